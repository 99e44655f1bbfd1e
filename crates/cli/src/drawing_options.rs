//! The options of a drawing as arguments: one for each field of [`Options`], with the field's documentation as its help.

use std::collections::HashMap;
use std::str::FromStr;
use std::sync::LazyLock;

use clap::builder::ValueParser;
use clap::error::ErrorKind;
use clap::parser::ValueSource;
use clap::{Arg, ArgAction, ArgMatches, Command, value_parser};
use dobot_draw::{Grid, HatchStyle, LayerTool, Options, PaperSize, PassesBy, ResumePoint, Spacing};
use dobot_import::{Align, GcodeTool, LayersBy, ShadingStyle};
use serde::Serialize;
use serde_json::{Map, Value};

/// The options of a drawing, as arguments.
#[derive(Clone, Debug)]
pub(crate) struct DrawingOptions(pub(crate) Options);

/// Returns the arguments in the order of the help.
#[expect(clippy::too_many_lines, reason = "a table")]
fn rows() -> Vec<Row> {
    // table
    let source = vec![
        text("text", "TEXT").arg(|arg| arg.conflicts_with("card")),
        text("font", "NAME"),
        number("height", "MM"),
        parsed::<Align>("align", "SIDE"),
        number("wrap", "MM"),
        flag("justify").arg(|arg| arg.conflicts_with("align")),
        several::<f64>("card", ValueParser::new(card_speed))
            .arg(|arg| arg.value_name("SPEED,...").value_delimiter(',')),
        whole::<u32>("card_passes"),
        number("card_size", "MM"),
        number("card_gap", "MM"),
        text("card_label", "TEXT"),
        parsed::<LayersBy>("layers", "BY"),
        several::<LayerTool>("layer", parser::<LayerTool>())
            .arg(|arg| arg.value_name("NAME=PEN").requires("layers")),
        several::<String>("only", value_parser!(String))
            .arg(|arg| arg.value_name("NAME").requires("layers")),
        flag("no_crop"),
        parsed::<GcodeTool>("gcode", "TOOL"),
        flag("strict"),
        flag("hide"),
        flag("white_edges"),
        parsed::<Spacing>("hatch", "MM")
            .arg(|arg| arg.num_args(0..=1).default_missing_value("auto")),
        number("hatch_angle", "DEGREES").arg(|arg| arg.requires("hatch")),
        parsed::<HatchStyle>("hatch_style", "STYLE").arg(|arg| arg.requires("hatch")),
        number("hatch_inset", "MM").arg(|arg| arg.requires("hatch")),
        flag("cross").arg(|arg| arg.requires("hatch")),
        parsed::<ShadingStyle>("shade", "STYLE"),
        number("spacing", "MM"),
        number("brightness", "PERCENT"),
        number("contrast", "PERCENT"),
        number("gamma", "GAMMA"),
        number("threshold", "DARKNESS"),
        whole::<u8>("levels").arg(|arg| arg.conflicts_with("threshold")),
        flag("invert"),
    ];
    let paper = vec![
        parsed::<PaperSize>("paper_size", "SIZE"),
        flag("landscape").arg(|arg| arg.requires("paper_size")),
        several::<f64>("corner", ValueParser::new(finite)).arg(|arg| {
            arg.num_args(2)
                .value_names(["X", "Y"])
                .requires("paper_size")
                .conflicts_with_all(["at", "paper"])
        }),
        flag("fit").arg(|arg| arg.conflicts_with("scale")),
        positive("scale", "FACTOR"),
        several::<f64>("at", ValueParser::new(finite))
            .arg(|arg| arg.num_args(2).value_names(["X", "Y"])),
        flag("mirror"),
        parsed::<Grid>("grid", "GRID"),
        number("gap", "MM"),
        number("rotate", "DEGREES"),
        number("margin", "MM"),
        flag("border"),
        flag("crop_marks"),
        text("sign", "TEXT"),
        flag("clip"),
        number("pen_down", "Z").arg(|arg| arg.conflicts_with("paper")),
        several::<f64>("paper", ValueParser::new(finite)).arg(|arg| {
            arg.num_args(9)
                .value_names(["X", "Y", "Z", "X", "Y", "Z", "X", "Y", "Z"])
        }),
        number("offset", "MM"),
    ];
    let laser = |row: Row| row.arg(|arg| arg.help_heading("Laser"));
    let cut = |row: Row| laser(row).arg(|arg| arg.requires("laser"));
    let run = vec![
        text("pen", "PEN").arg(|arg| arg.conflicts_with("laser").help_heading("Pen")),
        laser(text("laser", "MATERIAL")),
        number("lift", "MM").arg(|arg| arg.help_heading("Pen")),
        positive("speed", "MM/S"),
        positive("travel_speed", "MM/S"),
        whole::<u32>("passes"),
        cut(parsed::<PassesBy>("passes_by", "WHAT")),
        cut(number("kerf", "MM")),
        cut(number("lead_in", "MM")),
        cut(number("overcut", "MM")),
        cut(whole::<u32>("tabs")),
        laser(number("tab_width", "MM")).arg(|arg| arg.requires("tabs")),
        positive("acceleration", "MM/S2"),
        number("tolerance", "MM"),
        number("join", "MM"),
        flag("drop_doubles"),
        flag("keep_order"),
        whole::<u32>("tries").arg(|arg| arg.conflicts_with("keep_order")),
        whole::<u64>("seed"),
        parsed::<ResumePoint>("from", "WHERE"),
    ];
    let under = |heading: &'static str| {
        move |row: Row| match row.arg.get_help_heading() {
            Some(_) => row,
            None => row.arg(|arg| arg.help_heading(heading)),
        }
    };
    let source = source.into_iter().map(under("Source"));
    let paper = paper.into_iter().map(under("Paper"));
    let run = run.into_iter().map(under("Run"));
    source.chain(paper).chain(run).collect()
}

/// The fields that the short help shows.
const COMMON: [&str; 20] = [
    "text",
    "font",
    "height",
    "layers",
    "hatch",
    "shade",
    "paper_size",
    "landscape",
    "fit",
    "scale",
    "at",
    "grid",
    "rotate",
    "margin",
    "pen_down",
    "pen",
    "laser",
    "speed",
    "passes",
    "from",
];

/// An argument, and the conversion of its value to JSON.
struct Row {
    field: &'static str,
    arg: Arg,
    value: fn(&ArgMatches, &str) -> Value,
}

impl Row {
    fn arg(mut self, change: impl FnOnce(Arg) -> Arg) -> Self {
        self.arg = change(self.arg);
        self
    }
}

fn row(field: &'static str, arg: Arg, value: fn(&ArgMatches, &str) -> Value) -> Row {
    let arg = arg.long(&*Field::named(field).option);
    Row { field, arg, value }
}

fn flag(field: &'static str) -> Row {
    let arg = Arg::new(field).action(ArgAction::SetTrue);
    row(field, arg, |matches, field| matches.get_flag(field).into())
}

fn one<T: Clone + Serialize + Send + Sync + 'static>(
    field: &'static str,
    value_name: &'static str,
    parser: ValueParser,
) -> Row {
    let arg = Arg::new(field)
        .action(ArgAction::Set)
        .value_name(value_name)
        .value_parser(parser);
    row(field, arg, |matches, field| {
        json(&matches.get_one::<T>(field))
    })
}

fn several<T: Clone + Serialize + Send + Sync + 'static>(
    field: &'static str,
    parser: ValueParser,
) -> Row {
    let arg = Arg::new(field)
        .action(ArgAction::Append)
        .value_parser(parser);
    row(field, arg, |matches, field| {
        let all = matches.get_many::<T>(field).unwrap_or_default();
        json(&all.collect::<Vec<_>>())
    })
}

fn text(field: &'static str, value_name: &'static str) -> Row {
    one::<String>(field, value_name, value_parser!(String))
}

fn number(field: &'static str, value_name: &'static str) -> Row {
    one::<f64>(field, value_name, ValueParser::new(finite))
}

fn positive(field: &'static str, value_name: &'static str) -> Row {
    let parse = |text: &str| {
        let value = finite(text).ok().filter(|value| *value > 0.0);
        value.ok_or("expected a number above 0")
    };
    one::<f64>(field, value_name, ValueParser::new(parse))
}

fn whole<T>(field: &'static str) -> Row
where
    T: FromStr + Clone + Serialize + Send + Sync + 'static,
{
    let parse = |text: &str| {
        let value = text.parse::<T>();
        value.map_err(|_| "expected a whole number, 0 or more")
    };
    one::<T>(field, "N", ValueParser::new(parse))
}

fn parsed<T>(field: &'static str, value_name: &'static str) -> Row
where
    T: FromStr<Err = &'static str> + Clone + Serialize + Send + Sync + 'static,
{
    one::<T>(field, value_name, parser::<T>())
}

fn parser<T>() -> ValueParser
where
    T: FromStr<Err = &'static str> + Clone + Send + Sync + 'static,
{
    ValueParser::new(|text: &str| text.parse::<T>())
}

/// Parses a finite number, the only kind that JSON has.
fn finite(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        _ => Err("expected a finite number".to_owned()),
    }
}

fn card_speed(text: &str) -> Result<f64, &'static str> {
    finite(text).map_err(|_| {
        "expected speeds in mm/s, separated by commas, as in 2,5,10; a test card is drawn without a file"
    })
}

fn json(value: &impl Serialize) -> Value {
    serde_json::to_value(value).expect("the keys are strings")
}

impl clap::Args for DrawingOptions {
    fn augment_args(command: Command) -> Command {
        let args = rows().into_iter().map(|row| {
            let is_rare = !COMMON.contains(&row.field);
            let arg = row.arg.help(help(row.field)).hide_short_help(is_rare);
            match &Field::named(row.field).default {
                Some(default) => arg.default_value(&**default),
                None => arg,
            }
        });
        command.args(args)
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl clap::FromArgMatches for DrawingOptions {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let mut all = Map::new();
        let is_given = |field: &str| matches.value_source(field) == Some(ValueSource::CommandLine);
        for row in rows().into_iter().filter(|row| is_given(row.field)) {
            let group = all.entry(&*Field::named(row.field).group);
            group.or_insert_with(|| Map::new().into())[row.field] = (row.value)(matches, row.field);
        }
        let options = serde_json::from_value(all.into());
        let wrong = |error: serde_json::Error| clap::Error::raw(ErrorKind::InvalidValue, error);
        options.map(Self).map_err(wrong)
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

/// Replaces the field names in a text about a drawing by options of the command line.
pub(crate) fn with_option_names(text: &str) -> String {
    Options::rename_fields(text, |field| format!("--{}", option_name(field)))
}

/// Returns the option of a field, without dashes.
pub(crate) fn option_name(field: &str) -> String {
    field.replace('_', "-")
}

/// A field, as the command line needs it.
struct Field {
    group: String,
    option: String,
    /// The default value that the help shows.
    default: Option<String>,
}

impl Field {
    fn named(name: &str) -> &'static Self {
        static ALL: LazyLock<HashMap<String, Field>> = LazyLock::new(|| {
            let groups = Options::fields().iter();
            let fields = groups.flat_map(|(group, fields)| {
                let fields = fields.as_object().into_iter().flatten();
                fields.map(move |(name, default)| (group, name, default))
            });
            let named = fields.map(|(group, name, default)| {
                let field = Field {
                    group: group.clone(),
                    option: option_name(name),
                    default: shown_default(default),
                };
                (name.clone(), field)
            });
            named.collect()
        });
        &ALL[name]
    }
}

/// Formats a default for the help; `None` if it is not worth showing.
fn shown_default(default: &Value) -> Option<String> {
    match default {
        Value::Number(number) => number.as_f64().map(|number| number.to_string()),
        Value::String(text) => Some(text.clone()),
        _ => None,
    }
}

/// Converts the documentation of a field to a help text.
fn help(field: &str) -> String {
    let docs = Options::description(field).expect("every field is documented");
    let help = with_option_names(&docs.replace('\n', " "));
    // Options are shown without backticks.
    let parts = help.split('`').enumerate();
    let bare = parts.map(|(n, part)| match n % 2 {
        1 if !part.starts_with("--") => format!("`{part}`"),
        _ => part.to_owned(),
    });
    bare.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_field_is_an_option() {
        let groups = Options::fields().values().filter_map(Value::as_object);
        let fields: Vec<&String> = groups.flat_map(Map::keys).collect();
        let rows: Vec<&str> = rows().iter().map(|row| row.field).collect();
        assert_eq!(rows, fields);
        assert!(COMMON.iter().all(|field| rows.contains(field)));
    }
}
