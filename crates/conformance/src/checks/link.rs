//! Checks of the line before anything is sent.

use std::time::Duration;

use dobot_arm::{Degrees, Joints, Limits, Pose, Position, Tool, inverse};
use dobot_wire::{PACKET_LEN, Status};

use crate::blocker::Blocker;
use crate::observed_motion::PERIOD_S;
use crate::outcome::Outcome;
use crate::rig::{CheckError, Rig, disagreement, joints, lenient, tool_of, turned};
use crate::timed_status::TimedStatus;

/// Receives and counts bytes that do not belong to statuses.
pub(crate) async fn form(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let began = rig.now();
    while rig.seen.is_empty() && rig.now() < began + FIRST_STATUS {
        rig.pass(LISTEN_MS / 8).await?;
    }
    rig.pass(LISTEN_MS).await?;
    let bytes = rig.raw.len();
    if bytes == 0 {
        return Ok(Outcome::Differs("nothing was received".into()));
    }
    let lenient = lenient(&rig.raw).len() as u64;
    let counts = rig.counts();
    // Whoever joins a stream in the middle skips the rest of one packet.
    let stray = counts.skipped_bytes.saturating_sub(PACKET_LEN as u64);
    let found = format!("{lenient} statuses, {stray} other bytes of {bytes}");
    Ok(Outcome::of(
        lenient > 0 && (stray == 0 || counts.frames < lenient),
        found,
    ))
}

/// The mean time between two statuses; over Bluetooth between two messages, and between two permits,
/// which come half as often (note N38).
pub(crate) fn period(rig: &Rig) -> Outcome {
    if rig.seen.is_empty() {
        return Outcome::NotTried("no trustworthy status was received".into());
    }
    let regular = spacing(&rig.seen, PERIOD_MS);
    if !rig.is_bluetooth() {
        return regular;
    }
    let permits = spacing(&rig.permits, 2.0 * PERIOD_MS);
    let found = format!(
        "over Bluetooth: messages {}; permits {}",
        regular.found(),
        permits.found()
    );
    match [regular, permits] {
        [Outcome::Holds(_), Outcome::Holds(_)] => Outcome::Holds(found),
        [Outcome::Differs(_), _] | [_, Outcome::Differs(_)] => Outcome::Differs(found),
        _ => Outcome::Unsteady(found),
    }
}

/// Whether statuses come with this period.
fn spacing(seen: &[TimedStatus], period_ms: f64) -> Outcome {
    let steps = u32::try_from(seen.len().saturating_sub(1)).unwrap_or(u32::MAX);
    let (Some(first), Some(last), FEW..) = (seen.first(), seen.last(), steps) else {
        return Outcome::Differs(format!("only {} statuses were received", seen.len()));
    };
    let total = last.at.saturating_sub(first.at);
    let spans = sorted_spans_ms(seen);
    let at = |share: usize| spans.get(share).copied().unwrap_or_default();
    let (least, middle, most) = (at(0), at(spans.len() / 2), at(spans.len() - 1));
    let mean_ms = ms(total / steps);
    let found = format!("{mean_ms:.1} ms on average of {steps}, {least:.0} to {most:.0}");
    let is_period = |ms: f64| (ms - period_ms).abs() <= TOLERANCE_MS;
    if is_period(mean_ms) {
        return Outcome::Holds(found);
    }
    // Most of them come in time, and the others by whole periods late: some did not come at all.
    let due = (ms(total) / period_ms).round();
    let missing = due - f64::from(steps);
    let is_usual = (middle - period_ms).abs() <= BEHIND_PERMIT_MS;
    if is_usual && missing > 0.0 && is_period(ms(total) / due) {
        return Outcome::Unsteady(format!(
            "{missing:.0} of {due:.0} are missing, the others every {middle:.1} ms: lost on the line?"
        ));
    }
    Outcome::Differs(found)
}

fn sorted_spans_ms(seen: &[TimedStatus]) -> Vec<f64> {
    let pairs = seen.windows(2);
    let spans = pairs.map(|it| ms(it[1].at.saturating_sub(it[0].at)));
    let mut spans: Vec<f64> = spans.collect();
    spans.sort_by(f64::total_cmp);
    spans
}

/// Whether position and angles agree, over all statuses.
pub(crate) fn pose(rig: &Rig) -> Outcome {
    let statuses = lenient(&rig.raw);
    // The very first one over Bluetooth has angles alone (note N38).
    let incomplete = statuses
        .first()
        .filter(|status| rig.is_bluetooth() && [status.x_mm, status.y_mm, status.z_mm] == [0.0; 3]);
    let worst = statuses
        .iter()
        .skip(usize::from(incomplete.is_some()))
        .map(disagreement)
        .fold(0.0_f64, f64::max);
    if rig.seen.is_empty() && worst == 0.0 {
        return Outcome::NotTried("no status was received".into());
    }
    let found = format!("off by up to {worst:.4} mm or degrees; 0.01 is allowed");
    Outcome::of(worst <= AGREED, found)
}

/// Whether the arm is at rest, within its limits and with room for the checks.
pub(crate) fn start(rig: &mut Rig) -> Outcome {
    let (Some(first), Some(TimedStatus { status, .. })) = (rig.seen.first(), rig.seen.last())
    else {
        return Outcome::NotTried("no trustworthy status was received".into());
    };
    let turned = turned(&first.status, status);
    if turned > 0.01 {
        return Outcome::Differs(format!("it moves: by {turned:.2} degrees"));
    }
    let status = *status;
    let tool = tool_of(&status);
    if let Err(error) = Limits::STOCK.check(&joints(&status), tool) {
        return Outcome::Differs(error.to_string());
    }
    rig.start = Some(status);
    let Joints {
        base, rear, fore, ..
    } = joints(&status);
    Outcome::Holds(format!(
        "base {:.1}, rear {:.1}, fore {:.1} degrees",
        base.0, rear.0, fore.0
    ))
}

/// The reason not to move the arm from its position.
pub(crate) fn blocker(start: &Status) -> Option<Blocker> {
    if start.suction {
        return Some(Blocker::Pump);
    }
    cramped(start).map(Blocker::Cramped)
}

/// The reason why the arm has too little room: the checks move by up to 10 mm and 5 degrees, and jump
/// up to 9 mm higher.
fn cramped(start: &Status) -> Option<String> {
    let tool = tool_of(start);
    let Joints {
        base, rear, fore, ..
    } = joints(start);
    let room = |name, value: f64, min, max| {
        let inside = value >= min && value <= max;
        (!inside).then(|| format!("{name} is {value:.1} degrees; the checks need {min} to {max}"))
    };
    let joints = room("base", base.0, -170.0, 170.0)
        .or_else(|| room("rear arm", rear.0, 0.0, 80.0))
        .or_else(|| room("forearm", fore.0, -5.0, 90.0))
        .or_else(|| room("servo", start.servo_deg.into(), -80.0, 80.0))
        .or_else(|| room("gripper", start.gripper_deg.into(), -80.0, 80.0));
    joints.or_else(|| corners(start).find_map(|position| near_limit(position, tool)))
}

fn near_limit(position: Position, tool: Tool) -> Option<String> {
    let pose = Pose {
        position,
        ..Pose::default()
    };
    let joints = inverse(&pose, tool);
    let joints = joints.map(|it| Joints {
        servo: Degrees(0.0),
        ..it
    });
    let checked = joints.and_then(|it| Limits::STOCK.check_at(&it, position));
    let error = checked.err()?;
    Some(format!("too near to a limit: {error}"))
}

/// The corners of the space needed by the checks.
fn corners(start: &Status) -> impl Iterator<Item = Position> {
    let at = dobot_session::position(start);
    let sides = [-ROOM_MM, ROOM_MM];
    sides.into_iter().flat_map(move |x| {
        sides
            .into_iter()
            .flat_map(move |y| [0.0, ABOVE_MM].map(move |z| at + Position::new(x, y, z)))
    })
}

fn ms(span: Duration) -> f64 {
    span.as_secs_f64() * 1000.0
}

/// A stock arm ignores bytes for up to two seconds after its port is opened (note N35).
const FIRST_STATUS: Duration = Duration::from_secs(5);
const LISTEN_MS: u64 = 2700;
/// The smallest number of times between statuses for a mean.
const FEW: u32 = 10;
const PERIOD_MS: f64 = PERIOD_S * 1000.0;
const TOLERANCE_MS: f64 = 2.0;
/// How late a status may be because the one before it is still on the line: over Bluetooth the message
/// behind a permit is, by 7.5 ms at 9600 baud.
const BEHIND_PERMIT_MS: f64 = 10.0;
/// Note N22, per coordinate; the distance of all three may be a bit more.
const AGREED: f64 = 0.0174;
/// The range of the checks around the start.
const ROOM_MM: f64 = 12.0;
const ABOVE_MM: f64 = 28.0;
