//! What comes of the ways of a tool in a world.

use std::time::Duration;

use dobot_arm::{Degrees, Joints, Pose, Position, TICK, inverse};
use dobot_controller::{Controller, PowerUp};
use dobot_sim::world::{Actuators, Event, Object, Point, Scene, World, WorldState};
use dobot_sim::{SerialLine, VirtualArm};
use proptest::prelude::*;

/// An arm in a world, placed by the test.
struct WorldTest {
    world: World,
    scene: Scene,
    now: Duration,
    at: [f64; 4],
    actuators: Actuators,
    events: Vec<String>,
}

impl WorldTest {
    /// The tip stands 30 mm above the table at x 200.
    fn new(scene: &str) -> Self {
        let scene = Scene::parse(scene).unwrap();
        let mut lab = Self {
            world: World::new(scene.clone()),
            now: Duration::ZERO,
            at: [200.0, 0.0, 30.0, 0.0],
            actuators: Actuators::default(),
            events: Vec::new(),
            scene,
        };
        lab.update();
        lab
    }

    /// Brings the tip to a place at a height above the table, straight and at a speed in mm/s.
    fn go(mut self, x: f64, y: f64, height: f64, speed: f64) -> Self {
        let (from, to) = (self.at, [x, y, height, self.at[3]]);
        let way: f64 = (0..3)
            .map(|i| (to[i] - from[i]).powi(2))
            .sum::<f64>()
            .sqrt();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "few"
        )]
        let ticks = (way / speed / 0.02).round().max(1.0) as u32;
        for tick in 1..=ticks {
            let share = f64::from(tick) / f64::from(ticks);
            self.at = [0, 1, 2, 3].map(|i| from[i] + (to[i] - from[i]) * share);
            self.now += TICK;
            self.update();
        }
        self
    }

    /// Turns the tool to an angle in the base frame.
    fn turn(mut self, degrees: f64) -> Self {
        let from = self.at[3];
        for tick in 1..=50 {
            self.at[3] = from + (degrees - from) * f64::from(tick) / 50.0;
            self.now += TICK;
            self.update();
        }
        self
    }

    fn wait_ms(mut self, ms: u64) -> Self {
        for _ in 0..ms / 20 {
            self.now += TICK;
            self.update();
        }
        self
    }

    fn pump(mut self, on: bool) -> Self {
        self.actuators.pump = on;
        self.wait_ms(20)
    }

    fn laser(mut self, on: bool) -> Self {
        self.actuators.laser = on;
        self
    }

    fn gripper(mut self, degrees: f64) -> Self {
        self.actuators.gripper_deg = degrees;
        self.wait_ms(20)
    }

    fn update(&mut self) {
        let [x, y, height, turn] = self.at;
        let pose = Pose {
            position: Position::new(x, y, height + self.scene.tool.down_z_mm),
            rotation: Degrees(turn),
        };
        let joints = inverse(&pose, self.scene.tool.tool()).unwrap();
        self.world.handle_arm(self.now, &joints, self.actuators);
        while let Some(happened) = self.world.poll_event() {
            self.events.push(happened.event.to_string());
        }
    }

    fn state(&self) -> WorldState {
        self.world.state()
    }

    fn object(&self, name: &str) -> Object {
        let objects = self.state().objects;
        objects.into_iter().find(|it| it.name == name).unwrap()
    }

    /// All reported events; where an expected text ends in `..`, the rest does not matter.
    #[track_caller]
    fn reports(self, expected: &[&str]) -> Self {
        let same = |(found, expected): (&String, &&str)| match expected.strip_suffix("..") {
            Some(start) => found.starts_with(start),
            None => found == expected,
        };
        let all = self.events.len() == expected.len();
        assert!(
            all && self.events.iter().zip(expected).all(same),
            "found {:?}, expected {expected:?}",
            self.events
        );
        self
    }
}

#[track_caller]
fn near(found: f64, expected: f64, tolerance: f64) {
    assert!(
        (found - expected).abs() <= tolerance,
        "found {found}, expected {expected} within {tolerance}"
    );
}

#[track_caller]
fn at(found: Point, x: f64, y: f64, tolerance: f64) {
    near(found.x, x, tolerance);
    near(found.y, y, tolerance);
}

#[test]
fn a_pen_draws_where_it_is_down_and_only_there() {
    let lab = WorldTest::new("[pen]")
        .go(200.0, 10.0, 0.0, 20.0)
        .go(200.0, 60.0, 0.0, 40.0)
        .go(240.0, 60.0, 0.0, 40.0)
        .go(240.0, 60.0, 10.0, 40.0)
        .go(240.0, -60.0, 10.0, 80.0)
        .go(240.0, -60.0, 0.0, 40.0)
        .go(240.0, -60.0, 10.0, 40.0)
        .reports(&[]);
    let strokes = lab.state().strokes;
    assert_eq!(strokes.len(), 2, "{strokes:?}");
    let corner = &strokes[0].points_mm;
    // The pen comes down on a slope, of which the last 0.1 mm write; then 50 and 40 mm.
    at(corner[0], 200.0, 10.0, 0.05);
    at(*corner.last().unwrap(), 240.0, 60.0, 0.01);
    let length: f64 = corner
        .windows(2)
        .map(|it| (it[1].x - it[0].x).hypot(it[1].y - it[0].y))
        .sum();
    near(length, 90.0, 0.15);
    assert!(corner.len() < 8, "{corner:?}");
    for point in &strokes[1].points_mm {
        at(*point, 240.0, -60.0, 0.01);
    }
}

#[test]
fn a_pen_that_leaves_the_paper_or_is_pressed_down_too_far_is_reported_once() {
    WorldTest::new("[pen]\n[paper]\nx_mm = [150, 250]\ny_mm = [-50, 50]")
        .go(200.0, 0.0, -1.9, 40.0)
        .go(200.0, 80.0, -1.9, 40.0)
        .go(200.0, 0.0, -1.9, 40.0)
        .reports(&["off the paper at x 200.0 y 50.."])
        .go(200.0, 0.0, -3.0, 10.0)
        .go(210.0, 0.0, -3.0, 10.0)
        .reports(&["off the paper at x 200.0 y 50..", "the pen is 2.."]);
}

#[test]
fn a_pressed_pen_is_reported_again_each_time_it_is_twice_as_deep() {
    let lab = WorldTest::new("[pen]").go(200.0, 0.0, -20.0, 10.0);
    assert_eq!(lab.events.len(), 4, "{:?}", lab.events);
}

const CUBES: &str = r#"
[suction-cup]
[[box]]
name = "red"
size_mm = [25, 25, 25]
at_mm = [200, 60]
[[box]]
name = "blue"
size_mm = [30, 30, 40]
at_mm = [240, -60]
"#;

#[test]
fn a_cube_is_picked_up_carried_turned_and_put_on_another_one() {
    let lab = WorldTest::new(CUBES)
        .go(200.0, 60.0, 60.0, 100.0)
        .go(200.0, 60.0, 24.0, 40.0)
        .pump(true)
        .reports(&["picked up red"])
        .go(200.0, 60.0, 100.0, 40.0);
    near(lab.object("red").bottom_mm, 76.0, 0.01);
    assert_eq!(lab.state().held, ["red"]);
    let lab = lab
        .go(240.0, -60.0, 100.0, 100.0)
        .turn(90.0)
        .go(240.0, -60.0, 64.0, 40.0)
        .pump(false)
        .go(240.0, -60.0, 100.0, 40.0)
        .reports(&["picked up red", "put red down on blue"]);
    let red = lab.object("red");
    at(red.at_mm, 240.0, -60.0, 0.01);
    // It stands on the 40 mm of the other: its top is at the sum of the heights.
    near(red.top_mm(), 65.0, 0.01);
    near(red.turn_deg, 90.0, 0.01);
    assert!(lab.state().held.is_empty());
}

#[test]
fn what_stands_on_a_cube_is_lifted_with_it_and_falls_with_it() {
    let stack = format!(
        "{CUBES}[[cylinder]]\nname = \"pin\"\ndiameter_mm = 4\nheight_mm = 10\nat_mm = [209, 51]\non = \"red\"\n[[box]]\nsize_mm = [4, 4, 4]\nat_mm = [210, 69]\non = \"red\""
    );
    let stack = stack.replace("[suction-cup]", "[suction-cup]\ndiameter_mm = 8");
    let lab = WorldTest::new(&stack)
        .go(200.0, 60.0, 60.0, 100.0)
        .go(200.0, 60.0, 25.0, 40.0)
        .pump(true)
        .go(200.0, 60.0, 75.0, 40.0)
        .reports(&["picked up red with 2 on it"]);
    near(lab.object("pin").bottom_mm, 75.0, 0.01);
    let lab = lab.pump(false).reports(&[
        "picked up red with 2 on it",
        "dropped red: it fell 50.0 mm onto the table",
    ]);
    near(lab.object("red").bottom_mm, 0.0, 1e-9);
    near(lab.object("pin").top_mm(), 35.0, 1e-9);
    near(lab.object("box 3").bottom_mm, 25.0, 1e-9);
}

#[test]
fn the_pump_lifts_nothing_where_the_cup_touches_nothing() {
    let lab = WorldTest::new(CUBES)
        .go(200.0, 60.0, 29.0, 40.0)
        .pump(true)
        .go(200.0, 60.0, 60.0, 40.0)
        .go(150.0, 0.0, 25.0, 40.0)
        .reports(&[]);
    near(lab.object("red").bottom_mm, 0.0, 1e-9);
}

#[test]
fn a_pump_that_runs_already_picks_up_what_the_cup_is_lowered_on() {
    WorldTest::new(CUBES)
        .pump(true)
        .go(200.0, 60.0, 60.0, 100.0)
        .go(200.0, 60.0, 25.0, 40.0)
        .reports(&["picked up red"]);
}

#[test]
fn a_cup_over_an_edge_draws_air() {
    // 25 mm wide: 12.5 less the 10 of the cup leave 2.5 on each side.
    WorldTest::new(CUBES)
        .go(205.0, 60.0, 25.0, 100.0)
        .pump(true)
        .go(205.0, 60.0, 60.0, 100.0)
        .reports(&["red is not held: the cup stands 2.5 mm over its edge"]);
    WorldTest::new(CUBES)
        .go(202.4, 60.0, 25.0, 100.0)
        .pump(true)
        .reports(&["picked up red"]);
}

#[test]
fn what_is_too_heavy_stays() {
    let heavy = CUBES.replace("at_mm = [200", "mass_g = 501\nat_mm = [200");
    let lab = WorldTest::new(&heavy)
        .go(200.0, 60.0, 25.0, 100.0)
        .pump(true)
        .wait_ms(200)
        .go(200.0, 60.0, 60.0, 100.0)
        .reports(&["red is too heavy: it weighs 501 g, the tool lifts 500 g"]);
    near(lab.object("red").bottom_mm, 0.0, 1e-9);
}

#[test]
fn a_tool_or_a_load_that_runs_into_something_is_reported() {
    WorldTest::new(CUBES)
        .go(200.0, 60.0, 60.0, 40.0)
        .go(200.0, 60.0, 20.0, 10.0)
        .reports(&["the suction cup is 3.."]);
    WorldTest::new(CUBES)
        .go(200.0, 60.0, 60.0, 40.0)
        .go(200.0, 60.0, 25.0, 40.0)
        .pump(true)
        .go(200.0, 60.0, 45.0, 40.0)
        .go(240.0, -60.0, 45.0, 40.0)
        .reports(&["picked up red", "red is 20.0 mm deep in blue at x .."]);
}

#[test]
fn an_end_of_the_tool_in_the_table_is_reported() {
    WorldTest::new("[suction-cup]")
        .go(200.0, 0.0, -4.0, 10.0)
        .reports(&["the suction cup is 3.."]);
}

/// 20 mm between the fingers at 45 degrees, 4/9 mm less for each degree more.
const GRIPPER: &str = r#"
[gripper]
open_mm = 40
closed_mm = 0
[[box]]
name = "rod"
size_mm = [60, 20, 30]
at_mm = [200, 60]
"#;

#[test]
fn a_gripper_holds_what_is_narrower_than_its_opening_and_drops_it_when_it_opens() {
    let lab = WorldTest::new(GRIPPER)
        .go(200.0, 60.0, 60.0, 100.0)
        .go(200.0, 60.0, 5.0, 40.0)
        .gripper(40.0)
        .reports(&[])
        .gripper(46.0)
        .reports(&["picked up rod"])
        .gripper(80.0)
        .go(200.0, 60.0, 50.0, 40.0);
    near(lab.object("rod").bottom_mm, 45.0, 0.01);
    // The fingers cannot close farther than the rod is wide.
    near(lab.state().arm.unwrap().opening_mm, 20.0, 0.5);
    let lab = lab.gripper(30.0).reports(&[
        "picked up rod",
        "dropped rod: it fell 45.0 mm onto the table",
    ]);
    near(lab.object("rod").bottom_mm, 0.0, 1e-9);
}

#[test]
fn a_gripper_runs_into_what_is_wider_than_its_opening_and_holds_nothing() {
    // Across the fingers the rod is 60 mm long when the tool is turned by 90 degrees.
    let lab = WorldTest::new(GRIPPER)
        .turn(90.0)
        .go(200.0, 60.0, 60.0, 100.0)
        .go(200.0, 60.0, 28.0, 40.0)
        .gripper(90.0);
    assert_eq!(lab.events.len(), 1, "{:?}", lab.events);
    assert!(
        lab.events[0].starts_with("the gripper is"),
        "{:?}",
        lab.events
    );
    assert!(lab.state().held.is_empty());
}

#[test]
fn fingers_that_close_above_or_beside_an_object_hold_nothing() {
    WorldTest::new(GRIPPER)
        .go(200.0, 60.0, 31.0, 100.0)
        .gripper(90.0)
        .reports(&[]);
    WorldTest::new(GRIPPER)
        .go(250.0, 60.0, 60.0, 100.0)
        .go(250.0, 60.0, 10.0, 100.0)
        .gripper(90.0)
        .reports(&[]);
}

/// In focus when the tip is 25 mm above the table.
const LASER: &str = "[laser]\npower_w = 0.5";

#[test]
fn the_dose_of_a_burn_is_power_by_speed() {
    let lab = WorldTest::new(LASER)
        .go(200.0, 0.0, 25.0, 40.0)
        .laser(true)
        .go(200.0, 50.0, 25.0, 10.0)
        .go(200.0, 50.0, 25.0, 10.0)
        .laser(false)
        .go(200.0, 90.0, 25.0, 10.0)
        .laser(true)
        .go(200.0, 90.0, 35.0, 10.0)
        .go(200.0, 20.0, 35.0, 10.0)
        .reports(&[]);
    let burns = lab.state().burns;
    assert_eq!(burns.len(), 1, "{burns:?}");
    near(burns[0].speed_mm_s, 10.0, 0.01);
    near(burns[0].dose_j_mm(), 0.05, 1e-4);
    at(burns[0].points_mm[0], 200.0, 0.0, 0.01);
    at(*burns[0].points_mm.last().unwrap(), 200.0, 50.0, 0.01);
}

#[test]
fn a_standing_laser_burns_a_hole_and_is_reported_as_dangerous() {
    let lab = WorldTest::new(LASER)
        .go(200.0, 0.0, 25.0, 40.0)
        .laser(true)
        .wait_ms(480)
        .reports(&[])
        .wait_ms(10_000)
        .reports(&["danger: the laser burns in place at x 200.0 y 0.0, for 0.5 s"]);
    let holes = lab.state().holes;
    assert_eq!(holes.len(), 1, "{holes:?}");
    near(holes[0].time_s, 10.48, 1e-3);
}

#[test]
fn burns_of_different_speeds_are_kept_apart() {
    let lab = WorldTest::new(LASER)
        .go(200.0, 0.0, 25.0, 40.0)
        .laser(true)
        .go(200.0, 30.0, 25.0, 5.0)
        .go(200.0, 90.0, 25.0, 50.0);
    let speeds: Vec<f64> = lab.state().burns.iter().map(|it| it.speed_mm_s).collect();
    assert_eq!(speeds.len(), 2, "{speeds:?}");
    near(speeds[0], 5.0, 0.05);
    near(speeds[1], 50.0, 0.5);
}

#[test]
fn angles_that_are_no_numbers_are_reported_once_and_leave_the_world_as_it_was() {
    let mut lab = WorldTest::new(CUBES);
    let before = lab.state();
    for ms in 1..4 {
        let joints = Joints::new(f64::NAN, 45.0, 45.0, 0.0);
        lab.world
            .handle_arm(Duration::from_millis(ms), &joints, Actuators::default());
    }
    assert_eq!(lab.world.poll_event().unwrap().event, Event::Lost);
    assert_eq!(lab.world.poll_event(), None);
    assert_eq!(lab.state().arm, before.arm);
}

#[test]
fn a_state_comes_back_from_json_as_it_was_and_makes_the_same_picture() {
    let lab = WorldTest::new(CUBES)
        .go(200.0, 60.0, 25.0, 40.0)
        .pump(true)
        .go(220.0, 0.0, 50.0, 40.0);
    let state = lab.state();
    let json = serde_json::to_string(&state).unwrap();
    let back: WorldState = serde_json::from_str(&json).unwrap();
    assert_eq!(back, state);
    assert_eq!(back.picture(), lab.world.picture());
}

#[test]
fn an_hour_of_writing_is_a_few_points_and_the_same_every_time() {
    let drawn = || {
        let mut lab = WorldTest::new("[pen]").go(200.0, -50.0, 0.0, 40.0);
        for line in 0..40 {
            let x = 200.0 + f64::from(line);
            lab = lab.go(x, 50.0, 0.0, 40.0).go(x + 1.0, -50.0, 0.0, 40.0);
        }
        lab.state()
    };
    let state = drawn();
    let points: usize = state.strokes.iter().map(|it| it.points_mm.len()).sum();
    assert!(points < 200, "{points} points for 80 lines");
    assert_eq!(drawn(), state);
}

#[test]
fn a_world_feels_where_the_arm_is_and_not_where_it_believes_to_be() {
    let power_up = PowerUp::default();
    let askew = ["zero=servo:5".parse().unwrap()];
    let mut arm = VirtualArm::new(Controller::power_up(power_up), SerialLine::STOCK)
        .with_faults(power_up, &askew, 0)
        .with_world(World::new(Scene::parse("[pen]").unwrap()));
    arm.handle_time(Duration::from_millis(200));
    let state = arm.world().unwrap().state().arm.unwrap();
    near(state.rotation_deg, 5.0, 1e-9);
    // At power-up: 135 sin 45 + 160 cos 45 + 55.07, and 135 cos 45 - 160 sin 45.
    near(state.x_mm, 263.667, 1e-3);
    near(state.z_mm, -17.678, 1e-3);
    near(arm.controller().joints_at(arm.now()).servo.0, 0.0, 1e-9);
}

fn moment() -> impl Strategy<Value = (u64, Joints, Actuators)> {
    let angle = || prop_oneof![8 => -180.0..180.0_f64, 1 => any::<f64>()];
    let joints = (angle(), -10.0..90.0_f64, -15.0..100.0_f64, angle());
    (0..100_u64, joints, any::<[bool; 2]>(), -20.0..120.0_f64).prop_map(
        |(ms, (base, rear, fore, servo), [pump, laser], gripper_deg)| {
            let actuators = Actuators {
                pump,
                laser,
                gripper_deg,
            };
            (ms, Joints::new(base, rear, fore, servo), actuators)
        },
    )
}

proptest! {
    #[test]
    fn whatever_an_arm_does_everything_stays_somewhere(
        tool in prop_oneof![Just("[pen]"), Just("[laser]"), Just("[suction-cup]"), Just("[gripper]")],
        moments in proptest::collection::vec(moment(), 1..30),
    ) {
        let mut world = World::new(Scene::parse(&CUBES.replace("[suction-cup]", tool)).unwrap());
        let mut now = Duration::ZERO;
        for (ms, joints, actuators) in moments {
            now += Duration::from_millis(ms);
            world.handle_arm(now, &joints, actuators);
        }
        let state = world.state();
        // NaN is `null` in JSON, which is no number when it is read.
        let json = serde_json::to_string(&state).unwrap();
        prop_assert_eq!(serde_json::from_str::<WorldState>(&json).unwrap(), state.clone());
        let picture = state.picture();
        prop_assert!(!picture.contains("NaN") && !picture.contains("inf"), "{picture}");
        for object in &state.objects {
            prop_assert!(state.held.contains(&object.name) || object.bottom_mm >= 0.0);
        }
    }
}
