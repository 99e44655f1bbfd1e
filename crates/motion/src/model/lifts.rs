//! The JUMP of stock arms: up, across and down, each as a joint move (note N45).

use super::segment::{Interpolation, Segment};
use super::stretched_move::StretchedMove;
use crate::{ArmPlace, Speeds, TrajectoryError};
use dobot_arm::{Joints, Limits, Millimeters, Pose, Tool};

/// Lifts by a height at its start, moves to that height above the target, and lowers.
///
/// ```text
///          _ - - _ to + height        each way from rest to rest, all joints together:
///  from + _       |                   none of the three is a straight line
///  height |       * to
///    from *
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Lifts {
    ways: [StretchedMove; 3],
}

impl Lifts {
    /// Plans the three moves. A stock arm skips a move whose end is out of reach; here that is an
    /// error, because the tool would then move straight across.
    pub(crate) fn new(
        from: ArmPlace,
        to: Pose,
        end: Joints,
        height: Millimeters,
        speeds: &Speeds,
        tool: Tool,
    ) -> Result<Self, TrajectoryError> {
        let above = |mut pose: Pose| {
            pose.position.z += height;
            Limits::STOCK.solve(&pose, tool)
        };
        let corners = [from.joints, above(from.pose)?, above(to)?, end];
        let way = |index: usize| StretchedMove::new(corners[index], corners[index + 1], speeds);
        Ok(Self {
            ways: [way(0)?, way(1)?, way(2)?],
        })
    }

    pub(crate) fn joints_at(&self, t_s: f64) -> Joints {
        let [up, across, down] = &self.ways;
        let across_s = t_s - up.duration_s();
        let down_s = across_s - across.duration_s();
        if across_s < 0.0 {
            up.joints_at(t_s)
        } else if down_s < 0.0 {
            across.joints_at(across_s)
        } else {
            down.joints_at(down_s)
        }
    }

    /// Returns the three moves as segments.
    pub(crate) fn segments(&self) -> [Segment; 3] {
        let mut until_s = 0.0;
        self.ways.map(|way| {
            until_s += way.duration_s();
            Segment {
                until_s,
                interpolation: Interpolation::Stretched(way.stretching()),
            }
        })
    }

    pub(crate) const fn duration_s(&self) -> f64 {
        let [up, across, down] = &self.ways;
        up.duration_s() + across.duration_s() + down.duration_s()
    }
}
