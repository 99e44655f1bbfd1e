//! `dobot fleet`: several stations at once.

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

/// See the stations of a fleet, stop them all, and set a fleet up
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot fleet                                    who is there, and what each does
  dobot fleet stop --reason \"fire drill\"         all arms; `dobot fleet stop --group room-2` those of one group
  dobot fleet stop --reset                       a person has looked: all may move again; --reset=desk-1 one of them
  dobot fleet certificates keys desk-1 desk-2 router=192.168.7.1    a folder with a certificate for each
  dobot fleet router --listen quic/0.0.0.0:7447 --fleet=keys/router

A station joins with `dobot up --fleet`; docs/fleet.md tells how a school sets one up. Each station keeps its rules,
its tokens and its own page, where its arm is stopped even when the network is gone.")]
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
    /// Stop the arms of all stations, or of those of a group
    Stop {
        /// Only those of this group
        #[arg(long, value_name = "NAME")]
        group: Option<String>,
        /// Why, for those who find their arm stopped
        #[arg(long, value_name = "TEXT")]
        reason: Option<String>,
        /// Let the whole fleet move again after a stop of all, or only the arm of the station NAME; a person has looked
        #[arg(long, value_name = "NAME", num_args = 0..=1, require_equals = true, conflicts_with_all = ["group", "reason"])]
        #[expect(
            clippy::option_option,
            reason = "it is given with a name, without one, or not at all"
        )]
        reset: Option<Option<String>>,
    },
    /// Submit drawings and programs to any arm that has what they need, and see what has become of them
    Work(WorkArgs),
    #[cfg(feature = "fleet")]
    /// Do one program with several arms, which wait for each other at barriers
    Together(together::TogetherArgs),
    #[cfg(feature = "fleet")]
    /// Make a certificate for each station, and the authority where there is none yet
    Certificates(set_up::Certificates),
    #[cfg(feature = "fleet")]
    /// Revoke the certificates of stations, as of one on a stick that was lost
    Revoke(set_up::RevokeArgs),
    #[cfg(feature = "fleet")]
    /// Run a router, by which stations of several networks find each other
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

/// What a person reads of a station.
fn line(member: &Member) -> String {
    let name = &member.name;
    let groups = member.about.as_ref().map(|it| it.groups.join(" "));
    let groups = groups.filter(|it| !it.is_empty()).unwrap_or("-".into());
    format!("{name:20}  {groups:12}  {}", doing(member))
}

/// What a station does.
fn doing(member: &Member) -> String {
    match &member.presence {
        Presence::Away => return "away; its own page stops its arm".into(),
        Presence::Refused { problem } => return format!("refused: {}", problem.detail),
        Presence::Present => {}
    }
    let Some(state) = &member.state else {
        return "there, and has not told what it does".into();
    };
    let stop = state.stop.as_ref().map(StopView::text);
    let link = (state.link.phase != LinkPhase::Up).then(|| "no arm".to_owned());
    let job = state.job.as_ref().map(|job| {
        let done = 100 * job.completed / job.commands.max(1);
        let phase = format!("{:?}", job.phase).to_lowercase();
        format!("{} ({phase}, {done} %)", job.title)
    });
    let lease = state.lease.as_ref();
    let lease = lease.map(|it| format!("{} has control", it.name));
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
    let to = group.map_or(json!("all"), |it| json!({ "group": it }));
    let body = json!({ "to": to, "reason": reason });
    let answers: Vec<MemberAnswer> = post(&address, FLEET_STOP, &body).await?;
    let failure = Failure::new(
        anyhow::anyhow!("not every arm is known to be stopped"),
        "stop those on their own pages, or with their switches",
    );
    report(&answers, "stopped", as_json, failure)
}

/// Lets the fleet move again, or one of its arms.
async fn reset(station: &Station, name: Option<String>, as_json: bool) -> Result<(), Failure> {
    let address = station.address_of_running().await?;
    let answers = match name {
        Some(name) => reset_one(&address, &name).await?,
        None => delete(&address, FLEET_STOP).await?,
    };
    let failure = Failure::new(
        anyhow::anyhow!("not every arm may move again"),
        "a station that is away learns of a reset of the fleet when it comes back; `dobot fleet` shows what holds the others",
    );
    report(&answers, "may move again", as_json, failure)
}

async fn reset_one(address: &StationAddress, name: &str) -> Result<Vec<MemberAnswer>, Failure> {
    let body = json!({ "to": { "members": [name] }, "method": "DELETE", "path": "/api/v1/stop" });
    Ok(post(address, "/api/v1/fleet/requests", &body).await?)
}

/// Prints how many stations succeeded and what the others answered; fails with `failure` if there are others.
fn report(
    answers: &[MemberAnswer],
    done: &str,
    as_json: bool,
    failure: Failure,
) -> Result<(), Failure> {
    if as_json {
        output::json(&answers)?;
    }
    let (stopped, silent): (Vec<_>, Vec<_>) = answers.iter().partition(|it| it.answer.is_success());
    if !as_json {
        output::line(&format!("{} of {} {done}", stopped.len(), answers.len()))?;
        for it in &silent {
            let why = it.answer.body["detail"].as_str().unwrap_or("no answer");
            output::plain_line(&format!("{}: {why}", it.member))?;
        }
    }
    if silent.is_empty() {
        return Ok(());
    }
    Err(failure)
}

const FLEET_STOP: &str = "/api/v1/fleet/stop";
