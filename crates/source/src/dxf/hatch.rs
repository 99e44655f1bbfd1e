//! HATCH: areas by their boundaries.

use dobot_geometry::{Affine, Area, FillRule, Point, Vec2};

use super::entity::Entity;
use super::frame::way;
use super::pairs::Pair;
use super::renderer::EntityRenderer;
use super::shapes::{Corner, span_rad};
use crate::arc::Arc;
use crate::error::SourceError;
use crate::limits::MAX_SEGMENTS;

impl EntityRenderer<'_, '_> {
    /// Its boundaries as rings of an area, whatever pattern fills it. A hatch with ellipses or splines
    /// is left out with a warning.
    pub(super) fn hatch(&mut self, it: &Entity<'_>, frame: Affine) -> Result<(), SourceError> {
        let pairs = it.pairs.iter().enumerate();
        let starts = pairs.filter(|(_, pair)| pair.code == 92);
        let starts: Vec<usize> = starts.map(|(i, _)| i).collect();
        let mut rings = Vec::new();
        for (i, &start) in starts.iter().enumerate() {
            let end = starts.get(i + 1).copied().unwrap_or(it.pairs.len());
            let path = &it.pairs[start..end];
            let Some(ring) = self.ring(it, path, frame)? else {
                self.left_out(it, "a boundary by ellipses or splines, left out");
                return Ok(());
            };
            rings.push(ring);
        }
        let rule = FillRule::EvenOdd;
        self.sketch.area(Area { rings, rule })
    }

    fn ring(
        &mut self,
        it: &Entity<'_>,
        path: &[Pair<'_>],
        frame: Affine,
    ) -> Result<Option<Vec<Point>>, SourceError> {
        if let Some(corners) = corners(path)? {
            return self.bulged(it, frame, &corners, true).map(Some);
        }
        let mut ring = Vec::new();
        for edge in edges(path) {
            let Some(mut points) = self.edge(it, edge, frame)? else {
                return Ok(None);
            };
            ring.append(&mut points);
            if ring.len() > MAX_SEGMENTS {
                self.sketch.spend(ring.len())?;
            }
        }
        Ok(Some(ring))
    }

    /// The corners of a line or an arc, nothing of others.
    fn edge(
        &mut self,
        it: &Entity<'_>,
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
            let ends = [at, point(11, 21)?].map(|p| self.place(it, frame, p));
            return Ok(Some(ends.into_iter().collect::<Result<_, _>>()?));
        }
        if kind != ARC {
            return Ok(None);
        }
        let (radius, is_left) = (number(40)?, number(73)? != 0.0);
        let (from_deg, to_deg) = (number(50)?, number(51)?);
        // Of one that goes clockwise the angles are counted clockwise too.
        let side = if is_left { 1.0 } else { -1.0 };
        let across = way(frame, Vec2::new(radius, 0.0));
        let along = way(frame, Vec2::new(0.0, radius * side));
        let center = self.place(it, frame, at)?;
        let [from_rad, sweep_rad] = span_rad(from_deg, to_deg);
        let arc = Arc::ellipse(center, across, along, from_rad, sweep_rad);
        Ok(Some(self.sketch.arc_points(it.at, &arc)?))
    }
}

/// The edges of a boundary that is no polyline: each begins with its kind.
fn edges<'p, 't>(path: &'p [Pair<'t>]) -> impl Iterator<Item = &'p [Pair<'t>]> {
    let path = before_sources(path);
    let first = path.iter().position(|it| it.code == 72);
    let mut rest = &path[first.unwrap_or(path.len())..];
    std::iter::from_fn(move || {
        let after = rest.get(1..)?;
        let next = after.iter().position(|it| it.code == 72);
        let (edge, others) = rest.split_at(next.map_or(rest.len(), |it| it + 1));
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

/// A boundary without what follows it: its sources, the pattern, the seeds.
fn before_sources<'p, 't>(path: &'p [Pair<'t>]) -> &'p [Pair<'t>] {
    let end = path.iter().position(|it| matches!(it.code, 97 | 75));
    &path[..end.unwrap_or(path.len())]
}

const POLYLINE: i64 = 2;
/// Kinds of edges; others are 3, ellipses, and 4, splines.
const LINE: f64 = 1.0;
const ARC: f64 = 2.0;
