//! An arm that is moved with keys, and what it gets.

use dobot_teach::Program;
use dobot_wire::JointJogAxis::SuctionOn;
use dobot_wire::{Command, JointJogAxis, LinearJogAxis, MouseMove};

use crate::support::keys::{Bench, LEFT, UP};
use crate::support::program::{command, dobot};
use crate::support::terminal::{Keyboard, Terminal};

#[test]
fn without_key_releases_the_arm_stops_when_the_key_stops_repeating() {
    let mut bench = Bench::new(&["jog"], Keyboard::Plain);
    bench.jogs_forward();
    bench.gets_jog(LinearJogAxis::Released);
    bench.leaves();
}

#[test]
fn a_stop_by_key_holds_the_arm_until_the_person_lets_it_move_again() {
    let mut bench = Bench::new(&["jog"], Keyboard::Plain);
    bench.terminal.types(" ");
    bench.terminal.shows("STOPPED");
    bench.terminal.shows("at rest)");
    bench.terminal.types("r");
    bench.terminal.shows("clear the stop?");
    bench.terminal.types("y");
    bench.terminal.shows("at rest");
    bench.jogs_forward();
    bench.leaves();
}

#[test]
fn keys_move_the_arm_as_a_mouse_does() {
    let mut bench = Bench::new(&["mouse", "--keys"], Keyboard::Plain);
    bench.terminal.types(UP);
    let first = bench.gets(|it| matches!(it, Command::MouseMove(_)));
    let Command::MouseMove(MouseMove { x, y, z, .. }) = first else {
        panic!("{first:?}");
    };
    assert_eq!([x, y, z], [2.5, 0.0, 0.0]);
    bench.leaves();
}

#[test]
fn a_missing_gamepad_is_reported() {
    let verb = ["jog", "--to", "virtual:", "--gamepad", "/dev/input/js99"];
    let status = Terminal::new(&command(&verb), Keyboard::Plain).ends();
    assert_eq!(status.code(), Some(1));
}

#[test]
fn a_program_is_taught_run_and_saved_with_keys() {
    let folder = tempfile::tempdir().expect("there is room");
    let file = folder.path().join("cubes.toml");
    let name = file.to_str().expect("the path is text");
    let mut bench = Bench::new(&["teach", name], Keyboard::Plain);
    bench.rests();
    bench.terminal.types("\r");
    bench.terminal.shows("▶   1");
    bench.jogs_by(UP, 0, 1.0);
    // The arm is seen at rest here before it is seen so there; Enter teaches a place once.
    bench.presses_until("\r", "▶   2");
    let pump = |it: &Command| matches!(it, Command::JointJog(jog) if jog.axis == SuctionOn);
    bench.presses_until_sent("u", pump);
    let x_mm = |it: &Command| match it {
        Command::MoveTo(it) => Some(it.x_mm),
        _ => None,
    };
    let first = x_mm(&bench.presses_until_sent("g", |it| x_mm(it).is_some()));
    // It stood with both arms at 45 degrees: 135 sin 45 + 160 cos 45 + 55.07.
    assert!(
        (first.expect("a target") - 263.67).abs() < 0.01,
        "{first:?}"
    );
    bench.gets(|it| x_mm(it) > first);
    bench.rests();
    while bench.terminal.shows_one_of(&["saved /", "STOP"]) != 0 {
        bench.terminal.types("w");
        bench.rests();
    }
    bench.leaves();
    let text = std::fs::read_to_string(&file).expect("it was saved");
    let program = Program::from_toml(&text).expect("it is a program");
    assert_eq!(program.points.len(), 2, "{text}");
    assert_eq!(program.steps.0.len(), 3, "{text}");
    assert!(text.contains("suction = true"), "{text}");
}

#[test]
fn a_grid_and_a_repeat_are_taught_with_keys_and_checked() {
    let folder = tempfile::tempdir().expect("there is room");
    let file = folder.path().join("tray.toml");
    let name = file.to_str().expect("the path is text");
    let mut bench = Bench::new(&["teach", name], Keyboard::Plain);
    bench.terminal.types("a");
    bench.terminal.shows_one_of(&["add what?"]);
    bench.terminal.types("r");
    bench.terminal.shows_one_of(&["repeat how often?"]);
    bench.answers("2");
    bench
        .terminal
        .shows_one_of(&["repeat 2 times, from the next step on"]);
    // Enter that is still held after an answer adds no point.
    bench.presses_until("\r", "go = \"p1\"");
    bench.terminal.types("a");
    bench.terminal.shows_one_of(&["add what?"]);
    bench.terminal.types("g");
    bench.terminal.shows_one_of(&["name of the grid"]);
    bench.answers("tray");
    bench.terminal.shows_one_of(&["place 1 of 3"]);
    bench.presses_until("\r", "place 2 of 3");
    bench.jogs_by(UP, 0, 2.0);
    bench.presses_until("\r", "place 3 of 3");
    bench.jogs_by(LEFT, 1, 2.0);
    bench.presses_until("\r", "cells in the first row");
    bench.answers("2x2");
    bench.terminal.shows_one_of(&["go = \"tray\""]);
    bench.terminal.types("e");
    bench.terminal.shows_one_of(&["the each ends here"]);
    bench.terminal.types("e");
    bench.terminal.shows_one_of(&["the repeat ends here"]);
    bench.presses_until("\r", "go = \"p2\"");
    bench.presses_until("w", "saved /");
    bench.leaves();
    let text = std::fs::read_to_string(&file).expect("it was saved");
    let checked = dobot(&["check", name, "--json"]).succeeds().stdout;
    let checked: serde_json::Value = serde_json::from_str(&checked).expect("it is JSON");
    // Twice the point and four cells, then the last point.
    assert_eq!(checked["steps"], 11, "{text}");
    assert_eq!(
        checked["report"]["problems"],
        serde_json::json!([]),
        "{text}"
    );
}

#[test]
fn what_is_no_program_is_not_taught() {
    let folder = tempfile::tempdir().expect("there is room");
    let file = folder.path().join("poem.toml");
    std::fs::write(&file, "roses = \"red\"\n").expect("there is room");
    let name = file.to_str().expect("the path is text");
    let verb = ["teach", name, "--to", "virtual:"];
    let status = Terminal::new(&command(&verb), Keyboard::Plain).ends();
    assert_eq!(status.code(), Some(1));
    dobot(&verb).fails(1, &["needs a terminal", "dobot check"]);
}

#[test]
fn keys_without_a_terminal_are_refused() {
    dobot(&["jog"]).fails(1, &["needs a terminal", "dobot jog x+"]);
    dobot(&["mouse", "--keys"]).fails(1, &["needs a terminal", "dobot mouse X Y Z"]);
}

/// Releases and a laser that is switched off come with the connection.
fn is_end(command: &Command) -> bool {
    match command {
        Command::LinearJog(jog) => jog.axis == LinearJogAxis::Released,
        Command::JointJog(jog) => {
            matches!(jog.axis, JointJogAxis::Released | JointJogAxis::LaserOff)
        }
        _ => false,
    }
}

#[test]
fn pasted_text_moves_nothing() {
    let text = "glue the logo, grab it, hold it, left";
    let without_stops = text.replace([' ', 's'], "");
    for pasted in [format!("\x1b[200~{text}\x1b[201~"), without_stops] {
        let mut bench = Bench::new(&["jog"], Keyboard::Plain);
        bench.terminal.types(&pasted);
        bench.terminal.shows_one_of(&["pasted text was ignored"]);
        // The first command that moves the arm is that of the key.
        bench.terminal.types(UP);
        let first = bench.gets(|it| !is_end(it));
        assert!(
            matches!(first, Command::LinearJog(jog) if jog.axis == LinearJogAxis::XPlus),
            "{first:?}"
        );
        bench.leaves();
    }
}
