//! `dobot draw`: from a drawing, a picture or a text to ink on the paper.

mod args;
mod estimates;
mod execute;
mod rehearse;
mod report;
mod work;

use std::fs;
use std::path::Path;

use anyhow::Context;
use dobot_draw::{
    Colors, Deviation, FrameShape, InkLine, Picture, Plan, Prepared, Settings, Stroke, View, Worst,
    deviation, frame, ink_seen,
};
use dobot_sim::RECORDING_PERIOD;
use dobot_wire::Dialect;

pub(crate) use self::args::Args;
use self::execute::{Executed, direct, enter, through};
use self::rehearse::{Carried, rehearse};
use self::report::{Report, Times};
use self::work::Work;
pub(crate) use self::work::materials;
use crate::connect::Reached;
use crate::control;
use crate::failure::Failure;
use crate::output;

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let work = Work::new(&args)?;
    // What is wrong with it is told before any arm is touched.
    let (prepared, settings) = work.prepare(&args, args.to.dialect, VIRTUAL_PAPER_Z_MM)?;
    for warning in &prepared.warnings {
        eprintln!("warning: {warning}");
    }
    if args.way.dry_run {
        let dialect = args.to.dialect.unwrap_or(Dialect::SPECIFICATION);
        return dry_run(&args, &work, &prepared, &settings, dialect).await;
    }
    let mut reached = args.to.reach("draw").await?;
    match standing(&args, &mut reached).await? {
        Some((z_mm, dialect)) => {
            let (prepared, settings) = work.prepare(&args, dialect, z_mm)?;
            draw(&args, &work, &prepared, &settings, &mut reached, dialect).await
        }
        None => {
            let dialect = args.to.dialect;
            draw(&args, &work, &prepared, &settings, &mut reached, dialect).await
        }
    }
}

/// How high the arm stands and which dialect it speaks, where that decides how it draws: a virtual
/// arm in this process has its own paper.
async fn standing(
    args: &Args,
    reached: &mut Reached,
) -> Result<Option<(f64, Option<Dialect>)>, Failure> {
    let (z_mm, dialect) = match reached {
        Reached::Station(station) => {
            let (arm, dialect) = control::arm(station).await?;
            (arm.status.z_mm, dialect)
        }
        Reached::Arm(it) if it.virtual_arm.is_none() => {
            (it.arm.next_status().await?.z_mm, args.to.dialect)
        }
        Reached::Arm(_) => return Ok(None),
    };
    Ok(Some((z_mm.into(), dialect)))
}

async fn dry_run(
    args: &Args,
    work: &Work,
    prepared: &Prepared,
    settings: &Settings,
    dialect: Dialect,
) -> Result<(), Failure> {
    let (finished, carried) = rehearse(prepared, settings, dialect).await?;
    let times = Times {
        estimated: Some(finished.time),
        took: None,
    };
    let drawn = carried.as_ref().map(Drawn::carried);
    let report = write_files(
        args,
        work,
        prepared,
        carried.as_ref(),
        drawn.as_ref(),
        times,
    )?;
    print(args, &report)
}

async fn draw(
    args: &Args,
    work: &Work,
    prepared: &Prepared,
    settings: &Settings,
    reached: &mut Reached,
    dialect: Option<Dialect>,
) -> Result<(), Failure> {
    if args.way.frame {
        let plan = frame(
            &prepared.passes,
            &settings.paper,
            &settings.machine,
            FrameShape::Rectangle,
        )?;
        let title = format!("frame of {}", work.title);
        execute(args, &plan, &title, reached, plan.duration_s())
            .await
            .outcome?;
        eprintln!("this is where it will be; Ctrl-C leaves it undone");
        enter().await;
    }
    let is_virtual = matches!(reached, Reached::Arm(it) if it.virtual_arm.is_some());
    // Nobody knows the dialect of this arm: the session will refuse what depends on it.
    let known = dialect.filter(|_| !is_virtual);
    let rehearsed = match known {
        Some(dialect) => Some(rehearse(prepared, settings, dialect).await?),
        None => None,
    };
    let estimated = rehearsed.as_ref().map(|(finished, _)| finished.time);
    let total_s = estimated.map_or_else(|| prepared.plan.duration_s(), |it| it.as_secs_f64());
    if let Reached::Arm(it) = reached
        && let Some(arm) = &it.virtual_arm
    {
        arm.arm().record(RECORDING_PERIOD);
    }
    let executed = execute(args, &prepared.plan, &work.title, reached, total_s).await;
    let times = Times {
        estimated,
        took: executed.outcome.as_ref().ok().copied(),
    };
    let virtual_arm = match reached {
        Reached::Arm(it) => it.virtual_arm.as_ref(),
        Reached::Station(_) => None,
    };
    let (carried, drawn) = match virtual_arm {
        Some(arm) => {
            let carried = Carried::of(arm, prepared, settings);
            let drawn = carried.as_ref().map(Drawn::carried);
            (carried, drawn)
        }
        None => {
            let drawn = Drawn::seen(&executed, prepared, settings);
            (rehearsed.and_then(|(_, carried)| carried), Some(drawn))
        }
    };
    if !is_virtual {
        estimates::keep(&work.title, times)?;
    }
    let report = write_files(
        args,
        work,
        prepared,
        carried.as_ref(),
        drawn.as_ref(),
        times,
    )?;
    executed.outcome?;
    print(args, &report)
}

async fn execute(
    args: &Args,
    plan: &Plan,
    title: &str,
    reached: &mut Reached,
    total_s: f64,
) -> Executed {
    match reached {
        Reached::Station(station) => through(station, plan, title, args).await,
        Reached::Arm(connected) => direct(connected, plan, total_s).await,
    }
}

/// Writes the files that were asked for: of a drawing that was stopped half way, too.
fn write_files(
    args: &Args,
    work: &Work,
    prepared: &Prepared,
    carried: Option<&Carried>,
    drawn: Option<&Drawn>,
    times: Times,
) -> Result<Report, Failure> {
    let estimate = carried.map(|it| &it.estimate);
    let report = Report::new(prepared, estimate, drawn, times);
    if let Some(file) = &args.result.picture {
        let ink = drawn.map_or(&[][..], |it| &it.ink);
        write_picture(args, file, &work.title, prepared, ink, &report)?;
    }
    if let (Some(file), Some(carried)) = (&args.result.timeline, carried) {
        let text = serde_json::to_string(&carried.timeline)?;
        fs::write(file, text).with_context(|| format!("cannot write {}", file.display()))?;
    }
    Ok(report)
}

fn print(args: &Args, report: &Report) -> Result<(), Failure> {
    report.print(args.result.json)?;
    if args.result.json {
        return Ok(());
    }
    let files = [
        ("picture", &args.result.picture),
        ("timeline", &args.result.timeline),
    ];
    for (what, file) in files {
        if let Some(file) = file {
            output::line(&format!("{what:<19}{}", file.display()))?;
        }
    }
    Ok(())
}

fn write_picture(
    args: &Args,
    file: &Path,
    title: &str,
    prepared: &Prepared,
    ink: &[InkLine],
    report: &Report,
) -> Result<(), Failure> {
    let picture = Picture {
        title,
        figures: &report.figures(),
        passes: report.passes(),
        area: dobot_draw::AREA,
        plan: &prepared.plan,
        drawn: ink,
        colors: if args.result.errors {
            Colors::Error {
                tolerance_mm: args.way.tolerance,
            }
        } else {
            Colors::Passes
        },
        view: if args.result.whole_reach {
            View::Reach
        } else {
            View::Paper
        },
    };
    let bytes = if is_png(file) {
        picture.to_png(PNG_WIDTH_PX)?
    } else {
        picture.to_svg().into_bytes()
    };
    fs::write(file, bytes).with_context(|| format!("cannot write {}", file.display()))?;
    Ok(())
}

/// What became ink, and what is known of it.
struct Drawn {
    ink: Vec<InkLine>,
    deviation: Deviation,
    /// The true position was recorded; otherwise only the statuses tell.
    true_position: bool,
}

impl Drawn {
    fn carried(carried: &Carried) -> Self {
        Self {
            ink: carried.ink.clone(),
            deviation: carried.deviation,
            true_position: true,
        }
    }

    fn seen(executed: &Executed, prepared: &Prepared, settings: &Settings) -> Self {
        let wanted = prepared.wanted();
        let seen = executed.seen.iter().copied();
        let dots: Vec<Stroke> = ink_seen(seen, &prepared.plan, &settings.paper);
        Self {
            deviation: deviation(&wanted, &dots),
            ink: InkLine::measured(dots, &wanted),
            true_position: false,
        }
    }

    /// What the statuses do not show is not missing.
    fn worst(&self) -> Worst {
        let Deviation { astray, missed } = self.deviation;
        if self.true_position && missed.distance_mm > astray.distance_mm {
            missed
        } else {
            astray
        }
    }
}

fn is_png(file: &Path) -> bool {
    file.extension()
        .is_some_and(|it| it.eq_ignore_ascii_case("png"))
}

const PNG_WIDTH_PX: u32 = 2000;
/// Where the paper of a virtual arm lies.
const VIRTUAL_PAPER_Z_MM: f64 = -40.0;
