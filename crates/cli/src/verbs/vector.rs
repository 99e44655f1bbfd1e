//! `dobot vector`: draws one straight line (state 4).

use std::time::Duration;

use dobot_host::StationClient;
use dobot_wire::WriteVector;

use crate::connect::To;
use crate::control::run_one_command;
use crate::failure::Failure;
use crate::{output, values};

/// Draw one straight line with a pen or the laser (state 4)
#[derive(Debug, clap::Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "\
Examples:
  dobot vector 0 20 0                         20 mm to the left
  dobot vector 10 0 0 --speed 15              slowly forward
  dobot vector 0 0 5 --end-speed 20           up, without a stop at the end
  dobot vector 0 20 0 --burn --arm-laser 60   a burnt line; wear goggles

X, Y and Z are a distance from the current position, in millimetres, in every
dialect: x forward, y left, z up. Use an end speed only if another vector
follows immediately: after the last one the arm stops abruptly. `dobot draw`
plans the speeds of whole drawings."
)]
pub(crate) struct Args {
    /// Distance, in mm
    #[arg(num_args = 3, value_names = ["X", "Y", "Z"], required = true, action = clap::ArgAction::Set, value_parser = values::finite)]
    by: Vec<f32>,
    /// Maximum speed, in mm/s
    #[arg(long, value_name = "MM/S", default_value = "20", value_parser = values::positive)]
    speed: f32,
    /// Speed at the start, in mm/s
    #[arg(long, value_name = "MM/S", default_value = "0", value_parser = values::non_negative)]
    start_speed: f32,
    /// Speed at the end, in mm/s
    #[arg(long, value_name = "MM/S", default_value = "0", value_parser = values::non_negative)]
    end_speed: f32,
    /// Burn the line with the laser
    #[arg(long)]
    burn: bool,
    /// Arm the laser for this many seconds, 1 to 3600; everyone present must wear goggles
    #[arg(long, value_name = "SECONDS", value_parser = values::laser_seconds, requires = "burn")]
    arm_laser: Option<Duration>,
    #[command(flatten)]
    to: To,
    /// Print the last status as JSON
    #[arg(long)]
    json: bool,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let draw = async |station: &mut StationClient| {
        let command = |_: &_, _| Ok(args.vector().into());
        run_one_command(station, &args.to, args.arm_laser, command).await
    };
    let status = args.to.with_arm("vector", draw).await?;
    Ok(output::status(&status, args.json)?)
}

impl Args {
    fn vector(&self) -> WriteVector {
        let stroke = WriteVector {
            start_speed_mm_s: self.start_speed,
            end_speed_mm_s: self.end_speed,
            ..WriteVector::by(self.by[0], self.by[1], self.by[2], self.speed)
        };
        if self.burn { stroke.burning() } else { stroke }
    }
}
