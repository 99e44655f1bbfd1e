//! An arm at a moment, and on the way from one to another.

use std::time::Duration;

use dobot_arm::{Joints, Pose, forward};

use super::place::rounded;
use super::tip::Tip;
use super::{Actuators, ArmState, Tool};

/// An arm at a moment.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ArmMoment {
    pub(crate) at: Duration,
    pub(crate) joints: Joints,
    pub(crate) actuators: Actuators,
    pub(crate) tip: Tip,
}

impl ArmMoment {
    /// Whether its angles are such that an arm can have them.
    pub(crate) fn is_somewhere(&self) -> bool {
        let angles = self.joints.angles_deg().into_iter();
        angles
            .chain([self.actuators.gripper_deg])
            .all(|angle| angle.abs() <= MAX_DEG)
    }

    /// Whether anything but time passes on the way to another moment.
    pub(crate) fn changes(&self, to: &Self) -> bool {
        self.joints != to.joints || self.actuators != to.actuators || to.actuators.laser
    }

    /// In how many pieces to go on to another moment: so many that the tip goes a millimetre or two
    /// in each, and the fingers close by as much.
    pub(crate) fn pieces(&self, to: &Self) -> u32 {
        let way_mm = self.tip.at.distance(to.tip.at);
        let up_mm = (to.tip.height_mm - self.tip.height_mm).abs();
        let turn_deg = (to.tip.turn_deg - self.tip.turn_deg).abs();
        let grip_deg = (to.actuators.gripper_deg - self.actuators.gripper_deg).abs();
        let longest = way_mm.max(up_mm).max(turn_deg).max(grip_deg);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "from 1 to 64"
        )]
        let pieces = longest.clamp(1.0, 64.0).ceil() as u32;
        pieces
    }

    /// The moment after so many of the pieces on the way to another one; pump and laser act as
    /// there from the beginning.
    pub(crate) fn towards(&self, to: &Self, piece: u32, pieces: u32, tool: &Tool) -> Self {
        if piece == pieces {
            return *to;
        }
        let share = f64::from(piece) / f64::from(pieces);
        let joints = self.joints.towards(&to.joints, share);
        let (from_deg, to_deg) = (self.actuators.gripper_deg, to.actuators.gripper_deg);
        Self {
            at: self.at + to.at.saturating_sub(self.at).mul_f64(share),
            joints,
            actuators: Actuators {
                gripper_deg: from_deg + (to_deg - from_deg) * share,
                ..to.actuators
            },
            tip: Tip::of(&joints, tool),
        }
    }

    pub(crate) fn state(&self, tool: &Tool, held_mm: f64) -> ArmState {
        let Pose { position, rotation } = forward(&self.joints, tool.tool());
        ArmState {
            base_deg: rounded(self.joints.base.0),
            rear_deg: rounded(self.joints.rear.0),
            fore_deg: rounded(self.joints.fore.0),
            servo_deg: rounded(self.joints.servo.0),
            x_mm: rounded(position.x.0),
            y_mm: rounded(position.y.0),
            z_mm: rounded(position.z.0),
            rotation_deg: rounded(rotation.0),
            tip_mm: rounded(self.tip.height_mm),
            pump: self.actuators.pump,
            laser: self.actuators.laser,
            gripper_deg: rounded(self.actuators.gripper_deg),
            opening_mm: rounded(tool.opening_mm(self.actuators.gripper_deg).max(held_mm)),
        }
    }
}

/// Ten turns.
const MAX_DEG: f64 = 3600.0;
