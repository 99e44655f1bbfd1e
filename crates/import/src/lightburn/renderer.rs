//! The renderer of the shapes of a project.

use std::collections::BTreeSet;

use dobot_geometry::{Affine, Point};
use usvg::roxmltree::Node;

use super::TRUE;
use super::cut::{Cuts, Output};
use super::field::Field;
use super::fill::Fills;
use super::path::Lists;
use crate::error::SourceError;
use crate::limits::MAX_NUMBER;
use crate::place::{printable, shortened};
use crate::sketch::Sketch;

/// A renderer of shapes into a sketch.
#[derive(Debug)]
pub(super) struct ShapeRenderer<'s, 'a, 'd> {
    pub(super) file: &'d str,
    pub(super) sketch: &'s mut Sketch<'a>,
    pub(super) lists: Lists<'d>,
    cuts: Cuts,
    fills: Fills,
    /// The transform of the project: x may be mirrored.
    frame: Affine,
    /// The numbers of outermost shapes and of all shapes up to now.
    counts: [usize; 2],
    /// Shapes of layers with output off, and of tool layers.
    off: LeftOut,
    tools: LeftOut,
    /// The drawn layers.
    drawn: BTreeSet<u32>,
}

/// The context of a shape.
#[derive(Clone, Copy, Debug)]
struct Pose {
    frame: Affine,
    /// The layer, unless the shape has its own.
    cut: u32,
    /// The nesting depth of groups.
    depth: u32,
}

/// A line of a shape, and whether it is closed.
#[derive(Debug)]
pub(super) struct Contour {
    pub(super) points: Vec<Point>,
    pub(super) closed: bool,
}

impl<'s, 'a, 'd> ShapeRenderer<'s, 'a, 'd> {
    pub(super) fn new(
        file: &'d str,
        sketch: &'s mut Sketch<'a>,
        root: Node<'d, '_>,
        cuts: Cuts,
    ) -> Self {
        let is_mirrored = root.attribute("MirrorX") == Some(TRUE);
        let across = if is_mirrored { -1.0 } else { 1.0 };
        Self {
            file,
            sketch,
            lists: Lists::new(file, root),
            cuts,
            fills: Fills::default(),
            frame: Affine::scale_non_uniform(across, 1.0),
            counts: [0; 2],
            off: LeftOut::default(),
            tools: LeftOut::default(),
            drawn: BTreeSet::new(),
        }
    }

    /// Draws all shapes; layers are in the order in which a laser runs them.
    pub(super) fn all(&mut self, root: Node<'d, '_>) -> Result<(), SourceError> {
        for cut in self.cuts.in_order() {
            self.sketch.use_layer(cut.layer())?;
        }
        let pose = Pose {
            frame: self.frame,
            cut: 0,
            depth: 0,
        };
        for shape in shapes_in(root) {
            self.counts[0] += 1;
            self.sketch.check_cancelled()?;
            self.shape_or_mistake(shape, pose)?;
        }
        Ok(())
    }

    /// Fills areas and adds the warnings about what was left out.
    pub(super) fn finish(mut self) -> Result<(), SourceError> {
        self.fills.draw(self.sketch, &mut self.cuts)?;
        let off = "left out, because the output of its layer is off in LightBurn";
        self.off.warn(self.sketch, "switched-off shape", off);
        let tools = "left out, because LightBurn does not output tool layers";
        self.tools.warn(self.sketch, "tool-layer shape", tools);
        for cut in self.drawn {
            if let Some(at) = self.cuts.of(cut).at {
                let instead = "drawn without its speed, power, passes and kerf, which are for another laser; \
                     tool.laser MATERIAL has those of this one";
                self.sketch.warn(at, "laser layer", instead);
            }
        }
        Ok(())
    }

    /// Draws a shape; one with a mistake is reported and left out.
    fn shape_or_mistake(&mut self, shape: Node<'d, '_>, pose: Pose) -> Result<(), SourceError> {
        let drawn = self.shape(shape, pose);
        self.sketch.skip_mistake(drawn, "its shape is left out")
    }

    fn shape(&mut self, shape: Node<'d, '_>, pose: Pose) -> Result<(), SourceError> {
        let cut = Field::attribute(shape, "CutIndex").map(|field| field.count(self.file));
        let pose = Pose {
            cut: cut.transpose()?.unwrap_or(pose.cut),
            ..pose
        };
        let kind = shape.attribute("Type").unwrap_or_default();
        match kind {
            "Group" | "Component" => return self.group(shape, pose),
            "Bitmap" => {
                let instead = "left out; save it from LightBurn and draw it separately: dobot draw picture.png";
                self.left_out(shape, "picture", instead);
                return Ok(());
            }
            _ if !self.is_burned(shape, pose.cut) => return Ok(()),
            _ => {}
        }
        let frame = self.frame_of(shape, pose.frame)?;
        let contours = match kind {
            "Text" => return self.text(shape, pose),
            "Path" => self.path(shape, frame)?,
            "Rect" => self.rectangle(shape, frame)?,
            "Ellipse" => self.ellipse(shape, frame)?,
            "Polygon" => self.polygon(shape, frame)?,
            _ => {
                let kind = printable(&shortened(kind));
                let instead = format!(
                    "left out (the first is a {kind:?}); convert them to paths in LightBurn and save the project"
                );
                self.left_out(shape, "unsupported shape", &instead);
                return Ok(());
            }
        };
        self.draw(shape, pose.cut, contours)
    }

    fn group(&mut self, group: Node<'d, '_>, pose: Pose) -> Result<(), SourceError> {
        if pose.depth == MAX_DEPTH {
            let found = format!("groups nested more than {MAX_DEPTH} deep");
            let expected = "fewer; ungroup them in LightBurn";
            return Err(self.sketch.found(group.range().start, found, expected));
        }
        let pose = Pose {
            frame: self.frame_of(group, pose.frame)?,
            depth: pose.depth + 1,
            ..pose
        };
        let lists = group
            .children()
            .filter(|child| child.has_tag_name("Children"));
        for shape in lists.flat_map(shapes_in) {
            self.shape_or_mistake(shape, pose)?;
        }
        Ok(())
    }

    /// Draws a text by the outlines stored in the file, in project coordinates whatever group the
    /// text is in.
    fn text(&mut self, text: Node<'d, '_>, pose: Pose) -> Result<(), SourceError> {
        if let Some(outlines) = text
            .children()
            .find(|child| child.has_tag_name("BackupPath"))
        {
            let pose = Pose {
                frame: self.frame,
                // A text in the outlines of a text would recurse forever.
                depth: pose.depth + 1,
                ..pose
            };
            if pose.depth <= MAX_DEPTH {
                return self.shape(outlines, pose);
            }
        }
        let instead = "left out, because the project has no outlines of it; convert it to a path in LightBurn (Edit, Convert to Path) and save the project";
        self.left_out(text, "plain text", instead);
        Ok(())
    }

    /// Draws the lines of a shape, or keeps them until everything filled with them is known.
    fn draw(
        &mut self,
        shape: Node<'_, '_>,
        cut_index: u32,
        contours: Vec<Contour>,
    ) -> Result<(), SourceError> {
        self.counts[1] += 1;
        self.drawn.insert(cut_index);
        let at = shape.range().start;
        let cut = self.cuts.of(cut_index);
        if cut.at.is_none() {
            let instead = "drawn as lines, because the project has no settings of its layer";
            self.sketch.warn(at, "unlisted shape", instead);
        }
        if cut.output == Output::Hidden {
            let instead = "drawn, because its layer is output although LightBurn does not show it";
            self.sketch.warn(at, "hidden shape", instead);
        }
        self.sketch.use_layer(cut.layer())?;
        for Contour { points, closed } in contours {
            match cut.filling {
                Some(filling) if closed => {
                    self.sketch.spend(points.len())?;
                    self.fills.keep(cut_index, filling, self.counts, points);
                }
                Some(_) => {
                    let instead = "drawn as a line, because only closed shapes can be filled";
                    self.sketch.warn(at, "unclosed fill", instead);
                    self.sketch.stroke(points)?;
                }
                None => self.sketch.stroke(points)?,
            }
        }
        Ok(())
    }

    /// Whether a laser burns a layer; otherwise counts it.
    fn is_burned(&mut self, shape: Node<'_, '_>, cut: u32) -> bool {
        let cut = self.cuts.of(cut);
        let left_out = match cut.output {
            Output::On | Output::Hidden => return true,
            Output::Off => &mut self.off,
            Output::Tool => &mut self.tools,
        };
        left_out.note(shape.range().start, &cut.name);
        false
    }

    /// The transform from a shape to the project.
    fn frame_of(&self, shape: Node<'d, '_>, outer: Affine) -> Result<Affine, SourceError> {
        let Some(field) = Field::content(shape, "XForm") else {
            return Ok(outer);
        };
        let numbers = field.text.split_whitespace().map(|word| word.parse().ok());
        let numbers = numbers.map(|number| number.filter(|x: &f64| x.abs() <= MAX_NUMBER));
        // One more than allowed.
        let numbers: Option<Vec<f64>> = numbers.take(7).collect();
        let numbers = numbers.and_then(|number| <[f64; 6]>::try_from(number).ok());
        let numbers =
            numbers.ok_or_else(|| field.refused(self.file, "six numbers of at most 1e9"))?;
        Ok(outer * Affine::new(numbers))
    }

    pub(super) fn left_out(&mut self, shape: Node<'_, '_>, what: &str, instead: &str) {
        self.sketch.warn(shape.range().start, what, instead);
    }
}

/// Shapes left out because of their layers.
#[derive(Debug, Default)]
struct LeftOut {
    count: usize,
    /// The position of the first one, in bytes.
    first: usize,
    /// The names of the first few layers.
    layers: BTreeSet<String>,
}

impl LeftOut {
    fn note(&mut self, at: usize, layer: &str) {
        if self.count == 0 {
            self.first = at;
        }
        self.count += 1;
        if self.layers.len() < MAX_NAMES && !self.layers.contains(layer) {
            self.layers.insert(layer.to_owned());
        }
    }

    fn warn(&self, sketch: &mut Sketch<'_>, what: &str, instead: &str) {
        let names: Vec<&str> = self.layers.iter().map(String::as_str).collect();
        let instead = format!("{instead} ({})", names.join(", "));
        for _ in 0..self.count {
            sketch.warn(self.first, what, &instead);
        }
    }
}

fn shapes_in<'d, 'i>(parent: Node<'d, 'i>) -> impl Iterator<Item = Node<'d, 'i>> {
    parent
        .children()
        .filter(|child| child.has_tag_name("Shape"))
}

/// The largest nesting depth of groups.
const MAX_DEPTH: u32 = 100;
/// The number of layers that a warning names.
const MAX_NAMES: usize = 6;
