//! A scenario: commands at given times and the reported statuses.

use std::time::Duration;

use dobot_arm::{Joints, Position};
use dobot_controller::{Controller, PowerUp, Refused};
use dobot_wire::{Command, Dialect, Frame, Packet, Status};

/// A controller on simulated time and all its statuses.
pub(crate) struct Lab {
    pub(crate) controller: Controller,
    now: Duration,
    /// The statuses with their times in milliseconds.
    pub(crate) statuses: Vec<(u64, Status)>,
}

impl Lab {
    pub(crate) fn power_up() -> Self {
        Self::power_up_with(PowerUp::default())
    }

    pub(crate) fn power_up_with(power_up: PowerUp) -> Self {
        Self {
            controller: Controller::power_up(power_up),
            now: Duration::ZERO,
            statuses: Vec::new(),
        }
    }

    /// Sends a command that arrives now.
    pub(crate) fn send(self, command: impl Into<Command>) -> Self {
        let packet = command.into().emit(&Dialect::SPECIFICATION);
        self.send_packet(packet)
    }

    pub(crate) fn send_packet(self, packet: Packet) -> Self {
        self.send_bytes(&packet.to_bytes())
    }

    pub(crate) fn send_floats(self, floats: [f32; 10]) -> Self {
        let frame = (1..=10).fold(Frame::ZERO, |frame, n| frame.with(n, floats[n - 1]));
        self.send_packet(Packet::Frame(frame))
    }

    pub(crate) fn send_bytes(mut self, bytes: &[u8]) -> Self {
        self.controller.handle_bytes(self.now, bytes);
        self
    }

    pub(crate) fn wait_ms(mut self, ms: u64) -> Self {
        let until = self.now + Duration::from_millis(ms);
        while self.controller.poll_wakeup() <= until {
            let at = self.controller.poll_wakeup();
            self.controller.handle_time(at);
            while let Some(upload) = self.controller.poll_bytes() {
                let frame = Frame::from_bytes(&upload.bytes).expect("a status is a frame");
                let status = Status::parse(&frame).expect("it is within its table");
                let ms = u64::try_from(at.as_millis()).expect("tests are short");
                self.statuses.push((ms, status));
            }
        }
        self.now = until;
        self
    }

    pub(crate) fn position(&self) -> Position {
        self.controller.pose_at(self.now).position
    }

    pub(crate) fn joints(&self) -> Joints {
        self.controller.joints_at(self.now)
    }

    #[track_caller]
    pub(crate) fn expect_at(self, x_mm: f64, y_mm: f64, z_mm: f64) -> Self {
        let (found, expected) = (self.position(), Position::new(x_mm, y_mm, z_mm));
        let apart = found.distance(expected).0;
        assert!(
            apart < 1e-6,
            "the arm is at {found:?}, not at {expected:?}: {apart} mm"
        );
        self
    }

    #[track_caller]
    pub(crate) fn expect_joints(self, base: f64, rear: f64, fore: f64, servo: f64) -> Self {
        let found = self.joints();
        for (found, expected) in [
            (found.base.0, base),
            (found.rear.0, rear),
            (found.fore.0, fore),
            (found.servo.0, servo),
        ] {
            assert!(
                (found - expected).abs() < 1e-9,
                "{found} is not {expected}: {:?}",
                self.joints()
            );
        }
        self
    }

    /// The refusals as texts.
    pub(crate) fn refusals(&mut self) -> Vec<String> {
        std::iter::from_fn(|| self.controller.poll_refused())
            .map(|it: Refused| it.to_string())
            .collect()
    }

    #[track_caller]
    pub(crate) fn expect_no_refusal(mut self) -> Self {
        let refusals = self.refusals();
        assert!(refusals.is_empty(), "refused were {refusals:?}");
        self
    }

    #[track_caller]
    pub(crate) fn expect_refusal(mut self, part: &str) -> Self {
        let refusals = self.refusals();
        assert!(
            refusals.len() == 1 && refusals[0].contains(part),
            "refused were {refusals:?}, expected `{part}`"
        );
        self
    }
}
