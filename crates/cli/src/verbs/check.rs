//! `dobot check`: checks a program before anything moves.

use std::path::PathBuf;

use anyhow::anyhow;
use dobot_host::{DryRun, dry_run_program};
use dobot_teach::{Compiled, Program};
use serde_json::json;

use crate::connect::To;
use crate::failure::Failure;
use crate::{output, program_file};

/// Check a program: list its problems and its duration; nothing moves
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot check pick-and-place.toml       each problem with its step, line and remedy
  dobot check PlayBackPoints.xml        points of the vendor's program
  dobot check job.toml --policy policy.toml --dialect firmware-1.1
  dobot check --schema > program.json   the JSON Schema of programs, for editors

The exit code is 1 if there are problems. The program is checked for the arm of
the station, as it stands, with its speeds, calibration and policy; if no
station runs, for an arm that was just switched on.")]
pub(crate) struct Args {
    /// Program: a TOML file, PlayBackPoints.xml, a .play or a .playback file
    #[arg(required_unless_present = "schema")]
    program: Option<PathBuf>,
    /// Print the report as JSON
    #[arg(long)]
    json: bool,
    /// Print the JSON Schema of programs
    #[arg(long, conflicts_with = "program")]
    schema: bool,
    #[command(flatten)]
    to: To,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let Some(file) = &args.program else {
        return Ok(output::line(&serde_json::to_string_pretty(
            &Program::schema(),
        )?)?);
    };
    let (arm, arm_line) = args.to.planned_for("check").await?;
    let program = program_file::read_program(file)?;
    let (program, _) = program_file::compile_times(file, &program, None, &arm)?;
    let mut files = program_file::files_beside(file, &arm);
    let (compiled, report) = dry_run_program(&program, &arm, &mut files)?;
    print(&compiled, &report, arm_line, args.json)?;
    match report.problems.len() {
        0 => Ok(()),
        count => Err(anyhow!("{} has {}", file.display(), output::count(count, "problem")).into()),
    }
}

fn print(compiled: &Compiled, report: &DryRun, arm: String, as_json: bool) -> Result<(), Failure> {
    if as_json {
        return Ok(output::json(&json!({
            "arm": arm,
            "title": compiled.title,
            "commands": compiled.commands.len(),
            "steps": compiled.steps.len(),
            "report": report,
        }))?);
    }
    let problems = report.problems.iter().map(ToString::to_string);
    let summary = program_file::summary(compiled, report);
    problems
        .chain([summary, arm])
        .try_for_each(|line| output::line(&line))?;
    Ok(())
}
