//! What a file controls, stated and chosen, and files with mistakes.

use super::*;
use crate::options::GcodeTool;

fn options(gcode: Option<GcodeTool>, burns: bool) -> ReadOptions {
    ReadOptions {
        burns,
        gcode,
        ..ReadOptions::default()
    }
}

fn ends(text: &str, gcode: GcodeTool, burns: bool) -> Vec<Vec<(f64, f64)>> {
    corners_of(&draw_with(text, &options(Some(gcode), burns)).0)
}

const LASER: &str = "M4 S0\nG0 X0 Y0\nG1 X10 S500\nM5\n";
const MILL: &str = "M3 S9000\nG0 Z5\nG0 X0 Y0\nG1 Z-1\nG1 X10\nG0 Z5\nG0 X20\nM5\n";

#[test]
fn each_file_is_read_by_a_rule_that_one_sentence_states() {
    let laser =
        "G-code for a laser: G1, G2 and G3 draw while M3, M4 or M106 is active with S above 0";
    let mill = "G-code for a pen or a mill: drawn where Z is below 0.00 mm";
    for burns in [true, false] {
        assert_eq!(decision(LASER, &options(None, burns)), laser);
        assert_eq!(decision(MILL, &options(None, burns)), mill);
    }
    let guess = decision("G1 X10", &options(None, false));
    let plain =
        "1 file without commands for a laser or a pen (M3, Z): G1, G2 and G3 draw, G0 travels";
    assert_eq!(guess, format!("{plain}{CHOICE}"));
    assert_eq!(
        decision("G1 X10", &options(Some(GcodeTool::Pen), false)),
        plain
    );
}

#[test]
fn the_chosen_tool_decides_what_draws() {
    // A spindle that turns during travel by G1, taken for a laser, and the other way round.
    let text =
        "M3 S9000\nG0 Z5\nG0 X0 Y0\nG1 Z-1\nG1 X10\nG1 Z5\nG1 X20\nM5\nG1 Z-1\nG1 X30\nG0 Z5\n";
    for burns in [true, false] {
        let by_m3 = [[(0.0, 0.0), (10.0, 0.0), (20.0, 0.0)]];
        assert_eq!(ends(text, GcodeTool::Laser, burns), by_m3);
    }
    let by_z = [[(0.0, 0.0), (10.0, 0.0)], [(20.0, 0.0), (30.0, 0.0)]];
    for gcode in [GcodeTool::Mill, GcodeTool::Pen] {
        assert_eq!(ends(text, gcode, false), by_z);
    }
    // A laser stays dark where the file switches it off, whatever is chosen.
    assert_eq!(
        ends(text, GcodeTool::Mill, true),
        [[(0.0, 0.0), (10.0, 0.0)]]
    );
}

#[test]
fn a_dry_run_of_a_laser_draws_nothing_unless_it_is_read_as_a_file_for_a_pen() {
    let dry_run = "G21 G90\nM4 S0\nG0 X0 Y0\nG1 X10 F600\nM5\n";
    let read = super::super::read(dry_run.as_bytes(), &options(None, false));
    let error = read.unwrap_err().to_string();
    let message = "nothing to draw: the file is for a laser that has no power in any line (M3, M4 or M106, and S above 0); what.gcode pen draws it";
    assert_eq!(error, message);
    assert_eq!(
        ends(dry_run, GcodeTool::Pen, false),
        [[(0.0, 0.0), (10.0, 0.0)]]
    );
    // Z lifts a pen.
    let by_z = "M3 S0\nG0 Z5\nG0 X5\nG1 Z-1\nG1 X10\nG0 Z5";
    assert_eq!(corners_by_pen(by_z), [[(0.0, 0.0), (5.0, 0.0)]]);
}

#[test]
fn powers_in_moves_after_m5_are_reported() {
    let text = "M3\nG1 X10 S100\nM5\nG1 X20 S50\nG1 X30 S20\nG1 X40\nM3 S9\nG1 X50";
    let lines = [[(0.0, 0.0), (10.0, 0.0)], [(40.0, 0.0), (50.0, 0.0)]];
    let message = "4:1: 2 powered lines: left out, because M5 or M107 is active there; put M3 or M4 before it";
    for burns in [true, false] {
        let (artwork, warnings) = draw_with(text, &options(None, burns));
        assert_eq!(corners_of(&artwork), lines);
        assert!(warnings.contains(&message.to_owned()), "{warnings:?}");
    }
}

#[test]
fn everything_before_a_mistake_is_drawn_and_the_mistake_is_reported() {
    let word = "expected a word such as G1 or X-2.5";
    for (mistake, expected) in [
        (
            "G1 Xabc",
            "3:4: found \"Xabc\"; expected a word such as G1 or X-2.5",
        ),
        (
            "G41 D1",
            "3:1: found G41; expected moves by G0 to G3: cutter compensation is not supported",
        ),
        (
            "G2 X30 R1",
            "3:8: found an arc of radius 1.000 mm between points 20.000 mm apart",
        ),
        (
            "G1 X2000000",
            "3:1: leads to (2000000, 5) mm; at most 1000000 mm",
        ),
        ("#1=5", &format!("3:1: found \"#1=5\"; {word}")),
    ] {
        let text = format!("G1 X0 Y5\nX10\n{mistake}\nG1 X50 Y50");
        let (artwork, warnings) = draw_by_pen(&text);
        assert_eq!(
            corners_of(&artwork),
            [[(0.0, 5.0), (0.0, 0.0), (10.0, 0.0)]],
            "{text}"
        );
        let found = warnings
            .iter()
            .find(|warning| warning.starts_with(expected));
        let found = found.unwrap_or_else(|| panic!("{warnings:?}"));
        assert!(
            found.ends_with(": the rest of the file is left out"),
            "{found}"
        );
    }
    // An arc may leave the limits between its ends.
    let (artwork, warnings) = draw_by_pen("G1 X10\nG2 X10 Y0 I900000\nG1 X20");
    assert_eq!(corners_of(&artwork), [[(0.0, 0.0), (10.0, 0.0)]]);
    assert!(
        warnings
            .iter()
            .any(|warning| warning.starts_with("2:1: leads to ")),
        "{warnings:?}"
    );
}

#[test]
fn a_file_with_a_mistake_before_its_first_line_is_refused() {
    let read = super::super::read(b"G0 X5\nG1 Xabc\nG1 X9", &ReadOptions::default());
    assert!(
        read.unwrap_err()
            .to_string()
            .starts_with("2:4: found \"Xabc\"")
    );
}
