//! The four actuated joints, with the names of the model (`docs/models.md`).

use dobot_arm::Joints;
use dobot_wire::Status;

use crate::messages::{Header, JointState};

/// The joints, in the order of a status.
pub(crate) const JOINTS: [&str; 4] = ["base", "rear", "fore", "servo"];

/// Returns the angles of a status.
pub(crate) fn joints_of(status: &Status) -> Joints {
    let [base, rear, fore, servo] = degrees_of(status);
    Joints::new(base, rear, fore, servo)
}

/// Returns the angles of a status, in degrees, in the order of [`JOINTS`].
pub(crate) fn degrees_of(status: &Status) -> [f64; 4] {
    [
        status.base_deg,
        status.rear_deg,
        status.fore_deg,
        status.servo_deg,
    ]
    .map(f64::from)
}

/// Returns the message for `joint_states`: mimic joints are left to readers of the description,
/// such as `robot_state_publisher`.
pub(crate) fn joint_state(status: &Status) -> JointState {
    JointState {
        header: Header::now(""),
        name: JOINTS.map(str::to_owned).to_vec(),
        position: degrees_of(status).map(f64::to_radians).to_vec(),
        velocity: Vec::new(),
        effort: Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_are_radians_in_the_order_of_their_names() {
        let status = Status {
            base_deg: 90.0,
            rear_deg: 45.0,
            fore_deg: -9.0,
            servo_deg: 0.0,
            ..Status::AT_ZERO
        };
        let state = joint_state(&status);
        assert_eq!(state.name, ["base", "rear", "fore", "servo"]);
        let quarter = std::f64::consts::FRAC_PI_2;
        let expected = [quarter, quarter / 2.0, -quarter / 10.0, 0.0];
        for (found, expected) in state.position.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-12, "{found}, not {expected}");
        }
    }
}
