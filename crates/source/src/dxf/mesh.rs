//! MESH: corners and the faces between them.

use std::collections::BTreeSet;

use dobot_geometry::{Affine, Point};

use super::entity::Entity;
use super::renderer::EntityRenderer;
use crate::error::SourceError;
use crate::place::shortened;

impl EntityRenderer<'_, '_> {
    /// The edges of its faces, each once, as they are seen from above.
    pub(super) fn mesh(&mut self, it: &Entity<'_>, frame: Affine) -> Result<(), SourceError> {
        if it.flags(91)? > 0 {
            self.left_out(it, "drawn with straight edges, not smoothed");
        }
        let corners = self.places(it, frame, &it.points(10)?)?;
        for (a, b) in edges(it, corners.len())? {
            let ends: [Point; 2] = [a, b].map(|i| corners[i]);
            if ends[0] != ends[1] {
                self.sketch.stroke(ends.to_vec())?;
            }
        }
        Ok(())
    }
}

/// The edges of all faces by their corners, the smaller number first. The list of faces has for each the count of its
/// corners, and these.
fn edges(it: &Entity<'_>, corners: usize) -> Result<BTreeSet<(usize, usize)>, SourceError> {
    let list = it.pairs.iter().skip_while(|pair| pair.code != 93).skip(1);
    let mut list = list.take_while(|pair| pair.code == 90);
    let mut edges = BTreeSet::new();
    let mut next = |allowed: usize, what: &str| {
        let Some(pair) = list.next() else {
            return Ok::<_, SourceError>(None);
        };
        let text = pair.text();
        let number = text.parse().ok().filter(|it: &usize| *it <= allowed);
        let found = || it.refused(format!("{:?} in the faces of MESH", shortened(&text)), what);
        Ok(Some(number.ok_or_else(found)?))
    };
    let expected = "counts of corners, and for each as many numbers of corners that are there";
    while let Some(count) = next(corners, expected)? {
        let mut face = Vec::new();
        for _ in 0..count {
            let corner = next(corners.saturating_sub(1), expected)?;
            face.push(
                corner.ok_or_else(|| it.refused("a face of MESH that ends early", expected))?,
            );
        }
        for (i, &a) in face.iter().enumerate() {
            let b = face[(i + 1) % face.len()];
            edges.insert((a.min(b), a.max(b)));
        }
    }
    Ok(edges)
}
