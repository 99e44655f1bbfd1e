use super::*;

#[test]
fn a_mill_draws_while_it_is_down_even_if_its_spindle_turns_during_travel() {
    let text = "M3 S10000\nG0 Z5\nG0 X1 Y1\nG1 Z-1\nG1 X4\nG1 Z2\nG1 X9\nG0 Z5\nG0 X0 Y0\nM5";
    assert_eq!(corners(text), [[(0.0, 0.0), (3.0, 0.0)]]);
}

#[test]
fn a_spindle_that_turns_while_z_moves_up_and_down_is_not_a_laser() {
    let by_g1 = "G21 G90\nM3 S1000\nG0 Z5\nG0 X5 Y5\nG1 Z-1 F100\nG1 X10\nG1 Z5\nG1 X20\nG1 Z-1\nG1 X30\nG0 Z5\nM5";
    assert_eq!(
        corners(by_g1),
        [[(0.0, 0.0), (5.0, 0.0)], [(15.0, 0.0), (25.0, 0.0)]]
    );
    let ramps_out =
        "M3 S9\nG0 X10 Y10 Z5\nG1 Z-1\nG1 X30\nG1 X40 Z5\nG0 X60\nG1 Z-1\nG1 X80\nG0 Z5\nM5";
    assert_eq!(
        corners(ramps_out),
        [
            vec![(0.0, 0.0), (20.0, 0.0), (20.0 + 10.0 / 6.0, 0.0)],
            vec![(50.0, 0.0), (70.0, 0.0)]
        ]
        .map(|line| line
            .iter()
            .map(|&(x, y)| (rounded(x), y))
            .collect::<Vec<_>>())
    );
    // It is off while another tool is put in.
    let tools = format!("T1 M6\n{by_g1}\nT2 M6\n{}", ramps_out.replace("Y10", "Y5"));
    assert_eq!(corners(&tools).len(), 4);
}

#[test]
fn a_tool_that_is_off_during_travel_is_a_laser_even_if_its_z_moves_and_this_is_reported() {
    let switched = "M3 S255\nG0 X0 Z5\nG1 Z0\nG1 X4\nM5\nG1 Z1\nG1 X6\nM3\nG1 Z-1\nG1 X9\nG0 X0";
    assert_eq!(
        corners(switched),
        [[(0.0, 0.0), (4.0, 0.0)], [(6.0, 0.0), (9.0, 0.0)]]
    );
    let message =
        "1 laser at several heights: everything with the laser on (M3, M4 or M106) draws, at any Z";
    assert_eq!(draw(switched).1, [message]);
    let passes =
        "M4 S9\nG0 X0 Z0\nG1 X4\nG0 X0\nG1 Z-1\nG1 X4\nG0 X6 Z0\nG1 X9\nG0 X6\nG1 Z-1\nG1 X9";
    assert_eq!(corners(passes).len(), 4);
}

#[test]
fn shallow_cuts_are_drawn_if_only_moves_along_z_go_above_zero() {
    let text = "G21 G90\nG0 X0 Y0\nG0 Z15\nG1 Z-1 F100\nX20\nZ-0.5\nX40\nZ-1\nX60\nZ15";
    assert_eq!(
        corners(text),
        [[(0.0, 0.0), (20.0, 0.0), (40.0, 0.0), (60.0, 0.0)]]
    );
    assert_eq!(
        draw(text).1,
        ["1 file with all lines below Z 0: drawn where Z is below 0.00 mm"]
    );
    let machine = "G0 X1 Y0\nG0 Z0\nG0 Z-40\nX5\nG1 Z-45\nX9\nG0 Z-40\nX0\nG0 Z0";
    assert_eq!(corners(machine), [[(0.0, 0.0), (4.0, 0.0)]]);
    assert_eq!(
        draw(machine).1,
        ["1 file with travels below Z 0: drawn where Z is below -40.00 mm"]
    );
    // A single hole has no line with a height.
    assert_eq!(
        corners_by_pen("G0 X5 Y5\nG0 Z5\nG1 Z-1\nG0 Z5"),
        [[(0.0, 0.0)]]
    );
}

#[test]
fn lines_at_zero_among_lower_ones_are_drawn_if_the_tool_comes_down_to_them_or_else_reported() {
    let pen = "G0 Z5\nX10 Y10\nG1 Z0\nX20\nZ-0.2\nX30\nG0 Z5\nX60\nG1 Z0\nX70\nG0 Z5";
    let message = |text: &str| draw(text).1.concat();
    for text in [
        pen.to_owned(),
        pen.replace("G0", "G1"),
        format!("M3 S9\n{pen}"),
    ] {
        let lines = [
            vec![(0.0, 0.0), (10.0, 0.0), (20.0, 0.0)],
            vec![(50.0, 0.0), (60.0, 0.0)],
        ];
        assert_eq!(corners(&text), lines, "{text}");
        assert_eq!(
            message(&text),
            "1 file with lines at Z 0: drawn like those below, because the tool moves down to them"
        );
    }
    let relief = "G0 Z5\nX-1 Y0\nG1 Z0\nX5\nX10 Z-0.2\nX20 Z0\nG0 Z5";
    let above = "G0 Z5\nX-1 Y0\nG1 Z0\nX5\nG1 Z-0.2\nX10\nG1 Z0\nX30\nG1 Z5";
    let below = [
        vec![(0.0, 0.0), (5.0, 0.0), (15.0, 0.0)],
        vec![(0.0, 0.0), (5.0, 0.0)],
    ];
    for (text, lines) in [relief, above].into_iter().zip(below) {
        assert_eq!(corners(text), [lines], "{text}");
        assert_eq!(
            message(text),
            "1 file with lines at Z 0: left out, because only lines below Z 0 are drawn"
        );
    }
    // A pen that is up at 0.
    let up = "G0 Z0\nG1 X10\nZ-1\nX20\nZ0\nX30";
    assert_eq!(corners(up), [[(0.0, 0.0), (10.0, 0.0)]]);
    assert_eq!(message(up), "");
}

#[test]
fn a_spindle_that_is_off_between_operations_is_still_one_if_it_turns_while_plunging() {
    let operation = |y: u32| {
        format!(
            "M3 S9000\nG0 X0 Y{y}\nG0 Z0\nG1 Z-1 F100\nG1 X10\nG0 Z0\nG0 X20\nG1 Z-1\nG1 X30\nG0 Z5\nM5\n"
        )
    };
    let text = format!("G21 G90\nG0 Z5\n{}{}", operation(0), operation(10));
    assert_eq!(
        corners(&text),
        [
            vec![(0.0, 10.0), (10.0, 10.0)],
            vec![(20.0, 10.0), (30.0, 10.0)],
            vec![(0.0, 0.0), (10.0, 0.0)],
            vec![(20.0, 0.0), (30.0, 0.0)],
        ]
    );
    assert!(!layers(&text)[0].is_burned);
    // A travel at the height of the work does not change that.
    let low = text.replace("G0 X20", "G0 X15\nG0 Z-1\nG0 X16\nG0 Z0\nG0 X20");
    assert!(!layers(&low)[0].is_burned);
    // A laser comes down before it is on.
    let laser = low.replace("M3 S9000\n", "");
    let laser = laser.replace("G1 Z-1 F100\n", "G1 Z-1 F100\nM3 S9\n");
    assert!(layers(&laser)[0].is_burned);
}

#[test]
fn a_ramp_is_drawn_only_where_it_is_below_the_paper() {
    // Z 5 to -2 over 20 mm is below 0 from 5 / 7 on.
    let text = "G21 G90\nG0 Z5\nG0 X0 Y0\nG1 X21 Z-2 F100\nG1 X40\nG1 X61 Z5\nG0 X0 Y10\nG1 Z-2\nG1 Y20\nG0 Z5";
    for burns in [true, false] {
        let options = ReadOptions {
            burns,
            ..ReadOptions::default()
        };
        let lines = [
            vec![(15.0, 20.0), (21.0, 20.0), (40.0, 20.0), (46.0, 20.0)],
            vec![(0.0, 10.0), (0.0, 0.0)],
        ];
        assert_eq!(corners_of(&draw_with(text, &options).0), lines);
    }
    // Half of a half turn is below.
    let helix = "G0 Z1\nG0 X10 Y0\nG3 X-10 I-10 Z-1\nG0 Z1";
    let (artwork, _) = draw_by_pen(helix);
    let length = artwork.layers[0].strokes[0].length_mm();
    let expected = 5.0 * PI;
    assert!(
        (length - expected).abs() < 0.05,
        "{length}, expected {expected}"
    );
    // A rapid move need not be straight.
    let rapid = "G0 Z1\nG0 X0 Y0\nG1 Z-1\nG1 X10\nG0 X20 Z1";
    assert_eq!(corners_by_pen(rapid), [[(0.0, 0.0), (10.0, 0.0)]]);
    let high = "G1 Z0\nG0 X-5 Y0\nG0 X0\nG1 X10 Z4\nG1 X20\nG1 X30\nG1 X40 Z0\nG0 X50";
    assert_eq!(
        corners_by_pen(high),
        [[
            (0.0, 0.0),
            (5.0, 0.0),
            (15.0, 0.0),
            (25.0, 0.0),
            (30.0, 0.0)
        ]]
    );
}

#[test]
fn a_pen_is_down_at_high_z_if_all_travels_are_below_the_lines() {
    let text = "G21 G90\nG1 Z0.5 F5000\nG0 X10 Y10\nG1 Z5\nG1 X40\nG1 Z0.5\nG0 X60 Y40\nG1 Z5\nG1 X80\nG1 Z0.5\nG0 X0 Y0";
    let lines = [[(0.0, 30.0), (30.0, 30.0)], [(50.0, 0.0), (70.0, 0.0)]];
    assert_eq!(corners(text), lines);
    let message = "1 file with travels (G0) below its lines: drawn where Z is above 2.75 mm";
    assert_eq!(draw(text).1, [message]);
    // The way home may be lower.
    let home = format!("G28\n{text}\nG1 Z0\nG1 X-9");
    assert_eq!(corners(&home), lines);
    // One travel at the start proves nothing if there are travels by G1 above.
    let by_g1 =
        "G0 Z0\nG0 X1\nG1 Z5\nG1 X10 Y10\nG1 Z1\nG1 X40\nG1 Z5\nG1 X60 Y40\nG1 Z1\nG1 X80\nG1 Z5";
    assert!(!draw_by_pen(by_g1).1.concat().contains("above"));
}
