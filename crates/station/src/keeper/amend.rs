//! Settings of old programs that a stock arm takes harmlessly, though a table or the policy does not allow
//! them: sent with what is in force, or with the ceiling, instead of being refused as a whole.

use dobot_course::Settings;
use dobot_motion::Speeds;
use dobot_safety::Policy;
use dobot_wire::{Configuration, Dialect, Frame, Packet, PlaybackAdjustment};

/// A packet of settings (states 9 and 10) as it may be sent, and what was changed, in one line; `None`
/// where nothing was.
pub(super) fn amended(
    packet: &Packet,
    settings: &Settings,
    dialect: &Dialect,
    policy: &Policy,
) -> Option<(Packet, String)> {
    let Packet::Frame(frame) = packet else {
        return None;
    };
    let floats = Floats::of(frame, settings, dialect, policy)?;
    let mut sent = *frame;
    let mut told = Vec::new();
    for (n, name) in (3..).zip(floats.names) {
        let found = frame.float(n);
        let (in_force, most) = (floats.in_force.float(n), floats.most.float(n));
        // Of the others 0 would stop the arm for good.
        let is_zero = found == 0.0 && (TEACH.contains(name) || *name == TEACHING_SPEED);
        let value = if is_zero { in_force } else { found };
        if value.is_finite() && value > most {
            sent = sent.with(n, most);
            told.push(format!(
                "float {n} ({name}) is {found}; the policy allows {most}, which is sent"
            ));
        } else if is_zero {
            sent = sent.with(n, value);
            told.push(format!(
                "float {n} ({name}) is 0; {value}, which is in force, is sent"
            ));
        }
    }
    (!told.is_empty()).then(|| {
        let state = frame.float(1);
        (sent.into(), format!("state {state}: {}", told.join("; ")))
    })
}

/// What the floats of a packet, from the third on, are called, what is in force, and the most that the
/// policy allows.
struct Floats {
    names: &'static [&'static str],
    in_force: Frame,
    most: Frame,
}

impl Floats {
    fn of(frame: &Frame, settings: &Settings, dialect: &Dialect, policy: &Policy) -> Option<Self> {
        let ceilings = Speeds {
            joint_deg_s: policy.speed.joint_deg_s,
            joint_deg_s2: policy.acceleration.joint_deg_s2,
            servo_deg_s: policy.speed.servo_deg_s,
            servo_deg_s2: policy.acceleration.servo_deg_s2,
            line_mm_s: policy.speed.line_mm_s,
            line_mm_s2: policy.acceleration.line_mm_s2,
        };
        let floats = |names, in_force: Frame, most: Frame| Self {
            names,
            in_force,
            most,
        };
        let configurations = |names, in_force: Configuration, most: Configuration| {
            floats(names, in_force.emit(dialect), most.emit(dialect))
        };
        let share = |percent: f64| 1e4 / percent;
        let state_and_mode = [frame.float(1), frame.float(2)];
        if state_and_mode == [PlaybackAdjustment::STATE, 0.0] {
            let (in_force, most) = adjustments(settings, &ceilings);
            let names: &[_] = if dialect.adjusts_speed_first {
                &["playback speed", "playback acceleration", TEACHING_SPEED]
            } else {
                &["playback acceleration", "playback speed", TEACHING_SPEED]
            };
            return Some(floats(names, in_force.emit(dialect), most.emit(dialect)));
        }
        if state_and_mode == [Configuration::STATE, 0.0] {
            let most = ceilings.scaled(share(policy.speed.jog_percent), 100.0);
            return Some(configurations(TEACH, teach(&settings.teach), teach(&most)));
        }
        if state_and_mode == [Configuration::STATE, 1.0] {
            let most = ceilings.scaled(
                share(settings.speed_percent),
                share(settings.acceleration_percent),
            );
            let in_force = playback(&settings.playback, settings.jump_height.0);
            return Some(configurations(
                PLAYBACK,
                in_force,
                playback(&most, policy.jump.height_mm),
            ));
        }
        if state_and_mode == [Configuration::STATE, 2.0] {
            return Some(configurations(
                WRITING,
                writing(settings.write_acceleration_mm_s2),
                writing(policy.acceleration.writing_mm_s2),
            ));
        }
        None
    }
}

/// The percentages of targets in force, and those with which they are as fast as the policy allows.
fn adjustments(settings: &Settings, ceilings: &Speeds) -> (PlaybackAdjustment, PlaybackAdjustment) {
    let playback = &settings.playback;
    let percent = |ways: [(f64, f64); 3]| {
        let shares = ways.map(|(most, full)| most / full * 100.0);
        shares.into_iter().fold(100.0, f64::min)
    };
    let speed_percent = percent([
        (ceilings.joint_deg_s, playback.joint_deg_s),
        (ceilings.servo_deg_s, playback.servo_deg_s),
        (ceilings.line_mm_s, playback.line_mm_s),
    ]);
    let acceleration_percent = percent([
        (ceilings.joint_deg_s2, playback.joint_deg_s2),
        (ceilings.servo_deg_s2, playback.servo_deg_s2),
        (ceilings.line_mm_s2, playback.line_mm_s2),
    ]);
    (
        PlaybackAdjustment {
            speed_percent: single(settings.speed_percent),
            acceleration_percent: single(settings.acceleration_percent),
            teach_speed_percent: single(settings.teach_percent),
        },
        PlaybackAdjustment {
            speed_percent: single(speed_percent),
            acceleration_percent: single(acceleration_percent),
            teach_speed_percent: f32::INFINITY,
        },
    )
}

fn teach(speeds: &Speeds) -> Configuration {
    Configuration::Teach {
        joint_speed_deg_s: single(speeds.joint_deg_s),
        joint_acceleration_deg_s2: single(speeds.joint_deg_s2),
        servo_speed_deg_s: single(speeds.servo_deg_s),
        servo_acceleration_deg_s2: single(speeds.servo_deg_s2),
        linear_speed_mm_s: single(speeds.line_mm_s),
        linear_acceleration_mm_s2: single(speeds.line_mm_s2),
    }
}

fn playback(speeds: &Speeds, jump_height_mm: f64) -> Configuration {
    Configuration::Playback {
        joint_speed_deg_s: single(speeds.joint_deg_s),
        joint_acceleration_deg_s2: single(speeds.joint_deg_s2),
        servo_speed_deg_s: single(speeds.servo_deg_s),
        servo_acceleration_deg_s2: single(speeds.servo_deg_s2),
        linear_speed_mm_s: single(speeds.line_mm_s),
        linear_acceleration_mm_s2: single(speeds.line_mm_s2),
        default_pause_s: f32::INFINITY,
        jump_height_mm: single(jump_height_mm),
    }
}

fn writing(acceleration_mm_s2: f64) -> Configuration {
    Configuration::Writing {
        acceleration_mm_s2: single(acceleration_mm_s2),
    }
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "a packet carries single precision"
)]
const fn single(value: f64) -> f32 {
    value as f32
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
const TEACHING_SPEED: &str = "teaching speed";

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests;
