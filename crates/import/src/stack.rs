//! The stacking order of a sketch.

use std::rc::Rc;

use dobot_geometry::{FillRule, Point, Stroke};

use crate::artwork::Layer;
use crate::clip::{ClipArea, Region};
use crate::hidden::{CoverPaint, Covers, Heights};
use crate::limits::{Budget, OverBudget};

/// The hiding areas, and the number of them below the ink of each layer.
#[derive(Debug, Default)]
pub(crate) struct Stack {
    covers: Covers,
    /// By layer, as far as [`note`](Self::note) has recorded its ink.
    pub(crate) heights: Vec<Heights>,
}

impl Stack {
    /// The number of hiding areas.
    pub(crate) fn height(&self) -> u32 {
        self.covers.count()
    }

    /// Records that all ink since the last call is above all areas.
    pub(crate) fn note(&mut self, layers: &[Layer]) {
        let height = self.height();
        self.heights.resize_with(layers.len(), Heights::default);
        for (heights, layer) in self.heights.iter_mut().zip(layers) {
            heights.strokes.resize(layer.strokes.len(), height);
            heights.areas.resize(layer.areas.len(), height);
        }
    }

    /// Adds an area over all ink.
    pub(crate) fn cover(&mut self, layers: &[Layer], rings: &[Vec<Point>], rule: FillRule) {
        self.note(layers);
        let outlines: Vec<Stroke> = rings.iter().cloned().map(Stroke::open).collect();
        let area = ClipArea::new(&outlines, rule, Vec::new());
        self.covers.put(area, CoverPaint::Ink(None), true);
    }

    /// Limits the areas above the first `height` to a region.
    pub(crate) fn clip_since(&mut self, height: u32, region: &Rc<Region>) {
        self.covers.clip_since(height, region);
    }

    /// The visible parts of each layer, and the number of lines and areas for which they are
    /// unknown.
    pub(crate) fn what_shows(
        mut self,
        layers: Vec<Layer>,
        fills: bool,
        budget: &mut Budget,
    ) -> Result<(Vec<Layer>, usize), OverBudget> {
        self.note(&layers);
        self.covers.what_shows(layers, &self.heights, fills, budget)
    }
}
