//! Artwork: lines and areas in layers on a page.

use dobot_geometry::{Area, Point, Stroke, Vec2};

/// A page with layers of lines and areas: x to the right, y down, in millimetres.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Artwork {
    /// The page's width in millimetres; that of the ink if the file has no page.
    pub width_mm: f64,
    /// The page's height in millimetres.
    pub height_mm: f64,
    /// Whether the file defines a page.
    pub has_page: bool,
    /// Whether it is the same at any tolerance, because it has no curves; `false` if that is unknown.
    pub is_exact: bool,
    /// The layers in the order of the file; each becomes a separate pass.
    pub layers: Vec<Layer>,
}

impl Artwork {
    /// The corners of all lines and areas.
    pub fn points(&self) -> impl Iterator<Item = Point> {
        self.layers.iter().flat_map(Layer::points)
    }

    /// The artwork moved by an offset on its page.
    #[must_use]
    pub fn moved(mut self, way: Vec2) -> Self {
        let points = self.layers.iter_mut().flat_map(Layer::points_mut);
        points.for_each(|p| *p += way);
        self
    }

    /// The artwork with its page, scaled by a factor.
    #[must_use]
    pub fn scaled(mut self, factor: f64) -> Self {
        let points = self.layers.iter_mut().flat_map(Layer::points_mut);
        points.for_each(|p| *p = (p.to_vec2() * factor).to_point());
        Self {
            width_mm: self.width_mm * factor,
            height_mm: self.height_mm * factor,
            ..self
        }
    }

    /// Adds the content of another page. Layers of the same name, colour and speed are merged, unless
    /// there is a pause between them.
    pub fn add(&mut self, other: Self) {
        for mut layer in other.layers {
            let paused = self.layers.iter().rposition(|layer| layer.pause.is_some());
            let same = |existing: &&mut Layer| {
                let pen = |layer: &Layer| (layer.color, layer.speed_mm_s, layer.is_burned);
                existing.name == layer.name && pen(existing) == pen(&layer)
            };
            let since = self.layers.iter_mut().skip(paused.unwrap_or_default());
            match since.filter(|_| layer.pause.is_none()).find(same) {
                Some(same) => {
                    same.strokes.append(&mut layer.strokes);
                    same.areas.append(&mut layer.areas);
                }
                None => self.layers.push(layer),
            }
        }
    }
}

/// The lines and areas drawn with one pen, or burned with one speed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Layer {
    /// The name: the label of a group, the name of a colour, the number of a pen.
    pub name: String,
    /// The colour (red, green, blue), if the file specifies one.
    pub color: Option<[u8; 3]>,
    /// The speed in mm/s, if the file specifies one (F of G-code, VS of HP-GL,
    /// +S of `AxiDraw`).
    pub speed_mm_s: Option<f64>,
    /// Whether the speed is that of a laser.
    pub is_burned: bool,
    /// The label of the group before which the arm pauses for a person (! of `AxiDraw`).
    pub pause: Option<String>,
    /// The lines to draw.
    pub strokes: Vec<Stroke>,
    /// The areas to fill; hatching converts them to lines.
    pub areas: Vec<Area>,
}

impl Layer {
    /// Whether the layer is empty.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.strokes.is_empty() && self.areas.is_empty()
    }

    /// The corners of its lines and areas.
    pub fn points(&self) -> impl Iterator<Item = Point> {
        let lines = self
            .strokes
            .iter()
            .flat_map(|stroke| stroke.points.iter().copied());
        let areas = self
            .areas
            .iter()
            .flat_map(|area| area.rings.iter().flatten().copied());
        lines.chain(areas)
    }

    /// Mutable references to the corners of its lines and areas.
    pub fn points_mut(&mut self) -> impl Iterator<Item = &mut Point> {
        let lines = self
            .strokes
            .iter_mut()
            .flat_map(|stroke| &mut stroke.points);
        lines.chain(
            self.areas
                .iter_mut()
                .flat_map(|area| area.rings.iter_mut().flatten()),
        )
    }
}
