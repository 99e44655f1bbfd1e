//! The loop of the pendant between the terminal and the station.

use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

use crossterm::event::{Event, EventStream};
use dobot_api::{RemoteError, Reply, Request, State, StationEvent};
use dobot_host::StationClient;
use futures_util::StreamExt;
use ratatui::Frame;
use tokio::time::Instant;

use super::gamepad::{EVENT_LEN, PadEvents};
use super::paste::{IGNORED, PasteFilter};
use super::screen::draw;
use super::terminal::Screen;
use super::{Drive, Pendant};
use crate::failure::Failure;
use crate::interrupt::interrupt;

/// A screen around a pendant with additional keys.
pub(crate) trait Panel {
    /// The pendant.
    fn pendant(&mut self) -> &mut Pendant;

    /// Draws the screen.
    fn draw(&self, frame: &mut Frame);

    /// Handles an event of the terminal.
    fn handle_event(&mut self, now: Duration, event: &Event) {
        self.pendant().handle_event(now, event);
    }

    /// Handles pasted text; returns whether it was taken as the text of a prompt. It is never a key.
    fn handle_paste(&mut self, _: &str) -> bool {
        false
    }

    /// Handles a state of the station.
    fn handle_state(&mut self, state: State) {
        self.pendant().handle_state(state);
    }

    /// Handles a reply of the station.
    fn handle_reply(&mut self, reply: &Reply) {
        self.pendant().handle_reply(reply);
    }

    /// Handles the refusal of a request.
    fn handle_refused(&mut self, request: &Request, _kind: Option<&str>, why: String) {
        self.pendant().handle_refused(request, why);
    }

    /// Returns the next file to write, with its text.
    fn poll_file(&mut self) -> Option<(PathBuf, String)> {
        None
    }

    /// Handles the result of writing a text.
    fn handle_saved(&mut self, _: String, _: io::Result<()>) {}
}

impl Panel for Pendant {
    fn pendant(&mut self) -> &mut Pendant {
        self
    }

    fn draw(&self, frame: &mut Frame) {
        draw(frame, self);
    }
}

/// Lets a person move the arm with keys until they quit. The client must have control. `panel` creates the
/// screen around the pendant.
pub(crate) async fn run<P: Panel>(
    station: &mut StationClient,
    drive: Drive,
    mut pad: Option<PadEvents>,
    panel: impl FnOnce(Pendant) -> P,
) -> Result<(), Failure> {
    let mut interrupt = std::pin::pin!(interrupt());
    let mut screen = Screen::open()?;
    let mut events = EventStream::new();
    let clock = Clock::of(station);
    let pendant = Pendant::new(station.id(), screen.keys(), station.dead_man(), drive);
    let mut panel = panel(pendant);
    let mut filter = PasteFilter::default();
    let mut is_shown = false;
    loop {
        tokio::select! {
            biased;
            () = &mut interrupt => panel.pendant().quit(),
            event = events.next() => match event.transpose()? {
                Some(Event::Paste(text)) if panel.handle_paste(&text) => {}
                Some(event) => {
                    for event in filter.handle_event(clock.now(), event) {
                        panel.handle_event(clock.now(), &event);
                    }
                }
                None => panel.pendant().quit(),
            },
            () = clock.wait_until(filter.poll_wakeup()) => {
                if let Some(event) = filter.handle_time(clock.now()) {
                    panel.handle_event(clock.now(), &event);
                }
            }
            event = pad_event(&mut pad) => panel.pendant().handle_pad(clock.now(), event),
            () = tokio::time::sleep_until(screen.free_from()), if !is_shown => {
                screen.draw(|frame| panel.draw(frame))?;
                is_shown = true;
                continue;
            }
            () = clock.wait_until(panel.pendant().poll_wakeup()) => {}
            event = clock.next(station) => match event? {
                StationEvent::State(state) => panel.handle_state(*state),
                StationEvent::Notice(notice) => panel.pendant().handle_notice(notice),
            },
        }
        is_shown = false;
        if filter.take_discarded() {
            panel.pendant().show(IGNORED.to_owned());
        }
        panel.pendant().handle_time(clock.now());
        send_requests(station, &mut panel, clock).await?;
        if let Some((file, text)) = panel.poll_file() {
            let saved = write_whole(&file, &text);
            panel.handle_saved(text, saved);
        }
        if panel.pendant().is_over() {
            return Ok(());
        }
    }
}

/// Replaces a file atomically.
fn write_whole(file: &Path, text: &str) -> io::Result<()> {
    // Keep a symbolic link, and replace its target.
    let file = file.canonicalize().unwrap_or_else(|_| file.to_owned());
    let mut name = file.file_name().unwrap_or_default().to_owned();
    name.push(".new");
    let beside = file.with_file_name(name);
    let written = std::fs::write(&beside, text).and_then(|()| std::fs::rename(&beside, &file));
    if written.is_err() {
        // Best effort: remove the incomplete file.
        let _ = std::fs::remove_file(&beside);
    }
    written
}

/// Waits for the next event of the gamepad, once for `None` after it was disconnected, and forever without one.
async fn pad_event(pad: &mut Option<PadEvents>) -> Option<[u8; EVENT_LEN]> {
    let Some(events) = pad else {
        return std::future::pending().await;
    };
    let event = events.recv().await;
    if event.is_none() {
        *pad = None;
    }
    event
}

/// Sends the pending requests of the pendant.
async fn send_requests(
    station: &mut StationClient,
    panel: &mut impl Panel,
    clock: Clock,
) -> Result<(), Failure> {
    while let Some(request) = panel.pendant().poll_request(clock.now()) {
        match station.request(request.clone()).await {
            Ok(reply) => panel.handle_reply(&reply),
            Err(error @ RemoteError::Refused(_)) => {
                let hint = error.hint().map(|hint| format!("; {hint}"));
                let why = format!("{error}{}", hint.unwrap_or_default());
                panel.handle_refused(&request, error.kind(), why);
            }
            Err(error) => return Err(error.into()),
        }
    }
    Ok(())
}

/// Waits until a time after the beginning, or forever for `None`.
pub(crate) async fn wait_until(began: Instant, time: Option<Duration>) {
    match time {
        Some(time) => tokio::time::sleep_until(began + time).await,
        None => std::future::pending().await,
    }
}

/// Real time. A virtual arm in this process has its own clock, which advances only while waiting; it is kept
/// in step with real time.
#[derive(Clone, Copy)]
pub(crate) struct Clock {
    began: Instant,
    /// The time of the arm's clock at the start.
    arm: Duration,
}

impl Clock {
    /// Starts the clock.
    pub(crate) fn of(station: &StationClient) -> Self {
        Self {
            began: Instant::now(),
            arm: station.now(),
        }
    }

    /// The time since the start.
    pub(crate) fn now(&self) -> Duration {
        self.began.elapsed()
    }

    /// Waits until a time, or forever for `None`.
    pub(crate) async fn wait_until(&self, time: Option<Duration>) {
        wait_until(self.began, time).await;
    }

    /// Waits for the next event of the station.
    pub(crate) async fn next(
        &self,
        station: &mut StationClient,
    ) -> Result<StationEvent, RemoteError> {
        if station.virtual_arm().is_some() {
            let arm_time = station.now().saturating_sub(self.arm);
            tokio::time::sleep_until(self.began + arm_time).await;
        }
        station.next().await
    }
}
