//! A button is released by its own kind of jog and by nothing else: no other axis moves.

use std::time::Duration;

use dobot_api::{ClientId, Jog, News, Request};
use dobot_controller::{Controller, Personality, PowerUp};
use dobot_host::VirtualStation;
use dobot_motion::{Button, JogAxis};
use dobot_safety::Policy;
use dobot_sim::{Fault, SerialLine, VirtualArm};
use dobot_wire::{
    Command, Configuration, Dialect, Frame, JointJog, JointJogAxis, LinearJog, LinearJogAxis,
    PACKET_LEN,
};

const PERCENT: f32 = 50.0;

/// The 16 buttons that move something, and those of the linear jog that have the same effect as in a joint jog.
pub(crate) fn buttons() -> Vec<Jog> {
    let joints = JointJogAxis::ALL.into_iter().filter(|axis| axis.moves());
    let lines = LinearJogAxis::ALL.into_iter().filter(|axis| axis.moves());
    joints.map(joint).chain(lines.map(linear)).collect()
}

pub(crate) fn joint(axis: JointJogAxis) -> Jog {
    Jog::Joint(JointJog::new(axis, PERCENT))
}

pub(crate) fn linear(axis: LinearJogAxis) -> Jog {
    Jog::Linear(LinearJog::new(axis, PERCENT))
}

/// A link whose bytes are late by up to this much, in both directions.
pub(crate) fn over(personality: Personality, delay_ms: u32) -> (VirtualStation, ClientId) {
    let power_up = PowerUp::new(personality);
    let mut arm = VirtualArm::new(Controller::power_up(power_up), SerialLine::STOCK);
    if delay_ms > 0 {
        let fault: Fault = format!("delay={delay_ms}ms").parse().unwrap();
        arm = arm.with_faults(power_up, &[fault], 5);
    }
    let mut station = VirtualStation::with_arm(arm, power_up, Policy::default());
    station.run_for(Duration::from_secs(1));
    let anna = station.client("Anna");
    station.ask(anna, Request::TakeLease).unwrap();
    (station, anna)
}

/// A button held for this long; a refusal before that releases it.
pub(crate) fn hold(station: &mut VirtualStation, client: ClientId, jog: Jog, ms: u64) {
    for _ in 0..=ms / 50 {
        if station.ask(client, Request::Jog { jog }).is_err() {
            return;
        }
        station.run_for(Duration::from_millis(50));
    }
}

/// The positions of everything: the joints as the machine has them, x, y and z, and the gripper.
pub(crate) fn places(station: &mut VirtualStation) -> ([f64; 4], [f64; 3], f64) {
    station.run_for(Duration::from_secs(4));
    let arm = station.arm();
    let joints = arm.mechanics().joints_at(station.now());
    let at = arm.controller().pose_at(station.now()).position;
    let gripper_deg = station.supervisor().state().arm.unwrap().status.gripper_deg;
    (
        joints.angles_deg(),
        [at.x.0, at.y.0, at.z.0],
        gripper_deg.into(),
    )
}

/// The releases that the arm got, and the presses.
pub(crate) fn released(station: &VirtualStation, from: usize) -> Vec<f32> {
    let frames = station.packets()[from..]
        .iter()
        .map(|(_, bytes)| frame(bytes));
    frames
        .filter(|frame| matches!(frame.float(1), 2.0 | 7.0) && frame.float(2) == 0.0)
        .map(|frame| frame.float(1))
        .collect()
}

pub(crate) fn frame(bytes: &[u8; PACKET_LEN]) -> Frame {
    Frame::from_bytes(bytes).expect("no voice")
}

/// Looks that only the axis of the button has moved, and into its direction.
pub(crate) fn check_moved(
    what: &str,
    station: &mut VirtualStation,
    jog: Jog,
    before: ([f64; 4], [f64; 3], f64),
) {
    let after = places(station);
    let Some(Button::Held { axis, share }) = Button::of(&jog.command()) else {
        panic!("{jog:?} moves nothing");
    };
    let by = |from: f64, to: f64| (to - from) * share.signum();
    let (joints, lines) = ([0, 1, 2, 3], [0, 1, 2]);
    let joints = joints.map(|n| by(before.0[n], after.0[n]));
    let lines = lines.map(|n| by(before.1[n], after.1[n]));
    let gripper = by(before.2, after.2);
    let (found, wanted): (Vec<f64>, usize) = match axis {
        JogAxis::Base => ([joints.as_slice(), &[gripper]].concat(), 0),
        JogAxis::Rear => ([joints.as_slice(), &[gripper]].concat(), 1),
        JogAxis::Fore => ([joints.as_slice(), &[gripper]].concat(), 2),
        JogAxis::Servo => ([joints.as_slice(), &[gripper]].concat(), 3),
        JogAxis::Gripper => ([joints.as_slice(), &[gripper]].concat(), 4),
        JogAxis::X => (lines.to_vec(), 0),
        JogAxis::Y => (lines.to_vec(), 1),
        JogAxis::Z => (lines.to_vec(), 2),
    };
    for (n, moved) in found.iter().enumerate() {
        if n == wanted {
            assert!(*moved > 0.5, "{what}: it moved by {moved}");
        } else {
            // Rounding, and the resolution of servo and motor steps.
            assert!(moved.abs() < 0.2, "{what}: axis {n} moved by {moved}, too");
        }
    }
}

fn state(jog: Jog) -> f32 {
    match jog {
        Jog::Joint(_) => JointJog::STATE,
        Jog::Linear(_) => LinearJog::STATE,
    }
}

/// A button is held on a link and a computer like that, and ends as `end` does it.
fn check_ended(delay_ms: u32, load_ms: u64, end: impl Fn(&mut VirtualStation, ClientId)) {
    for personality in Personality::ALL {
        for jog in buttons() {
            let (mut station, anna) = over(personality, delay_ms);
            let before = places(&mut station);
            let from = station.packets().len();
            station.load(Duration::from_millis(load_ms));
            hold(&mut station, anna, jog, 600);
            end(&mut station, anna);
            let what = format!("{personality}, {delay_ms} ms, load {load_ms} ms: {jog:?}");
            check_moved(&what, &mut station, jog, before);
            let found = released(&station, from);
            assert!(!found.is_empty(), "{what}: it was released");
            assert!(
                found.iter().all(|found| *found == state(jog)),
                "{what}: {found:?}"
            );
        }
    }
}

const LINKS_MS: [u32; 5] = [0, 10, 30, 90, 200];

#[test]
fn every_button_is_released_by_its_own_kind_on_any_slow_link() {
    for delay_ms in LINKS_MS {
        check_ended(delay_ms, 0, |station, anna| {
            station.ask(anna, Request::Release).unwrap();
        });
    }
}

#[test]
fn every_button_is_released_by_its_own_kind_by_a_slow_computer() {
    for load_ms in [90, 170, 330] {
        check_ended(0, load_ms, |station, anna| {
            station.ask(anna, Request::Release).unwrap();
        });
    }
}

#[test]
fn a_stop_releases_every_button_by_its_own_kind() {
    for (delay_ms, load_ms) in [(0, 0), (30, 0), (200, 0), (0, 170)] {
        check_ended(delay_ms, load_ms, |station, anna| {
            station.ask(anna, Request::Stop { reason: None }).unwrap();
        });
    }
}

#[test]
fn the_button_of_a_silent_client_is_released_by_its_own_kind() {
    for delay_ms in LINKS_MS {
        check_ended(delay_ms, 0, |_, _| {});
    }
}

#[test]
fn a_button_held_when_the_cable_was_pulled_is_released_by_its_own_kind() {
    check_ended(0, 0, |station, _| {
        station.unplug();
        station.run_for(Duration::from_millis(100));
        station.plug();
    });
}

#[test]
fn a_release_of_the_wrong_kind_from_a_client_becomes_one_of_the_right_kind() {
    let joint = Command::from(JointJog::new(JointJogAxis::Released, 0.0));
    let linear = Command::from(LinearJog::new(LinearJogAxis::Released, 0.0));
    for command in [joint, linear] {
        check_ended(30, 0, |station, anna| {
            station.ask(anna, Request::Command { command }).unwrap();
        });
        check_ended(30, 0, |station, anna| {
            let packet = command.emit(&Dialect::FIRMWARE_1_1);
            station.send_raw(anna, &packet).unwrap();
        });
    }
}

#[test]
fn a_stop_of_an_arm_that_was_never_jogged_releases_nothing() {
    for personality in Personality::ALL {
        let (mut station, anna) = over(personality, 0);
        station.ask(anna, Request::Stop { reason: None }).unwrap();
        station.run_for(Duration::from_secs(2));
        assert!(released(&station, 0).is_empty(), "{personality}");
    }
}

#[test]
fn a_button_that_was_never_sent_moves_nothing_and_the_previous_one_is_released() {
    for personality in Personality::ALL {
        for never in buttons() {
            let first = match never {
                Jog::Joint(_) => linear(LinearJogAxis::YPlus),
                Jog::Linear(_) => joint(JointJogAxis::BasePlus),
            };
            let (mut station, anna) = over(personality, 0);
            let before = places(&mut station);
            let from = station.packets().len();
            hold(&mut station, anna, first, 550);
            station.ask(anna, Request::Jog { jog: first }).unwrap();
            // A press uses the permit of the last status up, and the next one waits for another.
            for jog in [joint(JointJogAxis::SuctionOff), never] {
                // A switch releases the button; an axis that still coasts may refuse the next one.
                let _ = station.ask(anna, Request::Jog { jog });
            }
            station.ask(anna, Request::Release).unwrap();
            let what = format!("{personality}: {never:?}");
            check_moved(&what, &mut station, first, before);
            let found = released(&station, from);
            assert!(!found.is_empty(), "{what}");
            assert!(
                found.iter().all(|found| *found == state(first)),
                "{what}: {found:?}"
            );
        }
    }
}

#[test]
fn a_long_coast_is_not_mistaken_for_a_reset() {
    for personality in Personality::ALL {
        for stops in [false, true] {
            let (mut station, anna) = over(personality, 0);
            // As the vendor's client sets it: a joint 4 at 50 % takes 1.5 s and more to come to rest.
            let slow = Configuration::Teach {
                joint_speed_deg_s: 30.0,
                joint_acceleration_deg_s2: 30.0,
                servo_speed_deg_s: 30.0,
                servo_acceleration_deg_s2: 10.0,
                linear_speed_mm_s: 30.0,
                linear_acceleration_mm_s2: 30.0,
            };
            let command = slow.into();
            station.ask(anna, Request::Command { command }).unwrap();
            station.run_for(Duration::from_secs(1));
            assert_eq!(
                station.supervisor().state().arm.unwrap().status.base_deg,
                0.0
            );
            hold(&mut station, anna, joint(JointJogAxis::ServoPlus), 1900);
            if stops {
                station.ask(anna, Request::Stop { reason: None }).unwrap();
            } else {
                station.ask(anna, Request::Release).unwrap();
            }
            station.run_for(Duration::from_secs(5));
            let state = station.supervisor().state();
            assert!(state.trust.trusted, "{personality}: {:?}", state.trust);
            assert!(station.supervisor().is_at_rest(), "{personality}");
            let reset = station
                .notices()
                .iter()
                .find(|notice| notice.news == News::Reset);
            assert_eq!(reset, None, "{personality}");
        }
    }
}
