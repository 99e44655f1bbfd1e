//! A spatial index of segments for nearest and overlap queries.

use std::ops::Range;

use kurbo::{Line, ParamCurveNearest, Point, Rect};

use crate::BoxTree;

/// A spatial index of segments. Items keep the numbers in which they were given and can be removed;
/// a point is a segment of length zero.
#[derive(Debug)]
pub struct SegmentIndex {
    segments: Vec<(Point, Point)>,
    tree: BoxTree,
    /// The items in tree order.
    items: Vec<u32>,
    /// The position of each item in tree order; `NONE` once it is removed.
    place_of: Vec<u32>,
    /// The number of remaining items of each node of the tree.
    alive: Vec<u32>,
    /// The number of distance computations.
    #[cfg(test)]
    pub visits: std::cell::Cell<usize>,
}

impl SegmentIndex {
    /// Builds the index.
    ///
    /// # Panics
    ///
    /// If there are 2^32 segments or more.
    #[must_use]
    pub fn new(segments: Vec<(Point, Point)>) -> Self {
        let mut items: Vec<u32> = (0..).take(segments.len()).collect();
        let tree = BoxTree::sort(&mut items, |&item| segments[item as usize]);
        let mut place_of = vec![NONE; segments.len()];
        for (place, &item) in (0..).zip(&items) {
            place_of[item as usize] = place;
        }
        Self {
            alive: tree.counts().collect(),
            segments,
            tree,
            items,
            place_of,
            #[cfg(test)]
            visits: std::cell::Cell::default(),
        }
    }

    /// Removes an item from all later queries.
    pub fn remove(&mut self, item: u32) {
        let place = std::mem::replace(&mut self.place_of[item as usize], NONE);
        if place != NONE {
            for node in self.tree.owners(place) {
                self.alive[node as usize] -= 1;
            }
        }
    }

    /// Returns the item nearest to a point and its squared distance; among equals, the first item.
    #[must_use]
    pub fn nearest(&self, p: Point) -> Option<(u32, f64)> {
        let mut best = (NONE, f64::INFINITY);
        self.around(p, f64::INFINITY, &mut |items| {
            for item in self.alive(items) {
                let distance2 = self.distance2(item, p);
                if distance2 < best.1 || (distance2 == best.1 && item < best.0) {
                    best = (item, distance2);
                }
            }
            // Among equals the first item wins, so equal distances must be visited too.
            best.1.next_up()
        });
        (best.0 != NONE).then_some(best)
    }

    /// Returns a remaining item and its squared distance to a point: the nearest, or any within
    /// `enough2`. `near` is an item close to the point.
    #[must_use]
    pub fn nearest_from(&self, near: u32, p: Point, enough2: f64) -> Option<(u32, f64)> {
        let place = self.place_of.get(near as usize);
        let mut best = if place.is_some_and(|&place| place != NONE) {
            (near, self.distance2(near, p))
        } else {
            (NONE, f64::INFINITY)
        };
        if best.1 > enough2 {
            self.around(p, best.1, &mut |items| {
                for item in self.alive(items) {
                    let distance2 = self.distance2(item, p);
                    if distance2 < best.1 {
                        best = (item, distance2);
                    }
                    if best.1 <= enough2 {
                        return 0.0;
                    }
                }
                best.1
            });
        }
        (best.0 != NONE).then_some(best)
    }

    /// Calls `visit` for every item whose box touches `area` and returns the number of items
    /// examined.
    pub fn touching(&self, area: Rect, visit: &mut impl FnMut(u32)) -> usize {
        let mut looks = 0;
        self.tree.touching(area, &mut |items| {
            looks += items.len();
            for item in self.alive(items) {
                let (a, b) = self.segment(item);
                if Rect::from_points(a, b).overlaps(area) {
                    visit(item);
                }
            }
        });
        looks
    }

    /// Returns all items in the order given.
    #[must_use]
    pub fn segments(&self) -> &[(Point, Point)] {
        &self.segments
    }

    /// Returns the two ends of an item.
    #[must_use]
    pub fn segment(&self, item: u32) -> (Point, Point) {
        self.segments[item as usize]
    }

    fn around(&self, p: Point, limit2: f64, visit: &mut impl FnMut(Range<u32>) -> f64) {
        let is_sought = |node: u32, _: Rect| self.alive[node as usize] > 0;
        self.tree.around(p, limit2, &is_sought, visit);
    }

    fn alive(&self, items: Range<u32>) -> impl Iterator<Item = u32> {
        let items = &self.items[items.start as usize..items.end as usize];
        let is_alive = |item: &u32| self.place_of[*item as usize] != NONE;
        items.iter().copied().filter(is_alive)
    }

    fn distance2(&self, item: u32, p: Point) -> f64 {
        #[cfg(test)]
        self.visits.set(self.visits.get() + 1);
        let (a, b) = self.segment(item);
        Line::new(a, b).nearest(p, 0.0).distance_sq
    }
}

const NONE: u32 = u32::MAX;

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn point() -> impl Strategy<Value = Point> {
        (-50..50_i32, -50..50_i32).prop_map(|(x, y)| Point::new(f64::from(x), f64::from(y)))
    }

    proptest! {
        #[test]
        fn the_nearest_item_is_that_of_an_exhaustive_search(
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
                let distance2 = Line::new(a, b).nearest(p, 0.0).distance_sq;
                if best.is_none_or(|best| distance2 < best.1) {
                    best = Some((item, distance2));
                }
            }
            prop_assert_eq!(index.nearest(p), best);
            for near in 0..=u32::try_from(segments.len()).unwrap_or(0) {
                let found = index.nearest_from(near, p, 0.0).map(|found| found.1.sqrt());
                let best = best.map(|found| found.1.sqrt());
                // If a box ends exactly at the nearest point, rounding may exclude the item after it
                // it.
                let same = found.zip(best).is_none_or(|(found, best)| (found - best).abs() < 1e-6);
                prop_assert!(same && found.is_some() == best.is_some(), "{found:?}, not {best:?}");
                let rough = index.nearest_from(near, p, 25.0).map(|found| found.1.sqrt());
                prop_assert_eq!(rough.is_some(), best.is_some());
                prop_assert!(rough.zip(best).is_none_or(|(rough, best)| rough <= best.max(5.0) + 1e-6));
            }
        }

        #[test]
        fn visits_exactly_the_boxes_that_touch(
            segments in proptest::collection::vec((point(), point()), 0..80),
            corners in (point(), point()),
        ) {
            let area = Rect::from_points(corners.0, corners.1);
            let mut found = Vec::new();
            SegmentIndex::new(segments.clone()).touching(area, &mut |item| found.push(item));
            found.sort_unstable();
            let expected: Vec<u32> = (0..)
                .zip(&segments)
                .filter(|(_, s)| Rect::from_points(s.0, s.1).overlaps(area))
                .map(|(item, _)| item)
                .collect();
            prop_assert_eq!(found, expected);
        }
    }
}
