//! The messages between a station and its clients, and a station client.
//!
//! The API, its documentation, the recordings and the program share these types. The feature
//! `remote` adds a client: [`Folders`] locates the file that describes a running station of this
//! machine, and [`Remote`] talks to a station.
//!
//! ```
//! use dobot_api::{Request, Role};
//!
//! let request: Request = serde_json::from_str(r#"{"type": "stop", "reason": "smoke"}"#)?;
//! assert_eq!(request, Request::Stop { reason: Some("smoke".into()) });
//! assert_eq!(request.role(), Role::Watch);
//! # Ok::<(), serde_json::Error>(())
//! ```

mod button;
mod calibration;
mod decision;
mod fleet;
#[cfg(feature = "remote")]
mod folders;
mod job;
mod job_state;
mod lease;
mod link_problem;
mod message;
mod near;
mod not_built;
mod notice;
mod path_preview;
#[cfg(feature = "remote")]
mod private;
mod problem;
pub mod problem_kinds;
#[cfg(feature = "remote")]
mod remote;
mod reply;
mod request;
mod role;
#[cfg(feature = "remote")]
mod running;
mod slot;
mod state;
mod work;

pub use button::{Button, ButtonError, JogFrame};
pub use calibration::{
    Axis, Backlash, CalibrationFile, Calibrations, NoSuchArm, PaperPlane, ToolOffset, Touched,
    Zeros,
};
pub use decision::{Answer, AnsweredBy, AskingProgram, GivenPlace, PendingQuestion, Question};
pub use fleet::{
    ApiAnswer, ApiRequest, FleetView, FleetWideStop, GivenArm, GivenArms, Member, MemberAbout,
    MemberAnswer, Presence, Recipients, is_fleet_name,
};
#[cfg(feature = "remote")]
pub use folders::{Folders, make_private};
pub use job::{JobKind, JobPause, JobPhase, JobProgram, JobRepeat, JobView, NewJob, ProgramView};
pub use job_state::JobState;
pub use lease::{ClientId, ControlRequest, Device, LeaseView};
pub use link_problem::{LinkCause, LinkProblem};
pub use message::{FromClient, Hello, ToClient};
pub use near::{BoundedQuantity, NearLimit, NearView};
pub use not_built::NotBuilt;
pub use notice::{Heard, News, Notice};
pub use path_preview::{JobPath, PathPreview};
#[cfg(feature = "remote")]
pub use private::write_private;
pub use problem::Problem;
#[cfg(feature = "options")]
pub use remote::StationOptions;
#[cfg(feature = "remote")]
pub use remote::{
    CertificateTrust, ConnectError, Remote, RemoteError, SearchError, StationAddress,
    StationAddressError, StationEvent, StationSearch, TrustError, delete, fetch, fetch_bytes,
    fingerprint, is_station, post, running,
};
pub use reply::Reply;
pub use request::{EpisodeMark, Jog, Request, Sense};
pub use role::{Role, UnknownRole};
#[cfg(feature = "remote")]
pub use running::{Running, RunningError};
pub use slot::{SlotView, SlotsView, TimeSlot, is_same_person};
pub use state::{
    ArmView, CalibratedView, LaserView, LinkPhase, LinkView, LockView, QueueView, State, StopView,
    TrustView,
};
pub use work::{TakesWork, WorkBefore, WorkMember, WorkPhase, WorkView};
