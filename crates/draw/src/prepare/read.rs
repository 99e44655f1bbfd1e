//! Reading sources as layers on the paper, with the accuracy that their final size requires.

use std::sync::Arc;

use dobot_geometry::{Point, Stroke};
use dobot_import::{Artwork, Layer, ReadOptions, Source, SourceError, Warning};

use super::{NamedSource, PrepareError, Settings};
use crate::layout::multi_file::combine;
use crate::layout::place::Placed;

/// Reads the layers on the paper, within the share of the tolerance for curves.
///
/// The content depends on its size on the paper, which depends on all sources: they are read,
/// placed, and read again if the size differs from the assumption.
pub(super) fn read(
    sources: &[NamedSource],
    settings: &Settings,
) -> Result<(Placed, Vec<Warning>), PrepareError> {
    let is_alone = sources.len() == 1;
    let named = |named: &NamedSource, error| match (is_alone, error) {
        (true, error) => PrepareError::Source(error),
        (false, error) => PrepareError::File {
            name: named.name.clone(),
            error,
        },
    };
    let begin = |source| Reading::begin(source, settings).map_err(|error| named(source, error));
    let mut readings: Vec<Reading> = sources.iter().map(begin).collect::<Result<_, _>>()?;
    let place = |readings: &mut [Reading], for_good| {
        let parts = readings
            .iter_mut()
            .map(|reading| reading.part(for_good))
            .collect();
        settings.placement.place(combine(parts, settings)?)
    };
    // Sources in their final size need not be kept.
    let for_good = readings
        .iter()
        .all(|reading| reading.source.source.is_same_at_any_size());
    let mut placed = place(&mut readings, for_good)?;
    let most_reads = if for_good { 0 } else { MAX_READS };
    for _ in 0..most_reads {
        let mut is_as_thought = true;
        for reading in &mut readings {
            let read = reading.read_for(placed.scale, settings.flatten_mm());
            is_as_thought &= !read.map_err(|error| named(reading.source, error))?;
        }
        if is_as_thought {
            break;
        }
        placed = place(&mut readings, false)?;
    }
    let warnings = readings.into_iter().flat_map(|reading| {
        let file = (!is_alone).then(|| reading.source.name.clone());
        let in_file = move |warning| Warning {
            file: file.clone(),
            ..warning
        };
        reading.warnings.into_iter().map(in_file)
    });
    Ok((placed, warnings.collect()))
}

/// The last reading of a source.
struct Reading<'a> {
    source: &'a NamedSource,
    options: ReadOptions,
    /// The corners of the page for a picture that was not read yet.
    artwork: Artwork,
    is_read: bool,
    warnings: Vec<Warning>,
}

impl<'a> Reading<'a> {
    /// Reads the source at its own size, but only the page size of a picture, because its lines
    /// depend on the final size.
    fn begin(source: &'a NamedSource, settings: &Settings) -> Result<Self, SourceError> {
        let mut options = ReadOptions {
            tolerance_mm: settings.flatten_mm(),
            layers: settings.layers.unwrap_or_default(),
            shading: settings.shading,
            crops: settings.crops,
            hides: settings.hides,
            white_edges: settings.white_edges,
            fills: settings.hatch.is_some(),
            burns: settings.tool.burns() || settings.tools.iter().any(|(_, tool)| tool.burns()),
            fonts: Arc::clone(&settings.fonts),
            ..ReadOptions::default()
        };
        let page = source.source.picture_page()?;
        let (artwork, warnings) = match page {
            Some(page) => (corners(page), Vec::new()),
            None => read_coarsely(&source.source, &mut options)?,
        };
        Ok(Self {
            source,
            options,
            artwork,
            is_read: page.is_none(),
            warnings,
        })
    }

    /// Returns the artwork on the page; with `for_good` it is not needed again.
    fn part(&mut self, for_good: bool) -> (&'a Source, Artwork) {
        let artwork = if for_good {
            std::mem::take(&mut self.artwork)
        } else {
            self.artwork.clone()
        };
        (&self.source.source, artwork)
    }

    /// Reads the source again if it was read for a different size; returns whether it was.
    fn read_for(&mut self, scale: f64, flatten_mm: f64) -> Result<bool, SourceError> {
        if self.source.source.is_same_at_any_size() {
            return Ok(false);
        }
        if self.source.source.has_size() {
            let tolerance_mm = (flatten_mm / scale).max(1e-6);
            let last_mm = self.options.tolerance_mm;
            if (last_mm..last_mm * MUCH).contains(&tolerance_mm) {
                return Ok(false);
            }
            self.options.tolerance_mm = tolerance_mm;
        } else if self.is_read && (scale / self.options.scale - 1.0).abs() < SAME_SCALE {
            return Ok(false);
        }
        self.options.scale = scale;
        (self.artwork, self.warnings) = self.source.source.read(&self.options)?;
        self.is_read = true;
        Ok(true)
    }
}

fn corners(page: Point) -> Artwork {
    let corners = Layer {
        strokes: vec![Stroke::open(vec![Point::default(), page])],
        ..Layer::default()
    };
    Artwork {
        width_mm: page.x,
        height_mm: page.y,
        has_page: true,
        layers: vec![corners],
    }
}

/// Reads a source with the accuracy of its own size: a town plan in metres would have too many
/// corners otherwise, but not as a drawing on the paper.
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

/// Once for the page of a picture, and once more if its ink is much smaller.
const MAX_READS: u32 = 2;
/// The coarsest accuracy: a file with too many corners even then would have too many on the paper.
const COARSEST_MM: f64 = 100.0;
const COARSER: f64 = 30.0;
/// Content read with this many times the necessary accuracy is read again.
const MUCH: f64 = 4.0;
/// The scale difference up to which the lines of a picture are kept.
const SAME_SCALE: f64 = 0.05;
