//! State 4 of the stock controller: writing and laser (note N48).

use dobot_motion::{TickProgress, TickStroke};
use dobot_wire::Frame;

use super::TickOutcome;
use super::body::Body;
use super::line::moved;
use super::settings::StockSettings;
use crate::Hang;

/// The current vector and the end speed of the last one.
#[derive(Debug, Default)]
pub(crate) struct Write {
    /// The end speed of the last vector that was completed.
    stored_speed: f32,
    /// The end speed of the current vector.
    end_speed: f32,
    vector: [f32; 3],
    length: f32,
    acceleration: f32,
    speed_change: f32,
    progress: TickProgress,
    /// What the next tick will make of it, calculated a tick ahead.
    next: Option<TickProgress>,
}

impl Write {
    /// Runs a tick of a vector.
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
        if !body.is_planned {
            self.plan(frame, settings, body);
        }
        let outcome = if frame.float(6) == 1.0 {
            body.hands.laser = false;
            TickOutcome::OVER
        } else {
            self.go(body)
        };
        if frame.float(2) == LASER
            && let Some(lit) = lit(frame)
        {
            body.hands.laser = lit;
        }
        outcome
    }

    fn plan(&mut self, frame: &Frame, settings: &StockSettings, body: &mut Body) {
        let f = |n| frame.float(n);
        let (z, factor) = self.z_and_factor(frame);
        self.vector = [-f(3), f(4), z];
        self.length = libm::sqrtf(f(3) * f(3) + f(4) * f(4) + f(5) * f(5));
        if let Some(factor) = factor {
            self.acceleration = factor * settings.write_acceleration;
        }
        body.begin();
        body.is_planned = true;
        self.next = None;
        let (end, max) = (f(9), f(10));
        // NaN is not above it.
        if self.length > NO_LENGTH_MM {
            let stroke =
                TickStroke::of(self.length, self.stored_speed, end, max, self.acceleration);
            self.progress.begin(Some(&stroke));
            self.speed_change = stroke.change_mm_s;
            self.end_speed = stroke.end_mm_s;
        } else {
            self.progress.begin(None);
            self.end_speed = if end > max { max } else { end };
        }
    }

    /// The z component of a vector, and the factor of its acceleration. In another mode the vector keeps
    /// z and acceleration of the previous one.
    fn z_and_factor(&self, frame: &Frame) -> (f32, Option<f32>) {
        let [_, _, z_before] = self.vector;
        match (frame.float(2), lit(frame)) {
            (WRITING, _) => (frame.float(5), Some(1.0)),
            (LASER, Some(lit)) => (0.0, Some(if lit { 1.0 } else { RAPID_FACTOR })),
            (LASER, None) => (0.0, None),
            _ => (z_before, None),
        }
    }

    /// Advances by one tick. The vector ends in its last tick, and the next one moves in the following
    /// tick.
    fn go(&mut self, body: &mut Body) -> TickOutcome {
        self.progress = self.next.unwrap_or_else(|| self.step(self.progress));
        let left = self.progress.ticks_left();
        self.next = (left != 0).then(|| self.step(self.progress));
        let start = body.start;
        let place = |progress: &TickProgress| moved(start, progress.travelled_mm());
        let advanced = body.advance_along(place(&self.progress), self.next.as_ref().map(place));
        if left == 0 {
            // Even if a limit refuses the last tick.
            self.stored_speed = self.end_speed;
        }
        if left == 0 || !advanced {
            return TickOutcome::over(advanced);
        }
        TickOutcome::hangs_if(left < 0, Hang::NeverArrives)
    }

    /// A tick further.
    fn step(&self, progress: TickProgress) -> TickProgress {
        progress.tick(self.vector, self.length, self.speed_change)
    }
}

/// The laser state that a packet sets; `None` leaves it unchanged.
fn lit(frame: &Frame) -> Option<bool> {
    match frame.float(7) {
        1.0 => Some(true),
        0.0 => Some(false),
        _ => None,
    }
}

/// The modes, compared exactly.
const WRITING: f32 = 0.0;
const LASER: f32 = 1.0;
/// The acceleration factor of the laser mode with the laser off.
const RAPID_FACTOR: f32 = 100.0;
/// A vector of this length or less is not planned.
const NO_LENGTH_MM: f32 = 0.0001;
