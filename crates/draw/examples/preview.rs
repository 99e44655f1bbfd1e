//! `cargo run -p dobot-draw --example preview -- examples/drawings/harbour.svg target/preview`
//!
//! Draws a file on a virtual stock arm, prints its figures, and makes pictures and the timeline of
//! it: `preview.png`, `preview-passes.png`, `preview.svg` and `preview.json`. Moves nothing real.

use std::error::Error;
use std::fs;

use dobot_client::Connection;
use dobot_controller::{Controller, Personality, PowerUp};
use dobot_draw::{
    Colors, LayersBy, Picture, Sample, Settings, Size, Source, Trace, View, prepare, run,
};
use dobot_sim::{InProcess, Line, RECORDING_PERIOD, VirtualArm};

#[tokio::main(flavor = "current_thread")]
async fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let (Some(file), Some(out)) = (arguments.next(), arguments.next()) else {
        return Err("usage: preview FILE OUT".into());
    };
    let mut settings = Settings {
        layers: Some(LayersBy::Color),
        ..Settings::default()
    };
    settings.placement.size = Size::Fit;
    let source = Source::of_file(&file, fs::read(&file)?)?;
    let prepared = prepare(&source, &settings, |_| Ok::<(), String>(()))?;
    let plan = &prepared.plan;

    let controller = Controller::power_up(PowerUp::new(Personality::Specification));
    let twin = InProcess::new(VirtualArm::new(controller, Line::STOCK));
    twin.arm().record(RECORDING_PERIOD);
    let dialect = Personality::Specification.dialect();
    let mut arm = Connection::over_peer(twin.clone(), Some(dialect));
    let ready = async |message: &str| println!("{message}");
    run(&mut arm, plan, ready, std::future::pending(), |_| {}).await?;
    let samples: Vec<Sample> = (twin.arm().samples().iter())
        .map(
            |&dobot_sim::Sample {
                 at,
                 position,
                 laser,
             }| Sample {
                at,
                position,
                laser,
            },
        )
        .collect();

    let trace = Trace::new(plan, &settings.paper, &samples, &prepared.wanted())?;
    let (estimate, ink) = (trace.estimate(), trace.ink());
    let tolerance_mm = settings.tolerance_mm;
    let picture = |colors| Picture {
        title: &file,
        figures: &[],
        passes: &estimate.passes,
        area: settings.placement.area,
        plan,
        drawn: &ink,
        colors,
        view: View::Paper,
    };
    let errors = picture(Colors::Error { tolerance_mm });
    fs::write(format!("{out}.svg"), errors.to_svg())?;
    fs::write(format!("{out}.png"), errors.to_png(1600)?)?;
    let passes = picture(Colors::Passes).to_png(1600)?;
    fs::write(format!("{out}-passes.png"), passes)?;
    fs::write(
        format!("{out}.json"),
        serde_json::to_string(&trace.timeline())?,
    )?;
    println!("{}", serde_json::to_string_pretty(&estimate)?);
    Ok(())
}
