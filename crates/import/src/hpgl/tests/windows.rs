use super::*;

#[test]
fn everything_outside_a_window_is_cut_off_until_it_is_removed() {
    let line = "PU0,0;PD4000,0;PU;";
    let found = |text: &str| spans(&format!("PU0,0;PD0,4;PU{text}"));
    let all = [0.0, 10_000.0];
    let cut = [1000.0, 3000.0];
    let window = "IW400,-400,1200,400;";
    assert_eq!(
        found(&format!("{line}{window}{line}IW;{line}"))[1..],
        [all, cut, all]
    );
    assert_eq!(
        found(&format!("IW1200,400,400,-400;{line}IN;{line}"))[1..],
        [cut, all]
    );
    assert_eq!(
        found(&format!("{window}IW0,0,400,400;{line}"))[1..],
        [[0.0, 1000.0]]
    );
    assert_eq!(draw(&format!("{window}{line}")).1, [""; 0]);
    // In the units of the scale, with a warning.
    let scaled = format!("IP0,0,4000,4000;SC0,100,0,100;IW10,-10,30,10;SC;{line}");
    assert_eq!(found(&scaled)[1..], [cut]);
    let message = "1:31: 1 window in a scale: read as one in the units of SC, as in HP-GL/2 (IW)";
    assert_eq!(draw(&scaled).1, [message]);
    let flat = draw(&format!("IW0,0,0,400;{line}")).1;
    assert_eq!(flat, ["1:1: 1 flat window: nothing is clipped (IW)"]);
    assert_eq!(
        error(b"IW1,2,3;"),
        "1:1: found IW 1,2,3; expected x,y of two opposite corners"
    );
}

#[test]
fn a_window_cuts_dashes_letters_and_areas_and_turns_with_the_plot() {
    let length = |text: &str| strokes(text).iter().map(Stroke::length_mm).sum::<f64>();
    let near = |text: &str, wanted: f64| {
        let found = length(text);
        assert!(
            (found - wanted).abs() < 1e-2,
            "{text}: {found} mm, {wanted} mm wanted"
        );
    };
    near(
        "IW0,-40,600,40;LT2,10,1;PU0,0;PD1200,0;PU;IW;LT;PU0,0;PD0,40;",
        11.0,
    );
    near("IW0,-40,600,40;PU400,0;RA1200,20;", 10.5);
    near("RO90;IW0,-40,600,40;PU0,0;PD1200,0;", 15.0);
    near("IW0,-40,600,40;PU0,0;PD1200,0;RO90;PU0,0;PD1200,0;", 30.0);
    let letters = "PU0,0;SI.5,.7;LBOO\u{3}";
    assert!(length(&format!("IW0,0,100,1000;{letters}")) < 0.6 * length(letters));
    let (artwork, _) = draw("IW0,0,400,400;PU0,0;RA800,800;");
    assert_eq!((artwork.width_mm, artwork.layers[0].areas.len()), (10.0, 1));
    assert!(error(b"IW0,0,400,400;PU800,800;PD900,900;").starts_with("nothing to draw"));
}

#[test]
fn adaptive_dashes_fit_each_straight_line_and_curves_as_a_whole() {
    // 28 mm: three turns of 9.33 mm in place of 10 mm; and one of 4 mm.
    let found = spans("LT-2,10,1;PU0,0;PD1120,0,1120,160;");
    let ends = [
        [0.0, 233.0],
        [700.0, 1167.0],
        [1633.0, 2100.0],
        [2567.0, 2800.0],
    ];
    assert_eq!(found[..4], ends);
    assert_eq!(found.len(), 5);
    let (_, warnings) = draw("LT-2,10,1;PU0,0;PD1120,0,1120,160;");
    assert_eq!(warnings, [""; 0]);
    // 62.8 mm: six turns, and half a dash at both ends.
    assert_eq!(strokes("LT-2,10,1;PU0,0;CI400;").len(), 7);
}
