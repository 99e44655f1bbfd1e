//! The inverse kinematics of a straight line, one tick ahead.

use dobot_arm::stock::{StockJoints, StockPose, inverse};

/// The joint angles at the probable end of the next tick of a straight line.
///
/// The angles of a position are a long chain of dependent operations, and the pose at the end of a
/// tick is another, which depends on the angles. Calculated a tick ahead they are independent, and the
/// host's processor runs both in parallel. The results are bit for bit the same.
#[derive(Debug, Default)]
pub(crate) struct Ahead(Option<Stop>);

#[derive(Clone, Copy, Debug)]
struct Stop {
    place: [f32; 3],
    tool_mm: f32,
    /// All angles but the servo's.
    joints: StockJoints,
}

impl Ahead {
    /// Returns the angles for a position, except the servo's; also calculates those for the next.
    pub(crate) fn solve(
        &mut self,
        place: [f32; 3],
        next: Option<[f32; 3]>,
        tool_mm: f32,
    ) -> StockJoints {
        let joints = match &self.0 {
            Some(stop) if stop.is_for(place, tool_mm) => stop.joints,
            _ => Stop::new(place, tool_mm).joints,
        };
        self.0 = next.map(|place| Stop::new(place, tool_mm));
        joints
    }
}

impl Stop {
    fn new(place @ [x_mm, y_mm, z_mm]: [f32; 3], tool_mm: f32) -> Self {
        let pose = StockPose {
            x_mm,
            y_mm,
            z_mm,
            rotation_deg: 0.0,
        };
        Self {
            place,
            tool_mm,
            joints: inverse(pose, tool_mm),
        }
    }

    /// Compares bit for bit: zeros are signed.
    fn is_for(&self, place: [f32; 3], tool_mm: f32) -> bool {
        self.place.map(f32::to_bits) == place.map(f32::to_bits) && self.tool_mm == tool_mm
    }
}
