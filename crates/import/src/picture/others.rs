//! GIF, WebP, BMP and TIFF files to grey pixels.

use std::io::Cursor;

use dobot_geometry::Point;
use image::{DynamicImage, ImageDecoder, ImageFormat, ImageReader, Limits};

use super::decode::{self, Header, PIXEL_MM, on_paper};
use super::deep::DeepPixels;
use super::exif::Orientation;
use super::frames::series;
use crate::error::ImageError;

/// Reads the header only.
pub(super) fn header(bytes: &[u8], format: ImageFormat) -> Result<Header, ImageError> {
    decoder(bytes, format).map(|decoder| decoder.1)
}

/// Reads header and pixels, 0 for black and 255 for white; transparent pixels become `paper`. Of an
/// animation the first picture is used.
pub(super) fn pixels(
    bytes: &[u8],
    format: ImageFormat,
    paper: u8,
) -> Result<(Header, Vec<u8>), ImageError> {
    let (decoder, header) = decoder(bytes, format)?;
    let image = DynamicImage::from_decoder(decoder).map_err(|error| damaged(format, &error))?;
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

fn decoder(
    bytes: &[u8],
    format: ImageFormat,
) -> Result<(impl ImageDecoder + '_, Header), ImageError> {
    let bad = |error| damaged(format, &error);
    let mut limits = Limits::default();
    limits.max_alloc = Some(MAX_BYTES);
    let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
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
    Ok((decoder, header.check(MAX_PIXELS)?))
}

fn damaged(format: ImageFormat, error: &image::ImageError) -> ImageError {
    let format = match format {
        ImageFormat::Gif => "GIF",
        ImageFormat::WebP => "WebP",
        ImageFormat::Bmp => "BMP",
        _ => "TIFF",
    };
    decode::damaged(format, error)
}

/// The largest number of pixels; these decoders return all pixels at once, in colour.
const MAX_PIXELS: usize = 25_000_000;
const MAX_BYTES: u64 = 128_000_000;
