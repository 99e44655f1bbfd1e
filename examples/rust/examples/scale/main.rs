//! `cargo run -p dobot-examples --features fleet --example scale`: the cost of a fleet of many
//! stations, and the latency of a stop of all.
//!
//! Many complete stations with virtual arms run in this process (rules, journal, recording, page,
//! their own or a shared Zenoh session), and the router in another one. They are measured one step
//! after another:
//!
//! ```text
//! cargo run --release -p dobot-examples --features fleet --example scale -- --stations 100 --presses 300 --burning 20 --actions 300 --rest 20
//! ```
//!
//! The time of a packet is when the station hands it to the arm's line, on which it then takes
//! 43.68 ms at 9600 baud. Linux only: the cost of a process is read from `/proc`.

mod action;
mod arguments;
mod press;
mod router;
mod stations;
#[path = "../../../../crates/station/benches/station/support/times.rs"]
#[allow(dead_code, reason = "shared with the benchmarks of the station")]
mod times;
mod usage;

use std::error::Error;
use std::time::Instant;

use self::arguments::Arguments;
use self::router::RouterProcess;
use self::stations::Stations;
use self::usage::{Costs, Usage};

#[tokio::main]
async fn main() -> Result<(), Box<dyn Error + Send + Sync>> {
    if let Some(address) = router::wanted() {
        return router::serve(&address).await;
    }
    let arguments = Arguments::read()?;
    println!("{}", times::load());
    let before = Usage::now(std::process::id())?;
    let mut stations = Stations::start(arguments.stations).await?;
    let measured = measure(&mut stations, arguments, &before).await;
    println!("{}", times::load());
    if let Err(error) = &measured {
        eprintln!("error: {error}");
    }
    stations.end().await?;
    measured
}

/// Runs one step after another.
async fn measure(
    stations: &mut Stations,
    arguments: Arguments,
    before: &Usage,
) -> Result<(), Box<dyn Error + Send + Sync>> {
    let Arguments {
        stations: count,
        rest,
        ..
    } = arguments;
    let own = std::process::id();
    let alone = Costs::at_rest(own, rest).await?;
    alone.print_each("a station alone", before, count);

    let router = RouterProcess::start()?;
    let began = Instant::now();
    let by_one_session = arguments.by_one_session.into();
    stations.join(&router.address, by_one_session).await?;
    stations.all_know_all().await;
    let took = began.elapsed();
    println!("all members are known {took:.1?} after the first began to join");
    let joined = Costs::at_rest(own, rest).await?;
    joined.print_each("a station that has joined", before, count);
    joined.print_more("what joining adds", &alone, count);
    Costs::at_rest(router.pid(), rest)
        .await?
        .print("the router");

    let began = Instant::now();
    let board = stations.board().await?;
    let took = began.elapsed();
    println!("a board shows all members {took:.1?} after it was opened");
    let watched = Costs::at_rest(own, rest).await?;
    watched.print_more("what a board adds, for each station", &joined, count);
    let watched = Costs::at_rest(router.pid(), rest).await?;
    watched.print("the router, with a board");

    press::at_rest(stations, arguments.presses).await?;
    press::while_all_burn(stations, arguments.burning).await?;
    action::of_a_board(stations, arguments.actions).await?;
    drop(board);
    Ok(())
}
