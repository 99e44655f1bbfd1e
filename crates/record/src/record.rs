//! What can be recorded.

use std::sync::Arc;

use dobot_model::MountedTool;
use serde_json::Value;

use crate::{About, Topic};

/// What can be recorded.
#[derive(Clone, Debug, PartialEq)]
pub enum Record {
    /// From here on this is what the recording is of.
    About(Box<About>),
    /// From here on these tools may hang at the arm, so long; of one that is not among them nobody knows how long it is.
    Tools(Vec<MountedTool>),
    /// From here on a pen draws where the tool is below that height, in millimetres and the arm's own words; nowhere, if
    /// that is `None`.
    Pen {
        /// The height.
        below_mm: Option<f64>,
    },
    /// Bytes that were sent to the arm, of any number.
    ToArm(Vec<u8>),
    /// Bytes that came from the arm, of any number.
    FromArm(Vec<u8>),
    /// Anything else: a state, a job, an event.
    Json {
        /// What it is called and what it looks like.
        topic: Arc<Topic>,
        /// The message itself, an object.
        value: Value,
    },
}

impl Record {
    /// About how many bytes it takes while it waits to be written; what is longer than `limit` may
    /// be longer still.
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

/// Stops counting beyond `limit`, so that a huge value costs its caller no more than a large one.
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
    fn a_value_is_never_taken_for_smaller_than_its_text() {
        let state =
            json!({ "pose": [1.0, 2.0, { "z": 3.0 }], "name": "x".repeat(100), "on": true });
        assert!(size_of_value(&state, usize::MAX) > state.to_string().len());
    }

    #[test]
    fn beyond_the_limit_nobody_counts_on() {
        let item = json!("x".repeat(100));
        let huge = Value::Array(vec![item; 1000]);
        let size = size_of_value(&huge, 1000);
        assert!((1000..2000).contains(&size), "{size}");
    }
}
