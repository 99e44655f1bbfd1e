//! The episodes that were marked while a recording was made.

use std::ops::RangeInclusive;
use std::time::Duration;

use serde_json::Value;

use crate::{Entry, Moment, Recording};

/// A marked episode of a recording.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MarkedEpisode {
    /// Its period, in time since the start of the recorder.
    pub period: RangeInclusive<Duration>,
    /// What the arm does, if the mark says so.
    pub task: Option<String>,
}

/// Returns the marked episodes of a recording, in order: from each `begin` to the next `end` or
/// `begin`, or to the end of the recording, without discarded ones.
pub fn marked_episodes(recording: &mut Recording) -> Vec<MarkedEpisode> {
    let mut episodes: Vec<MarkedEpisode> = Vec::new();
    let mut is_open = false;
    let mut last = Duration::ZERO;
    for moment in recording {
        last = last.max(moment.at);
        let Some((mark, task)) = mark_of(&moment) else {
            continue;
        };
        if std::mem::take(&mut is_open)
            && let Some(open) = episodes.last_mut()
        {
            open.period = *open.period.start()..=moment.at;
        }
        match mark {
            "begin" => {
                is_open = true;
                let period = moment.at..=moment.at;
                episodes.push(MarkedEpisode { period, task });
            }
            "discard" => drop(episodes.pop()),
            _ => {}
        }
    }
    if is_open && let Some(open) = episodes.last_mut() {
        open.period = *open.period.start()..=last;
    }
    episodes
}

/// The mark in a notice of the station, and its task.
fn mark_of(moment: &Moment) -> Option<(&str, Option<String>)> {
    let Entry::Json(notice) = &moment.entry else {
        return None;
    };
    let text = |field: &str| notice.get(field).and_then(Value::as_str);
    let is_mark = &*moment.topic == NOTICES && text("type") == Some("episode_marked");
    let mark = text("mark").filter(|_| is_mark)?;
    Some((mark, text("task").map(str::to_owned)))
}

/// The topic of a station's notices.
const NOTICES: &str = "/station/notices";
