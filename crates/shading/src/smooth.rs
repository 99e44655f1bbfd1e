//! Smoothing that keeps edges.

use dobot_geometry::CancelToken;

use crate::tone::Tone;

/// Smooths each tone with its neighbours, less the more they differ (Perona-Malik diffusion): grain
/// and gentle gradients become smooth while edges stay.
pub(crate) fn smoothed(tone: &Tone, cancel: &CancelToken) -> Tone {
    let mut smooth = tone.clone();
    let mut before = Vec::with_capacity(tone.ink.len());
    for _ in 0..ROUNDS {
        before.clear();
        before.extend_from_slice(&smooth.ink);
        round(&before, &mut smooth, cancel);
    }
    smooth
}

fn round(before: &[f32], tone: &mut Tone, cancel: &CancelToken) {
    let (width, height) = (tone.width, tone.height);
    // A flow into one cell is one out of its neighbour: each is computed once, and none crosses an edge.
    let (mut from_below, mut to_above) = (vec![0.0; width], vec![0.0; width]);
    let mut from_right = vec![0.0; width + 1];
    for y in (0..height).take_while(|_| !cancel.is_cancelled()) {
        let row = |y: usize| &before[y * width..][..width];
        let (here, below) = (row(y), row((y + 1).min(height - 1)));
        flows(here, below, &mut from_below);
        flows(here, &here[1..], &mut from_right[1..width]);
        let (to_left, from_right) = (&from_right[..width], &from_right[1..]);
        let ink = &mut tone.ink[y * width..][..width];
        for x in 0..width {
            let sum = from_below[x] - to_above[x] - to_left[x] + from_right[x];
            ink[x] = here[x] + SPEED * sum;
        }
        std::mem::swap(&mut from_below, &mut to_above);
    }
}

/// Sets the flow into each of these cells from the other.
fn flows(here: &[f32], others: &[f32], into: &mut [f32]) {
    for ((into, own), other) in into.iter_mut().zip(here).zip(others) {
        *into = flow(other - own);
    }
}

fn flow(difference: f32) -> f32 {
    let steep = difference / EDGE;
    difference / (1.0 + steep * steep)
}

const ROUNDS: usize = 40;
/// At most a quarter for stability.
const SPEED: f32 = 0.22;
/// The difference between neighbours that counts as an edge.
const EDGE: f32 = 0.06;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tone::as_ink;
    use dobot_geometry::Point;

    #[test]
    fn grain_is_removed_and_edges_stay() {
        let grain = |i: usize| if i.is_multiple_of(2) { 0.02 } else { -0.02 };
        let ink = |i: usize| as_ink(if i % 20 < 10 { 0.2 } else { 0.8 } + grain(i + i / 20));
        let tone = Tone {
            width: 20,
            height: 20,
            cell: Point::new(1.0, 1.0),
            ink: (0..400).map(ink).collect(),
        };
        for (i, ink) in smoothed(&tone, &CancelToken::default())
            .ink
            .into_iter()
            .enumerate()
        {
            let wanted = if i % 20 < 10 { 0.2 } else { 0.8 };
            assert!((ink - wanted).abs() < 0.05, "{i}: {ink}");
            let far = (i % 20).abs_diff(9) > 4;
            assert!(!far || (ink - wanted).abs() < 0.005, "{i}: {ink}");
        }
    }
}
