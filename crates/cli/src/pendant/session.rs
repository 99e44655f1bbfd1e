//! The pendant at work: between the terminal and the station.

use std::time::Duration;

use crossterm::event::EventStream;
use dobot_api::{RemoteError, StationEvent};
use dobot_rules::StationClient;
use futures_util::StreamExt;
use tokio::time::Instant;

use super::screen::draw;
use super::terminal::Screen;
use super::{Drive, Pendant};
use crate::failure::Failure;
use crate::interrupt::interrupt;

/// Lets a person move the arm with keys until they leave; control has been taken.
pub(crate) async fn run(station: &mut StationClient, drive: Drive) -> Result<(), Failure> {
    let mut interrupt = std::pin::pin!(interrupt());
    let mut screen = Screen::open()?;
    let mut events = EventStream::new();
    let clock = Clock::of(station);
    let mut pendant = Pendant::new(station.id(), screen.keys(), station.dead_man(), drive);
    loop {
        screen.draw(|frame| draw(frame, &pendant))?;
        tokio::select! {
            biased;
            () = &mut interrupt => pendant.quit(),
            event = events.next() => match event.transpose()? {
                Some(event) => pendant.handle_event(clock.now(), &event),
                None => pendant.quit(),
            },
            () = clock.wait_until(pendant.poll_wakeup()) => {}
            heard = clock.next(station) => match heard? {
                StationEvent::State(state) => pendant.handle_state(*state),
                StationEvent::Notice(notice) => pendant.handle_notice(notice),
            },
        }
        pendant.handle_time(clock.now());
        ask_all(station, &mut pendant, clock).await?;
        if pendant.is_over() {
            return Ok(());
        }
    }
}

/// Asks for all that the pendant wants now.
async fn ask_all(
    station: &mut StationClient,
    pendant: &mut Pendant,
    clock: Clock,
) -> Result<(), Failure> {
    while let Some(request) = pendant.poll_request(clock.now()) {
        match station.request(request.clone()).await {
            Ok(reply) => pendant.handle_reply(&reply),
            Err(RemoteError::Refused(problem)) => {
                let hint = problem.hint.map(|it| format!("; {it}")).unwrap_or_default();
                pendant.handle_refused(&request, format!("{}{hint}", problem.detail));
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
