//! The arm: its parts, and what turns about what.

use dobot_arm::{Degrees, FOREARM, Limits, REAR_ARM, Span};
use dobot_motion::Speeds;

use crate::joint::{Axis, Joint, Turn};
use crate::mounted_tool::MountedTool;
use crate::part::{self, CRANK_MM, FRONT_ROD_AT_MM, REAR_ROD_AT_MM};
use crate::shape::Shape;

/// The arm as a tree of parts with a joint between each and its parent, and three pins that close its loops.
///
/// ```text
///     tail .____ elbow _________          The rear rod keeps the plate at the elbow level, and with it the front
///         /    /  \  forearm    \ wrist   rod the wrist: the tool never tilts. The crank turns the forearm, by a
///  crank /    / rear arm         \___ tool  rod that is as long as the rear arm: so the forearm keeps its angle
///  rod  /    /                       |    when the rear arm turns.
///      /____/ pivot                  | tip
///      crank
/// ```
///
/// Motors turn `base`, `rear` (the rear arm), `fore` (the crank, and with it the forearm) and `servo`; all other joints follow.
#[derive(Clone, Debug)]
pub struct Model {
    pub(crate) tool: Option<MountedTool>,
    pub(crate) limits: Limits,
    pub(crate) parts: Vec<Part>,
    pub(crate) joints: Vec<Joint>,
    pub(crate) pins: [Pin; 3],
}

/// A rigid body.
#[derive(Clone, Debug)]
pub(crate) struct Part {
    pub(crate) name: &'static str,
    pub(crate) shapes: Vec<Shape>,
}

/// A pin along Y that holds a part to another than its parent, and so closes a loop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pin {
    pub(crate) name: &'static str,
    pub(crate) parts: [&'static str; 2],
    /// Where it is in the frame of each, in mm.
    pub(crate) at_mm: [[f64; 3]; 2],
}

impl Model {
    /// The stock arm with a tool, or without one; then it ends at the wrist.
    #[must_use]
    pub fn new(tool: Option<MountedTool>) -> Self {
        let servo_mm = tool.map(|tool| tool.kind().reach().0);
        let mut parts = stock_parts(servo_mm);
        let mut joints = LINKAGE.to_vec();
        if let Some((tool, x)) = tool.zip(servo_mm) {
            parts.push(part("tool", part::tool(tool)));
            parts.push(part("tip", Vec::new()));
            let servo = driven(Axis::Z, Limits::STOCK.servo, Speeds::STOCK.servo_deg_s);
            joints.push(joint("servo", "wrist", "tool", [x, 0.0, 0.0], servo));
            let down = [0.0, 0.0, -tool.length().0];
            joints.push(joint("tip", "tool", "tip", down, Turn::Fixed));
        }
        Self {
            tool,
            limits: Limits::STOCK,
            parts,
            joints,
            pins: PINS,
        }
    }

    /// The joints whose parent is this part.
    pub(crate) fn joints_of(&self, parent: &str) -> impl Iterator<Item = &Joint> {
        self.joints
            .iter()
            .filter(move |joint| joint.parent == parent)
    }
}

/// The parts of the arm without a tool.
fn stock_parts(servo_mm: Option<f64>) -> Vec<Part> {
    vec![
        part("base", part::base()),
        part("turret", part::turret()),
        part("rear_arm", part::rear_arm()),
        part("rear_rod", part::rear_rod()),
        part("elbow_plate", part::elbow_plate()),
        part("forearm", part::forearm()),
        part("front_rod", part::front_rod()),
        part("crank", part::crank()),
        part("crank_rod", part::crank_rod()),
        part("wrist", part::wrist(servo_mm)),
    ]
}

fn part(name: &'static str, shapes: Vec<Shape>) -> Part {
    Part { name, shapes }
}

const fn joint(
    name: &'static str,
    parent: &'static str,
    child: &'static str,
    at_mm: [f64; 3],
    turn: Turn,
) -> Joint {
    Joint {
        name,
        parent,
        child,
        at_mm,
        turn,
    }
}

const fn driven(axis: Axis, span: Span<Degrees>, deg_s: f64) -> Turn {
    Turn::Driven { axis, span, deg_s }
}

const fn follows(rear: f64, fore: f64) -> Turn {
    Turn::Follows { rear, fore }
}

const JOINT_DEG_S: f64 = Speeds::STOCK.joint_deg_s;
const ORIGIN: [f64; 3] = [0.0; 3];
const ELBOW: [f64; 3] = [0.0, 0.0, REAR_ARM.0];
const WRIST: [f64; 3] = [FOREARM.0, 0.0, 0.0];
const CRANK_END: [f64; 3] = [-CRANK_MM, 0.0, 0.0];
const REAR_ROD_AT: [f64; 3] = [REAR_ROD_AT_MM[0], 0.0, REAR_ROD_AT_MM[1]];
const FRONT_ROD_AT: [f64; 3] = [FRONT_ROD_AT_MM[0], 0.0, FRONT_ROD_AT_MM[1]];

const BASE: Turn = driven(Axis::Z, Limits::STOCK.base, JOINT_DEG_S);
const REAR: Turn = driven(Axis::Y, Limits::STOCK.rear, JOINT_DEG_S);
const FORE: Turn = driven(Axis::Y, Limits::STOCK.fore, JOINT_DEG_S);

/// All joints up to the wrist.
const LINKAGE: [Joint; 9] = [
    joint("base", "base", "turret", ORIGIN, BASE),
    joint("rear", "turret", "rear_arm", ORIGIN, REAR),
    joint("fore", "turret", "crank", ORIGIN, FORE),
    joint(
        "rear_rod",
        "turret",
        "rear_rod",
        REAR_ROD_AT,
        follows(1.0, 0.0),
    ),
    joint(
        "crank_rod",
        "crank",
        "crank_rod",
        CRANK_END,
        follows(1.0, -1.0),
    ),
    joint(
        "elbow_plate",
        "rear_arm",
        "elbow_plate",
        ELBOW,
        follows(-1.0, 0.0),
    ),
    joint("elbow", "rear_arm", "forearm", ELBOW, follows(-1.0, 1.0)),
    joint(
        "front_rod",
        "elbow_plate",
        "front_rod",
        FRONT_ROD_AT,
        follows(0.0, 1.0),
    ),
    joint("wrist", "forearm", "wrist", WRIST, follows(0.0, -1.0)),
];

const PINS: [Pin; 3] = [
    Pin {
        name: "crank_pin",
        parts: ["crank_rod", "forearm"],
        at_mm: [ELBOW, CRANK_END],
    },
    Pin {
        name: "rear_pin",
        parts: ["rear_rod", "elbow_plate"],
        at_mm: [ELBOW, REAR_ROD_AT],
    },
    Pin {
        name: "front_pin",
        parts: ["front_rod", "wrist"],
        at_mm: [WRIST, FRONT_ROD_AT],
    },
];

#[cfg(test)]
mod tests {
    use dobot_arm::{Joints, Millimeters, Position, Tool, forward};
    use proptest::prelude::*;

    use super::*;

    /// Where a point of a part is, in the base frame; each joint turned on the way to its root.
    fn place(
        model: &Model,
        part: &str,
        [mut x, mut y, mut z]: [f64; 3],
        joints: &Joints,
    ) -> Position {
        let mut part = part;
        while let Some(joint) = model.joints.iter().find(|joint| joint.child == part) {
            let (sin, cos) = angle(joint, joints).to_radians().sin_cos();
            [x, y, z] = match joint.turn.axis() {
                Axis::Y => [cos * x + sin * z, y, cos * z - sin * x],
                Axis::Z => [cos * x - sin * y, sin * x + cos * y, z],
            };
            let [dx, dy, dz] = joint.at_mm;
            [x, y, z] = [x + dx, y + dy, z + dz];
            part = joint.parent;
        }
        Position::new(x, y, z)
    }

    fn angle(joint: &Joint, joints: &Joints) -> f64 {
        match (joint.turn, joint.name) {
            (Turn::Fixed, _) => 0.0,
            (Turn::Follows { rear, fore }, _) => rear * joints.rear.0 + fore * joints.fore.0,
            (Turn::Driven { .. }, "base") => joints.base.0,
            (Turn::Driven { .. }, "rear") => joints.rear.0,
            (Turn::Driven { .. }, "fore") => joints.fore.0,
            (Turn::Driven { .. }, _) => joints.servo.0,
        }
    }

    fn joints() -> impl Strategy<Value = Joints> {
        (-180.0..180.0, -5.0..85.0, -10.0..95.0, -90.0..90.0)
            .prop_map(|(base, rear, fore, servo)| Joints::new(base, rear, fore, servo))
    }

    proptest! {
        #[test]
        fn the_tool_is_at_the_place_given_by_the_kinematics(joints in joints()) {
            for kind in Tool::ALL {
                let tool = MountedTool::new(kind, Millimeters(50.0)).expect("it is allowed");
                let model = Model::new(Some(tool));
                let expected = forward(&joints, kind);
                let found = place(&model, "tool", ORIGIN, &joints);
                prop_assert!(found.distance(expected.position).0 < 1e-9, "{found:?}, expected {expected:?}");
                let tip = place(&model, "tip", ORIGIN, &joints);
                let below = expected.position - Position::new(0.0, 0.0, 50.0);
                prop_assert!(tip.distance(below).0 < 1e-9, "{tip:?}, expected {below:?}");
                // A point ahead of the tool's axis shows the rotation of the tool.
                let ahead = place(&model, "tool", [1.0, 0.0, 0.0], &joints) - found;
                let turned = Position::polar(Millimeters(1.0), expected.rotation, Millimeters(0.0));
                prop_assert!(ahead.distance(turned).0 < 1e-9, "{ahead:?}, expected {turned:?}");
            }
        }

        #[test]
        fn every_pin_holds_its_two_parts_together_in_every_pose(joints in joints()) {
            let model = Model::new(None);
            for pin in model.pins {
                let [a, b] = [0, 1].map(|n| place(&model, pin.parts[n], pin.at_mm[n], &joints));
                prop_assert!(a.distance(b).0 < 1e-9, "{}: {a:?} and {b:?}", pin.name);
            }
        }
    }

    #[test]
    fn every_part_but_the_base_has_one_parent() {
        let tool = MountedTool::new(Tool::Gripper, Millimeters(40.0)).expect("it is allowed");
        for model in [Model::new(None), Model::new(Some(tool))] {
            let names: Vec<_> = model.parts.iter().map(|part| part.name).collect();
            assert_eq!(names[0], "base");
            for joint in &model.joints {
                let at = |name| {
                    names
                        .iter()
                        .position(|known| *known == name)
                        .expect("it is there")
                };
                assert!(at(joint.child) > 0, "{}", joint.name);
            }
            let children = model.joints.iter().map(|joint| joint.child);
            assert_eq!(children.count() + 1, names.len());
        }
    }
}
