//! The stock controller's kinematics against what its own program was recorded to calculate.

#![expect(
    clippy::excessive_precision,
    reason = "nine digits, as they were recorded"
)]

use std::path::Path;

use dobot_arm::stock::{StockJoints, StockPose, forward, inverse, sensed};
use proptest::prelude::*;

#[test]
fn every_recorded_pose_follows_from_its_angles_to_the_last_digit() {
    let statuses = statuses();
    assert!(statuses.len() > 3600, "only {} statuses", statuses.len());
    for (name, joints, pose) in statuses {
        let found = TOOLS_MM.map(|tool_mm| forward(joints, tool_mm));
        assert!(
            found.contains(&pose),
            "{name}: {joints:?} gives {found:?}, expected {pose:?}"
        );
    }
}

/// Where moves to these places ended.
#[test]
fn recorded_angles_follow_from_their_places_to_the_last_digit() {
    for (place_mm, [base_deg, rear_deg, fore_deg]) in [
        ([220.0, 0.0, 0.0], [0.0, 26.438_522_3, 49.069_461_8]),
        (
            [220.0, 50.0, 30.0],
            [12.804_266, 18.942_886_4, 37.629_623_4],
        ),
        (
            [200.0, 100.0, 20.0],
            [26.565_052, 21.114_250_2, 41.460_529_3],
        ),
        (
            [200.0, -120.0, 60.0],
            [-30.963_756_6, 14.824_363_7, 26.146_350_9],
        ),
        (
            [260.0, 80.0, -20.0],
            [17.102_729_8, 48.235_122_7, 43.393_184_7],
        ),
        ([215.0, 0.0, 100.0], [0.0, 1.610_061_65, 12.616_065]),
    ] {
        let [x_mm, y_mm, z_mm] = place_mm;
        let pose = StockPose {
            x_mm,
            y_mm,
            z_mm,
            rotation_deg: 0.0,
        };
        let expected = StockJoints {
            base_deg,
            rear_deg,
            fore_deg,
            servo_deg: -base_deg,
        };
        assert_eq!(inverse(pose, TOOLS_MM[0]), expected, "{place_mm:?}");
    }
}

/// As a jump to base 25, rear 35, fore 50 ended: it calculates the place first.
#[test]
fn angles_are_not_exactly_recovered_from_their_place() {
    let joints = StockJoints {
        base_deg: 25.0,
        rear_deg: 35.0,
        fore_deg: 50.0,
        servo_deg: 20.0,
    };
    let found = inverse(forward(joints, TOOLS_MM[0]), TOOLS_MM[0]);
    assert_eq!(
        [found.base_deg, found.rear_deg, found.fore_deg],
        [25.000_003_8, 34.999_996_2, 50.000_007_6]
    );
}

/// The pose that the arm assumed after it was powered up at these angles.
#[test]
fn sensors_report_angles_in_steps() {
    assert_eq!(sensed(45.0), 45.0);
    assert_eq!(sensed(30.0), 29.999_927_5);
    assert_eq!(90.0 - sensed(60.0), 29.999_935_2);
    assert_eq!(90.0 - sensed(30.0), 60.000_072_5);
}

proptest! {
    #[test]
    fn every_float_is_handled(bits: [u32; 4]) {
        let [x_mm, y_mm, z_mm, rotation_deg] = bits.map(f32::from_bits);
        let pose = StockPose { x_mm, y_mm, z_mm, rotation_deg };
        let joints = inverse(pose, TOOLS_MM[0]);
        if [x_mm, y_mm, z_mm].iter().any(|number| number.is_nan()) {
            prop_assert!(joints.rear_deg.is_nan() && joints.fore_deg.is_nan());
        }
        let again = forward(joints, TOOLS_MM[0]);
        prop_assert!(again.x_mm.is_nan() || again.x_mm.abs() < 351.0);
    }
}

/// The angles and the pose of every recorded status, but for those that hide something: before the
/// first pose is calculated, with a thousand added over Bluetooth, or lost.
fn statuses() -> Vec<(String, StockJoints, StockPose)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../vectors/traces");
    let mut statuses = Vec::new();
    for file in std::fs::read_dir(folder).expect("the recordings are there") {
        let script = file.expect("a file").path();
        if script
            .extension()
            .is_none_or(|extension| extension != "script")
        {
            continue;
        }
        let path = script.with_extension("csv");
        let name = path.display().to_string();
        let text = std::fs::read_to_string(&path).expect("a recording for each script");
        for row in text.lines().skip(1) {
            let floats: Vec<f32> = row
                .split(',')
                .map(|field| field.parse().expect("a number"))
                .collect();
            let &[
                t_ms,
                x_mm,
                y_mm,
                z_mm,
                rotation_deg,
                base_deg,
                rear_deg,
                fore_deg,
                servo_deg,
                ..,
            ] = floats.as_slice()
            else {
                panic!("{name}: {row}");
            };
            if x_mm.abs() < 900.0 {
                let joints = StockJoints {
                    base_deg,
                    rear_deg,
                    fore_deg,
                    servo_deg,
                };
                let pose = StockPose {
                    x_mm,
                    y_mm,
                    z_mm,
                    rotation_deg,
                };
                statuses.push((format!("{name} at {t_ms} ms"), joints, pose));
            }
        }
    }
    statuses
}

/// From the wrist to the suction cup and to the laser.
const TOOLS_MM: [f32; 2] = [55.07, 49.57];
