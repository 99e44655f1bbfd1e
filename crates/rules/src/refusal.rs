//! Why the station does not do what a client asks.

use dobot_client::SendError;
use dobot_safety::Violation;

use dobot_api::{JobPhase, Problem, Role};

/// Why the station does not do what a client asks. Nothing has changed then.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Refusal {
    /// The client's role is not enough.
    #[error("this takes the role {needed}; this client has {found}")]
    Role {
        /// What it takes.
        needed: Role,
        /// What the client has.
        found: Role,
    },
    /// The client does not have control.
    #[error("{}", match holder { Some(Holder { name, .. }) => format!("{name} has control of the arm"), None => "nobody has control of the arm; this client has to take it first".to_owned() })]
    NoLease {
        /// Who has it.
        holder: Option<Holder>,
    },
    /// Nobody of that number asked for control.
    #[error("client {0} does not ask for control")]
    NotAsking(u64),
    /// The arm is stopped until a person resets that.
    #[error("the arm was stopped by {by}{}", reason.as_ref().map(|it| format!(": {it}")).unwrap_or_default())]
    Stopped {
        /// Who stopped it.
        by: String,
        /// Why.
        reason: Option<String>,
    },
    /// The arm has not come to rest yet after a stop.
    #[error("the arm still moves; it rests within {within_s:.1} s")]
    StillMoving {
        /// How long that takes at the most.
        within_s: f64,
    },
    /// The station let go of a button that is still pressed.
    #[error("the button was let go: {0}")]
    LetGo(String),
    /// There is no arm to talk to.
    #[error("there is no link to an arm: {0}")]
    NoLink(String),
    /// The session does not send it.
    #[error(transparent)]
    Send(SendError),
    /// The policy does not allow it.
    #[error(transparent)]
    Policy(Box<Violation>),
    /// The laser is not armed.
    #[error("the laser is disarmed")]
    LaserDisarmed,
    /// A number is not allowed.
    #[error("{name} is {found}; allowed is {allowed}")]
    OutOfRange {
        /// Which number.
        name: &'static str,
        /// What was given.
        found: f64,
        /// What is allowed.
        allowed: String,
    },
    /// Too much waits already.
    #[error("{waiting} commands wait already, and more than {most} may not")]
    TooMany {
        /// How many wait.
        waiting: usize,
        /// How many may.
        most: usize,
    },
    /// A job has the arm.
    #[error("job {0} has the arm")]
    JobRunning(u64),
    /// The arm is finding out its dialect.
    #[error("the arm makes the motions that tell its dialect")]
    Detecting,
    /// The motions that tell the dialect did not tell it.
    #[error("the dialect was not found: {0}")]
    NotFound(String),
    /// No job runs.
    #[error("no job is running")]
    NoJobRuns,
    /// There is no such job.
    #[error("there is no job {0}")]
    NoSuchJob(u64),
    /// A job is not in a phase that allows this.
    #[error("job {job} is {found:?}; this takes one that is {allowed}", found = format!("{found:?}").to_lowercase())]
    JobPhase {
        /// Its number.
        job: u64,
        /// How far it is.
        found: JobPhase,
        /// How far it would have to be.
        allowed: &'static str,
    },
    /// A job has no vectors whose speed or height could be changed.
    #[error("job {0} has no write vectors: its speed and height are those of its targets")]
    NoVectors(u64),
    /// A job cannot be done as it is.
    #[error("command {index} of the job: {why}")]
    BadJob {
        /// Which command, from 0.
        index: usize,
        /// What is wrong with it.
        why: String,
    },
    /// A job cannot be gone on with as things are.
    #[error("the job cannot be gone on with: {0}")]
    CannotResume(String),
    /// The journal cannot be written.
    #[error("the journal of jobs cannot be written: {0}")]
    Journal(String),
    /// The request cannot be understood.
    #[error("the request cannot be understood: {0}")]
    Malformed(String),
    /// The station ends.
    #[error("the station is shutting down")]
    Ending,
}

/// Who has control.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Holder {
    /// What it calls itself.
    pub name: String,
    /// Whether it is a program on the raw port, which cannot be asked.
    pub is_program: bool,
}

impl Refusal {
    /// The kind of refusal: the last part of the problem type's address.
    #[must_use]
    pub const fn kind(&self) -> &'static str {
        match self {
            Self::Role { .. } => "role",
            Self::NoLease { .. } => "no-lease",
            Self::NotAsking(_) => "not-asking",
            Self::Stopped { .. } => "stopped",
            Self::StillMoving { .. } => "still-moving",
            Self::LetGo(_) => "let-go",
            Self::NoLink(_) => "no-link",
            Self::Send(_) => "command",
            Self::Policy(_) => "policy",
            Self::LaserDisarmed => "laser-disarmed",
            Self::OutOfRange { .. } => "out-of-range",
            Self::TooMany { .. } => "too-many",
            Self::JobRunning(_) => "job-running",
            Self::Detecting => "detecting",
            Self::NotFound(_) => "dialect-not-found",
            Self::NoJobRuns => "no-job-runs",
            Self::NoSuchJob(_) => "no-such-job",
            Self::JobPhase { .. } => "job-phase",
            Self::NoVectors(_) => "no-vectors",
            Self::BadJob { .. } => "bad-job",
            Self::CannotResume(_) => "cannot-resume",
            Self::Journal(_) => "journal",
            Self::Malformed(_) => "malformed",
            Self::Ending => "ending",
        }
    }

    /// What to do about it.
    #[must_use]
    pub fn hint(&self) -> Option<String> {
        Some(match self {
            Self::Role { needed, .. } => format!("use a token with the role {needed}"),
            Self::NoLease { holder: None } => "take the lease".into(),
            Self::NoLease {
                holder: Some(Holder { is_program: true, .. }),
            } => "a program on the raw port cannot be asked; on this machine, take control from it: `dobot lease take`".into(),
            Self::NoLease { .. } => "ask the holder for the lease: `dobot lease ask`".into(),
            Self::Stopped { .. } => {
                "look at the arm; when it may move again, `dobot stop --reset`".into()
            }
            Self::StillMoving { .. } => "wait until it rests".into(),
            Self::LetGo(_) => "let go of the button, then press it again".into(),
            Self::NoLink(_) => "`dobot watch` shows what the station waits for".into(),
            Self::Send(error) => return send_hint(error),
            Self::Policy(_) => "`dobot policy` shows the rules".into(),
            Self::LaserDisarmed => {
                "put the goggles on, then arm the laser for a while, with the client that is to use it: `--arm-laser 600` of `dobot jog` and `dobot jobs start`"
                    .into()
            }
            Self::TooMany { .. } => "wait until some are over, or send them as a job".into(),
            Self::JobRunning(_) => "pause it: `dobot jobs pause`".into(),
            Self::Detecting => "wait until it is done, or stop it: `dobot stop`".into(),
            Self::NoJobRuns | Self::NoSuchJob(_) | Self::JobPhase { .. } => {
                "`dobot jobs` lists the jobs".into()
            }
            Self::Journal(_) => "make room on the disk, or check the folder's permissions".into(),
            Self::NotFound(_) => {
                "see that nothing is in the arm's way and that its cable sits well, then `dobot detect` again; or say which dialect it is: `--dialect firmware-1.1` for an arm as it was sold"
                    .into()
            }
            Self::NoVectors(_) => "`dobot set percent` changes the speed of targets".into(),
            Self::BadJob { .. } => "change that command, and submit the job again".into(),
            Self::CannotResume(_) => "`dobot jobs` says how far it is; `dobot jobs cancel` ends it".into(),
            Self::NotAsking(_) => "`dobot lease` shows who asks".into(),
            Self::Ending => "`dobot up` starts it again".into(),
            // Both say what is allowed.
            Self::OutOfRange { .. } | Self::Malformed(_) => return None,
        })
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

/// What helps against a command that the session does not send.
fn send_hint(error: &SendError) -> Option<String> {
    match error {
        SendError::Undecided { .. } => Some(
            "find out with `dobot detect`, or say which: `--dialect firmware-1.1` for an arm as it was sold"
                .into(),
        ),
        SendError::Untrusted => {
            Some("look at the arm; where it stands as its statuses say, confirm it: `dobot confirm`".into())
        }
        SendError::OnTheSpot => Some("a JUMP goes there without harm".into()),
        _ => None,
    }
}

impl From<&Refusal> for Problem {
    fn from(refusal: &Refusal) -> Self {
        let (title, status) = title_and_status(refusal);
        let mut problem = Self::new(refusal.kind(), title, status, refusal.to_string());
        problem.hint = refusal.hint();
        if let Refusal::Policy(violation) = refusal {
            problem.rule = Some(violation.rule.clone());
            problem.nearest_mm = violation.nearest;
            problem.at_mm = violation.at.as_ref().map(|it| it.position_mm);
        }
        problem
    }
}

impl From<Refusal> for Problem {
    fn from(refusal: Refusal) -> Self {
        Self::from(&refusal)
    }
}

const fn title_and_status(refusal: &Refusal) -> (&'static str, u16) {
    match refusal {
        Refusal::Role { .. } => ("the role does not allow this", 403),
        Refusal::NoLease { .. } => ("this client does not have control", 409),
        Refusal::NotAsking(_) => ("nobody asks for control", 409),
        Refusal::Stopped { .. } => ("the arm is stopped", 409),
        Refusal::StillMoving { .. } => ("the arm still moves", 409),
        Refusal::LetGo(_) => ("the button was let go", 409),
        Refusal::NoLink(_) => ("there is no arm", 503),
        Refusal::Send(_) => ("the command is not sent", 422),
        Refusal::Policy(_) => ("the policy does not allow this", 422),
        Refusal::LaserDisarmed => ("the laser is disarmed", 409),
        Refusal::OutOfRange { .. } => ("a number is not allowed", 422),
        Refusal::TooMany { .. } => ("too much waits already", 429),
        Refusal::JobRunning(_) => ("a job has the arm", 409),
        Refusal::Detecting => ("the arm is finding out its dialect", 409),
        Refusal::NotFound(_) => ("the dialect was not found", 422),
        Refusal::NoJobRuns => ("no job is running", 409),
        Refusal::NoSuchJob(_) => ("there is no such job", 404),
        Refusal::JobPhase { .. } => ("the job does not allow this now", 409),
        Refusal::NoVectors(_) => ("the job has no vectors", 409),
        Refusal::BadJob { .. } => ("the job cannot be done", 422),
        Refusal::CannotResume(_) => ("the job cannot be gone on with", 409),
        Refusal::Journal(_) => ("the journal cannot be written", 507),
        Refusal::Malformed(_) => ("the request cannot be understood", 400),
        Refusal::Ending => ("the station is shutting down", 503),
    }
}
