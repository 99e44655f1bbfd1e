//! Where the arm comes from: a port that is named or looked for, or a virtual arm of the station.

use std::sync::Arc;

use dobot_controller::{Personality, PowerUp};
use dobot_session::{Address, Link};
use dobot_sim::{InProcess, Speed};
use tokio::runtime::Handle;
use tokio::sync::{Mutex, mpsc};
use tokio::time::{Instant, sleep_until};

use crate::{Finder, Found, Reconnect};

/// Where the arm comes from.
#[derive(Clone, Debug)]
pub(crate) enum Source {
    /// A port that is named or looked for.
    Port(Arc<Mutex<Finder>>),
    /// The station's own virtual arm.
    Virtual {
        arm: InProcess,
        personality: Personality,
        /// How many times as fast as a clock it lives.
        speed: Speed,
    },
}

/// The station's own virtual arm: to look at its world, and to let things go wrong.
#[derive(Clone, Debug)]
pub struct OwnVirtualArm {
    /// The arm.
    pub arm: InProcess,
    /// How its controller was switched on.
    pub power_up: PowerUp,
}

/// What is told while there is no link.
#[derive(Debug)]
pub(crate) enum Connecting {
    /// The port is open.
    Up(Found),
    /// Not yet, and why.
    Waiting(String),
    /// It is being looked for already.
    Begun(mpsc::Receiver<Self>),
}

impl Connecting {
    /// Where the arm is, if it is there.
    pub(crate) fn address(&self) -> Option<Address> {
        match self {
            Self::Up(found) => Some(found.address.clone()),
            Self::Waiting(_) | Self::Begun(_) => None,
        }
    }
}

impl Source {
    /// Looks for the arm until it is there, in a task of its own that ends with its receiver.
    pub(crate) fn connect(&self, runtime: &Handle) -> mpsc::Receiver<Connecting> {
        let (tell, news) = mpsc::channel(4);
        runtime.spawn(connect(self.clone(), tell));
        news
    }

    /// Whether it is the station's own virtual arm.
    pub(crate) const fn is_virtual(&self) -> bool {
        matches!(self, Self::Virtual { .. })
    }

    /// The station's own virtual arm, if that is it.
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

    /// How the station's own virtual arm behaves.
    pub(crate) const fn personality(&self) -> Option<Personality> {
        match self {
            Self::Virtual { personality, .. } => Some(*personality),
            Self::Port(_) => None,
        }
    }

    /// How fast time passes for the arm.
    pub(crate) const fn speed(&self) -> Speed {
        match self {
            Self::Virtual { speed, .. } => *speed,
            Self::Port(_) => Speed::REAL,
        }
    }
}

async fn connect(source: Source, tell: mpsc::Sender<Connecting>) {
    let started = Instant::now();
    let mut again = Reconnect::lost(started.elapsed());
    loop {
        let news = attempt(&source).await;
        let up = matches!(news, Connecting::Up(_));
        if tell.send(news).await.is_err() || up {
            return;
        }
        again.handle_failure(started.elapsed());
        tokio::select! {
            () = sleep_until(started + again.poll_wakeup()) => {}
            () = tell.closed() => return,
        }
    }
}

/// Tries once.
async fn attempt(source: &Source) -> Connecting {
    match source {
        Source::Virtual { arm, speed, .. } => Connecting::Up(Found {
            address: Address::Virtual,
            link: Link::over_paced_peer(arm.clone(), speed.times()),
            bytes: Vec::new(),
        }),
        Source::Port(finder) => match finder.lock().await.find(|_| ()).await {
            Ok(found) => Connecting::Up(found),
            Err(nothing) => Connecting::Waiting(nothing.to_string()),
        },
    }
}
