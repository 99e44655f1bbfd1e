//! The cable is pulled, the arm is reset, bytes are lost.

use std::iter;
use std::time::Duration;

use dobot_api::{
    CalibrationFile, Calibrations, ClientId, JobPhase, LinkCause, LinkPhase, LinkProblem, News,
    Request, Role,
};
use dobot_controller::{Controller, Personality, PowerUp};
use dobot_host::VirtualStation;
use dobot_motion::LASER_OFF;
use dobot_safety::Policy;
use dobot_sim::{Fault, RECORDING_PERIOD, SerialLine, VirtualArm};
use dobot_supervisor::{Refusal, Supervisor};
use dobot_wire::{Dialect, Packet};
use proptest::prelude::*;

use super::drawing::{drawn_mm, is_paused, spiral, start_burning, virtual_station, wanted_mm};

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn a_cable_that_was_pulled_and_plugged_in_again_costs_no_vector(
        after_ms in 0_u64..25_000,
        away_ms in 1_u64..10_000,
        twin in any::<bool>(),
    ) {
        let mut station = virtual_station(Personality::ALL[usize::from(twin)]);
        let drawing = spiral(12);
        let job = station.submit(&drawing).unwrap();
        let anna = station.client("Anna");
        station.ask(anna, Request::TakeLease).unwrap();
        station.start(anna, job).unwrap();
        station.run_for(Duration::from_millis(after_ms));
        station.unplug();
        station.run_for(Duration::from_millis(away_ms));
        station.plug();
        let is_over = |station: &VirtualStation| station.job(job).unwrap().state.is_over();
        for _ in 0..3 {
            let minutes = station.now() + Duration::from_mins(3);
            prop_assert!(station.run_until(minutes, |station| is_paused(station, job) || is_over(station)));
            if is_over(&station) {
                break;
            }
            // An arm that comes back with its base at 0 may have been reset meanwhile: a person
            // looks.
            station.ask(anna, Request::ConfirmPose).unwrap();
            station.start(anna, job).unwrap();
            // The journal writes that down.
            station.run_for(Duration::from_millis(100));
        }
        prop_assert!(is_over(&station));
        let (found_mm, wanted_mm) = (drawn_mm(&station), wanted_mm(&drawing));
        prop_assert!((found_mm - wanted_mm).abs() < 0.3, "{found_mm} mm, wanted {wanted_mm} mm");
    }
}

/// An arm on which something goes wrong.
fn faulty(fault: &str) -> VirtualStation {
    let power_up = PowerUp::new(Personality::Firmware11);
    let arm = VirtualArm::new(Controller::power_up(power_up), SerialLine::STOCK);
    let faults: Vec<Fault> = fault
        .split(' ')
        .map(|fault| fault.parse().unwrap())
        .collect();
    let mut arm = arm.with_faults(power_up, &faults, 7);
    arm.record(RECORDING_PERIOD);
    let mut station = VirtualStation::with_arm(arm, power_up, Policy::default());
    station.run_for(Duration::from_secs(1));
    station
}

#[test]
fn after_a_reset_the_arm_cannot_be_moved_until_its_pose_is_confirmed() {
    let mut station = faulty("reset@10s");
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    let job = station.submit(&spiral(12)).unwrap();
    station.start(anna, job).unwrap();
    station.run_for(Duration::from_secs(20));
    let state = station.supervisor().state();
    assert!(!state.trust.trusted, "{:?}", state.trust);
    assert!(is_paused(&station, job));
    let refused = station.start(anna, job).unwrap_err();
    assert!(
        refused.hint().is_some_and(|hint| hint.contains("confirm")),
        "{refused}"
    );
    station.ask(anna, Request::ConfirmPose).unwrap();
    assert!(station.supervisor().state().trust.trusted);
}

#[test]
fn an_arm_that_goes_silent_is_reported_as_lost_and_then_as_found() {
    let mut station = faulty("withhold@5s..12s");
    station.run_for(Duration::from_secs(7));
    let link = station.supervisor().state().link;
    assert_eq!(link.phase, LinkPhase::Lost);
    assert!(link.remedy.is_some_and(|remedy| remedy.contains("cable")));
    station.run_for(Duration::from_secs(10));
    assert_eq!(station.supervisor().state().link.phase, LinkPhase::Up);
}

#[test]
fn damaged_statuses_are_counted_and_the_drawing_is_still_right() {
    let mut station = faulty("flip=0.3%:from");
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    let drawing = spiral(12);
    let job = station.submit(&drawing).unwrap();
    station.start(anna, job).unwrap();
    let minutes = station.now() + Duration::from_mins(5);
    assert!(station.run_until(minutes, |station| station.job(job).unwrap().state.is_over()));
    let (found_mm, wanted_mm) = (drawn_mm(&station), wanted_mm(&drawing));
    assert!(
        (found_mm - wanted_mm).abs() < 0.3,
        "{found_mm} mm, wanted {wanted_mm} mm"
    );
    assert!(station.supervisor().state().link.damaged_bytes > 0);
}

/// A job that burns when something happens to the arm, and what became of it.
fn burning_until(fault: &str) -> (VirtualStation, ClientId, u64) {
    let mut station = faulty(fault);
    let anna = station.client("Anna");
    let job = start_burning(&mut station, anna);
    (station, anna, job)
}

fn assert_armed_again(station: &mut VirtualStation, anna: ClientId, job: u64, what: &str) {
    assert_eq!(
        station.supervisor().state().laser.armed_for_s,
        0.0,
        "{what}"
    );
    let disarmed = |notice: &&dobot_api::Notice| notice.news == News::LaserDisarmed;
    assert_eq!(
        station.notices().iter().filter(disarmed).count(),
        1,
        "{what}"
    );
    let latest = station.now() + Duration::from_secs(20);
    let up = |station: &VirtualStation| {
        station.supervisor().state().link.phase == LinkPhase::Up && is_paused(station, job)
    };
    assert!(station.run_until(latest, up), "{what}");
    station.run_for(Duration::from_secs(3));
    station.ask(anna, Request::ConfirmPose).unwrap();
    assert_eq!(
        station.start(anna, job),
        Err(Refusal::LaserDisarmed),
        "{what}"
    );
    station
        .ask(anna, Request::ArmLaser { for_s: 600.0 })
        .unwrap();
    station.start(anna, job).unwrap();
}

#[test]
fn a_reset_and_a_power_cut_and_silence_disarm_the_laser_until_a_person_arms_it_again() {
    for fault in [
        "reset@8s",
        "power@8s..11s",
        "withhold@8s..11s",
        "close@8s..10s",
    ] {
        let (mut station, anna, job) = burning_until(fault);
        let disarmed =
            |station: &VirtualStation| station.supervisor().state().laser.armed_for_s == 0.0;
        let latest = station.now() + Duration::from_secs(14);
        assert!(station.run_until(latest, disarmed), "{fault}");
        assert!(
            !station
                .supervisor()
                .job()
                .is_some_and(|job| job.phase == JobPhase::Running)
        );
        assert_armed_again(&mut station, anna, job, fault);
    }
}

#[test]
fn a_cable_that_is_pulled_disarms_the_laser() {
    let (mut station, anna, job) = burning_until("backlash=base:0");
    station.run_for(Duration::from_secs(7));
    station.unplug();
    assert_eq!(station.supervisor().state().laser.armed_for_s, 0.0);
    station.run_for(Duration::from_millis(300));
    station.plug();
    assert_armed_again(&mut station, anna, job, "cable");
}
/// A status of an arm.
fn status() -> [u8; 42] {
    let power_up = PowerUp::new(Personality::Firmware11);
    let mut controller = Controller::power_up(power_up);
    controller.handle_time(Duration::from_millis(100));
    controller.poll_bytes().expect("it reports its state").bytes
}

#[test]
fn each_opening_of_a_real_port_costs_the_trust_in_the_pose_and_that_of_a_virtual_arm_does_not() {
    for (address, trusted) in [
        ("serial:/dev/ttyUSB0@9600", false),
        ("tcp:192.168.1.7:5555", false),
        ("virtual:", true),
    ] {
        let mut supervisor =
            Supervisor::new(Policy::default(), Some(Personality::Firmware11.dialect()));
        let anna = supervisor.handle_client(Duration::ZERO, "Anna", Role::Admin, "Anna");
        supervisor.handle_request(Duration::ZERO, anna, Request::TakeLease);
        for opened in 1..4 {
            let now = Duration::from_secs(opened * 10);
            supervisor.handle_link_up(now, address);
            supervisor.handle_bytes(now + Duration::from_millis(80), &status());
            let trust = supervisor.state().trust;
            assert_eq!(trust.trusted, trusted, "{address}: {trust:?}");
            let confirmed = supervisor.handle_request(now, anna, Request::ConfirmPose);
            assert!(matches!(confirmed, Some(Ok(_))), "{address}: {confirmed:?}");
            assert!(supervisor.state().trust.trusted, "{address}");
            supervisor.handle_link_down(now + Duration::from_secs(1), LinkPhase::Lost, closed());
        }
    }
}

fn closed() -> LinkProblem {
    LinkProblem {
        cause: LinkCause::Closed,
        text: "the other end closed the link".to_owned(),
        remedy: None,
    }
}

fn unreachable() -> LinkProblem {
    LinkProblem {
        cause: LinkCause::Unreachable,
        text: "connection refused".to_owned(),
        remedy: Some("check host and port".to_owned()),
    }
}

/// The notices since the last call that concern the link.
fn link_notices(supervisor: &mut Supervisor) -> Vec<String> {
    iter::from_fn(|| supervisor.poll_notice())
        .filter(|notice| matches!(notice.news, News::LinkLost | News::NoLink { .. }))
        .map(|notice| notice.text)
        .collect()
}

#[test]
fn a_port_that_cannot_be_opened_is_reported_once_with_its_remedy_and_is_not_a_lost_link() {
    let mut supervisor = Supervisor::new(Policy::default(), None);
    for second in 0..20 {
        let now = Duration::from_secs(second);
        supervisor.handle_link_down(now, LinkPhase::Searching, unreachable());
        supervisor.handle_time(now + Duration::from_millis(900));
    }
    assert_eq!(
        link_notices(&mut supervisor),
        ["there is no link to an arm: connection refused; check host and port"]
    );
    let link = supervisor.state().link;
    assert_eq!(link.phase, LinkPhase::Searching);
    assert_eq!(link.cause, Some(LinkCause::Unreachable));
    assert_eq!(link.problem.as_deref(), Some("connection refused"));
    assert_eq!(link.remedy.as_deref(), Some("check host and port"));
}

#[test]
fn each_new_cause_after_a_loss_is_reported_once() {
    let now = Duration::from_secs(1);
    let mut supervisor = Supervisor::new(Policy::default(), None);
    supervisor.handle_link_up(now, "tcp:127.0.0.1:5555");
    supervisor.handle_bytes(now, &status());
    supervisor.handle_link_down(now, LinkPhase::Lost, closed());
    for _ in 0..3 {
        supervisor.handle_link_down(now, LinkPhase::Searching, unreachable());
    }
    let [lost, since] = &link_notices(&mut supervisor)[..] else {
        panic!("two notices");
    };
    assert_eq!(
        lost,
        "the link to the arm was lost: the other end closed the link"
    );
    assert!(
        since.ends_with("connection refused; check host and port"),
        "{since}"
    );
}

#[test]
fn a_port_without_statuses_is_not_a_lost_link_and_its_data_is_described() {
    let mut big_endian = status();
    big_endian[1..41].chunks_mut(4).for_each(<[u8]>::reverse);
    for (bytes, cause, text) in [
        (&[][..], LinkCause::Silent, "nothing was received"),
        (&[7; 90][..], LinkCause::NotAnArm, "90 bytes were received"),
        (
            b"HTTP/1.1 400 Bad Request\r\n",
            LinkCause::NotAnArm,
            "HTTP/1.1 400 Bad Request",
        ),
        (&big_endian[..], LinkCause::BigEndian, "big-endian"),
    ] {
        let mut supervisor = Supervisor::new(Policy::default(), None);
        supervisor.handle_link_up(Duration::ZERO, "serial:/dev/ttyUSB0@9600");
        supervisor.handle_bytes(Duration::from_secs(1), bytes);
        supervisor.handle_time(Duration::from_secs(6));
        let notices = link_notices(&mut supervisor);
        let [notice] = &notices[..] else {
            panic!("{notices:?}");
        };
        assert!(
            notice.starts_with("there is no link to an arm: "),
            "{notice}"
        );
        assert!(notice.contains(text), "{notice}");
        let link = supervisor.state().link;
        assert_eq!(link.cause, Some(cause));
        assert!(link.remedy.is_some());
        let closed_later = Duration::from_secs(7);
        supervisor.handle_link_down(closed_later, LinkPhase::Lost, closed());
        assert!(
            link_notices(&mut supervisor)
                .iter()
                .all(|text| !text.contains("was lost"))
        );
    }
}

#[test]
fn an_arm_that_is_not_found_again_is_reported_with_the_cause_of_the_loss() {
    let now = Duration::from_secs(1);
    let mut supervisor = Supervisor::new(Policy::default(), None);
    let anna = supervisor.handle_client(now, "Anna", Role::Control, "Anna");
    supervisor.handle_link_up(now, "tcp:127.0.0.1:5555");
    supervisor.handle_bytes(now, &status());
    supervisor.handle_link_down(now, LinkPhase::Lost, closed());
    for _ in 0..2 {
        supervisor.handle_link_down(now, LinkPhase::Searching, unreachable());
    }
    let _ = supervisor.handle_request(now, anna, Request::TakeLease);
    let answer = supervisor.handle_request(now, anna, Request::ConfirmPose);
    let text = answer.unwrap().unwrap_err().to_string();
    assert_eq!(
        text,
        "there is no link to an arm: the other end closed the link; since then: connection refused; check host and port"
    );
}

#[test]
fn the_assumed_arm_at_a_port_is_reported() {
    let mut supervisor = Supervisor::new(Policy::default(), None);
    let file = CalibrationFile {
        name: Some("desk 3".to_owned()),
        ..CalibrationFile::default()
    };
    let known = Calibrations::default().replaced_by(Some(file));
    supervisor.handle_known_calibration("serial:/dev/ttyUSB0@9600", &known);
    let found = iter::from_fn(|| supervisor.poll_notice()).any(|notice| {
        notice
            .text
            .contains("the arm at serial:/dev/ttyUSB0@9600 is assumed to be desk 3")
    });
    assert!(found);
}

#[test]
fn big_endian_floats_of_a_client_are_reported() {
    let mut supervisor = Supervisor::new(Policy::default(), Some(Dialect::SPECIFICATION));
    let program = supervisor.handle_client(Duration::ZERO, "program", Role::Control, "program");
    let mut bytes = LASER_OFF.emit(&Dialect::SPECIFICATION).to_bytes();
    bytes[1..41].chunks_mut(4).for_each(<[u8]>::reverse);
    let packet = Packet::from_bytes(&bytes).unwrap();
    assert!(
        supervisor
            .handle_raw(Duration::ZERO, program, &packet)
            .is_err()
    );
    let refused = iter::from_fn(|| supervisor.poll_notice())
        .find(|notice| matches!(notice.news, News::Refused { .. }))
        .unwrap();
    assert!(
        refused.text.contains("the floats are big-endian"),
        "{}",
        refused.text
    );
}
