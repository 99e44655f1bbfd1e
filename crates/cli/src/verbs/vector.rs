//! `dobot vector`: one straight line as a drawing has them (state 4).

use std::time::Duration;

use dobot_host::StationClient;
use dobot_wire::WriteVector;

use crate::connect::To;
use crate::control::carry_out_one;
use crate::failure::Failure;
use crate::output;
use crate::verbs::jog::laser_seconds;

/// Draw one straight line with pen or laser (state 4)
#[derive(Debug, clap::Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "\
Examples:
  dobot vector 0 20 0                          20 mm to the left
  dobot vector 10 0 0 --speed 15               slowly forward
  dobot vector 0 0 5 --end-speed 20            up, and not down to rest at the end
  dobot vector 0 20 0 --laser --arm-laser 60   a burnt line: everybody's goggles are on

X, Y and Z are millimetres from where the arm stands: x forward, y left, z up, whatever the dialect. A speed at
the end is for vectors that follow at once; behind the last one an arm stops suddenly. `dobot draw` plans speeds
for whole drawings."
)]
pub(crate) struct Args {
    /// How far, in millimetres
    #[arg(num_args = 3, value_names = ["X", "Y", "Z"], required = true)]
    by: Vec<f32>,
    /// The largest speed on the way, in mm/s
    #[arg(long, value_name = "MM/S", default_value_t = 20.0)]
    speed: f32,
    /// The speed at the start, in mm/s
    #[arg(long, value_name = "MM/S", default_value_t = 0.0)]
    start_speed: f32,
    /// The speed at the end, in mm/s
    #[arg(long, value_name = "MM/S", default_value_t = 0.0)]
    end_speed: f32,
    /// With the laser, which is on
    #[arg(long)]
    laser: bool,
    /// Let the laser be switched on for so many seconds: everybody's goggles are on
    #[arg(long, value_name = "SECONDS", value_parser = laser_seconds, requires = "laser")]
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
        carry_out_one(station, &args.to, args.arm_laser, command).await
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
        if self.laser { stroke.burning() } else { stroke }
    }
}
