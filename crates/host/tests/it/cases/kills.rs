//! The station is killed in the middle of a job and started again.

use std::time::Duration;

use dobot_api::JobState;
use dobot_api::Request;
use dobot_controller::Personality;
use dobot_host::VirtualStation;

use super::chance::Chance;
use super::jobs::Sort;
use super::scene::{LASER_OFF, Scene, Wrong, burns, cases};
use super::spread::Spread;

/// The outcome of jobs whose station was killed.
#[derive(Debug, Default)]
pub(crate) struct Kills {
    /// The number of times the station was killed.
    pub times: usize,
    /// While a job had the arm.
    pub at_work: usize,
    /// While the laser burnt.
    pub burning: usize,
    /// Jobs that were drawn to their end.
    pub jobs: usize,
    /// Commands that the arm was never given.
    pub lost: usize,
    /// Commands that it was given again.
    pub repeated: usize,
    /// Afterwards a person had to determine the progress of the arm.
    pub unclear: usize,
    /// The first packet after the start was not laser off.
    pub not_off_first: usize,
    /// The laser was on when the arm had come to rest after the start.
    pub burnt_at_rest: usize,
    /// From the start of the station to the end of the light, in seconds, where it burnt then.
    pub off_after_s: Spread,
    /// Violations.
    pub wrong: Vec<String>,
}

/// Kills stations at random moments until there were `kills` of them.
pub(crate) fn run(kills: usize) -> Kills {
    let mut figures = Kills::default();
    for (personality, sort, seed) in cases(u64::MAX) {
        if figures.times >= kills {
            break;
        }
        if let Err(wrong) = one(&mut figures, personality, sort, seed) {
            figures
                .wrong
                .push(format!("{personality}, {sort}, seed {seed}: {wrong}"));
        }
    }
    figures
}

fn one(figures: &mut Kills, personality: Personality, sort: Sort, seed: u64) -> Result<(), Wrong> {
    let mut chance = Chance::new(seed);
    let mut scene = Scene::new(personality)?;
    let drawing = sort.job(&mut chance);
    let job = scene.begin(&drawing)?;
    let planned = scene.planned();
    for _ in 0..=chance.below(2) {
        scene.station.run_for(chance.time(planned));
        if chance.below(4) == 0 && scene.station.ask(scene.anna, Request::PauseJob).is_ok() {
            scene.station.run_for(chance.time(Duration::from_secs(4)));
        }
        if scene.station.job(job)?.state.is_over() {
            break;
        }
        kill(figures, &mut scene, &mut chance)?;
        figures.unclear += usize::from(is_unclear(&scene.settle(job)?));
        scene.come_back()?;
        scene.start(job)?;
    }
    scene.finish(job)?;
    let given = scene.given(&drawing);
    figures.jobs += 1;
    figures.lost += given.lost;
    figures.repeated += given.repeated;
    scene.check(&drawing)
}

/// Kills the station, starts it again, and looks at the laser.
fn kill(figures: &mut Kills, scene: &mut Scene, chance: &mut Chance) -> Result<(), Wrong> {
    figures.times += 1;
    figures.burning += usize::from(scene.burns());
    let before = scene.station.packets().len();
    scene.station.crash(chance.time(Duration::from_secs(5)))?;
    figures.at_work += usize::from(scene.station.supervisor().job().is_some());
    let (began, burnt) = (scene.station.now(), scene.burns());
    let mut last = began;
    let rests = |station: &VirtualStation| {
        if burns(station) {
            last = station.now();
        }
        station.supervisor().is_at_rest() && station.now() > began + Duration::from_secs(1)
    };
    if !scene
        .station
        .run_until(began + Duration::from_secs(60), rests)
    {
        return Err(Wrong("the arm did not come to rest".into()));
    }
    if burnt {
        figures.off_after_s.add_time(began, last);
    }
    figures.burnt_at_rest += usize::from(scene.burns());
    let first = scene.sent(before).first().copied();
    figures.not_off_first += usize::from(first != Some(LASER_OFF));
    Ok(())
}

fn is_unclear(state: &JobState) -> bool {
    state.to_string().contains("say")
}
