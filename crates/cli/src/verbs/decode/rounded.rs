//! Statuses with rounded values, as in text logs.

use dobot_arm::{Joints, Tool, forward};
use dobot_wire::Frame;

/// Returns the distance between the position of a status and that of its angles, in mm, if rounding to the
/// decimals of its values explains it.
pub(super) fn rounded(frame: &Frame) -> Option<f64> {
    let float = |n| f64::from(frame.float(n));
    let step = |numbers: [usize; 4]| {
        let decimals = numbers.map(|n| decimals(float(n)));
        let most = decimals
            .into_iter()
            .try_fold(0, |most, decimals| Some(decimals?.max(most)));
        most.map_or(0.0, |most| 0.1_f64.powi(most))
    };
    let (place_step, angle_step) = (step([1, 2, 3, 4]), step([5, 6, 7, 8]));
    let [base, rear, fore, servo] = [5, 6, 7, 8].map(float);
    let turned = (float(4) - base - servo).abs();
    let off_mm = Tool::END_EFFECTORS
        .map(|tool| forward(&Joints::new(base, rear, fore, servo), tool).position)
        .map(|at| [float(1) - at.x.0, float(2) - at.y.0, float(3) - at.z.0])
        .map(|off| {
            off.into_iter()
                .fold(0.0, |most: f64, mm| most.max(mm.abs()))
        })
        .into_iter()
        .fold(f64::INFINITY, f64::min);
    let fits = off_mm <= EXACT + 0.5 * place_step + MM_PER_STEP * angle_step
        && turned <= EXACT + 0.5 * place_step + angle_step;
    fits.then_some(off_mm)
}

/// The number of decimals of a value, up to three; `None` if it has more, like a calculated value.
fn decimals(value: f64) -> Option<i32> {
    (0..=3).find(|decimals| {
        let shifted = value * 10_f64.powi(*decimals);
        (shifted - shifted.round()).abs() <= shifted.abs() * SINGLE_PRECISION
    })
}

/// The tolerance of a status that is not rounded (note N22), in mm or degrees.
const EXACT: f64 = 0.01;

/// The maximum motion of the tool for half a degree of base, rear arm and forearm: 2.8 mm at the longest
/// reach, 1.2 and 1.4 mm.
const MM_PER_STEP: f64 = 5.4;

/// The relative precision of a single-precision number.
const SINGLE_PRECISION: f64 = 1e-7;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_decimals_of_a_single_precision_number_are_counted() {
        let cases = [
            (0.0_f32, Some(0)),
            (-33.0, Some(0)),
            (190.9, Some(1)),
            (0.25, Some(2)),
            (190.938, Some(3)),
        ];
        for (value, expected) in cases {
            assert_eq!(decimals(f64::from(value)), expected, "{value}");
        }
        assert_eq!(decimals(f64::from(190.938_37_f32)), None);
        assert_eq!(decimals(f64::NAN), None);
    }

    #[test]
    fn a_position_may_deviate_by_the_rounding_of_its_decimals_and_no_more() {
        // A real arm at base -33, rear 14, fore 29 degrees, its position with one decimal.
        let status = |x: f32, base: f32| {
            let frame = Frame::ZERO
                .with(1, x)
                .with(2, -124.0)
                .with(3, 53.4)
                .with(4, -33.0);
            frame.with(5, base).with(6, 14.1).with(7, 29.0)
        };
        let off = rounded(&status(190.9, -33.0)).expect("it is rounded");
        assert!(off < 0.3, "{off}");
        assert_eq!(rounded(&status(192.9, -33.0)), None);
        assert_eq!(rounded(&status(190.9, -33.052_7)), None);
    }
}
