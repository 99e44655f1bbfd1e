//! Where a command leads.

use dobot_arm::{Position, TICK_S, Tool, Unreachable};

use super::error::{LONGEST_S, MOST_COUNTED_S};
use super::left_speed::LeftSpeed;
use super::motion::Motion;
use crate::{ArmPlace, JogTrajectory, Model, TrajectoryError};

/// Where a command leads: the whole way, as a pure function of the time since it began.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trajectory {
    pub(crate) motion: Motion,
    pub(crate) from: ArmPlace,
    pub(crate) tool: Tool,
    /// Where the way ends, as well as it can be told.
    pub(crate) to: ArmPlace,
    pub(crate) pause_s: f64,
    pub(crate) burns: bool,
    /// Whether it begins where the model says, and goes as planned.
    pub(crate) is_exact: bool,
    /// Whether it ends where it says.
    pub(crate) knows_end: bool,
    /// What a vector leaves for the next one.
    pub(crate) left: Option<LeftSpeed>,
    /// The ticks of a vector, where an arm counts such.
    pub(crate) ticks: Option<Ticks>,
}

/// How many ticks a stock arm counts of a vector (note N48).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ticks {
    /// With what the vector before is believed to have left.
    pub(crate) believed: i16,
    /// The most, with all that it may have left.
    pub(crate) most: i16,
}

impl Trajectory {
    /// A way of an arm from where it is.
    pub(crate) fn moving(motion: Motion, to: ArmPlace, model: &Model) -> Self {
        Self {
            motion,
            from: model.place,
            tool: model.tool,
            to,
            pause_s: 0.0,
            burns: model.laser && motion != Motion::Still,
            is_exact: model.knows_place,
            knows_end: model.knows_place,
            left: None,
            ticks: None,
        }
    }

    /// A way by so much from wherever the arm is.
    pub(crate) fn relative(motion: Motion, model: &Model) -> Result<Self, TrajectoryError> {
        let to = motion
            .place_at(f64::MAX, model.tool)
            .unwrap_or(Ok(model.place));
        Ok(match to {
            Ok(to) => Self::moving(motion, to, model),
            Err(error) => {
                // The arm cannot be there at all: where the way leaves the limits says more.
                Self::moving(motion, model.place, model).check()?;
                return Err(error.into());
            }
        })
    }

    /// How long motion and pause take, in seconds; `None` for a jog, which goes on until told
    /// otherwise.
    #[must_use]
    pub fn duration_s(&self) -> Option<f64> {
        self.lasts_s().map(|it| it + self.pause_s)
    }

    /// How long the motion takes if no tick is counted, in seconds; `None` for a jog.
    #[must_use]
    pub const fn motion_s(&self) -> Option<f64> {
        self.motion.duration_s()
    }

    /// How long the arm is at the motion, in seconds; `None` for a jog. A stock arm counts a vector in
    /// whole ticks, which take longer where it begins and goes on slowly: a vector for which it counts
    /// no tick that accelerates keeps the speed that the one before left (note N48).
    #[must_use]
    pub fn lasts_s(&self) -> Option<f64> {
        self.in_ticks(|it| it.believed)
    }

    /// The same at the most, where nobody knows what the vector before left, in seconds.
    #[must_use]
    pub fn lasts_at_most_s(&self) -> Option<f64> {
        self.in_ticks(|it| it.most)
    }

    fn in_ticks(&self, ticks: fn(Ticks) -> i16) -> Option<f64> {
        let counted = self.ticks.map(|it| f64::from(ticks(it)) * TICK_S);
        counted.or(self.motion_s())
    }

    /// How long the arm waits behind the motion, in seconds.
    #[must_use]
    pub const fn pause_s(&self) -> f64 {
        self.pause_s
    }

    /// Where the arm is at a time since the command began: before 0 at the start, behind the motion
    /// at the end. Limits are not looked at: [`Trajectory::check`] does that.
    ///
    /// # Errors
    ///
    /// [`Unreachable`] where a way leads through a place in which the arm cannot be at all.
    pub fn place_at(&self, t_s: f64) -> Result<ArmPlace, Unreachable> {
        self.motion
            .place_at(t_s, self.tool)
            .unwrap_or(Ok(self.from))
    }

    /// Where the command ends. `None` where that cannot be told: of a jog and its release, of a step
    /// from a place that is not known itself, and where rounding decides when a stock arm ends a
    /// gesture (note N49); [`Trajectory::place_at`] the end is the best guess then.
    #[must_use]
    pub fn end(&self) -> Option<ArmPlace> {
        self.knows_end.then_some(self.to)
    }

    /// Whether the way is known, not only guessed: it begins where the arm is known to stand.
    #[must_use]
    pub const fn is_exact(&self) -> bool {
        self.is_exact
    }

    /// From where to where it goes, if that is known and its way is a straight line.
    #[must_use]
    pub const fn line(&self) -> Option<(Position, Position)> {
        match self.motion {
            Motion::Line(..) | Motion::Stroke { .. } if self.is_exact && self.knows_end => {
                Some((self.from.pose.position, self.to.pose.position))
            }
            _ => None,
        }
    }

    /// Places by which the way can be drawn, each with when it is reached, in seconds since the command began: of a
    /// vector its end, of any other motion sixteen places of equal time, the last of them its end. There are none of a
    /// jog, nor where nothing moves, and those are left out where the arm cannot be at all.
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

    /// Whether something moves on the way.
    #[must_use]
    pub fn moves(&self) -> bool {
        self.motion_s() != Some(0.0)
    }

    /// Whether the laser burns on the way.
    #[must_use]
    pub const fn laser(&self) -> bool {
        self.burns
    }

    /// The jog that it is.
    #[must_use]
    pub const fn jog(&self) -> Option<JogTrajectory> {
        match self.motion {
            Motion::Jog(jog) => Some(jog),
            _ => None,
        }
    }

    /// Whether the motion takes no longer than [`LONGEST_S`].
    pub(crate) fn check_duration(&self) -> Result<(), TrajectoryError> {
        match self.motion_s() {
            Some(found) if found > LONGEST_S => Err(TrajectoryError::TooSlow { found }),
            _ => Ok(()),
        }
    }

    /// Whether a stock arm can count the ticks of motion and pause: it does so in 16 bits.
    pub(crate) fn check_counters(&self) -> Result<(), TrajectoryError> {
        let motion_s = self.motion_s().unwrap_or(0.0);
        let found = if motion_s > MOST_COUNTED_S {
            motion_s
        } else {
            self.pause_s
        };
        if found > MOST_COUNTED_S {
            return Err(TrajectoryError::Uncounted { found });
        }
        Ok(())
    }

    /// Whether the whole way stays within the limits of a stock arm (note N30) and takes no longer
    /// than [`LONGEST_S`]. An arm that stands outside of the limits may come back in. A jog is not
    /// looked along: it has no end.
    ///
    /// # Errors
    ///
    /// [`TrajectoryError::TooSlow`], or [`TrajectoryError::Unreachable`] with the first limit on the way.
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
                .map(|it| it.and_then(|place| place.check()))
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

/// In how many parts of equal time a way is drawn that may be a jump.
const CORNERS: u32 = 16;
/// As often as this a way is checked against the limits: once a control tick.
const SAMPLING_S: f64 = 0.02;
