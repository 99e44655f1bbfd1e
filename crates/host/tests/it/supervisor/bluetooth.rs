//! The Bluetooth port of a stock arm is a link like the others (note N38).

use std::time::Duration;

use dobot_api::{ClientId, News, Reply, Request};
use dobot_controller::{Controller, Personality, Port, PowerUp};
use dobot_host::VirtualStation;
use dobot_safety::Policy;
use dobot_sim::{SerialLine, VirtualArm};
use dobot_wire::{Command, Dialect, JointJog, JointJogAxis, VOICE_HEADER, Voice};

use super::releases::{buttons, check_moved, frame, hold, joint, places, released};
use crate::cases::commands::{target, vector};

/// A station with a stock arm whose Bluetooth port is served, received from its first status on.
fn virtual_station() -> (VirtualStation, ClientId) {
    let power_up = PowerUp::new(Personality::Firmware11).with_port(Port::Bluetooth);
    let arm = VirtualArm::new(Controller::power_up(power_up), SerialLine::STOCK);
    let mut station = VirtualStation::with_arm(arm, power_up, Policy::default());
    station.run_for(Duration::from_secs(1));
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    (station, anna)
}

/// Gives a command and waits until it is over; how long that took.
fn done(station: &mut VirtualStation, client: ClientId, command: Command) -> Duration {
    let Reply::Accepted { command, .. } =
        station.ask(client, Request::Command { command }).unwrap()
    else {
        panic!("it was not taken");
    };
    let begun = station.now();
    let is_done = |station: &VirtualStation| {
        let mut news = station.notices().iter().map(|notice| &notice.news);
        assert!(!news.any(|event| matches!(event, News::CommandFailed { .. })));
        let mut news = station.notices().iter().map(|notice| &notice.news);
        news.any(|event| *event == News::CommandDone { command })
    };
    assert!(station.run_until(begun + Duration::from_secs(20), is_done));
    station.now().saturating_sub(begun)
}

#[test]
fn the_port_is_recognised_and_its_line_is_clean() {
    let (mut station, anna) = virtual_station();
    done(&mut station, anna, target([220.0, 60.0, 10.0]).into());
    station.run_for(Duration::from_secs(3));
    let state = station.supervisor().state();
    assert!(state.link.bluetooth);
    assert_eq!((state.link.lost_statuses, state.link.damaged_bytes), (0, 0));
    // Three in 160 ms.
    let per_s = state.link.statuses_per_s;
    assert!((18.0..19.6).contains(&per_s), "{per_s}");
    let status = state.arm.unwrap().status;
    let at = [status.x_mm, status.y_mm, status.z_mm];
    for (found, wanted) in at.iter().zip([220.0, 60.0, 10.0]) {
        assert!((found - wanted).abs() < 0.05, "{at:?}");
    }
}

#[test]
fn lost_statuses_are_counted_by_the_scheme_of_the_port() {
    let power_up = PowerUp::new(Personality::Firmware11).with_port(Port::Bluetooth);
    let arm = VirtualArm::new(Controller::power_up(power_up), SerialLine::STOCK);
    let arm = arm.with_faults(power_up, &["drop=0.1%:from".parse().unwrap()], 9);
    let mut station = VirtualStation::with_arm(arm, power_up, Policy::default());
    station.run_for(Duration::from_mins(1));
    let counters = station.arm().controller().counters();
    let (link, whole) = (station.supervisor().state().link, counters.statuses);
    // 4.1 % of all packets miss a byte.
    let (least, most) = (whole * 25 / 1000, whole * 60 / 1000);
    let lost = link.lost_statuses;
    assert!((least..most).contains(&lost), "{lost} of {whole}");
}

#[test]
fn every_button_moves_its_own_joint() {
    for jog in buttons() {
        let (mut station, anna) = virtual_station();
        let before = places(&mut station);
        hold(&mut station, anna, jog, 600);
        station.ask(anna, Request::Release).unwrap();
        check_moved(&format!("{jog:?}"), &mut station, jog, before);
    }
}

#[test]
fn a_button_that_is_pressed_with_the_first_status_moves_its_own_joint() {
    for after_ms in (0..400).step_by(20) {
        let power_up = PowerUp::new(Personality::Firmware11).with_port(Port::Bluetooth);
        let mut arm = VirtualArm::new(Controller::power_up(power_up), SerialLine::STOCK);
        // The station connects when the arm has been sending for a while: any of its statuses may
        // be the first.
        arm.handle_time(Duration::from_millis(2000 + after_ms));
        let mut station = VirtualStation::with_arm(arm, power_up, Policy::default());
        let anna = station.client("Anna");
        station.ask(anna, Request::TakeLease).unwrap();
        let jog = joint(JointJogAxis::BasePlus);
        let by = station.now() + Duration::from_secs(5);
        assert!(station.run_until(by, |station| {
            station.supervisor().session().status().is_some()
        }));
        // The supervisor's own laser-off has the first permit.
        while station.ask(anna, Request::Jog { jog }).is_err() {
            station.run_for(Duration::from_millis(20));
        }
        hold(&mut station, anna, jog, 600);
        station.ask(anna, Request::Release).unwrap();
        station.run_for(Duration::from_secs(3));
        let joints = station.arm().mechanics().joints_at(station.now());
        assert!(joints.base.0 > 0.5, "{after_ms} ms: {joints:?}");
        assert!(
            (joints.rear.0 - 45.0).abs() < 0.02,
            "{after_ms} ms: {joints:?}"
        );
    }
}

#[test]
fn the_policy_sees_the_joint_that_moves() {
    let (mut station, anna) = virtual_station();
    // 7.5 degrees a second for 8 s would bring the rear arm from 45 to 105 degrees.
    hold(&mut station, anna, joint(JointJogAxis::RearPlus), 8000);
    station.run_for(Duration::from_secs(3));
    let joints = station.arm().mechanics().joints_at(station.now());
    assert!(joints.base.0.abs() < 0.02, "{joints:?}");
    assert!((60.0..=80.0).contains(&joints.rear.0), "{joints:?}");
    let refused = |news: &News| matches!(news, News::Refused { kind, .. } if kind == "policy");
    assert!(station.notices().iter().any(|notice| refused(&notice.news)));
}

#[test]
fn a_packet_of_a_raw_client_has_its_usual_effect_on_that_port() {
    let (mut station, _) = virtual_station();
    station.run_for(Duration::from_secs(1));
    let raw = station.client("an old program");
    let anna = station.supervisor().state().lease.unwrap().client;
    station.ask(anna, Request::ReleaseLease).unwrap();
    let before = places(&mut station);
    // Axis 1, which is the rear arm there.
    let button = JointJog::new(JointJogAxis::BasePlus, 50.0);
    let packet = Command::from(button).emit(&Dialect::FIRMWARE_1_1);
    let from = station.packets().len();
    for _ in 0..12 {
        station.send_raw(raw, &packet).unwrap();
        station.run_for(Duration::from_millis(50));
    }
    assert!(
        station.packets()[from..]
            .iter()
            .any(|(_, sent)| *sent == packet.to_bytes())
    );
    let release = Command::from(JointJog::new(JointJogAxis::Released, 0.0));
    station
        .send_raw(raw, &release.emit(&Dialect::FIRMWARE_1_1))
        .unwrap();
    check_moved("raw", &mut station, joint(JointJogAxis::RearPlus), before);
    assert!(!released(&station, from).is_empty());
}

#[test]
fn one_command_is_sent_for_each_permit_and_none_for_a_message() {
    let (mut station, anna) = virtual_station();
    let from = station.packets().len();
    for n in 0..8_u8 {
        let by = if n % 2 == 0 { 1.0 } else { -1.0 };
        let command = vector([0.0, by, 0.0], false);
        station.ask(anna, Request::Command { command }).unwrap();
    }
    station.run_for(Duration::from_secs(6));
    let vectors: Vec<_> = station.packets()[from..]
        .iter()
        .filter(|(_, bytes)| frame(bytes).float(1) == 4.0)
        .map(|packet| packet.0)
        .collect();
    assert_eq!(vectors.len(), 8);
    // The first one used a permit that had come before, the line was busy with another packet, and a
    // stock arm wants a gap between two.
    for pair in vectors[2..].windows(2) {
        let apart = pair[1].saturating_sub(pair[0]);
        assert!(apart >= Duration::from_millis(155), "{apart:?}");
    }
    let refused = std::iter::from_fn(|| station.arm_mut().poll_refused()).count();
    assert_eq!(refused, 0);
}

#[test]
fn a_voice_command_becomes_the_motion_that_its_words_mean() {
    let (mut station, anna) = virtual_station();
    let aside = target([220.0, 40.0, 0.0]);
    station
        .ask(
            anna,
            Request::Command {
                command: aside.into(),
            },
        )
        .unwrap();
    let from = station.packets().len();
    // A stock arm hears 22 for sixteen, and 101 for one hundred two; while it moves it hangs on any text.
    for (text, to) in [
        ("back sixteen", [204.0, 40.0, 0.0]),
        ("Up Ten", [204.0, 40.0, 10.0]),
        ("right one hundred two", [204.0, -62.0, 10.0]),
    ] {
        let voice = Voice::new(text).unwrap();
        done(&mut station, anna, Command::Voice(voice));
        station.run_for(Duration::from_secs(3));
        let at = station.arm().controller().pose_at(station.now()).position;
        for (found, wanted) in [at.x.0, at.y.0, at.z.0].into_iter().zip(to) {
            assert!((found - wanted).abs() < 0.1, "{text}: {at:?}");
        }
    }
    for text in ["hello", "up", ""] {
        let command = Voice::new(text).unwrap().into();
        let refused = station.ask(anna, Request::Command { command });
        assert!(refused.is_err(), "{text}");
    }
    let voice = |(_, bytes): &&(Duration, [u8; 42])| bytes[0] == VOICE_HEADER;
    assert_eq!(station.packets()[from..].iter().filter(voice).count(), 0);
    // And it obeys packets again.
    done(&mut station, anna, target([220.0, -40.0, 0.0]).into());
    let at = station.arm().controller().pose_at(station.now()).position;
    assert!((at.y.0 + 40.0).abs() < 0.1, "{at:?}");
}

#[test]
fn a_joint_jog_reports_its_joint_and_not_its_axis() {
    let (mut station, anna) = virtual_station();
    let from = station.packets().len();
    hold(&mut station, anna, joint(JointJogAxis::ForePlus), 300);
    station.ask(anna, Request::Release).unwrap();
    let sent = station.packets()[from..]
        .iter()
        .map(|(_, bytes)| frame(bytes));
    let axes: Vec<f32> = sent
        .filter(|frame| frame.float(1) == 2.0)
        .map(|frame| frame.float(2))
        .collect();
    assert!(axes.contains(&6.0) && !axes.contains(&5.0), "{axes:?}");
}
