//! A mixture, sent to the twin in one way or another.

use std::time::Duration;

use dobot_arm::TICK;
use dobot_controller::{Controller, Outputs, Personality, PowerUp, Refused, Upload};

use super::mixture::Mixture;

/// Who looks at the twin how often.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Slicing {
    /// At each tick, and with each byte.
    Ticks,
    /// With each byte, and once at the end or each second.
    Bytes,
    /// With the bytes of the second half of a tick at once.
    Chunks,
}

/// What came of it.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct MixtureRun {
    pub(crate) uploads: Vec<Upload>,
    pub(crate) refused: u64,
    pub(crate) packets: u64,
    pub(crate) begun: u64,
    pub(crate) steps: [i64; 3],
    pub(crate) other_port: Vec<u8>,
    /// A row for each tick, if each was looked at.
    pub(crate) rows: Vec<TickRow>,
}

/// What can be seen behind a tick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TickRow {
    pub(crate) outputs: Outputs,
    pub(crate) steps: [i64; 3],
    /// Commands that wait, counted from outside.
    pub(crate) waiting: u64,
    /// How many uploads there have been.
    pub(crate) uploads: usize,
}

pub(crate) fn run(mixture: &Mixture, pace: Slicing) -> MixtureRun {
    let bytes = mixture.bytes();
    let mut it = Runner::new(mixture);
    let end = bytes.last().map_or(Duration::ZERO, |it| it.0) + WATCHED;
    let mut rest = &bytes[..];
    while let Some(&(at, byte)) = rest.first() {
        it.look_until(at, pace);
        let count = match pace {
            Slicing::Ticks | Slicing::Bytes => 1,
            Slicing::Chunks => same_half(rest),
        };
        let (chunk, behind) = rest.split_at(count);
        let values: Vec<u8> = chunk.iter().map(|it| it.1).collect();
        debug_assert_eq!(values[0], byte);
        it.controller.handle_bytes(chunk[count - 1].0, &values);
        rest = behind;
        it.note();
    }
    it.look_until(end, pace);
    it.finish()
}

/// How many bytes arrive within one second half of a tick, when nobody calculates; the first one of
/// any other time alone.
fn same_half(bytes: &[(Duration, u8)]) -> usize {
    let tick = |at: Duration| at.as_micros() / TICK.as_micros();
    let is_late = |at: Duration| at.as_micros() % TICK.as_micros() >= TICK.as_micros() / 2;
    let first = bytes[0].0;
    let same = |it: &&(Duration, u8)| is_late(it.0) && tick(it.0) == tick(first);
    bytes.iter().take_while(same).count().max(1)
}

struct Runner {
    controller: Controller,
    run: MixtureRun,
    next_tick: u32,
    dropped: u64,
}

impl Runner {
    fn new(mixture: &Mixture) -> Self {
        Self {
            controller: Controller::power_up(
                PowerUp::new(Personality::Firmware11).with_port(mixture.port),
            ),
            run: MixtureRun::default(),
            next_tick: 0,
            dropped: 0,
        }
    }

    fn look_until(&mut self, until: Duration, pace: Slicing) {
        while TICK * self.next_tick <= until {
            let at = TICK * self.next_tick;
            self.next_tick += 1;
            match pace {
                Slicing::Ticks => {
                    self.controller.handle_time(at);
                    self.note();
                    self.push_row();
                }
                // Statuses are kept for a second.
                Slicing::Bytes | Slicing::Chunks if self.next_tick.is_multiple_of(50) => {
                    self.controller.handle_time(at);
                    self.note();
                }
                Slicing::Bytes | Slicing::Chunks => {}
            }
        }
    }

    fn note(&mut self) {
        let it = &mut self.controller;
        self.run
            .uploads
            .extend(std::iter::from_fn(|| it.poll_bytes()));
        let printed = std::iter::from_fn(|| it.poll_other_port());
        self.run.other_port.extend(printed);
        let refused = std::iter::from_fn(|| it.poll_refused());
        self.dropped += refused.filter(|it| *it == Refused::QueueFull).count() as u64;
    }

    fn push_row(&mut self) {
        let counters = self.controller.counters();
        self.run.rows.push(TickRow {
            outputs: self.controller.outputs(),
            steps: self.controller.steps(),
            waiting: counters.packets - self.dropped - counters.begun,
            uploads: self.run.uploads.len(),
        });
    }

    fn finish(mut self) -> MixtureRun {
        self.controller.handle_time(TICK * (self.next_tick - 1));
        self.note();
        let counters = self.controller.counters();
        MixtureRun {
            refused: counters.refused,
            packets: counters.packets,
            begun: counters.begun,
            steps: self.controller.steps(),
            ..self.run
        }
    }
}
/// How long the arm is watched behind the last byte.
const WATCHED: Duration = Duration::from_secs(4);
