//! `dobot say`: sends a voice command as text (state 5).

use dobot_host::{StationClient, voice_command};

use crate::connect::To;
use crate::control::run_one_command;
use crate::failure::Failure;
use crate::output;

/// Send a voice command as text (state 5)
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot say left ten                10 mm to the left
  dobot say \"go up twenty-five\"     25 mm up
  dobot say catch                   pump on; `release` switches it off

Each command has one order: ahead, back, left, right, up or down with a number
of millimetres in English words, or catch, or release. Other words are ignored.
An arm as sold is sent the equivalent motion or switch instead of the text: it
understands other numbers, and text that arrives during a motion makes it hang.")]
pub(crate) struct Args {
    /// Words of the command, up to 40 ASCII letters, digits and signs
    #[arg(value_name = "WORD", required = true)]
    words: Vec<String>,
    #[command(flatten)]
    to: To,
    /// Print the last status as JSON
    #[arg(long)]
    json: bool,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let voice = voice_command(&args.words.join(" ")).map_err(Failure::usage)?;
    let send = async |station: &mut StationClient| {
        run_one_command(station, &args.to, None, |_, _| Ok(voice.into())).await
    };
    let status = args.to.with_arm("say", send).await?;
    Ok(output::status(&status, args.json)?)
}
