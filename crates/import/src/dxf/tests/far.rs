use super::*;

#[test]
fn a_plan_in_millimetres_in_national_coordinates_keeps_its_size() {
    let (east, north) = (4_468_503_000.0, 5_333_304_000.0);
    let corners = [(0.0, 0.0), (12_000.25, 0.0), (12_000.25, 9_000.5)];
    let mut line = "0 LWPOLYLINE ".to_owned();
    for (x, y) in corners {
        write!(line, "10 {} 20 {} ", east + x, north + y).unwrap();
    }
    let circle = format!("0 CIRCLE 10 {east} 20 {north} 40 500");
    let (artwork, warnings) = draw(&(line + &circle));
    assert_eq!(warnings, [""; 0]);
    let near = |found: f64, wanted: f64| assert!((found - wanted).abs() < 0.02, "{found}");
    near(artwork.width_mm, 12_500.25);
    near(artwork.height_mm, 9_500.5);
}

#[test]
fn a_drawing_too_far_off_to_resolve_its_places_is_refused() {
    let line = |x: &str| file("", "", &format!("0 LINE 10 {x} 20 0 11 {x} 21 5"));
    assert_eq!(
        error(line("2e12").as_bytes()),
        "30:1: found \"2e12\" for group 10; expected a number from -1e12 to 1e12"
    );
    let in_metres = line("1e12").replace("70\n4\n", "70\n6\n");
    let message = error(in_metres.as_bytes());
    assert!(
        message.contains("leads to (1000000000000000, 0) mm; at most"),
        "{message}"
    );
    // Other numbers are as large as they were.
    let turned = file("", "", "0 CIRCLE 10 0 20 0 40 2e9");
    assert!(error(turned.as_bytes()).ends_with("expected a number from -1e9 to 1e9"));
}
