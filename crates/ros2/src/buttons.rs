//! Jogs: an axis moves while messages request it.

use std::sync::Arc;

use dobot_api::{Jog, Request};
use dobot_host::StationClient;
use tokio::sync::watch;
use tokio::time::timeout;

use crate::actions::{ended, take};
use crate::log::Log;
use crate::station::{Station, refused};

/// The last jog message: a button, no button, or an error in the message.
pub(crate) type JogMessage = Option<Result<Option<Jog>, String>>;

/// Holds the requested buttons while the requests are repeated.
pub(crate) struct Buttons {
    pub(crate) station: Station,
    pub(crate) log: Arc<Log>,
    pub(crate) messages: watch::Receiver<JogMessage>,
    pub(crate) ending: watch::Receiver<bool>,
}

impl Buttons {
    /// Runs until no more messages can arrive.
    pub(crate) async fn run(mut self) {
        while self.messages.changed().await.is_ok() {
            let message = self.messages.borrow_and_update().clone();
            let refused = match message {
                None | Some(Ok(None)) => continue,
                Some(Ok(Some(jog))) => self.press(jog).await.err(),
                Some(Err(why)) => Some(why),
            };
            if let Some(why) = refused {
                self.log.warn(&format!("jog: {why}"));
                // The arm must not start moving because a limit is cleared while a stick is held:
                // the stick must be released first.
                self.silence().await;
            }
        }
    }

    async fn press(&mut self, jog: Jog) -> Result<(), String> {
        let mut station = self.station.connect("jog").await?;
        take(&mut station).await?;
        let held = hold(&mut station, jog, &mut self.messages, &mut self.ending).await;
        // If this fails, the dead-man time releases it a little later.
        station.request(Request::Release).await.ok();
        held
    }

    /// Waits until no more jogs are requested.
    async fn silence(&mut self) {
        while let Ok(Ok(())) = timeout(SILENT, self.messages.changed()).await {}
    }
}

/// Holds a button until it is released, or no message arrives within the dead-man time.
async fn hold(
    station: &mut StationClient,
    mut jog: Jog,
    messages: &mut watch::Receiver<JogMessage>,
    ending: &mut watch::Receiver<bool>,
) -> Result<(), String> {
    let patience = station.dead_man();
    loop {
        let pressed = station.request(Request::Jog { jog }).await;
        pressed.map_err(|error| refused(&error))?;
        let next = next_message(station, messages, ending);
        match timeout(patience, next).await {
            Err(_) | Ok(None | Some(Ok(None))) => return Ok(()),
            Ok(Some(Ok(Some(next)))) => jog = next,
            Ok(Some(Err(why))) => return Err(why),
        }
    }
}

/// Waits for the next message; `None` at the end. Meanwhile it handles the events of the station.
async fn next_message(
    station: &mut StationClient,
    messages: &mut watch::Receiver<JogMessage>,
    ending: &mut watch::Receiver<bool>,
) -> JogMessage {
    loop {
        tokio::select! {
            changed = messages.changed() => {
                return changed.is_ok().then(|| messages.borrow_and_update().clone()).flatten();
            }
            event = station.next() => {
                if let Err(error) = event {
                    return Some(Err(refused(&error)));
                }
            }
            () = ended(ending) => return None,
        }
    }
}

/// The pause in messages after which a refused button may be pressed again.
const SILENT: std::time::Duration = std::time::Duration::from_millis(300);
