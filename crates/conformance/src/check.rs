//! The list of checks.

use crate::checks::{delay, flow, framing, hand, jog, limits, link, moves, settings, traps, write};
use crate::outcome::Outcome;
use crate::rig::{Rig, Trouble};

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
    MoveJoints,
    MovePause,
    DefaultPause,
    MoveTool,
    FlowSilence,
    FlowAgain,
    FlowSix,
    FlowOrder,
    JogRelease,
    Jog(jog::Axis),
    JogPump,
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
        check(
            "status-form",
            "statuses are whole packets of ten floats",
            "Table 2.3",
            Probe::StatusForm,
        ),
        check(
            "status-period",
            "a status comes every 80 ms",
            "N20, N27",
            Probe::StatusPeriod,
        ),
        check(
            "status-pose",
            "position and angles of a status agree",
            "N22",
            Probe::StatusPose,
        ),
        check(
            "status-start",
            "the arm stands still, within its limits",
            "N28, N30",
            Probe::StatusStart,
        ),
        check(
            "line-delay",
            "the line is fast enough: how long it takes there and back",
            "N20, N41",
            Probe::Delay,
        ),
        check(
            "move-point",
            "goes to a point: 10 mm up (state 3)",
            "Table 3.7",
            Probe::Lift,
        ),
        check(
            "set-tool",
            "takes an end effector (9/4)",
            "Table 3.9, N32",
            Probe::SetTool,
        ),
        check(
            "frame-noise",
            "skips noise before a packet",
            "N24",
            Probe::FrameNoise,
        ),
        check(
            "frame-tail",
            "does not obey a packet with a wrong tail",
            "Table 2.1",
            Probe::FrameTail,
        ),
        check(
            "frame-pieces",
            "takes a packet that comes in two pieces",
            "Table 2.1",
            Probe::FramePieces,
        ),
        check(
            "frame-truncated",
            "finds its place again after half a packet",
            "N24",
            Probe::FrameTruncated,
        ),
        check(
            "frame-pair",
            "takes two packets without a gap",
            "N26",
            Probe::FramePair,
        ),
        check(
            "move-modes",
            "MovingMode 1 and 2: one straight, one by joints",
            "Table 3.7, N2",
            Probe::MoveModes,
        ),
        check(
            "move-jump",
            "MovingMode 0: up, across, down",
            "Table 3.7, N11",
            Probe::MoveJump,
        ),
        check(
            "move-joints",
            "goes to joint angles (state 6)",
            "Table 3.7, N19",
            Probe::MoveJoints,
        ),
        check(
            "move-pause",
            "waits after a move as long as told",
            "Table 3.7, N10",
            Probe::MovePause,
        ),
        check(
            "default-pause",
            "the default pause of 9/1",
            "Table 3.9, N10",
            Probe::DefaultPause,
        ),
        check(
            "move-tool",
            "sets pump and gripper after a move",
            "Table 3.7, N21",
            Probe::MoveTool,
        ),
        check(
            "flow-silence",
            "no status while four commands wait",
            "N20",
            Probe::FlowSilence,
        ),
        check(
            "flow-again",
            "statuses again when three wait",
            "N20",
            Probe::FlowAgain,
        ),
        check(
            "flow-six",
            "six commands wait, a seventh does not",
            "N20",
            Probe::FlowSix,
        ),
        check(
            "flow-order",
            "what waits is done in order",
            "N20",
            Probe::FlowOrder,
        ),
        check(
            "jog-release",
            "a released button stops the jog",
            "Table 2.5, N13",
            Probe::JogRelease,
        ),
        check(
            "jog-base",
            "joint jog 1, 2: base (state 2)",
            "Table 2.5",
            Probe::Jog(jog::BASE),
        ),
        check(
            "jog-rear",
            "joint jog 3, 4: rear arm",
            "Table 2.5",
            Probe::Jog(jog::REAR),
        ),
        check(
            "jog-fore",
            "joint jog 5, 6: forearm",
            "Table 2.5",
            Probe::Jog(jog::FORE),
        ),
        check(
            "jog-servo",
            "joint jog 7, 8: servo",
            "Table 2.5",
            Probe::Jog(jog::SERVO),
        ),
        check(
            "jog-gripper",
            "joint jog 11, 12: gripper",
            "Table 2.5",
            Probe::Jog(jog::GRIPPER),
        ),
        check(
            "jog-pump",
            "joint jog 9, 10: pump",
            "Table 2.5, N21",
            Probe::JogPump,
        ),
        check(
            "line-x",
            "linear jog 1, 2: X (state 7)",
            "Table 2.5",
            Probe::Jog(jog::X),
        ),
        check(
            "line-y",
            "linear jog 3, 4: Y",
            "Table 2.5",
            Probe::Jog(jog::Y),
        ),
        check(
            "line-z",
            "linear jog 5, 6: Z",
            "Table 2.5",
            Probe::Jog(jog::Z),
        ),
        check(
            "line-servo",
            "linear jog 7, 8: servo",
            "N14",
            Probe::Jog(jog::LINE_SERVO),
        ),
        check(
            "line-gripper",
            "linear jog 11, 12: gripper",
            "N14",
            Probe::Jog(jog::LINE_GRIPPER),
        ),
        check(
            "write-vector",
            "a write vector: which way is X (state 4)",
            "Table 2.6, N4",
            Probe::WriteVector,
        ),
        check(
            "write-speed",
            "the start speed of a write vector",
            "Table 2.6, N5",
            Probe::WriteSpeed,
        ),
        check(
            "write-stop",
            "a write vector with float 6 of 1 moves nothing",
            "N7",
            Probe::WriteStop,
        ),
        check(
            "set-jog",
            "teach configuration (9/0) and StarVel",
            "Tables 3.5 and 3.9",
            Probe::SetJog,
        ),
        check(
            "set-moves",
            "playback configuration (9/1)",
            "Table 3.9",
            Probe::SetMoves,
        ),
        check(
            "set-writing",
            "acceleration of writing (9/2)",
            "Table 3.9",
            Probe::SetWriting,
        ),
        check(
            "set-angles",
            "initial angles (9/3), without motion",
            "Table 3.9, N8",
            Probe::SetAngles,
        ),
        check(
            "percent",
            "state 10: which percentage comes first",
            "Table 3.9, N3",
            Probe::Percent,
        ),
        check(
            "gesture",
            "a hand position (state 8)",
            "N18",
            Probe::Gesture,
        ),
        check(
            "mouse",
            "an increment of the mouse (state 1)",
            "Table 2.4, N9",
            Probe::Mouse,
        ),
        check("voice", "a spoken order (state 5)", "N17", Probe::Voice),
        check(
            "laser",
            "joint jog 13, 14: laser",
            "Table 2.5, N21",
            Probe::Laser,
        ),
        check(
            "limit-far",
            "does not go to a point out of reach",
            "N30",
            Probe::LimitFar,
        ),
        check(
            "limit-jog",
            "a jog stops at the servo's limit",
            "N13, N30",
            Probe::LimitJog,
        ),
        check("return", "is back where it was", "Table 3.7", Probe::Return),
        check(
            "trap-no-length",
            "a write vector without length",
            "N16, N34",
            Probe::TrapNoLength,
        ),
        check("trap-state", "an unknown state", "N34", Probe::TrapState),
    ];

    /// Makes the check.
    pub(crate) async fn make(&self, rig: &mut Rig) -> Result<Outcome, Trouble> {
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
            Probe::MoveJump => moves::jump(rig).await,
            Probe::MoveJoints => moves::joints(rig).await,
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

const fn check(id: &'static str, title: &'static str, source: &'static str, probe: Probe) -> Check {
    Check {
        id,
        title,
        source,
        probe,
    }
}
