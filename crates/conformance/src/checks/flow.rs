//! Flow control: one run with a queue that is full, evaluated in four ways.

use std::time::Duration;

use dobot_arm::Position;
use dobot_session::position;
use dobot_wire::Status;

use crate::flow::{BLOCKER, Flow, NEAR_MM, STEPS};
use crate::observed_motion::off_segment;
use crate::outcome::Outcome;
use crate::packet::vector;
use crate::rig::{CheckError, Rig};

/// Sends a slow vector and eight more, and checks that statuses are withheld; over Bluetooth those that
/// permit a command.
pub(crate) async fn silence(rig: &mut Rig) -> Result<Outcome, CheckError> {
    let home = rig.home()?;
    let marks = [rig.seen.len(), rig.permits.len()];
    rig.send(vector(BLOCKER, 0.0, 3.0)).await?;
    for step in STEPS {
        rig.send(vector(step, 0.0, 10.0)).await?;
    }
    let end = rig.settled().await?;
    let flow = Flow {
        home: position(&home),
        seen: rig.seen[marks[0]..].to_vec(),
        permits: rig.permits[marks[1]..].to_vec(),
        end,
    };
    let (_, gap) = flow.longest_gap();
    rig.flow = Some(flow);
    Ok(Outcome::of(
        gap > SILENT,
        format!("no {} for {:.2} s", withheld(rig), gap.as_secs_f64()),
    ))
}

/// The position of the arm when statuses resume.
pub(crate) fn again(rig: &Rig) -> Outcome {
    let Some(flow) = &rig.flow else {
        return untried();
    };
    let (after, gap) = flow.longest_gap();
    let (Some(first), true) = (flow.permits.get(after), gap > SILENT) else {
        return Outcome::NotTried(format!("each {} was sent in time", withheld(rig)));
    };
    let corners = flow.corners(&[0, 1, 2, 3, 4, 5]);
    let (step, off) = nearest(&corners, &first.status);
    // Side 0 is that of the slow vector, side 3 that of the third after it. Over USB three of six wait
    // behind that one; over Bluetooth, where five may, they wait behind the first.
    let expected = if rig.is_bluetooth() { [1, 2] } else { [3, 4] };
    Outcome::of(
        off < NEAR_MM && expected.contains(&step),
        match step {
            0 => "while the first command runs".to_owned(),
            _ => format!("with command {step} of those that waited, {off:.2} mm off its path"),
        },
    )
}

/// The executed commands of the eight.
pub(crate) fn six(rig: &Rig) -> Outcome {
    let Some(flow) = &rig.flow else {
        return untried();
    };
    match flow.done() {
        Some(done) => Outcome::of(
            done == [0, 1, 2, 3, 4, 5],
            format!(
                "of eight after the running one, {} were executed",
                list(&done)
            ),
        ),
        None => Outcome::Differs(
            "the arm stopped at a point that no subset of the eight leads to".into(),
        ),
    }
}

/// Whether the statuses lie on the way of what was done, in order.
pub(crate) fn order(rig: &Rig) -> Outcome {
    let Some(flow) = &rig.flow else {
        return untried();
    };
    let Some(done) = flow.done() else {
        return Outcome::NotTried("the executed commands are unknown".into());
    };
    let corners = flow.corners(&done);
    let places = flow.seen.iter().map(|it| nearest(&corners, &it.status));
    let (steps, offs): (Vec<_>, Vec<_>) = places.unzip();
    let worst = offs.into_iter().fold(0.0, f64::max);
    Outcome::of(
        worst < NEAR_MM && steps.is_sorted(),
        format!("statuses are up to {worst:.3} mm off the path"),
    )
}

/// The last of the sides of a way that are nearest to a status, and how far it is: a corner is the
/// beginning of a side.
fn nearest(corners: &[Position], status: &Status) -> (usize, f64) {
    let sides = corners
        .windows(2)
        .map(|it| off_segment(it[0], it[1], status));
    let mut best = (0, f64::MAX);
    for (side, off) in sides.enumerate() {
        if off < best.1 + CORNER_MM {
            best = (side, off.min(best.1));
        }
    }
    best
}

fn list(done: &[usize]) -> String {
    if done.is_empty() {
        return "none".into();
    }
    let numbers: Vec<_> = done.iter().map(|n| (n + 1).to_string()).collect();
    numbers.join(", ")
}

/// What is withheld while the queue is full.
fn withheld(rig: &Rig) -> &'static str {
    if rig.is_bluetooth() {
        "permit"
    } else {
        "status"
    }
}

fn untried() -> Outcome {
    Outcome::NotTried("the queue was not filled".into())
}

const CORNER_MM: f64 = 0.005;
const SILENT: Duration = Duration::from_millis(600);
