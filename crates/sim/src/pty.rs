//! A virtual serial port: any program that speaks serial can open it.

use std::fs::OpenOptions;
use std::io;
use std::os::fd::{AsFd, OwnedFd};
use std::os::unix::ffi::OsStringExt;
use std::os::unix::fs::{OpenOptionsExt, symlink};
use std::path::{Path, PathBuf};

use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::fs::OFlags;
use rustix::io::{Errno, ioctl_fionbio};
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{OptionalActions, speed, tcgetattr, tcsetattr};
use tokio::io::unix::AsyncFd;

/// A pseudo-terminal: this program holds one end, a client opens the other as its serial port.
#[derive(Debug)]
pub struct Pty {
    master: AsyncFd<OwnedFd>,
    path: PathBuf,
    link: Option<PathBuf>,
}

impl Pty {
    /// Makes a virtual serial port, and a symbolic link to it where one is asked for.
    ///
    /// # Errors
    ///
    /// What the operating system says; a file that is in the way of the link is left alone, unless
    /// it is a dangling link of the same kind.
    pub fn open(link: Option<&Path>) -> io::Result<Self> {
        let master = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY)?;
        grantpt(&master)?;
        unlockpt(&master)?;
        ioctl_fionbio(&master, true)?;
        let name = ptsname(&master, Vec::new())?;
        let path = PathBuf::from(std::ffi::OsString::from_vec(name.into_bytes()));
        make_raw(&path)?;
        if let Some(link) = link {
            if link.is_symlink() && !link.exists() {
                std::fs::remove_file(link)?;
            }
            symlink(&path, link)?;
        }
        #[expect(
            deprecated,
            reason = "its successor is unsafe; an `OwnedFd` keeps its descriptor, which is all that is asked"
        )]
        let master = AsyncFd::new(master)?;
        Ok(Self {
            master,
            path,
            link: link.map(Path::to_owned),
        })
    }

    /// The name by which a client opens it.
    #[must_use]
    pub fn path(&self) -> &Path {
        self.link.as_deref().unwrap_or(&self.path)
    }

    /// Whether a client has it open.
    #[must_use]
    pub fn is_open(&self) -> bool {
        let fd = self.master.get_ref().as_fd();
        let mut fds = [PollFd::from_borrowed_fd(fd, PollFlags::OUT)];
        let now = Timespec {
            tv_sec: 0,
            tv_nsec: 0,
        };
        poll(&mut fds, Some(&now)).is_ok() && !fds[0].revents().contains(PollFlags::HUP)
    }

    /// Waits for bytes from the client; none means that it closed the port. Safe to cancel.
    ///
    /// # Errors
    ///
    /// What the operating system says.
    pub async fn read(&self, buffer: &mut [u8]) -> io::Result<usize> {
        loop {
            let mut guard = self.master.readable().await?;
            match guard.try_io(|fd| Ok(rustix::io::read(fd.get_ref(), &mut *buffer)?)) {
                Ok(Err(error)) if error.raw_os_error() == Some(Errno::IO.raw_os_error()) => {
                    guard.clear_ready();
                    return Ok(0);
                }
                Ok(result) => return result,
                Err(_would_block) => {}
            }
        }
    }

    /// Writes what fits; the rest is lost, as on a serial line that nobody listens to.
    pub fn write(&self, bytes: &[u8]) {
        let _ = rustix::io::write(self.master.get_ref(), bytes);
    }
}

impl Drop for Pty {
    fn drop(&mut self) {
        if let Some(link) = &self.link {
            let _ = std::fs::remove_file(link);
        }
    }
}

/// No echo, no line ends, all byte values: a client that sets nothing gets a plain byte stream.
fn make_raw(path: &Path) -> io::Result<()> {
    let flags = OFlags::NOCTTY.bits().cast_signed();
    let client_end = OpenOptions::new()
        .read(true)
        .write(true)
        .custom_flags(flags)
        .open(path)?;
    let mut settings = tcgetattr(&client_end)?;
    settings.make_raw();
    settings.set_speed(speed::B9600)?;
    tcsetattr(&client_end, OptionalActions::Now, &settings)?;
    Ok(())
}
