//! `dobot simulate`: runs a script in virtual time.

use std::io::{Read, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, anyhow};
use dobot_controller::Personality;
use dobot_sim::{
    Plot, Script, SimulateError, Simulation, Snapshot, Trace, TracedStatus, simulate,
    simulate_watched,
};

use crate::failure::Failure;
use crate::{output, values};

/// Run a script in virtual time, and write what the arm did
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot simulate square.script                      a summary
  dobot simulate square.script --plot square.svg    path, joints and speeds
  dobot simulate square.script --personality firmware-1.1 --trace square.csv
  echo 'credit 3 0 240 0 0 0 0 2 0 0' | dobot simulate - --trace -
  dobot simulate square.script --strict             fail if a packet is refused

Each line of a script is one packet, `T f1 f2 ... f10`. T is the time of its
first byte in milliseconds, or `credit` for the arrival of the next status; the
ten floats are those of the protocol. Other lines are `!end MS`, `!pose REAR
FORE`, `!port usb|bt`, `raw T BYTES`, `voice T TEXT` and `# comment`.

--trace OUT.csv writes the statuses to OUT.csv, each control tick to
OUT.ticks.csv, and the output of the arm's other port, if any, to
OUT.other_port.txt.")]
pub(crate) struct Args {
    /// Script file, or - for standard input
    script: PathBuf,
    /// Behaviour of the controller: specification, or firmware-1.1 for an arm as sold
    #[arg(long, value_name = "PERSONALITY", default_value_t)]
    personality: Personality,
    /// Write the statuses to a CSV file, and the ticks to one beside it; - for standard output
    #[arg(long, value_name = "OUT.csv", value_parser = trace_file)]
    trace: Option<PathBuf>,
    /// Draw path, joints and speeds in an SVG file
    #[arg(long, value_name = "OUT.svg", value_parser = values::svg_file)]
    plot: Option<PathBuf>,
    /// Fail if the controller refuses a packet or hangs, or if a line was not sent
    #[arg(long)]
    strict: bool,
}

pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let name = if is_dash(&args.script) {
        "standard input".to_owned()
    } else {
        args.script.display().to_string()
    };
    let script = parse(&read(&args.script)?, &name)?;
    let (simulation, snapshots) = args.simulate(&script).map_err(cannot_run)?;
    if let Some(file) = &args.trace {
        write_trace(&simulation.trace, file)?;
    }
    if let Some(file) = &args.plot {
        let plot = Plot {
            title: &title(&args.script),
            personality: args.personality,
            snapshots: &snapshots,
            statuses: &simulation.trace.statuses,
        };
        write(file, plot.to_svg().as_bytes())?;
    }
    let lines = script.lines.len();
    if args.trace.is_none() && args.plot.is_none() {
        output::line(&summary(&name, args.personality, lines, &simulation))?;
    }
    for warning in warnings(lines, &simulation) {
        eprintln!("{warning}");
    }
    let (refused, unsent) = (simulation.refused.len(), simulation.unsent);
    if args.strict && refused + unsent > 0 {
        return Err(Failure::new(
            anyhow!(
                "{} refused and {} not sent; --strict allows none",
                output::many(refused, "packet was", "packets were"),
                output::many(unsent, "line was", "lines were")
            ),
            "remove lines that are refused, or allow more time with `!end MS`",
        ));
    }
    Ok(())
}

impl Args {
    /// Runs the script; takes snapshots only for a plot.
    fn simulate(&self, script: &Script) -> Result<(Simulation, Vec<Snapshot>), SimulateError> {
        let mut snapshots = Vec::new();
        let simulation = if self.plot.is_some() {
            simulate_watched(script, self.personality, |at, controller| {
                snapshots.push(Snapshot::of(controller, at));
            })
        } else {
            simulate(script, self.personality)
        };
        Ok((simulation?, snapshots))
    }
}

/// The title of a plot: the name of the script without its folder.
fn title(script: &Path) -> String {
    let name = script.file_name().filter(|_| !is_dash(script));
    name.map_or_else(
        || "script".to_owned(),
        |name| name.to_string_lossy().into_owned(),
    )
}

fn is_dash(file: &Path) -> bool {
    file.as_os_str() == "-"
}

fn trace_file(text: &str) -> Result<PathBuf, String> {
    if text == "-"
        || Path::new(text)
            .extension()
            .is_some_and(|extension| extension == "csv")
    {
        Ok(text.into())
    } else {
        Err("expected a file name that ends in .csv, or -".to_owned())
    }
}

fn read(file: &Path) -> anyhow::Result<Vec<u8>> {
    if is_dash(file) {
        let mut bytes = Vec::new();
        std::io::stdin()
            .read_to_end(&mut bytes)
            .context("cannot read standard input")?;
        return Ok(bytes);
    }
    std::fs::read(file).with_context(|| format!("cannot read {}", file.display()))
}

fn parse(bytes: &[u8], name: &str) -> anyhow::Result<Script> {
    let text = std::str::from_utf8(bytes).map_err(|error| {
        let (before, rest) = bytes.split_at(error.valid_up_to());
        let line = before.split(|&byte| byte == b'\n').count();
        anyhow!(
            "{name}:{line}: byte {:02X} is not text; expected UTF-8",
            rest[0]
        )
    })?;
    Script::parse(text).map_err(|error| anyhow!("{name}:{}: {}", error.line, error.problem))
}

fn cannot_run(error: SimulateError) -> Failure {
    match error {
        SimulateError::NoBluetooth { .. } => {
            Failure::usage(error).with_hint("use `--personality firmware-1.1`, which has that port")
        }
        _ => error.into(),
    }
}

fn write(file: &Path, bytes: &[u8]) -> anyhow::Result<()> {
    std::fs::write(file, bytes).with_context(|| format!("cannot write {}", file.display()))
}

/// Writes the files of a trace. Removes the text of the other port of an earlier run if this run has
/// none.
fn write_trace(trace: &Trace, file: &Path) -> anyhow::Result<()> {
    if is_dash(file) {
        std::io::stdout().write_all(&trace.statuses_csv())?;
        return Ok(());
    }
    write(file, &trace.statuses_csv())?;
    write(&file.with_extension("ticks.csv"), &trace.ticks_csv())?;
    let text = file.with_extension("other_port.txt");
    if !trace.other_port.is_empty() {
        return write(&text, &trace.other_port);
    }
    match std::fs::remove_file(&text) {
        Err(error) if error.kind() != std::io::ErrorKind::NotFound => {
            Err(error).with_context(|| format!("cannot remove {}", text.display()))
        }
        _ => Ok(()),
    }
}

fn summary(name: &str, personality: Personality, lines: usize, simulation: &Simulation) -> String {
    let seconds = simulation.end.as_secs_f64();
    [
        format!("{name}: {seconds:.2} s of a {personality} arm"),
        format!("lines sent   {} of {lines}", lines - simulation.unsent),
        format!("statuses     {}", simulation.trace.statuses.len()),
        format!(
            "last status  {}",
            simulation
                .trace
                .statuses
                .last()
                .map_or_else(|| "none".to_owned(), place)
        ),
        format!("refused      {}", simulation.refused.len()),
    ]
    .join("\n")
}

fn place(status: &TracedStatus) -> String {
    let [x, y, z, turn, base, rear, fore, servo, ..] = status.floats;
    format!(
        "at {:.2} s: x {x:.3}  y {y:.3}  z {z:.3} mm   turn {turn:.2}°   base {base:.2}°  rear {rear:.2}°  fore {fore:.2}°  servo {servo:.2}°",
        f64::from(status.tick) * 0.02
    )
}

/// Returns the warnings about a run, one line each.
fn warnings(lines: usize, simulation: &Simulation) -> Vec<String> {
    let mut warnings: Vec<_> = simulation
        .refused
        .iter()
        .take(MAX_SHOWN)
        .map(|(at, refused)| format!("at {} ms: {refused}", at.as_millis()))
        .collect();
    if simulation.refused.len() > MAX_SHOWN {
        warnings.push(format!("and {} more", simulation.refused.len() - MAX_SHOWN));
    }
    if simulation.unsent > 0 {
        warnings.push(format!(
            "{} of {lines} lines were not sent before the end",
            simulation.unsent
        ));
    }
    warnings
}

/// The maximum number of refusals that are shown.
const MAX_SHOWN: usize = 10;
