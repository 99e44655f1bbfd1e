//! How long a tick calculates (note N39): meanwhile nobody looks at the receive buffer, and the
//! status of the tick waits.

use core::time::Duration;

/// What the processor has to calculate in a tick.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Work {
    /// Only the pose from the angles: nothing moves, a pause passes, a button acts.
    Idle,
    /// An increment of one joint.
    JointJog,
    /// An increment of a coordinate, and both kinematics.
    LinearJog,
    /// The first tick of a MOVJ, in which it is planned.
    PlanMovj,
    /// An increment of all joints, of a MOVJ or within a phase of a JUMP.
    Movj,
    /// An increment of a line, and both kinematics.
    Movl,
    /// A tick of a JUMP in which a phase begins; the first one, too.
    JumpPhase,
    /// The first tick of a vector, in which it is planned.
    PlanWrite,
    /// An increment of a vector, and both kinematics.
    Write,
    /// An increment of a line that was ordered by voice.
    Voice,
    /// The first tick of a mouse packet: sums, target and both kinematics.
    PlanMouse,
    /// The first tick of a gesture, or of state 15.
    PlanGesture,
    /// An increment on the way of a mouse, a gesture or state 15.
    Follow,
}

impl Work {
    /// How long it takes. The most that was measured on the stock controller (note N39) stands for
    /// what is done once; what is done again and again takes less than that as a rule, and stands
    /// here with what loses as many packets without a gap as the stock controller was seen to lose.
    #[expect(clippy::match_same_arms, reason = "a table, a line for each kind")]
    pub(crate) const fn time(self) -> Duration {
        Duration::from_micros(match self {
            Self::Idle => 980,
            // 2400 to 2750.
            Self::JointJog => 2600,
            // 3700 to 4600; of packets without a gap 15 % are lost.
            Self::LinearJog => 4100,
            Self::PlanMovj => 5700,
            // 2600 to 3200; 8 % are lost. What follows moves all joints likewise.
            Self::Movj | Self::Follow => 2700,
            // 4000 to 4900; 15 % are lost. That of voice was not measured: it is a line.
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
