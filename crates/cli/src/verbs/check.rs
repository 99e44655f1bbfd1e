//! `dobot check`: checks a program before anything moves.

use dobot_host::{PlannedFor, Rules};
use std::path::PathBuf;

use anyhow::anyhow;
use dobot_safety::Policy;
use dobot_teach::{Compiled, Program, Report, check};
use dobot_wire::Dialect;
use serde_json::json;

use crate::connect::read_policy;
use crate::failure::Failure;
use crate::output;
use crate::program_file;

/// Check a program: list its problems and its duration; nothing moves
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot check pick-and-place.toml       each problem with its step, line and remedy
  dobot check PlayBackPoints.xml        points of the vendor's program
  dobot check job.toml --policy policy.toml --dialect specification
  dobot check --schema > program.json   the JSON Schema of programs, for editors

The exit code is 1 if there are problems. Durations follow from the motion
model of an arm that was just switched on.")]
pub(crate) struct Args {
    /// Program: a TOML file, PlayBackPoints.xml or a .play file
    #[arg(required_unless_present = "schema")]
    program: Option<PathBuf>,
    /// Safety policy, a TOML file (default: as printed by `dobot policy`)
    #[arg(long, value_name = "FILE")]
    policy: Option<PathBuf>,
    /// Protocol dialect of the arm: specification or firmware-1.1
    #[arg(long, value_name = "DIALECT", default_value_t = Dialect::FIRMWARE_1_1)]
    dialect: Dialect,
    /// Print the report as JSON
    #[arg(long)]
    json: bool,
    /// Print the JSON Schema of programs
    #[arg(long, conflicts_with = "program")]
    schema: bool,
}

pub(crate) fn run(args: &Args) -> Result<(), Failure> {
    let Some(file) = &args.program else {
        return Ok(output::line(&serde_json::to_string_pretty(
            &Program::schema(),
        )?)?);
    };
    let policy = args
        .policy
        .as_deref()
        .map_or(Ok(Policy::default()), read_policy)?;
    let arm = PlannedFor::any(Rules::of(&policy).into(), Some(args.dialect));
    let compiled = program_file::compile(file, &arm)?;
    let report = check(&compiled, &policy, arm.model());
    if args.json {
        output::json(&json!({
            "title": compiled.title,
            "commands": compiled.commands.len(),
            "steps": compiled.steps.len(),
            "report": report,
        }))?;
    } else {
        lines(&compiled, &report)
            .iter()
            .try_for_each(|line| output::line(line))?;
    }
    match report.problems.len() {
        0 => Ok(()),
        count => Err(anyhow!("{} has {}", file.display(), output::count(count, "problem")).into()),
    }
}

fn lines(compiled: &Compiled, report: &Report) -> Vec<String> {
    let mut lines: Vec<String> = report.problems.iter().map(ToString::to_string).collect();
    lines.push(format!(
        "{}: {}",
        compiled.title,
        output::counts(&[
            (compiled.steps.len(), "step", "steps"),
            (compiled.commands.len(), "command", "commands"),
            (
                compiled.pauses.len(),
                "pause for a person",
                "pauses for a person"
            ),
        ])
    ));
    if let Some(cycle_s) = report.cycle_s {
        lines.push(format!("a cycle takes {}", output::clock(cycle_s)));
    }
    lines.push(match report.total_s {
        Some(total_s) => format!("the whole program takes {}", output::clock(total_s)),
        None => "it runs until a person ends it".to_owned(),
    });
    lines
}
