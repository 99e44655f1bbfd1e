//! The controller of the original Dobot Arm as an engine: bytes in, bytes out, time is an argument.
//!
//! ```
//! use core::time::Duration;
//! use dobot_controller::{Controller, PowerUp};
//! use dobot_wire::{Frame, Status};
//!
//! let mut controller = Controller::power_up(PowerUp::default());
//! controller.handle_time(Duration::from_millis(60));
//! let upload = controller.poll_bytes().expect("the first status is due 60 ms after power-up");
//! let frame = Frame::from_bytes(&upload.bytes).expect("a status is a frame");
//! assert_eq!(Status::parse(&frame)?.rear_deg, 45.0);
//! # Ok::<(), dobot_wire::ParseError>(())
//! ```

#![no_std]

mod controller;
mod firmware;
mod log;
mod outputs;
mod power_up;
mod refused;
mod specification;
mod upload;

pub use controller::Controller;
pub use log::Counters;
pub use outputs::{Outputs, STEPS_PER_DEG};
pub use power_up::{Personality, Port, PowerUp, UnknownPersonality};
pub use refused::{Hang, Refused};
pub use upload::Upload;
