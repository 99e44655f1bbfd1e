//! Tests of profiles and ramps: limits, continuity, ends, and the integral of the speed.

use dobot_motion::{PlanError, Profile, Ramp};
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn distance_ends_exactly_and_never_goes_back((_, profile) in profiles()) {
        prop_assert_eq!(profile.distance_at(profile.duration_s()), profile.distance());
        prop_assert_eq!(profile.distance_at(f64::INFINITY), profile.distance());
        prop_assert_eq!(profile.distance_at(-1.0), 0.0);
        let mut before = 0.0;
        for t_s in samples(profile.duration_s()) {
            let here = profile.distance_at(t_s);
            prop_assert!(here >= before - slack(&profile), "{here} after {before} at {t_s} s");
            prop_assert!(here <= profile.distance() + slack(&profile));
            before = here;
        }
    }

    #[test]
    fn speed_stays_within_the_maximum_and_changes_within_the_acceleration(
        (asked, profile) in profiles(),
    ) {
        let step_s = profile.duration_s() / f64::from(STEPS);
        for t_s in samples(profile.duration_s()) {
            let [before, here] = [profile.speed_at(t_s - step_s), profile.speed_at(t_s)];
            prop_assert!((0.0..=asked.max_speed).contains(&here), "{here} at {t_s} s");
            let change = (here - before).abs();
            let allowed = asked.acceleration * step_s + 1e-9 * asked.max_speed;
            prop_assert!(change <= allowed, "speed changes by {change}, allowed {allowed}");
        }
    }

    #[test]
    fn distance_is_the_integral_of_the_speed((asked, profile) in profiles()) {
        let step_s = profile.duration_s() / f64::from(STEPS);
        let mut sum = 0.0;
        for t_s in samples(profile.duration_s()).skip(1) {
            let [before, here] = [t_s - step_s, t_s].map(|t_s| profile.speed_at(t_s));
            sum += 0.5 * (before + here) * step_s;
            let off = (sum - profile.distance_at(t_s)).abs();
            // The rule is exact except where a step contains a corner of the trapezoid: there a
            // bend of at most 2 a cuts off a triangle of a quarter of the squared step times it.
            let corners = asked.acceleration * step_s * step_s;
            prop_assert!(off <= corners + slack(&profile), "{off} off at {t_s} s, {profile:?}");
        }
    }

    #[test]
    fn a_speed_gives_way_only_where_the_distance_is_too_short((asked, profile) in profiles()) {
        let gain_v2 = 2.0 * asked.acceleration * asked.distance;
        let reachable = |from: f64| (from * from + gain_v2).sqrt();
        let expected = [asked.start.min(reachable(asked.end)), asked.end.min(reachable(asked.start))];
        for (got, expected) in [profile.start_speed(), profile.end_speed()].into_iter().zip(expected) {
            prop_assert!((got - expected).abs() <= 1e-9 * (1.0 + expected), "{profile:?}");
        }
    }

    #[test]
    fn no_profile_within_the_limits_is_faster((asked, profile) in rest_to_rest()) {
        let ramps_s = asked.max_speed / asked.acceleration;
        let fastest_s = if ramps_s * asked.max_speed < asked.distance {
            asked.distance / asked.max_speed + ramps_s
        } else {
            2.0 * (asked.distance / asked.acceleration).sqrt()
        };
        prop_assert!((profile.duration_s() - fastest_s).abs() <= 1e-9 * fastest_s);
    }

    #[test]
    fn a_ramp_is_the_integral_of_its_speed(
        from in -200.0..200.0, to in -200.0..200.0, acceleration in 1.0..500.0, t_s in 0.0..5.0,
    ) {
        let ramp = Ramp::new(from, to, acceleration).expect("the acceleration is positive");
        let change_s = f64::abs(to - from) / acceleration;
        let signed = if to > from { acceleration } else { -acceleration };
        let expected = if t_s < change_s {
            from * t_s + signed * t_s * t_s / 2.0
        } else {
            f64::midpoint(from, to) * change_s + to * (t_s - change_s)
        };
        prop_assert!((ramp.distance_at(t_s) - expected).abs() < 1e-9);
        let [before, after] = [ramp.speed_at(t_s), ramp.speed_at(t_s + 1e-3)];
        prop_assert!((after - before).abs() <= acceleration * 1e-3 + 1e-9);
        prop_assert!(before >= f64::min(from, to) && before <= f64::max(from, to));
    }

    #[test]
    fn a_run_down_goes_the_square_of_the_speed_over_twice_the_acceleration(
        speed in -200.0..200.0, acceleration in 1.0..500.0,
    ) {
        let ramp = Ramp::to_rest(speed, acceleration).expect("the acceleration is positive");
        let expected = speed * f64::abs(speed) / (2.0 * acceleration);
        prop_assert!((ramp.change_distance() - expected).abs() < 1e-9);
        prop_assert_eq!(ramp.speed_at(ramp.change_s()), 0.0);
        prop_assert_eq!(ramp.distance_at(1e6), ramp.change_distance());
    }
}

#[test]
fn a_hundred_millimetres_at_fifty_take_half_a_second_longer_than_without_ramps() {
    let profile = Profile::new(100.0, 0.0, 0.0, 50.0, 100.0).expect("the limits are positive");
    assert_eq!(profile.duration_s(), 2.5);
    assert_eq!(profile.peak_speed(), 50.0);
    assert_eq!(profile.distance_at(1.25), 50.0);
    assert_eq!(profile.speed_at(0.25), 25.0);
    assert_eq!(profile.speed_at(2.25), 25.0);
}

#[test]
fn too_short_to_brake_starts_with_the_highest_speed_that_can() {
    // 30 down to 10 mm/s at 100 mm/s2 needs 4 mm; within 1.5 mm only 20 mm/s can be braked.
    let profile = Profile::new(1.5, 30.0, 10.0, 50.0, 100.0).expect("the limits are positive");
    assert_eq!(profile.start_speed(), 20.0);
    assert_eq!(profile.end_speed(), 10.0);
    assert!((profile.duration_s() - 0.1).abs() < 1e-12);
}

#[test]
fn no_distance_takes_no_time() {
    let profile = Profile::new(0.0, 30.0, 10.0, 50.0, 100.0).expect("the limits are positive");
    assert_eq!(profile.duration_s(), 0.0);
    assert_eq!([profile.start_speed(), profile.end_speed()], [10.0, 10.0]);
}

#[test]
fn bad_numbers_are_refused_by_name() {
    let cases = [
        (
            [-1.0, 0.0, 0.0, 50.0, 9.0],
            "distance is -1; a motion allows 0 to 3.4e38",
        ),
        (
            [f64::NAN, 0.0, 0.0, 50.0, 9.0],
            "distance is NaN; a motion allows 0 to 3.4e38",
        ),
        (
            [1.0, -2.0, 0.0, 50.0, 9.0],
            "start speed is -2; a motion allows 0 to 3.4e38",
        ),
        (
            [1.0, 0.0, f64::INFINITY, 50.0, 9.0],
            "end speed is inf; a motion allows 0 to 3.4e38",
        ),
        (
            [1.0, 0.0, 0.0, 0.0, 9.0],
            "maximum speed is 0; a motion needs more than 0 and at most 3.4e38",
        ),
        (
            [1.0, 0.0, 0.0, 50.0, f64::NAN],
            "acceleration is NaN; a motion needs more than 0 and at most 3.4e38",
        ),
        (
            [1.0, 60.0, 0.0, 50.0, 9.0],
            "start speed is 60; the maximum speed of the same motion allows 0 to 50",
        ),
    ];
    for ([distance, start, end, max_speed, acceleration], expected) in cases {
        let error =
            Profile::new(distance, start, end, max_speed, acceleration).expect_err(expected);
        assert_eq!(error.to_string(), expected);
    }
}

#[test]
fn limits_too_small_for_a_finite_time_are_refused() {
    let error = Profile::new(1e38, 0.0, 0.0, 1e-300, 1.0).expect_err("1e338 s is no number");
    assert!(matches!(error, PlanError::Endless { .. }));
    let error = Ramp::new(0.0, 1e300, 1e-300).expect_err("1e600 s is no number");
    assert!(matches!(error, PlanError::Endless { .. }));
}

#[test]
fn a_reversed_jog_runs_through_rest() {
    let ramp = Ramp::new(15.0, -15.0, 50.0).expect("the acceleration is positive");
    assert_eq!(ramp.speed_at(0.3), 0.0);
    assert_eq!(ramp.distance_at(0.3), 2.25);
    assert_eq!(ramp.distance_at(0.6), 0.0);
    assert!((ramp.distance_at(1.6) + 15.0).abs() < 1e-12);
}

/// The input of a profile.
#[derive(Clone, Copy, Debug)]
struct ProfileLimits {
    distance: f64,
    start: f64,
    end: f64,
    max_speed: f64,
    acceleration: f64,
}

impl ProfileLimits {
    fn planned(self) -> (Self, Profile) {
        let Self {
            distance,
            start,
            end,
            max_speed,
            acceleration,
        } = self;
        let profile = Profile::new(distance, start, end, max_speed, acceleration);
        (self, profile.expect("all numbers are in range"))
    }
}

fn profiles() -> impl Strategy<Value = (ProfileLimits, Profile)> {
    let distances = prop_oneof![Just(0.0), 1e-6..1e-2, 0.01..10.0, 10.0..2000.0];
    let shares = || prop_oneof![Just(0.0), 0.0..1.0, Just(1.0)];
    (distances, shares(), shares(), 0.1..500.0, 1.0..2000.0).prop_map(
        |(distance, start, end, max_speed, acceleration)| {
            let [start, end] = [start * max_speed, end * max_speed];
            ProfileLimits {
                distance,
                start,
                end,
                max_speed,
                acceleration,
            }
            .planned()
        },
    )
}

fn rest_to_rest() -> impl Strategy<Value = (ProfileLimits, Profile)> {
    (1e-6..2000.0, 0.1..500.0, 1.0..2000.0).prop_map(|(distance, max_speed, acceleration)| {
        ProfileLimits {
            distance,
            start: 0.0,
            end: 0.0,
            max_speed,
            acceleration,
        }
        .planned()
    })
}

fn samples(duration_s: f64) -> impl Iterator<Item = f64> {
    (0..=STEPS).map(move |n| duration_s * f64::from(n) / f64::from(STEPS))
}

/// The rounding error of a distance.
fn slack(profile: &Profile) -> f64 {
    1e-9 * (1.0 + profile.distance())
}

const STEPS: u32 = 64;
