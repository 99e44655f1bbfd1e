//! The conversion of statuses to frames at equal intervals.

use std::time::Duration;

use crate::Sample;
use dobot_wire::Status;

/// Frames per second: twice the status rate of a stock arm.
pub(crate) const FPS: u32 = 25;

/// The state of the arm at one of the frame times of an episode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Frame {
    /// The number of the frame in its episode, from 0; `FPS` per second.
    pub(crate) number: u32,
    pub(crate) status: Status,
}

/// A converter from statuses to frames: numbers are interpolated linearly between two statuses,
/// suction and gripper are those of the earlier one.
///
/// A silence of more than a second ends an episode, because the motion meanwhile is unknown; so
/// does a time that goes back. An episode starts at a status.
#[derive(Debug, Default)]
pub(crate) struct Frames {
    episode: Option<Episode>,
}

#[derive(Debug)]
struct Episode {
    begin: Duration,
    last: Sample,
    /// The number of the next frame.
    next: u32,
}

impl Frames {
    /// Accepts the next status and returns the frames up to it. The first frame of an episode has
    /// number 0.
    pub(crate) fn push(&mut self, sample: Sample) -> Vec<Frame> {
        if let Some(episode) = &mut self.episode
            && let Some(silence) = sample.at.checked_sub(episode.last.at)
            && silence <= MAX_SILENCE
        {
            return episode.push(sample);
        }
        self.episode = Some(Episode {
            begin: sample.at,
            last: sample,
            next: 1,
        });
        vec![Frame {
            number: 0,
            status: sample.status,
        }]
    }
}

impl Episode {
    fn push(&mut self, sample: Sample) -> Vec<Frame> {
        let mut frames = Vec::new();
        while let at = self.begin + PERIOD * self.next
            && at <= sample.at
        {
            frames.push(Frame {
                number: self.next,
                status: between(&self.last, &sample, at),
            });
            self.next += 1;
        }
        self.last = sample;
        frames
    }
}

/// The interpolated status at a time between two others.
fn between(before: &Sample, after: &Sample, at: Duration) -> Status {
    if at == after.at {
        return after.status;
    }
    let whole = after.at.saturating_sub(before.at).as_secs_f32();
    let share = at.saturating_sub(before.at).as_secs_f32() / whole;
    let (a, b) = (before.status, after.status);
    let mix = |a: f32, b: f32| a + (b - a) * share;
    Status {
        x_mm: mix(a.x_mm, b.x_mm),
        y_mm: mix(a.y_mm, b.y_mm),
        z_mm: mix(a.z_mm, b.z_mm),
        rotation_deg: mix(a.rotation_deg, b.rotation_deg),
        base_deg: mix(a.base_deg, b.base_deg),
        rear_deg: mix(a.rear_deg, b.rear_deg),
        fore_deg: mix(a.fore_deg, b.fore_deg),
        servo_deg: mix(a.servo_deg, b.servo_deg),
        ..a
    }
}

const PERIOD: Duration = Duration::from_millis(1000 / FPS as u64);

const MAX_SILENCE: Duration = Duration::from_secs(1);

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn sample(at_ms: u64, base_deg: f32) -> Sample {
        Sample {
            at: Duration::from_millis(at_ms),
            status: Status {
                base_deg,
                ..Status::AT_ZERO
            },
        }
    }

    fn angles(samples: &[Sample]) -> Vec<(u32, f32)> {
        let mut frames = Frames::default();
        let all = samples.iter().flat_map(|sample| frames.push(*sample));
        all.map(|item| (item.number, item.status.base_deg))
            .collect()
    }

    #[test]
    fn between_two_statuses_the_arm_is_assumed_to_turn_evenly() {
        let found = angles(&[sample(500, 0.0), sample(580, 8.0), sample(700, 20.0)]);
        assert_eq!(
            found,
            [
                (0, 0.0),
                (1, 4.0),
                (2, 8.0),
                (3, 12.0),
                (4, 16.0),
                (5, 20.0)
            ]
        );
    }

    #[test]
    fn an_episode_begins_after_a_silence_or_a_time_that_goes_back() {
        assert_eq!(
            angles(&[sample(0, 1.0), sample(1001, 2.0)]),
            [(0, 1.0), (0, 2.0)]
        );
        assert_eq!(angles(&[sample(0, 1.0), sample(1000, 1.0)]).len(), 26);
        assert_eq!(
            angles(&[sample(90, 1.0), sample(80, 2.0)]),
            [(0, 1.0), (0, 2.0)]
        );
    }

    #[test]
    fn the_pump_switches_at_its_status_and_not_before() {
        let mut frames = Frames::default();
        let mut on = sample(100, 0.0);
        on.status.suction = true;
        let all: Vec<_> = [sample(0, 0.0), on, sample(200, 0.0)]
            .into_iter()
            .flat_map(|value| frames.push(value))
            .map(|value| value.status.suction)
            .collect();
        assert_eq!(all, [false, false, false, true, true, false]);
    }

    proptest! {
        #[test]
        fn frames_are_even_and_as_many_as_the_time_holds(gaps_ms in prop::collection::vec(0_u64..1500, 1..50)) {
            let mut frames = Frames::default();
            let (mut at_ms, mut begin_ms, mut expected) = (0, 0, 0);
            frames.push(sample(0, 0.0));
            for gap_ms in gaps_ms {
                at_ms += gap_ms;
                let found: Vec<_> = frames.push(sample(at_ms, 0.0)).iter().map(|frame| frame.number).collect();
                if gap_ms > 1000 {
                    (begin_ms, expected) = (at_ms, 0);
                    prop_assert_eq!(found, [0]);
                    continue;
                }
                let last = u32::try_from((at_ms - begin_ms) / 40).expect("it is small");
                prop_assert_eq!(found, (expected + 1..=last).collect::<Vec<_>>());
                expected = last;
            }
        }
    }
}
