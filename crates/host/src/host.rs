//! The host: the driver of one arm with everything it needs.

use std::path::PathBuf;
use std::sync::Arc;

use dobot_api::Folders;
use dobot_controller::Personality;
use dobot_journal::{Journal, JournalError};
use dobot_safety::Policy;
use dobot_sim::Speed;
use dobot_supervisor::Supervisor;
use dobot_wire::Dialect;

use crate::arm_thread::RunningArmThread;
use crate::connect::{OwnVirtualArm, Source};
use crate::data_format::{DataFormat, DataFormatError};
use crate::disk::Disk;
use crate::driver::{Driver, DriverParts};
use crate::handle::{Rules, StationHandle};
use crate::jobs::Jobs;
use crate::known_arms::{KnownArms, KnownArmsError};
use crate::prepared_arm::PreparedArm;
use crate::recording::{self, Recording};
use crate::saved_slots::SavedSlots;
use crate::saved_stop::SavedStop;
use crate::service_manager::ServiceManager;
use crate::watchdog::{HeartbeatSender, take_note};

/// The policy for an arm and the places of its data.
#[derive(Debug)]
pub struct Setup {
    /// The policy.
    pub policy: Policy,
    /// The dialect. If absent, the one known for this arm; a virtual arm speaks its personality's
    /// dialect, and any other one is undecided.
    pub dialect: Option<Dialect>,
    /// The folders of the jobs and of the watchdog's note.
    pub folders: Folders,
    /// The folders of recordings and known arms, shared by all arms of a user.
    pub common: Folders,
    /// The file of the stop, so that it still holds at the next start; optional.
    pub stop: Option<PathBuf>,
    /// The watchdog program, started as `PROGRAM watchdog --note FILE`; optional.
    pub watchdog: Option<PathBuf>,
    /// The service manager that monitors the arm thread, if any.
    pub service_manager: Option<ServiceManager>,
}

/// The running supervisor of one arm, in its own thread.
#[derive(Debug)]
pub struct Host {
    handle: StationHandle,
    virtual_arm: Option<OwnVirtualArm>,
    thread: RunningArmThread,
    notes: Vec<String>,
    watchdog_reports: Vec<String>,
}

/// Why the host could not be started.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum HostError {
    /// A folder cannot be created.
    #[error("cannot make the folder {folder}")]
    Folder {
        /// The folder.
        folder: String,
        /// The operating system's error.
        #[source]
        source: std::io::Error,
    },
    /// The data folder cannot be used.
    #[error(transparent)]
    DataFormat(#[from] DataFormatError),
    /// The journal of jobs cannot be opened.
    #[error(transparent)]
    Journal(#[from] JournalError),
    /// The operating system has no thread left.
    #[error("no thread can be started for the disk")]
    Thread(#[source] std::io::Error),
    /// The file of known arms cannot be read.
    #[error(transparent)]
    KnownArms(#[from] KnownArmsError),
}

impl Host {
    /// Starts the supervisor for an arm whose laser is off; restores an interrupted job.
    ///
    /// # Errors
    ///
    /// [`HostError`]; nothing keeps running.
    pub fn start(prepared_arm: PreparedArm, setup: Setup) -> Result<Self, HostError> {
        make_folder(&setup.folders)?;
        for folders in [&setup.common, &setup.folders] {
            DataFormat::claim(folders)?;
        }
        let arms = KnownArms::read(&setup.common.arms())?;
        let journal = Journal::open(&setup.folders.journal())?;
        let source = prepared_arm.source;
        let virtual_arm = source.virtual_arm();
        let supervisor = supervisor(&setup, &source);
        let (handle, channels) = StationHandle::new(supervisor.state(), Rules::of(&setup.policy));
        let own = handle.messages.clone();
        let disk = Disk::start(own.clone()).map_err(HostError::Thread)?;
        let (recorder, trouble) = recording::start(&setup.common);
        let personality = source
            .personality()
            .map(|personality| personality.to_string());
        let note = setup.folders.watchdog();
        let heartbeats =
            HeartbeatSender::new(setup.watchdog, note.clone(), prepared_arm.panic_stop);
        let mut driver = Driver::new(DriverParts {
            supervisor,
            channels,
            source,
            arms,
            slots: SavedSlots::at(&setup.folders.slots()),
            stop: setup.stop.map(SavedStop::at),
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
            watchdog_reports: take_note(&note),
            thread: prepared_arm.thread.run(driver, prepared_arm.first),
        })
    }

    /// Returns the handle.
    #[must_use]
    pub const fn handle(&self) -> &StationHandle {
        &self.handle
    }

    /// Returns the station's own virtual arm, if any.
    #[must_use]
    pub const fn virtual_arm(&self) -> Option<&OwnVirtualArm> {
        self.virtual_arm.as_ref()
    }

    /// Returns lines to show to a person: why no arm was found, or what cannot be recorded.
    #[must_use]
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// Returns the reports of watchdogs since the arm was last used, one per line.
    #[must_use]
    pub fn watchdog_reports(&self) -> &[String] {
        &self.watchdog_reports
    }

    /// Spawns a task on the arm thread; it ends with the host.
    pub fn spawn(&self, task: impl Future<Output = ()> + Send + 'static) {
        self.thread.spawn(task);
    }

    /// Ends the station: laser off first, then in-flight commands finish, then journal and
    /// recording are closed.
    ///
    /// # Errors
    ///
    /// The failure of something that the arm depends on, in one line.
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
    let policy = scaled_to_arm_time(&setup.policy, source.speed());
    let own = source.personality().map(Personality::dialect);
    Supervisor::new(policy, setup.dialect.or(own))
}

/// Scales the times of jogging, because a hand on a button does not get faster with the simulation.
pub(crate) fn scaled_to_arm_time(policy: &Policy, speed: Speed) -> Policy {
    let mut policy = policy.clone();
    policy.jog.dead_man_s *= speed.times();
    policy.jog.raw_dead_man_s *= speed.times();
    policy
}
