//! `dobot fleet`: the stations of a fleet.

#[cfg(feature = "fleet")]
mod set_up;
#[cfg(feature = "fleet")]
mod together;
mod work;

use clap::Subcommand;
use dobot_api::{
    FleetView, LinkPhase, Member, MemberAnswer, Presence, StationAddress, StopView, delete, fetch,
    post,
};
use serde_json::json;

use self::work::WorkArgs;
use crate::failure::Failure;
use crate::output;
use crate::reach::Station;

/// List and stop the stations of a fleet, and set a fleet up
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot fleet                               list the stations and their activity
  dobot fleet stop --reason \"fire drill\"    stop all arms
  dobot fleet stop --group room-2           stop the arms of a group
  dobot fleet stop --reset                  clear the stop after looking at all arms
  dobot fleet stop --reset=desk-1           clear the stop of one station
  dobot fleet certificates keys desk-1 desk-2 router=192.168.7.1
                                            create a certificate for each
  dobot fleet router --listen quic/0.0.0.0:7447 --fleet=keys/router

A station joins a fleet with `dobot up --fleet`. docs/fleet.md describes the
setup for a school. Each station keeps its rules, its tokens and its own page,
which stops its arm even without the network.")]
pub(crate) struct Args {
    #[command(subcommand)]
    action: Option<Action>,
    #[command(flatten)]
    station: Station,
    /// Print JSON (list, stop, work, together)
    #[arg(long, global = true)]
    json: bool,
}

#[derive(Clone, Debug, Subcommand)]
enum Action {
    /// List the stations
    List,
    /// Stop the arms of all stations or of a group, or clear a stop
    Stop {
        /// Group of stations to stop (default: all)
        #[arg(long, value_name = "NAME")]
        group: Option<String>,
        /// Reason, shown to others who find their arm stopped
        #[arg(long, value_name = "TEXT")]
        reason: Option<String>,
        /// Clear the stop of all stations, or of the station NAME; a person must have looked at the arms
        #[arg(long, value_name = "NAME", num_args = 0..=1, require_equals = true, conflicts_with_all = ["group", "reason"])]
        #[expect(
            clippy::option_option,
            reason = "it is given with a name, without one, or not at all"
        )]
        reset: Option<Option<String>>,
    },
    /// Submit drawings and programs to any suitable arm, and track them
    Work(WorkArgs),
    #[cfg(feature = "fleet")]
    /// Run a coordinated program on several arms, with barriers
    Together(together::TogetherArgs),
    #[cfg(feature = "fleet")]
    /// Create a certificate for each station, and an authority if needed
    Certificates(set_up::Certificates),
    #[cfg(feature = "fleet")]
    /// Revoke certificates, for example those on a lost stick
    Revoke(set_up::RevokeArgs),
    #[cfg(feature = "fleet")]
    /// Run a router that connects stations of several networks
    Router(set_up::RouterArgs),
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    match args.action.unwrap_or(Action::List) {
        Action::List => list(&args.station, args.json).await,
        Action::Stop {
            reset: Some(name), ..
        } => reset(&args.station, name, args.json).await,
        Action::Stop { group, reason, .. } => stop(&args.station, group, reason, args.json).await,
        Action::Work(work) => work.run(&args.station, args.json).await,
        #[cfg(feature = "fleet")]
        Action::Together(together) => together.run(&args.station, args.json).await,
        #[cfg(feature = "fleet")]
        Action::Certificates(args) => args.run(),
        #[cfg(feature = "fleet")]
        Action::Revoke(args) => args.run(),
        #[cfg(feature = "fleet")]
        Action::Router(args) => args.run().await,
    }
}

async fn list(station: &Station, as_json: bool) -> Result<(), Failure> {
    let address = station.address_of_running().await?;
    let fleet: FleetView = fetch(&address, "/api/v1/fleet").await?;
    if as_json {
        return Ok(output::json(&fleet)?);
    }
    for member in &fleet.members {
        output::plain_line(&line(member))?;
    }
    Ok(())
}

/// Formats one line about a station.
fn line(member: &Member) -> String {
    let name = &member.name;
    let groups = member.about.as_ref().map(|about| about.groups.join(" "));
    let groups = groups
        .filter(|groups| !groups.is_empty())
        .unwrap_or("-".into());
    format!("{name:20}  {groups:12}  {}", doing(member))
}

/// Describes the activity of a station.
fn doing(member: &Member) -> String {
    match &member.presence {
        Presence::Away => return "away; use its own page to stop its arm".into(),
        Presence::Refused { problem } => return format!("refused: {}", problem.detail),
        Presence::Present => {}
    }
    let Some(state) = &member.state else {
        return "present; no state reported yet".into();
    };
    let stop = state.stop.as_ref().map(StopView::text);
    let link = (state.link.phase != LinkPhase::Up).then(|| "no arm".to_owned());
    let job = state.job.as_ref().map(|job| {
        let done = 100 * job.completed / job.commands.max(1);
        let phase = format!("{:?}", job.phase).to_lowercase();
        format!("{} ({phase}, {done} %)", job.title)
    });
    let lease = state.lease.as_ref();
    let lease = lease.map(|lease| format!("{} has control", lease.name));
    let all: Vec<_> = [stop, link, job, lease].into_iter().flatten().collect();
    if all.is_empty() {
        return "free".into();
    }
    all.join("; ")
}

async fn stop(
    station: &Station,
    group: Option<String>,
    reason: Option<String>,
    as_json: bool,
) -> Result<(), Failure> {
    let address = station.address_of_running().await?;
    let to = group.map_or(json!("all"), |group| json!({ "group": group }));
    let body = json!({ "to": to, "reason": reason });
    let answers: Vec<MemberAnswer> = post(&address, FLEET_STOP, &body).await?;
    let failure = Failure::new(
        anyhow::anyhow!("some arms may not be stopped"),
        "stop the others on their own pages, or with their switches",
    );
    report(&answers, "stopped", as_json, failure)
}

/// Clears the stop of the fleet, or of one station.
async fn reset(station: &Station, name: Option<String>, as_json: bool) -> Result<(), Failure> {
    let address = station.address_of_running().await?;
    let answers = match name {
        Some(name) => reset_one(&address, &name).await?,
        None => delete(&address, FLEET_STOP).await?,
    };
    let failure = Failure::new(
        anyhow::anyhow!("some arms may not move yet"),
        "run `dobot fleet` to see why; a station that is away is reset when it returns",
    );
    report(&answers, "may move again", as_json, failure)
}

async fn reset_one(address: &StationAddress, name: &str) -> Result<Vec<MemberAnswer>, Failure> {
    let body = json!({ "to": { "members": [name] }, "method": "DELETE", "path": "/api/v1/stop" });
    Ok(post(address, "/api/v1/fleet/requests", &body).await?)
}

/// Prints how many stations succeeded and the answers of the others; fails with `failure` if there are others.
fn report(
    answers: &[MemberAnswer],
    done: &str,
    as_json: bool,
    failure: Failure,
) -> Result<(), Failure> {
    if as_json {
        output::json(&answers)?;
    }
    let (stopped, silent): (Vec<_>, Vec<_>) = answers
        .iter()
        .partition(|member| member.answer.is_success());
    if !as_json {
        output::line(&format!("{} of {} {done}", stopped.len(), answers.len()))?;
        for member in &silent {
            let why = member.answer.body["detail"].as_str().unwrap_or("no answer");
            output::plain_line(&format!("{}: {why}", member.member))?;
        }
    }
    if silent.is_empty() {
        return Ok(());
    }
    Err(failure)
}

const FLEET_STOP: &str = "/api/v1/fleet/stop";
