//! `cargo run -p dobot-examples --example move_and_jog`
//!
//! Moves to a point, and jogs from there for a second: `move_and_jog [ADDRESS]`, with addresses as
//! in the example `draw`. A real arm moves: the example asks first.

mod support;

use std::error::Error;
use std::time::Duration;

use dobot_api::{Jog, Reply, Request};
use dobot_wire::{Command, LinearJog, LinearJogAxis, MoveTo};

#[tokio::main(flavor = "current_thread")]
async fn main() -> Result<(), Box<dyn Error>> {
    let mut station = support::reach(std::env::args().nth(1)).await?;
    support::ready(&mut station).await?;

    let command = Command::from(MoveTo::to(220.0, 0.0, 30.0));
    let there = station.request(Request::Command { command }).await?;
    if let Reply::Accepted { command, .. } = there {
        station.finished(command).await?;
    }

    let jog = Jog::Linear(LinearJog::new(LinearJogAxis::YPlus, 50.0));
    // Hold to run: a button that is not repeated for 150 ms is released.
    for _ in 0..20 {
        station.request(Request::Jog { jog }).await?;
        station.wait(Duration::from_millis(50)).await;
    }
    station.request(Request::Release).await?;
    station.wait(Duration::from_secs(1)).await;
    let state = station.state().await?;
    println!("{:?}", state.arm);
    station.end().await;
    Ok(())
}
