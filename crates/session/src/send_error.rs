//! Why a command is not sent.

use dobot_motion::TrajectoryError;
use dobot_wire::{Command, ParseError, VoiceOrder};

/// Why a command is not sent.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SendError {
    /// The arm's dialect is not known and the command means different things in them (note N1).
    #[error("{field} depends on the dialect of the arm, which is not known")]
    Undecided {
        /// The field in question.
        field: &'static str,
    },
    /// The arm is already at the target, and a straight line of length 0 makes it lose its pose.
    #[error(
        "the arm is there already, and a straight line of length 0 would make it lose its pose (note N34)"
    )]
    OnTheSpot,
    /// The arm was reset or its pose was never confirmed, so the reported pose may be wrong.
    #[error("the reported pose may be wrong; look at the arm and confirm its pose before it moves")]
    Untrusted,
    /// The command burns, and the laser is not armed.
    #[error("the laser is disarmed; put on goggles, then arm it (`Connection::arm_laser`)")]
    LaserDisarmed,
    /// A stock arm would hang or move forever (notes N48 and N51).
    #[error("{0}")]
    Trap(TrajectoryError),
    /// A stock arm would understand other numbers than the words mean.
    #[error(
        "a stock arm misunderstands numbers, such as 22 for sixteen (note N50); send the motion or the button instead of the words"
    )]
    Misheard,
    /// A value is outside the range in its table.
    #[error("the command is not allowed: {0}")]
    Invalid(ParseError),
}

/// Whether a command makes the arm move. Releases, switches and configuration do not.
pub(crate) fn moves(command: &Command) -> bool {
    match command {
        Command::MoveTo(_)
        | Command::MoveJoints(_)
        | Command::MouseMove(_)
        | Command::Gesture(_) => true,
        Command::WriteVector(vector) => !vector.stop,
        Command::Voice(voice) => !matches!(
            VoiceOrder::parse(voice),
            Some(VoiceOrder::Catch | VoiceOrder::Release)
        ),
        Command::JointJog(jog) => jog.axis.moves(),
        Command::LinearJog(jog) => jog.axis.moves(),
        Command::Configuration(_) | Command::PlaybackAdjustment(_) => false,
    }
}
