//! Topics: named kinds of messages with a schema.

use std::collections::BTreeMap;
use std::io::{Seek, Write};

use mcap::{McapResult, Writer};
use serde_json::Value;

/// The topic of bytes to the arm.
pub const TO_ARM: &str = "/wire/to_arm";

/// The topic of bytes from the arm. A repeated packet is one message with all its times;
/// [`Recording`](crate::Recording) returns each repetition.
pub const FROM_ARM: &str = "/wire/from_arm";

/// The topic of the tool's pose, as `foxglove.PoseInFrame`: metres, in the frame `base`.
pub const POSE: &str = "/arm/pose";

/// The topic of the joint angles, in degrees.
pub const JOINTS: &str = "/arm/joints";

/// The topic of the links of the arm relative to their parents, as `foxglove.FrameTransforms`: the
/// links of the URDF of `dobot-model`, of which `tool` is the tool. Older recordings have
/// `foxglove.FrameTransform` from `base` to `tool`.
pub const TRANSFORMS: &str = "/tf";

/// The topic of the targets of in-flight commands, as `foxglove.SceneUpdate`.
pub const TARGET: &str = "/arm/target";

/// The topic of the lines that the tool has drawn or burned, as `foxglove.SceneUpdate`: each
/// message has the new pieces.
pub const INK: &str = "/arm/ink";

/// The topic of the recorder's own messages: lost records and the reason.
pub const RECORDER: &str = "/recorder";

/// The topics that the recorder itself writes.
pub(crate) const OWN: [&str; OWN_COUNT] = [
    TO_ARM, FROM_ARM, POSE, JOINTS, TRANSFORMS, TARGET, INK, RECORDER,
];

/// The number of these topics.
pub(crate) const OWN_COUNT: usize = 8;

/// A topic: a kind of messages, which are JSON objects with a JSON Schema.
#[derive(Clone, Debug, PartialEq)]
pub struct Topic {
    name: String,
    schema_name: String,
    schema: String,
}

impl Topic {
    /// Creates a topic with a name as in `/events`, a schema name as in `dobot.Event`, and the JSON
    /// Schema of its messages.
    ///
    /// Foxglove requires the schema of an object, and plots its `properties`; it does not follow
    /// references: configure `schemars` to inline subschemas.
    ///
    /// # Errors
    ///
    /// [`TopicError`] for a name that is not allowed or used by the recorder, and for a schema of
    /// anything but an object.
    pub fn new(name: &str, schema_name: &str, schema: &Value) -> Result<Self, TopicError> {
        let found = || name.to_owned();
        if !name.starts_with('/') || name.len() > NAME_LEN || schema_name.len() > NAME_LEN {
            return Err(TopicError::Name(found()));
        }
        if OWN.contains(&name) {
            return Err(TopicError::Taken(found()));
        }
        if schema.get("type").and_then(Value::as_str) != Some("object") {
            return Err(TopicError::Schema(found()));
        }
        let topic = Self::own(name, schema_name, schema);
        if topic.schema.len() > SCHEMA_LEN {
            return Err(TopicError::LongSchema {
                name: found(),
                found: topic.schema.len(),
            });
        }
        Ok(topic)
    }

    /// The name.
    #[must_use]
    pub const fn name(&self) -> &str {
        self.name.as_str()
    }

    /// The name of its schema.
    #[must_use]
    pub const fn schema_name(&self) -> &str {
        self.schema_name.as_str()
    }

    /// The schema, as text.
    #[must_use]
    pub const fn schema(&self) -> &str {
        self.schema.as_str()
    }

    /// Adds its schema and a channel to a file; returns the channel's number.
    pub(crate) fn add_to<W: Write + Seek>(&self, writer: &mut Writer<W>) -> McapResult<u16> {
        let schema = self.schema.as_bytes();
        let schema_id = writer.add_schema(&self.schema_name, "jsonschema", schema)?;
        writer.add_channel(schema_id, &self.name, "json", &BTreeMap::new())
    }

    /// Creates one of the recorder's own topics.
    pub(crate) fn own(name: &str, schema_name: &str, schema: &Value) -> Self {
        Self {
            name: name.to_owned(),
            schema_name: schema_name.to_owned(),
            schema: schema.to_string(),
        }
    }
}

/// The reason why a topic is refused.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum TopicError {
    /// The name is not allowed.
    #[error(
        "topic is `{0}`; a name starts with /, and names of topics and schemas have at most 256 bytes"
    )]
    Name(String),
    /// The recorder itself writes this topic.
    #[error("topic is `{0}`, which the recorder uses itself; choose another name")]
    Taken(String),
    /// The schema is not that of an object.
    #[error("the type of the schema of {0} is not `object`; allowed is `object`")]
    Schema(String),
    /// The schema is too long.
    #[error("the schema of {name} has {found} bytes; allowed are 65536")]
    LongSchema {
        /// The name of the topic.
        name: String,
        /// The length in bytes.
        found: usize,
    },
}

/// The longest name, in bytes.
pub(crate) const NAME_LEN: usize = 256;

/// The longest schema, in bytes.
const SCHEMA_LEN: usize = 64 << 10;

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn an_invalid_topic_is_refused() {
        let object = json!({ "type": "object" });
        let refused = |name: &str, schema: &Value| {
            Topic::new(name, "x.X", schema)
                .expect_err("it makes no sense")
                .to_string()
        };
        assert!(refused("events", &object).contains("starts with /"));
        assert!(refused(TO_ARM, &object).contains("the recorder uses itself"));
        assert!(refused("/events", &json!({ "type": "string" })).contains("`object`"));
        let long = json!({ "type": "object", "description": "x".repeat(SCHEMA_LEN) });
        assert!(refused("/events", &long).contains("allowed are 65536"));
        assert!(Topic::new("/events", "dobot.Event", &object).is_ok());
    }
}
