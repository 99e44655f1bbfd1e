use super::*;
use crate::{Script, simulate_watched};

fn plot(script: &str) -> String {
    let script: Script = script.parse().unwrap();
    let personality = Personality::Firmware11;
    let mut snapshots = Vec::new();
    let simulation = simulate_watched(&script, personality, |at, controller| {
        snapshots.push(Snapshot::of(controller, at));
    });
    Plot {
        title: "<square> & circle",
        personality,
        snapshots: &snapshots,
        statuses: &simulation.unwrap().trace.statuses,
    }
    .to_svg()
}

#[test]
fn a_picture_names_script_personality_axes_and_units() {
    let svg = plot("!end 1000\n100 3 0 240 0 0 0 0 1 0 0");
    for words in [
        "&lt;square> &amp; circle",
        "firmware-1.1  ·  0.98 s",
        "x (mm)",
        "y (mm)",
        "z (mm)",
        "Joint angles (°)",
        "Joint speeds (°/s)",
        "Tool speed (mm/s)",
        "time (s)",
        "rear arm",
        "laser",
    ] {
        assert!(svg.contains(words), "{words}");
    }
}

#[test]
fn pump_and_laser_have_their_colours_while_they_are_on() {
    let count = |svg: &str, color: &str| svg.matches(&format!("fill=\"{color}\"")).count();
    let on = plot("!end 1000\n100 2 9 0 0 0 0 0 50 0 0\n300 2 13 0 0 0 0 0 50 0 0");
    let off = plot("!end 1000");
    for color in [PUMP, LASER] {
        assert_eq!(count(&on, color), count(&off, color) + 1, "{color}");
    }
}

#[test]
fn a_lost_pose_is_marked_and_leaves_no_trace_of_nan_in_the_lines() {
    // A write vector of length zero.
    let svg = plot("!end 3000\n100 4 0 0 0 0 0 0 0 0 50");
    assert!(svg.contains("the pose is NaN"));
    assert!(!svg.contains("NaN ") && !svg.contains("\"NaN") && !svg.contains("inf"));
    assert!(!plot("!end 3000").contains("NaN"));
}

#[test]
fn a_long_run_is_not_as_much_greater_as_it_is_longer() {
    let jog = |n: u32| format!("{} 2 {} 0 0 0 0 0 50 0 0\n", 2000 * n, 1 + n % 2);
    let jogs = |count| plot(&(0..count).map(jog).collect::<String>()).len();
    assert!(jogs(600) < 8 * jogs(30), "{} {}", jogs(600), jogs(30));
}

#[test]
fn nothing_at_all_is_a_picture_too() {
    let svg = plot("!end 0");
    assert!(svg.ends_with("</svg>\n") && !svg.contains("NaN") && !svg.contains("inf"));
}
