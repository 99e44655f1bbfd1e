//! `dobot mouse`: moves by a small distance, as with a mouse (state 1).

use dobot_host::StationClient;
use dobot_wire::{Command, Dialect, MouseMove, Status};

use crate::connect::To;
use crate::control::run_one_command;
use crate::failure::Failure;
use crate::pendant::{Drive, Mouse, PadArgs, check_terminal};
use crate::verbs::jog::with_keys;
use crate::{output, values};

/// Move by a small distance, as with a mouse (state 1)
#[derive(Debug, clap::Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "\
Examples:
  dobot mouse 5 0 0                    5 mm forward
  dobot mouse 0 -2.5 10 --suction on   to the right and up, with the pump on
  dobot mouse --keys                   with the arrow keys, page up and page down
  dobot mouse 10 4 0 --to serial:/dev/ttyUSB0 --dialect firmware-1.1

The unit depends on the dialect. With `specification`, X, Y and Z are
millimetres in the base frame: x forward, y left, z up. With `firmware-1.1`,
one unit of X changes the reach by 0.4 mm, one of Y turns the base by -0.225
degrees, and one of Z lifts by 0.4 mm; the arm averages each packet with up to
ten before it. Such an arm then loses the joint speeds of `dobot set moves`:
set them again before the next target.

Keys: Space, Esc or s stops the arm, q quits, 1 to 9 and 0 set the step size,
up to 5 units. After a key is released, at most two more steps are made."
)]
pub(crate) struct Args {
    /// Distance, in the unit of the dialect
    #[arg(num_args = 3, value_names = ["X", "Y", "Z"], required_unless_present = "keys", action = clap::ArgAction::Set, value_parser = values::finite)]
    by: Vec<f32>,
    /// Move with the keyboard, in small steps while a key is held
    #[arg(long, conflicts_with_all = ["by", "rotation", "suction"])]
    keys: bool,
    /// Rotation of the tool, in degrees (default: unchanged); relative to the base frame with
    /// `specification`, the servo's angle with `firmware-1.1`
    #[arg(long, value_name = "DEGREES", value_parser = values::finite)]
    rotation: Option<f32>,
    /// Suction cup, on or off (default: unchanged)
    #[arg(long, value_name = "on|off", value_parser = values::on_off)]
    suction: Option<bool>,
    #[command(flatten)]
    pad: PadArgs,
    #[command(flatten)]
    to: To,
    /// Print the last status as JSON
    #[arg(long)]
    json: bool,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    if args.keys {
        check_terminal("`--keys`", "use `dobot mouse X Y Z`")?;
    }
    let go = async |station: &mut StationClient| {
        if args.keys {
            let drive = Drive::Mouse(Mouse::new());
            return with_keys(station, &args.to, &args.pad, drive, |pendant| pendant).await;
        }
        let command = |status: &Status, dialect| Ok(args.command(status, dialect));
        run_one_command(station, &args.to, None, command).await
    };
    let status = args.to.with_arm("mouse", go).await?;
    Ok(output::status(&status, args.json)?)
}

impl Args {
    fn command(&self, from: &Status, dialect: Option<Dialect>) -> Command {
        let [x, y, z] = [self.by[0], self.by[1], self.by[2]];
        let kept_deg = MouseMove::kept_rotation_deg(from, dialect);
        MouseMove {
            y,
            x,
            z,
            rotation_deg: self.rotation.unwrap_or(kept_deg),
            suction: self.suction.unwrap_or(from.suction),
        }
        .into()
    }
}
