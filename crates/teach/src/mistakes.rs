//! The mistakes of a text that cannot be read as a program, all at once: each point, grid and step
//! is read on its own, and the names are checked in those that can be read.

use std::collections::{BTreeMap, BTreeSet};

use dobot_arm::Tool;
use dobot_safety::line_of;
use serde::Deserialize;
use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue, ValueDeserializer};

use crate::corrections::{corrected, switch};
use crate::lines::Lines;
use crate::place::Point;
use crate::plain::plain;
use crate::program::{Frame, Grid, MountedTool, Offset};
use crate::read::NO_STEPS;
use crate::similar::nearest;
use crate::step_table::StepTable;
use crate::{Action, Place, Program, ProgramError, Steps};

/// Returns the mistakes of a text, or `first`, the one that its reader has found.
pub(crate) fn mistakes_of(text: &str, lines: &Lines, first: &toml::de::Error) -> ProgramError {
    if text.len() > MAX_TEXT_BYTES {
        return one(lines, first);
    }
    let (text, corrections) = corrected(text);
    let lines = &Lines::of(&text);
    let (document, errors) = DeTable::parse_recoverable(&text);
    let mut reader = Reader {
        lines,
        mistakes: Vec::new(),
        inner: Vec::new(),
        each: Vec::new(),
        has_all_names: true,
        is_whole: errors.is_empty(),
    };
    let starts = |error: &toml::de::Error| error.span().map_or(0, |span| span.start);
    if errors.is_empty() {
        reader.document(&text, document.into_inner());
    } else {
        let broken = errors.iter().map(|error| lines.at(starts(error))).collect();
        reader.document_without(&text, &broken);
    }
    let mut known = BTreeSet::new();
    for error in &errors {
        // The rest of a line may be wrong only because of its first mistake.
        if known.insert(lines.at(starts(error))) {
            reader.report(error, starts(error));
        }
    }
    reader.mistakes.extend(corrections);
    ProgramError::merge(reader.mistakes).unwrap_or_else(|| one(lines, first))
}

fn one(lines: &Lines, error: &toml::de::Error) -> ProgramError {
    let line = error.span().map(|span| lines.at(span.start));
    ProgramError::at(line, plain(error.message()))
}

/// Reads the parts of a text, and collects their mistakes.
struct Reader<'a> {
    lines: &'a Lines,
    mistakes: Vec<ProgramError>,
    /// The steps within others.
    inner: Vec<Spanned<Action>>,
    /// The grids that steps with `each` name.
    each: Vec<String>,
    /// Whether all named points, grids, frames, tools and variables are known.
    has_all_names: bool,
    /// Whether no line was left out.
    is_whole: bool,
}

impl Reader<'_> {
    /// Reports an error; it is at `start` if it has no position of its own.
    fn report(&mut self, error: &toml::de::Error, start: usize) {
        let start = error.span().map_or(start, |span| span.start);
        self.report_text(start, plain(error.message()));
    }

    fn report_text(&mut self, start: usize, reason: String) {
        let line = self.lines.at(start);
        self.mistakes.push(ProgramError::at(line, reason));
    }

    /// Reads a value; `None` if it has a mistake.
    fn value<'de, T: Deserialize<'de>>(&mut self, value: Spanned<DeValue<'de>>) -> Option<T> {
        let start = value.span().start;
        let read = T::deserialize(ValueDeserializer::from(value));
        read.map_err(|error| self.report(&error, start)).ok()
    }

    /// Reads a table, without the keys whose mistakes are reported already; `None` if it has any.
    fn table<'de, T: Deserialize<'de>>(&mut self, value: Spanned<DeValue<'de>>) -> Option<T> {
        let span = value.span();
        let mut value = value.into_inner();
        let known = self.mistakes.len();
        let mut removed: Vec<String> = Vec::new();
        loop {
            let whole = Spanned::new(span.clone(), value.clone());
            let error = match T::deserialize(ValueDeserializer::from(whole)) {
                Ok(read) => return Some(read).filter(|_| self.mistakes.len() == known),
                Err(error) => error,
            };
            let key = match &value {
                DeValue::Table(table) => key_at(table, error.span()),
                _ => None,
            };
            // What a missing key has caused is no mistake of its own.
            if removed.is_empty() || key.is_some() {
                self.report(&error, span.start);
            }
            let (Some(key), DeValue::Table(table)) = (key, &mut value) else {
                return None;
            };
            table.remove(key.as_str());
            removed.push(key);
        }
    }

    /// Reads a document without the lines that are not TOML, and leaves out the mistakes of the
    /// tables that contain them. Without a header, the lines below it belong nowhere.
    fn document_without(&mut self, text: &str, broken: &BTreeSet<usize>) {
        let is_header = |line: &usize| text[self.lines.range(*line, text)].trim().starts_with('[');
        if broken.iter().any(is_header) {
            return;
        }
        let headers = broken.iter().map(|line| (1..*line).rev().find(is_header));
        let headers: BTreeSet<Option<usize>> = headers.collect();
        let is_step = |line: usize| text[self.lines.range(line, text)].contains("steps");
        self.has_all_names = headers.iter().all(|line| line.is_some_and(is_step));
        let mut rest = text.to_owned();
        for line in broken {
            let range = self.lines.range(*line, text);
            let len = text[range.clone()].trim_end().len();
            rest.replace_range(range.start..range.start + len, &" ".repeat(len));
        }
        if let Ok(document) = DeTable::parse(&rest) {
            self.document(&rest, document.into_inner());
            self.mistakes
                .retain(|mistake| !headers.contains(&mistake.line));
        }
    }

    /// Reads a document part by part, and checks the names in what could be read.
    fn document(&mut self, text: &str, document: DeTable<'_>) {
        let mut program = Program {
            lines: self.lines.clone(),
            ..Program::default()
        };
        let mut grids = BTreeMap::new();
        let mut has_steps = false;
        for (key, value) in document {
            match self.program_key(&key) {
                Some("title") => drop(self.value::<String>(value)),
                Some("start_speed_percent") => program.start_speed_percent = self.value(value),
                Some("tools") => program.tools = known(self.named(value), &A_TOOL),
                Some("points") => program.points = known(self.named(value), &A_POINT),
                Some("frames") => {
                    let [origin, x, y] = [(); 3].map(|()| Place::At(A_POINT));
                    program.frames = known(self.named(value), &Frame { origin, x, y });
                }
                Some("grids") => grids = self.named(value),
                Some("variables") => program.variables = known(self.named(value), &0),
                Some(_) => {
                    has_steps = true;
                    program.steps = self.program_steps(value);
                }
                None => self.has_all_names = false,
            }
        }
        let found = self.mistakes.len();
        program.grids = grids
            .iter()
            .filter_map(|(name, grid)| Some((name.clone(), grid.clone()?)))
            .collect();
        program.check_values(&mut |key, reason| {
            self.mistakes
                .push(ProgramError::at(line_of(text, key), reason));
        });
        program.grids = known(grids, &A_GRID);
        program.check_nested(&program.steps, &[], 0, &mut self.mistakes);
        // The steps around these may have mistakes: any of them may stand in a step with `each`.
        let cells = program.grids.keys().chain(&self.each);
        let cells: Vec<&str> = cells.map(String::as_str).collect();
        let inner = Steps(std::mem::take(&mut self.inner));
        program.check_nested(&inner, &cells, 0, &mut self.mistakes);
        if !self.has_all_names {
            self.mistakes.truncate(found);
        }
        if !has_steps && self.is_whole {
            self.report_text(text.len(), NO_STEPS.to_owned());
        }
    }

    /// Returns the key of a program that is meant; `None` if no key is similar.
    fn program_key(&mut self, key: &Spanned<DeString<'_>>) -> Option<&'static str> {
        let found: &str = key.get_ref();
        if let Some(key) = KEYS.into_iter().find(|key| *key == found) {
            return Some(key);
        }
        let allowed = KEYS.map(|key| format!("`{key}`")).join(", ");
        let message = format!("unknown field `{found}`, expected one of {allowed}");
        self.report_text(key.span().start, plain(&message));
        nearest(found, KEYS.into_iter())
    }

    /// Reads a table of names; the value of a name is `None` if it has a mistake.
    fn named<'de, T: Deserialize<'de>>(
        &mut self,
        table: Spanned<DeValue<'de>>,
    ) -> BTreeMap<String, Option<T>> {
        let span = table.span();
        match table.into_inner() {
            DeValue::Table(table) => {
                let read = |(name, value): (Spanned<DeString<'_>>, _)| {
                    (name.get_ref().to_string(), self.table(value))
                };
                table.into_iter().map(read).collect()
            }
            other => {
                self.has_all_names = false;
                self.value::<BTreeMap<String, T>>(Spanned::new(span, other));
                BTreeMap::new()
            }
        }
    }

    fn program_steps(&mut self, steps: Spanned<DeValue<'_>>) -> Steps {
        let span = steps.span();
        match steps.into_inner() {
            DeValue::Array(steps) => {
                let read = |step| self.step(step).1;
                Steps(steps.into_iter().filter_map(read).collect())
            }
            DeValue::Table(_) => {
                let reason = "found one table; write each step under [[steps]], with two brackets";
                self.report_text(span.start, reason.to_owned());
                Steps::default()
            }
            other => self.value(Spanned::new(span, other)).unwrap_or_default(),
        }
    }

    /// Reads a step key by key. Returns what has no mistake, and its action.
    fn step<'de>(
        &mut self,
        step: Spanned<DeValue<'de>>,
    ) -> (Spanned<DeValue<'de>>, Option<Spanned<Action>>) {
        let span = step.span();
        let step = match step.into_inner() {
            DeValue::Table(step) => step,
            other => {
                let other = Spanned::new(span.clone(), other);
                let action = self
                    .value(other)
                    .map(|action| Spanned::new(span.clone(), action));
                return (a_step(span), action);
            }
        };
        let keys = step.len();
        let sound = step
            .into_iter()
            .filter_map(|(key, value)| {
                let value = self.step_key(&key, value)?;
                Some((key, value))
            })
            .collect::<DeTable<'_>>();
        let is_whole = sound.len() == keys;
        let sound = Spanned::new(span.clone(), DeValue::Table(sound));
        let action = Action::deserialize(ValueDeserializer::from(sound.clone()));
        match action {
            Ok(action) => {
                if let Action::Each(grids, _) = &action {
                    self.each.extend_from_slice(grids);
                }
                (sound, Some(Spanned::new(span, action)))
            }
            Err(error) => {
                if is_whole {
                    self.report(&error, span.start);
                }
                (a_step(span), None)
            }
        }
    }

    /// Reads the value of a key of a step; `None` if it has a mistake.
    fn step_key<'de>(
        &mut self,
        key: &Spanned<DeString<'de>>,
        value: Spanned<DeValue<'de>>,
    ) -> Option<Spanned<DeValue<'de>>> {
        let start = key.span().start;
        if let Some(reason) = common_mistake(key.get_ref(), value.get_ref()) {
            self.report_text(start, reason);
            return None;
        }
        let value = self.with_sound_steps(key.get_ref(), value);
        let only = DeTable::from_iter([(key.clone(), value.clone())]);
        let only = Spanned::new(key.span(), DeValue::Table(only));
        match StepTable::deserialize(ValueDeserializer::from(only)) {
            Ok(_) => Some(value),
            Err(error) => {
                self.report(&error, start);
                None
            }
        }
    }

    /// Replaces the steps that have mistakes within the value of a key, and reports them.
    fn with_sound_steps<'de>(
        &mut self,
        key: &str,
        value: Spanned<DeValue<'de>>,
    ) -> Spanned<DeValue<'de>> {
        let span = value.span();
        let sound = match value.into_inner() {
            DeValue::Array(steps) if key == "steps" => {
                let sound = |step| {
                    let (sound, action) = self.step(step);
                    self.inner.extend(action);
                    sound
                };
                DeValue::Array(steps.into_iter().map(sound).collect())
            }
            DeValue::Array(values) => {
                let sound = |value| self.with_sound_steps("", value);
                DeValue::Array(values.into_iter().map(sound).collect())
            }
            DeValue::Table(table) => {
                let sound = |(key, value): (Spanned<DeString<'de>>, _)| {
                    let value = self.with_sound_steps(key.get_ref(), value);
                    (key, value)
                };
                DeValue::Table(table.into_iter().map(sound).collect())
            }
            other => other,
        };
        Spanned::new(span, sound)
    }
}

/// The key of a table at a place of the text, or whose value is there.
fn key_at(table: &DeTable<'_>, place: Option<std::ops::Range<usize>>) -> Option<String> {
    let start = place?.start;
    let at = |(key, value): &(&Spanned<DeString<'_>>, &Spanned<DeValue<'_>>)| {
        key.span().contains(&start) || value.span().contains(&start)
    };
    let (key, _) = table.iter().find(at)?;
    Some(key.get_ref().to_string())
}

/// A step that stands for one with mistakes.
fn a_step<'de>(span: std::ops::Range<usize>) -> Spanned<DeValue<'de>> {
    let at = |value| Spanned::new(span.clone(), value);
    let key = Spanned::new(span.clone(), DeString::from("laser"));
    let table = DeTable::from_iter([(key, at(DeValue::Boolean(false)))]);
    at(DeValue::Table(table))
}

/// What is wrong with a value that people often give to this key of a step, and what to write.
fn common_mistake(key: &str, value: &DeValue<'_>) -> Option<String> {
    let needs_table = |written: String| Some(format!("{key} needs a table; write {written}"));
    match (key, value) {
        ("drawing", DeValue::String(file)) => needs_table(format!(
            "drawing = {{ file = {file:?}, pen_down = HEIGHT }}, with the height of the wrist in mm"
        )),
        ("on_missed", DeValue::String(_) | DeValue::Integer(_) | DeValue::Boolean(_)) => {
            needs_table("on_missed = { by = \"person\", retries = 2 }".to_owned())
        }
        ("suction" | "laser", DeValue::String(word)) => {
            let is_on = switch(word)?;
            Some(format!("{key} is true or false; write {key} = {is_on}"))
        }
        ("pause" | "gripper" | "settle", DeValue::String(text)) => {
            let number = text.split_whitespace().next()?.trim_end_matches('s');
            let number = number.parse::<f64>().ok()?;
            Some(format!(
                "found the text {text:?}; write {key} = {number}, a number without quotes"
            ))
        }
        (_, DeValue::Integer(_) | DeValue::Float(_)) => {
            let number = match value {
                DeValue::Integer(number) => number.as_str(),
                DeValue::Float(number) => number.as_str(),
                _ => return None,
            };
            match key {
                "speed" => needs_table(format!("speed = {{ percent = {number} }}")),
                "offset" => needs_table(format!("offset = {{ z = {number} }}")),
                "wait" => Some(format!(
                    "wait shows a message to a person and needs a text; to wait {number} s, write pause = {number}"
                )),
                _ => None,
            }
        }
        _ => None,
    }
}

/// The values by name; `stand_in` stands for those with a mistake, whose names are known all the
/// same.
fn known<T: Clone>(read: BTreeMap<String, Option<T>>, stand_in: &T) -> BTreeMap<String, T> {
    let known = |(name, value): (_, Option<T>)| (name, value.unwrap_or_else(|| stand_in.clone()));
    read.into_iter().map(known).collect()
}

/// The keys of a program.
const KEYS: [&str; 8] = [
    "title",
    "start_speed_percent",
    "tools",
    "points",
    "frames",
    "grids",
    "variables",
    "steps",
];
/// The largest text whose mistakes are all listed: longer ones are not written by hand.
const MAX_TEXT_BYTES: usize = 1 << 20;
const A_POINT: Point = Point::xyz(0.0, 0.0, 0.0);
const A_TOOL: MountedTool = MountedTool {
    kind: Tool::SuctionCup,
    length: 0.0,
};
/// A grid without cells, which other grids are not compared with.
const A_GRID: Grid = Grid {
    at: Place::At(A_POINT),
    columns: 0,
    rows: 0,
    layers: 0,
    pitch: Offset {
        x: 0.0,
        y: 0.0,
        z: 0.0,
    },
};
