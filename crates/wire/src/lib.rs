//! The packets of the original Dobot Arm: bytes, frames, commands and statuses.
//!
//! Every packet is 42 bytes long. A [`Frame`] holds any ten floats; a [`Command`] or a [`Status`]
//! only what makes sense. A [`Dialect`] defines how to read the fields on which the published document
//! and the stock firmware disagree. A [`Decoder`] finds the packets in a stream of bytes.
//!
//! Numbers are the packet's own `f32`, with the unit in the name of the field. Tables and figures
//! are those of the published protocol; notes (N1, N2 ...) stand in `docs/protocol.md`.
//!
//! No I/O, no clock, no heap.
//!
//! ```
//! use dobot_wire::{Command, Decoder, Dialect, MoveTo, Packet};
//!
//! let command = Command::from(MoveTo { rotation_deg: 15.0, ..MoveTo::to(200.0, -50.0, 20.0) });
//! let bytes = command.emit(&Dialect::SPECIFICATION).to_bytes();
//!
//! let mut decoder = Decoder::commands();
//! let packets: Vec<Packet> = decoder.feed(&bytes).collect();
//! assert_eq!(Command::parse(&packets[0], &Dialect::SPECIFICATION), Ok(command));
//!
//! // An invalid value is refused with its table.
//! let Packet::Frame(frame) = packets[0] else { unreachable!() };
//! let error = MoveTo::parse(&frame.with(8, 3.0), &Dialect::SPECIFICATION).unwrap_err();
//! assert_eq!(
//!     error.to_string(),
//!     "float 8 (MovingMode) is 3; Table 3.7 allows 0 (jump), 1 (linear) or 2 (joint)"
//! );
//! ```

#![no_std]

#[cfg(feature = "alloc")]
extern crate alloc;

mod adjustment;
mod command;
mod configuration;
mod decoder;
mod dialect;
mod direction;
mod error;
#[cfg(feature = "alloc")]
mod finding;
mod frame;
mod gesture;
mod jog;
mod joint_jog;
mod leniency;
mod linear_jog;
mod mouse;
mod move_joints;
mod move_to;
mod moving_mode;
mod packet;
mod single;
mod status;
mod table;
mod timing;
mod voice;
mod voice_order;
mod write_vector;

pub use adjustment::PlaybackAdjustment;
pub use command::Command;
pub use configuration::{Configuration, EndEffector};
pub use decoder::{Counts, Decoder, Packets};
pub use dialect::{Dialect, UnknownDialect};
pub use direction::{Commands, Direction, Statuses};
pub use error::ParseError;
#[cfg(feature = "alloc")]
pub use finding::{Evidence, Finding};
pub use frame::{Frame, HEADER, PACKET_LEN, TAIL};
pub use gesture::Gesture;
pub use joint_jog::{JointJog, JointJogAxis};
pub use leniency::{Instead, Leniency};
pub use linear_jog::{LinearJog, LinearJogAxis};
pub use mouse::MouseMove;
pub use move_joints::MoveJoints;
pub use move_to::MoveTo;
pub use moving_mode::MovingMode;
pub use packet::Packet;
pub use single::single;
pub use status::Status;
pub use timing::{LINE_TIME, PACKET_GAP};
pub use voice::{VOICE_HEADER, VOICE_TAIL, Voice};
pub use voice_order::VoiceOrder;
pub use write_vector::{WriteMode, WriteVector};
