//! The stop that holds the arm, through restarts of the station.

use std::io;
use std::path::PathBuf;

use dobot_api::StopView;
use serde::{Deserialize, Serialize};

use crate::known_arms::{NewText, read_file};

/// The file with the stop; it is empty while none holds.
#[derive(Debug)]
pub(crate) struct KeptStop(PathBuf);

#[derive(Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Content {
    #[serde(default, skip_serializing_if = "Option::is_none")]
    stop: Option<StoppedBy>,
}

/// Who stopped the arm, and why.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct StoppedBy {
    pub(crate) by: String,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) reason: Option<String>,
}

impl KeptStop {
    pub(crate) const fn at(file: PathBuf) -> Self {
        Self(file)
    }

    /// The stop that held when the station ended. A file that cannot be read counts as a stop: somebody has to look.
    pub(crate) fn read(&self) -> Option<StoppedBy> {
        let text = read_file(&self.0).map_err(|error| error.to_string());
        let content = text.and_then(|text| {
            let text = text.unwrap_or_default();
            toml::from_str(&text).map_err(|error| error.message().to_owned())
        });
        let unreadable = |why| Content {
            stop: Some(StoppedBy {
                by: "the station".to_owned(),
                reason: Some(format!(
                    "whether a stop held before cannot be read: {}: {why}",
                    self.0.display()
                )),
            }),
        };
        content.unwrap_or_else(unreadable).stop
    }

    /// The file for the stop that holds now, if one does.
    pub(crate) fn keep(&self, stop: Option<StopView>) -> io::Result<NewText> {
        let stop = stop.map(|it| StoppedBy {
            by: it.by,
            reason: it.reason,
        });
        NewText::of(&self.0, &Content { stop })
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    #[test]
    fn a_stop_is_kept_until_it_is_reset() {
        let folder = tempfile::tempdir().unwrap();
        let kept = KeptStop::at(folder.path().join("stop.toml"));
        assert_eq!(kept.read(), None);
        let stop = StopView {
            by: "Anna".into(),
            reason: Some("finger caught".into()),
            at_s: 5.0,
            rests_by_s: 6.0,
            at_rest: true,
            delivered: true,
        };
        kept.keep(Some(stop)).unwrap().write().unwrap();
        let read = kept.read().unwrap();
        assert_eq!(read.by, "Anna");
        assert_eq!(read.reason.as_deref(), Some("finger caught"));
        kept.keep(None).unwrap().write().unwrap();
        assert_eq!(kept.read(), None);
    }

    #[test]
    fn a_file_that_cannot_be_read_counts_as_a_stop() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("stop.toml");
        std::fs::write(&file, "[stop").unwrap();
        let read = KeptStop::at(file).read().unwrap();
        assert!(read.reason.unwrap().contains("stop.toml"));
    }
}
