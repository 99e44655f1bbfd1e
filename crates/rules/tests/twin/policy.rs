//! Whether the rules allow what is planned: a plan that a dry run takes may not be refused in the run.

use dobot_arm::{Pose, Position, Tool};
use dobot_geometry::{Point, Stroke};
use dobot_plan::{DrawingTool, Laser, Machine, Paper, Pass, Pen, Plan};
use dobot_safety::Policy;
use dobot_trajectory::{ArmPlace, Model};
use dobot_wire::Dialect;
use proptest::prelude::*;

/// Strokes within reach, of steps from a hundredth of a millimetre to the whole width of the paper.
fn strokes() -> impl Strategy<Value = Vec<Stroke>> {
    let place = || (160.0..260.0_f64, -90.0..90.0_f64).prop_map(|(x, y)| Point::new(x, y));
    let way = (0.0..360.0_f64, -2.0..1.5_f64);
    let step = prop_oneof![
        4 => way.prop_map(|(turn_deg, power)| (turn_deg, 10.0_f64.powf(power))),
        1 => (0.0..360.0_f64, 20.0..150.0_f64),
    ];
    let stroke = (place(), prop::collection::vec(step, 0..12)).prop_map(|(start, steps)| {
        let walk = steps.iter().scan(start, |here, &(turn_deg, length_mm)| {
            let ahead = *here + dobot_geometry::direction(turn_deg) * length_mm;
            let is_inside = (160.0..260.0).contains(&ahead.x) && ahead.y.abs() < 90.0;
            // Back over the middle, beside the way that it came.
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
        (5.0..60.0_f64, speed()).prop_map(|(burn, travel)| {
            DrawingTool::Laser(Laser {
                burn_speed_mm_s: burn,
                travel_speed_mm_s: travel,
                ..Laser::default()
            })
        }),
    ]
}

/// The first command of a plan that the policy refuses, and why.
fn refused(plan: &Plan, dialect: Dialect, tool: Tool) -> Option<String> {
    let [x, y, z] = plan.start;
    let position = Position::new(x, y, z);
    let pose = Pose {
        position,
        rotation: position.direction(),
    };
    let place = ArmPlace::at_pose(pose, tool).unwrap();
    let mut model = Model::standing(dialect, place);
    model.tool = tool;
    let policy = Policy::default();
    plan.commands()
        .enumerate()
        .find_map(|(number, command)| match policy.check(&model, &command) {
            Ok(trajectory) => {
                model = model.after(&command, &trajectory);
                None
            }
            Err(violation) => Some(format!("{number}: {violation}, {command:?}")),
        })
}

proptest! {
    #[test]
    fn the_rules_allow_every_command_of_a_plan(strokes in strokes(), tool in tool()) {
        for dialect in [Dialect::SPECIFICATION, Dialect::FIRMWARE_1_1] {
            let machine = Machine::of(dialect);
            let pass = Pass::new(tool, strokes.clone());
            let plan = Plan::new(&[pass], &Paper::level(-40.0), &machine).unwrap();
            let most = 200.0_f64;
            for vector in &plan.moves {
                prop_assert!(f64::from(vector.max_speed_mm_s) <= most, "{vector:?}");
            }
            prop_assert_eq!(refused(&plan, dialect, tool.end_effector()), None);
        }
    }
}
