//! The laser never burns while the arm is at rest, for any sender.

use std::time::Duration;

use dobot_api::{ClientId, News, Request};
use dobot_controller::{Controller, Personality, PowerUp};
use dobot_host::VirtualStation;
use dobot_safety::Policy;
use dobot_sim::{SerialLine, VirtualArm};
use dobot_wire::{Command, Packet};

use super::drawing::virtual_station;
use crate::cases::commands::vector;
use crate::cases::light::longest_stand_s;

/// The longest time that the laser may burn in one place.
const MAX_S: f64 = 0.3;

/// Control, and a laser that is armed.
fn armed(station: &mut VirtualStation) -> ClientId {
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    station
        .ask(anna, Request::ArmLaser { for_s: 600.0 })
        .unwrap();
    anna
}

fn burns(station: &VirtualStation) -> bool {
    station.arm().controller().outputs().laser
}

/// A while in which nothing is sent, and a motion at its end: the rest before it is recorded.
fn rest(station: &mut VirtualStation, anna: ClientId) {
    station.run_for(Duration::from_secs(5));
    let command = vector([0.0, 0.0, 5.0], false);
    station.ask(anna, Request::Command { command }).unwrap();
    station.run_for(Duration::from_secs(3));
}

#[test]
fn a_single_vector_that_burns_does_not_leave_the_laser_on() {
    for personality in Personality::ALL {
        let mut station = virtual_station(personality);
        let anna = armed(&mut station);
        let command = vector([10.0, 0.0, 0.0], true);
        station.ask(anna, Request::Command { command }).unwrap();
        let soon = station.now() + Duration::from_secs(1);
        assert!(station.run_until(soon, burns), "{personality}: it burns");
        assert!(station.supervisor().state().laser.on, "{personality}");
        let later = station.now() + Duration::from_secs(2);
        assert!(
            station.run_until(later, |station| !burns(station)),
            "{personality}"
        );
        station.run_for(Duration::from_millis(500));
        assert!(!station.supervisor().state().laser.on, "{personality}");
        assert!(
            station.supervisor().state().laser.armed_for_s > 0.0,
            "{personality}"
        );
        rest(&mut station, anna);
        let stood_s = longest_stand_s(station.arm().samples(), 0.001);
        assert!(stood_s <= MAX_S, "{personality}: {stood_s} s");
    }
}

#[test]
fn a_burning_packet_of_a_raw_client_does_not_leave_the_laser_on() {
    for personality in Personality::ALL {
        let mut station = virtual_station(personality);
        let program = station.client("an old program");
        let packet = vector([10.0, 0.0, 0.0], true).emit(&personality.dialect());
        assert_eq!(
            station.send_raw(program, &packet).unwrap_err().kind(),
            "laser-disarmed"
        );
        let anna = station.client("Anna");
        // Its protocol has no words for that.
        station
            .ask(anna, Request::ArmLaser { for_s: 600.0 })
            .unwrap();
        station.send_raw(program, &packet).unwrap();
        let soon = station.now() + Duration::from_secs(1);
        assert!(station.run_until(soon, burns), "{personality}: it burns");
        station.run_for(Duration::from_secs(5));
        let packet = vector([0.0, 0.0, 5.0], false).emit(&personality.dialect());
        station.send_raw(program, &packet).unwrap();
        station.run_for(Duration::from_secs(3));
        let stood_s = longest_stand_s(station.arm().samples(), 0.001);
        assert!(stood_s <= MAX_S, "{personality}: {stood_s} s");
    }
}

#[test]
fn watchers_learn_that_the_laser_was_switched_off() {
    let mut station = virtual_station(Personality::Firmware11);
    let anna = armed(&mut station);
    let command = vector([10.0, 0.0, 0.0], true);
    station.ask(anna, Request::Command { command }).unwrap();
    station.run_for(Duration::from_secs(5));
    let notices = station
        .notices()
        .iter()
        .filter(|notice| notice.news == News::LaserOff);
    assert_eq!(notices.count(), 1, "{:?}", station.notices());
}

#[test]
fn consecutive_vectors_burn_without_a_packet_between_them() {
    for personality in Personality::ALL {
        let mut station = virtual_station(personality);
        let anna = armed(&mut station);
        let before = station.packets().len();
        for x_mm in [5.0, 6.0, 7.0, 8.0] {
            let command = vector([x_mm, 0.0, 0.0], true);
            station.ask(anna, Request::Command { command }).unwrap();
        }
        station.run_for(Duration::from_secs(8));
        let sent: Vec<Command> = station.packets()[before..]
            .iter()
            .filter_map(|(_, bytes)| Packet::from_bytes(bytes))
            .map(|packet| Command::parse(&packet, &personality.dialect()).unwrap())
            .collect();
        let burning = |command: &Command| matches!(command, Command::WriteVector(_));
        assert!(sent.iter().take(4).all(burning), "{personality}: {sent:?}");
        assert_eq!(sent.iter().filter(|command| burning(command)).count(), 4);
    }
}

#[test]
fn a_policy_that_allows_a_standing_laser_leaves_it_on() {
    let power_up = PowerUp::new(Personality::Firmware11);
    let arm = VirtualArm::new(Controller::power_up(power_up), SerialLine::STOCK);
    let mut policy = Policy::default();
    policy.laser.standing = true;
    let mut station = VirtualStation::with_arm(arm, power_up, policy);
    station.run_for(Duration::from_secs(1));
    let anna = armed(&mut station);
    let command = vector([10.0, 0.0, 0.0], true);
    station.ask(anna, Request::Command { command }).unwrap();
    station.run_for(Duration::from_secs(5));
    assert!(burns(&station));
    assert!(station.supervisor().state().laser.on);
}
