//! Time slots: when the arm is reserved for a student.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A time slot, relative to now: no clocks are compared, so a wrong clock does no harm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TimeSlot {
    /// The student: 1 to 60 visible characters. Case and surrounding spaces are ignored.
    #[schemars(length(min = 1, max = 60))]
    pub student: String,
    /// The student's group: 1 to 40 lowercase English letters, digits and hyphens.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(length(min = 1, max = 40))]
    pub group: Option<String>,
    /// The start, in seconds from now; 0 if it has begun.
    #[schemars(range(min = 0.0, max = 86_400.0))]
    pub starts_in_s: f64,
    /// The end, in seconds from now: at least a second after the start.
    #[schemars(range(min = 1.0, max = 86_400.0))]
    pub ends_in_s: f64,
}

impl TimeSlot {
    /// The maximum number of slots of an arm.
    pub const MAX_COUNT: usize = 200;
    /// The latest end of the last slot, in seconds from now.
    pub const LONGEST_S: f64 = 86_400.0;
}

/// The time slots of an arm for observers; `GET /api/v1/slots` returns all of them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SlotsView {
    /// The current slot, if any: only its student and administrators have control meanwhile.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub now: Option<SlotView>,
    /// The next slot, if any.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub next: Option<SlotView>,
    /// When the arm is free again, in seconds since the station started: the end of the last of the
    /// consecutive slots. Absent if it is free now.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub free_s: Option<f64>,
}

/// A time slot, for observers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SlotView {
    /// The student.
    pub student: String,
    /// The student's group.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub group: Option<String>,
    /// The start, in seconds since the station started.
    pub starts_s: f64,
    /// The end, in seconds since the station started.
    pub ends_s: f64,
}

/// Returns whether two names mean the same person: case and surrounding spaces are ignored.
///
/// ```
/// assert!(dobot_api::is_same_person(" anna", "Anna"));
/// assert!(!dobot_api::is_same_person("Anna B", "Anna"));
/// ```
#[must_use]
pub fn is_same_person(one: &str, other: &str) -> bool {
    one.trim().to_lowercase() == other.trim().to_lowercase()
}
