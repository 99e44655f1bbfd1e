//! The arguments of the tools.

use std::collections::BTreeMap;

use dobot_api::GivenPlace;
use dobot_api::problem_kinds::OUT_OF_RANGE;
use dobot_draw::Options;
use dobot_host::{Target, TargetPlace};
use dobot_wire::{MovingMode, single};
use rmcp::model::JsonObject;
use schemars::JsonSchema;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::refused::Refused;

/// Parses the arguments of a tool.
pub(crate) fn read<T: DeserializeOwned>(arguments: JsonObject) -> Result<T, Refused> {
    serde_path_to_error::deserialize(Value::Object(arguments)).map_err(|error| {
        let path = error.path().to_string();
        let why = error.inner();
        let detail = if path == "." {
            why.to_string()
        } else {
            format!("{path}: {why}")
        };
        Refused::new("invalid", detail).hinted("see the input schema of the tool")
    })
}

/// No arguments.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Nothing {}

/// A point to move to. Omitted values do not change.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ToPoint {
    /// Forward of the base axis, in mm.
    x_mm: f64,
    /// To the left of it, in mm.
    y_mm: f64,
    /// Above the rear arm's pivot, in mm; the table is about 103 mm below it.
    z_mm: f64,
    /// The rotation of the tool in the base frame, in degrees; omitted, the servo does not move.
    rotation_deg: Option<f64>,
    #[serde(flatten)]
    there: There,
}

/// Joint angles to move to. Omitted values do not change.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ToJoints {
    /// The base, in degrees, positive to the left of straight ahead; -135 to 135.
    base_deg: f64,
    /// The rear arm, in degrees from the vertical, positive forward; -5 to 85.
    rear_deg: f64,
    /// The forearm, in degrees below the horizontal; -10 to 95.
    fore_deg: f64,
    /// The servo, in degrees; -90 to 90.
    servo_deg: Option<f64>,
    #[serde(flatten)]
    there: There,
}

/// The path to the target, and the tool state there.
#[derive(Debug, Deserialize, JsonSchema)]
struct There {
    /// jump lifts, moves across and lowers; movl is straight; movj turns all joints together.
    #[serde(default)]
    #[schemars(with = "Path")]
    path: Option<Path>,
    /// Whether the suction cup's pump runs then.
    suction: Option<bool>,
    /// The gripper's angle then, -90 to 90 degrees.
    gripper_deg: Option<f64>,
    /// Seconds to wait there, 0 to 655.
    pause_s: Option<f64>,
}

#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(inline)]
enum Path {
    Jump,
    Movl,
    Movj,
}

impl There {
    fn target(self, place: TargetPlace, servo_deg: Option<f32>) -> Result<Target, Refused> {
        Ok(Target {
            place,
            servo_deg,
            mode: match self.path.unwrap_or(Path::Jump) {
                Path::Jump => MovingMode::Jump,
                Path::Movl => MovingMode::MovL,
                Path::Movj => MovingMode::MovJ,
            },
            suction: self.suction,
            gripper_deg: maybe("gripper_deg", self.gripper_deg)?,
            pause_s: number("pause_s", self.pause_s.unwrap_or(0.0))?,
        })
    }
}

impl ToPoint {
    pub(crate) fn target(self) -> Result<Target, Refused> {
        let mm = [
            number("x_mm", self.x_mm)?,
            number("y_mm", self.y_mm)?,
            number("z_mm", self.z_mm)?,
        ];
        let rotation_deg = maybe("rotation_deg", self.rotation_deg)?;
        self.there
            .target(TargetPlace::Point { mm, rotation_deg }, None)
    }
}

impl ToJoints {
    pub(crate) fn target(self) -> Result<Target, Refused> {
        let joints = [
            number("base_deg", self.base_deg)?,
            number("rear_deg", self.rear_deg)?,
            number("fore_deg", self.fore_deg)?,
        ];
        let servo_deg = maybe("servo_deg", self.servo_deg)?;
        self.there.target(TargetPlace::Joints(joints), servo_deg)
    }
}

/// Converts a number to the arm's precision.
fn number(name: &str, value: f64) -> Result<f32, Refused> {
    let number = single(value);
    if number.is_finite() {
        return Ok(number);
    }
    let detail = format!("{name} is {value}; allowed are -3.4e38 to 3.4e38");
    Err(OUT_OF_RANGE.problem(detail).into())
}

fn maybe(name: &str, value: Option<f64>) -> Result<Option<f32>, Refused> {
    value.map(|value| number(name, value)).transpose()
}

/// A move to check: either to a point or to joint angles.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct CheckMove {
    /// The arguments of `move_to`.
    #[schemars(with = "Option<JsonObject>")]
    move_to: Option<ToPoint>,
    /// The arguments of `move_joints`.
    #[schemars(with = "Option<JsonObject>")]
    move_joints: Option<ToJoints>,
}

impl CheckMove {
    pub(crate) fn target(self) -> Result<Target, Refused> {
        match (self.move_to, self.move_joints) {
            (Some(point), None) => point.target(),
            (None, Some(joints)) => joints.target(),
            _ => Err(Refused::new(
                "invalid",
                "give either `move_to` or `move_joints`",
            )),
        }
    }
}

/// A drawing: one of text, svg and file, or a text or a test card in the options.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct NewDrawing {
    /// A text.
    pub(crate) text: Option<String>,
    /// A whole SVG document.
    pub(crate) svg: Option<String>,
    /// A file in the folder for agents.
    pub(crate) file: Option<String>,
    /// Options in groups, such as `{"place": {"pen_down": -40}, "tool": {"speed": 30}}`; the
    /// resource `dobot://drawing-options` describes them.
    #[serde(default)]
    #[schemars(with = "JsonObject")]
    pub(crate) options: Options,
}

/// A planned drawing.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct PlannedDrawing {
    /// The number returned by `plan_drawing`.
    pub(crate) drawing: u64,
    /// Seconds to wait for its end, 0 to 3600; it continues afterwards.
    #[serde(default = "half_a_minute")]
    #[schemars(range(min = 0.0, max = 3600.0))]
    pub(crate) wait_s: f64,
}

/// A program: either text or file.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ProgramArguments {
    /// The TOML text of the program.
    pub(crate) text: Option<String>,
    /// A TOML file in the folder for agents.
    pub(crate) file: Option<String>,
    /// The texts of the programs and drawings that it uses, by name.
    #[serde(default)]
    pub(crate) files: BTreeMap<String, String>,
}

/// A program to run.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct RunProgram {
    /// The arguments of `check_program`.
    #[schemars(with = "JsonObject")]
    pub(crate) program: ProgramArguments,
    /// The number of repetitions; by default that of the program.
    #[schemars(range(min = 1))]
    pub(crate) times: Option<u64>,
    /// Seconds to wait for its end, 0 to 3600; it continues afterwards.
    #[serde(default = "half_a_minute")]
    #[schemars(range(min = 0.0, max = 3600.0))]
    pub(crate) wait_s: f64,
}

/// A program, in the format of the station.
#[derive(Debug, Serialize)]
pub(crate) struct ProgramText {
    pub(crate) text: String,
    pub(crate) files: BTreeMap<String, String>,
}

/// The jobs to return.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct WhichJobs {
    /// One job; omitted, all unfinished and the latest finished ones.
    pub(crate) job: Option<u64>,
    /// Seconds to wait until that job stops running, 0 to 3600.
    #[serde(default)]
    #[schemars(range(min = 0.0, max = 3600.0))]
    pub(crate) wait_s: f64,
}

/// A change of a job.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ChangeJob {
    /// Its number.
    pub(crate) job: u64,
    /// A cancelled job cannot be resumed.
    pub(crate) action: JobAction,
    /// Seconds to wait for its end after `resume`, 0 to 3600.
    #[serde(default = "half_a_minute")]
    #[schemars(range(min = 0.0, max = 3600.0))]
    pub(crate) wait_s: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
#[schemars(inline)]
pub(crate) enum JobAction {
    Pause,
    Resume,
    Cancel,
}

/// The answer to the question of a program: either answer or place.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct AnswerJob {
    /// The number of the job.
    pub(crate) job: u64,
    /// One of the possible answers.
    pub(crate) answer: Option<String>,
    /// The position that it asks for: `x_mm`, `y_mm` and `z_mm` of the tool's tip, and optionally
    /// `rotation_deg`.
    #[schemars(with = "Option<JsonObject>")]
    pub(crate) place: Option<GivenPlace>,
    /// Seconds to wait for its end, 0 to 3600; it continues afterwards.
    #[serde(default = "half_a_minute")]
    #[schemars(range(min = 0.0, max = 3600.0))]
    pub(crate) wait_s: f64,
}

/// The reason of a stop.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct StopArguments {
    /// The reason, shown at the stopped arm.
    pub(crate) reason: Option<String>,
}

const fn half_a_minute() -> f64 {
    30.0
}
