//! The folder of recordings.

use std::fs::{DirEntry, File, OpenOptions};
use std::io::{self, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

use jiff::Timestamp;

/// A recording in a folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RecordedFile {
    /// The file.
    pub path: PathBuf,
    /// The length, in bytes.
    pub bytes: u64,
    /// The start of the recording.
    pub begin: Timestamp,
    /// The number among the recordings started in the same second, from 1.
    number: u32,
}

/// Lists the recordings in a folder, oldest first. Files with other names are not recordings. A
/// missing folder has none.
///
/// # Errors
///
/// The error of the operating system.
pub fn recordings(folder: &Path) -> io::Result<Vec<RecordedFile>> {
    let files = match folder.read_dir() {
        Ok(files) => files,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Vec::new()),
        Err(error) => return Err(error),
    };
    let mut entries = Vec::new();
    for file in files {
        entries.extend(recorded(&file?)?);
    }
    entries.sort_by_key(|entry| (entry.begin, entry.number));
    Ok(entries)
}

/// Returns a file if it is a recording.
fn recorded(file: &DirEntry) -> io::Result<Option<RecordedFile>> {
    let name = file.file_name();
    let Some((begin, number)) = name.to_str().and_then(parse) else {
        return Ok(None);
    };
    match file.metadata() {
        Ok(metadata) if metadata.is_file() => Ok(Some(RecordedFile {
            path: file.path(),
            bytes: metadata.len(),
            begin,
            number,
        })),
        Ok(_) => Ok(None),
        // Another program may have deleted it.
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(error),
    }
}

/// Whether another process is writing this recording: a recorder locks its file until it finishes
/// it or exits. If the operating system cannot tell, the answer is yes.
#[must_use]
pub fn is_being_written(path: &Path) -> bool {
    if cfg!(windows) {
        return OpenOptions::new().write(true).open(path).is_err();
    }
    File::open(path).is_ok_and(|file| file.try_lock_shared().is_err())
}

/// Whether the file ends with the end mark of a finished one.
pub(crate) fn has_end_mark(path: &Path) -> io::Result<bool> {
    let mut file = File::open(path)?;
    let mark_len = mcap::MAGIC.len() as u64;
    if file.metadata()?.len() < 2 * mark_len {
        return Ok(false);
    }
    file.seek(SeekFrom::Start(file.metadata()?.len() - mark_len))?;
    let mut mark = Vec::new();
    file.read_to_end(&mut mark)?;
    Ok(mark == mcap::MAGIC)
}

/// Creates a file beside a recording for its repaired version; `None` while another process writes
/// it. Remains of an interrupted repair are deleted.
pub(crate) fn beside(recording: &Path) -> io::Result<Option<(PathBuf, File)>> {
    let mut name = recording.as_os_str().to_owned();
    name.push(REPAIRED);
    let path = PathBuf::from(name);
    let mut options = OpenOptions::new();
    let file = alone(options.write(true).create(true).truncate(false)).open(&path)?;
    if cfg!(not(windows)) && file.try_lock().is_err() {
        return Ok(None);
    }
    file.set_len(0)?;
    Ok(Some((path, file)))
}

/// Replaces the damaged recording by the repaired one. The file must be written and synced.
pub(crate) fn replace(repaired: &Path, recording: &Path) -> io::Result<()> {
    std::fs::rename(repaired, recording)?;
    if let Some(folder) = recording.parent() {
        sync_folder(folder);
    }
    Ok(())
}

/// Deletes the remains of interrupted repairs.
pub(crate) fn tidy(folder: &Path) -> io::Result<()> {
    for file in folder.read_dir()? {
        let file = file?;
        let name = file.file_name();
        let recording = name.to_str().and_then(|text| text.strip_suffix(REPAIRED));
        if recording.and_then(parse).is_some() && !is_being_written(&file.path()) {
            std::fs::remove_file(file.path())?;
        }
    }
    Ok(())
}

/// Creates a file for a recording with this start; creates the folder if it is missing.
pub(crate) fn create(folder: &Path, begin: Timestamp) -> io::Result<(PathBuf, File)> {
    std::fs::create_dir_all(folder)?;
    for number in 1..=MAX_PER_SECOND {
        let path = folder.join(name(begin, number));
        match alone(OpenOptions::new().write(true).create_new(true)).open(&path) {
            Ok(file) => {
                lock(&file);
                sync_folder(folder);
                return Ok((path, file));
            }
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            Err(error) => return Err(error),
        }
    }
    Err(io::ErrorKind::AlreadyExists.into())
}

/// Deletes the oldest recordings until `bytes` more fit into `total`.
pub(crate) fn make_room(folder: &Path, bytes: u64, total: u64) -> io::Result<()> {
    let entries = recordings(folder)?;
    let mut kept: u64 = entries.iter().map(|entry| entry.bytes).sum();
    for entry in entries {
        if kept + bytes <= total {
            break;
        }
        match std::fs::remove_file(&entry.path) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
            _ => kept -= entry.bytes,
        }
    }
    Ok(())
}

/// On Windows no other process may write the open file; this replaces a lock, which would keep
/// readers out.
fn alone(options: &mut OpenOptions) -> &mut OpenOptions {
    #[cfg(windows)]
    std::os::windows::fs::OpenOptionsExt::share_mode(options, 1 | 4);
    options
}

/// Locks the file while it is open. On file systems without locks it is written unlocked.
fn lock(file: &File) {
    if cfg!(not(windows)) {
        let _ = file.lock();
    }
}

/// The file name, as in `dobot-2026-11-21T12-30-00Z.mcap`: valid on every system, sorted by time.
fn name(begin: Timestamp, number: u32) -> String {
    let begin = begin.strftime("%Y-%m-%dT%H-%M-%SZ");
    match number {
        1 => format!("dobot-{begin}.mcap"),
        _ => format!("dobot-{begin}-{number}.mcap"),
    }
}

fn parse(file: &str) -> Option<(Timestamp, u32)> {
    let middle = file.strip_prefix("dobot-")?.strip_suffix(".mcap")?;
    let (begin, number) = middle.split_once('Z')?;
    let number = match number {
        "" => 1,
        number => number.strip_prefix('-')?.parse().ok()?,
    };
    let (date, time) = begin.split_once('T')?;
    let begin: Timestamp = format!("{date}T{}Z", time.replace('-', ":")).parse().ok()?;
    // Only exact names count as recordings: other files are not deleted.
    (name(begin, number) == file).then_some((begin, number))
}

/// Syncs the folder: after a power failure a file exists only if its folder was written too. Not
/// every system supports this.
fn sync_folder(folder: &Path) {
    if let Ok(folder) = File::open(folder) {
        let _ = folder.sync_all();
    }
}

/// The suffix of a recording under repair.
const REPAIRED: &str = ".repair";

/// The largest number of recordings that start in one second.
const MAX_PER_SECOND: u32 = 1000;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    fn noon() -> Timestamp {
        "2026-11-21T12:30:00Z".parse().unwrap()
    }

    #[test]
    fn an_existing_name_gets_a_number() {
        let folder = tempfile::tempdir().unwrap();
        let names: Vec<_> = (0..11)
            .map(|_| create(folder.path(), noon()).unwrap().0)
            .collect();
        assert!(names[0].ends_with("dobot-2026-11-21T12-30-00Z.mcap"));
        assert!(names[10].ends_with("dobot-2026-11-21T12-30-00Z-11.mcap"));
        let listed = recordings(folder.path()).unwrap();
        assert_eq!(
            names,
            listed.into_iter().map(|item| item.path).collect::<Vec<_>>()
        );
    }

    #[test]
    fn the_oldest_make_room_and_nothing_else_is_touched() {
        let folder = tempfile::tempdir().unwrap();
        let strangers = [
            "dobot-holiday.mcap",
            "dobot-2026-11-21T12-30-00Z-1.mcap",
            "notes.txt",
        ];
        for stranger in strangers {
            std::fs::write(folder.path().join(stranger), [0; 1000]).unwrap();
        }
        for day in [3, 1, 2] {
            let name = format!("dobot-2026-11-0{day}T00-00-00Z.mcap");
            std::fs::write(folder.path().join(name), [0; 100]).unwrap();
        }
        make_room(folder.path(), 50, 200).unwrap();
        let left = recordings(folder.path()).unwrap();
        assert_eq!(left.len(), 1);
        assert!(left[0].path.ends_with("dobot-2026-11-03T00-00-00Z.mcap"));
        for stranger in strangers {
            assert!(folder.path().join(stranger).exists(), "{stranger}");
        }
    }

    #[test]
    fn a_missing_folder_contains_nothing() {
        assert_eq!(recordings(Path::new("/no/such/folder")).unwrap(), []);
    }
}
