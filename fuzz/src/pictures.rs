use std::io::{Cursor, Write};

use dobot_import::{ReadOptions, Shading, ShadingStyle, Source};
use flate2::Compression;
use flate2::write::GzEncoder;
use image::{DynamicImage, GrayAlphaImage, GrayImage, ImageFormat, RgbImage, RgbaImage};

/// Pictures of every format, whole and damaged, packed with gzip too, in every style: an error, or ink on the
/// picture's page, but never a panic.
pub fn pictures(input: &[u8]) {
    let Some((&[format, how, width, height, damages], rest)) = input.split_first_chunk() else {
        return;
    };
    let (damages, pixels) = rest.split_at(rest.len().min(usize::from(damages % 8) * 3));
    let size = [1 + u16::from(width % 48), 1 + u16::from(height % 48)];
    let mut file = match format % 8 {
        0 => png(size, how, pixels),
        1 => jpeg(size, how, pixels),
        2 => other(ImageFormat::Gif, size, how, pixels),
        3 => other(ImageFormat::WebP, size, how, pixels),
        4 => other(ImageFormat::Bmp, size, how, pixels),
        5 => other(ImageFormat::Tiff, size, how, pixels),
        _ => pixels.to_vec(),
    };
    let is_packed = format >= 128;
    // Damage to a packed file is found by its check sum at the latest, that of what is in it is not.
    let is_packed_first = format >= 224;
    if is_packed_first {
        file = packed(&file);
    }
    for damage in damages.chunks_exact(3) {
        let place = usize::from(damage[0]) | usize::from(damage[1]) << 8;
        let place = place % file.len().max(1);
        if let Some(byte) = file.get_mut(place) {
            *byte = damage[2];
        }
    }
    if is_packed && !is_packed_first {
        file = packed(&file);
    }
    let style = [
        ShadingStyle::Outline,
        ShadingStyle::Lines,
        ShadingStyle::Stipple,
        ShadingStyle::Hatch,
    ][usize::from(how % 4)];
    let options = ReadOptions {
        shading: Shading {
            invert: how >= 128,
            ..Shading::new(style)
        },
        ..ReadOptions::default()
    };
    let source = if is_packed {
        match Source::of_file("-", file) {
            Ok(source) if !source.has_size() => source,
            _ => return,
        }
    } else {
        crate::file("png", file)
    };
    let page = source.picture_page();
    if let Ok((artwork, _)) = source.read(&options) {
        let page = page
            .expect("what can be read has a page")
            .expect("a picture has one");
        // Which of them is divided by what differs in the last digit.
        let near = |found: f64, expected: f64| (found - expected).abs() < 1e-9;
        assert!(near(artwork.width_mm, page.x) && near(artwork.height_mm, page.y));
        assert!(artwork.points().next().is_some());
        crate::lies_on(&artwork, [page.x, page.y]);
    }
}

/// A PNG file of any colour type whose pixels are those bytes, again and again.
fn png(size: [u16; 2], how: u8, pixels: &[u8]) -> Vec<u8> {
    let colors = [
        (png::ColorType::Grayscale, 1),
        (png::ColorType::Rgb, 3),
        (png::ColorType::GrayscaleAlpha, 2),
        (png::ColorType::Rgba, 4),
    ];
    let (color, samples) = colors[usize::from(how / 4 % 4)];
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, size[0].into(), size[1].into());
    encoder.set_color(color);
    let count = usize::from(size[0]) * usize::from(size[1]) * samples;
    let mut writer = encoder.write_header().expect("memory takes it");
    let written = writer.write_image_data(&again(pixels, count));
    written.expect("so many bytes were announced");
    writer.finish().expect("memory takes it");
    file
}

fn jpeg(size: [u16; 2], how: u8, pixels: &[u8]) -> Vec<u8> {
    let (color, samples) = match how / 4 % 2 {
        0 => (jpeg_encoder::ColorType::Luma, 1),
        _ => (jpeg_encoder::ColorType::Rgb, 3),
    };
    let count = usize::from(size[0]) * usize::from(size[1]) * samples;
    let mut file = Vec::new();
    let mut encoder = jpeg_encoder::Encoder::new(&mut file, 80);
    encoder.set_progressive(how / 8 % 2 == 1);
    let encoded = encoder.encode(&again(pixels, count), size[0], size[1], color);
    encoded.expect("so many bytes were announced");
    file
}

/// A file of one of the formats that the `image` crate writes and reads.
fn other(format: ImageFormat, size: [u16; 2], how: u8, pixels: &[u8]) -> Vec<u8> {
    let [width, height] = size.map(u32::from);
    let samples = |of_pixel: usize| {
        again(
            pixels,
            usize::from(size[0]) * usize::from(size[1]) * of_pixel,
        )
    };
    let picture = match how / 4 % 4 {
        0 => GrayImage::from_raw(width, height, samples(1)).map(DynamicImage::from),
        1 => RgbImage::from_raw(width, height, samples(3)).map(DynamicImage::from),
        2 => GrayAlphaImage::from_raw(width, height, samples(2)).map(DynamicImage::from),
        _ => RgbaImage::from_raw(width, height, samples(4)).map(DynamicImage::from),
    };
    let picture = picture.expect("there are as many samples as pixels need");
    // GIF files have these pixels only.
    let picture = match format {
        ImageFormat::Gif => DynamicImage::from(picture.into_rgba8()),
        _ => picture,
    };
    let mut file = Cursor::new(Vec::new());
    match picture.write_to(&mut file, format) {
        Ok(()) => file.into_inner(),
        // Not every format has every kind of pixel.
        Err(_) => pixels.to_vec(),
    }
}

/// Packed with gzip.
fn packed(file: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::fast());
    encoder.write_all(file).expect("memory takes it");
    encoder.finish().expect("memory takes it")
}

fn again(bytes: &[u8], count: usize) -> Vec<u8> {
    let bytes = if bytes.is_empty() { &[0] } else { bytes };
    bytes.iter().copied().cycle().take(count).collect()
}
