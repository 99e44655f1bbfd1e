//! The borders between tones.

use dobot_geometry::{CancelToken, Point, Stroke, Vec2};

use crate::contour::contours;
use crate::levels::Histogram;
use crate::shading::Shading;
use crate::smooth::smoothed;
use crate::tone::{Tone, count};

/// Draws the borders between the tones of a page as smooth lines, closed unless they end at the
/// page's border.
///
/// Grain finer than `spacing_mm` (on the page) is smoothed, and smaller areas are left out. So are
/// borders along a gentle gradient, such as a darkening sky, unless a threshold is set.
pub(crate) fn outlines(
    tone: &Tone,
    shading: &Shading,
    spacing_mm: f64,
    cancel: &CancelToken,
) -> Vec<Stroke> {
    let tone = smoothed(tone, cancel);
    let (thresholds, least) = match shading.threshold {
        Some(threshold) => (vec![threshold], 0.0),
        None => (Histogram::of(&tone).thresholds(shading.levels), GENTLE),
    };
    let tone = tone.blurred(SOFTNESS * spacing_mm, cancel);
    let lines = thresholds
        .iter()
        .take_while(|_| !cancel.is_cancelled())
        .flat_map(|&threshold| contours(&tone, threshold));
    let seen = lines.filter(|line| is_seen(line, spacing_mm));
    seen.filter(|item| steepness(&tone, item, spacing_mm) >= least)
        .collect()
}

/// Whether it is larger than a speck.
fn is_seen(stroke: &Stroke, spacing_mm: f64) -> bool {
    if stroke.closed {
        return area_mm2(&stroke.points) >= SPECK * spacing_mm * spacing_mm;
    }
    stroke.length_mm() >= spacing_mm
}

/// The mean change of tone within a spacing across a line.
fn steepness(tone: &Tone, stroke: &Stroke, spacing_mm: f64) -> f64 {
    let change = |p: Point, way: Vec2| tone.at(p + way) - tone.at(p - way);
    let half = spacing_mm / 2.0;
    let steep = |&p: &Point| change(p, Vec2::new(half, 0.0)).hypot(change(p, Vec2::new(0.0, half)));
    stroke.points.iter().map(steep).sum::<f64>() / count(stroke.points.len())
}

fn area_mm2(ring: &[Point]) -> f64 {
    let twice: f64 = ring
        .windows(2)
        .map(|pair| pair[0].to_vec2().cross(pair[1].to_vec2()))
        .sum();
    twice.abs() / 2.0
}

/// The smoothing radius of tones, in spacings.
const SOFTNESS: f64 = 0.3;
/// The smallest area drawn, in square spacings: a disc 0.8 spacings wide.
const SPECK: f64 = 0.5;
/// The smallest change of tone within a spacing that counts as a border.
const GENTLE: f64 = 0.025;
