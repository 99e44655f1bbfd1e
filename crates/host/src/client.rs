//! A client of a supervisor: in a running station, in this process, or in virtual time.

mod jog;
mod local;
mod virtual_time;

use std::fmt;
use std::time::Duration;

use dobot_api::{
    ArmView, ClientId, ConnectError, JobPhase, JobView, LinkPhase, NewJob, News, Notice, Problem,
    Remote, RemoteError, Reply, Request, Role, State, StationAddress, StationEvent, fetch,
};
use dobot_controller::{Controller, PowerUp};
use dobot_safety::Policy;
use dobot_session::Address;
use dobot_sim::{SerialLine, VirtualArm};
use dobot_supervisor::Refusal;
use tokio::time::{Instant, timeout};

use crate::{PlannedFor, Rules};

pub use self::jog::JogEnd;
use self::local::Local;
use self::virtual_time::VirtualTimeClient;

pub use self::local::{LocalArm, OpenArmError};

/// The total time of retries while an arm still moves.
const PATIENCE: Duration = Duration::from_secs(5);
/// The pause between two retries.
const PAUSE: Duration = Duration::from_millis(80);
/// A stock arm does not respond for up to two seconds after its port is opened; five are allowed.
const FIRST_STATUS: Duration = Duration::from_secs(6);

/// A client of the supervisor that checks every command to an arm.
///
/// Rules and requests are the same wherever the supervisor runs:
///
/// | constructor | the rules are kept | the arm |
/// |---|---|---|
/// | [`connect`](Self::connect) | by a station that runs | is the station's |
/// | [`open`](Self::open) | in this process, in a thread of their own | is at an address |
/// | [`with_virtual_arm`](Self::with_virtual_arm) | in this process, in virtual time | is in this process too |
///
/// Control of the arm and jog buttons are released when the client is dropped. [`end`](Self::end)
/// also waits until the arm is at rest.
///
/// ```
/// use dobot_controller::{Personality, PowerUp};
/// use dobot_safety::Policy;
/// use dobot_api::{Reply, Request};
/// use dobot_host::StationClient;
/// use dobot_wire::{Command, MoveTo, MovingMode};
///
/// # #[tokio::main(flavor = "current_thread")]
/// # async fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let power_up = PowerUp::new(Personality::Firmware11);
/// let mut station = StationClient::with_virtual_arm(power_up, Policy::default(), "example");
/// station.state().await?;
/// station.request(Request::TakeLease).await?;
/// let command = Command::from(MoveTo::to(220.0, 0.0, 30.0));
/// let Reply::Accepted { command, .. } = station.request(Request::Command { command }).await? else {
///     panic!("a motion is accepted");
/// };
/// station.finished(command).await?;
/// # Ok(())
/// # }
/// ```
pub struct StationClient {
    route: ClientRoute,
    began: Instant,
}

/// Where the supervisor runs.
enum ClientRoute {
    Running(Box<Remote>, StationAddress),
    Local(Box<Local>),
    Virtual(Box<VirtualTimeClient>),
}

impl StationClient {
    /// Connects to a running station, with a name that other clients see.
    ///
    /// # Errors
    ///
    /// [`ConnectError`], with a hint.
    pub async fn connect(address: &StationAddress, name: &str) -> Result<Self, ConnectError> {
        let remote = Remote::connect(address, name).await?;
        Ok(Self::new(ClientRoute::Running(
            Box::new(remote),
            address.clone(),
        )))
    }

    /// Opens the port of an arm and runs the supervisor in this process, in its own thread, with
    /// journal and recording but without page and raw port. The laser is switched off first. The
    /// pose is not trusted until [`Request::ConfirmPose`], because opening its port resets a stock
    /// arm.
    ///
    /// # Errors
    ///
    /// [`OpenArmError`]; nothing keeps running.
    ///
    /// # Panics
    ///
    /// Outside of a tokio runtime.
    pub async fn open(arm: LocalArm, name: &str) -> Result<Self, OpenArmError> {
        let local = Local::open(arm, name).await?;
        Ok(Self::new(ClientRoute::Local(Box::new(local))))
    }

    /// Runs a supervisor with a virtual arm in this process, in virtual time, which passes only
    /// during waits. Its pose is trusted and its laser needs no arming, since it can do no harm.
    ///
    /// # Panics
    ///
    /// Never: an in-memory journal can always be created.
    #[must_use]
    pub fn with_virtual_arm(power_up: PowerUp, policy: Policy, name: &str) -> Self {
        let arm = VirtualArm::new(Controller::power_up(power_up), SerialLine::STOCK);
        Self::with_custom_virtual_arm(arm, power_up, policy, name)
    }

    /// Runs a supervisor with the given virtual arm, for example one with faults or in a world.
    /// `power_up` is the power-up of its controller.
    ///
    /// # Panics
    ///
    /// Never: an in-memory journal can always be created.
    #[must_use]
    pub fn with_custom_virtual_arm(
        arm: VirtualArm,
        power_up: PowerUp,
        policy: Policy,
        name: &str,
    ) -> Self {
        let station = VirtualTimeClient::new(arm, power_up, policy, name);
        Self::new(ClientRoute::Virtual(Box::new(station)))
    }

    fn new(route: ClientRoute) -> Self {
        Self {
            route,
            began: Instant::now(),
        }
    }

    /// Sends a request. Events that arrive in the meantime are kept for [`next`](Self::next).
    ///
    /// # Errors
    ///
    /// [`RemoteError::Refused`] if it is refused, other variants if no answer comes.
    pub async fn request(&mut self, request: Request) -> Result<Reply, RemoteError> {
        match &mut self.route {
            ClientRoute::Running(remote, _) => remote.request(request).await,
            ClientRoute::Local(local) => local
                .request(request)
                .await
                .map_err(|error| refused(&error)),
            ClientRoute::Virtual(station) => {
                station.request(request).map_err(|error| refused(&error))
            }
        }
    }

    /// Sends a request that needs an arm at rest; it is repeated for up to five seconds of the
    /// arm's time.
    ///
    /// # Errors
    ///
    /// Same as [`request`](Self::request).
    pub async fn request_at_rest(&mut self, request: Request) -> Result<Reply, RemoteError> {
        let until = self.now() + PATIENCE;
        loop {
            match self.request(request.clone()).await {
                Err(error) if error.kind() == Some("still-moving") && self.now() < until => {
                    self.wait(PAUSE).await;
                }
                answer => return answer,
            }
        }
    }

    /// Returns the next event: a state or a notice. Cancelling this loses nothing.
    ///
    /// # Errors
    ///
    /// [`RemoteError`] if the connection is lost or the supervisor has ended.
    pub async fn next(&mut self) -> Result<StationEvent, RemoteError> {
        match &mut self.route {
            ClientRoute::Running(remote, _) => remote.next().await,
            ClientRoute::Local(local) => local.next().await,
            ClientRoute::Virtual(station) => {
                // Gives other tasks of the runtime (such as a stop signal) a turn.
                tokio::task::consume_budget().await;
                Ok(station.next())
            }
        }
    }

    /// Returns the next state.
    ///
    /// # Errors
    ///
    /// Same as [`next`](Self::next).
    pub async fn state(&mut self) -> Result<State, RemoteError> {
        loop {
            if let StationEvent::State(state) = self.next().await? {
                return Ok(*state);
            }
        }
    }

    /// Returns the next event, or `None` if none comes within this time by the arm's clock. Cancelling this
    /// loses nothing.
    ///
    /// # Errors
    ///
    /// Same as [`next`](Self::next).
    pub async fn next_within(
        &mut self,
        time: Duration,
    ) -> Result<Option<StationEvent>, RemoteError> {
        if let ClientRoute::Virtual(station) = &mut self.route {
            tokio::task::consume_budget().await;
            return Ok(station.next_within(time));
        }
        timeout(time, self.next()).await.ok().transpose()
    }

    /// Waits until the arm is at rest after everything it was given, and returns it.
    ///
    /// # Errors
    ///
    /// [`NoArm`] if there is none, or no state comes for five seconds.
    pub async fn rest(&mut self) -> Result<ArmView, NoArm> {
        self.rest_with_events(|_| {}).await
    }

    /// Waits until the arm is at rest, or there is none.
    ///
    /// # Errors
    ///
    /// Same as [`next`](Self::next); [`RemoteError::Silent`] if no state comes for five seconds.
    pub async fn idle(&mut self) -> Result<(), RemoteError> {
        match self.rest().await {
            Ok(_) | Err(NoArm::Unusable(_)) => Ok(()),
            Err(NoArm::Silent(error)) => Err(error),
        }
    }

    /// Waits like [`rest`](Self::rest), passing every event to `see`.
    ///
    /// # Errors
    ///
    /// Same as [`rest`](Self::rest).
    pub async fn rest_with_events(
        &mut self,
        mut see: impl FnMut(&StationEvent),
    ) -> Result<ArmView, NoArm> {
        loop {
            // A state among the events may be older than the last request.
            let state = self.current_state().await?;
            match &state.arm {
                Some(arm) if state.link.phase == LinkPhase::Up => {
                    if !arm.moving {
                        return Ok(arm.clone());
                    }
                }
                _ => return Err(NoArm::of(&state)),
            }
            loop {
                let event = timeout(PATIENCE, self.next()).await;
                let event = event.map_err(|_| RemoteError::Silent)??;
                see(&event);
                if matches!(event, StationEvent::State(_)) {
                    break;
                }
            }
        }
    }

    /// Returns the state after everything requested so far.
    async fn current_state(&mut self) -> Result<Box<State>, RemoteError> {
        match self.request(Request::ShowState).await? {
            Reply::State { state } => Ok(state),
            reply => Err(RemoteError::Garbled(format!("{reply:?}"))),
        }
    }

    /// Returns the first state with an arm. After the start of a station, waits up to six seconds
    /// for the first status of its arm.
    ///
    /// # Errors
    ///
    /// [`NoArm`] if no arm responds.
    pub async fn first_state(&mut self) -> Result<State, NoArm> {
        let mut missing = NoArm::Silent(RemoteError::Silent);
        let until = self.now() + FIRST_STATUS;
        while self.now() < until {
            let Ok(state) = timeout(FIRST_STATUS, self.state()).await else {
                break;
            };
            let state = state?;
            match &state.arm {
                Some(_) if state.link.phase == LinkPhase::Up => return Ok(state),
                // Why the link was lost is more useful than that there is none now.
                _ if state.link.phase == LinkPhase::Lost => return Err(NoArm::of(&state)),
                _ => missing = NoArm::of(&state),
            }
        }
        Err(missing)
    }

    /// Queues a job and returns its number.
    ///
    /// # Errors
    ///
    /// Same as [`request`](Self::request).
    pub async fn submit(&mut self, job: NewJob) -> Result<u64, RemoteError> {
        match self.request(Request::SubmitJob { job, key: None }).await? {
            Reply::Job { job } => Ok(job.job),
            other => Err(RemoteError::Garbled(format!(
                "the answer to a new job is {other:?}"
            ))),
        }
    }

    /// Removes a job that was refused before it started; the next attempt queues its own. Errors
    /// are ignored, because the reason of the refusal is what matters.
    pub async fn remove_unstarted(&mut self, job: u64) {
        let Ok(jobs) = self.jobs().await else {
            return;
        };
        let is_unbegun = |view: &JobView| view.job == job && view.phase == JobPhase::Queued;
        if jobs.iter().any(is_unbegun) {
            let _ = self.request(Request::CancelJob { job }).await;
        }
    }

    /// Waits until an [accepted](Reply::Accepted) command is over.
    ///
    /// # Errors
    ///
    /// [`RemoteError::Failed`] if the arm is not at the command's end or the link is lost,
    /// otherwise the errors of [`next`](Self::next).
    pub async fn finished(&mut self, command: u64) -> Result<(), RemoteError> {
        self.finished_with_states(command, |_| {}).await
    }

    /// Waits like [`finished`](Self::finished), passing every state to `see`.
    ///
    /// # Errors
    ///
    /// Same as [`finished`](Self::finished).
    pub async fn finished_with_states(
        &mut self,
        command: u64,
        mut see: impl FnMut(&State),
    ) -> Result<(), RemoteError> {
        loop {
            let notice = match self.next().await? {
                StationEvent::Notice(notice) => notice,
                StationEvent::State(state) => {
                    see(&state);
                    continue;
                }
            };
            match notice.news {
                News::CommandDone { command: done } if done == command => return Ok(()),
                News::CommandFailed { command: failed } if failed == command => {
                    return Err(RemoteError::Failed(notice.text));
                }
                News::LinkLost | News::NoLink { .. } => {
                    return Err(RemoteError::Failed(notice.text));
                }
                _ => {}
            }
        }
    }

    /// Returns all jobs, oldest first.
    ///
    /// # Errors
    ///
    /// [`JobsError`] if they are not available.
    pub async fn jobs(&mut self) -> Result<Vec<JobView>, JobsError> {
        match &mut self.route {
            ClientRoute::Running(_, address) => Ok(fetch(address, "/api/v1/jobs").await?),
            ClientRoute::Local(local) => Ok(local.jobs().await.map_err(|error| refused(&error))?),
            ClientRoute::Virtual(station) => Ok(station.jobs().map_err(|error| refused(&error))?),
        }
    }

    /// Returns the arm to plan for: its pose and its settings in this state, its policy, and its known
    /// calibration.
    ///
    /// # Errors
    ///
    /// [`JobsError`] if the station does not provide them.
    pub async fn planned_for(&mut self, state: &State) -> Result<PlannedFor, JobsError> {
        let rules = match &mut self.route {
            ClientRoute::Running(_, address) => {
                let policy: Policy = fetch(address, "/api/v1/policy").await?;
                let calibrations = fetch(address, "/api/v1/calibration").await?;
                Rules::with_calibrations(&policy, calibrations).into()
            }
            ClientRoute::Local(local) => local.rules(),
            ClientRoute::Virtual(station) => station.rules().into(),
        };
        Ok(PlannedFor::of(rules, state))
    }

    /// Returns the client's number.
    #[must_use]
    pub const fn id(&self) -> ClientId {
        match &self.route {
            ClientRoute::Running(remote, _) => remote.hello().client,
            ClientRoute::Local(local) => local.id(),
            ClientRoute::Virtual(station) => station.id(),
        }
    }

    /// Returns the client's role.
    #[must_use]
    pub const fn role(&self) -> Role {
        match &self.route {
            ClientRoute::Running(remote, _) => remote.hello().role,
            ClientRoute::Local(_) | ClientRoute::Virtual(_) => Role::Admin,
        }
    }

    /// Returns the dead-man time: how long a jog button stays pressed without a repeated request.
    #[must_use]
    pub fn dead_man(&self) -> Duration {
        let seconds = match &self.route {
            ClientRoute::Running(remote, _) => remote.hello().dead_man_s,
            ClientRoute::Local(local) => local.dead_man_s(),
            ClientRoute::Virtual(station) => station.dead_man_s(),
        };
        // An impossible value from the station means that no button can be held.
        Duration::try_from_secs_f64(seconds).unwrap_or_default()
    }

    /// Lets time pass by the arm's clock.
    pub async fn wait(&mut self, time: Duration) {
        match &mut self.route {
            ClientRoute::Virtual(station) => station.wait(time),
            ClientRoute::Running(..) | ClientRoute::Local(_) => tokio::time::sleep(time).await,
        }
    }

    /// Returns the time since this client connected, by the arm's clock.
    #[must_use]
    pub fn now(&self) -> Duration {
        match &self.route {
            ClientRoute::Virtual(station) => station.now(),
            ClientRoute::Running(..) | ClientRoute::Local(_) => self.began.elapsed(),
        }
    }

    /// Returns the address of the arm, if this process has opened it.
    #[must_use]
    pub fn arm_address(&self) -> Option<&Address> {
        match &self.route {
            ClientRoute::Running(..) => None,
            ClientRoute::Local(local) => Some(local.address()),
            ClientRoute::Virtual(_) => Some(&Address::Virtual),
        }
    }

    /// Returns the virtual arm, if it is in this process.
    #[must_use]
    pub const fn virtual_arm(&self) -> Option<&VirtualArm> {
        match &self.route {
            ClientRoute::Virtual(station) => Some(station.arm()),
            ClientRoute::Running(..) | ClientRoute::Local(_) => None,
        }
    }

    /// Returns the virtual arm mutably.
    pub const fn virtual_arm_mut(&mut self) -> Option<&mut VirtualArm> {
        match &mut self.route {
            ClientRoute::Virtual(station) => Some(station.arm_mut()),
            ClientRoute::Running(..) | ClientRoute::Local(_) => None,
        }
    }

    /// Disconnects and releases everything. If the supervisor runs in this process, the laser goes
    /// off, in-flight commands get a moment to finish, and the port is closed.
    pub async fn end(self) {
        if let ClientRoute::Local(local) = self.route {
            local.end().await;
        }
    }
}

impl fmt::Debug for StationClient {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let route: &dyn fmt::Debug = match &self.route {
            ClientRoute::Running(remote, _) => remote,
            ClientRoute::Local(local) => local,
            ClientRoute::Virtual(station) => station,
        };
        f.debug_tuple("StationClient").field(route).finish()
    }
}

/// Determines from notices when a job stops running.
#[derive(Clone, Copy, Debug)]
pub struct JobWatch {
    job: u64,
    has_run: bool,
}

impl JobWatch {
    /// Watches a job that is about to start.
    #[must_use]
    pub const fn new(job: u64) -> Self {
        Self {
            job,
            has_run: false,
        }
    }

    /// Returns how the job ended, or that it is paused, with the text; only after it has run.
    pub fn handle_notice(&mut self, notice: &Notice) -> Option<(JobPhase, String)> {
        let News::Job { job, phase } = notice.news else {
            return None;
        };
        if job != self.job {
            return None;
        }
        // A job that had to come to rest first is reported as paused once more.
        self.has_run |= phase == JobPhase::Running;
        let rests = !matches!(phase, JobPhase::Queued | JobPhase::Running);
        (self.has_run && rests).then(|| (phase, notice.text.clone()))
    }
}

/// Why no arm responds.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum NoArm {
    /// The station has no usable arm, and says why.
    #[error("no arm can be used: {0}")]
    Unusable(String),
    /// The station does not respond.
    #[error(transparent)]
    Silent(#[from] RemoteError),
}

impl NoArm {
    fn of(state: &State) -> Self {
        let why = match (&state.link.problem, state.link.phase) {
            (Some(problem), _) => problem.clone(),
            (None, LinkPhase::Searching) => "no arm has been found yet".into(),
            (None, _) => "the arm does not respond".into(),
        };
        Self::Unusable(why)
    }

    /// Returns a hint on how to fix it.
    #[must_use]
    pub fn hint(&self) -> Option<String> {
        match self {
            Self::Unusable(_) => Some("check that the arm is switched on, and its port and line speed: `dobot ports` lists the ports, `dobot watch` shows what the station is waiting for".into()),
            Self::Silent(error) => error.hint(),
        }
    }
}

/// Why the jobs are not available.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum JobsError {
    /// The station cannot be reached or refuses.
    #[error(transparent)]
    Connect(#[from] ConnectError),
    /// The supervisor refuses.
    #[error(transparent)]
    Request(#[from] RemoteError),
}

fn refused(refusal: &Refusal) -> RemoteError {
    RemoteError::Refused(Box::new(Problem::from(refusal)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_job_is_over_or_paused_only_after_it_has_run() {
        let mut watch = JobWatch::new(7);
        let mut handle = |job, phase| {
            let notice = Notice {
                number: 1,
                at_s: 0.0,
                news: News::Job { job, phase },
                text: "so".to_owned(),
            };
            watch.handle_notice(&notice).map(|(phase, _)| phase)
        };
        assert_eq!(handle(7, JobPhase::Paused), None);
        assert_eq!(handle(7, JobPhase::Running), None);
        assert_eq!(handle(8, JobPhase::Done), None);
        assert_eq!(handle(7, JobPhase::Paused), Some(JobPhase::Paused));
    }
}
