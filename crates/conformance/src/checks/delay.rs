//! The latency of the line, measured before any motion because all timeouts depend on it.

use std::time::Duration;

use dobot_wire::{Frame, PACKET_LEN, Status};

use crate::blocker::Blocker;
use crate::checks::link::blocker;
use crate::checks::settings::{reach_of, show_tool, tool_frame};
use crate::latency::{Latency, MAX_LATENCY};
use crate::observed_motion::PERIOD_S;
use crate::outcome::Outcome;
use crate::packet::jog;
use crate::rig::{ANSWER, BYTE, CheckError, Rig};
use crate::timed_status::TimedStatus;

/// A reversible change without motion that shows in the status immediately.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum VisibleChange {
    /// The end effector: X and Y change by 5.5 mm.
    Tool,
    /// The pump, for a controller that does not accept an end effector.
    Pump,
}

/// Applies and reverts a visible change a few times and measures its delay.
pub(crate) async fn measure(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let start = rig.start.ok_or(CheckError::Homeless)?;
    if let Some(why) = blocker(&start) {
        return Ok(forbidden(rig, why));
    }
    let mut answers = Vec::new();
    let mut lost = 0;
    let mut sign_used = VisibleChange::Tool;
    for sign in [VisibleChange::Tool, VisibleChange::Pump] {
        lost = 0;
        sign_used = sign;
        while answers.len() < ANSWERS && lost < MAX_LOST {
            let phase = u64::try_from(answers.len()).unwrap_or_default() * PHASE_MS;
            let changes = answers.len() % 2 == 0;
            // Once it is known, an answer that takes a second more will not come.
            let patience = answers.last().map_or(ANSWER, |it| *it + MAX_LATENCY);
            match answer(rig, sign, changes, phase, patience).await? {
                Some(answer) => answers.push(answer),
                None => lost += 1,
            }
        }
        if !answers.is_empty() {
            break;
        }
    }
    if sign_used == VisibleChange::Pump {
        rig.send(jog(2.0, PUMP_OFF, 0.0)).await?;
    }
    show_tool(rig, true).await?;
    let latency = Latency::of(&answers, jitter(&rig.seen)).ok_or(CheckError::Unanswered)?;
    rig.latency = Some(latency);
    if latency.most > MAX_LATENCY {
        return Ok(forbidden(rig, Blocker::Slow(latency.most)));
    }
    rig.settled().await?;
    Ok(match lost {
        0 => Outcome::Holds(format!("{latency}, by {} answers", answers.len())),
        _ => Outcome::Unsteady(format!(
            "{latency}; {lost} of {} commands showed no effect: lost on the line?",
            answers.len() + lost
        )),
    })
}

/// Sends one change and waits for the first status that shows it.
async fn answer(
    rig: &mut Rig,
    sign: VisibleChange,
    changes: bool,
    phase_ms: u64,
    patience: Duration,
) -> Result<Option<Duration>, CheckError> {
    // At another time between two statuses than the one before.
    rig.next_status().await?;
    rig.pass(phase_ms).await?;
    let start = rig.start.ok_or(CheckError::Homeless)?;
    let mark = rig.seen.len();
    let arrived = rig.now() + BYTE * u32::try_from(PACKET_LEN).unwrap_or(u32::MAX);
    rig.send(sign.packet(rig, changes)).await?;
    loop {
        let mut seen = rig.seen[mark..].iter();
        if let Some(seen) = seen.find(|it| sign.shows(&it.status, &start) == changes) {
            return Ok(Some(seen.at.saturating_sub(arrived)));
        }
        if rig.now() > arrived + patience {
            return Ok(None);
        }
        rig.next_status().await?;
    }
}

impl VisibleChange {
    fn packet(self, rig: &Rig, changes: bool) -> Frame {
        match self {
            Self::Tool => tool_frame(rig, !changes),
            Self::Pump => jog(2.0, if changes { PUMP_ON } else { PUMP_OFF }, 0.0),
        }
    }

    fn shows(self, status: &Status, start: &Status) -> bool {
        match self {
            Self::Tool => (reach_of(status) - reach_of(start)).abs() > 1.0,
            Self::Pump => status.suction,
        }
    }
}

/// The deviation of statuses from a period of 80 ms (note N20).
fn jitter(seen: &[TimedStatus]) -> Duration {
    let Some(first) = seen.first() else {
        return Duration::ZERO;
    };
    let delays = seen.iter().map(|it| {
        let since_s = it.at.saturating_sub(first.at).as_secs_f64() / PERIOD_S;
        // How far from the beat, in shares of it: one that is missing counts for nothing.
        since_s - since_s.round()
    });
    let (least, most) = delays.fold((0.0_f64, 0.0_f64), |(least, most), late| {
        (least.min(late), most.max(late))
    });
    Duration::from_secs_f64((most - least) * PERIOD_S)
}

fn forbidden(rig: &mut Rig, why: Blocker) -> Outcome {
    let outcome = Outcome::NotTried(why.to_string());
    rig.blocker = Some(why);
    outcome
}

/// How many answers are waited for; an even number takes the last sign back.
const ANSWERS: usize = 6;
/// What is sent at six times between two statuses meets one of them soon.
const PHASE_MS: u64 = 13;
const MAX_LOST: usize = 3;
const PUMP_ON: f32 = 9.0;
const PUMP_OFF: f32 = 10.0;
