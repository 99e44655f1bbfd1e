//! Why no arm was found.

use std::fmt;
use std::io;

use dobot_api::{LinkCause, LinkProblem};
use dobot_session::{Address, LinkError, NoStatus, OpenError};
use dobot_supervisor::cause_of_silence;

/// Why no arm was found at a port.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ProbeFailure {
    /// The port cannot be opened.
    #[error("{}", open_text(.0))]
    Open(#[from] OpenError),
    /// No valid status was received.
    #[error("{0} for 5 s")]
    NoStatus(NoStatus),
    /// The port was closed at the other end, unplugged, or failed.
    #[error("{}{}", .error, received_text(.received))]
    Link {
        /// The error.
        error: LinkError,
        /// What was received before.
        received: NoStatus,
    },
    /// The port failed recently and is not tried again for a while.
    #[error("{}; retrying later", .0.text)]
    Before(LinkProblem),
}

/// The error returned when no arm was found, with the failure of each port.
#[derive(Debug)]
pub struct NothingFound {
    /// The failure of each port tried.
    pub failures: Vec<(Address, ProbeFailure)>,
    /// Ports that are tried only when named.
    pub passed_over: Vec<String>,
    /// Why the ports of this machine could not be listed.
    pub unlisted: Option<String>,
}

impl ProbeFailure {
    /// Returns a hint on how to fix it.
    #[must_use]
    pub fn hint(&self) -> Option<String> {
        match self {
            Self::Open(error) => error.hint(),
            Self::Link {
                error,
                received: NoStatus::Nothing,
            } => error.hint().map(str::to_owned),
            Self::NoStatus(received) | Self::Link { received, .. } => {
                Some(received.hint().to_owned())
            }
            Self::Before(problem) => problem.remedy.clone(),
        }
    }

    /// Returns the kind of the failure.
    #[must_use]
    pub const fn cause(&self) -> LinkCause {
        match self {
            Self::Open(error) => cause_of_open(error),
            Self::Link {
                error,
                received: NoStatus::Nothing,
            } => cause_of_link(error),
            Self::NoStatus(received) | Self::Link { received, .. } => cause_of_silence(received),
            Self::Before(problem) => problem.cause,
        }
    }

    /// Returns the failure with its kind and hint.
    pub(super) fn problem(&self) -> LinkProblem {
        LinkProblem {
            cause: self.cause(),
            text: self.to_string(),
            remedy: self.hint(),
        }
    }

    /// Returns whether the port was opened, which may have disturbed the device.
    pub(super) const fn was_open(&self) -> bool {
        !matches!(self, Self::Open(_) | Self::Before(_))
    }
}

impl NothingFound {
    pub(super) const fn new(
        failures: Vec<(Address, ProbeFailure)>,
        passed_over: Vec<String>,
    ) -> Self {
        Self {
            failures,
            passed_over,
            unlisted: None,
        }
    }

    pub(super) fn without_list(self, error: &io::Error) -> Self {
        Self {
            unlisted: Some(error.to_string()),
            ..self
        }
    }

    /// Returns a hint on how to fix it.
    #[must_use]
    pub fn hint(&self) -> String {
        let hint = self.failures.iter().find_map(|(_, failure)| failure.hint());
        hint.unwrap_or_else(|| {
            "plug the arm in and switch it on; list the serial ports with `dobot ports`".into()
        })
    }

    /// Returns the failures as one problem, with the kind of the first one that has a hint.
    #[must_use]
    pub fn problem(&self) -> LinkProblem {
        let mut failures = self.failures.iter().map(|(_, failure)| failure);
        let first = failures
            .find(|failure| failure.hint().is_some())
            .or_else(|| self.failures.first().map(|(_, failure)| failure));
        let text = match &self.failures[..] {
            [(address, failure)] => format!("{address}: {failure}"),
            _ => self.to_string(),
        };
        LinkProblem {
            cause: first.map_or(LinkCause::NoneFound, ProbeFailure::cause),
            text,
            remedy: Some(self.hint()),
        }
    }
}

impl fmt::Display for NothingFound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("no arm was found")?;
        if let Some(error) = &self.unlisted {
            write!(f, "; the ports of this machine cannot be listed: {error}")?;
        } else if self.failures.is_empty() {
            f.write_str("; there is no USB serial port")?;
        }
        for (address, failure) in &self.failures {
            write!(f, "; {address}: {failure}")?;
        }
        if !self.passed_over.is_empty() {
            let ports = listed(&self.passed_over);
            write!(f, "; not tried unless named: {ports}")?;
        }
        Ok(())
    }
}

impl std::error::Error for NothingFound {}

const fn cause_of_open(error: &OpenError) -> LinkCause {
    match error {
        OpenError::NoSuchPort { .. } => LinkCause::NoSuchPort,
        OpenError::NotAllowed { .. } => LinkCause::NotAllowed,
        OpenError::InUse { .. } => LinkCause::InUse,
        OpenError::NotASerialPort { .. } => LinkCause::NotASerialPort,
        OpenError::Tcp { .. } => LinkCause::Unreachable,
        _ => LinkCause::CannotOpen,
    }
}

/// Returns the kind of an error of an open link.
pub(crate) const fn cause_of_link(error: &LinkError) -> LinkCause {
    match error {
        LinkError::Closed => LinkCause::Closed,
        _ => LinkCause::Broken,
    }
}

/// Returns what was received, to follow an error.
fn received_text(received: &NoStatus) -> String {
    match received {
        NoStatus::Nothing => String::new(),
        received => format!("; {received}"),
    }
}

/// Returns the error and the operating system's error.
fn open_text(error: &OpenError) -> String {
    match std::error::Error::source(error) {
        Some(source) => format!("{error}: {source}"),
        None => error.to_string(),
    }
}

/// Lists the first few by name.
fn listed(ports: &[String]) -> String {
    match ports.get(NAMED..) {
        Some(more) if !more.is_empty() => {
            format!("{} and {} more", ports[..NAMED].join(", "), more.len())
        }
        _ => ports.join(", "),
    }
}

/// A machine has dozens of `/dev/ttyS*`.
const NAMED: usize = 3;

#[cfg(test)]
mod tests {
    use super::*;

    fn address() -> Address {
        "serial:/dev/ttyUSB0".parse().expect("it is one")
    }

    #[test]
    fn a_port_without_permission_is_reported_with_a_remedy() {
        let error = OpenError::NotAllowed {
            path: "/dev/ttyUSB0".into(),
            group: Some("dialout".into()),
        };
        let nothing = NothingFound::new(vec![(address(), error.into())], Vec::new());
        assert_eq!(
            nothing.to_string(),
            "no arm was found; serial:/dev/ttyUSB0@9600: this user may not open /dev/ttyUSB0"
        );
        assert!(
            nothing.hint().contains("usermod -aG dialout"),
            "{}",
            nothing.hint()
        );
    }

    #[test]
    fn a_missing_port_is_reported_with_a_few_of_the_ports_not_tried() {
        let ports = ["a", "b", "c", "d", "e"].map(str::to_owned).into();
        let nothing = NothingFound::new(Vec::new(), ports);
        assert_eq!(
            nothing.to_string(),
            "no arm was found; there is no USB serial port; not tried unless named: a, b, c and 2 more"
        );
        assert!(nothing.hint().contains("dobot ports"), "{}", nothing.hint());
    }

    #[test]
    fn a_failure_to_list_the_ports_is_reported() {
        let nothing = NothingFound::new(
            vec![(address(), ProbeFailure::NoStatus(NoStatus::Nothing))],
            Vec::new(),
        );
        let error = io::Error::other("no /sys");
        let text = nothing.without_list(&error).to_string();
        assert!(text.contains("cannot be listed: no /sys"), "{text}");
        assert!(text.contains("nothing was received"), "{text}");
    }
}
