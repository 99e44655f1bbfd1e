//! `cargo run -p dobot-examples --example plan_json -- examples/drawings/harbour.svg specification link`
//!
//! Plans a drawing and prints, as JSON for `tests/compare/toppra_time.py`, the duration of the
//! plan, the acceleration of the motion, and the strokes with their speeds. Moves nothing.

use std::error::Error;
use std::fmt::Write as _;
use std::fs;

use dobot_draw::{Settings, Size, prepare};
use dobot_import::Source;
use dobot_plan::{ArmLimits, LinkRate, MoveKind, Plan, acceleration};
use dobot_wire::Dialect;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let Some(file) = arguments.first() else {
        return Err("usage: plan_json DRAWING.svg [DIALECT] [link]".into());
    };
    let dialect = arguments
        .iter()
        .find_map(|argument| argument.parse::<Dialect>().ok());
    let mut arm_limits = ArmLimits::of(dialect.unwrap_or(Dialect::SPECIFICATION));
    if !arguments.iter().any(|argument| argument == "link") {
        arm_limits.link = LinkRate { period_s: 0.0 };
    }
    let mut settings = Settings {
        arm_limits,
        ..Settings::default()
    };
    settings.placement.size = Size::Fit;
    let anywhere = |_| Ok::<(), String>(());
    let plan = prepare(
        &Source::of_file(file, fs::read(file)?)?,
        &settings,
        anywhere,
    )?
    .plan;
    println!("{}", json(&plan));
    Ok(())
}

fn json(plan: &Plan) -> String {
    let peaks = [0.08, 0.02].map(|apart_s| acceleration(plan, apart_s));
    let mut text = format!(
        r#"{{"vectors":{},"time_s":{},"peak_80_ms":{},"peak_20_ms":{},"period_s":{},"chains":["#,
        plan.moves.len(),
        plan.duration_s(),
        peaks[0],
        peaks[1],
        plan.arm_limits().link.period_s,
    );
    let ends = plan
        .moves
        .iter()
        .zip(plan.positions())
        .zip(plan.durations());
    let mut from = plan.start;
    let mut moves = false;
    for ((vector, to), duration_s) in ends {
        if !moves {
            let [x, y, z] = from;
            let separator = if text.ends_with('[') { "" } else { "," };
            let limit = if vector.kind == MoveKind::Travel {
                80
            } else {
                40
            };
            let _ = write!(
                text,
                r#"{separator}{{"limit":{limit},"points":[[{x},{y},{z},0,0]"#
            );
        }
        let [x, y, z] = to;
        let speed = vector.end_speed_mm_s;
        let _ = write!(text, ",[{x},{y},{z},{speed},{duration_s}]");
        moves = speed > 0.0;
        if !moves {
            text += "]}";
        }
        from = to;
    }
    text + "]}"
}
