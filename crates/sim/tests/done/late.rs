//! A link that takes its time, the same each way.

use std::collections::VecDeque;
use std::time::Duration;

use dobot_client::Peer;
use dobot_sim::InProcess;

/// A virtual arm behind a link that is late by the same time each way.
#[derive(Debug)]
pub(crate) struct Late {
    arm: InProcess,
    latency: Duration,
    to_arm: VecDeque<(Duration, Vec<u8>)>,
    from_arm: VecDeque<(Duration, Vec<u8>)>,
}

impl Late {
    pub(crate) fn new(arm: InProcess, latency: Duration) -> Self {
        Self {
            arm,
            latency,
            to_arm: VecDeque::new(),
            from_arm: VecDeque::new(),
        }
    }

    fn deliver(&mut self, bytes: &mut Vec<u8>) {
        let now = self.arm.now();
        while let Some((_, packet)) = self.to_arm.pop_front_if(|it| it.0 <= now) {
            self.arm.send(&packet);
        }
        while let Some((_, piece)) = self.from_arm.pop_front_if(|it| it.0 <= now) {
            bytes.extend(piece);
        }
    }
}

impl Peer for Late {
    fn now(&self) -> Duration {
        self.arm.now()
    }

    fn send(&mut self, bytes: &[u8]) {
        self.to_arm
            .push_back((self.arm.now() + self.latency, bytes.to_vec()));
    }

    fn receive(&mut self, until: Duration, bytes: &mut Vec<u8>) -> bool {
        let had = bytes.len();
        loop {
            self.deliver(bytes);
            let now = self.arm.now();
            if bytes.len() > had || now >= until {
                return true;
            }
            let due = [&self.to_arm, &self.from_arm].map(|it| it.front().map(|it| it.0));
            let next = due.into_iter().flatten().min().unwrap_or(until);
            let mut piece = Vec::new();
            self.arm.receive(next.min(until), &mut piece);
            if !piece.is_empty() {
                let arrives = self.arm.now() + self.latency;
                self.from_arm.push_back((arrives, piece));
            }
        }
    }
}
