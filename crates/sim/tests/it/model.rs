//! The motion model against the controllers: where does a chain of commands end, and when?

use std::time::Duration;

use dobot_arm::{Position, TICK, Tool};
use dobot_controller::{Controller, Personality, PowerUp};
use dobot_motion::{Model, TrajectoryError};
use dobot_wire::{
    Command, Configuration, MoveTo, MovingMode, PlaybackAdjustment, Status, WriteMode, WriteVector,
};
use proptest::prelude::*;

/// What a chain of commands comes to on an arm: where it rests, and when its last motion began to
/// rest.
struct TestArm {
    controller: Controller,
    now: Duration,
}

impl TestArm {
    fn power_up(personality: Personality) -> Self {
        let power_up = PowerUp::new(personality);
        Self {
            controller: Controller::power_up(power_up),
            now: Duration::ZERO,
        }
    }

    fn wait(&mut self, until: Duration) -> Option<Status> {
        let mut last = None;
        while self.now < until {
            self.now = (self.now + TICK).min(until);
            self.controller.handle_time(self.now);
            while let Some(upload) = self.controller.poll_bytes() {
                last = dobot_wire::Frame::from_bytes(&upload.bytes)
                    .and_then(|frame| Status::parse(&frame).ok())
                    .or(last);
            }
        }
        last
    }

    /// Gives a command, and returns how long the arm moved for it.
    fn obey(&mut self, command: &Command, personality: Personality) -> Duration {
        let from = self.now;
        let packet = command.emit(&personality.dialect());
        self.controller.handle_bytes(self.now, &packet.to_bytes());
        let mut moved = from;
        let mut at = self.controller.pose_at(self.now).position;
        for _ in 0..MAX_TICKS {
            self.wait(self.now + TICK);
            let found = self.controller.pose_at(self.now).position;
            if found.distance(at).0 > 1e-4 {
                moved = self.now;
            } else if self.now > moved + Duration::from_millis(300) {
                break;
            }
            at = found;
        }
        moved.saturating_sub(from)
    }
}

fn command() -> impl Strategy<Value = Command> {
    let mode = prop_oneof![
        Just(MovingMode::Jump),
        Just(MovingMode::MovL),
        Just(MovingMode::MovJ)
    ];
    let point = [200.0..260.0_f32, -60.0..60.0_f32, -20.0..60.0_f32];
    let target = (mode, point, -20.0..20.0_f32).prop_map(|(mode, [x_mm, y_mm, z_mm], turn)| {
        Command::from(MoveTo {
            rotation_deg: turn,
            mode,
            ..MoveTo::to(x_mm, y_mm, z_mm)
        })
    });
    let vector = (-20.0..20.0_f32, 5.0..20.0_f32, 20.0..60.0_f32)
        .prop_map(|(x_mm, y_mm, max)| Command::from(WriteVector::by(x_mm, y_mm, 0.0, max)));
    let percent = (30.0..100.0_f32, 30.0..100.0_f32).prop_map(|(speed, acceleration)| {
        Command::from(PlaybackAdjustment {
            speed_percent: speed,
            acceleration_percent: acceleration,
            teach_speed_percent: 50.0,
        })
    });
    let tool = prop_oneof![Just(Tool::SuctionCup), Just(Tool::Laser)]
        .prop_map(|tool| Command::from(Configuration::EndEffector { tool: tool.into() }));
    prop_oneof![4 => target, 3 => vector, 1 => percent, 1 => tool]
}

fn apart_mm(a: Position, b: Position) -> f64 {
    a.distance(b).0
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Both controllers end where the model says, in the time that it says: the stock one to a few
    /// ticks for the motions that it rounds, and to its single precision.
    #[test]
    fn a_chain_of_commands_ends_where_and_when_the_model_says(
        stock in any::<bool>(),
        commands in prop::collection::vec(command(), 1..8),
    ) {
        let personality = if stock { Personality::Firmware11 } else { Personality::Specification };
        let mut lab = TestArm::power_up(personality);
        let status = lab.wait(Duration::from_millis(100)).expect("a status arrived");
        let mut model = Model::new(personality.dialect(), &status);
        for command in commands {
            let Ok(trajectory) = model.trajectory(&command) else { continue };
            if trajectory.check().is_err() {
                continue;
            }
            let expected_s = trajectory.lasts_s().expect("it ends");
            let took_s = lab.obey(&command, personality).as_secs_f64();
            let late_s = took_s - expected_s;
            prop_assert!(
                (-0.05..=LATE_S).contains(&late_s),
                "{command:?} took {took_s} s; {expected_s} s were expected"
            );
            model = model.after(&command, &trajectory);
            let found = lab.controller.pose_at(lab.now).position;
            let off_mm = apart_mm(found, model.place.pose.position);
            prop_assert!(off_mm < 0.05, "{command:?} ended {off_mm} mm off at {found:?}");
        }
    }
}

/// A stock arm that begins slowly, and for which it counts no tick that accelerates, goes on as slowly:
/// ten times longer than any drawing of the motion says (note N48).
#[test]
fn a_vector_that_creeps_takes_as_long_as_the_model_says() {
    let personality = Personality::Firmware11;
    let mut longer_s = 0.0_f64;
    for tenths in 100..400_u16 {
        let speed_mm_s = f32::from(tenths) / 10.0;
        let mut lab = TestArm::power_up(personality);
        let status = lab
            .wait(Duration::from_millis(100))
            .expect("a status arrived");
        let mut model = Model::new(personality.dialect(), &status);
        for [y_mm, z_mm] in [[0.0, 8.0], [2.1, 0.0], [0.0, -8.0], [-2.1, 0.0]] {
            let command = Command::from(WriteVector::by(0.0, y_mm, z_mm, speed_mm_s));
            let trajectory = model.trajectory(&command).expect("it is in reach");
            let expected_s = trajectory.lasts_s().expect("it ends");
            let took_s = lab.obey(&command, personality).as_secs_f64();
            assert!(
                (-0.05..=LATE_S).contains(&(took_s - expected_s)),
                "{command:?} took {took_s} s; {expected_s} s were expected"
            );
            longer_s = longer_s.max(expected_s - trajectory.motion_s().expect("it ends"));
            model = model.after(&command, &trajectory);
        }
    }
    assert!(longer_s > 0.3, "none of them crept: {longer_s}");
}

/// The model refuses a vector of laser mode without the laser that the twin cuts short, and no
/// other (note N48).
#[test]
fn a_rapid_vector_is_refused_where_the_twin_ends_it_early() {
    let personality = Personality::Firmware11;
    for (max_speed_mm_s, arrives) in [(50.0, false), (95.0, false), (105.0, true), (150.0, true)] {
        let mut lab = TestArm::power_up(personality);
        let status = lab
            .wait(Duration::from_millis(100))
            .expect("a status arrived");
        let model = Model::new(personality.dialect(), &status);
        let rapid = Command::from(WriteVector {
            mode: WriteMode::Laser,
            ..WriteVector::by(0.0, 40.0, 0.0, max_speed_mm_s)
        });
        lab.obey(&rapid, personality);
        let y_mm = lab.controller.pose_at(lab.now).position.y.0;
        assert_eq!(
            (y_mm - 40.0).abs() < 0.1,
            arrives,
            "{max_speed_mm_s}: {y_mm}"
        );
        let refused = matches!(
            model.trajectory(&rapid),
            Err(TrajectoryError::SlowRapid { .. })
        );
        assert_eq!(refused, !arrives, "{max_speed_mm_s} mm/s");
    }
}

/// Behind a burn that left some speed a laser vector without the laser arrives, and so the model
/// lets it, however slow it is (note N48).
#[test]
fn a_rapid_vector_behind_a_burn_arrives_and_is_not_refused() {
    let personality = Personality::Firmware11;
    let vector = |y_mm: f32, laser: bool, speed: f32| WriteVector {
        mode: WriteMode::Laser,
        laser,
        end_speed_mm_s: speed,
        ..WriteVector::by(0.0, y_mm, 0.0, speed)
    };
    for speed in [1.0, 1.5, 2.0, 5.0, 8.0, 10.0, 20.0, 50.0] {
        let mut lab = TestArm::power_up(personality);
        let status = lab
            .wait(Duration::from_millis(100))
            .expect("a status arrived");
        let mut model = Model::new(personality.dialect(), &status);
        for command in [vector(40.0, true, speed), vector(7.3, false, speed)].map(Command::from) {
            let trajectory = model.trajectory(&command).expect("it is allowed");
            model = model.after(&command, &trajectory);
            lab.obey(&command, personality);
        }
        let y_mm = lab.controller.pose_at(lab.now).position.y.0;
        assert!((y_mm - 47.3).abs() < 0.01, "{speed} mm/s: {y_mm}");
    }
}

/// A minute and more.
const MAX_TICKS: u32 = 5000;
/// Until it is taken, and a tick for each of the three parts of a JUMP and for its rounding.
const LATE_S: f64 = 0.12;
