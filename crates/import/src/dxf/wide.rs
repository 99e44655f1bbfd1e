//! Polylines with a width: areas, as in `AutoCAD`.

use dobot_geometry::{Affine, Area, FillRule, Point, Polygons, Vec2};

use super::entity::Entity;
use super::renderer::EntityRenderer;
use super::shapes::{Corner, bulge_center};
use crate::arc::Arc;
use crate::error::SourceError;
use crate::frame::way;
use crate::limits::MAX_SEGMENTS;

/// A place on the middle line of a wide segment.
///
/// ```text
///   ------- + -------    the left edge
///           | beside     half the width
///   --------+--------    at
///
///   -----------------    the right edge
/// ```
#[derive(Clone, Copy, Debug)]
struct Section {
    at: Point,
    beside: Vec2,
}

impl EntityRenderer<'_, '_> {
    /// Draws the parts of a polyline without a width as lines, and the others as one area.
    pub(super) fn wide_polyline(
        &mut self,
        entity: &Entity<'_>,
        frame: Affine,
        corners: &[Corner],
        is_closed: bool,
    ) -> Result<(), SourceError> {
        let ends = corners
            .iter()
            .skip(1)
            .chain(corners.first().filter(|_| is_closed));
        let segments: Vec<_> = corners.iter().zip(ends).collect();
        let widths = segments.iter().flat_map(|(from, _)| from.widths);
        if let Some(width) = widths.clone().find(|width| *width < 0.0) {
            let found = format!("a polyline of width {width}");
            return Err(entity.refused(found, "a width of 0 or more"));
        }
        if widths.clone().all(|width| width == 0.0) {
            let points = self.bulged(entity, frame, corners, is_closed)?;
            return self.sketch.stroke(points);
        }
        let is_thin = |corner: &Corner| corner.widths == [0.0; 2];
        let mut wide: Vec<Option<Vec<Section>>> = Vec::with_capacity(segments.len());
        for run in segments.chunk_by(|a, b| is_thin(a.0) == is_thin(b.0)) {
            if is_thin(run[0].0) {
                let last = run.last().map(|(_, to)| **to);
                let line: Vec<Corner> = run.iter().map(|(from, _)| **from).chain(last).collect();
                let points = self.bulged(entity, frame, &line, false)?;
                self.sketch.stroke(points)?;
            }
            for &(from, to) in run {
                let is_drawn = !is_thin(from) && from.at != to.at;
                let sections = is_drawn.then(|| self.sections(entity, frame, from, to.at));
                wide.push(sections.transpose()?);
            }
        }
        fit_smooth_joints(&mut wide, is_closed);
        let area = self.wide_area(entity, frame, &wide, is_closed)?;
        self.cover(entity, &area)?;
        self.sketch.area(area)
    }

    /// The sections of a segment, from its start to its end.
    fn sections(
        &self,
        entity: &Entity<'_>,
        frame: Affine,
        from: &Corner,
        to: Point,
    ) -> Result<Vec<Section>, SourceError> {
        let [begin, end] = from.widths.map(|width| width / 2.0);
        let half = |share: f64| begin + (end - begin) * share;
        if from.bulge == 0.0 {
            let way = to - from.at;
            let left = way.turn_90() * (1.0 / way.length());
            let section = |at, share| Section {
                at,
                beside: left * half(share),
            };
            return Ok(vec![section(from.at, 0.0), section(to, 1.0)]);
        }
        let (center, sweep_rad) = bulge_center(from, to);
        let out = from.at - center;
        let larger = 1.0 + begin.max(end) / out.length();
        let [across, along] = [out, out.turn_90()].map(|side| way(frame, side * larger));
        let edge = Arc::ellipse(frame * center, across, along, 0.0, sweep_rad);
        let chords = self.sketch.arc_points(entity.at, &edge)?.len() - 1;
        let inwards = -sweep_rad.signum() / out.length();
        #[expect(clippy::cast_precision_loss, reason = "a few millions")]
        let section = |i: usize| {
            let share = i as f64 / chords as f64;
            let out = Affine::rotate(sweep_rad * share) * out.to_point();
            Section {
                at: center + out.to_vec2(),
                beside: out.to_vec2() * (inwards * half(share)),
            }
        };
        let mut sections: Vec<Section> = (0..=chords).map(section).collect();
        (sections[0].at, sections[chords].at) = (from.at, to);
        Ok(sections)
    }

    /// The union of segments and of the joints between them.
    fn wide_area(
        &mut self,
        entity: &Entity<'_>,
        frame: Affine,
        wide: &[Option<Vec<Section>>],
        is_closed: bool,
    ) -> Result<Area, SourceError> {
        let outlines = wide.iter().flatten().map(|sections| outline(sections));
        let next = wide
            .iter()
            .skip(1)
            .chain(wide.first().filter(|_| is_closed));
        let joints = wide
            .iter()
            .zip(next)
            .filter_map(|(a, b)| joint(*a.as_ref()?.last()?, *b.as_ref()?.first()?));
        let mut rings = Vec::new();
        let mut count = 0;
        for ring in outlines.chain(joints) {
            count += ring.len();
            if count > MAX_SEGMENTS {
                self.sketch.spend(count)?;
            }
            rings.push(self.places(entity, frame, &ring)?);
        }
        let rule = FillRule::NonZero;
        let union = Polygons::new(&rings, rule).map(Polygons::into_area);
        Ok(union.unwrap_or(Area { rings, rule }))
    }
}

/// Gives segments that continue each other the same edge, without a gap by rounding.
fn fit_smooth_joints(wide: &mut [Option<Vec<Section>>], is_closed: bool) {
    let count = wide.len();
    for i in 0..count {
        let next = (i + 1) % count;
        if next == 0 && !is_closed {
            return;
        }
        let end = wide[i]
            .as_ref()
            .and_then(|sections| sections.last().copied());
        let start = wide[next]
            .as_mut()
            .and_then(|sections| sections.first_mut());
        if let (Some(end), Some(start)) = (end, start)
            && (end.beside - start.beside).length() <= 1e-6 * end.beside.length()
        {
            *start = end;
        }
    }
}

/// The left edge forwards and the right edge back, clockwise.
fn outline(sections: &[Section]) -> Vec<Point> {
    let left = sections.iter().map(|section| section.at + section.beside);
    let right = sections.iter().rev();
    left.chain(right.map(|section| section.at - section.beside))
        .collect()
}

/// What is missing on the outer side between two segments, clockwise: a mitre, or a bevel if it
/// would be too long or the widths differ.
fn joint(end: Section, start: Section) -> Option<Vec<Point>> {
    let (a, b) = (end.beside, start.beside);
    let turn = a.cross(b);
    let squares = a.length() * b.length();
    if turn.abs() <= 1e-9 * squares {
        return None;
    }
    let outer = if turn > 0.0 { -1.0 } else { 1.0 };
    let corner = end.at;
    let mut ring = vec![corner, corner + a * outer];
    let cosine = a.dot(b) / squares;
    let has_mitre = (a.length() - b.length()).abs() < 1e-6 * a.length();
    if has_mitre && cosine > LEAST_COSINE {
        ring.push(corner + (a + b) * (outer / (1.0 + cosine)));
    }
    ring.push(corner + b * outer);
    if turn > 0.0 {
        ring.reverse();
    }
    Some(ring)
}

/// The cosine of the turn up to which segments have a mitre.
const LEAST_COSINE: f64 = -0.9;
