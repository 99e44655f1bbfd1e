//! Search for the path with the fewest vectors.
//!
//! The search is breadth-first: from all corners that `n` vectors reach, it expands to those that
//! one more vector reaches. There are five possible corners per point: the point itself, the
//! tolerance to its left and right, and the two farthest places reached by vectors that miss the
//! disc of the next point. With a minimum vector length, eight more around the point are added: a
//! step that is too short may lead farther, or not be possible at all.
//!
//! The farthest corners of a layer are expanded first. When a work allowance, which grows with the
//! progress, is used up, only those corners follow that are needed to guarantee a result no worse
//! than the best choice among the stroke's own points; when a second allowance is used up, none.
//! Therefore the total work is linear.

use dobot_geometry::Point;

use super::MIN_VECTOR_MM;
use super::corridor::{Corner, Corridor};
use super::snap::snap_to_points;
use super::visibility::Visibility;

/// Returns the corners of the path with the fewest vectors; `None` if every path has vectors that
/// are too short.
pub(super) fn fewest(corridor: &Corridor<'_>) -> Option<Vec<Corner>> {
    if corridor.points.len() < 2 {
        return None;
    }
    let mut best = Search::new(corridor, corridor.points[0]).run();
    let length = |path: &Option<Vec<Corner>>| path.as_ref().map_or(usize::MAX, Vec::len);
    if corridor.closed && length(&best) <= WORTH_ANOTHER_BEGIN {
        for begin in corridor.beside(0) {
            let other = Search::new(corridor, begin).run();
            if length(&other) < length(&best) {
                best = other;
            }
        }
    }
    best.map(|path| snap_to_points(corridor, &path))
}

struct Search<'a> {
    corridor: &'a Corridor<'a>,
    /// The end of the path.
    end: Point,
    /// The expanded corners.
    done: Vec<Corner>,
    /// The corners of the next layer.
    next: Vec<Corner>,
    /// A bit set per point of its reached corners.
    reached: Vec<u16>,
    /// All points before this one have been reached.
    gap: usize,
    /// The number of points examined.
    work: usize,
}

impl<'a> Search<'a> {
    fn new(corridor: &'a Corridor<'a>, begin: Point) -> Self {
        let begin = Corner {
            at: begin,
            passed: 0,
            before: 0,
        };
        Self {
            corridor,
            end: if corridor.closed {
                begin.at
            } else {
                corridor.points[corridor.points.len() - 1]
            },
            done: Vec::new(),
            next: vec![begin],
            reached: vec![0; corridor.points.len()],
            gap: 1,
            work: 0,
        }
    }

    fn run(mut self) -> Option<Vec<Corner>> {
        let mut layer = Vec::new();
        while !self.next.is_empty() {
            layer.clear();
            std::mem::swap(&mut layer, &mut self.next);
            // They come in ascending runs, so sorting is fast.
            layer.sort_by_key(|corner| corner.passed);
            let lean = LEAN_WORK + WORK_PER_POINT * layer[layer.len() - 1].passed;
            for &corner in layer.iter().rev() {
                // Never stop before the next layer has a corner, or the path could not be
                // continued.
                let enough = self.work > lean && !self.next.is_empty();
                if enough && (self.work > lean + EXACT_WORK || self.is_useless(corner.passed)) {
                    break;
                }
                // The guarantee concerns the stroke's own points only.
                if enough && corner.at != self.corridor.points[corner.passed] {
                    continue;
                }
                self.done.push(corner);
                // Breadth-first: the first path that reaches the end has the fewest vectors.
                if self.go_on(corner) {
                    return Some(self.path());
                }
            }
        }
        None
    }

    /// Whether no vector from point `i` or an earlier one leads to an unreached point: everything
    /// it reaches is also visible from point `i` with all tolerances increased by that of the
    /// point.
    fn is_useless(&mut self, i: usize) -> bool {
        while self.reached.get(self.gap).is_some_and(|bits| bits & 1 == 1) {
            self.gap += 1;
        }
        let corner = Corner {
            at: self.corridor.points[i],
            passed: i,
            before: 0,
        };
        let mut visibility = Visibility::from(self.corridor, corner, self.corridor.radii[i]);
        let out_of_sight = (i + 1..=self.gap).any(|next| !visibility.pass(next));
        self.work += visibility.work;
        out_of_sight
    }

    /// Adds all corners that one vector from here reaches; returns true if the end is among them.
    fn go_on(&mut self, from: Corner) -> bool {
        let last = self.corridor.points.len() - 1;
        let mut visibility = Visibility::from(self.corridor, from, 0.0);
        for i in from.passed + 1..=last {
            if !visibility.pass(i) {
                break;
            }
            if i == last {
                if visibility.reaches(self.end, i) {
                    return true;
                }
            } else if visibility.stops(i) {
                self.note_corners(&mut visibility, i);
                visibility.set_next_stop(i);
            }
        }
        self.note_exits(&mut visibility);
        self.work += visibility.work;
        false
    }

    fn note_corners(&mut self, visibility: &mut Visibility<'_>, i: usize) {
        let corridor = self.corridor;
        let [left, right] = corridor.beside(i);
        let is_tedious = visibility.is_tedious(i);
        let mut look = |bit: u16, at: Point| {
            // A corner reached by an earlier layer, or this one, needs no second path.
            if self.reached[i] & bit == 0 && visibility.reaches(at, i) {
                self.note(at, i, bit);
            }
        };
        look(1, corridor.points[i]);
        // Far away, where each corner requires checking all points, use only the point itself.
        if is_tedious {
            return;
        }
        look(2, left);
        look(4, right);
        if corridor.least_mm > MIN_VECTOR_MM {
            for (n, at) in corridor.around(i).enumerate() {
                look(32 << n, at);
            }
        }
    }

    fn note_exits(&mut self, visibility: &mut Visibility<'_>) {
        let (i, Some(cone)) = (visibility.passed, visibility.cone) else {
            return;
        };
        for (bit, along) in [(8, cone.right), (16, cone.left)] {
            if self.reached[i] & bit == 0
                && let Some(at) = self.corridor.exit(visibility.from.at, along, i)
                && visibility.reaches_exit(at, i)
            {
                self.note(at, i, bit);
            }
        }
    }

    fn note(&mut self, at: Point, passed: usize, bit: u16) {
        self.reached[passed] |= bit;
        self.next.push(Corner {
            at,
            passed,
            before: self.done.len() - 1,
        });
    }

    /// Returns the corners from the start to the end, which is visible from the last of `done`.
    fn path(&self) -> Vec<Corner> {
        let end = Corner {
            at: self.end,
            passed: self.corridor.points.len() - 1,
            before: self.done.len() - 1,
        };
        let mut path = vec![end];
        let mut at = end.before;
        loop {
            path.push(self.done[at]);
            if at == 0 {
                break;
            }
            at = self.done[at].before;
        }
        path.reverse();
        path
    }
}

/// The work allowance in examined points: per stroke and per point, and the additional allowance to
/// guarantee that no choice of points is better.
const LEAN_WORK: usize = 200;
const WORK_PER_POINT: usize = 5;
const EXACT_WORK: usize = 20_000;
/// Another start of a closed stroke saves at most one vector.
const WORTH_ANOTHER_BEGIN: usize = 100;
