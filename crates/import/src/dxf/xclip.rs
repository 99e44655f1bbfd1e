//! Clipped blocks: INSERTs with a spatial filter.

use dobot_geometry::{Affine, Point, Rect, bounds};

use super::entity::Entity;
use super::pairs::Pair;
use super::renderer::EntityRenderer;
use crate::error::SourceError;

impl<'a> EntityRenderer<'_, 'a> {
    /// The clip ring of the block of an INSERT, in the block's units; `None` if it is not clipped.
    ///
    /// ```text
    ///   INSERT -- 102 {ACAD_XDICTIONARY 360 --> DICTIONARY -- 3 ACAD_FILTER 360 -->
    ///   DICTIONARY -- 3 SPATIAL 360 --> SPATIAL_FILTER
    /// ```
    pub(super) fn clip(&mut self, entity: &Entity<'a>) -> Result<Option<Vec<Point>>, SourceError> {
        let mut own = entity.pairs.iter();
        own.find(|value| value.is(102, b"{ACAD_XDICTIONARY"));
        let Some(own) = own.find(|value| value.code == 360) else {
            return Ok(None);
        };
        let Some(filters) = self.entry(own, b"ACAD_FILTER")? else {
            return Ok(None);
        };
        let Some(filter) = self.entry(&filters, b"SPATIAL")? else {
            return Ok(None);
        };
        match self.object(&filter)? {
            Some(entity) if entity.kind == b"SPATIAL_FILTER" => ring(&entity).map(Some),
            _ => Ok(None),
        }
    }

    /// The entry of a dictionary.
    fn entry(
        &mut self,
        dictionary: &Pair<'a>,
        name: &[u8],
    ) -> Result<Option<Pair<'a>>, SourceError> {
        let Some(object) = self.object(dictionary)? else {
            return Ok(None);
        };
        let mut entries = object.pairs.iter();
        entries.find(|entry| entry.is(3, name));
        Ok(entries
            .find(|entry| matches!(entry.code, 350 | 360))
            .copied())
    }

    /// The object with a handle.
    pub(super) fn object(&mut self, handle: &Pair<'a>) -> Result<Option<Entity<'a>>, SourceError> {
        let Some(&span) = self.file.objects.get(handle.value) else {
            return Ok(None);
        };
        // Many blocks may refer to the same one.
        self.spend(span)?;
        Entity::read(self.file.text, span).map(Some)
    }
}

/// The corners of a filter.
fn ring(entity: &Entity<'_>) -> Result<Vec<Point>, SourceError> {
    let corners = entity.points(10)?;
    let numbers = entity.numbers(40)?;
    // The last groups are two matrices of twelve numbers: the first is from the world to the block.
    let Some(&[xx, xy, _, x, yx, yy, _, y, ..]) =
        numbers.len().checked_sub(24).map(|n| &numbers[n..])
    else {
        let found = format!("a clip with {} numbers (group 40)", numbers.len());
        return Err(entity.refused(found, "two matrices of 12 numbers"));
    };
    let to_block = Affine::new([xx, yx, xy, yy, x, y]);
    let corners: Vec<Point> = corners.into_iter().map(|p| to_block * p).collect();
    if corners.len() != 2 {
        return Ok(corners);
    }
    let Rect { x0, y0, x1, y1 } = bounds(corners);
    Ok([(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
        .map(Point::from)
        .to_vec())
}
