//! A link that takes its time.

use std::collections::VecDeque;
use std::time::Duration;

use dobot_session::Peer;
use dobot_sim::InProcess;

use super::Dice;

/// A virtual arm behind a link that is late by the same time each way; or on the way back by any
/// time up to that. The other way that would bring two packets too close together for a stock arm,
/// which loses one then (note N26).
#[derive(Debug)]
pub(crate) struct Late {
    arm: InProcess,
    latency: Duration,
    jitter: Option<Dice>,
    to_arm: VecDeque<(Duration, Vec<u8>)>,
    from_arm: VecDeque<(Duration, Vec<u8>)>,
}

impl Late {
    pub(crate) fn new(arm: InProcess, latency: Duration, jitter: Option<Dice>) -> Self {
        Self {
            arm,
            latency,
            jitter,
            to_arm: VecDeque::new(),
            from_arm: VecDeque::new(),
        }
    }

    /// When what the arm says now arrives, behind what it said before.
    fn arrival(&mut self) -> Duration {
        let last = self.from_arm.back().map(|it| it.0);
        let share = self.jitter.as_mut().map_or(1.0, |it| it.between(0.0, 1.0));
        let arrival = self.arm.now() + self.latency.mul_f32(share);
        arrival.max(last.unwrap_or_default())
    }

    fn deliver(&mut self, bytes: &mut Vec<u8>) {
        let now = self.arm.now();
        while self.to_arm.front().is_some_and(|it| it.0 <= now)
            && let Some((_, packet)) = self.to_arm.pop_front()
        {
            self.arm.send(&packet);
        }
        while self.from_arm.front().is_some_and(|it| it.0 <= now)
            && let Some((_, piece)) = self.from_arm.pop_front()
        {
            bytes.extend(piece);
        }
    }
}

impl Peer for Late {
    fn now(&self) -> Duration {
        self.arm.now()
    }

    fn send(&mut self, bytes: &[u8]) {
        let arrival = self.arm.now() + self.latency;
        self.to_arm.push_back((arrival, bytes.to_vec()));
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
                let arrival = self.arrival();
                self.from_arm.push_back((arrival, piece));
            }
        }
    }
}
