//! The shapes of the parts of the arm, of boxes and cylinders, as on the page
//! (`page/files/stage/arm.js`).
//!
//! The frame of a part is at the joint that carries it. At 0 degrees the rear arm and the rods beside it stand along Z, and
//! the forearm and the rod beside it lie along X.

use dobot_arm::{FOREARM, REAR_ARM, Tool};

use crate::mounted_tool::MountedTool;
use crate::shape::Colour::{Accent, Dark, Metal};
use crate::shape::{Shape, cuboid, pin, post};

/// How high the pivot of the rear arm is above the table, in mm (Figure 3.1).
pub(crate) const FOOT_MM: f64 = 103.0;

/// From the pivot of the crank to its end, and from the elbow to the tail of the forearm, in mm.
pub(crate) const CRANK_MM: f64 = 42.0;

/// From the pivot of the rear arm to where the rear rod is held, and from the elbow to the same: X and Z in mm.
pub(crate) const REAR_ROD_AT_MM: [f64; 2] = [-27.0, 22.0];

/// From the elbow to where the front rod is held, and from the wrist to the same: X and Z in mm.
pub(crate) const FRONT_ROD_AT_MM: [f64; 2] = [20.0, 22.0];

/// How far below the wrist the horn of the servo ends, in mm.
const HORN_MM: f64 = 13.0;

/// How far the fingers of an open gripper are apart, in mm.
const FINGERS_MM: f64 = 30.0;

const CRANK_Y: f64 = -21.0;
const ROD_Y: f64 = 25.5;
const FRONT_ROD_Y: f64 = 9.5;

pub(crate) fn base() -> Vec<Shape> {
    vec![
        cuboid(
            [-73.0, -73.0, -FOOT_MM + 2.0],
            [73.0, 73.0, -FOOT_MM + 38.0],
            Dark,
        ),
        cuboid([-66.0, -66.0, -FOOT_MM + 38.0], [66.0, 66.0, -61.0], Metal),
        post(62.0, [-61.0, -58.5], Accent),
    ]
}

pub(crate) fn turret() -> Vec<Shape> {
    let [rod_x, rod_z] = REAR_ROD_AT_MM;
    let cheek = |y: f64| cuboid([-36.0, y - 3.0, -50.5], [23.0, y + 3.0, 23.0], Metal);
    let motor = |y: f64| cuboid([-21.0, y - 15.0, -21.0], [21.0, y + 15.0, 21.0], Dark);
    vec![
        post(60.0, [-58.5, -50.5], Metal),
        cheek(32.0),
        cheek(-32.0),
        motor(58.0),
        motor(-58.0),
        pin(4.5, [rod_x, rod_z], [ROD_Y - 4.0, 38.0], Metal),
    ]
}

pub(crate) fn rear_arm() -> Vec<Shape> {
    let side = |y: f64| {
        cuboid(
            [-16.0, y - 3.0, -16.0],
            [16.0, y + 3.0, REAR_ARM.0 + 14.0],
            Metal,
        )
    };
    vec![
        side(15.0),
        side(-15.0),
        pin(8.0, [0.0, 0.0], [-30.0, 30.0], Dark),
        pin(11.0, [0.0, REAR_ARM.0], [-19.6, 19.6], Accent),
    ]
}

pub(crate) fn elbow_plate() -> Vec<Shape> {
    let [rear_x, rear_z] = REAR_ROD_AT_MM;
    let [front_x, front_z] = FRONT_ROD_AT_MM;
    vec![
        cuboid(
            [rear_x - 6.0, 19.6, -9.0],
            [front_x + 6.0, 23.0, 28.0],
            Accent,
        ),
        pin(4.0, [rear_x, rear_z], [19.0, ROD_Y + 3.5], Metal),
        pin(4.0, [front_x, front_z], [FRONT_ROD_Y - 3.5, 24.0], Metal),
    ]
}

pub(crate) fn forearm() -> Vec<Shape> {
    vec![
        cuboid(
            [-CRANK_MM - 7.0, -7.0, -8.0],
            [FOREARM.0 + 8.0, 7.0, 8.0],
            Metal,
        ),
        pin(14.0, [0.0, 0.0], [-8.0, 8.0], Metal),
        pin(4.0, [-CRANK_MM, 0.0], [-ROD_Y - 3.5, 10.0], Metal),
        pin(4.5, [FOREARM.0, 0.0], [-21.5, 21.5], Metal),
    ]
}

pub(crate) fn crank() -> Vec<Shape> {
    vec![
        cuboid(
            [-CRANK_MM - 7.0, CRANK_Y - 2.0, -8.0],
            [10.0, CRANK_Y + 2.0, 8.0],
            Dark,
        ),
        pin(4.0, [-CRANK_MM, 0.0], [-ROD_Y - 3.5, -18.0], Metal),
    ]
}

/// The rod from the crank to the tail of the forearm.
pub(crate) fn crank_rod() -> Vec<Shape> {
    upright_rod(-ROD_Y)
}

/// The rod beside the rear arm, which keeps the plate at the elbow level.
pub(crate) fn rear_rod() -> Vec<Shape> {
    upright_rod(ROD_Y)
}

fn upright_rod(y: f64) -> Vec<Shape> {
    let rod = cuboid(
        [-3.4, y - 1.8, -3.4],
        [3.4, y + 1.8, REAR_ARM.0 + 3.4],
        Dark,
    );
    let eye = |z: f64| pin(7.0, [0.0, z], [y - 2.0, y + 2.0], Dark);
    vec![rod, eye(0.0), eye(REAR_ARM.0)]
}

/// The rod beside the forearm, which keeps the wrist level.
pub(crate) fn front_rod() -> Vec<Shape> {
    let y = FRONT_ROD_Y;
    let rod = cuboid([-3.4, y - 1.8, -3.4], [FOREARM.0 + 3.4, y + 1.8, 3.4], Dark);
    let eye = |x: f64| pin(7.0, [x, 0.0], [y - 2.0, y + 2.0], Dark);
    vec![rod, eye(0.0), eye(FOREARM.0)]
}

/// The wrist, with the servo so far beyond it that turns a tool.
pub(crate) fn wrist(servo_mm: Option<f64>) -> Vec<Shape> {
    let [rod_x, rod_z] = FRONT_ROD_AT_MM;
    let side = |y: f64| cuboid([-10.0, y - 2.0, -10.0], [33.0, y + 2.0, 28.0], Metal);
    let mut shapes = vec![
        side(17.5),
        side(-17.5),
        pin(4.0, [rod_x, rod_z], [FRONT_ROD_Y - 4.0, 21.0], Metal),
    ];
    if let Some(x) = servo_mm {
        shapes.extend([
            cuboid([22.0, -15.5, -8.0], [x + 13.0, 15.5, 3.0], Metal),
            cuboid([x - 11.5, -6.5, 3.0], [x + 11.5, 6.5, 27.0], Dark),
        ]);
    }
    shapes
}

/// A tool, from its axis at the height of the wrist down to its tip.
pub(crate) fn tool(tool: MountedTool) -> Vec<Shape> {
    let tip = -tool.length().0;
    let horn = post(10.0, [-HORN_MM, -8.0], Metal);
    // The part between the horn and the tip, if there is room for it.
    let down_to = |end: f64, radius: f64, colour| {
        (end < -HORN_MM).then(|| post(radius, [end, -HORN_MM], colour))
    };
    let mut shapes = vec![horn];
    match tool.kind() {
        Tool::SuctionCup => {
            shapes.extend(down_to(tip + 12.0, 4.0, Metal));
            shapes.push(post(9.0, [tip, tip + 12.0], Dark));
        }
        Tool::Gripper => {
            shapes.push(cuboid(
                [-10.0, -20.0, -HORN_MM - 6.0],
                [10.0, 20.0, -HORN_MM],
                Dark,
            ));
            for side in [-1.0, 1.0] {
                let [near, far] = [FINGERS_MM / 2.0, FINGERS_MM / 2.0 + 5.0].map(|y| y * side);
                let (right, left) = (near.min(far), near.max(far));
                shapes.push(cuboid(
                    [-5.0, right, tip],
                    [5.0, left, -HORN_MM - 6.0],
                    Metal,
                ));
            }
        }
        Tool::Pen => {
            shapes.extend(down_to(tip + 7.0, 4.8, Accent));
            shapes.push(post(1.4, [tip, tip + 7.0], Metal));
        }
        Tool::Laser => {
            shapes.extend(down_to(tip + 7.0, 11.0, Dark));
            shapes.push(post(3.2, [tip, tip + 7.0], Metal));
        }
    }
    shapes
}
