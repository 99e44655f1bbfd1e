//! The pattern lines of a hatch.

use dobot_geometry::{Affine, Area, Point, Rect, Vec2, bounds};

use super::entity::Entity;
use super::renderer::EntityRenderer;
use crate::error::SourceError;
use crate::frame::way;

/// A family of parallel lines with equal shift and dashes.
///
/// ```text
///                 / /  --- dashes: a length that is drawn, one that is not (below 0), 0 a dot
///       shift -> / /
///      base ->  x /     at an angle
/// ```
#[derive(Debug)]
pub(super) struct PatternLine {
    angle_deg: f64,
    base: Vec2,
    shift: Vec2,
    dashes: Vec<f64>,
}

impl PatternLine {
    /// The families of a hatch, which include angle and scale of the pattern.
    pub(super) fn all(entity: &Entity<'_>) -> Result<Vec<Self>, SourceError> {
        let begin = entity.pairs.iter().position(|pair| pair.code == 78);
        let mut lines: Vec<Self> = Vec::new();
        for pair in &entity.pairs[begin.unwrap_or(entity.pairs.len())..] {
            match (pair.code, lines.last_mut()) {
                (53, _) => lines.push(Self {
                    angle_deg: pair.number()?,
                    base: Vec2::ZERO,
                    shift: Vec2::ZERO,
                    dashes: Vec::new(),
                }),
                (43, Some(last)) => last.base.x = pair.number()?,
                (44, Some(last)) => last.base.y = pair.number()?,
                (45, Some(last)) => last.shift.x = pair.number()?,
                (46, Some(last)) => last.shift.y = pair.number()?,
                (49, Some(last)) => last.dashes.push(pair.number()?),
                // The seeds, the colours.
                (98 | 450, _) => break,
                _ => {}
            }
        }
        Ok(lines)
    }

    /// Its dashes within these bounds; `None` if there are too many or the lines have no distance.
    fn dashes_in(&self, frame: Affine, bounds: Rect) -> Option<Vec<[Point; 2]>> {
        let along = way(frame, Vec2::from_angle(self.angle_deg.to_radians()));
        let unit_mm = along.length();
        let along = along / unit_mm;
        let (base, shift) = (frame * self.base.to_point(), way(frame, self.shift));
        let apart_mm = along.cross(shift);
        let corners = [
            Point::new(bounds.x0, bounds.y0),
            Point::new(bounds.x1, bounds.y0),
            Point::new(bounds.x1, bounds.y1),
            Point::new(bounds.x0, bounds.y1),
        ];
        let [first, last] = extent(corners.map(|p| along.cross(p - base) / apart_mm));
        let [begin_mm, end_mm] = extent(corners.map(|p| along.dot(p - base)));
        let period_mm: f64 = self.dashes.iter().map(|dash| dash.abs() * unit_mm).sum();
        let is_dashed = period_mm > 0.0;
        let per_line = if is_dashed {
            (end_mm - begin_mm) / period_mm + 2.0
        } else {
            1.0
        };
        #[expect(clippy::cast_precision_loss, reason = "a handful")]
        let count = (last - first + 1.0) * per_line * self.dashes.len().max(1) as f64;
        if count.is_nan() || count >= MAX_DASHES {
            return None;
        }
        let mut dashes = Vec::new();
        let mut line = first.ceil();
        while line <= last {
            let from = base + shift * line;
            // The range of the bounds on this line, from the start of its dashes.
            let before_mm = along.dot(shift) * line;
            let [begin, end] = [begin_mm - before_mm, end_mm - before_mm];
            if is_dashed {
                self.dash(from, along, unit_mm, [begin, end], period_mm, &mut dashes);
            } else {
                dashes.push([begin, end].map(|mm| from + along * mm));
            }
            line += 1.0;
        }
        Some(dashes)
    }

    fn dash(
        &self,
        from: Point,
        along: Vec2,
        unit_mm: f64,
        [begin_mm, end_mm]: [f64; 2],
        period_mm: f64,
        dashes: &mut Vec<[Point; 2]>,
    ) {
        let mut at_mm = (begin_mm / period_mm).floor() * period_mm;
        while at_mm <= end_mm {
            for dash in &self.dashes {
                let to_mm = at_mm + dash.abs() * unit_mm;
                if *dash >= 0.0 && to_mm >= begin_mm && at_mm <= end_mm {
                    dashes.push([at_mm, to_mm].map(|mm| from + along * mm));
                }
                at_mm = to_mm;
            }
        }
    }
}

impl EntityRenderer<'_, '_> {
    /// Draws the pattern lines of an area; too many of them are left to hatching.
    pub(super) fn pattern(
        &mut self,
        entity: &Entity<'_>,
        frame: Affine,
        area: Area,
        lines: &[PatternLine],
    ) -> Result<(), SourceError> {
        let around = bounds(area.rings.iter().flatten().copied());
        let mut all = Vec::new();
        for line in lines {
            let Some(mut dashes) = line.dashes_in(frame, around) else {
                self.left_out(
                    entity,
                    "its pattern left out, because it has too many lines",
                );
                return self.sketch.area(area);
            };
            all.append(&mut dashes);
        }
        self.sketch.lines_within(&area, all.into_iter())
    }
}

/// The minimum and the maximum.
fn extent(numbers: [f64; 4]) -> [f64; 2] {
    let least = numbers.iter().copied().fold(f64::INFINITY, f64::min);
    let most = numbers.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    [least, most]
}

/// The largest number of lines of one family in a hatch.
const MAX_DASHES: f64 = 20_000.0;
