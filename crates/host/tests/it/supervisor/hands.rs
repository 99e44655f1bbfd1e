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
fn hold(it: &mut VirtualStation, client: ClientId, jog: Jog, time: Duration) {
    let until = it.now() + time;
    while it.now() < until {
        it.ask(client, Request::Jog { jog }).unwrap();
        it.run_for(BEAT);
    }
}

/// Returns the button packets sent to the arm, from a packet on: the axis that moves and its share,
/// or `None` for a release.
fn pressed(it: &VirtualStation, from: usize) -> Vec<(Duration, Option<(JogAxis, f64)>)> {
    let dialect = *it.supervisor().session().dialect().expect("it is known");
    let packets = it.packets()[from..].iter();
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

fn y_mm(it: &VirtualStation) -> f32 {
    it.supervisor()
        .state()
        .arm
        .expect("the arm reports its state")
        .status
        .y_mm
}

fn refusals(it: &VirtualStation) -> usize {
    let refused = |news: &News| matches!(news, News::Refused { .. });
    it.notices()
        .iter()
        .filter(|notice| refused(&notice.news))
        .count()
}

#[test]
fn a_press_while_the_arm_coasts_takes_effect_at_rest_if_it_is_still_held() {
    for personality in Personality::ALL {
        let (mut it, anna) = at_hand(personality);
        hold(&mut it, anna, linear(PLUS), Duration::from_secs(1));
        it.ask(anna, Request::Release).unwrap();
        it.run_for(BEAT);
        let before = it.packets().len();
        hold(&mut it, anna, linear(PLUS), Duration::from_secs(2));
        let told = pressed(&it, before);
        let acts = told.iter().position(|(_, button)| button.is_some());
        let acts = acts.unwrap_or_else(|| panic!("{personality}: {told:?}"));
        assert!(
            told[acts..].iter().all(|(_, button)| button.is_some()),
            "{personality}: it is not released: {told:?}"
        );
        assert_eq!(refusals(&it), 0, "{personality}");
    }
}

/// The notices of presses that were never sent to the arm.
fn lost_presses(it: &VirtualStation) -> usize {
    let is_lost = |text: &str| text.contains("before the press was sent, so nothing moved");
    it.notices()
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
            let (mut it, anna) = at_hand(personality);
            hold(&mut it, anna, joint(JointJogAxis::BasePlus), BEAT * 8);
            it.ask(anna, Request::Release).unwrap();
            it.run_for(Duration::from_millis(after_ms));
            let before = it.packets().len();
            let jog = joint(JointJogAxis::RearPlus);
            it.ask(anna, Request::Jog { jog }).unwrap();
            it.run_for(Duration::from_millis(tap_ms.min(140)));
            it.ask(anna, Request::Jog { jog }).unwrap();
            it.run_for(Duration::from_millis(tap_ms.saturating_sub(140)));
            it.ask(anna, Request::Release).unwrap();
            it.run_for(Duration::from_secs(2));
            let told = pressed(&it, before);
            let sent = told.iter().any(|(_, it)| it.is_some());
            let what = format!("{personality}, {tap_ms} ms, after {after_ms} ms: {told:?}");
            assert_ne!(sent, lost_presses(&it) == 1, "{what}");
            let last = told.last();
            assert!(last.is_none_or(|(_, it)| it.is_none()), "{what}");
        }
    }
}

#[test]
fn a_press_whose_client_goes_silent_before_the_arm_is_at_rest_is_reported() {
    for personality in Personality::ALL {
        let (mut it, anna) = at_hand(personality);
        hold(&mut it, anna, linear(PLUS), Duration::from_secs(1));
        it.ask(anna, Request::Release).unwrap();
        it.run_for(BEAT);
        let jog = joint(JointJogAxis::RearPlus);
        it.ask(anna, Request::Jog { jog }).unwrap();
        it.run_for(Duration::from_secs(3));
        assert_eq!(lost_presses(&it), 1, "{personality}");
    }
}

#[test]
fn a_press_released_before_the_arm_is_at_rest_moves_nothing_and_is_reported() {
    for personality in Personality::ALL {
        let (mut it, anna) = at_hand(personality);
        hold(&mut it, anna, linear(PLUS), Duration::from_secs(1));
        it.ask(anna, Request::Release).unwrap();
        let before = it.packets().len();
        hold(&mut it, anna, linear(PLUS), Duration::from_millis(100));
        it.ask(anna, Request::Release).unwrap();
        it.run_for(Duration::from_secs(3));
        assert_eq!(lost_presses(&it), 1, "{personality}");
        let told = pressed(&it, before);
        assert!(
            told.iter().all(|(_, it)| it.is_none()),
            "{personality}: {told:?}"
        );
    }
}

#[test]
fn a_reversal_is_accepted_with_and_without_a_release_in_between() {
    for personality in Personality::ALL {
        for lets_go in [true, false] {
            let (mut it, anna) = at_hand(personality);
            hold(&mut it, anna, linear(PLUS), Duration::from_millis(800));
            if lets_go {
                it.ask(anna, Request::Release).unwrap();
                it.run_for(BEAT);
            }
            let far = y_mm(&it);
            let before = it.packets().len();
            hold(&mut it, anna, linear(MINUS), Duration::from_millis(2500));
            it.ask(anna, Request::Release).unwrap();
            it.run_for(Duration::from_secs(2));
            assert!(y_mm(&it) < far - 10.0, "{personality}: {} mm", y_mm(&it));
            assert_eq!(refusals(&it), 0, "{personality}");
            // From plus to minus only through a release of the same kind: see `releases`.
            let told = pressed(&it, before);
            let acts = told.iter().position(|(_, it)| it.is_some()).unwrap();
            assert!(
                lets_go || told[..acts].iter().any(|(_, it)| it.is_none()),
                "{personality}: {told:?}"
            );
        }
    }
}

#[test]
fn after_a_dead_man_timeout_a_new_press_is_needed() {
    for personality in Personality::ALL {
        let (mut it, anna) = at_hand(personality);
        hold(&mut it, anna, linear(PLUS), Duration::from_millis(500));
        it.run_for(Duration::from_millis(2500));
        let before = it.packets().len();
        let jog = linear(PLUS);
        for _ in 0..20 {
            let refusal = it.ask(anna, Request::Jog { jog }).unwrap_err();
            assert!(matches!(refusal, Refusal::LetGo(_)), "{refusal}");
            it.run_for(BEAT);
        }
        let told = pressed(&it, before);
        assert!(
            told.iter().all(|(_, it)| it.is_none()),
            "{personality}: {told:?}"
        );
        assert_eq!(refusals(&it), 1, "{personality}: it is reported once");
        it.ask(anna, Request::Release).unwrap();
        hold(&mut it, anna, jog, Duration::from_millis(500));
        assert!(pressed(&it, before).iter().any(|(_, it)| it.is_some()));
    }
}

#[test]
fn at_a_limit_the_button_is_released_once_and_the_limit_stays_the_reason() {
    for personality in Personality::ALL {
        let (mut it, anna) = at_hand(personality);
        let jog = linear(LinearJogAxis::ZMinus);
        let mut reasons = Vec::new();
        for _ in 0..400 {
            reasons.extend(it.ask(anna, Request::Jog { jog }).err());
            it.run_for(BEAT);
        }
        assert!(reasons.len() > 20, "{personality}");
        for reason in &reasons {
            assert!(
                matches!(reason, Refusal::Policy(_)),
                "{personality}: {reason}"
            );
        }
        assert_eq!(refusals(&it), 1, "{personality}: it is reported once");
        let told = pressed(&it, 0);
        let released = told.iter().position(|(_, it)| it.is_none()).unwrap();
        assert!(
            told[released..].iter().all(|(_, it)| it.is_none()),
            "{personality}: it does not start again: {told:?}"
        );
    }
}

#[test]
fn a_button_held_through_a_stop_does_not_move_the_arm_after_the_reset() {
    for personality in Personality::ALL {
        let (mut it, anna) = at_hand(personality);
        let ben = it.client("Ben");
        hold(&mut it, anna, linear(PLUS), Duration::from_millis(500));
        it.ask(ben, Request::Stop { reason: None }).unwrap();
        let before = it.packets().len();
        let jog = linear(PLUS);
        for beat in 0..100 {
            assert!(it.ask(anna, Request::Jog { jog }).is_err(), "{personality}");
            if beat == 80 {
                it.ask(ben, Request::ResetStop).unwrap();
            }
            it.run_for(BEAT);
        }
        let told = pressed(&it, before);
        assert!(
            told.iter().all(|(_, it)| it.is_none()),
            "{personality}: {told:?}"
        );
    }
}

#[test]
fn a_press_during_a_long_move_is_refused_and_has_no_effect_after_it() {
    let (mut it, anna) = at_hand(Personality::Firmware11);
    let command = crate::cases::commands::target([230.0, 100.0, 20.0]).into();
    it.ask(anna, Request::Command { command }).unwrap();
    let command = crate::cases::commands::target([230.0, -100.0, 20.0]).into();
    it.ask(anna, Request::Command { command }).unwrap();
    let jog = linear(PLUS);
    let refusal = it.ask(anna, Request::Jog { jog }).unwrap_err();
    assert!(matches!(refusal, Refusal::StillMoving { .. }), "{refusal}");
    for _ in 0..400 {
        let again = it.ask(anna, Request::Jog { jog });
        assert!(again.is_err());
        it.run_for(BEAT);
    }
    assert!(pressed(&it, 0).iter().all(|(_, it)| it.is_none()));
}

#[test]
fn a_press_by_a_raw_client_while_the_arm_coasts_takes_effect() {
    for personality in Personality::ALL {
        let (mut it, anna) = at_hand(personality);
        it.leave(anna);
        let program = it.client("a raw program");
        let dialect = personality.dialect();
        let say = |station: &mut VirtualStation, jog: Jog| {
            station.send_raw(program, &jog.command().emit(&dialect))
        };
        let release = linear(LinearJogAxis::Released);
        say(&mut it, linear(PLUS)).unwrap();
        it.run_for(Duration::from_millis(500));
        say(&mut it, release).unwrap();
        it.run_for(Duration::from_millis(100));
        // Like the vendor's client: sent immediately, and again after half a second.
        say(&mut it, joint(JointJogAxis::RearPlus)).unwrap();
        let before = it.packets().len();
        it.run_for(Duration::from_millis(500));
        say(&mut it, joint(JointJogAxis::RearPlus)).unwrap();
        it.run_for(Duration::from_millis(500));
        let told = pressed(&it, before);
        let acts = |button: &(Duration, Option<(JogAxis, f64)>)| {
            button.1.is_some_and(|(axis, _)| axis == JogAxis::Rear)
        };
        assert!(told.iter().any(acts), "{personality}: {told:?}");
        assert_eq!(refusals(&it), 0, "{personality}");
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
        let (mut it, anna) = over(
            personality,
            [0, 20, 50, 100, 200][usize::try_from(seed % 5).unwrap()],
        );
        let mut holds: Option<Jog> = None;
        let mut from = it.packets().len();
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
            let until = it.now() + time;
            let begun = it.now();
            let (mut refused, mut is_lost) = (false, false);
            match hand {
                Hand::Holds(jog) => {
                    if chance.below(2) == 0 {
                        let _ = it.ask(anna, Request::Release);
                        holds = None;
                    }
                    let fresh = holds != Some(jog);
                    while it.now() < until {
                        refused |= it.ask(anna, Request::Jog { jog }).is_err();
                        it.run_for(BEAT.min(until.saturating_sub(it.now())));
                    }
                    if fresh && !refused {
                        acted += 1;
                        is_lost = lasts;
                    }
                    holds = Some(jog);
                }
                Hand::Rests => {
                    let _ = it.ask(anna, Request::Release);
                    holds = None;
                    it.run_for(time);
                }
                Hand::Sleeps => it.run_for(time),
            }
            let now = pressed(&it, from);
            from = it.packets().len();
            let Some(jog) = holds else {
                let bad = now.iter().find(|(at, it)| it.is_some() && *at > begun);
                assert!(bad.is_none(), "seed {seed}: {bad:?} without a hand");
                continue;
            };
            let Some(Button::Held { axis, share }) = Button::of(&jog.command()) else {
                panic!("{jog:?} moves nothing");
            };
            is_lost &= now.iter().all(|(_, it)| it.is_none());
            assert!(!is_lost, "seed {seed}: {jog:?} was held for 3 s");
            for (at, button) in now.iter().filter(|(at, _)| *at > begun) {
                if let Some(found) = button {
                    assert_eq!(*found, (axis, share), "seed {seed}, {at:?}: {hand:?}");
                }
            }
        }
        let _ = it.ask(anna, Request::Release);
        it.run_for(Duration::from_secs(4));
        let told = pressed(&it, 0);
        assert!(
            told.last().is_none_or(|(_, it)| it.is_none()),
            "seed {seed}"
        );
        let before = it.arm().mechanics().joints_at(it.now());
        it.run_for(Duration::from_secs(1));
        assert_eq!(
            before,
            it.arm().mechanics().joints_at(it.now()),
            "seed {seed}: it rests"
        );
        // After all that a long press takes effect.
        let from = it.packets().len();
        let jog = joint(JointJogAxis::BasePlus);
        let back = joint(JointJogAxis::BaseMinus);
        for jog in [jog, back] {
            let _ = it.ask(anna, Request::Release);
            for _ in 0..40 {
                let _ = it.ask(anna, Request::Jog { jog });
                it.run_for(BEAT);
            }
        }
        let _ = it.ask(anna, Request::Release);
        it.run_for(Duration::from_secs(2));
        assert!(
            pressed(&it, from).iter().any(|(_, it)| it.is_some()),
            "seed {seed}"
        );
    }
    assert!(acted > 1000, "{acted} presses acted");
}
