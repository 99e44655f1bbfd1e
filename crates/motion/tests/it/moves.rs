//! Tests of motions: exact ends, shapes, and limits on sampled speeds and accelerations.

use dobot_arm::{Degrees, Joints, Millimeters, Pose, Position, Tool, forward};
use dobot_motion::{JointMove, Jump, LineMove, PlanError, Speeds, Stroke, StrokeSpeeds};
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn joints_start_and_stop_together_and_exactly(
        from in joints(), to in joints(), speeds in speeds(),
    ) {
        let movement = JointMove::new(from, to, &speeds).expect("all numbers are in range");
        let duration_s = movement.duration_s();
        prop_assert_eq!(movement.joints_at(duration_s), to);
        prop_assert_eq!(movement.joints_at(-1.0), from);
        let [start, way] = [from.angles_deg(), between(from, to).angles_deg()];
        for t_s in samples(duration_s) {
            let gone = between(from, movement.joints_at(t_s)).angles_deg();
            // All joints cover the same share: each cross product of two of them is zero.
            for n in 1..4 {
                prop_assert!((gone[n] * way[0] - gone[0] * way[n]).abs() < 1e-9, "{start:?}");
            }
        }
    }

    #[test]
    fn joints_stay_within_their_speeds_and_accelerations(
        from in joints(), to in joints(), speeds in speeds(),
    ) {
        let movement = JointMove::new(from, to, &speeds).expect("all numbers are in range");
        for n in 0..4 {
            let (speed, acceleration) = if n < 3 {
                (speeds.joint_deg_s, speeds.joint_deg_s2)
            } else {
                (speeds.servo_deg_s, speeds.servo_deg_s2)
            };
            let angle = |t_s| [movement.joints_at(t_s).angles_deg()[n], 0.0, 0.0];
            stays_within(angle, movement.duration_s(), speed, acceleration)?;
        }
    }

    #[test]
    fn the_slowest_joint_sets_the_duration(from in joints(), to in joints(), speeds in speeds()) {
        let movement = JointMove::new(from, to, &speeds).expect("all numbers are in range");
        let [base, rear, fore, servo] = between(from, to).angles_deg().map(f64::abs);
        let alone_s = [base, rear, fore]
            .map(|way| fastest_s(way, speeds.joint_deg_s, speeds.joint_deg_s2))
            .into_iter()
            .fold(fastest_s(servo, speeds.servo_deg_s, speeds.servo_deg_s2), f64::max);
        // The move may take longer than the slowest joint if one joint limits the speed and another
        // the acceleration, but never longer than the ramps of the one plus the cruise of the
        // other.
        prop_assert!(movement.duration_s() >= alone_s - 1e-9);
        prop_assert!(movement.duration_s() <= 2.0 * alone_s + 1e-9);
    }

    #[test]
    fn a_line_is_straight_within_a_millionth_of_a_millimetre_and_ends_exactly(
        from in poses(), to in poses(), speeds in speeds(),
    ) {
        let line = LineMove::new(from, to, &speeds).expect("all numbers are in range");
        prop_assert_eq!(line.pose_at(line.duration_s()), to);
        prop_assert_eq!(line.pose_at(-1.0), from);
        let length = from.position.distance(to.position).0;
        for t_s in samples(line.duration_s()) {
            let Pose { position, rotation } = line.pose_at(t_s);
            let share = from.position.distance(position).0 / length;
            let on_line = from.position + (to.position - from.position) * share;
            prop_assert!(position.distance(on_line).0 < 1e-6);
            let even = from.rotation.0 + (to.rotation.0 - from.rotation.0) * share;
            prop_assert!((rotation.0 - even).abs() < 1e-6);
        }
    }

    #[test]
    fn a_line_stays_within_its_speed_and_acceleration_and_the_servos(
        from in poses(), to in poses(), speeds in speeds(),
    ) {
        let line = LineMove::new(from, to, &speeds).expect("all numbers are in range");
        let place = |t_s| coordinates(line.pose_at(t_s).position);
        stays_within(place, line.duration_s(), speeds.line_mm_s, speeds.line_mm_s2)?;
        let turn = |t_s| [line.pose_at(t_s).rotation.0, 0.0, 0.0];
        stays_within(turn, line.duration_s(), speeds.servo_deg_s, speeds.servo_deg_s2)?;
    }

    #[test]
    fn a_jump_goes_up_then_across_then_down(
        from in poses(), to in poses(), height in 0.0..60.0, speeds in speeds(),
    ) {
        let jump = Jump::new(from, to, Millimeters(height), &speeds).expect("all in range");
        prop_assert_eq!(jump.pose_at(jump.duration_s()), to);
        prop_assert_eq!(jump.pose_at(-1.0), from);
        let top = from.position.z.0.max(to.position.z.0) + height;
        let ends = [from.position.reach().0, to.position.reach().0];
        let [near, far] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        let mut phase = 0;
        for t_s in samples(jump.duration_s()) {
            let Pose { position, rotation } = jump.pose_at(t_s);
            let over = |end: Pose| {
                let above = Position { z: position.z, ..end.position };
                position.distance(above).0 < 1e-9 && (rotation - end.rotation).abs().0 < 1e-9
            };
            let at_top = (position.z.0 - top).abs() < 1e-9;
            phase = match phase {
                0 if over(from) => 0,
                0 | 1 if at_top => 1,
                _ => 2,
            };
            prop_assert!(phase < 2 || over(to), "{position:?} at {t_s} s, {jump:?}");
            prop_assert!(position.z.0 <= top + 1e-9);
            let reach = position.reach().0;
            prop_assert!(reach >= near - 1e-9 && reach <= far + 1e-9, "reach {reach}");
        }
    }

    #[test]
    fn a_jump_stays_within_the_lines_speed_and_acceleration_and_the_servos(
        from in poses(), to in poses(), height in 0.0..60.0, speeds in speeds(),
    ) {
        let jump = Jump::new(from, to, Millimeters(height), &speeds).expect("all in range");
        let place = |t_s| coordinates(jump.pose_at(t_s).position);
        stays_within(place, jump.duration_s(), speeds.line_mm_s, speeds.line_mm_s2)?;
        let servo = |t_s| {
            let Pose { position, rotation } = jump.pose_at(t_s);
            [rotation.0 - position.direction().0, 0.0, 0.0]
        };
        stays_within(servo, jump.duration_s(), speeds.servo_deg_s, speeds.servo_deg_s2)?;
    }

    #[test]
    fn reach_and_base_angle_of_a_jump_change_evenly(
        from in poses(), to in poses(), speeds in speeds(),
    ) {
        let [from, to] = [from, to].map(|pose| at_height(pose, 50.0));
        let jump = Jump::new(from, to, Millimeters(0.0), &speeds).expect("all in range");
        let polar = |pose: Pose| [pose.position.reach().0, pose.position.direction().0];
        let [start, end] = [polar(from), polar(to)];
        for t_s in samples(jump.duration_s()) {
            let here = polar(jump.pose_at(t_s));
            let gone = [here[0] - start[0], here[1] - start[1]];
            let cross = gone[0] * (end[1] - start[1]) - gone[1] * (end[0] - start[0]);
            prop_assert!(cross.abs() < 1e-8, "{gone:?} of {start:?} to {end:?}");
        }
    }

    #[test]
    fn a_stroke_stays_within_its_speeds_and_ends_exactly(
        from in poses(), vector in (-60.0..60.0, -60.0..60.0, -60.0..60.0),
        shares in (0.0..=1.0, 0.0..=1.0), max_mm_s in 1.0..200.0, acceleration in 10.0..1000.0,
    ) {
        let (from, vector) = (from.position, Position::new(vector.0, vector.1, vector.2));
        let speeds = StrokeSpeeds {
            start_mm_s: shares.0 * max_mm_s,
            end_mm_s: shares.1 * max_mm_s,
            max_mm_s,
            acceleration_mm_s2: acceleration,
        };
        let stroke = Stroke::new(from, vector, &speeds).expect("all numbers are in range");
        prop_assert_eq!(stroke.position_at(stroke.duration_s()), from + vector);
        prop_assert_eq!(stroke.target(), from + vector);
        prop_assert_eq!(stroke.position_at(-1.0), from);
        prop_assert!(stroke.start_speed() <= speeds.start_mm_s);
        prop_assert!(stroke.end_speed() <= speeds.end_mm_s);
        let place = |t_s| coordinates(stroke.position_at(t_s));
        let step_s = stroke.duration_s() / f64::from(STEPS);
        for t_s in samples(stroke.duration_s()).skip(1) {
            let gone = length(difference(place(t_s), place(t_s - step_s)));
            prop_assert!(gone <= max_mm_s * step_s + 1e-9);
        }
    }
}

#[test]
fn what_has_no_way_to_go_takes_no_time() {
    let (joints, pose) = (Joints::new(10.0, 20.0, 30.0, 40.0), at_height(POSE, 10.0));
    let speeds = Speeds::STOCK;
    let movement = JointMove::new(joints, joints, &speeds).expect("all numbers are in range");
    assert_eq!(
        (movement.duration_s(), movement.joints_at(0.0)),
        (0.0, joints)
    );
    let line = LineMove::new(pose, pose, &speeds).expect("all numbers are in range");
    assert_eq!((line.duration_s(), line.pose_at(0.0)), (0.0, pose));
    let jump = Jump::new(pose, pose, Millimeters(0.0), &speeds).expect("all numbers are in range");
    assert_eq!((jump.duration_s(), jump.pose_at(0.0)), (0.0, pose));
    let stroke = Stroke::new(pose.position, Position::default(), &STROKE).expect("all in range");
    assert_eq!(
        (stroke.duration_s(), stroke.position_at(0.0)),
        (0.0, pose.position)
    );
}

#[test]
fn turning_on_the_spot_takes_the_time_that_the_servo_needs() {
    let turned = Pose {
        rotation: Degrees(90.0),
        ..POSE
    };
    let expected_s = fastest_s(90.0, 200.0, 200.0);
    let line = LineMove::new(POSE, turned, &Speeds::STOCK).expect("all numbers are in range");
    assert!((line.duration_s() - expected_s).abs() < 1e-12);
    assert_eq!(line.pose_at(expected_s / 2.0).position, POSE.position);
    assert!((line.pose_at(expected_s / 2.0).rotation.0 - 45.0).abs() < 1e-9);
    let jump = Jump::new(POSE, turned, Millimeters(0.0), &Speeds::STOCK).expect("all in range");
    assert!((jump.duration_s() - expected_s).abs() < 1e-12);
}

#[test]
fn a_jump_of_known_size_takes_the_known_time() {
    // Up 30, straight out 100, down 20; each at 100 mm/s and 200 mm/s2 from rest to rest.
    let from = Pose {
        position: Position::new(150.0, 0.0, 0.0),
        ..POSE
    };
    let to = Pose {
        position: Position::new(250.0, 0.0, 10.0),
        ..POSE
    };
    let jump = Jump::new(from, to, Millimeters(20.0), &Speeds::STOCK).expect("all in range");
    let [up_s, across_s, down_s] = [30.0, 100.0, 20.0].map(|way| fastest_s(way, 100.0, 200.0));
    assert!((jump.duration_s() - (up_s + across_s + down_s)).abs() < 1e-12);
    let middle = jump.pose_at(up_s + across_s / 2.0).position;
    assert!(middle.distance(Position::new(200.0, 0.0, 30.0)).0 < 1e-9);
}

#[test]
fn a_jump_from_left_behind_to_right_behind_turns_through_the_front() {
    let at = |base| Pose {
        position: Position::polar(Millimeters(200.0), Degrees(base), Millimeters(0.0)),
        rotation: Degrees(0.0),
    };
    let jump = Jump::new(at(170.0), at(-170.0), Millimeters(10.0), &Speeds::STOCK)
        .expect("all numbers are in range");
    let half_way = jump.pose_at(jump.duration_s() / 2.0).position;
    assert!(
        half_way.distance(Position::new(200.0, 0.0, 10.0)).0 < 1e-9,
        "{half_way:?}"
    );
}

#[test]
fn a_joint_that_does_not_turn_stays_where_it_is() {
    let from = Joints::new(0.1, 20.3, 30.7, 0.9);
    let to = Joints {
        base: Degrees(77.7),
        ..from
    };
    let movement = JointMove::new(from, to, &Speeds::STOCK).expect("all numbers are in range");
    for t_s in samples(movement.duration_s()) {
        let Joints {
            rear, fore, servo, ..
        } = movement.joints_at(t_s);
        assert_eq!((rear, fore, servo), (from.rear, from.fore, from.servo));
    }
}

#[test]
fn bad_numbers_are_refused_by_name() {
    let lame = Speeds {
        servo_deg_s2: 0.0,
        ..Speeds::STOCK
    };
    let error = LineMove::new(POSE, at_height(POSE, 9.0), &lame).expect_err("no acceleration");
    assert_eq!(
        error.to_string(),
        "servo acceleration is 0; a motion needs more than 0 and at most 3.4e38"
    );
    let nowhere = at_height(POSE, f64::NAN);
    let error = LineMove::new(POSE, nowhere, &Speeds::STOCK).expect_err("NaN is nowhere");
    assert_eq!(
        error.to_string(),
        "length of the line is NaN; a motion needs a finite number"
    );
    let error = Jump::new(POSE, POSE, Millimeters(-1.0), &Speeds::STOCK).expect_err("below");
    assert_eq!(
        error.to_string(),
        "jump height is -1; a motion allows 0 to 3.4e38"
    );
    assert!(Jump::new(nowhere, POSE, Millimeters(1.0), &Speeds::STOCK).is_err());
    assert!(Jump::new(POSE, nowhere, Millimeters(1.0), &Speeds::STOCK).is_err());
    let twisted = Joints::new(0.0, 0.0, f64::INFINITY, 0.0);
    let error = JointMove::new(twisted, twisted, &Speeds::STOCK).expect_err("no angle");
    assert!(matches!(
        error,
        PlanError::NotFinite {
            name: "forearm angle's way",
            ..
        }
    ));
    let error = Stroke::new(nowhere.position, Position::new(1.0, 0.0, 0.0), &STROKE);
    assert!(matches!(error, Err(PlanError::NotFinite { .. })));
}

/// Samples the motion and checks that the mean speed over a step and its change are within the
/// limits.
fn stays_within(
    place: impl Fn(f64) -> [f64; 3],
    duration_s: f64,
    speed: f64,
    acceleration: f64,
) -> Result<(), TestCaseError> {
    let step_s = duration_s / f64::from(STEPS);
    for t_s in samples(duration_s) {
        let [before, here, after] = [t_s - step_s, t_s, t_s + step_s].map(&place);
        let [gone, next] = [difference(here, before), difference(after, here)];
        prop_assert!(
            length(gone) <= speed * step_s + ROUNDING,
            "too fast at {t_s} s"
        );
        let bend = length(difference(next, gone));
        let allowed = acceleration * step_s * step_s + ROUNDING;
        prop_assert!(
            bend <= allowed,
            "{bend} is more than {allowed} at {t_s} s of {duration_s} s"
        );
    }
    Ok(())
}

/// Returns the duration from rest to rest.
fn fastest_s(way: f64, speed: f64, acceleration: f64) -> f64 {
    if speed * speed < way * acceleration {
        way / speed + speed / acceleration
    } else {
        2.0 * (way / acceleration).sqrt()
    }
}

fn joints() -> impl Strategy<Value = Joints> {
    (-135.0..135.0, -5.0..85.0, -10.0..95.0, -90.0..90.0)
        .prop_map(|(base, rear, fore, servo)| Joints::new(base, rear, fore, servo))
}

fn poses() -> impl Strategy<Value = Pose> {
    joints().prop_map(|joints| forward(&joints, Tool::SuctionCup))
}

fn speeds() -> impl Strategy<Value = Speeds> {
    prop::array::uniform6(5.0..400.0).prop_map(Speeds::new)
}

fn samples(duration_s: f64) -> impl Iterator<Item = f64> {
    (0..=STEPS).map(move |n| duration_s * f64::from(n) / f64::from(STEPS))
}

fn at_height(pose: Pose, z_mm: f64) -> Pose {
    Pose {
        position: Position {
            z: Millimeters(z_mm),
            ..pose.position
        },
        ..pose
    }
}

fn between(from: Joints, to: Joints) -> Joints {
    let [a, b] = [from.angles_deg(), to.angles_deg()];
    Joints::new(b[0] - a[0], b[1] - a[1], b[2] - a[2], b[3] - a[3])
}

fn coordinates(position: Position) -> [f64; 3] {
    [position.x.0, position.y.0, position.z.0]
}

fn difference(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn length(a: [f64; 3]) -> f64 {
    a.iter().map(|a| a * a).sum::<f64>().sqrt()
}

const POSE: Pose = Pose {
    position: Position::new(200.0, 0.0, 0.0),
    rotation: Degrees(0.0),
};
const STROKE: StrokeSpeeds = StrokeSpeeds {
    start_mm_s: 0.0,
    end_mm_s: 0.0,
    max_mm_s: 50.0,
    acceleration_mm_s2: 100.0,
};
const STEPS: u32 = 97;

/// The rounding of a coordinate of some hundred millimetres or degrees.
const ROUNDING: f64 = 1e-11;
