//! The `PlayBackPoints.xml` format.

use std::fmt::Write;

use dobot_wire::MovingMode;
use roxmltree::Node;

use super::text::decode;
use super::xml::{Fields, MAX_NUMBER, document, line, root, unknown};
use super::{Read, VendorPoint, bad};
use crate::ProgramError;
use crate::step_table::MAX_PAUSE_S;

pub(super) fn read(bytes: &[u8]) -> Result<Read<Vec<VendorPoint>>, ProgramError> {
    let (text, warning) = decode(bytes);
    let mut warnings: Vec<String> = warning.into_iter().collect();
    let document = document(&text)?;
    let root = root(&document, ROOT, &mut warnings)?;
    let mut points = Vec::new();
    for node in root.children().filter(Node::is_element) {
        if node.tag_name().name() == "point" {
            let mut fields = Fields::new(node, &mut warnings);
            points.push(point(&mut fields)?);
        } else {
            warnings.push(unknown(node));
        }
    }
    if points.is_empty() {
        return Err(bad(
            line(root),
            "the file has no points; it needs at least one <point>",
        ));
    }
    Ok(Read {
        content: points,
        warnings,
    })
}

pub(super) fn write(points: &[VendorPoint]) -> String {
    let mut text = format!("<?xml version='1.0' encoding='UTF-8'?>\n<{ROOT}>\n");
    for point in points {
        let [base, rear, fore, servo] = point.joints_deg;
        let style = style(point.mode);
        let lines = [
            ("motionStyle", style.to_owned()),
            ("isGrab", point.grab.to_string()),
            ("x", base.to_string()),
            ("y", rear.to_string()),
            ("z", fore.to_string()),
            ("rHead", servo.to_string()),
            ("gripper", point.gripper_deg.to_string()),
            ("pauseTime", point.pause_s.to_string()),
        ];
        text.push_str("    <point>\n");
        for (name, value) in lines {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "        <{name}>{value}</{name}>");
        }
        text.push_str("    </point>\n");
    }
    let _ = writeln!(text, "</{ROOT}>");
    text
}

fn point(fields: &mut Fields<'_, '_>) -> Result<VendorPoint, ProgramError> {
    let joints_deg = [
        fields.required("x")?,
        fields.required("y")?,
        fields.required("z")?,
        fields.number("rHead", -MAX_NUMBER, MAX_NUMBER)?,
    ];
    Ok(VendorPoint {
        mode: path(fields)?,
        grab: grab(fields)?,
        joints_deg,
        gripper_deg: fields.number("gripper", -90.0, 90.0)?,
        pause_s: fields.number("pauseTime", 0.0, MAX_PAUSE_S)?,
    })
}

fn path(fields: &mut Fields<'_, '_>) -> Result<MovingMode, ProgramError> {
    let Some((text, line)) = fields.text("motionStyle", "JUMP") else {
        return Ok(MovingMode::Jump);
    };
    mode(text).ok_or_else(|| {
        bad(
            line,
            format!("<motionStyle> is {text:?}; allowed are JUMP, MOVL and MOVJ"),
        )
    })
}

fn grab(fields: &mut Fields<'_, '_>) -> Result<bool, ProgramError> {
    let Some((text, line)) = fields.text("isGrab", "false") else {
        return Ok(false);
    };
    match text.to_ascii_lowercase().as_str() {
        "true" | "1" => Ok(true),
        "false" | "0" => Ok(false),
        _ => Err(bad(
            line,
            format!("<isGrab> is {text:?}; allowed are true and false"),
        )),
    }
}

/// The path type that a word names.
pub(super) fn mode(word: &str) -> Option<MovingMode> {
    let modes = [MovingMode::Jump, MovingMode::MovL, MovingMode::MovJ];
    modes
        .into_iter()
        .find(|mode| style(*mode).eq_ignore_ascii_case(word))
}

pub(super) const fn style(mode: MovingMode) -> &'static str {
    match mode {
        MovingMode::Jump => "JUMP",
        MovingMode::MovL => "MOVL",
        MovingMode::MovJ => "MOVJ",
    }
}

const ROOT: &str = "playBack";
