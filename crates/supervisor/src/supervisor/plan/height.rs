//! Height changes of a job relative to its plan.

use dobot_wire::{Command, WriteMode, WriteVector, single};

/// Tracks the height of a job above its plan, command by command.
///
/// A change is spread over the vectors so that no stroke has a step; it is applied in full where
/// the pen goes up or down anyway, and not at all where a laser burns, because a stock arm keeps
/// its height there (note N48). Targets are absolute and shifted as a whole.
#[derive(Clone, Copy, Debug)]
pub(super) struct Height {
    /// The current height above the plan, in mm.
    pub(super) raised_mm: f64,
    /// The wanted height above the plan, in mm.
    pub(super) offset_mm: f64,
    /// The largest part of a change per vector, as a share of its length.
    slope: f64,
}

impl Height {
    /// Starts at the planned height.
    pub(super) const fn planned(burns: bool) -> Self {
        Self {
            raised_mm: 0.0,
            offset_mm: 0.0,
            slope: if burns { TRAVEL_SLOPE } else { PEN_SLOPE },
        }
    }

    /// Applies the current height to the next command.
    pub(super) fn apply(&mut self, command: &Command) -> Command {
        match command {
            Command::WriteVector(vector) if takes_height(vector) => self.vector(*vector).into(),
            Command::MoveTo(planned) if self.offset_mm != 0.0 => {
                let z_mm = single(f64::from(planned.z_mm) + self.offset_mm);
                self.raised_mm = f64::from(z_mm) - f64::from(planned.z_mm);
                let mut target = *planned;
                target.z_mm = z_mm;
                target.into()
            }
            Command::MoveTo(_) | Command::MoveJoints(_) => {
                self.raised_mm = 0.0;
                *command
            }
            _ => *command,
        }
    }

    fn vector(&mut self, vector: WriteVector) -> WriteVector {
        let missing_mm = self.offset_mm - self.raised_mm;
        if missing_mm.abs() < ENOUGH_MM {
            return vector;
        }
        let most_mm = self.most_mm(&vector, missing_mm);
        let planned_mm = f64::from(vector.z_mm);
        let z_mm = single(planned_mm + missing_mm.clamp(-most_mm, most_mm));
        self.raised_mm += f64::from(z_mm) - planned_mm;
        WriteVector { z_mm, ..vector }
    }

    /// Returns the largest change for a vector. A vertical vector takes the whole change unless
    /// hardly any length would be left: a zero-length vector makes a stock arm lose its pose (note
    /// N51).
    fn most_mm(&self, vector: &WriteVector, missing_mm: f64) -> f64 {
        let [x, y, z] = [vector.x_mm, vector.y_mm, vector.z_mm].map(f64::from);
        let rests = vector.start_speed_mm_s == 0.0 && vector.end_speed_mm_s == 0.0;
        if x == 0.0 && y == 0.0 && rests {
            let longer = missing_mm * z > 0.0;
            return if longer { f64::MAX } else { z.abs() / 2.0 };
        }
        self.slope * (x * x + y * y + z * z).sqrt()
    }
}

fn takes_height(vector: &WriteVector) -> bool {
    vector.mode == WriteMode::Writing && !vector.laser && !vector.stop
}

/// A slope this small is not visible in a stroke.
const PEN_SLOPE: f64 = 0.05;
/// With the laser off nothing is drawn.
const TRAVEL_SLOPE: f64 = 0.5;
/// A hundredth of the resolution of a status.
const ENOUGH_MM: f64 = 1e-5;

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn vector([x_mm, y_mm, z_mm]: [f32; 3]) -> WriteVector {
        WriteVector::by(x_mm, y_mm, z_mm, 40.0)
    }

    fn z_mm(height: &mut Height, vector: WriteVector) -> f64 {
        match height.apply(&vector.into()) {
            Command::WriteVector(vector) => vector.z_mm.into(),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn a_stroke_rises_gently_and_a_lift_takes_the_rest() {
        let mut height = Height::planned(false);
        height.offset_mm = 1.0;
        let drawn_mm = z_mm(&mut height, vector([10.0, 0.0, 0.0]));
        assert!((drawn_mm - 0.5).abs() < 1e-6, "{drawn_mm}");
        let lifted_mm = z_mm(&mut height, vector([0.0, 0.0, 5.0]));
        assert!((lifted_mm - 5.5).abs() < 1e-6, "{lifted_mm}");
        assert_eq!(z_mm(&mut height, vector([10.0, 0.0, 0.0])), 0.0);
    }

    #[test]
    fn burning_strokes_are_unchanged() {
        let mut height = Height::planned(true);
        height.offset_mm = 1.0;
        let burning = WriteVector {
            mode: WriteMode::Laser,
            laser: true,
            ..vector([10.0, 0.0, 0.0])
        };
        assert_eq!(height.apply(&burning.into()), Command::from(burning));
        assert_eq!(height.raised_mm, 0.0);
    }

    proptest! {
        #[test]
        fn the_offset_is_the_added_height_of_the_vectors_and_none_of_them_vanishes(
            offset_mm in -5.0..5.0_f64,
            increments in prop::collection::vec(
                (-20.0..20.0_f32, -20.0..20.0_f32, prop_oneof![Just(0.0_f32), -9.0..9.0_f32], any::<bool>()),
                1..60,
            ),
        ) {
            let mut height = Height::planned(false);
            height.offset_mm = offset_mm;
            let mut higher_mm = 0.0;
            for (x, y, z, upright) in increments {
                let planned = vector(if upright { [0.0, 0.0, z] } else { [x, y, z] });
                let length = |z: f64| f64::from(planned.x_mm).hypot(planned.y_mm.into()).hypot(z);
                let before_mm = length(planned.z_mm.into());
                let z_mm = z_mm(&mut height, planned);
                higher_mm += z_mm - f64::from(planned.z_mm);
                prop_assert!(length(z_mm) >= 0.49 * before_mm);
                prop_assert!((height.raised_mm - higher_mm).abs() < 1e-9);
                prop_assert!(higher_mm.abs() <= offset_mm.abs() + 1e-5);
            }
        }
    }
}
