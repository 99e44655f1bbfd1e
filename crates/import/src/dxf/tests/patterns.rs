use super::*;

/// A hatch of a square of 20 mm, filled with these families of lines.
fn hatch(lines: &str) -> String {
    let count = lines.matches("53 ").count();
    format!(
        "0 HATCH 2 X 70 0 71 0 91 1 92 3 72 0 73 1 93 4 10 0 20 0 10 20 20 0 10 20 20 20 10 0 20 20 97 0
        75 0 76 1 52 0 41 1 77 0 78 {count} {lines} 98 1 10 5 20 5"
    )
}

fn lengths(lines: &str) -> Vec<f64> {
    let (artwork, warnings) = draw(&hatch(lines));
    assert_eq!(warnings, [""; 0]);
    assert!(artwork.layers[0].areas.is_empty());
    let strokes = artwork.layers[0].strokes.iter();
    strokes
        .map(|stroke| (stroke.length_mm() * 1e3).round() / 1e3)
        .collect()
}

#[test]
fn the_lines_of_a_pattern_fill_its_area() {
    // Level, 5 mm apart, from 2.5 mm up.
    assert_eq!(lengths("53 0 43 0 44 2.5 45 0 46 5 79 0"), [20.0; 4]);
    // At 45 degrees, through the corners: 28.3 mm in the middle, and 8 less on either side.
    let slanted = lengths("53 45 43 0 44 0 45 -2.828427 46 2.828427 79 0");
    let longest = slanted.iter().copied().fold(0.0, f64::max);
    assert!((longest - 28.284).abs() < 0.01, "{slanted:?}");
    assert_eq!(slanted.len(), 7);
    let crossed = lengths("53 0 43 0 44 2.5 45 0 46 5 79 0 53 90 43 2.5 44 0 45 -5 46 0 79 0");
    assert_eq!(crossed, [20.0; 8]);
}

#[test]
fn the_lines_of_a_pattern_may_be_dashed_and_dotted() {
    // 3 drawn, 1 not: 5 dashes on each line.
    assert_eq!(
        lengths("53 0 43 0 44 5 45 0 46 10 79 2 49 3 49 -1"),
        [3.0; 10]
    );
    // Every second row begins 2 mm farther: one dash is cut at either side.
    let bricks = lengths("53 0 43 0 44 5 45 2 46 10 79 2 49 3 49 -1");
    assert_eq!(bricks.iter().sum::<f64>(), 30.0, "{bricks:?}");
    assert!(bricks.len() > 10);
    let dots = lengths("53 0 43 1 44 5 45 0 46 10 79 2 49 0 49 -4");
    assert_eq!(dots, [0.0; 10]);
}

#[test]
fn a_pattern_of_too_many_lines_and_a_solid_one_are_areas() {
    for (text, message) in [
        (hatch("53 0 43 0 44 0 45 0 46 0.0001 79 0"), 1),
        (hatch("53 0 43 0 44 0 45 5 46 0 79 0"), 1),
        (
            hatch("53 0 43 0 44 0 45 0 46 5 79 0").replace("70 0", "70 1"),
            0,
        ),
        (hatch(""), 0),
    ] {
        let (artwork, warnings) = draw(&text);
        assert_eq!(
            (artwork.layers[0].areas.len(), warnings.len()),
            (1, message),
            "{text}"
        );
    }
}

#[test]
fn a_hatch_may_be_bounded_by_ellipses_and_splines() {
    let text = "0 HATCH 2 SOLID 70 1 91 1 92 1 93 1 72 3 10 0 20 0 11 10 21 0 40 0.5 50 0 51 360 73 1 97 0 75 0";
    let (artwork, warnings) = draw(text);
    assert_eq!(warnings, [""; 0]);
    assert!((artwork.width_mm - 20.0).abs() < 0.02 && (artwork.height_mm - 10.0).abs() < 0.02);
    // A straight spline from 0,0 to 10,0, also given by its fit points, and two lines back.
    let text = "0 HATCH 2 SOLID 70 1 91 1 92 1 93 3 72 4 94 1 73 0 74 0 95 4 96 2 40 0 40 0 40 1 40 1
        10 0 20 0 10 10 20 0 97 2 11 0 21 0 11 10 21 0 72 1 10 10 20 0 11 10 21 10 72 1 10 10 20 10 11 0 21 0 97 0 75 0";
    let (artwork, warnings) = draw(text);
    assert_eq!(warnings, [""; 0]);
    let length_mm = artwork.layers[0].strokes[0].length_mm();
    assert!(
        (length_mm - 20.0 - 200.0_f64.sqrt()).abs() < 1e-6,
        "{length_mm}"
    );
}
