//! What went wrong, what to do about it, and the exit code.

use std::process::ExitCode;

use dobot_api::{ConnectError, NotBuilt, RemoteError};
use dobot_draw::OptionsError;
use dobot_host::{NoArm, OpenArmError};
use dobot_session::{LinkError, OpenError, SendError};

use crate::drawing_options::with_option_names;
use crate::logging::LogFormat;

/// What went wrong.
#[derive(Debug)]
pub(crate) struct Failure {
    error: anyhow::Error,
    hint: Option<String>,
}

impl Failure {
    /// A failure with something to do about it.
    pub(crate) fn new(error: impl Into<anyhow::Error>, hint: impl Into<String>) -> Self {
        Self {
            error: error.into(),
            hint: Some(hint.into()),
        }
    }

    /// The same failure; where nothing else helps, this may.
    pub(crate) fn or_hint(mut self, hint: impl FnOnce() -> Option<String>) -> Self {
        self.hint = self.hint().or_else(hint);
        self
    }

    /// What went wrong, in one line.
    pub(crate) fn detail(&self) -> String {
        with_option_names(&format!("{:#}", self.error))
    }

    /// What to do about it.
    pub(crate) fn hint(&self) -> Option<String> {
        let causes = self.error.chain().find_map(known_hint);
        let hint = self.hint.clone().or(causes);
        hint.map(|hint| with_option_names(&hint))
    }

    /// Tells the person, and gives the exit code. Output that nobody wants to read any more, as
    /// with `dobot decode FILE | head`, is no failure.
    pub(crate) fn report(&self, log: LogFormat) -> ExitCode {
        let causes = || self.error.chain();
        let unread = |cause: &(dyn std::error::Error + 'static)| {
            let io = cause.downcast_ref::<std::io::Error>();
            io.is_some_and(|it| it.kind() == std::io::ErrorKind::BrokenPipe)
        };
        if causes().any(unread) {
            return ExitCode::SUCCESS;
        }
        let hint = self.hint();
        match log {
            LogFormat::Text => {
                eprintln!("error: {}", self.detail());
                hint.inspect(|it| eprintln!("hint: {it}"));
            }
            LogFormat::Json => {
                tracing::error!(hint, "{}", self.detail());
                crate::stderr::flush();
            }
        }
        ExitCode::FAILURE
    }
}

impl<E: Into<anyhow::Error>> From<E> for Failure {
    fn from(error: E) -> Self {
        Self {
            error: error.into(),
            hint: None,
        }
    }
}

/// What helps against the failures that any verb may meet.
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
    let link = cause.downcast_ref::<LinkError>();
    let send = match link {
        Some(LinkError::Send(error)) => Some(error),
        _ => cause.downcast_ref::<SendError>(),
    };
    let hint = send
        .and_then(send_hint)
        .or_else(|| link.and_then(link_hint));
    hint.map(str::to_owned)
}

const fn send_hint(error: &SendError) -> Option<&'static str> {
    match error {
        SendError::Undecided { .. } => Some(
            "say which: `--dialect firmware-1.1` for an arm as it was sold, `--dialect specification` for one that follows the published protocol",
        ),
        SendError::OnTheSpot => Some("`--path jump` goes there without harm"),
        _ => None,
    }
}

const fn link_hint(error: &LinkError) -> Option<&'static str> {
    match error {
        LinkError::Silent { noise: 0, .. } => {
            Some("is the arm switched on, and is this its port? `dobot ports` lists them")
        }
        LinkError::Silent { .. } => Some(
            "wrong line speed or not a Dobot Arm? 9600 is usual; a green board wants `@256000` behind the port",
        ),
        LinkError::Closed | LinkError::Broken(_) => Some(
            "is the arm still plugged in and switched on? over TCP it serves one client at a time",
        ),
        LinkError::NotReached { .. } => {
            Some("`dobot status` tells where the arm is; a nearer target may be allowed")
        }
        _ => None,
    }
}
