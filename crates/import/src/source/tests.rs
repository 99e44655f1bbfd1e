#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

use std::fs;
use std::path::Path;

use dobot_geometry::{Stroke, bounds_of_strokes};

use super::*;
use crate::artwork::Layer;

/// A drawing of the project; a skipped part would be a mistake in it.
fn example(name: &str) -> Artwork {
    let (artwork, warnings) = example_with_warnings(name);
    let mut differences = warnings
        .iter()
        .filter(|warning| warning.kind != WarningKind::Note);
    assert_eq!(differences.next(), None, "{name}");
    artwork
}

fn example_with_warnings(name: &str) -> (Artwork, Vec<Warning>) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/drawings");
    let bytes = fs::read(folder.join(name)).unwrap();
    let named = Source::of_file(name, bytes.clone()).unwrap();
    assert_eq!(
        Source::of_file("-", bytes).unwrap(),
        named,
        "{name} without its name"
    );
    named.read(&ReadOptions::default()).unwrap()
}

#[test]
fn a_file_larger_than_its_format_allows_is_refused_before_it_is_read() {
    let blanks = |begin: &str, length: usize| {
        let mut bytes = begin.as_bytes().to_vec();
        bytes.resize(length, b' ');
        bytes
    };
    let error = Source::of_file("a.svg", blanks("<svg>", 64_000_001)).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the file has more than 64 MB, and its format may have 64 MB; draw it in parts, or remove detail that no pen can show"
    );
    Source::of_file("a.csv", blanks("0,0", 64_000_000)).unwrap();
    // A sheet that was scanned and not packed.
    Source::of_file("a.tif", blanks("II*\0", 64_000_001)).unwrap();
}

/// Name, strokes and closed strokes of each layer.
fn layers(artwork: &Artwork) -> Vec<(&str, usize, usize)> {
    let closed = |layer: &Layer| layer.strokes.iter().filter(|stroke| stroke.closed).count();
    let layers = artwork.layers.iter();
    layers
        .map(|layer| (layer.name.as_str(), layer.strokes.len(), closed(layer)))
        .collect()
}

#[track_caller]
fn has_size(artwork: &Artwork, expected_mm: [f64; 2]) {
    let found_mm = [artwork.width_mm, artwork.height_mm];
    let is_near = |i: usize| (found_mm[i] - expected_mm[i]).abs() < 0.1;
    assert!(
        is_near(0) && is_near(1),
        "{found_mm:?} mm, expected are {expected_mm:?} mm"
    );
}

#[test]
fn the_leaf_has_an_outline_and_slower_veins() {
    let leaf = example("leaf.gcode");
    has_size(&leaf, [110.0, 50.0]);
    assert_eq!(
        layers(&leaf),
        [("S1000 F1200", 1, 1), ("S1000 F600", 15, 0)]
    );
    assert_eq!(leaf.layers[0].speed_mm_s, Some(20.0));
    // Two arcs of radius 62.5 mm, each over twice the angle whose sine is 50 / 62.5.
    let outline = leaf.layers[0].strokes[0].length_mm();
    let wanted = 4.0 * 62.5 * (50.0_f64 / 62.5).asin();
    assert!(
        (outline - wanted).abs() < 0.05,
        "{outline}, wanted {wanted}"
    );
}

#[test]
fn the_gear_has_24_teeth_and_holes_for_another_pen() {
    let gear = example("gear.plt");
    has_size(&gear, [80.0, 80.0]);
    assert_eq!(layers(&gear), [("pen 1", 2, 2), ("pen 2", 7, 7)]);
    assert_eq!(gear.layers[0].strokes[0].points.len(), 24 * 4 + 1);
}

#[test]
fn the_dial_has_labels_around_it_and_a_pointer_for_another_pen() {
    let dial = example("dial.plt");
    let found: Vec<&str> = dial
        .layers
        .iter()
        .map(|layer| layer.name.as_str())
        .collect();
    assert_eq!(found, ["pen 1", "pen 2"]);
    assert!((dial.layers[1].strokes[0].length_mm() - 36.75).abs() < 0.1);
    assert!(dial.layers[0].strokes.len() > 60);
}

#[test]
fn the_bracket_has_an_outline_and_holes() {
    let bracket = example("bracket.dxf");
    has_size(&bracket, [120.0, 80.0]);
    assert_eq!(layers(&bracket), [("outline", 2, 1), ("holes", 7, 7)]);
    assert_eq!(bracket.layers[1].color, Some([255, 0, 0]));
}

#[test]
fn the_tag_is_filled_drawn_and_cut_in_this_order() {
    let (tag, warnings) = example_with_warnings("tag.lbrn2");
    let message: Vec<&str> = warnings
        .iter()
        .map(|warning| warning.what.as_str())
        .collect();
    assert_eq!(message, ["tool-layer shape", "laser layer"]);
    has_size(&tag, [90.0, 50.0]);
    assert_eq!(
        layers(&tag),
        [("moon", 2, 2), ("waves", 5, 2), ("edge", 2, 2)]
    );
    // The star is a hole in the moon.
    assert_eq!(tag.layers[0].areas[0].rings.len(), 2);
    assert_eq!(tag.layers[2].color, Some([255, 0, 0]));
}

#[test]
fn the_wave_is_fifteen_lines() {
    let wave = example("wave.csv");
    assert!((wave.width_mm - 160.0).abs() < 1e-9 && wave.height_mm < 80.0);
    assert_eq!(layers(&wave), [("", 15, 0)]);
}

#[test]
fn the_knot_is_one_line_in_two_rings() {
    let knot = example("knot.json");
    has_size(&knot, [100.0, 100.0]);
    assert_eq!(layers(&knot), [("knot", 1, 1), ("ring", 2, 2)]);
    let ring: f64 = knot.layers[1].strokes.iter().map(Stroke::length_mm).sum();
    assert!((ring - std::f64::consts::TAU * 97.0).abs() < 0.2, "{ring}");
}

#[test]
fn a_drawing_is_exact_if_it_is_the_same_at_any_tolerance() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/drawings");
    let is_exact = |name: &str| {
        let source = Source::of_file(name, fs::read(folder.join(name)).unwrap()).unwrap();
        let [fine, coarse] = [0.001, 1.0].map(|tolerance_mm| {
            let options = ReadOptions {
                tolerance_mm,
                ..ReadOptions::default()
            };
            source.read(&options).unwrap().0
        });
        assert_eq!(fine.is_exact, fine == coarse, "{name}");
        fine.is_exact
    };
    let names = [
        "wave.csv",
        "knot.json",
        "square.svg",
        "harbour.svg",
        "leaf.gcode",
        "bracket.dxf",
        "dial.plt",
        "tag.lbrn2",
    ];
    let exact = names.map(is_exact);
    assert_eq!(exact, [true, true, true, false, false, false, false, false]);
}

#[test]
fn a_name_with_an_unknown_extension_is_reported_with_the_known_ones() {
    let error = Source::of_file("letter.txt", b"Dear reader".to_vec()).unwrap_err();
    let error = error.to_string();
    let start = "\"letter.txt\" is not a supported file; supported are .svg, .svgz, .png, ";
    assert!(
        error.starts_with(start) && error.ends_with(".cnc files"),
        "{error}"
    );
    let endings = ["gcode", "gco", "g", "nc", "ngc", "tap", "cnc", "NC"];
    for ending in endings {
        let source = Source::of_file(&format!("a.{ending}"), Vec::new()).unwrap();
        assert_eq!(format_name(&source), "G-code", "{ending}");
    }
    for ending in ["hpgl", "hpg", "plt", "hgl"] {
        let source = Source::of_file(&format!("a.{ending}"), Vec::new()).unwrap();
        assert_eq!(format_name(&source), "HP-GL", "{ending}");
    }
}

#[test]
fn a_drawing_with_a_wrong_name_or_in_packed_form_is_recognised_by_its_contents() {
    use std::io::Write;
    let svg = "<svg xmlns=\"http://www.w3.org/2000/svg\"/>";
    let expected = Source::from(svg);
    let mut packer = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
    packer.write_all(svg.as_bytes()).unwrap();
    let packed = packer.finish().unwrap();
    for name in ["a.svgz", "a.svg.gz", "a.svg", "-"] {
        assert_eq!(
            Source::of_file(name, packed.clone()).unwrap(),
            expected,
            "{name}"
        );
    }
    for name in ["a.gcode", "a.dxf", "a.jpg"] {
        assert_eq!(
            Source::of_file(name, svg.into()).unwrap(),
            expected,
            "{name}"
        );
    }
}

#[test]
fn a_format_that_other_programs_can_convert_is_reported_with_the_program() {
    for (bytes, message) in [
        (
            &b"%PDF-1.7\n4 0 obj"[..],
            "found a PDF file, which is not supported; Inkscape opens it",
        ),
        (
            b"%!PS-Adobe-3.0 EPSF-3.0",
            "found a PostScript or EPS file, which is not supported; Inkscape",
        ),
        (
            b"\x00\x00\x00\x18ftypheic",
            "found an HEIC or AVIF picture, which is not supported; save it as JPEG",
        ),
        (
            b"PK\x03\x04\x14\x00",
            "found a zip archive, which is not supported; unpack it",
        ),
        (
            b"<!-- saved -->\n<!DOCTYPE html>\n<html><body><br>",
            "found an HTML page, which is not supported; open it in a browser",
        ),
        (
            b"\n<HTML><svg>",
            "found an HTML page, which is not supported; open it in a browser",
        ),
        (
            b"PK\x03\x04\x14\x00\x06\x00\x08\x00\x00\x00!\x00[Content_Types].xml",
            "found a text document, spreadsheet or presentation, which is not supported; export",
        ),
        (
            b"PK\x03\x04\x14\x00\x00\x08mimetypeapplication/vnd.oasis.opendocument.text",
            "found a text document, spreadsheet or presentation, which is not supported; export",
        ),
        (
            b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1",
            "found a document of an office program, which is not supported; export",
        ),
        (
            b"{\\rtf1\\ansi",
            "found a document of an office program, which is not supported; export",
        ),
        (
            b"ISO-10303-21;\nHEADER;",
            "found a 3D model, which is not supported; export a flat drawing",
        ),
        (
            b"Rar!\x1a\x07",
            "found an archive, which is not supported; unpack it",
        ),
        (
            b"\x00\x00\x00\x18ftypisom",
            "found a video or a sound, which is not supported; save one of its pictures",
        ),
        (
            b"version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n",
            "found a Git LFS pointer instead of the file, which is not supported; run `git lfs pull` in its folder",
        ),
    ] {
        for name in ["a.gcode", "a.svg", "a.png", "a.dxf", "a.csv", "a"] {
            let error = Source::of_file(name, bytes.to_vec());
            let error = error.unwrap_err().to_string();
            assert!(error.starts_with(message), "{name}: {error}");
        }
    }
}

#[test]
fn a_drawing_is_read_whatever_its_name_is_if_its_start_leaves_no_doubt() {
    for (name, start, format) in [
        ("a.svg", "  0\nSECTION\n  2\nENTITIES\n", "DXF"),
        ("a.gcode", "0\r\nSECTION\r\n2\r\nHEADER\r\n", "DXF"),
        (
            "a.dxf",
            "<svg xmlns=\"http://www.w3.org/2000/svg\"/>",
            "SVG",
        ),
        ("a.svg", "IN;SP1;PU0,0;PD400,0;", "HP-GL"),
        ("a.svg", "G21\nG0 X1\n", "G-code"),
        ("a.lbrn2", "0,0\n1,1\n", "CSV"),
        ("a.svg", "Dear reader", "SVG"),
        (
            "a.svg",
            "<p>a <svg><foreignObject><html/></foreignObject></svg>",
            "SVG",
        ),
    ] {
        let source = Source::of_file(name, start.into()).unwrap();
        assert_eq!(format_name(&source), format, "{name}: {start}");
    }
}

fn format_name(source: &Source) -> &str {
    match source {
        Source::File { format, .. } => format.name,
        _ => panic!("{source:?} is no file"),
    }
}

/// Left, bottom, right and top of all strokes but the first, which is a dot, in millimetres from
/// that dot, y up.
pub(crate) fn sides_from_dot(strokes: &[Stroke]) -> [f64; 4] {
    let origin = strokes[0].points[0];
    let ink = bounds_of_strokes(&strokes[1..]);
    let sides = [ink.x0, -ink.y1, ink.x1, -ink.y0];
    let from = [origin.x, -origin.y, origin.x, -origin.y];
    std::array::from_fn(|i| ((sides[i] - from[i]) * 1e6).round() / 1e6)
}
