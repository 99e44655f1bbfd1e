//! Random programs within reach, against a model of where they lead.

use dobot_arm::{Joints, Limits, Pose, Tool, forward};
use dobot_wire::single;
use proptest::prelude::*;

use super::*;

/// One step, with where it leads in numbers of its own.
#[derive(Clone, Debug)]
enum Step {
    Go {
        to: SafePlace,
        mode: MovingMode,
        pause_s: f32,
    },
    Turn {
        to: SafePlace,
        mode: MovingMode,
    },
    Write {
        to: SafePlace,
        max_mm_s: f32,
        shares: (f32, f32),
    },
    Mouse {
        to: SafePlace,
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
        then: SafePlace,
    },
}

/// A place from where all others are within reach on a straight line.
#[derive(Clone, Copy, Debug)]
struct SafePlace {
    base_deg: f64,
    reach_mm: f64,
    z_mm: f64,
    rotation_deg: f32,
}

impl SafePlace {
    fn position(self) -> Position {
        Position::polar(
            dobot_arm::Millimeters(self.reach_mm),
            dobot_arm::Degrees(self.base_deg),
            dobot_arm::Millimeters(self.z_mm),
        )
    }
}

fn place() -> impl Strategy<Value = SafePlace> {
    (-30.0..30.0, 205.0..285.0, -40.0..25.0, -20.0..20.0_f32).prop_map(
        |(base_deg, reach_mm, z_mm, rotation_deg)| SafePlace {
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
    let tool = prop::sample::select(Tool::END_EFFECTORS.to_vec()).prop_map(EndEffector::from);
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
                let jog = LinearJog::new(axis, percent);
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

    fn turn(&mut self, to: SafePlace, mode: MovingMode) -> Command {
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
        Command::from(MoveJoints::to([base_deg, rear_deg, fore_deg, servo_deg]).with_mode(mode))
    }

    fn write(&mut self, to: SafePlace, max_mm_s: f32, shares: (f32, f32)) -> Vec<Command> {
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
                self.tool = tool.into();
                self.pose = forward(&joints, self.tool);
                Configuration::EndEffector { tool }.into()
            }
            Step::Speeds {
                speed,
                default_pause_s,
            } => Configuration::playback(
                [speed, speed, speed, speed, speed, speed],
                default_pause_s,
                15.0,
            )
            .into(),
            _ => unreachable!("the other steps move"),
        }
    }

    fn shift(&mut self, x_mm: f32, y_mm: f32, z_mm: f32) {
        let by = Position::new(x_mm.into(), y_mm.into(), z_mm.into());
        self.pose.position = self.pose.position + by;
    }
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
                assert!(
                    *id < begun,
                    "{id} is reported as completed before it was begun"
                );
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
