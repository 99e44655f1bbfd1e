//! The layers of lines and areas.

use std::collections::HashMap;

use dobot_geometry::{Area, Stroke};

use super::color;
use super::ink::InkColor;
use crate::artwork::Layer;
use crate::clip::ClipArea;
use crate::hidden::{CoverPaint, Covers, Heights};
use crate::limits::{Budget, OverBudget};
use crate::options::LayersBy;
use crate::place::printable;

/// A sorter of lines and areas into layers, in the order of their first appearance.
#[derive(Debug)]
pub(crate) struct Layers {
    by: LayersBy,
    /// The current outermost group.
    group: Option<String>,
    /// The current line width, in hundredths of a millimetre; `None` for fills.
    width: Option<u32>,
    found: Vec<Layer>,
    places: HashMap<Key, usize>,
    /// The layer of the last line or area, which is most often that of the next one.
    last: Option<(Key, usize)>,
    covers: Covers,
    /// For each layer, the number of covers below its lines and areas.
    heights: Vec<Heights>,
}

impl Layers {
    pub(crate) fn new(by: LayersBy) -> Self {
        Self {
            by,
            group: None,
            width: None,
            found: Vec::new(),
            places: HashMap::new(),
            last: None,
            covers: Covers::default(),
            heights: Vec::new(),
        }
    }

    /// Starts an outermost group, or the part outside groups.
    pub(crate) fn enter(&mut self, group: Option<String>) {
        self.group = group;
        self.last = None;
    }

    /// Starts lines of a width on the page, or fills.
    pub(crate) fn draw_with(&mut self, width_mm: Option<f64>) {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "it saturates"
        )]
        let width = width_mm.map(|mm| (mm * 100.0).round() as u32);
        if self.width != width {
            self.width = width;
            self.last = None;
        }
    }

    pub(crate) fn stroke(&mut self, stroke: Stroke, color: InkColor) {
        let height = self.covers.count();
        let (layer, heights) = self.layer(color);
        layer.strokes.push(stroke);
        heights.strokes.push(height);
    }

    pub(crate) fn area(&mut self, area: Area, color: InkColor) {
        let height = self.covers.count();
        let (layer, heights) = self.layer(color);
        layer.areas.push(area);
        heights.areas.push(height);
    }

    /// Adds an area over everything before it, in any layer, and whether it hides that.
    pub(crate) fn cover(&mut self, area: ClipArea, paint: CoverPaint, hides: bool) {
        self.covers.put(area, paint, hides);
    }

    /// The areas painted before.
    pub(crate) const fn covers(&self) -> &Covers {
        &self.covers
    }

    /// The visible parts of each layer, and the number of lines and areas for which they are
    /// unknown. Unneeded areas are left out.
    pub(crate) fn finish(
        self,
        budget: &mut Budget,
        fills: bool,
    ) -> Result<(Vec<Layer>, usize), OverBudget> {
        self.covers
            .what_shows(self.found, &self.heights, fills, budget)
    }

    fn layer(&mut self, color: InkColor) -> (&mut Layer, &mut Heights) {
        let place = match &self.last {
            Some((key, place)) if key.still_takes(color) => *place,
            _ => self.find(color),
        };
        let layer = &mut self.found[place];
        if layer.color != color.0 {
            // A layer of several colours has no colour.
            layer.color = None;
        }
        (layer, &mut self.heights[place])
    }

    fn find(&mut self, color: InkColor) -> usize {
        let key = match self.by {
            LayersBy::Color => Key::Color(color),
            LayersBy::Group => Key::Group(self.group.clone()),
            LayersBy::Width => Key::Width(self.width),
            LayersBy::Nothing => Key::All,
        };
        let place = *self.places.entry(key.clone()).or_insert_with(|| {
            self.found.push(Layer {
                name: key.name(),
                color: color.0,
                ..Layer::default()
            });
            self.heights.push(Heights::default());
            self.found.len() - 1
        });
        self.last = Some((key, place));
        place
    }
}

#[derive(Clone, Debug, PartialEq, Eq, Hash)]
enum Key {
    Color(InkColor),
    /// The name of the group.
    Group(Option<String>),
    /// The line width, in hundredths of a millimetre.
    Width(Option<u32>),
    All,
}

impl Key {
    /// Whether this colour belongs to the last layer; another group or width leaves it.
    fn still_takes(&self, color: InkColor) -> bool {
        match self {
            Self::Color(of) => *of == color,
            Self::Group(_) | Self::Width(_) | Self::All => true,
        }
    }

    fn name(&self) -> String {
        match self {
            Self::Color(InkColor(Some(rgb))) => color::name(*rgb),
            Self::Color(InkColor(None)) => "pattern".to_owned(),
            Self::Group(Some(name)) => printable(name),
            Self::Group(None) => "outside groups".to_owned(),
            Self::Width(Some(width)) => format!("{} mm", f64::from(*width) / 100.0),
            Self::Width(None) => "fills".to_owned(),
            Self::All => "all".to_owned(),
        }
    }
}
