//! `dobot move`: moves to a point or to joint angles.

use dobot_arm::{Degrees, Joints, Limits, Pose, Position, Tool, Unreachable, inverse};
use dobot_host::{PathName, StationClient, Target, TargetPlace};
use dobot_wire::{Command, Status};

use crate::connect::To;
use crate::control::run_one_command;
use crate::failure::Failure;
use crate::{output, values};

/// Move to a point or to joint angles
#[derive(Debug, clap::Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "\
Examples:
  dobot move 220 0 30                             to a point, lifted (JUMP)
  dobot move 220 50 30 --path movl                to a point, in a straight line
  dobot move --joints 30 45 40                    base, rear arm and forearm
  dobot move 220 0 -20 --suction on --pause 0.5   move, then pick up

Points are in the base frame, in millimetres: x forward, y left, z up from the
pivot of the rear arm, about 103 mm above the table. Tool, gripper and suction
stay unchanged unless an option sets them.

Ctrl-C stops the arm. A move in progress runs to its end, because the protocol
has no stop command."
)]
pub(crate) struct Args {
    /// Target point, in mm
    #[arg(num_args = 3, value_names = ["X", "Y", "Z"], required_unless_present = "joints", action = clap::ArgAction::Set, value_parser = values::finite)]
    point: Vec<f32>,
    /// Joint angles instead of a point, in degrees
    #[arg(long, num_args = 3, value_names = ["BASE", "REAR", "FORE"], conflicts_with_all = ["point", "rotation"], value_parser = values::finite)]
    joints: Option<Vec<f32>>,
    /// Rotation of the tool relative to the base frame, in degrees (default: the servo stays)
    #[arg(long, value_name = "DEGREES", conflicts_with = "servo", value_parser = values::finite)]
    rotation: Option<f32>,
    /// Angle of the servo, in degrees (default: unchanged)
    #[arg(long, value_name = "DEGREES", value_parser = values::finite)]
    servo: Option<f32>,
    /// Path type: jump, movl (straight line) or movj (joints)
    #[arg(long, default_value = "jump")]
    path: PathName,
    /// Suction cup at the target, on or off (default: unchanged)
    #[arg(long, value_name = "on|off", value_parser = values::on_off)]
    suction: Option<bool>,
    /// Angle of the gripper at the target, -90 to 90 degrees (default: unchanged)
    #[arg(long, value_name = "DEGREES", value_parser = values::number(-90.0..=90.0_f32, "degrees"))]
    gripper: Option<f32>,
    /// Pause at the target, 0 to 655 seconds
    #[arg(long, value_name = "SECONDS", default_value = "0", value_parser = values::number(0.0..=655.0_f32, "seconds"))]
    pause: f32,
    #[command(flatten)]
    to: To,
    /// Print the last status as JSON
    #[arg(long)]
    json: bool,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    if let Some(warning) = args.place().unit_warning() {
        eprintln!("warning: {warning}");
    }
    let go = async |station: &mut StationClient| {
        let command = |status: &Status, _| args.command(status);
        run_one_command(station, &args.to, None, command).await
    };
    let status = args.to.with_arm("move", go).await?;
    Ok(output::status(&status, args.json)?)
}

impl Args {
    fn place(&self) -> TargetPlace {
        match &self.joints {
            Some(joints) => TargetPlace::Joints(three(joints)),
            None => TargetPlace::Point {
                mm: three(&self.point),
                rotation_deg: self.rotation,
            },
        }
    }

    fn command(&self, from: &Status) -> Result<Command, Failure> {
        let target = Target {
            place: self.place(),
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

fn three(values: &[f32]) -> [f32; 3] {
    values.try_into().expect("the command line takes three")
}

fn check(command: &Command) -> Result<(), Unreachable> {
    match command {
        Command::MoveTo(to) => check_point([to.x_mm, to.y_mm, to.z_mm], to.rotation_deg),
        Command::MoveJoints(to) => {
            check_joints([to.base_deg, to.rear_deg, to.fore_deg, to.servo_deg])
        }
        _ => Ok(()),
    }
}

/// Checks a point. A status does not contain the tool, so a point within reach of any tool passes.
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
        "choose another target; nothing was sent, and `dobot status` shows where the arm is",
    )
}
