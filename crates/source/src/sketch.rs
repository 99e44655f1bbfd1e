//! What a reader has found so far: ink in layers, and what is drawn otherwise than the file says.

use std::collections::{HashMap, HashSet};

use dobot_geometry::{Area, CubicBez, ParamCurve, Point, Stroke, Vec2, bounds, chords};

use crate::artwork::{Artwork, Layer};
use crate::error::{LIMIT_MM, MAX_SEGMENTS};
use crate::error::{Place, SourceError, Warning};
use crate::options::ReadOptions;
use crate::svg::checked_tolerance_mm;

/// The drawing of a text file while it is being read. Places in the text are offsets in bytes, `at`.
#[derive(Debug)]
pub(super) struct Sketch<'a> {
    text: &'a [u8],
    tolerance_mm: f64,
    layers: Vec<Layer>,
    numbers: HashMap<String, usize>,
    /// The layer in use: an index into `layers` once there is one.
    current: usize,
    /// The last stroke of the layer may go on.
    goes_on: bool,
    segments_left: usize,
    /// The edges of areas, each with the layer that it belongs to.
    borders: Vec<(usize, Vec<Point>)>,
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
            goes_on: false,
            segments_left: MAX_SEGMENTS,
            borders: Vec::new(),
            warnings: Warnings::new(text),
        })
    }

    /// What follows belongs to the layer of that name, which begins as `layer` where it is new.
    pub(super) fn use_layer(&mut self, layer: Layer) -> Result<(), SourceError> {
        self.goes_on = false;
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

    /// The layer in use.
    pub(super) fn layer(&mut self) -> &mut Layer {
        if self.layers.is_empty() {
            self.numbers.insert(String::new(), 0);
            self.layers.push(Layer::default());
        }
        &mut self.layers[self.current]
    }

    /// The pen leaves the paper: the next line begins a stroke.
    pub(super) const fn lift(&mut self) {
        self.goes_on = false;
    }

    /// A straight line, joined to the one before where that ended here.
    pub(super) fn line(&mut self, from: Point, to: Point) -> Result<(), SourceError> {
        self.spend(1)?;
        let goes_on = self.goes_on;
        let strokes = &mut self.layer().strokes;
        match strokes.last_mut() {
            Some(stroke) if goes_on && stroke.last() == Some(from) => stroke.points.push(to),
            _ => strokes.push(Stroke::open(vec![from, to])),
        }
        self.goes_on = true;
        Ok(())
    }

    /// A dot, from which a line may go on.
    pub(super) fn dot(&mut self, at: Point) -> Result<(), SourceError> {
        self.spend(1)?;
        self.layer().strokes.push(Stroke::open(vec![at]));
        self.goes_on = true;
        Ok(())
    }

    /// Whether the ink of the stroke in hand ends there.
    pub(super) fn ends_at(&self, p: Point) -> bool {
        let last = self
            .layers
            .get(self.current)
            .and_then(|it| it.strokes.last());
        self.goes_on && last.and_then(Stroke::last) == Some(p)
    }

    /// A whole stroke.
    pub(super) fn stroke(&mut self, points: Vec<Point>) -> Result<(), SourceError> {
        self.spend(points.len())?;
        if !points.is_empty() {
            self.layer().strokes.push(Stroke::open(points));
        }
        self.goes_on = false;
        Ok(())
    }

    /// An area to be filled, whose edges are drawn; rings of fewer than three corners hold nothing.
    pub(super) fn area(&mut self, mut area: Area) -> Result<(), SourceError> {
        area.rings.retain(|ring| ring.len() > 2);
        // Once as an area, once as lines.
        self.spend(2 * area.rings.iter().map(Vec::len).sum::<usize>())?;
        if area.rings.is_empty() {
            return Ok(());
        }
        let layer = self.layer();
        layer.areas.push(area.clone());
        let number = self.current;
        let borders = area.rings.into_iter().map(|ring| (number, closed(ring)));
        self.borders.extend(borders);
        Ok(())
    }

    /// A part of a circle or ellipse as lines, joined to the one before where that ended at its
    /// start.
    pub(super) fn arc(&mut self, at: usize, arc: &Arc) -> Result<(), SourceError> {
        let points = self.arc_points(at, arc)?;
        points.windows(2).try_for_each(|it| self.line(it[0], it[1]))
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

    /// A curve of `chords` pieces, which is a whole number from 1 up, from 0 to 1. Its ends may lie
    /// within the limits and its middle beyond them, so each point is checked.
    fn curve_points(
        &self,
        at: usize,
        chords: f64,
        point: impl Fn(f64) -> Point,
    ) -> Result<Vec<Point>, SourceError> {
        // Before anything is stored; what is no number is refused too.
        #[expect(clippy::cast_precision_loss, reason = "a few millions")]
        let fits = chords <= self.segments_left as f64;
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
        let points = (0..=count).map(|i| point(f64::from(i) / chords));
        points.map(|p| self.check(at, p)).collect()
    }

    pub(super) const fn tolerance_mm(&self) -> f64 {
        self.tolerance_mm
    }

    pub(super) const fn warnings(&mut self) -> &mut Warnings<'a> {
        &mut self.warnings
    }

    /// Refuses points beyond any table, and those that are no numbers.
    pub(super) fn check(&self, at: usize, p: Point) -> Result<Point, SourceError> {
        checked(self.text, at, p)
    }

    pub(super) fn found(&self, at: usize, found: impl Into<String>, expected: &str) -> SourceError {
        found_at(self.text, at, found, expected)
    }

    /// Counts what will be kept.
    pub(super) fn spend(&mut self, segments: usize) -> Result<(), SourceError> {
        let limit = MAX_SEGMENTS;
        let left = self.segments_left.checked_sub(segments);
        self.segments_left = left.ok_or(SourceError::TooManySegments { limit })?;
        Ok(())
    }

    /// Draws the edges of areas that the file does not draw itself.
    fn draw_borders(&mut self) {
        if self.borders.is_empty() {
            return;
        }
        let strokes = self.layers.iter().flat_map(|it| &it.strokes);
        let mut drawn: HashSet<Vec<[i64; 2]>> = strokes.map(|it| corners(&it.points)).collect();
        for (layer, points) in std::mem::take(&mut self.borders) {
            if drawn.insert(corners(&points)) {
                self.layers[layer].strokes.push(Stroke::open(points));
            }
        }
    }

    /// The page: as large as the ink, whose upper left corner is its origin.
    pub(super) fn finish(
        mut self,
        y: Y,
        nothing: &str,
    ) -> Result<(Artwork, Vec<Warning>), SourceError> {
        self.draw_borders();
        self.layers.retain(|layer| !layer.is_empty());
        if self.layers.is_empty() {
            return Err(self.warnings.nothing_to_draw(nothing));
        }
        let mut artwork = Artwork {
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
        let strokes = artwork.layers.iter_mut().flat_map(|it| &mut it.strokes);
        strokes.for_each(close);
        [artwork.width_mm, artwork.height_mm] = [ink.width(), ink.height()];
        Ok((artwork, self.warnings.list))
    }
}

/// Where y points in a file.
#[derive(Clone, Copy, Debug)]
pub(super) enum Y {
    Up,
    Down,
}

/// A part of an ellipse, `center + across cos t + along sin t`; its size may drift on the way, so
/// that it ends where the file says.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arc {
    center: Point,
    across: Vec2,
    along: Vec2,
    from_rad: f64,
    sweep_rad: f64,
    /// How much larger it is at its end.
    growth: f64,
    start: Point,
    end: Point,
}

impl Arc {
    /// Counterclockwise where `sweep_rad` is above 0 and y points up.
    pub(super) fn circle(center: Point, radius: f64, from_rad: f64, sweep_rad: f64) -> Self {
        let across = Vec2::new(radius, 0.0);
        Self::ellipse(center, across, Vec2::new(0.0, radius), from_rad, sweep_rad)
    }

    pub(super) fn ellipse(
        center: Point,
        across: Vec2,
        along: Vec2,
        from_rad: f64,
        sweep_rad: f64,
    ) -> Self {
        let at = |t: f64| center + across * t.cos() + along * t.sin();
        let is_whole = sweep_rad.abs() >= std::f64::consts::TAU;
        let start = at(from_rad);
        Self {
            center,
            across,
            along,
            from_rad,
            sweep_rad,
            growth: 1.0,
            start,
            end: if is_whole {
                start
            } else {
                at(from_rad + sweep_rad)
            },
        }
    }

    /// About a center from a point by an angle to another point, which may be a little nearer or
    /// farther.
    pub(super) fn between(center: Point, start: Point, sweep_rad: f64, end: Point) -> Self {
        let out = start - center;
        let radius = out.length();
        Self {
            growth: end.distance(center) / radius,
            start,
            end,
            ..Self::circle(center, radius, out.atan2(), sweep_rad)
        }
    }

    fn at(&self, share: f64) -> Point {
        let (sin, cos) = (self.from_rad + self.sweep_rad * share).sin_cos();
        let size = 1.0 + (self.growth - 1.0) * share;
        self.center + (self.across * cos + self.along * sin) * size
    }

    /// How many chords stay within the tolerance, a whole number from 1 up.
    ///
    /// A chord over the angle `a` leaves its circle by `r (1 - cos(a / 2))`; an ellipse is a circle
    /// of its larger radius, flattened.
    fn chords(&self, tolerance: f64) -> f64 {
        let radius = self.across.length().max(self.along.length()) * self.growth.max(1.0);
        let share = (tolerance / (2.0 * radius)).sqrt().min(1.0);
        let most_rad = (4.0 * share.asin()).min(std::f64::consts::FRAC_PI_2);
        (self.sweep_rad.abs() / most_rad).ceil().max(1.0)
    }
}

/// What is drawn otherwise than the file says, each kind once.
#[derive(Debug)]
pub(super) struct Warnings<'a> {
    text: &'a [u8],
    list: Vec<Warning>,
    numbers: HashMap<String, usize>,
}

impl<'a> Warnings<'a> {
    pub(super) fn new(text: &'a [u8]) -> Self {
        Self {
            text,
            list: Vec::new(),
            numbers: HashMap::new(),
        }
    }

    /// Counts one more of `what`, which is in the singular.
    pub(super) fn add(&mut self, at: impl Into<Option<usize>>, what: &str, instead: &str) {
        if let Some(&number) = self.numbers.get(what) {
            self.list[number].count += 1;
            return;
        }
        self.numbers.insert(what.to_owned(), self.list.len());
        self.list.push(Warning {
            place: at.into().map(|at| place(self.text, at)),
            what: what.to_owned(),
            instead: instead.to_owned(),
            count: 1,
        });
    }

    fn nothing_to_draw(&self, nothing: &str) -> SourceError {
        let warnings = self.list.iter().map(Warning::to_string);
        let reasons: Vec<String> = [nothing.to_owned()].into_iter().chain(warnings).collect();
        SourceError::NothingToDraw {
            reason: reasons.join("; "),
        }
    }
}

/// Line and column of an offset into a text.
pub(super) fn place(text: &[u8], at: usize) -> Place {
    let before = &text[..at.min(text.len())];
    let lines = before.split(|&byte| byte == b'\n');
    let (count, last) = lines.fold((0, before), |(count, _), line| (count + 1, line));
    // The second and further bytes of a character are no columns.
    let columns = last.iter().filter(|&&byte| byte & 0xC0 != 0x80).count() + 1;
    let number = |count: usize| u32::try_from(count).unwrap_or(u32::MAX);
    Place {
        line: number(count),
        column: number(columns),
    }
}

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

pub(super) fn found_at(
    text: &[u8],
    at: usize,
    found: impl Into<String>,
    expected: &str,
) -> SourceError {
    SourceError::Found {
        place: place(text, at),
        found: found.into(),
        expected: expected.to_owned(),
    }
}

/// What stands in a text from there on, shortened, in quotes; its end where there is no more.
pub(super) fn excerpt(text: &[u8], at: usize) -> String {
    let rest = text.get(at..).unwrap_or_default();
    let line = rest.split(|byte| b"\r\n".contains(byte)).next();
    let line = line.unwrap_or_default();
    match (rest.is_empty(), line.is_empty()) {
        (true, _) => "the end of the file".to_owned(),
        (_, true) => "the end of the line".to_owned(),
        _ => format!("{:?}", shortened(&String::from_utf8_lossy(line))),
    }
}

pub(super) fn shortened(text: &str) -> String {
    match text.char_indices().nth(20) {
        Some((end, _)) => format!("{}..", &text[..end]),
        None => text.to_owned(),
    }
}

/// The decimal number without an exponent that a text begins with, and its length in bytes.
pub(super) fn decimal(text: &[u8]) -> Option<(f64, usize)> {
    let is_part = |(i, byte): &(usize, &u8)| match byte {
        b'0'..=b'9' | b'.' => true,
        b'+' | b'-' => *i == 0,
        _ => false,
    };
    let length = text.iter().enumerate().take_while(is_part).count();
    let digits = std::str::from_utf8(&text[..length]).ok()?;
    let number: f64 = digits.parse().ok()?;
    (number.abs() <= MAX_NUMBER).then_some((number, length))
}

fn closed(mut ring: Vec<Point>) -> Vec<Point> {
    if ring.first() != ring.last() {
        ring.extend(ring.first().copied());
    }
    ring
}

/// What two rings share that are the same, wherever they begin and whichever way they go.
fn corners(points: &[Point]) -> Vec<[i64; 2]> {
    #[expect(clippy::cast_possible_truncation, reason = "no farther than LIMIT_MM")]
    let rounded = |mm: f64| (mm / SAME_MM).round() as i64;
    let corners = points.iter().map(|p| [rounded(p.x), rounded(p.y)]);
    let mut corners: Vec<_> = corners.collect();
    corners.sort_unstable();
    corners.dedup();
    corners
}

/// A line that ends where it began may be drawn from anywhere.
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

/// Larger numbers are a mistake, and would overflow further on.
pub(super) const MAX_NUMBER: f64 = 1e9;
/// What sums of rounded ways may leave between two points that are the same.
pub(super) const SAME_MM: f64 = 1e-6;
/// No file has more pens, or speeds and powers.
const MAX_LAYERS: usize = 1000;
