//! Dashed lines: LT and UL.

use super::command::Command;
use super::plotter::Plotter;
use super::transform::{PlotTransform, UNIT_MM};
use crate::error::SourceError;
use crate::sketch::SketchMark;

/// The line types.
#[derive(Debug)]
pub(super) struct LineTypes {
    /// Alternating pen down and pen up for the types from 1 on, as fractions of a pattern.
    patterns: [Vec<f64>; COUNT],
    /// The current type, and the previous one (LT 99).
    current: Option<LineType>,
    previous: Option<LineType>,
    length: PatternLength,
    /// The start of the lines of this type.
    since: Option<SketchMark>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct LineType {
    /// The type number, from 0.
    pattern: usize,
    /// Whether a straight line has whole patterns, and starts and ends with half a dash.
    is_adaptive: bool,
}

/// The length of a pattern.
#[derive(Clone, Copy, Debug, PartialEq)]
struct PatternLength {
    number: f64,
    /// In mm, or else in percent of the distance from P1 to P2.
    is_absolute: bool,
}

impl Default for LineTypes {
    fn default() -> Self {
        Self {
            patterns: PATTERNS.map(<[f64]>::to_vec),
            current: None,
            previous: None,
            length: PatternLength {
                number: 4.0,
                is_absolute: false,
            },
            since: None,
        }
    }
}

impl PatternLength {
    fn mm(self, transform: &PlotTransform) -> f64 {
        let [p1, p2] = transform.corners;
        if self.is_absolute {
            self.number
        } else {
            self.number / 100.0 * p1.distance(p2) * UNIT_MM
        }
    }
}

impl Plotter<'_> {
    /// LT: the type, from -8 to 8, the length of its pattern, and whether that is in mm.
    pub(super) fn set_line_type(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        self.end_dashes()?;
        let types = &mut self.line_types;
        if let Some(number) = command.number(1).filter(|number| *number > 0.0) {
            types.length.number = number;
        }
        if let Some(mode) = command.number(2) {
            types.length.is_absolute = mode == 1.0;
        }
        let before = types.current;
        types.current = match command.number(0).map(f64::trunc) {
            None => None,
            Some(PREVIOUS) => types.previous,
            Some(number) => line_type(number),
        };
        types.previous = before.or(types.previous);
        if let (Some(number), None) = (command.number(0), types.current)
            && number != PREVIOUS
        {
            self.warn(command, "line type without a pattern", "drawn solid (LT)");
        }
        Ok(())
    }

    /// UL: a type, and its dashes and gaps. Without these the type is reset, and without a type all
    /// are.
    pub(super) fn define_line_type(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        self.end_dashes()?;
        let patterns = &mut self.line_types.patterns;
        match command.numbers.as_slice() {
            [] => *patterns = PATTERNS.map(<[f64]>::to_vec),
            [number, gaps @ ..] => {
                let Some(LineType { pattern, .. }) = line_type(number.abs().trunc()) else {
                    return Err(
                        self.refused(command, "a line type from 1 to 8, and its dashes and gaps")
                    );
                };
                let is_pattern =
                    gaps.iter().all(|gap| *gap >= 0.0) && gaps.iter().any(|gap| *gap > 0.0);
                patterns[pattern] = match gaps {
                    [] => PATTERNS[pattern].to_vec(),
                    _ if is_pattern && gaps.len() <= MAX_GAPS => gaps.to_vec(),
                    _ => {
                        return Err(
                            self.refused(command, "up to 20 dashes and gaps, not all of them 0")
                        );
                    }
                };
            }
        }
        Ok(())
    }

    /// Resets to solid lines.
    pub(super) fn reset_line_types(&mut self) -> Result<(), SourceError> {
        self.end_dashes()?;
        self.line_types = LineTypes::default();
        Ok(())
    }

    /// Starts a line: lines from here on have the current type.
    pub(super) fn begin_dashes(&mut self) {
        if self.line_types.current.is_some() && self.line_types.since.is_none() {
            self.sketch.lift();
            self.line_types.since = Some(self.sketch.mark());
        }
    }

    /// Dashes the lines up to here: before the type changes, and before letters, which are never
    /// dashed.
    pub(super) fn end_dashes(&mut self) -> Result<(), SourceError> {
        let types = &mut self.line_types;
        let (Some(mark), Some(line_type)) = (types.since.take(), types.current) else {
            return Ok(());
        };
        let shares = &types.patterns[line_type.pattern];
        let factor = types.length.mm(&self.transform) / shares.iter().sum::<f64>();
        let lengths: Vec<f64> = shares.iter().map(|share| share * factor).collect();
        if line_type.is_adaptive {
            return self.sketch.fit_dashes_since(&mark, &lengths);
        }
        self.sketch.dash_since(&mark, &lengths, 0.0)
    }
}

/// The type of a number; `None` if it has no pattern.
fn line_type(number: f64) -> Option<LineType> {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "saturates"
    )]
    let pattern = (number.abs() as usize).checked_sub(1)?;
    (pattern < COUNT).then_some(LineType {
        pattern,
        is_adaptive: number < 0.0,
    })
}

const COUNT: usize = 8;
/// The initial patterns of a plotter: dots, dashes, dashes and dots.
const PATTERNS: [&[f64]; COUNT] = [
    &[0.0, 100.0],
    &[50.0, 50.0],
    &[70.0, 30.0],
    &[80.0, 10.0, 0.0, 10.0],
    &[70.0, 10.0, 10.0, 10.0],
    &[50.0, 10.0, 10.0, 10.0, 10.0, 10.0],
    &[70.0, 10.0, 0.0, 10.0, 0.0, 10.0],
    &[50.0, 10.0, 0.0, 10.0, 10.0, 10.0, 0.0, 10.0],
];
/// The type before this one.
const PREVIOUS: f64 = 99.0;
const MAX_GAPS: usize = 20;
