//! Defaults for `dobot draw`: a file whose keys are its long options. They are put before what the command line gives,
//! so that one parser reads both.

mod entry;

use std::ffi::OsString;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use anyhow::{Context, anyhow};
use clap::builder::Resettable;
use clap::parser::ValueSource;
use clap::{ArgMatches, Command, CommandFactory, Id, Parser};
use dobot_draw::{OptionsError, Subject};
use serde::Serialize;

pub(super) use self::entry::known;
use self::entry::{Entry, entries};
use super::args::{ALL_DEFAULTS, Args};
use crate::Cli;
use crate::bounded;
use crate::drawing_options::{option_name, with_option_names};
use crate::failure::Failure;
use crate::reach::folders;
use crate::verbs::Verb;

/// A file of defaults, and what the command line gives beside it.
#[derive(Clone, Debug)]
pub(crate) struct Defaults {
    file: PathBuf,
    entries: Vec<Entry>,
    /// What stands behind `draw`.
    words: Vec<OsString>,
    /// The options that it gives.
    given: Vec<Id>,
}

/// The defaults of a drawing, for its report.
#[derive(Debug, Serialize)]
pub(super) struct DefaultsLine {
    pub(super) file: String,
    /// The options that are as the file says.
    pub(super) used: Vec<String>,
    /// Those that the command line does not give either, and are not.
    pub(super) unused: Vec<UnusedLine>,
}

/// A default that this drawing does not use.
#[derive(Debug, Serialize)]
pub(super) struct UnusedLine {
    pub(super) option: String,
    pub(super) why: String,
}

/// What the command line asks of `draw`, with the defaults of its file; none where it asks for something else, where
/// there is no such file, and where it cannot be read: then whoever reads it without them tells what is wrong.
pub(crate) fn read(words: &[OsString]) -> Option<Result<Verb, Failure>> {
    let behind = words.get(2..).filter(|_| words[1] == "draw")?;
    let matches = without_rules().try_get_matches_from(words).ok()?;
    let (_, given) = matches.subcommand()?;
    let defaults = Defaults::of(given, behind).transpose()?;
    Some(defaults.and_then(|it| it.args().map(|args| Verb::Draw(Box::new(args)))))
}

/// The program with options that need and exclude nothing: to see what is given.
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

impl Defaults {
    fn of(given: &ArgMatches, words: &[OsString]) -> Result<Option<Self>, Failure> {
        let left_out = given.get_many::<String>("no_defaults");
        let left_out: Vec<&String> = left_out.into_iter().flatten().collect();
        if left_out.iter().any(|it| *it == ALL_DEFAULTS) {
            return Ok(None);
        }
        let Some((file, text)) = file(given.get_one("defaults"))? else {
            return Ok(None);
        };
        let mut entries = entries(&file, &text)?;
        for entry in &mut entries {
            if left_out.contains(&&entry.option) {
                entry.unused = Some("--no-defaults leaves it out".to_owned());
            }
        }
        let by_person =
            |it: &&Id| given.value_source(it.as_str()) == Some(ValueSource::CommandLine);
        let mut defaults = Self {
            file,
            entries,
            words: words.to_vec(),
            given: given.ids().filter(by_person).cloned().collect(),
        };
        defaults.yield_to_given()?;
        Ok(Some(defaults))
    }

    /// What the command line gives wins over a default of the same option, and over one that it excludes.
    fn yield_to_given(&mut self) -> Result<(), Failure> {
        let program = Cli::command();
        let draw = program.find_subcommand("draw").expect("it is a verb");
        let excludes = |one: &Id, other: &Id| {
            let (one, other) = (argument(draw, one), argument(draw, other));
            let blacklist = |a, b: &clap::Arg| {
                let all = draw.get_arg_conflicts_with(a);
                all.iter().any(|it| it.get_id() == b.get_id())
            };
            one.zip(other)
                .is_some_and(|(a, b)| blacklist(a, b) || blacklist(b, a))
        };
        for entry in self.entries.iter_mut().filter(|it| it.is_used()) {
            let excluding = self.given.iter().find(|it| excludes(&entry.id, it));
            if self.given.contains(&entry.id) {
                entry.unused = Some(GIVEN.to_owned());
            } else if let Some(arg) = excluding.and_then(|it| argument(draw, it)) {
                let long = arg.get_long().unwrap_or_default();
                entry.unused = Some(format!("the command line gives --{long}"));
            }
        }
        let used: Vec<&Entry> = self.used().collect();
        for (i, one) in used.iter().enumerate() {
            if let Some(other) = used[..i].iter().find(|it| excludes(&it.id, &one.id)) {
                let (file, line) = (self.file.display(), one.line);
                return Err(anyhow!(
                    "{file}, line {line}: {} and {} exclude each other; use only one",
                    one.option,
                    other.option
                )
                .into());
            }
        }
        self.leave_out_alone();
        Ok(())
    }

    /// Leaves out what does nothing without an option that is not there.
    fn leave_out_alone(&mut self) {
        loop {
            let there = self.given.iter().chain(self.used().map(|it| &it.id));
            let there: Vec<String> = there.map(long).collect();
            let alone = |it: &Entry| it.is_used() && !it.needs.iter().all(|it| there.contains(it));
            let Some(i) = self.entries.iter().position(alone) else {
                return;
            };
            let entry = &mut self.entries[i];
            let needs = entry.needs.join(", ");
            entry.unused = Some(format!("it does nothing without {needs}"));
        }
    }

    fn used(&self) -> impl Iterator<Item = &Entry> {
        self.entries.iter().filter(|it| it.is_used())
    }

    /// The options of the command line and the defaults that are used. Wrong usage ends the program, as it does
    /// without defaults.
    fn args(self) -> Result<Args, Failure> {
        let defaults = self.used().flat_map(|it| it.words.clone());
        let program = ["dobot", "draw"].map(OsString::from).into_iter();
        let words = program.chain(defaults).chain(self.words.clone());
        let cli = Cli::try_parse_from(words).unwrap_or_else(|error| error.exit());
        match cli.verb {
            Some(Verb::Draw(mut args)) => {
                args.from_file = Some(self);
                Ok(*args)
            }
            _ => Err(anyhow!("`draw` is no verb any more").into()),
        }
    }

    /// Without those that do nothing for what is drawn; what is wrong with others is told with their line.
    fn fitting(mut self, args: &Args, error: OptionsError) -> Result<Args, Failure> {
        let place = |field: &str| {
            let option = option_of(field);
            let is_it = |it: &Entry| it.is_used() && it.option == option;
            self.entries.iter().position(is_it)
        };
        let (entry, why) = match &error {
            OptionsError::Misfit { field, fits, .. } => (place(field), format!("it is for {fits}")),
            OptionsError::Alone { field, needs } => {
                (place(field), format!("it does nothing without {needs}"))
            }
            OptionsError::Both { field, other } => match (place(field), place(other)) {
                (Some(one), None) => (Some(one), format!("the command line gives {other}")),
                (None, Some(one)) => (Some(one), format!("the command line gives {field}")),
                _ => (None, String::new()),
            },
            _ => (None, String::new()),
        };
        let Some(entry) = entry else {
            return Err(self.told(args, error));
        };
        self.entries[entry].unused = Some(with_option_names(&why));
        self.leave_out_alone();
        self.args()
    }

    /// What is wrong with a default, with its place.
    fn told(&self, args: &Args, error: OptionsError) -> Failure {
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
        match self.used().find(|it| Some(&it.option) == option.as_ref()) {
            Some(entry) => {
                let place = format!("{}, line {}", self.file.display(), entry.line);
                anyhow::Error::from(error).context(place).into()
            }
            None => error.into(),
        }
    }

    /// What may help where a drawing fails: a person may have forgotten them.
    pub(super) fn hint(&self) -> Option<String> {
        let used: Vec<&str> = self.used().map(|it| it.option.as_str()).collect();
        let (used, file) = (used.join(", "), self.file.display());
        let some = format!("{used} as {file} says; `--no-defaults` leaves the file out");
        (!used.is_empty()).then_some(some)
    }

    /// What a report tells of them.
    pub(super) fn line(&self) -> DefaultsLine {
        let unused = self.entries.iter().filter_map(|it| {
            let why = it.unused.clone().filter(|it| it != GIVEN)?;
            Some(UnusedLine {
                option: it.option.clone(),
                why,
            })
        });
        DefaultsLine {
            file: self.file.display().to_string(),
            used: self.used().map(|it| it.option.clone()).collect(),
            unused: unused.collect(),
        }
    }
}

/// The options without the defaults that do nothing for what is drawn, checked.
pub(super) fn fitted(mut args: Args, subject: &Subject) -> Result<Args, Failure> {
    while let Err(error) = args.options.0.check(subject) {
        args = match args.from_file.take() {
            Some(defaults) => defaults.fitting(&args, error)?,
            None => return Err(error.into()),
        };
    }
    Ok(args)
}

/// What is wrong with what was asked for, with the place of the default that asks for it.
pub(super) fn told(args: &Args, error: OptionsError) -> Failure {
    match &args.from_file {
        Some(defaults) => defaults.told(args, error),
        None => error.into(),
    }
}

/// The file and its text: that which is named, or else that of this person, if there is one.
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
    draw.get_arguments().find(|it| it.get_id() == id)
}

/// The option of a field such as `tool.kerf`, without its dashes; of `what.shade tsp` that of the field.
fn option_of(field: &str) -> String {
    let path = field.split(' ').next().unwrap_or_default();
    option_name(path.rsplit('.').next().unwrap_or_default())
}

fn long(id: &Id) -> String {
    format!("--{}", option_name(id.as_str()))
}

const GIVEN: &str = "the command line gives it";
