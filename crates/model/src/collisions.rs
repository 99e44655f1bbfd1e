//! The pairs of links that a planner need not check for collisions, found by sampling poses.

use std::collections::BTreeMap;

use dobot_arm::{Joints, Tool};

use crate::joint::Joint;
use crate::model::{Model, Part};
use crate::mounted_tool::MountedTool;
use crate::shape::{Shape, Solid};

/// A pair of links that needs no check.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Unchecked {
    pub(crate) links: [&'static str; 2],
    pub(crate) reason: Reason,
}

/// Why a pair of links needs no check.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Reason {
    /// A joint or a pin connects them, or they turn about the same axis.
    Adjacent,
    /// They stayed apart in every sampled pose.
    Never,
}

impl Model {
    /// Returns the pairs of links with shapes that need no check: neighbours, and those that come no closer than 2 mm in 2,000
    /// poses which the arm's limits allow. Cylinders count as the boxes around them.
    pub(crate) fn unchecked_pairs(&self) -> Vec<Unchecked> {
        let parts: Vec<&Part> = self.solid_parts().collect();
        let near = self.near_parts(parts.len());
        let mut pairs = Vec::new();
        for one in 0..parts.len() {
            for other in 0..one {
                let links = [parts[other].name, parts[one].name];
                let reason = if self.are_adjacent(links) {
                    Reason::Adjacent
                } else if near[one][other] {
                    continue;
                } else {
                    Reason::Never
                };
                pairs.push(Unchecked { links, reason });
            }
        }
        pairs
    }

    /// Whether solid parts come near each other in any pose, by the larger index and then the smaller one.
    fn near_parts(&self, count: usize) -> Vec<Vec<bool>> {
        let mut near = vec![vec![false; count]; count];
        for joints in self.poses() {
            let boxes: Vec<Vec<Block>> = self.blocks(&joints);
            for one in 0..count {
                for other in 0..one {
                    near[one][other] |= are_near(&boxes[one], &boxes[other]);
                }
            }
        }
        near
    }

    fn solid_parts(&self) -> impl Iterator<Item = &Part> {
        self.parts.iter().filter(|part| !part.shapes.is_empty())
    }

    /// Whether a joint or a pin connects two links, or both turn about the same axis of a third one.
    fn are_adjacent(&self, links: [&str; 2]) -> bool {
        let is_pair = |one: &str, other: &str| links == [one, other] || links == [other, one];
        let joints = || self.joints.iter();
        let shares_axis = |one: &Joint, other: &Joint| {
            one.parent == other.parent
                && one.at_mm == other.at_mm
                && one.turn.axis() == other.turn.axis()
        };
        joints().any(|joint| is_pair(joint.parent, joint.child))
            || self
                .pins
                .iter()
                .any(|pin| is_pair(pin.parts[0], pin.parts[1]))
            || joints().any(|one| {
                let mut others = joints().filter(|other| shares_axis(one, other));
                others.any(|other| is_pair(one.child, other.child))
            })
    }

    /// Returns 2,000 poses within the limits, spread over all of them and their ends.
    fn poses(&self) -> impl Iterator<Item = Joints> + '_ {
        let tool = self.tool.map_or(Tool::SuctionCup, MountedTool::kind);
        let limits = self.limits;
        let spans = [limits.base, limits.rear, limits.fore, limits.servo];
        (1_u32..)
            .map(move |n| {
                let [base, rear, fore, servo] = std::array::from_fn(|axis| {
                    let share = (f64::from(n) * SPREAD[axis]).fract();
                    // A tenth of the poses is at an end.
                    let share = (share * 1.1 - 0.05).clamp(0.0, 1.0);
                    let [min, max] = [spans[axis].min.0, spans[axis].max.0];
                    min + (max - min) * share
                });
                Joints::new(base, rear, fore, servo)
            })
            .filter(move |joints| limits.check(joints, tool).is_ok())
            .take(POSES)
    }

    /// Returns the boxes of every part with a shape, in the base frame.
    fn blocks(&self, joints: &Joints) -> Vec<Vec<Block>> {
        let mut frames = BTreeMap::from([("base".to_owned(), Frame::BASE)]);
        for link in self.link_frames(joints) {
            let frame = frames[&*link.parent].then(&link.at_mm, &link.axis, link.angle.0);
            frames.insert(link.child.into_owned(), frame);
        }
        let of = |part: &Part| {
            let frame = &frames[part.name];
            part.shapes
                .iter()
                .map(|shape| Block::of(shape, frame))
                .collect()
        };
        self.solid_parts().map(of).collect()
    }
}

/// A frame in the base frame: its origin, and the directions of its axes.
#[derive(Clone, Copy, Debug)]
struct Frame {
    at_mm: [f64; 3],
    axes: [[f64; 3]; 3],
}

impl Frame {
    const BASE: Self = Self {
        at_mm: [0.0; 3],
        axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    };

    /// Returns the frame that is at a point of this one and turned about its Y or Z.
    fn then(&self, at_mm: &[f64; 3], axis: &[f64; 3], angle_deg: f64) -> Self {
        let [x, y, z] = self.axes;
        let (sin, cos) = angle_deg.to_radians().sin_cos();
        let mix = |a: [f64; 3], b: [f64; 3], sin: f64| [0, 1, 2].map(|n| cos * a[n] + sin * b[n]);
        let axes = if axis[2] == 1.0 {
            [mix(x, y, sin), mix(y, x, -sin), z]
        } else {
            [mix(x, z, -sin), y, mix(z, x, sin)]
        };
        Self {
            at_mm: self.point(at_mm),
            axes,
        }
    }

    fn point(&self, at_mm: &[f64; 3]) -> [f64; 3] {
        let [x, y, z] = self.axes;
        [0, 1, 2].map(|n| self.at_mm[n] + at_mm[0] * x[n] + at_mm[1] * y[n] + at_mm[2] * z[n])
    }
}

/// A box in the base frame.
#[derive(Clone, Copy, Debug)]
struct Block {
    frame: Frame,
    half_mm: [f64; 3],
}

impl Block {
    /// Returns the box around a shape, larger by half the gap that two links must keep.
    fn of(shape: &Shape, frame: &Frame) -> Self {
        let half_mm = match shape.solid {
            Solid::Box { size_mm } => size_mm.map(|edge| edge / 2.0),
            Solid::Pin { radius_mm, long_mm } => [radius_mm, long_mm / 2.0, radius_mm],
            Solid::Post { radius_mm, long_mm } => [radius_mm, radius_mm, long_mm / 2.0],
        };
        Self {
            frame: Frame {
                at_mm: frame.point(&shape.at_mm),
                ..*frame
            },
            half_mm: half_mm.map(|half| half + GAP_MM / 2.0),
        }
    }

    /// Whether two boxes overlap: no plane separates them (separating axis theorem).
    fn overlaps(&self, other: &Self) -> bool {
        let between = [0, 1, 2].map(|n| other.frame.at_mm[n] - self.frame.at_mm[n]);
        let (ours, theirs) = (self.frame.axes, other.frame.axes);
        let edges = ours.into_iter().flat_map(|a| theirs.map(|b| cross(a, b)));
        let mut directions = ours.into_iter().chain(theirs).chain(edges);
        !directions.any(|direction| {
            let reach = self.reach(direction) + other.reach(direction);
            dot(between, direction).abs() > reach + ROUNDING
        })
    }

    /// Returns half the extent along a direction.
    fn reach(&self, direction: [f64; 3]) -> f64 {
        let along = self.frame.axes.into_iter().zip(self.half_mm);
        along
            .map(|(axis, half)| half * dot(axis, direction).abs())
            .sum()
    }
}

fn are_near(some: &[Block], others: &[Block]) -> bool {
    let touches = |one: &Block| others.iter().any(|other| one.overlaps(other));
    some.iter().any(touches)
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

const POSES: usize = 2000;
/// The gap that a pair keeps which needs no check: more than links approach each other between two sampled poses.
const GAP_MM: f64 = 2.0;
/// Of products of unit vectors that are parallel.
const ROUNDING: f64 = 1e-9;
/// Multiples of these, without their whole parts, fill a cube of four dimensions evenly: powers of the root of
/// x^5 = x + 1.
const SPREAD: [f64; 4] = [
    0.856_674_883_854_502_9,
    0.733_891_856_627_126,
    0.628_706_721_037_809_1,
    0.538_597_257_223_612_7,
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::{Colour, cuboid};

    fn block(from: [f64; 3], to: [f64; 3], turned_deg: f64) -> Block {
        let shape = cuboid(from, to, Colour::Dark);
        let frame = Frame::BASE.then(&[0.0; 3], &[0.0, 0.0, 1.0], turned_deg);
        Block::of(&shape, &frame)
    }

    #[test]
    fn boxes_overlap_only_if_nothing_separates_them() {
        let cube = block([-10.0; 3], [10.0; 3], 0.0);
        // With the gap, a corner of the turned cube reaches 11 sqrt(2) = 15.6 mm ahead.
        let turned = block([-10.0; 3], [10.0; 3], 45.0);
        let beside = |x: f64| block([x, -1.0, -1.0], [x + 5.0, 1.0, 1.0], 0.0);
        for (one, other, expected) in [
            (&cube, beside(11.9), true),
            (&cube, beside(12.1), false),
            (&turned, beside(16.0), true),
            (&turned, beside(16.7), false),
        ] {
            assert_eq!(one.overlaps(&other), expected, "{other:?}");
            assert_eq!(other.overlaps(one), expected, "{other:?}");
        }
    }

    #[test]
    fn neighbours_and_links_on_different_sides_need_no_check_but_the_wrist_does() {
        use crate::MountedTool;
        use dobot_arm::Millimeters;

        let tool = MountedTool::new(Tool::Gripper, Millimeters(90.0)).expect("it is allowed");
        let pairs = Model::new(Some(tool)).unchecked_pairs();
        let reason = |links| {
            let found = pairs.iter().find(|pair| pair.links == links);
            found.map(|pair| pair.reason)
        };
        assert_eq!(reason(["base", "turret"]), Some(Reason::Adjacent));
        // A pin closes the loop.
        assert_eq!(reason(["forearm", "crank_rod"]), Some(Reason::Adjacent));
        assert_eq!(reason(["rear_arm", "crank"]), Some(Reason::Adjacent));
        assert_eq!(reason(["rear_rod", "crank_rod"]), Some(Reason::Never));
        // A folded arm gets to its foot.
        assert_eq!(reason(["base", "wrist"]), None);
    }
}
