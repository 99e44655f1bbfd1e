//! The limits and keep-outs close to a position of the arm.

use dobot_api::{BoundedQuantity, NearLimit, NearView};
use dobot_arm::{Joints, Tool};
use dobot_motion::ArmPlace;
use dobot_safety::{Bounds, KeepOut, Policy};

/// Returns the policy limits and keep-outs close to a calibrated position of an arm with this tool.
pub(super) fn near(policy: &Policy, place: &ArmPlace, tool: Tool) -> NearView {
    let position = place.pose.position;
    let [x, y, z] = [position.x, position.y, position.z].map(|mm| mm.0);
    let angles = angles(policy, &place.joints)
        .into_iter()
        .flat_map(|angle| near_ends(angle, NEAR_DEG));
    let lengths = lengths(policy, [x, y, z])
        .into_iter()
        .flat_map(|length| near_ends(length, NEAR_MM));
    let tool_at = [[x, y, z], [x, y, z - policy.tool_length.of(tool)]];
    let keep_outs = policy.keep_out.iter().filter_map(|(name, keep_out)| {
        let rooms_mm = tool_at.map(|point| distance_mm(keep_out, point));
        let closeness = closeness(rooms_mm[0].min(rooms_mm[1]), NEAR_MM)?;
        Some((name.clone(), closeness))
    });
    NearView {
        limits: angles.chain(lengths).collect(),
        keep_outs: keep_outs.collect(),
    }
}

fn angles(policy: &Policy, joints: &Joints) -> [(BoundedQuantity, f64, Bounds); 5] {
    let (rear, fore) = (joints.rear.0, joints.fore.0);
    let limits = &policy.joints;
    [
        (BoundedQuantity::Base, joints.base.0, limits.base_deg),
        (BoundedQuantity::Rear, rear, limits.rear_deg),
        (BoundedQuantity::Fore, fore, limits.fore_deg),
        (BoundedQuantity::Servo, joints.servo.0, limits.servo_deg),
        (BoundedQuantity::Opening, rear - fore, limits.opening_deg),
    ]
}

fn lengths(policy: &Policy, [x, y, z]: [f64; 3]) -> [(BoundedQuantity, f64, Bounds); 4] {
    let space = &policy.workspace;
    [
        (BoundedQuantity::X, x, space.x_mm),
        (BoundedQuantity::Y, y, space.y_mm),
        (BoundedQuantity::Z, z, space.z_mm),
        (BoundedQuantity::Reach, x.hypot(y), space.reach_mm),
    ]
}

/// Returns the bounds close to a value.
fn near_ends(
    (quantity, value, bounds): (BoundedQuantity, f64, Bounds),
    within: f64,
) -> impl Iterator<Item = NearLimit> {
    let Bounds { min, max } = bounds;
    [(min, value - min), (max, max - value)]
        .into_iter()
        .filter_map(move |(bound, room)| {
            Some(NearLimit {
                quantity,
                bound,
                closeness: closeness(room, within)?,
            })
        })
}

/// Returns the closeness from 0 to 1 in hundredths, to keep a state short; `None` if not close.
fn closeness(room: f64, within: f64) -> Option<f64> {
    let closeness = ((1.0 - room / within).min(1.0) * 100.0).round() / 100.0;
    (closeness > 0.0).then_some(closeness)
}

/// Returns the distance from a point to a keep-out; 0 inside.
fn distance_mm(keep_out: &KeepOut, [x, y, z]: [f64; 3]) -> f64 {
    match keep_out {
        KeepOut::Box(area) => {
            let level = outside(x, area.x_mm).hypot(outside(y, area.y_mm));
            level.hypot(outside(z, area.z_mm))
        }
        KeepOut::Cylinder(cylinder) => {
            let level =
                ((x - cylinder.x_mm).hypot(y - cylinder.y_mm) - cylinder.radius_mm).max(0.0);
            level.hypot(outside(z, cylinder.z_mm))
        }
    }
}

/// Returns how far a value is outside its bounds.
fn outside(value: f64, Bounds { min, max }: Bounds) -> f64 {
    (min - value).max(value - max).max(0.0)
}

/// The distance at which a length limit or a keep-out is close.
const NEAR_MM: f64 = 20.0;
/// The distance at which an angle limit is close.
const NEAR_DEG: f64 = 5.0;

#[cfg(test)]
mod tests {
    use dobot_arm::{Degrees, Pose, Position};
    use dobot_safety::{Area, Cylinder};

    use super::*;

    const CUP: Tool = Tool::SuctionCup;

    fn at(x_mm: f64, y_mm: f64, z_mm: f64, servo_deg: f64) -> ArmPlace {
        let pose = Pose {
            position: Position::new(x_mm, y_mm, z_mm),
            ..Pose::default()
        };
        let place = ArmPlace::at_pose(pose, CUP).expect("it is within reach");
        let joints = Joints {
            servo: Degrees(servo_deg),
            ..place.joints
        };
        ArmPlace { joints, ..place }
    }

    fn limits(place: &ArmPlace) -> Vec<(BoundedQuantity, f64)> {
        let near = near(&Policy::default(), place, CUP);
        near.limits
            .iter()
            .map(|limit| (limit.quantity, limit.bound))
            .collect()
    }

    #[test]
    fn in_the_middle_of_its_room_the_arm_is_near_no_limit() {
        assert_eq!(limits(&at(220.0, 0.0, 0.0, 0.0)), []);
        assert!(near(&Policy::default(), &at(220.0, 0.0, 0.0, 0.0), CUP).is_empty());
    }

    #[test]
    fn the_height_and_the_reach_are_near_from_20_mm_on() {
        let highest = (BoundedQuantity::Z, 136.0);
        assert!(!limits(&at(200.0, 0.0, 115.9, 0.0)).contains(&highest));
        assert!(limits(&at(200.0, 0.0, 116.5, 0.0)).contains(&highest));
        let nearest = (BoundedQuantity::Reach, 129.0);
        assert!(limits(&at(0.0, -148.0, 20.0, 0.0)).contains(&nearest));
    }

    #[test]
    fn a_joint_is_near_its_limit_from_5_degrees_on_and_the_closer_the_more() {
        for (servo_deg, closeness) in [(86.0, 0.2), (89.0, 0.8), (95.0, 1.0)] {
            let near = near(&Policy::default(), &at(220.0, 0.0, 0.0, servo_deg), CUP);
            let expected = NearLimit {
                quantity: BoundedQuantity::Servo,
                bound: 90.0,
                closeness,
            };
            assert_eq!(near.limits, [expected]);
        }
    }

    #[test]
    fn a_keep_out_is_near_from_20_mm_on_in_every_direction() {
        let side = Bounds::new(0.0, 10.0);
        let cube = KeepOut::Box(Area {
            x_mm: side,
            y_mm: side,
            z_mm: side,
        });
        let cylinder = KeepOut::Cylinder(Cylinder {
            x_mm: 100.0,
            y_mm: 0.0,
            radius_mm: 10.0,
            z_mm: Bounds::new(0.0, 50.0),
        });
        for (keep_out, point, expected) in [
            (cube, [5.0, 5.0, 5.0], Some(1.0)),
            (cube, [20.0, 5.0, 5.0], Some(0.5)),
            (cube, [5.0, 5.0, 40.0], None),
            (cube, [16.0, 18.0, 5.0], Some(0.5)),
            (cylinder, [100.0, 25.0, 20.0], Some(0.25)),
        ] {
            let found = closeness(distance_mm(&keep_out, point), NEAR_MM);
            assert_eq!(found, expected, "{keep_out:?} and {point:?}");
        }
    }

    #[test]
    fn a_keep_out_is_near_to_the_wrist_and_to_the_tip() {
        let level = Bounds::new(210.0, 230.0);
        let mut policy = Policy::default();
        for (name, z_mm) in [
            ("low", Bounds::new(-90.0, -50.0)),
            ("far", Bounds::new(60.0, 90.0)),
        ] {
            let area = Area {
                x_mm: level,
                y_mm: Bounds::new(-10.0, 10.0),
                z_mm,
            };
            policy.keep_out.insert(name.into(), KeepOut::Box(area));
        }
        // The tip is 40 mm below the wrist.
        let near = near(&policy, &at(220.0, 0.0, 0.0, 0.0), CUP);
        assert_eq!(near.keep_outs, [("low".to_owned(), 0.5)].into());
    }
}
