//! The geometry that completion asks for.

use dobot_arm::{Degrees, Joints, Limits, Position, Tool};
use dobot_course::Place;
use dobot_wire::Status;

/// Whether an arm stands so near to a limit that a tick's way further would be beyond it.
pub(super) fn is_at_limit(status: &Status, tool: Tool) -> bool {
    let joints = Place::of_status(status).joints;
    let all = [NEAR_DEG, -NEAR_DEG];
    let turned = |by: f64| {
        let by = Degrees(by);
        [
            Joints {
                base: joints.base + by,
                ..joints
            },
            Joints {
                rear: joints.rear + by,
                ..joints
            },
            Joints {
                fore: joints.fore + by,
                ..joints
            },
            Joints {
                servo: joints.servo + by,
                ..joints
            },
        ]
    };
    all.into_iter()
        .flat_map(turned)
        .any(|joints| Limits::STOCK.check(&joints, tool).is_err())
}

/// How far a point lies aside of a line, and how far along it, in millimetres.
pub(super) fn beside(from: Position, to: Position, point: Position) -> (f64, f64) {
    let length_mm = from.distance(to).0;
    if length_mm == 0.0 {
        return (point.distance(from).0, 0.0);
    }
    let (way, part) = (to - from, point - from);
    let dot = way.x.0 * part.x.0 + way.y.0 * part.y.0 + way.z.0 * part.z.0;
    let along_mm = (dot / length_mm).clamp(0.0, length_mm);
    let foot = from + way * (along_mm / length_mm);
    (point.distance(foot).0, along_mm)
}

/// The same joint angles with another tool: the position moves along the reach.
pub(super) fn retooled(position: Position, before: Tool, after: Tool) -> Position {
    let reach_mm = position.reach().0;
    let factor = (reach_mm + after.reach().0 - before.reach().0) / reach_mm;
    Position {
        x: position.x * factor,
        y: position.y * factor,
        z: position.z,
    }
}

/// A tick's way at the speeds of a stock arm at power-up.
const NEAR_DEG: f64 = 2.0;
