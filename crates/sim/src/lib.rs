//! Virtual Dobot Arms: in this process, on a virtual serial port and on TCP.
//!
//! [`VirtualArm`] is a controller on a serial line, an engine without a clock. [`InProcess`] runs it
//! for a client in this process, in virtual time or paced; [`Server`] runs it for other programs, in
//! real time or faster.
//!
//! This crate is enough to begin with: [`connect`] gives a virtual arm, and the crates that it is made
//! of are [`controller`], [`session`] and [`wire`].
//!
//! ```
//! use dobot_sim::controller::Personality;
//!
//! # #[tokio::main(flavor = "current_thread")]
//! # async fn main() -> Result<(), dobot_sim::session::LinkError> {
//! let mut arm = dobot_sim::connect(Personality::Specification);
//! assert_eq!(arm.next_status().await?.rear_deg, 45.0);
//! # Ok(())
//! # }
//! ```
//!
//! The feature `world`, on by default, adds paper, objects and a laser that burns.

mod faults;
mod in_process;
mod mechanics;
mod plot;
#[cfg(unix)]
mod pty;
mod script;
mod serial_line;
mod serve;
mod simulate;
mod speed;
mod trace;
mod virtual_arm;
#[cfg(feature = "world")]
pub mod world;

pub use dobot_controller as controller;
pub use dobot_session as session;
pub use dobot_wire as wire;
pub use faults::{Fault, FaultEffect, FaultError, Struck};
pub use in_process::{InProcess, connect};
pub use mechanics::{Joint, Mechanics};
pub use plot::{Plot, Snapshot};
#[cfg(unix)]
pub use pty::{Pty, PtyClient};
pub use script::{Script, ScriptError, ScriptLine, ScriptProblem, Start};
pub use serial_line::SerialLine;
pub use serve::{DEFAULT_TCP, DEFAULT_WORLD, RECORDING_PERIOD, Server, ServerEvent};
pub use simulate::{SimulateError, Simulation, simulate, simulate_watched};
pub use speed::{Speed, SpeedError};
pub use trace::{Comparison, Deviation, Trace, TraceError, TracedStatus, TracedTick};
pub use virtual_arm::{Sample, VirtualArm};
