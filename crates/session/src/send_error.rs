//! Why a command is not sent.

use dobot_motion::TrajectoryError;
use dobot_wire::{Command, ParseError, VoiceOrder};

/// Why a command is not sent.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SendError {
    /// The arm's dialect is not known and the command means different things in them (note N1).
    #[error("{field} means different things to different arms, and nobody has said which this is")]
    Undecided {
        /// The field in question.
        field: &'static str,
    },
    /// The arm stands there already, and a straight line of no length makes it lose its pose.
    #[error(
        "the arm is at the target already; a straight line of no length would make it lose its pose (note N34)"
    )]
    OnTheSpot,
    /// The arm was reset, or nobody has looked where it stands: what it says of its pose need not be
    /// true.
    #[error(
        "the arm may not be where it says; look where it stands and confirm its pose before it moves"
    )]
    Untrusted,
    /// The command lights the laser, and nobody has armed it.
    #[error(
        "the laser is disarmed; put the goggles on, then arm it for a while (`Connection::arm_laser`) before it burns"
    )]
    LaserDisarmed,
    /// A stock arm would not come out of it: it would hang, or go on for ever (notes N48 and N51).
    #[error("{0}")]
    Trap(TrajectoryError),
    /// A stock arm would hear other numbers than the words mean.
    #[error(
        "a stock arm hears other numbers than the words mean, such as 22 for sixteen (note N50); send the motion or the button that the words mean"
    )]
    Misheard,
    /// The command breaks a range of its table.
    #[error("the command is not allowed: {0}")]
    Invalid(ParseError),
}

/// Whether a command makes the arm move: a release, a switch and a configuration do not.
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
