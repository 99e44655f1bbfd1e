//! Failures: an error, a hint and the exit code.

use std::ffi::OsString;
use std::process::ExitCode;

use dobot_api::{ConnectError, NotBuilt, RemoteError};
use dobot_draw::OptionsError;
use dobot_host::{NoArm, OpenArmError};
use dobot_session::{LinkError, OpenError, SendError};

use serde_json::json;

use crate::drawing_options::with_option_names;

/// A failure of a verb.
#[derive(Debug)]
pub(crate) struct Failure {
    error: anyhow::Error,
    hint: Option<String>,
    kind: FailureKind,
}

/// The kind of a failure, which determines its exit code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum FailureKind {
    Failed,
    /// An option has an invalid value.
    Usage,
    /// The job waits for a person; it did not fail.
    Waiting {
        job: u64,
    },
}

/// The form of an error on standard error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ErrorFormat {
    /// Lines for people.
    Text,
    /// One JSON object with `error`, `hint` and `exit_code`.
    Json,
    /// An event of the log.
    Log,
}

impl ErrorFormat {
    /// The form that a command line asks for: JSON with `--json`.
    pub(crate) fn of(words: &[OsString]) -> Self {
        let mut options = words.iter().take_while(|word| *word != "--");
        if options.any(|word| word == "--json") {
            Self::Json
        } else {
            Self::Text
        }
    }
}

impl Failure {
    /// Creates a failure with a hint.
    pub(crate) fn new(error: impl Into<anyhow::Error>, hint: impl Into<String>) -> Self {
        Self {
            error: error.into(),
            hint: Some(hint.into()),
            kind: FailureKind::Failed,
        }
    }

    /// Creates a failure of an invalid option value.
    pub(crate) fn usage(error: impl Into<anyhow::Error>) -> Self {
        Self {
            kind: FailureKind::Usage,
            ..Self::from(error)
        }
    }

    /// Creates the end of a run in which a job waits for a person to do something.
    pub(crate) fn waiting(job: u64, what: impl Into<anyhow::Error>, hint: String) -> Self {
        Self {
            kind: FailureKind::Waiting { job },
            ..Self::new(what, hint)
        }
    }

    /// Adds a hint.
    pub(crate) fn with_hint(self, hint: impl Into<String>) -> Self {
        Self {
            hint: Some(hint.into()),
            ..self
        }
    }

    /// Adds a hint unless the failure has one.
    pub(crate) fn or_hint(mut self, hint: impl FnOnce() -> Option<String>) -> Self {
        self.hint = self.hint().or_else(hint);
        self
    }

    /// The error message, in one line.
    pub(crate) fn detail(&self) -> String {
        with_option_names(&format!("{:#}", self.error))
    }

    /// The hint, if there is a remedy.
    pub(crate) fn hint(&self) -> Option<String> {
        let causes = self.error.chain().find_map(known_hint);
        let hint = self.hint.clone().or(causes);
        hint.map(|hint| with_option_names(&hint))
    }

    /// Prints the failure and returns the exit code. Output that is no longer read, as with
    /// `dobot decode FILE | head`, is no failure.
    pub(crate) fn report(&self, format: ErrorFormat) -> ExitCode {
        let causes = || self.error.chain();
        let unread = |cause: &(dyn std::error::Error + 'static)| {
            let io = cause.downcast_ref::<std::io::Error>();
            io.is_some_and(|error| error.kind() == std::io::ErrorKind::BrokenPipe)
        };
        if causes().any(unread) {
            return ExitCode::SUCCESS;
        }
        let (code, detail, hint) = (self.exit_code(), self.detail(), self.hint());
        match self.kind {
            FailureKind::Waiting { job } => {
                print_waiting(format, job, &detail, &hint.unwrap_or_default(), code);
            }
            _ => print_error(format, &detail, hint.as_deref(), code),
        }
        code.into()
    }

    /// 3 for a job that waits for a person, 2 for an invalid option or value, otherwise 1.
    fn exit_code(&self) -> u8 {
        match self.kind {
            FailureKind::Waiting { .. } => 3,
            FailureKind::Usage => 2,
            FailureKind::Failed if self.error.chain().any(is_invalid_option) => 2,
            FailureKind::Failed => 1,
        }
    }
}

/// Whether an error is an option that no drawing may have, or that does not fit what is drawn.
fn is_invalid_option(cause: &(dyn std::error::Error + 'static)) -> bool {
    let error = cause.downcast_ref::<OptionsError>();
    error.is_some_and(|error| {
        use OptionsError::{DoesNotFit, NoSurface, Prepare};
        !matches!(error, DoesNotFit { .. } | Prepare(_) | NoSurface)
    })
}

/// Prints an error and its hint.
pub(crate) fn print_error(format: ErrorFormat, error: &str, hint: Option<&str>, exit_code: u8) {
    match format {
        ErrorFormat::Text => {
            eprintln!("error: {error}");
            if let Some(hint) = hint {
                eprintln!("hint: {hint}");
            }
        }
        ErrorFormat::Json => {
            let mut object = json!({ "error": error, "exit_code": exit_code });
            if let Some(hint) = hint {
                object["hint"] = hint.into();
            }
            eprintln!("{object}");
        }
        ErrorFormat::Log => {
            tracing::error!(hint, "{error}");
            crate::stderr::flush();
        }
    }
}

/// Prints what a job waits for, in one line.
fn print_waiting(format: ErrorFormat, job: u64, what: &str, hint: &str, exit_code: u8) {
    let line = format!("job {job} waits: {what}; {hint}");
    match format {
        ErrorFormat::Text => eprintln!("{line}"),
        ErrorFormat::Json => {
            let object =
                json!({ "job": job, "waits_for": what, "hint": hint, "exit_code": exit_code });
            eprintln!("{object}");
        }
        ErrorFormat::Log => {
            tracing::warn!(job, hint, "{what}");
            crate::stderr::flush();
        }
    }
}

impl<E: Into<anyhow::Error>> From<E> for Failure {
    fn from(error: E) -> Self {
        Self {
            error: error.into(),
            hint: None,
            kind: FailureKind::Failed,
        }
    }
}

/// Returns the hint for a failure that any verb may have.
fn known_hint(cause: &(dyn std::error::Error + 'static)) -> Option<String> {
    if let Some(error) = cause.downcast_ref::<OpenError>() {
        return error.hint();
    }
    if let Some(OpenArmError::Open(error)) = cause.downcast_ref::<OpenArmError>() {
        return error.hint();
    }
    if let Some(error) = cause.downcast_ref::<OptionsError>() {
        return error.hint();
    }
    if let Some(error) = cause.downcast_ref::<ConnectError>() {
        return error.hint();
    }
    if let Some(error) = cause.downcast_ref::<RemoteError>() {
        return error.hint();
    }
    if let Some(error) = cause.downcast_ref::<NoArm>() {
        return error.hint();
    }
    if cause.is::<NotBuilt>() {
        return Some(NotBuilt::HINT.into());
    }
    transport_hint(cause).map(str::to_owned)
}

fn transport_hint(cause: &(dyn std::error::Error + 'static)) -> Option<&'static str> {
    let link = cause.downcast_ref::<LinkError>();
    let send = match link {
        Some(LinkError::Send(error)) => Some(error),
        _ => cause.downcast_ref::<SendError>(),
    };
    send.and_then(send_hint)
        .or_else(|| link.and_then(link_hint))
}

const fn send_hint(error: &SendError) -> Option<&'static str> {
    match error {
        SendError::Undecided { .. } => Some(
            "name its dialect: `--dialect firmware-1.1` for an arm as sold, `--dialect specification` for the published protocol; or find out with `dobot detect`",
        ),
        SendError::OnTheSpot => Some("use `--path jump`, which is safe there"),
        _ => None,
    }
}

const fn link_hint(error: &LinkError) -> Option<&'static str> {
    match error {
        LinkError::NotReached { .. } => {
            Some("run `dobot status` to see where the arm is; a nearer target may be allowed")
        }
        _ => error.hint(),
    }
}
