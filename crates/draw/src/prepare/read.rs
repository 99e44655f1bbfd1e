//! A source as layers on the paper, read as finely as its size there needs.

use std::sync::Arc;

use dobot_geometry::{Point, Stroke};
use dobot_source::{Artwork, Layer, ReadOptions, Source, SourceError, Warning};

use super::{PrepareError, Settings};
use crate::place::Placed;

/// The layers on the paper, within the share of the tolerance that is for curves.
pub(super) fn read(
    source: &Source,
    settings: &Settings,
) -> Result<(Placed, Vec<Warning>), PrepareError> {
    let mut options = ReadOptions {
        tolerance_mm: settings.flatten_mm(),
        layers: settings.layers.unwrap_or_default(),
        shading: settings.shading,
        crops: settings.crops,
        hides: settings.hides,
        fills: settings.hatch.is_some(),
        fonts: Arc::clone(&settings.fonts),
        ..ReadOptions::default()
    };
    if let Some(page) = source.picture_page()? {
        return read_picture(source, settings, options, page);
    }
    let (artwork, warnings) = read_coarsely(source, &mut options)?;
    let placed = settings.placement.place(artwork)?;
    // What counts is the size on the paper, which is known only now.
    let tolerance_mm = (settings.flatten_mm() / placed.scale).max(1e-6);
    if (options.tolerance_mm..options.tolerance_mm * MUCH).contains(&tolerance_mm) {
        return Ok((placed, warnings));
    }
    options.scale = placed.scale;
    options.tolerance_mm = tolerance_mm;
    let (artwork, warnings) = source.read(&options)?;
    Ok((settings.placement.place(artwork)?, warnings))
}

/// Reads a source as finely as its own size allows: a town in metres has too many corners for that, but
/// not as a drawing on the paper.
fn read_coarsely(
    source: &Source,
    options: &mut ReadOptions,
) -> Result<(Artwork, Vec<Warning>), SourceError> {
    loop {
        match source.read(options) {
            Err(error) if error.is_too_fine() && options.tolerance_mm < COARSEST_MM => {
                options.tolerance_mm *= COARSER;
            }
            read => return read,
        }
    }
}

/// The lines of a picture depend on how large it becomes. Its page tells that, but what counts is
/// the ink: where that is much smaller, it is read once more.
fn read_picture(
    source: &Source,
    settings: &Settings,
    mut options: ReadOptions,
    page: Point,
) -> Result<(Placed, Vec<Warning>), PrepareError> {
    let corners = Layer {
        strokes: vec![Stroke::open(vec![Point::default(), page])],
        ..Layer::default()
    };
    let sheet = Artwork {
        width_mm: page.x,
        height_mm: page.y,
        layers: vec![corners],
    };
    options.scale = settings.placement.place(sheet)?.scale;
    let (artwork, warnings) = source.read(&options)?;
    let placed = settings.placement.place(artwork)?;
    if (placed.scale / options.scale - 1.0).abs() < SAME_SCALE {
        return Ok((placed, warnings));
    }
    options.scale = placed.scale;
    let (artwork, warnings) = source.read(&options)?;
    Ok((settings.placement.place(artwork)?, warnings))
}

/// Where a file has too many corners even like this, it would on the paper.
const COARSEST_MM: f64 = 100.0;
const COARSER: f64 = 30.0;
/// What is read so many times finer than it need be is read once more.
const MUCH: f64 = 4.0;
/// How much larger than its page says the ink of a picture may become for its lines to stay.
const SAME_SCALE: f64 = 0.05;
