//! `dobot service`: runs the station as a system service.

mod unit;

use std::ffi::OsString;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::{Context, anyhow};
use clap::Subcommand;

use self::unit::{Scope, ServiceManager, Unit};
use crate::failure::Failure;
use crate::{command_line, output, renamed};

/// Run the station as a system service, restarted if it crashes or hangs
#[derive(Debug, clap::Args)]
#[command(after_help = "\
Examples:
  dobot service install -- --arm serial:/dev/ttyUSB0
                                             for this user; options of `dobot up`
                                             follow --
  sudo dobot service install --system        for the machine, from boot
  dobot service status
  dobot service remove

A restarted station first switches the laser off. The watchdog of a killed
station has already done so by then.")]
pub(crate) struct Args {
    #[command(subcommand)]
    action: Action,
}

#[derive(Debug, Subcommand)]
enum Action {
    /// Install the service, and start it if the service manager runs
    Install {
        #[command(flatten)]
        scope: ScopeArgs,
        /// Data folder of the station
        #[arg(long, value_name = "FOLDER")]
        data: Option<PathBuf>,
        /// Options of `dobot up`
        #[arg(last = true, value_name = "ARGUMENT")]
        up: Vec<String>,
    },
    /// Stop the service and remove it
    Remove {
        #[command(flatten)]
        scope: ScopeArgs,
    },
    /// Print the service file, for packages and other service managers
    Print {
        #[command(flatten)]
        scope: ScopeArgs,
        /// Data folder of the station
        #[arg(long, value_name = "FOLDER")]
        data: Option<PathBuf>,
        /// Options of `dobot up`
        #[arg(last = true, value_name = "ARGUMENT")]
        up: Vec<String>,
    },
    /// Show whether the service is installed and running
    Status {
        #[command(flatten)]
        scope: ScopeArgs,
    },
}

#[derive(Clone, Copy, Debug, clap::Args)]
struct ScopeArgs {
    /// For this user, while logged in (default)
    #[arg(long, conflicts_with = "system")]
    user: bool,
    /// For the machine
    #[arg(long)]
    system: bool,
}

impl ScopeArgs {
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
        Action::Install { scope, data, up } => install(scope.scope(), data, up),
        Action::Remove { scope } => remove(scope.scope()),
        Action::Print { scope, data, up } => {
            let unit = unit(scope.scope(), data, up)?;
            Ok(output::bytes(ServiceManager::HERE.text(&unit).as_bytes())?)
        }
        Action::Status { scope } => status(scope.scope()),
    }
}

fn install(scope: Scope, data: Option<PathBuf>, up: Vec<String>) -> Result<(), Failure> {
    let unit = unit(scope, data, up)?;
    let file = file(scope)?;
    let folder = file.parent().expect("a file of a service is in a folder");
    std::fs::create_dir_all(folder)
        .and_then(|()| std::fs::write(&file, ServiceManager::HERE.text(&unit)))
        .map_err(|error| not_written(&file, scope, error))?;
    output::line(&format!("installed {}", file.display()))?;
    run_or_print("start it", &ServiceManager::HERE.enable(scope, &file))?;
    if scope == Scope::User && ServiceManager::HERE == ServiceManager::Systemd {
        output::line("it ends when you log out; `loginctl enable-linger` keeps it running")?;
    }
    Ok(())
}

fn unit(scope: Scope, data: Option<PathBuf>, up: Vec<String>) -> Result<Unit, Failure> {
    let up = with_log(up);
    check_up(&up)?;
    Ok(Unit {
        scope,
        program: std::env::current_exe().context("cannot find the file of this program")?,
        arguments: up,
        data: data.map(std::path::absolute).transpose()?,
    })
}

/// Adds the JSON log format unless a format is given.
fn with_log(mut up: Vec<String>) -> Vec<String> {
    if !up.iter().any(|word| word.starts_with("--log-format")) {
        up.splice(0..0, ["--log-format", "json"].map(str::to_owned));
    }
    up
}

/// Checks the options of `dobot up`, which would otherwise fail only when the service starts.
fn check_up(up: &[String]) -> Result<(), Failure> {
    let words = ["dobot", "up"].into_iter().map(OsString::from);
    let mut words: Vec<OsString> = words.chain(up.iter().map(OsString::from)).collect();
    for hint in renamed::replace(&mut words) {
        eprintln!("hint: {hint}");
    }
    command_line::parse(words).map(drop).map_err(|error| {
        let text = error.to_string();
        let line = text.lines().next().unwrap_or_default();
        let line = line.trim_start_matches("error: ").to_owned();
        Failure::usage(anyhow!("`dobot up`: {line}"))
            .with_hint("run `dobot up --help` for its options")
    })
}

fn remove(scope: Scope) -> Result<(), Failure> {
    let file = installed(scope)?;
    run_or_print("stop it", &ServiceManager::HERE.disable(scope, &file))?;
    std::fs::remove_file(&file).map_err(|error| not_written(&file, scope, error))?;
    output::line(&format!("removed {}", file.display()))?;
    Ok(())
}

fn status(scope: Scope) -> Result<(), Failure> {
    let file = installed(scope)?;
    output::line(&format!("installed {}", file.display()))?;
    let ask = ServiceManager::HERE.status_command(scope);
    if !runs_here() {
        output::line(&format!(
            "no service manager runs on this machine now; on one that has it, run: {}",
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

/// Runs commands if a service manager runs, and otherwise prints them.
fn run_or_print(what: &str, commands: &[Vec<String>]) -> Result<(), Failure> {
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
                "run `dobot service status` to see its state",
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

/// Whether a service manager runs on this machine; in a container it usually does not.
fn runs_here() -> bool {
    match ServiceManager::HERE {
        ServiceManager::Systemd => Path::new("/run/systemd/system").is_dir(),
        ServiceManager::Launchd => true,
    }
}

fn file(scope: Scope) -> Result<PathBuf, Failure> {
    let home = std::env::home_dir().filter(|home| home.is_absolute());
    let home = match (scope, home) {
        (_, Some(home)) => home,
        (Scope::System, None) => PathBuf::from("/"),
        (Scope::User, None) => {
            return Err(Failure::new(
                anyhow!("this user has no home folder"),
                "install it for the machine: `dobot service install --system`",
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
        anyhow!("no service is installed: {} does not exist", file.display()),
        format!("install it with `dobot service install {option}`"),
    ))
}

fn not_written(file: &Path, scope: Scope, error: std::io::Error) -> Failure {
    let denied = error.kind() == ErrorKind::PermissionDenied;
    let error = anyhow::Error::new(error).context(format!("cannot change {}", file.display()));
    match scope {
        Scope::System if denied => Failure::new(
            error,
            "run `sudo dobot service ... --system`, or use `--user`; services of the machine belong to root",
        ),
        _ => error.into(),
    }
}
