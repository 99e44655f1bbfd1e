//! Programs from 2016 at the raw port: what the arm gets of what they send.

use std::time::Duration;

use dobot_controller::Personality;
use dobot_station::{ClientId, News, Rehearsal};
use dobot_wire::Frame;

use crate::drawing::rehearsal;
use crate::releases::frame;

fn packet(floats: &[f32]) -> Frame {
    let floats = (1..).zip(floats);
    floats.fold(Frame::ZERO, |frame, (n, value)| frame.with(n, *value))
}

/// What the arm got of what a program sends, one packet for each status.
fn got(it: &mut Rehearsal, program: ClientId, packets: &[&[f32]]) -> Vec<Frame> {
    let before = it.packets().len();
    for floats in packets {
        it.send_raw(program, &packet(floats).into()).unwrap();
        it.run_for(Duration::from_millis(100));
    }
    let sent = it.packets()[before..].iter();
    sent.map(|(_, bytes)| frame(bytes)).collect()
}

#[test]
fn the_start_of_a_program_of_the_pydobot_family_keeps_its_jump_height_and_is_told_what_was_changed()
{
    let mut it = rehearsal(Personality::Firmware11);
    let program = it.client("a raw program");
    let start: [&[f32]; 2] = [
        &[
            9.0, 1.0, 200.0, 200.0, 200.0, 200.0, 800.0, 1000.0, 0.0, 50.0,
        ],
        &[10.0, 0.0, 100.0, 100.0, 0.0],
    ];
    let sent = got(&mut it, program, &start);
    assert_eq!(sent.len(), 2, "{sent:?}");
    assert_eq!(sent[0].float(10), 50.0, "the height of a JUMP");
    assert_eq!(sent[0].float(3), 200.0);
    assert_eq!(sent[1].float(5), 100.0, "what is in force");
    // What comes of both is the policy's ceiling.
    let policy = it.keeper().policy();
    let line_mm_s = f64::from(sent[0].float(7)) * f64::from(sent[1].float(3)) / 100.0;
    assert!(
        line_mm_s <= policy.speed.line_mm_s * 1.000_001,
        "{line_mm_s}"
    );
    let amended = |news: &News| matches!(news, News::Amended { .. });
    let told = it.notices().iter().filter(|it| amended(&it.news)).count();
    assert_eq!(told, 2);
    // The same again is not told again.
    got(&mut it, program, &start[1..]);
    got(&mut it, program, &start[1..]);
    let told = it.notices().iter().filter(|it| amended(&it.news)).count();
    assert_eq!(told, 2);
}

#[test]
fn a_setting_above_its_ceiling_is_sent_as_the_ceiling_and_the_rest_as_it_is() {
    let mut it = rehearsal(Personality::Firmware11);
    let program = it.client("a raw program");
    for n in 3..=8 {
        let mut floats = [9.0, 1.0, 50.0, 50.0, 50.0, 50.0, 50.0, 50.0, 0.0, 20.0];
        floats[n - 1] = 1e30;
        let sent = got(&mut it, program, &[&floats]);
        let [sent] = sent[..] else {
            panic!("{sent:?}");
        };
        assert!((50.0..1e5).contains(&sent.float(n)), "{n}: {sent:?}");
        let others = (1..=10).filter(|it| *it != n);
        for other in others {
            assert_eq!(sent.float(other), floats[other - 1], "{n}");
        }
    }
    let sent = got(&mut it, program, &[&[9.0, 2.0, 1e30]]);
    assert!(sent[0].float(3) < 1e5, "{sent:?}");
    it.send_raw(program, &packet(&[9.0, 2.0, f32::INFINITY]).into())
        .unwrap_err();
}

#[test]
fn the_sliders_of_the_vendors_client_and_its_demo_for_arduino_act() {
    for personality in Personality::ALL {
        let mut it = rehearsal(personality);
        let program = it.client("a raw program");
        let sent = got(
            &mut it,
            program,
            &[&[10.0, 0.0, 58.0, 38.0, 0.0], &[9.0, 0.0, 50.0, 100.0]],
        );
        assert_eq!(sent.len(), 2, "{personality}: {sent:?}");
        assert_eq!([sent[0].float(3), sent[0].float(4)], [58.0, 38.0]);
        assert_eq!([sent[1].float(3), sent[1].float(4)], [50.0, 100.0]);
        assert!((5..=8).all(|n| sent[1].float(n) > 0.0), "{personality}");
    }
}
