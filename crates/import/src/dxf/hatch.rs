//! HATCH: areas by their boundaries, and the lines that fill them.

use dobot_geometry::{Affine, Area, FillRule, Point, Vec2};

use super::entity::Entity;
use super::pairs::Pair;
use super::pattern::PatternLine;
use super::renderer::EntityRenderer;
use super::shapes::{Corner, span_rad};
use crate::arc::Arc;
use crate::error::SourceError;
use crate::frame::way;
use crate::limits::MAX_SEGMENTS;

impl EntityRenderer<'_, '_> {
    /// Its boundaries as rings of an area. For a pattern of lines these are drawn and the area is
    /// theirs; for an unknown or solid fill the area is hatched.
    pub(super) fn hatch(&mut self, entity: &Entity<'_>, frame: Affine) -> Result<(), SourceError> {
        let pairs = entity.pairs.iter().enumerate();
        let starts = pairs.filter(|(_, pair)| pair.code == 92);
        let starts: Vec<usize> = starts.map(|(i, _)| i).collect();
        let mut rings = Vec::new();
        for (i, &start) in starts.iter().enumerate() {
            let end = starts.get(i + 1).copied().unwrap_or(entity.pairs.len());
            let path = &entity.pairs[start..end];
            let Some(ring) = self.ring(entity, path, frame)? else {
                self.left_out(entity, "a boundary of unknown type left out");
                return Ok(());
            };
            rings.push(ring);
        }
        rings.retain(|ring| ring.len() > 2);
        let rule = FillRule::EvenOdd;
        let area = Area { rings, rule };
        let is_solid = entity.flags(70)? & SOLID != 0;
        let lines = if is_solid {
            Vec::new()
        } else {
            PatternLine::all(entity)?
        };
        if is_solid {
            self.cover(entity, &area)?;
        }
        if lines.is_empty() || area.rings.is_empty() {
            return self.sketch.area(area);
        }
        self.pattern(entity, frame, area, &lines)
    }

    fn ring(
        &mut self,
        entity: &Entity<'_>,
        path: &[Pair<'_>],
        frame: Affine,
    ) -> Result<Option<Vec<Point>>, SourceError> {
        if let Some(corners) = corners(path)? {
            return self.bulged(entity, frame, &corners, true).map(Some);
        }
        let mut ring = Vec::new();
        for edge in edges(path) {
            let Some(mut points) = self.edge(entity, edge, frame)? else {
                return Ok(None);
            };
            ring.append(&mut points);
            if ring.len() > MAX_SEGMENTS {
                self.sketch.spend(ring.len())?;
            }
        }
        Ok(Some(ring))
    }

    /// The corners of a line or an arc; nothing for other edges.
    fn edge(
        &mut self,
        entity: &Entity<'_>,
        edge: &[Pair<'_>],
        frame: Affine,
    ) -> Result<Option<Vec<Point>>, SourceError> {
        let number = |code| {
            let pair = edge.iter().find(|pair| pair.code == code);
            pair.map_or(Ok(0.0), Pair::number)
        };
        let point = |x, y| Ok::<_, SourceError>(Point::new(number(x)?, number(y)?));
        let kind = edge[0].number()?;
        let at = point(10, 20)?;
        if kind == LINE {
            let ends = [at, point(11, 21)?].map(|p| self.place(entity, frame, p));
            return Ok(Some(ends.into_iter().collect::<Result<_, _>>()?));
        }
        if kind == SPLINE {
            return self.edge_spline(entity, edge, frame).map(Some);
        }
        // The angles of a clockwise arc are counted clockwise too.
        let side = if number(73)? == 0.0 { -1.0 } else { 1.0 };
        let (across, along) = if kind == ARC {
            let radius = number(40)?;
            (Vec2::new(radius, 0.0), Vec2::new(0.0, radius * side))
        } else if kind == ELLIPSE {
            let across = point(11, 21)?.to_vec2();
            (across, across.turn_90() * (number(40)? * side))
        } else {
            return Ok(None);
        };
        let center = self.place(entity, frame, at)?;
        let [from_rad, sweep_rad] = span_rad(number(50)?, number(51)?);
        let arc = Arc::ellipse(
            center,
            way(frame, across),
            way(frame, along),
            from_rad,
            sweep_rad,
        );
        Ok(Some(self.sketch.arc_points(entity.at, &arc)?))
    }

    fn edge_spline(
        &mut self,
        entity: &Entity<'_>,
        edge: &[Pair<'_>],
        frame: Affine,
    ) -> Result<Vec<Point>, SourceError> {
        // Fit points follow, which repeat the curve.
        let end = edge.iter().position(|pair| pair.code == 97);
        let own = Entity {
            pairs: edge[..end.unwrap_or(edge.len())].to_vec(),
            ..*entity
        };
        let degree = usize::try_from(own.flags(94)?).unwrap_or(usize::MAX);
        let places = own
            .points(10)?
            .into_iter()
            .map(|p| self.place(entity, frame, p));
        let places: Vec<Point> = places.collect::<Result<_, _>>()?;
        self.curve(entity, degree, own.numbers(40)?, &places, &own.numbers(42)?)
    }
}

/// The edges of a boundary that is not a polyline: each starts with its kind.
fn edges<'p, 't>(path: &'p [Pair<'t>]) -> impl Iterator<Item = &'p [Pair<'t>]> {
    let end = path.iter().position(|pair| pair.code == 75);
    let path = &path[..end.unwrap_or(path.len())];
    let first = path.iter().position(|pair| pair.code == 72);
    let mut rest = &path[first.unwrap_or(path.len())..];
    std::iter::from_fn(move || {
        let after = rest.get(1..)?;
        let next = after.iter().position(|pair| pair.code == 72);
        let (edge, others) = rest.split_at(next.map_or(rest.len(), |next| next + 1));
        rest = others;
        Some(edge)
    })
}

/// The corners of a boundary that is a polyline, else nothing.
fn corners(path: &[Pair<'_>]) -> Result<Option<Vec<Corner>>, SourceError> {
    #[expect(clippy::cast_possible_truncation, reason = "a few bits; saturates")]
    let flags = path[0].number()? as i64;
    if flags & POLYLINE == 0 {
        return Ok(None);
    }
    Corner::all(before_sources(path)).map(Some)
}

/// A boundary without the groups after it: its sources, the pattern, the seeds.
fn before_sources<'p, 't>(path: &'p [Pair<'t>]) -> &'p [Pair<'t>] {
    let end = path.iter().position(|pair| matches!(pair.code, 97 | 75));
    &path[..end.unwrap_or(path.len())]
}

const POLYLINE: i64 = 2;
/// Kinds of edges.
const LINE: f64 = 1.0;
const ARC: f64 = 2.0;
const ELLIPSE: f64 = 3.0;
const SPLINE: f64 = 4.0;
/// The flag of a solid hatch.
const SOLID: u32 = 1;
