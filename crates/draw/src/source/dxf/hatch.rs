//! HATCH: areas by their boundaries.

use super::entity::Entity;
use super::frame::Frame;
use super::pairs::Pair;
use super::shapes::Corner;
use super::walk::Walk;
use crate::artwork::{Area, FillRule};
use crate::point::Point;
use crate::source::SourceError;

impl Walk<'_, '_> {
    /// Its boundaries as rings of an area, whatever pattern fills it; those by edges, not corners,
    /// are told and left out.
    pub(super) fn hatch(&mut self, it: &Entity<'_>, frame: Frame) -> Result<(), SourceError> {
        let starts = it
            .pairs
            .iter()
            .enumerate()
            .filter(|(_, pair)| pair.code == 92);
        let starts: Vec<usize> = starts.map(|(i, _)| i).collect();
        let mut rings = Vec::new();
        for (i, &start) in starts.iter().enumerate() {
            let end = starts.get(i + 1).copied().unwrap_or(it.pairs.len());
            let path = &it.pairs[start..end];
            let Some(corners) = corners(it.text, path)? else {
                self.left_out(it, "a boundary by arcs or splines, left out");
                return Ok(());
            };
            rings.push(self.bulged(it, frame, &corners, true)?);
        }
        let rule = FillRule::EvenOdd;
        self.sketch.area(Area { rings, rule })
    }
}

/// The corners of a boundary that is a polyline, else nothing.
fn corners(text: &[u8], path: &[Pair<'_>]) -> Result<Option<Vec<Corner>>, SourceError> {
    #[expect(clippy::cast_possible_truncation, reason = "a few bits; saturates")]
    let flags = path[0].number(text)? as i64;
    if flags & POLYLINE == 0 {
        return Ok(None);
    }
    let mut corners: Vec<Corner> = Vec::new();
    for pair in path {
        match (pair.code, corners.last_mut()) {
            // What follows the boundary: its sources, the pattern, the seeds.
            (97 | 75, _) => break,
            (10, _) => corners.push(Corner {
                at: Point::new(pair.number(text)?, 0.0),
                bulge: 0.0,
            }),
            (20, Some(last)) => last.at.y = pair.number(text)?,
            (42, Some(last)) => last.bulge = pair.number(text)?,
            _ => {}
        }
    }
    Ok(Some(corners))
}

const POLYLINE: i64 = 2;
