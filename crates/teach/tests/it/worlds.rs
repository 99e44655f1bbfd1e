//! The sample programs on both virtual arms: the objects end at the right places.

use std::fs;
use std::path::PathBuf;
use std::time::Duration;

use dobot_api::{Answer, GivenPlace};
use dobot_arm::Calibration;
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
    answered(program, &[])
}

/// The commands of a program with these answers.
fn answered(program: &str, answers: &[Answer]) -> Compiled {
    read(program)
        .compile_answered(&Calibration::NONE, &mut ExampleFiles, answers)
        .unwrap()
}

fn read(program: &str) -> Program {
    let text = fs::read_to_string(example(&format!("programs/{program}"))).unwrap();
    Program::from_toml(&text).unwrap()
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
    ends_with(&compiled(program), scene, expected);
}

/// As [`ends`], for a compiled program.
#[track_caller]
fn ends_with(compiled: &Compiled, scene: &str, expected: &[(&str, [f64; 3])]) {
    for personality in [Personality::Specification, Personality::Firmware11] {
        let (objects, surprises) = carried_out(compiled, scene, personality);
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
fn a_pallet_has_three_cubes_in_each_of_three_layers() {
    let names: Vec<String> = (1..=9).map(|n| format!("cube {n}")).collect();
    let expected = names.iter().enumerate().map(|(n, name)| {
        #[expect(clippy::cast_precision_loss, reason = "nine")]
        let [column, layer] = [n % 3, n / 3].map(|value| value as f64);
        (name.as_str(), [190.0 + 30.0 * column, -90.0, 20.0 * layer])
    });
    let expected: Vec<_> = expected.collect();
    ends("palletizing.toml", "grid.toml", &expected);
}

fn choices(answers: &[&str]) -> Vec<Answer> {
    let choice = |answer: &&str| Answer::Choice((*answer).to_owned());
    answers.iter().map(choice).collect()
}

#[test]
fn each_cube_goes_where_its_colour_belongs() {
    let program = answered("sorting.toml", &choices(&["red", "yellow", "blue"]));
    assert_eq!(program.question, None);
    ends_with(
        &program,
        "pick-and-place.toml",
        &[
            ("red", [208.0, -80.0, 6.0]),
            ("yellow", [235.0, -80.0, 6.0]),
            ("blue", [262.0, -80.0, 6.0]),
        ],
    );
    let program = answered("sorting.toml", &choices(&["none", "blue", "none"]));
    let stays = ("red", [200.0, 80.0, 0.0]);
    let moved = ("yellow", [262.0, -80.0, 6.0]);
    ends_with(&program, "pick-and-place.toml", &[stays, moved]);
}

#[test]
fn a_person_decides_about_every_third_cube() {
    for (answer, third) in [("yes", [250.0, -110.0, 0.0]), ("no", [160.0, -30.0, 0.0])] {
        let program = answered("quality-gate.toml", &choices(&[answer]));
        assert_eq!(program.question, None);
        let [first, second] = [190.0, 220.0].map(|x| [x, -110.0, 0.0]);
        let expected = [("cube 1", first), ("cube 2", second), ("cube 3", third)];
        ends_with(&program, "grid.toml", &expected);
    }
}

#[test]
fn parts_are_picked_up_where_they_are_seen() {
    let seen = [(200.0, 0.0), (240.0, 30.0), (280.0, 0.0)];
    let [red, yellow, blue] = seen.map(|(x_mm, rotation_deg)| {
        Answer::Place(GivenPlace {
            name: Some("part".into()),
            x_mm,
            y_mm: 80.0,
            z_mm: -35.0,
            rotation_deg,
            sense: None,
        })
    });
    let [yes, no] = ["yes", "no"].map(|answer| Answer::Choice(answer.to_owned()));
    let answers = [&blue, &yes, &red, &no, &red, &yes, &yellow, &yes].map(Clone::clone);
    let program = answered("conveyor.toml", &answers);
    assert_eq!(program.question, None);
    ends_with(
        &program,
        "pick-and-place.toml",
        &[
            ("blue", [208.0, -80.0, 6.0]),
            ("red", [235.0, -80.0, 6.0]),
            ("yellow", [262.0, -80.0, 6.0]),
        ],
    );
}

/// The programs whose objects the tests above look for. `drawing.toml` moves none: `every_example_has_the_predicted_duration`
/// of `dobot-cli` plays it.
const WITH_OBJECTS: [&str; 8] = [
    "conveyor.toml",
    "dipping.toml",
    "palletizing.toml",
    "pick-and-place.toml",
    "quality-gate.toml",
    "sort-by-colour.toml",
    "sorting.toml",
    "stack.toml",
];

#[test]
fn no_sample_program_is_left_out() {
    let files = fs::read_dir(example("programs")).unwrap();
    let paths = files.map(|file| file.unwrap().path());
    let programs = paths.filter(|path| path.extension().is_some_and(|kind| kind == "toml"));
    let names = programs.map(|path| path.file_name().unwrap().to_str().unwrap().to_owned());
    let mut names: Vec<_> = names.filter(|name| name != "drawing.toml").collect();
    names.sort();
    assert_eq!(names, WITH_OBJECTS);
}

#[test]
fn the_sample_programs_have_no_problem_on_either_arm() {
    for program in WITH_OBJECTS {
        let paths = read(program).paths(&Calibration::NONE, &mut ExampleFiles);
        for path in paths.unwrap() {
            for dialect in Dialect::ALL {
                let start = Model::new(dialect, &Status::AT_ZERO);
                let report = check(&path, &Policy::default(), start);
                assert!(
                    report.problems.is_empty(),
                    "{program}: {:#?}",
                    report.problems
                );
            }
        }
    }
}
