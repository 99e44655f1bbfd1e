#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

use std::io::Cursor;

use dobot_geometry::{Point, Random, Stroke, bounds, bounds_of_strokes};
use dobot_shading::Shading;
use image::ImageFormat::{Bmp, Gif, Tiff, WebP};
use jpeg_encoder::{ColorType as JpegColor, Encoder as JpegEncoder};
use png::{BitDepth, ColorType};
use proptest::prelude::*;

use super::*;
use crate::Source;

/// A PNG file of grey pixels.
fn grey(width: u32, height: u32, grey: impl Fn(f64, f64) -> f64) -> Vec<u8> {
    let middle = |i: u32| f64::from(i) + 0.5;
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (middle(x), middle(y))));
    let pixels: Vec<u8> = places.map(|(x, y)| byte(grey(x, y))).collect();
    encoded(
        width,
        height,
        ColorType::Grayscale,
        BitDepth::Eight,
        &pixels,
    )
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "clamped"
)]
fn byte(value: f64) -> u8 {
    (value.clamp(0.0, 1.0) * 255.0).round() as u8
}

fn encoded(width: u32, height: u32, color: ColorType, depth: BitDepth, pixels: &[u8]) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, width, height);
    encoder.set_color(color);
    encoder.set_depth(depth);
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(pixels).unwrap();
    writer.finish().unwrap();
    file
}

fn jpeg(width: u16, height: u16, color: JpegColor, pixels: &[u8]) -> Vec<u8> {
    let mut file = Vec::new();
    let encoder = JpegEncoder::new(&mut file, 95);
    encoder.encode(pixels, width, height, color).unwrap();
    file
}

fn options(style: ShadingStyle) -> ReadOptions {
    ReadOptions {
        shading: Shading::new(style),
        ..ReadOptions::default()
    }
}

fn drawn(file: &[u8], options: &ReadOptions) -> Vec<Stroke> {
    let (mut artwork, warnings) = read(file, options).unwrap();
    assert_eq!(warnings, []);
    artwork.layers.remove(0).strokes
}

/// The grey pixels of a file, row by row.
fn seen(file: &[u8]) -> Vec<u8> {
    pixels(file, 255, &CancelToken::default()).unwrap().1
}

const PIXEL_MM: f64 = 25.4 / 96.0;
const STYLES: [ShadingStyle; 6] = [
    ShadingStyle::Spiral,
    ShadingStyle::Flow,
    ShadingStyle::Outline,
    ShadingStyle::Lines,
    ShadingStyle::Stipple,
    ShadingStyle::Hatch,
];

#[test]
fn an_inverted_picture_is_drawn_on_black_paper() {
    let white_disc = grey(120, 120, |x, y| 30.5 - (x - 60.0).hypot(y - 60.0));
    let mut options = options(ShadingStyle::Hatch);
    options.shading.invert = true;
    let strokes = drawn(&white_disc, &options);
    let bounds = bounds_of_strokes(&strokes);
    assert!(
        bounds.x0 > 27.5 * PIXEL_MM && bounds.x1 < 92.5 * PIXEL_MM,
        "{bounds:?}"
    );
}

#[test]
fn transparent_pixels_are_paper() {
    let pixels: Vec<u8> = (0..4000)
        .flat_map(|i| [0, if i % 80 < 40 { 255 } else { 0 }])
        .collect();
    let file = encoded(80, 50, ColorType::GrayscaleAlpha, BitDepth::Eight, &pixels);
    let strokes = drawn(&file, &options(ShadingStyle::Hatch));
    assert!(bounds_of_strokes(&strokes).x1 < 42.5 * PIXEL_MM);
    assert_eq!(
        self::pixels(&file, 0, &CancelToken::default()).unwrap().1[70],
        0
    );
}

#[test]
fn every_kind_of_png_is_read() {
    let eight = [0, 128, 255, 64];
    let plain = encoded(2, 2, ColorType::Grayscale, BitDepth::Eight, &eight);
    assert_eq!(seen(&plain), eight);
    let sixteen: Vec<u8> = eight.iter().flat_map(|&item| [item, item]).collect();
    let file = encoded(2, 2, ColorType::Grayscale, BitDepth::Sixteen, &sixteen);
    assert_eq!(seen(&file), eight);
    let colors = eight.map(|item| [item; 3]).concat();
    let file = encoded(2, 2, ColorType::Rgb, BitDepth::Eight, &colors);
    assert_eq!(seen(&file), eight);
    let bits = encoded(2, 2, ColorType::Grayscale, BitDepth::One, &[0x40, 0x80]);
    assert_eq!(seen(&bits), [0, 255, 255, 0]);
    assert_eq!(
        seen(INTERLACED),
        (0..64).map(|i| 4 * i).collect::<Vec<u8>>()
    );
}

#[test]
fn a_picture_of_16_bits_with_small_values_uses_the_full_range() {
    let wide = |values: &[u16]| -> Vec<u8> {
        values
            .iter()
            .flat_map(|value| value.to_be_bytes())
            .collect()
    };
    // 12 bits of a camera, and 4 bits.
    for white in [4095, 15] {
        let values = [0, white / 2, white, white / 4];
        let file = encoded(
            2,
            2,
            ColorType::Grayscale,
            BitDepth::Sixteen,
            &wide(&values),
        );
        let found = seen(&file);
        assert_eq!((found[0], found[2]), (0, 255));
        assert!(
            found[1].abs_diff(127) < 13 && found[3].abs_diff(63) < 13,
            "{found:?}"
        );
        let colors: Vec<u16> = values.iter().flat_map(|&value| [value; 3]).collect();
        let file = encoded(2, 2, ColorType::Rgb, BitDepth::Sixteen, &wide(&colors));
        assert_eq!(seen(&file), found);
        let clear: Vec<u16> = values.iter().flat_map(|&value| [value, 0]).collect();
        let file = encoded(
            2,
            2,
            ColorType::GrayscaleAlpha,
            BitDepth::Sixteen,
            &wide(&clear),
        );
        assert_eq!(seen(&file), [255; 4]);
        let pixels = image::ImageBuffer::<image::Luma<u16>, _>::from_vec(2, 2, values.to_vec());
        let mut tiff = Cursor::new(Vec::new());
        image::DynamicImage::from(pixels.unwrap())
            .write_to(&mut tiff, Tiff)
            .unwrap();
        assert_eq!(seen(&tiff.into_inner()), found);
    }
    // Values in the upper half are as bright as they say, and black stays black.
    let dark = wide(&[0, 0x4000, 0x7fff, 0]);
    let file = encoded(2, 2, ColorType::Grayscale, BitDepth::Sixteen, &dark);
    assert_eq!(seen(&file), [0, 64, 127, 0]);
    let black = encoded(1, 1, ColorType::Grayscale, BitDepth::Sixteen, &[0, 0]);
    assert_eq!(seen(&black), [0]);
}

#[test]
fn every_kind_of_jpeg_is_read() {
    let near = |file: &[u8], wanted: u8| {
        let seen = seen(file);
        assert_eq!(seen.len(), 256);
        assert!(
            seen.iter().all(|item| item.abs_diff(wanted) < 4),
            "{seen:?}, not {wanted}"
        );
    };
    near(&jpeg(16, 16, JpegColor::Luma, &[77; 256]), 77);
    // The luminance of ITU-R BT.601.
    let red = [255, 0, 0].repeat(256);
    near(&jpeg(16, 16, JpegColor::Rgb, &red), 76);
    // Half of the light is taken by black, all red by cyan.
    let cyan = [255, 0, 0, 128].repeat(256);
    for color in [JpegColor::Cmyk, JpegColor::CmykAsYcck] {
        near(&jpeg(16, 16, color, &cyan), 89);
    }
}

#[test]
fn a_photo_is_upright_for_every_orientation_of_the_camera() {
    // The upper half is black in the file; number 6: its left edge is the top of the photo.
    let pixels: Vec<u8> = (0..32 * 16)
        .map(|i| if i < 256 { 0 } else { 255 })
        .collect();
    let mut file = jpeg(32, 16, JpegColor::Luma, &pixels);
    let exif =
        b"\xff\xe1\0\x22Exif\0\0II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0\x06\0\0\0\0\0\0\0";
    file.splice(2..2, exif.iter().copied());
    let (artwork, _) = read(&file, &options(ShadingStyle::Hatch)).unwrap();
    assert!((artwork.width_mm - 16.0 * PIXEL_MM).abs() < 1e-9);
    assert!((artwork.height_mm - 32.0 * PIXEL_MM).abs() < 1e-9);
    // Turned clockwise, what was above is on the right.
    let bounds = bounds(artwork.points());
    assert!(
        bounds.x0 > 5.5 * PIXEL_MM && bounds.x1 > 15.0 * PIXEL_MM,
        "{bounds:?}"
    );
}

#[test]
fn a_png_with_a_physical_size_is_drawn_at_that_size() {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, 40, 20);
    encoder.set_color(ColorType::Grayscale);
    // 10 pixels to the millimetre.
    encoder.set_pixel_dims(Some(png::PixelDimensions {
        xppu: 10_000,
        yppu: 10_000,
        unit: png::Unit::Meter,
    }));
    encoder
        .write_header()
        .unwrap()
        .write_image_data(&[0; 800])
        .unwrap();
    let page = Source::of_file("-", file).unwrap().picture_page().unwrap();
    assert_eq!(page, Some(Point::new(4.0, 2.0)));
}

#[test]
fn a_truncated_file_is_refused() {
    let png = grey(300, 200, |x, _| x / 300.0);
    let jpeg = include_bytes!("../../../../examples/drawings/still-life.jpg");
    for file in [png.as_slice(), jpeg] {
        for part in [10, 40, 70, 95] {
            let error =
                read(&file[..file.len() * part / 100], &ReadOptions::default()).unwrap_err();
            assert!(
                matches!(error, SourceError::Picture(ImageError::Damaged { .. })),
                "{error}"
            );
            assert!(
                error
                    .to_string()
                    .ends_with("; save it again as PNG or JPEG"),
                "{error}"
            );
        }
    }
}

#[test]
fn pictures_of_other_formats_are_drawn_like_the_same_png() {
    // The left half black, the right one white and half of that transparent.
    let picture = image::RgbaImage::from_fn(64, 32, |x, _| match x {
        0..32 => image::Rgba([0, 0, 0, 255]),
        32..48 => image::Rgba([255; 4]),
        _ => image::Rgba([0; 4]),
    });
    let file = |format| {
        let mut bytes = Cursor::new(Vec::new());
        let picture = image::DynamicImage::from(picture.clone());
        picture.write_to(&mut bytes, format).unwrap();
        bytes.into_inner()
    };
    let options = ReadOptions {
        shading: Shading::new(ShadingStyle::Lines),
        ..ReadOptions::default()
    };
    let mut encoded = Vec::new();
    let mut encoder = png::Encoder::new(&mut encoded, 64, 32);
    encoder.set_color(png::ColorType::Rgba);
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(&picture).unwrap();
    drop(writer);
    let wanted = read(&encoded, &options).unwrap().0;
    assert!(!wanted.layers[0].strokes.is_empty());
    for format in [Bmp, Gif, Tiff, WebP] {
        let bytes = file(format);
        assert!(matches!(
            Source::of_file("-", bytes.clone()),
            Ok(Source::File { format, .. }) if format.is_picture()
        ));
        let (found, _) = read(&bytes, &options).unwrap();
        assert_eq!(found, wanted, "{format:?}");
        for cut in [bytes.len() / 2, 20, 12] {
            let error = read(&bytes[..cut], &options).unwrap_err().to_string();
            assert!(
                error.contains("picture: ") && !error.contains("buffer"),
                "{format:?}, {cut}: {error}"
            );
        }
    }
}

#[test]
fn a_file_that_is_not_a_picture_is_distinguished_from_a_damaged_one() {
    for name in ["a.jpg", "a.png"] {
        let message = |bytes: &[u8]| {
            let source = crate::Source::of_file(name, bytes.to_vec()).unwrap();
            source.picture_page().unwrap_err().to_string()
        };
        assert_eq!(
            message(b""),
            "the file is empty; a picture is a PNG, JPEG, GIF, WebP, BMP or TIFF file"
        );
        assert_eq!(
            message(b"FORM89a"),
            "the file is not a PNG, JPEG, GIF, WebP, BMP or TIFF file; save the picture as PNG or JPEG"
        );
        assert!(message(b"\xff\xd8\xff").starts_with("cannot read the JPEG picture: "));
    }
}

#[test]
fn gigapixels_are_refused_before_they_are_read() {
    let mut file = Vec::new();
    drop(
        png::Encoder::new(&mut file, 100_000, 50_000)
            .write_header()
            .unwrap(),
    );
    let error = read(&file, &ReadOptions::default()).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the picture has 100000 x 50000 pixels; allowed are 100 million; make it smaller"
    );
}

#[test]
fn a_picture_without_pixels_is_refused_with_its_size() {
    let message = |file: &[u8]| read(file, &ReadOptions::default()).unwrap_err().to_string();
    let needed = "allowed are 1 x 1 or more; save it again as PNG or JPEG";
    for size in [[0, 16], [16, 0], [0, 0]] {
        let [width, height] = size;
        assert_eq!(
            message(&sized(Gif, size)),
            format!("the picture has {width} x {height} pixels; {needed}")
        );
        for format in [Bmp, Tiff] {
            let message = message(&sized(format, size));
            assert!(
                message.starts_with("cannot read the ") || message.starts_with("the picture has "),
                "{format:?} {size:?}: {message}"
            );
        }
    }
}

#[test]
fn pictures_with_a_huge_size_in_the_header_are_refused() {
    let message = |format| {
        let file = sized(format, [u16::MAX, u16::MAX]);
        let error = read(&file, &ReadOptions::default()).unwrap_err();
        error.to_string()
    };
    let wanted = "the picture has 65535 x 65535 pixels; allowed are 25 million";
    for format in [Gif, Bmp] {
        assert!(message(format).starts_with(wanted), "{format:?}");
    }
    // Its parts have sizes too, which do not match.
    assert!(message(Tiff).starts_with("cannot read the TIFF picture: "));
}

#[test]
fn a_progressive_jpeg_in_colour_has_fewer_pixels_because_it_is_stored_as_a_whole() {
    for (color, samples, most) in [
        (JpegColor::Luma, 1, "100 million"),
        (JpegColor::Rgb, 3, "60 million"),
        (JpegColor::Cmyk, 4, "35 million"),
    ] {
        for is_progressive in [false, true] {
            let mut file = Vec::new();
            let mut encoder = JpegEncoder::new(&mut file, 50);
            encoder.set_progressive(is_progressive);
            encoder
                .encode(&vec![9; 256 * samples], 16, 16, color)
                .unwrap();
            let frame = if is_progressive { 0xc2 } else { 0xc0 };
            let at = file
                .windows(2)
                .position(|pair| pair == [0xff, frame])
                .unwrap();
            for place in [at + 5, at + 7] {
                file[place..place + 2].copy_from_slice(&20_000_u16.to_be_bytes());
            }
            let error = read(&file, &ReadOptions::default())
                .unwrap_err()
                .to_string();
            let most = if is_progressive { most } else { "100 million" };
            assert!(error.contains(&format!("allowed are {most}")), "{error}");
        }
    }
}

#[test]
fn a_lossy_webp_has_fewer_pixels_because_it_is_decoded_at_once() {
    // RIFF, WEBP, "VP8 ", a key frame of 4,000 x 4,000 pixels; then the same size without loss.
    let size = 4_000_u16.to_le_bytes();
    let lossy = [
        &b"RIFF\x1e\0\0\0WEBPVP8 \x0a\0\0\0\x10\0\0\x9d\x01\x2a"[..],
        &size,
        &size,
    ];
    let error = page(&lossy.concat()).unwrap_err();
    let error = error.to_string();
    assert!(
        error.contains("4000 x 4000 pixels; allowed are 13 million"),
        "{error}"
    );
    let bits = 3_999_u32 + (3_999 << 14);
    let lossless = [
        &b"RIFF\x12\0\0\0WEBPVP8L\x05\0\0\0\x2f"[..],
        &bits.to_le_bytes(),
        &[0],
    ];
    let size = page(&lossless.concat()).unwrap();
    assert!((size.x - 4_000.0 * 25.4 / 96.0).abs() < 1e-9, "{size:?}");
}

/// A picture of 16 x 16 pixels whose header gives another size.
fn sized(format: image::ImageFormat, [width, height]: [u16; 2]) -> Vec<u8> {
    let picture = image::RgbImage::from_pixel(16, 16, image::Rgb([90; 3]));
    let mut file = Cursor::new(Vec::new());
    picture.write_to(&mut file, format).unwrap();
    let mut file = file.into_inner();
    let places = match format {
        Gif => [6, 8],
        Bmp => [18, 22],
        // The tags of TIFF for width and height, each with one number.
        _ => [0_u8, 1].map(|tag| {
            let is_entry = |byte: &[u8]| byte[..2] == [tag, 1] && byte[4..8] == [1, 0, 0, 0];
            8 + file.windows(8).position(is_entry).unwrap()
        }),
    };
    for (place, size) in places.into_iter().zip([width, height]) {
        file[place..place + 2].copy_from_slice(&size.to_le_bytes());
    }
    file
}

#[test]
fn a_spacing_that_would_take_days_is_refused_with_the_smallest_one() {
    let file = grey(100, 50, |_, _| 0.0);
    let mut options = options(ShadingStyle::Hatch);
    options.scale = 8.0;
    options.shading.spacing_mm = 0.1;
    assert_eq!(
        read(&file, &options).unwrap_err().to_string(),
        "a spacing of 0.1 mm is too fine for a picture of 212 x 106 mm on the paper; allowed are \
         0.21 mm or more; use a wider spacing or a smaller picture"
    );
}

#[test]
fn settings_out_of_range_are_named() {
    let file = grey(10, 10, |_, _| 0.0);
    let message = |change: fn(&mut Shading)| {
        let mut options = ReadOptions::default();
        change(&mut options.shading);
        read(&file, &options).unwrap_err().to_string()
    };
    assert_eq!(
        message(|options| options.spacing_mm = f64::NAN),
        "the spacing of the shading is NaN; allowed is a number above 0, in mm"
    );
    assert_eq!(
        message(|options| options.levels = 9),
        "the levels of the shading is 9; allowed is from 1 to 8"
    );
    assert_eq!(
        message(|options| options.threshold = Some(1.0)),
        "the threshold of the shading is 1; allowed is between 0 and 1"
    );
    assert!(message(|options| options.darkness = 0.0).starts_with("the darkness"));
    assert!(message(|options| options.angle_deg = f64::INFINITY).starts_with("the angle"));
}

#[test]
fn a_white_page_has_nothing_to_draw() {
    for style in STYLES {
        let error = read(&grey(30, 30, |_, _| 1.0), &options(style)).unwrap_err();
        assert!(
            matches!(error, SourceError::NothingToDraw { .. }),
            "{error}"
        );
    }
}

#[test]
fn pictures_are_recognised_by_name_and_by_contents() {
    let file = grey(2, 2, |_, _| 0.0);
    for name in ["photo.png", "photo.JPG", "photo.jpeg", "-", "photo"] {
        let source = Source::of_file(name, file.clone()).unwrap();
        assert_eq!(
            source,
            Source::of_file("a.png", file.clone()).unwrap(),
            "{name}"
        );
        assert!(!source.has_size(), "{name}");
    }
}

#[test]
fn the_bundled_photo_is_drawn_in_every_style() {
    let photo = include_bytes!("../../../../examples/drawings/still-life.jpg");
    for style in STYLES {
        let scale = 180.0 / (720.0 * PIXEL_MM);
        let strokes = drawn(
            photo,
            &ReadOptions {
                scale,
                ..options(style)
            },
        );
        let points: usize = strokes.iter().map(|stroke| stroke.points.len()).sum();
        assert!(
            (500..20_000).contains(&points),
            "{style:?}: {points} points"
        );
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn every_stroke_is_on_the_page_and_reproducible(
        pixels in prop::collection::vec(any::<u8>(), 1..300),
        width in 1..30_u32,
        style in prop::sample::select(STYLES.to_vec()),
        spacing_mm in 0.2..3.0,
        angle_deg in -200.0..200.0,
        scale in 0.3..6.0,
        invert in any::<bool>(),
    ) {
        let height = u32::try_from(pixels.len()).unwrap().div_ceil(width);
        let mut pixels = pixels;
        pixels.resize((width * height) as usize, 0);
        let file = encoded(width, height, ColorType::Grayscale, BitDepth::Eight, &pixels);
        let shading = Shading { spacing_mm, angle_deg, invert, ..Shading::new(style) };
        let options = ReadOptions { scale, shading, ..ReadOptions::default() };
        match read(&file, &options) {
            Ok((artwork, _)) => {
                for p in artwork.points() {
                    prop_assert!((-1e-9..=artwork.width_mm + 1e-9).contains(&p.x), "{:?}", p);
                    prop_assert!((-1e-9..=artwork.height_mm + 1e-9).contains(&p.y), "{:?}", p);
                }
                prop_assert_eq!(read(&file, &options).unwrap().0, artwork);
            }
            Err(error) => {
                let nothing = matches!(error, SourceError::NothingToDraw { .. });
                prop_assert!(nothing, "{}", error);
            }
        }
    }
}

/// A small picture in each format.
fn of_each_format() -> Vec<Vec<u8>> {
    let picture = image::DynamicImage::from(image::RgbImage::from_fn(24, 16, |x, y| {
        let [x, y] = [x, y].map(|place| u8::try_from(place).unwrap());
        image::Rgb([9 * x, 13 * y, 60])
    }));
    let others = [Gif, Bmp, Tiff, WebP].map(|format| {
        let mut file = Cursor::new(Vec::new());
        picture.write_to(&mut file, format).unwrap();
        file.into_inner()
    });
    let png = grey(24, 16, |x, y| x * y / 400.0);
    let jpeg = jpeg(24, 16, JpegColor::Luma, &[99; 384]);
    [png, jpeg].into_iter().chain(others).collect()
}

#[test]
fn a_picture_with_any_byte_of_its_header_damaged_is_read_or_refused() {
    for file in of_each_format() {
        // TIFF and WebP have sizes at their ends, too.
        let end = file.len();
        let places = (0..end.min(160)).chain(end.saturating_sub(200)..end);
        for place in places {
            for value in [0, 1, 0x7f, 0xff] {
                let mut damaged = file.clone();
                damaged[place] = value;
                if let Ok((header, grey)) = pixels(&damaged, 255, &CancelToken::default()) {
                    assert_eq!(grey.len(), header.width * header.height);
                    assert!(!grey.is_empty());
                }
            }
        }
    }
}

proptest! {
    #[test]
    fn a_damaged_file_gives_an_error_or_a_picture(
        format in 0..6_usize,
        damage in prop::collection::vec((0..100_000_usize, any::<u8>()), 1..6),
        kept in 0.0..1.2_f64,
    ) {
        let mut file = of_each_format().swap_remove(format);
        for (place, value) in damage {
            let place = place % file.len();
            file[place] = value;
        }
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            clippy::cast_precision_loss,
            reason = "a share of a short file"
        )]
        file.truncate((kept * file.len() as f64) as usize);
        // It only has to return.
        let _outcome = read(&file, &ReadOptions::default());
    }
}

/// 8 x 8 pixels, 0, 4, 8 and so on, stored in the seven passes of Adam7.
const INTERLACED: &[u8] = &[
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52,
    0x00, 0x00, 0x00, 0x08, 0x00, 0x00, 0x00, 0x08, 0x08, 0x00, 0x00, 0x00, 0x01, 0x96, 0x63, 0xd1,
    0xc1, 0x00, 0x00, 0x00, 0x5a, 0x49, 0x44, 0x41, 0x54, 0x78, 0xda, 0x01, 0x4f, 0x00, 0xb0, 0xff,
    0x00, 0x00, 0x00, 0x10, 0x00, 0x80, 0x90, 0x00, 0x08, 0x18, 0x00, 0x88, 0x98, 0x00, 0x40, 0x48,
    0x50, 0x58, 0x00, 0xc0, 0xc8, 0xd0, 0xd8, 0x00, 0x04, 0x0c, 0x14, 0x1c, 0x00, 0x44, 0x4c, 0x54,
    0x5c, 0x00, 0x84, 0x8c, 0x94, 0x9c, 0x00, 0xc4, 0xcc, 0xd4, 0xdc, 0x00, 0x20, 0x24, 0x28, 0x2c,
    0x30, 0x34, 0x38, 0x3c, 0x00, 0x60, 0x64, 0x68, 0x6c, 0x70, 0x74, 0x78, 0x7c, 0x00, 0xa0, 0xa4,
    0xa8, 0xac, 0xb0, 0xb4, 0xb8, 0xbc, 0x00, 0xe0, 0xe4, 0xe8, 0xec, 0xf0, 0xf4, 0xf8, 0xfc, 0xb8,
    0xcc, 0x1f, 0x81, 0x51, 0x76, 0x85, 0x96, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae,
    0x42, 0x60, 0x82,
];

#[test]
fn a_picture_of_one_tone_has_no_outlines_at_any_darkness() {
    let black = grey(40, 40, |_, _| 0.0);
    let error = read(&black, &options(ShadingStyle::Outline)).unwrap_err();
    assert_eq!(
        error.to_string(),
        "nothing to draw: the picture has no borders between tones, or the enclosed areas are smaller than the spacing"
    );
    let white = grey(40, 40, |_, _| 1.0);
    let error = read(&white, &options(ShadingStyle::Hatch)).unwrap_err();
    assert!(error.to_string().contains("only one light tone"), "{error}");
}

#[test]
fn a_picture_of_any_format_is_no_longer_decoded_once_it_is_cancelled() {
    for file in of_noise() {
        assert!(pixels(&file, 255, &CancelToken::default()).is_ok());
        // A decoder gets at most 4 kB at once.
        for checks in 0..file.len() / 4096 {
            let read = pixels(&file, 255, &CancelToken::after_checks(checks));
            assert!(read.is_err(), "{:?} after {checks} checks", format(&file));
        }
    }
}

/// A picture of noise, which cannot be packed, in each format.
fn of_noise() -> Vec<Vec<u8>> {
    let mut random = Random::new(1);
    let bytes: Vec<u8> = (0..3 * 300 * 300)
        .map(|_| random.number().to_le_bytes()[0])
        .collect();
    let picture = image::RgbImage::from_raw(300, 300, bytes.clone()).unwrap();
    let picture = image::DynamicImage::from(picture);
    let others = [Gif, Bmp, Tiff, WebP].map(|format| {
        let mut file = Cursor::new(Vec::new());
        picture.write_to(&mut file, format).unwrap();
        file.into_inner()
    });
    let png = encoded(300, 300, ColorType::Rgb, BitDepth::Eight, &bytes);
    let jpegs = [false, true].map(|is_progressive| {
        let mut file = Vec::new();
        let mut encoder = JpegEncoder::new(&mut file, 95);
        encoder.set_progressive(is_progressive);
        encoder.encode(&bytes, 300, 300, JpegColor::Rgb).unwrap();
        file
    });
    [png].into_iter().chain(jpegs).chain(others).collect()
}
