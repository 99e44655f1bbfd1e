//! `cargo run --release -p dobot-draw --example drawn -- firmware-1.1 DRAWING.svg ...`
//!
//! Has a virtual arm of that personality make drawings over a line as slow as the real one, and
//! compares what it did with the plan: how long it took, how far it left the path, and how much it
//! accelerated, looked at each 80 ms.

use std::error::Error;
use std::fs;

use dobot_client::Connection;
use dobot_controller::{Controller, Personality, PowerUp};
use dobot_draw::{Machine, Pen, Settings, Size, Source, deviation, ink, prepare, run};
use dobot_sim::{InProcess, Line, RECORDING_PERIOD, Sample, VirtualArm};

#[tokio::main(flavor = "current_thread")]
async fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let Some(personality) = arguments.next() else {
        return Err("usage: drawn PERSONALITY DRAWING.svg ...".into());
    };
    let personality: Personality = personality.parse()?;
    for file in arguments {
        println!("{file} {}", drawn(&file, personality).await?);
    }
    Ok(())
}

async fn drawn(file: &str, personality: Personality) -> Result<String, Box<dyn Error>> {
    let dialect = personality.dialect();
    let mut settings = Settings {
        machine: Machine::of(dialect),
        ..Settings::default()
    };
    settings.placement.size = Size::Fit;
    let anywhere = |_| Ok::<(), String>(());
    let prepared = prepare(
        &Source::of_file(file, fs::read(file)?)?,
        &settings,
        anywhere,
    )?;
    let plan = &prepared.plan;

    let controller = Controller::power_up(PowerUp::new(personality));
    let arm = InProcess::new(VirtualArm::new(controller, Line::STOCK));
    let mut connection = Connection::over_peer(arm.clone(), Some(dialect));
    arm.arm().record(RECORDING_PERIOD);
    let never = std::future::pending();
    let finished = run(&mut connection, plan, &Pen::default(), never, |_| {}).await?;
    let arm = arm.arm();
    let samples = arm.samples();
    let moved_s = moved_s(samples, plan.start, plan.lift_mm());
    let ink = ink(samples.iter().map(|it| it.position), -40.0);
    let planned_s = plan.duration_s();
    Ok(format!(
        "{} vectors, planned {planned_s:.2} s, took {:.2} s, moved {moved_s:.2} s, deviation {:.4} mm, acceleration {:.1}",
        plan.moves.len(),
        finished.time.as_secs_f64(),
        deviation(&prepared.wanted, &ink).largest_mm(),
        acceleration(samples, moved_s),
    ))
}

/// From when it leaves the start of the plan to when it comes to rest.
fn moved_s(samples: &[Sample], start: [f64; 3], lift_mm: f64) -> f64 {
    let at_start = |sample: &&Sample| {
        let p = sample.position;
        let away = [p.x.0 - start[0], p.y.0 - start[1], p.z.0 - start[2]];
        away.iter().all(|it| it.abs() < 0.001 * lift_mm)
    };
    let began = samples
        .iter()
        .rfind(at_start)
        .map_or(0.0, |it| it.at.as_secs_f64());
    samples.last().map_or(0.0, |it| it.at.as_secs_f64()) - began
}

/// The largest second difference of the places 80 ms apart, over the last `moved_s`.
fn acceleration(samples: &[Sample], moved_s: f64) -> f64 {
    let step_s = 0.02;
    let (mut places, mut i) = (Vec::new(), 0);
    let end_s = samples.last().map_or(0.0, |it| it.at.as_secs_f64());
    let mut t_s = end_s - moved_s;
    while t_s < end_s {
        while samples[i + 1].at.as_secs_f64() < t_s {
            i += 1;
        }
        let [a, b] = [samples[i], samples[i + 1]];
        let [from_s, to_s] = [a, b].map(|it| it.at.as_secs_f64());
        let share = ((t_s - from_s) / (to_s - from_s).max(1e-9)).clamp(0.0, 1.0);
        let [from, to] = [a, b].map(|it| [it.position.x.0, it.position.y.0, it.position.z.0]);
        places.push([0, 1, 2].map(|k| from[k] + share * (to[k] - from[k])));
        t_s += step_s;
    }
    let seen = places.windows(9).map(|seen| {
        let parts = [0, 1, 2].map(|k| seen[0][k] - 2.0 * seen[4][k] + seen[8][k]);
        parts.iter().map(|it| it * it).sum::<f64>().sqrt() / (0.08 * 0.08)
    });
    seen.fold(0.0, f64::max)
}
