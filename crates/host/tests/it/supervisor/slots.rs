//! Time slots: only the student of the current slot and administrators have control.

use std::time::Duration;

use dobot_api::{ClientId, JobPhase, Jog, News, Reply, Request, Role, TimeSlot, is_same_person};
use dobot_controller::Personality;
use dobot_host::VirtualStation;
use dobot_motion::LASER_OFF;
use dobot_wire::{Command, Dialect, LinearJog, LinearJogAxis, Packet};
use proptest::prelude::*;

use super::drawing::{burnt_spiral, is_over, spiral, virtual_station};
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

fn holder(it: &VirtualStation) -> Option<String> {
    it.supervisor().state().lease.map(|lease| lease.name)
}

fn told(it: &VirtualStation, news: &News) -> usize {
    it.notices()
        .iter()
        .filter(|notice| notice.news == *news)
        .count()
}

/// A class at an arm: the teacher, Anna and Ben.
fn class(personality: Personality) -> (VirtualStation, [ClientId; 3]) {
    let mut it = virtual_station(personality);
    let teacher = it.client("Ms Weber");
    let students = ["Anna", "Ben"].map(|name| it.client_as(name, Role::Control));
    (it, [teacher, students[0], students[1]])
}

fn packet() -> Packet {
    vector([0.0, 5.0, 0.0], false).emit(&Dialect::SPECIFICATION)
}

#[test]
fn in_a_slot_only_its_student_and_administrators_get_control() {
    let (mut it, [teacher, anna, ben]) = class(Personality::Specification);
    let program = it.client_as("an old program", Role::Control);
    let slots = [slot(" anna", 0.0, 600.0), slot("Ben", 600.0, 1200.0)];
    assert_eq!(it.ask(anna, set(&slots)).unwrap_err().kind(), "role");
    it.ask(teacher, set(&slots)).unwrap();
    for request in [UP, Request::TakeLease, Request::AskLease] {
        let refused = it.ask(ben, request).unwrap_err();
        assert_eq!(refused.kind(), "slot");
        assert_eq!(
            refused.to_string(),
            "the arm is reserved for anna for another 10 min; it is free in 20 min"
        );
    }
    assert_eq!(it.send_raw(program, &packet()).unwrap_err().kind(), "slot");
    assert_eq!(holder(&it), None);
    it.ask(anna, Request::TakeLease).unwrap();
    assert_eq!(it.ask(ben, Request::AskLease).unwrap_err().kind(), "slot");
    it.ask(ben, Request::Stop { reason: None }).unwrap();
    // The teacher has control in every slot, and grants it only to the student.
    it.ask(teacher, Request::SeizeLease).unwrap();
    it.ask(anna, Request::AskLease).unwrap();
    it.ask(teacher, Request::GrantLease { to: anna }).unwrap();
    assert_eq!(holder(&it).as_deref(), Some("Anna"));
}

#[test]
fn a_request_for_control_from_before_a_slot_is_not_granted_in_it() {
    let (mut it, [teacher, anna, ben]) = class(Personality::Specification);
    it.ask(teacher, Request::TakeLease).unwrap();
    it.ask(ben, Request::AskLease).unwrap();
    it.ask(teacher, set(&[slot("Anna", 5.0, 600.0)])).unwrap();
    it.run_for(Duration::from_secs(6));
    let refused = it
        .ask(teacher, Request::GrantLease { to: ben })
        .unwrap_err();
    assert_eq!(refused.kind(), "slot");
    assert_eq!(holder(&it).as_deref(), Some("Ms Weber"));
    it.ask(teacher, Request::ReleaseLease).unwrap();
    it.ask(anna, Request::TakeLease).unwrap();
}

#[test]
fn a_person_is_identified_by_the_token_and_not_by_the_name_of_the_client() {
    let (mut it, [teacher, ..]) = class(Personality::Specification);
    it.ask(teacher, set(&[slot("Anna", 0.0, 600.0)])).unwrap();
    let script = it.client_of("a script", Role::Control, "Anna");
    let ben = it.client_of("Anna", Role::Control, "Ben");
    assert_eq!(it.ask(ben, Request::TakeLease).unwrap_err().kind(), "slot");
    it.ask(script, Request::TakeLease).unwrap();
}

#[test]
fn a_burning_laser_is_switched_off_when_the_slot_ends_and_the_arm_comes_to_rest() {
    for personality in Personality::ALL {
        let (mut it, [teacher, anna, ben]) = class(personality);
        it.ask(anna, Request::TakeLease).unwrap();
        let job = it.submit(&burnt_spiral(20)).unwrap();
        it.ask(anna, Request::ArmLaser { for_s: 600.0 }).unwrap();
        it.start(anna, job).unwrap();
        let minute = it.now() + Duration::from_mins(1);
        assert!(it.run_until(minute, burns), "{personality}");
        let ends = it.now() + Duration::from_secs(1);
        it.ask(
            teacher,
            set(&[slot("Anna", 0.0, 1.0), slot("Ben", 1.0, 99.0)]),
        )
        .unwrap();
        assert_eq!(holder(&it).as_deref(), Some("Anna"));
        it.run_for(Duration::from_secs(1) + SOON);
        let after = it.packets().iter().find(|(at, _)| *at >= ends).unwrap();
        let first = Packet::from_bytes(&after.1).unwrap();
        let first = Command::parse(&first, &personality.dialect()).unwrap();
        assert_eq!(first, LASER_OFF, "{personality}: it goes before all else");
        assert!(!burns(&it), "{personality}");
        assert_eq!(it.supervisor().state().laser.armed_for_s, 0.0);
        assert_eq!(holder(&it), None);
        let minute = it.now() + Duration::from_mins(1);
        let paused = |station: &VirtualStation| {
            let job = station.supervisor().state().job;
            job.is_some_and(|job| job.phase == JobPhase::Paused)
        };
        assert!(it.run_until(minute, paused), "{personality}");
        assert_eq!(it.start(anna, job).unwrap_err().kind(), "slot");
        it.ask(ben, Request::TakeLease).unwrap();
        let student = "Anna".to_owned();
        assert_eq!(told(&it, &News::SlotEnded { student }), 1);
        let over = it
            .notices()
            .iter()
            .any(|notice| notice.text.contains("the time slot of Ben"));
        assert!(over, "{:?}", it.notices());
    }
}

#[test]
fn a_button_is_released_when_another_persons_slot_begins() {
    for personality in Personality::ALL {
        let (mut it, [teacher, anna, ben]) = class(personality);
        it.ask(teacher, set(&[slot("Anna", 2.0, 600.0)])).unwrap();
        it.ask(ben, Request::TakeLease).unwrap();
        it.run_for(Duration::from_millis(1_900));
        it.ask(ben, UP).unwrap();
        it.run_for(Duration::from_millis(120));
        assert_eq!(it.ask(ben, UP).unwrap_err().kind(), "slot");
        it.run_for(Duration::from_secs(1));
        assert!(it.supervisor().is_at_rest(), "{personality}");
        it.ask(anna, Request::TakeLease).unwrap();
        it.ask(anna, UP).unwrap();
    }
}

#[test]
fn an_administrator_keeps_control_and_jobs_in_the_slot_of_a_student() {
    let (mut it, [teacher, ..]) = class(Personality::Specification);
    it.ask(teacher, Request::TakeLease).unwrap();
    let job = it.submit(&spiral(8)).unwrap();
    it.start(teacher, job).unwrap();
    it.ask(teacher, set(&[slot("Anna", 1.0, 3.0)])).unwrap();
    let minute = it.now() + Duration::from_mins(1);
    assert!(it.run_until(minute, |station| is_over(station, job)));
    assert_eq!(it.job(job).unwrap().state.to_string(), "done");
    assert_eq!(holder(&it).as_deref(), Some("Ms Weber"));
}

#[test]
fn consecutive_slots_of_one_student_interrupt_nothing() {
    let (mut it, [teacher, anna, _]) = class(Personality::Specification);
    let slots = [slot("Anna", 0.0, 3.0), slot("ANNA", 3.0, 99.0)];
    it.ask(teacher, set(&slots)).unwrap();
    it.ask(anna, Request::TakeLease).unwrap();
    let job = it.submit(&spiral(8)).unwrap();
    it.start(anna, job).unwrap();
    let minute = it.now() + Duration::from_mins(1);
    assert!(it.run_until(minute, |station| is_over(station, job)));
    assert_eq!(it.job(job).unwrap().state.to_string(), "done");
    assert_eq!(holder(&it).as_deref(), Some("Anna"));
}

#[test]
fn a_new_list_that_extends_the_slot_of_a_student_interrupts_nothing() {
    let (mut it, [teacher, anna, _]) = class(Personality::Specification);
    it.ask(teacher, set(&[slot("Anna", 0.0, 60.0)])).unwrap();
    it.ask(anna, Request::TakeLease).unwrap();
    let job = it.submit(&spiral(8)).unwrap();
    it.start(anna, job).unwrap();
    // Her job continues without her, as in her slot.
    it.leave(anna);
    it.run_for(Duration::from_secs(1));
    it.ask(teacher, set(&[slot("anna", 0.0, 900.0)])).unwrap();
    let minute = it.now() + Duration::from_mins(1);
    assert!(it.run_until(minute, |station| is_over(station, job)));
    assert_eq!(it.job(job).unwrap().state.to_string(), "done");
    let began = it
        .notices()
        .iter()
        .filter(|notice| matches!(notice.news, News::SlotBegan { .. }));
    assert_eq!(began.count(), 1);
}

#[test]
fn a_student_is_warned_a_minute_before_the_end_and_the_arm_is_free_after_the_last_slot() {
    let (mut it, [teacher, anna, ben]) = class(Personality::Specification);
    it.ask(teacher, set(&[slot("Anna", 0.0, 90.0)])).unwrap();
    it.ask(anna, Request::TakeLease).unwrap();
    let ending = News::SlotEnding {
        student: "Anna".into(),
    };
    it.run_for(Duration::from_secs(29));
    assert_eq!(told(&it, &ending), 0);
    it.run_for(Duration::from_secs(2));
    assert_eq!(told(&it, &ending), 1);
    let view = it.supervisor().state().slots.unwrap();
    assert_eq!(view.now.map(|now| now.student).as_deref(), Some("Anna"));
    it.run_for(Duration::from_secs(60));
    assert_eq!((holder(&it), told(&it, &ending)), (None, 1));
    assert_eq!(it.supervisor().state().slots, None);
    it.ask(ben, Request::TakeLease).unwrap();
}

#[test]
fn clearing_the_slots_leaves_control_unchanged() {
    let (mut it, [teacher, anna, ben]) = class(Personality::Specification);
    it.ask(teacher, set(&[slot("Anna", 0.0, 90.0)])).unwrap();
    it.ask(anna, Request::TakeLease).unwrap();
    let reply = it.ask(teacher, set(&[])).unwrap();
    assert_eq!(reply, Reply::Slots { slots: Vec::new() });
    assert_eq!(holder(&it).as_deref(), Some("Anna"));
    it.ask(anna, Request::ReleaseLease).unwrap();
    it.ask(ben, Request::TakeLease).unwrap();
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
        6 => (who.clone(), asked).prop_map(|(who, it)| Deed::Ask(who, it)),
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
        let mut it = virtual_station(Personality::Specification);
        let names = ["Anna", "Ben", "Chen", "an old program", "Ms Weber"];
        let come = |station: &mut VirtualStation, who: usize| {
            let role = if who == 4 { Role::Admin } else { Role::Control };
            station.client_as(names[who], role)
        };
        let mut people: Vec<_> = (0..5).map(|who| come(&mut it, who)).collect();
        for deed in deeds {
            // Refusals are fine: only control counts here.
            match deed {
                Deed::Ask(who, request) => drop(it.ask(people[who], request)),
                Deed::Grant(from, to) => drop(it.ask(people[from], Request::GrantLease { to: people[to] })),
                Deed::Raw(who) => drop(it.send_raw(people[who], &packet())),
                Deed::Leave(who) => {
                    it.leave(people[who]);
                    people[who] = come(&mut it, who);
                }
                Deed::Wait(ms) => it.run_for(Duration::from_millis(ms)),
                Deed::Set(slots) => drop(it.ask(people[4], set(&slots)).unwrap()),
            }
            let state = it.supervisor().state();
            let now = state.slots.and_then(|slots| slots.now);
            if let (Some(now), Some(lease)) = (now, state.lease) {
                let may = lease.client == people[4] || is_same_person(&lease.name, &now.student);
                prop_assert!(may, "{} has control in the time of {}", lease.name, now.student);
            }
        }
    }
}
