//! Keys and sticks that are held for longer than the dead-man time.

use std::fs::File;
use std::io::Write;
use std::thread;

use dobot_wire::LinearJogAxis;
use rustix::fs::{CWD, FileType, Mode, mknodat};
use tempfile::TempDir;

use crate::Turn;
use crate::support::keys::Bench;
use crate::support::terminal::Keyboard;

/// A dead-man time of half a second: a busy machine may keep a program waiting for longer than the usual 150 ms.
fn policy(folder: &TempDir) -> String {
    let file = folder.path().join("policy.toml");
    std::fs::write(&file, "[jog]\ndead_man_s = 0.5\n").expect("there is room");
    file.to_str().expect("the path is text").to_owned()
}

/// 640 ms, which is longer than that.
const LONG: usize = 8;

#[test]
fn if_a_terminal_reports_releases_the_arm_moves_until_the_key_is_released() {
    let _turn = Turn::wait();
    let folder = tempfile::tempdir().expect("there is room");
    let mut bench = Bench::new(&["jog", "--policy", &policy(&folder)], Keyboard::Kitty);
    // Slowly: it stays within reach.
    bench.terminal.types("1");
    bench.terminal.shows_one_of(&[" 10 % of the jog speed"]);
    bench.terminal.types("\x1b[1;1:1A");
    bench.gets_jog(LinearJogAxis::XPlus);
    bench.still_jogs_for(LONG);
    bench.terminal.types("\x1b[1;1:3A");
    bench.gets_jog(LinearJogAxis::Released);
    bench.leaves();
}

/// An event of the joystick driver: time, value, kind (2 is an axis), number (1 is up and down).
fn stick(value: i16) -> [u8; 8] {
    let [low, high] = value.to_ne_bytes();
    [0, 0, 0, 0, low, high, 2, 1]
}

#[test]
fn a_gamepad_moves_the_arm_until_its_stick_is_centred_or_it_is_unplugged() {
    let _turn = Turn::wait();
    let folder = tempfile::tempdir().expect("there is room");
    let device = folder.path().join("js0");
    let mode = Mode::RUSR | Mode::WUSR;
    mknodat(CWD, &device, FileType::Fifo, mode, 0).expect("a pipe can be made");
    let name = device.to_str().expect("the path is text").to_owned();
    // Either end waits for the other one.
    let writer = thread::spawn(move || File::options().write(true).open(device));
    let policy = policy(&folder);
    let jog = ["jog", "--gamepad", &name, "--policy", &policy];
    let mut bench = Bench::new(&jog, Keyboard::Plain);
    bench.terminal.types("1");
    bench.terminal.shows_one_of(&[" 10 % of the jog speed"]);
    let mut pad = writer.join().expect("it waits").expect("it is there");
    for end in [Some(stick(0)), None] {
        pad.write_all(&stick(-32767)).expect("it is open");
        bench.gets_jog(LinearJogAxis::XPlus);
        bench.still_jogs_for(LONG);
        match end {
            Some(back) => pad.write_all(&back).expect("it is open"),
            None => break,
        }
        bench.gets_jog(LinearJogAxis::Released);
    }
    drop(pad);
    bench.gets_jog(LinearJogAxis::Released);
    bench.leaves();
}
