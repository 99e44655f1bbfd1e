//! The `dobot` program: everything that a person needs to use the original Dobot Arm.

mod bounded;
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
mod reach;
mod stderr;
mod verbs;

use std::ffi::OsString;
use std::process::ExitCode;

use clap::Parser;

use crate::logging::LogFormat;
use crate::verbs::Verb;

/// Everything that a person needs to use the original Dobot Arm (V1.0, 2016), with or without it.
#[derive(Debug, Parser)]
#[command(name = "dobot", version, max_term_width = 100, after_help = EXAMPLES)]
struct Cli {
    #[command(subcommand)]
    verb: Option<Verb>,
}

/// The one place where an outcome becomes an exit code: 0 done, 1 failed, 2 usage.
fn main() -> ExitCode {
    std::panic::set_hook(Box::new(stderr::report_panic));
    let words: Vec<OsString> = std::env::args_os().collect();
    let verb = match verbs::with_defaults(&words) {
        Some(Ok(verb)) => verb,
        Some(Err(failure)) => return failure.report(LogFormat::Text),
        None => Cli::parse_from(words).verb.unwrap_or_else(default_verb),
    };
    let log = verb.log_format();
    log.start();
    let outcome = verb.run();
    stderr::flush();
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(log),
    }
}

/// What `dobot` alone does.
fn default_verb() -> Verb {
    let cli = Cli::parse_from(["dobot", "up"]);
    cli.verb.expect("it is given")
}

/// Whether a command line would be understood.
#[cfg(unix)]
fn check(words: impl IntoIterator<Item = String>) -> Result<(), clap::Error> {
    Cli::try_parse_from(words).map(drop)
}

const EXAMPLES: &str = "\
Examples:
  dobot                                        start the station, with the arm that is found or a virtual one
  dobot watch                                  its dashboard, in another terminal
  dobot draw photo.jpg --picture drawn.png     draw, and see what comes out
  dobot arm                                    serve a virtual arm on TCP and a virtual serial port
  dobot status --to serial:/dev/ttyUSB0        see where a real arm is
  dobot move 220 0 30                          go to a point

As long as a station runs, the verbs go through it. An arm's address (--to) is virtual:, serial:PORT[@BAUD] or
tcp:HOST:PORT.";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_line_is_well_formed() {
        use clap::CommandFactory;
        Cli::command().debug_assert();
    }

    #[test]
    fn without_arguments_the_station_is_started() {
        assert!(Cli::parse_from(["dobot"]).verb.is_none());
        assert!(matches!(default_verb(), Verb::Up(_)));
    }
}
