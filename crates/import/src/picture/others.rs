//! GIF, WebP, BMP and TIFF files to grey pixels.

use super::cancellable::CancellableBytes;
use super::decode::{Header, PIXEL_MM, damaged, on_paper};
use super::deep::DeepPixels;
use super::format::PictureFormat;
use super::series::series;
use crate::error::ImageError;
use dobot_geometry::{CancelToken, Point};
use dobot_shading::Orientation;
use image::{DynamicImage, ImageDecoder, ImageFormat, ImageReader, Limits};

/// Reads the header only.
pub(super) fn header(
    bytes: &[u8],
    format: PictureFormat,
    cancel: &CancelToken,
) -> Result<Header, ImageError> {
    decoder(bytes, format, cancel).map(|decoder| decoder.1)
}

/// Reads header and pixels, 0 for black and 255 for white; transparent pixels become `paper`. Of an
/// animation the first picture is used.
pub(super) fn pixels(
    bytes: &[u8],
    format: PictureFormat,
    paper: u8,
    cancel: &CancelToken,
) -> Result<(Header, Vec<u8>), ImageError> {
    let (decoder, header) = decoder(bytes, format, cancel)?;
    let image = DynamicImage::from_decoder(decoder).map_err(|error| damaged(format, error))?;
    if let DynamicImage::ImageLuma16(_)
    | DynamicImage::ImageLumaA16(_)
    | DynamicImage::ImageRgb16(_)
    | DynamicImage::ImageRgba16(_) = image
    {
        let mut deep = DeepPixels::default();
        for pixel in image.into_luma_alpha16().pixels() {
            deep.add_transparent(pixel.0[0], pixel.0[1]);
        }
        return Ok((header, deep.shallow(paper)));
    }
    let image = image.into_luma_alpha8();
    let grey = image
        .pixels()
        .map(|pixel| on_paper(pixel.0[0], pixel.0[1], paper));
    Ok((header, grey.collect()))
}

fn decoder<'a>(
    bytes: &'a [u8],
    format: PictureFormat,
    cancel: &CancelToken,
) -> Result<(impl ImageDecoder + use<'a>, Header), ImageError> {
    let bad = |error| damaged(format, error);
    let mut limits = Limits::default();
    limits.max_alloc = Some(MAX_BYTES);
    let mut reader =
        ImageReader::with_format(CancellableBytes::new(bytes, cancel), in_library(format));
    reader.limits(limits);
    let mut decoder = reader.into_decoder().map_err(bad)?;
    let (width, height) = decoder.dimensions();
    let turned = decoder.orientation().map_err(bad)?;
    let header = Header {
        width: width as usize,
        height: height as usize,
        pixel: Point::new(PIXEL_MM, PIXEL_MM),
        orientation: Orientation::numbered(turned.to_exif().into()),
        series: series(bytes, format),
    };
    Ok((decoder, header.check(max_pixels(bytes, format))?))
}

fn max_pixels(bytes: &[u8], format: PictureFormat) -> usize {
    if format == PictureFormat::WebP && !is_lossless(bytes) {
        MAX_LOSSY_PIXELS
    } else {
        MAX_PIXELS
    }
}

/// Whether the first picture of a WebP file is lossless.
///
/// ```text
///   RIFF length WEBP   [VP8X length ...]   [other parts]   VP8L or "VP8 ", length, ...
/// ```
fn is_lossless(bytes: &[u8]) -> bool {
    let mut rest = bytes.get(12..).unwrap_or_default();
    while let Some((&[n, a, m, e, l0, l1, l2, l3], content)) = rest.split_first_chunk() {
        match &[n, a, m, e] {
            b"VP8L" => return true,
            b"VP8 " => return false,
            _ => {}
        }
        let length = u32::from_le_bytes([l0, l1, l2, l3]) as usize;
        // Parts have an even length.
        let length = length.saturating_add(length % 2);
        rest = content.get(length..).unwrap_or_default();
    }
    false
}

/// The name of a format in the library, which reads those of this module only.
fn in_library(format: PictureFormat) -> ImageFormat {
    match format {
        PictureFormat::Png => ImageFormat::Png,
        PictureFormat::Jpeg => ImageFormat::Jpeg,
        PictureFormat::Gif => ImageFormat::Gif,
        PictureFormat::WebP => ImageFormat::WebP,
        PictureFormat::Bmp => ImageFormat::Bmp,
        PictureFormat::Tiff => ImageFormat::Tiff,
    }
}

/// The largest number of pixels; these decoders return all pixels at once, in colour.
const MAX_PIXELS: usize = 25_000_000;
/// The largest number of pixels of a lossy WebP file: they are decoded without reading further bytes, so that this
/// cannot be cancelled, and noise takes almost half a second.
const MAX_LOSSY_PIXELS: usize = 13_000_000;
const MAX_BYTES: u64 = 128_000_000;
