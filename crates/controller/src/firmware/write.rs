//! State 4 of the stock controller: writing and laser (note N48).

use dobot_wire::Frame;

use super::body::{Body, PERIOD_S};
use super::line::moved;
use super::settings::Settings;
use super::{Outcome, Progress};
use crate::outputs::short;

/// The vector that is being written, and the speed that the last one left.
#[derive(Debug, Default)]
pub(crate) struct Write {
    is_planned: bool,
    /// The end speed of the last vector that was completed.
    stored_speed: f32,
    /// What that will be once this one is.
    end_speed: f32,
    start: [f32; 3],
    vector: [f32; 3],
    length: f32,
    acceleration: f32,
    speed_change: f32,
    counts: Counts,
    speed: f32,
    /// How far the last tick went.
    step: f32,
    travelled: [f32; 3],
}

/// Ticks that accelerate, go on as fast, and decelerate.
#[derive(Clone, Copy, Debug, Default)]
struct Counts {
    up: i16,
    even: i16,
    down: i16,
}

impl Write {
    pub(crate) const fn clear(&mut self) {
        self.is_planned = false;
    }

    /// A tick of a vector.
    pub(crate) fn tick(
        &mut self,
        frame: &Frame,
        is_over: bool,
        settings: &Settings,
        body: &mut Body,
    ) -> Outcome {
        if is_over {
            return Outcome::OVER;
        }
        let is_laser = short(frame.float(2)) == LASER;
        let outcome = if frame.float(6) == 1.0 {
            body.hands.laser = false;
            Outcome::OVER
        } else {
            if !self.is_planned {
                self.plan(frame, settings, body);
                self.is_planned = true;
            }
            self.go(body)
        };
        if is_laser {
            body.hands.laser = frame.float(7) == 1.0;
        }
        outcome
    }

    fn plan(&mut self, frame: &Frame, settings: &Settings, body: &Body) {
        let f = |n| frame.float(n);
        let mode = short(f(2));
        if mode == WRITING || mode == LASER {
            self.vector = [-f(3), f(4), if mode == LASER { 0.0 } else { f(5) }];
            self.length = libm::sqrtf(f(3) * f(3) + f(4) * f(4) + f(5) * f(5));
            let is_rapid = mode == LASER && f(7) != 1.0;
            let factor = if is_rapid { RAPID_FACTOR } else { 1.0 };
            self.acceleration = factor * settings.write_acceleration;
        }
        self.start = [body.pose.x_mm, body.pose.y_mm, body.pose.z_mm];
        self.travelled = [0.0; 3];
        self.speed_change = self.acceleration * PERIOD_S;
        let max = f(10);
        let begin = if self.stored_speed > max {
            max
        } else {
            self.stored_speed
        };
        let end = if f(9) > max { max } else { f(9) };
        if self.length <= NO_LENGTH_MM {
            self.counts = Counts::default();
            self.end_speed = end;
        } else {
            self.plan_speeds(begin, end, max);
        }
    }

    fn plan_speeds(&mut self, begin: f32, end: f32, max: f32) {
        let change = self.speed_change;
        let (begin, up, down) = self.ramps(begin, end, max);
        let (ups, downs) = (f32::from(up), f32::from(down));
        let way_up = ups * (2.0 * begin + (ups - 1.0) * change) * 0.01;
        let way_down = if up > 0 {
            downs * (2.0 * begin + 2.0 * (ups - 1.0) * change - (downs - 1.0) * change) * 0.01
        } else {
            downs * (2.0 * begin - (downs + 1.0) * change) * 0.01
        };
        let top = begin + ups * change;
        let mut even = short(50.0 * (self.length - way_up - way_down) / top);
        if up.wrapping_add(even).wrapping_add(down) == 0 {
            even = 1;
        }
        let ticks = f32::from(up.wrapping_add(even).wrapping_add(down));
        let rest = self.length - (way_up + f32::from(even) * top * PERIOD_S + way_down);
        let correction = 50.0 * rest / ticks;
        let correction = if correction.abs() > change {
            change
        } else {
            correction
        };
        self.counts = Counts { up, even, down };
        self.speed = begin + correction;
        self.end_speed = correction
            + match (up > 0, down > 0) {
                (true, true) => begin + ups * change - downs * change,
                (false, false) => begin,
                (true, false) if even <= 0 => begin + (ups - 1.0) * change,
                (true, false) => begin + ups * change,
                (false, true) => begin - downs * change,
            };
    }

    /// The begin speed, and how many ticks accelerate and decelerate.
    fn ramps(&self, begin: f32, end: f32, max: f32) -> (f32, i16, i16) {
        let (length, acceleration) = (self.length, self.acceleration);
        let ticks = |change: f32| short(change / self.speed_change + 0.5);
        let full = (max * max - begin * begin / 2.0 - end * end / 2.0) / acceleration;
        if full <= length {
            return (begin, ticks(max - begin), ticks(max - end));
        }
        let least = (end * end - begin * begin) / (2.0 * acceleration);
        let is_rising = least >= 0.0;
        if length <= least.abs() {
            return if is_rising {
                let end = libm::sqrtf(2.0 * acceleration * length + begin * begin);
                (begin, ticks(end - begin), 0)
            } else {
                let begin = libm::sqrtf(2.0 * acceleration * length + end * end);
                (begin, 0, ticks(begin - end))
            };
        }
        if begin < 0.1 * max && end < 0.1 * max {
            let peak = libm::sqrtf(acceleration * length + begin * begin / 2.0 + end * end / 2.0);
            (begin, ticks(peak - begin), ticks(peak - end))
        } else if is_rising {
            (begin, ticks(end - begin), 0)
        } else {
            (begin, 0, ticks(begin - end))
        }
    }

    /// One tick further. With all ticks used up the vector is over in that same tick, and the next
    /// one moves in the next.
    fn go(&mut self, body: &mut Body) -> Outcome {
        let counts = &mut self.counts;
        if counts.up > 0 {
            counts.up -= 1;
            self.step = self.speed * PERIOD_S;
            self.speed += self.speed_change;
        } else if counts.even > 0 {
            counts.even -= 1;
            self.step = self.speed * PERIOD_S;
        } else if counts.down > 0 {
            counts.down -= 1;
            self.speed -= self.speed_change;
            self.step = self.speed * PERIOD_S;
        }
        let is_last = counts.up <= 0 && counts.even <= 0 && counts.down <= 0;
        for (travelled, part) in self.travelled.iter_mut().zip(self.vector) {
            *travelled += part * self.step / self.length;
        }
        let to = moved(self.start, self.travelled, body.pose.rotation_deg);
        if Progress::of(body.advance_to(to)) == Progress::CutShort {
            return Outcome::over(false);
        }
        if is_last {
            self.stored_speed = self.end_speed;
            return Outcome::OVER;
        }
        Outcome::GOES_ON
    }
}

const WRITING: i16 = 0;
const LASER: i16 = 1;
/// With the laser off the laser mode accelerates that much faster.
const RAPID_FACTOR: f32 = 100.0;
/// A vector of that length or less is not planned.
const NO_LENGTH_MM: f32 = 0.0001;
