//! The engine of a replay: recording and bytes in, bytes and differences out.

use std::collections::VecDeque;
use std::time::Duration;

use dobot_wire::{Commands, Decoder};

use crate::{Difference, Entry, Recording, Report};

/// A playback of a recording with comparison. It reads the recording twice, once for the bytes of
/// the arm and once for those of its client, so that neither side waits for the other.
#[derive(Debug)]
pub(crate) struct Playback {
    arm: Recording,
    /// The next bytes of the arm and their time.
    next: Option<(Duration, Vec<u8>)>,
    /// The time of the first byte.
    begin: Option<Duration>,
    /// The time of the last byte, as far as known.
    end: Duration,
    now: Duration,
    client: Recording,
    recorded: Decoder<Commands>,
    /// Packets of one piece of the recording that the client has not sent yet.
    expected: VecDeque<(Duration, [u8; 42])>,
    sent: Decoder<Commands>,
    report: Report,
}

impl Playback {
    /// Starts a playback from two readers of the same recording.
    pub(crate) fn new(arm: Recording, client: Recording) -> Self {
        let mut playback = Self {
            arm,
            next: None,
            begin: None,
            end: Duration::ZERO,
            now: Duration::ZERO,
            client,
            recorded: Decoder::commands(),
            expected: VecDeque::new(),
            sent: Decoder::commands(),
            report: Report::default(),
        };
        playback.fetch();
        playback.now = playback.begin();
        playback
    }

    /// The time since the first byte.
    pub(crate) fn now(&self) -> Duration {
        self.now.saturating_sub(self.begin())
    }

    pub(crate) fn poll_wakeup(&self) -> Option<Duration> {
        let next = self.next.as_ref().map(|(at, _)| *at);
        let next = next.or_else(|| (self.now < self.end).then_some(self.end))?;
        Some(next.max(self.now).saturating_sub(self.begin()))
    }

    /// Handles bytes from the client.
    pub(crate) fn handle_bytes(&mut self, bytes: &[u8]) {
        let packets: Vec<_> = self.sent.feed(bytes).map(|feed| feed.to_bytes()).collect();
        for packet in packets {
            self.compare(packet);
        }
    }

    pub(crate) fn receive(&mut self, until: Duration, bytes: &mut Vec<u8>) -> bool {
        let until = self.begin().saturating_add(until);
        if let Some((at, some)) = self.next.take_if(|(at, _)| *at <= until) {
            self.now = self.now.max(at);
            bytes.extend(some);
            self.fetch();
            return true;
        }
        let is_over = self.next.is_none() && self.end <= until;
        let until = if is_over { self.end } else { until };
        self.now = self.now.max(until);
        !is_over
    }

    /// Returns the result; recorded packets up to now that were not sent count as missing.
    pub(crate) fn report(&mut self) -> Report {
        self.look_ahead();
        while self
            .expected
            .front()
            .is_some_and(|packet| packet.0 <= self.now)
            && let Some((at, recorded)) = self.expected.pop_front()
        {
            self.report.push(Difference {
                at,
                recorded: Some(recorded),
                sent: None,
            });
            self.look_ahead();
        }
        Report {
            noise_bytes: self.sent.counts().skipped_bytes,
            recorded_noise_bytes: self.recorded.counts().skipped_bytes,
            damage: self.arm.damage().cloned(),
            ..self.report.clone()
        }
    }

    fn begin(&self) -> Duration {
        self.begin.unwrap_or_default()
    }

    /// Reads up to the next bytes of the arm.
    fn fetch(&mut self) {
        for moment in self.arm.by_ref() {
            let bytes = match moment.entry {
                Entry::FromArm(bytes) => Some(bytes),
                Entry::ToArm(_) => None,
                Entry::Json(_) | Entry::Other(_) => continue,
            };
            self.begin.get_or_insert(moment.at);
            self.end = self.end.max(moment.at);
            if let Some(bytes) = bytes {
                self.next = Some((moment.at, bytes));
                return;
            }
        }
    }

    fn compare(&mut self, sent: [u8; 42]) {
        self.look_ahead();
        match self.expected.pop_front() {
            Some((at, recorded)) if recorded == sent => {
                let apart = self.now.abs_diff(at);
                self.report.furthest_apart = self.report.furthest_apart.max(apart);
                self.report.same += 1;
            }
            other => self.report.push(Difference {
                at: self.now,
                recorded: other.map(|(_, recorded)| recorded),
                sent: Some(sent),
            }),
        }
    }

    /// Reads up to the next packet expected from the client.
    fn look_ahead(&mut self) {
        while self.expected.is_empty()
            && let Some(moment) = self.client.next()
        {
            if let Entry::ToArm(bytes) = moment.entry {
                let packets = self.recorded.feed(&bytes);
                let packets = packets.map(|packet| (moment.at, packet.to_bytes()));
                self.expected.extend(packets);
            }
        }
    }
}
