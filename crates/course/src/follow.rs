//! How a stock arm follows mouse and hand: scaled and smoothed (note N49).
//!
//! Both are averaged with up to ten packets before, which nobody knows who did not see them all.
//! So the courses here are guesses and say so: the first packet of a row exactly, those behind it
//! as if the row had been steady.

use dobot_arm::{Degrees, Joints, Limits, Millimeters, Pose, Position, Tool};
use dobot_motion::{JointMove, Speeds};
use dobot_wire::{Gesture, MouseMove};

use crate::plan::moving;
use crate::way::Way;
use crate::{Course, CourseError, Model, Place};

/// Swings the base, and changes reach and height, by what a mouse tells.
pub(crate) fn moused(by: &MouseMove, model: &Model) -> Result<Course, CourseError> {
    let [swing, longer, higher] = [by.y, by.x, by.z].map(|it| f64::from(it) * gain(model));
    if [swing, longer, higher] == [0.0; 3] {
        return Err(CourseError::NothingToFollow);
    }
    let from = model.place;
    let reach = from.pose.position.reach() + Millimeters(MOUSE_MM * longer);
    let z_mm = from.pose.position.z.0 + MOUSE_MM * higher;
    let ahead = Pose {
        position: Position::new(reach.0, 0.0, within_height(z_mm, model.tool)),
        rotation: Degrees(0.0),
    };
    let arms = Limits::STOCK.solve(&ahead, model.tool)?;
    let base = from.joints.base + Degrees(-MOUSE_DEG * swing);
    let servo = match Degrees(by.rotation_deg.into()) {
        told if told.abs().0 <= 90.0 => told,
        _ => from.joints.servo,
    };
    let to = Joints {
        base,
        servo,
        ..arms
    };
    followed(to, FOLLOW_S, model)
}

/// Goes to where a hand is, scaled to the arm.
pub(crate) fn gestured(hand: &Gesture, model: &Model) -> Result<Course, CourseError> {
    let from = model.place;
    let to = Position::new(
        230.0 + 0.5 * f64::from(hand.x),
        hand.y.into(),
        0.5 * (f64::from(hand.z) - 200.0) + lowest_mm(model.tool),
    );
    let distance_mm = from.pose.position.distance(to).0;
    let period_s = if distance_mm > NEAR_MM {
        distance_mm / GESTURE_MM_S
    } else {
        FOLLOW_S
    };
    let pose = Pose {
        position: Position {
            z: Millimeters(within_height(to.z.0, model.tool)),
            ..to
        },
        rotation: Degrees(0.0),
    };
    let to = Joints {
        servo: from.joints.servo,
        ..Limits::STOCK.solve(&pose, model.tool)?
    };
    followed(to, period_s, model)
}

/// All joints at an even speed, without ramps.
fn followed(to: Joints, period_s: f64, model: &Model) -> Result<Course, CourseError> {
    let from = model.place.joints;
    let ways = [
        to.base - from.base,
        to.rear - from.rear,
        to.fore - from.fore,
    ];
    let longest_deg = ways
        .iter()
        .fold(0.0, |most, way| f64::max(most, way.abs().0));
    if longest_deg < NO_WAY_DEG {
        return Err(CourseError::NothingToFollow);
    }
    let even = Speeds {
        joint_deg_s: longest_deg / period_s,
        joint_deg_s2: NO_RAMP_DEG_S2,
        servo_deg_s: NO_RAMP_DEG_S2,
        servo_deg_s2: NO_RAMP_DEG_S2,
        ..Speeds::STOCK
    };
    let way = Way::Joints(JointMove::new(from, to, &even)?);
    let course = moving(way, Place::at_joints(to, model.tool), model);
    Ok(Course {
        is_exact: false,
        knows_end: false,
        ..course
    })
}

/// What a steady row of packets counts for, against the first of them.
const fn gain(model: &Model) -> f64 {
    if model.follows { STEADY_GAIN } else { 1.0 }
}

fn within_height(z_mm: f64, tool: Tool) -> f64 {
    z_mm.clamp(lowest_mm(tool), HIGHEST_MM)
}

/// The lowest height to which a stock arm follows.
const fn lowest_mm(tool: Tool) -> f64 {
    match tool {
        Tool::SuctionCup | Tool::Laser => -30.0,
        Tool::Gripper => 20.0,
    }
}

/// What a unit of the mouse is worth.
const MOUSE_DEG: f64 = 0.225;
const MOUSE_MM: f64 = 0.4;
const STEADY_GAIN: f64 = 2.1;
const FOLLOW_S: f64 = 0.1;
const HIGHEST_MM: f64 = 135.0;
/// Beyond that distance the time of a gesture follows from its speed.
const NEAR_MM: f64 = 20.0;
const GESTURE_MM_S: f64 = 200.0;
/// So fast that no ramp is left of it.
const NO_RAMP_DEG_S2: f64 = 1e9;
const NO_WAY_DEG: f64 = 1e-6;
