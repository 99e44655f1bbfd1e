#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

use jiff::SignedDuration;

use super::*;
use crate::{Entry, RECORDER, Recording, recordings};

const LIMITS: Limits = Limits {
    file_bytes: 1 << 20,
    total_bytes: 3 << 20,
};

fn rotation(folder: &Path) -> Rotation {
    let start = "2026-11-21T12:30:00Z".parse().unwrap();
    let encoder = Encoder::new(start).unwrap();
    Rotation::new(folder.to_owned(), LIMITS, start, About::default(), encoder)
}

fn s(seconds: u64) -> Duration {
    Duration::from_secs(seconds)
}

/// Bytes that hardly compress.
fn noise(len: usize, seed: u64) -> Record {
    let mut state = seed;
    let mut random = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        state.to_be_bytes()[0]
    };
    Record::ToArm((0..len).map(|_| random()).collect())
}

/// The bytes to the arm and the reasons for losses in a file.
fn read(path: &Path) -> (usize, Vec<(u64, String)>) {
    let (mut bytes, mut lost) = (0, Vec::new());
    for moment in Recording::open(path).unwrap() {
        match moment.entry {
            Entry::ToArm(piece) => bytes += piece.len(),
            Entry::Json(value) if &*moment.topic == RECORDER => {
                let count = value["lost"].as_u64().unwrap();
                lost.push((count, value["reason"].as_str().unwrap().to_owned()));
            }
            _ => {}
        }
    }
    (bytes, lost)
}

#[test]
fn a_program_that_is_killed_loses_a_second_at_the_most() {
    let folder = tempfile::tempdir().unwrap();
    let mut rotation = rotation(folder.path());
    for n in 0..100_u32 {
        rotation.handle_record(Duration::from_millis(100) * n, &Record::ToArm(vec![0xA5]));
        if let Some(path) = rotation.health().file {
            // As after a kill: nothing more is written.
            let (bytes, _) = read(&path);
            let lost = usize::try_from(n).unwrap() + 1 - bytes;
            assert!(lost <= 10, "{lost} of {n} records, 10 a second");
        }
    }
}

#[test]
fn after_a_while_of_silence_nothing_is_unsafe() {
    let folder = tempfile::tempdir().unwrap();
    let mut rotation = rotation(folder.path());
    rotation.handle_record(s(0), &Record::ToArm(vec![0xA5]));
    let path = rotation.health().file.unwrap();
    assert_eq!(read(&path).0, 0);
    rotation.handle_idle();
    assert_eq!(read(&path).0, 1);
}

#[test]
fn files_and_folder_keep_within_their_limits_and_the_newest_stay() {
    let folder = tempfile::tempdir().unwrap();
    let mut rotation = rotation(folder.path());
    for n in 0..600 {
        rotation.handle_record(s(n), &noise(10_000, n));
        let files = recordings(folder.path()).unwrap();
        let total: u64 = files.iter().map(|file| file.bytes).sum();
        assert!(total <= LIMITS.total_bytes, "{total}");
        assert!(files.iter().all(|file| file.bytes <= LIMITS.file_bytes));
    }
    rotation.finish();
    assert_eq!(rotation.health().lost, 0);
    let files = recordings(folder.path()).unwrap();
    assert!(files.len() >= 3, "{files:?}");
    let last = Recording::open(&files.last().unwrap().path).unwrap();
    assert_eq!(last.last().unwrap().at, s(599));
    for file in &files[..files.len() - 1] {
        let mut recording = Recording::open(&file.path).unwrap();
        let first = recording.next().unwrap().at;
        let begin = rotation.start + SignedDuration::try_from(first).unwrap();
        assert_eq!(file.begin, begin, "its name is its first moment");
        recording.by_ref().for_each(drop);
        assert_eq!(recording.damage(), None);
    }
}

#[test]
fn a_folder_that_cannot_be_written_is_reported_and_tried_again() {
    let place = tempfile::tempdir().unwrap();
    let folder = place.path().join("recordings");
    std::fs::write(&folder, "something is in the way").unwrap();
    let mut rotation = rotation(&folder);
    let trouble = rotation.health().trouble.unwrap();
    assert!(trouble.contains("recordings"), "{trouble}");
    for n in 0..5 {
        rotation.handle_record(s(n), &Record::ToArm(vec![1]));
    }
    assert_eq!(rotation.health().lost, 5);
    std::fs::remove_file(&folder).unwrap();
    // Not yet: a full disk is not retried continuously.
    rotation.handle_record(s(9), &Record::ToArm(vec![1]));
    assert_eq!(rotation.health().lost, 6);
    rotation.handle_record(s(10), &Record::ToArm(vec![1]));
    let health = rotation.health();
    assert_eq!((health.lost, health.trouble), (6, None));
    rotation.finish();
    let (bytes, lost) = read(&health.file.unwrap());
    assert_eq!(bytes, 1);
    assert_eq!(lost.len(), 1);
    assert_eq!(lost[0].0, 6);
    assert!(lost[0].1.contains("cannot"), "{lost:?}");
}

#[test]
fn a_new_arm_is_reported_in_the_middle_of_a_file_and_in_the_next() {
    let folder = tempfile::tempdir().unwrap();
    let mut rotation = rotation(folder.path());
    rotation.handle_record(s(0), &Record::ToArm(vec![1]));
    let about = About {
        address: "tcp:arm:5555".to_owned(),
        ..About::default()
    };
    rotation.handle_record(s(1), &Record::About(Box::new(about)));
    for n in 0..100 {
        rotation.handle_record(s(2 + n), &noise(10_000, n));
    }
    rotation.finish();
    let files = recordings(folder.path()).unwrap();
    assert!(files.len() > 1);
    let mut first = Recording::open(&files[0].path).unwrap();
    first.next().unwrap();
    assert_eq!(first.about().unwrap().address, "");
    for file in files {
        let mut recording = Recording::open(file.path).unwrap();
        recording.by_ref().for_each(drop);
        assert_eq!(recording.about().unwrap().address, "tcp:arm:5555");
    }
}

#[test]
fn topics_beyond_the_limit_of_a_file_get_another_file() {
    let folder = tempfile::tempdir().unwrap();
    let mut rotation = rotation(folder.path());
    let schema = serde_json::json!({ "type": "object" });
    for n in 0..100 {
        let topic = crate::Topic::new(&format!("/{n}"), "x.X", &schema).unwrap();
        let value = serde_json::json!({ "n": n });
        let topic = topic.into();
        rotation.handle_record(s(n), &Record::Json { topic, value });
    }
    rotation.finish();
    assert_eq!(rotation.health().lost, 0);
    let files = recordings(folder.path()).unwrap();
    assert_eq!(files.len(), 2);
    let moments = files
        .iter()
        .map(|file| Recording::open(&file.path).unwrap().count());
    assert_eq!(moments.sum::<usize>(), 100);
}

/// Rear arm upright, forearm level, base rotated by this angle.
fn status(base_deg: f32) -> Vec<u8> {
    let radius_mm = 215.07;
    let status = dobot_wire::Status {
        x_mm: radius_mm * base_deg.to_radians().cos(),
        y_mm: radius_mm * base_deg.to_radians().sin(),
        rotation_deg: base_deg,
        base_deg,
        ..dobot_wire::Status::AT_ZERO
    };
    status.emit().to_bytes().to_vec()
}

/// A number from 0 to 1.
fn random(state: &mut u64) -> f64 {
    *state = state
        .wrapping_mul(6_364_136_223_846_793_005)
        .wrapping_add(1_442_695_040_888_963_407);
    f64::from(u32::try_from(*state >> 32).unwrap()) / f64::from(u32::MAX)
}

/// The station's messages while nothing happens, of realistic length.
fn state(at: Duration, seed: &mut u64) -> Record {
    let schema = serde_json::json!({ "type": "object", "description": "x".repeat(20_000) });
    let topic = crate::Topic::new("/station/state", "dobot.State", &schema).unwrap();
    let value = serde_json::json!({
        "at_s": at.as_secs_f64(),
        "link": {
            "address": "serial:/dev/ttyUSB0", "phase": "up", "problem": null, "bluetooth": false,
            "statuses_per_s": 12.5 + random(seed) / 10.0, "lost_statuses": 0,
            "damaged_bytes": 0, "latency_ms": 93.0 + random(seed),
        },
        "arm": {
            "x_mm": 215.07, "y_mm": 0.0, "z_mm": 135.0, "rotation_deg": 0.0, "base_deg": 0.0,
            "rear_deg": 0.0, "fore_deg": 0.0, "servo_deg": 0.0, "suction": false,
            "gripper_deg": 0.0, "moving": false,
        },
        "dialect": "firmware-1.1",
        "trust": { "trusted": false, "reason": "nobody has confirmed the pose yet" },
        "queue": { "waiting": 0, "under_way": 0, "ahead_s": 0.0 },
        "lease": null, "stop": null, "laser": { "armed_for_s": 0.0, "on": false },
        "job": null, "clients": 1,
    });
    Record::Json {
        topic: topic.into(),
        value,
    }
}

/// The length of an hour at rest: a status every 80 ms, half a millisecond early or late, split
/// like the data of a serial port.
fn idle_hour(cuts: &[usize]) -> u64 {
    let folder = tempfile::tempdir().unwrap();
    let mut rotation = rotation(folder.path());
    let (mut seed, mut message) = (7, 0);
    for n in 0..45_000_u64 {
        let late = |seed: &mut u64| Duration::from_secs_f64(0.001 * random(seed));
        let mut at = Duration::from_millis(80 * n);
        let status = status(0.0);
        let ends = cuts.iter().copied().chain([status.len()]);
        let mut begin = 0;
        for end in ends {
            at += late(&mut seed);
            rotation.handle_record(at, &Record::FromArm(status[begin..end].to_vec()));
            begin = end;
        }
        if n % 125 == 0 {
            rotation.handle_record(at, &state(at, &mut seed));
        }
    }
    rotation.finish();
    assert_eq!(rotation.health().lost, 0);
    let files = recordings(folder.path()).unwrap();
    for file in &files {
        let mut recording = Recording::open(&file.path).unwrap();
        message += recording
            .by_ref()
            .filter_map(|recording| match recording.entry {
                Entry::FromArm(bytes) => Some(bytes.len()),
                _ => None,
            })
            .sum::<usize>();
        assert_eq!(recording.damage(), None);
    }
    assert_eq!(message, 45_000 * 42, "nothing is missing");
    files.iter().map(|file| file.bytes).sum()
}

#[test]
fn an_hour_at_rest_takes_less_than_a_megabyte() {
    for cuts in [&[][..], &[16], &[4, 8, 12, 16, 20, 24, 28, 32, 36, 40]] {
        let bytes = idle_hour(cuts);
        assert!(
            bytes < 1_000_000,
            "{bytes} bytes, {} pieces",
            cuts.len() + 1
        );
    }
}

#[test]
fn at_rest_a_killed_program_loses_the_latest_repeats_and_of_anything_new_a_second() {
    let folder = tempfile::tempdir().unwrap();
    let mut rotation = rotation(folder.path());
    let mut news = Duration::ZERO;
    for n in 0..1000_u32 {
        let at = Duration::from_millis(80) * n;
        // It moves for a moment now and then.
        let is_new = n % 300 == 0;
        news = if is_new { at } else { news };
        let base_deg = if is_new { 30.0 } else { 0.0 };
        rotation.handle_record(at, &Record::FromArm(status(base_deg)));
        let Some(path) = rotation.health().file else {
            continue;
        };
        let last = Recording::open(&path).unwrap().last();
        let last = last.map(|last| last.at).unwrap_or_default();
        let repeats = Duration::from_millis(11_200);
        assert!(at <= last + repeats, "at {at:?}, last {last:?}");
        let is_recorded = last >= news || at <= news + Duration::from_millis(1_080);
        assert!(is_recorded, "at {at:?}, last {last:?}, new at {news:?}");
    }
}

#[test]
fn lost_records_are_reported_after_those_before_them() {
    let folder = tempfile::tempdir().unwrap();
    let mut rotation = rotation(folder.path());
    for n in 0..5 {
        rotation.handle_record(s(n), &Record::FromArm(status(0.0)));
    }
    rotation.handle_lost(3, "a test");
    rotation.handle_record(s(6), &Record::FromArm(status(0.0)));
    rotation.finish();
    let path = &recordings(folder.path()).unwrap()[0].path;
    let moments = Recording::open(path).unwrap();
    let message: Vec<_> = moments
        .filter(|moment| [RECORDER, crate::FROM_ARM].contains(&&*moment.topic))
        .map(|moment| (moment.at, &*moment.topic == RECORDER))
        .collect();
    let statuses = (0..5).map(|n| (s(n), false));
    let expected: Vec<_> = statuses.chain([(s(6), true), (s(6), false)]).collect();
    assert_eq!(message, expected);
}
