//! MLINE: parallel lines.

use std::f64::consts::PI;

use dobot_geometry::{Affine, Point, Vec2};

use super::entity::Entity;
use super::renderer::EntityRenderer;
use crate::error::SourceError;

/// A corner: each line passes it at its distance along the mitre.
///
/// ```text
///   -----------+ offset 1
///             /|
///   --------x  |      x the corner, its mitre leads to the lower right or the upper left
///    -----+ |  |
/// ```
#[derive(Debug)]
struct Corner {
    at: Point,
    mitre: Vec2,
    offsets: Vec<f64>,
}

impl Corner {
    /// The positions of the outermost lines on each side.
    fn sides(&self) -> [Point; 2] {
        let least = self.offsets.iter().copied().fold(f64::INFINITY, f64::min);
        let most = self
            .offsets
            .iter()
            .copied()
            .fold(f64::NEG_INFINITY, f64::max);
        [least, most].map(|value| self.at + self.mitre * value)
    }
}

impl<'a> EntityRenderer<'_, 'a> {
    /// Draws each of its lines and the caps of its style.
    pub(super) fn multiline(
        &mut self,
        entity: &Entity<'a>,
        frame: Affine,
    ) -> Result<(), SourceError> {
        let (corners, has_gaps) = corners(entity)?;
        if has_gaps {
            self.left_out(entity, "drawn without its gaps");
        }
        let lines = corners.iter().map(|corner| corner.offsets.len()).min();
        for line in 0..lines.unwrap_or(0) {
            let place = |corner: &Corner| corner.at + corner.mitre * corner.offsets[line];
            let mut points: Vec<Point> = corners.iter().map(place).collect();
            if entity.flags(71)? & CLOSED != 0 {
                points.extend(points.first().copied());
            }
            let points = self.places(entity, frame, &points)?;
            self.sketch.stroke(points)?;
        }
        self.caps(entity, frame, &corners, lines.unwrap_or(0))
    }

    /// Draws the cross lines: straight or round caps at both ends, and the mitres of the corners.
    ///
    /// ```text
    ///      ,----------------
    ///    ,' ,---------------   a round cap is an arc of the outer lines, and arcs
    ///    ', '---------------   of pairs of the inner ones
    ///      '----------------
    /// ```
    fn caps(
        &mut self,
        entity: &Entity<'a>,
        frame: Affine,
        corners: &[Corner],
        lines: usize,
    ) -> Result<(), SourceError> {
        let (Some(handle), [first, middle @ .., last]) = (entity.find(340), corners) else {
            return Ok(());
        };
        let style = match self.object(handle)? {
            Some(style) if style.kind == b"MLINESTYLE" => style.flags(70)?,
            _ => return Ok(()),
        };
        let flags = entity.flags(71)?;
        let is_closed = flags & CLOSED != 0;
        if style & MITRES != 0 && lines > 1 {
            let ends = [first, last].into_iter().filter(|_| is_closed);
            for corner in middle.iter().chain(ends) {
                self.across(entity, frame, corner.sides())?;
            }
        }
        let [second, before] = [corners[1].at, corners[corners.len() - 2].at];
        let ends = [
            (first, first.at - second, NO_START, START_CAPS),
            (last, last.at - before, NO_END, END_CAPS),
        ];
        for (end, outward, suppressed, [straight, inner, outer]) in ends {
            if is_closed || flags & suppressed != 0 || lines < 2 {
                continue;
            }
            if style & straight != 0 {
                self.across(entity, frame, end.sides())?;
            }
            if style & outer != 0 {
                self.half_circle(entity, frame, end.sides(), outward)?;
            }
            if style & inner != 0 {
                let mut inner: Vec<Point> = (end.offsets.iter().take(lines))
                    .map(|entity| end.at + end.mitre * *entity)
                    .collect();
                inner.sort_by(|a, b| {
                    let along = |p: &Point| (*p - end.at).dot(end.mitre);
                    along(a).total_cmp(&along(b))
                });
                for i in 1..lines / 2 {
                    let pair = [inner[i], inner[lines - 1 - i]];
                    self.half_circle(entity, frame, pair, outward)?;
                }
            }
        }
        Ok(())
    }

    fn across(
        &mut self,
        entity: &Entity<'_>,
        frame: Affine,
        ends: [Point; 2],
    ) -> Result<(), SourceError> {
        let points = self.places(entity, frame, &ends)?;
        self.sketch.stroke(points)
    }

    /// A half circle from one point to another, on the side of a direction.
    fn half_circle(
        &mut self,
        entity: &Entity<'_>,
        frame: Affine,
        [from, to]: [Point; 2],
        side: Vec2,
    ) -> Result<(), SourceError> {
        let center = from.midpoint(to);
        let across = from - center;
        let along = across.turn_90();
        let along = if along.dot(side) < 0.0 { -along } else { along };
        self.sketch.lift();
        self.round(entity, frame, center, [across, along], [0.0, PI])
    }
}

/// The corners, and whether a line has gaps: the first of the numbers of a line (41, counted in 74)
/// is its offset, the second its start.
fn corners(entity: &Entity<'_>) -> Result<(Vec<Corner>, bool), SourceError> {
    let mut corners: Vec<Corner> = Vec::new();
    let (mut is_offset, mut has_gaps) = (false, false);
    for pair in &entity.pairs {
        match (pair.code, corners.last_mut()) {
            (11, _) => corners.push(Corner {
                at: Point::new(pair.number()?, 0.0),
                mitre: Vec2::ZERO,
                offsets: Vec::new(),
            }),
            (21, Some(last)) => last.at.y = pair.number()?,
            (13, Some(last)) => last.mitre.x = pair.number()?,
            (23, Some(last)) => last.mitre.y = pair.number()?,
            (74, Some(_)) => {
                is_offset = true;
                has_gaps |= pair.number()? > 2.0;
            }
            (41, Some(last)) if is_offset => {
                last.offsets.push(pair.number()?);
                is_offset = false;
            }
            _ => {}
        }
    }
    Ok((corners, has_gaps))
}

/// The flag of a closed line.
const CLOSED: u32 = 2;
/// The flags of a line without caps.
const NO_START: u32 = 4;
const NO_END: u32 = 8;
/// The style flag of drawn mitres.
const MITRES: u32 = 2;
/// The cap flags: straight, arcs of pairs of inner lines, an arc of the outer ones.
const START_CAPS: [u32; 3] = [16, 32, 64];
const END_CAPS: [u32; 3] = [256, 512, 1024];
