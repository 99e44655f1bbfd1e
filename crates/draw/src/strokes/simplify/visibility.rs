//! How far one vector may go from a corner.

use dobot_geometry::{Point, Vec2};

use super::cone::Cone;
use super::corridor::{Corner, Corridor};

/// What is seen from a corner on the way along the stroke.
pub(super) struct Visibility<'a> {
    corridor: &'a Corridor<'a>,
    pub(super) from: Corner,
    /// How far off a disc still counts as hit.
    slack: f64,
    /// The directions that hit all discs so far; `None` while every direction does.
    pub(super) cone: Option<Cone>,
    /// The last point that was passed.
    pub(super) passed: usize,
    /// The squared length of the longest tangent to a disc so far.
    reach2: f64,
    /// The radius of that disc.
    reach_radius: f64,
    /// The stroke came back a little: the order in which the discs are hit has to be looked at.
    wavering: bool,
    /// How many looks in a row found them out of order.
    misses: usize,
    /// There was such a look since the last stop.
    looked: bool,
    /// From far off not every point is a corner.
    next_stop: usize,
    pub(super) work: usize,
}

impl<'a> Visibility<'a> {
    pub(super) const fn from(corridor: &'a Corridor<'a>, from: Corner, slack: f64) -> Self {
        Self {
            corridor,
            from,
            slack,
            cone: None,
            passed: from.passed,
            reach2: 0.0,
            reach_radius: 0.0,
            wavering: false,
            misses: 0,
            looked: false,
            next_stop: from.passed + 1,
            work: 0,
        }
    }

    /// Narrows the view to what passes the next point; false if nothing does.
    pub(super) fn pass(&mut self, i: usize) -> bool {
        self.work += 1;
        let radius = self.corridor.radii[i] + self.slack;
        let way = self.corridor.points[i] - self.from.at;
        let distance2 = way.hypot2();
        let tangent2 = distance2 - radius * radius;
        if tangent2 >= self.reach2 {
            self.reach2 = tangent2;
            self.reach_radius = radius;
        } else if self.reach2 > 0.0 {
            self.wavering = true;
            let reach = (self.reach2 + self.reach_radius * self.reach_radius).sqrt();
            if distance2.sqrt() + radius + self.reach_radius < reach {
                return false;
            }
        }
        if self.misses > LOOK_PAST {
            return false;
        }
        if let Some(disc) = Cone::to_disc(way, radius) {
            let both = self.cone.map_or(Some(disc), |cone| cone.and(disc));
            if both.is_none() {
                return false;
            }
            self.cone = both;
        }
        self.passed = i;
        true
    }

    /// Whether the vector to `at`, within the tolerance of point `i`, passes all before it.
    pub(super) fn reaches(&mut self, at: Point, i: usize) -> bool {
        let way = at - self.from.at;
        let length2 = way.hypot2();
        if length2.is_nan() || length2 < self.corridor.least_mm * self.corridor.least_mm {
            return false;
        }
        if self.cone.is_some_and(|cone| !cone.holds(way)) {
            return false;
        }
        // Discs ever farther out are hit in order, and no later than their tangents are long.
        if !self.wavering && length2 >= self.reach2 {
            return true;
        }
        self.in_order(at, i)
    }

    /// The same for a place on an edge of the view.
    pub(super) fn reaches_exit(&mut self, at: Point, i: usize) -> bool {
        at.distance(self.from.at) >= self.corridor.least_mm
            && (!self.wavering || self.in_order(at, i))
    }

    fn in_order(&mut self, at: Point, i: usize) -> bool {
        let first = self.from.passed + 1;
        self.work += (i - first) / 2;
        let fine = self.corridor.passes(self.from.at, at, first, i);
        self.looked = true;
        self.misses = if fine { 0 } else { self.misses + 1 };
        fine
    }

    /// Whether to look for corners at this point.
    pub(super) const fn stops(&self, i: usize) -> bool {
        i >= self.next_stop
    }

    /// Whether every corner costs a look at all points up to a far one.
    pub(super) const fn is_tedious(&self, i: usize) -> bool {
        self.wavering && i - self.from.passed > NEAR
    }

    /// After a stop at point `i`: the first points are stops, then ever fewer.
    pub(super) fn set_next_stop(&mut self, i: usize) {
        if self.wavering && !self.looked {
            self.look_ahead(i);
        }
        self.looked = false;
        let beyond = (i - self.from.passed).saturating_sub(NEAR);
        self.next_stop = i + 1;
        if self.misses == 0 {
            self.next_stop += if self.wavering { beyond } else { beyond / NEAR };
        }
    }

    /// Counts whether the order holds in the middle of the view, as there may be no corner to tell.
    fn look_ahead(&mut self, i: usize) {
        if let Some(cone) = self.cone {
            let unit = |way: Vec2| way * (1.0 / way.length());
            let middle = unit(unit(cone.left) + unit(cone.right));
            let far = (self.corridor.points[i] - self.from.at).dot(middle);
            self.in_order(self.from.at + middle * far, i);
        }
    }
}

/// As far as this every point is a stop; farther off they are this much rarer, and rarer still where
/// the stroke wavers.
const NEAR: usize = 64;
/// A line that comes back may be in order again after so many looks.
const LOOK_PAST: usize = 100;
