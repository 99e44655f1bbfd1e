//! Conversion between raw and calibrated positions.
//!
//! A model, its trajectories and the statuses use raw positions. People and rules use calibrated
//! positions: a [`Model`] with a [`Calibration`] converts between them.

use dobot_arm::{Calibration, Degrees, Joints, Pose, Tool, Unreachable, forward};
use dobot_wire::{Command, MoveJoints, MoveTo, MovingMode, WriteVector, single};

use super::place::position;
use crate::{ArmPlace, Model};

impl ArmPlace {
    /// Returns the calibrated joint angles and position for this raw position.
    #[must_use]
    pub fn calibrated(&self, calibration: &Calibration, tool: Tool) -> Self {
        if calibration.is_none() {
            return *self;
        }
        Self {
            joints: calibration.true_joints(&self.joints),
            pose: Pose {
                position: calibration.true_place_of(&self.joints, tool),
                rotation: self.pose.rotation + Degrees(calibration.base_deg),
            },
        }
    }
}

/// Converts a command from calibrated to raw positions for an arm with this calibration.
///
/// Targets in positions or joint angles are converted; all other commands are returned unchanged.
/// If the start is known, backlash is compensated where a joint reverses.
///
/// # Errors
///
/// [`Unreachable`] if the arm cannot bring its tool to the calibrated position.
pub fn to_raw(
    command: &Command,
    arm: &Calibration,
    tool: Tool,
    from: Option<&Joints>,
) -> Result<Command, Unreachable> {
    if arm.is_none() {
        return Ok(*command);
    }
    Ok(match command {
        Command::MoveTo(move_to) => {
            let there = position(move_to.x_mm, move_to.y_mm, move_to.z_mm);
            let joints = arm.raw_joints(there, tool)?;
            let above = position(move_to.x_mm, move_to.y_mm, move_to.z_mm + 1.0);
            let lowered = arm.raw_joints(above, tool).ok();
            let from = match move_to.mode {
                // A JUMP approaches its end from above, with the base already turned.
                MovingMode::Jump => from.zip(lowered).map(|(from, above)| Joints {
                    base: from.base,
                    ..above
                }),
                _ => from.copied(),
            };
            let raw = forward(&compensated(&joints, from.as_ref(), arm), tool).position;
            MoveTo {
                x_mm: single(raw.x.0),
                y_mm: single(raw.y.0),
                z_mm: single(raw.z.0),
                rotation_deg: single(f64::from(move_to.rotation_deg) - arm.base_deg),
                ..*move_to
            }
            .into()
        }
        Command::MoveJoints(move_joints) => {
            let [base, rear, fore] = [
                move_joints.base_deg,
                move_joints.rear_deg,
                move_joints.fore_deg,
            ]
            .map(f64::from);
            let joints = arm.raw_joints_of(&Joints::new(base, rear, fore, 0.0));
            let raw = compensated(&joints, from, arm);
            MoveJoints {
                base_deg: single(raw.base.0),
                rear_deg: single(raw.rear.0),
                fore_deg: single(raw.fore.0),
                ..*move_joints
            }
            .into()
        }
        _ => *command,
    })
}

/// Returns the raw joint angles with backlash compensated, given those of the start.
fn compensated(joints: &Joints, from: Option<&Joints>, arm: &Calibration) -> Joints {
    from.map_or(*joints, |from| {
        let turned = [
            joints.base - from.base,
            joints.rear - from.rear,
            joints.fore - from.fore,
        ];
        arm.motors_at(joints, turned.map(|angle| angle.0))
    })
}

impl Model {
    /// Returns the calibrated position of a raw one.
    #[must_use]
    pub fn calibrated_place(&self, raw: &ArmPlace) -> ArmPlace {
        raw.calibrated(&self.calibration, self.tool)
    }

    /// Converts a command from calibrated to raw positions: targets, joint angles and vectors,
    /// which begin at the arm's position.
    ///
    /// The end of a line is exact. The line between is straight in raw positions, which bends it by
    /// the errors of zeros and tool.
    ///
    /// # Errors
    ///
    /// [`Unreachable`] if the arm cannot bring its tool to the calibrated position.
    pub fn to_raw(&self, command: &Command) -> Result<Command, Unreachable> {
        let arm = &self.calibration;
        match command {
            Command::WriteVector(write) if !write.stop && !arm.is_none() => {
                let here = self.calibrated_place(&self.place).pose.position;
                let there = here + position(write.x_mm, write.y_mm, write.z_mm);
                let joints = arm.raw_joints(there, self.tool)?;
                let joints = compensated(&joints, Some(&self.place.joints), arm);
                let raw = forward(&joints, self.tool).position - self.place.pose.position;
                Ok(WriteVector {
                    x_mm: single(raw.x.0),
                    y_mm: single(raw.y.0),
                    z_mm: single(raw.z.0),
                    ..*write
                }
                .into())
            }
            _ => to_raw(command, arm, self.tool, Some(&self.place.joints)),
        }
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use dobot_arm::Position;
    use dobot_wire::Dialect;
    use proptest::prelude::*;

    use super::*;

    fn arm() -> impl Strategy<Value = Calibration> {
        (
            -25.0..25.0,
            -20.0..20.0,
            -20.0..20.0,
            -10.0..10.0,
            -10.0..10.0,
        )
            .prop_map(
                |(base_deg, rear_deg, fore_deg, reach_mm, left_mm)| Calibration {
                    base_deg,
                    rear_deg,
                    fore_deg,
                    reach_mm,
                    left_mm,
                    axis_mm: [1.0, -2.0],
                    backlash_deg: [0.0; 3],
                    table: None,
                },
            )
    }

    fn model(calibration: Calibration) -> Model {
        let here = ArmPlace::at_joints(Joints::new(10.0, 40.0, 45.0, 0.0), Tool::SuctionCup);
        Model::standing(Dialect::SPECIFICATION, here).calibrated(calibration)
    }

    /// Returns the calibrated position after a command.
    fn end(model: &Model, command: &Command) -> ArmPlace {
        let raw = model.to_raw(command).unwrap();
        let trajectory = model.trajectory(&raw).unwrap();
        model.calibrated_place(&trajectory.end().unwrap())
    }

    proptest! {
        #[test]
        fn a_target_brings_the_tool_to_the_calibrated_place(arm in arm(), x in 190.0_f32..230.0, y in -60.0_f32..60.0, z in -10.0_f32..30.0) {
            let model = model(arm);
            let target = Command::from(MoveTo::to(x, y, z));
            prop_assume!(model.to_raw(&target).is_ok_and(|raw| model.trajectory(&raw).is_ok()));
            let found = end(&model, &target).pose.position;
            let away = found - position(x, y, z);
            prop_assert!(away.x.0.hypot(away.y.0).hypot(away.z.0) < 1e-3, "{found:?}");
        }

        #[test]
        fn a_vector_moves_the_tool_by_what_it_says(arm in arm(), dx in -10.0_f32..10.0, dy in -10.0_f32..10.0) {
            let model = model(arm);
            let vector = Command::from(WriteVector::by(dx, dy, 0.0, 40.0));
            prop_assume!(model.to_raw(&vector).is_ok_and(|raw| model.trajectory(&raw).is_ok()));
            let from = model.calibrated_place(&model.place).pose.position;
            let gone = end(&model, &vector).pose.position - from;
            prop_assert!((gone - position(dx, dy, 0.0)).reach().0 < 1e-3, "{gone:?}");
        }
    }

    #[test]
    fn joint_angles_are_the_calibrated_ones() {
        let zeros = Calibration {
            base_deg: 5.0,
            rear_deg: -3.0,
            fore_deg: 2.0,
            ..Calibration::NONE
        };
        let turned = Command::from(MoveJoints::to([20.0, 30.0, 50.0, 0.0]));
        let joints = end(&model(zeros), &turned).joints;
        let found = [joints.base.0, joints.rear.0, joints.fore.0];
        for (found, wanted) in found.into_iter().zip([20.0, 30.0, 50.0]) {
            assert!((found - wanted).abs() < 1e-4, "{joints:?}");
        }
    }

    #[test]
    fn to_an_arm_as_drawn_a_command_means_what_it_says() {
        let target = Command::from(MoveTo::to(200.0, 10.0, 5.0));
        assert_eq!(model(Calibration::NONE).to_raw(&target), Ok(target));
    }

    #[test]
    fn what_the_arm_cannot_come_to_is_refused() {
        let far = Command::from(MoveTo::to(500.0, 0.0, 0.0));
        let arm = Calibration {
            reach_mm: 5.0,
            ..Calibration::NONE
        };
        model(arm).to_raw(&far).unwrap_err();
        assert!(model(arm).place.pose.position != Position::new(500.0, 0.0, 0.0));
    }
}
