//! What a detection sends: small slow motions near the arm, whose end no dialect doubts but that of
//! the one vector, and which is led back.

use dobot_wire::{
    Command, Configuration, Dialect, Frame, MoveTo, Packet, PlaybackAdjustment, Status, WriteVector,
};

/// A packet, and what is asked by it.
#[derive(Clone, Copy, Debug)]
pub(super) struct DetectionStep {
    pub(super) frame: Frame,
    pub(super) question: Option<Question>,
    pub(super) moves: bool,
}

/// What the dialects disagree about, and a motion shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Question {
    /// Which of the moving modes 1 and 2 is straight?
    Modes,
    /// Which float of state 10 is the speed?
    Percentages,
    /// Which way does X of a vector go?
    WriteX,
}

impl Question {
    pub(super) const ALL: [Self; 3] = [Self::Modes, Self::Percentages, Self::WriteX];

    pub(super) const fn words(self) -> &'static str {
        match self {
            Self::Modes => "which of the moving modes 1 and 2 is straight (note N2)",
            Self::Percentages => "which percentage of state 10 is the speed (note N3)",
            Self::WriteX => "which way X of a write vector goes (note N4)",
        }
    }
}

/// All of it, from where the arm stands and back there.
pub(super) fn steps(start: &Status) -> Vec<DetectionStep> {
    let home = [start.x_mm, start.y_mm, start.z_mm + LIFT_MM];
    let aside = [home[0] - 6.0, home[1] + 12.0, home[2] + 4.0];
    let start_point = [start.x_mm, start.y_mm, start.z_mm];
    let ask = |question, frame| DetectionStep {
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
        ask(Question::Modes, to(1.0, aside)),
        ask(Question::Modes, to(1.0, home)),
        ask(Question::Modes, to(2.0, aside)),
        ask(Question::Modes, to(2.0, home)),
        set(playback(UNEVEN)),
        set_frame(adjustment(10.0, 100.0)),
        ask(Question::Percentages, to(1.0, aside)),
        set(playback(GENTLE)),
        set(percentages(50.0, 50.0)),
        go(to(1.0, home)),
        ask(Question::WriteX, vector(2.0)),
        ask(Question::WriteX, vector(-2.0)),
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

/// A command that means the same in all dialects.
fn set(command: impl Into<Command>) -> DetectionStep {
    let command = command.into();
    debug_assert_eq!(command.dialect_dependent(), None);
    set_frame(frame(&command))
}

/// A point by moving mode 1 or 2, whichever is which.
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

/// The percentages of state 10 by the number of their float.
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
        Packet::Voice(_) => unreachable!("nothing is said here"),
    }
}

/// So slow that a dozen statuses tell of each way; and no joint reaches its largest speed, because
/// a stock arm then strays from the way of all joints together.
const GENTLE: [f32; 4] = [200.0, 20.0, 200.0, 60.0];
/// A tenth of the speed takes 1.6 s for the way aside, a tenth of the acceleration 2.5 s.
const UNEVEN: [f32; 4] = [30.0, 30.0, 100.0, 100.0];
/// What a stock arm knows at power-up.
const STOCK: [f32; 4] = [200.0, 200.0, 100.0, 200.0];
/// A pen is lifted off the paper before anything else moves.
const LIFT_MM: f32 = 6.0;
