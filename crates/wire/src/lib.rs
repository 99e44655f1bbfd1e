//! The packets of the original Dobot Arm: bytes, frames, commands and statuses.

#![no_std]

#[cfg(feature = "serde")]
extern crate alloc;

mod adjustment;
mod command;
mod configuration;
mod decoder;
mod dialect;
mod direction;
mod error;
mod frame;
mod gesture;
mod joint_jog;
mod linear_jog;
mod mouse;
mod move_joints;
mod move_to;
mod moving_mode;
mod packet;
mod status;
mod table;
mod voice;
mod write_vector;

pub use adjustment::PlaybackAdjustment;
pub use command::Command;
pub use configuration::{Configuration, EndEffector};
pub use decoder::{Counts, Decoder, Packets};
pub use dialect::{Dialect, UnknownDialect};
pub use direction::{Commands, Direction, Statuses};
pub use error::ParseError;
pub use frame::{Frame, HEADER, PACKET_LEN, TAIL};
pub use gesture::Gesture;
pub use joint_jog::{JointJog, JointJogAxis};
pub use linear_jog::{LinearJog, LinearJogAxis};
pub use mouse::MouseMove;
pub use move_joints::MoveJoints;
pub use move_to::MoveTo;
pub use moving_mode::MovingMode;
pub use packet::Packet;
pub use status::Status;
pub use voice::{VOICE_HEADER, VOICE_TAIL, Voice};
pub use write_vector::{WriteMode, WriteVector};
