//! The targets of the in-flight commands.

use std::time::Duration;

use dobot_arm::Position;
use dobot_motion::Trajectory;
use serde_json::{Value, json};

use crate::scene::{color, entity, line, points, removal, sphere};

/// The view of the targets of the in-flight commands: one entity, which each update replaces.
#[derive(Debug, Default)]
pub(crate) struct Target {
    /// Whether it changed since the last report.
    is_news: bool,
    is_shown: bool,
    reported_at: Option<Duration>,
}

impl Target {
    /// Handles added or finished commands.
    pub(crate) const fn note_change(&mut self) {
        self.is_news = true;
    }

    /// Requests another report if the view is visible.
    pub(crate) const fn report_again(&mut self) {
        self.is_news |= self.is_shown;
    }

    /// The target and the paths to it, if changed; at most four times a second.
    pub(crate) fn poll<'w>(
        &mut self,
        at: Duration,
        time: &Value,
        ways: impl Iterator<Item = &'w Trajectory>,
        tip_mm: f64,
    ) -> Option<Value> {
        let is_due = |last| at.saturating_sub(last) >= PERIOD;
        if !self.is_news || !self.reported_at.is_none_or(is_due) {
            return None;
        }
        self.is_news = false;
        let places = places(ways);
        let was_shown = std::mem::replace(&mut self.is_shown, !places.is_empty());
        if !was_shown && !self.is_shown {
            return None;
        }
        self.reported_at = Some(at);
        Some(shown(time, &points(&places, tip_mm)))
    }
}

/// The target and the paths through these points, or what removes them if there are none.
fn shown(time: &Value, places: &[Value]) -> Value {
    let Some(end) = places.last() else {
        return json!({ "deletions": [removal(time, NAME)], "entities": [] });
    };
    let color = color(TARGET);
    let lines = [line(places, LINE_M, &color)];
    let entity = entity(time, NAME, &lines, &[sphere(end, END_M, &color)]);
    json!({ "deletions": [], "entities": [entity] })
}

/// The points along the paths, in order; none if no command moves or has an end.
fn places<'w>(ways: impl Iterator<Item = &'w Trajectory>) -> Vec<Position> {
    let mut places = Vec::new();
    for way in ways {
        let mut corners = way.corners().peekable();
        if places.is_empty()
            && corners.peek().is_some()
            && let Ok(from) = way.place_at(0.0)
        {
            places.push(from.pose.position);
        }
        places.extend(corners.map(|(place, _)| place.pose.position));
    }
    places
}

const NAME: &str = "target";
const PERIOD: Duration = Duration::from_millis(250);
const LINE_M: f64 = 0.001;
const END_M: f64 = 0.006;
/// The colour of planned motion on the station's page.
const TARGET: u32 = 0x2a_72_b8;
