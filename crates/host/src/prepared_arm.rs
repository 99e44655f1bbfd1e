//! Before anything else is there, the arm is dark.

use std::io;
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

use dobot_controller::{Controller, Personality, PowerUp};
use dobot_session::{Address, Link};
use dobot_sim::world::{Scene, World};
use dobot_sim::{InProcess, SerialLine, Speed, VirtualArm};
use tokio::sync::Mutex;

use crate::OpenArmError;
use crate::arm_thread::ArmThread;
use crate::connect::{Connecting, Source};
use crate::finder::{Finder, Found, Search, darken};
use crate::watchdog::{PanicStop, wait_for_watchdog};

/// Which arm is wanted.
#[derive(Clone, Debug, PartialEq)]
pub struct WantedArm {
    /// Where it is. When absent, it is the first arm that is found, or a virtual one when there is
    /// none.
    pub address: Option<Address>,
    /// How a virtual arm behaves.
    pub personality: Personality,
    /// How fast time passes for a virtual arm.
    pub speed: Speed,
}

/// An arm whose rules are about to be set to work. Its laser was switched off, whatever becomes of
/// that: a power cut is what damages a journal, and what leaves a laser on.
#[derive(Debug)]
pub struct PreparedArm {
    pub(crate) thread: ArmThread,
    pub(crate) panic_stop: Arc<PanicStop>,
    pub(crate) source: Source,
    /// The arm, or why it is not there.
    pub(crate) first: Option<Connecting>,
    /// What a person should know, a line each.
    pub(crate) notes: Vec<String>,
}

impl PreparedArm {
    /// Opens the port that is named, or looks for one with an arm, and switches the laser off there.
    /// Without an arm there is a virtual one. It waits until the watchdog of a program that was killed
    /// just now has let go of the port.
    ///
    /// # Errors
    ///
    /// What the operating system says that has no thread left for the arm.
    ///
    /// # Panics
    ///
    /// Outside of a tokio runtime.
    pub async fn new(arm: &WantedArm, note: &Path) -> io::Result<Self> {
        let mut prepared = Self::with_source(port(arm.address.as_ref()))?;
        wait_for_watchdog(note).await;
        match arm.address {
            Some(Address::Virtual) => prepared.use_virtual(arm),
            Some(_) => prepared.open_named().await,
            None => prepared.search(arm).await,
        }
        Ok(prepared)
    }

    /// Opens the port of an arm, and switches its laser off.
    ///
    /// # Errors
    ///
    /// Where the port cannot be opened, or the system has no thread left for the arm.
    pub(crate) async fn open(address: &Address) -> Result<Self, OpenArmError> {
        let mut link = Link::open(address).await?;
        darken(&mut link).await;
        let found = Found {
            address: address.clone(),
            link,
            bytes: Vec::new(),
        };
        let mut prepared = Self::with_source(port(Some(address))).map_err(OpenArmError::Thread)?;
        prepared.first = Some(Connecting::Up(found));
        Ok(prepared)
    }

    /// Where the arm is, as far as that is known.
    #[must_use]
    pub fn address(&self) -> Option<Address> {
        match self.source {
            Source::Virtual { .. } => Some(Address::Virtual),
            Source::Port(_) => self.first.as_ref().and_then(Connecting::address),
        }
    }

    fn with_source(source: Source) -> io::Result<Self> {
        let panic_stop = Arc::new(PanicStop::default());
        Ok(Self {
            thread: ArmThread::start(panic_stop.clone())?,
            panic_stop,
            source,
            first: None,
            notes: Vec::new(),
        })
    }

    /// Opens the port that is named. An arm that runs is heard at once; the station goes on to wait
    /// for any other.
    async fn open_named(&mut self) {
        let mut news = self.source.connect(self.thread.runtime());
        self.first = match tokio::time::timeout(SOON, news.recv()).await {
            Ok(first) => first,
            Err(_) => Some(Connecting::Begun(news)),
        };
    }

    /// Looks for an arm; without one there is a virtual arm.
    async fn search(&mut self, arm: &WantedArm) {
        let mut news = self.source.connect(self.thread.runtime());
        match news.recv().await {
            Some(Connecting::Waiting(nothing)) => {
                self.notes.push(nothing);
                self.use_virtual(arm);
            }
            first => self.first = first,
        }
    }

    /// A virtual arm that lives as long as the station.
    fn use_virtual(&mut self, wanted: &WantedArm) {
        let controller = Controller::power_up(PowerUp::new(wanted.personality));
        let scene = Scene::parse(DESK).expect("the desk is a scene");
        let arm = VirtualArm::new(controller, SerialLine::STOCK).with_world(World::new(scene));
        self.source = Source::Virtual {
            arm: InProcess::new(arm),
            personality: wanted.personality,
            speed: wanted.speed,
        };
    }
}

/// A port that is named, or any.
fn port(address: Option<&Address>) -> Source {
    let finder = Finder::new(Search {
        named: address.into_iter().cloned().collect(),
        ..Search::default()
    });
    Source::Port(Arc::new(Mutex::new(finder)))
}

/// An arm that runs tells its state within that time, over TCP too.
const SOON: Duration = Duration::from_millis(500);

/// What is around a virtual arm until somebody puts it elsewhere: a sheet of paper under its pen.
const DESK: &str = "
[paper]
x_mm = [140, 280]
y_mm = [-110, 110]

[pen]
down_z_mm = -40
give_mm = 2
width_mm = 0.5
";
