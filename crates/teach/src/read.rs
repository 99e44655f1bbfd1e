//! From text to program, and back.

use std::collections::BTreeMap;

use toml::de::{DeTable, DeValue};

use crate::document::on_lines;
use crate::lines::Lines;
use crate::number::within;
use crate::place::Place;
use crate::step_table::LEAST_SPEED;
use crate::{Action, Program, ProgramError, Steps};

impl Program {
    /// Reads a program.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] with the line: no TOML, an unknown key, a value of another kind or outside its range, a
    /// name that nothing has, no steps.
    pub fn from_toml(text: &str) -> Result<Self, ProgramError> {
        let lines = Lines::of(text);
        let bad = |line, reason| ProgramError {
            file: None,
            line,
            reason,
        };
        if text.len() > LONGEST_TEXT {
            let found = text.len();
            return Err(bad(
                None,
                format!("the text has {found} bytes; allowed are {LONGEST_TEXT}"),
            ));
        }
        if let Some(line) = deep_line(text) {
            return Err(bad(
                Some(line),
                format!("a key has more than {MOST_DOTS} dots; that is deeper than any program"),
            ));
        }
        let mut program: Self = toml::from_str(text).map_err(|error| {
            let line = error.span().map(|span| lines.at(span.start));
            bad(line, error.message().trim().replace('\n', ", "))
        })?;
        program.lines = lines;
        program
            .check_values()
            .map_err(|(key, reason)| bad(line_of(text, &key), reason))?;
        program.check_steps(&program.steps, 0)?;
        Ok(program)
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

    /// The values that have a place in no step: the key that is wrong, and why.
    fn check_values(&self) -> Result<(), (String, String)> {
        let at = |key: String| move |reason: String| (key, reason);
        if let Some(percent) = self.start_speed_percent {
            within("start_speed_percent", " %", percent, LEAST_SPEED, 100.0)
                .map_err(at("start_speed_percent".into()))?;
        }
        for (name, tool) in &self.tools {
            let key = format!("tools.{name}");
            within(&format!("{key}.length"), " mm", tool.length, 0.0, 200.0).map_err(at(key))?;
        }
        for (name, grid) in &self.grids {
            for (field, found) in [
                ("columns", grid.columns),
                ("rows", grid.rows),
                ("layers", grid.layers),
            ] {
                let key = format!("grids.{name}");
                within(&format!("{key}.{field}"), "", found.into(), 1.0, 1000.0)
                    .map_err(at(key))?;
            }
            if self.points.contains_key(name) {
                let reason = format!("a grid and a point have the name {name:?}; names are unique");
                return Err((format!("grids.{name}"), reason));
            }
        }
        self.check_names()
    }

    /// That the places of points, frames and grids are there.
    fn check_names(&self) -> Result<(), (String, String)> {
        for (name, frame) in &self.frames {
            for place in [&frame.origin, &frame.x, &frame.y] {
                self.check_place(place, &[])
                    .map_err(|reason| (format!("frames.{name}"), reason))?;
            }
        }
        for (name, grid) in &self.grids {
            self.check_place(&grid.at, &[])
                .map_err(|reason| (format!("grids.{name}"), reason))?;
        }
        for (name, point) in &self.points {
            self.check_place(&point.clone().into(), &[])
                .map_err(|reason| (format!("points.{name}"), reason))?;
        }
        Ok(())
    }

    /// That all that steps name is there. `cells` counts how deep they are in `each`.
    fn check_steps(&self, steps: &Steps, depth: usize) -> Result<(), ProgramError> {
        if steps.0.is_empty() {
            let reason = "the program has no steps; it needs one at least, as [[steps]]".to_owned();
            return Err(ProgramError::new(reason));
        }
        let grids: Vec<&str> = Vec::new();
        self.check_within(steps, &grids, depth)
    }

    fn check_within<'a>(
        &'a self,
        steps: &'a Steps,
        cells: &[&'a str],
        depth: usize,
    ) -> Result<(), ProgramError> {
        for step in &steps.0 {
            let bad = |reason| ProgramError {
                file: None,
                line: Some(self.line_of(step)),
                reason,
            };
            if depth > DEEPEST {
                return Err(bad(format!(
                    "steps are nested {depth} deep; allowed are {DEEPEST}"
                )));
            }
            match step.get_ref() {
                Action::Go(go) => self.check_place(&go.to, cells).map_err(bad)?,
                Action::Arc(arc) | Action::Circle(arc) => {
                    self.check_place(&arc.through, cells).map_err(bad)?;
                    self.check_place(&arc.to, cells).map_err(bad)?;
                }
                Action::Tool(name) => check_name("tool", name, &self.tools).map_err(bad)?,
                Action::Repeat(_, steps) => self.check_within(steps, cells, depth + 1)?,
                Action::Each(grids, steps) => {
                    self.check_grids(grids).map_err(bad)?;
                    let cells: Vec<&str> = cells
                        .iter()
                        .copied()
                        .chain(grids.iter().map(String::as_str))
                        .collect();
                    self.check_within(steps, &cells, depth + 1)?;
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn check_grids(&self, names: &[String]) -> Result<(), String> {
        let mut cells = None;
        for name in names {
            check_name("grid", name, &self.grids)?;
            let count = self.grids[name].cells();
            let (first, before) = *cells.get_or_insert((name, count));
            if count != before {
                return Err(format!(
                    "grid {name:?} has {count} cells and grid {first:?} {before}; side by side they need as many"
                ));
            }
        }
        Ok(())
    }

    fn check_place(&self, place: &Place, cells: &[&str]) -> Result<(), String> {
        match place {
            Place::Named(name) if cells.contains(&name.as_str()) => Ok(()),
            Place::Named(name) if self.grids.contains_key(name) => Err(format!(
                "{name:?} is a grid; its cells are places within a step with each = {name:?}"
            )),
            Place::Named(name) => check_name("point", name, &self.points),
            Place::At(crate::Point::Cartesian {
                frame: Some(frame), ..
            }) => check_name("frame", frame, &self.frames),
            Place::At(_) => Ok(()),
        }
    }
}

fn check_name<T>(kind: &str, name: &str, known: &BTreeMap<String, T>) -> Result<(), String> {
    if known.contains_key(name) {
        return Ok(());
    }
    let names: Vec<&str> = known.keys().take(MOST_NAMES).map(String::as_str).collect();
    let more = if known.len() > MOST_NAMES {
        " and more"
    } else {
        ""
    };
    Err(if names.is_empty() {
        format!(
            "there is no {kind} {name:?}; the program has none: teach it under [{kind}s.{name}]"
        )
    } else {
        format!(
            "there is no {kind} {name:?}; there are {}{more}",
            names.join(", ")
        )
    })
}

/// The line of a key in a text; where the key itself is not written, the nearest table that is.
fn line_of(text: &str, key: &str) -> Option<usize> {
    let document = DeTable::parse(text).ok()?;
    let mut table = document.get_ref();
    let mut offset = None;
    for part in key.split('.') {
        let Some((name, value)) = table.iter().find(|(name, _)| *name.get_ref() == part) else {
            break;
        };
        offset = Some(name.span().start);
        match value.get_ref() {
            DeValue::Table(inner) => table = inner,
            _ => break,
        }
    }
    offset.map(|offset| Lines::of(text).at(offset))
}

/// The first line whose key has too many dots.
fn deep_line(text: &str) -> Option<usize> {
    let dots = |line: &str| {
        line.split(['=', '#'])
            .next()
            .map_or(0, |key| key.matches('.').count())
    };
    text.lines()
        .position(|line| dots(line) > MOST_DOTS)
        .map(|at| at + 1)
}

/// 64 MiB; a program of 1,000,000 steps has that.
const LONGEST_TEXT: usize = 64 << 20;
/// A key of a program has two for each level of steps.
const MOST_DOTS: usize = 64;
/// How deep repeats and grids may be in each other.
pub(crate) const DEEPEST: usize = 32;
/// How many names an error lists.
const MOST_NAMES: usize = 12;
