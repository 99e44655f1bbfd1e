//! Programs from 2016 at the raw port: what the arm gets of what they send.

mod played;
mod recorded;

use std::time::Duration;

use dobot_api::{ClientId, News};
use dobot_controller::Personality;
use dobot_host::VirtualStation;
use dobot_wire::{Command, Dialect, Frame, JointJog, LinearJog};

use self::played::{Look, Seen, Served, at_a_bare_arm, at_a_station, is_trapped_by};
use self::recorded::{Program, names, program};
use super::drawing::virtual_station;
use super::releases::frame;

fn packet(floats: &[f32]) -> Frame {
    let floats = (1..).zip(floats);
    floats.fold(Frame::ZERO, |frame, (n, value)| frame.with(n, *value))
}

/// Returns what the arm got of a program's packets, one packet for each status.
fn got(station: &mut VirtualStation, program: ClientId, packets: &[&[f32]]) -> Vec<Frame> {
    let before = station.packets().len();
    for floats in packets {
        station.send_raw(program, &packet(floats).into()).unwrap();
        station.run_for(Duration::from_millis(100));
    }
    let sent = station.packets()[before..].iter();
    sent.map(|(_, bytes)| frame(bytes)).collect()
}

#[test]
fn a_program_of_the_pydobot_family_keeps_its_jump_height_and_learns_what_was_changed() {
    let mut station = virtual_station(Personality::Firmware11);
    let program = station.client("a raw program");
    let start: [&[f32]; 2] = [
        &[
            9.0, 1.0, 200.0, 200.0, 200.0, 200.0, 800.0, 1000.0, 0.0, 50.0,
        ],
        &[10.0, 0.0, 100.0, 100.0, 0.0],
    ];
    let sent = got(&mut station, program, &start);
    assert_eq!(sent.len(), 2, "{sent:?}");
    assert_eq!(sent[0].float(10), 50.0, "the height of a JUMP");
    assert_eq!(sent[0].float(3), 200.0);
    assert_eq!(sent[1].float(5), 100.0, "the value in force");
    // The result of both is the policy's ceiling.
    let policy = station.supervisor().policy();
    let line_mm_s = f64::from(sent[0].float(7)) * f64::from(sent[1].float(3)) / 100.0;
    assert!(
        line_mm_s <= policy.speed.line_mm_s * 1.000_001,
        "{line_mm_s}"
    );
    let amended = |news: &News| matches!(news, News::Amended { .. });
    let notices = station
        .notices()
        .iter()
        .filter(|notice| amended(&notice.news))
        .count();
    assert_eq!(notices, 2);
    // A repetition is not reported again.
    got(&mut station, program, &start[1..]);
    got(&mut station, program, &start[1..]);
    let notices = station
        .notices()
        .iter()
        .filter(|notice| amended(&notice.news))
        .count();
    assert_eq!(notices, 2);
}

#[test]
fn a_setting_above_its_ceiling_is_sent_as_the_ceiling_and_the_rest_is_unchanged() {
    let mut station = virtual_station(Personality::Firmware11);
    let program = station.client("a raw program");
    for n in 3..=8 {
        let mut floats = [9.0, 1.0, 50.0, 50.0, 50.0, 50.0, 50.0, 50.0, 0.0, 20.0];
        floats[n - 1] = 1e30;
        let sent = got(&mut station, program, &[&floats]);
        let [sent] = sent[..] else {
            panic!("{sent:?}");
        };
        assert!((50.0..1e5).contains(&sent.float(n)), "{n}: {sent:?}");
        let others = (1..=10).filter(|other| *other != n);
        for other in others {
            assert_eq!(sent.float(other), floats[other - 1], "{n}");
        }
    }
    let sent = got(&mut station, program, &[&[9.0, 2.0, 1e30]]);
    assert!(sent[0].float(3) < 1e5, "{sent:?}");
    station
        .send_raw(program, &packet(&[9.0, 2.0, f32::INFINITY]).into())
        .unwrap_err();
}

#[test]
fn the_sliders_of_the_vendors_client_and_its_demo_for_arduino_take_effect() {
    for personality in Personality::ALL {
        let mut station = virtual_station(personality);
        let program = station.client("a raw program");
        let sent = got(
            &mut station,
            program,
            &[&[10.0, 0.0, 58.0, 38.0, 0.0], &[9.0, 0.0, 50.0, 100.0]],
        );
        assert_eq!(sent.len(), 2, "{personality}: {sent:?}");
        assert_eq!([sent[0].float(3), sent[0].float(4)], [58.0, 38.0]);
        assert_eq!([sent[1].float(3), sent[1].float(4)], [50.0, 100.0]);
        assert!((5..=8).all(|n| sent[1].float(n) > 0.0), "{personality}");
    }
}

#[test]
fn the_default_pause_of_the_vendors_client_is_reported_when_it_begins() {
    let mut station = virtual_station(Personality::Specification);
    let program = station.client("a raw program");
    let start = [
        9.0, 1.0, 200.0, 200.0, 200.0, 200.0, 200.0, 200.0, 100.0, 20.0,
    ];
    let point = [6.0, 0.0, 9.0, 45.0, 45.0, 0.0, 0.0, 1.0];
    got(&mut station, program, &[&start, &point]);
    station.run_for(Duration::from_secs(5));
    let pauses = |news: &News| matches!(news, News::Pausing { lasts_s: 100.0, .. });
    let pause = station.notices().iter().find(|notice| pauses(&notice.news));
    let text = "the arm waits 100 s here: its default pause (state 9, mode 1)";
    assert_eq!(pause.map(|notice| notice.text.as_str()), Some(text));
}

/// Plays a program on a bare arm and at a station: they come to rest at the same positions with the
/// same tools, apart from refused packets; and every refusal and change was reported.
fn check(name: &str) {
    let program = program(name);
    let what = format!("{}: {}", program.name, program.does);
    let (bare, lost) = at_a_bare_arm(&program);
    assert_eq!(lost, [], "{what}: a bare arm does all of it");
    let served = at_a_station(&program);
    check_reports(&what, &program, &served);
    check_packets(&what, &program, &served.got);
    let places = |seen: &Seen| {
        if program.looks_ms.is_empty() {
            seen.rests.clone()
        } else {
            seen.looks.clone()
        }
    };
    let (wanted, found) = (places(&bare), places(&served.seen));
    let is_same = |(one, other): (&Look, &Look)| one.is_near(other, program.within);
    assert!(
        wanted.len() == found.len() && wanted.iter().zip(&found).all(is_same),
        "{what}\na bare arm is at\n{wanted:#?}\nthrough the station it is at\n{found:#?}\n{:?} off are allowed",
        program.within,
    );
}

/// Checks that each packet was accepted, changed or refused as the data states, and that nothing
/// else was reported.
fn check_reports(what: &str, program: &Program, served: &Served) {
    assert_eq!(served.reports.len(), program.packets.len(), "{what}");
    for (packet, (is_refused, texts)) in program.packets.iter().zip(&served.reports) {
        assert_eq!(
            *is_refused,
            packet.refused.is_some(),
            "{what}: {packet:?}: {:#?}",
            served.troubles
        );
        let reason = packet.refused.as_ref().or(packet.notice.as_ref());
        match reason {
            None => assert!(texts.is_empty(), "{what}: {packet:?}: {texts:?}"),
            Some(reason) => {
                // A repetition is not reported again.
                let mut reported = served.troubles.iter();
                assert!(
                    reported.any(|text| text.contains(reason)),
                    "{what}: {packet:?}: {texts:?}"
                );
            }
        }
        if packet.traps {
            assert!(is_trapped_by(program, packet), "{what}: {packet:?}");
        }
    }
    let at_once: usize = served.reports.iter().map(|(_, texts)| texts.len()).sum();
    assert_eq!(
        at_once,
        served.troubles.len(),
        "{what}: {:#?}",
        served.troubles
    );
    for text in served
        .troubles
        .iter()
        .filter(|trouble| trouble.starts_with("refused"))
    {
        let is_named = |remedy: &&str| text.contains(*remedy);
        assert!(REMEDIES.iter().any(is_named), "{what}: {text}");
    }
}

/// Checks that the arm got what the data states, in order. A repeated held button, a repeated
/// release or one of the other kind, and laser off are up to the station.
fn check_packets(what: &str, program: &Program, got: &[Frame]) {
    let dialect = Dialect::FIRMWARE_1_1;
    let read = |frame: &Frame| Command::parse(&(*frame).into(), &dialect).unwrap();
    let wanted = program
        .packets
        .iter()
        .filter_map(recorded::RecordedPacket::sent);
    let wanted: Vec<Command> = wanted.map(|command| read(&command)).collect();
    let got: Vec<Command> = got.iter().map(read).collect();
    assert_eq!(
        bare_of_the_stations_own(&got),
        bare_of_the_stations_own(&wanted),
        "{what}"
    );
}

fn bare_of_the_stations_own(commands: &[Command]) -> Vec<Command> {
    let mut kept = Vec::new();
    let mut last = None;
    for command in commands {
        let switch = match *command {
            Command::JointJog(JointJog { axis, .. }) => Some(axis as u8),
            Command::LinearJog(LinearJog { axis, .. }) => Some(axis as u8),
            _ => None,
        };
        match switch {
            Some(0) => last = None,
            Some(14) => {}
            Some(_) if last == Some(*command) => {}
            _ => {
                kept.push(*command);
                last = Some(*command);
            }
        }
    }
    kept
}

/// The remedies in refusals.
const REMEDIES: [&str; 3] = ["; send an allowed packet", "; use a JUMP", "`dobot "];

#[test]
fn every_program_in_the_vectors_has_a_test() {
    let source = include_str!("programs.rs");
    for name in names() {
        assert!(source.contains(&format!("check(\"{name}\")")), "{name}");
    }
}

#[test]
fn the_vendors_client_jogs_and_grips_as_on_a_bare_arm() {
    check("vendor_client_buttons");
}

#[test]
fn presses_of_the_vendors_client_in_quick_succession_all_take_effect() {
    check("vendor_client_quick_presses");
}

#[test]
fn the_vendors_client_plays_back_as_on_a_bare_arm() {
    check("vendor_client_playback");
}

#[test]
fn the_first_start_of_the_vendors_client_is_as_on_a_bare_arm() {
    check("vendor_client_first_start");
}

#[test]
fn the_vendors_demo_for_arduino_swings_as_far_as_on_a_bare_arm() {
    check("arduino_demo");
}

#[test]
fn programs_of_the_pydobot_family_go_back_and_forth_as_on_a_bare_arm() {
    check("pydobot");
}

#[test]
fn a_held_key_goes_as_far_as_on_a_bare_arm() {
    check("pydobot_keyboard");
}

#[test]
fn a_target_out_of_reach_is_refused_and_the_rest_is_as_on_a_bare_arm() {
    check("pydobot_out_of_reach");
}

#[test]
fn programs_with_a_pump_grip_as_on_a_bare_arm() {
    check("pydobot_suction");
}

#[test]
fn jumps_sent_all_at_once_are_as_high_and_as_many_as_on_a_bare_arm() {
    check("pydobot_jumps");
}

#[test]
fn the_first_packet_of_node_goose_is_corrected_and_the_rest_is_as_on_a_bare_arm() {
    check("node_goose");
}

#[test]
fn node_dobot_makes_its_only_move() {
    check("node_dobot");
}

#[test]
fn a_client_in_c_sharp_moves_as_on_a_bare_arm_and_leaves_the_pump_unchanged() {
    check("csharp_client");
}

#[test]
fn jogs_at_any_percentage_are_as_on_a_bare_arm() {
    check("jog_percentages");
}

#[test]
fn matlab_functions_of_a_course_go_where_a_bare_arm_goes() {
    check("matlab_course");
}

#[test]
fn a_card_press_grips_and_releases_as_on_a_bare_arm() {
    check("card_press");
}

#[test]
fn a_client_in_c_sharp_writes_as_on_a_bare_arm() {
    check("csharp_writer");
}

#[test]
fn big_endian_packets_are_refused_with_the_reason_and_the_corrected_ones_take_effect() {
    check("python_big_endian");
}
