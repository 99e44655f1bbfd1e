//! `dobot draw`: from a drawing, a picture or a text to ink on the paper.

mod args;
mod estimates;
mod execute;
mod fitting;
mod input;
mod output_files;
mod rehearse;
mod report;
mod work;

use std::path::Path;

use dobot_draw::{
    Colors, Deviation, FrameShape, InkLine, Picture, Plan, Prepared, Settings, Stroke, View, Worst,
    deviation, frame, ink_seen,
};
use dobot_sim::RECORDING_PERIOD;
use dobot_wire::Dialect;

pub(crate) use self::args::Args;
use self::execute::{Executed, ask_about_frame, check_frame, check_laser, direct, through};
use self::output_files::{check_writable, write};
use self::rehearse::{Carried, rehearse};
use self::report::{Report, Times};
use self::work::Work;
pub(crate) use self::work::materials;
use crate::connect::Reached;
use crate::control;
use crate::failure::Failure;
use crate::output;

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let files = [&args.result.picture, &args.result.timeline];
    for file in files.into_iter().flatten() {
        check_writable(file)?;
    }
    let work = Work::new(&args)?;
    // What is wrong with it is told before any arm is touched.
    let mut drawing = Drawing::new(&args, &work, args.to.dialect, VIRTUAL_PAPER_Z_MM)?;
    for warning in &drawing.prepared.warnings {
        eprintln!("warning: {warning}");
    }
    if args.way.dry_run {
        return drawing.estimate().await;
    }
    let mut reached = args.to.reach("draw").await?;
    if args.way.frame {
        check_frame(&reached)?;
    }
    if let Some((z_mm, dialect)) = standing(&args, &mut reached).await? {
        drawing = Drawing::new(&args, &work, dialect, z_mm)?;
    }
    check_laser(&mut reached, &drawing.prepared.plan, &args).await?;
    if args.way.frame {
        drawing.frame(&mut reached).await?;
    }
    drawing.draw(&mut reached).await
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

/// A drawing, planned for an arm.
struct Drawing<'a> {
    args: &'a Args,
    title: &'a str,
    prepared: Prepared,
    settings: Settings,
    /// What the arm speaks, where that is known.
    dialect: Option<Dialect>,
}

impl<'a> Drawing<'a> {
    fn new(
        args: &'a Args,
        work: &'a Work,
        dialect: Option<Dialect>,
        standing_z_mm: f64,
    ) -> Result<Self, Failure> {
        let (prepared, settings) = work.prepare(args, dialect, standing_z_mm)?;
        Ok(Self {
            args,
            title: &work.title,
            prepared,
            settings,
            dialect,
        })
    }

    /// Tells what it would be; nothing moves.
    async fn estimate(&self) -> Result<(), Failure> {
        let dialect = self.dialect.unwrap_or(Dialect::SPECIFICATION);
        let (finished, carried) = rehearse(&self.prepared, &self.settings, dialect).await?;
        let times = Times {
            estimated: Some(finished.time),
            took: None,
        };
        let drawn = carried.as_ref().map(Drawn::carried);
        let report = self.write_files(carried.as_ref(), drawn.as_ref(), times)?;
        print(self.args, &report)
    }

    /// Goes around it, and asks whether that is the place.
    async fn frame(&self, reached: &mut Reached) -> Result<(), Failure> {
        let Settings { paper, machine, .. } = &self.settings;
        let plan = frame(&self.prepared.passes, paper, machine, FrameShape::Rectangle)?;
        let title = format!("frame of {}", self.title);
        let executed = self
            .execute(&plan, &title, reached, plan.duration_s())
            .await;
        executed.outcome?;
        ask_about_frame(reached).await
    }

    async fn draw(&self, reached: &mut Reached) -> Result<(), Failure> {
        let arm = match reached {
            Reached::Arm(it) => it.virtual_arm.clone(),
            Reached::Station(_) => None,
        };
        // What a virtual arm in this process does is not estimated, it is seen.
        let rehearsed = match self.dialect.filter(|_| arm.is_none()) {
            Some(dialect) => Some(rehearse(&self.prepared, &self.settings, dialect).await?),
            None => None,
        };
        let (estimated, estimate) =
            rehearsed.map_or((None, None), |(it, carried)| (Some(it.time), carried));
        let total_s = estimated.map_or(self.prepared.plan.duration_s(), |it| it.as_secs_f64());
        if let Some(arm) = &arm {
            arm.arm().record(RECORDING_PERIOD);
        }
        let executed = self
            .execute(&self.prepared.plan, self.title, reached, total_s)
            .await;
        let times = Times {
            estimated,
            took: executed.outcome.as_ref().ok().copied(),
        };
        let carried = arm
            .as_ref()
            .and_then(|it| Carried::of(it, &self.prepared, &self.settings));
        let drawn = match (&arm, &carried) {
            (Some(_), carried) => carried.as_ref().map(Drawn::carried),
            (None, _) => Some(Drawn::seen(&executed, &self.prepared, &self.settings)),
        };
        let report = self.write_files(carried.or(estimate).as_ref(), drawn.as_ref(), times)?;
        executed.outcome?;
        estimates::keep(self.title, times)?;
        print(self.args, &report)
    }

    async fn execute(
        &self,
        plan: &Plan,
        title: &str,
        reached: &mut Reached,
        total_s: f64,
    ) -> Executed {
        match reached {
            Reached::Station(station) => through(station, plan, title, self.args).await,
            Reached::Arm(connected) => direct(connected, plan, total_s).await,
        }
    }

    /// Writes the files that were asked for: of a drawing that was stopped half way, too.
    fn write_files(
        &self,
        carried: Option<&Carried>,
        drawn: Option<&Drawn>,
        times: Times,
    ) -> Result<Report, Failure> {
        let results = &self.args.result;
        let estimate = carried.map(|it| &it.estimate);
        let report = Report::new(&self.prepared, estimate, drawn, times);
        if let Some(file) = &results.picture {
            let ink = drawn.map_or(&[][..], |it| &it.ink);
            write(file, &self.picture(file, ink, &report)?)?;
        }
        if let (Some(file), Some(carried)) = (&results.timeline, carried) {
            write(file, &serde_json::to_vec(&carried.timeline)?)?;
        }
        Ok(report)
    }

    fn picture(&self, file: &Path, ink: &[InkLine], report: &Report) -> Result<Vec<u8>, Failure> {
        let results = &self.args.result;
        let tolerance_mm = self.args.way.tolerance;
        let picture = Picture {
            title: self.title,
            figures: &report.figures(),
            passes: report.passes(),
            area: dobot_draw::AREA,
            plan: &self.prepared.plan,
            drawn: ink,
            colors: if results.errors {
                Colors::Error { tolerance_mm }
            } else {
                Colors::Passes
            },
            view: if results.whole_reach {
                View::Reach
            } else {
                View::Paper
            },
        };
        Ok(if is_png(file) {
            picture.to_png(PNG_WIDTH_PX)?
        } else {
            picture.to_svg().into_bytes()
        })
    }
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

    /// Whether there is anything of which to tell how far it is astray.
    fn is_measured(&self) -> bool {
        self.true_position || !self.ink.is_empty()
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
