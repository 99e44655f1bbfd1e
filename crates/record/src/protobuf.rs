//! Copies of recordings with Foxglove's well-known messages in protobuf.

use std::borrow::Cow;
use std::collections::HashMap;
use std::path::Path;

use foxglove::messages::{
    FrameTransform, FrameTransforms, PoseInFrame, SceneUpdate, line_primitive,
    scene_entity_deletion,
};
use foxglove::{Encode, Schema};
use mcap::records::Record;
use serde::de::DeserializeOwned;
use serde_json::Value;

use crate::repair::{Change, copy_changed};
use crate::{Damage, RepairError};

/// Copies the readable part of a recording as [`copy`](crate::copy) does, with poses, links and scenes
/// in protobuf instead of JSON, for viewers that read Foxglove's well-known messages only so.
///
/// # Errors
///
/// [`RepairError`]; then there is no copy.
pub fn copy_as_protobuf(path: &Path, copy: &Path) -> Result<Option<Damage>, RepairError> {
    let mut converter = Converter::default();
    let change: Box<Change> = Box::new(move |record| converter.convert(record));
    copy_changed(path, copy, Some(change))
}

/// The well-known schemas and their channels in a file.
#[derive(Default)]
struct Converter {
    schemas: HashMap<u16, &'static WellKnown>,
    channels: HashMap<u16, &'static WellKnown>,
}

/// A well-known message.
struct WellKnown {
    name: &'static str,
    schema: fn() -> Option<Schema>,
    encode: fn(Value) -> Result<Vec<u8>, String>,
}

impl Converter {
    fn convert<'r>(&mut self, record: Record<'r>) -> Result<Record<'r>, String> {
        match record {
            Record::Schema { mut header, data } => {
                let known = WELL_KNOWN
                    .iter()
                    .find(|known| header.encoding == "jsonschema" && known.name == header.name);
                let Some((known, schema)) = known.and_then(|it| Some((it, (it.schema)()?))) else {
                    return Ok(Record::Schema { header, data });
                };
                self.schemas.insert(header.id, known);
                header.encoding = schema.encoding;
                let data = schema.data;
                Ok(Record::Schema { header, data })
            }
            Record::Channel(mut channel) => {
                if let Some(known) = self.schemas.get(&channel.schema_id) {
                    self.channels.insert(channel.id, known);
                    "protobuf".clone_into(&mut channel.message_encoding);
                }
                Ok(Record::Channel(channel))
            }
            Record::Message { header, data } => {
                let data = match self.channels.get(&header.channel_id) {
                    Some(known) => Cow::Owned(known.message(&data)?),
                    None => data,
                };
                Ok(Record::Message { header, data })
            }
            other => Ok(other),
        }
    }
}

impl WellKnown {
    const fn of<M: Encode + DeserializeOwned>(name: &'static str) -> Self {
        Self {
            name,
            schema: M::get_schema,
            encode: encoded::<M>,
        }
    }

    /// Converts a message from JSON.
    fn message(&self, json: &[u8]) -> Result<Vec<u8>, String> {
        let value = serde_json::from_slice(json).map_err(|error| error.to_string());
        let message = value.and_then(|mut value| {
            name_types(&mut value);
            (self.encode)(value)
        });
        message.map_err(|error| format!("a message is no {}: {error}", self.name))
    }
}

fn encoded<M: Encode + DeserializeOwned>(value: Value) -> Result<Vec<u8>, String> {
    let message: M = serde_json::from_value(value).map_err(|error| error.to_string())?;
    let mut bytes = Vec::new();
    let encoded = message.encode(&mut bytes);
    encoded.map_err(|error| error.to_string())?;
    Ok(bytes)
}

/// Replaces the numbers of enumerations in a scene by their names, which the library expects in JSON.
fn name_types(scene: &mut Value) {
    for deletion in items(scene, "deletions") {
        name_type(deletion, |number| {
            let kind = scene_entity_deletion::Type::try_from(number).ok()?;
            Some(kind.as_str_name())
        });
    }
    for line in items(scene, "entities").flat_map(|entity| items(entity, "lines")) {
        name_type(line, |number| {
            let kind = line_primitive::Type::try_from(number).ok()?;
            Some(kind.as_str_name())
        });
    }
}

fn name_type(value: &mut Value, name: fn(i32) -> Option<&'static str>) {
    if let Some(kind) = value.get_mut("type")
        && let Some(number) = kind.as_i64().and_then(|number| i32::try_from(number).ok())
        && let Some(name) = name(number)
    {
        *kind = name.into();
    }
}

fn items<'v>(value: &'v mut Value, name: &str) -> impl Iterator<Item = &'v mut Value> + use<'v> {
    let items = value.get_mut(name).and_then(Value::as_array_mut);
    items.into_iter().flatten()
}

static WELL_KNOWN: [WellKnown; 4] = [
    WellKnown::of::<PoseInFrame>("foxglove.PoseInFrame"),
    // Older recordings have single transforms.
    WellKnown::of::<FrameTransform>("foxglove.FrameTransform"),
    WellKnown::of::<FrameTransforms>("foxglove.FrameTransforms"),
    WellKnown::of::<SceneUpdate>("foxglove.SceneUpdate"),
];
