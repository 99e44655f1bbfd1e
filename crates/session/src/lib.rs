//! A session with an original Dobot Arm over a serial port, TCP or in this process.
//!
//! [`Session`] is the engine: one command per status received, resynchronisation, link loss and
//! completion read from the statuses. [`Connection`] is its thin async shell over a byte [`Link`].
//!
//! ```no_run
//! use dobot_session::Connection;
//! use dobot_wire::{Dialect, MoveTo};
//!
//! # async fn example() -> Result<(), Box<dyn std::error::Error>> {
//! let address = "serial:/dev/ttyUSB0".parse()?;
//! let mut arm = Connection::open(&address, Some(Dialect::FIRMWARE_1_1)).await?;
//! // ... after a person has checked that the arm stands where it reports:
//! arm.session_mut().confirm_pose();
//! let id = arm.send(MoveTo::to(220.0, 0.0, 20.0))?;
//! arm.completed(id).await?;
//! # Ok(())
//! # }
//! ```

mod address;
#[cfg(feature = "io")]
mod arm;
mod arm_estimate;
#[cfg(feature = "io")]
pub mod blocking;
mod completion;
#[cfg(feature = "io")]
mod connection;
mod detection;
mod event;
mod in_flight;
#[cfg(feature = "io")]
mod link;
mod link_error;
mod no_status;
mod observer;
#[cfg(feature = "io")]
mod open;
mod peer;
mod permit_scheme;
mod plan;
#[cfg(feature = "io")]
mod ports;
mod quality;
mod queue;
mod reset_detector;
mod send_error;
mod session;

pub use address::{Address, AddressError, DEFAULT_BAUD};
#[cfg(feature = "io")]
pub use arm::Arm;
#[cfg(feature = "io")]
pub use connection::Connection;
pub use detection::{Detection, DetectionError};
pub use event::{Disarmed, Event, NotReached};
#[cfg(feature = "io")]
pub use link::Link;
pub use link_error::LinkError;
pub use no_status::{NoStatus, StatusWait};
pub use observer::{Observer, SeenOver};
#[cfg(feature = "io")]
pub use open::OpenError;
#[cfg(all(feature = "io", unix))]
pub use open::check_permission;
pub use peer::Peer;
pub use permit_scheme::{PermitScheme, ReceivedStatus, plausible};
pub use plan::position;
#[cfg(feature = "io")]
pub use ports::{Port, Usb, ports};
pub use quality::LinkQuality;
pub use queue::Queue;
pub use reset_detector::ResetEvidence;
pub use send_error::SendError;
pub use session::{CommandId, Session};
