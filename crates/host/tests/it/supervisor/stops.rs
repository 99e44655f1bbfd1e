//! Anyone may stop the arm, and it stays stopped.

use std::time::Duration;

use dobot_api::{ClientId, Jog, News, Notice, Reply, Request};
use dobot_controller::Personality;
use dobot_host::VirtualStation;
use dobot_supervisor::StoppedBy;
use dobot_wire::{Command, Dialect, JointJog, JointJogAxis, MoveTo, Packet};

use super::drawing::{spiral, virtual_station};

const STOP: Request = Request::Stop { reason: None };

fn target(y_mm: f32) -> Request {
    Request::Command {
        command: MoveTo::to(220.0, y_mm, 30.0).into(),
    }
}

/// Returns the commands put on the wire since then.
pub(crate) fn sent_since(station: &VirtualStation, since: usize) -> Vec<Command> {
    let packets = station.packets()[since..].iter();
    let frame = |bytes: &[u8; 42]| Packet::from_bytes(bytes).expect("the station sends packets");
    packets
        .map(|(_, bytes)| Command::parse(&frame(bytes), &Dialect::FIRMWARE_1_1).unwrap())
        .collect()
}

const LASER_OFF: Command = Command::JointJog(JointJog::new(JointJogAxis::LaserOff, 0.0));

#[test]
fn the_first_packet_after_a_stop_is_laser_off_and_is_sent_immediately() {
    for stop_ms in (3_300..3_500).step_by(10) {
        let mut station = virtual_station(Personality::Firmware11);
        let (anna, ben) = (station.client("Anna"), station.client("Ben"));
        station.ask(anna, Request::TakeLease).unwrap();
        let job = station.submit(&spiral(12)).unwrap();
        station.start(anna, job).unwrap();
        station.run_for(Duration::from_millis(stop_ms));
        let (before, at) = (station.packets().len(), station.now());
        station.ask(ben, STOP).unwrap();
        assert_eq!(sent_since(&station, before)[0], LASER_OFF);
        assert_eq!(station.packets()[before].0, at, "after {stop_ms} ms");
        // A packet sent just before may have corrupted it: it is repeated.
        station.run_for(Duration::from_secs(10));
        let sent = sent_since(&station, before);
        assert!(sent.iter().filter(|command| **command == LASER_OFF).count() >= 2);
    }
}

#[test]
fn a_stop_right_after_the_release_of_a_button_also_switches_the_laser_off() {
    for personality in Personality::ALL {
        for (presses, later_ms) in [(1, 5), (2, 0), (2, 5), (2, 30), (2, 60), (8, 5), (8, 200)] {
            let mut station = virtual_station(personality);
            let anna = station.client("Anna");
            station.ask(anna, Request::TakeLease).unwrap();
            let jog = Jog::Joint(JointJog::new(JointJogAxis::BasePlus, 30.0));
            for _ in 0..presses {
                station.ask(anna, Request::Jog { jog }).unwrap();
                station.run_for(Duration::from_millis(60));
            }
            station.ask(anna, Request::Release).unwrap();
            station.run_for(Duration::from_millis(later_ms));
            let before = station.packets().len();
            station.ask(anna, Request::Stop { reason: None }).unwrap();
            let sent = sent_since(&station, before);
            assert!(
                matches!(
                    sent[..],
                    [Command::JointJog(JointJog {
                        axis: JointJogAxis::LaserOff,
                        ..
                    })]
                ),
                "{personality}, {presses} presses, {later_ms} ms: {sent:?}"
            );
            // The release, which the laser's packet may have damaged on the line, is repeated.
            station.run_for(Duration::from_secs(2));
            let again = |command: &Command| matches!(command, Command::JointJog(jog) if jog.axis == JointJogAxis::Released);
            assert!(
                sent_since(&station, before).iter().any(again),
                "{personality}, {later_ms} ms"
            );
        }
    }
}

#[test]
fn a_stopped_arm_refuses_everything_until_a_person_resets_the_stop() {
    let mut station = virtual_station(Personality::Firmware11);
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    let reason = Some("a hand".to_owned());
    station.ask(anna, Request::Stop { reason }).unwrap();
    let refused = station.ask(anna, target(20.0)).unwrap_err();
    assert_eq!(refused.to_string(), "the arm was stopped by Anna: a hand");
    station.run_for(Duration::from_mins(1));
    assert_eq!(
        station.ask(anna, target(20.0)).unwrap_err().kind(),
        "stopped"
    );
    station.ask(anna, Request::ResetStop).unwrap();
    station.ask(anna, target(20.0)).unwrap();
}

#[test]
fn a_stop_cannot_be_reset_while_the_arm_is_moving() {
    let mut station = virtual_station(Personality::Firmware11);
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    station.ask(anna, target(100.0)).unwrap();
    station.run_for(Duration::from_millis(800));
    station.ask(anna, STOP).unwrap();
    assert_eq!(
        station.ask(anna, Request::ResetStop).unwrap_err().kind(),
        "still-moving"
    );
    let minute = station.now() + Duration::from_mins(1);
    let at_rest = |station: &VirtualStation| {
        station
            .supervisor()
            .state()
            .stop
            .is_some_and(|stop| stop.at_rest)
    };
    assert!(station.run_until(minute, at_rest));
    station.ask(anna, Request::ResetStop).unwrap();
}

#[test]
fn queued_packets_are_never_sent_after_a_stop() {
    let mut station = virtual_station(Personality::Firmware11);
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    for y_mm in [100.0, -100.0, 100.0, -100.0, 100.0] {
        station.ask(anna, target(y_mm)).unwrap();
    }
    station.run_for(Duration::from_millis(500));
    let before = station.packets().len();
    station.ask(anna, STOP).unwrap();
    station.run_for(Duration::from_mins(1));
    let moved = sent_since(&station, before)
        .into_iter()
        .filter(|command| matches!(command, Command::MoveTo(_)))
        .count();
    assert_eq!(moved, 0);
    let failed = |notice: &&dobot_api::Notice| matches!(notice.news, News::CommandFailed { .. });
    assert!(station.notices().iter().filter(failed).count() >= 3);
}

#[test]
fn the_arm_rests_within_the_promised_time_after_a_stop_at_any_moment() {
    for eighth in 1..40 {
        let mut station = virtual_station(Personality::Firmware11);
        let anna = station.client("Anna");
        station.ask(anna, Request::TakeLease).unwrap();
        let job = station.submit(&spiral(12)).unwrap();
        station.start(anna, job).unwrap();
        station.run_for(Duration::from_millis(125 * eighth));
        station.ask(anna, STOP).unwrap();
        let stop = station.supervisor().state().stop.unwrap();
        let promised = Duration::from_secs_f64(stop.rests_by_s);
        station.run_until(promised, |_| false);
        let there = station.arm().mechanics().joints_at(station.now());
        station.run_for(Duration::from_secs(30));
        let later = station.arm().mechanics().joints_at(station.now());
        assert_eq!(there, later, "stopped after {eighth} eighths of a second");
    }
}

/// A station whose cable is pulled while a button is held.
fn unplugged_in_a_jog(personality: Personality) -> (VirtualStation, ClientId) {
    let mut station = virtual_station(personality);
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    let jog = Jog::Joint(JointJog::new(JointJogAxis::BasePlus, 30.0));
    for _ in 0..10 {
        station.ask(anna, Request::Jog { jog }).unwrap();
        station.run_for(Duration::from_millis(50));
    }
    station.unplug();
    station.run_for(Duration::from_millis(600));
    (station, anna)
}

fn notices_with(station: &VirtualStation, text: &str) -> usize {
    let has = |notice: &&Notice| notice.text.contains(text);
    station.notices().iter().filter(has).count()
}

#[test]
fn a_stop_without_a_link_is_reported_as_not_delivered_until_it_is() {
    for personality in Personality::ALL {
        let (mut station, anna) = unplugged_in_a_jog(personality);
        let ben = station.client("Ben");
        let reply = station.ask(ben, STOP).unwrap();
        assert!(
            matches!(
                reply,
                Reply::Stopping {
                    delivered: false,
                    ..
                }
            ),
            "{reply:?}"
        );
        assert!(!station.supervisor().state().stop.unwrap().delivered);
        station.run_for(Duration::from_secs(5));
        assert!(
            notices_with(&station, "NOT DELIVERED") >= 5,
            "{personality}"
        );
        // It is unknown whether the arm is at rest.
        let refused = station.ask(anna, Request::ResetStop).unwrap_err();
        assert_eq!(refused.kind(), "no-link");
        let before = station.packets().len();
        station.plug();
        station.run_for(Duration::from_secs(1));
        assert_eq!(sent_since(&station, before)[0], LASER_OFF, "{personality}");
        assert!(station.supervisor().state().stop.unwrap().delivered);
        assert_eq!(notices_with(&station, "the stop has been delivered"), 1);
        station.run_for(Duration::from_secs(5));
        station.ask(anna, Request::ResetStop).unwrap();
    }
}

#[test]
fn a_release_and_laser_off_without_a_link_are_refused_as_not_delivered() {
    for personality in Personality::ALL {
        let (mut station, anna) = unplugged_in_a_jog(personality);
        for asked in [Request::Release, Request::DisarmLaser] {
            assert_eq!(
                station.ask(anna, asked).unwrap_err().kind(),
                "not-delivered"
            );
        }
    }
}

#[test]
fn a_stop_with_a_link_is_delivered() {
    let mut station = virtual_station(Personality::Firmware11);
    let anna = station.client("Anna");
    let reply = station.ask(anna, STOP).unwrap();
    assert!(
        matches!(
            reply,
            Reply::Stopping {
                delivered: true,
                ..
            }
        ),
        "{reply:?}"
    );
    assert!(station.supervisor().state().stop.unwrap().delivered);
}

fn fire_drill() -> StoppedBy {
    StoppedBy {
        by: "Ms Weber".into(),
        reason: Some("fire drill".into()),
        ..StoppedBy::default()
    }
}

/// Two stations of a fleet, and who controls the second one.
fn two_stations() -> (VirtualStation, VirtualStation, ClientId) {
    let one = virtual_station(Personality::Firmware11);
    let mut other = virtual_station(Personality::Firmware11);
    let ben = other.client("Ben");
    other.ask(ben, Request::TakeLease).unwrap();
    (one, other, ben)
}

/// No motion was put on the wire since then.
fn moved_since(station: &VirtualStation, since: usize) -> bool {
    let sent = sent_since(station, since);
    sent.iter().any(
        |command| !matches!(command, Command::JointJog(jog) if jog.speed_percent == 0.0 || *command == LASER_OFF),
    )
}

#[test]
fn a_fleet_stop_first_switches_the_laser_off_and_nothing_more_is_sent() {
    let (mut one, mut other, ben) = two_stations();
    let job = other.submit(&spiral(12)).unwrap();
    other.start(ben, job).unwrap();
    other.run_for(Duration::from_secs(3));
    let stop = one.stop_fleet("desk-1", fire_drill());
    let before = other.packets().len();
    other.adopt_fleet_stops(std::slice::from_ref(&stop));
    assert_eq!(sent_since(&other, before)[0], LASER_OFF);
    other.run_for(Duration::from_mins(1));
    assert!(!moved_since(&other, before));
    let refused = other.ask(ben, target(20.0)).unwrap_err();
    assert_eq!(refused.kind(), "stopped");
    let text = "stopped: fleet, by Ms Weber: fire drill";
    assert_eq!(refused.to_string(), text);
    assert_eq!(other.supervisor().state().stop.unwrap().text(), text);
    assert!(other.start(ben, job).is_err());
    assert!(!moved_since(&other, before));
}

#[test]
fn a_fleet_stop_holds_through_a_restart_of_every_station() {
    let (mut one, mut other, _) = two_stations();
    let stop = one.stop_fleet("desk-1", fire_drill());
    other.adopt_fleet_stops(&[stop]);
    for station in [&mut one, &mut other] {
        station.run_for(Duration::from_secs(10));
        station.crash(Duration::from_secs(2)).unwrap();
        station.run_for(Duration::from_secs(1));
        let anna = station.client("Anna");
        station.ask(anna, Request::TakeLease).unwrap();
        let before = station.packets().len();
        assert_eq!(
            station.ask(anna, target(20.0)).unwrap_err().kind(),
            "stopped"
        );
        station.run_for(Duration::from_secs(10));
        assert!(!moved_since(station, before));
    }
}

#[test]
fn a_station_that_was_away_at_the_fleet_reset_moves_again_once_it_learns_of_it() {
    let (mut one, mut other, ben) = two_stations();
    let stop = one.stop_fleet("desk-1", fire_drill());
    other.adopt_fleet_stops(&[stop]);
    one.run_for(Duration::from_secs(10));
    let reset = one.reset_fleet("Ms Weber");
    assert_eq!(one.supervisor().state().stop, None);
    other.run_for(Duration::from_secs(10));
    assert_eq!(other.ask(ben, target(20.0)).unwrap_err().kind(), "stopped");
    other.adopt_fleet_stops(&reset);
    other.ask(ben, target(20.0)).unwrap();
}

#[test]
fn an_arm_that_is_still_moving_is_released_by_a_fleet_reset_when_it_rests() {
    let (mut one, mut other, ben) = two_stations();
    other.ask(ben, target(100.0)).unwrap();
    other.run_for(Duration::from_millis(800));
    let stop = one.stop_fleet("desk-1", fire_drill());
    other.adopt_fleet_stops(&[stop]);
    other.adopt_fleet_stops(&one.reset_fleet("Ms Weber"));
    assert_eq!(other.ask(ben, target(0.0)).unwrap_err().kind(), "stopped");
    let minute = other.now() + Duration::from_mins(1);
    assert!(other.run_until(minute, |station| {
        station.supervisor().state().stop.is_none()
    }));
    assert!(other.supervisor().is_at_rest());
}

#[test]
fn a_stop_of_one_arm_holds_when_the_fleet_is_reset() {
    let (mut one, mut other, ben) = two_stations();
    let reason = Some("finger caught".to_owned());
    other.ask(ben, Request::Stop { reason }).unwrap();
    let stop = one.stop_fleet("desk-1", fire_drill());
    other.adopt_fleet_stops(&[stop]);
    assert!(other.supervisor().state().stop.unwrap().of_fleet);
    other.run_for(Duration::from_secs(10));
    other.adopt_fleet_stops(&one.reset_fleet("Ms Weber"));
    let stop = other.supervisor().state().stop.unwrap();
    assert_eq!(stop.text(), "stopped by Ben: finger caught");
    assert_eq!(other.ask(ben, target(20.0)).unwrap_err().kind(), "stopped");
    // It is known after a restart which one is left.
    other.crash(Duration::from_secs(2)).unwrap();
    let stop = other.supervisor().state().stop.unwrap();
    assert_eq!(stop.text(), "stopped by Ben: finger caught");
}

#[test]
fn an_arm_reset_by_a_person_moves_while_the_others_stay_stopped_and_is_not_stopped_again() {
    let (mut one, mut other, ben) = two_stations();
    let stop = one.stop_fleet("desk-1", fire_drill());
    other.adopt_fleet_stops(std::slice::from_ref(&stop));
    other.run_for(Duration::from_secs(10));
    other.ask(ben, Request::ResetStop).unwrap();
    other.ask(ben, target(20.0)).unwrap();
    // The others send it again, also after a restart.
    other.run_for(Duration::from_secs(10));
    other.crash(Duration::from_secs(2)).unwrap();
    other.run_for(Duration::from_secs(1));
    let known = other.adopt_fleet_stops(std::slice::from_ref(&stop));
    assert_eq!(known, [stop]);
    let ben = other.client("Ben");
    other.ask(ben, Request::TakeLease).unwrap();
    other.ask(ben, target(0.0)).unwrap();
    assert!(one.supervisor().is_stopped());
    // A new one stops it.
    other.adopt_fleet_stops(&[one.stop_fleet("desk-1", fire_drill())]);
    assert_eq!(other.ask(ben, target(20.0)).unwrap_err().kind(), "stopped");
}
