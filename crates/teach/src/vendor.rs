//! Files of the vendor's programs: points and speeds, read and written.
//!
//! They come from many machines: what is missing or written in another way is read where its meaning is clear, with
//! a warning.

mod params;
mod play;
mod points;
mod text;

use dobot_wire::MovingMode;

pub use self::params::{JogParams, PlaybackParams};
pub use self::text::decode;
use crate::program::{Go, Here};
use crate::{Action, Place, Point, Program, ProgramError};

/// A point of the vendor's programs: where to go by joint angles, and what the tool does there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VendorPoint {
    /// Base, rear arm, forearm and servo, in degrees.
    pub joints_deg: [f64; 4],
    /// The way there.
    pub mode: MovingMode,
    /// Whether the pump runs from there on.
    pub grab: bool,
    /// The gripper's angle from there on, in degrees.
    pub gripper_deg: f64,
    /// How long the arm waits there, in seconds.
    pub pause_s: f64,
}

/// What was read, and what was surprising about it, with its line.
#[derive(Clone, Debug, PartialEq)]
pub struct Read<T> {
    /// What was read.
    pub it: T,
    /// What was understood although it is not as the vendor's programs write it.
    pub warnings: Vec<String>,
}

/// Reads a `PlayBackPoints.xml`.
///
/// # Errors
///
/// [`ProgramError`] with the line: no XML, another root, a point without an angle, a value that is not allowed, or
/// a document that declares entities.
pub fn read_points(bytes: &[u8]) -> Result<Read<Vec<VendorPoint>>, ProgramError> {
    points::read(bytes)
}

/// Writes a `PlayBackPoints.xml`.
#[must_use]
pub fn write_points(points: &[VendorPoint]) -> String {
    points::write(points)
}

/// Reads a `.play` file of the later vendor's program.
///
/// # Errors
///
/// [`ProgramError`] with the line: fields that are missing or not allowed.
pub fn read_play(bytes: &[u8]) -> Result<Read<Vec<VendorPoint>>, ProgramError> {
    play::read(bytes)
}

/// Writes a `.play` file. It carries angles to a thousandth of a degree.
#[must_use]
pub fn write_play(points: &[VendorPoint]) -> String {
    play::write(points)
}

/// The program that goes through points.
#[must_use]
pub fn program_of(points: &[VendorPoint]) -> Program {
    let steps = points.iter().map(|it| {
        Action::Go(Go {
            path: it.mode,
            then: Here {
                suction: Some(it.grab),
                gripper: Some(it.gripper_deg),
                pause: Some(it.pause_s).filter(|it| *it != 0.0),
            },
            ..Go::to(Point::Joints(it.joints_deg))
        })
    });
    Program::new(steps.collect())
}

/// The points of a program, and what such a file cannot carry of it: its lines, each with what is lost.
#[must_use]
pub fn points_of(program: &Program) -> (Vec<VendorPoint>, Vec<String>) {
    let mut points: Vec<VendorPoint> = Vec::new();
    let mut lost = Vec::new();
    let mut held = Held::default();
    for step in &program.steps.0 {
        match held.point(program, step.get_ref()) {
            Ok(point) => points.push(point),
            Err(reason) => lost.push(format!("line {}: {reason}", program.line_of(step))),
        }
    }
    if program.start_speed_percent.is_some() {
        lost.push("start_speed_percent: a soft start".to_owned());
    }
    (points, lost)
}

/// What was said so far.
#[derive(Default)]
struct Held {
    grab: bool,
    gripper_deg: f64,
    last: Option<VendorPoint>,
}

impl Held {
    fn point(&mut self, program: &Program, action: &Action) -> Result<VendorPoint, String> {
        let (then, at) = match action {
            Action::Go(go) => (go.then, Some(place(program, go)?)),
            Action::Here(then) => (*then, None),
            _ => return Err("the file knows points alone; this step is left out".to_owned()),
        };
        self.grab = then.suction.unwrap_or(self.grab);
        self.gripper_deg = then.gripper.unwrap_or(self.gripper_deg);
        let (joints_deg, mode) = match (at, self.last) {
            (Some(at), _) => at,
            (None, Some(last)) => (last.joints_deg, MovingMode::MovJ),
            (None, None) => {
                return Err("nothing says where the arm is; this step is left out".to_owned());
            }
        };
        let pause_s = then.pause.unwrap_or(0.0);
        let point = VendorPoint {
            joints_deg,
            mode,
            grab: self.grab,
            gripper_deg: self.gripper_deg,
            pause_s,
        };
        self.last = Some(point);
        Ok(point)
    }
}

/// The joint angles of a step.
fn place(program: &Program, go: &Go) -> Result<([f64; 4], MovingMode), String> {
    let point = match &go.to {
        Place::At(point) => Some(point),
        Place::Named(name) => program.points.get(name),
    };
    match point {
        Some(Point::Joints(joints)) if go.offset == crate::Offset::default() => {
            Ok((*joints, go.path))
        }
        _ => Err(
            "the file knows joint angles alone, without offsets; this step is left out".to_owned(),
        ),
    }
}

fn bad(line: impl Into<Option<usize>>, reason: impl Into<String>) -> ProgramError {
    ProgramError {
        file: None,
        line: line.into(),
        reason: reason.into(),
    }
}
