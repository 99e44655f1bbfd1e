//! What the station records: everything on the wire, states and notices.

use std::sync::Arc;
use std::time::Duration;

use dobot_client::Address;
use dobot_record::{About, Limits, Record, Recorder, Topic};
use dobot_wire::Dialect;
use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde::Serialize;

use crate::Folders;
use crate::words::{Notice, State};

/// What the station records; without a recorder nothing.
#[derive(Debug)]
pub(crate) struct Recording {
    recorder: Option<Recorder>,
    about: About,
    states: Arc<Topic>,
    notices: Arc<Topic>,
    /// What was wrong with the recorder when it was asked last.
    problem: Option<String>,
}

impl Recording {
    pub(crate) fn new(recorder: Option<Recorder>, personality: Option<String>) -> Self {
        Self {
            recorder,
            about: About {
                program: concat!("dobot ", env!("CARGO_PKG_VERSION")).into(),
                personality,
                ..About::default()
            },
            states: topic::<State>("/station/state", "dobot.State"),
            notices: topic::<Notice>("/station/notices", "dobot.Notice"),
            problem: None,
        }
    }

    pub(crate) fn sent(&self, at: Duration, bytes: &[u8]) {
        self.record(at, || Record::ToArm(bytes.to_vec()));
    }

    pub(crate) fn heard(&self, at: Duration, bytes: &[u8]) {
        self.record(at, || Record::FromArm(bytes.to_vec()));
    }

    pub(crate) fn state(&self, at: Duration, state: &State) {
        self.json(at, &self.states, state);
    }

    pub(crate) fn notice(&self, at: Duration, notice: &Notice) {
        self.json(at, &self.notices, notice);
    }

    /// Takes which arm it is from now on, and what it speaks, if that is known.
    pub(crate) fn link(&mut self, at: Duration, address: &Address, dialect: Option<Dialect>) {
        self.about.address = address.to_string();
        self.about.dialect = dialect;
        let about = Box::new(self.about.clone());
        self.record(at, || Record::About(about));
    }

    /// What went wrong with recording, or went right again, since this was asked last.
    pub(crate) fn poll_trouble(&mut self) -> Option<String> {
        let problem = self.recorder.as_ref()?.health().trouble;
        if problem == self.problem {
            return None;
        }
        self.problem.clone_from(&problem);
        Some(match problem {
            Some(problem) => format!("recording: {problem}"),
            None => "recording goes on".into(),
        })
    }

    /// Writes what is left.
    pub(crate) fn end(self) {
        if let Some(recorder) = self.recorder {
            // Nobody is left who could be told how it went.
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

/// Starts a recording, or says why there is none.
pub(crate) fn start(folders: &Folders) -> (Option<Recorder>, Option<String>) {
    let recorder = Recorder::start(
        folders.recordings(),
        Limits::default(),
        About::default(),
        jiff::Timestamp::now(),
    );
    match recorder {
        Ok(recorder) => (Some(recorder), None),
        Err(error) => (None, Some(format!("nothing is recorded: {error}"))),
    }
}

/// The topic of one of our types. Programs that show recordings do not follow references.
fn topic<T: JsonSchema>(name: &str, schema_name: &str) -> Arc<Topic> {
    let mut settings = SchemaSettings::draft2020_12();
    settings.inline_subschemas = true;
    let schema = settings.into_generator().into_root_schema_for::<T>();
    let topic = Topic::new(name, schema_name, schema.as_value());
    Arc::new(topic.expect("our types are objects, and our topics begin with a slash"))
}
