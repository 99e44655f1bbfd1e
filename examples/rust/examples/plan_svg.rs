//! `cargo run -p dobot-examples --example plan_svg -- examples/drawings/harbour.svg target/plan.png`
//!
//! Plans a drawing, prints its figures and draws the picture of a perfect arm. Moves nothing.

use std::error::Error;
use std::fs;

use dobot_arm::Position;
use dobot_draw::{Colors, InkLine, Picture, Settings, View, prepare};
use dobot_import::Source;
use dobot_plan::MoveKind;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let (file, picture) = (arguments.next(), arguments.next());
    let (Some(file), Some(picture)) = (file, picture) else {
        return Err("usage: plan_svg FILE.svg PICTURE.png [all]".into());
    };
    let settings = Settings::default();
    let reach = |p: Position| match p.reach().0 {
        129.0..=321.0 => Ok(()),
        reach => Err(format!("reach is {reach:.1} mm, allowed are 129 to 321")),
    };
    let prepared = prepare(&Source::of_file(&file, fs::read(&file)?)?, &settings, reach)?;
    let summary = prepared.plan.summary();
    println!("{summary:#?}");
    let drawn = prepared.plan.paths(MoveKind::Draw);
    let png = Picture {
        title: &file,
        figures: &[
            ("strokes".into(), summary.strokes.to_string()),
            ("vectors".into(), summary.vectors.to_string()),
            (
                "drawn".into(),
                format!("{:.2} m", summary.drawn_mm / 1000.0),
            ),
            (
                "travelled".into(),
                format!("{:.2} m", summary.travelled_mm / 1000.0),
            ),
            (
                "time on the arm".into(),
                format!("{:.0} s", summary.duration_s),
            ),
        ],
        passes: &[],
        area: settings.placement.area,
        sheet: None,
        plan: &prepared.plan,
        drawn: &InkLine::measured(drawn, &prepared.wanted()),
        colors: Colors::Error {
            tolerance_mm: settings.tolerance_mm,
        },
        view: arguments.next().map_or(View::Paper, |_| View::Reach),
    }
    .to_png(1600)?;
    fs::write(picture, png)?;
    Ok(())
}
