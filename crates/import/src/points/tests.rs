#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

use std::fmt::Write as _;

use dobot_geometry::Point;
use proptest::prelude::*;

use super::*;
use crate::artwork::Artwork;
use crate::error::SourceError;
use crate::options::ReadOptions;
use crate::warning::Warning;

fn csv(text: &str) -> (Artwork, Vec<String>) {
    let (artwork, warnings) = read_csv(text, &ReadOptions::default()).unwrap();
    (artwork, warnings.iter().map(Warning::to_string).collect())
}

fn json(text: &str) -> Artwork {
    read_json(text, &ReadOptions::default()).unwrap().0
}

fn corners(artwork: &Artwork) -> Vec<Vec<(f64, f64)>> {
    let strokes = artwork.layers.iter().flat_map(|layer| &layer.strokes);
    strokes
        .map(|stroke| stroke.points.iter().map(|p| (p.x, p.y)).collect())
        .collect()
}

#[test]
fn csv_is_read_with_and_without_header_and_with_any_separator() {
    let wanted = [vec![(0.0, 0.0), (10.0, 2.5)], vec![(5.0, 1.0)]];
    for text in [
        "1,1\n11,3.5\n\n6,2\n",
        "\u{FEFF}x;y\r\n1;1\r\n11;3.5\r\n\r\n\r\n6;2",
        "Y\tX\n1\t1\n3.5\t11\n\n2\t6\n",
        "stroke,x,y\na, 1, 1\na,1.1e1,+3.5\nb,6,2",
    ] {
        assert_eq!(corners(&csv(text).0), wanted, "{text}");
    }
}

#[test]
fn each_pen_of_a_csv_file_is_a_layer() {
    let (artwork, warnings) = csv("x,y,pen,z\n0,0,1,9\n9,0,1,9\n9,5,2,9\n0,5,2,9\n0,9,1,9\n");
    let found: Vec<_> = artwork
        .layers
        .iter()
        .map(|layer| (layer.name.as_str(), layer.strokes.len()))
        .collect();
    assert_eq!(found, [("pen 1", 2), ("pen 2", 1)]);
    assert_eq!(warnings, ["1:1: 1 column \"z\": left out"]);
}

#[test]
fn a_line_that_ends_at_its_start_is_closed() {
    assert!(csv("0,0\n9,0\n9,9\n0,0").0.layers[0].strokes[0].closed);
}

#[test]
fn json_is_read_as_lists_and_as_objects() {
    let wanted = [vec![(0.0, 0.0), (10.0, 2.5)], vec![(5.0, 1.0)]];
    for text in [
        "[[[1, 1], [11, 3.5]], [[6, 2]]]",
        r#"[[{"x": 1, "y": 1}, {"y": 3.5, "x": 11}], [[6, 2]]]"#,
        r#"{"strokes": [[[1, 1], [11, 3.5]], {"points": [[6, 2]]}]}"#,
    ] {
        assert_eq!(corners(&json(text)), wanted, "{text}");
    }
}

#[test]
fn json_strokes_name_their_layer_and_color() {
    let artwork = json(
        r##"{"strokes": [
            {"layer": "sea", "color": "#0000ff", "points": [[0, 0], [9, 9]]},
            {"color": "#FF8000", "closed": true, "points": [[0, 0], [9, 0], [9, 9]]},
            {"layer": "sea", "points": [[0, 9], [9, 0]]}
        ]}"##,
    );
    let layers = &artwork.layers;
    assert_eq!(
        (layers[0].name.as_str(), layers[0].color),
        ("sea", Some([0, 0, 255]))
    );
    assert_eq!(
        (layers[1].name.as_str(), layers[1].color),
        ("#FF8000", Some([255, 128, 0]))
    );
    assert_eq!(layers[0].strokes.len(), 2);
    let triangle = &layers[1].strokes[0];
    assert!(triangle.closed && triangle.points.len() == 4);
}

#[test]
fn bad_csv_is_refused_with_its_place() {
    for (text, expected) in [
        ("", "nothing to draw: no points in the file"),
        ("x,y\n", "nothing to draw: no points in the file"),
        (
            "1,5;2,5\n",
            "1:1: found \"1,5\"; expected a number such as 12.5, with a decimal point",
        ),
        (
            "1,5,2,5\n",
            "1:1: found \"1,5,2,5\"; expected a header with x and y, or two numbers x,y",
        ),
        (
            "hello\n",
            "1:1: found \"hello\"; expected a header with x and y, or two numbers x,y",
        ),
        (
            "x,y\n1,2\n1\n",
            "3:1: found 1 fields; expected 2 fields, decimals with a point",
        ),
        (
            "1,2\n1,zwei\n",
            "2:3: found \"zwei\"; expected a number such as 12.5, with a decimal point",
        ),
        (
            "1,2\n1,NaN\n",
            "2:3: found \"NaN\"; expected a number such as 12.5, with a decimal point",
        ),
        (
            "1,2\n1,1e999\n",
            "2:3: found \"1e999\"; expected a number such as 12.5, with a decimal point",
        ),
        (
            "1,2\n1,\n",
            "2:3: found \"\"; expected a number such as 12.5, with a decimal point",
        ),
        (
            "1,2\n0,2000000\n",
            "2:1: leads to (0, 2000000) mm; at most 1000000 mm from the origin are allowed",
        ),
    ] {
        let error = read_csv(text, &ReadOptions::default()).unwrap_err();
        assert_eq!(error.to_string(), expected, "{text}");
    }
}

#[test]
fn bad_json_is_refused_with_its_place() {
    let mut wrong = Vec::new();
    let shape = r#"expected a list of strokes, or {"strokes": [..]}"#;
    let point = r#"expected a point: [x, y] or {"x": .., "y": ..}"#;
    for (text, expected) in [
        (
            "",
            "1:1: found the end of the file; expected the rest of the JSON text",
        ),
        ("[]", "nothing to draw: no strokes in the file"),
        (
            "[[[1,2],",
            "1:8: found the end of the file in [0]; expected the rest of the JSON text",
        ),
        ("5", &format!("1:1: found the number 5; {shape}")),
        (
            "[[]]",
            "1:3: found a stroke without points in [0]; expected at least one point",
        ),
        (
            "[[1,2]]",
            &format!("1:3: found the number 1 in [0][0]; {point}"),
        ),
        (
            "[[[1,\n null]]]",
            "2:5: found null in [0][0][1]; expected a number",
        ),
        (
            "[[[1,2,3]]]",
            "1:8: found \"3]]]\" in [0][0]; expected JSON (trailing characters)",
        ),
        (
            "[[[1]]]",
            "1:5: found a list of length 1 in [0][0]; expected two numbers [x, y]",
        ),
        (r#"[[{"x":1}]]"#, "1:9: found no key `y` in [0][0]"),
        (r#"{"lines":[]}"#, "1:8: found the unknown key `lines`"),
        ("{}", "1:2: found no key `strokes`"),
        (
            r#"{"strokes":[],"strokes":[]}"#,
            "1:23: found the key `strokes` twice",
        ),
        (
            r#"{"strokes":{}}"#,
            "1:11: found an object in strokes; expected a list",
        ),
        ("{\"li\\nes\":[]}", r"1:9: found the unknown key `li\nes`"),
        (
            "[[[1e300,0]]]",
            "1:9: found the number 1e+300 in [0][0][0]; expected a number from -1000000 to 1000000 (mm)",
        ),
        ("[[[1e400,0]]]", "1:8"),
        (
            "[[[NaN,0]]]",
            "1:4: found \"NaN,0]]]\" in [0][0][0]; expected JSON (expected value)",
        ),
        (
            "[[[1,2]]] x",
            "1:11: found \"x\"; expected JSON (trailing characters)",
        ),
        (
            r#"{"strokes":[{"color":"red","points":[[0,0]]}]}"#,
            "1:26: found the text \"red\" in strokes[0].color; expected a color such as #ff8000",
        ),
    ] {
        let error = read_json(text, &ReadOptions::default())
            .unwrap_err()
            .to_string();
        if !error.starts_with(expected) {
            wrong.push(format!("{text}: {error}"));
        }
    }
    assert_eq!(wrong, Vec::<String>::new());
    let deep = "[".repeat(100_000);
    let error = read_json(&deep, &ReadOptions::default())
        .unwrap_err()
        .to_string();
    assert!(error.starts_with("1:"), "{error}");
}

#[test]
fn strokes_are_drawn_while_read_so_that_an_excess_one_is_reported_before_later_errors() {
    let strokes: Vec<String> = (0..1001)
        .map(|i| format!(r#"{{"layer":"{i}","points":[[0,0]]}}"#))
        .collect();
    let text = format!("[{},oops", strokes.join(","));
    let error = read_json(&text, &ReadOptions::default()).unwrap_err();
    assert_eq!(error, SourceError::TooManyLayers { limit: 1000 });
}

#[test]
fn a_truncated_file_gives_less_or_an_error() {
    let text = r#"{"strokes": [{"layer": "a", "closed": true, "points": [[0, 0], [9, 9]]}]}"#;
    for end in 0..text.len() {
        read_json(&text[..end], &ReadOptions::default()).unwrap_err();
    }
    let text = "x,y,stroke\n1,2,a\n3.5,-4,a\n\n5,6,b\n";
    for end in 0..text.len() {
        if let Ok((artwork, _)) = read_csv(&text[..end], &ReadOptions::default()) {
            assert!(artwork.points().count() <= 3);
        }
    }
}

proptest! {
    #[test]
    fn strokes_are_read_as_they_were_written(
        strokes in prop::collection::vec(prop::collection::vec((-1e4..1e4, -1e4..1e4), 1..9), 1..9)
    ) {
        let mut lines = String::new();
        for stroke in &strokes {
            for (x, y) in stroke {
                writeln!(lines, "{x},{y}").unwrap();
            }
            lines.push('\n');
        }
        let lists = format!("{strokes:?}").replace('(', "[").replace(')', "]");
        for artwork in [csv(&lines).0, json(&lists)] {
            let found: Vec<usize> = artwork.layers[0].strokes.iter().map(|stroke| stroke.points.len()).collect();
            let wanted: Vec<usize> = strokes.iter().map(Vec::len).collect();
            prop_assert_eq!(found, wanted);
            let wanted: Vec<Point> = strokes.iter().flatten().map(|stroke| Point::new(stroke.0, stroke.1)).collect();
            let shift = wanted[0] - artwork.points().next().unwrap();
            for (found, wanted) in artwork.points().zip(wanted) {
                prop_assert!((found + shift).distance(wanted) < 1e-6);
            }
        }
    }

    #[test]
    fn no_text_makes_it_panic(text in ".{0,200}", points in "[-0-9.,;:e\t\n\\[\\]{}\"xy]{0,100}") {
        for text in [text, points] {
            let _ = read_csv(&text, &ReadOptions::default());
            let _ = read_json(&text, &ReadOptions::default());
        }
    }
}

#[test]
fn a_stroke_with_too_many_points_is_refused_before_later_errors() {
    let lines = "1,1\n2,2\n".repeat(50_001) + "oops";
    let error = read_csv(&lines, &ReadOptions::default()).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the drawing has more than 100000 line segments, most of them straight; simplify it, or draw it in parts"
    );
    // Read once more with a larger tolerance it would have as many.
    assert!(!error.is_too_fine());
    let points = format!("[[{}oops", "[1,1],[2,2],".repeat(50_001));
    let error = read_json(&points, &ReadOptions::default()).unwrap_err();
    assert_eq!(
        error.to_string(),
        "1:600008: found a stroke of more than 100000 points in [0]; expected at most that in a drawing; simplify it"
    );
}
