//! Whether the rules allow every plan: a plan accepted by a dry run must not be refused in the
//! run.

use dobot_arm::{Pose, Position, Tool};
use dobot_geometry::{Point, Stroke};
use dobot_motion::{ArmPlace, Model};
use dobot_plan::{
    ArmLimits, DrawingTool, Laser, MoveKind, Paper, Pass, Pen, Plan, RespeedStart, end_speed_mm_s,
    respeed, stop_each,
};
use dobot_safety::Policy;
use dobot_wire::{Command, Dialect, Status, WriteVector};
use proptest::prelude::*;

/// Strokes within reach, of steps from a hundredth of a millimetre to the whole width of the paper.
fn strokes() -> impl Strategy<Value = Vec<Stroke>> {
    let place = || (160.0..260.0_f64, -90.0..90.0_f64).prop_map(|(x, y)| Point::new(x, y));
    let way = (0.0..360.0_f64, -2.0..1.5_f64);
    let step = prop_oneof![
        4 => way.prop_map(|(turn_deg, power)| (turn_deg, 10.0_f64.powf(power))),
        1 => (0.0..360.0_f64, 20.0..150.0_f64),
    ];
    // As in small letters: none of its steps is long, and few of them lead to a stroke that is hardly longer than they are.
    let small = (0.0..360.0_f64, 0.05..0.8_f64);
    let steps = prop_oneof![
        2 => prop::collection::vec(step, 0..12),
        1 => prop::collection::vec(small, 1..12),
    ];
    let stroke = (place(), steps).prop_map(|(start, steps)| {
        let walk = steps.iter().scan(start, |here, &(turn_deg, length_mm)| {
            let ahead = *here + dobot_geometry::direction(turn_deg) * length_mm;
            let is_inside = (160.0..260.0).contains(&ahead.x) && ahead.y.abs() < 90.0;
            // Back through the centre, beside the previous path.
            let back = Point::new(420.0 - here.x, 0.9 * -here.y);
            *here = if is_inside { ahead } else { back };
            Some(*here)
        });
        Stroke::open([start].into_iter().chain(walk).collect())
    });
    prop::collection::vec(stroke, 1..4)
}

fn tool() -> impl Strategy<Value = DrawingTool> {
    let speed = || prop_oneof![Just(200.0), 1.0..200.0_f64];
    prop_oneof![
        (speed(), speed(), 1.0..100.0_f64).prop_map(|(draw, travel, lift)| {
            DrawingTool::Pen(Pen {
                draw_speed_mm_s: draw,
                travel_speed_mm_s: travel,
                lift_speed_mm_s: lift,
                ..Pen::default()
            })
        }),
        (
            prop_oneof![Just(1.0), 1.0..4.0_f64, 1.5..6.0_f64, 5.0..60.0_f64],
            speed()
        )
            .prop_map(|(burn, travel)| {
                DrawingTool::Laser(Laser {
                    burn_speed_mm_s: burn,
                    travel_speed_mm_s: travel,
                    ..Laser::default()
                })
            }),
    ]
}

/// Returns the first command that the policy refuses or that takes the arm too long, and why.
fn refused(
    commands: Vec<Command>,
    start: [f64; 3],
    dialect: Dialect,
    tool: Tool,
) -> Option<String> {
    refused_after(Before::Rest, commands, start, dialect, tool)
}

/// The arm's previous motion.
#[derive(Clone, Copy, Debug)]
enum Before {
    /// Nothing since its power-up.
    Rest,
    /// Unknown: a client has connected to it.
    Others,
}

fn refused_after(
    before: Before,
    commands: Vec<Command>,
    start: [f64; 3],
    dialect: Dialect,
    tool: Tool,
) -> Option<String> {
    let [x, y, z] = start;
    let position = Position::new(x, y, z);
    let pose = Pose {
        position,
        rotation: position.direction(),
    };
    let place = ArmPlace::at_pose(pose, tool).unwrap();
    let mut model = match before {
        Before::Rest => Model::standing(dialect, place),
        Before::Others => Model::new(dialect, &Status::AT_ZERO),
    };
    model.place = place;
    model.tool = tool;
    let policy = Policy::default();
    commands
        .into_iter()
        .enumerate()
        .find_map(|(number, command)| match policy.check(&model, &command) {
            Ok(trajectory) if trajectory.duration_s() > Some(most_s(&command)) => Some(format!(
                "{number}: takes {:?} s, {command:?}",
                trajectory.duration_s()
            )),
            Ok(trajectory) => {
                model = model.after(&command, &trajectory);
                None
            }
            Err(violation) => Some(format!("{number}: {violation}, {command:?}")),
        })
}

/// Returns the longest duration of a vector: at a tenth of its largest speed, plus a second.
fn most_s(command: &Command) -> f64 {
    match command {
        Command::WriteVector(vector) => {
            let way_mm = vector.x_mm.hypot(vector.y_mm).hypot(vector.z_mm);
            1.0 + f64::from(way_mm / (0.1 * vector.max_speed_mm_s))
        }
        _ => f64::INFINITY,
    }
}

/// A plan from one of its vectors on, at another share of its speeds.
struct Other {
    /// All of its commands, when a person asks for that share while the arm draws.
    running: Vec<Command>,
    /// The commands from that vector on after a crash: up to the next rest, each of them ends at
    /// rest.
    after_a_crash: Vec<Command>,
    /// The arm's position then.
    here: [f64; 3],
}

impl Other {
    fn of(plan: &Plan, at: usize, share: f64, tool: Tool) -> Self {
        let arm_limits = plan.arm_limits();
        let mut running: Vec<Command> = plan.commands().collect();
        let first = plan.command_of(at);
        let vector = |command: &Command| match command {
            Command::WriteVector(vector) => Some(*vector),
            _ => None,
        };
        let before = running[..first].iter().filter_map(vector);
        let speed_mm_s = before.fold(0.0, |speed, vector| {
            end_speed_mm_s(&vector, speed, arm_limits)
        });
        let vectors: Vec<WriteVector> = running[first..].iter().filter_map(vector).collect();
        let here = plan.positions().take(at).last().unwrap_or(plan.start);
        let begin = RespeedStart {
            speed_mm_s,
            position: Position::new(here[0], here[1], here[2]),
            tool,
        };
        let faster_or_slower = respeed(&vectors, &begin, share, arm_limits);
        for (command, other) in running[first..].iter_mut().zip(faster_or_slower) {
            *command = other.into();
        }
        let rest = vectors
            .iter()
            .position(|vector| vector.end_speed_mm_s == 0.0);
        let chain = &vectors[..=rest.expect("a plan ends at rest")];
        let setup = plan.commands().take(plan.command_of(0) - 1);
        let resting = stop_each(chain, share, arm_limits);
        Self {
            running,
            after_a_crash: setup
                .chain(resting.into_iter().map(Command::from))
                .collect(),
            here,
        }
    }
}

proptest! {
    #[test]
    fn the_rules_allow_every_command_of_a_plan_at_any_speed(
        strokes in strokes(), tool in tool(), share in 0.1..1.0_f64, at in any::<prop::sample::Index>(),
    ) {
        for dialect in [Dialect::SPECIFICATION, Dialect::FIRMWARE_1_1] {
            let arm_limits = ArmLimits::of(dialect);
            let pass = Pass::new(tool, strokes.clone());
            let plan = Plan::new(&[pass], &Paper::level(-40.0), &arm_limits).unwrap();
            let most = 200.0_f64;
            for vector in &plan.moves {
                prop_assert!(f64::from(vector.max_speed_mm_s) <= most, "{vector:?}");
            }
            let effector = tool.end_effector();
            let refusal = |commands, start| refused(commands, start, dialect, effector);
            prop_assert_eq!(refusal(plan.commands().collect(), plan.start), None);
            let commands = plan.commands().collect();
            let refusal_after_others = refused_after(Before::Others, commands, plan.start, dialect, effector);
            prop_assert_eq!(refusal_after_others, None);
            // The policy has a least speed for lasers: a slower request is refused.
            if plan.moves.is_empty() || plan.burns() {
                continue;
            }
            let other = Other::of(&plan, at.index(plan.moves.len()), share.min(1.0), effector);
            prop_assert_eq!(refusal(other.running, plan.start), None);
            prop_assert_eq!(refusal(other.after_a_crash, other.here), None);
        }
    }
}

/// After a burned vector that ended at 0.16 mm/s the lead-out, 0.3 mm, took two seconds: with the
/// laser off a stock arm accelerates by 200 mm/s at each tick, or not at all.
#[test]
fn a_laser_that_is_switched_off_after_a_slow_shape_does_not_creep() {
    let sides = [
        [-3.0840, -1.0021],
        [0.0, -3.3308],
        [3.1677, -1.0292],
        [1.9578, 2.6947],
    ];
    let mut points = vec![Point::new(170.0, -20.0)];
    for [x, y] in sides {
        let last = points[points.len() - 1];
        points.push(Point::new(last.x + x, last.y + y));
    }
    points.push(points[0]);
    let pentagon = Stroke {
        points,
        closed: true,
    };
    for burn_speed_mm_s in [3.0, 4.0, 5.0, 6.0, 8.0] {
        let tool = DrawingTool::Laser(Laser {
            burn_speed_mm_s,
            ..Laser::default()
        });
        let pass = Pass::new(tool, vec![pentagon.clone()]);
        let arm_limits = ArmLimits::of(Dialect::FIRMWARE_1_1);
        let plan = Plan::new(&[pass], &Paper::level(-40.0), &arm_limits).unwrap();
        for vector in plan
            .moves
            .iter()
            .filter(|planned| planned.kind == MoveKind::RunOut)
        {
            assert!(
                vector.duration_s < 0.5,
                "{burn_speed_mm_s} mm/s: {vector:?}"
            );
        }
        let dialect = Dialect::FIRMWARE_1_1;
        let refusal = refused(plan.commands().collect(), plan.start, dialect, Tool::Laser);
        assert_eq!(refusal, None, "{burn_speed_mm_s} mm/s");
    }
}

/// After a line of 165 mm, which a stock arm can run 2 % faster or 5 % slower, it kept 0.36 mm/s for a piece of 0.2 mm.
#[test]
fn a_laser_does_not_creep_along_a_short_piece_because_of_a_long_line_before_it() {
    let points = [
        (237.460_504_156_907_58, 81.879_966_704_964_43),
        (182.539_495_843_092_42, -73.691_970_034_467_99),
        (182.456_087_589_244_93, -73.894_329_920_720_7),
        (237.543_912_410_755_07, 66.504_896_928_648_62),
        (240.661_735_847_242_88, 66.504_896_928_648_62),
    ];
    let stroke = Stroke::open(points.map(Point::from).to_vec());
    let tool = DrawingTool::Laser(Laser {
        burn_speed_mm_s: 2.410_659_434_173_686,
        ..Laser::default()
    });
    let dialect = Dialect::FIRMWARE_1_1;
    let pass = Pass::new(tool, vec![stroke]);
    let plan = Plan::new(&[pass], &Paper::level(-40.0), &ArmLimits::of(dialect)).unwrap();
    let refusal = refused(plan.commands().collect(), plan.start, dialect, Tool::Laser);
    assert_eq!(refusal, None);
}

/// A speed left by previous clients of the arm became the start of a run-out of 0.15 mm: almost
/// nothing, or less.
#[test]
fn a_laser_does_not_creep_after_small_shapes_that_begin_at_an_unknown_speed() {
    for sides in 3..9_u32 {
        for radius_mm in [0.2, 0.35, 0.5, 1.0] {
            let at = |i: u32| {
                let way = dobot_geometry::direction(360.0 / f64::from(sides) * f64::from(i));
                Point::new(210.0, 20.0) + way * radius_mm
            };
            let polygon = Stroke {
                points: (0..=sides).map(at).collect(),
                closed: true,
            };
            for burn_speed_mm_s in [1.0, 1.01, 1.1, 1.2, 1.3, 1.5, 1.7, 1.9, 2.0, 2.5, 3.0] {
                let tool = DrawingTool::Laser(Laser {
                    burn_speed_mm_s,
                    ..Laser::default()
                });
                let dialect = Dialect::FIRMWARE_1_1;
                let pass = Pass::new(tool, vec![polygon.clone()]);
                let arm_limits = ArmLimits::of(dialect);
                let plan = Plan::new(&[pass], &Paper::level(-40.0), &arm_limits).unwrap();
                let commands = plan.commands().collect();
                let refusal =
                    refused_after(Before::Others, commands, plan.start, dialect, Tool::Laser);
                assert_eq!(
                    refusal, None,
                    "{sides} sides, {radius_mm} mm, {burn_speed_mm_s} mm/s"
                );
            }
        }
    }
}
