//! Silence, noise and the reset of an arm by its port.

use std::time::Duration;

use dobot_motion::LASER_OFF;
use dobot_session::{Event, NoStatus, Session};
use dobot_wire::{Command, Dialect, JointJog, JointJogAxis};

use crate::desk::{Desk, status, vector};

#[test]
fn a_second_of_silence_is_a_lost_link() {
    let mut desk = Desk::new(None);
    desk.status_at(200.0, 0.0, 0.0);
    desk.session
        .handle_time(desk.now + Duration::from_millis(999));
    assert_eq!(desk.events(), []);
    desk.session.handle_time(desk.now + Duration::from_secs(1));
    assert_eq!(
        desk.events(),
        [Event::LinkLost {
            silent_for: Duration::from_secs(1),
            received: NoStatus::Nothing
        }]
    );
    desk.session.handle_time(desk.now + Duration::from_secs(9));
    assert_eq!(desk.events(), [], "it is reported once");
}

#[test]
fn an_arm_reset_by_the_opening_of_its_port_has_five_seconds() {
    let mut session = Session::trusted(None);
    session.handle_time(Duration::from_millis(4900));
    assert_eq!(session.poll_event(), None);
    session.handle_bytes(Duration::from_millis(4950), &[0x07; 30]);
    session.handle_time(Duration::from_secs(5));
    assert_eq!(
        session.poll_event(),
        Some(Event::LinkLost {
            silent_for: Duration::from_secs(5),
            received: NoStatus::Other { bytes: 30 }
        })
    );
}

#[test]
fn a_full_queue_is_not_a_lost_link() {
    let mut desk = Desk::ahead(Some(Dialect::SPECIFICATION));
    desk.status_at(200.0, 10.0, 0.0);
    for n in 1..=5_u8 {
        let by = if n % 2 == 0 { -60.0 } else { 60.0 };
        desk.session.send(vector(0.0, by)).expect("it is allowed");
        desk.status_at(200.0, 10.0, 0.0);
    }
    assert_eq!(desk.session.in_flight(), 5);
    desk.session.handle_time(desk.now + Duration::from_secs(20));
    assert_eq!(desk.events(), []);
    desk.session
        .handle_time(desk.now + Duration::from_secs(1000));
    assert!(matches!(desk.events()[..], [Event::LinkLost { .. }]));
}

/// An arm whose base is at 0, and a computer that is frozen for a second and sends a packet before it reads the statuses
/// sent meanwhile.
fn still_arm_after(commands: &[Command]) -> Desk {
    let mut desk = Desk::new(Some(Dialect::SPECIFICATION));
    for _ in 0..3 {
        desk.status_at(200.0, 0.0, 0.0);
    }
    desk.now += Duration::from_secs(1);
    desk.session.handle_time(desk.now);
    for command in commands {
        desk.session.emit_now(command).expect("it is allowed");
        desk.session.note_urgent(command);
    }
    desk
}

#[test]
fn an_arm_at_rest_with_the_same_pose_after_a_silence_was_not_reset_even_if_its_laser_went_off() {
    let mut desk = still_arm_after(&[LASER_OFF]);
    for _ in 0..3 {
        desk.status_at(200.0, 0.0, 0.0);
    }
    assert!(desk.session.is_trusted());
}

#[test]
fn an_arm_commanded_to_move_before_a_silence_may_have_been_reset_even_with_the_same_pose() {
    let turn = JointJog::new(JointJogAxis::BasePlus, 50.0).into();
    let release = JointJog::new(JointJogAxis::Released, 0.0).into();
    for commands in [&[turn][..], &[turn, LASER_OFF], &[turn, release]] {
        let mut desk = still_arm_after(commands);
        desk.now += Duration::from_secs(1);
        desk.status_at(200.0, 0.0, 0.0);
        assert!(!desk.session.is_trusted(), "{commands:?}");
    }
}

/// This many statuses of a base at 0, all read at once after a silence of this many milliseconds.
fn read_at_once(desk: &mut Desk, statuses: usize, silent_ms: u64) {
    desk.now += Duration::from_millis(silent_ms);
    desk.session.handle_stall(desk.now);
    desk.session.handle_time(desk.now);
    let bytes = status(200.0, 0.0, 0.0).emit().to_bytes().repeat(statuses);
    desk.session.handle_bytes(desk.now, &bytes);
}

#[test]
fn an_arm_that_kept_sending_while_the_computer_was_suspended_was_not_reset() {
    for statuses in [7, 14, 25] {
        let mut desk = Desk::new(Some(Dialect::SPECIFICATION));
        desk.status_at(200.0, 0.0, 0.0);
        desk.session.send(vector(0.0, 60.0)).expect("it is allowed");
        desk.status_at(200.0, 0.0, 0.0);
        read_at_once(&mut desk, statuses, 80 * statuses as u64 + 70);
        assert!(desk.session.is_trusted(), "{statuses} statuses");
        assert!(
            desk.events()
                .iter()
                .all(|event| !matches!(event, Event::LinkLost { .. }))
        );
    }
}

#[test]
fn an_arm_that_was_silent_for_a_part_of_that_time_may_have_been_reset() {
    // The base is at 0 only after the reset, and 0.7 s of statuses are missing.
    let mut desk = Desk::new(Some(Dialect::SPECIFICATION));
    desk.status_at(200.0, 0.0, 0.0);
    desk.session.send(vector(0.0, 60.0)).expect("it is allowed");
    desk.status_at(200.0, 0.0, 0.0);
    read_at_once(&mut desk, 10, 1_500);
    assert!(!desk.session.is_trusted());
}

#[test]
fn the_number_of_queued_commands_is_limited_if_the_base_may_come_to_0() {
    let mut desk = Desk::ahead(Some(Dialect::SPECIFICATION));
    desk.status_at(200.0, 0.0, 0.0);
    for n in 1..=5_u8 {
        // Every second one ends with the base at 0, as after a reset.
        let by = if n % 2 == 0 { -60.0 } else { 60.0 };
        desk.session.send(vector(0.0, by)).expect("it is allowed");
        desk.status_at(200.0, 0.0, 0.0);
    }
    assert_eq!((desk.session.in_flight(), desk.session.waiting()), (4, 1));
}

#[test]
fn noise_between_statuses_is_reported_and_loses_none() {
    let mut desk = Desk::new(None);
    desk.status_at(200.0, 0.0, 0.0);
    desk.session.handle_bytes(desk.now, &[0xA5, 1, 2, 3, 0xA5]);
    let events = desk.status_at(200.0, 0.0, 0.0);
    assert_eq!(events, [Event::Resynced { skipped: 5 }]);
}

#[test]
fn statuses_that_arrive_late_in_a_burst_are_not_lost_and_missing_ones_are() {
    let mut desk = Desk::new(None);
    for _ in 0..10 {
        desk.status_at(200.0, 0.0, 0.0);
    }
    let bytes = status(200.0, 0.0, 0.0).emit().to_bytes();
    desk.now += Duration::from_millis(400);
    for _ in 0..5 {
        desk.session.handle_bytes(desk.now, &bytes);
    }
    assert_eq!(desk.session.link().lost, 0);
    desk.now += Duration::from_millis(240);
    desk.session.handle_bytes(desk.now, &bytes);
    desk.status_at(200.0, 0.0, 0.0);
    assert_eq!(desk.session.link().lost, 2);
}

#[test]
fn a_good_link_carries_12_5_statuses_a_second_and_the_rate_of_a_silent_one_falls() {
    let mut desk = Desk::new(None);
    for _ in 0..40 {
        desk.status_at(200.0, 0.0, 0.0);
    }
    let rate = |desk: &Desk| desk.session.link().statuses_per_s;
    assert!((rate(&desk) - 12.5).abs() < 1e-9, "{}", rate(&desk));
    desk.session
        .handle_time(desk.now + Duration::from_millis(79));
    assert!((rate(&desk) - 12.5).abs() < 1e-9, "{}", rate(&desk));
    desk.session.handle_time(desk.now + Duration::from_secs(1));
    assert!((rate(&desk) - 6.8).abs() < 0.8, "{}", rate(&desk));
    desk.session.handle_time(desk.now + Duration::from_secs(3));
    assert_eq!(rate(&desk), 0.0);
}
