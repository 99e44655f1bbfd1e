//! The rules for one arm, at work: the driver of its port with all that he needs.

use std::path::PathBuf;
use std::sync::Arc;

use dobot_api::Folders;
use dobot_controller::Personality;
use dobot_journal::{Journal, JournalError};
use dobot_safety::Policy;
use dobot_sim::Speed;
use dobot_supervisor::Supervisor;
use dobot_wire::Dialect;

use crate::arm_thread::ArmAtWork;
use crate::connect::{OwnVirtualArm, Source};
use crate::disk::Disk;
use crate::driver::{Driver, DriverParts};
use crate::handle::{Rules, StationHandle};
use crate::jobs::Jobs;
use crate::kept_slots::KeptSlots;
use crate::kept_stop::KeptStop;
use crate::known_arms::{KnownArms, KnownArmsError};
use crate::prepared_arm::PreparedArm;
use crate::recording::{self, Recording};
use crate::service_manager::ServiceManager;
use crate::watchdog::{HeartbeatSender, take_note};

/// By which rules an arm is used, and where what has to be remembered is kept.
#[derive(Debug)]
pub struct Setup {
    /// The rules.
    pub policy: Policy,
    /// What the arm understands. When absent, it is what was found out about this arm before; a
    /// virtual arm speaks as its personality does, and any other one is undecided.
    pub dialect: Option<Dialect>,
    /// Where the jobs are kept, and what the watchdog did.
    pub folders: Folders,
    /// Where recordings are kept, and what is known of each arm: the same for all arms of a person.
    pub common: Folders,
    /// Where a stop is kept, so that it holds at the next start too, if it is.
    pub stop: Option<PathBuf>,
    /// The program that guards the arm when it is started as `PROGRAM watchdog --note FILE`, if one
    /// does.
    pub watchdog: Option<PathBuf>,
    /// Who keeps the program running, where that wants to know that the arm's thread is at work.
    pub service_manager: Option<ServiceManager>,
}

/// The rules for one arm, at work in a thread of their own.
#[derive(Debug)]
pub struct Host {
    handle: StationHandle,
    virtual_arm: Option<OwnVirtualArm>,
    thread: ArmAtWork,
    notes: Vec<String>,
    of_watchdog: Vec<String>,
}

/// Why the rules are not at work.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum HostError {
    /// A folder cannot be made.
    #[error("cannot make the folder {folder}")]
    Folder {
        /// The folder.
        folder: String,
        /// Why.
        #[source]
        source: std::io::Error,
    },
    /// The journal of jobs cannot be opened.
    #[error(transparent)]
    Journal(#[from] JournalError),
    /// The operating system has no thread left.
    #[error("no thread can be started for the disk")]
    Thread(#[source] std::io::Error),
    /// What is known of arms cannot be read.
    #[error(transparent)]
    KnownArms(#[from] KnownArmsError),
}

impl Host {
    /// Sets the rules to work at an arm that is dark; a job that was interrupted is taken up.
    ///
    /// # Errors
    ///
    /// [`HostError`]; nothing is left running then.
    pub fn start(prepared_arm: PreparedArm, setup: Setup) -> Result<Self, HostError> {
        make_folder(&setup.folders)?;
        let arms = KnownArms::read(&setup.common.arms())?;
        let journal = Journal::open(&setup.folders.journal())?;
        let source = prepared_arm.source;
        let virtual_arm = source.virtual_arm();
        let supervisor = supervisor(&setup, &source);
        let (handle, channels) = StationHandle::new(supervisor.state(), Rules::of(&setup.policy));
        let own = handle.messages.clone();
        let disk = Disk::start(own.clone()).map_err(HostError::Thread)?;
        let (recorder, trouble) = recording::start(&setup.common);
        let personality = source.personality().map(|it| it.to_string());
        let note = setup.folders.watchdog();
        let heartbeats =
            HeartbeatSender::new(setup.watchdog, note.clone(), prepared_arm.panic_stop);
        let mut driver = Driver::new(DriverParts {
            supervisor,
            channels,
            source,
            arms,
            slots: KeptSlots::at(&setup.folders.slots()),
            stop: setup.stop.map(KeptStop::at),
            disk,
            jobs: Jobs::new(journal, Arc::new(setup.policy), own.clone()),
            recording: Recording::new(recorder, personality),
            own,
            heartbeats: heartbeats.supervised(setup.service_manager.unwrap_or_default()),
        });
        let notes = prepared_arm.notes.into_iter().chain(trouble);
        driver.recover_stop();
        Ok(Self {
            handle,
            virtual_arm,
            notes: notes
                .chain(driver.recover().err())
                .chain(driver.recover_slots().err())
                .collect(),
            of_watchdog: take_note(&note),
            thread: prepared_arm.thread.run(driver, prepared_arm.first),
        })
    }

    /// How to talk to it.
    #[must_use]
    pub const fn handle(&self) -> &StationHandle {
        &self.handle
    }

    /// The own virtual arm, if the arm is that.
    #[must_use]
    pub const fn virtual_arm(&self) -> Option<&OwnVirtualArm> {
        self.virtual_arm.as_ref()
    }

    /// What a person should know, a line each: why no arm was found, what cannot be recorded.
    #[must_use]
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// What a watchdog had to do since the arm was used last, a line each.
    #[must_use]
    pub fn of_watchdog(&self) -> &[String] {
        &self.of_watchdog
    }

    /// Lets something else run in the arm's thread: it ends with the rules.
    pub fn spawn(&self, task: impl Future<Output = ()> + Send + 'static) {
        self.thread.spawn(task);
    }

    /// Ends the station: laser off first, then what is under way comes to its end, then journal and recording
    /// are closed.
    ///
    /// # Errors
    ///
    /// What failed that the arm depends on, in one line.
    pub async fn end(self) -> Result<(), String> {
        self.handle.end().await;
        self.thread.ended().await
    }
}

fn make_folder(folders: &Folders) -> Result<(), HostError> {
    folders.make_data().map_err(|source| HostError::Folder {
        folder: folders.data().display().to_string(),
        source,
    })
}

fn supervisor(setup: &Setup, source: &Source) -> Supervisor {
    let policy = in_time_of_arm(&setup.policy, source.speed());
    let own = source.personality().map(Personality::dialect);
    Supervisor::new(policy, setup.dialect.or(own))
}

/// A hand on a button is as fast as ever, however fast the arm lives.
pub(crate) fn in_time_of_arm(policy: &Policy, speed: Speed) -> Policy {
    let mut policy = policy.clone();
    policy.jog.dead_man_s *= speed.times();
    policy.jog.raw_dead_man_s *= speed.times();
    policy
}
