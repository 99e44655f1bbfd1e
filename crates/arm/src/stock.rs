//! The kinematics of the stock controller, in single precision.
//!
//! Its rounding is part of its behaviour: ticks are counted and values truncated, so that a
//! difference in the last digit may show as millimetres later. A twin of the stock controller
//! calculates with these; planning calculates with [`forward`](crate::forward) and
//! [`inverse`](crate::inverse).

mod functions;
mod integers;

use self::functions::{acos, atan, atan2, sin_cos};
pub use self::integers::{short, short_unsigned, whole};

/// The joint angles as the stock controller holds them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StockJoints {
    /// Joint 1.
    pub base_deg: f32,
    /// Joint 2.
    pub rear_deg: f32,
    /// Joint 3.
    pub fore_deg: f32,
    /// Joint 4.
    pub servo_deg: f32,
}

/// The pose as the stock controller holds it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StockPose {
    /// Forward.
    pub x_mm: f32,
    /// To the left.
    pub y_mm: f32,
    /// Up.
    pub z_mm: f32,
    /// Base plus servo.
    pub rotation_deg: f32,
}

/// Where these joint angles bring a tool that reaches `tool_mm` beyond the wrist.
///
/// The rear arm is calculated from its angle above level: a quarter of a turn less the joint angle,
/// in radians. That shows in the last digits.
#[must_use]
pub fn forward(joints: StockJoints, tool_mm: f32) -> StockPose {
    let (base_sin, base_cos) = sin_cos(radians(joints.base_deg));
    let (rear_sin, rear_cos) = sin_cos(FRAC_PI_2 - radians(joints.rear_deg));
    let (fore_sin, fore_cos) = sin_cos(radians(joints.fore_deg));
    let reach_mm = REAR_MM * rear_cos + FORE_MM * fore_cos + tool_mm;
    StockPose {
        x_mm: reach_mm * base_cos,
        y_mm: reach_mm * base_sin,
        z_mm: REAR_MM * rear_sin - FORE_MM * fore_sin,
        rotation_deg: joints.servo_deg + joints.base_deg,
    }
}

/// The joint angles for a pose, as the stock controller calculates them.
///
/// Out of reach its answer is NaN. Nearer to the base axis than `tool_mm` it is wrong, because it
/// takes the wrist's elevation from a plain arc tangent; the stock limits forbid that place.
#[must_use]
pub fn inverse(pose: StockPose, tool_mm: f32) -> StockJoints {
    let base_deg = degrees(atan2(pose.y_mm, pose.x_mm));
    let up_mm = pose.z_mm;
    let across_mm = reach(pose) - tool_mm;
    let cosine = shoulder_cosine(across_mm, up_mm);
    let rear_above_level = acos(cosine) + atan(up_mm / across_mm);
    let (sin, cos) = sin_cos(rear_above_level);
    let fore = atan2(REAR_MM * sin - up_mm, across_mm - REAR_MM * cos);
    StockJoints {
        base_deg,
        rear_deg: 90.0 - degrees(rear_above_level),
        fore_deg: degrees(fore),
        servo_deg: pose.rotation_deg - base_deg,
    }
}

/// The stock controller's estimated position after a relative motion, in mm: X, Y and Z.
///
/// It begins each way from its own rounded pose: a hundredth of a micrometre short each time, always
/// in the same direction, which is half a millimetre after 50,000 vectors. Out of reach it is the
/// sum of both.
#[must_use]
#[expect(
    clippy::cast_possible_truncation,
    reason = "as the controller holds it"
)]
pub fn behind(from_mm: [f64; 3], way_mm: [f32; 3], tool_mm: f32) -> [f64; 3] {
    let [x_mm, y_mm, z_mm] = [0, 1, 2].map(|i| from_mm[i] as f32 + way_mm[i]);
    let wanted = StockPose {
        x_mm,
        y_mm,
        z_mm,
        rotation_deg: 0.0,
    };
    let found = forward(inverse(wanted, tool_mm), tool_mm);
    let found = [found.x_mm, found.y_mm, found.z_mm];
    if found.iter().all(|mm| mm.is_finite()) {
        found.map(f64::from)
    } else {
        [x_mm, y_mm, z_mm].map(f64::from)
    }
}

/// Whether the arms are too short or too long for a pose, by the stock controller's own test. A
/// pose that is not a number passes it.
#[must_use]
pub fn is_out_of_reach(pose: StockPose, tool_mm: f32) -> bool {
    libm::fabsf(shoulder_cosine(reach(pose) - tool_mm, pose.z_mm)) > 1.0
}

/// How far from the base axis a pose is, in millimetres.
#[must_use]
pub fn reach(pose: StockPose) -> f32 {
    libm::sqrtf(pose.x_mm * pose.x_mm + pose.y_mm * pose.y_mm)
}

/// The tilt reading of the sensor on an arm, in degrees: gravity along two axes, each in whole
/// parts of 16384.
#[must_use]
pub fn sensed(tilt_deg: f64) -> f32 {
    let tilt = tilt_deg.to_radians();
    #[expect(
        clippy::cast_possible_truncation,
        reason = "single precision holds whole numbers of 15 digits"
    )]
    let parts = |share: f64| libm::rint(share * 16_384.0) as f32;
    degrees(atan2(parts(libm::sin(tilt)), parts(libm::cos(tilt))))
}

/// The cosine of the angle at the shoulder, between the rear arm and the way to the wrist.
fn shoulder_cosine(across_mm: f32, up_mm: f32) -> f32 {
    let distance_mm = libm::sqrtf(across_mm * across_mm + up_mm * up_mm);
    (REAR_MM * REAR_MM + distance_mm * distance_mm - FORE_MM * FORE_MM)
        / (2.0 * REAR_MM * distance_mm)
}

fn radians(angle_deg: f32) -> f32 {
    angle_deg / 180.0 * PI
}

fn degrees(angle_rad: f32) -> f32 {
    angle_rad / PI * 180.0
}

const REAR_MM: f32 = 135.0;
const FORE_MM: f32 = 160.0;

const PI: f32 = core::f32::consts::PI;
const FRAC_PI_2: f32 = core::f32::consts::FRAC_PI_2;
