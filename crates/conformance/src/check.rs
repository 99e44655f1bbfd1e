//! The list of checks.

use std::future::ready;
use std::pin::Pin;

use crate::checks::{
    delay, flow, framing, hand, jog, jump, limits, link, moves, release, settings, ticks, traps,
    write,
};
use crate::outcome::Outcome;
use crate::rig::{CheckError, Rig};

/// Something that is checked.
#[derive(Clone, Copy, Debug)]
pub struct Check {
    /// A name to speak of it.
    pub id: &'static str,
    /// What is checked, in plain words.
    pub title: &'static str,
    /// The table of the published protocol or the note of `docs/protocol.md` that says so.
    pub source: &'static str,
    /// What has to hold before it says anything, by name.
    pub(crate) needs: &'static [&'static str],
    pub(crate) begins: Begins,
    make: for<'r> fn(&'r mut Rig) -> Judging<'r>,
}

/// Where a check begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Begins {
    /// Where nearly all do.
    AtHome,
    /// Where the arm is.
    Anywhere,
    /// Where the arm is, and once only: it just listens, or a stock arm does not come back from it.
    Once,
}

/// A check that is being made.
struct Judging<'r>(Pin<Box<dyn Future<Output = Result<Outcome, CheckError>> + 'r>>);

impl Check {
    /// All checks, in the order in which they are made.
    pub const ALL: &[Self] = &[
        check("status-form", |rig| judged(link::form(rig)))
            .says("statuses are whole packets of ten floats")
            .by("Table 2.3")
            .needs(&[])
            .begins(Begins::Once),
        check("status-period", |rig| told(link::period(rig)))
            .says("a status comes every 80 ms")
            .by("N20, N27")
            .needs(&[])
            .begins(Begins::Once),
        check("status-pose", |rig| told(link::pose(rig)))
            .says("position and angles of a status agree")
            .by("N22")
            .needs(&[])
            .begins(Begins::Once),
        check("status-start", |rig| told(link::start(rig)))
            .says("the arm stands still, within its limits")
            .by("N28, N30")
            .needs(&[])
            .begins(Begins::Once),
        check("line-delay", |rig| judged(delay::measure(rig)))
            .says("the line is fast enough: how long it takes there and back")
            .by("N20, N41")
            .needs(&["status-form", "status-pose", "status-start"])
            .begins(Begins::Once),
        check("move-point", |rig| judged(moves::lift(rig)))
            .says("goes to a point: 10 mm up (state 3)")
            .by("Table 3.7")
            .needs(&["line-delay"])
            .begins(Begins::Anywhere),
        check("set-tool", |rig| judged(settings::tool(rig)))
            .says("takes an end effector (9/4)")
            .by("Table 3.9, N32"),
        check("frame-noise", |rig| judged(framing::noise(rig)))
            .says("skips noise before a packet")
            .by("N24")
            .needs(TOOL_SHOWS),
        check("frame-tail", |rig| judged(framing::tail(rig)))
            .says("does not obey a packet with a wrong tail")
            .by("Table 2.1")
            .needs(TOOL_SHOWS),
        check("frame-pieces", |rig| judged(framing::pieces(rig)))
            .says("takes a packet that comes in two pieces")
            .by("Table 2.1")
            .needs(TOOL_SHOWS),
        check("frame-truncated", |rig| judged(framing::truncated(rig)))
            .says("finds its place again after half a packet")
            .by("N24")
            .needs(TOOL_SHOWS),
        check("frame-pair", |rig| judged(framing::pair(rig)))
            .says("takes two packets without a gap")
            .by("N26")
            .needs(TOOL_SHOWS),
        check("move-modes", |rig| judged(moves::modes(rig)))
            .says("MovingMode 1 and 2: one straight, one by joints")
            .by("Table 3.7, N2"),
        check("move-jump", |rig| judged(jump::lifts(rig)))
            .says("MovingMode 0: up, across, down")
            .by("Table 3.7, N11"),
        check("jump-across", |rig| judged(jump::across(rig)))
            .says("MovingMode 0 between unequal heights: how it goes across")
            .by("N11, N45")
            .needs(&["move-point", "move-jump"]),
        check("move-joints", |rig| judged(moves::joints(rig)))
            .says("goes to joint angles (state 6)")
            .by("Table 3.7, N19"),
        check("move-ticks", |rig| judged(ticks::whole(rig)))
            .says("a move of whole ticks: when the next one begins")
            .by("N29, N45"),
        check("move-pause", |rig| judged(moves::pause(rig)))
            .says("waits after a move as long as commanded")
            .by("Table 3.7, N10"),
        check("default-pause", |rig| judged(moves::default_pause(rig)))
            .says("the default pause of 9/1")
            .by("Table 3.9, N10"),
        check("move-tool", |rig| judged(moves::tool(rig)))
            .says("sets pump and gripper after a move")
            .by("Table 3.7, N21"),
        check("flow-silence", |rig| judged(flow::silence(rig)))
            .says("no status while four commands wait")
            .by("N20"),
        check("flow-again", |rig| told(flow::again(rig)))
            .says("statuses again when three wait")
            .by("N20")
            .begins(Begins::Anywhere),
        check("flow-six", |rig| told(flow::six(rig)))
            .says("six commands wait, a seventh does not")
            .by("N20")
            .begins(Begins::Anywhere),
        check("flow-order", |rig| told(flow::order(rig)))
            .says("what waits is done in order")
            .by("N20")
            .begins(Begins::Anywhere),
        check("jog-release", |rig| judged(jog::release(rig)))
            .says("a released button stops the jog")
            .by("Table 2.5, N13"),
        check("jog-base", |rig| judged(jog::axis(rig, jog::BASE)))
            .says("joint jog 1, 2: base (state 2)")
            .by("Table 2.5")
            .needs(JOG_STOPS),
        check("jog-rear", |rig| judged(jog::axis(rig, jog::REAR)))
            .says("joint jog 3, 4: rear arm")
            .by("Table 2.5")
            .needs(JOG_STOPS),
        check("jog-fore", |rig| judged(jog::axis(rig, jog::FORE)))
            .says("joint jog 5, 6: forearm")
            .by("Table 2.5")
            .needs(JOG_STOPS),
        check("jog-servo", |rig| judged(jog::axis(rig, jog::SERVO)))
            .says("joint jog 7, 8: servo")
            .by("Table 2.5")
            .needs(JOG_STOPS),
        check("jog-gripper", |rig| judged(jog::axis(rig, jog::GRIPPER)))
            .says("joint jog 11, 12: gripper")
            .by("Table 2.5")
            .needs(JOG_STOPS),
        check("jog-pump", |rig| judged(jog::pump(rig)))
            .says("joint jog 9, 10: pump")
            .by("Table 2.5, N21"),
        check("line-x", |rig| judged(jog::axis(rig, jog::X)))
            .says("linear jog 1, 2: X (state 7)")
            .by("Table 2.5")
            .needs(JOG_STOPS),
        check("line-y", |rig| judged(jog::axis(rig, jog::Y)))
            .says("linear jog 3, 4: Y")
            .by("Table 2.5")
            .needs(JOG_STOPS),
        check("line-z", |rig| judged(jog::axis(rig, jog::Z)))
            .says("linear jog 5, 6: Z")
            .by("Table 2.5")
            .needs(JOG_STOPS),
        check("line-servo", |rig| judged(jog::axis(rig, jog::LINE_SERVO)))
            .says("linear jog 7, 8: servo")
            .by("N14")
            .needs(JOG_STOPS),
        check("line-gripper", |rig| {
            judged(jog::axis(rig, jog::LINE_GRIPPER))
        })
        .says("linear jog 11, 12: gripper")
        .by("N14")
        .needs(JOG_STOPS),
        check("release-kind", |rig| judged(release::other_kind(rig)))
            .says("a release of the other kind of jog")
            .by("N13, N44")
            .needs(&["move-point", "jog-fore", "line-z"]),
        check("release-settings", |rig| {
            judged(release::other_settings(rig))
        })
        .says("another acceleration (9/0) between press and release")
        .by("N13, N44")
        .needs(&["move-point", "jog-servo"]),
        check("write-vector", |rig| judged(write::vector(rig)))
            .says("a write vector: which way is X (state 4)")
            .by("Table 2.6, N4"),
        check("write-speed", |rig| judged(write::start_speed(rig)))
            .says("the start speed of a write vector")
            .by("Table 2.6, N5"),
        check("write-stop", |rig| judged(write::stop(rig)))
            .says("a write vector with float 6 of 1 moves nothing")
            .by("N7"),
        check("set-jog", |rig| judged(settings::jog(rig)))
            .says("teach configuration (9/0) and StarVel")
            .by("Tables 3.5 and 3.9")
            .needs(JOG_STOPS),
        check("set-moves", |rig| judged(settings::moves(rig)))
            .says("playback configuration (9/1)")
            .by("Table 3.9"),
        check("set-writing", |rig| judged(settings::writing(rig)))
            .says("acceleration of writing (9/2)")
            .by("Table 3.9"),
        check("set-angles", |rig| judged(settings::angles(rig)))
            .says("initial angles (9/3), without motion")
            .by("Table 3.9, N8"),
        check("percent", |rig| judged(settings::percentages(rig)))
            .says("state 10: which percentage comes first")
            .by("Table 3.9, N3"),
        check("gesture", |rig| judged(hand::gesture(rig)))
            .says("a hand position (state 8)")
            .by("N18"),
        check("mouse", |rig| judged(hand::mouse(rig)))
            .says("an increment of the mouse (state 1)")
            .by("Table 2.4, N9"),
        check("voice", |rig| judged(hand::voice(rig)))
            .says("a spoken order (state 5)")
            .by("N17"),
        check("laser", |rig| judged(jog::laser(rig)))
            .says("joint jog 13, 14: laser")
            .by("Table 2.5, N21"),
        check("limit-far", |rig| judged(limits::far(rig)))
            .says("does not go to a point out of reach")
            .by("N30"),
        check("limit-jog", |rig| judged(limits::jog(rig)))
            .says("a jog stops at the servo's limit")
            .by("N13, N30")
            .needs(JOG_STOPS),
        check("return", |rig| judged(moves::back(rig)))
            .says("is back where it was")
            .by("Table 3.7")
            .begins(Begins::Anywhere),
        check("trap-no-length", |rig| judged(traps::no_length(rig)))
            .says("a write vector without length")
            .by("N16, N34")
            .begins(Begins::Once),
        check("trap-state", |rig| judged(traps::unknown_state(rig)))
            .says("an unknown state")
            .by("N34")
            .begins(Begins::Once),
    ];

    const fn says(self, title: &'static str) -> Self {
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

    /// Makes the check.
    pub(crate) async fn make(&self, rig: &mut Rig) -> Result<Outcome, CheckError> {
        (self.make)(rig).0.await
    }
}

impl PartialEq for Check {
    fn eq(&self, other: &Self) -> bool {
        self.id == other.id
    }
}

/// A check of an arm that could be moved, beginning at home, unless something else is said.
const fn check(id: &'static str, make: for<'r> fn(&'r mut Rig) -> Judging<'r>) -> Check {
    Check {
        id,
        title: "",
        source: "",
        needs: &["move-point"],
        begins: Begins::AtHome,
        make,
    }
}

fn judged<'r>(making: impl Future<Output = Result<Outcome, CheckError>> + 'r) -> Judging<'r> {
    Judging(Box::pin(making))
}

/// The outcome of a check that only looks at what came.
fn told<'r>(outcome: Outcome) -> Judging<'r> {
    judged(ready(Ok(outcome)))
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
                assert!(before.any(|it| it.id == *needed), "{}: {needed}", check.id);
            }
        }
    }
}
