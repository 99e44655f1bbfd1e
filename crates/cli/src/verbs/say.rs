//! `dobot say`: a spoken order as text (state 5).

use dobot_host::StationClient;
use dobot_wire::Voice;

use crate::connect::To;
use crate::control::carry_out_one;
use crate::failure::Failure;
use crate::output;

/// Say a voice command (state 5)
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot say left ten                          10 mm to the left
  dobot say \"go up twenty-five\"               25 mm up
  dobot say catch                             the pump on; `release` switches it off

One order in each command: ahead, back, left, right, up or down with a number in English words, in millimetres,
or catch or release. Other words do not count. An arm as it was sold gets the motion or the button that the words
mean, over USB and Bluetooth: it would hear other numbers, and a text while it moves makes it hang.")]
pub(crate) struct Args {
    /// What to say: up to 40 letters, digits and signs of ASCII
    #[arg(value_name = "WORD", required = true)]
    words: Vec<String>,
    #[command(flatten)]
    to: To,
    /// Print the last status as JSON
    #[arg(long)]
    json: bool,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let voice = Voice::new(&args.words.join(" "))?;
    let say = async |station: &mut StationClient| {
        carry_out_one(station, &args.to, None, |_, _| Ok(voice.into())).await
    };
    let status = args.to.with_arm("say", say).await?;
    Ok(output::status(&status, args.json)?)
}
