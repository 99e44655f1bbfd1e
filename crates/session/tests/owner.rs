//! Features of a session for a long-term owner of an arm: dialects learned later, ports opened
//! again, urgent packets, and a view of the commands in flight.

use std::time::Duration;

use dobot_session::{Event, SendError, Session};
use dobot_wire::{
    Command, Dialect, JointJog, JointJogAxis, LinearJog, LinearJogAxis, MoveTo, MovingMode, Packet,
    Status, WriteVector,
};

const PERIOD: Duration = Dialect::SPECIFICATION.status_period();

/// Rear arm upright, forearm level.
const STATUS: Status = Status::AT_ZERO;

fn report(session: &mut Session, now: Duration) {
    session.handle_bytes(now, &STATUS.emit().to_bytes());
}

fn line(x_mm: f32) -> MoveTo {
    MoveTo::to(x_mm, 0.0, 100.0).with_mode(MovingMode::MovL)
}

fn stroke(y_mm: f32) -> WriteVector {
    WriteVector::by(0.0, y_mm, 0.0, 50.0)
}

fn packets(session: &mut Session) -> usize {
    std::iter::from_fn(|| session.poll_bytes()).count()
}

#[test]
fn a_dialect_learned_later_applies_from_then_on() {
    let mut session = Session::trusted(None);
    report(&mut session, PERIOD);
    assert!(matches!(
        session.send(line(220.0)),
        Err(SendError::Undecided { .. })
    ));
    let height = |session: &Session| {
        session
            .model()
            .expect("a status arrived")
            .settings
            .jump_height
            .0
    };
    assert_eq!(height(&session), 20.0);
    session.set_dialect(Dialect::FIRMWARE_1_1);
    assert_eq!(height(&session), 10.0);
    session.send(line(220.0)).expect("it is known now");
}

#[test]
fn a_packet_is_read_by_its_dialect_and_refused_if_that_matters_and_is_unknown() {
    let command = Command::from(line(220.0));
    let packet = command.emit(&Dialect::FIRMWARE_1_1);
    let stock = Session::trusted(Some(Dialect::FIRMWARE_1_1));
    assert_eq!(stock.parse(&packet), Ok(command));
    let unknown = Session::trusted(None);
    assert!(matches!(
        unknown.parse(&packet),
        Err(SendError::Undecided { .. })
    ));
    let jog = Command::from(JointJog::new(JointJogAxis::BasePlus, 10.0));
    assert_eq!(unknown.parse(&jog.emit(&Dialect::FIRMWARE_1_1)), Ok(jog));
}

#[test]
fn a_reopened_port_has_five_seconds_and_no_permit() {
    let mut session = Session::trusted(Some(Dialect::SPECIFICATION));
    report(&mut session, PERIOD);
    let again = Duration::from_mins(1);
    session.handle_open(again);
    session.send(stroke(5.0)).expect("it is allowed");
    assert_eq!(packets(&mut session), 0);
    session.handle_time(again + Duration::from_millis(4900));
    let lost = |session: &mut Session| {
        std::iter::from_fn(|| session.poll_event())
            .any(|event| matches!(event, Event::LinkLost { .. }))
    };
    assert!(!lost(&mut session));
    session.handle_time(again + Duration::from_secs(5));
    assert!(lost(&mut session));
    report(&mut session, again + Duration::from_secs(6));
    assert_eq!(packets(&mut session), 1);
}

#[test]
fn discarded_commands_are_named_by_their_ids() {
    let mut session = Session::trusted(Some(Dialect::SPECIFICATION));
    let ids: Vec<_> = [1.0, 2.0, 3.0]
        .map(|y| session.send(stroke(y)).expect("it is allowed"))
        .into();
    report(&mut session, PERIOD);
    assert_eq!(session.discard_waiting(), ids[1..]);
}

#[test]
fn a_full_queue_is_distinguished_from_an_idle_link() {
    let mut session = Session::trusted(Some(Dialect::SPECIFICATION)).with_ahead(Duration::MAX);
    let mut now = PERIOD;
    report(&mut session, now);
    session.handle_time(now + PERIOD * 3);
    assert!(!session.queue().is_full, "nothing is under way");
    for n in 0..4_u8 {
        let by = if n % 2 == 0 { 40.0 } else { -40.0 };
        session.send(stroke(by)).expect("it is allowed");
        report(&mut session, now + PERIOD * 3);
        now += PERIOD;
    }
    session.handle_time(now + PERIOD * 6);
    let queue = session.queue();
    assert_eq!((queue.in_flight, queue.is_full), (4, true));
    // Four strokes of 1.3 s each.
    let ahead_s = queue.ahead.as_secs_f64();
    assert!((4.0..5.3).contains(&ahead_s), "{ahead_s}");
    assert!(session.is_moving() && session.rests_within() > queue.ahead);
}

#[test]
fn a_jog_is_released_by_its_own_kind() {
    for (held, expected) in [
        (LinearJogAxis::ZPlus, LinearJogAxis::Released),
        (LinearJogAxis::YMinus, LinearJogAxis::Released),
    ] {
        let mut session = Session::trusted(Some(Dialect::FIRMWARE_1_1));
        report(&mut session, PERIOD);
        let jog = LinearJog::new(held, 10.0);
        session.send(jog).expect("it is allowed");
        assert_eq!(
            session.release(),
            Some(Command::from(LinearJog::new(expected, 0.0)))
        );
        assert_eq!(session.rests_within(), Duration::MAX);
    }
}

#[test]
fn an_urgent_packet_sent_outside_the_session_is_accounted_for() {
    let mut session = Session::trusted(Some(Dialect::FIRMWARE_1_1));
    report(&mut session, PERIOD);
    let laser = Command::from(JointJog::new(JointJogAxis::LaserOn, 0.0));
    let packet = session.emit_now(&laser).expect("it is allowed");
    assert!(matches!(packet, Packet::Frame(_)));
    assert_eq!(packets(&mut session), 0, "the caller sends it");
    session.note_urgent(&laser);
    assert!(session.model().expect("a status arrived").laser);
}

#[test]
fn an_urgent_packet_that_moves_nothing_is_over_soon() {
    let mut session = Session::trusted(Some(Dialect::FIRMWARE_1_1));
    report(&mut session, PERIOD);
    let laser_off = JointJog::new(JointJogAxis::LaserOff, 0.0);
    session.send_now(laser_off).expect("it is allowed");
    assert!(session.is_moving(), "it is not known yet");
    for n in 2..8 {
        report(&mut session, PERIOD * n);
    }
    assert!(!session.is_moving());
    assert!(session.model().expect("a status arrived").knows_place());
}

fn burn(y_mm: f32) -> WriteVector {
    stroke(y_mm).burning()
}

fn events(session: &mut Session) -> Vec<Event> {
    std::iter::from_fn(|| session.poll_event()).collect()
}

#[test]
fn burning_commands_are_refused_unless_the_laser_is_armed() {
    let mut session = Session::trusted(Some(Dialect::SPECIFICATION));
    report(&mut session, PERIOD);
    let refused = Err(SendError::LaserDisarmed);
    assert_eq!(session.send(burn(10.0)), refused);
    let on = JointJog::new(JointJogAxis::LaserOn, 0.0);
    assert_eq!(session.send(on), refused);
    assert_eq!(packets(&mut session), 0);
    session.send(stroke(10.0)).expect("it does not burn");
    session.arm_laser(Duration::from_secs(1));
    session.send(burn(10.0)).expect("it is armed");
    session.handle_time(Duration::from_secs(1));
    assert_eq!(session.send(burn(10.0)), refused);
}

#[test]
fn burning_commands_still_queued_when_the_arming_time_ends_are_not_sent() {
    let mut session = Session::trusted(Some(Dialect::SPECIFICATION));
    report(&mut session, PERIOD);
    session.arm_laser(Duration::from_secs(1));
    let first = session.send(stroke(5.0)).expect("it is allowed");
    let kept = session.send(stroke(5.0)).expect("it is allowed");
    let burning = session.send(burn(5.0)).expect("it is armed");
    let after = session.send(stroke(5.0)).expect("it is allowed");
    events(&mut session);
    session.handle_time(Duration::from_secs(1));
    let reported = events(&mut session);
    let not_sent = |command| Event::NotSent {
        command,
        reason: SendError::LaserDisarmed,
    };
    assert!(reported.contains(&not_sent(burning)), "{reported:?}");
    assert!(reported.contains(&not_sent(after)), "{reported:?}");
    assert!(
        reported.contains(&Event::LaserDisarmed(dobot_session::Disarmed::TimeOver)),
        "{reported:?}"
    );
    assert!(first < kept && session.waiting() == 1, "{reported:?}");
}

#[test]
fn the_laser_is_disarmed_by_silence_by_reopening_the_port_and_by_a_reset() {
    let armed = || {
        let mut session = Session::trusted(Some(Dialect::SPECIFICATION));
        report(&mut session, PERIOD);
        session.arm_laser(Duration::from_mins(10));
        session
    };
    let mut silent = armed();
    silent.handle_time(Duration::from_secs(5));
    assert_eq!(silent.laser_armed_until(), None);
    let mut opened = armed();
    opened.handle_open(Duration::from_secs(1));
    assert_eq!(opened.laser_armed_until(), None);
    let mut reset = armed();
    let elsewhere = Status {
        x_mm: 0.0,
        y_mm: 160.0 + 55.07,
        base_deg: 90.0,
        rotation_deg: 90.0,
        ..STATUS
    };
    reset.handle_bytes(PERIOD * 2, &elsewhere.emit().to_bytes());
    assert!(!reset.is_trusted(), "it is seen");
    assert_eq!(reset.laser_armed_until(), None);
}

#[test]
fn a_free_laser_needs_no_arming_and_is_not_disarmed() {
    let mut session = Session::trusted(Some(Dialect::SPECIFICATION)).with_free_laser();
    report(&mut session, PERIOD);
    session.send(burn(5.0)).expect("it is free");
    session.handle_open(Duration::from_secs(1));
    session.disarm_laser();
    session.send(burn(5.0)).expect("it is free");
}
