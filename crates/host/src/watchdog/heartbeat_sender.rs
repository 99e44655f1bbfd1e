//! The sender of heartbeats, which also detects stalls of its own loop.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use dobot_session::Link;
use dobot_wire::{Dialect, Packet};

#[cfg(unix)]
use super::child::Child;
use super::clock::Clock;
use super::{Hazards, Heartbeat, PanicStop, Watchdog};
use crate::{Notification, ServiceManager};

/// Sends heartbeats while the loop of the arm thread runs.
#[derive(Debug)]
pub(crate) struct HeartbeatSender {
    /// The watchdog program, if any.
    program: Option<PathBuf>,
    note: PathBuf,
    clock: Clock,
    /// When the last heartbeat was sent, while there is an arm.
    last: Option<Duration>,
    hazards: Hazards,
    panic_stop: Arc<PanicStop>,
    #[cfg(unix)]
    watchdog: Option<Child>,
    /// When the last watchdog was started.
    #[cfg(unix)]
    watchdog_started: Duration,
    /// Why there is no watchdog although one is required.
    gone: Option<String>,
    trouble: Option<String>,
    /// The service manager.
    service_manager: ServiceManager,
    /// When the service manager was last notified.
    reported: Duration,
}

impl HeartbeatSender {
    /// Creates a sender; without a program there is no watchdog.
    pub(crate) fn new(program: Option<PathBuf>, note: PathBuf, panic_stop: Arc<PanicStop>) -> Self {
        Self {
            program,
            note,
            clock: Clock::new(),
            last: None,
            hazards: Hazards::default(),
            panic_stop,
            #[cfg(unix)]
            watchdog: None,
            #[cfg(unix)]
            watchdog_started: Duration::ZERO,
            gone: None,
            trouble: None,
            service_manager: ServiceManager::default(),
            reported: Duration::ZERO,
        }
    }

    /// Also notifies the service manager.
    pub(crate) fn supervised(mut self, service_manager: ServiceManager) -> Self {
        self.service_manager = service_manager;
        self
    }

    /// Starts guarding the arm on this link.
    pub(crate) fn start(&mut self, link: &Link) {
        self.stop();
        if let Err(error) = self.guard(link) {
            self.set_gone(&error);
        }
    }

    /// Stops guarding, because the link is gone or the station ends properly.
    pub(crate) fn stop(&mut self) {
        self.last = None;
        self.gone = None;
        #[cfg(unix)]
        {
            self.panic_stop.set_port(None);
            if let Some(mut watchdog) = self.watchdog.take() {
                // It may be gone already.
                let _ = watchdog.send(Heartbeat::Goodbye);
            }
        }
    }

    /// Sends a heartbeat if due; returns the length of a stall, if there was one.
    pub(crate) fn send_due(&mut self) -> Option<Duration> {
        let now = self.clock.now();
        if let Some(period) = self.service_manager.period()
            && now >= self.reported + period
        {
            self.reported = now;
            self.service_manager.notify(Notification::Alive);
        }
        let silent = now.saturating_sub(self.last?);
        if silent >= PERIOD {
            self.send();
        }
        (silent >= Watchdog::PATIENCE).then_some(silent)
    }

    /// Notes the next packet to the arm: the watchdog learns of it before the arm does.
    pub(crate) fn note_packet(&mut self, packet: &Packet, dialect: &Dialect) {
        let hazards = self.hazards.after(packet, dialect);
        if hazards != self.hazards {
            self.hazards = hazards;
            self.panic_stop.note(hazards);
            if self.last.is_some() {
                self.send();
            }
        }
    }

    /// Returns the time until the next heartbeat is due.
    pub(crate) fn due_in(&self) -> Option<Duration> {
        let watchdog = self.last.map(|last| last + PERIOD);
        let service_manager = self
            .service_manager
            .period()
            .map(|period| self.reported + period);
        let next = watchdog.into_iter().chain(service_manager).min()?;
        Some(next.saturating_sub(self.clock.now()))
    }

    /// Returns the file of the watchdog's note.
    pub(crate) fn note(&self) -> &Path {
        &self.note
    }

    /// Returns why no watchdog guards the arm although one is required.
    pub(crate) const fn gone(&self) -> Option<&String> {
        self.gone.as_ref()
    }

    /// Returns a fault to report.
    pub(crate) const fn poll_trouble(&mut self) -> Option<String> {
        self.trouble.take()
    }

    #[cfg(unix)]
    fn guard(&mut self, link: &Link) -> std::io::Result<()> {
        let Some(port) = link.port() else {
            // An arm in this process ends with it.
            return Ok(());
        };
        self.panic_stop.set_port(Some(port.try_clone_to_owned()?));
        self.last = Some(self.clock.now());
        self.start_watchdog()
    }

    /// Starts the watchdog of the port, if there is a program.
    #[cfg(unix)]
    fn start_watchdog(&mut self) -> std::io::Result<()> {
        if let (Some(program), Some(port)) = (&self.program, self.panic_stop.port()?) {
            self.watchdog_started = self.clock.now();
            self.watchdog = Some(Child::start(program, &self.note, port)?);
            self.send();
        }
        Ok(())
    }

    /// Replaces a watchdog that is gone, unless it had just been started: then a little later,
    /// until one stays.
    #[cfg(unix)]
    fn replace(&mut self) {
        if self.clock.now().saturating_sub(self.watchdog_started) < BETWEEN_STARTS {
            return;
        }
        match self.start_watchdog() {
            Ok(()) if self.watchdog.is_some() => {
                self.gone = None;
                self.trouble = Some("the watchdog was gone and has been replaced".to_owned());
            }
            Ok(()) => {}
            Err(error) => self.set_gone(&error),
        }
    }

    #[cfg(unix)]
    fn set_gone(&mut self, error: &std::io::Error) {
        self.watchdog = None;
        if self.gone.is_none() {
            self.trouble = Some(format!(
                "the watchdog is gone: {error}; jogging and burning are refused until there is another one"
            ));
        }
        self.gone = Some(error.to_string());
    }

    #[cfg(not(unix))]
    fn guard(&mut self, _link: &Link) -> std::io::Result<()> {
        Ok(())
    }

    fn send(&mut self) {
        self.last = Some(self.clock.now());
        #[cfg(unix)]
        match &mut self.watchdog {
            Some(watchdog) => {
                if let Err(error) = watchdog.send(Heartbeat::Alive(self.hazards)) {
                    self.set_gone(&error);
                    self.replace();
                }
            }
            None if self.gone.is_some() => self.replace(),
            None => {}
        }
    }
}

/// The longest time between heartbeats.
pub(crate) const PERIOD: Duration = Duration::from_millis(80);
/// The pause before another watchdog is started.
#[cfg(unix)]
const BETWEEN_STARTS: Duration = Duration::from_secs(3);
