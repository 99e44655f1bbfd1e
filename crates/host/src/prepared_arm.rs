//! An arm whose laser is switched off before anything else starts.

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

/// The arm to use.
#[derive(Clone, Debug, PartialEq)]
pub struct ArmSelection {
    /// The address. If absent, the first arm that is found, otherwise a virtual one.
    pub address: Option<Address>,
    /// The personality of a virtual arm.
    pub personality: Personality,
    /// The simulation speed of a virtual arm.
    pub speed: Speed,
}

/// An arm before its supervisor starts. Its laser was switched off, whatever happens next: a power
/// cut may damage a journal and leave a laser on.
#[derive(Debug)]
pub struct PreparedArm {
    pub(crate) thread: ArmThread,
    pub(crate) panic_stop: Arc<PanicStop>,
    pub(crate) source: Source,
    /// The arm, or why it is missing.
    pub(crate) first: Option<Connecting>,
    /// Lines to show to a person.
    pub(crate) notes: Vec<String>,
}

impl PreparedArm {
    /// Opens the named port, or searches for one with an arm, and switches the laser off. If there
    /// is no arm, uses a virtual one. Waits until the watchdog of a program that was just killed
    /// has released the port.
    ///
    /// # Errors
    ///
    /// The operating system's error if no thread can be started for the arm.
    ///
    /// # Panics
    ///
    /// Outside of a tokio runtime.
    pub async fn new(arm: &ArmSelection, note: &Path) -> io::Result<Self> {
        let mut prepared = Self::with_source(port(arm.address.as_ref()))?;
        wait_for_watchdog(note).await;
        match arm.address {
            Some(Address::Virtual) => prepared.use_virtual(arm),
            Some(_) => prepared.open_named().await,
            None => prepared.search(arm).await,
        }
        Ok(prepared)
    }

    /// Opens the port of an arm and switches its laser off.
    ///
    /// # Errors
    ///
    /// If the port cannot be opened, or no thread can be started for the arm.
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

    /// Returns the address of the arm, if known.
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

    /// Opens the named port. A running arm is received immediately; the station keeps waiting for
    /// any other.
    async fn open_named(&mut self) {
        let mut news = self.source.connect(self.thread.runtime());
        self.first = match tokio::time::timeout(SOON, news.recv()).await {
            Ok(first) => first,
            Err(_) => Some(Connecting::Begun(news)),
        };
    }

    /// Searches for an arm; without one, uses a virtual arm.
    async fn search(&mut self, arm: &ArmSelection) {
        let mut news = self.source.connect(self.thread.runtime());
        match news.recv().await {
            Some(Connecting::Waiting(nothing)) => {
                self.notes.push(nothing.to_string());
                self.use_virtual(arm);
            }
            first => self.first = first,
        }
    }

    /// Uses a virtual arm that lives as long as the station.
    fn use_virtual(&mut self, wanted: &ArmSelection) {
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

/// Returns the source for a named port, or any.
fn port(address: Option<&Address>) -> Source {
    let finder = Finder::new(Search {
        named: address.into_iter().cloned().collect(),
        ..Search::default()
    });
    Source::Port(Arc::new(Mutex::new(finder)))
}

/// A running arm sends a status within this time, also over TCP.
const SOON: Duration = Duration::from_millis(500);

/// The initial surroundings of a virtual arm: a sheet of paper under its pen.
const DESK: &str = "
[paper]
x_mm = [140, 280]
y_mm = [-110, 110]

[pen]
down_z_mm = -40
give_mm = 2
width_mm = 0.5
";
