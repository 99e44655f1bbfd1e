//! How long the laser burns in one place, for each sender.

use std::fmt;
use std::time::Duration;

use dobot_api::JobState;
use dobot_api::{ClientId, JobPhase, News, Request};
use dobot_controller::{Personality, Refused};
use dobot_host::VirtualStation;
use dobot_wire::Command;

use super::chance::Chance;
use super::commands::vector;
use super::jobs::Sort;
use super::light::longest_stand_s;
use super::scene::{Scene, Wrong, burns, each_seed};
use super::spread::Spread;

/// The sender of the burning commands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sender {
    /// A client, command by command.
    Requests,
    /// A raw program, packet by packet.
    Packets,
    /// A job, which is paused now and then.
    Job,
}

impl fmt::Display for Sender {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Requests => "requests",
            Self::Packets => "raw packets",
            Self::Job => "jobs",
        })
    }
}

/// The figures of the standing laser.
#[derive(Debug)]
pub(crate) struct StandingLaser {
    /// The sender of the burning commands.
    pub sender: Sender,
    /// The fault of the link.
    pub link: &'static str,
    /// The number of programs, each with up to 25 commands.
    pub programs: usize,
    /// The longest time that it burned in one place in each of them, in seconds.
    pub stood_s: Spread,
    /// For longer than [`MAX_S`].
    pub late: usize,
    /// How often the station switched it off for that.
    pub switched_off: usize,
    /// Jobs that failed because the arm lost a packet of a batch, and reported it.
    pub displaced: usize,
    /// Violations.
    pub wrong: Vec<String>,
}

/// Lets this many programs burn, for each sender on each link.
pub(crate) fn run(programs: u64) -> Vec<StandingLaser> {
    let senders = [Sender::Requests, Sender::Packets, Sender::Job];
    let on_links = |sender| LINKS.map(|link| of(sender, link, programs));
    senders.into_iter().flat_map(on_links).collect()
}

fn of(sender: Sender, link: &'static str, programs: u64) -> StandingLaser {
    let mut figures = StandingLaser {
        sender,
        link,
        programs: 0,
        stood_s: Spread::default(),
        late: 0,
        switched_off: 0,
        displaced: 0,
        wrong: Vec::new(),
    };
    figures.wrong = each_seed(
        programs,
        format_args!("{sender}, {link}"),
        |personality, seed| one(&mut figures, personality, seed),
    );
    figures
}

fn one(figures: &mut StandingLaser, personality: Personality, seed: u64) -> Result<(), Wrong> {
    let mut chance = Chance::new(seed);
    let faults: Vec<&str> = figures.link.split_whitespace().collect();
    let mut scene = Scene::faulty(personality, &faults, seed)?;
    match figures.sender {
        Sender::Job => figures.displaced += usize::from(!job(&mut scene, &mut chance)?),
        sender => program(&mut scene, &mut chance, sender)?,
    }
    scene.station.run_for(Duration::from_secs(20));
    if burns(&scene.station) {
        return Err(Wrong("the laser is still on".into()));
    }
    // A stand is recorded by the motion after it.
    scene.station.ask(scene.anna, Request::SeizeLease)?;
    scene.station.ask(scene.anna, Request::ConfirmPose)?;
    let command = vector([0.0, 0.0, 2.0], false);
    scene
        .station
        .ask(scene.anna, Request::Command { command })?;
    scene.station.run_for(Duration::from_secs(3));
    let off = |notice: &&dobot_api::Notice| notice.news == News::LaserOff;
    figures.switched_off += scene.station.notices().iter().filter(off).count();
    figures.programs += 1;
    let stood_s = longest_stand_s(scene.station.arm().samples(), STILL_MM);
    figures.stood_s.add(stood_s);
    if stood_s > MAX_S {
        figures.late += 1;
        return Err(Wrong(format!("it stood for {stood_s} s")));
    }
    Ok(())
}

/// Vectors that burn and others, with or without time between them; refusals are ignored.
fn program(scene: &mut Scene, chance: &mut Chance, sender: Sender) -> Result<(), Wrong> {
    let program = scene.station.client("an old program");
    if sender == Sender::Packets {
        scene.station.ask(scene.anna, Request::ReleaseLease)?;
        send(scene, program, sender, vector([0.0, 1.0, 0.0], false));
    }
    for step in 0_u8..25 {
        // A link that was lost has disarmed it.
        scene
            .station
            .ask(scene.anna, Request::ArmLaser { for_s: 600.0 })?;
        let side = if step % 2 == 0 { 1.0 } else { -1.0 };
        let y_mm = side * chance.between(1.0, 12.0);
        let command = match chance.below(5) {
            0 => vector([0.0, 0.0, y_mm / 4.0], false),
            1 => vector([0.0, y_mm, 0.0], false),
            _ => vector([0.0, y_mm, 0.0], true),
        };
        send(scene, program, sender, command);
        if chance.below(3) == 0 {
            scene
                .station
                .run_for(chance.time(Duration::from_millis(900)));
        }
    }
    Ok(())
}

fn send(scene: &mut Scene, program: ClientId, sender: Sender, command: Command) {
    // Some of it is refused: the arm is somewhere else than the program believes.
    if sender == Sender::Packets {
        let packet = command.emit(&scene.personality().dialect());
        let _ = scene.station.send_raw(program, &packet);
    } else {
        let _ = scene.station.ask(scene.anna, Request::Command { command });
    }
}

/// Returns whether the job is done; it may fail only if a late line made the arm lose a packet.
fn job(scene: &mut Scene, chance: &mut Chance) -> Result<bool, Wrong> {
    let job = scene.begin(&Sort::Burn.job(chance))?;
    for _ in 0..chance.below(3) {
        scene.station.run_for(chance.time(Duration::from_secs(8)));
        let runs = |station: &VirtualStation| {
            let phase = station.supervisor().job().map(|job| job.phase);
            phase == Some(JobPhase::Running)
        };
        if runs(&scene.station) {
            scene.station.ask(scene.anna, Request::PauseJob)?;
        }
    }
    let finished = scene.finish(job);
    let arm = scene.station.arm_mut();
    let lost = std::iter::from_fn(|| arm.poll_refused()).any(|refused| refused == Refused::TooLong);
    match finished {
        Err(_) if lost && failed(&scene.station, job) => Ok(false),
        finished => finished.map(|()| true),
    }
}

fn failed(station: &VirtualStation, job: u64) -> bool {
    station
        .job(job)
        .is_ok_and(|job| matches!(job.state, JobState::Failed { .. }))
}

/// A laser at rest is off within that, in seconds.
pub(crate) const MAX_S: f64 = 0.3;
/// In the 20 ms from one sample to the next.
const STILL_MM: f64 = 0.001;
/// The second one lets packets heap up, of which a stock arm may lose one; the others lose no command.
const LINKS: [&str; 4] = [
    "",
    "delay=80ms",
    "delay=40ms drop=1%:from",
    "withhold@5s..5.8s withhold@8s..8.9s",
];
