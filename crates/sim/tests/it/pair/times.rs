//! When bytes arrive, and when commands act.

use super::*;

#[tokio::test]
async fn a_status_takes_43_68_ms_and_the_next_one_comes_80_ms_later() {
    let mut peer = in_process();
    let mut bytes = Vec::new();
    assert!(peer.receive(Duration::MAX, &mut bytes));
    // Some of its bytes came before the last one: what counts is when it is whole.
    while bytes.len() < 42 {
        assert!(peer.receive(Duration::MAX, &mut bytes));
    }
    assert_eq!(peer.now(), ms(60) + Duration::from_micros(43_680));
    while bytes.len() < 84 {
        assert!(peer.receive(Duration::MAX, &mut bytes));
    }
    assert_eq!(peer.now(), ms(140) + Duration::from_micros(43_680));
}

/// When an arm to which a jog is sent at `sent` is first seen to have begun it.
fn begins_at(sent: Duration) -> Duration {
    let mut arm = virtual_arm();
    let jog: Command = button(JointJogAxis::BasePlus, 100.0).into();
    let bytes = jog.emit(&Dialect::SPECIFICATION).to_bytes();
    arm.handle_bytes(sent, &bytes);
    while arm.controller().counters().begun == 0 {
        let next = arm.poll_wakeup();
        arm.handle_time(next);
        arm.poll_bytes(&mut Vec::new());
    }
    arm.now()
}

#[test]
fn a_command_acts_in_the_first_tick_after_it_has_arrived_whole() {
    let travel = Duration::from_micros(43_680);
    let arrives = ms(100).saturating_sub(travel);
    let just_in_time = arrives.saturating_sub(Duration::from_nanos(1));
    assert_eq!(begins_at(just_in_time), ms(100));
    assert_eq!(begins_at(arrives), ms(120), "a tick has no ears");
    assert_eq!(begins_at(ms(0)), ms(60));
}

#[test]
fn a_packet_torn_by_the_clock_is_the_same_packet() {
    let jog: Command = button(JointJogAxis::BasePlus, 100.0).into();
    let bytes = jog.emit(&Dialect::SPECIFICATION).to_bytes();
    let mut arm = virtual_arm();
    for (n, byte) in (0_u64..).zip(bytes) {
        arm.handle_bytes(ms(7 * n), &[byte]);
    }
    arm.handle_time(ms(1000));
    let counters = arm.controller().counters();
    assert_eq!((counters.packets, counters.begun), (1, 1));
}
