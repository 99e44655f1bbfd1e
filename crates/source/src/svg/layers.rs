//! Which lines and areas belong together.

use std::collections::HashMap;

use dobot_geometry::{Area, Stroke};

use super::color;
use super::ink::InkColor;
use crate::artwork::Layer;
use crate::options::LayersBy;
use crate::place::printable;

/// Sorts lines and areas into layers, in the order in which each first appears.
#[derive(Debug)]
pub(crate) struct Layers {
    by: LayersBy,
    /// The outermost group that is being read.
    group: Option<String>,
    found: Vec<Layer>,
    places: HashMap<Key, usize>,
    /// Where the last line or area went, which is most often where the next one goes.
    last: Option<(Key, usize)>,
}

impl Layers {
    pub(crate) fn new(by: LayersBy) -> Self {
        Self {
            by,
            group: None,
            found: Vec::new(),
            places: HashMap::new(),
            last: None,
        }
    }

    /// All that comes belongs to this outermost group, or to none.
    pub(crate) fn enter(&mut self, group: Option<String>) {
        self.group = group;
        self.last = None;
    }

    pub(crate) fn stroke(&mut self, stroke: Stroke, color: InkColor) {
        self.layer(color).strokes.push(stroke);
    }

    pub(crate) fn area(&mut self, area: Area, color: InkColor) {
        self.layer(color).areas.push(area);
    }

    pub(crate) fn finish(self) -> Vec<Layer> {
        self.found
    }

    fn layer(&mut self, color: InkColor) -> &mut Layer {
        let place = match &self.last {
            Some((key, place)) if key.still_takes(color) => *place,
            _ => self.find(color),
        };
        let layer = &mut self.found[place];
        if layer.color != color.0 {
            // What holds several colours has none.
            layer.color = None;
        }
        layer
    }

    fn find(&mut self, color: InkColor) -> usize {
        let key = match self.by {
            LayersBy::Color => Key::Color(color),
            LayersBy::Group => Key::Group(self.group.clone()),
            LayersBy::Nothing => Key::All,
        };
        let place = *self.places.entry(key.clone()).or_insert_with(|| {
            self.found.push(Layer {
                name: key.name(),
                color: color.0,
                ..Layer::default()
            });
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
    All,
}

impl Key {
    /// Whether this colour goes where the last one went; a group is left by entering another.
    fn still_takes(&self, color: InkColor) -> bool {
        match self {
            Self::Color(of) => *of == color,
            Self::Group(_) | Self::All => true,
        }
    }

    fn name(&self) -> String {
        match self {
            Self::Color(InkColor(Some(rgb))) => color::name(*rgb),
            Self::Color(InkColor(None)) => "pattern".to_owned(),
            Self::Group(Some(name)) => printable(name),
            Self::Group(None) => "outside groups".to_owned(),
            Self::All => "all".to_owned(),
        }
    }
}
