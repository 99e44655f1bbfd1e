//! The way between a station and the others of its fleet. What joins them is not in here: it gives the station a
//! [`FleetPort`], and asks the station by its [`StationApi`](crate::StationApi).

use std::sync::Arc;

use dobot_api::problem_kinds::{ENDING, NO_SUCH_MEMBER};
use dobot_api::{
    ApiRequest, LinkPhase, Member, MemberAnswer, Problem, Recipients, State, TakesWork, WorkView,
};
use tokio::sync::{mpsc, oneshot, watch};

/// All stations of a fleet that have been seen, by name.
pub type Members = Arc<[Arc<Member>]>;

/// What the station knows of its fleet, and asks of it.
#[derive(Clone, Debug)]
pub struct FleetPort {
    name: String,
    id: String,
    takes_work: Option<TakesWork>,
    is_on_one_machine: bool,
    is_settled: watch::Receiver<bool>,
    members: watch::Receiver<Members>,
    wishes: mpsc::Sender<FleetWish>,
}

/// The other end of a [`FleetPort`]: of what joins the stations.
#[derive(Debug)]
pub struct FleetEnd {
    /// All stations that have been seen.
    pub members: watch::Sender<Members>,
    /// Whether the station has learned which stops of the fleet there are since it came or came back.
    pub is_settled: watch::Sender<bool>,
    /// What is wanted of the fleet.
    pub wishes: mpsc::Receiver<FleetWish>,
}

/// What a station wants of its fleet.
#[derive(Debug)]
pub enum FleetWish {
    /// To know what the others are and do, as long as there is anybody who has asked for it. An answer says that those know
    /// it who are there.
    Look(oneshot::Sender<()>),
    /// To ask others for something.
    Ask(FleetAsk),
    /// To tell these stations at once which stops of the fleet there are. Those that do not answer are told later.
    TellStops(Vec<Arc<Member>>, oneshot::Sender<Vec<MemberAnswer>>),
    /// That any arm does something.
    Work(WorkWish),
}

/// What a station wants of the work that was submitted to it for any arm.
#[derive(Debug)]
pub enum WorkWish {
    /// To submit some.
    Submit(Box<NewWork>, oneshot::Sender<Result<WorkView, Problem>>),
    /// To know all of it, in the order in which it came.
    List(oneshot::Sender<Result<Vec<WorkView>, Problem>>),
    /// To cancel one, by its number.
    Cancel(String, oneshot::Sender<Result<WorkView, Problem>>),
    /// To give one that is in doubt, or has failed, to another arm.
    Give(String, oneshot::Sender<Result<WorkView, Problem>>),
}

/// A drawing or a program for any arm.
#[derive(Clone, Debug, PartialEq)]
pub struct NewWork {
    /// What a person calls it.
    pub title: String,
    /// Whose it is.
    pub student: String,
    /// The group of that one.
    pub group: Option<String>,
    /// What an arm has to have for it.
    pub needs: Vec<String>,
    /// When it was submitted, in milliseconds since 1970-01-01T00:00:00Z.
    pub submitted_ms: i64,
    /// What the sender calls the request for it.
    pub key: Option<String>,
    /// The body of the request by which it is offered to a station.
    pub offer: serde_json::Value,
}

/// Where the work of a fleet is offered to a station.
pub const OFFERS: &str = "/api/v1/fleet/offers";

/// A request that others are to be asked.
#[derive(Debug)]
pub struct FleetAsk {
    /// Whom.
    pub to: Vec<Arc<Member>>,
    /// What.
    pub request: ApiRequest,
    /// Where their answers go, one of each.
    pub answers: oneshot::Sender<Vec<MemberAnswer>>,
}

impl FleetPort {
    /// The two ends, for a station of this name and number.
    #[must_use]
    pub fn new(name: &str, id: &str) -> (Self, FleetEnd) {
        let (members, seen) = watch::channel(Members::default());
        // Each one who asks waits for its answer.
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
        let end = FleetEnd {
            members,
            is_settled,
            wishes: wished,
        };
        (port, end)
    }

    /// The same, for a station that takes work of its fleet, or none.
    #[must_use]
    pub fn taking(self, takes_work: Option<TakesWork>) -> Self {
        Self { takes_work, ..self }
    }

    /// The same, for a fleet that nobody on another machine can join.
    #[must_use]
    pub fn on_one_machine(self, is_on_one_machine: bool) -> Self {
        Self {
            is_on_one_machine,
            ..self
        }
    }

    /// Whether nobody on another machine can join the fleet.
    #[must_use]
    pub const fn is_on_one_machine(&self) -> bool {
        self.is_on_one_machine
    }

    /// Whether the station has learned which stops of the fleet there are since it came or came back.
    #[must_use]
    pub fn is_settled(&self) -> bool {
        *self.is_settled.borrow()
    }

    /// The number that the station goes by, as in [`Member::id`].
    #[must_use]
    pub fn id(&self) -> &str {
        &self.id
    }

    /// What the station does with work of its fleet; nothing where it takes none.
    #[must_use]
    pub const fn takes_work(&self) -> Option<TakesWork> {
        self.takes_work
    }

    /// What the station is called.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// All stations that have been seen, with what they are and do, as that changes for as long as this is held.
    ///
    /// # Errors
    ///
    /// [`ENDING`] where the fleet is left.
    pub async fn look(&self) -> Result<watch::Receiver<Members>, Problem> {
        let members = self.members.clone();
        let (seen, looked) = oneshot::channel();
        self.wish(FleetWish::Look(seen)).await?;
        looked.await.map_err(|_| ending())?;
        Ok(members)
    }

    /// Asks these stations, and waits for the answer of each: from one that cannot be reached, a problem.
    ///
    /// # Errors
    ///
    /// [`NO_SUCH_MEMBER`] where none is meant, or one that has not been seen; nobody is asked then. [`ENDING`] where the fleet
    /// is left.
    pub async fn ask(
        &self,
        to: &Recipients,
        request: ApiRequest,
    ) -> Result<Vec<MemberAnswer>, Problem> {
        // Everyone, and those of a name, are known without looking: a stop waits for nothing.
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
        self.wish(FleetWish::Ask(ask)).await?;
        answered.await.map_err(|_| ending())
    }

    /// Tells these stations which stops of the fleet there are, and waits for the answer of each. Those that do not answer
    /// are told later.
    ///
    /// # Errors
    ///
    /// [`ENDING`] where the fleet is left.
    pub async fn tell_stops(&self, to: Vec<Arc<Member>>) -> Result<Vec<MemberAnswer>, Problem> {
        let (answers, answered) = oneshot::channel();
        self.wish(FleetWish::TellStops(to, answers)).await?;
        answered.await.map_err(|_| ending())
    }

    /// Wants something of the work for any arm, and waits for what comes of it.
    ///
    /// # Errors
    ///
    /// Why not; [`ENDING`] where the fleet is left.
    pub async fn work<T>(
        &self,
        wish: impl FnOnce(oneshot::Sender<Result<T, Problem>>) -> WorkWish,
    ) -> Result<T, Problem> {
        let (reply, answer) = oneshot::channel();
        self.wish(FleetWish::Work(wish(reply))).await?;
        answer.await.map_err(|_| ending())?
    }

    /// All stations that have been seen, as far as that is known without asking them.
    #[must_use]
    pub fn members(&self) -> Members {
        self.members.borrow().clone()
    }

    /// The station of this name, as far as it has been seen.
    #[must_use]
    pub fn member(&self, name: &str) -> Option<Arc<Member>> {
        let members = self.members.borrow();
        members.iter().find(|member| member.name == name).cloned()
    }

    async fn wish(&self, wish: FleetWish) -> Result<(), Problem> {
        self.wishes.send(wish).await.map_err(|_| ending())
    }
}

/// Why a station that has just joined or returned neither takes nor offers work yet.
pub const UNSETTLED: &str =
    "the station has just joined or returned; it first learns whether the fleet is stopped";

/// Why an arm cannot start work of its fleet now, whatever its job is; one of a station that starts it by itself where nobody
/// has control.
#[must_use]
pub fn work_hurdle(state: &State, takes_work: TakesWork) -> Option<String> {
    if let Some(stop) = &state.stop {
        return Some(stop.text());
    }
    if let Some(lock) = &state.lock {
        return Some(format!("locked by {}", lock.by));
    }
    if state.link.phase != LinkPhase::Up {
        return Some("its station does not hear the arm".into());
    }
    if !state.trust.trusted {
        return Some("its pose is to be confirmed".into());
    }
    match (takes_work, &state.lease) {
        (TakesWork::Start, Some(lease)) => Some(format!("{} has control", lease.name)),
        // A person starts it, and that one may have control.
        _ => None,
    }
}

fn ending() -> Problem {
    ENDING.problem("the station leaves its fleet")
}

/// Those that are meant.
fn chosen(members: &[Arc<Member>], to: &Recipients) -> Result<Vec<Arc<Member>>, Problem> {
    let none = |detail| {
        let hint = "`GET /api/v1/fleet` lists all that have been seen";
        NO_SUCH_MEMBER.hinted(detail, hint)
    };
    if let Recipients::Members(names) = to {
        let is_unknown = |name: &&String| members.iter().all(|member| member.name != **name);
        if let Some(name) = names.iter().find(is_unknown) {
            let name: String = name.chars().take(40).collect();
            return Err(none(format!("no station called {name:?} has been seen")));
        }
    }
    let chosen: Vec<_> = members
        .iter()
        .filter(|member| to.include(member))
        .cloned()
        .collect();
    if chosen.is_empty() {
        return Err(none(match to {
            Recipients::Group(group) => {
                let group: String = group.chars().take(40).collect();
                format!("no station belongs to a group {group:?}")
            }
            _ => "no station is named".to_owned(),
        }));
    }
    Ok(chosen)
}
