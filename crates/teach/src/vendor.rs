//! Files of the vendor's software: points and speeds.
//!
//! Files come from many machines: deviations with a clear meaning are accepted with a warning.

mod params;
mod play;
mod points;
mod text;

use dobot_wire::MovingMode;

pub use self::params::{JogParams, PlaybackParams};
pub use self::text::decode;
use crate::program::{Go, Here};
use crate::{Action, Place, Point, Program, ProgramError};

/// A point of the vendor's software: joint angles and the state of the tool.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VendorPoint {
    /// Base, rear arm, forearm and servo, in degrees.
    pub joints_deg: [f64; 4],
    /// The path type.
    pub mode: MovingMode,
    /// Whether the pump runs from here on.
    pub grab: bool,
    /// The gripper's angle from here on, in degrees.
    pub gripper_deg: f64,
    /// The pause, in seconds.
    pub pause_s: f64,
}

/// The content of a file and the warnings about it, with lines.
#[derive(Clone, Debug, PartialEq)]
pub struct Read<T> {
    /// The content.
    pub content: T,
    /// Deviations from the vendor's format that were accepted.
    pub warnings: Vec<String>,
}

/// Parses a `PlayBackPoints.xml`.
///
/// # Errors
///
/// [`ProgramError`] with the line: not XML, another root element, a point without an angle, a value
/// that is not allowed, or a document that declares entities.
pub fn read_points(bytes: &[u8]) -> Result<Read<Vec<VendorPoint>>, ProgramError> {
    points::read(bytes)
}

/// Writes a `PlayBackPoints.xml`.
#[must_use]
pub fn write_points(points: &[VendorPoint]) -> String {
    points::write(points)
}

/// Parses a `.play` file of the vendor's later software.
///
/// # Errors
///
/// [`ProgramError`] with the line: fields that are missing or not allowed.
pub fn read_play(bytes: &[u8]) -> Result<Read<Vec<VendorPoint>>, ProgramError> {
    play::read(bytes)
}

/// Writes a `.play` file, with angles to a thousandth of a degree.
#[must_use]
pub fn write_play(points: &[VendorPoint]) -> String {
    play::write(points)
}

/// Creates the program that visits points.
#[must_use]
pub fn program_of(points: &[VendorPoint]) -> Program {
    let steps = points.iter().map(|point| {
        Action::Go(Go {
            path: point.mode,
            then: Here {
                suction: Some(point.grab),
                gripper: Some(point.gripper_deg),
                pause: Some(point.pause_s).filter(|point| *point != 0.0),
            },
            ..Go::to(Point::Joints(point.joints_deg))
        })
    });
    Program::new(steps.collect())
}

/// Returns the points of a program, and the lines that the format cannot express, each with the
/// reason.
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

/// The state after the steps before.
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
            _ => return Err("the format has points only; this step is left out".to_owned()),
        };
        self.grab = then.suction.unwrap_or(self.grab);
        self.gripper_deg = then.gripper.unwrap_or(self.gripper_deg);
        let (joints_deg, mode) = match (at, self.last) {
            (Some(at), _) => at,
            (None, Some(last)) => (last.joints_deg, MovingMode::MovJ),
            (None, None) => {
                return Err("the position of the arm is unknown; this step is left out".to_owned());
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
            "the format has joint angles only, without offsets; this step is left out".to_owned(),
        ),
    }
}

fn bad(line: impl Into<Option<usize>>, reason: impl Into<String>) -> ProgramError {
    ProgramError::at(line, reason)
}
