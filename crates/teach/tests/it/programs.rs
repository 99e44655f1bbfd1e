//! The meaning of program texts, and the errors of bad ones.

use std::collections::BTreeMap;

use dobot_motion::Model;
use dobot_safety::Policy;
use dobot_teach::{Compiled, Drawing, Files, NoFiles, Program, barrier_reason, check};
use dobot_wire::{Command, Dialect, MoveTo, MovingMode, Status, WriteVector};

/// Files in memory; a drawing is one line of 10 mm.
struct TestFiles(BTreeMap<&'static str, &'static str>);

impl Files for TestFiles {
    fn program(&mut self, path: &str) -> Result<String, String> {
        let text = self.0.get(path).ok_or(format!("there is no {path}"))?;
        Ok((*text).to_owned())
    }

    fn drawing(&mut self, _: &str, drawing: &Drawing) -> Result<Vec<Command>, String> {
        #[expect(clippy::cast_possible_truncation, reason = "a small number")]
        let down = MoveTo::to(200.0, 0.0, drawing.pen_down as f32);
        Ok(vec![
            down.into(),
            WriteVector::by(10.0, 0.0, 0.0, 20.0).into(),
        ])
    }
}

fn compiled(text: &str) -> Compiled {
    Program::from_toml(text)
        .unwrap()
        .compile(&mut NoFiles)
        .unwrap()
}

fn places(compiled: &Compiled) -> Vec<[f32; 3]> {
    let place = |command: &Command| match command {
        Command::MoveTo(command) => Some([command.x_mm, command.y_mm, command.z_mm]),
        _ => None,
    };
    compiled.commands.iter().filter_map(place).collect()
}

/// The error of parsing or compiling.
fn error(text: &str, files: &mut dyn Files) -> String {
    let done = Program::from_toml(text).and_then(|program| program.compile(files));
    done.unwrap_err().to_string()
}

const GO: &str = "[[steps]]\ngo = { x = 200, y = 0, z = 0 }\n";

/// A bad text, the start of its error, and parts of it.
const BAD: &[(&str, &str, &[&str])] = &[
    ("title = ", "line 1: ", &[]),
    (
        "[[step]]",
        "line 1: ",
        &["the key `step` is unknown", "steps"],
    ),
    ("steps = []", "", &["no steps"]),
    (
        "[[steps]]\ngo = 3",
        "line 2: ",
        &["found the number 3", "name of a point"],
    ),
    (
        "[[steps]]\ngo = \"a\"",
        "line 1: ",
        &["no point \"a\"", "[points.a]"],
    ),
    (
        "[points]\nb = {x=1,y=2,z=3}\n[[steps]]\ngo = \"a\"",
        "line 3: ",
        &["there are b"],
    ),
    (
        "[[steps]]\ngo = { x = 1, y = 2 }",
        "line 2: ",
        &["a point has x, y", "x, y and z"],
    ),
    (
        "[[steps]]\ngo = { x = nan, y = 2, z = 1 }",
        "line 2: ",
        &["NaN", "1000000"],
    ),
    (
        "[[steps]]\ngo = { x = 1e9, y = 2, z = 1 }",
        "line 2: ",
        &["1000000000"],
    ),
    (
        "[[steps]]\ngo = { x = 1, y = 2, z = 1 }\npath = \"walk\"",
        "line 3: ",
        &["walk", "jump"],
    ),
    (
        "[[steps]]\nlaser = true\nwait = \"x\"",
        "line 1: ",
        &["laser and wait", "one of"],
    ),
    (
        "[[steps]]\nlaser = true\npause = 1",
        "line 1: ",
        &["pause beside laser", "nothing"],
    ),
    ("[[steps]]", "line 1: ", &["a step is empty"]),
    (
        "[[steps]]\npause = 700",
        "line 1: ",
        &["pause is 700 s", "655"],
    ),
    (
        "[[steps]]\ngripper = 91",
        "line 1: ",
        &["gripper is 91", "-90 to 90"],
    ),
    (
        "[[steps]]\nwait = \"\"",
        "line 1: ",
        &["0 letters", "1 to 200"],
    ),
    (
        "[[steps]]\nrepeat = 0\nsteps = [{pause=1}]",
        "line 2: ",
        &["repeat is 0"],
    ),
    (
        "[[steps]]\nrepeat = \"often\"\nsteps = [{pause=1}]",
        "line 2: ",
        &["often", "forever"],
    ),
    ("[[steps]]\nrepeat = 2", "line 1: ", &["has no steps"]),
    ("[[steps]]\nspeed = {}", "line 1: ", &["speed is empty"]),
    (
        "[[steps]]\nspeed = { percent = 0 }",
        "line 1: ",
        &["percent is 0", "100"],
    ),
    (
        "[[steps]]\ntool = \"cup\"",
        "line 1: ",
        &["no tool \"cup\"", "[tools.cup]"],
    ),
    (
        "[[steps]]\neach = \"tray\"\nsteps = [{go=\"tray\"}]",
        "line 1: ",
        &["no grid \"tray\""],
    ),
    (
        "start_speed_percent = 0\n[[steps]]\npause = 1",
        "line 1: ",
        &["start_speed_percent is 0"],
    ),
    (
        "[[steps]]\npause = 1",
        "line 1: ",
        &["position of the arm is unknown"],
    ),
    (
        "[[steps]]\nlaser = false",
        "line 1: ",
        &["no step moves the arm"],
    ),
    (
        "[[steps]]\nrepeat = \"forever\"\nsteps=[{go={x=200,y=0,z=0}}]\n[[steps]]\npause = 1",
        "line 1: ",
        &["last step"],
    ),
    (
        "[[steps]]\nrepeat = 1000000000\nsteps=[{go={x=200,y=0,z=0}}]\n[[steps]]\npause = 1",
        "line 1: ",
        &["1000000000 steps", "1000000"],
    ),
    (
        "[[steps]]\ngo = {x=200,y=0,z=0}\n[[steps]]\narc = { through = {x=210,y=0,z=0}, to = {x=220,y=0,z=0} }",
        "line 3: ",
        &["on one line"],
    ),
    (
        "[frames.f]\norigin = {x=200,y=0,z=0}\nx = {x=200,y=0,z=0}\ny = {x=200,y=10,z=0}\n[[steps]]\ngo = {x=1,y=1,z=1,frame=\"f\"}",
        "line 5: ",
        &["its second point is its origin"],
    ),
];

#[test]
fn a_bad_program_is_reported_with_its_line_the_found_and_the_allowed_value() {
    for (text, start, parts) in BAD {
        let error = error(text, &mut NoFiles);
        assert!(error.starts_with(start), "{error}\n{text}");
        for part in *parts {
            assert!(error.contains(part), "`{part}` is missing: {error}");
        }
        assert!(!error.contains('\n') && !error.ends_with('.'), "{error}");
    }
}

#[test]
fn all_independent_mistakes_are_reported_at_once() {
    let values = "titel = \"x\"\n[points]\na = { x = 1 }\n[grids.g]\nat = \"a\"\nrows = \"two\"\npitch = {}\n[[steps]]\npause = 700\n[[steps]]\ngo = 3";
    let found = error(values, &mut NoFiles);
    let expected = [
        "line 1: the key `titel` is unknown; did you mean `title`?",
        " | line 3: a point has x; ",
        " | line 6: found the text \"two\"; expected a whole number of 0 or more",
        " | line 8: pause is 700 s; ",
        " | line 11: found the number 3; expected the name of a point",
    ];
    for part in expected {
        assert!(found.contains(part), "`{part}` is missing: {found}");
    }
    let names = "[grids.g]\nat = \"a\"\nrows = 1001\npitch = {}\n[[steps]]\ntool = \"t\"\n[[steps]]\nrepeat = 2\nsteps = [{ go = \"b\" }]";
    let error = Program::from_toml(names).unwrap_err();
    let lines: Vec<_> = error.others.iter().map(|other| other.line).collect();
    assert_eq!(
        (error.line, lines),
        (Some(1), vec![Some(1), Some(5), Some(9)])
    );
    assert!(
        error
            .to_string()
            .contains(" | line 9: there is no point \"b\"")
    );
}

#[test]
fn wrong_types_wrong_names_and_wrong_values_are_reported_together() {
    for (text, expected) in [
        (
            "[points]\na = { x = 200, y = 0, z = \"low\" }\n[[steps]]\ngo = \"a\"\npause = \"long\"\n[[steps]]\ngo = \"b\"\npth = \"movl\"\n[[steps]]\nspeed = 50",
            &[
                "line 2: found the text \"low\"; expected a number",
                "line 5: found the text \"long\"; expected a number",
                "line 6: there is no point \"b\"; there are a",
                "line 8: the key `pth` is unknown; did you mean `path`?",
                "line 10: speed needs a table; write speed = { percent = 50 }",
            ][..],
        ),
        (
            "[grids.tray]\nat = { x = 200, y = 0, z = 0 }\ncolumn = 2\npitch = 30\n[grids.other]\nat = \"corner\"\ncolumns = 3\npitch = {}\n[[steps]]\neach = [\"tray\", \"other\"]\nsteps = [{ go = \"tray\", pause = 700 }, { go = \"tray2\" }]",
            &[
                "line 3: the key `column` is unknown; did you mean `columns`?",
                "line 4: found the number 30; expected a table",
                "line 5: there is no point \"corner\"",
                "line 11: pause is 700 s",
                "line 11: there is no point \"tray2\"",
            ],
        ),
        (
            "[point]\nhome = { x = 200, y = 0, z = 0 }\n[[step]]\ngo = \"home\"\n[[step]]\nchoose = \"Go on?\"\n[[step.when]]\nanswer = \"yes\"\n[[step.when.steps]]\npick = \"home2\"\nsettle = \"long\"\n[[step.when]]\nanswr = \"no\"",
            &[
                "line 1: the key `point` is unknown; did you mean `points`?",
                "line 3: the key `step` is unknown; did you mean `steps`?",
                "line 9: there is no point \"home2\"; did you mean \"home\"?",
                "line 11: found the text \"long\"; expected a number",
                "line 13: the key `answr` is unknown; did you mean `answer`?",
            ],
        ),
        (
            "[[steps]]\ngo = { x = 200,5, y = -0,25, z = 0 }\npause = \"long\"\n[[steps]]\npause = 1,5\nwait = \"a = 3,5\"",
            &[
                "line 2: the number 200,5 has a decimal comma; write 200.5, with a point",
                "line 2: the number -0,25 has a decimal comma; write -0.25, with a point",
                "line 3: found the text \"long\"; expected a number",
                "line 4: a step has pause beside wait",
                "line 5: the number 1,5 has a decimal comma; write 1.5, with a point",
            ],
        ),
        (
            "[grids.tray]\nat = { x = 200, y = 0, z = 0 }\npitch = {}\n[[steps]]\neach = \"trey\"\nsteps = [{ go = \"trey\", pause = \"long\" }]",
            &[
                "line 4: there is no grid \"trey\"; did you mean \"tray\"?",
                "line 6: found the text \"long\"; expected a number",
            ],
        ),
        (
            "[[steps]]\ngo = home\n[[steps]]\nsuction = on\n",
            &[
                "line 1: there is no point \"home\"",
                "line 2: a text must be in quotes; write go = \"home\"",
                "line 4: suction is true or false; write suction = true",
            ],
        ),
        (
            "[points]\nhome = { x = 200, y = 0, z = 50\n\n[[steps]]\nspeed = 50\n[[steps]]\ngo = \"home\npth = \"movl\"\n[[steps]]\ngo = { from = \"cam, timeout = \"5\" }\n[[steps]]\nspeeds = { percent = 50 }\n",
            &[
                "line 2: the table is not closed; write } at its end",
                "line 5: speed needs a table",
                "line 7: the text is not closed; write \" at its end",
                "line 8: the key `pth` is unknown; did you mean `path`?",
                "line 10: ",
                "line 12: the key `speeds` is unknown; did you mean `speed`?",
            ],
        ),
        (
            "[points]\na = { x = 200 y = 0, z = 50 }\n[[steps]]\ngo = \"b\"\npause = \"0.5 s\"\n[[steps]]\nrepeat = 2 3\n[[steps.steps]]\nwait = 5\n[[steps]]\nsuction = \"on\"\n",
            &[
                "line 2: ",
                "line 5: found the text \"0.5 s\"; write pause = 0.5, a number without quotes",
                "line 7: ",
                "line 9: wait shows a message to a person and needs a text; to wait 5 s, write pause = 5",
                "line 11: suction is true or false; write suction = true",
            ],
        ),
        (
            "[steps]\ngo = { x = 200, y = 0, z = 50 }\n",
            &["line 1: found one table; write each step under [[steps]], with two brackets"],
        ),
    ] {
        let error = Program::from_toml(text).unwrap_err();
        let found = error.to_string();
        let found: Vec<&str> = found.split(" | ").collect();
        assert_eq!(found.len(), expected.len(), "{found:#?}");
        for (found, expected) in found.iter().zip(expected) {
            assert!(found.starts_with(expected), "{found} is not: {expected}");
        }
    }
}

#[test]
fn no_error_of_a_program_has_terms_of_the_parser() {
    let jargon = [
        "field", "invalid", "f64", "u32", "struct", "literal", "variant",
    ];
    for text in [
        "[[steps]]\npause = \"long\"",
        "[[steps]]\ngripper = true",
        "[[steps]]\nlaser = 1",
        "[[steps]]\nwait = 3",
        "[[steps]]\npause = [1]",
        "[[steps]]\ngo = { x = \"1\", y = 2, z = 3 }",
        "[[steps]]\narc = { through = \"a\" }",
        "[[steps]]\ndrawing = { file = \"a.svg\" }",
        "[[steps]]\nspeed = { fast = 1 }",
        "[[steps]]\nspeed = 3",
        "[[steps]]\nrepeat = 2.5\nsteps = [{ pause = 1 }]",
        "[tools.a]\nkind = \"hammer\"",
        "[tools.a]\nlength = 3",
        "[frames]\na = 3",
        "[grids.g]\nat = \"a\"\nrows = -1\npitch = {}",
        "points = 3",
        "steps = 3",
        "title = 3",
        "title = x",
        "title = 1.2.3",
        "a b = 3",
        "title = \"a\"\ntitle = \"b\"",
    ] {
        let error = error(text, &mut NoFiles);
        assert!(error.starts_with("line "), "{error}\n{text}");
        for word in jargon {
            assert!(!error.contains(word), "`{word}`: {error}\n{text}");
        }
    }
}

#[test]
fn excessive_nesting_is_refused_quickly() {
    let arrays = format!("steps = {}", "[".repeat(100_000));
    let inline = format!("steps = {}", "[{repeat=2,steps=".repeat(50_000));
    let header = format!("[[{}steps]]\npause = 1", "steps.".repeat(20_000));
    for text in [arrays, inline, header] {
        assert!(!error(&text, &mut NoFiles).is_empty());
    }
    let nested = (0..40).fold("{ pause = 1 }".to_owned(), |inner, _| {
        format!("{{ repeat = 2, steps = [{inner}] }}")
    });
    let error = error(&format!("steps = [{nested}]"), &mut NoFiles);
    assert!(!error.is_empty(), "{error}");
}

#[test]
fn a_target_carries_grip_and_pause_and_unspecified_values_are_kept() {
    let program = compiled(
        "[[steps]]\ngo = { x = 200, y = 10, z = -5, rotation = 15 }\npath = \"movl\"\nsuction = true\ngripper = 45\npause = 0.5\n\
         [[steps]]\ngo = { base = 10, rear = 20, fore = 30 }\n[[steps]]\nsuction = false\npause = 1",
    );
    let Command::MoveTo(first) = program.commands[0] else {
        panic!("{:?}", program.commands)
    };
    assert_eq!(
        [first.x_mm, first.y_mm, first.z_mm, first.rotation_deg],
        [200.0, 10.0, -5.0, 15.0]
    );
    assert_eq!(
        (first.mode, first.suction, first.gripper_deg, first.pause_s),
        (MovingMode::MovL, true, 45.0, 0.5)
    );
    let [Command::MoveJoints(second), Command::MoveJoints(here)] = program.commands[1..] else {
        panic!("{:?}", program.commands)
    };
    assert!(second.suction && second.gripper_deg == 45.0 && second.pause_s == 0.0);
    assert_eq!(
        (here.rear_deg, here.mode, here.suction, here.pause_s),
        (20.0, MovingMode::MovJ, false, 1.0)
    );
    assert_eq!(
        program
            .steps
            .iter()
            .map(|step| step.line)
            .collect::<Vec<_>>(),
        [1, 7, 9]
    );
}

#[test]
fn a_grid_has_its_cells_row_by_row_then_layer_by_layer() {
    let program = compiled(
        "[grids.tray]\nat = { x = 200, y = 0, z = 0 }\ncolumns = 2\nrows = 2\nlayers = 2\npitch = { x = 30, y = 20, z = 10 }\n\
         [[steps]]\neach = \"tray\"\nsteps = [{ go = \"tray\" }]",
    );
    let expected = [
        [200.0, 0.0, 0.0],
        [230.0, 0.0, 0.0],
        [200.0, 20.0, 0.0],
        [230.0, 20.0, 0.0],
        [200.0, 0.0, 10.0],
        [230.0, 0.0, 10.0],
        [200.0, 20.0, 10.0],
        [230.0, 20.0, 10.0],
    ];
    assert_eq!(places(&program), expected);
}

#[test]
fn grids_side_by_side_need_as_many_cells() {
    let text = "[grids.a]\nat = {x=200,y=0,z=0}\ncolumns=3\npitch={x=20}\n[grids.b]\nat={x=200,y=90,z=0}\nrows=2\npitch={y=20}\n[[steps]]\neach=[\"a\",\"b\"]\nsteps=[{go=\"a\"},{go=\"b\"}]";
    assert!(
        error(text, &mut NoFiles).contains("grid \"a\" 3"),
        "{}",
        error(text, &mut NoFiles)
    );
    let program = compiled(&text.replace("rows=2", "rows=3"));
    assert_eq!(
        places(&program)[4..],
        [[240.0, 0.0, 0.0], [200.0, 130.0, 0.0]]
    );
}

#[test]
fn a_frame_turns_and_lifts_its_contents() {
    // Its x axis points left in the base frame, its y axis back.
    let program = compiled(
        "[frames.f]\norigin = {x=200,y=50,z=10}\nx = {x=200,y=80,z=10}\ny = {x=180,y=50,z=10}\n\
         [points]\np = { x = 5, y = 7, z = 2, frame = \"f\" }\n[[steps]]\ngo = \"p\"\noffset = { x = 1, z = 3 }",
    );
    let Command::MoveTo(to) = program.commands[0] else {
        panic!("{:?}", program.commands)
    };
    for (found, expected) in [
        (to.x_mm, 193.0),
        (to.y_mm, 56.0),
        (to.z_mm, 15.0),
        (to.rotation_deg, 90.0),
    ] {
        assert!(
            (found - expected).abs() < 1e-4,
            "found {found}, expected {expected} within 1e-4"
        );
    }
}

#[test]
fn the_length_of_a_tool_is_added_to_points_but_not_to_taught_angles() {
    let program = compiled(
        "[tools.cup]\nkind = \"suction_cup\"\nlength = 60\n[[steps]]\ntool = \"cup\"\n[[steps]]\ngo = {x=200,y=0,z=-100}\n[[steps]]\ngo = {base=0,rear=30,fore=30}",
    );
    assert_eq!(places(&program), [[200.0, 0.0, -40.0]]);
    assert!(matches!(program.commands[2], Command::MoveJoints(joints) if joints.rear_deg == 30.0));
}

#[test]
fn a_repeat_at_the_end_is_stored_once_with_its_count() {
    let body = "[[steps.steps]]\ngo = {x=200,y=0,z=0}\nsuction = true\n[[steps.steps]]\ngo = {x=200,y=50,z=0}\nsuction = false\n";
    let program = compiled(&format!(
        "[[steps]]\ngo={{x=220,y=0,z=40}}\n[[steps]]\nrepeat = 10000000\n{body}"
    ));
    assert_eq!((program.commands.len(), program.first_apart), (3, false));
    assert_eq!(
        program.repeat.map(|repeat| (repeat.from, repeat.times)),
        Some((1, Some(10_000_000)))
    );
    let forever = compiled(&format!("[[steps]]\nrepeat = \"forever\"\n{body}"));
    assert_eq!(
        forever.repeat.map(|repeat| (repeat.from, repeat.times)),
        Some((0, None))
    );
    assert!(forever.job().program.check(forever.commands.len()).is_ok());
}

#[test]
fn a_first_cycle_that_differs_is_placed_before_the_others() {
    // In the first cycle the gripper is at 0 until the second point; in later ones at 30.
    let program = compiled(
        "[[steps]]\nrepeat = 5\n[[steps.steps]]\ngo = {x=200,y=0,z=0}\n[[steps.steps]]\ngo = {x=200,y=50,z=0}\ngripper = 30",
    );
    assert_eq!((program.commands.len(), program.first_apart), (4, true));
    assert_eq!(
        program.repeat.map(|repeat| (repeat.from, repeat.times)),
        Some((2, Some(4)))
    );
}

#[test]
fn only_the_first_motion_starts_softly() {
    let program = compiled(&format!(
        "start_speed_percent = 20\n[[steps]]\nspeed = {{ percent = 80 }}\n{GO}{GO}"
    ));
    let percents: Vec<f32> = program
        .commands
        .iter()
        .filter_map(|command| match command {
            Command::PlaybackAdjustment(command) => Some(command.speed_percent),
            _ => None,
        })
        .collect();
    assert_eq!(percents, [80.0, 16.0, 80.0]);
    assert!(
        matches!(program.commands[2], Command::MoveTo(_))
            && matches!(program.commands[4], Command::MoveTo(_))
    );
}

#[test]
fn a_barrier_waits_as_for_a_person_and_has_its_name() {
    let program = compiled(&format!("{GO}[[steps]]\nbarrier = \"handed over\"\n{GO}"));
    let at = program
        .steps
        .iter()
        .find(|step| step.barrier.is_some())
        .unwrap();
    assert_eq!(at.barrier.as_deref(), Some("handed over"));
    let [pause] = &program.pauses[..] else {
        panic!("{:?}", program.pauses)
    };
    assert_eq!(pause.before, at.first);
    assert_eq!(pause.message, barrier_reason("handed over"));
}

#[test]
fn a_barrier_before_the_first_motion_is_reported_with_a_remedy() {
    let text = format!("[[steps]]\nbarrier = \"ready\"\n{GO}");
    let program = Program::from_toml(&text).unwrap();
    let error = program.compile(&mut NoFiles).unwrap_err().to_string();
    for part in ["line 1", "\"ready\"", "first motion", "step with go"] {
        assert!(error.contains(part), "{part} is missing: {error}");
    }
}

#[test]
fn a_wait_is_placed_before_its_own_command_and_becomes_a_pause_of_the_job() {
    let program = compiled(&format!("{GO}[[steps]]\nwait = \"put a cube here\""));
    assert_eq!(
        program
            .pauses
            .iter()
            .map(|pause| pause.before)
            .collect::<Vec<_>>(),
        [1]
    );
    assert_eq!(program.commands.len(), 2);
    let before = compiled(&format!("[[steps]]\nwait = \"ready?\"\n{GO}"));
    assert_eq!((before.pauses[0].before, before.steps.len()), (0, 1));
}

#[test]
fn a_called_program_has_its_own_names_and_its_own_folder() {
    let mut files = TestFiles(BTreeMap::from([
        (
            "sub/a.toml",
            "[points]\np = {x=210,y=0,z=0}\n[[steps]]\ngo=\"p\"\n[[steps]]\ncall = \"b.toml\"",
        ),
        ("sub/b.toml", "[[steps]]\ngo={x=230,y=0,z=0}"),
    ]));
    let text =
        "[points]\np = {x=200,y=0,z=0}\n[[steps]]\ngo=\"p\"\n[[steps]]\ncall=\"./sub/a.toml\"";
    let program = Program::from_toml(text)
        .unwrap()
        .compile(&mut files)
        .unwrap();
    assert_eq!(
        places(&program),
        [[200.0, 0.0, 0.0], [210.0, 0.0, 0.0], [230.0, 0.0, 0.0]]
    );
    assert_eq!(program.steps[2].file.as_deref(), Some("sub/b.toml"));
}

#[test]
fn calls_that_never_end_are_found() {
    let mut files = TestFiles(BTreeMap::from([
        (
            "a.toml",
            "[[steps]]\ngo={x=200,y=0,z=0}\n[[steps]]\ncall = \"b.toml\"",
        ),
        ("b.toml", "[[steps]]\ncall = \"a.toml\""),
    ]));
    let error = error("[[steps]]\ncall = \"a.toml\"", &mut files);
    assert_eq!(
        error,
        "b.toml: line 1: the calls never end: a.toml calls b.toml calls a.toml again; remove one of the calls"
    );
}

#[test]
fn a_drawing_is_a_step_and_must_be_followed_by_a_target() {
    let drawing = "[[steps]]\ndrawing = { file = \"star.svg\", pen_down = -40 }\n";
    let mut files = TestFiles(BTreeMap::new());
    let program = Program::from_toml(&format!("{drawing}{GO}"))
        .unwrap()
        .compile(&mut files)
        .unwrap();
    assert_eq!((program.commands.len(), program.steps[1].first), (3, 2));
    let error = error(&format!("{drawing}[[steps]]\npause = 1"), &mut files);
    assert!(
        error.starts_with("line 3: ") && error.contains("drawing"),
        "{error}"
    );
}

#[test]
fn all_problems_are_listed_with_step_line_and_remedy() {
    let program = compiled(
        "[[steps]]\ngo = {x=200,y=0,z=0}\n[[steps]]\ngo = {x=500,y=0,z=0}\n[[steps]]\ngo = {x=200,y=0,z=-250}\n[[steps]]\ngo={x=220,y=0,z=0}\n[[steps]]\nspeed = { line = 5000 }",
    );
    let start = Model::new(Dialect::SPECIFICATION, &Status::AT_ZERO);
    let report = check(&program, &Policy::default(), start);
    let found: Vec<(usize, usize)> = report
        .problems
        .iter()
        .map(|problem| (problem.step, problem.line))
        .collect();
    assert_eq!(found, [(2, 3), (3, 5), (5, 9)], "{:#?}", report.problems);
    assert!(
        report
            .problems
            .iter()
            .all(|problem| !problem.remedy.is_empty())
    );
    assert_eq!(report.steps_s.len(), 5);
}

#[test]
fn a_laser_that_is_left_on_is_a_problem() {
    let program = compiled(&format!("{GO}[[steps]]\nlaser = true"));
    let start = Model::new(Dialect::SPECIFICATION, &Status::AT_ZERO);
    let report = check(&program, &Policy::default(), start);
    assert!(
        report
            .problems
            .iter()
            .any(|problem| problem.message.contains("still on")),
        "{report:?}"
    );
}
