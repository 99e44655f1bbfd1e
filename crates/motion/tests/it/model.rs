//! Trajectories of commands, compared with closed formulas.

use dobot_arm::{Joints, Position, Tool, forward};
use dobot_motion::{ArmPlace, JogAxis, Model, Trajectory, TrajectoryError};
use dobot_wire::{
    Command, Configuration, Dialect, Gesture, JointJog, JointJogAxis, LinearJog, LinearJogAxis,
    MouseMove, MoveJoints, MoveTo, MovingMode, PlaybackAdjustment, Status, Voice, WriteMode,
    WriteVector,
};
use proptest::prelude::*;

const DOCUMENT: Dialect = Dialect::SPECIFICATION;
const STOCK: Dialect = Dialect::FIRMWARE_1_1;

/// An arm in the middle of its reach: at 220, 0, 20 with the tool straight ahead.
fn model(dialect: Dialect) -> Model {
    let pose = dobot_arm::Pose {
        position: Position::new(220.0, 0.0, 20.0),
        ..dobot_arm::Pose::default()
    };
    let place = ArmPlace::at_pose(pose, Tool::SuctionCup).expect("it is in reach");
    Model::standing(dialect, place)
}

fn to(mode: MovingMode, x_mm: f32, y_mm: f32, z_mm: f32) -> MoveTo {
    MoveTo::to(x_mm, y_mm, z_mm).with_mode(mode)
}

fn vector(x_mm: f32, y_mm: f32, end_speed_mm_s: f32, max_speed_mm_s: f32) -> WriteVector {
    WriteVector {
        end_speed_mm_s,
        ..WriteVector::by(x_mm, y_mm, 0.0, max_speed_mm_s)
    }
}

fn jog(axis: JointJogAxis, speed_percent: f32) -> Command {
    JointJog::new(axis, speed_percent).into()
}

fn trajectory(model: &Model, command: impl Into<Command>) -> Trajectory {
    model
        .trajectory(&command.into())
        .expect("the arm may do that from here")
}

fn after(model: &Model, command: impl Into<Command>) -> Model {
    let command = command.into();
    model.after(&command, &trajectory(model, command))
}

fn refusal(model: &Model, command: impl Into<Command>) -> TrajectoryError {
    model
        .trajectory(&command.into())
        .expect_err("the arm may not do that")
}

fn close(what: &str, found: f64, expected: f64, tolerance: f64) {
    assert!(
        (found - expected).abs() <= tolerance,
        "{what} is {found}; expected {expected} within {tolerance}"
    );
}

/// The single-precision accuracy of a stock arm's position: 24 bits of 300 mm.
const SINGLE_MM: f64 = 1e-4;

fn motion_s(trajectory: &Trajectory) -> f64 {
    trajectory.motion_s().expect("it comes to an end")
}

fn z_at(trajectory: &Trajectory, t_s: f64) -> f64 {
    let place = trajectory.place_at(t_s).expect("it is in reach");
    place.pose.position.z.0
}

#[test]
fn a_line_takes_its_length_by_its_speed_and_one_ramp_more() {
    for dialect in Dialect::ALL {
        let trajectory = trajectory(&model(dialect), to(MovingMode::MovL, 220.0, 100.0, 20.0));
        // 50 mm/s and 100 mm/s2: half of what a stock arm is configured for.
        close(
            "duration",
            motion_s(&trajectory),
            100.0 / 50.0 + 50.0 / 100.0,
            1e-9,
        );
        let middle = trajectory.place_at(1.25).expect("it is in reach");
        close("y half way", middle.pose.position.y.0, 50.0, 1e-9);
    }
}

#[test]
fn a_short_joint_move_takes_twice_the_root_of_angle_by_acceleration() {
    for dialect in Dialect::ALL {
        let from = model(dialect);
        let joints = from.place.joints;
        #[expect(
            clippy::cast_possible_truncation,
            reason = "the wire is single precision"
        )]
        let turn = MoveJoints::to([81.0, joints.rear.0 as f32, joints.fore.0 as f32, 0.0])
            .with_mode(MovingMode::MovJ);
        // 100 degrees/s2, and the 100 degrees/s are never reached.
        let trajectory = trajectory(&from, turn);
        close(
            "duration",
            motion_s(&trajectory),
            2.0 * (81.0_f64 / 100.0).sqrt(),
            1e-6,
        );
    }
}

#[test]
fn percentages_scale_speeds_and_accelerations() {
    let adjusted = after(
        &model(STOCK),
        PlaybackAdjustment {
            speed_percent: 75.0,
            acceleration_percent: 50.0,
            teach_speed_percent: 10.0,
        },
    );
    let trajectory = trajectory(&adjusted, to(MovingMode::MovL, 220.0, 120.0, 20.0));
    // 75 mm/s and 100 mm/s2.
    close(
        "duration",
        motion_s(&trajectory),
        120.0 / 75.0 + 75.0 / 100.0,
        1e-9,
    );
}

#[test]
fn a_vector_begins_with_its_start_speed_or_with_what_the_last_one_left() {
    let first = vector(0.0, 20.0, 40.0, 40.0);
    let second = vector(0.0, 20.0, 40.0, 40.0);
    // From rest to 40 mm/s within 8 mm at 100 mm/s2, then 12 mm at that speed.
    let from_rest_s = 0.4 + 12.0 / 40.0;
    for (dialect, expected_s) in [(DOCUMENT, from_rest_s), (STOCK, 20.0 / 40.0)] {
        let model = model(dialect);
        close(
            "first",
            motion_s(&trajectory(&model, first)),
            from_rest_s,
            1e-9,
        );
        let then = after(&model, first);
        close(
            "second",
            motion_s(&trajectory(&then, second)),
            expected_s,
            1e-9,
        );
    }
}

#[test]
fn a_jump_rises_above_the_higher_end_or_lifts_at_each_end_as_the_dialect_has_it() {
    let target = to(MovingMode::Jump, 220.0, 100.0, 60.0);
    let highest = |dialect| {
        let trajectory = trajectory(&model(dialect), target);
        let steps =
            (0..=1000).map(|n| z_at(&trajectory, motion_s(&trajectory) * f64::from(n) / 1000.0));
        steps.fold(f64::MIN, f64::max)
    };
    close("document", highest(DOCUMENT), 60.0 + 20.0, 0.01);
    close("stock", highest(STOCK), 60.0 + 10.0, 0.1);
    // Where the document rises to 80, a stock arm lifts by 10.
    let stock = trajectory(&model(STOCK), target);
    let lifted_s = (0..=1000)
        .map(|n| motion_s(&stock) * f64::from(n) / 1000.0)
        .find(|&t_s| stock.place_at(t_s).expect("in reach").joints.base.0 > 0.01)
        .expect("it turns");
    close("height before it turns", z_at(&stock, lifted_s), 30.0, 0.2);
}

#[test]
fn a_jump_of_a_stock_arm_whose_corner_is_out_of_reach_is_refused() {
    let error = refusal(&model(STOCK), to(MovingMode::Jump, 220.0, 0.0, 130.0));
    assert!(matches!(error, TrajectoryError::Unreachable(_)), "{error}");
    assert!(error.to_string().contains("140"), "{error}");
}

#[test]
fn the_tool_of_a_stock_arm_turns_at_the_end_of_a_line() {
    let target = MoveTo {
        rotation_deg: 30.0,
        ..to(MovingMode::MovL, 220.0, 50.0, 20.0)
    };
    for (dialect, expected_deg) in [(DOCUMENT, 15.0), (STOCK, 0.0)] {
        let trajectory = trajectory(&model(dialect), target);
        let half = trajectory
            .place_at(motion_s(&trajectory) / 2.0)
            .expect("in reach");
        close(
            "rotation half way",
            half.pose.rotation.0,
            expected_deg,
            1e-9,
        );
        let end = trajectory.end().expect("it is known");
        close("rotation at the end", end.pose.rotation.0, 30.0, 1e-9);
    }
}

#[test]
fn a_default_pause_counts_where_the_dialect_knows_it() {
    let playback = Configuration::playback([200.0, 200.0, 200.0, 200.0, 100.0, 200.0], 3.0, 5.0);
    for (dialect, expected_s) in [(DOCUMENT, 3.0), (STOCK, 0.0)] {
        let model = after(&model(dialect), playback);
        let trajectory = trajectory(&model, to(MovingMode::MovJ, 230.0, 0.0, 20.0));
        close("pause", trajectory.pause_s(), expected_s, 0.0);
        let duration_s = trajectory.duration_s().expect("it ends");
        close("all", duration_s, motion_s(&trajectory) + expected_s, 1e-12);
    }
}

#[test]
fn a_line_without_length_is_refused_for_an_arm_that_would_lose_its_pose() {
    let here = to(MovingMode::MovL, 220.0, 0.0, 20.0);
    assert_eq!(refusal(&model(STOCK), here), TrajectoryError::OnTheSpot);
    assert!(!trajectory(&model(DOCUMENT), here).moves());
}

#[test]
fn a_line_behind_one_that_ends_at_a_limit_is_refused_for_an_arm_that_would_jump() {
    // The rear arm at exactly -5 degrees: rounding moves the last tick beyond the limit, and the
    // state of the line is kept for the next one (note N46).
    let to_limit = MoveJoints::to([10.0, -5.0, 35.0, 0.0]).with_mode(MovingMode::MovL);
    let back = to(MovingMode::MovL, 220.0, 0.0, 20.0);
    let there = after(&model(STOCK), to_limit);
    assert_eq!(refusal(&there, back), TrajectoryError::BehindCutLine);
    let beside = after(
        &model(STOCK),
        MoveJoints {
            rear_deg: -4.9,
            ..to_limit
        },
    );
    assert!(trajectory(&beside, back).moves());
    let cleared = after(&there, to(MovingMode::MovJ, 220.0, 10.0, 20.0));
    assert!(trajectory(&cleared, back).moves());
}

#[test]
fn a_value_beyond_its_table_is_refused_with_the_table() {
    for command in [
        Command::from(to(MovingMode::MovJ, f32::NAN, 0.0, 0.0)),
        Command::from(vector(0.0, 0.0, 0.0, 40.0)),
        Configuration::Writing {
            acceleration_mm_s2: 0.0,
        }
        .into(),
    ] {
        let error = refusal(&model(STOCK), command);
        assert!(matches!(error, TrajectoryError::Invalid(_)), "{error}");
    }
}

#[test]
fn an_end_beyond_a_limit_is_refused_where_the_way_leaves_it() {
    let error = refusal(&model(DOCUMENT), vector(150.0, 0.0, 0.0, 40.0));
    let TrajectoryError::Unreachable(beyond) = error else {
        panic!("{error}");
    };
    // The travel of a tick at 40 mm/s, which opens the elbow by less than half a degree at that
    // reach.
    assert!((0.0..0.8).contains(&beyond.excess()), "{error}");
    assert!(error.to_string().starts_with("on its way"), "{error}");
}

#[test]
fn a_jog_goes_on_and_its_release_runs_down() {
    let model = model(DOCUMENT);
    let held = jog(JointJogAxis::BasePlus, 100.0);
    let trajectory_held = trajectory(&model, held);
    assert_eq!(trajectory_held.duration_s(), None);
    assert_eq!(trajectory_held.end(), None);
    let going = trajectory_held.jog().expect("it is one");
    assert_eq!(going.axis(), JogAxis::Base);
    close("speed", going.target_speed(), 15.0, 0.0);
    // 15 degrees/s after 0.3 s at 50 degrees/s2.
    let later = trajectory_held.place_at(2.0).expect("in reach");
    close(
        "base",
        later.joints.base.0,
        15.0 * 2.0 - 0.5 * 15.0 * 0.3,
        1e-9,
    );

    let jogging = after(&model, held);
    assert!(!jogging.knows_place());
    let released = trajectory(&jogging, jog(JointJogAxis::Released, 0.0));
    close("run down", motion_s(&released), 0.3, 1e-9);
    assert_eq!(released.end(), None);
}

#[test]
fn an_axis_coasts_as_far_as_its_release_moves_it() {
    let standing = model(STOCK);
    let jogging = after(&standing, jog(JointJogAxis::BasePlus, 80.0));
    let released = trajectory(&jogging, jog(JointJogAxis::Released, 0.0));
    let begin = jogging.place.joints.base.0;
    let end = released.place_at(1.0).expect("in reach");
    let coasting = JogAxis::Base.coasting(&standing.settings, 0.8, 0.0);
    assert!(
        (end.joints.base.0 - begin - coasting).abs() < 1e-9,
        "{coasting}"
    );
}

#[test]
fn behind_a_jog_a_target_has_a_known_end_and_a_step_has_none() {
    let jogging = after(&model(STOCK), jog(JointJogAxis::BasePlus, 50.0));
    let target = trajectory(&jogging, to(MovingMode::MovL, 220.0, 50.0, 20.0));
    assert!(target.end().is_some() && !target.is_exact());
    assert!(after(&jogging, to(MovingMode::MovL, 220.0, 50.0, 20.0)).knows_place());
    let step = trajectory(&jogging, vector(0.0, 10.0, 0.0, 40.0));
    assert_eq!(step.end(), None);
}

#[test]
fn the_jog_percentage_of_state_10_counts_where_the_dialect_uses_it() {
    let adjustment = PlaybackAdjustment {
        speed_percent: 50.0,
        acceleration_percent: 50.0,
        teach_speed_percent: 20.0,
    };
    let held = LinearJog::new(LinearJogAxis::YMinus, 50.0);
    for (dialect, expected) in [(DOCUMENT, -6.0), (STOCK, -30.0)] {
        let trajectory = trajectory(&after(&model(dialect), adjustment), held);
        let jog = trajectory.jog().expect("it is one");
        close("speed", jog.target_speed(), expected, 1e-9);
    }
}

#[test]
fn laser_mode_of_a_stock_arm_holds_its_height_and_leaves_the_laser_on() {
    let burn = WriteVector {
        mode: WriteMode::Laser,
        laser: true,
        z_mm: 30.0,
        ..vector(0.0, 40.0, 0.0, 50.0)
    };
    let stock = trajectory(&model(STOCK), burn);
    assert!(stock.laser());
    let end = stock.end().expect("it is known").pose.position;
    assert!(
        end.distance(Position::new(220.0, 40.0, 20.0)).0 < SINGLE_MM,
        "{end:?}"
    );
    // The height counts towards the length: 50 mm at 50 mm/s, and half a second of ramp.
    close("duration", motion_s(&stock), 50.0 / 50.0 + 0.5, 1e-9);
    assert!(after(&model(STOCK), burn).laser);

    let document = trajectory(&model(DOCUMENT), burn);
    close(
        "z",
        document.end().expect("known").pose.position.z.0,
        50.0,
        1e-9,
    );
    assert!(!after(&model(DOCUMENT), burn).laser);
}

#[test]
fn a_rapid_vector_that_a_stock_arm_cuts_short_is_refused() {
    let slow = WriteVector {
        mode: WriteMode::Laser,
        ..vector(0.0, 40.0, 0.0, 50.0)
    };
    // 100 mm/s2 a hundredfold change the speed by 200 mm/s per tick; half of that rounds to one
    // tick.
    let error = refusal(&model(STOCK), slow);
    assert_eq!(
        error,
        TrajectoryError::SlowRapid {
            found: 50.0,
            least: 100.0
        }
    );
    trajectory(&model(DOCUMENT), slow);
}

#[test]
fn a_laser_vector_goes_on_without_the_laser_as_fast_as_it_burned() {
    let burn = WriteVector {
        mode: WriteMode::Laser,
        laser: true,
        end_speed_mm_s: 10.0,
        ..vector(0.0, 40.0, 0.0, 10.0)
    };
    let run_out = WriteVector {
        mode: WriteMode::Laser,
        end_speed_mm_s: 10.0,
        ..vector(0.0, 2.0, 0.0, 10.0)
    };
    let burned = after(&model(STOCK), burn);
    let trajectory = trajectory(&burned, run_out);
    // 2 mm at about 10 mm/s: whole ticks of the burn make it slightly more or less.
    close("time", trajectory.motion_s().expect("it ends"), 0.2, 0.02);
    let end = trajectory.end().expect("known").pose.position;
    close(
        "y",
        end.y.0 - burned.place.pose.position.y.0,
        2.0,
        SINGLE_MM,
    );
    let rested = after(
        &model(STOCK),
        WriteVector {
            end_speed_mm_s: 0.0,
            ..burn
        },
    );
    assert!(matches!(
        refusal(&rested, run_out),
        TrajectoryError::SlowRapid { .. }
    ));
}

#[test]
fn a_tool_moves_the_position_and_not_the_angles() {
    let laser = Configuration::EndEffector {
        tool: Tool::Laser.into(),
    };
    let model = after(&model(DOCUMENT), laser);
    close("x", model.place.pose.position.x.0, 220.0 - 5.5, 1e-9);
    assert_eq!(model.tool, Tool::Laser);
}

#[test]
#[expect(
    clippy::cast_possible_truncation,
    reason = "the wire is single precision"
)]
fn a_status_shows_which_tool_is_mounted() {
    let joints = Joints::new(10.0, 30.0, 40.0, 0.0);
    let pose = forward(&joints, Tool::Laser);
    let status = Status {
        x_mm: pose.position.x.0 as f32,
        y_mm: pose.position.y.0 as f32,
        z_mm: pose.position.z.0 as f32,
        rotation_deg: 10.0,
        base_deg: 10.0,
        rear_deg: 30.0,
        fore_deg: 40.0,
        servo_deg: 0.0,
        suction: true,
        gripper_deg: 12.0,
    };
    let model = Model::new(STOCK, &status);
    assert_eq!((model.tool, model.suction), (Tool::Laser, true));
    close("gripper", model.gripper_deg, 12.0, 0.0);
}

#[test]
fn initial_angles_say_where_the_arm_is() {
    let jogging = after(&model(STOCK), jog(JointJogAxis::BasePlus, 50.0));
    let configuration = Configuration::InitialAngles {
        rear_deg: 30.0,
        fore_deg: 40.0,
    };
    let model = after(&jogging, configuration);
    assert!(model.knows_place());
    assert_eq!(model.place.joints, Joints::new(0.0, 30.0, 40.0, 0.0));
}

#[test]
fn a_mouse_moves_by_millimetres_or_swings() {
    let by = MouseMove {
        y: 10.0,
        x: 0.0,
        z: 0.0,
        rotation_deg: 0.0,
        suction: true,
    };
    let document = trajectory(&model(DOCUMENT), by);
    assert!(document.is_exact());
    close(
        "y",
        document.end().expect("known").pose.position.y.0,
        10.0,
        1e-9,
    );
    let stock = trajectory(&model(STOCK), by);
    assert!(stock.is_exact());
    let end = stock.end().expect("the row is known");
    close("base", end.joints.base.0, -2.25, 1e-6);
    close("duration", motion_s(&stock), 0.1, 1e-6);
    assert!(after(&model(STOCK), by).suction);
    let nothing = MouseMove { y: 0.0, ..by };
    assert_eq!(
        refusal(&model(STOCK), nothing),
        TrajectoryError::NothingToFollow
    );
}

#[test]
fn a_spoken_order_is_a_line_and_nonsense_is_refused() {
    let say = |text| Command::from(Voice::new(text).expect("it fits"));
    let trajectory = trajectory(&model(DOCUMENT), say("up twenty"));
    close("z", z_at(&trajectory, 9.0), 40.0, 1e-9);
    assert!(after(&model(DOCUMENT), say("catch")).suction);
    assert_eq!(
        refusal(&model(DOCUMENT), say("hello")),
        TrajectoryError::NotUnderstood
    );
}

fn command() -> impl Strategy<Value = Command> {
    let mode = prop_oneof![
        Just(MovingMode::Jump),
        Just(MovingMode::MovL),
        Just(MovingMode::MovJ)
    ];
    let point = [150.0..320.0_f32, -150.0..150.0_f32, -80.0..140.0_f32];
    let target = (mode.clone(), point, -90.0..90.0_f32).prop_map(|(mode, [x, y, z], turn)| {
        Command::from(MoveTo {
            rotation_deg: turn,
            ..to(mode, x, y, z)
        })
    });
    let angles = [-90.0..90.0_f32, -10.0..90.0, -10.0..95.0, -90.0..90.0];
    let joints = (mode, angles).prop_map(|(mode, [base, rear, fore, servo])| {
        Command::from(MoveJoints {
            base_deg: base,
            rear_deg: rear,
            fore_deg: fore,
            servo_deg: servo,
            suction: true,
            mode,
            gripper_deg: 5.0,
            pause_s: 0.5,
        })
    });
    let vector = (
        -60.0..60.0_f32,
        -60.0..60.0_f32,
        0.0..80.0_f32,
        0.1..200.0_f32,
    )
        .prop_map(|(x, y, end, max)| Command::from(vector(x, y, end, max)));
    let mouse = [-20.0..20.0_f32, -20.0..20.0, -20.0..20.0].prop_map(|[y, x, z]| {
        Command::from(MouseMove {
            y,
            x,
            z,
            rotation_deg: 0.0,
            suction: false,
        })
    });
    let hand = [-100.0..400.0_f32, -100.0..100.0, -100.0..400.0].prop_map(|[x, y, z]| {
        Command::from(Gesture {
            x,
            y,
            z,
            grab: true,
        })
    });
    prop_oneof![target, joints, vector, mouse, hand]
}

proptest! {
    /// A trajectory begins at the arm's position and ends at the position of the model after it.
    #[test]
    fn trajectories_lead_from_the_model_to_the_model_after(
        stock in any::<bool>(),
        commands in prop::collection::vec(command(), 1..6),
    ) {
        let mut model = model(if stock { STOCK } else { DOCUMENT });
        for command in commands {
            let Ok(trajectory) = model.trajectory(&command) else { continue };
            let after = model.after(&command, &trajectory);
            let begin = trajectory.place_at(0.0).expect("the arm stands there");
            let end = trajectory.place_at(motion_s(&trajectory)).expect("it was planned");
            let off_mm = begin.pose.position.distance(model.place.pose.position).0;
            prop_assert!(off_mm < 1e-6, "it begins {off_mm} mm off");
            let off_mm = end.pose.position.distance(after.place.pose.position).0;
            prop_assert!(off_mm < SINGLE_MM, "it ends {off_mm} mm off");
            prop_assert!(after.place.check().is_ok() || !after.knows_place());
            model = after;
        }
    }

    /// An arm that was just switched on has the same settings after the configuration of another one.
    #[test]
    fn a_configuration_gives_another_arm_the_same_settings(
        stock in any::<bool>(),
        speeds in prop::array::uniform6(1.0..300.0_f32),
        pause_s in 0.0..10.0_f32,
        percents in prop::array::uniform3(1.0..100.0_f32),
        is_pen in any::<bool>(),
    ) {
        let [speed_percent, acceleration_percent, teach_speed_percent] = percents;
        let [joint, joint_2, servo, servo_2, line, line_2] = speeds;
        let mut used = model(if stock { STOCK } else { DOCUMENT });
        let tool = if is_pen { Tool::Pen } else { Tool::Laser };
        let commands: [Command; 4] = [
            Configuration::Playback {
                joint_speed_deg_s: joint,
                joint_acceleration_deg_s2: joint_2,
                servo_speed_deg_s: servo,
                servo_acceleration_deg_s2: servo_2,
                linear_speed_mm_s: line,
                linear_acceleration_mm_s2: line_2,
                default_pause_s: pause_s,
                jump_height_mm: line,
            }.into(),
            Configuration::Writing { acceleration_mm_s2: line_2 }.into(),
            Configuration::EndEffector { tool: tool.into() }.into(),
            PlaybackAdjustment { speed_percent, acceleration_percent, teach_speed_percent }.into(),
        ];
        for command in commands {
            used = after(&used, command);
        }
        let fresh = used.configuration().fold(model(used.dialect), |model, command| after(&model, command));
        prop_assert_eq!(fresh.settings, used.settings);
        prop_assert_eq!(fresh.tool, used.tool);
    }
}
