//! Packets that an arm as sold executes although the tables do not allow them.

use dobot_wire::{Command, Dialect, Frame, Leniency, Packet};

/// Whether an arm as sold executes a packet that is not allowed (note N34), without hanging and without
/// losing its pose (note N51).
pub(super) fn takes(packet: &Packet) -> bool {
    let Packet::Frame(mut frame) = *packet else {
        return false;
    };
    if frame.float(1) == SMOOTH_JOINTS {
        return true;
    }
    frame = frame.with(1, frame.float(1).trunc());
    // Each round corrects one float, so that errors after it are also found.
    for _ in 0..10 {
        let Err(error) = Command::parse(&frame.into(), &Dialect::FIRMWARE_1_1) else {
            return true;
        };
        let Some(leniency) = Leniency::of(&frame, &error) else {
            return false;
        };
        frame = leniency.stand_in(&frame, &error, &SOMETHING_IN_FORCE);
    }
    false
}

/// State 15 (note N25).
const SMOOTH_JOINTS: f32 = 15.0;
/// Settings in force that allow all values that an arm as sold accepts.
const SOMETHING_IN_FORCE: Frame = Frame::ZERO
    .with(3, 1.0)
    .with(4, 1.0)
    .with(5, 1.0)
    .with(6, 1.0)
    .with(7, 1.0)
    .with(8, 1.0)
    .with(9, 1.0);

#[cfg(test)]
mod tests {
    use super::*;

    fn takes_floats(floats: [f32; 10]) -> bool {
        let frame = (1..)
            .zip(floats)
            .fold(Frame::ZERO, |frame, (n, float)| frame.with(n, float));
        takes(&frame.into())
    }

    #[test]
    fn packets_of_old_programs_are_accepted() {
        for floats in [
            // The vendor's sliders.
            [10.0, 0.0, 100.0, 58.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
            // Its demo for a microcontroller.
            [9.0, 0.0, 50.0, 100.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
            // A gripper that opens too far, with a pump that is half on.
            [3.0, 0.0, 200.0, 0.0, 0.0, 0.0, 0.5, 0.0, 130.0, 0.0],
            // A jog at 130 percent, and one at none.
            [2.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 130.0, 0.0, 0.0],
            [2.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
            // Codes with a fraction (note N6), and state 15 (note N25).
            [2.5, 1.5, 0.0, 0.0, 0.0, 0.0, 0.0, 50.0, 0.0, 0.0],
            [15.0, 0.0, 45.0, 45.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        ] {
            assert!(takes_floats(floats), "{floats:?}");
        }
    }

    #[test]
    fn packets_that_hang_an_arm_or_lose_its_pose_are_not_accepted() {
        for floats in [
            // States, axes and moving modes that do not exist (note N51).
            [11.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
            [0.0; 10],
            [5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
            [2.0, 15.0, 0.0, 0.0, 0.0, 0.0, 0.0, 50.0, 0.0, 0.0],
            [3.0, 0.0, 200.0, 0.0, 0.0, 0.0, 0.0, 3.0, 0.0, 0.0],
            // A percentage of 0 (note N15), a vector without length (note N16), an endless pause.
            [10.0, 0.0, 0.0, 50.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
            [4.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 50.0],
            [3.0, 0.0, 200.0, 0.0, 0.0, 0.0, 0.0, 0.0, 130.0, 700.0],
            [3.0, 0.0, f32::NAN, 0.0, 0.0, 0.0, 0.0, 0.0, 130.0, 0.0],
        ] {
            assert!(!takes_floats(floats), "{floats:?}");
        }
    }
}
