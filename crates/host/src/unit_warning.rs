//! Targets that look as if they were in other units.

use std::f32::consts::PI;
use std::fmt;

use crate::TargetPlace;

/// The warning about a target that looks as if it were in radians or metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UnitWarning(TargetPlace);

impl TargetPlace {
    /// Returns a warning if joint angles look like radians, or a point like metres: all values are small,
    /// and not all are whole numbers.
    ///
    /// ```
    /// use dobot_host::TargetPlace;
    ///
    /// let warning = TargetPlace::Joints([0.0, 0.7, 0.7]).unit_warning();
    /// assert_eq!(
    ///     warning.map(|warning| warning.to_string()).as_deref(),
    ///     Some("the joint angles 0 0.7 0.7 look like radians; they are degrees: for these radians use 0 40.1 40.1"),
    /// );
    /// assert_eq!(TargetPlace::Joints([0.0, 45.0, 45.0]).unit_warning(), None);
    /// ```
    #[must_use]
    pub fn unit_warning(&self) -> Option<UnitWarning> {
        let (values, largest) = match *self {
            Self::Point { mm, .. } => (mm, LARGEST_M),
            Self::Joints(joints_deg) => (joints_deg, PI),
        };
        let is_small = values.iter().all(|value| value.abs() <= largest);
        let is_whole = values.iter().all(|value| value.fract() == 0.0);
        (is_small && !is_whole).then_some(UnitWarning(*self))
    }
}

impl fmt::Display for UnitWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            TargetPlace::Point { mm, .. } => write!(
                f,
                "the point {} looks like metres; it is in millimetres: for these metres use {}",
                list(mm),
                list(mm.map(|m| tenths(m * 1000.0))),
            ),
            TargetPlace::Joints(joints_deg) => write!(
                f,
                "the joint angles {} look like radians; they are degrees: for these radians use {}",
                list(joints_deg),
                list(joints_deg.map(|rad| tenths(rad.to_degrees()))),
            ),
        }
    }
}

fn list(values: [f32; 3]) -> String {
    values.map(|value| value.to_string()).join(" ")
}

/// Rounds to a tenth.
fn tenths(value: f32) -> f32 {
    (value * 10.0).round() / 10.0
}

/// The largest coordinate that looks like metres: the arm reaches less far, and no point so near to the base.
const LARGEST_M: f32 = 1.0;

#[cfg(test)]
mod tests {
    use super::*;

    fn of_point(mm: [f32; 3]) -> Option<String> {
        let place = TargetPlace::Point {
            mm,
            rotation_deg: None,
        };
        place.unit_warning().map(|warning| warning.to_string())
    }

    #[test]
    fn a_point_in_metres_is_named_with_its_millimetres() {
        assert_eq!(
            of_point([0.22, 0.0, -0.05]).as_deref(),
            Some(
                "the point 0.22 0 -0.05 looks like metres; it is in millimetres: for these metres use 220 0 -50"
            )
        );
    }

    #[test]
    fn points_and_angles_in_the_arms_units_pass() {
        assert_eq!(of_point([220.0, 0.5, 0.5]), None);
        assert_eq!(of_point([0.0, 0.0, 0.0]), None);
        assert_eq!(TargetPlace::Joints([0.0, 2.0, 3.0]).unit_warning(), None);
        assert_eq!(TargetPlace::Joints([0.5, 2.0, 30.0]).unit_warning(), None);
    }
}
