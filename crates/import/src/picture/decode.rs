//! Pictures to grey pixels: PNG and JPEG here, the others in `others`.

use dobot_geometry::{CancelToken, Point};
use dobot_shading::{GreyPicture, Orientation};
use png::{BitDepth, ColorType, Limits, Transformations, Unit};
use zune_jpeg::JpegDecoder;
use zune_jpeg::zune_core::colorspace::ColorSpace;
use zune_jpeg::zune_core::options::DecoderOptions;

use super::cancellable::CancellableBytes;
use super::deep::DeepPixels;
use super::exif::orientation;
use super::format::{PictureFormat, format};
use super::others;
use crate::error::ImageError;

/// The header of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Header {
    pub(super) width: usize,
    pub(super) height: usize,
    /// A pixel's width and height, in millimetres.
    pub(super) pixel: Point,
    pub(super) orientation: Orientation,
    /// The kind of a file with further pictures; the first one is used.
    pub(super) series: Option<&'static str>,
}

impl Header {
    /// The picture of these pixels.
    pub(super) fn picture<'a>(&self, pixels: &'a [u8]) -> GreyPicture<'a> {
        GreyPicture {
            pixels,
            width: self.width,
            height: self.height,
            page: self.stored_page(),
            orientation: self.orientation,
        }
    }

    /// The stored rows and columns, in millimetres.
    #[expect(clippy::cast_precision_loss, reason = "at most 100 million")]
    fn stored_page(&self) -> Point {
        let [width, height] = [self.width, self.height].map(|pixels| pixels as f64);
        Point::new(width * self.pixel.x, height * self.pixel.y)
    }

    /// The page as displayed, in millimetres.
    pub(super) fn page(&self) -> Point {
        self.orientation.page(self.stored_page())
    }

    /// Refuses pictures without pixels and those with too many: not every decoder does.
    pub(super) fn check(self, most: usize) -> Result<Self, ImageError> {
        let (width, height) = (self.width, self.height);
        if width == 0 || height == 0 {
            return Err(ImageError::NoPixels { width, height });
        }
        if width.saturating_mul(height) <= most {
            return Ok(self);
        }
        Err(ImageError::TooManyPixels {
            width,
            height,
            limit: most / 1_000_000,
        })
    }
}

fn known_format(bytes: &[u8]) -> Result<PictureFormat, ImageError> {
    if bytes.is_empty() {
        return Err(ImageError::EmptyFile);
    }
    format(bytes).ok_or(ImageError::UnknownFormat)
}

/// Reads the header only. A cancelled one may be any error.
pub(super) fn header(bytes: &[u8], cancel: &CancelToken) -> Result<Header, ImageError> {
    match known_format(bytes)? {
        PictureFormat::Png => png(bytes, cancel).map(|png| png.header),
        PictureFormat::Jpeg => jpeg(bytes, cancel).map(|jpeg| jpeg.header),
        format => others::header(bytes, format, cancel),
    }
}

/// Reads header and pixels, 0 for black and 255 for white; transparent pixels become `paper`. A
/// cancelled picture may be any error.
pub(super) fn pixels(
    bytes: &[u8],
    paper: u8,
    cancel: &CancelToken,
) -> Result<(Header, Vec<u8>), ImageError> {
    match known_format(bytes)? {
        PictureFormat::Png => png_pixels(bytes, paper, cancel),
        PictureFormat::Jpeg => jpeg_pixels(bytes, cancel),
        format => others::pixels(bytes, format, paper, cancel),
    }
}

/// A PNG file after its header.
struct PngFile<'a> {
    reader: png::Reader<CancellableBytes<'a>>,
    header: Header,
}

fn png<'a>(bytes: &'a [u8], cancel: &CancelToken) -> Result<PngFile<'a>, ImageError> {
    let limits = Limits { bytes: PNG_BYTES };
    let mut decoder = png::Decoder::new_with_limits(CancellableBytes::new(bytes, cancel), limits);
    decoder.set_transformations(Transformations::EXPAND);
    let info = decoder.read_header_info().map_err(bad_png)?;
    let [width, height] = [info.width, info.height].map(|value| value as usize);
    let mut header = Header {
        width,
        height,
        pixel: Point::new(PIXEL_MM, PIXEL_MM),
        orientation: Orientation::default(),
        series: None,
    }
    .check(MAX_PIXELS)?;
    let reader = decoder.read_info().map_err(bad_png)?;
    let info = reader.info();
    header.series = info.is_animated().then_some(ANIMATION);
    if let Some(exif) = &info.exif_metadata {
        header.orientation = orientation(exif);
    }
    if let Some(dims) = info.pixel_dims
        && dims.unit == Unit::Meter
        && dims.xppu > 0
        && dims.yppu > 0
    {
        header.pixel = Point::new(1000.0 / f64::from(dims.xppu), 1000.0 / f64::from(dims.yppu));
    }
    Ok(PngFile { reader, header })
}

fn png_pixels(
    bytes: &[u8],
    paper: u8,
    cancel: &CancelToken,
) -> Result<(Header, Vec<u8>), ImageError> {
    let PngFile { mut reader, header } = png(bytes, cancel)?;
    let (color, depth) = reader.output_color_type();
    if depth == BitDepth::Sixteen {
        let mut deep = DeepPixels::default();
        rows(&mut reader, |row| add_deep(&mut deep, row, color))?;
        return complete(header, deep.shallow(paper));
    }
    let mut grey = Vec::with_capacity(header.width * header.height);
    rows(&mut reader, |row| {
        add_grey(&mut grey, row, color, paper);
    })?;
    complete(header, grey)
}

/// Reads all rows of a PNG file, one by one unless they are interlaced.
fn rows(
    reader: &mut png::Reader<CancellableBytes<'_>>,
    mut add: impl FnMut(&[u8]),
) -> Result<(), ImageError> {
    if reader.info().interlaced {
        let size = reader.output_buffer_size();
        let mut all = vec![0; size.ok_or_else(|| bad_png("too large"))?];
        reader.next_frame(&mut all).map_err(bad_png)?;
        add(&all);
        return Ok(());
    }
    while let Some(row) = reader.next_row().map_err(bad_png)? {
        add(row.data());
    }
    Ok(())
}

fn complete(header: Header, grey: Vec<u8>) -> Result<(Header, Vec<u8>), ImageError> {
    if grey.len() == header.width * header.height {
        return Ok((header, grey));
    }
    Err(bad_png("some pixels are missing"))
}

/// Adds pixels of a PNG file with 16 bits per value, the upper 8 first.
fn add_deep(deep: &mut DeepPixels, row: &[u8], color: ColorType) {
    let values: Vec<u16> = row
        .chunks_exact(2)
        .map(|pair| u16::from_be_bytes([pair[0], pair[1]]))
        .collect();
    match color {
        ColorType::Grayscale | ColorType::Indexed => values.iter().for_each(|&grey| deep.add(grey)),
        ColorType::GrayscaleAlpha => {
            for pixel in values.chunks_exact(2) {
                deep.add_transparent(pixel[0], pixel[1]);
            }
        }
        ColorType::Rgb => {
            for pixel in values.chunks_exact(3) {
                deep.add(deep_luma(pixel));
            }
        }
        ColorType::Rgba => {
            for pixel in values.chunks_exact(4) {
                deep.add_transparent(deep_luma(pixel), pixel[3]);
            }
        }
    }
}

/// Blends a transparent pixel with the paper.
pub(super) fn on_paper(grey: u8, alpha: u8, paper: u8) -> u8 {
    let [grey, alpha, paper] = [grey, alpha, paper].map(u32::from);
    byte((grey * alpha + paper * (255 - alpha) + 127) / 255)
}

fn add_grey(grey: &mut Vec<u8>, row: &[u8], color: ColorType, paper: u8) {
    let on_paper = |grey: u8, alpha: u8| on_paper(grey, alpha, paper);
    match color {
        ColorType::Grayscale | ColorType::Indexed => grey.extend_from_slice(row),
        ColorType::GrayscaleAlpha => {
            grey.extend(
                row.chunks_exact(2)
                    .map(|chunk| on_paper(chunk[0], chunk[1])),
            );
        }
        ColorType::Rgb => grey.extend(row.chunks_exact(3).map(luma)),
        ColorType::Rgba => {
            grey.extend(
                row.chunks_exact(4)
                    .map(|chunk| on_paper(luma(chunk), chunk[3])),
            );
        }
    }
}

/// A JPEG file after its header.
struct JpegFile<'a> {
    decoder: JpegDecoder<CancellableBytes<'a>>,
    header: Header,
}

fn jpeg<'a>(bytes: &'a [u8], cancel: &CancelToken) -> Result<JpegFile<'a>, ImageError> {
    let options = DecoderOptions::default()
        .set_strict_mode(true)
        .set_max_width(usize::from(u16::MAX))
        .set_max_height(usize::from(u16::MAX));
    let mut decoder = JpegDecoder::new_with_options(CancellableBytes::new(bytes, cancel), options);
    decoder.decode_headers().map_err(bad_jpeg)?;
    let (width, height) = decoder
        .dimensions()
        .ok_or_else(|| bad_jpeg("its size is missing"))?;
    let exif = decoder.exif().map_or(&[][..], Vec::as_slice);
    let header = Header {
        width,
        height,
        pixel: Point::new(PIXEL_MM, PIXEL_MM),
        orientation: orientation(exif),
        series: None,
    };
    let components = decoder.info().map_or(0, |info| info.components.into());
    let most = most_jpeg_pixels(bytes, components, gives_grey(&decoder));
    let header = header.check(most)?;
    Ok(JpegFile { decoder, header })
}

/// Whether the decoder gives grey pixels: the first component of the usual colour spaces is grey. Others are
/// converted.
fn gives_grey(decoder: &JpegDecoder<CancellableBytes<'_>>) -> bool {
    let space = decoder.input_colorspace();
    matches!(space, Some(ColorSpace::Luma | ColorSpace::YCbCr))
}

/// The largest number of pixels of a JPEG file. Unless one scan holds all components line by line, the decoder stores
/// two bytes for each component of a pixel.
fn most_jpeg_pixels(bytes: &[u8], components: usize, gives_grey: bool) -> usize {
    if has_single_scan(bytes) {
        return MAX_PIXELS;
    }
    let of_pixel = 2 * components + if gives_grey { 1 } else { 4 };
    MAX_PIXELS.min(MAX_STORED_BYTES / of_pixel)
}

/// Whether a JPEG file is sequential, with all components in its first scan.
///
/// ```text
///   FF D8   FF kind, length of the rest, ...   FF C0, length, depth, height, width, components   ...   FF DA, length, components
/// ```
fn has_single_scan(bytes: &[u8]) -> bool {
    let (mut at, mut components) = (2, None);
    while let Some(&[0xff, kind, high, low]) = bytes.get(at..at + 4) {
        match kind {
            0xc0 | 0xc1 => components = bytes.get(at + 9),
            0xda => return components.is_some() && bytes.get(at + 4) == components,
            _ => {}
        }
        at += 2 + usize::from(u16::from_be_bytes([high, low]));
    }
    false
}

fn jpeg_pixels(bytes: &[u8], cancel: &CancelToken) -> Result<(Header, Vec<u8>), ImageError> {
    let JpegFile {
        mut decoder,
        header,
    } = jpeg(bytes, cancel)?;
    let grey = gives_grey(&decoder);
    let color = if grey {
        ColorSpace::Luma
    } else {
        ColorSpace::RGB
    };
    decoder.set_options(decoder.options().jpeg_set_out_colorspace(color));
    let mut pixels = decoder.decode().map_err(bad_jpeg)?;
    if !grey {
        pixels = pixels.chunks_exact(3).map(luma).collect();
    }
    if pixels.len() == header.width * header.height {
        return Ok((header, pixels));
    }
    Err(bad_jpeg("some pixels are missing"))
}

/// The luma of a colour: red, green and blue weighted as in JPEG files.
fn luma(rgb: &[u8]) -> u8 {
    let [red, green, blue] = [rgb[0], rgb[1], rgb[2]].map(u32::from);
    byte((299 * red + 587 * green + 114 * blue + 500) / 1000)
}

/// The luma of a colour of 16 bits per value.
pub(super) fn deep_luma(rgb: &[u16]) -> u16 {
    let [red, green, blue] = [rgb[0], rgb[1], rgb[2]].map(u32::from);
    let luma = (299 * red + 587 * green + 114 * blue + 500) / 1000;
    u16::try_from(luma).expect("a mean of 16-bit values")
}

fn byte(value: u32) -> u8 {
    u8::try_from(value).expect("a mean of bytes")
}

fn bad_png(problem: impl ToString) -> ImageError {
    damaged(PictureFormat::Png, problem)
}

fn bad_jpeg(problem: impl ToString) -> ImageError {
    damaged(PictureFormat::Jpeg, problem)
}

#[expect(clippy::needless_pass_by_value, reason = "used with `map_err`")]
pub(super) fn damaged(format: PictureFormat, problem: impl ToString) -> ImageError {
    let problem = problem.to_string();
    let line = problem.lines().next().unwrap_or_default();
    let lower = line.to_ascii_lowercase();
    let problem = if CUT_OFF.iter().any(|words| lower.contains(words)) {
        "the file ends too soon"
    } else {
        line.trim_end_matches('.')
    };
    ImageError::Damaged {
        format: format.name(),
        problem: problem.to_owned(),
    }
}

/// Messages of the decoders and of `std::io` about a file that ends too soon.
const CUT_OFF: [&str; 4] = [
    "failed to fill whole buffer",
    "unexpected end",
    "unexpected eof",
    "exhausted",
];

/// The kind of a file whose further pictures are those of an animation.
pub(super) const ANIMATION: &str = "animation";
/// 96 per inch, as in browsers.
pub(super) const PIXEL_MM: f64 = 25.4 / 96.0;
const MAX_PIXELS: usize = 100_000_000;
/// The largest memory for a JPEG file that the decoder stores as a whole.
const MAX_STORED_BYTES: usize = 420_000_000;
/// The memory limit of the PNG decoder beside the pixels: a few rows, colour profiles, texts.
const PNG_BYTES: usize = 1 << 26;
