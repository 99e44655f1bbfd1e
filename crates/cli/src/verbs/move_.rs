//! `dobot move`: go to a point or to joint angles.

use dobot_arm::{Degrees, Joints, Limits, Pose, Position, Tool, Unreachable, inverse};
use dobot_host::{PathName, StationClient, Target, TargetPlace};
use dobot_wire::{Command, Status};

use crate::connect::To;
use crate::control::carry_out_one;
use crate::failure::Failure;
use crate::output;

/// Go to a point or to joint angles
#[derive(Debug, clap::Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "\
Examples:
  dobot move 220 0 30                               to a point, lifted (JUMP)
  dobot move 220 50 30 --path movl                  to a point, in a straight line
  dobot move --joints 30 45 40                      base, rear arm and forearm in degrees
  dobot move 220 0 -20 --suction on --pause 0.5     go, then grab

Points are millimetres in the base frame: x forward, y left, z up from the pivot of the rear arm,
about 103 mm above the table. Tool, gripper and suction stay as they are unless told otherwise.
Ctrl-C stops the arm. A move that has begun goes on to its end, for the protocol has no stop."
)]
pub(crate) struct Args {
    /// The point, in millimetres
    #[arg(num_args = 3, value_names = ["X", "Y", "Z"], required_unless_present = "joints")]
    point: Vec<f32>,
    /// The joint angles instead of a point, in degrees
    #[arg(long, num_args = 3, value_names = ["BASE", "REAR", "FORE"], conflicts_with_all = ["point", "rotation"])]
    joints: Option<Vec<f32>>,
    /// How the tool is turned relative to the base frame, in degrees (default: the servo stays)
    #[arg(long, value_name = "DEGREES", conflicts_with = "servo")]
    rotation: Option<f32>,
    /// The servo's angle, in degrees (default: it stays)
    #[arg(long, value_name = "DEGREES")]
    servo: Option<f32>,
    /// The way there: jump, movl or movj
    #[arg(long, default_value = "jump")]
    path: PathName,
    /// The suction cup, once there: on or off
    #[arg(long, value_name = "on|off", value_parser = on_off)]
    suction: Option<bool>,
    /// The gripper's angle, once there, in degrees from -90 to 90
    #[arg(long, value_name = "DEGREES")]
    gripper: Option<f32>,
    /// How long to wait there, in seconds
    #[arg(long, value_name = "SECONDS", default_value_t = 0.0)]
    pause: f32,
    #[command(flatten)]
    to: To,
    /// Print the last status as JSON
    #[arg(long)]
    json: bool,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let go = async |station: &mut StationClient| {
        let command = |status: &Status, _| args.command(status);
        carry_out_one(station, &args.to, None, command).await
    };
    let status = args.to.with_arm("move", go).await?;
    Ok(output::status(&status, args.json)?)
}

impl Args {
    fn command(&self, from: &Status) -> Result<Command, Failure> {
        let place = match &self.joints {
            Some(joints) => TargetPlace::Joints(three(joints)),
            None => TargetPlace::Point {
                mm: three(&self.point),
                rotation_deg: self.rotation,
            },
        };
        let target = Target {
            place,
            servo_deg: self.servo,
            mode: self.path.0,
            suction: self.suction,
            gripper_deg: self.gripper,
            pause_s: self.pause,
        };
        let command = target.command(from);
        check(&command).map_err(out_of_reach)?;
        Ok(command)
    }
}

/// A switch on the command line.
pub(crate) fn on_off(text: &str) -> Result<bool, &'static str> {
    match text {
        "on" => Ok(true),
        "off" => Ok(false),
        _ => Err("allowed are on and off"),
    }
}

fn three(values: &[f32]) -> [f32; 3] {
    values.try_into().expect("the command line takes three")
}

fn check(command: &Command) -> Result<(), Unreachable> {
    match command {
        Command::MoveTo(it) => check_point([it.x_mm, it.y_mm, it.z_mm], it.rotation_deg),
        Command::MoveJoints(it) => {
            check_joints([it.base_deg, it.rear_deg, it.fore_deg, it.servo_deg])
        }
        _ => Ok(()),
    }
}

/// The reach of the tool is not in a status, so what any tool allows is let through.
fn check_point(point: [f32; 3], rotation_deg: f32) -> Result<(), Unreachable> {
    let [x, y, z] = point.map(f64::from);
    let pose = Pose {
        position: Position::new(x, y, z),
        rotation: Degrees(rotation_deg.into()),
    };
    any_tool(|tool| {
        let joints = inverse(&pose, tool)?;
        Limits::STOCK.check_at(&joints, pose.position)
    })
}

fn check_joints(joints: [f32; 4]) -> Result<(), Unreachable> {
    let [base, rear, fore, servo] = joints.map(f64::from);
    any_tool(|tool| Limits::STOCK.check(&Joints::new(base, rear, fore, servo), tool))
}

fn any_tool(check: impl Fn(Tool) -> Result<(), Unreachable>) -> Result<(), Unreachable> {
    if Tool::ALL.into_iter().any(|tool| check(tool).is_ok()) {
        return Ok(());
    }
    check(Tool::default())
}

fn out_of_reach(error: Unreachable) -> Failure {
    Failure::new(
        anyhow::Error::from(error).context("the target is out of reach"),
        "nothing was sent; `dobot status` tells where the arm is now",
    )
}
