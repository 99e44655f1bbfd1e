//! Repeated cycles: the position in the plan moves back, and each cycle is timed.

use std::time::Duration;

use dobot_api::ProgramView;

use crate::supervisor::run::{Phase, Run};

/// The durations of uninterrupted cycles.
#[derive(Debug, Default)]
pub(crate) struct CycleTimes {
    /// When the current cycle began, if it has not been paused since.
    started: Option<Duration>,
    total: Duration,
    count: u32,
}

impl CycleTimes {
    /// Ends a cycle and begins the next one.
    fn handle_over(&mut self, now: Duration) {
        if let Some(started) = self.started.replace(now) {
            self.total += now.saturating_sub(started);
            self.count += 1;
        }
    }

    /// Discards the current cycle, because the job rests in it.
    pub(crate) const fn forget(&mut self) {
        self.started = None;
    }

    fn mean_s(&self) -> Option<f64> {
        (self.count > 0).then(|| self.total.as_secs_f64() / f64::from(self.count))
    }
}

impl Run {
    /// Handles a completed command: a cycle may be over, and the position in the plan moves back.
    pub(crate) fn handle_progress(&mut self, now: Duration) {
        let Some(cycle) = self.started.plan.cycle() else {
            return;
        };
        let counted = self.started.completed + self.started.back;
        if counted > cycle.from && (counted - cycle.from).is_multiple_of(cycle.len) {
            self.cycle_times.handle_over(now);
        }
        if let Some(back) = self.started.go_back() {
            self.go_back(back);
        }
    }

    fn go_back(&mut self, back: usize) {
        self.next -= back;
        self.permit.go_back(back);
        self.reach = None;
        self.speeds.go_back(back);
        for given in &mut self.given {
            given.index -= back;
        }
        if let Some(end) = &mut self.step_end {
            *end -= back;
        }
        match &mut self.phase {
            Phase::Running { upto } | Phase::Draining { upto, .. } => *upto -= back,
            _ => {}
        }
        if let Phase::Running { .. } = self.phase {
            self.phase = self.running();
        }
    }

    /// Returns the running phase, up to the next pause for a person or the end.
    pub(in crate::supervisor::run) fn running(&self) -> Phase {
        let pause = self.started.next_pause().map(|(before, _)| before);
        let ends = [
            Some(self.started.end()),
            Some(self.started.plan.len()),
            pause,
            self.step_end,
        ];
        let upto = ends.into_iter().flatten().min().unwrap_or(0);
        Phase::Running { upto }
    }

    /// Returns the remaining time at the current speed, in seconds (motion model).
    pub(crate) fn left_s(&self) -> Option<f64> {
        let (started, plan) = (&self.started, &self.started.plan);
        let cycles = plan.cycle().map_or(0, |cycle| started.back / cycle.len);
        #[expect(clippy::cast_precision_loss, reason = "2^53 cycles are out of reach")]
        let over_s =
            plan.cycle_s().unwrap_or(0.0) * cycles as f64 + plan.takes_s(0..started.completed);
        let left_s = plan.planned_s()? - over_s;
        Some(left_s * 100.0 / started.adjustment.speed_percent)
    }

    pub(crate) fn program_view(&self, counted: usize) -> Option<ProgramView> {
        let view = self.started.program.view(self.started.commands, counted)?;
        Some(ProgramView {
            planned_cycle_s: self.started.plan.cycle_s(),
            mean_cycle_s: self.cycle_times.mean_s(),
            ..view
        })
    }
}
