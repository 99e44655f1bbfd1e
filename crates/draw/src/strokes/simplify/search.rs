//! The search for the path with the fewest vectors.
//!
//! Breadth first: from all corners that `n` vectors reach, all that one more does. A corner is one
//! of five for each point of the stroke: the point itself, the tolerance to its left and right, and
//! the two farthest places that vectors get to which miss the disc of the next point. Where vectors have to be long, eight more
//! around the point: a step that is too short may lead farther, or not be made at all.
//!
//! The farthest corners of a layer come first. Once an allowance of work is used up, which grows
//! with the way done, only those follow that could spoil the promise to be no worse than the best
//! choice among the stroke's own points; once a second one is used up, none. So the whole is linear.

use dobot_geometry::Point;

use super::MIN_VECTOR_MM;
use super::corridor::{Corner, Corridor};
use super::snap::snap_to_points;
use super::visibility::Visibility;

/// The corners of the path with the fewest vectors; `None` if there is none without vectors
/// that are too short.
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
    /// Where the path has to end.
    end: Point,
    /// The corners that were gone on from.
    done: Vec<Corner>,
    /// What the next layer goes on from.
    next: Vec<Corner>,
    /// For each point a bit for each of its corners that was reached.
    reached: Vec<u16>,
    /// No point before this one is left to be reached.
    gap: usize,
    /// How many points were looked at.
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
            // They come in runs of ascending order: sorted in no time.
            layer.sort_by_key(|corner| corner.passed);
            let lean = LEAN_WORK + WORK_PER_POINT * layer[layer.len() - 1].passed;
            for &corner in layer.iter().rev() {
                let enough = self.work > lean && !self.next.is_empty();
                if enough && (self.work > lean + EXACT_WORK || self.is_useless(corner.passed)) {
                    break;
                }
                if enough && corner.at != self.corridor.points[corner.passed] {
                    continue;
                }
                self.done.push(corner);
                if self.go_on(corner) {
                    return Some(self.path());
                }
            }
        }
        None
    }

    /// Whether no vector from point `i`, or from any before it, leads to a point that was not
    /// reached yet: what it leads to lies also in sight of point `i` if all tolerances are larger by that of the point.
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

    /// Notes all corners that one vector from here reaches; true if the end is among them.
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
            if self.reached[i] & bit == 0 && visibility.reaches(at, i) {
                self.note(at, i, bit);
            }
        };
        look(1, corridor.points[i]);
        // Far off, where each has to be looked at, the point itself has to do.
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

    /// The corners from the begin to the end, which the last of `done` sees.
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

/// The allowance of work, in points looked at: a little for each stroke and each of its points, and
/// what it may take to be sure that no choice of points is better.
const LEAN_WORK: usize = 200;
const WORK_PER_POINT: usize = 5;
const EXACT_WORK: usize = 20_000;
/// Another begin of a closed stroke saves one vector at most.
const WORTH_ANOTHER_BEGIN: usize = 100;
