//! Power-up, status schedule and queue.

use dobot_controller::{Personality, PowerUp};
use dobot_wire::{JointJog, JointJogAxis};

use crate::lab::Lab;
use crate::moving::movl;

#[test]
fn reports_its_state_every_80_ms_from_60_ms_after_power_up() {
    let lab = Lab::power_up().wait_ms(300);
    let times: Vec<u64> = lab.statuses.iter().map(|it| it.0).collect();
    assert_eq!(times, [60, 140, 220, 300]);
}

#[test]
fn starts_where_the_tilt_sensors_say_with_the_base_straight_ahead() {
    let lab = Lab::power_up_with(PowerUp::new(Personality::Specification).with_tilt(60.0, 30.0))
        .wait_ms(60);
    let status = lab.statuses[0].1;
    assert_eq!(
        (status.base_deg, status.rear_deg, status.fore_deg),
        (0.0, 60.0, 30.0)
    );
    // 135 sin 60 + 160 cos 30 + 55.07, and 135 cos 60 - 160 sin 30.
    assert!((status.x_mm - 310.547_5).abs() < 1e-3, "{status:?}");
    assert!((status.z_mm - -12.5).abs() < 1e-4, "{status:?}");
    assert_eq!(status.y_mm, 0.0);
}

#[test]
fn falls_silent_while_four_commands_wait_and_goes_on_when_there_is_room() {
    let mut lab = Lab::power_up().wait_ms(60);
    let x = lab.position().x.0;
    // The first is executed, the others wait.
    for n in 1..=5 {
        lab = lab.send(movl(x - f64::from(n) * 10.0, 0.0, 0.0));
    }
    let lab = lab.wait_ms(2000);
    let gaps: Vec<u64> = lab
        .statuses
        .windows(2)
        .map(|it| it[1].0 - it[0].0)
        .collect();
    assert!(gaps.iter().any(|&gap| gap > 80), "never silent: {gaps:?}");
    assert_eq!(*gaps.last().expect("there are statuses"), 80);
    lab.expect_no_refusal();
}

#[test]
fn a_command_is_obeyed_at_the_next_tick_however_long_nothing_was_done() {
    for personality in Personality::ALL {
        for ms in [10_010, 10_030, 10_050, 10_070] {
            let mut lab = Lab::power_up_with(PowerUp::new(personality)).wait_ms(ms);
            let jog = JointJog::new(JointJogAxis::SuctionOn, 100.0);
            lab = lab.send(jog).wait_ms(9);
            assert!(!lab.controller.suction(), "{personality} at {ms} ms");
            assert!(
                lab.wait_ms(1).controller.suction(),
                "{personality} at {ms} ms"
            );
        }
    }
}

#[test]
fn refuses_a_seventh_command_in_the_queue() {
    let mut lab = Lab::power_up().wait_ms(60);
    for n in 1..=8 {
        lab = lab.send(movl(250.0, f64::from(n), 0.0));
    }
    // None has begun yet: six wait, two are too many.
    let refusals = lab.refusals();
    assert_eq!(refusals.len(), 2, "{refusals:?}");
    assert!(refusals[0].contains("all 6 places of the queue are taken"));
    lab.wait_ms(5000)
        .expect_at(250.0, 6.0, 0.0)
        .expect_no_refusal();
}

#[test]
fn unfetched_statuses_are_lost_oldest_first_and_counted() {
    let mut lab = Lab::power_up();
    lab.controller
        .handle_time(std::time::Duration::from_secs(8));
    let fetched = std::iter::from_fn(|| lab.controller.poll_bytes()).count();
    let counters = *lab.controller.counters();
    assert_eq!(counters.statuses, 100);
    assert_eq!(fetched as u64 + counters.lost_statuses, 100);
}

#[test]
fn a_command_takes_effect_at_the_tick_after_its_last_byte() {
    let on = JointJog::new(JointJogAxis::SuctionOn, 0.0);
    let lab = Lab::power_up().wait_ms(45).send(on);
    assert!(!lab.controller.suction());
    let lab = lab.wait_ms(14);
    assert!(!lab.controller.suction());
    assert!(lab.wait_ms(1).controller.suction());
}
