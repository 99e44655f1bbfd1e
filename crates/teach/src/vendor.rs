//! Files of the vendor's software: points and speeds.
//!
//! Files come from many machines: deviations with a clear meaning are accepted with a warning.

mod joint_points;
mod params;
mod play;
mod playback;
mod points;
mod text;
mod xml;

use dobot_wire::MovingMode;

pub use self::params::{JogParams, Params, PlaybackParams};
pub use self::text::decode;
use crate::program::{Go, Here};
use crate::{Action, Files, Point, Program, ProgramError};

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

/// Parses a `.playback` file of the vendor's later software, whose points are positions.
///
/// # Errors
///
/// [`ProgramError`] with the line: not XML, another root element, a point without a coordinate, a
/// value that is not allowed, such as the path of an arc.
pub fn read_playback(bytes: &[u8]) -> Result<Read<Program>, ProgramError> {
    playback::read(bytes)
}

/// Returns the points of a program, with the joint angles of its positions, and what the formats
/// cannot express, with its line. `files` provides the called programs and the drawings.
///
/// # Errors
///
/// [`ProgramError`] for a program that cannot be compiled, and with all steps whose position is out
/// of reach.
pub fn points_of(
    program: &Program,
    files: &mut dyn Files,
) -> Result<(Vec<VendorPoint>, Vec<String>), ProgramError> {
    joint_points::read(program, files)
}

fn bad(line: impl Into<Option<usize>>, reason: impl Into<String>) -> ProgramError {
    ProgramError::at(line, reason)
}
