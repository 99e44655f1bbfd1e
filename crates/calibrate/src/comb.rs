//! A test comb that shows the backlash of a joint.
//!
//! The comb has pairs of lines: the joint reaches the first line of a pair by turning on and the
//! second by turning back. From pair to pair, the second line is commanded a little less, as on a
//! vernier: the pair whose lines meet shows the backlash.
//!
//! ```text
//!   | | | | | | |     turned on, 0 1 2 3 ...
//!    | || | | | |     turned back, less by n times 0.05 degrees: here pair 3 meets, which is 0.15 degrees
//! ```

use dobot_arm::{Calibration, Degrees, Joints, Position, Tool, Unreachable, forward};
use dobot_wire::{Command, MoveJoints, MoveTo, MovingMode, PlaybackAdjustment, single};

/// A joint whose backlash a comb can measure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SlackJoint {
    /// The base.
    Base,
    /// The rear arm.
    Rear,
    /// The forearm.
    Fore,
}

/// The number of pairs in a comb, numbered from 0.
pub const COMB_PAIRS: u32 = 13;
/// The decrease of the commanded angle of the second line from pair to pair, in degrees.
pub const COMB_STEP_DEG: f64 = 0.05;

/// Returns the commands that draw the comb of a joint on paper of these heights with a calibrated
/// arm.
///
/// # Errors
///
/// [`Unreachable`] if the arm cannot reach the comb in the middle of the sheet.
pub fn comb(
    joint: SlackJoint,
    arm: &Calibration,
    paper_z_mm: impl Fn([f64; 2]) -> f64,
    tool: Tool,
) -> Result<Vec<Command>, Unreachable> {
    let at = |reach_mm: f64, deg: f64| {
        let (sin, cos) = deg.to_radians().sin_cos();
        let [x, y] = [reach_mm * cos, reach_mm * sin];
        arm.raw_joints(Position::new(x, y, paper_z_mm([x, y])), tool)
    };
    let mut drawn = Comb {
        tool,
        commands: vec![SLOWLY.into()],
    };
    for pair in 0..COMB_PAIRS {
        let number = f64::from(pair);
        let less = Degrees(number * COMB_STEP_DEG);
        let middle = number - f64::from(COMB_PAIRS - 1) / 2.0;
        for is_back in [false, true] {
            let less = if is_back { less } else { Degrees(0.0) };
            let from = Degrees(if is_back { RUN_UP_DEG } else { -RUN_UP_DEG });
            match joint {
                SlackJoint::Base => {
                    let deg = middle * BASE_PITCH_DEG;
                    let [near, far] = if is_back {
                        [BASE_REACH_MM - LINE_MM, BASE_REACH_MM]
                    } else {
                        [BASE_REACH_MM, BASE_REACH_MM + LINE_MM]
                    };
                    let [mut near, mut far] = [at(near, deg)?, at(far, deg)?];
                    near.base = near.base - less;
                    far.base = near.base;
                    drawn.base_line(near, far, from);
                }
                SlackJoint::Rear => {
                    let mut there = at(REAR_REACH_MM + number * PITCH_MM, 0.0)?;
                    there.rear = there.rear - less;
                    let above = Joints {
                        fore: there.fore - Degrees(LIFT_FORE_DEG),
                        ..there
                    };
                    let beside = Joints {
                        rear: above.rear + from,
                        ..above
                    };
                    drawn.link_line([beside, above, there], is_back);
                }
                SlackJoint::Fore => {
                    let mut there = at(FORE_REACH_MM + number * PITCH_MM, 0.0)?;
                    there.fore = there.fore - less;
                    let above = Joints {
                        rear: there.rear - Degrees(LIFT_REAR_DEG),
                        ..there
                    };
                    let beside = Joints {
                        fore: above.fore + from,
                        ..above
                    };
                    drawn.link_line([beside, above, there], is_back);
                }
            }
        }
    }
    Ok(drawn.commands)
}

struct Comb {
    tool: Tool,
    commands: Vec<Command>,
}

impl Comb {
    /// Draws a line towards the base, which does not turn meanwhile.
    fn base_line(&mut self, near: Joints, far: Joints, from: Degrees) {
        let beside = Joints {
            base: near.base + from,
            ..near
        };
        for (joints, above_mm) in [
            (beside, UP_MM),
            (near, UP_MM),
            (near, 0.0),
            (far, 0.0),
            (far, UP_MM),
        ] {
            let place = forward(&joints, self.tool).position;
            let (x, y, z) = (place.x.0, place.y.0, place.z.0 + above_mm);
            let mode = if joints == beside || above_mm > 0.0 && joints == near {
                MovingMode::MovJ
            } else {
                MovingMode::MovL
            };
            let target = MoveTo::to(single(x), single(y), single(z)).with_mode(mode);
            self.commands.push(target.into());
        }
    }

    /// Draws a line across with the base alone: beside the place, above it, down, across, up again.
    fn link_line(&mut self, [beside, above, there]: [Joints; 3], is_back: bool) {
        let across = Degrees(if is_back { -LINE_DEG } else { LINE_DEG });
        let turned = |joints: Joints| Joints {
            base: joints.base + across,
            ..joints
        };
        for joints in [beside, above, there, turned(there), turned(above)] {
            let angles = [joints.base, joints.rear, joints.fore, joints.servo];
            let target = MoveJoints::to(angles.map(|angle| single(angle.0)));
            self.commands
                .push(target.with_mode(MovingMode::MovJ).into());
        }
    }
}

/// Slow enough that the pen does not jump.
const SLOWLY: PlaybackAdjustment = PlaybackAdjustment {
    speed_percent: 30.0,
    acceleration_percent: 50.0,
    teach_speed_percent: 50.0,
};
/// The angle by which a joint turns before it reaches a line: more than any backlash.
const RUN_UP_DEG: f64 = 2.0;
const LINE_MM: f64 = 8.0;
const LINE_DEG: f64 = 2.0;
const UP_MM: f64 = 6.0;
const BASE_REACH_MM: f64 = 215.0;
const BASE_PITCH_DEG: f64 = 1.2;
const REAR_REACH_MM: f64 = 190.0;
const FORE_REACH_MM: f64 = 195.0;
const PITCH_MM: f64 = 4.0;
/// The angle by which the other link lifts the pen: more than a run-up lowers it.
const LIFT_FORE_DEG: f64 = 6.0;
const LIFT_REAR_DEG: f64 = 12.0;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    #[test]
    fn the_pen_is_above_the_paper_on_every_path_to_a_line() {
        for joint in [SlackJoint::Base, SlackJoint::Rear, SlackJoint::Fore] {
            let commands = comb(joint, &Calibration::NONE, |_| -40.0, Tool::SuctionCup).unwrap();
            let heights: Vec<f64> = commands.iter().filter_map(height).collect();
            assert_eq!(heights.len(), 5 * 2 * COMB_PAIRS as usize);
            for line in heights.chunks(5) {
                assert!(
                    line[0] > 0.5 && line[1] > 2.0 && line[4] > 2.0,
                    "{joint:?}: {line:?}"
                );
                // A line with a smaller angle is slightly higher; the pen's spring absorbs more
                // than that.
                assert!(
                    line[2].abs() < 1.5 && line[3].abs() < 1.5,
                    "{joint:?}: {line:?}"
                );
            }
        }
    }

    fn height(command: &Command) -> Option<f64> {
        match command {
            Command::MoveTo(target) => Some(f64::from(target.z_mm) + 40.0),
            Command::MoveJoints(angles) => {
                let angles = [angles.base_deg, angles.rear_deg, angles.fore_deg].map(f64::from);
                let joints = Joints::new(angles[0], angles[1], angles[2], 0.0);
                Some(forward(&joints, Tool::SuctionCup).position.z.0 + 40.0)
            }
            _ => None,
        }
    }

    #[test]
    fn a_comb_beyond_the_reach_is_refused() {
        comb(
            SlackJoint::Rear,
            &Calibration::NONE,
            |_| -290.0,
            Tool::SuctionCup,
        )
        .unwrap_err();
    }
}
