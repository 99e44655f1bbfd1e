//! The engine: time, ticks and statuses. A program defines what a tick does.

use core::time::Duration;

use dobot_arm::{Joints, Pose, TICK};
use dobot_wire::{Dialect, Frame};

use crate::firmware::Firmware;
use crate::log::{Counters, Log};
use crate::outputs::{Hands, Outputs, Steppers};
use crate::specification::Specification;
use crate::upload::{StatusSchedule, Upload, Uploads};
use crate::{Personality, Port, PowerUp, Refused};

/// The controller of an arm, as an engine: it owns no port, no thread and no clock.
///
/// It takes events (`handle_*`), returns outputs (`poll_*`), and [`Controller::poll_wakeup`] returns
/// the next time it needs. Time counts from power-up and never decreases. Calling
/// [`Controller::handle_time`] later gives the same results, but fetch the statuses at least every
/// second, or the oldest are lost.
#[derive(Debug)]
pub struct Controller {
    program: Program,
    /// The number of the next control tick and its due time.
    tick: u32,
    next_tick: Duration,
    /// The number of consecutive ticks without motion and without waiting commands.
    ticks_at_rest: u8,
    schedule: StatusSchedule,
    steppers: Steppers,
    outputs: Outputs,
    /// Whether the laser was on in the previous outputs.
    laser_before: bool,
    uploads: Uploads,
    log: Log,
}

/// The program of a personality.
#[derive(Debug)]
enum Program {
    Specification(Specification),
    Firmware(Firmware),
}

impl Controller {
    /// Creates a controller at power-up.
    #[must_use]
    pub fn power_up(power_up: PowerUp) -> Self {
        Self::speaking(&power_up.personality.dialect(), &power_up)
    }

    fn speaking(dialect: &Dialect, power_up: &PowerUp) -> Self {
        let (program, port) = match power_up.personality {
            Personality::Specification => {
                let program = Specification::power_up(power_up);
                (Program::Specification(program), Port::Usb)
            }
            Personality::Firmware11 => {
                let program = Firmware::power_up(power_up);
                (Program::Firmware(program), power_up.port)
            }
        };
        let outputs = Outputs::new([0; 3], program.hands());
        Self {
            program,
            tick: 0,
            next_tick: Duration::ZERO,
            ticks_at_rest: 0,
            schedule: StatusSchedule::new(port, dialect.status_period()),
            steppers: Steppers::default(),
            outputs,
            laser_before: outputs.laser,
            uploads: Uploads::default(),
            log: Log::default(),
        }
    }

    /// Handles bytes from the client that arrive at `now`. They take effect from the next tick on.
    pub fn handle_bytes(&mut self, now: Duration, bytes: &[u8]) {
        self.handle_time(now);
        self.ticks_at_rest = 0;
        match &mut self.program {
            Program::Specification(it) => it.handle_bytes(bytes, &mut self.log),
            Program::Firmware(it) => it.handle_bytes(now, bytes, &mut self.log),
        }
    }

    /// Advances to `now`.
    pub fn handle_time(&mut self, now: Duration) {
        while self.next_event() <= now {
            self.rest_until(now);
            // No tick is left to skip.
            let at = self.next_event();
            if at > now {
                return;
            }
            if let Program::Specification(it) = &mut self.program {
                it.handle_time(at, &mut self.log);
            }
            if self.next_tick <= at {
                self.tick(at);
            }
        }
    }

    /// Returns the next status to send, if one is due.
    pub fn poll_bytes(&mut self) -> Option<Upload> {
        self.uploads.pop()
    }

    /// Returns the next byte of the text printed on the unused port (note N39).
    pub fn poll_other_port(&mut self) -> Option<u8> {
        match &mut self.program {
            Program::Specification(_) => None,
            Program::Firmware(it) => it.poll_other_port(),
        }
    }

    /// Returns the oldest refusal; only the last few are kept.
    pub fn poll_refused(&mut self) -> Option<Refused> {
        self.log.poll_refused()
    }

    /// The time at which to call [`Controller::handle_time`] next.
    #[must_use]
    pub fn poll_wakeup(&self) -> Duration {
        match self.ticks_to_rest() {
            0 => self.next_event(),
            ticks => self.next_event() + TICK * ticks,
        }
    }

    /// The commanded pose at a time between now and the next wakeup.
    #[must_use]
    pub fn pose_at(&self, at: Duration) -> Pose {
        match &self.program {
            Program::Specification(it) => it.pose_at(at),
            Program::Firmware(it) => it.pose_at(self.tick_share(at)),
        }
    }

    /// The commanded joint angles at a time between now and the next wakeup.
    #[must_use]
    pub fn joints_at(&self, at: Duration) -> Joints {
        match &self.program {
            Program::Specification(it) => it.joints_at(at),
            Program::Firmware(it) => it.joints_at(self.tick_share(at)),
        }
    }

    /// The status period while there is room in the queue.
    #[must_use]
    pub const fn status_period(&self) -> Duration {
        self.schedule.period()
    }

    /// The outputs of the last control tick.
    #[must_use]
    pub const fn outputs(&self) -> Outputs {
        self.outputs
    }

    /// Pulses sent to the motors since power-up: base, rear arm, forearm, with the signs of
    /// [`STEPS_PER_DEG`](crate::STEPS_PER_DEG).
    #[must_use]
    pub const fn steps(&self) -> [i64; 3] {
        self.steppers.sent()
    }

    /// The number of control ticks since power-up; tick n, counted from 0, is due at n times 20 ms.
    #[must_use]
    pub const fn tick_count(&self) -> u32 {
        self.tick
    }

    /// Whether the pump of the suction cup is on.
    #[must_use]
    pub fn suction(&self) -> bool {
        self.program.hands().pump
    }

    /// Whether the laser is on.
    #[must_use]
    pub fn laser(&self) -> bool {
        self.program.hands().laser
    }

    /// Whether the laser is on while the motors make the pulses of the last
    /// [`outputs`](Self::outputs). A stock arm switches it immediately, a tick before the motors start
    /// the command that switched it (note N48). The motors of an ideal arm lag two ticks behind its
    /// pose, and so does the burn of its laser, to within a tick.
    #[must_use]
    pub fn laser_at_motors(&self) -> bool {
        match &self.program {
            Program::Specification(_) => self.laser_before,
            Program::Firmware(_) => self.laser(),
        }
    }

    /// The counters since power-up.
    #[must_use]
    pub const fn counters(&self) -> &Counters {
        &self.log.counters
    }

    /// The time of the next tick, or of an earlier end of a motion.
    fn next_event(&self) -> Duration {
        match &self.program {
            Program::Specification(it) => it
                .wakeup()
                .map_or(self.next_tick, |wakeup| wakeup.min(self.next_tick)),
            Program::Firmware(_) => self.next_tick,
        }
    }

    /// The elapsed fraction of the last tick, from 0 to 1.
    fn tick_share(&self, at: Duration) -> f64 {
        let since = at.saturating_sub(self.next_tick.saturating_sub(TICK));
        (since.as_secs_f64() / TICK.as_secs_f64()).min(1.0)
    }

    /// The number of coming ticks without effect, as long as no byte arrives.
    const fn ticks_to_rest(&self) -> u32 {
        if self.ticks_at_rest < SETTLES_AFTER {
            0
        } else {
            self.schedule.silent_ticks()
        }
    }

    /// Skips the due ticks that have no effect.
    fn rest_until(&mut self, now: Duration) {
        if self.ticks_at_rest < SETTLES_AFTER {
            return;
        }
        for _ in 0..self.ticks_to_rest() {
            let at = self.next_tick;
            if at > now {
                return;
            }
            self.tick += 1;
            self.next_tick += TICK;
            self.schedule.tick(0);
            if let Program::Firmware(it) = &mut self.program {
                it.rest(at);
            }
        }
    }

    fn tick(&mut self, at: Duration) {
        self.tick += 1;
        self.next_tick += TICK;
        self.laser_before = self.outputs.laser;
        self.outputs = Outputs::new(self.steppers.exchange(), self.program.hands());
        let may_send = self.schedule.silent_ticks() == 0;
        let (waiting, motion_deg, repeats) = match &mut self.program {
            Program::Specification(specification) => {
                specification.tick(at, &mut self.log);
                (
                    specification.waiting(),
                    specification.take_motion_deg(),
                    false,
                )
            }
            Program::Firmware(firmware) => {
                firmware.tick(at, may_send, &mut self.log);
                let repeats = firmware.take_repeats();
                (firmware.waiting(), firmware.take_motion_deg(), repeats)
            }
        };
        self.turn_motors(motion_deg, repeats);
        if let Some(add_to_x_mm) = self.schedule.tick(waiting) {
            self.upload(at, add_to_x_mm);
        }
    }

    /// Passes a tick's motion to the motors, or the last one again.
    fn turn_motors(&mut self, motion_deg: [f32; 3], repeats: bool) {
        if repeats {
            self.ticks_at_rest = 0;
            self.steppers.repeat();
        } else if motion_deg == [0.0; 3] {
            let ticks = self.ticks_at_rest.saturating_add(1);
            self.ticks_at_rest = if self.program.is_at_rest() { ticks } else { 0 };
        } else {
            self.ticks_at_rest = 0;
            self.steppers.turn(motion_deg);
        }
    }

    fn upload(&mut self, at: Duration, add_to_x_mm: f32) {
        let (status, delay) = self.program.status();
        let upload = Upload {
            at: at + delay,
            bytes: status.with(1, status.float(1) + add_to_x_mm).to_bytes(),
        };
        self.uploads.push(upload, &mut self.log);
    }
}

impl Program {
    fn hands(&self) -> Hands {
        match self {
            Self::Specification(it) => it.hands(),
            Self::Firmware(it) => it.hands(),
        }
    }

    fn is_at_rest(&self) -> bool {
        match self {
            Self::Specification(it) => it.is_at_rest(),
            Self::Firmware(it) => it.is_at_rest(),
        }
    }

    /// The status and its delay after the tick.
    fn status(&self) -> (Frame, Duration) {
        match self {
            Self::Specification(it) => (it.status(), Duration::ZERO),
            Self::Firmware(firmware) => (firmware.status(), firmware.status_delay()),
        }
    }
}

/// After this many ticks without motion, all pulses are sent and the outputs are constant.
const SETTLES_AFTER: u8 = 3;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_status_period_is_kept_even_if_it_is_not_a_whole_number_of_ticks() {
        let mut dialect = Dialect::FIRMWARE_1_1;
        dialect.status_period_ms = 50;
        for step_ms in [1, 1000] {
            let power_up = PowerUp::new(Personality::Firmware11);
            let mut controller = Controller::speaking(&dialect, &power_up);
            let mut came = 0;
            for now_ms in (0..10_000).step_by(step_ms) {
                controller.handle_time(Duration::from_millis(now_ms));
                came += core::iter::from_fn(|| controller.poll_bytes()).count();
            }
            let all = if step_ms == 1 { 200 } else { 180 };
            assert_eq!(came, all, "in steps of {step_ms} ms");
        }
    }
}
