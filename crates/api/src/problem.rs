//! Refusals as documents (RFC 9457).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A refusal as a problem document (RFC 9457, `application/problem+json`).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Problem {
    /// The kind of problem; the address tells about it.
    #[serde(rename = "type")]
    pub kind: String,
    /// The kind of problem in words.
    pub title: String,
    /// The HTTP status.
    pub status: u16,
    /// What is wrong: where, what was found, what is allowed.
    pub detail: String,
    /// What to do about it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hint: Option<String>,
    /// Which rule of the policy was broken.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rule: Option<String>,
    /// Where on its way a motion would break the rule: x, y, z in millimetres.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at_mm: Option<[f64; 3]>,
    /// The nearest place that is allowed: x, y, z in millimetres.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub nearest_mm: Option<[f64; 3]>,
}

impl Problem {
    /// The name of its kind: the last part of the address, as in `no-lease`.
    #[must_use]
    pub fn name(&self) -> &str {
        self.kind
            .rsplit_once('/')
            .map_or(self.kind.as_str(), |it| it.1)
    }
}
