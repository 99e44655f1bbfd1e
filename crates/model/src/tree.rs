//! The joints as a tree of which each turns with one motor at most, as URDF wants them.

use std::borrow::Cow;

use dobot_arm::{Degrees, Joints};

use crate::joint::{Joint, Turn};
use crate::model::Model;

/// A joint that turns with one motor, or not at all.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct TreeJoint {
    pub(crate) name: Cow<'static, str>,
    pub(crate) parent: Cow<'static, str>,
    pub(crate) child: Cow<'static, str>,
    /// Where it is in the frame of its parent, in mm.
    pub(crate) at_mm: [f64; 3],
    pub(crate) turn: Turn,
}

/// Where a link is, seen from its parent.
#[derive(Clone, Debug, PartialEq)]
pub struct LinkFrame {
    /// The link's parent.
    pub parent: Cow<'static, str>,
    /// The link.
    pub child: Cow<'static, str>,
    /// Where it is in the frame of its parent, in mm.
    pub at_mm: [f64; 3],
    /// About what it is turned: a unit vector in the frame of its parent.
    pub axis: [f64; 3],
    /// How far it is turned.
    pub angle: Degrees,
    /// Whether it is always so.
    pub is_fixed: bool,
}

impl Model {
    /// Where every link of the [URDF](Self::to_urdf) is, seen from its parent, when the arm stands so.
    #[must_use]
    pub fn link_frames(&self, joints: &Joints) -> Vec<LinkFrame> {
        let frame = |joint: TreeJoint| LinkFrame {
            angle: joint.angle(joints),
            axis: joint.turn.axis().vector(),
            at_mm: joint.at_mm,
            is_fixed: joint.turn == Turn::Fixed,
            parent: joint.parent,
            child: joint.child,
        };
        self.tree().map(frame).collect()
    }

    /// The joints. One that follows both arms is two, with a link without a shape between them, as `forearm_level`.
    ///
    /// In the arm a motor turns the crank, which turns the forearm. Here the driven joint `fore` is that of the forearm, and
    /// the joint `crank` follows it: solvers of inverse kinematics need the driven joints between base and tool.
    pub(crate) fn tree(&self) -> impl Iterator<Item = TreeJoint> {
        let fore = self.joints.iter().find(|joint| joint.name == "fore");
        let fore = fore.expect("it is in the linkage").turn;
        self.joints
            .iter()
            .flat_map(split)
            .map(move |joint| match &*joint.name {
                "fore" => TreeJoint {
                    name: "crank".into(),
                    turn: Turn::Follows {
                        rear: 0.0,
                        fore: 1.0,
                    },
                    ..joint
                },
                "elbow" => TreeJoint {
                    name: "fore".into(),
                    turn: fore,
                    ..joint
                },
                _ => joint,
            })
    }
}

impl TreeJoint {
    fn angle(&self, joints: &Joints) -> Degrees {
        match self.turn {
            Turn::Fixed => Degrees(0.0),
            Turn::Follows { rear, fore } => joints.rear * rear + joints.fore * fore,
            Turn::Driven { .. } => match &*self.name {
                "base" => joints.base,
                "rear" => joints.rear,
                "fore" => joints.fore,
                _ => joints.servo,
            },
        }
    }
}

fn split(joint: &Joint) -> Vec<TreeJoint> {
    let whole = TreeJoint {
        name: joint.name.into(),
        parent: joint.parent.into(),
        child: joint.child.into(),
        at_mm: joint.at_mm,
        turn: joint.turn,
    };
    let Turn::Follows { rear, fore } = joint.turn else {
        return vec![whole];
    };
    if rear * fore == 0.0 {
        return vec![whole];
    }
    let between: Cow<'static, str> = format!("{}_level", joint.child).into();
    let first = TreeJoint {
        name: between.clone(),
        child: between.clone(),
        turn: Turn::Follows { rear, fore: 0.0 },
        ..whole.clone()
    };
    let second = TreeJoint {
        parent: between,
        at_mm: [0.0; 3],
        turn: Turn::Follows { rear: 0.0, fore },
        ..whole
    };
    vec![first, second]
}

#[cfg(test)]
mod tests {
    use dobot_arm::{Millimeters, Position, Tool, forward};
    use proptest::prelude::*;

    use super::*;
    use crate::mounted_tool::MountedTool;

    /// A point of a link in the frame of the root.
    fn place(frames: &[LinkFrame], link: &str, mut point: [f64; 3]) -> [f64; 3] {
        let mut link = link;
        while let Some(frame) = frames.iter().find(|frame| frame.child == link) {
            let (sin, cos) = frame.angle.0.to_radians().sin_cos();
            let [x, y, z] = point;
            let turned = if frame.axis == [0.0, 0.0, 1.0] {
                [cos * x - sin * y, sin * x + cos * y, z]
            } else {
                [cos * x + sin * z, y, cos * z - sin * x]
            };
            point = std::array::from_fn(|i| turned[i] + frame.at_mm[i]);
            link = &frame.parent;
        }
        point
    }

    proptest! {
        #[test]
        fn the_frames_place_the_tool_as_the_kinematics_do(
            base in -180.0..180.0, rear in -5.0..85.0, fore in -10.0..95.0, servo in -90.0..90.0,
        ) {
            let tool = MountedTool::new(Tool::Gripper, Millimeters(50.0)).expect("it is allowed");
            let joints = Joints::new(base, rear, fore, servo);
            let frames = Model::new(Some(tool)).link_frames(&joints);
            let [x, y, z] = place(&frames, "tool", [0.0; 3]);
            let expected = forward(&joints, Tool::Gripper).position;
            let off = Position::new(x, y, z).distance(expected).0;
            prop_assert!(off < 1e-9, "{off} mm");
        }
    }

    #[test]
    fn every_driven_joint_is_between_base_and_tool() {
        let tool = MountedTool::new(Tool::Pen, Millimeters(50.0)).expect("it is allowed");
        let joints: Vec<TreeJoint> = Model::new(Some(tool)).tree().collect();
        let mut driven = Vec::new();
        let mut link = Cow::from("tool");
        while let Some(joint) = joints.iter().find(|joint| joint.child == link) {
            if let Turn::Driven { .. } = joint.turn {
                driven.push(&*joint.name);
            }
            link = joint.parent.clone();
        }
        assert_eq!(driven, ["servo", "fore", "rear", "base"]);
    }

    #[test]
    fn every_link_has_one_parent_and_only_the_tip_is_fixed() {
        let tool = MountedTool::new(Tool::Pen, Millimeters(50.0)).expect("it is allowed");
        let frames = Model::new(Some(tool)).link_frames(&Joints::default());
        for frame in &frames {
            let same = frames.iter().filter(|other| other.child == frame.child);
            assert_eq!(same.count(), 1, "{}", frame.child);
            assert_eq!(frame.is_fixed, frame.child == "tip");
        }
    }
}
