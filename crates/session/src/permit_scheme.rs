//! Which statuses permit a command: the two ports of a stock arm have a permit scheme each (notes N20 and
//! N38).

use std::time::Duration;

use dobot_arm::Tool;
use dobot_motion::ArmPlace;
use dobot_wire::{Frame, Status};

/// Tells by the statuses which port of the arm this is.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct PermitScheme {
    port: Option<ServedPort>,
    /// When the last status came that was no message.
    plain: Option<Duration>,
}

/// The port that an arm serves, which it does not say.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ServedPort {
    /// A status every 80 ms, each of which permits a command.
    Usb,
    /// Three statuses in 160 ms: a message, a permit 40 ms later, a message 40 ms later. So the
    /// messages alone come as often as the statuses over USB.
    Bluetooth,
}

/// What a status is good for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ReceivedStatus {
    /// With the true X.
    pub(crate) status: Status,
    /// Whether it is one of those that come every 80 ms, by which all that waits is measured.
    pub(crate) tells: bool,
    /// Whether it permits a command.
    pub(crate) permits: bool,
}

impl PermitScheme {
    /// Takes a status as it came.
    pub(crate) fn take(&mut self, now: Duration, status: Status) -> ReceivedStatus {
        if let Some(message) = status.message() {
            self.port = Some(ServedPort::Bluetooth);
            return ReceivedStatus {
                status: with_pose(message),
                tells: true,
                permits: false,
            };
        }
        let before = self.plain.replace(now);
        if self.port.is_none() && before.is_some_and(|it| now.saturating_sub(it) < TWO_IN_A_ROW) {
            self.port = Some(ServedPort::Usb);
        }
        ReceivedStatus {
            status,
            tells: !self.is_bluetooth(),
            permits: true,
        }
    }

    /// Whether the port is known: one status may be the permit of either.
    pub(crate) const fn is_known(&self) -> bool {
        self.port.is_some()
    }

    pub(crate) fn is_bluetooth(&self) -> bool {
        self.port == Some(ServedPort::Bluetooth)
    }
}

/// Whether a frame can be a status: its position agrees with its angles (note N22), the 1000 mm of a
/// message taken off (note N38).
#[must_use]
pub fn plausible(frame: &Frame) -> bool {
    let float = |n| f64::from(frame.float(n));
    let [x, y, z] = [1, 2, 3].map(float);
    let agrees = |x| dobot_arm::agrees([x, y, z], float(4), [5, 6, 7, 8].map(float));
    agrees(x) || agrees(x - MESSAGE_MM) || [x, y, z, float(4)] == FIRST_POSE
}

/// The very first message has angles, and 0 for the pose, which follows from them.
fn with_pose(message: Status) -> Status {
    let pose = [message.x_mm, message.y_mm, message.z_mm];
    if pose != [0.0; 3] {
        return message;
    }
    let joints = ArmPlace::of_status(&message).joints;
    Status {
        suction: message.suction,
        gripper_deg: message.gripper_deg,
        ..ArmPlace::at_joints(joints, Tool::SuctionCup).status()
    }
}

/// Less than the time between two permits over Bluetooth, and more than a period over USB.
const TWO_IN_A_ROW: Duration = Duration::from_millis(120);
const MESSAGE_MM: f64 = 1000.0;
const FIRST_POSE: [f64; 4] = [MESSAGE_MM, 0.0, 0.0, 0.0];
