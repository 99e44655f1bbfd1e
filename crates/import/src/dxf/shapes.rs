//! Line entities.

use std::f64::consts::TAU;

use dobot_geometry::{Affine, Area, FillRule, Point, Vec2};

use super::entity::Entity;
use super::file::Span;
use super::fit::{self, Ends};
use super::pairs::Pair;
use super::plane::{Plane, from_above};
use super::renderer::EntityRenderer;
use super::spline::Spline;
use crate::arc::{Arc, SAME_MM};
use crate::error::SourceError;
use crate::frame::way;
use crate::limits::MAX_SEGMENTS;

/// A corner of a polyline and its segment.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    pub(super) at: Point,
    /// The tangent of a quarter of the angle of its arc; 0 for a straight segment.
    pub(super) bulge: f64,
    /// The widths at the start and the end of the segment.
    pub(super) widths: [f64; 2],
}

impl Corner {
    /// The corners given by consecutive pairs. All segments have the width 43, or else each its own
    /// (40 and 41).
    pub(super) fn all(pairs: &[Pair<'_>]) -> Result<Vec<Self>, SourceError> {
        let mut corners: Vec<Self> = Vec::new();
        let mut width = 0.0;
        for pair in pairs {
            match (pair.code, corners.last_mut()) {
                (43, None) => width = pair.number()?,
                (10, _) => corners.push(Self {
                    at: Point::new(pair.number()?, 0.0),
                    bulge: 0.0,
                    widths: [width; 2],
                }),
                (20, Some(last)) => last.at.y = pair.number()?,
                (40, Some(last)) => last.widths[0] = pair.number()?,
                (41, Some(last)) => last.widths[1] = pair.number()?,
                (42, Some(last)) => last.bulge = pair.number()?,
                _ => {}
            }
        }
        Ok(corners)
    }
}

impl EntityRenderer<'_, '_> {
    pub(super) fn straight(
        &mut self,
        entity: &Entity<'_>,
        frame: Affine,
    ) -> Result<(), SourceError> {
        let [a, b] = [10, 11].map(|code| self.place(entity, frame, entity.point(code)?));
        self.sketch.line(a?, b?)
    }

    pub(super) fn dot(&mut self, entity: &Entity<'_>, frame: Affine) -> Result<(), SourceError> {
        let at = self.place(entity, frame, entity.point(10)?)?;
        self.sketch.dot(at)
    }

    pub(super) fn circle(&mut self, entity: &Entity<'_>, frame: Affine) -> Result<(), SourceError> {
        let (center, radius) = (entity.point(10)?, entity.number(40)?);
        let span_rad = match entity.kind {
            b"ARC" => span_rad(entity.number(50)?, entity.number(51)?),
            _ => [0.0, TAU],
        };
        let (across, along) = (Vec2::new(radius, 0.0), Vec2::new(0.0, radius));
        self.round(entity, frame, center, [across, along], span_rad)
    }

    pub(super) fn ellipse(
        &mut self,
        entity: &Entity<'_>,
        frame: Affine,
    ) -> Result<(), SourceError> {
        let (center, across) = (entity.point(10)?, entity.way(11)?);
        let along = from_above(Plane::of(entity)?.left_of(across)) * entity.number(40)?;
        let across = from_above(across);
        let (from_rad, to_rad) = (entity.number_or(41, 0.0)?, entity.number_or(42, TAU)?);
        let sweep_rad = (to_rad - from_rad).rem_euclid(TAU);
        // Files round the end of a full one.
        let is_whole = !(1e-6..=TAU - 1e-6).contains(&sweep_rad);
        let sweep_rad = if is_whole { TAU } else { sweep_rad };
        self.round(
            entity,
            frame,
            center,
            [across, along],
            [from_rad, sweep_rad],
        )
    }

    /// A part of a circle or an ellipse, given by two vectors from its center, a start angle and a
    /// sweep.
    pub(super) fn round(
        &mut self,
        entity: &Entity<'_>,
        frame: Affine,
        center: Point,
        [across, along]: [Vec2; 2],
        [from_rad, sweep_rad]: [f64; 2],
    ) -> Result<(), SourceError> {
        let center = self.place(entity, frame, center)?;
        let (across, along) = (way(frame, across), way(frame, along));
        let arc = Arc::ellipse(center, across, along, from_rad, sweep_rad);
        self.sketch.arc(entity.at, &arc)
    }

    pub(super) fn light_polyline(
        &mut self,
        entity: &Entity<'_>,
        frame: Affine,
    ) -> Result<(), SourceError> {
        let corners = Corner::all(&entity.pairs)?;
        let is_closed = entity.flags(70)? & 1 != 0;
        self.wide_polyline(entity, frame, &corners, is_closed)
    }

    /// The older polyline, with its corners as entities.
    pub(super) fn polyline(
        &mut self,
        entity: &Entity<'_>,
        vertices: &[Span<'_>],
        frame: Affine,
    ) -> Result<(), SourceError> {
        let flags = entity.flags(70)?;
        if flags & (MESH | POLYFACE) != 0 {
            return self.old_mesh(entity, vertices, frame);
        }
        let mut corners = Vec::new();
        let widths = [entity.number_or(40, 0.0)?, entity.number_or(41, 0.0)?];
        for &span in vertices {
            let vertex = Entity::read(entity.text, span)?;
            if vertex.flags(70)? & SPLINE_CONTROL == 0 {
                corners.push(Corner {
                    at: vertex.point(10)?,
                    bulge: vertex.number_or(42, 0.0)?,
                    widths: [
                        vertex.number_or(40, widths[0])?,
                        vertex.number_or(41, widths[1])?,
                    ],
                });
            }
        }
        self.wide_polyline(entity, frame, &corners, flags & 1 != 0)
    }

    /// Draws the line through corners, with arcs for bulges.
    pub(super) fn bulged(
        &mut self,
        entity: &Entity<'_>,
        frame: Affine,
        corners: &[Corner],
        is_closed: bool,
    ) -> Result<Vec<Point>, SourceError> {
        let Some(first) = corners.first() else {
            return Ok(Vec::new());
        };
        let mut points = vec![self.place(entity, frame, first.at)?];
        let next = corners.iter().skip(1).chain(is_closed.then_some(first));
        for (from, to) in corners.iter().zip(next) {
            let end = self.place(entity, frame, to.at)?;
            if from.bulge == 0.0 || from.at == to.at {
                points.push(end);
                continue;
            }
            let arc = bulge_arc(frame, from, to.at);
            let arc = self.sketch.arc_points(entity.at, &arc)?;
            points.extend(&arc[1..arc.len() - 1]);
            points.push(end);
            if points.len() > MAX_SEGMENTS {
                self.sketch.spend(points.len())?;
            }
        }
        Ok(points)
    }

    pub(super) fn spline(&mut self, entity: &Entity<'_>, frame: Affine) -> Result<(), SourceError> {
        let controls = entity.points(10)?;
        let fits = entity.points(11)?;
        if controls.is_empty() && !fits.is_empty() {
            return self.fit_spline(entity, frame, &fits);
        }
        let placed = self.places(entity, frame, &controls)?;
        let degree = usize::try_from(entity.flags(71)?).unwrap_or(usize::MAX);
        let points = self.curve(
            entity,
            degree,
            entity.numbers(40)?,
            &placed,
            &entity.numbers(41)?,
        )?;
        let is_open = points
            .first()
            .zip(points.last())
            .is_some_and(|(a, b)| a.distance(*b) > SAME_MM);
        if is_open && entity.flags(70)? & CLOSED_SPLINE != 0 {
            let instead =
                "drawn open, as its control points are, although it is flagged as closed (70)";
            self.sketch.warn(entity.at, "unclosed spline", instead);
        }
        self.sketch.stroke(points)
    }

    /// A spline by fit points.
    fn fit_spline(
        &mut self,
        entity: &Entity<'_>,
        frame: Affine,
        fits: &[Point],
    ) -> Result<(), SourceError> {
        let pieces = if entity.flags(70)? & CLOSED_SPLINE != 0 {
            fit::closed_pieces(fits)
        } else {
            let (first, last) = (direction(entity, 12)?, direction(entity, 13)?);
            fit::pieces(fits, Ends { first, last })
        };
        let mut points = vec![self.place(entity, frame, fits[0])?];
        for piece in pieces {
            let piece = self.sketch.cubic_points(entity.at, frame * piece)?;
            points.extend(&piece[1..]);
            if points.len() > MAX_SEGMENTS {
                self.sketch.spend(points.len())?;
            }
        }
        self.sketch.stroke(points)
    }

    /// The corners of a spline.
    pub(super) fn curve(
        &mut self,
        entity: &Entity<'_>,
        degree: usize,
        knots: Vec<f64>,
        placed: &[Point],
        weights: &[f64],
    ) -> Result<Vec<Point>, SourceError> {
        let spline = Spline::new(degree, knots, placed, weights);
        let expected = "degree 1 to 15, and as many knots as control points plus degree plus 1";
        let spline = spline.map_err(|found| entity.refused(found, expected))?;
        let points = spline.points(self.sketch.tolerance_mm(), MAX_SEGMENTS);
        let limit = MAX_SEGMENTS;
        let points = points.ok_or(SourceError::TooManySegments { limit })?;
        self.sketch.note_curve(points.len());
        Ok(points)
    }

    /// Four corners, the last two swapped.
    pub(super) fn solid(&mut self, entity: &Entity<'_>, frame: Affine) -> Result<(), SourceError> {
        let fourth = if entity.find(13).is_some() { 13 } else { 12 };
        let ring = [10, 11, fourth, 12].map(|code| self.place(entity, frame, entity.point(code)?));
        let ring = ring.into_iter().collect::<Result<_, _>>()?;
        let area = Area {
            rings: vec![ring],
            rule: FillRule::NonZero,
        };
        self.cover(entity, &area)?;
        self.sketch.area(area)
    }

    /// Three or four corners, some edges invisible.
    pub(super) fn face(&mut self, entity: &Entity<'_>, frame: Affine) -> Result<(), SourceError> {
        let fourth = if entity.find(13).is_some() { 13 } else { 12 };
        let corners =
            [10, 11, 12, fourth].map(|code| self.place(entity, frame, entity.point(code)?));
        let corners: Vec<Point> = corners.into_iter().collect::<Result<_, _>>()?;
        let hidden = entity.flags(70)?;
        for (i, &from) in corners.iter().enumerate() {
            let to = corners[(i + 1) % corners.len()];
            if hidden & (1 << i) != 0 {
                self.sketch.lift();
            } else if from != to {
                self.sketch.line(from, to)?;
            }
        }
        Ok(())
    }

    /// The leader line of a note; its arrow is not drawn.
    pub(super) fn leader(&mut self, entity: &Entity<'_>, frame: Affine) -> Result<(), SourceError> {
        if entity.flags(71)? != 0 {
            self.left_out(entity, "drawn without its arrow");
        }
        let points = self.places(entity, frame, &entity.points(10)?)?;
        self.sketch.stroke(points)
    }

    pub(super) fn places(
        &self,
        entity: &Entity<'_>,
        frame: Affine,
        points: &[Point],
    ) -> Result<Vec<Point>, SourceError> {
        let points = points.iter().map(|&p| self.place(entity, frame, p));
        points.collect()
    }

    pub(super) fn place(
        &self,
        entity: &Entity<'_>,
        frame: Affine,
        p: Point,
    ) -> Result<Point, SourceError> {
        self.sketch.check(entity.at, frame * p)
    }
}

/// The unit direction of an entity, if it has one.
fn direction(entity: &Entity<'_>, code: i32) -> Result<Option<Vec2>, SourceError> {
    if entity.find(code).is_none() {
        return Ok(None);
    }
    let way = from_above(entity.way(code)?);
    Ok((way != Vec2::ZERO).then(|| way / way.length()))
}

/// The start and the counterclockwise sweep of an arc; a full turn if it ends at its start.
pub(super) fn span_rad(from_deg: f64, to_deg: f64) -> [f64; 2] {
    let sweep_deg = (to_deg - from_deg).rem_euclid(360.0);
    let sweep_deg = if sweep_deg == 0.0 { 360.0 } else { sweep_deg };
    [from_deg, sweep_deg].map(f64::to_radians)
}

/// The center of the arc of a corner with a bulge, and its sweep: four times the arc tangent of the bulge.
///
/// ```text
///   bulge = tan(angle / 4)     the center lies at chord (1 / bulge - bulge) / 4 beside the
///                              middle of the chord, to the left where the bulge is above 0
/// ```
pub(super) fn bulge_center(from: &Corner, to: Point) -> (Point, f64) {
    let chord = to - from.at;
    let beside = chord.turn_90() * ((1.0 / from.bulge - from.bulge) / 4.0);
    (from.at.midpoint(to) + beside, 4.0 * from.bulge.atan())
}

fn bulge_arc(frame: Affine, from: &Corner, to: Point) -> Arc {
    let (center, sweep_rad) = bulge_center(from, to);
    let out = from.at - center;
    let (across, along) = (way(frame, out), way(frame, out.turn_90()));
    Arc::ellipse(frame * center, across, along, 0.0, sweep_rad)
}

/// The flags of a POLYLINE with world coordinates.
pub(super) const IN_SPACE: u32 = 8 | MESH | POLYFACE;
const MESH: u32 = 16;
pub(super) const POLYFACE: u32 = 64;
/// The flag of a closed SPLINE.
const CLOSED_SPLINE: u32 = 1 | 2;
/// The flag of a VERTEX that is only a control point.
pub(super) const SPLINE_CONTROL: u32 = 16;
