//! Scripts in virtual time.

mod feed;

use std::time::Duration;

use dobot_arm::TICK;
use dobot_controller::{Controller, Personality, Port, PowerUp, Refused};
use dobot_wire::PACKET_LEN;
use thiserror::Error;

use self::feed::Feed;
use crate::Script;
use crate::serial_line::STOCK_BYTE_TIME;
use crate::trace::{Trace, TracedStatus, TracedTick};

/// The result of a script.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Simulation {
    /// The statuses, ticks and printed text.
    pub trace: Trace,
    /// The refusals, oldest first, each with its control tick.
    pub refused: Vec<(Duration, Refused)>,
    /// The number of script lines not completely sent at the end.
    pub unsent: usize,
    /// The end time.
    pub end: Duration,
}

/// The error returned when a script cannot be run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum SimulateError {
    /// The script is for a port that this personality does not have.
    #[error(
        "the script says `!port bt`; the personality {personality} has the USB port only, and {} has both",
        Personality::Firmware11
    )]
    NoBluetooth {
        /// The personality.
        personality: Personality,
    },
}

/// Runs a script in virtual time: deterministic to the bit, and as fast as the machine calculates.
///
/// Time 0 is the first control tick. Bytes travel over the line of a stock arm
/// ([`SerialLine::STOCK`](crate::SerialLine::STOCK)); each reaches the controller at its own time, and
/// one that arrives exactly at a control tick is in time for it. A status is received when its last
/// byte has arrived.
///
/// A script without `!end` is run until all lines are sent and the motors have stood still for
/// a second after that; at most for a minute after the last byte, and for a minute after the
/// last status where a line waits for one.
///
/// # Errors
///
/// Returns a [`SimulateError`] if the personality does not have the script's port.
pub fn simulate(script: &Script, personality: Personality) -> Result<Simulation, SimulateError> {
    simulate_watched(script, personality, |_, _| {})
}

/// Runs a script as [`simulate`] and calls `watch` after each control tick with the controller and
/// the tick's time.
///
/// # Errors
///
/// See [`simulate`].
pub fn simulate_watched(
    script: &Script,
    personality: Personality,
    mut watch: impl FnMut(Duration, &Controller),
) -> Result<Simulation, SimulateError> {
    if script.port == Port::Bluetooth && personality == Personality::Specification {
        return Err(SimulateError::NoBluetooth { personality });
    }
    let mut run = ScriptRun::new(script, personality);
    while let Some(at) = run.tick() {
        watch(at, &run.controller);
    }
    Ok(run.finish())
}

/// A running script.
struct ScriptRun<'a> {
    controller: Controller,
    feed: Feed<'a>,
    port: Port,
    /// The end time of the script, if given.
    end: Option<Duration>,
    /// The arrival time of the last status.
    line_free: Duration,
    /// The time of the last motor motion.
    last_move: Duration,
    next_tick: u32,
    trace: Trace,
    refused: Vec<(Duration, Refused)>,
}

impl<'a> ScriptRun<'a> {
    fn new(script: &'a Script, personality: Personality) -> Self {
        let controller = Controller::power_up(
            PowerUp::new(personality)
                .with_port(script.port)
                .with_tilt(script.rear_deg, script.fore_deg),
        );
        Self {
            controller,
            feed: Feed::new(&script.lines),
            port: script.port,
            end: script.end,
            line_free: Duration::ZERO,
            last_move: Duration::ZERO,
            next_tick: 0,
            trace: Trace::default(),
            refused: Vec::new(),
        }
    }

    /// Runs the next control tick and returns its time; `None` at the end.
    fn tick(&mut self) -> Option<Duration> {
        let at = TICK * self.next_tick;
        if self.is_over(at) {
            return None;
        }
        self.deliver(at);
        self.controller.handle_time(at);
        self.record(at);
        self.next_tick += 1;
        Some(at)
    }

    fn is_over(&self, at: Duration) -> bool {
        match self.end {
            Some(end) => at >= end,
            None if self.feed.starves() => at >= self.line_free + PATIENCE,
            None if self.feed.unsent() > 0 => false,
            None => {
                let sent = self.feed.line_free();
                at >= sent.max(self.last_move) + STILL || at >= sent + PATIENCE
            }
        }
    }

    /// Passes on the bytes that arrive up to and including a control tick. The controller itself treats
    /// a byte at that instant as later.
    fn deliver(&mut self, tick: Duration) {
        while let Some((arrival, byte)) = self.feed.next_byte(tick) {
            let arrival = arrival.min(tick.saturating_sub(INSTANT));
            self.controller.handle_bytes(arrival, &[byte]);
        }
    }

    fn record(&mut self, at: Duration) {
        let row = TracedTick {
            outputs: self.controller.outputs(),
            sums: self.controller.steps(),
        };
        if row.outputs.pulses != [0; 3] {
            self.last_move = at;
        }
        self.trace.ticks.push(row);
        while let Some(upload) = self.controller.poll_bytes() {
            self.receive(upload.at, &upload.bytes);
        }
        while let Some(refused) = self.controller.poll_refused() {
            self.refused.push((at, refused));
        }
        self.print();
    }

    /// Records a status and the time at which it releases a line.
    fn receive(&mut self, at: Duration, bytes: &[u8; PACKET_LEN]) {
        let floats = std::array::from_fn(|index| {
            let at = 1 + 4 * index;
            f32::from_le_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]])
        });
        self.trace.statuses.push(TracedStatus {
            tick: self.next_tick,
            floats,
        });
        self.line_free = at.max(self.line_free) + PACKET_TIME;
        let is_credit = match self.port {
            Port::Usb => true,
            Port::Bluetooth => floats[0] < REQUEST_BELOW_MM,
        };
        if is_credit {
            self.feed.credit(self.line_free);
        }
    }

    fn print(&mut self) {
        while let Some(byte) = self.controller.poll_other_port() {
            self.trace.other_port.push(byte);
        }
    }

    fn finish(mut self) -> Simulation {
        let end = self.end.unwrap_or(TICK * self.next_tick);
        self.deliver(end);
        self.print();
        Simulation {
            trace: self.trace,
            refused: self.refused,
            unsent: self.feed.unsent(),
            end,
        }
    }
}
/// The transmission time of a status.
const PACKET_TIME: Duration = STOCK_BYTE_TIME.saturating_mul(42);
/// Shorter than any time on the line.
const INSTANT: Duration = Duration::from_nanos(1);
/// On the Bluetooth port, x of the statuses that ask for a command; the others have 1000 more.
const REQUEST_BELOW_MM: f32 = 500.0;
/// The rest time of the motors that ends a script without `!end`.
const STILL: Duration = Duration::from_secs(1);
/// The timeout of such a script.
const PATIENCE: Duration = Duration::from_secs(60);

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test fails by it")]
mod tests;
