//! `dobot set`: configures the arm (states 9 and 10).

use clap::Subcommand;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use dobot_arm::Tool;
use dobot_host::StationClient;
use dobot_wire::{Command, Configuration, PlaybackAdjustment};

use crate::connect::To;
use crate::control::{self, run_command, take_control};
use crate::failure::Failure;
use crate::{output, values};

/// Configure the arm: tool, speeds, accelerations, angles (states 9, 10)
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot set tool laser --to serial:/dev/ttyUSB0
  dobot set writing --acceleration 200
  dobot set percent --speed-percent 50 --acceleration-percent 50

An arm receives all values of a group together and cannot report them: values
that are not given are set to the defaults in `dobot set GROUP --help`. The arm
forgets them when it is switched off.")]
pub(crate) struct Args {
    #[command(subcommand)]
    group: Group,
    #[command(flatten)]
    to: CommonArgs,
}

/// The options of all groups, before or after the group.
#[derive(Clone, Debug, clap::Args)]
struct CommonArgs {
    #[command(flatten)]
    to: To,
    /// Print the last status as JSON
    #[arg(long, global = true)]
    json: bool,
}

#[derive(Clone, Debug, Subcommand)]
enum Group {
    /// Set the end effector (state 9, mode 4)
    Tool {
        /// Mounted tool
        #[arg(value_parser = tool())]
        tool: Tool,
    },
    /// Set the jog speeds (state 9, mode 0)
    Jog {
        /// Joint speed at 100 %, in degrees/s
        #[arg(long, value_name = "DEG/S", default_value = "15", value_parser = values::positive)]
        joint_speed: f32,
        /// Joint acceleration, in degrees/s²
        #[arg(long, value_name = "DEG/S2", default_value = "50", value_parser = values::positive)]
        joint_acceleration: f32,
        /// Servo speed, in degrees/s
        #[arg(long, value_name = "DEG/S", default_value = "30", value_parser = values::positive)]
        servo_speed: f32,
        /// Servo acceleration, in degrees/s²
        #[arg(long, value_name = "DEG/S2", default_value = "50", value_parser = values::positive)]
        servo_acceleration: f32,
        /// Linear speed, in mm/s
        #[arg(long, value_name = "MM/S", default_value = "60", value_parser = values::positive)]
        linear_speed: f32,
        /// Linear acceleration, in mm/s²
        #[arg(long, value_name = "MM/S2", default_value = "60", value_parser = values::positive)]
        linear_acceleration: f32,
    },
    /// Set the speeds, default pause and JUMP height of moves (state 9, mode 1)
    Moves {
        /// Joint speed at 100 %, in degrees/s
        #[arg(long, value_name = "DEG/S", default_value = "200", value_parser = values::positive)]
        joint_speed: f32,
        /// Joint acceleration, in degrees/s²
        #[arg(long, value_name = "DEG/S2", default_value = "200", value_parser = values::positive)]
        joint_acceleration: f32,
        /// Servo speed, in degrees/s
        #[arg(long, value_name = "DEG/S", default_value = "200", value_parser = values::positive)]
        servo_speed: f32,
        /// Servo acceleration, in degrees/s²
        #[arg(long, value_name = "DEG/S2", default_value = "200", value_parser = values::positive)]
        servo_acceleration: f32,
        /// Linear speed, in mm/s
        #[arg(long, value_name = "MM/S", default_value = "100", value_parser = values::positive)]
        linear_speed: f32,
        /// Linear acceleration, in mm/s²
        #[arg(long, value_name = "MM/S2", default_value = "200", value_parser = values::positive)]
        linear_acceleration: f32,
        /// Default pause, 0 to 655 seconds; ignored by arms as sold
        #[arg(long, value_name = "SECONDS", default_value = "0", value_parser = values::number(0.0..=655.0_f32, "seconds"))]
        pause: f32,
        /// Height of a JUMP, in mm
        #[arg(long, value_name = "MM", default_value = "20", value_parser = values::non_negative)]
        jump_height: f32,
    },
    /// Set the writing acceleration (state 9, mode 2)
    Writing {
        /// Acceleration, in mm/s²
        #[arg(long, value_name = "MM/S2", default_value = "100", value_parser = values::positive)]
        acceleration: f32,
    },
    /// Set the current joint angles (state 9, mode 3); the base becomes 0
    #[command(allow_negative_numbers = true)]
    Angles {
        /// Angle of the rear arm, in degrees from the vertical
        #[arg(value_parser = values::finite)]
        rear: f32,
        /// Angle of the forearm, in degrees below the horizontal
        #[arg(value_parser = values::finite)]
        fore: f32,
    },
    /// Set the percentages of speeds and accelerations (state 10)
    Percent {
        /// Speed of moves, above 0 to 100 percent
        #[arg(long, value_name = "PERCENT", default_value = "50", value_parser = values::percent)]
        speed_percent: f32,
        /// Acceleration of moves, above 0 to 100 percent
        #[arg(long, value_name = "PERCENT", default_value = "50", value_parser = values::percent)]
        acceleration_percent: f32,
        /// Jog speed, above 0 to 100 percent; ignored by arms as sold
        #[arg(long, value_name = "PERCENT", default_value = "100", value_parser = values::percent)]
        jog_percent: f32,
    },
}

/// Returns a parser of tool names.
fn tool() -> impl TypedValueParser<Value = Tool> {
    let names = PossibleValuesParser::new(Tool::ALL.map(Tool::option));
    names.map(|name| Tool::named(&name).expect("each of the names is that of a tool"))
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let command = command(&args.group);
    let set = async |station: &mut StationClient| {
        control::status(station).await?;
        take_control(station).await?;
        run_command(station, command).await?;
        control::wait_for_rest(station).await
    };
    let status = args.to.to.with_arm("set", set).await?;
    Ok(output::status(&status, args.to.json)?)
}

fn command(group: &Group) -> Command {
    match *group {
        Group::Tool { tool } => Configuration::EndEffector { tool: tool.into() }.into(),
        Group::Jog {
            joint_speed,
            joint_acceleration,
            servo_speed,
            servo_acceleration,
            linear_speed,
            linear_acceleration,
        } => Configuration::teach([
            joint_speed,
            joint_acceleration,
            servo_speed,
            servo_acceleration,
            linear_speed,
            linear_acceleration,
        ])
        .into(),
        Group::Moves {
            joint_speed,
            joint_acceleration,
            servo_speed,
            servo_acceleration,
            linear_speed,
            linear_acceleration,
            pause,
            jump_height,
        } => Configuration::playback(
            [
                joint_speed,
                joint_acceleration,
                servo_speed,
                servo_acceleration,
                linear_speed,
                linear_acceleration,
            ],
            pause,
            jump_height,
        )
        .into(),
        Group::Writing { acceleration } => Configuration::Writing {
            acceleration_mm_s2: acceleration,
        }
        .into(),
        Group::Angles { rear, fore } => Configuration::InitialAngles {
            rear_deg: rear,
            fore_deg: fore,
        }
        .into(),
        Group::Percent {
            speed_percent,
            acceleration_percent,
            jog_percent,
        } => PlaybackAdjustment {
            speed_percent,
            acceleration_percent,
            teach_speed_percent: jog_percent,
        }
        .into(),
    }
}
