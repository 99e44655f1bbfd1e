#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

use dobot_geometry::Vec2;
use proptest::prelude::*;

use super::*;
use crate::source::tests::sides_from_dot;

/// A dot at the origin, then the label; left, bottom, right and top of that, in millimetres
/// from the dot, y up.
fn written(text: &str) -> [f64; 4] {
    sides_from_dot(&strokes(&format!("IN;SP1;PD;PU;{text}")))
}

#[test]
fn a_label_is_placed_on_its_base_line_in_the_given_size() {
    // H is as wide as a character, and as tall.
    for (text, wanted) in [
        ("PU400,800;LBH\x03", [10.0, 20.0, 11.87, 22.69]),
        ("PU400,800;SI;LBH\x03", [10.0, 20.0, 11.87, 22.69]),
        ("PU400,800;SI.3,.5;LBH\x03", [10.0, 20.0, 13.0, 25.0]),
        ("PU400,800;SI-.3,.5;LBH\x03", [7.0, 20.0, 10.0, 25.0]),
        ("PU400,800;SI.3,-.5;LBH\x03", [10.0, 15.0, 13.0, 20.0]),
        // 10000 by 7200 units lie between P1 and P2.
        ("PU400,800;SR2,5;LBH\x03", [10.0, 20.0, 15.0, 29.0]),
        ("PU400,800;SR;LBH\x03", [10.0, 20.0, 11.875, 22.7]),
        (
            "IP0,0,4000,2000;PU400,800;SR2,5;LBH\x03",
            [10.0, 20.0, 12.0, 22.5],
        ),
        (
            "IP4000,0,0,2000;PU400,800;SR2,5;LBH\x03",
            [8.0, 20.0, 10.0, 22.5],
        ),
        (
            "IP0,0,4000,4000;SC0,10,0,20;PU1,4;SI.3,.5;LBH\x03",
            [10.0, 20.0, 13.0, 25.0],
        ),
        ("PU400,800;SI.3,.5;SL1;LBH\x03", [10.0, 20.0, 18.0, 25.0]),
        ("PU400,800;SI.3,.5;SL1;SL;LBH\x03", [10.0, 20.0, 13.0, 25.0]),
        ("SI1,1;DF;PU400,800;LBH\x03", [10.0, 20.0, 11.87, 22.69]),
        // W is wider than H, and is squeezed to its width.
        ("PU400,800;SI.3,.5;LBW\x03", [10.0, 20.0, 13.0, 25.0]),
        ("BLH\x03PU400,800;SI.3,.5;PB;", [10.0, 20.0, 13.0, 25.0]),
        ("SI.3,.5;SMH;PU400,800;", [8.5, 17.5, 11.5, 22.5]),
    ] {
        assert_eq!(written(text), wanted, "{text}");
    }
}

#[test]
fn a_label_runs_in_its_direction() {
    for (text, wanted) in [
        ("DI0,1;LBH\x03", [5.0, 20.0, 10.0, 23.0]),
        ("DI-2,0;LBH\x03", [7.0, 15.0, 10.0, 20.0]),
        ("DI0,1;DI;LBH\x03", [10.0, 20.0, 13.0, 25.0]),
        ("DI0,1;DI0,0;LBH\x03", [5.0, 20.0, 10.0, 23.0]),
        ("DR0,1;LBH\x03", [5.0, 20.0, 10.0, 23.0]),
        ("DR0,1;DR;LBH\x03", [10.0, 20.0, 13.0, 25.0]),
        ("IP0,0,-40,40;DR9,0;LBH\x03", [7.0, 15.0, 10.0, 20.0]),
        ("DI3,4;LBH\x03", [6.0, 20.0, 11.8, 25.4]),
        ("IP0,0,400,200;DR3,8;LBH\x03", [6.0, 20.0, 11.8, 25.4]),
        ("DI0,1;LB H\x03", [5.0, 24.5, 10.0, 27.5]),
    ] {
        let text = format!("PU400,800;SI.3,.5;{text}");
        assert_eq!(written(&text), wanted, "{text}");
    }
    let turned = "RO90;PU800,-400;SI.3,.5;LBH\x03";
    assert_eq!(written(turned), [5.0, 20.0, 10.0, 23.0]);
}

#[test]
fn the_pen_advances_by_cells_and_lines() {
    // A cell is 4.5 mm wide, a line 10 mm high.
    for (text, [left, bottom]) in [
        ("LB H\x03", [14.5, 20.0]),
        ("LB \x03LBH\x03", [14.5, 20.0]),
        ("ES1;LB H\x03", [19.0, 20.0]),
        ("ES-.1,.5;LB \n\x08H\x03", [10.0, 5.0]),
        ("ES1,1;ES;LB H\x03", [14.5, 20.0]),
        ("LB  \r\nH\x03", [10.0, 10.0]),
        ("LB \nH\x03", [14.5, 10.0]),
        ("LB  \x08H\x03", [14.5, 20.0]),
        ("LB\tH\x03", [32.5, 20.0]),
        ("LB\x07\x0e\x0fH\x03", [10.0, 20.0]),
        ("CP1,-.5;LBH\x03", [14.5, 15.0]),
        ("LB  \x03CP;LBH\x03", [10.0, 10.0]),
        ("LB \x03CP2,1;LB\rH\x03", [10.0, 30.0]),
        ("LB \x03CP2,0;LB\rH\x03", [10.0, 20.0]),
        ("LB \x03PR40,0;LB \rH\x03", [15.5, 20.0]),
        ("LB \x03DI;LB \rH\x03", [14.5, 20.0]),
        ("LB \x03PU;LB \rH\x03", [10.0, 20.0]),
        ("LO4;LB   \x03LO1;LBH\x03", [10.0, 20.0]),
        ("LO5;LB   \r\nH\x03", [8.5, 7.5]),
        ("DT#;LB #LBH#", [14.5, 20.0]),
        ("DT#,1;LB #LBH#", [14.5, 20.0]),
        ("DTH,0;LB HDT;", [14.5, 20.0]),
        ("DT#;DT;LBH\x03", [10.0, 20.0]),
    ] {
        let text = format!("PU400,800;SI.3,.5;{text}");
        assert_eq!(
            written(&text),
            [left, bottom, left + 3.0, bottom + 5.0],
            "{text:?}"
        );
    }
    // A line continues from the next cell.
    let text = "PU400,800;SI.3,.5;PD;LBH\x03PR40,0;";
    assert_eq!(corners(text).last().unwrap(), &[(4.5, 5.0), (5.5, 5.0)]);
}

#[test]
fn a_label_is_aligned_at_its_origin() {
    for (origin, [left, bottom]) in [
        (1, [10.0, 20.0]),
        (2, [10.0, 17.5]),
        (3, [10.0, 15.0]),
        (4, [6.25, 20.0]),
        (5, [6.25, 17.5]),
        (6, [6.25, 15.0]),
        (7, [2.5, 20.0]),
        (8, [2.5, 17.5]),
        (9, [2.5, 15.0]),
        (11, [12.5, 22.5]),
        (12, [12.5, 17.5]),
        (13, [12.5, 12.5]),
        (14, [6.25, 22.5]),
        (15, [6.25, 17.5]),
        (16, [6.25, 12.5]),
        (17, [0.0, 22.5]),
        (18, [0.0, 17.5]),
        (19, [0.0, 12.5]),
        (21, [10.0, 20.0]),
    ] {
        let text = format!("PU400,800;SI.3,.5;LO{origin};LBHH\x03");
        assert_eq!(
            written(&text),
            [left, bottom, left + 7.5, bottom + 5.0],
            "{origin}"
        );
    }
}

#[test]
fn labels_are_in_roman_8_or_utf_8() {
    let letters = |label: &[u8]| {
        let text = [b"SI.3,.5;LB", label, b"\x03"].concat();
        let (artwork, warnings) = super::read(&text, &ReadOptions::default()).unwrap();
        assert_eq!(warnings, []);
        artwork
    };
    assert_eq!(letters(b"\xB3\xCC\xDE"), letters("°äß".as_bytes()));
}

#[test]
fn characters_missing_from_labels_are_named() {
    let text = "SI.3,.5;SD1,21,2,1;CS33;DV1;TD1;LO21;PD40,0;";
    assert_eq!(draw(text).1, [""; 0]);
    let (_, warnings) = draw(&format!(
        "{text}DI0,0;\nLBa漢\tb字\x03CP;SM\u{3};SP;LBc\x03"
    ));
    assert_eq!(
        warnings,
        [
            "1:45: 1 zero direction: ignored (DI or DR)",
            "1:9: 1 font: written in plain letters, in the size set by SI or SR (SD)",
            "1:20: 1 character set: read as Roman-8, or as UTF-8 if it is valid UTF-8 (CS)",
            "1:25: 1 text path: written to the right (DV)",
            "1:29: 1 transparent label: its control characters are executed (TD)",
            "1:33: 1 PCL label origin: read as LO 1 (LO 21)",
            "2:1: 2 characters: not in the sans letters, left out; the first is '漢'",
            "2:1: 1 label tab: read as five spaces",
            "2:19: 1 penless line: left out (SP 0)",
        ]
    );
}

proptest! {
    #[test]
    fn letters_stay_in_their_cells(
        text in "[!-~ÄÖÜäöüß°µ]{1,12}",
        (width_cm, height_cm) in (0.1..2.0_f64, 0.1..2.0_f64),
        direction_deg in -180.0..180.0_f64,
        (x, y) in (-9_000..9_000, -9_000..9_000),
    ) {
        let (sin, cos) = direction_deg.to_radians().sin_cos();
        let file = format!(
            "PD;PU;PU{x},{y};SI{width_cm:.3},{height_cm:.3};DI{cos:.9},{sin:.9};LB{text}\x03"
        );
        let strokes = strokes(&file);
        let pen = strokes[0].points[0] + Vec2::new(f64::from(x), -f64::from(y)) * 0.025;
        let cells = f64::from(u32::try_from(text.chars().count()).unwrap());
        for p in strokes[1..].iter().flat_map(|stroke| &stroke.points) {
            let way = Vec2::new(p.x - pen.x, pen.y - p.y);
            let along = way.dot(Vec2::new(cos, sin)) / (10.0 * width_cm);
            let up = way.dot(Vec2::new(-sin, cos)) / (10.0 * height_cm);
            // A letter is 1.5 widths from the next; curves may swing a little over their corners.
            prop_assert!((-0.1..1.5 * cells - 0.4).contains(&along), "{along}");
            prop_assert!((-0.5..1.5).contains(&up), "{up}");
        }
    }
}
