//! Recordings of everything on the wire, as MCAP files, and their replay.
//!
//! [`Recorder`] writes in its own thread; a truncated file stays readable, and the next start
//! repairs it. [`Live`] makes the same messages for live viewers, [`Recording`] reads, and
//! [`Replay`] is a virtual arm that plays a recording back. The files open in Foxglove, with the
//! arm, its target and its ink in the 3D panel and everything else to plot.
//!
//! ```
//! use std::time::Duration;
//!
//! use dobot_record::{About, Entry, Limits, Record, Recorder, Recording, recordings};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let folder = tempfile::tempdir()?;
//! let start = "2026-11-21T12:30:00Z".parse()?;
//! let recorder = Recorder::start(folder.path(), Limits::DEFAULT, About::default(), start)?;
//! recorder.record(Duration::from_secs(1), Record::ToArm(vec![0xA5, 0x5A]));
//! assert_eq!(recorder.finish().lost, 0);
//!
//! let file = &recordings(folder.path())?[0].path;
//! assert!(file.ends_with("dobot-2026-11-21T12-30-01Z.mcap"));
//! let entries: Vec<_> = Recording::open(file)?.collect();
//! assert_eq!(entries[0].at, Duration::from_secs(1));
//! assert_eq!(entries[0].entry, Entry::ToArm(vec![0xA5, 0x5A]));
//! # Ok(())
//! # }
//! ```

mod about;
mod chunk;
mod encoder;
mod file_writer;
mod folder;
mod frames;
mod ink;
mod limits;
mod live;
mod moment;
mod playback;
#[cfg(feature = "protobuf")]
mod protobuf;
mod record;
mod recorder;
mod recording;
mod records;
mod repair;
mod repairs;
mod repeats;
mod replay;
mod rotation;
mod scene;
mod schema;
#[cfg(feature = "tables")]
pub mod tables;
mod target;
mod topic;
mod track;

pub use about::About;
pub use encoder::{Message, meaning};
pub use folder::{RecordedFile, is_being_written, recordings};
pub use limits::{Limits, StartError};
pub use live::Live;
pub use moment::{Damage, Entry, Moment};
#[cfg(feature = "protobuf")]
pub use protobuf::copy_as_protobuf;
pub use record::Record;
pub use recorder::{Health, Recorder};
pub use recording::{OpenError, Recording};
pub use repair::{RepairError, copy, repair};
pub use replay::{Difference, Replay, Report};
pub use schema::topics;
pub use topic::{
    FROM_ARM, INK, JOINTS, POSE, RECORDER, TARGET, TO_ARM, TRANSFORMS, Topic, TopicError,
};
pub use track::{Sample, Track};
