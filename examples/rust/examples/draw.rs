//! `cargo run -p dobot-examples --example draw -- examples/drawings/square.svg`
//!
//! Draws a file: `draw FILE [ADDRESS]`. The arm is a virtual one, an arm at `serial:PORT` or
//! `tcp:HOST:PORT`, or that of a station at `http://HOST:PORT`. A real arm moves: the example asks
//! first.

mod support;

use std::error::Error;
use std::fs;

use dobot_api::{JobKind, JobPhase, NewJob, News, Reply, Request, StationEvent};
use dobot_draw::{Settings, prepare};
use dobot_import::Source;
use dobot_plan::{ArmLimits, Paper};

#[tokio::main(flavor = "current_thread")]
async fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let file = arguments.next().ok_or("usage: draw FILE [ADDRESS]")?;
    let mut station = support::reach(arguments.next()).await?;
    let state = support::ready(&mut station).await?;
    let dialect = state.dialect.ok_or("the dialect of the arm is unknown")?;

    let settings = Settings {
        // The pen touches the paper now, or the virtual arm has its own paper.
        paper: Paper::level(state.arm.map_or(-40.0, |arm| arm.status.z_mm.into())),
        arm_limits: ArmLimits::of(dialect),
        ..Settings::default()
    };
    let source = Source::of_file(&file, fs::read(&file)?)?;
    let plan = prepare(&source, &settings, |_| Ok::<(), String>(()))?.plan;
    #[expect(clippy::cast_possible_truncation, reason = "the precision of a job")]
    let job = NewJob {
        title: file,
        kind: JobKind::Drawing,
        commands: plan.commands().collect(),
        lift_mm: plan.lift_mm() as f32,
        pauses: Vec::new(),
        program: dobot_api::JobProgram::default(),
    };
    let Reply::Job { job } = station
        .request(Request::SubmitJob { job, key: None })
        .await?
    else {
        return Err("expected a job".into());
    };
    station.request(Request::StartJob { job: job.job }).await?;
    loop {
        if let StationEvent::Notice(notice) = station.next().await?
            && let News::Job { phase, .. } = notice.news
        {
            println!("{}", notice.text);
            if phase != JobPhase::Running {
                break;
            }
        }
    }
    station.end().await;
    Ok(())
}
