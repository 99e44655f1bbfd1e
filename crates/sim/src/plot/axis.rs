//! From quantities to pixels, with ticks at round numbers.

/// An axis: a range of a quantity on a range of pixels.
#[derive(Clone, Copy, Debug)]
pub(super) struct Axis {
    range: [f64; 2],
    pixels: [f64; 2],
}

impl Axis {
    /// An axis from one value to another.
    pub(super) const fn exact(range: [f64; 2], pixels: [f64; 2]) -> Self {
        Self { range, pixels }
    }

    /// An axis on which these values have some room; those that are no numbers do not count.
    pub(super) fn around(values: impl Iterator<Item = f64>, least: f64, pixels: [f64; 2]) -> Self {
        let [low, high] = range(values);
        let margin = (0.06 * (high - low)).max((least - (high - low)) / 2.0);
        Self::exact([low - margin, high + margin], pixels)
    }

    pub(super) const fn pixels(&self) -> [f64; 2] {
        self.pixels
    }

    pub(super) fn pixel(&self, value: f64) -> f64 {
        let [low, high] = self.range;
        let [from, to] = self.pixels;
        from + (value - low) / (high - low) * (to - from)
    }

    /// Round values, about one in so many pixels, each with its text.
    pub(super) fn ticks(&self, spacing: f64) -> Vec<(f64, String)> {
        let [low, high] = self.range;
        let count = ((self.pixels[1] - self.pixels[0]).abs() / spacing).max(1.0);
        let step = round_step((high - low) / count);
        let places = (-step.log10().floor()).max(0.0);
        let mut ticks = Vec::new();
        let mut n = (low / step - 1e-9).ceil();
        while n * step <= high + step * 1e-9 && ticks.len() < 100 {
            // Plus zero, because there is no minus zero on an axis.
            ticks.push((n * step, format!("{:.*}", whole(places), n * step + 0.0)));
            n += 1.0;
        }
        ticks
    }
}

/// From the least to the greatest number; around zero if there is none.
pub(super) fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let numbers = values.filter(|it| it.is_finite());
    let ends = numbers.fold(None, |ends: Option<[f64; 2]>, it| {
        Some(ends.map_or([it, it], |[low, high]| [low.min(it), high.max(it)]))
    });
    ends.unwrap_or_default()
}

/// 1, 2 or 5 times a power of ten, not below this.
fn round_step(least: f64) -> f64 {
    let power = 10.0_f64.powf(least.log10().floor());
    let steps = [1.0, 2.0, 5.0].map(|it| it * power);
    steps
        .into_iter()
        .find(|&it| it >= least * (1.0 - 1e-9))
        .unwrap_or(10.0 * power)
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "places behind a point are few"
)]
const fn whole(places: f64) -> usize {
    places as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(axis: &Axis, spacing: f64) -> Vec<String> {
        axis.ticks(spacing).into_iter().map(|it| it.1).collect()
    }

    #[test]
    fn ticks_stand_at_round_numbers() {
        let axis = Axis::exact([-3.0, 11.0], [0.0, 300.0]);
        assert_eq!(texts(&axis, 100.0), ["0", "5", "10"]);
        let axis = Axis::exact([0.0, 0.3], [0.0, 300.0]);
        assert_eq!(texts(&axis, 100.0), ["0.0", "0.1", "0.2", "0.3"]);
        let axis = Axis::exact([-200.0, 150.0], [500.0, 100.0]);
        assert_eq!(texts(&axis, 100.0), ["-200", "-100", "0", "100"]);
    }

    #[test]
    fn an_axis_leaves_room_and_overlooks_what_is_no_number() {
        let values = [2.0, f64::NAN, 4.0, f64::INFINITY];
        let axis = Axis::around(values.into_iter(), 1.0, [0.0, 112.0]);
        assert!((axis.pixel(2.0) - 6.0).abs() < 1e-9 && (axis.pixel(4.0) - 106.0).abs() < 1e-9);
        let nothing = Axis::around(std::iter::empty(), 10.0, [0.0, 100.0]);
        assert!((nothing.pixel(0.0) - 50.0).abs() < 1e-9);
    }
}
