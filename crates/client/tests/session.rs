//! The session engine against statuses made by hand.

use std::time::Duration;

use dobot_arm::{Joints, Pose, Position, Tool, forward, inverse};
use dobot_client::{CommandId, Event, SendError, Session};
use dobot_wire::{
    Configuration, Dialect, JointJog, JointJogAxis, MouseMove, MoveTo, MovingMode, Status,
    WriteMode, WriteVector,
};

const PERIOD: Duration = Duration::from_millis(80);

/// A session, and an arm that does nothing but stand where it is put.
struct Desk {
    session: Session,
    now: Duration,
}

impl Desk {
    fn new(dialect: Option<Dialect>) -> Self {
        Self {
            session: Session::trusted(dialect),
            now: Duration::ZERO,
        }
    }

    /// One that fills the arm's queue.
    fn ahead(dialect: Option<Dialect>) -> Self {
        let desk = Self::new(dialect);
        Self {
            session: desk.session.with_ahead(Duration::MAX),
            ..desk
        }
    }

    /// The next status, 80 ms after the last one; returns what happened.
    fn status_at(&mut self, x_mm: f64, y_mm: f64, z_mm: f64) -> Vec<Event> {
        self.now += PERIOD;
        let bytes = status(x_mm, y_mm, z_mm).emit().to_bytes();
        self.session.handle_bytes(self.now, &bytes);
        self.events()
    }

    fn events(&mut self) -> Vec<Event> {
        std::iter::from_fn(|| self.session.poll_event())
            .filter(|event| !matches!(event, Event::Status(_)))
            .collect()
    }

    fn packets(&mut self) -> usize {
        std::iter::from_fn(|| self.session.poll_bytes()).count()
    }
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "the wire is single precision"
)]
fn status(x_mm: f64, y_mm: f64, z_mm: f64) -> Status {
    let pose = Pose {
        position: Position::new(x_mm, y_mm, z_mm),
        ..Pose::default()
    };
    let joints = inverse(&pose, Tool::SuctionCup).expect("within reach");
    let pose = forward(&joints, Tool::SuctionCup);
    let Joints {
        base,
        rear,
        fore,
        servo,
    } = joints;
    Status {
        x_mm: pose.position.x.0 as f32,
        y_mm: pose.position.y.0 as f32,
        z_mm: pose.position.z.0 as f32,
        rotation_deg: pose.rotation.0 as f32,
        base_deg: base.0 as f32,
        rear_deg: rear.0 as f32,
        fore_deg: fore.0 as f32,
        servo_deg: servo.0 as f32,
        suction: false,
        gripper_deg: 0.0,
    }
}

fn target(mode: MovingMode, x_mm: f32, y_mm: f32) -> MoveTo {
    MoveTo {
        x_mm,
        y_mm,
        z_mm: 0.0,
        rotation_deg: 0.0,
        suction: false,
        mode,
        gripper_deg: 0.0,
        pause_s: 0.0,
    }
}

fn vector(x_mm: f32, y_mm: f32) -> WriteVector {
    WriteVector {
        mode: WriteMode::Writing,
        x_mm,
        y_mm,
        z_mm: 0.0,
        laser: false,
        start_speed_mm_s: 0.0,
        end_speed_mm_s: 0.0,
        max_speed_mm_s: 50.0,
        stop: false,
    }
}

fn completed(events: &[Event]) -> Vec<u64> {
    let id = |event: &Event| match event {
        Event::Completed(CommandId(id)) => Some(*id),
        _ => None,
    };
    events.iter().filter_map(id).collect()
}

#[test]
fn one_command_leaves_for_each_status() {
    let mut desk = Desk::new(Some(Dialect::SPECIFICATION));
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
fn permits_are_not_saved_up() {
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
fn a_packet_that_leaves_late_in_a_period_is_not_followed_by_the_next_at_once() {
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
fn statuses_that_come_in_a_heap_permit_one_command() {
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
fn what_depends_on_an_unknown_dialect_is_refused_and_the_rest_is_not() {
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
    let laser_off = JointJog {
        axis: JointJogAxis::LaserOff,
        speed_percent: 0.0,
    };
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
fn a_line_to_where_a_stock_arm_stands_is_not_sent() {
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
    assert_eq!(desk.session.under_way(), 0);
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
    let pause = Configuration::Playback {
        joint_speed_deg_s: 100.0,
        joint_acceleration_deg_s2: 100.0,
        servo_speed_deg_s: 100.0,
        servo_acceleration_deg_s2: 100.0,
        linear_speed_mm_s: 100.0,
        linear_acceleration_mm_s2: 100.0,
        default_pause_s: 3.0,
        jump_height_mm: 10.0,
    };
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
fn a_place_to_which_two_targets_lead_is_the_first_ones_when_the_arm_comes_there_first() {
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
fn a_way_back_does_not_end_the_way_there_as_it_begins() {
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
fn a_pump_that_acts_in_the_middle_of_a_pause_does_not_end_it() {
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
fn a_long_pause_is_told_once_when_it_begins() {
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
    let told = Event::Pausing {
        command: CommandId(0),
        lasts: Duration::from_secs(8),
        by_default: false,
    };
    assert_eq!(events, [told]);
    assert_eq!(completed(&desk.status_at(220.0, 10.0, 0.0)), [0]);
}

#[test]
fn all_targets_out_of_reach_are_told_and_none_is_over() {
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
    let mut desk = Desk::new(Some(Dialect::SPECIFICATION));
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
    let (command, expected, found) = short.expect("the person is told");
    assert_eq!(command, CommandId(0));
    assert_eq!(expected, Position::new(220.0, 10.0, 0.0));
    assert!(found.distance(Position::new(208.0, 4.0, 0.0)).0 < 1e-3);
}

#[test]
fn statuses_that_come_in_a_heap_tell_of_no_command_that_was_lost() {
    let mut desk = Desk::new(Some(Dialect::SPECIFICATION));
    desk.status_at(200.0, 0.0, 0.0);
    desk.session
        .send(target(MovingMode::MovL, 220.0, 10.0))
        .expect("it is allowed");
    // The computer stood still, and what came meanwhile is read at once.
    desk.now += PERIOD;
    let heap = status(200.0, 0.0, 0.0).emit().to_bytes().repeat(20);
    desk.session.handle_bytes(desk.now, &heap);
    let lost = |it: &Event| matches!(it, Event::NotReached { .. });
    assert!(!desk.events().iter().any(lost));
}

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
            noise: 0
        }]
    );
    desk.session.handle_time(desk.now + Duration::from_secs(9));
    assert_eq!(desk.events(), [], "it is told once");
}

#[test]
fn an_arm_reset_by_the_opening_of_its_port_has_five_seconds() {
    let mut session = Session::trusted(None);
    session.handle_time(Duration::from_millis(4900));
    assert_eq!(session.poll_event(), None);
    session.handle_bytes(Duration::from_millis(4950), &[0x42; 30]);
    session.handle_time(Duration::from_secs(5));
    assert_eq!(
        session.poll_event(),
        Some(Event::LinkLost {
            silent_for: Duration::from_secs(5),
            noise: 30
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
    assert_eq!(desk.session.under_way(), 5);
    desk.session.handle_time(desk.now + Duration::from_secs(20));
    assert_eq!(desk.events(), []);
    desk.session
        .handle_time(desk.now + Duration::from_secs(1000));
    assert!(matches!(desk.events()[..], [Event::LinkLost { .. }]));
}

#[test]
fn no_more_waits_in_the_arm_than_lets_it_speak_where_its_base_comes_to_0() {
    let mut desk = Desk::ahead(Some(Dialect::SPECIFICATION));
    desk.status_at(200.0, 0.0, 0.0);
    for n in 1..=5_u8 {
        // Every second one ends with the base at 0, as after a reset.
        let by = if n % 2 == 0 { -60.0 } else { 60.0 };
        desk.session.send(vector(0.0, by)).expect("it is allowed");
        desk.status_at(200.0, 0.0, 0.0);
    }
    assert_eq!((desk.session.under_way(), desk.session.waiting()), (4, 1));
}

#[test]
fn noise_between_statuses_is_told_and_costs_none() {
    let mut desk = Desk::new(None);
    desk.status_at(200.0, 0.0, 0.0);
    desk.session.handle_bytes(desk.now, &[0xA5, 1, 2, 3, 0xA5]);
    let events = desk.status_at(200.0, 0.0, 0.0);
    assert_eq!(events, [Event::Resynced { skipped: 5 }]);
}

#[test]
fn parting_words_leave_without_a_permit_and_before_all_that_waits() {
    let mut desk = Desk::new(Some(Dialect::SPECIFICATION));
    desk.session.send(vector(0.0, 1.0)).expect("it is allowed");
    let laser_off = JointJog {
        axis: JointJogAxis::LaserOff,
        speed_percent: 0.0,
    };
    desk.session.send_now(laser_off).expect("it is allowed");
    assert_eq!(desk.session.waiting(), 0);
    assert_eq!(desk.packets(), 1);
}
