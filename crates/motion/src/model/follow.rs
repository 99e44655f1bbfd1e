//! How a stock arm follows mouse and hand: scaled, and smoothed by what it was sent before (note
//! N49).

use crate::{JointMove, Speeds};
use dobot_arm::{Degrees, Joints, Limits, Millimeters, Pose, Position, TICK_S, Tool};
use dobot_wire::{Gesture, MouseMove};

use super::followed::{Before, Behind, hand_sample, mouse_sample};
use super::hand_scale::{HandScale, lowest_mm};
use super::motion::Motion;
use crate::{ArmPlace, Model, Trajectory, TrajectoryError};

/// Swings the base, and changes reach and height, by what a mouse tells.
pub(crate) fn moused(by: &MouseMove, model: &Model) -> Result<Trajectory, TrajectoryError> {
    let trajectory = |before| {
        let average = model.followed.mouse_average(mouse_sample(by), before);
        swung(average, by, model)
    };
    surely_moves(&trajectory(Before::Another))?;
    surely_moves(&trajectory(Before::TheRow))?;
    trajectory(Before::AsSent)
}

/// Whether the arm does not hang with a packet that may come to this.
fn surely_moves(trajectory: &Result<Trajectory, TrajectoryError>) -> Result<(), TrajectoryError> {
    match trajectory {
        Err(TrajectoryError::NothingToFollow) => Err(TrajectoryError::NothingToFollow),
        Ok(_) | Err(_) => Ok(()),
    }
}

/// Goes by what a mouse told, averaged.
fn swung(average: [f32; 3], by: &MouseMove, model: &Model) -> Result<Trajectory, TrajectoryError> {
    let [swing, longer, higher] = average.map(f64::from);
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
        angle if angle.abs().0 <= 90.0 => angle,
        _ => from.joints.servo,
    };
    let to = Joints {
        base,
        servo,
        ..arms
    };
    // From an unknown place only the swing is sure to move something: the arm may be at a stop.
    let sure = [true, model.knows_place, model.knows_place];
    followed(to, FOLLOW_S, sure, model)
}

/// Goes to where a hand is, scaled to the arm.
pub(crate) fn gestured(hand: &Gesture, model: &Model) -> Result<Trajectory, TrajectoryError> {
    let sample = hand_sample(hand);
    let trajectory = |before, behind| {
        let average = model.followed.hand_average(sample, before, behind);
        handed(average, model)
    };
    for before in [Before::AsSent, Before::Another, Before::TheRow] {
        surely_moves(&trajectory(before, Behind::AsSent))?;
        surely_moves(&trajectory(before, Behind::TheSame))?;
    }
    trajectory(Before::AsSent, Behind::AsSent)
}

/// Goes to the place of a hand that is averaged already.
fn handed([x, y, z]: [f32; 3], model: &Model) -> Result<Trajectory, TrajectoryError> {
    let from = model.place;
    let hand = HandScale::of(&model.dialect, model.tool);
    let to = Position::new(hand.x.place_mm(x), hand.y.place_mm(y), hand.z.place_mm(z));
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
    followed(to, period_s, [model.knows_place; 3], model)
}

/// All joints at an even speed, without ramps, for as many whole ticks as fit into the time. `sure`
/// tells of base, rear arm and forearm whether their ways are known.
fn followed(
    to: Joints,
    period_s: f64,
    sure: [bool; 3],
    model: &Model,
) -> Result<Trajectory, TrajectoryError> {
    let from = model.place.joints;
    let ways = [
        to.base - from.base,
        to.rear - from.rear,
        to.fore - from.fore,
    ];
    let longest_deg = longest(ways, [true; 3]);
    if longest(ways, sure) < STEP_DEG {
        return Err(TrajectoryError::NothingToFollow);
    }
    let ticks = libm::floor(period_s / TICK_S + ROUNDING);
    let share = (ticks * TICK_S / period_s).min(1.0);
    let part = |from: Degrees, way: Degrees| from + Degrees(way.0 * share);
    let end = Joints {
        base: part(from.base, ways[0]),
        rear: part(from.rear, ways[1]),
        fore: part(from.fore, ways[2]),
        servo: to.servo,
    };
    let even = Speeds {
        joint_deg_s: longest_deg / period_s,
        joint_deg_s2: NO_RAMP_DEG_S2,
        servo_deg_s: NO_RAMP_DEG_S2,
        servo_deg_s2: NO_RAMP_DEG_S2,
        ..Speeds::STOCK
    };
    let motion = Motion::Joints(JointMove::new(from, end, &even)?);
    let trajectory = Trajectory::moving(motion, ArmPlace::at_joints(end, model.tool), model);
    // With a whole number of ticks, rounding decides whether it is one less.
    let clear = libm::fabs(period_s / TICK_S - ticks) > 2.0 * ROUNDING || period_s == FOLLOW_S;
    Ok(Trajectory {
        knows_end: trajectory.knows_end && clear,
        ..trajectory
    })
}

fn longest(ways: [Degrees; 3], counts: [bool; 3]) -> f64 {
    let counted = ways.into_iter().zip(counts).filter(|it| it.1);
    counted.fold(0.0, |most, (way, _)| f64::max(most, way.abs().0))
}

fn within_height(z_mm: f64, tool: Tool) -> f64 {
    z_mm.clamp(lowest_mm(tool), HIGHEST_MM)
}

/// What a unit of the mouse is worth.
const MOUSE_DEG: f64 = 0.225;
const MOUSE_MM: f64 = 0.4;
const FOLLOW_S: f64 = 0.1;
/// Of a number of ticks, by single precision.
const ROUNDING: f64 = 1e-3;
const HIGHEST_MM: f64 = 135.0;
/// Beyond that distance the time of a gesture follows from its speed.
const NEAR_MM: f64 = 20.0;
const GESTURE_MM_S: f64 = 200.0;
/// So fast that no ramp is left of it.
const NO_RAMP_DEG_S2: f64 = 1e9;
/// A step of a motor (note N37): who moves less than that may move nothing, and then the arm hangs.
const STEP_DEG: f64 = 1.8 / 160.0;
