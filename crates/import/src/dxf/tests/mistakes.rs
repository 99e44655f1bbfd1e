//! Files with mistakes, and what is left out of a drawing.

use super::*;

const LINE: &str = "0 LINE 10 0 20 0 11 10 21 0 ";
const LAST: &str = "0 LINE 10 0 20 5 11 10 21 5 ";

fn lines_beside(mistake: &str) -> (Vec<Vec<(f64, f64)>>, Vec<String>) {
    let (artwork, warnings) = draw(&format!("{LINE}{mistake} {LAST}"));
    (corners(&artwork), warnings)
}

#[test]
fn objects_with_a_mistake_are_left_out_and_reported() {
    let both = [[(0.0, 5.0), (10.0, 5.0)], [(0.0, 0.0), (10.0, 0.0)]];
    for (mistake, expected) in [
        (
            "0 CIRCLE 10 x 20 0 40 5",
            "40:1: found \"x\" for group 10; expected a number from -1e12 to 1e12",
        ),
        (
            "0 CIRCLE 10 0 20 0",
            "37:1: found CIRCLE without group 40; expected a number",
        ),
        (
            "0 SPLINE 71 3 10 0 20 0",
            "37:1: found a spline of degree 3 with 1 control points",
        ),
        (
            "0 LINE 10 0 20 0 11 5e8 21 0",
            "37:1: leads to (500000000, 0) mm",
        ),
    ] {
        let (lines, warnings) = lines_beside(mistake);
        assert_eq!(lines, both, "{mistake}");
        let [warning] = &warnings[..] else {
            panic!("{mistake}: {warnings:?}");
        };
        assert!(warning.starts_with(expected), "{warning}");
        assert!(warning.ends_with(": its object is left out"), "{warning}");
    }
    let (_, warnings) = lines_beside(&"0 CIRCLE 10 0 20 0 ".repeat(3));
    assert_eq!(
        warnings,
        [
            "37:1: found CIRCLE without group 40; expected a number (first of 3): its object is left out"
        ]
    );
}

#[test]
fn a_mistake_in_a_block_costs_only_its_object() {
    let block = format!(
        "0 BLOCK 2 a 10 0 20 0 {LINE} 0 CIRCLE 10 0 20 0 0 INSERT 2 a 10 0 20 0 {LAST} 0 ENDBLK"
    );
    let (artwork, warnings) = draw_text(&file("", &block, "0 INSERT 2 a 10 7 20 7"));
    assert_eq!(
        corners(&artwork),
        [[(0.0, 5.0), (10.0, 5.0)], [(0.0, 0.0), (10.0, 0.0)]]
    );
    assert_eq!(warnings.len(), 2, "{warnings:?}");
    assert!(
        warnings[1].contains("found a block inside itself"),
        "{warnings:?}"
    );
}

#[test]
fn a_file_that_is_cut_off_is_drawn_up_to_there() {
    let whole = file("", "", &format!("{LINE}{LAST}"));
    let line = [[(0.0, 0.0), (10.0, 0.0)]];
    let last = whole.rfind("21\n5\n").unwrap();
    for (text, expected) in [
        (
            whole[..last].to_owned(),
            "found the end of the file; expected 0 and EOF: the file is cut off",
        ),
        (
            whole[..last].to_owned() + "oops\n5\n0\nEOF\n",
            "found \"oops\"; expected a group code such as 0 or 10",
        ),
    ] {
        let (artwork, warnings) = draw_text(&text);
        assert_eq!(corners(&artwork), line);
        let [warning] = &warnings[..] else {
            panic!("{warnings:?}");
        };
        assert!(warning.contains(expected), "{warning}");
        assert!(
            warning.ends_with(": the rest of the file is left out"),
            "{warning}"
        );
    }
}

#[test]
fn a_mistake_outside_of_objects_costs_only_its_group() {
    let layer = "0 TABLE 2 LAYER 0 LAYER 2 a 62 red 70 0 0 ENDTAB";
    let (artwork, warnings) = draw_text(&file(layer, "", LINE));
    assert_eq!(corners(&artwork), [[(0.0, 0.0), (10.0, 0.0)]]);
    assert!(
        warnings[0].contains("found \"red\" for group 62"),
        "{warnings:?}"
    );
    assert!(
        warnings[0].ends_with(": its group is left out"),
        "{warnings:?}"
    );
}

#[test]
fn many_different_mistakes_are_counted_together() {
    let mut mistakes = String::new();
    for i in 0..30 {
        write!(mistakes, "0 CIRCLE 10 x{i} ").unwrap();
    }
    let (_, warnings) = lines_beside(&mistakes);
    assert_eq!(warnings.len(), 21, "{warnings:?}");
    assert!(
        warnings[20].contains("further mistakes (first of 10)"),
        "{warnings:?}"
    );
}

#[test]
fn a_block_with_a_scale_of_0_is_left_out_with_its_count() {
    let block = format!("0 BLOCK 2 a 10 0 20 0 {LINE} 0 ENDBLK");
    let inserts = "0 INSERT 2 a 10 7 20 7 41 0 0 INSERT 2 a 10 7 20 7 42 0 0 INSERT 2 a 10 0 20 0";
    let (artwork, warnings) = draw_text(&file("", &block, inserts));
    assert_eq!(corners(&artwork), [[(0.0, 0.0), (10.0, 0.0)]]);
    let [warning] = &warnings[..] else {
        panic!("{warnings:?}");
    };
    assert!(
        warning.ends_with(": 2 INSERTs: left out, because its scale is 0"),
        "{warning}"
    );
}

#[test]
fn a_file_without_a_unit_that_states_inches_is_reported() {
    let text = file("", "", LINE).replace("$INSUNITS\n70\n4", "$MEASUREMENT\n70\n0");
    let (artwork, warnings) = draw_text(&text);
    assert_eq!(artwork.width_mm, 10.0);
    assert!(
        warnings[0].contains("taken for millimetres, although $MEASUREMENT 0 stands for inches"),
        "{warnings:?}"
    );
}

#[test]
fn a_spline_flagged_as_closed_that_is_open_is_reported_with_its_count() {
    let spline = |flags: u32, end: &str| {
        format!(
            "0 SPLINE 70 {flags} 71 2 40 0 40 0 40 0 40 0.5 40 1 40 1 40 1 10 0 20 0 10 40 20 0 10 40 20 40 {end} "
        )
    };
    let open = "10 0 20 40";
    let (artwork, warnings) = draw(&(spline(1, open) + &spline(1, open)));
    assert!(!artwork.layers[0].strokes[0].closed);
    let [warning] = &warnings[..] else {
        panic!("{warnings:?}");
    };
    let message = "2 unclosed splines: drawn open, as its control points are, although it is flagged as closed (70)";
    assert!(warning.ends_with(message), "{warning}");
    for quiet in [spline(0, open), spline(1, "10 0 20 0")] {
        assert_eq!(draw(&quiet).1, [""; 0], "{quiet}");
    }
}
