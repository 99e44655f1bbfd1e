//! A binary tree of boxes around items.

use std::ops::Range;

use kurbo::{Point, Rect};

use crate::bounds;

/// A bounding volume hierarchy over sorted items.
///
/// Every box owns a range of items, so that neighbours are also close in memory. The tree stores
/// the boxes, its user the items.
#[derive(Debug)]
pub struct BoxTree {
    /// Node 0 is the root; the left child of a node is the next one.
    nodes: Vec<Node>,
}

#[derive(Debug)]
struct Node {
    bounds: Rect,
    items: Range<u32>,
    /// The right child; `NONE` in a leaf.
    right: u32,
}

impl BoxTree {
    /// Sorts the items by the segments between their two ends and builds the tree.
    ///
    /// # Panics
    ///
    /// If there are 2^32 items or more.
    pub fn sort<T>(items: &mut [T], ends: impl Fn(&T) -> (Point, Point)) -> Self {
        let mut nodes = Vec::with_capacity(items.len() / 2 + 1);
        build(&mut nodes, items, 0, &ends);
        Self { nodes }
    }

    /// Returns the number of items of each node, by node number.
    pub fn counts(&self) -> impl Iterator<Item = u32> {
        self.nodes
            .iter()
            .map(|node| node.items.end - node.items.start)
    }

    /// The nodes that own an item, the root first.
    pub fn owners(&self, item: u32) -> impl Iterator<Item = u32> {
        std::iter::successors(Some(0), move |&id| {
            let right = self.node(id).right;
            let is_left = right != NONE && item < self.node(right).items.start;
            (right != NONE).then_some(if is_left { id + 1 } else { right })
        })
    }

    /// Calls `visit` for the items of the leaves nearer to `p` than the squared distance `limit2`,
    /// nearer boxes first; it returns the limit from there on. Boxes that are not `is_sought`, by
    /// number and bounds, are left out.
    pub fn around(
        &self,
        p: Point,
        mut limit2: f64,
        is_sought: &impl Fn(u32, Rect) -> bool,
        visit: &mut impl FnMut(Range<u32>) -> f64,
    ) {
        self.around_in(0, p, &mut limit2, is_sought, visit);
    }

    fn around_in(
        &self,
        id: u32,
        p: Point,
        limit2: &mut f64,
        is_sought: &impl Fn(u32, Rect) -> bool,
        visit: &mut impl FnMut(Range<u32>) -> f64,
    ) {
        let node = self.node(id);
        if node.right == NONE {
            *limit2 = visit(node.items.clone());
            return;
        }
        let child = |id| (distance2(self.node(id).bounds, p), id);
        let (mut near, mut far) = (child(id + 1), child(node.right));
        if far.0 < near.0 {
            std::mem::swap(&mut near, &mut far);
        }
        for (distance2, child) in [near, far] {
            if distance2 < *limit2 && is_sought(child, self.node(child).bounds) {
                self.around_in(child, p, limit2, is_sought, visit);
            }
        }
    }

    /// Calls `visit` for the items of every leaf whose box touches `area`.
    pub fn touching(&self, area: Rect, visit: &mut impl FnMut(Range<u32>)) {
        self.touching_in(0, area, visit);
    }

    fn touching_in(&self, id: u32, area: Rect, visit: &mut impl FnMut(Range<u32>)) {
        let node = self.node(id);
        if !node.bounds.overlaps(area) {
            return;
        }
        if node.right == NONE {
            visit(node.items.clone());
        } else {
            self.touching_in(id + 1, area, visit);
            self.touching_in(node.right, area, visit);
        }
    }

    fn node(&self, id: u32) -> &Node {
        &self.nodes[id as usize]
    }
}

fn build<T>(
    nodes: &mut Vec<Node>,
    items: &mut [T],
    start: u32,
    ends: &impl Fn(&T) -> (Point, Point),
) -> u32 {
    let id = number(nodes.len());
    let bounds = bounds(items.iter().map(ends).flat_map(|(a, b)| [a, b]));
    nodes.push(Node {
        bounds,
        items: start..start + number(items.len()),
        right: NONE,
    });
    if items.len() > LEAF_ITEMS {
        let by_y = bounds.width() < bounds.height();
        let middle = halve(items, by_y, ends);
        let (left, right) = items.split_at_mut(middle);
        build(nodes, left, start, ends);
        nodes[id as usize].right = build(nodes, right, start + number(middle), ends);
    }
    id
}

/// Partitions the items at their median along one axis; returns its index.
fn halve<T>(items: &mut [T], by_y: bool, ends: &impl Fn(&T) -> (Point, Point)) -> usize {
    let middle = items.len() / 2;
    let key = |item: &T| {
        let (a, b) = ends(item);
        if by_y { a.y + b.y } else { a.x + b.x }
    };
    items.select_nth_unstable_by(middle, |a, b| key(a).total_cmp(&key(b)));
    middle
}

/// The squared distance of a rectangle to a point; 0 inside.
fn distance2(bounds: Rect, p: Point) -> f64 {
    let dx = (bounds.x0 - p.x).max(p.x - bounds.x1).max(0.0);
    let dy = (bounds.y0 - p.y).max(p.y - bounds.y1).max(0.0);
    dx * dx + dy * dy
}

fn number(count: usize) -> u32 {
    u32::try_from(count).expect("a drawing holds far fewer than 2^32")
}

const NONE: u32 = u32::MAX;
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
        fn the_nearest_point_is_that_of_an_exhaustive_search(
            mut points in proptest::collection::vec(point(), 1..80),
            p in point(),
        ) {
            let tree = BoxTree::sort(&mut points, |&p| (p, p));
            let away2 = |q: &Point| (q.x - p.x).powi(2) + (q.y - p.y).powi(2);
            let mut found = f64::INFINITY;
            tree.around(p, f64::INFINITY, &|_, _| true, &mut |items| {
                let leaf = &points[items.start as usize..items.end as usize];
                found = leaf.iter().map(away2).fold(found, f64::min);
                found
            });
            prop_assert_eq!(found, points.iter().map(away2).fold(f64::INFINITY, f64::min));
        }
    }
}
