//! Patterns as lines: the tiles of a pattern, clipped to the shape.

use std::rc::Rc;

use dobot_geometry::{Affine, Point, Vec2, bounds};
use usvg::{Path, Pattern};

use super::mask::boxed;
use super::renderer::{TreeRenderer, affine};
use crate::clip::Region;
use crate::error::SvgError;

impl TreeRenderer<'_> {
    /// Draws a shape filled with a pattern; `false` if it has too many tiles.
    pub(super) fn pattern(
        &mut self,
        path: &Path,
        pattern: &Pattern,
        transform: Affine,
        clips: &[Rc<Region>],
    ) -> Result<bool, SvgError> {
        let own = affine(pattern.transform());
        let rect = pattern.rect();
        let [width, height] = [rect.width(), rect.height()].map(f64::from);
        let start = Vec2::new(f64::from(rect.x()), f64::from(rect.y()));
        let shape = path.bounding_box();
        let [x0, y0, x1, y1] =
            [shape.left(), shape.top(), shape.right(), shape.bottom()].map(f64::from);
        let corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)];
        let inverse = own.inverse();
        let around = bounds(corners.map(|(x, y)| inverse * Point::new(x, y) - start));
        let columns = [around.x0 / width, around.x1 / width];
        let rows = [around.y0 / height, around.y1 / height];
        let number = |[from, to]: [f64; 2]| to.ceil() - from.floor();
        let tiles = number(columns) * number(rows);
        if tiles.is_nan() || tiles > f64::from(self.tiles_left) {
            return Ok(false);
        }
        let inside = Region::new(vec![self.area(path, transform, Vec::new())?]);
        let mut clips: Vec<Rc<Region>> = clips.iter().cloned().chain([Rc::new(inside)]).collect();
        for row in steps(rows) {
            for column in steps(columns) {
                // An empty tile spends nothing.
                self.page.work.budget.spend(0)?;
                self.tiles_left = self.tiles_left.saturating_sub(1);
                let corner = start + Vec2::new(column * width, row * height);
                let place = transform * own * Affine::translate(corner);
                clips.push(boxed([0.0, 0.0, width, height], place));
                self.group(pattern.root(), place, &mut clips)?;
                clips.pop();
            }
        }
        Ok(true)
    }
}

/// The whole numbers from the one below the first to the one below the second.
fn steps([from, to]: [f64; 2]) -> impl Iterator<Item = f64> {
    std::iter::successors(Some(from.floor()), |step| Some(step + 1.0))
        .take_while(move |step| *step < to)
}

/// The largest number of tiles in a file.
pub(super) const MAX_TILES: u32 = 20_000;
