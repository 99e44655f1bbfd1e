//! Topics: what messages of one kind are called, and what they look like.

use std::collections::BTreeMap;
use std::io::{Seek, Write};

use mcap::{McapResult, Writer};
use serde_json::Value;

/// Where bytes to the arm are recorded.
pub const TO_ARM: &str = "/wire/to_arm";

/// Where bytes from the arm are recorded. What came again and again is one message with all its
/// times; [`Recording`](crate::Recording) tells each of them.
pub const FROM_ARM: &str = "/wire/from_arm";

/// Where the tool is, as `foxglove.PoseInFrame`: metres, in the frame `base`.
pub const POSE: &str = "/arm/pose";

/// The joint angles, in degrees.
pub const JOINTS: &str = "/arm/joints";

/// Where each link of the arm is, seen from its parent, as `foxglove.FrameTransforms`: the links of the URDF of `dobot-model`, of
/// which `tool` is where the tool is. In recordings of before, `foxglove.FrameTransform` from `base` to `tool`.
pub const TRANSFORMS: &str = "/tf";

/// Where the commands lead that the arm has, as `foxglove.SceneUpdate`.
pub const TARGET: &str = "/arm/target";

/// What the tool has drawn or burnt, as `foxglove.SceneUpdate`: each message has the pieces that are new.
pub const INK: &str = "/arm/ink";

/// What the recorder has to say about itself: records that it lost, and why.
pub const RECORDER: &str = "/recorder";

/// The topics that the recorder writes itself.
pub(crate) const OWN: [&str; OWN_COUNT] = [
    TO_ARM, FROM_ARM, POSE, JOINTS, TRANSFORMS, TARGET, INK, RECORDER,
];

/// How many those are.
pub(crate) const OWN_COUNT: usize = 8;

/// A topic: messages of one kind, JSON objects with a JSON Schema.
#[derive(Clone, Debug, PartialEq)]
pub struct Topic {
    name: String,
    schema_name: String,
    schema: String,
}

impl Topic {
    /// A topic with a name as in `/events`, a name for its schema as in `dobot.Event`, and the JSON
    /// Schema of its messages.
    ///
    /// Foxglove wants the schema of an object, and plots what it finds in its `properties`; it does
    /// not follow references: let `schemars` inline the schemas within.
    ///
    /// # Errors
    ///
    /// [`TopicError`] for a name that is not allowed or is the recorder's own, and for a schema of
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

    /// Its name.
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

    /// Adds its schema and a channel for it to a file; gives the channel's number.
    pub(crate) fn add_to<W: Write + Seek>(&self, writer: &mut Writer<W>) -> McapResult<u16> {
        let schema = self.schema.as_bytes();
        let schema_id = writer.add_schema(&self.schema_name, "jsonschema", schema)?;
        writer.add_channel(schema_id, &self.name, "json", &BTreeMap::new())
    }

    /// One of the recorder's own.
    pub(crate) fn own(name: &str, schema_name: &str, schema: &Value) -> Self {
        Self {
            name: name.to_owned(),
            schema_name: schema_name.to_owned(),
            schema: schema.to_string(),
        }
    }
}

/// Why a topic is refused.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum TopicError {
    /// The name is not allowed.
    #[error("topic is `{0}`; a name begins with / and it and its schema's have 256 bytes at most")]
    Name(String),
    /// The recorder writes this topic itself.
    #[error("topic is `{0}`; the recorder writes that itself: choose another name")]
    Taken(String),
    /// The schema is not that of an object.
    #[error("the schema of {0} has another type than `object`, the only one that is allowed")]
    Schema(String),
    /// The schema is too long.
    #[error("the schema of {name} has {found} bytes; allowed are 65536")]
    LongSchema {
        /// The topic's name.
        name: String,
        /// Its length in bytes.
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
    fn a_topic_that_makes_no_sense_is_refused() {
        let object = json!({ "type": "object" });
        let refused = |name: &str, schema: &Value| {
            Topic::new(name, "x.X", schema)
                .expect_err("it makes no sense")
                .to_string()
        };
        assert!(refused("events", &object).contains("begins with /"));
        assert!(refused(TO_ARM, &object).contains("the recorder writes that itself"));
        assert!(refused("/events", &json!({ "type": "string" })).contains("`object`"));
        let long = json!({ "type": "object", "description": "x".repeat(SCHEMA_LEN) });
        assert!(refused("/events", &long).contains("allowed are 65536"));
        assert!(Topic::new("/events", "dobot.Event", &object).is_ok());
    }
}
