//! The model as JSON, in the units of this project.

use dobot_arm::{Limits, Span};
use serde_json::{Value, json};

use crate::dimensions::Dimensions;
use crate::joint::{Axis, Joint, Turn};
use crate::model::{Model, Part, Pin};
use crate::shape::{Shape, Solid};

impl Model {
    /// The model as JSON: millimetres and degrees.
    ///
    /// It holds what the other formats hold, and the limits that they cannot: the reach and the height of the tool. A limit
    /// that the arm does not have is `null`. The angle of a dependent joint is the sum of multiples of `rear` and `fore`.
    ///
    /// # Panics
    ///
    /// Never: all its names are text.
    #[must_use]
    pub fn to_json(&self) -> String {
        let lengths = Dimensions::STOCK;
        let value = json!({
            "name": "dobot_arm",
            "units": { "length": "mm", "angle": "deg" },
            "rear_arm_mm": lengths.rear_arm_mm,
            "forearm_mm": lengths.forearm_mm,
            "pivot_above_table_mm": lengths.pivot_above_table_mm,
            "tool": self.tool.map(|tool| json!({
                "kind": tool.kind().name(),
                "reach_mm": tool.kind().reach().0,
                "length_mm": tool.length().0,
            })),
            "limits": limits(&self.limits),
            "joints": self.joints.iter().map(joint).collect::<Vec<_>>(),
            "pins": self.pins.iter().map(pin).collect::<Vec<_>>(),
            "links": self.parts.iter().map(link).collect::<Vec<_>>(),
        });
        serde_json::to_string_pretty(&value).expect("all its names are text") + "\n"
    }
}

fn limits(limits: &Limits) -> Value {
    let Limits {
        base,
        rear,
        fore,
        servo,
        opening,
        reach,
        z,
    } = limits;
    let angle = |range: &Span<dobot_arm::Degrees>| span(range.min.0, range.max.0);
    let length = |range: &Span<dobot_arm::Millimeters>| span(range.min.0, range.max.0);
    json!({
        "base_deg": angle(base),
        "rear_deg": angle(rear),
        "fore_deg": angle(fore),
        "servo_deg": angle(servo),
        "rear_minus_fore_deg": angle(opening),
        "reach_mm": length(reach),
        "z_mm": length(z),
    })
}

/// An infinite end is no limit; JSON has no such number.
fn span(min: f64, max: f64) -> Value {
    json!([min, max].map(|limit| limit.is_finite().then_some(limit)))
}

fn joint(joint: &Joint) -> Value {
    let mut value = json!({
        "name": joint.name,
        "parent": joint.parent,
        "child": joint.child,
        "at_mm": joint.at_mm,
    });
    match joint.turn {
        Turn::Fixed => {}
        Turn::Driven {
            axis,
            span: range,
            deg_s,
        } => {
            value["axis"] = name_of(axis).into();
            value["range_deg"] = span(range.min.0, range.max.0);
            value["speed_deg_s"] = deg_s.into();
        }
        Turn::Follows { rear, fore } => {
            value["axis"] = name_of(joint.turn.axis()).into();
            value["follows"] = json!({ "rear": rear, "fore": fore });
        }
    }
    value
}

const fn name_of(axis: Axis) -> &'static str {
    match axis {
        Axis::Y => "y",
        Axis::Z => "z",
    }
}

fn pin(pin: &Pin) -> Value {
    json!({ "name": pin.name, "links": pin.parts, "at_mm": pin.at_mm })
}

fn link(part: &Part) -> Value {
    json!({ "name": part.name, "shapes": part.shapes.iter().map(shape).collect::<Vec<_>>() })
}

fn shape(shape: &Shape) -> Value {
    let mut value = match shape.solid {
        Solid::Box { size_mm } => json!({ "shape": "box", "size_mm": size_mm }),
        Solid::Pin { radius_mm, long_mm } => {
            json!({ "shape": "cylinder", "axis": "y", "radius_mm": radius_mm, "length_mm": long_mm })
        }
        Solid::Post { radius_mm, long_mm } => {
            json!({ "shape": "cylinder", "axis": "z", "radius_mm": radius_mm, "length_mm": long_mm })
        }
    };
    value["at_mm"] = json!(shape.at_mm);
    value["colour"] = shape.colour.name().into();
    value
}
