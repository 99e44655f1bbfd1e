//! `cargo run -p dobot-examples --example accuracy`: the accuracy of arms before and after a
//! calibration.
//!
//! Prints the table of `docs/calibration.md`, for a hundred random arms.

use dobot_arm::{Calibration, Degrees, Joints, Plane, Position, Tool};
use dobot_calibrate::{Fit, SHEET_POINTS, Touch, fit};
use dobot_geometry::Random;

/// An arm with all its errors, and its paper.
struct Arm {
    truth: Calibration,
    backlash_deg: [f64; 3],
    paper: Plane,
}

fn main() {
    println!(
        "| touches | arms | before, median | median | 95 of 100 | worst | height, 95 of 100 |"
    );
    println!("|---|---|---|---|---|---|---|");
    for (name, touches) in [
        ("4", touched(4, 1)),
        ("6", touched(6, 1)),
        ("9", touched(9, 1)),
        ("9, each twice", touched(9, 2)),
    ] {
        row(name, &touches);
    }
}

/// The first points of the sheet, each touched this many times.
fn touched(points: usize, times: usize) -> Vec<[f64; 2]> {
    // The four corners are better than the middle and three corners.
    let from = usize::from(points == 4);
    SHEET_POINTS[from..from + points].repeat(times)
}

fn row(name: &str, places: &[[f64; 2]]) {
    let mut before = Vec::new();
    let mut after = Vec::new();
    let mut heights = Vec::new();
    let mut refused = 0;
    for seed in 0..ARMS {
        let mut random = Random::sequence(16, seed);
        let arm = Arm::random(&mut random);
        let touches: Vec<Touch> = places
            .iter()
            .map(|place| arm.touch(*place, &mut random))
            .collect();
        let found = match fit(&touches, TOOL) {
            Ok(found) => found,
            Err(error) => {
                eprintln!("{name} touches, arm {seed}: {error}");
                refused += 1;
                continue;
            }
        };
        for place in grid() {
            let [plane_mm, z_mm] = arm.error_mm(place, &found);
            after.push(plane_mm);
            heights.push(z_mm);
            before.extend(arm.error_before_mm(place));
        }
    }
    println!(
        "| {name} | {} | {:.1} mm | {:.2} mm | {:.2} mm | {:.2} mm | {:.2} mm |",
        ARMS - refused,
        of_hundred(&mut before, 50),
        of_hundred(&mut after, 50),
        of_hundred(&mut after, 95),
        of_hundred(&mut after, 100),
        of_hundred(&mut heights, 95),
    );
}

impl Arm {
    fn random(random: &mut Random) -> Self {
        let mut up_to = |most: f64| (2.0 * random.share() - 1.0) * most;
        let tilt_deg = 2.0;
        let direction = up_to(std::f64::consts::PI);
        let slope = f64::to_radians(tilt_deg).tan();
        Self {
            truth: Calibration {
                base_deg: up_to(25.0),
                rear_deg: up_to(25.0),
                fore_deg: up_to(25.0),
                reach_mm: up_to(10.0),
                left_mm: up_to(10.0),
                axis_mm: [up_to(1.0), up_to(1.0)],
                backlash_deg: [0.0; 3],
                table: None,
            },
            backlash_deg: [0; 3].map(|_| up_to(0.25) + 0.25),
            paper: Plane {
                z0_mm: -40.0 + up_to(10.0),
                slope_x: slope * direction.cos(),
                slope_y: slope * direction.sin(),
            },
        }
    }

    /// A person moves the tool to the point, each joint always from the same side, with a small
    /// error.
    fn touch(&self, place_mm: [f64; 2], random: &mut Random) -> Touch {
        let [x_mm, y_mm] = place_mm;
        let z_mm = self.paper.z_at(place_mm);
        let [dx, dy, dz] = [0; 3].map(|_| NOISE_MM * normal(random));
        let place = Position::new(x_mm + dx, y_mm + dy, z_mm + dz);
        let told = self
            .truth
            .told_joints(place, TOOL)
            .expect("the sheet is in reach");
        // The backlash of each joint is on the same side each time: it becomes part of the zero.
        let [base, rear, fore] = self.backlash_deg;
        Touch {
            place_mm,
            height_mm: 0.0,
            raw: Joints {
                base: told.base + Degrees(base / 2.0),
                rear: told.rear + Degrees(rear / 2.0),
                fore: told.fore + Degrees(fore / 2.0),
                ..told
            },
        }
    }

    /// Returns the error of a position, in the plane and in height, if each joint approaches from
    /// the side from which it touched.
    fn error_mm(&self, place_mm: [f64; 2], found: &Fit) -> [f64; 2] {
        let [x_mm, y_mm] = place_mm;
        let wanted = Position::new(x_mm, y_mm, found.paper.z_at(place_mm));
        let told = found
            .arm
            .told_joints(wanted, TOOL)
            .expect("the sheet is in reach");
        let [base, rear, fore] = self.backlash_deg;
        let told = Joints {
            base: told.base + Degrees(-base / 2.0),
            rear: told.rear + Degrees(-rear / 2.0),
            fore: told.fore + Degrees(-fore / 2.0),
            ..told
        };
        let came = self.truth.true_place_of(&told, TOOL);
        let z_mm = came.z.0 - self.paper.z_at([came.x.0, came.y.0]);
        [(came.x.0 - x_mm).hypot(came.y.0 - y_mm), z_mm.abs()]
    }

    /// Returns the error of an uncalibrated arm; `None` if it could not reach the position at all.
    fn error_before_mm(&self, [x_mm, y_mm]: [f64; 2]) -> Option<f64> {
        let wanted = Position::new(x_mm, y_mm, self.paper.z_at([x_mm, y_mm]));
        let came = self.truth.true_place(wanted, TOOL).ok()?;
        Some((came.x.0 - x_mm).hypot(came.y.0 - y_mm))
    }
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

fn of_hundred(values: &mut [f64], share: usize) -> f64 {
    values.sort_by(f64::total_cmp);
    values[(values.len() - 1) * share / 100]
}

const ARMS: u64 = 100;
const NOISE_MM: f64 = 0.3;
const TOOL: Tool = Tool::SuctionCup;
