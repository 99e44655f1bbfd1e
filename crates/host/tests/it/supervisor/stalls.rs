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
fn sent(it: &VirtualStation, since: usize, personality: Personality) -> Vec<Command> {
    let packets = it.packets()[since..].iter();
    packets
        .filter_map(|(_, bytes)| Packet::from_bytes(bytes))
        .map(|packet| Command::parse(&packet, &personality.dialect()).unwrap())
        .collect()
}

fn is_laser_off(command: &Command) -> bool {
    matches!(command, Command::JointJog(it) if it.axis == JointJogAxis::LaserOff)
}

#[test]
fn a_station_suspended_in_a_jog_releases_and_disarms_the_laser_before_all_else() {
    for personality in Personality::ALL {
        let mut it = virtual_station(personality);
        let anna = it.client("Anna");
        it.ask(anna, Request::TakeLease).unwrap();
        it.ask(anna, Request::ArmLaser { for_s: 60.0 }).unwrap();
        let jog = Jog::Linear(LinearJog::new(LinearJogAxis::YPlus, 30.0));
        for _ in 0..8 {
            it.ask(anna, Request::Jog { jog }).unwrap();
            it.run_for(Duration::from_millis(50));
        }
        let before = it.packets().len();
        it.stall(Duration::from_millis(2300));
        it.run_for(Duration::from_secs(3));
        let said = sent(&it, before, personality);
        assert!(is_laser_off(&said[0]), "{personality}: {said:?}");
        let release = |command: &Command| matches!(command, Command::LinearJog(jog) if jog.axis == LinearJogAxis::Released);
        assert!(said.iter().any(release), "{personality}: {said:?}");
        assert!(
            said.iter()
                .all(|command| release(command) || is_laser_off(command)),
            "{personality}: {said:?}"
        );
        let state = it.supervisor().state();
        assert!(state.laser.armed_for_s == 0.0, "{personality}");
        assert!(it.supervisor().is_at_rest(), "{personality}");
        let told = |notice: &dobot_api::Notice| notice.text.contains("hung for 2.3 s");
        assert!(it.notices().iter().any(told), "{personality}");
    }
}

#[test]
fn a_burning_job_of_a_suspended_station_is_paused() {
    for personality in Personality::ALL {
        let (mut it, _, _) = armed(personality);
        let latest = it.now() + Duration::from_secs(20);
        assert!(it.run_until(latest, |station| station.arm().controller().outputs().laser));
        let before = it.packets().len();
        it.stall(Duration::from_millis(400));
        it.run_for(Duration::from_secs(5));
        assert!(
            is_laser_off(&sent(&it, before, personality)[0]),
            "{personality}"
        );
        assert!(!it.arm().controller().outputs().laser, "{personality}");
        let phase = it.supervisor().job().map(|job| job.phase);
        assert_eq!(phase, Some(JobPhase::Paused), "{personality}");
    }
}

#[test]
fn without_a_watchdog_nothing_jogs_or_burns_until_there_is_a_new_one() {
    for personality in Personality::ALL {
        let mut it = virtual_station(personality);
        let anna = it.client("Anna");
        it.ask(anna, Request::TakeLease).unwrap();
        let jog = Jog::Joint(JointJog::new(JointJogAxis::BasePlus, 30.0));
        for _ in 0..8 {
            it.ask(anna, Request::Jog { jog }).unwrap();
            it.run_for(Duration::from_millis(50));
        }
        let before = it.packets().len();
        it.set_watchdog(Some("no process is left"));
        it.run_for(Duration::from_secs(2));
        let released = |command: &Command| matches!(command, Command::JointJog(jog) if jog.axis == JointJogAxis::Released);
        let sent_then = sent(&it, before, personality);
        assert!(released(&sent_then[0]), "{personality}: {sent_then:?}");
        assert!(it.supervisor().is_at_rest(), "{personality}");
        let before = it.packets().len();
        let other = Jog::Joint(JointJog::new(JointJogAxis::BaseMinus, 30.0));
        for asked in [
            Request::Jog { jog: other },
            Request::ArmLaser { for_s: 60.0 },
        ] {
            let refusal = it.ask(anna, asked).unwrap_err();
            assert!(matches!(refusal, Refusal::Unguarded(_)), "{refusal}");
        }
        it.run_for(Duration::from_secs(1));
        assert_eq!(sent(&it, before, personality), [], "{personality}");
        it.set_watchdog(None);
        it.ask(anna, Request::ArmLaser { for_s: 60.0 }).unwrap();
        it.ask(anna, Request::Jog { jog }).unwrap();
    }
}

#[test]
fn a_burning_job_that_loses_its_watchdog_is_paused_with_the_laser_off() {
    for personality in Personality::ALL {
        let (mut it, _, _) = armed(personality);
        let latest = it.now() + Duration::from_secs(20);
        assert!(it.run_until(latest, |station| station.arm().controller().outputs().laser));
        it.set_watchdog(Some("no process is left"));
        it.run_for(Duration::from_secs(5));
        assert!(!it.arm().controller().outputs().laser, "{personality}");
        let phase = it.supervisor().job().map(|job| job.phase);
        assert_eq!(phase, Some(JobPhase::Paused), "{personality}");
    }
}
