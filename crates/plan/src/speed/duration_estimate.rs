//! Estimation of a path's duration without planning it.

use dobot_arm::TICK_S;

use crate::speed::link::Credit;
use crate::speed::lookahead::{ChainVector, Cornering};
use crate::{ArmLimits, DrawingTool, LinkRate};

/// Estimates the duration of a stroke.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DurationEstimator {
    /// The limits at corners.
    pub cornering: Cornering,
    /// The maximum speed, in mm/s.
    pub speed_mm_s: f64,
    /// The rate of the link.
    pub link: LinkRate,
    /// The mean extra duration of a vector because it is divided into whole ticks, in s.
    pub lost_s: f64,
}

impl DurationEstimator {
    /// Creates the estimator for a tool and the limits of an arm.
    #[must_use]
    pub const fn of(arm_limits: &ArmLimits, tool: &DrawingTool) -> Self {
        Self {
            cornering: arm_limits.cornering(),
            speed_mm_s: tool.speed_mm_s(),
            link: arm_limits.link,
            lost_s: if arm_limits.has_ticks {
                LOST_TICKS * TICK_S
            } else {
                0.0
            },
        }
    }

    /// Whether the arm divides each vector into whole ticks.
    #[must_use]
    pub fn has_ticks(&self) -> bool {
        self.lost_s > 0.0
    }

    /// Returns the duration of each vector with these increments in mm, from rest to rest, in s,
    /// without the link and without slowing corners further.
    #[must_use]
    pub fn durations_s(&self, increments: impl Iterator<Item = [f64; 3]>) -> Vec<f64> {
        let chain: Vec<ChainVector> = increments
            .map(|increment| ChainVector::of(increment, self.speed_mm_s))
            .collect();
        self.cornering.durations_s(&chain)
    }

    /// Returns the total duration including the link, in s. The link is assumed slightly slower
    /// than it is: if it slows one vector, the neighbours brake for it.
    #[must_use]
    pub fn time_s(&self, durations_s: &[f64]) -> f64 {
        let mut credit = Credit::new(LinkRate {
            period_s: BRAKING * self.link.period_s,
        });
        let took_s = durations_s.iter().map(|&arm_s| {
            let took_s = (arm_s + self.lost_s).max(credit.least_s());
            credit.take(took_s);
            took_s
        });
        took_s.sum()
    }
}

const BRAKING: f64 = 1.15;
/// The mean number of ticks lost by rounding a vector up to whole ticks.
const LOST_TICKS: f64 = 0.9;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_duration_of_a_vector_is_that_of_the_arm_or_the_link() {
        let estimator = DurationEstimator::of(&ArmLimits::default(), &DrawingTool::default());
        // 40 mm at 40 mm/s and 100 mm/s2: 0.4 s up, 0.4 s down over 8 mm each, 24 mm at full speed.
        let long = estimator.durations_s([[40.0, 0.0, 0.0]].into_iter());
        assert!((estimator.time_s(&long) - 1.4).abs() < 1e-9, "{long:?}");
        let short = estimator.durations_s([[0.1, 0.0, 0.0]; 100].into_iter());
        let took_s = estimator.time_s(&short);
        assert!((9.0..9.4).contains(&took_s), "{took_s}");
    }
}
