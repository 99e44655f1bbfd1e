//! Recorded paths, reduced to the fewest points within a tolerance.

use dobot_arm::Position;
use dobot_geometry::distance_from_chord;
use dobot_wire::{MovingMode, Status};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use toml::Spanned;

use crate::axes::Axes;
use crate::{Action, Go, Here, Place, Point};

/// A place of a path: the position and the state of the tool.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RecordedPlace {
    /// x, y and z, in millimetres in the base frame.
    pub point_mm: [f64; 3],
    /// The rotation of the tool in the base frame, in degrees.
    pub rotation_deg: f64,
    /// Whether the pump runs.
    pub suction: bool,
    /// The gripper's angle, in degrees.
    pub gripper_deg: f64,
}

impl RecordedPlace {
    /// The place that a status reports.
    #[must_use]
    pub fn of(status: &Status) -> Self {
        Self {
            point_mm: [status.x_mm, status.y_mm, status.z_mm].map(f64::from),
            rotation_deg: status.rotation_deg.into(),
            suction: status.suction,
            gripper_deg: status.gripper_deg.into(),
        }
    }

    /// The point, rounded to a hundredth of a millimetre and of a degree, which is finer than the
    /// arm's resolution.
    #[must_use]
    pub fn point(&self) -> Point {
        Point::Cartesian {
            position: self.point_mm.map(|point_mm| rounded(point_mm, 100.0)),
            rotation: Some(rounded(self.rotation_deg, 100.0)).filter(|rotation| *rotation != 0.0),
            frame: None,
        }
    }

    /// The point in a frame.
    pub(crate) fn point_in(&self, frame: &str, axes: &Axes) -> Point {
        let [x, y, z] = self.point_mm;
        let position = axes.locate(Position::new(x, y, z));
        let turned = (self.rotation_deg - axes.rotation_deg() + 180.0).rem_euclid(360.0) - 180.0;
        Point::Cartesian {
            position: position.map(|along_mm| rounded(along_mm, 100.0)),
            rotation: Some(rounded(turned, 100.0)).filter(|rotation| *rotation != 0.0),
            frame: Some(frame.to_owned()),
        }
    }

    /// The place of the tip of a tool that is this long, in mm.
    #[must_use]
    pub fn tip(self, length_mm: f64) -> Self {
        let [x, y, z] = self.point_mm;
        Self {
            point_mm: [x, y, z - length_mm],
            ..self
        }
    }

    /// Whether the tool has the same state at both places.
    fn has_tool_of(&self, other: &Self) -> bool {
        self.suction == other.suction && self.gripper_deg == other.gripper_deg
    }

    /// Point and rotation as one vector; a degree counts as a millimetre.
    fn joined(&self) -> [f64; 4] {
        let [x, y, z] = self.point_mm;
        [x, y, z, self.rotation_deg]
    }
}

/// Simplifies a path by the Ramer-Douglas-Peucker algorithm: straight lines between the remaining
/// places stay within the tolerance, in millimetres for the point and in degrees for the rotation
/// together. The first and the last place remain, and those where the state of the tool changes.
///
/// ```text
///                  far .
///                   .     .            the place that is farthest from the chord
///        from *-------------------* to splits it, until none is farther than the tolerance
/// ```
#[must_use]
pub fn simplified(places: &[RecordedPlace], tolerance: f64) -> Vec<RecordedPlace> {
    let mut kept = vec![false; places.len()];
    let mut spans = vec![(0, places.len().saturating_sub(1))];
    if let [first, .., last] = &mut kept[..] {
        (*first, *last) = (true, true);
    } else {
        kept.fill(true);
    }
    while let Some((from, to)) = spans.pop() {
        if let Some(at) = split(places, from, to, tolerance) {
            kept[at] = true;
            spans.extend([(from, at), (at, to)]);
        }
    }
    let places = places.iter().zip(kept);
    places
        .filter_map(|(place, kept)| kept.then_some(*place))
        .collect()
}

/// The index at which a chord must be split: where the tool changes first, else at the place
/// farthest from it, if that is too far.
fn split(places: &[RecordedPlace], from: usize, to: usize, tolerance: f64) -> Option<usize> {
    let mut between = from + 1..to;
    let changes = |at: &usize| {
        !places[*at].has_tool_of(&places[*at - 1]) || !places[*at].has_tool_of(&places[*at + 1])
    };
    if let Some(at) = between.clone().find(changes) {
        return Some(at);
    }
    let (a, b) = (places.get(from)?.joined(), places.get(to)?.joined());
    let far = |at: usize| distance_from_chord(places[at].joined(), a, b);
    let farthest = between.next().map(|first| {
        between.fold((first, far(first)), |best, at| {
            let found = far(at);
            if found > best.1 { (at, found) } else { best }
        })
    });
    farthest
        .filter(|farthest| farthest.1 > tolerance)
        .map(|farthest| farthest.0)
}

/// The state of the tool at a position in a program.
#[derive(Clone, Copy, Debug, Default)]
pub struct ToolState {
    /// Whether the pump runs.
    pub suction: bool,
    /// The gripper's angle, in degrees.
    pub gripper_deg: f64,
}

impl ToolState {
    /// The state after these steps, executed in order from the start of a program.
    #[must_use]
    pub fn behind(steps: &[Spanned<Action>]) -> Self {
        let thens = steps.iter().filter_map(|step| match step.get_ref() {
            Action::Go(go) => Some(go.then),
            Action::Here(here) => Some(*here),
            _ => None,
        });
        thens.fold(Self::default(), Self::after)
    }

    /// The state after an action.
    #[must_use]
    pub fn after(self, here: Here) -> Self {
        Self {
            suction: here.suction.unwrap_or(self.suction),
            gripper_deg: here.gripper.unwrap_or(self.gripper_deg),
        }
    }

    /// The settings that change the tool to the state at a place.
    #[must_use]
    pub fn changes_to(self, place: &RecordedPlace) -> Here {
        let gripper = rounded(place.gripper_deg, 10.0);
        Here {
            suction: Some(place.suction).filter(|suction| *suction != self.suction),
            gripper: Some(gripper).filter(|gripper| *gripper != self.gripper_deg),
            pause: None,
        }
    }
}

/// Steps along a recorded path: straight lines through its places. Where only the tool changes, it is switched
/// on the spot, since a stock arm loses its pose on a straight line of no length (note N34).
#[must_use]
pub fn path_steps(places: &[RecordedPlace], mut before: ToolState) -> Vec<Action> {
    let mut here = None;
    let step = |place: &RecordedPlace| {
        let then = before.changes_to(place);
        before = before.after(then);
        let point = place.point();
        if here.replace(point.clone()).as_ref() == Some(&point) {
            return (then != Here::default()).then_some(Action::Here(then));
        }
        Some(Action::Go(Go {
            path: MovingMode::MovL,
            then,
            ..Go::to(Place::At(point))
        }))
    };
    places.iter().filter_map(step).collect()
}

/// Rounds to parts of one; replaces a negative zero by zero.
pub(crate) fn rounded(number: f64, parts: f64) -> f64 {
    (number * parts).round() / parts + 0.0
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn place(point_mm: [f64; 3]) -> RecordedPlace {
        RecordedPlace {
            point_mm,
            rotation_deg: 0.0,
            suction: false,
            gripper_deg: 0.0,
        }
    }

    #[test]
    fn a_straight_line_with_a_corner_becomes_three_places() {
        let out = (0..=50).map(|i| place([200.0 + f64::from(i), 0.0, 0.0]));
        let up = (1..=30).map(|i| place([250.0, 0.0, f64::from(i)]));
        let path: Vec<RecordedPlace> = out.chain(up).collect();
        let corners = [[200.0, 0.0, 0.0], [250.0, 0.0, 0.0], [250.0, 0.0, 30.0]].map(place);
        assert_eq!(simplified(&path, 0.1), corners);
    }

    #[test]
    fn the_number_of_chords_of_a_quarter_circle_follows_from_its_tolerance() {
        let at = |deg: f64| {
            let (sin, cos) = deg.to_radians().sin_cos();
            place([200.0 * cos, 200.0 * sin, 0.0])
        };
        let path: Vec<RecordedPlace> = (0..=900).map(|i| at(f64::from(i) / 10.0)).collect();
        // A chord of angle a is r (1 - cos(a / 2)) off: 1 mm of 200 mm allows 11.5 degrees. Halving
        // 90 degrees gives 11.25 in the end, which is 8 chords.
        assert_eq!(simplified(&path, 1.0).len(), 9);
    }

    #[test]
    fn a_tool_is_switched_on_the_spot_without_a_line_of_no_length() {
        let there = place([200.0, 0.0, 0.0]);
        let switched = RecordedPlace {
            suction: true,
            ..there
        };
        let steps = path_steps(&[there, there, switched, switched], ToolState::default());
        let on = Here {
            suction: Some(true),
            ..Here::default()
        };
        assert!(matches!(steps[0], Action::Go(_)));
        assert_eq!(steps[1..], [Action::Here(on)]);
    }

    #[test]
    fn a_switch_of_the_pump_is_kept_even_on_a_straight_line() {
        let mut path: Vec<RecordedPlace> =
            (0..10).map(|i| place([f64::from(i), 0.0, 0.0])).collect();
        for place in &mut path[6..] {
            place.suction = true;
        }
        let kept = simplified(&path, 1.0);
        assert_eq!(kept, [path[0], path[5], path[6], path[9]]);
    }

    #[test]
    fn a_turn_of_the_tool_on_the_spot_stays() {
        let turned = |rotation_deg| RecordedPlace {
            rotation_deg,
            ..place([200.0, 0.0, 0.0])
        };
        let path = [0.0, 15.0, 30.0, 15.0, 0.0].map(turned);
        let kept = simplified(&path, 0.5);
        assert_eq!(kept, [turned(0.0), turned(30.0), turned(0.0)]);
    }

    #[test]
    fn nothing_and_a_single_place_stay_as_they_are() {
        assert_eq!(simplified(&[], 1.0), []);
        let one = place([1.0, 2.0, 3.0]);
        assert_eq!(simplified(&[one], 1.0), [one]);
    }

    proptest! {
        #[test]
        fn no_place_is_farther_from_the_lines_than_the_tolerance(
            points in prop::collection::vec((prop::array::uniform3(-300.0..300.0), -90.0..90.0), 1..60),
            tolerance in 0.0..50.0_f64,
        ) {
            let path: Vec<RecordedPlace> = points
                .into_iter()
                .map(|(point_mm, rotation_deg)| RecordedPlace { rotation_deg, ..place(point_mm) })
                .collect();
            let kept = simplified(&path, tolerance);
            prop_assert_eq!((kept.first(), kept.last()), (path.first(), path.last()));
            for place in &path {
                let near = kept.windows(2).any(|ends| {
                    distance_from_chord(place.joined(), ends[0].joined(), ends[1].joined()) <= tolerance + 1e-9
                });
                prop_assert!(near || kept.contains(place));
            }
        }
    }
}
