//! The commands of a client.

use crate::table::whole_number;
use crate::{
    Configuration, Dialect, Frame, Gesture, JointJog, LinearJog, MouseMove, MoveJoints, MoveTo,
    MovingMode, Packet, ParseError, PlaybackAdjustment, Voice, WriteVector,
};

/// A command from a client (Table 2.2).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(tag = "type", rename_all = "snake_case"))]
pub enum Command {
    /// State 1.
    MouseMove(MouseMove),
    /// State 2.
    JointJog(JointJog),
    /// State 3.
    MoveTo(MoveTo),
    /// State 4.
    WriteVector(WriteVector),
    /// State 5.
    Voice(Voice),
    /// State 6.
    MoveJoints(MoveJoints),
    /// State 7.
    LinearJog(LinearJog),
    /// State 8.
    Gesture(Gesture),
    /// State 9.
    Configuration(Configuration),
    /// State 10.
    PlaybackAdjustment(PlaybackAdjustment),
}

impl Command {
    /// Reads a packet.
    ///
    /// Floats that a command does not use are ignored, whatever they hold (note N6).
    ///
    /// # Errors
    ///
    /// Returns a [`ParseError`] with the field, the value found, the allowed values and the source.
    pub fn parse(packet: &Packet, dialect: &Dialect) -> Result<Self, ParseError> {
        match packet {
            Packet::Frame(frame) => Self::parse_frame(frame, dialect),
            Packet::Voice(voice) => voice.text().map(|_| Self::Voice(*voice)),
        }
    }

    /// Writes the packet; `parse` reads it back unchanged.
    ///
    /// Values that their table does not allow are written as they are; `parse` of the packet
    /// refuses them.
    #[must_use]
    pub fn emit(&self, dialect: &Dialect) -> Packet {
        match self {
            Self::MouseMove(command) => command.emit(dialect).into(),
            Self::JointJog(command) => command.emit(dialect).into(),
            Self::MoveTo(command) => command.emit(dialect).into(),
            Self::WriteVector(command) => command.emit(dialect).into(),
            Self::Voice(command) => (*command).into(),
            Self::MoveJoints(command) => command.emit(dialect).into(),
            Self::LinearJog(command) => command.emit(dialect).into(),
            Self::Gesture(command) => command.emit(dialect).into(),
            Self::Configuration(command) => command.emit(dialect).into(),
            Self::PlaybackAdjustment(command) => command.emit(dialect).into(),
        }
    }

    /// The field whose packet or meaning depends on the dialect for this command, as text
    /// for an error; `None` where all dialects agree (note N1).
    #[must_use]
    pub fn dialect_dependent(&self) -> Option<&'static str> {
        match self {
            Self::MouseMove(_) => Some("floats 3 to 5 (increments) of a mouse move"),
            Self::MoveTo(MoveTo { mode, .. }) | Self::MoveJoints(MoveJoints { mode, .. }) => {
                (*mode != MovingMode::Jump).then_some("float 8 (MovingMode) of a target")
            }
            Self::WriteVector(vector) => write_dependent(vector),
            Self::Gesture(_) => Some("floats 3 to 5 (hand position) of a gesture"),
            Self::Configuration(configuration) => configuration_dependent(configuration),
            Self::PlaybackAdjustment(percent) => (percent.speed_percent
                != percent.acceleration_percent)
                .then_some("floats 3 and 4 (speed and acceleration) of a playback adjustment"),
            Self::JointJog(_) | Self::LinearJog(_) | Self::Voice(_) => None,
        }
    }

    fn parse_frame(frame: &Frame, dialect: &Dialect) -> Result<Self, ParseError> {
        match whole_number(frame.float(1)) {
            Some(1) => MouseMove::parse(frame, dialect).map(Self::MouseMove),
            Some(2) => JointJog::parse(frame, dialect).map(Self::JointJog),
            Some(3) => MoveTo::parse(frame, dialect).map(Self::MoveTo),
            Some(4) => WriteVector::parse(frame, dialect).map(Self::WriteVector),
            Some(5) => Err(ParseError::VoiceAsFloats),
            Some(6) => MoveJoints::parse(frame, dialect).map(Self::MoveJoints),
            Some(7) => LinearJog::parse(frame, dialect).map(Self::LinearJog),
            Some(8) => Gesture::parse(frame, dialect).map(Self::Gesture),
            Some(9) => Configuration::parse(frame, dialect).map(Self::Configuration),
            Some(10) => PlaybackAdjustment::parse(frame, dialect).map(Self::PlaybackAdjustment),
            _ => Err(match frame.big_endian_state() {
                Some(state) => ParseError::BigEndian(state),
                None => ParseError::UnknownState(frame.float(1)),
            }),
        }
    }
}

impl From<MouseMove> for Command {
    fn from(command: MouseMove) -> Self {
        Self::MouseMove(command)
    }
}

impl From<JointJog> for Command {
    fn from(command: JointJog) -> Self {
        Self::JointJog(command)
    }
}

impl From<MoveTo> for Command {
    fn from(command: MoveTo) -> Self {
        Self::MoveTo(command)
    }
}

impl From<WriteVector> for Command {
    fn from(command: WriteVector) -> Self {
        Self::WriteVector(command)
    }
}

impl From<Voice> for Command {
    fn from(command: Voice) -> Self {
        Self::Voice(command)
    }
}

impl From<MoveJoints> for Command {
    fn from(command: MoveJoints) -> Self {
        Self::MoveJoints(command)
    }
}

impl From<LinearJog> for Command {
    fn from(command: LinearJog) -> Self {
        Self::LinearJog(command)
    }
}

impl From<Gesture> for Command {
    fn from(command: Gesture) -> Self {
        Self::Gesture(command)
    }
}

impl From<Configuration> for Command {
    fn from(command: Configuration) -> Self {
        Self::Configuration(command)
    }
}

impl From<PlaybackAdjustment> for Command {
    fn from(command: PlaybackAdjustment) -> Self {
        Self::PlaybackAdjustment(command)
    }
}

/// The start speed is no reason: vectors that follow each other give the same motion (note N5).
fn write_dependent(vector: &WriteVector) -> Option<&'static str> {
    if vector.stop {
        Some("float 6 (stop) of a write vector")
    } else {
        (vector.x_mm != 0.0).then_some("float 3 (X) of a write vector")
    }
}

fn configuration_dependent(configuration: &Configuration) -> Option<&'static str> {
    match *configuration {
        Configuration::Playback {
            default_pause_s, ..
        } if default_pause_s != 0.0 => {
            Some("float 9 (default pause time) of a playback configuration")
        }
        Configuration::InitialAngles { rear_deg, .. }
            if Dialect::FIRMWARE_1_1.initial_rear(rear_deg) != rear_deg =>
        {
            Some("float 3 (joint2 angle) of the initial angles")
        }
        _ => None,
    }
}
