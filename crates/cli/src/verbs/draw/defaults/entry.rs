//! One key of a file of defaults, as words of a command line.

use std::any::TypeId;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

use anyhow::anyhow;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Arg, ArgAction, Args, Command, CommandFactory, Id, Parser};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::Cli;
use crate::drawing_options::DrawingOptions;
use crate::failure::Failure;
use crate::renamed::draw_option;

/// A default.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    /// Its long name, without dashes.
    pub(super) option: String,
    pub(super) id: Id,
    /// Where it stands in the file, counted from 1.
    pub(super) line: usize,
    /// The same on a command line.
    pub(super) words: Vec<OsString>,
    /// The options without which it does nothing, with their dashes.
    pub(super) needs: Vec<String>,
    /// Why it is not used; none where it is.
    pub(super) unused: Option<String>,
}

impl Entry {
    pub(super) const fn is_used(&self) -> bool {
        self.unused.is_none()
    }
}

/// The defaults of a file, in its order, each checked for itself.
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
        let Some(arg) = known.iter().find(|it| it.get_long() == Some(&option)) else {
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

/// The options of `draw` that a file may have: those that do not say what is drawn this time.
pub(in crate::verbs::draw) fn known() -> Vec<Arg> {
    let options = DrawingOptions::augment_args(Command::new("draw"));
    let others = ["materials", "outline"];
    let program = Cli::command();
    let draw = program.find_subcommand("draw").expect("it is a verb");
    let others = draw
        .get_arguments()
        .filter(|it| others.contains(&it.get_id().as_str()));
    let is_lasting =
        |it: &&Arg| !["text", "card", "card_label", "from"].contains(&it.get_id().as_str());
    let lasting = options.get_arguments().filter(is_lasting);
    lasting.chain(others).cloned().collect()
}

fn unknown(option: &str, known: &[Arg]) -> String {
    let parsed = Cli::try_parse_from(["dobot", "draw", "FILE", &format!("--{option}")]);
    let suggested = parsed
        .err()
        .and_then(|error| match error.get(ContextKind::SuggestedArg)? {
            ContextValue::String(it) => it.strip_prefix("--").map(str::to_owned),
            _ => None,
        });
    let is_known = |it: &String| known.iter().any(|arg| arg.get_long() == Some(it));
    let meant = suggested.filter(is_known);
    let meant = meant.map_or_else(String::new, |it| format!("; did you mean {it}?"));
    format!("{option} is no key of a file of defaults{meant}")
}

/// What a value has to be.
struct Kind {
    /// The option can stand alone.
    alone: bool,
    /// It takes a value at all.
    takes: bool,
    /// It takes so many.
    count: usize,
    /// It may be given again and again.
    repeats: bool,
    of: ValueKind,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum ValueKind {
    Number,
    Whole,
    Path,
    /// A text, or a number where that can be read as one.
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
            alone: !takes || range.is_some_and(|it| it.min_values() == 0),
            takes,
            count: range.map_or(1, |it| it.max_values()),
            repeats: matches!(arg.get_action(), ArgAction::Append),
            of,
        }
    }

    /// The same on a command line; none where it is not allowed.
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
                let values = all.iter().map(|it| self.value(it.get_ref(), folder));
                std::iter::once(Some(long.into())).chain(values).collect()
            }
            DeValue::Array(all) if self.repeats && self.count == 1 => {
                let values = all
                    .iter()
                    .map(|it| self.value(it.get_ref(), folder).map(joined));
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
            DeValue::Integer(it) => i64::from_str_radix(it.as_str(), it.radix())
                .ok()?
                .to_string(),
            DeValue::Float(it) => it.as_str().parse::<f64>().ok()?.to_string(),
            _ => return None,
        };
        let allowed = match self.of {
            ValueKind::Number | ValueKind::Text => true,
            ValueKind::Whole => matches!(value, DeValue::Integer(_)),
            ValueKind::Path => false,
        };
        allowed.then(|| number.into())
    }

    /// What is allowed, for a person.
    fn allowed(&self) -> String {
        let one = match self.of {
            ValueKind::Number => "a number",
            ValueKind::Whole => "a whole number from 0 on",
            ValueKind::Path => "the name of a file in quotation marks",
            ValueKind::Text => "a text in quotation marks",
        };
        match (self.takes, self.alone) {
            (false, _) => "allowed are true and false".to_owned(),
            (_, true) => {
                "allowed are true, false and what stands behind it on a command line".to_owned()
            }
            _ if self.count > 1 => format!("allowed are {} numbers in brackets", self.count),
            _ if self.repeats => format!("allowed is {one}, or several in brackets"),
            _ => format!("allowed is {one}"),
        }
    }
}

/// The options without which these words do nothing; or what is wrong with their value.
fn needs(words: &[OsString]) -> Result<Vec<String>, String> {
    let program = ["dobot", "draw", "FILE"].map(OsString::from).into_iter();
    let Err(error) = Cli::try_parse_from(program.chain(words.iter().cloned())) else {
        return Ok(Vec::new());
    };
    if error.kind() == ErrorKind::MissingRequiredArgument
        && let Some(ContextValue::Strings(missing)) = error.get(ContextKind::InvalidArg)
    {
        let long = |it: &String| it.split(' ').next().map(str::to_owned);
        return Ok(missing.iter().filter_map(long).collect());
    }
    let reason = std::error::Error::source(&error).map(ToString::to_string);
    Err(reason.unwrap_or_else(|| error.kind().to_string()))
}

fn key_text(key: &Spanned<toml::de::DeString<'_>>) -> String {
    key.get_ref().to_string()
}

/// The line of a place in a text, counted from 1.
fn line_at(text: &str, offset: usize) -> usize {
    let before = text.get(..offset);
    before.map_or(1, |before| before.split('\n').count())
}

const KEYS: &str = "keys are the long options of `dobot draw --help` that say how it is drawn, where, and with what; \
    what is drawn stands on the command line";
