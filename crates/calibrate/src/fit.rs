//! Fits a calibration to touches and reports residuals and trust.

use dobot_arm::{Calibration, Plane, Position, Tool};

use schemars::JsonSchema;
use serde::Serialize;

use crate::outliers::{Kept, MIN_WIDTH_MM, width_without, without_wrong};
use crate::solve::{Numbers, Solved, Suspect, TOUCH_MM, length, norm_squared, solve};
use crate::{FitError, SHEET_POINTS, Touch};

/// A calibration and how well it explains the touches.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// The calibration of the arm.
    pub arm: Calibration,
    /// The position of the tool's tip from the axis of the wrist, outwards and to the left, in mm: a
    /// person can measure it.
    pub tool_mm: [f64; 2],
    /// The plane of the paper.
    pub paper: Plane,
    /// The residual of each touch, in mm: X, Y, Z, in the order of the touches.
    pub residuals_mm: Vec<[f64; 3]>,
    /// The indexes of the touches left out because they contradict all others, at most two.
    pub left_out: Vec<usize>,
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
    /// The touches agree, but put the tool so far from its nominal position that a person has to
    /// measure it: a scaled print looks the same.
    Unmeasured,
    /// The touches that count agree poorly, or the base may have been turned between two of them.
    Doubtful,
}

impl Fit {
    /// Returns the distance of a touch from its expected position, in mm.
    #[must_use]
    pub fn residual_mm(&self, index: usize) -> f64 {
        self.residuals_mm.get(index).map_or(0.0, length)
    }

    /// Accepts the fitted tool offset because a person has measured it.
    #[must_use]
    pub fn with_measured_tool(self) -> Self {
        let trust = match self.trust {
            Trust::Unmeasured => trust_in(self.residuals_mm.len() - self.left_out.len()),
            trust => trust,
        };
        Self { trust, ..self }
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
    let kept = without_wrong(touches, tool);
    let numbers = kept.solved.numbers;
    let away_mm = |touch: &Touch| numbers.away_mm(touch, tool, false);
    let distances: Vec<f64> = kept
        .touches
        .iter()
        .map(|touch| length(&away_mm(touch)))
        .collect();
    let typical_mm = (norm_squared(&distances) / count(distances.len())).sqrt();
    check_contradiction(touches, tool, &kept, typical_mm)?;
    Ok(Fit {
        arm: numbers.arm,
        tool_mm: [tool.reach().0 + numbers.arm.reach_mm, numbers.arm.left_mm],
        paper: numbers.paper,
        residuals_mm: touches.iter().map(away_mm).collect(),
        typical_mm,
        largest_mm: distances.iter().copied().fold(0.0, f64::max),
        expected_mm: expected(distances.len(), typical_mm),
        unsure: unsure(&kept.solved),
        advice: advice(&kept.solved, tool),
        trust: trust(touches, tool, &kept, typical_mm),
        left_out: kept.wrong,
    })
}

fn check_contradiction(
    touches: &[Touch],
    tool: Tool,
    kept: &Kept,
    typical_mm: f64,
) -> Result<(), FitError> {
    let numbers = kept.solved.numbers;
    let error = if typical_mm > MAX_TYPICAL_MM {
        FitError::Contradiction {
            typical_mm,
            allowed_mm: MAX_TYPICAL_MM,
        }
    } else if let Err(beyond) = check_arm(&numbers.arm, &numbers.paper) {
        beyond
    } else {
        return Ok(());
    };
    Err(what_went_wrong(touches, tool, &kept.solved).unwrap_or(error))
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
    if touches.len() < MIN_TOUCHES {
        return Err(FitError::TooFew {
            found: touches.len(),
        });
    }
    let width_mm = width_without(touches, &[]);
    if width_mm < MIN_WIDTH_MM {
        return Err(FitError::InLine { width_mm });
    }
    Ok(())
}

/// Returns the known mistake that explains the touches far better than a calibration does.
fn what_went_wrong(touches: &[Touch], tool: Tool, plain: &Solved) -> Option<FitError> {
    let scaled = solve(touches, tool, Suspect::Scale);
    let step = best_step(touches, tool);
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

/// Returns the change of the base's zero that explains the touches best, with the index of the
/// touch before which it happened.
fn best_step(touches: &[Touch], tool: Tool) -> Option<(usize, Solved)> {
    let steps = (1..touches.len()).map(|at| (at, solve(touches, tool, Suspect::StepBefore(at))));
    steps.min_by(|a, b| a.1.cost.total_cmp(&b.1.cost))
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
            let raw = arm.raw_joints(place, tool).ok()?;
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
    (gain > MIN_GAIN).then_some(Advice {
        place_mm: best.place_mm,
        height_mm: best.height_mm,
        gain,
    })
}

fn trust(touches: &[Touch], tool: Tool, kept: &Kept, typical_mm: f64) -> Trust {
    let arm = &kept.solved.numbers.arm;
    if typical_mm > GOOD_TYPICAL_MM || is_turned(touches, tool, kept) {
        Trust::Doubtful
    } else if arm.reach_mm.hypot(arm.left_mm) > UNUSUAL_TOOL_MM {
        Trust::Unmeasured
    } else {
        trust_in(kept.touches.len())
    }
}

/// Returns the trust in this many touches that agree.
const fn trust_in(touches: usize) -> Trust {
    if touches < TOUCHES_TO_JUDGE {
        Trust::Unchecked
    } else {
        Trust::Good
    }
}

/// Returns whether a change of the base's zero explains the touches better than wrong touches do.
fn is_turned(touches: &[Touch], tool: Tool, kept: &Kept) -> bool {
    let explained = |touches| best_step(touches, tool).map_or(f64::INFINITY, |step| step.1.cost);
    explained(&kept.touches) + STEP_GAIN < kept.solved.cost
        || !kept.wrong.is_empty() && explained(touches) < kept.solved.cost + STEP_GAIN
}

#[expect(
    clippy::cast_precision_loss,
    reason = "there are fewer than 2^52 touches"
)]
const fn count(touches: usize) -> f64 {
    touches as f64
}

const MIN_TOUCHES: usize = 4;
/// The least number of touches that have to agree to detect a wrong one.
const TOUCHES_TO_JUDGE: usize = 6;
const FARTHEST_MM: f64 = 400.0;
/// How much better a change of the base's zero has to explain the touches to cast doubt, in squared
/// standard deviations of a touch.
const STEP_GAIN: f64 = 16.0;
/// A tool offset beyond which a person has to measure it.
const UNUSUAL_TOOL_MM: f64 = 8.0;
const GOOD_TYPICAL_MM: f64 = 0.7;
const MAX_TYPICAL_MM: f64 = 1.5;
/// The number of parameters that determine a position in the plane.
const NUMBERS_OF_A_PLACE: f64 = 6.0;
const BLOCK_MM: f64 = 40.0;
const MIN_GAIN: f64 = 0.1;
