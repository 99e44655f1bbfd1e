//! The geometry that completion asks for.

use dobot_arm::{Degrees, Limits, Position, Tool};
use dobot_motion::ArmPlace;
use dobot_wire::Status;

/// Whether an arm stands so near to a limit that a tick's way further would be beyond it.
pub(super) fn is_at_limit(status: &Status, tool: Tool) -> bool {
    let joints = ArmPlace::of_status(status).joints;
    [NEAR_DEG, -NEAR_DEG].into_iter().any(|by| {
        let mut turned = [joints; 4];
        turned[0].base += Degrees(by);
        turned[1].rear += Degrees(by);
        turned[2].fore += Degrees(by);
        turned[3].servo += Degrees(by);
        turned
            .iter()
            .any(|joints| Limits::STOCK.check(joints, tool).is_err())
    })
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

/// A tick's way at the speeds of a stock arm at power-up.
const NEAR_DEG: f64 = 2.0;
