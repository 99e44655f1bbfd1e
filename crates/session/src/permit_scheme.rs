//! Which statuses permit a command. The two ports of a stock arm differ in this (notes N20 and N38).

use std::time::Duration;

use dobot_arm::Tool;
use dobot_motion::ArmPlace;
use dobot_wire::{Frame, Status};

/// Detects from the statuses which port of the arm is connected, and which of them permit a command
/// (notes N20 and N38).
#[derive(Clone, Copy, Debug, Default)]
pub struct PermitScheme {
    port: Option<ServedPort>,
    /// When the last status arrived that was not a message.
    plain: Option<Duration>,
}

/// The port in use. The arm does not report it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ServedPort {
    /// A status every 80 ms, each of which permits a command.
    Usb,
    /// Three statuses in 160 ms: a message, a permit 40 ms later, a message 40 ms later. The messages
    /// alone have the period of the statuses over USB.
    Bluetooth,
}

/// A status and its role on this port.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ReceivedStatus {
    /// The status, with the 1000 mm of a message removed from X.
    pub status: Status,
    /// Whether it belongs to the 80 ms sequence that all timing relies on.
    pub is_regular: bool,
    /// Whether it permits a command.
    pub permits: bool,
}

impl PermitScheme {
    /// Classifies a status as received.
    pub fn classify(&mut self, now: Duration, status: Status) -> ReceivedStatus {
        if let Some(message) = status.message() {
            self.port = Some(ServedPort::Bluetooth);
            return ReceivedStatus {
                status: with_pose(message),
                is_regular: true,
                permits: false,
            };
        }
        let before = self.plain.replace(now);
        if self.port.is_none() && before.is_some_and(|at| now.saturating_sub(at) < TWO_IN_A_ROW) {
            self.port = Some(ServedPort::Usb);
        }
        ReceivedStatus {
            status,
            is_regular: !self.is_bluetooth(),
            permits: true,
        }
    }

    /// Whether the port is known. A single status may be the permit of either port.
    pub(crate) const fn is_known(&self) -> bool {
        self.port.is_some()
    }

    /// Whether it is the Bluetooth port of a stock arm.
    #[must_use]
    pub fn is_bluetooth(&self) -> bool {
        self.port == Some(ServedPort::Bluetooth)
    }
}

/// Returns whether a frame can be a status: its position agrees with its angles (note N22), with or
/// without the 1000 mm that a message adds to X (note N38).
#[must_use]
pub fn plausible(frame: &Frame) -> bool {
    let float = |n| f64::from(frame.float(n));
    let [x, y, z] = [1, 2, 3].map(float);
    let agrees = |x| dobot_arm::agrees([x, y, z], float(4), [5, 6, 7, 8].map(float));
    agrees(x) || agrees(x - MESSAGE_MM) || [x, y, z, float(4)] == FIRST_POSE
}

/// Completes the first message after power-up: it has angles, but 0 for the pose.
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
