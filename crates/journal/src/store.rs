//! The file of the journal: creating, opening, locking, and reopening after a failure.

use std::fmt;
use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

use redb::backends::{FileBackend, InMemoryBackend};
use redb::{
    Builder, Database, DatabaseError, Durability, ReadTransaction, ReadableDatabase, ReadableTable,
    StorageBackend, StorageError, TableDefinition, TableError, WriteTransaction,
};

use crate::JournalError;
use crate::write_count::WriteCount;

/// A database that reopens itself after a failure and knows its name for errors.
pub(crate) struct Store {
    /// `None` while the storage fails.
    database: Option<Database>,
    open_again: Box<dyn Fn() -> Result<Database, DatabaseError> + Send + Sync>,
    file: String,
    durability: Durability,
    /// The number of writes, kept in a separate file that damage to the database does not reach.
    count: Option<WriteCount>,
}

impl Store {
    /// Opens the file, or creates it. An existing file is never overwritten.
    pub(crate) fn open(path: &Path) -> Result<Self, JournalError> {
        let file = path.display().to_string();
        if fs::metadata(path).is_ok_and(|metadata| metadata.len() == 0) {
            let found = "it is empty, as a power cut or a full disk leaves it".to_owned();
            return Err(JournalError::Foreign { file, found });
        }
        let mut count = WriteCount::beside(path);
        let database = match builder().open(path) {
            Err(DatabaseError::Storage(StorageError::Io(error)))
                if error.kind() == ErrorKind::NotFound =>
            {
                // The previous journal was moved away; this one has no writes.
                count.note(0);
                create(path)
            }
            other => other,
        };
        let again = path.to_owned();
        Ok(Self {
            database: Some(database.map_err(|error| failed(&file, error.into()))?),
            open_again: Box::new(move || builder().open(&again)),
            file,
            durability: Durability::Immediate,
            count: Some(count),
        })
    }

    /// Opens storage that is not a file; `storage` returns it, again after a failure.
    pub(crate) fn with_backend<B: StorageBackend>(
        storage: impl Fn() -> B + Send + Sync + 'static,
    ) -> Result<Self, JournalError> {
        let file = "in memory".to_owned();
        let open = move || builder().create_with_backend(storage());
        let database = open().map_err(|error| failed(&file, error.into()))?;
        initialise(&database).map_err(|error| failed(&file, error))?;
        Ok(Self {
            database: Some(database),
            open_again: Box::new(open),
            file,
            durability: Durability::Immediate,
            count: None,
        })
    }

    /// Opens a private database in memory.
    pub(crate) fn in_memory() -> Result<Self, JournalError> {
        let store = Self::with_backend(InMemoryBackend::new)?;
        // It ends with the process: a durable write would cost more and gain nothing.
        let durability = Durability::None;
        Ok(Self {
            durability,
            ..store
        })
    }

    /// Reads.
    pub(crate) fn read<T>(
        &mut self,
        look_up: impl FnOnce(&ReadTransaction) -> Result<T, redb::Error>,
    ) -> Result<T, JournalError> {
        let found = self.database()?.begin_read().map_err(redb::Error::from);
        let found = found.and_then(|transaction| look_up(&transaction));
        found.map_err(|error| self.recover(error))
    }

    /// Applies a change durably and completely, or not at all.
    pub(crate) fn write(
        &mut self,
        change: impl FnOnce(&WriteTransaction) -> Result<(), redb::Error>,
    ) -> Result<(), JournalError> {
        let mut number = 0;
        let (durability, counts) = (self.durability, self.count.is_some());
        let changed = commit(self.database()?, durability, |transaction| {
            change(transaction)?;
            if counts {
                number = number_write(transaction)?;
            }
            Ok(())
        });
        changed.map_err(|error| self.recover(error))?;
        if let Some(count) = &mut self.count {
            count.note(number);
        }
        Ok(())
    }

    /// Returns how many of the writes noted beside the file are missing: its newest part is
    /// damaged, and the previous one is used.
    pub(crate) fn missing_writes(&mut self) -> Result<u64, JournalError> {
        let noted = self.count.as_ref().map_or(0, WriteCount::read);
        let found = self.read(|look| fact(look, WRITES_FACT))?;
        Ok(noted.saturating_sub(found))
    }

    /// Returns the error for invalid content.
    pub(crate) fn damaged(&self, found: String) -> JournalError {
        let file = self.file.clone();
        JournalError::Damaged { file, found }
    }

    /// Returns the file name for errors.
    pub(crate) fn file(&self) -> String {
        self.file.clone()
    }

    fn database(&mut self) -> Result<&Database, JournalError> {
        let database = match self.database.take() {
            Some(database) => database,
            None => (self.open_again)().map_err(|error| failed(&self.file, error.into()))?,
        };
        Ok(self.database.insert(database))
    }

    /// After a failure nothing in memory is trusted: the file has what was committed.
    fn recover(&mut self, error: redb::Error) -> JournalError {
        self.database = None;
        self.database = (self.open_again)().ok();
        failed(&self.file, error)
    }
}

impl fmt::Debug for Store {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Store")
            .field("file", &self.file)
            .finish_non_exhaustive()
    }
}

/// Every page is checked on opening: a journal is small, and damage must be reported.
fn builder() -> Builder {
    let mut builder = Builder::new();
    builder
        .set_cache_size(CACHE_BYTES)
        .set_check_integrity_on_open(true);
    builder
}

/// Creates the file under another name and renames it, so that it is there completely or not at
/// all.
fn create(path: &Path) -> Result<Database, DatabaseError> {
    let draft = draft(path);
    let database = match open_draft(&draft) {
        // Nothing in a draft has been acknowledged.
        Err(DatabaseError::Storage(_)) => {
            fs::remove_file(&draft)?;
            open_draft(&draft)?
        }
        other => other?,
    };
    // The draft is locked now: a faster process has finished.
    if path.try_exists()? {
        drop(database);
        let _ = fs::remove_file(&draft); // The other one may have renamed it.
        return builder().open(path);
    }
    initialise(&database).map_err(|error| match error {
        redb::Error::Io(error) => DatabaseError::Storage(StorageError::Io(error)),
        other => DatabaseError::Storage(StorageError::Corrupted(other.to_string())),
    })?;
    fs::rename(&draft, path)?;
    sync_folder(path)?;
    Ok(database)
}

fn draft(path: &Path) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".new");
    name.into()
}

fn open_draft(draft: &Path) -> Result<Database, DatabaseError> {
    let file = private().read(true).open(draft)?;
    builder().create_with_backend(FileBackend::new(file)?)
}

/// Returns the options to write a file created for its owner alone; its content stays.
pub(crate) fn private() -> OpenOptions {
    let mut options = File::options();
    options.write(true).create(true).truncate(false);
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
    options
}

/// A new name is lost in a power cut until its folder is on the disk.
fn sync_folder(path: &Path) -> io::Result<()> {
    let folder = match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    };
    if cfg!(unix) {
        File::open(folder)?.sync_all()?;
    }
    Ok(())
}

/// Writes what makes a database a journal, unless present.
fn initialise(database: &Database) -> Result<(), redb::Error> {
    match database.begin_read()?.open_table(FACTS) {
        Err(TableError::TableDoesNotExist(_)) => {}
        other => return other.map(|_| ()).map_err(Into::into),
    }
    commit(database, Durability::Immediate, |transaction| {
        let mut facts = transaction.open_table(FACTS)?;
        facts.insert(FORMAT_FACT, FORMAT)?;
        facts.insert(CLEAN_FACT, 1)?;
        facts.insert(NEXT_JOB_FACT, 1)?;
        transaction.open_table(JOBS)?;
        transaction.open_table(COMMANDS)?;
        transaction.open_table(STEPS)?;
        transaction.open_table(WINDOWS)?;
        transaction.open_table(PLACES)?;
        transaction.open_table(OFFERS)?;
        transaction.open_table(REFUSALS)?;
        Ok(())
    })
}

fn commit(
    database: &Database,
    durability: Durability,
    change: impl FnOnce(&WriteTransaction) -> Result<(), redb::Error>,
) -> Result<(), redb::Error> {
    let mut transaction = database.begin_write()?;
    transaction.set_durability(durability)?;
    change(&transaction)?;
    transaction.commit()?;
    Ok(())
}

/// Counts a write; returns its number.
fn number_write(change: &WriteTransaction) -> Result<u64, redb::Error> {
    let mut facts = change.open_table(FACTS)?;
    let number = facts.get(WRITES_FACT)?.map_or(0, |fact| fact.value()) + 1;
    facts.insert(WRITES_FACT, number)?;
    Ok(number)
}

/// A missing fact is 0, which no format, job or clean journal is.
pub(crate) fn fact(look: &ReadTransaction, name: &str) -> Result<u64, redb::Error> {
    let value = look.open_table(FACTS)?.get(name)?;
    Ok(value.map_or(0, |value| value.value()))
}

/// Converts an error of the database.
fn failed(file: &str, error: redb::Error) -> JournalError {
    let file = file.to_owned();
    match error {
        redb::Error::Io(source) => failed_io(file, source),
        error @ (redb::Error::PreviousIo | redb::Error::DatabaseClosed) => {
            let source = io::Error::other(error);
            JournalError::Io { file, source }
        }
        redb::Error::DatabaseAlreadyOpen | redb::Error::LockProtocolMismatch => {
            JournalError::InUse { file }
        }
        error @ (redb::Error::TableDoesNotExist(_) | redb::Error::UpgradeRequired(_)) => {
            let found = error.to_string();
            JournalError::Foreign { file, found }
        }
        other => {
            let found = other.to_string();
            JournalError::Damaged { file, found }
        }
    }
}

fn failed_io(file: String, source: io::Error) -> JournalError {
    match source.kind() {
        _ if is_full(&source) => JournalError::Full { file, source },
        ErrorKind::InvalidData => {
            let found = source.to_string();
            JournalError::Foreign { file, found }
        }
        ErrorKind::UnexpectedEof => {
            let found = "it ends too early".to_owned();
            JournalError::Damaged { file, found }
        }
        _ => JournalError::Io { file, source },
    }
}

fn is_full(error: &io::Error) -> bool {
    matches!(
        error.kind(),
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded | ErrorKind::FileTooLarge
    )
}

/// The format that this version writes.
pub(crate) const FORMAT: u64 = 6;
/// The format of the tables.
pub(crate) const FORMAT_FACT: &str = "format";
/// Whether the program ended cleanly.
pub(crate) const CLEAN_FACT: &str = "clean";
/// The number of writes.
const WRITES_FACT: &str = "writes";
/// The number of writes missing on opening, since the last clean end.
pub(crate) const MISSING_FACT: &str = "missing writes";
/// The number of the next job.
pub(crate) const NEXT_JOB_FACT: &str = "next job";
/// Facts about the journal itself.
pub(crate) const FACTS: TableDefinition<'_, &str, u64> = TableDefinition::new("dobot journal");
/// Jobs without their commands, as JSON.
pub(crate) const JOBS: TableDefinition<'_, u64, &[u8]> = TableDefinition::new("jobs");
/// The packets of jobs.
pub(crate) const COMMANDS: TableDefinition<'_, u64, &[u8]> = TableDefinition::new("commands");
/// The first commands of the steps of jobs that have steps, apart from the rows that are read with each window: a program
/// may have a million of them.
pub(crate) const STEPS: TableDefinition<'_, u64, &[u8]> = TableDefinition::new("steps");
/// The progress of jobs: completed, upto, and the packet of the status at `completed`.
pub(crate) const WINDOWS: TableDefinition<'_, u64, (u64, u64, &[u8])> =
    TableDefinition::new("windows");
/// The list places of moved jobs; the place of any other job is its number.
pub(crate) const PLACES: TableDefinition<'_, u64, u64> = TableDefinition::new("places");
/// The answers to offers of other stations, by key, as JSON.
pub(crate) const OFFERS: TableDefinition<'_, &str, &[u8]> = TableDefinition::new("offers");
/// The keys of the latest refusals, in order.
pub(crate) const REFUSALS: TableDefinition<'_, u64, &str> = TableDefinition::new("refusals");
/// The number of refused offers.
pub(crate) const REFUSED_FACT: &str = "refused offers";
const CACHE_BYTES: usize = 8 << 20;
