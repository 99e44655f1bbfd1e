//! `dobot fleet together`: one program for several arms.

use std::collections::BTreeMap;
use std::fs;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};

use anyhow::{Context, anyhow};
use dobot_draw::ProgramFiles;
use dobot_fleet::together::{
    EngineEvent, Home, Order, Outcome, Part, Rehearsal, RunEvent, Together, check, rehearse, run,
};
use dobot_host::{PlannedFor, Rules};
use dobot_safety::Policy;
use dobot_teach::Program;
use dobot_wire::Dialect;
use tokio::io::{AsyncBufReadExt, BufReader};
use tokio::sync::mpsc;

use crate::connect::{read_policy, speaker};
use crate::failure::Failure;
use crate::interrupt::interrupt;
use crate::output::{self, clock};
use crate::reach::Station;

/// One program for several arms
#[derive(Clone, Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot fleet together examples/together/cube.toml --dry-run    when all meet, and who waits; nothing moves
  DOBOT_TOKEN=$(cat teacher.txt) dobot fleet together examples/together/cube.toml    each station accepts this token

The file names the arms and their programs; a step `barrier = \"NAME\"` waits for all that have it. Ctrl-C has all arms hold.
When one does not go on, those that depend on it hold, and a person decides.")]
pub(super) struct TogetherArgs {
    /// The program for several arms: a TOML file that names the parts
    file: PathBuf,
    /// Rehearse it with virtual arms on one clock: when all meet, and who waits; nothing moves
    #[arg(long)]
    dry_run: bool,
    /// The policy of the rehearsal, a TOML file (default: the one that `dobot policy` shows)
    #[arg(long, value_name = "FILE", requires = "dry_run")]
    policy: Option<PathBuf>,
    /// Which arms the rehearsal has: specification or firmware-1.1
    #[arg(long, default_value_t = Dialect::FIRMWARE_1_1, requires = "dry_run")]
    dialect: Dialect,
}

impl TogetherArgs {
    pub(super) async fn run(self, station: &Station, as_json: bool) -> Result<(), Failure> {
        let policy = self.policy.as_deref();
        let policy = policy.map_or(Ok(Policy::default()), read_policy)?;
        let arm = PlannedFor::any(Rules::of(&policy).into(), Some(self.dialect));
        let parts = read(&self.file, &arm)?;
        if self.dry_run {
            let told = rehearse(&parts, &policy, speaker(self.dialect))?;
            return tell(&told, as_json);
        }
        let address = station.address_of_running().await?;
        carry_out(&Home::new(address), &parts, as_json).await
    }
}

/// All parts, in which nothing is wrong.
fn read(file: &Path, arm: &PlannedFor) -> Result<Vec<Part>, Failure> {
    let named = || file.display().to_string();
    let together = Together::from_toml(&text(file)?).with_context(named)?;
    let folder = file.parent().unwrap_or(Path::new(""));
    let parts = together.parts.into_iter();
    let parts = parts.map(|it| read_part(it.arm, &folder.join(it.program), arm));
    let parts = parts.collect::<Result<Vec<_>, _>>()?;
    let problems = check(&parts);
    if problems.is_empty() {
        return Ok(parts);
    }
    let (file, count) = (named(), problems.len());
    Err(anyhow!("{file} has {count} problems:\n{}", problems.join("\n")).into())
}

/// A part with all that its station needs for it.
fn read_part(arm: String, file: &Path, planned: &PlannedFor) -> Result<Part, Failure> {
    let named = || file.display().to_string();
    let folder = file.parent().unwrap_or(Path::new(""));
    let text = text(file)?;
    let program = Program::from_toml(&text).with_context(named)?;
    let mut files = BTreeMap::new();
    let read = |path: &str| {
        let bytes = fs::read(folder.join(path));
        let bytes = bytes.map_err(|error| format!("cannot read {path}: {error}"))?;
        let text = String::from_utf8(bytes.clone());
        let text = text.map_err(|_| {
            format!("{path} is not text in UTF-8, and only texts go to a station: draw an SVG")
        })?;
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

fn text(file: &Path) -> Result<String, Failure> {
    let read = fs::read_to_string(file);
    Ok(read.with_context(|| format!("cannot read {}", file.display()))?)
}

/// What a rehearsal shows.
fn tell(told: &Rehearsal, as_json: bool) -> Result<(), Failure> {
    if as_json {
        return Ok(output::json(told)?);
    }
    for it in &told.barriers {
        let waits = it.waits.iter();
        let waits = waits.map(|it| format!("{} {}", it.arm, clock(it.waited_s)));
        let waits = waits.collect::<Vec<_>>().join(", ");
        let (at, barrier) = (clock(it.at_s), &it.barrier);
        output::line(&format!("{at:>10}  all at {barrier:?}; waited: {waits}"))?;
    }
    for it in &told.parts {
        let over = it.over_s.map_or("on and on".to_owned(), clock);
        let waited = clock(it.waited_s);
        output::line(&format!(
            "{over:>10}  {} is through, {waited} of it waiting",
            it.arm
        ))?;
    }
    Ok(())
}

/// Does it with the arms of the fleet.
async fn carry_out(home: &Home, parts: &[Part], as_json: bool) -> Result<(), Failure> {
    let is_attended = std::io::stdin().is_terminal();
    let (sender, orders) = mpsc::channel(8);
    let deciding = tokio::spawn(decide(sender, is_attended));
    let mut teller = Teller::new(parts, as_json, is_attended);
    let outcome = run(home, parts, is_attended, orders, |said| teller.say(&said)).await;
    deciding.abort();
    match outcome? {
        Outcome::Done => teller.sum_up(),
        Outcome::Held => Err(Failure::new(
            anyhow!("not all arms are through"),
            "their jobs stay paused at their stations: `dobot jobs` lists them there, and `dobot jobs cancel` ends one",
        )),
    }
}

/// What a person decides: by Ctrl-C, and by keys where a terminal is there.
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

/// Tells a person how it goes.
struct Teller<'a> {
    parts: &'a [Part],
    jobs: Vec<u64>,
    as_json: bool,
    is_attended: bool,
    /// The farthest that any start was apart.
    most_ms: f64,
}

impl<'a> Teller<'a> {
    const fn new(parts: &'a [Part], as_json: bool, is_attended: bool) -> Self {
        Self {
            parts,
            jobs: Vec::new(),
            as_json,
            is_attended,
            most_ms: 0.0,
        }
    }

    /// Output that nobody reads any more does not end what the arms do.
    fn say(&mut self, said: &RunEvent) {
        match said {
            RunEvent::Queued(jobs) => self.jobs.clone_from(jobs),
            RunEvent::Started { within_ms, .. } => self.most_ms = self.most_ms.max(*within_ms),
            RunEvent::News(_) | RunEvent::Hindered { .. } => {}
        }
        if self.as_json {
            return drop(output::json(said));
        }
        for line in self.lines(said) {
            drop(output::plain_line(&line));
        }
    }

    fn lines(&self, said: &RunEvent) -> Vec<String> {
        match said {
            RunEvent::Queued(jobs) => {
                let both = self.parts.iter().zip(jobs);
                let line =
                    |(it, job): (&Part, &u64)| format!("{}: {} is job {job}", it.arm, it.file);
                both.map(line).collect()
            }
            RunEvent::Started { barrier, within_ms } => {
                let all = barrier.as_ref().map_or("all begin".to_owned(), |it| {
                    format!("all that waited at {it:?} go on")
                });
                vec![format!(
                    "{all}, started within {within_ms:.0} ms of each other"
                )]
            }
            RunEvent::Hindered { part, why } => {
                vec![format!("{} cannot go on: {why}", self.arm(*part))]
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
                    "{arm} waits for a person: {message}; `dobot jobs start {job}` at its station goes on"
                )]
            }
            EngineEvent::Done { part } => vec![format!("{} is through", self.arm(*part))],
            EngineEvent::Held { part, why, with } => {
                let with: Vec<_> = with.iter().map(|it| self.arm(*it)).collect();
                let holds = match &with[..] {
                    [] => "nobody depends on it".to_owned(),
                    with => format!("{} hold with it", with.join(", ")),
                };
                let keys = "look at its arm; then g and Enter goes on, e and Enter ends it";
                let line = format!("{} does not go on: {why}; {holds}", self.arm(*part));
                let keys = self.is_attended.then(|| keys.to_owned());
                [line].into_iter().chain(keys).collect()
            }
        }
    }

    fn arm(&self, part: usize) -> &str {
        &self.parts[part].arm
    }

    fn sum_up(&self) -> Result<(), Failure> {
        if self.as_json {
            return Ok(());
        }
        let most_ms = self.most_ms;
        let line = format!(
            "all are through; they were started within {most_ms:.0} ms of each other at the most"
        );
        Ok(output::line(&line)?)
    }
}
