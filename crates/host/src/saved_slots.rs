//! The file of time slots, which survives crashes of the station.

use std::io;
use std::path::{Path, PathBuf};

use dobot_api::TimeSlot;
use serde::{Deserialize, Serialize};

use crate::known_arms::{NewText, read_file};

/// The file of time slots, with times by the computer's clock, the only one that runs while no
/// station does.
#[derive(Debug)]
pub(crate) struct SavedSlots(PathBuf);

#[derive(Debug, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Content {
    #[serde(default)]
    slot: Vec<SavedSlot>,
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct SavedSlot {
    student: String,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    group: Option<String>,
    /// In milliseconds since 1970-01-01T00:00:00Z, as below.
    starts_ms: i64,
    ends_ms: i64,
}

impl SavedSlots {
    pub(crate) fn at(file: &Path) -> Self {
        Self(file.to_owned())
    }

    /// Returns the current and upcoming slots, relative to now.
    ///
    /// # Errors
    ///
    /// The reason of a failure, in one line.
    pub(crate) fn read(&self, now_ms: i64) -> Result<Vec<TimeSlot>, String> {
        let describe = |why: String| format!("{}: {why}", self.0.display());
        let Some(text) = read_file(&self.0).map_err(|error| describe(error.to_string()))? else {
            return Ok(Vec::new());
        };
        let content: Content =
            toml::from_str(&text).map_err(|error| describe(error.message().to_owned()))?;
        let slots = content.slot.into_iter().map(|slot| slot.after(now_ms));
        Ok(slots.filter(|slot| slot.ends_in_s >= LEFT_S).collect())
    }

    /// Returns the file content for these slots.
    pub(crate) fn keep(&self, slots: &[TimeSlot], now_ms: i64) -> io::Result<NewText> {
        let slot = slots
            .iter()
            .map(|slot| SavedSlot::of(slot, now_ms))
            .collect();
        NewText::of(&self.0, &Content { slot })
    }
}

impl SavedSlot {
    fn of(slot: &TimeSlot, now_ms: i64) -> Self {
        #[expect(
            clippy::cast_possible_truncation,
            reason = "a day has fewer milliseconds"
        )]
        let at = |in_s: f64| now_ms.saturating_add((in_s * 1000.0).round() as i64);
        Self {
            student: slot.student.clone(),
            group: slot.group.clone(),
            starts_ms: at(slot.starts_in_s),
            ends_ms: at(slot.ends_in_s),
        }
    }

    fn after(self, now_ms: i64) -> TimeSlot {
        #[expect(
            clippy::cast_precision_loss,
            reason = "what is farther away than a day is refused"
        )]
        let in_s = |at_ms: i64| at_ms.saturating_sub(now_ms) as f64 / 1000.0;
        TimeSlot {
            student: self.student,
            group: self.group,
            starts_in_s: in_s(self.starts_ms).max(0.0),
            ends_in_s: in_s(self.ends_ms),
        }
    }
}

/// A remainder of a slot below this is dropped, in seconds.
const LEFT_S: f64 = 1.0;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    fn slot(student: &str, starts_in_s: f64, ends_in_s: f64) -> TimeSlot {
        TimeSlot {
            student: student.into(),
            group: Some("red".into()),
            starts_in_s,
            ends_in_s,
        }
    }

    #[test]
    fn slots_continue_after_a_restart_of_the_station() {
        let folder = tempfile::tempdir().unwrap();
        let kept = SavedSlots::at(&folder.path().join("slots.toml"));
        assert_eq!(kept.read(5).unwrap(), []);
        let all = [slot("Anna", 0.0, 600.0), slot("Ben", 600.0, 1200.5)];
        kept.keep(&all, 1_000_000).unwrap().write().unwrap();
        assert_eq!(
            kept.read(1_100_000).unwrap(),
            [slot("Anna", 0.0, 500.0), slot("Ben", 500.0, 1100.5)]
        );
        assert_eq!(
            kept.read(1_700_000).unwrap(),
            [slot("Ben", 0.0, 500.5)],
            "the one of Anna is over"
        );
    }

    #[test]
    fn a_damaged_file_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("slots.toml");
        std::fs::write(&file, "[[slot]]\nstudent = 5").unwrap();
        let why = SavedSlots::at(&file).read(0).unwrap_err();
        assert!(why.contains("slots.toml"), "{why}");
    }
}
