//! The renderer from the tree of shapes to the page.

use std::collections::HashMap;
use std::rc::Rc;

use dobot_geometry::{Affine, FillRule, Stroke};
use usvg::{
    BlendMode, ClipPath, Group, Image, ImageKind, LineCap, Node, Paint, Path, Stop, Text, Tree,
};

use super::flatten::flatten;
use super::groups::LayerGroup;
use super::ink::{
    DashLength, Dashes, FillPaint, Ink, InkColor, LinePaint, PAPER, PATH_DASHES, SCREEN_LINE,
    SCREEN_PATH_DASHES,
};
use super::mask::boxed;
use super::page::{SvgPage, place};
use super::pattern::MAX_TILES;
use super::single_line::{self, Written};
use super::warning_count::WarningKind;
use crate::clip::{ClipArea, Region};
use crate::error::SvgError;

/// A visitor of a tree that draws on a page.
pub(crate) struct TreeRenderer<'a> {
    pub(super) page: &'a mut SvgPage,
    tolerance_mm: f64,
    /// The groups that make layers, by `id`.
    groups: &'a HashMap<String, LayerGroup>,
    /// Whether it is inside one with a name.
    in_group: bool,
    /// Whether it is inside a transparent group.
    is_faint: bool,
    /// The number of tiles of patterns that may still be drawn.
    pub(super) tiles_left: u32,
}

impl<'a> TreeRenderer<'a> {
    pub(crate) const fn new(
        page: &'a mut SvgPage,
        tolerance_mm: f64,
        groups: &'a HashMap<String, LayerGroup>,
    ) -> Self {
        Self {
            page,
            tolerance_mm,
            groups,
            in_group: false,
            is_faint: false,
            tiles_left: MAX_TILES,
        }
    }

    pub(crate) fn tree(&mut self, tree: &Tree) -> Result<(), SvgError> {
        self.page.tracks_fills |= has_white_over_dark(tree.root(), &mut false);
        self.group(tree.root(), Affine::scale(MM_PER_PX), &mut Vec::new())
    }

    pub(super) fn group(
        &mut self,
        group: &Group,
        parent: Affine,
        clips: &mut Vec<Rc<Region>>,
    ) -> Result<(), SvgError> {
        let Some(LayerGroup { name, control }) = self.groups.get(group.id()) else {
            return self.contents(group, parent, clips);
        };
        let name = name.as_ref().filter(|_| !self.in_group);
        let outer_mm_s = self.page.layers.speed_mm_s();
        if let Some(control) = control {
            self.page.layers.draw_as(control);
        }
        if let Some(name) = name {
            self.in_group = true;
            self.page.layers.enter(Some(name.clone()));
        }
        self.contents(group, parent, clips)?;
        if name.is_some() {
            self.page.layers.enter(None);
            self.in_group = false;
        }
        self.page.layers.draw_at(outer_mm_s);
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
        self.page.warn(WarningKind::Filter, group.filters().len());
        let transform = parent * affine(group.transform());
        let outer = clips.len();
        if let Some(clip) = group.clip_path() {
            self.regions(clip, transform, clips)?;
        }
        if let Some(mask) = group.mask()
            && !self.mask(mask, transform, clips)?
        {
            self.page.warn(WarningKind::Mask, 1);
        }
        let was_faint = self.is_faint;
        self.is_faint |= group.opacity().get() < 1.0 || group.blend_mode() != BlendMode::Normal;
        for child in group.children() {
            self.node(child, transform, clips)?;
        }
        self.is_faint = was_faint;
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
            Node::Text(text) => self.text(text, transform, clips),
            Node::Image(image) => self.image(image, transform, clips),
        }
    }

    /// Draws an SVG image; others are left out.
    fn image(
        &mut self,
        image: &Image,
        transform: Affine,
        clips: &mut Vec<Rc<Region>>,
    ) -> Result<(), SvgError> {
        if !image.is_visible() {
            return Ok(());
        }
        let ImageKind::SVG(tree) = image.kind() else {
            self.page.warn(WarningKind::Image, 1);
            return Ok(());
        };
        let size = tree.size();
        let [width, height] = [size.width(), size.height()].map(f64::from);
        clips.push(boxed([0.0, 0.0, width, height], transform));
        self.group(tree.root(), transform, clips)?;
        clips.pop();
        Ok(())
    }

    /// Draws a text in single-line letters if the file asks for them, otherwise in outlines.
    fn text(
        &mut self,
        text: &Text,
        transform: Affine,
        clips: &mut Vec<Rc<Region>>,
    ) -> Result<(), SvgError> {
        let stretch = transform.spectral_norm().max(f64::MIN_POSITIVE);
        let written = single_line::written(text, self.tolerance_mm / stretch);
        let Some(text) = written else {
            return self.group(text.flattened(), transform, clips);
        };
        self.page.warn(WarningKind::MissingLetter, text.missing);
        for kind in text.unread {
            self.page.warn(kind, 1);
        }
        for Written { strokes, span } in text.written {
            let paint = span.stroke().map(usvg::Stroke::paint);
            let Some(paint) = paint.or_else(|| span.fill().map(usvg::Fill::paint)) else {
                continue;
            };
            if !span.is_visible() {
                continue;
            }
            let line = LinePaint {
                color: InkColor(rgb(paint)),
                width: span.stroke().map(|line| line.width().get().into()),
                on_page: false,
                has_ends: true,
                dashes: None,
            };
            let ink = Ink {
                line: Some(line),
                fill: None,
            };
            let corners = strokes.iter().map(|stroke| stroke.points.len()).sum();
            self.page.work.budget.note_curve(corners);
            self.page.work.budget.spend(corners)?;
            self.page.shape(strokes, transform, &ink, clips)?;
        }
        Ok(())
    }

    fn path(
        &mut self,
        path: &Path,
        transform: Affine,
        clips: &[Rc<Region>],
    ) -> Result<(), SvgError> {
        let mut ink = self.ink(path);
        let pattern = path
            .fill()
            .filter(|fill| path.is_visible() && fill.opacity().get() > 0.0);
        if let Some(Paint::Pattern(pattern)) = pattern.map(usvg::Fill::paint) {
            if self.pattern(path, pattern, transform, clips)? {
                ink.fill = None;
            } else {
                self.page.warn(WarningKind::Pattern, 1);
            }
        }
        if !path.is_visible() || ink == Ink::default() {
            return Ok(());
        }
        if ink.is_paper() && !self.page.hides {
            self.page.warn(WarningKind::Paper, 1);
        }
        let outlines = self.flatten(path, transform)?;
        self.page.shape(outlines, transform, &ink, clips)
    }

    fn ink(&mut self, path: &Path) -> Ink {
        let shows = |opacity: f32, paint: &Paint| opacity > 0.0 && is_seen(paint);
        let line = path.stroke();
        let line = line.filter(|line| shows(line.opacity().get(), line.paint()));
        let fill = path.fill();
        let fill = fill.filter(|fill| shows(fill.opacity().get(), fill.paint()));
        if path.is_visible() {
            self.warn_of_paint(line.map(usvg::Stroke::paint));
            let fill = fill.map(usvg::Fill::paint);
            self.warn_of_paint(fill.filter(|fill| !matches!(fill, Paint::Pattern(_))));
        }
        Ink {
            line: line.map(read_line),
            fill: fill.map(|fill| read_fill(fill, self.is_faint)),
        }
    }

    fn flatten(&mut self, path: &Path, transform: Affine) -> Result<Vec<Stroke>, SvgError> {
        let stretch = transform.spectral_norm().max(f64::MIN_POSITIVE);
        let tolerance = self.tolerance_mm / stretch;
        flatten(path.data(), tolerance, &mut self.page.work.budget)
    }

    /// The clip regions; all must contain a visible point.
    pub(super) fn regions(
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
        areas: &mut Vec<ClipArea>,
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

    /// The inside of a shape.
    pub(super) fn area(
        &mut self,
        path: &Path,
        transform: Affine,
        within: Vec<Rc<Region>>,
    ) -> Result<ClipArea, SvgError> {
        let mut outlines = self.flatten(path, transform)?;
        for outline in &mut outlines {
            place(&mut outline.points, transform)?;
        }
        let rule = path
            .fill()
            .map_or(FillRule::NonZero, |fill| rule(fill.rule()));
        Ok(ClipArea::new(&outlines, rule, within))
    }

    fn warn_of_paint(&mut self, paint: Option<&Paint>) {
        match paint {
            None | Some(Paint::Color(_)) => {}
            Some(Paint::Pattern(_)) => self.page.warn(WarningKind::Pattern, 1),
            Some(Paint::LinearGradient(_) | Paint::RadialGradient(_)) => {
                self.page.warn(WarningKind::Gradient, 1);
            }
        }
    }
}

/// Whether a white fill comes after one of another colour, which is noted.
fn has_white_over_dark(group: &Group, has_dark: &mut bool) -> bool {
    group.children().iter().any(|node| match node {
        Node::Group(group) => has_white_over_dark(group, has_dark),
        Node::Text(text) => has_white_over_dark(text.flattened(), has_dark),
        Node::Path(path) => path.fill().is_some_and(|fill| {
            let is_white = rgb(fill.paint()) == Some(PAPER);
            *has_dark |= !is_white;
            is_white && *has_dark
        }),
        Node::Image(_) => false,
    })
}

pub(super) fn affine(map: usvg::Transform) -> Affine {
    Affine::new([map.sx, map.ky, map.kx, map.sy, map.tx, map.ty].map(f64::from))
}

/// Width and height of the page.
pub(crate) fn page_mm(tree: &Tree) -> [f64; 2] {
    let size = tree.size();
    [size.width(), size.height()].map(|px| f64::from(px) * MM_PER_PX)
}

fn read_line(line: &usvg::Stroke) -> LinePaint {
    let mark = line.miterlimit().get();
    let dashes = line.dasharray().map(|lengths| Dashes {
        lengths: lengths.iter().copied().map(f64::from).collect(),
        offset: f64::from(line.dashoffset()),
        of: match mark {
            SCREEN_LINE => DashLength::Page,
            PATH_DASHES | SCREEN_PATH_DASHES => DashLength::Path,
            _ => DashLength::Line,
        },
    });
    LinePaint {
        color: InkColor(rgb(line.paint())),
        width: Some(line.width().get().into()),
        on_page: matches!(mark, SCREEN_LINE | SCREEN_PATH_DASHES),
        has_ends: line.linecap() != LineCap::Butt,
        dashes,
    }
}

fn read_fill(fill: &usvg::Fill, is_faint: bool) -> FillPaint {
    FillPaint {
        color: InkColor(rgb(fill.paint())),
        rule: rule(fill.rule()),
        is_opaque: fill.opacity().get() == 1.0 && !is_faint && is_opaque(fill.paint()),
    }
}

/// The colour of a gradient: the first one visible on white paper.
pub(super) fn rgb(paint: &Paint) -> Option<[u8; 3]> {
    if let Paint::Color(color) = paint {
        return Some([color.red, color.green, color.blue]);
    }
    let stops = stops(paint).iter();
    let seen = stops.clone().filter(|stop| stop.opacity().get() > 0.0);
    let colors = seen.map(|item| [item.color().red, item.color().green, item.color().blue]);
    let mut inks = colors.clone().filter(|color| *color != PAPER);
    inks.next().or_else(|| colors.clone().next())
}

/// The stops of a gradient; none of any other paint.
fn stops(paint: &Paint) -> &[Stop] {
    match paint {
        Paint::LinearGradient(gradient) => gradient.stops(),
        Paint::RadialGradient(gradient) => gradient.stops(),
        Paint::Color(_) | Paint::Pattern(_) => &[],
    }
}

/// Whether a gradient is visible at all.
fn is_seen(paint: &Paint) -> bool {
    let mut stops = stops(paint).iter().peekable();
    stops.peek().is_none() || stops.any(|stop| stop.opacity().get() > 0.0)
}

/// Whether it is opaque. The gaps of a pattern are unknown.
fn is_opaque(paint: &Paint) -> bool {
    let solid = stops(paint).iter().all(|stop| stop.opacity().get() == 1.0);
    solid && !matches!(paint, Paint::Pattern(_))
}

const fn rule(rule: usvg::FillRule) -> FillRule {
    match rule {
        usvg::FillRule::NonZero => FillRule::NonZero,
        usvg::FillRule::EvenOdd => FillRule::EvenOdd,
    }
}

/// A browser's pixel: 96 per inch.
pub(crate) const MM_PER_PX: f64 = 25.4 / 96.0;
