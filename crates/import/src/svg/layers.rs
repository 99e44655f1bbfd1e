//! The layers of lines and areas.

use std::collections::HashMap;

use dobot_geometry::{Area, Stroke};

use super::color;
use super::ink::InkColor;
use super::layer_code::LayerControl;
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
    /// The current largest speed, in mm/s.
    speed_mm_s: Option<f64>,
    /// The number of pauses so far: a layer ends at each.
    pauses: u32,
    /// The label of the group before which the arm pauses, until something is drawn after it.
    pause: Option<String>,
    found: Vec<Layer>,
    places: HashMap<(Key, Manner), usize>,
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
            speed_mm_s: None,
            pauses: 0,
            pause: None,
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

    pub(crate) const fn speed_mm_s(&self) -> Option<f64> {
        self.speed_mm_s
    }

    /// Starts lines and areas with this largest speed, in mm/s.
    pub(crate) fn draw_at(&mut self, speed_mm_s: Option<f64>) {
        self.speed_mm_s = speed_mm_s;
        self.last = None;
    }

    /// Starts a group whose label says how it is drawn.
    pub(crate) fn draw_as(&mut self, control: &LayerControl) {
        self.draw_at(control.speed_mm_s);
        if control.pause.is_some() {
            self.pauses += 1;
            self.pause.clone_from(&control.pause);
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
        let manner = Manner {
            speed_bits: self.speed_mm_s.map(f64::to_bits),
            pauses: self.pauses,
        };
        let place = *self.places.entry((key.clone(), manner)).or_insert_with(|| {
            self.found.push(Layer {
                name: key.name(),
                color: color.0,
                speed_mm_s: self.speed_mm_s,
                pause: self.pause.take(),
                ..Layer::default()
            });
            self.heights.push(Heights::default());
            self.found.len() - 1
        });
        self.last = Some((key, place));
        place
    }
}

/// How a layer is drawn: its speed, and the number of pauses before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
struct Manner {
    speed_bits: Option<u64>,
    pauses: u32,
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
