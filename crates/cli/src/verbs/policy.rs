//! `dobot policy`: shows, checks and tests the safety policy.

use std::path::PathBuf;

use anyhow::{Context, anyhow};
use clap::{Subcommand, ValueEnum};
use dobot_arm::{Degrees, Pose, Position, Tool};
use dobot_motion::{ArmPlace, Model};
use dobot_safety::Policy;
use dobot_wire::{Dialect, MoveTo, MovingMode, single};

use crate::connect::read_policy;
use crate::failure::Failure;
use crate::{output, values};

/// Show, check and test the safety policy
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot policy > policy.toml          the default policy, with a comment on each key
  dobot policy check policy.toml      check it after each change
  dobot policy show policy.toml       the policy with the defaults of missing keys
  dobot policy schema > policy.json   the JSON Schema, for editors
  dobot policy test 200 100 0 --start-point 200 -100 0 --policy policy.toml
                                      whether a move is allowed, or why not

The policy limits what every command may make the arm do.")]
pub(crate) struct Args {
    #[command(subcommand)]
    action: Option<Action>,
}

#[derive(Clone, Debug, Subcommand)]
enum Action {
    /// Print a policy with the defaults of missing keys
    Show {
        /// Safety policy, a TOML file
        file: PathBuf,
    },
    /// Check a policy file
    Check {
        /// Safety policy, a TOML file
        file: PathBuf,
    },
    /// Print the JSON Schema of a policy
    Schema,
    /// Test whether a move is allowed; exit code 0 if it is, otherwise 1
    #[command(allow_negative_numbers = true)]
    Test(Test),
}

#[derive(Clone, Debug, clap::Args)]
struct Test {
    /// Target point, in mm
    #[arg(num_args = 3, value_names = ["X", "Y", "Z"], required = true, action = clap::ArgAction::Set, value_parser = values::finite)]
    target: Vec<f32>,
    /// Start point, in mm
    #[arg(long, num_args = 3, value_names = ["X", "Y", "Z"], required = true, action = clap::ArgAction::Set, value_parser = values::finite)]
    start_point: Vec<f32>,
    /// Path type
    #[arg(long, value_enum, default_value_t = PathType::Movl)]
    path: PathType,
    /// Safety policy, a TOML file (default: as printed by `dobot policy`)
    #[arg(long, value_name = "FILE")]
    policy: Option<PathBuf>,
    /// Protocol dialect of the arm: specification or firmware-1.1
    #[arg(long, value_name = "DIALECT", default_value_t = Dialect::FIRMWARE_1_1)]
    dialect: Dialect,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum PathType {
    Jump,
    Movl,
    Movj,
}

pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    match &args.action {
        None => print(Policy::DEFAULT_TOML)?,
        Some(Action::Show { file }) => print(&read_policy(file)?.to_toml())?,
        Some(Action::Check { file }) => {
            read_policy(file)?;
            output::line(&format!("{} is a valid policy", file.display()))?;
        }
        Some(Action::Schema) => print(&serde_json::to_string_pretty(&Policy::json_schema())?)?,
        Some(Action::Test(test)) => output::line(&judge(test)?)?,
    }
    Ok(())
}

fn print(text: &str) -> std::io::Result<()> {
    output::line(text.trim_end())
}

/// Tests a move at the speeds of an arm that was just switched on.
fn judge(test: &Test) -> Result<String, Failure> {
    let policy = test
        .policy
        .as_deref()
        .map_or(Ok(Policy::default()), read_policy)?;
    let from = place(&test.start_point)
        .with_context(|| format!("the arm cannot reach {}", text(&test.start_point)))?;
    let model = Model::standing(test.dialect, from);
    match policy.check(&model, &command(test).into()) {
        Ok(trajectory) => {
            let motion_s = trajectory.lasts_s().unwrap_or_default();
            Ok(format!(
                "allowed: {} in {motion_s:.2} s",
                text(&test.target)
            ))
        }
        Err(violation) => Err(anyhow!("refused by {}: {violation}", violation.rule).into()),
    }
}

/// The place of the arm at a point with its tool straight ahead, as with the servo centred.
fn place(from: &[f32]) -> Result<ArmPlace, dobot_arm::Unreachable> {
    let position = position(from);
    let pose = Pose {
        position,
        rotation: position.direction(),
    };
    ArmPlace::at_pose(pose, Tool::SuctionCup)
}

fn command(test: &Test) -> MoveTo {
    let Degrees(rotation_deg) = position(&test.target).direction();
    let [x_mm, y_mm, z_mm] = [test.target[0], test.target[1], test.target[2]];
    MoveTo {
        rotation_deg: single(rotation_deg),
        mode: match test.path {
            PathType::Jump => MovingMode::Jump,
            PathType::Movl => MovingMode::MovL,
            PathType::Movj => MovingMode::MovJ,
        },
        ..MoveTo::to(x_mm, y_mm, z_mm)
    }
}

fn position(numbers: &[f32]) -> Position {
    Position::new(numbers[0].into(), numbers[1].into(), numbers[2].into())
}

fn text(numbers: &[f32]) -> String {
    format!("x {} y {} z {} mm", numbers[0], numbers[1], numbers[2])
}
