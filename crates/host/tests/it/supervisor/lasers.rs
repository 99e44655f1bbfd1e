//! The laser is off, unless a person has armed it, for a while.

use std::time::Duration;

use dobot_api::{ClientId, Reply, Request};
use dobot_arm::Tool;
use dobot_controller::Personality;
use dobot_host::VirtualStation;
use dobot_supervisor::Refusal;
use dobot_wire::{Command, Configuration, MoveTo, WriteMode, WriteVector};

use super::drawing::{burnt_spiral, start_burning, virtual_station};

const PERSONALITIES: [Personality; 2] = Personality::ALL;

/// An arm that burns.
fn burning(personality: Personality) -> (VirtualStation, ClientId, u64) {
    let mut station = virtual_station(personality);
    let anna = station.client("Anna");
    let job = start_burning(&mut station, anna);
    let minute = station.now() + Duration::from_secs(60);
    assert!(
        station.run_until(minute, burns),
        "{personality}: it begins to burn"
    );
    station.run_for(Duration::from_secs(1));
    (station, anna, job)
}

pub(crate) fn burns(station: &VirtualStation) -> bool {
    station.arm().controller().outputs().laser
}

/// Half a second ahead, the vector that runs, and the line.
pub(crate) const SOON: Duration = Duration::from_millis(2_500);

#[test]
fn a_job_that_burns_is_refused_while_the_laser_is_disarmed() {
    let mut station = virtual_station(Personality::Firmware11);
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    let job = station.submit(&burnt_spiral(4)).unwrap();
    assert_eq!(station.start(anna, job), Err(Refusal::LaserDisarmed));
    station.run_for(Duration::from_secs(10));
    assert!(!burns(&station));
}

#[test]
fn the_laser_is_off_soon_after_a_stop() {
    for personality in PERSONALITIES {
        let (mut station, anna, _) = burning(personality);
        station.ask(anna, Request::Stop { reason: None }).unwrap();
        station.run_for(SOON);
        assert!(!burns(&station), "{personality}");
        assert!(station.supervisor().state().laser.armed_for_s == 0.0);
    }
}

#[test]
fn the_laser_is_off_soon_after_the_client_that_armed_it_leaves() {
    for personality in PERSONALITIES {
        let (mut station, anna, job) = burning(personality);
        station.leave(anna);
        station.run_for(SOON);
        assert!(!burns(&station), "{personality}");
        let left = station.now() + Duration::from_secs(30);
        let paused = |station: &VirtualStation| {
            station
                .job(job)
                .unwrap()
                .state
                .to_string()
                .starts_with("paused")
        };
        assert!(station.run_until(left, paused), "{personality}");
    }
}

#[test]
fn the_laser_is_off_soon_after_its_arming_time_is_over() {
    for personality in PERSONALITIES {
        let (mut station, anna, _) = burning(personality);
        station.ask(anna, Request::ArmLaser { for_s: 1.0 }).unwrap();
        station.run_for(Duration::from_secs(1) + SOON);
        assert!(!burns(&station), "{personality}");
    }
}

#[test]
fn the_laser_is_off_soon_after_a_pause() {
    for personality in PERSONALITIES {
        let (mut station, anna, _) = burning(personality);
        station.ask(anna, Request::PauseJob).unwrap();
        station.run_for(SOON);
        assert!(!burns(&station), "{personality}");
    }
}

#[test]
fn the_laser_is_off_soon_after_a_killed_station_is_restarted() {
    for personality in PERSONALITIES {
        let (mut station, _, _) = burning(personality);
        station.crash(Duration::from_millis(700)).unwrap();
        station.run_for(SOON);
        assert!(!burns(&station), "{personality}");
    }
}

#[test]
fn the_laser_is_armed_for_no_longer_than_the_policy_allows() {
    let mut station = virtual_station(Personality::Firmware11);
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    for for_s in [0.0, -1.0, 601.0, f64::NAN, f64::INFINITY] {
        let refused = station.ask(anna, Request::ArmLaser { for_s }).unwrap_err();
        assert_eq!(refused.kind(), "out-of-range", "{for_s}");
    }
}

/// A detection that a person ends early, `after` its beginning, by giving control back and taking it again.
fn detection_ended(personality: Personality, after: Duration) -> (VirtualStation, ClientId) {
    let mut station = virtual_station(personality);
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    station.ask(anna, Request::Detect).unwrap();
    station.run_for(after);
    for request in [Request::ReleaseLease, Request::TakeLease] {
        station.ask(anna, request).unwrap();
    }
    (station, anna)
}

/// Stops, and runs until the time is over that was promised, and the line.
fn stop_as_promised(station: &mut VirtualStation, anna: ClientId) {
    let stopping = station.ask(anna, Request::Stop { reason: None });
    let Ok(Reply::Stopping { rests_within_s, .. }) = stopping else {
        panic!("anyone may stop: {stopping:?}");
    };
    station.run_for(Duration::from_secs_f64(rests_within_s) + Duration::from_millis(500));
}

#[test]
fn a_stop_keeps_its_time_on_an_arm_that_a_detection_left_slow() {
    // Each of them ends the detection after a different packet.
    for (personality, tenths) in PERSONALITIES.into_iter().zip([1, 3]) {
        let after = Duration::from_millis(100 * tenths);
        let (mut station, anna) = detection_ended(personality, after);
        station.run_for(Duration::from_secs(6));
        let vector = WriteVector {
            mode: WriteMode::Laser,
            laser: true,
            start_speed_mm_s: 20.0,
            end_speed_mm_s: 20.0,
            ..WriteVector::by(9.0, 9.0, 0.0, 20.0)
        };
        let commands: [Command; 3] = [
            Configuration::EndEffector {
                tool: Tool::Laser.into(),
            }
            .into(),
            vector.into(),
            MoveTo::to(220.0, 30.0, 30.0).into(),
        ];
        station
            .ask(anna, Request::ArmLaser { for_s: 60.0 })
            .unwrap();
        for command in commands {
            station.ask(anna, Request::Command { command }).unwrap();
        }
        let minute = station.now() + Duration::from_secs(60);
        let has_all = |station: &VirtualStation| station.supervisor().session().waiting() == 0;
        assert!(station.run_until(minute, has_all), "{personality}");
        assert!(station.run_until(minute, burns), "{personality}");
        stop_as_promised(&mut station, anna);
        assert!(!burns(&station), "{personality}");
    }
}

#[test]
fn a_stop_keeps_its_time_in_a_motion_of_a_detection_that_ended() {
    for personality in PERSONALITIES {
        for tenths in 8..40 {
            let after = Duration::from_millis(100 * tenths);
            let (mut station, anna) = detection_ended(personality, after);
            stop_as_promised(&mut station, anna);
            let place = station.arm().controller().steps();
            station.run_for(Duration::from_secs(10));
            assert_eq!(
                station.arm().controller().steps(),
                place,
                "{personality}: it is at rest {after:?} after it"
            );
        }
    }
}
