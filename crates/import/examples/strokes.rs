//! `cargo run -p dobot-import --example strokes -- examples/drawings/sailing.svg`
//!
//! Reads drawings and prints a line of JSON for each: its size in mm, its strokes without hidden
//! parts, and its warnings, or the error. `tests/icons` compares them with a browser's picture.

use std::error::Error;
use std::fs;

use dobot_import::{ReadOptions, Source};
use serde_json::{Value, json};

fn main() {
    for file in std::env::args().skip(1) {
        let line = read(&file).unwrap_or_else(|error| json!({ "error": error.to_string() }));
        println!("{line}");
    }
}

fn read(file: &str) -> Result<Value, Box<dyn Error>> {
    let options = ReadOptions {
        hides: true,
        ..ReadOptions::default()
    };
    let source = Source::of_file(file, fs::read(file)?)?;
    let (artwork, warnings) = source.read(&options)?;
    let strokes = artwork.layers.iter().flat_map(|layer| &layer.strokes);
    let strokes: Vec<Vec<[f64; 2]>> = strokes
        .map(|stroke| stroke.points.iter().map(|p| [p.x, p.y]).collect())
        .collect();
    let warnings: Vec<String> = warnings.iter().map(ToString::to_string).collect();
    Ok(json!({
        "size": [artwork.width_mm, artwork.height_mm],
        "strokes": strokes,
        "warnings": warnings,
    }))
}
