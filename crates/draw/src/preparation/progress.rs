//! The progress of a preparation, visible from another thread.

use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};

use dobot_geometry::Point;
use dobot_plan::{ArmLimits, Pass};

use crate::strokes::order::Travel;

/// The progress of a preparation, for reading from another thread.
#[derive(Clone, Debug, Default)]
pub struct Progress(Arc<Counters>);

#[derive(Debug, Default)]
struct Counters {
    /// An index in [`STEPS`].
    step: AtomicUsize,
    done: AtomicUsize,
    /// 0 if the amount of work is unknown.
    all: AtomicUsize,
    /// The bits of the estimated duration in seconds; 0 while it is unknown.
    roughly_s: AtomicU64,
}

/// A step of the preparation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum PrepareStep {
    /// Converts the source to lines on the paper.
    #[default]
    Reading,
    /// Searches for a good stroke order.
    Ordering,
    /// Selects the fastest vectors.
    Vectors,
    /// Plans the speeds.
    Planning,
}

impl Progress {
    /// Returns the current step.
    #[must_use]
    pub fn step(&self) -> PrepareStep {
        STEPS[self.0.step.load(Ordering::Relaxed)]
    }

    /// Returns the completed share of the step, from 0 to 1, if it is known.
    #[must_use]
    pub fn share(&self) -> Option<f64> {
        let [done, all] = [&self.0.done, &self.0.all].map(|count| count.load(Ordering::Relaxed));
        #[expect(clippy::cast_precision_loss, reason = "only a share")]
        (all > 0).then(|| (done as f64 / all as f64).min(1.0))
    }

    /// Returns a rough estimate of the drawing time, in seconds, from the lengths with and without
    /// ink, before the vectors are selected.
    #[must_use]
    pub fn roughly_s(&self) -> Option<f64> {
        let roughly_s = f64::from_bits(self.0.roughly_s.load(Ordering::Relaxed));
        (roughly_s > 0.0).then_some(roughly_s)
    }

    /// Begins a step with this amount of work; 0 if it is unknown.
    pub(crate) fn begin(&self, step: PrepareStep, all: usize) {
        self.0.all.store(0, Ordering::Relaxed);
        self.0.done.store(0, Ordering::Relaxed);
        self.0.step.store(step as usize, Ordering::Relaxed);
        self.0.all.store(all, Ordering::Relaxed);
    }

    /// Adds completed work to the step.
    pub(crate) fn advance(&self, by: usize) {
        self.0.done.fetch_add(by, Ordering::Relaxed);
    }

    /// Estimates the drawing time of these passes within the arm's limits.
    pub(crate) fn expect(&self, passes: &[Pass], arm_limits: &ArmLimits) {
        let bits = roughly_s(passes, arm_limits).to_bits();
        self.0.roughly_s.store(bits, Ordering::Relaxed);
    }
}

impl fmt::Display for PrepareStep {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Reading => "reading",
            Self::Ordering => "ordering the strokes",
            Self::Vectors => "choosing vectors",
            Self::Planning => "planning",
        })
    }
}

/// Returns the duration of passes from their lengths: each stroke and each travel from rest to
/// rest.
fn roughly_s(passes: &[Pass], arm_limits: &ArmLimits) -> f64 {
    let mut here: Option<Point> = None;
    let mut all_s = 0.0;
    for Pass { tool, strokes, .. } in passes {
        let at = |speed_mm_s| Travel::Time {
            speed_mm_s,
            acceleration_mm_s2: arm_limits.acceleration_mm_s2,
            least_s: arm_limits.link.period_s,
        };
        let (travel, ink) = (at(tool.travel_speed_mm_s()), at(tool.speed_mm_s()));
        let mut pass_s = 0.0;
        for stroke in strokes {
            let (Some(&first), Some(last)) = (stroke.points.first(), stroke.last()) else {
                continue;
            };
            let way_mm = here.map_or(0.0, |here| here.distance(first));
            // Includes lowering and lifting.
            pass_s += travel.cost(way_mm) + 2.0 * travel.cost(tool.lift_mm());
            pass_s += ink.cost(stroke.length_mm());
            here = Some(last);
        }
        all_s += pass_s * f64::from(tool.times());
    }
    all_s
}

const STEPS: [PrepareStep; 4] = [
    PrepareStep::Reading,
    PrepareStep::Ordering,
    PrepareStep::Vectors,
    PrepareStep::Planning,
];

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use dobot_import::Source;

    use super::*;
    use crate::{Settings, prepare};

    #[test]
    fn a_rough_estimate_needs_only_the_paths() {
        let lines: Vec<String> = (0..200)
            .map(|i| format!("M5 {}H95", 5.0 + 0.25 * f64::from(i)))
            .collect();
        let lines = lines.concat();
        let svg = format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="60mm" viewBox="0 0 100 60"><path d="{lines}" stroke="black"/></svg>"#
        );
        let settings = Settings::default();
        assert_eq!(settings.progress.roughly_s(), None);
        let prepared = prepare(&Source::from(svg.as_str()), &settings, |_| {
            Ok::<(), String>(())
        })
        .unwrap();
        let (roughly_s, planned_s) = (
            settings.progress.roughly_s().unwrap(),
            prepared.plan.duration_s(),
        );
        assert!(
            (0.8..1.25).contains(&(roughly_s / planned_s)),
            "{roughly_s} and {planned_s} s"
        );
        assert_eq!(settings.progress.step(), PrepareStep::Planning);
    }

    #[test]
    fn the_progress_of_a_step_is_reported_if_known() {
        let progress = Progress::default();
        assert_eq!(progress.share(), None);
        progress.begin(PrepareStep::Vectors, 40);
        progress.advance(10);
        assert_eq!(
            (progress.step(), progress.share()),
            (PrepareStep::Vectors, Some(0.25))
        );
        progress.begin(PrepareStep::Planning, 0);
        assert_eq!(progress.share(), None);
    }
}
