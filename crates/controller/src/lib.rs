//! The controller of the original Dobot Arm as an engine: bytes in, bytes out, time is an argument.
//!
//! ```
//! use core::time::Duration;
//! use dobot_controller::{Controller, PowerUp};
//! use dobot_wire::{Frame, Status};
//!
//! let mut controller = Controller::power_up(PowerUp::default());
//! controller.handle_time(Duration::from_millis(60));
//! let bytes = controller.poll_bytes().expect("the first status is due 60 ms after power-up");
//! let frame = Frame::from_bytes(&bytes).expect("a status is a frame");
//! assert_eq!(Status::parse(&frame)?.rear_deg, 45.0);
//! # Ok::<(), dobot_wire::ParseError>(())
//! ```

#![no_std]

mod controller;
mod jog;
mod motion;
mod plan;
mod power_up;
mod refused;
mod settings;
mod state;

pub use controller::{Controller, Counters};
pub use power_up::{Personality, PowerUp};
pub use refused::Refused;
