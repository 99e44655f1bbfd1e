//! Files of killed recorders are repaired at the next start.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use dobot_record::{
    About, Damage, Entry, Health, Limits, Moment, RECORDER, Record, Recorder, Recording, Topic,
    copy, is_being_written, recordings, repair,
};
use serde_json::{Value, json};

const LIMITS: Limits = Limits {
    file_bytes: 1 << 20,
    total_bytes: 4 << 20,
};

fn recorder(folder: &Path, limits: Limits) -> Recorder {
    let start = "2026-11-21T12:30:00Z".parse().unwrap();
    Recorder::start(folder, limits, About::default(), start).unwrap()
}

/// Starts a recorder that records nothing, and waits until all repairs are done.
fn repaired(folder: &Path, limits: Limits) -> Health {
    let recorder = recorder(folder, limits);
    loop {
        // It is done when it has examined the first file of the folder: this one, which is empty.
        let health = recorder.health();
        if health.left > 0 {
            return recorder.finish();
        }
        std::thread::yield_now();
    }
}

/// A folder with an unreadable file before all others.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join(FIRST), mcap::MAGIC).unwrap();
    folder
}

/// The files before the unreadable one.
fn file(folder: &Path) -> PathBuf {
    folder.join("dobot-2026-11-21T12-30-00Z.mcap")
}

/// Some seconds with events, bytes and repeated statuses.
fn session() -> Vec<u8> {
    let folder = tempfile::tempdir().unwrap();
    let recorder = recorder(folder.path(), LIMITS);
    let schema = json!({ "type": "object" });
    let topic = Arc::new(Topic::new("/events", "x.Event", &schema).unwrap());
    for n in 0..40_u64 {
        let at = Duration::from_millis(80 * n);
        let (topic, value) = (Arc::clone(&topic), json!({ "n": n }));
        recorder.record(at, Record::FromArm(vec![0; 42]));
        if n.is_multiple_of(5) {
            recorder.record(at, Record::Json { topic, value });
            recorder.record(at, Record::ToArm(vec![1, 2, 3]));
        }
    }
    assert_eq!(recorder.finish().lost, 0);
    std::fs::read(file(folder.path())).unwrap()
}

fn read(file: &Path) -> (Vec<Moment>, Option<Damage>) {
    let mut recording = Recording::open(file).unwrap();
    let moments = recording.by_ref().collect();
    (moments, recording.damage().cloned())
}

/// The note at the end of a repaired file.
fn message(moments: &[Moment]) -> &Value {
    match moments.last() {
        Some(Moment {
            topic,
            entry: Entry::Json(value),
            ..
        }) if &**topic == RECORDER => value,
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_truncated_file_is_complete_after_the_next_start() {
    let whole = session();
    // Through all of its content, and the end mark byte by byte.
    let lengths = (0..whole.len())
        .step_by(211)
        .chain(whole.len() - 12..whole.len());
    let folder = folder();
    for len in lengths {
        let file = file(folder.path());
        std::fs::write(&file, &whole[..len]).unwrap();
        let (before, damage) = read(&file);
        let about = Recording::open(&file).map(|mut recording| {
            recording.by_ref().for_each(drop);
            recording.about().cloned()
        });
        let health = repaired(folder.path(), LIMITS);
        let (after, still) = read(&file);
        if about.unwrap().is_none() {
            assert_eq!(health.repaired, 0, "{len} bytes");
            assert_eq!(std::fs::read(&file).unwrap(), &whole[..len]);
            continue;
        }
        assert_eq!((health.repaired, still), (1, None), "{len} bytes");
        assert_eq!(after.split_last().unwrap().1, before, "{len} bytes");
        let unread = len as u64 - damage.unwrap().good_bytes;
        assert_eq!(message(&after)["unreadable_bytes"], unread, "{len} bytes");
        let bytes = std::fs::read(&file).unwrap();
        let summary = mcap::Summary::read(&bytes).unwrap().expect("it has one");
        let count = mcap::MessageStream::new(&bytes).unwrap().count() as u64;
        assert_eq!(summary.stats.unwrap().message_count, count);
        assert_eq!(folder.path().read_dir().unwrap().count(), 2);
    }
}

#[test]
fn a_damaged_file_is_repaired_on_request_and_a_whole_one_stays_as_it_is() {
    let whole = session();
    let folder = folder();
    let file = file(folder.path());
    std::fs::write(&file, &whole).unwrap();
    assert_eq!(repair(&file).unwrap(), None);
    assert_eq!(std::fs::read(&file).unwrap(), whole);
    for len in (0..whole.len()).step_by(211) {
        std::fs::write(&file, &whole[..len]).unwrap();
        let (before, damage) = read(&file);
        match repair(&file) {
            Ok(found) => {
                assert_eq!(found, damage, "{len} bytes");
                let (after, still) = read(&file);
                assert_eq!((after.split_last().unwrap().1, still), (&before[..], None));
            }
            Err(error) => {
                assert!(before.is_empty(), "{len} bytes: {error}");
                assert_eq!(std::fs::read(&file).unwrap(), &whole[..len]);
            }
        }
    }
}

#[test]
fn a_copy_has_all_that_can_be_read_and_the_recording_stays_as_it_is() {
    let whole = session();
    let folder = folder();
    let (file, out) = (file(folder.path()), folder.path().join("copy"));
    for len in (0..whole.len()).step_by(211).chain([whole.len()]) {
        std::fs::write(&file, &whole[..len]).unwrap();
        let (before, damage) = read(&file);
        let found = copy(&file, &out);
        assert_eq!(std::fs::read(&file).unwrap(), &whole[..len]);
        assert_eq!(found.is_ok(), out.exists(), "{len} bytes");
        let Ok(found) = found else {
            assert!(before.is_empty(), "{len} bytes");
            continue;
        };
        assert_eq!(found, damage);
        let (after, still) = read(&out);
        assert!(after.starts_with(&before) && still.is_none(), "{len} bytes");
        assert!(copy(&file, &out).is_err(), "it exists");
        std::fs::remove_file(&out).unwrap();
    }
}

/// Not a test: it leaves repaired recordings and their numbers of messages in a folder, for
/// `./ci.sh recordings`.
#[test]
#[ignore = "leaves files for another program"]
fn samples() {
    let Some(samples) = std::env::var_os(SAMPLES) else {
        return;
    };
    let whole = session();
    for len in (0..whole.len()).rev().step_by(whole.len() / 8) {
        let folder = folder();
        let file = file(folder.path());
        std::fs::write(&file, &whole[..len]).unwrap();
        if repaired(folder.path(), LIMITS).repaired == 0 {
            continue;
        }
        let bytes = std::fs::read(&file).unwrap();
        let count = mcap::MessageStream::new(&bytes).unwrap().count();
        let sample = Path::new(&samples).join(format!("{len}.mcap"));
        std::fs::write(sample.with_extension("mcap.count"), count.to_string()).unwrap();
        std::fs::write(sample, bytes).unwrap();
    }
}

#[test]
fn a_properly_closed_file_and_one_being_written_are_not_touched() {
    let folder = folder();
    let whole = session();
    let ended = file(folder.path());
    std::fs::write(&ended, &whole).unwrap();
    let other = recorder(folder.path(), LIMITS);
    let at = Duration::from_mins(1);
    other.record(at, Record::ToArm(vec![1]));
    let open = loop {
        if let Some(open) = other.health().file {
            break open;
        }
    };
    assert!(is_being_written(&open));
    assert!(!is_being_written(&ended));
    assert_eq!(repaired(folder.path(), LIMITS).repaired, 0);
    assert_eq!(std::fs::read(&ended).unwrap(), whole);
    other.record(at, Record::ToArm(vec![2]));
    assert_eq!(other.finish().lost, 0);
    assert!(!is_being_written(&open));
    let (moments, damage) = read(&open);
    assert_eq!((moments.len(), damage), (2, None));
}

#[test]
fn damage_in_the_middle_costs_its_chunk_and_is_reported() {
    let whole = session();
    let summary = mcap::Summary::read(&whole).unwrap().expect("it has one");
    let mut chunks = summary.chunk_indexes;
    chunks.sort_by_key(|chunk| chunk.chunk_start_offset);
    let place = chunks[1].chunk_start_offset + chunks[1].chunk_length / 2;
    let mut bytes = whole[..whole.len() - 20].to_vec();
    bytes[usize::try_from(place).unwrap()] ^= 0xFF;
    let folder = folder();
    let file = file(folder.path());
    std::fs::write(&file, bytes).unwrap();
    let (before, damage) = read(&file);
    assert!(!damage.unwrap().breaks_off);
    assert_eq!(repaired(folder.path(), LIMITS).repaired, 1);
    let (after, damage) = read(&file);
    assert_eq!(damage, None);
    assert!(after.starts_with(&before));
    // The content after it is there too.
    assert!(after.len() > before.len() + 1, "{}", after.len());
    assert!(after[after.len() - 2].at > Duration::from_secs(3));
    let unread = message(&after)["unreadable_bytes"].as_u64().unwrap();
    assert!(unread >= chunks[1].chunk_length, "{unread}");
}

#[test]
fn an_interrupted_repair_is_done_again_and_leaves_nothing() {
    let whole = session();
    let folder = folder();
    let file = file(folder.path());
    std::fs::write(&file, &whole[..whole.len() - 30]).unwrap();
    let names = [
        "dobot-2026-11-21T12-30-00Z.mcap.repair",
        "dobot-2025-01-01T00-00-00Z.mcap.repair",
    ];
    for name in names {
        std::fs::write(folder.path().join(name), &whole[..500]).unwrap();
    }
    assert_eq!(recordings(folder.path()).unwrap().len(), 2, "no recordings");
    assert_eq!(repaired(folder.path(), LIMITS).repaired, 1);
    assert_eq!(read(&file).1, None);
    for name in names {
        assert!(!folder.path().join(name).exists(), "{name}");
    }
    assert_eq!(repaired(folder.path(), LIMITS).repaired, 0);
}

#[test]
fn a_repaired_folder_keeps_within_its_limits() {
    let folder = folder();
    // Noise: files of the maximum length.
    let noisy = recorder(folder.path(), LIMITS);
    let mut state = 1_u64;
    for n in 0..330_u64 {
        let mut byte = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            state.to_be_bytes()[0]
        };
        let noise = (0..10_000).map(|_| byte()).collect();
        noisy.record(Duration::from_secs(n), Record::ToArm(noise));
        std::thread::yield_now();
    }
    assert_eq!(noisy.finish().lost, 0);
    let before = recordings(folder.path()).unwrap();
    assert!(before.len() > 4, "{before:?}");
    for file in &before[1..] {
        let bytes = std::fs::read(&file.path).unwrap();
        std::fs::write(&file.path, &bytes[..bytes.len() - 10]).unwrap();
    }
    // The unreadable file is deleted first to make room.
    let recorder = recorder(folder.path(), LIMITS);
    while recorder.health().repaired == 0 {
        std::thread::yield_now();
    }
    drop(recorder);
    let after = recordings(folder.path()).unwrap();
    let total: u64 = after.iter().map(|item| item.bytes).sum();
    assert!(total + LIMITS.file_bytes <= LIMITS.total_bytes, "{total}");
    assert!(after.iter().all(|item| item.bytes <= LIMITS.file_bytes));
    assert_eq!(read(&after.last().unwrap().path).1, None);
}

/// The folder of samples.
const SAMPLES: &str = "DOBOT_RECORD_SAMPLES";

/// Sorts before all others.
const FIRST: &str = "dobot-2020-01-01T00-00-00Z.mcap";
