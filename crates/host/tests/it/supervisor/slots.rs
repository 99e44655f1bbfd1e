//! Time slots: only the student of the current slot and administrators have control.

use std::time::Duration;

use dobot_api::{ClientId, JobPhase, Jog, News, Reply, Request, Role, TimeSlot, is_same_person};
use dobot_controller::Personality;
use dobot_host::VirtualStation;
use dobot_motion::LASER_OFF;
use dobot_wire::{Command, Dialect, LinearJog, LinearJogAxis, Packet};
use proptest::prelude::*;

use super::drawing::{is_over, spiral, start_burning, virtual_station};
use super::lasers::{SOON, burns};
use crate::cases::commands::vector;

const UP: Request = Request::Jog {
    jog: Jog::Linear(LinearJog::new(LinearJogAxis::ZPlus, 20.0)),
};

fn slot(student: &str, starts_in_s: f64, ends_in_s: f64) -> TimeSlot {
    TimeSlot {
        student: student.into(),
        group: None,
        starts_in_s,
        ends_in_s,
    }
}

fn set(slots: &[TimeSlot]) -> Request {
    Request::SetSlots {
        slots: slots.to_vec(),
    }
}

fn holder(station: &VirtualStation) -> Option<String> {
    station.supervisor().state().lease.map(|lease| lease.name)
}

fn count(station: &VirtualStation, news: &News) -> usize {
    station
        .notices()
        .iter()
        .filter(|notice| notice.news == *news)
        .count()
}

/// A class at an arm: the teacher, Anna and Ben.
fn class(personality: Personality) -> (VirtualStation, [ClientId; 3]) {
    let mut station = virtual_station(personality);
    let teacher = station.client("Ms Weber");
    let students = ["Anna", "Ben"].map(|name| station.client_as(name, Role::Control));
    (station, [teacher, students[0], students[1]])
}

fn packet() -> Packet {
    vector([0.0, 5.0, 0.0], false).emit(&Dialect::SPECIFICATION)
}

#[test]
fn in_a_slot_only_its_student_and_administrators_get_control() {
    let (mut station, [teacher, anna, ben]) = class(Personality::Specification);
    let program = station.client_as("an old program", Role::Control);
    let slots = [slot(" anna", 0.0, 600.0), slot("Ben", 600.0, 1200.0)];
    assert_eq!(station.ask(anna, set(&slots)).unwrap_err().kind(), "role");
    station.ask(teacher, set(&slots)).unwrap();
    for request in [UP, Request::TakeLease, Request::AskLease] {
        let refused = station.ask(ben, request).unwrap_err();
        assert_eq!(refused.kind(), "slot");
        assert_eq!(
            refused.to_string(),
            "the arm is reserved for anna for another 10 min; it is free in 20 min"
        );
    }
    assert_eq!(
        station.send_raw(program, &packet()).unwrap_err().kind(),
        "slot"
    );
    assert_eq!(holder(&station), None);
    station.ask(anna, Request::TakeLease).unwrap();
    assert_eq!(
        station.ask(ben, Request::AskLease).unwrap_err().kind(),
        "slot"
    );
    station.ask(ben, Request::Stop { reason: None }).unwrap();
    // The teacher has control in every slot, and grants it only to the student.
    station.ask(teacher, Request::SeizeLease).unwrap();
    station.ask(anna, Request::AskLease).unwrap();
    station
        .ask(teacher, Request::GrantLease { to: anna })
        .unwrap();
    assert_eq!(holder(&station).as_deref(), Some("Anna"));
}

#[test]
fn a_request_for_control_from_before_a_slot_is_not_granted_in_it() {
    let (mut station, [teacher, anna, ben]) = class(Personality::Specification);
    station.ask(teacher, Request::TakeLease).unwrap();
    station.ask(ben, Request::AskLease).unwrap();
    station
        .ask(teacher, set(&[slot("Anna", 5.0, 600.0)]))
        .unwrap();
    station.run_for(Duration::from_secs(6));
    let refused = station
        .ask(teacher, Request::GrantLease { to: ben })
        .unwrap_err();
    assert_eq!(refused.kind(), "slot");
    assert_eq!(holder(&station).as_deref(), Some("Ms Weber"));
    station.ask(teacher, Request::ReleaseLease).unwrap();
    station.ask(anna, Request::TakeLease).unwrap();
}

#[test]
fn a_person_is_identified_by_the_token_and_not_by_the_name_of_the_client() {
    let (mut station, [teacher, ..]) = class(Personality::Specification);
    station
        .ask(teacher, set(&[slot("Anna", 0.0, 600.0)]))
        .unwrap();
    let script = station.client_of("a script", Role::Control, "Anna");
    let ben = station.client_of("Anna", Role::Control, "Ben");
    assert_eq!(
        station.ask(ben, Request::TakeLease).unwrap_err().kind(),
        "slot"
    );
    station.ask(script, Request::TakeLease).unwrap();
}

#[test]
fn a_burning_laser_is_switched_off_when_the_slot_ends_and_the_arm_comes_to_rest() {
    for personality in Personality::ALL {
        let (mut station, [teacher, anna, ben]) = class(personality);
        let job = start_burning(&mut station, anna);
        let minute = station.now() + Duration::from_mins(1);
        assert!(station.run_until(minute, burns), "{personality}");
        let ends = station.now() + Duration::from_secs(1);
        station
            .ask(
                teacher,
                set(&[slot("Anna", 0.0, 1.0), slot("Ben", 1.0, 99.0)]),
            )
            .unwrap();
        assert_eq!(holder(&station).as_deref(), Some("Anna"));
        station.run_for(Duration::from_secs(1) + SOON);
        let after = station
            .packets()
            .iter()
            .find(|(at, _)| *at >= ends)
            .unwrap();
        let first = Packet::from_bytes(&after.1).unwrap();
        let first = Command::parse(&first, &personality.dialect()).unwrap();
        assert_eq!(first, LASER_OFF, "{personality}: it goes before all else");
        assert!(!burns(&station), "{personality}");
        assert_eq!(station.supervisor().state().laser.armed_for_s, 0.0);
        assert_eq!(holder(&station), None);
        let minute = station.now() + Duration::from_mins(1);
        let paused = |station: &VirtualStation| {
            let job = station.supervisor().state().job;
            job.is_some_and(|job| job.phase == JobPhase::Paused)
        };
        assert!(station.run_until(minute, paused), "{personality}");
        assert_eq!(station.start(anna, job).unwrap_err().kind(), "slot");
        station.ask(ben, Request::TakeLease).unwrap();
        let student = "Anna".to_owned();
        assert_eq!(count(&station, &News::SlotEnded { student }), 1);
        let over = station
            .notices()
            .iter()
            .any(|notice| notice.text.contains("the time slot of Ben"));
        assert!(over, "{:?}", station.notices());
    }
}

#[test]
fn a_button_is_released_when_another_persons_slot_begins() {
    for personality in Personality::ALL {
        let (mut station, [teacher, anna, ben]) = class(personality);
        station
            .ask(teacher, set(&[slot("Anna", 2.0, 600.0)]))
            .unwrap();
        station.ask(ben, Request::TakeLease).unwrap();
        station.run_for(Duration::from_millis(1_900));
        station.ask(ben, UP).unwrap();
        station.run_for(Duration::from_millis(120));
        assert_eq!(station.ask(ben, UP).unwrap_err().kind(), "slot");
        station.run_for(Duration::from_secs(1));
        assert!(station.supervisor().is_at_rest(), "{personality}");
        station.ask(anna, Request::TakeLease).unwrap();
        station.ask(anna, UP).unwrap();
    }
}

#[test]
fn an_administrator_keeps_control_and_jobs_in_the_slot_of_a_student() {
    let (mut station, [teacher, ..]) = class(Personality::Specification);
    station.ask(teacher, Request::TakeLease).unwrap();
    let job = station.submit(&spiral(8)).unwrap();
    station.start(teacher, job).unwrap();
    station
        .ask(teacher, set(&[slot("Anna", 1.0, 3.0)]))
        .unwrap();
    let minute = station.now() + Duration::from_mins(1);
    assert!(station.run_until(minute, |station| is_over(station, job)));
    assert_eq!(station.job(job).unwrap().state.to_string(), "done");
    assert_eq!(holder(&station).as_deref(), Some("Ms Weber"));
}

#[test]
fn consecutive_slots_of_one_student_interrupt_nothing() {
    let (mut station, [teacher, anna, _]) = class(Personality::Specification);
    let slots = [slot("Anna", 0.0, 3.0), slot("ANNA", 3.0, 99.0)];
    station.ask(teacher, set(&slots)).unwrap();
    station.ask(anna, Request::TakeLease).unwrap();
    let job = station.submit(&spiral(8)).unwrap();
    station.start(anna, job).unwrap();
    let minute = station.now() + Duration::from_mins(1);
    assert!(station.run_until(minute, |station| is_over(station, job)));
    assert_eq!(station.job(job).unwrap().state.to_string(), "done");
    assert_eq!(holder(&station).as_deref(), Some("Anna"));
}

#[test]
fn a_new_list_that_extends_the_slot_of_a_student_interrupts_nothing() {
    let (mut station, [teacher, anna, _]) = class(Personality::Specification);
    station
        .ask(teacher, set(&[slot("Anna", 0.0, 60.0)]))
        .unwrap();
    station.ask(anna, Request::TakeLease).unwrap();
    let job = station.submit(&spiral(8)).unwrap();
    station.start(anna, job).unwrap();
    // Her job continues without her, as in her slot.
    station.leave(anna);
    station.run_for(Duration::from_secs(1));
    station
        .ask(teacher, set(&[slot("anna", 0.0, 900.0)]))
        .unwrap();
    let minute = station.now() + Duration::from_mins(1);
    assert!(station.run_until(minute, |station| is_over(station, job)));
    assert_eq!(station.job(job).unwrap().state.to_string(), "done");
    let began = station
        .notices()
        .iter()
        .filter(|notice| matches!(notice.news, News::SlotBegan { .. }));
    assert_eq!(began.count(), 1);
}

#[test]
fn a_student_is_warned_a_minute_before_the_end_and_the_arm_is_free_after_the_last_slot() {
    let (mut station, [teacher, anna, ben]) = class(Personality::Specification);
    station
        .ask(teacher, set(&[slot("Anna", 0.0, 90.0)]))
        .unwrap();
    station.ask(anna, Request::TakeLease).unwrap();
    let ending = News::SlotEnding {
        student: "Anna".into(),
    };
    station.run_for(Duration::from_secs(29));
    assert_eq!(count(&station, &ending), 0);
    station.run_for(Duration::from_secs(2));
    assert_eq!(count(&station, &ending), 1);
    let view = station.supervisor().state().slots.unwrap();
    assert_eq!(view.now.map(|now| now.student).as_deref(), Some("Anna"));
    station.run_for(Duration::from_secs(60));
    assert_eq!((holder(&station), count(&station, &ending)), (None, 1));
    assert_eq!(station.supervisor().state().slots, None);
    station.ask(ben, Request::TakeLease).unwrap();
}

#[test]
fn clearing_the_slots_leaves_control_unchanged() {
    let (mut station, [teacher, anna, ben]) = class(Personality::Specification);
    station
        .ask(teacher, set(&[slot("Anna", 0.0, 90.0)]))
        .unwrap();
    station.ask(anna, Request::TakeLease).unwrap();
    let reply = station.ask(teacher, set(&[])).unwrap();
    assert_eq!(reply, Reply::Slots { slots: Vec::new() });
    assert_eq!(holder(&station).as_deref(), Some("Anna"));
    station.ask(anna, Request::ReleaseLease).unwrap();
    station.ask(ben, Request::TakeLease).unwrap();
}

/// Actions of people at an arm with time slots.
#[derive(Clone, Debug)]
enum Deed {
    Ask(usize, Request),
    /// The first one gives control to the second one.
    Grant(usize, usize),
    Raw(usize),
    Leave(usize),
    Wait(u64),
    Set(Vec<TimeSlot>),
}

fn deed() -> impl Strategy<Value = Deed> {
    let who = 0..5_usize;
    let asked = prop_oneof![
        Just(Request::TakeLease),
        Just(Request::AskLease),
        Just(Request::ReleaseLease),
        Just(Request::SeizeLease),
        Just(Request::Lock { message: None }),
        Just(Request::Unlock),
        Just(UP),
    ];
    let one = (0..3_usize, 0.0..3.0_f64, 1.0..9.0_f64);
    let slots = prop::collection::vec(one, 0..4).prop_map(|all| {
        let mut from = 0.0;
        let of = |(who, wait, lasts): (usize, f64, f64)| {
            let starts = from + wait.floor();
            from = starts + lasts.floor();
            slot(["Anna", "ben ", "Chen"][who], starts, from)
        };
        all.into_iter().map(of).collect()
    });
    prop_oneof![
        6 => (who.clone(), asked).prop_map(|(who, request)| Deed::Ask(who, request)),
        2 => (who.clone(), who.clone()).prop_map(|(from, to)| Deed::Grant(from, to)),
        1 => who.clone().prop_map(Deed::Raw),
        1 => who.prop_map(Deed::Leave),
        3 => (10..4000_u64).prop_map(Deed::Wait),
        2 => slots.prop_map(Deed::Set),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]
    #[test]
    fn in_the_slot_of_one_student_no_other_student_ever_has_control(deeds in prop::collection::vec(deed(), 1..60)) {
        let mut station = virtual_station(Personality::Specification);
        let names = ["Anna", "Ben", "Chen", "an old program", "Ms Weber"];
        let connect = |station: &mut VirtualStation, who: usize| {
            let role = if who == 4 { Role::Admin } else { Role::Control };
            station.client_as(names[who], role)
        };
        let mut people: Vec<_> = (0..5).map(|who| connect(&mut station, who)).collect();
        for deed in deeds {
            // Refusals are fine: only control counts here.
            match deed {
                Deed::Ask(who, request) => drop(station.ask(people[who], request)),
                Deed::Grant(from, to) => drop(station.ask(people[from], Request::GrantLease { to: people[to] })),
                Deed::Raw(who) => drop(station.send_raw(people[who], &packet())),
                Deed::Leave(who) => {
                    station.leave(people[who]);
                    people[who] = connect(&mut station, who);
                }
                Deed::Wait(ms) => station.run_for(Duration::from_millis(ms)),
                Deed::Set(slots) => drop(station.ask(people[4], set(&slots)).unwrap()),
            }
            let state = station.supervisor().state();
            let now = state.slots.and_then(|slots| slots.now);
            if let (Some(now), Some(lease)) = (now, state.lease) {
                let may = lease.client == people[4] || is_same_person(&lease.name, &now.student);
                prop_assert!(may, "{} has control in the time of {}", lease.name, now.student);
            }
        }
    }
}
