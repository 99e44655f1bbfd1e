//! A person at a terminal who calibrates an arm with the keys alone, and draws with it.

use std::fs;
use std::sync::mpsc::Receiver;
use std::time::Duration;

use dobot_arm::{Calibration, Joints, Tool};
use dobot_calibrate::SHEET_POINTS;
use dobot_geometry::{Point, Stroke, bounds_of_strokes, deviation};
use dobot_wire::Status;
use serde_json::Value;

use crate::going::Going;
use crate::program::{command, dobot, example};
use crate::terminal::{Keyboard, Terminal};
use crate::wire::{Passed, wire};

/// What is wrong with the arm: more than ten millimetres on the paper.
const TRUTH: &str = "[zeros]\nbase = 4.0\nrear = -4.0\nfore = 4.0\n";
const ZEROS: Calibration = Calibration {
    base_deg: 4.0,
    rear_deg: -4.0,
    fore_deg: 4.0,
    ..Calibration::NONE
};
const PAPER_MM: f64 = -40.0;
const SCENE: &str = "[paper]\nx_mm = [130, 300]\ny_mm = [-120, 120]\n[pen]\ndown_z_mm = -40\ngive_mm = 2\nwidth_mm = 0.4\n";

/// The person sees where the tip truly is, and knows no numbers of the arm.
struct Person {
    passed: Receiver<Passed>,
    terminal: Terminal,
    /// How far a press moves the arm: nothing where it moves for as long as a key is held.
    step_mm: Option<f64>,
}

impl Person {
    /// Where the tip comes to rest.
    fn sees(&self) -> [f64; 3] {
        let (mut last, mut same) = (None, 0);
        while same < 5 {
            let place = tip(&self.next());
            same = if last == Some(place) { same + 1 } else { 0 };
            last = Some(place);
        }
        last.expect("it was seen")
    }

    fn next(&self) -> Status {
        loop {
            let next = self.passed.recv_timeout(Duration::from_secs(30));
            if let Passed::FromArm(_, status) = next.expect("the arm tells something") {
                return status;
            }
        }
    }

    /// Presses the point until a press moves the arm by so much.
    fn steps_of(&mut self, step_mm: Option<f64>) {
        const STEPS: [Option<f64>; 3] = [None, Some(1.0), Some(0.1)];
        let index = |it| STEPS.iter().position(|step| *step == it).expect("a step");
        let presses = (index(step_mm) + 3 - index(self.step_mm)) % 3;
        self.terminal.types(&".".repeat(presses));
        self.step_mm = step_mm;
    }

    /// Holds a key until the tip is nearly there along an axis.
    fn holds(&mut self, axis: usize, wanted_mm: f64) {
        self.steps_of(None);
        let far_mm = wanted_mm - self.sees()[axis];
        if far_mm.abs() < 8.0 {
            return;
        }
        let key = KEYS[axis][usize::from(far_mm < 0.0)];
        // Near the limits of the arm it is refused: steps get farther.
        for _ in 0..PATIENCE {
            // Held: it repeats.
            self.terminal.types(key);
            let left_mm = wanted_mm - tip(&self.next())[axis];
            if left_mm.abs() < 8.0 || left_mm.signum() != far_mm.signum() {
                return;
            }
        }
    }

    /// Presses keys until the tip is where it is wanted, to half a step along each axis.
    fn presses(&mut self, wanted: [f64; 3], step_mm: f64) {
        self.steps_of(Some(step_mm));
        for _ in 0..200 {
            let at = self.sees();
            let away = [0, 1, 2].map(|axis| wanted[axis] - at[axis]);
            let farthest = (0..3).max_by(|a, b| away[*a].abs().total_cmp(&away[*b].abs()));
            let axis = farthest.expect("there are axes");
            if away[axis].abs() <= 0.6 * step_mm {
                return;
            }
            self.terminal
                .types(KEYS[axis][usize::from(away[axis] < 0.0)]);
            // The arm moves, unless the key came too early.
            for _ in 0..6 {
                if tip(&self.next()) != at {
                    break;
                }
            }
        }
        panic!("the tip does not come to {wanted:?}: {:?}", self.sees());
    }

    fn touches(&mut self, [x, y]: [f64; 2]) {
        self.presses_up();
        // Not along the limits of the arm.
        for (axis, wanted_mm) in [(0, 215.0), (1, y), (0, x), (2, PAPER_MM + 4.0)] {
            self.holds(axis, wanted_mm);
        }
        self.presses([x, y, PAPER_MM + 1.0], 1.0);
        self.presses([x, y, PAPER_MM], 0.1);
        self.sees();
        self.terminal.types("\r");
    }

    /// The tip leaves the paper before it goes to the next point.
    fn presses_up(&mut self) {
        let [x, y, z] = self.sees();
        if z < PAPER_MM + 3.0 {
            self.presses([x, y, PAPER_MM + 4.0], 1.0);
        }
    }
}

/// Where the tip truly is.
fn tip(status: &Status) -> [f64; 3] {
    let told = Joints::new(
        status.base_deg.into(),
        status.rear_deg.into(),
        status.fore_deg.into(),
        0.0,
    );
    let at = ZEROS.true_place_of(&told, Tool::SuctionCup);
    [at.x.0, at.y.0, at.z.0]
}

#[test]
fn an_arm_that_a_person_calibrated_with_the_keys_draws_the_harbour_where_it_should() {
    let folder = tempfile::tempdir().expect("there is room");
    let in_folder = |name: &str| folder.path().join(name).display().to_string();
    let [truth, scene, found] = ["truth.toml", "scene.toml", "arm.toml"].map(in_folder);
    fs::write(&truth, TRUTH).expect("there is room");
    fs::write(&scene, SCENE).expect("there is room");

    let mut arm = Going::new(command(&[
        "arm",
        "--tcp",
        "127.0.0.1:0",
        "--calibration",
        &truth,
        "--speed",
        "10",
    ]));
    let address = arm.address();
    let address = address.trim_start_matches("tcp:");
    let (wire, passed) = wire(address.parse().expect("an address"));
    let to = format!("tcp:{wire}");
    let calibrate = [
        "calibrate",
        &found,
        "--bar",
        "200",
        "--to",
        &to,
        "--dialect",
        "specification",
        "--pose-confirmed",
    ];
    let mut terminal = Terminal::new(&command(&calibrate), Keyboard::Plain);
    terminal.shows("STOP");
    let mut person = Person {
        passed,
        terminal,
        step_mm: None,
    };
    // Slowly: the time of this arm passes ten times as fast as the person's.
    person.terminal.types("1");
    for point in &SHEET_POINTS[..5] {
        person.touches(*point);
    }
    person.terminal.types("wwq");
    assert!(person.terminal.ends().success());
    let kept = fs::read_to_string(&found).expect("the calibration was kept");
    assert!(kept.contains("points = 5"), "{kept}");

    let after = deviation(&wanted(), &ink(&truth, &scene, &["--calibration", &found])).largest_mm();
    assert!(after < 0.3, "{after} mm after the calibration");
}

/// The harbour where it is to be on the paper: as it is exported, turned into the frame of the arm.
fn wanted() -> Vec<Stroke> {
    let folder = tempfile::tempdir().expect("there is room");
    let export = folder.path().join("plan.json").display().to_string();
    let harbour = example("harbour.svg");
    let plan = [
        "draw",
        &harbour,
        "--to",
        "virtual:",
        "--dry-run",
        "--json",
        "--export",
        &export,
    ];
    let report = json(&dobot(&plan).succeeds().stdout);
    let exported = fs::read_to_string(&export).expect("it was written");
    let strokes = strokes(&json(&exported)["strokes"], "points");
    let page = bounds_of_strokes(&strokes);
    let [far_mm, left_mm] = [2, 3].map(|it| report["ink_mm"][it].as_f64().expect("a number"));
    let placed = |it: &Point| Point::new(far_mm - (it.y - page.y0), left_mm - (it.x - page.x0));
    strokes
        .into_iter()
        .map(|it| Stroke {
            points: it.points.iter().map(placed).collect(),
            ..it
        })
        .collect()
}

/// The harbour as such an arm draws it.
fn ink(truth: &str, scene: &str, draw: &[&str]) -> Vec<Stroke> {
    let arm = [
        "arm",
        "--tcp",
        "127.0.0.1:0",
        "--calibration",
        truth,
        "--speed",
        "50",
    ];
    let world = ["--world", scene, "--world-port", "127.0.0.1:0"];
    let mut arm = Going::new(command(&[&arm[..], &world].concat()));
    let (to, world) = (arm.address(), arm.address());
    let harbour = example("harbour.svg");
    let to = [
        "draw",
        &harbour,
        "--to",
        &to,
        "--dialect",
        "specification",
        "--pose-confirmed",
    ];
    dobot(&[&to, draw].concat()).succeeds();
    let state = dobot(&["world", "--json", "--from", &world])
        .succeeds()
        .stdout;
    strokes(&json(&state)["strokes"], "points_mm")
}

fn json(text: &str) -> Value {
    serde_json::from_str(text).expect("it is JSON")
}

fn strokes(all: &Value, points: &str) -> Vec<Stroke> {
    let number = |it: &Value| it.as_f64().expect("a number");
    let point = |it: &Value| Point::new(number(&it[0]), number(&it[1]));
    let all = all.as_array().expect("strokes").iter();
    all.map(|it| Stroke {
        points: it[points]
            .as_array()
            .expect("points")
            .iter()
            .map(point)
            .collect(),
        ..Stroke::default()
    })
    .collect()
}

/// For so many statuses a key is held.
const PATIENCE: usize = 150;

/// Forward and back, left and right, up and down.
const KEYS: [[&str; 2]; 3] = [
    ["\x1b[A", "\x1b[B"],
    ["\x1b[D", "\x1b[C"],
    ["\x1b[5~", "\x1b[6~"],
];
