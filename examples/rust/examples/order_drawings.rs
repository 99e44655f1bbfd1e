//! `cargo run -p dobot-examples --example order_drawings -- length 1000 1 examples/drawings/harbour.svg`
//!
//! Orders the strokes of SVG files and prints, as a line of JSON for each, the pen's travel before
//! and after and the CPU time of the ordering. Arguments: the objective (`length` or `time`),
//! kicks, seed, files.

use std::error::Error;
use std::fs;
use std::time::Instant;

use dobot_draw::{Search, Travel, order};
use dobot_geometry::{Point, Stroke};
use dobot_import::{ReadOptions, Source};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let mut next = || {
        arguments
            .next()
            .ok_or("usage: order_drawings length|time KICKS SEED FILE.svg...")
    };
    let search = Search {
        travel: if next()? == "time" {
            Travel::Time {
                speed_mm_s: 100.0,
                acceleration_mm_s2: 100.0,
                least_s: 0.08,
            }
        } else {
            Travel::Length
        },
        kicks: next()?.parse()?,
        seed: next()?.parse()?,
    };
    for file in arguments {
        let begin = cpu_s();
        let (artwork, _) =
            Source::of_file(&file, fs::read(&file)?)?.read(&ReadOptions::default())?;
        let drawn = artwork.layers.into_iter().flat_map(|layer| layer.strokes);
        let drawn: Vec<Stroke> = drawn.collect();
        let read = cpu_s();
        let (strokes, given) = (drawn.len(), between(search.travel, &drawn));
        let ordering = cpu_s();
        let ordered = order(drawn, Point::default(), &search);
        let ordered_at = cpu_s();
        println!(
            r#"{{"file": "{file}", "strokes": {strokes}, "given": {given:.3}, "travel": {:.3}, "read_s": {:.4}, "order_s": {:.4}}}"#,
            between(search.travel, &ordered),
            read - begin,
            ordered_at - ordering
        );
    }
    Ok(())
}

/// Returns the cost of the travel between the strokes, without the travel to the first one.
fn between(travel: Travel, strokes: &[Stroke]) -> f64 {
    let way_mm = |pair: &[Stroke]| Some(pair[0].last()?.distance(*pair[1].points.first()?));
    let ways_mm = strokes.windows(2).filter_map(way_mm);
    ways_mm.fold(0.0, |sum, way_mm| sum + travel.cost(way_mm))
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
