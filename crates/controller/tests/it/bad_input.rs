//! Bad input: refused, counted, survived.

use std::time::Duration;

use dobot_arm::{Limits, Tool};
use dobot_controller::{Controller, Personality, PowerUp, Upload};
use dobot_wire::{Frame, Status, WriteVector};
use proptest::prelude::*;

use crate::lab::Lab;
use crate::moving::movl;

#[test]
fn a_target_out_of_reach_is_refused_before_anything_moves() {
    let lab = Lab::power_up();
    let from = lab.position();
    lab.send(movl(400.0, 0.0, 0.0))
        .wait_ms(3000)
        .expect_at(from.x.0, from.y.0, from.z.0)
        .expect_refusal("before it moved");
}

#[test]
fn a_line_between_two_allowed_points_is_refused_where_it_leaves_the_limits_between_them() {
    // Past the base: both ends are 200 mm away from it, the middle only 60 mm.
    Lab::power_up()
        .send(movl(60.0, 190.0, -30.0))
        .wait_ms(10_000)
        .expect_no_refusal()
        .send(movl(60.0, -190.0, -30.0))
        .wait_ms(10_000)
        .expect_at(60.0, 190.0, -30.0)
        .expect_refusal("reach is");
}

#[test]
fn what_the_tables_do_not_allow_is_refused_with_the_table() {
    for (floats, part) in [
        (
            [3.0, 0.0, 200.0, 0.0, 0.0, 0.0, 0.0, 3.0, 0.0, 0.0],
            "MovingMode",
        ),
        (
            [2.0, 15.0, 0.0, 0.0, 0.0, 0.0, 0.0, 50.0, 0.0, 0.0],
            "Table 2.5",
        ),
        (
            [11.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
            "Table 2.2",
        ),
        (
            [9.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
            "Table 3.9",
        ),
        (
            [3.0, 0.0, f32::NAN, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
            "float 3",
        ),
        ([4.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 10.0], "N16"),
    ] {
        Lab::power_up()
            .send_floats(floats)
            .wait_ms(100)
            .expect_refusal(part);
    }
}

#[test]
fn words_that_it_does_not_know_are_refused() {
    let voice = dobot_wire::Voice::new("sing a song").expect("it is short");
    Lab::power_up()
        .send(voice)
        .wait_ms(100)
        .expect_refusal("voice command");
}

#[test]
fn noise_between_packets_costs_none_of_them() {
    let command = movl(250.0, 0.0, 0.0);
    let lab = Lab::power_up()
        .send_bytes(&[0xA5, 0x00, 0x5A, 0xFF, 0xA5])
        .send(command);
    assert_eq!(lab.controller.counters().packets, 1);
    assert_eq!(lab.controller.counters().skipped_bytes, 5);
    lab.wait_ms(3000).expect_at(250.0, 0.0, 0.0);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// Any floats, mostly plausible ones, at any time.
    #[test]
    fn whatever_is_sent_no_status_is_nan_or_beyond_a_limit(
        frames in proptest::collection::vec((any_frame(), 0_u64..1500), 1..12),
    ) {
        let mut lab = Lab::power_up();
        for (floats, ms) in frames {
            lab = lab.send_floats(floats).wait_ms(ms);
        }
        lab = lab.wait_ms(1000);
        for (ms, status) in &lab.statuses {
            let joints = dobot_arm::Joints::new(
                status.base_deg.into(),
                status.rear_deg.into(),
                status.fore_deg.into(),
                status.servo_deg.into(),
            );
            // A status is in single precision, which may round a value over its limit.
            let allowed = within(&joints);
            prop_assert!(allowed, "at {ms} ms: {status:?}");
            prop_assert!(status.gripper_deg.abs() <= 90.0);
        }
    }

    #[test]
    fn how_bytes_are_cut_and_how_time_is_sliced_changes_nothing(
        personality in proptest::sample::select(&Personality::ALL),
        frames in proptest::collection::vec((any_frame(), 0_u64..400), 1..6),
        cuts in proptest::collection::vec(1_usize..42, 1..8),
        slices in proptest::collection::vec(1_u64..90, 1..8),
    ) {
        let whole = statuses(personality, &frames, &[42], &[1000]);
        let cut = statuses(personality, &frames, &cuts, &slices);
        prop_assert_eq!(whole, cut);
    }
}

/// Every status for bytes in these chunks and time in these steps.
fn statuses(
    personality: Personality,
    frames: &[([f32; 10], u64)],
    cuts: &[usize],
    slices_ms: &[u64],
) -> Vec<Upload> {
    let mut controller = Controller::power_up(PowerUp::new(personality));
    let mut statuses = Vec::new();
    // The twin buffers bytes while it calculates.
    let mut now = Duration::from_millis(10);
    let mut slices = slices_ms.iter().cycle();
    let mut cuts = cuts.iter().cycle();
    for (floats, ms) in frames.iter().chain(&[([0.0; 10], 500)]) {
        let frame = (1..=10).fold(Frame::ZERO, |frame, n| frame.with(n, floats[n - 1]));
        let bytes = frame.to_bytes();
        let mut rest = &bytes[..];
        while !rest.is_empty() {
            let (piece, after) = rest.split_at((*cuts.next().expect("it cycles")).min(rest.len()));
            controller.handle_bytes(now, piece);
            rest = after;
        }
        let until = now + Duration::from_millis(*ms);
        while now < until {
            let slice = Duration::from_millis(*slices.next().expect("it cycles"));
            now = (now + slice).min(until);
            controller.handle_time(now);
            statuses.extend(std::iter::from_fn(|| controller.poll_bytes()));
        }
    }
    statuses
}

fn within(joints: &dobot_arm::Joints) -> bool {
    match Limits::STOCK.check(joints, Tool::SuctionCup) {
        Ok(()) => true,
        Err(error) => error.excess() < 1e-3 || Limits::STOCK.check(joints, Tool::Laser).is_ok(),
    }
}

fn any_frame() -> impl Strategy<Value = [f32; 10]> {
    let number = prop_oneof![
        4 => -400.0_f32..400.0,
        4 => (0_u8..16).prop_map(f32::from),
        1 => any::<f32>(),
        1 => Just(0.0),
    ];
    let state = prop_oneof![8 => (1_u8..11).prop_map(f32::from), 1 => any::<f32>()];
    (state, proptest::array::uniform9(number)).prop_map(|(state, rest)| {
        let mut floats = [state; 10];
        floats[1..].copy_from_slice(&rest);
        floats
    })
}

#[test]
fn a_motion_of_hours_is_refused_at_once() {
    let crawl = dobot_wire::PlaybackAdjustment {
        speed_percent: 1e-9,
        acceleration_percent: 1.0,
        teach_speed_percent: 1.0,
    };
    Lab::power_up()
        .send(crawl)
        .send(movl(250.0, 0.0, 0.0))
        .wait_ms(100)
        .expect_refusal("allowed are 3600 s");
}

#[test]
fn a_status_is_a_status_even_after_the_wildest_vector() {
    let vector = WriteVector {
        start_speed_mm_s: f32::MAX,
        end_speed_mm_s: f32::MAX,
        ..WriteVector::by(f32::MAX, f32::MAX, f32::MAX, f32::MIN_POSITIVE)
    };
    let lab = Lab::power_up().send(vector).wait_ms(1000);
    let status: Status = lab.statuses.last().expect("statuses continue").1;
    assert!(status.x_mm.is_finite());
}
