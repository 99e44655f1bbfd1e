//! Masks that are clips: everything in them is fully shown or fully hidden.

use std::rc::Rc;

use dobot_geometry::{Affine, Point, Polygons, Stroke};
use usvg::{Group, Mask, MaskType, Node, Paint, Path};

use super::ink::PAPER;
use super::renderer::{TreeRenderer, affine, rgb};
use super::warning_count::WarningKind;
use crate::clip::{ClipArea, Region};
use crate::error::SvgError;

impl TreeRenderer<'_> {
    /// Adds the regions that a mask shows; `false` if it has half-tones, images or lines.
    pub(super) fn mask(
        &mut self,
        mask: &Mask,
        transform: Affine,
        regions: &mut Vec<Rc<Region>>,
    ) -> Result<bool, SvgError> {
        if mask.root().children().is_empty() {
            self.page.warn(WarningKind::EmptyMask, 1);
        }
        if !is_plain(mask.root(), mask.kind()) {
            return Ok(false);
        }
        let mut shown = Some(Polygons::default());
        self.masked(mask.root(), mask.kind(), transform, &mut shown)?;
        let Some(shown) = shown else {
            return Ok(false);
        };
        if let Some(outer) = mask.mask()
            && !self.mask(outer, transform, regions)?
        {
            return Ok(false);
        }
        let shown = shown.into_area();
        let outlines: Vec<Stroke> = shown.rings.into_iter().map(Stroke::open).collect();
        let area = ClipArea::new(&outlines, shown.rule, vec![rectangle(mask, transform)]);
        regions.push(Rc::new(Region::new(vec![area])));
        Ok(true)
    }

    /// Adds what each shape shows, and subtracts what it hides; `None` if they are too complex.
    fn masked(
        &mut self,
        group: &Group,
        kind: MaskType,
        parent: Affine,
        shown: &mut Option<Polygons>,
    ) -> Result<(), SvgError> {
        let transform = parent * affine(group.transform());
        let mut within = Vec::new();
        if let Some(clip) = group.clip_path() {
            self.regions(clip, transform, &mut within)?;
        }
        for node in group.children() {
            let path = match node {
                Node::Group(inner) => {
                    self.masked(inner, kind, transform, shown)?;
                    continue;
                }
                Node::Text(text) => {
                    self.masked(text.flattened(), kind, transform, shown)?;
                    continue;
                }
                Node::Path(path) if path.is_visible() => path,
                Node::Path(_) | Node::Image(_) => continue,
            };
            let Some(before) = shown.take().filter(|_| path.fill().is_some()) else {
                continue;
            };
            let area = self.area(path, transform, within.clone())?;
            let corners = before.corners() + area.corners();
            if !self.page.take_corners(corners) {
                return Ok(());
            }
            let Some(area) = area.polygons() else {
                return Ok(());
            };
            *shown = match tone(path, kind) {
                Some(true) => Polygons::union(vec![before, area]),
                Some(false) => before.difference([&area]),
                None => None,
            };
        }
        Ok(())
    }
}

/// Whether each shape in a mask is fully shown or hides fully.
fn is_plain(group: &Group, kind: MaskType) -> bool {
    let is_whole = group.opacity().get() == 1.0
        && group.mask().is_none()
        && group.filters().is_empty()
        && (group.clip_path().is_none() || group.children().iter().all(is_shape));
    is_whole
        && group.children().iter().all(|node| match node {
            Node::Group(inner) => is_plain(inner, kind),
            Node::Text(text) => is_plain(text.flattened(), kind),
            Node::Path(path) => {
                !path.is_visible() || (path.stroke().is_none() && tone(path, kind).is_some())
            }
            Node::Image(_) => false,
        })
}

const fn is_shape(node: &Node) -> bool {
    matches!(node, Node::Path(_))
}

/// Whether a shape in a mask shows what is under it, or hides it; `None` if neither.
fn tone(path: &Path, kind: MaskType) -> Option<bool> {
    let Some(fill) = path.fill() else {
        return Some(false);
    };
    let is_color = matches!(fill.paint(), Paint::Color(_)) && fill.opacity().get() == 1.0;
    match (kind, rgb(fill.paint()).filter(|_| is_color)?) {
        (MaskType::Alpha, _) | (MaskType::Luminance, PAPER) => Some(true),
        (MaskType::Luminance, [0, 0, 0]) => Some(false),
        (MaskType::Luminance, _) => None,
    }
}

/// The rectangle of a mask, beyond which nothing shows.
fn rectangle(mask: &Mask, transform: Affine) -> Rc<Region> {
    let rect = mask.rect();
    let [x0, x1] = [rect.left(), rect.right()].map(f64::from);
    let [y0, y1] = [rect.top(), rect.bottom()].map(f64::from);
    boxed([x0, y0, x1, y1], transform)
}

/// The inside of a rectangle given by two corners, in page coordinates.
pub(super) fn boxed([x0, y0, x1, y1]: [f64; 4], transform: Affine) -> Rc<Region> {
    let corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)];
    let corners = corners.map(|(x, y)| transform * Point::new(x, y));
    let outline = Stroke::open(corners.to_vec());
    let area = ClipArea::new(&[outline], dobot_geometry::FillRule::NonZero, Vec::new());
    Rc::new(Region::new(vec![area]))
}
