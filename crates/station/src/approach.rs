//! Before anything else of a station is there, its arm is dark.

use std::sync::Arc;
use std::time::Duration;

use dobot_client::Address;
use dobot_controller::{Controller, PowerUp};
use dobot_sim::{InProcess, Line, VirtualArm};
use tokio::sync::Mutex;

use crate::arm_thread::ArmThread;
use crate::connect::{Connecting, Source};
use crate::guardian::{LastWords, wait_for_guardian};
use crate::{Config, Finder, Search, StartError};

/// The arm of a station that is about to start. Its laser was switched off, whatever becomes of the
/// start: a power cut is what damages a journal, and what leaves a laser on.
#[derive(Debug)]
pub struct Approach {
    pub(crate) config: Config,
    pub(crate) thread: ArmThread,
    pub(crate) words: Arc<LastWords>,
    pub(crate) source: Source,
    /// The arm, or why it is not there.
    pub(crate) first: Option<Connecting>,
    /// What a person should know, a line each.
    pub(crate) notes: Vec<String>,
}

impl Approach {
    /// Opens the port that is named, or looks for one with an arm, and switches the laser off there.
    /// Without an arm there is a virtual one. It waits until the guardian of a station that was killed
    /// just now has let go of the port.
    ///
    /// # Errors
    ///
    /// [`StartError::Thread`].
    ///
    /// # Panics
    ///
    /// Outside of a tokio runtime.
    pub async fn new(config: Config) -> Result<Self, StartError> {
        let words = Arc::new(LastWords::default());
        let thread = ArmThread::start(words.clone()).map_err(StartError::Thread)?;
        wait_for_guardian(&config.folders.guardian()).await;
        let mut approach = Self {
            source: Source::Port(Arc::new(Mutex::new(finder(&config)))),
            config,
            thread,
            words,
            first: None,
            notes: Vec::new(),
        };
        match approach.config.arm {
            Some(Address::Virtual) => approach.take_virtual(),
            Some(_) => approach.knock().await,
            None => approach.look().await,
        }
        Ok(approach)
    }

    /// Opens the port that is named. An arm that runs is heard at once; the station goes on to wait
    /// for any other.
    async fn knock(&mut self) {
        let mut news = self.source.connect(self.thread.runtime());
        self.first = match tokio::time::timeout(SOON, news.recv()).await {
            Ok(first) => first,
            Err(_) => Some(Connecting::Begun(news)),
        };
    }

    /// Looks for an arm; without one there is a virtual arm.
    async fn look(&mut self) {
        let mut news = self.source.connect(self.thread.runtime());
        match news.recv().await {
            Some(Connecting::Waiting(nothing)) => {
                self.notes.push(nothing);
                self.take_virtual();
            }
            first => self.first = first,
        }
    }

    /// A virtual arm that lives as long as the station.
    fn take_virtual(&mut self) {
        let controller = Controller::power_up(PowerUp::new(self.config.personality));
        let arm = VirtualArm::new(controller, Line::STOCK);
        self.source = Source::Virtual {
            arm: InProcess::new(arm),
            times: self.config.speed.times(),
        };
    }
}

fn finder(config: &Config) -> Finder {
    Finder::new(Search {
        named: config.arm.iter().cloned().collect(),
        ..Search::default()
    })
}

/// An arm that runs tells its state within that time, over TCP too.
const SOON: Duration = Duration::from_millis(500);
