//! Identification of packets in bytes, one by one, from either sender.

use dobot_session::plausible;
use dobot_wire::{Command, Decoder, Dialect, Frame, PACKET_LEN, Packet, Status};

use super::SenderOption;
use super::content::{Content, Oddity, readings};
use super::rounded::rounded;

/// A range of bytes and its content.
#[derive(Debug)]
pub(super) struct Piece {
    /// The offset of the first byte.
    pub(super) offset: usize,
    /// The number of bytes.
    pub(super) len: usize,
    pub(super) content: Content,
}

/// Splits bytes into packets and other bytes. They start with a packet if they are `in_step`; otherwise
/// possibly in the middle of one.
///
/// A packet with plausible contents is accepted at any offset. Another one is accepted only right after
/// a packet, and only if no more plausible packet starts inside it.
pub(super) fn pieces(
    bytes: &[u8],
    from: SenderOption,
    dialect: Option<Dialect>,
    in_step: bool,
) -> Vec<Piece> {
    let found = find(bytes, from, in_step);
    let prevailing = prevailing(&found);
    let mut pieces = Vec::new();
    let mut end = 0;
    for packet in &found {
        skip(&mut pieces, end, packet.offset);
        pieces.push(packet.piece(prevailing, dialect));
        end = packet.offset + PACKET_LEN;
    }
    skip(&mut pieces, end, bytes.len());
    pieces
}

/// The confidence that a window of 42 bytes is a packet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Confidence {
    /// No packet.
    No,
    /// First and last byte of a packet.
    Delimited,
    /// Numbers in a plausible range.
    Believable,
    /// An allowed command, or a status whose position matches its angles.
    Sure,
}

impl Confidence {
    /// The least confidence in a packet right after another one, or elsewhere.
    const fn least(in_step: bool) -> Self {
        if in_step {
            Self::Delimited
        } else {
            Self::Believable
        }
    }
}

/// The sender of a packet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Sender {
    Client,
    Arm,
}

/// The confidence in a window as a packet of each sender.
#[derive(Clone, Copy, Debug)]
struct View {
    client: Confidence,
    arm: Confidence,
}

impl View {
    fn of(window: &[u8; PACKET_LEN], from: SenderOption) -> Self {
        let unless = |other: SenderOption, trust: fn(&[u8; PACKET_LEN]) -> Confidence| {
            if from == other {
                Confidence::No
            } else {
                trust(window)
            }
        };
        Self {
            client: unless(SenderOption::Arm, as_command),
            arm: unless(SenderOption::Client, as_status),
        }
    }

    fn trust(self) -> Confidence {
        self.client.max(self.arm)
    }

    /// The sender of the packet. An implausible packet is attributed to the sender of all other packets,
    /// if they have the same one.
    fn sender(self, window: &[u8; PACKET_LEN], prevailing: Option<Sender>) -> Sender {
        if self.client != self.arm {
            return if self.client > self.arm {
                Sender::Client
            } else {
                Sender::Arm
            };
        }
        if self.arm == Confidence::Sure {
            return Sender::Arm;
        }
        prevailing.unwrap_or_else(|| {
            let has_state = Frame::from_bytes(window).is_none_or(|frame| is_near_a_state(&frame));
            if has_state {
                Sender::Client
            } else {
                Sender::Arm
            }
        })
    }
}

/// A window that is accepted as a packet.
struct Found<'a> {
    offset: usize,
    window: &'a [u8; PACKET_LEN],
    view: View,
}

impl Found<'_> {
    fn piece(&self, prevailing: Option<Sender>, dialect: Option<Dialect>) -> Piece {
        let sender = self.view.sender(self.window, prevailing);
        Piece {
            offset: self.offset,
            len: PACKET_LEN,
            content: content(self.window, sender, self.view.trust(), dialect),
        }
    }
}

fn find(bytes: &[u8], from: SenderOption, mut in_step: bool) -> Vec<Found<'_>> {
    let view_at = |offset: usize| {
        let window = bytes.get(offset..)?.first_chunk()?;
        Some((window, View::of(window, from)))
    };
    let mut found = Vec::new();
    let mut offset = 0;
    while let Some((window, view)) = view_at(offset) {
        let trust = view.trust();
        let least = Confidence::least(in_step);
        let is_better = |inside| view_at(inside).is_some_and(|(_, view)| view.trust() > trust);
        in_step = trust >= least
            && (trust == Confidence::Sure || !(offset + 1..offset + PACKET_LEN).any(is_better));
        if in_step {
            found.push(Found {
                offset,
                window,
                view,
            });
        }
        offset += if in_step { PACKET_LEN } else { 1 };
    }
    found
}

/// The sender of all plausible packets, if they have the same one.
fn prevailing(found: &[Found]) -> Option<Sender> {
    let views = || {
        found
            .iter()
            .map(|found| found.view)
            .filter(|view| view.trust() >= Confidence::Believable)
    };
    let by_client = views().any(|view| view.client > view.arm);
    let by_arm = views().any(|view| view.client <= view.arm);
    match (by_client, by_arm) {
        (true, false) => Some(Sender::Client),
        (false, true) => Some(Sender::Arm),
        _ => None,
    }
}

/// Adds the bytes between two packets.
fn skip(pieces: &mut Vec<Piece>, from: usize, to: usize) {
    if from < to {
        pieces.push(Piece {
            offset: from,
            len: to - from,
            content: Content::Skipped((to - from) as u64),
        });
    }
}

fn content(
    window: &[u8; PACKET_LEN],
    sender: Sender,
    trust: Confidence,
    dialect: Option<Dialect>,
) -> Content {
    let frame = Frame::from_bytes(window);
    match (sender, frame, Packet::from_bytes(window)) {
        (Sender::Arm, Some(frame), _) => status(&frame, trust),
        (_, _, Some(packet)) => Content::Command(readings(&packet, dialect)),
        (_, _, None) => Content::Skipped(PACKET_LEN as u64),
    }
}

fn status(frame: &Frame, trust: Confidence) -> Content {
    if is_status(&frame.to_bytes(), plausible)
        && let Ok(status) = Status::parse(frame)
    {
        return Content::Status(status);
    }
    let oddity = match rounded(frame) {
        _ if is_pose_lost(frame) => Oddity::PoseLost,
        Some(off_mm) if trust >= Confidence::Believable => Oddity::Rounded { off_mm },
        _ => Oddity::Damaged,
    };
    Content::OddStatus(unchecked_status(frame), oddity)
}

/// Reads a status without any check.
fn unchecked_status(frame: &Frame) -> Status {
    let [
        x_mm,
        y_mm,
        z_mm,
        rotation_deg,
        base_deg,
        rear_deg,
        fore_deg,
        servo_deg,
        grab,
        gripper_deg,
    ] = *frame.floats();
    Status {
        x_mm,
        y_mm,
        z_mm,
        rotation_deg,
        base_deg,
        rear_deg,
        fore_deg,
        servo_deg,
        suction: grab == 1.0,
        gripper_deg,
    }
}

fn as_status(window: &[u8; PACKET_LEN]) -> Confidence {
    let Some(frame) = Frame::from_bytes(window) else {
        return Confidence::No;
    };
    if frame.floats() == Frame::ZERO.floats() {
        return Confidence::Delimited; // Matches the first message over Bluetooth (note N38), but proves nothing.
    }
    if is_status(window, plausible) {
        return Confidence::Sure;
    }
    let is_rounded = is_status(window, |frame| rounded(frame).is_some());
    if is_rounded || is_pose_lost(&frame) && frame.float(1).is_nan() {
        Confidence::Believable
    } else {
        Confidence::Delimited
    }
}

fn as_command(window: &[u8; PACKET_LEN]) -> Confidence {
    let Some(packet) = Packet::from_bytes(window) else {
        return Confidence::No;
    };
    if let Packet::Frame(frame) = &packet
        && frame.big_endian_state().is_some()
    {
        return Confidence::Believable;
    }
    // After a byte of noise a decoder accepts only plausible packets (note N24).
    let mut out_of_step = Decoder::commands();
    out_of_step.feed(&[0]).for_each(drop);
    if out_of_step.feed(window).count() > 0 {
        let is_allowed = |dialect: &Dialect| Command::parse(&packet, dialect).is_ok();
        return if Dialect::ALL.iter().any(is_allowed) {
            Confidence::Sure
        } else {
            Confidence::Believable
        };
    }
    if Decoder::commands().feed(window).count() > 0 {
        Confidence::Delimited
    } else {
        Confidence::No
    }
}

/// Whether a client with this check accepts a window as a status (note N22).
fn is_status(window: &[u8; PACKET_LEN], plausible: fn(&Frame) -> bool) -> bool {
    Decoder::statuses(plausible).feed(window).count() > 0
}

/// Whether a frame is a status of an arm whose pose became NaN (note N34).
fn is_pose_lost(frame: &Frame) -> bool {
    let lost = |n: &usize| frame.float(*n).is_nan();
    let rest = (1..=8)
        .filter(lost)
        .fold(*frame, |rest, n| rest.with(n, 0.0));
    (1..=8).any(|n| lost(&n)) && is_status(&rest.to_bytes(), |_| true)
}

/// Whether float 1 may be a state: X of a status is rarely a small whole number.
fn is_near_a_state(frame: &Frame) -> bool {
    let state = frame.float(1);
    (0.0..=20.0).contains(&state) && state.fract() == 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A packet of ten floats.
    fn packet(floats: [f32; 10]) -> Vec<u8> {
        let body = floats.iter().flat_map(|float| float.to_le_bytes());
        [0xA5].into_iter().chain(body).chain([0x5A]).collect()
    }

    /// What is found: `c` a command, `r` one that is refused, `s` a status, `d` a damaged one, `n` one
    /// whose pose is lost, `~` a rounded one, `-` bytes that belong to no packet.
    fn kinds(bytes: &[u8], from: SenderOption) -> String {
        let kind = |piece: Piece| match piece.content {
            Content::Status(_) => 's',
            Content::OddStatus(_, Oddity::PoseLost) => 'n',
            Content::OddStatus(_, Oddity::Rounded { .. }) => '~',
            Content::OddStatus(_, Oddity::Damaged) => 'd',
            Content::Command(readings)
                if readings.iter().any(|reading| reading.command.is_ok()) =>
            {
                'c'
            }
            Content::Command(_) => 'r',
            Content::Skipped(_) | Content::Gap(_) => '-',
        };
        pieces(bytes, from, None, true)
            .into_iter()
            .map(kind)
            .collect()
    }

    #[test]
    fn a_client_with_its_floats_high_byte_first_is_recognised() {
        let jog = [2.0, 0.0, 1.0, 50.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        let target = [3.0, 0.0, 200.0, -50.0, 20.0, 15.0, 0.0, 1.0, 0.0, 0.0];
        let swapped = [jog, target]
            .map(|floats| floats.map(|float: f32| f32::from_bits(float.to_bits().swap_bytes())));
        assert_eq!(kinds(&joined(&swapped), SenderOption::Auto), "rr");
        let Content::Command(readings) =
            &pieces(&joined(&swapped), SenderOption::Auto, None, false)[1].content
        else {
            panic!("a command");
        };
        let error = readings[0].command.expect_err("it is refused").to_string();
        assert!(error.contains("big-endian"), "{error}");
    }

    fn joined(packets: &[[f32; 10]]) -> Vec<u8> {
        packets.iter().flat_map(|floats| packet(*floats)).collect()
    }

    #[test]
    fn one_bad_status_does_not_turn_the_others_into_commands() {
        let mut bytes = joined(&[STATUS; 75]);
        bytes[40 * 42 + 3] ^= 0x40;
        let expected = format!("{}d{}", "s".repeat(40), "s".repeat(34));
        assert_eq!(kinds(&bytes, SenderOption::Auto), expected);
        assert_eq!(kinds(&bytes, SenderOption::Arm), expected);
    }

    #[test]
    fn packets_of_a_file_with_both_directions_are_classified_one_by_one() {
        let bytes = joined(&[STATUS, MOVE, STATUS, BAD_MOVE, STATUS, STATUS]);
        assert_eq!(kinds(&bytes, SenderOption::Auto), "scsrss");
        let noisy = [&bytes[..84], &[0xA5, 0x17, 0x00], &bytes[84..]].concat();
        assert_eq!(kinds(&noisy, SenderOption::Auto), "sc-srss");
    }

    #[test]
    fn statuses_with_rounded_values_are_statuses() {
        // The real one with one decimal, and with none.
        let one = [190.9, -124.0, 53.4, -33.0, -33.0, 14.0, 29.0, 0.0, 1.0, 0.0];
        let none = [191.0, -124.0, 53.0, -33.0, -33.0, 14.0, 29.0, 0.0, 1.0, 0.0];
        assert_eq!(
            kinds(&joined(&[one, none, STATUS, MOVE]), SenderOption::Auto),
            "~~sc"
        );
        assert_eq!(kinds(&joined(&[one, none]), SenderOption::Arm), "~~");
        // An X of 11 mm instead of 191 is no state 11 among them.
        let damaged = [11.0, -124.0, 53.0, -33.0, -33.0, 14.0, 29.0, 0.0, 1.0, 0.0];
        assert_eq!(kinds(&joined(&[none, damaged]), SenderOption::Auto), "~d");
        let off = [200.9, -124.0, 53.4, -33.0, -33.0, 14.0, 29.0, 0.0, 1.0, 0.0];
        assert_eq!(kinds(&joined(&[one, off]), SenderOption::Auto), "~d");
    }

    #[test]
    fn a_status_without_a_pose_is_a_status() {
        let nan = f32::NAN;
        let lost = [nan, nan, nan, -33.0, -33.0, nan, nan, 0.0, 1.0, 0.0];
        for from in [SenderOption::Auto, SenderOption::Arm] {
            assert_eq!(kinds(&joined(&[lost]), from), "n");
            assert_eq!(kinds(&joined(&[STATUS, lost, lost]), from), "snn");
            let joined_late = [&[0x17, 0x5A][..], &joined(&[lost, lost])].concat();
            assert_eq!(kinds(&joined_late, from), "-nn");
        }
    }

    #[test]
    fn a_meaningless_packet_belongs_to_the_sender_of_the_others() {
        let nonsense = [1.5, 0.0, 200.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        assert_eq!(kinds(&joined(&[MOVE, nonsense]), SenderOption::Auto), "cr");
        assert_eq!(
            kinds(&joined(&[STATUS, nonsense]), SenderOption::Auto),
            "sd"
        );
        assert_eq!(kinds(&joined(&[nonsense]), SenderOption::Client), "r");
        // State 0 alone.
        assert_eq!(kinds(&joined(&[[0.0; 10]]), SenderOption::Auto), "r");
    }

    #[test]
    fn a_truncated_packet_does_not_swallow_the_next() {
        let cut = &packet(MOVE)[..30];
        let bytes = [cut, &joined(&[STATUS, MOVE])].concat();
        assert_eq!(kinds(&bytes, SenderOption::Auto), "-sc");
        assert_eq!(kinds(&bytes, SenderOption::Client), "-c");
    }

    #[test]
    fn a_stream_joined_in_the_middle_is_found_again() {
        let bytes = joined(&[STATUS, STATUS, MOVE]);
        for cut in 1..42 {
            assert_eq!(kinds(&bytes[cut..], SenderOption::Auto), "-sc", "cut {cut}");
        }
    }

    proptest::proptest! {
        #[test]
        fn every_byte_is_in_exactly_one_piece(
            bytes in proptest::collection::vec(
                proptest::prop_oneof![
                    proptest::prelude::any::<u8>(),
                    proptest::prelude::Just(0xA5),
                    proptest::prelude::Just(0x5A),
                    proptest::prelude::Just(0),
                ],
                0..300,
            ),
            good in 0..3_usize,
            in_step: bool,
        ) {
            let bytes = [joined(&[MOVE, STATUS][..good.min(2)]), bytes].concat();
            for from in [SenderOption::Auto, SenderOption::Arm, SenderOption::Client] {
                let mut end = 0;
                for piece in pieces(&bytes, from, None, in_step) {
                    proptest::prop_assert_eq!(piece.offset, end);
                    proptest::prop_assert!(piece.len > 0);
                    end += piece.len;
                }
                proptest::prop_assert_eq!(end, bytes.len());
            }
        }
    }

    /// Sent by a real arm.
    const STATUS: [f32; 10] = [
        190.938_37,
        -123.997_19,
        53.420_32,
        -33.0,
        -33.0,
        14.0,
        29.0,
        0.0,
        1.0,
        0.0,
    ];
    const MOVE: [f32; 10] = [3.0, 0.0, 200.0, -50.0, 20.0, 15.0, 0.0, 0.0, 0.0, 0.0];
    /// With an unknown moving mode.
    const BAD_MOVE: [f32; 10] = [3.0, 0.0, 200.0, -50.0, 20.0, 15.0, 0.0, 7.0, 0.0, 0.0];
}
