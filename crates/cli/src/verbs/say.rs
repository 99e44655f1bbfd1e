//! `dobot say`: sends a voice command as text (state 5).

use anyhow::anyhow;
use dobot_host::StationClient;
use dobot_wire::{Voice, VoiceOrder};

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
    let voice = order(&args.words.join(" "))?;
    let say = async |station: &mut StationClient| {
        run_one_command(station, &args.to, None, |_, _| Ok(voice.into())).await
    };
    let status = args.to.with_arm("say", say).await?;
    Ok(output::status(&status, args.json)?)
}

/// Checks that a text is one voice command.
fn order(text: &str) -> Result<Voice, Failure> {
    let voice = Voice::new(text).map_err(Failure::usage)?;
    if VoiceOrder::parse(&voice).is_some() {
        return Ok(voice);
    }
    let words = text.to_ascii_lowercase();
    let mut words = words.split(|letter: char| !letter.is_ascii_alphabetic());
    let direction = words.find(|word| DIRECTIONS.contains(word));
    let error = match direction {
        Some(word) => anyhow!("`{word}` needs one number in words, for example `{word} ten`"),
        None => anyhow!(
            "`{text}` contains no order; expected {} with a number, or catch or release",
            DIRECTIONS.join(", ")
        ),
    };
    Err(Failure::usage(error))
}

const DIRECTIONS: [&str; 6] = ["ahead", "back", "left", "right", "up", "down"];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_order_without_a_number_is_refused_with_an_example() {
        assert!(order("go up twenty-five").is_ok() && order("catch").is_ok());
        let detail = |text| order(text).expect_err(text).detail();
        assert!(detail("go left").contains("`left` needs one number"));
        assert!(detail("go left").contains("`left ten`"));
        assert!(detail("hello").contains("no order"));
    }
}
