//! The current motion.

use core::time::Duration;

use dobot_arm::Unreachable;
use dobot_motion::{ArmPlace, JogTrajectory, Trajectory};
use dobot_wire::Command;

/// The current motion.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Running {
    pub(crate) motion: Motion,
    pub(crate) began: Duration,
    /// The end time; none for a jog whose button is held.
    pub(crate) ends: Duration,
    /// The cached pose of a jog at the next tick.
    pub(crate) ahead: Option<(Duration, ArmPlace)>,
}

/// The motion of a command, a jog, or the pause after a motion.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Motion {
    Trajectory(Command, Trajectory),
    Jog(JogTrajectory),
    Pause,
}

impl Running {
    /// The pose at a time; `None` while the arm stands.
    pub(crate) fn place_at(&self, at: Duration) -> Option<Result<ArmPlace, Unreachable>> {
        if let Some((_, place)) = self.ahead.filter(|(when, _)| *when == at) {
            return Some(Ok(place));
        }
        let t_s = at.saturating_sub(self.began).as_secs_f64();
        match &self.motion {
            Motion::Trajectory(_, trajectory) => Some(trajectory.place_at(t_s)),
            Motion::Jog(jog) => Some(jog.place_at(t_s)),
            Motion::Pause => None,
        }
    }
}
