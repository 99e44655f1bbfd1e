//! A job that goes no further: by a person, by trouble, for good or for a while.

use dobot_journal::Window;

use super::{Effect, Phase, Run, Wish, straight, word};
use crate::keeper::arm::Arm;
use crate::words::{JobPhase, News};

impl Run {
    /// Ends a job that gives the arm no commands any more, with what its phase needs for that.
    pub(in crate::keeper) fn end(&mut self, why: &str) -> Option<Wish> {
        match &mut self.phase {
            // Nothing moves for its sake: how far the job got, nobody needs to know any more.
            Phase::Paused { .. } | Phase::Locating { .. } => {
                Some(self.drain(JobPhase::Stopped, why, false))
            }
            Phase::Draining { then, reason, .. } | Phase::Lifting { then, reason, .. } => {
                *then = JobPhase::Stopped;
                why.clone_into(reason);
                Some(self.tell(JobPhase::Stopped, why))
            }
            Phase::Running | Phase::Approaching { .. } => None,
        }
    }

    /// The job goes no further: it comes to rest on its way, and the tool is lifted. What was not sent
    /// is forgotten already.
    pub(in crate::keeper) fn come_to_rest(&mut self, then: JobPhase, why: &str) -> Wish {
        let wish = self.drain(then, why, self.is_down());
        self.brake();
        wish
    }

    /// The job goes no further: what is under way comes to its end, then it is paused.
    pub(in crate::keeper) fn interrupt(&mut self, why: &str) -> Option<Wish> {
        if self.is_at_work() {
            return Some(self.drain(JobPhase::Paused, why, false));
        }
        let cut_short = self.is_cut_short();
        self.end_here();
        if let Phase::Draining { lift, reason, .. } = &mut self.phase {
            *lift = false;
            if cut_short {
                why.clone_into(reason);
            }
        }
        None
    }

    /// A job that burns goes no further, and the tool is lifted.
    pub(in crate::keeper) fn interrupt_burning(&mut self, why: &str) -> Wish {
        self.drain(JobPhase::Paused, why, true)
    }

    pub(super) fn drain(&mut self, then: JobPhase, reason: &str, lift: bool) -> Wish {
        self.end_here();
        self.phase = Phase::Draining {
            then,
            reason: reason.to_owned(),
            lift,
        };
        // The journal keeps it as running until nothing is under way: a crash until then has to find
        // out how far the job got.
        self.tell(then, reason)
    }

    /// All was given that the job does before it rests: the tool is lifted right behind that, so that
    /// no pen stands on the paper.
    pub(super) fn lift(&mut self, arm: &mut Arm, may_lift: bool, then: JobPhase, reason: String) {
        let up = self.lift_mm();
        let command = straight(up.into());
        let lifts = up > 0.0
            && may_lift
            && arm.check_way(&command).is_ok()
            && arm.session_mut().send(command).is_ok();
        self.phase = if lifts {
            Phase::Lifting { then, reason }
        } else {
            let lift = false;
            Phase::Draining { then, reason, lift }
        };
    }

    /// Nothing of the job is under way any more: how far it got is certain, and kept.
    pub(super) fn rest(&mut self, arm: &mut Arm, then: JobPhase, reason: String) -> Vec<Wish> {
        let window = self.come_to_end(&reason);
        arm.part_from_laser();
        let mut wishes = vec![Wish::Keep(Effect::Phase {
            job: self.job(),
            phase: then,
            reason: Some(reason),
            window,
            behind: self.begun.behind,
        })];
        wishes.extend(then.is_over().then_some(Wish::Forget));
        wishes
    }

    /// Gives how far the job is, where that is certain.
    fn come_to_end(&mut self, reason: &str) -> Option<Window> {
        if matches!(self.phase, Phase::Lifting { .. }) {
            self.left = self.after(self.left, &straight(self.lift_mm().into()));
        }
        self.next = self.begun.completed;
        let waited = self.begun.next_pause().map(|it| it.before);
        if self.waits && waited == Some(self.next) {
            self.begun.behind.pauses += 1;
        }
        self.end_here();
        self.note_ran();
        self.phase = Phase::Paused {
            reason: reason.to_owned(),
        };
        self.begun.doubt.is_none().then(|| self.certain())
    }

    pub(super) fn tell(&self, phase: JobPhase, reason: &str) -> Wish {
        let job = self.job();
        let text = format!("job {job} is {}: {reason}", word(phase));
        Wish::Tell(News::Job { job, phase }, text)
    }

    /// Comes to rest on the way that it is on, where that goes soon: an arm that has nothing more to
    /// do stops dead.
    fn brake(&mut self) {
        let left = self.left();
        if left.moves
            && let Some(upto) = self
                .pace
                .brake(&self.begun.plan, self.next, left.speed_mm_s)
        {
            self.limit = upto;
        }
    }

    /// No more than what was given already.
    fn end_here(&mut self) {
        self.limit = self.next;
        self.waits = false;
    }

    /// Whether it waits for a person at a place to which it will not come.
    const fn is_cut_short(&self) -> bool {
        self.waits && self.next < self.limit
    }

    /// Whether the tool is where the job goes on: not above that, on its way.
    const fn is_down(&self) -> bool {
        !matches!(self.phase, Phase::Approaching { .. }) && self.lower.is_none()
    }
}
