//! The fill of a layer's shapes: a shape inside another one is a hole.

use std::collections::BTreeMap;

use dobot_geometry::{Area, FillRule, Point};

use super::cut::{Cuts, Filling};
use crate::error::SourceError;
use crate::sketch::Sketch;

/// The rings to fill, by layer and by the shapes filled together.
#[derive(Debug, Default)]
pub(super) struct Fills(BTreeMap<(u32, usize), Vec<Vec<Point>>>);

impl Fills {
    /// Adds a ring of a shape in an outermost group; both count from 0.
    pub(super) fn keep(
        &mut self,
        cut: u32,
        filling: Filling,
        [group, shape]: [usize; 2],
        ring: Vec<Point>,
    ) {
        let together = match filling {
            Filling::Layer => 0,
            Filling::Group => group,
            Filling::Shape => shape,
        };
        self.0.entry((cut, together)).or_default().push(ring);
    }

    pub(super) fn draw(self, sketch: &mut Sketch<'_>, cuts: &mut Cuts) -> Result<(), SourceError> {
        for ((cut, _), rings) in self.0 {
            sketch.use_layer(cuts.of(cut).layer())?;
            sketch.area(Area {
                rings,
                rule: FillRule::EvenOdd,
            })?;
        }
        Ok(())
    }
}
