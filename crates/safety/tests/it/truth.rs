//! A slow second implementation of the policy: for one position, by points.

use dobot_arm::Tool;
use dobot_motion::ArmPlace;
use dobot_safety::{Bounds, KeepOut, Policy};

/// Returns the rules broken at a position with the suction cup; values and points may be off by
/// `tolerance`.
pub(crate) fn broken(policy: &Policy, place: &ArmPlace, tolerance: f64) -> Option<String> {
    let joints = place.joints;
    let position = place.pose.position;
    let (x, y, z) = (position.x.0, position.y.0, position.z.0);
    let measures = [
        ("joints.base", joints.base.0, policy.joints.base_deg),
        ("joints.rear", joints.rear.0, policy.joints.rear_deg),
        ("joints.fore", joints.fore.0, policy.joints.fore_deg),
        ("joints.servo", joints.servo.0, policy.joints.servo_deg),
        (
            "joints.opening",
            joints.rear.0 - joints.fore.0,
            policy.joints.opening_deg,
        ),
        ("workspace.x", x, policy.workspace.x_mm),
        ("workspace.y", y, policy.workspace.y_mm),
        ("workspace.z", z, policy.workspace.z_mm),
        ("workspace.reach", x.hypot(y), policy.workspace.reach_mm),
    ];
    let out =
        |value: f64, span: Bounds| value < span.min - tolerance || value > span.max + tolerance;
    for (rule, value, span) in measures {
        if out(value, span) {
            return Some(format!("{rule}: {value}"));
        }
    }
    let length = policy.tool_length.suction_cup_mm;
    if z - length < policy.table.z_mm - tolerance {
        return Some(format!("table: {z}"));
    }
    let radius = policy.arm.radius_mm - tolerance;
    for (name, keep_out) in &policy.keep_out {
        if let Some(point) = points(place, length).find(|point| holds(keep_out, *point, radius)) {
            return Some(format!("keep_out.{name}: {point:?}"));
        }
    }
    None
}

/// Points along rear arm, forearm, hand and tool.
fn points(place: &ArmPlace, length: f64) -> impl Iterator<Item = [f64; 3]> {
    let joints = place.joints;
    let (rear, fore) = (joints.rear.0.to_radians(), joints.fore.0.to_radians());
    let base = joints.base.0.to_radians();
    let elbow = [135.0 * rear.sin(), 135.0 * rear.cos()];
    let wrist = [elbow[0] + 160.0 * fore.cos(), elbow[1] - 160.0 * fore.sin()];
    let tool = [wrist[0] + Tool::SuctionCup.reach().0, wrist[1]];
    let tip = [tool[0], tool[1] - length];
    let corners = [[0.0, 0.0], elbow, wrist, tool, tip];
    (0..4_usize).flat_map(move |part| {
        (0..=30_i32).map(move |step| {
            let share = f64::from(step) / 30.0;
            let [from, to] = [corners[part], corners[part + 1]];
            let out = from[0] + (to[0] - from[0]) * share;
            let up = from[1] + (to[1] - from[1]) * share;
            [out * base.cos(), out * base.sin(), up]
        })
    })
}

fn holds(keep_out: &KeepOut, [x, y, z]: [f64; 3], radius: f64) -> bool {
    let within = |value: f64, span: Bounds| value > span.min - radius && value < span.max + radius;
    match keep_out {
        KeepOut::Box(space) => {
            within(x, space.x_mm) && within(y, space.y_mm) && within(z, space.z_mm)
        }
        KeepOut::Cylinder(cylinder) => {
            (x - cylinder.x_mm).hypot(y - cylinder.y_mm) < cylinder.radius_mm + radius
                && within(z, cylinder.z_mm)
        }
    }
}
