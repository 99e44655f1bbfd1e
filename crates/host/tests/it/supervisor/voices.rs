//! Voice orders to an arm without voice recognition are carried out anyway (note N50).

use std::time::Duration;

use dobot_api::{ClientId, News, Request};
use dobot_controller::Personality;
use dobot_host::VirtualStation;
use dobot_supervisor::Refusal;
use dobot_wire::{Command, MoveTo, MovingMode, Packet, Voice};

use super::drawing::virtual_station;
use crate::cases::commands::target;

const PERSONALITIES: [Personality; 2] = Personality::ALL;

fn lab(personality: Personality) -> (VirtualStation, ClientId) {
    let mut station = virtual_station(personality);
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    let start = MoveTo {
        mode: MovingMode::MovJ,
        ..target([210.0, 10.0, 0.0])
    };
    station
        .ask(
            anna,
            Request::Command {
                command: start.into(),
            },
        )
        .unwrap();
    station.run_for(Duration::from_secs(5));
    (station, anna)
}

fn voice(text: &str) -> Command {
    Voice::new(text).unwrap().into()
}

fn send(
    station: &mut VirtualStation,
    client: ClientId,
    raw: bool,
    text: &str,
) -> Result<(), Refusal> {
    let command = voice(text);
    if raw {
        let packet = command.emit(&station.supervisor().dialect().unwrap());
        return station.send_raw(client, &packet);
    }
    station.ask(client, Request::Command { command }).map(drop)
}

fn place(station: &VirtualStation) -> [f32; 3] {
    let status = station.supervisor().state().arm.unwrap().status;
    [status.x_mm, status.y_mm, status.z_mm]
}

#[test]
fn an_arm_obeys_the_words_with_and_without_voice_support() {
    for personality in PERSONALITIES {
        for raw in [false, true] {
            let (mut station, anna) = lab(personality);
            for (text, to) in [
                ("left twenty five", [210.0, 35.0, 0.0]),
                ("up ten", [210.0, 35.0, 10.0]),
                ("Back sixty", [150.0, 35.0, 10.0]),
            ] {
                send(&mut station, anna, raw, text).unwrap();
                station.run_for(Duration::from_secs(5));
                let found = place(&station);
                let off: f32 = found.iter().zip(to).map(|(a, b)| (a - b).abs()).sum();
                assert!(off < 0.01, "{personality}, {text}: {found:?}, not {to:?}");
            }
            for (text, on) in [("catch it", true), ("release", false)] {
                send(&mut station, anna, raw, text).unwrap();
                station.run_for(Duration::from_secs(1));
                assert_eq!(
                    station.arm().controller().suction(),
                    on,
                    "{personality}, {text}"
                );
            }
        }
    }
}

#[test]
fn a_stock_arm_gets_no_voice_packet_over_usb_and_the_pump_stays_on_during_the_motion() {
    let (mut station, anna) = lab(Personality::Firmware11);
    send(&mut station, anna, false, "catch").unwrap();
    send(&mut station, anna, false, "ahead five").unwrap();
    station.run_for(Duration::from_secs(3));
    assert!(station.arm().controller().suction());
    let is_voice = |bytes: &[u8; 42]| matches!(Packet::from_bytes(bytes), Some(Packet::Voice(_)));
    assert!(!station.packets().iter().any(|(_, bytes)| is_voice(bytes)));
    let done = |notice: &&dobot_api::Notice| matches!(notice.news, News::CommandDone { .. });
    assert_eq!(station.notices().iter().filter(done).count(), 3);
}

#[test]
fn a_voice_command_is_judged_as_the_motion_that_it_means() {
    let (mut station, anna) = lab(Personality::Firmware11);
    for (text, why) in [
        ("down seventy", "table allows"),
        ("hello", "allowed are ahead, back"),
        ("up", "allowed are ahead, back"),
    ] {
        let refusal = send(&mut station, anna, true, text)
            .unwrap_err()
            .to_string();
        assert!(refusal.contains(why), "{text}: {refusal}");
    }
}

#[test]
fn no_voice_packet_is_sent_to_a_moving_arm_with_voice_support() {
    let (mut station, anna) = lab(Personality::Specification);
    send(&mut station, anna, false, "left twenty").unwrap();
    station.run_for(Duration::from_millis(300));
    let refusal = send(&mut station, anna, false, "right twenty").unwrap_err();
    assert!(matches!(refusal, Refusal::StillMoving { .. }), "{refusal}");
}
