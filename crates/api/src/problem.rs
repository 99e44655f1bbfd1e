//! Refusals as documents (RFC 9457).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A refusal as a problem document (RFC 9457, `application/problem+json`).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Problem {
    /// The problem type; its URL explains it.
    #[serde(rename = "type")]
    pub kind: String,
    /// The problem type in words.
    pub title: String,
    /// The HTTP status.
    pub status: u16,
    /// What is wrong: where, what was found and what is allowed.
    pub detail: String,
    /// How to fix it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hint: Option<String>,
    /// The policy rule that was broken.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rule: Option<String>,
    /// Where the motion would break the rule: x, y and z in millimetres.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at_mm: Option<[f64; 3]>,
    /// The nearest allowed position: x, y and z in millimetres.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub nearest_mm: Option<[f64; 3]>,
}

impl Problem {
    /// Returns the name of the problem type: the last part of its URL, as in `no-lease`.
    #[must_use]
    pub fn name(&self) -> &str {
        self.kind
            .rsplit_once('/')
            .map_or(self.kind.as_str(), |(_, name)| name)
    }
}
