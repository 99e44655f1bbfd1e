//! Defaults for `dobot draw`: a file whose keys are its long options. They are inserted before the arguments of the
//! command line, so that one parser reads both.

mod entry;

use std::ffi::OsString;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use anyhow::{Context, anyhow};
use clap::builder::Resettable;
use clap::parser::ValueSource;
use clap::{ArgMatches, Command, CommandFactory, Id};
use dobot_draw::{OptionsError, Subject};
use serde::Serialize;

pub(super) use self::entry::known;
use self::entry::{Entry, entries};
use super::args::{ALL_DEFAULTS, Args};
use crate::Cli;
use crate::bounded;
use crate::command_line;
use crate::drawing_options::{option_name, with_option_names};
use crate::failure::{ErrorFormat, Failure};
use crate::reach::folders;
use crate::verbs::Verb;

/// A file of defaults, and the arguments of the command line.
#[derive(Clone, Debug)]
pub(crate) struct Defaults {
    file: PathBuf,
    entries: Vec<Entry>,
    /// The words after `draw`.
    words: Vec<OsString>,
    /// The options on the command line.
    given: Vec<Id>,
}

/// The defaults of a drawing, for its report.
#[derive(Debug, Serialize)]
pub(super) struct DefaultsLine {
    pub(super) file: String,
    /// The options that the file sets.
    pub(super) used: Vec<String>,
    /// The options that are neither used nor on the command line.
    pub(super) unused: Vec<UnusedLine>,
}

/// A default that this drawing does not use.
#[derive(Debug, Serialize)]
pub(super) struct UnusedLine {
    pub(super) option: String,
    pub(super) why: String,
}

/// Parses a `draw` command line with the defaults of its file. `None` for another command, without such a file, and
/// for an invalid command line, which the ordinary parser then reports.
pub(crate) fn read(words: &[OsString]) -> Option<Result<Verb, Failure>> {
    let arguments = words.get(2..).filter(|_| words[1] == "draw")?;
    let matches = without_rules().try_get_matches_from(words).ok()?;
    let (_, given) = matches.subcommand()?;
    let defaults = Defaults::of(given, arguments).transpose()?;
    Some(defaults.and_then(|defaults| defaults.args().map(|args| Verb::Draw(Box::new(args)))))
}

/// The program with options that neither require nor exclude others.
fn without_rules() -> Command {
    let none = || Resettable::<Id>::Reset;
    Cli::command().mut_subcommand("draw", |draw| {
        draw.mut_args(|arg| {
            arg.requires(none())
                .conflicts_with(none())
                .required_unless_present(none())
        })
    })
}

/// Returns whether one option excludes the other.
fn excludes(draw: &Command, one: &Id, other: &Id) -> bool {
    let conflict = |a, b: &clap::Arg| {
        let all = draw.get_arg_conflicts_with(a);
        all.iter().any(|arg| arg.get_id() == b.get_id())
    };
    let (one, other) = (argument(draw, one), argument(draw, other));
    one.zip(other)
        .is_some_and(|(a, b)| conflict(a, b) || conflict(b, a))
}

impl Defaults {
    fn of(given: &ArgMatches, words: &[OsString]) -> Result<Option<Self>, Failure> {
        let omitted = given.get_many::<String>("no_defaults");
        let omitted: Vec<&String> = omitted.into_iter().flatten().collect();
        if omitted.iter().any(|option| *option == ALL_DEFAULTS) {
            return Ok(None);
        }
        let Some((file, text)) = file(given.get_one("defaults"))? else {
            return Ok(None);
        };
        let mut entries = entries(&file, &text)?;
        for entry in &mut entries {
            if omitted.contains(&&entry.option) {
                entry.unused = Some("--no-defaults ignores it".to_owned());
            }
        }
        let by_person =
            |id: &&Id| given.value_source(id.as_str()) == Some(ValueSource::CommandLine);
        let mut defaults = Self {
            file,
            entries,
            words: words.to_vec(),
            given: given.ids().filter(by_person).cloned().collect(),
        };
        defaults.yield_to_given()?;
        Ok(Some(defaults))
    }

    /// Drops defaults of options that the command line gives or excludes.
    fn yield_to_given(&mut self) -> Result<(), Failure> {
        let program = Cli::command();
        let draw = program
            .find_subcommand("draw")
            .expect("`draw` is a subcommand");
        for entry in self.entries.iter_mut().filter(|entry| entry.is_used()) {
            let excluding = self.given.iter().find(|id| excludes(draw, &entry.id, id));
            if self.given.contains(&entry.id) {
                entry.unused = Some(GIVEN.to_owned());
            } else if let Some(arg) = excluding.and_then(|id| argument(draw, id)) {
                let long = arg.get_long().unwrap_or_default();
                entry.unused = Some(format!("the command line gives --{long}"));
            }
        }
        self.check_exclusive(draw)?;
        self.drop_ineffective();
        Ok(())
    }

    fn check_exclusive(&self, draw: &Command) -> Result<(), Failure> {
        let used: Vec<&Entry> = self.used().collect();
        for (i, one) in used.iter().enumerate() {
            if let Some(other) = used[..i]
                .iter()
                .find(|other| excludes(draw, &other.id, &one.id))
            {
                let (file, line) = (self.file.display(), one.line);
                return Err(anyhow!(
                    "{file}, line {line}: {} and {} exclude each other; use only one",
                    one.option,
                    other.option
                )
                .into());
            }
        }
        Ok(())
    }

    /// Drops defaults that have no effect without an option that is missing.
    fn drop_ineffective(&mut self) {
        loop {
            let there = self.given.iter().chain(self.used().map(|entry| &entry.id));
            let there: Vec<String> = there.map(long).collect();
            let is_ineffective = |entry: &Entry| {
                entry.is_used() && !entry.needs.iter().all(|option| there.contains(option))
            };
            let Some(i) = self.entries.iter().position(is_ineffective) else {
                return;
            };
            let entry = &mut self.entries[i];
            let needs = entry.needs.join(", ");
            entry.unused = Some(format!("it has no effect without {needs}"));
        }
    }

    fn used(&self) -> impl Iterator<Item = &Entry> {
        self.entries.iter().filter(|entry| entry.is_used())
    }

    /// Parses the command line with the defaults that are used. A usage error ends the program, as without defaults.
    fn args(self) -> Result<Args, Failure> {
        let defaults = self.used().flat_map(|entry| entry.words.clone());
        let program = ["dobot", "draw"].map(OsString::from).into_iter();
        let words = program.chain(defaults).chain(self.words.clone());
        let format = ErrorFormat::of(&self.words);
        let verb =
            command_line::parse(words).unwrap_or_else(|error| command_line::exit(&error, format));
        match verb {
            Verb::Draw(mut args) => {
                args.from_file = Some(self);
                Ok(*args)
            }
            _ => Err(anyhow!("expected the command `draw`").into()),
        }
    }

    /// Drops the default that does not fit what is drawn; reports other errors with their line.
    fn without_misfit(mut self, args: &Args, error: OptionsError) -> Result<Args, Failure> {
        let place = |field: &str| {
            let option = option_of(field);
            let has_name = |entry: &Entry| entry.is_used() && entry.option == option;
            self.entries.iter().position(has_name)
        };
        let (entry, why) = match &error {
            OptionsError::Misfit { field, fits, .. } => (place(field), format!("it is for {fits}")),
            OptionsError::Alone { field, needs } => {
                (place(field), format!("it has no effect without {needs}"))
            }
            OptionsError::Both { field, other } => match (place(field), place(other)) {
                (Some(one), None) => (Some(one), format!("the command line gives {other}")),
                (None, Some(one)) => (Some(one), format!("the command line gives {field}")),
                _ => (None, String::new()),
            },
            _ => (None, String::new()),
        };
        let Some(entry) = entry else {
            return Err(self.located(args, error));
        };
        self.entries[entry].unused = Some(with_option_names(&why));
        self.drop_ineffective();
        self.args()
    }

    /// Adds the line of a default to its error.
    fn located(&self, args: &Args, error: OptionsError) -> Failure {
        let tool = &args.options.0.tool;
        let tool_option = |name: &str| {
            if name == tool.pen {
                "tool.pen"
            } else {
                "tool.laser"
            }
        };
        let field = match &error {
            OptionsError::Unknown(unknown) => Some(tool_option(&unknown.name)),
            OptionsError::OtherKind { name, .. } => Some(tool_option(name)),
            other => other.field(),
        };
        let option = field.map(option_of);
        match self
            .used()
            .find(|entry| Some(&entry.option) == option.as_ref())
        {
            Some(entry) => {
                let place = format!("{}, line {}", self.file.display(), entry.line);
                anyhow::Error::from(error).context(place).into()
            }
            None => error.into(),
        }
    }

    /// Returns a hint for a failed drawing: the defaults may be forgotten.
    pub(super) fn hint(&self) -> Option<String> {
        let used: Vec<&str> = self.used().map(|entry| entry.option.as_str()).collect();
        let (used, file) = (used.join(", "), self.file.display());
        let some = format!("{used} set by {file}; `--no-defaults` ignores the file");
        (!used.is_empty()).then_some(some)
    }

    /// Returns the part of a report about them.
    pub(super) fn line(&self) -> DefaultsLine {
        let unused = self.entries.iter().filter_map(|entry| {
            let why = entry.unused.clone().filter(|why| why != GIVEN)?;
            Some(UnusedLine {
                option: entry.option.clone(),
                why,
            })
        });
        DefaultsLine {
            file: self.file.display().to_string(),
            used: self.used().map(|entry| entry.option.clone()).collect(),
            unused: unused.collect(),
        }
    }
}

/// Checks the options, and drops defaults that do not fit what is drawn.
pub(super) fn fitted(mut args: Args, subject: &Subject) -> Result<Args, Failure> {
    while let Err(error) = args.options.0.check(subject) {
        args = match args.from_file.take() {
            Some(defaults) => defaults.without_misfit(&args, error)?,
            None => return Err(error.into()),
        };
    }
    Ok(args)
}

/// Adds the line of the default that causes an error.
pub(super) fn located(args: &Args, error: OptionsError) -> Failure {
    match &args.from_file {
        Some(defaults) => defaults.located(args, error),
        None => error.into(),
    }
}

/// Reads the file that is named, or the user's own one if it exists.
fn file(named: Option<&PathBuf>) -> Result<Option<(PathBuf, String)>, Failure> {
    let read = |file: &Path| bounded::settings(file);
    let unread = |file: &Path| format!("cannot read {}", file.display());
    if let Some(file) = named {
        let text = read(file).with_context(|| unread(file))?;
        return Ok(Some((file.clone(), text)));
    }
    let Ok(folders) = folders(None) else {
        return Ok(None);
    };
    let file = folders.drawing_defaults();
    match read(&file) {
        Ok(text) => Ok(Some((file, text))),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
        Err(error) => Err(anyhow::Error::from(error).context(unread(&file)).into()),
    }
}

fn argument<'a>(draw: &'a Command, id: &Id) -> Option<&'a clap::Arg> {
    draw.get_arguments().find(|arg| arg.get_id() == id)
}

/// Returns the option of a field such as `tool.kerf` or `what.shade tsp`, without dashes.
fn option_of(field: &str) -> String {
    let path = field.split(' ').next().unwrap_or_default();
    option_name(path.rsplit('.').next().unwrap_or_default())
}

fn long(id: &Id) -> String {
    format!("--{}", option_name(id.as_str()))
}

const GIVEN: &str = "the command line gives it";
