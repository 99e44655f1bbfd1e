//! Whether the numbers of a status belong together.

use crate::kinematics::RAD_PER_DEG;
use crate::{FOREARM, REAR_ARM, Tool};

/// Whether position, rotation and joint angles of a status describe the same pose.
///
/// A status carries no checksum, but it reports the tool position twice: as coordinates and as joint
/// angles (Table 2.3). They agree where the position lies within 0.01 mm of the forward
/// kinematics with one of the tools, and the rotation within 0.01 degrees of base plus servo. A
/// number that is not finite never agrees.
///
/// `position_mm` is x, y, z; `joints_deg` is base, rear, fore, servo.
///
/// ```
/// // Sent by a real arm that stood at base -33, rear 14, fore 29 degrees.
/// let position = [190.93837, -123.99719, 53.42032];
/// assert!(dobot_arm::agrees(position, -33.0, [-33.0, 14.0, 29.0, 0.0]));
/// assert!(!dobot_arm::agrees(position, -33.0, [-33.0, 14.0, 29.1, 0.0]));
/// ```
#[must_use]
pub fn agrees(position_mm: [f64; 3], rotation_deg: f64, joints_deg: [f64; 4]) -> bool {
    let [x, y, z] = position_mm;
    let [base, rear, fore, servo] = joints_deg;
    let (sin_base, cos_base) = libm::sincos(base * RAD_PER_DEG);
    let (sin_rear, cos_rear) = libm::sincos(rear * RAD_PER_DEG);
    let (sin_fore, cos_fore) = libm::sincos(fore * RAD_PER_DEG);
    let wrist = REAR_ARM.0 * sin_rear + FOREARM.0 * cos_fore;
    let height = REAR_ARM.0 * cos_rear - FOREARM.0 * sin_fore;
    let fits = |tool: Tool| {
        let reach = wrist + tool.reach().0;
        near(x, reach * cos_base) && near(y, reach * sin_base)
    };
    near(z, height)
        && near(rotation_deg, base + servo)
        && (fits(Tool::SuctionCup) || fits(Tool::Laser))
}

fn near(reported: f64, calculated: f64) -> bool {
    (reported - calculated).abs() <= TOLERANCE
}

/// Millimetres or degrees; a stock arm's single precision errs by less than 0.0001.
const TOLERANCE: f64 = 0.01;
