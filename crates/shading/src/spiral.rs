//! A spiral wave over a page, wider and faster in darker areas.

use std::f64::consts::TAU;

use dobot_geometry::{CancelToken, Point, Stroke, Vec2};

use crate::tone::Tone;
use crate::waves::{FAINT, FASTEST, GO_ON, SHORTEST, SLOWEST, SOFTNESS, WIDEST, strength};

/// Draws a page with a spiral whose turns are `spacing_mm` (on the page) apart, from the center to
/// the corners. In white areas and beyond the page, the pen is lifted.
///
/// Each swing is one vector, because the arm's link is slow: the wave is a zigzag.
pub(crate) fn spiral(tone: &Tone, spacing_mm: f64, cancel: &CancelToken) -> Vec<Stroke> {
    let tone = tone.blurred(SOFTNESS * spacing_mm, cancel);
    let page = tone.page();
    let middle = page.to_vec2() * 0.5;
    let farthest_mm = middle.length();
    let margin_mm = WIDEST * spacing_mm;
    let on_page = |p: Point| {
        let [x, y] = [p.x.min(page.x - p.x), p.y.min(page.y - p.y)];
        x.min(y) >= margin_mm
    };
    let mut strokes = Vec::new();
    let mut piece = Vec::new();
    let (mut angle, mut side) = (0.0_f64, 1.0);
    loop {
        let radius_mm = spacing_mm * angle / TAU;
        if radius_mm > farthest_mm || cancel.is_cancelled() {
            break;
        }
        let out = Vec2::from_angle(angle);
        let place = middle.to_point() + out * radius_mm;
        let ink = if on_page(place) { tone.at(place) } else { 0.0 };
        // Hysteresis: a started line continues a little longer, which avoids dashes.
        let least = FAINT * if piece.is_empty() { 1.0 } else { GO_ON };
        if ink >= least {
            piece.push(place + out * (side * spacing_mm * WIDEST * strength(ink)));
        } else {
            finish(&mut strokes, &mut piece, spacing_mm);
        }
        let step_mm = spacing_mm * (SLOWEST + (FASTEST - SLOWEST) * strength(ink));
        // Near the center a step is at most an eighth of a turn.
        angle += step_mm / radius_mm.max(step_mm / (TAU / 8.0));
        side = -side;
    }
    finish(&mut strokes, &mut piece, spacing_mm);
    strokes
}

fn finish(strokes: &mut Vec<Stroke>, piece: &mut Vec<Point>, spacing_mm: f64) {
    let piece = Stroke::open(std::mem::take(piece));
    if piece.length_mm() >= SHORTEST * spacing_mm {
        strokes.push(piece);
    }
}
