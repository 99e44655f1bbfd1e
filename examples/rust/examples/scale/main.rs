//! `cargo run -p dobot-examples --features fleet --example scale`: what a fleet of many stations costs, and how soon all of them stop.
//!
//! Many stations with virtual arms run in this process, each whole (rules, journal, recording, page, a session of Zenoh
//! alone or with others), and the router in another one. What they do is measured one step after another:
//!
//! ```text
//! cargo run --release -p dobot-examples --features fleet --example scale -- --stations 100 --presses 300 --burning 20 --actions 300 --rest 20
//! ```
//!
//! The time of a packet is when the station hands it to the arm's line, on which it then takes 43.68 ms at 9600 baud.
//! Linux only: what a process costs is read in `/proc`.

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

/// One step after another.
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
    alone.tell("a station alone", before, count);

    let router = RouterProcess::start()?;
    let began = Instant::now();
    let by_one_session = arguments.by_one_session.into();
    stations.join(&router.address, by_one_session).await?;
    stations.all_know_all().await;
    let took = began.elapsed();
    println!("all know all {took:.1?} after the first began to join");
    let joined = Costs::at_rest(own, rest).await?;
    joined.tell("a station that has joined", before, count);
    joined.tell_more("what joining adds", &alone, count);
    Costs::at_rest(router.pid(), rest)
        .await?
        .tell_all("the router");

    let began = Instant::now();
    let board = stations.board().await?;
    let took = began.elapsed();
    println!("a board shows all of them {took:.1?} after it was opened");
    let watched = Costs::at_rest(own, rest).await?;
    watched.tell_more("what a board adds, for each station", &joined, count);
    let watched = Costs::at_rest(router.pid(), rest).await?;
    watched.tell_all("the router, with a board");

    press::at_rest(stations, arguments.presses).await?;
    press::while_all_burn(stations, arguments.burning).await?;
    action::of_a_board(stations, arguments.actions).await?;
    drop(board);
    Ok(())
}
