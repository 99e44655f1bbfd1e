//! The journal of jobs, which survives crashes and power cuts.
//!
//! A job is a drawing or a program: commands for the arm, and their outcome. The protocol has no
//! acknowledgement, so the journal records what *may* have been done before it is done: no command
//! may be sent before [`Journal::extend_window`] has put it into the job's [`Window`] on the disk.
//! After a crash the commands of the window are in doubt, and [`locate`] finds out by where the arm
//! rests which of them were done. [`window_end`] makes that possible: no two commands of a window
//! end at the same position.
//!
//! ```
//! use dobot_api::{JobKind, JobProgram, JobState};
//! use dobot_journal::{Journal, PlannedJob, Window};
//! use dobot_wire::{Configuration, Dialect};
//!
//! let journal = Journal::in_memory()?;
//! let id = journal.submit(&PlannedJob {
//!     title: "a line".into(),
//!     kind: JobKind::Drawing,
//!     calibration: dobot_arm::Calibration::NONE,
//!     dialect: Dialect::FIRMWARE_1_1,
//!     lift_mm: None,
//!     created_ms: 1_700_000_000_000,
//!     planned_s: None,
//!     commands: vec![Configuration::Writing { acceleration_mm_s2: 100.0 }.into()],
//!     pauses: Vec::new(),
//!     program: JobProgram::default(),
//!     key: None,
//! })?;
//!
//! journal.set_state(id, &JobState::Running)?;
//! let first = Window { completed: 0, upto: 1, start: None };
//! journal.extend_window(id, &first)?;
//! // From here on the command may be sent; a program that is started after a crash finds:
//! assert_eq!(journal.progress(id)?, first);
//! # Ok::<(), dobot_journal::JournalError>(())
//! ```

mod adjustment;
mod ends;
#[cfg(feature = "store")]
mod error;
mod job;
#[cfg(feature = "store")]
mod journal;
#[cfg(feature = "store")]
mod new_rows;
#[cfg(feature = "store")]
mod offers;
mod prelude;
mod recovery;
#[cfg(feature = "store")]
mod rows;
#[cfg(feature = "store")]
mod store;
mod window;
#[cfg(feature = "store")]
mod write_count;

pub use adjustment::{Adjustment, HeightChange};
pub use ends::{End, Located, SPACING_MM};
#[cfg(feature = "store")]
pub use error::JournalError;
pub use job::{Job, JobExtension, JobHistory, JobId, PlannedJob};
#[cfg(feature = "store")]
pub use journal::Journal;
#[cfg(feature = "store")]
pub use offers::Offered;
pub use prelude::{model_at, prelude};
pub use recovery::{NEAR_MM, Unclear, locate, window_end};
#[cfg(feature = "store")]
pub use redb::StorageBackend;
pub use window::Window;
