//! Time slots: from when until when an arm is a student's.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A time slot, told from now on: no clocks are compared, so that a wrong one does no harm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TimeSlot {
    /// Whose it is: 1 to 60 visible characters. Capital letters and spaces around it make no difference.
    #[schemars(length(min = 1, max = 60))]
    pub student: String,
    /// The group of that one: 1 to 40 small letters of English, digits and hyphens.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(length(min = 1, max = 40))]
    pub group: Option<String>,
    /// When it begins, in seconds from now; 0 where it has begun.
    #[schemars(range(min = 0.0, max = 86_400.0))]
    pub starts_in_s: f64,
    /// When it ends, in seconds from now: at least a second after it begins.
    #[schemars(range(min = 1.0, max = 86_400.0))]
    pub ends_in_s: f64,
}

impl TimeSlot {
    /// How many slots an arm may have.
    pub const MOST: usize = 200;
    /// How far ahead the last one may end, in seconds.
    pub const LONGEST_S: f64 = 86_400.0;
}

/// The time slots of an arm, as far as those who watch have to know: `GET /api/v1/slots` tells all.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SlotsView {
    /// The one that is under way, if one is: only its student and administrators have control meanwhile.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub now: Option<SlotView>,
    /// The one that comes next, if one does.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub next: Option<SlotView>,
    /// When the arm is everyone's again, in seconds since the station started: the end of the last of the slots that follow each
    /// other without a break. Absent where it is everyone's now.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub free_s: Option<f64>,
}

/// A time slot, for those who watch.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SlotView {
    /// Whose it is.
    pub student: String,
    /// The group of that one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub group: Option<String>,
    /// When it begins, in seconds since the station started.
    pub starts_s: f64,
    /// When it ends, in seconds since the station started.
    pub ends_s: f64,
}

/// Whether two names are those of one person: capital letters and spaces around them make no difference.
///
/// ```
/// assert!(dobot_api::is_same_person(" anna", "Anna"));
/// assert!(!dobot_api::is_same_person("Anna B", "Anna"));
/// ```
#[must_use]
pub fn is_same_person(one: &str, other: &str) -> bool {
    one.trim().to_lowercase() == other.trim().to_lowercase()
}
