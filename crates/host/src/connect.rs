//! The source of the arm: a port that is named or searched for, or the station's virtual arm.

use std::sync::Arc;

use dobot_api::LinkProblem;
use dobot_controller::{Personality, PowerUp};
use dobot_session::{Address, Link};
use dobot_sim::{InProcess, Speed};
use tokio::runtime::Handle;
use tokio::sync::{Mutex, mpsc};
use tokio::time::{Instant, sleep_until};

use crate::{Finder, Found, Reconnect};

/// The source of the arm.
#[derive(Clone, Debug)]
pub(crate) enum Source {
    /// A port that is named or searched for.
    Port(Arc<Mutex<Finder>>),
    /// The station's own virtual arm.
    Virtual {
        arm: InProcess,
        personality: Personality,
        /// Its simulation speed, as a factor of real time.
        speed: Speed,
    },
}

/// The station's own virtual arm: to inspect its world and to inject faults.
#[derive(Clone, Debug)]
pub struct OwnVirtualArm {
    /// The arm.
    pub arm: InProcess,
    /// The power-up of its controller.
    pub power_up: PowerUp,
}

/// The progress of connecting.
#[derive(Debug)]
pub(crate) enum Connecting {
    /// The port is open.
    Up(Found),
    /// Not yet, and why.
    Waiting(LinkProblem),
    /// A search is already running.
    Begun(mpsc::Receiver<Self>),
}

impl Connecting {
    /// Returns the address of the arm, if connected.
    pub(crate) fn address(&self) -> Option<Address> {
        match self {
            Self::Up(found) => Some(found.address.clone()),
            Self::Waiting(_) | Self::Begun(_) => None,
        }
    }
}

impl Source {
    /// Searches for the arm until it is found, in a task that ends with its receiver.
    pub(crate) fn connect(&self, runtime: &Handle) -> mpsc::Receiver<Connecting> {
        let (sender, news) = mpsc::channel(4);
        runtime.spawn(connect(self.clone(), sender));
        news
    }

    /// Returns whether this is the station's own virtual arm.
    pub(crate) const fn is_virtual(&self) -> bool {
        matches!(self, Self::Virtual { .. })
    }

    /// Returns the station's own virtual arm, if any.
    pub(crate) fn virtual_arm(&self) -> Option<OwnVirtualArm> {
        match self {
            Self::Virtual {
                arm, personality, ..
            } => Some(OwnVirtualArm {
                arm: arm.clone(),
                power_up: PowerUp::new(*personality),
            }),
            Self::Port(_) => None,
        }
    }

    /// Returns the personality of the station's own virtual arm.
    pub(crate) const fn personality(&self) -> Option<Personality> {
        match self {
            Self::Virtual { personality, .. } => Some(*personality),
            Self::Port(_) => None,
        }
    }

    /// Returns the simulation speed.
    pub(crate) const fn speed(&self) -> Speed {
        match self {
            Self::Virtual { speed, .. } => *speed,
            Self::Port(_) => Speed::REAL,
        }
    }
}

async fn connect(source: Source, sender: mpsc::Sender<Connecting>) {
    let started = Instant::now();
    let mut again = Reconnect::lost(started.elapsed());
    loop {
        let news = attempt(&source).await;
        let up = matches!(news, Connecting::Up(_));
        if sender.send(news).await.is_err() || up {
            return;
        }
        again.handle_failure(started.elapsed());
        tokio::select! {
            () = sleep_until(started + again.poll_wakeup()) => {}
            () = sender.closed() => return,
        }
    }
}

/// Makes one attempt.
async fn attempt(source: &Source) -> Connecting {
    match source {
        Source::Virtual { arm, speed, .. } => Connecting::Up(Found {
            address: Address::Virtual,
            link: Link::over_paced_peer(arm.clone(), speed.times()),
            bytes: Vec::new(),
        }),
        Source::Port(finder) => match finder.lock().await.find(|_| ()).await {
            Ok(found) => Connecting::Up(found),
            Err(nothing) => Connecting::Waiting(nothing.problem()),
        },
    }
}
