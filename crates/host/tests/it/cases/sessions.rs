//! Random sessions: several faults, one after another, during any activity of the arm.

use std::fmt;
use std::time::Duration;

use dobot_api::{JobPhase, JobState, NewJob, Reply, Request, Role};
use dobot_controller::Personality;
use dobot_host::VirtualStation;
use dobot_wire::{Command, JointJogAxis, LinearJogAxis, MovingMode};

use super::chance::Chance;
use super::jobs::{DOWN_MM, Sort};
use super::paper::Paper;
use super::scene::{GivenCounts, LASER_OFF, Scene, Wrong, each_seed};
use super::spread::Spread;
use super::stops::{jog, targets, watch, work};
use super::watchdogs::hazards;

/// An incident.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Incident {
    /// A watcher stops the arm: here, or all arms of the fleet.
    Stop,
    /// The station is frozen for a while.
    Freeze,
    /// The station is killed; its watchdog speaks for it, and the station is started again.
    Kill,
    /// The cable is pulled for a while; a client may stop the arm meanwhile.
    Cable,
    /// The token of the person who has control is removed.
    Removal,
}

impl Incident {
    const ALL: [Self; 5] = [
        Self::Stop,
        Self::Freeze,
        Self::Kill,
        Self::Cable,
        Self::Removal,
    ];
}

impl fmt::Display for Incident {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Stop => "stop",
            Self::Freeze => "freeze",
            Self::Kill => "kill",
            Self::Cable => "cable",
            Self::Removal => "removed token",
        })
    }
}

/// The outcome for the arms.
#[derive(Debug, Default)]
pub(crate) struct Sessions {
    /// The number of sessions.
    pub times: usize,
    /// The number of incidents.
    pub incidents: usize,
    /// Jobs that were done in the end, and right.
    pub jobs: usize,
    /// Stops that were asked for while the cable was out.
    pub undelivered: usize,
    /// From the last stop to the arm's rest, in seconds.
    pub rest_s: Spread,
    /// From the last stop to the end of the light, in seconds, where it burnt.
    pub dark_s: Spread,
    /// Violations.
    pub wrong: Vec<String>,
}

/// Runs this many sessions.
pub(crate) fn run(sessions: u64) -> Sessions {
    let mut figures = Sessions::default();
    figures.wrong = each_seed(sessions, "a session", |personality, seed| {
        one(&mut figures, personality, seed)
    });
    figures
}

fn one(figures: &mut Sessions, personality: Personality, seed: u64) -> Result<(), Wrong> {
    let mut chance = Chance::new(seed);
    let mut scene = Scene::new(personality)?;
    for round in 0..=chance.below(4) {
        let incident = chance.one(&Incident::ALL);
        let motion = chance.below(5);
        let at = |Wrong(text)| Wrong(format!("round {round}, {incident} in {motion}: {text}"));
        let begun = begin(&mut scene, motion, &mut chance).map_err(at)?;
        befall(figures, &mut scene, incident, motion, &mut chance).map_err(at)?;
        figures.incidents += 1;
        recover(figures, &mut scene, begun, &mut chance).map_err(at)?;
    }
    let motion = chance.below(5);
    begin(&mut scene, motion, &mut chance)?;
    stop_for_good(figures, &mut scene)?;
    figures.times += 1;
    Ok(())
}

const JOG: u64 = 4;

/// A job that was begun.
struct Begun {
    id: u64,
    wanted: NewJob,
    /// The number of machine samples before it.
    samples: usize,
    /// The pen was on the paper: a line drawn on the way to the start does not belong to the job.
    began_down: bool,
}

/// The arm at work: a job of each sort, targets, a button that is held.
fn begin(scene: &mut Scene, motion: u64, chance: &mut Chance) -> Result<Option<Begun>, Wrong> {
    match motion {
        0..=2 => {
            let sort = Sort::ALL[usize::try_from(motion).unwrap_or_default()];
            let samples = scene.station.arm().samples();
            let last = samples.last().map_or(0.0, |sample| sample.position.z.0);
            let began_down = (last - f64::from(DOWN_MM)).abs() < 0.2;
            let samples = samples.len();
            let mut wanted = sort.job(chance);
            begin_elsewhere(&scene.station, &mut wanted);
            work(scene, &wanted, chance)?;
            let job = scene.station.supervisor().job();
            Ok(job.map(|job| Begun {
                id: job.job,
                wanted,
                samples,
                began_down,
            }))
        }
        JOG => jog(scene, chance).map(|()| None),
        _ => targets(scene, chance).map(|()| None),
    }
}

/// A program may not begin with a straight line to the place of the arm; a person writes another mode then.
fn begin_elsewhere(station: &VirtualStation, wanted: &mut NewJob) {
    let here = station.supervisor().state().arm.map(|arm| arm.status);
    if let (Some(Command::MoveTo(first)), Some(here)) = (wanted.commands.first_mut(), here)
        && [
            first.x_mm - here.x_mm,
            first.y_mm - here.y_mm,
            first.z_mm - here.z_mm,
        ]
        .iter()
        .all(|off| off.abs() < 1.0)
    {
        first.mode = MovingMode::Jump;
    }
}

fn befall(
    figures: &mut Sessions,
    scene: &mut Scene,
    incident: Incident,
    motion: u64,
    chance: &mut Chance,
) -> Result<(), Wrong> {
    match incident {
        Incident::Stop => stop(scene, true),
        // No button is released while its station is frozen for longer: that is the watchdog's task.
        Incident::Freeze if motion == JOG => {
            scene.station.stall(chance.time(Duration::from_millis(250)));
            Ok(())
        }
        Incident::Freeze => {
            scene.station.stall(chance.time(Duration::from_secs(2)));
            Ok(())
        }
        Incident::Kill => {
            let packets = hazards(scene).stop_packets();
            scene.station.guard(&packets);
            scene.station.crash(chance.time(Duration::from_secs(3)))?;
            scene.anna = scene.station.client("Anna");
            Ok(())
        }
        // Without its cable a button is not released: the arm moves to the end of its axis.
        Incident::Cable if motion == JOG => stop(scene, true),
        Incident::Cable => {
            scene.station.unplug();
            scene.station.run_for(chance.time(Duration::from_secs(2)));
            if chance.below(2) == 0 {
                stop(scene, false)?;
                figures.undelivered += 1;
                scene.station.run_for(chance.time(Duration::from_secs(2)));
                let before = scene.station.packets().len();
                scene.station.plug();
                return is_off_first(scene, before);
            }
            scene.station.plug();
            Ok(())
        }
        Incident::Removal => {
            let held = is_held(scene);
            let before = scene.station.packets().len();
            scene.station.leave(scene.anna);
            scene.station.run_for(Duration::from_millis(210));
            if held && !scene.sent(before).iter().any(lets_go) {
                return Err(Wrong("a button is held whose person is gone".into()));
            }
            scene.anna = scene.station.client("Anna");
            Ok(())
        }
    }
}

/// Returns whether the arm jogs, by its packets.
fn is_held(scene: &Scene) -> bool {
    let last = scene
        .sent(0)
        .into_iter()
        .rev()
        .find_map(|command| match command {
            Command::LinearJog(jog) => Some(jog.axis != LinearJogAxis::Released),
            Command::JointJog(jog) if (jog.axis as u8) <= 8 => {
                Some(jog.axis != JointJogAxis::Released)
            }
            _ => None,
        });
    last.unwrap_or_default()
}

/// Returns whether a packet releases a button.
fn lets_go(command: &Command) -> bool {
    match command {
        Command::LinearJog(jog) => jog.axis == LinearJogAxis::Released,
        Command::JointJog(jog) => jog.axis == JointJogAxis::Released,
        _ => false,
    }
}

/// A client that may only watch stops the arm; the answer must be true.
fn stop(scene: &mut Scene, plugged: bool) -> Result<(), Wrong> {
    let before = scene.station.packets().len();
    let watcher = scene.station.client_as("the fleet", Role::Watch);
    let reason = Some("a person shouted".to_owned());
    let reply = scene.station.ask(watcher, Request::Stop { reason })?;
    let Reply::Stopping { delivered, .. } = reply else {
        return Err(Wrong(format!("the stop is answered with {reply:?}")));
    };
    if delivered != plugged {
        return Err(Wrong(format!("delivered: {delivered}, cable: {plugged}")));
    }
    scene.station.run_for(Duration::from_millis(60));
    match (plugged, scene.station.packets().len() > before) {
        (true, _) => is_off_first(scene, before),
        (false, false) => Ok(()),
        (false, true) => Err(Wrong("a packet passed without a cable".into())),
    }
}

fn is_off_first(scene: &mut Scene, before: usize) -> Result<(), Wrong> {
    let latest = scene.station.now() + Duration::from_millis(500);
    scene
        .station
        .run_until(latest, |station| station.packets().len() > before);
    match scene.sent(before).first() {
        Some(first) if *first == LASER_OFF => Ok(()),
        first => Err(Wrong(format!("laser off comes first, not {first:?}"))),
    }
}

/// A person looks, and ends or resumes the job. Afterwards the arm is at rest and its laser off.
fn recover(
    figures: &mut Sessions,
    scene: &mut Scene,
    begun: Option<Begun>,
    chance: &mut Chance,
) -> Result<(), Wrong> {
    scene.station.run_for(chance.time(Duration::from_secs(3)));
    if begun.is_some() && works(&scene.station) {
        let anna = scene.anna;
        scene.station.ask(anna, Request::PauseJob)?;
    }
    let latest = scene.station.now() + Duration::from_secs(60);
    let rests = |station: &VirtualStation| station.supervisor().is_at_rest() && !works(station);
    if !scene.station.run_until(latest, rests) {
        return Err(Wrong("it does not come to rest".into()));
    }
    // What the watchdog or a new station repeats.
    scene.station.run_for(Duration::from_millis(500));
    if scene.burns() {
        return Err(Wrong("the arm rests, and its laser is on".into()));
    }
    let anna = scene.anna;
    if begun.is_none() {
        // Every held button is released.
        scene.station.ask(anna, Request::TakeLease)?;
        scene.station.ask(anna, Request::Release)?;
    }
    if scene.station.supervisor().state().stop.is_some() {
        scene.station.ask(anna, Request::ResetStop)?;
    }
    scene.station.ask(anna, Request::TakeLease)?;
    scene.station.ask(anna, Request::ConfirmPose)?;
    let Some(job) = begun else {
        return Ok(());
    };
    let id = job.id;
    let is_over = matches!(scene.station.job(id)?.state, JobState::Done);
    if !is_over && chance.below(2) == 0 {
        scene.station.ask(anna, Request::CancelJob { job: id })?;
        scene.settle(id)?;
        return Ok(());
    }
    if !is_over {
        scene.finish(id)?;
    }
    figures.jobs += 1;
    let given = scene.given(&job.wanted);
    let samples = &scene.station.arm().samples()[job.samples..];
    let paper = Paper::of(samples, &job.wanted);
    // A laser is dark on its ways between the lines, but no higher.
    let is_pen = job.wanted.lift_mm > 0.0 && !job.began_down;
    if given == GivenCounts::default() && (!is_pen || paper.is_right()) {
        return Ok(());
    }
    Err(Wrong(format!("{given:?}, {paper:?}")))
}

fn works(station: &VirtualStation) -> bool {
    let job = station.supervisor().job();
    job.is_some_and(|job| job.phase == JobPhase::Running)
}

/// Stops the arm for the last time, and watches it.
fn stop_for_good(figures: &mut Sessions, scene: &mut Scene) -> Result<(), Wrong> {
    let (at, burnt) = (scene.station.now(), scene.burns());
    stop(scene, true)?;
    let stopped = watch(scene, at)?;
    figures.rest_s.add(stopped.took_s);
    if burnt {
        figures.dark_s.add_time(at, stopped.lit);
    }
    stopped.check_rest()?;
    if stopped.burns_too_long() {
        return Err(Wrong(format!("the laser was on until {:?}", stopped.lit)));
    }
    if scene.burns() {
        return Err(Wrong("the laser is on in the end".into()));
    }
    Ok(())
}
