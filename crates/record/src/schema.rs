//! The schemas of the recorder's own topics.

use std::sync::LazyLock;

use dobot_wire::Status;
use serde_json::{Value, json};

use crate::Topic;
use crate::topic::{FROM_ARM, JOINTS, POSE, RECORDER, TO_ARM, TRANSFORM};

/// The recorder's own topic of that name.
pub(crate) fn own(name: &str) -> Option<&'static Topic> {
    topics().iter().find(|topic| topic.name() == name)
}

/// The topics of what is on the wire, and of the recorder itself.
#[must_use]
pub fn topics() -> &'static [Topic] {
    &*OWN
}

static OWN: LazyLock<[Topic; 6]> = LazyLock::new(|| {
    [
        Topic::own(TO_ARM, "dobot.ToArm", &to_arm()),
        Topic::own(FROM_ARM, "dobot.FromArm", &from_arm()),
        Topic::own(POSE, "foxglove.PoseInFrame", &pose_in_frame()),
        Topic::own(JOINTS, "dobot.Joints", &joints()),
        Topic::own(TRANSFORM, "foxglove.FrameTransform", &frame_transform()),
        Topic::own(RECORDER, "dobot.Recorder", &recorder()),
    ]
});

fn to_arm() -> Value {
    object(
        "Bytes on their way to the arm",
        &["at_s", "bytes"],
        &json!({
            "at_s": at_s(),
            "bytes": { "type": "string", "description": "Hex digits" },
            "command": {
                "type": "object",
                "description": "The command that these bytes complete, if they do",
                "properties": { "type": { "type": "string" } },
            },
            "error": { "type": "string", "description": "Why the packet is no command" },
        }),
    )
}

fn from_arm() -> Value {
    let mut status = Value::from(schemars::schema_for!(Status));
    if let Some(fields) = status.as_object_mut() {
        fields.remove("$schema");
    }
    object(
        "Bytes that came from the arm; with gaps_ns, the same packet that came again and again",
        &["at_s", "bytes"],
        &json!({
            "at_s": at_s(),
            "bytes": { "type": "string", "description": "Hex digits" },
            "gaps_ns": {
                "type": "array",
                "items": { "type": "integer" },
                "description": "Nanoseconds from each time that the packet was whole to the next; \
                    the last was this message's log time. There is a time more than gaps",
            },
            "status": status,
        }),
    )
}

fn joints() -> Value {
    let angle = |text| json!({ "type": "number", "description": text });
    object(
        "The joint angles and the tool",
        &[
            "at_s",
            "base_deg",
            "rear_deg",
            "fore_deg",
            "servo_deg",
            "suction",
            "gripper_deg",
        ],
        &json!({
            "at_s": at_s(),
            "base_deg": angle("Counter-clockwise seen from above"),
            "rear_deg": angle("From the vertical, forward positive"),
            "fore_deg": angle("Below the horizontal"),
            "servo_deg": angle("The servo's angle"),
            "suction": { "type": "boolean", "description": "Whether the pump runs" },
            "gripper_deg": angle("The gripper's angle"),
        }),
    )
}

fn recorder() -> Value {
    object(
        "What is missing from the recording before this message",
        &["at_s", "reason"],
        &json!({
            "at_s": at_s(),
            "lost": { "type": "integer", "description": "How many records, if that is known" },
            "unreadable_bytes": {
                "type": "integer",
                "description": "How many bytes of the file could not be read when it was repaired",
            },
            "reason": { "type": "string", "description": "Why" },
        }),
    )
}

fn pose_in_frame() -> Value {
    let pose = object(
        "Pose in 3D space",
        &["position", "orientation"],
        &json!({ "position": vector(), "orientation": quaternion() }),
    );
    object(
        "A timestamped pose for an object or reference frame in 3D space",
        &["timestamp", "frame_id", "pose"],
        &json!({ "timestamp": time(), "frame_id": { "type": "string" }, "pose": pose }),
    )
}

fn frame_transform() -> Value {
    object(
        "A transform between two reference frames in 3D space",
        &[
            "timestamp",
            "parent_frame_id",
            "child_frame_id",
            "translation",
            "rotation",
        ],
        &json!({
            "timestamp": time(),
            "parent_frame_id": { "type": "string" },
            "child_frame_id": { "type": "string" },
            "translation": vector(),
            "rotation": quaternion(),
        }),
    )
}

fn vector() -> Value {
    numbers("In metres", &["x", "y", "z"])
}

fn quaternion() -> Value {
    numbers("A rotation", &["x", "y", "z", "w"])
}

fn numbers(description: &str, names: &[&str]) -> Value {
    let number = |name: &&str| ((*name).to_owned(), json!({ "type": "number" }));
    let properties = Value::Object(names.iter().map(number).collect());
    object(description, names, &properties)
}

fn time() -> Value {
    let mut time = object(
        "Since 1970",
        &["sec", "nsec"],
        &json!({
            "sec": { "type": "integer", "minimum": 0 },
            "nsec": { "type": "integer", "minimum": 0, "maximum": 999_999_999 },
        }),
    );
    // By this title Foxglove knows a time.
    time["title"] = json!("time");
    time
}

fn at_s() -> Value {
    json!({ "type": "number", "description": "Seconds since the recorder was started" })
}

fn object(description: &str, required: &[&str], properties: &Value) -> Value {
    json!({
        "type": "object",
        "description": description,
        "properties": properties,
        "required": required,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What Foxglove takes: objects, numbers, texts and truths all the way down, lists of numbers, no
    /// references.
    fn plots(schema: &Value) -> bool {
        match schema["type"].as_str() {
            Some("object") => {
                let fields = schema.get("properties").and_then(Value::as_object);
                fields.is_none_or(|fields| fields.values().all(plots))
            }
            Some("number" | "integer" | "string" | "boolean") => true,
            Some("array") => matches!(schema["items"]["type"].as_str(), Some("integer")),
            _ => false,
        }
    }

    #[test]
    fn every_schema_is_one_that_foxglove_takes() {
        for topic in OWN.iter() {
            let schema: Value = serde_json::from_str(topic.schema()).expect("it is JSON");
            assert!(plots(&schema), "{schema:#}");
            assert_eq!(schema["type"], "object");
        }
    }

    #[test]
    fn a_status_has_all_its_ten_fields_with_their_units() {
        let schema = from_arm();
        let status = &schema["properties"]["status"]["properties"];
        assert_eq!(status.as_object().map(serde_json::Map::len), Some(10));
        assert_eq!(status["x_mm"]["type"], "number");
        assert_eq!(status["suction"]["type"], "boolean");
    }
}
