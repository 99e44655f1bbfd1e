use super::blocks::{MATRICES, with_objects};
use super::*;

const LINE: &str = "0 LINE 10 0 20 5 11 60 21 5";
/// From 20 to 40 and from 0 to 10, so that it lies over a third of the line.
const SOLID: &str = "0 SOLID 10 20 20 0 11 40 21 0 12 20 22 10 13 40 23 10";
const EDGE_MM: f64 = 60.0;

fn hidden_text(text: &str) -> (Artwork, Vec<String>) {
    let hides = ReadOptions {
        hides: true,
        ..ReadOptions::default()
    };
    let (artwork, warnings) = super::super::read(text.as_bytes(), &hides).unwrap();
    (artwork, warnings.iter().map(Warning::to_string).collect())
}

/// The length of all visible lines.
#[track_caller]
fn shown_mm(entities: &str) -> f64 {
    let (artwork, warnings) = hidden_text(&file("", "", entities));
    assert_eq!(warnings, [""; 0]);
    length_mm(&artwork)
}

fn length_mm(artwork: &Artwork) -> f64 {
    let strokes = artwork.layers.iter().flat_map(|layer| &layer.strokes);
    strokes.map(Stroke::length_mm).sum()
}

#[track_caller]
fn same(found_mm: f64, expected_mm: f64) {
    let off_mm = (found_mm - expected_mm).abs();
    assert!(
        off_mm < 1e-3,
        "{found_mm} mm, expected are {expected_mm} mm"
    );
}

#[test]
fn a_line_under_a_solid_is_cut_and_one_above_it_is_not() {
    same(shown_mm(&format!("{LINE} {SOLID}")), 40.0 + EDGE_MM);
    same(shown_mm(&format!("{SOLID} {LINE}")), 60.0 + EDGE_MM);
    let trace = SOLID.replace("SOLID", "TRACE");
    same(shown_mm(&format!("{LINE} {trace}")), 40.0 + EDGE_MM);
}

#[test]
fn without_hiding_everything_is_drawn() {
    let (artwork, _) = draw(&format!("{LINE} {SOLID}"));
    same(length_mm(&artwork), 60.0 + EDGE_MM);
}

#[test]
fn lines_of_other_layers_are_hidden_too() {
    let line = LINE.replace("LINE", "LINE 8 ink");
    same(shown_mm(&format!("{line} {SOLID}")), 40.0 + EDGE_MM);
}

#[test]
fn the_outline_of_a_filled_shape_shows_whether_it_was_drawn_before_or_after() {
    let outline = "0 LWPOLYLINE 70 1 10 20 20 0 10 40 20 0 10 40 20 10 10 20 20 10";
    for entities in [format!("{outline} {SOLID}"), format!("{SOLID} {outline}")] {
        same(shown_mm(&entities), EDGE_MM);
    }
    // Another square under both: its edge stays hidden.
    let under = "0 LWPOLYLINE 70 1 10 25 20 2 10 35 20 2 10 35 20 8 10 25 20 8";
    same(shown_mm(&format!("{under} {outline} {SOLID}")), EDGE_MM);
}

#[test]
fn a_filled_hatch_hides_and_its_island_shows_the_shapes_below() {
    let hatch = |solid: &str| {
        format!(
            "{LINE} 0 HATCH 2 X 70 {solid} 71 0 91 2
            92 3 72 0 73 1 93 4 10 20 20 0 10 40 20 0 10 40 20 10 10 20 20 10 97 0
            92 2 72 0 73 1 93 4 10 25 20 2 10 35 20 2 10 35 20 8 10 25 20 8 97 0 75 0"
        )
    };
    let edges_mm = EDGE_MM + 2.0 * (10.0 + 6.0);
    same(shown_mm(&hatch("1")), 50.0 + edges_mm);
    // One that is not filled hides nothing.
    same(shown_mm(&hatch("0")), 60.0 + edges_mm);
}

#[test]
fn a_transparent_object_hides_nothing() {
    let faint = SOLID.replace("SOLID", &format!("SOLID 440 {}", 0x0200_007f));
    same(shown_mm(&format!("{LINE} {faint}")), 60.0 + EDGE_MM);
    let opaque = SOLID.replace("SOLID", &format!("SOLID 440 {}", 0x0200_00ff));
    same(shown_mm(&format!("{LINE} {opaque}")), 40.0 + EDGE_MM);
}

#[test]
fn an_object_on_a_transparent_layer_hides_nothing_unless_it_is_opaque_itself() {
    let tables = |transparency: u32| {
        format!(
            "0 LAYER 2 glass 70 0 62 1 1001 ACAD 1071 33554559
            1001 AcCmTransparency 1071 {transparency} 0 LAYER 2 ink 70 0 62 7"
        )
    };
    let shown_mm = |transparency: u32, solid: &str| {
        let entities = format!("{LINE} {solid}");
        let (artwork, _) = hidden_text(&file(&tables(transparency), "", &entities));
        length_mm(&artwork)
    };
    let on = |more: &str| SOLID.replace("SOLID", &format!("SOLID 8 {more}"));
    same(shown_mm(0x0200_007f, &on("glass")), 60.0 + EDGE_MM);
    same(shown_mm(0x0200_00ff, &on("glass")), 40.0 + EDGE_MM);
    same(shown_mm(0x0200_007f, &on("ink")), 40.0 + EDGE_MM);
    let opaque = on(&format!("glass 440 {}", 0x0200_00ff));
    same(shown_mm(0x0200_007f, &opaque), 40.0 + EDGE_MM);
}

#[test]
fn an_object_with_the_transparency_of_its_block_hides_if_the_block_is_opaque() {
    let solid = SOLID.replace("SOLID", &format!("SOLID 440 {}", 0x0100_0000));
    let inner = format!("0 BLOCK 2 INNER 10 0 20 0 {solid} 0 ENDBLK");
    let outer = |more: &str| {
        format!("{inner} 0 BLOCK 2 OUTER 10 0 20 0 0 INSERT 2 INNER 10 0 20 0 {more} 0 ENDBLK")
    };
    let glass = format!(
        "0 LAYER 2 glass 70 0 62 1 1001 AcCmTransparency 1071 {}",
        0x0200_007f
    );
    let shown_mm = |inner: &str, outer_insert: &str| {
        let entities = format!("{LINE} 0 INSERT 2 OUTER 10 0 20 0 {outer_insert}");
        let (artwork, _) = hidden_text(&file(&glass, &outer(inner), &entities));
        length_mm(&artwork)
    };
    let (faint, opaque) = (
        format!("440 {}", 0x0200_007f),
        format!("440 {}", 0x0200_00ff),
    );
    let by_block = format!("440 {}", 0x0100_0000);
    let (hidden_mm, seen_mm) = (40.0 + EDGE_MM, 60.0 + EDGE_MM);
    same(shown_mm("", ""), hidden_mm);
    same(shown_mm(&faint, ""), seen_mm);
    same(shown_mm("8 glass", ""), seen_mm);
    same(shown_mm(&format!("8 glass {opaque}"), ""), hidden_mm);
    same(shown_mm(&by_block, &faint), seen_mm);
    same(shown_mm(&by_block, ""), hidden_mm);
    same(shown_mm(&opaque, &faint), hidden_mm);
    // On layer 0 it has the layer of the INSERT around it.
    same(shown_mm("", "8 glass"), seen_mm);
}

#[test]
fn an_area_is_hatched_only_where_it_shows() {
    let big = "0 SOLID 10 0 20 0 11 60 21 0 12 0 22 10 13 60 23 10";
    let (artwork, _) = hidden_text(&file("", "", &format!("{big} {SOLID}")));
    let area = |area: &dobot_geometry::Area| {
        let twice = |ring: &Vec<Point>| {
            let next = ring.iter().cycle().skip(1);
            let pairs = ring.iter().zip(next);
            pairs.map(|(a, b)| a.x * b.y - b.x * a.y).sum::<f64>()
        };
        area.rings.iter().map(twice).sum::<f64>().abs() / 2.0
    };
    let areas: f64 = artwork.layers[0].areas.iter().map(area).sum();
    // 400 mm2 beside the small one, and the 200 mm2 of the small one.
    assert!((areas - 600.0).abs() < 0.1, "{areas}");
}

#[test]
fn a_wipeout_hides_and_is_not_drawn_itself() {
    // A square picture of one pixel from 20 to 40 and from -5 to 15.
    let wipeout = "0 WIPEOUT 10 20 20 -5 11 20 21 0 12 0 22 20 13 1 23 1";
    same(shown_mm(&format!("{LINE} {wipeout}")), 40.0);
    same(shown_mm(&format!("{wipeout} {LINE}")), 60.0);
    // Its left half, by two corners, and a triangle whose edges cross the line at 30 and 40.
    let left = format!("{LINE} {wipeout} 71 1 91 2 14 -0.5 24 -0.5 14 0 24 0.5");
    same(shown_mm(&left), 50.0);
    let corner = "71 2 91 4 14 -0.5 24 0.5 14 0.5 24 0.5 14 0.5 24 -0.5 14 -0.5 24 0.5";
    same(shown_mm(&format!("{LINE} {wipeout} {corner}")), 50.0);
    let high = "0 LINE 10 30 20 9 11 40 21 9";
    // There the triangle begins at 34.
    same(shown_mm(&format!("{high} {wipeout} {corner}")), 4.0);
}

#[test]
fn an_inverted_wipeout_covers_everything_outside_its_corners() {
    // The picture reaches from 20 to 40, and its opening from 25 to 35.
    let wipeout = "0 WIPEOUT 10 20 20 -5 11 20 21 0 12 0 22 20 13 1 23 1 71 1 91 2 14 -0.25 24 -0.25 14 0.25 24 0.25";
    same(shown_mm(&format!("{LINE} {wipeout} 290 0")), 50.0);
    same(shown_mm(&format!("{LINE} {wipeout} 290 1")), 50.0);
    let near = "0 LINE 10 0 20 12 11 60 21 12";
    same(shown_mm(&format!("{near} {wipeout} 290 0")), 60.0);
    same(shown_mm(&format!("{near} {wipeout} 290 1")), 40.0);
}

/// A line, a solid and a polyline of two parts, with handles, and the table with their order.
fn ordered(places: &str, in_block: bool) -> Artwork {
    let line = LINE.replace("LINE", "LINE 5 A1");
    let solid = SOLID.replace("SOLID", "SOLID 5 A2");
    let poly =
        "0 POLYLINE 5 A3 66 1 0 VERTEX 5 A4 10 0 20 7 0 VERTEX 5 A5 10 60 20 7 0 SEQEND 5 A6";
    let entities = format!("{line} {solid} {poly}");
    let table = format!("0 SORTENTSTABLE 5 B1 330 B0 100 AcDbSortentsTable 330 1F {places}");
    let text = if in_block {
        let block = format!("0 BLOCK 2 a {entities} 0 ENDBLK");
        with_objects(&block, "0 INSERT 5 C1 2 a 10 0 20 0", &table)
    } else {
        with_objects("", &entities, &table)
    };
    let (artwork, warnings) = hidden_text(&text);
    assert_eq!(warnings, [""; 0]);
    artwork
}

#[test]
fn entities_hide_each_other_in_the_order_given_by_the_file() {
    for in_block in [false, true] {
        let length_mm = |places: &str| length_mm(&ordered(places, in_block));
        // As they are: over the line, under the polyline.
        same(length_mm(""), 40.0 + 60.0 + EDGE_MM);
        // To the back, by a handle that comes before all others.
        same(length_mm("331 A2 5 1"), 60.0 + 60.0 + EDGE_MM);
        // To the front; the parts of the polyline stay with it.
        same(length_mm("331 A2 5 FF"), 40.0 + 40.0 + EDGE_MM);
        same(length_mm("331 A2 5 A3 331 A3 5 A2"), 40.0 + 40.0 + EDGE_MM);
        // Objects that are not in the drawing change nothing.
        same(length_mm("331 DD 5 1"), 40.0 + 60.0 + EDGE_MM);
    }
}

#[test]
fn an_invalid_handle_keeps_the_order_of_the_file() {
    let table = "0 SORTENTSTABLE 5 B1 331 A2 5 xyz";
    let text = with_objects("", LINE, table);
    let hides = ReadOptions {
        hides: true,
        ..ReadOptions::default()
    };
    let (_, warnings) = super::super::read(text.as_bytes(), &hides).unwrap();
    let message =
        "found \"xyz\" for group 5; expected a handle such as 1F: the order of the file remains";
    assert!(warnings[0].to_string().contains(message), "{warnings:?}");
}

#[test]
fn a_clipped_block_hides_only_within_its_clip() {
    let blocks = format!("0 BLOCK 2 a {SOLID} 0 ENDBLK");
    let line = "0 LINE 10 100 20 5 11 160 21 5";
    let insert = "0 INSERT 5 1F 102 {ACAD_XDICTIONARY 360 D1 102 } 2 a 10 100 20 0";
    let objects = format!(
        "0 DICTIONARY 5 D1 3 ACAD_FILTER 360 D2 0 DICTIONARY 5 D2 3 SPATIAL 360 F1
        0 SPATIAL_FILTER 5 F1 330 D2 70 2 10 100 20 -1 10 130 20 11 71 1 72 0 73 0 {MATRICES}"
    );
    let text = with_objects(&blocks, &format!("{line} {insert}"), &objects);
    let (artwork, warnings) = hidden_text(&text);
    assert_eq!(warnings, [""; 0]);
    // Half of the solid, with three of its edges.
    same(length_mm(&artwork), 50.0 + 10.0 + 10.0 + 10.0);
}
