//! What a person changes on a job while it runs: its speed and its height.

use dobot_journal::{Adjustment, HeightChange};

use super::{Effect, Phase, Run};
use crate::keeper::{JobPlan, Keeper};
use crate::words::{ClientId, Refusal, Reply};

impl Keeper {
    /// Draws the vectors that are not sent yet at another speed.
    pub(in crate::keeper) fn set_job_speed(
        &mut self,
        client: ClientId,
        percent: f64,
    ) -> Result<Reply, Refusal> {
        self.leases.check(client)?;
        check_range("percent", percent, SLOWEST_PERCENT, FASTEST_PERCENT, "%")?;
        self.check_adjustable()?;
        self.take_back();
        if let Some(run) = &mut self.run {
            run.begun.adjustment.speed_percent = percent;
            run.change_pace();
        }
        self.keep_adjustment();
        Ok(self.job_reply())
    }

    /// Draws what is not sent yet higher or lower: bit by bit while it runs, at once where it is
    /// paused, for there the tool comes from above.
    pub(in crate::keeper) fn set_job_height(
        &mut self,
        client: ClientId,
        offset_mm: f64,
    ) -> Result<Reply, Refusal> {
        self.leases.check(client)?;
        check_range("offset_mm", offset_mm, -HEIGHT_MM, HEIGHT_MM, "mm")?;
        self.check_adjustable()?;
        self.take_back();
        if let Some(run) = &mut self.run {
            let (plan, change) = run.at_height(offset_mm);
            plan.check_lowest(self.arm.policy(), change.from)?;
            run.begun.plan = plan;
            run.note_height(change);
            run.change_pace();
            run.unkept = Some(run.begun.adjustment.clone());
        }
        self.keep_adjustment();
        Ok(self.job_reply())
    }

    /// Whether there is a job whose vectors can be changed now.
    fn check_adjustable(&self) -> Result<(), Refusal> {
        let run = self.run.as_ref().ok_or(Refusal::NoJobRuns)?;
        match run.phase {
            Phase::Locating { .. } | Phase::Draining { .. } | Phase::Lifting { .. } => {
                return Err(self.still_moving());
            }
            Phase::Approaching { .. } | Phase::Running | Phase::Paused { .. } => {}
        }
        if run.begun.doubt.is_some() {
            let why = "nobody knows yet how far it is; start it first".to_owned();
            return Err(Refusal::CannotResume(why));
        }
        if !run.begun.plan.has_vectors() {
            return Err(Refusal::NoVectors(run.job()));
        }
        Ok(())
    }

    /// What was given and not sent is given again.
    fn take_back(&mut self) {
        let runs = |it: &Run| matches!(it.phase, Phase::Running);
        if self.run.as_ref().is_some_and(runs) {
            self.drop_waiting("it is sent at another speed or height");
        }
    }

    fn keep_adjustment(&mut self) {
        if let Some(run) = &self.run {
            self.save.ask(Effect::Adjust {
                job: run.job(),
                adjustment: run.begun.adjustment.clone(),
            });
            self.outbox.note_change();
        }
    }
}

impl Run {
    fn change_pace(&mut self) {
        let speed_mm_s = self.speed_mm_s();
        let percent = self.begun.adjustment.speed_percent;
        self.pace
            .change(&self.begun.plan, self.next, speed_mm_s, percent);
    }

    /// The job with all that is not sent yet at another height.
    fn at_height(&self, offset_mm: f64) -> (JobPlan, HeightChange) {
        let from = self.next;
        let begin_mm = match self.phase {
            Phase::Paused { .. } => offset_mm,
            _ => self.begun.plan.raised_mm(from),
        };
        let change = HeightChange {
            from,
            begin_mm,
            offset_mm,
        };
        let mut plan = self.begun.plan.clone();
        plan.change_height(&change);
        (plan, change)
    }

    fn note_height(&mut self, change: HeightChange) {
        let heights = &mut self.begun.adjustment.heights;
        heights.retain(|it| it.from < change.from);
        forget_older(heights, self.kept);
        heights.push(change);
    }

    /// Takes that the journal has what a person changed.
    pub(super) fn adjusted(&mut self, adjustment: &Adjustment) {
        self.unkept.take_if(|it| it.heights == adjustment.heights);
    }
}

/// Of the changes before the commands that the journal knows to be done only the last one still
/// matters.
fn forget_older(heights: &mut Vec<HeightChange>, kept: usize) {
    let done = heights.partition_point(|it| it.from <= kept);
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
