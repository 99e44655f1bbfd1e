//! The journal of jobs.

use std::path::Path;
use std::sync::{Mutex, MutexGuard, PoisonError};

use dobot_api::JobState;
use dobot_wire::Command;
use redb::{ReadOnlyTable, ReadTransaction, ReadableTable, StorageBackend, WriteTransaction};

use crate::new_rows::NewRows;
use crate::offers::keep_outcome;
use crate::rows::{self, JobRow, check_contents};
use crate::store::{
    CLEAN_FACT, COMMANDS, FACTS, FORMAT, FORMAT_FACT, JOBS, MISSING_FACT, OFFERS, PLACES, REFUSALS,
    STEPS, Store, WINDOWS, fact,
};
use crate::{Adjustment, Job, JobExtension, JobHistory, JobId, JournalError, PlannedJob, Window};

/// A file of jobs that survives crashes and power cuts.
///
/// A change acknowledged with `Ok` is completely on the disk; any other is there completely or not
/// at all. Each change waits for the disk, which takes some milliseconds.
///
/// After an error the next call reopens the file, so the journal works again as soon as its storage
/// does. Jobs can still be read if the storage can.
#[derive(Debug)]
pub struct Journal {
    store: Mutex<Store>,
    was_clean: bool,
    missing_writes: u64,
}

impl Journal {
    /// Opens the journal in a file, or creates it; its folder must exist.
    ///
    /// A journal left by a crash is repaired. It then counts as not clean until
    /// [`Journal::note_clean_shutdown`].
    ///
    /// # Errors
    ///
    /// [`JournalError`] if the file is not a journal, is damaged, or is open in another program; it
    /// is not changed.
    pub fn open(path: &Path) -> Result<Self, JournalError> {
        Self::with_store(Store::open(path)?)
    }

    /// Creates a journal in memory.
    ///
    /// # Errors
    ///
    /// [`JournalError`] if there is no memory for it.
    pub fn in_memory() -> Result<Self, JournalError> {
        Self::with_store(Store::in_memory()?)
    }

    /// Creates a journal on other storage than a file, for example to simulate disk failures.
    ///
    /// `storage` returns the storage, and again after a failure.
    ///
    /// # Errors
    ///
    /// Same as [`Journal::open`].
    pub fn with_backend<B: StorageBackend>(
        storage: impl Fn() -> B + Send + Sync + 'static,
    ) -> Result<Self, JournalError> {
        Self::with_store(Store::with_backend(storage)?)
    }

    /// Returns whether the program that had it open before ended with
    /// [`Journal::note_clean_shutdown`]. A new journal is clean.
    #[must_use]
    pub const fn was_clean(&self) -> bool {
        self.was_clean
    }

    /// Returns the number of last writes that are missing because the newest part of the file was
    /// damaged and the previous one is used: the last queued jobs or the progress of a job may be
    /// lost. The number is kept until [`Journal::note_clean_shutdown`].
    #[must_use]
    pub const fn missing_writes(&self) -> u64 {
        self.missing_writes
    }

    /// Notes a clean end: the arm is at rest and the laser is off.
    ///
    /// # Errors
    ///
    /// [`JournalError`] if the storage fails.
    pub fn note_clean_shutdown(&self) -> Result<(), JournalError> {
        self.store().write(|change| note_clean(change, true))
    }

    /// Adds a queued job. If a job with the same key exists, returns that one.
    ///
    /// # Errors
    ///
    /// [`JournalError`] if a command or the lift is invalid, the key was used for a different job,
    /// or the storage fails.
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

    /// Returns all jobs: oldest first, unless they were [arranged](Journal::arrange) otherwise.
    ///
    /// # Errors
    ///
    /// [`JournalError`] if the storage fails or a row is invalid.
    pub fn jobs(&self) -> Result<Vec<Job>, JournalError> {
        self.store().jobs()
    }

    /// Returns a job.
    ///
    /// # Errors
    ///
    /// [`JournalError::NoSuchJob`], or the storage fails.
    pub fn job(&self, id: JobId) -> Result<Job, JournalError> {
        self.store().job(id)
    }

    /// Returns the commands of a job.
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
                packets.as_ref().map_or(&[][..], |packets| packets.value()),
                &row,
            ))
        })?;
        commands.map_err(|found| store.damaged(found))
    }

    /// Returns the progress of a job.
    ///
    /// # Errors
    ///
    /// [`JournalError::NoSuchJob`], or the storage fails.
    pub fn progress(&self, id: JobId) -> Result<Window, JournalError> {
        self.job(id).map(|job| job.window)
    }

    /// Permits commands to be given to the arm: **only after this returned `Ok` may a command
    /// before `window.upto` be sent.** The job must be [`JobState::Running`].
    ///
    /// # Errors
    ///
    /// [`JournalError`] if the job is not running, the window is outside it or begins before what
    /// is done, or the storage fails. Then no further commands may be sent.
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

    /// Sets the state of a job.
    ///
    /// # Errors
    ///
    /// [`JournalError::NoSuchJob`], [`JournalError::NotRunning`] if a job that is over was to run,
    /// or the storage fails.
    pub fn set_state(&self, id: JobId, state: &JobState) -> Result<(), JournalError> {
        self.change(id, |row| row.change_state(id, state))
    }

    /// Sets the state of a job together with its history.
    ///
    /// # Errors
    ///
    /// [`JournalError::NoSuchJob`], [`JournalError::Number`], or the storage fails.
    pub fn set_state_with_history(
        &self,
        id: JobId,
        state: &JobState,
        history: JobHistory,
    ) -> Result<(), JournalError> {
        finite("the time that it ran", history.ran_s)?;
        self.change(id, |row| {
            row.change_state(id, state)?;
            row.history = history;
            Ok(())
        })
    }

    /// Extends a job that is not over by the commands that follow an answer. **Only after this
    /// returned `Ok` may the answer take effect.**
    ///
    /// # Errors
    ///
    /// [`JournalError::NoSuchJob`], [`JournalError::Shorter`] if the new commands do not begin with
    /// those of the job, [`JournalError::NotRunning`] if the job is over, or the storage fails.
    pub fn extend(&self, id: JobId, longer: &JobExtension) -> Result<(), JournalError> {
        let known = self.commands(id)?;
        let mut store = self.store();
        let mut row = store.row(id)?;
        if row.state.is_over() {
            let state = row.state;
            return Err(JournalError::NotRunning { job: id, state });
        }
        if !longer.commands.starts_with(&known) {
            return Err(JournalError::Shorter(id));
        }
        check_contents(&longer.pauses, &longer.program, longer.commands.len())?;
        let dialect = row.dialect().map_err(|found| store.damaged(found))?;
        let packets = rows::packets(&longer.commands, &dialect)?;
        let steps = rows::steps_bytes(&longer.program);
        row.extend(longer);
        let row = row.to_bytes();
        store.write(|change| {
            change
                .open_table(COMMANDS)?
                .insert(id.0, packets.as_slice())?;
            change.open_table(STEPS)?.insert(id.0, steps.as_slice())?;
            change.open_table(JOBS)?.insert(id.0, row.as_slice())?;
            Ok(())
        })
    }

    /// Stores the adjustment of a job. **Only after this returned `Ok` may a command changed by it
    /// be sent**: where the arm rests after a crash depends on it.
    ///
    /// # Errors
    ///
    /// [`JournalError::NoSuchJob`], [`JournalError::Number`], or the storage fails.
    pub fn adjust(&self, id: JobId, adjustment: &Adjustment) -> Result<(), JournalError> {
        finite("the speed", [adjustment.speed_percent])?;
        let heights = &adjustment.heights;
        finite(
            "a height",
            heights
                .iter()
                .flat_map(|height| [height.begin_mm, height.offset_mm]),
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

    /// Reorders jobs among each other: the first one gets the first of their current places in the
    /// list, and so on. All others keep their places.
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

    /// Removes a job that is over or has not started.
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

    /// Removes the oldest finished jobs until `most` of them are left, and returns the number
    /// removed. Unfinished jobs stay.
    ///
    /// # Errors
    ///
    /// [`JournalError`] if the storage fails.
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
        store.write(|change| begin_use(change, missing))?;
        Ok(Self {
            store: Mutex::new(store),
            was_clean: clean == 1,
            missing_writes: missing,
        })
    }

    /// A panic cannot leave a partial change: what is not committed does not exist.
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
            Ok(window.map(|window| rows::window(window.value())))
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

/// The tables of jobs, without their commands.
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

    /// Returns all jobs in list order.
    fn in_order(&self) -> Result<Vec<JobId>, redb::Error> {
        let placed = self.rows.iter()?.map(|entry| {
            let job = entry?.0.value();
            Ok((place(&self.places, job)?, job))
        });
        let mut placed = placed.collect::<Result<Vec<_>, redb::Error>>()?;
        placed.sort_unstable();
        Ok(placed.into_iter().map(|(_, job)| JobId(job)).collect())
    }

    /// Returns a job, or what is invalid about it.
    fn job(&self, id: JobId) -> Result<Option<Result<Job, String>>, redb::Error> {
        let Some(row) = self.rows.get(id.0)? else {
            return Ok(None);
        };
        let steps = self.steps.get(id.0)?;
        let window = self.windows.get(id.0)?;
        let read = || {
            let steps = steps.map(|steps| rows::steps(steps.value())).transpose()?;
            let window = window
                .map(|window| rows::window(window.value()))
                .transpose()?;
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

/// JSON cannot represent other numbers.
pub(crate) fn finite(
    name: &'static str,
    numbers: impl IntoIterator<Item = f64>,
) -> Result<(), JournalError> {
    match numbers.into_iter().find(|number| !number.is_finite()) {
        Some(found) => Err(JournalError::Number { name, found }),
        None => Ok(()),
    }
}

/// Returns the place of a job in the list; for a job that was never moved, its number.
fn place(table: &impl ReadableTable<u64, u64>, job: u64) -> Result<u64, redb::Error> {
    Ok(table.get(job)?.map_or(job, |place| place.value()))
}

/// Notes the format of new jobs, and that the journal is in use.
fn begin_use(change: &WriteTransaction, missing: u64) -> Result<(), redb::Error> {
    // Jobs of earlier formats are read as they are; new ones are written in this format.
    let mut facts = change.open_table(FACTS)?;
    facts.insert(FORMAT_FACT, FORMAT)?;
    facts.insert(MISSING_FACT, missing)?;
    drop(facts);
    change.open_table(STEPS)?;
    change.open_table(PLACES)?;
    change.open_table(OFFERS)?;
    change.open_table(REFUSALS)?;
    note_clean(change, false)
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

/// Returns the job that was requested with the same key.
fn asked_before(jobs: &[Job], asked: &PlannedJob) -> Result<Option<JobId>, JournalError> {
    let Some(key) = &asked.key else {
        return Ok(None);
    };
    match jobs.iter().find(|job| job.key.as_ref() == Some(key)) {
        Some(job) if job.matches_request(asked) => Ok(Some(job.id)),
        Some(job) => Err(JournalError::KeyReused {
            key: key.clone(),
            job: job.id,
        }),
        None => Ok(None),
    }
}
