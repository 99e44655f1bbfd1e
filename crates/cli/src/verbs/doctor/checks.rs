//! The checks, in the order of the report.

use std::fs;
use std::net::{SocketAddr, TcpListener};
use std::path::Path;

use dobot_api::{Folders, LinkPhase, Remote, State, StationAddress, StationEvent, running};
use dobot_host::{DataFormat, is_chip_of_arms};
use dobot_record::recordings;
use dobot_session::{Port, Usb};
use dobot_station::{DEFAULT_HTTP, DEFAULT_RAW, Tokens};
use jiff::Timestamp;

use super::report::Finding;
use crate::output;
use crate::reach::client_name;

pub(super) async fn all(folders: &Folders) -> Vec<Finding> {
    let ports = dobot_session::ports();
    let mut found = vec![port_list(&ports)];
    let ports = ports.unwrap_or_default();
    #[cfg(unix)]
    found.extend(ports.iter().map(permission));
    #[cfg(target_os = "linux")]
    found.extend(udev(&ports));
    found.push(clock(Timestamp::now()));
    #[cfg(unix)]
    found.push(disk(folders));
    #[cfg(target_os = "linux")]
    found.push(browser());
    found.extend(station(folders).await);
    found.push(recorded(folders));
    found.push(certificate(&folders.tls()));
    found.push(tokens(folders));
    found.push(data(folders));
    found
}

fn port_list(ports: &std::io::Result<Vec<Port>>) -> Finding {
    match ports {
        Err(error) => Finding::bad("ports", format!("cannot be listed: {error}"), PLUG),
        Ok(ports) if ports.is_empty() => Finding::note("ports", "no serial port", PLUG),
        Ok(ports) => {
            let names = ports.iter().map(|port| match &port.usb {
                Some(usb) if is_chip_of_arms(usb) => {
                    format!("{} ({}, a chip of arms)", port.path, ids(usb))
                }
                Some(usb) => format!("{} ({})", port.path, ids(usb)),
                None => port.path.clone(),
            });
            Finding::ok("ports", names.collect::<Vec<_>>().join(", "))
        }
    }
}

fn ids(usb: &Usb) -> String {
    format!("USB {:04x}:{:04x}", usb.vendor, usb.product)
}

#[cfg(unix)]
fn permission(port: &Port) -> Finding {
    match dobot_session::check_permission(&port.path) {
        Ok(()) => Finding::ok("permission", format!("{} may be opened", port.path)),
        // Ports without USB belong to the machine; no arm is there.
        Err(error) if port.usb.is_none() => Finding::note(
            "permission",
            error.to_string(),
            "needed only for an arm at this port",
        ),
        Err(error) => Finding::bad(
            "permission",
            error.to_string(),
            error.hint().unwrap_or_default(),
        ),
    }
}

/// The rule that lets the person at this computer open an arm's port, and programs that take such ports.
#[cfg(target_os = "linux")]
fn udev(ports: &[Port]) -> Vec<Finding> {
    let plugged_in = ports
        .iter()
        .any(|port| port.usb.as_ref().is_some_and(is_chip_of_arms));
    let ruled = RULE_FOLDERS
        .iter()
        .any(|folder| Path::new(folder).join("60-dobot.rules").exists());
    let rule = if ruled {
        Finding::ok("udev", "the rule for the ports of arms is installed")
    } else {
        Finding::note(
            "udev",
            "no rule for the ports of arms: users need the group of the port, and ModemManager may write to an arm",
            "run `sudo cp 60-dobot.rules /etc/udev/rules.d/` in the folder of the archive, then plug the arm in again",
        )
    };
    let mut found = vec![rule];
    if !plugged_in && Path::new("/usr/bin/brltty").exists() {
        found.push(Finding::note(
            "udev",
            "brltty is installed; on some systems it takes the port of an arm with the chip 1a86:7523",
            "if the port is missing, run `sudo apt-get remove brltty`",
        ));
    }
    found
}

fn clock(now: Timestamp) -> Finding {
    let text = format!("{now:.0}");
    if now < RELEASED.parse().expect("it is a date") {
        Finding::bad(
            "clock",
            format!("{text}: before this version was made"),
            "set it: `sudo timedatectl set-ntp true`",
        )
    } else {
        Finding::ok("clock", text)
    }
}

/// Room for the data and permission to write it.
#[cfg(unix)]
fn disk(folders: &Folders) -> Finding {
    use rustix::fs::{Access, access, statvfs};

    let mut existing = folders.data().ancestors();
    let folder = existing
        .find(|folder| folder.exists())
        .unwrap_or(Path::new("/"));
    if access(folder, Access::WRITE_OK).is_err() {
        return Finding::bad(
            "disk",
            format!("{} cannot be written", folder.display()),
            "give it to this user, or use another folder: `--data FOLDER`",
        );
    }
    let free = match statvfs(folder) {
        Ok(disk) => disk.f_bavail.saturating_mul(disk.f_frsize) / 1_000_000,
        Err(error) => {
            return Finding::bad(
                "disk",
                error.to_string(),
                "use another folder: `--data FOLDER`",
            );
        }
    };
    let text = format!("{free} MB free for {}", folders.data().display());
    match free {
        0..100 => Finding::bad("disk", text, "make room; jobs and recordings need 100 MB"),
        100..1000 => Finding::note("disk", text, "an hour of recording needs about 20 MB"),
        _ => Finding::ok("disk", text),
    }
}

/// The browser for the page.
#[cfg(target_os = "linux")]
fn browser() -> Finding {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let mut folders = std::env::split_paths(&path);
    let browser = folders.find_map(|folder| {
        BROWSERS
            .into_iter()
            .find(|name| folder.join(name).is_file())
    });
    match browser {
        Some(name) => Finding::ok("browser", name),
        None => Finding::note(
            "browser",
            "none was found",
            "install one, or open the page from another computer: docs/security.md says how",
        ),
    }
}

/// The running station, or whether one could be started.
async fn station(folders: &Folders) -> Vec<Finding> {
    let address = match running(folders) {
        Ok(Some(address)) => address,
        Ok(None) => return vec![free_addresses()],
        Err(error) => {
            return vec![Finding::bad(
                "station",
                error.to_string(),
                "remove that file",
            )];
        }
    };
    match greeting(&address).await {
        Ok((version, state)) => vec![link(&state), versions(&version)],
        Err(error) => vec![Finding::bad(
            "station",
            format!("it was started and does not respond: {error}"),
            "start it again: `dobot`",
        )],
    }
}

/// The version of a running station and its state.
async fn greeting(address: &StationAddress) -> anyhow::Result<(String, State)> {
    let mut station = Remote::connect(address, &client_name("doctor")).await?;
    let version = station.hello().version.clone();
    loop {
        if let StationEvent::State(state) = station.next().await? {
            return Ok((version, *state));
        }
    }
}

/// A station that was started before an update still runs the old program.
fn versions(station: &str) -> Finding {
    let program = env!("CARGO_PKG_VERSION");
    if station == program {
        Finding::ok("versions", format!("station and program are {program}"))
    } else {
        Finding::bad(
            "versions",
            format!("the station is {station}, this program {program}"),
            "end the station when the arm is at rest, and start it again: `dobot`",
        )
    }
}

/// What a running station says of its arm.
fn link(state: &State) -> Finding {
    let kind = match state.link.address.as_deref() {
        None => "no arm",
        Some(address) => address.split(':').next().unwrap_or_default(),
    };
    let dialect = state.dialect.map_or_else(
        || "dialect unknown".to_owned(),
        |dialect| format!("dialect {dialect}"),
    );
    let text = format!(
        "running; {kind}, {dialect}; {:.1} statuses a second, {} lost, {} damaged bytes",
        state.link.statuses_per_s, state.link.lost_statuses, state.link.damaged_bytes
    );
    match (&state.link.problem, state.link.phase) {
        (Some(problem), _) => Finding::bad(
            "station",
            format!("{text}; {problem}"),
            state.link.remedy.clone().unwrap_or_default(),
        ),
        (None, LinkPhase::Up) if state.dialect.is_none() => {
            Finding::note("station", text, "run `dobot detect`")
        }
        (None, _) => Finding::ok("station", text),
    }
}

/// Whether a station could be started.
fn free_addresses() -> Finding {
    let taken = |address: &SocketAddr| TcpListener::bind(address).is_err();
    match [DEFAULT_HTTP, DEFAULT_RAW].into_iter().find(taken) {
        None => Finding::ok("station", "none is running"),
        Some(address) => Finding::note(
            "station",
            format!("none is running, and another program uses {address}"),
            "end that program, or use `dobot up --http 127.0.0.1:0 --raw 127.0.0.1:0`",
        ),
    }
}

fn recorded(folders: &Folders) -> Finding {
    match recordings(&folders.recordings()) {
        Ok(files) => {
            let bytes: u64 = files.iter().map(|file| file.bytes).sum();
            let text = output::count(files.len(), "file");
            Finding::ok("recordings", format!("{text}, {} MB", bytes / 1_000_000))
        }
        Err(error) => Finding::bad(
            "recordings",
            format!("cannot be read: {error}"),
            "give the folder DATA/recordings to this user",
        ),
    }
}

/// The station's own certificate, which is made when it first serves a network.
fn certificate(folder: &Path) -> Finding {
    let key = folder.join("key.pem");
    match (folder.join("certificate.pem").exists(), fs::metadata(&key)) {
        (false, Err(_)) => Finding::ok("certificate", "none yet; made for `--http` on a network"),
        (true, Ok(_)) if is_open(&key) => Finding::bad(
            "certificate",
            "others can read its key",
            "remove the folder DATA/tls and start the station; clients need the new fingerprint",
        ),
        (true, Ok(_)) => Finding::ok("certificate", "present, its key is private"),
        _ => Finding::bad(
            "certificate",
            "either the certificate or its key is missing",
            "remove the folder DATA/tls; the next start makes both",
        ),
    }
}

#[cfg(unix)]
fn is_open(file: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;

    fs::metadata(file).is_ok_and(|metadata| metadata.mode() & 0o077 != 0)
}

#[cfg(not(unix))]
fn is_open(_file: &Path) -> bool {
    false
}

fn tokens(folders: &Folders) -> Finding {
    match Tokens::open(&folders.tokens()) {
        Ok(tokens) => Finding::ok("tokens", output::count(tokens.list().count(), "token")),
        Err(error) => Finding::bad("tokens", error.to_string(), "restore a copy of the file"),
    }
}

fn data(folders: &Folders) -> Finding {
    match DataFormat::of(folders) {
        Ok(None) => Finding::ok("data", "none yet"),
        Ok(Some(format)) => {
            let text = format!("format {}, made by {}", format.format, format.program);
            Finding::ok("data", text)
        }
        Err(error) => Finding::bad(
            "data",
            error.to_string(),
            "the station does not start with it",
        ),
    }
}

const PLUG: &str =
    "to use a real arm, plug it in and switch it on; without one `dobot` uses a virtual arm";

/// The clock of a machine without a battery starts before.
const RELEASED: &str = "2026-11-01T00:00:00Z";

#[cfg(target_os = "linux")]
const RULE_FOLDERS: [&str; 3] = [
    "/etc/udev/rules.d",
    "/usr/lib/udev/rules.d",
    "/lib/udev/rules.d",
];

#[cfg(target_os = "linux")]
const BROWSERS: [&str; 7] = [
    "xdg-open",
    "firefox",
    "firefox-esr",
    "chromium",
    "chromium-browser",
    "google-chrome",
    "epiphany-browser",
];

#[cfg(test)]
mod tests {
    use super::super::report::Health;
    use super::*;

    fn port(usb: Option<(u16, u16)>) -> Port {
        Port {
            path: "/dev/ttyUSB0".into(),
            device: None,
            usb: usb.map(|(vendor, product)| Usb {
                vendor,
                product,
                serial: Some("A50285BI".into()),
            }),
        }
    }

    #[test]
    fn the_chip_of_an_arm_is_recognised_and_its_serial_number_is_not_shown() {
        let found = port_list(&Ok(vec![port(Some((0x0403, 0x6001)))]));
        assert_eq!(found.text, "/dev/ttyUSB0 (USB 0403:6001, a chip of arms)");
    }

    #[test]
    fn a_clock_before_the_release_is_wrong() {
        let start = clock(Timestamp::UNIX_EPOCH);
        assert_eq!(start.health, Health::Bad);
        let later = "2027-02-03T04:05:06.7Z".parse().expect("it is a time");
        assert_eq!(clock(later), Finding::ok("clock", "2027-02-03T04:05:06Z"));
    }

    #[test]
    fn a_station_of_another_version_has_to_be_started_again() {
        assert_eq!(versions(env!("CARGO_PKG_VERSION")).health, Health::Ok);
        let found = versions("0.0.9");
        assert_eq!(found.health, Health::Bad);
        assert!(found.text.contains("0.0.9"), "{}", found.text);
    }

    #[test]
    fn an_arm_whose_dialect_is_unknown_needs_a_detection() {
        let mut state = State::sample();
        assert_eq!(link(&state).health, Health::Ok);
        state.dialect = None;
        let found = link(&state);
        assert!(
            found
                .remedy
                .is_some_and(|remedy| remedy.contains("dobot detect"))
        );
        state.link.problem = Some("the cable is unplugged".into());
        assert_eq!(link(&state).health, Health::Bad);
        assert!(!link(&state).text.contains("ttyUSB0"), "{state:?}");
    }
}
