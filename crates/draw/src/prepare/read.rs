//! Reading sources as layers on the paper, with the accuracy that their final size requires.

use std::sync::Arc;

use dobot_geometry::{Point, Rect, Stroke, bounds};
use dobot_import::{Artwork, Layer, ReadOptions, Source, SourceError, Warning};

use super::passes::counted;
use super::{NamedSource, PrepareError, Settings};
use crate::layout::multi_file::{combine, is_text, scales};
use crate::layout::place::{PlaceError, Placed, Placement, Size};

/// Reads the layers on the paper, within the share of the tolerance for curves.
///
/// The content depends on its size on the paper, which depends on all sources: they are read,
/// placed, and read again if the size differs from the assumption.
pub(super) fn read(
    sources: &[NamedSource],
    settings: &Settings,
) -> Result<(Placed, Vec<Warning>), PrepareError> {
    let is_alone = sources.len() == 1;
    let named = |named: &NamedSource, error: SourceError| match (is_alone, error) {
        (_, error) if error.is_cancelled() => PrepareError::Cancelled,
        (true, error) => PrepareError::Source(error),
        (false, error) => PrepareError::File {
            name: named.name.clone(),
            error,
        },
    };
    let begin = |source| Reading::begin(source, settings).map_err(|error| named(source, error));
    let mut readings: Vec<Reading> = sources.iter().map(begin).collect::<Result<_, _>>()?;
    // What is not read again need not be kept.
    let for_good = readings.iter().all(|reading| reading.artwork.is_exact);
    let mut page = PlacedPage::new(&mut readings, settings, for_good)?;
    let most_reads = if for_good { 0 } else { MAX_READS };
    for _ in 0..most_reads {
        let mut is_as_thought = true;
        for (reading, scale) in readings.iter_mut().zip(page.scales()) {
            let read = reading.read_for(scale, settings.flatten_mm());
            is_as_thought &= !read.map_err(|error| named(reading.source, error))?;
        }
        if is_as_thought {
            break;
        }
        page = PlacedPage::new(&mut readings, settings, false)?;
    }
    let scaled_down = page.scaled_down(sources, settings);
    let scale = page.scale(sources);
    let warnings = readings.into_iter().flat_map(|reading| {
        let file = (!is_alone).then(|| reading.source.name.clone());
        let in_file = move |warning| Warning {
            file: file.clone(),
            ..warning
        };
        reading.warnings.into_iter().map(in_file)
    });
    let placed = Placed {
        scale,
        ..page.placed
    };
    Ok((placed, warnings.chain(scaled_down).collect()))
}

/// All sources on the paper.
struct PlacedPage {
    /// The page; its scale is that of the page.
    placed: Placed,
    /// The scale of each source on the page.
    on_page: Vec<f64>,
}

impl PlacedPage {
    /// Places the sources. Texts that keep their height are smaller on a page that is enlarged,
    /// which changes the size of the page: this is repeated until both agree.
    fn new(
        readings: &mut [Reading],
        settings: &Settings,
        for_good: bool,
    ) -> Result<Self, PlaceError> {
        let sources: Vec<&Source> = readings
            .iter()
            .map(|reading| &reading.source.source)
            .collect();
        let inks: Vec<Rect> = readings
            .iter()
            .map(|reading| bounds(reading.artwork.points()))
            .collect();
        let has_text = sources.iter().any(|source| is_text(source));
        let keeps_height = has_text && settings.keeps_text_height;
        let mut page_scale = 1.0;
        for _ in 0..MAX_ROUNDS {
            let on_page = scales(&sources, &inks, settings, page_scale)?;
            let parts = readings.iter_mut().zip(&on_page).map(|(reading, scale)| {
                let (source, artwork) = reading.part(for_good);
                (source, artwork.scaled(*scale))
            });
            let placed = settings
                .placement
                .place(combine(parts.collect(), settings)?)?;
            if !keeps_height || (placed.scale / page_scale - 1.0).abs() < SAME_HEIGHT {
                return Ok(Self { placed, on_page });
            }
            page_scale = placed.scale;
            if sources.iter().all(|source| is_text(source)) || page_scale < SMALLEST_SCALE {
                break;
            }
        }
        Err(too_large(readings, settings)?)
    }

    /// Returns the scale of each source on the paper.
    fn scales(&self) -> impl Iterator<Item = f64> {
        self.on_page.iter().map(|scale| scale * self.placed.scale)
    }

    /// Returns the scale of the files, or that of the page if they differ.
    fn scale(&self, sources: &[NamedSource]) -> f64 {
        let is_file = |source: &NamedSource| !is_text(&source.source);
        let files = sources.iter().zip(self.scales());
        let mut files = files.filter(|file| is_file(file.0)).map(|file| file.1);
        let first = files.next();
        let common = first.filter(|first| files.all(|scale| scale == *first));
        common.unwrap_or(self.placed.scale)
    }

    /// Warns that the drawing is smaller than it should be.
    fn scaled_down(&self, sources: &[NamedSource], settings: &Settings) -> Option<Warning> {
        let is_smaller = settings.placement.size == Size::Within && self.placed.scale < 1.0;
        let percent = 100.0 * self.placed.scale;
        let mut instead =
            format!("scaled down to {percent:.1} % to fit; place.scale 1 keeps its size");
        if sources.iter().all(|source| is_text(&source.source)) {
            instead += ", and what.wrap breaks long lines";
        }
        counted(usize::from(is_smaller), "drawing", &instead)
    }
}

/// Returns the error for texts that do not fit with their height.
fn too_large(readings: &mut [Reading], settings: &Settings) -> Result<PlaceError, PlaceError> {
    let within = Placement {
        size: Size::Within,
        ..settings.placement
    };
    let mut found = [0.0, f64::INFINITY];
    let mut can_wrap = false;
    for reading in readings {
        if let Source::Text(text) = &reading.source.source {
            let mut scale = 1.0;
            // The gaps between copies keep their size, so the first result is not exact.
            for _ in 0..MAX_ROUNDS {
                let (source, artwork) = reading.part(false);
                let alone = combine(vec![(source, artwork.scaled(scale))], settings)?;
                let fitting = within.place(alone)?.scale;
                scale *= fitting;
                if fitting > 1.0 - SAME_HEIGHT {
                    break;
                }
            }
            found = [text.height_mm, found[1].min(scale * text.height_mm)];
            can_wrap |= text.wrap.is_none() && text.text.lines().any(has_words);
        }
    }
    let [height_mm, most_mm] = found;
    Ok(PlaceError::TextTooLarge {
        height_mm,
        // Rounded down, so that it fits.
        most_mm: (100.0 * most_mm).floor() / 100.0,
        can_wrap,
    })
}

/// Whether a line has more than one word.
fn has_words(line: &str) -> bool {
    line.split_whitespace().nth(1).is_some()
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
            gcode: settings.gcode,
            strict: settings.strict,
            hides: settings.hides,
            white_edges: settings.white_edges,
            fills: settings.hatch.is_some(),
            burns: settings.tool.burns() || settings.tools.iter().any(|(_, tool)| tool.burns()),
            fonts: Arc::clone(&settings.fonts),
            cancel: settings.cancel.clone(),
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
        if self.artwork.is_exact {
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
        is_exact: false,
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
/// The number of times that a page with texts of a fixed height is placed.
const MAX_ROUNDS: u32 = 100;
/// The accuracy of such a height.
const SAME_HEIGHT: f64 = 1e-6;
/// A page this small shows nothing but its texts.
const SMALLEST_SCALE: f64 = 1e-4;
/// The coarsest accuracy: a file with too many corners even then would have too many on the paper.
const COARSEST_MM: f64 = 100.0;
const COARSER: f64 = 30.0;
/// Content read with this many times the necessary accuracy is read again.
const MUCH: f64 = 4.0;
/// The scale difference up to which the lines of a picture are kept.
const SAME_SCALE: f64 = 0.05;
