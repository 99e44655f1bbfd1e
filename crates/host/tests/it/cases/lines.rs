//! Bytes that are lost, damaged and late.

use dobot_api::JobState;
use dobot_controller::Personality;

use super::chance::Chance;
use super::jobs::Sort;
use super::paper::{ASIDE_MM, Paper};
use super::scene::{Scene, Wrong, each_seed};

/// The outcome of pen drawings on a bad line, without a person to resume a paused one.
#[derive(Debug, Default)]
pub(crate) struct Lines {
    /// The fault of the line.
    pub fault: &'static str,
    /// The number of started drawings.
    pub drawings: usize,
    /// Done, and right on the paper.
    pub done: usize,
    /// Paused, with the reason.
    pub paused: usize,
    /// Paused, and something was on the paper by then that was not wanted.
    pub spoilt: usize,
    /// Failed, for the arm does not rest where the drawing ends.
    pub failed: usize,
    /// Done as the station has it, and wrong on the paper.
    pub silently_wrong: usize,
    /// One of these.
    pub example: Option<String>,
    /// A reason of a pause.
    pub reason: Option<String>,
    /// Violations.
    pub wrong: Vec<String>,
}

/// The faults of the lines. A packet has 42 bytes: if one byte in a thousand is lost, so is one
/// packet in 24.
pub(crate) const FAULTS: [&str; 9] = [
    "drop=0.1%:from",
    "drop=1%:from",
    "flip=0.1%:from",
    "flip=1%:from",
    "delay=200ms:from",
    "delay=100ms:to",
    "drop=0.01%:to",
    "drop=0.1%:to",
    "flip=0.1%:to",
];

/// Draws this many drawings with each fault.
pub(crate) fn run(drawings: u64) -> Vec<Lines> {
    FAULTS.map(|fault| of(fault, drawings)).into()
}

fn of(fault: &'static str, drawings: u64) -> Lines {
    let mut figures = Lines {
        fault,
        ..Lines::default()
    };
    figures.wrong = each_seed(drawings, fault, |personality, seed| {
        one(&mut figures, personality, seed)
    });
    figures
}

fn one(figures: &mut Lines, personality: Personality, seed: u64) -> Result<(), Wrong> {
    let mut chance = Chance::new(seed);
    // The start, before the line becomes bad, does not count.
    let fault = format!("{}@2s", figures.fault);
    let mut scene = Scene::faulty(personality, &[&fault], seed)?;
    let drawing = Sort::Pen.job(&mut chance);
    let job = scene.begin(&drawing)?;
    figures.drawings += 1;
    let state = scene.settle(job)?;
    let paper = Paper::of(scene.station.arm().samples(), &drawing);
    match state {
        JobState::Done if paper.is_right() => figures.done += 1,
        JobState::Done => {
            figures.silently_wrong += 1;
            figures.example = Some(format!("{personality}, seed {seed}: {paper:?}"));
        }
        JobState::Paused { reason } => {
            figures.paused += 1;
            figures.spoilt += usize::from(paper.aside_mm >= ASIDE_MM);
            figures.reason = Some(reason);
        }
        JobState::Failed { reason } => {
            figures.failed += 1;
            figures.reason = Some(reason);
        }
        other => return Err(Wrong(format!("the job is {other}"))),
    }
    Ok(())
}
