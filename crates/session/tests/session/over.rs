//! When a command is over, and when it was missed.

use std::time::Duration;

use dobot_arm::Position;
use dobot_session::{CommandId, Event};
use dobot_wire::{Configuration, Dialect, MouseMove, MoveTo, MovingMode, Status};

use crate::desk::{Desk, PERIOD, completed, status, target, vector};

#[test]
fn a_move_is_over_when_the_arm_rests_at_its_target() {
    let mut desk = Desk::new(Some(Dialect::SPECIFICATION));
    desk.status_at(200.0, 0.0, 0.0);
    desk.session
        .send(target(MovingMode::MovJ, 220.0, 10.0))
        .expect("it is allowed");
    assert!(completed(&desk.status_at(200.0, 0.0, 0.0)).is_empty());
    assert!(completed(&desk.status_at(210.0, 5.0, 2.0)).is_empty());
    assert!(completed(&desk.status_at(220.0, 10.0, 0.0)).is_empty());
    assert_eq!(completed(&desk.status_at(220.0, 10.0, 0.0)), [0]);
    assert_eq!(desk.session.in_flight(), 0);
}

#[test]
fn targets_passed_without_a_rest_are_over_when_the_queue_has_room_for_more() {
    let mut desk = Desk::ahead(Some(Dialect::SPECIFICATION));
    desk.status_at(200.0, 0.0, 0.0);
    for n in 0..8_u8 {
        let y_mm = f32::from(n) * 5.0 + 5.0;
        desk.session
            .send(target(MovingMode::MovJ, 200.0, y_mm))
            .expect("it is allowed");
    }
    // Three wait and one is executed when a status comes; two more are on the line.
    let mut over = Vec::new();
    for n in 1..=7_u8 {
        over.extend(completed(&desk.status_at(201.0, 2.0 + f64::from(n), 1.0)));
    }
    assert_eq!(over, [0, 1]);
}

#[test]
fn a_default_pause_is_part_of_each_target() {
    let mut desk = Desk::new(Some(Dialect::SPECIFICATION));
    desk.status_at(200.0, 0.0, 0.0);
    let pause = Configuration::playback([100.0, 100.0, 100.0, 100.0, 100.0, 100.0], 3.0, 10.0);
    desk.session.send(pause).expect("it is allowed");
    for y_mm in [10.0, 20.0] {
        desk.session
            .send(target(MovingMode::MovJ, 220.0, y_mm))
            .expect("it is allowed");
    }
    desk.status_at(200.0, 0.0, 0.0);
    desk.status_at(200.0, 0.0, 0.0);
    let mut events = Vec::new();
    // Three seconds at the first target are 37 statuses and a half.
    for _ in 0..37 {
        events.extend(desk.status_at(220.0, 10.0, 0.0));
    }
    assert_eq!(events, [Event::Completed(CommandId(0))], "the pause is set");
    assert_eq!(completed(&desk.status_at(220.0, 15.0, 0.0)), [1]);
}

#[test]
fn a_mouse_move_is_not_over_before_the_arm_has_moved() {
    // The document's arm goes 10 mm; a stock arm swings, and reaches 0.4 mm further for each (note N9).
    for (dialect, x) in [
        (Dialect::SPECIFICATION, 210.0),
        (Dialect::FIRMWARE_1_1, 204.0),
    ] {
        let mut desk = Desk::new(Some(dialect));
        for _ in 0..20 {
            desk.status_at(200.0, 0.0, 0.0);
        }
        let by = MouseMove {
            x: 10.0,
            y: 0.0,
            z: 0.0,
            rotation_deg: 0.0,
            suction: false,
        };
        desk.session.send(by).expect("it is allowed");
        // It left late in a period, over a slow link: the sixth status is the first that shows it.
        for _ in 0..5 {
            assert!(
                completed(&desk.status_at(200.0, 0.0, 0.0)).is_empty(),
                "{dialect}"
            );
        }
        assert!(
            completed(&desk.status_at(x - 3.0, 0.0, 0.0)).is_empty(),
            "{dialect}"
        );
        assert!(
            completed(&desk.status_at(x, 0.0, 0.0)).is_empty(),
            "{dialect}"
        );
        assert_eq!(completed(&desk.status_at(x, 0.0, 0.0)), [0], "{dialect}");
    }
}

#[test]
fn a_place_shared_by_two_targets_belongs_to_the_first_one_if_the_arm_comes_there_first() {
    let mut desk = Desk::ahead(Some(Dialect::SPECIFICATION));
    desk.status_at(200.0, 0.0, 0.0);
    let pausing = MoveTo {
        pause_s: 0.3,
        ..target(MovingMode::MovJ, 220.0, 10.0)
    };
    for there in [
        pausing,
        target(MovingMode::MovJ, 240.0, 0.0),
        target(MovingMode::MovJ, 220.0, 10.0),
    ] {
        desk.session.send(there).expect("it is allowed");
    }
    let mut over = Vec::new();
    for y_mm in [0.0, 0.0, 5.0, 10.0, 10.0, 10.0, 10.0, 10.0, 10.0] {
        over.extend(completed(&desk.status_at(200.0 + 2.0 * y_mm, y_mm, 0.0)));
    }
    assert_eq!(over, [0]);
    over.extend(completed(&desk.status_at(230.0, 5.0, 0.0)));
    for _ in 0..2 {
        over.extend(completed(&desk.status_at(220.0, 10.0, 0.0)));
    }
    assert_eq!(over, [0, 1, 2]);
}

#[test]
fn a_path_back_to_the_start_does_not_end_the_path_there_as_it_begins() {
    let mut desk = Desk::ahead(Some(Dialect::SPECIFICATION));
    desk.status_at(200.0, 0.0, 0.0);
    for y_mm in [30.0, 0.0] {
        let there = target(MovingMode::MovL, 200.0, y_mm);
        desk.session.send(there).expect("it is allowed");
        desk.status_at(200.0, 0.0, 0.0);
    }
    assert!(completed(&desk.status_at(200.0, 0.03, 0.0)).is_empty());
    assert!(completed(&desk.status_at(200.0, 20.0, 0.0)).is_empty());
    assert!(completed(&desk.status_at(200.0, 25.0, 0.0)).is_empty());
    assert_eq!(completed(&desk.status_at(200.0, 15.0, 0.0)), [0]);
}

#[test]
fn a_pump_that_switches_in_the_middle_of_a_pause_does_not_end_it() {
    let mut desk = Desk::new(Some(Dialect::FIRMWARE_1_1));
    desk.status_at(200.0, 0.0, 0.0);
    let grabbing = MoveTo {
        suction: true,
        pause_s: 1.0,
        ..target(MovingMode::Jump, 220.0, 10.0)
    };
    desk.session.send(grabbing).expect("it is allowed");
    desk.status_at(200.0, 0.0, 0.0);
    desk.status_at(210.0, 5.0, 0.0);
    let mut at = Vec::new();
    for n in 0..20 {
        // At half the pause the pump acts (note N47).
        let status = Status {
            suction: n >= 6,
            ..status(220.0, 10.0, 0.0)
        };
        desk.now += PERIOD;
        let bytes = status.emit().to_bytes();
        desk.session.handle_bytes(desk.now, &bytes);
        at.extend(completed(&desk.events()).iter().map(|_| n));
    }
    assert_eq!(
        at,
        [13],
        "the first status a second after the arm was there"
    );
}

#[test]
fn a_long_pause_is_reported_once_when_it_begins() {
    let mut desk = Desk::new(Some(Dialect::FIRMWARE_1_1));
    desk.status_at(200.0, 0.0, 0.0);
    let pausing = MoveTo {
        pause_s: 8.0,
        ..target(MovingMode::MovJ, 220.0, 10.0)
    };
    desk.session.send(pausing).expect("it is allowed");
    desk.status_at(200.0, 0.0, 0.0);
    desk.status_at(210.0, 5.0, 0.0);
    let mut events = desk.status_at(220.0, 10.0, 0.0);
    assert_eq!(events, []);
    for _ in 0..99 {
        events.extend(desk.status_at(220.0, 10.0, 0.0));
    }
    let pausing = Event::Pausing {
        command: CommandId(0),
        lasts: Duration::from_secs(8),
        by_default: false,
    };
    assert_eq!(events, [pausing]);
    assert_eq!(completed(&desk.status_at(220.0, 10.0, 0.0)), [0]);
}

#[test]
fn all_targets_out_of_reach_are_reported_and_no_reachable_one() {
    let mut desk = Desk::new(Some(Dialect::SPECIFICATION));
    desk.status_at(200.0, 0.0, 0.0);
    for x_mm in [400.0, 500.0] {
        desk.session
            .send(target(MovingMode::MovJ, x_mm, 0.0))
            .expect("it is allowed");
    }
    let mut events = Vec::new();
    for _ in 0..40 {
        events.extend(desk.status_at(200.0, 0.0, 0.0));
    }
    let short = |event: &Event| match event {
        Event::NotReached { command, .. } => Some(command.0),
        _ => None,
    };
    let short: Vec<u64> = events.iter().filter_map(short).collect();
    assert_eq!(short, [0, 1]);
    assert!(completed(&events).is_empty());
}

#[test]
fn a_pause_is_part_of_its_command() {
    let mut desk = Desk::new(Some(Dialect::SPECIFICATION));
    desk.status_at(200.0, 0.0, 0.0);
    let rest = MoveTo {
        pause_s: 0.375,
        ..target(MovingMode::MovL, 220.0, 10.0)
    };
    desk.session.send(rest).expect("it is allowed");
    desk.status_at(200.0, 0.0, 0.0);
    let at: Vec<usize> = (0..8)
        .filter(|_| !completed(&desk.status_at(220.0, 10.0, 0.0)).is_empty())
        .collect();
    assert_eq!(at, [5]);
}

#[test]
fn a_vector_is_over_when_the_arm_is_seen_on_a_later_one() {
    let mut desk = Desk::ahead(Some(Dialect::SPECIFICATION));
    desk.status_at(200.0, 0.0, 0.0);
    for by in [vector(0.0, 10.0), vector(10.0, 0.0), vector(0.0, -10.0)] {
        desk.session.send(by).expect("it is allowed");
        desk.status_at(200.0, 0.0, 0.0);
    }
    assert!(completed(&desk.status_at(200.0, 5.0, 0.0)).is_empty());
    assert_eq!(completed(&desk.status_at(204.0, 10.0, 0.0)), [0]);
    assert_eq!(completed(&desk.status_at(210.0, 3.0, 0.0)), [1]);
    desk.status_at(210.0, 0.0, 0.0);
    assert_eq!(completed(&desk.status_at(210.0, 0.0, 0.0)), [2]);
}

#[test]
fn an_arm_that_comes_to_rest_elsewhere_has_not_reached_its_target() {
    let mut desk = Desk::new(Some(Dialect::SPECIFICATION));
    desk.status_at(200.0, 0.0, 0.0);
    desk.session
        .send(target(MovingMode::MovL, 220.0, 10.0))
        .expect("it is allowed");
    let mut events = Vec::new();
    for _ in 0..20 {
        events.extend(desk.status_at(208.0, 4.0, 0.0));
    }
    let short = events.iter().find_map(|event| match event {
        Event::NotReached {
            command,
            expected,
            found,
            ..
        } => Some((*command, *expected, *found)),
        _ => None,
    });
    let (command, expected, found) = short.expect("it is reported");
    assert_eq!(command, CommandId(0));
    assert_eq!(expected, Position::new(220.0, 10.0, 0.0));
    assert!(found.distance(Position::new(208.0, 4.0, 0.0)).0 < 1e-3);
}

#[test]
fn statuses_that_arrive_in_a_burst_indicate_no_lost_command() {
    let mut desk = Desk::new(Some(Dialect::SPECIFICATION));
    desk.status_at(200.0, 0.0, 0.0);
    desk.session
        .send(target(MovingMode::MovL, 220.0, 10.0))
        .expect("it is allowed");
    // The computer was frozen, and the statuses sent meanwhile are read at once.
    desk.now += PERIOD;
    let heap = status(200.0, 0.0, 0.0).emit().to_bytes().repeat(20);
    desk.session.handle_bytes(desk.now, &heap);
    let lost = |event: &Event| matches!(event, Event::NotReached { .. });
    assert!(!desk.events().iter().any(lost));
}
