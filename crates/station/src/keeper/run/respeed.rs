//! Vectors at other speeds than planned.

use dobot_wire::WriteVector;

/// The same vectors at a share of their speeds, begun at a speed of its own: the same ways, and
/// never more than the acceleration along them.
///
/// ```text
///   planned     ____            half of it            from rest
///              /    \___                ____                ___
///            _/         \_           __/    \__           _/   \__
/// ```
pub(super) fn respeed(
    vectors: &[WriteVector],
    begin_mm_s: f64,
    share: f64,
    acceleration_mm_s2: f64,
) -> Vec<WriteVector> {
    let speeds = speeds(vectors, begin_mm_s, share, acceleration_mm_s2);
    let pair = |(vector, ends): (&WriteVector, &[f64])| {
        let [start, end] = [ends[0], ends[1]];
        WriteVector {
            start_speed_mm_s: single(start),
            end_speed_mm_s: single(end),
            max_speed_mm_s: single(limit_mm_s(vector, share).max(start).max(end)),
            ..*vector
        }
    };
    vectors.iter().zip(speeds.windows(2)).map(pair).collect()
}

/// The speed that must not be passed on a vector: no faster than the link brings the next one, where
/// it was not planned so.
fn limit_mm_s(vector: &WriteVector, share: f64) -> f64 {
    let planned = f64::from(vector.max_speed_mm_s);
    (planned * share).min(planned.max(length_mm(vector) / LINK_S))
}

/// The speeds in mm/s where each vector begins and, last, where the last one ends.
fn speeds(
    vectors: &[WriteVector],
    begin_mm_s: f64,
    share: f64,
    acceleration_mm_s2: f64,
) -> Vec<f64> {
    let gain = 2.0 * acceleration_mm_s2;
    let mut speeds = vec![begin_mm_s];
    speeds.extend((0..vectors.len()).map(|it| joint_mm_s(&vectors[it..], share)));
    let mut most_v2 = f64::MAX;
    for (speed, vector) in speeds[1..].iter_mut().zip(vectors).rev() {
        let v2 = (*speed * *speed).min(most_v2);
        *speed = v2.sqrt();
        most_v2 = v2 + gain * length_mm(vector);
    }
    for (index, vector) in vectors.iter().enumerate() {
        let (v2, change) = (speeds[index] * speeds[index], gain * length_mm(vector));
        let next = &mut speeds[index + 1];
        // What it is too fast for is slowed down as soon as it can be.
        let v2 = (*next * *next).clamp((v2 - change).max(0.0), v2 + change);
        *next = v2.sqrt();
    }
    speeds
}

/// The speed at which the joint behind the first of these vectors is passed: only where nothing but
/// the vectors' own speeds limits it does it become more.
fn joint_mm_s(vectors: &[WriteVector], share: f64) -> f64 {
    let planned = f64::from(vectors[0].end_speed_mm_s);
    let neighbours = &vectors[..vectors.len().min(2)];
    let least =
        |of: &dyn Fn(&WriteVector) -> f64| neighbours.iter().map(of).fold(f64::MAX, f64::min);
    let is_free = planned >= 0.98 * least(&|it| it.max_speed_mm_s.into());
    match share {
        ..=1.0 => planned * share,
        _ if is_free => least(&|it| limit_mm_s(it, share)),
        _ => planned,
    }
}

pub(super) fn length_mm(vector: &WriteVector) -> f64 {
    let [x, y, z] = [vector.x_mm, vector.y_mm, vector.z_mm].map(f64::from);
    (x * x + y * y + z * z).sqrt()
}

#[expect(clippy::cast_possible_truncation, reason = "as the packet holds it")]
const fn single(value: f64) -> f32 {
    value as f32
}

/// From one packet to the next, with a bit to spare.
const LINK_S: f64 = 0.084;
