//! The verbs of the program: one file for each subcommand of `dobot`.

mod arm;
mod calibrate;
mod check;
mod completions;
mod confirm;
mod conformance;
mod convert;
mod decode;
mod detect;
mod doctor;
mod draw;
mod extras;
mod files;
mod fleet;
mod hand;
mod jobs;
mod jog;
mod lease;
mod log;
mod man;
mod markers;
mod materials;
mod mcp;
mod model;
mod mouse;
mod move_;
mod play;
mod policy;
mod ports;
mod replay;
mod say;
#[cfg(unix)]
mod service;
mod set;
mod simulate;
mod slots;
mod status;
mod stop;
mod teach;
mod token;
mod up;
mod vector;
pub(crate) mod watch;
#[cfg(unix)]
mod watchdog;
mod world;

use clap::Subcommand;

pub(crate) use self::draw::read as with_defaults;
use crate::failure::Failure;
use crate::logging::LogFormat;

/// A subcommand of `dobot`.
#[derive(Debug, Subcommand)]
pub(crate) enum Verb {
    Up(up::Args),
    Draw(Box<draw::Args>),
    Check(check::Args),
    Convert(convert::Args),
    Materials(materials::Args),
    Markers(markers::Args),
    Extras(extras::Args),
    Model(model::Args),
    Arm(arm::Args),
    Status(status::Args),
    Move(move_::Args),
    Jog(jog::Args),
    Mouse(mouse::Args),
    Say(say::Args),
    Hand(hand::Args),
    Vector(vector::Args),
    Teach(teach::Args),
    Calibrate(Box<calibrate::Args>),
    Set(set::Args),
    Simulate(simulate::Args),
    Decode(decode::Args),
    World(world::Args),
    Policy(policy::Args),
    Ports(ports::Args),
    Doctor(doctor::Args),
    Log(log::Args),
    Replay(replay::Args),
    Conformance(conformance::Args),
    Stop(stop::Args),
    Watch(watch::Args),
    Jobs(jobs::Args),
    Files(files::Args),
    Play(Box<play::Args>),
    Fleet(fleet::Args),
    Mcp(mcp::Args),
    Lease(lease::Args),
    Slots(slots::Args),
    Confirm(confirm::Args),
    Detect(detect::Args),
    Token(token::Args),
    #[cfg(unix)]
    Service(service::Args),
    Completions(completions::Args),
    Man(man::Args),
    #[cfg(unix)]
    #[command(hide = true)]
    Watchdog(watchdog::Args),
}

impl Verb {
    /// The format of the verb's log.
    pub(crate) fn log_format(&self) -> LogFormat {
        match self {
            Self::Up(args) => args.log_format,
            _ => LogFormat::Text,
        }
    }

    /// Runs the verb.
    pub(crate) fn run(self) -> Result<(), Failure> {
        match self {
            Self::Up(args) => wait_for(up::run(args)),
            Self::Draw(args) => wait_for(draw::run(*args)),
            Self::Check(args) => wait_for(check::run(args)),
            Self::Convert(args) => convert::run(&args),
            Self::Materials(args) => materials::run(&args),
            Self::Markers(args) => markers::run(&args),
            Self::Extras(args) => extras::run(args),
            Self::Model(args) => model::run(&args),
            Self::Arm(args) => wait_for(arm::run(args)),
            Self::Status(args) => wait_for(status::run(args)),
            Self::Move(args) => wait_for(move_::run(args)),
            Self::Jog(args) => wait_for(jog::run(args)),
            Self::Mouse(args) => wait_for(mouse::run(args)),
            Self::Say(args) => wait_for(say::run(args)),
            Self::Hand(args) => wait_for(hand::run(args)),
            Self::Vector(args) => wait_for(vector::run(args)),
            Self::Teach(args) => wait_for(teach::run(args)),
            Self::Calibrate(args) => wait_for(calibrate::run(*args)),
            Self::Set(args) => wait_for(set::run(args)),
            Self::Simulate(args) => simulate::run(&args),
            Self::Decode(args) => decode::run(&args),
            Self::World(args) => wait_for(world::run(args)),
            Self::Policy(args) => policy::run(&args),
            Self::Ports(args) => ports::run(&args),
            Self::Doctor(args) => wait_for(doctor::run(args)),
            Self::Log(args) => log::run(&args),
            Self::Replay(args) => wait_for(replay::run(args)),
            Self::Conformance(args) => wait_for(conformance::run(args)),
            Self::Stop(args) => wait_for(stop::run(args)),
            Self::Watch(args) => wait_for(watch::run(args)),
            Self::Jobs(args) => wait_for(jobs::run(args)),
            Self::Files(args) => wait_for(files::run(args)),
            Self::Play(args) => wait_for(play::run(*args)),
            Self::Fleet(args) => wait_for(fleet::run(args)),
            Self::Mcp(args) => wait_for(mcp::run(args)),
            Self::Lease(args) => wait_for(lease::run(args)),
            Self::Slots(args) => wait_for(slots::run(args)),
            Self::Confirm(args) => wait_for(confirm::run(args)),
            Self::Detect(args) => wait_for(detect::run(args)),
            Self::Token(args) => token::run(args),
            #[cfg(unix)]
            Self::Service(args) => service::run(args),
            Self::Completions(args) => completions::run(&args),
            Self::Man(args) => man::run(&args),
            #[cfg(unix)]
            Self::Watchdog(args) => watchdog::run(&args),
        }
    }
}

/// Runs an asynchronous verb to its end.
fn wait_for(verb: impl Future<Output = Result<(), Failure>>) -> Result<(), Failure> {
    let runtime = tokio::runtime::Runtime::new()?;
    let result = runtime.block_on(verb);
    // A read of standard input or of a port may still block a thread.
    runtime.shutdown_background();
    result
}
