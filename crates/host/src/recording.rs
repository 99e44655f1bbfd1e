//! The recording of a station: all packets, states and notices.

use std::sync::Arc;
use std::time::Duration;

use dobot_api::{Folders, Notice, State, make_private};
use dobot_arm::{Millimeters, Tool};
use dobot_model::MountedTool;
use dobot_record::{About, Limits, Record, Recorder, Topic};
use dobot_safety::Policy;
use dobot_session::Address;
use dobot_wire::Dialect;
use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde::Serialize;

/// The recording of a station; without a recorder it does nothing.
#[derive(Debug)]
pub(crate) struct Recording {
    recorder: Option<Recorder>,
    about: About,
    states: Arc<Topic>,
    notices: Arc<Topic>,
    /// The last recorded height below which a pen draws.
    pen_below_mm: Option<f64>,
    /// The last recorded state and its time.
    recorded: Option<(Duration, State)>,
    /// The last reported problem of the recorder.
    problem: Option<String>,
}

impl Recording {
    pub(crate) fn new(recorder: Option<Recorder>, personality: Option<String>) -> Self {
        Self {
            recorder,
            about: About {
                personality,
                ..about()
            },
            states: state_topic(),
            notices: notice_topic(),
            pen_below_mm: None,
            recorded: None,
            problem: None,
        }
    }

    /// Records a packet to the arm, and the tool height below which a pen draws then.
    pub(crate) fn sent(&mut self, at: Duration, bytes: &[u8], pen_below_mm: Option<f64>) {
        if pen_below_mm != self.pen_below_mm {
            self.pen_below_mm = pen_below_mm;
            self.record(at, || Record::Pen {
                below_mm: pen_below_mm,
            });
        }
        self.record(at, || Record::ToArm(bytes.to_vec()));
    }

    pub(crate) fn received(&self, at: Duration, bytes: &[u8]) {
        self.record(at, || Record::FromArm(bytes.to_vec()));
    }

    /// Records a state if it has changed; if only the arm's status, clocks or link figures differ,
    /// every ten seconds.
    pub(crate) fn state(&mut self, at: Duration, state: &State) {
        if state.dialect != self.about.dialect {
            // It was detected or set after the link came up.
            self.about.dialect = state.dialect;
            let about = Box::new(self.about.clone());
            self.record(at, || Record::About(about));
        }
        if self.recorder.is_some() && self.is_worth_recording(at, state) {
            self.recorded = Some((at, state.clone()));
            self.json(at, &self.states, state);
        }
    }

    fn is_worth_recording(&self, at: Duration, state: &State) -> bool {
        let Some((recorded_at, recorded)) = &self.recorded else {
            return true;
        };
        let is_due = at.saturating_sub(*recorded_at) >= STATE_PERIOD;
        if is_due {
            recorded != state
        } else {
            recorded.without_readings() != state.without_readings()
        }
    }

    /// Records the tool lengths of a new policy.
    pub(crate) fn tools(&self, at: Duration, policy: &Policy) {
        self.record(at, || Record::Tools(tools_of(policy)));
    }

    pub(crate) fn notice(&self, at: Duration, notice: &Notice) {
        self.json(at, &self.notices, notice);
    }

    /// Sets the arm and its dialect, if known.
    pub(crate) fn link(&mut self, at: Duration, address: &Address, dialect: Option<Dialect>) {
        self.about.address = address.to_string();
        self.about.dialect = dialect;
        let about = Box::new(self.about.clone());
        self.record(at, || Record::About(about));
    }

    /// Returns why nothing is recorded now; `None` if all is.
    pub(crate) fn missing(&self) -> Option<String> {
        match &self.recorder {
            Some(recorder) => recorder.health().trouble,
            None => Some("the station has no recorder".into()),
        }
    }

    /// Returns a new problem of the recorder, or its end.
    pub(crate) fn poll_trouble(&mut self) -> Option<String> {
        let problem = self.recorder.as_ref()?.health().trouble;
        if problem == self.problem {
            return None;
        }
        self.problem.clone_from(&problem);
        Some(match problem {
            Some(problem) => format!("recording: {problem}"),
            None => "recording works again".into(),
        })
    }

    /// Writes the rest.
    pub(crate) fn end(self) {
        if let Some(recorder) = self.recorder {
            // There is no one left to report the result to.
            let _ = recorder.finish();
        }
    }

    fn json(&self, at: Duration, topic: &Arc<Topic>, value: &impl Serialize) {
        self.record(at, || Record::Json {
            topic: topic.clone(),
            value: serde_json::to_value(value).unwrap_or_default(),
        });
    }

    fn record(&self, at: Duration, record: impl FnOnce() -> Record) {
        if let Some(recorder) = &self.recorder {
            recorder.record(at, record());
        }
    }
}

/// Starts a recording, or returns why it cannot.
pub(crate) fn start(folders: &Folders) -> (Option<Recorder>, Option<String>) {
    // The recorder fails for the same reason and reports it.
    let _ = make_private(&folders.recordings());
    let recorder = Recorder::start(
        folders.recordings(),
        Limits::default(),
        about(),
        jiff::Timestamp::now(),
    );
    match recorder {
        Ok(recorder) => (Some(recorder), None),
        Err(error) => (None, Some(format!("nothing is recorded: {error}"))),
    }
}

/// Returns the description of every recording.
fn about() -> About {
    About {
        program: concat!("dobot ", env!("CARGO_PKG_VERSION")).into(),
        ..About::default()
    }
}

/// Returns the tools that the arm may have, with the policy's lengths; without those that no model
/// could have.
#[must_use]
pub fn tools_of(policy: &Policy) -> Vec<MountedTool> {
    let mounted = |tool: Tool| {
        let length = Millimeters(policy.tool_length.of(tool));
        MountedTool::new(tool, length).ok()
    };
    let tools = Tool::END_EFFECTORS.into_iter();
    tools.filter_map(mounted).collect()
}

/// Returns the topic on which a station's states are recorded and published.
#[must_use]
pub fn state_topic() -> Arc<Topic> {
    topic::<State>("/station/state", "dobot.State")
}

/// Returns the topic on which a station's notices are recorded and published.
#[must_use]
pub fn notice_topic() -> Arc<Topic> {
    topic::<Notice>("/station/notices", "dobot.Notice")
}

/// Returns the topic of a type. Viewers of recordings do not follow references.
fn topic<T: JsonSchema>(name: &str, schema_name: &str) -> Arc<Topic> {
    let mut settings = SchemaSettings::draft2020_12();
    settings.inline_subschemas = true;
    let schema = settings.into_generator().into_root_schema_for::<T>();
    let topic = Topic::new(name, schema_name, schema.as_value());
    Arc::new(topic.expect("our types are objects, and our topics begin with a slash"))
}

/// The interval of recording states without news.
const STATE_PERIOD: Duration = Duration::from_secs(10);

#[cfg(test)]
mod tests {
    use super::*;

    /// A state of an arm at rest: clock and figures advance.
    fn state(at_s: f64) -> State {
        let mut state = State {
            at_s,
            dialect: None,
            ..State::sample()
        };
        state.link.statuses_per_s += at_s / 1e6;
        state
    }

    /// Returns the number of these states that are recorded, at one per 80 ms.
    fn recorded(states: impl IntoIterator<Item = State>) -> usize {
        let folder = tempfile::tempdir().expect("there is room");
        let start = jiff::Timestamp::UNIX_EPOCH;
        let recorder = Recorder::start(folder.path(), Limits::DEFAULT, About::default(), start);
        let mut recording = Recording::new(Some(recorder.expect("it starts")), None);
        for state in states {
            recording.state(Duration::from_secs_f64(state.at_s), &state);
        }
        recording.end();
        let files = dobot_record::recordings(folder.path()).expect("it is readable");
        let moments = dobot_record::Recording::open(&files[0].path).expect("it is one");
        moments.count()
    }

    #[test]
    fn a_dialect_found_after_the_first_state_is_saved_in_the_recording() {
        let folder = tempfile::tempdir().expect("there is room");
        let start = jiff::Timestamp::UNIX_EPOCH;
        let recorder = Recorder::start(folder.path(), Limits::DEFAULT, About::default(), start);
        let mut recording = Recording::new(Some(recorder.expect("it starts")), None);
        recording.state(Duration::ZERO, &state(0.0));
        let known = State {
            dialect: Some(Dialect::FIRMWARE_1_1),
            ..state(1.0)
        };
        recording.state(Duration::from_secs(1), &known);
        recording.end();
        let files = dobot_record::recordings(folder.path()).expect("it is readable");
        let mut read = dobot_record::Recording::open(&files[0].path).expect("it is one");
        assert_eq!(read.by_ref().count(), 2);
        let about = read.about().expect("every file has it");
        assert_eq!(about.dialect, Some(Dialect::FIRMWARE_1_1));
    }

    fn hour() -> impl Iterator<Item = State> {
        (0..45_000).map(|n| state(0.08 * f64::from(n)))
    }

    #[test]
    fn at_rest_a_state_is_recorded_every_ten_seconds() {
        let count = recorded(hour());
        // 125 states of 80 ms are ten seconds.
        assert!((350..=361).contains(&count), "{count} an hour");
    }

    #[test]
    fn a_state_with_new_content_is_recorded_at_once() {
        let mut states: Vec<_> = hour().take(100).collect();
        for state in &mut states[50..] {
            state.clients = 2;
        }
        if let Some(arm) = &mut states[70].arm {
            arm.moving = true;
        }
        // The first, the second client, the movement and its end.
        assert_eq!(recorded(states), 4);
    }

    #[test]
    fn the_status_alone_is_on_the_wire_anyway() {
        let mut states: Vec<_> = hour().take(100).collect();
        for (n, state) in (0_u8..).zip(&mut states) {
            if let Some(arm) = &mut state.arm {
                arm.status.x_mm = n.into();
            }
        }
        assert_eq!(recorded(states), 1);
    }
}
