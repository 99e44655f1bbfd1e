//! Reading HP-GL and HP-GL/2, the language of pen plotters: 40 units are a millimetre.

mod characters;
mod command;
mod encoded;
mod label;
mod line_type;
mod names;
mod plotter;
mod polygon;
mod shapes;
mod transform;
mod units;
mod window;

use self::command::commands;
use self::plotter::Plotter;
use crate::artwork::Artwork;
use crate::error::SourceError;
use crate::options::ReadOptions;
use crate::sketch::{Sketch, Y};
use crate::warning::Warning;

/// Reads a plot: each pen is a layer, filled rectangles, wedges and polygons are areas. The page is
/// as large as the ink and upright (Y points up).
pub(crate) fn read(
    text: &[u8],
    options: &ReadOptions,
) -> Result<(Artwork, Vec<Warning>), SourceError> {
    let mut plotter = Plotter::new(Sketch::new(text, options)?);
    commands(text).try_for_each(|command| plotter.handle(&command?))?;
    plotter
        .finish()?
        .finish(Y::Up, "no command draws with a pen down")
}

#[cfg(test)]
mod tests;
