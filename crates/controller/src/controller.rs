//! The engine: time, ticks and statuses; what a tick does is the business of a program.

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
/// Things happen to it (`handle_*`), it wants things (`poll_*`), and [`Controller::poll_wakeup`]
/// says when it next needs the time, which counts from power-up and never goes back. Who calls
/// [`Controller::handle_time`] later than that gets all the same results, but has to fetch the
/// statuses at least every second, else the oldest are lost.
#[derive(Debug)]
pub struct Controller {
    program: Program,
    /// The number of the next control tick, and when it is due.
    tick: u32,
    next_tick: Duration,
    /// How many ticks in a row nothing moved and nothing waited.
    ticks_at_rest: u8,
    schedule: StatusSchedule,
    steppers: Steppers,
    outputs: Outputs,
    /// Whether the laser was on in the outputs before.
    laser_before: bool,
    uploads: Uploads,
    log: Log,
}

/// What the two personalities do differently.
#[derive(Debug)]
enum Program {
    Specification(Specification),
    Firmware(Firmware),
}

impl Controller {
    /// Switches a controller on.
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

    /// Takes bytes from the client that arrive at `now`, one after the other. What they say is done
    /// from the next tick on.
    pub fn handle_bytes(&mut self, now: Duration, bytes: &[u8]) {
        self.handle_time(now);
        self.ticks_at_rest = 0;
        match &mut self.program {
            Program::Specification(it) => it.handle_bytes(bytes, &mut self.log),
            Program::Firmware(it) => it.handle_bytes(now, bytes, &mut self.log),
        }
    }

    /// Takes the passing of time.
    pub fn handle_time(&mut self, now: Duration) {
        while self.next_event() <= now {
            self.rest_until(now);
            // No tick is left that could be passed over.
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

    /// The status to send next, if one is due.
    pub fn poll_bytes(&mut self) -> Option<Upload> {
        self.uploads.pop()
    }

    /// The next byte of what is printed on the port that is not served (note N39).
    pub fn poll_other_port(&mut self) -> Option<u8> {
        match &mut self.program {
            Program::Specification(_) => None,
            Program::Firmware(it) => it.poll_other_port(),
        }
    }

    /// What was refused, the oldest first; only the last few are kept.
    pub fn poll_refused(&mut self) -> Option<Refused> {
        self.log.poll_refused()
    }

    /// When [`Controller::handle_time`] wants to be called next.
    #[must_use]
    pub fn poll_wakeup(&self) -> Duration {
        match self.ticks_to_rest() {
            0 => self.next_event(),
            ticks => self.next_event() + TICK * ticks,
        }
    }

    /// Where the tool is told to be at a time between now and the next wakeup.
    #[must_use]
    pub fn pose_at(&self, at: Duration) -> Pose {
        match &self.program {
            Program::Specification(it) => it.pose_at(at),
            Program::Firmware(it) => it.pose_at(self.tick_share(at)),
        }
    }

    /// The joint angles that are told to the motors for a time between now and the next wakeup.
    #[must_use]
    pub fn joints_at(&self, at: Duration) -> Joints {
        match &self.program {
            Program::Specification(it) => it.joints_at(at),
            Program::Firmware(it) => it.joints_at(self.tick_share(at)),
        }
    }

    /// From one status to the next while there is room in the queue.
    #[must_use]
    pub const fn status_period(&self) -> Duration {
        self.schedule.period()
    }

    /// What the last control tick told the machine.
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

    /// How many control ticks have been; tick n, counted from 0, is due at n times 20 ms.
    #[must_use]
    pub const fn tick_count(&self) -> u32 {
        self.tick
    }

    /// Whether the suction cup's pump runs.
    #[must_use]
    pub fn suction(&self) -> bool {
        self.program.hands().pump
    }

    /// Whether the laser is on.
    #[must_use]
    pub fn laser(&self) -> bool {
        self.program.hands().laser
    }

    /// Whether the laser is on while the motors make the pulses of the last [`outputs`](Self::outputs): a stock arm switches it at
    /// once, a tick before the motors begin what switched it (note N48). The motors of an ideal arm are two ticks behind its pose, and
    /// so is what its laser burns, to a tick.
    #[must_use]
    pub fn laser_at_motors(&self) -> bool {
        match &self.program {
            Program::Specification(_) => self.laser_before,
            Program::Firmware(_) => self.laser(),
        }
    }

    /// What it has counted.
    #[must_use]
    pub const fn counters(&self) -> &Counters {
        &self.log.counters
    }

    /// The next tick, or the end of a motion before it.
    fn next_event(&self) -> Duration {
        match &self.program {
            Program::Specification(it) => it
                .wakeup()
                .map_or(self.next_tick, |it| it.min(self.next_tick)),
            Program::Firmware(_) => self.next_tick,
        }
    }

    /// How much of the last tick's time has passed, from 0 to 1.
    fn tick_share(&self, at: Duration) -> f64 {
        let since = at.saturating_sub(self.next_tick.saturating_sub(TICK));
        (since.as_secs_f64() / TICK.as_secs_f64()).min(1.0)
    }

    /// How many ticks from now on change nothing and send nothing, as long as nothing arrives.
    const fn ticks_to_rest(&self) -> u32 {
        if self.ticks_at_rest < SETTLES_AFTER {
            0
        } else {
            self.schedule.silent_ticks()
        }
    }

    /// Passes over such ticks, as many as are due.
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
        let may_tell = self.schedule.silent_ticks() == 0;
        let (waiting, way_deg, repeats) = match &mut self.program {
            Program::Specification(it) => {
                it.tick(at, &mut self.log);
                (it.waiting(), it.take_way_deg(), false)
            }
            Program::Firmware(it) => {
                it.tick(at, may_tell, &mut self.log);
                let repeats = it.take_repeats();
                (it.waiting(), it.take_way_deg(), repeats)
            }
        };
        if repeats {
            self.ticks_at_rest = 0;
            self.steppers.repeat();
        } else if way_deg == [0.0; 3] {
            let ticks = self.ticks_at_rest.saturating_add(1);
            self.ticks_at_rest = if self.program.is_at_rest() { ticks } else { 0 };
        } else {
            self.ticks_at_rest = 0;
            self.steppers.turn(way_deg);
        }
        if let Some(add_to_x_mm) = self.schedule.tick(waiting) {
            self.upload(at, add_to_x_mm);
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

    /// The status, and how long after its tick it leaves.
    fn status(&self) -> (Frame, Duration) {
        match self {
            Self::Specification(it) => (it.status(), Duration::ZERO),
            Self::Firmware(it) => (it.status(), it.status_delay()),
        }
    }
}

/// After so many ticks without motion the last pulses are out, and all outputs are as they stay.
const SETTLES_AFTER: u8 = 3;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_status_comes_as_often_as_the_dialect_says_even_if_that_is_no_whole_number_of_ticks() {
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
