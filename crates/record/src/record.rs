//! The input of a recorder.

use std::sync::Arc;

use dobot_model::MountedTool;
use serde_json::Value;

use crate::{About, Topic};

/// An input of a recorder.
#[derive(Clone, Debug, PartialEq)]
pub enum Record {
    /// New metadata from here on.
    About(Box<About>),
    /// The lengths of the tools from here on; those of other tools are unknown.
    Tools(Vec<MountedTool>),
    /// The height below which a pen draws from here on, in millimetres as the arm reports it;
    /// `None` if a pen never draws.
    Pen {
        /// The height.
        below_mm: Option<f64>,
    },
    /// Bytes sent to the arm, of any number.
    ToArm(Vec<u8>),
    /// Bytes received from the arm, of any number.
    FromArm(Vec<u8>),
    /// Anything else: a state, a job, an event.
    Json {
        /// The topic.
        topic: Arc<Topic>,
        /// The message itself, a JSON object.
        value: Value,
    },
}

impl Record {
    /// The approximate number of bytes that it occupies in the queue; exact only up to `limit`.
    pub(crate) fn size(&self, limit: usize) -> usize {
        size_of::<Self>()
            + match self {
                Self::About(about) => about.program.len() + about.address.len() + 200,
                Self::ToArm(bytes) | Self::FromArm(bytes) => bytes.capacity(),
                Self::Tools(tools) => size_of_val(&tools[..]),
                Self::Pen { .. } => 0,
                Self::Json { value, .. } => size_of_value(value, limit),
            }
    }
}

/// Counts up to `limit`, so that a huge value costs the caller no more than a large one.
fn size_of_value(value: &Value, limit: usize) -> usize {
    let own = size_of::<Value>();
    match value {
        Value::Null | Value::Bool(_) | Value::Number(_) => own,
        Value::String(text) => own + text.len(),
        Value::Array(items) => items.iter().fold(own, |sum, item| add(sum, item, 0, limit)),
        Value::Object(fields) => fields.iter().fold(own, |sum, (name, item)| {
            add(sum, item, name.len() + 40, limit)
        }),
    }
}

fn add(sum: usize, item: &Value, extra: usize, limit: usize) -> usize {
    if sum > limit {
        sum
    } else {
        sum + extra + size_of_value(item, limit - sum)
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn the_estimated_size_of_a_value_is_never_below_that_of_its_text() {
        let state =
            json!({ "pose": [1.0, 2.0, { "z": 3.0 }], "name": "x".repeat(100), "on": true });
        assert!(size_of_value(&state, usize::MAX) > state.to_string().len());
    }

    #[test]
    fn counting_stops_at_the_limit() {
        let item = json!("x".repeat(100));
        let huge = Value::Array(vec![item; 1000]);
        let size = size_of_value(&huge, 1000);
        assert!((1000..2000).contains(&size), "{size}");
    }
}
