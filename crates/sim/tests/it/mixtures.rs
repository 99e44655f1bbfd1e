//! Random mixtures of commands on the twin of the stock controller: what the notes say of all of
//! them, whatever they are.

mod mixture;
mod run;

use std::time::Duration;

use dobot_arm::{Joints, TICK, Tool};
use dobot_controller::{Port, STEPS_PER_DEG, Upload};
use dobot_wire::Frame;
use proptest::prelude::*;

use self::mixture::{Mixture, mixture};
use self::run::{MixtureRun, Slicing, run};

proptest! {
    #![proptest_config(ProptestConfig::with_cases(CASES))]

    /// Whoever looks at it when, it does the same; and the same again.
    #[test]
    fn it_does_the_same_whoever_looks_when(mixture in mixture()) {
        let mut by_ticks = run(&mixture, Slicing::Ticks);
        prop_assert!(by_ticks == run(&mixture, Slicing::Ticks), "another time it does something else");
        by_ticks.rows.clear();
        for pace in [Slicing::Bytes, Slicing::Chunks] {
            let other = run(&mixture, pace);
            prop_assert!(by_ticks == other, "{pace:?}: {}", difference(&by_ticks, &other));
        }
    }

    /// Every fourth tick in which fewer than four wait (note N20); over Bluetooth three times in
    /// eight ticks (note N38).
    #[test]
    fn statuses_come_when_they_are_due(mixture in mixture()) {
        let run = run(&mixture, Slicing::Ticks);
        match mixture.port {
            Port::Usb => check_usb_statuses(&run)?,
            Port::Bluetooth => check_bluetooth_statuses(&run)?,
        }
        for upload in &run.uploads {
            // A tick calculates for 7 ms at most (note N39).
            let late = Duration::from_nanos(u64::from(upload.at.subsec_nanos() % 20_000_000));
            prop_assert!(
                (Duration::from_micros(1500)..=Duration::from_micros(7600)).contains(&late),
                "a status leaves {late:?} behind its tick"
            );
        }
    }

    /// Position and rotation follow from the angles, unless they are lost (note N21).
    #[test]
    fn the_pose_follows_from_the_angles(mixture in mixture()) {
        let run = run(&mixture, Slicing::Ticks);
        // The very first one over Bluetooth has no pose yet (note N38).
        let skipped = usize::from(mixture.port == Port::Bluetooth);
        for upload in &run.uploads[skipped..] {
            let floats = floats(upload, mixture.port);
            if floats.iter().all(|it| it.is_finite()) {
                let off_mm = off_mm(&floats);
                prop_assert!(off_mm < 0.01, "{off_mm} mm off: {floats:?}");
                let off_deg = floats[7] + floats[4] - floats[3];
                prop_assert!(off_deg.abs() < 0.01, "{off_deg} degrees off: {floats:?}");
            }
        }
    }

    /// No pulse is lost or made up, except that 9/3 says other angles, and motors repeat their
    /// pulses below a text (notes N37, N43 and N50).
    #[test]
    fn pulses_add_up_to_the_angles(mixture in mixture()) {
        let run = run(&mixture, Slicing::Ticks);
        prop_assume!(!mixture.has_text() && !may(&mixture, sets_angles));
        let mut reported = 0;
        for (tick, row) in run.rows.iter().enumerate() {
            if row.uploads == reported {
                continue;
            }
            reported = row.uploads;
            let floats = floats(&run.uploads[reported - 1], mixture.port);
            if floats.iter().any(|it| !it.is_finite()) {
                break;
            }
            for axis in 0..3 {
                let turned = f64::from(floats[4 + axis]) - [0.0, 45.0, 45.0][axis];
                #[expect(clippy::cast_precision_loss, reason = "they are few")]
                let sent = row.steps[axis] as f64 / STEPS_PER_DEG[axis];
                prop_assert!(
                    (sent - turned).abs() < PULSE_DEG,
                    "tick {tick}, axis {axis}: {sent} degrees of pulses, {turned} of turn"
                );
            }
        }
    }

    /// The hard limits of each joint (note N42); the servo's does not hold at the end of a line.
    #[test]
    fn no_joint_goes_beyond_its_hard_limit(mixture in mixture()) {
        prop_assume!(!may(&mixture, sets_angles));
        let run = run(&mixture, Slicing::Ticks);
        for upload in &run.uploads {
            let floats = floats(upload, mixture.port);
            for (angle, [low, high]) in floats[4..7].iter().zip(HARD_DEG) {
                let is_out = *angle < low || *angle > high;
                prop_assert!(!is_out, "{angle} is not within {low} to {high}");
            }
        }
    }

    /// Pump and laser are switched no more often than there are packets that may, and not before
    /// the first of them.
    #[test]
    fn only_what_may_switches_pump_and_laser(mixture in mixture()) {
        prop_assume!(!mixture.has_text() && !mixture.has_noise());
        let run = run(&mixture, Slicing::Ticks);
        let pump: Vec<bool> = run.rows.iter().map(|row| row.outputs.pump).collect();
        let laser: Vec<bool> = run.rows.iter().map(|row| row.outputs.laser).collect();
        for (name, states, to, switches) in [
            ("pump on", &pump, true, pump_on as fn(&[f32; 10]) -> bool),
            ("pump off", &pump, false, pump_off),
            ("laser on", &laser, true, laser_on),
            ("laser off", &laser, false, laser_off),
        ] {
            let edges = states.windows(2).filter(|it| it[0] != it[1] && it[1] == to).count();
            let most = mixture.packets().filter(|it| switches(it)).count();
            prop_assert!(edges <= most, "{name} {edges} times by {most} packets");
        }
        for row in &run.rows {
            prop_assert_eq!(row.outputs.pump, row.outputs.valve);
        }
    }

    /// Six wait at most, and one begins in a tick (notes N40 and N41).
    #[test]
    fn the_queue_has_six_places(mixture in mixture()) {
        prop_assume!(!mixture.has_text() && !mixture.has_noise());
        let run = run(&mixture, Slicing::Ticks);
        for row in &run.rows {
            prop_assert!(row.waiting <= 6, "{} wait", row.waiting);
        }
        prop_assert!(run.begun <= run.packets);
    }
}

fn check_usb_statuses(run: &MixtureRun) -> Result<(), TestCaseError> {
    let (mut ticks, mut expected) = (0, 0);
    for (tick, row) in run.rows.iter().enumerate() {
        ticks += u8::from(row.waiting < 4);
        if ticks == 4 {
            ticks = 0;
            expected += 1;
        }
        prop_assert_eq!(row.uploads, expected, "by tick {}", tick);
    }
    Ok(())
}

/// In the first and fifth tick of eight with 1000 added to x, in the third the permit.
fn check_bluetooth_statuses(run: &MixtureRun) -> Result<(), TestCaseError> {
    for upload in &run.uploads {
        let x_mm = raw_floats(upload)[0];
        let tick = upload.at.as_millis() / TICK.as_millis() % 8;
        let is_right = match tick {
            0 | 4 => x_mm > 500.0 || x_mm.is_nan(),
            2 => x_mm < 500.0 || x_mm.is_nan(),
            _ => false,
        };
        prop_assert!(is_right, "tick {tick} of eight, x {x_mm}");
    }
    Ok(())
}

fn raw_floats(upload: &Upload) -> [f32; 10] {
    let frame = Frame::from_bytes(&upload.bytes).expect("it is delimited");
    std::array::from_fn(|index| frame.float(index + 1))
}

/// Without the 1000 that marks a message over Bluetooth.
fn floats(upload: &Upload, port: Port) -> [f32; 10] {
    let mut floats = raw_floats(upload);
    if port == Port::Bluetooth && floats[0] > 500.0 {
        floats[0] -= 1000.0;
    }
    floats
}

/// How far the position is from the angles, with one tool or the other.
fn off_mm(floats: &[f32; 10]) -> f64 {
    let [x, y, z, _, base, rear, fore, servo, ..] = floats.map(f64::from);
    let joints = Joints::new(base, rear, fore, servo);
    [Tool::SuctionCup, Tool::Laser]
        .map(|tool| {
            let position = dobot_arm::forward(&joints, tool).position;
            position.distance(dobot_arm::Position::new(x, y, z)).0
        })
        .into_iter()
        .fold(f64::INFINITY, f64::min)
}

fn may(mixture: &Mixture, what: fn(&[f32; 10]) -> bool) -> bool {
    mixture.has_noise() || mixture.packets().any(what)
}

fn sets_angles(floats: &[f32; 10]) -> bool {
    whole(floats[0]) == 9 && whole(floats[1]) == 3
}

fn pump_on(floats: &[f32; 10]) -> bool {
    match whole(floats[0]) {
        2 | 7 => whole(floats[1]) == 9,
        1 | 3 | 6 | 8 => floats[6] == 1.0,
        _ => false,
    }
}

fn pump_off(floats: &[f32; 10]) -> bool {
    match whole(floats[0]) {
        2 | 7 => whole(floats[1]) == 10,
        1 | 3 | 6 | 8 => floats[6] == 0.0,
        _ => false,
    }
}

fn laser_on(floats: &[f32; 10]) -> bool {
    match whole(floats[0]) {
        2 | 7 => whole(floats[1]) == 13,
        4 => whole(floats[1]) == 1 && floats[6] == 1.0,
        _ => false,
    }
}

fn laser_off(floats: &[f32; 10]) -> bool {
    match whole(floats[0]) {
        2 | 7 => whole(floats[1]) == 14,
        4 => floats[5] == 1.0 || (whole(floats[1]) == 1 && floats[6] == 0.0),
        _ => false,
    }
}

/// The integer part; sixteen bits of it, as the stock controller has.
fn whole(value: f32) -> i16 {
    dobot_arm::stock::short(value)
}

/// The first difference of two runs, to be read by a person.
fn difference(a: &MixtureRun, b: &MixtureRun) -> String {
    let both = a.uploads.iter().zip(&b.uploads);
    if let Some((a, b)) = both.into_iter().find(|(a, b)| a != b) {
        return format!(
            "{:?} {:?}, {:?} {:?}",
            a.at,
            raw_floats(a),
            b.at,
            raw_floats(b)
        );
    }
    format!(
        "{} and {} statuses, {:?} and {:?} pulses, {} and {} begun, {} and {} refused",
        a.uploads.len(),
        b.uploads.len(),
        a.steps,
        b.steps,
        a.begun,
        b.begun,
        a.refused,
        b.refused
    )
}

const CASES: u32 = 200;
/// Base, rear and fore, in degrees; a rounding error beyond.
const HARD_DEG: [[f32; 2]; 3] = [[-180.001, 180.001], [-5.001, 85.001], [-10.001, 95.001]];
/// A pulse and a half, and what single precision rounds away in a minute.
const PULSE_DEG: f64 = 0.03;
