//! An arm that is moved with keys, and what it gets.

use std::sync::mpsc::Receiver;
use std::time::Duration;

use dobot_teach::Program;
use dobot_wire::JointJogAxis::SuctionOn;
use dobot_wire::{Command, LinearJogAxis, MouseMove};

use crate::going::Going;
use crate::program::{command, dobot};
use crate::terminal::{Keyboard, Terminal};
use crate::wire::{Passed, wire};

/// An arm, and a person with keys.
struct Bench {
    _arm: Going,
    passed: Receiver<Passed>,
    terminal: Terminal,
}

impl Bench {
    fn new(verb: &[&str], keyboard: Keyboard) -> Self {
        let mut arm = Going::new(command(&["arm", "--tcp", "127.0.0.1:0"]));
        let address = arm.address();
        let address = address.trim_start_matches("tcp:");
        let (wire, passed) = wire(address.parse().expect("an address"));
        let to = format!("tcp:{wire}");
        let to = ["--to", &to, "--dialect", "specification"];
        let arguments = [verb, &to, &["--pose-confirmed"]].concat();
        let mut terminal = Terminal::new(&command(&arguments), keyboard);
        // The first screen is there.
        terminal.shows("STOP");
        Self {
            _arm: arm,
            passed,
            terminal,
        }
    }

    fn next(&self) -> Passed {
        let next = self.passed.recv_timeout(Duration::from_secs(30));
        next.expect("something passes the wire")
    }

    /// Waits for a command to the arm.
    fn gets(&self, mut is_it: impl FnMut(&Command) -> bool) -> Command {
        loop {
            if let Passed::ToArm(_, command) = self.next()
                && is_it(&command)
            {
                return command;
            }
        }
    }

    fn gets_jog(&self, axis: LinearJogAxis) {
        self.gets(|it| is_jog(it, axis));
    }

    /// Presses the arrow until the arm jogs by it: one press is over before an arm that runs down rests.
    fn jogs_forward(&mut self) {
        for _ in 0..50 {
            self.terminal.types(UP);
            let mut statuses = 0;
            while statuses < 4 {
                match self.next() {
                    Passed::FromArm(..) => statuses += 1,
                    Passed::ToArm(_, it) if is_jog(&it, LinearJogAxis::XPlus) => return,
                    Passed::ToArm(..) | Passed::Opened => {}
                }
            }
        }
        panic!("the arm does not jog");
    }

    /// Lets so many statuses pass, within which the arm gets no release.
    fn still_jogs_for(&self, statuses: usize) {
        let mut seen = 0;
        while seen < statuses {
            match self.next() {
                Passed::FromArm(..) => seen += 1,
                Passed::ToArm(_, Command::LinearJog(jog)) => {
                    assert_ne!(jog.axis, LinearJogAxis::Released, "after {seen} statuses");
                }
                Passed::ToArm(..) | Passed::Opened => {}
            }
        }
    }

    /// Waits until the arm tells the same place for half a second.
    fn rests(&self) {
        let (mut last, mut same) = (None, 0);
        while same < 6 {
            if let Passed::FromArm(_, status) = self.next() {
                let place = Some([status.x_mm, status.y_mm, status.z_mm]);
                same = if place == last { same + 1 } else { 0 };
                last = place;
            }
        }
    }

    fn leaves(mut self) {
        self.terminal.types("q");
        assert!(self.terminal.ends().success());
    }
}

#[test]
fn where_a_terminal_tells_presses_alone_the_arm_stops_when_the_key_repeats_no_more() {
    let mut bench = Bench::new(&["jog"], Keyboard::Plain);
    bench.jogs_forward();
    bench.gets_jog(LinearJogAxis::Released);
    bench.leaves();
}

#[test]
fn where_a_terminal_tells_when_a_key_is_let_go_the_arm_moves_until_then() {
    let mut bench = Bench::new(&["jog"], Keyboard::Kitty);
    bench.terminal.types("\x1b[1;1:1A");
    bench.gets_jog(LinearJogAxis::XPlus);
    // 320 ms, which is longer than the dead-man time of 150 ms.
    bench.still_jogs_for(4);
    bench.terminal.types("\x1b[1;1:3A");
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
    bench.terminal.shows("let the arm move again?");
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
fn a_program_is_taught_run_and_saved_with_keys() {
    let folder = tempfile::tempdir().expect("there is room");
    let file = folder.path().join("cubes.toml");
    let name = file.to_str().expect("the path is text");
    let mut bench = Bench::new(&["teach", name], Keyboard::Plain);
    bench.rests();
    bench.terminal.types("\r");
    bench.jogs_forward();
    bench.gets_jog(LinearJogAxis::Released);
    bench.rests();
    bench.terminal.types("\r");
    bench.terminal.types("u");
    let pump = |it: &Command| matches!(it, Command::JointJog(jog) if jog.axis == SuctionOn);
    bench.gets(pump);
    bench.terminal.types("g");
    let x_mm = |it: &Command| match it {
        Command::MoveTo(it) => Some(it.x_mm),
        _ => None,
    };
    let first = x_mm(&bench.gets(|it| x_mm(it).is_some()));
    // It stood with both arms at 45 degrees: 135 sin 45 + 160 cos 45 + 55.07.
    assert!(
        (first.expect("a target") - 263.67).abs() < 0.01,
        "{first:?}"
    );
    bench.gets(|it| x_mm(it) > first);
    bench.rests();
    bench.terminal.types("w");
    bench.leaves();
    let text = std::fs::read_to_string(&file).expect("it was saved");
    let program = Program::from_toml(&text).expect("it is a program");
    assert_eq!(program.points.len(), 2, "{text}");
    assert_eq!(program.steps.0.len(), 3, "{text}");
    assert!(text.contains("suction = true"), "{text}");
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

fn is_jog(command: &Command, axis: LinearJogAxis) -> bool {
    matches!(command, Command::LinearJog(jog) if jog.axis == axis)
}

/// The arrow as most terminals send it.
const UP: &str = "\x1b[A";
