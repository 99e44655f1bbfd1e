//! A virtual arm: a controller on a serial line.

#[cfg(feature = "world")]
mod surroundings;

use std::time::Duration;

use dobot_arm::{Position, TICK};
use dobot_controller::{Controller, PowerUp, Refused};

use crate::faults::{ArmOrder, FaultState, LineDirection, Tilt};
#[cfg(feature = "world")]
use crate::world::World;
use crate::{Fault, FaultError, Mechanics, SerialLine, Struck};

/// A virtual arm: a controller on a serial line, as an engine that owns no port and no clock.
#[derive(Debug)]
pub struct VirtualArm {
    controller: Controller,
    /// The time of the controller's first tick; `Duration::MAX` while the power is off.
    started: Duration,
    mechanics: Mechanics,
    /// The time of the last status, and the shortest interval between two.
    uploaded: Duration,
    spacing: Duration,
    /// Control ticks applied to the machine.
    ticks: u32,
    to_arm: SerialLine,
    from_arm: SerialLine,
    faults: Option<Box<FaultState>>,
    now: Duration,
    /// The time of the last event, up to which the path is recorded.
    last_event: Duration,
    recorder: Option<Recorder>,
    #[cfg(feature = "world")]
    world: Option<Box<World>>,
    scratch: Vec<u8>,
}

/// A sample of the commanded tool pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// The time since power-up.
    pub at: Duration,
    /// The pose of the tool.
    pub position: Position,
    /// Whether the laser was on since the previous sample.
    pub laser: bool,
}

#[derive(Debug)]
struct Recorder {
    period: Duration,
    samples: Vec<Sample>,
    /// The last sample equal to the one before it, where a motion starts.
    rest: Option<Sample>,
}

impl VirtualArm {
    /// Connects a controller to a line.
    #[must_use]
    pub fn new(controller: Controller, line: SerialLine) -> Self {
        Self {
            mechanics: Mechanics::new(controller.joints_at(Duration::ZERO)),
            uploaded: Duration::ZERO,
            spacing: controller.status_period(),
            ticks: 0,
            controller,
            started: Duration::ZERO,
            to_arm: line.clone(),
            from_arm: line,
            faults: None,
            now: Duration::ZERO,
            last_event: Duration::ZERO,
            recorder: None,
            #[cfg(feature = "world")]
            world: None,
            scratch: Vec::new(),
        }
    }

    /// Injects faults from power-up on; call it before any time passes. `power_up` is the configuration
    /// for every restart of the controller. The same faults with the same seed have the same effect.
    #[must_use]
    pub fn with_faults(mut self, power_up: PowerUp, faults: &[Fault], seed: u64) -> Self {
        let faults = FaultState::new(power_up, faults, seed, &mut self.mechanics);
        self.faults = Some(Box::new(faults));
        self.strike(Duration::ZERO);
        self
    }

    /// Replaces all faults; times, packets and statuses count from now. `power_up` is the configuration
    /// for every restart of the controller. Lost joint positions stay lost.
    ///
    /// # Errors
    ///
    /// Returns [`FaultError::NotNow`] for `zero=`, which must be set at power-up, and changes nothing.
    pub fn set_faults(
        &mut self,
        power_up: PowerUp,
        faults: &[Fault],
        seed: u64,
    ) -> Result<(), FaultError> {
        if let Some(zero) = faults.iter().find(|fault| fault.is_zero()) {
            return Err(FaultError::NotNow {
                fault: zero.to_string(),
            });
        }
        let now = self.now;
        let state = self
            .faults
            .get_or_insert_with(|| Box::new(FaultState::none(power_up)));
        state.end_all(now);
        self.strike(now);
        if let Some(state) = &mut self.faults {
            state.replace(now, &self.controller, faults, seed);
            state.schedule.fit_backlash(&mut self.mechanics);
        }
        self.strike(now);
        Ok(())
    }

    /// Records the tool pose from now on: at least once per `period` while it moves, and at every
    /// corner. At rest only the first and the last moment are recorded.
    pub fn record(&mut self, period: Duration) {
        self.recorder = Some(Recorder {
            period,
            samples: Vec::new(),
            rest: None,
        });
    }

    /// The recorded samples.
    #[must_use]
    pub fn samples(&self) -> &[Sample] {
        self.recorder
            .as_ref()
            .map_or(&[], |recorder| &recorder.samples)
    }

    /// The controller, whose time counts from its own first tick ([`VirtualArm::controller_time`]).
    #[must_use]
    pub const fn controller(&self) -> &Controller {
        &self.controller
    }

    /// The controller's own time, which starts again at every restart.
    #[must_use]
    pub const fn controller_time(&self, at: Duration) -> Duration {
        at.saturating_sub(self.started)
    }

    /// The machine with its true pose.
    #[must_use]
    pub const fn mechanics(&self) -> &Mechanics {
        &self.mechanics
    }

    /// The current time of the arm.
    #[must_use]
    pub const fn now(&self) -> Duration {
        self.now
    }

    /// Whether the arm's port is present.
    #[must_use]
    pub fn has_port(&self) -> bool {
        self.faults.as_ref().is_none_or(|faults| faults.has_port)
    }

    /// Handles the opening of the port by a client.
    pub fn handle_open(&mut self, now: Duration) {
        self.handle_time(now);
        if let Some(faults) = &mut self.faults {
            faults.schedule.handle_open(now);
            self.strike(now);
        }
    }

    /// Sends bytes to the arm; without a port they are lost.
    pub fn handle_bytes(&mut self, now: Duration, bytes: &[u8]) {
        self.handle_time(now);
        if self.has_port() {
            if now > self.started {
                // Ticks in which nothing happened may still be to be passed over.
                self.controller.handle_time(self.controller_time(now));
            }
            self.to_arm.send(now, bytes);
        }
    }

    /// Advances to `now`.
    pub fn handle_time(&mut self, now: Duration) {
        loop {
            let event = self.next_event();
            self.deliver(event.min(now));
            if event > now {
                break;
            }
            self.step(event);
        }
        self.now = self.now.max(now);
    }

    /// Takes the bytes received from the arm.
    pub fn poll_bytes(&mut self, bytes: &mut Vec<u8>) {
        self.judge(self.now);
        match &mut self.faults {
            None => {
                self.from_arm.receive(self.now, bytes);
            }
            Some(faults) => {
                let schedule = &mut faults.schedule;
                while let Some((_, byte)) = schedule.pop(LineDirection::FromArm, self.now) {
                    bytes.push(byte);
                }
            }
        }
    }

    /// The number of bytes to the arm that were lost because the line buffer was full.
    #[must_use]
    pub const fn lost_bytes(&self) -> u64 {
        self.to_arm.lost()
    }

    /// Takes the refusals since the last call.
    pub fn poll_refused(&mut self) -> Option<Refused> {
        self.controller.poll_refused()
    }

    /// Takes the next fault event; only the last few are kept.
    pub fn poll_struck(&mut self) -> Option<Struck> {
        self.faults.as_mut()?.schedule.poll_struck()
    }

    /// The time of the next event.
    #[must_use]
    pub fn poll_wakeup(&self) -> Duration {
        let event = self.next_event();
        self.next_bytes().map_or(event, |bytes| bytes.min(event))
    }

    /// The earliest time at which the host has bytes to pass on. Polling later than that is harmless.
    #[must_use]
    pub fn poll_delivery(&self) -> Duration {
        let bytes = self.next_bytes().unwrap_or_else(|| {
            let after_tick = self.next_tick().saturating_add(self.from_arm.packet_time());
            after_tick.max(self.uploaded + self.spacing + self.from_arm.packet_time())
        });
        bytes.min(self.poll_fault())
    }

    /// The next time at which a timed fault begins or ends.
    #[must_use]
    pub fn poll_fault(&self) -> Duration {
        let next = |it: &FaultState| it.schedule.poll_wakeup();
        self.faults.as_deref().map_or(Duration::MAX, next)
    }

    /// The arrival time of the bytes from the arm that are on the line.
    fn next_bytes(&self) -> Option<Duration> {
        let burst = self.from_arm.next_burst();
        let late = self.faults.as_ref().and_then(|faults| {
            let schedule = &faults.schedule;
            schedule.next_late(LineDirection::FromArm, self.now)
        });
        burst.into_iter().chain(late).min()
    }

    /// The time of the next event of the controller or a fault.
    fn next_event(&self) -> Duration {
        self.next_tick().min(self.poll_fault())
    }

    /// The next time needed by the controller: every tick while bytes are on the line, so that it gets
    /// each byte before the following tick.
    fn next_tick(&self) -> Duration {
        let wakeup = self.controller.poll_wakeup();
        let until_then = if self.is_spoken_to() {
            wakeup.min(TICK * self.controller.tick_count())
        } else {
            wakeup
        };
        self.started.saturating_add(until_then)
    }

    fn is_spoken_to(&self) -> bool {
        let late = |it: &FaultState| it.schedule.keeps(LineDirection::ToArm);
        self.to_arm.next_burst().is_some() || self.faults.as_deref().is_some_and(late)
    }

    /// Passes the bytes that arrive before `time` to the controller. A byte that arrives exactly at a
    /// control tick is too late for it. Bytes before the first tick are ignored.
    ///
    /// A controller may be busy at the start of a tick, so the time of each byte matters; for the rest
    /// of the tick it only matters that it arrives before the next.
    fn deliver(&mut self, time: Duration) {
        let before = time.saturating_sub(Duration::from_nanos(1));
        self.judge(before);
        let mut last = Duration::ZERO;
        while let Some((arrival, byte)) = self.next_byte(before) {
            if arrival < self.started {
                continue;
            }
            let arrival = self.controller_time(arrival);
            if arrival.subsec_nanos() % TICK.subsec_nanos() < BUSY.subsec_nanos() {
                self.controller.handle_bytes(arrival, &[byte]);
            } else {
                self.scratch.push(byte);
                last = arrival;
            }
        }
        if !self.scratch.is_empty() {
            self.controller.handle_bytes(last, &self.scratch);
            self.scratch.clear();
        }
    }

    fn next_byte(&mut self, before: Duration) -> Option<(Duration, u8)> {
        match &mut self.faults {
            None => self.to_arm.pop(before),
            Some(faults) => faults.schedule.pop(LineDirection::ToArm, before),
        }
    }

    /// Applies the faults to the received bytes before a fault begins or ends.
    fn judge(&mut self, by: Duration) {
        if let Some(faults) = &mut self.faults {
            let lines = [&mut self.to_arm, &mut self.from_arm];
            faults.schedule.judge(lines, by, faults.has_port);
        }
    }

    fn step(&mut self, event: Duration) {
        if let Some(recorder) = &mut self.recorder
            && event >= self.started
        {
            let [from, to] = [self.last_event, event].map(|time| time.saturating_sub(self.started));
            recorder.sample(&self.controller, self.started, from, to);
        }
        #[cfg(feature = "world")]
        self.go_through_world(event);
        self.last_event = event;
        self.now = event;
        self.strike(event);
        if self.next_tick() <= event {
            self.tick(event);
            self.strike(event);
        }
    }

    fn tick(&mut self, at: Duration) {
        self.controller.handle_time(at.saturating_sub(self.started));
        let withheld = |it: &FaultState| it.schedule.withholds();
        let withheld = self.faults.as_deref().is_some_and(withheld);
        while let Some(upload) = self.controller.poll_bytes() {
            if !withheld {
                let leaves = self.started.saturating_add(upload.at);
                if !self.uploaded.is_zero() {
                    self.spacing = self.spacing.min(leaves.saturating_sub(self.uploaded));
                }
                self.uploaded = leaves;
                self.from_arm.send(leaves, &upload.bytes);
            }
        }
        // Several ticks at once are ticks in which nothing moved.
        if self.controller.tick_count() > self.ticks {
            self.ticks = self.controller.tick_count();
            self.drive(at);
        }
    }

    /// Drives the machine with the outputs of the control tick.
    fn drive(&mut self, at: Duration) {
        let outputs = self.controller.outputs();
        let pulses = match &mut self.faults {
            None => outputs.pulses,
            Some(faults) => faults.schedule.make(outputs.pulses, at),
        };
        self.mechanics.handle_tick(at, pulses, outputs.head_servo);
    }

    /// Applies the due faults.
    fn strike(&mut self, at: Duration) {
        while let Some(faults) = &mut self.faults
            && let Some(order) = faults.handle_time(at, &self.controller)
        {
            match order {
                ArmOrder::ClosePort => faults.has_port = false,
                ArmOrder::AllowPort => faults.has_port = true,
                ArmOrder::Reset(_) if self.started == Duration::MAX => {}
                ArmOrder::Reset(tilt) => self.stop(at, tilt, at.saturating_add(START)),
                ArmOrder::PowerOff(tilt) => self.stop(at, tilt, Duration::MAX),
                ArmOrder::PowerOn => self.started = at.saturating_add(START),
            }
        }
    }

    /// Restarts the controller immediately, with no memory.
    fn stop(&mut self, at: Duration, tilt: Tilt, started: Duration) {
        self.mechanics.halt(at);
        self.from_arm.cut(at);
        if let Some(faults) = &mut self.faults {
            self.controller = faults.restart(at, &self.controller, &self.mechanics, tilt);
        }
        self.ticks = 0;
        self.started = started;
    }
}

impl Recorder {
    /// Samples the controller between two of its events, including the later one.
    fn sample(&mut self, controller: &Controller, started: Duration, from: Duration, to: Duration) {
        let mut at = from + self.period;
        while at < to {
            self.push(controller, started, at);
            at += self.period;
        }
        self.push(controller, started, to);
    }

    fn push(&mut self, controller: &Controller, started: Duration, at: Duration) {
        let sample = Sample {
            at: started.saturating_add(at),
            position: controller.pose_at(at).position,
            laser: controller.laser(),
        };
        let stands = self
            .samples
            .last()
            .is_some_and(|last| last.position == sample.position && last.laser == sample.laser);
        if stands {
            self.rest = Some(sample);
        } else {
            self.samples.extend(self.rest.take());
            self.samples.push(sample);
        }
    }
}

/// The longest calculation time in a tick (note N39).
const BUSY: Duration = Duration::from_millis(8);
/// The time from a reset or power-up to the first control tick: 1.3 s of the boot loader, which waits
/// for a new program, and 0.7 s of the firmware.
const START: Duration = Duration::from_secs(2);
