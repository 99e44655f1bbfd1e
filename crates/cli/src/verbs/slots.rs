//! `dobot slots`: whose time it is at the arm, and when.

use std::time::Duration;

use anyhow::{Context, bail};
use dobot_api::{Reply, Request, TimeSlot};
use dobot_host::StationClient;

use crate::failure::Failure;
use crate::output::{self, clock};
use crate::reach::Station;

/// Show whose time it is at the arm, give students their time one after the other, or clear it all
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot slots                              whose time it is, and who comes next
  dobot slots --each 15m Anna Ben Chen     15 minutes for each, one after the other, from now on
  dobot slots --each 10m --start 5m --group red Anna Ben
  dobot slots --clear                      the arm is everyone's

While somebody's time goes on, only that one and administrators have control; who else has it loses it, and a job that
runs is paused. New slots take the place of all before. A person is known by the name of his token, or with one that was
made with `--shared` by the name that he says.")]
pub(crate) struct Args {
    /// Whose time it is, in this order
    #[arg(requires = "each", value_name = "NAME")]
    students: Vec<String>,
    /// How long each has the arm, as in 15m, 90s or 1h
    #[arg(long, value_name = "TIME", value_parser = time, requires = "students")]
    each: Option<Duration>,
    /// When the first one begins, from now on
    #[arg(long, value_name = "TIME", value_parser = time, requires = "each")]
    start: Option<Duration>,
    /// The group of all of them
    #[arg(long, value_name = "NAME", requires = "each")]
    group: Option<String>,
    /// End all slots
    #[arg(long, conflicts_with = "each")]
    clear: bool,
    #[command(flatten)]
    station: Station,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let mut station = args.station.client("slots").await?;
    let request = match args.each {
        Some(each) => Request::SetSlots {
            slots: in_turn(&args.students, each, args.start, args.group.as_deref()),
        },
        None if args.clear => Request::SetSlots { slots: Vec::new() },
        None => Request::ShowSlots,
    };
    show(&ask(&mut station, request).await?, args.json)
}

async fn ask(station: &mut StationClient, request: Request) -> Result<Vec<TimeSlot>, Failure> {
    match station.request(request).await? {
        Reply::Slots { slots } => Ok(slots),
        _ => Ok(Vec::new()),
    }
}

/// A slot for each, one after the other.
fn in_turn(
    students: &[String],
    each: Duration,
    start: Option<Duration>,
    group: Option<&str>,
) -> Vec<TimeSlot> {
    let mut starts = start.unwrap_or_default();
    let slot = |student: &String| {
        let ends = starts + each;
        let slot = TimeSlot {
            student: student.clone(),
            group: group.map(str::to_owned),
            starts_in_s: starts.as_secs_f64(),
            ends_in_s: ends.as_secs_f64(),
        };
        starts = ends;
        slot
    };
    students.iter().map(slot).collect()
}

fn show(slots: &[TimeSlot], as_json: bool) -> Result<(), Failure> {
    if as_json {
        return Ok(output::json(&slots)?);
    }
    if slots.is_empty() {
        output::line("no time slots: the arm is everyone's")?;
    }
    for slot in slots {
        output::line(&line(slot))?;
    }
    Ok(())
}

fn line(slot: &TimeSlot) -> String {
    let (starts, lasts) = (slot.starts_in_s, slot.ends_in_s - slot.starts_in_s);
    let when = if starts <= 0.0 {
        format!("now, for another {}", clock(lasts))
    } else {
        format!("in {}, for {}", clock(starts), clock(lasts))
    };
    match &slot.group {
        Some(group) => format!("{} ({group})  {when}", slot.student),
        None => format!("{}  {when}", slot.student),
    }
}

/// Reads a time such as `15m`; a number alone is in seconds.
fn time(text: &str) -> anyhow::Result<Duration> {
    let allowed = "allowed is 1s to 24h, as in 15m, 90s or 1h";
    let (number, unit_s) = match text.chars().next_back() {
        Some('s') => (&text[..text.len() - 1], 1.0),
        Some('m') => (&text[..text.len() - 1], 60.0),
        Some('h') => (&text[..text.len() - 1], 3600.0),
        _ => (text, 1.0),
    };
    let seconds = number.parse::<f64>().context(allowed)? * unit_s;
    if !(1.0..=TimeSlot::LONGEST_S).contains(&seconds) {
        bail!("{allowed}");
    }
    Ok(Duration::from_secs_f64(seconds))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn students_have_the_arm_one_after_the_other() {
        let students = ["Anna", "Ben"].map(str::to_owned);
        let start = Some(Duration::from_mins(5));
        let slots = in_turn(&students, Duration::from_mins(15), start, Some("red"));
        let lines: Vec<_> = slots.iter().map(line).collect();
        assert_eq!(
            lines,
            [
                "Anna (red)  in 5:00 min, for 15:00 min",
                "Ben (red)  in 20:00 min, for 15:00 min"
            ]
        );
        assert_eq!(slots[0].ends_in_s, slots[1].starts_in_s);
    }

    #[test]
    fn times_are_read_with_their_units_and_others_are_refused() {
        for (text, s) in [
            ("15m", 900.0),
            ("90s", 90.0),
            ("1h", 3600.0),
            ("1.5m", 90.0),
            ("30", 30.0),
        ] {
            assert_eq!(time(text).expect(text).as_secs_f64(), s, "{text}");
        }
        for text in ["", "m", "0s", "-5m", "25h", "NaN", "infh", "15 min", "5€"] {
            let error = time(text).expect_err(text);
            assert!(error.to_string().contains("15m"), "{text}: {error}");
        }
    }
}
