//! Stop packets sent when a part of the station panics.

use std::cell::RefCell;
use std::panic::{set_hook, take_hook};
use std::sync::{Arc, Mutex, Once, PoisonError};

#[cfg(unix)]
use std::os::fd::OwnedFd;
#[cfg(unix)]
use std::time::Duration;

use super::Hazards;

/// The arm's port and hazards, kept apart from the arm thread: if it panics, laser off and the
/// release are sent immediately and without its help.
#[derive(Debug, Default)]
pub(crate) struct PanicStop(Mutex<GuardedPort>);

#[derive(Debug, Default)]
struct GuardedPort {
    hazards: Hazards,
    #[cfg(unix)]
    port: Option<OwnedFd>,
}

impl PanicStop {
    /// Records the current hazards.
    pub(crate) fn note(&self, hazards: Hazards) {
        self.lock().hazards = hazards;
    }

    /// Sets the port of the arm; `None` while there is no link.
    #[cfg(unix)]
    pub(crate) fn set_port(&self, port: Option<OwnedFd>) {
        self.lock().port = port;
    }

    /// Duplicates the port; `None` while there is no link.
    ///
    /// # Errors
    ///
    /// The operating system's error.
    #[cfg(unix)]
    pub(crate) fn port(&self) -> std::io::Result<Option<OwnedFd>> {
        self.lock()
            .port
            .as_ref()
            .map(OwnedFd::try_clone)
            .transpose()
    }

    /// From now on, a panic of this thread sends laser off and the release before anything else:
    /// even before the panic message, which may wait for a full pipe.
    pub(crate) fn send_on_panic(self: Arc<Self>) {
        static HOOK: Once = Once::new();
        HOOK.call_once(|| {
            let previous = take_hook();
            set_hook(Box::new(move |panic| {
                // A thread that is ending has no hook left.
                let stop = OF_THREAD.try_with(|stop| stop.borrow().clone());
                if let Ok(Some(stop)) = stop {
                    stop.send();
                }
                previous(panic);
            }));
        });
        OF_THREAD.set(Some(self));
    }

    /// Sends laser off and the release without anything that may have panicked; the watchdog
    /// repeats them.
    #[cfg(unix)]
    fn send(&self) {
        let known = self.lock();
        let Some(port) = &known.port else {
            return;
        };
        for packet in known.hazards.stop_packets() {
            // If the port accepts nothing, the watchdog keeps trying.
            super::port::write_within(port, &packet.to_bytes(), PATIENCE);
            std::thread::sleep(super::GAP);
        }
    }

    /// Without a port there is nothing to send to.
    #[cfg(not(unix))]
    fn send(&self) {}

    fn lock(&self) -> std::sync::MutexGuard<'_, GuardedPort> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

thread_local! {
    static OF_THREAD: RefCell<Option<Arc<PanicStop>>> = const { RefCell::new(None) };
}

/// The time a port may take for a packet.
#[cfg(unix)]
const PATIENCE: Duration = Duration::from_millis(100);

#[cfg(all(test, unix))]
#[path = "../../../cli/tests/support/full_pipe.rs"]
mod full_pipe;

#[cfg(all(test, unix))]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use std::io::Read;
    use std::os::fd::AsFd;
    use std::process::{Command, Stdio};

    use super::super::JogKind;
    use super::full_pipe::full_pipe;
    use super::*;

    const HAZARDS: Hazards = Hazards {
        jog: Some(JogKind::Linear),
        burns: true,
    };
    /// Set in the process that panics in this test.
    const PANICS: &str = "DOBOT_TEST_PANICS";

    /// Standard output is the arm's port.
    fn panic_with_port() {
        let stop = Arc::new(PanicStop::default());
        let port = std::io::stdout().as_fd().try_clone_to_owned().unwrap();
        stop.set_port(Some(port));
        stop.note(HAZARDS);
        stop.send_on_panic();
        panic!("this text waits for a full pipe");
    }

    #[test]
    fn a_panic_sends_its_packets_even_if_standard_error_is_never_read() {
        if std::env::var_os(PANICS).is_some() {
            panic_with_port();
        }
        let (reader, errors) = full_pipe();
        let (_, module) = module_path!().split_once("::").unwrap();
        let name =
            format!("{module}::a_panic_sends_its_packets_even_if_standard_error_is_never_read");
        let mut child = Command::new(std::env::current_exe().unwrap())
            .args(["--exact", &name, "--nocapture"])
            .env(PANICS, "1")
            .stdout(Stdio::piped())
            .stderr(errors)
            .spawn()
            .unwrap();
        let wanted: Vec<u8> = HAZARDS
            .stop_packets()
            .iter()
            .flat_map(dobot_wire::Packet::to_bytes)
            .collect();
        let mut received = Vec::new();
        let mut port = child.stdout.take().unwrap();
        while !received
            .windows(wanted.len())
            .any(|window| window == wanted)
        {
            let mut bytes = [0; 256];
            let read = port.read(&mut bytes).unwrap();
            assert!(read > 0, "it ended without the packets");
            received.extend_from_slice(&bytes[..read]);
        }
        // It is waiting for the pipe now.
        assert_eq!(child.try_wait().unwrap(), None);
        drop(reader);
        assert!(!child.wait().unwrap().success());
    }
}
