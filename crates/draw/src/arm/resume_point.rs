//! The resume point of an interrupted drawing.

use std::str::FromStr;

use dobot_geometry::Stroke;
use dobot_plan::{DrawingTool, Pass};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// The resume point of an interrupted drawing: `layer:NAME`, `stroke:NUMBER` or a share such as
/// `40%`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "String", into = "String")]
pub enum ResumePoint {
    /// A pass: its name, or its number from 1.
    Pass(String),
    /// A stroke, counted from 1 through all passes including repeated burns of a laser.
    Stroke(usize),
    /// The drawn share of the total length including repeated burns, in percent, from 0 to below
    /// 100. It may lie within a stroke.
    Percent(f64),
}

impl ResumePoint {
    /// Returns the rest of the drawing. A partially drawn pass keeps its message, because its pen
    /// must be inserted again.
    ///
    /// # Errors
    ///
    /// [`ResumePointError`] with the allowed values.
    pub fn rest_of(&self, passes: Vec<Pass>) -> Result<Vec<Pass>, ResumePointError> {
        match self {
            Self::Pass(pass) => from_pass(passes, pass),
            Self::Stroke(stroke) => from_stroke(passes, *stroke),
            Self::Percent(percent) => from_percent(passes, *percent),
        }
    }
}

impl FromStr for ResumePoint {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let expected = "expected layer:NAME, stroke:NUMBER or a share such as 40%";
        if let Some(percent) = text.strip_suffix('%') {
            return percent.parse().map(Self::Percent).map_err(|_| expected);
        }
        match text.split_once(':') {
            Some(("layer", name)) => Ok(Self::Pass(name.to_owned())),
            Some(("stroke", number)) => number.parse().map(Self::Stroke).map_err(|_| expected),
            _ => Err(expected),
        }
    }
}

impl TryFrom<String> for ResumePoint {
    type Error = &'static str;

    fn try_from(text: String) -> Result<Self, Self::Error> {
        text.parse()
    }
}

impl From<ResumePoint> for String {
    fn from(from: ResumePoint) -> Self {
        match from {
            ResumePoint::Pass(name) => format!("layer:{name}"),
            ResumePoint::Stroke(number) => format!("stroke:{number}"),
            ResumePoint::Percent(percent) => format!("{percent}%"),
        }
    }
}

/// The error returned when a drawing has no such resume point.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum ResumePointError {
    /// There is no such pass.
    #[error("there is no pass '{found}' to resume at; the passes are: {}", numbered(.names))]
    Pass {
        /// The requested pass.
        found: String,
        /// The names of the passes.
        names: Vec<String>,
    },
    /// There is no such stroke.
    #[error("there is no stroke {found} to resume at; allowed are 1 to {strokes}")]
    Stroke {
        /// The requested stroke.
        found: usize,
        /// The number of strokes.
        strokes: usize,
    },
    /// The share is out of range.
    #[error("a drawing cannot resume at {0} %; allowed are 0 to below 100")]
    Percent(f64),
}

/// A name takes precedence over a number: a pass may be called "2".
fn from_pass(mut passes: Vec<Pass>, pass: &str) -> Result<Vec<Pass>, ResumePointError> {
    let by_number = || {
        let number: usize = pass.parse().ok()?;
        number.checked_sub(1).filter(|&index| index < passes.len())
    };
    let by_name = passes.iter().position(|other| other.name == pass);
    let Some(first) = by_name.or_else(by_number) else {
        return Err(ResumePointError::Pass {
            found: pass.to_owned(),
            names: passes.into_iter().map(|pass| pass.name).collect(),
        });
    };
    Ok(passes.split_off(first))
}

fn from_stroke(passes: Vec<Pass>, stroke: usize) -> Result<Vec<Pass>, ResumePointError> {
    let strokes = passes.iter().map(|pass| pass.drawn().count()).sum();
    if !(1..=strokes).contains(&stroke) {
        let found = stroke;
        return Err(ResumePointError::Stroke { found, strokes });
    }
    Ok(after(passes, stroke - 1, 0.0))
}

fn from_percent(passes: Vec<Pass>, percent: f64) -> Result<Vec<Pass>, ResumePointError> {
    if !(0.0..100.0).contains(&percent) {
        return Err(ResumePointError::Percent(percent));
    }
    let all = passes.iter().flat_map(Pass::drawn);
    let lengths: Vec<f64> = all.map(Stroke::length_mm).collect();
    let mut drawn_mm = lengths.iter().sum::<f64>() * percent / 100.0;
    let whole = lengths.iter().take_while(|&&length_mm| {
        let over = drawn_mm > 0.0 && length_mm <= drawn_mm;
        drawn_mm -= if over { length_mm } else { 0.0 };
        over
    });
    let whole = whole.count();
    Ok(after(passes, whole, drawn_mm))
}

/// Returns the passes without the first strokes and the first part of the next one, in drawing
/// order. Empty passes are omitted.
fn after(passes: Vec<Pass>, mut strokes: usize, mut drawn_mm: f64) -> Vec<Pass> {
    let mut rest = Vec::new();
    for pass in passes {
        let count = pass.drawn().count();
        if strokes < count {
            rest.extend(rest_of_pass(&pass, strokes, drawn_mm));
            (strokes, drawn_mm) = (0, 0.0);
        } else {
            strokes -= count;
        }
    }
    rest
}

/// Returns the rest of a pass after some strokes and a part of the next one. Repeated burns of a
/// laser become several passes: the rest of the interrupted repetition, and the remaining
/// repetitions.
fn rest_of_pass(pass: &Pass, drawn: usize, drawn_mm: f64) -> Vec<Pass> {
    let (count, times) = (pass.strokes.len(), pass.tool.times());
    let by_stroke = matches!(pass.tool, DrawingTool::Laser(laser) if laser.by_stroke);
    let (first, done) = if by_stroke {
        (drawn / times as usize, drawn % times as usize)
    } else {
        (drawn % count, drawn / count)
    };
    let left = times - u32::try_from(done).unwrap_or(times);
    let (all, to_come) = (&pass.strokes[..], &pass.strokes[first..]);
    let begun = drawn_mm > 0.0;
    let rest = if begun {
        rest_of_stroke(&to_come[0], drawn_mm)
    } else {
        to_come[0].clone()
    };
    let parts = if by_stroke && done == 0 && !begun {
        vec![(to_come.to_vec(), times)]
    } else if by_stroke {
        let again = left - u32::from(begun);
        vec![
            (vec![rest], u32::from(begun)),
            (to_come[..1].to_vec(), again),
            (to_come[1..].to_vec(), times),
        ]
    } else {
        let is_begun = first > 0 || begun;
        vec![
            ([&[rest], &to_come[1..]].concat(), u32::from(is_begun)),
            (all.to_vec(), left - u32::from(is_begun)),
        ]
    };
    let parts = parts
        .into_iter()
        .filter(|part| !part.0.is_empty() && part.1 > 0);
    let part = |(number, (strokes, times)): (usize, (Vec<Stroke>, u32))| Pass {
        name: pass.name.clone(),
        tool: pass.tool.times_over(times),
        strokes,
        message: pass.message.clone().filter(|_| number == 0),
        ..*pass
    };
    parts.enumerate().map(part).collect()
}

/// Returns the rest of a stroke after a drawn length.
fn rest_of_stroke(stroke: &Stroke, mut drawn_mm: f64) -> Stroke {
    for (i, (a, b)) in stroke.segments().enumerate() {
        let length_mm = a.distance(b);
        if drawn_mm < length_mm {
            let begin = a.lerp(b, drawn_mm / length_mm);
            let rest = stroke.points[i + 1..].iter().copied();
            return Stroke::open([begin].into_iter().chain(rest).collect());
        }
        drawn_mm -= length_mm;
    }
    Stroke::open(stroke.last().into_iter().collect())
}

fn numbered(names: &[String]) -> String {
    let numbered = (1..).zip(names).map(|(number, name)| {
        if name.is_empty() {
            number.to_string()
        } else {
            format!("{number} ({name})")
        }
    });
    numbered.collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use dobot_geometry::Point;
    use dobot_plan::{DrawingTool, Laser};

    fn line(from: f64, to: f64) -> Stroke {
        Stroke::open(vec![Point::new(from, 0.0), Point::new(to, 0.0)])
    }

    fn pass(name: &str, strokes: Vec<Stroke>) -> Pass {
        Pass {
            name: name.to_owned(),
            message: Some(format!("put in {name}")),
            ..Pass::new(DrawingTool::default(), strokes)
        }
    }

    /// 10 and 20 mm in red, 10 mm in blue.
    fn passes() -> Vec<Pass> {
        vec![
            pass("red", vec![line(0.0, 10.0), line(20.0, 40.0)]),
            pass("blue", vec![line(50.0, 60.0)]),
        ]
    }

    fn rest(from: &ResumePoint) -> Vec<(String, Vec<Stroke>)> {
        let rest = from.rest_of(passes()).unwrap();
        rest.into_iter()
            .map(|pass| (pass.name, pass.strokes))
            .collect()
    }

    #[test]
    fn a_pass_is_found_by_its_name_or_its_number() {
        let blue = vec![("blue".to_owned(), vec![line(50.0, 60.0)])];
        assert_eq!(rest(&ResumePoint::Pass("blue".to_owned())), blue);
        assert_eq!(rest(&ResumePoint::Pass("2".to_owned())), blue);
        assert_eq!(rest(&ResumePoint::Pass("1".to_owned())).len(), 2);
    }

    #[test]
    fn a_stroke_is_counted_through_all_passes() {
        let second = rest(&ResumePoint::Stroke(2));
        assert_eq!(second[0], ("red".to_owned(), vec![line(20.0, 40.0)]));
        assert_eq!(second.len(), 2);
        assert_eq!(rest(&ResumePoint::Stroke(3))[0].0, "blue");
        let left = ResumePoint::Stroke(2).rest_of(passes()).unwrap();
        assert_eq!(left[0].message.as_deref(), Some("put in red"));
    }

    #[test]
    fn the_remaining_repetitions_of_a_laser_are_kept() {
        let laser = |by_stroke| {
            let laser = Laser {
                times: 3,
                by_stroke,
                ..Laser::default()
            };
            let strokes = vec![line(0.0, 10.0), line(20.0, 40.0)];
            vec![Pass::new(DrawingTool::Laser(laser), strokes)]
        };
        let left = |by_stroke, from: ResumePoint| -> Vec<(u32, Vec<Stroke>)> {
            let rest = from.rest_of(laser(by_stroke)).unwrap();
            rest.into_iter()
                .map(|pass| (pass.tool.times(), pass.strokes))
                .collect()
        };
        let (short, long) = (line(0.0, 10.0), line(20.0, 40.0));
        let both = vec![short.clone(), long.clone()];
        let fourth = ResumePoint::Stroke(4);
        assert_eq!(
            left(false, fourth.clone()),
            [(1, vec![long.clone()]), (1, both.clone())]
        );
        assert_eq!(left(true, fourth), [(3, vec![long.clone()])]);
        // 20 of 90 mm.
        let share = ResumePoint::Percent(200.0 / 9.0);
        let half = line(30.0, 40.0);
        assert_eq!(
            left(false, share.clone()),
            [(1, vec![half]), (2, both.clone())]
        );
        assert_eq!(left(true, share), [(1, vec![short]), (3, vec![long])]);
        assert_eq!(left(false, ResumePoint::Stroke(1)), [(3, both.clone())]);
        assert_eq!(left(true, ResumePoint::Stroke(1)), [(3, both)]);
    }

    #[test]
    fn a_percentage_counts_by_length_and_may_start_within_a_stroke() {
        // 10 of 40 mm: the second stroke as a whole. 20 of 40 mm: half of it.
        assert_eq!(
            rest(&ResumePoint::Percent(25.0)),
            rest(&ResumePoint::Stroke(2))
        );
        let half = rest(&ResumePoint::Percent(50.0));
        assert_eq!(half[0].1, [line(30.0, 40.0)]);
        assert_eq!(
            rest(&ResumePoint::Percent(75.0)),
            rest(&ResumePoint::Stroke(3))
        );
        assert_eq!(
            rest(&ResumePoint::Percent(0.0)),
            rest(&ResumePoint::Stroke(1))
        );
    }

    #[test]
    fn dots_have_no_length_and_are_not_lost_at_the_beginning() {
        let dots = vec![pass("dots", vec![Stroke::open(vec![Point::default()]); 3])];
        let rest = ResumePoint::Percent(0.0).rest_of(dots.clone()).unwrap();
        assert_eq!(rest, dots);
    }

    #[test]
    fn a_pass_without_a_name_is_reported_by_its_number() {
        let passes = vec![pass("", vec![Stroke::open(vec![Point::default()])])];
        let error = ResumePoint::Pass("red".to_owned()).rest_of(passes);
        let expected = "there is no pass 'red' to resume at; the passes are: 1";
        assert_eq!(error.unwrap_err().to_string(), expected);
    }

    #[test]
    fn a_missing_pass_or_stroke_is_reported_with_the_existing_ones() {
        let error = |from: ResumePoint| from.rest_of(passes()).unwrap_err().to_string();
        for name in ["green", "0", "3"] {
            assert_eq!(
                error(ResumePoint::Pass(name.to_owned())),
                format!(
                    "there is no pass '{name}' to resume at; the passes are: 1 (red), 2 (blue)"
                )
            );
        }
        assert_eq!(
            error(ResumePoint::Stroke(4)),
            "there is no stroke 4 to resume at; allowed are 1 to 3"
        );
        assert_eq!(
            error(ResumePoint::Stroke(0)),
            "there is no stroke 0 to resume at; allowed are 1 to 3"
        );
        for found in [-1.0, 100.0, f64::NAN] {
            assert_eq!(
                error(ResumePoint::Percent(found)),
                format!("a drawing cannot resume at {found} %; allowed are 0 to below 100")
            );
        }
    }

    proptest! {
        #[test]
        fn the_rest_has_the_remaining_length(
            lengths in proptest::collection::vec(0.0..30.0_f64, 1..12),
            percent in 0.0..100.0_f64,
            times in 1..4_u32,
            by_stroke: bool,
        ) {
            let strokes: Vec<Stroke> = lengths.iter().map(|&length| line(0.0, length)).collect();
            let half = strokes.len() / 2;
            let laser = Laser {
                times,
                by_stroke,
                ..Laser::default()
            };
            let passes = vec![
                pass("a", strokes[..half].to_vec()),
                Pass::new(DrawingTool::Laser(laser), strokes[half..].to_vec()),
            ];
            let drawn = |passes: &[Pass]| -> Vec<f64> {
                passes.iter().flat_map(Pass::drawn).map(Stroke::length_mm).collect()
            };
            let all = drawn(&passes);
            let rest = drawn(&ResumePoint::Percent(percent).rest_of(passes).unwrap());
            let all_mm: f64 = all.iter().sum();
            let left_mm: f64 = rest.iter().sum();
            prop_assert!((left_mm - all_mm * (1.0 - percent / 100.0)).abs() < 1e-6);
            // The rest continues as it would have without the interruption.
            if let Some(later) = rest.get(1..) {
                prop_assert_eq!(later, &all[all.len() - later.len()..]);
            }
        }
    }
}
