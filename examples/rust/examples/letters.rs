//! `cargo run -p dobot-examples --example letters -- "Grüße, Zoë!" target/letters.svg`
//!
//! Writes a text in every single-line font, as an SVG file. Moves nothing.

use std::error::Error;
use std::fmt::Write as _;
use std::fs;

use dobot_import::{Font, ReadOptions, Source, StrokeFont, Text};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let (Some(words), Some(file)) = (arguments.next(), arguments.next()) else {
        return Err("usage: letters TEXT OUT.svg".into());
    };
    let mut lines = String::new();
    let (mut width_mm, mut y_mm) = (0.0_f64, 0.0);
    for font in StrokeFont::ALL {
        let text = Text {
            font: Font::Stroke(font),
            ..Text::new(&words)
        };
        let (artwork, warnings) = Source::Text(text).read(&ReadOptions::default())?;
        for stroke in artwork.layers.iter().flat_map(|layer| &layer.strokes) {
            lines += "<path d=\"M";
            for p in &stroke.points {
                write!(lines, "{:.3} {:.3} ", p.x, y_mm + p.y)?;
            }
            lines += "\"/>\n";
        }
        for warning in warnings {
            println!("{warning}");
        }
        width_mm = width_mm.max(artwork.width_mm);
        y_mm += artwork.height_mm + 5.0;
    }
    let svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width_mm:.1}mm\" height=\"{y_mm:.1}mm\" \
         viewBox=\"-1 -1 {:.1} {y_mm:.1}\" fill=\"none\" stroke=\"black\" stroke-width=\"0.4\" \
         stroke-linecap=\"round\" stroke-linejoin=\"round\">\n{lines}</svg>\n",
        width_mm + 2.0
    );
    fs::write(file, svg)?;
    Ok(())
}
