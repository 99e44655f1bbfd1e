//! A virtual serial port that any serial program can open.

mod client;

use std::ffi::OsString;
use std::fs::{File, OpenOptions};
use std::io;
use std::os::fd::{AsFd, OwnedFd};
use std::os::unix::ffi::OsStringExt;
use std::os::unix::fs::{OpenOptionsExt, symlink};
use std::path::{Path, PathBuf};

use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::fs::OFlags;
use rustix::io::{ioctl_fionbio, retry_on_intr};
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{OptionalActions, QueueSelector, speed, tcflush, tcgetattr, tcsetattr};
use tokio::io::unix::AsyncFd;

pub use client::PtyClient;

/// A pseudo-terminal: this program holds one end, a client opens the other as its serial port.
///
/// It starts as a raw byte stream: no echo, no line processing.
#[derive(Debug)]
pub struct Pty {
    master: OwnedFd,
    path: PathBuf,
    link: Option<PathBuf>,
}

impl Pty {
    /// Creates a virtual serial port and, if requested, a symbolic link to it.
    ///
    /// # Errors
    ///
    /// Returns the error of the operating system. An existing file is not replaced by the link, unless
    /// it is a broken link.
    pub fn open(link: Option<&Path>) -> io::Result<Self> {
        // Before the new port is made: it may get the very name that an old link leads to.
        if let Some(link) = link
            && link.is_symlink()
            && !link.exists()
        {
            std::fs::remove_file(link)?;
        }
        let (master, path) = pair()?;
        if let Some(link) = link {
            symlink(&path, link)?;
        }
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

    /// The client: it has the port open, or closed it with bytes still to be read.
    ///
    /// The system does not report the opening: poll this function.
    ///
    /// # Errors
    ///
    /// Returns the error of the operating system.
    ///
    /// # Panics
    ///
    /// If called outside of a tokio runtime.
    pub fn client(&self) -> io::Result<Option<PtyClient>> {
        let flags = self.flags()?;
        if flags.contains(PollFlags::HUP) && !flags.contains(PollFlags::IN) {
            return Ok(None);
        }
        // Each client gets a registration of its own: one that has seen a client leave says so
        // for ever after.
        #[expect(
            deprecated,
            reason = "its successor is unsafe; an `OwnedFd` keeps its descriptor, which is all that is asked"
        )]
        let master = AsyncFd::new(self.master.try_clone()?)?;
        Ok(Some(PtyClient::new(master)))
    }

    /// Discards the bytes of a client that does not have the arm.
    pub(crate) fn ignore_client(&self) {
        let _ = rustix::io::read(&self.master, &mut [0; 4096]);
    }

    /// Resets the port for the next client and discards unread bytes.
    ///
    /// A killed client can leave the port locked permanently; it is then replaced by a new port, whose
    /// name is returned.
    ///
    /// # Errors
    ///
    /// Returns the error of the operating system.
    pub fn renew(&mut self) -> io::Result<Option<&Path>> {
        match client_end(&self.path) {
            Ok(end) => {
                tcflush(end, QueueSelector::IFlush)?;
                Ok(None)
            }
            // By now the lock may be that of the next client.
            Err(error) if error.kind() == io::ErrorKind::ResourceBusy && !self.is_open()? => {
                self.replace()?;
                Ok(Some(self.path()))
            }
            Err(error) if error.kind() == io::ErrorKind::ResourceBusy => Ok(None),
            Err(error) => Err(error),
        }
    }

    /// Replaces the port; a client that has it open reads end of file.
    pub(crate) fn replace(&mut self) -> io::Result<()> {
        let (master, path) = pair()?;
        if let Some(link) = self.link.as_ref().filter(|link| leads(link, &self.path)) {
            std::fs::remove_file(link)?;
            symlink(&path, link)?;
        }
        self.master = master;
        self.path = path;
        Ok(())
    }

    fn is_open(&self) -> io::Result<bool> {
        Ok(!self.flags()?.contains(PollFlags::HUP))
    }

    fn flags(&self) -> io::Result<PollFlags> {
        let fd = self.master.as_fd();
        let mut fds = [PollFd::from_borrowed_fd(fd, PollFlags::IN)];
        let now = Timespec {
            tv_sec: 0,
            tv_nsec: 0,
        };
        retry_on_intr(|| poll(&mut fds, Some(&now)))?;
        Ok(fds[0].revents())
    }
}

impl Drop for Pty {
    fn drop(&mut self) {
        if let Some(link) = self.link.as_ref().filter(|link| leads(link, &self.path)) {
            let _ = std::fs::remove_file(link);
        }
    }
}

/// The master of a new virtual serial port and the name of its slave.
fn pair() -> io::Result<(OwnedFd, PathBuf)> {
    let master = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY)?;
    grantpt(&master)?;
    unlockpt(&master)?;
    ioctl_fionbio(&master, true)?;
    let name = ptsname(&master, Vec::new())?;
    let path = PathBuf::from(OsString::from_vec(name.into_bytes()));
    make_raw(&client_end(&path)?)?;
    Ok((master, path))
}

fn client_end(path: &Path) -> io::Result<File> {
    let flags = OFlags::NOCTTY | OFlags::NONBLOCK;
    OpenOptions::new()
        .read(true)
        .write(true)
        .custom_flags(flags.bits().cast_signed())
        .open(path)
}

/// Sets raw mode: no echo, no line processing.
fn make_raw(client_end: &File) -> io::Result<()> {
    let mut settings = tcgetattr(client_end)?;
    settings.make_raw();
    settings.set_speed(speed::B9600)?;
    tcsetattr(client_end, OptionalActions::Now, &settings)?;
    Ok(())
}

/// Whether a symbolic link still points to the port; it may have been replaced.
fn leads(link: &Path, path: &Path) -> bool {
    std::fs::read_link(link).is_ok_and(|target| target == path)
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use std::io::{Read, Write};
    use std::pin::pin;
    use std::sync::Arc;
    use std::sync::atomic::{AtomicBool, Ordering};
    use std::task::{Context, Wake, Waker};

    use rustix::io::Errno;
    use rustix::termios::ioctl_tiocexcl;
    use tokio::io::AsyncReadExt as _;
    use tokio_serial::{ClearBuffer, SerialPort, SerialPortBuilderExt};

    use super::*;

    /// Remembers that it was woken.
    #[derive(Default)]
    struct Woken(AtomicBool);

    impl Wake for Woken {
        fn wake(self: Arc<Self>) {
            self.0.store(true, Ordering::Relaxed);
        }
    }

    /// What a plain serial program does: 9600 baud, 8N1.
    fn open(pty: &Pty) -> tokio_serial::SerialStream {
        let path = pty.path().to_str().unwrap();
        tokio_serial::new(path, 9600).open_native_async().unwrap()
    }

    async fn read(client: &mut PtyClient, count: usize) -> Vec<u8> {
        let mut bytes = Vec::new();
        while bytes.len() < count {
            let mut some = [0; 64];
            let len = client.read(&mut some).await.unwrap();
            assert!(len > 0, "it left after {bytes:?}");
            bytes.extend_from_slice(&some[..len]);
        }
        bytes
    }

    #[tokio::test]
    async fn all_byte_values_pass_both_ways_unchanged() {
        use tokio::io::{AsyncReadExt, AsyncWriteExt};

        let pty = Pty::open(None).unwrap();
        let mut program = open(&pty);
        let mut client = pty.client().unwrap().unwrap();
        let all: Vec<u8> = (0..=255).collect();
        client.try_write(&all);
        let mut received = vec![0; 256];
        AsyncReadExt::read_exact(&mut program, &mut received)
            .await
            .unwrap();
        assert_eq!(received, all);
        AsyncWriteExt::write_all(&mut program, &all).await.unwrap();
        assert_eq!(read(&mut client, 256).await, all);
    }

    #[tokio::test]
    async fn a_program_that_sets_nothing_gets_a_plain_byte_stream() {
        let pty = Pty::open(None).unwrap();
        let mut program = client_end(pty.path()).unwrap();
        let mut client = pty.client().unwrap().unwrap();
        let all: Vec<u8> = (0..=255).collect();
        program.write_all(&all).unwrap();
        assert_eq!(read(&mut client, 256).await, all);
        client.try_write(&all);
        let mut received = Vec::new();
        while received.len() < 256 {
            let mut some = [0; 256];
            let len = program.read(&mut some).unwrap_or_default();
            received.extend_from_slice(&some[..len]);
            tokio::task::yield_now().await;
        }
        assert_eq!(received, all);
        let echo = rustix::io::read(&pty.master, &mut [0; 256]);
        assert_eq!(echo, Err(Errno::RETRY_DELAY));
    }

    #[tokio::test]
    async fn nobody_is_there_until_the_port_is_opened_and_after_it_was_closed() {
        let pty = Pty::open(None).unwrap();
        assert!(pty.client().unwrap().is_none());
        for _ in 0..3 {
            let program = open(&pty);
            let mut client = pty.client().unwrap().unwrap();
            drop(program);
            assert_eq!(client.read(&mut [0; 64]).await.unwrap(), 0);
            assert!(pty.client().unwrap().is_none());
        }
    }

    #[tokio::test]
    async fn what_a_program_wrote_before_it_left_is_still_read() {
        let pty = Pty::open(None).unwrap();
        client_end(pty.path()).unwrap().write_all(&[7; 42]).unwrap();
        let mut client = pty.client().unwrap().unwrap();
        assert_eq!(read(&mut client, 42).await, [7; 42]);
        assert_eq!(client.read(&mut [0; 64]).await.unwrap(), 0);
    }

    #[tokio::test]
    async fn a_wait_for_bytes_sleeps_although_a_client_left_before() {
        let pty = Pty::open(None).unwrap();
        drop(open(&pty));
        let _program = open(&pty);
        let mut client = pty.client().unwrap().unwrap();
        // One poll finds nothing and does not spin: a spinning one wakes itself at once.
        let woken = Arc::new(Woken::default());
        let waker = Waker::from(Arc::clone(&woken));
        let mut some = [0; 64];
        let mut wait = pin!(client.read(&mut some));
        for _ in 0..5 {
            let polled = wait.as_mut().poll(&mut Context::from_waker(&waker));
            assert!(polled.is_pending());
            tokio::task::yield_now().await;
        }
        assert!(!woken.0.load(Ordering::Relaxed));
    }

    #[tokio::test]
    async fn a_program_that_does_not_read_loses_bytes_and_blocks_nobody() {
        let pty = Pty::open(None).unwrap();
        let mut program = client_end(pty.path()).unwrap();
        let client = pty.client().unwrap().unwrap();
        for _ in 0..1000 {
            client.try_write(&[5; 4096]);
        }
        let mut some = [0; 42];
        program.read_exact(&mut some).unwrap();
        assert_eq!(some, [5; 42]);
    }

    #[tokio::test]
    async fn what_the_last_client_did_not_read_is_not_for_the_next() {
        let mut pty = Pty::open(None).unwrap();
        let program = open(&pty);
        pty.client().unwrap().unwrap().try_write(&[1; 420]);
        // It has arrived: it is not on its way any more when the port is emptied.
        while program.bytes_to_read().unwrap() < 420 {
            tokio::task::yield_now().await;
        }
        drop(program);
        assert_eq!(pty.renew().unwrap(), None);
        let mut program = client_end(pty.path()).unwrap();
        let error = program.read(&mut [0; 64]).unwrap_err();
        assert_eq!(error.kind(), io::ErrorKind::WouldBlock);
        // What comes later does arrive.
        pty.client().unwrap().unwrap().try_write(&[2]);
        let mut one = [0];
        while program.read(&mut one).is_err() {
            tokio::task::yield_now().await;
        }
        assert_eq!(one, [2]);
    }

    #[tokio::test]
    async fn a_lock_that_a_killed_client_left_is_got_rid_of() {
        let folder = tempfile::tempdir().unwrap();
        let link = folder.path().join("arm");
        let mut pty = Pty::open(Some(&link)).unwrap();
        let program = client_end(pty.path()).unwrap();
        ioctl_tiocexcl(&program).unwrap();
        drop(program);
        // The superuser is not locked out, so that there the port is the same.
        pty.renew().unwrap();
        assert_eq!(pty.path(), link);
        let program = open(&pty);
        program.clear(ClearBuffer::Input).unwrap();
        assert!(pty.client().unwrap().is_some());
    }
}
