//! Exports of recordings as tables and datasets, read back.

use std::fs::File;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use bytes::Bytes;
use dobot_record::tables::{
    Dataset, DatasetPart, ExportError, MarkedEpisode, Table, TableForm, Values, Written,
    export_files, export_lerobot, export_tables, holds_packets, marked_episodes, read_tables,
};
use dobot_record::{About, Limits, Record, Recorder, Recording, Topic, recordings};
use dobot_wire::{Dialect, JointJog, JointJogAxis, MoveTo, Status};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::RowAccessor;
use serde_json::{Value, json};

const ALL: RangeInclusive<Duration> = Duration::ZERO..=Duration::MAX;

/// The recorded entries and their times, in milliseconds.
fn recorded(folder: &Path, records: impl IntoIterator<Item = (u64, Record)>) -> PathBuf {
    let about = About {
        dialect: Some(Dialect::SPECIFICATION),
        ..About::default()
    };
    let start = "2026-11-21T12:30:00Z".parse().unwrap();
    let recorder = Recorder::start(folder, Limits::DEFAULT, about, start).unwrap();
    for (at_ms, record) in records {
        recorder.record(Duration::from_millis(at_ms), record);
    }
    assert_eq!(recorder.finish().lost, 0);
    recordings(folder).unwrap().remove(0).path
}

/// A status that the arm can send: the base rotates the tool.
fn turned(base_deg: f32, suction: bool) -> Record {
    let (sin, cos) = base_deg.to_radians().sin_cos();
    let status = Status {
        x_mm: 215.07 * cos,
        y_mm: 215.07 * sin,
        rotation_deg: base_deg,
        base_deg,
        suction,
        ..Status::AT_ZERO
    };
    Record::FromArm(status.emit().to_bytes().to_vec())
}

/// Two seconds of rotation, half a second of rest, three of silence, and a rotation back; with
/// three packets, of which one is not a command and one comes in two pieces.
fn session() -> Vec<(u64, Record)> {
    let target = MoveTo::to(200.0, 0.0, 20.0)
        .emit(&Dialect::SPECIFICATION)
        .to_bytes();
    let mut bad = target;
    // Float 8 (bytes 29 to 32), the moving mode, becomes 3, which no table allows.
    bad[29..33].copy_from_slice(&3.0_f32.to_le_bytes());
    let jog = JointJog {
        axis: JointJogAxis::BasePlus,
        speed_percent: 50.0,
    };
    let jog = jog.emit(&Dialect::SPECIFICATION).to_bytes();
    let mut records = vec![
        (0, Record::ToArm(target.to_vec())),
        (1, Record::ToArm(bad.to_vec())),
        (2, Record::ToArm(jog[..10].to_vec())),
        (3, Record::ToArm(jog[10..].to_vec())),
    ];
    records.extend((0_u16..25).map(|n| (100 + 80 * u64::from(n), turned(f32::from(n), n > 10))));
    records.extend((0..7).map(|n| (2100 + 80 * n, turned(24.0, true))));
    records.extend(
        (0_u16..10).map(|n| (5600 + 80 * u64::from(n), turned(24.0 - f32::from(n), false))),
    );
    // A single status has no motion.
    records.push((9000, turned(0.0, false)));
    records
}

fn tables(file: &Path, stretch: &RangeInclusive<Duration>) -> (Written, [Vec<u8>; 4]) {
    let open = || Recording::open(file).unwrap();
    let [mut a, mut b, mut c, mut d] = [const { Vec::new() }; 4];
    let csv = export_tables(
        &mut open(),
        stretch,
        Table::statuses_csv(&mut a).unwrap(),
        Table::commands_csv(&mut b).unwrap(),
    );
    let parquet = export_tables(
        &mut open(),
        stretch,
        Table::statuses_parquet(&mut c).unwrap(),
        Table::commands_parquet(&mut d).unwrap(),
    );
    assert_eq!(csv.as_ref().unwrap(), parquet.as_ref().unwrap());
    (csv.unwrap(), [a, b, c, d])
}

fn rows(csv: &[u8]) -> Vec<Vec<String>> {
    let mut reader = csv::Reader::from_reader(csv);
    let records = reader.records().map(|record| record.unwrap());
    records
        .map(|record| record.iter().map(str::to_owned).collect())
        .collect()
}

#[test]
fn every_status_is_a_row_with_its_time_and_every_packet_one_with_its_meaning() {
    let folder = tempfile::tempdir().unwrap();
    let file = recorded(folder.path(), session());
    let (written, [statuses, commands, ..]) = tables(&file, &ALL);
    assert_eq!((written.statuses, written.commands), (43, 3));
    let statuses = rows(&statuses);
    assert_eq!(statuses.len(), 43);
    assert_eq!(statuses[3][..2], ["2026-11-21T12:30:00.340000000Z", "0.34"]);
    assert_eq!(statuses[3][6], "3.0");
    assert_eq!((&*statuses[10][10], &*statuses[11][10]), ("false", "true"));
    let commands = rows(&commands);
    assert_eq!(commands[0][2], "move_to");
    let fields: Value = serde_json::from_str(&commands[0][3]).unwrap();
    assert_eq!(fields["x_mm"], 200.0);
    assert_eq!((&*commands[1][2], &*commands[1][3]), ("", ""));
    assert!(commands[1][4].contains("float 8"), "{:?}", commands[1]);
    assert_eq!(commands[1][12], "3.0");
    // It was complete with its second piece.
    assert_eq!(
        commands[2][..3],
        ["2026-11-21T12:30:00.003000000Z", "0.003", "joint_jog"]
    );
}

/// polars takes a column whose first cells have no decimal point for one of integers.
#[test]
fn the_cells_of_a_csv_column_all_look_like_its_type() {
    let folder = tempfile::tempdir().unwrap();
    let file = recorded(folder.path(), session());
    let (_, [statuses, commands, ..]) = tables(&file, &ALL);
    for table in [rows(&statuses), rows(&commands)] {
        for column in 0..table[0].len() {
            let cells = table.iter().map(|row| &*row[column]);
            let mut kinds: Vec<&str> = cells
                .filter(|cell| !cell.is_empty())
                .map(looks_like)
                .collect();
            kinds.sort_unstable();
            kinds.dedup();
            assert!(kinds.len() <= 1, "column {column}: {kinds:?}");
        }
        let times = table.iter().map(|row| row[0].len());
        assert!(
            times
                .clone()
                .all(|len| len == "2026-11-21T12:30:00.340000000Z".len())
        );
    }
}

fn looks_like(cell: &str) -> &str {
    if cell.parse::<i64>().is_ok() {
        "an integer"
    } else if cell.parse::<f64>().is_ok() {
        "a float"
    } else if cell.parse::<bool>().is_ok() {
        "a truth value"
    } else {
        "a text"
    }
}

#[test]
fn parquet_holds_what_csv_holds() {
    let folder = tempfile::tempdir().unwrap();
    let file = recorded(folder.path(), session());
    let (_, [statuses, _, parquet, _]) = tables(&file, &ALL);
    let reader = SerializedFileReader::new(Bytes::from(parquet)).unwrap();
    let found = reader.get_row_iter(None).unwrap().map(|row| row.unwrap());
    for (row, expected) in found.zip(rows(&statuses)) {
        assert_eq!(format!("{:?}", row.get_double(1).unwrap()), expected[1]);
        for (n, number) in expected.iter().enumerate().take(10).skip(2) {
            assert_eq!(format!("{:?}", row.get_float(n).unwrap()), *number);
        }
        assert_eq!(row.get_bool(10).unwrap().to_string(), expected[10]);
    }
    assert_eq!(reader.metadata().file_metadata().num_rows(), 43);
}

#[test]
fn an_excerpt_contains_the_events_within_it() {
    let folder = tempfile::tempdir().unwrap();
    let file = recorded(folder.path(), session());
    let stretch = Duration::from_millis(100)..=Duration::from_millis(260);
    let (written, _) = tables(&file, &stretch);
    assert_eq!((written.statuses, written.commands), (3, 0));
    let open = || Recording::open(&file).unwrap();
    assert!(holds_packets(&mut open(), &stretch));
    let silence = Duration::from_secs(3)..=Duration::from_secs(5);
    assert!(!holds_packets(&mut open(), &silence));
}

fn part(file: &Path, period: RangeInclusive<Duration>, task: &str) -> DatasetPart {
    let (recording, task) = (Recording::open(file).unwrap(), task.to_owned());
    DatasetPart {
        recording,
        period,
        task,
    }
}

/// The numbers of frames of the episodes of a dataset.
fn episode_lengths(out: &Path) -> Vec<i64> {
    let file = File::open(out.join("meta/episodes/chunk-000/file-000.parquet")).unwrap();
    let reader = SerializedFileReader::new(file).unwrap();
    let rows = reader.get_row_iter(None).unwrap();
    rows.map(|row| row.unwrap().get_long(2).unwrap()).collect()
}

#[test]
fn several_recordings_make_one_dataset_with_the_episodes_of_each() {
    let folder = tempfile::tempdir().unwrap();
    let files = ["a", "b"].map(|name| recorded(&folder.path().join(name), session()));
    let out = folder.path().join("dataset");
    let found = export_lerobot(
        &mut files.map(|file| part(&file, ALL, "Turn.")),
        false,
        &out,
    )
    .unwrap();
    let expected = Dataset {
        episodes: 4,
        frames: 2 * (63 + 19),
        left_out: 2,
    };
    assert_eq!(found, expected);
    assert_eq!(episode_lengths(&out), [63, 19, 63, 19]);
}

#[test]
fn episodes_are_the_marked_periods() {
    let folder = tempfile::tempdir().unwrap();
    let file = recorded(folder.path(), session());
    let out = folder.path().join("dataset");
    let period = |from, to| Duration::from_millis(from)..=Duration::from_millis(to);
    // Statuses come every 80 ms, from 100 ms on.
    let mut parts = [
        part(&file, period(100, 500), "Turn."),
        part(&file, period(580, 900), "Turn on."),
        part(&file, period(100, 500), "Turn."),
    ];
    let found = export_lerobot(&mut parts, false, &out).unwrap();
    assert_eq!(
        (found.episodes, episode_lengths(&out)),
        (3, vec![11, 9, 11])
    );
    let tasks = File::open(out.join("meta/tasks.parquet")).unwrap();
    let reader = SerializedFileReader::new(tasks).unwrap();
    let rows = reader.get_row_iter(None).unwrap().map(Result::unwrap);
    let tasks: Vec<_> = rows.map(|row| row.get_string(1).unwrap().clone()).collect();
    assert_eq!(tasks, ["Turn.", "Turn on."]);
}

#[test]
fn marked_episodes_end_at_the_next_mark_and_discarded_ones_are_left_out() {
    let folder = tempfile::tempdir().unwrap();
    let schema = json!({ "type": "object" });
    let topic = Arc::new(Topic::new("/station/notices", "dobot.Notice", &schema).unwrap());
    let marks = [
        (1000, "begin", Some("Pick.")),
        (2000, "end", None),
        (3000, "begin", None),
        (4000, "discard", None),
        (5000, "begin", None),
        (6000, "begin", None),
        (7000, "end", None),
        (8000, "discard", None),
        (9000, "begin", Some("Place.")),
    ];
    let records = marks.map(|(at_ms, mark, task)| {
        let value = json!({ "type": "episode_marked", "mark": mark, "task": task, "text": "" });
        let topic = Arc::clone(&topic);
        (at_ms, Record::Json { topic, value })
    });
    let end = [(10_000, turned(0.0, false))];
    let file = recorded(folder.path(), records.into_iter().chain(end));
    let episode = |from_s, to_s, task: Option<&str>| MarkedEpisode {
        period: Duration::from_secs(from_s)..=Duration::from_secs(to_s),
        task: task.map(str::to_owned),
    };
    assert_eq!(
        marked_episodes(&mut Recording::open(&file).unwrap()),
        [
            episode(1, 2, Some("Pick.")),
            episode(5, 6, None),
            episode(9, 10, Some("Place.")),
        ]
    );
}

#[test]
fn an_episode_without_idle_time_begins_and_ends_with_motion() {
    let folder = tempfile::tempdir().unwrap();
    // Two seconds of rest, a turn for half a second, a switch of the pump, and two seconds of rest.
    let angle = |n: u16| f32::from(n.clamp(25, 31) - 25);
    let session = (0..60).map(|n: u16| (u64::from(n) * 80, turned(angle(n), n >= 35)));
    let file = recorded(folder.path(), session);
    let out = folder.path().join("dataset");
    let found = export_lerobot(&mut [part(&file, ALL, "Turn.")], true, &out).unwrap();
    // From 0.5 s before 2 s to 0.5 s after 2.8 s, each 40 ms.
    let expected = (2800 - 2000) / 40 + 1 + 2 * 12;
    assert_eq!((found.episodes, found.frames), (1, expected));
    let rest = (0..60).map(|n| (n * 80, turned(3.0, false)));
    let file = recorded(&folder.path().join("rest"), rest);
    let out = folder.path().join("nothing");
    let found = export_lerobot(&mut [part(&file, ALL, "Turn.")], true, &out);
    assert!(matches!(found, Err(ExportError::NoMotion)), "{found:?}");
}

#[test]
fn a_dataset_has_an_episode_for_each_stretch_without_silence() {
    let folder = tempfile::tempdir().unwrap();
    let file = recorded(folder.path(), session());
    let out = folder.path().join("dataset");
    let dataset = export_lerobot(&mut [part(&file, ALL, "Turn.")], false, &out).unwrap();
    // 100 to 2580 ms and 5600 to 6320 ms, each 40 ms.
    let expected = Dataset {
        episodes: 2,
        frames: 63 + 19,
        left_out: 1,
    };
    assert_eq!(dataset, expected);
    let data = File::open(out.join("data/chunk-000/file-000.parquet")).unwrap();
    let reader = SerializedFileReader::new(data).unwrap();
    let rows: Vec<_> = reader
        .get_row_iter(None)
        .unwrap()
        .map(|row| row.unwrap())
        .collect();
    let base = |row: usize, column: usize| {
        let list = rows[row].get_list(column).unwrap();
        assert_eq!(list.len(), 6);
        match list.elements()[0] {
            parquet::record::Field::Float(number) => number,
            ref other => panic!("{other:?}"),
        }
    };
    // 1 degree in 80 ms.
    for row in 0..48 {
        let expected = f32::from(u16::try_from(row).unwrap()) / 2.0;
        assert!(
            (base(row, 0) - expected).abs() < 1e-5,
            "{row}: {}",
            base(row, 0)
        );
        assert_eq!(
            base(row, 2),
            base(row + 1, 0),
            "the action of row {row} is what comes next"
        );
    }
    // The last one of an episode stays.
    assert_eq!((base(62, 0), base(62, 2)), (24.0, 24.0));
    assert_eq!((base(63, 0), base(81, 2)), (24.0, 15.0));
    let integer = |row: usize, column: usize| rows[row].get_long(column).unwrap();
    assert_eq!(
        [integer(62, 4), integer(62, 5), integer(62, 6)],
        [62, 0, 62]
    );
    assert_eq!([integer(63, 4), integer(63, 5), integer(63, 6)], [0, 1, 63]);
}

#[test]
fn nothing_is_left_of_a_dataset_that_cannot_be_made() {
    let folder = tempfile::tempdir().unwrap();
    let file = recorded(
        folder.path(),
        [(0, turned(1.0, false)), (5000, turned(2.0, false))],
    );
    let out = folder.path().join("dataset");
    let export = |task| export_lerobot(&mut [part(&file, ALL, task)], false, &out);
    assert!(matches!(export("Turn."), Err(ExportError::NoMotion)));
    assert!(matches!(export(" "), Err(ExportError::NoTask)));
    assert!(!out.exists());
    // Existing files stay unchanged.
    std::fs::create_dir(&out).unwrap();
    std::fs::write(out.join("mine"), "mine").unwrap();
    assert!(matches!(export("Turn."), Err(ExportError::Io(_))));
    assert_eq!(std::fs::read_to_string(out.join("mine")).unwrap(), "mine");
}

#[test]
fn a_truncated_recording_is_exported_up_to_its_end() {
    let folder = tempfile::tempdir().unwrap();
    let file = recorded(folder.path(), session());
    let whole = std::fs::read(&file).unwrap();
    let mut before = 0;
    for len in (100..whole.len()).step_by(97) {
        std::fs::write(&file, &whole[..len]).unwrap();
        let (written, _) = tables(&file, &ALL);
        assert!(written.statuses >= before, "{len} bytes");
        before = written.statuses;
    }
    assert_eq!(before, 43);
}

/// Writes the recording for other programs: `tests/recordings/tables.sh` runs this.
#[test]
#[ignore = "it writes a file for others"]
fn samples() {
    let folder =
        std::env::var_os("DOBOT_RECORD_SAMPLES").expect("DOBOT_RECORD_SAMPLES names a folder");
    recorded(Path::new(&folder), session());
}

#[test]
fn columns_in_memory_hold_what_csv_holds() {
    let folder = tempfile::tempdir().unwrap();
    let file = recorded(folder.path(), session());
    let stretch = Duration::from_millis(300)..=Duration::from_secs(5);
    let (_, [statuses, commands, ..]) = tables(&file, &stretch);
    let read = read_tables(&mut Recording::open(&file).unwrap(), &stretch);
    for (columns, csv) in [(read.statuses, statuses), (read.commands, commands)] {
        let rows = rows(&csv);
        assert!(!rows.is_empty() || columns[0].name == "time");
        for (at, column) in columns.iter().enumerate() {
            let texts: Vec<String> = rows.iter().map(|row| row[at].clone()).collect();
            let read: Vec<String> = match &column.values {
                Values::Floats(all) => all.iter().map(|value| format!("{value:?}")).collect(),
                Values::Doubles(all) => all.iter().map(|value| format!("{value:?}")).collect(),
                Values::Truths(all) => all.iter().map(ToString::to_string).collect(),
                Values::Texts(all) => all
                    .iter()
                    .map(|item| item.clone().unwrap_or_default())
                    .collect(),
                // 2026-11-21T12:30:00Z
                Values::Times(all) => {
                    let begun_ns = 1_795_264_200_000_000_000_i64;
                    assert!(
                        all.iter()
                            .all(|item| (300_000_000..=5_000_000_000).contains(&(item - begun_ns)))
                    );
                    continue;
                }
            };
            assert_eq!(read, texts, "{}", column.name);
        }
    }
}

#[test]
fn existing_files_are_overwritten_only_on_request() {
    let folder = tempfile::tempdir().unwrap();
    let file = recorded(folder.path(), session());
    let out = folder.path().join("run.csv");
    let beside = folder.path().join("run.commands.csv");
    let export = |overwrites| {
        let mut recording = Recording::open(&file).unwrap();
        export_files(&mut recording, &ALL, TableForm::Csv, &out, overwrites)
    };
    std::fs::write(&beside, "mine").unwrap();
    let error = export(false).unwrap_err();
    assert!(error.to_string().contains("run.commands.csv"), "{error}");
    assert!(!out.exists(), "half of it is left behind");
    assert_eq!(std::fs::read_to_string(&beside).unwrap(), "mine");
    let (written, message) = export(true).unwrap();
    assert_eq!((written.statuses, message), (43, beside.clone()));
    assert_eq!(rows(&std::fs::read(&beside).unwrap()).len(), 3);
    assert!(matches!(export(false), Err(ExportError::File { .. })));
    assert_eq!(rows(&std::fs::read(&out).unwrap()).len(), 43);
}
