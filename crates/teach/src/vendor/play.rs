//! The `.play` format, a point per line: `6;;0:Jump;31.800;36.686;18.769;0.000;NO;0;0;` — state,
//! nothing, path type, base, rear, fore, servo, grab, gripper and pause. The last two are 0 in all
//! known samples.

use std::fmt::Write;

use dobot_wire::MovingMode;

use super::points::mode;
use super::text::{decode, number};
use super::{Read, VendorPoint, bad};
use crate::ProgramError;
use crate::number::within;
use crate::step_table::MAX_PAUSE_S;

pub(super) fn read(bytes: &[u8]) -> Result<Read<Vec<VendorPoint>>, ProgramError> {
    let (text, warning) = decode(bytes);
    let mut warnings: Vec<String> = warning.into_iter().collect();
    let mut points = Vec::new();
    for (index, line) in text
        .lines()
        .enumerate()
        .filter(|line| !line.1.trim().is_empty())
    {
        points.push(point(line.trim(), index + 1, &mut warnings)?);
    }
    if points.is_empty() {
        return Err(bad(
            None,
            "the file has no points; it needs at least one line",
        ));
    }
    Ok(Read {
        content: points,
        warnings,
    })
}

fn point(text: &str, line: usize, warnings: &mut Vec<String>) -> Result<VendorPoint, ProgramError> {
    let mut fields: Vec<&str> = text.split(';').map(str::trim).collect();
    // Each field ends with a semicolon.
    if fields.last().is_some_and(|field| field.is_empty()) {
        fields.pop();
    }
    if fields.len() < MIN_FIELDS || fields.len() > FIELDS {
        let found = fields.len();
        return Err(bad(
            line,
            format!(
                "the line has {found} fields; a point has {FIELDS}, and the last two may be missing"
            ),
        ));
    }
    if fields[0] != "6" {
        return Err(bad(
            line,
            format!("the state is {:?}; a point has state 6", fields[0]),
        ));
    }
    if fields.len() < FIELDS {
        warnings.push(format!(
            "line {line}: gripper or pause is missing; read as 0"
        ));
    }
    let mut value = |at: usize, name: &str, least: f64, most: f64| {
        let text = fields.get(at).copied().unwrap_or("0");
        let (value, is_comma) = number(text)
            .ok_or_else(|| bad(line, format!("{name} is {text:?}; expected a number")))?;
        if is_comma {
            warnings.push(format!(
                "line {line}: {name} is {text:?}; the comma is read as a point"
            ));
        }
        within(name, "", value, least, most).map_err(|reason| bad(line, reason))
    };
    let wide = 1e6;
    let joints_deg = [
        value(3, "the base's angle", -wide, wide)?,
        value(4, "the rear arm's angle", -wide, wide)?,
        value(5, "the forearm's angle", -wide, wide)?,
        value(6, "the servo's angle", -wide, wide)?,
    ];
    Ok(VendorPoint {
        joints_deg,
        gripper_deg: value(8, "the gripper's angle", -90.0, 90.0)?,
        pause_s: value(9, "the pause", 0.0, MAX_PAUSE_S)?,
        mode: way(fields[2], line)?,
        grab: grab(fields[7], line)?,
    })
}

/// The path type, as in `0:Jump`: the word decides, because arms number the types differently (note
/// N2).
fn way(text: &str, line: usize) -> Result<MovingMode, ProgramError> {
    let word = text.rsplit(':').next().unwrap_or(text);
    mode(word).ok_or_else(|| {
        bad(
            line,
            format!("the path type is {text:?}; allowed are 0:Jump, 1:Movj and 2:Movl"),
        )
    })
}

fn grab(text: &str, line: usize) -> Result<bool, ProgramError> {
    match text.to_ascii_uppercase().as_str() {
        "YES" => Ok(true),
        "NO" => Ok(false),
        _ => Err(bad(
            line,
            format!("grab is {text:?}; allowed are YES and NO"),
        )),
    }
}

pub(super) fn write(points: &[VendorPoint]) -> String {
    let mut text = String::new();
    for point in points {
        let way = match point.mode {
            MovingMode::Jump => "0:Jump",
            MovingMode::MovJ => "1:Movj",
            MovingMode::MovL => "2:Movl",
        };
        let [base, rear, fore, servo] = point.joints_deg;
        let grab = if point.grab { "YES" } else { "NO" };
        let (gripper, pause) = (point.gripper_deg, point.pause_s);
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "6;;{way};{base:.3};{rear:.3};{fore:.3};{servo:.3};{grab};{gripper};{pause};"
        );
    }
    text
}

const FIELDS: usize = 10;
/// The number of fields without gripper and pause.
const MIN_FIELDS: usize = 8;
