//! Checks a controller at the other end of a link, real or virtual, against the protocol.
//!
//! [`Suite`] runs all checks of [`Check::ALL`] with small motions and reports which of them hold, what
//! differs, and the dialect of the controller. It uses only bytes and their times, so it runs over a
//! serial port or TCP in real time, and over a peer in this process in virtual time.
//!
//! ```
//! use dobot_session::Link;
//! use dobot_conformance::{Options, Suite, Verdict};
//! use dobot_controller::{Controller, PowerUp};
//! use dobot_sim::{InProcess, SerialLine, VirtualArm};
//!
//! # #[tokio::main(flavor = "current_thread")]
//! # async fn main() {
//! let arm = VirtualArm::new(Controller::power_up(PowerUp::default()), SerialLine::STOCK);
//! let link = Link::over_peer(InProcess::new(arm));
//! let report = Suite::new(link, Options::default()).run(|row| println!("{row}")).await;
//! assert_eq!(report.verdict(), Verdict::Specification);
//! assert!(report.conforms());
//! # }
//! ```

mod blocker;
mod check;
mod checks;
mod flow;
mod latency;
mod observed_motion;
mod outcome;
mod packet;
mod report;
mod rig;
mod suite;
mod timed_status;

pub use blocker::Blocker;
pub use check::Check;
pub use latency::Latency;
pub use outcome::Outcome;
pub use report::{HEADING, Report, Row, Verdict};
pub use suite::{Options, Suite};
