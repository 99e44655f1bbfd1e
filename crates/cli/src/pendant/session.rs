//! The pendant at work: between the terminal and the station.

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
use super::screen::draw;
use super::terminal::Screen;
use super::{Drive, Pendant};
use crate::failure::Failure;
use crate::interrupt::interrupt;

/// A pendant, and what its keys mean beside.
pub(crate) trait Panel {
    /// The pendant.
    fn pendant(&mut self) -> &mut Pendant;

    /// Draws everything.
    fn draw(&self, frame: &mut Frame);

    /// Takes what the terminal tells.
    fn handle_event(&mut self, now: Duration, event: &Event) {
        self.pendant().handle_event(now, event);
    }

    /// Takes what the station tells all the time.
    fn handle_state(&mut self, state: State) {
        self.pendant().handle_state(state);
    }

    /// Takes what the station answers.
    fn handle_reply(&mut self, reply: &Reply) {
        self.pendant().handle_reply(reply);
    }

    /// Takes that the station refuses a request.
    fn handle_refused(&mut self, request: &Request, _kind: Option<&str>, why: String) {
        self.pendant().handle_refused(request, why);
    }

    /// A file that is to be written, and its text.
    fn poll_file(&mut self) -> Option<(PathBuf, String)> {
        None
    }

    /// Takes what came of writing this text.
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

/// Lets a person move the arm with keys until they leave; control has been taken. `panel` makes what is
/// on the screen of a pendant that jogs.
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
    let mut is_shown = false;
    loop {
        tokio::select! {
            biased;
            () = &mut interrupt => panel.pendant().quit(),
            event = events.next() => match event.transpose()? {
                Some(event) => panel.handle_event(clock.now(), &event),
                None => panel.pendant().quit(),
            },
            event = pad_event(&mut pad) => panel.pendant().handle_pad(clock.now(), event),
            () = tokio::time::sleep_until(screen.free_from()), if !is_shown => {
                screen.draw(|frame| panel.draw(frame))?;
                is_shown = true;
                continue;
            }
            () = clock.wait_until(panel.pendant().poll_wakeup()) => {}
            heard = clock.next(station) => match heard? {
                StationEvent::State(state) => panel.handle_state(*state),
                StationEvent::Notice(notice) => panel.pendant().handle_notice(notice),
            },
        }
        is_shown = false;
        panel.pendant().handle_time(clock.now());
        ask_all(station, &mut panel, clock).await?;
        if let Some((file, text)) = panel.poll_file() {
            let saved = write_whole(&file, &text);
            panel.handle_saved(text, saved);
        }
        if panel.pendant().is_over() {
            return Ok(());
        }
    }
}

/// Writes a file so that it is there as it was or as it is to be, whatever happens meanwhile.
fn write_whole(file: &Path, text: &str) -> io::Result<()> {
    // A link goes on to lead to where it leads.
    let file = file.canonicalize().unwrap_or_else(|_| file.to_owned());
    let mut name = file.file_name().unwrap_or_default().to_owned();
    name.push(".new");
    let beside = file.with_file_name(name);
    let written = std::fs::write(&beside, text).and_then(|()| std::fs::rename(&beside, &file));
    if written.is_err() {
        // What is left of it is of no use.
        let _ = std::fs::remove_file(&beside);
    }
    written
}

/// What the gamepad tells next; once `None` where it is gone, and nothing where there is none.
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

/// Asks for all that the pendant wants now.
async fn ask_all(
    station: &mut StationClient,
    panel: &mut impl Panel,
    clock: Clock,
) -> Result<(), Failure> {
    while let Some(request) = panel.pendant().poll_request(clock.now()) {
        match station.request(request.clone()).await {
            Ok(reply) => panel.handle_reply(&reply),
            Err(error @ RemoteError::Refused(_)) => {
                let hint = error.hint().map(|it| format!("; {it}"));
                let why = format!("{error}{}", hint.unwrap_or_default());
                panel.handle_refused(&request, error.kind(), why);
            }
            Err(error) => return Err(error.into()),
        }
    }
    Ok(())
}

/// The person's clock. An arm in this process has a clock of its own that stands while nobody waits:
/// it is kept at the person's.
#[derive(Clone, Copy)]
pub(crate) struct Clock {
    began: Instant,
    /// What the arm's clock showed then.
    arm: Duration,
}

impl Clock {
    /// From now on.
    pub(crate) fn of(station: &StationClient) -> Self {
        Self {
            began: Instant::now(),
            arm: station.now(),
        }
    }

    /// The time since then.
    pub(crate) fn now(&self) -> Duration {
        self.began.elapsed()
    }

    /// Waits for a time; for ever, where none is given.
    pub(crate) async fn wait_until(&self, time: Option<Duration>) {
        match time {
            Some(time) => tokio::time::sleep_until(self.began + time).await,
            None => std::future::pending().await,
        }
    }

    /// What the station tells next.
    pub(crate) async fn next(
        &self,
        station: &mut StationClient,
    ) -> Result<StationEvent, RemoteError> {
        if station.virtual_arm().is_some() {
            let told_until = station.now().saturating_sub(self.arm);
            tokio::time::sleep_until(self.began + told_until).await;
        }
        station.next().await
    }
}
