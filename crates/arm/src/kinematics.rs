//! From joint angles to poses and back, in `f64`.

use core::f64::consts::PI;

use crate::{Degrees, Joints, Millimeters, Pose, Position, Quantity, Tool, Unreachable};

/// From pivot to elbow.
pub const REAR_ARM: Millimeters = Millimeters(135.0);

/// From elbow to wrist.
pub const FOREARM: Millimeters = Millimeters(160.0);

/// Where these joint angles bring the tool.
///
/// Total: angles beyond the limits are calculated all the same, and NaN gives NaN; see
/// [`Limits::check`](crate::Limits::check).
///
/// ```text
/// reach = 135 sin(rear) + 160 cos(fore) + L      x = reach cos(base)
///     z = 135 cos(rear) - 160 sin(fore)          y = reach sin(base)
/// ```
#[must_use]
pub fn forward(joints: &Joints, tool: Tool) -> Pose {
    let [reach_mm, z_mm] = reach_and_height(joints, tool);
    Pose {
        position: Position::polar(Millimeters(reach_mm), joints.base, Millimeters(z_mm)),
        rotation: joints.base + joints.servo,
    }
}

/// The joint angles that bring the tool to this pose, with the elbow up.
///
/// This is geometry only: whether the arm can go there is checked by
/// [`Limits::check_at`](crate::Limits::check_at). The base angle lies in -180..=180.
///
/// ```text
///           elbow                    distance = hypot(reach - L, z), pivot to wrist
///            /\                     elevation = atan2(z, reach - L)
///     135   /  \   160                  alpha = at the pivot, from wrist to elbow
///          / alpha gamma                gamma = at the wrist, from pivot to elbow
///         /________\ wrist  L  tool
///       pivot                            rear = 90 - elevation - alpha
///                                        fore = gamma - elevation
/// ```
///
/// # Errors
///
/// [`Unreachable`] where a number is not finite, or where the wrist would be nearer to the pivot
/// than the difference of the two links or farther than their sum.
pub fn inverse(pose: &Pose, tool: Tool) -> Result<Joints, Unreachable> {
    let z = pose.position.z;
    let across_mm = pose.position.reach().0 - tool.reach().0;
    let distance_v2 = across_mm * across_mm + z.0 * z.0;
    let distance_mm = libm::sqrt(distance_v2);
    let within = (NEAREST_MM..=FARTHEST_MM).contains(&distance_mm);
    if !(within && pose.rotation.0.is_finite()) {
        return Err(why_unreachable(pose, distance_mm));
    }
    let per_distance = 1.0 / distance_mm;
    let alpha_rad = acos((distance_v2 - LINKS_V2) * per_distance * PER_REAR);
    let gamma_rad = acos((distance_v2 + LINKS_V2) * per_distance * PER_FORE);
    let elevation_rad = libm::atan2(z.0, across_mm);
    let base = pose.position.direction();
    Ok(Joints {
        base,
        rear: Degrees(90.0 - (elevation_rad + alpha_rad) * DEG_PER_RAD),
        fore: Degrees((gamma_rad - elevation_rad) * DEG_PER_RAD),
        servo: pose.rotation - base,
    })
}

/// Reach and z of the tool in mm, which the base angle does not change.
pub(crate) fn reach_and_height(joints: &Joints, tool: Tool) -> [f64; 2] {
    let (sin_rear, cos_rear) = libm::sincos(joints.rear.0 * RAD_PER_DEG);
    let (sin_fore, cos_fore) = libm::sincos(joints.fore.0 * RAD_PER_DEG);
    [
        REAR_ARM.0 * sin_rear + FOREARM.0 * cos_fore + tool.reach().0,
        REAR_ARM.0 * cos_rear - FOREARM.0 * sin_fore,
    ]
}

/// `acos`, where rounding may have pushed a cosine of a stretched or folded arm beyond 1.
fn acos(cosine: f64) -> f64 {
    libm::acos(cosine.clamp(-1.0, 1.0))
}

#[cold]
fn why_unreachable(pose: &Pose, distance_mm: f64) -> Unreachable {
    let Position { x, y, z } = pose.position;
    let named = [
        (Quantity::X, x.0),
        (Quantity::Y, y.0),
        (Quantity::Z, z.0),
        (Quantity::Rotation, pose.rotation.0),
    ];
    match named.into_iter().find(|(_, value)| !value.is_finite()) {
        Some((quantity, found)) => Unreachable::NotFinite { quantity, found },
        None => Unreachable::OutOfRange {
            quantity: Quantity::Stretch,
            found: distance_mm,
            min: FOREARM.0 - REAR_ARM.0,
            max: FOREARM.0 + REAR_ARM.0,
        },
    }
}

pub(crate) const RAD_PER_DEG: f64 = PI / 180.0;
pub(crate) const DEG_PER_RAD: f64 = 180.0 / PI;

/// The tolerance for rounding of a value at a limit.
pub(crate) const ROUNDING: f64 = 1e-9;

const NEAREST_MM: f64 = FOREARM.0 - REAR_ARM.0 - ROUNDING;
const FARTHEST_MM: f64 = FOREARM.0 + REAR_ARM.0 + ROUNDING;

/// The difference of the squared link lengths.
const LINKS_V2: f64 = FOREARM.0 * FOREARM.0 - REAR_ARM.0 * REAR_ARM.0;

const PER_REAR: f64 = 0.5 / REAR_ARM.0;
const PER_FORE: f64 = 0.5 / FOREARM.0;
