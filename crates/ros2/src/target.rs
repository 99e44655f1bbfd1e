//! Conversion of a pose to a target of the arm.

use dobot_host::{Target, TargetPlace};
use dobot_wire::{MovingMode, single};

use crate::frames::Frames;
use crate::messages::{PoseStamped, Quaternion};

/// Returns the target for a pose of the frame `tool`, with a joint path (MOVJ).
///
/// # Errors
///
/// The problem, and what is allowed.
pub(crate) fn target(wanted: &PoseStamped, frames: &Frames) -> Result<Target, String> {
    frames.check_base(&wanted.header)?;
    let at = &wanted.pose.position;
    let mm = [("x", at.x), ("y", at.y), ("z", at.z)].map(|(name, m)| coordinate(name, m));
    let [x, y, z] = mm;
    Ok(Target {
        place: TargetPlace::Point {
            mm: [x?, y?, z?],
            rotation_deg: Some(single(yaw_deg(&wanted.pose.orientation)?)),
        },
        servo_deg: None,
        mode: MovingMode::MovJ,
        suction: None,
        gripper_deg: None,
        pause_s: 0.0,
    })
}

fn coordinate(name: &str, metres: f64) -> Result<f32, String> {
    if metres.abs() <= FARTHEST_M {
        return Ok(single(metres * 1000.0));
    }
    Err(format!(
        "pose.position.{name} is {metres}; allowed are metres in the base frame, up to {FARTHEST_M}"
    ))
}

/// Returns the rotation of a quaternion about Z, in degrees; the arm keeps its tool level.
fn yaw_deg(turn: &Quaternion) -> Result<f64, String> {
    let Quaternion { x, y, z, w } = *turn;
    let length = (x * x + y * y + z * z + w * w).sqrt();
    if !(1.0 - TOLERANCE..=1.0 + TOLERANCE).contains(&length) {
        return Err(format!(
            "pose.orientation has the length {length}; allowed is a unit quaternion, as x 0, y 0, z 0, w 1"
        ));
    }
    if x.abs() > TOLERANCE || y.abs() > TOLERANCE {
        return Err(format!(
            "pose.orientation tilts the tool (x {x}, y {y}); allowed are rotations about z: the arm keeps its tool level"
        ));
    }
    let half = z.atan2(w).to_degrees();
    // Normalised to the shorter rotation.
    Ok((2.0 * half + 180.0).rem_euclid(360.0) - 180.0)
}

const TOLERANCE: f64 = 0.01;
/// Beyond the reach of any arm of this kind; nearer positions are checked by the station.
const FARTHEST_M: f64 = 10.0;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;
    use crate::messages::{Header, Pose, Vector3};

    fn pose([x, y, z]: [f64; 3], turn: [f64; 4]) -> PoseStamped {
        let position = Vector3 { x, y, z };
        let [x, y, z, w] = turn;
        PoseStamped {
            header: Header::now("base"),
            pose: Pose {
                position,
                orientation: Quaternion { x, y, z, w },
            },
        }
    }

    fn refused(wanted: &PoseStamped) -> String {
        target(wanted, &Frames::new("/")).unwrap_err()
    }

    #[test]
    fn metres_become_millimetres_and_a_quarter_turn_ninety_degrees() {
        let half = std::f64::consts::FRAC_1_SQRT_2;
        let wanted = pose([0.22, -0.03, 0.05], [0.0, 0.0, half, half]);
        let found = target(&wanted, &Frames::new("/")).expect("it is allowed");
        let TargetPlace::Point { mm, rotation_deg } = found.place else {
            panic!("{found:?}");
        };
        for (found, expected) in mm.iter().zip([220.0, -30.0, 50.0]) {
            assert!((found - expected).abs() < 1e-3, "{found}, not {expected}");
        }
        let turned = rotation_deg.expect("it is given");
        assert!((turned - 90.0).abs() < 1e-3, "{turned}");
    }

    #[test]
    fn a_turn_and_its_opposite_quaternion_are_the_same() {
        for sign in [1.0, -1.0] {
            let (sin, cos) = (-20_f64.to_radians()).sin_cos();
            let turn = Quaternion {
                x: 0.0,
                y: 0.0,
                z: sign * sin,
                w: sign * cos,
            };
            let found = yaw_deg(&turn).expect("it is allowed");
            assert!((found + 40.0).abs() < 1e-9, "{found}");
        }
    }

    #[test]
    fn a_tilted_tool_an_invalid_rotation_and_an_invalid_place_are_refused_by_name() {
        let half = std::f64::consts::FRAC_1_SQRT_2;
        let level = [0.0, 0.0, 0.0, 1.0];
        for (wanted, expected) in [
            (pose([0.2, 0.0, 0.0], [0.0, half, 0.0, half]), "tilts"),
            (pose([0.2, 0.0, 0.0], [0.0; 4]), "unit quaternion"),
            (
                pose([0.2, 0.0, 0.0], [f64::NAN, 0.0, 0.0, 1.0]),
                "unit quaternion",
            ),
            (pose([0.2, f64::NAN, 0.0], level), "pose.position.y"),
            (pose([0.2, 0.0, f64::INFINITY], level), "pose.position.z"),
            (pose([220.0, 0.0, 0.0], level), "metres"),
        ] {
            let found = refused(&wanted);
            assert!(found.contains(expected), "{found}");
        }
    }
}
