//! `dobot service`: the station as a service that the system keeps running.

mod unit;

use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::{Context, anyhow};
use clap::Subcommand;

use self::unit::{Scope, ServiceManager, Unit};
use crate::failure::Failure;
use crate::output;

/// Let the system keep the station running: start it anew when it is killed or stands still
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot service install -- --arm serial:/dev/ttyUSB0     for this person; behind -- what `dobot up` is told
  sudo dobot service install --system                    for the machine, from its start on
  dobot service status
  dobot service remove

A station that is started anew switches the laser off before anything else. The watchdog of the one that was killed has
done that already, so the arm waits for neither.")]
pub(crate) struct Args {
    #[command(subcommand)]
    action: Action,
}

#[derive(Debug, Subcommand)]
enum Action {
    /// Write the service's file, and start it where the system's manager of services runs
    Install {
        #[command(flatten)]
        whose: Whose,
        /// Where the station keeps its data
        #[arg(long, value_name = "FOLDER")]
        data: Option<PathBuf>,
        /// What `dobot up` is told
        #[arg(last = true, value_name = "ARGUMENT")]
        up: Vec<String>,
    },
    /// Stop the service, and remove its file
    Remove {
        #[command(flatten)]
        whose: Whose,
    },
    /// Tell whether it is installed, and whether it runs
    Status {
        #[command(flatten)]
        whose: Whose,
    },
}

#[derive(Clone, Copy, Debug, clap::Args)]
struct Whose {
    /// For this person: it runs while that person is logged in (the default)
    #[arg(long, conflicts_with = "system")]
    user: bool,
    /// For the machine
    #[arg(long)]
    system: bool,
}

impl Whose {
    const fn scope(self) -> Scope {
        if self.system {
            Scope::System
        } else {
            Scope::User
        }
    }
}

pub(crate) fn run(args: Args) -> Result<(), Failure> {
    match args.action {
        Action::Install { whose, data, up } => install(whose.scope(), data, up),
        Action::Remove { whose } => remove(whose.scope()),
        Action::Status { whose } => status(whose.scope()),
    }
}

fn install(scope: Scope, data: Option<PathBuf>, up: Vec<String>) -> Result<(), Failure> {
    let up = with_log(up);
    check_up(&up)?;
    let file = file(scope)?;
    let unit = Unit {
        scope,
        program: std::env::current_exe().context("this program cannot be found")?,
        arguments: up,
        data: data.map(std::path::absolute).transpose()?,
    };
    let folder = file.parent().expect("a file of a service is in a folder");
    std::fs::create_dir_all(folder)
        .and_then(|()| std::fs::write(&file, ServiceManager::HERE.text(&unit)))
        .map_err(|error| not_written(&file, scope, error))?;
    output::line(&format!("installed {}", file.display()))?;
    carry_out("start it", &ServiceManager::HERE.enable(scope, &file))?;
    if scope == Scope::User && ServiceManager::HERE == ServiceManager::Systemd {
        output::line("it ends when you log out, unless `loginctl enable-linger` says otherwise")?;
    }
    Ok(())
}

/// The log of a service is for programs, unless it is wanted otherwise.
fn with_log(mut up: Vec<String>) -> Vec<String> {
    if !up.iter().any(|it| it.starts_with("--log-format")) {
        up.splice(0..0, ["--log-format", "json"].map(str::to_owned));
    }
    up
}

/// What `dobot up` would not understand would only show when the service does not start.
fn check_up(up: &[String]) -> Result<(), Failure> {
    let words = ["dobot", "up"].into_iter().map(str::to_owned);
    let checked = crate::check(words.chain(up.iter().cloned()));
    checked.map_err(|error| {
        let text = error.to_string();
        let line = text.lines().next().unwrap_or_default();
        let line = line.trim_start_matches("error: ").to_owned();
        Failure::new(
            anyhow!("`dobot up`: {line}"),
            "`dobot up --help` tells what it can be told",
        )
    })
}

fn remove(scope: Scope) -> Result<(), Failure> {
    let file = installed(scope)?;
    carry_out("stop it", &ServiceManager::HERE.disable(scope, &file))?;
    std::fs::remove_file(&file).map_err(|error| not_written(&file, scope, error))?;
    output::line(&format!("removed {}", file.display()))?;
    Ok(())
}

fn status(scope: Scope) -> Result<(), Failure> {
    let file = installed(scope)?;
    output::line(&format!("installed {}", file.display()))?;
    let ask = ServiceManager::HERE.ask(scope);
    if !runs_here() {
        output::line(&format!(
            "nothing on this machine keeps services running now; where it does: {}",
            ask.join(" ")
        ))?;
        return Ok(());
    }
    let asked = command(&ask).stderr(Stdio::null()).output();
    let asked = asked.with_context(|| ask.join(" "))?;
    let text = String::from_utf8_lossy(&asked.stdout);
    let state = if asked.status.success() {
        "running"
    } else {
        "not running"
    };
    output::line(&format!("{state} ({}: {})", ask.join(" "), text.trim()))?;
    Ok(())
}

/// Runs commands where services are kept running now, and tells them where not.
fn carry_out(what: &str, commands: &[Vec<String>]) -> Result<(), Failure> {
    for words in commands {
        let text = words.join(" ");
        if !runs_here() {
            output::line(&format!("to {what}: {text}"))?;
            continue;
        }
        let status = command(words).status().with_context(|| text.clone())?;
        if !status.success() {
            let error = anyhow!("`{text}` failed: {status}");
            return Err(Failure::new(
                error,
                "`dobot service status` tells how far it came",
            ));
        }
        output::line(&format!("done: {text}"))?;
    }
    Ok(())
}

fn command(words: &[String]) -> Command {
    let mut command = Command::new(&words[0]);
    command.args(&words[1..]);
    command
}

/// Whether what keeps services runs on this machine now: in a container it mostly does not.
fn runs_here() -> bool {
    match ServiceManager::HERE {
        ServiceManager::Systemd => Path::new("/run/systemd/system").is_dir(),
        ServiceManager::Launchd => true,
    }
}

fn file(scope: Scope) -> Result<PathBuf, Failure> {
    let home = std::env::home_dir().filter(|it| it.is_absolute());
    let home = match (scope, home) {
        (_, Some(home)) => home,
        (Scope::System, None) => PathBuf::from("/"),
        (Scope::User, None) => {
            return Err(Failure::new(
                anyhow!("this person has no home folder"),
                "`dobot service install --system` installs it for the machine",
            ));
        }
    };
    Ok(scope
        .folder(ServiceManager::HERE, &home)
        .join(ServiceManager::HERE.file()))
}

fn installed(scope: Scope) -> Result<PathBuf, Failure> {
    let file = file(scope)?;
    if file.exists() {
        return Ok(file);
    }
    let option = scope.option();
    Err(Failure::new(
        anyhow!("no service is installed: there is no {}", file.display()),
        format!("`dobot service install {option}`"),
    ))
}

fn not_written(file: &Path, scope: Scope, error: std::io::Error) -> Failure {
    let denied = error.kind() == ErrorKind::PermissionDenied;
    let error = anyhow::Error::new(error).context(format!("cannot change {}", file.display()));
    match scope {
        Scope::System if denied => Failure::new(
            error,
            "the machine's services belong to root: `sudo dobot service ... --system`, or `--user`",
        ),
        _ => error.into(),
    }
}
