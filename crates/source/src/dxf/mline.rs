//! MLINE: lines side by side.

use dobot_geometry::{Affine, Point, Vec2};

use super::entity::Entity;
use super::renderer::EntityRenderer;
use crate::error::SourceError;

/// A corner: each of the lines passes it so far away along its mitre.
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

impl EntityRenderer<'_, '_> {
    /// Each of its lines; their ends are open.
    pub(super) fn multiline(&mut self, it: &Entity<'_>, frame: Affine) -> Result<(), SourceError> {
        let (corners, has_gaps) = corners(it)?;
        if has_gaps {
            self.left_out(it, "drawn without its gaps");
        }
        let lines = corners.iter().map(|it| it.offsets.len()).min();
        for line in 0..lines.unwrap_or(0) {
            let place = |corner: &Corner| corner.at + corner.mitre * corner.offsets[line];
            let mut points: Vec<Point> = corners.iter().map(place).collect();
            if it.flags(71)? & CLOSED != 0 {
                points.extend(points.first().copied());
            }
            let points = self.places(it, frame, &points)?;
            self.sketch.stroke(points)?;
        }
        Ok(())
    }
}

/// The corners, and whether a line has gaps: of the numbers of a line (41), which are counted before (74), the first is
/// its offset, and the second where it begins.
fn corners(it: &Entity<'_>) -> Result<(Vec<Corner>, bool), SourceError> {
    let mut corners: Vec<Corner> = Vec::new();
    let (mut is_offset, mut has_gaps) = (false, false);
    for pair in &it.pairs {
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

/// Flag of a line that ends where it begins.
const CLOSED: u32 = 2;
