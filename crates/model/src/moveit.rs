//! The model as a configuration of MoveIt.

use dobot_motion::Speeds;
use xmlwriter::XmlWriter;

use crate::collisions::Reason;
use crate::joint::Turn;
use crate::model::Model;
use crate::xml::{document, element, numbers};

impl Model {
    /// The model as a configuration of MoveIt for the arm of `dobot-ros2`: the name and the text of each file of a folder.
    ///
    /// The group `arm` is the chain from `base` to `tool`, or to `wrist` without a tool. Speeds and accelerations are those
    /// of an arm after power-up.
    #[must_use]
    pub fn to_moveit(&self) -> Vec<(&'static str, String)> {
        vec![
            ("dobot_arm.urdf", self.to_urdf()),
            ("dobot_arm.srdf", self.to_srdf()),
            ("kinematics.yaml", KINEMATICS.to_owned()),
            ("joint_limits.yaml", self.joint_limits()),
            ("moveit_controllers.yaml", self.controllers()),
            ("demo.launch.py", LAUNCH.to_owned()),
            ("moveit.rviz", RVIZ.to_owned()),
        ]
    }

    /// The semantic description: groups, named poses, end effector, and the pairs of links that need no check.
    fn to_srdf(&self) -> String {
        let mut xml =
            document(" The original Dobot Arm (V1.0, 2016) for MoveIt; written by `dobot model` ");
        xml.start_element("robot");
        xml.write_attribute("name", "dobot_arm");
        let tip = if self.tool.is_some() { "tool" } else { "wrist" };
        group(
            &mut xml,
            "arm",
            "chain",
            &[("base_link", "base"), ("tip_link", tip)],
        );
        if self.tool.is_some() {
            group(&mut xml, "tip", "link", &[("name", "tip")]);
            element(
                &mut xml,
                "end_effector",
                &[
                    ("name", "tip"),
                    ("parent_link", "tool"),
                    ("group", "tip"),
                    ("parent_group", "arm"),
                ],
            );
        }
        for (name, rear_deg, fore_deg) in POSES {
            self.pose(&mut xml, name, rear_deg, fore_deg);
        }
        for pair in self.unchecked_pairs() {
            let reason = match pair.reason {
                Reason::Adjacent => "Adjacent",
                Reason::Never => "Never",
            };
            let [one, other] = pair.links;
            let pair = [("link1", one), ("link2", other), ("reason", reason)];
            element(&mut xml, "disable_collisions", &pair);
        }
        xml.end_document()
    }

    fn pose(&self, xml: &mut XmlWriter, name: &str, rear_deg: f64, fore_deg: f64) {
        xml.start_element("group_state");
        xml.write_attribute("name", name);
        xml.write_attribute("group", "arm");
        for joint in self.driven() {
            let deg: f64 = match joint {
                "rear" => rear_deg,
                "fore" => fore_deg,
                _ => 0.0,
            };
            let value = numbers([deg.to_radians()]);
            element(xml, "joint", &[("name", joint), ("value", &value)]);
        }
        xml.end_element();
    }

    fn driven(&self) -> impl Iterator<Item = &'static str> {
        let joints = self.joints.iter();
        let driven = joints.filter(|joint| matches!(joint.turn, Turn::Driven { .. }));
        driven.map(|joint| joint.name)
    }

    fn joint_limits(&self) -> String {
        let speeds = Speeds::STOCK.scaled(POWER_UP_PERCENT, POWER_UP_PERCENT);
        let mut yaml = "# Those of an arm after power-up, with which dobot-ros2 follows trajectories: rad/s and rad/s2.\n\
            default_velocity_scaling_factor: 1.0\n\
            default_acceleration_scaling_factor: 1.0\n\
            joint_limits:\n"
            .to_owned();
        for joint in self.driven() {
            let [velocity, acceleration] = if joint == "servo" {
                [speeds.servo_deg_s, speeds.servo_deg_s2]
            } else {
                [speeds.joint_deg_s, speeds.joint_deg_s2]
            }
            .map(f64::to_radians);
            let limits = format!(
                "  {joint}:\n    has_velocity_limits: true\n    max_velocity: {velocity}\n    \
                 has_acceleration_limits: true\n    max_acceleration: {acceleration}\n"
            );
            yaml.push_str(&limits);
        }
        yaml
    }

    fn controllers(&self) -> String {
        let joints: Vec<&str> = self.driven().collect();
        CONTROLLERS.replace("JOINTS", &joints.join(", "))
    }
}

fn group(xml: &mut XmlWriter, name: &str, kind: &str, members: &[(&str, &str)]) {
    xml.start_element("group");
    xml.write_attribute("name", name);
    element(xml, kind, members);
    xml.end_element();
}

/// Named poses, with base and servo at 0: the name, and the angles of rear arm and forearm. An arm is switched on as in the
/// first one (note N28).
const POSES: [(&str, f64, f64); 2] = [("power_up", 45.0, 45.0), ("upright", 0.0, 0.0)];

/// The percentages after power-up.
const POWER_UP_PERCENT: f64 = 50.0;

const KINEMATICS: &str = include_str!("moveit/kinematics.yaml");
const CONTROLLERS: &str = include_str!("moveit/moveit_controllers.yaml");
const LAUNCH: &str = include_str!("moveit/demo.launch.py");
const RVIZ: &str = include_str!("moveit/moveit.rviz");

#[cfg(test)]
mod tests {
    use dobot_arm::{Joints, Limits, Tool};

    use super::*;

    #[test]
    fn every_named_pose_is_within_the_limits() {
        for (name, rear_deg, fore_deg) in POSES {
            let joints = Joints::new(0.0, rear_deg, fore_deg, 0.0);
            for tool in Tool::ALL {
                assert!(Limits::STOCK.check(&joints, tool).is_ok(), "{name}");
            }
        }
    }

    #[test]
    fn an_arm_without_a_tool_has_no_servo_and_no_end_effector() {
        let files = Model::new(None).to_moveit();
        let text = |name: &str| {
            let file = files.iter().find(|file| file.0 == name);
            file.expect("it is there").1.clone()
        };
        assert!(text("dobot_arm.srdf").contains("tip_link=\"wrist\""));
        for name in [
            "dobot_arm.srdf",
            "joint_limits.yaml",
            "moveit_controllers.yaml",
        ] {
            assert!(!text(name).contains("servo"), "{name}");
        }
    }
}
