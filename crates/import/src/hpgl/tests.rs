#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

mod labels;
mod windows;

use std::f64::consts::PI;
use std::fmt::Write as _;

use dobot_geometry::{Point, Stroke, bounds_of_strokes};
use proptest::prelude::*;

use super::*;
use crate::artwork::Layer;
use crate::source::refuse_mistakes;

fn draw(text: &str) -> (Artwork, Vec<String>) {
    let (artwork, warnings) = super::read(text.as_bytes(), &ReadOptions::default()).unwrap();
    (artwork, warnings.iter().map(Warning::to_string).collect())
}

fn strokes(text: &str) -> Vec<Stroke> {
    let layers = draw(text).0.layers;
    layers.into_iter().flat_map(|layer| layer.strokes).collect()
}

fn corners(text: &str) -> Vec<Vec<(f64, f64)>> {
    let round = |x: f64| (x * 1e6).round() / 1e6 + 0.0;
    let corners = |stroke: &Stroke| {
        stroke
            .points
            .iter()
            .map(|p| (round(p.x), round(p.y)))
            .collect()
    };
    strokes(text).iter().map(corners).collect()
}

/// The error of a file in which no mistake is allowed.
fn error(text: &[u8]) -> String {
    let read = super::read(text, &ReadOptions::default());
    let refused = read.and_then(|(_, warnings)| refuse_mistakes(&warnings));
    refused.unwrap_err().to_string()
}

#[test]
fn forty_units_are_a_millimetre_and_y_points_up() {
    let text = "IN;SP1;PU400,400;PD800,400,800,1200;PU;SP0;";
    assert_eq!(corners(text), [[(0.0, 20.0), (10.0, 20.0), (10.0, 0.0)]]);
    let (artwork, warnings) = draw(text);
    assert_eq!((artwork.width_mm, artwork.height_mm), (10.0, 20.0));
    assert_eq!(artwork.layers[0].name, "pen 1");
    assert!(warnings.is_empty(), "{warnings:?}");
}

#[test]
fn corners_in_percent_need_a_sheet_unless_they_only_shift_the_scale() {
    let text = "PS11056,7977;RO90;IP0,0,1016,-1016;IR0,100;SC0,300,0,300;SP1;PA0,0;PD300,150;";
    let round = |mm: f64| (mm * 1e6).round() / 1e6;
    let size = |artwork: &Artwork| [round(artwork.width_mm), round(artwork.height_mm)];
    let (artwork, warnings) = draw(text);
    assert_eq!(size(&artwork), [12.7, 25.4]);
    assert!(warnings.is_empty(), "{warnings:?}");
    let (artwork, warnings) = draw(&text.replace("PS11056,7977;", ""));
    assert_eq!(size(&artwork), [12.7, 25.4]);
    assert_eq!(
        warnings,
        [
            "1:23: 1 shift of the scale: left out, because the size of the sheet is unknown (IR without PS)"
        ]
    );
    // Both corners, of a sheet of 100 mm by 50.
    let (artwork, warnings) = draw("PS4000,2000;IR10,20,60,70;SC0,1,0,1;PA0,0;PD1,1");
    assert_eq!(size(&artwork), [50.0, 25.0]);
    assert!(warnings.is_empty(), "{warnings:?}");
    let unknown = error(b"IP0,0,9,9;IR10,20,60,70;SC0,1,0,1;PA0,0;PD1,1");
    assert!(
        unknown.contains("the size of the sheet is unknown"),
        "{unknown}"
    );
    let three = error(b"PS4000,2000;IR1,2,3");
    assert!(
        three.ends_with("found IR 1,2,3; expected x,y of P1, or of P1 and of P2, in percent"),
        "{three}"
    );
}

#[test]
fn everything_before_a_mistake_is_drawn_and_the_mistake_is_reported() {
    let line = [[(0.0, 0.0), (10.0, 0.0)]];
    for (mistake, place) in [
        ("PD800,abc,7", "1:17: "),
        ("PD;PD800,0,5;", "1:20: "),
        (";5;PD800,800", "1:18: "),
        ("LBwithout an end", "1:17: "),
        ("PD;VS-1;", "1:20: "),
        ("PD99999999,0", "1:17: "),
    ] {
        let text = format!("PU0,0;PD400,0;PU{mistake};PU;PD900,900");
        let (artwork, warnings) = draw(&text);
        let strokes = artwork.layers.iter().flat_map(|layer| &layer.strokes);
        let ends =
            strokes.map(|stroke| stroke.points.iter().map(|p| (p.x, p.y)).collect::<Vec<_>>());
        assert_eq!(ends.collect::<Vec<_>>(), line, "{text}");
        let [warning] = &warnings[..] else {
            panic!("{text}: {warnings:?}");
        };
        assert!(
            warning.ends_with(": the rest of the file is left out"),
            "{warning}"
        );
        assert!(warning.starts_with(place), "{warning}");
    }
}

#[test]
fn the_last_encoded_lines_of_autocad_are_drawn_although_they_have_no_semicolon() {
    // 40 units to the right, twice: 80 in base 64 is 16 and 1.
    let short: &[u8] = b"PU0,0;PE\x4f\xc0\xbf\x4f\xc0\xbfPUSP0;PG;";
    // As AutoCAD writes it: from (1495, 471) to (354, 354), in 25.4 mm / 300.
    let autocad: &[u8] = b"\x1b%0BBPINPS1640,1640ECIP0,0,1016,-1016SC0,300,0,300SP1PU\
        PA0,0PE<=m\xedm\xcd=C\xcaC\xcaPUSP0;PG;";
    for (text, expected_mm) in [(short, 2.0), (autocad, 97.1)] {
        let (artwork, warnings) = super::read(text, &ReadOptions::default()).unwrap();
        let strokes = artwork.layers.iter().flat_map(|layer| &layer.strokes);
        let found_mm: f64 = strokes.map(Stroke::length_mm).sum();
        assert!(
            (found_mm - expected_mm).abs() < 0.05,
            "{found_mm} mm, expected {expected_mm} mm"
        );
        assert_eq!(warnings.len(), 1, "{warnings:?}");
    }
}

#[test]
fn ticks_are_fractions_of_the_distance_between_the_corners() {
    // P1 and P2 are 100 mm and 50 mm apart.
    let of = |text: &str| corners(&format!("IP0,0,4000,2000;PU2000,1000;{text}"));
    assert_eq!(of("TL4,2;XT"), [[(0.0, 3.0), (0.0, 0.0)]]);
    assert_eq!(of("TL4,2;YT"), [[(0.0, 0.0), (6.0, 0.0)]]);
    assert_eq!(of("TL4;XT"), [[(0.0, 2.0), (0.0, 0.0)]]);
    assert_eq!(of("TL0,4;YT"), [[(0.0, 0.0), (4.0, 0.0)]]);
    for default in ["XT", "TL9,9;TL;XT", "TL9,9;DF;PU2000,1000;XT"] {
        assert_eq!(of(default), [[(0.0, 0.5), (0.0, 0.0)]], "{default}");
    }
    assert_eq!(of("TL4,2;RO90;PU2000,1000;XT"), [[(3.0, 0.0), (0.0, 0.0)]]);
    // The pen stays where it is, down or up.
    let line = of("TL4,0;PD;XT;PD2400,1000;");
    assert_eq!(line, [[(0.0, 2.0), (0.0, 0.0)], [(0.0, 2.0), (10.0, 2.0)]]);
    let (_, warnings) = draw("PU2000,1000;XT;YT");
    assert_eq!(
        warnings,
        ["1:13: 2 sizeless ticks: drawn as for an A4 sheet (TL without IP)"]
    );
}

#[test]
fn a_square_is_the_same_in_any_notation() {
    for text in [
        "PA0,0;PD;PA40,0;PA40,40;PA0,40;PA0,0;PU;",
        "pu0 0pd40 0 40 40 0 40 0 0pu",
        "PD;PR40,0,0,40,-40,0,0,-40",
        "IN\nPU 0,0\nPD 40 , 0\nPD40,40,0,40\r\nPD+0.0,0",
        "ER40,40;",
        "PA40,40;EA0,0",
        "PM0;PD40,0,40,40,0,40;PM2;EP;",
        "PM;PR40,0,0,40,-40,0,0,-40;PM2;EP",
        "\u{1b}.(;IN;SP1;\u{1b}.I81;;17:PA0,0PD40,0,40,40,0,40,0,0",
        "\u{1b}%-12345X@PJL ENTER LANGUAGE=HPGL2\n\u{1b}EPA0,0PD40,0,40,40,0,40,0,0\u{1b}%0A",
        "\u{1b}E\u{1b}&l1o26A\u{1b}*p+0x-3Y\u{1b}%0BPA0,0PD40,0,40,40,0,40,0,0\u{1b}%0A\u{1b}E",
        "IP0,0,40,40;SC0,1,0,1;PA0,0PD1,0,1,1,0,1,0,0",
        "IP0,0,80,40;SC0,1,0,1,1;PA0,0PD1,0,1,1,0,1,0,0",
        "SC0,4,0,4,2;PA0,0PD10,0,10,10,0,10,0,0",
    ] {
        let strokes = strokes(text);
        assert_eq!(strokes.len(), 1, "{text}");
        let bounds = bounds_of_strokes(&strokes);
        assert!((bounds.width() - 1.0).abs() < 1e-9, "{text}: {bounds:?}");
        assert!((bounds.height() - 1.0).abs() < 1e-9, "{text}: {bounds:?}");
        assert!(
            (strokes[0].length_mm() - 4.0).abs() < 1e-9 && strokes[0].closed,
            "{text}"
        );
    }
}

#[test]
fn scaled_units_are_stretched_into_their_corners() {
    let text = "IP1000,1000,5000,3000;SC0,100,0,100;PU0,0PD100,0,100,100";
    assert_eq!(corners(text), [[(0.0, 50.0), (100.0, 50.0), (100.0, 0.0)]]);
    // The pen stays where it is when the units change.
    let text = "IP0,0,4000,4000;SC0,100,0,100;PU50,50;SC;PD4000,2000";
    assert_eq!(corners(text), [[(0.0, 0.0), (50.0, 0.0)]]);
    let (_, warnings) = draw("SC0,1,0,1;PD1,1");
    assert_eq!(
        warnings,
        ["1:1: 1 cornerless scale: read as that of an A4 sheet (SC without IP)"]
    );
}

#[test]
fn a_turned_plot_is_rotated_counterclockwise() {
    assert_eq!(
        corners("RO90;PD400,0,400,40"),
        [[(1.0, 10.0), (1.0, 0.0), (0.0, 0.0)]]
    );
    assert_eq!(
        corners("RO180;PD400,0,400,40"),
        [[(10.0, 0.0), (0.0, 0.0), (0.0, 1.0)]]
    );
    assert_eq!(
        corners("RO270;PD400,0,400,40"),
        [[(0.0, 0.0), (0.0, 10.0), (1.0, 10.0)]]
    );
}

#[test]
fn each_pen_is_a_layer_with_its_speed() {
    let text = "SP1;VS20;PD40,0;PU;SP2;VS5;PD40,40;PU;SP1;VS20;PD0,0;PU;SP;PD9,9;";
    let (artwork, warnings) = draw(text);
    let found: Vec<_> = artwork
        .layers
        .iter()
        .map(|layer| (layer.name.as_str(), layer.speed_mm_s))
        .collect();
    assert_eq!(found, [("pen 1", Some(200.0)), ("pen 2", Some(50.0))]);
    assert_eq!(artwork.layers[0].strokes.len(), 2);
    assert_eq!(warnings, ["1:60: 1 penless line: left out (SP 0)"]);
}

#[test]
fn pens_have_the_colours_assigned_to_them_and_pen_0_draws_with_one() {
    let (artwork, warnings) = draw(
        "IN;PC1,255,0,0;PC0,128,128,128;SP1;PD40,0;PU;SP0;PD40,40;PU;PC0,255,255,255;SP0;PD0,0;",
    );
    let found: Vec<_> = artwork
        .layers
        .iter()
        .map(|layer| (layer.name.as_str(), layer.color))
        .collect();
    assert_eq!(
        found,
        [("pen 1", Some([255, 0, 0])), ("pen 0", Some([128; 3]))]
    );
    assert_eq!(warnings.len(), 1, "{warnings:?}");
}

#[test]
fn a_pen_that_only_touches_leaves_a_dot() {
    assert_eq!(
        corners("PU40,40;PD;PU;PA80,40;PD80,40;PU120,40"),
        [[(0.0, 0.0)], [(1.0, 0.0)]]
    );
}

/// How far lines leave a circle, and their length.
fn on_circle(strokes: &[Stroke], center: Point, radius: f64) -> (f64, f64) {
    let middles = strokes
        .iter()
        .flat_map(|stroke| stroke.segments().map(|(a, b)| a.lerp(b, 0.5)));
    let off = middles
        .map(|p| (p.distance(center) - radius).abs())
        .fold(0.0, f64::max);
    (off, strokes.iter().map(Stroke::length_mm).sum())
}

#[test]
fn circles_arcs_and_wedges_stay_within_the_tolerance() {
    let center = Point::new(10.0, 10.0);
    for text in [
        "PA800,0;CI400;",
        "PU400,0;PD;AA0,0,360;PU",
        "PU400,0;PD;AR-400,0,-180,5;AA0,0,-180",
        "PU400,0PDRT-400,400,-800,0;AT0,-400,400,0",
        "EW400,30,360;",
        "PM0;PM1;CI400;PM2;EP",
    ] {
        let strokes = strokes(text);
        let (off, length) = on_circle(&strokes, center, 10.0);
        // The page begins where the lines do, which may be inside the circle.
        assert!(off < 0.011, "{text}: {off}");
        assert!((length - 20.0 * PI).abs() < 0.05, "{text}: {length}");
        assert!(strokes[0].closed, "{text}");
    }
    // Stretched units make ellipses.
    let (artwork, _) = draw("IP0,0,800,400;SC-1,1,-1,1;CI1");
    assert!((artwork.width_mm - 20.0).abs() < 0.01 && (artwork.height_mm - 10.0).abs() < 0.01);
    // A quarter of a cake: two straight sides and a quarter of the way around.
    let cake = strokes("EW400,0,90");
    let wanted = 20.0 + 5.0 * PI;
    assert!(cake[0].closed && (cake[0].length_mm() - wanted).abs() < 0.02);
}

/// The polygons that old programs draw as circles of few chords.
#[test]
fn arcs_have_the_requested_chords() {
    let corners = |text: &str| -> Vec<[f64; 2]> {
        let points = strokes(text)[0].points.clone();
        points.iter().map(|p| [p.x, p.y]).collect()
    };
    let near = |found: &[[f64; 2]], wanted: &[[f64; 2]]| {
        let off = found.iter().zip(wanted);
        let off = off.map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]));
        assert_eq!(found.len(), wanted.len(), "{found:?}");
        assert!(off.fold(0.0, f64::max) < 1e-9, "{found:?}");
    };
    // A square that stands on a corner, 20 mm wide; the page begins where it does, its down is y.
    let square = [
        [20.0, 10.0],
        [10.0, 0.0],
        [0.0, 10.0],
        [10.0, 20.0],
        [20.0, 10.0],
    ];
    near(&corners("PA2000,2000;CI400,90"), &square);
    assert_eq!(corners("CI400,120").len(), 4);
    assert_eq!(corners("CI400,100").len(), 5);
    // From the left for a radius below 0.
    near(
        &corners("CI-400,180"),
        &[[0.0, 0.0], [20.0, 0.0], [0.0, 0.0]],
    );
    for half in ["PU400,0PDAA0,0,180,60", "PU400,0PDAT0,400,-400,0,60"] {
        let high_mm = 10.0 * 0.75_f64.sqrt();
        let wanted = [[20.0, high_mm], [15.0, 0.0], [5.0, 0.0], [0.0, high_mm]];
        near(&corners(half), &wanted);
    }
    assert_eq!(corners("EW400,0,90,45").len(), 5);
    // Round: at most the chords of a plotter.
    assert!(corners("CI400,5").len() > 72);
    assert_eq!(corners("CT1;CT0;CI400,90").len(), 5);
    assert_eq!(corners("CT1;IN;CI400,90").len(), 5);
}

#[test]
fn an_unsupported_chord_angle_becomes_the_nearest_supported_one() {
    let corners = |text: &str| strokes(text)[0].points.len();
    // To the other side and back.
    assert_eq!(corners("CI400,180"), 3);
    for large in ["CI400,200", "CI400,99999999", "CI400,-360"] {
        assert_eq!(corners(large), 3, "{large}");
    }
    // Its sign means nothing.
    assert_eq!(corners("CI400,-90"), corners("CI400,90"));
    for small in ["CI400,0", "CI400,-5", "CI400,0.000001"] {
        assert_eq!(corners(small), corners("CI400"), "{small}");
    }
}

#[test]
fn chords_given_by_their_deviation_from_the_arc_have_that_deviation() {
    let corners = |text: &str| strokes(text)[0].points.len();
    // A chord over the angle a leaves a circle by r (1 - cos(a / 2)): by half of r over 120
    // degrees.
    assert_eq!(corners("CT1;CI400,200"), 4);
    // Over 60 degrees by 1 - cos 30 degrees, 0.134 of r.
    assert_eq!(corners("CT1;PU400,0PDAA0,0,180,53.6"), 4);
    // No farther than the circle is wide.
    for large in ["400", "800", "99999999"] {
        assert_eq!(corners(&format!("CT1;CI400,{large}")), 3, "{large}");
    }
    // By 0.1 of 400 units over 2.6 degrees, which is smooth.
    assert_eq!(corners("CT1;CI400,0.1"), corners("CI400"));
    for nothing in ["CT1;CI0,90", "CT1;CI0,0", "CI0,90"] {
        _ = super::read(nothing.as_bytes(), &ReadOptions::default());
    }
}

#[test]
fn curves_follow_their_control_points() {
    // A parabola raised to a cubic: y = x (1 - x) between 0 and 1, 40 mm wide.
    let text = "PD;BZ533.3333333,533.3333333,1066.6666667,533.3333333,1600,0";
    let strokes = strokes(text);
    let height = |p: &Point| (40.0 - p.x) * p.x / 40.0;
    for p in &strokes[0].points {
        assert!((10.0 - p.y - height(p)).abs() < 0.006, "{p:?}");
    }
    let relative = "PU80,80;PD;BR533.3333333,533.3333333,1066.6666667,533.3333333,1600,0";
    assert!((draw(relative).0.height_mm - 10.0).abs() < 0.006);
}

#[test]
fn filled_shapes_are_areas() {
    let areas = |text: &str| -> Vec<_> {
        let layers: Vec<Layer> = draw(text).0.layers;
        layers.into_iter().flat_map(|layer| layer.areas).collect()
    };
    assert_eq!(areas("RR40,40")[0].rings[0].len(), 5);
    assert_eq!(areas("PA40,0RA0,80WG400,0,90").len(), 2);
    let ring = areas("PM0;PD400,0,400,400,0,400;PM1;PU100,100;PD300,100,300,300;PM2;FP");
    let lengths: Vec<_> = ring[0].rings.iter().map(Vec::len).collect();
    assert_eq!(lengths, [5, 4]);
}

#[test]
fn the_edges_of_areas_are_drawn_once() {
    for text in ["PA40,0RA0,80", "PA40,0RA0,80EA0,80", "PA40,0EA0,80RA0,80"] {
        let layer = &draw(text).0.layers[0];
        assert_eq!((layer.areas.len(), layer.strokes.len()), (1, 1), "{text}");
        // A step is 0.025 mm.
        assert!((layer.strokes[0].length_mm() - 6.0).abs() < 1e-9);
    }
    let polygon = "PM0;PD400,0,400,400,0,400;PM1;PU100,100;PD300,100,300,300;PM2;FP";
    assert_eq!(draw(polygon).0.layers[0].strokes.len(), 2);
    assert_eq!(draw(&format!("{polygon};EP")).0.layers[0].strokes.len(), 2);
}

#[test]
fn edges_followed_with_a_lifted_pen_are_not_drawn() {
    let lengths_mm = |text: &str| {
        let (artwork, warnings) = draw(text);
        assert_eq!(warnings, [""; 0]);
        let layers = artwork.layers.iter().flat_map(|layer| &layer.strokes);
        layers
            .map(Stroke::length_mm)
            .map(f64::round)
            .collect::<Vec<_>>()
    };
    // An open line, as GNU plotutils writes it.
    assert_eq!(lengths_mm("PU0,0;PM0;PD1600,0,1600,800;PU;PM2;EP"), [60.0]);
    assert_eq!(lengths_mm("PU0,0;PM0;PD1600,0,1600,1200;PM2;EP"), [120.0]);
    // In the middle of a ring, by an arc too, and all of it.
    let square = "PU0,0;PM0;PD400,0;PU400,400;PD0,400;PM2;EP";
    assert_eq!(lengths_mm(square), [10.0, 20.0]);
    let arc = "PU0,0;PM0;PD400,0;PU;AA400,200,180;PD0,400;PM2;EP";
    assert_eq!(lengths_mm(arc), [10.0, 20.0]);
    // A filled shape has all of its edges, and so has a ring for which the pen was never lowered.
    assert_eq!(
        lengths_mm("PU0,0;PM0;PD1600,0,1600,1200;PU;PM2;FP"),
        [120.0]
    );
}

/// The length of all visible lines, in mm.
fn shown_mm(text: &str) -> f64 {
    let hides = ReadOptions {
        hides: true,
        ..ReadOptions::default()
    };
    let (artwork, _) = super::read(text.as_bytes(), &hides).unwrap();
    let strokes = artwork.layers.iter().flat_map(|layer| &layer.strokes);
    strokes.map(Stroke::length_mm).sum()
}

#[test]
fn filled_shapes_hide_the_shapes_below() {
    // 60 mm long, and a square of 20 mm over its middle.
    let line = "SP1;PU0,400;PD2400,400;PU";
    let [square, edge] = ["RA", "EA"].map(|name| format!("SP2;PU800,0;{name}1600,800"));
    let polygon = "SP2;PU800,0;PM0;PD1600,0,1600,800,800,800;PM2;FP";
    let cake = "SP2;PU1200,400;WG400,0,360";
    for (text, expected_mm) in [
        (format!("{line};{square}"), 40.0 + 80.0),
        (format!("{square};{line}"), 60.0 + 80.0),
        (format!("{line};{edge}"), 60.0 + 80.0),
        (format!("{line};{polygon}"), 40.0 + 80.0),
        (format!("{line};{square};{edge}"), 40.0 + 80.0),
        (format!("FT2;{line};{square}"), 40.0 + 80.0),
        // A pattern lets it show.
        (format!("FT3,40,45;{line};{square}"), 60.0 + 80.0),
        (format!("FT3,40,45;FT;{line};{square}"), 40.0 + 80.0),
        (format!("FT3,40,45;IN;{line};{square}"), 40.0 + 80.0),
        (format!("{line};{cake}"), 40.0 + 20.0 * std::f64::consts::PI),
    ] {
        let found_mm = shown_mm(&text);
        assert!(
            (found_mm - expected_mm).abs() < 0.1,
            "{text}: {found_mm} mm, expected are {expected_mm} mm"
        );
    }
    let (artwork, _) = draw(&format!("{line};{square}"));
    let strokes = artwork.layers.iter().flat_map(|layer| &layer.strokes);
    let drawn_mm: f64 = strokes.map(Stroke::length_mm).sum();
    assert!((drawn_mm - 140.0).abs() < 1e-6, "{drawn_mm}");
}

/// Numbers as PE packs them.
fn packed(numbers: &[i64], has_7_bits: bool) -> Vec<u8> {
    let (bits, last) = if has_7_bits { (5, 95) } else { (6, 191) };
    let mut bytes = Vec::new();
    for number in numbers {
        let mut rest = number.unsigned_abs() << 1 | u64::from(*number < 0);
        while rest >> bits > 0 {
            bytes.push(63 + u8::try_from(rest & ((1 << bits) - 1)).unwrap());
            rest >>= bits;
        }
        bytes.push(last + u8::try_from(rest).unwrap());
    }
    bytes
}

#[test]
fn packed_lines_are_read() {
    // By hand: 40 is 80 doubled, 16 + 1 * 64 in base 64 and 16 + 2 * 32 in base 32.
    let in_8_bits = b"PU0,0;PE<\xBF\xBF\x4F\xC0\xBF\xBF\x4F\xC0;";
    let in_7_bits = b"PU0,0;PE7<__O a__Oa;";
    for text in [in_8_bits.as_slice(), in_7_bits] {
        let (artwork, _) = super::read(text, &ReadOptions::default()).unwrap();
        assert_eq!(artwork.layers[0].strokes[0].points.len(), 3);
        assert_eq!((artwork.width_mm, artwork.height_mm), (1.0, 1.0));
    }
    // A pen, an absolute place with the pen up, and a fraction of two bits.
    let mut text = b"PE:".to_vec();
    text.extend(packed(&[3], false));
    text.extend(b"<=");
    text.extend(packed(&[400, 400], false));
    text.extend(b">");
    text.extend(packed(&[2], false));
    text.extend(packed(&[160, 0], false));
    let (artwork, _) = super::read(&text, &ReadOptions::default()).unwrap();
    assert_eq!(
        (artwork.width_mm, artwork.layers[0].name.as_str()),
        (1.0, "pen 3")
    );
}

/// The extents of the lines of a plot along X, in hundredths of a millimetre.
fn spans(text: &str) -> Vec<[f64; 2]> {
    let ends = |stroke: &Stroke| [stroke.points[0].x, stroke.points[stroke.points.len() - 1].x];
    let round = |x: f64| (x * 100.0).round();
    strokes(text)
        .iter()
        .map(|stroke| ends(stroke).map(round))
        .collect()
}

#[test]
fn lines_are_dashed_by_their_type() {
    // 10 mm of pattern, half of it a dash, along 30 mm; then solid again, and the type before once
    // more.
    let dashes = [[0.0, 500.0], [1000.0, 1500.0], [2000.0, 2500.0]];
    let solid = [0.0, 3000.0];
    let line = "PU0,0;PD1200,0;PU;";
    assert_eq!(spans(&format!("LT2,10,1;{line}")), dashes);
    let all = [&dashes[..], &[solid], &dashes].concat();
    assert_eq!(spans(&format!("LT2,10,1;{line}LT;{line}LT99;{line}")), all);
    assert_eq!(spans(&format!("LT2,10,1;{line}IN;{line}")), all[..4]);
    // In percent of the way from P1 to P2, which is 125 mm: 10 mm, and 5 mm by default.
    let corners = "IP0,0,3000,4000;";
    assert_eq!(spans(&format!("{corners}LT2,8;{line}")), dashes);
    assert_eq!(
        spans(&format!("IP0,0,1500,2000;LT2,8;{corners}{line}")),
        dashes
    );
    let short = [[0.0, 350.0], [500.0, 850.0]];
    assert_eq!(spans(&format!("{corners}LT3;PD400,0;")), short);
}

#[test]
fn the_dashes_of_a_line_continue_around_its_corners() {
    // 4 mm and 4 mm more: the second dash goes from 5 to 7.5 mm, and so the ink is 3.5 mm tall.
    let found = corners("LT2,5,1;PD160,0,160,160;");
    let second = [(4.0, 2.5), (4.0, 0.0)];
    assert_eq!(found, [vec![(0.0, 3.5), (2.5, 3.5)], second.to_vec()]);
}

#[test]
fn line_types_can_be_defined_and_letters_are_never_dashed() {
    let line = "PU0,0;PD400,0;PU;";
    let own = [[0.0, 100.0], [500.0, 500.0]];
    assert_eq!(spans(&format!("UL4,10,40,0,50;LT4,10,1;{line}")), own);
    let defaults = [[0.0, 800.0], [900.0, 900.0]];
    assert_eq!(spans(&format!("UL4,1,1;UL;LT4,10,1;{line}")), defaults);
    assert_eq!(spans(&format!("UL4,1,1;LT4,10,1;UL4;{line}")), defaults);
    // Half a dash at the begin of a line, which need not end with one.
    let half = [[0.0, 250.0], [750.0, 1000.0]];
    assert_eq!(spans(&format!("LT-2,10,1;{line}")), half);
    let count = |text: &str| strokes(text).len();
    let letters = "SI1,1.5;PU0,0;LBHO\u{3}";
    assert_eq!(count(&format!("LT2,1,1;{letters}")), count(letters));
    assert_eq!(
        error(b"UL9,1,1;PD40,0"),
        "1:1: found UL 9,1,1; expected a line type from 1 to 8, and its dashes and gaps"
    );
    assert_eq!(
        error(b"UL2,0,0;PD40,0"),
        "1:1: found UL 2,0,0; expected up to 20 dashes and gaps, not all of them 0"
    );
}

#[test]
fn skipped_commands_are_named_with_their_place_and_count() {
    let text =
        "IN;LT0;PD40,0;\nLBSP1;text;\u{3}LT;DT$;LBmore$PU;ZZ1,2;\nFT3;PG;PD0,0;SI.2,.3;RO90;";
    let (_, warnings) = draw(text);
    assert_eq!(
        warnings,
        [
            "1:4: 1 line type without a pattern: drawn solid (LT)",
            "2:1: 2 sizeless texts: written as for an A4 sheet, 1.87 mm wide, 2.69 mm tall (no SI or SR)",
            "2:30: 1 ZZ command: unknown, left out",
            "3:1: 1 fill pattern: filled like all other areas (FT)",
            "3:8: 1 further page: drawn on the same sheet (PG)",
            "3:22: 1 late rotation: rotated about the origin instead of the sheet, because the size of the sheet is unknown (RO)",
        ]
    );
}

#[test]
#[expect(clippy::too_many_lines, reason = "a table")]
fn an_undrawable_command_is_refused_with_its_place() {
    for (text, expected) in [
        (
            &b""[..],
            "nothing to draw: no command draws with a pen down",
        ),
        (
            b"IN;PU5,5;SP1;",
            "nothing to draw: no command draws with a pen down",
        ),
        (
            b"SP0;PD5,5;",
            "nothing to draw: no command draws with a pen down; 1:5: 1 penless line: left out (SP 0)",
        ),
        (
            b"PD1,2;\n1,2",
            "2:1: found \"1,2\"; expected a command of two letters such as PD",
        ),
        (
            b"PD1,2;P",
            "1:7: found \"P\"; expected a command of two letters such as PD",
        ),
        (
            b"PD1,2,3;",
            "1:1: found PD 1,2,3; expected pairs of coordinates x,y",
        ),
        (
            b"PD1,--2;",
            "1:5: found \"--2;\"; expected a number such as 40 or -2.5",
        ),
        (
            b"PD1,1.2.3;",
            "1:5: found \"1.2.3;\"; expected a number such as 40 or -2.5",
        ),
        (
            b"PD1,99999999999;",
            "1:5: found \"99999999999;\"; expected a number such as 40 or -2.5",
        ),
        (
            b"PD1:2",
            "1:4: found \":2\"; expected a number such as 40 or -2.5",
        ),
        (
            b"PD1,2;\xFF\xFE",
            "1:7: found \"\u{FFFD}\u{FFFD}\"; expected a command of two letters such as PD",
        ),
        (
            b"\x1B=PU",
            "1:1: found \"\\u{1b}=PU\"; expected an escape sequence of a plotter: ESC . or ESC %",
        ),
        (
            b"\x1B&l1O\x1B*b3W\x01\x02\x03",
            "1:6: found \"\\u{1b}*b3W\\u{1}\\u{2}\\u{3}\"; expected printer settings only; printer pictures and fonts (PCL) are not supported",
        ),
        (
            b"PD50000000,0",
            "1:1: leads to (1250000, 0) mm; at most 1000000 mm from the origin are allowed",
        ),
        (
            b"SC0,0,1,1",
            "1:1: found SC 0,0,1,1; expected a scale with a width and a height",
        ),
        (
            b"SC1,2,3",
            "1:1: found SC 1,2,3; expected x and y of P1 and P2 as SC x1,x2,y1,y2",
        ),
        (
            b"IP0,0,0,9",
            "1:1: found IP 0,0,0,9; expected x,y of P1 and of P2, different in both",
        ),
        (
            b"IR10,10",
            "1:1: found IR 10,10; expected IP, because the size of the sheet is unknown",
        ),
        (
            b"RO45",
            "1:1: found RO 45; expected a rotation of 0, 90, 180 or 270 degrees",
        ),
        (b"VS0", "1:1: found VS 0; expected a speed above 0 cm/s"),
        (b"CI", "1:1: found CI; expected a radius"),
        (
            b"AA1,2",
            "1:1: found AA 1,2; expected x,y of the center, and an angle",
        ),
        (
            b"AA1,2,500",
            "1:1: found AA 1,2,500; expected an angle from -360 to 360 degrees",
        ),
        (
            b"AT1,2",
            "1:1: found AT 1,2; expected x,y of an intermediate point, and of the end",
        ),
        (
            b"BZ1,2",
            "1:1: found BZ 1,2; expected six numbers for each curve",
        ),
        (
            b"EA1",
            "1:1: found EA 1; expected x,y of the opposite corner",
        ),
        (
            b"WG1",
            "1:1: found WG 1; expected a radius, and the angles of start and sweep",
        ),
        (b"PM3", "1:1: found PM 3; expected PM 0, PM 1 or PM 2"),
        (
            b"PD5,5;\nLBHello",
            "2:1: found a label without an end; expected ETX (character 3) after it, or the terminator set by DT",
        ),
        (
            b"DT#;BLHello\x03",
            "1:5: found a label without an end; expected ETX (character 3) after it, or the terminator set by DT",
        ),
        (
            b"SI0,1",
            "1:1: found SI 0,1; expected a width and a height other than 0",
        ),
        (
            b"SR1",
            "1:1: found SR 1; expected a width and a height other than 0",
        ),
        (b"DI1", "1:1: found DI 1; expected a direction as run,rise"),
        (
            b"LO10",
            "1:1: found LO 10; expected an origin from 1 to 9 or from 11 to 19",
        ),
        (
            b"CP1",
            "1:1: found CP 1; expected the numbers of spaces and lines, or nothing",
        ),
        (
            b"ES1,2,3",
            "1:1: found ES 1,2,3; expected the extra width and height of the character cells",
        ),
        (
            b"SI999999999,1;LBH\x03",
            "1:15: leads to (-2857142854, 0) mm; at most 1000000 mm from the origin are allowed",
        ),
        (
            b"LB \x03",
            "nothing to draw: no command draws with a pen down; 1:1: 1 sizeless text: written as for an A4 sheet, 1.87 mm wide, 2.69 mm tall (no SI or SR)",
        ),
        (
            b"PE!!;",
            "1:3: found \"!!\"; expected a digit of an encoded number",
        ),
        (
            b"PE<?;",
            "1:5: found the end of the file; expected a digit of an encoded number",
        ),
    ] {
        assert_eq!(error(text), expected, "{:?}", String::from_utf8_lossy(text));
    }
    let label = format!("LB{}\u{3}", "A".repeat(100_001));
    assert_eq!(
        error(label.as_bytes()),
        "1:1: found a label of 100001 characters; expected at most 100000; split it"
    );
    let circles = "CI39999999;".repeat(1000);
    let polygon = format!("PM0;{circles}");
    for text in [circles, polygon] {
        assert_eq!(
            error(text.as_bytes()),
            "the drawing has more than 100000 line segments; simplify it or allow a larger tolerance"
        );
    }
}

#[test]
fn a_truncated_file_gives_less_or_an_error() {
    let text =
        b"IN;SP1;PU0,0;PD400,0,400,400;CI100;PU;SP2;PE<\xBF\xBF\x4F\xC0\xBF;PA0,0;PD;AA0,80,90;PU;\
        DT#,1;SI.2,.3;DI0,1;LO5;SM*;PU9,9;LBA;\xE4#CP1,-1;BLb#PB;SP0;";
    for end in 0..text.len() {
        if let Ok((artwork, _)) = super::read(&text[..end], &ReadOptions::default()) {
            assert!(artwork.layers.len() <= 2);
        }
    }
}

fn lines() -> impl Strategy<Value = Vec<Vec<(i32, i32)>>> {
    let corner = (-9_000..9_000, -9_000..9_000);
    prop::collection::vec(prop::collection::vec(corner, 2..9), 1..9)
}

/// The segments of a plot, as they come onto the page, in mm.
fn wanted(lines: &[Vec<(i32, i32)>]) -> Vec<(Point, Point)> {
    let all = || lines.iter().flatten();
    let left = all().map(|item| item.0).min().unwrap();
    let top = all().map(|item| item.1).max().unwrap();
    let place =
        |&(x, y): &(i32, i32)| Point::new(0.025 * f64::from(x - left), 0.025 * f64::from(top - y));
    let pairs = lines.iter().flat_map(|line| line.windows(2));
    pairs
        .map(|pair| (place(&pair[0]), place(&pair[1])))
        .collect()
}

proptest! {
    #[test]
    fn lines_are_read_as_they_were_written(lines in lines(), encoded: bool, has_7_bits: bool) {
        let mut text = b"IN;SP1;".to_vec();
        let mut here = (0, 0);
        for line in &lines {
            if encoded {
                text.extend(if has_7_bits { b"PE7<" } else { &b"PE<"[..] });
                for &(x, y) in line {
                    text.extend(packed(&[i64::from(x - here.0), i64::from(y - here.1)], has_7_bits));
                    here = (x, y);
                }
                text.push(b';');
            } else {
                let mut written = String::new();
                for (i, (x, y)) in line.iter().enumerate() {
                    write!(written, "{}{x},{y};", if i == 0 { "PU" } else { "PD" }).unwrap();
                }
                text.extend(written.as_bytes());
            }
        }
        let (artwork, _) = super::read(&text, &ReadOptions::default()).unwrap();
        let found: Vec<_> = artwork.layers[0].strokes.iter().flat_map(Stroke::segments).collect();
        let mut wanted = wanted(&lines);
        wanted.retain(|wanted| wanted.0 != wanted.1);
        prop_assert_eq!(found.len(), wanted.len());
        for (found, wanted) in found.iter().zip(&wanted) {
            prop_assert!(found.0.distance(wanted.0) < 1e-6 && found.1.distance(wanted.1) < 1e-6);
        }
    }

    #[test]
    fn no_bytes_make_it_panic(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let _ = super::read(&bytes, &ReadOptions::default());
    }

    #[test]
    fn no_commands_make_it_panic(
        text in "((PU|PD|PA|PR|PE|CI|AA|AR|AT|BZ|EA|RR|EW|WG|PM|EP|FP|IP|SC|RO|SP|IN|DF|SI|SR|DI|DR|SL|ES|LO|CP|SM|DT|DV|SD|PB)[0-9,<.:;?_-]{0,20};?|(LB|BL)[ -~\\t\\r\\n\\x08äß漢]{0,9}[\\x03;#]){0,30}"
    ) {
        if let Ok((artwork, _)) = super::read(text.as_bytes(), &ReadOptions::default()) {
            prop_assert!(artwork.points().all(|p| p.x.is_finite() && p.y.is_finite()));
        }
    }
}

#[test]
fn numbers_may_have_exponents_but_commands_that_begin_with_e_are_not_exponents() {
    // A turned label of pstoedit.
    let label = |way: &str| corners(&format!("SI.5,.7;PU0,0;DI{way};LBHO\u{3}"));
    assert_eq!(label("4.48966e-09,100"), label("0,1"));
    let text = "PU0,0;PD4E2,0PU0,0EA400,400;";
    assert_eq!(corners(text).len(), 2);
}
