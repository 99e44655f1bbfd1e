//! The prediction of a command.

use std::time::Duration;

use dobot_arm::Position;
use dobot_motion::{ArmPlace, Model, Trajectory, TrajectoryError};
use dobot_wire::{Command, Status};

use crate::SendError;

/// The prediction of a command from the model at the time it was queued. It is made once and kept with the command.
#[derive(Clone, Debug)]
pub(crate) struct Plan {
    pub(crate) trajectory: Result<Trajectory, TrajectoryError>,
    /// The model after the command.
    pub(crate) after: Model,
    /// Its target, reachable or not; `None` if unknown.
    pub(crate) target: Option<Position>,
    /// Duration of its motion: 0 for a jog, which has no end; long if unknown.
    pub(crate) motion: Duration,
    /// Upper bound of the duration of its motion.
    pub(crate) longest_motion: Duration,
    /// Pause after it.
    pub(crate) pause: Duration,
}

impl Plan {
    pub(crate) fn new(model: &Model, command: &Command) -> Box<Self> {
        let trajectory = model.trajectory(command);
        let after = model_after(model, command, &trajectory);
        let target = match &trajectory {
            Ok(trajectory) => trajectory.end().map(|end| end.pose.position),
            Err(_) => model.target(command),
        };
        let lasts = |of: fn(&Trajectory) -> Option<f64>| match &trajectory {
            Ok(trajectory) => of(trajectory).map_or(Duration::ZERO, seconds),
            Err(_) => UNFORESEEN,
        };
        Box::new(Self {
            motion: lasts(Trajectory::lasts_s),
            longest_motion: lasts(Trajectory::lasts_at_most_s),
            trajectory,
            after,
            target,
            pause: seconds(model.pause_s(command)),
        })
    }

    /// Why it must not be sent: a stock arm would never finish it.
    pub(crate) const fn trap(&self) -> Option<SendError> {
        match self.trajectory {
            Err(TrajectoryError::OnTheSpot) => Some(SendError::OnTheSpot),
            Err(
                trap @ (TrajectoryError::NeverEnds
                | TrajectoryError::NothingToFollow
                | TrajectoryError::NotUnderstood
                | TrajectoryError::NotHeard
                | TrajectoryError::BehindCutLine
                | TrajectoryError::LeavesBackwards { .. }
                | TrajectoryError::Uncounted { .. }),
            ) => Some(SendError::Trap(trap)),
            _ => None,
        }
    }

    /// The line that it follows, if it does.
    pub(crate) fn line(&self) -> Option<(Position, Position)> {
        self.trajectory
            .ok()
            .and_then(|trajectory| trajectory.line())
    }

    /// Whether it moves nothing and ends immediately.
    pub(crate) fn is_still(&self) -> bool {
        self.trajectory
            .is_ok_and(|trajectory| trajectory.duration_s() == Some(0.0))
    }

    /// Whether it has no end of its own (a jog).
    pub(crate) fn is_endless(&self) -> bool {
        self.trajectory
            .is_ok_and(|trajectory| trajectory.motion_s().is_none())
    }

    /// Whether its path is predicted to leave the limits of the arm.
    pub(crate) fn leaves_limits(&self) -> bool {
        let checked = self.trajectory.and_then(|trajectory| trajectory.check());
        matches!(checked, Err(TrajectoryError::Unreachable(_)))
    }

    /// Whether the status is at the target.
    pub(crate) fn is_near(&self, status: &Status) -> bool {
        self.target
            .is_some_and(|target| target.distance(position(status)).0 <= ARRIVED_MM)
    }

    /// Whether the status is on the path of a jog from the predicted start. The end of the command before it
    /// may never be visible, because the jog can move the arm away immediately.
    pub(crate) fn jogs_by(&self, status: &Status) -> bool {
        let exact = self.trajectory.ok().filter(Trajectory::is_exact);
        let Some(jog) = exact.and_then(|trajectory| trajectory.jog()) else {
            return false;
        };
        let nearest = jog.nearest(&ArmPlace::of_status(status));
        nearest.is_ok_and(|place| place.pose.position.distance(position(status)).0 <= ARRIVED_MM)
    }

    /// Like [`Plan::is_near`], with the rotation of the tool as well.
    pub(crate) fn ends_at(&self, status: &Status) -> bool {
        let end = self.trajectory.ok().and_then(|trajectory| trajectory.end());
        let turned =
            |rotation_deg: f64| (rotation_deg - f64::from(status.rotation_deg)).abs() <= TURNED_DEG;
        self.is_near(status) && end.is_none_or(|end| turned(end.pose.rotation.0))
    }

    /// Whether the status equals the predicted one after the command, in everything that is predicted.
    pub(crate) fn shows(&self, status: &Status) -> bool {
        let gripper_deg = f64::from(status.gripper_deg);
        self.after.suction == status.suction
            && (self.after.gripper_deg - gripper_deg).abs() <= TURNED_DEG
            && (self.target.is_none() || self.ends_at(status))
    }
}

/// Returns the position of the tool in a status.
#[must_use]
pub fn position(status: &Status) -> Position {
    Position::new(status.x_mm.into(), status.y_mm.into(), status.z_mm.into())
}

/// Returns the model after a command.
fn model_after(
    model: &Model,
    command: &Command,
    trajectory: &Result<Trajectory, TrajectoryError>,
) -> Model {
    if let Ok(trajectory) = trajectory {
        return model.after(command, trajectory);
    }
    // It is refused, skipped or cut short: the place of the arm is seen when it rests.
    let mut after = model.begun(command);
    after.lose_place();
    after
}

pub(crate) fn seconds(seconds: f64) -> Duration {
    Duration::try_from_secs_f64(seconds).unwrap_or(FOR_EVER)
}

/// Tolerance for arrival; a stock arm reports its target to 0.01 mm.
pub(crate) const ARRIVED_MM: f64 = 0.05;
const TURNED_DEG: f64 = 0.05;
/// Assumed duration of a command with an unknown path: 700 mm at a quarter of the stock speed.
const UNFORESEEN: Duration = Duration::from_secs(60);
/// Long, but many of them can be added without overflow.
const FOR_EVER: Duration = Duration::from_secs(u32::MAX as u64);
