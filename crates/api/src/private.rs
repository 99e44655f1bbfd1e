//! Files that only this user may read.

use std::fs::{self, OpenOptions};
use std::io::{self, Write};
use std::path::Path;

use crate::make_private;

/// Writes a private file atomically; creates its folder if it is missing.
///
/// # Errors
///
/// The operating system's error; the previous file is unchanged.
pub fn write_private(file: &Path, content: impl AsRef<[u8]>) -> io::Result<()> {
    if let Some(folder) = file.parent() {
        make_private(folder)?;
    }
    let new = file.with_extension(format!("new-{}", std::process::id()));
    let written = write_new(&new, content.as_ref()).and_then(|()| fs::rename(&new, file));
    if written.is_err() {
        // The partial file is of no use; report the write error instead.
        let _ = fs::remove_file(&new);
    }
    written
}

fn write_new(file: &Path, content: &[u8]) -> io::Result<()> {
    let mut options = OpenOptions::new();
    options.write(true).create_new(true);
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
    let mut file = options.open(file)?;
    file.write_all(content)?;
    file.sync_all()
}

#[cfg(all(test, unix))]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use std::os::unix::fs::PermissionsExt;

    use super::*;

    #[test]
    fn a_file_readable_by_others_is_private_after_it_is_written_again() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("in/here.toml");
        write_private(&file, "one").unwrap();
        fs::set_permissions(&file, fs::Permissions::from_mode(0o644)).unwrap();
        write_private(&file, "two").unwrap();
        assert_eq!(fs::read_to_string(&file).unwrap(), "two");
        let mode = fs::metadata(&file).unwrap().permissions().mode();
        assert_eq!(mode & 0o777, 0o600, "{mode:o}");
        assert_eq!(fs::read_dir(folder.path().join("in")).unwrap().count(), 1);
    }
}
