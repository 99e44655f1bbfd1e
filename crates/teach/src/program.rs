//! What a program says: the model of its text form.

use std::collections::BTreeMap;

use dobot_arm::Tool;
use dobot_wire::MovingMode;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use toml::Spanned;

use crate::lines::Lines;
use crate::number::{finite, perhaps};
use crate::place::{Place, Point};
use crate::step_table::StepTable;

/// A taught program: named places, and steps that go through them.
///
/// Lengths are millimetres, angles degrees, times seconds. [`Program::from_toml`] reads it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Program {
    /// What a person calls it.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub title: String,
    /// Soft start: how fast the first motion is, in percent of the speed that holds then, above 0 to 100.
    #[serde(
        default,
        skip_serializing_if = "Option::is_none",
        deserialize_with = "perhaps"
    )]
    pub start_speed_percent: Option<f64>,
    /// What can be mounted at the arm, by name; a step `tool = "NAME"` says which is.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub tools: BTreeMap<String, MountedTool>,
    /// Places to go to, by name.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub points: BTreeMap<String, Point>,
    /// Planes that were taught by three points, by name.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub frames: BTreeMap<String, Frame>,
    /// Patterns of places: rows, columns and layers, by name.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub grids: BTreeMap<String, Grid>,
    /// What is done, in order.
    #[schemars(with = "Vec<StepTable>")]
    pub steps: Steps,
    /// Where the lines of its text begin.
    #[serde(skip)]
    pub(crate) lines: Lines,
}

/// Steps in order, each with its place in the text; two that do the same are equal wherever they stand.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Steps(pub Vec<Spanned<Action>>);

/// What a step does.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "StepTable", into = "StepTable")]
#[non_exhaustive]
pub enum Action {
    /// Goes to a place, then sets the tool (states 3 and 6).
    Go(Go),
    /// Sets the tool, or waits, where the arm is.
    Here(Here),
    /// Switches the laser (state 2, buttons 13 and 14).
    Laser(bool),
    /// Waits for a person, who is told this.
    Wait(String),
    /// Waits for the other arms of a program for several: all that name this barrier go on together.
    Barrier(String),
    /// Sets speeds (states 9 and 10).
    Speed(Speed),
    /// Says which of the named tools is mounted (state 9, mode 4).
    Tool(String),
    /// Does steps again.
    Repeat(Times, Steps),
    /// Does steps for each cell of a grid, or of several side by side: in them, a grid's name is its cell.
    Each(Vec<String>, Steps),
    /// Does the steps of another program, by the name of its file beside this one.
    Call(String),
    /// Goes along an arc to its end.
    Arc(Arc),
    /// Goes once around the circle through here and two more places.
    Circle(Arc),
    /// Draws a file.
    Drawing(Drawing),
}

/// A way to a place, and what the tool does there.
#[derive(Clone, Debug, PartialEq)]
pub struct Go {
    /// Where to.
    pub to: Place,
    /// So far from it, along the axes of its frame.
    pub offset: Offset,
    /// The way there; a JUMP, if nothing is said.
    pub path: MovingMode,
    /// What the tool does there.
    pub then: Here,
}

/// What the tool does where the arm is; what is not said stays as it is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Here {
    /// Whether the pump runs from now on.
    pub suction: Option<bool>,
    /// The gripper's angle from now on, -90 to 90 degrees.
    pub gripper: Option<f64>,
    /// How long the arm waits, 0 to 655 seconds (note N10); pump and gripper act at half of that (note N47).
    pub pause: Option<f64>,
}

/// How often steps are done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Times {
    /// So often in all, 1 or more.
    Count(u64),
    /// Until a person ends it; only the program's last step can be.
    Forever,
}

/// A tool as it is mounted.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MountedTool {
    /// Which kind: `suction_cup`, `gripper`, `pen` or `laser`.
    pub kind: Tool,
    /// How far its tip hangs below the wrist, 0 to 200 mm: points with x, y and z say where the tip goes. With
    /// 0, as without it, they say where the wrist goes, as the arm's statuses do.
    #[serde(default, skip_serializing_if = "is_zero", deserialize_with = "finite")]
    pub length: f64,
}

/// A plane that was taught by three points: its x axis goes from the origin through the second, and its y axis
/// lies at a right angle to that, on the side of the third. Its z axis is at right angles to both (right-handed).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Frame {
    /// Its origin.
    pub origin: Place,
    /// A place on its x axis.
    pub x: Place,
    /// A place on the side of its y axis.
    pub y: Place,
}

/// A pattern of places: columns along x, rows along y and layers along z of the frame of its first cell. The cells
/// of a row come first, then the rows, then the layers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Grid {
    /// Its first cell.
    pub at: Place,
    /// How many cells a row has, 1 to 1000.
    #[serde(default = "one")]
    #[schemars(range(min = 1, max = 1000))]
    pub columns: u32,
    /// How many rows a layer has, 1 to 1000.
    #[serde(default = "one")]
    #[schemars(range(min = 1, max = 1000))]
    pub rows: u32,
    /// How many layers there are, 1 to 1000.
    #[serde(default = "one")]
    #[schemars(range(min = 1, max = 1000))]
    pub layers: u32,
    /// From one cell to the next along x, y and z; a negative z goes down, as from the top of a stack.
    pub pitch: Offset,
}

/// A way along the axes of a frame, in mm.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Offset {
    /// Along x.
    #[serde(skip_serializing_if = "is_zero", deserialize_with = "finite")]
    pub x: f64,
    /// Along y.
    #[serde(skip_serializing_if = "is_zero", deserialize_with = "finite")]
    pub y: f64,
    /// Along z.
    #[serde(skip_serializing_if = "is_zero", deserialize_with = "finite")]
    pub z: f64,
}

/// Speeds of targets (states 9 and 10; Table 3.9); what is not said stays as it was, at first as in an arm that
/// was just switched on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Speed {
    /// All speeds of targets, in percent of the ones below, above 0 to 100; 50 at first.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    pub percent: Option<f64>,
    /// Their accelerations, in percent, above 0 to 100; 50 at first.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    pub acceleration_percent: Option<f64>,
    /// Base, rear arm and forearm, in degrees/s; 200 at first.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    pub joint: Option<f64>,
    /// Their acceleration, in degrees/s2; 200 at first.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    pub joint_acceleration: Option<f64>,
    /// The servo, in degrees/s; 200 at first.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    pub servo: Option<f64>,
    /// Its acceleration, in degrees/s2; 200 at first.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    pub servo_acceleration: Option<f64>,
    /// Along a line, in mm/s; 100 at first.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    pub line: Option<f64>,
    /// The acceleration along a line, in mm/s2; 200 at first.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    pub line_acceleration: Option<f64>,
    /// How high a JUMP lifts, in mm, 0 to 300. An arm that was just switched on lifts by 10 or 20 mm, depending on
    /// its firmware (note N11): once one of the speeds above is set, without this it is 20.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    pub jump_height: Option<f64>,
}

/// An arc or a circle from where the arm is, given by two more places on it. The arm goes along it by straight
/// lines (MOVL), from rest to rest: a target can be sent again when a packet was lost, a vector cannot.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Arc {
    /// A place on the way.
    pub through: Place,
    /// Where an arc ends; the third place of a circle.
    pub to: Place,
    /// How far the straight lines may be from the arc, 0.01 to 10 mm; 0.5 if nothing is said.
    #[serde(default = "half_a_millimetre", deserialize_with = "finite")]
    pub tolerance: f64,
}

/// A drawing as a step. What reads the program prepares it, as `dobot draw` does.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Drawing {
    /// The drawing's file, beside the program.
    pub file: String,
    /// The height of the wrist at which the pen touches the paper, in mm.
    #[serde(deserialize_with = "finite")]
    pub pen_down: f64,
    /// The options of `dobot draw`, under their names in a request: `place`, `tool`, `way`, `what`.
    #[serde(default, skip_serializing_if = "toml::Table::is_empty")]
    #[schemars(with = "serde_json::Map<String, serde_json::Value>")]
    pub options: toml::Table,
}

impl Program {
    /// A program that does this, without names.
    #[must_use]
    pub fn new(actions: Vec<Action>) -> Self {
        Self {
            steps: Steps::new(actions),
            ..Self::default()
        }
    }

    /// The line on which a step begins, counted from 1; 1 where it was not read from a text.
    #[must_use]
    pub fn line_of(&self, step: &Spanned<Action>) -> usize {
        self.lines.at(step.span().start)
    }

    /// The JSON Schema of a program, for editors and programs.
    #[must_use]
    pub fn schema() -> serde_json::Value {
        schemars::schema_for!(Self).to_value()
    }
}

impl Steps {
    /// Steps that are not from a text.
    #[must_use]
    pub fn new(actions: Vec<Action>) -> Self {
        Self(
            actions
                .into_iter()
                .map(|it| Spanned::new(0..0, it))
                .collect(),
        )
    }
}

impl Go {
    /// A JUMP to a place.
    #[must_use]
    pub fn to(place: impl Into<Place>) -> Self {
        Self {
            to: place.into(),
            offset: Offset::default(),
            path: MovingMode::Jump,
            then: Here::default(),
        }
    }
}

impl Grid {
    /// How many cells it has.
    #[must_use]
    pub fn cells(&self) -> u64 {
        [self.columns, self.rows, self.layers]
            .map(u64::from)
            .iter()
            .product()
    }
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde asks for it")]
fn is_zero(number: &f64) -> bool {
    *number == 0.0
}

const fn one() -> u32 {
    1
}

const fn half_a_millimetre() -> f64 {
    DEFAULT_TOLERANCE_MM
}

/// How far the straight lines may be from an arc, if nothing is said.
pub const DEFAULT_TOLERANCE_MM: f64 = 0.5;
