//! A key of a file of defaults, converted to words of a command line.

use std::any::TypeId;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

use anyhow::anyhow;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Arg, ArgAction, Args, Command, CommandFactory, Id};
use dobot_safety::line_at;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::Cli;
use crate::command_line;
use crate::drawing_options::DrawingOptions;
use crate::failure::Failure;
use crate::renamed::draw_option;

/// A default.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    /// Its long name, without dashes.
    pub(super) option: String,
    pub(super) id: Id,
    /// The line in the file, counted from 1.
    pub(super) line: usize,
    /// The default as words of a command line.
    pub(super) words: Vec<OsString>,
    /// The options without which it has no effect, with dashes.
    pub(super) needs: Vec<String>,
    /// The reason why it is not used, if it is not.
    pub(super) unused: Option<String>,
}

impl Entry {
    pub(super) const fn is_used(&self) -> bool {
        self.unused.is_none()
    }
}

/// Reads the defaults of a file in their order, and checks each of them.
pub(super) fn entries(file: &Path, text: &str) -> Result<Vec<Entry>, Failure> {
    let wrong = |at: usize, reason: &str| {
        let line = line_at(text, at);
        anyhow!("{}, line {line}: {reason}", file.display())
    };
    let document = DeTable::parse(text).map_err(|error| {
        let at = error.span().map_or(0, |span| span.start);
        wrong(at, &error.message().trim().replace('\n', ", "))
    })?;
    let mut keys: Vec<_> = document.get_ref().iter().collect();
    keys.sort_by_key(|(key, _)| key.span().start);
    let known = known();
    let folder = file.parent().unwrap_or(Path::new(""));
    let entry = |(key, value): (&Spanned<_>, &Spanned<DeValue<'_>>)| {
        let ((option, renamed), at) = (draw_option(&key_text(key)), key.span().start);
        if let Some(hint) = renamed {
            eprintln!("hint: {}: {hint}", file.display());
        }
        let Some(arg) = known.iter().find(|arg| arg.get_long() == Some(&option)) else {
            return Err(Failure::new(wrong(at, &unknown(&option, &known)), KEYS));
        };
        let refused = |allowed: &str| {
            let found = text.get(value.span()).unwrap_or_default();
            let found = found.lines().next().unwrap_or_default();
            wrong(at, &format!("{option} is {found}; {allowed}"))
        };
        let kind = Kind::of(arg);
        let words = kind.words(&option, value.get_ref(), folder);
        let words = words.ok_or_else(|| refused(&kind.allowed()))?;
        let needs = needs(&words).map_err(|reason| refused(&reason))?;
        Ok(Entry {
            id: arg.get_id().clone(),
            line: line_at(text, at),
            option,
            words,
            needs,
            unused: None,
        })
    };
    keys.into_iter().map(entry).collect()
}

/// The options of `draw` that a file may have: all except those that select what is drawn.
pub(in crate::verbs::draw) fn known() -> Vec<Arg> {
    let options = DrawingOptions::augment_args(Command::new("draw"));
    let others = ["materials", "outline"];
    let program = Cli::command();
    let draw = program
        .find_subcommand("draw")
        .expect("`draw` is a subcommand");
    let others = draw
        .get_arguments()
        .filter(|arg| others.contains(&arg.get_id().as_str()));
    let is_lasting =
        |arg: &&Arg| !["text", "card", "card_label", "from"].contains(&arg.get_id().as_str());
    let lasting = options.get_arguments().filter(is_lasting);
    lasting.chain(others).cloned().collect()
}

fn unknown(option: &str, known: &[Arg]) -> String {
    let parsed = command_line::parse(["dobot", "draw", "FILE", &format!("--{option}")]);
    let suggested = parsed
        .err()
        .and_then(|error| match error.get(ContextKind::SuggestedArg)? {
            ContextValue::String(option) => option.strip_prefix("--").map(str::to_owned),
            _ => None,
        });
    let is_known = |option: &String| known.iter().any(|arg| arg.get_long() == Some(option));
    let meant = suggested.filter(is_known);
    let meant = meant.map_or_else(String::new, |option| format!("; did you mean {option}?"));
    format!("{option} is not a key of a file of defaults{meant}")
}

/// The kind of a value.
struct Kind {
    /// Whether the option is allowed without a value.
    alone: bool,
    /// Whether it takes values.
    takes: bool,
    /// The number of values.
    count: usize,
    /// Whether it may be repeated.
    repeats: bool,
    of: ValueKind,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum ValueKind {
    Number,
    Whole,
    Path,
    /// A text, or a number that is read as a text.
    Text,
}

impl Kind {
    fn of(arg: &Arg) -> Self {
        let id = arg.get_value_parser().type_id();
        let is = |one: TypeId| id == one;
        let of = if is(TypeId::of::<f64>()) {
            ValueKind::Number
        } else if [TypeId::of::<u8>(), TypeId::of::<u32>(), TypeId::of::<u64>()]
            .into_iter()
            .any(is)
        {
            ValueKind::Whole
        } else if is(TypeId::of::<PathBuf>()) {
            ValueKind::Path
        } else {
            ValueKind::Text
        };
        let takes = matches!(arg.get_action(), ArgAction::Set | ArgAction::Append);
        let range = arg.get_num_args();
        Self {
            alone: !takes || range.is_some_and(|range| range.min_values() == 0),
            takes,
            count: range.map_or(1, |range| range.max_values()),
            repeats: matches!(arg.get_action(), ArgAction::Append),
            of,
        }
    }

    /// Converts a value to words of a command line; `None` if it is not allowed.
    fn words(&self, option: &str, value: &DeValue<'_>, folder: &Path) -> Option<Vec<OsString>> {
        let long = format!("--{option}");
        let joined = |value: OsString| {
            let mut word = OsString::from(format!("{long}="));
            word.push(value);
            word
        };
        match value {
            DeValue::Boolean(given) if self.alone => {
                Some(given.then(|| long.into()).into_iter().collect())
            }
            DeValue::Array(all) if self.count > 1 && all.len() == self.count => {
                let values = all.iter().map(|one| self.value(one.get_ref(), folder));
                std::iter::once(Some(long.into())).chain(values).collect()
            }
            DeValue::Array(all) if self.repeats && self.count == 1 => {
                let values = all
                    .iter()
                    .map(|one| self.value(one.get_ref(), folder).map(joined));
                values.collect()
            }
            one if self.takes && self.count == 1 => Some(vec![joined(self.value(one, folder)?)]),
            _ => None,
        }
    }

    fn value(&self, value: &DeValue<'_>, folder: &Path) -> Option<OsString> {
        let number = match value {
            DeValue::String(text) => {
                return match self.of {
                    ValueKind::Path => Some(folder.join(&**text).into()),
                    ValueKind::Text => Some(text.to_string().into()),
                    _ => None,
                };
            }
            DeValue::Integer(number) => i64::from_str_radix(number.as_str(), number.radix())
                .ok()?
                .to_string(),
            DeValue::Float(number) => number.as_str().parse::<f64>().ok()?.to_string(),
            _ => return None,
        };
        let allowed = match self.of {
            ValueKind::Number | ValueKind::Text => true,
            ValueKind::Whole => matches!(value, DeValue::Integer(_)),
            ValueKind::Path => false,
        };
        allowed.then(|| number.into())
    }

    /// Describes the allowed values.
    fn allowed(&self) -> String {
        let one = match self.of {
            ValueKind::Number => "a number",
            ValueKind::Whole => "a whole number, 0 or more",
            ValueKind::Path => "a file name in quotation marks",
            ValueKind::Text => "a text in quotation marks",
        };
        match (self.takes, self.alone) {
            (false, _) => "expected true or false".to_owned(),
            (_, true) => "expected true, false or the value of the option".to_owned(),
            _ if self.count > 1 => format!("expected {} numbers in brackets", self.count),
            _ if self.repeats => format!("expected {one}, or several in brackets"),
            _ => format!("expected {one}"),
        }
    }
}

/// Returns the options without which the words have no effect, or the problem of their value.
fn needs(words: &[OsString]) -> Result<Vec<String>, String> {
    let program = ["dobot", "draw", "FILE"].map(OsString::from).into_iter();
    let Err(error) = command_line::parse(program.chain(words.iter().cloned())) else {
        return Ok(Vec::new());
    };
    if error.kind() == ErrorKind::MissingRequiredArgument
        && let Some(ContextValue::Strings(missing)) = error.get(ContextKind::InvalidArg)
    {
        let long = |arg: &String| arg.split(' ').next().map(str::to_owned);
        return Ok(missing.iter().filter_map(long).collect());
    }
    let reason = std::error::Error::source(&error).map(ToString::to_string);
    Err(reason.unwrap_or_else(|| error.kind().to_string()))
}

fn key_text(key: &Spanned<toml::de::DeString<'_>>) -> String {
    key.get_ref().to_string()
}

const KEYS: &str =
    "use long options of `dobot draw --help` as keys; what is drawn is given on the command line";
