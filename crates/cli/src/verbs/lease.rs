//! `dobot lease`: control of the arm.

use std::time::Duration;

use anyhow::anyhow;
use clap::Subcommand;
use dobot_api::{ClientId, LeaseView, News, Notice, Reply, Request, StationEvent};
use dobot_host::StationClient;
use tokio::sync::mpsc;
use tokio::time::sleep;

use crate::control::{arm_laser, first_state, take_control};
use crate::failure::Failure;
use crate::interrupt::interrupt;
use crate::output::{self, clock};
use crate::reach::Station;
use crate::values;

/// Show, take, request and hand over control of the arm
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot lease                    show who has control
  dobot lease take --for 600     keep control for ten minutes, or until Ctrl-C
  dobot lease ask                request control, wait, and keep it until Ctrl-C
  dobot lease laser --for 600    keep control with the laser armed; wear goggles
  dobot lease release            end the control of any client (administrators)

One client at a time has control; all clients may watch and may stop the arm.
Control ends when its client ends. Commands that move the arm take control while
they run.")]
pub(crate) struct Args {
    #[command(subcommand)]
    action: Option<Action>,
    #[command(flatten)]
    station: Station,
    /// Print JSON (show)
    #[arg(long, global = true)]
    json: bool,
}

#[derive(Clone, Debug, Subcommand)]
enum Action {
    /// Show who has control
    Show,
    /// Take control if it is free; Enter hands it to a client that asks
    Take {
        /// Maximum duration, 1 to 86400 seconds (default: until Ctrl-C)
        #[arg(long = "for", value_name = "SECONDS", value_parser = values::seconds(1.0..=86_400.0))]
        time: Option<Duration>,
    },
    /// Request control, wait for it, and keep it until Ctrl-C
    Ask,
    /// Take control from its holder, and keep it until Ctrl-C (administrators)
    Seize,
    /// End the control of any client (administrators)
    Release,
    /// Take control and arm the laser, for a time or until Ctrl-C
    Laser {
        /// Duration, 1 to 3600 seconds
        #[arg(long = "for", value_name = "SECONDS", value_parser = values::laser_seconds)]
        time: Duration,
    },
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let mut station = args.station.client("lease").await?;
    match args.action.unwrap_or(Action::Show) {
        Action::Show => show(&mut station, args.json).await,
        Action::Take { time } => {
            take_control(&mut station).await?;
            keep_control(&mut station, time).await
        }
        Action::Ask => {
            request_control(&mut station).await?;
            keep_control(&mut station, None).await
        }
        Action::Seize => {
            station.request(Request::SeizeLease).await?;
            keep_control(&mut station, None).await
        }
        Action::Release => {
            station.request(Request::SeizeLease).await?;
            station.request(Request::ReleaseLease).await?;
            Ok(output::line("nobody has control")?)
        }
        Action::Laser { time } => keep_laser(&mut station, time).await,
    }
}

async fn keep_laser(station: &mut StationClient, time: Duration) -> Result<(), Failure> {
    take_control(station).await?;
    arm_laser(station, Some(time)).await?;
    output::line("the laser is armed; wear goggles")?;
    keep_control(station, Some(time)).await
}

async fn show(station: &mut StationClient, as_json: bool) -> Result<(), Failure> {
    let state = first_state(station).await?;
    if as_json {
        return Ok(output::json(&state.lease)?);
    }
    for line in lines(state.lease.as_ref(), state.at_s) {
        output::line(&line)?;
    }
    Ok(())
}

fn lines(lease: Option<&LeaseView>, now_s: f64) -> Vec<String> {
    let Some(lease) = lease else {
        return vec!["nobody has control".to_owned()];
    };
    let (name, client, time) = (&lease.name, lease.client.0, clock(now_s - lease.since_s));
    let mut lines = vec![format!("{name} (client {client}) has control, for {time}")];
    let asks = |asking: &dobot_api::ControlRequest| {
        format!("{} (client {}) asks for it", asking.name, asking.client.0)
    };
    lines.extend(lease.asked_by.iter().map(asks));
    lines
}

/// Requests control and waits until it is granted.
async fn request_control(station: &mut StationClient) -> Result<(), Failure> {
    let me = station.id();
    let reply = station.request(Request::AskLease).await?;
    let Reply::Lease { lease } = reply else {
        return Ok(());
    };
    if let Some(lease) = lease.filter(|lease| lease.client != me) {
        output::line(&format!("asked {} (client {})", lease.name, lease.client.0))?;
        wait_for_control(station, me).await?;
    }
    Ok(())
}

/// Waits until control is this client's.
async fn wait_for_control(station: &mut StationClient, me: ClientId) -> Result<(), Failure> {
    loop {
        let event = tokio::select! {
            event = station.next() => event?,
            () = interrupt() => return Err(anyhow!("interrupted").into()),
        };
        let StationEvent::Notice(notice) = event else {
            continue;
        };
        match notice.news {
            News::LeaseTaken { client } if client == me => return Ok(()),
            // The holder has just released it.
            News::LeaseFree if take_control(station).await.is_ok() => return Ok(()),
            _ => {}
        }
    }
}

/// Keeps control until the time is over, Ctrl-C is pressed, or another client gets it.
async fn keep_control(station: &mut StationClient, time: Option<Duration>) -> Result<(), Failure> {
    output::line("you have control; press Ctrl-C to release it")?;
    let mut over = std::pin::pin!(over(time));
    let mut interrupt = std::pin::pin!(interrupt());
    let mut lines = lines_of_person();
    let mut asking = None;
    loop {
        let event = tokio::select! {
            event = station.next() => event?,
            Some(()) = lines.recv() => {
                if let Some(to) = asking.take() {
                    station.request(Request::GrantLease { to }).await?;
                    return Ok(output::line("control was handed over")?);
                }
                continue;
            }
            () = &mut over => break,
            () = &mut interrupt => break,
        };
        if let StationEvent::Notice(notice) = event {
            asking = asking_client(&notice, station.id())?.or(asking);
        }
    }
    station.request(Request::ReleaseLease).await?;
    Ok(output::line("control is released")?)
}

/// Handles a notice while the client keeps control; returns the client that asks for control, if any.
fn asking_client(notice: &Notice, me: ClientId) -> Result<Option<ClientId>, Failure> {
    let asking = match notice.news {
        News::LeaseAsked { client } => Some(client),
        _ => None,
    };
    if asking.is_some() {
        output::line(&format!("{}; press Enter to hand it over", notice.text))?;
    }
    check_kept(notice, me)?;
    Ok(asking)
}

fn check_kept(notice: &Notice, me: ClientId) -> Result<(), Failure> {
    match notice.news {
        News::LeaseFree => Err(anyhow!("control was lost: {}", notice.text).into()),
        News::LeaseTaken { client } if client != me => {
            Err(anyhow!("control was lost: {}", notice.text).into())
        }
        _ => Ok(()),
    }
}

async fn over(time: Option<Duration>) {
    match time {
        Some(time) => sleep(time).await,
        None => std::future::pending().await,
    }
}

/// Receives a message for each line that the person enters.
fn lines_of_person() -> mpsc::Receiver<()> {
    let (sender, lines) = mpsc::channel(1);
    // A read of standard input cannot be cancelled, so that it has its own thread.
    std::thread::spawn(move || {
        for line in std::io::stdin().lines() {
            if line.is_err() || sender.blocking_send(()).is_err() {
                return;
            }
        }
    });
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lease_holder_is_shown_with_the_waiting_requesters() {
        let text = r#"{"client": 5, "name": "the page", "since_s": 10.0,
            "asked_by": [{"client": 9, "name": "dobot jog"}]}"#;
        let lease: LeaseView = serde_json::from_str(text).expect("it is a lease");
        assert_eq!(
            lines(Some(&lease), 22.5),
            [
                "the page (client 5) has control, for 12.5 s",
                "dobot jog (client 9) asks for it"
            ]
        );
        assert_eq!(lines(None, 22.5), ["nobody has control"]);
    }
}
