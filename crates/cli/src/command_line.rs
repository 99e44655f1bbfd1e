//! From the words of a command line to a verb, and the form of usage errors.

use std::ffi::OsString;

use clap::error::{ContextKind, ContextValue};
use clap::{Command, CommandFactory, FromArgMatches};

use crate::Cli;
use crate::failure::{ErrorFormat, print_error};
use crate::renamed;
use crate::verbs::Verb;

/// The words of this command line, with the current names of renamed options.
pub(crate) fn words() -> Vec<OsString> {
    let mut words: Vec<OsString> = std::env::args_os().collect();
    for hint in renamed::replace(&mut words) {
        eprintln!("hint: {hint}");
    }
    words
}

/// The program with its subcommands.
pub(crate) fn command() -> Command {
    with_short_help(Cli::command())
}

/// Shows the examples in the short help, and all that follows them in the long help.
fn with_short_help(command: Command) -> Command {
    let command = command
        .allow_negative_numbers(true)
        .mut_subcommands(with_short_help);
    let Some(long) = command.get_after_help().map(ToString::to_string) else {
        return command;
    };
    match long.split_once("\n\n") {
        Some((examples, _)) => command
            .after_help(examples.to_owned())
            .after_long_help(long),
        None => command,
    }
}

/// Parses a command line.
pub(crate) fn parse(
    words: impl IntoIterator<Item = impl Into<OsString> + Clone>,
) -> Result<Verb, clap::Error> {
    let matches = command().try_get_matches_from(words);
    let cli = matches.and_then(|matches| Cli::from_arg_matches(&matches));
    let cli = cli.map_err(without_far_suggestions)?;
    Ok(cli.verb.unwrap_or_else(crate::default_verb))
}

/// Prints a usage error, or the help that was asked for, and ends the program.
pub(crate) fn exit(error: &clap::Error, format: ErrorFormat) -> ! {
    let code = error.exit_code();
    if format == ErrorFormat::Json && error.use_stderr() {
        let (text, hint) = text_and_hint(error);
        print_error(format, &text, Some(&hint), u8::try_from(code).unwrap_or(2));
    } else {
        // A closed standard output is no failure.
        let _ = error.print();
    }
    std::process::exit(code)
}

/// Splits a usage error into its message and a hint.
fn text_and_hint(error: &clap::Error) -> (String, String) {
    let text = error.to_string();
    let (message, rest) = text.split_once("\n\n").unwrap_or((&text, ""));
    let message: Vec<&str> = message.lines().map(str::trim).collect();
    let message = message.join(" ");
    let message = message.trim_start_matches("error: ").to_owned();
    let tip = rest
        .lines()
        .find_map(|line| line.trim().strip_prefix("tip: "));
    let hint = tip.unwrap_or("`--help` lists what is allowed").to_owned();
    (message, hint)
}

/// Drops suggestions that are not near misses.
fn without_far_suggestions(mut error: clap::Error) -> clap::Error {
    for (kind, given) in [
        (ContextKind::SuggestedArg, ContextKind::InvalidArg),
        (ContextKind::SuggestedValue, ContextKind::InvalidValue),
        (
            ContextKind::SuggestedSubcommand,
            ContextKind::InvalidSubcommand,
        ),
    ] {
        let (Some(ContextValue::String(given)), Some(suggested)) =
            (error.get(given), error.get(kind))
        else {
            continue;
        };
        match near_misses(suggested, given) {
            None => drop(error.remove(kind)),
            Some(near) => drop(error.insert(kind, near)),
        }
    }
    error
}

/// Returns those of the suggestions that are near misses; `None` if there are none.
fn near_misses(suggested: &ContextValue, given: &str) -> Option<ContextValue> {
    match suggested {
        ContextValue::String(one) => is_near(given, one).then(|| suggested.clone()),
        ContextValue::Strings(all) => {
            let near = all.iter().filter(|meant| is_near(given, meant));
            let near: Vec<String> = near.cloned().collect();
            (!near.is_empty()).then_some(ContextValue::Strings(near))
        }
        _ => Some(suggested.clone()),
    }
}

/// Reports whether a word is probably a misspelling of another one, or its beginning.
pub(crate) fn is_near(given: &str, meant: &str) -> bool {
    let plain = |word: &str| word.trim_start_matches('-').to_lowercase();
    let (given, meant) = (plain(given), plain(meant));
    let [given_len, meant_len] = [&given, &meant].map(|word| word.chars().count());
    let is_beginning = given_len >= 3 && meant.starts_with(&given);
    is_beginning || strsim::osa_distance(&given, &meant) <= (given_len.max(meant_len) / 3).min(2)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error(line: &str) -> clap::Error {
        parse(line.split(' ')).expect_err(line)
    }

    #[test]
    fn near_misses_are_suggested_and_nothing_else() {
        for (line, meant) in [
            ("dobot drwa a.svg", "'draw'"),
            ("dobot draw a.svg --sped 5", "'--speed'"),
            ("dobot set tool lasre", "'laser'"),
            ("dobot move --joint 1 2 3", "'--joints'"),
        ] {
            let text = error(line).to_string();
            assert!(text.contains("similar") && text.contains(meant), "{text}");
        }
        for line in [
            "dobot set tool hammer",
            "dobot dance",
            "dobot jog x+ --hammer",
        ] {
            let text = error(line).to_string();
            assert!(!text.contains("similar"), "{text}");
        }
    }

    #[test]
    fn every_invalid_option_value_is_a_usage_error_in_plain_words() {
        for (line, allowed) in [
            ("dobot jog x+ --for -1", "expected 0.02 to 60 seconds"),
            ("dobot jog x+ --percent 150", "expected 1 to 100 percent"),
            (
                "dobot move 1 2 3 --gripper 120",
                "expected -90 to 90 degrees",
            ),
            ("dobot move 1 2 x", "expected a finite number"),
            ("dobot move 1 2 3 --pause 700", "expected 0 to 655 seconds"),
            ("dobot vector 1 2 3 --speed 0", "expected a number above 0"),
            (
                "dobot set writing --acceleration 0",
                "expected a number above 0",
            ),
            ("dobot set percent --speed-percent 101", "up to 100 percent"),
            (
                "dobot play a.toml --times 0",
                "expected a whole number, 1 or more",
            ),
            (
                "dobot status --count x",
                "expected a whole number, 1 or more",
            ),
            ("dobot jobs show first", "expected a whole number"),
            ("dobot up --http here", "expected HOST:PORT"),
            ("dobot calibrate a.toml --bar 200", "print a new sheet"),
            ("dobot calibrate a.toml --bar 417:x", "as in 417:173.5"),
        ] {
            let error = error(line);
            let text = error.to_string();
            assert_eq!(error.exit_code(), 2, "{text}");
            assert!(text.contains(allowed), "{line}: {text}");
            for jargon in ["literal", "digit", "struct", "syntax", "..1"] {
                assert!(!text.contains(jargon), "{line}: {text}");
            }
        }
    }

    #[test]
    fn a_usage_error_has_a_message_and_a_hint() {
        let (message, hint) = text_and_hint(&error("dobot set tool lasre"));
        assert!(
            message.starts_with("invalid value 'lasre' for '<TOOL>'"),
            "{message}"
        );
        assert!(hint.contains("'laser'"), "{hint}");
        let (message, hint) = text_and_hint(&error("dobot move 1 2"));
        assert!(
            !message.contains('\n') && hint.contains("--help"),
            "{message} {hint}"
        );
    }

    /// Calls a function with each command and its name.
    fn each_command(command: &Command, name: &str, check: &mut impl FnMut(&str, &Command)) {
        check(name, command);
        for sub in command.get_subcommands() {
            each_command(sub, &format!("{name} {}", sub.get_name()), check);
        }
    }

    #[test]
    fn each_command_is_described_in_one_short_line() {
        each_command(&command(), "dobot", &mut |name, command| {
            let about = command.get_about().map(ToString::to_string);
            let about = about.unwrap_or_else(|| panic!("{name} has no description"));
            assert!(about.chars().count() <= 72, "{name}: {about}");
            assert!(
                !about.contains('\n') && !about.ends_with('.'),
                "{name}: {about}"
            );
        });
    }

    #[test]
    fn examples_fit_on_a_terminal() {
        each_command(&command(), "dobot", &mut |name, command| {
            let long = command.get_after_long_help().or(command.get_after_help());
            let text = long.map(ToString::to_string).unwrap_or_default();
            for line in text.lines() {
                assert!(line.chars().count() <= 96, "{name}: {line}");
            }
        });
    }

    #[test]
    fn options_mean_the_same_everywhere() {
        let mut values = std::collections::BTreeMap::<String, Vec<String>>::new();
        each_command(&command(), "dobot", &mut |name, command| {
            for arg in command.get_arguments() {
                let Some(long) = arg.get_long().filter(|long| SHARED.contains(long)) else {
                    continue;
                };
                let value = arg.get_value_names().unwrap_or_default();
                let value: Vec<&str> = value.iter().map(|name| &**name).collect();
                let all = values.entry(long.to_owned()).or_default();
                let value = value.join(" ");
                assert!(
                    all.is_empty() || all.contains(&value),
                    "{name} --{long}: {value} and {all:?}"
                );
                all.push(value);
            }
        });
    }

    /// Options that had several meanings.
    const SHARED: [&str; 8] = [
        "speed", "to", "frame", "paper", "laser", "data", "height", "percent",
    ];
}
