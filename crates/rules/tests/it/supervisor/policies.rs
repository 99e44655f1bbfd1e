//! A policy that is changed while the station runs.

use std::time::Duration;

use dobot_api::{Jog, News, Request, Role};
use dobot_rules::{Refusal, VirtualStation};
use dobot_safety::Policy;
use dobot_wire::{Command, LinearJog, LinearJogAxis, MoveTo};

use super::releases::over;
use super::strokes::PERSONALITIES;

fn low() -> Policy {
    Policy::from_toml("[workspace]\nz_mm = [20, 100]\n").unwrap()
}

fn down() -> Request {
    let command = Command::from(MoveTo::to(200.0, 0.0, 0.0));
    Request::Command { command }
}

#[test]
fn a_command_is_judged_by_the_policy_that_holds_when_it_is_given() {
    for personality in PERSONALITIES {
        let (mut it, anna) = over(personality, 0);
        it.set_policy(anna, low()).unwrap();
        assert!(it.notices().iter().any(|it| it.news == News::PolicyChanged));
        let place = |it: &VirtualStation| it.supervisor().state().arm.unwrap().status.z_mm;
        let z_mm = place(&it);
        let refused = it.ask(anna, down()).unwrap_err();
        assert!(refused.to_string().contains("workspace"), "{refused}");
        it.run_for(Duration::from_secs(5));
        assert_eq!(place(&it), z_mm);
        it.set_policy(anna, Policy::default()).unwrap();
        it.ask(anna, down()).unwrap();
    }
}

#[test]
fn what_is_under_way_was_judged_by_the_old_policy_and_has_to_be_over_first() {
    for personality in PERSONALITIES {
        let (mut it, anna) = over(personality, 0);
        it.ask(anna, down()).unwrap();
        it.run_for(Duration::from_millis(200));
        let refused = it.set_policy(anna, low());
        assert!(
            matches!(refused, Err(Refusal::StillMoving { .. })),
            "{refused:?}"
        );
        it.run_for(Duration::from_secs(20));
        let jog = Jog::Linear(LinearJog::new(LinearJogAxis::YPlus, 50.0));
        it.ask(anna, Request::Jog { jog }).unwrap();
        it.run_for(Duration::from_millis(100));
        let refused = it.set_policy(anna, low());
        assert!(
            matches!(refused, Err(Refusal::StillMoving { .. })),
            "{refused:?}"
        );
        it.ask(anna, Request::Release).unwrap();
        it.run_for(Duration::from_secs(2));
        it.set_policy(anna, low()).unwrap();
    }
}

#[test]
fn only_an_administrator_changes_the_policy_and_an_armed_laser_does_not_outlive_it() {
    for personality in PERSONALITIES {
        let (mut it, anna) = over(personality, 0);
        let pupil = it.client_as("pupil", Role::Watch);
        let refused = it.set_policy(pupil, low());
        assert!(matches!(refused, Err(Refusal::Role { .. })), "{refused:?}");
        it.ask(anna, Request::ArmLaser { for_s: 60.0 }).unwrap();
        it.set_policy(anna, low()).unwrap();
        assert_eq!(it.supervisor().state().laser.armed_for_s, 0.0);
    }
}
