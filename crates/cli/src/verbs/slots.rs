//! `dobot slots`: time slots of students at the arm.

use std::time::Duration;

use anyhow::{anyhow, bail};
use dobot_api::{Reply, Request, TimeSlot};
use dobot_host::StationClient;

use crate::failure::Failure;
use crate::output::{self, clock};
use crate::reach::Station;

/// Show, set or clear the time slots of students at the arm
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot slots                              show the current slot and the next ones
  dobot slots --each 15m Anna Ben Chen     15 minutes each, in this order, from now
  dobot slots --each 10m --start 5m --group red Anna Ben
  dobot slots --clear                      free the arm for everyone

During a slot only its student and administrators can have control; another
client that has control loses it, and a running job is paused. New slots replace
all earlier ones. A student is identified by the name of the token, or, with a
token made with `--shared`, by the name that the client states.")]
pub(crate) struct Args {
    /// Students in the order of their slots
    #[arg(requires = "each", value_name = "NAME")]
    students: Vec<String>,
    /// Length of each slot, 1s to 24h, for example 15m, 90s or 1h
    #[arg(long, value_name = "TIME", value_parser = time, requires = "students")]
    each: Option<Duration>,
    /// Time until the first slot, 1s to 24h (default: now)
    #[arg(long, value_name = "TIME", value_parser = time, requires = "each")]
    start: Option<Duration>,
    /// Group of all students
    #[arg(long, value_name = "NAME", requires = "each")]
    group: Option<String>,
    /// Remove all slots
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
    show(&send(&mut station, request).await?, args.json)
}

async fn send(station: &mut StationClient, request: Request) -> Result<Vec<TimeSlot>, Failure> {
    match station.request(request).await? {
        Reply::Slots { slots } => Ok(slots),
        _ => Ok(Vec::new()),
    }
}

/// Creates consecutive slots.
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
        output::line("no time slots; the arm is free for everyone")?;
    }
    for slot in slots {
        output::line(&line(slot))?;
    }
    Ok(())
}

fn line(slot: &TimeSlot) -> String {
    let (starts, lasts) = (slot.starts_in_s, slot.ends_in_s - slot.starts_in_s);
    let when = if starts <= 0.0 {
        format!("now, {} left", clock(lasts))
    } else {
        format!("in {}, for {}", clock(starts), clock(lasts))
    };
    match &slot.group {
        Some(group) => format!("{} ({group})  {when}", slot.student),
        None => format!("{}  {when}", slot.student),
    }
}

/// Parses a time such as `15m`; a plain number is in seconds.
fn time(text: &str) -> anyhow::Result<Duration> {
    let allowed = "expected 1s to 24h, as in 15m, 90s or 1h";
    let (number, unit_s) = match text.chars().next_back() {
        Some('s') => (&text[..text.len() - 1], 1.0),
        Some('m') => (&text[..text.len() - 1], 60.0),
        Some('h') => (&text[..text.len() - 1], 3600.0),
        _ => (text, 1.0),
    };
    let seconds = number.parse::<f64>().map_err(|_| anyhow!("{allowed}"))? * unit_s;
    if !(1.0..=TimeSlot::LONGEST_S).contains(&seconds) {
        bail!("{allowed}");
    }
    Ok(Duration::from_secs_f64(seconds))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn students_have_the_arm_one_after_another() {
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
