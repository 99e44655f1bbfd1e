//! The list of checks.
//!
//! To add one, add a `Probe`, its row in [`Check::ALL`] and its line in `make`; the function in
//! `src/checks/`; its preconditions (`lacks` in `src/suite.rs`); its row in `docs/conformance.md`;
//! and a test with a controller that has exactly this fault (`tests/`).

use std::future::ready;
use std::pin::Pin;

use crate::checks::{
    delay, flow, framing, hand, jog, jump, limits, link, moves, release, settings, ticks, traps,
    write,
};
use crate::outcome::Outcome;
use crate::rig::{CheckError, Rig};

/// A check of the suite.
#[derive(Clone, Copy, Debug)]
pub struct Check {
    /// The name.
    pub id: &'static str,
    /// The title.
    pub title: &'static str,
    /// The source: a table of the published protocol or a note of `docs/protocol.md`.
    pub source: &'static str,
    /// The names of the checks that must hold first.
    pub(crate) needs: &'static [&'static str],
    pub(crate) begins: Begins,
    make: for<'r> fn(&'r mut Rig) -> PendingOutcome<'r>,
}

/// The start position of a check.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Begins {
    /// The common home position.
    AtHome,
    /// The current position.
    Anywhere,
    /// The current position, without repetition: it only receives, or a stock arm does not recover from
    /// it.
    Once,
}

/// A running check.
struct PendingOutcome<'r>(Pin<Box<dyn Future<Output = Result<Outcome, CheckError>> + 'r>>);

impl Check {
    /// All checks, in order of execution.
    pub const ALL: &[Self] = &[
        check("status-form", |rig| pending(link::form(rig)))
            .title("statuses are whole packets of ten floats")
            .by("Table 2.3")
            .needs(&[])
            .begins(Begins::Once),
        check("status-period", |rig| ready_outcome(link::period(rig)))
            .title("a status is sent every 80 ms; over Bluetooth three in 160 ms")
            .by("N20, N27, N38")
            .needs(&[])
            .begins(Begins::Once),
        check("status-pose", |rig| ready_outcome(link::pose(rig)))
            .title("position and angles of a status agree")
            .by("N22, N38")
            .needs(&[])
            .begins(Begins::Once),
        check("status-start", |rig| ready_outcome(link::start(rig)))
            .title("the arm is at rest, within its limits")
            .by("N28, N30")
            .needs(&[])
            .begins(Begins::Once),
        check("line-delay", |rig| pending(delay::measure(rig)))
            .title("the line is fast enough: round-trip time")
            .by("N20, N41")
            .needs(&["status-form", "status-pose", "status-start"])
            .begins(Begins::Once),
        check("move-point", |rig| pending(moves::lift(rig)))
            .title("moves to a point: 10 mm up (state 3)")
            .by("Table 3.7")
            .needs(&["line-delay"])
            .begins(Begins::Anywhere),
        check("set-tool", |rig| pending(settings::tool(rig)))
            .title("accepts an end effector (9/4)")
            .by("Table 3.9, N32"),
        check("frame-noise", |rig| pending(framing::noise(rig)))
            .title("skips noise before a packet")
            .by("N24")
            .needs(TOOL_SHOWS),
        check("frame-tail", |rig| pending(framing::tail(rig)))
            .title("ignores a packet with a wrong tail")
            .by("Table 2.1")
            .needs(TOOL_SHOWS),
        check("frame-pieces", |rig| pending(framing::pieces(rig)))
            .title("accepts a packet in two pieces")
            .by("Table 2.1")
            .needs(TOOL_SHOWS),
        check("frame-truncated", |rig| pending(framing::truncated(rig)))
            .title("resynchronises after half a packet")
            .by("N24")
            .needs(TOOL_SHOWS),
        check("frame-pair", |rig| pending(framing::pair(rig)))
            .title("accepts two packets without a gap")
            .by("N26")
            .needs(TOOL_SHOWS),
        check("move-modes", |rig| pending(moves::modes(rig)))
            .title("MovingMode 1 and 2: one straight, one by joints")
            .by("Table 3.7, N2"),
        check("move-jump", |rig| pending(jump::lifts(rig)))
            .title("MovingMode 0: up, across, down")
            .by("Table 3.7, N11"),
        check("jump-across", |rig| pending(jump::across(rig)))
            .title("MovingMode 0 between different heights: traverse")
            .by("N11, N45")
            .needs(&["move-point", "move-jump"]),
        check("move-joints", |rig| pending(moves::joints(rig)))
            .title("moves to joint angles (state 6)")
            .by("Table 3.7, N19"),
        check("move-ticks", |rig| pending(ticks::whole(rig)))
            .title("a move of whole ticks: start of the next move")
            .by("N29, N45"),
        check("move-pause", |rig| pending(moves::pause(rig)))
            .title("pauses after a move for the given time")
            .by("Table 3.7, N10"),
        check("default-pause", |rig| pending(moves::default_pause(rig)))
            .title("the default pause of 9/1")
            .by("Table 3.9, N10"),
        check("move-tool", |rig| pending(moves::tool(rig)))
            .title("sets pump and gripper after a move")
            .by("Table 3.7, N21"),
        check("flow-silence", |rig| pending(flow::silence(rig)))
            .title("no status while four commands wait; over Bluetooth no permit while six do")
            .by("N20, N38"),
        check("flow-again", |rig| ready_outcome(flow::again(rig)))
            .title("statuses resume when three wait; over Bluetooth permits when five do")
            .by("N20, N38")
            .begins(Begins::Anywhere),
        check("flow-six", |rig| ready_outcome(flow::six(rig)))
            .title("six commands wait, a seventh does not")
            .by("N20")
            .begins(Begins::Anywhere),
        check("flow-order", |rig| ready_outcome(flow::order(rig)))
            .title("waiting commands are executed in order")
            .by("N20")
            .begins(Begins::Anywhere),
        check("jog-release", |rig| pending(jog::release(rig)))
            .title("a released button stops the jog")
            .by("Table 2.5, N13"),
        check("jog-base", |rig| pending(jog::axis(rig, jog::BASE)))
            .title("joint jog 1, 2: base (state 2)")
            .by("Table 2.5, N38")
            .needs(JOG_STOPS),
        check("jog-rear", |rig| pending(jog::axis(rig, jog::REAR)))
            .title("joint jog 3, 4: rear arm")
            .by("Table 2.5, N38")
            .needs(JOG_STOPS),
        check("jog-fore", |rig| pending(jog::axis(rig, jog::FORE)))
            .title("joint jog 5, 6: forearm")
            .by("Table 2.5, N38")
            .needs(JOG_STOPS),
        check("jog-servo", |rig| pending(jog::axis(rig, jog::SERVO)))
            .title("joint jog 7, 8: servo")
            .by("Table 2.5")
            .needs(JOG_STOPS),
        check("jog-gripper", |rig| pending(jog::axis(rig, jog::GRIPPER)))
            .title("joint jog 11, 12: gripper")
            .by("Table 2.5")
            .needs(JOG_STOPS),
        check("jog-pump", |rig| pending(jog::pump(rig)))
            .title("joint jog 9, 10: pump")
            .by("Table 2.5, N21"),
        check("line-x", |rig| pending(jog::axis(rig, jog::X)))
            .title("linear jog 1, 2: X (state 7)")
            .by("Table 2.5")
            .needs(JOG_STOPS),
        check("line-y", |rig| pending(jog::axis(rig, jog::Y)))
            .title("linear jog 3, 4: Y")
            .by("Table 2.5")
            .needs(JOG_STOPS),
        check("line-z", |rig| pending(jog::axis(rig, jog::Z)))
            .title("linear jog 5, 6: Z")
            .by("Table 2.5")
            .needs(JOG_STOPS),
        check("line-servo", |rig| pending(jog::axis(rig, jog::LINE_SERVO)))
            .title("linear jog 7, 8: servo")
            .by("N14")
            .needs(JOG_STOPS),
        check("line-gripper", |rig| {
            pending(jog::axis(rig, jog::LINE_GRIPPER))
        })
        .title("linear jog 11, 12: gripper")
        .by("N14")
        .needs(JOG_STOPS),
        check("release-kind", |rig| pending(release::other_kind(rig)))
            .title("a release of the other kind of jog")
            .by("N13, N44")
            .needs(&["move-point", "jog-fore", "line-z"]),
        check("release-settings", |rig| {
            pending(release::other_settings(rig))
        })
        .title("another acceleration (9/0) between press and release")
        .by("N13, N44")
        .needs(&["move-point", "jog-servo"]),
        check("write-vector", |rig| pending(write::vector(rig)))
            .title("a write vector: direction of X (state 4)")
            .by("Table 2.6, N4"),
        check("write-speed", |rig| pending(write::start_speed(rig)))
            .title("the start speed of a write vector")
            .by("Table 2.6, N5"),
        check("write-stop", |rig| pending(write::stop(rig)))
            .title("a write vector with float 6 of 1 does not move")
            .by("N7"),
        check("set-jog", |rig| pending(settings::jog(rig)))
            .title("teach configuration (9/0) and StarVel")
            .by("Tables 3.5 and 3.9")
            .needs(JOG_STOPS),
        check("set-moves", |rig| pending(settings::moves(rig)))
            .title("playback configuration (9/1)")
            .by("Table 3.9"),
        check("set-writing", |rig| pending(settings::writing(rig)))
            .title("acceleration of writing (9/2)")
            .by("Table 3.9"),
        check("set-angles", |rig| pending(settings::angles(rig)))
            .title("initial angles (9/3), without motion")
            .by("Table 3.9, N8"),
        check("percent", |rig| pending(settings::percentages(rig)))
            .title("state 10: order of the percentages")
            .by("Table 3.9, N3"),
        check("gesture", |rig| pending(hand::gesture(rig)))
            .title("a hand position (state 8)")
            .by("N18"),
        check("mouse", |rig| pending(hand::mouse(rig)))
            .title("an increment of the mouse (state 1)")
            .by("Table 2.4, N9"),
        check("voice", |rig| pending(hand::voice(rig)))
            .title("a voice command (state 5)")
            .by("N17, N38"),
        check("laser", |rig| pending(jog::laser(rig)))
            .title("joint jog 13, 14: laser")
            .by("Table 2.5, N21"),
        check("limit-far", |rig| pending(limits::far(rig)))
            .title("does not move to a point out of reach")
            .by("N30"),
        check("limit-jog", |rig| pending(limits::jog(rig)))
            .title("a jog stops at the servo's limit")
            .by("N13, N30")
            .needs(JOG_STOPS),
        check("return", |rig| pending(moves::back(rig)))
            .title("returns to the start")
            .by("Table 3.7")
            .begins(Begins::Anywhere),
        check("trap-no-length", |rig| pending(traps::no_length(rig)))
            .title("a write vector without length")
            .by("N16, N34")
            .begins(Begins::Once),
        check("trap-state", |rig| pending(traps::unknown_state(rig)))
            .title("an unknown state")
            .by("N34")
            .begins(Begins::Once),
    ];

    const fn title(self, title: &'static str) -> Self {
        Self { title, ..self }
    }

    const fn by(self, source: &'static str) -> Self {
        Self { source, ..self }
    }

    const fn needs(self, needs: &'static [&'static str]) -> Self {
        Self { needs, ..self }
    }

    const fn begins(self, begins: Begins) -> Self {
        Self { begins, ..self }
    }

    /// Runs the check.
    pub(crate) async fn make(&self, rig: &mut Rig) -> Result<Outcome, CheckError> {
        (self.make)(rig).0.await
    }
}

impl PartialEq for Check {
    fn eq(&self, other: &Self) -> bool {
        self.id == other.id
    }
}

/// A check of an arm that may be moved, starting at home by default.
const fn check(id: &'static str, make: for<'r> fn(&'r mut Rig) -> PendingOutcome<'r>) -> Check {
    Check {
        id,
        title: "",
        source: "",
        needs: &["move-point"],
        begins: Begins::AtHome,
        make,
    }
}

fn pending<'r>(run: impl Future<Output = Result<Outcome, CheckError>> + 'r) -> PendingOutcome<'r> {
    PendingOutcome(Box::pin(run))
}

/// The outcome of a check that only evaluates received statuses.
fn ready_outcome<'r>(outcome: Outcome) -> PendingOutcome<'r> {
    pending(ready(Ok(outcome)))
}

const TOOL_SHOWS: &[&str] = &["move-point", "set-tool"];
const JOG_STOPS: &[&str] = &["move-point", "jog-release"];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_check_needs_is_checked_before_it() {
        for (n, check) in Check::ALL.iter().enumerate() {
            for needed in check.needs {
                let mut before = Check::ALL[..n].iter();
                assert!(
                    before.any(|earlier| earlier.id == *needed),
                    "{}: {needed}",
                    check.id
                );
            }
        }
    }
}
