//! A policy that is changed while the station runs.

use std::time::Duration;

use dobot_api::{ClientId, Jog, News, Request, Role};
use dobot_host::VirtualStation;
use dobot_safety::Policy;
use dobot_supervisor::Refusal;
use dobot_wire::{Command, LinearJog, LinearJogAxis, MoveTo, MovingMode, PlaybackAdjustment};

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
fn a_command_is_judged_by_the_policy_in_force_when_it_is_given() {
    for personality in PERSONALITIES {
        let (mut station, anna) = over(personality, 0);
        station.set_policy(anna, low()).unwrap();
        assert!(
            station
                .notices()
                .iter()
                .any(|notice| notice.news == News::PolicyChanged)
        );
        let place =
            |station: &VirtualStation| station.supervisor().state().arm.unwrap().status.z_mm;
        let z_mm = place(&station);
        let refused = station.ask(anna, down()).unwrap_err();
        assert!(refused.to_string().contains("workspace"), "{refused}");
        station.run_for(Duration::from_secs(5));
        assert_eq!(place(&station), z_mm);
        station.set_policy(anna, Policy::default()).unwrap();
        station.ask(anna, down()).unwrap();
    }
}

#[test]
fn a_new_policy_is_refused_while_the_arm_moves_under_the_old_one() {
    for personality in PERSONALITIES {
        let (mut station, anna) = over(personality, 0);
        station.ask(anna, down()).unwrap();
        station.run_for(Duration::from_millis(200));
        let refused = station.set_policy(anna, low());
        assert!(
            matches!(refused, Err(Refusal::StillMoving { .. })),
            "{refused:?}"
        );
        station.run_for(Duration::from_secs(20));
        let jog = Jog::Linear(LinearJog::new(LinearJogAxis::YPlus, 50.0));
        station.ask(anna, Request::Jog { jog }).unwrap();
        station.run_for(Duration::from_millis(100));
        let refused = station.set_policy(anna, low());
        assert!(
            matches!(refused, Err(Refusal::StillMoving { .. })),
            "{refused:?}"
        );
        station.ask(anna, Request::Release).unwrap();
        station.run_for(Duration::from_secs(2));
        station.set_policy(anna, low()).unwrap();
    }
}

#[test]
fn only_an_administrator_changes_the_policy_and_an_armed_laser_does_not_outlive_it() {
    for personality in PERSONALITIES {
        let (mut station, anna) = over(personality, 0);
        let pupil = station.client_as("pupil", Role::Watch);
        let refused = station.set_policy(pupil, low());
        assert!(matches!(refused, Err(Refusal::Role { .. })), "{refused:?}");
        station
            .ask(anna, Request::ArmLaser { for_s: 60.0 })
            .unwrap();
        station.set_policy(anna, low()).unwrap();
        assert_eq!(station.supervisor().state().laser.armed_for_s, 0.0);
    }
}

/// A slow line of 180 mm, and what was sent for it.
fn slow_line(station: &mut VirtualStation, anna: ClientId) -> usize {
    let slow = PlaybackAdjustment {
        speed_percent: 20.0,
        acceleration_percent: 100.0,
        teach_speed_percent: 20.0,
    };
    for command in [slow.into(), MoveTo::to(200.0, -90.0, 20.0).into()] {
        station.ask(anna, Request::Command { command }).unwrap();
    }
    station.run_for(Duration::from_secs(20));
    let before = station.packets().len();
    let command = MoveTo::to(200.0, 90.0, 20.0)
        .with_mode(MovingMode::MovL)
        .into();
    station.ask(anna, Request::Command { command }).unwrap();
    before
}

#[test]
fn a_slow_straight_line_is_sent_in_pieces_if_the_policy_says_so_and_a_stop_waits_for_one_only() {
    for personality in PERSONALITIES {
        let rested_s = ["", "[queue]\nline_s = 1\n"].map(|policy| {
            let (mut station, anna) = over(personality, 0);
            station
                .set_policy(anna, Policy::from_toml(policy).unwrap())
                .unwrap();
            slow_line(&mut station, anna);
            station.run_for(Duration::from_secs(3));
            let at = station.now();
            station.ask(anna, Request::Stop { reason: None }).unwrap();
            station.run_for(Duration::from_secs(30));
            let stop = station.supervisor().state().stop.unwrap();
            assert!(stop.at_rest, "{personality}");
            let rested = station
                .notices()
                .iter()
                .find(|notice| notice.news == News::AtRest)
                .unwrap();
            assert!(
                rested.at_s <= stop.rests_by_s + 0.3,
                "{personality}: {rested:?}"
            );
            rested.at_s - at.as_secs_f64()
        });
        let [whole_s, cut_s] = rested_s;
        assert!(
            cut_s < 2.2 && whole_s > 2.0 * cut_s,
            "{personality}: {rested_s:?}"
        );
    }
}

#[test]
fn a_line_in_pieces_ends_at_its_target_and_is_done_once() {
    for personality in PERSONALITIES {
        let (mut station, anna) = over(personality, 0);
        let policy = Policy::from_toml("[queue]\nline_s = 1\n").unwrap();
        station.set_policy(anna, policy).unwrap();
        let before = slow_line(&mut station, anna);
        let first_notice = station.notices().len();
        station.run_for(Duration::from_secs(40));
        let sent = station.packets()[before..].len();
        assert!((4..=12).contains(&sent), "{personality}: {sent}");
        let done = station.notices()[first_notice..].iter();
        let done = done.filter(|done| matches!(done.news, News::CommandDone { .. }));
        assert_eq!(done.count(), 1, "{personality}");
        let status = station.supervisor().state().arm.unwrap().status;
        let off = [status.x_mm - 200.0, status.y_mm - 90.0, status.z_mm - 20.0];
        assert!(
            off.iter().all(|off| off.abs() < 0.1),
            "{personality}: {off:?}"
        );
    }
}
