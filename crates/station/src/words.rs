//! What the station and its clients say to each other: the same types in the API, its document, the
//! recordings and the program.

mod job;
mod lease;
mod notice;
mod problem;
mod refusal;
mod reply;
mod request;
mod role;
mod state;
mod text;

pub use job::{JobKind, JobPause, JobPhase, JobView, NewJob};
pub use lease::{Asking, ClientId, LeaseView};
pub use notice::{News, Notice};
pub use problem::Problem;
pub use refusal::{Holder, Refusal};
pub use reply::Reply;
pub use request::{Jog, Request};
pub use role::{Role, UnknownRole};
pub use state::{ArmView, LaserView, LinkPhase, LinkView, QueueView, State, StopView, TrustView};
pub(crate) use text::{is_plain, plain};
