//! The interface between a station and its fleet. The implementation is elsewhere: it gives the
//! station a [`FleetPort`], and calls the station through its [`StationApi`](crate::StationApi).

use std::sync::Arc;

use dobot_api::problem_kinds::{ENDING, NO_SUCH_MEMBER};
use dobot_api::{
    ApiRequest, LinkPhase, Member, MemberAnswer, Problem, Recipients, State, TakesWork, WorkView,
};
use tokio::sync::{mpsc, oneshot, watch};

/// All known stations of a fleet, by name.
pub type Members = Arc<[Arc<Member>]>;

/// The station's view of its fleet, and its requests to it.
#[derive(Clone, Debug)]
pub struct FleetPort {
    name: String,
    id: String,
    takes_work: Option<TakesWork>,
    is_on_one_machine: bool,
    is_settled: watch::Receiver<bool>,
    members: watch::Receiver<Members>,
    wishes: mpsc::Sender<FleetCommand>,
}

/// The fleet's end of a [`FleetPort`].
#[derive(Debug)]
pub struct FleetChannels {
    /// All known stations.
    pub members: watch::Sender<Members>,
    /// Whether the station has learned the fleet's stops since it joined or returned.
    pub is_settled: watch::Sender<bool>,
    /// Requests to the fleet.
    pub wishes: mpsc::Receiver<FleetCommand>,
}

/// A request of a station to its fleet.
#[derive(Debug)]
pub enum FleetCommand {
    /// Keep the members' states current while there are receivers. The reply is sent when the
    /// members present have reported.
    Look(oneshot::Sender<()>),
    /// Send a request to members.
    Ask(FleetAsk),
    /// Send the fleet's stops to these stations immediately. Stations that do not answer get them
    /// later.
    SendStops(Vec<Arc<Member>>, oneshot::Sender<Vec<MemberAnswer>>),
    /// Manage the jobs for any arm.
    Work(WorkCommand),
}

/// A request concerning the jobs for any arm that were submitted to a station.
#[derive(Debug)]
pub enum WorkCommand {
    /// Submit a job.
    Submit(Box<NewWork>, oneshot::Sender<Result<WorkView, Problem>>),
    /// List all jobs, in the order of their submission.
    List(oneshot::Sender<Result<Vec<WorkView>, Problem>>),
    /// Cancel a job, by its id.
    Cancel(String, oneshot::Sender<Result<WorkView, Problem>>),
    /// Move a job that is in doubt or has failed to another arm.
    Give(String, oneshot::Sender<Result<WorkView, Problem>>),
}

/// A drawing or program for any arm.
#[derive(Clone, Debug, PartialEq)]
pub struct NewWork {
    /// The title.
    pub title: String,
    /// The student who owns the job.
    pub student: String,
    /// The student's group.
    pub group: Option<String>,
    /// The features that an arm must offer.
    pub needs: Vec<String>,
    /// The time of submission, in milliseconds since 1970-01-01T00:00:00Z.
    pub submitted_ms: i64,
    /// The sender's key of the request.
    pub key: Option<String>,
    /// The body of the request by which it is offered to a station.
    pub offer: serde_json::Value,
}

/// The path at which a station accepts offers of the fleet.
pub const OFFERS: &str = "/api/v1/fleet/offers";

/// A request to several members.
#[derive(Debug)]
pub struct FleetAsk {
    /// The receivers.
    pub to: Vec<Arc<Member>>,
    /// The request.
    pub request: ApiRequest,
    /// The channel for their responses, one of each.
    pub answers: oneshot::Sender<Vec<MemberAnswer>>,
}

impl FleetPort {
    /// Returns both ends, for a station with this name and id.
    #[must_use]
    pub fn new(name: &str, id: &str) -> (Self, FleetChannels) {
        let (members, seen) = watch::channel(Members::default());
        // Each requester waits for its reply.
        let (wishes, wished) = mpsc::channel(64);
        let (is_settled, settled) = watch::channel(true);
        let port = Self {
            name: name.into(),
            id: id.into(),
            takes_work: None,
            is_on_one_machine: false,
            is_settled: settled,
            members: seen,
            wishes,
        };
        let end = FleetChannels {
            members,
            is_settled,
            wishes: wished,
        };
        (port, end)
    }

    /// Sets whether and how the station accepts jobs of its fleet.
    #[must_use]
    pub fn taking(self, takes_work: Option<TakesWork>) -> Self {
        Self { takes_work, ..self }
    }

    /// Sets whether only programs of this machine can join the fleet.
    #[must_use]
    pub fn on_one_machine(self, is_on_one_machine: bool) -> Self {
        Self {
            is_on_one_machine,
            ..self
        }
    }

    /// Whether only programs of this machine can join the fleet.
    #[must_use]
    pub const fn is_on_one_machine(&self) -> bool {
        self.is_on_one_machine
    }

    /// Whether the station has learned the fleet's stops since it joined or returned.
    #[must_use]
    pub fn is_settled(&self) -> bool {
        *self.is_settled.borrow()
    }

    /// Returns the station's id, as in [`Member::id`].
    #[must_use]
    pub fn id(&self) -> &str {
        &self.id
    }

    /// Returns how the station handles jobs of its fleet; `None` if it accepts none.
    #[must_use]
    pub const fn takes_work(&self) -> Option<TakesWork> {
        self.takes_work
    }

    /// Returns the name of the station.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Returns all known stations with their states, which are kept current while the receiver
    /// exists.
    ///
    /// # Errors
    ///
    /// [`ENDING`] if the station has left the fleet.
    pub async fn look(&self) -> Result<watch::Receiver<Members>, Problem> {
        let members = self.members.clone();
        let (seen, looked) = oneshot::channel();
        self.wish(FleetCommand::Look(seen)).await?;
        looked.await.map_err(|_| ending())?;
        Ok(members)
    }

    /// Sends a request to these stations, and waits for all responses; an unreachable station gives
    /// a problem.
    ///
    /// # Errors
    ///
    /// [`NO_SUCH_MEMBER`] if there is no recipient or an unknown one; then nothing is sent.
    /// [`ENDING`] if the station has left the fleet.
    pub async fn ask(
        &self,
        to: &Recipients,
        request: ApiRequest,
    ) -> Result<Vec<MemberAnswer>, Problem> {
        // All stations, and named ones, are known without a query: a stop must not wait.
        if matches!(to, Recipients::Group(_)) {
            drop(self.look().await?);
        }
        let to = chosen(&self.members.borrow(), to)?;
        let (answers, answered) = oneshot::channel();
        let ask = FleetAsk {
            to,
            request,
            answers,
        };
        self.wish(FleetCommand::Ask(ask)).await?;
        answered.await.map_err(|_| ending())
    }

    /// Sends the fleet's stops to these stations, and waits for all responses. Stations that do not
    /// answer get them later.
    ///
    /// # Errors
    ///
    /// [`ENDING`] if the station has left the fleet.
    pub async fn send_stops(&self, to: Vec<Arc<Member>>) -> Result<Vec<MemberAnswer>, Problem> {
        let (answers, answered) = oneshot::channel();
        self.wish(FleetCommand::SendStops(to, answers)).await?;
        answered.await.map_err(|_| ending())
    }

    /// Sends a request concerning the jobs for any arm, and waits for the reply.
    ///
    /// # Errors
    ///
    /// The problem; [`ENDING`] if the station has left the fleet.
    pub async fn work<T>(
        &self,
        wish: impl FnOnce(oneshot::Sender<Result<T, Problem>>) -> WorkCommand,
    ) -> Result<T, Problem> {
        let (reply, answer) = oneshot::channel();
        self.wish(FleetCommand::Work(wish(reply))).await?;
        answer.await.map_err(|_| ending())?
    }

    /// Returns all known stations without a query.
    #[must_use]
    pub fn members(&self) -> Members {
        self.members.borrow().clone()
    }

    /// Returns the station of this name, if it is known.
    #[must_use]
    pub fn member(&self, name: &str) -> Option<Arc<Member>> {
        let members = self.members.borrow();
        members.iter().find(|member| member.name == name).cloned()
    }

    async fn wish(&self, wish: FleetCommand) -> Result<(), Problem> {
        self.wishes.send(wish).await.map_err(|_| ending())
    }
}

/// The reason why a station that has just joined or returned neither accepts nor offers jobs yet.
pub const UNSETTLED: &str =
    "the station has just joined or returned, and first checks whether the fleet is stopped";

/// Returns why an arm cannot start a job of its fleet now, regardless of its current job. A station
/// with automatic starts also requires that nobody has control.
#[must_use]
pub fn work_hurdle(state: &State, takes_work: TakesWork) -> Option<String> {
    if let Some(stop) = &state.stop {
        return Some(stop.text());
    }
    if let Some(lock) = &state.lock {
        return Some(format!("locked by {}", lock.by));
    }
    if state.link.phase != LinkPhase::Up {
        return Some("its station has no connection to the arm".into());
    }
    if !state.trust.trusted {
        return Some("its pose must be confirmed".into());
    }
    match (takes_work, &state.lease) {
        (TakesWork::Start, Some(lease)) => Some(format!("{} has control", lease.name)),
        // A person starts it, and may have control.
        _ => None,
    }
}

fn ending() -> Problem {
    ENDING.problem("the station is leaving its fleet")
}

/// Returns the recipients.
fn chosen(members: &[Arc<Member>], to: &Recipients) -> Result<Vec<Arc<Member>>, Problem> {
    if let Recipients::Members(names) = to {
        check_known(members, names)?;
    }
    let chosen: Vec<_> = members
        .iter()
        .filter(|member| to.include(member))
        .cloned()
        .collect();
    if chosen.is_empty() {
        return Err(no_such_member(match to {
            Recipients::Group(group) => {
                format!("no station belongs to the group {:?}", shortened(group))
            }
            _ => "no station is given".to_owned(),
        }));
    }
    Ok(chosen)
}

fn check_known(members: &[Arc<Member>], names: &[String]) -> Result<(), Problem> {
    let is_unknown = |name: &&String| members.iter().all(|member| member.name != **name);
    let Some(name) = names.iter().find(is_unknown) else {
        return Ok(());
    };
    let name = shortened(name);
    Err(no_such_member(format!(
        "no station with the name {name:?} is known"
    )))
}

fn no_such_member(detail: String) -> Problem {
    NO_SUCH_MEMBER.hinted(detail, "`GET /api/v1/fleet` lists all known stations")
}

/// Shortens a name for a message.
fn shortened(name: &str) -> String {
    name.chars().take(40).collect()
}
