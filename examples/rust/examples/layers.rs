//! `cargo run -p dobot-examples --example layers -- examples/drawings/sailing.svg`
//!
//! Reads a drawing and prints the contents of its layers. Moves nothing.

use std::error::Error;
use std::fs;

use dobot_import::{ReadOptions, Source};

fn main() -> Result<(), Box<dyn Error>> {
    let file = std::env::args().nth(1).ok_or("usage: layers FILE")?;
    let source = Source::of_file(&file, fs::read(&file)?)?;
    let (artwork, warnings) = source.read(&ReadOptions::default())?;
    println!("{:.1} x {:.1} mm", artwork.width_mm, artwork.height_mm);
    for layer in &artwork.layers {
        let segments: usize = layer
            .strokes
            .iter()
            .map(|stroke| stroke.points.len() - 1)
            .sum();
        println!(
            "{}: {} strokes of {segments} segments, {} areas",
            layer.name,
            layer.strokes.len(),
            layer.areas.len()
        );
    }
    for warning in warnings {
        println!("{warning}");
    }
    Ok(())
}
