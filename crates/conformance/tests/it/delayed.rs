//! A line that is late: everything takes so much longer, each way.

use std::collections::VecDeque;
use std::time::Duration;

use dobot_session::Peer;
use dobot_sim::InProcess;

/// A virtual arm behind a line that is late.
#[derive(Debug)]
pub(crate) struct Delayed {
    arm: InProcess,
    /// How late, for the first, second and every further send; the last one counts from then on.
    one_way: Vec<Duration>,
    to_arm: VecDeque<(Duration, Vec<u8>)>,
    from_arm: VecDeque<(Duration, Vec<u8>)>,
    sent: usize,
}

impl Delayed {
    /// Both ways always as late.
    pub(crate) fn by(arm: InProcess, one_way: Duration) -> Self {
        Self::in_turn(arm, vec![one_way])
    }

    /// Each send as late as it is its turn, and again from the first one; no byte overtakes another.
    pub(crate) fn in_turn(arm: InProcess, one_way: Vec<Duration>) -> Self {
        Self {
            arm,
            one_way,
            to_arm: VecDeque::new(),
            from_arm: VecDeque::new(),
            sent: 0,
        }
    }

    /// When what is sent now arrives, behind what was sent before it.
    fn arrival(&mut self, before: Option<Duration>) -> Duration {
        let late = self.one_way[self.sent % self.one_way.len()];
        self.sent += 1;
        (self.arm.now() + late).max(before.unwrap_or_default())
    }
}

impl Peer for Delayed {
    fn now(&self) -> Duration {
        self.arm.now()
    }

    fn send(&mut self, bytes: &[u8]) {
        if !bytes.is_empty() {
            let at = self.arrival(self.to_arm.back().map(|it| it.0));
            self.to_arm.push_back((at, bytes.to_vec()));
        }
    }

    fn receive(&mut self, until: Duration, bytes: &mut Vec<u8>) -> bool {
        loop {
            let now = self.arm.now();
            while self.to_arm.front().is_some_and(|(at, _)| *at <= now) {
                let (_, packet) = self.to_arm.pop_front().expect("it was just seen");
                self.arm.send(&packet);
            }
            if self.from_arm.front().is_some_and(|(at, _)| *at <= now) {
                let (_, packet) = self.from_arm.pop_front().expect("it was just seen");
                bytes.extend(packet);
                return true;
            }
            if now >= until {
                return true;
            }
            let due = [self.to_arm.front(), self.from_arm.front()];
            let due = due.into_iter().flatten().map(|(at, _)| *at);
            let next = due.fold(until, Duration::min);
            let mut new = Vec::new();
            self.arm.receive(next, &mut new);
            if !new.is_empty() {
                let at = self.arrival(self.from_arm.back().map(|it| it.0));
                self.from_arm.push_back((at, new));
            }
        }
    }
}
