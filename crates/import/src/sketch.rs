//! The drawing that a reader builds: ink in layers, and warnings.

use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::iter::repeat;
use std::rc::Rc;

use dobot_geometry::{
    Area, CubicBez, FillRule, ParamCurve, Point, Polygons, Stroke, bounds, chords,
};

use crate::arc::{Arc, SAME_MM};
use crate::artwork::{Artwork, Layer};
use crate::clip::{ClipArea, Region};
use crate::dash::{dash, fitted_dashes};
use crate::error::SourceError;
use crate::hidden::UNKNOWN;
use crate::limits::{Budget, LIMIT_MM, MAX_SEGMENTS, OverBudget, checked_tolerance_mm};
use crate::options::ReadOptions;
use crate::place::place;
use crate::stack::Stack;
use crate::warning::{Warning, Warnings};

/// The drawing of a text file while it is being read. Positions in the text (`at`) are offsets in
/// bytes.
#[derive(Debug)]
pub(super) struct Sketch<'a> {
    text: &'a [u8],
    tolerance_mm: f64,
    layers: Vec<Layer>,
    numbers: HashMap<String, usize>,
    /// The current layer: an index into `layers` if there is one.
    current: usize,
    /// Whether the last stroke of the layer may continue.
    continues: bool,
    budget: Budget,
    /// The edges of areas.
    borders: Vec<Border>,
    stack: Stack,
    /// Whether filled areas hide what is under them.
    hides: bool,
    /// Whether areas are needed if something is hidden.
    fills: bool,
    warnings: Warnings<'a>,
}

impl<'a> Sketch<'a> {
    pub(super) fn new(text: &'a [u8], options: &ReadOptions) -> Result<Self, SourceError> {
        Ok(Self {
            text,
            tolerance_mm: checked_tolerance_mm(options.tolerance_mm)?,
            layers: Vec::new(),
            numbers: HashMap::new(),
            current: 0,
            continues: false,
            budget: Budget::until(MAX_SEGMENTS, &options.cancel),
            borders: Vec::new(),
            stack: Stack::default(),
            hides: options.hides,
            fills: options.fills,
            warnings: Warnings::new(text),
        })
    }

    /// Selects the layer of this name; a new one starts as `layer`.
    pub(super) fn use_layer(&mut self, layer: Layer) -> Result<(), SourceError> {
        self.continues = false;
        if let Some(&number) = self.numbers.get(&layer.name) {
            self.current = number;
            return Ok(());
        }
        if self.layers.len() == MAX_LAYERS {
            return Err(SourceError::TooManyLayers { limit: MAX_LAYERS });
        }
        self.current = self.layers.len();
        self.numbers.insert(layer.name.clone(), self.current);
        self.layers.push(layer);
        Ok(())
    }

    /// The current layer.
    pub(super) fn layer(&mut self) -> &mut Layer {
        if self.layers.is_empty() {
            self.numbers.insert(String::new(), 0);
            self.layers.push(Layer::default());
        }
        &mut self.layers[self.current]
    }

    /// All layers, in the order of the source if it has one.
    #[cfg(test)]
    pub(super) fn layers(&self) -> &[Layer] {
        &self.layers
    }

    /// Lifts the pen: the next line starts a stroke.
    pub(super) const fn lift(&mut self) {
        self.continues = false;
    }

    /// Adds a straight line, joined to the previous one if that ended here.
    pub(super) fn line(&mut self, from: Point, to: Point) -> Result<(), SourceError> {
        if self.ends_at(from) {
            self.spend(1)?;
            if let Some(stroke) = self.layer().strokes.last_mut() {
                stroke.points.push(to);
            }
        } else {
            // As a stroke of two points does.
            self.spend(2)?;
            self.layer().strokes.push(Stroke::open(vec![from, to]));
        }
        self.continues = true;
        Ok(())
    }

    /// Adds a dot, from which a line may continue.
    pub(super) fn dot(&mut self, at: Point) -> Result<(), SourceError> {
        self.spend(1)?;
        self.layer().strokes.push(Stroke::open(vec![at]));
        self.continues = true;
        Ok(())
    }

    /// Whether the current stroke ends there.
    pub(super) fn ends_at(&self, p: Point) -> bool {
        let last = self
            .layers
            .get(self.current)
            .and_then(|layer| layer.strokes.last());
        self.continues && last.and_then(Stroke::last) == Some(p)
    }

    /// Adds a whole stroke.
    pub(super) fn stroke(&mut self, points: Vec<Point>) -> Result<(), SourceError> {
        self.spend(points.len())?;
        self.counted_stroke(points);
        Ok(())
    }

    /// Adds a whole stroke whose points were [counted](Self::spend) as they came.
    pub(super) fn counted_stroke(&mut self, points: Vec<Point>) {
        if !points.is_empty() {
            self.layer().strokes.push(Stroke::open(points));
        }
        self.continues = false;
    }

    /// Adds an area to be filled, whose edges are drawn; rings of fewer than three corners are
    /// empty.
    pub(super) fn area(&mut self, mut area: Area) -> Result<(), SourceError> {
        area.rings.retain(|ring| ring.len() > 2);
        // Once as an area, once as lines.
        self.spend(2 * area.rings.iter().map(Vec::len).sum::<usize>())?;
        if area.rings.is_empty() {
            return Ok(());
        }
        let layer = self.layer();
        layer.areas.push(area.clone());
        let (layer, height) = (self.current, self.stack.height());
        let border = |ring| Border {
            layer,
            height,
            points: closed(ring),
        };
        self.borders.extend(area.rings.into_iter().map(border));
        Ok(())
    }

    /// Whether filled areas hide what is under them.
    pub(super) const fn hides(&self) -> bool {
        self.hides
    }

    /// Hides everything drawn under this area, if hidden lines are removed.
    pub(super) fn cover(
        &mut self,
        rings: &[Vec<Point>],
        rule: FillRule,
    ) -> Result<(), SourceError> {
        let corners: usize = rings.iter().map(Vec::len).sum();
        if !self.hides || corners == 0 {
            return Ok(());
        }
        // It is kept both as it is and as clip polygons.
        self.spend(2 * corners)?;
        // A continued line would be partly under the area and partly above it.
        self.continues = false;
        self.stack.cover(&self.layers, rings, rule);
        Ok(())
    }

    /// Adds an elliptic arc as lines, joined to the previous one if that ended at its start.
    pub(super) fn arc(&mut self, at: usize, arc: &Arc) -> Result<(), SourceError> {
        let points = self.arc_points(at, arc)?;
        points
            .windows(2)
            .try_for_each(|pair| self.line(pair[0], pair[1]))
    }

    /// The corners of an arc, both ends included.
    pub(super) fn arc_points(&self, at: usize, arc: &Arc) -> Result<Vec<Point>, SourceError> {
        let chords = arc.chords(self.tolerance_mm);
        let mut points = self.curve_points(at, chords, |t| arc.at(t))?;
        if let [first, .., last] = points.as_mut_slice() {
            (*first, *last) = (arc.start, arc.end);
        }
        Ok(points)
    }

    /// The corners of a cubic curve, both ends included.
    pub(super) fn cubic_points(
        &self,
        at: usize,
        curve: CubicBez,
    ) -> Result<Vec<Point>, SourceError> {
        self.curve_points(at, chords(curve, self.tolerance_mm), |t| curve.eval(t))
    }

    /// Adds a curve of `chords` pieces (a whole number from 1) over the parameter 0 to 1. Its ends
    /// may be within the limits and its middle beyond them, so each point is checked.
    fn curve_points(
        &self,
        at: usize,
        chords: f64,
        point: impl Fn(f64) -> Point,
    ) -> Result<Vec<Point>, SourceError> {
        // Before anything is stored; NaN is refused too.
        #[expect(clippy::cast_precision_loss, reason = "a few millions")]
        let fits = chords <= self.budget.left() as f64;
        if !fits {
            let limit = MAX_SEGMENTS;
            return Err(SourceError::TooManySegments { limit });
        }
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a whole number from 1 to what is left"
        )]
        let count = chords as u32;
        self.note_curve(count as usize);
        let points = (0..=count).map(|i| point(f64::from(i) / chords));
        points.map(|p| self.check(at, p)).collect()
    }

    /// Checks that reading was not cancelled, for readers of much that leaves no ink.
    pub(super) fn check_cancelled(&mut self) -> Result<(), SourceError> {
        Ok(self.budget.spend(0)?)
    }

    pub(super) const fn tolerance_mm(&self) -> f64 {
        self.tolerance_mm
    }

    /// Counts one more of `what`, which is in the singular.
    pub(super) fn warn(&mut self, at: impl Into<Option<usize>>, what: &str, instead: &str) {
        self.warnings.add(at, what, instead);
    }

    /// Reports a mistake in the source, for which the drawing lacks what `instead` states. Returns
    /// other errors.
    pub(super) fn skip_mistake(
        &mut self,
        read: Result<(), SourceError>,
        instead: &str,
    ) -> Result<(), SourceError> {
        read.or_else(|error| self.warnings.add_mistake(error, instead))
    }

    pub(super) const fn warnings(&mut self) -> &mut Warnings<'a> {
        &mut self.warnings
    }

    /// A mark in the drawing: everything after it can be [clipped](Self::cut_since).
    pub(super) fn mark(&self) -> SketchMark {
        let counts = |layer: &Layer| [layer.strokes.len(), layer.areas.len()];
        SketchMark {
            layers: self.layers.iter().map(counts).collect(),
            borders: self.borders.len(),
            height: self.stack.height(),
        }
    }

    /// Cuts the lines since a mark into dashes, if they are longer than one period and the dashes
    /// are large enough to be visible.
    pub(super) fn dash_since(
        &mut self,
        mark: &SketchMark,
        lengths: &[f64],
        offset: f64,
    ) -> Result<(), SourceError> {
        let period: f64 = lengths.iter().sum();
        self.change_since(mark, |stroke, budget| {
            let turns = stroke.length_mm() / period;
            if (1.0..MAX_DASHES).contains(&turns) {
                dash(stroke, lengths, offset, budget)
            } else {
                Ok(vec![stroke])
            }
        })
    }

    /// Cuts the lines since a mark into dashes with whole periods per straight line, which starts
    /// and ends with half of the first dash. Lines with invisibly short periods are drawn whole.
    pub(super) fn fit_dashes_since(
        &mut self,
        mark: &SketchMark,
        lengths: &[f64],
    ) -> Result<(), SourceError> {
        self.change_since(mark, |stroke, budget| {
            fitted_dashes(stroke, lengths, [MIN_TURN_MM, MAX_DASHES], budget)
        })
    }

    /// Replaces the lines since a mark.
    fn change_since(
        &mut self,
        mark: &SketchMark,
        mut change: impl FnMut(Stroke, &mut Budget) -> Result<Vec<Stroke>, OverBudget>,
    ) -> Result<(), SourceError> {
        self.continues = false;
        self.stack.note(&self.layers);
        let from = mark.layers.iter().copied().chain(repeat([0, 0]));
        let layers = self.layers.iter_mut().zip(&mut self.stack.heights);
        for ((layer, heights), [strokes, _]) in layers.zip(from) {
            let of_strokes = heights.strokes.split_off(strokes);
            for (stroke, height) in layer.strokes.split_off(strokes).into_iter().zip(of_strokes) {
                let mut pieces = change(stroke, &mut self.budget)?;
                let count = heights.strokes.len() + pieces.len();
                heights.strokes.resize(count, height);
                layer.strokes.append(&mut pieces);
            }
        }
        Ok(())
    }

    /// Clips everything since a mark to the inside of a ring.
    pub(super) fn cut_since(
        &mut self,
        mark: &SketchMark,
        ring: Vec<Point>,
    ) -> Result<(), SourceError> {
        let outline = Stroke::open(ring);
        let inside = ClipArea::new(&[outline], FillRule::NonZero, Vec::new());
        let inside = Rc::new(Region::new(vec![inside]));
        self.stack.note(&self.layers);
        self.stack.clip_since(mark.height, &inside);
        self.change_since(mark, |stroke, budget| inside.cut(stroke, budget))?;
        let from = mark.layers.iter().copied().chain(repeat([0, 0]));
        let layers = self.layers.iter_mut().zip(&mut self.stack.heights);
        for ((layer, heights), [_, areas]) in layers.zip(from) {
            let of_areas = heights.areas.split_off(areas);
            for (area, height) in layer.areas.split_off(areas).into_iter().zip(of_areas) {
                let cut = Polygons::new(&area.rings, area.rule)
                    .and_then(|polygon| polygon.intersection(inside.polygons()?))
                    .map(Polygons::into_area);
                match cut {
                    Some(cut) if cut.rings.is_empty() => {}
                    Some(cut) => {
                        layer.areas.push(cut);
                        heights.areas.push(height);
                    }
                    None => self.warnings.add(
                        None,
                        "filled shape",
                        "not hatched, because it crosses itself too often",
                    ),
                }
            }
        }
        for border in self.borders.split_off(mark.borders) {
            let pieces = inside.cut(Stroke::open(border.points), &mut self.budget)?;
            let piece = |stroke: Stroke| Border {
                points: stroke.points,
                ..border
            };
            self.borders.extend(pieces.into_iter().map(piece));
        }
        Ok(())
    }

    /// The parts of lines inside an area, each a separate stroke.
    pub(super) fn lines_within(
        &mut self,
        area: &Area,
        lines: impl Iterator<Item = [Point; 2]>,
    ) -> Result<(), SourceError> {
        let rings: Vec<Stroke> = area.rings.iter().cloned().map(Stroke::open).collect();
        let inside = Region::new(vec![ClipArea::new(&rings, area.rule, Vec::new())]);
        for [from, to] in lines {
            let line = if from == to {
                vec![from]
            } else {
                vec![from, to]
            };
            for piece in inside.cut(Stroke::open(line), &mut self.budget)? {
                self.stroke(piece.points)?;
            }
        }
        Ok(())
    }

    /// Refuses points that are too far away or not numbers.
    pub(super) fn check(&self, at: usize, p: Point) -> Result<Point, SourceError> {
        checked(self.text, at, p)
    }

    pub(super) fn found(&self, at: usize, found: impl Into<String>, expected: &str) -> SourceError {
        SourceError::found(self.text, at, found, expected)
    }

    /// Notes that this number of segments comes from a curve.
    pub(super) fn note_curve(&self, segments: usize) {
        self.budget.note_curve(segments);
    }

    /// Spends segments from the budget.
    pub(super) fn spend(&mut self, segments: usize) -> Result<(), SourceError> {
        Ok(self.budget.spend(segments)?)
    }

    /// Draws the edges of areas that the file does not draw itself. An edge that it draws is at the
    /// height of its area.
    fn draw_borders(&mut self) {
        if self.borders.is_empty() {
            return;
        }
        self.stack.note(&self.layers);
        let mut drawn = self.strokes_by_corners();
        for border in std::mem::take(&mut self.borders) {
            match drawn.entry(corners(&border.points)) {
                Entry::Occupied(place) => {
                    let [layer, i] = *place.get();
                    let height = &mut self.stack.heights[layer].strokes[i];
                    *height = border.height.max(*height);
                }
                Entry::Vacant(place) => {
                    let strokes = &mut self.layers[border.layer].strokes;
                    place.insert([border.layer, strokes.len()]);
                    strokes.push(Stroke::open(border.points));
                    let heights = &mut self.stack.heights[border.layer];
                    heights.strokes.push(border.height);
                }
            }
        }
    }

    /// The layer and the index of the first stroke with these corners.
    fn strokes_by_corners(&self) -> HashMap<Vec<[i64; 2]>, [usize; 2]> {
        let mut drawn = HashMap::new();
        for (number, layer) in self.layers.iter().enumerate() {
            for (i, stroke) in layer.strokes.iter().enumerate() {
                drawn.entry(corners(&stroke.points)).or_insert([number, i]);
            }
        }
        drawn
    }

    /// Removes what is under the hiding areas.
    fn hide(&mut self) -> Result<(), SourceError> {
        let (stack, layers) = (
            std::mem::take(&mut self.stack),
            std::mem::take(&mut self.layers),
        );
        let (layers, unknown) = stack.what_shows(layers, self.fills, &mut self.budget)?;
        self.layers = layers;
        let (what, instead) = UNKNOWN;
        (0..unknown).for_each(|_| self.warn(None, what, instead));
        Ok(())
    }

    /// The page: as large as the ink, whose upper left corner is its origin.
    pub(super) fn finish(
        mut self,
        y: Y,
        nothing: &str,
    ) -> Result<(Artwork, Vec<Warning>), SourceError> {
        self.draw_borders();
        self.hide()?;
        self.layers.retain(|layer| !layer.is_empty());
        if self.layers.is_empty() {
            if let Some(mistake) = self.warnings.take_mistake() {
                return Err(mistake);
            }
            let warnings = self.warnings.into_list();
            let warnings = warnings.iter().map(Warning::to_string);
            let reasons = [nothing.to_owned()].into_iter().chain(warnings);
            return Err(SourceError::nothing_to_draw(reasons));
        }
        let mut artwork = Artwork {
            is_exact: !self.budget.has_curves(),
            layers: self.layers,
            ..Artwork::default()
        };
        let ink = bounds(artwork.points());
        let place = |p: &mut Point| match y {
            Y::Down => *p -= ink.origin().to_vec2(),
            Y::Up => *p = Point::new(p.x - ink.x0, ink.y1 - p.y),
        };
        let points = artwork.layers.iter_mut().flat_map(Layer::points_mut);
        points.for_each(place);
        let strokes = artwork
            .layers
            .iter_mut()
            .flat_map(|layer| &mut layer.strokes);
        strokes.for_each(close);
        [artwork.width_mm, artwork.height_mm] = [ink.width(), ink.height()];
        Ok((artwork, self.warnings.into_list()))
    }
}

/// The size of a sketch at a moment.
#[derive(Debug)]
pub(super) struct SketchMark {
    /// The numbers of strokes and areas of each layer.
    layers: Vec<[usize; 2]>,
    borders: usize,
    /// The number of hiding areas.
    height: u32,
}

/// A line with more periods of dashes is drawn whole.
const MAX_DASHES: f64 = 2000.0;
/// A pattern with a shorter period is drawn whole, in mm.
const MIN_TURN_MM: f64 = 0.5;

/// The edge of an area.
#[derive(Debug)]
struct Border {
    /// Its layer.
    layer: usize,
    /// The number of hiding areas below it.
    height: u32,
    points: Vec<Point>,
}

/// The direction of y in a file.
#[derive(Clone, Copy, Debug)]
pub(super) enum Y {
    Up,
    Down,
}

/// Refuses points that are too far away or not numbers.
pub(super) fn checked(text: &[u8], at: usize, p: Point) -> Result<Point, SourceError> {
    if p.x.abs() <= LIMIT_MM && p.y.abs() <= LIMIT_MM {
        return Ok(p);
    }
    Err(SourceError::TooFar {
        place: place(text, at),
        x_mm: p.x,
        y_mm: p.y,
        limit_mm: LIMIT_MM,
    })
}

fn closed(mut ring: Vec<Point>) -> Vec<Point> {
    if ring.first() != ring.last() {
        ring.extend(ring.first().copied());
    }
    ring
}

/// The corners of a ring in canonical order: equal rings have the same, whatever their start and
/// direction.
fn corners(points: &[Point]) -> Vec<[i64; 2]> {
    #[expect(clippy::cast_possible_truncation, reason = "no farther than LIMIT_MM")]
    let rounded = |mm: f64| (mm / SAME_MM).round() as i64;
    let corners = points.iter().map(|p| [rounded(p.x), rounded(p.y)]);
    let mut corners: Vec<_> = corners.collect();
    corners.sort_unstable();
    corners.dedup();
    corners
}

/// A closed line may be drawn from any point.
fn close(stroke: &mut Stroke) {
    let [first, .., last] = stroke.points.as_mut_slice() else {
        return;
    };
    if first.distance(*last) < SAME_MM {
        *last = *first;
        stroke.closed = stroke.points.len() > 2;
        if !stroke.closed {
            stroke.points.pop();
        }
    }
}

/// What the drawing lacks if a mistake ends it.
pub(super) const REST_LEFT_OUT: &str = "the rest of the file is left out";
/// The largest number of layers: pens, or speeds and powers.
const MAX_LAYERS: usize = 1000;
