//! Random requests and packets at random times and with random faults, from client to twin.

mod asking;
mod judge;

use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Duration;

use dobot_api::{ClientId, Request, Role};
use dobot_controller::{Controller, Personality, PowerUp};
use dobot_host::VirtualStation;
use dobot_safety::Policy;
use dobot_sim::{Fault, SerialLine, VirtualArm};
use dobot_supervisor::Refusal;
use dobot_wire::{Command, Packet};

use self::asking::{Asking, FuzzStep};
use self::judge::Judge;
use super::chance::Chance;

/// The outcome for an arm that got random requests.
#[derive(Debug, Default)]
pub(crate) struct Fuzz {
    /// The cases: an arm that was just switched on, and this many requests.
    pub cases: u64,
    /// Requests and packets in all.
    pub requests: u64,
    /// The number of accepted ones.
    pub taken: u64,
    /// Packets that reached the line.
    pub packets: usize,
    /// Control ticks that were judged.
    pub ticks: u64,
    /// The virtual time that passed, in seconds.
    pub virtual_s: f64,
    /// Cases in which the arm was lost, by what went wrong.
    pub lost: BTreeMap<&'static str, u64>,
    /// Violations.
    pub wrong: Vec<String>,
}

/// The kinds of violations, in the order of the report.
pub(crate) const LOSSES: [&str; 5] = [
    judge::HANGS,
    judge::NAN,
    judge::OUTSIDE,
    judge::LASER,
    PANIC,
];

impl Fuzz {
    /// The figures as a table.
    pub(crate) fn page(&self) -> String {
        let mut page = format!(
            "| | |\n|---|---|\n| arms, each asked {REQUESTS} times | {} |\n| requests and packets | {} |\n| taken | {} |\n| packets on the line | {} |\n| control ticks judged | {} |\n| virtual time | {:.0} h |\n",
            self.cases,
            self.requests,
            self.taken,
            self.packets,
            self.ticks,
            self.virtual_s / 3600.0
        );
        let lost = LOSSES.map(|loss| {
            let times = self.lost.get(loss).copied().unwrap_or_default();
            format!("| **{loss}** | {times} |\n")
        });
        page += &lost.concat();
        page
    }
}

/// Runs this many cases, starting with a seed.
pub(crate) fn run(first: u64, cases: u64) -> Fuzz {
    let mut figures = Fuzz::default();
    for seed in first..first + cases {
        one(&mut figures, seed);
    }
    figures
}

/// A case; a panic is one of the things that should not be.
fn one(figures: &mut Fuzz, seed: u64) {
    let mut case = Case::new(seed);
    figures.cases += 1;
    let ended = catch_unwind(AssertUnwindSafe(|| case.run(figures)));
    figures.packets += case.station.packets().len();
    figures.ticks += case.judge.ticks;
    figures.virtual_s += case.station.now().as_secs_f64();
    let (what, why) = match (ended, &case.judge.lost) {
        (Err(_), _) => (PANIC, "the station panicked".to_owned()),
        (Ok(()), Some((what, why))) => (*what, why.clone()),
        (Ok(()), None) => return,
    };
    *figures.lost.entry(what).or_default() += 1;
    figures.wrong.push(format!(
        "seed {seed} ({}, {:?}), {:.3} s: {what}: {why}\n{}",
        case.personality,
        case.faults,
        case.station.now().as_secs_f64(),
        case.lately(),
    ));
}

struct Case {
    station: VirtualStation,
    judge: Judge,
    chance: Chance,
    asking: Asking,
    personality: Personality,
    faults: Vec<&'static str>,
    log: Vec<(Duration, String)>,
    requests: u64,
    taken: u64,
}

impl Case {
    fn new(seed: u64) -> Self {
        // Seeds that follow one another would give the same numbers, one later.
        let mut chance = Chance::new(Chance::new(seed).number());
        let personality = Personality::ALL[usize::from(!seed.is_multiple_of(4))];
        let power_up = PowerUp::new(personality);
        let faults = match chance.below(3) {
            0 => vec![chance.one(&FAULTS)],
            _ => Vec::new(),
        };
        let arm = VirtualArm::new(Controller::power_up(power_up), SerialLine::STOCK);
        let parsed: Vec<Fault> = faults
            .iter()
            .filter_map(|fault| fault.parse().ok())
            .collect();
        let arm = if parsed.is_empty() {
            arm
        } else {
            arm.with_faults(power_up, &parsed, seed)
        };
        let policy = Policy::from_toml(chance.one(&POLICIES)).unwrap_or_default();
        let mut station = VirtualStation::with_arm(arm, power_up, policy.clone());
        station.run_for(Duration::from_millis(700));
        let burns = chance.below(4) == 0;
        let resets = faults
            .iter()
            .any(|fault| fault.contains("reset") || fault.contains("power"));
        let jogs = !faults.iter().any(|fault| fault.contains("close"));
        let people = ["Anna", "Ben", "a raw program"].map(|name| station.client(name));
        let watcher = station.client_as("the class", Role::Watch);
        Self {
            judge: Judge::new(policy, burns, resets),
            asking: Asking {
                people,
                watcher,
                burns,
                jogs,
                dialect: personality.dialect(),
                jobs: Vec::new(),
                before: None,
                row: None,
            },
            station,
            chance,
            personality,
            faults,
            log: Vec::new(),
            requests: 0,
            taken: 0,
        }
    }

    fn run(&mut self, figures: &mut Fuzz) {
        let anna = self.asking.people[0];
        for request in [Request::TakeLease, Request::ConfirmPose] {
            let _ = self.ask(anna, request);
        }
        while self.requests < REQUESTS && self.judge.lost.is_none() {
            self.step();
        }
        figures.requests += self.requests;
        figures.taken += self.taken;
        self.part();
    }

    /// Something is asked or sent, and a while passes.
    fn step(&mut self) {
        match self.asking.next(&mut self.chance, &self.station) {
            FuzzStep::Again(asked, times, gap) => {
                for _ in 0..times {
                    self.perform((*asked).clone());
                    self.pass(gap);
                    if self.judge.lost.is_some() {
                        return;
                    }
                }
            }
            asked => self.perform(asked),
        }
        let pass = match self.chance.below(20) {
            0..8 => Duration::ZERO,
            8..17 => self.chance.time(Duration::from_millis(300)),
            17 | 18 => self.chance.time(Duration::from_secs(2)),
            _ => self.chance.time(Duration::from_secs(8)),
        };
        self.pass(pass);
    }

    fn perform(&mut self, asked: FuzzStep) {
        let before = self.station.now();
        let text = format!("{asked:?}");
        let taken = match asked {
            FuzzStep::Request(who, request) => self.ask(who, request),
            FuzzStep::Packet(who, packet) => self.station.send_raw(who, &packet),
            FuzzStep::Submit(job) => {
                let submitted = self.station.submit(&job);
                submitted.map(|id| self.asking.jobs.push(id))
            }
            FuzzStep::Start(who, id) => self.station.start(who, id).map(drop),
            FuzzStep::Again(..) => Ok(()),
            FuzzStep::Unplug(time) => {
                self.station.unplug();
                self.pass(time);
                self.station.plug();
                Ok(())
            }
        };
        let what = match &taken {
            Ok(()) => "taken".to_owned(),
            Err(refusal) => format!("refused, {}", refusal.kind()),
        };
        self.log.push((before, format!("{text} ({what})")));
        self.requests += 1;
        self.taken += u64::from(taken.is_ok());
    }

    fn ask(&mut self, who: ClientId, request: Request) -> Result<(), Refusal> {
        self.station.ask(who, request).map(drop)
    }

    /// Lets time pass, and judges every moment of it.
    fn pass(&mut self, time: Duration) {
        let latest = self.station.now() + time;
        let judge = &mut self.judge;
        self.station.run_until(latest, |station| {
            judge.look(station);
            judge.lost.is_some()
        });
        self.judge.read_reports(&mut self.station);
    }

    /// Returns the last requests and packets, one per line; repetitions are shown once.
    fn lately(&self) -> String {
        let dialect = self.personality.dialect();
        let packets = self.station.packets().iter().map(|(at, bytes)| {
            let packet = Packet::from_bytes(bytes);
            let command = packet.map(|packet| Command::parse(&packet, &dialect));
            (*at, format!("sent {command:?}"))
        });
        let mut lines: Vec<(Duration, String)> = self.log.iter().cloned().chain(packets).collect();
        lines.sort_by_key(|line| line.0);
        lines.dedup_by(|next, line| next.1 == line.1);
        let last = lines.iter().rev().take(LATELY).rev();
        let last = last.map(|(at, text)| format!("  {:.3} s {text}\n", at.as_secs_f64()));
        last.collect()
    }

    /// All clients release everything: the arm comes to rest and reports where it is.
    fn part(&mut self) {
        for who in self.asking.people {
            self.station.leave(who);
        }
        self.pass(Duration::from_secs(20));
    }
}

/// No faults that lose packets on the way to the arm: it has no acknowledgements, and an unknown
/// position allows no promises. The same applies to backlash and lost pulses.
const FAULTS: [&str; 12] = [
    "drop=1%:from",
    "flip=1%:from",
    "duplicate=1%:from",
    "delay=60ms",
    "delay=150ms:from",
    "withhold@9s..12s",
    "withhold@5s..+700ms",
    "close@7s..9s",
    "close@3s..+300ms",
    "reset@6s",
    "reset@11s",
    "power@8s..10s",
];
const POLICIES: [&str; 3] = [
    "",
    "[table]\nz_mm = -90\n[joints]\nbase_deg = [-70, 70]\n[workspace]\nx_mm = [120, 321]",
    "[table]\nz_mm = -80\n[jog]\nraw_dead_man_s = 0.5\n[workspace]\ny_mm = [-120, 150]\nz_mm = [-60, 120]",
];
/// Of each case, and a few more where the last of them was a row.
pub(crate) const REQUESTS: u64 = 400;
/// The number of lines shown.
const LATELY: usize = 30;
const PANIC: &str = "the station panicked";
