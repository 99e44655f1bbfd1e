//! The range check of a policy's values, and the line of the first one out of range.

use dobot_arm::Limits;

use crate::body::PIVOT;
use crate::policy_error::InvalidValue;
use crate::{Area, Bounds, KeepOut, Policy};

/// Returns the first value that is not allowed.
pub(crate) fn problem(policy: &Policy) -> Option<InvalidValue> {
    spans(policy)
        .into_iter()
        .find_map(|(key, found, widest)| span(key, found, widest))
        .or_else(|| {
            numbers(policy)
                .into_iter()
                .find_map(|(key, found, allowed)| number(key, found, allowed))
        })
        .or_else(|| area("laser.area", &policy.laser.area))
        .or_else(|| {
            let mut keep_outs = policy.keep_out.iter();
            keep_outs.find_map(|(name, keep_out)| {
                check_keep_out(name, keep_out)
                    .or_else(|| around_the_base(name, keep_out, policy.arm.radius_mm))
            })
        })
}

/// Ranges and their widest values, which are what the arm itself can do.
fn spans(policy: &Policy) -> [(&'static str, Bounds, Bounds); 9] {
    let (joints, space, arm) = (&policy.joints, &policy.workspace, Limits::STOCK);
    [
        (
            "joints.base_deg",
            joints.base_deg,
            Bounds::degrees(arm.base),
        ),
        (
            "joints.rear_deg",
            joints.rear_deg,
            Bounds::degrees(arm.rear),
        ),
        (
            "joints.fore_deg",
            joints.fore_deg,
            Bounds::degrees(arm.fore),
        ),
        (
            "joints.servo_deg",
            joints.servo_deg,
            Bounds::degrees(arm.servo),
        ),
        (
            "joints.opening_deg",
            joints.opening_deg,
            Bounds::new(-105.0, arm.opening.max.0),
        ),
        (
            "workspace.x_mm",
            space.x_mm,
            Bounds::new(-arm.reach.max.0, arm.reach.max.0),
        ),
        (
            "workspace.y_mm",
            space.y_mm,
            Bounds::new(-arm.reach.max.0, arm.reach.max.0),
        ),
        (
            "workspace.z_mm",
            space.z_mm,
            Bounds::new(-300.0, Limits::STOCK.z.max.0),
        ),
        (
            "workspace.reach_mm",
            space.reach_mm,
            Bounds::new(arm.reach.min.0, arm.reach.max.0),
        ),
    ]
}

/// Numbers and their ranges.
fn numbers(policy: &Policy) -> [(&'static str, f64, Bounds); 25] {
    let Policy {
        table,
        tool_length,
        arm,
        speed,
        acceleration,
        jump,
        laser,
        jog,
        queue,
        voice,
        ..
    } = policy;
    let within = Bounds::new;
    let highest_mm = Limits::STOCK.z.max.0;
    let fastest = within(0.001, 1000.0);
    let steepest = within(0.001, 10_000.0);
    let length = within(0.0, 200.0);
    [
        ("table.z_mm", table.z_mm, within(-300.0, highest_mm)),
        (
            "table.below_paper_mm",
            table.below_paper_mm,
            within(0.0, 300.0),
        ),
        (
            "tool_length.suction_cup_mm",
            tool_length.suction_cup_mm,
            length,
        ),
        ("tool_length.gripper_mm", tool_length.gripper_mm, length),
        ("tool_length.laser_mm", tool_length.laser_mm, length),
        ("arm.radius_mm", arm.radius_mm, within(0.0, 100.0)),
        ("speed.joint_deg_s", speed.joint_deg_s, fastest),
        ("speed.servo_deg_s", speed.servo_deg_s, fastest),
        ("speed.line_mm_s", speed.line_mm_s, fastest),
        ("speed.writing_mm_s", speed.writing_mm_s, fastest),
        ("speed.jog_percent", speed.jog_percent, within(1.0, 100.0)),
        (
            "acceleration.joint_deg_s2",
            acceleration.joint_deg_s2,
            steepest,
        ),
        (
            "acceleration.servo_deg_s2",
            acceleration.servo_deg_s2,
            steepest,
        ),
        ("acceleration.line_mm_s2", acceleration.line_mm_s2, steepest),
        (
            "acceleration.writing_mm_s2",
            acceleration.writing_mm_s2,
            steepest,
        ),
        ("jump.height_mm", jump.height_mm, within(0.0, 300.0)),
        ("laser.arm_for_s", laser.arm_for_s, within(1.0, 3600.0)),
        (
            "laser.least_speed_mm_s",
            laser.least_speed_mm_s,
            within(0.0, 1000.0),
        ),
        ("laser.longest_s", laser.longest_s, within(0.1, 3600.0)),
        ("jog.dead_man_s", jog.dead_man_s, within(0.05, 2.0)),
        ("jog.raw_dead_man_s", jog.raw_dead_man_s, within(0.05, 5.0)),
        ("jog.reaction_s", jog.reaction_s, within(0.05, 2.0)),
        ("queue.ahead_s", queue.ahead_s, within(0.0, 60.0)),
        ("queue.line_s", queue.line_s, within(0.5, 3600.0)),
        ("voice.largest_mm", voice.largest_mm, within(1.0, 1000.0)),
    ]
}

fn check_keep_out(name: &str, keep_out: &KeepOut) -> Option<InvalidValue> {
    let plain = |letter: char| letter.is_ascii_alphanumeric() || "-_".contains(letter);
    if name.is_empty() || !name.chars().all(plain) {
        return Some(InvalidValue {
            key: format!("keep_out.{name}"),
            found: format!("called {name:?}"),
            allowed: "names of letters, digits, - and _".to_owned(),
        });
    }
    match keep_out {
        KeepOut::Box(sides) => area(&format!("keep_out.{name}.box"), sides),
        KeepOut::Cylinder(cylinder) => {
            let key = |field: &str| format!("keep_out.{name}.cylinder.{field}");
            number(key("x_mm"), cylinder.x_mm, ANYWHERE)
                .or_else(|| number(key("y_mm"), cylinder.y_mm, ANYWHERE))
                .or_else(|| {
                    number(
                        key("radius_mm"),
                        cylinder.radius_mm,
                        Bounds::new(0.0, 1000.0),
                    )
                })
                .or_else(|| span(key("z_mm"), cylinder.z_mm, ANYWHERE))
        }
    }
}

/// The arm's base is always in place: a keep-out there would forbid everything.
fn around_the_base(name: &str, keep_out: &KeepOut, radius_mm: f64) -> Option<InvalidValue> {
    keep_out
        .touches(&[PIVOT, PIVOT], radius_mm + 1.0)
        .then(|| InvalidValue {
            key: format!("keep_out.{name}"),
            found: "around the pivot of the rear arm".to_owned(),
            allowed: format!(
                "keep-outs that are more than {radius_mm} mm (arm.radius_mm) away from it"
            ),
        })
}

fn area(key: &str, area: &Area) -> Option<InvalidValue> {
    let fields = [
        ("x_mm", area.x_mm),
        ("y_mm", area.y_mm),
        ("z_mm", area.z_mm),
    ];
    fields
        .into_iter()
        .find_map(|(field, found)| span(format!("{key}.{field}"), found, ANYWHERE))
}

fn span(key: impl Into<String>, found: Bounds, widest: Bounds) -> Option<InvalidValue> {
    let Bounds { min, max } = found;
    if min <= max && widest.contains(min) && widest.contains(max) {
        return None;
    }
    Some(InvalidValue {
        key: key.into(),
        found: format!("[{min}, {max}]"),
        allowed: format!("[min, max] with min <= max within {widest}"),
    })
}

fn number(key: impl Into<String>, found: f64, allowed: Bounds) -> Option<InvalidValue> {
    if allowed.contains(found) {
        return None;
    }
    Some(InvalidValue {
        key: key.into(),
        found: found.to_string(),
        allowed: allowed.to_string(),
    })
}

const ANYWHERE: Bounds = Bounds::new(-1000.0, 1000.0);
