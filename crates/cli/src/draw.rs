//! `dobot draw`: from a picture in a file to ink on the paper.

use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use anyhow::{Context, anyhow};
use dobot_arm::{Limits, Pose, Position, Tool, Unreachable};
use dobot_client::position;
use dobot_draw::{
    Deviation, Machine, Paper, Parting, Pen, Picture, Placement, Plan, Point, PrepareError,
    Prepared, Progress, Settings, Size, Stopped, Stroke, View, deviation, fontdb, ink, ink_seen,
    prepare,
};
use dobot_sim::RECORDING_PERIOD;
use dobot_station::{JobKind, NewJob, Remote, Reply, Request, State};
use dobot_wire::Dialect;
use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;

use crate::connect::{Connected, Reached, To};
use crate::control::{self, take_control};
use crate::failure::Failure;
use crate::follow;
use crate::guard;
use crate::interrupt::interrupt;
use crate::output::{self, clock};

/// Draw an SVG file
#[derive(Debug, clap::Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "\
Examples:
  dobot draw picture.svg                                 through the running station, if there is one
  dobot draw picture.svg --to virtual: --picture drawn.png
                                                         a virtual arm draws, as fast as it can be calculated
  dobot draw picture.svg --fit                           as large as the drawing area allows
  dobot draw picture.svg --scale 0.5 --at 200 30         half the size, its middle at that point
  dobot draw picture.svg --to serial:/dev/ttyUSB0 --dialect firmware-1.1

The drawing area is 200 mm wide and 120 mm deep: x 150 to 270, y -100 to 100. Seen from behind the
arm the picture lies upright. On a real arm bring the pen down to the paper first (`dobot jog z-`): unless --pen-down says
otherwise, it draws at the height at which it stands. Ctrl-C lifts the pen and says how far it got.

When a station runs, the drawing becomes a job of it: Ctrl-C pauses it, and `dobot jobs start` goes on with it."
)]
pub(crate) struct Args {
    /// The SVG file, or - for standard input
    file: PathBuf,
    #[command(flatten)]
    to: To,
    /// As large as the drawing area allows
    #[arg(long, conflicts_with = "scale")]
    fit: bool,
    /// Times the true size
    #[arg(long, value_name = "FACTOR")]
    scale: Option<f64>,
    /// Where the middle of the drawing goes, in mm (default: the middle of the drawing area)
    #[arg(long, num_args = 2, value_names = ["X", "Y"])]
    at: Option<Vec<f64>>,
    /// Z where the pen draws, in mm (default: where the arm stands; a virtual arm -40)
    #[arg(long, value_name = "Z")]
    pen_down: Option<f64>,
    /// How high above the paper the pen travels, in mm
    #[arg(long, value_name = "MM", default_value_t = Pen::default().lift_mm)]
    pen_lift: f64,
    /// Speed while drawing, in mm/s
    #[arg(long, value_name = "MM/S", default_value_t = Pen::default().draw_speed_mm_s)]
    speed: f64,
    /// Speed between the strokes, in mm/s
    #[arg(long, value_name = "MM/S", default_value_t = Pen::default().travel_speed_mm_s)]
    travel_speed: f64,
    /// Acceleration, in mm/s²
    #[arg(long, value_name = "MM/S2", default_value_t = Machine::default().acceleration_mm_s2)]
    acceleration: f64,
    /// How far the drawn path may leave the wanted one, in mm
    #[arg(long, value_name = "MM", default_value_t = Settings::default().tolerance_mm)]
    tolerance: f64,
    /// Make a picture of the commanded and the drawn path, in a file that ends in .svg or .png
    #[arg(long, value_name = "FILE", value_parser = picture_file)]
    picture: Option<PathBuf>,
    /// Show all that the arm reaches in the picture, not only the paper
    #[arg(long, requires = "picture")]
    whole_reach: bool,
    /// Print the report as JSON
    #[arg(long)]
    json: bool,
}

pub(crate) async fn run(args: Args) -> Result<(), Failure> {
    let svg = read(&args.file)?;
    let mut settings = args.settings(&svg);
    // What is wrong with the file is told before any arm is touched.
    let mut prepared = args.prepare(&svg, &settings)?;
    for warning in &prepared.warnings {
        eprintln!("warning: {warning}");
    }
    let mut reached = args.to.reach("draw").await?;
    if let Some((paper, dialect)) = args.paper_of(&mut reached).await? {
        settings.paper = paper;
        settings.machine = args.machine(dialect);
        prepared = args.prepare(&svg, &settings)?;
    }
    let (outcome, drawn) = match &mut reached {
        Reached::Station(station) => args.through(station, &prepared, &settings.paper).await,
        Reached::Arm(connected) => {
            guard::check_all(connected, prepared.plan.commands()).await?;
            if let Some(arm) = &connected.virtual_arm {
                arm.arm().record(RECORDING_PERIOD);
            }
            draw(connected, &prepared, &settings).await
        }
    };
    let report = Report::new(&prepared, &drawn, outcome.as_ref().ok().copied());
    if let Some(file) = &args.picture {
        args.write_picture(file, &prepared, &drawn, &report)?;
    }
    let time = outcome?;
    report.print(time, args.json)?;
    if let (Some(file), false) = (&args.picture, args.json) {
        output::line(&format!("picture            {}", file.display()))?;
    }
    Ok(())
}

/// What became ink, and what is known of it.
struct Drawn {
    strokes: Vec<Stroke>,
    deviation: Deviation,
    /// The true position was recorded; otherwise only the statuses tell.
    true_position: bool,
}

async fn draw(
    connected: &mut Connected,
    prepared: &Prepared,
    settings: &Settings,
) -> (Result<Duration, Failure>, Drawn) {
    let bar = progress_bar(prepared);
    let total_s = prepared.plan.duration_s();
    let tell = |progress: Progress| {
        bar.set_position(progress.vectors as u64);
        bar.set_message(clock(total_s - progress.planned_s));
    };

    let (plan, pen) = (&prepared.plan, &pen_of(settings));
    let outcome = dobot_draw::run(&mut connected.arm, plan, pen, interrupt(), tell).await;
    bar.finish_and_clear();
    let seen = match &outcome {
        Ok(finished) => &finished.seen,
        Err(stopped) => &stopped.seen,
    };
    let strokes = match &connected.virtual_arm {
        Some(arm) => ink(
            arm.arm().samples().iter().map(|it| it.position),
            down_z_mm(&settings.paper),
        ),
        None => ink_seen(seen.iter().copied(), down_z_mm(&settings.paper)),
    };
    let drawn = Drawn::new(prepared, strokes, connected.virtual_arm.is_some());
    (outcome.map(|it| it.time).map_err(stopped), drawn)
}

impl Args {
    /// Queues the drawing as a job of the station, and follows it.
    async fn through(
        &self,
        station: &mut Remote,
        prepared: &Prepared,
        paper: &Paper,
    ) -> (Result<Duration, Failure>, Drawn) {
        let mut seen = Vec::new();
        let see = |state: &State| {
            seen.extend(state.arm.as_ref().map(|arm| position(&arm.status)));
        };
        let outcome = self.job(station, prepared, see).await;
        let strokes = ink_seen(seen.iter().copied(), down_z_mm(paper));
        (outcome, Drawn::new(prepared, strokes, false))
    }

    async fn job(
        &self,
        station: &mut Remote,
        prepared: &Prepared,
        see: impl FnMut(&State),
    ) -> Result<Duration, Failure> {
        // Nothing is queued that cannot be started.
        take_control(station).await?;
        let job = NewJob {
            title: self.title(),
            kind: JobKind::Drawing,
            commands: prepared.plan.commands().collect(),
            lift_mm: lift_mm(&prepared.plan),
            pauses: Vec::new(),
        };
        match station.request(Request::SubmitJob { job }).await? {
            Reply::Job { job } => follow::start(station, job.job, see).await,
            other => Err(anyhow!("the station answers {other:?} to a new job").into()),
        }
    }

    /// Paper and dialect, where they depend on the arm.
    async fn paper_of(
        &self,
        reached: &mut Reached,
    ) -> Result<Option<(Paper, Option<Dialect>)>, Failure> {
        let (z_mm, dialect) = match reached {
            Reached::Station(station) => {
                let (arm, dialect) = control::arm(station).await?;
                (arm.status.z_mm, dialect)
            }
            Reached::Arm(it) if it.virtual_arm.is_none() && self.pen_down.is_none() => {
                (it.arm.next_status().await?.z_mm, self.to.dialect)
            }
            Reached::Arm(_) => return Ok(None),
        };
        let down_z_mm = self.pen_down.unwrap_or(z_mm.into());
        Ok(Some((Paper::level(down_z_mm), dialect)))
    }

    fn settings(&self, svg: &str) -> Settings {
        let size = match (self.fit, self.scale) {
            (true, _) => Size::Fit,
            (false, Some(factor)) => Size::Scaled(factor),
            (false, None) => Size::True,
        };
        let center = self.at.as_ref().map(|at| Point::new(at[0], at[1]));
        Settings {
            tolerance_mm: self.tolerance,
            placement: Placement {
                size,
                center,
                ..Placement::default()
            },
            paper: self.pen_down.map_or_else(Paper::default, Paper::level),
            tool: dobot_draw::Tool::Pen(self.pen()),
            machine: self.machine(self.to.dialect),
            fonts: fonts(svg),
            ..Settings::default()
        }
    }

    fn pen(&self) -> Pen {
        Pen {
            lift_mm: self.pen_lift,
            draw_speed_mm_s: self.speed,
            travel_speed_mm_s: self.travel_speed,
            ..Pen::default()
        }
    }

    fn machine(&self, dialect: Option<Dialect>) -> Machine {
        Machine {
            acceleration_mm_s2: self.acceleration,
            // Nobody knows better over a port until it is told.
            ..dialect.map_or_else(Machine::default, Machine::of)
        }
    }

    fn prepare(&self, svg: &str, settings: &Settings) -> Result<Prepared, Failure> {
        prepare(&svg.into(), settings, reachable).map_err(|error| {
            let hint = hint(&error);
            let error = anyhow::Error::from(error).context(format!("{}", self.file.display()));
            match hint {
                Some(hint) => Failure::new(error, hint),
                None => error.into(),
            }
        })
    }

    fn write_picture(
        &self,
        file: &Path,
        prepared: &Prepared,
        drawn: &Drawn,
        report: &Report,
    ) -> Result<(), Failure> {
        let picture = Picture {
            title: &self.title(),
            figures: &report.figures(),
            area: Placement::default().area,
            plan: &prepared.plan,
            drawn: &drawn.strokes,
            view: if self.whole_reach {
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

    fn title(&self) -> String {
        self.file
            .file_name()
            .map_or_else(String::new, |name| name.to_string_lossy().into_owned())
    }
}

/// The closing report.
#[derive(Debug, Serialize)]
struct Report {
    strokes: usize,
    vectors: usize,
    drawn_mm: f64,
    travelled_mm: f64,
    planned_s: f64,
    /// From the first vector sent to the last one over; absent where the drawing was stopped.
    time_s: Option<f64>,
    deviation_mm: f64,
    deviation_at_mm: [f64; 2],
    /// What the deviation was measured from.
    measured_from: &'static str,
}

impl Report {
    fn new(prepared: &Prepared, drawn: &Drawn, time: Option<Duration>) -> Self {
        let summary = prepared.plan.summary();
        let worst = drawn.worst();
        Self {
            strokes: summary.strokes,
            vectors: summary.vectors,
            drawn_mm: summary.drawn_mm,
            travelled_mm: summary.travelled_mm,
            planned_s: summary.duration_s,
            time_s: time.map(|it| it.as_secs_f64()),
            deviation_mm: worst.distance_mm,
            deviation_at_mm: [worst.at.x, worst.at.y],
            measured_from: if drawn.true_position {
                "the arm's true position"
            } else {
                "the statuses"
            },
        }
    }

    fn print(&self, time: Duration, as_json: bool) -> std::io::Result<()> {
        if as_json {
            return output::json(self);
        }
        output::line(&format!("strokes            {}", self.strokes))?;
        output::line(&format!("vectors            {}", self.vectors))?;
        output::line(&format!("drawn              {:.1} mm", self.drawn_mm))?;
        output::line(&format!(
            "travelled          {:.1} mm, pen up",
            self.travelled_mm
        ))?;
        let (time, planned) = (clock(time.as_secs_f64()), clock(self.planned_s));
        output::line(&format!("time on the arm    {time} ({planned} planned)"))?;
        let [x, y] = self.deviation_at_mm;
        output::line(&format!(
            "largest deviation  {:.3} mm, at x {x:.1} y {y:.1}, measured from {}",
            self.deviation_mm, self.measured_from
        ))
    }

    fn figures(&self) -> Vec<(String, String)> {
        let time_s = self.time_s.unwrap_or(self.planned_s);
        [
            ("strokes", self.strokes.to_string()),
            ("vectors", self.vectors.to_string()),
            ("drawn", format!("{:.0} mm", self.drawn_mm)),
            ("travelled", format!("{:.0} mm", self.travelled_mm)),
            ("time", clock(time_s)),
            ("deviation", format!("{:.3} mm", self.deviation_mm)),
        ]
        .map(|(name, figure)| (name.to_owned(), figure))
        .to_vec()
    }
}

impl Drawn {
    fn new(prepared: &Prepared, strokes: Vec<Stroke>, true_position: bool) -> Self {
        Self {
            deviation: deviation(&prepared.wanted(), &strokes),
            strokes,
            true_position,
        }
    }

    /// What the statuses do not show is not missing.
    fn worst(&self) -> dobot_draw::Worst {
        let Deviation { astray, missed } = self.deviation;
        if self.true_position && missed.distance_mm > astray.distance_mm {
            missed
        } else {
            astray
        }
    }
}

fn read(file: &Path) -> Result<String, Failure> {
    let mut bytes = Vec::new();
    if file == Path::new("-") {
        std::io::stdin()
            .read_to_end(&mut bytes)
            .context("cannot read standard input")?;
    } else {
        bytes = fs::read(file).map_err(|error| {
            let missing = error.kind() == std::io::ErrorKind::NotFound;
            let error =
                anyhow::Error::from(error).context(format!("cannot read {}", file.display()));
            if missing {
                Failure::new(
                    error,
                    "give the name of an SVG file; examples/drawings/ has some",
                )
            } else {
                error.into()
            }
        })?;
    }
    String::from_utf8(bytes).map_err(|_| {
        Failure::new(
            anyhow!("{} is not text, so it is not an SVG file", file.display()),
            "save the drawing as plain SVG (not compressed .svgz, not a bitmap)",
        )
    })
}

/// The fonts of this machine, if there is anything to letter.
fn fonts(svg: &str) -> Arc<fontdb::Database> {
    let mut fonts = fontdb::Database::new();
    if svg.contains("<text") || svg.contains(":text") {
        fonts.load_system_fonts();
    }
    Arc::new(fonts)
}

const fn pen_of(settings: &Settings) -> Pen {
    match settings.tool {
        dobot_draw::Tool::Pen(pen) => pen,
        dobot_draw::Tool::Laser(_) => panic!("no option asks for a laser yet"),
    }
}

fn reachable(position: Position) -> Result<(), Unreachable> {
    let pose = Pose {
        position,
        rotation: position.direction(),
    };
    Limits::STOCK.solve(&pose, Tool::SuctionCup).map(|_| ())
}

fn hint(error: &PrepareError) -> Option<String> {
    use dobot_draw::PlaceError;
    match error {
        PrepareError::Place(PlaceError::TooLarge { .. }) => {
            Some("`--fit` makes it as large as the drawing area allows".into())
        }
        PrepareError::Place(PlaceError::OutOfReach { .. }) => Some(
            "`--fit` without `--at` places it inside reach; `--pen-down` and `--pen-lift` set the heights".into(),
        ),
        _ => None,
    }
}

fn stopped(stopped: Stopped) -> Failure {
    match stopped.parting {
        Parting::Done | Parting::Unneeded => stopped.into(),
        Parting::Sent | Parting::Lost => Failure::new(
            stopped,
            "look after the arm: lift the pen or switch it off by hand",
        ),
    }
}

fn progress_bar(prepared: &Prepared) -> ProgressBar {
    let vectors = prepared.plan.moves.len() as u64;
    let style =
        ProgressStyle::with_template("{wide_bar:.cyan/dim} {pos}/{len} vectors, {msg} left");
    ProgressBar::new(vectors).with_style(style.expect("the template is well-formed"))
}

#[expect(clippy::cast_possible_truncation, reason = "as the job holds it")]
fn lift_mm(plan: &Plan) -> f32 {
    plan.lift_mm() as f32
}

/// Where ink is looked for, on paper that is level.
fn down_z_mm(paper: &Paper) -> f64 {
    paper.z_at(Point::default())
}

fn picture_file(text: &str) -> Result<PathBuf, String> {
    let file = PathBuf::from(text);
    let ending = file
        .extension()
        .and_then(|it| it.to_str())
        .map(str::to_ascii_lowercase);
    match ending.as_deref() {
        Some("svg" | "png") => Ok(file),
        _ => Err("allowed are names that end in .svg or .png".into()),
    }
}

fn is_png(file: &Path) -> bool {
    file.extension()
        .is_some_and(|it| it.eq_ignore_ascii_case("png"))
}

const PNG_WIDTH_PX: u32 = 2000;
