//! The burn of a laser: never where the file switches it off.

mod reference;

use self::reference::{Reference, Words, program};
use super::*;
use crate::options::GcodeTool;

const SWITCHED: &str = "G21 G90 F600\nG0 X0 Y0\nM3\nG1 X10\nM5\nG1 X20\nM3\nG1 X30\nM5\n";
const DRY_RUN: &str = "G21 G90\nM4 S0\nG0 X0 Y0\nG1 X10 F600\nM5\n";
const POWERS_WHILE_OFF: &str = "G21\nG90\nG28 XY\nM5\nG0 X0 Y0 F3000\nG1 X15 Y0 S100 F900\nG1 X15 Y15\nG0 X20 Y0 F3000\nG1 X35 Y0 S20 F900\nM5\nG0 X0 Y100\n";
const HOLES: &str = "G21\nG90\nG00 S7000\nG00 Z25\nM5\nM3\nG0 Z1\nG04 P1\nG1 F50\nG0 X4 Y6\nG1 Z-1.5\nG1 Z1\nG0 X14 Y6\nG1 Z-1.5\nG1 Z1\nG0 X24 Y6\nG1 Z-1.5\nG1 Z1\nG0 Z25\nM5\nM2\n";
const NEVER: &str = "nothing to draw: the laser has no power in any line (M3, M4 or M106, and S above 0 if the file uses S)";

#[test]
fn m5_and_m107_mean_off_for_a_laser_even_if_the_first_line_is_on() {
    let lines = [[(0.0, 0.0), (10.0, 0.0)], [(20.0, 0.0), (30.0, 0.0)]];
    let fan = SWITCHED.replace("M3", "M106").replace("M5", "M107");
    for text in [SWITCHED, &fan] {
        assert_eq!(corners(text), lines, "{text}");
        let message =
            "1 file without powers (S): G1, G2 and G3 draw while M3, M4 or M106 is active";
        assert_eq!(draw(text).1, [message]);
    }
    let whole = [[(0.0, 0.0), (10.0, 0.0), (20.0, 0.0), (30.0, 0.0)]];
    assert_eq!(corners_by_pen(SWITCHED), whole);
    assert_eq!(
        draw_by_pen(SWITCHED).1,
        ["1 file with ambiguous pen commands (M3, M5 or S): G1, G2 and G3 draw, G0 travels"]
    );
}

#[test]
fn a_laser_without_power_burns_nothing_and_this_is_reported() {
    assert_eq!(error(DRY_RUN), NEVER);
    assert!(error(POWERS_WHILE_OFF).starts_with(NEVER));
    // S0 in its own line, in a move, for a fan, and where Z lifts a pen.
    for text in [
        "M3\nS0\nG1 X10\nM5",
        "M3\nG1 X10 S0\nX20\nM5",
        "M106 S0\nG1 X10",
        "G0 Z5\nM3 S0\nG0 X5\nG1 Z-1\nG1 X10\nG0 Z5",
    ] {
        assert_eq!(error(text), NEVER, "{text}");
    }
}

#[test]
fn power_applies_from_the_line_that_sets_it() {
    assert_eq!(
        corners("M3\nG1 X10\nS0\nG1 X20\nS9\nG1 X30\nM5"),
        [[(0.0, 0.0), (10.0, 0.0)]]
    );
    // Beside the time of a dwell, and beside codes that are not known.
    assert_eq!(
        corners("M3 S9\nG1 X10\nG4 P1 S0\nG1 X20\nS9\nM5 M400\nG1 X30"),
        [[(0.0, 0.0), (10.0, 0.0)]]
    );
}

#[test]
fn a_spindle_that_waits_or_plunges_burns_nothing_and_a_pen_draws_its_holes() {
    let cycle = "M3 S1000\nG4 P2\nG0 Z5\nG0 X4 Y6\nG81 Z-1.5 R1\nX14\nX24\nG80\nM5";
    let holes = [[(0.0, 0.0)], [(10.0, 0.0)], [(20.0, 0.0)]];
    for (text, line) in [(HOLES, 11), (cycle, 5)] {
        let message = format!(
            "nothing to draw: no line with the laser on; G-code for a pen or a mill: drawn where Z is below 0.00 mm; {line}:1: 3 holes: not burned, because Z and drilling cycles do not switch a laser on"
        );
        assert_eq!(error(text), message, "{text}");
        assert_eq!(corners_by_pen(text), holes, "{text}");
        assert_eq!(draw_by_pen(text).1, <[&str; 0]>::default(), "{text}");
    }
}

#[test]
fn a_dwell_before_the_first_line_or_above_all_lines_burns_no_dot() {
    let line = [[(0.0, 0.0), (10.0, 0.0)]];
    let message =
        "spindle dwell: not burned (G4 before the first line, above all lines or of a drill)";
    let before = "M3 S255\nG0 X5 Y5\nG4 P1\nG0 X10\nG1 X20\nM5";
    assert_eq!(corners(before), line);
    assert_eq!(draw(before).1, [format!("3:1: 1 {message}")]);
    let above = "G0 Z0\nM3 S255\nG0 X10\nG1 X20\nG0 Z5\nG0 X30\nG4 P1\nG0 X40\nM5";
    assert_eq!(corners(above), line);
    assert_eq!(draw(above).1, [format!("7:1: 1 {message}")]);
    // At the height of the lines it is a dot of the laser.
    let at_zero = above.replace("Z5", "Z0");
    assert_eq!(corners(&at_zero).len(), 2);
}

#[test]
fn a_laser_that_moves_down_at_the_end_burns_its_lines() {
    let text = "G0 Z0\nM3 S255\nG0 X1\nG1 X11\nG1 Z-2\nM5";
    assert_eq!(corners(text), [[(0.0, 0.0), (10.0, 0.0)]]);
}

#[test]
fn a_file_for_a_pen_is_burned_without_its_dots_and_travels() {
    let text = "G0 Z5\nG0 X0 Y0\nG1 Z-1\nG1 X10\nG0 X20\nG1 X30\nG0 Z5\nG0 X40\nG1 Z-1\nG0 Z5";
    assert_eq!(
        corners(text),
        [[(0.0, 0.0), (10.0, 0.0)], [(20.0, 0.0), (30.0, 0.0)]]
    );
    assert_eq!(
        draw(text).1,
        [
            "5:1: 1 dark move: not burned, because the laser is off there (G0, M5, M107 or S0)",
            "9:1: 1 hole: not burned, because Z and drilling cycles do not switch a laser on",
        ]
    );
}

/// Asserts that each program burns 10 mm, in one line.
#[track_caller]
fn assert_one_line(texts: &[&str]) {
    for text in texts {
        assert_eq!(corners(text), [[(0.0, 0.0), (10.0, 0.0)]], "{text}");
    }
}

#[test]
fn a_fan_beside_m3_neither_switches_the_laser_on_nor_sets_its_power() {
    assert_one_line(&[
        "M106 S255\nG1 X10\nM3 S100\nG1 X20\nM5\nG1 X30\nM107",
        "M3 S100\nG1 X10\nM5\nM106 S255\nG1 X20\nM107",
        "M4 S0\nM106 S255\nG1 X10\nS100\nG1 X20\nM107 M5\nG1 X30",
        "M3 M106 S0\nG1 X10\nM3 S100\nG1 X20\nM5",
    ]);
}

#[test]
fn a_laser_is_dark_while_an_output_is_off() {
    assert_one_line(&[
        "M62 P0\nG1 X10\nM63 P0\nG1 X20",
        "G1 X10\nM64 P1\nG1 X20\nM65 P1\nG1 X30",
        "M67 E0 Q0\nG1 X10\nM67 E0 Q50\nG1 X20\nM68 E0 Q0\nG1 X30",
        "M42 P4 S255\nG1 X10\nM42 P4 S0\nG1 X20",
        "M62 P0\nG1 X10\nM5\nG1 X20",
        "M3 S100\nM67 E0 Q0\nG1 X10\nM67 E0 Q50\nG1 X20\nM5\nG1 X30",
        // The air is on, the laser is not.
        "M62 P0\nG1 X10\nM63 P0\nM62 P1\nG1 X20",
    ]);
    let (_, warnings) = draw("M3 S255\nM62 P0\nG1 X10\nM63 P0\nG1 X20");
    let message = |line, code| {
        format!("{line}:1: 1 {code} code: read as a switch of the tool, like M3 and M5")
    };
    assert_eq!(warnings, [message(2, "M62"), message(4, "M63")]);
}

#[test]
fn nothing_is_burned_after_the_end_of_a_program() {
    for end in ["M2", "M30", "M112", "%"] {
        let text = format!("%\nM3 S9\nG1 X10\n{end}\nG1 X20");
        assert_one_line(&[&text]);
    }
}

/// The ink of a laser where the program has it.
fn burned(text: &str) -> Vec<Stroke> {
    ink(text, None, true)
}

/// The ink of a file read for this tool, where the program has it.
fn ink(text: &str, gcode: Option<GcodeTool>, burns: bool) -> Vec<Stroke> {
    let options = ReadOptions {
        tolerance_mm: 0.02,
        gcode,
        burns,
        ..ReadOptions::default()
    };
    let (sketch, _) = sketch(text.as_bytes(), &options).unwrap();
    let strokes = sketch.layers().iter().flat_map(|layer| &layer.strokes);
    strokes.cloned().collect()
}

fn length_mm(strokes: &[Stroke]) -> f64 {
    strokes.iter().map(Stroke::length_mm).sum()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn nothing_is_burned_while_the_file_switches_the_laser_off(
        text in program(Words::ANY),
        gcode in prop::sample::select(vec![None, Some(GcodeTool::Laser), Some(GcodeTool::Pen), Some(GcodeTool::Mill)]),
    ) {
        let reference = Reference::read(&text);
        let strokes = ink(&text, gcode, true);
        for stroke in &strokes {
            if let [dot] = stroke.points[..] {
                prop_assert!(reference.waits_at(dot), "dot at {dot:?} of\n{text}");
            }
            for (from, to) in stroke.segments() {
                for t in [0.0, 0.25, 0.5, 0.75, 1.0] {
                    let p = from.lerp(to, t);
                    prop_assert!(reference.burns_at(p), "line {from:?} to {to:?} of\n{text}");
                }
            }
        }
        let (found, lit) = (length_mm(&strokes), reference.length_mm());
        prop_assert!(found <= lit * 1.01 + 1e-6, "{found} mm of {lit} mm of\n{text}");
    }

    #[test]
    fn a_pen_draws_nothing_while_a_file_for_a_laser_switches_it_off(text in program(Words::ANY)) {
        let reference = Reference::read(&text);
        for (from, to) in ink(&text, Some(GcodeTool::Laser), false).iter().flat_map(Stroke::segments) {
            let middle = from.midpoint(to);
            prop_assert!(reference.burns_at(middle), "line {from:?} to {to:?} of\n{text}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn everything_is_burned_while_a_file_for_a_laser_switches_it_on(text in program(Words::OF_LASER)) {
        let (found, lit) = (length_mm(&burned(&text)), Reference::read(&text).length_mm());
        prop_assert!((found - lit).abs() <= lit * 0.01 + 1e-6, "{found} mm of {lit} mm of\n{text}");
    }
}
