//! The packets of a detection: small slow motions near the arm. Except for the vector, which is
//! undone, they end at the same point in all dialects.

use dobot_wire::{
    Command, Configuration, Dialect, Frame, MoveTo, Packet, PlaybackAdjustment, Status, WriteVector,
};

/// A packet and the question it answers.
#[derive(Clone, Copy, Debug)]
pub(super) struct DetectionStep {
    pub(super) frame: Frame,
    pub(super) question: Option<Question>,
    pub(super) moves: bool,
}

/// A difference between the dialects that a motion shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Question {
    /// Which of the moving modes 1 and 2 is straight?
    Modes,
    /// Which float of state 10 is the speed?
    Percentages,
    /// Which direction is X in a vector?
    WriteX,
}

impl Question {
    pub(super) const ALL: [Self; 3] = [Self::Modes, Self::Percentages, Self::WriteX];

    pub(super) const fn words(self) -> &'static str {
        match self {
            Self::Modes => "which of the moving modes 1 and 2 is straight (note N2)",
            Self::Percentages => "which percentage of state 10 is the speed (note N3)",
            Self::WriteX => "the direction of X in a write vector (note N4)",
        }
    }
}

/// All steps, from the current position and back.
pub(super) fn steps(start: &Status) -> Vec<DetectionStep> {
    let home = [start.x_mm, start.y_mm, start.z_mm + LIFT_MM];
    let aside = [home[0] - 6.0, home[1] + 12.0, home[2] + 4.0];
    let start_point = [start.x_mm, start.y_mm, start.z_mm];
    let measure = |question, frame| DetectionStep {
        question: Some(question),
        ..go(frame)
    };
    let to = |mode, point| target(start, mode, point);
    vec![
        set(playback(GENTLE)),
        set(percentages(50.0, 50.0)),
        set(Configuration::Writing {
            acceleration_mm_s2: 20.0,
        }),
        go(to(1.0, home)),
        measure(Question::Modes, to(1.0, aside)),
        measure(Question::Modes, to(1.0, home)),
        measure(Question::Modes, to(2.0, aside)),
        measure(Question::Modes, to(2.0, home)),
        set(playback(UNEVEN)),
        set_frame(adjustment(10.0, 100.0)),
        measure(Question::Percentages, to(1.0, aside)),
        set(playback(GENTLE)),
        set(percentages(50.0, 50.0)),
        go(to(1.0, home)),
        measure(Question::WriteX, vector(2.0)),
        measure(Question::WriteX, vector(-2.0)),
        go(to(1.0, start_point)),
        set(playback(STOCK)),
        set(Configuration::Writing {
            acceleration_mm_s2: 100.0,
        }),
    ]
}

const fn go(frame: Frame) -> DetectionStep {
    DetectionStep {
        frame,
        question: None,
        moves: true,
    }
}

const fn set_frame(frame: Frame) -> DetectionStep {
    DetectionStep {
        frame,
        question: None,
        moves: false,
    }
}

/// A command that is the same in all dialects.
fn set(command: impl Into<Command>) -> DetectionStep {
    let command = command.into();
    debug_assert_eq!(command.dialect_dependent(), None);
    set_frame(frame(&command))
}

/// A move to a point with moving mode 1 or 2 by number.
fn target(start: &Status, mode: f32, [x_mm, y_mm, z_mm]: [f32; 3]) -> Frame {
    let command = Command::from(MoveTo {
        rotation_deg: start.rotation_deg,
        suction: start.suction,
        gripper_deg: start.gripper_deg,
        ..MoveTo::to(x_mm, y_mm, z_mm)
    });
    frame(&command).with(8, mode)
}

/// A vector of state 4 along its float 3.
fn vector(x_mm: f32) -> Frame {
    frame(&Command::from(WriteVector::by(x_mm, 0.0, 0.0, 5.0)))
}

const fn percentages(speed_percent: f32, acceleration_percent: f32) -> PlaybackAdjustment {
    PlaybackAdjustment {
        speed_percent,
        acceleration_percent,
        teach_speed_percent: 100.0,
    }
}

/// The percentages of state 10 by float number.
fn adjustment(third: f32, fourth: f32) -> Frame {
    frame(&percentages(50.0, 50.0).into())
        .with(3, third)
        .with(4, fourth)
}

/// Speed and acceleration of the joints, and of lines.
const fn playback([joint, joint_2, line, line_2]: [f32; 4]) -> Configuration {
    Configuration::playback([joint, joint_2, 200.0, 200.0, line, line_2], 0.0, 10.0)
}

fn frame(command: &Command) -> Frame {
    match command.emit(&Dialect::SPECIFICATION) {
        Packet::Frame(frame) => frame,
        Packet::Voice(_) => unreachable!("no voice command is sent"),
    }
}

/// Slow enough for a dozen statuses per motion; no joint reaches its maximum speed, because a stock
/// arm then leaves the joint path.
const GENTLE: [f32; 4] = [200.0, 20.0, 200.0, 60.0];
/// The move aside takes 1.6 s at a tenth of the speed, 2.5 s at a tenth of the acceleration.
const UNEVEN: [f32; 4] = [30.0, 30.0, 100.0, 100.0];
/// The power-up settings of a stock arm.
const STOCK: [f32; 4] = [200.0, 200.0, 100.0, 200.0];
/// The initial lift, which takes a pen off the paper.
const LIFT_MM: f32 = 6.0;
