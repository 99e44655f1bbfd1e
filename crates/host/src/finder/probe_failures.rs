//! Why no arm was found.

use std::fmt;
use std::io;

use dobot_session::{Address, OpenError};

/// Why no arm was found at a port.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ProbeFailure {
    /// The port cannot be opened.
    #[error("{}", open_text(.0))]
    Open(#[from] OpenError),
    /// Nothing was received.
    #[error("nothing was received for 5 s")]
    Silent,
    /// Something was received, but not from an arm.
    #[error("{bytes} bytes were received in 5 s, without a valid status")]
    Noise {
        /// The number of bytes.
        bytes: u64,
    },
    /// The port was closed at the other end, or unplugged.
    #[error("it was unplugged, or closed at the other end")]
    Closed,
    /// Reading failed.
    #[error("it broke: {0}")]
    Broken(#[source] io::Error),
    /// The port failed recently and is not tried again for a while.
    #[error("{why}; retrying later")]
    Before {
        /// The earlier failure.
        why: String,
    },
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
            Self::Silent => Some("switch the arm on".into()),
            Self::Noise { .. } => Some(
                "if it is an arm at another speed than 9600 baud, name the speed, as in serial:/dev/ttyUSB0@115200".into(),
            ),
            Self::Closed | Self::Broken(_) | Self::Before { .. } => None,
        }
    }

    /// Returns whether the port was opened, which may have disturbed the device.
    pub(super) const fn was_open(&self) -> bool {
        !matches!(self, Self::Open(_) | Self::Before { .. })
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
    fn a_port_that_is_not_allowed_is_told_with_what_helps() {
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
    fn no_port_at_all_says_so_and_names_a_few_of_those_not_tried() {
        let ports = ["a", "b", "c", "d", "e"].map(str::to_owned).into();
        let nothing = NothingFound::new(Vec::new(), ports);
        assert_eq!(
            nothing.to_string(),
            "no arm was found; there is no USB serial port; not tried unless named: a, b, c and 2 more"
        );
        assert!(nothing.hint().contains("dobot ports"), "{}", nothing.hint());
    }

    #[test]
    fn ports_that_cannot_be_listed_are_told() {
        let nothing = NothingFound::new(vec![(address(), ProbeFailure::Silent)], Vec::new());
        let error = io::Error::other("no /sys");
        let text = nothing.without_list(&error).to_string();
        assert!(text.contains("cannot be listed: no /sys"), "{text}");
        assert!(text.contains("nothing was received"), "{text}");
    }
}
