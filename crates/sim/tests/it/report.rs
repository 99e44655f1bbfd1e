//! The text of `docs/fidelity.md`.

use std::fmt::Write as _;

use dobot_sim::{Comparison, Deviation, Trace};

use crate::recordings::{names, recording, twin};
use crate::scripts;

/// How far the twin is from the stock controller, recording by recording.
pub(crate) fn report() -> String {
    let rows: Vec<_> = names().iter().map(|name| Row::of(name)).collect();
    let statuses: usize = rows.iter().map(|it| it.comparison.statuses).sum();
    let worst = |size: fn(&Row) -> f64| rows.iter().map(size).fold(0.0, f64::max);
    let mut text = format!(
        "{HEAD}\nOver all {} recordings with {statuses} statuses the largest deviations are {} mm, {} and {}.\n\n{TABLE_HEAD}",
        rows.len(),
        number(worst(Row::mm)),
        degrees(worst(Row::deg)),
        pulses(worst(Row::pulses)),
    );
    for row in &rows {
        text += &row.text();
    }
    text += SCRIPTS;
    for kind in scripts::Kind::ALL {
        writeln!(text, "{}", scripts::Row::of(kind)).expect("a string takes all");
    }
    text
}

struct Row {
    name: String,
    expected: Trace,
    comparison: Comparison,
}

impl Row {
    fn of(name: &str) -> Self {
        let expected = recording(name);
        Self {
            name: name.to_owned(),
            comparison: twin(name).compare(&expected),
            expected,
        }
    }

    fn text(&self) -> String {
        format!(
            "| `{}` | {} | {} | {} | {} |\n",
            self.name,
            shows(&self.name),
            self.statuses(),
            self.outputs(),
            self.printed(),
        )
    }

    fn statuses(&self) -> String {
        let (missing, extra) = (&self.comparison.missing_ms, &self.comparison.extra_ms);
        if missing.is_empty() && extra.is_empty() {
            self.comparison.statuses.to_string()
        } else {
            let of = self.expected.statuses.len();
            format!("{} of {of}, {} more", self.comparison.statuses, extra.len())
        }
    }

    /// x, y and z.
    fn mm(&self) -> f64 {
        largest(&self.comparison.floats[..3])
    }

    /// All other floats but the pump's.
    fn deg(&self) -> f64 {
        let floats = &self.comparison.floats;
        largest(&floats[3..8]).max(floats[9].size())
    }

    fn pulses(&self) -> f64 {
        largest(&self.comparison.outputs[3..6])
    }

    /// Servos and pins, and the pump as the statuses tell it.
    fn outputs(&self) -> &'static str {
        let it = &self.comparison;
        let off = largest(&it.outputs[6..]).max(it.floats[8].size());
        if off == 0.0 && it.same_ticks {
            "equal"
        } else {
            "differ"
        }
    }

    fn printed(&self) -> &'static str {
        match (
            self.comparison.same_text,
            self.expected.other_port.is_empty(),
        ) {
            (false, _) => "differs",
            (true, true) => "none",
            (true, false) => "equal",
        }
    }
}

fn largest(deviations: &[Deviation]) -> f64 {
    deviations.iter().map(Deviation::size).fold(0.0, f64::max)
}

fn number(size: f64) -> String {
    if size.is_infinite() {
        "NaN differs".to_owned()
    } else if size == 0.0 || size >= 1.0 && size.fract() == 0.0 {
        format!("{size}")
    } else {
        format!("{size:.5}")
    }
}

fn degrees(size: f64) -> String {
    format!("{}°", number(size))
}

fn pulses(size: f64) -> String {
    let plural = if size == 1.0 { "" } else { "s" };
    format!("{} pulse{plural}", number(size))
}

fn shows(name: &str) -> &'static str {
    let shown = SHOWN.iter().find(|it| it.0 == name);
    shown.map_or("", |it| it.1)
}

const HEAD: &str = "\
# Fidelity

For users who rely on the twin (`--personality firmware-1.1`): how far it differs from the controller of a stock arm. That
controller's program, version 1.1, was run instruction by instruction on a simulated processor; its uploads and actions are
the recordings in [`vectors/traces/`](../vectors/traces/README.md). The twin gets the same bytes at the same times, and every status
and control tick of both are compared:

- **statuses**: their number, at equal times in both
- **mm**: the largest deviation of x, y and z in any status
- **degrees**: the largest deviation of the angles of base, rear arm, forearm, servo, tool and gripper
- **pulses**: the largest deviation of the motor pulses sent since power-up, in any tick; 88.89 pulses are a degree
- **outputs**: servo values, pump, valve and laser in every tick
- **text**: what is printed on the unused port

Where the recording has NaN, the twin must have NaN. A 0 is not rounded: every digit is equal. `crates/sim/tests/it/traces.rs`
allows no difference, and fails if this page is not the output of `cargo run -p dobot-examples --example fidelity`.
";

const TABLE_HEAD: &str = "\
| recording | what it shows | statuses | outputs | text |
|---|---|---:|---|---|
";

const SCRIPTS: &str = "
## Random scripts

The simulated processor is not part of this project, so random scripts are compared with a second implementation: the motion model
(`crates/motion`), with which plans and policies predict an arm. It calculates paths in double precision and continuous time, the twin
in single precision and in ticks. A script has one to six motions within reach, each from rest to rest; the generator is
`crates/sim/tests/it/scripts.rs`. It matches if every motion

- stays within 0.05 mm of the path of the model, seen in every fourth tick, and ends within 0.01 mm and 0.01° of its end; a jog, for which the
  model knows no ticks, within two ticks at its speed
- takes at most 120 ms longer than in the model, and 50 ms less: the rounding of each part to ticks, and the time until it is taken

What the two share cannot show in this comparison: for write vectors, the number of ticks (`TickStroke`). Voice, mouse, gestures, traps and
commands during a motion are compared with recordings only.

| scripts | match | motions | path, mm | end, mm | end, degrees | jogs, mm | later, ms |
|---|---:|---:|---:|---:|---:|---:|---:|
";

/// What each recording shows.
const SHOWN: [(&str, &str); 84] = [
    (
        "p01_boot_status",
        "switched on and left alone: when statuses come",
    ),
    ("p02_boot_pose", "switched on in another pose"),
    (
        "p03_joint_jog_base",
        "the base jogs to both sides, slowly and fast",
    ),
    ("p04_joint_jog_arms", "rear arm and forearm jog up and down"),
    (
        "p05_joint_jog_servo",
        "the servo jogs into its end at 90° and back",
    ),
    ("p06_jog_gripper", "the gripper jogs, without any end"),
    (
        "p07_jog_switch",
        "from one jog key to another without a release: the speed is kept",
    ),
    ("p08_linear_jog", "jogs along x, y and z"),
    ("p09_linear_jog_servo", "linear jogs that turn the tool"),
    ("p10_buttons", "pump and laser by jog buttons"),
    ("p11_movj_xyz", "joint moves to points"),
    (
        "p12_movl_xyz",
        "straight lines: long, short, across, and with a turn of the tool",
    ),
    ("p13_jump_xyz", "jumps, 10 mm and 30 mm high"),
    (
        "p14_movj_joint",
        "joint moves to angles, one of them to where the arm stands",
    ),
    ("p15_movl_joint", "a line to where given angles would be"),
    ("p16_jump_joint", "a jump to given angles"),
    (
        "p17_pause_grip",
        "pauses, and the pump that switches in their middle",
    ),
    (
        "p18_pause_repeats",
        "a pause that begins again while nothing waits",
    ),
    (
        "p19_cfg_playback",
        "speeds and accelerations of moves are set",
    ),
    ("p20_cfg_ratio", "speed and acceleration in percent are set"),
    ("p21_cfg_teach", "speeds and accelerations of jogs are set"),
    ("p22_cfg_tool", "tools are chosen, one of them unknown"),
    ("p23_cfg_angles", "new angles are set, without a motion"),
    (
        "p24_write_vectors",
        "write vectors one by one: plus x goes to minus x",
    ),
    (
        "p25_write_square",
        "a square of write vectors without a stop at its corners",
    ),
    ("p26_write_acc", "the write acceleration is set"),
    (
        "p27_laser",
        "laser vectors: rapid, burning, and the stop flag",
    ),
    (
        "p28_fifo_full",
        "more moves than the queue holds: the rest is lost",
    ),
    ("p29_credit_flow", "fifteen lines, one for each status"),
    ("p30_mouse", "mouse moves and how they are smoothed"),
    ("p31_gesture", "hand positions and how they are smoothed"),
    ("p32_pick_place", "pick and place with jumps"),
    (
        "p33_servo_tracking",
        "the servo holds the tool's direction along a line",
    ),
    (
        "p34_bt_status",
        "the Bluetooth port: its statuses and its order of axes",
    ),
    ("p35_bt_voice", "voice packets"),
    ("p36_framing", "noise, a wrong tail, and a head too many"),
    ("p37_cfg_queued", "settings wait for the motion before them"),
    (
        "p38_grab_values",
        "pump and gripper values that are neither 0 nor 1",
    ),
    (
        "p39_release_other_kind",
        "a jog that is released by the other state",
    ),
    (
        "p40_config_during_jog",
        "settings between a button and its release",
    ),
    (
        "p41_jog_percent",
        "percents that give whole ticks, or just not",
    ),
    (
        "p42_movj_whole_ticks",
        "a move whose time is whole ticks but for rounding",
    ),
    ("p43_jump_whole_ticks", "the same with a jump"),
    (
        "p44_write_below_zero",
        "trap: a vector after a speed below zero moves on slowly for ever",
    ),
    (
        "p45_laser_neither",
        "laser mode that says neither on nor off",
    ),
    (
        "p46_mouse_servo",
        "mouse packets with a servo angle out of range",
    ),
    (
        "p47_shared_history",
        "gestures after mouse packets, which are averaged in too",
    ),
    ("p48_voice_stops_line", "catch, said during a line, ends it"),
    (
        "p49_voice_in_movj",
        "voice during a move: the motors repeat their last pulses",
    ),
    (
        "p50_buttons_servos",
        "buttons and what they do to the servo outputs",
    ),
    (
        "p51_limit_in_run_down",
        "a run-down that meets a limit is over, and runs on",
    ),
    ("p52_tool_exact", "tools that are not exactly 0, 1 or 2"),
    ("p53_write_modes", "write modes that are not exactly 0 or 1"),
    (
        "p54_stop_sets_acceleration",
        "a stop packet sets the acceleration of a later vector",
    ),
    (
        "p55_refused_last_tick",
        "a vector whose last tick is refused at a limit leaves its end speed",
    ),
    ("p56_mouse_order", "the order of operations in mouse moves"),
    ("p57_gesture_stays", "the same gesture again and again"),
    (
        "p58_state15_after_mouse",
        "state 15 after a mouse: the average is held against the limits",
    ),
    (
        "p59_bt_fractional_state",
        "state 2.5 over Bluetooth, whose axes are not exchanged",
    ),
    ("p60_gripper_far", "servo outputs of more than 15 bits"),
    (
        "p61_voice_words",
        "which words and numbers voice understands",
    ),
    (
        "p62_voice_in_movl",
        "catch, said during a line, ends the line",
    ),
    (
        "p63_voice_in_pause",
        "voice during a pause: the next target is skipped",
    ),
    (
        "p64_voice_in_jump",
        "voice during a jump: the next jump continues its phase",
    ),
    (
        "p65_voice_speed_zero",
        "a spoken line at speed 0 is over immediately",
    ),
    (
        "p66_voice_in_vector",
        "voice during a vector: the arm is set back to its start",
    ),
    ("p67_voice_first_in_jump", "the same during a jump"),
    (
        "p68_voice_exact_length",
        "spoken lines are exactly along their axis",
    ),
    (
        "p69_gesture_sixteen_bits",
        "a gesture so far away that its ticks overflow",
    ),
    (
        "x10_movj_after_nan",
        "trap: a move when two of four angles are lost",
    ),
    (
        "x11_voice_not_understood",
        "trap: a text without an order during a move repeats the last pulses forever",
    ),
    (
        "x12_voice_bad_tail",
        "trap: the same with a voice packet whose tail is wrong",
    ),
    (
        "x13_voice_overfull",
        "trap: more than six places taken by voice repeat the last words forever",
    ),
    (
        "x14_line_speed_nan",
        "trap: a line whose speed is not a number arrives",
    ),
    (
        "x15_write_nan_length",
        "trap: a vector whose length is not a number loses the pose",
    ),
    (
        "x1_movl_zero_nan",
        "trap: a line to where the arm stands loses the pose",
    ),
    (
        "x2_write_zero_nan",
        "trap: a write vector without length loses the pose",
    ),
    (
        "x3_unknown_state_hang",
        "trap: an unknown state is never finished",
    ),
    (
        "x4_unknown_type_hang",
        "trap: an unknown way to move is never finished",
    ),
    ("x5_axis15_hang", "trap: a jog of axis 15 is never finished"),
    (
        "x6_out_of_reach_twice_nan",
        "trap: the second line out of reach is not stopped",
    ),
    (
        "x7_jog_past_reach_nan",
        "trap: the first limit that a jog meets does not stop it",
    ),
    ("x8_zero_speed_hang", "trap: a move at speed 0 never ends"),
    (
        "x9_zero_acc_nan",
        "trap: a move with acceleration 0 loses the pose",
    ),
];
