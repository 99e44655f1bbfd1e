//! The calculation time of a tick (note N39), during which the receive buffer is not searched and the
//! status of the tick waits.

use core::time::Duration;

/// The calculation in a tick.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Work {
    /// Only the pose from the angles: no motion, a pause or a button.
    Idle,
    /// An increment of one joint.
    JointJog,
    /// An increment of a coordinate, and both kinematics.
    LinearJog,
    /// The first tick of a MOVJ, with its planning.
    PlanMovj,
    /// An increment of all joints, of a MOVJ or within a phase of a JUMP.
    Movj,
    /// An increment of a line, and both kinematics.
    Movl,
    /// A tick of a JUMP in which a phase starts, including the first.
    JumpPhase,
    /// The first tick of a vector, with its planning.
    PlanWrite,
    /// An increment of a vector, and both kinematics.
    Write,
    /// An increment of a line ordered by voice.
    Voice,
    /// The first tick of a mouse packet: sums, target and both kinematics.
    PlanMouse,
    /// The first tick of a gesture, or of state 15.
    PlanGesture,
    /// An increment of a mouse, a gesture or state 15.
    Follow,
}

impl Work {
    /// The calculation time. One-off calculations use the maximum measured on the stock controller
    /// (note N39). Repeated ones usually take less; they use the time that loses as many packets
    /// without a gap as the stock controller did.
    #[expect(clippy::match_same_arms, reason = "a table with one line per kind")]
    pub(crate) const fn time(self) -> Duration {
        Duration::from_micros(match self {
            Self::Idle => 980,
            // 2400 to 2750.
            Self::JointJog => 2600,
            // 3700 to 4600; of packets without a gap 15 % are lost.
            Self::LinearJog => 4100,
            Self::PlanMovj => 5700,
            // 2600 to 3200; 8 % are lost. Following moves all joints likewise.
            Self::Movj | Self::Follow => 2700,
            // 4000 to 4900; 15 % are lost. Voice was not measured: it is a line.
            Self::Movl | Self::Voice => 4100,
            Self::JumpPhase => 7000,
            Self::PlanWrite => 5400,
            // 3800 to 5400; 15 % are lost.
            Self::Write => 4100,
            Self::PlanMouse => 5200,
            Self::PlanGesture => 5400,
        })
    }
}
