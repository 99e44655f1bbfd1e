//! Hidden line removal: the parts of a drawing visible beside the filled shapes over it.

use std::cell::OnceCell;
use std::rc::Rc;

use dobot_geometry::{Area, Point, Polygons, Rect, SegmentIndex, Stroke, bounds};

use crate::artwork::Layer;
use crate::clip::{ClipArea, Region, parts_on};
use crate::limits::{Budget, OverBudget};

/// The painted areas, in their order.
#[derive(Debug, Default)]
pub(crate) struct Covers(Vec<Cover>);

impl Covers {
    /// Their number: what is painted now is above this many.
    pub(crate) fn count(&self) -> u32 {
        u32::try_from(self.0.len()).expect("each has corners, and those are counted")
    }

    /// Adds an area over everything painted before, and whether it hides that.
    pub(crate) fn put(&mut self, area: ClipArea, paint: CoverPaint, hides: bool) {
        self.0.push(Cover {
            bounds: area.bounds(),
            area,
            paint,
            hides,
            polygons: OnceCell::new(),
        });
    }

    /// The parts of the edge of a white shape that lie on something darker painted before, with its
    /// colour; `None` if the budget of edge tests is exhausted.
    pub(crate) fn darker_under(
        &self,
        edge: &Stroke,
        budget: &mut Budget,
    ) -> Result<Option<Vec<ColoredStroke>>, OverBudget> {
        let around = bounds(edge.points.iter().copied());
        if !budget.take_looks(LOOKS_FOR_COVER + self.0.len()) {
            return Ok(None);
        }
        let touching = self
            .0
            .iter()
            .rev()
            .filter(|cover| cover.bounds.overlaps(around));
        let under: Vec<&Cover> = touching.collect();
        let areas: Vec<&ClipArea> = under.iter().map(|cover| &cover.area).collect();
        let mut paints: Vec<CoverPaint> = under.iter().map(|cover| cover.paint).collect();
        paints.sort_unstable();
        paints.dedup();
        let mut parts = Vec::new();
        for paint in paints {
            let CoverPaint::Ink(color) = paint else {
                continue;
            };
            let is_on = |p| {
                under
                    .iter()
                    .find(|cover| cover.area.covers(p))
                    .map(|top| top.paint)
            };
            let found = parts_on(edge, &areas, |p| is_on(p) == Some(paint), budget)?;
            let Some(found) = found else {
                return Ok(None);
            };
            parts.extend(found.into_iter().map(|part| (color, part)));
        }
        Ok(Some(parts))
    }

    /// Limits all areas after the first `count` to a region.
    pub(crate) fn clip_since(&mut self, count: u32, region: &Rc<Region>) {
        for cover in self.0.iter_mut().skip(count as usize) {
            cover.area.clip(region.clone());
        }
    }

    /// The visible parts of each layer, and the number of lines and areas for which they are
    /// unknown: these stay whole. Areas are left out if they are not wanted and something is
    /// hidden.
    pub(crate) fn what_shows(
        self,
        layers: Vec<Layer>,
        heights: &[Heights],
        fills: bool,
        budget: &mut Budget,
    ) -> Result<(Vec<Layer>, usize), OverBudget> {
        if !self.0.iter().any(|cover| cover.hides) {
            return Ok((layers, 0));
        }
        let mut sight = self.sight();
        let mut shown = Vec::with_capacity(layers.len());
        for (mut layer, heights) in layers.into_iter().zip(heights) {
            if !fills {
                layer.areas.clear();
            }
            shown.push(sight.layer(layer, heights, budget)?);
        }
        shown.retain(|stroke| !stroke.is_empty());
        Ok((shown, sight.unknown))
    }

    fn sight(self) -> Sight {
        let corners = |cover: &Cover| {
            let Rect { x0, y0, x1, y1 } = cover.bounds;
            (Point::new(x0, y0), Point::new(x1, y1))
        };
        Sight {
            boxes: SegmentIndex::new(self.0.iter().map(corners).collect()),
            covers: self.0,
            unknown: 0,
        }
    }
}

/// The warning about lines and areas that stay whole.
pub(crate) const UNKNOWN: (&str, &str) = (
    "shape",
    "drawn completely, because too many shapes lie over it to find the visible part",
);

/// The number of covers below each line and area of a layer.
#[derive(Debug, Default)]
pub(crate) struct Heights {
    pub(crate) strokes: Vec<u32>,
    pub(crate) areas: Vec<u32>,
}

/// The computation of visible parts.
#[derive(Debug)]
struct Sight {
    covers: Vec<Cover>,
    /// The covers by place: lower left and upper right corner of each.
    boxes: SegmentIndex,
    /// The number of lines and areas that stay whole.
    unknown: usize,
}

impl Sight {
    /// The visible parts of a layer.
    fn layer(
        &mut self,
        layer: Layer,
        heights: &Heights,
        budget: &mut Budget,
    ) -> Result<Layer, OverBudget> {
        let mut strokes = Vec::with_capacity(layer.strokes.len());
        for (stroke, &height) in layer.strokes.into_iter().zip(&heights.strokes) {
            strokes.append(&mut self.stroke(stroke, height, budget)?);
        }
        let mut areas = Vec::with_capacity(layer.areas.len());
        for (area, &height) in layer.areas.into_iter().zip(&heights.areas) {
            let area = self.area(area, height, budget);
            if !area.rings.is_empty() {
                areas.push(area);
            }
        }
        Ok(Layer {
            strokes,
            areas,
            ..layer
        })
    }

    fn stroke(
        &mut self,
        stroke: Stroke,
        height: u32,
        budget: &mut Budget,
    ) -> Result<Vec<Stroke>, OverBudget> {
        let around = bounds(stroke.points.iter().copied());
        let Some(over) = self.over(around, height, budget) else {
            return Ok(vec![stroke]);
        };
        // The stroke itself is kept for an exhausted budget.
        let mut pieces = vec![stroke.clone()];
        for cover in over {
            let cover = &self.covers[cover as usize];
            let mut seen = Vec::with_capacity(pieces.len());
            for piece in pieces {
                let Some(mut parts) = cover.area.uncovered(&piece, budget)? else {
                    self.unknown += 1;
                    return Ok(vec![stroke]);
                };
                seen.append(&mut parts);
            }
            pieces = seen;
            if pieces.is_empty() {
                break;
            }
        }
        Ok(pieces)
    }

    fn area(&mut self, area: Area, height: u32, budget: &mut Budget) -> Area {
        let around = bounds(area.rings.iter().flatten().copied());
        let Some(over) = self.over(around, height, budget) else {
            return area;
        };
        let corner = area.rings[0][0];
        let mut cutting = Vec::new();
        for cover in over {
            let cover = &self.covers[cover as usize];
            let has_edge = cover.area.may_cut(around);
            let is_hidden = !has_edge && cover.area.covers(corner);
            let corners = if has_edge { cover.area.corners() } else { 0 };
            let is_known = budget.take_looks(LOOKS_FOR_CORNER * corners);
            if !cover.area.charge(budget) || !is_known {
                self.unknown += 1;
                return area;
            }
            if is_hidden {
                return Area::default();
            }
            if has_edge {
                cutting.push(cover);
            }
        }
        if cutting.is_empty() {
            return area;
        }
        let seen = seen(&area, &cutting);
        seen.unwrap_or_else(|| {
            self.unknown += 1;
            area
        })
    }

    /// The covers that may hide something at this place above this number, the largest first,
    /// because they hide the most; none if there are too many.
    fn over(&mut self, around: Rect, height: u32, budget: &mut Budget) -> Option<Vec<u32>> {
        if !budget.has_looks() {
            self.unknown += 1;
            return None;
        }
        let mut over = Vec::new();
        let mut looks = 0;
        self.boxes.touching(around, &mut |cover| {
            looks += 1;
            if cover >= height && self.covers[cover as usize].hides {
                over.push(cover);
            }
        });
        budget.take_looks(LOOKS_FOR_COVER * looks);
        let size = |&cover: &u32| self.covers[cover as usize].bounds.area();
        over.sort_unstable_by(|a, b| size(b).total_cmp(&size(a)).then(a.cmp(b)));
        Some(over)
    }
}

/// A line with its colour; `None` for a pattern.
pub(crate) type ColoredStroke = (Option<[u8; 3]>, Stroke);

/// What an area is painted with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum CoverPaint {
    /// White, the colour of the paper.
    Paper,
    /// A colour, or a pattern.
    Ink(Option<[u8; 3]>),
}

/// A painted area.
#[derive(Debug)]
struct Cover {
    area: ClipArea,
    bounds: Rect,
    paint: CoverPaint,
    /// Whether it hides what is under it.
    hides: bool,
    /// The area as polygons, computed on demand; `None` if too complex.
    polygons: OnceCell<Option<Polygons>>,
}

impl Cover {
    fn polygons(&self) -> Option<&Polygons> {
        self.polygons.get_or_init(|| self.area.polygons()).as_ref()
    }
}

/// The parts of an area outside these covers: first the largest few are subtracted, then more and
/// more at a time.
fn seen(area: &Area, covers: &[&Cover]) -> Option<Area> {
    let mut seen = Polygons::new(&area.rings, area.rule)?;
    let (mut rest, mut count) = (covers, 2);
    while !rest.is_empty() && !seen.is_empty() {
        let (some, others) = rest.split_at(count.min(rest.len()));
        let some: Option<Vec<&Polygons>> = some.iter().map(|item| item.polygons()).collect();
        seen = seen.difference(some?)?;
        (rest, count) = (others, 2 * count);
    }
    Some(seen.into_area())
}

/// The cost of finding a cover and adding it, in edge tests.
const LOOKS_FOR_COVER: usize = 10;
/// The cost of subtracting a corner of a cover from an area, in edge tests.
const LOOKS_FOR_CORNER: usize = 20;
