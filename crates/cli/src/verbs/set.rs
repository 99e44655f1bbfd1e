//! `dobot set`: configuration (states 9 and 10).

use clap::Subcommand;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use dobot_arm::Tool;
use dobot_host::StationClient;
use dobot_wire::{Command, Configuration, PlaybackAdjustment};

use crate::connect::To;
use crate::control::{self, carry_out, take_control};
use crate::failure::Failure;
use crate::output;

/// Configure the arm
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot set tool laser --to serial:/dev/ttyUSB0
  dobot set writing --acceleration 200 --to serial:/dev/ttyUSB0
  dobot set percent --speed 50 --acceleration 50 --dialect firmware-1.1 --to serial:/dev/ttyUSB0

An arm takes all values of a group at once and cannot be asked for them: those that are not given get the
values shown in `dobot set GROUP --help`. An arm forgets them when it is switched off.")]
pub(crate) struct Args {
    #[command(subcommand)]
    group: Group,
    #[command(flatten)]
    to: Way,
}

/// `--to` and `--dialect`, before or behind the group.
#[derive(Clone, Debug, clap::Args)]
struct Way {
    #[command(flatten)]
    to: To,
    /// Print the last status as JSON
    #[arg(long, global = true)]
    json: bool,
}

#[derive(Clone, Debug, Subcommand)]
enum Group {
    /// The end effector (state 9, mode 4)
    Tool {
        /// What is mounted
        #[arg(value_parser = tool())]
        tool: Tool,
    },
    /// Speeds of jogging (state 9, mode 0)
    Jog {
        /// Joint speed at 100 %, in degrees/s
        #[arg(long, default_value_t = 15.0)]
        joint_speed: f32,
        /// Joint acceleration, in degrees/s²
        #[arg(long, default_value_t = 50.0)]
        joint_acceleration: f32,
        /// Servo speed, in degrees/s
        #[arg(long, default_value_t = 30.0)]
        servo_speed: f32,
        /// Servo acceleration, in degrees/s²
        #[arg(long, default_value_t = 50.0)]
        servo_acceleration: f32,
        /// Linear speed, in mm/s
        #[arg(long, default_value_t = 60.0)]
        linear_speed: f32,
        /// Linear acceleration, in mm/s²
        #[arg(long, default_value_t = 60.0)]
        linear_acceleration: f32,
    },
    /// Speeds of moves, default pause and height of a JUMP (state 9, mode 1)
    Moves {
        /// Joint speed at 100 %, in degrees/s
        #[arg(long, default_value_t = 200.0)]
        joint_speed: f32,
        /// Joint acceleration, in degrees/s²
        #[arg(long, default_value_t = 200.0)]
        joint_acceleration: f32,
        /// Servo speed, in degrees/s
        #[arg(long, default_value_t = 200.0)]
        servo_speed: f32,
        /// Servo acceleration, in degrees/s²
        #[arg(long, default_value_t = 200.0)]
        servo_acceleration: f32,
        /// Linear speed, in mm/s
        #[arg(long, default_value_t = 100.0)]
        linear_speed: f32,
        /// Linear acceleration, in mm/s²
        #[arg(long, default_value_t = 200.0)]
        linear_acceleration: f32,
        /// Default pause, in seconds; stock arms ignore it
        #[arg(long, default_value_t = 0.0)]
        pause: f32,
        /// Height of a JUMP, in mm
        #[arg(long, default_value_t = 20.0)]
        jump_height: f32,
    },
    /// Acceleration of writing (state 9, mode 2)
    Writing {
        /// In mm/s²
        #[arg(long, default_value_t = 100.0)]
        acceleration: f32,
    },
    /// Tell the arm the angles at which it stands (state 9, mode 3); the base becomes 0
    #[command(allow_negative_numbers = true)]
    Angles {
        /// Rear arm, in degrees from the vertical
        rear: f32,
        /// Forearm, in degrees below the horizontal
        fore: f32,
    },
    /// Percentages of the speeds and accelerations of moves (state 10)
    Percent {
        /// Speed, in percent
        #[arg(long, default_value_t = 50.0)]
        speed: f32,
        /// Acceleration, in percent
        #[arg(long, default_value_t = 50.0)]
        acceleration: f32,
        /// Jog speed, in percent; stock arms ignore it
        #[arg(long, default_value_t = 100.0)]
        teach: f32,
    },
}

/// A tool by its name.
fn tool() -> impl TypedValueParser<Value = Tool> {
    let names = PossibleValuesParser::new(Tool::ALL.map(Tool::option));
    names.map(|name| Tool::named(&name).expect("each of the names is that of a tool"))
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let command = command(&args.group);
    let set = async |station: &mut StationClient| {
        control::status(station).await?;
        take_control(station).await?;
        carry_out(station, command).await?;
        control::rest(station).await
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
            speed,
            acceleration,
            teach,
        } => PlaybackAdjustment {
            speed_percent: speed,
            acceleration_percent: acceleration,
            teach_speed_percent: teach,
        }
        .into(),
    }
}
