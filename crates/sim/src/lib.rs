//! Virtual Dobot Arms: in this process, on a virtual serial port and on TCP.
//!
//! [`VirtualArm`] is a controller on a serial line, an engine without a clock. [`InProcess`] runs it
//! for a client in this process, in virtual time or paced; [`Server`] runs it for other programs, in
//! real time or faster.
//!
//! ```
//! use dobot_session::Connection;
//! use dobot_controller::{Controller, PowerUp};
//! use dobot_sim::{InProcess, SerialLine, VirtualArm};
//! use dobot_wire::Dialect;
//!
//! # #[tokio::main(flavor = "current_thread")]
//! # async fn main() -> Result<(), dobot_session::LinkError> {
//! let arm = VirtualArm::new(Controller::power_up(PowerUp::default()), SerialLine::STOCK);
//! let mut connection = Connection::over_peer(InProcess::new(arm), Some(Dialect::SPECIFICATION));
//! assert_eq!(connection.next_status().await?.rear_deg, 45.0);
//! # Ok(())
//! # }
//! ```

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
pub mod world;

pub use faults::{Fault, FaultEffect, FaultError, Struck};
pub use in_process::InProcess;
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
