//! Old programs, which speak the arm's own protocol: what is known of them.

use std::path::PathBuf;

/// What happens to the programs that speak the arm's own protocol.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ProgramNews {
    /// A program came.
    Came {
        /// The name by which the station knows it.
        name: String,
    },
    /// A program was turned away: one at a time is served.
    TurnedAway {
        /// What would have been its name.
        name: String,
        /// The program that is served.
        by: String,
    },
    /// The program left.
    Left {
        /// Its name.
        name: String,
        /// What it sent and got.
        traffic: Traffic,
    },
    /// The virtual serial port has another name now: a program that was killed left the old one
    /// locked.
    PortMoved(PathBuf),
    /// No program can come for now; it is tried again.
    Trouble(String),
}

impl ProgramNews {
    /// What a person should know of it, in one line; `None` for what is as it should be.
    #[must_use]
    pub fn trouble(&self) -> Option<String> {
        match self {
            Self::Came { .. } => None,
            Self::TurnedAway { name, by } => Some(format!(
                "{name} was turned away: {by} is served, and one at a time is"
            )),
            Self::Left { name, traffic } => {
                let trouble = traffic.trouble()?;
                Some(format!("{name} left: {trouble}"))
            }
            Self::PortMoved(path) => Some(format!(
                "the virtual serial port is {} now: a program that was killed left the old one locked",
                path.display()
            )),
            Self::Trouble(text) => Some(text.clone()),
        }
    }
}

/// What a program that speaks the arm's own protocol sent and got.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Traffic {
    /// Packets that it sent.
    pub packets: u64,
    /// How many of them were refused.
    pub refused: u64,
    /// Bytes that it sent and that belong to no packet.
    pub damaged_bytes: u64,
    /// Statuses that it got.
    pub statuses: u64,
    /// Statuses that it did not get, because it did not read those before.
    pub lost_statuses: u64,
    /// It was no program but a web page in a browser, and was cut off: its packets would have come
    /// from anywhere.
    pub web: bool,
}

impl Traffic {
    /// What was wrong with it, in words; `None` where nothing was.
    fn trouble(&self) -> Option<String> {
        if self.web {
            return Some("it was a page in a web browser, and was cut off".into());
        }
        let wrong = [
            (self.refused, "packets were refused"),
            (self.damaged_bytes, "bytes belonged to no packet"),
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
    fn noise_on_the_raw_port_is_counted_and_told_when_its_program_leaves() {
        let traffic = Traffic {
            packets: 3,
            damaged_bytes: 17,
            ..Traffic::default()
        };
        let name = "raw program 127.0.0.1:4000".to_owned();
        let told = ProgramNews::Left { name, traffic }.trouble();
        assert_eq!(
            told.as_deref(),
            Some(
                "raw program 127.0.0.1:4000 left: of 3 packets and their statuses 17 bytes belonged to no packet"
            )
        );
    }

    #[test]
    fn a_program_that_does_nothing_wrong_is_no_news() {
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
