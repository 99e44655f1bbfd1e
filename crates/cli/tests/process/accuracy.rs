//! A person at a terminal who calibrates an arm with the keys alone, and draws with it. The name puts the longest test first.

use std::fs;
use std::path::Path;
use std::time::Duration;

use data_encoding::BASE64;
use dobot_arm::{Calibration, Joints, Position, Tool};
use dobot_calibrate::{SHEET_POINTS, Sheet};
use dobot_geometry::{Point, Stroke, bounds_of_strokes, deviation};
use dobot_wire::{Command, Status};
use serde_json::{Value, json};
use tempfile::TempDir;

use crate::support::api::{Api, read_json};
use crate::support::arm::{WiredArm, fast_arm};
use crate::support::program::{command, dobot, example};
use crate::support::running_process::RunningProcess;
use crate::support::terminal::{Keyboard, Terminal};
use crate::support::up::Up;
use crate::support::wire::Passed;

/// The errors of the arm: more than ten millimetres on the paper.
const TRUTH: &str = "[zeros]\nbase = 4.0\nrear = -4.0\nfore = 4.0\n";
const ZEROS: Calibration = Calibration {
    base_deg: 4.0,
    rear_deg: -4.0,
    fore_deg: 4.0,
    ..Calibration::NONE
};
const PAPER_MM: f64 = -40.0;
/// The spring of the pen gives way by half a millimetre when it draws.
const SCENE: &str = "[paper]\nx_mm = [130, 300]\ny_mm = [-120, 120]\n[pen]\ndown_z_mm = -39.5\ngive_mm = 2\nwidth_mm = 0.4\n";

/// The person sees where the tip truly is, and knows no numbers of the arm.
struct Person {
    arm: WiredArm,
    terminal: Terminal,
}

impl Person {
    /// Where the tip comes to rest.
    fn sees(&self) -> [f64; 3] {
        tip(&self.at_rest())
    }

    fn at_rest(&self) -> Status {
        let (mut last, mut same) = (self.next(), 0);
        while same < AT_REST {
            let next = self.next();
            same = if tip(&next) == tip(&last) {
                same + 1
            } else {
                0
            };
            last = next;
        }
        last
    }

    /// Whether the screen shows the arm at rest: the program of a busy machine reads statuses late.
    fn sees_rest_on_the_screen(&mut self) -> bool {
        let status = self.at_rest();
        let axes = [("x", status.x_mm), ("y", status.y_mm), ("z", status.z_mm)];
        let lines = axes.map(|(axis, mm)| format!("{axis}    {mm:9.3} mm"));
        let shows = |line: &String| self.terminal.screen_shows_within(SCREEN, line);
        lines.iter().all(shows)
    }

    fn next(&self) -> Status {
        loop {
            if let Passed::FromArm(_, status) = self.arm.next() {
                return status;
            }
        }
    }

    /// Presses the point until a press moves the arm by this much.
    fn steps_of(&mut self, step_mm: Option<f64>) {
        const SHOWN: [&str; 3] = ["% of the jog speed", "steps of 1 mm", "steps of 0.1 mm"];
        let wanted = match step_mm {
            None => 0,
            Some(step_mm) => 1 + usize::from(step_mm < 1.0),
        };
        loop {
            let shown = self.terminal.shows_one_of(&SHOWN);
            if shown == wanted {
                return;
            }
            // A key that follows another one too closely is ignored.
            self.sees();
            self.terminal.types(".");
            let mut statuses = 0;
            while self.terminal.shows_one_of(&SHOWN) == shown && statuses < TOO_EARLY {
                self.next();
                statuses += 1;
            }
        }
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
            if left_mm.abs() < RUN_ON_MM || left_mm.signum() != far_mm.signum() {
                return;
            }
        }
    }

    /// Presses keys until the tip is where it is wanted, to half a step along each axis.
    fn presses(&mut self, wanted: [f64; 3], step_mm: f64) {
        self.steps_of(Some(step_mm));
        for _ in 0..PRESSES {
            let at = self.sees();
            let away = [0, 1, 2].map(|axis| wanted[axis] - at[axis]);
            let farthest = (0..3).max_by(|a, b| away[*a].abs().total_cmp(&away[*b].abs()));
            let axis = farthest.expect("there are axes");
            if away[axis].abs() <= 0.6 * step_mm {
                return;
            }
            self.terminal
                .types(KEYS[axis][usize::from(away[axis] < 0.0)]);
            self.sees_motion_from(at);
        }
        panic!("the tip does not come to {wanted:?}: {:?}", self.sees());
    }

    /// Waits until a press moves the tip from where it was, unless the press came too early.
    fn sees_motion_from(&self, place: [f64; 3]) {
        let (mut is_sent, mut statuses) = (false, 0);
        while is_sent || statuses < TOO_EARLY {
            match self.arm.next() {
                Passed::ToArm(_, Command::MoveJoints(_) | Command::MoveTo(_)) => is_sent = true,
                Passed::FromArm(_, status) if is_sent && tip(&status) != place => return,
                Passed::FromArm(..) => statuses += 1,
                _ => {}
            }
        }
    }

    /// Touches a point of the sheet, and looks whether it was recorded where it is: a press that the
    /// program of a busy machine reads late still moves the tip.
    fn touches(&mut self, number: usize, point: [f64; 2]) {
        let recorded = touched(number);
        for _ in 0..TRIES {
            self.goes_to(point);
            if !self.sees_rest_on_the_screen() {
                continue;
            }
            self.terminal.types("\r");
            if self.terminal.shows_one_of(&[&recorded, "not touched"]) == 1 {
                continue;
            }
            let there = [point[0], point[1], PAPER_MM];
            let is_there = |(at, there): (f64, f64)| (at - there).abs() < 0.07;
            if self.sees().into_iter().zip(there).all(is_there) {
                return;
            }
            self.terminal.types("z");
            self.terminal.shows_one_of(&[&touched(number - 1)]);
        }
        panic!("point {number} is not touched: {:?}", self.sees());
    }

    fn goes_to(&mut self, [x, y]: [f64; 2]) {
        self.presses_up();
        // Not along the limits of the arm.
        for (axis, wanted_mm) in [(0, 215.0), (1, y), (0, x), (2, PAPER_MM + 4.0)] {
            self.holds(axis, wanted_mm);
        }
        // From the right and from above, so that the backlash of each joint is on the same side.
        self.presses([x, y - 4.0, PAPER_MM + 4.0], 1.0);
        self.presses([x, y - 1.0, PAPER_MM + 1.0], 1.0);
        self.presses([x, y, PAPER_MM], 0.1);
    }

    /// The tip leaves the paper before it goes to the next point.
    fn presses_up(&mut self) {
        let [x, y, z] = self.sees();
        if z < PAPER_MM + 3.0 {
            self.presses([x, y, PAPER_MM + 4.0], 1.0);
        }
    }
}

/// More than any way across the sheet takes in steps of a millimetre, on a machine so busy that every other press comes too early.
const PRESSES: u32 = 2000;

/// More than a busy machine needs.
const TRIES: u32 = 20;
/// The screen shows within this time what a status says.
const SCREEN: Duration = Duration::from_secs(10);
/// The tip is at rest if it stays for this many statuses.
const AT_REST: u32 = 3;
/// A press came too early if it sends the arm nothing within this many statuses.
const TOO_EARLY: u32 = 50;

/// What the terminal shows of this many points.
fn touched(number: usize) -> String {
    let s = if number == 1 { "" } else { "s" };
    format!("{number} point{s} touched")
}

/// Where the tip truly is.
fn tip(status: &Status) -> [f64; 3] {
    let reported = Joints::new(
        status.base_deg.into(),
        status.rear_deg.into(),
        status.fore_deg.into(),
        0.0,
    );
    let at = ZEROS.true_place_of(&reported, Tool::SuctionCup);
    [at.x.0, at.y.0, at.z.0]
}

#[test]
fn an_arm_calibrated_by_a_person_with_the_keys_draws_the_bracket_at_its_place() {
    let folder = tempfile::tempdir().expect("there is room");
    let in_folder = |name: &str| folder.path().join(name).display().to_string();
    let [truth, found] = ["truth.toml", "arm.toml"].map(in_folder);
    fs::write(&truth, TRUTH).expect("there is room");

    let arm = ["--tcp", "127.0.0.1:0", "--calibration", &truth];
    let arm = WiredArm::new(fast_arm(&arm));
    let sheet = Sheet::chosen_by(17);
    let bar = format!("{}:{}", sheet.number(), sheet.bar_mm());
    let calibrate = ["calibrate", &found, "--bar", &bar, "--to", &arm.address];
    let calibrate = [
        &calibrate[..],
        &["--dialect", "specification", "--pose-confirmed"],
    ]
    .concat();
    let mut terminal = Terminal::new(&command(&calibrate), Keyboard::Plain);
    terminal.shows("STOP");
    let mut person = Person { arm, terminal };
    // Slowly: the time of this arm passes faster as the person's.
    person.terminal.types("1");
    for (number, point) in (1..).zip(&SHEET_POINTS[..5]) {
        person.touches(number, *point);
    }
    person.terminal.types("w");
    person.terminal.shows_one_of(&["press w again"]);
    person.terminal.types("w");
    person.terminal.shows_one_of(&["saved in"]);
    assert!(person.terminal.types_until_the_end("q").success());
    let kept = fs::read_to_string(&found).expect("the calibration was kept");
    assert!(kept.contains("points = 5"), "{kept}");
    // It is called as its file.
    let stem = Path::new(&found).file_stem().expect("it is a file");
    let name = stem.to_string_lossy();
    assert!(kept.contains(&format!("name = \"{name}\"")), "{kept}");

    let arm = DrawingArm::new();
    let bracket = example("bracket.dxf");
    let draw = [
        "draw",
        &bracket,
        "--to",
        &arm.address,
        "--dialect",
        "specification",
    ];
    dobot(&[&draw[..], &["--pose-confirmed", "--calibration", &found]].concat()).succeeds();
    let after = deviation(&wanted(), &arm.ink());
    assert!(after.largest_mm() < 0.3, "after the calibration: {after:?}");
}

#[test]
fn an_arm_calibrated_by_the_api_alone_draws_the_bracket_at_its_place() {
    let arm = DrawingArm::new();
    let at = ["--arm", arm.address.as_str(), "--dialect", "specification"];
    let up = Up::with_arm(&at, &[]);
    let api = Api::with_control(&up.page);
    api.asks("POST", "pose/confirm", &json!({}));
    let touches = SHEET_POINTS.map(|[x, y]| {
        let there = Position::new(x, y, PAPER_MM);
        let on = ZEROS.raw_joints(there, Tool::SuctionCup).expect("it reaches the sheet");
        let above = [on.base.0 - 3.0, on.rear.0 - 1.0, on.fore.0 - 1.0];
        for [base, rear, fore] in [above, [on.base.0, on.rear.0, on.fore.0]] {
            let command = json!({
                "type": "move_joints", "base_deg": base, "rear_deg": rear, "fore_deg": fore, "servo_deg": 0.0,
                "suction": false, "gripper_deg": 0.0, "mode": "movj", "pause_s": 0.0,
            });
            api.asks("POST", "commands", &json!({"command": command, "wait": true}));
        }
        let arm = &api.asks("GET", "state", &Value::Null)["arm"];
        json!({"place_mm": [x, y], "raw_deg": [arm["base_deg"], arm["rear_deg"], arm["fore_deg"]]})
    });
    let sheet = Sheet::chosen_by(17);
    let touches = json!({"touches": touches, "sheet": sheet.number(), "bar_mm": sheet.bar_mm()});
    let fit = api.asks("POST", "calibration/fit", &touches);
    assert_eq!(fit["trust"], "good", "{fit}");
    api.asks(
        "PUT",
        "calibration",
        &json!({"calibration": fit["calibration"]}),
    );

    // The pen left marks where it touched.
    let marks = arm.ink().len();
    let file = fs::read(example("bracket.dxf")).expect("it is there");
    let options = json!({"tool": {}, "place": {}, "way": {}, "what": {}});
    let drawing = json!({"name": "bracket.dxf", "file": BASE64.encode(&file), "options": options});
    // Planning may take longer than control lasts that is not used.
    api.asks("DELETE", "lease", &Value::Null);
    let api = Api::new(&up.page);
    let drawing = api.asks("POST", "drawings", &drawing)["drawing"].to_string();
    while api.asks("GET", &format!("drawings/{drawing}"), &Value::Null)["phase"] != "planned" {}
    let api = Api::with_control(&up.page);
    let job = api.asks(
        "POST",
        &format!("drawings/{drawing}/jobs"),
        &json!({"part": "whole"}),
    );
    let job = job["job"]["job"].to_string();
    api.asks("POST", &format!("jobs/{job}/start"), &json!({}));
    // A state from before the start does not include the job.
    let jobs = || api.asks("GET", "jobs", &Value::Null);
    api.wait_for_state(|state| {
        state["job"]["phase"] != "running" && jobs()[0]["phase"] != "running"
    });
    let jobs = jobs();
    assert_eq!(jobs[0]["phase"], "done", "{jobs}");
    let after = deviation(&wanted(), &arm.ink()[marks..]);
    assert!(after.largest_mm() < 0.3, "{after:?} after {fit}");
}

/// The bracket where it is to be on the paper: as it is exported, turned into the frame of the arm.
fn wanted() -> Vec<Stroke> {
    let folder = tempfile::tempdir().expect("there is room");
    let export = folder.path().join("plan.json").display().to_string();
    let bracket = example("bracket.dxf");
    let plan = [
        "draw",
        &bracket,
        "--to",
        "virtual:",
        "--dry-run",
        "--json",
        "--export",
        &export,
    ];
    let report = read_json(&dobot(&plan).succeeds().stdout);
    let exported = fs::read_to_string(&export).expect("it was written");
    let strokes = strokes(&read_json(&exported)["strokes"], "points");
    let page = bounds_of_strokes(&strokes);
    let [far_mm, left_mm] = [2, 3].map(|side| report["ink_mm"][side].as_f64().expect("a number"));
    let placed =
        |point: &Point| Point::new(far_mm - (point.y - page.y0), left_mm - (point.x - page.x0));
    strokes
        .into_iter()
        .map(|stroke| Stroke {
            points: stroke.points.iter().map(placed).collect(),
            ..stroke
        })
        .collect()
}

/// An arm with wrong zeros and a pen, on paper.
struct DrawingArm {
    _served: RunningProcess,
    _folder: TempDir,
    address: String,
    world: String,
}

impl DrawingArm {
    fn new() -> Self {
        let folder = tempfile::tempdir().expect("there is room");
        let in_folder = |name: &str| folder.path().join(name).display().to_string();
        let [truth, scene] = ["truth.toml", "scene.toml"].map(in_folder);
        fs::write(&truth, TRUTH).expect("there is room");
        fs::write(&scene, SCENE).expect("there is room");
        let arm = ["--tcp", "127.0.0.1:0", "--calibration", &truth];
        let world = ["--world", &scene, "--world-port", "127.0.0.1:0"];
        let mut served = fast_arm(&[&arm[..], &world].concat());
        let (address, world) = (served.address(), served.address());
        Self {
            _served: served,
            _folder: folder,
            address,
            world,
        }
    }

    /// Its drawn ink.
    fn ink(&self) -> Vec<Stroke> {
        let state = dobot(&["world", "--json", "--address", &self.world]).succeeds();
        strokes(&read_json(&state.stdout)["strokes"], "points_mm")
    }
}

fn strokes(all: &Value, points: &str) -> Vec<Stroke> {
    let number = |value: &Value| value.as_f64().expect("a number");
    let point = |pair: &Value| Point::new(number(&pair[0]), number(&pair[1]));
    let all = all.as_array().expect("strokes").iter();
    all.map(|stroke| Stroke {
        points: stroke[points]
            .as_array()
            .expect("points")
            .iter()
            .map(point)
            .collect(),
        ..Stroke::default()
    })
    .collect()
}

/// The tip moves on by about this much after the last repeat of a key.
const RUN_ON_MM: f64 = 14.0;
/// A key is held for this many statuses: enough to cross the sheet.
const PATIENCE: usize = 400;

/// Forward and back, left and right, up and down.
const KEYS: [[&str; 2]; 3] = [
    ["\x1b[A", "\x1b[B"],
    ["\x1b[D", "\x1b[C"],
    ["\x1b[5~", "\x1b[6~"],
];
