//! Fits a calibration to touches and reports residuals and trust.

use dobot_arm::{Calibration, Plane, Position, Tool};
use dobot_geometry::{Point, least_width};

use schemars::JsonSchema;
use serde::Serialize;

use crate::solve::{Numbers, Solved, Suspect, TOUCH_MM, norm_squared, solve};
use crate::{FitError, SHEET_POINTS, Touch};

/// A calibration and how well it explains the touches.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// The calibration of the arm.
    pub arm: Calibration,
    /// The plane of the paper.
    pub paper: Plane,
    /// The residual of each touch, in mm: X, Y, Z, in the order of the touches.
    pub residuals_mm: Vec<[f64; 3]>,
    /// The index of the touch left out because it contradicts all others.
    pub left_out: Option<usize>,
    /// The root mean square of the residuals that count, in mm.
    pub typical_mm: f64,
    /// The largest residual that counts, in mm.
    pub largest_mm: f64,
    /// The typical remaining error of a position on the sheet, in mm.
    pub expected_mm: f64,
    /// The parameters that these points determine poorly.
    pub unsure: Vec<Unsure>,
    /// The further point that would add most information.
    pub advice: Option<Advice>,
    /// How far to trust the calibration.
    pub trust: Trust,
}

/// A parameter that the touches determine poorly.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Unsure {
    /// The parameter.
    pub what: &'static str,
    /// Its standard deviation.
    pub by: f64,
    /// The unit of the deviation.
    pub unit: &'static str,
}

/// A recommended further point to touch.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Advice {
    /// The position on the sheet, in mm.
    pub place_mm: [f64; 2],
    /// The height above the paper, in mm.
    pub height_mm: f64,
    /// The share of the uncertainty that the point removes, from 0 to 1.
    pub gain: f64,
}

/// How far a calibration can be trusted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Trust {
    /// The touches agree, and there are enough of them to detect a wrong one.
    Good,
    /// The touches agree, but are too few to detect a wrong one.
    Unchecked,
    /// The touches agree poorly, or one had to be left out.
    Doubtful,
}

impl Fit {
    /// Returns the distance of a touch from its expected position, in mm.
    #[must_use]
    pub fn residual_mm(&self, index: usize) -> f64 {
        self.residuals_mm.get(index).map_or(0.0, length)
    }
}

/// Fits a calibration to touches of known points.
///
/// # Errors
///
/// [`FitError`] if the points are insufficient, contradict each other, or give a calibration
/// outside the limits of an arm.
pub fn fit(touches: &[Touch], tool: Tool) -> Result<Fit, FitError> {
    check(touches)?;
    let all = solve(touches, tool, Suspect::Nothing);
    let left_out = wrong_touch(touches, tool, &all);
    let counted: Vec<Touch> = kept(touches, left_out);
    let solved = if left_out.is_some() {
        solve(&counted, tool, Suspect::Nothing)
    } else {
        all
    };
    let numbers = solved.numbers;
    let typical_mm = typical(&counted, tool, &numbers);
    if typical_mm > MOST_TYPICAL_MM {
        let contradiction = FitError::Contradiction {
            typical_mm,
            allowed_mm: MOST_TYPICAL_MM,
        };
        return Err(what_went_wrong(touches, tool, &solved).unwrap_or(contradiction));
    }
    check_arm(&numbers.arm, &numbers.paper)
        .map_err(|beyond| what_went_wrong(touches, tool, &solved).unwrap_or(beyond))?;
    let residuals_mm: Vec<_> = touches
        .iter()
        .map(|touch| numbers.away_mm(touch, tool, false))
        .collect();
    let distances = counted
        .iter()
        .map(|touch| length(&numbers.away_mm(touch, tool, false)));
    let largest_mm = distances.fold(0.0, f64::max);
    Ok(Fit {
        arm: numbers.arm,
        paper: numbers.paper,
        residuals_mm,
        left_out,
        typical_mm,
        largest_mm,
        expected_mm: expected(counted.len(), typical_mm),
        unsure: unsure(&solved),
        advice: advice(&solved, tool),
        trust: trust(counted.len(), left_out, typical_mm),
    })
}

fn check(touches: &[Touch]) -> Result<(), FitError> {
    for (number, touch) in (1..).zip(touches) {
        let [x_mm, y_mm] = touch.place_mm;
        let raw = [
            touch.raw.base.0,
            touch.raw.rear.0,
            touch.raw.fore.0,
            touch.height_mm,
        ];
        let is_place = [x_mm, y_mm].iter().all(|mm| mm.abs() <= FARTHEST_MM);
        if !is_place || raw.iter().any(|value| !value.is_finite()) {
            return Err(FitError::NoPlace { number, x_mm, y_mm });
        }
    }
    if touches.len() < LEAST_TOUCHES {
        return Err(FitError::TooFew {
            found: touches.len(),
        });
    }
    let width_mm = width(touches);
    if width_mm < LEAST_WIDTH_MM {
        return Err(FitError::InLine { width_mm });
    }
    Ok(())
}

/// Returns the width of the narrowest strip that holds all points, seen from above, in mm.
fn width(touches: &[Touch]) -> f64 {
    let place = |touch: &Touch| Point::from((touch.place_mm[0], touch.place_mm[1]));
    least_width(&touches.iter().map(place).collect::<Vec<_>>())
}

/// Returns the touch without which the others agree far better, if there are enough others.
fn wrong_touch(touches: &[Touch], tool: Tool, all: &Solved) -> Option<usize> {
    if touches.len() < TOUCHES_TO_JUDGE {
        return None;
    }
    let without = |index: usize| {
        let others = kept(touches, Some(index));
        let solved = solve(&others, tool, Suspect::Nothing);
        let away_mm = length(&solved.numbers.away_mm(&touches[index], tool, false));
        (width(&others) >= LEAST_WIDTH_MM).then_some((index, all.cost - solved.cost, away_mm))
    };
    let worst = (0..touches.len())
        .filter_map(without)
        .max_by(|a, b| a.1.total_cmp(&b.1))?;
    let (index, gain, away_mm) = worst;
    let is_wrong = gain > WRONG_GAIN && gain > all.cost / 2.0 && away_mm > WRONG_MM;
    is_wrong.then_some(index)
}

fn kept(touches: &[Touch], left_out: Option<usize>) -> Vec<Touch> {
    let counts = |&(index, _): &(usize, &Touch)| Some(index) != left_out;
    touches
        .iter()
        .enumerate()
        .filter(counts)
        .map(|(_, touch)| *touch)
        .collect()
}

fn typical(touches: &[Touch], tool: Tool, numbers: &Numbers) -> f64 {
    let squares = touches
        .iter()
        .map(|touch| length(&numbers.away_mm(touch, tool, false)).powi(2));
    (squares.sum::<f64>() / count(touches.len())).sqrt()
}

/// Returns the known mistake that explains the touches far better than a calibration does.
fn what_went_wrong(touches: &[Touch], tool: Tool, plain: &Solved) -> Option<FitError> {
    let scaled = solve(touches, tool, Suspect::Scale);
    let steps = (1..touches.len()).map(|at| (at, solve(touches, tool, Suspect::StepBefore(at))));
    let step = steps.min_by(|a, b| a.1.cost.total_cmp(&b.1.cost));
    let explains = |solved: &Solved| solved.cost < plain.cost / 4.0;
    match step {
        Some((last, step)) if explains(&step) && step.cost < scaled.cost => Some(FitError::Reset {
            last,
            deg: step.numbers.step_deg.abs(),
        }),
        _ if explains(&scaled) => Some(FitError::ScaledPrint {
            percent: scaled.numbers.scale * 100.0,
        }),
        _ => None,
    }
}

fn check_arm(arm: &Calibration, paper: &Plane) -> Result<(), FitError> {
    let slope_deg = paper.slope_x.hypot(paper.slope_y).atan().to_degrees();
    let found = [
        ("a zero of the base", arm.base_deg, 45.0, "degrees"),
        ("a zero of the rear arm", arm.rear_deg, 30.0, "degrees"),
        ("a zero of the forearm", arm.fore_deg, 30.0, "degrees"),
        ("a tool offset outwards", arm.reach_mm, 30.0, "mm"),
        ("a tool offset to the left", arm.left_mm, 30.0, "mm"),
        ("a slope of the paper", slope_deg, 10.0, "degrees"),
    ];
    let beyond = found
        .into_iter()
        .find(|(_, found, allowed, _)| found.abs() > *allowed);
    beyond.map_or(Ok(()), |(what, found, allowed, unit)| {
        Err(FitError::Beyond {
            what,
            found,
            allowed,
            unit,
        })
    })
}

/// Returns the expected deviation of a position on the paper for this number of touches and their
/// agreement.
fn expected(touches: usize, typical_mm: f64) -> f64 {
    let numbers = 3.0 * count(touches);
    let spare = (numbers - NUMBERS_OF_A_PLACE).max(1.0);
    let touch_mm = (typical_mm.powi(2) * count(touches) / spare)
        .sqrt()
        .max(TOUCH_MM / 3.0);
    touch_mm * (NUMBERS_OF_A_PLACE / count(touches)).sqrt()
}

fn unsure(solved: &Solved) -> Vec<Unsure> {
    let named = [
        ("the zero of the base", 15.0, 1.0, "degrees"),
        ("the zero of the rear arm", 12.0, 1.0, "degrees"),
        ("the zero of the forearm", 12.0, 1.0, "degrees"),
        ("the tool offset outwards", 7.0, 1.0, "mm"),
        ("the tool offset to the left", 5.0, 1.0, "mm"),
    ];
    let with_spread = named.into_iter().zip(solved.spread.iter());
    with_spread
        .map(|((what, before, most, unit), spread)| (what, before * spread, most, unit))
        .filter(|(_, by, most, _)| by > most)
        .map(|(what, by, _, unit)| Unsure { what, by, unit })
        .collect()
}

/// Returns the point of the sheet, on paper or on a block, that would add most information.
fn advice(solved: &Solved, tool: Tool) -> Option<Advice> {
    let Numbers { arm, paper, .. } = solved.numbers;
    let now = norm_squared(&solved.spread[..5]);
    let heights = [0.0, BLOCK_MM];
    let candidates = heights.iter().flat_map(|&height_mm| {
        SHEET_POINTS.into_iter().filter_map(move |place_mm| {
            let [x_mm, y_mm] = place_mm;
            let place = Position::new(x_mm, y_mm, paper.z_at(place_mm) + height_mm);
            let raw = arm.told_joints(place, tool).ok()?;
            Some(Touch {
                place_mm,
                height_mm,
                raw,
            })
        })
    });
    let judged = candidates.map(|touch| (touch, solved.unsure_with(&touch, tool)));
    let (best, then) = judged.min_by(|a, b| a.1.total_cmp(&b.1))?;
    let gain = 1.0 - then / now.max(1e-12);
    (gain > LEAST_GAIN).then_some(Advice {
        place_mm: best.place_mm,
        height_mm: best.height_mm,
        gain,
    })
}

fn trust(touches: usize, left_out: Option<usize>, typical_mm: f64) -> Trust {
    if typical_mm > GOOD_TYPICAL_MM || left_out.is_some() {
        Trust::Doubtful
    } else if touches < TOUCHES_TO_JUDGE {
        Trust::Unchecked
    } else {
        Trust::Good
    }
}

fn length(away_mm: &[f64; 3]) -> f64 {
    away_mm.iter().map(|mm| mm * mm).sum::<f64>().sqrt()
}

#[expect(
    clippy::cast_precision_loss,
    reason = "there are fewer than 2^52 touches"
)]
const fn count(touches: usize) -> f64 {
    touches as f64
}

const LEAST_TOUCHES: usize = 4;
/// The least number of touches in which a wrong one can be identified.
const TOUCHES_TO_JUDGE: usize = 6;
const LEAST_WIDTH_MM: f64 = 60.0;
const FARTHEST_MM: f64 = 400.0;
/// How much better the others agree without a wrong touch, in squared standard deviations of a
/// touch.
const WRONG_GAIN: f64 = 20.0;
const WRONG_MM: f64 = 1.5;
const GOOD_TYPICAL_MM: f64 = 0.8;
const MOST_TYPICAL_MM: f64 = 1.5;
/// The number of parameters that determine a position in the plane.
const NUMBERS_OF_A_PLACE: f64 = 6.0;
const BLOCK_MM: f64 = 40.0;
const LEAST_GAIN: f64 = 0.1;
