//! Service files of systemd and launchd.

use std::path::{Path, PathBuf};

/// The owner of a service.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scope {
    /// The user who installs it; it runs while the user is logged in or lingers.
    User,
    /// The machine; it runs from boot on.
    System,
}

/// A service manager.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ServiceManager {
    /// systemd.
    Systemd,
    /// launchd of macOS.
    Launchd,
}

/// A service to install.
#[derive(Clone, Debug)]
pub(super) struct Unit {
    pub(super) scope: Scope,
    pub(super) program: PathBuf,
    /// The arguments of `dobot up`.
    pub(super) arguments: Vec<String>,
    /// The data folder; the default one if `None`.
    pub(super) data: Option<PathBuf>,
}

impl Scope {
    /// The folder of the service file.
    pub(super) fn folder(self, manager: ServiceManager, home: &Path) -> PathBuf {
        match (manager, self) {
            (ServiceManager::Systemd, Self::System) => "/etc/systemd/system".into(),
            (ServiceManager::Systemd, Self::User) => home.join(".config/systemd/user"),
            (ServiceManager::Launchd, Self::System) => "/Library/LaunchDaemons".into(),
            (ServiceManager::Launchd, Self::User) => home.join("Library/LaunchAgents"),
        }
    }

    /// The command line option.
    pub(super) const fn option(self) -> &'static str {
        match self {
            Self::User => "--user",
            Self::System => "--system",
        }
    }
}

impl ServiceManager {
    /// The service manager of this system.
    pub(super) const HERE: Self = if cfg!(target_os = "macos") {
        Self::Launchd
    } else {
        Self::Systemd
    };

    /// The name of the service file.
    pub(super) const fn file(self) -> &'static str {
        match self {
            Self::Systemd => "dobot.service",
            Self::Launchd => "dobot.station.plist",
        }
    }

    /// The text of the service file.
    pub(super) fn text(self, unit: &Unit) -> String {
        match self {
            Self::Systemd => systemd(unit),
            Self::Launchd => launchd(unit),
        }
    }

    /// The commands that start the service now and at each login or boot.
    pub(super) fn enable(self, scope: Scope, file: &Path) -> Vec<Vec<String>> {
        match self {
            Self::Systemd => vec![
                systemctl(scope, &["daemon-reload"]),
                systemctl(scope, &["enable", "--now", "dobot"]),
            ],
            Self::Launchd => vec![launchctl("load", file)],
        }
    }

    /// The commands that stop the service permanently.
    pub(super) fn disable(self, scope: Scope, file: &Path) -> Vec<Vec<String>> {
        match self {
            Self::Systemd => vec![systemctl(scope, &["disable", "--now", "dobot"])],
            Self::Launchd => vec![launchctl("unload", file)],
        }
    }

    /// The command that reports whether the service runs.
    pub(super) fn status_command(self, scope: Scope) -> Vec<String> {
        match self {
            Self::Systemd => systemctl(scope, &["is-active", "dobot"]),
            Self::Launchd => words(&["launchctl", "list", "dobot.station"]),
        }
    }
}

/// Returns a unit file. Stopping the service first sends a termination signal to all processes and kills
/// them only later, so that the watchdog of a killed station has enough time.
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
    let words = words.iter().chain(&unit.arguments).map(|word| quoted(word));
    let command = words.collect::<Vec<_>>().join(" ");
    format!(
        "# Written by `dobot service install`; `dobot service remove` removes it.
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

/// Quotes a word for systemd, without specifiers and variables.
fn quoted(word: &str) -> String {
    let word = word.replace('%', "%%").replace('$', "$$");
    let plain = |letter: char| letter.is_ascii_alphanumeric() || "-_./:=@,%+".contains(letter);
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
    let words = words.map(|word| format!("    <string>{}</string>\n", escaped(word)));
    let words: String = words.collect();
    let data = unit.data.as_ref().map_or_else(String::new, |data| {
        let data = escaped(&data.display().to_string());
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
    words.iter().map(|word| (*word).to_owned()).collect()
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
    fn the_service_of_a_machine_has_its_own_folder() {
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
