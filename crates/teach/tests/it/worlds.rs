//! The sample programs on both virtual arms: the objects end at the right places.

use std::fs;
use std::path::PathBuf;
use std::time::Duration;

use dobot_controller::{Controller, Personality, PowerUp};
use dobot_motion::Model;
use dobot_safety::Policy;
use dobot_sim::world::{Object, Scene, World};
use dobot_sim::{SerialLine, VirtualArm};
use dobot_teach::{Compiled, Drawing, Files, Program, check};
use dobot_wire::{Command, Dialect, Status};

struct ExampleFiles;

impl Files for ExampleFiles {
    fn program(&mut self, path: &str) -> Result<String, String> {
        fs::read_to_string(example(&format!("programs/{path}"))).map_err(|error| error.to_string())
    }

    fn drawing(&mut self, path: &str, _: &Drawing) -> Result<Vec<Command>, String> {
        Err(format!("{path} is not drawn here"))
    }
}

fn example(path: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("../../examples")
        .join(path)
}

fn compiled(program: &str) -> Compiled {
    let text = fs::read_to_string(example(&format!("programs/{program}"))).unwrap();
    Program::from_toml(&text)
        .unwrap()
        .compile(&mut ExampleFiles)
        .unwrap()
}

/// The objects after a program executed command by command, and the events besides grips.
fn carried_out(
    program: &Compiled,
    scene: &str,
    personality: Personality,
) -> (Vec<Object>, Vec<String>) {
    let dialect = if personality == Personality::Firmware11 {
        Dialect::FIRMWARE_1_1
    } else {
        Dialect::SPECIFICATION
    };
    let scene = fs::read_to_string(example(&format!("scenes/{scene}"))).unwrap();
    let world = World::new(Scene::parse(&scene).unwrap());
    let controller = Controller::power_up(PowerUp::new(personality));
    let mut arm = VirtualArm::new(controller, SerialLine::STOCK).with_world(world);
    let mut model = Model::new(dialect, &Status::AT_ZERO);
    let mut now = Duration::from_secs(1);
    for command in &program.commands {
        let trajectory = model.trajectory(command).unwrap();
        model = model.after(command, &trajectory);
        arm.handle_bytes(now, &command.emit(&dialect).to_bytes());
        // A stock arm is some ticks later; the first move starts elsewhere than in the model.
        now +=
            Duration::from_secs_f64(trajectory.duration_s().unwrap()) + Duration::from_millis(1500);
        arm.handle_time(now);
    }
    assert_eq!(arm.poll_refused(), None, "{personality}");
    let state = arm.world().unwrap().state();
    let expected = ["picked up", "put "];
    let surprises = state.events.iter().map(ToString::to_string);
    let surprises = surprises.filter(|warning| !expected.iter().any(|word| warning.contains(word)));
    (state.objects.clone(), surprises.collect())
}

/// The place of each object: x, y and the height of its underside, within half a millimetre.
#[track_caller]
fn ends(program: &str, scene: &str, expected: &[(&str, [f64; 3])]) {
    let compiled = compiled(program);
    for personality in [Personality::Specification, Personality::Firmware11] {
        let (objects, surprises) = carried_out(&compiled, scene, personality);
        assert!(surprises.is_empty(), "{personality}: {surprises:?}");
        for (name, [x, y, bottom]) in expected {
            let object = objects.iter().find(|object| object.name == *name).unwrap();
            let off = [
                object.at_mm.x - x,
                object.at_mm.y - y,
                object.bottom_mm - bottom,
            ];
            assert!(
                off.iter().all(|distance| distance.abs() < 0.5),
                "{personality}: {object:?}, expected x {x} y {y} bottom {bottom} within 0.5 mm"
            );
        }
    }
}

#[test]
fn nine_cubes_go_from_tray_to_tray() {
    let mut expected = Vec::new();
    let names: Vec<String> = (1..=9).map(|n| format!("cube {n}")).collect();
    for (n, name) in names.iter().enumerate() {
        #[expect(clippy::cast_precision_loss, reason = "nine")]
        let [column, row] = [n % 3, n / 3].map(|value| value as f64);
        expected.push((
            name.as_str(),
            [190.0 + 30.0 * column, -110.0 + 30.0 * row, 0.0],
        ));
    }
    ends("pick-and-place.toml", "grid.toml", &expected);
}

#[test]
fn four_cubes_become_a_tower() {
    let expected = [
        ("cube 1", 0.0),
        ("cube 2", 20.0),
        ("cube 3", 40.0),
        ("cube 4", 60.0),
    ];
    ends(
        "stack.toml",
        "stack.toml",
        &expected.map(|(name, bottom)| (name, [220.0, -70.0, bottom])),
    );
}

#[test]
fn a_dipped_rod_stands_on_the_other_side_and_the_baths_are_not_moved() {
    ends(
        "dipping.toml",
        "baths.toml",
        &[
            ("rod", [220.0, -100.0, 0.0]),
            ("dye", [220.0, 20.0, 0.0]),
            ("water", [220.0, -40.0, 0.0]),
        ],
    );
}

#[test]
fn each_colour_arrives_at_its_place_on_the_tray() {
    ends(
        "sort-by-colour.toml",
        "pick-and-place.toml",
        &[
            ("red", [208.0, -80.0, 6.0]),
            ("yellow", [235.0, -80.0, 6.0]),
            ("blue", [262.0, -80.0, 6.0]),
        ],
    );
}

#[test]
fn the_sample_programs_have_no_problem_on_either_arm() {
    for program in [
        "pick-and-place.toml",
        "stack.toml",
        "dipping.toml",
        "sort-by-colour.toml",
    ] {
        for dialect in Dialect::ALL {
            let report = check(
                &compiled(program),
                &Policy::default(),
                Model::new(dialect, &Status::AT_ZERO),
            );
            assert!(
                report.problems.is_empty(),
                "{program}: {:#?}",
                report.problems
            );
        }
    }
}
