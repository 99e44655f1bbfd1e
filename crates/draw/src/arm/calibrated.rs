//! Conversion of a drawing to the raw positions of a calibrated arm.

use dobot_api::PaperPlane;
use dobot_arm::Position;
use dobot_geometry::{HeightMap, Point, Stroke, steps};
use dobot_plan::{DrawingTool, Paper, Pass};

use crate::layout::place::PlaceError;
use crate::options::OptionsError;
use crate::prepare::Settings;

/// Returns the paper of a calibration.
///
/// # Errors
///
/// [`OptionsError::NoSurface`] if its heights span no surface.
pub fn known_paper(known: &PaperPlane) -> Result<Paper, OptionsError> {
    let paper = Paper::sloping(known.plane());
    if known.heights.is_empty() {
        return Ok(paper);
    }
    let heights = HeightMap::through(&known.heights).ok_or(OptionsError::NoSurface)?;
    Ok(paper.bent(heights))
}

/// Converts passes to raw positions.
pub(crate) fn raw_passes(passes: Vec<Pass>, settings: &Settings) -> Result<Vec<Pass>, PlaceError> {
    let raw = |pass: Pass| {
        let strokes = raw_strokes(pass.strokes, pass.tool, settings)?;
        Ok(Pass { strokes, ..pass })
    };
    passes.into_iter().map(raw).collect()
}

/// Converts strokes to raw positions; straight lines on the paper become curved.
pub(crate) fn raw_strokes(
    strokes: Vec<Stroke>,
    tool: DrawingTool,
    settings: &Settings,
) -> Result<Vec<Stroke>, PlaceError> {
    let Some(known) = &settings.calibration else {
        return Ok(strokes);
    };
    let arm = known.arm();
    let paper = known
        .paper
        .as_ref()
        .and_then(|paper| known_paper(paper).ok());
    let raw = |p: Point| {
        let z_mm = paper.as_ref().map_or(0.0, |paper| paper.z_at(p));
        let there = Position::new(p.x, p.y, z_mm);
        let raw = arm.raw_place(there, tool.end_effector());
        let raw = raw.map_err(|reason| PlaceError::OutOfReach {
            x_mm: p.x,
            y_mm: p.y,
            z_mm,
            reason: reason.to_string(),
        })?;
        Ok(Point::new(raw.x.0, raw.y.0))
    };
    let stroke = |stroke: Stroke| {
        let points = dense(&stroke.points).into_iter().map(raw);
        Ok(Stroke {
            points: points.collect::<Result<_, _>>()?,
            ..stroke
        })
    };
    strokes.into_iter().map(stroke).collect()
}

/// Splits the lines of a stroke so that they stay on curved paper.
pub(crate) fn shortened(stroke: Stroke, paper: &Paper) -> Stroke {
    if !paper.is_curved() {
        return stroke;
    }
    let mut points: Vec<Point> = stroke.points.first().copied().into_iter().collect();
    for pair in stroke.points.windows(2) {
        halved(pair[0], pair[1], paper, &mut points);
    }
    Stroke { points, ..stroke }
}

/// Appends the path from `a`, which is there already, to `b`.
fn halved(a: Point, b: Point, paper: &Paper, points: &mut Vec<Point>) {
    let middle = a.midpoint(b);
    let ends = [paper.z_at(a), paper.z_at(b)];
    let is_off = |share: f64| {
        let straight_mm = ends[0] + (ends[1] - ends[0]) * share;
        (paper.z_at(a.lerp(b, share)) - straight_mm).abs() > OFF_PAPER_MM
    };
    // Paper with an S-shaped bend may meet the line in the middle, so check three places.
    let is_off = [0.25, 0.5, 0.75].into_iter().any(is_off);
    if is_off && a.distance(b) > SHORTEST_MM {
        halved(a, middle, paper, points);
        halved(middle, b, paper, points);
    } else {
        points.push(b);
    }
}

/// Returns the points with more points in between where they are far apart.
fn dense(points: &[Point]) -> Vec<Point> {
    let mut all: Vec<Point> = points.first().copied().into_iter().collect();
    for pair in points.windows(2) {
        all.extend(steps(pair[0], pair[1], STEP_MM).skip(1));
    }
    all
}

/// A line of this length bends by less than a hundredth of a millimetre, even with zero errors of
/// 25 degrees.
const STEP_MM: f64 = 4.0;
/// The maximum distance of a vector from the paper between its ends: less than the travel of the
/// pen's spring.
const OFF_PAPER_MM: f64 = 0.02;
const SHORTEST_MM: f64 = 1.0;
