//! `cargo run -p dobot-examples --example plan_time -- target/lines examples/drawings/harbour.svg`
//!
//! Plans drawings and prints, as a line of JSON for each, their strokes and vectors, the pen's
//! travel and the CPU time from file to plan. The lines of each drawing are written to the folder
//! for `tests/compare/saxi.mjs`, in mm.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use dobot_draw::{Prepared, Settings, Size, prepare};
use dobot_geometry::Stroke;
use dobot_import::{ReadOptions, Source};
use dobot_plan::ArmLimits;
use dobot_wire::Dialect;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let usage = "usage: plan_time FOLDER [DIALECT] FILE...";
    let folder = PathBuf::from(arguments.next().ok_or(usage)?);
    fs::create_dir_all(&folder)?;
    let mut dialect = Dialect::SPECIFICATION;
    for file in arguments {
        if let Ok(given) = file.parse() {
            dialect = given;
            continue;
        }
        let begin_s = cpu_s();
        let prepared = prepared(&file, dialect)?;
        let took_s = cpu_s() - begin_s;
        let summary = prepared.plan.summary();
        println!(
            r#"{{"file": "{file}", "strokes": {}, "vectors": {}, "travel_mm": {:.1}, "planned_s": {:.1}, "scale": {}, "cpu_s": {took_s:.4}}}"#,
            summary.strokes,
            summary.vectors,
            summary.travelled_mm,
            summary.duration_s,
            prepared.scale
        );
        write_lines(&file, &folder, prepared.scale)?;
    }
    Ok(())
}

/// Plans a drawing, as large as possible.
fn prepared(file: &str, dialect: Dialect) -> Result<Prepared, Box<dyn Error>> {
    let mut settings = Settings {
        arm_limits: ArmLimits::of(dialect),
        ..Settings::default()
    };
    settings.placement.size = Size::Fit;
    let anywhere = |_| Ok::<(), String>(());
    Ok(prepare(
        &Source::of_file(file, fs::read(file)?)?,
        &settings,
        anywhere,
    )?)
}

/// Writes the lines of a drawing as JSON, in its own order, read for this scale.
fn write_lines(file: &str, folder: &Path, scale: f64) -> Result<(), Box<dyn Error>> {
    let options = ReadOptions {
        scale,
        ..ReadOptions::default()
    };
    let (artwork, _) = Source::of_file(file, fs::read(file)?)?.read(&options)?;
    let strokes = artwork.layers.iter().flat_map(|layer| &layer.strokes);
    let lines: Vec<String> = strokes.map(line).collect();
    let name = Path::new(file).file_name().ok_or("a file has a name")?;
    let text = format!("[{}]", lines.join(",\n"));
    fs::write(folder.join(name).with_extension("json"), text)?;
    Ok(())
}

fn line(stroke: &Stroke) -> String {
    let points = stroke.points.iter();
    let points: Vec<String> = points.map(|p| format!("[{:.4},{:.4}]", p.x, p.y)).collect();
    format!("[{}]", points.join(","))
}

/// Returns the CPU time used so far, or the elapsed time if the system does not report it.
fn cpu_s() -> f64 {
    thread_local!(static BEGIN: Instant = Instant::now());
    let text = fs::read_to_string("/proc/thread-self/schedstat").ok();
    let cpu_ns = text.and_then(|line| line.split(' ').next()?.parse::<f64>().ok());
    cpu_ns.map_or_else(
        || BEGIN.with(Instant::elapsed).as_secs_f64(),
        |ns| ns * 1e-9,
    )
}
