//! From touches to a calibration, with its residuals and how far it can be trusted.

use dobot_arm::{Calibration, Plane, Position, Tool};
use dobot_geometry::{Point, least_width};

use schemars::JsonSchema;
use serde::Serialize;

use crate::solve::{Numbers, Solved, Suspect, TOUCH_MM, norm_squared, solve};
use crate::{FitError, SHEET_POINTS, Touch};

/// A calibration, and how well it explains the touches.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// What is wrong with the arm.
    pub arm: Calibration,
    /// Where the paper lies.
    pub paper: Plane,
    /// How far each touch is from where it should be, in mm: X, Y, Z, in the order of the touches.
    pub residuals_mm: Vec<[f64; 3]>,
    /// The touch that was left out because it contradicts all others, by its index.
    pub left_out: Option<usize>,
    /// The root of the mean square of the residuals that count, in mm.
    pub typical_mm: f64,
    /// The largest residual that counts, in mm.
    pub largest_mm: f64,
    /// How wrong a place on the sheet may still be, typically, in mm.
    pub expected_mm: f64,
    /// What these points tell badly.
    pub unsure: Vec<Unsure>,
    /// Which further point would tell most.
    pub advice: Option<Advice>,
    /// Whether to use it.
    pub trust: Trust,
}

/// A number that the touches tell badly.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Unsure {
    /// What of the arm.
    pub what: &'static str,
    /// Its deviation.
    pub by: f64,
    /// The unit of the deviation.
    pub unit: &'static str,
}

/// A point that is worth touching.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Advice {
    /// Where it is on the sheet, in mm.
    pub place_mm: [f64; 2],
    /// How high above the paper, in mm.
    pub height_mm: f64,
    /// The share of the doubt that goes away with it, from 0 to 1.
    pub gain: f64,
}

/// Whether to use a calibration.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Trust {
    /// The touches agree, and there are enough of them to know.
    Good,
    /// They agree, but are so few that a wrong one would not be noticed.
    Unchecked,
    /// They agree badly, or one had to be left out.
    Doubtful,
}

impl Fit {
    /// The distance of a touch from where it should be, in mm.
    #[must_use]
    pub fn residual_mm(&self, index: usize) -> f64 {
        self.residuals_mm.get(index).map_or(0.0, length)
    }
}

/// Finds what is wrong with an arm whose tool has touched known points.
///
/// # Errors
///
/// [`FitError`] where the points tell too little, contradict each other, or tell of what no arm has.
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
        .map(|it| numbers.away_mm(it, tool, false))
        .collect();
    let distances = counted
        .iter()
        .map(|it| length(&numbers.away_mm(it, tool, false)));
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
        let is_place = [x_mm, y_mm].iter().all(|it| it.abs() <= FARTHEST_MM);
        if !is_place || raw.iter().any(|it| !it.is_finite()) {
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

/// How wide the strip is in which all points lie, seen from above, in mm.
fn width(touches: &[Touch]) -> f64 {
    let place = |it: &Touch| Point::from((it.place_mm[0], it.place_mm[1]));
    least_width(&touches.iter().map(place).collect::<Vec<_>>())
}

/// The touch without which the others agree far better, where there are enough others.
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
        .map(|(_, it)| *it)
        .collect()
}

fn typical(touches: &[Touch], tool: Tool, numbers: &Numbers) -> f64 {
    let squares = touches
        .iter()
        .map(|it| length(&numbers.away_mm(it, tool, false)).powi(2));
    (squares.sum::<f64>() / count(touches.len())).sqrt()
}

/// Which of the things that go wrong with touches explains these far better than an arm does.
fn what_went_wrong(touches: &[Touch], tool: Tool, plain: &Solved) -> Option<FitError> {
    let scaled = solve(touches, tool, Suspect::Scale);
    let steps = (1..touches.len()).map(|at| (at, solve(touches, tool, Suspect::StepBefore(at))));
    let step = steps.min_by(|a, b| a.1.cost.total_cmp(&b.1.cost));
    let explains = |it: &Solved| it.cost < plain.cost / 4.0;
    match step {
        Some((last, it)) if explains(&it) && it.cost < scaled.cost => Some(FitError::Reset {
            last,
            deg: it.numbers.step_deg.abs(),
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
        ("a tool too far out by", arm.reach_mm, 30.0, "mm"),
        ("a tool aside by", arm.left_mm, 30.0, "mm"),
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

/// The deviation of a place on the paper after so many touches that agree so well.
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
        ("how far out the tool is", 7.0, 1.0, "mm"),
        ("how far aside the tool is", 5.0, 1.0, "mm"),
    ];
    let with_spread = named.into_iter().zip(solved.spread.iter());
    with_spread
        .map(|((what, before, most, unit), spread)| (what, before * spread, most, unit))
        .filter(|(_, by, most, _)| by > most)
        .map(|(what, by, _, unit)| Unsure { what, by, unit })
        .collect()
}

/// The point, of those of the sheet and of the same on a block, that would tell most.
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
    let judged = candidates.map(|it| (it, solved.unsure_with(&it, tool)));
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
    away_mm.iter().map(|it| it * it).sum::<f64>().sqrt()
}

#[expect(clippy::cast_precision_loss, reason = "nobody touches 2^52 points")]
const fn count(touches: usize) -> f64 {
    touches as f64
}

const LEAST_TOUCHES: usize = 4;
/// With so many, one that is wrong can be told from the others.
const TOUCHES_TO_JUDGE: usize = 6;
const LEAST_WIDTH_MM: f64 = 60.0;
const FARTHEST_MM: f64 = 400.0;
/// How much better the others agree without a wrong touch, in squares of a touch's deviation.
const WRONG_GAIN: f64 = 20.0;
const WRONG_MM: f64 = 1.5;
const GOOD_TYPICAL_MM: f64 = 0.8;
const MOST_TYPICAL_MM: f64 = 1.5;
/// How many numbers decide where a place in the plane is.
const NUMBERS_OF_A_PLACE: f64 = 6.0;
const BLOCK_MM: f64 = 40.0;
const LEAST_GAIN: f64 = 0.1;
