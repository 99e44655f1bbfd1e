//! A tree of boxes around segments: which is nearest, which lie here.

use crate::{Bounds, Point};

/// Segments sorted into a binary tree of boxes. Items are numbered as they were given; a point is
/// a segment of length zero.
///
/// Items keep their numbers and can be taken out. Points that all stay and may take an order of the
/// tree's own have a leaner one, in the order of `dobot-draw`.
#[derive(Debug)]
pub struct SegmentIndex {
    segments: Vec<(Point, Point)>,
    /// The items, such that every node owns a range of them.
    items: Vec<u32>,
    /// Node 0 is the root; the left child of a node is the next one.
    nodes: Vec<Node>,
    /// For each item its leaf; `NONE` once it is removed.
    leaf_of: Vec<u32>,
    /// How often the distance of an item was asked for.
    #[cfg(test)]
    pub visits: std::cell::Cell<usize>,
}

impl SegmentIndex {
    /// Sorts the segments.
    ///
    /// # Panics
    ///
    /// With 2^32 segments or more.
    #[must_use]
    pub fn new(segments: Vec<(Point, Point)>) -> Self {
        let count = u32::try_from(segments.len()).expect("a drawing holds far fewer than 2^32");
        let mut index = Self {
            items: (0..count).collect(),
            leaf_of: vec![NONE; segments.len()],
            nodes: Vec::with_capacity(segments.len() / 2 + 1),
            segments,
            #[cfg(test)]
            visits: std::cell::Cell::default(),
        };
        if count > 0 {
            index.build(0, count, NONE);
        }
        index
    }

    /// Takes an item out of all later answers.
    pub fn remove(&mut self, item: u32) {
        let leaf = &mut self.leaf_of[item as usize];
        let mut node = std::mem::replace(leaf, NONE);
        while node != NONE {
            let node_ref = &mut self.nodes[node as usize];
            node_ref.alive -= 1;
            node = node_ref.parent;
        }
    }

    /// The item nearest to a point and the squared distance to it; of equals the first.
    #[must_use]
    pub fn nearest(&self, p: Point) -> Option<(u32, f64)> {
        let mut best = (NONE, f64::INFINITY);
        if !self.nodes.is_empty() {
            self.nearest_in(0, p, &mut best);
        }
        (best.0 != NONE).then_some(best)
    }

    /// An item that is not removed and its squared distance to a point: of the nearest, or of any
    /// that is as near as `enough2`. `near` is an item not far from the point.
    #[must_use]
    pub fn nearest_from(&self, near: u32, p: Point, enough2: f64) -> Option<(u32, f64)> {
        let is_there = self
            .leaf_of
            .get(near as usize)
            .is_some_and(|&it| it != NONE);
        let mut best = if is_there {
            (near, self.distance2(near, p))
        } else {
            (NONE, f64::INFINITY)
        };
        if !self.nodes.is_empty() && best.1 > enough2 {
            self.near_in(0, p, enough2, &mut best);
        }
        (best.0 != NONE).then_some(best)
    }

    /// Calls `visit` for every item whose box touches `area`.
    pub fn touching(&self, area: Bounds, visit: &mut impl FnMut(u32)) {
        if !self.nodes.is_empty() {
            self.touching_in(0, area, visit);
        }
    }

    /// All items, in the order given.
    #[must_use]
    pub fn segments(&self) -> &[(Point, Point)] {
        &self.segments
    }

    /// The two ends of an item.
    #[must_use]
    pub fn segment(&self, item: u32) -> (Point, Point) {
        self.segments[item as usize]
    }

    fn build(&mut self, start: u32, end: u32, parent: u32) -> u32 {
        let id = u32::try_from(self.nodes.len()).expect("fewer nodes than items");
        let bounds = self.bounds(start, end);
        self.nodes.push(Node {
            bounds,
            start,
            end,
            right: NONE,
            parent,
            alive: end - start,
        });
        if end - start <= LEAF {
            for &item in &self.items[start as usize..end as usize] {
                self.leaf_of[item as usize] = id;
            }
            return id;
        }
        let middle = start + (end - start) / 2;
        self.split(start, middle, end, bounds.width() < bounds.height());
        self.build(start, middle, id);
        let right = self.build(middle, end, id);
        self.nodes[id as usize].right = right;
        id
    }

    fn split(&mut self, start: u32, middle: u32, end: u32, by_y: bool) {
        let segments = &self.segments;
        let key = |&item: &u32| {
            let (a, b) = segments[item as usize];
            if by_y { a.y + b.y } else { a.x + b.x }
        };
        self.items[start as usize..end as usize]
            .select_nth_unstable_by((middle - start) as usize, |a, b| key(a).total_cmp(&key(b)));
    }

    fn bounds(&self, start: u32, end: u32) -> Bounds {
        let items = &self.items[start as usize..end as usize];
        items.iter().fold(Bounds::EMPTY, |bounds, &item| {
            let (a, b) = self.segment(item);
            bounds.with(a).with(b)
        })
    }

    fn nearest_in(&self, id: u32, p: Point, best: &mut (u32, f64)) {
        let node = &self.nodes[id as usize];
        if node.right == NONE {
            self.nearest_in_leaf(node, p, best);
            return;
        }
        for (distance2, child) in self.children(id, p) {
            // Of equals the first counts, so that they must be looked at too.
            if distance2 <= best.1 && self.nodes[child as usize].alive > 0 {
                self.nearest_in(child, p, best);
            }
        }
    }

    fn nearest_in_leaf(&self, node: &Node, p: Point, best: &mut (u32, f64)) {
        for &item in self.alive(node) {
            let distance2 = self.distance2(item, p);
            if distance2 < best.1 || (distance2 == best.1 && item < best.0) {
                *best = (item, distance2);
            }
        }
    }

    /// As [`nearest_in`](Self::nearest_in) where any of equals will do.
    fn near_in(&self, id: u32, p: Point, enough2: f64, best: &mut (u32, f64)) {
        let node = &self.nodes[id as usize];
        if node.right == NONE {
            self.near_in_leaf(node, p, enough2, best);
            return;
        }
        for (distance2, child) in self.children(id, p) {
            let is_nearer = distance2 < best.1 && best.1 > enough2;
            if is_nearer && self.nodes[child as usize].alive > 0 {
                self.near_in(child, p, enough2, best);
            }
        }
    }

    fn near_in_leaf(&self, node: &Node, p: Point, enough2: f64, best: &mut (u32, f64)) {
        for &item in self.alive(node) {
            let distance2 = self.distance2(item, p);
            if distance2 < best.1 {
                *best = (item, distance2);
            }
            if best.1 <= enough2 {
                return;
            }
        }
    }

    /// The two children of a node and how far their boxes are, the nearer first.
    fn children(&self, id: u32, p: Point) -> [(f64, u32); 2] {
        let right = self.nodes[id as usize].right;
        let mut children = [id + 1, right].map(|c| (self.nodes[c as usize].distance2(p), c));
        if children[1].0 < children[0].0 {
            children.swap(0, 1);
        }
        children
    }

    fn distance2(&self, item: u32, p: Point) -> f64 {
        #[cfg(test)]
        self.visits.set(self.visits.get() + 1);
        let (a, b) = self.segment(item);
        (p - p.nearest_on(a, b)).length2()
    }

    fn touching_in(&self, id: u32, area: Bounds, visit: &mut impl FnMut(u32)) {
        let node = &self.nodes[id as usize];
        if node.alive == 0 || !node.bounds.touches(area) {
            return;
        }
        if node.right != NONE {
            self.touching_in(id + 1, area, visit);
            self.touching_in(node.right, area, visit);
            return;
        }
        for &item in self.alive(node) {
            let (a, b) = self.segment(item);
            if Bounds::of([a, b]).touches(area) {
                visit(item);
            }
        }
    }

    fn alive(&self, node: &Node) -> impl Iterator<Item = &u32> {
        self.items[node.start as usize..node.end as usize]
            .iter()
            .filter(|item| self.leaf_of[**item as usize] != NONE)
    }
}

#[derive(Debug)]
struct Node {
    bounds: Bounds,
    start: u32,
    end: u32,
    /// `NONE` in a leaf.
    right: u32,
    parent: u32,
    alive: u32,
}

impl Node {
    fn distance2(&self, p: Point) -> f64 {
        self.bounds.distance2(p)
    }
}

const NONE: u32 = u32::MAX;
const LEAF: u32 = 6;

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn point() -> impl Strategy<Value = Point> {
        (-50..50_i32, -50..50_i32).prop_map(|(x, y)| Point::new(f64::from(x), f64::from(y)))
    }

    proptest! {
        #[test]
        fn finds_the_same_nearest_item_as_looking_at_all_of_them(
            segments in proptest::collection::vec((point(), point()), 1..80),
            removed in proptest::collection::vec(any::<bool>(), 80),
            p in point(),
        ) {
            let mut index = SegmentIndex::new(segments.clone());
            let mut best: Option<(u32, f64)> = None;
            for (item, &(a, b)) in (0..).zip(&segments) {
                if removed[item as usize] {
                    index.remove(item);
                    continue;
                }
                let distance2 = (p - p.nearest_on(a, b)).length2();
                if best.is_none_or(|best| distance2 < best.1) {
                    best = Some((item, distance2));
                }
            }
            prop_assert_eq!(index.nearest(p), best);
            for near in 0..=u32::try_from(segments.len()).unwrap_or(0) {
                let found = index.nearest_from(near, p, 0.0).map(|it| it.1.sqrt());
                let best = best.map(|it| it.1.sqrt());
                // Where a box ends at the nearest place, rounding may leave the one behind it.
                let same = found.zip(best).is_none_or(|(found, best)| (found - best).abs() < 1e-6);
                prop_assert!(same && found.is_some() == best.is_some(), "{found:?}, not {best:?}");
                let rough = index.nearest_from(near, p, 25.0).map(|it| it.1.sqrt());
                prop_assert_eq!(rough.is_some(), best.is_some());
                prop_assert!(rough.zip(best).is_none_or(|(rough, best)| rough <= best.max(5.0) + 1e-6));
            }
        }

        #[test]
        fn visits_exactly_the_boxes_that_touch(
            segments in proptest::collection::vec((point(), point()), 0..80),
            corners in (point(), point()),
        ) {
            let area = Bounds::of([corners.0, corners.1]);
            let mut found = Vec::new();
            SegmentIndex::new(segments.clone()).touching(area, &mut |item| found.push(item));
            found.sort_unstable();
            let expected: Vec<u32> = (0..)
                .zip(&segments)
                .filter(|(_, s)| Bounds::of([s.0, s.1]).touches(area))
                .map(|(item, _)| item)
                .collect();
            prop_assert_eq!(found, expected);
        }
    }
}
