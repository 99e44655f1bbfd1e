//! At which speeds the vectors go that are not sent yet.

use dobot_safety::burns;
use dobot_wire::{Command, WriteVector};

use super::respeed::{length_mm, respeed};
use crate::keeper::JobPlan;

/// At which speeds the vectors go that are not sent yet: as planned, or at a share of that, or as
/// it takes to begin or to come to rest in the middle of a stroke.
#[derive(Clone, Debug)]
pub(super) struct Pace {
    share: f64,
    /// The first vector with a speed of its own.
    first: usize,
    vectors: Vec<WriteVector>,
}

impl Pace {
    pub(super) const fn new(speed_percent: f64) -> Self {
        Self {
            share: speed_percent / 100.0,
            first: 0,
            vectors: Vec::new(),
        }
    }

    /// A command as it is to be sent when the one before it ends with so much speed, in mm/s.
    pub(super) fn command(
        &mut self,
        plan: &JobPlan,
        index: usize,
        speed_mm_s: f32,
    ) -> Option<Command> {
        let planned = *plan.commands().get(index)?;
        if !self.covers(index) && (self.share != 1.0 || plan.is_altered(index)) {
            self.go_on(plan, index, speed_mm_s);
        }
        let own = index
            .checked_sub(self.first)
            .and_then(|it| self.vectors.get(it));
        Some(own.map_or(planned, |it| Command::from(*it)))
    }

    /// From here on it is another share, or another way.
    pub(super) fn change(
        &mut self,
        plan: &JobPlan,
        index: usize,
        speed_mm_s: f32,
        speed_percent: f64,
    ) {
        self.share = speed_percent / 100.0;
        self.go_on(plan, index, speed_mm_s);
    }

    /// Begins the rest of a stroke from rest.
    pub(super) fn begin(&mut self, plan: &JobPlan, index: usize) {
        let planned = plan.chain(index).next();
        if planned.is_some_and(|it| it.start_speed_mm_s > 0.0) {
            self.go_on(plan, index, 0.0);
        }
    }

    /// Comes to rest on the way that goes on, if that is soon and no laser burns there. Gives the
    /// command before which the arm rests.
    pub(super) fn brake(&mut self, plan: &JobPlan, index: usize, speed_mm_s: f32) -> Option<usize> {
        let speed_mm_s = f64::from(speed_mm_s);
        let acceleration_mm_s2 = plan.acceleration_mm_s2(index);
        let needed_mm = speed_mm_s * speed_mm_s / (2.0 * acceleration_mm_s2) * TO_SPARE;
        let mut vectors: Vec<WriteVector> = Vec::new();
        let mut length_so_far_mm = 0.0;
        for vector in plan.chain(index) {
            if length_so_far_mm >= needed_mm {
                break;
            }
            length_so_far_mm += length_mm(vector);
            vectors.push(*vector);
        }
        let upto = index + vectors.len();
        let takes_s = (plan.left_s(index) - plan.left_s(upto)) / self.share;
        let any_burns = vectors.iter().any(|it| burns(&(*it).into()));
        if any_burns || takes_s > SOON_S {
            return None;
        }
        vectors.last_mut()?.end_speed_mm_s = 0.0;
        self.vectors = respeed(&vectors, speed_mm_s, self.share, acceleration_mm_s2);
        self.first = index;
        Some(upto)
    }

    fn covers(&self, index: usize) -> bool {
        (self.first..self.first + self.vectors.len()).contains(&index)
    }

    fn go_on(&mut self, plan: &JobPlan, index: usize, speed_mm_s: f32) {
        let vectors: Vec<WriteVector> = plan.chain(index).copied().collect();
        let acceleration_mm_s2 = plan.acceleration_mm_s2(index);
        self.vectors = respeed(&vectors, speed_mm_s.into(), self.share, acceleration_mm_s2);
        self.first = index;
    }
}

/// A stock arm cuts vectors into whole ticks, and needs a bit more way for that.
const TO_SPARE: f64 = 1.1;
/// A way on which it takes longer to come to rest is not gone for that.
const SOON_S: f64 = 1.5;
