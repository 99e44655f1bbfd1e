//! The journal of jobs.

use std::path::Path;
use std::sync::{Mutex, MutexGuard, PoisonError};

use dobot_api::JobState;
use dobot_wire::Command;
use redb::{ReadOnlyTable, ReadTransaction, ReadableTable, StorageBackend, WriteTransaction};

use crate::new_rows::NewRows;
use crate::offers::keep_outcome;
use crate::rows::{self, JobRow};
use crate::store::{
    CLEAN_FACT, COMMANDS, FACTS, FORMAT, FORMAT_FACT, JOBS, MISSING_FACT, OFFERS, PLACES, REFUSALS,
    STEPS, Store, WINDOWS, fact,
};
use crate::{Adjustment, Behind, Job, JobId, JournalError, PlannedJob, Window};

/// Jobs that survive a crash and a power cut, in one file.
///
/// What a method has acknowledged with `Ok` is on the disk, whole; what it has not is there as a
/// whole or not at all. Each change waits for the disk: some milliseconds.
///
/// After an error the next call opens the file anew, so the journal works again as soon as its
/// storage does. Where the storage lets it read, jobs can still be read.
#[derive(Debug)]
pub struct Journal {
    store: Mutex<Store>,
    was_clean: bool,
    missing_writes: u64,
}

impl Journal {
    /// Opens the journal in a file, or makes it where there is none; its folder must exist.
    ///
    /// A journal that a crash has left behind is repaired. From now on it counts as not clean,
    /// until [`Journal::note_clean_shutdown`].
    ///
    /// # Errors
    ///
    /// [`JournalError`] where the file is something else, damaged, or open in another program;
    /// nothing in it is changed then.
    pub fn open(path: &Path) -> Result<Self, JournalError> {
        Self::with_store(Store::open(path)?)
    }

    /// A journal that is forgotten with the program.
    ///
    /// # Errors
    ///
    /// [`JournalError`] where there is no memory for it.
    pub fn in_memory() -> Result<Self, JournalError> {
        Self::with_store(Store::in_memory()?)
    }

    /// A journal on other storage than a file: what disks do wrong can be tried with it.
    ///
    /// `storage` hands the storage out, and again after it has failed.
    ///
    /// # Errors
    ///
    /// As [`Journal::open`].
    pub fn with_backend<B: StorageBackend>(
        storage: impl Fn() -> B + Send + Sync + 'static,
    ) -> Result<Self, JournalError> {
        Self::with_store(Store::with_backend(storage)?)
    }

    /// Whether the program that had it open before has called [`Journal::note_clean_shutdown`] as
    /// its last word. A new journal is clean.
    #[must_use]
    pub const fn was_clean(&self) -> bool {
        self.was_clean
    }

    /// How many of its last writes are missing, because the newest part of the file was damaged and what was before it is
    /// in force: the last queued jobs may be gone, or how far a job came. It is told until
    /// [`Journal::note_clean_shutdown`].
    #[must_use]
    pub const fn missing_writes(&self) -> u64 {
        self.missing_writes
    }

    /// Says that nothing is left to be put right: the arm rests, the laser is off.
    ///
    /// # Errors
    ///
    /// [`JournalError`] where the storage fails.
    pub fn note_clean_shutdown(&self) -> Result<(), JournalError> {
        self.store().write(|change| note_clean(change, true))
    }

    /// Takes a job, which is queued. Where the journal has one that was asked for with the same key, it is that one.
    ///
    /// # Errors
    ///
    /// [`JournalError`] where a command or the lift makes no sense, another job was asked for with the same key, or the storage
    /// fails.
    pub fn submit(&self, job: &PlannedJob) -> Result<JobId, JournalError> {
        let rows = NewRows::of(job)?;
        let mut store = self.store();
        if let Some(id) = asked_before(&store.jobs()?, job)? {
            return Ok(id);
        }
        let mut id = 0;
        store.write(|change| {
            id = rows.insert(change)?;
            Ok(())
        })?;
        Ok(JobId(id))
    }

    /// All jobs: the oldest first, unless they were [arranged](Journal::arrange) otherwise.
    ///
    /// # Errors
    ///
    /// [`JournalError`] where the storage fails or a row makes no sense.
    pub fn jobs(&self) -> Result<Vec<Job>, JournalError> {
        self.store().jobs()
    }

    /// One job.
    ///
    /// # Errors
    ///
    /// [`JournalError::NoSuchJob`], or the storage fails.
    pub fn job(&self, id: JobId) -> Result<Job, JournalError> {
        self.store().job(id)
    }

    /// What a job is to do.
    ///
    /// # Errors
    ///
    /// [`JournalError::NoSuchJob`], or the storage fails.
    pub fn commands(&self, id: JobId) -> Result<Vec<Command>, JournalError> {
        let mut store = self.store();
        let row = store.row(id)?;
        let commands = store.read(|look| {
            let table = look.open_table(COMMANDS)?;
            let packets = table.get(id.0)?;
            Ok(rows::commands(
                packets.as_ref().map_or(&[][..], |it| it.value()),
                &row,
            ))
        })?;
        commands.map_err(|found| store.damaged(found))
    }

    /// How far a job has come.
    ///
    /// # Errors
    ///
    /// [`JournalError::NoSuchJob`], or the storage fails.
    pub fn progress(&self, id: JobId) -> Result<Window, JournalError> {
        self.job(id).map(|job| job.window)
    }

    /// Allows commands to be given to the arm: **only after this returned `Ok` may a command
    /// before `window.upto` be sent.** The job must be [`JobState::Running`].
    ///
    /// # Errors
    ///
    /// [`JournalError`] where the job does not run, the window leaves it or goes back behind what
    /// is done, or the storage fails. Nothing may be sent then that was not given before.
    pub fn extend_window(&self, id: JobId, window: &Window) -> Result<(), JournalError> {
        let start = rows::start_bytes(id, window.start.as_ref())?;
        let mut store = self.store();
        check_window(id, &store.row(id)?, store.window(id)?.completed, window)?;
        let row = (
            window.completed as u64,
            window.upto as u64,
            start.as_slice(),
        );
        store.write(|change| {
            change.open_table(WINDOWS)?.insert(id.0, row)?;
            Ok(())
        })
    }

    /// Says what became of a job.
    ///
    /// # Errors
    ///
    /// [`JournalError::NoSuchJob`], [`JournalError::NotRunning`] where one that is over was to run, or the storage
    /// fails.
    pub fn set_state(&self, id: JobId, state: &JobState) -> Result<(), JournalError> {
        self.change(id, |row| row.go_on(id, state))
    }

    /// The same, together with what the job has behind it.
    ///
    /// # Errors
    ///
    /// [`JournalError::NoSuchJob`], [`JournalError::Number`], or the storage fails.
    pub fn set_state_behind(
        &self,
        id: JobId,
        state: &JobState,
        behind: Behind,
    ) -> Result<(), JournalError> {
        finite("the time that it ran", behind.ran_s)?;
        self.change(id, |row| {
            row.go_on(id, state)?;
            row.behind = behind;
            Ok(())
        })
    }

    /// Keeps what a person has changed on a job. **Only after this returned `Ok` may a command be
    /// sent that is changed by it**: where the arm rests after a crash depends on it.
    ///
    /// # Errors
    ///
    /// [`JournalError::NoSuchJob`], [`JournalError::Number`], or the storage fails.
    pub fn adjust(&self, id: JobId, adjustment: &Adjustment) -> Result<(), JournalError> {
        finite("the speed", [adjustment.speed_percent])?;
        let heights = &adjustment.heights;
        finite(
            "a height",
            heights.iter().flat_map(|it| [it.begin_mm, it.offset_mm]),
        )?;
        self.change(id, |row| {
            row.adjustment = adjustment.clone();
            Ok(())
        })
    }

    pub(crate) fn change(
        &self,
        id: JobId,
        change: impl FnOnce(&mut JobRow) -> Result<(), JournalError>,
    ) -> Result<(), JournalError> {
        let mut store = self.store();
        let mut row = store.row(id)?;
        change(&mut row)?;
        let row = row.to_bytes();
        store.write(|change| {
            change.open_table(JOBS)?.insert(id.0, row.as_slice())?;
            Ok(())
        })
    }

    /// Puts jobs in another order among each other: the first one gets the first of the places in the list that
    /// they have now, and so on. All others stay where they are.
    ///
    /// # Errors
    ///
    /// [`JournalError::NoSuchJob`], or the storage fails.
    pub fn arrange(&self, order: &[JobId]) -> Result<(), JournalError> {
        let mut store = self.store();
        for id in order {
            store.row(*id)?;
        }
        store.write(|change| {
            let mut table = change.open_table(PLACES)?;
            let places = order.iter().map(|id| place(&table, id.0));
            let mut places = places.collect::<Result<Vec<_>, redb::Error>>()?;
            places.sort_unstable();
            for (id, place) in order.iter().zip(places) {
                table.insert(id.0, place)?;
            }
            Ok(())
        })
    }

    /// Forgets a job that is over, or that has not begun.
    ///
    /// # Errors
    ///
    /// [`JournalError::NoSuchJob`], [`JournalError::Unfinished`], or the storage fails.
    pub fn remove(&self, id: JobId) -> Result<(), JournalError> {
        let mut store = self.store();
        let state = store.row(id)?.state;
        if state.is_active() {
            return Err(JournalError::Unfinished { job: id, state });
        }
        store.write(|change| forget(change, &[id]))
    }

    /// Forgets the oldest jobs that are over until `most` of them are left, and tells how many it
    /// forgot. Jobs that are not over stay.
    ///
    /// # Errors
    ///
    /// [`JournalError`] where the storage fails.
    pub fn keep_last(&self, most: usize) -> Result<usize, JournalError> {
        let mut store = self.store();
        let jobs = store.jobs()?;
        let over = jobs.iter().filter(|job| job.state.is_over());
        let over: Vec<JobId> = over.map(|job| job.id).collect();
        let old = &over[..over.len().saturating_sub(most)];
        if !old.is_empty() {
            store.write(|change| forget(change, old))?;
        }
        Ok(old.len())
    }

    fn with_store(mut store: Store) -> Result<Self, JournalError> {
        let (format, clean) =
            store.read(|look| Ok((fact(look, FORMAT_FACT)?, fact(look, CLEAN_FACT)?)))?;
        if format > FORMAT {
            return Err(JournalError::Newer {
                file: store.file(),
                found: format,
                known: FORMAT,
            });
        }
        let missing = store.read(|look| fact(look, MISSING_FACT))? + store.missing_writes()?;
        store.write(|change| {
            // Jobs of the formats before are read as they are; what is written is of this one.
            let mut facts = change.open_table(FACTS)?;
            facts.insert(FORMAT_FACT, FORMAT)?;
            facts.insert(MISSING_FACT, missing)?;
            drop(facts);
            change.open_table(STEPS)?;
            change.open_table(PLACES)?;
            change.open_table(OFFERS)?;
            change.open_table(REFUSALS)?;
            note_clean(change, false)
        })?;
        Ok(Self {
            store: Mutex::new(store),
            was_clean: clean == 1,
            missing_writes: missing,
        })
    }

    /// A panic in the middle leaves nothing half: what is not committed is not there.
    pub(crate) fn store(&self) -> MutexGuard<'_, Store> {
        self.store.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Store {
    pub(crate) fn jobs(&mut self) -> Result<Vec<Job>, JournalError> {
        let jobs = self.read(|look| {
            let tables = JobTables::open(look)?;
            let jobs = tables.in_order()?.into_iter();
            let jobs = jobs.filter_map(|id| tables.job(id).transpose());
            jobs.collect::<Result<Vec<_>, redb::Error>>()
        })?;
        let jobs = jobs.into_iter().collect::<Result<Vec<_>, _>>();
        jobs.map_err(|found| self.damaged(found))
    }

    fn job(&mut self, id: JobId) -> Result<Job, JournalError> {
        let job = self.read(|look| JobTables::open(look)?.job(id))?;
        let job = job.ok_or(JournalError::NoSuchJob(id))?;
        job.map_err(|found| self.damaged(found))
    }

    fn window(&mut self, id: JobId) -> Result<Window, JournalError> {
        let window = self.read(|look| {
            let window = look.open_table(WINDOWS)?.get(id.0)?;
            Ok(window.map(|it| rows::window(it.value())))
        })?;
        let window = window.transpose().map_err(|found| self.damaged(found))?;
        Ok(window.unwrap_or_default())
    }

    fn row(&mut self, id: JobId) -> Result<JobRow, JournalError> {
        let row = self.read(|look| {
            let row = look.open_table(JOBS)?.get(id.0)?;
            Ok(row.map(|row| JobRow::from_bytes(row.value())))
        })?;
        let row = row.ok_or(JournalError::NoSuchJob(id))?;
        row.map_err(|found| self.damaged(found))
    }
}

/// What is known of jobs, but for their commands.
struct JobTables {
    rows: ReadOnlyTable<u64, &'static [u8]>,
    steps: ReadOnlyTable<u64, &'static [u8]>,
    windows: ReadOnlyTable<u64, (u64, u64, &'static [u8])>,
    places: ReadOnlyTable<u64, u64>,
}

impl JobTables {
    fn open(look: &ReadTransaction) -> Result<Self, redb::Error> {
        Ok(Self {
            rows: look.open_table(JOBS)?,
            steps: look.open_table(STEPS)?,
            windows: look.open_table(WINDOWS)?,
            places: look.open_table(PLACES)?,
        })
    }

    /// All jobs by their places in the list.
    fn in_order(&self) -> Result<Vec<JobId>, redb::Error> {
        let placed = self.rows.iter()?.map(|entry| {
            let job = entry?.0.value();
            Ok((place(&self.places, job)?, job))
        });
        let mut placed = placed.collect::<Result<Vec<_>, redb::Error>>()?;
        placed.sort_unstable();
        Ok(placed.into_iter().map(|(_, job)| JobId(job)).collect())
    }

    /// A job, or what of it makes no sense.
    fn job(&self, id: JobId) -> Result<Option<Result<Job, String>>, redb::Error> {
        let Some(row) = self.rows.get(id.0)? else {
            return Ok(None);
        };
        let steps = self.steps.get(id.0)?;
        let window = self.windows.get(id.0)?;
        let read = || {
            let steps = steps.map(|it| rows::steps(it.value())).transpose()?;
            let window = window.map(|it| rows::window(it.value())).transpose()?;
            let row = JobRow::from_bytes(row.value())?;
            row.job(id, steps.unwrap_or_default(), window.unwrap_or_default())
        };
        Ok(Some(read()))
    }
}

fn check_window(id: JobId, row: &JobRow, done: usize, window: &Window) -> Result<(), JournalError> {
    if row.state != JobState::Running {
        return Err(JournalError::NotRunning {
            job: id,
            state: row.state.clone(),
        });
    }
    let commands = row.total();
    if done <= window.completed && window.completed <= window.upto && window.upto <= commands {
        return Ok(());
    }
    Err(JournalError::Window {
        job: id,
        completed: window.completed,
        upto: window.upto,
        done,
        commands,
    })
}

/// JSON has no words for other numbers.
pub(crate) fn finite(
    name: &'static str,
    numbers: impl IntoIterator<Item = f64>,
) -> Result<(), JournalError> {
    match numbers.into_iter().find(|it| !it.is_finite()) {
        Some(found) => Err(JournalError::Number { name, found }),
        None => Ok(()),
    }
}

/// The place of a job in the list; that of one that was never moved is its number.
fn place(table: &impl ReadableTable<u64, u64>, job: u64) -> Result<u64, redb::Error> {
    Ok(table.get(job)?.map_or(job, |place| place.value()))
}

fn note_clean(change: &WriteTransaction, clean: bool) -> Result<(), redb::Error> {
    let mut facts = change.open_table(FACTS)?;
    facts.insert(CLEAN_FACT, u64::from(clean))?;
    if clean {
        facts.insert(MISSING_FACT, 0)?;
    }
    Ok(())
}

fn forget(change: &WriteTransaction, jobs: &[JobId]) -> Result<(), redb::Error> {
    for job in jobs {
        keep_outcome(change, *job)?;
    }
    let mut rows = change.open_table(JOBS)?;
    let mut commands = change.open_table(COMMANDS)?;
    let mut steps = change.open_table(STEPS)?;
    let mut windows = change.open_table(WINDOWS)?;
    let mut places = change.open_table(PLACES)?;
    for job in jobs {
        rows.remove(job.0)?;
        commands.remove(job.0)?;
        steps.remove(job.0)?;
        windows.remove(job.0)?;
        places.remove(job.0)?;
    }
    Ok(())
}

/// The job that was asked for with the same key.
fn asked_before(jobs: &[Job], asked: &PlannedJob) -> Result<Option<JobId>, JournalError> {
    let Some(key) = &asked.key else {
        return Ok(None);
    };
    match jobs.iter().find(|it| it.key.as_ref() == Some(key)) {
        Some(job) if job.is_as(asked) => Ok(Some(job.id)),
        Some(job) => Err(JournalError::KeyReused {
            key: key.clone(),
            job: job.id,
        }),
        None => Ok(None),
    }
}
