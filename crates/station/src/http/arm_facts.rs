//! The facts of the arm that a client draws it by and computes with.

use dobot_api::State;
use dobot_arm::{TICK_S, Tool};
use dobot_host::Rules;
use dobot_model::Dimensions;
use dobot_motion::{HandAxis, HandScale};
use dobot_safety::{JointLimits, Policy, Workspace};
use dobot_wire::{Dialect, PACKET_GAP};
use schemars::JsonSchema;
use serde::Serialize;

/// The facts of the arm: they hold until the policy or the dialect changes.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub(super) struct ArmFacts {
    /// The lengths of its links and rods.
    dimensions: Dimensions,
    /// The tools that were sold with it.
    tools: [ToolFacts; 4],
    /// How far its joints may turn, by the policy that holds.
    joints: JointLimits,
    /// Where its tool may be, by the policy that holds.
    workspace: Workspace,
    /// From one status to the next while there is room in its queue, in seconds; over Bluetooth they come sooner.
    status_period_s: f64,
    /// From one tick of its controller to the next, in seconds.
    tick_s: f64,
    /// From a packet to the next one that must not get lost, in seconds.
    packet_gap_s: f64,
    /// What mouse and gesture packets mean to it; none while nobody knows its dialect.
    dialect: Option<DialectFacts>,
}

/// A tool.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
struct ToolFacts {
    /// What it is.
    kind: Tool,
    /// From the wrist to the axis of the tool, level, in mm.
    reach_mm: f64,
    /// From the height of the wrist down to the tip, by the policy that holds, in mm.
    length_mm: f64,
    /// What an arm with this tool makes of gesture packets (note N18); none while nobody knows its dialect.
    gesture: Option<GestureFacts>,
}

/// What the dialect of the arm means for one who leads it by hand.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
struct DialectFacts {
    /// The dialect.
    name: Dialect,
    /// Whether Y of a mouse packet swings the base, to the right where it is positive, and its rotation is the angle of the
    /// servo (note N9).
    mouse_swings: bool,
    /// How often the same gesture packet has to be sent until the arm is where the hand is (note N49).
    gesture_samples: usize,
}

/// The units of a gesture packet.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
struct GestureFacts {
    /// Along X.
    x: GestureAxis,
    /// Along Y.
    y: GestureAxis,
    /// Along Z.
    z: GestureAxis,
}

/// One axis of a gesture packet: its number is (place in mm - `zero_mm`) times `units_per_mm`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
struct GestureAxis {
    /// The place that the number 0 means, in mm.
    zero_mm: f64,
    /// What is counted for each mm beyond that.
    units_per_mm: f64,
}

impl ArmFacts {
    /// Those of the arm of a station.
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
