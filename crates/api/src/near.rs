//! The limits and keep-outs that the arm is near to.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The limits and keep-outs of the policy that a place of the arm is near to.
///
/// The closeness of each is above 0, which is 20 mm or 5 degrees off, and 1 at the bound or beyond it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct NearView {
    /// The bounds of joints and workspace.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub limits: Vec<NearLimit>,
    /// The closeness of the tool to keep-outs, by their names.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub keep_outs: BTreeMap<String, f64>,
}

/// A bound that the arm is near to.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct NearLimit {
    /// The quantity that is bounded.
    pub quantity: BoundedQuantity,
    /// The bound, in degrees or mm.
    pub bound: f64,
    /// How near it is: above 0, and 1 at the bound or beyond it.
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
    /// Forward of the axis of the base, in mm.
    X,
    /// To the left of it, in mm.
    Y,
    /// The height of the wrist, in mm.
    Z,
    /// The horizontal distance from the axis of the base, in mm.
    Reach,
}

impl NearView {
    /// Whether the arm is near to nothing.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.limits.is_empty() && self.keep_outs.is_empty()
    }
}
