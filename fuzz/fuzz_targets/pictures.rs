//! PNG and JPEG pictures, whole and damaged, in every style: an error, or ink on the picture's page,
//! but never a panic.
#![no_main]

use dobot_source::{ReadOptions, Shading, ShadingStyle, Source};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|input: &[u8]| {
    let Some((&[how, width, height, damages], rest)) = input.split_first_chunk() else {
        return;
    };
    let (damages, pixels) = rest.split_at(rest.len().min(usize::from(damages % 8) * 3));
    let size = [1 + u16::from(width % 48), 1 + u16::from(height % 48)];
    let mut file = match how % 3 {
        0 => png(size, how, pixels),
        1 => jpeg(size, how, pixels),
        _ => pixels.to_vec(),
    };
    for damage in damages.chunks_exact(3) {
        let place = usize::from(damage[0]) | usize::from(damage[1]) << 8;
        let place = place % file.len().max(1);
        if let Some(byte) = file.get_mut(place) {
            *byte = damage[2];
        }
    }
    let style = [
        ShadingStyle::Outline,
        ShadingStyle::Lines,
        ShadingStyle::Stipple,
        ShadingStyle::Hatch,
    ][usize::from(how / 3 % 4)];
    let options = ReadOptions {
        shading: Shading {
            invert: how >= 128,
            ..Shading::new(style)
        },
        ..ReadOptions::default()
    };
    let source = Source::Picture(file);
    let page = source.picture_page();
    if let Ok((artwork, _)) = source.read(&options) {
        let page = page
            .expect("what can be read has a page")
            .expect("a picture has one");
        // Which of them is divided by what differs in the last digit.
        let near = |found: f64, expected: f64| (found - expected).abs() < 1e-9;
        assert!(near(artwork.width_mm, page.x) && near(artwork.height_mm, page.y));
        assert!(artwork.points().next().is_some());
        dobot_fuzz::lies_on(&artwork, [page.x, page.y]);
    }
});

/// A PNG file of any colour type whose pixels are those bytes, again and again.
fn png(size: [u16; 2], how: u8, pixels: &[u8]) -> Vec<u8> {
    let colors = [
        (png::ColorType::Grayscale, 1),
        (png::ColorType::Rgb, 3),
        (png::ColorType::GrayscaleAlpha, 2),
        (png::ColorType::Rgba, 4),
    ];
    let (color, samples) = colors[usize::from(how / 12 % 4)];
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
    let (color, samples) = match how / 12 % 2 {
        0 => (jpeg_encoder::ColorType::Luma, 1),
        _ => (jpeg_encoder::ColorType::Rgb, 3),
    };
    let count = usize::from(size[0]) * usize::from(size[1]) * samples;
    let mut file = Vec::new();
    let mut encoder = jpeg_encoder::Encoder::new(&mut file, 80);
    encoder.set_progressive(how / 24 % 2 == 1);
    let encoded = encoder.encode(&again(pixels, count), size[0], size[1], color);
    encoded.expect("so many bytes were announced");
    file
}

fn again(bytes: &[u8], count: usize) -> Vec<u8> {
    let bytes = if bytes.is_empty() { &[0] } else { bytes };
    bytes.iter().copied().cycle().take(count).collect()
}
