use super::*;

/// Three lines along X, 1 mm apart, with a corner in the middle; their style has these flags.
fn strokes(style: u32, flags: u32) -> Vec<Stroke> {
    let corner = |x: u32| {
        format!(
            "11 {x} 21 0 12 1 22 0 13 0 23 1 74 2 41 0 41 0 75 0 74 2 41 1 41 0 75 0 74 2 41 -1 41 0 75 0 74 2 41 -2 41 0 75 0 "
        )
    };
    let corners = [0, 5, 10].map(corner).concat();
    let line = format!("0 MLINE 2 RAILS 340 1F 40 1 70 0 71 {flags} 72 3 73 4 10 0 20 0 {corners}");
    let style = format!("0 MLINESTYLE 5 1F 2 RAILS 70 {style}");
    let (artwork, warnings) = draw_text(&blocks::with_objects("", &line, &style));
    assert_eq!(warnings, [""; 0]);
    artwork.layers[0].strokes.clone()
}

#[test]
fn multilines_have_the_caps_and_mitres_of_their_style() {
    let count = |style| strokes(style, 1).len();
    assert_eq!(count(0), 4);
    assert_eq!(count(16), 5);
    assert_eq!(count(16 + 256), 6);
    assert_eq!(count(2), 5);
    assert_eq!(strokes(2, 3).len(), 7);
    // Caps that the line itself has not.
    assert_eq!(strokes(16 + 256, 1 + 4).len(), 5);
    assert_eq!(strokes(16 + 256, 1 + 4 + 8).len(), 4);
    let width = |style| bounds_of_strokes(&strokes(style, 1)).width();
    let near = |found: f64, wanted: f64| assert!((found - wanted).abs() < 0.02, "{found}");
    near(width(16 + 256), 10.0);
    // Half circles of 3 mm, and of 2 mm less.
    near(width(64), 11.5);
    near(width(64 + 1024), 13.0);
    near(width(512), 10.5);
    assert_eq!(count(32 + 64), 6);
}
