//! The `dobot` program: everything that a person needs to use the original Dobot Arm.

mod arm;
mod completions;
mod confirm;
mod conformance;
mod connect;
mod control;
mod decode;
mod detect;
mod draw;
mod failure;
mod follow;
#[cfg(unix)]
mod guardian;
mod interrupt;
mod jobs;
mod jog;
mod lease;
mod log;
mod logging;
mod man;
mod materials;
mod output;
mod policy;
mod ports;
mod reach;
mod replay;
#[cfg(unix)]
mod service;
mod set;
mod simulate;
mod status;
mod stop;
mod token;
mod travel;
mod up;
mod watch;
mod world;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

use crate::failure::Failure;
use crate::logging::LogFormat;

/// Everything that a person needs to use the original Dobot Arm (V1.0, 2016), with or without it.
#[derive(Debug, Parser)]
#[command(name = "dobot", version, max_term_width = 100, after_help = EXAMPLES)]
struct Cli {
    #[command(subcommand)]
    verb: Option<Verb>,
}

#[derive(Debug, Subcommand)]
enum Verb {
    Up(up::Args),
    Draw(Box<draw::Args>),
    Materials(materials::Args),
    Arm(arm::Args),
    Status(status::Args),
    Move(travel::Args),
    Jog(jog::Args),
    Set(set::Args),
    Simulate(simulate::Args),
    Decode(decode::Args),
    World(world::Args),
    Policy(policy::Args),
    Ports(ports::Args),
    Log(log::Args),
    Replay(replay::Args),
    Conformance(conformance::Args),
    Stop(stop::Args),
    Watch(watch::Args),
    Jobs(jobs::Args),
    Lease(lease::Args),
    Confirm(confirm::Args),
    Detect(detect::Args),
    Token(token::Args),
    #[cfg(unix)]
    Service(service::Args),
    Completions(completions::Args),
    Man(man::Args),
    #[cfg(unix)]
    #[command(hide = true)]
    Guardian(guardian::Args),
}

/// The one place where an outcome becomes an exit code: 0 done, 1 failed, 2 usage.
fn main() -> ExitCode {
    let verb = Cli::parse().verb.unwrap_or_else(default_verb);
    let log = match &verb {
        Verb::Up(args) => args.log_format,
        _ => LogFormat::Text,
    };
    log.start();
    match run(verb) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(log),
    }
}

fn run(verb: Verb) -> Result<(), Failure> {
    match verb {
        Verb::Up(args) => wait_for(up::run(args)),
        Verb::Draw(args) => wait_for(draw::run(*args)),
        Verb::Materials(args) => materials::run(&args),
        Verb::Arm(args) => wait_for(arm::run(args)),
        Verb::Status(args) => wait_for(status::run(args)),
        Verb::Move(args) => wait_for(travel::run(args)),
        Verb::Jog(args) => wait_for(jog::run(args)),
        Verb::Set(args) => wait_for(set::run(args)),
        Verb::Simulate(args) => simulate::run(&args),
        Verb::Decode(args) => decode::run(&args),
        Verb::World(args) => wait_for(world::run(args)),
        Verb::Policy(args) => policy::run(&args),
        Verb::Ports(args) => ports::run(&args),
        Verb::Log(args) => log::run(&args),
        Verb::Replay(args) => wait_for(replay::run(args)),
        Verb::Conformance(args) => wait_for(conformance::run(args)),
        Verb::Stop(args) => wait_for(stop::run(args)),
        Verb::Watch(args) => wait_for(watch::run(args)),
        Verb::Jobs(args) => wait_for(jobs::run(args)),
        Verb::Lease(args) => wait_for(lease::run(args)),
        Verb::Confirm(args) => wait_for(confirm::run(args)),
        Verb::Detect(args) => wait_for(detect::run(args)),
        Verb::Token(args) => token::run(args),
        #[cfg(unix)]
        Verb::Service(args) => service::run(args),
        Verb::Completions(args) => completions::run(&args),
        Verb::Man(args) => man::run(&args),
        #[cfg(unix)]
        Verb::Guardian(args) => guardian::run(&args),
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

/// Runs a verb that waits for ports and for time.
fn wait_for(verb: impl Future<Output = Result<(), Failure>>) -> Result<(), Failure> {
    let runtime = tokio::runtime::Runtime::new()?;
    let result = runtime.block_on(verb);
    // A read of standard input or a port may still hang in a thread of its own.
    runtime.shutdown_background();
    result
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
