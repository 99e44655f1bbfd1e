//! Dots, denser in darker areas.

use dobot_geometry::{CancelToken, Point, Random, Stroke, Vec2};

use crate::shading::Shading;
use crate::tone::Tone;

/// Scatters dots over a page: in black areas about `spacing_mm` (on the page) apart, in lighter
/// ones fewer in proportion, without clumps or rows.
///
/// Error diffusion sets as many dots as the tone needs; then each dot moves to the centroid of its
/// nearest ink, a few times (Lloyd's method). The ink is squared there, because otherwise the
/// density would converge to the root of the ink.
pub(crate) fn stippled(
    tone: &Tone,
    shading: &Shading,
    spacing_mm: f64,
    cancel: &CancelToken,
) -> Vec<Stroke> {
    let mut dots = scattered(tone, shading.seed, spacing_mm);
    if !dots.is_empty() {
        relax(tone, &mut dots, cancel);
    }
    let strokes = dots.into_iter().map(|dot| Stroke::open(vec![dot]));
    strokes.collect()
}

/// Dots at the centers of cells, as many as each tone needs.
fn scattered(tone: &Tone, seed: u64, spacing_mm: f64) -> Vec<Point> {
    let per_cell = tone.cell.x * tone.cell.y / (HEXAGON * spacing_mm * spacing_mm);
    let mut random = Random::new(seed);
    let mut dots = Vec::new();
    // The error of the cells of this row and of the next; one more on both sides.
    let mut here = vec![0.0; tone.width + 2];
    for y in 0..tone.height {
        let mut below = vec![0.0; tone.width + 2];
        for step in 0..tone.width {
            let forward = y.is_multiple_of(2);
            let x = if forward { step } else { tone.width - 1 - step };
            let ink = f64::from(tone.ink[y * tone.width + x]);
            if ink < WHITE {
                // White passes no error to its neighbours.
                continue;
            }
            let owed = here[x + 1] + ink * per_cell;
            let is_dot = owed > 0.5 + SHAKE * (random.share() - 0.5);
            if is_dot {
                dots.push(tone.middle(x, y));
            }
            let rest = if is_dot { owed - 1.0 } else { owed };
            let (ahead, back) = if forward { (x + 2, x) } else { (x, x + 2) };
            here[ahead] += rest * 7.0 / 16.0;
            below[back] += rest * 3.0 / 16.0;
            below[x + 1] += rest * 5.0 / 16.0;
            below[ahead] += rest / 16.0;
        }
        here = below;
    }
    dots
}

/// Moves each dot to the centroid of its nearest ink, repeatedly.
fn relax(tone: &Tone, dots: &mut [Point], cancel: &CancelToken) {
    let mut nearest = Nearest::new(tone, dots);
    for _ in 0..ROUNDS {
        nearest.update(dots, cancel);
        if cancel.is_cancelled() {
            return;
        }
        let middles = middles(tone, &nearest, dots.len());
        for (dot, middle) in dots.iter_mut().zip(middles) {
            // Around a white hole the centroid may be in it.
            if let Some(middle) = middle
                && inked(tone, middle)
            {
                *dot = middle;
            }
        }
    }
}

fn inked(tone: &Tone, p: Point) -> bool {
    f64::from(tone.ink[tone.index(p)]) >= WHITE
}

/// For each dot the centroid of its ink.
fn middles(tone: &Tone, nearest: &Nearest<'_>, dots: usize) -> Vec<Option<Point>> {
    let mut sums = vec![(Vec2::ZERO, 0.0); dots];
    for (i, (&ink, &dot)) in tone.ink.iter().zip(&nearest.dot).enumerate() {
        if f64::from(ink) >= WHITE {
            let weight = f64::from(ink) * f64::from(ink);
            let (sum, all) = &mut sums[dot as usize];
            *sum += tone.middle(i % tone.width, i / tone.width).to_vec2() * weight;
            *all += weight;
        }
    }
    let middle = |(sum, all): (Vec2, f64)| (all > 0.0).then(|| (sum * (1.0 / all)).to_point());
    sums.into_iter().map(middle).collect()
}

/// For each cell the nearest dot.
///
/// A cell takes over the dots of its neighbours, in two sweeps over the page, down and up. Dots
/// move little between rounds, so that the previous result is a good start. An occasional wrong
/// choice between two dots does no harm, because both are nearly as near.
struct Nearest<'a> {
    tone: &'a Tone,
    dot: Vec<u32>,
}

impl<'a> Nearest<'a> {
    fn new(tone: &'a Tone, dots: &[Point]) -> Self {
        let mut dot = vec![NO_DOT; tone.ink.len()];
        for (i, p) in (0..).zip(dots) {
            dot[tone.index(*p)] = i;
        }
        Self { tone, dot }
    }

    fn update(&mut self, dots: &[Point], cancel: &CancelToken) {
        let height = self.tone.height;
        for y in (0..height).take_while(|_| !cancel.is_cancelled()) {
            self.sweep(dots, y, y.checked_sub(1));
        }
        for y in (0..height).rev().take_while(|_| !cancel.is_cancelled()) {
            self.sweep(dots, y, (y + 1 < height).then_some(y + 1));
        }
    }

    /// Takes over nearer dots, from the row before and within the row, to the right and back.
    fn sweep(&mut self, dots: &[Point], y: usize, before: Option<usize>) {
        let width = self.tone.width;
        let mut held = NO_DOT;
        for x in (0..width).chain((0..width).rev()) {
            let far = |dot: u32| {
                let dot = dots.get(dot as usize);
                dot.map_or(f64::INFINITY, |&dot| {
                    (dot - self.tone.middle(x, y)).hypot2()
                })
            };
            let own = y * width + x;
            let mut best = far(held);
            for other in [Some(own), before.map(|before| before * width + x)] {
                let other = other.map_or(NO_DOT, |other| self.dot[other]);
                if other != held && far(other) < best {
                    (best, held) = (far(other), other);
                }
            }
            self.dot[own] = held;
        }
    }
}

const NO_DOT: u32 = u32::MAX;
/// The area of a dot in the densest packing, in square spacings.
const HEXAGON: f64 = 0.866;
/// Less ink counts as white.
const WHITE: f64 = 0.02;
const ROUNDS: usize = 30;
/// The randomness of the initial dots; without it they form patterns.
const SHAKE: f64 = 0.6;
