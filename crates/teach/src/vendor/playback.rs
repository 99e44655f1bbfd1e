//! The `.playback` format of the vendor's later software, which was made for a later arm. The points
//! are positions.
//!
//! The fields of a row are those that three independent readers of such files use: `item_0` the
//! path type (0 JUMP, 1 MOVJ, 2 MOVL), `item_1` a name, `item_2` to `item_5` x, y, z and the rotation
//! of the tool in the base frame, `item_6` to `item_9` the second point of an arc, `item_10` the
//! pause, `item_11` the gripper and `item_12` the suction cup.

use dobot_wire::MovingMode;
use roxmltree::Node;

use super::text::decode;
use super::xml::{Fields, MAX_NUMBER, document, line, root, unknown};
use super::{Read, bad};
use crate::program::{Go, Here};
use crate::step_table::MAX_PAUSE_S;
use crate::{Action, Point, Program, ProgramError};

pub(super) fn read(bytes: &[u8]) -> Result<Read<Program>, ProgramError> {
    let (text, warning) = decode(bytes);
    let mut warnings: Vec<String> = warning.into_iter().collect();
    let document = document(&text)?;
    let root = root(&document, ROOT, &mut warnings)?;
    let mut steps = Vec::new();
    for node in root.children().filter(Node::is_element) {
        match node.tag_name().name() {
            "DobotType" => warnings.push(format!(
                "line {}: the file was made for another arm; check the positions with a dry run first",
                line(node)
            )),
            "row_StudioVersion" => {}
            name if is_row(name) => {
                steps.push(Action::Go(go(&mut Fields::new(node, &mut warnings))?));
            }
            _ => warnings.push(unknown(node)),
        }
    }
    if steps.is_empty() {
        return Err(bad(
            line(root),
            "the file has no points; it needs at least one <row0>",
        ));
    }
    Ok(Read {
        content: Program::new(steps),
        warnings,
    })
}

fn is_row(name: &str) -> bool {
    name.strip_prefix("row")
        .is_some_and(|number| number.parse::<u32>().is_ok())
}

fn go(fields: &mut Fields<'_, '_>) -> Result<Go, ProgramError> {
    let path = path(fields)?;
    let position = [
        fields.required("item_2")?,
        fields.required("item_3")?,
        fields.required("item_4")?,
    ];
    let point = Point::Cartesian {
        position,
        rotation: Some(fields.number("item_5", -MAX_NUMBER, MAX_NUMBER)?),
        frame: None,
    };
    let pause = fields.number("item_10", 0.0, MAX_PAUSE_S)?;
    if fields.find("item_11").is_some_and(|found| found.0 != "0") {
        fields.warn("the gripper of <item_11> is left out; its angle here depends on the gripper");
    }
    Ok(Go {
        path,
        then: Here {
            suction: suction(fields)?,
            gripper: None,
            pause: Some(pause).filter(|pause| *pause != 0.0),
        },
        ..Go::to(point)
    })
}

fn path(fields: &mut Fields<'_, '_>) -> Result<MovingMode, ProgramError> {
    let Some((text, line)) = fields.text("item_0", "0 (JUMP)") else {
        return Ok(MovingMode::Jump);
    };
    match text {
        "0" => Ok(MovingMode::Jump),
        "1" => Ok(MovingMode::MovJ),
        "2" => Ok(MovingMode::MovL),
        _ => Err(bad(
            line,
            format!("<item_0> is {text:?}; allowed are 0 (JUMP), 1 (MOVJ) and 2 (MOVL)"),
        )),
    }
}

fn suction(fields: &Fields<'_, '_>) -> Result<Option<bool>, ProgramError> {
    match fields.find("item_12") {
        None => Ok(None),
        Some(("0", _)) => Ok(Some(false)),
        Some(("1", _)) => Ok(Some(true)),
        Some((text, line)) => Err(bad(
            line,
            format!("<item_12> is {text:?}; allowed are 0 (off) and 1 (on)"),
        )),
    }
}

const ROOT: &str = "root";
