#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

mod choice;
mod heights;
mod laser;
mod servo;
mod subroutines;

use std::f64::consts::{PI, TAU};
use std::fmt::Write as _;

use dobot_geometry::{Point, Stroke};
use proptest::prelude::*;

use super::*;
use crate::artwork::Layer;
use crate::source::refuse_mistakes;
use crate::warning::WarningKind;

/// The lines that a laser burns.
fn draw(text: &str) -> (Artwork, Vec<String>) {
    draw_with(text, &ReadOptions::default())
}

fn draw_by_pen(text: &str) -> (Artwork, Vec<String>) {
    let options = ReadOptions {
        burns: false,
        ..ReadOptions::default()
    };
    draw_with(text, &options)
}

/// The drawing and its warnings, without notes and without the way to choose another rule.
fn draw_with(text: &str, options: &ReadOptions) -> (Artwork, Vec<String>) {
    let (artwork, warnings) = super::read(text.as_bytes(), options).unwrap();
    let warnings = warnings
        .iter()
        .filter(|warning| warning.kind != WarningKind::Note);
    let plain = |warning: &Warning| warning.to_string().replace(CHOICE, "");
    (artwork, warnings.map(plain).collect())
}

/// How the file is read.
fn decision(text: &str, options: &ReadOptions) -> String {
    let (_, warnings) = super::read(text.as_bytes(), options).unwrap();
    warnings.last().unwrap().to_string()
}

const CHOICE: &str = "; what.gcode chooses laser, pen or mill instead";

fn layers(text: &str) -> Vec<Layer> {
    draw(text).0.layers
}

/// The corners of the strokes of all layers.
fn corners(text: &str) -> Vec<Vec<(f64, f64)>> {
    corners_of(&draw(text).0)
}

fn corners_by_pen(text: &str) -> Vec<Vec<(f64, f64)>> {
    corners_of(&draw_by_pen(text).0)
}

fn rounded(mm: f64) -> f64 {
    (mm * 1e6).round() / 1e6 + 0.0
}

fn corners_of(artwork: &Artwork) -> Vec<Vec<(f64, f64)>> {
    let corners = |stroke: &Stroke| {
        let points = stroke.points.iter();
        points.map(|p| (rounded(p.x), rounded(p.y))).collect()
    };
    let strokes = artwork.layers.iter().flat_map(|layer| &layer.strokes);
    strokes.map(corners).collect()
}

/// The error of a file in which no mistake is allowed.
fn error(text: &str) -> String {
    let read = super::read(text.as_bytes(), &ReadOptions::default());
    let refused = read.and_then(|(_, warnings)| refuse_mistakes(&warnings));
    refused.unwrap_err().to_string().replace(CHOICE, "")
}

/// The largest deviation of a layer's lines from the circle of this radius about the middle of a
/// page of its size.
fn leaves_circle_by(layer: &Layer, radius: f64) -> f64 {
    let center = Point::new(radius, radius);
    let strokes = layer.strokes.iter();
    let middles = strokes.flat_map(|stroke| stroke.segments().map(|(a, b)| a.lerp(b, 0.5)));
    let off = middles
        .chain(layer.points())
        .map(|p| (p.distance(center) - radius).abs());
    off.fold(0.0, f64::max)
}

#[test]
fn a_laser_burns_while_m3_or_m4_hold_with_power_and_never_in_g0() {
    let text =
        "G21 G90\nM4 S0\nG0 X10 Y10\nG1 X20 S500 F1200\nG1 Y0\nG0 X0\nG1 Y10 S0\nM5\nG1 X3\n";
    let (artwork, warnings) = draw(text);
    assert_eq!(corners(text), [[(0.0, 0.0), (10.0, 0.0), (10.0, 10.0)]]);
    assert_eq!(artwork.layers[0].name, "S500 F1200");
    assert_eq!(artwork.layers[0].speed_mm_s, Some(20.0));
    assert_eq!([artwork.width_mm, artwork.height_mm], [10.0, 10.0]);
    assert_eq!(warnings, Vec::<String>::new());
}

#[test]
fn each_power_and_speed_of_a_laser_is_a_layer_and_low_power_is_reported() {
    let text = "M3\nG1 X9 S1000 F600\nG0 Y1\nG1 X0 S300\nG0 Y2\nG1 X9 S1000\nG0 Y3\nG1 X0 F60\n";
    let (artwork, warnings) = draw(text);
    let names: Vec<_> = artwork
        .layers
        .iter()
        .map(|layer| layer.name.as_str())
        .collect();
    assert_eq!(names, ["S1000 F600", "S300 F600", "S1000 F60"]);
    let strokes: Vec<_> = artwork
        .layers
        .iter()
        .map(|layer| layer.strokes.len())
        .collect();
    assert_eq!(strokes, [2, 1, 1]);
    assert_eq!(
        warnings,
        ["4:1: 1 weaker layer: burned faster instead, because this laser is only on or off"]
    );
    let speeds: Vec<_> = artwork
        .layers
        .iter()
        .map(|layer| layer.speed_mm_s)
        .collect();
    assert_eq!(speeds, [Some(10.0), Some(10.0 / 0.3), Some(1.0)]);
}

#[test]
fn laser_warnings_are_not_given_for_a_pen() {
    let text = "; Cut @ 600 mm/min, 20% power\nM4\nG0 X1 Y1\nG1 X9 S200 F600\nM5\n";
    assert_eq!(draw_by_pen(text).1, <[&str; 0]>::default());
    assert_eq!(draw(text).1.len(), 1);
}

#[test]
fn numbers_with_an_exponent_are_read_and_an_extruder_after_a_number_is_recognised() {
    let (artwork, warnings) = draw("M3 S1\nG1 X1e1 Y5E+01 F100\nG1 X1e-05");
    assert_eq!([artwork.width_mm, artwork.height_mm], [10.0, 50.0]);
    assert_eq!(warnings, Vec::<String>::new());
    let (artwork, warnings) = draw("G1X9Y9E2\ng1x1y1e3");
    assert_eq!([artwork.width_mm, artwork.height_mm], [9.0, 9.0]);
    assert!(
        warnings.iter().any(|warning| warning.contains("2 E words")),
        "{warnings:?}"
    );
    assert_eq!(
        error("G2 X1 I1e30"),
        "1:7: found \"I1e30\"; expected a number from -1e9 to 1e9"
    );
}

#[test]
fn power_in_percent_is_burned_as_fast_as_the_arm_can() {
    let job = |percent: u32, s: u32| {
        format!(
            "; LightBurn 1.4\n; GRBL device profile\nG21\nM4\n; Line @ 600 mm/min, {percent}% power\nG0 X1 Y1\n; Layer C00\nG1 X9 S{s} F600\nG1 Y9\nM5\n"
        )
    };
    let (artwork, warnings) = draw(&job(20, 200));
    assert_eq!(artwork.layers[0].speed_mm_s, Some(50.0));
    assert_eq!(warnings.len(), 1, "{warnings:?}");
    let (artwork, warnings) = draw(&job(100, 255));
    assert_eq!(artwork.layers[0].speed_mm_s, Some(10.0));
    assert!(warnings.is_empty(), "{warnings:?}");
    for text in [job(1, 10), job(1, 10).replace("1% power", "faint")] {
        let (artwork, warnings) = draw(&text);
        assert_eq!(
            artwork.layers[0]
                .speed_mm_s
                .map(|speed_mm_s| speed_mm_s > 199.0),
            Some(true)
        );
        assert!(
            warnings[1].contains("times as much; omit the layer"),
            "{warnings:?}"
        );
    }
}

#[test]
fn a_laser_that_waits_burns_a_dot() {
    let text = "M3 S0\nG0 X1 Y1\nS9\nG4 P0.1\nS0\nG0 X5\nS9\nG4 P.1\nM5";
    assert_eq!(corners(text), [[(0.0, 0.0)], [(4.0, 0.0)]]);
}

#[test]
fn a_dwell_before_the_pen_comes_down_leaves_no_dot_before_its_stroke() {
    let text =
        "G0 X1 Y1\nM3 S90\nG4 P0.2\nG1 X5 F1000\nM5\nG4 P0.2\nG0 X7\nM3 S90\nG4 P0.2\nG1 X9\nM5";
    assert_eq!(
        corners(text),
        [[(0.0, 0.0), (4.0, 0.0)], [(6.0, 0.0), (8.0, 0.0)]]
    );
    let (artwork, _) = draw(text);
    let names: Vec<_> = artwork
        .layers
        .iter()
        .map(|layer| layer.name.as_str())
        .collect();
    assert_eq!(names, ["S90 F1000"]);
}

#[test]
fn a_pen_draws_below_zero_and_leaves_dots_where_it_only_dips() {
    let text =
        "G0 Z5\nG0 X10 Y0\nG1 Z-0.1 F100\nG1 X20 F600\nG0 Z5\nG0 X15 Y5\nG1 Z-0.1\nG0 Z5\nG0 X0 Y0";
    let (artwork, warnings) = draw_by_pen(text);
    assert_eq!(
        corners_by_pen(text),
        [vec![(0.0, 5.0), (10.0, 5.0)], vec![(5.0, 0.0)]]
    );
    assert_eq!(artwork.layers[0].speed_mm_s, Some(10.0));
    assert!(warnings.is_empty(), "{warnings:?}");
}

#[test]
fn a_pen_that_never_goes_below_zero_draws_below_its_travels() {
    let text = "G0 Z3\nG0 X1 Y0\nG1 Z0.4\nG1 X5\nG1 Z0.3\nG1 Y5\nG0 Z3\nG0 X0 Y0\nG0 Z50\nG0 X9";
    let (_, warnings) = draw(text);
    assert_eq!(corners(text), [[(0.0, 5.0), (4.0, 5.0), (4.0, 0.0)]]);
    assert_eq!(
        warnings,
        ["1 file without moves below Z 0: drawn where Z is below 3.00 mm"]
    );
    let only_g1 = text.replace("G0", "G1").replace("0.4", "0.3");
    let (_, warnings) = draw(&only_g1);
    assert_eq!(corners(&only_g1), [[(0.0, 5.0), (4.0, 5.0), (4.0, 0.0)]]);
    assert_eq!(
        warnings,
        ["1 file without moves below Z 0: drawn where Z is below 0.40 mm"]
    );
}

#[test]
fn upright_arcs_are_lines_of_their_full_extent() {
    let lead_in = "G0 X-1 Y0\nZ5\nG1 Z-1\nG18 G2 X0 Z-2 I1\nG1 X5\nG17 G3 X10 Y5 J5\nG0 Z5";
    let strokes = corners(lead_in);
    assert_eq!(strokes.len(), 1);
    assert_eq!(strokes[0][..3], [(0.0, 5.0), (1.0, 5.0), (6.0, 5.0)]);
    // G2 turns from Z to X, on a circle of radius 2 around X 2: the first two go by its far side.
    for (text, width, length) in [
        ("G18 G2 X2 Z2 I2", 4.0, 6.0),
        ("G18 G3 X2 Z-2 I2", 4.0, 6.0),
        ("G18 G3 X2 Z2 I2", 2.0, 2.0),
        ("G18 G3 X4 Z0 R2", 4.0, 4.0),
    ] {
        let text = format!("M3 S1\nG0 X-1 Z0\nX0\n{text}\n");
        let (artwork, _) = draw(&text);
        let strokes = artwork.layers[0].strokes.iter();
        let drawn: f64 = strokes.map(Stroke::length_mm).sum();
        assert!((artwork.width_mm - width).abs() < 1e-9, "{text}");
        assert!((drawn - length).abs() < 1e-9, "{text}: {drawn}");
    }
    let there_and_back = "M3 S1\nG0 X0 Y0\nG19 G3 J2 F1";
    assert_eq!(
        corners(there_and_back),
        [[(0.0, 4.0), (0.0, 0.0), (0.0, 4.0)]]
    );
    // Without an arc the plane has no effect.
    assert_eq!(corners("G18 M3 S1\nG1 X10\nG17\nG1 Y10").len(), 1);
}

#[test]
fn drilled_holes_are_dots_where_z_lifts_the_pen() {
    let holes = [(0.0, 5.0), (10.0, 5.0), (10.0, 0.0)];
    for text in [
        "G0 X1 Y1\nZ5\nG98 G81 X1 Y1 Z-2 R1 F50\nX11\nY6\nG80\nG0 Z5",
        "G0 Z5\nG99 G83 X1 Y1 Z-2 R1 Q0.5 F50\nX11\nG81 Y6\nG0 X0 Y0",
        "G0 Z5\nG91 G82 X1 Y1 Z-3 R-4 P1\nX10\nY5\nG80",
    ] {
        assert_eq!(corners_by_pen(text), holes.map(|hole| [hole]), "{text}");
    }
    let (_, warnings) = draw("M280 S90\nG0 X1\nM280 S30\nG1 X5\nM280 S90\nG81 X9 Z-1 R1");
    assert!(
        warnings
            .contains(&"6:1: 1 drilled hole: left out, because Z does not lift the pen".to_owned()),
        "{warnings:?}"
    );
}

#[test]
fn queries_to_grbl_are_skipped_and_comments_may_contain_comments() {
    let text = "$I\n? ; status\n!\n~ (go on)\nG1 X5 (a (nested) one) Y5\nG1 X9 (a ( bracket)";
    let (artwork, warnings) = draw(text);
    assert_eq!([artwork.width_mm, artwork.height_mm], [9.0, 5.0]);
    assert_eq!(
        warnings[1],
        "2:1: 3 real-time commands: left out (?, ! or ~)"
    );
}

#[test]
fn a_dwell_while_the_pen_is_up_leaves_no_dot() {
    let text = "M3S40\nG4 P0.2\nG0X10Y10\nM3S90\nG4 P0.2\nG1X50Y10F1000\nG1X50Y50\nM3S40\nG4 P0.2\nG0X0Y0\nM5";
    let (artwork, warnings) = draw(text);
    assert_eq!(corners(text).len(), 1);
    assert_eq!(artwork.layers[0].name, "S90 F1000");
    assert!(warnings.is_empty(), "{warnings:?}");
}

#[test]
fn a_focus_move_of_a_laser_is_not_a_pen() {
    let text = "M3 S0\nG0 Z0\nG0 X1\nG1 X4 S9\nG0 Z-1\nG0 X1 S0\nG1 X4 S9\nM5";
    assert_eq!(corners(text).len(), 2);
}

#[test]
fn a_file_without_pen_or_laser_draws_with_g1_and_reports_it() {
    let text = "G0 X1 Y1\nG1 X2\nX3\nG0 X0";
    assert_eq!(corners(text), [[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0)]]);
    let (_, warnings) = draw(text);
    assert_eq!(
        warnings,
        ["1 file without commands for a laser or a pen (M3, Z): G1, G2 and G3 draw, G0 travels"]
    );
}

#[test]
fn a_pen_that_starts_at_its_place_is_recognised() {
    for text in [
        "G0 Z5\nG0 X0 Y0\nG1 Z-1\nG1 X10\nG0 Z5",
        "G0 Z5\nG1 Z-1\nG1 X10 Y0\nG1 Z5",
    ] {
        let wanted = [[(0.0, 0.0), (10.0, 0.0)]];
        assert_eq!(corners(text), wanted, "{text}");
        assert_eq!(draw(text).1, <[&str; 0]>::default(), "{text}");
    }
}

#[test]
fn a_lowered_pen_draws_with_every_motion_until_it_is_lifted() {
    let wanted = [[(0.0, 0.0), (10.0, 0.0), (20.0, 0.0)]];
    for text in [
        "G21 G90\nG0 Z5\nG0 X0 Y0\nG1 Z-1\nG1 X10\nG0 X20\nG0 Z5",
        "G21 G90\nG0 Z5\nG1 Z-1\nG0 X10\nG1 X20\nG0 Z5",
    ] {
        assert_eq!(corners_by_pen(text), wanted, "{text}");
        assert_eq!(draw_by_pen(text).1, <[&str; 0]>::default(), "{text}");
    }
}

#[test]
fn a_laser_that_starts_at_its_place_is_not_a_pen_even_if_it_is_lifted_at_the_end() {
    for text in [
        "G0 Z0\nM3 S255\nG1 X10\nM5\nG0 Z10",
        "G0 Z5\nG0 Z0\nM3 S255\nG1 X10\nM5",
    ] {
        assert_eq!(corners(text), [[(0.0, 0.0), (10.0, 0.0)]], "{text}");
        assert!(layers(text)[0].is_burned, "{text}");
        assert_eq!(draw(text).1, <[&str; 0]>::default(), "{text}");
    }
    // Without powers it goes by M3 as well.
    let switch = "G0 Z5\nG0 Z0\nG1 X10\nM3\nG1 X20\nM5\nG0 Z5";
    assert_eq!(corners(switch), [[(0.0, 0.0), (10.0, 0.0)]]);
}

#[test]
fn each_tool_is_a_layer() {
    let text = "T1 M6\nG1 X5\nT2 M6\nG0 Y1\nG1 X0\nM0\nT1 M6\nG0 Y2\nG1 X5";
    let layers = layers(text);
    let found: Vec<_> = layers
        .iter()
        .map(|layer| (layer.name.as_str(), layer.strokes.len()))
        .collect();
    assert_eq!(found, [("T1", 2), ("T2", 1)]);
    assert!(
        draw(text)
            .1
            .contains(&"6:1: 1 M0 code: drawn without a pause".to_owned())
    );
}

#[test]
fn y_points_up_in_the_file_and_down_on_the_page() {
    assert_eq!(
        corners("G0 X5 Y5\nG1 X5 Y9\nX7"),
        [[(0.0, 4.0), (0.0, 0.0), (2.0, 0.0)]]
    );
}

#[test]
fn inches_relative_moves_and_shifted_origins_become_millimetres() {
    let same = [
        "G1 X25.4\nY12.7\nX0\nY0",
        "G20\nG1 X1\nY.5\nX0\nY0",
        "g20g91g1x1\ny.5\nx-1\ny-.5",
        "G92 X100 Y-7\nG1 X125.4\nY5.7\nX100\nY-7",
        "G1 X25.4\nG92 X0\nY12.7\nX-25.4\nG92.1\nY0",
        "N10 G1 X 25.4 (right; so it is) Y0 ; comment (\n%\n/N20Y12.7\r\nX+0\n  Y-0. M2",
    ];
    for text in same {
        let found = corners(text);
        let square = [
            (0.0, 12.7),
            (25.4, 12.7),
            (25.4, 0.0),
            (0.0, 0.0),
            (0.0, 12.7),
        ];
        assert_eq!(found, [square], "{text}");
        assert!(layers(text)[0].strokes[0].closed, "{text}");
    }
}

#[test]
fn speeds_in_inches_are_reported_in_millimetres_per_second() {
    let layers = layers("G20 M3 S1\nG1 X1 F60");
    assert_eq!(
        (layers[0].name.as_str(), layers[0].speed_mm_s),
        ("S1 F60", Some(25.4))
    );
}

#[test]
fn circles_stay_within_the_tolerance_in_any_notation() {
    let circles = [
        "G0 X20 Y10\nG2 I-10",
        "G0 X20 Y10\nG3 X20 Y10 I-10 J0",
        "G0 X20 Y10\nG90.1 G3 X20 Y10 I10 J10",
        "G0 X20 Y10\nG91\nG2 X-20 R10\nX20 R10",
        "G0 X20 Y10\nG3 X0 R10 Z5 K1\nX20 I10.001",
        "G0 X20 Y10\nG3 X10 Y20 R10\nX20 Y10 R-10",
    ];
    for text in circles {
        let (artwork, _) = draw(text);
        let layer = &artwork.layers[0];
        let (length, off) = (layer.strokes[0].length_mm(), leaves_circle_by(layer, 10.0));
        assert!(off < 0.006, "{text}: {off}");
        assert!((length - 20.0 * PI).abs() < 0.1, "{text}: {length}");
        assert!(
            layer.strokes[0].closed && layer.strokes.len() == 1,
            "{text}"
        );
    }
}

#[test]
fn arcs_of_several_turns_are_drawn_as_often() {
    // A quarter and one more turn; two whole turns.
    for (text, turns) in [
        ("G0 X10\nG3 X0 Y10 I-10 P2", 1.25),
        ("G0 X10\nG2 I-10 P2", 2.0),
    ] {
        let length = layers(text)[0].strokes[0].length_mm();
        let expected = turns * 10.0 * TAU;
        assert!(
            (length - expected).abs() < 0.1,
            "{text}: {length}, expected {expected}"
        );
    }
}

#[test]
fn arcs_turn_in_the_given_direction() {
    // A quarter from the right to the top: short counterclockwise, three quarters clockwise.
    let length = |text: &str| layers(text)[0].strokes[0].length_mm();
    let quarter = 10.0 * TAU / 4.0;
    for (text, quarters) in [
        ("G0 X10\nG3 X0 Y10 I-10", 1.0),
        ("G0 X10\nG2 X0 Y10 I-10", 3.0),
        ("G0 X10\nG3 X0 Y10 R10", 1.0),
        ("G0 X10\nG3 X0 Y10 R-10", 3.0),
        ("G0 X10\nG2 X0 Y10 R-10", 3.0),
    ] {
        let found = length(text);
        assert!((found - quarters * quarter).abs() < 0.05, "{text}: {found}");
    }
    let rightmost = |text: &str| draw(text).0.width_mm;
    assert!((rightmost("G0 X10\nG3 X0 Y10 R10") - 10.0).abs() < 0.01);
    assert!((rightmost("G0 X10\nG3 X0 Y10 R-10") - 20.0).abs() < 0.01);
}

#[test]
fn skipped_codes_are_named_with_their_place_and_count() {
    let text = "M117 Hello (world\n$H\nG54\nM999\nG1 X1 E5\nM999\nG55\nG1 X2 E6\nG93\nG28\nG53 G0 Z0\nM30\nG1 X9\n";
    let (_, warnings) = draw(text);
    assert_eq!(
        warnings,
        [
            "1:1: 1 M117 code: its message is not shown",
            "2:1: 1 machine setting: left out ($)",
            "4:1: 2 M999 codes: unknown, left out",
            "5:7: 2 E words: left out, because only X and Y are drawn",
            "7:1: 1 G55 coordinate system: drawn in the place of G54",
            "9:1: 1 G93 code: speeds are read as units per minute",
            "10:1: 1 G28 or G30 homing: read as a travel to X 0, Y 0",
            "11:1: 1 G53 move: read as a travel with the pen up",
            "13:1: 1 unreached line: left out, because it is after the end (M2, M30, M99, M112 or %)",
            "1 file without commands for a laser or a pen (M3, Z): G1, G2 and G3 draw, G0 travels",
        ]
    );
}

#[test]
fn words_of_other_codes_are_not_moves_tools_or_speeds() {
    let other_codes = "M205 X80 Y80 Z0.2\nM204 P1000 R1000 T1000\nM73 P10 R5\nM201 X500 E5000\nM203 X1 F9\nM84 X Y\nM18 X0";
    let text =
        format!("G0 Z5\nG0 X0 Y0\nG1 Z-1\nG1 X10 F600\n{other_codes}\nG1 X10 Y10\nG0 Z5\nG0 X0\n");
    let (artwork, warnings) = draw(&text);
    assert_eq!(corners(&text), [[(0.0, 10.0), (10.0, 10.0), (10.0, 0.0)]]);
    assert_eq!(
        (
            artwork.layers[0].name.as_str(),
            artwork.layers[0].speed_mm_s
        ),
        ("", Some(10.0))
    );
    assert_eq!(warnings.len(), 5, "{warnings:?}");
    assert!(
        warnings
            .iter()
            .all(|warning| warning.ends_with("code: unknown, left out")),
        "{warnings:?}"
    );
    // With a motion code beside it, and modal beside a laser's, a word is one of a move.
    assert_eq!(
        corners("M3 S9\nG0 X0\nM999 G1 X10"),
        [[(0.0, 0.0), (10.0, 0.0)]]
    );
    assert_eq!(corners("G1 X0 F60\nX10 M3 S9"), [[(0.0, 0.0), (10.0, 0.0)]]);
}

#[test]
fn programs_have_numbers_and_an_end_and_lasers_may_be_switched_in_moves() {
    let text = "%\nO1234 (a part)\nM3 I\nG0 X0 Y0\nG1 X10 S9 F600\nM5 I\nM99\n%";
    assert_eq!(corners(text), [[(0.0, 0.0), (10.0, 0.0)]]);
    assert_eq!(corners(&text.replace("O1234 (a part)", ":1000")).len(), 1);
}

#[test]
#[expect(clippy::too_many_lines, reason = "a table")]
fn codes_that_would_draw_something_else_are_refused_with_their_place() {
    let word = "expected a word such as G1 or X-2.5 (variables, formulas, loops and conditions are not supported; expand them in the program that made the file)";
    for (text, expected) in [
        (
            "",
            "nothing to draw: no moves by G1, G2 or G3; 1 file without commands for a laser or a pen (M3, Z): G1, G2 and G3 draw, G0 travels",
        ),
        (
            "G0 X1\nM5",
            "nothing to draw: the laser has no power in any line (M3, M4 or M106, and S above 0 if the file uses S)",
        ),
        ("G1 X1\nG1 Xabc", &format!("2:4: found \"Xabc\"; {word}")),
        ("G1 X1,5", &format!("1:6: found \",5\"; {word}")),
        ("#1=5", &format!("1:1: found \"#1=5\"; {word}")),
        ("o100 if", &format!("1:1: found \"o100 if\"; {word}")),
        ("G1 X[1+2]", &format!("1:4: found \"X[1+2]\"; {word}")),
        ("G1 XNaN", &format!("1:4: found \"XNaN\"; {word}")),
        (
            "G1 X9999999999",
            &format!("1:4: found \"X9999999999\"; {word}"),
        ),
        ("G1 X--5", &format!("1:4: found \"X--5\"; {word}")),
        (
            "G1 X1 (open",
            "1:7: found \"(open\"; expected a comment closed by ) on the same line",
        ),
        (
            "G1 X1 X2",
            "1:7: found \"X2\"; expected X only once per line",
        ),
        (
            "G1 G2 X1",
            "1:4: found G2; expected one of G0 to G3 per line",
        ),
        (
            "G1.25 X1",
            "1:1: found \"G1.25 X1\"; expected a code such as G1 or G90.1",
        ),
        (
            "G-1 X1",
            "1:1: found \"G-1 X1\"; expected a code such as G1 or G90.1",
        ),
        (
            "G1 X2000000",
            "1:1: leads to (2000000, 0) mm; at most 1000000 mm from the origin are allowed",
        ),
        (
            "G5 X1",
            "1:1: found G5; expected moves by G0 to G3: splines are not supported; export lines or arcs",
        ),
        (
            "G18 G2 X10 Y1 R5",
            "1:1: found an upright arc (G18 or G19) that also moves sideways; expected an arc within its plane",
        ),
        (
            "G41 D1",
            "1:1: found G41; expected moves by G0 to G3: cutter compensation is not supported; export the path of the tool center",
        ),
        (
            "G87 X1 Z-1 R1",
            "1:1: found G87; expected moves by G0 to G3: this canned cycle is not supported; export single moves",
        ),
        (
            "M98 P1",
            "1:1: found M98; expected moves by G0 to G3: subroutines are not supported; expand them",
        ),
        (
            "G92",
            "1:1: found G92 without an axis; expected X, Y or Z after it",
        ),
        (
            "G1 X1 I1",
            "1:7: found the center of an arc with G1; expected I, J and R only with G2 or G3",
        ),
        (
            "G2 X1",
            "1:1: found G2 without a center; expected I and J, or R",
        ),
        (
            "G2 X10 I4",
            "1:1: found an arc whose start is 4.000 mm and whose end is 6.000 mm from its center; expected ends that fit the arc",
        ),
        (
            "G2 X10 I0 J0",
            "1:1: found an arc whose center is its start; expected ends that fit the arc",
        ),
        (
            "G2 X10 R4",
            "1:8: found an arc of radius 4.000 mm between points 10.000 mm apart; expected a radius of at least half their distance",
        ),
        (
            "G2 X0 R4",
            "1:7: found an arc given by its radius that ends at its start; expected a radius of at least half their distance",
        ),
        (
            "G2 I5 P2.5",
            "1:7: found an arc of 2.5 turns (P); expected a whole number from 1 to 1000",
        ),
        (
            "N1 G1 X1*5",
            "1:9: found \"*5\"; expected *96, the checksum (XOR of the bytes of the line)",
        ),
    ] {
        assert_eq!(error(text), expected, "{text}");
    }
    let sum = "N1 G1 X1".bytes().fold(0, |sum, byte| sum ^ byte);
    assert_eq!(layers(&format!("N1 G1 X1*{sum}")).len(), 1);
}

#[test]
fn an_upright_arc_without_a_center_and_a_drilling_cycle_without_a_depth_are_refused() {
    for (text, expected) in [
        (
            "G19 G2 Y10 I5",
            "1:1: found G2 without a center; expected J and K, or R",
        ),
        (
            "G81 X1 Z-1",
            "1:1: found a drilling cycle without a depth; expected Z (the depth) and R (the start height)",
        ),
        (
            "G91 G81 X1 Z-1 R1 L3",
            "1:19: found a drilling cycle of 3 times (L); expected single holes",
        ),
    ] {
        assert_eq!(error(text), expected, "{text}");
    }
}

#[test]
fn files_that_would_fill_the_memory_are_refused() {
    let many = "G91\n".to_owned() + &"G2 I400000\n".repeat(1000);
    assert_eq!(
        error(&many),
        "the drawing has more than 100000 line segments; simplify it or allow a larger tolerance"
    );
    let travels = "G0X1\nG0X2\n".repeat(75_001) + "oops";
    assert_eq!(
        error(&travels),
        "150001:1: found more than 150000 moves; expected at most that in a drawing; simplify it, or draw it in parts"
    );
    let mut speeds = "M3 S1\n".to_owned();
    for i in 0..1001 {
        writeln!(speeds, "G1 X{i} F{}", i + 1).unwrap();
        writeln!(speeds, "G1 X{i}.5").unwrap();
    }
    assert_eq!(
        error(&speeds),
        "the drawing has more than 1000 layers (pens, or speeds and powers of a laser)"
    );
}

/// As a laser program writes them.
fn written(strokes: &[Vec<(i32, i32)>]) -> String {
    let mut text = "G21 G90 M4\n".to_owned();
    for stroke in strokes {
        for (i, (x, y)) in stroke.iter().enumerate() {
            let word = if i == 0 { "G0" } else { "G1" };
            let [x, y] = [x, y].map(|value| f64::from(*value) / 100.0);
            writeln!(text, "{word} X{x} Y{y} S{}", i.min(1) * 255).unwrap();
        }
    }
    text + "M5\n"
}

fn strokes() -> impl Strategy<Value = Vec<Vec<(i32, i32)>>> {
    let corner = (-10_000..10_000, -10_000..10_000);
    prop::collection::vec(prop::collection::vec(corner, 2..9), 1..9)
}

proptest! {
    #[test]
    fn strokes_are_read_as_they_were_written(strokes in strokes()) {
        let (artwork, _) = draw(&written(&strokes));
        let all = || strokes.iter().flatten();
        let left = all().map(|item| item.0).min().unwrap();
        let top = all().map(|item| item.1).max().unwrap();
        let wanted = strokes.iter().flat_map(|stroke| stroke.windows(2)).filter(|stroke| stroke[0] != stroke[1]);
        let found = artwork.layers.iter().flat_map(|layer| &layer.strokes).flat_map(Stroke::segments);
        let place = |&(x, y): &(i32, i32)| Point::new(0.01 * f64::from(x - left), 0.01 * f64::from(top - y));
        let wanted: Vec<_> = wanted.map(|wanted| (place(&wanted[0]), place(&wanted[1]))).collect();
        let found: Vec<_> = found.collect();
        prop_assert_eq!(found.len(), wanted.len());
        for (found, wanted) in found.iter().zip(&wanted) {
            prop_assert!(found.0.distance(wanted.0) < 1e-6 && found.1.distance(wanted.1) < 1e-6);
        }
    }

    #[test]
    fn no_text_makes_it_panic(text in ".{0,200}") {
        let _ = super::read(text.as_bytes(), &ReadOptions::default());
    }

    #[test]
    fn no_words_make_it_panic(text in "([GMXYZIJRPSFT]-?[0-9.]{1,4}[ \n*(;]?){0,60}") {
        if let Ok((artwork, _)) = super::read(text.as_bytes(), &ReadOptions::default()) {
            prop_assert!(artwork.points().all(|p| p.x.is_finite() && p.y.is_finite()));
        }
    }
}

#[test]
fn an_arc_that_extends_too_far_on_its_far_side_is_refused() {
    for center in ["I-900000", "I900000", "J-900000", "J900000"] {
        let message = error(&format!("M3 S9\nG3 {center} F9"));
        assert!(message.starts_with("2:1: leads to ("), "{message}");
        assert!(
            message.ends_with("at most 1000000 mm from the origin are allowed"),
            "{message}"
        );
    }
}

#[test]
fn a_truncated_file_gives_less_or_an_error() {
    let text = "(made by hand)\nG21 G90\nM4 S0\nG0 X10 Y10\nG1 X20 S500 F1200\nG3 X10 Y20 I-10\nM5\nG0 X0 Y0\n%";
    let whole = layers(text)[0].strokes[0].length_mm();
    for end in 0..text.len() {
        if let Ok((artwork, _)) = super::read(&text.as_bytes()[..end], &ReadOptions::default()) {
            let strokes = artwork.layers.iter().flat_map(|layer| &layer.strokes);
            let length: f64 = strokes.map(Stroke::length_mm).sum();
            assert!(length <= whole + 1e-9, "{end}: {length}");
        }
    }
}
