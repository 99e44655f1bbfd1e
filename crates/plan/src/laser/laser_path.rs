//! The path of a laser through a stroke: it accelerates before and brakes after.

use dobot_geometry::{Point, Stroke, Vec2, bounds, distance_from_chord};

use crate::path::planner::MIN_VECTOR_MM;
use crate::ticks::TICK_S;
use crate::{ArmLimits, Laser};

/// The path of a laser through a stroke, with run-up and run-out.
pub(crate) struct LaserPath {
    pub run_up: Point,
    /// The points up to the place where the laser is switched on.
    pub off_to: Vec<Point>,
    /// The points from there to the place where it is switched off.
    pub on_to: Vec<Point>,
    pub run_out: Point,
    pub brake: Point,
    /// The actual switching points, which differ from the intended ones if a corner is too close.
    pub lead: SwitchLead,
}

/// The end of a stroke at which a vector is divided, although the laser is switched later.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Parted {
    Nowhere,
    AtEnd,
    AtBoth,
}

/// The distance before the end of a vector at which the laser is switched by the next vector, in
/// mm: a stock arm does that one tick before the motion of that vector.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SwitchLead {
    pub on_mm: f64,
    pub off_mm: f64,
}

impl SwitchLead {
    /// Returns the lead at constant laser speed.
    pub(crate) fn at_speed(laser: &Laser, arm_limits: &ArmLimits) -> Self {
        let mm = if arm_limits.has_ticks {
            laser.burn_speed_mm_s * f64::from(TICK_S)
        } else {
            0.0
        };
        Self {
            on_mm: mm,
            off_mm: mm,
        }
    }

    pub(crate) fn distance_mm(self, other: Self) -> f64 {
        let off_mm = (self.off_mm - other.off_mm).abs();
        (self.on_mm - other.on_mm).abs().max(off_mm)
    }

    pub(crate) fn half_way(self, to: Self) -> Self {
        Self {
            on_mm: 0.5 * (self.on_mm + to.on_mm),
            off_mm: 0.5 * (self.off_mm + to.off_mm),
        }
    }
}

impl LaserPath {
    /// Creates the path of a stroke; the run-up is extended by `longer_mm`.
    pub(crate) fn of(
        points: &[Point],
        speed_mm_s: f64,
        lead: SwitchLead,
        (longer_mm, parted): (f64, Parted),
        arm_limits: &ArmLimits,
    ) -> Self {
        let (first, last) = (points[0], points[points.len() - 1]);
        let into = unit(points[1] - first).expect("burnable points lie apart");
        let out = unit(last - points[points.len() - 2]).expect("burnable points lie apart");
        let off = last + out * lead.off_mm;
        let mut path = points[..points.len() - 1].to_vec();
        if parted != Parted::Nowhere && lead.off_mm >= MIN_BURN_MM {
            path.push(last);
        }
        path.push(off);
        let on_mm = switchable_mm(&mut path, lead.on_mm);
        let (mut off_to, on_to) = split(&path, on_mm);
        if parted == Parted::AtBoth && on_mm >= MIN_BURN_MM {
            off_to.insert(0, first);
        }
        let gain_mm = gain_mm(speed_mm_s, arm_limits);
        let run_out = off + out * packet_mm(speed_mm_s, arm_limits).max(MIN_RUN_OUT_MM);
        Self {
            run_up: first - into * (gain_mm + longer_mm),
            off_to,
            on_to,
            run_out,
            brake: run_out + out * gain_mm,
            lead: SwitchLead { on_mm, ..lead },
        }
    }
}

/// Returns the possible switching point closest to the wanted one: the next vector must not be
/// shorter than [`MIN_BURN_MM`]. A closer corner is removed if that is invisible. Otherwise the
/// laser is switched at that corner or [`MIN_BURN_MM`] before it, with an error of at most half
/// of that.
///
/// ```text
///            wanted                          wanted
///   ----------o--.                   ------o------.
///                 \                               \
///                  \  at the corner         that distance before it
/// ```
fn switchable_mm(path: &mut [Point], wanted_mm: f64) -> f64 {
    let (mut corner_mm, mut corner) = (0.0, 0);
    while corner_mm <= wanted_mm && corner + 1 < path.len() {
        corner += 1;
        corner_mm += path[corner].distance(path[corner - 1]);
    }
    let left_mm = corner_mm - wanted_mm;
    if left_mm >= MIN_BURN_MM {
        return wanted_mm;
    }
    let before_mm = (corner_mm - MIN_BURN_MM).max(0.0);
    if corner + 1 == path.len() {
        return before_mm;
    }
    let [a, b, next] = [path[corner - 1], path[corner], path[corner + 1]];
    let on = b.lerp(a, left_mm / b.distance(a));
    let [of_b, of_on, of_next] = [b, on, next].map(|p| [p.x, p.y]);
    let is_straight = distance_from_chord(of_b, of_on, of_next) <= NEAR_MM;
    if is_straight && on.distance(next) >= MIN_BURN_MM {
        path[corner] = on;
        wanted_mm
    } else if left_mm <= 0.5 * MIN_BURN_MM {
        corner_mm
    } else {
        before_mm
    }
}

/// Returns the maximum distance of the laser beyond the ends of a stroke, in mm.
pub(crate) fn run_mm(laser: &Laser, arm_limits: &ArmLimits) -> f64 {
    let speed_mm_s = laser.burn_speed_mm_s;
    let run_out_mm = packet_mm(speed_mm_s, arm_limits).max(MIN_RUN_OUT_MM);
    SwitchLead::at_speed(laser, arm_limits).off_mm + run_out_mm + gain_mm(speed_mm_s, arm_limits)
}

/// Returns the distance needed to reach a speed, and at least one packet's. From rest, an arm with
/// ticks reaches the change per tick immediately and cannot be slower.
fn gain_mm(speed_mm_s: f64, arm_limits: &ArmLimits) -> f64 {
    let gain_mm = 0.5 * speed_mm_s * speed_mm_s / arm_limits.acceleration_mm_s2 * RUN_SPARE;
    let least_mm_s = if arm_limits.has_ticks {
        arm_limits.acceleration_mm_s2 * f64::from(TICK_S)
    } else {
        0.0
    };
    gain_mm.max(packet_mm(speed_mm_s.max(least_mm_s), arm_limits))
}

/// Returns the distance covered while the link delivers a packet.
fn packet_mm(speed_mm_s: f64, arm_limits: &ArmLimits) -> f64 {
    speed_mm_s * arm_limits.link.period_s * RUN_SPARE
}

/// Returns the corners of a burned stroke, at least [`MIN_BURN_MM`] apart: the link takes as long
/// for a shorter vector as for any other, so the laser would burn a hole. For a stroke shorter than
/// that, returns only its start.
#[must_use]
pub fn burned_corners(stroke: &Stroke) -> Vec<Point> {
    let mut points = Vec::with_capacity(stroke.points.len());
    for &p in &stroke.points {
        if points
            .last()
            .is_none_or(|last: &Point| p.distance(*last) >= MIN_BURN_MM)
        {
            points.push(p);
        }
    }
    if let ([.., before, end], Some(&last)) = (points.as_mut_slice(), stroke.points.last())
        && last.distance(*before) >= MIN_BURN_MM
    {
        *end = last;
    }
    points
}

/// Returns the corners of a stroke, at least two. A stroke shorter than the spot becomes a centred
/// line of that length.
pub(crate) fn burnable(stroke: &Stroke, here: [f64; 3]) -> Vec<Point> {
    let points = burned_corners(stroke);
    if points.len() > 1 && stroke.length_mm() >= DOT_MM {
        return points;
    }
    let middle = bounds(stroke.points.iter().copied()).center();
    let come = middle - Point::new(here[0], here[1]);
    let into = direction_of(stroke.segments()).or_else(|| unit(come));
    let half = into.unwrap_or(Vec2::new(1.0, 0.0)) * (0.5 * DOT_MM);
    vec![middle - half, middle + half]
}

/// Returns the speed at which a laser burns a path: a stock arm switches it between ticks, so a
/// path shorter than a tick is burned for a whole one.
pub(crate) fn burn_speed_mm_s(points: &[Point], laser: &Laser, arm_limits: &ArmLimits) -> f64 {
    let length_mm: f64 = points
        .windows(2)
        .map(|pair| pair[0].distance(pair[1]))
        .sum();
    if arm_limits.has_ticks {
        laser.burn_speed_mm_s.min(length_mm / f64::from(TICK_S))
    } else {
        laser.burn_speed_mm_s
    }
}

/// Splits a path at a distance along it.
fn split(path: &[Point], at_mm: f64) -> (Vec<Point>, Vec<Point>) {
    let (mut left_mm, mut before) = (at_mm, Vec::new());
    for (i, pair) in path.windows(2).enumerate() {
        let length_mm = pair[0].distance(pair[1]);
        if left_mm < length_mm {
            before.push(pair[0].lerp(pair[1], left_mm / length_mm));
            return (before, path[i + 1..].to_vec());
        }
        left_mm -= length_mm;
        before.push(pair[1]);
    }
    (before, Vec::new())
}

/// Returns the direction of the first segment with a length.
fn direction_of(mut segments: impl Iterator<Item = (Point, Point)>) -> Option<Vec2> {
    segments.find_map(|(a, b)| unit(b - a))
}

fn unit(way: Vec2) -> Option<Vec2> {
    let length = way.length();
    (length >= MIN_VECTOR_MM).then(|| way * (1.0 / length))
}

/// The length of the line that a laser burns for a dot: the width of its spot.
pub const DOT_MM: f64 = 0.2;
/// The minimum length of a burned vector, except for shorter strokes: the laser would burn a hole
/// because of the link.
pub const MIN_BURN_MM: f64 = 0.08;
/// A distance that is invisible when burned.
pub(crate) const NEAR_MM: f64 = 0.005;
const MIN_RUN_OUT_MM: f64 = 0.1;
/// The extra length of acceleration and braking, for rounding.
const RUN_SPARE: f64 = 1.01;
