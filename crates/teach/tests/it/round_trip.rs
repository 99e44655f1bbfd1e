//! Any written program reads back equal; any read program compiles or is refused.

use std::collections::BTreeMap;

use dobot_arm::Tool;
use dobot_teach::{
    Action, Arc, Frame, Go, Grid, Here, MountedTool, NoFiles, Offset, Place, Point, Program, Speed,
    Steps, Times,
};
use dobot_wire::MovingMode;
use proptest::prelude::*;

fn offset() -> impl Strategy<Value = Offset> {
    prop::array::uniform3(-50.0..50.0_f64).prop_map(|[x, y, z]| Offset { x, y, z })
}

fn point() -> impl Strategy<Value = Point> {
    let number = || -300.0..300.0_f64;
    prop_oneof![
        (
            prop::array::uniform3(number()),
            prop::option::of(number()),
            any::<bool>()
        )
            .prop_map(|(position, rotation, framed)| {
                let frame = framed.then(|| "frame".to_owned());
                Point::Cartesian {
                    position,
                    rotation,
                    frame,
                }
            }),
        prop::array::uniform4(-90.0..90.0_f64).prop_map(Point::Joints),
    ]
}

fn place() -> impl Strategy<Value = Place> {
    prop_oneof![
        point().prop_map(Place::At),
        Just(Place::from("a name, with \"marks\""))
    ]
}

fn here() -> impl Strategy<Value = Here> {
    (
        any::<Option<bool>>(),
        prop::option::of(-90.0..90.0_f64),
        0.0..655.0_f64,
    )
        .prop_map(|(suction, gripper, pause)| Here {
            suction,
            gripper,
            pause: Some(pause),
        })
}

fn action() -> impl Strategy<Value = Action> {
    let modes = prop::sample::select(vec![MovingMode::Jump, MovingMode::MovL, MovingMode::MovJ]);
    let arc = || {
        (place(), place(), 0.01..10.0_f64).prop_map(|(through, to, tolerance)| Arc {
            through,
            to,
            tolerance,
        })
    };
    let speed =
        (prop::option::of(1.0..100.0_f64), 1.0..500.0_f64).prop_map(|(percent, line)| Speed {
            percent,
            line: Some(line),
            ..Speed::default()
        });
    let leaf = prop_oneof![
        4 => (place(), offset(), modes, here()).prop_map(|(to, offset, path, then)| Action::Go(Go { to, offset, path, then })),
        1 => here().prop_map(Action::Here),
        1 => any::<bool>().prop_map(Action::Laser),
        1 => "[a-z \"\n#=]{1,20}".prop_map(Action::Wait),
        1 => "[a-z \"\n#=]{1,20}".prop_map(Action::Barrier),
        1 => speed.prop_map(Action::Speed),
        1 => Just(Action::Tool("tool".to_owned())),
        1 => arc().prop_map(Action::Arc),
        1 => arc().prop_map(Action::Circle),
    ];
    leaf.prop_recursive(3, 12, 4, |inner| {
        let steps = prop::collection::vec(inner, 1..4).prop_map(Steps::new);
        prop_oneof![
            (1..5_u64, steps.clone())
                .prop_map(|(count, steps)| Action::Repeat(Times::Count(count), steps)),
            steps
                .clone()
                .prop_map(|steps| Action::Repeat(Times::Forever, steps)),
            steps.prop_map(|steps| Action::Each(vec!["grid".to_owned()], steps)),
        ]
    })
}

fn program() -> impl Strategy<Value = Program> {
    let sizes = prop::array::uniform3(1..5_u32);
    let named = (point(), sizes, offset(), 0.0..200.0_f64);
    (
        named,
        prop::collection::vec(action(), 1..6),
        prop::option::of(1.0..100.0_f64),
    )
        .prop_map(
            |((point, [columns, rows, layers], pitch, length), actions, start)| {
                let [origin, x, y] = [[200.0, 0.0], [230.0, 0.0], [200.0, 30.0]]
                    .map(|[x, y]| Point::xyz(x, y, 0.0).into());
                let tool = MountedTool {
                    kind: Tool::Gripper,
                    length,
                };
                let grid = Grid {
                    at: Point::xyz(200.0, 0.0, 0.0).into(),
                    columns,
                    rows,
                    layers,
                    pitch,
                };
                let mut program = Program::new(actions);
                program.start_speed_percent = start;
                program.points = BTreeMap::from([("a name, with \"marks\"".to_owned(), point)]);
                program.frames = BTreeMap::from([("frame".to_owned(), Frame { origin, x, y })]);
                program.grids = BTreeMap::from([("grid".to_owned(), grid)]);
                program.tools = BTreeMap::from([("tool".to_owned(), tool)]);
                program
            },
        )
}

proptest! {
    #[test]
    fn a_program_that_is_written_is_read_again_equal(program in program()) {
        let text = program.to_toml();
        let again = Program::from_toml(&text).unwrap();
        prop_assert_eq!(again, program, "{}", text);
    }

    #[test]
    fn a_program_is_made_into_a_job_or_refused_with_a_line(program in program()) {
        match Program::from_toml(&program.to_toml()).unwrap().compile(&mut NoFiles) {
            Ok(compiled) => {
                let job = compiled.job();
                prop_assert_eq!(job.program.check(job.commands.len()), Ok(()));
                prop_assert!(job.pauses.iter().all(|pause| pause.before < job.commands.len()));
            }
            Err(error) => prop_assert!(error.line.is_some(), "{}", error),
        }
    }

    #[test]
    fn a_pattern_has_rows_by_columns_by_layers(program in program()) {
        let cells = program.grids["grid"].cells();
        let each = Action::Each(vec!["grid".to_owned()], Steps::new(vec![Action::Go(Go::to("grid"))]));
        let mut program = program;
        (program.steps, program.start_speed_percent) = (Steps::new(vec![each]), None);
        let compiled = program.compile(&mut NoFiles).unwrap();
        prop_assert_eq!(compiled.commands.len() as u64, cells);
    }
}

#[test]
fn a_program_is_written_as_people_write_it() {
    let text = "[points]\nhere = { x = 200.0, y = 60.0, z = 0.0 }\n\n[[steps]]\ngo = \"here\"\nsuction = true\n\n\
        [[steps]]\nrepeat = 3\n\n[[steps.steps]]\ngo = { x = 200.0, y = -60.0, z = 0.0 }\npath = \"movl\"\n";
    assert_eq!(Program::from_toml(text).unwrap().to_toml(), text);
}
