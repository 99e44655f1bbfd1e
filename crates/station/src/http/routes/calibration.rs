//! How the arm differs from the drawing of it: finding that, and saying so.

use std::sync::Arc;

use axum::Json;
use axum::extract::State;
use axum::http::header::CONTENT_TYPE;
use axum::response::{IntoResponse, Response};
use dobot_api::problem_kinds::{
    BAD_TOUCHES, DETECTING, JOB_RUNNING, NO_LINK, OUT_OF_RANGE, STILL_MOVING,
};
use dobot_api::{Backlash, CalibrationFile, Calibrations, PaperPlane, Reply, Request};
use dobot_arm::{Joints, Tool};
use dobot_calibrate::{
    Advice, BAR_MM, Fit, SHEET_POINTS, Touch, Trust, Unsure, check_bar, fit, found, paper,
    residuals_svg, sheet_svg,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{GET, MOVES, POST, PUT};
use crate::http::app::App;
use crate::http::exchange::answer::{Body, Maybe, NotDone, Nothing};
use crate::http::route::Route;

pub(super) fn all() -> Vec<Route> {
    vec![
        Route::new(
            GET,
            "/api/v1/calibration",
            "How the arm differs from the drawing of it, as far as that is known, and what was known before",
            known,
        )
        .gives::<Calibrations>(200, "what is known"),
        Route::asks(
            PUT,
            "/api/v1/calibration",
            "Says how the arm differs from the drawing of it: from then on all places are true ones. It is kept for \
                this arm, and what was known before is kept beside it; `null` takes the arm to be as drawn (admin)",
            |Body(new): Body<NewCalibration>| Request::Calibrate {
                calibration: new.calibration.map(Box::new),
            },
        )
        .example(r#"{"calibration": {"zeros": {"base": 1.5, "rear": -4.2, "fore": 3.1}, "tool": {"out_mm": 2.0, "left_mm": 0.5}}}"#)
        .gives::<Reply>(200, "what is known now")
        .problems(&[OUT_OF_RANGE, JOB_RUNNING, DETECTING, STILL_MOVING, NO_LINK]),
        Route::asks(
            POST,
            "/api/v1/calibration/angles",
            "Tells a calibrated arm its true joint angles (state 9, mode 3), which corrects its zeros until its next \
                reset. It has to rest, with its base straight ahead",
            |_: Maybe<Nothing>| Request::TellAngles,
        )
        .gives::<Reply>(200, "the command is accepted")
        .problems(MOVES),
        Route::new(
            POST,
            "/api/v1/calibration/fit",
            "What touches of the sheet tell: a calibration, how well it explains them, whether to trust it, and which \
                further point would tell most. Nothing is kept",
            fit_touches,
        )
        .brings::<Body<NewTouches>>()
        .example(FIT_EXAMPLE)
        .gives::<FitReport>(200, "what they tell")
        .problems(&[BAD_TOUCHES]),
        Route::new(
            POST,
            "/api/v1/calibration/paper",
            "How the paper lies that the tool has touched at true places: three tell its plane, more how it is bent. \
                Nothing is kept: put it into the calibration",
            fit_paper,
        )
        .brings::<Body<PaperTouches>>()
        .example(PAPER_EXAMPLE)
        .gives::<PaperReport>(200, "how it lies")
        .problems(&[BAD_TOUCHES]),
        Route::new(
            POST,
            "/api/v1/calibration/picture",
            "What touches of the sheet tell, as a picture: how far each is from where it should be",
            picture,
        )
        .brings::<Body<NewTouches>>()
        .example(FIT_EXAMPLE)
        .gives_text(200, "image/svg+xml", "the sheet with the touches")
        .problems(&[BAD_TOUCHES]),
        Route::new(
            GET,
            "/api/v1/calibration/points",
            "The points of the sheet, in the order in which they are touched",
            points,
        )
        .gives::<SheetPoints>(200, "the points"),
        Route::new(
            GET,
            "/api/v1/calibration/sheet",
            "The sheet to print, A4 and landscape, at 100 %",
            sheet,
        )
        .gives_text(200, "image/svg+xml", "the sheet"),
    ]
}

const FIT_EXAMPLE: &str = r#"{"bar_mm": 200, "touches": [
    {"place_mm": [215, 0], "told_deg": [0.0, 35.1, 47.2]},
    {"place_mm": [155, 100], "told_deg": [32.8, 20.4, 51.0]},
    {"place_mm": [275, 100], "told_deg": [20.0, 58.6, 40.3]},
    {"place_mm": [275, -100], "told_deg": [-20.0, 58.6, 40.3]}
]}"#;

const PAPER_EXAMPLE: &str =
    r#"{"places_mm": [[160, -80, -42.1], [160, 80, -41.6], [270, 0, -43.0]]}"#;

/// Places of the paper that the tool has touched.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct PaperTouches {
    /// Where the arm stood at each: forward, to the left and up, in mm, true places as its state has them.
    #[schemars(length(max = 400))]
    places_mm: Vec<[f64; 3]>,
}

/// How the paper lies.
#[derive(Debug, Serialize, JsonSchema)]
struct PaperReport {
    /// What is to be kept of it.
    paper: PaperPlane,
    /// How much higher than the plane each touch is, in mm.
    away_mm: Vec<f64>,
    /// How steep the plane is, in degrees.
    slope_deg: f64,
}

/// What is to be known of the arm.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct NewCalibration {
    /// The calibration; `null` for an arm as drawn.
    calibration: Option<CalibrationFile>,
}

/// Points that the tool has touched.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct NewTouches {
    /// What the arm said at each, in the order in which they were touched.
    #[schemars(length(max = 100))]
    touches: Vec<TouchedPoint>,
    /// How long the bar of the print is, measured with a ruler, in mm; one that is scaled is refused.
    #[serde(default)]
    bar_mm: Option<f64>,
    /// Whether the laser is mounted, and no suction cup.
    #[serde(default)]
    laser: bool,
    /// How slack the joints are known to be.
    #[serde(default)]
    backlash: Backlash,
}

/// A known point, and what the arm said when its tool touched it.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct TouchedPoint {
    /// Where it is on the sheet: forward and to the left, in mm.
    place_mm: [f64; 2],
    /// How high above the paper it is, in mm.
    #[serde(default)]
    height_mm: f64,
    /// The angles that the arm says of base, rear arm and forearm, in degrees: `told` of its state where it is
    /// calibrated already.
    told_deg: [f64; 3],
}

/// What touches tell.
#[derive(Debug, Serialize, JsonSchema)]
struct FitReport {
    /// How the arm differs from the drawing of it.
    calibration: CalibrationFile,
    /// How far each touch is from where it should be, in mm.
    away_mm: Vec<f64>,
    /// The touch that was left out because it contradicts all others, counted from 0.
    left_out: Option<usize>,
    /// How wrong a place on the sheet may still be, typically, in mm.
    expected_mm: f64,
    /// What these points tell badly.
    unsure: Vec<Unsure>,
    /// Which further point would tell most.
    advice: Option<Advice>,
    /// Whether to use it: `good`; `unchecked`, where so few points were touched that a wrong one would not be
    /// noticed; or `doubtful`.
    trust: Trust,
}

/// The points of the sheet.
#[derive(Debug, Serialize, JsonSchema)]
struct SheetPoints {
    /// Forward and to the left of the base's axis, in mm.
    points_mm: [[f64; 2]; SHEET_POINTS.len()],
    /// How long the bar is where the print is true, in mm.
    bar_mm: f64,
}

async fn known(State(app): State<Arc<App>>) -> Json<Calibrations> {
    Json(app.handle.rules().calibrations.clone())
}

async fn points() -> Json<SheetPoints> {
    Json(SheetPoints {
        points_mm: SHEET_POINTS,
        bar_mm: BAR_MM,
    })
}

async fn sheet() -> Response {
    ([(CONTENT_TYPE, "image/svg+xml")], sheet_svg()).into_response()
}

async fn fit_paper(Body(asked): Body<PaperTouches>) -> Result<Json<PaperReport>, NotDone> {
    let found = paper(&asked.places_mm).map_err(|why| BAD_TOUCHES.problem(why.to_string()))?;
    Ok(Json(PaperReport {
        paper: found.paper,
        away_mm: found.away_mm,
        slope_deg: found.slope_deg,
    }))
}

async fn fit_touches(Body(asked): Body<NewTouches>) -> Result<Json<FitReport>, NotDone> {
    let (touches, fit) = fitted(&asked)?;
    Ok(Json(FitReport {
        calibration: found(&fit, asked.backlash),
        away_mm: (0..touches.len())
            .map(|index| fit.residual_mm(index))
            .collect(),
        left_out: fit.left_out,
        expected_mm: fit.expected_mm,
        unsure: fit.unsure,
        advice: fit.advice,
        trust: fit.trust,
    }))
}

async fn picture(Body(asked): Body<NewTouches>) -> Result<Response, NotDone> {
    let (touches, fit) = fitted(&asked)?;
    Ok((
        [(CONTENT_TYPE, "image/svg+xml")],
        residuals_svg(&touches, &fit),
    )
        .into_response())
}

/// The touches, and what they tell.
fn fitted(asked: &NewTouches) -> Result<(Vec<Touch>, Fit), NotDone> {
    let bad = |why: &dyn std::fmt::Display| BAD_TOUCHES.problem(why.to_string());
    if let Some(bar_mm) = asked.bar_mm {
        check_bar(bar_mm).map_err(|why| bad(&why))?;
    }
    let touches = asked.touches.iter().map(|touch| {
        let [base_deg, rear_deg, fore_deg] = touch.told_deg;
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
    Ok((touches, fit))
}
