//! `cargo run -p dobot-examples --example benchmark_drawings -- target/drawings`
//!
//! Writes the drawings used for the numbers of docs/performance.md, each in file order and in
//! shuffled order. The result is the same every time.

use std::error::Error;
use std::fs;
use std::path::PathBuf;

mod drawings;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args().nth(1);
    let folder = PathBuf::from(folder.unwrap_or_else(|| "target/drawings".to_owned()));
    fs::create_dir_all(&folder)?;
    for drawing in drawings::ALL {
        let file = folder.join(drawing.name).with_extension("svg");
        fs::write(&file, drawing.svg())?;
        println!("{}", file.display());
    }
    Ok(())
}
