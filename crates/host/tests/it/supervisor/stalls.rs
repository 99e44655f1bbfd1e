//! A station that was frozen acts as after a fault.

use std::time::Duration;

use dobot_api::{JobPhase, Jog, Request};
use dobot_controller::Personality;
use dobot_host::VirtualStation;
use dobot_supervisor::Refusal;
use dobot_wire::{Command, JointJog, JointJogAxis, LinearJog, LinearJogAxis, Packet};

use super::burns::armed;
use super::drawing::virtual_station;

/// The commands since a packet.
fn sent(station: &VirtualStation, since: usize, personality: Personality) -> Vec<Command> {
    let packets = station.packets()[since..].iter();
    packets
        .filter_map(|(_, bytes)| Packet::from_bytes(bytes))
        .map(|packet| Command::parse(&packet, &personality.dialect()).unwrap())
        .collect()
}

fn is_laser_off(command: &Command) -> bool {
    matches!(command, Command::JointJog(jog) if jog.axis == JointJogAxis::LaserOff)
}

#[test]
fn a_station_suspended_in_a_jog_releases_and_disarms_the_laser_before_all_else() {
    for personality in Personality::ALL {
        let mut station = virtual_station(personality);
        let anna = station.client("Anna");
        station.ask(anna, Request::TakeLease).unwrap();
        station
            .ask(anna, Request::ArmLaser { for_s: 60.0 })
            .unwrap();
        let jog = Jog::Linear(LinearJog::new(LinearJogAxis::YPlus, 30.0));
        for _ in 0..8 {
            station.ask(anna, Request::Jog { jog }).unwrap();
            station.run_for(Duration::from_millis(50));
        }
        let before = station.packets().len();
        station.stall(Duration::from_millis(2300));
        station.run_for(Duration::from_secs(3));
        let sent = sent(&station, before, personality);
        assert!(is_laser_off(&sent[0]), "{personality}: {sent:?}");
        let release = |command: &Command| matches!(command, Command::LinearJog(jog) if jog.axis == LinearJogAxis::Released);
        assert!(sent.iter().any(release), "{personality}: {sent:?}");
        assert!(
            sent.iter()
                .all(|command| release(command) || is_laser_off(command)),
            "{personality}: {sent:?}"
        );
        let state = station.supervisor().state();
        assert!(state.laser.armed_for_s == 0.0, "{personality}");
        assert!(station.supervisor().is_at_rest(), "{personality}");
        let is_notice = |notice: &dobot_api::Notice| notice.text.contains("hung for 2.3 s");
        assert!(station.notices().iter().any(is_notice), "{personality}");
    }
}

#[test]
fn a_burning_job_of_a_suspended_station_is_paused() {
    for personality in Personality::ALL {
        let (mut station, _, _) = armed(personality);
        let latest = station.now() + Duration::from_secs(20);
        assert!(station.run_until(latest, |station| station.arm().controller().outputs().laser));
        let before = station.packets().len();
        station.stall(Duration::from_millis(400));
        station.run_for(Duration::from_secs(5));
        assert!(
            is_laser_off(&sent(&station, before, personality)[0]),
            "{personality}"
        );
        assert!(!station.arm().controller().outputs().laser, "{personality}");
        let phase = station.supervisor().job().map(|job| job.phase);
        assert_eq!(phase, Some(JobPhase::Paused), "{personality}");
    }
}

#[test]
fn without_a_watchdog_nothing_jogs_or_burns_until_there_is_a_new_one() {
    for personality in Personality::ALL {
        let mut station = virtual_station(personality);
        let anna = station.client("Anna");
        station.ask(anna, Request::TakeLease).unwrap();
        let jog = Jog::Joint(JointJog::new(JointJogAxis::BasePlus, 30.0));
        for _ in 0..8 {
            station.ask(anna, Request::Jog { jog }).unwrap();
            station.run_for(Duration::from_millis(50));
        }
        let before = station.packets().len();
        station.set_watchdog(Some("no process is left"));
        station.run_for(Duration::from_secs(2));
        let released = |command: &Command| matches!(command, Command::JointJog(jog) if jog.axis == JointJogAxis::Released);
        let sent_then = sent(&station, before, personality);
        assert!(released(&sent_then[0]), "{personality}: {sent_then:?}");
        assert!(station.supervisor().is_at_rest(), "{personality}");
        let before = station.packets().len();
        let other = Jog::Joint(JointJog::new(JointJogAxis::BaseMinus, 30.0));
        for asked in [
            Request::Jog { jog: other },
            Request::ArmLaser { for_s: 60.0 },
        ] {
            let refusal = station.ask(anna, asked).unwrap_err();
            assert!(matches!(refusal, Refusal::Unguarded(_)), "{refusal}");
        }
        station.run_for(Duration::from_secs(1));
        assert_eq!(sent(&station, before, personality), [], "{personality}");
        station.set_watchdog(None);
        station
            .ask(anna, Request::ArmLaser { for_s: 60.0 })
            .unwrap();
        station.ask(anna, Request::Jog { jog }).unwrap();
    }
}

#[test]
fn a_burning_job_that_loses_its_watchdog_is_paused_with_the_laser_off() {
    for personality in Personality::ALL {
        let (mut station, _, _) = armed(personality);
        let latest = station.now() + Duration::from_secs(20);
        assert!(station.run_until(latest, |station| station.arm().controller().outputs().laser));
        station.set_watchdog(Some("no process is left"));
        station.run_for(Duration::from_secs(5));
        assert!(!station.arm().controller().outputs().laser, "{personality}");
        let phase = station.supervisor().job().map(|job| job.phase);
        assert_eq!(phase, Some(JobPhase::Paused), "{personality}");
    }
}
