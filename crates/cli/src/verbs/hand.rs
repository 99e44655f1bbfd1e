//! `dobot hand`: moves to the position of a hand (state 8).

use dobot_host::StationClient;
use dobot_wire::{Gesture, Status};

use crate::connect::To;
use crate::control::run_one_command;
use crate::failure::Failure;
use crate::{output, values};

/// Follow a hand to a position, as with a hand tracker (state 8)
#[derive(Debug, clap::Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "\
Examples:
  dobot hand 230 0 40             to the position of the hand
  dobot hand 230 0 0 --grab on    the same, with the hand closed: the pump runs
  dobot hand 0 40 260 --to serial:/dev/ttyUSB0 --dialect firmware-1.1

The unit depends on the dialect. With `specification`, X, Y and Z are a point
in the base frame, in millimetres, and the arm moves there in a straight line.
With `firmware-1.1` they are units of the hand tracker: x is 230 mm plus half
of X, y is Y, and z is half of Z minus 100 mm, above the tool's lowest
position; a packet is averaged with the ten before it, so that one packet moves
the arm only part of the way. On such an arm a closed hand also closes the
gripper, and the joint speeds of `dobot set moves` are lost: set them again
before the next target."
)]
pub(crate) struct Args {
    /// Position of the hand, in the unit of the dialect
    #[arg(num_args = 3, value_names = ["X", "Y", "Z"], required = true, action = clap::ArgAction::Set, value_parser = values::finite)]
    place: Vec<f32>,
    /// Closed hand, on or off (default: as the pump)
    #[arg(long, value_name = "on|off", value_parser = values::on_off)]
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
        run_one_command(station, &args.to, None, command).await
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
