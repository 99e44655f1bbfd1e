//! From the tree of shapes to strokes on the page.

use std::collections::BTreeMap;
use std::rc::Rc;

use usvg::{ClipPath, FillRule, Group, LineCap, Node, Paint, Path, Tree};

use super::Budget;
use super::affine::Affine;
use super::clip::{Area, Region};
use super::dash::dash;
use super::error::{SvgError, Unshown, WarningKind};
use super::flatten::flatten;
use crate::point::{Bounds, Point, Stroke};

/// Collects the strokes of a tree.
pub(crate) struct Walk {
    tolerance_mm: f64,
    budget: Budget,
    page: Region,
    page_bounds: Bounds,
    strokes: Vec<Stroke>,
    warnings: BTreeMap<WarningKind, usize>,
}

impl Walk {
    pub(crate) fn new(tree: &Tree, tolerance_mm: f64, budget: Budget) -> Self {
        let [w, h] = page_mm(tree);
        let corners = [(0.0, 0.0), (w, 0.0), (w, h), (0.0, h)].map(|(x, y)| Point::new(x, y));
        let outline = Stroke::open(corners.to_vec());
        Self {
            tolerance_mm,
            budget,
            page: Region {
                areas: vec![Area::new(&[outline], FillRule::NonZero, Vec::new())],
            },
            page_bounds: Bounds::of(corners),
            strokes: Vec::new(),
            warnings: BTreeMap::new(),
        }
    }

    pub(crate) fn tree(&mut self, tree: &Tree) -> Result<(), SvgError> {
        self.group(tree.root(), Affine::scale(MM_PER_PX), &mut Vec::new())
    }

    pub(crate) fn finish(self) -> (Vec<Stroke>, Vec<Unshown>) {
        let warnings = self.warnings.into_iter();
        let warnings = warnings.map(|(kind, count)| Unshown { kind, count });
        (self.strokes, warnings.collect())
    }

    fn group(
        &mut self,
        group: &Group,
        parent: Affine,
        clips: &mut Vec<Rc<Region>>,
    ) -> Result<(), SvgError> {
        if group.opacity().get() == 0.0 {
            return Ok(());
        }
        self.warn(WarningKind::Mask, usize::from(group.mask().is_some()));
        self.warn(WarningKind::Filter, group.filters().len());
        let transform = parent.of(group.transform());
        let outer = clips.len();
        if let Some(clip) = group.clip_path() {
            self.regions(clip, transform, clips)?;
        }
        for child in group.children() {
            self.node(child, transform, clips)?;
        }
        clips.truncate(outer);
        Ok(())
    }

    fn node(
        &mut self,
        node: &Node,
        transform: Affine,
        clips: &mut Vec<Rc<Region>>,
    ) -> Result<(), SvgError> {
        match node {
            Node::Group(group) => self.group(group, transform, clips),
            Node::Path(path) => self.path(path, transform, clips),
            Node::Text(text) => self.group(text.flattened(), transform, clips),
            Node::Image(image) => {
                self.warn(WarningKind::Image, usize::from(image.is_visible()));
                Ok(())
            }
        }
    }

    fn path(
        &mut self,
        path: &Path,
        transform: Affine,
        clips: &[Rc<Region>],
    ) -> Result<(), SvgError> {
        let stroke = path.stroke().filter(|s| s.opacity().get() > 0.0);
        let fill = path.fill().filter(|f| f.opacity().get() > 0.0);
        if !path.is_visible() || (stroke.is_none() && fill.is_none()) {
            return Ok(());
        }
        self.paint(stroke.map(usvg::Stroke::paint));
        self.paint(fill.map(usvg::Fill::paint));
        let dashes = stroke.and_then(|s| Some((s.dasharray()?, f64::from(s.dashoffset()))));
        for outline in self.flatten(path, transform)? {
            let pieces = match dashes {
                Some((lengths, offset)) => dash(outline, lengths, offset, &mut self.budget)?,
                None => vec![outline],
            };
            for piece in pieces.into_iter().filter(|piece| has_ink(piece, stroke)) {
                self.show(piece, transform, clips)?;
            }
        }
        Ok(())
    }

    fn flatten(&mut self, path: &Path, transform: Affine) -> Result<Vec<Stroke>, SvgError> {
        let stretch = transform.max_stretch().max(f64::MIN_POSITIVE);
        flatten(path.data(), self.tolerance_mm / stretch, &mut self.budget)
    }

    /// Puts a stroke on the page, as far as it shows.
    fn show(
        &mut self,
        mut stroke: Stroke,
        transform: Affine,
        clips: &[Rc<Region>],
    ) -> Result<(), SvgError> {
        place(&mut stroke, transform)?;
        let mut pieces = if self.leaves_page(&stroke) {
            self.page.cut(stroke, &mut self.budget)?
        } else {
            vec![stroke]
        };
        for clip in clips {
            let mut shown = Vec::new();
            for piece in pieces {
                shown.append(&mut clip.cut(piece, &mut self.budget)?);
            }
            pieces = shown;
        }
        self.strokes.append(&mut pieces);
        Ok(())
    }

    fn leaves_page(&self, stroke: &Stroke) -> bool {
        let (page, ink) = (self.page_bounds, Bounds::of(stroke.points.iter().copied()));
        page.with(ink.min).with(ink.max) != page
    }

    /// The regions of which all must show a point.
    fn regions(
        &mut self,
        clip: &ClipPath,
        transform: Affine,
        regions: &mut Vec<Rc<Region>>,
    ) -> Result<(), SvgError> {
        let mut region = Region::default();
        let own = transform.of(clip.transform());
        self.areas(clip.root(), own, &[], &mut region.areas)?;
        regions.push(Rc::new(region));
        match clip.clip_path() {
            Some(outer) => self.regions(outer, transform, regions),
            None => Ok(()),
        }
    }

    fn areas(
        &mut self,
        group: &Group,
        parent: Affine,
        within: &[Rc<Region>],
        areas: &mut Vec<Area>,
    ) -> Result<(), SvgError> {
        let transform = parent.of(group.transform());
        let mut within = within.to_vec();
        if let Some(clip) = group.clip_path() {
            self.regions(clip, transform, &mut within)?;
        }
        for child in group.children() {
            match child {
                Node::Group(inner) => self.areas(inner, transform, &within, areas)?,
                Node::Text(text) => self.areas(text.flattened(), transform, &within, areas)?,
                Node::Path(path) if path.is_visible() => {
                    areas.push(self.area(path, transform, within.clone())?);
                }
                Node::Path(_) | Node::Image(_) => {}
            }
        }
        Ok(())
    }

    fn area(
        &mut self,
        path: &Path,
        transform: Affine,
        within: Vec<Rc<Region>>,
    ) -> Result<Area, SvgError> {
        let mut outlines = self.flatten(path, transform)?;
        for outline in &mut outlines {
            place(outline, transform)?;
        }
        let rule = path.fill().map_or(FillRule::NonZero, usvg::Fill::rule);
        Ok(Area::new(&outlines, rule, within))
    }

    fn paint(&mut self, paint: Option<&Paint>) {
        match paint {
            None | Some(Paint::Color(_)) => {}
            Some(Paint::Pattern(_)) => self.warn(WarningKind::Pattern, 1),
            Some(Paint::LinearGradient(_) | Paint::RadialGradient(_)) => {
                self.warn(WarningKind::Gradient, 1);
            }
        }
    }

    fn warn(&mut self, kind: WarningKind, count: usize) {
        if count > 0 {
            *self.warnings.entry(kind).or_default() += count;
        }
    }
}

/// Width and height of the page.
pub(crate) fn page_mm(tree: &Tree) -> [f64; 2] {
    let size = tree.size();
    [size.width(), size.height()].map(|px| f64::from(px) * MM_PER_PX)
}

/// A line without length is a dot where its ends are drawn, and nothing where they are cut off.
fn has_ink(line: &Stroke, stroke: Option<&usvg::Stroke>) -> bool {
    let has_ends = stroke.is_some_and(|stroke| stroke.linecap() != LineCap::Butt);
    has_ends || line.points.iter().any(|p| *p != line.points[0])
}

fn place(stroke: &mut Stroke, transform: Affine) -> Result<(), SvgError> {
    for p in &mut stroke.points {
        *p = transform.apply(*p);
        if p.x.abs().max(p.y.abs()) > LIMIT_MM || !(p.x + p.y).is_finite() {
            return Err(SvgError::TooFar {
                x_mm: p.x,
                y_mm: p.y,
                limit_mm: LIMIT_MM,
            });
        }
    }
    Ok(())
}

/// A browser's pixel: 96 to the inch.
const MM_PER_PX: f64 = 25.4 / 96.0;
const LIMIT_MM: f64 = 1_000_000.0;
