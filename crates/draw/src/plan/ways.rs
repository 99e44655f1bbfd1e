//! The way of a laser through a stroke: it gets to its speed before, and loses it behind.

use super::planner::LEAST_VECTOR_MM;
use super::ticks::TICK_S;
use super::{Laser, Machine};
use crate::point::{Point, Stroke};

/// Where a laser gets to its speed before a stroke, and where it loses it behind.
pub(super) struct Ways {
    pub run_up: Point,
    /// Where it is switched on and off.
    pub on: Point,
    pub off: Point,
    pub run_out: Point,
    pub brake: Point,
}

/// How far before the end of a vector the laser is switched with the vector behind it, in mm: a stock
/// arm does that a tick before its motors begin that vector.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Early {
    pub on_mm: f64,
    pub off_mm: f64,
}

impl Early {
    /// As long as the laser's speed is kept.
    pub(super) fn at_speed(laser: &Laser, machine: &Machine) -> Self {
        let mm = if machine.has_ticks {
            laser.burn_speed_mm_s * f64::from(TICK_S)
        } else {
            0.0
        };
        Self {
            on_mm: mm,
            off_mm: mm,
        }
    }

    pub(super) fn is_near(self, other: Self) -> bool {
        (self.on_mm - other.on_mm).abs() < NEAR_MM && (self.off_mm - other.off_mm).abs() < NEAR_MM
    }
}

impl Ways {
    pub(super) fn of(
        stroke: &Stroke,
        here: [f64; 3],
        speed_mm_s: f64,
        early: Early,
        machine: &Machine,
    ) -> Self {
        let points = &stroke.points;
        let (first, last) = (points[0], points[points.len() - 1]);
        let come = Point::new(first.x - here[0], first.y - here[1]);
        let into = way_of(stroke.segments()).or_else(|| unit(come));
        let into = into.unwrap_or(Point::new(1.0, 0.0));
        let out = way_of(
            stroke
                .points
                .windows(2)
                .rev()
                .map(|pair| (pair[0], pair[1])),
        )
        .unwrap_or(into);
        let end = if points.len() == 1 {
            first + into * DOT_MM
        } else {
            last
        };
        let packet_mm = speed_mm_s * machine.link.period_s * RUN_SPARE;
        let gain_mm = 0.5 * speed_mm_s * speed_mm_s / machine.acceleration_mm_s2 * RUN_SPARE;
        let gain_mm = gain_mm.max(packet_mm);
        let first_mm = stroke
            .segments()
            .next()
            .map_or(DOT_MM, |(a, b)| a.distance(b));
        let off = end + out * early.off_mm;
        let run_out = off + out * packet_mm.max(LEAST_RUN_OUT_MM);
        Self {
            run_up: first - into * gain_mm,
            on: first + into * early.on_mm.min(0.5 * first_mm),
            off,
            run_out,
            brake: run_out + out * gain_mm,
        }
    }
}

/// The direction of the first piece that has one.
fn way_of(mut segments: impl Iterator<Item = (Point, Point)>) -> Option<Point> {
    segments.find_map(|(a, b)| unit(b - a))
}

fn unit(way: Point) -> Option<Point> {
    let length = way.length();
    (length >= LEAST_VECTOR_MM).then(|| way * (1.0 / length))
}

/// A laser burns a dot as a line, as long as its spot is wide.
const DOT_MM: f64 = 0.1;
/// Nobody sees less burned.
const NEAR_MM: f64 = 0.005;
const LEAST_RUN_OUT_MM: f64 = 0.1;
/// Ways to get faster and slower are a little longer than they have to be, for rounding.
const RUN_SPARE: f64 = 1.01;
