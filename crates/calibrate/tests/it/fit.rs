//! Calibrations fitted to touches of a sheet.

use crate::arms::{CASES, Row};
use dobot_arm::{Calibration, Degrees, Joints, Position, Tool};
use dobot_calibrate::{FitError, SHEET_POINTS, Touch, Trust, fit};

const ARM: Calibration = Calibration {
    base_deg: 3.0,
    rear_deg: -24.4,
    fore_deg: -3.9,
    reach_mm: 6.0,
    left_mm: 2.0,
    axis_mm: [0.0, 0.0],
    backlash_deg: [0.0; 3],
    table: None,
};

/// The paper rises by two degrees towards the front.
fn touch([x, y]: [f64; 2], miss_mm: [f64; 2]) -> Touch {
    let z = -45.0 + 0.035 * x;
    let place = Position::new(x + miss_mm[0], y + miss_mm[1], z);
    Touch {
        place_mm: [x, y],
        height_mm: 0.0,
        raw: ARM.raw_joints(place, Tool::SuctionCup).unwrap(),
    }
}

fn nine() -> Vec<Touch> {
    SHEET_POINTS.map(|point| touch(point, [0.0, 0.0])).to_vec()
}

#[test]
fn an_old_arm_finds_every_place_of_its_paper_again() {
    let found = fit(&nine(), Tool::SuctionCup).unwrap();
    assert_eq!(found.trust, Trust::Good);
    for [x, y] in [[150.0, -100.0], [230.0, 40.0], [270.0, 100.0]] {
        let wanted = Position::new(x, y, found.paper.z_at([x, y]));
        let raw = found.arm.raw_place(wanted, Tool::SuctionCup).unwrap();
        let reached = ARM.true_place(raw, Tool::SuctionCup).unwrap();
        let away = (reached.x.0 - x).hypot(reached.y.0 - y);
        assert!(away < 0.15, "{x}, {y}: {away} mm away");
        let height = reached.z.0 - (-45.0 + 0.035 * reached.x.0);
        assert!(height.abs() < 0.1, "{x}, {y}: {height} mm above the paper");
    }
}

#[test]
fn one_wrong_touch_of_nine_is_named_and_excluded() {
    for wrong in 0..9 {
        let mut touches = nine();
        touches[wrong] = touch(SHEET_POINTS[wrong], [4.0, -3.0]);
        let found = fit(&touches, Tool::SuctionCup).unwrap();
        assert_eq!(found.left_out, [wrong], "touch {}", wrong + 1);
        assert_eq!(found.trust, Trust::Good);
        let away = found.residual_mm(wrong);
        assert!(
            (3.5..=7.0).contains(&away),
            "touch {}: {away} mm",
            wrong + 1
        );
    }
}

#[test]
fn two_wrong_touches_of_twelve_are_named_and_excluded() {
    let twelve = [nine(), nine()[..3].to_vec()].concat();
    for [one, other] in [[0, 1], [2, 11], [4, 7], [9, 10]] {
        let mut touches = twelve.clone();
        for (wrong, miss_mm) in [(one, [9.0, -8.0]), (other, [6.0, 10.0])] {
            touches[wrong] = touch(touches[wrong].place_mm, miss_mm);
        }
        let found = fit(&touches, Tool::SuctionCup).unwrap();
        assert_eq!(found.left_out, [one, other]);
        assert_eq!(found.trust, Trust::Good);
    }
}

#[test]
fn a_base_turned_by_hand_before_the_last_touch_is_not_mistaken_for_a_wrong_touch() {
    let mut touches = nine();
    touches[8].raw.base = touches[8].raw.base - Degrees(2.0);
    let found = fit(&touches, Tool::SuctionCup).unwrap();
    assert_eq!(found.trust, Trust::Doubtful);
}

#[test]
fn three_points_are_too_few() {
    let error = fit(&nine()[..3], Tool::SuctionCup).unwrap_err();
    assert_eq!(error, FitError::TooFew { found: 3 });
}

#[test]
fn points_in_a_line_are_refused() {
    let line = [165.0, 190.0, 215.0, 240.0, 265.0].map(|x| touch([x, 10.0], [0.0, 0.0]));
    let error = fit(&line, Tool::SuctionCup).unwrap_err();
    assert!(matches!(error, FitError::InLine { .. }), "{error}");
}

#[test]
fn a_reset_between_two_touches_is_reported_with_its_place() {
    let mut touches = nine();
    for touch in &mut touches[5..] {
        touch.raw.base = touch.raw.base - Degrees(31.0);
    }
    let error = fit(&touches, Tool::SuctionCup).unwrap_err();
    assert!(matches!(error, FitError::Reset { last: 5, .. }), "{error}");
}

#[test]
fn a_print_of_nine_tenths_is_reported() {
    let touches = SHEET_POINTS.map(|[x, y]| Touch {
        place_mm: [x, y],
        ..touch([x * 0.9, y * 0.9], [0.0, 0.0])
    });
    let error = fit(&touches, Tool::SuctionCup).unwrap_err();
    let FitError::ScaledPrint { percent } = error else {
        panic!("{error}");
    };
    assert!((89.0..91.0).contains(&percent), "{percent}");
}

#[test]
fn points_touched_in_another_order_contradict_each_other() {
    let mut touches = nine();
    let raw: Vec<_> = touches.iter().map(|touch| touch.raw).collect();
    for (index, touch) in touches.iter_mut().enumerate() {
        touch.raw = raw[(index * 4 + 1) % 9];
    }
    let error = fit(&touches, Tool::SuctionCup).unwrap_err();
    assert!(error.to_string().contains("ouch"), "{error}");
}

#[test]
fn four_corners_suggest_the_most_useful_further_point() {
    let found = fit(&nine()[1..5], Tool::SuctionCup).unwrap();
    assert_eq!(found.trust, Trust::Unchecked);
    assert!(!found.unsure.is_empty());
    let advice = found.advice.unwrap();
    assert!(advice.gain > 0.1, "{advice:?}");
}

#[test]
fn a_calibration_rated_good_is_accurate_to_a_millimetre_at_95_of_100_positions() {
    // Touches from either side are refused before they come here.
    for case in CASES.iter().filter(|case| !case.is_any_side) {
        let row = Row::of(case, ARMS);
        assert!(row.good_mm.iter().all(|mm| *mm < 1.0), "{row}");
    }
}

/// The example `accuracy` calibrates more.
const ARMS: u64 = 6;

#[test]
fn crosses_calibrate_an_arm_to_half_a_millimetre() {
    let mut errors_mm: Vec<f64> = (0..20)
        .flat_map(|seed| {
            let (crosses, checks) = crate::arms::crosses(seed);
            let touches: Vec<Touch> = crosses
                .iter()
                .map(|&(place_mm, [base, rear, fore])| Touch {
                    place_mm,
                    height_mm: 0.0,
                    raw: Joints::new(base, rear, fore, 0.0),
                })
                .collect();
            let found = fit(&touches, Tool::SuctionCup).unwrap();
            checks.into_iter().map(move |([x, y, z], at)| {
                let place = Position::new(x, y, z);
                let place = found.arm.true_place(place, Tool::SuctionCup).unwrap();
                (place.x.0 - at[0]).hypot(place.y.0 - at[1])
            })
        })
        .collect();
    errors_mm.sort_by(f64::total_cmp);
    assert!(errors_mm[errors_mm.len() * 95 / 100] < 0.5);
}
