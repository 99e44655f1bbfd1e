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
fn armed(it: &mut VirtualStation) -> ClientId {
    let anna = it.client("Anna");
    it.ask(anna, Request::TakeLease).unwrap();
    it.ask(anna, Request::ArmLaser { for_s: 600.0 }).unwrap();
    anna
}

fn burns(it: &VirtualStation) -> bool {
    it.arm().controller().outputs().laser
}

/// A while in which nothing is sent, and a motion at its end: the rest before it is recorded.
fn rest(it: &mut VirtualStation, anna: ClientId) {
    it.run_for(Duration::from_secs(5));
    let command = vector([0.0, 0.0, 5.0], false);
    it.ask(anna, Request::Command { command }).unwrap();
    it.run_for(Duration::from_secs(3));
}

#[test]
fn a_single_vector_that_burns_does_not_leave_the_laser_on() {
    for personality in Personality::ALL {
        let mut it = virtual_station(personality);
        let anna = armed(&mut it);
        let command = vector([10.0, 0.0, 0.0], true);
        it.ask(anna, Request::Command { command }).unwrap();
        let soon = it.now() + Duration::from_secs(1);
        assert!(it.run_until(soon, burns), "{personality}: it burns");
        assert!(it.supervisor().state().laser.on, "{personality}");
        let later = it.now() + Duration::from_secs(2);
        assert!(
            it.run_until(later, |station| !burns(station)),
            "{personality}"
        );
        it.run_for(Duration::from_millis(500));
        assert!(!it.supervisor().state().laser.on, "{personality}");
        assert!(
            it.supervisor().state().laser.armed_for_s > 0.0,
            "{personality}"
        );
        rest(&mut it, anna);
        let stood_s = longest_stand_s(it.arm().samples(), 0.001);
        assert!(stood_s <= MAX_S, "{personality}: {stood_s} s");
    }
}

#[test]
fn a_burning_packet_of_a_raw_client_does_not_leave_the_laser_on() {
    for personality in Personality::ALL {
        let mut it = virtual_station(personality);
        let program = it.client("an old program");
        let packet = vector([10.0, 0.0, 0.0], true).emit(&personality.dialect());
        assert_eq!(
            it.send_raw(program, &packet).unwrap_err().kind(),
            "laser-disarmed"
        );
        let anna = it.client("Anna");
        // Its protocol has no words for that.
        it.ask(anna, Request::ArmLaser { for_s: 600.0 }).unwrap();
        it.send_raw(program, &packet).unwrap();
        let soon = it.now() + Duration::from_secs(1);
        assert!(it.run_until(soon, burns), "{personality}: it burns");
        it.run_for(Duration::from_secs(5));
        let packet = vector([0.0, 0.0, 5.0], false).emit(&personality.dialect());
        it.send_raw(program, &packet).unwrap();
        it.run_for(Duration::from_secs(3));
        let stood_s = longest_stand_s(it.arm().samples(), 0.001);
        assert!(stood_s <= MAX_S, "{personality}: {stood_s} s");
    }
}

#[test]
fn watchers_learn_that_the_laser_was_switched_off() {
    let mut it = virtual_station(Personality::Firmware11);
    let anna = armed(&mut it);
    let command = vector([10.0, 0.0, 0.0], true);
    it.ask(anna, Request::Command { command }).unwrap();
    it.run_for(Duration::from_secs(5));
    let told = it
        .notices()
        .iter()
        .filter(|notice| notice.news == News::LaserOff);
    assert_eq!(told.count(), 1, "{:?}", it.notices());
}

#[test]
fn consecutive_vectors_burn_without_a_packet_between_them() {
    for personality in Personality::ALL {
        let mut it = virtual_station(personality);
        let anna = armed(&mut it);
        let before = it.packets().len();
        for x_mm in [5.0, 6.0, 7.0, 8.0] {
            let command = vector([x_mm, 0.0, 0.0], true);
            it.ask(anna, Request::Command { command }).unwrap();
        }
        it.run_for(Duration::from_secs(8));
        let sent: Vec<Command> = it.packets()[before..]
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
    let mut it = VirtualStation::with_arm(arm, power_up, policy);
    it.run_for(Duration::from_secs(1));
    let anna = armed(&mut it);
    let command = vector([10.0, 0.0, 0.0], true);
    it.ask(anna, Request::Command { command }).unwrap();
    it.run_for(Duration::from_secs(5));
    assert!(burns(&it));
    assert!(it.supervisor().state().laser.on);
}
