//! Clients that vanish.

use std::time::Duration;

use dobot_api::{Jog, Request};
use dobot_arm::{Position, Tool, forward};
use dobot_controller::Personality;
use dobot_host::VirtualStation;
use dobot_wire::{Command, JointJog, JointJogAxis, LinearJog, LinearJogAxis};

use super::chance::Chance;
use super::jobs::Sort;
use super::scene::{LASER_OFF, Scene, Wrong, burns, each_seed};
use super::spread::Spread;

/// The outcome for the arm when its client disappeared.
#[derive(Debug, Default)]
pub(crate) struct Clients {
    /// How it disappeared.
    pub how: &'static str,
    /// The number of times.
    pub times: usize,
    /// From there to the first packet that stops the arm, in seconds.
    pub packet_s: Spread,
    /// From there to the rest of the arm, or the end of the light, in seconds.
    pub over_s: Spread,
    /// The distance moved by the tool from there, in millimetres; empty if irrelevant.
    pub went_mm: Spread,
    /// Control was not free afterwards, though the connection was gone.
    pub not_free: usize,
    /// Violations.
    pub wrong: Vec<String>,
}

const SILENT: &str = "silent while it jogs, still connected";
const GONE: &str = "gone while it jogs";
const BURNING: &str = "gone while its job burns";

/// Lets this many clients disappear in each way.
pub(crate) fn run(times: u64) -> Vec<Clients> {
    [SILENT, GONE, BURNING].map(|how| of(how, times)).into()
}

fn of(how: &'static str, times: u64) -> Clients {
    let mut figures = Clients {
        how,
        ..Clients::default()
    };
    figures.wrong = each_seed(times, how, |personality, seed| match how {
        BURNING => burn(&mut figures, personality, seed),
        _ => jog(&mut figures, personality, seed),
    });
    figures
}

fn jog(figures: &mut Clients, personality: Personality, seed: u64) -> Result<(), Wrong> {
    let mut chance = Chance::new(seed);
    let mut scene = Scene::new(personality)?;
    let button = button(&mut chance);
    for _ in 0..2 + chance.below(20) {
        scene
            .station
            .ask(scene.anna, Request::Jog { jog: button })?;
        scene.station.run_for(Duration::from_millis(50));
    }
    scene
        .station
        .ask(scene.anna, Request::Jog { jog: button })?;
    if figures.how == GONE {
        scene
            .station
            .run_for(chance.time(Duration::from_millis(140)));
    }
    let (at, before) = (scene.station.now(), scene.station.packets().len());
    if figures.how == GONE {
        scene.station.leave(scene.anna);
    }
    let there = place(&scene);
    scene.station.run_for(Duration::from_secs(5));
    let first = scene.station.packets().get(before).map(|packet| packet.0);
    let first = first.ok_or_else(|| Wrong("nothing was sent".into()))?;
    figures.packet_s.add_time(at, first);
    figures
        .over_s
        .add((scene.rested_s() - at.as_secs_f64()).max(0.0));
    let rest = place(&scene);
    figures.went_mm.add(there.distance(rest).0);
    note_lease(figures, &scene);
    figures.times += 1;
    Ok(())
}

fn burn(figures: &mut Clients, personality: Personality, seed: u64) -> Result<(), Wrong> {
    let mut chance = Chance::new(seed);
    let mut scene = Scene::new(personality)?;
    scene.begin(&Sort::Burn.job(&mut chance))?;
    let latest = scene.station.now() + Duration::from_secs(30);
    if !scene.station.run_until(latest, burns) {
        return Err(Wrong("it does not begin to burn".into()));
    }
    scene.station.run_for(chance.time(Duration::from_secs(2)));
    let (at, packets) = (scene.station.now(), scene.station.packets().len());
    scene.station.leave(scene.anna);
    // The packet before may still be on the line.
    scene.station.run_for(Duration::from_millis(60));
    let sent: Vec<Command> = scene.sent(packets);
    if sent.first() != Some(&LASER_OFF) {
        return Err(Wrong(format!("the first packet is {:?}", sent.first())));
    }
    figures.packet_s.add(
        scene.station.packets()[packets]
            .0
            .saturating_sub(at)
            .as_secs_f64(),
    );
    let mut lit = if scene.burns() {
        scene.station.now()
    } else {
        at
    };
    let note = |station: &VirtualStation| {
        if burns(station) {
            lit = station.now();
        }
        false
    };
    scene.station.run_until(at + Duration::from_secs(20), note);
    figures.over_s.add_time(at, lit);
    note_lease(figures, &scene);
    figures.times += 1;
    Ok(())
}

/// Returns the true position of the tool.
fn place(scene: &Scene) -> Position {
    let joints = scene
        .station
        .arm()
        .mechanics()
        .joints_at(scene.station.now());
    forward(&joints, Tool::SuctionCup).position
}

fn note_lease(figures: &mut Clients, scene: &Scene) {
    let held = scene.station.supervisor().state().lease.is_some();
    figures.not_free += usize::from(held && figures.how != SILENT);
}

fn button(chance: &mut Chance) -> Jog {
    let speed_percent = chance.between(10.0, 100.0);
    if chance.below(2) == 0 {
        let axis = chance.one(&[
            LinearJogAxis::YPlus,
            LinearJogAxis::YMinus,
            LinearJogAxis::ZPlus,
        ]);
        Jog::Linear(LinearJog::new(axis, speed_percent))
    } else {
        let axis = chance.one(&[JointJogAxis::BasePlus, JointJogAxis::BaseMinus]);
        Jog::Joint(JointJog::new(axis, speed_percent))
    }
}
