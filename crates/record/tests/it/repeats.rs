//! Repeated statuses are written once, with all their times, and read back entry by entry.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use dobot_record::{
    About, Entry, FROM_ARM, JOINTS, Limits, Moment, Record, Recorder, Recording, Topic, recordings,
};
use dobot_wire::{Decoder, Status};
use proptest::collection::vec;
use proptest::prelude::*;
use serde_json::{Value, json};

/// Rear arm upright, forearm level, with or without the pump.
fn status(suction: bool) -> [u8; 42] {
    let status = Status {
        suction,
        ..Status::AT_ZERO
    };
    status.emit().to_bytes()
}

/// Records from noon on.
fn record(folder: &Path, records: impl IntoIterator<Item = (Duration, Record)>) -> PathBuf {
    let start = "2026-11-21T12:00:00Z".parse().unwrap();
    let recorder = Recorder::start(folder, Limits::DEFAULT, About::default(), start).unwrap();
    for (at, record) in records {
        recorder.record(at, record);
    }
    assert_eq!(recorder.finish().lost, 0);
    let mut files = recordings(folder).unwrap();
    assert_eq!(files.len(), 1);
    files.remove(0).path
}

fn read(file: &Path) -> Vec<Moment> {
    let mut recording = Recording::open(file).unwrap();
    let moments = recording.by_ref().collect();
    assert_eq!(recording.damage(), None);
    moments
}

/// The messages of a topic as in the file.
fn messages(file: &Path, topic: &str) -> Vec<(u64, Value)> {
    let bytes = std::fs::read(file).unwrap();
    let messages = mcap::MessageStream::new(&bytes).unwrap();
    let messages = messages.map(Result::unwrap);
    let messages = messages.filter(|message| message.channel.topic == topic);
    messages
        .map(|message| {
            (
                message.log_time,
                serde_json::from_slice(&message.data).unwrap(),
            )
        })
        .collect()
}

/// 2026-11-21T12:00:00Z in nanoseconds since 1970.
const NOON_NS: u64 = 1_795_262_400_000_000_000;

#[test]
fn a_repeated_status_is_one_message_with_the_gaps_between_its_times() {
    let folder = tempfile::tempdir().unwrap();
    let times_ms = [0, 80, 160, 241, 320];
    let at = |ms: u64| Duration::from_millis(ms);
    let same = |ms: &u64| (at(*ms), Record::FromArm(status(false).to_vec()));
    let other = (at(400), Record::FromArm(status(true).to_vec()));
    let file = record(folder.path(), times_ms.iter().map(same).chain([other]));
    let wire = messages(&file, FROM_ARM);
    assert_eq!(wire.len(), 3, "{wire:?}");
    assert_eq!(wire[0].0, NOON_NS);
    assert_eq!(wire[0].1.get("gaps_ns"), None);
    // The last one came at 320 ms, 79 after the one before, and so on back to the one at 80 ms.
    assert_eq!(wire[1].0, NOON_NS + 320_000_000);
    assert_eq!(wire[1].1["at_s"], 0.32);
    let gaps = json!([80_000_000, 81_000_000, 79_000_000]);
    assert_eq!(wire[1].1["gaps_ns"], gaps);
    assert_eq!(wire[1].1["bytes"], wire[0].1["bytes"]);
    assert_eq!(wire[1].1["status"], wire[0].1["status"]);
    assert_eq!(wire[2].1["status"]["suction"], true);
    // The views: at the change, at the end of the repetitions, at the next change.
    let joints = messages(&file, JOINTS);
    let times: Vec<_> = joints.iter().map(|joint| joint.1["at_s"].clone()).collect();
    assert_eq!(times, [json!(0.0), json!(0.32), json!(0.4)]);
    let moments = read(&file);
    let statuses = moments.iter().filter(|moment| &*moment.topic == FROM_ARM);
    let times: Vec<_> = statuses.map(|status| status.at).collect();
    assert_eq!(times, [0, 80, 160, 241, 320, 400].map(at));
}

#[test]
fn repeats_are_reported_every_ten_seconds() {
    let folder = tempfile::tempdir().unwrap();
    let same = |n: u64| {
        let at = Duration::from_millis(80 * n);
        (at, Record::FromArm(status(false).to_vec()))
    };
    let file = record(folder.path(), (0..500).map(same));
    let times = messages(&file, FROM_ARM)
        .into_iter()
        .map(|message| message.0);
    let times: Vec<_> = times.map(|ns| (ns - NOON_NS) / 1_000_000).collect();
    // 125 gaps of 80 ms are ten seconds.
    assert_eq!(times, [0, 10_080, 20_160, 30_240, 39_920]);
}

#[test]
fn a_split_repeat_has_the_time_of_its_last_piece_and_an_incomplete_one_is_kept_as_it_is() {
    let folder = tempfile::tempdir().unwrap();
    let bytes = status(false).repeat(4);
    // Three complete ones, two of them in pieces, and 33 bytes of a fourth.
    let cuts = [0, 42, 58, 84, 100, 110, 126, 140, 159];
    let mut ms = 0;
    let records = cuts.windows(2).map(|cut| {
        ms += 20;
        let piece = bytes[cut[0]..cut[1]].to_vec();
        (Duration::from_millis(ms), Record::FromArm(piece))
    });
    let file = record(folder.path(), records);
    let wire = messages(&file, FROM_ARM);
    assert_eq!(wire.len(), 4, "{wire:?}");
    let found = read(&file)
        .into_iter()
        .filter_map(|value| match value.entry {
            Entry::FromArm(bytes) => Some((value.at.as_millis(), bytes.len())),
            _ => None,
        });
    let found: Vec<_> = found.collect();
    assert_eq!(found, [(20, 42), (60, 42), (120, 42), (140, 14), (160, 19)]);
}

/// The next input: a time and its content.
#[derive(Clone, Debug)]
enum Next {
    /// Bytes of one or more statuses: which one, and the number of bytes up to the split.
    Status(bool, usize),
    Noise(Vec<u8>),
    Sent,
    Event,
}

fn next() -> impl Strategy<Value = (i64, Next)> {
    let what = prop_oneof![
        12 => Just(Next::Status(false, 42)),
        4 => (any::<bool>(), 1..100_usize).prop_map(|(which, len)| Next::Status(which, len)),
        1 => vec(any::<u8>(), 1..60).prop_map(Next::Noise),
        1 => Just(Next::Sent),
        1 => Just(Next::Event),
    ];
    // Time sometimes stops or goes back, which it should not.
    let gap_ns = prop_oneof![
        20 => 0..200_000_000_i64,
        2 => Just(0_i64),
        1 => -50_000_000..0_i64,
        1 => 0..15_000_000_000_i64,
    ];
    (gap_ns, what)
}

/// The records: statuses follow each other byte by byte, however they are split.
fn records(list: Vec<(i64, Next)>) -> Vec<(Duration, Record)> {
    let topic = Topic::new("/events", "x.Event", &json!({ "type": "object" })).unwrap();
    let topic = Arc::new(topic);
    let (mut at_ns, mut place) = (0_i64, 0);
    let mut records = Vec::new();
    for (n, (gap_ns, next)) in list.into_iter().enumerate() {
        at_ns = (at_ns + gap_ns).max(0);
        let record = match next {
            Next::Status(which, len) => {
                let bytes = status(which);
                let bytes = bytes.iter().cycle().skip(place).take(len);
                place = (place + len) % 42;
                Record::FromArm(bytes.copied().collect())
            }
            Next::Noise(bytes) => Record::FromArm(bytes),
            Next::Sent => Record::ToArm(vec![1, 2, 3]),
            Next::Event => Record::Json {
                topic: Arc::clone(&topic),
                value: json!({ "n": n }),
            },
        };
        records.push((Duration::from_nanos(at_ns.unsigned_abs()), record));
    }
    records
}

/// The entries in order: packets of the arm when complete, and everything else; and all bytes of
/// the arm.
#[derive(Debug, Default, PartialEq)]
struct Received {
    all: Vec<(Duration, String, Vec<u8>)>,
    from_arm: Vec<u8>,
}

impl Received {
    fn of(records: impl Iterator<Item = (Duration, String, Vec<u8>)>) -> Self {
        let mut received = Self::default();
        let mut decoder = Decoder::statuses(dobot_session::plausible);
        for (at, topic, bytes) in records {
            if topic != FROM_ARM {
                received.all.push((at, topic, bytes));
                continue;
            }
            for frame in decoder.feed(&bytes) {
                let packet = frame.to_bytes().to_vec();
                received.all.push((at, topic.clone(), packet));
            }
            received.from_arm.extend(bytes);
        }
        received
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]
    #[test]
    fn repeats_in_any_pieces_keep_their_times_and_their_order(
        list in vec(next(), 1..80),
    ) {
        let folder = tempfile::tempdir().unwrap();
        let records = records(list);
        let file = record(folder.path(), records.clone());
        let found = Received::of(read(&file).into_iter().filter_map(|message| match message.entry {
            Entry::ToArm(bytes) | Entry::FromArm(bytes) => Some((message.at, message.topic.to_string(), bytes)),
            Entry::Json(value) if &*message.topic == "/events" => {
                Some((message.at, message.topic.to_string(), value.to_string().into_bytes()))
            }
            _ => None,
        }));
        let expected = Received::of(records.into_iter().map(|(at, record)| match record {
            Record::ToArm(bytes) => (at, "/wire/to_arm".to_owned(), bytes),
            Record::FromArm(bytes) => (at, FROM_ARM.to_owned(), bytes),
            Record::Json { value, .. } => (at, "/events".to_owned(), value.to_string().into_bytes()),
            Record::About(_) | Record::Tools(_) | Record::Pen { .. } => {
                unreachable!("there is none")
            }
        }));
        prop_assert_eq!(found, expected);
    }
}
