//! A controller at the end of a serial line.

use std::time::Duration;

use dobot_arm::{Position, TICK};
use dobot_controller::{Controller, PowerUp, Refused};

use crate::faults::{ArmOrder, FaultState, LineDirection, Tilt};
use crate::world::{Actuators, Happened, World};
use crate::{Fault, FaultError, Mechanics, SerialLine, Struck};

/// A controller at the end of a serial line, as an engine: it owns no port and no clock.
#[derive(Debug)]
pub struct VirtualArm {
    controller: Controller,
    /// When the controller's first tick was or will be; `Duration::MAX` while the power is cut.
    started: Duration,
    mechanics: Mechanics,
    /// When the last status left, and the shortest time between two so far.
    uploaded: Duration,
    spacing: Duration,
    /// Control ticks that the machine has seen.
    ticks: u32,
    to_arm: SerialLine,
    from_arm: SerialLine,
    faults: Option<Box<FaultState>>,
    now: Duration,
    /// When something last happened: up to then the way is recorded.
    last_event: Duration,
    recorder: Option<Recorder>,
    world: Option<Box<World>>,
    scratch: Vec<u8>,
}

/// Where the tool was, as far as the controller knows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// When, since power-up.
    pub at: Duration,
    /// Where the tool was.
    pub position: Position,
    /// Whether the laser was on, on the way here.
    pub laser: bool,
}

#[derive(Debug)]
struct Recorder {
    period: Duration,
    samples: Vec<Sample>,
    /// The last sample that says the same as the one before: a motion begins there.
    rest: Option<Sample>,
}

impl VirtualArm {
    /// Puts a controller at the end of a line.
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
            world: None,
            scratch: Vec::new(),
        }
    }

    /// Lets things go wrong, from power-up on: call it before any time passes. The controller was
    /// switched on with `power_up`, and will be again. The same faults with the same seed do the
    /// same.
    #[must_use]
    pub fn with_faults(mut self, power_up: PowerUp, faults: &[Fault], seed: u64) -> Self {
        let faults = FaultState::new(power_up, faults, seed, &mut self.mechanics);
        self.faults = Some(Box::new(faults));
        self.strike(Duration::ZERO);
        self
    }

    /// Puts the arm into a world, which from then on feels what its tool does.
    #[must_use]
    pub fn with_world(mut self, world: World) -> Self {
        self.world = Some(Box::new(world));
        self.feel(self.now);
        self
    }

    /// Puts it into another world, as it stands: what its tool holds or marked is gone.
    pub fn set_world(&mut self, world: World) {
        self.world = Some(Box::new(world));
        self.feel(self.now);
    }

    /// Lets other things go wrong from now on, and nothing else any more: times, packets and statuses count from now.
    /// `power_up` is how the controller was switched on, and will be again. A joint that was lost stays so.
    ///
    /// # Errors
    ///
    /// [`FaultError::NotNow`] for `zero=`, which has to be there from power-up; nothing has changed then.
    pub fn set_faults(
        &mut self,
        power_up: PowerUp,
        faults: &[Fault],
        seed: u64,
    ) -> Result<(), FaultError> {
        if let Some(zero) = faults.iter().find(|it| it.is_zero()) {
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

    /// The world around it, if it has one.
    #[must_use]
    pub fn world(&self) -> Option<&World> {
        self.world.as_deref()
    }

    /// What happened in the world since the last call.
    pub fn poll_world(&mut self) -> Option<Happened> {
        self.world.as_mut()?.poll_event()
    }

    /// Records from now on where the tool is: at least once in `period` while it moves, and at
    /// every corner. While it stands only the first and the last moment are recorded.
    pub fn record(&mut self, period: Duration) {
        self.recorder = Some(Recorder {
            period,
            samples: Vec::new(),
            rest: None,
        });
    }

    /// What was recorded.
    #[must_use]
    pub fn samples(&self) -> &[Sample] {
        self.recorder.as_ref().map_or(&[], |it| &it.samples)
    }

    /// The controller, whose time counts from its own first tick ([`VirtualArm::controller_time`]).
    #[must_use]
    pub const fn controller(&self) -> &Controller {
        &self.controller
    }

    /// What the time is for the controller: after a start anew it began again.
    #[must_use]
    pub const fn controller_time(&self, at: Duration) -> Duration {
        at.saturating_sub(self.started)
    }

    /// The machine, and where it really is.
    #[must_use]
    pub const fn mechanics(&self) -> &Mechanics {
        &self.mechanics
    }

    /// The time that it has come to.
    #[must_use]
    pub const fn now(&self) -> Duration {
        self.now
    }

    /// Whether the arm's port is there, to be opened or open.
    #[must_use]
    pub fn has_port(&self) -> bool {
        self.faults.as_ref().is_none_or(|it| it.has_port)
    }

    /// Takes that a client opens the port.
    pub fn handle_open(&mut self, now: Duration) {
        self.handle_time(now);
        if let Some(faults) = &mut self.faults {
            faults.schedule.handle_open(now);
            self.strike(now);
        }
    }

    /// Takes bytes that start travelling to the arm; without a port they are lost.
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

    /// Takes the passing of time.
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

    /// Takes the bytes that have arrived from the arm by now.
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

    /// How many bytes to the arm were lost, because too many waited on the line.
    #[must_use]
    pub const fn lost_bytes(&self) -> u64 {
        self.to_arm.lost()
    }

    /// What the controller refused since the last call.
    pub fn poll_refused(&mut self) -> Option<Refused> {
        self.controller.poll_refused()
    }

    /// Which fault struck since the last call; only the last few are kept.
    pub fn poll_struck(&mut self) -> Option<Struck> {
        self.faults.as_mut()?.schedule.poll_struck()
    }

    /// When something next happens.
    #[must_use]
    pub fn poll_wakeup(&self) -> Duration {
        let event = self.next_event();
        self.next_bytes().map_or(event, |it| it.min(event))
    }

    /// When the host next has bytes to pass on, as far as can be told now; until then nothing is
    /// to be done. The arm may be looked at later than that without harm.
    #[must_use]
    pub fn poll_delivery(&self) -> Duration {
        let bytes = self.next_bytes().unwrap_or_else(|| {
            let after_tick = self.next_tick().saturating_add(self.from_arm.packet_time());
            after_tick.max(self.uploaded + self.spacing + self.from_arm.packet_time())
        });
        bytes.min(self.poll_fault())
    }

    /// When a fault next begins or ends at a time.
    #[must_use]
    pub fn poll_fault(&self) -> Duration {
        let next = |it: &FaultState| it.schedule.poll_wakeup();
        self.faults.as_deref().map_or(Duration::MAX, next)
    }

    /// When the bytes that are on their way from the arm have arrived.
    fn next_bytes(&self) -> Option<Duration> {
        let burst = self.from_arm.next_burst();
        let late = self.faults.as_ref().and_then(|faults| {
            let schedule = &faults.schedule;
            schedule.next_late(LineDirection::FromArm, self.now)
        });
        burst.into_iter().chain(late).min()
    }

    /// When the controller or a fault next does something.
    fn next_event(&self) -> Duration {
        self.next_tick().min(self.poll_fault())
    }

    /// When the controller next wants the time: while bytes travel to it at each tick, so that it
    /// gets each byte before the first tick after it.
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

    /// Gives the controller the bytes that arrive before `time`: one that arrives in the very
    /// instant of a control tick is too late for it. One that arrives before the first tick meets
    /// a deaf controller.
    ///
    /// At the beginning of a tick a controller may be busy, so that it matters when each byte
    /// comes; for the rest of the tick only that it comes before the next.
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

    /// Lets the faults judge the bytes that have arrived, before one of them begins or ends.
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
            let [from, to] = [self.last_event, event].map(|it| it.saturating_sub(self.started));
            recorder.sample(&self.controller, self.started, from, to);
        }
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

    /// Lets the world feel the way since the last event: the machine stands still from a tick
    /// after that at the latest.
    fn go_through_world(&mut self, to: Duration) {
        let tick_over = self.last_event + TICK;
        if tick_over < to {
            self.feel(tick_over);
        }
        self.feel(to);
    }

    /// Tells the world where the arm really is, and what acted at its tool since it was told last.
    fn feel(&mut self, at: Duration) {
        if let Some(world) = &mut self.world {
            let outputs = self.controller.outputs();
            let actuators = Actuators {
                pump: outputs.pump,
                laser: self.controller.laser_at_motors(),
                gripper_deg: (f64::from(outputs.gripper_servo) - 500.0) * 0.18,
            };
            world.handle_arm(at, &self.mechanics.joints_at(at), actuators);
        }
    }

    /// Drives the machine with what the control tick sent.
    fn drive(&mut self, at: Duration) {
        let outputs = self.controller.outputs();
        let pulses = match &mut self.faults {
            None => outputs.pulses,
            Some(faults) => faults.schedule.make(outputs.pulses, at),
        };
        self.mechanics.handle_tick(at, pulses, outputs.head_servo);
    }

    /// Does what the faults of this moment want.
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

    /// Stops in the middle of whatever it does; a controller takes over that knows nothing.
    fn stop(&mut self, at: Duration, tilt: Tilt, started: Duration) {
        self.mechanics.halt(at);
        self.from_arm.cut(at);
        if let Some(faults) = &mut self.faults {
            self.controller = faults.start_anew(at, &self.controller, &self.mechanics, tilt);
        }
        self.ticks = 0;
        self.started = started;
    }
}

impl Recorder {
    /// Samples the controller between two of its events, the later one included.
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

/// After that much of a tick no controller calculates any more (note N39).
const BUSY: Duration = Duration::from_millis(8);
/// From a reset or the return of the power to the first control tick: 1.3 s of its loader, which
/// waits for a new program, and 0.7 s of its own.
const START: Duration = Duration::from_secs(2);
