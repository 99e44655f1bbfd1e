//! Detection of a desktop on which the page can be opened.

use std::env::var_os;
use std::io::IsTerminal;

/// The environment of the process.
#[derive(Clone, Copy, Debug)]
pub(super) struct Surroundings {
    /// Whether standard output is a terminal; a service and a script have none.
    pub(super) terminal: bool,
    /// Whether the terminal is at another computer.
    pub(super) remote: bool,
    /// Whether windows can be opened.
    pub(super) windows: bool,
}

impl Surroundings {
    pub(super) fn detect() -> Self {
        let any = |names: &[&str]| names.iter().any(|name| var_os(name).is_some());
        Self {
            terminal: std::io::stdout().is_terminal(),
            remote: any(&["SSH_CONNECTION", "SSH_CLIENT", "SSH_TTY"]),
            windows: cfg!(any(windows, target_os = "macos"))
                || any(&["DISPLAY", "WAYLAND_DISPLAY"]),
        }
    }

    /// Whether a person sits at a desktop of this computer.
    pub(super) const fn have_a_desktop(self) -> bool {
        self.terminal && self.windows && !self.remote
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const DESK: Surroundings = Surroundings {
        terminal: true,
        remote: false,
        windows: true,
    };

    #[test]
    fn a_page_is_opened_at_a_desk_and_never_over_ssh_in_a_service_or_a_script() {
        assert!(DESK.have_a_desktop());
        let elsewhere = [
            Surroundings {
                terminal: false,
                ..DESK
            },
            Surroundings {
                remote: true,
                ..DESK
            },
            Surroundings {
                windows: false,
                ..DESK
            },
        ];
        assert!(
            elsewhere
                .iter()
                .all(|surroundings| !surroundings.have_a_desktop())
        );
    }
}
