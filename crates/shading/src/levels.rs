//! The tone adjustment of drawings: full range from white to black.

use dobot_geometry::CancelToken;

use crate::shading::{Shading, ShadingStyle};
use crate::tone::{Tone, as_ink, count};

/// Stretches the tones to the full range, sharpens local contrast, balances the middle tones, and
/// inverts on request.
///
/// Dull photos become rich; dark and light ones move half the way to a medium tone; black and white
/// stay. `spacing_mm` is on the page.
pub(crate) fn levelled(
    tone: &Tone,
    shading: &Shading,
    spacing_mm: f64,
    cancel: &CancelToken,
) -> Tone {
    let turned = if shading.invert {
        tone.map(|ink| 1.0 - ink)
    } else {
        tone.clone()
    };
    let clear = set_off(&stretched(&turned), SURROUNDINGS * spacing_mm, cancel);
    let exponent = as_ink(balance(&clear) / shading.darkness);
    clear.map(|ink| adjusted(ink.powf(exponent), shading))
}

/// Adjusts a tone: first contrast, then brightness, then black or white.
fn adjusted(ink: f32, shading: &Shading) -> f32 {
    let (contrast, brightness) = (shading.contrast, shading.brightness);
    let slope = if contrast > 0.0 {
        1.0 / (1.0 - contrast).max(1.0 / STEEPEST)
    } else {
        1.0 + contrast
    };
    let ink = (f64::from(ink) - 0.5) * slope + 0.5 - brightness;
    match shading.threshold {
        Some(from) if shading.style != ShadingStyle::Outline => f32::from(u8::from(ink >= from)),
        _ => as_ink(ink.clamp(0.0, 1.0)),
    }
}

/// Increases the contrast to the surroundings.
fn set_off(tone: &Tone, radius_mm: f64, cancel: &CancelToken) -> Tone {
    let around = tone.blurred(radius_mm, cancel);
    let pairs = tone.ink.iter().zip(&around.ink);
    let clear = pairs.map(|(ink, around)| (ink + CLARITY * (ink - around)).clamp(0.0, 1.0));
    Tone {
        ink: clear.collect(),
        ..*tone
    }
}

fn stretched(tone: &Tone) -> Tone {
    let histogram = Histogram::of(tone);
    let [mut low, mut high] = [EXTREMES, 1.0 - EXTREMES].map(|share| histogram.below(share));
    if high - low < 1.0 / MAX_GAIN {
        // A few thin lines on a page of one tone: they are the whole content.
        [low, high] = [histogram.below(0.0), histogram.below(1.0)];
    }
    let range = high - low;
    if range < MIN_RANGE {
        return tone.clone();
    }
    let gain = (1.0 / range).min(MAX_GAIN);
    // A range that cannot be fully stretched keeps its position.
    let zero = low - low * (1.0 - gain * range) / (1.0 - range).max(1e-9) / gain;
    let [gain, zero] = [gain, zero].map(as_ink);
    tone.map(|ink| ((ink - zero) * gain).clamp(0.0, 1.0))
}

/// The exponent that moves the mean half the way to [`MIDDLE`].
fn balance(tone: &Tone) -> f64 {
    let between = || tone.ink.iter().filter(|&&ink| ink > 0.03 && ink < 0.97);
    let number = between().count();
    if count(number) < 0.2 * count(tone.ink.len()) {
        return 1.0;
    }
    let mean = between().copied().map(f64::from).sum::<f64>() / count(number);
    (MIDDLE.ln() / mean.ln()).sqrt().clamp(0.6, 1.7)
}

/// The histogram of tones.
pub(crate) struct Histogram {
    pub(crate) bins: [usize; BINS],
    total: usize,
}

impl Histogram {
    pub(crate) fn of(tone: &Tone) -> Self {
        let mut bins = [0; BINS];
        for &ink in &tone.ink {
            let place = f64::from(ink) * count(BINS - 1) + 0.5;
            bins[super::tone::cell(place, BINS)] += 1;
        }
        Self {
            bins,
            total: tone.ink.len(),
        }
    }

    /// The tone that this fraction of all cells does not exceed.
    fn below(&self, share: f64) -> f64 {
        let wanted = share * count(self.total);
        let mut sum = 0;
        let bin = self.bins.iter().position(|&bin| {
            sum += bin;
            sum > 0 && count(sum) >= wanted
        });
        Self::tone(bin.unwrap_or(BINS - 1))
    }

    /// The tone of a bin.
    pub(crate) fn tone(bin: usize) -> f64 {
        count(bin) / count(BINS - 1)
    }

    /// The borders between at most `levels` + 1 representative tones of the picture (k-means of its
    /// cells). A tone between others that hardly any cell has does not count.
    pub(crate) fn thresholds(&self, levels: u8) -> Vec<f64> {
        let tones = usize::from(levels) + 1;
        let mut means: Vec<f64> = (0..tones)
            .map(|i| self.below((count(i) + 0.5) / count(tones)))
            .collect();
        let (low, high) = (self.below(0.0), self.below(1.0));
        if high - low < MIN_RANGE {
            return Vec::new();
        }
        for (i, mean) in means.iter_mut().enumerate() {
            // Between the median and the uniform division: both extremes are met.
            *mean = (*mean + low + (high - low) * count(i) / count(tones - 1)) / 2.0;
        }
        for _ in 0..ROUNDS {
            means = self
                .means(&means)
                .into_iter()
                .map(|(mean, _)| mean)
                .collect();
        }
        let least = MIN_SHARE * count(self.total);
        let means = self.means(&means).into_iter().enumerate();
        let kept =
            means.filter(|&(i, (_, cells))| i == 0 || i + 1 == tones || count(cells) >= least);
        let kept: Vec<f64> = kept.map(|(_, (mean, _))| mean).collect();
        borders(&kept)
    }

    /// The mean and the number of the cells nearest to each of these ascending tones.
    fn means(&self, tones: &[f64]) -> Vec<(f64, usize)> {
        let borders = borders(tones);
        let mut sums = vec![(0.0, 0); tones.len()];
        for (bin, &cells) in self.bins.iter().enumerate() {
            let tone = Self::tone(bin);
            let (sum, number) = &mut sums[borders.partition_point(|&border| border < tone)];
            *sum += tone * count(cells);
            *number += cells;
        }
        let mean = |(&(sum, cells), &tone): (&(f64, usize), &f64)| {
            let mean = if cells > 0 { sum / count(cells) } else { tone };
            (mean, cells)
        };
        sums.iter().zip(tones).map(mean).collect()
    }
}

fn borders(tones: &[f64]) -> Vec<f64> {
    tones
        .windows(2)
        .map(|pair| f64::midpoint(pair[0], pair[1]))
        .collect()
}

const BINS: usize = 256;
/// The slope at full contrast.
const STEEPEST: f64 = 100.0;
/// The fraction of cells that may become plain white, and plain black.
const EXTREMES: f64 = 0.005;
/// Noise is not amplified.
const MAX_GAIN: f64 = 5.0;
/// A smaller range is a page of one tone.
const MIN_RANGE: f64 = 0.02;
/// The radius of the surroundings, in spacings.
const SURROUNDINGS: f64 = 5.0;
const CLARITY: f32 = 0.5;
/// The medium tone of a drawing.
const MIDDLE: f64 = 0.36;
const ROUNDS: usize = 30;
/// The smallest fraction of cells of a separate tone.
const MIN_SHARE: f64 = 0.03;
