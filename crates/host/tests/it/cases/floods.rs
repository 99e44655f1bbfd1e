//! Peers that send more than anyone can use.

use std::time::Duration;

use dobot_api::{ClientId, Request, Role};
use dobot_controller::{Personality, Refused};
use dobot_host::VirtualStation;
use dobot_wire::{Command, LinearJog, LinearJogAxis, MoveTo, MovingMode, Packet};

use super::chance::Chance;
use super::jobs::Sort;
use super::scene::{Scene, Wrong, each_seed};

/// The outcome for the arm and other clients when one client sent too much.
#[derive(Debug, Default)]
pub(crate) struct Floods {
    /// The sender and its packets.
    pub who: &'static str,
    /// The number of times.
    pub times: usize,
    /// Requests or packets in all.
    pub sent: usize,
    /// The number of packets passed on to the arm meanwhile.
    pub passed_on: usize,
    /// Packets that the arm lost or refused for want of room.
    pub overrun: usize,
    /// Commands that waited in the station at the most.
    pub most_waiting: usize,
    /// A job of another client did not come to its end, or a stop did not hold.
    pub not_served: usize,
    /// Violations.
    pub wrong: Vec<String>,
}

const HOLDER: &str = "commands of the client in control";
const NONSENSE: &str = "forbidden commands of the client in control";
const RAW: &str = "raw packets of a program in control";
const STRANGER: &str = "requests of another client, while a job runs";
const STRANGER_RAW: &str = "raw packets of another client, while a job runs";
const STOPS: &str = "consecutive stops";

/// Floods this often in each way, with this many requests per moment.
pub(crate) fn run(floods: u64) -> Vec<Floods> {
    [HOLDER, NONSENSE, RAW, STRANGER, STRANGER_RAW, STOPS]
        .map(|who| of(who, floods))
        .into()
}

fn of(who: &'static str, floods: u64) -> Floods {
    let mut figures = Floods {
        who,
        ..Floods::default()
    };
    let wrong = each_seed(floods, who, |personality, seed| {
        one(&mut figures, personality, seed)
    });
    figures.wrong.extend(wrong);
    figures
}

fn one(figures: &mut Floods, personality: Personality, seed: u64) -> Result<(), Wrong> {
    let mut chance = Chance::new(seed);
    let mut scene = Scene::new(personality)?;
    let stranger = scene.station.client("Ben");
    let job = match figures.who {
        STRANGER | STRANGER_RAW => Some(scene.begin(&Sort::Pen.job(&mut chance))?),
        RAW => {
            scene.station.ask(scene.anna, Request::ReleaseLease)?;
            None
        }
        _ => {
            let command = target([200.0, -90.0, 20.0], MovingMode::MovJ);
            scene
                .station
                .ask(scene.anna, Request::Command { command })?;
            None
        }
    };
    let before = scene.station.packets().len();
    for _ in 0..ROUNDS {
        for _ in 0..chance.below(40) {
            flood(figures, &mut scene, stranger, &mut chance);
        }
        scene
            .station
            .run_for(chance.time(Duration::from_millis(100)));
        let stops = figures.who == STOPS;
        overruns(figures, &mut scene.station, stops);
        figures.most_waiting = figures
            .most_waiting
            .max(scene.station.supervisor().session().waiting());
    }
    figures.passed_on += scene.station.packets().len() - before;
    if let Some(job) = job {
        scene.finish(job)?;
    }
    overruns(figures, &mut scene.station, false);
    let watcher = scene.station.client_as("the class", Role::Watch);
    scene.station.ask(watcher, Request::Stop { reason: None })?;
    scene.station.run_for(Duration::from_secs(20));
    overruns(figures, &mut scene.station, true);
    let holds = scene
        .station
        .supervisor()
        .state()
        .stop
        .is_some_and(|stop| stop.at_rest);
    figures.not_served += usize::from(!holds);
    figures.times += 1;
    Ok(())
}

fn flood(figures: &mut Floods, scene: &mut Scene, stranger: ClientId, chance: &mut Chance) {
    figures.sent += 1;
    let (x_mm, y_mm) = (chance.between(200.0, 235.0), chance.between(-90.0, 90.0));
    let z_mm = if figures.who == NONSENSE {
        -500.0
    } else {
        20.0
    };
    let command = target([x_mm, y_mm, z_mm], MovingMode::MovJ);
    let who = match figures.who {
        HOLDER | NONSENSE | STOPS => scene.anna,
        _ => stranger,
    };
    // The individual answers do not matter here: most are refusals.
    match figures.who {
        RAW | STRANGER_RAW => drop(scene.station.send_raw(who, &raw(scene, command, chance))),
        STOPS => drop(scene.station.ask(who, Request::Stop { reason: None })),
        _ => drop(scene.station.ask(who, Request::Command { command })),
    }
}

fn target([x_mm, y_mm, z_mm]: [f32; 3], mode: MovingMode) -> Command {
    MoveTo::to(x_mm, y_mm, z_mm).with_mode(mode).into()
}

/// A target, or a button pressed and released as fast as it can be sent.
fn raw(scene: &Scene, command: Command, chance: &mut Chance) -> Packet {
    let axis = chance.one(&[
        LinearJogAxis::YPlus,
        LinearJogAxis::YMinus,
        LinearJogAxis::Released,
    ]);
    let jog = LinearJog::new(axis, 50.0);
    let command = if chance.below(2) == 0 {
        command
    } else {
        jog.into()
    };
    command.emit(&scene.personality().dialect())
}

fn overruns(figures: &mut Floods, station: &mut VirtualStation, was_stopped: bool) {
    while let Some(refused) = station.arm_mut().poll_refused() {
        let lost = match refused {
            // The first packet of a stop does not wait for the line; it is repeated.
            Refused::TooLong => !was_stopped,
            _ => matches!(refused, Refused::QueueFull | Refused::BadTail),
        };
        figures.overrun += usize::from(lost);
        if lost {
            figures.wrong.push(format!("{refused}"));
        }
    }
    figures.overrun += usize::from(station.arm().lost_bytes() > 0);
}

const ROUNDS: usize = 60;
