//! The HP-GL and HP-GL/2 reader (the language of pen plotters; 40 units per millimetre).

mod characters;
mod command;
mod encoded;
mod label;
mod line_type;
mod plotter;
mod polygon;
mod shapes;
mod tick;
mod transform;
mod units;
mod window;

use self::command::commands;
use self::plotter::Plotter;
use crate::artwork::Artwork;
use crate::error::SourceError;
use crate::options::ReadOptions;
use crate::sketch::{REST_LEFT_OUT, Sketch, Y};
use crate::warning::Warning;

/// Reads a plot: each pen is a layer, filled rectangles, wedges and polygons are areas. The page is
/// as large as the ink and upright (Y points up).
pub(crate) fn read(
    text: &[u8],
    options: &ReadOptions,
) -> Result<(Artwork, Vec<Warning>), SourceError> {
    let mut plotter = Plotter::new(Sketch::new(text, options)?);
    let read = commands(text).try_for_each(|command| {
        options.cancel.check()?;
        plotter.handle(&command?)
    });
    let mut sketch = match &read {
        Ok(()) => plotter.finish()?,
        Err(_) => plotter.finish_early()?,
    };
    sketch.skip_mistake(read, REST_LEFT_OUT)?;
    sketch.finish(Y::Up, "no command draws with a pen down")
}

/// A plotter's escape sequence, or a command with which plots start, without other letters after
/// it.
pub(crate) fn is_likely(start: &str) -> bool {
    let start = start.trim_start_matches(';');
    let name = start.get(..2).unwrap_or_default().to_ascii_uppercase();
    let next = start.get(2..).unwrap_or_default();
    let is_first = [
        "BP", "DF", "IN", "IP", "PA", "PD", "PR", "PU", "RO", "SC", "SP", "VS",
    ]
    .contains(&name.as_str());
    let is_word = next.starts_with(|c: char| c.is_ascii_lowercase())
        && !start.starts_with(|c: char| c.is_ascii_lowercase());
    start.starts_with('\u{1b}') || (is_first && !is_word)
}

#[cfg(test)]
mod tests;
