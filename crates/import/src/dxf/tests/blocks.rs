use super::*;

/// A file with objects: an INSERT names the dictionary D1.
pub(super) fn with_objects(blocks: &str, entities: &str, objects: &str) -> String {
    let objects = format!("0 SECTION 2 OBJECTS {objects} 0 ENDSEC 0 EOF");
    let objects: String = objects
        .split_whitespace()
        .map(|word| word.to_owned() + "\n")
        .collect();
    file("", blocks, entities).replace("0\nEOF\n", &objects)
}

/// To the block from where it was clipped: moved by 100 and 0.
pub(super) const MATRICES: &str = "40 1 40 0 40 0 40 -100 40 0 40 1 40 0 40 0 40 0 40 0 40 1 40 0
    40 1 40 0 40 0 40 0 40 0 40 1 40 0 40 0 40 0 40 0 40 1 40 0";

#[test]
fn a_clipped_block_shows_only_its_parts_within_the_clip() {
    let blocks =
        "0 BLOCK 2 a 0 LINE 10 0 20 0 11 40 21 0 0 SOLID 10 0 20 5 11 40 21 5 12 0 22 9 13 40 23 9
        0 POINT 10 90 20 0 0 ENDBLK";
    let entities = "0 INSERT 5 1F 102 {ACAD_XDICTIONARY 360 D1 102 } 2 a 10 100 20 0 0 LINE 10 0 20 0 11 9 21 0";
    let objects = |corners: &str| {
        format!(
            "0 DICTIONARY 5 D1 3 OTHER 360 D9 3 ACAD_FILTER 360 D2 0 DICTIONARY 5 D2 3 SPATIAL 360 F1
            0 XRECORD 5 D9 0 SPATIAL_FILTER 5 F1 330 D2 {corners} 71 1 72 0 73 0 {MATRICES}"
        )
    };
    let text = with_objects(blocks, entities, &objects("70 2 10 110 20 -1 10 120 20 7"));
    let (artwork, warnings) = draw_text(&text);
    assert_eq!(warnings, [""; 0]);
    let layer = &artwork.layers[0];
    let mut lengths: Vec<f64> = layer
        .strokes
        .iter()
        .map(|stroke| stroke.length_mm().round())
        .collect();
    lengths.sort_by(f64::total_cmp);
    // The line outside of the block is whole; of the block 10 mm show, and two edges of the solid.
    assert_eq!(lengths[..2], [9.0, 10.0], "{lengths:?}");
    let area = bounds_of_strokes(&[Stroke::open(layer.areas[0].rings[0].clone())]);
    assert_eq!([area.width(), area.height()].map(f64::round), [10.0, 2.0]);
    // A clip with other corners than two is the polygon through them.
    let triangle = objects("70 3 10 110 20 -1 10 120 20 -1 10 120 20 9");
    let (artwork, _) = draw_text(&with_objects(blocks, entities, &triangle));
    let lengths: Vec<f64> = artwork.layers[0]
        .strokes
        .iter()
        .map(Stroke::length_mm)
        .collect();
    assert!(
        lengths.iter().any(|length| (length - 9.0).abs() < 1e-6),
        "{lengths:?}"
    );
}

#[test]
fn every_copy_of_a_block_has_its_attributes() {
    let blocks = "0 BLOCK 2 a 0 POINT 10 0 20 0 0 ENDBLK";
    let entities = "0 INSERT 66 1 2 a 10 0 20 0 50 90 70 3 71 2 44 10 45 20 0 ATTRIB 10 1 20 0 40 2 1 I 0 SEQEND";
    let (artwork, _) = draw_text(&file("", blocks, entities));
    let strokes = &artwork.layers[0].strokes;
    let dots: Vec<Point> = strokes
        .iter()
        .filter(|stroke| stroke.points.len() == 1)
        .map(|stroke| stroke.points[0])
        .collect();
    let letters: Vec<Point> = strokes
        .iter()
        .filter(|stroke| stroke.points.len() > 1)
        .map(|stroke| stroke.points[0])
        .collect();
    assert_eq!([dots.len(), letters.len()], [6, 6]);
    // Each letter lies as far from its dot as the first from its own.
    let ways: Vec<[f64; 2]> = dots
        .iter()
        .map(|dot| {
            let nearest = letters
                .iter()
                .min_by(|a, b| a.distance(*dot).total_cmp(&b.distance(*dot)));
            let way = *nearest.unwrap() - *dot;
            [way.x, way.y].map(|mm| (mm * 1e3).round())
        })
        .collect();
    assert!(ways.iter().all(|way| *way == ways[0]), "{ways:?}");
}

#[test]
fn faces_tables_and_leaders_are_drawn() {
    let face = |hidden: u32| {
        let insert = format!(
            "0 3DFACE 10 0 20 0 30 5 11 9 21 0 31 5 12 9 22 9 32 0 13 0 23 9 33 0 70 {hidden}"
        );
        let (artwork, warnings) = draw(&insert);
        assert_eq!(warnings, [""; 0]);
        let strokes = artwork.layers[0].strokes.iter();
        strokes.map(Stroke::length_mm).sum::<f64>()
    };
    assert_eq!([face(0), face(1), face(10)], [36.0, 27.0, 18.0]);
    let (artwork, _) = draw("0 3DFACE 10 0 20 0 11 3 21 0 12 3 22 4 13 3 23 4");
    assert_eq!(artwork.layers[0].strokes[0].length_mm(), 12.0);
    let table = "0 BLOCK 2 *T1 0 LINE 10 0 20 0 11 40 21 0 0 ENDBLK";
    let (artwork, _) = draw_text(&file(
        "",
        table,
        "0 POINT 10 0 20 0 0 ACAD_TABLE 2 *T1 10 100 20 0 11 0 21 1",
    ));
    let ends = &artwork.layers[0].strokes[1].points;
    assert!(
        (ends[1] - ends[0]).y < -39.9 && ends[0].x > 99.9,
        "{ends:?}"
    );
    let (artwork, warnings) =
        draw("0 LEADER 3 STANDARD 71 1 72 0 76 3 10 0 20 0 10 5 20 5 10 9 20 5");
    assert_eq!(artwork.layers[0].strokes[0].points.len(), 3);
    assert_eq!(warnings, ["27:1: 1 LEADER: drawn without its arrow"]);
}

#[test]
fn a_multileader_is_drawn_with_its_lines_and_its_note() {
    let note = |text: &str| {
        format!(
            "0 MULTILEADER 8 notes 300 CONTEXT_DATA{{ 40 1 10 30 20 20 41 2.5 290 1 304 {text} 11 0 21 0 31 1 \
             12 31 22 21 32 0 13 1 23 0 33 0 43 0 45 1 171 1 296 0 \
             302 LEADER{{ 290 1 291 1 10 20 20 20 30 0 11 1 21 0 31 0 90 0 40 10 \
             304 LEADER_LINE{{ 10 0 20 0 30 0 10 5 20 15 30 0 91 0 305 }} \
             304 LEADER_LINE{{ 10 9 20 0 30 0 91 1 305 }} 303 }} 301 }} 340 1E 11 7 21 7"
        )
    };
    let (artwork, warnings) = draw(&note("I"));
    assert_eq!(artwork.layers[0].name, "notes");
    let strokes = &artwork.layers[0].strokes;
    let leaders: Vec<f64> = strokes[..2].iter().map(Stroke::length_mm).collect();
    let expected = [
        5_f64.hypot(15.0) + 15_f64.hypot(5.0) + 10.0,
        11_f64.hypot(20.0) + 10.0,
    ];
    for (found, expected) in leaders.iter().zip(expected) {
        assert!(
            (found - expected).abs() < 1e-9,
            "{found}, expected {expected}"
        );
    }
    // The letter hangs from the place of the note, 1 mm above the place to which the lines lead.
    let letter = bounds_of_strokes(&strokes[2..]);
    let above = strokes[0].points.last().unwrap().y - letter.y0;
    let found = [letter.x0, letter.height(), above];
    for (found, expected) in found.into_iter().zip([31.0, 2.5, 1.0]) {
        assert!((found - expected).abs() < 0.01, "{letter:?}, {above} mm");
    }
    assert!(
        warnings[0].ends_with("1 MULTILEADER: drawn without its arrow"),
        "{warnings:?}"
    );
}

#[test]
fn a_mesh_is_drawn_by_the_edges_of_its_faces_each_once() {
    let corners = "92 4 10 0 20 0 30 0 10 4 20 0 30 0 10 4 20 3 30 1 10 0 20 3 30 1";
    let mesh = |faces: &str| {
        format!("0 MESH 71 2 72 0 91 0 {corners} {faces} 94 1 90 0 90 1 95 1 140 0 90 0")
    };
    let (artwork, warnings) = draw(&mesh("93 8 90 3 90 0 90 1 90 2 90 3 90 0 90 2 90 3"));
    let length_mm: f64 = artwork.layers[0]
        .strokes
        .iter()
        .map(Stroke::length_mm)
        .sum();
    assert_eq!(
        (length_mm, artwork.layers[0].strokes.len()),
        (4.0 + 3.0 + 4.0 + 3.0 + 5.0, 5)
    );
    assert_eq!(warnings, [""; 0]);
    for wrong in [
        "93 2 90 3 90 0",
        "93 4 90 3 90 0 90 1 90 4",
        "93 1 90 -1",
        "93 1 90 1.5",
    ] {
        let error = error(file("", "", &mesh(wrong)).as_bytes());
        assert!(error.contains("MESH"), "{wrong}: {error}");
    }
}

#[test]
fn a_wipeout_is_skipped_and_hides_nothing() {
    let (_, warnings) = draw("0 LINE 10 0 20 0 11 5 21 5 0 WIPEOUT 10 0 20 0 11 1 21 0 12 0 22 1");
    assert!(
        warnings[0].contains("1 WIPEOUT: left out, and what it covers is drawn"),
        "{warnings:?}"
    );
}
