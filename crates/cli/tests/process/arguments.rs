//! Verbs and their arguments, on a virtual arm in the process.

use serde_json::Value;

use crate::support::program::dobot;
use crate::support::up::Up;

fn json(text: &str) -> Value {
    serde_json::from_str(text).expect("it is one line of JSON")
}

fn near(value: &Value, expected: f64) -> bool {
    value
        .as_f64()
        .is_some_and(|found| (found - expected).abs() < 1e-3)
}

#[test]
fn help_shows_examples_for_every_verb() {
    for verb in [
        "draw",
        "arm",
        "status",
        "move",
        "jog",
        "mouse",
        "say",
        "hand",
        "vector",
        "teach",
        "set",
        "decode",
        "ports",
        "doctor",
        "conformance",
        "simulate",
        "up",
        "stop",
        "watch",
        "jobs",
        "lease",
        "slots",
        "confirm",
        "detect",
        "token",
        "completions",
        "man",
    ] {
        let outcome = dobot(&[verb, "--help"]).succeeds();
        assert!(outcome.stdout.contains(&format!("dobot {verb}")), "{verb}");
        assert!(outcome.stdout.contains("Examples:"), "{verb}");
    }
}

#[test]
fn an_invalid_command_line_exits_with_two() {
    for arguments in [
        &["dance"][..],
        &["move", "1", "2"],
        &["jog", "sideways"],
        &["jog", "x+", "--for", "1000"],
        &["jog", "--for", "1"],
        &["mouse", "1", "2"],
        &["mouse", "1", "2", "3", "--keys"],
        &["vector", "1", "2", "3", "--arm-laser", "60"],
        &["say"],
        &["teach", "a.toml", "--tolerance", "0"],
        &["status", "--to", "nowhere"],
        &["status", "--dialect", "klingon"],
        &["draw"],
        &["draw", "a.svg", "--picture", "a.bmp"],
        &["set"],
        &["up", "--http", "here"],
        &["up", "--raw", "5555"],
        &["up", "--virtual", "--arm", "tcp:localhost:1"],
        &[
            "status",
            "--station",
            "http://localhost",
            "--to",
            "virtual:",
        ],
        &["stop", "--reset", "--reason", "smoke"],
        &["lease", "laser", "--for", "0"],
        &["slots", "Anna"],
        &["slots", "--each", "15m"],
        &["slots", "--each", "2d", "Anna"],
        &["slots", "--clear", "--each", "15m", "Anna"],
        &["token", "add", "king", "me"],
        &["jobs", "start", "first"],
        &["completions", "dos"],
    ] {
        let outcome = dobot(arguments);
        assert_eq!(outcome.code, Some(2), "{outcome:?}");
    }
}

#[test]
fn an_invalid_fault_speed_or_pose_is_reported_with_the_allowed_values() {
    for (arguments, parts) in [
        (
            &["--fault", "dorp=1%"][..],
            &["`dorp`", "drop, flip", "reset"][..],
        ),
        (&["--fault", "drop=200%"], &["`200%`", "up to 100 %"]),
        (&["--fault", "close@12s"], &["close@12s", "@12s..15s"]),
        (&["--time-factor", "0"], &["`0`", "0.1 to 1000", "max"]),
        (&["--pose", "45"], &["two angles", "45,45"]),
        (&["--pose", "45,200"], &["-10 to 95"]),
        (&["--port", "lpt"], &["usb or bluetooth"]),
        (&["--personality", "klingon"], &["firmware-1.1"]),
        (&["--dialect", "firmware-1.1"], &["--dialect"]),
        (&["--count", "0"], &["1 to 10000"]),
        (&["--seed", "many"], &["many"]),
    ] {
        dobot(&[&["arm"], arguments].concat()).fails(2, parts);
    }
}

#[test]
fn more_arms_than_ports_are_refused() {
    dobot(&["arm", "--count", "10", "--tcp", "127.0.0.1:65530"])
        .fails(2, &["10 arms from port 65530", "up to 65526"]);
}

#[test]
fn a_virtual_arm_starts_in_its_power_up_pose() {
    let outcome = dobot(&["status", "--json"]).succeeds();
    assert!(outcome.stderr.contains("a virtual arm in this process"));
    let status = json(&outcome.stdout);
    assert!(near(&status["rear_deg"], 45.0) && near(&status["fore_deg"], 45.0));
    // 135 sin 45 + 160 cos 45 + 55.07
    assert!(near(&status["x_mm"], 263.666_5), "{status}");
}

#[test]
fn a_move_ends_at_its_target() {
    for path in ["jump", "movl", "movj"] {
        let status = json(
            &dobot(&["move", "220", "-40", "-10", "--path", path, "--json"])
                .succeeds()
                .stdout,
        );
        assert!(near(&status["x_mm"], 220.0), "{path}: {status}");
        assert!(near(&status["y_mm"], -40.0), "{path}: {status}");
        assert!(near(&status["z_mm"], -10.0), "{path}: {status}");
        assert!(near(&status["servo_deg"], 0.0), "{path}: {status}");
    }
}

#[test]
fn a_move_to_joint_angles_ends_there_and_sets_the_tool() {
    let arguments = [
        "move",
        "--joints",
        "30",
        "40",
        "35",
        "--servo",
        "-15",
        "--suction",
        "on",
        "--gripper",
        "20",
        "--json",
    ];
    let status = json(&dobot(&arguments).succeeds().stdout);
    for (name, expected) in [
        ("base_deg", 30.0),
        ("rear_deg", 40.0),
        ("fore_deg", 35.0),
        ("servo_deg", -15.0),
        ("rotation_deg", 15.0),
        ("gripper_deg", 20.0),
    ] {
        assert!(near(&status[name], expected), "{name}: {status}");
    }
    assert_eq!(status["suction"], true);
}

#[test]
fn a_target_out_of_reach_is_refused_with_how_far_and_which_limit() {
    dobot(&["move", "400", "0", "30"]).fails(1, &["out of reach", "too far", "nothing was sent"]);
    dobot(&["move", "--joints", "0", "90", "60"])
        .fails(1, &["rear arm angle is 90°", "5° too much"]);
    dobot(&["move", "nan", "0", "30"]).fails(2, &["'nan'", "finite number"]);
}

#[test]
fn targets_that_look_like_metres_or_radians_get_a_warning_with_the_right_numbers() {
    dobot(&["move", "0.22", "0", "0.05"])
        .fails(1, &["looks like metres", "220 0 50", "out of reach"]);
    let output = dobot(&["move", "--joints", "0", "0.7", "0.7", "--path", "movj"]).succeeds();
    assert!(
        output.stderr.contains("look like radians") && output.stderr.contains("0 40.1 40.1"),
        "{}",
        output.stderr
    );
    let output = dobot(&["move", "--joints", "0", "45", "45"]).succeeds();
    assert!(!output.stderr.contains("warning"), "{}", output.stderr);
}

#[test]
fn a_jog_moves_its_axis_and_comes_to_rest() {
    let status = json(
        &dobot(&["jog", "base+", "--for", "1", "--json"])
            .succeeds()
            .stdout,
    );
    let base = status["base_deg"].as_f64().expect("a number");
    // Half of 15 degrees per second for about a second, ramps included.
    assert!((5.0..10.0).contains(&base), "{status}");
}

#[test]
fn a_jog_that_did_not_move_the_arm_is_reported() {
    let up = Up::at_speed("10", &[]);
    let jog = ["jog", "gripper+", "--for", "1", "--percent", "100"];
    let moved = up.dobot(&jog).succeeds();
    assert!(!moved.stderr.contains("did not move"), "{moved:?}");
    // Ten seconds of the arm opened the gripper fully.
    let stayed = up.dobot(&jog).succeeds();
    assert!(stayed.stderr.contains("did not move"), "{stayed:?}");
}

#[test]
fn a_tool_and_angles_can_be_set() {
    let laser = json(&dobot(&["set", "tool", "laser", "--json"]).succeeds().stdout);
    assert!(near(&laser["x_mm"], 263.666_5 - 5.5), "{laser}");
    let angles = json(
        &dobot(&["set", "angles", "-5", "20.5", "--json"])
            .succeeds()
            .stdout,
    );
    assert!(
        near(&angles["rear_deg"], -5.0) && near(&angles["fore_deg"], 20.5),
        "{angles}"
    );
}

#[test]
fn a_setting_that_would_hang_an_arm_is_not_sent() {
    dobot(&["set", "writing", "--acceleration", "0"]).fails(2, &["--acceleration", "above 0"]);
    dobot(&["set", "percent", "--speed-percent", "101"])
        .fails(2, &["--speed-percent", "up to 100 percent"]);
}

#[test]
fn ports_are_listed_as_text_and_as_json() {
    dobot(&["ports"]).succeeds();
    assert!(json(&dobot(&["ports", "--json"]).succeeds().stdout).is_array());
}

#[test]
fn without_a_station_its_verbs_explain_how_to_start_one() {
    for arguments in [&["stop"][..], &["jobs"], &["jobs", "pause"], &["lease"]] {
        dobot(arguments).fails(1, &["no station runs", "dobot up"]);
    }
    dobot(&["stop"]).fails(1, &["switch it off by hand"]);
}

#[test]
fn a_named_station_that_is_missing_is_reported() {
    let listener = std::net::TcpListener::bind("127.0.0.1:0").expect("a port is free");
    let address = listener.local_addr().expect("it has one");
    drop(listener);
    let url = format!("http://{address}");
    dobot(&["status", "--station", &url]).fails(1, &["there is no station", "dobot up"]);
    dobot(&["stop", "--station", "localhost"]).fails(1, &["http://HOST:PORT"]);
    dobot(&[
        "stop",
        "--station",
        "https://localhost",
        "--fingerprint",
        "00",
    ])
    .fails(2, &["64 hex"]);
}

#[test]
fn tokens_are_made_listed_and_removed() {
    let folder = tempfile::tempdir().expect("there is room");
    let data = ["--data", folder.path().to_str().expect("the path is text")];
    let token = |arguments: &[&str]| dobot(&[&["token"], arguments, &data].concat());
    let made = token(&["add", "control", "plotter"]).succeeds().stdout;
    assert!(made.trim().len() >= 32, "{made}");
    let listed = token(&["list"]).succeeds().stdout;
    assert!(listed.contains("control  plotter") && !listed.contains(made.trim()));
    token(&["add", "watch", "plotter"]).fails(1, &["plotter"]);
    token(&["remove", "plotter"]).succeeds();
    token(&["remove", "plotter"]).fails(1, &["plotter"]);
    assert_eq!(token(&["list"]).succeeds().stdout, "");
}

#[test]
fn shells_get_their_completions() {
    for shell in ["bash", "zsh", "fish"] {
        let script = dobot(&["completions", shell]).succeeds().stdout;
        assert!(script.contains("simulate"), "{shell}");
    }
}

#[cfg(feature = "full")]
mod full {
    use crate::support::program::dobot;

    #[test]
    fn readers_get_their_manual() {
        assert!(dobot(&["man"]).succeeds().stdout.contains(".TH dobot 1"));
        let folder = tempfile::tempdir().expect("there is room");
        let pages = folder.path().join("man1");
        dobot(&["man", "--out", pages.to_str().expect("the path is text")]).succeeds();
        assert!(pages.join("dobot.1").exists() && pages.join("dobot-draw.1").exists());
    }

    #[test]
    fn a_picture_of_a_rare_format_is_drawn() {
        let folder = tempfile::tempdir().expect("there is room");
        let picture = super::black_bmp(folder.path());
        dobot(&["draw", &picture, "--dry-run"]).succeeds();
    }
}

/// Writes a BMP file of 8 x 8 black pixels, and returns its path.
fn black_bmp(folder: &std::path::Path) -> String {
    let (header, pixels) = (14 + 40, 3 * 8 * 8);
    // The length of the file and of both headers; width, height, planes and bits of a pixel.
    let numbers: [(usize, u8); 7] = [
        (2, header + pixels),
        (10, header),
        (14, 40),
        (18, 8),
        (22, 8),
        (26, 1),
        (28, 24),
    ];
    let mut file = vec![0; usize::from(header) + usize::from(pixels)];
    file[..2].copy_from_slice(b"BM");
    for (place, number) in numbers {
        file[place] = number;
    }
    let path = folder.join("black.bmp");
    std::fs::write(&path, file).expect("there is room");
    path.to_str().expect("the path is text").to_owned()
}

#[cfg(not(feature = "full"))]
#[test]
fn parts_that_are_not_built_in_say_how_to_get_them() {
    let capture = crate::decoding::sample("ethernet.pcap");
    let folder = tempfile::tempdir().expect("there is room");
    let picture = black_bmp(folder.path());
    for (arguments, part) in [
        (&["man"][..], "manual pages"),
        (&["decode", &capture], "network captures"),
        (&["draw", &picture, "--dry-run"], "BMP pictures"),
    ] {
        dobot(arguments).fails(1, &[part, "--features full"]);
    }
}

#[test]
fn a_dashboard_without_a_terminal_is_refused() {
    dobot(&["watch"]).fails(1, &["needs a terminal", "dobot status --json"]);
}

#[test]
fn errors_are_json_objects_if_json_is_requested() {
    for (arguments, code, error, hint) in [
        (
            &["stop", "--station", "localhost"][..],
            1,
            "localhost",
            "hint",
        ),
        (&["jobs", "--json"], 1, "no station runs", "dobot up"),
        (
            &["jog", "x+", "--for", "-1", "--json"],
            2,
            "0.02 to 60 seconds",
            "--help",
        ),
        (&["set", "tool", "lasre", "--json"], 2, "lasre", "'laser'"),
    ] {
        let outcome = dobot(arguments);
        assert_eq!(outcome.code, Some(code), "{outcome:?}");
        assert_eq!(outcome.stdout, "");
        if !arguments.contains(&"--json") {
            assert!(outcome.stderr.contains("error: "), "{outcome:?}");
            continue;
        }
        let object = json(outcome.stderr.trim());
        assert_eq!(object["exit_code"], code, "{object}");
        let text = |key: &str| object[key].as_str().expect("a text").to_owned();
        assert!(text("error").contains(error), "{object}");
        assert!(text("hint").contains(hint), "{object}");
    }
}

#[test]
fn an_old_option_is_accepted_with_a_hint() {
    let jog = dobot(&["jog", "base+", "--for", "0.1", "--speed", "50"]).succeeds();
    assert!(
        jog.stderr.contains("hint: `--speed` is now `--percent`"),
        "{jog:?}"
    );
    let test = [
        "policy", "test", "200", "0", "0", "--from", "200", "50", "0",
    ];
    let test = dobot(&test).succeeds();
    assert!(test.stderr.contains("`--start-point`"), "{test:?}");
}
