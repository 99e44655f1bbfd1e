//! A controller at the end of a serial line.

use std::time::Duration;

use dobot_arm::Position;
use dobot_controller::{Controller, Refused};

use crate::Line;

/// A controller at the end of a serial line, as an engine: it owns no port and no clock.
#[derive(Debug)]
pub struct VirtualArm {
    controller: Controller,
    to_arm: Line,
    from_arm: Line,
    now: Duration,
    /// When something last happened: up to then the way is recorded.
    last_event: Duration,
    recorder: Option<Recorder>,
    scratch: Vec<u8>,
}

/// Where the tool really was.
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
    pub fn new(controller: Controller, line: Line) -> Self {
        Self {
            controller,
            to_arm: line.clone(),
            from_arm: line,
            now: Duration::ZERO,
            last_event: Duration::ZERO,
            recorder: None,
            scratch: Vec::new(),
        }
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

    /// The controller.
    #[must_use]
    pub const fn controller(&self) -> &Controller {
        &self.controller
    }

    /// The time that it has come to.
    #[must_use]
    pub const fn now(&self) -> Duration {
        self.now
    }

    /// Takes bytes that start travelling to the arm.
    pub fn handle_bytes(&mut self, now: Duration, bytes: &[u8]) {
        self.handle_time(now);
        self.to_arm.send(now, bytes);
    }

    /// Takes the passing of time.
    pub fn handle_time(&mut self, now: Duration) {
        loop {
            let event = self.controller.poll_wakeup();
            let next = event.min(now);
            self.deliver(next);
            if event > now {
                break;
            }
            self.step(event);
        }
        self.now = self.now.max(now);
    }

    /// Takes the bytes that have arrived from the arm by now.
    pub fn poll_bytes(&mut self, bytes: &mut Vec<u8>) {
        self.from_arm.receive(self.now, bytes);
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

    /// When something next happens.
    #[must_use]
    pub fn poll_wakeup(&self) -> Duration {
        let event = self.controller.poll_wakeup();
        self.from_arm
            .next_burst()
            .map_or(event, |arrival| arrival.min(event))
    }

    /// Gives the controller the bytes that arrive before `time`: one that arrives in the very
    /// instant of a control tick is too late for it.
    fn deliver(&mut self, time: Duration) {
        self.scratch.clear();
        let before = time.saturating_sub(Duration::from_nanos(1));
        if let Some(arrival) = self.to_arm.receive(before, &mut self.scratch) {
            self.controller.handle_bytes(arrival, &self.scratch);
        }
    }

    fn step(&mut self, event: Duration) {
        if let Some(recorder) = &mut self.recorder {
            recorder.sample(&self.controller, self.last_event, event);
        }
        self.controller.handle_time(event);
        self.last_event = event;
        self.now = event;
        while let Some(upload) = self.controller.poll_bytes() {
            self.from_arm.send(upload.at, &upload.bytes);
        }
    }
}

impl Recorder {
    /// Samples the controller between two of its events, the later one included.
    fn sample(&mut self, controller: &Controller, from: Duration, to: Duration) {
        let mut at = from + self.period;
        while at < to {
            self.push(controller, at);
            at += self.period;
        }
        self.push(controller, to);
    }

    fn push(&mut self, controller: &Controller, at: Duration) {
        let sample = Sample {
            at,
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
