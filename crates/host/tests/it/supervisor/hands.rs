//! A hand on a button: presses, releases and reversals as people make them, on the packets that the
//! arm got.

use std::time::Duration;

use dobot_api::{ClientId, Jog, News, Request};
use dobot_controller::Personality;
use dobot_host::VirtualStation;
use dobot_motion::{Button, JogAxis};
use dobot_supervisor::Refusal;
use dobot_wire::{Command, JointJogAxis, LinearJogAxis, Packet};

use super::releases::{buttons, joint, linear, over};
use crate::cases::chance::Chance;

const BEAT: Duration = Duration::from_millis(50);
const PLUS: LinearJogAxis = LinearJogAxis::YPlus;
const MINUS: LinearJogAxis = LinearJogAxis::YMinus;

fn at_hand(personality: Personality) -> (VirtualStation, ClientId) {
    over(personality, 0)
}

/// Holds a button as a page does, and takes no refusal.
fn hold(station: &mut VirtualStation, client: ClientId, jog: Jog, time: Duration) {
    let until = station.now() + time;
    while station.now() < until {
        station.ask(client, Request::Jog { jog }).unwrap();
        station.run_for(BEAT);
    }
}

/// Returns the button packets sent to the arm, from a packet on: the axis that moves and its share,
/// or `None` for a release.
fn pressed(station: &VirtualStation, from: usize) -> Vec<(Duration, Option<(JogAxis, f64)>)> {
    let dialect = *station
        .supervisor()
        .session()
        .dialect()
        .expect("it is known");
    let packets = station.packets()[from..].iter();
    packets
        .filter_map(|(at, bytes)| {
            let command = Command::parse(&Packet::from_bytes(bytes)?, &dialect).ok()?;
            match Button::of(&command)? {
                Button::Held { axis, share } => Some((*at, Some((axis, share)))),
                Button::Released => Some((*at, None)),
                Button::Suction(_) | Button::Laser(_) => None,
            }
        })
        .collect()
}

fn y_mm(station: &VirtualStation) -> f32 {
    station
        .supervisor()
        .state()
        .arm
        .expect("the arm reports its state")
        .status
        .y_mm
}

fn refusals(station: &VirtualStation) -> usize {
    let refused = |news: &News| matches!(news, News::Refused { .. });
    station
        .notices()
        .iter()
        .filter(|notice| refused(&notice.news))
        .count()
}

#[test]
fn a_press_while_the_arm_coasts_takes_effect_at_rest_if_it_is_still_held() {
    for personality in Personality::ALL {
        let (mut station, anna) = at_hand(personality);
        hold(&mut station, anna, linear(PLUS), Duration::from_secs(1));
        station.ask(anna, Request::Release).unwrap();
        station.run_for(BEAT);
        let before = station.packets().len();
        hold(&mut station, anna, linear(PLUS), Duration::from_secs(2));
        let packets = pressed(&station, before);
        let acts = packets.iter().position(|(_, button)| button.is_some());
        let acts = acts.unwrap_or_else(|| panic!("{personality}: {packets:?}"));
        assert!(
            packets[acts..].iter().all(|(_, button)| button.is_some()),
            "{personality}: it is not released: {packets:?}"
        );
        assert_eq!(refusals(&station), 0, "{personality}");
    }
}

/// The notices of presses that were never sent to the arm.
fn lost_presses(station: &VirtualStation) -> usize {
    let is_lost = |text: &str| text.contains("before the press was sent, so nothing moved");
    station
        .notices()
        .iter()
        .filter(|notice| is_lost(&notice.text))
        .count()
}

#[test]
fn a_tap_is_sent_or_reported_at_any_time() {
    for personality in Personality::ALL {
        for (after_ms, tap_ms) in (0..1200)
            .step_by(37)
            .flat_map(|after| [5, 20, 45, 90, 160].map(|tap| (after, tap)))
        {
            let (mut station, anna) = at_hand(personality);
            hold(&mut station, anna, joint(JointJogAxis::BasePlus), BEAT * 8);
            station.ask(anna, Request::Release).unwrap();
            station.run_for(Duration::from_millis(after_ms));
            let before = station.packets().len();
            let jog = joint(JointJogAxis::RearPlus);
            station.ask(anna, Request::Jog { jog }).unwrap();
            station.run_for(Duration::from_millis(tap_ms.min(140)));
            station.ask(anna, Request::Jog { jog }).unwrap();
            station.run_for(Duration::from_millis(tap_ms.saturating_sub(140)));
            station.ask(anna, Request::Release).unwrap();
            station.run_for(Duration::from_secs(2));
            let packets = pressed(&station, before);
            let sent = packets.iter().any(|(_, button)| button.is_some());
            let what = format!("{personality}, {tap_ms} ms, after {after_ms} ms: {packets:?}");
            assert_ne!(sent, lost_presses(&station) == 1, "{what}");
            let last = packets.last();
            assert!(last.is_none_or(|(_, button)| button.is_none()), "{what}");
        }
    }
}

#[test]
fn a_press_whose_client_goes_silent_before_the_arm_is_at_rest_is_reported() {
    for personality in Personality::ALL {
        let (mut station, anna) = at_hand(personality);
        hold(&mut station, anna, linear(PLUS), Duration::from_secs(1));
        station.ask(anna, Request::Release).unwrap();
        station.run_for(BEAT);
        let jog = joint(JointJogAxis::RearPlus);
        station.ask(anna, Request::Jog { jog }).unwrap();
        station.run_for(Duration::from_secs(3));
        assert_eq!(lost_presses(&station), 1, "{personality}");
    }
}

#[test]
fn a_press_released_before_the_arm_is_at_rest_moves_nothing_and_is_reported() {
    for personality in Personality::ALL {
        let (mut station, anna) = at_hand(personality);
        hold(&mut station, anna, linear(PLUS), Duration::from_secs(1));
        station.ask(anna, Request::Release).unwrap();
        let before = station.packets().len();
        hold(&mut station, anna, linear(PLUS), Duration::from_millis(100));
        station.ask(anna, Request::Release).unwrap();
        station.run_for(Duration::from_secs(3));
        assert_eq!(lost_presses(&station), 1, "{personality}");
        let packets = pressed(&station, before);
        assert!(
            packets.iter().all(|(_, button)| button.is_none()),
            "{personality}: {packets:?}"
        );
    }
}

#[test]
fn a_reversal_is_accepted_with_and_without_a_release_in_between() {
    for personality in Personality::ALL {
        for lets_go in [true, false] {
            let (mut station, anna) = at_hand(personality);
            hold(&mut station, anna, linear(PLUS), Duration::from_millis(800));
            if lets_go {
                station.ask(anna, Request::Release).unwrap();
                station.run_for(BEAT);
            }
            let far = y_mm(&station);
            let before = station.packets().len();
            hold(
                &mut station,
                anna,
                linear(MINUS),
                Duration::from_millis(2500),
            );
            station.ask(anna, Request::Release).unwrap();
            station.run_for(Duration::from_secs(2));
            assert!(
                y_mm(&station) < far - 10.0,
                "{personality}: {} mm",
                y_mm(&station)
            );
            assert_eq!(refusals(&station), 0, "{personality}");
            // From plus to minus only through a release of the same kind: see `releases`.
            let packets = pressed(&station, before);
            let acts = packets
                .iter()
                .position(|(_, button)| button.is_some())
                .unwrap();
            assert!(
                lets_go || packets[..acts].iter().any(|(_, button)| button.is_none()),
                "{personality}: {packets:?}"
            );
        }
    }
}

#[test]
fn after_a_dead_man_timeout_a_new_press_is_needed() {
    for personality in Personality::ALL {
        let (mut station, anna) = at_hand(personality);
        hold(&mut station, anna, linear(PLUS), Duration::from_millis(500));
        station.run_for(Duration::from_millis(2500));
        let before = station.packets().len();
        let jog = linear(PLUS);
        for _ in 0..20 {
            let refusal = station.ask(anna, Request::Jog { jog }).unwrap_err();
            assert!(matches!(refusal, Refusal::LetGo(_)), "{refusal}");
            station.run_for(BEAT);
        }
        let packets = pressed(&station, before);
        assert!(
            packets.iter().all(|(_, button)| button.is_none()),
            "{personality}: {packets:?}"
        );
        assert_eq!(refusals(&station), 1, "{personality}: it is reported once");
        station.ask(anna, Request::Release).unwrap();
        hold(&mut station, anna, jog, Duration::from_millis(500));
        assert!(
            pressed(&station, before)
                .iter()
                .any(|(_, button)| button.is_some())
        );
    }
}

#[test]
fn at_a_limit_the_button_is_released_once_and_the_limit_stays_the_reason() {
    for personality in Personality::ALL {
        let (mut station, anna) = at_hand(personality);
        let jog = linear(LinearJogAxis::ZMinus);
        let mut reasons = Vec::new();
        for _ in 0..400 {
            reasons.extend(station.ask(anna, Request::Jog { jog }).err());
            station.run_for(BEAT);
        }
        assert!(reasons.len() > 20, "{personality}");
        for reason in &reasons {
            assert!(
                matches!(reason, Refusal::Policy(_)),
                "{personality}: {reason}"
            );
        }
        assert_eq!(refusals(&station), 1, "{personality}: it is reported once");
        let packets = pressed(&station, 0);
        let released = packets
            .iter()
            .position(|(_, button)| button.is_none())
            .unwrap();
        assert!(
            packets[released..]
                .iter()
                .all(|(_, button)| button.is_none()),
            "{personality}: it does not start again: {packets:?}"
        );
    }
}

#[test]
fn a_button_held_through_a_stop_does_not_move_the_arm_after_the_reset() {
    for personality in Personality::ALL {
        let (mut station, anna) = at_hand(personality);
        let ben = station.client("Ben");
        hold(&mut station, anna, linear(PLUS), Duration::from_millis(500));
        station.ask(ben, Request::Stop { reason: None }).unwrap();
        let before = station.packets().len();
        let jog = linear(PLUS);
        for beat in 0..100 {
            assert!(
                station.ask(anna, Request::Jog { jog }).is_err(),
                "{personality}"
            );
            if beat == 80 {
                station.ask(ben, Request::ResetStop).unwrap();
            }
            station.run_for(BEAT);
        }
        let packets = pressed(&station, before);
        assert!(
            packets.iter().all(|(_, button)| button.is_none()),
            "{personality}: {packets:?}"
        );
    }
}

#[test]
fn a_press_during_a_long_move_is_refused_and_has_no_effect_after_it() {
    let (mut station, anna) = at_hand(Personality::Firmware11);
    let command = crate::cases::commands::target([230.0, 100.0, 20.0]).into();
    station.ask(anna, Request::Command { command }).unwrap();
    let command = crate::cases::commands::target([230.0, -100.0, 20.0]).into();
    station.ask(anna, Request::Command { command }).unwrap();
    let jog = linear(PLUS);
    let refusal = station.ask(anna, Request::Jog { jog }).unwrap_err();
    assert!(matches!(refusal, Refusal::StillMoving { .. }), "{refusal}");
    for _ in 0..400 {
        let again = station.ask(anna, Request::Jog { jog });
        assert!(again.is_err());
        station.run_for(BEAT);
    }
    assert!(
        pressed(&station, 0)
            .iter()
            .all(|(_, button)| button.is_none())
    );
}

#[test]
fn a_press_by_a_raw_client_while_the_arm_coasts_takes_effect() {
    for personality in Personality::ALL {
        let (mut station, anna) = at_hand(personality);
        station.leave(anna);
        let program = station.client("a raw program");
        let dialect = personality.dialect();
        let send = |station: &mut VirtualStation, jog: Jog| {
            station.send_raw(program, &jog.command().emit(&dialect))
        };
        let release = linear(LinearJogAxis::Released);
        send(&mut station, linear(PLUS)).unwrap();
        station.run_for(Duration::from_millis(500));
        send(&mut station, release).unwrap();
        station.run_for(Duration::from_millis(100));
        // Like the vendor's client: sent immediately, and again after half a second.
        send(&mut station, joint(JointJogAxis::RearPlus)).unwrap();
        let before = station.packets().len();
        station.run_for(Duration::from_millis(500));
        send(&mut station, joint(JointJogAxis::RearPlus)).unwrap();
        station.run_for(Duration::from_millis(500));
        let packets = pressed(&station, before);
        let acts = |button: &(Duration, Option<(JogAxis, f64)>)| {
            button.1.is_some_and(|(axis, _)| axis == JogAxis::Rear)
        };
        assert!(packets.iter().any(acts), "{personality}: {packets:?}");
        assert_eq!(refusals(&station), 0, "{personality}");
    }
}

/// A person's next action and its duration.
#[derive(Clone, Copy, Debug)]
enum Hand {
    Holds(Jog),
    Rests,
    /// The finger is on the button, but its client is busy.
    Sleeps,
}

#[test]
fn random_presses_never_cause_unrequested_motion_and_no_long_press_is_lost() {
    let all = buttons();
    let mut acted = 0;
    for seed in 0..200 {
        // Seeds that follow one another would give the same numbers, one later.
        let mut chance = Chance::new(Chance::new(seed).number());
        let personality = Personality::ALL[usize::from(seed % 4 != 0)];
        let (mut station, anna) = over(
            personality,
            [0, 20, 50, 100, 200][usize::try_from(seed % 5).unwrap()],
        );
        let mut holds: Option<Jog> = None;
        let mut from = station.packets().len();
        for _ in 0..50 {
            let hand = match chance.below(5) {
                0 => Hand::Rests,
                1 => Hand::Sleeps,
                // To and fro around the middle, with one neighbour in four.
                n => Hand::Holds(
                    all[usize::try_from(chance.below(if n == 2 { 16 } else { 2 })).unwrap()],
                ),
            };
            let lasts = chance.below(8) == 0;
            let time = Duration::from_millis(30 + if lasts { 3000 } else { chance.below(900) });
            let until = station.now() + time;
            let begun = station.now();
            let (mut refused, mut is_lost) = (false, false);
            match hand {
                Hand::Holds(jog) => {
                    if chance.below(2) == 0 {
                        let _ = station.ask(anna, Request::Release);
                        holds = None;
                    }
                    let fresh = holds != Some(jog);
                    while station.now() < until {
                        refused |= station.ask(anna, Request::Jog { jog }).is_err();
                        station.run_for(BEAT.min(until.saturating_sub(station.now())));
                    }
                    if fresh && !refused {
                        acted += 1;
                        is_lost = lasts;
                    }
                    holds = Some(jog);
                }
                Hand::Rests => {
                    let _ = station.ask(anna, Request::Release);
                    holds = None;
                    station.run_for(time);
                }
                Hand::Sleeps => station.run_for(time),
            }
            let now = pressed(&station, from);
            from = station.packets().len();
            let Some(jog) = holds else {
                let bad = now
                    .iter()
                    .find(|(at, button)| button.is_some() && *at > begun);
                assert!(bad.is_none(), "seed {seed}: {bad:?} without a hand");
                continue;
            };
            let Some(Button::Held { axis, share }) = Button::of(&jog.command()) else {
                panic!("{jog:?} moves nothing");
            };
            is_lost &= now.iter().all(|(_, button)| button.is_none());
            assert!(!is_lost, "seed {seed}: {jog:?} was held for 3 s");
            for (at, button) in now.iter().filter(|(at, _)| *at > begun) {
                if let Some(found) = button {
                    assert_eq!(*found, (axis, share), "seed {seed}, {at:?}: {hand:?}");
                }
            }
        }
        let _ = station.ask(anna, Request::Release);
        station.run_for(Duration::from_secs(4));
        let packets = pressed(&station, 0);
        assert!(
            packets.last().is_none_or(|(_, button)| button.is_none()),
            "seed {seed}"
        );
        let before = station.arm().mechanics().joints_at(station.now());
        station.run_for(Duration::from_secs(1));
        assert_eq!(
            before,
            station.arm().mechanics().joints_at(station.now()),
            "seed {seed}: it rests"
        );
        a_long_press_acts(&mut station, anna, seed);
    }
    assert!(acted > 1000, "{acted} presses acted");
}

/// Checks that a long press takes effect.
fn a_long_press_acts(station: &mut VirtualStation, anna: ClientId, seed: u64) {
    let from = station.packets().len();
    for axis in [JointJogAxis::BasePlus, JointJogAxis::BaseMinus] {
        let jog = joint(axis);
        let _ = station.ask(anna, Request::Release);
        for _ in 0..40 {
            let _ = station.ask(anna, Request::Jog { jog });
            station.run_for(BEAT);
        }
    }
    let _ = station.ask(anna, Request::Release);
    station.run_for(Duration::from_secs(2));
    let buttons = pressed(station, from);
    assert!(
        buttons.iter().any(|(_, button)| button.is_some()),
        "seed {seed}"
    );
}
