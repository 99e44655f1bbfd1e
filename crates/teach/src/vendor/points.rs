//! The `PlayBackPoints.xml` format.

use std::fmt::Write;

use dobot_wire::MovingMode;
use roxmltree::{Document, Node, ParsingOptions};

use super::text::{decode, number};
use super::{Read, VendorPoint, bad};
use crate::ProgramError;
use crate::number::within;
use crate::step_table::MAX_PAUSE_S;

pub(super) fn read(bytes: &[u8]) -> Result<Read<Vec<VendorPoint>>, ProgramError> {
    let (text, warning) = decode(bytes);
    let mut warnings: Vec<String> = warning.into_iter().collect();
    // Without entities there are no entity bombs.
    let options = ParsingOptions {
        allow_dtd: false,
        ..ParsingOptions::default()
    };
    let document = Document::parse_with_options(text.trim_start(), options).map_err(|error| {
        let line = usize::try_from(error.pos().row).ok();
        bad(line, format!("not well-formed XML: {}", problem(&error)))
    })?;
    let root = document.root_element();
    let name = root.tag_name().name();
    if !name.eq_ignore_ascii_case(ROOT) {
        return Err(bad(
            line(root),
            format!("the outermost element is <{name}>; it must be <{ROOT}>"),
        ));
    }
    if name != ROOT {
        warnings.push(format!(
            "line {}: the outermost element is <{name}>; read as <{ROOT}>",
            line(root)
        ));
    }
    let mut points = Vec::new();
    for node in root.children().filter(Node::is_element) {
        if node.tag_name().name() == "point" {
            points.push(
                Reader {
                    node,
                    warnings: &mut warnings,
                }
                .point()?,
            );
        } else {
            let name = node.tag_name().name();
            warnings.push(format!(
                "line {}: <{name}> is unknown; left out",
                line(node)
            ));
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
    for it in points {
        let [base, rear, fore, servo] = it.joints_deg;
        let style = style(it.mode);
        let lines = [
            ("motionStyle", style.to_owned()),
            ("isGrab", it.grab.to_string()),
            ("x", base.to_string()),
            ("y", rear.to_string()),
            ("z", fore.to_string()),
            ("rHead", servo.to_string()),
            ("gripper", it.gripper_deg.to_string()),
            ("pauseTime", it.pause_s.to_string()),
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

struct Reader<'a, 'input> {
    node: Node<'a, 'input>,
    warnings: &'a mut Vec<String>,
}

impl<'a> Reader<'a, '_> {
    fn point(&mut self) -> Result<VendorPoint, ProgramError> {
        let joints_deg = [
            self.angle("x")?,
            self.angle("y")?,
            self.angle("z")?,
            self.number("rHead", -1e6, 1e6)?,
        ];
        Ok(VendorPoint {
            mode: self.mode()?,
            grab: self.grab()?,
            joints_deg,
            gripper_deg: self.number("gripper", -90.0, 90.0)?,
            pause_s: self.number("pauseTime", 0.0, MAX_PAUSE_S)?,
        })
    }

    /// The text of a field and its line; `None`, with a warning, if it is missing.
    fn field(&mut self, name: &str, otherwise: &str) -> Option<(&'a str, usize)> {
        let found = self
            .node
            .children()
            .find(|child| child.tag_name().name() == name);
        let text = found
            .and_then(|found| Some((found.text()?.trim(), line(found))))
            .filter(|found| !found.0.is_empty());
        if text.is_none() {
            let line = line(self.node);
            self.warnings.push(format!(
                "line {line}: the point has no <{name}>; read as {otherwise}"
            ));
        }
        text
    }

    /// A required angle.
    fn angle(&mut self, name: &str) -> Result<f64, ProgramError> {
        if !self
            .node
            .children()
            .any(|child| child.tag_name().name() == name)
        {
            return Err(bad(
                line(self.node),
                format!("the point has no <{name}>; x, y and z are required"),
            ));
        }
        self.number(name, -1e6, 1e6)
    }

    fn number(&mut self, name: &str, least: f64, most: f64) -> Result<f64, ProgramError> {
        let Some((text, line)) = self.field(name, "0") else {
            return Ok(0.0);
        };
        let (value, is_comma) = number(text)
            .ok_or_else(|| bad(line, format!("<{name}> is {text:?}; expected a number")))?;
        if is_comma {
            self.warnings.push(format!(
                "line {line}: <{name}> is {text:?}; the comma is read as a point"
            ));
        }
        within(&format!("<{name}>"), "", value, least, most).map_err(|reason| bad(line, reason))
    }

    fn mode(&mut self) -> Result<MovingMode, ProgramError> {
        let Some((text, line)) = self.field("motionStyle", "JUMP") else {
            return Ok(MovingMode::Jump);
        };
        mode(text).ok_or_else(|| {
            bad(
                line,
                format!("<motionStyle> is {text:?}; allowed are JUMP, MOVL and MOVJ"),
            )
        })
    }

    fn grab(&mut self) -> Result<bool, ProgramError> {
        let Some((text, line)) = self.field("isGrab", "false") else {
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

/// What the XML parser reports, without the position that it appends.
fn problem(error: &roxmltree::Error) -> String {
    let message = error.to_string();
    let problem = message
        .rsplit_once(" at ")
        .map_or(&*message, |parts| parts.0);
    problem.replace('\'', "`")
}

fn line(node: Node<'_, '_>) -> usize {
    let at = node.document().text_pos_at(node.range().start);
    usize::try_from(at.row).unwrap_or(usize::MAX)
}

const ROOT: &str = "playBack";
