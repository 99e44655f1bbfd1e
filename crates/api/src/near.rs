//! The limits and keep-outs close to the arm.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The policy limits and keep-outs close to the arm.
///
/// Each closeness is above 0 (20 mm or 5 degrees away) and reaches 1 at the bound or beyond it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct NearView {
    /// The joint and workspace bounds.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub limits: Vec<NearLimit>,
    /// The closeness of the tool to keep-outs, by name.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub keep_outs: BTreeMap<String, f64>,
}

/// A bound close to the arm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct NearLimit {
    /// The bounded quantity.
    pub quantity: BoundedQuantity,
    /// The bound, in degrees or mm.
    pub bound: f64,
    /// The closeness: above 0, and 1 at the bound or beyond it.
    pub closeness: f64,
}

/// A quantity that the policy bounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum BoundedQuantity {
    /// The base angle, in degrees.
    Base,
    /// The rear arm angle, in degrees.
    Rear,
    /// The forearm angle, in degrees.
    Fore,
    /// The servo angle, in degrees.
    Servo,
    /// The rear arm angle minus the forearm angle, in degrees.
    Opening,
    /// The distance forward of the base axis, in mm.
    X,
    /// The distance to the left of the base axis, in mm.
    Y,
    /// The height of the wrist, in mm.
    Z,
    /// The horizontal distance from the axis of the base, in mm.
    Reach,
}

impl NearView {
    /// Returns whether nothing is close.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.limits.is_empty() && self.keep_outs.is_empty()
    }
}
