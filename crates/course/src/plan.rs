//! From a command to its course: pure, nothing has moved yet.

use dobot_arm::{Degrees, Joints, Limits, Pose, Position, Unreachable, forward, stock};
use dobot_motion::{Cut, JointMove, Jump, LineMove, Stroke, StrokeSpeeds};
use dobot_wire::{
    Command, Configuration, Gesture, MouseMove, MoveJoints, MovingMode, Voice, VoiceOrder,
    WriteMode, WriteVector,
};

use crate::error::MOST_COUNTED_S;
use crate::follow::{gestured, moused};
use crate::lifts::Lifts;
use crate::model::{Lines, tool_named};
use crate::place::position;
use crate::way::Way;
use crate::{Button, Course, CourseError, JogCourse, Model, Place};

/// Plans a command from where the arm is.
pub(crate) fn plan(model: &Model, command: &Command) -> Result<Course, CourseError> {
    match command {
        Command::MoveTo(it) => {
            let target = Target::Pose(Pose {
                position: position(it.x_mm, it.y_mm, it.z_mm),
                rotation: Degrees(it.rotation_deg.into()),
            });
            Ok(target
                .course(model, it.mode)?
                .pausing(model.pause_s(command)))
        }
        Command::MoveJoints(it) => {
            let target = Target::Joints(joints(it));
            Ok(target
                .course(model, it.mode)?
                .pausing(model.pause_s(command)))
        }
        Command::WriteVector(it) if it.stop => Ok(still(model)),
        Command::WriteVector(it) => write(it, model),
        Command::MouseMove(it) => mouse(it, model),
        Command::Gesture(it) => gesture(it, model),
        Command::Voice(it) => spoken(it, model),
        Command::JointJog(_) | Command::LinearJog(_) => pressed(command, model),
        Command::Configuration(it) => configured(it, model),
        Command::PlaybackAdjustment(_) => Ok(still(model)),
    }
}

#[derive(Clone, Copy)]
enum Target {
    Pose(Pose),
    Joints(Joints),
}

impl Target {
    /// The place of the target. One given as joint angles says more than its pose.
    fn place(self, model: &Model) -> Result<Place, Unreachable> {
        match self {
            Self::Pose(pose) => Limits::STOCK
                .solve(&pose, model.tool)
                .map(|joints| Place { joints, pose }),
            Self::Joints(joints) => {
                Limits::STOCK.check(&joints, model.tool)?;
                Ok(Place::at_joints(joints, model.tool))
            }
        }
    }

    fn course(self, model: &Model, mode: MovingMode) -> Result<Course, CourseError> {
        let to = self.place(model)?;
        let speeds = model.settings.move_speeds();
        let height = model.settings.jump_height;
        let from = model.place;
        let way = match mode {
            MovingMode::Jump if model.dialect.jumps_by_joints => Way::Lifts(Lifts::new(
                from, to.pose, to.joints, height, &speeds, model.tool,
            )?),
            MovingMode::Jump => Way::Jump(Jump::new(from.pose, to.pose, height, &speeds)?),
            MovingMode::MovL => line(model, to.pose)?,
            MovingMode::MovJ => Way::Joints(JointMove::new(from.joints, to.joints, &speeds)?),
        };
        Ok(Course {
            // It says itself where it ends, from wherever.
            knows_end: true,
            ..moving(way, to, model)
        })
    }
}

/// A straight line, and how the tool turns on it.
fn line(model: &Model, to: Pose) -> Result<Way, CourseError> {
    let from = model.place.pose;
    let length_mm = from.position.distance(to.position).0;
    if model.dialect.loses_pose_on_the_spot && model.knows_place && length_mm < ON_THE_SPOT_MM {
        return Err(CourseError::OnTheSpot);
    }
    check_lines(model)?;
    let held = Pose {
        rotation: if model.dialect.turns_after_line {
            from.rotation
        } else {
            to.rotation
        },
        ..to
    };
    let line = LineMove::new(from, held, &model.settings.move_speeds())?;
    Ok(Way::Line(line, to.rotation))
}

/// Whether a straight line begins where the arm is.
fn check_lines(model: &Model) -> Result<(), CourseError> {
    if model.dialect.resumes_cut_lines && model.lines == Lines::Cut {
        return Err(CourseError::BehindCutLine);
    }
    Ok(())
}

fn write(vector: &WriteVector, model: &Model) -> Result<Course, CourseError> {
    let from = model.place.pose;
    let by = position(vector.x_mm, vector.y_mm, vector.z_mm);
    if model.dialect.loses_pose_on_the_spot && by.length().0 <= NO_LENGTH_MM {
        return Err(CourseError::OnTheSpot);
    }
    let speeds = stroke_speeds(vector, model)?;
    let stored_mm_s = model.write_speed_mm_s;
    let cut = cut_of(vector, stored_mm_s, speeds.acceleration_mm_s2, model);
    let stroke = Stroke::new(from.position, by, &speeds)?;
    if model.dialect.counts_ticks_in_16_bits && stroke.duration_s() > MOST_COUNTED_S {
        let found = stroke.duration_s();
        return Err(CourseError::Uncounted { found });
    }
    if never_ends(vector, speeds.acceleration_mm_s2, model) {
        return Err(CourseError::NeverEnds);
    }
    let is_flat = model.dialect.has_rapid_laser_mode && vector.mode == WriteMode::Laser;
    let way = Way::Stroke {
        stroke,
        rotation: from.rotation,
        held_z: is_flat.then_some(from.position.z),
    };
    let course = relative(way, model)?;
    Ok(Course {
        to: if model.dialect.uses_start_speed {
            course.to
        } else {
            stock_end(&course, model)
        },
        burns: model.laser_during(vector),
        end_speed_mm_s: Some(cut.map_or(stroke.end_speed(), |it| it.end_mm_s.into())),
        ..course
    })
}

/// Where a stock arm takes itself to be when it has gone this way. At the very edge of its limits
/// rounding could bring it out: there it is where the way leads.
#[expect(clippy::cast_possible_truncation, reason = "as the arm calculates")]
fn stock_end(course: &Course, model: &Model) -> Place {
    let [from, to] = [course.from, course.to].map(|it| it.pose.position);
    let way = to - from;
    let way = [way.x, way.y, way.z].map(|it| it.0 as f32);
    let from = [from.x, from.y, from.z].map(|it| it.0);
    let [x, y, z] = stock::behind(from, way, model.tool.reach().0 as f32);
    let pose = Pose {
        position: Position::new(x, y, z),
        ..course.to.pose
    };
    let place = Place::at_pose(pose, model.tool).ok();
    place.filter(|it| it.check().is_ok()).unwrap_or(course.to)
}

/// Whether the arm would creep on for ever: with the end speed that the vector before left or, where
/// nobody knows that, with one that it may well have left.
fn never_ends(vector: &WriteVector, acceleration_mm_s2: f64, model: &Model) -> bool {
    let creeps = |stored_mm_s| {
        let cut = cut_of(vector, stored_mm_s, acceleration_mm_s2, model);
        cut.is_some_and(|it| it.ticks() <= 0)
    };
    let creeps_unknown = || LEFT_BY_OTHERS_MM_S.into_iter().any(creeps);
    creeps(model.write_speed_mm_s) || !model.knows_write_speed && creeps_unknown()
}

/// The ticks of a vector, where an arm cuts it into such and keeps the speed of the last for the next
/// vector (note N48).
#[expect(clippy::cast_possible_truncation, reason = "as the arm calculates")]
fn cut_of(
    vector: &WriteVector,
    stored_mm_s: f64,
    acceleration_mm_s2: f64,
    model: &Model,
) -> Option<Cut> {
    let [x, y, z] = [vector.x_mm, vector.y_mm, vector.z_mm];
    (!model.dialect.uses_start_speed).then(|| {
        Cut::of(
            libm::sqrtf(x * x + y * y + z * z),
            stored_mm_s as f32,
            vector.end_speed_mm_s,
            vector.max_speed_mm_s,
            acceleration_mm_s2 as f32,
        )
    })
}

/// Speeds above the largest count as the largest (note N5).
fn stroke_speeds(vector: &WriteVector, model: &Model) -> Result<StrokeSpeeds, CourseError> {
    let max_mm_s = f64::from(vector.max_speed_mm_s);
    let start_mm_s = if model.dialect.uses_start_speed {
        vector.start_speed_mm_s.into()
    } else {
        // It may have kept a little less than nothing, where a short vector was braked.
        model.write_speed_mm_s.max(0.0)
    };
    let speeds = StrokeSpeeds {
        start_mm_s: f64::min(start_mm_s, max_mm_s),
        end_mm_s: f64::from(vector.end_speed_mm_s).min(max_mm_s),
        max_mm_s,
        acceleration_mm_s2: model.settings.write_acceleration_mm_s2,
    };
    let is_rapid = vector.mode == WriteMode::Laser && !vector.laser;
    if model.dialect.has_rapid_laser_mode && is_rapid {
        rapid(&speeds)
    } else {
        Ok(speeds)
    }
}

/// Without the laser, laser mode accelerates a hundredfold (note N48).
fn rapid(speeds: &StrokeSpeeds) -> Result<StrokeSpeeds, CourseError> {
    let acceleration_mm_s2 = speeds.acceleration_mm_s2 * RAPID_FACTOR;
    let least_mm_s = acceleration_mm_s2 * HALF_A_TICK_S;
    if speeds.max_mm_s >= least_mm_s {
        return Ok(StrokeSpeeds {
            acceleration_mm_s2,
            ..*speeds
        });
    }
    // Less than half of what a tick changes the speed by: no tick is planned that changes it. As
    // fast as it begins it goes on; at rest it stays.
    let begin_mm_s = speeds.start_mm_s;
    if begin_mm_s < CREEPS_MM_S {
        return Err(CourseError::SlowRapid {
            found: speeds.max_mm_s,
            least: least_mm_s,
        });
    }
    Ok(StrokeSpeeds {
        end_mm_s: begin_mm_s,
        max_mm_s: begin_mm_s,
        acceleration_mm_s2,
        ..*speeds
    })
}

/// By a mouse increment: that much of Y, X and Z by the document (note N9).
fn mouse(by: &MouseMove, model: &Model) -> Result<Course, CourseError> {
    if model.dialect.mouse_swings {
        return moused(by, model);
    }
    let from = model.place.pose;
    let to = Pose {
        position: from.position + position(by.x, by.y, by.z),
        rotation: Degrees(by.rotation_deg.into()),
    };
    relative(
        Way::Line(
            LineMove::new(from, to, &model.settings.move_speeds())?,
            to.rotation,
        ),
        model,
    )
}

/// To where the hand is, with the rotation kept (note N18).
fn gesture(hand: &Gesture, model: &Model) -> Result<Course, CourseError> {
    if model.dialect.scales_gesture {
        return gestured(hand, model);
    }
    straight(position(hand.x, hand.y, hand.z), model)
}

fn spoken(voice: &Voice, model: &Model) -> Result<Course, CourseError> {
    if !model.dialect.hears_voice && !model.is_bluetooth {
        return Err(CourseError::NotHeard);
    }
    match VoiceOrder::parse(voice).ok_or(CourseError::NotUnderstood)? {
        VoiceOrder::Catch | VoiceOrder::Release => Ok(still(model)),
        VoiceOrder::Move { x_mm, y_mm, z_mm } => {
            let from = model.place.pose.position;
            straight(from + position(x_mm, y_mm, z_mm), model)
        }
    }
}

fn straight(to: Position, model: &Model) -> Result<Course, CourseError> {
    check_lines(model)?;
    let from = model.place.pose;
    let to = Pose {
        position: to,
        ..from
    };
    let line = LineMove::new(from, to, &model.settings.move_speeds())?;
    relative(Way::Line(line, to.rotation), model)
}

/// A button pressed; while an arm jogs it goes on from the speed that it has.
fn pressed(command: &Command, model: &Model) -> Result<Course, CourseError> {
    let speed = |axis| match &model.jog {
        Some(jog) if jog.axis() == axis || model.dialect.keeps_jog_speed => jog.target_speed(),
        _ => 0.0,
    };
    let way = match Button::of(command) {
        Some(Button::Held { axis, share }) => {
            Way::Jog(JogCourse::start(model, axis, share, speed(axis))?)
        }
        Some(Button::Released) => match &model.jog {
            Some(jog) => Way::RunDown(jog.release(model, f64::MAX)?),
            None => Way::Still,
        },
        _ => Way::Still,
    };
    let goes_on = matches!(way, Way::Jog(_) | Way::RunDown(_));
    let course = moving(way, model.place, model);
    Ok(Course {
        knows_end: course.knows_end && !goes_on,
        burns: model.begun(command).laser && goes_on,
        ..course
    })
}

fn configured(configuration: &Configuration, model: &Model) -> Result<Course, CourseError> {
    let joints = model.place.joints;
    let to = match *configuration {
        Configuration::InitialAngles { rear_deg, fore_deg } => {
            let told = Joints::new(0.0, rear_deg.into(), fore_deg.into(), joints.servo.0);
            let place = Place::at_joints(told, model.tool);
            place.check()?;
            return Ok(Course {
                knows_end: true,
                ..moving(Way::Still, place, model)
            });
        }
        Configuration::EndEffector { tool } => Place::at_joints(joints, tool_named(tool)),
        _ => model.place,
    };
    Ok(moving(Way::Still, to, model))
}

impl Model {
    /// How long the arm waits behind a command, in seconds. A target without a pause of its own
    /// takes the default one, where there is one (note N10).
    #[must_use]
    pub fn pause_s(&self, command: &Command) -> f64 {
        let own_s = match command {
            Command::MoveTo(it) => it.pause_s,
            Command::MoveJoints(it) => it.pause_s,
            _ => return 0.0,
        };
        if own_s > 0.0 || !self.dialect.uses_default_pause {
            own_s.into()
        } else {
            self.settings.default_pause_s
        }
    }

    /// The point that a command names, be it in reach or not: a target, or that far from a place that
    /// is known. `None` where it names none, or a stock arm makes another of it (notes N9 and N18).
    #[must_use]
    pub fn aim(&self, command: &Command) -> Option<Position> {
        let by = |x, y, z| {
            let from = self.knows_place.then_some(self.place.pose.position)?;
            Some(from + position(x, y, z))
        };
        match command {
            Command::MoveTo(it) => Some(position(it.x_mm, it.y_mm, it.z_mm)),
            Command::MoveJoints(it) => Some(forward(&joints(it), self.tool).position),
            Command::WriteVector(it) if !it.stop => by(it.x_mm, it.y_mm, it.z_mm),
            Command::MouseMove(it) if !self.dialect.mouse_swings => by(it.x, it.y, it.z),
            Command::Gesture(it) if !self.dialect.scales_gesture => {
                Some(position(it.x, it.y, it.z))
            }
            Command::Voice(it) => match VoiceOrder::parse(it)? {
                VoiceOrder::Move { x_mm, y_mm, z_mm } => by(x_mm, y_mm, z_mm),
                VoiceOrder::Catch | VoiceOrder::Release => None,
            },
            _ => None,
        }
    }
}

fn joints(target: &MoveJoints) -> Joints {
    let [base, rear, fore, servo] = [
        target.base_deg,
        target.rear_deg,
        target.fore_deg,
        target.servo_deg,
    ]
    .map(f64::from);
    Joints::new(base, rear, fore, servo)
}

fn still(model: &Model) -> Course {
    moving(Way::Still, model.place, model)
}

/// A way by so much from wherever the arm is.
fn relative(way: Way, model: &Model) -> Result<Course, CourseError> {
    let to = way
        .place_at(f64::MAX, model.tool)
        .unwrap_or(Ok(model.place));
    Ok(match to {
        Ok(to) => moving(way, to, model),
        Err(error) => {
            // The arm cannot be there at all: where the way leaves the limits says more.
            moving(way, model.place, model).check()?;
            return Err(error.into());
        }
    })
}

pub(crate) fn moving(way: Way, to: Place, model: &Model) -> Course {
    Course {
        way,
        from: model.place,
        tool: model.tool,
        to,
        pause_s: 0.0,
        burns: model.laser && way != Way::Still,
        is_exact: model.knows_place,
        knows_end: model.knows_place,
        end_speed_mm_s: None,
    }
}

impl Course {
    fn pausing(self, pause_s: f64) -> Self {
        Self { pause_s, ..self }
    }
}

/// A status says where the arm is to that much.
const ON_THE_SPOT_MM: f64 = 0.001;
/// A vector of half that length or less is none (note N16); the rest is for rounding.
const NO_LENGTH_MM: f64 = 0.0002;
/// With the laser off the laser mode of a stock arm accelerates that much faster (note N48).
const RAPID_FACTOR: f64 = 100.0;
/// With less a vector takes for ever, or none of it is done.
const CREEPS_MM_S: f64 = 0.1;
/// What a vector that was braked to rest leaves, in mm/s: a little less than nothing.
const LEFT_BY_OTHERS_MM_S: [f64; 4] = [-0.01, -0.1, -1.0, -3.0];
/// Half a control tick of 20 ms.
const HALF_A_TICK_S: f64 = 0.01;

#[cfg(test)]
mod tests {
    use dobot_arm::Tool;
    use dobot_wire::Dialect;

    use super::*;

    #[test]
    fn a_vector_that_creeps_behind_what_others_may_have_left_is_refused_where_nobody_knows_that() {
        // Laser mode without the laser: a tick is worth 200 mm/s, and half of that is more than the peak of
        // 1.4 mm (118 mm/s) less rounding: no tick accelerates, and 1.4 mm at -0.15 mm/s take -467 ticks.
        let here = Place::at_joints(Joints::new(0.0, 45.0, 45.0, 0.0), Tool::SuctionCup);
        let mut model = Model::standing(Dialect::FIRMWARE_1_1, here);
        model.write_speed_mm_s = 0.8;
        let rapid = Command::from(WriteVector {
            mode: WriteMode::Laser,
            x_mm: 0.0,
            y_mm: -1.4,
            z_mm: 0.0,
            laser: false,
            start_speed_mm_s: 34.0,
            end_speed_mm_s: 40.0,
            max_speed_mm_s: 150.0,
            stop: false,
        });
        assert!(model.course(&rapid).is_ok());
        model.lose_place();
        model.knows_place = true;
        assert_eq!(model.course(&rapid), Err(CourseError::NeverEnds));
    }

    #[test]
    fn a_vector_whose_ticks_add_up_to_less_than_none_is_refused() {
        // Begun at -0.9 mm/s no tick accelerates to 1 mm/s, for a tick is worth 4 mm/s; 0.3 mm at -0.9
        // mm/s take -16 ticks.
        let here = Place::at_joints(Joints::new(0.0, 45.0, 45.0, 0.0), Tool::SuctionCup);
        let mut model = Model::standing(Dialect::FIRMWARE_1_1, here);
        model.settings.write_acceleration_mm_s2 = 200.0;
        model.write_speed_mm_s = -0.9;
        let vector = Command::from(WriteVector {
            mode: WriteMode::Writing,
            x_mm: 0.3,
            y_mm: 0.0,
            z_mm: 0.0,
            laser: false,
            start_speed_mm_s: 0.0,
            end_speed_mm_s: 1.0,
            max_speed_mm_s: 10.0,
            stop: false,
        });
        assert_eq!(model.course(&vector), Err(CourseError::NeverEnds));
    }
}
