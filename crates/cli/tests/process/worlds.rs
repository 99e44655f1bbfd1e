//! An arm in a world, and its reports.

use std::io::BufReader;
use std::net::TcpListener;
use std::process::ChildStderr;
use std::thread;

use crate::support::arm::FAST;
use crate::support::program::{command, dobot};
use crate::support::running_process::{RunningProcess, line_with};

/// `dobot arm --world` as a separate process; it ends with the test.
struct Inhabited {
    _served: RunningProcess,
    errors: BufReader<ChildStderr>,
    /// The addresses of the arm and of its world.
    arm: String,
    world: String,
}

impl Inhabited {
    fn new(scene: &str) -> Self {
        let ports = ["--tcp", "127.0.0.1:0", "--world-port", "127.0.0.1:0"];
        let arm = ["arm", "--time-factor", FAST, "--world", scene];
        let (mut served, errors) =
            RunningProcess::with_errors(command(&[&arm[..], &ports].concat()));
        let (arm, world) = (served.address(), served.address());
        Self {
            _served: served,
            errors,
            arm,
            world,
        }
    }

    fn run(&self, arguments: &[&str]) {
        let to = [
            "--to",
            &self.arm,
            "--dialect",
            "specification",
            "--pose-confirmed",
        ];
        dobot(&[arguments, &to[..]].concat()).succeeds();
    }

    fn state(&self) -> serde_json::Value {
        let outcome = dobot(&["world", "--json", "--address", &self.world]).succeeds();
        serde_json::from_str(&outcome.stdout).expect("it is JSON")
    }

    /// Waits for its first report.
    fn wait_for(&mut self, part: &str) {
        line_with(part, &mut self.errors);
    }
}

fn scene(name: &str) -> String {
    format!(
        "{}/../../examples/scenes/{name}.toml",
        env!("CARGO_MANIFEST_DIR")
    )
}

#[test]
fn a_drawing_over_tcp_is_ink_in_the_world_and_in_its_picture() {
    let arm = Inhabited::new(&scene("desk"));
    let square = crate::support::program::example("square.svg");
    arm.run(&["draw", &square, "--pen-down", "-40"]);
    let state = arm.state();
    let strokes = state["strokes"].as_array().expect("there are some");
    assert_eq!(strokes.len(), 1, "{state}");
    let folder = tempfile::tempdir().expect("there is room");
    let picture = folder.path().join("world.svg");
    let picture = picture.to_str().expect("the path is text");
    let outcome = dobot(&["world", "--picture", picture, "--address", &arm.world]).succeeds();
    assert!(
        outcome.stdout.contains("strokes            1"),
        "{outcome:?}"
    );
    let svg = std::fs::read_to_string(picture).expect("it was written");
    let [x, y] = [0, 1].map(|i| strokes[0]["points_mm"][0][i].as_f64().expect("a number"));
    // Above is X, left is Y.
    let mut begins = svg.split('M').filter_map(|path| {
        let (x, rest) = path.split_once(' ')?;
        let (y, _) = rest.split_once('L')?;
        Some([x.parse::<f64>().ok()?, y.parse::<f64>().ok()?])
    });
    assert!(
        begins.any(|point| (point[0] + y).abs() < 0.01 && (point[1] + x).abs() < 0.01),
        "no ink from x {x} y {y}"
    );
}

#[test]
fn a_cube_is_picked_up_and_placed_on_a_tray_with_the_verbs_of_the_program() {
    let mut arm = Inhabited::new(&scene("pick-and-place"));
    let go = |x: &str, y: &str, z: &str, pump: &str| {
        arm.run(&["move", x, y, z, "--path", "movj", "--suction", pump]);
    };
    go("200", "80", "-35", "on");
    go("200", "80", "0", "on");
    go("235", "-80", "0", "on");
    go("235", "-80", "-29", "off");
    arm.wait_for("picked up red");
    arm.wait_for("put red down on tray");
    let state = arm.state();
    let red = &state["objects"][0];
    assert_eq!(red["name"], "red");
    for (found, expected) in [
        (&red["at_mm"][0], 235.0),
        (&red["at_mm"][1], -80.0),
        (&red["bottom_mm"], 6.0),
    ] {
        let found = found.as_f64().expect("a number");
        assert!(
            (found - expected).abs() < 0.1,
            "found {found}, expected {expected}"
        );
    }
}

#[test]
fn a_bad_scene_is_reported_with_file_and_line() {
    let folder = tempfile::tempdir().expect("there is room");
    let file = folder.path().join("bad.toml");
    std::fs::write(
        &file,
        "[pen]\n\n[[box]]\nsize_mm = [1, 2, -3]\nat_mm = [200, 0]\n",
    )
    .expect("there is room");
    let file = file.to_str().expect("the path is text");
    dobot(&["arm", "--tcp", "127.0.0.1:0", "--world", file]).fails(
        1,
        &["bad.toml: line 4: size_mm of `box 1` is -3; from 0.5 to 500 is allowed"],
    );
    dobot(&["arm", "--world", "no-such.toml"]).fails(1, &["no-such.toml", "examples/scenes"]);
    dobot(&["arm", "--world-port", "127.0.0.1:0"]).fails(2, &["--world"]);
}

#[test]
fn an_occupied_world_port_and_one_without_a_world_are_reported() {
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port is free");
    let taken = listener.local_addr().expect("it is bound").to_string();
    let desk = scene("desk");
    dobot(&[
        "arm",
        "--tcp",
        "127.0.0.1:0",
        "--world",
        &desk,
        "--world-port",
        &taken,
    ])
    .fails(1, &["cannot serve on", &taken, "--world-port 127.0.0.1:0"]);
    thread::spawn(move || drop(listener.accept()));
    dobot(&["world", "--address", &taken]).fails(1, &["is not the state of a world"]);
    dobot(&["world", "--picture", "world.jpg"]).fails(2, &["ends in .svg"]);
}
