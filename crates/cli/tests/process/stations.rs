//! A station, and several programs that share it.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::time::Duration;

use dobot_wire::{Command, Decoder, Dialect, JointJog, JointJogAxis};
use serde_json::{Value, json};

use crate::support::program::{command_at, example, run};
use crate::support::running_process::RunningProcess;
use crate::support::up::Up;

fn near(value: &Value, expected: f64) -> bool {
    value
        .as_f64()
        .is_some_and(|found| (found - expected).abs() < 0.01)
}

#[test]
fn verbs_use_the_running_station_and_others_use_none() {
    let up = Up::new(&[]);
    let moved = up.json(&["move", "220", "-30", "20"]);
    assert!(near(&moved["x_mm"], 220.0), "{moved}");
    // Another process sees the place of the arm; its own arm would be elsewhere.
    let seen = up.json(&["status", "--count", "1"]);
    assert!(near(&seen["y_mm"], -30.0), "{seen}");
    let own = up.json(&["status", "--to", "virtual:"]);
    assert!(near(&own["y_mm"], 0.0), "{own}");
    let named = up.json(&["status", "--count", "1", "--station", &up.page]);
    assert!(near(&named["x_mm"], 220.0), "{named}");
}

#[test]
fn at_a_thousand_times_real_time_no_status_is_lost_and_a_long_drawing_ends_at_once() {
    let up = Up::at_speed("1000", &["--personality", "firmware-1.1"]);
    let drawn = up.dobot(&["draw", &example("harbour.svg")]).succeeds();
    assert!(drawn.stdout.contains("3:"), "minutes: {drawn:?}");
    let state = up.dobot(&["status", "--count", "1", "--json"]).succeeds();
    assert!(state.stdout.contains("x_mm"), "{state:?}");
    let log = up.dobot(&["log", "--json"]).succeeds();
    let file: Value =
        serde_json::from_str(log.stdout.lines().next().expect("a recording")).expect("it is JSON");
    let output = up
        .dobot(&[
            "log",
            file["file"].as_str().expect("a path"),
            "--topic",
            "/station/state",
            "--json",
        ])
        .succeeds();
    let last: Value = serde_json::from_str(output.stdout.lines().rev().nth(1).expect("states"))
        .expect("it is JSON");
    let link = &last["message"]["link"];
    assert_eq!(
        (&link["lost_statuses"], &link["damaged_bytes"]),
        (&0.into(), &0.into()),
        "{last}"
    );
}

#[test]
fn a_jog_through_the_station_moves_and_comes_to_rest() {
    let up = Up::new(&[]);
    let before = up.json(&["status", "--count", "1"]);
    let after = up.json(&["jog", "base+", "--for", "0.5"]);
    let turned = |status: &Value| status["base_deg"].as_f64().expect("a number");
    assert!(turned(&after) > turned(&before) + 0.5, "{after}");
    let later = up.json(&["status", "--count", "1"]);
    assert!(near(&later["base_deg"], turned(&after)), "{after} {later}");
}

#[test]
fn settings_and_switches_pass_through_the_station() {
    // In real time: the next status already shows the effect of a switch.
    let up = Up::at_speed("1", &[]);
    up.dobot(&["set", "moves", "--joint-speed", "100"])
        .succeeds();
    let on = up.json(&["jog", "suction-on"]);
    assert_eq!(on["suction"], true);
    up.dobot(&["jog", "laser-on"])
        .fails(1, &["laser is disarmed"]);
}

#[test]
fn one_client_has_control_and_anyone_may_stop() {
    let up = Up::new(&[]);
    let mut holder = RunningProcess::new(up.command(&["lease", "take"]));
    holder.wait_for_line("you have control");
    assert!(
        up.dobot(&["lease"])
            .succeeds()
            .stdout
            .contains("dobot lease")
    );
    up.dobot(&["move", "220", "0", "20"])
        .fails(1, &["dobot lease", "dobot lease ask"]);
    up.dobot(&["stop", "--reason", "smoke"]).succeeds();
    assert_eq!(holder.interrupt(), Some(0));
    up.dobot(&["move", "220", "0", "20"])
        .fails(1, &["smoke", "dobot stop --reset"]);
    up.dobot(&["stop", "--reset"]).succeeds();
    up.dobot(&["move", "220", "0", "20"]).succeeds();
}

#[test]
fn requested_control_is_granted_when_its_holder_ends() {
    let up = Up::new(&[]);
    let mut holder = RunningProcess::new(up.command(&["lease", "take"]));
    holder.wait_for_line("you have control");
    let mut next = RunningProcess::new(up.command(&["lease", "ask"]));
    next.wait_for_line("asked dobot lease");
    holder.wait_for_line("asks for control");
    drop(holder);
    next.wait_for_line("you have control");
}

#[test]
fn students_get_their_slots_one_after_another_and_all_slots_are_cleared() {
    let up = Up::new(&[]);
    let output = |arguments: &[&str]| up.dobot(arguments).succeeds().stdout;
    let free = "no time slots; the arm is free for everyone\n";
    assert_eq!(output(&["slots"]), free);
    assert_eq!(
        output(&["slots", "--each", "15m", "--group", "red", "Anna", "Ben"]),
        "Anna (red)  now, 15:00 min left\nBen (red)  in 15:00 min, for 15:00 min\n"
    );
    let slots = up.json(&["slots"]);
    assert_eq!(slots[1]["student"], "Ben", "{slots}");
    // What cannot be changes nothing.
    up.dobot(&["slots", "--each", "13h", "Anna", "Ben"])
        .fails(1, &["ends_in_s of Ben is 93600", "86400"]);
    assert!(output(&["slots"]).starts_with("Anna (red)  now"));
    // On this machine everyone is an administrator, in everybody's time.
    up.dobot(&["move", "220", "0", "20"]).succeeds();
    assert_eq!(output(&["slots", "--clear"]), free);
}

#[test]
fn a_person_takes_control_from_a_raw_client_by_a_verb() {
    let up = Up::new(&[]);
    let mut raw = TcpStream::connect(&up.raw).expect("it is served");
    raw.set_read_timeout(Some(Duration::from_secs(60)))
        .expect("it can be set");
    let mut packet = [0; 42];
    raw.read_exact(&mut packet).expect("a status comes");
    let mut decoder = Decoder::statuses(|_| true);
    assert_eq!(decoder.feed(&packet).count(), 1, "{packet:?}");
    // Its first packet takes control.
    let suction: Command = JointJog::new(JointJogAxis::SuctionOn, 0.0).into();
    let suction = suction.emit(&Dialect::SPECIFICATION);
    raw.write_all(&suction.to_bytes())
        .expect("the station reads it");
    raw.read_exact(&mut packet).expect("a status comes");
    // It cannot be asked for it.
    up.dobot(&["move", "220", "0", "20"]).succeeds();
    drop(raw);
}

#[test]
fn a_drawing_becomes_a_job_that_is_followed_to_its_end() {
    let up = Up::new(&[]);
    let report = up.json(&["draw", &example("square.svg"), "--pen-down", "-40"]);
    assert_eq!(report["measured_from"], "the statuses");
    assert!(
        report["deviation_mm"].as_f64().expect("a number") < 0.5,
        "{report}"
    );
    let jobs = up.json(&["jobs"]);
    assert_eq!(jobs[0]["title"], "square.svg");
    assert_eq!(jobs[0]["phase"], "done");
    up.dobot(&["jobs", "start", "99"])
        .fails(1, &["no job 99", "dobot jobs"]);
}

#[test]
fn jobs_are_moved_queued_again_and_deleted_by_verbs() {
    let up = Up::new(&[]);
    let folder = tempfile::tempdir().expect("there is room");
    let file = folder.path().join("job.json");
    let job = r#"{"title": "there", "kind": "program", "commands": [{"type": "move_to", "x_mm": 200, "y_mm": 0, "z_mm": 50,
        "rotation_deg": 0, "suction": false, "mode": "movj", "gripper_deg": 0, "pause_s": 0}]}"#;
    std::fs::write(&file, job).expect("there is room");
    for _ in 0..2 {
        up.dobot(&["jobs", "submit", file.to_str().expect("it is text")])
            .succeeds();
    }
    let listed = || -> Vec<u64> {
        let jobs = up.json(&["jobs"]);
        let jobs = jobs.as_array().expect("a list").iter();
        jobs.map(|job| job["job"].as_u64().expect("a number"))
            .collect()
    };
    up.dobot(&["jobs", "move", "2", "--before", "1"]).succeeds();
    assert_eq!(listed(), [2, 1]);
    up.dobot(&["jobs", "move", "2"]).succeeds();
    assert_eq!(listed(), [1, 2]);
    up.dobot(&["jobs", "again", "1"]).succeeds();
    assert_eq!(listed(), [1, 2, 3]);
    up.dobot(&["jobs", "forget", "2"]).succeeds();
    assert_eq!(listed(), [1, 3]);
    up.dobot(&["jobs", "forget", "2"]).fails(1, &["no job 2"]);
}

#[test]
fn an_unarmed_laser_is_reported_before_anything_is_queued() {
    let up = Up::new(&[]);
    let square = example("square.svg");
    let burn = [
        "draw",
        &square,
        "--laser",
        "plywood-engrave",
        "--pen-down",
        "-40",
    ];
    up.dobot(&burn)
        .fails(1, &["the laser is disarmed", "--arm-laser SECONDS"]);
    assert_eq!(up.json(&["jobs"]), Value::Array(Vec::new()));
    let burned = up.dobot(&[&burn[..], &["--arm-laser", "600"]].concat());
    // No status shows where the laser was on.
    let output = burned.succeeds().stdout;
    assert!(
        output.contains("largest deviation  not measured"),
        "{output}"
    );
}

#[test]
fn a_refused_drawing_leaves_no_job() {
    let up = Up::new(&[]);
    up.dobot(&["stop", "--reason", "smoke"]).succeeds();
    let draw = ["draw", &example("square.svg"), "--pen-down", "-40"];
    up.dobot(&draw).fails(1, &["smoke"]);
    let jobs = up.json(&["jobs"]);
    let jobs = jobs.as_array().expect("a list");
    assert!(jobs.iter().all(|job| job["phase"] == "stopped"), "{jobs:?}");
    up.dobot(&["stop", "--reset"]).succeeds();
    up.dobot(&draw).succeeds();
}

#[test]
fn a_drawing_is_planned_for_the_arm_and_not_for_an_assumed_one_before() {
    let up = Up::new(&[]);
    let square = example("square.svg");
    let draw = ["draw", &square, "--at", "313", "0", "--scale", "0.1"];
    // An arm reaches further at the height of its shoulder, near which the station's arm stands, than at -40 mm.
    up.dobot(&[&draw[..], &["--dry-run"]].concat())
        .fails(1, &["the pen cannot reach", "z -40.0 mm"]);
    up.dobot(&draw).succeeds();
}

#[test]
fn an_interrupted_drawing_is_paused_and_can_be_resumed_or_cancelled() {
    let up = Up::new(&[]);
    // Too many vectors for the arm's queue: a queued vector cannot be paused.
    let draw = ["draw", &example("gear.plt"), "--pen-down", "-40"];
    let drawing = RunningProcess::new(up.command(&draw));
    up.runs_a_job();
    assert_eq!(drawing.interrupt(), Some(1));
    let paused = up.json(&["jobs", "show", "1"]);
    assert_eq!(paused["phase"], "paused", "{paused}");
    up.dobot(&["jobs", "start", "1"]).succeeds();
    assert_eq!(up.json(&["jobs", "show", "1"])["phase"], "done");
    up.dobot(&["jobs", "cancel", "1"]).fails(1, &["job 1 is"]);
}

#[test]
fn an_interrupted_laser_is_off_and_resuming_arms_it_again() {
    let up = Up::new(&[]);
    let burn = [
        "draw",
        &example("gear.plt"),
        "--laser",
        "plywood-engrave",
        "--pen-down",
        "-40",
        "--arm-laser",
        "600",
    ];
    let (drawing, mut errors) = RunningProcess::with_errors(up.command(&burn));
    up.runs_a_job();
    assert_eq!(drawing.interrupt(), Some(1));
    let mut output = String::new();
    errors.read_to_string(&mut output).expect("it is text");
    assert!(
        output.contains("job 1 is paused: interrupted; the laser is off"),
        "{output}"
    );
    assert!(
        output.contains("resume it with `dobot jobs start 1 --arm-laser SECONDS`"),
        "{output}"
    );
    up.dobot(&["jobs", "start", "1", "--arm-laser", "600"])
        .succeeds();
    assert_eq!(up.json(&["jobs", "show", "1"])["phase"], "done");
}

#[test]
fn jobs_are_queued_from_files_and_cancelled() {
    let up = Up::new(&[]);
    let job = up.folder.path().join("job.json");
    let file = job.to_str().expect("the path is text");
    std::fs::write(&job, "{\"title\": \"home\"}").expect("there is room");
    up.dobot(&["jobs", "submit", file])
        .fails(1, &["is not a job", "kind"]);
    std::fs::write(&job, HOME).expect("there is room");
    let queued = up.json(&["jobs", "submit", file]);
    assert_eq!(queued["phase"], "queued", "{queued}");
    up.dobot(&["jobs", "cancel", "1"]).succeeds();
    let shown = up.dobot(&["jobs"]).succeeds().stdout;
    assert!(
        shown.contains("stopped") && shown.contains("home"),
        "{shown}"
    );
}

#[test]
fn a_move_forbidden_by_the_policy_is_refused_with_the_rule_and_nothing_moves() {
    let up = Up::new(&[]);
    up.dobot(&["move", "220", "0", "-90"])
        .fails(1, &["table", "dobot policy"]);
    let seen = up.json(&["status", "--count", "1"]);
    assert!(near(&seen["rear_deg"], 45.0), "{seen}");
    // An arm of one's own keeps to the same rules.
    up.dobot(&["move", "220", "0", "-90", "--to", "virtual:"])
        .fails(1, &["table", "dobot policy"]);
}

#[test]
fn a_dialect_or_policy_other_than_that_of_the_station_is_refused() {
    let up = Up::new(&[]);
    up.dobot(&["status", "--dialect", "firmware-1.1"])
        .fails(1, &["dobot up --dialect"]);
    up.dobot(&["status", "--policy", "my.toml"])
        .fails(1, &["dobot up --policy"]);
    up.dobot(&["status", "--count", "1", "--dialect", "specification"])
        .succeeds();
}

#[test]
fn a_detection_reports_the_dialect_and_its_evidence() {
    let up = Up::new(&["--personality", "firmware-1.1"]);
    let output = up.dobot(&["detect"]).succeeds().stdout;
    assert!(
        output.contains("the dialect of the arm is firmware-1.1"),
        "{output}"
    );
}

#[test]
fn a_second_station_of_the_same_person_is_refused() {
    let up = Up::new(&[]);
    up.dobot(&["up", "--virtual", "--http", "127.0.0.1:0"])
        .fails(1, &["already runs", &up.page, "dobot watch"]);
}

#[test]
fn an_occupied_port_is_reported_with_a_remedy() {
    let up = Up::new(&[]);
    let folder = tempfile::tempdir().expect("there is room");
    let data = folder.path();
    let arguments = ["up", "--virtual", "--http", "127.0.0.1:0", "--raw", &up.raw];
    run(&mut command_at(data, &arguments), b"").fails(1, &["raw port", "--raw off"]);
    let page = up.page.replace("http://", "");
    let arguments = ["up", "--virtual", "--raw", "off", "--http", &page];
    run(&mut command_at(data, &arguments), b"").fails(1, &["--http 127.0.0.1:0"]);
}

#[test]
fn ctrl_c_ends_the_station_and_the_verbs_no_longer_find_it() {
    let up = Up::new(&[]);
    assert!(up.file().exists());
    let file = up.file();
    let Up {
        station, folder, ..
    } = up;
    assert_eq!(station.interrupt(), Some(0));
    assert!(!file.exists());
    run(&mut command_at(folder.path(), &["stop"]), b"").fails(1, &["no station runs"]);
}

#[test]
fn a_killed_station_is_not_waited_for() {
    let mut up = Up::new(&[]);
    up.station.kill();
    assert!(up.file().exists());
    let own = up.json(&["status"]);
    assert!(near(&own["rear_deg"], 45.0), "{own}");
    up.dobot(&["stop"])
        .fails(1, &["there is no station", "dobot up"]);
}

const HOME: &str = r#"{"title": "home", "kind": "program", "commands": [{"type": "move_joints",
    "base_deg": 0, "rear_deg": 30, "fore_deg": 40, "servo_deg": 0, "suction": false,
    "mode": "movj", "gripper_deg": 0, "pause_s": 0}]}"#;

#[test]
fn a_program_is_done_step_by_step_and_then_to_the_end_of_its_cycles() {
    let up = Up::at_speed("20", &[]);
    let target = |x_mm: f64| {
        json!({"type": "move_to", "x_mm": x_mm, "y_mm": 0.0, "z_mm": 20.0, "rotation_deg": 0.0,
            "suction": false, "mode": "jump", "gripper_deg": 0.0, "pause_s": 0.0})
    };
    let job = json!({
        "title": "to and fro", "kind": "program",
        "commands": [target(220.0), target(240.0), target(200.0)],
        "program": {"steps": [0, 1, 2], "repeat": {"from": 1, "times": 3}},
    });
    let file = up.folder.path().join("program.json");
    std::fs::write(&file, job.to_string()).expect("there is room");
    let file = file.to_str().expect("the path is text");
    up.dobot(&["jobs", "submit", file]).succeeds();
    let first = up.dobot(&["jobs", "step", "1"]).succeeds().stdout;
    assert!(
        first.contains("paused") && first.contains("cycle 1 of 3"),
        "{first}"
    );
    assert!(first.contains("step 2 of 3"), "{first}");
    up.dobot(&["jobs", "start", "1"]).succeeds();
    let all = up.json(&["jobs"]);
    assert_eq!(all[0]["phase"], "done");
    assert_eq!(all[0]["program"]["cycles_done"], 3);
}

#[test]
fn a_stop_and_its_reason_hold_at_the_next_start() {
    let mut up = Up::new(&[]);
    up.dobot(&["stop", "--reason", "finger caught"]).succeeds();
    let kept = up.folder.path().join("stop.toml");
    // Another thread saves it, after the packets.
    let is_kept =
        || std::fs::read_to_string(&kept).is_ok_and(|text| text.contains("finger caught"));
    while !is_kept() {
        std::thread::yield_now();
    }
    up.station.kill();
    let again = up.again();
    let stop = again.wait_for_state(|state| state["stop"]["at_rest"] == true);
    assert_eq!(stop["stop"]["reason"], "finger caught", "{stop}");
    let draw = ["draw", &example("square.svg"), "--pen-down", "-40"];
    again.dobot(&draw).fails(1, &["finger caught"]);
    again.dobot(&["stop", "--reset"]).succeeds();
    while is_kept() {
        std::thread::yield_now();
    }
    let mut again = again;
    again.station.kill();
    let last = again.again();
    let state = last.wait_for_state(|state| state["arm"].is_object());
    assert_eq!(state["stop"], Value::Null, "{state}");
}

#[test]
fn if_tokens_are_required_raw_packets_are_served_only_on_request() {
    let folder = tempfile::tempdir().expect("there is room");
    let start = [
        "up",
        "--virtual",
        "--http",
        "127.0.0.1:0",
        "--token-required",
    ];
    run(
        &mut command_at(folder.path(), &["token", "add", "admin", "me"]),
        b"",
    )
    .succeeds();
    let mut station = RunningProcess::new(command_at(folder.path(), &start));
    station.wait_for_line("raw packets are not served");
    drop(station);
    let asked = [&start[..], &["--raw", "127.0.0.1:0"]].concat();
    let mut station = RunningProcess::new(command_at(folder.path(), &asked));
    station.wait_for_line("tcp:127.0.0.1:");
}

#[test]
fn a_change_of_pen_without_a_terminal_is_reported_as_waiting_and_not_as_a_failure() {
    let up = Up::new(&[]);
    let file = up.folder.path().join("pens.svg");
    let lines = r#"<path d="M1 1H5" stroke="red"/><path d="M1 3H5" stroke="blue"/>"#;
    let svg = format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="9mm" height="9mm" viewBox="0 0 9 9">{lines}</svg>"#
    );
    std::fs::write(&file, svg).expect("there is room");
    let file = file.to_str().expect("it is text");
    let draw = ["draw", file, "--layers", "color", "--pen-down", "-40"];
    let what = "put in the pen for blue; that of red is done";
    assert_eq!(
        up.dobot(&draw).waits(),
        format!(
            "job 1 waits: {what}; resume it with `dobot jobs start 1`, or end it with `dobot jobs cancel 1`"
        )
    );
    up.dobot(&["jobs", "cancel", "1"]).succeeds();
    let line = up.dobot(&[&draw[..], &["--json"]].concat()).waits();
    let waiting: Value = serde_json::from_str(&line).expect("it is JSON");
    assert_eq!(waiting["waits_for"], what);
    assert_eq!(waiting["job"], 2);
    assert_eq!(waiting["exit_code"], 3);
    assert!(waiting["hint"].is_string(), "{waiting}");
}
