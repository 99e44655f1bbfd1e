//! The rules that every command to an arm passes, and those who keep them.
//!
//! ```text
//!   clients, wherever they are
//!          |
//!        Handle ----> Driver          the one task that has the port; recordings, journal
//!                       |
//!                   Supervisor        every rule, an engine: no port, no file, no clock
//!                       |
//!                    Session ----> the arm
//! ```
//!
//! The [`Supervisor`] decides. A [`StationClient`] asks it, wherever it is: in a station that runs, in this
//! process for an arm at an address, or in virtual time. A [`VirtualStation`] lets it decide in virtual time,
//! with a virtual arm:
//!
//! ```
//! use std::time::Duration;
//! use dobot_api::Request;
//! use dobot_controller::{Personality, PowerUp};
//! use dobot_rules::VirtualStation;
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
//! # Ok::<(), dobot_rules::Refusal>(())
//! ```

mod approach;
mod arm_thread;
mod background;
mod client;
mod connect;
mod disk;
mod drawing_job;
mod driver;
mod finder;
mod guardian;
mod handle;
mod host;
mod job_path;
mod jobs;
mod kept_slots;
mod kept_stop;
mod known_arms;
mod long_work;
mod planned_for;
mod predict;
mod priority;
mod recording;
mod refusal;
mod service_manager;
mod supervisor;
mod target;
mod text;
mod virtual_station;

pub use approach::{Approach, WantedArm};
pub use background::Background;
pub use client::{JobWatch, JobsError, LocalArm, NoArm, OpenArmError, StationClient};
pub use connect::OwnVirtualArm;
pub use drawing_job::drawing_job;
pub use finder::{Finder, FinderNews, Found, Missed, NothingFound, Reconnect, Search, WhereFound};
#[cfg(unix)]
pub use guardian::guard;
pub use guardian::{Guardian, Hazards, Heartbeat, JogKind, Silence};
pub use handle::{
    Client, Ends, Handle, Message, OfferAnswer, OfferAsk, PassedPacket, Rules, Snapshot,
};
pub use host::{Host, HostError, Setup};
pub use jobs::WITHDRAWN;
pub use kept_stop::StoppedBy;
pub use known_arms::KnownArmsError;
pub use long_work::{LongWorkError, run_long};
pub use planned_for::PlannedFor;
pub use predict::{Prediction, predict};
pub use recording::{notice_topic, state_topic, tools_of};
pub use refusal::{Holder, Refusal};
pub use service_manager::{Notification, ServiceManager};
pub use supervisor::{Begun, Effect, JobPlan, KeptFleetStop, Supervisor};
pub use target::{PathName, Target, TargetPlace, UnknownPath};
pub use text::{is_plain, plain};
pub use virtual_station::VirtualStation;
