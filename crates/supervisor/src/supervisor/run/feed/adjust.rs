//! Speed and height changes of a running job by a person.

use dobot_journal::HeightChange;
use dobot_safety::Policy;

use crate::refusal::Refusal;
use crate::supervisor::JobPlan;
use crate::supervisor::run::{Effect, JobEffect, Phase, Run};

/// Checks that a height offset is allowed.
pub(in crate::supervisor) fn check_height(offset_mm: f64) -> Result<(), Refusal> {
    check_range("offset_mm", offset_mm, -HEIGHT_MM, HEIGHT_MM, "mm")
}

impl Run {
    /// Checks that the job is not coming to rest and its speed and height can be changed.
    pub(in crate::supervisor) fn check_adjustable(&self) -> Result<(), Refusal> {
        if self.started.doubt.is_some() {
            let why = "its progress is not known yet; start it first".to_owned();
            return Err(Refusal::CannotResume(why));
        }
        Ok(())
    }

    /// Checks that the job may run at this share of its speed.
    pub(in crate::supervisor) fn check_speed(&self, percent: f64) -> Result<(), Refusal> {
        let most = self.started.most_percent().min(FASTEST_PERCENT);
        check_range("percent", percent, SLOWEST_PERCENT, most, "%")
    }

    /// Changes the speed of what is not given yet: vectors, and the targets of a program, which run
    /// at no more than 100 % of the arm's configured speed.
    pub(in crate::supervisor) fn set_speed(&mut self, percent: f64) -> JobEffect {
        self.started.adjustment.speed_percent = percent;
        self.target_speed = self.started.target_speed(self.next);
        self.change_speeds();
        self.keep_adjustment()
    }

    /// Changes the height of what is not given yet.
    pub(in crate::supervisor) fn set_height(
        &mut self,
        offset_mm: f64,
        policy: &Policy,
    ) -> Result<JobEffect, Refusal> {
        if !self.started.plan.has_vectors() || self.started.plan.cycle().is_some() {
            return Err(Refusal::NoVectors(self.job()));
        }
        let (plan, change) = self.at_height(offset_mm);
        plan.check_lowest(policy, change.from)?;
        self.started.plan = plan;
        self.reach = None;
        self.note_height(change);
        self.change_speeds();
        self.permit.wait_for(self.started.adjustment.clone());
        Ok(self.keep_adjustment())
    }

    fn keep_adjustment(&self) -> JobEffect {
        JobEffect::Write(Effect::Adjust {
            job: self.job(),
            adjustment: self.started.adjustment.clone(),
        })
    }

    fn change_speeds(&mut self) {
        let speed_mm_s = self.speed_mm_s();
        let percent = self.started.adjustment.speed_percent;
        self.speeds
            .change(&self.started.plan, self.next, speed_mm_s, percent);
    }

    /// Returns the plan with everything not sent yet at another height.
    fn at_height(&self, offset_mm: f64) -> (JobPlan, HeightChange) {
        let from = self.next;
        let begin_mm = match self.phase {
            Phase::Paused { .. } => offset_mm,
            _ => self.started.plan.raised_mm(from),
        };
        let change = HeightChange {
            from,
            begin_mm,
            offset_mm,
        };
        let mut plan = self.started.plan.clone();
        plan.change_height(&change);
        (plan, change)
    }

    fn note_height(&mut self, change: HeightChange) {
        let heights = &mut self.started.adjustment.heights;
        heights.retain(|height| height.from < change.from);
        forget_older(heights, self.permit.kept());
        heights.push(change);
    }
}

/// Of the changes before the commands that the journal has as done, only the last one matters.
fn forget_older(heights: &mut Vec<HeightChange>, kept: usize) {
    let done = heights.partition_point(|height| height.from <= kept);
    heights.drain(..done.saturating_sub(1));
}

fn check_range(
    name: &'static str,
    found: f64,
    least: f64,
    most: f64,
    unit: &str,
) -> Result<(), Refusal> {
    if (least..=most).contains(&found) {
        return Ok(());
    }
    Err(Refusal::OutOfRange {
        name,
        found,
        allowed: format!("{least} to {most} {unit}"),
    })
}

const SLOWEST_PERCENT: f64 = 10.0;
const FASTEST_PERCENT: f64 = 200.0;
const HEIGHT_MM: f64 = 5.0;
