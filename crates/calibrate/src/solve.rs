//! Robust least squares with prior knowledge: a wrong point has limited influence.

use std::array::from_fn;

use dobot_arm::{Calibration, Joints, Plane, Tool};
use dobot_geometry::{inverse, solve as solve_linear};

use crate::Touch;

/// The parameters that touches determine.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Numbers {
    pub(crate) arm: Calibration,
    /// The paper in the calibrated frame, as Z of the wrist where the tool touches it.
    pub(crate) paper: Plane,
    /// The scale of the print; 1 at true size.
    pub(crate) scale: f64,
    /// The change of the base's zero after some touch.
    pub(crate) step_deg: f64,
}

/// A suspected mistake in the touches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Suspect {
    Nothing,
    Scale,
    /// The base's zero changed before the touch with this index.
    StepBefore(usize),
}

/// The best parameters for some touches.
#[derive(Clone, Debug)]
pub(crate) struct Solved {
    pub(crate) numbers: Numbers,
    /// The sum of squares, in units of the standard deviation of a touch.
    pub(crate) cost: f64,
    /// The standard deviation of each parameter, in units of its prior.
    pub(crate) spread: [f64; COUNT],
    information: [[f64; COUNT]; COUNT],
    at: [f64; COUNT],
    /// The rows of the Jacobian, three for each touch.
    rows: Vec<[f64; COUNT]>,
    /// The deviations, three for each touch, in units of [`TOUCH_MM`].
    away: Vec<f64>,
}

/// The number of parameters.
pub(crate) const COUNT: usize = 12;

/// The standard deviation of a touch along each axis, in mm.
pub(crate) const TOUCH_MM: f64 = 0.3;

impl Numbers {
    fn of(scaled: &[f64; COUNT], middle: &[f64; COUNT], suspect: Suspect) -> Self {
        let n: [f64; COUNT] = from_fn(|i| scaled[i] * BEFORE[i] + middle[i]);
        Self {
            arm: Self::arm_of(&n),
            paper: Plane {
                z0_mm: n[7],
                slope_x: n[8],
                slope_y: n[9],
            },
            scale: if suspect == Suspect::Scale {
                1.0 + n[10]
            } else {
                1.0
            },
            step_deg: if matches!(suspect, Suspect::StepBefore(_)) {
                n[11]
            } else {
                0.0
            },
        }
    }

    fn arm_of(n: &[f64; COUNT]) -> Calibration {
        Calibration {
            base_deg: n[0],
            rear_deg: n[1],
            fore_deg: n[2],
            reach_mm: n[3],
            left_mm: n[4],
            axis_mm: [n[5], n[6]],
            backlash_deg: [0.0; 3],
            table: None,
        }
    }

    /// Returns the deviation of the tool from the point that it touched, in mm.
    pub(crate) fn away_mm(&self, touch: &Touch, tool: Tool, is_after_step: bool) -> [f64; 3] {
        let base_deg = if is_after_step { self.step_deg } else { 0.0 };
        let raw = Joints {
            base: touch.raw.base + dobot_arm::Degrees(base_deg),
            ..touch.raw
        };
        let found = self.arm.true_place_of(&raw, tool);
        let [x_mm, y_mm] = touch.place_mm.map(|mm| mm * self.scale);
        let z_mm = self.paper.z_at([x_mm, y_mm]) + touch.height_mm;
        [found.x.0 - x_mm, found.y.0 - y_mm, found.z.0 - z_mm]
    }
}

impl Solved {
    /// Returns the uncertainty of the arm's parameters after one more touch.
    pub(crate) fn unsure_with(&self, touch: &Touch, tool: Tool) -> f64 {
        let mut more = self.information;
        let middle = [0.0; COUNT];
        let scaled = self.numbers.scaled();
        for row in jacobian(&[*touch], tool, Suspect::Nothing, &scaled, &middle) {
            add_square(&mut more, &row, 1.0);
        }
        let spread =
            inverse(&more).map_or(f64::INFINITY, |inverse| (0..5).map(|i| inverse[i][i]).sum());
        spread.max(0.0)
    }

    /// Returns the sum of squares of the best parameters without some touches: one step from here,
    /// in which a touch counts by its square.
    pub(crate) fn cost_without(&self, left_out: &[usize]) -> f64 {
        let mut information = PRIOR;
        let mut pull = self.at;
        let mut cost = norm_squared(&self.at);
        let touches = self.rows.chunks_exact(3).zip(self.away.chunks_exact(3));
        for (index, (rows, away)) in touches.enumerate() {
            if !left_out.contains(&index) {
                add_touch(&mut information, &mut pull, rows, away, 1.0);
                cost += norm_squared(away);
            }
        }
        let saved = |step: Vec<f64>| step.iter().zip(&pull).map(|(a, b)| a * b).sum::<f64>();
        solve_linear(&information, &pull).map_or(f64::INFINITY, |step| cost - saved(step))
    }
}

impl Numbers {
    fn scaled(&self) -> [f64; COUNT] {
        let Self { arm, paper, .. } = self;
        let numbers = [
            arm.base_deg,
            arm.rear_deg,
            arm.fore_deg,
            arm.reach_mm,
            arm.left_mm,
            arm.axis_mm[0],
            arm.axis_mm[1],
            paper.z0_mm,
            paper.slope_x,
            paper.slope_y,
            0.0,
            0.0,
        ];
        from_fn(|i| numbers[i] / BEFORE[i])
    }
}

/// Minimises the sum of squares with Huber's loss beyond [`HUBER`] and the prior [`BEFORE`]
/// (Levenberg-Marquardt).
pub(crate) fn solve(touches: &[Touch], tool: Tool, suspect: Suspect) -> Solved {
    let mut middle = [0.0; COUNT];
    // Start from the height of the first touch; the prior of the height is weak.
    middle[7] = touches.first().map_or(0.0, |touch| {
        Calibration::default().true_place_of(&touch.raw, tool).z.0 - touch.height_mm
    });
    let mut at = [0.0; COUNT];
    let mut damping = 1e-3;
    let mut cost = cost_of(touches, tool, suspect, &at, &middle);
    for _ in 0..ROUNDS {
        let rows = jacobian(touches, tool, suspect, &at, &middle);
        let away = residuals(touches, tool, suspect, &at, &middle);
        let (information, pull) = normal(&rows, &away, &at);
        let mut damped = information;
        for (i, row) in damped.iter_mut().enumerate() {
            row[i] *= 1.0 + damping;
        }
        let Some(step) = solve_linear(&damped, &pull) else {
            break;
        };
        let next = from_fn(|i| at[i] - step[i]);
        let next_cost = cost_of(touches, tool, suspect, &next, &middle);
        if next_cost < cost {
            let is_done = cost - next_cost < 1e-9 * cost.max(1e-9);
            (at, cost, damping) = (next, next_cost, damping * 0.2);
            if is_done {
                break;
            }
        } else {
            damping *= 8.0;
            if damping > 1e12 {
                break;
            }
        }
    }
    let rows = jacobian(touches, tool, suspect, &at, &middle);
    let away = residuals(touches, tool, suspect, &at, &middle);
    let (information, _) = normal(&rows, &away, &at);
    let spread = inverse(&information).map_or([1.0; COUNT], |inverse| {
        from_fn(|i| inverse[i][i].max(0.0).sqrt())
    });
    Solved {
        numbers: Numbers::of(&at, &middle, suspect),
        cost,
        spread,
        information,
        at,
        rows,
        away,
    }
}

/// Returns the matrix of the normal equations and their right side.
fn normal(
    rows: &[[f64; COUNT]],
    away: &[f64],
    at: &[f64; COUNT],
) -> ([[f64; COUNT]; COUNT], [f64; COUNT]) {
    let mut information = PRIOR;
    let mut pull = *at;
    for (rows, away) in rows.chunks_exact(3).zip(away.chunks_exact(3)) {
        let weight = (HUBER / norm(away).max(1e-12)).min(1.0);
        add_touch(&mut information, &mut pull, rows, away, weight);
    }
    (information, pull)
}

/// Adds a weighted touch to the normal equations.
fn add_touch(
    information: &mut [[f64; COUNT]; COUNT],
    pull: &mut [f64; COUNT],
    rows: &[[f64; COUNT]],
    away: &[f64],
    weight: f64,
) {
    for (row, away) in rows.iter().zip(away) {
        add_square(information, row, weight);
        for (pull, number) in pull.iter_mut().zip(row) {
            *pull += number * away * weight;
        }
    }
}

/// Adds the weighted outer product of a row of the Jacobian with itself.
fn add_square(information: &mut [[f64; COUNT]; COUNT], row: &[f64; COUNT], weight: f64) {
    for (sums, a) in information.iter_mut().zip(row) {
        for (sum, b) in sums.iter_mut().zip(row) {
            *sum += a * b * weight;
        }
    }
}

fn cost_of(
    touches: &[Touch],
    tool: Tool,
    suspect: Suspect,
    at: &[f64; COUNT],
    middle: &[f64; COUNT],
) -> f64 {
    let away = residuals(touches, tool, suspect, at, middle);
    let of_touch = |own: &[f64]| {
        let norm = norm(own);
        if norm <= HUBER {
            norm * norm
        } else {
            HUBER * (2.0 * norm - HUBER)
        }
    };
    away.chunks_exact(3).map(of_touch).sum::<f64>() + norm_squared(at)
}

/// Returns the deviations of all touches, three numbers each, in units of [`TOUCH_MM`].
fn residuals(
    touches: &[Touch],
    tool: Tool,
    suspect: Suspect,
    at: &[f64; COUNT],
    middle: &[f64; COUNT],
) -> Vec<f64> {
    let numbers = Numbers::of(at, middle, suspect);
    let all = touches.iter().enumerate().flat_map(|(index, touch)| {
        let is_after = matches!(suspect, Suspect::StepBefore(step) if index >= step);
        numbers.away_mm(touch, tool, is_after)
    });
    all.map(|mm| mm / TOUCH_MM).collect()
}

fn jacobian(
    touches: &[Touch],
    tool: Tool,
    suspect: Suspect,
    at: &[f64; COUNT],
    middle: &[f64; COUNT],
) -> Vec<[f64; COUNT]> {
    let mut rows = vec![[0.0; COUNT]; 3 * touches.len()];
    for column in 0..COUNT {
        let mut ends = [*at; 2];
        ends[0][column] -= DIFFERENCE;
        ends[1][column] += DIFFERENCE;
        let [before, after] =
            ends.map(|numbers| residuals(touches, tool, suspect, &numbers, middle));
        for (row, (after, before)) in rows.iter_mut().zip(after.iter().zip(&before)) {
            row[column] = (after - before) / (2.0 * DIFFERENCE);
        }
    }
    rows
}

fn norm(numbers: &[f64]) -> f64 {
    norm_squared(numbers).sqrt()
}

pub(crate) fn norm_squared(numbers: &[f64]) -> f64 {
    numbers.iter().map(|number| number * number).sum()
}

/// Returns the length of a vector.
pub(crate) fn length(away_mm: &[f64; 3]) -> f64 {
    norm(away_mm)
}

/// The information of the prior knowledge: each parameter is in units of its prior deviation.
const PRIOR: [[f64; COUNT]; COUNT] = {
    let mut identity = [[0.0; COUNT]; COUNT];
    let mut i = 0;
    while i < COUNT {
        identity[i][i] = 1.0;
        i += 1;
    }
    identity
};
/// The prior standard deviation of each parameter, in degrees, mm, and mm per mm; a sheet is laid
/// to a millimetre.
const BEFORE: [f64; COUNT] = [
    15.0, 12.0, 12.0, 7.0, 5.0, 0.6, 0.6, 100.0, 0.04, 0.04, 0.05, 30.0,
];
/// The residual beyond which a touch counts less, in units of [`TOUCH_MM`].
const HUBER: f64 = 3.0;
const DIFFERENCE: f64 = 1e-5;
const ROUNDS: usize = 100;
