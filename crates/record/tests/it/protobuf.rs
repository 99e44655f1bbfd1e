//! Copies with Foxglove's well-known messages in protobuf.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

use dobot_record::{
    About, FROM_ARM, INK, Limits, POSE, Record, Recorder, RepairError, TARGET, TRANSFORMS, Topic,
    copy_as_protobuf, recordings,
};
use dobot_wire::{Dialect, MoveTo, Status};
use foxglove::Decode;
use foxglove::messages::{FrameTransforms, PoseInFrame, SceneUpdate, line_primitive};
use serde_json::json;

/// Records a target, a status there, and another record.
fn record(folder: &Path, other: Record) -> std::path::PathBuf {
    let about = About {
        dialect: Some(Dialect::SPECIFICATION),
        ..About::default()
    };
    let start = "2026-11-21T12:30:00Z".parse().unwrap();
    let recorder = Recorder::start(folder, Limits::DEFAULT, about, start).unwrap();
    let target = MoveTo::to(220.0, 50.0, 30.0).emit(&Dialect::SPECIFICATION);
    let record = |ms, record| recorder.record(Duration::from_millis(ms), record);
    record(
        80,
        Record::FromArm(Status::AT_ZERO.emit().to_bytes().to_vec()),
    );
    record(100, Record::ToArm(target.to_bytes().to_vec()));
    record(120, other);
    assert_eq!(recorder.finish().lost, 0);
    recordings(folder).unwrap()[0].path.clone()
}

/// The encodings and the messages of each topic.
fn read(file: &Path) -> BTreeMap<String, (String, String, Vec<Vec<u8>>)> {
    let bytes = std::fs::read(file).unwrap();
    let mut topics = BTreeMap::new();
    for message in mcap::MessageStream::new(&bytes).unwrap() {
        let message = message.unwrap();
        let schema = message.channel.schema.clone().unwrap();
        let encodings = (
            schema.encoding.clone(),
            message.channel.message_encoding.clone(),
        );
        let topic = message.channel.topic.clone();
        let entry = topics
            .entry(topic)
            .or_insert((encodings.0, encodings.1, Vec::new()));
        entry.2.push(message.data.into_owned());
    }
    topics
}

fn decoded<M: Decode>(topics: &BTreeMap<String, (String, String, Vec<Vec<u8>>)>, name: &str) -> M {
    let found = topics.get(name);
    let (schema, encoding, messages) =
        found.unwrap_or_else(|| panic!("{name}: {:?}", topics.keys()));
    assert_eq!(
        (schema.as_str(), encoding.as_str()),
        ("protobuf", "protobuf")
    );
    let message = M::decode(&messages[0][..]);
    message.unwrap_or_else(|_| panic!("{name} cannot be decoded"))
}

#[test]
fn poses_links_and_scenes_are_in_protobuf_and_everything_else_is_as_it_was() {
    let folder = tempfile::tempdir().unwrap();
    let file = record(folder.path(), Record::ToArm(vec![1]));
    let out = folder.path().join("copy");
    assert_eq!(copy_as_protobuf(&file, &out).unwrap(), None);
    let (before, after) = (read(&file), read(&out));
    assert!(after.keys().eq(before.keys()), "{:?}", after.keys());
    let pose: PoseInFrame = decoded(&after, POSE);
    let position = pose.pose.unwrap().position.unwrap();
    near(position.x, f64::from(Status::AT_ZERO.x_mm) / 1000.0);
    let moment = pose.timestamp.unwrap();
    // 2026-11-21T12:30:00Z is 1,795,264,200 s after 1970.
    assert_eq!((moment.sec(), moment.nsec()), (1_795_264_200, 80_000_000));
    let links: FrameTransforms = decoded(&after, TRANSFORMS);
    assert!(
        links
            .transforms
            .iter()
            .any(|link| link.child_frame_id == "tool")
    );
    let target: SceneUpdate = decoded(&after, TARGET);
    let aim = target.entities[0].spheres[0]
        .pose
        .unwrap()
        .position
        .unwrap();
    near(aim.x, 0.22);
    near(aim.y, 0.05);
    for (topic, messages) in before {
        let is_known = [POSE, TRANSFORMS, TARGET, INK].contains(&topic.as_str());
        if is_known {
            assert_eq!(after[&topic].2.len(), messages.2.len());
        } else {
            assert_eq!(after[&topic], messages);
        }
    }
    assert!(after.contains_key(FROM_ARM));
}

fn near(found: f64, expected: f64) {
    assert!((found - expected).abs() < 1e-9, "{found}, not {expected}");
}

/// A scene of a topic that other programs may record.
fn scene(kind: u8) -> Record {
    let schema = json!({ "type": "object" });
    let topic = Arc::new(Topic::new("/scene", "foxglove.SceneUpdate", &schema).unwrap());
    let line = json!({
        "type": kind, "pose": null, "thickness": 1.0, "scale_invariant": true, "points": [],
        "color": null, "colors": [], "indices": [],
    });
    let entity = json!({
        "timestamp": { "sec": 1, "nsec": 2 }, "frame_id": "base", "id": "a",
        "lifetime": { "sec": 0, "nsec": 0 }, "frame_locked": true, "metadata": [], "arrows": [],
        "cubes": [], "spheres": [], "cylinders": [], "lines": [line], "triangles": [],
        "texts": [], "models": [],
    });
    let value = json!({ "deletions": [], "entities": [entity] });
    Record::Json { topic, value }
}

#[test]
fn the_kinds_of_lines_keep_their_meaning() {
    for (kind, expected) in [
        (0, line_primitive::Type::LineStrip),
        (1, line_primitive::Type::LineLoop),
        (2, line_primitive::Type::LineList),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let file = record(folder.path(), scene(kind));
        let out = folder.path().join("copy");
        copy_as_protobuf(&file, &out).unwrap();
        let scene: SceneUpdate = decoded(&read(&out), "/scene");
        assert_eq!(scene.entities[0].lines[0].r#type(), expected);
    }
}

#[test]
fn a_message_that_is_not_what_its_schema_says_is_named_and_there_is_no_copy() {
    let folder = tempfile::tempdir().unwrap();
    let file = record(folder.path(), scene(9));
    let out = folder.path().join("copy");
    let error = copy_as_protobuf(&file, &out).unwrap_err();
    assert!(matches!(error, RepairError::NotConverted(_)), "{error}");
    assert!(
        error.to_string().contains("foxglove.SceneUpdate"),
        "{error}"
    );
    assert!(!out.exists());
}
