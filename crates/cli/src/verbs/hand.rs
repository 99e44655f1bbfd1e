//! `dobot hand`: go where a hand is (state 8).

use dobot_host::StationClient;
use dobot_wire::{Gesture, Status};

use crate::connect::To;
use crate::control::carry_out_one;
use crate::failure::Failure;
use crate::output;
use crate::verbs::move_::on_off;

/// Follow a hand to a place (state 8, gesture)
#[derive(Debug, clap::Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "\
Examples:
  dobot hand 230 0 40                     to where the hand is
  dobot hand 230 0 0 --grab on            there, and the hand closes: the pump runs
  dobot hand 0 40 260 --to serial:/dev/ttyUSB0 --dialect firmware-1.1

The unit depends on the dialect. By the specification X, Y and Z are a point in millimetres in the base frame,
and the arm goes there in a straight line. On an arm as it was sold they are units of the hand tracker: x is
230 mm and half of X, y is Y, z is half of Z above the lowest place of the tool less 100 mm; a place is averaged
with the ten packets before it, so one packet leads only part of the way. There a closed hand also closes the
gripper, and the joint speeds of `dobot set moves` are forgotten: set them again before the next target."
)]
pub(crate) struct Args {
    /// Where the hand is, in the unit of the dialect
    #[arg(num_args = 3, value_names = ["X", "Y", "Z"], required = true)]
    place: Vec<f32>,
    /// Whether the hand is closed: on or off (default: as the pump is)
    #[arg(long, value_name = "on|off", value_parser = on_off)]
    grab: Option<bool>,
    #[command(flatten)]
    to: To,
    /// Print the last status as JSON
    #[arg(long)]
    json: bool,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let follow = async |station: &mut StationClient| {
        let command = |status: &Status, _| Ok(args.gesture(status).into());
        carry_out_one(station, &args.to, None, command).await
    };
    let status = args.to.with_arm("hand", follow).await?;
    Ok(output::status(&status, args.json)?)
}

impl Args {
    fn gesture(&self, from: &Status) -> Gesture {
        Gesture {
            x: self.place[0],
            y: self.place[1],
            z: self.place[2],
            grab: self.grab.unwrap_or(from.suction),
        }
    }
}
