//! Programs: the model of their text form.

use std::collections::BTreeMap;

use dobot_arm::Tool;
use dobot_wire::MovingMode;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use toml::Spanned;

use crate::decision::{Choose, Condition, Transfer, Variables, When};
use crate::lines::Lines;
use crate::number::{finite, perhaps};
use crate::place::{Place, Point};
use crate::recorded_path::RecordedPlace;
use crate::step_table::StepTable;

/// A taught program: named places and the steps that visit them.
///
/// Lengths are in millimetres, angles in degrees, times in seconds. See [`Program::from_toml`].
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Program {
    /// The title.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub title: String,
    /// The speed of the first motion (soft start), in percent of the speed that is set then, above
    /// 0 to 100.
    #[serde(
        default,
        skip_serializing_if = "Option::is_none",
        deserialize_with = "perhaps"
    )]
    pub start_speed_percent: Option<f64>,
    /// The tools that can be mounted, by name; a step `tool = "NAME"` selects one.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub tools: BTreeMap<String, MountedTool>,
    /// Points, by name.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub points: BTreeMap<String, Point>,
    /// Frames taught by three points, by name.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub frames: BTreeMap<String, Frame>,
    /// Grids of places in columns, rows and layers, by name.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub grids: BTreeMap<String, Grid>,
    /// The variables with their initial values: whole numbers, by name.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub variables: Variables,
    /// The steps, in order.
    #[schemars(with = "Vec<StepTable>")]
    pub steps: Steps,
    /// The lines of the text.
    #[serde(skip)]
    pub(crate) lines: Lines,
}

/// Steps in order, each with its position in the text. Equality ignores the positions.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Steps(pub Vec<Spanned<Action>>);

/// The action of a step.
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
    /// Waits for a person and shows this text.
    Wait(String),
    /// Waits for the other arms of a coordinated program: all arms at the barrier of this name
    /// continue together.
    Barrier(String),
    /// Sets speeds (states 9 and 10).
    Speed(Speed),
    /// Selects the mounted tool by name (state 9, mode 4).
    Tool(String),
    /// Repeats steps.
    Repeat(Times, Steps),
    /// Repeats steps for each cell of a grid, or of several grids in parallel; in the steps, the
    /// name of a grid is its current cell.
    Each(Vec<String>, Steps),
    /// Executes the steps of another program, named by its file relative to this one.
    Call(String),
    /// Follows an arc to its end.
    Arc(Arc),
    /// Follows a full circle through the current position and two more places.
    Circle(Arc),
    /// Draws a file.
    Drawing(Drawing),
    /// Asks a question, and executes the steps of the answer.
    Choose(Choose),
    /// Sets variables.
    Set(Variables),
    /// Adds to variables.
    Add(Variables),
    /// Repeats steps while a comparison holds.
    While(Condition, Steps),
    /// Picks up an object.
    Pick(Transfer),
    /// Puts an object down.
    Place(Transfer),
}

/// A move to a place, and the state of the tool there.
#[derive(Clone, Debug, PartialEq)]
pub struct Go {
    /// The place.
    pub to: Place,
    /// The offset from the place, along the axes of its frame.
    pub offset: Offset,
    /// The path type; default: a JUMP.
    pub path: MovingMode,
    /// The state of the tool at the place.
    pub then: Here,
}

/// The state of the tool at the current position; omitted values stay unchanged.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Here {
    /// Whether the pump runs from here on.
    pub suction: Option<bool>,
    /// The gripper's angle from here on, -90 to 90 degrees.
    pub gripper: Option<f64>,
    /// The pause, 0 to 655 seconds (note N10); pump and gripper switch at half of it (note N47).
    pub pause: Option<f64>,
}

/// The number of repetitions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Times {
    /// This many times in total, 1 or more.
    Count(u64),
    /// Until a person ends it; allowed only for the last step of the program.
    Forever,
}

/// A mounted tool.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MountedTool {
    /// The kind.
    pub kind: Tool,
    /// The distance from the wrist down to the tip, 0 to 200 mm; default 0. With a length, points
    /// with x, y and z are positions of the tip; with 0 they are positions of the wrist, as in the
    /// arm's statuses.
    #[serde(default, skip_serializing_if = "is_zero", deserialize_with = "finite")]
    pub length: f64,
}

/// A frame taught by three points: its x axis goes from the origin through the second point, its y
/// axis is at right angles to it on the side of the third, and its z axis is at right angles to
/// both (right-handed).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Frame {
    /// The origin.
    pub origin: Place,
    /// A place on the x axis.
    pub x: Place,
    /// A place on the side of the y axis.
    pub y: Place,
}

/// A grid of places: columns along x, rows along y and layers along z of the frame of its first
/// cell, in the order cells of a row, rows, layers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Grid {
    /// The first cell.
    pub at: Place,
    /// The number of cells in a row, 1 to 1000.
    #[serde(default = "one")]
    #[schemars(range(min = 1, max = 1000))]
    pub columns: u32,
    /// The number of rows in a layer, 1 to 1000.
    #[serde(default = "one")]
    #[schemars(range(min = 1, max = 1000))]
    pub rows: u32,
    /// The number of layers, 1 to 1000.
    #[serde(default = "one")]
    #[schemars(range(min = 1, max = 1000))]
    pub layers: u32,
    /// The distance between cells along x, y and z; a negative z goes down, for example from the
    /// top of a stack.
    pub pitch: Offset,
}

/// A displacement along the axes of a frame, in mm.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
#[schemars(extend("examples" = [{"x": 0, "y": 0, "z": 10}]))]
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

/// Speeds of targets (states 9 and 10; Table 3.9). Omitted values stay unchanged; the initial ones
/// are those of an arm after power-up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
#[schemars(extend("examples" = [{"percent": 50}]))]
pub struct Speed {
    /// All speeds of targets, in percent of the ones below, above 0 to 100; initially 50.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    pub percent: Option<f64>,
    /// All accelerations of targets, in percent, above 0 to 100; initially 50.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    pub acceleration_percent: Option<f64>,
    /// The speed of base, rear arm and forearm, in degrees/s; initially 200.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    pub joint: Option<f64>,
    /// The acceleration of base, rear arm and forearm, in degrees/s2; initially 200.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    pub joint_acceleration: Option<f64>,
    /// The speed of the servo, in degrees/s; initially 200.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    pub servo: Option<f64>,
    /// The acceleration of the servo, in degrees/s2; initially 200.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    pub servo_acceleration: Option<f64>,
    /// The speed along a line, in mm/s; initially 100.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    pub line: Option<f64>,
    /// The acceleration along a line, in mm/s2; initially 200.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    pub line_acceleration: Option<f64>,
    /// The lift of a JUMP, in mm, 0 to 300. After power-up it is 10 or 20 mm, depending on the
    /// firmware (note N11); setting one of the speeds above without this sets it to 20.
    #[serde(skip_serializing_if = "Option::is_none", deserialize_with = "perhaps")]
    pub jump_height: Option<f64>,
}

/// An arc or a circle from the current position, given by two more places on it. The arm follows it
/// in straight lines (MOVL) and stops after each: a target can be resent after a lost packet, a
/// vector cannot.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Arc {
    /// A place on the arc.
    pub through: Place,
    /// The end of an arc; the third place of a circle.
    pub to: Place,
    /// The largest distance between the straight lines and the arc, 0.01 to 10 mm; default 0.5.
    #[serde(default = "half_a_millimetre", deserialize_with = "finite")]
    pub tolerance: f64,
}

/// A drawing as a step. The reader of the program prepares it, as `dobot draw` does.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Drawing {
    /// The file of the drawing, relative to the program.
    pub file: String,
    /// The height of the wrist at which the pen touches the paper, in mm.
    #[serde(deserialize_with = "finite")]
    pub pen_down: f64,
    /// The options of `dobot draw`, with their names in a request: `place`, `tool`, `way`, `what`.
    #[serde(default, skip_serializing_if = "toml::Table::is_empty")]
    #[schemars(with = "serde_json::Map<String, serde_json::Value>")]
    pub options: toml::Table,
}

impl Program {
    /// Creates a program of these actions, without names.
    #[must_use]
    pub fn new(actions: Vec<Action>) -> Self {
        Self {
            steps: Steps::new(actions),
            ..Self::default()
        }
    }

    /// Returns the first line of a step, counted from 1; 1 if the program was not read from a text.
    #[must_use]
    pub fn line_of(&self, step: &Spanned<Action>) -> usize {
        self.lines.at(step.span().start)
    }

    /// Returns the JSON Schema of a program.
    #[must_use]
    pub fn schema() -> serde_json::Value {
        schemars::schema_for!(Self).to_value()
    }
}

impl Action {
    /// Returns the steps inside it.
    pub fn inner(&self) -> impl Iterator<Item = &Steps> {
        let (steps, when): (Option<&Steps>, &[When]) = match self {
            Self::Repeat(_, steps) | Self::Each(_, steps) | Self::While(_, steps) => {
                (Some(steps), &[])
            }
            Self::Choose(choose) => (None, &choose.when),
            Self::Pick(transfer) | Self::Place(transfer) => {
                (transfer.missed.as_ref().map(|missed| &missed.steps), &[])
            }
            _ => (None, &[]),
        };
        steps.into_iter().chain(when.iter().map(|when| &when.steps))
    }
}

impl Frame {
    /// The frame of three touched places: its origin, a place on its x axis and one on the side of
    /// its y axis.
    #[must_use]
    pub fn touched(places: &[RecordedPlace; 3]) -> Self {
        let [origin, x, y] = places.map(|place| Place::At(place.point()));
        Self { origin, x, y }
    }
}

impl Steps {
    /// Creates steps that are not from a text.
    #[must_use]
    pub fn new(actions: Vec<Action>) -> Self {
        Self(
            actions
                .into_iter()
                .map(|action| Spanned::new(0..0, action))
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
    /// The number of cells.
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

/// The default distance between the straight lines and an arc, in mm.
pub const DEFAULT_TOLERANCE_MM: f64 = 0.5;
