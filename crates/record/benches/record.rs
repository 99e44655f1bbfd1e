//! The cost of recording.
//!
//! `cargo bench -p dobot-record --bench record`

use std::sync::Arc;
use std::time::Duration;

use divan::Bencher;
use divan::counter::ItemsCount;
use dobot_record::{About, Limits, Record, Recorder, Recording, Topic, recordings};
use dobot_wire::Status;
use serde_json::json;
use tempfile::TempDir;

fn main() {
    divan::main();
}

/// The cost of a status for the caller, including its copy. Up to the size of the queue: beyond it,
/// records are lost and cost less.
#[divan::bench(sample_count = 20, sample_size = 1)]
fn a_status_for_its_caller(bencher: Bencher) {
    let status = status();
    bencher
        .counter(ItemsCount::new(QUEUE))
        .with_inputs(recorder)
        .bench_refs(|(_, recorder)| {
            for n in 0..QUEUE {
                recorder.record(at(n), Record::FromArm(status.to_vec()));
            }
        });
}

/// The cost of a station state that the caller has already created.
#[divan::bench(sample_count = 20, sample_size = 1)]
fn a_state_for_its_caller(bencher: Bencher) {
    let topic = Topic::new("/state", "x.State", &json!({ "type": "object" }));
    let topic = Arc::new(topic.expect("it is one"));
    let value = json!({
        "pose": { "x_mm": 200.0, "y_mm": 0.0, "z_mm": 20.0 },
        "joints": [0.0, 45.0, 45.0, 0.0],
        "link": "up",
        "queue": 3,
    });
    bencher
        .counter(ItemsCount::new(QUEUE))
        .with_inputs(|| {
            let record = || Record::Json {
                topic: Arc::clone(&topic),
                value: value.clone(),
            };
            let records: Vec<_> = (0..QUEUE).map(|n| (at(n), record())).collect();
            (recorder(), Some(records))
        })
        .bench_refs(|((_, recorder), records)| {
            for (at, record) in records.take().into_iter().flatten() {
                recorder.record(at, record);
            }
        });
}

/// Statuses including the file, in the recorder's thread.
#[divan::bench(sample_count = 20, sample_size = 1)]
fn a_status_to_its_file(bencher: Bencher) {
    let status = status();
    bencher
        .counter(ItemsCount::new(QUEUE))
        .with_inputs(|| {
            let (folder, recorder) = recorder();
            for n in 0..QUEUE {
                recorder.record(at(n), Record::FromArm(status.to_vec()));
            }
            (folder, Some(recorder))
        })
        .bench_refs(|(_, recorder)| recorder.take().map(Recorder::finish));
}

/// Reading a recording: four messages per status.
#[divan::bench(sample_count = 20, sample_size = 1)]
fn a_status_from_its_file(bencher: Bencher) {
    let status = status();
    let (folder, recorder) = recorder();
    for n in 0..QUEUE {
        recorder.record(at(n), Record::FromArm(status.to_vec()));
    }
    assert_eq!(recorder.finish().lost, 0);
    let file = &recordings(folder.path()).expect("it is readable")[0].path;
    bencher
        .counter(ItemsCount::new(QUEUE))
        .bench(|| Recording::open(file).expect("it is one").count());
}

fn recorder() -> (TempDir, Recorder) {
    let folder = tempfile::tempdir().expect("there is room");
    let start = "2026-11-21T12:30:00Z".parse().expect("it is a time");
    let recorder = Recorder::start(folder.path(), Limits::DEFAULT, About::default(), start);
    (folder, recorder.expect("the limits are good"))
}

fn at(n: u32) -> Duration {
    Duration::from_millis(80) * n
}

fn status() -> [u8; 42] {
    let status = Status::AT_ZERO;
    status.emit().to_bytes()
}

/// The largest number of records that wait to be written.
const QUEUE: u32 = 4096;
