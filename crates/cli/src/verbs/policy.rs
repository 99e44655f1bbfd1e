//! `dobot policy`: shows and checks the safety policy.

use std::path::PathBuf;

use anyhow::{Context, anyhow};
use clap::{Subcommand, ValueEnum};
use dobot_arm::{Degrees, Pose, Position, Tool};
use dobot_motion::{ArmPlace, Model};
use dobot_safety::Policy;
use dobot_wire::{Dialect, MoveTo, MovingMode, single};

use crate::connect::read_policy;
use crate::failure::Failure;
use crate::output;

/// Show and check the safety policy: what no command may make the arm do
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot policy > policy.toml              begin with the default: every key, with a comment
  dobot policy check policy.toml          after each change
  dobot policy show policy.toml           what is in force, the defaults of missing keys included
  dobot policy schema > policy.json       the JSON Schema, for editors
  dobot policy test 200 100 0 --from 200 -100 0 --path movl --policy policy.toml
                                          would this move be allowed, and if not, why not?")]
pub(crate) struct Args {
    #[command(subcommand)]
    action: Option<Action>,
}

#[derive(Clone, Debug, Subcommand)]
enum Action {
    /// Print what is in force with a policy file, the defaults of missing keys included
    Show {
        /// The policy, a TOML file
        file: PathBuf,
    },
    /// Check a policy file
    Check {
        /// The policy, a TOML file
        file: PathBuf,
    },
    /// Print the JSON Schema of a policy
    Schema,
    /// Tell whether a move would be allowed: 0 yes, 1 no and why
    #[command(allow_negative_numbers = true)]
    Test(Test),
}

#[derive(Clone, Debug, clap::Args)]
struct Test {
    /// Where to, in mm
    #[arg(num_args = 3, value_names = ["X", "Y", "Z"], required = true)]
    target: Vec<f32>,
    /// Where from, in mm
    #[arg(long, num_args = 3, value_names = ["X", "Y", "Z"], required = true)]
    from: Vec<f32>,
    /// The way
    #[arg(long, value_enum, default_value_t = Way::Movl)]
    path: Way,
    /// The policy, a TOML file; the default policy if it is not given
    #[arg(long, value_name = "FILE")]
    policy: Option<PathBuf>,
    /// Which arm: specification or firmware-1.1
    #[arg(long, default_value_t = Dialect::FIRMWARE_1_1)]
    dialect: Dialect,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Way {
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
            output::line(&format!("{} is a good policy", file.display()))?;
        }
        Some(Action::Schema) => print(&serde_json::to_string_pretty(&Policy::json_schema())?)?,
        Some(Action::Test(test)) => output::line(&judge(test)?)?,
    }
    Ok(())
}

fn print(text: &str) -> std::io::Result<()> {
    output::line(text.trim_end())
}

/// Whether the move is allowed, at the speeds of an arm that has just been switched on.
fn judge(test: &Test) -> Result<String, Failure> {
    let policy = test
        .policy
        .as_deref()
        .map_or(Ok(Policy::default()), read_policy)?;
    let from = place(&test.from)
        .with_context(|| format!("the arm cannot stand at {}", told(&test.from)))?;
    let model = Model::standing(test.dialect, from);
    match policy.check(&model, &command(test).into()) {
        Ok(trajectory) => {
            let motion_s = trajectory.lasts_s().unwrap_or_default();
            Ok(format!(
                "allowed: {} in {motion_s:.2} s",
                told(&test.target)
            ))
        }
        Err(violation) => Err(anyhow!("refused by {}: {violation}", violation.rule).into()),
    }
}

/// With the tool straight on, as it is with the servo in its middle.
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
            Way::Jump => MovingMode::Jump,
            Way::Movl => MovingMode::MovL,
            Way::Movj => MovingMode::MovJ,
        },
        ..MoveTo::to(x_mm, y_mm, z_mm)
    }
}

fn position(numbers: &[f32]) -> Position {
    Position::new(numbers[0].into(), numbers[1].into(), numbers[2].into())
}

fn told(numbers: &[f32]) -> String {
    format!("x {} y {} z {} mm", numbers[0], numbers[1], numbers[2])
}
