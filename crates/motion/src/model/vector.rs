//! The trajectory of a writing or laser vector (state 4).

use crate::{Stroke, StrokeSpeeds, TickStroke};
use dobot_arm::{Pose, Position, TICK_S, stock};
use dobot_wire::{WriteMode, WriteVector};

use super::error::MAX_COUNTED_S;
use super::left_speed::{CREEPS_MM_S, LeftSpeed};
use super::motion::Motion;
use super::place::position;
use super::trajectory::Ticks;
use crate::{ArmPlace, Model, Trajectory, TrajectoryError};

/// Plans a vector from the arm's position.
#[expect(clippy::cast_possible_truncation, reason = "as the arm calculates")]
pub(crate) fn vector(vector: &WriteVector, model: &Model) -> Result<Trajectory, TrajectoryError> {
    let from = model.place.pose;
    let by = position(vector.x_mm, vector.y_mm, vector.z_mm);
    if model.dialect.loses_pose_on_the_spot && by.length().0 <= NO_LENGTH_MM {
        return Err(TrajectoryError::OnTheSpot);
    }
    let speeds = stroke_speeds(vector, model)?;
    let tick_stroke = TickStrokes::of(vector, speeds.acceleration_mm_s2, model);
    let by = tick_stroke
        .as_ref()
        .map_or(by, |strokes| strokes.executed(by));
    let stroke = Stroke::new(from.position, by, &speeds)?;
    if model.dialect.counts_ticks_in_16_bits && stroke.duration_s() > MAX_COUNTED_S {
        let found = stroke.duration_s();
        return Err(TrajectoryError::Uncounted { found });
    }
    let rapid = is_rapid(vector, model);
    if tick_stroke
        .as_ref()
        .is_some_and(|strokes| strokes.may_never_end(rapid))
    {
        return Err(TrajectoryError::NeverEnds);
    }
    if let Some(tick_stroke) = &tick_stroke {
        tick_stroke.check_left(model.settings.write_acceleration_mm_s2 as f32)?;
    }
    let is_flat = model.dialect.has_rapid_laser_mode && vector.mode == WriteMode::Laser;
    let motion = Motion::Stroke {
        stroke,
        rotation: from.rotation,
        held_z: is_flat.then_some(from.position.z),
    };
    let trajectory = Trajectory::relative(motion, model)?;
    let length_mm = by.length().0;
    Ok(Trajectory {
        knows_end: trajectory.knows_end
            && (model.left.is_known()
                || tick_stroke
                    .as_ref()
                    .is_none_or(|strokes| strokes.is_sure(length_mm))),
        to: if model.dialect.uses_start_speed {
            trajectory.to
        } else {
            stock_end(&trajectory, model)
        },
        burns: model.laser_during(vector),
        left: tick_stroke.as_ref().map(TickStrokes::left),
        ticks: tick_stroke.as_ref().map(TickStrokes::ticks),
        ..trajectory
    })
}

/// Returns the position of a stock arm after this displacement in its own arithmetic. At the very
/// edge of the limits, where rounding could move it outside, the exact end is used.
#[expect(clippy::cast_possible_truncation, reason = "as the arm calculates")]
fn stock_end(trajectory: &Trajectory, model: &Model) -> ArmPlace {
    let [from, to] = [trajectory.from, trajectory.to].map(|place| place.pose.position);
    let way = to - from;
    let way = [way.x, way.y, way.z].map(|mm| mm.0 as f32);
    let from = [from.x, from.y, from.z].map(|mm| mm.0);
    let [x, y, z] = stock::behind(from, way, model.tool.reach().0 as f32);
    let pose = Pose {
        position: Position::new(x, y, z),
        ..trajectory.to.pose
    };
    let place = ArmPlace::at_pose(pose, model.tool).ok();
    place
        .filter(|place| place.check().is_ok())
        .unwrap_or(trajectory.to)
}

/// The possible ticks of a vector on an arm that divides it into ticks and keeps the last speed for
/// the next vector (note N48).
struct TickStrokes {
    believed: TickStroke,
    /// The other possibilities.
    perhaps: Option<[TickStroke; 3]>,
}

impl TickStrokes {
    #[expect(clippy::cast_possible_truncation, reason = "as the arm calculates")]
    fn of(vector: &WriteVector, acceleration_mm_s2: f64, model: &Model) -> Option<Self> {
        let [x, y, z] = [vector.x_mm, vector.y_mm, vector.z_mm];
        let tick_stroke = |left_mm_s| {
            TickStroke::of(
                libm::sqrtf(x * x + y * y + z * z),
                left_mm_s,
                vector.end_speed_mm_s,
                vector.max_speed_mm_s,
                acceleration_mm_s2 as f32,
            )
        };
        (!model.dialect.uses_start_speed).then(|| Self {
            believed: tick_stroke(model.left.believed_mm_s),
            perhaps: model
                .left
                .perhaps_mm_s
                .map(|speeds| speeds.map(tick_stroke)),
        })
    }

    /// Returns the vector as executed if its ticks are known and do not add up to its length.
    fn executed(&self, by: Position) -> Position {
        if self.perhaps.is_some() || self.believed.is_exact() {
            return by;
        }
        by * (f64::from(self.believed.length_mm()) / by.length().0)
    }

    /// Whether the vector has its length with every speed that may have been left.
    fn is_sure(&self, length_mm: f64) -> bool {
        let mut perhaps = self.perhaps.iter().flatten().chain([&self.believed]);
        perhaps.all(|stroke| (f64::from(stroke.length_mm()) - length_mm).abs() <= SURE_MM)
    }

    /// Whether the arm could creep forever. Speeds left by others count only if that is likely:
    /// with a rapid vector, in which a tick changes the speed a hundred times more.
    fn may_never_end(&self, rapid: bool) -> bool {
        let perhaps = self.perhaps.iter().flatten().filter(|_| rapid);
        perhaps
            .chain([&self.believed])
            .any(|stroke| stroke.ticks() <= 0)
    }

    /// Checks that a writing mode vector after this one does not move back: begun below zero, it
    /// first moves backwards until it has accelerated.
    fn check_left(&self, acceleration_mm_s2: f32) -> Result<(), TrajectoryError> {
        let left_mm_s = self.believed.end_mm_s;
        let back_mm = left_mm_s * left_mm_s / (2.0 * acceleration_mm_s2);
        if left_mm_s < 0.0 && back_mm > BACK_MM {
            return Err(TrajectoryError::LeavesBackwards { left_mm_s, back_mm });
        }
        Ok(())
    }

    fn ticks(&self) -> Ticks {
        let believed = self.believed.ticks();
        let perhaps = self.perhaps.iter().flatten().map(TickStroke::ticks);
        Ticks {
            believed,
            most: perhaps.fold(believed, i16::max),
        }
    }

    fn left(&self) -> LeftSpeed {
        LeftSpeed {
            believed_mm_s: self.believed.end_mm_s,
            perhaps_mm_s: self
                .perhaps
                .map(|strokes| strokes.map(|tick_stroke| tick_stroke.end_mm_s)),
        }
    }
}

/// Returns the speeds of a stroke; values above the maximum count as the maximum (note N5).
fn stroke_speeds(vector: &WriteVector, model: &Model) -> Result<StrokeSpeeds, TrajectoryError> {
    let max_mm_s = f64::from(vector.max_speed_mm_s);
    let start_mm_s = if model.dialect.uses_start_speed {
        vector.start_speed_mm_s.into()
    } else {
        // The arm may keep slightly less than zero after braking in a short vector.
        f64::from(model.left.believed_mm_s).max(0.0)
    };
    let speeds = StrokeSpeeds {
        start_mm_s: f64::min(start_mm_s, max_mm_s),
        end_mm_s: f64::from(vector.end_speed_mm_s).min(max_mm_s),
        max_mm_s,
        acceleration_mm_s2: model.settings.write_acceleration_mm_s2,
    };
    if is_rapid(vector, model) {
        rapid(&speeds, model.left.may_creep())
    } else {
        Ok(speeds)
    }
}

/// Whether it is a laser mode vector without the laser, which a stock arm accelerates a hundredfold
/// (note N48).
fn is_rapid(vector: &WriteVector, model: &Model) -> bool {
    model.dialect.has_rapid_laser_mode && vector.mode == WriteMode::Laser && !vector.laser
}

/// Scales the acceleration: without the laser, laser mode accelerates a hundredfold (note N48).
fn rapid(speeds: &StrokeSpeeds, may_creep: bool) -> Result<StrokeSpeeds, TrajectoryError> {
    let acceleration_mm_s2 = speeds.acceleration_mm_s2 * RAPID_FACTOR;
    let least_mm_s = acceleration_mm_s2 * TICK_S / 2.0;
    if speeds.max_mm_s >= least_mm_s {
        return Ok(StrokeSpeeds {
            acceleration_mm_s2,
            ..*speeds
        });
    }
    // Below half of the speed change of a tick no tick accelerates: the vector continues at its
    // initial speed, and at rest it stays there, as it may with an unknown initial speed.
    let begin_mm_s = speeds.start_mm_s;
    if begin_mm_s < CREEPS_MM_S || may_creep {
        return Err(TrajectoryError::SlowRapid {
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

/// A vector of half this length or less does not move the arm (note N16); the rest is for rounding.
const NO_LENGTH_MM: f64 = 0.0002;
/// The distance that a vector may move back first: less than the travel of a tick at 40 mm/s.
const BACK_MM: f32 = 0.5;
/// The deviation up to which an end counts as known.
const SURE_MM: f64 = 0.05;
/// The acceleration factor of laser mode with the laser off on a stock arm (note N48).
const RAPID_FACTOR: f64 = 100.0;

#[cfg(test)]
mod tests {
    use dobot_arm::{Joints, Tool};
    use dobot_wire::{Command, Dialect};

    use super::*;

    #[test]
    fn a_vector_that_creeps_behind_what_others_may_have_left_is_refused_where_nobody_knows_that() {
        // Laser mode without the laser: a tick changes 200 mm/s, and half of that exceeds the peak
        // of 1.4 mm (118 mm/s) less rounding: no tick accelerates, and 1.4 mm at -0.15 mm/s take
        // -467 ticks.
        let here = ArmPlace::at_joints(Joints::new(0.0, 45.0, 45.0, 0.0), Tool::SuctionCup);
        let mut model = Model::standing(Dialect::FIRMWARE_1_1, here);
        model.left = LeftSpeed::known(0.8);
        let rapid = Command::from(WriteVector {
            mode: WriteMode::Laser,
            start_speed_mm_s: 34.0,
            end_speed_mm_s: 40.0,
            ..WriteVector::by(0.0, -1.4, 0.0, 150.0)
        });
        assert!(model.trajectory(&rapid).is_ok());
        model.lose_place();
        model.knows_place = true;
        assert_eq!(model.trajectory(&rapid), Err(TrajectoryError::NeverEnds));
    }

    #[test]
    fn where_nobody_knows_how_it_begins_a_slow_rapid_vector_is_refused_and_the_end_of_a_short_one_is_not_known()
     {
        let here = ArmPlace::at_joints(Joints::new(0.0, 45.0, 45.0, 0.0), Tool::SuctionCup);
        let mut model = Model::standing(Dialect::FIRMWARE_1_1, here);
        model.left = LeftSpeed::known(40.0);
        // Below 100 mm/s no tick changes the speed: it stays at the possible initial 10 mm/s.
        let mut vector = WriteVector {
            mode: WriteMode::Laser,
            end_speed_mm_s: 10.0,
            ..WriteVector::by(0.0, -3.1, 0.0, 10.0)
        };
        assert!(model.trajectory(&vector.into()).is_ok());
        model.left = model.left.perhaps();
        let refused = model.trajectory(&vector.into());
        assert!(
            matches!(refused, Err(TrajectoryError::SlowRapid { .. })),
            "{refused:?}"
        );
        // At 145 mm/s2 a tick changes 2.9 mm/s, and 1 mm/s is less than half of that: no tick
        // accelerates, and with slightly negative speed the arm moves back.
        model.settings.write_acceleration_mm_s2 = 145.0;
        vector.mode = WriteMode::Writing;
        (vector.y_mm, vector.max_speed_mm_s, vector.end_speed_mm_s) = (-0.4, 1.0, 0.0);
        let trajectory = model.trajectory(&vector.into()).expect("it may be sent");
        assert_eq!(trajectory.end(), None);
        model.left = LeftSpeed::known(0.5);
        let trajectory = model.trajectory(&vector.into()).expect("it may be sent");
        assert!(trajectory.end().is_some());
    }

    #[test]
    fn a_vector_behind_which_the_next_one_would_go_far_back_is_refused() {
        // Laser mode without the laser: one slower tick is 200 mm/s less. Begun at 57.5 mm/s, 26.76
        // mm take 25 ticks and that one, which ends near -141 mm/s; from there to rest at 100 mm/s2
        // are 99 mm.
        let here = ArmPlace::at_joints(Joints::new(0.0, 45.0, 45.0, 0.0), Tool::SuctionCup);
        let mut model = Model::standing(Dialect::FIRMWARE_1_1, here);
        model.left = LeftSpeed::known(57.5);
        let rapid = WriteVector {
            mode: WriteMode::Laser,
            ..WriteVector::by(0.0, 26.764, 0.0, 150.0)
        };
        let trajectory = model.trajectory(&rapid.into());
        let Err(TrajectoryError::LeavesBackwards { left_mm_s, back_mm }) = trajectory else {
            panic!("{trajectory:?}");
        };
        assert!((left_mm_s + 141.0).abs() < 1.0, "{left_mm_s}");
        assert!((back_mm - 99.0).abs() < 1.5, "{back_mm}");
        let written = WriteVector {
            mode: WriteMode::Writing,
            ..rapid
        };
        assert!(model.trajectory(&written.into()).is_ok());
    }

    #[test]
    fn a_vector_with_a_negative_number_of_ticks_is_refused() {
        // Begun at -0.9 mm/s no tick accelerates to 1 mm/s, because a tick changes 4 mm/s; 0.3 mm
        // at -0.9 mm/s take -16 ticks.
        let here = ArmPlace::at_joints(Joints::new(0.0, 45.0, 45.0, 0.0), Tool::SuctionCup);
        let mut model = Model::standing(Dialect::FIRMWARE_1_1, here);
        model.settings.write_acceleration_mm_s2 = 200.0;
        model.left = LeftSpeed::known(-0.9);
        let vector = Command::from(WriteVector {
            end_speed_mm_s: 1.0,
            ..WriteVector::by(0.3, 0.0, 0.0, 10.0)
        });
        assert_eq!(model.trajectory(&vector), Err(TrajectoryError::NeverEnds));
    }
}
