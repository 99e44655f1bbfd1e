//! Mouse and hand following of a stock arm: scaled, and averaged with earlier packets (note N49).

use crate::{JointMove, Speeds};
use dobot_arm::{Degrees, Joints, Limits, Millimeters, Pose, Position, TICK_S, Tool};
use dobot_wire::{Gesture, MouseMove};

use super::followed::{Predecessor, StaleSlot, hand_sample, mouse_sample};
use super::hand_scale::{HandScale, lowest_mm};
use super::motion::Motion;
use crate::{ArmPlace, Model, Trajectory, TrajectoryError};

/// Plans a mouse move: swings the base and changes reach and height.
pub(crate) fn follow_mouse(by: &MouseMove, model: &Model) -> Result<Trajectory, TrajectoryError> {
    let trajectory = |before| {
        let average = model.followed.mouse_average(mouse_sample(by), before);
        mouse_step(average, by, model)
    };
    check_moves(&trajectory(Predecessor::OtherCommand))?;
    check_moves(&trajectory(Predecessor::SameSeries))?;
    trajectory(Predecessor::AsSent)
}

/// Refuses a packet whose trajectory may be empty, because the arm would hang.
fn check_moves(trajectory: &Result<Trajectory, TrajectoryError>) -> Result<(), TrajectoryError> {
    match trajectory {
        Err(TrajectoryError::NothingToFollow) => Err(TrajectoryError::NothingToFollow),
        Ok(_) | Err(_) => Ok(()),
    }
}

/// Plans an averaged mouse move.
fn mouse_step(
    average: [f32; 3],
    by: &MouseMove,
    model: &Model,
) -> Result<Trajectory, TrajectoryError> {
    let [swing, longer, higher] = average.map(f64::from);
    let from = model.place;
    let ahead = pose_ahead(&from.pose, [longer, higher], model.tool);
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
    // From an unknown position only the swing is certain to move something: the arm may be at a
    // stop.
    let sure = [true, model.knows_place, model.knows_place];
    joint_step(to, FOLLOW_S, sure, model)
}

/// The pose straight ahead with another reach and height.
fn pose_ahead(from: &Pose, [longer, higher]: [f64; 2], tool: Tool) -> Pose {
    let reach = from.position.reach() + Millimeters(MOUSE_MM * longer);
    let z_mm = from.position.z.0 + MOUSE_MM * higher;
    Pose {
        position: Position::new(reach.0, 0.0, within_height(z_mm, tool)),
        rotation: Degrees(0.0),
    }
}

/// Plans a move to the position of a hand, scaled to the arm.
pub(crate) fn follow_hand(hand: &Gesture, model: &Model) -> Result<Trajectory, TrajectoryError> {
    let sample = hand_sample(hand);
    let trajectory = |before, behind| {
        let average = model.followed.hand_average(sample, before, behind);
        hand_step(average, model)
    };
    for before in [
        Predecessor::AsSent,
        Predecessor::OtherCommand,
        Predecessor::SameSeries,
    ] {
        check_moves(&trajectory(before, StaleSlot::AsSent))?;
        check_moves(&trajectory(before, StaleSlot::SameAsNew))?;
    }
    trajectory(Predecessor::AsSent, StaleSlot::AsSent)
}

/// Plans a move to an averaged hand position.
fn hand_step([x, y, z]: [f32; 3], model: &Model) -> Result<Trajectory, TrajectoryError> {
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
    joint_step(to, period_s, [model.knows_place; 3], model)
}

/// Moves all joints at constant speed, without ramps, for the whole number of ticks that fit into
/// the time. `sure` states whether the angles of base, rear arm and forearm are known.
fn joint_step(
    to: Joints,
    period_s: f64,
    sure: [bool; 3],
    model: &Model,
) -> Result<Trajectory, TrajectoryError> {
    let from = model.place.joints;
    let ways = ways(&from, &to);
    let longest_deg = longest(ways, [true; 3]);
    if longest(ways, sure) < STEP_DEG {
        return Err(TrajectoryError::NothingToFollow);
    }
    let ticks = libm::floor(period_s / TICK_S + ROUNDING);
    let share = (ticks * TICK_S / period_s).min(1.0);
    let end = part_way(&from, &to, share);
    let even = even_speeds(longest_deg / period_s);
    let motion = Motion::Joints(JointMove::new(from, end, &even)?);
    let trajectory = Trajectory::moving(motion, ArmPlace::at_joints(end, model.tool), model);
    // With a whole number of ticks, rounding may make it one less.
    let clear = libm::fabs(period_s / TICK_S - ticks) > 2.0 * ROUNDING || period_s == FOLLOW_S;
    Ok(Trajectory {
        knows_end: trajectory.knows_end && clear,
        ..trajectory
    })
}

/// Returns the joint angles after a share of the ways; the servo is at its end.
fn part_way(from: &Joints, to: &Joints, share: f64) -> Joints {
    let [base, rear, fore] = ways(from, to).map(|way| Degrees(way.0 * share));
    Joints {
        base: from.base + base,
        rear: from.rear + rear,
        fore: from.fore + fore,
        servo: to.servo,
    }
}

/// Returns the ways of base, rear arm and forearm.
pub(super) fn ways(from: &Joints, to: &Joints) -> [Degrees; 3] {
    [
        to.base - from.base,
        to.rear - from.rear,
        to.fore - from.fore,
    ]
}

/// Returns the speeds of a move whose slowest joint moves evenly, without ramps.
fn even_speeds(joint_deg_s: f64) -> Speeds {
    Speeds {
        joint_deg_s,
        joint_deg_s2: NO_RAMP_DEG_S2,
        servo_deg_s: NO_RAMP_DEG_S2,
        servo_deg_s2: NO_RAMP_DEG_S2,
        ..Speeds::STOCK
    }
}

fn longest(ways: [Degrees; 3], counts: [bool; 3]) -> f64 {
    let counted = ways.into_iter().zip(counts).filter(|way| way.1);
    counted.fold(0.0, |most, (way, _)| f64::max(most, way.abs().0))
}

fn within_height(z_mm: f64, tool: Tool) -> f64 {
    z_mm.clamp(lowest_mm(tool), HIGHEST_MM)
}

/// The value of a mouse unit.
const MOUSE_DEG: f64 = 0.225;
const MOUSE_MM: f64 = 0.4;
const FOLLOW_S: f64 = 0.1;
/// The single-precision rounding of a number of ticks.
const ROUNDING: f64 = 1e-3;
const HIGHEST_MM: f64 = 135.0;
/// Beyond this distance the duration of a gesture follows from its speed.
const NEAR_MM: f64 = 20.0;
const GESTURE_MM_S: f64 = 200.0;
/// So fast that the ramp vanishes.
const NO_RAMP_DEG_S2: f64 = 1e9;
/// A motor step (note N37): a smaller move may move nothing, and then the arm hangs.
const STEP_DEG: f64 = 1.8 / 160.0;
