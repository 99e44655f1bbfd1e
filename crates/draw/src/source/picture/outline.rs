//! The borders between tones.

use super::contour::contours;
use super::levels::Histogram;
use super::shading::Shading;
use super::smooth::smoothed;
use super::tone::Tone;
use crate::point::{Point, Stroke};

/// Draws the borders between the tones of a page as smooth lines, closed where they do not end at
/// the page's border.
///
/// Grain finer than `spacing_mm` (on the page) is smoothed, and what is smaller than about that
/// is left out.
pub(super) fn outlines(tone: &Tone, shading: &Shading, spacing_mm: f64) -> Vec<Stroke> {
    let tone = smoothed(tone);
    let thresholds = match shading.threshold {
        Some(threshold) => vec![threshold],
        None => Histogram::of(&tone).thresholds(shading.levels),
    };
    let tone = tone.blurred(SOFTNESS * spacing_mm);
    let lines = thresholds.iter().flat_map(|&it| contours(&tone, it));
    lines.filter(|it| is_seen(it, spacing_mm)).collect()
}

/// Whether it is more than a speck.
fn is_seen(stroke: &Stroke, spacing_mm: f64) -> bool {
    if stroke.closed {
        return area_mm2(&stroke.points) >= SPECK * spacing_mm * spacing_mm;
    }
    stroke.length_mm() >= spacing_mm
}

fn area_mm2(ring: &[Point]) -> f64 {
    let twice: f64 = ring.windows(2).map(|it| it[0].cross(it[1])).sum();
    twice.abs() / 2.0
}

/// How far tones are mixed, in spacings.
const SOFTNESS: f64 = 0.3;
/// The smallest area that is drawn, in square spacings: a disc 0.8 spacings wide.
const SPECK: f64 = 0.5;
