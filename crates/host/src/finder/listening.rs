//! Listening to a port.

use std::time::Duration;

use dobot_session::{NoStatus, StatusWait, plausible};
use dobot_wire::{Decoder, Status, Statuses};

/// Listens to a port until a valid status arrives or the time is over.
#[derive(Debug)]
pub(super) struct Listening {
    decoder: Decoder<Statuses>,
    /// The last bytes received.
    kept: Vec<u8>,
    wait: StatusWait,
}

impl Listening {
    /// The time after opening by which an arm has sent a status: one that restarts is silent for
    /// two seconds.
    pub(super) const UNTIL: Duration = Duration::from_secs(5);

    pub(super) fn new() -> Self {
        Self {
            decoder: Decoder::statuses(plausible),
            kept: Vec::new(),
            wait: StatusWait::default(),
        }
    }

    /// Handles bytes; returns whether an arm was found.
    pub(super) fn handle_bytes(&mut self, bytes: &[u8]) -> bool {
        self.wait.handle_bytes(bytes);
        self.kept.extend_from_slice(bytes);
        self.kept.drain(..self.kept.len().saturating_sub(KEPT));
        let is_status = |frame| Status::parse(&frame).is_ok();
        // Count all of them: the decoder drops bytes that it has not reached.
        self.decoder
            .feed(bytes)
            .filter(|frame| is_status(*frame))
            .count()
            > 0
    }

    /// Returns what arrived, if no arm was found.
    pub(super) fn no_status(&self) -> NoStatus {
        self.wait.no_status()
    }

    /// Returns the bytes received, without the oldest ones.
    pub(super) fn into_bytes(self) -> Vec<u8> {
        self.kept
    }
}

/// The size of the kernel's buffer for a serial port.
const KEPT: usize = 4096;

#[cfg(test)]
mod tests {
    use dobot_arm::{Joints, Tool};
    use dobot_motion::ArmPlace;
    use proptest::prelude::*;

    use super::*;

    /// The status of an arm at power-up.
    fn status() -> [u8; 42] {
        let joints = Joints::new(0.0, 45.0, 45.0, 0.0);
        let place = ArmPlace::at_joints(joints, Tool::SuctionCup);
        place.status().emit().to_bytes()
    }

    #[test]
    fn one_status_in_pieces_of_any_size_is_an_arm() {
        let mut listening = Listening::new();
        let are_arms: Vec<bool> = status().map(|byte| listening.handle_bytes(&[byte])).into();
        assert!(are_arms[41]);
        assert_eq!(are_arms.iter().filter(|is_arm| **is_arm).count(), 1);
        assert_eq!(listening.into_bytes(), status());
    }

    #[test]
    fn nothing_is_silence_and_anything_else_is_noise() {
        let mut listening = Listening::new();
        assert!(!listening.handle_bytes(&[]));
        assert_eq!(listening.no_status(), NoStatus::Nothing);
        assert!(!listening.handle_bytes(&[7; 7]));
        assert_eq!(listening.no_status(), NoStatus::Other { bytes: 7 });
    }

    #[test]
    fn a_packet_whose_position_contradicts_its_angles_is_not_an_arm() {
        let mut packet = status();
        packet[1..5].copy_from_slice(&200.0_f32.to_le_bytes());
        let mut listening = Listening::new();
        assert!(!listening.handle_bytes(&packet.repeat(20)));
    }

    proptest! {
        #[test]
        fn a_status_after_any_noise_is_found_and_the_buffer_is_bounded(
            noise in proptest::collection::vec(any::<u8>(), 0..10_000),
            cut in 1_usize..500,
        ) {
            let mut listening = Listening::new();
            let mut all = noise;
            // A false header at the end of the noise hides at most the first status.
            all.extend(status().repeat(2));
            let found = all.chunks(cut).filter(|chunk| listening.handle_bytes(chunk)).count();
            prop_assert!(found > 0);
            prop_assert!(listening.into_bytes().len() <= 4096);
        }
    }
}
