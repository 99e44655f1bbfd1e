//! The `dobot` program: draw, teach, calibrate and drive the original Dobot Arm.

mod bounded;
mod command_line;
mod connect;
mod control;
mod drawing_options;
mod failure;
mod follow;
mod interrupt;
mod logging;
mod open_files;
mod output;
mod pendant;
mod program_file;
mod questions;
mod reach;
mod renamed;
mod stderr;
mod values;
mod verbs;

use std::process::ExitCode;

use clap::Parser;

use crate::failure::ErrorFormat;
use crate::logging::LogFormat;
use crate::verbs::Verb;

/// Control the original Dobot Arm (V1.0, 2016), real or virtual
#[derive(Debug, Parser)]
#[command(name = "dobot", version, max_term_width = 100, after_help = EXAMPLES)]
struct Cli {
    #[command(subcommand)]
    verb: Option<Verb>,
}

/// Runs the program with the arguments of the process and returns its exit code: 0 done, 1 failed,
/// 2 usage, 3 waiting. This is the only place where an outcome becomes an exit code.
#[must_use]
pub fn run() -> ExitCode {
    std::panic::set_hook(Box::new(stderr::report_panic));
    let words = command_line::words();
    let format = ErrorFormat::of(&words);
    let verb = match verbs::with_defaults(&words) {
        Some(Ok(verb)) => verb,
        Some(Err(failure)) => return failure.report(format),
        None => {
            command_line::parse(words).unwrap_or_else(|error| command_line::exit(&error, format))
        }
    };
    let log = verb.log_format();
    log.start();
    let outcome = verb.run();
    stderr::flush();
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) if log == LogFormat::Json => failure.report(ErrorFormat::Log),
        Err(failure) => failure.report(format),
    }
}

/// The verb of `dobot` without arguments: start the station.
fn default_verb() -> Verb {
    let cli = Cli::parse_from(["dobot", "up"]);
    cli.verb.expect("it is given")
}

const EXAMPLES: &str = "\
Examples:
  dobot                                      start the station
  dobot watch                                open its dashboard in another terminal
  dobot draw photo.jpg --picture drawn.png   draw, and save a picture of the result
  dobot arm                                  serve a virtual arm
  dobot status --to serial:/dev/ttyUSB0      show where a real arm is
  dobot move 220 0 30                        move to a point

While a station runs, the commands go through it. `--to` selects an arm:
virtual:, serial:PORT[@BAUD] or tcp:HOST:PORT.

A dialect is the protocol that an arm understands, a personality is the
behaviour of a virtual arm. They have the same names: specification (the
published protocol) and firmware-1.1 (the arms that were sold).

Exit codes: 0 done, 1 failed, 2 invalid command line, 3 a job waits for a
person, as for another pen. With `--json`, the last line on standard error is a
JSON object: error, hint, exit_code; or job, waits_for, hint, exit_code.";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_line_is_well_formed() {
        command_line::command().debug_assert();
    }

    #[test]
    fn without_arguments_the_station_is_started() {
        assert!(Cli::parse_from(["dobot"]).verb.is_none());
        assert!(matches!(default_verb(), Verb::Up(_)));
    }
}
