//! A session with an original Dobot Arm over a serial port, TCP or in this process.
//!
//! [`Session`] is the engine: one command per status received, resynchronisation, link loss and
//! completion read off the statuses. [`Connection`] is its thin async shell, over a [`Link`] of bytes.
//!
//! ```no_run
//! use dobot_client::Connection;
//! use dobot_wire::{Dialect, MoveTo, MovingMode};
//!
//! # async fn example() -> Result<(), Box<dyn std::error::Error>> {
//! let address = "serial:/dev/ttyUSB0".parse()?;
//! let mut arm = Connection::open(&address, Some(Dialect::FIRMWARE_1_1)).await?;
//! let there = arm.send(MoveTo {
//!     x_mm: 220.0,
//!     y_mm: 0.0,
//!     z_mm: 20.0,
//!     rotation_deg: 0.0,
//!     suction: false,
//!     mode: MovingMode::Jump,
//!     gripper_deg: 0.0,
//!     pause_s: 0.0,
//! })?;
//! arm.completed(there).await?;
//! # Ok(())
//! # }
//! ```

mod address;
mod arm;
mod belief;
pub mod blocking;
mod completion;
mod connection;
mod detection;
mod event;
mod link;
mod open;
mod peer;
mod plan;
mod ports;
mod quality;
mod queue;
mod send_error;
mod session;
mod trust;
mod under_way;

pub use address::{Address, AddressError, DEFAULT_BAUD};
pub use arm::Arm;
pub use connection::{Connection, LinkError};
pub use detection::{Detection, DetectionError, Evidence, Finding};
pub use event::{Disarmed, Event, NotReached};
pub use link::Link;
pub use open::OpenError;
pub use peer::Peer;
pub use plan::position;
pub use ports::{Port, Usb, ports};
pub use quality::LinkQuality;
pub use queue::Queue;
pub use send_error::SendError;
pub use session::{CommandId, Session, plausible};
pub use trust::ResetEvidence;
