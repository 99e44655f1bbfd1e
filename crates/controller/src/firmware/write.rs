//! State 4 of the stock controller: writing and laser (note N48).

use dobot_arm::stock::short;
use dobot_motion::{TickProgress, TickStroke};
use dobot_wire::Frame;

use super::TickOutcome;
use super::body::Body;
use super::line::moved;
use super::settings::StockSettings;
use crate::Hang;

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
    progress: TickProgress,
    /// What the next tick will make of it, calculated a tick ahead.
    next: Option<TickProgress>,
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
        settings: &StockSettings,
        body: &mut Body,
    ) -> TickOutcome {
        if is_over {
            return TickOutcome::OVER;
        }
        let is_laser = short(frame.float(2)) == LASER;
        let outcome = if frame.float(6) == 1.0 {
            body.hands.laser = false;
            TickOutcome::OVER
        } else {
            if !self.is_planned {
                self.plan(frame, settings, body);
                self.is_planned = true;
            }
            self.go(body)
        };
        if is_laser && let Some(lit) = lit(frame) {
            body.hands.laser = lit;
        }
        outcome
    }

    fn plan(&mut self, frame: &Frame, settings: &StockSettings, body: &Body) {
        let f = |n| frame.float(n);
        let mode = short(f(2));
        if mode == WRITING || mode == LASER {
            self.vector = [-f(3), f(4), if mode == LASER { 0.0 } else { f(5) }];
            self.length = libm::sqrtf(f(3) * f(3) + f(4) * f(4) + f(5) * f(5));
            let factor = match lit(frame) {
                _ if mode == WRITING => Some(1.0),
                Some(lit) => Some(if lit { 1.0 } else { RAPID_FACTOR }),
                None => None,
            };
            if let Some(factor) = factor {
                self.acceleration = factor * settings.write_acceleration;
            }
        }
        self.start = [body.pose.x_mm, body.pose.y_mm, body.pose.z_mm];
        self.next = None;
        let (end, max) = (f(9), f(10));
        if self.length <= NO_LENGTH_MM {
            self.progress.begin(None);
            self.end_speed = if end > max { max } else { end };
            return;
        }
        let tick_stroke =
            TickStroke::of(self.length, self.stored_speed, end, max, self.acceleration);
        self.progress.begin(Some(&tick_stroke));
        self.speed_change = tick_stroke.change_mm_s;
        self.end_speed = tick_stroke.end_mm_s;
    }

    /// One tick further. With all ticks used up the vector is over in that same tick, and the next
    /// one moves in the next.
    fn go(&mut self, body: &mut Body) -> TickOutcome {
        self.progress = self.next.unwrap_or_else(|| self.step(self.progress));
        let left = self.progress.ticks_left();
        self.next = (left != 0).then(|| self.step(self.progress));
        let place = |it: &TickProgress| moved(self.start, it.travelled_mm());
        if !body.advance_along(place(&self.progress), self.next.as_ref().map(place)) {
            return TickOutcome::over(false);
        }
        if left == 0 {
            self.stored_speed = self.end_speed;
            return TickOutcome::OVER;
        }
        TickOutcome::hangs_if(left < 0, Hang::NeverArrives)
    }

    /// A tick further.
    fn step(&self, progress: TickProgress) -> TickProgress {
        progress.tick(self.vector, self.length, self.speed_change)
    }
}

/// Whether a packet wants the laser lit; where it says neither all stays as it was.
fn lit(frame: &Frame) -> Option<bool> {
    match frame.float(7) {
        1.0 => Some(true),
        0.0 => Some(false),
        _ => None,
    }
}

const WRITING: i16 = 0;
const LASER: i16 = 1;
/// With the laser off the laser mode accelerates that much faster.
const RAPID_FACTOR: f32 = 100.0;
/// A vector of that length or less is not planned.
const NO_LENGTH_MM: f32 = 0.0001;
