//! The schemas of the recorder's own topics.

use std::sync::LazyLock;

use dobot_wire::Status;
use serde_json::{Value, json};

use crate::Topic;
use crate::topic::{FROM_ARM, INK, JOINTS, OWN_COUNT, POSE, RECORDER, TARGET, TO_ARM, TRANSFORMS};

/// The recorder's own topic with this name.
pub(crate) fn own(name: &str) -> Option<&'static Topic> {
    topics().iter().find(|topic| topic.name() == name)
}

/// The topics of the wire and of the recorder itself.
#[must_use]
pub fn topics() -> &'static [Topic] {
    &*OWN
}

static OWN: LazyLock<[Topic; OWN_COUNT]> = LazyLock::new(|| {
    [
        Topic::own(TO_ARM, "dobot.ToArm", &to_arm()),
        Topic::own(FROM_ARM, "dobot.FromArm", &from_arm()),
        Topic::own(POSE, "foxglove.PoseInFrame", &pose_in_frame()),
        Topic::own(JOINTS, "dobot.Joints", &joints()),
        Topic::own(TRANSFORMS, "foxglove.FrameTransforms", &frame_transforms()),
        Topic::own(TARGET, "foxglove.SceneUpdate", &scene_update()),
        Topic::own(INK, "foxglove.SceneUpdate", &scene_update()),
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

fn frame_transforms() -> Value {
    object(
        "An array of FrameTransform messages",
        &["transforms"],
        &json!({ "transforms": list(&frame_transform()) }),
    )
}

fn scene_update() -> Value {
    let text = || json!({ "type": "string" });
    let number = || json!({ "type": "number" });
    let truth = || json!({ "type": "boolean" });
    let kind = || json!({ "type": "integer", "minimum": 0 });
    let pose = || {
        object(
            "Pose in 3D space",
            &["position", "orientation"],
            &json!({ "position": vector(), "orientation": quaternion() }),
        )
    };
    let color = || numbers("A color in RGBA format", &["r", "g", "b", "a"]);
    let primitive = |description, properties: Value| {
        let names: Vec<_> = properties.as_object().into_iter().flatten().collect();
        let names: Vec<_> = names.iter().map(|(name, _)| name.as_str()).collect();
        list(&object(description, &names, &properties))
    };
    let solid = |description| {
        primitive(
            description,
            json!({ "pose": pose(), "size": vector(), "color": color() }),
        )
    };
    let lines = primitive(
        "A series of points connected by lines",
        json!({
            "type": kind(),
            "pose": pose(),
            "thickness": number(),
            "scale_invariant": truth(),
            "points": list(&vector()),
            "color": color(),
            "colors": list(&color()),
            "indices": { "type": "array", "items": { "type": "integer" } },
        }),
    );
    // For kinds that never occur, a list of objects is enough.
    let none = |description: &str| list(&object(description, &[], &json!({})));
    let entity = json!({
        "timestamp": time(),
        "frame_id": text(),
        "id": text(),
        "lifetime": duration(),
        "frame_locked": truth(),
        "metadata": primitive("A key with its associated value", json!({ "key": text(), "value": text() })),
        "arrows": none("A primitive representing an arrow"),
        "cubes": solid("A primitive representing a cube or rectangular prism"),
        "spheres": solid("A primitive representing a sphere or ellipsoid"),
        "cylinders": none("A primitive representing a cylinder"),
        "lines": lines,
        "triangles": none("A primitive representing a set of triangles"),
        "texts": none("A primitive representing a text label"),
        "models": none("A primitive representing a 3D model file"),
    });
    let deletion = json!({ "timestamp": time(), "type": kind(), "id": text() });
    object(
        "An update to the entities displayed in a 3D scene",
        &["deletions", "entities"],
        &json!({
            "deletions": primitive("Command to remove previously published entities", deletion),
            "entities": primitive("A visual element in a 3D scene", entity),
        }),
    )
}

fn list(items: &Value) -> Value {
    json!({ "type": "array", "items": items })
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
    moment("time", "Since 1970")
}

fn duration() -> Value {
    moment("duration", "How long; 0 is for ever")
}

/// By this title Foxglove recognizes a time or a duration.
fn moment(title: &str, description: &str) -> Value {
    let mut moment = object(
        description,
        &["sec", "nsec"],
        &json!({
            "sec": { "type": "integer", "minimum": 0 },
            "nsec": { "type": "integer", "minimum": 0, "maximum": 999_999_999 },
        }),
    );
    moment["title"] = json!(title);
    moment
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

    /// The types that Foxglove accepts: objects, numbers, texts, booleans and lists of them at any
    /// depth, no references.
    fn plots(schema: &Value) -> bool {
        match schema["type"].as_str() {
            Some("object") => {
                let fields = schema.get("properties").and_then(Value::as_object);
                fields.is_none_or(|fields| fields.values().all(plots))
            }
            Some("number" | "integer" | "string" | "boolean") => true,
            Some("array") => plots(&schema["items"]),
            _ => false,
        }
    }

    #[test]
    fn every_schema_is_accepted_by_foxglove() {
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
