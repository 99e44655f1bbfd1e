//! The files that tell a system to keep a station running.

use std::path::{Path, PathBuf};

/// Whose service it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scope {
    /// Of the person who installs it: it runs while that person is logged in, or lingers.
    User,
    /// Of the machine: it runs from the start on.
    System,
}

/// What keeps services running here.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ServiceManager {
    /// systemd.
    Systemd,
    /// launchd of macOS.
    Launchd,
}

/// What is to be run.
#[derive(Clone, Debug)]
pub(super) struct Unit {
    pub(super) scope: Scope,
    pub(super) program: PathBuf,
    /// The arguments behind `dobot up`.
    pub(super) arguments: Vec<String>,
    /// Where the station keeps its data; its usual place when absent.
    pub(super) data: Option<PathBuf>,
}

impl Scope {
    /// The folder of such files.
    pub(super) fn folder(self, manager: ServiceManager, home: &Path) -> PathBuf {
        match (manager, self) {
            (ServiceManager::Systemd, Self::System) => "/etc/systemd/system".into(),
            (ServiceManager::Systemd, Self::User) => home.join(".config/systemd/user"),
            (ServiceManager::Launchd, Self::System) => "/Library/LaunchDaemons".into(),
            (ServiceManager::Launchd, Self::User) => home.join("Library/LaunchAgents"),
        }
    }

    /// As the option that says it.
    pub(super) const fn option(self) -> &'static str {
        match self {
            Self::User => "--user",
            Self::System => "--system",
        }
    }
}

impl ServiceManager {
    /// The one of this system.
    pub(super) const HERE: Self = if cfg!(target_os = "macos") {
        Self::Launchd
    } else {
        Self::Systemd
    };

    /// The name of the file.
    pub(super) const fn file(self) -> &'static str {
        match self {
            Self::Systemd => "dobot.service",
            Self::Launchd => "dobot.station.plist",
        }
    }

    /// The file.
    pub(super) fn text(self, unit: &Unit) -> String {
        match self {
            Self::Systemd => systemd(unit),
            Self::Launchd => launchd(unit),
        }
    }

    /// The commands that start it, now and whenever the person or the machine comes back.
    pub(super) fn enable(self, scope: Scope, file: &Path) -> Vec<Vec<String>> {
        match self {
            Self::Systemd => vec![
                systemctl(scope, &["daemon-reload"]),
                systemctl(scope, &["enable", "--now", "dobot"]),
            ],
            Self::Launchd => vec![launchctl("load", file)],
        }
    }

    /// The commands that stop it for good.
    pub(super) fn disable(self, scope: Scope, file: &Path) -> Vec<Vec<String>> {
        match self {
            Self::Systemd => vec![systemctl(scope, &["disable", "--now", "dobot"])],
            Self::Launchd => vec![launchctl("unload", file)],
        }
    }

    /// The command that tells whether it runs.
    pub(super) fn ask(self, scope: Scope) -> Vec<String> {
        match self {
            Self::Systemd => systemctl(scope, &["is-active", "dobot"]),
            Self::Launchd => words(&["launchctl", "list", "dobot.station"]),
        }
    }
}

/// The watchdog of a station that was killed gets the time that it needs: what ends the service asks
/// all of its processes to end, which the watchdog does when it has spoken, and kills only later.
fn systemd(unit: &Unit) -> String {
    let (folder, target) = match (unit.scope, &unit.data) {
        (_, Some(data)) => (environment(&data.display().to_string()), unit.scope),
        (Scope::System, None) => (
            format!("StateDirectory=dobot\n{}", environment("/var/lib/dobot")),
            Scope::System,
        ),
        (Scope::User, None) => (String::new(), Scope::User),
    };
    let target = match target {
        Scope::User => "default.target",
        Scope::System => "multi-user.target",
    };
    let program = unit.program.display().to_string();
    let words = [program, "up".to_owned()];
    let words = words.iter().chain(&unit.arguments).map(|it| quoted(it));
    let command = words.collect::<Vec<_>>().join(" ");
    format!(
        "# Written by `dobot service install`; `dobot service remove` takes it away.
[Unit]
Description=The station of a Dobot Arm
StartLimitIntervalSec=0

[Service]
Type=notify
ExecStart={command}
{folder}Restart=always
RestartSec=1
WatchdogSec=5
TimeoutStartSec=120
TimeoutStopSec=15
KillMode=control-group
LimitNICE=-10
ManagedOOMPreference=avoid

[Install]
WantedBy={target}
"
    )
}

fn environment(data: &str) -> String {
    format!("Environment={}\n", quoted(&format!("DOBOT_DATA={data}")))
}

/// A word as systemd reads it: specifiers and variables are meant as they stand.
fn quoted(word: &str) -> String {
    let word = word.replace('%', "%%").replace('$', "$$");
    let plain = |it: char| it.is_ascii_alphanumeric() || "-_./:=@,%+".contains(it);
    if !word.is_empty() && word.chars().all(plain) {
        return word;
    }
    let escaped = word.replace('\\', "\\\\").replace('"', "\\\"");
    format!("\"{}\"", escaped.replace('\n', "\\n"))
}

fn launchd(unit: &Unit) -> String {
    let program = unit.program.display().to_string();
    let words = [program, "up".to_owned()];
    let words = words.iter().chain(&unit.arguments);
    let words = words.map(|it| format!("    <string>{}</string>\n", escaped(it)));
    let words: String = words.collect();
    let data = unit.data.as_ref().map_or_else(String::new, |it| {
        let data = escaped(&it.display().to_string());
        format!(
            "  <key>EnvironmentVariables</key>\n  <dict>\n    <key>DOBOT_DATA</key>\n    <string>{data}</string>\n  </dict>\n"
        )
    });
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>
<!DOCTYPE plist PUBLIC \"-//Apple//DTD PLIST 1.0//EN\" \"http://www.apple.com/DTDs/PropertyList-1.0.dtd\">
<plist version=\"1.0\">
<dict>
  <key>Label</key>
  <string>dobot.station</string>
  <key>ProgramArguments</key>
  <array>
{words}  </array>
{data}  <key>RunAtLoad</key>
  <true/>
  <key>KeepAlive</key>
  <true/>
  <key>AbandonProcessGroup</key>
  <true/>
</dict>
</plist>
"
    )
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}

fn systemctl(scope: Scope, arguments: &[&str]) -> Vec<String> {
    let scope: &[&str] = match scope {
        Scope::User => &["--user"],
        Scope::System => &[],
    };
    words(&[&["systemctl"], scope, arguments].concat())
}

fn launchctl(action: &str, file: &Path) -> Vec<String> {
    words(&["launchctl", action, "-w", &file.display().to_string()])
}

fn words(words: &[&str]) -> Vec<String> {
    words.iter().map(|it| (*it).to_owned()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unit(scope: Scope) -> Unit {
        Unit {
            scope,
            program: "/opt/my tools/dobot".into(),
            arguments: ["--arm", "serial:/dev/ttyUSB0", "--name", "100% & \"<me>\""]
                .map(str::to_owned)
                .into(),
            data: None,
        }
    }

    #[test]
    fn a_word_with_a_space_or_a_percent_sign_is_one_word_for_systemd() {
        let text = ServiceManager::Systemd.text(&unit(Scope::User));
        let wanted = r#"ExecStart="/opt/my tools/dobot" up --arm serial:/dev/ttyUSB0 --name "100%% & \"<me>\"""#;
        assert!(text.contains(wanted), "{text}");
        for line in [
            "Restart=always",
            "Type=notify",
            "WatchdogSec=5",
            "KillMode=control-group",
            "LimitNICE=-10",
            "ManagedOOMPreference=avoid",
            "default.target",
        ] {
            assert!(text.contains(line), "{line} is missing: {text}");
        }
        assert!(!text.contains("DOBOT_DATA"), "{text}");
    }

    #[test]
    fn the_service_of_a_machine_has_a_folder_of_its_own() {
        let text = ServiceManager::Systemd.text(&unit(Scope::System));
        for line in [
            "StateDirectory=dobot",
            "DOBOT_DATA=/var/lib/dobot",
            "multi-user.target",
        ] {
            assert!(text.contains(line), "{line} is missing: {text}");
        }
    }

    #[test]
    fn a_word_with_angle_brackets_is_one_word_for_launchd() {
        let text = ServiceManager::Launchd.text(&unit(Scope::User));
        assert!(
            text.contains("<string>100% &amp; \"&lt;me&gt;\"</string>"),
            "{text}"
        );
        assert!(text.contains("<key>KeepAlive</key>"), "{text}");
    }
}
