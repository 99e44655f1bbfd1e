//! The darkness of a page, on a grid.

use dobot_geometry::{CancelToken, Point};

use crate::picture::Orientation;

/// The ink of a page, from 0 (white) to 1 (black), on a grid of cells.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tone {
    pub(crate) width: usize,
    pub(crate) height: usize,
    /// A cell's width and height, in millimetres.
    pub(crate) cell: Point,
    /// The cells row by row, from the upper left corner.
    pub(crate) ink: Vec<f32>,
}

impl Tone {
    /// The size of the page in millimetres.
    pub(crate) fn page(&self) -> Point {
        Point::new(
            count(self.width) * self.cell.x,
            count(self.height) * self.cell.y,
        )
    }

    /// The ink at a place on the page, interpolated between cell centers.
    pub(crate) fn at(&self, p: Point) -> f64 {
        let (x0, x1, tx) = around(p.x / self.cell.x, self.width);
        let (y0, y1, ty) = around(p.y / self.cell.y, self.height);
        let ink = |x: usize, y: usize| f64::from(self.ink[y * self.width + x]);
        let mix = |a: f64, b: f64, t: f64| a + (b - a) * t;
        mix(
            mix(ink(x0, y0), ink(x1, y0), tx),
            mix(ink(x0, y1), ink(x1, y1), tx),
            ty,
        )
    }

    /// The center of a cell.
    pub(crate) fn middle(&self, x: usize, y: usize) -> Point {
        Point::new(
            (count(x) + 0.5) * self.cell.x,
            (count(y) + 0.5) * self.cell.y,
        )
    }

    /// The number of the cell at a place.
    pub(crate) fn index(&self, p: Point) -> usize {
        let x = cell(p.x / self.cell.x, self.width);
        cell(p.y / self.cell.y, self.height) * self.width + x
    }

    /// Blurs the tones with the standard deviation `radius_mm`.
    pub(crate) fn blurred(&self, radius_mm: f64, cancel: &CancelToken) -> Self {
        let rows = blur_rows(&self.ink, self.width, radius_mm / self.cell.x, cancel);
        let columns = transposed(&rows, self.width);
        let columns = blur_rows(&columns, self.height, radius_mm / self.cell.y, cancel);
        Self {
            ink: transposed(&columns, self.height),
            ..*self
        }
    }

    /// Rotates and mirrors it by the orientation of a camera.
    pub(crate) fn oriented(mut self, orientation: Orientation) -> Self {
        if orientation.transpose {
            self.ink = transposed(&self.ink, self.width);
            (self.width, self.height) = (self.height, self.width);
            self.cell = Point::new(self.cell.y, self.cell.x);
        }
        if orientation.mirror_x {
            let rows = self.ink.chunks_mut(self.width);
            rows.for_each(<[f32]>::reverse);
        }
        if orientation.mirror_y {
            let rows = self.ink.chunks(self.width).rev();
            self.ink = rows.flatten().copied().collect();
        }
        self
    }

    pub(crate) fn map(&self, tone: impl Fn(f32) -> f32) -> Self {
        Self {
            ink: self.ink.iter().map(|&ink| tone(ink)).collect(),
            ..*self
        }
    }
}

#[expect(clippy::cast_precision_loss, reason = "at most some millions")]
pub(crate) const fn count(n: usize) -> f64 {
    n as f64
}

/// The number of the cell at a place within the grid or slightly outside.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "saturates, and is then cut to the grid"
)]
pub(crate) fn cell(place: f64, cells: usize) -> usize {
    (place as usize).min(cells - 1)
}

/// The two cells whose centers enclose a place, and the fraction from the first to the second.
fn around(place: f64, cells: usize) -> (usize, usize, f64) {
    let place = (place - 0.5).clamp(0.0, count(cells - 1));
    let first = cell(place, cells);
    (first, (first + 1).min(cells - 1), place - count(first))
}

fn transposed(ink: &[f32], width: usize) -> Vec<f32> {
    let height = ink.len() / width;
    let mut columns = vec![0.0; ink.len()];
    for (y, row) in ink.chunks(width).enumerate() {
        for (x, &ink) in row.iter().enumerate() {
            columns[x * height + y] = ink;
        }
    }
    columns
}

/// Gaussian blur along the rows; the edge values continue beyond the edge.
fn blur_rows(ink: &[f32], width: usize, sigma: f64, cancel: &CancelToken) -> Vec<f32> {
    let bell = bell(sigma);
    let reach = bell.len() / 2;
    let mut padded = Vec::with_capacity(width + 2 * reach);
    let mut out = vec![0.0; ink.len()];
    for (row, sums) in ink.chunks(width).zip(out.chunks_mut(width)) {
        if cancel.is_cancelled() {
            sums.copy_from_slice(row);
            continue;
        }
        padded.clear();
        padded.extend(std::iter::repeat_n(row[0], reach));
        padded.extend_from_slice(row);
        padded.extend(std::iter::repeat_n(row[width - 1], reach));
        // One neighbour of all cells after another: several cells at a time.
        for (near, share) in padded.windows(width).zip(&bell) {
            for (sum, ink) in sums.iter_mut().zip(near) {
                *sum += ink * share;
            }
        }
    }
    out
}

/// The normalized weights up to three standard deviations on both sides.
fn bell(sigma: f64) -> Vec<f32> {
    let reach = cell((3.0 * sigma).ceil(), MAX_BLUR);
    let share = |i: usize| {
        let away = count(i) - count(reach);
        (-away * away / (2.0 * sigma * sigma).max(1e-9)).exp()
    };
    let shares: Vec<f64> = (0..=2 * reach).map(share).collect();
    let sum: f64 = shares.iter().sum();
    shares.iter().map(|share| as_ink(share / sum)).collect()
}

#[expect(clippy::cast_possible_truncation, reason = "a tone needs no more")]
pub(crate) const fn as_ink(value: f64) -> f32 {
    value as f32
}

const MAX_BLUR: usize = 100;

#[cfg(test)]
mod tests {
    use super::*;

    fn step() -> Tone {
        Tone {
            width: 8,
            height: 4,
            cell: Point::new(0.5, 0.5),
            ink: (0..32).map(|i| f32::from(u8::from(i % 8 > 3))).collect(),
        }
    }

    #[test]
    fn between_the_middles_of_cells_tones_are_mixed() {
        let tone = step();
        for (x, wanted) in [(0.0, 0.0), (1.75, 0.0), (2.0, 0.5), (2.25, 1.0), (9.0, 1.0)] {
            assert_eq!(tone.at(Point::new(x, 1.0)), wanted, "{x}");
        }
    }

    #[test]
    fn a_blur_preserves_the_middle_of_an_edge_and_distant_pixels() {
        let tone = step().blurred(0.5, &CancelToken::default());
        assert!((tone.at(Point::new(2.0, 1.0)) - 0.5).abs() < 1e-6);
        assert!(tone.at(Point::new(0.25, 1.0)) < 0.01);
        assert!(tone.at(Point::new(3.75, 1.0)) > 0.99);
    }
}
