//! The positions of the arm over a period of a recording, in few samples.

use std::ops::RangeInclusive;
use std::time::Duration;

use dobot_wire::{Decoder, Status};

use crate::{Entry, Recording};

/// The positions of the arm over a period of a recording, oldest first: every status that differs,
/// or fewer, at equal intervals, if there are too many.
#[derive(Clone, Debug, PartialEq)]
pub struct Track {
    /// The samples.
    pub samples: Vec<Sample>,
    /// The smallest interval between samples; 0 if all differing statuses are kept.
    pub spacing: Duration,
}

/// The state of the arm at a moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// The time, as in the entries of the recording.
    pub at: Duration,
    /// The status.
    pub status: Status,
}

impl Track {
    /// Reads a recording up to the end of the period, and keeps at most `most` samples (2 or more).
    #[must_use]
    pub fn read(
        recording: &mut Recording,
        stretch: &RangeInclusive<Duration>,
        most: usize,
    ) -> Self {
        let mut decoder = Decoder::statuses(dobot_session::plausible);
        let mut thinning = Thinning::new(most);
        for moment in recording {
            if moment.at > *stretch.end() {
                break;
            }
            let Entry::FromArm(bytes) = &moment.entry else {
                continue;
            };
            for frame in decoder.feed(bytes) {
                let status = Status::parse(&frame).ok();
                if let Some(status) = status.filter(|_| stretch.contains(&moment.at)) {
                    let at = moment.at;
                    thinning.push(Sample { at, status });
                }
            }
        }
        thinning.end()
    }
}

/// A filter of a stream of samples with bounded memory.
#[derive(Debug)]
struct Thinning {
    most: usize,
    track: Track,
    /// The last sample, if it was not kept.
    held: Option<Sample>,
}

impl Thinning {
    const fn new(most: usize) -> Self {
        Self {
            most,
            track: Track {
                samples: Vec::new(),
                spacing: Duration::ZERO,
            },
            held: None,
        }
    }

    fn push(&mut self, sample: Sample) {
        let Some(last) = self.track.samples.last().copied() else {
            return self.keep(sample);
        };
        if sample.status == last.status {
            self.held = Some(sample);
            return;
        }
        // The end of a rest is kept: between its ends the arm did not move.
        if let Some(held) = self.held.take_if(|held| held.status == last.status) {
            self.keep(held);
        }
        self.held = Some(sample);
        let before = self
            .track
            .samples
            .last()
            .map_or(last.at, |sample| sample.at);
        if sample.at.saturating_sub(before) >= self.track.spacing {
            self.held = None;
            self.keep(sample);
        }
    }

    fn end(mut self) -> Track {
        if let Some(held) = self.held.take() {
            self.keep(held);
        }
        self.track
    }

    fn keep(&mut self, sample: Sample) {
        self.track.samples.push(sample);
        if self.track.samples.len() > self.most.max(2) {
            self.thin(sample.at);
        }
    }

    /// Drops at least half of the samples.
    fn thin(&mut self, now: Duration) {
        let Track { samples, spacing } = &mut self.track;
        let first = samples.first().map_or(now, |sample| sample.at);
        let even =
            now.saturating_sub(first) / u32::try_from(self.most / 2).unwrap_or(u32::MAX).max(1);
        *spacing = even.max(*spacing * 2);
        let mut kept = None;
        samples.retain(|sample| {
            let far = kept.is_none_or(|kept| sample.at.saturating_sub(kept) >= *spacing);
            if far {
                kept = Some(sample.at);
            }
            far
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A sample every 80 ms, at these X, in millimetres.
    fn track(most: usize, xs_mm: impl IntoIterator<Item = f32>) -> Track {
        let mut thinning = Thinning::new(most);
        for (n, x_mm) in (0..).zip(xs_mm) {
            thinning.push(Sample {
                at: Duration::from_millis(80) * n,
                status: Status {
                    x_mm,
                    ..Status::AT_ZERO
                },
            });
        }
        thinning.end()
    }

    fn xs(track: &Track) -> Vec<(u128, f32)> {
        let samples = track.samples.iter();
        samples
            .map(|sample| (sample.at.as_millis(), sample.status.x_mm))
            .collect()
    }

    #[test]
    fn a_rest_is_given_by_its_first_and_last_sample() {
        let found = track(100, [200.0, 200.0, 200.0, 210.0, 220.0, 220.0, 220.0]);
        assert_eq!(
            xs(&found),
            [
                (0, 200.0),
                (160, 200.0),
                (240, 210.0),
                (320, 220.0),
                (480, 220.0)
            ]
        );
        assert_eq!(found.spacing, Duration::ZERO);
    }

    #[test]
    fn a_long_motion_is_reduced_to_the_wanted_number_of_evenly_spread_samples() {
        let found = track(100, (0_u16..10_000).map(f32::from));
        assert!(
            (40..=101).contains(&found.samples.len()),
            "{}",
            found.samples.len()
        );
        let ends = [found.samples[0], found.samples[found.samples.len() - 1]];
        assert_eq!(ends.map(|end| end.status.x_mm), [0.0, 9_999.0]);
        for pair in found.samples.windows(2) {
            let gap = pair[1].at.saturating_sub(pair[0].at);
            assert!(gap <= found.spacing * 2, "{gap:?} with {:?}", found.spacing);
        }
    }

    #[test]
    fn without_samples_there_is_no_track() {
        assert!(track(100, []).samples.is_empty());
    }
}
