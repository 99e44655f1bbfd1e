//! The volume swept between two points of a path: bounds that hold for every point between.
//!
//! On each segment of a path, the same quantities change evenly with a share `u` from 0 to 1: the
//! tool's position on a line; its reach, height and base angle in a JUMP; the four joint angles in
//! a MOVJ. The joints of a stock arm have ramps of their own (note N45): there `u` is the share of
//! the joint with the shortest ramps, and the second derivatives of the others are bounded too. If
//! a quantity goes from `a` to `b` and its second derivative by `u` is at most `m`, then
//!
//! * it differs from the straight line between `a` and `b` by at most `m / 8`;
//! * if `|b - a|` is at least `m / 2`, it does not turn back: it stays between `a` and `b`.
//!
//! The joint rates bound everything else. Let the tool's path in the upright plane of the arm have
//! length `s` and second derivative `t`, and let `c` be the least cosine of rear minus forearm
//! angle on it. Each end of a link moves by at most `s / c`, and the second derivatives of
//! `135 rear` and `160 fore` (in radians) are at most `(t + (s/c)^2 (1/135 + 1/160)) / c`. For a
//! point at distance `r` from the axis, while the base turns with `B'` and `B''`, add
//! `r (B'^2 + B'') + 2 s B'`. The distance from pivot to wrist gives `c`; within the limits of a
//! stock arm it is at least 0.46.

use dobot_arm::{Calibration, FOREARM, Joints, Pose, REAR_ARM, Tool};
use dobot_motion::{ArmPlace, Interpolation, TurnBounds};

use crate::Bounds;
use crate::body::{MEASURES, Measure};

/// Bounds of second derivatives by the share of the path between two points.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct SweptPath {
    /// For each measure, in its unit.
    measures: [f64; MEASURES],
    elbow_mm: f64,
    wrist_mm: f64,
    tool_mm: f64,
}

impl SweptPath {
    /// Returns the bounds between two raw positions at two shares of their segment; `None` if they are
    /// too far apart.
    pub(crate) fn between(
        interpolation: Interpolation,
        [from, to]: [f64; 2],
        a: &ArmPlace,
        b: &ArmPlace,
        tool: Tool,
        arm: &Calibration,
    ) -> Option<Self> {
        let flat = match interpolation {
            Interpolation::Joints => {
                return Turns::evenly(&a.joints, &b.joints).swept_path(a, b, arm);
            }
            Interpolation::Stretched(stretching) => {
                return Turns::stretched(stretching.between(from, to)).swept_path(a, b, arm);
            }
            Interpolation::Line => Flat::line(&a.pose, &b.pose)?,
            Interpolation::Around => Flat::around(a, b),
        };
        let turns = flat.turns(a, b, tool.reach().0)?;
        // For an arm that is not as drawn, none of its lines is exactly straight.
        if arm.is_none() {
            Some(flat.swept_path(interpolation, &turns, arm))
        } else {
            turns.swept_path(a, b, arm)
        }
    }

    /// Returns the range of a measure between two points where it is `a` and `b`.
    pub(crate) fn span(&self, measure: Measure, a: f64, b: f64) -> Bounds {
        let stray = self.measures[measure as usize] / 8.0;
        let ends = Bounds::new(a.min(b), a.max(b));
        if ends.max - ends.min >= 4.0 * stray {
            return ends;
        }
        ends.grown(stray)
    }

    /// Returns how far the ends of rear arm, forearm, hand and tool stray from straight lines, in
    /// mm.
    pub(crate) const fn strays_mm(&self) -> [f64; 4] {
        let [elbow, wrist, tool] = [self.elbow_mm, self.wrist_mm, self.tool_mm];
        [
            elbow / 8.0,
            elbow.max(wrist) / 8.0,
            wrist.max(tool) / 8.0,
            tool / 8.0,
        ]
    }
}

/// The turns of the joints: bounds of first and second derivatives, in radians.
struct Turns {
    base: f64,
    base_2: f64,
    rear: f64,
    rear_2: f64,
    fore: f64,
    fore_2: f64,
}

impl Turns {
    /// All joints turn evenly.
    fn evenly(a: &Joints, b: &Joints) -> Self {
        let way = |from: f64, to: f64| (to - from).abs().to_radians();
        Self {
            base: way(a.base.0, b.base.0),
            base_2: 0.0,
            rear: way(a.rear.0, b.rear.0),
            rear_2: 0.0,
            fore: way(a.fore.0, b.fore.0),
            fore_2: 0.0,
        }
    }

    /// Each joint turns with timing of its own.
    fn stretched(turns: [TurnBounds; 3]) -> Self {
        let [base, rear, fore] =
            turns.map(|turn| [turn.first_deg, turn.second_deg].map(f64::to_radians));
        Self {
            base: base[0],
            base_2: base[1],
            rear: rear[0],
            rear_2: rear[1],
            fore: fore[0],
            fore_2: fore[1],
        }
    }

    /// Returns the bounds for the arm with its calibration: zeros change no derivative, and a
    /// displaced tool turns with base and forearm as the drawn tool does.
    fn swept_path(&self, a: &ArmPlace, b: &ArmPlace, arm: &Calibration) -> Option<SweptPath> {
        let [rear_mm, fore_mm] = [REAR_ARM.0 * self.rear, FOREARM.0 * self.fore];
        let way_mm = rear_mm + fore_mm;
        let flat_v2 = rear_mm * self.rear
            + fore_mm * self.fore
            + REAR_ARM.0 * self.rear_2
            + FOREARM.0 * self.fore_2;
        let farthest_mm = FARTHEST_MM + arm.reach_mm.abs() + arm.left_mm.abs();
        let tool_mm = turned(farthest_mm, way_mm, flat_v2, self.base, self.base_2);
        // A tool displaced sideways is farther from the axis than the plane shows.
        let reach_mm = if arm.is_none() {
            flat_v2
        } else {
            let speed_mm = way_mm + farthest_mm * self.base;
            let axis_mm = arm.axis_mm[0].hypot(arm.axis_mm[1]);
            let least_mm = a.pose.position.reach().0.min(b.pose.position.reach().0)
                - speed_mm
                - arm.reach_mm.abs()
                - axis_mm;
            if least_mm < NEAR_MM {
                return None;
            }
            tool_mm + speed_mm * speed_mm / least_mm
        };
        let degrees = f64::to_degrees;
        Some(SweptPath {
            measures: [
                degrees(self.base_2),
                degrees(self.rear_2),
                degrees(self.fore_2),
                degrees(self.base_2),
                degrees(self.rear_2 + self.fore_2),
                tool_mm,
                tool_mm,
                flat_v2,
                reach_mm,
                flat_v2 + slope(arm) * tool_mm,
            ],
            elbow_mm: turned(
                REAR_ARM.0,
                rear_mm,
                rear_mm * self.rear + REAR_ARM.0 * self.rear_2,
                self.base,
                self.base_2,
            ),
            wrist_mm: tool_mm,
            tool_mm,
        })
    }
}

/// The motion of the tool in the vertical plane of the arm, and the turn of that plane: bounds of
/// first and second derivatives.
#[derive(Default)]
struct Flat {
    /// Distance in the plane, in mm.
    way_mm: f64,
    /// Second derivative of the reach, in mm.
    reach_mm: f64,
    /// Base angle, in radians.
    base: f64,
    base_2: f64,
}

impl Flat {
    /// A straight line in space; `None` if it may pass too close to the axis.
    fn line(a: &Pose, b: &Pose) -> Option<Self> {
        let (from, to) = (a.position, b.position);
        let [x, y] = [to.x.0 - from.x.0, to.y.0 - from.y.0];
        let level_mm = x.hypot(y);
        let way_mm = level_mm.hypot(to.z.0 - from.z.0);
        if level_mm < LEVEL_MM {
            return Some(Self {
                way_mm,
                ..Self::default()
            });
        }
        // The distance from the axis of the infinite line, and of the segment.
        let off_mm = (from.x.0 * to.y.0 - to.x.0 * from.y.0).abs() / level_mm;
        let ends_mm = from.reach().0.min(to.reach().0);
        let nearest_mm = off_mm.max(ends_mm - 0.5 * level_mm);
        if nearest_mm < NEAREST_MM {
            return None;
        }
        let base = off_mm * level_mm / (nearest_mm * nearest_mm);
        Some(Self {
            way_mm,
            reach_mm: nearest_mm * base * base,
            base,
            base_2: 2.0 * level_mm / nearest_mm * base,
        })
    }

    /// Reach, base angle and height change evenly.
    fn around(a: &ArmPlace, b: &ArmPlace) -> Self {
        let (from, to) = (a.pose.position, b.pose.position);
        let reach_mm = to.reach().0 - from.reach().0;
        Self {
            way_mm: reach_mm.hypot(to.z.0 - from.z.0),
            reach_mm: 0.0,
            base: (b.joints.base.0 - a.joints.base.0).abs().to_radians(),
            base_2: 0.0,
        }
    }

    /// Returns the turns of the joints for this motion; `None` if they may turn at any speed.
    fn turns(&self, a: &ArmPlace, b: &ArmPlace, tool_reach_mm: f64) -> Option<Turns> {
        let fold = least_fold(a, b, tool_reach_mm, self.way_mm)?;
        // The distances moved by the links, and their second derivatives.
        let link_mm = self.way_mm / fold;
        let [rear, fore] = [link_mm / REAR_ARM.0, link_mm / FOREARM.0];
        let link_2_mm = (self.reach_mm + link_mm * (rear + fore)) / fold;
        Some(Turns {
            base: self.base,
            base_2: self.base_2,
            rear,
            rear_2: link_2_mm / REAR_ARM.0,
            fore,
            fore_2: link_2_mm / FOREARM.0,
        })
    }

    /// Returns the bounds for an arm as drawn, whose tool moves exactly like this.
    fn swept_path(
        &self,
        interpolation: Interpolation,
        turns: &Turns,
        arm: &Calibration,
    ) -> SweptPath {
        let degrees = f64::to_degrees;
        let tool_mm = if interpolation == Interpolation::Around {
            turned(FARTHEST_MM, self.way_mm, 0.0, self.base, 0.0)
        } else {
            0.0
        };
        let elbow_mm = REAR_ARM.0 * turns.rear;
        let elbow_2_mm = REAR_ARM.0 * turns.rear_2 + elbow_mm * turns.rear;
        SweptPath {
            measures: [
                degrees(self.base_2),
                degrees(turns.rear_2),
                degrees(turns.fore_2),
                degrees(self.base_2),
                degrees(turns.rear_2 + turns.fore_2),
                tool_mm,
                tool_mm,
                0.0,
                self.reach_mm,
                slope(arm) * tool_mm,
            ],
            elbow_mm: turned(REAR_ARM.0, elbow_mm, elbow_2_mm, self.base, self.base_2),
            wrist_mm: turned(
                FARTHEST_MM,
                self.way_mm,
                self.reach_mm,
                self.base,
                self.base_2,
            ),
            tool_mm,
        }
    }
}

/// Returns the steepest rise of the table, in mm per mm.
fn slope(arm: &Calibration) -> f64 {
    arm.table
        .map_or(0.0, |table| table.slope_x.hypot(table.slope_y))
}

/// Returns the second derivative of a point at most `radius_mm` from the axis: it moves in the
/// vertical plane with `way_mm` and `way_2_mm`, and the plane turns with `base` and `base_2`.
fn turned(radius_mm: f64, way_mm: f64, way_2_mm: f64, base: f64, base_2: f64) -> f64 {
    way_2_mm + radius_mm * (base * base + base_2) + 2.0 * way_mm * base
}

/// Returns the smallest cosine of rear minus forearm angle between two positions at this distance
/// in the plane; `None` if the arm may be stretched or folded so far that its joints turn at any
/// speed.
///
/// It follows from the distance between pivot and wrist: `d * d = 135 * 135 + 160 * 160 + 2 * 135 *
/// 160 * sin(rear - fore)`.
fn least_fold(a: &ArmPlace, b: &ArmPlace, tool_reach_mm: f64, way_mm: f64) -> Option<f64> {
    let stretch_mm = |place: &ArmPlace| {
        let position = place.pose.position;
        (position.reach().0 - tool_reach_mm).hypot(position.z.0)
    };
    let [a_mm, b_mm] = [stretch_mm(a), stretch_mm(b)];
    let least_mm = a_mm.min(b_mm) - 0.5 * way_mm;
    let most_mm = a_mm.max(b_mm) + 0.5 * way_mm;
    let cos = |d_mm: f64| {
        let sin = (d_mm * d_mm - LINKS_V2) / (2.0 * REAR_ARM.0 * FOREARM.0);
        (1.0 - sin * sin).max(0.0).sqrt()
    };
    let fold = cos(least_mm).min(cos(most_mm));
    (least_mm > FOREARM.0 - REAR_ARM.0 && fold > MIN_FOLD).then_some(fold)
}

/// The fold follows from the difference of the squared stretches; this is the squared stretch of a
/// right angle.
const LINKS_V2: f64 = REAR_ARM.0 * REAR_ARM.0 + FOREARM.0 * FOREARM.0;

/// No part of the arm is farther from the axis than its links and the longest tool.
const FARTHEST_MM: f64 = REAR_ARM.0 + FOREARM.0 + Tool::SuctionCup.reach().0;

/// If the reach of the tool is smaller than this, the path is checked in shorter pieces.
const NEAR_MM: f64 = 20.0;

/// A line that passes the axis closer than this is checked in shorter pieces.
const NEAREST_MM: f64 = 1.0;

/// A line that moves less than this horizontally is vertical.
const LEVEL_MM: f64 = 1e-9;

/// A stock arm within its limits never has less than 0.46.
const MIN_FOLD: f64 = 0.1;
