//! The reader of GIF, WebP, BMP and TIFF files in a build without the feature `full`.

use dobot_geometry::CancelToken;

use super::decode::Header;
use super::format::PictureFormat;
use crate::error::ImageError;

/// Refuses the picture.
pub(super) fn header(
    _bytes: &[u8],
    format: PictureFormat,
    _cancel: &CancelToken,
) -> Result<Header, ImageError> {
    Err(not_built(format))
}

/// Refuses the picture.
pub(super) fn pixels(
    _bytes: &[u8],
    format: PictureFormat,
    _paper: u8,
    _cancel: &CancelToken,
) -> Result<(Header, Vec<u8>), ImageError> {
    Err(not_built(format))
}

fn not_built(format: PictureFormat) -> ImageError {
    let format = format.name();
    ImageError::NotBuilt { format }
}
