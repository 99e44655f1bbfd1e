//! The session engine against statuses made by hand.

mod desk;
mod link;
mod over;
mod traps;

use std::time::Duration;

use dobot_session::{SendError, Session};
use dobot_wire::{Dialect, JointJog, JointJogAxis, MovingMode};

use crate::desk::{Desk, status, target, vector};

#[test]
fn one_command_is_sent_for_each_status() {
    let mut desk = Desk::ahead(Some(Dialect::SPECIFICATION));
    for y in [1.0, 2.0, 3.0] {
        desk.session.send(vector(0.0, y)).expect("it is allowed");
    }
    assert_eq!(desk.packets(), 0);
    desk.status_at(200.0, 0.0, 0.0);
    assert_eq!(desk.packets(), 1);
    assert_eq!(desk.packets(), 0);
    desk.status_at(200.0, 0.0, 0.0);
    desk.status_at(200.0, 0.0, 0.0);
    assert_eq!(desk.packets(), 2);
}

#[test]
fn permits_do_not_accumulate() {
    let mut desk = Desk::new(Some(Dialect::SPECIFICATION));
    for _ in 0..5 {
        desk.status_at(200.0, 0.0, 0.0);
    }
    for y in [1.0, 2.0] {
        desk.session.send(vector(0.0, y)).expect("it is allowed");
    }
    assert_eq!(desk.packets(), 1);
}

#[test]
fn a_packet_sent_late_in_a_period_is_not_followed_by_the_next_at_once() {
    let mut desk = Desk::new(Some(Dialect::FIRMWARE_1_1));
    desk.status_at(200.0, 0.0, 0.0);
    // The permit is kept, and used shortly before the next status.
    desk.session
        .handle_time(desk.now + Duration::from_millis(70));
    for y in [1.0, 2.0] {
        desk.session.send(vector(0.0, y)).expect("it is allowed");
    }
    assert_eq!(desk.packets(), 1);
    desk.status_at(200.0, 0.0, 0.0);
    assert_eq!(desk.packets(), 0, "10 ms later is too soon");
    desk.status_at(200.0, 0.0, 0.0);
    assert_eq!(desk.packets(), 1);
}

#[test]
fn statuses_that_arrive_in_a_burst_permit_one_command() {
    let mut desk = Desk::new(Some(Dialect::SPECIFICATION));
    for y in 1..=12_u8 {
        let by = vector(0.0, y.into());
        desk.session.send(by).expect("it is allowed");
    }
    let bytes = status(200.0, 0.0, 0.0).emit().to_bytes();
    // A computer that slept a second reads all that was kept for it, in pieces.
    for n in 0..12 {
        let now = Duration::from_secs(1) + Duration::from_micros(50 * n);
        desk.session.handle_bytes(now, &bytes);
    }
    assert_eq!(desk.packets(), 1);
    desk.now = Duration::from_secs(1);
    desk.status_at(200.0, 0.0, 0.0);
    assert_eq!(desk.packets(), 1);
}

#[test]
fn in_a_dialect_with_twenty_statuses_a_second_one_is_due_every_50_ms() {
    let mut dialect = Dialect::FIRMWARE_1_1;
    dialect.status_period_ms = 50;
    for mut session in [Session::trusted(Some(dialect)), Session::trusted(None)] {
        session.set_dialect(dialect);
        let bytes = status(200.0, 0.0, 0.0).emit().to_bytes();
        let mut at_ms = 0;
        // Two are missing.
        for gap_ms in [50, 50, 50, 150, 50, 50, 50] {
            at_ms += gap_ms;
            session.handle_bytes(Duration::from_millis(at_ms), &bytes);
        }
        let quality = session.link();
        assert_eq!(quality.lost, 2);
        assert!(
            (quality.statuses_per_s - 6.0 / 0.4).abs() < 1e-9,
            "{quality:?}"
        );
    }
}

#[test]
fn commands_that_depend_on_an_unknown_dialect_are_refused_and_others_are_not() {
    let mut session = Session::trusted(None);
    for command in [
        target(MovingMode::MovL, 200.0, 0.0),
        target(MovingMode::MovJ, 200.0, 0.0),
    ] {
        let error = session
            .send(command)
            .expect_err("1 and 2 are read both ways");
        assert!(matches!(error, SendError::Undecided { .. }), "{error}");
    }
    let error = session
        .send(vector(5.0, 0.0))
        .expect_err("X goes either way");
    assert!(error.to_string().contains("float"), "{error}");
    let jump = target(MovingMode::Jump, 200.0, 0.0);
    session.send(jump).expect("0 is JUMP everywhere");
    let laser_off = JointJog::new(JointJogAxis::LaserOff, 0.0);
    session
        .send(laser_off)
        .expect("it means the same everywhere");
}

#[test]
fn a_value_beyond_its_table_is_not_sent() {
    let mut session = Session::trusted(Some(Dialect::SPECIFICATION));
    let error = session
        .send(target(MovingMode::MovL, f32::NAN, 0.0))
        .expect_err("NaN goes nowhere");
    let SendError::Invalid(source) = error else {
        panic!("{error}");
    };
    assert!(source.to_string().contains("float 3"), "{source}");
    assert_eq!(session.waiting(), 0);
}

#[test]
fn final_packets_are_sent_without_a_permit_and_before_all_queued_ones() {
    let mut desk = Desk::new(Some(Dialect::SPECIFICATION));
    desk.session.send(vector(0.0, 1.0)).expect("it is allowed");
    let laser_off = JointJog::new(JointJogAxis::LaserOff, 0.0);
    desk.session.send_now(laser_off).expect("it is allowed");
    assert_eq!(desk.session.waiting(), 0);
    assert_eq!(desk.packets(), 1);
}
