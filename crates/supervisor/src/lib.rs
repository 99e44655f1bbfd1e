//! The rules for people and arm, as an engine: leases, stop, interlock, trust, jogging and jobs.
//!
//! Every command to an arm passes the [`Supervisor`]. Events go in through `handle_*`, outputs come
//! out through `poll_*`, and time is an argument. The engine needs no runtime, file or clock, as
//! this crate's dependencies show. `dobot-host` drives it with a port and a journal, or in virtual
//! time.
//!
//! ```
//! use dobot_safety::Policy;
//! use dobot_supervisor::Supervisor;
//!
//! let supervisor = Supervisor::new(Policy::default(), None);
//! assert!(supervisor.state().arm.is_none());
//! ```

mod refusal;
mod supervisor;
mod text;

pub use refusal::{Holder, Refusal};
pub use supervisor::{
    Effect, FORGETTABLE, JobPlan, SavedFleetStop, StartedJob, StoppedBy, Supervisor,
    cause_of_silence, draws_below_mm,
};
pub use text::{is_plain, plain};
