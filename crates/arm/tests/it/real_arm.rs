//! The stock controller's kinematics against thirty poses of a real arm.

use dobot_arm::{Joints, Limits, Tool, agrees, forward, stock};

#[test]
fn every_pose_of_the_real_arm_agrees_with_the_stock_forward_kinematics() {
    for row in rows() {
        let pose = stock::forward(row.stretched_joints(), TOOL_MM);
        for (got, expected) in [pose.x_mm, pose.y_mm, pose.z_mm]
            .into_iter()
            .zip(row.position_mm)
        {
            let off_mm = (f64::from(got) - expected).abs();
            let allowed_mm = row.tolerance_mm();
            assert!(
                off_mm <= allowed_mm,
                "row {}: {got}, expected {expected} to {allowed_mm}",
                row.n
            );
        }
    }
}

#[test]
fn the_stock_inverse_gives_the_angles_that_the_real_arm_was_sent_to() {
    for row in rows() {
        let [x_mm, y_mm, z_mm] = row.position_mm.map(narrow);
        let rotation_deg = narrow(row.joints_deg[0]);
        let got = stock::inverse(
            stock::StockPose {
                x_mm,
                y_mm,
                z_mm,
                rotation_deg,
            },
            TOOL_MM,
        );
        let stretched = row.stretched_joints();
        for (got, expected) in [
            (got.base_deg, stretched.base_deg),
            (got.rear_deg, stretched.rear_deg),
            (got.fore_deg, stretched.fore_deg),
        ] {
            // A position to 5 decimals in single precision determines an angle to about 1e-4 degrees.
            let off_deg = (got - expected).abs();
            assert!(
                off_deg <= 2e-4,
                "row {}: {got}, expected {expected} to 0.0002",
                row.n
            );
        }
    }
}

#[test]
fn planning_kinematics_differ_from_the_real_arm_by_no_more_than_its_four_digits_of_pi() {
    for row in rows() {
        let [base, rear, fore] = row.joints_deg;
        let position = forward(&Joints::new(base, rear, fore, 0.0), Tool::SuctionCup).position;
        let [x, y, z] = row.position_mm;
        let off_mm = position.distance(dobot_arm::Position::new(x, y, z)).0;
        // 3.1416 is 2.3e-6 of pi too large: at 49 + 35 + 35 degrees and 320 mm below 0.002 mm.
        assert!(off_mm < 0.002, "row {}: {off_mm} mm off", row.n);
    }
}

#[test]
fn every_pose_of_the_real_arm_agrees_with_its_angles_and_lies_within_the_stock_limits() {
    for row in rows() {
        let [base, rear, fore] = row.joints_deg;
        assert!(
            agrees(row.position_mm, base, [base, rear, fore, 0.0]),
            "row {}",
            row.n
        );
        let joints = Joints::new(base, rear, fore, 0.0);
        assert_eq!(
            Limits::STOCK.check(&joints, Tool::SuctionCup),
            Ok(()),
            "row {}",
            row.n
        );
    }
}

struct Row {
    n: usize,
    joints_deg: [f64; 3],
    position_mm: [f64; 3],
    as_sent: bool,
}

impl Row {
    fn parse(line: &str) -> Self {
        let fields: Vec<&str> = line.split(',').collect();
        let number = |n: usize| fields[n].parse().expect("the file holds numbers");
        Self {
            n: fields[0].parse().expect("the file numbers its rows"),
            joints_deg: [number(1), number(2), number(3)],
            position_mm: [number(4), number(5), number(6)],
            as_sent: fields[7] == "yes",
        }
    }

    /// That arm calculated with 3.1416 for pi, which makes all angles a little larger; that of the
    /// rear arm counts from level.
    fn stretched_joints(&self) -> stock::StockJoints {
        let [base, rear, fore] = self.joints_deg;
        let stretched = |angle: f64| angle * (PI_OF_THAT_ARM / std::f64::consts::PI);
        stock::StockJoints {
            base_deg: narrow(stretched(base)),
            rear_deg: narrow(90.0 - stretched(90.0 - rear)),
            fore_deg: narrow(stretched(fore)),
            servo_deg: 0.0,
        }
    }

    /// Angles that were sent are exact. Those at which the arm was stopped are known to half of
    /// their fourth decimal: 5e-5 degrees in each of three joints, 290 mm, 135 mm and 160 mm from
    /// their axes, are 5.1e-4 mm together.
    const fn tolerance_mm(&self) -> f64 {
        if self.as_sent { 1e-4 } else { 5.1e-4 }
    }
}

fn rows() -> Vec<Row> {
    let rows: Vec<Row> = include_str!("../data/real-arm-poses.csv")
        .lines()
        .filter(|line| line.starts_with(|first: char| first.is_ascii_digit()))
        .map(Row::parse)
        .collect();
    assert_eq!(rows.len(), 30);
    rows
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "the stock controller's precision is the point"
)]
fn narrow(value: f64) -> f32 {
    value as f32
}

const TOOL_MM: f32 = 55.07;

#[expect(clippy::approx_constant, reason = "it is not quite pi")]
const PI_OF_THAT_ARM: f64 = 3.1416;
