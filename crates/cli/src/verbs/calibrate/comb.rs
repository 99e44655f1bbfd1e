//! `dobot calibrate --comb`: measures the backlash of a joint with lines that the arm draws.

use std::io::IsTerminal;
use std::path::Path;

use anyhow::{anyhow, bail};
use dobot_api::{CalibrationFile, JobKind, JobProgram, NewJob, Reply, Request};
use dobot_arm::Tool;
use dobot_calibrate::{COMB_PAIRS, COMB_STEP_DEG, SlackJoint, comb};
use dobot_draw::known_paper;
use dobot_geometry::Point;
use dobot_host::StationClient;

use super::{apply, save};
use crate::connect::To;
use crate::control::{check_pose, take_control};
use crate::failure::Failure;
use crate::{follow, output};

/// A joint on the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum CombOf {
    /// The base
    Base,
    /// The rear arm
    Rear,
    /// The forearm
    Fore,
}

impl CombOf {
    const fn joint(self) -> SlackJoint {
        match self {
            Self::Base => SlackJoint::Base,
            Self::Rear => SlackJoint::Rear,
            Self::Fore => SlackJoint::Fore,
        }
    }

    const fn backlash(self, known: &mut CalibrationFile) -> &mut f64 {
        let backlash = &mut known.backlash;
        match self {
            Self::Base => &mut backlash.base,
            Self::Rear => &mut backlash.rear,
            Self::Fore => &mut backlash.fore,
        }
    }
}

/// Parses the pair of lines that meets: a number from 0, or a half between two.
pub(crate) fn pair(text: &str) -> anyhow::Result<f64> {
    let most = f64::from(COMB_PAIRS - 1);
    match text.trim().parse() {
        Ok(pair) if (0.0..=most).contains(&pair) => Ok(pair),
        _ => bail!("expected 0 to {most}, as in 6 or 6.5"),
    }
}

/// Draws the comb of a joint, and saves the backlash that a person reads from it.
pub(super) async fn measure_backlash(
    station: &mut StationClient,
    to: &To,
    file: &Path,
    mut known: CalibrationFile,
    of: CombOf,
) -> Result<(), Failure> {
    let Some(paper) = &known.paper else {
        return Err(Failure::new(
            anyhow!(
                "{} does not contain the position of the paper",
                file.display()
            ),
            "touch the points of the sheet first with `dobot calibrate`",
        ));
    };
    let paper = known_paper(paper)?;
    if !std::io::stdin().is_terminal() {
        return Err(Failure::new(
            anyhow!("reading which lines meet needs a terminal"),
            "run it in a terminal",
        ));
    }
    check_pose(station, to.pose_confirmed).await?;
    // The lines are drawn without compensation of the backlash.
    *of.backlash(&mut known) = 0.0;
    apply(station, Some(known.clone())).await?;
    take_control(station).await?;
    let commands = comb(
        of.joint(),
        &known.arm(),
        |[x, y]| paper.z_at(Point::new(x, y)),
        Tool::SuctionCup,
    )
    .map_err(|error| anyhow!("the comb is out of reach: {error}"))?;
    draw(station, commands).await?;
    output::line(&format!(
        "Count the pairs of lines from 0: from the right end for the base, from the near end for the arms. \
         Which pair meets, 0 to {}? Halves are allowed.",
        COMB_PAIRS - 1
    ))?;
    let pair = read_pair().await?;
    *of.backlash(&mut known) = pair * COMB_STEP_DEG;
    save(file, &known)?;
    output::line(&format!(
        "{}: {:.3} degrees of backlash",
        file.display(),
        pair * COMB_STEP_DEG
    ))?;
    apply(station, Some(known)).await
}

async fn draw(
    station: &mut StationClient,
    commands: Vec<dobot_wire::Command>,
) -> Result<(), Failure> {
    let job = NewJob {
        title: "comb".into(),
        kind: JobKind::Program,
        commands,
        lift_mm: 0.0,
        pauses: Vec::new(),
        program: JobProgram::default(),
    };
    let reply = station
        .request_at_rest(Request::SubmitJob { job, key: None })
        .await?;
    let Reply::Job { job } = reply else {
        return Err(anyhow!("unexpected answer of the station to a new job: {reply:?}").into());
    };
    follow::start(station, job.job, false, |_| {}).await?;
    Ok(())
}

/// Reads lines until one is a pair.
async fn read_pair() -> Result<f64, Failure> {
    loop {
        let Some(line) = crate::control::line_entered().await else {
            return Err(anyhow!("nothing was entered; nothing was saved").into());
        };
        match pair(&line) {
            Ok(pair) => return Ok(pair),
            Err(why) => output::line(&why.to_string())?,
        }
    }
}
