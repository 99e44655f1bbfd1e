//! A tree of nodes over points, for the nearest few of each.

use dobot_geometry::{Bounds, Point};

/// Points, sorted so that every box of the tree holds a range of them; this order keeps
/// neighbours together in memory too.
///
/// It has no place for what [`SegmentIndex`](crate::index::SegmentIndex) keeps for each item, its
/// number as given and whether it is still there: here the points take the tree's own order, so
/// that a search walks through memory from end to end, and none of them leaves.
#[derive(Debug)]
pub(super) struct PointTree {
    nodes: Vec<Node>,
}

impl PointTree {
    /// Sorts the items by place, and makes the tree over them.
    pub(super) fn sort<T>(items: &mut [T], at: impl Fn(&T) -> Point) -> Self {
        let mut nodes = Vec::with_capacity(items.len() / 2 + 1);
        build(&mut nodes, items, 0, &at);
        Self { nodes }
    }

    /// Calls `visit` for the points around `p`, nearer nodes first; it returns the squared distance
    /// beyond which no point is of interest any more. Given bounds, it leaves out most of what lies
    /// outside of them, and heaps of points at `p` itself.
    pub(super) fn around(
        &self,
        points: &[Point],
        p: Point,
        within: Option<Bounds>,
        visit: &mut impl FnMut(u32, f64) -> f64,
    ) {
        if !self.nodes.is_empty() {
            let mut limit2 = f64::INFINITY;
            self.around_in(0, points, p, within, &mut limit2, visit);
        }
    }

    fn around_in(
        &self,
        id: u32,
        points: &[Point],
        p: Point,
        within: Option<Bounds>,
        limit2: &mut f64,
        visit: &mut impl FnMut(u32, f64) -> f64,
    ) {
        let node = &self.nodes[id as usize];
        if node.right == LEAF {
            for item in node.start..node.end {
                let distance2 = (points[item as usize] - p).length2();
                if distance2 < *limit2 {
                    *limit2 = visit(item, distance2);
                }
            }
            return;
        }
        let mut children =
            [id + 1, node.right].map(|c| (self.nodes[c as usize].bounds.distance2(p), c));
        if children[1].0 < children[0].0 {
            children.swap(0, 1);
        }
        for (distance2, child) in children {
            let bounds = self.nodes[child as usize].bounds;
            let is_sought = within.is_none_or(|within| bounds.touches(within) && !is_at(bounds, p));
            if distance2 < *limit2 && is_sought {
                self.around_in(child, points, p, within, limit2, visit);
            }
        }
    }
}

#[derive(Debug)]
struct Node {
    bounds: Bounds,
    start: u32,
    end: u32,
    /// The left child is the next box; `LEAF` where there is none.
    right: u32,
}

fn build<T>(nodes: &mut Vec<Node>, items: &mut [T], start: u32, at: &impl Fn(&T) -> Point) -> u32 {
    let id = number(nodes.len());
    let bounds: Bounds = items.iter().map(at).collect();
    nodes.push(Node {
        bounds,
        start,
        end: start + number(items.len()),
        right: LEAF,
    });
    if items.len() > LEAF_ITEMS {
        let middle = items.len() / 2;
        if bounds.width() < bounds.height() {
            items.select_nth_unstable_by(middle, |a, b| at(a).y.total_cmp(&at(b).y));
        } else {
            items.select_nth_unstable_by(middle, |a, b| at(a).x.total_cmp(&at(b).x));
        }
        let (left, right) = items.split_at_mut(middle);
        build(nodes, left, start, at);
        let child = build(nodes, right, start + number(middle), at);
        nodes[id as usize].right = child;
    }
    id
}

fn is_at(bounds: Bounds, p: Point) -> bool {
    bounds.min == p && bounds.max == p
}

fn number(count: usize) -> u32 {
    u32::try_from(count).expect("a drawing holds far fewer than 2^32 points")
}

const LEAF: u32 = u32::MAX;
const LEAF_ITEMS: usize = 8;

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn point() -> impl Strategy<Value = Point> {
        (-9..9_i32, -9..9_i32).prop_map(|(x, y)| Point::new(f64::from(x), f64::from(y)))
    }

    proptest! {
        #[test]
        fn the_nearest_point_is_as_near_as_by_looking_at_all_of_them(
            mut points in proptest::collection::vec(point(), 1..80),
            p in point(),
        ) {
            let tree = PointTree::sort(&mut points, |&p| p);
            let mut found = f64::INFINITY;
            tree.around(&points, p, None, &mut |_, distance2| {
                found = distance2;
                found
            });
            let distances = points.iter().map(|&other| (other - p).length2());
            prop_assert_eq!(found, distances.fold(f64::INFINITY, f64::min));
        }
    }
}
