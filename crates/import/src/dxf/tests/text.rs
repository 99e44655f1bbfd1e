use dobot_geometry::{Stroke, Vec2};
use proptest::prelude::*;

use super::*;
use crate::source::tests::sides_from_dot;

/// A dot at the origin, then entities, in whose words `_` is a space; left, bottom, right and top
/// of their ink, in millimetres from the dot, y up.
fn written(blocks: &str, entities: &str) -> [f64; 4] {
    let text = file("", blocks, &format!("0 POINT 10 0 20 0 {entities}"));
    let (artwork, _) = draw_text(&text.replace('_', " "));
    let strokes: Vec<Stroke> = artwork
        .layers
        .into_iter()
        .flat_map(|layer| layer.strokes)
        .collect();
    sides_from_dot(&strokes)
}

#[test]
fn letters_in_parts_are_written_as_those_in_one() {
    for kind in ["TEXT", "MTEXT"] {
        let draw = |text: &str| draw(&format!("0 {kind} 10 0 20 0 40 21 1 {text}"));
        let (whole, warnings) = draw("\u{e9}a");
        assert_eq!(warnings, Vec::<String>::new());
        assert_eq!(draw("e\u{301}a"), (whole.clone(), Vec::new()));
        assert_eq!(draw("e\\U+0301a"), (whole, Vec::new()));
    }
}

#[test]
fn a_text_is_placed_on_its_base_line_at_its_justification() {
    // H is 14 wide at a height of 21, the next letter is 22 farther.
    for (groups, wanted) in [
        ("1 H", [100.0, 200.0, 114.0, 221.0]),
        ("1 HH", [100.0, 200.0, 136.0, 221.0]),
        ("1 _H", [120.0, 200.0, 134.0, 221.0]),
        ("1 H 41 2", [100.0, 200.0, 128.0, 221.0]),
        ("1 H 50 90", [79.0, 200.0, 100.0, 214.0]),
        ("1 H 51 45", [100.0, 200.0, 135.0, 221.0]),
        ("1 H 71 2", [86.0, 200.0, 100.0, 221.0]),
        ("1 H 71 4", [100.0, 179.0, 114.0, 200.0]),
        ("1 H 71 6", [86.0, 179.0, 100.0, 200.0]),
        ("1 HH 72 1 11 300 21 400", [282.0, 400.0, 318.0, 421.0]),
        ("1 HH 72 2 11 300 21 400", [264.0, 400.0, 300.0, 421.0]),
        ("1 H 72 4 11 300 21 400", [293.0, 389.5, 307.0, 410.5]),
        ("1 H 73 1 11 300 21 400", [300.0, 407.0, 314.0, 428.0]),
        ("1 H 73 2 11 300 21 400", [300.0, 389.5, 314.0, 410.5]),
        ("1 H 73 3 72 1 11 300 21 400", [293.0, 379.0, 307.0, 400.0]),
        // Some programs leave out the second point, and mean the first.
        ("1 HH 72 1", [82.0, 200.0, 118.0, 221.0]),
        ("1 H 73 3 72 2", [86.0, 179.0, 100.0, 200.0]),
        ("1 H 72 5", [100.0, 200.0, 114.0, 221.0]),
        ("1 H 72 3 11 128 21 200", [100.0, 200.0, 128.0, 242.0]),
        ("1 H 72 3 11 100 21 228", [58.0, 200.0, 100.0, 228.0]),
        ("1 H 72 5 11 128 21 200", [100.0, 200.0, 128.0, 221.0]),
        ("1 H 210 0 220 0 230 -1", [-114.0, 200.0, -100.0, 221.0]),
        ("1 I", [100.0, 200.0, 100.0, 221.0]),
        ("1 I 72 5 11 108 21 200", [100.0, 200.0, 100.0, 221.0]),
        ("1 %%072H", [100.0, 200.0, 136.0, 221.0]),
    ] {
        let text = format!("0 TEXT 10 100 20 200 40 21 {groups}");
        assert_eq!(written("", &text), wanted, "{groups}");
    }
    for attribute in [
        "0 ATTRIB 10 100 20 200 40 21 1 H 74 2 11 300 21 400",
        "0 ATTRIB 10 100 20 200 40 21 1 H 74 2 11 300 21 400 101 Embedded 11 9 21 9 70 1",
    ] {
        assert_eq!(written("", attribute), [300.0, 389.5, 314.0, 410.5]);
    }
    let block = "0 BLOCK 2 a 0 TEXT 10 5 20 5 40 21 1 H 0 ENDBLK";
    let inserted = "0 INSERT 2 a 10 100 20 200 41 2 42 3";
    assert_eq!(written(block, inserted), [110.0, 215.0, 138.0, 278.0]);
}

#[test]
fn paragraphs_are_aligned_at_their_point() {
    for (groups, wanted) in [
        ("1 H", [100.0, 179.0, 114.0, 200.0]),
        ("1 H 71 1", [100.0, 179.0, 114.0, 200.0]),
        ("1 H 71 2", [93.0, 179.0, 107.0, 200.0]),
        ("1 H 71 3", [86.0, 179.0, 100.0, 200.0]),
        ("1 H 71 4", [100.0, 189.5, 114.0, 210.5]),
        ("1 H 71 5", [93.0, 189.5, 107.0, 210.5]),
        ("1 H 71 6", [86.0, 189.5, 100.0, 210.5]),
        ("1 H 71 7", [100.0, 200.0, 114.0, 221.0]),
        ("1 H 71 8", [93.0, 200.0, 107.0, 221.0]),
        ("1 H 71 9", [86.0, 200.0, 100.0, 221.0]),
        ("1 H 71 7 11 0 21 2", [79.0, 200.0, 100.0, 214.0]),
        ("1 H 71 7 50 90", [79.0, 200.0, 100.0, 214.0]),
        ("1 H 71 7 50 90 11 1 21 0", [100.0, 200.0, 114.0, 221.0]),
        ("1 H 210 0 220 0 230 -1", [86.0, 179.0, 100.0, 200.0]),
        (
            "1 H 11 1 21 0 210 0 220 0 230 -1",
            [100.0, 200.0, 114.0, 221.0],
        ),
        // Leaning back: its letters are seen shorter from above.
        (
            "1 H 71 7 210 0 220 -0.6 230 0.8",
            [100.0, 200.0, 114.0, 216.8],
        ),
        (
            "1 H 71 7 11 1 21 0 210 0 220 -0.6 230 0.8",
            [100.0, 200.0, 114.0, 216.8],
        ),
        // Lines are 35 apart.
        (r"1 H\PH", [100.0, 144.0, 114.0, 200.0]),
        (r"1 H\P\PH", [100.0, 109.0, 114.0, 200.0]),
        (r"1 H\PH 44 2", [100.0, 109.0, 114.0, 200.0]),
        (r"1 H\PH 71 4", [100.0, 172.0, 114.0, 228.0]),
        (r"1 H\PH 71 7", [100.0, 200.0, 114.0, 256.0]),
        ("1 H_H_H", [100.0, 179.0, 190.0, 200.0]),
        ("1 H_H_H 41 60", [100.0, 144.0, 152.0, 200.0]),
        ("1 H_H_H 41 40", [100.0, 109.0, 114.0, 200.0]),
        // 90 wide: as narrow as other letters, it needs no second line.
        ("1 H_H_H 41 81", [100.0, 179.0, 181.0, 200.0]),
        ("1 H_H_H 41 70", [100.0, 144.0, 152.0, 200.0]),
        ("1 HH_H 41 1", [100.0, 144.0, 136.0, 200.0]),
        ("3 H_ 1 H", [100.0, 179.0, 152.0, 200.0]),
        ("1 H 101 Embedded 1 H", [100.0, 179.0, 114.0, 200.0]),
        // Newer programs repeat the point there, where a direction would be.
        (
            "1 H 71 7 50 90 101 Embedded 70 1 10 1 20 0 11 100 21 200 40 0 71 9",
            [79.0, 200.0, 100.0, 214.0],
        ),
    ] {
        let text = format!("0 MTEXT 10 100 20 200 40 21 {groups}");
        assert_eq!(written("", &text), wanted, "{groups}");
    }
}

#[test]
fn attributes_are_drawn_where_they_are_visible() {
    let definition = "0 ATTDEF 10 100 20 200 40 21 1 HH 2 H";
    // Among the entities a definition shows its tag.
    assert_eq!(written("", definition), [100.0, 200.0, 114.0, 221.0]);
    let drawn = |flags: u32| {
        let block = format!("0 BLOCK 2 a {definition} 70 {flags} 0 ENDBLK");
        let entities = "0 POINT 10 0 20 0 0 INSERT 66 1 2 a 10 0 20 0
            0 ATTRIB 10 0 20 0 40 21 1 H 70 1 0 SEQEND";
        let (artwork, warnings) = draw_text(&file("", &block, entities));
        assert_eq!(warnings, [""; 0]);
        artwork.layers[0].strokes.len()
    };
    // In a block its value where all copies share it: two H of three strokes.
    assert_eq!([0, 1, 2, 3].map(drawn), [1, 1, 7, 1]);
}

#[test]
fn a_dimension_is_the_picture_in_its_block() {
    let block =
        "0 BLOCK 2 *D1 10 0 20 0 0 LINE 10 10 20 20 11 40 21 20 0 POINT 8 Defpoints 10 0 20 0
        0 MTEXT 10 25 20 22 40 5 71 8 1 \\A1;HH 0 ENDBLK";
    let dimension = "0 DIMENSION 2 *D1 10 99 20 99 11 99 21 99 70 32 1 text 13 10 23 20";
    let found = written(block, dimension);
    assert_eq!(
        [found[0], found[1], found[2], found[3]],
        [10.0, 20.0, 40.0, 27.0]
    );
    let (artwork, warnings) = draw_text(&file("", block, dimension));
    assert_eq!(warnings, [""; 0]);
    assert!(artwork.points().all(|p| p.x <= 30.0 && p.y <= 7.0));
    let moved = written(block, "0 DIMENSION 2 *D1 12 1 22 2 10 99 20 99");
    assert_eq!(moved, [11.0, 22.0, 41.0, 29.0]);
}

proptest! {
    #[test]
    fn a_text_fits_between_its_points(
        text in "[A-H][A-Za-z0-9]{0,8}",
        height in 1.0..50.0_f64,
        (x, y) in (20.0..90.0_f64, -90.0..90.0_f64),
        column in prop::sample::select(vec![3, 5]),
    ) {
        let entities = format!(
            "0 POINT 10 0 20 0 0 TEXT 10 0 20 0 11 {x} 21 {y} 40 {height} 72 {column} 1 {text}"
        );
        let strokes = &draw(&entities).0.layers[0].strokes;
        let origin = strokes[0].points[0];
        let way = Vec2::new(x, -y);
        let shares = strokes[1..].iter().flat_map(|stroke| &stroke.points);
        let shares: Vec<f64> = shares.map(|&p| (p - origin).dot(way) / way.hypot2()).collect();
        let least = shares.iter().fold(f64::MAX, |a, &b| a.min(b));
        let most = shares.iter().fold(f64::MIN, |a, &b| a.max(b));
        // Curves may swing a little over their corners.
        prop_assert!(least.abs() < 0.05 && (most - 1.0).abs() < 0.05, "{least} {most}");
    }

    #[test]
    fn no_text_in_a_file_makes_it_panic(
        kind in "TEXT|MTEXT|ATTRIB|ATTDEF",
        text in "([ -~äß漢]|\\\\[A-Za-z]|%%[a-z]|\\\\P){0,30}",
        height in 0.1..50.0_f64,
        numbers in prop::collection::vec(("11|21|41|44|50|51|70|71|72|73|74|230", -9..9), 0..9),
    ) {
        let numbers: Vec<String> = numbers.iter().map(|(code, value)| format!("{code} {value}")).collect();
        let numbers = numbers.join(" ");
        let entity = format!("0 {kind} 10 0 20 0 40 {height} 1 ~ {numbers} 0 LINE 10 0 20 0 11 9 21 9");
        let text = file("", "", &entity).replace("~\n", &format!("{text}\n"));
        if let Ok((artwork, _)) = super::read(text.as_bytes(), &ReadOptions::default()) {
            prop_assert!(artwork.points().all(|p| p.x.is_finite() && p.y.is_finite()));
        }
    }
}
