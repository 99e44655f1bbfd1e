//! The cable is pulled and put back in every phase of a job.

use std::fmt;
use std::time::Duration;

use dobot_api::JobState;
use dobot_api::{News, Request};
use dobot_controller::Personality;

use super::chance::Chance;
use super::jobs::Sort;
use super::scene::{Scene, Wrong};
use super::spread::Spread;

/// The phase of the job when the cable is pulled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum During {
    /// On the way to its start.
    Approach,
    /// Somewhere in it.
    Running,
    /// It was just paused, and the arm finishes what it has got.
    Draining,
    /// The tool is lifted.
    Lifting,
    /// It is paused.
    Paused,
    /// Just resumed.
    Resuming,
}

impl During {
    /// All of them.
    pub(crate) const ALL: [Self; 6] = [
        Self::Approach,
        Self::Running,
        Self::Draining,
        Self::Lifting,
        Self::Paused,
        Self::Resuming,
    ];
}

impl fmt::Display for During {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Approach => "moving to its start",
            Self::Running => "at work",
            Self::Draining => "just paused",
            Self::Lifting => "lifting the tool",
            Self::Paused => "paused",
            Self::Resuming => "just resumed",
        })
    }
}

/// The outcome of jobs whose cable was pulled.
#[derive(Debug)]
pub(crate) struct Cables {
    /// What the job did.
    pub during: During,
    /// The number of times the cable was pulled.
    pub pulls: usize,
    /// The job was paused afterwards, with the reason.
    pub paused: usize,
    /// The arm could equally have been reset meanwhile: in-flight commands count as lost, and a
    /// person is asked to look.
    pub looks_reset: usize,
    /// Commands that the arm was never given.
    pub lost: usize,
    /// Commands that it was given again.
    pub repeated: usize,
    /// From the cable's return to the end of the light, in seconds, where it burnt then.
    pub dark_s: Spread,
    /// Violations.
    pub wrong: Vec<String>,
}

/// Pulls the cable this often in each phase.
pub(crate) fn run(pulls: u64) -> Vec<Cables> {
    During::ALL.map(|during| of(during, pulls)).into()
}

fn of(during: During, pulls: u64) -> Cables {
    let mut figures = Cables {
        during,
        pulls: 0,
        paused: 0,
        looks_reset: 0,
        lost: 0,
        repeated: 0,
        dark_s: Spread::default(),
        wrong: Vec::new(),
    };
    for (personality, sort, seed) in super::scene::cases(pulls) {
        if let Err(wrong) = one(&mut figures, personality, sort, seed) {
            figures.wrong.push(format!(
                "{personality}, {sort}, {during}, seed {seed}: {wrong}"
            ));
        }
    }
    figures
}

fn one(figures: &mut Cables, personality: Personality, sort: Sort, seed: u64) -> Result<(), Wrong> {
    let mut chance = Chance::new(seed);
    let mut scene = Scene::new(personality)?;
    let drawing = sort.job(&mut chance);
    let job = scene.begin(&drawing)?;
    come_to(figures.during, &mut scene, job, &mut chance)?;
    scene.station.unplug();
    scene.station.run_for(chance.time(Duration::from_secs(6)));
    let (back, burnt) = (scene.station.now(), scene.burns());
    scene.station.plug();
    let dark = |station: &dobot_host::VirtualStation| !super::scene::burns(station);
    if !scene
        .station
        .run_until(back + Duration::from_secs(10), dark)
    {
        return Err(Wrong("the laser burns on".into()));
    }
    if burnt {
        figures.dark_s.add_time(back, scene.station.now());
    }
    figures.pulls += 1;
    figures.paused += usize::from(matches!(scene.settle(job)?, JobState::Paused { .. }));
    scene.finish(job)?;
    if scene
        .station
        .notices()
        .iter()
        .any(|notice| notice.news == News::Reset)
    {
        figures.looks_reset += 1;
        return Ok(());
    }
    let given = scene.given(&drawing);
    figures.lost += given.lost;
    figures.repeated += given.repeated;
    scene.check(&drawing)
}

/// Lets the job come to the phase, and a random moment of it.
fn come_to(during: During, scene: &mut Scene, job: u64, chance: &mut Chance) -> Result<(), Wrong> {
    let planned = scene.planned();
    if during == During::Approach {
        scene
            .station
            .run_for(chance.time(Duration::from_millis(1_500)));
        return Ok(());
    }
    scene
        .station
        .run_for(Duration::from_millis(500) + chance.time(planned * 3 / 4));
    let most_ms = match during {
        During::Approach | During::Running => return Ok(()),
        During::Draining => 500,
        During::Lifting => 3_000,
        During::Paused => 8_000,
        During::Resuming => 1_500,
    };
    // A job that was over by then cannot be paused; the cable is still pulled.
    let pausing = scene.station.ask(scene.anna, Request::PauseJob).is_ok();
    if pausing && matches!(during, During::Paused | During::Resuming) {
        scene.settle(job)?;
    }
    if pausing && during == During::Resuming {
        scene.start(job)?;
    }
    scene
        .station
        .run_for(chance.time(Duration::from_millis(most_ms)));
    Ok(())
}
