//! Recordings read back: complete, truncated and damaged files.

use std::io::Cursor;
use std::path::{Path, PathBuf};
use std::sync::{Arc, LazyLock};
use std::time::Duration;

use dobot_record::{
    About, Entry, FROM_ARM, JOINTS, Limits, Moment, POSE, Record, Recorder, Recording, TO_ARM,
    TRANSFORMS, Topic, recordings,
};
use dobot_wire::{Dialect, MoveTo, MovingMode, Status};
use jiff::Timestamp;
use proptest::collection::vec;
use proptest::prelude::*;
use serde_json::{Value, json};

fn start() -> Timestamp {
    "2026-11-21T12:30:00Z".parse().unwrap()
}

fn about() -> About {
    About {
        program: "dobot 0.1.0".to_owned(),
        address: "virtual:".to_owned(),
        dialect: Some(Dialect::SPECIFICATION),
        personality: Some("specification".to_owned()),
    }
}

fn events() -> Arc<Topic> {
    let schema = json!({ "type": "object", "properties": { "n": { "type": "integer" } } });
    Arc::new(Topic::new("/events", "dobot.Event", &schema).unwrap())
}

/// Records into a folder and finishes the file.
fn record(folder: &Path, records: impl IntoIterator<Item = (Duration, Record)>) -> Vec<PathBuf> {
    let recorder = Recorder::start(folder, SMALL, about(), start()).unwrap();
    for (at, record) in records {
        recorder.record(at, record);
    }
    let health = recorder.finish();
    assert_eq!((health.lost, health.trouble), (0, None));
    let files = recordings(folder).unwrap();
    files.into_iter().map(|file| file.path).collect()
}

fn read(bytes: impl Into<Vec<u8>>) -> (Vec<Moment>, Recording) {
    let mut recording = Recording::over(Cursor::new(bytes.into())).unwrap();
    let moments = recording.by_ref().collect();
    (moments, recording)
}

/// Four seconds with an arm: statuses, commands, events.
fn session() -> Vec<(Duration, Record)> {
    let status = Status::AT_ZERO;
    let mut records = Vec::new();
    for n in 0..50_u16 {
        let at = Duration::from_millis(80) * n.into();
        let target = MoveTo::to(f32::from(n) + 100.0, 0.0, 20.0).with_mode(MovingMode::MovL);
        let packet = target.emit(&Dialect::SPECIFICATION).to_bytes();
        records.push((at, Record::FromArm(status.emit().to_bytes().to_vec())));
        records.push((at, Record::ToArm(packet.to_vec())));
        let (topic, value) = (events(), json!({ "n": n }));
        records.push((at, Record::Json { topic, value }));
    }
    records
}

/// A finished file.
static WHOLE: LazyLock<Vec<u8>> = LazyLock::new(|| {
    let folder = tempfile::tempdir().unwrap();
    let files = record(folder.path(), session());
    assert_eq!(files.len(), 1);
    std::fs::read(&files[0]).unwrap()
});

#[test]
fn log_times_are_in_order_and_the_measured_times_are_kept_when_a_clock_goes_back() {
    let folder = tempfile::tempdir().unwrap();
    let times_ms = [100, 300, 200, 250, 400];
    let event = |at_ms| {
        let (topic, value) = (events(), json!({ "n": at_ms }));
        (Duration::from_millis(at_ms), Record::Json { topic, value })
    };
    let files = record(folder.path(), times_ms.map(event));
    let bytes = std::fs::read(&files[0]).unwrap();
    let messages = mcap::MessageStream::new(&bytes).unwrap();
    let start_ns = u64::try_from(start().as_nanosecond()).unwrap();
    let ms = |at_ns: u64| (at_ns - start_ns) / 1_000_000;
    let times: Vec<_> = messages
        .map(Result::unwrap)
        .map(|message| [message.log_time, message.publish_time].map(ms))
        .collect();
    let expected = [[100, 100], [300, 300], [300, 200], [300, 250], [400, 400]];
    assert_eq!(times, expected);
    let (moments, _) = read(bytes);
    let found: Vec<_> = moments.iter().map(|moment| moment.at.as_millis()).collect();
    assert_eq!(found, times_ms.map(u128::from));
}

#[test]
fn recorded_data_is_read_back_with_its_time() {
    let (moments, recording) = read(WHOLE.clone());
    assert_eq!(recording.damage(), None);
    assert_eq!(recording.about(), Some(&about()));
    assert_eq!(recording.start(), Some(start()));
    let mut expected = session().into_iter();
    for moment in moments {
        let entry = match moment.entry {
            Entry::ToArm(bytes) => Record::ToArm(bytes),
            Entry::FromArm(bytes) => Record::FromArm(bytes),
            Entry::Json(value) if &*moment.topic == "/events" => Record::Json {
                topic: events(),
                value,
            },
            _ => continue,
        };
        assert_eq!(Some((moment.at, entry)), expected.next());
    }
    assert_eq!(expected.next(), None);
}

#[test]
fn the_reader_of_the_format_itself_finds_messages_schemas_and_index() {
    let summary = mcap::Summary::read(&WHOLE).unwrap().expect("it has one");
    let statistics = summary.stats.expect("it has some");
    // One message for each status, command and event, and three views of the pose, which never
    // changes. The targets are too near for the arm: no path leads there.
    assert_eq!(statistics.message_count, 50 * 3 + 3);
    assert_eq!(summary.metadata_indexes.len(), 1);
    let mut topics = Vec::new();
    for channel in summary.channels.values() {
        let schema = channel.schema.as_ref().expect("every topic has one");
        assert_eq!(schema.encoding, "jsonschema");
        assert_eq!(channel.message_encoding, "json");
        let schema: Value = serde_json::from_slice(&schema.data).unwrap();
        assert_eq!(schema["type"], "object");
        topics.push(channel.topic.as_str());
    }
    for topic in [TO_ARM, FROM_ARM, POSE, JOINTS, TRANSFORMS, "/events"] {
        assert!(topics.contains(&topic), "{topic}: {topics:?}");
    }
    let mut commands = 0;
    for message in mcap::MessageStream::new(&WHOLE).unwrap() {
        let message = message.unwrap();
        let value: Value = serde_json::from_slice(&message.data).unwrap();
        if message.channel.topic == TO_ARM {
            assert_eq!(value["command"]["x_mm"], 100.0 + f64::from(commands));
            commands += 1;
        }
    }
    assert_eq!(commands, 50);
}

#[test]
fn a_truncated_file_loses_no_chunk_that_was_written() {
    let summary = mcap::Summary::read(&WHOLE).unwrap().expect("it has one");
    let mut chunks: Vec<_> = summary.chunk_indexes.iter().collect();
    chunks.sort_by_key(|chunk| chunk.chunk_start_offset);
    assert!(chunks.len() >= 3, "one for each second");
    let messages_of = |index| {
        let indexes = summary.read_message_indexes(&WHOLE, index).unwrap();
        indexes.values().map(Vec::len).sum::<usize>()
    };
    let chunks: Vec<_> = chunks
        .into_iter()
        .map(|chunk| {
            (
                chunk.chunk_start_offset + chunk.chunk_length,
                messages_of(chunk),
            )
        })
        .collect();
    let (all, _) = read(WHOLE.clone());
    let ends = chunks.iter().map(|(end, _)| usize::try_from(*end).unwrap());
    let cuts = ends.flat_map(|end| end - 1..=end + 1);
    // At each end of a chunk, and at others.
    for cut in cuts.chain((0..WHOLE.len()).step_by(7)) {
        let whole_chunks = chunks.iter().filter(|(end, _)| *end <= cut as u64);
        let expected: usize = whole_chunks.map(|(_, messages)| messages).sum();
        let (moments, recording) = read(&WHOLE[..cut]);
        assert_eq!(moments, all[..expected], "cut after {cut} bytes");
        let damage = recording.damage().expect("it has no end");
        assert!(damage.good_bytes <= cut as u64, "{damage} of {cut}");
        assert_eq!(damage.last, moments.last().map(|moment| moment.at));
    }
}

#[test]
fn a_file_that_is_not_a_recording_is_refused() {
    for bytes in [&b"x"[..], b"\x89PNG\r\n\x1a\n", b"hello, world", &[0; 100]] {
        let error = Recording::over(Cursor::new(bytes.to_vec())).unwrap_err();
        assert!(error.to_string().contains("not a recording"), "{error}");
    }
    assert!(Recording::open("no-such-file.mcap").is_err());
}

/// A file with one record, whose length may be wrong.
fn file_of(kind: u8, len: u64, body: &[u8]) -> Vec<u8> {
    [mcap::MAGIC, &[kind], &len.to_le_bytes(), body].concat()
}

#[test]
fn false_lengths_in_a_file_cost_no_memory() {
    let chunk = |uncompressed: u64, compression: &[u8], records: u64| {
        let compression_len = u32::try_from(compression.len()).unwrap();
        [
            &[0; 16],
            &uncompressed.to_le_bytes()[..],
            &[0; 4],
            &compression_len.to_le_bytes(),
            compression,
            &records.to_le_bytes(),
            &[0x05, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF],
        ]
        .concat()
    };
    let long_text = [&[1, 0, 1, 0][..], &u32::MAX.to_le_bytes()].concat();
    let bodies = [
        (0x06, chunk(u64::MAX, b"zstd", 9)),
        (0x06, chunk(1 << 20, b"zstd", u64::MAX)),
        (0x06, chunk(9, b"zstd", 9)),
        (0x06, chunk(9, b"", 9)),
        (0x06, chunk(9, b"lz4", 9)),
        (0x04, long_text.clone()),
        (0x0C, long_text),
        (0x05, vec![1, 2, 3]),
    ];
    for (kind, body) in bodies {
        for len in [body.len() as u64, u64::MAX, 1 << 40, 1 << 22] {
            let (moments, recording) = read(file_of(kind, len, &body));
            assert_eq!(moments, []);
            let damage = recording.damage().expect("it is damaged");
            assert_eq!(damage.good_bytes, 8, "{damage}");
        }
    }
}

#[test]
fn a_topic_with_an_overlong_name_is_damage() {
    let text = |text: &str| {
        [
            &u32::try_from(text.len()).unwrap().to_le_bytes(),
            text.as_bytes(),
        ]
        .concat()
    };
    let body = [
        &[1, 0, 1, 0][..],
        &text(&"x".repeat(300)),
        &text("json"),
        &[0; 4],
    ]
    .concat();
    let (_, recording) = read(file_of(0x04, body.len() as u64, &body));
    let damage = recording.damage().expect("it is damaged");
    assert!(
        damage.reason.contains("300 bytes; allowed are 256"),
        "{damage}"
    );
}

fn any_record() -> impl Strategy<Value = Record> {
    prop_oneof![
        vec(any::<u8>(), 1..100).prop_map(Record::ToArm),
        vec(any::<u8>(), 1..100).prop_map(Record::FromArm),
        (any::<i64>(), ".{0,40}").prop_map(|(n, text)| Record::Json {
            topic: events(),
            value: json!({ "n": n, "text": text }),
        }),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]
    #[test]
    fn all_recorded_data_is_read_back(
        records in vec((0..100_000_000_000_u64, any_record()), 1..60),
    ) {
        let folder = tempfile::tempdir().unwrap();
        let timed = records.iter().map(|(at, record)| (Duration::from_nanos(*at), record.clone()));
        let files = record(folder.path(), timed);
        let (moments, recording) = read(std::fs::read(&files[0]).unwrap());
        prop_assert_eq!(recording.damage(), None);
        // Bytes may come back split, but with the same times and in the same order.
        let mut moments = moments.into_iter().peekable();
        for (at, record) in records {
            let at = Duration::from_nanos(at);
            match record {
                Record::ToArm(bytes) | Record::FromArm(bytes) => {
                    let mut found = Vec::new();
                    while found.len() < bytes.len() {
                        let moment = moments.next().unwrap();
                        prop_assert_eq!(moment.at, at);
                        if let Entry::ToArm(piece) | Entry::FromArm(piece) = moment.entry {
                            found.extend(piece);
                        }
                    }
                    prop_assert_eq!(found, bytes);
                }
                Record::Json { value, .. } => {
                    let moment = moments.find(|moment| &*moment.topic == "/events").unwrap();
                    prop_assert_eq!(moment.at, at);
                    prop_assert_eq!(moment.entry, Entry::Json(value));
                }
                Record::About(_) | Record::Tools(_) | Record::Pen { .. } => {
                    unreachable!("none was recorded")
                }
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]
    #[test]
    fn damage_costs_at_most_the_data_after_it_and_never_panics(
        hits in vec((8..WHOLE.len(), any::<u8>()), 1..8),
    ) {
        let mut file = WHOLE.clone();
        for (place, byte) in &hits {
            file[*place] = *byte;
        }
        let first = hits.iter().map(|(place, _)| *place).min().unwrap();
        let (intact, _) = read(&WHOLE[..first]);
        let (moments, _) = read(file);
        prop_assert!(moments.starts_with(&intact), "{} of {}", moments.len(), intact.len());
    }

    #[test]
    fn noise_never_panics(noise in vec(any::<u8>(), 0..2000)) {
        let (_, recording) = read([mcap::MAGIC, &noise].concat());
        prop_assert!(recording.damage().is_some());
    }

    #[test]
    fn invalid_records_never_panic(
        records in vec((1..16_u8, vec(any::<u8>(), 0..60)), 1..20),
        compress in any::<bool>(),
    ) {
        let mut bytes = Vec::new();
        for (kind, body) in records {
            bytes.push(kind);
            bytes.extend((body.len() as u64).to_le_bytes());
            bytes.extend(body);
        }
        if !compress {
            let header = [&[0; 16][..], &(bytes.len() as u64).to_le_bytes(), &[0; 8]].concat();
            let chunk = [header, (bytes.len() as u64).to_le_bytes().to_vec(), bytes.clone()].concat();
            bytes = file_of(0x06, chunk.len() as u64, &chunk).split_off(8);
        }
        let (_, recording) = read([mcap::MAGIC, &bytes].concat());
        prop_assert!(recording.damage().is_some());
    }
}

const SMALL: Limits = Limits {
    file_bytes: 1 << 20,
    total_bytes: 4 << 20,
};
