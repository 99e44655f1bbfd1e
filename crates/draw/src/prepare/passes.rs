//! From layers to passes: the lines of each layer, clipped and ordered.

use dobot_arm::Position;
use dobot_geometry::{Point, Rect, Stroke, bounds};
use dobot_import::{Layer, Warning};
use dobot_plan::{DrawingTool, Pass};

use super::layers;
use super::{MAX_REACH_MM, PrepareError, Settings, beside_mm};
use crate::arm::calibrated::raw_strokes;
use crate::layout::clip::{Clipped, clip_to_reach};
use crate::layout::place::PlaceError;
use crate::preparation::progress::PrepareStep;
use crate::strokes::cutting::{inner_first, layers_inner_first};
use crate::strokes::duplicate_lines::without_duplicates;
use crate::strokes::hatch::{Hatch, HatchError, HatchStyle, hatch_until};
use crate::strokes::merge::merge;
use crate::strokes::order::order_until;

/// Converts layers to ordered passes, and returns the omitted layers beside them: holes also count
/// for parts that are cut in another layer.
pub(super) fn passes<E>(
    layers: Vec<Layer>,
    left_out: Vec<Layer>,
    settings: &Settings,
    reachable: &impl Fn(Position) -> Result<(), E>,
    warnings: &mut Vec<Warning>,
) -> Result<Vec<Pass>, PrepareError> {
    let count = if layers.len() > 1 { layers.len() } else { 0 };
    settings.progress.begin(PrepareStep::Ordering, count);
    let (mut laid, mut has_lines, mut pause) = (Vec::new(), false, None);
    for mut layer in layers {
        settings.cancel.check()?;
        let tool = layers::tool(&layer, settings);
        let lines = Lines::of(&mut layer, tool, settings, warnings)?;
        has_lines |= !lines.is_empty();
        let lines = lines.on_sheet(settings, warnings)?;
        let lines = lines.try_map(|stroke| raw_strokes(stroke, tool, settings))?;
        settings.cancel.check()?;
        let lines = lines.within_reach(tool, settings, reachable, warnings);
        settings.cancel.check()?;
        // Areas without hatching leave no ink, but a pause before them is made before the next.
        pause = layer.pause.take().or(pause);
        if !lines.is_empty() {
            layer.pause = pause.take();
            let lines = lines.joined(tool, settings, warnings);
            laid.push(LaidLayer { layer, tool, lines });
        }
    }
    if has_lines && laid.is_empty() {
        return Err(PrepareError::AllCutOff);
    }
    if settings.tries.is_some() {
        laid = inner_layers_first(laid, warnings);
    }
    let several = laid.len() + left_out.len() > 1;
    let shapes = laid.iter().filter(|_| several);
    let mut shapes: Vec<Vec<Stroke>> = shapes.map(|layer| layer.cut_shapes(settings)).collect();
    for mut layer in left_out {
        let tool = layers::tool(&layer, settings);
        if !settings.cutting_of(tool).is_asked_for() {
            continue;
        }
        let own = raw_strokes(std::mem::take(&mut layer.strokes), tool, settings)?;
        let lines = Lines {
            own,
            fills: Vec::new(),
            whole: Vec::new(),
        }
        .joined(tool, settings, &mut Vec::new());
        shapes.push(LaidLayer { layer, tool, lines }.cut_shapes(settings));
    }
    let Rect { x1, y1, .. } = settings.placement.area;
    let mut here = Point::new(x1, y1);
    let mut passes = Vec::<Pass>::new();
    for (number, LaidLayer { layer, tool, lines }) in laid.into_iter().enumerate() {
        settings.cancel.check()?;
        let others = shapes.iter().enumerate().filter(|shape| shape.0 != number);
        let others: Vec<&Stroke> = others.flat_map(|shape| shape.1).collect();
        let strokes = lines.finished(&others, here, tool, settings, warnings);
        settings.progress.advance(1);
        here = strokes.last().and_then(Stroke::last).unwrap_or(here);
        let message = layers::message(&layer, passes.last(), settings);
        passes.push(Pass {
            name: layer.name,
            color: layer.color,
            tool,
            strokes,
            message,
        });
    }
    Ok(passes)
}

/// A layer with its tool and its lines on the paper.
#[derive(Debug)]
struct LaidLayer {
    layer: Layer,
    tool: DrawingTool,
    lines: Lines,
}

impl LaidLayer {
    /// Returns the closed shapes that are cut out, if cutting options apply.
    fn cut_shapes(&self, settings: &Settings) -> Vec<Stroke> {
        if !settings.cutting_of(self.tool).is_asked_for() {
            return Vec::new();
        }
        let shapes = self.lines.own.iter().filter(|stroke| stroke.closed);
        shapes.cloned().collect()
    }
}

/// Orders layers: engraved layers come before cut ones, and cut layers inside the shapes of others
/// before those, because cut-out parts may have fallen or moved.
fn inner_layers_first(laid: Vec<LaidLayer>, warnings: &mut Vec<Warning>) -> Vec<LaidLayer> {
    let (cut, mut sorted): (Vec<_>, Vec<_>) = laid.into_iter().partition(|layer| layer.tool.cuts());
    let lines = cut
        .iter()
        .map(|layer| layer.lines.own.iter().chain(&layer.lines.whole));
    let lines: Vec<Vec<&Stroke>> = lines.map(Iterator::collect).collect();
    let (order, too_late) = layers_inner_first(&lines);
    let mut cut: Vec<Option<LaidLayer>> = cut.into_iter().map(Some).collect();
    sorted.extend(order.into_iter().filter_map(|index| cut[index].take()));
    warnings.extend(counted(
        too_late,
        "layer inside shapes that are cut earlier",
        "cut anyway: two layers are inside each other",
    ));
    sorted
}

/// The lines of a layer.
#[derive(Debug)]
struct Lines {
    own: Vec<Stroke>,
    /// The hatching of its areas, if it must stay separate: rings of a hatching are not the edges
    /// of parts that a laser cuts out.
    fills: Vec<Stroke>,
    /// The closed shapes of a cut layer before duplicates were removed: their content must be cut
    /// before the rest of their edges.
    whole: Vec<Stroke>,
}

impl Lines {
    fn of(
        layer: &mut Layer,
        tool: DrawingTool,
        settings: &Settings,
        warnings: &mut Vec<Warning>,
    ) -> Result<Self, PrepareError> {
        let (mut own, mut fills) = (std::mem::take(&mut layer.strokes), Vec::new());
        let mut entangled = 0;
        if let Some(hatching) = &settings.hatch {
            let straight = Hatch {
                style: HatchStyle::Lines,
                ..*hatching
            };
            for area in &layer.areas {
                let hatched = match hatch_until(area, hatching, &settings.cancel) {
                    Err(HatchError::Entangled) => {
                        entangled += 1;
                        hatch_until(area, &straight, &settings.cancel)
                    }
                    hatched => hatched,
                };
                fills.append(&mut hatched?);
            }
        }
        warnings.extend(counted(
            entangled,
            "area",
            "hatched with lines, because its edge crosses itself too often",
        ));
        if !tool.cuts() {
            own.append(&mut fills);
        }
        Ok(Self {
            own,
            fills,
            whole: Vec::new(),
        })
    }

    fn is_empty(&self) -> bool {
        self.own.is_empty() && self.fills.is_empty()
    }

    fn map(self, mut change: impl FnMut(Vec<Stroke>) -> Vec<Stroke>) -> Self {
        Self {
            own: change(self.own),
            fills: change(self.fills),
            whole: self.whole,
        }
    }

    fn try_map<E>(self, change: impl Fn(Vec<Stroke>) -> Result<Vec<Stroke>, E>) -> Result<Self, E> {
        Ok(Self {
            own: change(self.own)?,
            fills: change(self.fills)?,
            whole: self.whole,
        })
    }

    /// Clips the lines to the sheet if requested.
    fn on_sheet(
        self,
        settings: &Settings,
        warnings: &mut Vec<Warning>,
    ) -> Result<Self, PlaceError> {
        let placement = &settings.placement;
        let Some(sheet) = placement.sheet else {
            return Ok(self);
        };
        let room = sheet.without_margin(placement.margin_mm);
        if placement.clips {
            let is_on = |p| room.beyond_mm(p) <= ON_EDGE_MM;
            let within = bounds(room.corners()).inflate(ON_EDGE_MM, ON_EDGE_MM);
            return Ok(self.clipped("layer beyond the sheet", within, is_on, warnings));
        }
        let points = self
            .own
            .iter()
            .chain(&self.fills)
            .flat_map(|stroke| &stroke.points);
        let beyond = points.map(|&p| (room.beyond_mm(p), p));
        match beyond.max_by(|a, b| a.0.total_cmp(&b.0)) {
            Some((by_mm, p)) if by_mm > ON_SHEET_MM => Err(PlaceError::BeyondSheet {
                by_mm,
                margin_mm: placement.margin_mm,
                x_mm: p.x,
                y_mm: p.y,
            }),
            _ => Ok(self),
        }
    }

    /// Clips the lines to the positions that the arm reaches with the tool down and lifted,
    /// including all positions beside the strokes, if requested.
    fn within_reach<E>(
        self,
        tool: DrawingTool,
        settings: &Settings,
        reachable: &impl Fn(Position) -> Result<(), E>,
        warnings: &mut Vec<Warning>,
    ) -> Self {
        if !settings.placement.clips {
            return self;
        }
        let reaches = |p: Point| {
            let z_mm = settings.paper.z_at(p);
            let reaches = |z_mm| reachable(Position::new(p.x, p.y, z_mm)).is_ok();
            // Cancelled lines are not needed any more.
            !settings.cancel.is_cancelled() && reaches(z_mm) && reaches(z_mm + tool.lift_mm())
        };
        let beside_mm = beside_mm(tool, settings);
        let is_in = |p| around(p, beside_mm).into_iter().all(&reaches);
        let farthest_mm = f64::from(MAX_REACH_MM);
        let within =
            Rect::from_origin_size(Point::ORIGIN, (0.0, 0.0)).inflate(farthest_mm, farthest_mm);
        self.clipped("layer out of reach", within, is_in, warnings)
    }

    fn clipped(
        self,
        what: &str,
        within: Rect,
        inside: impl Fn(Point) -> bool,
        warnings: &mut Vec<Warning>,
    ) -> Self {
        let [own, fills] =
            [self.own, self.fills].map(|strokes| clip_to_reach(&strokes, within, &inside));
        let cut_mm = own.cut_mm + fills.cut_mm;
        let cut_dots = own.cut_dots + fills.cut_dots;
        if !(own.is_whole() && fills.is_whole()) {
            let instead =
                format!("{cut_mm:.0} mm of its lines and {cut_dots} of its dots are cut off");
            warnings.extend(counted(1, what, &instead));
        }
        let [own, fills] = [own, fills].map(|Clipped { strokes, .. }| strokes);
        Self { own, fills, ..self }
    }

    /// Joins lines that meet, and removes duplicates if requested.
    fn joined(self, tool: DrawingTool, settings: &Settings, warnings: &mut Vec<Warning>) -> Self {
        let stay_whole = settings.cutting_of(tool).is_asked_for();
        let (mut duplicates, mut unknown) = (0, 0);
        let mut whole = Vec::new();
        if settings.drops_duplicates && tool.cuts() {
            whole = merge(self.own.clone(), settings.join_mm());
            whole.retain(|stroke| stroke.closed);
        }
        let lines = self.map(|strokes| {
            if !settings.drops_duplicates {
                return strokes;
            }
            let single = without_duplicates(strokes, stay_whole);
            duplicates += single.duplicates;
            unknown += single.unknown;
            single.strokes
        });
        warnings.extend(counted(duplicates, "duplicate line", "drawn once"));
        warnings.extend(counted(
            unknown,
            "line",
            "not compared with the others: there are too many in one place",
        ));
        let lines = lines.map(|strokes| merge(strokes, settings.join_mm()));
        if tool.cuts() || stay_whole {
            warnings.extend(with_gaps(&lines.own, settings.join_mm()));
        }
        Self { whole, ..lines }
    }

    /// Returns the strokes as drawn, for a tool that comes from `here`: ordered, with the cuts of a
    /// laser beside those in other layers, or with the repetitions of a pen.
    fn finished(
        self,
        others: &[&Stroke],
        here: Point,
        tool: DrawingTool,
        settings: &Settings,
        warnings: &mut Vec<Warning>,
    ) -> Vec<Stroke> {
        if !tool.burns() {
            return drawn_by_pen(self.own, here, tool, settings);
        }
        let cutting = settings.cutting_of(tool);
        let offset = cutting.offset(self.own, others, settings.flatten_mm());
        let groups = if tool.cuts() && settings.tries.is_some() {
            inner_first(offset.strokes, &self.whole)
        } else {
            vec![offset.strokes]
        };
        // The hatching of parts is burned before they are cut out.
        let mut strokes = in_order(vec![self.fills], here, tool, settings);
        let here = strokes.last().and_then(Stroke::last).unwrap_or(here);
        let cut = cutting.finished(in_order(groups, here, tool, settings), others);
        strokes.extend(cut.strokes);
        warnings.extend(counted(
            offset.vanished,
            "narrow shape",
            "omitted, because the beam is wider",
        ));
        warnings.extend(counted(
            offset.entangled,
            "shape",
            "cut without the kerf, because its edge crosses itself too often",
        ));
        warnings.extend(counted(
            cut.too_small,
            "shape",
            "too small for tabs, cut all around",
        ));
        warnings.extend(counted(
            cut.short_of_room,
            "shorter lead-in",
            "the waste beside the cut is too narrow",
        ));
        strokes
    }
}

/// Warns about outlines with gaps: they are not cut out as shapes, have no kerf, and their content
/// may be cut later. Parallel lines are not an outline, nor are shapes barely wider than their
/// gaps.
fn with_gaps(strokes: &[Stroke], join_mm: f64) -> Option<Warning> {
    let open: Vec<Stroke> = strokes
        .iter()
        .filter(|stroke| !stroke.closed)
        .cloned()
        .collect();
    let closed = |by_mm: f64| {
        let shapes = merge(open.clone(), by_mm);
        let wide = |stroke: &&Stroke| stroke.closed && width_mm(stroke) > MUCH_WIDER * by_mm;
        shapes.iter().filter(wide).count()
    };
    let wider = GAPS_MM.into_iter().filter(|&mm| mm > join_mm);
    let tried: Vec<(f64, usize)> = wider.map(|mm| (mm, closed(mm))).collect();
    let most = tried.iter().map(|gap| gap.1).max()?;
    let (by_mm, count) = tried.into_iter().find(|gap| gap.1 == most)?;
    let instead = format!("not cut out as shapes: `way.join {by_mm}` closes them");
    counted(count, "open outline", &instead)
}

/// Returns the width of a long shape with this area and perimeter.
fn width_mm(shape: &Stroke) -> f64 {
    let first = shape.points[0];
    let part = |pair: &[Point]| (pair[0] - first).cross(pair[1] - first);
    let twice_mm2: f64 = shape.points.windows(2).map(part).sum();
    twice_mm2.abs() / shape.length_mm()
}

/// Orders the strokes of a pen that comes from `here`, each repeated as requested.
fn drawn_by_pen(
    own: Vec<Stroke>,
    here: Point,
    tool: DrawingTool,
    settings: &Settings,
) -> Vec<Stroke> {
    let repeated = |strokes: Vec<Stroke>| {
        let strokes = strokes.into_iter();
        strokes.map(|stroke| gone_over(stroke, settings.pen_passes))
    };
    if settings.joins_dots() {
        // Only the whole line can be repeated without lifting the pen.
        let line = in_order(vec![own], here, tool, settings);
        return repeated(line).collect();
    }
    // Repetition moves the ends of a stroke, on which the best order depends.
    in_order(vec![repeated(own).collect()], here, tool, settings)
}

/// Orders groups of strokes one after another, for a tool that comes from `here`.
fn in_order(
    groups: Vec<Vec<Stroke>>,
    mut here: Point,
    tool: DrawingTool,
    settings: &Settings,
) -> Vec<Stroke> {
    let mut all = Vec::new();
    for group in groups.into_iter().filter(|group| !group.is_empty()) {
        let group = match settings.search(tool) {
            Some(search) => order_until(group, here, &search, &settings.cancel),
            None => group,
        };
        all.append(&mut if settings.joins_dots() {
            one_line(group)
        } else {
            group
        });
        here = all.last().and_then(Stroke::last).unwrap_or(here);
    }
    all
}

/// Returns the points beside a point: towards the arm's axis, away from it, and to both sides. The
/// borders of the reach are arcs around the axis and lines towards it.
fn around(p: Point, by_mm: f64) -> [Point; 4] {
    let from_axis = p.to_vec2();
    let out = from_axis * (by_mm / from_axis.hypot().max(by_mm));
    let aside = out.turn_90();
    [p + out, p - out, p + aside, p - aside]
}

pub(super) fn counted(count: usize, what: &str, instead: &str) -> Option<Warning> {
    (count > 0).then(|| Warning::new(what, instead, count))
}

/// Repeats a stroke without lifting the pen: a closed one continues around, an open one goes back
/// and forth.
fn gone_over(mut stroke: Stroke, times: u32) -> Stroke {
    if times < 2 {
        return stroke;
    }
    let once = stroke.points.clone();
    let is_loop = once.len() > 2 && once.first() == once.last();
    for time in 1..times {
        let mut again = once.clone();
        if !is_loop && time % 2 == 1 {
            again.reverse();
        }
        stroke.points.extend(again.into_iter().skip(1));
    }
    stroke
}

/// Joins all strokes to one, in order.
fn one_line(strokes: Vec<Stroke>) -> Vec<Stroke> {
    let points: Vec<Point> = strokes
        .into_iter()
        .flat_map(|stroke| stroke.points)
        .collect();
    vec![Stroke::open(points)]
}

/// The distance beyond the edge that counts as on the sheet: pages in inches are rounded.
const ON_SHEET_MM: f64 = 0.5;
/// Gaps in outlines that are probably unintended.
const GAPS_MM: [f64; 4] = [0.1, 0.2, 0.5, 1.0];
/// The minimum ratio of an outline's width to its gaps.
const MUCH_WIDER: f64 = 5.0;
/// The distance beyond the edge that is not cut off.
const ON_EDGE_MM: f64 = 0.05;
