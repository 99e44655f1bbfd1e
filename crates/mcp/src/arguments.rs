//! What agents say to the tools.

use std::collections::BTreeMap;

use dobot_api::problem_kinds::OUT_OF_RANGE;
use dobot_draw::{Format, Options};
use dobot_host::{Target, TargetPlace};
use dobot_wire::{MovingMode, single};
use rmcp::model::JsonObject;
use schemars::JsonSchema;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::refused::Refused;

/// Reads the arguments of a tool.
pub(crate) fn read<T: DeserializeOwned>(arguments: JsonObject) -> Result<T, Refused> {
    serde_path_to_error::deserialize(Value::Object(arguments)).map_err(|error| {
        let path = error.path().to_string();
        let why = error.inner();
        let detail = if path == "." {
            why.to_string()
        } else {
            format!("{path}: {why}")
        };
        Refused::new("invalid", detail).hinted("the input schema of the tool tells what it takes")
    })
}

/// Nothing.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Nothing {}

/// A point to go to. What is left out stays as it is.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ToPoint {
    /// Forward of the base's axis, in millimetres.
    x_mm: f64,
    /// To the left of it, in millimetres.
    y_mm: f64,
    /// Above the rear arm's pivot, in millimetres; the table is about 103 mm below it.
    z_mm: f64,
    /// How the tool is turned relative to the base frame, in degrees; without it the servo stays.
    rotation_deg: Option<f64>,
    #[serde(flatten)]
    there: There,
}

/// Joint angles to go to. What is left out stays as it is.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ToJoints {
    /// The base, in degrees, to the left of straight ahead.
    base_deg: f64,
    /// The rear arm, in degrees.
    rear_deg: f64,
    /// The forearm, in degrees.
    fore_deg: f64,
    /// The servo, in degrees.
    servo_deg: Option<f64>,
    #[serde(flatten)]
    there: There,
}

/// How to go there, and what to do there.
#[derive(Debug, Deserialize, JsonSchema)]
struct There {
    /// The way there: jump lifts, goes across and lowers; movl goes straight; movj moves all joints at once.
    path: Option<Path>,
    /// Whether the pump of the suction cup runs, once there.
    suction: Option<bool>,
    /// The gripper's angle, once there, in degrees from -90 to 90.
    gripper_deg: Option<f64>,
    /// How long to wait there, in seconds.
    pause_s: Option<f64>,
}

#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
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

/// A number as the arm has it.
fn number(name: &str, value: f64) -> Result<f32, Refused> {
    let number = single(value);
    if number.is_finite() {
        return Ok(number);
    }
    let detail = format!("{name} is {value}; allowed is what a number of 32 bits can be");
    Err(OUT_OF_RANGE.problem(detail).into())
}

fn maybe(name: &str, value: Option<f64>) -> Result<Option<f32>, Refused> {
    value.map(|value| number(name, value)).transpose()
}

/// A move that is only looked at: one of both.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct CheckMove {
    /// What `move_to` would be told.
    move_to: Option<ToPoint>,
    /// What `move_joints` would be told.
    move_joints: Option<ToJoints>,
}

impl CheckMove {
    pub(crate) fn target(self) -> Result<Target, Refused> {
        match (self.move_to, self.move_joints) {
            (Some(point), None) => point.target(),
            (None, Some(joints)) => joints.target(),
            _ => Err(Refused::new(
                "invalid",
                "it takes either `move_to` or `move_joints`",
            )),
        }
    }
}

/// What is to be drawn: one of text, svg and file, or a text or a test card of the options.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct NewDrawing {
    /// A text, drawn in letters of single lines.
    pub(crate) text: Option<String>,
    /// A whole SVG document.
    pub(crate) svg: Option<String>,
    /// A file of the folder for agents.
    #[schemars(description = file_description())]
    pub(crate) file: Option<String>,
    /// How it is drawn, as the arguments of `dobot draw`.
    #[serde(default)]
    pub(crate) options: Options,
}

fn file_description() -> String {
    let formats = Format::names(|_| true, "or");
    format!("A file of the folder for agents, in one of the formats {formats}")
}

/// A drawing that was planned.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct PlannedDrawing {
    /// The number that `plan_drawing` gave.
    pub(crate) drawing: u64,
    /// How long to wait for its end, in seconds; it goes on afterwards.
    #[serde(default = "half_a_minute")]
    #[schemars(range(min = 0.0, max = 3600.0))]
    pub(crate) wait_s: f64,
}

/// A program: one of text and file.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ProgramArguments {
    /// The TOML text of the program.
    pub(crate) text: Option<String>,
    /// A TOML file of the folder for agents.
    pub(crate) file: Option<String>,
    /// The texts of the programs and drawings that it names, by their names in it.
    #[serde(default)]
    pub(crate) files: BTreeMap<String, String>,
}

/// A program that is to run.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct RunProgram {
    /// The program.
    pub(crate) program: ProgramArguments,
    /// How often it is done; without this as often as it says itself.
    #[schemars(range(min = 1))]
    pub(crate) times: Option<u64>,
    /// How long to wait for its end, in seconds; it goes on afterwards.
    #[serde(default = "half_a_minute")]
    #[schemars(range(min = 0.0, max = 3600.0))]
    pub(crate) wait_s: f64,
}

/// The program, as the station takes it.
#[derive(Debug, Serialize)]
pub(crate) struct ProgramText {
    pub(crate) text: String,
    pub(crate) files: BTreeMap<String, String>,
}

/// Which jobs.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct WhichJobs {
    /// One of them; without it all that are not over, and the latest that are.
    pub(crate) job: Option<u64>,
    /// How long to wait until that job does not run any more, in seconds.
    #[serde(default)]
    #[schemars(range(min = 0.0, max = 3600.0))]
    pub(crate) wait_s: f64,
}

/// What is to become of a job.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ChangeJob {
    /// Its number.
    pub(crate) job: u64,
    /// What to do with it.
    pub(crate) action: JobAction,
    /// After `resume`: how long to wait for its end, in seconds; it goes on afterwards.
    #[serde(default = "half_a_minute")]
    #[schemars(range(min = 0.0, max = 3600.0))]
    pub(crate) wait_s: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(crate) enum JobAction {
    /// The tool goes up, and the job can be gone on with.
    Pause,
    /// Start it, or go on with it.
    Resume,
    /// End it for good.
    Cancel,
}

/// Why the arm is to stop.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct StopArguments {
    /// Why, for those who find the arm stopped.
    pub(crate) reason: Option<String>,
}

const fn half_a_minute() -> f64 {
    30.0
}
