//! The page under construction: shapes in, layers of lines and areas out.

use std::collections::BTreeMap;
use std::rc::Rc;

use dobot_geometry::{Affine, Area, CancelToken, FillRule, Point, Polygons, Rect, Stroke, bounds};

use super::ink::{DashLength, FillPaint, Ink, InkColor, LinePaint, PAPER};
use super::layers::Layers;
use super::renderer::MM_PER_PX;
use super::warning_count::{WarningCount, WarningKind};
use crate::artwork::Artwork;
use crate::clip::{ClipArea, Region};
use crate::dash::dash;
use crate::error::SvgError;
use crate::hidden::CoverPaint;
use crate::limits::LIMIT_MM;
use crate::limits::{Budget, MAX_SEGMENTS, OverBudget};
use crate::options::ReadOptions;
use crate::warning::Warning;

/// A collector of everything visible on the page.
#[expect(clippy::struct_excessive_bools, reason = "each is asked for by itself")]
pub(crate) struct SvgPage {
    size_mm: [f64; 2],
    /// The clip edge; `None` without clipping.
    edge: Option<PageEdge>,
    /// The length and the number of lines clipped at the edge.
    cut_mm: f64,
    cut_lines: usize,
    pub(crate) work: ClipWork,
    /// The work for what is under white shapes, which is limited by itself.
    white_work: ClipWork,
    pub(crate) layers: Layers,
    /// Whether filled shapes hide what is under them.
    pub(crate) hides: bool,
    /// Whether the edges of white shapes on darker ones are drawn.
    draws_white_edges: bool,
    /// Whether the darker shapes under white ones are needed.
    pub(crate) tracks_fills: bool,
    fills: bool,
    warnings: BTreeMap<WarningKind, usize>,
}

impl SvgPage {
    pub(crate) fn new(size_mm: [f64; 2], options: &ReadOptions) -> Self {
        let by = options.layers;
        Self {
            size_mm,
            edge: options.crops.then(|| PageEdge::new(size_mm)),
            cut_mm: 0.0,
            cut_lines: 0,
            work: ClipWork::until(&options.cancel),
            white_work: ClipWork::until(&options.cancel),
            layers: Layers::new(by),
            hides: options.hides,
            draws_white_edges: options.hides || options.white_edges,
            tracks_fills: options.hides,
            fills: options.fills,
            warnings: BTreeMap::new(),
        }
    }

    /// The warning about lines clipped at the edge of the page.
    pub(crate) fn cut(&self) -> Option<Warning> {
        let instead = format!(
            "{:.1} mm beyond the edge of the page left out; draw them with what.no_crop",
            self.cut_mm.max(0.1)
        );
        let count = self.cut_lines;
        (count > 0).then(|| Warning::new("cut line", &instead, count))
    }

    pub(crate) fn finish(mut self) -> Result<(Artwork, Vec<WarningCount>), SvgError> {
        let [width_mm, height_mm] = self.size_mm;
        let (layers, entangled) = self.layers.finish(&mut self.work.budget, self.fills)?;
        let artwork = Artwork {
            width_mm,
            height_mm,
            has_page: true,
            is_exact: !self.work.budget.has_curves(),
            layers,
        };
        if entangled > 0 {
            self.warnings.insert(WarningKind::Stacked, entangled);
        }
        let warnings = self.warnings.into_iter();
        let warnings = warnings.map(|(kind, count)| WarningCount { kind, count });
        Ok((artwork, warnings.collect()))
    }

    /// Spends corners of clipped areas; `false` if there are too few.
    pub(super) fn take_corners(&mut self, corners: usize) -> bool {
        let left = self.work.corners_left.checked_sub(corners);
        self.work.corners_left = left.unwrap_or_default();
        left.is_some()
    }

    pub(crate) fn warn(&mut self, kind: WarningKind, count: usize) {
        if count > 0 {
            *self.warnings.entry(kind).or_default() += count;
        }
    }

    /// Draws a shape: its fill first, then its line. The outlines are in the shape's units.
    pub(crate) fn shape(
        &mut self,
        mut outlines: Vec<Stroke>,
        transform: Affine,
        ink: &Ink,
        clips: &[Rc<Region>],
    ) -> Result<(), SvgError> {
        let darker = self.darker_under(&outlines, transform, ink, clips)?;
        if let Some(fill) = ink.fill {
            self.cover(&outlines, transform, fill, clips)?;
        }
        self.layers.draw_with(None);
        self.white_edges(darker)?;
        let Some(color) = ink.outline() else {
            return Ok(());
        };
        let mut cut = None;
        if let Some(fill) = ink.area() {
            cut = self.fill(&outlines, transform, fill, clips)?;
        }
        if let Some(CutArea { edges, whole }) = cut {
            if ink.line.is_none() {
                return edges
                    .into_iter()
                    .try_for_each(|edge| self.on_page(edge, color));
            }
            let color = ink.area().map_or(color, |fill| fill.color);
            for edge in beside_outline(&edges, &whole) {
                self.on_page(edge, color)?;
            }
        } else if ink.line.is_none() {
            outlines.retain(has_area);
            outlines.iter_mut().for_each(close);
        }
        let width_mm = ink.line.as_ref().and_then(|line| width_mm(line, transform));
        self.layers.draw_with(width_mm);
        let whole = outlines.iter().map(Stroke::length_mm).sum();
        for outline in outlines {
            let (pieces, transform) = self.dashes(outline, whole, transform, ink)?;
            for piece in pieces {
                if ink.has_ends() || has_length(&piece) {
                    self.stroke(piece, transform, color, clips)?;
                }
            }
        }
        Ok(())
    }

    /// The parts of the edge of a white fill that lie on something darker, with its colour.
    fn darker_under(
        &mut self,
        outlines: &[Stroke],
        transform: Affine,
        ink: &Ink,
        clips: &[Rc<Region>],
    ) -> Result<Vec<(InkColor, Stroke)>, SvgError> {
        let fill = ink
            .fill
            .filter(|fill| self.tracks_fills && fill.color.0 == Some(PAPER));
        let Some(fill) = fill else {
            return Ok(Vec::new());
        };
        let work = &mut self.white_work;
        let filled = match FilledArea::new(outlines, transform, fill.rule, clips, work) {
            Ok(Some(filled)) => filled,
            Ok(None) => return Ok(Vec::new()),
            // What is drawn has limits of its own.
            Err(_) => {
                self.stop_tracking()?;
                return Ok(Vec::new());
            }
        };
        let shown = filled.shown.unwrap_or_else(|| filled.whole.clone());
        let mut edges = outlines_of(shown);
        if ink.line.is_some() {
            edges = beside_outline(&edges, &filled.whole);
        }
        let mut darker = Vec::new();
        for edge in edges {
            let covers = self.layers.covers();
            let parts = covers.darker_under(&edge, &mut self.white_work.budget);
            let Ok(Some(parts)) = parts else {
                self.stop_tracking()?;
                break;
            };
            darker.extend(
                parts
                    .into_iter()
                    .map(|(color, part)| (InkColor(color), part)),
            );
        }
        Ok(darker)
    }

    /// Stops to look for what is under white shapes, of which there are too many.
    fn stop_tracking(&mut self) -> Result<(), SvgError> {
        // A cancelled budget looks exhausted.
        self.white_work.budget.spend(0)?;
        self.tracks_fills = false;
        self.warn(WarningKind::WhiteUnknown, 1);
        Ok(())
    }

    /// Draws edges of a white shape on darker ones, or reports that they are not drawn.
    fn white_edges(&mut self, darker: Vec<(InkColor, Stroke)>) -> Result<(), SvgError> {
        if !self.draws_white_edges {
            self.warn(WarningKind::WhiteOnDark, usize::from(!darker.is_empty()));
            return Ok(());
        }
        darker
            .into_iter()
            .try_for_each(|(color, edge)| self.on_page(edge, color))
    }

    /// Notes a fill for what is drawn before it and after it.
    fn cover(
        &mut self,
        outlines: &[Stroke],
        transform: Affine,
        fill: FillPaint,
        clips: &[Rc<Region>],
    ) -> Result<(), SvgError> {
        let is_paper = fill.color.0 == Some(PAPER);
        let hides = self.hides && fill.is_opaque;
        // Where white is translucent, what is under it stays darker.
        if !hides && (!self.tracks_fills || (is_paper && !fill.is_opaque)) {
            return Ok(());
        }
        let corners = outlines.iter().map(|outline| outline.points.len()).sum();
        if hides {
            self.work.budget.spend(corners)?;
        } else if self.white_work.budget.spend(corners).is_err() {
            self.stop_tracking()?;
            return Ok(());
        }
        let mut outlines = outlines.to_vec();
        for outline in &mut outlines {
            place(&mut outline.points, transform)?;
        }
        let paint = if is_paper {
            CoverPaint::Paper
        } else {
            CoverPaint::Ink(fill.color.0)
        };
        let area = ClipArea::new(&outlines, fill.rule, clips.to_vec());
        self.layers.cover(area, paint, hides);
        Ok(())
    }

    /// The dashes of an outline of a path of this length, and their transform to the page.
    fn dashes(
        &mut self,
        mut outline: Stroke,
        whole: f64,
        transform: Affine,
        ink: &Ink,
    ) -> Result<(Vec<Stroke>, Affine), SvgError> {
        let dashes = ink.line.as_ref().and_then(|line| line.dashes.as_ref());
        let Some(dashes) = dashes else {
            return Ok((vec![outline], transform));
        };
        let mut rest = transform;
        if dashes.of == DashLength::Page {
            rest = Affine::scale(MM_PER_PX);
            place(&mut outline.points, rest.inverse() * transform)?;
        }
        let unit = if dashes.of == DashLength::Path {
            whole
        } else {
            1.0
        };
        let lengths: Vec<f64> = dashes.lengths.iter().map(|length| unit * length).collect();
        let pieces = dash(
            outline,
            &lengths,
            unit * dashes.offset,
            &mut self.work.budget,
        )?;
        Ok((pieces, rest))
    }

    /// Adds the visible part of a stroke to the page.
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
        place(&mut stroke.points, transform)?;
        let mut pieces = vec![stroke];
        for clip in clips {
            let mut shown = Vec::new();
            for piece in pieces {
                shown.append(&mut clip.cut(piece, &mut self.work.budget)?);
            }
            pieces = shown;
        }
        pieces
            .into_iter()
            .try_for_each(|piece| self.on_page(piece, color))
    }

    /// Adds a stroke in page coordinates, clipped at the edge.
    fn on_page(&mut self, stroke: Stroke, color: InkColor) -> Result<(), SvgError> {
        let ink = bounds(stroke.points.iter().copied());
        let Some(edge) = self.edge.as_ref().filter(|edge| !edge.holds(ink)) else {
            self.layers.stroke(stroke, color);
            return Ok(());
        };
        let whole_mm = stroke.length_mm();
        let pieces = edge.region.cut(stroke, &mut self.work.budget)?;
        self.cut_mm += whole_mm - pieces.iter().map(Stroke::length_mm).sum::<f64>();
        self.cut_lines += 1;
        for piece in pieces {
            self.layers.stroke(piece, color);
        }
        Ok(())
    }

    /// Adds the visible part of a filled area to the page. Returns its edges if clip paths change
    /// them.
    fn fill(
        &mut self,
        outlines: &[Stroke],
        transform: Affine,
        fill: FillPaint,
        clips: &[Rc<Region>],
    ) -> Result<Option<CutArea>, SvgError> {
        let work = &mut self.work;
        let Some(filled) = FilledArea::new(outlines, transform, fill.rule, clips, work)? else {
            return Ok(None);
        };
        let FilledArea {
            whole,
            around,
            shown,
        } = filled;
        let edge = self.edge.as_ref().filter(|edge| !edge.holds(around));
        let area = match (&shown, edge) {
            (_, None) | (None, _) => shown.clone(),
            (Some(whole), Some(_)) if whole.rings.is_empty() => shown.clone(),
            (Some(whole), Some(edge)) => self::shown(
                whole,
                around,
                [&edge.region],
                &mut self.work.budget,
                &mut self.work.corners_left,
            )?,
        };
        match area {
            Some(area) if !area.rings.is_empty() => self.layers.area(area, fill.color),
            Some(_) => {}
            None => self.warn(WarningKind::Entangled, 1),
        }
        let cut = shown.filter(|shown| *shown != whole).map(outlines_of);
        Ok(cut.map(|edges| CutArea { edges, whole }))
    }
}

/// The work that may still be done.
#[derive(Debug)]
pub(crate) struct ClipWork {
    /// The number of remaining segments.
    pub(crate) budget: Budget,
    /// The remaining budget of corners of filled shapes and clip paths, charged for each clip.
    corners_left: usize,
}

impl ClipWork {
    fn until(cancel: &CancelToken) -> Self {
        Self {
            budget: Budget::until(MAX_SEGMENTS, cancel),
            corners_left: MAX_CLIPPED_CORNERS,
        }
    }
}

/// A filled area on the page.
struct FilledArea {
    whole: Area,
    around: Rect,
    /// The part inside its clip paths; `None` if too complex.
    shown: Option<Area>,
}

impl FilledArea {
    /// A filled area in page coordinates, and its part inside clip paths; `None` if it is empty.
    fn new(
        outlines: &[Stroke],
        transform: Affine,
        rule: FillRule,
        clips: &[Rc<Region>],
        work: &mut ClipWork,
    ) -> Result<Option<Self>, SvgError> {
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
            return Ok(None);
        }
        let whole = Area { rings, rule };
        let shown = shown(
            &whole,
            around,
            clips.iter().map(Rc::as_ref),
            &mut work.budget,
            &mut work.corners_left,
        )?;
        Ok(Some(Self {
            whole,
            around,
            shown,
        }))
    }
}

/// A filled area that clip paths cut.
struct CutArea {
    edges: Vec<Stroke>,
    whole: Area,
}

/// The parts of edges that clip paths cut into an area: those beside its own outline.
fn beside_outline(edges: &[Stroke], whole: &Area) -> Vec<Stroke> {
    let rings: Vec<Stroke> = whole.rings.iter().cloned().map(Stroke::open).collect();
    let outline = ClipArea::new(&rings, whole.rule, Vec::new());
    let mut parts: Vec<Stroke> = Vec::new();
    for edge in edges {
        let (mut is_open, before) = (false, parts.len());
        for (a, b) in edge.segments() {
            let is_own = [a, a.midpoint(b), b]
                .into_iter()
                .all(|p| outline.is_on_edge(p));
            match parts.last_mut().filter(|_| is_open) {
                Some(part) if !is_own => part.points.push(b),
                _ if !is_own => parts.push(Stroke::open(vec![a, b])),
                _ => {}
            }
            is_open = !is_own;
        }
        // The first part goes on where the last one ends.
        let is_around = is_open && parts.len() > before + 1;
        if is_around && parts[before].points.first() == edge.points.first() {
            let last = parts.pop().map_or_else(Vec::new, |last| last.points);
            let first = std::mem::replace(&mut parts[before].points, last);
            parts[before].points.extend_from_slice(&first[1..]);
        }
    }
    parts
}

/// The edge of a page, slightly enlarged: numbers in files are rounded, and half of a line on the
/// edge is visible.
struct PageEdge {
    region: Region,
    bounds: Rect,
}

impl PageEdge {
    fn new([w, h]: [f64; 2]) -> Self {
        let slack_mm = PAGE_SLACK * w.min(h);
        let bounds = Rect::new(0.0, 0.0, w, h).inflate(slack_mm, slack_mm);
        let Rect { x0, y0, x1, y1 } = bounds;
        let corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)].map(|(x, y)| Point::new(x, y));
        let outline = Stroke::open(corners.to_vec());
        let area = ClipArea::new(&[outline], FillRule::NonZero, Vec::new());
        Self {
            region: Region::new(vec![area]),
            bounds,
        }
    }

    fn holds(&self, ink: Rect) -> bool {
        self.bounds.contains_rect(ink)
    }
}

/// The visible part of an area; `None` if too complex, or if the budget of corners is too small.
fn shown<'r>(
    area: &Area,
    bounds: Rect,
    regions: impl IntoIterator<Item = &'r Region>,
    budget: &mut Budget,
    corners_left: &mut usize,
) -> Result<Option<Area>, OverBudget> {
    let mut shown = None;
    for region in regions {
        let cuts = region.has_edge_in(bounds) || !region.shows(area.rings[0][0]);
        region.charge(budget)?;
        if cuts {
            let before = shown.take();
            let before = before.or_else(|| Polygons::new(&area.rings, area.rule));
            let (Some(before), Some(region)) = (before, region.polygons()) else {
                return Ok(None);
            };
            let left = corners_left.checked_sub(before.corners() + region.corners());
            let after = left.and_then(|_| before.intersection(region));
            let (Some(left), Some(after)) = (left, after) else {
                return Ok(None);
            };
            *corners_left = left.saturating_sub(COST_OF_CORNER * after.corners());
            shown = Some(after);
        }
    }
    Ok(Some(
        shown.map_or_else(|| area.clone(), Polygons::into_area),
    ))
}

/// The width of a line on the page; the mean if it is scaled differently in two directions.
fn width_mm(line: &LinePaint, transform: Affine) -> Option<f64> {
    let scale = if line.on_page {
        MM_PER_PX
    } else {
        transform.determinant().abs().sqrt()
    };
    Some(line.width? * scale)
}

/// The edges of an area, each closed.
fn outlines_of(area: Area) -> Vec<Stroke> {
    let closed = |points| {
        let mut outline = Stroke::open(points);
        close(&mut outline);
        outline
    };
    area.rings.into_iter().map(closed).collect()
}

/// Closes a line like filling.
fn close(line: &mut Stroke) {
    let first = line.points[0];
    if line.points.len() > 2 && !line.closed {
        if line.last() != Some(first) {
            line.points.push(first);
        }
        line.closed = true;
    }
}

/// Whether it encloses anything when closed: its points are not all on one line.
fn has_area(line: &Stroke) -> bool {
    let first = line.points[0];
    let way = line
        .points
        .iter()
        .map(|p| *p - first)
        .find(|point| point.hypot2() > 0.0);
    way.is_some_and(|way| line.points.iter().any(|p| way.cross(*p - first) != 0.0))
}

fn has_length(line: &Stroke) -> bool {
    line.points.iter().any(|p| *p != line.points[0])
}

/// Moves points to page coordinates, and returns their bounds.
pub(crate) fn place(points: &mut [Point], transform: Affine) -> Result<Rect, SvgError> {
    let mut around = bounds([]);
    for p in points {
        *p = transform * *p;
        // NaN passes no comparison.
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

/// This takes one or two seconds.
const MAX_CLIPPED_CORNERS: usize = 1_200_000;
/// The cost of a visible corner: most of them are crossings of edges.
const COST_OF_CORNER: usize = 4;
/// The enlargement of the page edge, as a fraction of its smaller side.
const PAGE_SLACK: f64 = 0.005;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fill_is_clipped_while_the_budget_of_corners_lasts_and_visible_parts_cost_more() {
        let square = |at: f64| {
            let corners = [
                (at, at),
                (at + 9.0, at),
                (at + 9.0, at + 9.0),
                (at, at + 9.0),
            ];
            corners.map(|(x, y)| Point::new(x, y)).to_vec()
        };
        let outline = Stroke::open(square(5.0));
        let clip = ClipArea::new(&[outline], FillRule::NonZero, Vec::new());
        let region = Region::new(vec![clip]);
        let area = Area {
            rings: vec![square(0.0)],
            rule: FillRule::NonZero,
        };
        let around = bounds(area.rings[0].iter().copied());
        let cut = |left: &mut usize| {
            let mut budget = Budget::new(100);
            shown(&area, around, [&region], &mut budget, left).expect("looks are left")
        };
        let mut left = 8;
        assert_eq!(cut(&mut left).expect("few corners").rings[0].len(), 4);
        assert_eq!(left, 0);
        assert_eq!(cut(&mut 7), None);
    }
}
