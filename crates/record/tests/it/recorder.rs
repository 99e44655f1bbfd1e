//! The recorder thread: it never blocks, and a killed program leaves a good file.

use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};
use std::sync::Arc;
use std::time::Duration;

use dobot_record::{
    About, Entry, Limits, RECORDER, Record, Recorder, Recording, Topic, recordings,
};
use serde_json::json;

fn recorder(folder: &std::path::Path) -> Recorder {
    let start = "2026-11-21T12:30:00Z".parse().unwrap();
    Recorder::start(folder, Limits::DEFAULT, About::default(), start).unwrap()
}

#[test]
fn records_that_do_not_fit_are_counted_and_the_file_states_the_count() {
    let folder = tempfile::tempdir().unwrap();
    let recorder = recorder(folder.path());
    let topic = Topic::new("/big", "x.Big", &json!({ "type": "object" })).unwrap();
    let topic = Arc::new(topic);
    let big = |len: usize| Record::Json {
        topic: Arc::clone(&topic),
        value: json!({ "text": "x".repeat(len) }),
    };
    recorder.record(Duration::ZERO, big(200_000));
    recorder.record(Duration::ZERO, big(100));
    assert_eq!(recorder.finish().lost, 1);
    let file = &recordings(folder.path()).unwrap()[0].path;
    let moments: Vec<_> = Recording::open(file).unwrap().collect();
    assert_eq!(&*moments[0].topic, RECORDER);
    let Entry::Json(message) = &moments[0].entry else {
        panic!("{moments:?}");
    };
    assert_eq!(message["lost"], 1);
    assert!(message["reason"].as_str().unwrap().contains("128 KiB"));
    assert_eq!(&*moments[1].topic, "/big");
}

#[test]
fn a_flood_is_recorded_or_counted_and_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    let recorder = recorder(folder.path());
    let count = 100_000_u32;
    for n in 0..count {
        recorder.record(
            Duration::from_micros(n.into()),
            Record::ToArm(vec![n.to_be_bytes()[3]]),
        );
    }
    let health = recorder.finish();
    let file = &recordings(folder.path()).unwrap()[0].path;
    let (mut read, mut message) = (0, 0);
    for moment in Recording::open(file).unwrap() {
        match moment.entry {
            Entry::ToArm(_) => read += 1,
            Entry::Json(value) => message += value["lost"].as_u64().unwrap(),
            other => panic!("{other:?}"),
        }
    }
    assert_eq!(read + health.lost, u64::from(count));
    assert!(message <= health.lost);
}

#[test]
fn invalid_limits_and_clocks_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let start = |limits, start: &str| {
        let start = start.parse().unwrap();
        Recorder::start(folder.path(), limits, About::default(), start)
            .unwrap_err()
            .to_string()
    };
    let error = start(Limits::DEFAULT, "1969-01-01T00:00:00Z");
    assert!(error.contains("set the clock"), "{error}");
    let limits = Limits {
        file_bytes: 1,
        total_bytes: 2,
    };
    let error = start(limits, "2026-01-01T00:00:00Z");
    assert!(error.contains("file_bytes is 1"), "{error}");
}

/// Not a test: the program that the next test starts and kills. It records until then, and prints
/// the state of its file.
#[test]
#[ignore = "runs until it is killed"]
fn victim() {
    let Some(folder) = std::env::var_os(FOLDER) else {
        return;
    };
    let recorder = recorder(folder.as_ref());
    for n in 0_u64.. {
        // A status every 80 ms, far faster than real time.
        recorder.record(Duration::from_millis(80 * n), Record::ToArm(vec![1; 42]));
        if n.is_multiple_of(1000) {
            let file = recorder.health().file;
            println!(
                "{}",
                file.and_then(|file| file.metadata().ok())
                    .map_or(0, |file| file.len())
            );
            std::thread::yield_now();
        }
    }
}

#[test]
fn a_program_that_is_killed_leaves_what_it_flushed() {
    for lines in [1, 30, 100] {
        let folder = tempfile::tempdir().unwrap();
        let mut victim = Command::new(std::env::current_exe().unwrap())
            .args(["--exact", "recorder::victim", "--ignored", "--nocapture"])
            .env(FOLDER, folder.path())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let output = BufReader::new(victim.stdout.take().unwrap());
        let sizes = output.lines().map_while(Result::ok);
        let some: Vec<u64> = sizes
            .filter_map(|line| line.trim().parse().ok())
            .filter(|size| *size > 0)
            .take(lines)
            .collect();
        victim.kill().unwrap();
        victim.wait().unwrap();
        let files = recordings(folder.path()).unwrap();
        assert_eq!(files.len(), 1, "it ran for a moment only");
        let mut recording = Recording::open(&files[0].path).unwrap();
        recording.by_ref().for_each(drop);
        let damage = recording.damage().unwrap();
        let seen = some.last().copied().unwrap();
        // The printed state may end in the middle of a write.
        assert!(
            damage.good_bytes + (64 << 10) >= seen,
            "{damage}, seen were {seen}"
        );
        assert!(
            damage.last.is_some_and(|last| last > Duration::ZERO),
            "{damage}"
        );
    }
}

const FOLDER: &str = "DOBOT_RECORD_VICTIM";
