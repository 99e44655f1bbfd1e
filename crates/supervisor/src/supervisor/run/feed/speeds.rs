//! The speeds of the vectors not sent yet.

use dobot_motion::burns;
use dobot_plan::{ArmLimits, RespeedStart, respeed, stop_each};
use dobot_wire::{Command, WriteVector, single};

use crate::supervisor::JobPlan;

/// The speeds of the vectors not sent yet: as planned, at a share of that, or as needed to start or
/// to come to rest in the middle of a stroke.
#[derive(Clone, Debug)]
pub(crate) struct Speeds {
    share: f64,
    arm_limits: ArmLimits,
    /// The first vector with its own speed.
    first: usize,
    vectors: Vec<WriteVector>,
    /// Up to here, each vector ends at rest.
    rests_until: usize,
}

impl Speeds {
    pub(crate) const fn new(speed_percent: f64, arm_limits: ArmLimits) -> Self {
        Self {
            share: speed_percent / 100.0,
            arm_limits,
            first: 0,
            vectors: Vec::new(),
            rests_until: 0,
        }
    }

    /// Stops at each vector for the rest of this stroke, because the speed at which a stock arm
    /// starts it is unknown. A vector between two rests gets the right length whatever that speed
    /// is.
    pub(crate) fn stop_each(&mut self, plan: &JobPlan, index: usize) {
        if self.arm_limits.has_ticks {
            self.rests_until = index + plan.chain(index).count();
        }
    }

    /// Returns a command as it is to be sent after one that ends at this speed, in mm/s.
    pub(crate) fn command(
        &mut self,
        plan: &JobPlan,
        index: usize,
        speed_mm_s: f32,
    ) -> Option<Command> {
        let planned = *plan.commands().get(index)?;
        let begins_so = |command: &Command| begins_with(command, speed_mm_s);
        if !self.covers(index)
            && (index < self.rests_until
                || self.share != 1.0
                || plan.is_altered(index)
                || !begins_so(&planned))
        {
            self.go_on(plan, index, speed_mm_s);
        }
        let own = self.covers(index).then(|| self.vectors[index - self.first]);
        Some(own.map_or(planned, Command::from))
    }

    /// Changes the share or the path from here on.
    pub(crate) fn change(
        &mut self,
        plan: &JobPlan,
        index: usize,
        speed_mm_s: f32,
        speed_percent: f64,
    ) {
        self.share = speed_percent / 100.0;
        self.go_on(plan, index, speed_mm_s);
    }

    /// Moves back in the plan.
    pub(crate) fn go_back(&mut self, back: usize) {
        match self.first.checked_sub(back) {
            Some(first) => self.first = first,
            None => self.vectors.clear(),
        }
        self.rests_until = self.rests_until.saturating_sub(back);
    }

    /// Comes to rest along the path, if that is soon and no laser burns there. Returns the command
    /// before which the arm rests.
    pub(crate) fn brake(&mut self, plan: &JobPlan, index: usize, speed_mm_s: f32) -> Option<usize> {
        let speed = f64::from(speed_mm_s);
        let needed_mm =
            speed * speed / (2.0 * plan.drawn_with(index).acceleration_mm_s2) * TO_SPARE;
        self.go_on(plan, index, speed_mm_s);
        let count = reaching(&self.vectors, needed_mm);
        let takes_s = plan.takes_s(index..index + count) / self.share;
        let any_burns = self.vectors[..count]
            .iter()
            .any(|vector| burns(&(*vector).into()));
        if count == 0 || any_burns || takes_s > SOON_S {
            return None;
        }
        self.vectors.truncate(count);
        slow_down(&mut self.vectors, speed_mm_s);
        if self.arm_limits.has_ticks {
            let begin = begin(plan, index, speed_mm_s);
            self.vectors = respeed(&self.vectors, &begin, 1.0, &self.arm_limits);
        }
        Some(index + count)
    }

    /// Returns the arm limits for a vector of the job.
    pub(crate) fn arm_limits_at(&self, plan: &JobPlan, index: usize) -> ArmLimits {
        ArmLimits {
            acceleration_mm_s2: plan.drawn_with(index).acceleration_mm_s2,
            ..self.arm_limits
        }
    }

    pub(crate) const fn rests_each(&self, index: usize) -> bool {
        index < self.rests_until
    }

    fn covers(&self, index: usize) -> bool {
        (self.first..self.first + self.vectors.len()).contains(&index)
    }

    fn go_on(&mut self, plan: &JobPlan, index: usize, speed_mm_s: f32) {
        let chain: Vec<WriteVector> = plan.chain(index).copied().collect();
        self.arm_limits = self.arm_limits_at(plan, index);
        self.first = index;
        self.vectors = if self.rests_each(index) {
            stop_each(&chain, self.share, &self.arm_limits)
        } else {
            let begin = begin(plan, index, speed_mm_s);
            respeed(&chain, &begin, self.share, &self.arm_limits)
        };
    }
}

/// Returns the arm state that a vector starts from. A target comes before each.
fn begin(plan: &JobPlan, index: usize, speed_mm_s: f32) -> RespeedStart {
    RespeedStart {
        speed_mm_s,
        position: plan.start_position(index).unwrap_or_default(),
        tool: plan.drawn_with(index).tool,
    }
}

/// Returns whether a command is planned to start at this speed. Only a vector can start otherwise,
/// and between two rests it gets the right length anyway.
fn begins_with(planned: &Command, speed_mm_s: f32) -> bool {
    match planned {
        Command::WriteVector(vector)
            if vector.end_speed_mm_s > 0.0 || vector.start_speed_mm_s > MOVES_MM_S =>
        {
            let found_mm_s = speed_mm_s.max(0.0).min(vector.max_speed_mm_s);
            (vector.start_speed_mm_s - found_mm_s).abs() < SAME_MM_S
        }
        _ => true,
    }
}

/// Returns the number of vectors needed for this distance.
fn reaching(vectors: &[WriteVector], way_mm: f64) -> usize {
    let mut so_far_mm = 0.0;
    let before = vectors.iter().take_while(|vector| {
        let is_before = so_far_mm < way_mm;
        so_far_mm += length_mm(vector);
        is_before
    });
    before.count()
}

/// Slows vectors down evenly, so that the last one ends at rest.
///
/// ```text
///   v2 |'--.__     as planned where that is slower
///      |      '--.__
///      |____________'--.__ way
/// ```
fn slow_down(vectors: &mut [WriteVector], begin_mm_s: f32) {
    let way_mm: f64 = vectors.iter().map(length_mm).sum();
    let (mut left_mm, mut speed) = (way_mm, begin_mm_s);
    let rests = vectors.len() - 1;
    for (index, vector) in vectors.iter_mut().enumerate() {
        left_mm -= length_mm(vector);
        let even = f64::from(begin_mm_s) * (left_mm.max(0.0) / way_mm).sqrt();
        let end = if index == rests { 0.0 } else { single(even) };
        vector.start_speed_mm_s = speed;
        vector.end_speed_mm_s = vector.end_speed_mm_s.min(end);
        speed = vector.end_speed_mm_s;
        let fastest = vector.start_speed_mm_s.max(speed);
        if fastest > CREEPS_MM_S {
            vector.max_speed_mm_s = fastest;
        }
    }
}

fn length_mm(vector: &WriteVector) -> f64 {
    let [x, y, z] = [vector.x_mm, vector.y_mm, vector.z_mm].map(f64::from);
    (x * x + y * y + z * z).sqrt()
}

/// A slower vector would take minutes; it runs as fast as allowed instead, from rest to rest.
const CREEPS_MM_S: f32 = 1.0;
/// The speed that a stock arm keeps at rest is less.
const MOVES_MM_S: f32 = 4.0;
/// Speeds that differ by less are equal.
const SAME_MM_S: f32 = 1e-3;
/// A stock arm rounds vectors to whole ticks and needs some extra distance for that.
const TO_SPARE: f64 = 1.1;
/// If coming to rest along the path takes longer, it is not done.
const SOON_S: f64 = 1.5;

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn vector(x_mm: f32, end_speed_mm_s: f32) -> WriteVector {
        WriteVector {
            end_speed_mm_s,
            ..WriteVector::by(x_mm, 0.0, 0.0, 80.0)
        }
    }

    #[test]
    fn the_number_of_vectors_follows_from_the_distance() {
        let vectors = [vector(1.0, 9.0), vector(2.0, 9.0), vector(4.0, 9.0)];
        assert_eq!(
            [0.0, 0.5, 1.0, 1.1, 3.0, 9.0].map(|mm| reaching(&vectors, mm)),
            [0, 1, 1, 2, 2, 3]
        );
    }

    proptest! {
        #[test]
        fn vectors_that_slow_down_end_at_rest_and_keep_the_acceleration(
            lengths in prop::collection::vec(0.05..5.0_f32, 1..40),
            begin in 0.5..80.0_f32,
        ) {
            let mut vectors: Vec<_> = lengths.iter().map(|length| vector(*length, 80.0)).collect();
            let way_mm: f64 = vectors.iter().map(length_mm).sum();
            let acceleration = f64::from(begin) * f64::from(begin) / (2.0 * way_mm);
            slow_down(&mut vectors, begin);
            let mut speed = begin;
            for vector in &vectors {
                prop_assert_eq!(vector.start_speed_mm_s, speed);
                speed = vector.end_speed_mm_s;
                prop_assert!(speed <= vector.start_speed_mm_s);
                prop_assert!(vector.max_speed_mm_s > 0.0);
                let v2 = |v: f32| f64::from(v) * f64::from(v);
                let change = v2(vector.start_speed_mm_s) - v2(speed);
                prop_assert!(change <= 2.0 * acceleration * length_mm(vector) * 1.001 + 1e-6);
            }
            prop_assert_eq!(speed, 0.0);
        }
    }
}
