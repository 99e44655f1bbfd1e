//! Drawings, and what became of them on the paper.

use std::time::Duration;

use dobot_api::{ClientId, JobKind, NewJob, Request};
use dobot_arm::{Millimeters, Position};
use dobot_controller::{Personality, PowerUp};
use dobot_host::VirtualStation;
use dobot_safety::Policy;
use dobot_sim::RECORDING_PERIOD;
use dobot_wire::Command;

use crate::cases::commands::{settings, target, vector};

/// The drawing height of the pen.
pub(crate) const DOWN_MM: f32 = -30.0;
const UP_MM: f32 = -20.0;

pub(crate) fn virtual_station(personality: Personality) -> VirtualStation {
    let mut virtual_station = VirtualStation::new(PowerUp::new(personality), Policy::default());
    virtual_station.arm_mut().record(RECORDING_PERIOD);
    virtual_station.run_for(Duration::from_secs(1));
    virtual_station
}

/// Takes control, arms the laser and starts to burn a spiral; returns the job.
pub(crate) fn start_burning(station: &mut VirtualStation, client: ClientId) -> u64 {
    station.ask(client, Request::TakeLease).unwrap();
    let job = station.submit(&burnt_spiral(20)).unwrap();
    let armed = station.ask(client, Request::ArmLaser { for_s: 600.0 });
    armed.unwrap();
    station.start(client, job).unwrap();
    job
}

/// Whether the journal holds a job as paused.
pub(crate) fn is_paused(station: &VirtualStation, job: u64) -> bool {
    let job = station.job(job).unwrap();
    job.state.to_string().starts_with("paused")
}

/// A spiral of straight lines: no two of its points are near each other.
pub(crate) fn spiral(lines: u16) -> NewJob {
    job("a spiral", &spiral_vectors(lines), false)
}

/// A burnt spiral.
pub(crate) fn burnt_spiral(lines: u16) -> NewJob {
    job("a burnt spiral", &spiral_vectors(lines), true)
}

fn spiral_vectors(lines: u16) -> Vec<[f32; 2]> {
    let side = |line: u16| 4.0 + f32::from(line / 2) * 2.0;
    (0..lines)
        .map(|line| match line % 4 {
            0 => [side(line), 0.0],
            1 => [0.0, side(line)],
            2 => [-side(line), 0.0],
            _ => [0.0, -side(line)],
        })
        .collect()
}

fn job(title: &str, vectors: &[[f32; 2]], burns: bool) -> NewJob {
    let mut commands = settings(burns).to_vec();
    commands.push(target([220.0, 0.0, UP_MM]).into());
    commands.push(vector([0.0, 0.0, DOWN_MM - UP_MM], false));
    commands.extend(vectors.iter().map(|&[x, y]| vector([x, y, 0.0], burns)));
    commands.push(vector([0.0, 0.0, UP_MM - DOWN_MM], false));
    NewJob {
        title: title.into(),
        kind: JobKind::Drawing,
        commands,
        lift_mm: if burns { 0.0 } else { 5.0 },
        pauses: Vec::new(),
        program: dobot_api::JobProgram::default(),
    }
}

/// Returns the length of the line drawn on the paper; overlapping strokes count again.
pub(crate) fn drawn_mm(virtual_station: &VirtualStation) -> f64 {
    let samples = virtual_station.arm().samples();
    let down = |at: Position| (at.z.0 - f64::from(DOWN_MM)).abs() < 0.2;
    let flat = |at: Position| Position {
        z: Millimeters(0.0),
        ..at
    };
    samples
        .windows(2)
        .filter(|pair| down(pair[0].position) && down(pair[1].position))
        .map(|pair| flat(pair[0].position).distance(flat(pair[1].position)).0)
        .sum()
}

/// Returns the planned length of a job's line.
pub(crate) fn wanted_mm(job: &NewJob) -> f64 {
    let flat = |command: &Command| match command {
        Command::WriteVector(vector) if vector.z_mm == 0.0 => {
            f64::from(vector.x_mm.hypot(vector.y_mm))
        }
        _ => 0.0,
    };
    job.commands.iter().map(flat).sum()
}

/// Returns whether a job is over.
pub(crate) fn is_over(station: &VirtualStation, job: u64) -> bool {
    station.job(job).unwrap().state.is_over()
}
