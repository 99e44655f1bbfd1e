//! `dobot fleet together`: a coordinated program for several arms.

use std::collections::BTreeMap;
use std::fs;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};

use anyhow::{Context, anyhow};
use dobot_draw::ProgramFiles;
use dobot_fleet::together::{
    EngineEvent, Home, Order, Outcome, Part, Rehearsal, RunEvent, Together, check, rehearse, run,
};
use dobot_host::{PlannedFor, Rules, personality_of};
use dobot_safety::Policy;
use dobot_teach::Program;
use dobot_wire::Dialect;
use tokio::io::{AsyncBufReadExt, BufReader};
use tokio::sync::mpsc;

use crate::connect::read_policy;
use crate::failure::Failure;
use crate::interrupt::interrupt;
use crate::output::{self, clock};
use crate::reach::Station;

/// Run a coordinated program on several arms, with barriers
#[derive(Clone, Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot fleet together examples/together/cube.toml --dry-run
                                     simulate: when the arms meet, which ones wait
  DOBOT_TOKEN=$(cat teacher.txt) dobot fleet together examples/together/cube.toml
                                     run it; each station must accept this token

The file names the arms and their programs. A step `barrier = \"NAME\"` waits for
all arms that have it. Ctrl-C pauses all arms. If one arm cannot continue, those
that depend on it pause, and a person decides.")]
pub(super) struct TogetherArgs {
    /// Coordinated program, a TOML file that names the parts
    file: PathBuf,
    /// Simulate only, with virtual arms on one clock: when the arms meet, which ones wait
    #[arg(long)]
    dry_run: bool,
    /// Safety policy of the simulation, a TOML file (default: as printed by `dobot policy`)
    #[arg(long, value_name = "FILE", requires = "dry_run")]
    policy: Option<PathBuf>,
    /// Protocol dialect of the simulated arms: specification or firmware-1.1
    #[arg(long, value_name = "DIALECT", default_value_t = Dialect::SPECIFICATION, requires = "dry_run")]
    dialect: Dialect,
}

impl TogetherArgs {
    pub(super) async fn run(self, station: &Station, as_json: bool) -> Result<(), Failure> {
        let policy = self.policy.as_deref();
        let policy = policy.map_or(Ok(Policy::default()), read_policy)?;
        let arm = PlannedFor::any(Rules::of(&policy).into(), Some(self.dialect));
        let parts = read(&self.file, &arm)?;
        if self.dry_run {
            let rehearsal = rehearse(&parts, &policy, personality_of(self.dialect))?;
            return print(&rehearsal, as_json);
        }
        let address = station.address_of_running().await?;
        run_on_arms(&Home::new(address), &parts, as_json).await
    }
}

/// Reads and checks all parts.
fn read(file: &Path, arm: &PlannedFor) -> Result<Vec<Part>, Failure> {
    let named = || file.display().to_string();
    let together = Together::from_toml(&text(file)?).with_context(named)?;
    let folder = file.parent().unwrap_or(Path::new(""));
    let parts = together.parts.into_iter();
    let parts = parts.map(|part| read_part(part.arm, &folder.join(part.program), arm));
    let parts = parts.collect::<Result<Vec<_>, _>>()?;
    let problems = check(&parts);
    if problems.is_empty() {
        return Ok(parts);
    }
    let (file, count) = (named(), problems.len());
    let count = output::count(count, "problem");
    Err(anyhow!("{file} has {count}:\n{}", problems.join("\n")).into())
}

/// Reads a part with the files that its station needs.
fn read_part(arm: String, file: &Path, planned: &PlannedFor) -> Result<Part, Failure> {
    let named = || file.display().to_string();
    let folder = file.parent().unwrap_or(Path::new(""));
    let text = text(file)?;
    let program = Program::from_toml(&text).with_context(named)?;
    let mut files = BTreeMap::new();
    let read = |path: &str| {
        let (bytes, text) = read_text(folder, path)?;
        files.insert(path.to_owned(), text);
        Ok(bytes)
    };
    let mut reader = ProgramFiles::new(read, planned.dialect(), planned.calibration.clone());
    let compiled = program.compile_for(&planned.arm(), &mut reader);
    let compiled = compiled.with_context(named)?;
    Ok(Part {
        arm,
        file: named(),
        text,
        files,
        compiled,
    })
}

/// Reads a file of a part, as bytes and as the text that is sent to its station.
fn read_text(folder: &Path, path: &str) -> Result<(Vec<u8>, String), String> {
    let bytes = fs::read(folder.join(path));
    let bytes = bytes.map_err(|error| format!("cannot read {path}: {error}"))?;
    let text = String::from_utf8(bytes.clone());
    let text = text.map_err(|_| {
        format!(
            "{path} is not UTF-8 text; only text files can be sent to a station, for example SVG"
        )
    })?;
    Ok((bytes, text))
}

fn text(file: &Path) -> Result<String, Failure> {
    let read = fs::read_to_string(file);
    Ok(read.with_context(|| format!("cannot read {}", file.display()))?)
}

/// Prints the result of a rehearsal.
fn print(rehearsal: &Rehearsal, as_json: bool) -> Result<(), Failure> {
    if as_json {
        return Ok(output::json(rehearsal)?);
    }
    for meeting in &rehearsal.barriers {
        let waits = meeting.waits.iter();
        let waits = waits.map(|wait| format!("{} {}", wait.arm, clock(wait.waited_s)));
        let waits = waits.collect::<Vec<_>>().join(", ");
        let (at, barrier) = (clock(meeting.at_s), &meeting.barrier);
        output::line(&format!("{at:>10}  all at {barrier:?}; waited: {waits}"))?;
    }
    for part in &rehearsal.parts {
        let over = part.over_s.map_or("endless".to_owned(), clock);
        let waited = clock(part.waited_s);
        output::line(&format!(
            "{over:>10}  {} is done, {waited} of it waiting",
            part.arm
        ))?;
    }
    Ok(())
}

/// Runs the program on the arms of the fleet.
async fn run_on_arms(home: &Home, parts: &[Part], as_json: bool) -> Result<(), Failure> {
    let is_attended = std::io::stdin().is_terminal();
    let (sender, orders) = mpsc::channel(8);
    let deciding = tokio::spawn(decide(sender, is_attended));
    let mut progress = Progress::new(parts, as_json, is_attended);
    let outcome = run(home, parts, is_attended, orders, |event| {
        progress.show(&event);
    })
    .await;
    deciding.abort();
    match outcome? {
        Outcome::Done => progress.sum_up(),
        Outcome::Held => Err(Failure::new(
            anyhow!("not all arms are done"),
            "run `dobot jobs` at the stations: the jobs of the others are paused there; `dobot jobs cancel` ends one",
        )),
    }
}

/// Reads the decisions of a person: Ctrl-C, and keys on a terminal.
async fn decide(orders: mpsc::Sender<Order>, is_attended: bool) {
    let mut lines = BufReader::new(tokio::io::stdin()).lines();
    let mut is_held = false;
    loop {
        let order = tokio::select! {
            () = interrupt() => if is_held { Order::Leave } else { Order::Hold },
            line = lines.next_line(), if is_attended => {
                let line = line.ok().flatten().unwrap_or_else(|| "e".to_owned());
                match line.trim() {
                    "g" | "G" => Order::Resume,
                    "e" | "E" => Order::Leave,
                    _ => continue,
                }
            }
        };
        is_held = order == Order::Hold;
        if orders.send(order).await.is_err() {
            return;
        }
    }
}

/// Prints the progress.
struct Progress<'a> {
    parts: &'a [Part],
    jobs: Vec<u64>,
    as_json: bool,
    is_attended: bool,
    /// The largest time between the starts at a barrier.
    most_ms: f64,
}

impl<'a> Progress<'a> {
    const fn new(parts: &'a [Part], as_json: bool, is_attended: bool) -> Self {
        Self {
            parts,
            jobs: Vec::new(),
            as_json,
            is_attended,
            most_ms: 0.0,
        }
    }

    /// Shows an event. A closed standard output does not end the program of the arms.
    fn show(&mut self, event: &RunEvent) {
        match event {
            RunEvent::Queued(jobs) => self.jobs.clone_from(jobs),
            RunEvent::Started { within_ms, .. } => self.most_ms = self.most_ms.max(*within_ms),
            RunEvent::News(_) | RunEvent::Hindered { .. } => {}
        }
        if self.as_json {
            return drop(output::json(event));
        }
        for line in self.lines(event) {
            drop(output::plain_line(&line));
        }
    }

    fn lines(&self, event: &RunEvent) -> Vec<String> {
        match event {
            RunEvent::Queued(jobs) => {
                let both = self.parts.iter().zip(jobs);
                let line = |(part, job): (&Part, &u64)| {
                    format!("{}: {} is job {job}", part.arm, part.file)
                };
                both.map(line).collect()
            }
            RunEvent::Started { barrier, within_ms } => {
                let all = barrier
                    .as_ref()
                    .map_or("all arms start".to_owned(), |barrier| {
                        format!("the arms at {barrier:?} continue")
                    });
                vec![format!("{all}, within {within_ms:.0} ms of each other")]
            }
            RunEvent::Hindered { part, why } => {
                vec![format!("{} cannot continue: {why}", self.arm(*part))]
            }
            RunEvent::News(news) => self.news(news),
        }
    }

    fn news(&self, news: &EngineEvent) -> Vec<String> {
        match news {
            EngineEvent::Arrived { part, barrier } => {
                vec![format!("{} is at {barrier:?}", self.arm(*part))]
            }
            EngineEvent::SetOut { .. } => Vec::new(),
            EngineEvent::WaitsForPerson { part, message } => {
                let (arm, job) = (self.arm(*part), self.jobs.get(*part).unwrap_or(&0));
                vec![format!(
                    "{arm} waits for a person: {message}; run `dobot jobs start {job}` at its station to continue"
                )]
            }
            EngineEvent::Done { part } => vec![format!("{} is done", self.arm(*part))],
            EngineEvent::Held { part, why, with } => self.held(*part, why, with),
        }
    }

    /// Returns the lines about an arm that does not continue, and what a person can do.
    fn held(&self, part: usize, why: &str, with: &[usize]) -> Vec<String> {
        let with: Vec<_> = with.iter().map(|part| self.arm(*part)).collect();
        let holds = match &with[..] {
            [] => "no other arm depends on it".to_owned(),
            [one] => format!("{one} pauses, too"),
            with => format!("{} pause, too", with.join(", ")),
        };
        let keys = "look at its arm; then press g and Enter to continue, or e and Enter to end it";
        let line = format!("{} does not continue: {why}; {holds}", self.arm(part));
        let keys = self.is_attended.then(|| keys.to_owned());
        [line].into_iter().chain(keys).collect()
    }

    fn arm(&self, part: usize) -> &str {
        &self.parts[part].arm
    }

    fn sum_up(&self) -> Result<(), Failure> {
        if self.as_json {
            return Ok(());
        }
        let most_ms = self.most_ms;
        let line = format!("all arms are done; their starts were at most {most_ms:.0} ms apart");
        Ok(output::line(&line)?)
    }
}
