//! Random arms whose tools touch a sheet, and the accuracy of their calibrations.

use std::fmt;

use dobot_arm::{Calibration, Degrees, Joints, Millimeters, Plane, Position, Tool};
use dobot_calibrate::{Fit, SHEET_POINTS, Sheet, Touch, Trust, fit};
use dobot_geometry::{Random, solve};

/// A way in which arms, sheet and touches differ from the ideal.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Case {
    /// Its name in the table.
    pub(crate) name: &'static str,
    /// The touched points, by index; after the last point the first follows again.
    pub(crate) points: [usize; 2],
    /// The share by which a link may be longer or shorter.
    pub(crate) links: f64,
    pub(crate) wrong: Wrong,
    /// The largest backlash of a joint.
    pub(crate) backlash_deg: f64,
    /// Whether a joint may come from either side.
    pub(crate) is_any_side: bool,
    /// The largest displacement of the sheet along each axis.
    pub(crate) sheet_mm: f64,
    /// The angle by which the base is turned by hand between two touches.
    pub(crate) turned_deg: f64,
    /// The size of the print; 1 at true size.
    pub(crate) print: f64,
}

/// The wrong touches.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Wrong {
    /// This many, each wrong by this distance in mm.
    Exactly(usize, f64),
    /// Each touch with this probability, by 12 mm.
    Each(f64),
}

const NINE: Case = Case {
    name: "9 touches",
    points: [0, 9],
    links: 0.02,
    wrong: Wrong::Exactly(0, 0.0),
    backlash_deg: 0.0,
    is_any_side: false,
    sheet_mm: 1.0,
    turned_deg: 0.0,
    print: 1.0,
};
const TWELVE: Case = Case {
    points: [0, 12],
    ..NINE
};

/// The rows of the table.
#[rustfmt::skip]
pub(crate) const CASES: [Case; 16] = [
    Case { name: "4 corners", points: [1, 5], ..NINE },
    Case { name: "6 touches", points: [0, 6], ..NINE },
    NINE,
    Case { name: "9 touches, links exact", links: 0.0, ..NINE },
    Case { name: "9 points, each twice", points: [0, 18], ..NINE },
    Case { name: "9 touches, one wrong by 5 mm", wrong: Wrong::Exactly(1, 5.0), ..NINE },
    Case { name: "12 touches, one wrong by 12 mm", wrong: Wrong::Exactly(1, 12.0), ..TWELVE },
    Case { name: "12 touches, two wrong by 12 mm", wrong: Wrong::Exactly(2, 12.0), ..TWELVE },
    Case { name: "12 touches, each wrong with probability 1/12", wrong: Wrong::Each(1.0 / 12.0), ..TWELVE },
    Case { name: "sheet up to 5 mm off", sheet_mm: 5.0, ..NINE },
    Case { name: "backlash up to 1°, same side", backlash_deg: 1.0, ..NINE },
    Case { name: "backlash up to 0.5°, either side", backlash_deg: 0.5, is_any_side: true, ..NINE },
    Case { name: "backlash up to 1°, either side", backlash_deg: 1.0, is_any_side: true, ..NINE },
    Case { name: "base turned by 0.5° between touches", turned_deg: 0.5, ..NINE },
    Case { name: "base turned by 2° between touches", turned_deg: 2.0, ..NINE },
    Case { name: "print at 99 %", print: 0.99, ..NINE },
];

/// The ratings and errors of the arms of a case.
#[derive(Clone, Debug, Default)]
pub(crate) struct Row {
    pub(crate) name: &'static str,
    pub(crate) good: usize,
    pub(crate) unchecked: usize,
    pub(crate) unmeasured: usize,
    pub(crate) doubtful: usize,
    pub(crate) refused: usize,
    /// The errors in the plane, and in height, of all positions of arms rated good or unchecked.
    pub(crate) plane_mm: Vec<f64>,
    pub(crate) height_mm: Vec<f64>,
    /// For each arm rated good, the error that 95 of 100 positions stay within.
    pub(crate) good_mm: Vec<f64>,
}

impl Row {
    /// Calibrates this many random arms.
    #[must_use]
    pub(crate) fn of(case: &Case, arms: u64) -> Self {
        let mut row = Self {
            name: case.name,
            ..Self::default()
        };
        for seed in 0..arms {
            row.add(case, &mut Random::sequence(41, seed));
        }
        row
    }

    fn add(&mut self, case: &Case, random: &mut Random) {
        let sheet = Sheet::chosen_by(random.number());
        // The person measures the bar, and prints the sheet again if it is refused.
        if sheet.check_bar(case.print * sheet.bar_mm()).is_err() {
            self.refused += 1;
            return;
        }
        let arm = Arm::random(case, random);
        let Ok(found) = fit(&arm.touches(case, random), TOOL) else {
            self.refused += 1;
            return;
        };
        // The person measures the tool, and confirms the fitted offset if it is about the same.
        let is_as_measured = (found.arm.reach_mm - arm.out_mm).abs() < RULER_MM
            && (found.arm.left_mm - arm.left_mm).abs() < RULER_MM;
        let found = if is_as_measured {
            found.with_measured_tool()
        } else {
            found
        };
        match found.trust {
            Trust::Good => self.good += 1,
            Trust::Unchecked => self.unchecked += 1,
            Trust::Unmeasured => self.unmeasured += 1,
            Trust::Doubtful => self.doubtful += 1,
        }
        if !matches!(found.trust, Trust::Good | Trust::Unchecked) {
            return;
        }
        let errors: Vec<[f64; 2]> = grid()
            .map(|place| arm.error_mm(place, &found, case))
            .collect();
        let mut plane_mm: Vec<f64> = errors.iter().map(|error| error[0]).collect();
        if found.trust == Trust::Good {
            self.good_mm.push(of_hundred(&mut plane_mm, 95));
        }
        self.plane_mm.extend(plane_mm);
        self.height_mm.extend(errors.iter().map(|error| error[1]));
    }
}

/// The row of the table.
impl fmt::Display for Row {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mm = |values: &[f64], share| {
            let mut values = values.to_vec();
            if values.is_empty() {
                "-".to_owned()
            } else {
                format!("{:.2} mm", of_hundred(&mut values, share))
            }
        };
        let Self {
            name,
            good,
            unchecked,
            unmeasured,
            doubtful,
            refused,
            ..
        } = self;
        write!(
            f,
            "| {name} | {good} | {unchecked} | {unmeasured} | {doubtful} | {refused} | {} | {} | {} | {} |",
            mm(&self.plane_mm, 50),
            mm(&self.plane_mm, 95),
            mm(&self.good_mm, 100),
            mm(&self.height_mm, 95),
        )
    }
}

/// An arm with all its errors, and its paper.
struct Arm {
    zeros_deg: [f64; 3],
    out_mm: f64,
    left_mm: f64,
    axis_mm: [f64; 2],
    links_mm: [f64; 2],
    /// The slope of the base: forward and to the left.
    tilt: [f64; 2],
    backlash_deg: [f64; 3],
    paper: Plane,
}

impl Arm {
    fn random(case: &Case, random: &mut Random) -> Self {
        let mut up_to = |most: f64| (2.0 * random.share() - 1.0) * most;
        let direction = up_to(std::f64::consts::PI);
        let slope = BASE_TILT_DEG.to_radians().tan();
        Self {
            zeros_deg: [0; 3].map(|_| up_to(25.0)),
            out_mm: up_to(10.0),
            left_mm: up_to(10.0),
            axis_mm: [0; 2].map(|_| up_to(case.sheet_mm)),
            links_mm: [135.0, 160.0].map(|mm| mm * (1.0 + up_to(case.links))),
            tilt: [slope * direction.cos(), slope * direction.sin()],
            backlash_deg: [0; 3].map(|_| (up_to(0.5) + 0.5) * case.backlash_deg),
            paper: Plane {
                z0_mm: -40.0 + up_to(10.0),
                slope_x: 0.0,
                slope_y: 0.0,
            },
        }
    }

    /// Returns the position of the tool above the table, for reported angles and the share of
    /// its backlash by which each joint is displaced.
    fn place(&self, raw: &Joints, slack: [f64; 3]) -> [f64; 3] {
        let turned = [raw.base, raw.rear, raw.fore];
        let [base, rear, fore] = [0, 1, 2].map(|joint| {
            let slack_deg = slack[joint] * self.backlash_deg[joint];
            (turned[joint].0 + self.zeros_deg[joint] + slack_deg).to_radians()
        });
        let [rear_mm, fore_mm] = self.links_mm;
        let out = rear_mm * rear.sin() + fore_mm * fore.cos() + TOOL.reach().0 + self.out_mm;
        let z = rear_mm * rear.cos() - fore_mm * fore.sin();
        let x = out * base.cos() - self.left_mm * base.sin();
        let y = out * base.sin() + self.left_mm * base.cos();
        // A small rotation about a horizontal axis.
        let [to_x, to_y] = self.tilt;
        let [axis_x, axis_y] = self.axis_mm;
        [
            axis_x + x - to_x * z,
            axis_y + y - to_y * z,
            z + to_x * x + to_y * y,
        ]
    }

    /// Returns the angles that the arm reports with its tool at a position (Newton's method).
    fn raw_at(&self, wanted: [f64; 3], slack: [f64; 3]) -> Joints {
        let near =
            Calibration::NONE.raw_joints(Position::new(wanted[0], wanted[1], wanted[2]), TOOL);
        let near = near.expect("the sheet is in reach");
        let mut raw = [near.base, near.rear, near.fore].map(|angle| angle.0);
        for (angle, zero) in raw.iter_mut().zip(self.zeros_deg) {
            *angle -= zero;
        }
        let joints = |raw: [f64; 3]| Joints::new(raw[0], raw[1], raw[2], 0.0);
        for _ in 0..20 {
            let at = self.place(&joints(raw), slack);
            let beside = [0, 1, 2].map(|joint| {
                let mut more = raw;
                more[joint] += 1e-4;
                self.place(&joints(more), slack)
            });
            let slope =
                |axis: usize| [0, 1, 2].map(|joint: usize| (beside[joint][axis] - at[axis]) / 1e-4);
            let away: Vec<f64> = (0..3).map(|axis| wanted[axis] - at[axis]).collect();
            let step = solve(&[0, 1, 2].map(slope), &away).expect("the arm is not stretched");
            for (angle, step) in raw.iter_mut().zip(step) {
                *angle += step;
            }
        }
        joints(raw)
    }

    fn touches(&self, case: &Case, random: &mut Random) -> Vec<Touch> {
        let [from, to] = case.points;
        let count = to - from;
        let wrong = wrong_touches(case.wrong, count, random);
        let turned_before = random
            .below(u32::try_from(count).expect("few touches"))
            .max(1);
        let touch = |index: usize| {
            let place_mm = SHEET_POINTS[(from + index) % SHEET_POINTS.len()];
            let z = self.paper.z0_mm;
            let direction = random.share() * std::f64::consts::TAU;
            let [dx, dy, dz] = [0; 3].map(|_| TOUCH_MM * normal(random));
            let touched = [
                place_mm[0] * case.print + dx + wrong[index] * direction.cos(),
                place_mm[1] * case.print + dy + wrong[index] * direction.sin(),
                z + dz,
            ];
            let raw = self.raw_at(touched, sides(case, random));
            let is_turned = index >= turned_before as usize;
            let turned = Degrees(if is_turned { case.turned_deg } else { 0.0 });
            Touch {
                place_mm,
                height_mm: 0.0,
                raw: Joints {
                    base: raw.base + turned,
                    ..raw
                },
            }
        };
        (0..count).map(touch).collect()
    }

    /// Returns the error of a position, in the plane and in height.
    fn error_mm(&self, [x_mm, y_mm]: [f64; 2], found: &Fit, case: &Case) -> [f64; 2] {
        let wanted = Position {
            x: Millimeters(x_mm),
            y: Millimeters(y_mm),
            z: Millimeters(found.paper.z_at([x_mm, y_mm])),
        };
        let mut raw = found
            .arm
            .raw_joints(wanted, TOOL)
            .expect("the sheet is in reach");
        raw.base = raw.base - Degrees(case.turned_deg);
        // If a joint may come from either side, it is in the middle of its backlash on average.
        let slack = if case.is_any_side { 0.5 } else { 0.0 };
        let [x, y, z] = self.place(&raw, [slack; 3]);
        [(x - x_mm).hypot(y - y_mm), (z - self.paper.z0_mm).abs()]
    }
}

/// A position on the paper and the angles that the arm reported there, in degrees.
pub(crate) type Cross = ([f64; 2], [f64; 3]);
/// A position by the drawing of the arm and the true one on the paper.
pub(crate) type Check = ([f64; 3], [f64; 2]);

/// Returns the 25 crosses that a random arm drew up to 10 mm beside where they were wanted, and the
/// positions at which to compare its calibration.
pub(crate) fn crosses(seed: u64) -> (Vec<Cross>, Vec<Check>) {
    let mut random = Random::sequence(43, seed);
    let arm = Arm::random(&NINE, &mut random);
    let wanted = (0..25).map(|n| {
        let [row, column] = [n / 5, n % 5].map(f64::from);
        [140.0 + 30.0 * row, -90.0 + 45.0 * column]
    });
    let [off_x, off_y] = [0; 2].map(|_| 14.0 * random.share() - 7.0);
    let draw = |[x, y]: [f64; 2]| {
        // The pen follows the touched paper as well as a touch does.
        let z = arm.paper.z0_mm + TOUCH_MM * normal(&mut random);
        let raw = arm.raw_at([x + off_x, y + off_y, z], [0.0; 3]);
        let [x, y, _] = arm.place(&raw, [0.0; 3]);
        let at = [x, y].map(|mm| mm + PEN_MM * normal(&mut random));
        (at, [raw.base, raw.rear, raw.fore].map(|angle| angle.0))
    };
    let crosses = wanted.map(draw).collect();
    let check = |place: [f64; 2]| {
        let raw = arm.raw_at([place[0], place[1], arm.paper.z0_mm], [0.0; 3]);
        let at = Calibration::NONE.true_place_of(&raw, TOOL);
        ([at.x.0, at.y.0, at.z.0], place)
    };
    (crosses, grid().map(check).collect())
}

/// Returns the share of its backlash by which each joint is displaced: all of it if it came from
/// the other side.
fn sides(case: &Case, random: &mut Random) -> [f64; 3] {
    let is_other_side = [0; 3].map(|_| case.is_any_side && random.chance(50.0));
    is_other_side.map(|is_other_side| if is_other_side { 1.0 } else { 0.0 })
}

/// Returns how far each touch is wrong, in mm.
fn wrong_touches(wrong: Wrong, count: usize, random: &mut Random) -> Vec<f64> {
    let mut by_mm = vec![0.0; count];
    match wrong {
        Wrong::Exactly(wrong, mm) => {
            let mut left: Vec<usize> = (0..count).collect();
            for _ in 0..wrong {
                let index = random.below(u32::try_from(left.len()).expect("few touches"));
                by_mm[left.swap_remove(index as usize)] = mm;
            }
        }
        Wrong::Each(share) => {
            for mm in &mut by_mm {
                if random.chance(100.0 * share) {
                    *mm = 12.0;
                }
            }
        }
    }
    by_mm
}

/// The whole drawing area of the paper.
fn grid() -> impl Iterator<Item = [f64; 2]> {
    let forward = (0..=8).map(|x| 150.0 + 15.0 * f64::from(x));
    forward.flat_map(|x_mm| (0..=10).map(move |y| [x_mm, -100.0 + 20.0 * f64::from(y)]))
}

/// A normally distributed random number (Box and Muller).
fn normal(random: &mut Random) -> f64 {
    let radius = (-2.0 * (1.0 - random.share()).ln()).sqrt();
    radius * (std::f64::consts::TAU * random.share()).cos()
}

/// Returns the value that this share of a hundred values does not exceed.
fn of_hundred(values: &mut [f64], share: usize) -> f64 {
    values.sort_by(f64::total_cmp);
    values[(values.len() - 1) * share / 100]
}

const BASE_TILT_DEG: f64 = 1.0;
const TOUCH_MM: f64 = 0.3;
/// How far a pen draws beside its holder's position.
const PEN_MM: f64 = 0.1;
/// How exactly a person measures the tool.
const RULER_MM: f64 = 8.0;
const TOOL: Tool = Tool::SuctionCup;
