//! Bytes to a controller at any times.

use std::time::Duration;

use dobot_controller::{Controller, Personality, PowerUp};
use dobot_wire::{Frame, PACKET_LEN};

/// Does to a controller what the input says, and shows every status to `judge`.
///
/// The input is a list of steps of a few bytes: bytes on the line, whole packets with any floats or
/// with likely ones, and time that passes.
pub(crate) fn drive(
    personality: Personality,
    input: &[u8],
    mut judge: impl FnMut(&Controller, &Frame),
) {
    let mut steps = Steps { input };
    let mut line = Line {
        controller: Controller::power_up(PowerUp::new(personality)),
        now: Duration::ZERO,
    };
    while let Some(step) = steps.byte() {
        match step % 4 {
            0 => line.send(steps.bytes(usize::from(step / 4))),
            1 => line.send(&steps.any_packet()),
            2 => line.send(&steps.likely_packet(step / 4)),
            _ => {
                let factor = steps.byte().unwrap_or(1);
                line.now += Duration::from_millis(u64::from(step / 4) * u64::from(factor));
            }
        }
        line.settle(&mut judge);
    }
    line.now += Duration::from_secs(1);
    line.settle(&mut judge);
}

struct Line {
    controller: Controller,
    now: Duration,
}

impl Line {
    /// One byte after the other, each at its time.
    fn send(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.now += BYTE_TIME;
            self.controller.handle_bytes(self.now, &[byte]);
        }
    }

    fn settle(&mut self, judge: &mut impl FnMut(&Controller, &Frame)) {
        self.controller.handle_time(self.now);
        while let Some(upload) = self.controller.poll_bytes() {
            assert!(
                upload.at <= self.now + Duration::from_millis(20),
                "{upload:?}"
            );
            let frame = Frame::from_bytes(&upload.bytes).expect("a status is a frame");
            judge(&self.controller, &frame);
        }
        while self.controller.poll_refused().is_some() {}
        while self.controller.poll_other_port().is_some() {}
    }
}

struct Steps<'a> {
    input: &'a [u8],
}

impl<'a> Steps<'a> {
    fn byte(&mut self) -> Option<u8> {
        let (&byte, rest) = self.input.split_first()?;
        self.input = rest;
        Some(byte)
    }

    fn bytes(&mut self, count: usize) -> &'a [u8] {
        let (bytes, rest) = self.input.split_at(count.min(self.input.len()));
        self.input = rest;
        bytes
    }

    fn any_packet(&mut self) -> [u8; PACKET_LEN] {
        let bytes = self.bytes(PACKET_LEN - 2);
        let mut packet = Frame::ZERO.to_bytes();
        packet[1..=bytes.len()].copy_from_slice(bytes);
        packet
    }

    /// A state and numbers that somebody might send.
    fn likely_packet(&mut self, state: u8) -> [u8; PACKET_LEN] {
        let mut frame = Frame::ZERO.with(1, f32::from(state % 17));
        for n in 2..=10 {
            let byte = self.byte().unwrap_or(0);
            frame = frame.with(n, likely_number(byte));
        }
        frame.to_bytes()
    }
}

fn likely_number(byte: u8) -> f32 {
    match byte {
        16..200 => (f32::from(byte) - 108.0) * 4.0,
        200..240 => (f32::from(byte) - 220.0) / 8.0,
        240 => f32::NAN,
        241 => f32::INFINITY,
        242 => f32::NEG_INFINITY,
        243 => f32::MAX,
        244 => f32::MIN_POSITIVE,
        245 => -0.0,
        246 => 1e-7,
        247 => 1e7,
        248 => -1e7,
        _ => f32::from(byte),
    }
}

/// A byte at 9600 baud.
const BYTE_TIME: Duration = Duration::from_micros(1040);
