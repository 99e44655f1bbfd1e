//! Opening of serial ports and TCP connections, with hints on failure.

use std::io;
use std::time::Duration;

use tokio::net::TcpStream;
use tokio_serial::{ClearBuffer, SerialPort, SerialPortBuilderExt, SerialStream};

/// The error returned when a link cannot be opened.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum OpenError {
    /// The serial port does not exist.
    #[error("there is no serial port {path}")]
    NoSuchPort {
        /// The port.
        path: String,
    },
    /// The operating system does not let this user open the port.
    #[error("this user may not open {path}")]
    NotAllowed {
        /// The port.
        path: String,
        /// The group whose members may open the port.
        group: Option<String>,
    },
    /// Another program uses the port.
    #[error("{path} is in use by another program")]
    InUse {
        /// The port.
        path: String,
    },
    /// The file is not a serial port.
    #[error("{path} is not a serial port")]
    NotASerialPort {
        /// The file.
        path: String,
    },
    /// Any other error of a serial port.
    #[error("cannot open {path}")]
    Serial {
        /// The port.
        path: String,
        /// The error of the operating system.
        #[source]
        source: io::Error,
    },
    /// The TCP connection failed.
    #[error("cannot connect to {host}:{port}")]
    Tcp {
        /// The host.
        host: String,
        /// The port.
        port: u16,
        /// The error of the operating system.
        #[source]
        source: io::Error,
    },
    /// This crate cannot open a virtual arm; it is connected as a [`Peer`](crate::Peer).
    #[error("address virtual: cannot be opened as a port; a virtual arm runs in this process")]
    Virtual,
    /// The async runtime of the blocking API cannot be started.
    #[error("cannot start the async runtime")]
    Runtime(#[source] io::Error),
}

impl OpenError {
    /// A hint for the user.
    #[must_use]
    pub fn hint(&self) -> Option<String> {
        match self {
            Self::NoSuchPort { .. } => {
                Some("check that the arm is plugged in and switched on; `dobot ports` lists the serial ports of this machine".into())
            }
            Self::NotAllowed { group: Some(group), .. } => Some(format!(
                "run `sudo usermod -aG {group} $USER`, then log out and in again"
            )),
            Self::NotAllowed { group: None, path } => Some(format!(
                "add a udev rule: put SUBSYSTEM==\"tty\", MODE=\"0660\", TAG+=\"uaccess\" into /etc/udev/rules.d/70-dobot.rules, run `sudo udevadm control --reload`, and plug {path} in again"
            )),
            Self::InUse { path } => Some(format!(
                "run `fuser -v {path}` to find the program that uses it, and close that program"
            )),
            Self::NotASerialPort { .. } => Some("`dobot ports` lists the serial ports of this machine".into()),
            Self::Serial { .. } | Self::Virtual | Self::Runtime(_) => None,
            Self::Tcp { source, port, .. } if source.kind() == io::ErrorKind::ConnectionRefused => Some(format!(
                "no server listens there; `dobot arm --tcp 127.0.0.1:{port}` starts a virtual arm"
            )),
            Self::Tcp { .. } => Some("check the host name and the network".into()),
        }
    }
}

/// Opens a serial port, 8N1, for this program alone.
///
/// A stock arm is reset when its DTR line rises. Linux always raises it on the first opening; this
/// function keeps it up when the port is closed, so that the next opening does not reset the arm
/// again. Other systems leave DTR as it is.
///
/// Bytes received earlier are discarded: they are not a permit, and their pose is old.
///
/// Returns the port twice: as a stream, and as a file to pass to another process.
#[cfg(unix)]
pub(crate) fn serial(path: &str, baud: u32) -> Result<(SerialStream, std::fs::File), OpenError> {
    let port = keep_dtr_up(path)?;
    Ok((stream(path, baud)?, port))
}

/// Opens a serial port, 8N1, for this program alone. DTR is left as it is.
///
/// Bytes received earlier are discarded: they are not a permit, and their pose is old.
#[cfg(not(unix))]
pub(crate) fn serial(path: &str, baud: u32) -> Result<SerialStream, OpenError> {
    stream(path, baud)
}

fn stream(path: &str, baud: u32) -> Result<SerialStream, OpenError> {
    let stream = tokio_serial::new(path, baud)
        .preserve_dtr_on_open()
        .open_native_async()
        .map_err(|error| serial_error(path, error.into()))?;
    stream
        .clear(ClearBuffer::Input)
        .map_err(|error| serial_error(path, error.into()))?;
    Ok(stream)
}

pub(crate) async fn tcp(host: &str, port: u16) -> Result<TcpStream, OpenError> {
    let connecting = async {
        let stream = TcpStream::connect((host, port)).await?;
        stream.set_nodelay(true)?;
        Ok(stream)
    };
    tokio::time::timeout(CONNECT_TIMEOUT, connecting)
        .await
        .unwrap_or_else(|_| Err(io::ErrorKind::TimedOut.into()))
        .map_err(|source| OpenError::Tcp {
            host: host.to_owned(),
            port,
            source,
        })
}

/// Clears "hang up on close". The returned file keeps the line up until the port itself is open.
#[cfg(unix)]
fn keep_dtr_up(path: &str) -> Result<std::fs::File, OpenError> {
    use std::os::unix::fs::OpenOptionsExt;

    use rustix::fs::OFlags;
    use rustix::termios::{ControlModes, OptionalActions, tcgetattr, tcsetattr};

    let flags = OFlags::NOCTTY | OFlags::NONBLOCK;
    let file = std::fs::OpenOptions::new()
        .read(true)
        .write(true)
        .custom_flags(flags.bits().cast_signed())
        .open(path)
        .map_err(|error| serial_error(path, error))?;
    let result = tcgetattr(&file).and_then(|mut settings| {
        settings.control_modes -= ControlModes::HUPCL;
        settings.control_modes |= ControlModes::CLOCAL;
        tcsetattr(&file, OptionalActions::Now, &settings)
    });
    match result {
        Ok(()) => Ok(file),
        Err(error) => Err(serial_error(path, error.into())),
    }
}

fn serial_error(path: &str, source: io::Error) -> OpenError {
    let path = path.to_owned();
    match source.kind() {
        // The serial crate reports a port locked by another program as missing, with this text.
        _ if source.to_string().contains("lock on serial port") => OpenError::InUse { path },
        io::ErrorKind::NotFound => OpenError::NoSuchPort { path },
        io::ErrorKind::PermissionDenied => OpenError::NotAllowed {
            group: group(&path),
            path,
        },
        io::ErrorKind::ResourceBusy => OpenError::InUse { path },
        io::ErrorKind::IsADirectory => OpenError::NotASerialPort { path },
        _ if is_not_a_terminal(&source) => OpenError::NotASerialPort { path },
        _ => OpenError::Serial { path, source },
    }
}

#[cfg(unix)]
fn is_not_a_terminal(error: &io::Error) -> bool {
    error.raw_os_error() == Some(rustix::io::Errno::NOTTY.raw_os_error())
}

#[cfg(not(unix))]
fn is_not_a_terminal(_error: &io::Error) -> bool {
    false
}

/// Returns whether this user may open a serial port, without opening it, so that no arm is reset.
///
/// # Errors
///
/// [`OpenError`] if the port is missing or the user has no permission.
#[cfg(unix)]
pub fn check_permission(path: &str) -> Result<(), OpenError> {
    use rustix::fs::Access;

    rustix::fs::access(path, Access::READ_OK | Access::WRITE_OK)
        .map_err(|error| serial_error(path, error.into()))
}

/// The group that owns a port, if its members may use it.
#[cfg(unix)]
fn group(path: &str) -> Option<String> {
    use std::os::unix::fs::MetadataExt;

    let metadata = std::fs::metadata(path).ok()?;
    if metadata.mode() & 0o060 != 0o060 {
        return None;
    }
    let groups = std::fs::read_to_string("/etc/group").ok()?;
    groups
        .lines()
        .map(|line| line.split(':').collect::<Vec<_>>())
        .find(|fields| fields.get(2).and_then(|gid| gid.parse().ok()) == Some(metadata.gid()))
        .and_then(|fields| fields.first().map(|&name| name.to_owned()))
        .filter(|name| name != "root")
}

#[cfg(not(unix))]
fn group(_path: &str) -> Option<String> {
    None
}

/// Long enough for any reachable host.
const CONNECT_TIMEOUT: Duration = Duration::from_secs(5);

#[cfg(test)]
mod tests {
    use super::*;

    fn not_allowed(group: Option<&str>) -> OpenError {
        OpenError::NotAllowed {
            path: "/dev/ttyUSB0".into(),
            group: group.map(str::to_owned),
        }
    }

    #[test]
    fn a_port_without_permission_suggests_its_group() {
        let error = not_allowed(Some("dialout"));
        assert_eq!(error.to_string(), "this user may not open /dev/ttyUSB0");
        let hint = error.hint().expect("there is a hint");
        assert!(hint.contains("usermod -aG dialout"), "{hint}");
    }

    #[cfg(unix)]
    #[test]
    fn permission_is_checked_without_opening_the_port() {
        let missing = check_permission("/dev/no-such-port");
        assert!(
            matches!(missing, Err(OpenError::NoSuchPort { .. })),
            "{missing:?}"
        );
        assert!(check_permission("/dev/null").is_ok());
    }

    #[test]
    fn a_port_without_a_group_suggests_a_udev_rule() {
        let hint = not_allowed(None).hint().expect("there is a hint");
        assert!(hint.contains("/etc/udev/rules.d/"), "{hint}");
    }

    #[test]
    fn system_errors_become_errors_with_a_hint() {
        use io::ErrorKind as Kind;
        let converted = |kind: Kind| serial_error("/dev/ttyUSB9", kind.into());
        assert!(matches!(
            converted(Kind::NotFound),
            OpenError::NoSuchPort { .. }
        ));
        assert!(matches!(
            converted(Kind::PermissionDenied),
            OpenError::NotAllowed { .. }
        ));
        assert!(matches!(
            converted(Kind::ResourceBusy),
            OpenError::InUse { .. }
        ));
        assert!(matches!(
            converted(Kind::TimedOut),
            OpenError::Serial { .. }
        ));
    }

    /// A pseudo-terminal: its master and the name of its slave.
    #[cfg(unix)]
    fn pty() -> (std::os::fd::OwnedFd, String) {
        use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};

        let master = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).expect("a port is free");
        grantpt(&master).expect("it is ours");
        unlockpt(&master).expect("it is ours");
        let name = ptsname(&master, Vec::new()).expect("it has one");
        (master, name.into_string().expect("the name is text"))
    }

    #[cfg(unix)]
    #[test]
    fn a_port_that_another_program_has_locked_is_in_use() {
        let (_master, path) = pty();
        let open = || tokio_serial::new(&path, 9600).open_native();
        let _first = open().expect("it is free");
        // The superuser fails at the lock, other users before it.
        let error = open().expect_err("it is in use");
        let error = serial_error(&path, error.into());
        assert!(matches!(error, OpenError::InUse { .. }), "{error:?}");
    }

    #[cfg(unix)]
    #[test]
    fn closing_a_port_will_not_lower_its_dtr_line() {
        use rustix::termios::{ControlModes, tcgetattr};

        let (_master, path) = pty();
        let port = keep_dtr_up(&path).expect("it opens");
        let modes = tcgetattr(&port).expect("it is a terminal").control_modes;
        assert!(!modes.contains(ControlModes::HUPCL));
        assert!(modes.contains(ControlModes::CLOCAL));
    }
}
