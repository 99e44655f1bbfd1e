//! The MOVJ of stock arms (note N45).

use core::array::from_fn;

use super::follow::ways;
use crate::plan_error::finite;
use crate::{PlanError, Speeds};
use dobot_arm::Joints;

/// A joint move in which each joint is stretched to the time of the slowest one by ramps of its own.
///
/// ```text
///  share    ______            the slowest joint: as fast as it may be
///  of      /      \
///  speed  /  _--_  \          another one: it never gets to its speed, and takes half the time
///        / _-    -_ \         to accelerate; so the joints cover different shares at a time
///        <--- T --->
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct StretchedMove {
    from: Joints,
    to: Joints,
    duration_s: f64,
    /// The times in which base, rear arm, forearm and servo accelerate and decelerate.
    ramps_s: [f64; 4],
}

impl StretchedMove {
    /// Plans the move; it takes 0 s if no joint has to turn.
    ///
    /// # Errors
    ///
    /// [`PlanError`] if an angle is not finite or a speed or acceleration is not positive.
    pub(crate) fn new(from: Joints, to: Joints, speeds: &Speeds) -> Result<Self, PlanError> {
        speeds.check()?;
        let ways_deg = [
            to.base - from.base,
            to.rear - from.rear,
            to.fore - from.fore,
            to.servo - from.servo,
        ]
        .map(|way| way.abs().0);
        ways_deg
            .iter()
            .try_for_each(|way_deg| finite("angle to turn", *way_deg))?;
        let joint = [speeds.joint_deg_s, speeds.joint_deg_s2];
        let servo = [speeds.servo_deg_s, speeds.servo_deg_s2];
        let limits = [joint, joint, joint, servo];
        let axes = ways_deg.into_iter().zip(limits);
        let duration_s = axes.map(|(way, limits)| fastest_s(way, limits));
        let duration_s = duration_s.fold(0.0, f64::max);
        finite("duration", duration_s)?;
        let ramp_s = |i: usize| duration_s - ways_deg[i] / limits[i][0];
        Ok(Self {
            from,
            to,
            duration_s,
            ramps_s: from_fn(|i| ramp_s(i).clamp(0.0, duration_s / 2.0)),
        })
    }

    /// Returns the joint angles at a time.
    pub(crate) fn joints_at(&self, t_s: f64) -> Joints {
        if t_s >= self.duration_s {
            return self.to;
        }
        let [base, rear, fore, servo] = self.ramps_s.map(|ramp_s| self.share_at(t_s, ramp_s));
        let (from, to) = (&self.from, &self.to);
        Joints {
            base: from.base + (to.base - from.base) * base,
            rear: from.rear + (to.rear - from.rear) * rear,
            fore: from.fore + (to.fore - from.fore) * fore,
            servo: from.servo + (to.servo - from.servo) * servo,
        }
    }

    /// Returns the duration.
    pub(crate) const fn duration_s(&self) -> f64 {
        self.duration_s
    }

    /// Returns how differently base, rear arm and forearm turn.
    pub(crate) fn stretching(&self) -> Stretching {
        let ways = ways(&self.from, &self.to);
        let shortest_s = self.ramps_s.into_iter().fold(f64::INFINITY, f64::min);
        let turn = |axis: usize| {
            let (way_deg, ramp_s) = (ways[axis].abs().0, self.ramps_s[axis]);
            self.turn(way_deg, ramp_s, shortest_s)
        };
        Stretching {
            ramp: if self.duration_s > 0.0 {
                shortest_s / self.duration_s
            } else {
                0.5
            },
            turns: from_fn(turn),
        }
    }

    /// Returns how differently a joint turns, compared with the one that has the shortest ramps.
    fn turn(&self, way_deg: f64, ramp_s: f64, shortest_s: f64) -> TurnBounds {
        if ramp_s <= shortest_s {
            return TurnBounds {
                first_deg: way_deg,
                second_deg: 0.0,
            };
        }
        // Both joints accelerate: their shares are proportional. One of them has its speed: there
        // the other is faster by the ratio of speeds, and changes most.
        let cruise_s = self.duration_s - shortest_s;
        let first_deg = way_deg * cruise_s / (self.duration_s - ramp_s);
        TurnBounds {
            first_deg,
            second_deg: first_deg * cruise_s / ramp_s,
        }
    }

    /// Returns the share of its angle that a joint with these ramps has turned.
    fn share_at(&self, t_s: f64, ramp_s: f64) -> f64 {
        turned_share(t_s, ramp_s, self.duration_s)
    }
}

/// How differently the joints of a move turn: compared with the one that has the shortest ramps, which
/// covers a share of its angle that goes from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretching {
    /// The ramps of that joint, as a share of the time: above 0 to a half.
    ramp: f64,
    turns: [TurnBounds; 3],
}

/// Bounds of the angle of a joint while the share of another one goes evenly from 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TurnBounds {
    /// The largest first derivative, in degrees.
    pub first_deg: f64,
    /// The largest second derivative, in degrees.
    pub second_deg: f64,
}

impl Stretching {
    /// Returns the bounds of base, rear arm and forearm between two shares of the time.
    #[must_use]
    pub fn between(&self, from: f64, to: f64) -> [TurnBounds; 3] {
        let share = |time| turned_share(time, self.ramp, 1.0);
        let covered = share(to) - share(from);
        self.turns.map(|turn| TurnBounds {
            first_deg: turn.first_deg * covered,
            second_deg: turn.second_deg * covered * covered,
        })
    }
}

/// Returns the share of its angle that a joint with these ramps has turned.
fn turned_share(t_s: f64, ramp_s: f64, duration_s: f64) -> f64 {
    let top = 1.0 / (duration_s - ramp_s);
    let left_s = duration_s - t_s;
    if t_s <= 0.0 {
        0.0
    } else if left_s <= 0.0 {
        1.0
    } else if t_s < ramp_s {
        top * t_s * t_s / (2.0 * ramp_s)
    } else if left_s < ramp_s {
        1.0 - top * left_s * left_s / (2.0 * ramp_s)
    } else {
        top * (t_s - ramp_s / 2.0)
    }
}

/// The shortest time of one joint alone.
fn fastest_s(way_deg: f64, [speed, acceleration]: [f64; 2]) -> f64 {
    let ramps_deg = speed * speed / acceleration;
    if way_deg > ramps_deg {
        speed / acceleration + way_deg / speed
    } else {
        2.0 * libm::sqrt(way_deg / acceleration)
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    /// 100 degrees/s and 100 degrees/s2, and half of it for the servo.
    const SPEEDS: Speeds = Speeds::new([100.0, 100.0, 50.0, 50.0, 100.0, 100.0]);

    #[test]
    fn a_joint_that_is_not_the_slowest_accelerates_for_half_the_time() {
        // The base takes 1 s to its speed, 0.5 s at it, and 1 s to rest: 150 degrees.
        let to = Joints::new(150.0, 50.0, -25.0, 0.0);
        let movement = StretchedMove::new(Joints::default(), to, &SPEEDS).unwrap();
        assert_eq!(movement.duration_s(), 2.5);
        let joints = movement.joints_at(1.0);
        // The base has turned by 50 degrees, the others by 2 (t / T)^2 = 0.32 of their angles.
        for (found, expected) in [
            (joints.base.0, 50.0),
            (joints.rear.0, 16.0),
            (joints.fore.0, -8.0),
            (joints.servo.0, 0.0),
        ] {
            let off = (found - expected).abs();
            assert!(off < 1e-9, "{found}, not {expected} by 1e-9");
        }
        assert_eq!(movement.joints_at(2.5), to);
        assert_eq!(movement.joints_at(-1.0), Joints::default());
    }

    #[test]
    fn the_slowest_joint_alone_sets_the_time() {
        // The servo takes 1 s up, 1 s down, and 1.5 s for the other 75 degrees; the base 2.2 s.
        let to = Joints::new(120.0, 0.0, 0.0, 125.0);
        let movement = StretchedMove::new(Joints::default(), to, &SPEEDS).unwrap();
        assert!((movement.duration_s() - 3.5).abs() < 1e-9);
    }

    #[test]
    fn between_two_times_no_joint_turns_by_more_than_its_bounds() {
        let to = Joints::new(150.0, 50.0, -25.0, 60.0);
        let movement = StretchedMove::new(Joints::default(), to, &SPEEDS).unwrap();
        let stretching = movement.stretching();
        let angles = |share: f64| {
            let joints = movement.joints_at(share * movement.duration_s());
            [joints.base.0, joints.rear.0, joints.fore.0]
        };
        let base_share = |share: f64| angles(share)[0] / 150.0;
        for n in 0..64 {
            let [from, to] = [n, n + 1].map(|n| f64::from(n) / 64.0);
            let bounds = stretching.between(from, to);
            let [a, b] = [angles(from), angles(to)];
            for axis in 0..3 {
                let turned = (b[axis] - a[axis]).abs();
                assert!(
                    turned <= bounds[axis].first_deg + 1e-9,
                    "{axis} from {from}"
                );
                // In the middle it strays from the straight line over the share of the base.
                let [start, end] = [from, to].map(base_share);
                let middle = f64::midpoint(from, to);
                let along = (base_share(middle) - start) / (end - start);
                let straight = a[axis] + (b[axis] - a[axis]) * along;
                let stray = (angles(middle)[axis] - straight).abs();
                assert!(
                    stray <= bounds[axis].second_deg / 8.0 + 1e-9,
                    "{axis} from {from}"
                );
            }
        }
    }

    #[test]
    fn joints_that_only_accelerate_and_decelerate_turn_evenly() {
        let to = Joints::new(40.0, 20.0, -10.0, 0.0);
        let movement = StretchedMove::new(Joints::default(), to, &SPEEDS).unwrap();
        let [base, rear, fore] = movement.stretching().between(0.0, 1.0);
        for (bounds, way_deg) in [(base, 40.0), (rear, 20.0), (fore, 10.0)] {
            assert_eq!([bounds.first_deg, bounds.second_deg], [way_deg, 0.0]);
        }
    }

    #[test]
    fn no_turn_takes_no_time() {
        let here = Joints::new(10.0, 45.0, 45.0, 0.0);
        let movement = StretchedMove::new(here, here, &SPEEDS).unwrap();
        assert_eq!(movement.duration_s(), 0.0);
        assert_eq!(movement.joints_at(0.0), here);
    }
}
