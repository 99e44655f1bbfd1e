//! Runs the supervisor of an arm: port, finder, watchdog process, journal thread, recordings and
//! clients.
//!
//! A [`StationClient`] sends requests to a supervisor, wherever it runs: in a station, in this
//! process for an arm at an address, or in virtual time. Within a station, tasks use a
//! [`StationHandle`], which leads to the task that owns the port. A [`VirtualStation`] runs a
//! supervisor in virtual time, with a virtual arm:
//!
//! ```
//! use std::time::Duration;
//! use dobot_api::Request;
//! use dobot_controller::{Personality, PowerUp};
//! use dobot_host::VirtualStation;
//! use dobot_safety::Policy;
//! use dobot_wire::{MoveTo, MovingMode};
//!
//! let mut station = VirtualStation::new(PowerUp::new(Personality::Firmware11), Policy::default());
//! station.run_for(Duration::from_secs(1));
//! let anna = station.client("Anna");
//!
//! let command = MoveTo {
//!     x_mm: 220.0, y_mm: 0.0, z_mm: -90.0, rotation_deg: 0.0, suction: false,
//!     mode: MovingMode::Jump, gripper_deg: 0.0, pause_s: 0.0,
//! };
//! let into_the_table = Request::Command { command: command.into() };
//! assert_eq!(station.ask(anna, into_the_table.clone()).unwrap_err().kind(), "no-lease");
//!
//! station.ask(anna, Request::TakeLease)?;
//! let refused = station.ask(anna, into_the_table).unwrap_err();
//! assert!(refused.to_string().starts_with("z would be -90 mm; table allows -63 mm and more"));
//! # Ok::<(), dobot_supervisor::Refusal>(())
//! ```

mod arm_thread;
mod background;
mod client;
mod connect;
mod data_format;
mod disk;
mod drawing_job;
mod driver;
mod dry_run;
mod finder;
mod handle;
mod host;
mod job_path;
mod jobs;
mod known_arms;
mod long_work;
mod planned_for;
mod prepared_arm;
mod priority;
mod program_job;
mod recording;
mod saved_slots;
mod saved_stop;
mod service_manager;
mod target;
mod unit_warning;
mod virtual_station;
mod voice_command;
mod watchdog;

pub use background::Background;
pub use client::{JobWatch, JobsError, JogEnd, LocalArm, NoArm, OpenArmError, StationClient};
pub use connect::OwnVirtualArm;
pub use data_format::{DataFormat, DataFormatError};
pub use drawing_job::drawing_job;
pub use dry_run::{DryRun, dry_run, dry_run_program, personality_of};
pub use finder::{
    Finder, FinderNews, Found, KnownPort, NothingFound, ProbeFailure, Reconnect, Search,
    is_chip_of_arms,
};
pub use handle::{
    Client, DriverChannels, Message, OfferAnswer, OfferRequest, PassedPacket, Rules, Snapshot,
    StationHandle,
};
pub use host::{Host, HostError, Setup};
pub use jobs::WITHDRAWN;
pub use known_arms::KnownArmsError;
pub use long_work::{LongWorkError, run_long};
pub use planned_for::PlannedFor;
pub use prepared_arm::{ArmSelection, PreparedArm};
pub use program_job::{ProgramJobError, ProgramStart, program_job};
pub use recording::{notice_topic, state_topic, tools_of};
pub use service_manager::{Notification, ServiceManager};
pub use target::{PathName, Target, TargetPlace, UnknownPath};
pub use unit_warning::UnitWarning;
pub use virtual_station::VirtualStation;
pub use voice_command::{InvalidVoice, voice_command};
#[cfg(unix)]
pub use watchdog::guard;
pub use watchdog::{Hazards, Heartbeat, JogKind, Silence, Watchdog};
