#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

mod blocks;
mod dashes;
mod far;
mod hiding;
mod mistakes;
mod multilines;
mod patterns;
mod text;
mod wide;

use std::f64::consts::PI;
use std::fmt::Write as _;
use std::slice;

use dobot_geometry::{Point, Stroke, bounds_of_strokes};
use proptest::prelude::*;

use super::*;
use crate::source::refuse_mistakes;

/// A file from pairs written in a line: `0 LINE 10 1.5`, in millimetres.
fn file(tables: &str, blocks: &str, entities: &str) -> String {
    let section = |name: &str, pairs: &str| format!("0 SECTION 2 {name} {pairs} 0 ENDSEC ");
    let header = section("HEADER", "9 $INSUNITS 70 4");
    let all = header + &section("TABLES", tables) + &section("BLOCKS", blocks);
    let all = all + &section("ENTITIES", entities) + "0 EOF";
    all.split_whitespace()
        .map(|word| word.to_owned() + "\n")
        .collect()
}

fn draw_text(text: &str) -> (Artwork, Vec<String>) {
    let (artwork, warnings) = super::read(text.as_bytes(), &ReadOptions::default()).unwrap();
    (artwork, warnings.iter().map(Warning::to_string).collect())
}

fn draw(entities: &str) -> (Artwork, Vec<String>) {
    draw_text(&file("", "", entities))
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
    let strokes = artwork.layers.iter().flat_map(|layer| &layer.strokes);
    strokes.map(corners).collect()
}

/// The error of a file in which no mistake is allowed.
fn error(text: &[u8]) -> String {
    let read = super::read(text, &ReadOptions::default());
    let refused = read.and_then(|(_, warnings)| refuse_mistakes(&warnings));
    refused.unwrap_err().to_string()
}

#[test]
fn more_objects_and_groups_than_fit_are_refused_with_their_place() {
    let many = file("", "", &"0 X ".repeat(1_000_000));
    let message = error(many.as_bytes());
    let expected =
        "found more than 1000000 entities, layers, blocks and objects; expected fewer; purge";
    assert!(message.contains(expected), "{message}");
    let wide = file(
        "",
        "",
        &format!("0 LWPOLYLINE {}", "10 1 20 2 ".repeat(500_001)),
    );
    let message = error(wide.as_bytes());
    let expected =
        "2000029:1: found an entity with more than 1000000 groups; expected fewer; simplify";
    assert_eq!(message.split(" it,").next(), Some(expected));
}

#[test]
fn an_overlong_text_is_refused() {
    for kind in ["TEXT", "MTEXT"] {
        let text = file(
            "",
            "",
            &format!("0 {kind} 10 0 20 0 40 5 1 {}", "A".repeat(100_001)),
        );
        let message = error(text.as_bytes());
        let expected = "found a text of 100001 bytes; expected at most 100000; split it";
        assert!(message.ends_with(expected), "{message}");
    }
}

#[test]
fn the_last_groups_of_a_layer_apply_and_too_many_layers_are_refused() {
    let layers = |count: usize| {
        let names: Vec<String> = (0..count)
            .map(|i| format!("0 LAYER 2 {i} 62 1 62 5"))
            .collect();
        let tables = format!("0 TABLE 2 LAYER {} 0 ENDTAB", names.join(" "));
        file(&tables, "", "0 CIRCLE 8 3 10 0 20 0 40 9")
    };
    let (artwork, _) = draw_text(&layers(5));
    assert_eq!(artwork.layers[0].color, Some([0, 0, 255]));
    let message = error(layers(95_000).as_bytes());
    assert!(
        message.contains("found more than 1000000 entities, layers"),
        "{message}"
    );
}

#[test]
fn many_entities_without_a_name_are_skipped_at_once() {
    let text = file("", "", "0 CIRCLE 10 0 20 0 40 9");
    let nameless = "0\n\n".repeat(300_000);
    let text = text.replace("0\nCIRCLE", &(nameless + "0\nCIRCLE"));
    assert_eq!(corners(&draw_text(&text).0).len(), 1);
}

#[test]
fn a_circle_that_extends_too_far_on_one_side_is_refused() {
    for far in ["10 -900000 20 0", "10 900000 20 0", "10 0 20 900000"] {
        let text = file("", "", &format!("0 CIRCLE {far} 40 900000"));
        let error = error(text.as_bytes());
        assert!(
            error.contains("at most 1000000 mm from the origin"),
            "{error}"
        );
    }
}

#[test]
fn a_drawing_far_from_its_origin_is_drawn_in_place() {
    let entities = |x: f64, y: f64| {
        format!(
            "0 LINE 10 {x} 20 {y} 11 {} 21 {} 0 CIRCLE 10 {x} 20 {y} 40 0.25
            0 TEXT 10 {x} 20 {y} 40 1 1 a 0 INSERT 2 a 10 {x} 20 {y}",
            x + 0.5,
            y + 0.125
        )
    };
    let blocks = "0 BLOCK 2 a 10 400 20 0 0 ARC 10 400 20 0 40 0.5 50 0 51 90 0 ENDBLK";
    let in_metres = |entities: &str| file("", blocks, entities).replace("70\n4\n", "70\n6\n");
    let (near, _) = draw_text(&in_metres(&entities(0.0, 0.0)));
    let (far, warnings) = draw_text(&in_metres(&entities(500_000.0, 5_400_000.0)));
    assert_eq!(warnings, [""; 0]);
    let points: Vec<Point> = far.points().collect();
    assert_eq!(points.len(), near.points().count());
    for (far, near) in points.iter().zip(near.points()) {
        assert!(far.distance(near) < 1e-5, "{far:?} {near:?}");
    }
}

#[test]
fn an_object_far_from_the_drawing_is_left_out_with_its_place() {
    let (artwork, warnings) =
        draw("0 LINE 10 3 20 4 11 13 21 4 0 POINT 10 3000000 20 0 0 POINT 10 5 20 5");
    assert_eq!(artwork.width_mm, 10.0);
    let message = "37:1: leads to (3000000, 0) mm; at most 1000000 mm from the origin are allowed: its object is left out";
    assert_eq!(warnings, [message]);
}

#[test]
fn lines_and_polylines_are_upright() {
    let triangle = [[(0.0, 20.0), (10.0, 20.0), (10.0, 0.0), (0.0, 20.0)]];
    for entities in [
        "0 LWPOLYLINE 8 0 90 3 70 1 10 5 20 5 10 15 20 5 10 15 20 25",
        "0 POLYLINE 8 0 66 1 70 1 0 VERTEX 10 5 20 5 0 VERTEX 10 15 20 5 0 VERTEX 10 15 20 25 0 SEQEND",
    ] {
        let (artwork, warnings) = draw(entities);
        assert_eq!(corners(&artwork), triangle, "{entities}");
        assert!(artwork.layers[0].strokes[0].closed && warnings.is_empty());
    }
    let (artwork, _) =
        draw("0 LINE 10 0 20 0 11 9 21 9 0 LINE 10 9 20 9 11 18 21 0 0 POINT 10 4 20 4");
    assert_eq!(
        corners(&artwork),
        [
            vec![(0.0, 9.0), (9.0, 0.0)],
            vec![(9.0, 0.0), (18.0, 9.0)],
            vec![(4.0, 5.0)]
        ]
    );
}

#[test]
fn the_unit_of_the_file_applies() {
    let line = "0 SECTION 2 ENTITIES 0 LINE 10 0 20 0 11 1 21 0 0 ENDSEC 0 EOF";
    for (unit, wanted, has_warning) in [
        ("9 $INSUNITS 70 1", 25.4, false),
        ("9 $INSUNITS 70 4", 1.0, false),
        ("9 $INSUNITS 70 5", 10.0, false),
        ("9 $INSUNITS 70 6", 1000.0, false),
        ("9 $INSUNITS 70 0", 1.0, true),
        ("9 $ACADVER 1 AC1009", 1.0, true),
    ] {
        let text = format!("0 SECTION 2 HEADER {unit} 0 ENDSEC {line}").replace(' ', "\r\n");
        let (artwork, warnings) = draw_text(&text);
        assert!((artwork.width_mm - wanted).abs() < 1e-9, "{unit}");
        let expected: &[&str] = &["1 file without a unit ($INSUNITS): taken for millimetres"];
        assert_eq!(warnings, &expected[..usize::from(has_warning)], "{unit}");
    }
}

/// The largest deviation of lines from a circle of this radius about the middle of their page, and
/// their length.
fn on_circle(artwork: &Artwork, radius: f64) -> (f64, f64) {
    let strokes = &artwork.layers[0].strokes;
    let center = bounds_of_strokes(strokes).center();
    let middles = strokes
        .iter()
        .flat_map(|stroke| stroke.segments().map(|(a, b)| a.lerp(b, 0.5)));
    let off = middles
        .map(|p| (p.distance(center) - radius).abs())
        .fold(0.0, f64::max);
    (off, strokes.iter().map(Stroke::length_mm).sum())
}

#[test]
fn circles_stay_within_the_tolerance_in_any_notation() {
    // A circle of nine control points, of which every second weighs the cosine of 45 degrees.
    let spline = "0 SPLINE 70 11 71 2 72 12 73 9
        40 0 40 0 40 0 40 1 40 1 40 2 40 2 40 3 40 3 40 4 40 4 40 4
        41 1 41 0.7071067811865476 41 1 41 0.7071067811865476 41 1
        41 0.7071067811865476 41 1 41 0.7071067811865476 41 1
        10 10 20 0 10 10 20 10 10 0 20 10 10 -10 20 10 10 -10 20 0
        10 -10 20 -10 10 0 20 -10 10 10 20 -10 10 10 20 0";
    for entities in [
        "0 CIRCLE 10 3 20 4 40 10",
        "0 ARC 10 3 20 4 40 10 50 90 51 90",
        "0 ARC 10 3 20 4 40 10 50 0 51 90 0 ARC 10 3 20 4 40 10 50 90 51 360",
        "0 ELLIPSE 10 3 20 4 11 6 21 8 40 1",
        "0 LWPOLYLINE 70 1 10 -10 20 0 42 1 10 10 20 0 42 1",
        "0 LWPOLYLINE 70 1 210 0 220 0 230 -1 10 -10 20 0 42 -1 10 10 20 0 42 -1",
        "0 LWPOLYLINE 10 10 20 0 42 0.41421356237 10 0 20 10 42 2.41421356237 10 10 20 0",
        spline,
    ] {
        let (artwork, _) = draw(entities);
        let (off, length) = on_circle(&artwork, 10.0);
        assert!(off < 0.011, "{entities}: {off}");
        assert!((length - 20.0 * PI).abs() < 0.1, "{entities}: {length}");
    }
}

#[test]
fn arcs_and_ellipses_turn_counterclockwise() {
    let (artwork, _) = draw("0 ARC 10 0 20 0 40 10 50 270 51 0");
    let ends = &artwork.layers[0].strokes[0].points;
    let (first, last) = (ends[0], ends[ends.len() - 1]);
    assert!(first.distance(Point::new(0.0, 10.0)) < 1e-6, "{first:?}");
    assert!(last.distance(Point::new(10.0, 0.0)) < 1e-6, "{last:?}");
    let (artwork, _) = draw("0 ELLIPSE 10 0 20 0 11 20 21 0 40 0.5 41 0 42 1.5707963267948966");
    assert!((artwork.width_mm - 20.0).abs() < 1e-6 && (artwork.height_mm - 10.0).abs() < 1e-6);
}

#[test]
fn an_ellipse_whose_axis_has_no_y_is_level() {
    let (artwork, warnings) = draw("0 ELLIPSE 10 5 20 5 11 20 40 0.5");
    let size = [artwork.width_mm, artwork.height_mm].map(f64::round);
    assert_eq!((size, warnings.len()), ([40.0, 20.0], 0));
}

#[test]
fn splines_follow_their_control_points() {
    // A Bézier curve: y = x (1 - x), 40 mm wide.
    let entities = "0 SPLINE 71 2 40 0 40 0 40 0 40 1 40 1 40 1 10 0 20 0 10 20 20 20 10 40 20 0";
    let (artwork, _) = draw(entities);
    for p in &artwork.layers[0].strokes[0].points {
        assert!(
            (10.0 - p.y - p.x * (40.0 - p.x) / 40.0).abs() < 0.006,
            "{p:?}"
        );
    }
}

#[test]
fn objects_in_world_coordinates_are_not_turned_for_any_extrusion() {
    for (entities, wanted) in [
        ("0 LINE 10 0 20 0 11 9 21 4", vec![(0.0, 4.0), (9.0, 0.0)]),
        ("0 LEADER 10 0 20 0 10 9 20 4", vec![(0.0, 4.0), (9.0, 0.0)]),
        (
            "0 3DFACE 10 0 20 0 11 9 21 0 12 9 22 4",
            vec![(0.0, 4.0), (9.0, 4.0), (9.0, 0.0), (0.0, 4.0)],
        ),
        (
            "0 POLYLINE 70 8 0 VERTEX 10 0 20 0 0 VERTEX 10 9 20 4 0 SEQEND",
            vec![(0.0, 4.0), (9.0, 0.0)],
        ),
    ] {
        for tilted in [
            "210 1 220 0 230 0",
            "210 0 220 -1 230 0",
            "210 0.6 230 -0.8",
        ] {
            let (kind, groups) = entities.trim_start_matches("0 ").split_once(' ').unwrap();
            let text = format!("0 {kind} {tilted} {groups}");
            let (artwork, warnings) = draw(&text);
            assert_eq!(warnings, [""; 0], "{text}");
            assert_eq!(corners(&artwork), slice::from_ref(&wanted), "{text}");
        }
    }
    let (artwork, warnings) = draw(
        "0 POINT 210 1 230 0 10 3 20 3
        0 SPLINE 210 1 230 0 71 1 40 0 40 0 40 1 40 1 10 0 20 0 10 9 20 4",
    );
    let size = (artwork.width_mm, artwork.height_mm);
    assert_eq!((size, warnings.len()), ((9.0, 4.0), 0));
}

#[test]
fn a_tilted_ellipse_is_as_flat_as_seen_from_above() {
    // A circle that is lifted by 60 degrees about the X axis.
    let tilted = "0 ELLIPSE 10 0 20 0 11 10 21 0 31 0 40 1 210 0 220 -0.8660254 230 0.5";
    let (artwork, warnings) = draw(tilted);
    let size = [artwork.width_mm, artwork.height_mm].map(|value| (value * 100.0).round());
    assert_eq!((size, warnings.len()), ([2000.0, 1000.0], 0));
}

#[test]
fn a_spline_by_its_points_passes_them_in_curves() {
    let points = [(0.0, 0.0), (10.0, 10.0), (20.0, 0.0), (30.0, 10.0)];
    let fits: String = points.map(|(x, y)| format!("11 {x} 21 {y} ")).concat();
    let passed = |artwork: &Artwork, height: f64| {
        let found = &artwork.layers[0].strokes[0].points;
        assert!(found.len() > 30, "{found:?}");
        let near = |(x, y): (f64, f64)| {
            let p = Point::new(x, height - y);
            found.iter().any(|pair| pair.distance(p) < 1e-6)
        };
        points.into_iter().all(near)
    };
    let (natural, warnings) = draw(&format!("0 SPLINE 70 8 71 3 74 4 {fits}"));
    assert_eq!(warnings, [""; 0]);
    // It goes higher and lower than its points, by the same.
    let over = (natural.height_mm - 10.0) / 2.0;
    assert!(over > 0.1 && passed(&natural, 10.0 + over), "{over}");
    let (level, _) = draw(&format!(
        "0 SPLINE 70 8 71 3 74 4 12 5 22 0 13 1 23 0 {fits}"
    ));
    let begin = &level.layers[0].strokes[0].points[..2];
    let slope = (begin[1].y - begin[0].y) / (begin[1].x - begin[0].x);
    assert!(slope.abs() < 0.2, "{slope}");
    let (closed, _) = draw(&format!("0 SPLINE 70 11 71 3 74 4 {fits}"));
    assert!(closed.layers[0].strokes[0].closed);
}

#[test]
fn the_edges_of_old_meshes_are_drawn_once() {
    let vertex = |x: f64, y: f64, flags: u32| format!("0 VERTEX 70 {flags} 10 {x} 20 {y} 30 0 ");
    let square = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)];
    let corners: String = square.map(|(x, y)| vertex(x, y, 192)).concat();
    let face = |corners: &str| format!("0 VERTEX 70 128 10 0 20 0 30 0 {corners} ");
    let faces = |faces: &[&str]| {
        let faces: String = faces.iter().map(|corners| face(corners)).collect();
        format!("0 POLYLINE 70 64 71 4 72 2 {corners} {faces} 0 SEQEND")
    };
    let grid = |flags: u32, size: &str| {
        let rows = [0.0, 3.0].map(|y| [0.0, 2.0, 4.0].map(|x| vertex(x, y, 64)).concat());
        let rows = rows.concat();
        format!("0 POLYLINE 70 {flags} {size} {rows} 0 SEQEND")
    };
    let twice = square.map(|(x, y)| vertex(x, y, 192)).concat();
    let apart = format!(
        "0 POLYLINE 70 64 {corners} {twice} {} {} 0 SEQEND",
        face("71 1 72 2 73 3"),
        face("71 5 72 7 73 8")
    );
    for (entities, count, length_mm) in [
        (faces(&["71 1 72 2 73 3", "71 1 72 3 73 4"]), 5, 19.0),
        (faces(&["71 1 72 2 73 -3", "71 -1 72 3 73 4"]), 4, 14.0),
        (faces(&["71 1 72 2 73 3 74 4"]), 4, 14.0),
        (apart, 5, 19.0),
        (grid(16, "71 2 72 3"), 7, 17.0),
        (grid(16 | 32, "71 2 72 3"), 9, 25.0),
    ] {
        let (artwork, warnings) = draw(&entities);
        let strokes = &artwork.layers[0].strokes;
        let found_mm: f64 = strokes.iter().map(Stroke::length_mm).sum();
        assert_eq!((strokes.len(), found_mm), (count, length_mm), "{entities}");
        assert_eq!(warnings, [""; 0]);
    }
    for broken in [
        faces(&["71 1 72 2 73 9"]),
        grid(16, "71 2 72 4"),
        "0 POLYLINE 70 16 71 900000000 72 0 0 SEQEND".to_owned(),
        faces(&[]),
    ] {
        let (_, warnings) = draw(&format!("0 POINT 10 0 20 0 {broken}"));
        let message = "1 POLYLINE: left out, because its faces are incomplete";
        assert!(warnings[0].ends_with(message), "{warnings:?}");
    }
}

#[test]
fn each_line_of_an_mline_is_drawn_beside_its_corners() {
    let corner = |x: f64, y: f64, mitre: (f64, f64)| {
        let (across, up) = mitre;
        format!(
            "11 {x} 21 {y} 12 1 22 0 13 {across} 23 {up} 74 2 41 0 41 0 75 0 74 2 41 -2 41 0 75 0 "
        )
    };
    let corners = [
        corner(0.0, 10.0, (0.0, 1.0)),
        corner(10.0, 10.0, (-1.0, 1.0)),
        corner(10.0, 0.0, (-1.0, 0.0)),
    ]
    .concat();
    let text = format!("0 MLINE 2 STANDARD 40 1 70 0 71 1 72 3 73 2 10 0 20 10 {corners}");
    let (artwork, warnings) = draw(&text);
    assert_eq!(
        (self::corners(&artwork), warnings),
        (
            vec![
                vec![(0.0, 0.0), (10.0, 0.0), (10.0, 10.0)],
                vec![(0.0, 2.0), (12.0, 2.0), (12.0, 10.0)],
            ],
            Vec::new()
        )
    );
    let (closed, _) = draw(&text.replace("71 1", "71 3"));
    assert!(closed.layers[0].strokes.iter().all(|stroke| stroke.closed));
    let (_, warnings) = draw(&text.replacen("74 2 41 0 41 0", "74 4 41 0 41 0 41 3 41 4", 1));
    assert!(warnings[0].ends_with("1 MLINE: drawn without its gaps"));
}

#[test]
fn layers_have_names_and_colors_and_hidden_ones_are_left_out() {
    let tables =
        "0 TABLE 2 LAYER 0 LAYER 2 cut 70 0 62 1 0 LAYER 2 off 70 0 62 -3 0 LAYER 2 ice 70 1 62 5
        0 LAYER 2 true 62 7 420 16744448 0 ENDTAB";
    let entities = "0 LINE 8 cut 10 0 20 0 11 1 21 0 0 LINE 8 off 10 0 20 0 11 9 21 0
        0 LINE 8 ice 10 0 20 0 11 9 21 0 0 LINE 8 true 10 0 20 0 11 2 21 0 0 LINE 60 1 10 0 20 0 11 9 21 0
        0 LINE 67 1 10 0 20 0 11 9 21 0 0 LINE 8 cut 10 0 20 1 11 1 21 1";
    let (artwork, warnings) = draw_text(&file(tables, "", entities));
    let found: Vec<_> = artwork
        .layers
        .iter()
        .map(|layer| (layer.name.as_str(), layer.color, layer.strokes.len()))
        .collect();
    assert_eq!(
        found,
        [
            ("cut", Some([255, 0, 0]), 2),
            ("true", Some([255, 128, 0]), 1)
        ]
    );
    assert_eq!(warnings.len(), 2);
    assert!(
        warnings[0].ends_with("2 hidden objects: left out, because its layer is off or frozen"),
        "{warnings:?}"
    );
}

#[test]
fn blocks_are_drawn_where_they_are_inserted() {
    let blocks = "0 BLOCK 8 0 2 tick 10 1 20 1 0 LINE 8 0 10 1 20 1 11 2 21 1 0 ENDBLK
        0 BLOCK 2 pair 10 0 20 0 0 INSERT 2 tick 10 0 20 0 0 INSERT 2 tick 10 0 20 5 50 90 0 ENDBLK";
    let (artwork, _) = draw_text(&file(
        "",
        blocks,
        "0 INSERT 8 marks 2 pair 10 10 20 10 41 2 42 2",
    ));
    assert_eq!(artwork.layers[0].name, "marks");
    assert_eq!(
        corners(&artwork),
        [[(0.0, 12.0), (2.0, 12.0)], [(0.0, 2.0), (0.0, 0.0)]]
    );
    let rows = "0 INSERT 2 tick 10 0 20 0 70 3 71 2 44 10 45 20";
    assert_eq!(
        draw_text(&file("", blocks, rows)).0.layers[0].strokes.len(),
        6
    );
    let mirrored = "0 INSERT 2 tick 10 0 20 0 230 -1 210 0 220 0 0 POINT 10 0 20 0";
    let (artwork, _) = draw_text(&file("", blocks, mirrored));
    assert_eq!(corners(&artwork)[0], [(1.0, 0.0), (0.0, 0.0)]);
}

#[test]
fn objects_on_layers_that_never_plot_are_skipped_with_a_warning() {
    let tables = "0 TABLE 2 LAYER 0 LAYER 2 help 70 0 62 7 290 0 0 LAYER 2 ink 70 0 62 7 290 1
        0 LAYER 2 Defpoints 70 0 62 7 290 1 0 ENDTAB";
    let entities = "0 LINE 8 ink 10 0 20 0 11 9 21 0 0 LINE 8 Help 10 0 20 9 11 9 21 9
        0 LINE 8 DEFPOINTS 10 0 20 5 11 9 21 5 0 POINT 8 Defpoints 10 0 20 7";
    let (artwork, warnings) = draw_text(&file(tables, "", entities));
    assert_eq!(corners(&artwork), [[(0.0, 0.0), (9.0, 0.0)]]);
    let message = "2 unplotted objects: left out, because its layer is not plotted";
    assert!(
        warnings.len() == 1 && warnings[0].ends_with(message),
        "{warnings:?}"
    );
}

#[test]
fn a_block_on_a_hidden_layer_shows_its_parts_on_other_layers() {
    let tables = "0 TABLE 2 LAYER 0 LAYER 2 off 70 0 62 -7 0 LAYER 2 ice 70 1 62 7
        0 LAYER 2 help 62 7 290 0 0 LAYER 2 ink 70 0 62 7 0 ENDTAB";
    let blocks = "0 BLOCK 2 in 10 0 20 0 0 LINE 8 0 10 0 20 0 11 5 21 0
        0 LINE 8 ink 10 5 20 0 11 9 21 0 0 LINE 8 off 10 0 20 1 11 9 21 1 0 ENDBLK
        0 BLOCK 2 out 10 0 20 0 0 INSERT 8 0 2 in 10 0 20 0 0 ENDBLK";
    for (layer, block, lines) in [
        ("off", "in", 1),
        ("off", "out", 1),
        ("help", "in", 1),
        ("Defpoints", "in", 1),
        ("ink", "in", 2),
        ("ice", "in", 0),
        ("ice", "out", 0),
    ] {
        let entities = format!("0 POINT 10 0 20 9 0 INSERT 8 {layer} 2 {block} 10 0 20 0");
        let (artwork, _) = draw_text(&file(tables, blocks, &entities));
        assert_eq!(corners(&artwork).len(), 1 + lines, "{layer} {block}");
    }
}

#[test]
fn the_attributes_of_a_hidden_block_are_hidden_too() {
    let tables = "0 TABLE 2 LAYER 0 LAYER 2 ice 70 1 62 7 0 ENDTAB";
    let blocks = "0 BLOCK 2 a 10 0 20 0 0 POINT 10 0 20 0 0 ENDBLK";
    let attribute = "0 ATTRIB 8 ink 10 1 20 0 40 2 2 NAME 1 I 0 SEQEND";
    for (groups, strokes) in [("8 ink", 3), ("8 ice", 1), ("60 1", 1), ("67 1", 1)] {
        let insert = format!("0 INSERT {groups} 66 1 2 a 10 0 20 0 {attribute}");
        let text = file(tables, blocks, &format!("{insert} 0 POINT 10 0 20 9"));
        let (artwork, _) = draw_text(&text);
        assert_eq!(corners(&artwork).len(), strokes, "{groups}");
    }
}

#[test]
fn names_of_layers_and_blocks_are_the_same_in_capitals() {
    let tables = "0 TABLE 2 LAYER 0 LAYER 2 WALLS 70 1 62 7 0 LAYER 2 Türen 70 0 62 1 0 LAYER 2 türen 62 5 0 ENDTAB";
    let blocks = "0 BLOCK 2 FOO 10 0 20 0 0 LINE 8 0 10 0 20 0 11 5 21 5 0 ENDBLK";
    let entities = "0 LINE 8 walls 10 0 20 0 11 9 21 0 0 INSERT 8 TÜREN 2 foo 10 0 20 0
        0 INSERT 8 türen 2 Foo 10 0 20 0";
    let (artwork, warnings) = draw_text(&file(tables, blocks, entities));
    let found = artwork
        .layers
        .iter()
        .map(|layer| (layer.name.as_str(), layer.color));
    let found: Vec<_> = found.collect();
    // Programs that distinguish such names are not AutoCAD, and may have both.
    let wanted = [("Türen", Some([255, 0, 0])), ("türen", Some([0, 0, 255]))];
    assert_eq!(found, wanted);
    let message = "1 hidden object: left out, because its layer is off or frozen";
    assert!(
        warnings.len() == 1 && warnings[0].ends_with(message),
        "{warnings:?}"
    );
}

#[test]
fn a_missing_block_is_skipped_with_a_warning() {
    let (artwork, warnings) =
        draw("0 LINE 10 0 20 0 11 9 21 0 0 INSERT 2 foo 10 0 20 0 0 INSERT 2 bar 10 5 20 5");
    assert_eq!(corners(&artwork), [[(0.0, 0.0), (9.0, 0.0)]]);
    let message = "37:1: 2 INSERTs: left out, because its block is not in the file: \"foo\"";
    assert_eq!(warnings, [message]);
}

#[test]
fn hatches_and_solids_are_areas() {
    let hatch = "0 HATCH 10 0 20 0 30 0 2 SOLID 70 1 71 0 91 2
        92 3 72 0 73 1 93 4 10 0 20 0 10 9 20 0 10 9 20 9 10 0 20 9 97 0
        92 2 72 1 73 1 93 2 10 2 20 4 42 1 10 4 20 4 42 1 97 0 75 0 76 1 98 1 10 5 20 5";
    let (artwork, warnings) = draw(hatch);
    let area = &artwork.layers[0].areas[0];
    assert_eq!(
        (area.rings.len(), area.rings[0].len(), warnings.len()),
        (2, 5, 0)
    );
    assert!(area.rings[1].len() > 10);
    let (artwork, _) = draw("0 SOLID 10 0 20 0 11 9 21 0 12 0 22 9 13 9 23 9");
    let ring = &artwork.layers[0].areas[0].rings[0];
    let ring: Vec<_> = ring.iter().map(|p| (p.x, p.y)).collect();
    assert_eq!(ring, [(0.0, 9.0), (9.0, 9.0), (9.0, 0.0), (0.0, 0.0)]);
}

#[test]
fn the_edges_of_areas_are_drawn_once() {
    let solid = "0 SOLID 10 0 20 0 11 9 21 0 12 0 22 9 13 9 23 9";
    let outline = "0 LWPOLYLINE 70 1 10 9 20 9 10 9 20 0 10 0 20 0 10 0 20 9";
    for entities in [solid.to_owned(), format!("{solid} {outline}")] {
        let (artwork, _) = draw(&entities);
        let layer = &artwork.layers[0];
        assert_eq!((layer.areas.len(), layer.strokes.len()), (1, 1));
        assert!(layer.strokes[0].closed);
        assert_eq!(layer.strokes[0].length_mm(), 36.0);
    }
}

#[test]
fn a_hatch_may_be_bounded_by_arcs_and_lines() {
    let circle = |side| {
        format!(
            "0 HATCH 91 1 92 1 93 1 72 2 10 50 20 40 40 10 50 0 51 360 73 {side} 97 0 75 0 98 1 10 5 20 5"
        )
    };
    for side in [0, 1] {
        let (artwork, warnings) = draw(&circle(side));
        assert!(warnings.is_empty(), "{warnings:?}");
        let length_mm = artwork.layers[0].strokes[0].length_mm();
        assert!(
            (length_mm - 20.0 * std::f64::consts::PI).abs() < 0.05,
            "{length_mm}"
        );
    }
    // The upper half of a disc, to the left and, its angles counted clockwise, to the right.
    for arc in ["50 0 51 180 73 1", "50 180 51 360 73 0"] {
        let line = if arc.ends_with('1') {
            "10 -5 20 0 11 5 21 0"
        } else {
            "10 5 20 0 11 -5 21 0"
        };
        let half =
            format!("0 HATCH 91 1 92 1 93 2 72 2 10 0 20 0 40 5 {arc} 72 1 {line} 97 0 75 0");
        let (artwork, _) = draw(&half);
        let length_mm = artwork.layers[0].strokes[0].length_mm();
        assert!(
            (length_mm - 10.0 - 5.0 * std::f64::consts::PI).abs() < 0.05,
            "{length_mm}"
        );
        let lowest = artwork.layers[0].areas[0].rings[0]
            .iter()
            .filter(|p| p.y > 4.99);
        assert!(lowest.count() >= 2 && artwork.height_mm < 5.01);
    }
}

#[test]
fn skipped_entities_are_named_with_their_count() {
    let entities = "0 LINE 10 0 20 0 11 1 21 0 0 3DSOLID 1 x
        0 TEXT 10 0 20 0 40 1 1 %%u漢 0 MTEXT 10 0 20 0 40 1 1 \\H2;b字
        0 TEXT 10 0 20 0 40 0 1 a 0 MTEXT 10 0 20 0 40 -1 1 a 0 TEXT 72 5 10 0 20 0 11 0 21 0 40 1 1 a
        0 DIMENSION 2 *D1 10 0 20 0 0 RAY 10 0 20 0 11 1 21 0
        0 CIRCLE 10 0 20 0 40 1 210 1 220 0 230 0 0 HATCH 91 1 92 1 93 1 72 5 10 0 20 0 11 1 21 0 40 1
        0 POLYLINE 70 64 0 VERTEX 10 0 20 0 0 SEQEND 0 SPLINE 71 3 11 0 21 0 11 5 21 5 0 VIEWPORT 10 0";
    let (_, warnings) = draw(entities);
    let texts: Vec<&str> = warnings
        .iter()
        .map(|warning| warning.split_once(": ").unwrap().1)
        .collect();
    assert_eq!(
        texts,
        [
            "1 3DSOLID: unknown, left out",
            "2 formatted texts: written plainly: one height, no underlines, fractions on one line",
            "2 characters: not in the sans letters, left out; the first is '漢'",
            "2 TEXTs: left out, because its letters have no size",
            "1 MTEXT: left out, because its letters have no size",
            "1 DIMENSION: left out, because its picture is not in the file",
            "1 RAY: left out, because it has no end",
            "1 tilted object: left out, because only objects in the XY plane are drawn",
            "1 HATCH: a boundary of unknown type left out",
            "1 POLYLINE: left out, because its faces are incomplete",
        ]
    );
}

#[test]
fn an_undrawable_entity_is_refused_with_its_place() {
    let in_text = |entities: &str| file("", "", entities);
    for (text, expected) in [
        (
            String::new(),
            "1:1: found the end of the file; expected 0 and EOF: the file is cut off",
        ),
        (
            "AutoCAD Binary DXF\r\n\u{1a}\0".into(),
            "1:1: found a binary DXF file; expected an ASCII DXF file; save it as such",
        ),
        (
            "AC1032\0\0".into(),
            "1:1: found a DWG file; expected an ASCII DXF file; save it as such",
        ),
        (
            "hello\nworld\n".into(),
            "1:1: found \"hello\"; expected a group code such as 0 or 10",
        ),
        (
            "0\nSECTION\n2".into(),
            "3:2: found the end of the file; expected the value of the group",
        ),
        (in_text(""), "nothing to draw: no lines in the file"),
        (
            in_text("0 LINE 10 0 20 0 11 1"),
            "27:1: found LINE without group 21; expected a number",
        ),
        (
            in_text("0 LINE 10 0 20 zero 11 1 21 1"),
            "32:1: found \"zero\" for group 20; expected a number from -1e12 to 1e12",
        ),
        (
            in_text("0 LINE 10 nan 20 0 11 1 21 1"),
            "30:1: found \"nan\" for group 10; expected a number from -1e12 to 1e12",
        ),
        (
            in_text("0 TEXT 10 0 20 0 1 a"),
            "27:1: found TEXT without group 40; expected a number",
        ),
        (
            in_text("0 TEXT 10 0 20 0 40 1 72 1 11 0 1 a"),
            "27:1: found TEXT without group 21; expected a number",
        ),
        (
            in_text("0 ATTRIB 10 0 20 0 40 1 72 1 74 4 1 a"),
            "27:1: found ATTRIB justified 1 across and 4 up; expected 0 to 5 across (72) and 0 to 3 up (73, of attributes 74)",
        ),
        (
            in_text("0 MTEXT 10 0 20 0 40 1 71 10 1 a"),
            "27:1: found MTEXT attached at 10; expected an attachment point from 1 to 9",
        ),
        (
            in_text("0 TEXT 10 0 20 0 40 2100000 1 H"),
            "27:1: leads to (-400000, 2100000) mm; at most 1000000 mm from the origin are allowed",
        ),
        (
            in_text("0 CIRCLE 10 0 20 0 40 9000000"),
            "27:1: leads to (9000000, 0) mm; at most 1000000 mm from the origin are allowed",
        ),
        (
            in_text("0 SPLINE 71 3 10 0 20 0"),
            "27:1: found a spline of degree 3 with 1 control points and 0 knots; expected degree 1 to 15, and as many knots as control points plus degree plus 1",
        ),
        (
            in_text("0 INSERT 2 none 10 0 20 0"),
            "nothing to draw: no lines in the file; 27:1: 1 INSERT: left out, because its block is not in the file: \"none\"",
        ),
    ] {
        assert_eq!(error(text.as_bytes()), expected, "{text}");
    }
    let unit = "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n20\n";
    assert_eq!(
        error(unit.as_bytes()),
        "8:1: found $INSUNITS 20; expected a supported unit of length: 1, 2, 4 to 6, 8 to 10, 13 or 14"
    );
}

#[test]
fn recursive_blocks_are_refused() {
    let itself = file(
        "",
        "0 BLOCK 2 a 0 INSERT 2 a 10 0 20 0 0 ENDBLK",
        "0 INSERT 2 a 10 0 20 0",
    );
    assert!(
        error(itself.as_bytes()).contains("found a block inside itself"),
        "{}",
        error(itself.as_bytes())
    );
    let mut blocks = "0 BLOCK 2 b0 0 ENDBLK ".to_owned();
    for i in 1..20 {
        let one = format!("0 INSERT 2 b{} 10 0 20 0 ", i - 1);
        write!(blocks, "0 BLOCK 2 b{i} {} 0 ENDBLK ", one.repeat(20)).unwrap();
    }
    let laughs = file("", &blocks, "0 INSERT 2 b19 10 0 20 0");
    assert!(error(laughs.as_bytes()).contains(
        "found one copy too many; expected copies of blocks (INSERT) of less than 200 MB in total"
    ));
    let rows = file(
        "",
        "0 BLOCK 2 a 0 ENDBLK",
        "0 INSERT 2 a 10 0 20 0 70 1000000000 71 1000000000",
    );
    assert!(error(rows.as_bytes()).contains("found one copy too many"));
}

#[test]
fn names_of_old_files_are_western() {
    let text = file("", "", "0 LINE 8 Fr?ser 10 0 20 0 11 9 21 0");
    let bytes: Vec<u8> = text
        .bytes()
        .map(|byte| if byte == b'?' { 0xE4 } else { byte })
        .collect();
    let (artwork, _) = super::read(&bytes, &ReadOptions::default()).unwrap();
    assert_eq!(artwork.layers[0].name, "Fräser");
}

/// The name of a layer that is written in these bytes, in a file whose header has these groups.
fn layer_name(header: &str, name: &[u8]) -> (String, Vec<String>) {
    let text = file("", "", "0 LINE 8 ? 10 0 20 0 11 9 21 0");
    let header: String = header
        .split_whitespace()
        .map(|word| word.to_owned() + "\n")
        .collect();
    let text = text.replace("HEADER\n", &format!("HEADER\n{header}"));
    let (before, after) = text.split_once('?').unwrap();
    let bytes = [before.as_bytes(), name, after.as_bytes()].concat();
    let (artwork, warnings) = super::read(&bytes, &ReadOptions::default()).unwrap();
    let warnings = warnings.iter().map(Warning::to_string).collect();
    (artwork.layers[0].name.clone(), warnings)
}

#[test]
fn names_are_in_the_code_page_of_the_header_before_2007() {
    for (page, name, wanted) in [
        ("ANSI_1253", &b"\xc5\xeb\xeb\xdc\xe4\xe1"[..], "Ελλάδα"),
        ("ansi_1251", b"\xd1\xf2\xe5\xed\xfb", "Стены"),
        ("ANSI_1250", b"\xb3\xf3d\x9f", "łódź"),
        ("ANSI_1252", b"\x80\x96\x93\x94", "€–“”"),
        ("ANSI_932", b"\x93\xfa\x96\x7b", "日本"),
        // The first letter alone might be one in UTF-8 too.
        ("ANSI_936", b"\xc4\xa3\xd6\xd0\xb9\xfa", "模中国"),
        ("ANSI_949", b"\xc7\xd1", "한"),
        ("ANSI_950", b"\xa4\xa4", "中"),
        ("ANSI_874", b"\xa1", "ก"),
        ("dos866", b"\x84", "Д"),
        ("dos437", b"K\x81che \xe1", "Küche ß"),
        ("DOS850", b"\x9dre, \xb5", "Øre, Á"),
        ("dos852", b"\x88\xa2d\xab", "łódź"),
        ("ISO8859-2", b"\xb3", "ł"),
        // Written by programs that declare another code page than they use.
        ("ANSI_1252", "Küche".as_bytes(), "Küche"),
        ("ANSI_936", "模".as_bytes(), "模"),
    ] {
        let header = format!("9 $ACADVER 1 AC1015 9 $DWGCODEPAGE 3 {page}");
        let found = layer_name(&header, name);
        assert_eq!(found, (wanted.to_owned(), Vec::new()), "{page}");
    }
}

#[test]
fn names_from_2007_on_are_in_utf8_and_those_without_a_code_page_western() {
    let later = "9 $ACADVER 1 AC1021 9 $DWGCODEPAGE 3 ANSI_1251";
    assert_eq!(layer_name(later, "Küche".as_bytes()).0, "Küche");
    for header in ["", "9 $ACADVER 1 AC1009"] {
        assert_eq!(layer_name(header, b"5 \x80").0, "5 €");
    }
    let unknown = "9 $ACADVER 1 AC1009 9 $DWGCODEPAGE 3 dos863";
    let (name, warnings) = layer_name(unknown, b"Fr\xe4ser");
    assert_eq!(name, "Fräser");
    let message =
        "1 file in an unknown code page: read as Windows-1252; its header names \"dos863\"";
    assert_eq!(warnings, [message]);
    assert_eq!(layer_name(unknown, b"wall").1, [""; 0]);
}

#[test]
fn lines_may_end_as_on_old_macs() {
    let text = file("", "", "0 LINE 8 Fräser 10 0 20 0 11 9 21 0");
    let returns = |text: &str| text.replace('\n', "\r");
    assert_eq!(draw_text(&returns(&text)), draw_text(&text));
    let marked = format!("\u{FEFF}{}", returns(&text));
    assert_eq!(draw_text(&marked), draw_text(&text));
    let broken = text.replace("21\n0", "21\nzero");
    let message = "38:1: found \"zero\" for group 21; expected a number from -1e12 to 1e12";
    assert_eq!(error(returns(&broken).as_bytes()), message);
}

#[test]
fn a_truncated_file_is_refused_or_its_end_is_reported() {
    let text = file(
        "",
        "0 BLOCK 2 a 0 POINT 10 0 20 0 0 ENDBLK",
        "0 INSERT 2 a 10 0 20 0 0 LINE 10 0 20 0 11 9 21 0 0 TEXT 10 0 20 0 40 1 1 a%%d 0 MTEXT 10 0 20 0 40 1 1 a\\Pb",
    );
    for end in 0..text.len() - 1 {
        if let Ok((_, warnings)) = super::read(&text.as_bytes()[..end], &ReadOptions::default()) {
            refuse_mistakes(&warnings).unwrap_err();
        }
    }
}

proptest! {
    #[test]
    fn lines_are_read_as_they_were_written(lines in prop::collection::vec(prop::collection::vec((-1e3..1e3, -1e3..1e3), 2..9), 1..9)) {
        let mut entities = String::new();
        for line in &lines {
            entities += "0 LWPOLYLINE ";
            for (x, y) in line {
                write!(entities, "10 {x} 20 {y} ").unwrap();
            }
        }
        let (artwork, _) = draw(&entities);
        let wanted: Vec<Point> = lines.iter().flatten().map(|&(x, y): &(f64, f64)| Point::new(x, -y)).collect();
        let found: Vec<Point> = artwork.points().collect();
        prop_assert_eq!(found.len(), wanted.len());
        let shift = wanted[0] - found[0];
        for (found, wanted) in found.iter().zip(wanted) {
            prop_assert!((*found + shift).distance(wanted) < 1e-6);
        }
    }

    #[test]
    fn no_text_makes_it_panic(text in ".{0,200}", pairs in prop::collection::vec((0..100, "[-0-9.]{1,4}|LINE|ARC|ELLIPSE|SPLINE|POLYLINE|VERTEX|MLINE|HATCH|INSERT|TEXT|MTEXT|ATTDEF|DIMENSION|a"), 0..40)) {
        let _ = super::read(text.as_bytes(), &ReadOptions::default());
        let pairs: Vec<String> = pairs.iter().map(|(code, value)| format!("{code} {value}")).collect();
        let pairs = pairs.join(" ");
        let text = file("", "0 BLOCK 2 a 0 POINT 10 0 20 0 0 ENDBLK", &pairs);
        if let Ok((artwork, _)) = super::read(text.as_bytes(), &ReadOptions::default()) {
            prop_assert!(artwork.points().all(|p| p.x.is_finite() && p.y.is_finite()));
        }
    }
}

#[test]
fn lines_have_the_dashes_of_their_type_in_the_size_given_by_the_file() {
    let types = "0 LTYPE 2 Dashed 70 0 73 2 40 3 49 2 49 -1 0 LTYPE 2 CONTINUOUS 70 0 73 0 40 0
        0 LTYPE 2 DOTS 73 2 49 0 49 -2 0 LAYER 2 hidden 70 0 62 7 6 DASHED";
    let line = "0 LINE 10 0 20 0 11 10 21 0";
    let dashes = |entities: &str| {
        let (artwork, warnings) = draw_text(&file(types, "", entities));
        assert_eq!(warnings, [""; 0]);
        let strokes = artwork.layers.iter().flat_map(|layer| &layer.strokes);
        strokes.map(Stroke::length_mm).collect::<Vec<_>>()
    };
    let near = |found: Vec<f64>, expected: &[f64]| {
        assert_eq!(found.len(), expected.len(), "{found:?}");
        let mut both = found.iter().zip(expected);
        assert!(both.all(|(a, b)| (a - b).abs() < 1e-6), "{found:?}");
    };
    near(dashes(&format!("{line} 6 DASHED")), &[2.0, 2.0, 2.0, 1.0]);
    near(dashes(&format!("{line} 8 hidden")), &[2.0, 2.0, 2.0, 1.0]);
    near(
        dashes(&format!("{line} 8 hidden 6 ByLayer 48 2")),
        &[4.0, 4.0],
    );
    near(dashes(&format!("{line} 6 DOTS 48 2")), &[0.0, 0.0, 0.0]);
    // Solid: by its own type, by one that is nowhere, shorter than one turn, with dashes that
    // nobody would see.
    for solid in [
        "8 hidden 6 Continuous",
        "6 NONE",
        "6 DASHED 48 4",
        "6 DASHED 48 0.0001",
    ] {
        near(dashes(&format!("{line} {solid}")), &[10.0]);
    }
    let larger = file(types, "", &format!("{line} 6 DASHED"))
        .replace("9\n$INSUNITS", "9\n$LTSCALE\n40\n2\n9\n$INSUNITS");
    let (artwork, _) = draw_text(&larger);
    assert_eq!(artwork.layers[0].strokes.len(), 2);
    let arc = "0 ARC 10 0 20 0 40 10 50 0 51 90 6 DASHED";
    let along_arc = dashes(arc);
    near(along_arc[..5].to_vec(), &[2.0; 5]);
    // 15.71 mm along the arc, and the tolerance.
    assert!((along_arc[5] - 0.708).abs() < 0.01, "{along_arc:?}");
}
