//! Actions on one station's board for an arm of another station.

use std::error::Error;
use std::time::{Duration, Instant};

use dobot_api::{MemberAnswer, StationAddress, post};
use dobot_wire::{Command, Dialect, MoveTo, MovingMode};
use serde_json::{Value, json};

use super::stations::{Desk, Stations};
use super::times::Times;

/// Moves arms of other stations from the first one's board this many times, one after another.
pub(crate) async fn of_a_board(
    stations: &Stations,
    actions: usize,
) -> Result<(), Box<dyn Error + Send + Sync>> {
    let mut board = stations.first();
    board.token = Some(stations.token.secret().into());
    let others: Vec<_> = stations.all.iter().skip(1).take(MOVED).collect();
    let mut leases = Vec::new();
    for desk in &others {
        let taken = ask(
            &board,
            desk,
            &json!({"method": "POST", "path": "/api/v1/lease"}),
        )
        .await?;
        leases.push(taken["token"].clone());
    }
    let mut times = Vec::new();
    for number in 0..actions {
        let Some(desk) = others.get(number % others.len().max(1)) else {
            break;
        };
        let lease = &leases[number % others.len()];
        times.push(move_it(&board, desk, lease, number / others.len()).await?);
    }
    if !times.is_empty() {
        Times::new(times).print("an action of a board: the packet");
    }
    Ok(())
}

/// The number of arms that take turns: a moved arm rests before it is moved again.
const MOVED: usize = 10;

/// Moves an arm by a few millimetres; returns the time until its line was given the packet.
async fn move_it(
    board: &StationAddress,
    desk: &Desk,
    lease: &Value,
    turn: usize,
) -> Result<Duration, Box<dyn Error + Send + Sync>> {
    let mut states = desk.station.handle().states();
    let rests = |state: &dobot_api::State| state.queue.waiting == 0 && state.queue.under_way == 0;
    states.wait_for(|snapshot| rests(snapshot.state())).await?;
    let x_mm = if turn.is_multiple_of(2) { 205.0 } else { 200.0 };
    let there = MoveTo::to(x_mm, 0.0, 50.0).with_mode(MovingMode::MovJ);
    let command = Command::from(there);
    let wanted = command.emit(&Dialect::SPECIFICATION).to_bytes();
    let mut packets = desk.station.handle().passed();
    let listening = tokio::spawn(async move {
        while let Ok(packet) = packets.recv().await {
            if packet.to_arm && packet.bytes == wanted {
                return Some(Instant::now());
            }
        }
        None
    });
    let body = json!({"command": command});
    let request = json!({
        "method": "POST", "path": "/api/v1/commands", "lease": lease, "body": body,
    });
    let began = Instant::now();
    ask(board, desk, &request).await?;
    let arrived = listening.await?.ok_or("no packet was sent to the arm")?;
    Ok(arrived - began)
}

/// Sends a request to one station through the board of another.
async fn ask(
    board: &StationAddress,
    desk: &Desk,
    request: &Value,
) -> Result<Value, Box<dyn Error + Send + Sync>> {
    let mut request = request.clone();
    request["to"] = json!({"members": [desk.name]});
    let mut answers: Vec<MemberAnswer> = post(board, "/api/v1/fleet/requests", &request).await?;
    let answer = answers.pop().ok_or("expected a response")?.answer;
    if !answer.is_success() {
        return Err(format!("{} refused: {}", desk.name, answer.body).into());
    }
    Ok(answer.body)
}
