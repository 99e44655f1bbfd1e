//! Packets of old programs that a table or the policy does not allow, but that a stock arm accepts
//! harmlessly. They are sent with equivalent values, or reduced to the ceiling, instead of being
//! refused as a whole.

use dobot_motion::{Model, Speeds};
use dobot_safety::Policy;
use dobot_wire::{
    Command, Configuration, Dialect, Frame, Instead, JointJog, Leniency, LinearJog, MoveJoints,
    MoveTo, Packet, PlaybackAdjustment, WriteVector, single,
};

/// Returns the packet to send and a one-line description of the change, or `None` if nothing
/// changed.
pub(super) fn amended(packet: &Packet, model: &Model, policy: &Policy) -> Option<(Packet, String)> {
    let Packet::Frame(frame) = packet else {
        return None;
    };
    let mut notes = Vec::new();
    let sent = reduce_to_ceilings(frame, model, policy, &mut notes);
    let sent = replace_harmless_values(&sent, model, &mut notes);
    let state = frame.float(1);
    (!notes.is_empty()).then(|| (sent.into(), format!("state {state}: {}", notes.join("; "))))
}

/// Reduces values above a ceiling to the ceiling.
fn reduce_to_ceilings(
    frame: &Frame,
    model: &Model,
    policy: &Policy,
    notes: &mut Vec<String>,
) -> Frame {
    let mut sent = *frame;
    for (n, name, most) in ceilings(frame, model, policy) {
        let found = frame.float(n);
        if found.is_finite() && found > most {
            sent = sent.with(n, most);
            notes.push(format!(
                "float {n} ({name}) is {found}; the policy allows {most}, which is sent"
            ));
        }
    }
    sent
}

/// Replaces values that no table allows, but a stock arm accepts harmlessly, with equivalent ones.
fn replace_harmless_values(frame: &Frame, model: &Model, notes: &mut Vec<String>) -> Frame {
    let in_force = in_force(frame, model);
    let mut sent = *frame;
    let mut changes = Vec::new();
    // Each iteration replaces one float.
    for _ in frame.floats() {
        let Err(error) = Command::parse(&sent.into(), &model.dialect) else {
            notes.append(&mut changes);
            return sent;
        };
        let Some(leniency) = Leniency::of(&sent, &error).filter(|leniency| leniency.is_harmless)
        else {
            break;
        };
        let stand_in = leniency.stand_in(&sent, &error, &in_force);
        let what = replacement(leniency.instead, &sent, &stand_in);
        let effect = leniency.effect;
        changes.push(format!("{error}; a stock arm {effect}, and {what} is sent"));
        sent = stand_in;
    }
    // A packet that is refused anyway is refused as it came.
    *frame
}

/// Describes what is sent instead of a harmless value.
fn replacement(instead: Instead, sent: &Frame, stand_in: &Frame) -> String {
    match instead {
        Instead::Release => "a release".to_owned(),
        Instead::InForce => format!("{}, which is in force,", changed(sent, stand_in)),
        Instead::Tool => {
            let (pump, gripper) = (stand_in.float(7), stand_in.float(9));
            format!("{pump}, with {gripper} in float 9 (GripperValue), as they are,")
        }
        _ => changed(sent, stand_in),
    }
}

/// Returns the value of one of two frames at the float where they differ.
fn changed(from: &Frame, to: &Frame) -> String {
    let pairs = from.floats().iter().zip(to.floats());
    // Unused floats may be NaN.
    let mut others = pairs.filter(|(from, to)| from.to_bits() != to.to_bits());
    others
        .next()
        .map(|(_, to)| to.to_string())
        .unwrap_or_default()
}

/// Returns the values in force for the settings in a packet, each at its float.
fn in_force(frame: &Frame, model: &Model) -> Frame {
    let settings = &model.settings;
    let state = frame.float(1);
    if state == MoveTo::STATE || state == MoveJoints::STATE {
        let pump = Frame::ZERO.with(7, f32::from(model.suction));
        return pump.with(9, single(model.gripper_deg));
    }
    let configuration = |configuration: Configuration| configuration.emit(&model.dialect);
    match [state, frame.float(2)] {
        [Configuration::STATE, 0.0] => configuration(teach(&settings.teach)),
        [Configuration::STATE, 1.0] => Frame::ZERO.with(9, single(settings.default_pause_s)),
        [PlaybackAdjustment::STATE, _] => Frame::ZERO.with(5, single(settings.teach_percent)),
        _ => Frame::ZERO,
    }
}

/// Returns the floats of a packet that have a ceiling: number, name and the policy's maximum.
fn ceilings(frame: &Frame, model: &Model, policy: &Policy) -> Vec<(usize, &'static str, f32)> {
    let (settings, dialect) = (&model.settings, &model.dialect);
    let speeds = Speeds {
        joint_deg_s: policy.speed.joint_deg_s,
        joint_deg_s2: policy.acceleration.joint_deg_s2,
        servo_deg_s: policy.speed.servo_deg_s,
        servo_deg_s2: policy.acceleration.servo_deg_s2,
        line_mm_s: policy.speed.line_mm_s,
        line_mm_s2: policy.acceleration.line_mm_s2,
    };
    let share = |percent: f64| 1e4 / percent;
    let named = |names: &[&'static str], most: &Frame| {
        let named = (3..).zip(names);
        named.map(|(n, name)| (n, *name, most.float(n))).collect()
    };
    match [frame.float(1), frame.float(2)] {
        [JointJog::STATE | LinearJog::STATE, _] => {
            vec![(8, "StarVel", single(policy.speed.jog_percent))]
        }
        // A slower laser burns deeper than intended.
        [WriteVector::STATE, _] if frame.float(7) == 0.0 => {
            vec![(10, "MaxVel", single(policy.speed.writing_mm_s))]
        }
        [Configuration::STATE, 0.0] => {
            let most = speeds.scaled(share(policy.speed.jog_percent), 100.0);
            named(TEACH, &teach(&most).emit(dialect))
        }
        [Configuration::STATE, 1.0] => {
            let percent = [settings.speed_percent, settings.acceleration_percent];
            let most = speeds.scaled(share(percent[0]), share(percent[1]));
            named(
                PLAYBACK,
                &playback(&most, policy.jump.height_mm).emit(dialect),
            )
        }
        [Configuration::STATE, 2.0] => {
            let most = writing(policy.acceleration.writing_mm_s2);
            named(WRITING, &most.emit(dialect))
        }
        [PlaybackAdjustment::STATE, 0.0] => {
            let most = percentages(&settings.playback, &speeds);
            named(percentage_names(dialect), &most.emit(dialect))
        }
        _ => Vec::new(),
    }
}

/// Returns the percentages at which targets are as fast as the policy allows.
fn percentages(playback: &Speeds, ceilings: &Speeds) -> PlaybackAdjustment {
    let percent = |ways: [(f64, f64); 3]| {
        let shares = ways.map(|(most, full)| most / full * 100.0);
        single(shares.into_iter().fold(100.0, f64::min))
    };
    PlaybackAdjustment {
        speed_percent: percent([
            (ceilings.joint_deg_s, playback.joint_deg_s),
            (ceilings.servo_deg_s, playback.servo_deg_s),
            (ceilings.line_mm_s, playback.line_mm_s),
        ]),
        acceleration_percent: percent([
            (ceilings.joint_deg_s2, playback.joint_deg_s2),
            (ceilings.servo_deg_s2, playback.servo_deg_s2),
            (ceilings.line_mm_s2, playback.line_mm_s2),
        ]),
        teach_speed_percent: f32::INFINITY,
    }
}

/// Table 3.9, state 10.
const fn percentage_names(dialect: &Dialect) -> &'static [&'static str] {
    if dialect.adjusts_speed_first {
        &["playback speed", "playback acceleration"]
    } else {
        &["playback acceleration", "playback speed"]
    }
}

fn teach(speeds: &Speeds) -> Configuration {
    Configuration::teach(speeds.numbers().map(single))
}

fn playback(speeds: &Speeds, jump_height_mm: f64) -> Configuration {
    let speeds = speeds.numbers().map(single);
    Configuration::playback(speeds, f32::INFINITY, single(jump_height_mm))
}

fn writing(acceleration_mm_s2: f64) -> Configuration {
    Configuration::Writing {
        acceleration_mm_s2: single(acceleration_mm_s2),
    }
}

/// Table 3.9, mode 0.
const TEACH: &[&str] = &[
    "joint jog speed",
    "joint jog acceleration",
    "joint 4 speed",
    "joint 4 acceleration",
    "linear jog speed",
    "linear jog acceleration",
];
/// Table 3.9, mode 1.
const PLAYBACK: &[&str] = &[
    "max joint moving speed",
    "max joint moving acceleration",
    "max servo speed",
    "max servo acceleration",
    "max linear moving speed",
    "max linear moving acceleration",
    "default pause time",
    "JUMP height",
];
/// Table 3.9, mode 2.
const WRITING: &[&str] = &["writing acceleration"];

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests;
