//! The number of ticks of a move, counted between the starts of two moves, which statuses show exactly.

use std::time::Duration;

use crate::observed_motion::periods;
use crate::outcome::Outcome;
use crate::packet::{JUMP_MM, angles, playback};
use crate::rig::{CheckError, Rig};
use crate::timed_status::TimedStatus;
use dobot_arm::TICK_S;
use dobot_wire::{Status, single};

/// A turn of the base whose time is whole ticks but for rounding, and one back that waits for it. By
/// the document the second begins in that very moment. A stock arm, which calculates in single
/// precision, takes one tick more, and one to notice the end (note N45).
pub(crate) async fn whole(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let Some(mode) = rig.joint_mode else {
        return Ok(Outcome::NotTried("the joint mode is unknown".into()));
    };
    let home = rig.settled().await?;
    let Some((ticks, base_deg)) = turn(home.base_deg) else {
        return Ok(Outcome::NotTried(format!(
            "no turn from {} degrees is rounded up to one more tick",
            home.base_deg
        )));
    };
    // Half of it: 50 %.
    rig.send(playback(
        [2.0 * SPEED, 2.0 * ACCELERATION],
        [80.0, 200.0],
        0.0,
        JUMP_MM,
    ))
    .await?;
    rig.settled().await?;
    let mark = rig.seen.len();
    for base_deg in [base_deg, home.base_deg] {
        let goal = Status { base_deg, ..home };
        rig.send(angles(&goal, mode)).await?;
    }
    rig.settled().await?;
    rig.be_gentle().await?;
    let steady = rig.latency.is_none_or(|it| it.jitter() < UNSTEADY);
    let Some(found) = apart(&rig.seen[mark..], home.base_deg, base_deg, steady) else {
        return Ok(Outcome::Differs(format!(
            "no statuses show two turns by {:.3} degrees",
            base_deg - home.base_deg
        )));
    };
    let is = |expected: u8| (found - f64::from(expected)).abs() < SLACK_TICKS;
    Ok(Outcome::vote(
        is(ticks),
        is(ticks + 2),
        format!(
            "a turn of {ticks} ticks; the next one begins {found:.2} after it, {} on a stock arm",
            ticks + 2
        ),
    ))
}

/// A turn from this angle that takes whole ticks, or a trifle less, and one more in single precision:
/// the ticks, and where it leads.
fn turn(from_deg: f32) -> Option<(u8, f32)> {
    (MIN_TICKS..=MAX_TICKS).find_map(|ticks| {
        let time_s = f64::from(ticks) * TICK_S;
        let (speed, acceleration) = (f64::from(SPEED), f64::from(ACCELERATION));
        let way = speed * (time_s - speed / acceleration);
        let nearest = single(f64::from(from_deg) + way);
        let targets = [
            nearest,
            nearest.next_down(),
            nearest.next_down().next_down(),
        ];
        let target = targets.into_iter().find(|target| {
            let way = f64::from(*target) - f64::from(from_deg);
            let exact = way / speed + speed / acceleration;
            exact <= time_s + EXACT_S && stock_ticks(*target - from_deg) == ticks + 1
        })?;
        Some((ticks, target))
    })
}

/// How many ticks a stock arm moves, calculated as it does: in single precision, in this order (note
/// N45).
fn stock_ticks(way_deg: f32) -> u8 {
    let ramps_s = 2.0 * (SPEED / ACCELERATION);
    let time_s = ramps_s + (way_deg - SPEED * SPEED / ACCELERATION) / SPEED;
    let tick_s = single(TICK_S);
    let ticks = (1..u8::MAX).find(|ticks| f32::from(*ticks) * tick_s >= time_s);
    ticks.unwrap_or(u8::MAX)
}

/// How many ticks lie between the beginnings of two turns, there and back. On a steady line the times
/// of statuses count them, else their number.
fn apart(seen: &[TimedStatus], from_deg: f32, to_deg: f32, steady: bool) -> Option<f64> {
    let gone = |it: &TimedStatus| it.status.base_deg - from_deg;
    let numbered = || seen.iter().enumerate();
    // The farthest status: before it the first turn, after it the second one.
    let (turned, _) = numbered().max_by(|(_, a), (_, b)| gone(a).total_cmp(&gone(b)))?;
    let first = numbered()
        .take(turned)
        .filter_map(|(n, it)| Some((n, since_begun(gone(it))?)))
        .next_back()?;
    let second = numbered()
        .skip(turned)
        .filter_map(|(n, it)| Some((n, since_begun(to_deg - it.status.base_deg)?)))
        .next_back()?;
    let statuses = if steady {
        periods(&seen[first.0], &seen[second.0])
    } else {
        // None of them may have got lost.
        f64::from(u32::try_from(second.0 - first.0).ok()?)
    };
    Some(statuses * TICKS_OF_STATUS - second.1 + first.1)
}

/// How many ticks ago a motion began that gathers speed and has come so far.
fn since_begun(way_deg: f32) -> Option<f64> {
    let way = f64::from(way_deg);
    let ramp = f64::from(SPEED * SPEED / ACCELERATION / 2.0);
    let ticks = (2.0 * way / f64::from(ACCELERATION)).sqrt() / TICK_S;
    (way > JUST_BEGUN_DEG && way <= ramp).then_some(ticks)
}

/// Degrees/s and degrees/s2: full speed is there after ten ticks.
const SPEED: f32 = 2.5;
const ACCELERATION: f32 = 12.5;
/// Note N20.
const TICKS_OF_STATUS: f64 = 4.0;
/// Turns of 0.7 to 1.5 degrees.
const MIN_TICKS: u8 = 24;
const MAX_TICKS: u8 = 40;
/// What counts as whole ticks.
const EXACT_S: f64 = 1e-9;
/// A stock arm moves in steps: its first few say less of when it began.
const JUST_BEGUN_DEG: f64 = 0.03;
const SLACK_TICKS: f64 = 0.3;
/// A quarter of the time between two statuses.
const UNSTEADY: Duration = Duration::from_millis(20);
