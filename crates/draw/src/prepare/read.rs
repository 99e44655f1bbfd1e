//! Sources as layers on the paper, read as finely as their size there needs.

use std::sync::Arc;

use dobot_geometry::{Point, Stroke};
use dobot_import::{Artwork, Layer, ReadOptions, Source, SourceError, Warning};

use super::{NamedSource, PrepareError, Settings};
use crate::layout::multi_file::together;
use crate::layout::place::Placed;

/// The layers on the paper, within the share of the tolerance that is for curves.
///
/// What a source becomes depends on its size there, which depends on all of them: they are read, placed, and
/// where that turned out otherwise than was thought, read again.
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
    let begin = |it| Reading::begin(it, settings).map_err(|error| named(it, error));
    let mut readings: Vec<Reading> = sources.iter().map(begin).collect::<Result<_, _>>()?;
    let place = |readings: &mut [Reading], for_good| {
        let parts = readings.iter_mut().map(|it| it.part(for_good)).collect();
        settings.placement.place(together(parts, settings)?)
    };
    // What was read as it will be need not be kept for another time.
    let for_good = readings
        .iter()
        .all(|it| it.source.source.is_same_at_any_size());
    let mut placed = place(&mut readings, for_good)?;
    let most_reads = if for_good { 0 } else { MOST_READS };
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
    let warnings = readings.into_iter().flat_map(|it| {
        let file = (!is_alone).then(|| it.source.name.clone());
        let in_file = move |warning| Warning {
            file: file.clone(),
            ..warning
        };
        it.warnings.into_iter().map(in_file)
    });
    Ok((placed, warnings.collect()))
}

/// A source as it was read last.
struct Reading<'a> {
    source: &'a NamedSource,
    options: ReadOptions,
    /// Of a picture that was not read yet the corners of its page.
    artwork: Artwork,
    is_read: bool,
    warnings: Vec<Warning>,
}

impl<'a> Reading<'a> {
    /// Reads it at its own size; of a picture only how large its page is, because its lines depend on how large
    /// it becomes.
    fn begin(source: &'a NamedSource, settings: &Settings) -> Result<Self, SourceError> {
        let mut options = ReadOptions {
            tolerance_mm: settings.flatten_mm(),
            layers: settings.layers.unwrap_or_default(),
            shading: settings.shading,
            crops: settings.crops,
            hides: settings.hides,
            fills: settings.hatch.is_some(),
            burns: settings.tool.burns() || settings.tools.iter().any(|(_, it)| it.burns()),
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

    /// What it is on the page; `for_good` where it is not asked for again.
    fn part(&mut self, for_good: bool) -> (&'a Source, Artwork) {
        let artwork = if for_good {
            std::mem::take(&mut self.artwork)
        } else {
            self.artwork.clone()
        };
        (&self.source.source, artwork)
    }

    /// Reads it again where it was read for another size on the paper; tells whether it was.
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

/// Once for the page of a picture, and once more where its ink is much smaller.
const MOST_READS: u32 = 2;
/// Where a file has too many corners even like this, it would on the paper.
const COARSEST_MM: f64 = 100.0;
const COARSER: f64 = 30.0;
/// What is read so many times finer than it need be is read once more.
const MUCH: f64 = 4.0;
/// How much larger than its page says the ink of a picture may become for its lines to stay.
const SAME_SCALE: f64 = 0.05;
