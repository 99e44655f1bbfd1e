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
pub(crate) fn joint_state(status: &Status, velocities_deg_s: [f64; 4]) -> JointState {
    JointState {
        header: Header::now(""),
        name: JOINTS.map(str::to_owned).to_vec(),
        position: degrees_of(status).map(f64::to_radians).to_vec(),
        velocity: velocities_deg_s.map(f64::to_radians).to_vec(),
        effort: Vec::new(),
    }
}

/// The velocities of the joints, from one status to the next.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Velocities {
    /// The time of the last status in seconds, and its angles.
    last: Option<(f64, [f64; 4])>,
    deg_s: [f64; 4],
}

impl Velocities {
    /// Returns the velocities at a status, in degrees/s: 0 at the first one. The time is in seconds
    /// since the station started; the station may repeat a status.
    pub(crate) fn at(&mut self, at_s: f64, degrees: [f64; 4]) -> [f64; 4] {
        match self.last {
            Some((last_s, last)) if at_s > last_s => {
                if at_s - last_s < REPEATED_S {
                    return self.deg_s;
                }
                self.deg_s =
                    std::array::from_fn(|joint| (degrees[joint] - last[joint]) / (at_s - last_s));
            }
            // The first one, or that of a restarted station.
            _ => self.deg_s = [0.0; 4],
        }
        self.last = Some((at_s, degrees));
        self.deg_s
    }
}

/// Statuses are 80 ms apart.
const REPEATED_S: f64 = 0.04;

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
        let state = joint_state(&status, [90.0, 0.0, 0.0, 0.0]);
        assert_eq!(state.name, ["base", "rear", "fore", "servo"]);
        let quarter = std::f64::consts::FRAC_PI_2;
        let expected = [quarter, quarter / 2.0, -quarter / 10.0, 0.0];
        for (found, expected) in state.position.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-12, "{found}, not {expected}");
        }
        assert!((state.velocity[0] - quarter).abs() < 1e-12, "{state:?}");
    }

    #[test]
    fn velocities_are_those_between_statuses_and_a_repeated_status_does_not_change_them() {
        let mut velocities = Velocities::default();
        let at = |base: f64| [base, 0.0, 0.0, 0.0];
        let near = |found: [f64; 4], expected: f64| {
            assert!(
                (found[0] - expected).abs() < 1e-9,
                "{found:?}, not {expected}"
            );
        };
        near(velocities.at(5.0, at(10.0)), 0.0);
        // 2 degrees in 80 ms.
        near(velocities.at(5.08, at(12.0)), 25.0);
        near(velocities.at(5.09, at(12.0)), 25.0);
        near(velocities.at(5.16, at(11.0)), -12.5);
        near(velocities.at(5.24, at(11.0)), 0.0);
        // A restarted station counts from 0 again.
        near(velocities.at(0.5, at(80.0)), 0.0);
    }
}
