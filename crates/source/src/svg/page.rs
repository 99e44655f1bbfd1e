//! The page that fills: shapes come, layers of lines and areas result.

use std::collections::BTreeMap;
use std::rc::Rc;

use dobot_geometry::{Affine, Area, FillRule, Point, Rect, Stroke, bounds};

use super::clip::{self, Region};
use super::dash::dash;
use super::ink::{FillPaint, Ink, InkColor};
use super::layers::Layers;
use super::polygon::Polygons;
use super::warning_count::{WarningCount, WarningKind};
use crate::artwork::Artwork;
use crate::error::SvgError;
use crate::limits::LIMIT_MM;
use crate::limits::{Budget, MAX_SEGMENTS};
use crate::options::LayersBy;

/// Collects what shows on the page.
pub(crate) struct SvgPage {
    size_mm: [f64; 2],
    page: Region,
    page_bounds: Rect,
    /// How many segments may still come.
    pub(crate) budget: Budget,
    pub(crate) layers: Layers,
    warnings: BTreeMap<WarningKind, usize>,
}

impl SvgPage {
    pub(crate) fn new(size_mm: [f64; 2], by: LayersBy) -> Self {
        let [w, h] = size_mm;
        let corners = [(0.0, 0.0), (w, 0.0), (w, h), (0.0, h)].map(|(x, y)| Point::new(x, y));
        let outline = Stroke::open(corners.to_vec());
        let area = clip::ClipArea::new(&[outline], FillRule::NonZero, Vec::new());
        Self {
            size_mm,
            page: Region::new(vec![area]),
            page_bounds: bounds(corners),
            budget: Budget::new(MAX_SEGMENTS),
            layers: Layers::new(by),
            warnings: BTreeMap::new(),
        }
    }

    pub(crate) fn finish(self) -> (Artwork, Vec<WarningCount>) {
        let [width_mm, height_mm] = self.size_mm;
        let artwork = Artwork {
            width_mm,
            height_mm,
            layers: self.layers.finish(),
        };
        let warnings = self.warnings.into_iter();
        let warnings = warnings.map(|(kind, count)| WarningCount { kind, count });
        (artwork, warnings.collect())
    }

    pub(crate) fn warn(&mut self, kind: WarningKind, count: usize) {
        if count > 0 {
            *self.warnings.entry(kind).or_default() += count;
        }
    }

    /// Draws a shape: its fill first, its line upon it. The outlines lie in the shape's own units.
    pub(crate) fn shape(
        &mut self,
        outlines: Vec<Stroke>,
        transform: Affine,
        ink: &Ink,
        clips: &[Rc<Region>],
    ) -> Result<(), SvgError> {
        if let Some(fill) = ink.area() {
            self.fill(&outlines, transform, fill, clips)?;
        }
        let Some(color) = ink.outline() else {
            return Ok(());
        };
        for outline in outlines {
            for piece in self.dashes(outline, ink)? {
                if ink.has_ends() || has_length(&piece) {
                    self.stroke(piece, transform, color, clips)?;
                }
            }
        }
        Ok(())
    }

    fn dashes(&mut self, outline: Stroke, ink: &Ink) -> Result<Vec<Stroke>, SvgError> {
        match ink.line.as_ref().and_then(|line| line.dashes.as_ref()) {
            Some(it) => dash(outline, &it.lengths, it.offset, &mut self.budget),
            None => Ok(vec![outline]),
        }
    }

    /// Puts a stroke on the page, as far as it shows.
    fn stroke(
        &mut self,
        mut stroke: Stroke,
        transform: Affine,
        color: InkColor,
        clips: &[Rc<Region>],
    ) -> Result<(), SvgError> {
        if !has_length(&stroke) {
            stroke = Stroke::open(vec![stroke.points[0]]);
        }
        let ink = place(&mut stroke.points, transform)?;
        if self.is_on_page(ink) && clips.is_empty() {
            self.layers.stroke(stroke, color);
            return Ok(());
        }
        let mut pieces = self.page.cut(stroke, &mut self.budget)?;
        for clip in clips {
            let mut shown = Vec::new();
            for piece in pieces {
                shown.append(&mut clip.cut(piece, &mut self.budget)?);
            }
            pieces = shown;
        }
        for piece in pieces {
            self.layers.stroke(piece, color);
        }
        Ok(())
    }

    /// Puts a filled area on the page, as far as it shows.
    fn fill(
        &mut self,
        outlines: &[Stroke],
        transform: Affine,
        fill: FillPaint,
        clips: &[Rc<Region>],
    ) -> Result<(), SvgError> {
        let mut around = bounds([]);
        let mut rings = Vec::with_capacity(outlines.len());
        for outline in outlines {
            let mut ring = outline.points.clone();
            let ink = place(&mut ring, transform)?;
            around = around.union(ink);
            if ring.len() > 2 && ring.first() == ring.last() {
                ring.pop();
            }
            if ring.len() > 2 {
                rings.push(ring);
            }
        }
        if rings.is_empty() || around.width() <= 0.0 || around.height() <= 0.0 {
            return Ok(());
        }
        let area = Area {
            rings,
            rule: fill.rule,
        };
        match self.shown(area, around, clips) {
            Some(area) if !area.rings.is_empty() => self.layers.area(area, fill.color),
            Some(_) => {}
            None => self.warn(WarningKind::Entangled, 1),
        }
        Ok(())
    }

    /// The part of an area that shows; `None` where it is too entangled to tell.
    fn shown(&self, area: Area, bounds: Rect, clips: &[Rc<Region>]) -> Option<Area> {
        let page = (!self.is_on_page(bounds)).then_some(&self.page);
        let mut edges = page
            .into_iter()
            .chain(clips.iter().map(Rc::as_ref))
            .filter(|region| region.has_edge_in(bounds) || !region.shows(area.rings[0][0]))
            .peekable();
        if edges.peek().is_none() {
            return Some(area);
        }
        let whole = Polygons::new(&area.rings, area.rule);
        let shown = edges.try_fold(whole?, |shown, region| shown.and(region.polygons()?));
        Some(shown?.into_area())
    }

    fn is_on_page(&self, ink: Rect) -> bool {
        self.page_bounds.contains_rect(ink)
    }
}

fn has_length(line: &Stroke) -> bool {
    line.points.iter().any(|p| *p != line.points[0])
}

/// Moves points to where they lie on the page, and tells their bounds.
pub(crate) fn place(points: &mut [Point], transform: Affine) -> Result<Rect, SvgError> {
    let mut around = bounds([]);
    for p in points {
        *p = transform * *p;
        // What is no number passes no comparison.
        if !(p.x.abs().max(p.y.abs()) <= LIMIT_MM && (p.x + p.y).is_finite()) {
            return Err(SvgError::TooFar {
                x_mm: p.x,
                y_mm: p.y,
                limit_mm: LIMIT_MM,
            });
        }
        around = around.union_pt(*p);
    }
    Ok(around)
}
