//! How a stock arm follows mouse and hand: scaled, and smoothed by what it was sent before (note
//! N49).

use dobot_arm::{Degrees, Joints, Limits, Millimeters, Pose, Position, TICK_S, Tool};
use dobot_motion::{JointMove, Speeds};
use dobot_wire::{Gesture, MouseMove};

use crate::plan::moving;
use crate::way::Way;
use crate::{Course, CourseError, Model, Place};

/// The packets of mouse and hand that a stock arm remembers, for it averages each with those before.
///
/// They lie in ten places that mouse and hand share. A row ends with any other command; what it
/// leaves in its places stays there, and the first nine averages of a hand reach one place of that.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Followed {
    row: Option<Row>,
    /// Another command came behind the row.
    is_over: bool,
    samples: [[f32; 3]; SAMPLES],
    /// How many places the row has filled.
    count: u8,
}

/// What is followed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Row {
    Mouse,
    Hand,
}

/// What a packet may find when the arm comes to it. A release or a laser off, which wait for nothing,
/// may come between those of a row, or between others than was foreseen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Before {
    /// What was sent.
    AsSent,
    /// Another command: a row begins.
    Another,
    /// The row that is taken to be over goes on.
    TheRow,
}

impl Followed {
    /// Another command: what follows it begins a row.
    pub(crate) const fn end_row(&mut self) {
        self.is_over = true;
    }

    pub(crate) fn take_mouse(&mut self, by: &MouseMove) {
        self.take(Row::Mouse, mouse_sample(by));
    }

    pub(crate) fn take_hand(&mut self, hand: &Gesture) {
        self.take(Row::Hand, hand_sample(hand));
    }

    fn take(&mut self, row: Row, sample: [f32; 3]) {
        self.count = self.len(row, Before::AsSent);
        (self.row, self.is_over) = (Some(row), false);
        if usize::from(self.count) == SAMPLES {
            self.samples.copy_within(1.., 0);
            self.samples[SAMPLES - 1] = sample;
        } else {
            self.samples[usize::from(self.count)] = sample;
            self.count += 1;
        }
    }

    /// How many samples the next packet of a row finds.
    fn len(&self, row: Row, before: Before) -> u8 {
        let goes_on = match before {
            Before::AsSent => !self.is_over,
            Before::Another => false,
            Before::TheRow => true,
        };
        if goes_on && self.row == Some(row) {
            self.count
        } else {
            0
        }
    }

    /// Each sample before counts together with the new one, which counts once more.
    fn mouse_average(&self, sample: [f32; 3], before: Before) -> [f32; 3] {
        let len = self.len(Row::Mouse, before);
        core::array::from_fn(|axis| {
            let new = sample[axis];
            let row = self.samples[..usize::from(len)].iter();
            row.fold(new, |sum, it| sum + (new + it[axis])) / divisor(len)
        })
    }

    /// Half of it the new sample, half of it those before and one place more: what lies `behind` them,
    /// or behind ten samples the new one.
    fn hand_average(&self, sample: [f32; 3], before: Before, behind: Behind) -> [f32; 3] {
        let len = self.len(Row::Hand, before);
        let (row, left) = self.samples.split_at(usize::from(len));
        let behind = match (behind, left.first()) {
            (Behind::AsSent, Some(left)) => *left,
            _ => sample,
        };
        core::array::from_fn(|axis| {
            // A slip of the stock program: the height counts once more.
            let first = if axis == 2 { sample[2] } else { 0.0 };
            let sum = row.iter().fold(first, |sum, it| sum + it[axis]) + behind[axis];
            0.5 * sample[axis] + 0.5 * sum / divisor(len)
        })
    }
}

/// By how many packets a sum is divided: those before and the new one, ten at the most.
fn divisor(len: u8) -> f32 {
    f32::from((len + 1).min(10))
}

/// What lies in the place behind a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Behind {
    /// What was sent before; nothing since power-up.
    AsSent,
    /// The same as the new sample: whoever had the arm before held the hand still there.
    TheSame,
}

/// Swings the base, and changes reach and height, by what a mouse tells.
pub(crate) fn moused(by: &MouseMove, model: &Model) -> Result<Course, CourseError> {
    let course = |before| {
        let average = model.followed.mouse_average(mouse_sample(by), before);
        swung(average, by, model)
    };
    surely_moves(&course(Before::Another))?;
    surely_moves(&course(Before::TheRow))?;
    course(Before::AsSent)
}

/// Whether the arm does not hang with a packet that may come to this.
fn surely_moves(course: &Result<Course, CourseError>) -> Result<(), CourseError> {
    match course {
        Err(CourseError::NothingToFollow) => Err(CourseError::NothingToFollow),
        Ok(_) | Err(_) => Ok(()),
    }
}

/// Goes by what a mouse told, averaged.
fn swung(average: [f32; 3], by: &MouseMove, model: &Model) -> Result<Course, CourseError> {
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
        told if told.abs().0 <= 90.0 => told,
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
pub(crate) fn gestured(hand: &Gesture, model: &Model) -> Result<Course, CourseError> {
    let sample = hand_sample(hand);
    let course = |before, behind| {
        let average = model.followed.hand_average(sample, before, behind);
        handed(average, model)
    };
    for before in [Before::AsSent, Before::Another, Before::TheRow] {
        surely_moves(&course(before, Behind::AsSent))?;
        surely_moves(&course(before, Behind::TheSame))?;
    }
    course(Before::AsSent, Behind::AsSent)
}

/// Goes to the place of a hand that is averaged already.
fn handed([x, y, z]: [f32; 3], model: &Model) -> Result<Course, CourseError> {
    let from = model.place;
    let to = Position::new(
        230.0 + 0.5 * f64::from(x),
        y.into(),
        0.5 * (f64::from(z) - 200.0) + lowest_mm(model.tool),
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
    followed(to, period_s, [model.knows_place; 3], model)
}

/// All joints at an even speed, without ramps, for as many whole ticks as fit into the time. `sure`
/// tells of base, rear arm and forearm whether their ways are known.
fn followed(
    to: Joints,
    period_s: f64,
    sure: [bool; 3],
    model: &Model,
) -> Result<Course, CourseError> {
    let from = model.place.joints;
    let ways = [
        to.base - from.base,
        to.rear - from.rear,
        to.fore - from.fore,
    ];
    let longest_deg = longest(ways, [true; 3]);
    if longest(ways, sure) < STEP_DEG {
        return Err(CourseError::NothingToFollow);
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
    let way = Way::Joints(JointMove::new(from, end, &even)?);
    let course = moving(way, Place::at_joints(end, model.tool), model);
    // With a whole number of ticks, rounding decides whether it is one less.
    let clear = libm::fabs(period_s / TICK_S - ticks) > 2.0 * ROUNDING || period_s == FOLLOW_S;
    Ok(Course {
        knows_end: course.knows_end && clear,
        ..course
    })
}

fn longest(ways: [Degrees; 3], counts: [bool; 3]) -> f64 {
    let counted = ways.into_iter().zip(counts).filter(|it| it.1);
    counted.fold(0.0, |most, (way, _)| f64::max(most, way.abs().0))
}

/// Floats 3 to 5 in their order.
const fn mouse_sample(by: &MouseMove) -> [f32; 3] {
    [by.y, by.x, by.z]
}

const fn hand_sample(hand: &Gesture) -> [f32; 3] {
    [hand.x, hand.y, hand.z]
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

/// So many packets are remembered.
const SAMPLES: usize = 10;
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
