//! Objects on the table.

use dobot_geometry::Point;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::footprint::Footprint;
use super::place::{rounded, rounded_place};

/// An object on the table or held by the tool.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(rename = "WorldObject")]
#[non_exhaustive]
pub struct Object {
    /// The unique name.
    pub name: String,
    /// The shape and size.
    pub shape: Shape,
    /// The mass in grams.
    pub mass_g: f64,
    /// The colour, as `#rrggbb`.
    pub color: String,
    /// The centre.
    #[serde(with = "super::place::pair")]
    #[schemars(with = "[f64; 2]")]
    pub at_mm: Point,
    /// The rotation about the vertical, counter-clockwise.
    pub turn_deg: f64,
    /// The height of its underside above the table.
    pub bottom_mm: f64,
}

/// The shapes of objects; all stand upright.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "type", rename_all = "snake_case")]
pub enum Shape {
    /// A box, by its sides along X, Y and Z before it is turned.
    Box {
        /// The sides.
        size_mm: [f64; 3],
    },
    /// A cylinder.
    Cylinder {
        /// The diameter.
        diameter_mm: f64,
        /// The height.
        height_mm: f64,
    },
}

impl Object {
    /// The height of its upper face above the table.
    #[must_use]
    pub fn top_mm(&self) -> f64 {
        self.bottom_mm + self.height_mm()
    }

    pub(crate) const fn height_mm(&self) -> f64 {
        match self.shape {
            Shape::Box { size_mm } => size_mm[2],
            Shape::Cylinder { height_mm, .. } => height_mm,
        }
    }

    pub(crate) fn footprint(&self) -> Footprint {
        match self.shape {
            Shape::Box { size_mm: [x, y, _] } => Footprint::Rectangle {
                middle: self.at_mm,
                half_mm: [x / 2.0, y / 2.0],
                turn_deg: self.turn_deg,
            },
            Shape::Cylinder { diameter_mm, .. } => Footprint::Disc {
                middle: self.at_mm,
                radius_mm: diameter_mm / 2.0,
            },
        }
    }

    /// The vertical overlap of two objects; `None` if their outlines do not overlap.
    pub(crate) fn overlap_mm(&self, other: &Self) -> Option<f64> {
        let depth = (self.top_mm() - other.bottom_mm).min(other.top_mm() - self.bottom_mm);
        (depth > -TOUCHING_MM && self.footprint().overlaps(&other.footprint())).then_some(depth)
    }

    /// Whether it stands on the other object.
    pub(crate) fn stands_on(&self, other: &Self) -> bool {
        (self.bottom_mm - other.top_mm()).abs() < TOUCHING_MM
            && self.footprint().overlaps(&other.footprint())
    }

    pub(crate) fn rounded(&self) -> Self {
        Self {
            at_mm: rounded_place(self.at_mm),
            turn_deg: rounded(self.turn_deg),
            bottom_mm: rounded(self.bottom_mm),
            ..self.clone()
        }
    }
}

/// The largest distance that counts as contact.
pub(crate) const TOUCHING_MM: f64 = 0.01;
