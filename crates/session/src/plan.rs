//! The one prediction of where a command leads.

use std::time::Duration;

use dobot_arm::Position;
use dobot_motion::{ArmPlace, Model, Trajectory, TrajectoryError};
use dobot_wire::{Command, Status};

use crate::SendError;

/// Where a command leads from what was believed when it was given: told once, and kept with it.
#[derive(Clone, Debug)]
pub(crate) struct Plan {
    pub(crate) trajectory: Result<Trajectory, TrajectoryError>,
    /// What is to be believed when it is over.
    pub(crate) after: Model,
    /// Where it should end, in reach or not; `None` where nobody can tell.
    pub(crate) aim: Option<Position>,
    /// How long its motion takes: nothing for a jog, which goes on; long where nobody can tell.
    pub(crate) motion: Duration,
    /// The same at the most.
    pub(crate) longest_motion: Duration,
    /// How long the arm waits behind it.
    pub(crate) pause: Duration,
}

impl Plan {
    pub(crate) fn new(model: &Model, command: &Command) -> Box<Self> {
        let trajectory = model.trajectory(command);
        let after = if let Ok(trajectory) = &trajectory {
            model.after(command, trajectory)
        } else {
            // It is refused, skipped or cut short: where the arm is then is seen when it rests.
            let mut after = model.begun(command);
            after.lose_place();
            after
        };
        let aim = match &trajectory {
            Ok(trajectory) => trajectory.end().map(|it| it.pose.position),
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
            aim,
            pause: seconds(model.pause_s(command)),
        })
    }

    /// Why it must not be sent, if a stock arm would not come out of it.
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

    /// Whether nothing moves by it, and it is over at once.
    pub(crate) fn is_still(&self) -> bool {
        self.trajectory.is_ok_and(|it| it.duration_s() == Some(0.0))
    }

    /// Whether it goes on until told otherwise.
    pub(crate) fn is_endless(&self) -> bool {
        self.trajectory.is_ok_and(|it| it.motion_s().is_none())
    }

    /// Whether its way leaves the limits of the arm, as far as that can be foreseen.
    pub(crate) fn leaves_limits(&self) -> bool {
        let way = self.trajectory.and_then(|it| it.check());
        matches!(way, Err(TrajectoryError::Unreachable(_)))
    }

    /// Whether an arm with this status stands where it ends.
    pub(crate) fn is_near(&self, status: &Status) -> bool {
        self.aim
            .is_some_and(|aim| aim.distance(position(status)).0 <= ARRIVED_MM)
    }

    /// Whether an arm with this status stands on the way of a jog that begins where it is believed to: what ended
    /// there need not have been seen, since the jog may have taken the arm away at once.
    pub(crate) fn jogs_by(&self, status: &Status) -> bool {
        let exact = self.trajectory.ok().filter(Trajectory::is_exact);
        let Some(jog) = exact.and_then(|it| it.jog()) else {
            return false;
        };
        let nearest = jog.nearest(&ArmPlace::of_status(status));
        nearest.is_ok_and(|it| it.pose.position.distance(position(status)).0 <= ARRIVED_MM)
    }

    /// As [`Plan::is_near`], with the tool turned as it should be then.
    pub(crate) fn ends_at(&self, status: &Status) -> bool {
        let end = self.trajectory.ok().and_then(|it| it.end());
        let turned =
            |rotation_deg: f64| (rotation_deg - f64::from(status.rotation_deg)).abs() <= TURNED_DEG;
        self.is_near(status) && end.is_none_or(|it| turned(it.pose.rotation.0))
    }

    /// Whether a status looks as after it, in all that a status tells and that is foreseen.
    pub(crate) fn shows(&self, status: &Status) -> bool {
        let gripper_deg = f64::from(status.gripper_deg);
        self.after.suction == status.suction
            && (self.after.gripper_deg - gripper_deg).abs() <= TURNED_DEG
            && (self.aim.is_none() || self.ends_at(status))
    }
}

/// Where the tool is by a status.
#[must_use]
pub fn position(status: &Status) -> Position {
    Position::new(status.x_mm.into(), status.y_mm.into(), status.z_mm.into())
}

pub(crate) fn seconds(seconds: f64) -> Duration {
    Duration::try_from_secs_f64(seconds).unwrap_or(FOR_EVER)
}

/// As near as this counts as arrived: a status agrees with the target to 0.01 mm on a stock arm.
pub(crate) const ARRIVED_MM: f64 = 0.05;
const TURNED_DEG: f64 = 0.05;
/// By then a command is over whose way cannot be foreseen: 700 mm at a quarter of the stock speed.
const UNFORESEEN: Duration = Duration::from_secs(60);
/// Many of them added up still are a duration.
const FOR_EVER: Duration = Duration::from_secs(u32::MAX as u64);
