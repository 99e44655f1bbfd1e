//! The commands of simple steps.

use dobot_wire::{
    Command, Configuration, JointJog, JointJogAxis, MoveJoints, MoveTo, MovingMode, single,
};

use super::resolve::{Spot, SpotKind};
use super::state::State;
use crate::program::MountedTool;

/// A move to a place that sets the tool to the current state.
pub(super) fn target(spot: &Spot, mode: MovingMode, pause: Option<f64>, state: &State) -> Command {
    let (suction, gripper_deg) = (state.suction, single(state.gripper_deg));
    let pause_s = single(pause.unwrap_or(0.0));
    match spot.to {
        SpotKind::Joints(joints) => MoveJoints {
            suction,
            mode,
            gripper_deg,
            pause_s,
            ..MoveJoints::to(joints.angles_deg().map(single))
        }
        .into(),
        SpotKind::Wrist(pose) => {
            let [x_mm, y_mm, z_mm, rotation_deg] = Spot::numbers(&pose).map(single);
            MoveTo {
                x_mm,
                y_mm,
                z_mm,
                rotation_deg,
                suction,
                mode,
                gripper_deg,
                pause_s,
            }
            .into()
        }
    }
}

/// A command that switches the laser (state 2, buttons 13 and 14).
pub(super) fn laser(on: bool) -> Command {
    let axis = if on {
        JointJogAxis::LaserOn
    } else {
        JointJogAxis::LaserOff
    };
    JointJog::new(axis, 0.0).into()
}

/// A command that sets the mounted tool (state 9, mode 4).
pub(super) fn mounted(tool: &MountedTool) -> Command {
    let tool = tool.kind.into();
    Configuration::EndEffector { tool }.into()
}
