//! One long line, in the middle of which the arm is stopped, its job is paused, or its station is gone.

use std::fmt;
use std::time::Duration;

use dobot_api::{JobKind, JobProgram, NewJob, Request};
use dobot_controller::Personality;
use dobot_draw::{Material, Materials};
use dobot_geometry::{Point, Stroke};
use dobot_host::VirtualStation;
use dobot_plan::{ArmLimits, DrawingTool, Paper, Pass, Plan};

use super::chance::Chance;
use super::jobs::DOWN_MM;
use super::scene::{Scene, Wrong, burns, each_seed};
use super::spread::Spread;
use super::watchdogs::{Fate, left_alone};

/// What ends the line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LineEnd {
    /// A person stops the arm.
    Stopped,
    /// A person pauses the job.
    Paused,
    /// The station is killed, and its watchdog is there.
    Killed,
    /// The station is frozen, and its watchdog runs.
    Frozen,
}

impl LineEnd {
    /// All of them.
    pub(crate) const ALL: [Self; 4] = [Self::Stopped, Self::Paused, Self::Killed, Self::Frozen];
}

impl fmt::Display for LineEnd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Stopped => "stop",
            Self::Paused => "pause",
            Self::Killed => "station killed",
            Self::Frozen => "station freezes",
        })
    }
}

/// The outcome of the lines in one material.
#[derive(Debug)]
pub(crate) struct LongLines {
    /// The material, or the pen.
    pub material: String,
    /// Whether a laser burns it.
    pub burns: bool,
    /// For each end, the time from then to the end of the light, or of a pen's motion along the line, in seconds.
    pub ends: [(LineEnd, Spread); 4],
    /// The number of these that were longer than allowed.
    pub late: usize,
    /// Violations.
    pub wrong: Vec<String>,
}

/// A line in each material, ended this often in each way.
pub(crate) fn run(times: u64) -> Vec<LongLines> {
    let materials = Materials::built_in();
    materials
        .iter()
        .map(|(name, material)| of(name, material, times))
        .collect()
}

fn of(name: &str, material: &Material, times: u64) -> LongLines {
    let burns = material.tool.burns();
    let mut wrong = Vec::new();
    let ends = LineEnd::ALL.map(|end| {
        let mut took_s = Spread::default();
        let case = format_args!("{name}, {end}");
        wrong.extend(each_seed(times, case, |personality, seed| {
            took_s.add(one(material.tool, end, personality, seed)?);
            Ok(())
        }));
        (end, took_s)
    });
    LongLines {
        material: name.to_owned(),
        burns,
        late: ends
            .iter()
            .map(|(end, took_s)| took_s.above(most_s(*end, material.tool)))
            .sum(),
        ends,
        wrong,
    }
}

/// Returns how long the laser stays on, or a pen moves along the line, in seconds.
fn one(tool: DrawingTool, end: LineEnd, personality: Personality, seed: u64) -> Result<f64, Wrong> {
    let mut chance = Chance::new(seed);
    let mut scene = Scene::new(personality)?;
    scene.begin(&line(tool, personality)?)?;
    let latest = scene.station.now() + Duration::from_secs(60);
    let draws = |station: &VirtualStation| {
        let last = station.arm().samples().last().map(|sample| sample.position);
        last.is_some_and(|last| last.z.0 < f64::from(DOWN_MM) + 0.1 && last.y.0 > BEGIN_MM + 1.0)
    };
    let begun = |station: &VirtualStation| {
        if tool.burns() {
            burns(station)
        } else {
            draws(station)
        }
    };
    if !scene.station.run_until(latest, begun) {
        return Err(Wrong("the line does not begin".into()));
    }
    scene
        .station
        .run_for(chance.time(Duration::from_millis(1500)));
    let at = scene.station.now();
    let request = match end {
        LineEnd::Stopped => Request::Stop { reason: None },
        LineEnd::Paused => Request::PauseJob,
        LineEnd::Killed | LineEnd::Frozen => {
            let fate = if end == LineEnd::Killed {
                Fate::Killed
            } else {
                Fate::Frozen
            };
            let (after, ..) = left_alone(scene, fate, &mut chance);
            let over = if tool.burns() { after.lit } else { after.rests };
            return Ok(over.saturating_sub(at).as_secs_f64());
        }
    };
    scene.station.ask(scene.anna, request)?;
    let (mut over, mut last_mm) = (at, y_mm(&scene.station));
    let note = |station: &VirtualStation| {
        let continues = if tool.burns() {
            burns(station)
        } else {
            (y_mm(station) - last_mm).abs() > 1e-3
        };
        if continues {
            (over, last_mm) = (station.now(), y_mm(station));
        }
        false
    };
    scene.station.run_until(at + Duration::from_secs(40), note);
    Ok(over.saturating_sub(at).as_secs_f64())
}

/// Along Y, 96 mm.
fn line(tool: DrawingTool, personality: Personality) -> Result<NewJob, Wrong> {
    let ends = [BEGIN_MM, BEGIN_MM + 96.0].map(|y| Point::new(220.0, y));
    let pass = Pass::new(tool, vec![Stroke::open(ends.to_vec())]);
    let arm_limits = ArmLimits::of(personality.dialect());
    let plan = Plan::new(&[pass], &Paper::level(DOWN_MM.into()), &arm_limits);
    let plan = plan.map_err(|error| Wrong(error.to_string()))?;
    Ok(NewJob {
        title: "one long line".into(),
        kind: JobKind::Drawing,
        commands: plan.commands().collect(),
        lift_mm: if tool.burns() { 0.0 } else { 5.0 },
        pauses: Vec::new(),
        program: JobProgram::default(),
    })
}

fn y_mm(station: &VirtualStation) -> f64 {
    let last = station.arm().samples().last();
    last.map_or(0.0, |last| last.position.y.0)
}

const BEGIN_MM: f64 = -48.0;
/// A laser is off by then, and a pen goes no farther along its line, in seconds; in a pause a pen slows down on its line besides.
fn most_s(end: LineEnd, tool: DrawingTool) -> f64 {
    match end {
        _ if tool.burns() => 0.5,
        LineEnd::Paused => 1.5,
        _ => 0.7,
    }
}
