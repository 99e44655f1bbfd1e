//! MESH, and the older POLYLINE meshes: corners and the faces between them.

use std::collections::{BTreeSet, HashMap};

use dobot_geometry::{Affine, Point};

use super::entity::Entity;
use super::file::Span;
use super::renderer::EntityRenderer;
use super::shapes::{POLYFACE, SPLINE_CONTROL};
use crate::error::SourceError;
use crate::place::shortened;

impl EntityRenderer<'_, '_> {
    /// Draws the edges of its faces, each once, seen from above.
    pub(super) fn mesh(&mut self, entity: &Entity<'_>, frame: Affine) -> Result<(), SourceError> {
        if entity.flags(91)? > 0 {
            self.left_out(entity, "drawn with straight edges, not smoothed");
        }
        let corners = self.places(entity, frame, &entity.points(10)?)?;
        let edges = edges(entity, corners.len())?;
        self.edges(&corners, edges)
    }

    /// Draws the edges of a POLYLINE mesh: its corners are entities, and so are its faces unless
    /// they form a grid.
    pub(super) fn old_mesh(
        &mut self,
        entity: &Entity<'_>,
        vertices: &[Span<'_>],
        frame: Affine,
    ) -> Result<(), SourceError> {
        let (mut corners, mut edges) = (Vec::new(), Vec::new());
        for &span in vertices {
            let vertex = Entity::read(entity.text, span)?;
            let flags = vertex.flags(70)?;
            if flags & (FACE | CORNER) == FACE {
                edges.extend(edges_of_face(&vertex)?);
            } else if flags & SPLINE_CONTROL == 0 {
                corners.push(self.place(entity, frame, vertex.point(10)?)?);
            }
        }
        if entity.flags(70)? & POLYFACE == 0 {
            edges = edges_of_grid(entity, corners.len())?;
        }
        if edges.is_empty() || edges.iter().any(|(a, b)| *a.max(b) >= corners.len()) {
            self.left_out(entity, "left out, because its faces are incomplete");
            return Ok(());
        }
        // Faces may have separate corners at the same place, and one may lie above another.
        let same = first_in_place(&corners);
        let edges = edges.into_iter().map(|(a, b)| (same[a], same[b]));
        let edges = edges.map(|(a, b)| (a.min(b), a.max(b))).collect();
        self.edges(&corners, edges)
    }

    fn edges(
        &mut self,
        corners: &[Point],
        edges: BTreeSet<(usize, usize)>,
    ) -> Result<(), SourceError> {
        for (a, b) in edges {
            let ends: [Point; 2] = [a, b].map(|i| corners[i]);
            if ends[0] != ends[1] {
                self.sketch.stroke(ends.to_vec())?;
            }
        }
        Ok(())
    }
}

/// For each corner, the number of the first one at its place.
fn first_in_place(corners: &[Point]) -> Vec<usize> {
    let mut numbers = HashMap::new();
    let corners = corners.iter().enumerate();
    corners
        .map(|(i, p)| {
            // Adding turns a negative zero into zero.
            let place = [p.x, p.y].map(|value| (value + 0.0).to_bits());
            *numbers.entry(place).or_insert(i)
        })
        .collect()
}

/// The edges of a face by its corner numbers, which count from 1; a negative number starts an
/// invisible edge.
fn edges_of_face(face: &Entity<'_>) -> Result<Vec<(usize, usize)>, SourceError> {
    let mut corners = Vec::new();
    for code in 71..=74 {
        let number = face.number_or(code, 0.0)?;
        if number != 0.0 {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "a whole number from 1 up; saturates"
            )]
            let corner = number.abs() as usize;
            corners.push((corner.saturating_sub(1), number > 0.0));
        }
    }
    let next = corners.iter().cycle().skip(1);
    let edges = corners.iter().zip(next);
    let seen = edges.filter(|((_, is_seen), _)| *is_seen);
    Ok(seen.map(|((a, _), (b, _))| (*a, *b)).collect())
}

/// The edges of a mesh with this number of rows (71) and columns (72), for smoothed ones (73, 74);
/// none if corners are missing.
fn edges_of_grid(entity: &Entity<'_>, corners: usize) -> Result<Vec<(usize, usize)>, SourceError> {
    let codes = if entity.flags(75)? == 0 {
        [71, 72]
    } else {
        [73, 74]
    };
    let [rows, columns] = codes.map(|code| entity.flags(code));
    let (rows, columns) = (rows? as usize, columns? as usize);
    if corners == 0 || rows.checked_mul(columns) != Some(corners) {
        return Ok(Vec::new());
    }
    let flags = entity.flags(70)?;
    let next = |i: usize, count: usize, is_closed: bool| match i + 1 {
        next if next < count => Some(next),
        _ => is_closed.then_some(0),
    };
    let mut edges = Vec::new();
    for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
        let corner = |row: usize, column: usize| row * columns + column;
        let here = corner(row, column);
        let below = next(row, rows, flags & CLOSED_ROWS != 0);
        edges.extend(below.map(|row| (here, corner(row, column))));
        let beside = next(column, columns, flags & CLOSED_COLUMNS != 0);
        edges.extend(beside.map(|column| (here, corner(row, column))));
    }
    Ok(edges)
}

/// The edges of all faces by their corners, the smaller number first. The face list has a count and
/// the corner numbers for each face.
fn edges(entity: &Entity<'_>, corners: usize) -> Result<BTreeSet<(usize, usize)>, SourceError> {
    let list = entity
        .pairs
        .iter()
        .skip_while(|pair| pair.code != 93)
        .skip(1);
    let mut list = list.take_while(|pair| pair.code == 90);
    let mut edges = BTreeSet::new();
    let mut next = |allowed: usize, what: &str| {
        let Some(pair) = list.next() else {
            return Ok::<_, SourceError>(None);
        };
        let text = pair.text();
        let number = text.parse().ok().filter(|n: &usize| *n <= allowed);
        let found = || entity.refused(format!("{:?} in the faces of MESH", shortened(&text)), what);
        Ok(Some(number.ok_or_else(found)?))
    };
    let expected = "counts of corners, each followed by that many existing corner numbers";
    while let Some(count) = next(corners, expected)? {
        let mut face = Vec::new();
        for _ in 0..count {
            let corner = next(corners.saturating_sub(1), expected)?;
            face.push(
                corner.ok_or_else(|| entity.refused("a face of MESH that ends early", expected))?,
            );
        }
        for (i, &a) in face.iter().enumerate() {
            let b = face[(i + 1) % face.len()];
            edges.insert((a.min(b), a.max(b)));
        }
    }
    Ok(edges)
}

/// The POLYLINE flags of a grid whose last row, or column, joins the first.
const CLOSED_ROWS: u32 = 1;
const CLOSED_COLUMNS: u32 = 32;
/// The VERTEX flags of a corner of a mesh, and of a face.
const CORNER: u32 = 64;
const FACE: u32 = 128;
