#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

mod hostile;
mod layers;
mod paths;

use std::f64::consts::{PI, TAU};

use dobot_geometry::{Stroke, bounds_of_strokes};
use proptest::prelude::*;

use super::*;
use crate::source::refuse_mistakes;

/// A project with these elements.
fn project(inside: &str) -> String {
    mirrored("False", "False", inside)
}

fn mirrored(x: &str, y: &str, inside: &str) -> String {
    let root = format!(
        "<LightBurnProject AppVersion=\"1.7.08\" FormatVersion=\"1\" MirrorX=\"{x}\" MirrorY=\"{y}\">"
    );
    format!("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{root}\n{inside}\n</LightBurnProject>\n")
}

/// A layer with this name in `LightBurn`, a mode and more settings.
fn cut(index: u32, mode: &str, more: &str) -> String {
    format!(
        "<CutSetting type=\"{mode}\"><index Value=\"{index}\"/><name Value=\"C{index:02}\"/>{more}</CutSetting>"
    )
}

fn shape(attributes: &str, frame: &str, inside: &str) -> String {
    format!("<Shape {attributes}><XForm>{frame}</XForm>{inside}</Shape>")
}

const HERE: &str = "1 0 0 1 0 0";

fn read_text(text: &str) -> (Artwork, Vec<String>) {
    let (artwork, warnings) = super::read(text, &ReadOptions::default()).unwrap();
    (artwork, warnings.iter().map(Warning::to_string).collect())
}

/// The result of these shapes on layer 0, a line layer.
fn draw(inside: &str) -> Artwork {
    let (artwork, warnings) = read_text(&project(&(cut(0, "Cut", "") + inside)));
    let others = warnings
        .into_iter()
        .filter(|warning| !warning.contains("laser layer"));
    assert_eq!(others.collect::<Vec<_>>(), [""; 0]);
    artwork
}

/// The error of a project in which no mistake is allowed.
fn error(text: &str) -> String {
    let read = super::read(text, &ReadOptions::default());
    let refused = read.and_then(|(_, warnings)| refuse_mistakes(&warnings));
    refused.unwrap_err().to_string()
}

fn strokes(artwork: &Artwork) -> Vec<&Stroke> {
    artwork
        .layers
        .iter()
        .flat_map(|layer| &layer.strokes)
        .collect()
}

fn corners(artwork: &Artwork) -> Vec<Vec<(f64, f64)>> {
    let round = |x: f64| (x * 1e6).round() / 1e6 + 0.0;
    let corners = |stroke: &Stroke| {
        stroke
            .points
            .iter()
            .map(|p| (round(p.x), round(p.y)))
            .collect()
    };
    strokes(artwork).into_iter().map(corners).collect()
}

fn length_mm(artwork: &Artwork) -> f64 {
    strokes(artwork)
        .iter()
        .map(|stroke| stroke.length_mm())
        .sum()
}

#[track_caller]
fn same(found: f64, expected: f64, tolerance: f64) {
    let off = (found - expected).abs();
    assert!(
        off <= tolerance,
        "{found}, expected is {expected} within {tolerance}"
    );
}

#[test]
fn shapes_with_a_mistake_are_left_out_and_reported() {
    let square = |x: u32| {
        shape(
            "Type=\"Rect\" CutIndex=\"0\" W=\"2\" H=\"2\"",
            &format!("1 0 0 1 {x} 0"),
            "",
        )
    };
    let bad = shape("Type=\"Rect\" CutIndex=\"0\" W=\"wide\" H=\"2\"", HERE, "");
    let group = format!(
        "<Shape Type=\"Group\"><XForm>{HERE}</XForm><Children>{bad}{}</Children></Shape>",
        square(20)
    );
    let text = project(&(cut(0, "Cut", "") + &square(0) + &bad + &group));
    let (artwork, warnings) = read_text(&text);
    assert_eq!(artwork.width_mm, 22.0);
    let found = "expected a number of at most 1e9 (first of 2): its shape is left out";
    assert!(
        warnings[0].starts_with("3:") && warnings[0].ends_with(found),
        "{warnings:?}"
    );
    let settings = "<CutSetting type=\"Cut\"></CutSetting>".to_owned() + &square(0);
    let (_, warnings) = read_text(&project(&settings));
    assert!(
        warnings[0].ends_with(": the settings of its layer are left out"),
        "{warnings:?}"
    );
}

#[test]
fn a_project_that_is_cut_off_is_drawn_up_to_there() {
    let square = |x: u32| {
        shape(
            "Type=\"Rect\" CutIndex=\"0\" W=\"2\" H=\"2\"",
            &format!("1 0 0 1 {x} 0"),
            "",
        )
    };
    let text = project(&(cut(0, "Cut", "") + &square(0) + "\n" + &square(20) + "\n" + &square(40)));
    let last = text.rfind("<Shape").unwrap();
    for broken in [
        &text[..last],
        &text[..last + 9],
        &text[..last + 60],
        &text.replace("</Shape>\n</Light", "</Shap>\n</Light"),
    ] {
        let (artwork, warnings) = read_text(broken);
        assert_eq!(artwork.width_mm, 22.0, "{broken}");
        let found = warnings
            .iter()
            .find(|warning| warning.ends_with(": the rest of the file is left out"));
        assert!(
            found.is_some_and(|found| found.contains("not well-formed XML")),
            "{warnings:?}"
        );
    }
}

#[test]
fn a_rectangle_is_centred_at_its_place_and_y_points_up() {
    let small = shape(
        "Type=\"Rect\" CutIndex=\"0\" W=\"2\" H=\"4\"",
        "1 0 0 1 1 2",
        "",
    );
    let above = shape(
        "Type=\"Rect\" CutIndex=\"0\" W=\"2\" H=\"2\"",
        "1 0 0 1 9 9",
        "",
    );
    let artwork = draw(&(small + &above));
    assert_eq!([artwork.width_mm, artwork.height_mm], [10.0, 10.0]);
    let boxes: Vec<_> = strokes(&artwork)
        .into_iter()
        .map(|stroke| bounds_of_strokes(std::slice::from_ref(stroke)))
        .map(|stroke| (stroke.x0, stroke.y0, stroke.x1, stroke.y1))
        .collect();
    assert_eq!(boxes, [(0.0, 6.0, 2.0, 10.0), (8.0, 0.0, 10.0, 2.0)]);
}

#[test]
fn a_mirrored_project_is_drawn_as_shown_in_lightburn() {
    let hook = shape(
        "Type=\"Path\" CutIndex=\"0\"",
        HERE,
        "<VertList>V0 0V0 5V3 5</VertList><PrimList>L0 1L1 2</PrimList>",
    );
    let seen = |x, y| corners(&read_text(&mirrored(x, y, &(cut(0, "Cut", "") + &hook))).0);
    assert_eq!(
        seen("False", "False"),
        [[(0.0, 5.0), (0.0, 0.0), (3.0, 0.0)]]
    );
    assert_eq!(
        seen("False", "True"),
        [[(0.0, 0.0), (0.0, 5.0), (3.0, 5.0)]]
    );
    assert_eq!(
        seen("True", "False"),
        [[(3.0, 5.0), (3.0, 0.0), (0.0, 0.0)]]
    );
    assert_eq!(seen("True", "True"), [[(3.0, 0.0), (3.0, 5.0), (0.0, 5.0)]]);
}

#[test]
fn round_corners_are_quarters_of_circles() {
    let round = shape(
        "Type=\"Rect\" CutIndex=\"0\" W=\"30\" H=\"20\" Cr=\"4\"",
        HERE,
        "",
    );
    let artwork = draw(&round);
    assert_eq!(strokes(&artwork).len(), 1);
    assert!(strokes(&artwork)[0].closed);
    same(artwork.width_mm, 30.0, 1e-9);
    same(artwork.height_mm, 20.0, 1e-9);
    same(length_mm(&artwork), 100.0 - 8.0 * 4.0 + TAU * 4.0, 0.05);
}

#[test]
fn corners_that_are_too_round_or_turned_inwards_are_reported() {
    let with = |radius: &str| {
        let attributes = format!("Type=\"Rect\" CutIndex=\"0\" W=\"30\" H=\"20\" Cr=\"{radius}\"");
        read_text(&project(&shape(&attributes, HERE, "")))
    };
    let (artwork, warnings) = with("15");
    same(length_mm(&artwork), 20.0 + TAU * 10.0, 0.05);
    assert!(
        warnings[0].contains("the largest radius that its shorter side allows"),
        "{warnings:?}"
    );
    let (artwork, warnings) = with("-3");
    same(length_mm(&artwork), 100.0, 1e-9);
    assert!(warnings[0].contains("sharp corners"), "{warnings:?}");
}

#[test]
fn an_ellipse_has_its_radii_and_a_polygon_starts_on_the_right() {
    let circle = draw(&shape(
        "Type=\"Ellipse\" CutIndex=\"0\" Rx=\"10\" Ry=\"10\"",
        HERE,
        "",
    ));
    same(length_mm(&circle), TAU * 10.0, 0.05);
    let flat = draw(&shape(
        "Type=\"Ellipse\" CutIndex=\"0\" Rx=\"10\" Ry=\"3\"",
        HERE,
        "",
    ));
    same(flat.width_mm, 20.0, 1e-9);
    same(flat.height_mm, 6.0, 0.01);
    let square = draw(&shape(
        "Type=\"Polygon\" CutIndex=\"0\" N=\"4\" Rx=\"5\" Ry=\"2\"",
        HERE,
        "",
    ));
    let diamond = [(10.0, 2.0), (5.0, 0.0), (0.0, 2.0), (5.0, 4.0), (10.0, 2.0)];
    assert_eq!(corners(&square), [diamond]);
}

#[test]
fn groups_move_turn_and_stretch_their_contents() {
    let dash = shape(
        "Type=\"Path\" CutIndex=\"0\"",
        "2 0 0 2 1 0",
        "<VertList>V0 0V3 0</VertList><PrimList>L0 1</PrimList>",
    );
    let still = shape(
        "Type=\"Path\" CutIndex=\"0\"",
        HERE,
        "<VertList>V0 0V-5 0</VertList><PrimList>LineOpen</PrimList>",
    );
    let inner = shape(
        "Type=\"Group\"",
        "0 1 -1 0 0 0",
        &format!("<Children>{dash}</Children>"),
    );
    let outer = shape(
        "Type=\"Group\"",
        "1 0 0 1 10 0",
        &format!("<Children>{inner}</Children>"),
    );
    // (0, 0) and (3, 0) become (1, 0) and (7, 0), turned (0, 1) and (0, 7), moved (10, 1) and (10,
    // 7).
    let lines = corners(&draw(&(still + &outer)));
    assert_eq!(
        lines,
        [[(5.0, 7.0), (0.0, 7.0)], [(15.0, 6.0), (15.0, 0.0)]]
    );
}

#[test]
fn a_text_is_placed_at_its_outlines_in_any_group() {
    let line = "<VertList>V0 0V4 0</VertList><PrimList>L0 1</PrimList>";
    let outlines = format!(
        "<BackupPath Type=\"Path\" CutIndex=\"0\"><XForm>1 0 0 1 10 8</XForm>{line}</BackupPath>"
    );
    let text = shape(
        "Type=\"Text\" CutIndex=\"0\" Str=\"-\" HasBackupPath=\"1\"",
        "1 0 0 1 22 3",
        &outlines,
    );
    let group = shape(
        "Type=\"Group\"",
        "1 0 0 1 -12 5",
        &format!("<Children>{text}</Children>"),
    );
    let below = shape("Type=\"Path\" CutIndex=\"0\"", HERE, line);
    let lines = corners(&draw(&(below + &group)));
    assert_eq!(
        lines,
        [[(0.0, 8.0), (4.0, 8.0)], [(10.0, 0.0), (14.0, 0.0)]]
    );
}

#[test]
fn an_undrawable_shape_is_reported_with_a_remedy() {
    let line = shape(
        "Type=\"Path\"",
        HERE,
        "<VertList>V0 0V4 0</VertList><PrimList>L0 1</PrimList>",
    );
    let text = shape("Type=\"Text\" Str=\"hi\"", HERE, "");
    let code = shape("Type=\"QrCode\"", HERE, "");
    let picture = shape(
        "Type=\"Bitmap\" Data=\"iVBORw0KGgo=\" W=\"9\" H=\"9\"",
        HERE,
        "",
    );
    let (artwork, warnings) = read_text(&project(
        &(cut(0, "Cut", "") + &line + &text + &code + &picture),
    ));
    assert_eq!(strokes(&artwork).len(), 1);
    let message = warnings.join("\n");
    for part in [
        "1 plain text: left out, because the project has no outlines of it; convert it to a path in LightBurn",
        "1 unsupported shape: left out (the first is a \"QrCode\")",
        "1 picture: left out; save it from LightBurn and draw it separately: dobot draw picture.png",
        "1 laser layer: drawn without its speed, power, passes and kerf",
    ] {
        assert!(message.contains(part), "{message}");
    }
}

proptest! {
    #[test]
    fn a_circle_keeps_its_distance_from_its_middle_through_any_turn_and_size(
        turn in 0.0..TAU,
        size in 0.1..20.0_f64,
        [x, y] in [-500.0..500.0_f64, -500.0..500.0],
        radius in 0.5..30.0_f64,
    ) {
        let (sin, cos) = turn.sin_cos();
        let [a, b, c, d] = [size * cos, size * sin, -size * sin, size * cos];
        let frame = format!("{a} {b} {c} {d} {x} {y}");
        let attributes = format!("Type=\"Ellipse\" CutIndex=\"0\" Rx=\"{radius}\" Ry=\"{radius}\"");
        let artwork = draw(&shape(&attributes, &frame, ""));
        let tolerance = ReadOptions::default().tolerance_mm;
        let expected = radius * size;
        let middle = bounds_of_strokes(&artwork.layers[0].strokes).center();
        for p in artwork.points() {
            // The middle of the bounds is off by the tolerance, too.
            let off = (p.distance(middle) - expected).abs();
            prop_assert!(off <= 2.0 * tolerance, "{off}");
        }
        let share = length_mm(&artwork) / (2.0 * PI * expected);
        // Its corners lie on the circle: a chord that leaves it by the tolerance is shorter by less
        // than this share.
        let least = 1.0 - tolerance / expected;
        prop_assert!((least..=1.0 + 1e-9).contains(&share), "{share}");
    }
}
