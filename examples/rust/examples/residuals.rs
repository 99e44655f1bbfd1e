//! `cargo run -p dobot-examples --example residuals`: the residuals of an arm's touches, one of
//! them wrong.
//!
//! Prints `docs/pictures/residuals.svg`.

use dobot_arm::{Calibration, Position, Tool};
use dobot_calibrate::{SHEET_POINTS, Touch, fit, residuals_svg};
use dobot_geometry::Random;

fn main() {
    let arm = Calibration {
        base_deg: 6.0,
        rear_deg: -8.0,
        fore_deg: 5.0,
        reach_mm: 4.0,
        ..Calibration::NONE
    };
    let mut random = Random::new(5);
    let mut missed = || (random.share() - 0.5) * 0.6;
    let mut touches = SHEET_POINTS.map(|[x, y]| {
        let there = Position::new(x + missed(), y + missed(), -42.0 + missed());
        let joints = arm.raw_joints(there, Tool::SuctionCup);
        Touch {
            place_mm: [x, y],
            height_mm: 0.0,
            raw: joints.expect("the arm reaches the sheet"),
        }
    });
    touches[4].place_mm[0] += 12.0;
    let fit = fit(&touches, Tool::SuctionCup).expect("nine touches are enough");
    print!("{}", residuals_svg(&touches, &fit));
}
