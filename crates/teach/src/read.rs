//! Programs from text and back.

use std::collections::BTreeMap;

use dobot_safety::line_of;

use crate::document::on_lines;
use crate::lines::Lines;
use crate::mistakes::mistakes_of;
use crate::number::within;
use crate::place::{Place, Point};
use crate::similar::nearest;
use crate::step_table::MIN_SPEED;
use crate::{Action, Program, ProgramError, Steps};

impl Program {
    /// Parses a program.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] with the line: not TOML, an unknown key, a value of another type or outside
    /// its range, an unknown name, no steps. It lists all mistakes that are independent of each
    /// other.
    pub fn from_toml(text: &str) -> Result<Self, ProgramError> {
        check_size(text)?;
        let lines = Lines::of(text);
        let mut program: Self =
            toml::from_str(text).map_err(|first| mistakes_of(text, &lines, &first))?;
        program.lines = lines;
        let mut mistakes = Vec::new();
        program.check_values(&mut |key, reason| {
            mistakes.push(ProgramError::at(line_of(text, key), reason));
        });
        program.check_steps(&mut mistakes);
        match ProgramError::merge(mistakes) {
            Some(error) => Err(error),
            None => Ok(program),
        }
    }

    /// Writes the program without comments; [`from_toml`](Self::from_toml) reads it back unchanged.
    #[must_use]
    #[expect(
        clippy::missing_panics_doc,
        reason = "tables of numbers and texts are TOML"
    )]
    pub fn to_toml(&self) -> String {
        let document = on_lines(self);
        let document = document.expect("tables with text keys, numbers and switches are TOML");
        document.to_string()
    }

    /// Checks everything outside the steps; `report` receives the key and the reason.
    pub(crate) fn check_values(&self, report: &mut impl FnMut(&str, String)) {
        let mut check = |key: &str, outcome: Result<(), String>| {
            if let Err(reason) = outcome {
                report(key, reason);
            }
        };
        if let Some(percent) = self.start_speed_percent {
            let key = "start_speed_percent";
            let outcome = within(key, " %", percent, MIN_SPEED, 100.0);
            check(key, outcome.map(drop));
        }
        for (name, tool) in &self.tools {
            let key = format!("tools.{name}");
            let outcome = within(&format!("{key}.length"), " mm", tool.length, 0.0, 200.0);
            check(&key, outcome.map(drop));
        }
        for (name, frame) in &self.frames {
            for place in [&frame.origin, &frame.x, &frame.y] {
                check(&format!("frames.{name}"), self.check_place(place, &[]));
            }
        }
        for (name, grid) in &self.grids {
            let key = format!("grids.{name}");
            for (field, found) in [
                ("columns", grid.columns),
                ("rows", grid.rows),
                ("layers", grid.layers),
            ] {
                let outcome = within(&format!("{key}.{field}"), "", found.into(), 1.0, 1000.0);
                check(&key, outcome.map(drop));
            }
            if self.points.contains_key(name) {
                let reason = format!("a grid and a point have the name {name:?}; names are unique");
                check(&key, Err(reason));
            }
            check(&key, self.check_place(&grid.at, &[]));
        }
        for (name, point) in &self.points {
            let outcome = self.check_place(&point.clone().into(), &[]);
            check(&format!("points.{name}"), outcome);
        }
    }

    /// Checks that every name in the steps is defined.
    fn check_steps(&self, mistakes: &mut Vec<ProgramError>) {
        if self.steps.0.is_empty() {
            mistakes.push(ProgramError::new(NO_STEPS));
        }
        self.check_nested(&self.steps, &[], 0, mistakes);
    }

    /// Checks steps at a nesting depth within `each` steps over the grids `cells`.
    pub(crate) fn check_nested<'a>(
        &'a self,
        steps: &'a Steps,
        cells: &[&'a str],
        depth: usize,
        mistakes: &mut Vec<ProgramError>,
    ) {
        for step in &steps.0 {
            let line = self.line_of(step);
            let mut check = |outcome: Result<(), String>| {
                if let Err(reason) = outcome {
                    mistakes.push(ProgramError::at(line, reason));
                }
            };
            if depth > MAX_DEPTH {
                check(Err(format!(
                    "steps are nested {depth} deep; allowed are {MAX_DEPTH}"
                )));
                return;
            }
            match step.get_ref() {
                Action::Go(go) => check(self.check_place(&go.to, cells)),
                Action::Arc(arc) | Action::Circle(arc) => {
                    check(self.check_place(&arc.through, cells));
                    check(self.check_place(&arc.to, cells));
                }
                Action::Tool(name) => check(check_name("tool", name, &self.tools)),
                Action::Repeat(_, steps) => self.check_nested(steps, cells, depth + 1, mistakes),
                Action::Each(grids, steps) => {
                    check(self.check_grids(grids));
                    // Unknown grids count as cells: their uses inside are not reported again.
                    let names = grids.iter().map(String::as_str);
                    let cells: Vec<&str> = cells.iter().copied().chain(names).collect();
                    self.check_nested(steps, &cells, depth + 1, mistakes);
                }
                Action::While(condition, steps) => {
                    for name in condition.names() {
                        check(check_name("variable", name, &self.variables));
                    }
                    self.check_nested(steps, cells, depth + 1, mistakes);
                }
                Action::Set(variables) | Action::Add(variables) => {
                    for name in variables.keys() {
                        check(check_name("variable", name, &self.variables));
                    }
                }
                Action::Choose(choose) => {
                    for when in &choose.when {
                        self.check_nested(&when.steps, cells, depth + 1, mistakes);
                    }
                }
                Action::Pick(transfer) | Action::Place(transfer) => {
                    check(self.check_place(&transfer.at, cells));
                    if let Some(missed) = &transfer.missed {
                        self.check_nested(&missed.steps, cells, depth + 1, mistakes);
                    }
                }
                _ => {}
            }
        }
    }

    fn check_grids(&self, names: &[String]) -> Result<(), String> {
        let mut cells = None;
        for name in names {
            check_name("grid", name, &self.grids)?;
            let count = self.grids[name].cells();
            // Its size is wrong, which is reported with the grid.
            if count == 0 {
                continue;
            }
            let (first, before) = *cells.get_or_insert((name, count));
            if count != before {
                return Err(format!(
                    "grid {name:?} has {count} cells and grid {first:?} {before}; grids in one step need the same number"
                ));
            }
        }
        Ok(())
    }

    fn check_place(&self, place: &Place, cells: &[&str]) -> Result<(), String> {
        match place {
            Place::Named(name) if cells.contains(&name.as_str()) => Ok(()),
            Place::Named(name) if self.grids.contains_key(name) => Err(format!(
                "{name:?} is a grid; use it inside a step with each = {name:?}"
            )),
            Place::Named(name) => check_name("point", name, &self.points),
            Place::At(Point::Cartesian {
                frame: Some(frame), ..
            }) => check_name("frame", frame, &self.frames),
            Place::At(_) | Place::External(_) => Ok(()),
        }
    }
}

fn check_size(text: &str) -> Result<(), ProgramError> {
    if text.len() > MAX_TEXT_BYTES {
        return Err(ProgramError::new(format!(
            "the text has {} bytes; allowed are {MAX_TEXT_BYTES}",
            text.len()
        )));
    }
    let Some(line) = deep_line(text) else {
        return Ok(());
    };
    let reason = format!("a key has more than {MAX_DOTS} dots; that is deeper than any program");
    Err(ProgramError::at(line, reason))
}

fn check_name<T>(kind: &str, name: &str, known: &BTreeMap<String, T>) -> Result<(), String> {
    if known.contains_key(name) {
        return Ok(());
    }
    if let Some(meant) = nearest(name, known.keys().map(String::as_str)) {
        return Err(format!(
            "there is no {kind} {name:?}; did you mean {meant:?}?"
        ));
    }
    let names: Vec<&str> = known.keys().take(MAX_NAMES).map(String::as_str).collect();
    let more = if known.len() > MAX_NAMES {
        " and more"
    } else {
        ""
    };
    Err(if names.is_empty() {
        let added = match kind {
            "variable" => format!("{name} = 0 under [variables]"),
            _ => format!("[{kind}s.{name}]"),
        };
        format!("there is no {kind} {name:?}; the program has none: add {added}")
    } else {
        format!(
            "there is no {kind} {name:?}; there are {}{more}",
            names.join(", ")
        )
    })
}

/// The first line whose key has too many dots.
fn deep_line(text: &str) -> Option<usize> {
    let dots = |line: &str| {
        line.split(['=', '#'])
            .next()
            .map_or(0, |key| key.matches('.').count())
    };
    text.lines()
        .position(|line| dots(line) > MAX_DOTS)
        .map(|at| at + 1)
}

pub(crate) const NO_STEPS: &str = "the program has no steps; add at least one, as [[steps]]";
/// 64 MiB: a program of 1,000,000 steps.
const MAX_TEXT_BYTES: usize = 64 << 20;
/// A key of a program has two dots for each level of steps.
const MAX_DOTS: usize = 64;
/// The deepest nesting of repeats and grids.
pub(crate) const MAX_DEPTH: usize = 32;
/// The number of names that an error lists.
const MAX_NAMES: usize = 12;
