//! The inverse kinematics of a straight way, a tick ahead.

use dobot_arm::stock::{StockJoints, StockPose, inverse};

/// The angles for the place to which the next tick of a straight way will probably lead.
///
/// The angles of a place are a long row of steps of which each waits for the one before, and the pose
/// in which a tick ends is another, which waits for the angles. Calculated a tick ahead they do not
/// wait for each other: the host's processor does both at once. They are the same, digit by digit.
#[derive(Debug, Default)]
pub(crate) struct Ahead(Option<Stop>);

#[derive(Clone, Copy, Debug)]
struct Stop {
    place: [f32; 3],
    tool_mm: f32,
    /// All but that of the servo.
    joints: StockJoints,
}

impl Ahead {
    /// The angles for a place, but for the servo's; those for the next one are calculated, too.
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

    /// Digit by digit: a zero has its sign.
    fn is_for(&self, place: [f32; 3], tool_mm: f32) -> bool {
        self.place.map(f32::to_bits) == place.map(f32::to_bits) && self.tool_mm == tool_mm
    }
}
