//! `dobot conformance`: checks a controller against the protocol.

use std::fs;
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, anyhow};
use dobot_conformance::{Blocker, HEADING, Options, Outcome, Report, Row, Suite, Verdict};
use dobot_controller::{Controller, Personality, Port, PowerUp};
use dobot_session::{Address, Link};
use dobot_sim::{InProcess, SerialLine, VirtualArm};
use jiff::Timestamp;

use crate::failure::Failure;
use crate::interrupt::interrupt;
use crate::output;
use crate::verbs::arm::port;

/// Check a real or virtual controller against the protocol
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot conformance virtual: --personality firmware-1.1
  dobot conformance serial:/dev/ttyUSB0
  dobot conformance tcp:localhost:5555 --yes --report arm.md

It takes about 90 seconds, or no time for a virtual arm in this process. The
round-trip time of the line is measured first; it may be up to 600 ms. The arm
is lifted by 10 mm, moves by up to 10 mm and 5 degrees around that point, never
below its start, switches the pump briefly, and moves back. Speeds and other
settings are reset to their power-up values. Ctrl-C stops the checks and brings
the arm back.

Each check has one line with its result: holds; specification or firmware-1.1,
if only that dialect has this behaviour; DIFFERS; unsteady, if the result was
not always the same; not tried. The exit code is 0 if all checks that were tried
hold in one dialect. The Bluetooth port of a stock arm is detected; all checks
apply there too.")]
pub(crate) struct Args {
    /// The controller's address.
    #[arg(help = "Address of the controller: virtual:, serial:PORT[@BAUD] or tcp:HOST:PORT")]
    address: Address,
    /// Behaviour of the arm at virtual:, specification or firmware-1.1 (default: specification)
    #[arg(long, value_name = "PERSONALITY")]
    personality: Option<Personality>,
    /// Port of the firmware-1.1 arm at virtual:, usb or bluetooth (default: usb)
    #[arg(long, value_name = "PORT", value_parser = port, hide_short_help = true)]
    port: Option<Port>,
    /// Report file; only an earlier report is overwritten
    #[arg(long, value_name = "FILE", default_value = "conformance.md")]
    report: PathBuf,
    /// Move the arm without asking first
    #[arg(long)]
    yes: bool,
    /// Switch the laser on briefly; protect eyes and the surface below
    #[arg(long)]
    with_laser: bool,
    /// Try commands that make an arm as sold hang until it is reset; for virtual arms
    #[arg(long, hide_short_help = true)]
    traps: bool,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    writable(&args.report)?;
    let link = args.link().await?;
    let options = Options {
        laser: args.with_laser,
        traps: args.traps,
        fresh: args.is_virtual(),
    };
    let mut suite = Suite::new(link, options);
    let Some(report) = checked(&mut suite).await? else {
        eprintln!("stopping: the arm moves back to its start");
        suite.stop().await?;
        return Err(anyhow!("interrupted").into());
    };
    let file = report.markdown(&args.address.to_string(), &today());
    fs::write(&args.report, file)
        .with_context(|| format!("cannot write {}", args.report.display()))?;
    let latency = report.latency();
    let latency = latency.map_or_else(String::new, |latency| format!("\nlatency: {latency}"));
    output::line(&format!(
        "\n{}{latency}\nreport: {}",
        report.summary(),
        args.report.display()
    ))?;
    judge(&report, &args.address)
}

/// Runs the checks and prints each one; `None` if they were interrupted.
async fn checked(suite: &mut Suite) -> Result<Option<Report>, Failure> {
    let interrupt = interrupt();
    let mut printed = Ok(());
    let run = suite.run(|row| {
        if printed.is_ok() {
            printed = output::line(&text(row));
        }
    });
    let report = tokio::select! {
        report = run => Some(report),
        () = interrupt => None,
    };
    printed?;
    Ok(report)
}

impl Args {
    const fn is_virtual(&self) -> bool {
        matches!(self.address, Address::Virtual)
    }

    async fn link(&self) -> Result<Link, Failure> {
        if self.is_virtual() {
            return self.virtual_link();
        }
        if self.personality.is_some() {
            let error = anyhow!(
                "--personality is only for virtual:; {} has its own",
                self.address
            );
            return Err(Failure::usage(error)
                .with_hint("leave out `--personality`; the checks detect the dialect"));
        }
        if self.port.is_some() {
            let error = anyhow!("--port is only for virtual:; {} has its own", self.address);
            return Err(
                Failure::usage(error).with_hint("leave out `--port`; the checks detect the port")
            );
        }
        self.consent()?;
        Ok(Link::open(&self.address).await?)
    }

    fn virtual_link(&self) -> Result<Link, Failure> {
        let personality = self.personality.unwrap_or_default();
        let port = self.port.unwrap_or_default();
        if port == Port::Bluetooth && personality != Personality::Firmware11 {
            let error = anyhow!("the personality {personality} has the USB port only");
            return Err(Failure::usage(error).with_hint("add `--personality firmware-1.1`"));
        }
        let controller = Controller::power_up(PowerUp::new(personality).with_port(port));
        let arm = VirtualArm::new(controller, SerialLine::STOCK);
        Ok(Link::over_peer(InProcess::new(arm)))
    }

    /// Describes what will move, and waits until a person agrees.
    fn consent(&self) -> Result<(), Failure> {
        if self.yes {
            return Ok(());
        }
        if !io::stdin().is_terminal() {
            return Err(Failure::new(
                anyhow!(
                    "the arm at {} will move, and standard input is no terminal for a confirmation",
                    self.address
                ),
                "confirm with `--yes`; the arm needs 30 mm of free space around and above it",
            ));
        }
        eprint!("{}", self.warning());
        io::stderr().flush()?;
        let mut answer = String::new();
        if io::stdin().read_line(&mut answer)? == 0 {
            return Err(anyhow!("not confirmed").into());
        }
        Ok(())
    }

    fn warning(&self) -> String {
        let laser = if self.with_laser {
            "The laser will be on for a moment.\n"
        } else {
            ""
        };
        let traps = if self.traps {
            "At the end an arm as sold will hang until it is reset.\n"
        } else {
            ""
        };
        format!(
            "The arm at {} will move for one to two minutes: 10 mm up, by up to 10 mm and 5 degrees around\n\
             that point, and back. Its pump will run briefly. Remove what hangs on the arm, and keep 30 mm\n\
             around it free.\n\
             {laser}{traps}Press Enter to begin or Ctrl-C to cancel: ",
            self.address
        )
    }
}

/// Formats one line of the table, in colour on a terminal.
fn text(row: &Row) -> String {
    if !io::stdout().is_terminal() {
        return row.to_string();
    }
    let colour = match row.outcome {
        Outcome::Holds(_) => 32,
        Outcome::Specification(_) | Outcome::Firmware11(_) => 36,
        Outcome::Differs(_) => 31,
        Outcome::Unsteady(_) => 33,
        Outcome::NotTried(_) => 2,
    };
    let (id, word) = (row.check.id, row.outcome.word());
    let found = row.outcome.found();
    format!("{id:<16}  \x1b[{colour}m{word:<13}\x1b[0m  {found}")
}

/// Judges the report, for the exit code.
fn judge(report: &Report, address: &Address) -> Result<(), Failure> {
    if report.conforms() {
        return Ok(());
    }
    if let Some(why) = report.blocker()
        && report.differing().is_empty()
    {
        return Err(Failure::new(
            anyhow!("nothing was moved: {why}"),
            remedy(why, address),
        ));
    }
    Err(difference(report))
}

/// Describes how the controller differs from the protocol.
fn difference(report: &Report) -> Failure {
    let differing = report.differing();
    let error = match report.verdict() {
        _ if !differing.is_empty() => anyhow!(
            "{} from the protocol: {}",
            output::many(differing.len(), "check differs", "checks differ"),
            differing.join(", ")
        ),
        Verdict::Mixed { .. } => anyhow!("the controller mixes two dialects"),
        _ if !report.unsteady().is_empty() => return unsteady(report),
        _ => anyhow!("no check identified the controller's dialect"),
    };
    Failure::new(
        error,
        "see the report for the findings and the table or note that differs",
    )
}

fn unsteady(report: &Report) -> Failure {
    let unsteady = report.unsteady();
    Failure::new(
        anyhow!(
            "{} the same result each time: {}",
            output::many(unsteady.len(), "check does not have", "checks do not have"),
            unsteady.join(", ")
        ),
        "try again with another cable, or on a machine closer to the arm; the line loses packets",
    )
}

/// Returns a remedy for an arm that was not moved.
fn remedy(why: &Blocker, address: &Address) -> String {
    match why {
        Blocker::Pump => format!(
            "switch it off with `dobot jog suction-off --to {address}`; if it is off, the status reports it inverted"
        ),
        Blocker::Slow(_) => {
            "run it on the machine that the arm is plugged into: `dobot conformance serial:PORT`"
                .into()
        }
        _ => {
            format!("move the arm to free space: `dobot move --joints 0 45 45 --to {address}`")
        }
    }
}

/// Checks that only an earlier report would be overwritten.
fn writable(report: &Path) -> Result<(), Failure> {
    match fs::read(report) {
        Ok(old) if !old.starts_with(HEADING.as_bytes()) => Err(Failure::new(
            anyhow!("{} exists and is not a report", report.display()),
            "name another file with `--report FILE`",
        )),
        Ok(_) => Ok(()),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
        Err(error) => Err(anyhow::Error::from(error)
            .context(format!("cannot write {}", report.display()))
            .into()),
    }
}

/// Today's date in UTC, as in 2016-02-26.
fn today() -> String {
    Timestamp::now().strftime("%F").to_string()
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::*;

    #[test]
    fn each_hindrance_has_its_remedy() {
        let address = Address::Virtual;
        for (why, expected) in [
            (Blocker::Pump, "dobot jog suction-off"),
            (
                Blocker::Cramped("no room".into()),
                "dobot move --joints 0 45 45",
            ),
            (
                Blocker::Slow(Duration::from_secs(1)),
                "dobot conformance serial:PORT",
            ),
        ] {
            let found = remedy(&why, &address);
            assert!(found.contains(expected), "{found}");
        }
    }
}
