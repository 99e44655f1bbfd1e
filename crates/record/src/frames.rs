//! The links of the arm as transforms, for viewers.

use std::fmt;

use dobot_arm::Tool;
use dobot_model::{LinkFrame, Model, MountedTool};
use dobot_motion::ArmPlace;
use dobot_wire::Status;
use serde_json::{Value, json};

/// A converter from statuses to transforms of the links of the URDF, by its own geometry.
#[derive(Default)]
pub(crate) struct Frames {
    /// The length of each tool, where known.
    tools: Vec<MountedTool>,
    /// The model with the last mounted tool.
    model: Option<(Tool, Model)>,
}

impl Frames {
    /// Sets the lengths of the tools.
    pub(crate) fn set_tools(&mut self, tools: &[MountedTool]) {
        self.tools = tools.to_vec();
        self.model = None;
    }

    /// The distance from the wrist down to the tip, in mm; 0 if unknown.
    pub(crate) fn length_mm(&self, tool: Tool) -> f64 {
        self.mounted(tool).map_or(0.0, |mounted| mounted.length().0)
    }

    /// The transform of each link relative to its parent.
    pub(crate) fn transforms(&mut self, status: &Status, tool: Tool, time: &Value) -> Value {
        let mounted = self.mounted(tool);
        let model = match self.model.take() {
            Some((of, model)) if of == tool => model,
            _ => Model::new(mounted.or_else(|| of_any_length(tool))),
        };
        let links = model.link_frames(&ArmPlace::of_status(status).joints);
        self.model = Some((tool, model));
        // Without the length of the tool its tip is unknown.
        let known = links
            .iter()
            .filter(|link| mounted.is_some() || link.child != "tip");
        json!({ "transforms": known.map(|known| transform(known, time)).collect::<Vec<_>>() })
    }

    fn mounted(&self, tool: Tool) -> Option<MountedTool> {
        let mut tools = self.tools.iter().copied();
        tools.find(|mounted| mounted.kind() == tool.end_effector())
    }
}

impl fmt::Debug for Frames {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Frames")
            .field("tools", &self.tools)
            .finish_non_exhaustive()
    }
}

/// A tool for the frames up to its mount, which do not depend on its length.
fn of_any_length(tool: Tool) -> Option<MountedTool> {
    MountedTool::new(tool, dobot_arm::Millimeters(ANY_MM)).ok()
}

fn transform(link: &LinkFrame, time: &Value) -> Value {
    let at = link.at_mm.map(metres);
    let (sin, cos) = (link.angle.0.to_radians() / 2.0).sin_cos();
    let [x, y, z] = link.axis.map(|axis| rounded(axis * sin, TURN));
    json!({
        "timestamp": time,
        "parent_frame_id": link.parent,
        "child_frame_id": link.child,
        "translation": { "x": at[0], "y": at[1], "z": at[2] },
        "rotation": { "x": x, "y": y, "z": z, "w": rounded(cos, TURN) },
    })
}

/// Converts millimetres to metres, to a thousandth of a millimetre.
pub(crate) fn metres(mm: f64) -> f64 {
    rounded(mm / 1000.0, MICRO)
}

/// Rounds a number to fractions of one, which shortens the text, and removes a negative zero.
fn rounded(number: f64, parts: f64) -> f64 {
    (number * parts).round() / parts + 0.0
}

/// The frame of all poses, with its origin at the rear arm's pivot.
pub(crate) const BASE: &str = "base";

const MICRO: f64 = 1e6;
/// Smaller rotations move the tool by at most a quarter of a thousandth of a millimetre.
const TURN: f64 = 1e7;
const ANY_MM: f64 = 50.0;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use dobot_arm::{Joints, Millimeters, forward};
    use proptest::prelude::*;

    use super::*;

    /// The origin of a frame in the frame `base`, in metres, by quaternions only.
    fn place(transforms: &Value, frame: &str) -> [f64; 3] {
        let (mut point, mut frame) = ([0.0; 3], frame.to_owned());
        while frame != BASE {
            let mut all = transforms["transforms"].as_array().unwrap().iter();
            let link = all.find(|item| item["child_frame_id"] == *frame).unwrap();
            let part = |name: &str, axis: &str| link[name][axis].as_f64().unwrap();
            let [x, y, z, w] = ["x", "y", "z", "w"].map(|name| part("rotation", name));
            // p + 2w (q x p) + 2 q x (q x p)
            let cross = |[a, b, c]: [f64; 3]| [y * c - z * b, z * a - x * c, x * b - y * a];
            let (once, twice) = (cross(point), cross(cross(point)));
            let at = ["x", "y", "z"].map(|name| part("translation", name));
            point = std::array::from_fn(|i| at[i] + point[i] + 2.0 * (w * once[i] + twice[i]));
            link["parent_frame_id"]
                .as_str()
                .unwrap()
                .clone_into(&mut frame);
        }
        point
    }

    proptest! {
        #[test]
        fn the_chain_of_the_transforms_ends_at_the_pose(
            base in -130.0..130.0, rear in -5.0..85.0, fore in -10.0..95.0, servo in -90.0..90.0,
        ) {
            let mut frames = Frames::default();
            let laser = MountedTool::new(Tool::Laser, Millimeters(40.0)).unwrap();
            frames.set_tools(&[laser]);
            for tool in Tool::END_EFFECTORS {
                let status = ArmPlace::at_joints(Joints::new(base, rear, fore, servo), tool).status();
                let joints = ArmPlace::of_status(&status).joints;
                let position = forward(&joints, tool).position;
                let transforms = frames.transforms(&status, tool, &json!({}));
                let expected = [position.x, position.y, position.z].map(|value| value.0 / 1000.0);
                let found = place(&transforms, "tool");
                for (found, expected) in found.iter().zip(expected) {
                    prop_assert!((found - expected).abs() < 1e-6, "{found}, not {expected}");
                }
                // Only the length of the laser is known.
                let all = transforms["transforms"].as_array().unwrap();
                let has_tip = all.iter().any(|item| item["child_frame_id"] == "tip");
                prop_assert_eq!(has_tip, tool == Tool::Laser);
                if has_tip {
                    let below = place(&transforms, "tip")[2] - expected[2];
                    prop_assert!((below + 0.04).abs() < 1e-6, "{}", below);
                }
            }
        }
    }

    #[test]
    fn the_frames_are_the_links_of_the_urdf() {
        let mut frames = Frames::default();
        let cup = MountedTool::new(Tool::SuctionCup, Millimeters(60.0)).unwrap();
        frames.set_tools(&[cup]);
        let transforms = frames.transforms(&Status::AT_ZERO, Tool::SuctionCup, &json!({}));
        let urdf = Model::new(Some(cup)).to_urdf();
        let all = transforms["transforms"].as_array().unwrap();
        for link in all {
            let name = link["child_frame_id"].as_str().unwrap();
            assert!(urdf.contains(&format!(r#"<link name="{name}""#)), "{name}");
        }
        // Every link but `base` has a transform.
        assert_eq!(urdf.matches("<link name=").count(), all.len() + 1);
    }
}
