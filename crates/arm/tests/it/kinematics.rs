//! Forward and inverse kinematics, limits and agreement, over the whole workspace.

use dobot_arm::{
    Degrees, Joints, Limits, Millimeters, Pose, Position, Quantity, Span, Tool, Unreachable,
    agrees, forward, inverse,
};
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn inverse_undoes_forward_over_the_whole_workspace((joints, tool) in workspace()) {
        let pose = forward(&joints, tool);
        let again = inverse(&pose, tool).expect("the workspace is within reach");
        for (got, expected) in again.angles_deg().into_iter().zip(joints.angles_deg()) {
            // 1e-9 mm at the farthest reach of 321 mm is 1.8e-10 degrees.
            prop_assert!((got - expected).abs() < 1.7e-10, "got {got}, expected {expected}");
        }
    }

    #[test]
    fn forward_undoes_inverse_within_a_billionth_of_a_millimetre((joints, tool) in workspace()) {
        let pose = forward(&joints, tool);
        let again = forward(&inverse(&pose, tool).expect("the workspace is within reach"), tool);
        let off_mm = again.position.distance(pose.position).0;
        prop_assert!(off_mm < 1e-9, "{off_mm} mm off");
        prop_assert!((again.rotation - pose.rotation).abs().0 < 1e-9);
    }

    #[test]
    fn the_inverse_of_any_place_in_geometric_reach_reaches_it(
        base in -180.0..180.0, elevation in -90.0_f64..90.0, distance in 25.0..295.0,
        tool in tools(),
    ) {
        let (sin, cos) = elevation.to_radians().sin_cos();
        let reach = Millimeters(distance * cos) + tool.reach();
        let position = Position::polar(reach, Degrees(base), Millimeters(distance * sin));
        let pose = Pose { position, rotation: Degrees(7.0) };
        let again = forward(&inverse(&pose, tool).expect("the two links bridge 25 to 295 mm"), tool);
        let off_mm = again.position.distance(position).0;
        // Arc cosines lose digits where the arm is stretched or folded: 1e-16 of a cosine near 1
        // is 1e-8 of an angle, but that hardly changes the distance.
        prop_assert!(off_mm < 1e-6, "{off_mm} mm off");
    }

    #[test]
    fn checking_angles_with_and_without_their_place_gives_the_same_result(
        (joints, tool) in any_joints(),
    ) {
        let position = forward(&joints, tool).position;
        let [alone, with_place] = [
            Limits::STOCK.check(&joints, tool),
            Limits::STOCK.check_at(&joints, position),
        ];
        prop_assert_eq!(alone.is_ok(), with_place.is_ok());
    }

    #[test]
    fn any_pose_that_passes_the_check_is_within_every_limit((joints, tool) in any_joints()) {
        let pose = forward(&joints, tool);
        let [reach, z] = [pose.position.x.0.hypot(pose.position.y.0), pose.position.z.0];
        let opening = joints.rear.0 - joints.fore.0;
        let within = joints.rear.0 <= 85.0 && joints.fore.0 <= 95.0 && joints.rear.0 >= -5.0
            && joints.fore.0 >= -10.0 && joints.base.0.abs() <= 180.0
            && joints.servo.0.abs() <= 90.0 && opening <= 35.0
            && (129.0..=321.0).contains(&reach) && z <= 136.0;
        prop_assert_eq!(Limits::STOCK.check(&joints, tool).is_ok(), within);
    }

    #[test]
    fn an_error_gives_a_range_that_excludes_the_found_value((joints, tool) in any_joints()) {
        if let Err(Unreachable::OutOfRange { found, min, max, .. }) = Limits::STOCK.check(&joints, tool) {
            prop_assert!(found < min || found > max);
        }
    }

    #[test]
    fn a_status_of_one_pose_agrees_and_one_with_a_changed_number_does_not(
        (joints, tool) in workspace(), which in 0_usize..8, by in prop_oneof![-90.0..-0.05, 0.05..90.0],
    ) {
        let Pose { position, rotation } = forward(&joints, tool);
        let mut reported = [position.x.0, position.y.0, position.z.0, rotation.0, 0.0, 0.0, 0.0, 0.0];
        reported[4..].copy_from_slice(&joints.angles_deg());
        let judge = |reported: [f64; 8]| {
            agrees([reported[0], reported[1], reported[2]], reported[3], [reported[4], reported[5], reported[6], reported[7]])
        };
        prop_assert!(judge(reported));
        reported[which] += by;
        // 0.05 degrees move a tool that is 129 mm away by 0.11 mm, a link of 135 mm by 0.12 mm.
        prop_assert!(!judge(reported));
    }
}

#[test]
fn straight_up_and_level_is_a_right_angle_at_the_elbow() {
    let pose = forward(&Joints::new(0.0, 0.0, 0.0, 0.0), Tool::SuctionCup);
    assert_near(pose.position, Position::new(160.0 + 55.07, 0.0, 135.0));
}

#[test]
fn rear_arm_level_and_forearm_down_hangs_the_wrist_below_the_elbow() {
    let pose = forward(&Joints::new(90.0, 90.0, 90.0, -90.0), Tool::Laser);
    assert_near(pose.position, Position::new(0.0, 135.0 + 49.57, -160.0));
    assert_eq!(pose.rotation, Degrees(0.0));
}

#[test]
fn a_right_angle_at_the_elbow_is_found_back() {
    let pose = Pose {
        position: Position::new(0.0, -(160.0 + 49.57), 135.0),
        rotation: Degrees(-60.0),
    };
    let joints = inverse(&pose, Tool::Laser).expect("it is within reach");
    for (got, expected) in joints.angles_deg().into_iter().zip([-90.0, 0.0, 0.0, 30.0]) {
        assert!(
            (got - expected).abs() < 1e-12,
            "got {got}, expected {expected}"
        );
    }
}

#[test]
fn fully_stretched_and_fully_folded_are_the_ends_of_geometric_reach() {
    for distance in [295.0, 25.0] {
        let position = Position::new(distance + 55.07, 0.0, 0.0);
        let joints = inverse(
            &Pose {
                position,
                ..Pose::default()
            },
            Tool::SuctionCup,
        );
        assert_near(
            forward(&joints.expect("it is just in reach"), Tool::SuctionCup).position,
            position,
        );
    }
}

#[test]
fn too_far_reports_the_excess_and_the_limit() {
    let pose = Pose {
        position: Position::new(367.57, 0.0, 0.0),
        ..Pose::default()
    };
    let error =
        inverse(&pose, Tool::SuctionCup).expect_err("links of 135 and 160 mm end at 295 mm");
    assert_eq!(
        error.to_string(),
        "distance from pivot to wrist is 312.5 mm; the arm allows 25 to 295 mm: 17.5 mm too far"
    );
    assert!((error.excess() - 17.5).abs() < 1e-9);
}

#[test]
fn too_near_reports_the_excess_and_the_limit() {
    let pose = Pose {
        position: Position::new(65.07, 0.0, 0.0),
        ..Pose::default()
    };
    let error = inverse(&pose, Tool::Gripper).expect_err("links of 135 and 160 mm fold to 25 mm");
    assert_eq!(
        error.to_string(),
        "distance from pivot to wrist is 10 mm; the arm allows 25 to 295 mm: 15 mm too near"
    );
}

#[test]
fn beyond_the_reach_of_the_workspace_names_reach() {
    let pose = Pose {
        position: Position::new(345.2, 0.0, 0.0),
        ..Pose::default()
    };
    let limits = Limits {
        opening: Span::degrees(-180.0, 180.0),
        ..Limits::STOCK
    };
    let error = limits
        .solve(&pose, Tool::SuctionCup)
        .expect_err("345.2 is more than 321");
    assert_eq!(
        error.to_string(),
        "reach is 345.2 mm; the arm allows 129 to 321 mm: 24.2 mm too far"
    );
}

#[test]
fn each_joint_limit_is_named_with_the_found_value_and_the_excess() {
    let cases = [
        (
            Joints::new(180.5, 30.0, 30.0, 0.0),
            "base angle is 180.5°; the arm allows -180 to 180°: 0.5° too much",
        ),
        (
            Joints::new(0.0, -6.0, 30.0, 0.0),
            "rear arm angle is -6°; the arm allows -5 to 85°: 1° too little",
        ),
        (
            Joints::new(0.0, 30.0, 97.25, 0.0),
            "forearm angle is 97.25°; the arm allows -10 to 95°: 2.25° too much",
        ),
        (
            Joints::new(0.0, 30.0, 30.0, -93.0),
            "servo angle is -93°; the arm allows -90 to 90°: 3° too little",
        ),
        (
            Joints::new(0.0, 60.0, 20.0, 0.0),
            "rear arm minus forearm angle is 40°; the arm allows at most 35°: 5° too much",
        ),
    ];
    for (joints, expected) in cases {
        let error = Limits::STOCK
            .check(&joints, Tool::SuctionCup)
            .expect_err(expected);
        assert_eq!(error.to_string(), expected);
    }
}

#[test]
fn too_high_is_named_with_the_height() {
    // 135 cos 0 + 160 sin 10 = 162.7837.
    let error = Limits::STOCK
        .check(&Joints::new(0.0, 0.0, -10.0, 0.0), Tool::SuctionCup)
        .expect_err("162.8 is more than 136");
    assert_eq!(
        error.to_string(),
        "z is 162.7837 mm; the arm allows at most 136 mm: 26.7837 mm too high"
    );
}

#[test]
fn every_bound_itself_is_allowed() {
    for (base, servo) in [(-180.0, 90.0), (180.0, -90.0)] {
        let joints = Joints::new(base, 35.0, 0.0, servo);
        assert_eq!(Limits::STOCK.check(&joints, Tool::SuctionCup), Ok(()));
    }
}

#[test]
fn a_number_that_is_not_finite_never_passes_in_any_position() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for n in 0..4 {
            let place = |m: usize, good: f64| if m == n { bad } else { good };
            let pose = Pose {
                position: Position::new(place(0, 200.0), place(1, 10.0), place(2, 20.0)),
                rotation: Degrees(place(3, 0.0)),
            };
            let error = inverse(&pose, Tool::Laser).expect_err("not finite");
            let quantity = [Quantity::X, Quantity::Y, Quantity::Z, Quantity::Rotation][n];
            assert!(
                matches!(error, Unreachable::NotFinite { quantity: named, .. } if named == quantity)
            );

            let joints = Joints::new(place(0, 0.0), place(1, 20.0), place(2, 30.0), place(3, 0.0));
            assert!(Limits::STOCK.check(&joints, Tool::Laser).is_err());
            assert!(
                Limits::STOCK
                    .check_at(&joints, Position::new(200.0, 0.0, 20.0))
                    .is_err()
            );
        }
        let joints = Joints::new(0.0, 20.0, 30.0, 0.0);
        assert!(
            Limits::STOCK
                .check_at(&joints, Position::new(bad, 0.0, 20.0))
                .is_err()
        );
        assert!(
            Limits::STOCK
                .check_at(&joints, Position::new(200.0, 0.0, bad))
                .is_err()
        );
    }
}

#[test]
fn a_status_that_is_not_finite_does_not_agree() {
    for bad in [f64::NAN, f64::INFINITY] {
        assert!(!agrees([bad; 3], bad, [bad; 4]));
        assert!(!agrees([215.07, 0.0, 135.0], bad, [0.0; 4]));
    }
    assert!(agrees([215.07, 0.0, 135.0], 0.0, [0.0; 4]));
}

/// Joint angles over the whole region of the joint limits and a little beyond.
fn any_joints() -> impl Strategy<Value = (Joints, Tool)> {
    (-190.0..190.0, -8.0..88.0, -13.0..98.0, -95.0..95.0, tools())
        .prop_map(|(base, rear, fore, servo, tool)| (Joints::new(base, rear, fore, servo), tool))
}

/// Joint angles that the stock limits allow.
fn workspace() -> impl Strategy<Value = (Joints, Tool)> {
    (-180.0..180.0, -5.0..85.0, -10.0..95.0, -90.0..90.0, tools())
        .prop_map(|(base, rear, fore, servo, tool)| (Joints::new(base, rear, fore, servo), tool))
        .prop_filter("inside the limits", |(joints, tool)| {
            Limits::STOCK.check(joints, *tool).is_ok()
        })
}

fn tools() -> impl Strategy<Value = Tool> {
    prop_oneof![
        Just(Tool::SuctionCup),
        Just(Tool::Gripper),
        Just(Tool::Laser)
    ]
}

fn assert_near(got: Position, expected: Position) {
    let off = got.distance(expected);
    assert!(
        off.0 < 1e-6,
        "got {got:?}, expected {expected:?} to 1e-6 mm, {off} off"
    );
}
