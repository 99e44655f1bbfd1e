//! The `dobot` program: everything that a person needs to use the original Dobot Arm.

mod arm;
mod completions;
mod conformance;
mod connect;
mod control;
mod decode;
mod draw;
mod failure;
mod follow;
mod interrupt;
mod jobs;
mod jog;
mod lease;
mod man;
mod log;
mod output;
mod policy;
mod ports;
mod reach;
mod replay;
mod set;
mod simulate;
mod status;
mod stop;
mod token;
mod travel;
mod watch;
mod world;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

use crate::failure::Failure;

/// Everything that a person needs to use the original Dobot Arm (V1.0, 2016), with or without it.
#[derive(Debug, Parser)]
#[command(name = "dobot", version, max_term_width = 100, after_help = EXAMPLES)]
struct Cli {
    #[command(subcommand)]
    verb: Verb,
}

#[derive(Debug, Subcommand)]
enum Verb {
    Draw(draw::Args),
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
    Token(token::Args),
    Completions(completions::Args),
    Man(man::Args),
}

/// The one place where an outcome becomes an exit code: 0 done, 1 failed, 2 usage.
fn main() -> ExitCode {
    let cli = Cli::parse();
    match run(cli) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}

fn run(cli: Cli) -> Result<(), Failure> {
    match cli.verb {
        Verb::Draw(args) => wait_for(draw::run(args)),
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
        Verb::Token(args) => token::run(args),
        Verb::Completions(args) => completions::run(&args),
        Verb::Man(args) => man::run(&args),
    }
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
  dobot draw picture.svg --picture drawn.svg   draw with a virtual arm and see what comes out
  dobot arm                                    serve a virtual arm on TCP and a virtual serial port
  dobot status --to serial:/dev/ttyUSB0        watch a real arm
  dobot move 220 0 30                          go to a point

An arm's address (--to) is virtual:, serial:PORT[@BAUD] or tcp:HOST:PORT.";
