//! Jogging is hold-to-run.

use std::time::Duration;

use dobot_api::{ClientId, Jog, News, Request};
use dobot_controller::Personality;
use dobot_host::VirtualStation;
use dobot_wire::{JointJog, JointJogAxis, LinearJog, LinearJogAxis};

use super::drawing::virtual_station;

const PERSONALITIES: [Personality; 2] = Personality::ALL;

fn linear(axis: LinearJogAxis) -> Request {
    Request::Jog {
        jog: Jog::Linear(LinearJog::new(axis, 50.0)),
    }
}

fn jogging(personality: Personality, axis: LinearJogAxis) -> (VirtualStation, ClientId) {
    let mut station = virtual_station(personality);
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    station.ask(anna, linear(axis)).unwrap();
    (station, anna)
}

fn hold(station: &mut VirtualStation, client: ClientId, axis: LinearJogAxis, times: u32) {
    for _ in 0..times {
        station.run_for(Duration::from_millis(50));
        station.ask(client, linear(axis)).unwrap();
    }
}

fn y_mm(station: &VirtualStation) -> f32 {
    station
        .supervisor()
        .state()
        .arm
        .expect("the arm reports its state")
        .status
        .y_mm
}

/// Whether the arm is where it was a while ago.
fn rests(station: &mut VirtualStation) -> bool {
    station.run_for(Duration::from_secs(3));
    let before = y_mm(station);
    station.run_for(Duration::from_secs(1));
    (y_mm(station) - before).abs() < 0.001
}

#[test]
fn a_button_moves_the_arm_for_as_long_as_it_is_held() {
    for personality in PERSONALITIES {
        let (mut station, anna) = jogging(personality, LinearJogAxis::YPlus);
        hold(&mut station, anna, LinearJogAxis::YPlus, 40);
        // 30 mm/s for two seconds, less the run-up of half a second and the line.
        let moved = y_mm(&station);
        assert!((40.0..60.0).contains(&moved), "{personality}: {moved} mm");
        station.ask(anna, Request::Release).unwrap();
        assert!(rests(&mut station), "{personality}");
    }
}

#[test]
fn the_button_of_a_silent_client_is_released_after_150_ms() {
    for personality in PERSONALITIES {
        let (mut station, anna) = jogging(personality, LinearJogAxis::YPlus);
        hold(&mut station, anna, LinearJogAxis::YPlus, 20);
        let (silent, packets) = (station.now(), station.packets().len());
        station.run_for(Duration::from_millis(200));
        let (at, _) = station.packets()[packets];
        let after = at.saturating_sub(silent);
        assert!(
            after <= Duration::from_millis(151),
            "{personality}: {after:?}"
        );
        assert!(
            station
                .notices()
                .iter()
                .any(|notice| notice.news == News::DeadMan)
        );
        assert!(rests(&mut station), "{personality}");
    }
}

#[test]
fn a_client_that_vanishes_while_jogging_stops_the_arm_at_once() {
    for personality in PERSONALITIES {
        let (mut station, anna) = jogging(personality, LinearJogAxis::YPlus);
        hold(&mut station, anna, LinearJogAxis::YPlus, 20);
        let (gone, packets) = (station.now(), station.packets().len());
        station.leave(anna);
        assert_eq!(station.packets()[packets].0, gone, "{personality}");
        assert!(rests(&mut station), "{personality}");
    }
}

#[test]
fn a_jog_stops_before_a_limit_of_the_policy_and_names_the_rule() {
    for personality in PERSONALITIES {
        let (mut station, anna) = jogging(personality, LinearJogAxis::ZMinus);
        let table = -103.0 + 40.0;
        let mut held = true;
        for _ in 0..400 {
            station.run_for(Duration::from_millis(50));
            held = held && station.ask(anna, linear(LinearJogAxis::ZMinus)).is_ok();
            let z_mm = station.supervisor().state().arm.unwrap().status.z_mm;
            assert!(z_mm >= table, "{personality}: {z_mm} mm");
        }
        assert!(!held, "{personality}: it was refused in the end");
        let refused = |news: &News| matches!(news, News::Refused { kind, .. } if kind == "policy");
        assert!(station.notices().iter().any(|notice| refused(&notice.news)));
    }
}

#[test]
fn switches_need_not_be_held() {
    let mut station = virtual_station(Personality::Firmware11);
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    let jog = Jog::Joint(JointJog::new(JointJogAxis::SuctionOn, 0.0));
    station.ask(anna, Request::Jog { jog }).unwrap();
    station.run_for(Duration::from_secs(2));
    assert!(station.supervisor().state().arm.unwrap().status.suction);
}
