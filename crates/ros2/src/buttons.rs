//! Jogs: an axis moves for as long as somebody says so.

use std::sync::Arc;

use dobot_api::{Jog, Request};
use dobot_host::StationClient;
use tokio::sync::watch;
use tokio::time::timeout;

use crate::acts::{ended, take};
use crate::station::{Station, refused};
use crate::told::Told;

/// What was said last of a jog: the button, or that none is pressed, or what is wrong with what was said.
pub(crate) type Said = Option<Result<Option<Jog>, String>>;

/// Presses the buttons that are said, for as long as they are said again.
pub(crate) struct Buttons {
    pub(crate) station: Station,
    pub(crate) told: Arc<Told>,
    pub(crate) said: watch::Receiver<Said>,
    pub(crate) ending: watch::Receiver<bool>,
}

impl Buttons {
    /// For as long as somebody may say something.
    pub(crate) async fn run(mut self) {
        while self.said.changed().await.is_ok() {
            let said = self.said.borrow_and_update().clone();
            let refused = match said {
                None | Some(Ok(None)) => continue,
                Some(Ok(Some(jog))) => self.press(jog).await.err(),
                Some(Err(why)) => Some(why),
            };
            if let Some(why) = refused {
                self.told.warn(&format!("jog: {why}"));
                // No arm begins to move because a limit went away while a stick was held: it is let go first.
                self.silence().await;
            }
        }
    }

    async fn press(&mut self, jog: Jog) -> Result<(), String> {
        let mut station = self.station.connect("jog").await?;
        take(&mut station).await?;
        let held = hold(&mut station, jog, &mut self.said, &mut self.ending).await;
        // Silence lets it go too, a little later.
        station.request(Request::Release).await.ok();
        held
    }

    /// Until nothing is said any more.
    async fn silence(&mut self) {
        while let Ok(Ok(())) = timeout(SILENT, self.said.changed()).await {}
    }
}

/// Holds a button until it is said that none is pressed, or nothing is said for the dead-man time.
async fn hold(
    station: &mut StationClient,
    mut jog: Jog,
    said: &mut watch::Receiver<Said>,
    ending: &mut watch::Receiver<bool>,
) -> Result<(), String> {
    let patience = station.dead_man();
    loop {
        let pressed = station.request(Request::Jog { jog }).await;
        pressed.map_err(|error| refused(&error))?;
        let next = async {
            loop {
                tokio::select! {
                    changed = said.changed() => {
                        return changed.is_ok().then(|| said.borrow_and_update().clone()).flatten();
                    }
                    event = station.next() => {
                        if let Err(error) = event {
                            return Some(Err(refused(&error)));
                        }
                    }
                    () = ended(ending) => return None,
                }
            }
        };
        match timeout(patience, next).await {
            Err(_) | Ok(None | Some(Ok(None))) => return Ok(()),
            Ok(Some(Ok(Some(next)))) => jog = next,
            Ok(Some(Err(why))) => return Err(why),
        }
    }
}

/// So long nothing is said before a button that was refused may be pressed anew.
const SILENT: std::time::Duration = std::time::Duration::from_millis(300);
