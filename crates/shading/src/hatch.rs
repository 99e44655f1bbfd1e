//! Straight hatch lines, in more directions in darker areas.

use dobot_geometry::{CancelToken, Point, Stroke, steps};

use crate::rows::{Rows, strokes};
use crate::shading::Shading;
use crate::smooth::smoothed;
use crate::tone::{Tone, count};

/// Hatches a page. Each level adds a direction, at first with every other line only.
///
/// The lines of a direction are on one grid for the whole page, so that levels match. `spacing_mm`
/// is on the page. Pieces and gaps shorter than about a spacing are omitted.
pub(crate) fn hatched(
    tone: &Tone,
    shading: &Shading,
    spacing_mm: f64,
    cancel: &CancelToken,
) -> Vec<Stroke> {
    let tone = smoothed(tone, cancel).blurred(SOFTNESS * spacing_mm, cancel);
    let set = |level: u8| {
        let rows = Rows {
            page: tone.page(),
            margin_mm: 0.0,
            spacing_mm,
            angle_deg: shading.angle_deg + turn_deg(level),
        };
        let steps = [2 * level, 2 * level + 1].map(|value| threshold(value, 2 * shading.levels));
        let lines = rows.lines().into_iter().zip(steps.into_iter().cycle());
        let lines = lines.take_while(|_| !cancel.is_cancelled());
        let pieces = |(line, threshold)| pieces(&tone, &rows, line, threshold);
        strokes(
            lines.map(pieces).collect(),
            REACH * spacing_mm,
            shading.apart,
        )
    };
    (0..shading.levels).flat_map(set).collect()
}

/// The darkness at which a step of the hatching starts.
fn threshold(step: u8, steps: u8) -> f64 {
    (f64::from(step) + 0.7) / f64::from(steps)
}

/// Each direction halves the widest gap between the earlier ones: 0, 90, 45, 135, then those
/// between.
fn turn_deg(level: u8) -> f64 {
    const TURNS_DEG: [f64; 8] = [0.0, 90.0, 45.0, 135.0, 22.5, 112.5, 67.5, 157.5];
    TURNS_DEG[usize::from(level) % TURNS_DEG.len()]
}

fn pieces(tone: &Tone, rows: &Rows, [a, b]: [Point; 2], threshold: f64) -> Vec<Vec<Point>> {
    let place = |mm: f64| a + rows.along() * mm;
    let runs = cleaned(runs(tone, [a, b], threshold), rows.spacing_mm);
    let ends = runs
        .into_iter()
        .map(|(from, to)| vec![place(from), place(to)]);
    ends.collect()
}

/// The ranges in which a line is darker than the threshold, in millimetres from its start.
fn runs(tone: &Tone, [a, b]: [Point; 2], threshold: f64) -> Vec<(f64, f64)> {
    let length_mm = a.distance(b);
    let cell_mm = tone.cell.x.min(tone.cell.y);
    let places = steps(a, b, cell_mm);
    let step_mm = length_mm / (length_mm / cell_mm).ceil().max(1.0);
    let mut runs = Vec::new();
    let mut began = None;
    let mut before = tone.at(a);
    for (i, p) in places.enumerate() {
        let ink = tone.at(p);
        let back = ((ink - threshold) / (ink - before)).clamp(0.0, 1.0);
        let crossing_mm = || step_mm * (count(i) - back);
        match began {
            None if i == 0 && ink >= threshold => began = Some(0.0),
            None if ink >= threshold => began = Some(crossing_mm()),
            Some(from) if ink < threshold => {
                runs.push((from, crossing_mm()));
                began = None;
            }
            _ => {}
        }
        before = ink;
    }
    runs.extend(began.map(|from| (from, length_mm)));
    runs
}

/// Bridges short gaps, then drops short pieces.
fn cleaned(runs: Vec<(f64, f64)>, spacing_mm: f64) -> Vec<(f64, f64)> {
    let mut whole: Vec<(f64, f64)> = Vec::with_capacity(runs.len());
    for run in runs {
        match whole.last_mut() {
            Some(before) if run.0 - before.1 < SHORTEST_GAP * spacing_mm => before.1 = run.1,
            _ => whole.push(run),
        }
    }
    whole.retain(|(from, to)| to - from >= spacing_mm);
    whole
}

/// The smoothing radius of tones before comparison, in spacings.
const SOFTNESS: f64 = 0.2;
/// The largest gap between pieces over which the pen stays down, in spacings.
const REACH: f64 = 1.6;
/// The shortest gap, in spacings.
const SHORTEST_GAP: f64 = 0.75;
