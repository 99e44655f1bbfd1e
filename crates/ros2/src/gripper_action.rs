//! The action `gripper_command`.

use ros2_client::action::{ExecutingGoalHandle, GoalEndStatus};
use tokio::sync::watch;

use crate::actions::{GRIPPER_DEG, gripper};
use crate::goals::{Action, Outcome, Server};
use crate::messages::{GripperFeedback, GripperGoal, GripperResult, Header, JointState};
use crate::station::Station;

/// Turns the gripper. A turn is too short to be cancelled.
pub(crate) struct GripperAction {
    pub(crate) station: Station,
    pub(crate) ending: watch::Receiver<bool>,
}

impl Action for GripperAction {
    type Goal = GripperGoal;
    type Result = GripperResult;
    type Feedback = GripperFeedback;
    const NAME: &str = "gripper_command";

    async fn carry_out(
        &self,
        goal: &GripperGoal,
        _: &ExecutingGoalHandle<GripperGoal>,
        _: &Server<Self>,
        _: watch::Receiver<bool>,
    ) -> Outcome<GripperResult> {
        let turned = self.turn(&goal.command).await;
        let (status, position) = match &turned {
            Ok((rad, _)) => (GoalEndStatus::Succeeded, vec![*rad]),
            Err(_) => (GoalEndStatus::Aborted, Vec::new()),
        };
        Outcome {
            status,
            result: GripperResult {
                reached_goal: turned.is_ok(),
                stalled: false,
                state: JointState {
                    header: Header::now(""),
                    name: vec![GRIPPER.to_owned(); position.len()],
                    position,
                    velocity: Vec::new(),
                    effort: Vec::new(),
                },
            },
            text: turned.map(|(_, text)| text),
        }
    }
}

impl GripperAction {
    /// Turns the gripper; returns its angle in radians, and a message.
    async fn turn(&self, command: &JointState) -> Result<(f64, String), String> {
        let angle_deg = angle_deg(command)?;
        let mut station = self.station.connect("gripper").await?;
        let text = gripper(&mut station, angle_deg, &mut self.ending.clone()).await?;
        Ok((f64::from(angle_deg).to_radians(), text))
    }
}

/// Returns the angle of a goal.
fn angle_deg(command: &JointState) -> Result<f32, String> {
    if let Some(name) = command.name.iter().find(|name| *name != GRIPPER) {
        return Err(format!("command.name has {name:?}; allowed is {GRIPPER:?}"));
    }
    for (field, values) in [("velocity", &command.velocity), ("effort", &command.effort)] {
        if values.iter().any(|value| *value != 0.0) {
            return Err(format!(
                "command.{field} is {values:?}; allowed is none: the gripper has a speed and a force of its own"
            ));
        }
    }
    let most = f64::from(GRIPPER_DEG).to_radians();
    match command.position[..] {
        [rad] if rad.abs() <= most + ROUNDING => Ok(rounded(rad)),
        _ => Err(format!(
            "command.position is {:?}; allowed is one angle in radians, {:.4} (closed) to {most:.4} (open)",
            command.position, -most
        )),
    }
}

/// Converts radians to the angle that the arm gets.
fn rounded(rad: f64) -> f32 {
    dobot_wire::single(rad.to_degrees()).clamp(-GRIPPER_DEG, GRIPPER_DEG)
}

/// The joint of the gripper.
const GRIPPER: &str = "gripper";
/// Radians with four digits exceed a quarter turn by less.
const ROUNDING: f64 = 1e-4;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    fn command(name: &[&str], position: &[f64], effort: &[f64]) -> JointState {
        JointState {
            header: Header::now(""),
            name: name.iter().map(|name| (*name).to_owned()).collect(),
            position: position.to_vec(),
            velocity: Vec::new(),
            effort: effort.to_vec(),
        }
    }

    #[test]
    #[expect(clippy::approx_constant, reason = "what people type")]
    fn radians_become_degrees_and_four_digits_of_a_quarter_turn_are_allowed() {
        for (rad, expected) in [(-1.5708, -90.0), (1.5708, 90.0), (0.0, 0.0), (0.5236, 30.0)] {
            let found = angle_deg(&command(&["gripper"], &[rad], &[0.0])).unwrap();
            assert!((found - expected).abs() < 1e-2, "{found}, not {expected}");
        }
        assert!(angle_deg(&command(&[], &[0.1], &[])).is_ok());
    }

    #[test]
    fn a_goal_that_the_gripper_cannot_keep_is_refused_with_what_is_allowed() {
        for (wrong, expected) in [
            (command(&["finger"], &[0.0], &[]), "\"gripper\""),
            (
                command(&["gripper"], &[], &[]),
                "-1.5708 (closed) to 1.5708 (open)",
            ),
            (command(&["gripper"], &[1.6], &[]), "1.5708 (open)"),
            (command(&["gripper"], &[f64::NAN], &[]), "one angle"),
            (command(&["gripper"], &[0.1], &[5.0]), "a force of its own"),
        ] {
            let refused = angle_deg(&wrong).unwrap_err();
            assert!(refused.contains(expected), "{refused}");
        }
    }
}
