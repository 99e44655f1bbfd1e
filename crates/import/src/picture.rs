//! Pictures as lines or dots.
//!
//! ```text
//!   file -> grey pixels -> tones on a grid -> full range -> outline, lines, stipple or hatch
//!           (decode, exif)  (resample, tone)   (levels)      (contour)(waves)          (rows)
//! ```

mod cancellable;
mod contour;
mod decode;
mod deep;
mod exif;
mod flow;
mod frames;
mod hatch;
mod levels;
mod others;
mod outline;
mod resample;
mod rows;
pub(crate) mod shading;
mod smooth;
mod spiral;
mod stipple;
mod tone;
mod waves;

pub(super) use self::decode::format;
use self::decode::{Header, header, pixels};
pub use self::shading::{Shading, ShadingStyle};
use self::tone::{Tone, count};
use crate::artwork::{Artwork, Layer};
use crate::error::{ImageError, SourceError};
use crate::options::ReadOptions;
use crate::warning::Warning;
use dobot_geometry::{CancelToken, Point, Stroke};
pub(super) use image::ImageFormat;

/// Reads a picture as lines or dots on its page: 96 pixels per inch, or the resolution in a PNG
/// file.
///
/// The spacing applies on the paper, so that the strokes depend on `options.scale`.
///
/// # Errors
///
/// [`SourceError::Picture`] if the file is damaged or has too many pixels (over 100 million, or 60
/// million of a progressive JPEG in colour, 25 million of a GIF, WebP, BMP or TIFF, 13 million of a
/// lossy WebP), a setting of the shading is out of range, or the spacing is too fine for the size;
/// [`SourceError::NothingToDraw`] if it leaves no ink.
pub(crate) fn read(
    bytes: &[u8],
    options: &ReadOptions,
) -> Result<(Artwork, Vec<Warning>), SourceError> {
    let shading = &options.shading;
    shading.check()?;
    let spacing_mm = shading.spacing_mm / options.scale;
    let page = header(bytes, &options.cancel);
    options.cancel.check()?;
    check_size(page?.page(), shading.spacing_mm, options.scale)?;
    let (header, tone) = toned(bytes, options, spacing_mm)?;
    let strokes = strokes(&tone, shading, spacing_mm, &options.cancel);
    // What a cancelled step returned is not a drawing.
    options.cancel.check()?;
    if strokes.is_empty() {
        let reason = if shading.style == ShadingStyle::Outline {
            "the picture has no borders between tones, or the enclosed areas are smaller than the spacing"
        } else {
            "the picture has only one light tone, or its dark parts are smaller than the spacing"
        };
        return Err(SourceError::nothing_to_draw([reason.to_owned()]));
    }
    let page = tone.page();
    let artwork = Artwork {
        width_mm: page.x,
        height_mm: page.y,
        has_page: true,
        is_exact: false,
        layers: vec![Layer {
            strokes,
            ..Layer::default()
        }],
    };
    Ok((artwork, warnings(header)))
}

/// Returns width and height of the page in millimetres, without reading the pixels.
///
/// # Errors
///
/// Those of [`read`].
pub(super) fn page(bytes: &[u8]) -> Result<Point, SourceError> {
    Ok(header(bytes, &CancelToken::default())?.page())
}

/// The grid of tones, as fine as the spacing needs, whatever the size of the file.
fn toned(
    bytes: &[u8],
    options: &ReadOptions,
    spacing_mm: f64,
) -> Result<(Header, Tone), SourceError> {
    let (shading, cancel) = (&options.shading, &options.cancel);
    let paper = if shading.invert { 0 } else { 255 };
    let pixels = pixels(bytes, paper, cancel);
    cancel.check()?;
    let (header, grey) = pixels?;
    let page = header.stored_page();
    let cells = |mm: f64| tone::cell((CELLS * mm / spacing_mm).ceil(), MAX_CELLS).max(2);
    let tone = resample::resample(
        &grey,
        [header.width, header.height],
        [cells(page.x), cells(page.y)],
        page,
    );
    cancel.check()?;
    let tone = tone.oriented(header.orientation);
    Ok((header, levels::levelled(&tone, shading, spacing_mm, cancel)))
}

fn strokes(tone: &Tone, shading: &Shading, spacing_mm: f64, cancel: &CancelToken) -> Vec<Stroke> {
    match shading.style {
        ShadingStyle::Outline => outline::outlines(tone, shading, spacing_mm, cancel),
        ShadingStyle::Lines => waves::waves(tone, shading, spacing_mm, cancel),
        ShadingStyle::Spiral => spiral::spiral(tone, spacing_mm, cancel),
        ShadingStyle::Flow => flow::flowing(tone, shading, spacing_mm, cancel),
        ShadingStyle::Stipple | ShadingStyle::Tsp => {
            stipple::stippled(tone, shading, spacing_mm, cancel)
        }
        ShadingStyle::Hatch => hatch::hatched(tone, shading, spacing_mm, cancel),
    }
}

fn check_size(page: Point, spacing_mm: f64, scale: f64) -> Result<(), ImageError> {
    let [width_mm, height_mm] = [page.x, page.y].map(|mm| mm * scale);
    let least_mm = (width_mm * height_mm / MAX_SPACINGS)
        .sqrt()
        .max(width_mm.max(height_mm) * CELLS / count(MAX_CELLS));
    if spacing_mm >= least_mm {
        return Ok(());
    }
    Err(ImageError::TooFine {
        spacing_mm,
        least_mm,
        width_mm,
        height_mm,
    })
}

fn warnings(header: Header) -> Vec<Warning> {
    let instead = "only the first page is drawn";
    let further = header.series.map(|what| Warning::new(what, instead, 1));
    further.into_iter().collect()
}

/// Grid cells per spacing.
const CELLS: f64 = 4.0;
/// The largest number of cells along a side of the page.
const MAX_CELLS: usize = 100_000;
/// The largest number of square spacings on a page: 8 million cells.
const MAX_SPACINGS: f64 = 500_000.0;

#[cfg(test)]
mod tests;
