//! Traps that a stock arm would not recover from.

use std::time::Duration;

use dobot_session::{CommandId, Event, SendError};
use dobot_wire::{Dialect, JointJog, JointJogAxis, MovingMode, Voice};

use crate::desk::{Desk, PERIOD, status, target, vector};

#[test]
fn a_line_to_the_current_place_of_a_stock_arm_is_not_sent() {
    let mut desk = Desk::new(Some(Dialect::FIRMWARE_1_1));
    desk.status_at(200.0, 0.0, 0.0);
    let here = target(MovingMode::MovL, 200.0, 0.0);
    assert_eq!(desk.session.send(here), Err(SendError::OnTheSpot));
    let there = target(MovingMode::MovL, 220.0, 0.0);
    desk.session.send(there).expect("it leads elsewhere");
    assert_eq!(desk.session.send(there), Err(SendError::OnTheSpot));
    desk.session
        .send(here)
        .expect("by then the arm is elsewhere");

    let mut desk = Desk::new(Some(Dialect::SPECIFICATION));
    desk.status_at(200.0, 0.0, 0.0);
    desk.session
        .send(here)
        .expect("it does no harm to an arm of the document");
}

/// A button of the joints at half its speed, or the release of all.
fn jog(axis: JointJogAxis) -> JointJog {
    JointJog::new(axis, 50.0)
}

/// A button is pressed and released, and a straight line to the previous place of the arm waits after that.
fn line_after_a_jog(desk: &mut Desk) -> CommandId {
    for _ in 0..2 {
        desk.status_at(200.0, 0.0, 0.0);
    }
    for axis in [JointJogAxis::BasePlus, JointJogAxis::Released] {
        desk.session.send(jog(axis)).expect("it is allowed");
    }
    let line = target(MovingMode::MovL, 200.0, 0.0);
    desk.session.send(line).expect("it may lead elsewhere")
}

#[test]
fn a_line_after_a_jog_that_moved_nothing_is_not_sent() {
    let mut desk = Desk::new(Some(Dialect::FIRMWARE_1_1));
    let line = line_after_a_jog(&mut desk);
    let events: Vec<Event> = (0..100)
        .flat_map(|_| desk.status_at(200.0, 0.0, 0.0))
        .collect();
    let not_sent = Event::NotSent {
        command: line,
        reason: SendError::OnTheSpot,
    };
    assert!(events.contains(&not_sent), "{events:?}");
    assert_eq!(desk.packets(), 2, "the button and its release");
}

#[test]
fn a_line_after_a_jog_is_sent_when_the_arm_rests_elsewhere() {
    let mut desk = Desk::new(Some(Dialect::FIRMWARE_1_1));
    line_after_a_jog(&mut desk);
    for n in 0..20 {
        desk.status_at(200.0, f64::from(n), 0.0);
    }
    assert_eq!((desk.packets(), desk.session.waiting()), (2, 1));
    for _ in 0..9 {
        desk.status_at(200.0, 20.0, 0.0);
    }
    assert_eq!((desk.packets(), desk.session.waiting()), (1, 0));
}

#[test]
fn a_release_after_an_unsent_command_is_still_sent() {
    let mut desk = Desk::new(Some(Dialect::SPECIFICATION));
    desk.status_at(200.0, 0.0, 0.0);
    let lasting = Duration::from_secs(1);
    desk.session.arm_laser(lasting);
    desk.session
        .send(jog(JointJogAxis::BasePlus))
        .expect("it is allowed");
    let burning = vector(0.0, 5.0).burning();
    desk.session.send(burning).expect("it is armed");
    desk.session
        .send(jog(JointJogAxis::Released))
        .expect("it is allowed");
    desk.session.disarm_laser();
    for _ in 0..9 {
        desk.status_at(200.0, 0.0, 0.0);
    }
    assert_eq!((desk.packets(), desk.session.waiting()), (2, 0));
}

fn voice(text: &str) -> Voice {
    Voice::new(text).expect("it is ASCII and short")
}

#[test]
fn voice_is_not_sent_before_the_arm_was_seen_at_rest() {
    let mut desk = Desk::new(Some(Dialect::SPECIFICATION));
    for y_mm in [0.0, 2.0, 4.0] {
        desk.status_at(200.0, y_mm, 0.0);
    }
    desk.session.send(voice("left ten")).expect("it is allowed");
    for y_mm in [6.0, 8.0, 9.0] {
        desk.status_at(200.0, y_mm, 0.0);
        assert_eq!(desk.packets(), 0, "the arm moves: {y_mm}");
    }
    desk.status_at(200.0, 9.0, 0.0);
    assert_eq!(desk.packets(), 1, "the arm rests");
}

#[test]
fn voice_after_a_move_waits_until_the_move_is_over() {
    let mut desk = Desk::ahead(Some(Dialect::SPECIFICATION));
    for _ in 0..3 {
        desk.status_at(200.0, 0.0, 0.0);
    }
    let away = target(MovingMode::MovL, 200.0, 20.0);
    desk.session.send(away).expect("it is allowed");
    desk.session.send(voice("up ten")).expect("it is allowed");
    for y in [0, 0, 0, 4, 8, 12, 16, 19] {
        desk.status_at(200.0, f64::from(y), 0.0);
    }
    assert_eq!(desk.packets(), 1, "the move alone");
    for _ in 0..20 {
        desk.status_at(200.0, 20.0, 0.0);
    }
    assert_eq!(desk.packets(), 1, "the text");
}

#[test]
fn a_text_without_an_order_is_refused() {
    let mut desk = Desk::new(Some(Dialect::SPECIFICATION));
    desk.status_at(200.0, 0.0, 0.0);
    for text in ["hello", "", "up 10"] {
        let refused = desk.session.send(voice(text));
        assert!(matches!(refused, Err(SendError::Trap(_))), "{refused:?}");
    }
    assert_eq!(desk.packets(), 0);
}

#[test]
fn a_stock_arm_gets_no_voice_on_either_port() {
    let mut usb = Desk::new(Some(Dialect::FIRMWARE_1_1));
    for _ in 0..3 {
        usb.status_at(200.0, 0.0, 0.0);
    }
    let mut bluetooth = Desk::new(Some(Dialect::FIRMWARE_1_1));
    let mut message = status(200.0, 0.0, 0.0);
    message.x_mm += 1000.0;
    for _ in 0..3 {
        bluetooth.now += PERIOD;
        let bytes = message.emit().to_bytes();
        bluetooth.session.handle_bytes(bluetooth.now, &bytes);
    }
    assert!(bluetooth.session.is_bluetooth());
    for mut desk in [usb, bluetooth] {
        // A stock arm hears 22 for sixteen.
        let refused = desk.session.send(voice("back sixteen"));
        let refused = refused.expect_err("it would be misheard");
        assert!(refused.to_string().contains("instead"), "{refused}");
        assert_eq!(desk.packets(), 0);
    }
}
