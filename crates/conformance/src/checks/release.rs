//! Releases that are not like their press: of the other kind of jog, or with other settings in
//! between (notes N13 and N44).

use dobot_arm::{FOREARM, REAR_ARM};
use dobot_wire::{Frame, Status, single};

use crate::checks::settings::reach_of;
use crate::observed_motion::PERIOD_S;
use crate::outcome::Outcome;
use crate::packet::{configuration, jog};
use crate::rig::{CheckError, Rig};
use crate::timed_status::TimedStatus;

/// A joint jog that a linear release ends, and the other way round. By the document it runs down
/// where it is; a stock arm runs down the axis of the same number there, Z for the forearm, with the
/// acceleration of the button that was held.
pub(crate) async fn other_kind(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let home = rig.home()?;
    if home.fore_deg.abs() < LEVEL_DEG {
        return Ok(Outcome::NotTried(format!(
            "the forearm is nearly level, at {:.1} degrees: the effect of Z cannot be measured there",
            home.fore_deg
        )));
    }
    rig.send(ramps([MAX, SLOW], [MAX, FAST])).await?;
    let joint = press(rig, [2.0, FORE_MINUS], 7.0).await?;
    rig.go_home().await?;
    rig.send(ramps([MAX, FAST], [MAX, SLOW])).await?;
    let line = press(rig, [7.0, Z_PLUS], 2.0).await?;
    rig.settings().await?;
    let (Some(joint), Some(line)) = (joint, line) else {
        return Ok(Outcome::Differs(
            "the arm kept moving after the release".into(),
        ));
    };
    let run_down_mm = joint.z_mm - z_at(&home, &joint);
    let run_down_deg = line.fore_deg - fore_at(&home, &line);
    let same = (joint.rear_deg - home.rear_deg).abs() < STRAY
        && joint.fore_deg < home.fore_deg - LEAST
        && (reach_of(&line) - reach_of(&home)).abs() < f64::from(STRAY)
        && line.z_mm > home.z_mm + LEAST;
    let is = |found: f32, expected: f32| (found - expected).abs() < SLACK;
    let other = is(run_down_mm, -RUN_DOWN) && is(run_down_deg, RUN_DOWN);
    Ok(Outcome::vote(
        same,
        other,
        if same {
            "whichever kind it is, it ends the jog where it is".to_owned()
        } else {
            format!(
                "Z runs down {run_down_mm:.2} mm behind the forearm, the forearm {run_down_deg:.2} \
                 degrees behind Z; -{RUN_DOWN} and {RUN_DOWN} on a stock arm"
            )
        },
    ))
}

/// Another acceleration (9/0) between press and release: the run-down keeps that of the press. By the
/// document it begins with the setting, on a stock arm, which stops dead there, with the release.
pub(crate) async fn other_settings(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let start = rig.settled().await?;
    rig.send(servo_ramp(SLOW_SERVO)).await?;
    let mark = rig.seen.len();
    rig.send(jog(2.0, SERVO_PLUS, PERCENT)).await?;
    rig.pass(HOLD_SERVO_MS).await?;
    rig.send(servo_ramp(FAST)).await?;
    rig.expect_later(RUN_DOWN_MS);
    if !rig.stands().await? {
        rig.stop_jog().await?;
    }
    let stopped = rig.settled().await?;
    let braked = braked_deg(&rig.seen[mark..]);
    rig.send(jog(2.0, 0.0, 0.0)).await?;
    let end = rig.settled().await?;
    rig.settings().await?;
    let jogged = stopped.servo_deg - start.servo_deg > LEAST;
    let after = end.servo_deg - stopped.servo_deg;
    let specification = after.abs() < STRAY && (0.6..1.4).contains(&braked);
    let firmware = (after - RUN_DOWN_SERVO).abs() < SLACK;
    Ok(Outcome::vote(
        jogged && specification,
        jogged && firmware,
        format!(
            "it runs down {braked:.2} degrees at the setting and {after:.2} at the release; \
             {RUN_DOWN_SERVO} in all at the acceleration of the press"
        ),
    ))
}

/// Presses a button until full speed and releases it with a state; returns the status at rest.
async fn press(
    rig: &mut Rig,
    [state, button]: [f32; 2],
    by: f32,
) -> Result<Option<Status>, CheckError> {
    rig.send(jog(state, button, PERCENT)).await?;
    rig.pass(HOLD_MS).await?;
    rig.send(jog(by, 0.0, 0.0)).await?;
    rig.expect_later(RUN_DOWN_MS);
    let stands = rig.stands().await?;
    if !stands {
        rig.stop_jog().await?;
    }
    let there = rig.settled().await?;
    Ok(stands.then_some(there))
}

/// The height after a motion of the forearm alone, for the reach of a status.
fn z_at(home: &Status, there: &Status) -> f32 {
    let before = f64::from(home.fore_deg).to_radians();
    let cosine = before.cos() + (reach_of(there) - reach_of(home)) / FOREARM.0;
    let after = cosine.acos().copysign(before);
    single(f64::from(home.z_mm) + FOREARM.0 * (before.sin() - after.sin()))
}

/// The angle of the forearm that keeps the reach, for the rear arm's angle of a status.
fn fore_at(home: &Status, there: &Status) -> f32 {
    let [rear, now, fore] =
        [home.rear_deg, there.rear_deg, home.fore_deg].map(|angle| f64::from(angle).to_radians());
    let cosine = fore.cos() + (rear.sin() - now.sin()) * REAR_ARM.0 / FOREARM.0;
    single(cosine.acos().copysign(fore).to_degrees())
}

/// The motion of the servo after the last status at full speed.
fn braked_deg(seen: &[TimedStatus]) -> f32 {
    let full = SPEED_SERVO * single(PERIOD_S) * 0.9;
    let steps = seen.windows(2);
    let mut at_speed =
        steps.filter(|pair| pair[1].status.servo_deg - pair[0].status.servo_deg >= full);
    let (from, end) = (at_speed.next_back().map(|it| it[1]), seen.last());
    let way = from.zip(end.copied());
    way.map_or(0.0, |(from, end)| {
        end.status.servo_deg - from.status.servo_deg
    })
}

/// Teach configuration: speed and acceleration of joints and of lines.
fn ramps(joint: [f32; 2], line: [f32; 2]) -> Frame {
    configuration(0.0, &[joint[0], joint[1], 30.0, 50.0, line[0], line[1]])
}

/// Teach configuration with this acceleration of the servo.
fn servo_ramp(acceleration: f32) -> Frame {
    let speed = SPEED_SERVO * 100.0 / PERCENT;
    configuration(0.0, &[15.0, 50.0, speed, acceleration, 60.0, 60.0])
}

const FORE_MINUS: f32 = 6.0;
const Z_PLUS: f32 = 5.0;
const SERVO_PLUS: f32 = 7.0;
const PERCENT: f32 = 20.0;
/// At 20 % of it a jog goes 3 degrees/s or mm/s.
const MAX: f32 = 15.0;
/// Degrees/s2 or mm/s2 of the button that is held, and of what must not be taken instead.
const SLOW: f32 = 10.0;
const FAST: f32 = 80.0;
/// Degrees or millimetres in which a stock arm comes to rest then: 15 ticks with 0.2 less in each
/// (note N44).
const RUN_DOWN: f32 = 0.42;
/// The same of the servo: 4 degrees/s with 8 degrees/s2.
const SPEED_SERVO: f32 = 4.0;
const SLOW_SERVO: f32 = 8.0;
const RUN_DOWN_SERVO: f32 = 0.96;
/// Long enough to reach full speed.
const HOLD_MS: u64 = 500;
const HOLD_SERVO_MS: u64 = 800;
/// The longest time until it is at rest.
const RUN_DOWN_MS: u64 = 500;
/// The smallest motion of an effective press.
const LEAST: f32 = 0.3;
const STRAY: f32 = 0.02;
/// A tick more or less of the run-down, and rounding.
const SLACK: f32 = 0.1;
/// Near to level a change of reach says too little of the forearm.
const LEVEL_DEG: f32 = 4.0;
