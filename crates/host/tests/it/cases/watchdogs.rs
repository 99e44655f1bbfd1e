//! The station is killed or frozen, and its watchdog acts for it.

use std::fmt;
use std::time::Duration;

use dobot_api::{Jog, Request};
use dobot_arm::{Joints, Position, Tool, forward};
use dobot_controller::Personality;
use dobot_host::{Hazards, Heartbeat, Watchdog};
use dobot_sim::VirtualArm;
use dobot_wire::{JointJog, JointJogAxis, LinearJog, LinearJogAxis, Packet};

use super::chance::Chance;
use super::commands::target;
use super::jobs::Sort;
use super::scene::{Scene, Wrong, burns, each_seed};
use super::spread::Spread;

/// The fate of the station.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fate {
    /// Killed.
    Killed,
    /// It is frozen.
    Frozen,
    /// The thread that has the arm panicked.
    Panicked,
}

/// The motion of the arm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum GuardedMotion {
    Joint(JointJogAxis),
    Linear(LinearJogAxis),
    Burning,
    Moving,
}

/// The outcome for arm and laser.
#[derive(Debug)]
pub(crate) struct Guarded {
    pub fate: Fate,
    pub doing: GuardedMotion,
    pub times: usize,
    /// From the last sign of life to the watchdog's first packet, in seconds.
    pub packet_s: Spread,
    /// From the station's end to the arm's rest, in seconds.
    pub rest_s: Spread,
    /// The distance moved by the tool from there, in millimetres.
    pub went_mm: Spread,
    /// The distance moved by the joint of a joint jog from there, in degrees.
    pub went_deg: Spread,
    /// From the station's end to the end of the light, in seconds.
    pub lit_s: Spread,
    /// How long the laser was on while the arm was at rest, in seconds.
    pub stood_s: Spread,
    /// Motion that no button asked for.
    pub unasked: usize,
    /// The laser was on in the end.
    pub burnt: usize,
    /// Violations.
    pub wrong: Vec<String>,
}

impl Fate {
    pub(crate) const ALL: [Self; 3] = [Self::Killed, Self::Frozen, Self::Panicked];
}

impl GuardedMotion {
    /// Each button of both kinds that moves the arm, a burn, and a move.
    pub(crate) fn all() -> Vec<Self> {
        let joints = JointJogAxis::ALL[1..=8]
            .iter()
            .map(|axis| Self::Joint(*axis));
        let lines = LinearJogAxis::ALL[1..=8]
            .iter()
            .map(|axis| Self::Linear(*axis));
        joints
            .chain(lines)
            .chain([Self::Burning, Self::Moving])
            .collect()
    }
}

impl fmt::Display for Fate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Killed => "killed",
            Self::Frozen => "frozen",
            Self::Panicked => "panics",
        })
    }
}

impl fmt::Display for GuardedMotion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Joint(axis) => write!(f, "joint jog {}", name(axis)),
            Self::Linear(axis) => write!(f, "linear jog {}", name(axis)),
            Self::Burning => f.write_str("a burning job"),
            Self::Moving => f.write_str("a motion to a point"),
        }
    }
}

/// Each fate in each motion, this often.
pub(crate) fn run(times: u64) -> Vec<Guarded> {
    let of_fate = |fate| {
        GuardedMotion::all()
            .into_iter()
            .map(move |doing| (fate, doing))
    };
    Fate::ALL
        .into_iter()
        .flat_map(of_fate)
        .map(|(fate, doing)| of(fate, doing, times))
        .collect()
}

fn of(fate: Fate, doing: GuardedMotion, times: u64) -> Guarded {
    let mut figures = Guarded {
        fate,
        doing,
        times: 0,
        packet_s: Spread::default(),
        rest_s: Spread::default(),
        went_mm: Spread::default(),
        went_deg: Spread::default(),
        lit_s: Spread::default(),
        stood_s: Spread::default(),
        unasked: 0,
        burnt: 0,
        wrong: Vec::new(),
    };
    figures.wrong = each_seed(
        times,
        format_args!("{fate}, {doing}"),
        |personality, seed| one(&mut figures, personality, seed),
    );
    figures
}

fn one(figures: &mut Guarded, personality: Personality, seed: u64) -> Result<(), Wrong> {
    let mut chance = Chance::new(seed);
    let mut scene = Scene::new(personality)?;
    begin(&mut scene, figures.doing, &mut chance)?;
    let at = scene.station.now();
    let burnt = scene.burns();
    let (after, life, from) = left_alone(scene, figures.fate, &mut chance);
    let to = after.arm.mechanics().joints_at(after.now);
    let first = after
        .first
        .ok_or_else(|| Wrong("nothing was said".into()))?;
    figures.packet_s.add_time(life, first);
    figures.rest_s.add_time(at, after.rests);
    figures.went_mm.add(place(&from).distance(place(&to)).0);
    figures
        .went_deg
        .add(turned(figures.doing, &from, &to).abs());
    if burnt {
        figures.lit_s.add_time(at, after.lit);
    }
    figures.stood_s.add(after.stood.as_secs_f64());
    figures.burnt += usize::from(after.arm.controller().outputs().laser);
    figures.times += 1;
    if let Some(text) = unasked(figures.doing, &from, &to) {
        figures.unasked += 1;
        return Err(Wrong(text));
    }
    Ok(())
}

/// The arm with its watchdog for fifteen seconds after the end of the station; the time of the last
/// heartbeat, and the joints at the station's end.
pub(super) fn left_alone(
    scene: Scene,
    fate: Fate,
    chance: &mut Chance,
) -> (After, Duration, Joints) {
    let at = scene.station.now();
    let hazards = hazards(&scene);
    let life = at.saturating_sub(chance.time(HEARTBEAT));
    let arm = scene.station.into_arm();
    let from = arm.mechanics().joints_at(at);
    let mut after = After {
        arm,
        now: at,
        watchdog: Watchdog::new(life),
        first: None,
        lit: at,
        stood: Duration::ZERO,
        rests: at,
        joints: from,
    };
    after
        .watchdog
        .handle_heartbeat(life, Heartbeat::Alive(hazards));
    let mut own = own_packets(fate, at, hazards);
    if fate != Fate::Frozen {
        after.watchdog.handle_end(at);
    }
    after.run_until(at + Duration::from_secs(15), &mut own);
    (after, life, from)
}

/// The arm at work, at a moment that chance chooses.
fn begin(scene: &mut Scene, doing: GuardedMotion, chance: &mut Chance) -> Result<(), Wrong> {
    match doing {
        GuardedMotion::Burning => {
            scene.begin(&Sort::Burn.job(chance))?;
            let latest = scene.station.now() + Duration::from_secs(30);
            if !scene.station.run_until(latest, burns) {
                return Err(Wrong("it does not begin to burn".into()));
            }
            scene.station.run_for(chance.time(Duration::from_secs(2)));
        }
        GuardedMotion::Moving => {
            let y_mm = chance.between(40.0, 90.0);
            let command = target([215.0, y_mm, 20.0]).into();
            scene
                .station
                .ask(scene.anna, Request::Command { command })?;
            scene.station.run_for(chance.time(Duration::from_secs(2)));
        }
        GuardedMotion::Joint(axis) => {
            let speed_percent = chance.between(20.0, 100.0);
            let jog = Jog::Joint(JointJog::new(axis, speed_percent));
            hold(scene, jog, chance)?;
        }
        GuardedMotion::Linear(axis) => {
            let speed_percent = chance.between(20.0, 100.0);
            let jog = Jog::Linear(LinearJog::new(axis, speed_percent));
            hold(scene, jog, chance)?;
        }
    }
    Ok(())
}

/// Holds a button where there is room for that.
fn hold(scene: &mut Scene, jog: Jog, chance: &mut Chance) -> Result<(), Wrong> {
    let command = target([225.0, 0.0, 30.0]).into();
    scene
        .station
        .ask(scene.anna, Request::Command { command })?;
    let latest = scene.station.now() + Duration::from_secs(20);
    scene.station.run_for(Duration::from_millis(500));
    if !scene
        .station
        .run_until(latest, |station| station.supervisor().is_at_rest())
    {
        return Err(Wrong("it does not come to rest".into()));
    }
    for _ in 0..6 + chance.below(8) {
        scene.station.ask(scene.anna, Request::Jog { jog })?;
        scene.station.run_for(Duration::from_millis(50));
    }
    scene
        .station
        .run_for(chance.time(Duration::from_millis(90)));
    Ok(())
}

/// The watchdog's knowledge: every packet before it is sent.
pub(super) fn hazards(scene: &Scene) -> Hazards {
    let dialect = scene.personality().dialect();
    let packets = scene.station.packets().iter();
    packets
        .filter_map(|(_, bytes)| Packet::from_bytes(bytes))
        .fold(Hazards::default(), |hazards, packet| {
            hazards.after(&packet, &dialect)
        })
}

/// The packets of the station in its last moment, with their times.
fn own_packets(fate: Fate, at: Duration, hazards: Hazards) -> Vec<(Duration, Packet)> {
    if fate != Fate::Panicked {
        return Vec::new();
    }
    let gaps = (0..).map(|n| at + Duration::from_millis(60) * n);
    gaps.zip(hazards.stop_packets()).collect()
}

/// The arm and its watchdog, after the station.
pub(super) struct After {
    arm: VirtualArm,
    now: Duration,
    watchdog: Watchdog,
    /// When the first packet was sent.
    first: Option<Duration>,
    /// When the laser was last seen on.
    pub lit: Duration,
    /// How long it was on while the arm was at rest.
    stood: Duration,
    /// When the arm was last seen moving.
    pub rests: Duration,
    joints: Joints,
}

impl After {
    fn run_until(&mut self, latest: Duration, own: &mut Vec<(Duration, Packet)>) {
        while self.now < latest {
            self.carry(own);
            let next = own.first().map_or(Duration::MAX, |own| own.0);
            let next = next.min(self.watchdog.poll_wakeup());
            let soon = self.now + Duration::from_millis(1);
            let before = self.now;
            self.now = next
                .min(self.arm.poll_wakeup())
                .clamp(soon, soon.max(latest).min(before + LOOK));
            self.arm.handle_time(self.now);
            self.look(before);
        }
    }

    fn carry(&mut self, own: &mut Vec<(Duration, Packet)>) {
        let mut bytes = Vec::new();
        self.arm.poll_bytes(&mut bytes);
        if !bytes.is_empty() {
            self.watchdog.handle_reply(self.now);
        }
        self.watchdog.handle_time(self.now);
        while own.first().is_some_and(|own| own.0 <= self.now) {
            let (_, packet) = own.remove(0);
            self.send(&packet);
        }
        while let Some(packet) = self.watchdog.poll_bytes() {
            self.send(&packet);
        }
    }

    fn send(&mut self, packet: &Packet) {
        self.first.get_or_insert(self.now);
        self.arm.handle_bytes(self.now, &packet.to_bytes());
    }

    fn look(&mut self, before: Duration) {
        let joints = self.arm.mechanics().joints_at(self.now);
        let moved = joints != self.joints;
        self.joints = joints;
        if moved {
            self.rests = self.now;
        }
        if self.arm.controller().outputs().laser {
            self.lit = self.now;
            if !moved {
                self.stood += self.now.saturating_sub(before);
            }
        }
    }
}

/// How far each part went.
fn parts<const N: usize>(from: [f64; N], to: [f64; N]) -> Vec<f64> {
    from.iter().zip(to).map(|(a, b)| b - a).collect()
}

/// Motion that no button asked for, in words.
fn unasked(doing: GuardedMotion, from: &Joints, to: &Joints) -> Option<String> {
    let point = |joints: &Joints| {
        let place = place(joints);
        [place.x.0, place.y.0, place.z.0]
    };
    let turned = || parts(from.angles_deg(), to.angles_deg());
    let (number, parts, most): (usize, Vec<f64>, f64) = match doing {
        GuardedMotion::Joint(axis) => (axis as usize - 1, turned(), 0.05),
        // The servo turns as in a joint jog.
        GuardedMotion::Linear(axis @ (LinearJogAxis::ServoPlus | LinearJogAxis::ServoMinus)) => {
            (axis as usize - 1, turned(), 0.05)
        }
        GuardedMotion::Linear(axis) => (axis as usize - 1, parts(point(from), point(to)), 0.3),
        GuardedMotion::Burning | GuardedMotion::Moving => return None,
    };
    let (asked, sign) = (number / 2, sign(number));
    let wrong = parts.iter().enumerate().any(|(at, part)| {
        let back = at == asked && part * sign < -most;
        back || (at != asked && part.abs() > most)
    });
    wrong.then(|| format!("the arm moved by {parts:.2?}"))
}

const fn sign(number: usize) -> f64 {
    if number.is_multiple_of(2) { 1.0 } else { -1.0 }
}

fn turned(doing: GuardedMotion, from: &Joints, to: &Joints) -> f64 {
    match doing {
        GuardedMotion::Joint(JointJogAxis::BasePlus | JointJogAxis::BaseMinus) => {
            to.base.0 - from.base.0
        }
        GuardedMotion::Joint(JointJogAxis::RearPlus | JointJogAxis::RearMinus) => {
            to.rear.0 - from.rear.0
        }
        GuardedMotion::Joint(JointJogAxis::ForePlus | JointJogAxis::ForeMinus) => {
            to.fore.0 - from.fore.0
        }
        GuardedMotion::Joint(_)
        | GuardedMotion::Linear(LinearJogAxis::ServoPlus | LinearJogAxis::ServoMinus) => {
            to.servo.0 - from.servo.0
        }
        _ => 0.0,
    }
}

/// Returns the true position of the tool.
fn place(joints: &Joints) -> Position {
    forward(joints, Tool::SuctionCup).position
}

fn name(axis: &impl serde::Serialize) -> String {
    let name = serde_json::to_value(axis).unwrap_or_default();
    name.as_str().unwrap_or_default().to_owned()
}

/// From one beat to the next.
const HEARTBEAT: Duration = Duration::from_millis(80);
/// The interval of observations.
const LOOK: Duration = Duration::from_millis(5);
