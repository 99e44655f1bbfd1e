//! Client and virtual arm in one process, in virtual time.

mod common;

use std::time::Duration;

use common::{
    POWER_UP_X_MM, button, completed, in_process, move_to, ms, playback, refusals, run, run_with,
    vector, virtual_arm,
};
use dobot_arm::Position;
use dobot_client::{CommandId, Connection, Event, Peer};
use dobot_controller::Refused;
use dobot_course::CourseError;
use dobot_sim::{InProcess, Sample};
use dobot_wire::{
    Command, Configuration, Dialect, EndEffector, JointJogAxis, LinearJog, LinearJogAxis,
    MouseMove, MoveJoints, MoveTo, MovingMode, PlaybackAdjustment, Voice, WriteVector,
};

fn connect(peer: &InProcess) -> Connection {
    Connection::over_peer(peer.clone(), Some(Dialect::SPECIFICATION))
}

fn found(peer: &InProcess) -> Position {
    let arm = peer.arm();
    arm.controller().pose_at(arm.now()).position
}

#[track_caller]
fn assert_at(found: Position, x_mm: f64, y_mm: f64, z_mm: f64, tolerance_mm: f64) {
    let apart_mm = found.distance(Position::new(x_mm, y_mm, z_mm)).0;
    assert!(
        apart_mm <= tolerance_mm,
        "the arm is at {found:?}, {apart_mm} mm from {x_mm}, {y_mm}, {z_mm}; tolerance {tolerance_mm}"
    );
}

#[tokio::test]
async fn every_way_to_move_ends_at_its_target_and_the_status_says_so() {
    for mode in [MovingMode::Jump, MovingMode::MovJ, MovingMode::MovL] {
        let peer = in_process();
        let mut arm = connect(&peer);
        let events = run(&mut arm, &[move_to(mode, 220.0, -60.0, 30.0).into()]).await;
        assert_eq!(completed(&events), [0], "{mode:?}: {events:?}");
        let status = arm.session().status().expect("one came");
        let told = Position::new(status.x_mm.into(), status.y_mm.into(), status.z_mm.into());
        assert_at(told, 220.0, -60.0, 30.0, 1e-3);
        assert_at(found(&peer), 220.0, -60.0, 30.0, 1e-6);
        assert_eq!(refusals(&peer), []);
    }
}

#[tokio::test]
async fn a_target_in_joint_angles_ends_at_these_angles() {
    let peer = in_process();
    let mut arm = connect(&peer);
    let target = MoveJoints {
        base_deg: 25.0,
        rear_deg: 20.0,
        fore_deg: 30.0,
        servo_deg: -10.0,
        suction: true,
        mode: MovingMode::MovJ,
        gripper_deg: 15.0,
        pause_s: 0.0,
    };
    let events = run(&mut arm, &[target.into()]).await;
    assert_eq!(completed(&events), [0], "{events:?}");
    let status = arm.next_status().await.expect("another one comes");
    let angles = [
        status.base_deg,
        status.rear_deg,
        status.fore_deg,
        status.servo_deg,
        status.gripper_deg,
    ];
    assert_eq!(angles, [25.0, 20.0, 30.0, -10.0, 15.0]);
    assert!(status.suction);
}

#[tokio::test]
async fn a_mixed_program_is_over_command_by_command_in_order() {
    let peer = in_process();
    let mut arm = connect(&peer);
    let program: Vec<Command> = vec![
        playback(100.0).into(),
        move_to(MovingMode::MovL, 220.0, 0.0, 10.0).into(),
        Configuration::Writing {
            acceleration_mm_s2: 200.0,
        }
        .into(),
        vector(0.0, 20.0, 20.0).into(),
        vector(20.0, 0.0, 20.0).into(),
        vector(0.0, -20.0, 20.0).into(),
        button(JointJogAxis::SuctionOn, 0.0).into(),
        move_to(MovingMode::Jump, 200.0, 30.0, 0.0).into(),
        move_to(MovingMode::MovJ, 240.0, -30.0, 0.0).into(),
        vector(-10.0, 0.0, 10.0).into(),
    ];
    let events = run(&mut arm, &program).await;
    assert_eq!(completed(&events), (0..10).collect::<Vec<_>>());
    assert_eq!(refusals(&peer), []);
    assert_at(found(&peer), 230.0, -30.0, 0.0, 1e-6);
    let counters = *peer.arm().controller().counters();
    assert_eq!((counters.packets, counters.begun), (10, 10));
    assert_eq!((counters.skipped_bytes, counters.refused), (0, 0));
}

#[tokio::test]
async fn a_target_out_of_reach_is_told_with_the_place_where_the_arm_rests() {
    let peer = in_process();
    let mut arm = connect(&peer);
    let far = move_to(MovingMode::MovL, 400.0, 0.0, 0.0);
    let events = run(&mut arm, &[far.into()]).await;
    let Some(Event::NotReached {
        command,
        expected,
        found,
        ..
    }) = events.last()
    else {
        panic!("{events:?}");
    };
    assert_eq!(*command, CommandId(0));
    assert_at(*expected, 400.0, 0.0, 0.0, 0.0);
    assert_at(*found, POWER_UP_X_MM, 0.0, -17.677_669_5, 1e-3);
    assert!(matches!(
        refusals(&peer)[..],
        [Refused::Course(CourseError::Unreachable(_))]
    ));
}

#[tokio::test]
async fn two_targets_out_of_reach_are_both_told() {
    let peer = in_process();
    let mut arm = connect(&peer);
    let mut short = Vec::new();
    for x_mm in [400.0, 500.0] {
        arm.send(move_to(MovingMode::MovJ, x_mm, 0.0, 0.0))
            .expect("it is allowed");
    }
    while short.len() < 2 {
        match arm.next_event().await.expect("the link is open") {
            Event::NotReached {
                command, expected, ..
            } => short.push((command.0, expected.x.0)),
            Event::Completed(id) => panic!("{id:?} leads nowhere"),
            _ => {}
        }
    }
    assert_eq!(short, [(0, 400.0), (1, 500.0)]);
}

#[tokio::test]
async fn a_full_queue_of_slow_moves_and_long_pauses_is_no_lost_link() {
    let peer = in_process();
    let mut arm = connect(&peer);
    // At half of 0.5 mm/s, 40 mm take 160 s.
    let mut program: Vec<Command> = vec![playback(0.5).into()];
    let modes = [MovingMode::MovL, MovingMode::MovJ, MovingMode::Jump];
    for n in 0..9_u8 {
        let y_mm = if n % 2 == 0 { 20.0 } else { -20.0 };
        program.push(
            MoveTo {
                pause_s: 60.0,
                ..move_to(modes[usize::from(n % 3)], 230.0, y_mm, 0.0)
            }
            .into(),
        );
    }
    let events = run(&mut arm, &program).await;
    assert_eq!(
        completed(&events),
        (0..10).collect::<Vec<_>>(),
        "{events:?}"
    );
    assert_eq!(refusals(&peer), []);
    assert!(
        peer.now() > Duration::from_secs(9 * 60 + 8 * 80),
        "the pauses and the ways were taken: {:?}",
        peer.now()
    );
}

#[tokio::test]
async fn a_program_with_pauses_is_told_to_be_over_when_its_last_pause_is() {
    let peer = in_process();
    let mut arm = connect(&peer);
    let mut program: Vec<Command> = Vec::new();
    for n in 0..8_u8 {
        let y_mm = if n % 2 == 0 { 10.0 } else { -10.0 };
        program.push(
            MoveTo {
                pause_s: 60.0,
                ..move_to(MovingMode::MovJ, 230.0, y_mm, 0.0)
            }
            .into(),
        );
    }
    run(&mut arm, &program).await;
    let since = peer.now().saturating_sub(Duration::from_mins(8));
    assert!(since < Duration::from_secs(15), "{since:?} of moves");
}

#[tokio::test]
async fn a_default_pause_is_no_arm_that_fell_short() {
    let peer = in_process();
    let mut arm = connect(&peer);
    let slow = Configuration::Playback {
        joint_speed_deg_s: 100.0,
        joint_acceleration_deg_s2: 100.0,
        servo_speed_deg_s: 100.0,
        servo_acceleration_deg_s2: 100.0,
        linear_speed_mm_s: 100.0,
        linear_acceleration_mm_s2: 100.0,
        default_pause_s: 5.0,
        jump_height_mm: 10.0,
    };
    let program = [
        slow.into(),
        move_to(MovingMode::MovL, 230.0, 0.0, 0.0).into(),
        move_to(MovingMode::MovJ, 230.0, 20.0, 0.0).into(),
    ];
    let events = run(&mut arm, &program).await;
    assert_eq!(completed(&events), [0, 1, 2], "{events:?}");
    assert!(peer.now() > Duration::from_secs(10), "{:?}", peer.now());
}

/// The speed in mm/s between each two samples, and when.
fn speeds(samples: &[Sample]) -> Vec<(Duration, f64)> {
    samples
        .windows(2)
        .map(|it| {
            let way_mm = it[0].position.distance(it[1].position).0;
            let time = it[1].at.saturating_sub(it[0].at);
            (it[1].at, way_mm / time.as_secs_f64())
        })
        .collect()
}

#[tokio::test]
async fn the_pen_never_stops_between_vectors_that_last_as_long_as_a_status_period() {
    let peer = in_process();
    peer.arm().record(ms(5));
    let mut arm = connect(&peer);
    let start = move_to(MovingMode::MovL, 220.0, -75.0, 0.0);
    run(&mut arm, &[start.into()]).await;
    let begun = peer.now();
    // 30 mm/s for 84 ms are 2.52 mm. The first and the last one speed up and slow down.
    let mut program: Vec<Command> = vec![
        WriteVector {
            start_speed_mm_s: 0.0,
            ..vector(0.0, 10.0, 30.0)
        }
        .into(),
    ];
    program.extend((0..50).map(|_| Command::from(vector(0.0, 2.52, 30.0))));
    program.push(
        WriteVector {
            end_speed_mm_s: 0.0,
            ..vector(0.0, 10.0, 30.0)
        }
        .into(),
    );
    let events = run(&mut arm, &program).await;
    assert_eq!(completed(&events).len(), 52);
    assert_eq!(refusals(&peer), []);
    let arm = peer.arm();
    let between = |sample: &&Sample| {
        sample.at > begun && (-65.0..=-65.0 + 126.0).contains(&sample.position.y.0)
    };
    let drawn: Vec<Sample> = arm.samples().iter().filter(between).copied().collect();
    assert!(drawn.len() > 800, "{} samples", drawn.len());
    for (at, speed_mm_s) in speeds(&drawn) {
        assert!((speed_mm_s - 30.0).abs() < 0.01, "{speed_mm_s} at {at:?}");
    }
}

#[tokio::test]
async fn a_status_takes_43_68_ms_and_the_next_one_comes_80_ms_later() {
    let mut peer = in_process();
    let mut bytes = Vec::new();
    assert!(peer.receive(Duration::MAX, &mut bytes));
    // Some of its bytes came before the last one: what counts is when it is whole.
    while bytes.len() < 42 {
        assert!(peer.receive(Duration::MAX, &mut bytes));
    }
    assert_eq!(peer.now(), ms(60) + Duration::from_micros(43_680));
    while bytes.len() < 84 {
        assert!(peer.receive(Duration::MAX, &mut bytes));
    }
    assert_eq!(peer.now(), ms(140) + Duration::from_micros(43_680));
}

/// When an arm to which a jog is sent at `sent` is first seen to have begun it.
fn begins_at(sent: Duration) -> Duration {
    let mut arm = virtual_arm();
    let jog: Command = button(JointJogAxis::BasePlus, 100.0).into();
    let bytes = jog.emit(&Dialect::SPECIFICATION).to_bytes();
    arm.handle_bytes(sent, &bytes);
    while arm.controller().counters().begun == 0 {
        let next = arm.poll_wakeup();
        arm.handle_time(next);
        arm.poll_bytes(&mut Vec::new());
    }
    arm.now()
}

#[test]
fn a_command_acts_in_the_first_tick_after_it_has_arrived_whole() {
    let travel = Duration::from_micros(43_680);
    let arrives = ms(100).saturating_sub(travel);
    let just_in_time = arrives.saturating_sub(Duration::from_nanos(1));
    assert_eq!(begins_at(just_in_time), ms(100));
    assert_eq!(begins_at(arrives), ms(120), "a tick has no ears");
    assert_eq!(begins_at(ms(0)), ms(60));
}

#[test]
fn a_packet_torn_by_the_clock_is_the_same_packet() {
    let jog: Command = button(JointJogAxis::BasePlus, 100.0).into();
    let bytes = jog.emit(&Dialect::SPECIFICATION).to_bytes();
    let mut arm = virtual_arm();
    for (n, byte) in (0_u64..).zip(bytes) {
        arm.handle_bytes(ms(7 * n), &[byte]);
    }
    arm.handle_time(ms(1000));
    let counters = arm.controller().counters();
    assert_eq!((counters.packets, counters.begun), (1, 1));
}

async fn recorded(program: &[Command]) -> Vec<Sample> {
    let peer = in_process();
    peer.arm().record(ms(5));
    run(&mut connect(&peer), program).await;
    peer.arm().samples().to_vec()
}

#[tokio::test]
async fn the_same_program_twice_draws_the_same_samples_bit_by_bit() {
    let program: Vec<Command> = vec![
        move_to(MovingMode::MovJ, 230.0, 12.3, 4.5).into(),
        vector(1.1, 20.7, 33.3).into(),
        vector(-13.7, 2.9, 17.1).into(),
        move_to(MovingMode::Jump, 201.0, 30.0, 0.0).into(),
    ];
    let [first, second] = [recorded(&program).await, recorded(&program).await];
    assert!(first.len() > 100, "{} samples", first.len());
    let bits = |samples: &[Sample]| -> Vec<_> {
        let bits = |it: &Sample| {
            let Position { x, y, z } = it.position;
            (it.at, [x, y, z].map(|it| it.0.to_bits()), it.laser)
        };
        samples.iter().map(bits).collect()
    };
    assert_eq!(bits(&first), bits(&second));
}

#[tokio::test]
async fn a_released_jog_is_over_when_the_arm_stands() {
    let peer = in_process();
    let mut arm = connect(&peer);
    let jog = button(JointJogAxis::BasePlus, 100.0);
    let released = button(JointJogAxis::Released, 0.0);
    let slow = Configuration::Teach {
        joint_speed_deg_s: 20.0,
        joint_acceleration_deg_s2: 10.0,
        servo_speed_deg_s: 30.0,
        servo_acceleration_deg_s2: 10.0,
        linear_speed_mm_s: 40.0,
        linear_acceleration_mm_s2: 10.0,
    };
    let mut program: Vec<Command> = vec![slow.into()];
    program.extend([Command::from(jog); 12]);
    program.push(released.into());
    let events = run(&mut arm, &program).await;
    assert_eq!(completed(&events).len(), 14, "{events:?}");
    let rest = found(&peer);
    for _ in 0..20 {
        arm.next_status().await.expect("the link is open");
    }
    assert_eq!(found(&peer), rest);
    let events = run(&mut arm, &[vector(5.0, 5.0, 20.0).into()]).await;
    assert_eq!(completed(&events), [14], "{events:?}");
    assert_at(found(&peer), rest.x.0 + 5.0, rest.y.0 + 5.0, rest.z.0, 1e-6);
}

mod programs {
    //! Random programs within reach, against a model of where they lead.

    use dobot_arm::{Joints, Limits, Pose, Tool, forward};
    use proptest::prelude::*;

    use super::*;

    /// One step, with where it leads in numbers of its own.
    #[derive(Clone, Debug)]
    enum Step {
        Go {
            to: Place,
            mode: MovingMode,
            pause_s: f32,
        },
        Turn {
            to: Place,
            mode: MovingMode,
        },
        Write {
            to: Place,
            max_mm_s: f32,
            shares: (f32, f32),
        },
        Mouse {
            to: Place,
        },
        Voice,
        Jog {
            axis: LinearJogAxis,
            packets: usize,
            percent: f32,
        },
        Press(JointJogAxis),
        Speeds {
            speed: f32,
            default_pause_s: f32,
        },
        Adjust(f32, f32),
        WriteAcceleration(f32),
        Tool(EndEffector),
        Calibrate {
            rear_deg: f32,
            fore_deg: f32,
            then: Place,
        },
    }

    /// A place from where all others are within reach on a straight line.
    #[derive(Clone, Copy, Debug)]
    struct Place {
        base_deg: f64,
        reach_mm: f64,
        z_mm: f64,
        rotation_deg: f32,
    }

    impl Place {
        fn position(self) -> Position {
            Position::polar(
                dobot_arm::Millimeters(self.reach_mm),
                dobot_arm::Degrees(self.base_deg),
                dobot_arm::Millimeters(self.z_mm),
            )
        }
    }

    fn place() -> impl Strategy<Value = Place> {
        (-30.0..30.0, 205.0..285.0, -40.0..25.0, -20.0..20.0_f32).prop_map(
            |(base_deg, reach_mm, z_mm, rotation_deg)| Place {
                base_deg,
                reach_mm,
                z_mm,
                rotation_deg,
            },
        )
    }

    fn mode() -> impl Strategy<Value = MovingMode> {
        prop_oneof![
            Just(MovingMode::Jump),
            Just(MovingMode::MovJ),
            Just(MovingMode::MovL)
        ]
    }

    fn step() -> impl Strategy<Value = Step> {
        let axis = prop_oneof![
            Just(LinearJogAxis::YPlus),
            Just(LinearJogAxis::YMinus),
            Just(LinearJogAxis::ZPlus),
            Just(LinearJogAxis::ZMinus),
        ];
        let tool = prop_oneof![
            Just(EndEffector::SuctionCup),
            Just(EndEffector::Gripper),
            Just(EndEffector::Laser)
        ];
        prop_oneof![
            6 => (place(), mode(), prop_oneof![Just(0.0), 0.0..2.0_f32])
                .prop_map(|(to, mode, pause_s)| Step::Go { to, mode, pause_s }),
            2 => (place(), mode()).prop_map(|(to, mode)| Step::Turn { to, mode }),
            10 => (place(), 5.0..100.0_f32, (0.0..1.0_f32, 0.0..1.0_f32))
                .prop_map(|(to, max_mm_s, shares)| Step::Write { to, max_mm_s, shares }),
            1 => place().prop_map(|to| Step::Mouse { to }),
            1 => Just(Step::Voice),
            2 => (axis, 1..6_usize, 1.0..30.0_f32)
                .prop_map(|(axis, packets, percent)| Step::Jog { axis, packets, percent }),
            1 => prop_oneof![Just(JointJogAxis::SuctionOn), Just(JointJogAxis::LaserOff)]
                .prop_map(Step::Press),
            1 => (20.0..300.0_f32, prop_oneof![Just(0.0), 0.0..3.0_f32])
                .prop_map(|(speed, default_pause_s)| Step::Speeds { speed, default_pause_s }),
            1 => (10.0..100.0_f32, 10.0..100.0_f32).prop_map(|(a, b)| Step::Adjust(a, b)),
            1 => (20.0..500.0_f32).prop_map(Step::WriteAcceleration),
            1 => tool.prop_map(Step::Tool),
            1 => (32.0..48.0_f32, 35.0..55.0_f32, place())
                .prop_map(|(rear_deg, fore_deg, then)| Step::Calibrate { rear_deg, fore_deg, then }),
        ]
    }

    /// Where the arm is according to the commands alone.
    struct Model {
        pose: Pose,
        tool: Tool,
    }

    impl Model {
        fn joints(&self) -> Joints {
            dobot_arm::inverse(&self.pose, self.tool).expect("it is within reach")
        }

        /// The packets of a step; the model goes where they lead.
        fn take(&mut self, step: &Step) -> Vec<Command> {
            match *step {
                Step::Go { to, mode, pause_s } => {
                    let Position { x, y, z } = to.position();
                    let command = MoveTo {
                        rotation_deg: to.rotation_deg,
                        pause_s,
                        ..move_to(mode, single(x.0), single(y.0), single(z.0))
                    };
                    self.pose = Pose {
                        position: Position::new(
                            command.x_mm.into(),
                            command.y_mm.into(),
                            command.z_mm.into(),
                        ),
                        rotation: dobot_arm::Degrees(to.rotation_deg.into()),
                    };
                    vec![command.into()]
                }
                Step::Turn { to, mode } => vec![self.turn(to, mode)],
                Step::Write {
                    to,
                    max_mm_s,
                    shares,
                } => self.write(to, max_mm_s, shares),
                Step::Mouse { to } => {
                    let by = to.position() - self.pose.position;
                    let command = MouseMove {
                        x: single(by.x.0),
                        y: single(by.y.0),
                        z: single(by.z.0),
                        rotation_deg: to.rotation_deg,
                        suction: false,
                    };
                    self.shift(command.x, command.y, command.z);
                    self.pose.rotation = dobot_arm::Degrees(to.rotation_deg.into());
                    vec![command.into()]
                }
                Step::Voice => {
                    let up = self.pose.position.z.0 < 0.0;
                    self.shift(0.0, 0.0, if up { 15.0 } else { -15.0 });
                    let text = if up { "up fifteen" } else { "down fifteen" };
                    vec![Command::Voice(Voice::new(text).expect("it is short"))]
                }
                Step::Jog {
                    axis,
                    packets,
                    percent,
                } => {
                    let jog = LinearJog {
                        axis,
                        speed_percent: percent,
                    };
                    let mut commands = vec![Command::from(jog); packets];
                    commands.push(button(JointJogAxis::Released, 0.0).into());
                    commands
                }
                Step::Calibrate {
                    rear_deg,
                    fore_deg,
                    then,
                } => {
                    let servo_deg = self.joints().servo.0;
                    let joints = Joints::new(0.0, rear_deg.into(), fore_deg.into(), servo_deg);
                    self.pose = forward(&joints, self.tool);
                    let command = Configuration::InitialAngles { rear_deg, fore_deg };
                    vec![command.into(), self.turn(then, MovingMode::MovJ)]
                }
                _ => vec![self.set(step)],
            }
        }

        fn turn(&mut self, to: Place, mode: MovingMode) -> Command {
            let pose = Pose {
                position: to.position(),
                rotation: dobot_arm::Degrees(to.rotation_deg.into()),
            };
            let joints = Limits::STOCK.solve(&pose, self.tool).expect("in reach");
            let [base_deg, rear_deg, fore_deg, servo_deg] =
                [joints.base, joints.rear, joints.fore, joints.servo].map(|it| single(it.0));
            let rounded = [base_deg, rear_deg, fore_deg, servo_deg].map(f64::from);
            let [base, rear, fore, servo] = rounded;
            self.pose = forward(&Joints::new(base, rear, fore, servo), self.tool);
            Command::from(MoveJoints {
                base_deg,
                rear_deg,
                fore_deg,
                servo_deg,
                suction: false,
                mode,
                gripper_deg: 0.0,
                pause_s: 0.0,
            })
        }

        fn write(&mut self, to: Place, max_mm_s: f32, shares: (f32, f32)) -> Vec<Command> {
            let by = to.position() - self.pose.position;
            if by.length().0 < 0.01 {
                return Vec::new();
            }
            let command = WriteVector {
                z_mm: single(by.z.0),
                start_speed_mm_s: max_mm_s * shares.0,
                end_speed_mm_s: max_mm_s * shares.1,
                ..vector(single(by.x.0), single(by.y.0), max_mm_s)
            };
            self.shift(command.x_mm, command.y_mm, command.z_mm);
            vec![command.into()]
        }

        /// A step without motion.
        fn set(&mut self, step: &Step) -> Command {
            match *step {
                Step::Press(axis) => button(axis, 0.0).into(),
                Step::Adjust(speed_percent, acceleration_percent) => PlaybackAdjustment {
                    speed_percent,
                    acceleration_percent,
                    teach_speed_percent: 100.0,
                }
                .into(),
                Step::WriteAcceleration(acceleration_mm_s2) => {
                    Configuration::Writing { acceleration_mm_s2 }.into()
                }
                Step::Tool(tool) => {
                    let joints = self.joints();
                    self.tool = match tool {
                        EndEffector::SuctionCup => Tool::SuctionCup,
                        EndEffector::Gripper => Tool::Gripper,
                        EndEffector::Laser => Tool::Laser,
                    };
                    self.pose = forward(&joints, self.tool);
                    Configuration::EndEffector { tool }.into()
                }
                Step::Speeds {
                    speed,
                    default_pause_s,
                } => Configuration::Playback {
                    joint_speed_deg_s: speed,
                    joint_acceleration_deg_s2: speed,
                    servo_speed_deg_s: speed,
                    servo_acceleration_deg_s2: speed,
                    linear_speed_mm_s: speed,
                    linear_acceleration_mm_s2: speed,
                    default_pause_s,
                    jump_height_mm: 15.0,
                }
                .into(),
                _ => unreachable!("the other steps move"),
            }
        }

        fn shift(&mut self, x_mm: f32, y_mm: f32, z_mm: f32) {
            let by = Position::new(x_mm.into(), y_mm.into(), z_mm.into());
            self.pose.position = self.pose.position + by;
        }
    }

    #[expect(
        clippy::cast_possible_truncation,
        reason = "the wire is single precision"
    )]
    fn single(number: f64) -> f32 {
        number as f32
    }

    /// Runs a program in one go from each jog to the next: where a jog ends, only the arm knows.
    async fn check(steps: &[Step]) {
        let peer = in_process();
        let mut arm = connect(&peer);
        let mut model = Model {
            pose: peer.arm().controller().pose_at(Duration::ZERO),
            tool: Tool::SuctionCup,
        };
        let mut sent = 0;
        for stretch in steps.split_inclusive(|step| matches!(step, Step::Jog { .. })) {
            let commands: Vec<Command> = stretch.iter().flat_map(|it| model.take(it)).collect();
            if commands.is_empty() {
                continue;
            }
            let events = run_with(&mut arm, &commands, |event| {
                if let Event::Completed(CommandId(id)) = event {
                    let begun = peer.arm().controller().counters().begun;
                    assert!(*id < begun, "{id} is told to be over before it was begun");
                }
            })
            .await;
            assert_eq!(refusals(&peer), []);
            let ids = sent..sent + commands.len() as u64;
            assert_eq!(completed(&events), ids.collect::<Vec<_>>(), "{events:?}");
            sent += commands.len() as u64;
            let counters = *peer.arm().controller().counters();
            assert_eq!((counters.packets, counters.begun), (sent, sent));
            if let Some(Step::Jog { .. }) = stretch.last() {
                let now = peer.now();
                model.pose = peer.arm().controller().pose_at(now);
                arm.next_status().await.expect("the link is open");
                let now = peer.now();
                assert_eq!(peer.arm().controller().pose_at(now), model.pose, "it rests");
            } else {
                let Position { x, y, z } = model.pose.position;
                assert_at(found(&peer), x.0, y.0, z.0, 1e-3);
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(500))]

        #[test]
        fn every_program_within_reach_is_over_in_order_and_where_it_leads(
            steps in prop::collection::vec(step(), 1..25)
        ) {
            let runtime = tokio::runtime::Builder::new_current_thread()
                .build()
                .expect("it needs nothing");
            runtime.block_on(check(&steps));
        }
    }
}
