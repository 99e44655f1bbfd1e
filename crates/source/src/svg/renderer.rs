//! From the tree of shapes to the sheet.

use std::collections::HashMap;
use std::rc::Rc;

use dobot_geometry::{Affine, FillRule, Stroke};
use usvg::{ClipPath, Group, LineCap, Node, Paint, Path, Tree};

use super::clip::{Area, Region};
use super::flatten::flatten;
use super::ink::{Color, Dashes, Fill, Ink, Line};
use super::sheet::{Sheet, place};
use super::unshown::WarningKind;
use crate::error::SvgError;

/// Goes through a tree and draws on a sheet what it meets.
pub(crate) struct Walk<'a> {
    sheet: &'a mut Sheet,
    tolerance_mm: f64,
    /// The names of the outermost groups, by their `id`.
    groups: &'a HashMap<String, String>,
    /// Inside one of them.
    in_group: bool,
}

impl<'a> Walk<'a> {
    pub(crate) const fn new(
        sheet: &'a mut Sheet,
        tolerance_mm: f64,
        groups: &'a HashMap<String, String>,
    ) -> Self {
        Self {
            sheet,
            tolerance_mm,
            groups,
            in_group: false,
        }
    }

    pub(crate) fn tree(&mut self, tree: &Tree) -> Result<(), SvgError> {
        self.group(tree.root(), Affine::scale(MM_PER_PX), &mut Vec::new())
    }

    fn group(
        &mut self,
        group: &Group,
        parent: Affine,
        clips: &mut Vec<Rc<Region>>,
    ) -> Result<(), SvgError> {
        let name = self.groups.get(group.id()).filter(|_| !self.in_group);
        let Some(name) = name else {
            return self.contents(group, parent, clips);
        };
        self.in_group = true;
        self.sheet.layers.enter(Some(name.clone()));
        self.contents(group, parent, clips)?;
        self.sheet.layers.enter(None);
        self.in_group = false;
        Ok(())
    }

    fn contents(
        &mut self,
        group: &Group,
        parent: Affine,
        clips: &mut Vec<Rc<Region>>,
    ) -> Result<(), SvgError> {
        if group.opacity().get() == 0.0 {
            return Ok(());
        }
        let has_mask = usize::from(group.mask().is_some());
        self.sheet.warn(WarningKind::Mask, has_mask);
        self.sheet.warn(WarningKind::Filter, group.filters().len());
        let transform = parent * affine(group.transform());
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
                let is_visible = usize::from(image.is_visible());
                self.sheet.warn(WarningKind::Image, is_visible);
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
        let ink = self.ink(path);
        if !path.is_visible() || ink == Ink::default() {
            return Ok(());
        }
        if ink.is_paper() {
            self.sheet.warn(WarningKind::Paper, 1);
            return Ok(());
        }
        let outlines = self.flatten(path, transform)?;
        self.sheet.shape(outlines, transform, &ink, clips)
    }

    fn ink(&mut self, path: &Path) -> Ink {
        let line = path.stroke().filter(|it| it.opacity().get() > 0.0);
        let fill = path.fill().filter(|it| it.opacity().get() > 0.0);
        if path.is_visible() {
            self.warn_of_paint(line.map(usvg::Stroke::paint));
            self.warn_of_paint(fill.map(usvg::Fill::paint));
        }
        Ink {
            line: line.map(read_line),
            fill: fill.map(read_fill),
        }
    }

    fn flatten(&mut self, path: &Path, transform: Affine) -> Result<Vec<Stroke>, SvgError> {
        let stretch = transform.spectral_norm().max(f64::MIN_POSITIVE);
        let tolerance = self.tolerance_mm / stretch;
        flatten(path.data(), tolerance, &mut self.sheet.budget)
    }

    /// The regions of which all must show a point.
    fn regions(
        &mut self,
        clip: &ClipPath,
        transform: Affine,
        regions: &mut Vec<Rc<Region>>,
    ) -> Result<(), SvgError> {
        let mut areas = Vec::new();
        let own = transform * affine(clip.transform());
        self.areas(clip.root(), own, &[], &mut areas)?;
        regions.push(Rc::new(Region::new(areas)));
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
        let transform = parent * affine(group.transform());
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
            place(&mut outline.points, transform)?;
        }
        let rule = path.fill().map_or(FillRule::NonZero, |it| rule(it.rule()));
        Ok(Area::new(&outlines, rule, within))
    }

    fn warn_of_paint(&mut self, paint: Option<&Paint>) {
        match paint {
            None | Some(Paint::Color(_)) => {}
            Some(Paint::Pattern(_)) => self.sheet.warn(WarningKind::Pattern, 1),
            Some(Paint::LinearGradient(_) | Paint::RadialGradient(_)) => {
                self.sheet.warn(WarningKind::Gradient, 1);
            }
        }
    }
}

fn affine(map: usvg::Transform) -> Affine {
    Affine::new([map.sx, map.ky, map.kx, map.sy, map.tx, map.ty].map(f64::from))
}

/// Width and height of the page.
pub(crate) fn page_mm(tree: &Tree) -> [f64; 2] {
    let size = tree.size();
    [size.width(), size.height()].map(|px| f64::from(px) * MM_PER_PX)
}

fn read_line(line: &usvg::Stroke) -> Line {
    let dashes = line.dasharray().map(|lengths| Dashes {
        lengths: lengths.to_vec(),
        offset: f64::from(line.dashoffset()),
    });
    Line {
        color: color(line.paint()),
        has_ends: line.linecap() != LineCap::Butt,
        dashes,
    }
}

fn read_fill(fill: &usvg::Fill) -> Fill {
    Fill {
        color: color(fill.paint()),
        rule: rule(fill.rule()),
    }
}

/// A gradient counts as the colour that it begins with.
fn color(paint: &Paint) -> Color {
    let stops = match paint {
        Paint::Color(color) => return Some([color.red, color.green, color.blue]),
        Paint::LinearGradient(gradient) => gradient.stops(),
        Paint::RadialGradient(gradient) => gradient.stops(),
        Paint::Pattern(_) => &[],
    };
    let first = stops.first()?.color();
    Some([first.red, first.green, first.blue])
}

const fn rule(rule: usvg::FillRule) -> FillRule {
    match rule {
        usvg::FillRule::NonZero => FillRule::NonZero,
        usvg::FillRule::EvenOdd => FillRule::EvenOdd,
    }
}

/// A browser's pixel: 96 to the inch.
pub(crate) const MM_PER_PX: f64 = 25.4 / 96.0;
