//! The file of stops, which survives restarts of the station.

use std::io;
use std::path::PathBuf;

use dobot_supervisor::{SavedFleetStop, StoppedBy};
use serde::{Deserialize, Serialize};

use crate::known_arms::{NewText, read_file};

/// The file of the arm's stop and the fleet-wide stops; empty if there are none.
#[derive(Debug)]
pub(crate) struct SavedStop(PathBuf);

#[derive(Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Content {
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) stop: Option<StoppedBy>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(crate) fleet: Vec<SavedFleetStop>,
}

impl SavedStop {
    pub(crate) const fn at(file: PathBuf) -> Self {
        Self(file)
    }

    /// Returns the stops that held when the station ended. An unreadable file counts as a stop: a
    /// person has to look.
    pub(crate) fn read(&self) -> Content {
        let text = read_file(&self.0).map_err(|error| error.to_string());
        let content = text.and_then(|text| {
            let text = text.unwrap_or_default();
            toml::from_str(&text).map_err(|error| error.message().to_owned())
        });
        let unreadable = |why| Content {
            stop: Some(StoppedBy {
                by: "the station".to_owned(),
                reason: Some(format!(
                    "cannot read whether a stop held before: {}: {why}",
                    self.0.display()
                )),
                ..StoppedBy::default()
            }),
            fleet: Vec::new(),
        };
        content.unwrap_or_else(unreadable)
    }

    /// Returns the file content for the current stops.
    pub(crate) fn keep(&self, content: &Content) -> io::Result<NewText> {
        NewText::of(&self.0, content)
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use dobot_api::{Device, FleetWideStop};

    use super::*;

    #[test]
    fn a_stop_is_kept_until_it_is_reset() {
        let folder = tempfile::tempdir().unwrap();
        let kept = SavedStop::at(folder.path().join("stop.toml"));
        assert_eq!(kept.read(), Content::default());
        let content = Content {
            stop: Some(StoppedBy {
                by: "Anna".into(),
                device: Some(Device::Phone),
                client: None,
                reason: Some("finger caught".into()),
            }),
            fleet: vec![SavedFleetStop {
                stop: FleetWideStop {
                    origin: "0123".into(),
                    count: 1_800_000_000_000,
                    by: "Ms Weber".into(),
                    reason: None,
                    reset_by: Some("Ms Weber".into()),
                },
                is_reset_here: true,
            }],
        };
        kept.keep(&content).unwrap().write().unwrap();
        assert_eq!(kept.read(), content);
        kept.keep(&Content::default()).unwrap().write().unwrap();
        assert_eq!(kept.read(), Content::default());
    }

    #[test]
    fn a_file_that_cannot_be_read_counts_as_a_stop() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("stop.toml");
        std::fs::write(&file, "[stop").unwrap();
        let read = SavedStop::at(file).read().stop.unwrap();
        assert!(read.reason.unwrap().contains("stop.toml"));
    }
}
