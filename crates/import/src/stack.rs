//! What lies over what in a sketch.

use std::rc::Rc;

use dobot_geometry::{FillRule, Point, Stroke};

use crate::artwork::Layer;
use crate::clip::{ClipArea, Region};
use crate::hidden::{Covers, Heights};
use crate::limits::{Budget, OverBudget};

/// The areas that hide something, and above how many of them the ink of each layer lies.
#[derive(Debug, Default)]
pub(crate) struct Stack {
    covers: Covers,
    /// By layer; as far as [`note`](Self::note) has seen its ink.
    pub(crate) heights: Vec<Heights>,
}

impl Stack {
    /// How many areas hide something so far.
    pub(crate) fn height(&self) -> u32 {
        self.covers.count()
    }

    /// All ink that came since the last one lies above all areas so far.
    pub(crate) fn note(&mut self, layers: &[Layer]) {
        let height = self.height();
        self.heights.resize_with(layers.len(), Heights::default);
        for (heights, layer) in self.heights.iter_mut().zip(layers) {
            heights.strokes.resize(layer.strokes.len(), height);
            heights.areas.resize(layer.areas.len(), height);
        }
    }

    /// Lays an area over all ink so far.
    pub(crate) fn cover(&mut self, layers: &[Layer], rings: &[Vec<Point>], rule: FillRule) {
        self.note(layers);
        let outlines: Vec<Stroke> = rings.iter().cloned().map(Stroke::open).collect();
        self.covers.put(ClipArea::new(&outlines, rule, Vec::new()));
    }

    /// The areas above the first `height` hide nothing outside of this region.
    pub(crate) fn clip_since(&mut self, height: u32, region: &Rc<Region>) {
        self.covers.clip_since(height, region);
    }

    /// What shows of each layer, and of how many lines and areas that is not known.
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
