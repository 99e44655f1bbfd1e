//! The fields of [`Options`]: their names and numeric ranges.

use std::sync::LazyLock;

use dobot_import::{Shading, Text, Wrap};
use schemars::transform::Transform;
use schemars::{Schema, schema_for};
use serde_json::{Map, Value};

use super::Options;
use crate::layout::test_card::Card;
use crate::prepare::TOLERANCE_MM;

/// The range of a numeric option. It is checked and part of the JSON Schema.
#[derive(Clone, Copy, Debug)]
pub struct OptionRange {
    /// The field, as in `tool.kerf`.
    pub field: &'static str,
    /// The minimum.
    pub least: f64,
    /// The maximum.
    pub most: f64,
    /// The unit; empty for plain numbers.
    pub unit: &'static str,
    /// Returns the value; `None` if it is not given.
    pub(super) value: fn(&Options) -> Option<f64>,
}

/// The ranges of all numbers that are independent of the content.
#[rustfmt::skip]
pub static OPTION_RANGES: [OptionRange; 26] = [
    range("what.height", Text::HEIGHT_MM, "mm", |options| options.what.height),
    range("what.wrap", Wrap::WIDTH_MM, "mm", |options| options.what.wrap),
    range("what.card_passes", Card::PASSES, "times", |options| options.what.card_passes.map(f64::from)),
    range("what.card_size", Card::CELL_MM, "mm", |options| options.what.card_size),
    range("what.card_gap", Card::GAP_MM, "mm", |options| options.what.card_gap),
    range("what.hatch_inset", [0.0, 20.0], "mm", |options| Some(options.what.hatch_inset)),
    range("what.brightness", [-100.0, 100.0], "percent", |options| Some(options.what.brightness)),
    range("what.contrast", [-100.0, 100.0], "percent", |options| Some(options.what.contrast)),
    range("what.gamma", [0.1, 10.0], "", |options| Some(options.what.gamma)),
    range("what.threshold", [0.01, 0.99], "", |options| options.what.threshold),
    range("what.levels", Shading::LEVELS, "", |options| options.what.levels.map(f64::from)),
    range("place.gap", [0.0, 1000.0], "mm", |options| Some(options.place.gap)),
    range("place.pen_down", [-500.0, 500.0], "mm", |options| options.place.pen_down),
    range("place.offset", [-100.0, 100.0], "mm", |options| Some(options.place.offset)),
    range("tool.lift", [0.0, 200.0], "mm", |options| options.tool.lift),
    range("tool.speed", [0.0, 1000.0], "mm/s", |options| options.tool.speed),
    range("tool.travel_speed", [0.0, 1000.0], "mm/s", |options| options.tool.travel_speed),
    range("tool.passes", [1.0, 100.0], "times", |options| options.tool.passes.map(f64::from)),
    range("tool.kerf", [-5.0, 5.0], "mm", |options| Some(options.tool.kerf)),
    range("tool.lead_in", [0.0, 20.0], "mm", |options| Some(options.tool.lead_in)),
    range("tool.overcut", [0.0, 20.0], "mm", |options| Some(options.tool.overcut)),
    range("tool.tabs", [0.0, 100.0], "tabs", |options| Some(options.tool.tabs.into())),
    range("tool.tab_width", [0.1, 20.0], "mm", |options| Some(options.tool.tab_width)),
    range("tool.acceleration", [0.0, 10_000.0], "mm/s2", |options| Some(options.tool.acceleration)),
    range("way.tolerance", TOLERANCE_MM, "mm", |options| Some(options.way.tolerance)),
    range("way.join", [0.0, 20.0], "mm", |options| options.way.join),
];

impl PartialEq for OptionRange {
    /// Each field has one range.
    fn eq(&self, other: &Self) -> bool {
        self.field == other.field
    }
}

const fn range(
    field: &'static str,
    [least, most]: [f64; 2],
    unit: &'static str,
    value: fn(&Options) -> Option<f64>,
) -> OptionRange {
    OptionRange {
        field,
        least,
        most,
        unit,
        value,
    }
}

/// Adds the ranges of a group of options to its schema.
pub(super) struct Ranges(pub(super) &'static str);

impl Transform for Ranges {
    fn transform(&mut self, schema: &mut Schema) {
        let properties = schema.get_mut("properties").and_then(Value::as_object_mut);
        let Some(properties) = properties else {
            return;
        };
        for range in &OPTION_RANGES {
            let name = range.field.strip_prefix(self.0);
            let name = name.and_then(|name| name.strip_prefix('.'));
            let property = name.and_then(|name| properties.get_mut(name));
            if let Some(property) = property.and_then(Value::as_object_mut) {
                property.insert("minimum".to_owned(), range.least.into());
                property.insert("maximum".to_owned(), range.most.into());
            }
        }
    }
}

impl Options {
    /// Returns the fields by group: an object per group with the default value of each field.
    #[must_use]
    pub fn fields() -> &'static Map<String, Value> {
        static FIELDS: LazyLock<Map<String, Value>> = LazyLock::new(|| {
            let options = serde_json::to_value(Options::default());
            match options.expect("its keys are texts and its numbers are finite") {
                Value::Object(groups) => groups,
                other => panic!("options are an object, and not {other}"),
            }
        });
        &FIELDS
    }

    /// Returns the description of a field of any group.
    #[must_use]
    pub fn description(field: &str) -> Option<&'static str> {
        static SCHEMA: LazyLock<Schema> = LazyLock::new(|| schema_for!(Options));
        let groups = SCHEMA.get("properties")?.as_object()?.values();
        let mut groups = groups.filter_map(|group| {
            let pointer = group.get("$ref")?.as_str()?.strip_prefix('#')?;
            SCHEMA.as_value().pointer(pointer)
        });
        groups.find_map(|group| group.get("properties")?.get(field)?["description"].as_str())
    }

    /// Replaces the fields in a text, such as `tool.kerf`, by the result of `name` for `kerf`.
    /// Errors, warnings and descriptions of this crate name fields; the command line shows options
    /// instead, and Python arguments.
    ///
    /// ```
    /// use dobot_draw::Options;
    ///
    /// let error = "tool.lead_in is 30 mm; it takes 0 to 20 mm";
    /// let renamed = Options::rename_fields(error, |field| format!("--{}", field.replace('_', "-")));
    /// assert_eq!(renamed, "--lead-in is 30 mm; it takes 0 to 20 mm");
    /// ```
    #[must_use]
    pub fn rename_fields(text: &str, name: impl Fn(&str) -> String) -> String {
        let is_part = |letter: char| letter.is_alphanumeric() || "_./".contains(letter);
        let mut renamed = String::with_capacity(text.len());
        let mut rest = text;
        while let Some(start) = rest.find(is_part) {
            renamed.push_str(&rest[..start]);
            rest = &rest[start..];
            let end = rest.find(|letter| !is_part(letter));
            let (word, after) = rest.split_at(end.unwrap_or(rest.len()));
            // A full stop after the field ends the sentence.
            let bare = word.trim_end_matches('.');
            match field(bare) {
                Some(field) => {
                    renamed.push_str(&name(field));
                    renamed.push_str(&word[bare.len()..]);
                }
                None => renamed.push_str(word),
            }
            rest = after;
        }
        renamed.push_str(rest);
        renamed
    }
}

/// Returns the name of a field in its group if the word is a field, as in `tool.kerf`.
fn field(word: &str) -> Option<&str> {
    let (group, field) = word.split_once('.')?;
    Options::fields().get(group)?.get(field).map(|_| field)
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    #[test]
    fn each_range_is_that_of_a_number_and_holds_its_default() {
        for range in &OPTION_RANGES {
            assert_eq!(
                field(range.field),
                range.field.split('.').nth(1),
                "{range:?}"
            );
            if let Some(default) = (range.value)(&Options::default()) {
                assert!((range.least..=range.most).contains(&default), "{range:?}");
            }
        }
    }

    #[test]
    fn the_schema_has_the_ranges() {
        let schema = schema_for!(Options);
        let kerf = schema
            .as_value()
            .pointer("/$defs/ToolOptions/properties/kerf");
        let kerf = kerf.unwrap();
        assert_eq!(kerf["minimum"], -5.0);
        assert_eq!(kerf["maximum"], 5.0);
    }

    #[test]
    fn a_field_is_described_as_in_its_group() {
        assert_eq!(Options::description("pen"), Some("Pen to draw with"));
        assert_eq!(Options::description("name"), None);
    }

    #[test]
    fn only_fields_are_renamed() {
        let shout = |field: &str| field.to_uppercase();
        for (text, renamed) in [
            ("tool.kerf", "KERF"),
            (
                "`place.fit`, instead of `place.scale 2`.",
                "`FIT`, instead of `SCALE 2`.",
            ),
            ("it takes what.hide.", "it takes HIDE."),
            ("a/place.fit is a file", "a/place.fit is a file"),
            ("place.turn, tool. and .kerf", "place.turn, tool. and .kerf"),
            ("", ""),
        ] {
            assert_eq!(Options::rename_fields(text, shout), renamed);
        }
    }
}
