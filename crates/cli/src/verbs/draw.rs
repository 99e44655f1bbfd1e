//! `dobot draw`: draws a file, a picture or a text.

mod args;
mod defaults;
mod estimates;
mod execute;
mod input;
mod output_files;
mod planning;
mod rehearse;
mod report;

use crate::verbs::calibrate;
use std::path::Path;

use anyhow::{Context, anyhow};
use dobot_api::CalibrationFile;
use dobot_draw::{
    CancelToken, Colors, DrawingRequest, FrameShape, InkLine, Picture, Prepared, Settings, View,
    WITHOUT_ARM_Z_MM, export, frame, ink_seen,
};
use dobot_geometry::{Deviation, Stroke, WorstPoint, deviation};
use dobot_host::{PlannedFor, StationClient, run_long};
use dobot_import::WarningKind;
use dobot_sim::RECORDING_PERIOD;
use dobot_wire::{Dialect, Status};
use indicatif::ProgressBar;

pub(crate) use self::args::Args;
use self::args::export_format;
use self::defaults::Defaults;
pub(crate) use self::defaults::read;
use self::execute::{Executed, ask_about_frame, check_frame, check_laser, execute};
use self::input::drawing_request;
pub(crate) use self::input::materials;
use self::output_files::{check_apart, check_writable, write, write_json};
use self::planning::shown;
use self::rehearse::{Carried, Rehearsed, rehearse};
use self::report::{Report, Times};
use crate::control::{self, check_pose};
use crate::drawing_options::with_option_names;
use crate::failure::Failure;
use crate::follow::{progress_bar, share_bar};
use crate::interrupt::interrupt;
use crate::output;

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let defaults = args.from_file.clone();
    let done = Box::pin(draw(args)).await;
    let hint = || defaults?.hint();
    done.map_err(|failure| failure.or_hint(hint))
}

async fn draw(args: Args) -> Result<(), Failure> {
    check_apart(&args)?;
    let results = &args.result;
    let files = [&results.picture, &results.timeline, &results.export];
    for file in files.into_iter().flatten() {
        check_writable(file)?;
    }
    let (args, asked) = drawing_request(args)?;
    if args.dry_run {
        let drawing = Drawing::new(&args, &asked, args.to.dialect, WITHOUT_ARM_Z_MM)?;
        return drawing.estimate().await;
    }
    let draw = async |station: &mut StationClient| {
        if args.outline {
            check_frame(station)?;
        }
        // A virtual arm in this process has its own paper.
        let drawing = if station.virtual_arm().is_some() {
            Drawing::new(&args, &asked, args.to.dialect, WITHOUT_ARM_Z_MM)?
        } else {
            let arm = control::planned_for(station).await?;
            Drawing::for_arm(&args, asked, &arm).await?
        };
        check_pose(station, args.to.pose_confirmed).await?;
        let plan = &drawing.prepared.plan;
        check_laser(station, plan, args.arm_laser).await?;
        if args.outline {
            drawing.outline(station).await?;
        }
        drawing.draw(station).await
    };
    args.to.with_arm("draw", draw).await
}

/// The calibration of the arm: that of a file or that in use, which must be the same.
fn calibration(args: &Args, arm: &PlannedFor) -> Result<Option<CalibrationFile>, Failure> {
    let given = args.calibration.as_deref().map(calibrate::read);
    match (given.transpose()?, &arm.calibration) {
        (Some(given), Some(known)) if !given.arm().is_same(&known.arm()) => Err(Failure::new(
            anyhow!("--calibration differs from the calibration in use for the arm"),
            "leave out `--calibration`, or apply that of the file: `dobot calibrate FILE --use`",
        )),
        (None, known) => Ok(known.clone()),
        (given, _) => Ok(given),
    }
}

/// A drawing, planned for an arm.
struct Drawing<'a> {
    args: &'a Args,
    title: String,
    prepared: Prepared,
    settings: Settings,
    /// The dialect of the arm, if known.
    dialect: Option<Dialect>,
    /// The status of the arm, if known.
    from: Option<Status>,
}

impl<'a> Drawing<'a> {
    /// Plans the drawing for a virtual arm.
    fn new(
        args: &'a Args,
        asked: &DrawingRequest,
        dialect: Option<Dialect>,
        standing_z_mm: f64,
    ) -> Result<Self, Failure> {
        let is_hidden = args.result.json;
        let prepared = shown(asked.progress(), is_hidden, || {
            asked.prepare(dialect, standing_z_mm)
        });
        let (prepared, settings) = prepared.with_context(|| asked.title.clone())?;
        let drawing = Self {
            args,
            title: asked.title.clone(),
            prepared,
            settings,
            dialect,
            from: None,
        };
        drawing.warn();
        Ok(drawing)
    }

    /// Plans the drawing for an arm where it stands; Ctrl-C cancels it.
    async fn for_arm(
        args: &'a Args,
        asked: DrawingRequest,
        arm: &PlannedFor,
    ) -> Result<Self, Failure> {
        let (cancel, status, dialect) = (CancelToken::default(), arm.status(), arm.dialect);
        let asked = asked
            .calibrated(calibration(args, arm)?)
            .until(cancel.clone());
        let (title, is_hidden) = (asked.title.clone(), args.result.json);
        let planning = run_long(move || {
            shown(asked.progress(), is_hidden, || {
                asked.prepare(dialect, status.z_mm.into())
            })
        });
        let prepared = tokio::select! {
            prepared = planning => prepared.map_err(|error| anyhow!(error))?,
            () = interrupt() => {
                cancel.cancel();
                return Err(anyhow!("interrupted while planning; nothing was drawn").into());
            }
        };
        let (prepared, settings) = prepared.with_context(|| title.clone())?;
        let drawing = Self {
            args,
            title,
            prepared,
            settings,
            dialect,
            from: Some(status),
        };
        drawing.warn();
        Ok(drawing)
    }

    /// Prints the warnings about the drawing.
    fn warn(&self) {
        for warning in &self.prepared.warnings {
            let kind = match warning.kind {
                WarningKind::Note => "note",
                _ => "warning",
            };
            eprintln!("{kind}: {}", with_option_names(&warning.to_string()));
        }
        let hours = self.prepared.plan.duration_s() / 3600.0;
        if hours > LONG_HOURS {
            eprintln!("warning: this takes about {hours:.0} hours");
        }
    }

    /// Reports the result of a simulation; nothing moves.
    async fn estimate(&self) -> Result<(), Failure> {
        if self.is_long() {
            let report = self.write_files(None, self.planned().as_ref(), Times::default())?;
            return print(self.args, &report);
        }
        let Rehearsed {
            time,
            planned_s,
            carried,
        } = self.rehearse().await?;
        let times = Times {
            planned_s,
            estimated: Some(time),
            took: None,
        };
        let drawn = carried.as_ref().map(Drawn::carried);
        let report = self.write_files(carried.as_ref(), drawn.as_ref(), times)?;
        print(self.args, &report)
    }

    /// Whether a simulation would take too long; the plan is then reported instead.
    fn is_long(&self) -> bool {
        self.prepared.plan.duration_s() / 3600.0 > LONG_HOURS
    }

    /// The planned ink, for a picture only, because measuring it takes long.
    fn planned(&self) -> Option<Drawn> {
        let is_shown = self.args.result.picture.is_some();
        is_shown.then(|| Drawn::planned(&self.prepared))
    }

    async fn rehearse(&self) -> Result<Rehearsed, Failure> {
        let dialect = self.dialect.unwrap_or(Dialect::SPECIFICATION);
        let policy = self.args.to.policy()?;
        let from = self.from.as_ref();
        let bar = self.bar(share_bar).with_prefix("simulating ");
        rehearse(&self.prepared, &self.settings, dialect, policy, from, &bar).await
    }

    /// The progress bar, hidden with `--json`.
    fn bar(&self, bar: impl FnOnce() -> ProgressBar) -> ProgressBar {
        if self.args.result.json {
            ProgressBar::hidden()
        } else {
            bar()
        }
    }

    /// Traces the outline, and asks whether the position is right.
    async fn outline(&self, station: &mut StationClient) -> Result<(), Failure> {
        let Prepared { passes, plan, .. } = &self.prepared;
        let plan = frame(
            passes,
            &self.settings.paper,
            plan.arm_limits(),
            FrameShape::Rectangle,
        )?;
        let title = format!("outline of {}", self.title);
        let armed_for = self.args.arm_laser;
        let bar = self.bar(|| progress_bar(station));
        let executed = execute(station, &plan, &title, armed_for, &bar).await;
        executed.outcome?;
        ask_about_frame(station).await
    }

    async fn draw(&self, station: &mut StationClient) -> Result<(), Failure> {
        let is_virtual = station.virtual_arm().is_some();
        // A virtual arm in this process needs no estimate. With another policy than here, the
        // estimate may be refused: then there is none.
        let rehearsed = match self.dialect.filter(|_| !is_virtual && !self.is_long()) {
            Some(_) => self.rehearse().await.ok(),
            None => None,
        };
        let (estimated, estimate) = rehearsed.map_or((None, None), |rehearsed| {
            (Some(rehearsed.time), rehearsed.carried)
        });
        if let Some(arm) = station.virtual_arm_mut().filter(|_| !self.is_long()) {
            arm.record(RECORDING_PERIOD);
        }
        let armed_for = self.args.arm_laser;
        let bar = self.bar(|| progress_bar(station));
        let plan = &self.prepared.plan;
        let executed = execute(station, plan, &self.title, armed_for, &bar).await;
        let times = Times {
            planned_s: executed.planned_s,
            estimated,
            took: executed.outcome.as_ref().ok().copied(),
        };
        let arm = station.virtual_arm();
        let carried = arm
            .filter(|_| !self.is_long())
            .and_then(|arm| Carried::of(arm, &self.prepared, &self.settings));
        let drawn = if is_virtual && self.is_long() {
            self.planned()
        } else if is_virtual {
            carried.as_ref().map(Drawn::carried)
        } else {
            Some(Drawn::from_statuses(
                &executed,
                &self.prepared,
                &self.settings,
            ))
        };
        let report = self.write_files(carried.or(estimate).as_ref(), drawn.as_ref(), times)?;
        executed.outcome?;
        estimates::log(&self.title, times)?;
        print(self.args, &report)
    }

    /// Writes the requested files, also for an incomplete drawing.
    fn write_files(
        &self,
        carried: Option<&Carried>,
        drawn: Option<&Drawn>,
        times: Times,
    ) -> Result<Report, Failure> {
        let results = &self.args.result;
        let estimate = carried.map(|carried| &carried.estimate);
        let sheet = self.settings.placement.sheet.as_ref();
        let defaults = self.args.from_file.as_ref().map(Defaults::line);
        let report = Report::new(&self.prepared, sheet, estimate, drawn, times, defaults);
        if let Some(file) = &results.export {
            let format = export_format(file).map_err(|error| anyhow!(error))?;
            let sheet = self.settings.placement.sheet.as_ref();
            write(
                file,
                export(&self.prepared.passes, sheet, format).as_bytes(),
            )?;
        }
        if let Some(file) = &results.picture {
            let ink = drawn.map_or(&[][..], |drawn| &drawn.ink);
            write(file, &self.picture(file, ink, &report)?)?;
        }
        if let Some(file) = &results.timeline {
            match carried {
                Some(carried) => write_json(file, &carried.timeline)?,
                None => write_json(file, &self.prepared.timeline())?,
            }
        }
        Ok(report)
    }

    fn picture(&self, file: &Path, ink: &[InkLine], report: &Report) -> Result<Vec<u8>, Failure> {
        let results = &self.args.result;
        let tolerance_mm = self.args.options.0.way.tolerance;
        let picture = Picture {
            title: &self.title,
            figures: &report.figures(),
            passes: report.passes(),
            area: dobot_draw::AREA,
            sheet: self.settings.placement.sheet,
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
        ("export", &args.result.export),
    ];
    for (what, file) in files {
        if let Some(file) = file {
            output::line(&format!("{what:<19}{}", file.display()))?;
        }
    }
    Ok(())
}

/// The ink, and its deviation.
struct Drawn {
    ink: Vec<InkLine>,
    deviation: Deviation,
    from: MeasuredFrom,
}

/// The source of the ink.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum MeasuredFrom {
    /// The recorded true position.
    TruePosition,
    /// The statuses.
    Statuses,
    /// The plan.
    Plan,
}

impl Drawn {
    fn carried(carried: &Carried) -> Self {
        Self {
            ink: carried.ink.clone(),
            deviation: carried.deviation,
            from: MeasuredFrom::TruePosition,
        }
    }

    fn planned(prepared: &Prepared) -> Self {
        let ink = prepared.ink();
        let planned: Vec<Stroke> = ink.iter().map(|line| line.stroke.clone()).collect();
        Self {
            deviation: deviation(&prepared.wanted(), &planned),
            ink,
            from: MeasuredFrom::Plan,
        }
    }

    fn from_statuses(executed: &Executed, prepared: &Prepared, settings: &Settings) -> Self {
        let wanted = prepared.wanted();
        let seen = executed.seen.iter().copied();
        let dots: Vec<Stroke> = ink_seen(seen, &prepared.plan, &settings.paper);
        Self {
            deviation: deviation(&wanted, &dots),
            ink: InkLine::measured(dots, &wanted),
            from: MeasuredFrom::Statuses,
        }
    }

    /// Whether a deviation can be measured.
    fn is_measured(&self) -> bool {
        self.from == MeasuredFrom::TruePosition || !self.ink.is_empty()
    }

    /// The largest deviation; paths missing from the statuses do not count.
    fn worst(&self) -> WorstPoint {
        let Deviation { astray, missed } = self.deviation;
        if self.from != MeasuredFrom::Statuses && missed.distance_mm > astray.distance_mm {
            missed
        } else {
            astray
        }
    }
}

fn is_png(file: &Path) -> bool {
    file.extension()
        .is_some_and(|extension| extension.eq_ignore_ascii_case("png"))
}

/// Longer drawings are announced before they start.
const LONG_HOURS: f64 = 3.0;
const PNG_WIDTH_PX: u32 = 2000;
