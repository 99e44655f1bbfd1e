//! Geometry for the detection of ended commands.

use dobot_arm::{Degrees, Limits, Position, Tool};
use dobot_motion::ArmPlace;
use dobot_wire::Status;

/// Whether the arm is within one tick of motion of a limit.
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

/// Returns the distance of a point from a line and its position along it, in millimetres.
pub(super) fn beside(from: Position, to: Position, point: Position) -> (f64, f64) {
    let length_mm = from.distance(to).0;
    if length_mm == 0.0 {
        return (point.distance(from).0, 0.0);
    }
    let (line, part) = (to - from, point - from);
    let dot = line.x.0 * part.x.0 + line.y.0 * part.y.0 + line.z.0 * part.z.0;
    let along_mm = (dot / length_mm).clamp(0.0, length_mm);
    let foot = from + line * (along_mm / length_mm);
    (point.distance(foot).0, along_mm)
}

/// The motion of one tick at the power-up speeds of a stock arm, in degrees.
const NEAR_DEG: f64 = 2.0;
