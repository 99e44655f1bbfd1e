//! Pictures as lines or dots: decoding to grey pixels, for dobot-shading.

mod cancellable;
mod decode;
mod deep;
mod exif;
mod format;
#[cfg(not(any(feature = "full", test)))]
mod not_built;
#[cfg(any(feature = "full", test))]
mod others;
#[cfg(any(feature = "full", test))]
mod series;

use self::decode::{Header, header, pixels};
pub(super) use self::format::{PictureFormat, format};
#[cfg(not(any(feature = "full", test)))]
use self::not_built as others;
use crate::artwork::{Artwork, Layer};
use crate::error::{ImageError, SourceError};
use crate::options::ReadOptions;
use crate::warning::Warning;
use dobot_geometry::{CancelToken, Point};
use dobot_shading::ShadingStyle;

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
    let (shading, cancel) = (&options.shading, &options.cancel);
    shading.check().map_err(ImageError::from)?;
    let header = header(bytes, cancel);
    cancel.check()?;
    shading
        .check_size(header?.page(), options.scale)
        .map_err(ImageError::from)?;
    let paper = if shading.invert { 0 } else { 255 };
    let pixels = pixels(bytes, paper, cancel);
    cancel.check()?;
    let (header, pixels) = pixels?;
    let strokes = shading.strokes(&header.picture(&pixels), options.scale, cancel)?;
    if strokes.is_empty() {
        let reason = if shading.style == ShadingStyle::Outline {
            "the picture has no borders between tones, or the enclosed areas are smaller than the spacing"
        } else {
            "the picture has only one light tone, or its dark parts are smaller than the spacing"
        };
        return Err(SourceError::nothing_to_draw([reason.to_owned()]));
    }
    let page = header.page();
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

fn warnings(header: Header) -> Vec<Warning> {
    let instead = "only the first page is drawn";
    let further = header.series.map(|what| Warning::new(what, instead, 1));
    further.into_iter().collect()
}

#[cfg(test)]
mod tests;
