//! The trajectory of a command.

use dobot_arm::{Position, TICK_S, Tool, Unreachable};

use super::error::{LONGEST_S, MAX_COUNTED_S};
use super::left_speed::LeftSpeed;
use super::motion::Motion;
use crate::{ArmPlace, JogTrajectory, Model, TrajectoryError};

/// The trajectory of a command as a pure function of the time since its start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trajectory {
    pub(crate) motion: Motion,
    pub(crate) from: ArmPlace,
    pub(crate) tool: Tool,
    /// The best known end.
    pub(crate) to: ArmPlace,
    pub(crate) pause_s: f64,
    pub(crate) burns: bool,
    /// Whether it begins at the model's position and follows the plan.
    pub(crate) is_exact: bool,
    /// Whether the end is certain.
    pub(crate) knows_end: bool,
    /// The speed that a vector leaves for the next one.
    pub(crate) left: Option<LeftSpeed>,
    /// The ticks of a vector, if the arm counts them.
    pub(crate) ticks: Option<Ticks>,
}

/// The number of ticks that a stock arm counts for a vector (note N48).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ticks {
    /// With the speed that the vector before is assumed to have left.
    pub(crate) believed: i16,
    /// The maximum over all possible speeds.
    pub(crate) most: i16,
}

impl Trajectory {
    /// Creates a trajectory from the arm's position.
    pub(crate) fn moving(motion: Motion, to: ArmPlace, model: &Model) -> Self {
        Self {
            motion,
            from: model.place,
            tool: model.tool,
            to,
            pause_s: 0.0,
            burns: model.laser && motion != Motion::Rest,
            is_exact: model.knows_place,
            knows_end: model.knows_place,
            left: None,
            ticks: None,
        }
    }

    /// Creates a trajectory relative to any position of the arm.
    pub(crate) fn relative(motion: Motion, model: &Model) -> Result<Self, TrajectoryError> {
        let to = motion
            .place_at(f64::MAX, model.tool)
            .unwrap_or(Ok(model.place));
        Ok(match to {
            Ok(to) => Self::moving(motion, to, model),
            Err(error) => {
                // The end is outside the workspace; report where the path leaves the limits
                // instead.
                Self::moving(motion, model.place, model).check()?;
                return Err(error.into());
            }
        })
    }

    /// Returns the duration of motion and pause, in seconds; `None` for a jog.
    #[must_use]
    pub fn duration_s(&self) -> Option<f64> {
        self.lasts_s().map(|motion_s| motion_s + self.pause_s)
    }

    /// Returns the duration of the motion without counting ticks, in seconds; `None` for a jog.
    #[must_use]
    pub const fn motion_s(&self) -> Option<f64> {
        self.motion.duration_s()
    }

    /// Returns how long the arm takes for the motion, in seconds; `None` for a jog. A stock arm
    /// counts a vector in whole ticks, which takes longer at low speed: a vector without an
    /// accelerating tick keeps the speed left by the one before (note N48).
    #[must_use]
    pub fn lasts_s(&self) -> Option<f64> {
        self.in_ticks(|ticks| ticks.believed)
    }

    /// Returns the maximum of that time if the speed left by the vector before is unknown, in
    /// seconds.
    #[must_use]
    pub fn lasts_at_most_s(&self) -> Option<f64> {
        self.in_ticks(|ticks| ticks.most)
    }

    fn in_ticks(&self, ticks: fn(Ticks) -> i16) -> Option<f64> {
        let counted = self.ticks.map(|counted| f64::from(ticks(counted)) * TICK_S);
        counted.or(self.motion_s())
    }

    /// Returns the arm's pause after the motion, in seconds.
    #[must_use]
    pub const fn pause_s(&self) -> f64 {
        self.pause_s
    }

    /// Returns the position at a time since the start of the command: the start before 0, the end
    /// after the motion. Limits are not checked; use [`Trajectory::check`].
    ///
    /// # Errors
    ///
    /// [`Unreachable`] if the position is outside the arm's workspace.
    pub fn place_at(&self, t_s: f64) -> Result<ArmPlace, Unreachable> {
        self.motion
            .place_at(t_s, self.tool)
            .unwrap_or(Ok(self.from))
    }

    /// Returns the end of the command. `None` if it is uncertain: for a jog and its release, for a
    /// step from an unknown position, and if rounding decides when a stock arm ends a gesture (note
    /// N49). [`Trajectory::place_at`] the end is the best guess then.
    #[must_use]
    pub fn end(&self) -> Option<ArmPlace> {
        self.knows_end.then_some(self.to)
    }

    /// Whether the path is known rather than guessed: it begins at a known position.
    #[must_use]
    pub const fn is_exact(&self) -> bool {
        self.is_exact
    }

    /// Returns start and end if they are known and the path is a straight line.
    #[must_use]
    pub const fn line(&self) -> Option<(Position, Position)> {
        match self.motion {
            Motion::Line(..) | Motion::Stroke { .. } if self.is_exact && self.knows_end => {
                Some((self.from.pose.position, self.to.pose.position))
            }
            _ => None,
        }
    }

    /// Returns points for drawing the path, each with its time in seconds since the start of the
    /// command: for a vector its end, for any other motion sixteen points at equal time steps
    /// including the end. Jogs and motions without movement have none; positions outside the
    /// workspace are skipped.
    pub fn corners(&self) -> impl Iterator<Item = (ArmPlace, f64)> + use<'_> {
        let duration_s = self.motion_s().unwrap_or_default();
        let parts = match self.motion {
            _ if !self.moves() || self.motion_s().is_none() => 0,
            Motion::Stroke { .. } => 1,
            _ => CORNERS,
        };
        (1..=parts).filter_map(move |part| {
            let after_s = duration_s * f64::from(part) / f64::from(parts);
            Some((self.place_at(after_s).ok()?, after_s))
        })
    }

    /// Whether anything moves.
    #[must_use]
    pub fn moves(&self) -> bool {
        self.motion_s() != Some(0.0)
    }

    /// Whether the laser burns.
    #[must_use]
    pub const fn laser(&self) -> bool {
        self.burns
    }

    /// Returns the jog.
    #[must_use]
    pub const fn jog(&self) -> Option<JogTrajectory> {
        match self.motion {
            Motion::Jog(jog) => Some(jog),
            _ => None,
        }
    }

    /// Checks that the motion takes no longer than [`LONGEST_S`].
    pub(crate) fn check_duration(&self) -> Result<(), TrajectoryError> {
        match self.motion_s() {
            Some(found) if found > LONGEST_S => Err(TrajectoryError::TooSlow { found }),
            _ => Ok(()),
        }
    }

    /// Checks that a stock arm can count the ticks of motion and pause in 16 bits.
    pub(crate) fn check_counters(&self) -> Result<(), TrajectoryError> {
        let motion_s = self.motion_s().unwrap_or(0.0);
        let found = if motion_s > MAX_COUNTED_S {
            motion_s
        } else {
            self.pause_s
        };
        if found > MAX_COUNTED_S {
            return Err(TrajectoryError::Uncounted { found });
        }
        Ok(())
    }

    /// Checks that the whole path stays within the limits of a stock arm (note N30) and takes no
    /// longer than [`LONGEST_S`]. An arm outside the limits may come back inside. A jog is not
    /// checked along its path, because it has no end.
    ///
    /// # Errors
    ///
    /// [`TrajectoryError::TooSlow`], or [`TrajectoryError::Unreachable`] with the first limit
    /// exceeded.
    pub fn check(&self) -> Result<(), TrajectoryError> {
        let Some(duration_s) = self.motion_s() else {
            return Ok(());
        };
        self.check_duration()?;
        let samples = libm::ceil(duration_s / SAMPLING_S).max(1.0);
        let mut inside = self.from.check().is_ok();
        let mut index = 0.0;
        while index <= samples {
            let t_s = duration_s * (index / samples);
            match self
                .motion
                .place_at(t_s, self.tool)
                .map(|result| result.and_then(|place| place.check()))
            {
                Some(Ok(())) => inside = true,
                Some(Err(error)) if inside || index == samples => return Err(error.into()),
                Some(Err(_)) | None => {}
            }
            index += 1.0;
        }
        Ok(())
    }
}

/// The number of equal time steps with which a possible jump is drawn.
const CORNERS: u32 = 16;
/// The interval of limit checks on a path: one control tick.
const SAMPLING_S: f64 = 0.02;
