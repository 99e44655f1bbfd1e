//! Reading of materials files.

use std::collections::BTreeMap;

use dobot_plan::{DrawingTool, Laser, Pen};
use dobot_safety::line_at;
use dobot_teach::nearest;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::{Material, MaterialError};

/// Reads the materials of a file.
pub(super) fn materials(text: &str) -> Result<BTreeMap<String, Material>, MaterialError> {
    let document = DeTable::parse(text).map_err(|error| MaterialError {
        line: line_at(text, error.span().map_or(0, |span| span.start)),
        reason: error.message().trim().replace('\n', ", "),
    })?;
    let root = Table {
        text,
        name: String::new(),
        keys: document.get_ref(),
        line: 0,
    };
    root.knows(&["materials"])?;
    let Some(all) = root.table("materials")? else {
        return Ok(BTreeMap::new());
    };
    let names = all.keys.keys().map(|name| name.get_ref().to_string());
    names
        .map(|name| {
            let table = all.table(&name)?.expect("the name is one of its keys");
            Ok((name, material(&table)?))
        })
        .collect()
}

fn material(table: &Table<'_>) -> Result<Material, MaterialError> {
    let tool = match table.text("tool")?.as_deref() {
        Some("pen") => pen(table)?,
        Some("laser") => laser(table)?,
        Some(other) => return Err(table.wrong("tool", &format!("\"{other}\""), TOOLS)),
        None => return Err(table.missing("tool", TOOLS)),
    };
    let spacing_mm = table.number("spacing_mm", SPACING)?;
    let spacing_mm = spacing_mm.unwrap_or(SPACING_MM);
    Ok(Material { tool, spacing_mm })
}

fn pen(table: &Table<'_>) -> Result<DrawingTool, MaterialError> {
    table.knows(&[
        "tool",
        "speed_mm_s",
        "travel_speed_mm_s",
        "spacing_mm",
        "lift_mm",
        "lift_speed_mm_s",
        "touch_mm",
        "touch_speed_mm_s",
    ])?;
    let mut pen = Pen {
        draw_speed_mm_s: table.speed()?,
        ..Pen::default()
    };
    for (key, range, value) in [
        ("travel_speed_mm_s", SPEED, &mut pen.travel_speed_mm_s),
        ("lift_mm", LIFT, &mut pen.lift_mm),
        ("lift_speed_mm_s", SPEED, &mut pen.lift_speed_mm_s),
        ("touch_mm", TOUCH, &mut pen.touch_mm),
        ("touch_speed_mm_s", SPEED, &mut pen.touch_speed_mm_s),
    ] {
        *value = table.number(key, range)?.unwrap_or(*value);
    }
    Ok(DrawingTool::Pen(pen))
}

fn laser(table: &Table<'_>) -> Result<DrawingTool, MaterialError> {
    table.knows(&[
        "tool",
        "speed_mm_s",
        "travel_speed_mm_s",
        "spacing_mm",
        "passes",
        "cuts",
    ])?;
    let laser = Laser::default();
    Ok(DrawingTool::Laser(Laser {
        burn_speed_mm_s: table.speed()?,
        travel_speed_mm_s: table
            .number("travel_speed_mm_s", SPEED)?
            .unwrap_or(laser.travel_speed_mm_s),
        times: table.passes()?.unwrap_or(laser.times),
        cuts: table.flag("cuts")?.unwrap_or(laser.cuts),
        ..laser
    }))
}

/// A table of the file and its position.
struct Table<'a> {
    text: &'a str,
    /// Its dotted name.
    name: String,
    keys: &'a DeTable<'a>,
    line: usize,
}

impl<'a> Table<'a> {
    /// Refuses a key that is not one of these.
    fn knows(&self, allowed: &[&'static str]) -> Result<(), MaterialError> {
        let known = |key: &str| allowed.contains(&key);
        let Some(unknown) = self.keys.keys().find(|key| !known(key.get_ref())) else {
            return Ok(());
        };
        let key = unknown.get_ref();
        let meant = nearest(key, allowed.iter().copied());
        let meant = meant.map_or_else(String::new, |name| format!("did you mean {name}? "));
        let (path, allowed) = (self.path(key), allowed.join(", "));
        Err(MaterialError {
            line: line_at(self.text, unknown.span().start),
            reason: format!("{path} is unknown; {meant}allowed are: {allowed}"),
        })
    }

    fn table(&self, key: &str) -> Result<Option<Self>, MaterialError> {
        match self.value(key).map(Spanned::get_ref) {
            None => Ok(None),
            Some(DeValue::Table(keys)) => Ok(Some(Self {
                text: self.text,
                name: self.path(key),
                keys,
                line: self.line_of(key),
            })),
            Some(_) => Err(self.kind(key, "a table")),
        }
    }

    fn text(&self, key: &str) -> Result<Option<String>, MaterialError> {
        match self.value(key).map(Spanned::get_ref) {
            None => Ok(None),
            Some(DeValue::String(found)) => Ok(Some(found.to_string())),
            Some(_) => Err(self.kind(key, TOOLS)),
        }
    }

    fn number(&self, key: &str, range: Range) -> Result<Option<f64>, MaterialError> {
        let number = match self.value(key).map(Spanned::get_ref) {
            None => return Ok(None),
            Some(DeValue::Float(number)) => number.as_str().parse().ok(),
            Some(DeValue::Integer(number)) => i64::from_str_radix(number.as_str(), number.radix())
                .ok()
                .map(lossy),
            Some(_) => None,
        };
        match number {
            Some(number) if (range.0..=range.1).contains(&number) => Ok(Some(number)),
            _ => Err(self.kind(key, &range.allowed())),
        }
    }

    fn speed(&self) -> Result<f64, MaterialError> {
        let speed = self.number("speed_mm_s", SPEED)?;
        speed.ok_or_else(|| self.missing("speed_mm_s", &SPEED.allowed()))
    }

    fn passes(&self) -> Result<Option<u32>, MaterialError> {
        let passes = match self.value("passes").map(Spanned::get_ref) {
            None => return Ok(None),
            Some(DeValue::Integer(number)) => {
                u32::from_str_radix(number.as_str(), number.radix()).ok()
            }
            Some(_) => None,
        };
        match passes {
            Some(1..=MAX_PASSES) => Ok(passes),
            _ => Err(self.kind("passes", &format!("a whole number from 1 to {MAX_PASSES}"))),
        }
    }

    fn flag(&self, key: &str) -> Result<Option<bool>, MaterialError> {
        match self.value(key).map(Spanned::get_ref) {
            None => Ok(None),
            Some(DeValue::Boolean(found)) => Ok(Some(*found)),
            Some(_) => Err(self.kind(key, "true or false")),
        }
    }

    fn value(&self, key: &str) -> Option<&'a Spanned<DeValue<'a>>> {
        self.keys.get(key)
    }

    fn line_of(&self, key: &str) -> usize {
        let found = self.keys.keys().find(|other| *other.get_ref() == key);
        found.map_or(self.line, |key| line_at(self.text, key.span().start))
    }

    fn path(&self, key: &str) -> String {
        if self.name.is_empty() {
            return key.to_owned();
        }
        format!("{}.{key}", self.name)
    }

    /// Returns the error for a value of the wrong type or out of range, quoted as in the file.
    fn kind(&self, key: &str, allowed: &str) -> MaterialError {
        let span = self.value(key).map_or(0..0, Spanned::span);
        let found = self.text.get(span).unwrap_or_default();
        let first_line = found.lines().next().unwrap_or_default();
        self.wrong(key, first_line, allowed)
    }

    fn wrong(&self, key: &str, found: &str, allowed: &str) -> MaterialError {
        MaterialError {
            line: self.line_of(key),
            reason: format!("{} is {found}; allowed is {allowed}", self.path(key)),
        }
    }

    fn missing(&self, key: &str, allowed: &str) -> MaterialError {
        MaterialError {
            line: self.line,
            reason: format!("{} is missing; allowed is {allowed}", self.path(key)),
        }
    }
}

/// The range of a number and its unit.
#[derive(Clone, Copy)]
struct Range(f64, f64, &'static str);

impl Range {
    fn allowed(self) -> String {
        let Self(least, most, unit) = self;
        format!("a number from {least} to {most} {unit}")
    }
}

#[expect(
    clippy::cast_precision_loss,
    reason = "beyond 2^53 nothing is in range"
)]
const fn lossy(whole: i64) -> f64 {
    whole as f64
}

const TOOLS: &str = "\"pen\" or \"laser\"";
const SPEED: Range = Range(0.1, 500.0, "mm/s");
const LIFT: Range = Range(0.1, 100.0, "mm");
const TOUCH: Range = Range(0.0, 20.0, "mm");
const SPACING: Range = Range(0.05, 20.0, "mm");
const SPACING_MM: f64 = 0.5;
const MAX_PASSES: u32 = 100;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn error(text: &str) -> String {
        materials(text).unwrap_err().to_string()
    }

    #[test]
    fn an_unknown_key_is_refused_with_the_most_similar_one() {
        assert_eq!(
            error("[materials.oak]\ntool = 'laser'\nsped_mm_s = 4\n"),
            "line 3: materials.oak.sped_mm_s is unknown; did you mean speed_mm_s? allowed are: \
             tool, speed_mm_s, travel_speed_mm_s, spacing_mm, passes, cuts"
        );
        let pen_only = error("[materials.oak]\ntool = 'laser'\nspeed_mm_s = 4\nlift_mm = 5\n");
        assert!(
            pen_only.starts_with("line 4: materials.oak.lift_mm is unknown; "),
            "{pen_only}"
        );
        assert_eq!(
            error("[material.oak]\ntool = 'laser'"),
            "line 1: material is unknown; did you mean materials? allowed are: materials"
        );
    }

    #[test]
    fn a_value_that_is_not_allowed_is_reported_with_its_line_and_range() {
        let with = |line: &str| error(&format!("[materials.oak]\ntool = 'laser'\n{line}\n"));
        assert_eq!(
            with("speed_mm_s = 0"),
            "line 3: materials.oak.speed_mm_s is 0; allowed is a number from 0.1 to 500 mm/s"
        );
        assert_eq!(
            with("speed_mm_s = 'fast'"),
            "line 3: materials.oak.speed_mm_s is 'fast'; allowed is a number from 0.1 to 500 mm/s"
        );
        assert_eq!(
            with("speed_mm_s = nan"),
            "line 3: materials.oak.speed_mm_s is nan; allowed is a number from 0.1 to 500 mm/s"
        );
        assert_eq!(
            with("speed_mm_s = 1\npasses = 1.5"),
            "line 4: materials.oak.passes is 1.5; allowed is a whole number from 1 to 100"
        );
        assert_eq!(
            error("[materials.oak]\ntool = 'saw'\n"),
            "line 2: materials.oak.tool is \"saw\"; allowed is \"pen\" or \"laser\""
        );
    }

    #[test]
    fn settings_that_determine_the_result_are_required() {
        assert_eq!(
            error("\n[materials.oak]\n"),
            "line 2: materials.oak.tool is missing; allowed is \"pen\" or \"laser\""
        );
        assert_eq!(
            error("[materials.oak]\ntool = 'laser'\n"),
            "line 1: materials.oak.speed_mm_s is missing; allowed is a number from 0.1 to 500 mm/s"
        );
        assert_eq!(
            error("materials = 3\n"),
            "line 1: materials is 3; allowed is a table"
        );
    }

    #[test]
    fn invalid_toml_is_reported_with_its_line() {
        assert!(error("[materials.oak]\ntool = \n").starts_with("line 2: "));
        assert_eq!(materials(""), Ok(BTreeMap::new()));
    }

    proptest! {
        #[test]
        fn no_text_makes_it_panic(text in "(\\[?materials[.a-z]{0,4}\\]?|[a-z_]{1,6}|=|[0-9.'\"\\[\\]{}]|\n| |é){0,40}") {
            let _ = materials(&text);
        }

        #[test]
        fn numbers_are_read_as_they_were_written(speed in 0.1..500.0_f64, passes in 1..=100_u32) {
            let text = format!(
                "[materials.m]\ntool = \"laser\"\nspeed_mm_s = {speed:?}\npasses = {passes}\n"
            );
            let read = materials(&text).unwrap()["m"];
            let laser = Laser { burn_speed_mm_s: speed, times: passes, ..Laser::default() };
            prop_assert_eq!(read.tool, DrawingTool::Laser(laser));
        }
    }
}
