//! One client has control; everyone may watch and stop.

use std::time::Duration;

use dobot_controller::Personality;
use dobot_station::{Jog, Refusal, Rehearsal, Request};
use dobot_wire::{LinearJog, LinearJogAxis};

use crate::drawing::{is_over, rehearsal, spiral};

const UP: Request = Request::Jog {
    jog: Jog::Linear(LinearJog {
        axis: LinearJogAxis::ZMinus,
        speed_percent: 20.0,
    }),
};

fn holder(rehearsal: &Rehearsal) -> Option<String> {
    rehearsal.keeper().state().lease.map(|it| it.name)
}

#[test]
fn nobody_moves_the_arm_who_has_not_taken_control() {
    let mut it = rehearsal(Personality::Specification);
    let anna = it.client("Anna");
    let before = it.packets().len();
    let refused = it.ask(anna, UP).unwrap_err();
    assert_eq!(refused, Refusal::NoLease { holder: None });
    assert_eq!(it.packets().len(), before, "nothing was sent");
    it.ask(anna, Request::TakeLease).unwrap();
    it.ask(anna, UP).unwrap();
}

#[test]
fn a_second_client_is_told_who_has_control() {
    let mut it = rehearsal(Personality::Specification);
    let (anna, ben) = (it.client("Anna"), it.client("Ben"));
    it.ask(anna, Request::TakeLease).unwrap();
    let refused = it.ask(ben, Request::TakeLease).unwrap_err();
    assert_eq!(refused.to_string(), "Anna has control of the arm");
    let refused = it.ask(ben, UP).unwrap_err();
    assert_eq!(refused.kind(), "no-lease");
    assert_eq!(holder(&it).as_deref(), Some("Anna"));
}

#[test]
fn control_goes_over_to_the_one_who_asks_when_the_holder_grants_it() {
    let mut it = rehearsal(Personality::Specification);
    let (anna, ben) = (it.client("Anna"), it.client("Ben"));
    it.ask(anna, Request::TakeLease).unwrap();
    let grant = Request::GrantLease { to: ben };
    assert_eq!(it.ask(anna, grant.clone()), Err(Refusal::NotAsking(ben.0)));
    it.ask(ben, Request::AskLease).unwrap();
    assert_eq!(holder(&it).as_deref(), Some("Anna"));
    it.ask(anna, grant).unwrap();
    assert_eq!(holder(&it).as_deref(), Some("Ben"));
}

#[test]
fn control_is_free_when_its_holder_is_gone() {
    let mut it = rehearsal(Personality::Specification);
    let (anna, ben) = (it.client("Anna"), it.client("Ben"));
    it.ask(anna, Request::TakeLease).unwrap();
    it.leave(anna);
    assert_eq!(holder(&it), None);
    it.ask(ben, Request::TakeLease).unwrap();
}

#[test]
fn an_administrator_may_take_control_from_somebody() {
    let mut it = rehearsal(Personality::Specification);
    let (anna, ben) = (it.client("Anna"), it.client("Ben"));
    it.ask(anna, Request::TakeLease).unwrap();
    it.ask(ben, Request::SeizeLease).unwrap();
    assert_eq!(holder(&it).as_deref(), Some("Ben"));
    assert_eq!(it.ask(anna, UP).unwrap_err().kind(), "no-lease");
}

#[test]
fn a_watcher_may_stop_and_nothing_else() {
    let mut it = rehearsal(Personality::Specification);
    let watcher = it.watcher("the class");
    assert_eq!(
        it.ask(watcher, Request::TakeLease).unwrap_err().kind(),
        "role"
    );
    it.ask(watcher, Request::Stop { reason: None }).unwrap();
    assert!(it.keeper().state().stop.is_some());
}

#[test]
fn a_drawing_with_a_pen_goes_on_when_the_one_who_started_it_leaves() {
    let mut it = rehearsal(Personality::Specification);
    let anna = it.client("Anna");
    it.ask(anna, Request::TakeLease).unwrap();
    let job = it.submit(&spiral(8)).unwrap();
    it.start(anna, job).unwrap();
    it.run_for(Duration::from_secs(2));
    it.leave(anna);
    let minute = it.now() + Duration::from_mins(1);
    assert!(it.run_until(minute, |it| is_over(it, job)));
    assert_eq!(it.job(job).unwrap().state.to_string(), "done");
}
