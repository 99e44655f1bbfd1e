//! Refusals of requests.

use std::borrow::Cow;

use dobot_api::problem_kinds::{self, ProblemKind};
use dobot_api::{JobPhase, Problem, Role};
use dobot_safety::Violation;
use dobot_session::SendError;

/// Why the station refuses a request. Nothing has changed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Refusal {
    /// The client's role is not sufficient.
    #[error("role {needed} is required; this client has {found}")]
    Role {
        /// The role required.
        needed: Role,
        /// The client's role.
        found: Role,
    },
    /// The client does not have control.
    #[error("{}", match holder { Some(Holder { name, .. }) => format!("{name} has control of the arm"), None => "this client does not have control of the arm; control is free".to_owned() })]
    NoLease {
        /// The lease holder, if any.
        holder: Option<Holder>,
    },
    /// An administrator has locked the arm.
    #[error("the arm was locked by {by}{}", message.as_ref().map(|message| format!(": {message}")).unwrap_or_default())]
    Locked {
        /// Who locked it.
        by: String,
        /// The reason.
        message: Option<String>,
    },
    /// The arm is in another student's time slot.
    #[error("the arm is reserved for {student}{} for another {}; it is free in {}", group.as_ref().map(|group| format!(" ({group})")).unwrap_or_default(), span(*left_s), span(*free_in_s))]
    Slot {
        /// The student.
        student: String,
        /// The student's group.
        group: Option<String>,
        /// The remaining time of the slot, in seconds.
        left_s: f64,
        /// The time until the arm is free, in seconds, if the time slots do not change.
        free_in_s: f64,
    },
    /// The time slots are invalid.
    #[error("{0}")]
    BadSlots(String),
    /// No client with this number has asked for control.
    #[error("client {0} has not asked for control")]
    NotAsking(u64),
    /// The arm is stopped until a person clears the stop.
    #[error("{} {by}{}", if *of_fleet { "stopped: fleet, by" } else { "the arm was stopped by" },
        reason.as_ref().map(|reason| format!(": {reason}")).unwrap_or_default())]
    Stopped {
        /// Who stopped it.
        by: String,
        /// The reason.
        reason: Option<String>,
        /// Whether it is a fleet-wide stop.
        of_fleet: bool,
    },
    /// The arm is not at rest yet.
    #[error("the arm is still moving; it is at rest within {within_s:.1} s")]
    StillMoving {
        /// The longest time until it is at rest, in seconds.
        within_s: f64,
    },
    /// The station released a button that is still pressed.
    #[error("the button was released: {0}")]
    LetGo(String),
    /// There is no link to send it over, and the arm may be moving or burning.
    #[error("{0} was NOT DELIVERED: there is no link to the arm")]
    NotDelivered(&'static str),
    /// No watchdog guards the arm.
    #[error("no watchdog guards the arm: {0}")]
    Unguarded(String),
    /// There is no arm to send to.
    #[error("there is no link to an arm: {0}")]
    NoLink(String),
    /// The session refused to send it.
    #[error(transparent)]
    Send(SendError),
    /// The policy forbids it.
    #[error(transparent)]
    Policy(Box<Violation>),
    /// The laser is not armed.
    #[error("the laser is disarmed")]
    LaserDisarmed,
    /// A number is out of range.
    #[error("{name} is {found}; allowed is {allowed}")]
    OutOfRange {
        /// The name of the number.
        name: &'static str,
        /// The value given.
        found: f64,
        /// The values allowed.
        allowed: String,
    },
    /// Too many commands are waiting.
    #[error("{waiting} commands are waiting; allowed are {most}")]
    TooMany {
        /// The number waiting.
        waiting: usize,
        /// The maximum.
        most: usize,
    },
    /// A job is using the arm.
    #[error("job {0} is using the arm")]
    JobRunning(u64),
    /// The dialect of the arm is being detected.
    #[error("the dialect of the arm is being detected")]
    Detecting,
    /// The motions of the detection did not determine the dialect.
    #[error("the dialect could not be detected: {0}")]
    NotFound(String),
    /// The job waits for a person.
    #[error("job {job} waits for a person: {message}")]
    NeedsPerson {
        /// The job number.
        job: u64,
        /// What the person has to do.
        message: String,
    },
    /// No job is running.
    #[error("no job is running")]
    NoJobRuns,
    /// The job does not wait for an answer.
    #[error("job {0} does not wait for an answer now")]
    NoQuestion(u64),
    /// The answer is to an earlier question of the job.
    #[error("question {question} of job {job} has its answer; it asks question {asked} now")]
    AnsweredBefore {
        /// The job number.
        job: u64,
        /// The question of the answer.
        question: u64,
        /// The current question.
        asked: u64,
    },
    /// An answer does not fit the question, or the program cannot continue with it.
    #[error("{0}")]
    BadAnswer(String),
    /// There is no such job.
    #[error("there is no job {0}")]
    NoSuchJob(u64),
    /// The job's phase does not allow this.
    #[error("job {job} is {found}; allowed are jobs that are {allowed}", found = format!("{found:?}").to_lowercase())]
    JobPhase {
        /// The job number.
        job: u64,
        /// The job's phase.
        found: JobPhase,
        /// The phases allowed.
        allowed: &'static str,
    },
    /// The job has no vectors whose speed or height could be changed.
    #[error("job {0} has no write vectors: its speed and height are those of its targets")]
    NoVectors(u64),
    /// The job cannot run as it is.
    #[error("command {index} of the job: {why}")]
    BadJob {
        /// The index of the command, from 0.
        index: usize,
        /// What is wrong with it.
        why: String,
        /// The key of the policy rule, if a rule forbids it.
        rule: Option<String>,
    },
    /// The idempotency key was already used for another job.
    #[error("key {key:?} was already used for a different request (job {job})")]
    KeyReused {
        /// The key.
        key: String,
        /// The other job.
        job: u64,
    },
    /// The job cannot be resumed in the current situation.
    #[error("cannot resume the job: {0}")]
    CannotResume(String),
    /// The journal cannot be written.
    #[error("the journal of jobs cannot be written: {0}")]
    Journal(String),
    /// Nothing is recorded that could be marked.
    #[error("nothing is recorded: {0}")]
    NotRecorded(String),
    /// The request cannot be understood.
    #[error("the request cannot be understood: {0}")]
    Malformed(String),
    /// The station is shutting down.
    #[error("the station is shutting down")]
    Ending,
}

/// The lease holder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Holder {
    /// The holder's name.
    pub name: String,
    /// Whether it is a program on the raw port, which cannot answer requests.
    pub is_program: bool,
}

impl Refusal {
    /// Returns the refusal of a job because of a command, counted from 0, that breaks no rule of the policy.
    #[must_use]
    pub fn bad_job(index: usize, why: impl Into<String>) -> Self {
        Self::BadJob {
            index,
            why: why.into(),
            rule: None,
        }
    }

    /// Returns the kind of refusal: the last part of the problem type's URL.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        self.row().0.name
    }

    /// Returns a hint on how to fix it.
    #[must_use]
    pub fn hint(&self) -> Option<String> {
        self.row().1.map(Cow::into_owned)
    }

    /// Returns the problem type and, unless the text itself says what to do, a hint.
    #[expect(clippy::too_many_lines, reason = "a table")]
    fn row(&self) -> (ProblemKind, Option<Cow<'static, str>>) {
        // table
        let (kind, hint) = match self {
            Self::Role { needed, .. } => {
                let hint = format!("use a token with the role {needed}");
                return (problem_kinds::ROLE, Some(hint.into()));
            }
            Self::NoLease { holder } => (problem_kinds::NO_LEASE, lease_hint(holder.as_ref())),
            Self::Locked { .. } => (
                problem_kinds::LOCKED,
                "wait until it is unlocked; any client may stop the arm meanwhile",
            ),
            Self::Slot { .. } => (
                problem_kinds::SLOT,
                "wait for your time slot, or until the arm is free (`dobot slots` or `GET /api/v1/slots`); any client may stop the arm meanwhile",
            ),
            Self::NotAsking(_) => (
                problem_kinds::NOT_ASKING,
                "list the requests: `dobot lease` or `GET /api/v1/state`",
            ),
            Self::Stopped { of_fleet: true, .. } => (
                problem_kinds::STOPPED,
                "check the arm, then clear the stop: `dobot stop --reset` or `DELETE /api/v1/stop` for this arm, `dobot fleet stop --reset` or `DELETE /api/v1/fleet/stop` for the fleet",
            ),
            Self::Stopped { .. } => (
                problem_kinds::STOPPED,
                "check the arm, then clear the stop: `dobot stop --reset` or `DELETE /api/v1/stop`",
            ),
            Self::StillMoving { .. } => (problem_kinds::STILL_MOVING, "wait until it is at rest"),
            Self::LetGo(_) => (
                problem_kinds::LET_GO,
                "release the button, then press it again",
            ),
            Self::NotDelivered(_) => (
                problem_kinds::NOT_DELIVERED,
                "switch the arm off by hand; the packets are sent as soon as the link is back",
            ),
            Self::Unguarded(_) => (
                problem_kinds::UNGUARDED,
                "free memory or processes on this machine; the station starts another watchdog as soon as it can",
            ),
            Self::NoLink(_) => (
                problem_kinds::NO_LINK,
                "see what the station is waiting for: `dobot watch` or `GET /api/v1/state`",
            ),
            Self::Send(error) => return (problem_kinds::COMMAND, send_hint(error).map(Into::into)),
            Self::Policy(_) => (
                problem_kinds::POLICY,
                "see the rules: `dobot policy` or `GET /api/v1/policy`",
            ),
            Self::LaserDisarmed => (
                problem_kinds::LASER_DISARMED,
                "put on goggles, then arm the laser from the client that uses it: `--arm-laser 600` of `dobot jog` and `dobot jobs start`, or `POST /api/v1/laser`",
            ),
            Self::TooMany { .. } => (
                problem_kinds::TOO_MANY,
                "wait until some are over, or send them as a job",
            ),
            Self::JobRunning(_) => (
                problem_kinds::JOB_RUNNING,
                "pause it: `dobot jobs pause` or `POST /api/v1/jobs/pause`",
            ),
            Self::Detecting => (
                problem_kinds::DETECTING,
                "wait until it is done, or stop it: `dobot stop` or `POST /api/v1/stop`",
            ),
            Self::NotFound(_) => (
                problem_kinds::DIALECT_NOT_FOUND,
                "make sure that nothing blocks the arm and its cable is plugged in firmly, then detect again (`dobot detect` or `POST /api/v1/dialect/detect`); or set the dialect: `--dialect firmware-1.1` or `PUT /api/v1/dialect` for an arm with its original firmware",
            ),
            Self::NeedsPerson { .. } => (
                problem_kinds::NEEDS_PERSON,
                "have a person confirm and resume it: on the page, or with `dobot jobs start` in a terminal",
            ),
            Self::NoJobRuns => (
                problem_kinds::NO_JOB_RUNS,
                "list the jobs: `dobot jobs` or `GET /api/v1/jobs`",
            ),
            Self::NoQuestion(_) | Self::AnsweredBefore { .. } => (
                problem_kinds::NO_QUESTION,
                "show the question of the job: `dobot jobs` or `GET /api/v1/jobs`",
            ),
            Self::BadAnswer(_) => (
                problem_kinds::BAD_ANSWER,
                "give one of the allowed answers, or a position that the arm may go to",
            ),
            Self::NoSuchJob(_) => (
                problem_kinds::NO_SUCH_JOB,
                "list the jobs: `dobot jobs` or `GET /api/v1/jobs`",
            ),
            Self::JobPhase { .. } => (
                problem_kinds::JOB_PHASE,
                "list the jobs: `dobot jobs` or `GET /api/v1/jobs`",
            ),
            Self::NoVectors(_) => (
                problem_kinds::NO_VECTORS,
                "change the speed of targets: `dobot set percent`",
            ),
            Self::BadJob { .. } => (
                problem_kinds::BAD_JOB,
                "change that command, and submit the job again",
            ),
            Self::KeyReused { .. } => (
                problem_kinds::KEY_REUSED,
                "use a new key for each request, such as a random number",
            ),
            Self::CannotResume(_) => (
                problem_kinds::CANNOT_RESUME,
                "see its progress with `dobot jobs` or `GET /api/v1/jobs`; end it with `dobot jobs cancel` or `DELETE /api/v1/jobs/{id}`",
            ),
            Self::Journal(_) => (
                problem_kinds::JOURNAL,
                "make room on the disk, or check the folder's permissions",
            ),
            Self::NotRecorded(_) => (
                problem_kinds::NOT_RECORDED,
                "use the arm of a station (`dobot up`), which records; its page shows why it cannot",
            ),
            Self::Ending => (problem_kinds::ENDING, "start it again: `dobot up`"),
            // Both texts state what is allowed.
            Self::OutOfRange { .. } => return (problem_kinds::OUT_OF_RANGE, None),
            Self::Malformed(_) => return (problem_kinds::MALFORMED, None),
            Self::BadSlots(_) => return (problem_kinds::BAD_SLOTS, None),
        };
        (kind, Some(hint.into()))
    }
}

fn lease_hint(holder: Option<&Holder>) -> &'static str {
    match holder {
        None => "take control: `dobot lease take` or `POST /api/v1/lease`",
        Some(Holder { is_program, .. }) if *is_program => {
            "a program on the raw port cannot answer requests; take control from it as an administrator: `dobot lease take` or `POST /api/v1/lease`"
        }
        Some(_) => "ask for control: `dobot lease ask` or `POST /api/v1/lease/ask`",
    }
}

/// Formats a time in minutes and seconds.
pub(crate) fn span(s: f64) -> String {
    let s = s.ceil();
    let (minutes, rest) = ((s / 60.0).floor(), s % 60.0);
    match (minutes > 0.0, rest > 0.0) {
        (false, _) => format!("{rest} s"),
        (true, false) => format!("{minutes} min"),
        (true, true) => format!("{minutes} min {rest} s"),
    }
}

impl From<SendError> for Refusal {
    fn from(error: SendError) -> Self {
        match error {
            SendError::LaserDisarmed => Self::LaserDisarmed,
            error => Self::Send(error),
        }
    }
}

impl From<Violation> for Refusal {
    fn from(violation: Violation) -> Self {
        Self::Policy(Box::new(violation))
    }
}

/// Returns the hint for a command that the session refused.
const fn send_hint(error: &SendError) -> Option<&'static str> {
    match error {
        SendError::Undecided { .. } => Some(
            "detect the dialect (`dobot detect` or `POST /api/v1/dialect/detect`), or set it: `--dialect firmware-1.1` or `PUT /api/v1/dialect` for an arm with its original firmware",
        ),
        SendError::Untrusted => Some(
            "check the arm; if it stands where its statuses say, confirm the pose: `dobot confirm` or `POST /api/v1/pose/confirm`",
        ),
        SendError::OnTheSpot => Some("use a JUMP"),
        _ => None,
    }
}

impl From<&Refusal> for Problem {
    fn from(refusal: &Refusal) -> Self {
        let (kind, hint) = refusal.row();
        let mut problem = kind.problem(refusal.to_string());
        problem.hint = hint.map(Cow::into_owned);
        if let Refusal::BadJob { rule, .. } = refusal {
            problem.rule.clone_from(rule);
        }
        if let Refusal::Policy(violation) = refusal {
            problem.rule = Some(violation.rule.clone());
            problem.nearest_mm = violation.nearest;
            problem.at_mm = violation.at.as_ref().map(|at| at.position_mm);
        }
        problem
    }
}

impl From<Refusal> for Problem {
    fn from(refusal: Refusal) -> Self {
        Self::from(&refusal)
    }
}
