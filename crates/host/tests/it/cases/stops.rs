//! Stops at random moments of any activity of the arm.

use std::fmt;
use std::time::Duration;

use dobot_api::{Jog, NewJob, Request};
use dobot_controller::Personality;
use dobot_host::VirtualStation;
use dobot_wire::{Command, JointJog, JointJogAxis, LinearJog, LinearJogAxis, MoveTo, MovingMode};

use super::chance::Chance;
use super::jobs::Sort;
use super::scene::{Scene, Wrong, burns, each_seed};
use super::spread::Spread;

/// The motion of the arm when it is stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum StoppedMotion {
    /// A job, from its start to its end.
    Job(Sort),
    /// Targets of a client, as many as wait.
    Targets,
    /// A button that is held, of a joint or an axis.
    Jog,
    /// A job that is being paused, or that continues.
    Pausing,
    /// The in-flight commands when the station was killed.
    Killed,
}

impl StoppedMotion {
    /// All of them.
    pub(crate) const ALL: [Self; 7] = [
        Self::Job(Sort::Pen),
        Self::Job(Sort::Burn),
        Self::Job(Sort::Program),
        Self::Targets,
        Self::Jog,
        Self::Pausing,
        Self::Killed,
    ];
}

impl fmt::Display for StoppedMotion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Job(sort) => sort.fmt(f),
            Self::Targets => f.write_str("targets of a client"),
            Self::Jog => f.write_str("a jog"),
            Self::Pausing => f.write_str("a job that is paused and resumed"),
            Self::Killed => f.write_str("a job whose station has just restarted"),
        }
    }
}

/// The figures of the stops of one motion.
#[derive(Debug)]
pub(crate) struct Stops {
    /// The motion.
    pub doing: StoppedMotion,
    /// The number of stops.
    pub times: usize,
    /// At rest later than was promised.
    pub late: usize,
    /// The laser was on later than that.
    pub burnt: usize,
    /// The promised times, in seconds.
    pub promised_s: Spread,
    /// The actual times, in seconds.
    pub took_s: Spread,
    /// From the stop to the end of the light, in seconds, where it burnt.
    pub dark_s: Spread,
    /// Violations.
    pub wrong: Vec<String>,
}

/// Stops the arm this often in each motion.
pub(crate) fn run(stops: u64) -> Vec<Stops> {
    StoppedMotion::ALL.map(|doing| of(doing, stops)).into()
}

fn of(doing: StoppedMotion, stops: u64) -> Stops {
    let mut figures = Stops {
        doing,
        times: 0,
        late: 0,
        burnt: 0,
        promised_s: Spread::default(),
        took_s: Spread::default(),
        dark_s: Spread::default(),
        wrong: Vec::new(),
    };
    figures.wrong = each_seed(stops, doing, |personality, seed| {
        one(&mut figures, personality, seed)
    });
    figures
}

fn one(figures: &mut Stops, personality: Personality, seed: u64) -> Result<(), Wrong> {
    let mut chance = Chance::new(seed);
    let mut scene = Scene::new(personality)?;
    match figures.doing {
        StoppedMotion::Job(sort) => {
            let wanted = sort.job(&mut chance);
            work(&mut scene, &wanted, &mut chance)?;
        }
        StoppedMotion::Targets => targets(&mut scene, &mut chance)?,
        StoppedMotion::Jog => jog(&mut scene, &mut chance)?,
        StoppedMotion::Pausing => pause(&mut scene, &mut chance)?,
        StoppedMotion::Killed => {
            let wanted = chance.one(&Sort::ALL).job(&mut chance);
            work(&mut scene, &wanted, &mut chance)?;
            scene
                .station
                .crash(chance.time(Duration::from_millis(300)))?;
            scene
                .station
                .run_for(Duration::from_millis(100) + chance.time(Duration::from_secs(1)));
            scene.anna = scene.station.client("Anna");
        }
    }
    stop(figures, &mut scene)
}

/// Stops, and watches the arm.
fn stop(figures: &mut Stops, scene: &mut Scene) -> Result<(), Wrong> {
    let (at, burnt) = (scene.station.now(), scene.burns());
    scene
        .station
        .ask(scene.anna, Request::Stop { reason: None })?;
    let stopped = watch(scene, at)?;
    figures.times += 1;
    figures.promised_s.add(stopped.promised.as_secs_f64());
    figures.took_s.add(stopped.took_s);
    if burnt {
        figures.dark_s.add_time(at, stopped.lit);
    }
    figures.burnt += usize::from(stopped.burns_too_long());
    let late = stopped.check_rest();
    figures.late += usize::from(late.is_err());
    late
}

/// The outcome for a stopped arm.
pub(super) struct Stopped {
    at: Duration,
    promised: Duration,
    /// How long it took to come to rest, in seconds.
    pub(super) took_s: f64,
    /// When the laser was last seen on; the time of the stop if it was not.
    pub(super) lit: Duration,
}

/// Watches an arm that was stopped at this time, until long after it has to rest.
pub(super) fn watch(scene: &mut Scene, at: Duration) -> Result<Stopped, Wrong> {
    let stop = scene.station.supervisor().state().stop;
    let stop = stop.ok_or_else(|| Wrong("no stop holds the arm".into()))?;
    let promised = Duration::try_from_secs_f64(stop.rests_by_s - stop.at_s).unwrap_or_default();
    let mut lit = at;
    let note = |station: &VirtualStation| {
        if burns(station) {
            lit = station.now();
        }
        false
    };
    scene.station.run_until(
        at + promised.max(Duration::from_secs(4)) + Duration::from_secs(8),
        note,
    );
    Ok(Stopped {
        at,
        promised,
        took_s: (scene.rested_s() - at.as_secs_f64()).max(0.0),
        lit,
    })
}

impl Stopped {
    /// Returns whether the laser was on for longer than promised. The last packets are repeated,
    /// and may not have arrived at first.
    pub(super) fn burns_too_long(&self) -> bool {
        let dark_by = self.promised.max(Duration::from_millis(200));
        self.lit.saturating_sub(self.at) > dark_by
    }

    /// Checks that the arm came to rest as promised.
    pub(super) fn check_rest(&self) -> Result<(), Wrong> {
        let Self {
            promised, took_s, ..
        } = self;
        if *took_s > promised.as_secs_f64() {
            return Err(Wrong(format!("promised {promised:?}, took {took_s} s")));
        }
        Ok(())
    }
}

pub(super) fn work(scene: &mut Scene, wanted: &NewJob, chance: &mut Chance) -> Result<(), Wrong> {
    scene.begin(wanted)?;
    let planned = scene.planned();
    scene.station.run_for(chance.time(planned));
    Ok(())
}

fn pause(scene: &mut Scene, chance: &mut Chance) -> Result<(), Wrong> {
    let job = scene.begin(&chance.one(&Sort::ALL).job(chance))?;
    let planned = scene.planned();
    scene.station.run_for(chance.time(planned / 2));
    scene.station.ask(scene.anna, Request::PauseJob)?;
    if chance.below(2) == 0 {
        scene.settle(job)?;
        scene.start(job)?;
    }
    scene.station.run_for(chance.time(Duration::from_secs(2)));
    Ok(())
}

pub(super) fn targets(scene: &mut Scene, chance: &mut Chance) -> Result<(), Wrong> {
    for _ in 0..=chance.below(5) {
        let command: Command = MoveTo {
            x_mm: chance.between(200.0, 235.0),
            y_mm: chance.between(-90.0, 90.0),
            z_mm: chance.between(0.0, 40.0),
            rotation_deg: 0.0,
            suction: false,
            mode: chance.one(&[MovingMode::Jump, MovingMode::MovJ, MovingMode::MovL]),
            gripper_deg: 0.0,
            pause_s: chance.one(&[0.0, 0.3, 1.0]),
        }
        .into();
        scene
            .station
            .ask(scene.anna, Request::Command { command })?;
        scene.station.run_for(chance.time(Duration::from_secs(1)));
    }
    Ok(())
}

/// Holds a button, and mostly lets it go again before the stop: or not.
pub(super) fn jog(scene: &mut Scene, chance: &mut Chance) -> Result<(), Wrong> {
    let speed_percent = chance.between(10.0, 100.0);
    let jog = if chance.below(2) == 0 {
        Jog::Linear(LinearJog {
            axis: chance.one(&[
                LinearJogAxis::YPlus,
                LinearJogAxis::YMinus,
                LinearJogAxis::ZPlus,
            ]),
            speed_percent,
        })
    } else {
        Jog::Joint(JointJog {
            axis: chance.one(&[JointJogAxis::BasePlus, JointJogAxis::BaseMinus]),
            speed_percent,
        })
    };
    for _ in 0..chance.below(30) {
        scene.station.ask(scene.anna, Request::Jog { jog })?;
        scene.station.run_for(Duration::from_millis(60));
    }
    if chance.below(4) == 0 {
        scene.station.ask(scene.anna, Request::Release)?;
    }
    scene
        .station
        .run_for(chance.time(Duration::from_millis(140)));
    Ok(())
}
