//! Notices to clients about commands that end in a pause.

use std::time::Duration;

use dobot_api::{News, Reply, Request};
use dobot_controller::Personality;
use dobot_host::VirtualStation;
use dobot_wire::{Command, Configuration, MoveTo};

use super::drawing::virtual_station;
use crate::cases::commands::target;

/// The first packet of the vendor's client: a default pause of 100 s (note N10).
const VENDORS: Command = Command::Configuration(Configuration::Playback {
    joint_speed_deg_s: 200.0,
    joint_acceleration_deg_s2: 200.0,
    servo_speed_deg_s: 200.0,
    servo_acceleration_deg_s2: 200.0,
    linear_speed_mm_s: 200.0,
    linear_acceleration_mm_s2: 200.0,
    default_pause_s: 100.0,
    jump_height_mm: 20.0,
});

/// Returns the time and text of a notice.
fn notice_of(station: &VirtualStation, which: impl Fn(&News) -> bool) -> Option<(f64, String)> {
    let notice = station
        .notices()
        .iter()
        .find(|notice| which(&notice.news))?;
    Some((notice.at_s, notice.text.clone()))
}

/// Sends a target after the vendor's first packets, lets two minutes pass, and returns its number.
fn sent(station: &mut VirtualStation, target: MoveTo) -> u64 {
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    for command in [VENDORS, target.into()] {
        let asked = Request::Command { command };
        let Reply::Accepted { command, .. } = station.ask(anna, asked).unwrap() else {
            panic!("it is accepted");
        };
        if command > 0 {
            station.run_for(Duration::from_secs(120));
            return command;
        }
    }
    panic!("two commands have two numbers");
}

#[test]
fn a_default_pause_of_100_s_is_reported_at_its_start_and_the_command_is_done_at_its_end() {
    let mut station = virtual_station(Personality::Specification);
    let number = sent(&mut station, target([220.0, 40.0, 20.0]));
    let pauses = |news: &News| matches!(news, News::Pausing { lasts_s: 100.0, .. });
    let (began_s, text) = notice_of(&station, pauses).expect("it is reported");
    assert_eq!(
        text,
        "the arm waits 100 s here: its default pause (state 9, mode 1)"
    );
    let done = |news: &News| *news == News::CommandDone { command: number };
    let (done_s, _) = notice_of(&station, done).expect("it is reported");
    assert!(began_s < 7.0, "{began_s}");
    assert!((99.0..101.0).contains(&(done_s - began_s)), "{done_s}");
}

#[test]
fn no_pause_is_reported_for_an_arm_that_ignores_the_default_pause() {
    let mut station = virtual_station(Personality::Firmware11);
    let number = sent(&mut station, target([220.0, 40.0, 20.0]));
    assert_eq!(
        notice_of(&station, |news| matches!(news, News::Pausing { .. })),
        None
    );
    let done = |news: &News| *news == News::CommandDone { command: number };
    let (done_s, _) = notice_of(&station, done).expect("it is reported");
    assert!(done_s < 6.0, "{done_s}");
}

#[test]
fn an_explicit_pause_is_reported_as_that_of_the_command() {
    for personality in [Personality::Specification, Personality::Firmware11] {
        let mut station = virtual_station(personality);
        let pausing = MoveTo {
            pause_s: 7.5,
            ..target([220.0, 40.0, 20.0])
        };
        let number = sent(&mut station, pausing);
        let (_, text) = notice_of(&station, |news| matches!(news, News::Pausing { .. }))
            .expect("it is reported");
        let expected = format!("the arm waits 7.5 s here: the pause of command {number}");
        assert_eq!(text, expected, "{personality}");
    }
}
