//! How long a light stands; the tests of the station and the figures of reliability judge by it, too.

use dobot_sim::Sample;

/// How long the laser was on at the most while the arm stood, in seconds: of the arm, not as reported. It
/// stands where it goes less than `still_mm` from one sample to the next.
pub(crate) fn longest_stand_s(samples: &[Sample], still_mm: f64) -> f64 {
    let mut longest_s: f64 = 0.0;
    let mut stood_s = 0.0;
    for pair in samples.windows(2) {
        let stands = pair[1].position.distance(pair[0].position).0 < still_mm;
        stood_s = if stands && pair[1].laser {
            stood_s + pair[1].at.saturating_sub(pair[0].at).as_secs_f64()
        } else {
            0.0
        };
        longest_s = longest_s.max(stood_s);
    }
    longest_s
}
