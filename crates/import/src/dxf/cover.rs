//! Entities that hide others: filled areas and WIPEOUT.

use dobot_geometry::{Affine, Area, FillRule, Point};

use super::entity::Entity;
use super::file::LayerInfo;
use super::renderer::EntityRenderer;
use crate::error::SourceError;

impl EntityRenderer<'_, '_> {
    /// Hides what was drawn before under a filled area, unless it is transparent.
    pub(super) fn cover(&mut self, entity: &Entity<'_>, area: &Area) -> Result<(), SourceError> {
        if self.is_opaque(entity, self.layer_info())? {
            self.sketch.cover(&area.rings, area.rule)?;
        }
        Ok(())
    }

    /// Whether the entity, its layer or the INSERT of its block is opaque.
    pub(super) fn is_opaque(
        &self,
        entity: &Entity<'_>,
        layer: Option<&LayerInfo>,
    ) -> Result<bool, SourceError> {
        let own = entity.flags(440)?;
        let shows_nothing = |value: u32| value >> 24 != BY_VALUE || value & 0xff == OPAQUE;
        Ok(match own >> 24 {
            BY_LAYER => layer.is_none_or(|layer| shows_nothing(layer.transparency)),
            BY_BLOCK => self.block_is_opaque,
            _ => shows_nothing(own),
        })
    }

    /// Draws an area that only hides what was drawn before.
    ///
    /// ```text
    ///   -0.5,-0.5 +-------+        Its corners (14, 24) are counted in pixels from the middle of the upper left one,
    ///             |       |        down. A pixel is as wide as 11, 21 and as high as 12, 22; the picture begins at
    ///     10, 20 -+-------+        10, 20 and is so many (23) high.
    /// ```
    ///
    /// If its mode (290) is 1, it covers the picture except for the inside of these corners.
    pub(super) fn wipeout(
        &mut self,
        entity: &Entity<'_>,
        frame: Affine,
    ) -> Result<(), SourceError> {
        if !self.sketch.hides() {
            self.left_out(
                entity,
                "left out, and what it covers is drawn; what.hide removes that",
            );
            return Ok(());
        }
        let corner = entity.point(10)?;
        let [across, up] = [entity.point(11)?.to_vec2(), entity.point(12)?.to_vec2()];
        let (wide, high) = (entity.number_or(13, 1.0)?, entity.number_or(23, 1.0)?);
        let whole = [Point::new(-0.5, -0.5), Point::new(wide - 0.5, high - 0.5)];
        let corners = match entity.points(14)?.as_slice() {
            [] => rectangle(whole),
            &[a, b] => rectangle([a, b]),
            corners => corners.to_vec(),
        };
        let mut rings = vec![corners];
        if entity.flags(290)? == INSIDE {
            rings.push(rectangle(whole));
        }
        let on_paper = |p: Point| {
            let p = corner + across * (p.x + 0.5) + up * (high - 0.5 - p.y);
            self.place(entity, frame, p)
        };
        let rings = rings
            .into_iter()
            .map(|ring| ring.into_iter().map(on_paper).collect());
        let rings = rings.collect::<Result<Vec<_>, _>>()?;
        self.sketch.cover(&rings, FillRule::EvenOdd)
    }
}

fn rectangle([a, b]: [Point; 2]) -> Vec<Point> {
    vec![a, Point::new(b.x, a.y), b, Point::new(a.x, b.y)]
}

/// The flag of a picture that is clipped to its corners.
const INSIDE: u32 = 1;
/// The transparency (440) that refers to the layer.
const BY_LAYER: u32 = 0;
/// The transparency that refers to the INSERT.
const BY_BLOCK: u32 = 1;
/// The transparency with an explicit last byte.
const BY_VALUE: u32 = 2;
const OPAQUE: u32 = 0xff;
