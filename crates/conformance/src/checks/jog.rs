//! Buttons: joint jog and linear jog (states 2 and 7).

use dobot_wire::Status;

use crate::observed_motion::PERIOD_S;
use crate::outcome::Outcome;
use crate::packet::{jog, over_bluetooth};
use crate::rig::{CheckError, Rig};

/// A pair of buttons and their axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct JogButtons {
    state: f32,
    /// The forward button; the next one is backward.
    plus: f32,
    /// The index of the value that changes.
    index: usize,
    /// The share of the largest speed.
    percent: f32,
    unit: &'static str,
}

pub(crate) const BASE: JogButtons = joint(1.0, 0);
pub(crate) const REAR: JogButtons = joint(3.0, 1);
pub(crate) const FORE: JogButtons = joint(5.0, 2);
pub(crate) const SERVO: JogButtons = joint(7.0, 3);
pub(crate) const GRIPPER: JogButtons = joint(11.0, 4);
pub(crate) const X: JogButtons = along(1.0, 0);
pub(crate) const Y: JogButtons = along(3.0, 1);
pub(crate) const Z: JogButtons = along(5.0, 2);
pub(crate) const LINE_SERVO: JogButtons = JogButtons {
    state: LINES,
    ..SERVO
};
pub(crate) const LINE_GRIPPER: JogButtons = JogButtons {
    state: LINES,
    ..GRIPPER
};

/// Whether the arm stops after a release and stays at rest.
pub(crate) async fn release(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let before = rig.settled().await?;
    rig.send(jog(2.0, 1.0, 20.0)).await?;
    rig.pass(300).await?;
    rig.send(jog(2.0, 0.0, 0.0)).await?;
    if !rig.stands().await? {
        rig.stop_jog().await?;
        rig.settled().await?;
        return Ok(Outcome::Differs(
            "the arm kept moving after the release".into(),
        ));
    }
    let after = rig.settled().await?;
    let moved = after.base_deg - before.base_deg;
    Ok(Outcome::of(
        moved > LEAST,
        format!(
            "{moved:.3} degrees in the time of a short press, {LEAST} at least; then it stands"
        ),
    ))
}

/// Both buttons of an axis: only that axis moves, there and back.
pub(crate) async fn axis(rig: &mut Rig, axis: JogButtons) -> Result<Outcome, CheckError> {
    let before = numbers(axis, &rig.settled().await?);
    let there = numbers(axis, &press(rig, axis, axis.plus).await?);
    let back = numbers(axis, &press(rig, axis, axis.plus + 1.0).await?);
    let by = |from: [f32; 5], to: [f32; 5]| to[axis.index] - from[axis.index];
    let (plus, minus) = (by(before, there), by(there, back));
    let strays = strays(axis, before, there).max(strays(axis, there, back));
    Ok(Outcome::of(
        plus > LEAST && minus < -LEAST && strays < STRAY,
        format!(
            "{plus:+.2} and {minus:+.2} {}, {LEAST} at least; all else by up to {strays:.3} of {STRAY}{}",
            axis.unit,
            by_other_buttons(rig, axis)
        ),
    ))
}

/// Names the buttons of a joint where they differ on this port (note N38).
fn by_other_buttons(rig: &Rig, axis: JogButtons) -> String {
    let sent = [axis.plus, axis.plus + 1.0].map(|button| {
        let packet = jog(axis.state, button, axis.percent);
        over_bluetooth(packet).float(2)
    });
    if rig.is_bluetooth() && sent[0] != axis.plus {
        format!("; over Bluetooth by {} and {}", sent[0], sent[1])
    } else {
        String::new()
    }
}

/// The speed of the base while its button is held, in degrees per second.
pub(crate) async fn steady_speed(rig: &mut Rig, percent: f32) -> Result<f64, CheckError> {
    let mark = rig.seen.len();
    let axis = JogButtons { percent, ..BASE };
    hold(rig, axis, BASE.plus, LONGER_MS).await?;
    let steps = rig.seen[mark..].windows(2);
    let mut steps: Vec<f64> = steps
        .map(|it| f64::from(it[1].status.base_deg - it[0].status.base_deg))
        .filter(|step| *step > 0.01)
        .collect();
    // The middle one: at its beginning and end a step is shorter, and a late status makes one longer.
    steps.sort_by(f64::total_cmp);
    let middle = steps.get(steps.len().div_ceil(2)).or(steps.last());
    Ok(middle.copied().unwrap_or_default() / PERIOD_S)
}

/// The pump, on and off.
pub(crate) async fn pump(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let (with, _) = rig.carry_out(jog(2.0, 9.0, 0.0)).await?;
    let (without, _) = rig.carry_out(jog(2.0, 10.0, 0.0)).await?;
    let (on, off) = (with.suction, !without.suction);
    let found = match (on, off) {
        (true, true) => "on, then off",
        (false, _) => "it does not switch on",
        (_, false) => "it does not switch off",
    };
    Ok(Outcome::of(on && off, found))
}

/// The laser, on and off: a status does not show it, nor may it show anything else.
pub(crate) async fn laser(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let before = rig.settled().await?;
    rig.send(jog(2.0, 13.0, 0.0)).await?;
    rig.send(jog(2.0, 14.0, 0.0)).await?;
    let after = rig.settled().await?;
    Ok(Outcome::of(
        before == after,
        if before == after {
            "on for a moment; not part of the status: look for the spot"
        } else {
            "the status changes, although the laser is not part of it"
        },
    ))
}

/// Holds a button for a moment; the arm rests afterwards.
async fn press(rig: &mut Rig, axis: JogButtons, button: f32) -> Result<Status, CheckError> {
    hold(rig, axis, button, HOLD_MS).await
}

async fn hold(rig: &mut Rig, axis: JogButtons, button: f32, ms: u64) -> Result<Status, CheckError> {
    rig.send(jog(axis.state, button, axis.percent)).await?;
    rig.pass(ms).await?;
    rig.send(jog(axis.state, 0.0, 0.0)).await?;
    if !rig.stands().await? {
        rig.stop_jog().await?;
    }
    rig.settled().await
}

/// The values that a jog of this kind may change: joints or coordinates, and the gripper.
fn numbers(axis: JogButtons, it: &Status) -> [f32; 5] {
    if axis.state == JOINTS {
        [
            it.base_deg,
            it.rear_deg,
            it.fore_deg,
            it.servo_deg,
            it.gripper_deg,
        ]
    } else {
        [it.x_mm, it.y_mm, it.z_mm, it.rotation_deg, it.gripper_deg]
    }
}

/// The largest change of the values that should not change.
fn strays(axis: JogButtons, from: [f32; 5], to: [f32; 5]) -> f32 {
    let pairs = from.into_iter().zip(to).enumerate();
    let others = pairs.filter(|(index, _)| *index != axis.index);
    others
        .map(|(_, (from, to))| (to - from).abs())
        .fold(0.0, f32::max)
}

/// A joint jog at 20 % by default.
const fn joint(plus: f32, index: usize) -> JogButtons {
    JogButtons {
        state: JOINTS,
        plus,
        index,
        percent: 20.0,
        unit: "degrees",
    }
}

const fn along(plus: f32, index: usize) -> JogButtons {
    JogButtons {
        state: LINES,
        percent: 10.0,
        unit: "mm",
        ..joint(plus, index)
    }
}

const JOINTS: f32 = 2.0;
const LINES: f32 = 7.0;
const HOLD_MS: u64 = 300;
/// Long enough for three status periods at full speed, within 10 mm.
const LONGER_MS: u64 = 420;
/// The smallest motion of an effective press.
const LEAST: f32 = 0.3;
/// The tolerance for rounding.
const STRAY: f32 = 0.05;
