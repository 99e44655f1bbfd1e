//! The resampling of pixels to a grid of tones suitable for a pen.

use dobot_geometry::Point;

use crate::tone::{Tone, as_ink, cell, count};

/// Resamples grey pixels (255 is white) to a grid of `width` by `height` tones over a page.
///
/// A cell that covers several pixels gets their mean; a cell smaller than a pixel is interpolated
/// between the nearest two.
pub(crate) fn resample(grey: &[u8], stored: [usize; 2], grid: [usize; 2], page: Point) -> Tone {
    let [width, height] = grid;
    let columns = shares(stored[0], width);
    let mut narrow = Vec::with_capacity(width * stored[1]);
    for row in grey.chunks(stored[0]) {
        narrow.extend(columns.iter().map(|share| share.of(row)));
    }
    let mut ink = Vec::with_capacity(width * height);
    for share in shares(stored[1], height) {
        ink.extend(share.of_rows(&narrow, width).map(|grey| 1.0 - grey / 255.0));
    }
    Tone {
        width,
        height,
        cell: Point::new(page.x / count(width), page.y / count(height)),
        ink,
    }
}

/// The weights of the pixels of a row for each cell.
struct CellWeights {
    first: usize,
    parts: Vec<f32>,
}

impl CellWeights {
    fn of(&self, row: &[u8]) -> f32 {
        let parts = self.parts.iter().zip(&row[self.first..]);
        parts.map(|(part, &grey)| part * f32::from(grey)).sum()
    }

    fn of_rows(&self, ink: &[f32], width: usize) -> std::vec::IntoIter<f32> {
        let mut sums = vec![0.0; width];
        let rows = ink.chunks(width).skip(self.first);
        for (part, row) in self.parts.iter().zip(rows) {
            for (sum, ink) in sums.iter_mut().zip(row) {
                *sum += part * ink;
            }
        }
        sums.into_iter()
    }
}

fn shares(pixels: usize, cells: usize) -> Vec<CellWeights> {
    let size = count(pixels) / count(cells);
    let of_cell = |i: usize| {
        if size > 1.0 {
            covered(count(i) * size, count(i + 1) * size, pixels)
        } else {
            between((count(i) + 0.5) * size - 0.5, pixels)
        }
    };
    (0..cells).map(of_cell).collect()
}

/// The pixels between two places, weighted by coverage.
fn covered(from: f64, to: f64, pixels: usize) -> CellWeights {
    let (first, last) = (cell(from, pixels), cell(to, pixels));
    let part = |i: usize| (to.min(count(i + 1)) - from.max(count(i))).max(0.0);
    let parts: Vec<f64> = (first..=last).map(part).collect();
    let all: f64 = parts.iter().sum();
    let parts = parts.iter().map(|part| as_ink(part / all)).collect();
    CellWeights { first, parts }
}

/// The two pixels around a place, weighted by distance.
fn between(place: f64, pixels: usize) -> CellWeights {
    let place = place.clamp(0.0, count(pixels - 1));
    let first = cell(place, pixels);
    let t = as_ink(place - count(first));
    let parts = if first + 1 < pixels {
        vec![1.0 - t, t]
    } else {
        vec![1.0]
    };
    CellWeights { first, parts }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn a_cell_is_the_mean_of_the_pixels_it_covers() {
        let grey = [0, 255, 255, 0, 0, 0];
        let tone = resample(&grey, [6, 1], [4, 1], Point::new(6.0, 1.0));
        let wanted = [2.0 / 3.0, 0.0, 1.0, 1.0];
        for (ink, wanted) in tone.ink.iter().zip(wanted) {
            assert!((ink - wanted).abs() < 1e-6, "{:?}", tone.ink);
        }
    }

    proptest! {
        #[test]
        fn an_even_tone_stays_even(
            stored in [1..40_usize, 1..40_usize],
            grid in [1..40_usize, 1..40_usize],
        ) {
            let grey = vec![51; stored[0] * stored[1]];
            let tone = resample(&grey, stored, grid, Point::new(1.0, 1.0));
            prop_assert_eq!(tone.ink.len(), grid[0] * grid[1]);
            for ink in tone.ink {
                prop_assert!((ink - 0.8).abs() < 1e-5, "{}", ink);
            }
        }
    }
}
