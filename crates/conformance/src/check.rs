//! The list of checks.

use crate::checks::{
    delay, flow, framing, hand, jog, jump, limits, link, moves, release, settings, ticks, traps,
    write,
};
use crate::outcome::Outcome;
use crate::rig::{CheckError, Rig};

/// Something that is checked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Check {
    /// A name to speak of it.
    pub id: &'static str,
    /// What is checked, in plain words.
    pub title: &'static str,
    /// The table of the published protocol or the note of `docs/protocol.md` that says so.
    pub source: &'static str,
    pub(crate) probe: Probe,
}

/// How something is checked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Probe {
    StatusForm,
    StatusPeriod,
    StatusPose,
    StatusStart,
    Delay,
    Lift,
    SetTool,
    FrameNoise,
    FrameTail,
    FramePieces,
    FrameTruncated,
    FramePair,
    MoveModes,
    MoveJump,
    JumpAcross,
    MoveJoints,
    MoveTicks,
    MovePause,
    DefaultPause,
    MoveTool,
    FlowSilence,
    FlowAgain,
    FlowSix,
    FlowOrder,
    JogRelease,
    Jog(jog::JogButtons),
    JogPump,
    ReleaseKind,
    ReleaseSettings,
    WriteVector,
    WriteSpeed,
    WriteStop,
    SetJog,
    SetMoves,
    SetWriting,
    SetAngles,
    Percent,
    Gesture,
    Mouse,
    Voice,
    Laser,
    LimitFar,
    LimitJog,
    Return,
    TrapNoLength,
    TrapState,
}

impl Check {
    /// All checks, in the order in which they are made.
    pub const ALL: &[Self] = &[
        check("status-form", Probe::StatusForm)
            .says("statuses are whole packets of ten floats")
            .by("Table 2.3"),
        check("status-period", Probe::StatusPeriod)
            .says("a status comes every 80 ms")
            .by("N20, N27"),
        check("status-pose", Probe::StatusPose)
            .says("position and angles of a status agree")
            .by("N22"),
        check("status-start", Probe::StatusStart)
            .says("the arm stands still, within its limits")
            .by("N28, N30"),
        check("line-delay", Probe::Delay)
            .says("the line is fast enough: how long it takes there and back")
            .by("N20, N41"),
        check("move-point", Probe::Lift)
            .says("goes to a point: 10 mm up (state 3)")
            .by("Table 3.7"),
        check("set-tool", Probe::SetTool)
            .says("takes an end effector (9/4)")
            .by("Table 3.9, N32"),
        check("frame-noise", Probe::FrameNoise)
            .says("skips noise before a packet")
            .by("N24"),
        check("frame-tail", Probe::FrameTail)
            .says("does not obey a packet with a wrong tail")
            .by("Table 2.1"),
        check("frame-pieces", Probe::FramePieces)
            .says("takes a packet that comes in two pieces")
            .by("Table 2.1"),
        check("frame-truncated", Probe::FrameTruncated)
            .says("finds its place again after half a packet")
            .by("N24"),
        check("frame-pair", Probe::FramePair)
            .says("takes two packets without a gap")
            .by("N26"),
        check("move-modes", Probe::MoveModes)
            .says("MovingMode 1 and 2: one straight, one by joints")
            .by("Table 3.7, N2"),
        check("move-jump", Probe::MoveJump)
            .says("MovingMode 0: up, across, down")
            .by("Table 3.7, N11"),
        check("jump-across", Probe::JumpAcross)
            .says("MovingMode 0 between unequal heights: how it goes across")
            .by("N11, N45"),
        check("move-joints", Probe::MoveJoints)
            .says("goes to joint angles (state 6)")
            .by("Table 3.7, N19"),
        check("move-ticks", Probe::MoveTicks)
            .says("a move of whole ticks: when the next one begins")
            .by("N29, N45"),
        check("move-pause", Probe::MovePause)
            .says("waits after a move as long as told")
            .by("Table 3.7, N10"),
        check("default-pause", Probe::DefaultPause)
            .says("the default pause of 9/1")
            .by("Table 3.9, N10"),
        check("move-tool", Probe::MoveTool)
            .says("sets pump and gripper after a move")
            .by("Table 3.7, N21"),
        check("flow-silence", Probe::FlowSilence)
            .says("no status while four commands wait")
            .by("N20"),
        check("flow-again", Probe::FlowAgain)
            .says("statuses again when three wait")
            .by("N20"),
        check("flow-six", Probe::FlowSix)
            .says("six commands wait, a seventh does not")
            .by("N20"),
        check("flow-order", Probe::FlowOrder)
            .says("what waits is done in order")
            .by("N20"),
        check("jog-release", Probe::JogRelease)
            .says("a released button stops the jog")
            .by("Table 2.5, N13"),
        check("jog-base", Probe::Jog(jog::BASE))
            .says("joint jog 1, 2: base (state 2)")
            .by("Table 2.5"),
        check("jog-rear", Probe::Jog(jog::REAR))
            .says("joint jog 3, 4: rear arm")
            .by("Table 2.5"),
        check("jog-fore", Probe::Jog(jog::FORE))
            .says("joint jog 5, 6: forearm")
            .by("Table 2.5"),
        check("jog-servo", Probe::Jog(jog::SERVO))
            .says("joint jog 7, 8: servo")
            .by("Table 2.5"),
        check("jog-gripper", Probe::Jog(jog::GRIPPER))
            .says("joint jog 11, 12: gripper")
            .by("Table 2.5"),
        check("jog-pump", Probe::JogPump)
            .says("joint jog 9, 10: pump")
            .by("Table 2.5, N21"),
        check("line-x", Probe::Jog(jog::X))
            .says("linear jog 1, 2: X (state 7)")
            .by("Table 2.5"),
        check("line-y", Probe::Jog(jog::Y))
            .says("linear jog 3, 4: Y")
            .by("Table 2.5"),
        check("line-z", Probe::Jog(jog::Z))
            .says("linear jog 5, 6: Z")
            .by("Table 2.5"),
        check("line-servo", Probe::Jog(jog::LINE_SERVO))
            .says("linear jog 7, 8: servo")
            .by("N14"),
        check("line-gripper", Probe::Jog(jog::LINE_GRIPPER))
            .says("linear jog 11, 12: gripper")
            .by("N14"),
        check("release-kind", Probe::ReleaseKind)
            .says("a release of the other kind of jog")
            .by("N13, N44"),
        check("release-settings", Probe::ReleaseSettings)
            .says("another acceleration (9/0) between press and release")
            .by("N13, N44"),
        check("write-vector", Probe::WriteVector)
            .says("a write vector: which way is X (state 4)")
            .by("Table 2.6, N4"),
        check("write-speed", Probe::WriteSpeed)
            .says("the start speed of a write vector")
            .by("Table 2.6, N5"),
        check("write-stop", Probe::WriteStop)
            .says("a write vector with float 6 of 1 moves nothing")
            .by("N7"),
        check("set-jog", Probe::SetJog)
            .says("teach configuration (9/0) and StarVel")
            .by("Tables 3.5 and 3.9"),
        check("set-moves", Probe::SetMoves)
            .says("playback configuration (9/1)")
            .by("Table 3.9"),
        check("set-writing", Probe::SetWriting)
            .says("acceleration of writing (9/2)")
            .by("Table 3.9"),
        check("set-angles", Probe::SetAngles)
            .says("initial angles (9/3), without motion")
            .by("Table 3.9, N8"),
        check("percent", Probe::Percent)
            .says("state 10: which percentage comes first")
            .by("Table 3.9, N3"),
        check("gesture", Probe::Gesture)
            .says("a hand position (state 8)")
            .by("N18"),
        check("mouse", Probe::Mouse)
            .says("an increment of the mouse (state 1)")
            .by("Table 2.4, N9"),
        check("voice", Probe::Voice)
            .says("a spoken order (state 5)")
            .by("N17"),
        check("laser", Probe::Laser)
            .says("joint jog 13, 14: laser")
            .by("Table 2.5, N21"),
        check("limit-far", Probe::LimitFar)
            .says("does not go to a point out of reach")
            .by("N30"),
        check("limit-jog", Probe::LimitJog)
            .says("a jog stops at the servo's limit")
            .by("N13, N30"),
        check("return", Probe::Return)
            .says("is back where it was")
            .by("Table 3.7"),
        check("trap-no-length", Probe::TrapNoLength)
            .says("a write vector without length")
            .by("N16, N34"),
        check("trap-state", Probe::TrapState)
            .says("an unknown state")
            .by("N34"),
    ];

    const fn says(self, title: &'static str) -> Self {
        Self { title, ..self }
    }

    const fn by(self, source: &'static str) -> Self {
        Self { source, ..self }
    }

    /// Makes the check.
    pub(crate) async fn make(&self, rig: &mut Rig) -> Result<Outcome, CheckError> {
        match self.probe {
            Probe::StatusForm => link::form(rig).await,
            Probe::StatusPeriod => Ok(link::period(rig)),
            Probe::StatusPose => Ok(link::pose(rig)),
            Probe::StatusStart => Ok(link::start(rig)),
            Probe::Delay => delay::measure(rig).await,
            Probe::Lift => moves::lift(rig).await,
            Probe::SetTool => settings::tool(rig).await,
            Probe::FrameNoise => framing::noise(rig).await,
            Probe::FrameTail => framing::tail(rig).await,
            Probe::FramePieces => framing::pieces(rig).await,
            Probe::FrameTruncated => framing::truncated(rig).await,
            Probe::FramePair => framing::pair(rig).await,
            Probe::MoveModes => moves::modes(rig).await,
            Probe::MoveJump => jump::lifts(rig).await,
            Probe::JumpAcross => jump::across(rig).await,
            Probe::MoveJoints => moves::joints(rig).await,
            Probe::MoveTicks => ticks::whole(rig).await,
            Probe::MovePause => moves::pause(rig).await,
            Probe::DefaultPause => moves::default_pause(rig).await,
            Probe::MoveTool => moves::tool(rig).await,
            Probe::FlowSilence => flow::silence(rig).await,
            Probe::FlowAgain => Ok(flow::again(rig)),
            Probe::FlowSix => Ok(flow::six(rig)),
            Probe::FlowOrder => Ok(flow::order(rig)),
            Probe::JogRelease => jog::release(rig).await,
            Probe::Jog(axis) => jog::axis(rig, axis).await,
            Probe::JogPump => jog::pump(rig).await,
            Probe::ReleaseKind => release::other_kind(rig).await,
            Probe::ReleaseSettings => release::other_settings(rig).await,
            Probe::WriteVector => write::vector(rig).await,
            Probe::WriteSpeed => write::start_speed(rig).await,
            Probe::WriteStop => write::stop(rig).await,
            Probe::SetJog => settings::jog(rig).await,
            Probe::SetMoves => settings::moves(rig).await,
            Probe::SetWriting => settings::writing(rig).await,
            Probe::SetAngles => settings::angles(rig).await,
            Probe::Percent => settings::percentages(rig).await,
            Probe::Gesture => hand::gesture(rig).await,
            Probe::Mouse => hand::mouse(rig).await,
            Probe::Voice => hand::voice(rig).await,
            Probe::Laser => jog::laser(rig).await,
            Probe::LimitFar => limits::far(rig).await,
            Probe::LimitJog => limits::jog(rig).await,
            Probe::Return => moves::back(rig).await,
            Probe::TrapNoLength => traps::no_length(rig).await,
            Probe::TrapState => traps::unknown_state(rig).await,
        }
    }
}

const fn check(id: &'static str, probe: Probe) -> Check {
    Check {
        id,
        title: "",
        source: "",
        probe,
    }
}
