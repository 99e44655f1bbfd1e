//! Visibility: how far a single vector may lead from a corner.

use dobot_geometry::{Point, Vec2};

use super::cone::Cone;
use super::corridor::{Corner, Corridor};

/// The view from a corner along the stroke.
pub(super) struct Visibility<'a> {
    corridor: &'a Corridor<'a>,
    pub(super) from: Corner,
    /// The distance by which a disc may be missed.
    slack: f64,
    /// The directions that hit all discs up to here; `None` while every direction does.
    pub(super) cone: Option<Cone>,
    /// The last point that was passed.
    pub(super) passed: usize,
    /// The squared length of the longest tangent to a disc.
    reach2: f64,
    /// The radius of that disc.
    reach_radius: f64,
    /// Whether the stroke came back slightly, so that the order of the discs must be checked.
    wavering: bool,
    /// The number of consecutive checks with discs out of order.
    misses: usize,
    /// Whether there was such a check since the last stop.
    looked: bool,
    /// The next point examined as a corner; far away not every point is.
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

    /// Narrows the view to directions that pass the next point; returns false if none is left.
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
            // The stroke came back so far that this disc is entirely before the farthest one, so no
            // vector hits them in order.
            if distance2.sqrt() + radius + self.reach_radius < reach {
                return false;
            }
        }
        // The stroke keeps wavering; checking ever more points would take quadratic time.
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

    /// Whether the vector to `at`, within the tolerance of point `i`, passes all points before it.
    #[inline]
    pub(super) fn reaches(&mut self, at: Point, i: usize) -> bool {
        let way = at - self.from.at;
        let length2 = way.hypot2();
        if length2.is_nan() || length2 < self.corridor.least_mm * self.corridor.least_mm {
            return false;
        }
        if self.cone.is_some_and(|cone| !cone.holds(way)) {
            return false;
        }
        // Discs at increasing distances are hit in order, and no later than the length of their
        // tangents.
        if !self.wavering && length2 >= self.reach2 {
            return true;
        }
        self.in_order(at, i)
    }

    /// Whether the vector reaches a place on an edge of the view.
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

    /// Whether every corner requires checking all points up to a far one.
    pub(super) const fn is_tedious(&self, i: usize) -> bool {
        self.wavering && i - self.from.passed > NEAR
    }

    /// Sets the stop after point `i`: at first every point, then ever fewer.
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

    /// Counts whether the order holds in the middle of the view, because there may be no corner to
    /// check it.
    fn look_ahead(&mut self, i: usize) {
        if let Some(cone) = self.cone {
            let unit = |way: Vec2| way * (1.0 / way.length());
            let middle = unit(unit(cone.left) + unit(cone.right));
            let far = (self.corridor.points[i] - self.from.at).dot(middle);
            self.in_order(self.from.at + middle * far, i);
        }
    }
}

/// Up to this number of points, every point is a stop; farther away they are rarer by this factor,
/// and rarer still where the stroke wavers.
const NEAR: usize = 64;
/// The number of checks after which a line that comes back may be in order again.
const LOOK_PAST: usize = 100;
