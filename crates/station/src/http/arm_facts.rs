//! Facts of the arm for clients that draw it or compute with it.

use dobot_api::State;
use dobot_arm::{TICK_S, Tool};
use dobot_host::Rules;
use dobot_model::Dimensions;
use dobot_motion::{HandAxis, HandScale};
use dobot_safety::{JointLimits, Policy, Workspace};
use dobot_wire::{Dialect, PACKET_GAP};
use schemars::JsonSchema;
use serde::Serialize;

/// Facts of the arm; valid until the policy or the dialect changes.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub(super) struct ArmFacts {
    /// The lengths of its links and rods.
    dimensions: Dimensions,
    /// The tools that were sold with it.
    tools: [ToolFacts; Tool::ALL.len()],
    /// The ranges of its joints, by the current policy.
    joints: JointLimits,
    /// The workspace of its tool, by the current policy.
    workspace: Workspace,
    /// The period of statuses while its queue has space, in seconds; over Bluetooth it is shorter.
    status_period_s: f64,
    /// The period of its controller's ticks, in seconds.
    tick_s: f64,
    /// The minimum gap between packets that must not get lost, in seconds.
    packet_gap_s: f64,
    /// The meaning of mouse and gesture packets; absent while the dialect is unknown.
    dialect: Option<DialectFacts>,
}

/// A tool.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
struct ToolFacts {
    /// The kind of tool.
    kind: Tool,
    /// The distance from the wrist to the axis of the tool, horizontally, in mm.
    reach_mm: f64,
    /// The distance from the wrist down to the tip, by the current policy, in mm.
    length_mm: f64,
    /// The meaning of gesture packets with this tool (note N18); absent while the dialect is
    /// unknown.
    gesture: Option<GestureFacts>,
}

/// The effect of the arm's dialect on leading it by hand.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
struct DialectFacts {
    /// The dialect.
    name: Dialect,
    /// Whether Y of a mouse packet swings the base, to the right if it is positive, and its
    /// rotation is the servo angle (note N9).
    mouse_swings: bool,
    /// How many times a gesture packet must be sent until the arm is where the hand is (note N49).
    gesture_samples: usize,
}

/// The units of a gesture packet.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
struct GestureFacts {
    /// The X axis.
    x: GestureAxis,
    /// The Y axis.
    y: GestureAxis,
    /// The Z axis.
    z: GestureAxis,
}

/// One axis of a gesture packet: its number is (position in mm - `zero_mm`) times `units_per_mm`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
struct GestureAxis {
    /// The position of the number 0, in mm.
    zero_mm: f64,
    /// The number of units per mm.
    units_per_mm: f64,
}

impl ArmFacts {
    /// Returns the facts of a station's arm.
    pub(super) fn of(rules: &Rules, state: &State) -> Self {
        let (policy, dialect) = (&rules.policy, state.dialect.as_ref());
        let period = dialect.unwrap_or(&Dialect::SPECIFICATION).status_period();
        Self {
            dimensions: Dimensions::STOCK,
            tools: Tool::ALL.map(|kind| ToolFacts::of(kind, policy, dialect)),
            joints: policy.joints,
            workspace: policy.workspace,
            status_period_s: period.as_secs_f64(),
            tick_s: TICK_S,
            packet_gap_s: PACKET_GAP.as_secs_f64(),
            dialect: dialect.map(|dialect| DialectFacts {
                name: *dialect,
                mouse_swings: dialect.mouse_swings,
                gesture_samples: HandScale::samples(dialect),
            }),
        }
    }
}

impl ToolFacts {
    fn of(kind: Tool, policy: &Policy, dialect: Option<&Dialect>) -> Self {
        Self {
            kind,
            reach_mm: kind.reach().0,
            length_mm: policy.tool_length.of(kind),
            gesture: dialect.map(|dialect| HandScale::of(dialect, kind).into()),
        }
    }
}

impl From<HandScale> for GestureFacts {
    fn from(HandScale { x, y, z }: HandScale) -> Self {
        let [x, y, z] = [x, y, z].map(|axis| {
            let HandAxis {
                zero_mm,
                units_per_mm,
            } = axis;
            GestureAxis {
                zero_mm,
                units_per_mm,
            }
        });
        Self { x, y, z }
    }
}
