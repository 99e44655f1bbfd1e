//! The arm thread, which drives the arm's port.

use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use tokio::runtime::{Builder, Handle, Runtime};
use tokio::sync::oneshot;

use crate::connect::Connecting;
use crate::driver::Driver;
use crate::priority;
use crate::watchdog::PanicStop;

/// The arm thread: it runs the driver of the port and the clients that use the arm's own protocol,
/// so that no packet waits until a thousand others have received a state.
///
/// The system schedules it before threads that can wait, where permitted ([`priority`]).
///
/// If it panics, its [`PanicStop`] sends laser off and the release, because nothing else is left to
/// do so.
#[derive(Debug)]
pub(crate) struct ArmThread {
    runtime: Handle,
    driver: oneshot::Sender<(Driver, Option<Connecting>)>,
    ended: oneshot::Receiver<Result<(), String>>,
}

/// The thread with its driver running.
#[derive(Debug)]
pub(crate) struct RunningArmThread {
    runtime: Handle,
    ended: oneshot::Receiver<Result<(), String>>,
}

impl ArmThread {
    /// Starts the thread; it waits for its driver, but tasks spawned on it already run.
    ///
    /// # Errors
    ///
    /// The operating system's error.
    pub(crate) fn start(panic_stop: Arc<PanicStop>) -> io::Result<Self> {
        // A thread spawned from it would inherit its priority.
        let runtime = Builder::new_current_thread()
            .enable_all()
            .on_thread_start(priority::of_jobs)
            .build()?;
        let handle = runtime.handle().clone();
        let (driver, given) = oneshot::channel::<(Driver, Option<Connecting>)>();
        let (over, ended) = oneshot::channel();
        let thread = std::thread::Builder::new().name("arm".into());
        thread.spawn(move || {
            priority::of_arm();
            panic_stop.send_on_panic();
            let outcome = drive(&runtime, given);
            // The receiver may be gone.
            let _ = over.send(outcome);
        })?;
        Ok(Self {
            runtime: handle,
            driver,
            ended,
        })
    }

    /// Runs the driver with the first result of connecting; the thread and all its tasks end with
    /// it.
    pub(crate) fn run(self, driver: Driver, first: Option<Connecting>) -> RunningArmThread {
        // If the thread has ended, waiting for it reports that.
        let _ = self.driver.send((driver, first));
        RunningArmThread {
            runtime: self.runtime,
            ended: self.ended,
        }
    }

    /// The runtime of its tasks.
    pub(crate) const fn runtime(&self) -> &Handle {
        &self.runtime
    }
}

impl RunningArmThread {
    /// Spawns another task on the thread.
    pub(crate) fn spawn(&self, task: impl Future<Output = ()> + Send + 'static) {
        self.runtime.spawn(task);
    }

    /// Waits until the driver has ended.
    ///
    /// # Errors
    ///
    /// The failure of something that the arm depends on, in one line.
    pub(crate) async fn ended(self) -> Result<(), String> {
        match self.ended.await {
            Ok(outcome) => outcome,
            Err(_) => Err("the arm thread was aborted".to_owned()),
        }
    }
}

/// Runs the driver to its end, if the station starts.
fn drive(
    runtime: &Runtime,
    given: oneshot::Receiver<(Driver, Option<Connecting>)>,
) -> Result<(), String> {
    let work = || {
        runtime.block_on(async {
            match given.await {
                Ok((driver, first)) => Box::pin(driver.run(first)).await,
                // The station did not start.
                Err(_) => Ok(()),
            }
        })
    };
    catch_unwind(AssertUnwindSafe(work))
        .unwrap_or_else(|_| Err("the arm thread panicked".to_owned()))
}

#[cfg(all(test, unix))]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use std::io::Read;
    use std::os::unix::net::UnixStream;
    use std::pin::Pin;
    use std::task::{Context, Poll};
    use std::time::{Duration, Instant};

    use dobot_api::Folders;
    use dobot_journal::Journal;
    use dobot_motion::LASER_OFF;
    use dobot_safety::Policy;
    use dobot_session::{Address, Link};
    use dobot_wire::{Command, Decoder, Dialect, LinearJog, LinearJogAxis};
    use tokio::io::{AsyncRead, AsyncWrite, ReadBuf};
    use tokio::sync::Mutex;

    use super::*;
    use crate::connect::Source;
    use crate::disk::Disk;
    use crate::driver::DriverParts;
    use crate::handle::{Message, Rules};
    use crate::jobs::Jobs;
    use crate::known_arms::KnownArms;
    use crate::recording::Recording;
    use crate::saved_slots::SavedSlots;
    use crate::watchdog::{Hazards, HeartbeatSender, JogKind};
    use crate::{Finder, Found, Search};
    use dobot_supervisor::Supervisor;

    /// A port that accepts everything, and panics when it is read.
    struct Panics;

    impl AsyncRead for Panics {
        fn poll_read(
            self: Pin<&mut Self>,
            _: &mut Context<'_>,
            _: &mut ReadBuf<'_>,
        ) -> Poll<io::Result<()>> {
            panic!("a test wants it so")
        }
    }

    impl AsyncWrite for Panics {
        fn poll_write(
            self: Pin<&mut Self>,
            _: &mut Context<'_>,
            bytes: &[u8],
        ) -> Poll<io::Result<usize>> {
            Poll::Ready(Ok(bytes.len()))
        }

        fn poll_flush(self: Pin<&mut Self>, _: &mut Context<'_>) -> Poll<io::Result<()>> {
            Poll::Ready(Ok(()))
        }

        fn poll_shutdown(self: Pin<&mut Self>, _: &mut Context<'_>) -> Poll<io::Result<()>> {
            Poll::Ready(Ok(()))
        }
    }

    /// Runs a driver on a link and returns it with its handle.
    fn at_work(
        link: Link,
        panic_stop: &Arc<PanicStop>,
    ) -> (RunningArmThread, tokio::sync::mpsc::Sender<Message>) {
        let folder = tempfile::tempdir().unwrap();
        let folders = Folders::at(folder.path());
        let policy = Policy::default();
        let supervisor = Supervisor::new(policy.clone(), Some(Dialect::FIRMWARE_1_1));
        let (handle, channels) = crate::StationHandle::new(supervisor.state(), Rules::of(&policy));
        let own = handle.messages.clone();
        let journal = Journal::in_memory().unwrap();
        let driver = Driver::new(DriverParts {
            supervisor,
            channels,
            source: Source::Port(Arc::new(Mutex::new(Finder::new(Search::default())))),
            arms: KnownArms::read(&folders.arms()).unwrap(),
            slots: SavedSlots::at(&folders.slots()),
            jobs: Jobs::new(journal, Arc::new(policy), own.clone()),
            recording: Recording::new(None, None),
            stop: None,
            disk: Disk::start(own.clone()).unwrap(),
            own: own.clone(),
            heartbeats: HeartbeatSender::new(None, folders.watchdog(), panic_stop.clone()),
        });
        let found = Found {
            address: Address::Tcp {
                host: "an.arm".into(),
                port: 1,
            },
            link,
            bytes: Vec::new(),
        };
        let thread = ArmThread::start(panic_stop.clone()).unwrap();
        (thread.run(driver, Some(Connecting::Up(found))), own)
    }

    fn commands(far: &mut impl Read) -> Vec<Command> {
        let mut bytes = Vec::new();
        far.read_to_end(&mut bytes).unwrap();
        let mut decoder = Decoder::commands();
        let packets = decoder.feed(&bytes);
        packets
            .map(|packet| Command::parse(&packet, &Dialect::FIRMWARE_1_1).unwrap())
            .collect()
    }

    #[tokio::test]
    async fn a_panic_in_the_arm_thread_stops_the_arm_at_once_and_ends_the_station() {
        let (near, mut far) = UnixStream::pair().unwrap();
        let panic_stop = Arc::new(PanicStop::default());
        panic_stop.note(Hazards {
            jog: Some(JogKind::Linear),
            burns: true,
        });
        let link = Link::over_stream(Panics).with_port(near.into());
        let began = Instant::now();
        let (thread, _own) = at_work(link, &panic_stop);
        let error = thread.ended().await.unwrap_err();
        assert_eq!(error, "the arm thread panicked");
        drop(panic_stop);
        let release = Command::LinearJog(LinearJog::new(LinearJogAxis::Released, 0.0));
        assert_eq!(commands(&mut far), [LASER_OFF, release]);
        assert!(
            began.elapsed() < Duration::from_secs(5),
            "it did not wait for anybody"
        );
    }

    #[cfg(target_os = "linux")]
    #[tokio::test]
    async fn the_arm_has_priority_over_the_check_of_a_job() {
        use rustix::process::{getpriority_process, setpriority_process};

        let niceness = || getpriority_process(None).unwrap();
        let usual = niceness();
        // What the system permits here.
        let allowed = std::thread::spawn(move || setpriority_process(None, -10).is_ok());
        let allowed = allowed.join().unwrap();
        let thread = ArmThread::start(Arc::default()).unwrap();
        let of_arm = thread.runtime.spawn(async move { niceness() });
        let of_jobs = thread.runtime.spawn_blocking(niceness);
        let of_arm = of_arm.await.unwrap();
        assert_eq!(of_arm, if allowed { -10 } else { usual });
        assert!(of_jobs.await.unwrap() >= 5, "it is not inherited");
        assert_eq!(niceness(), usual, "other threads stay as they are");
    }

    #[tokio::test]
    async fn a_failure_of_something_the_arm_depends_on_ends_the_station_and_is_reported() {
        let (near, _far) = tokio::io::duplex(4096);
        let panic_stop = Arc::new(PanicStop::default());
        let (thread, own) = at_work(Link::over_stream(near), &panic_stop);
        own.send(Message::Failed("the journal is gone".into()))
            .await
            .unwrap();
        assert_eq!(thread.ended().await.unwrap_err(), "the journal is gone");
    }
}
