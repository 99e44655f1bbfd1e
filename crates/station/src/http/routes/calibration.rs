//! Calibration: the deviations of an arm from its nominal dimensions.

use std::sync::Arc;

use axum::Json;
use axum::extract::State;
use axum::http::StatusCode;
use axum::http::header::CONTENT_TYPE;
use axum::response::{IntoResponse, Response};
use dobot_api::problem_kinds::{
    BAD_TOUCHES, DETECTING, JOB_RUNNING, NO_LINK, OUT_OF_RANGE, STILL_MOVING,
};
use dobot_api::{Backlash, CalibrationFile, Calibrations, PaperPlane, Reply, Request};
use dobot_arm::{Joints, Tool};
use dobot_calibrate::{
    Advice, Fit, SHEET_POINTS, Sheet, Touch, Trust, Unsure, check_bar, fit, found, paper,
    residuals_svg, sheet_markers,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{GET, MOVES, POST, PUT};
use crate::http::app::App;
use crate::http::exchange::responses::{Body, Maybe, Nothing, RequestFailed};
use crate::http::route::Route;

pub(super) fn all() -> Vec<Route> {
    // table
    vec![
        Route::new(
            GET,
            "/api/v1/calibration",
            "The calibration of the arm, and the previous one",
            known,
        )
        .gives::<Calibrations>(200, "the calibrations"),
        Route::asks(
            PUT,
            "/api/v1/calibration",
            "Sets the calibration of the arm: from then on all positions are calibrated. It is stored for \
                this arm together with the previous one; `null` selects the nominal dimensions (admin)",
            |Body(new): Body<NewCalibration>| Request::Calibrate {
                calibration: new.calibration.map(Box::new),
            },
        )
        .example(r#"{"calibration": {"zeros": {"base": 1.5, "rear": -4.2, "fore": 3.1}, "tool": {"out_mm": 2.0, "left_mm": 0.5}}}"#)
        .gives::<Reply>(200, "the new calibration")
        .problems(&[OUT_OF_RANGE, JOB_RUNNING, DETECTING, STILL_MOVING, NO_LINK]),
        Route::asks(
            POST,
            "/api/v1/calibration/angles",
            "Sends a calibrated arm its true joint angles (state 9, mode 3), which corrects its zeros until its next \
                reset. The arm must be at rest, with its base straight ahead",
            |_: Maybe<Nothing>| Request::SetAngles,
        )
        .gives::<Reply>(200, "the command is accepted")
        .problems(MOVES),
        Route::new(
            POST,
            "/api/v1/calibration/bar",
            "Checks the measured length of the bar on a printed sheet",
            bar,
        )
        .brings::<Body<MeasuredBar>>()
        .example(r#"{"sheet": 417, "bar_mm": 189.5}"#)
        .gives_nothing(204, "the print has its true size")
        .problems(&[BAD_TOUCHES]),
        Route::new(
            POST,
            "/api/v1/calibration/fit",
            "Fits a calibration to touches of the sheet: returns its residuals, whether to trust it, and the most useful \
                further point. Nothing is stored",
            fit_touches,
        )
        .brings::<Body<NewTouches>>()
        .example(FIT_EXAMPLE)
        .gives::<FitReport>(200, "the fit")
        .problems(&[BAD_TOUCHES]),
        Route::new(
            POST,
            "/api/v1/calibration/paper",
            "Fits the paper to touches at calibrated positions: three give its plane, more its curvature. \
                Nothing is stored: add the result to the calibration",
            fit_paper,
        )
        .brings::<Body<PaperTouches>>()
        .example(PAPER_EXAMPLE)
        .gives::<PaperReport>(200, "the paper")
        .problems(&[BAD_TOUCHES]),
        Route::new(
            POST,
            "/api/v1/calibration/picture",
            "The residuals of touches of the sheet, as a picture",
            picture,
        )
        .brings::<Body<NewTouches>>()
        .example(FIT_EXAMPLE)
        .gives_text(200, "image/svg+xml", "the sheet with the touches")
        .problems(&[BAD_TOUCHES]),
        Route::new(
            GET,
            "/api/v1/calibration/points",
            "The points of the sheet, in the order of touching",
            points,
        )
        .gives::<SheetPoints>(200, "the points"),
        Route::new(
            GET,
            "/api/v1/calibration/sheet",
            "A sheet to print, A4 landscape, at 100 %: each time another one, with its own number and a bar to measure",
            sheet,
        )
        .gives_text(200, "image/svg+xml", "the sheet"),
    ]
}

const FIT_EXAMPLE: &str = r#"{"sheet": 417, "bar_mm": 189.5, "touches": [
    {"place_mm": [215, 0], "raw_deg": [0.0, 35.1, 47.2]},
    {"place_mm": [155, 100], "raw_deg": [32.8, 20.4, 51.0]},
    {"place_mm": [275, 100], "raw_deg": [20.0, 58.6, 40.3]},
    {"place_mm": [275, -100], "raw_deg": [-20.0, 58.6, 40.3]}
]}"#;

const PAPER_EXAMPLE: &str =
    r#"{"places_mm": [[160, -80, -42.1], [160, 80, -41.6], [270, 0, -43.0]]}"#;

/// Positions of the paper that the tool has touched.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct PaperTouches {
    /// The positions of the arm: forward, to the left and up, in mm, calibrated, as in its state.
    #[schemars(length(max = 400))]
    places_mm: Vec<[f64; 3]>,
}

/// The fitted paper.
#[derive(Debug, Serialize, JsonSchema)]
struct PaperReport {
    /// The part to store in the calibration.
    paper: PaperPlane,
    /// The height of each touch above the plane, in mm.
    away_mm: Vec<f64>,
    /// The slope of the plane, in degrees.
    slope_deg: f64,
}

/// A new calibration.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct NewCalibration {
    /// The calibration; `null` for nominal dimensions.
    calibration: Option<CalibrationFile>,
}

/// Points that the tool has touched.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct NewTouches {
    /// The reported angles at each point, in the order of touching.
    #[schemars(length(max = 100))]
    touches: Vec<TouchedPoint>,
    /// The number of the sheet, which is printed above its bar; required.
    #[serde(default)]
    sheet: Option<u16>,
    /// The length of the bar on the print, measured with a ruler, in mm; required. A scaled print is
    /// refused.
    #[serde(default)]
    bar_mm: Option<f64>,
    /// Whether a person has measured the tool and found it about at `tool_mm` of the fit: the answer
    /// to `unmeasured`.
    #[serde(default)]
    tool_measured: bool,
    /// Whether the laser is mounted instead of a suction cup.
    #[serde(default)]
    laser: bool,
    /// The known backlash of the joints.
    #[serde(default)]
    backlash: Backlash,
}

/// A printed sheet and its bar.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct MeasuredBar {
    /// The number of the sheet, which is printed above its bar.
    sheet: u16,
    /// The length of the bar on the print, measured with a ruler, in mm.
    bar_mm: f64,
}

/// A known point, and the reported angles when the tool touched it.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct TouchedPoint {
    /// Its position on the sheet: forward and to the left, in mm.
    place_mm: [f64; 2],
    /// Its height above the paper, in mm.
    #[serde(default)]
    height_mm: f64,
    /// The raw angles of base, rear arm and forearm, in degrees: `raw` of the state of an arm that
    /// is already calibrated.
    #[serde(alias = "told_deg")]
    raw_deg: [f64; 3],
}

/// The result of fitting a calibration.
#[derive(Debug, Serialize, JsonSchema)]
struct FitReport {
    /// The calibration.
    calibration: CalibrationFile,
    /// The residual of each touch, in mm.
    away_mm: Vec<f64>,
    /// The touches that are left out because they contradict all others, at most two, counted from 0.
    wrong: Vec<usize>,
    /// The first of `wrong`.
    #[schemars(extend("deprecated" = true))]
    left_out: Option<usize>,
    /// The position of the tool's tip from the axis of the wrist: outwards and to the left, in mm.
    tool_mm: [f64; 2],
    /// The typical remaining error of a position on the sheet, in mm.
    expected_mm: f64,
    /// Quantities that these points determine badly.
    unsure: Vec<Unsure>,
    /// The most useful further point.
    advice: Option<Advice>,
    /// Whether to use it: `good`; `unchecked` if there are too few points to detect a wrong one;
    /// `unmeasured` if the tool is so far from its nominal position that a person has to measure
    /// whether it is at `tool_mm`; or `doubtful`.
    trust: Trust,
}

/// The points of the sheet.
#[derive(Debug, Serialize, JsonSchema)]
struct SheetPoints {
    /// Their positions, forward and to the left of the base's axis, in mm.
    points_mm: [[f64; 2]; SHEET_POINTS.len()],
    /// The four corners of each of its markers 0 to 3, clockwise from the upper left one, in mm.
    markers_mm: [[[f64; 2]; 4]; 4],
}

async fn known(State(app): State<Arc<App>>) -> Json<Calibrations> {
    Json(app.handle.rules().calibrations.clone())
}

async fn points() -> Json<SheetPoints> {
    Json(SheetPoints {
        points_mm: SHEET_POINTS,
        markers_mm: sheet_markers().map(|(_, corners)| corners),
    })
}

async fn sheet() -> Response {
    // Without random numbers all sheets are the same one, whose bar still has to be measured.
    let sheet = Sheet::chosen_by(getrandom::u64().unwrap_or_default());
    ([(CONTENT_TYPE, "image/svg+xml")], sheet.svg()).into_response()
}

async fn bar(Body(print): Body<MeasuredBar>) -> Result<StatusCode, RequestFailed> {
    check_bar(Some(print.sheet), Some(print.bar_mm))
        .map_err(|why| BAD_TOUCHES.problem(why.to_string()))?;
    Ok(StatusCode::NO_CONTENT)
}

async fn fit_paper(Body(asked): Body<PaperTouches>) -> Result<Json<PaperReport>, RequestFailed> {
    let found = paper(&asked.places_mm).map_err(|why| BAD_TOUCHES.problem(why.to_string()))?;
    Ok(Json(PaperReport {
        paper: found.paper,
        away_mm: found.away_mm,
        slope_deg: found.slope_deg,
    }))
}

async fn fit_touches(Body(asked): Body<NewTouches>) -> Result<Json<FitReport>, RequestFailed> {
    let (touches, fit) = fitted(&asked)?;
    Ok(Json(FitReport {
        calibration: found(&fit, asked.backlash),
        away_mm: (0..touches.len())
            .map(|index| fit.residual_mm(index))
            .collect(),
        left_out: fit.left_out.first().copied(),
        wrong: fit.left_out,
        tool_mm: fit.tool_mm,
        expected_mm: fit.expected_mm,
        unsure: fit.unsure,
        advice: fit.advice,
        trust: fit.trust,
    }))
}

async fn picture(Body(asked): Body<NewTouches>) -> Result<Response, RequestFailed> {
    let (touches, fit) = fitted(&asked)?;
    Ok((
        [(CONTENT_TYPE, "image/svg+xml")],
        residuals_svg(&touches, &fit),
    )
        .into_response())
}

/// Returns the touches, and their fit.
fn fitted(asked: &NewTouches) -> Result<(Vec<Touch>, Fit), RequestFailed> {
    let bad = |why: &dyn std::fmt::Display| BAD_TOUCHES.problem(why.to_string());
    check_bar(asked.sheet, asked.bar_mm).map_err(|why| bad(&why))?;
    let touches = asked.touches.iter().map(|touch| {
        let [base_deg, rear_deg, fore_deg] = touch.raw_deg;
        Touch {
            place_mm: touch.place_mm,
            height_mm: touch.height_mm,
            raw: Joints::new(base_deg, rear_deg, fore_deg, 0.0),
        }
    });
    let touches: Vec<Touch> = touches.collect();
    let tool = if asked.laser {
        Tool::Laser
    } else {
        Tool::SuctionCup
    };
    let fit = fit(&touches, tool).map_err(|why| bad(&why))?;
    let fit = if asked.tool_measured {
        fit.with_measured_tool()
    } else {
        fit
    };
    Ok((touches, fit))
}
