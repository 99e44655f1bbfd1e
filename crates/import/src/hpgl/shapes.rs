//! Circles, arcs, curves, rectangles and wedges.

use std::f64::consts::TAU;

use dobot_geometry::{Area, CubicBez, FillRule, Point, Vec2};

use super::command::Command;
use super::plotter::Plotter;
use crate::arc::Arc;
use crate::error::SourceError;

impl Plotter<'_> {
    /// CI: a circle about the pen, which does not move.
    pub(super) fn circle(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        let radius = command
            .number(0)
            .ok_or_else(|| self.refused(command, "a radius"))?;
        let arc = self.round(command, self.at, radius, 0.0, TAU)?;
        if self.polygon.is_open {
            self.sketch.spend(arc.len())?;
            self.polygon.ring(arc);
            return Ok(());
        }
        self.outline(command, &arc)
    }

    /// AA and AR: an arc about a center by an angle.
    pub(super) fn arc(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        let (&[x, y, sweep_deg] | &[x, y, sweep_deg, _]) = command.numbers.as_slice() else {
            return Err(self.refused(command, "x,y of the center, and an angle"));
        };
        let from = self.base(&command.name == b"AR");
        let sweep_rad = self.angle_rad(command, sweep_deg)?;
        self.sweep(command, from + Vec2::new(x, y), sweep_rad)
    }

    /// AT and RT: an arc through a point to another.
    pub(super) fn arc_through(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        let (&[x1, y1, x2, y2] | &[x1, y1, x2, y2, _]) = command.numbers.as_slice() else {
            return Err(self.refused(command, "x,y of an intermediate point, and of the end"));
        };
        let from = self.base(&command.name == b"RT");
        let (middle, end) = (from + Vec2::new(x1, y1), from + Vec2::new(x2, y2));
        match circle_through(self.at, middle, end) {
            Some((center, sweep_rad)) => self.sweep(command, center, sweep_rad),
            None => self.go_to(command, end),
        }
    }

    /// BZ and BR: cubic curves, each by two control points and its end.
    pub(super) fn beziers(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        let numbers = command.numbers.chunks_exact(6);
        if !numbers.remainder().is_empty() {
            return Err(self.refused(command, "six numbers for each curve"));
        }
        for curve in numbers {
            let from = self.base(&command.name == b"BR");
            let point = |i: usize| from + Vec2::new(curve[i], curve[i + 1]);
            let [b, c, end] = [0, 2, 4].map(point);
            let [a, b, c, d] = [self.at, b, c, end].map(|p| self.transform.point(p));
            let curve = CubicBez::new(a, b, c, d);
            let points = self.sketch.cubic_points(command.at, curve)?;
            self.follow(command, points, end)?;
        }
        Ok(())
    }

    /// EA, ER, RA, RR: a rectangle from the pen to its opposite corner.
    pub(super) fn rectangle(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        let &[x, y] = command.numbers.as_slice() else {
            return Err(self.refused(command, "x,y of the opposite corner"));
        };
        let is_relative = command.name[1] == b'R';
        let (a, b) = (self.at, self.base(is_relative) + Vec2::new(x, y));
        let corners = [a, Point::new(b.x, a.y), b, Point::new(a.x, b.y), a];
        self.shape(command, corners.map(|p| self.transform.point(p)).to_vec())
    }

    /// EW, WG: a wedge about the pen.
    pub(super) fn wedge(&mut self, command: &Command<'_>) -> Result<(), SourceError> {
        let (&[radius, from_deg, sweep_deg] | &[radius, from_deg, sweep_deg, _]) =
            command.numbers.as_slice()
        else {
            return Err(self.refused(command, "a radius, and the angles of start and sweep"));
        };
        let sweep_rad = self.angle_rad(command, sweep_deg)?;
        let arc = self.round(command, self.at, radius, from_deg.to_radians(), sweep_rad)?;
        let center = self.transform.point(self.at);
        let is_whole = sweep_rad.abs() >= TAU;
        let tip = (!is_whole).then_some(center);
        self.shape(command, tip.into_iter().chain(arc).chain(tip).collect())
    }

    /// E* draws an edge, others fill.
    fn shape(&mut self, command: &Command<'_>, ring: Vec<Point>) -> Result<(), SourceError> {
        for &p in &ring {
            self.sketch.check(command.at, p)?;
        }
        if command.name[0] == b'E' {
            return self.outline(command, &ring);
        }
        let rule = FillRule::EvenOdd;
        let rings = vec![ring];
        self.fill(command, Area { rings, rule })
    }

    /// An arc from the pen about a center.
    fn sweep(
        &mut self,
        command: &Command<'_>,
        center: Point,
        sweep_rad: f64,
    ) -> Result<(), SourceError> {
        let out = self.at - center;
        let from_rad = out.atan2();
        let mut points = self.round(command, center, out.length(), from_rad, sweep_rad)?;
        let end = if sweep_rad.abs() >= TAU {
            self.at
        } else {
            let (sin, cos) = (from_rad + sweep_rad).sin_cos();
            center + Vec2::new(cos, sin) * out.length()
        };
        if let [first, .., last] = points.as_mut_slice() {
            (*first, *last) = (self.transform.point(self.at), self.transform.point(end));
        }
        self.follow(command, points, end)
    }

    /// Follows a line to a place, in user units.
    fn follow(
        &mut self,
        command: &Command<'_>,
        points: Vec<Point>,
        to: Point,
    ) -> Result<(), SourceError> {
        self.at = to;
        self.labels.margin_mm = None;
        if self.polygon.is_open {
            self.sketch.spend(points.len())?;
            points
                .into_iter()
                .skip(1)
                .for_each(|p| self.polygon.point(p, self.is_down));
            return Ok(());
        }
        if self.is_down {
            self.ink(command, &points)?;
        }
        Ok(())
    }

    fn round(
        &self,
        command: &Command<'_>,
        center: Point,
        radius: f64,
        from_rad: f64,
        sweep_rad: f64,
    ) -> Result<Vec<Point>, SourceError> {
        let across = self.transform.way(Vec2::new(radius, 0.0));
        let along = self.transform.way(Vec2::new(0.0, radius));
        let center = self.transform.point(center);
        let arc = Arc::ellipse(center, across, along, from_rad, sweep_rad);
        let Some(chord_rad) = self.chord_rad(command, radius) else {
            return self.sketch.arc_points(command.at, &arc);
        };
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "at most 72"
        )]
        let chords = (sweep_rad.abs() / chord_rad - ROUNDING).ceil().max(1.0) as u32;
        let corner = |i| match i {
            0 => arc.start,
            i if i == chords => arc.end,
            i => arc.at(f64::from(i) / f64::from(chords)),
        };
        let corners: Vec<Point> = (0..=chords).map(corner).collect();
        for &p in &corners {
            self.sketch.check(command.at, p)?;
        }
        Ok(corners)
    }

    /// The angle of the chords of an arc, all of the same length; `None` for a round arc. That is
    /// any chord of 5 degrees, a plotter's default, or less. The sign is ignored, and more than 180
    /// degrees are 180.
    ///
    /// After CT1 a command gives the deviation of the chords from the arc, `d = r (1 - cos(a / 2))
    /// = 2 r sin²(a / 4)`.
    fn chord_rad(&self, command: &Command<'_>, radius: f64) -> Option<f64> {
        let place = match &command.name {
            b"CI" => 1,
            b"AT" | b"RT" => 4,
            _ => 3,
        };
        let given = command.number(place)?.abs();
        let chord_deg = if self.chords_by_deviation {
            let share = given / (2.0 * radius.abs());
            (4.0 * share.min(1.0).sqrt().asin()).to_degrees()
        } else {
            given
        };
        (chord_deg > ROUND_DEG).then(|| chord_deg.min(180.0).to_radians())
    }

    fn angle_rad(&self, command: &Command<'_>, angle_deg: f64) -> Result<f64, SourceError> {
        if angle_deg.abs() <= 360.0 {
            return Ok(angle_deg.to_radians());
        }
        Err(self.refused(command, "an angle from -360 to 360 degrees"))
    }
}

/// The largest chord angle that counts as round.
const ROUND_DEG: f64 = 5.0;
/// The cost of a number of chords.
const ROUNDING: f64 = 1e-9;

/// Center and sweep of the arc through three points; `None` if they are on a line.
fn circle_through(start: Point, middle: Point, end: Point) -> Option<(Point, f64)> {
    let (b, c) = (middle - start, end - start);
    if c == Vec2::ZERO {
        return Some((start.lerp(middle, 0.5), TAU));
    }
    let area = 2.0 * b.cross(c);
    if area.abs() <= 1e-12 * b.length() * c.length() {
        return None;
    }
    let x = (c.y * b.hypot2() - b.y * c.hypot2()) / area;
    let y = (b.x * c.hypot2() - c.x * b.hypot2()) / area;
    let center = start + Vec2::new(x, y);
    let (from, to) = (start - center, end - center);
    let turn = from.cross(to).atan2(from.dot(to));
    let turns_left = area > 0.0;
    Some((
        center,
        match turns_left {
            true if turn < 0.0 => turn + TAU,
            false if turn > 0.0 => turn - TAU,
            _ => turn,
        },
    ))
}
