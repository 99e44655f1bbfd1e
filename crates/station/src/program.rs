//! Legacy programs, which speak the arm's own protocol.

use std::path::PathBuf;

/// An event of a program that speaks the arm's own protocol.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ProgramNews {
    /// A program connected.
    Came {
        /// Its name at the station.
        name: String,
    },
    /// A program was turned away: one at a time is served.
    TurnedAway {
        /// Its name, if it had been admitted.
        name: String,
        /// The program that is being served.
        by: String,
    },
    /// A program left.
    Left {
        /// Its name.
        name: String,
        /// Its traffic.
        traffic: Traffic,
    },
    /// The virtual serial port has a new name: a killed program left the old one locked.
    PortMoved(PathBuf),
    /// The port accepts no connections; it is retried.
    Trouble(String),
}

impl ProgramNews {
    /// Returns a line for the user; `None` if there is no problem.
    #[must_use]
    pub fn trouble(&self) -> Option<String> {
        match self {
            Self::Came { .. } => None,
            Self::TurnedAway { name, by } => Some(format!(
                "{name} was turned away: {by} is being served, and only one program is served at a time"
            )),
            Self::Left { name, traffic } => {
                let trouble = traffic.trouble()?;
                Some(format!("{name} left: {trouble}"))
            }
            Self::PortMoved(path) => Some(format!(
                "the virtual serial port is now {}: a killed program left the old one locked",
                path.display()
            )),
            Self::Trouble(text) => Some(text.clone()),
        }
    }
}

/// The traffic of a program that speaks the arm's own protocol.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Traffic {
    /// Packets sent by the program.
    pub packets: u64,
    /// Packets that were refused.
    pub refused: u64,
    /// Bytes from the program outside of packets.
    pub damaged_bytes: u64,
    /// Statuses sent to the program.
    pub statuses: u64,
    /// Statuses that were lost because the program did not read earlier ones.
    pub lost_statuses: u64,
    /// Whether it was a web page in a browser and was disconnected: its packets could have come
    /// from any site.
    pub web: bool,
}

impl Traffic {
    /// Returns the problems of a program; `None` if there were none.
    fn trouble(&self) -> Option<String> {
        if self.web {
            return Some("it was a page in a web browser and was disconnected".into());
        }
        let wrong = [
            (self.refused, "packets were refused"),
            (self.damaged_bytes, "bytes were outside of packets"),
            (self.lost_statuses, "statuses were not read in time"),
        ];
        let wrong: Vec<String> = wrong
            .iter()
            .filter(|(count, _)| *count > 0)
            .map(|(count, what)| format!("{count} {what}"))
            .collect();
        let packets = self.packets;
        (!wrong.is_empty()).then(|| {
            format!(
                "of {packets} packets and their statuses {}",
                wrong.join(", ")
            )
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_on_the_raw_port_is_counted_and_reported_when_its_client_leaves() {
        let traffic = Traffic {
            packets: 3,
            damaged_bytes: 17,
            ..Traffic::default()
        };
        let name = "a program on this computer (port 4000)".to_owned();
        let trouble = ProgramNews::Left { name, traffic }.trouble();
        assert_eq!(
            trouble.as_deref(),
            Some(
                "a program on this computer (port 4000) left: of 3 packets and their statuses 17 bytes were outside of packets"
            )
        );
    }

    #[test]
    fn a_client_without_errors_is_not_reported() {
        let (name, traffic) = (
            "a program".to_owned(),
            Traffic {
                packets: 9,
                ..Traffic::default()
            },
        );
        assert_eq!(ProgramNews::Left { name, traffic }.trouble(), None);
    }
}
