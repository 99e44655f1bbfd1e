use super::*;

#[test]
fn a_servo_is_up_as_in_the_first_move() {
    let text = "M280 P0 S90\nG1 X5 Y5\nM280 P0 S30\nG1 X8\nM280 P0 S90\nG1 X0 Y0";
    assert_eq!(corners(text), [[(0.0, 0.0), (3.0, 0.0)]]);
    let (_, warnings) = draw(text);
    assert_eq!(
        warnings,
        ["1 pen lifted by a servo (M280): S90 read as pen up, the angle in the first move"]
    );
}

#[test]
fn a_servo_is_up_as_in_g0_if_the_file_begins_with_a_move() {
    let text = "G0 X10 Y10\nM280 P0 S30\nG1 X40 Y10\nM280 P0 S90\nG0 X60 Y40\nM280 P0 S30\nG1 X80 Y40\nM280 P0 S90";
    let lines = [[(0.0, 30.0), (30.0, 30.0)], [(50.0, 0.0), (70.0, 0.0)]];
    assert_eq!(corners(text), lines);
    let message = |text: &str| draw(text).1.concat();
    let servo = "1 pen lifted by a servo (M280): S90 read as pen up, ";
    assert_eq!(message(text), format!("{servo}the angle in G0 moves"));
    let only_g1 = text.replace("G0", "G1");
    assert_eq!(corners(&only_g1), lines);
    assert_eq!(
        message(&only_g1),
        format!("{servo}the angle at the end of the program")
    );
    let unlifted = only_g1.replace("Y40\nM280 P0 S90", "Y40");
    let commented = unlifted
        .replace("S90", "S90 ; pen UP")
        .replace("S30", "S30 ; not up but down");
    assert_eq!(corners(&commented), lines);
    assert_eq!(message(&commented), format!("{servo}as a comment states"));
    // One line is enough.
    let single = "G1 X10 Y10\nM280 S30\nG1 X40\nM280 S90";
    assert_eq!(corners(single), [[(0.0, 0.0), (30.0, 0.0)]]);
}

#[test]
fn m300_turns_the_servo_of_a_pen_whose_larger_angle_is_up() {
    let text = "G1 X10 Y10\nM300 S30\nG1 X40 Y10\nM300 S50\nG1 X60 Y40\nM300 S30\nG1 X80 Y40\nM300 S50\nM300 S255\nG1 X0 Y0";
    let lines = [[(0.0, 30.0), (30.0, 30.0)], [(50.0, 0.0), (70.0, 0.0)]];
    assert_eq!(corners(text), lines);
    let up = |reason: &str| format!("1 pen lifted by a servo (M300): S50 read as pen up, {reason}");
    assert_eq!(draw(text).1, [up("because it is the largest angle")]);
    // As Inkscape's extension writes it: the pen is tried first, and Z has no effect.
    let tried = "G92 X0 Y0 Z0\nM300 S30 (pen down)\nG4 P150\nM300 S50 (pen up)\nG4 P150\n"
        .to_owned()
        + text;
    let tried = tried.replace("X40 Y10", "X40 Y10 Z1");
    assert_eq!(corners(&tried), lines);
    assert_eq!(
        draw(&tried).1,
        [
            up("as a comment states"),
            "3:1: 1 pen test: left out, before the first move (M300)".to_owned()
        ]
    );
}

#[test]
fn a_beep_is_not_a_servo() {
    let text = "M300 S440 P200\nM300\nM300 S100 P50\nG0 X1\nG1 X5\nM300 S30 P50\nG1 Y5";
    assert_eq!(corners(text), [[(0.0, 5.0), (4.0, 5.0), (4.0, 0.0)]]);
    assert_eq!(draw(text).1[0], "1:1: 4 M300 codes: unknown, left out");
}

#[test]
fn m3_turns_the_servo_of_a_pen_if_all_moves_use_two_angles_and_the_program_waits() {
    let text = "G21 G90\nM3 S90\nG4 P0.2\nG1 X10 Y10 F3000\nM3 S30\nG4 P0.2\nG1 X40 F1000\nM3 S90\nG4 P0.2\nG1 X60 Y40 F3000\nM3 S30\nG4 P0.2\nG1 X80 F1000\nM3 S90\nG4 P0.2\nG1 X0 Y0\nM5\nG0 X5";
    let lines = [[(0.0, 30.0), (30.0, 30.0)], [(50.0, 0.0), (70.0, 0.0)]];
    assert_eq!(corners(text), lines);
    let message = |text: &str| draw(text).1.concat();
    let up = |reason: &str| format!("1 pen lifted by a servo (M3): S90 read as pen up, {reason}");
    assert_eq!(message(text), up("the angle in the first move"));
    assert!(!layers(text)[0].is_burned);
    // In haste where it is up: it need not wait then.
    let in_haste = text.replace("G1 X60", "G0 X60").replace("G1 X10", "G0 X10");
    let in_haste = in_haste.replace("G1 X0", "G0 X0");
    for text in [&in_haste, &in_haste.replace("G4 P0.2\n", "")] {
        assert_eq!(corners(text), lines);
        assert_eq!(message(text), up("the angle in G0 moves"));
    }
    // The file begins with a move.
    let begun = text.replace("M3 S90\nG4 P0.2\nG1 X10 Y10 F3000", "G1 X10 Y10 F3000");
    assert_eq!(corners(&begun), lines);
    assert_eq!(message(&begun), up("the angle at the end of the program"));
    let commented = text.replace("S30", "S30 (pen up)");
    assert!(message(&commented).contains("S30 read as pen up, as a comment states"));
}

#[test]
fn m3_is_the_power_of_a_laser_that_is_off_during_travel_or_is_set_in_the_moves() {
    let lines = "M3 S90\nG4 P1\nG1 X9\nM3 S30\nG4 P1\nG1 X19\nM3 S90\nG4 P1\nG1 X29\nM5";
    let off_between = lines.replace("G1 X19", "M5\nG0 X12\nM3 S30\nG4 P1\nG1 X19");
    let hasty = lines.replace("G4 P1\n", "");
    let beside = lines.replace("G1 X19", "G1 X19 S60");
    let three = lines.replace("G1 X29", "G1 X29\nM3 S60\nG4 P1\nG1 X39");
    let twice = "M3 S90\nG4 P1\nG1 X9\nM3 S30\nG4 P1\nG1 X19\nM5";
    let waits_before = "M3 S90\nG4 P1\nG1 X9\nG4 P1\nM3 S30\nG1 X19\nG4 P1\nM3 S90\nG1 X29\nM5";
    for text in [&off_between, &hasty, &beside, &three, twice, waits_before] {
        assert!(layers(text).iter().all(|layer| layer.is_burned), "{text}");
        let message = draw(text).1.concat();
        assert!(!message.contains("servo"), "{message}");
    }
    assert_eq!(draw(lines).1.len(), 1);
}

#[test]
fn a_servo_may_be_down_at_zero_if_it_is_up_in_all_of_g0() {
    let text = "M3 S90\nG4 P0.3\nG0 X10 Y10\nM3 S0\nG4 P0.3\nG1 X40 F900\nM3 S90\nG4 P0.3\nG0 X60 Y40\nM3 S0\nG4 P0.3\nG1 X80\nM3 S90\nG0 X0 Y0";
    let lines = [[(0.0, 30.0), (30.0, 30.0)], [(50.0, 0.0), (70.0, 0.0)]];
    assert_eq!(corners_by_pen(text), lines);
    let message = "1 pen lifted by a servo (M3): S90 read as pen up, the angle in G0 moves";
    assert_eq!(draw_by_pen(text).1, [message]);
    // It is a laser that is off at 0.
    let laser = text
        .replace("S90", "S9")
        .replace("S0", "S90")
        .replace("S9\n", "S0\n");
    assert_eq!(corners(&laser), lines);
    assert!(layers(&laser)[0].is_burned);
    assert!(layers(&text.replace("G0", "G1"))[0].is_burned);
}

#[test]
fn m3_and_m5_switch_the_tool_if_no_power_is_given_and_the_first_travel_is_off() {
    let text = "G21\nG1 X10 Y10 F900\nM3\nG1 X40\nM5\nG1 X60 Y40\nM3\nG1 X80\nM5\nG1 X0 Y0";
    let lines = [[(0.0, 30.0), (30.0, 30.0)], [(50.0, 0.0), (70.0, 0.0)]];
    assert_eq!(corners(text), lines);
    let message = "1 file without powers (S): G1, G2 and G3 draw while M3, M4 or M106 is active";
    assert_eq!(draw(text).1, [message]);
    // Some pens are up while M3 holds.
    let pen = "M3\nG0 X10 Y10\nM5\nG1 X40\nM3\nG0 X60 Y40\nM5\nG1 X80\nM3\nG0 X0 Y0";
    assert_eq!(corners_by_pen(pen), lines);
}
