//! Optional parts of the page that are not in the program: installed from an archive whose digest is
//! known, kept in the data folder, and served from there.

use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::{fs, str};

use data_encoding::HEXLOWER;
use dobot_api::make_private;
use flate2::read::GzDecoder;
use sha2::{Digest, Sha256};

/// An optional part of the page.
#[derive(Clone, Copy, Debug)]
pub struct Extra {
    /// Its name, also that of its folder.
    pub name: &'static str,
    /// The npm package whose archive contains it.
    pub package: &'static str,
    sha256: &'static str,
    /// The files that are used, in the archive's folder `package`.
    files: &'static [&'static str],
}

/// Recognises hands in a camera's pictures, with the models for it (Apache-2.0).
pub const HANDS: Extra = Extra {
    name: "hands",
    package: "@mediapipe/hands@0.4.1675469240",
    sha256: "bdd5be939c60cbd72a49f4b6141407683cf2a67263598e1a44757d70b3dfcb8a",
    files: &[
        "hands.js",
        "hands.binarypb",
        "hands_solution_packed_assets.data",
        "hands_solution_packed_assets_loader.js",
        "hands_solution_simd_wasm_bin.js",
        "hands_solution_simd_wasm_bin.wasm",
        "hand_landmark_lite.tflite",
    ],
};

/// All optional parts.
pub const EXTRAS: [Extra; 1] = [HANDS];

/// An archive that cannot be installed; nothing has changed.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ExtraError {
    /// The archive cannot be read, or its files cannot be written.
    #[error("{}: {source}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// The reason.
        source: io::Error,
    },
    /// It is another file.
    #[error("{}: its SHA-256 is {found}; that of {package} is {expected}", path.display())]
    Other {
        /// The file.
        path: PathBuf,
        /// Its digest.
        found: String,
        /// The package.
        package: &'static str,
        /// The digest of the package.
        expected: &'static str,
    },
}

impl Extra {
    /// Whether it is installed in this folder of extras.
    #[must_use]
    pub fn is_installed(&self, extras: &Path) -> bool {
        let folder = extras.join(self.name);
        self.files.iter().all(|file| folder.join(file).is_file())
    }

    /// Returns the path of one of its files, `None` for any other name.
    #[must_use]
    pub fn file(&self, extras: &Path, name: &str) -> Option<PathBuf> {
        let known = self.files.iter().find(|file| **file == name)?;
        Some(extras.join(self.name).join(known))
    }

    /// Installs it from an archive into a folder of extras.
    ///
    /// # Errors
    ///
    /// [`ExtraError`].
    pub fn install(&self, extras: &Path, archive: &Path) -> Result<(), ExtraError> {
        let failed = |path: &Path| {
            let path = path.to_owned();
            |source| ExtraError::File { path, source }
        };
        let packed = fs::read(archive).map_err(failed(archive))?;
        let found = HEXLOWER.encode(&Sha256::digest(&packed));
        if found != self.sha256 {
            return Err(ExtraError::Other {
                path: archive.to_owned(),
                found,
                package: self.package,
                expected: self.sha256,
            });
        }
        let (folder, new) = (extras.join(self.name), extras.join("new"));
        let written = || {
            if new.exists() {
                fs::remove_dir_all(&new)?;
            }
            make_private(&new)?;
            self.unpack(GzDecoder::new(&*packed), &new)?;
            if folder.exists() {
                fs::remove_dir_all(&folder)?;
            }
            fs::rename(&new, &folder)
        };
        written().map_err(failed(&folder))
    }

    /// Writes the used files of a tar archive.
    fn unpack(&self, mut tar: impl Read, folder: &Path) -> io::Result<()> {
        let mut header = [0; BLOCK];
        loop {
            tar.read_exact(&mut header)?;
            if header[0] == 0 {
                return Ok(()); // The end of an archive is a block of zeros.
            }
            let size = size_of_entry(&header)?;
            let padded = size.next_multiple_of(BLOCK as u64);
            let mut content = Vec::new();
            tar.by_ref().take(padded).read_to_end(&mut content)?;
            let name = text(&header[..NAME_LEN])?;
            let name = name.strip_prefix("package/").unwrap_or_default();
            if let Some(known) = self.files.iter().find(|file| **file == name) {
                content.truncate(usize::try_from(size).unwrap_or(usize::MAX));
                fs::write(folder.join(known), content)?;
            }
        }
    }
}

/// Parses the size of an entry: octal digits.
fn size_of_entry(header: &[u8; BLOCK]) -> io::Result<u64> {
    let digits = text(&header[SIZE])?;
    u64::from_str_radix(digits.trim(), 8).map_err(io::Error::other)
}

/// Returns a text up to its first zero.
fn text(bytes: &[u8]) -> io::Result<&str> {
    let text = bytes.split(|byte| *byte == 0).next().unwrap_or_default();
    str::from_utf8(text).map_err(io::Error::other)
}

/// The size of a tar block, the length of a name, and where the size is (POSIX ustar).
const BLOCK: usize = 512;
const NAME_LEN: usize = 100;
const SIZE: std::ops::Range<usize> = 124..136;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use std::io::Write as _;

    use flate2::Compression;
    use flate2::write::GzEncoder;

    use super::*;

    /// Packs files as npm does.
    fn pack(files: &[(&str, &[u8])]) -> Vec<u8> {
        let mut tar = Vec::new();
        for (name, content) in files {
            let mut header = [0; BLOCK];
            header[..name.len()].copy_from_slice(name.as_bytes());
            let size = format!("{:011o}", content.len());
            header[SIZE][..size.len()].copy_from_slice(size.as_bytes());
            tar.extend(header);
            tar.extend(*content);
            tar.resize(tar.len().next_multiple_of(BLOCK), 0);
        }
        tar.extend([0; 2 * BLOCK]);
        let mut gzip = GzEncoder::new(Vec::new(), Compression::fast());
        gzip.write_all(&tar).unwrap();
        gzip.finish().unwrap()
    }

    fn extra(archive: &[u8]) -> Extra {
        Extra {
            name: "things",
            package: "things@1.0.0",
            sha256: HEXLOWER.encode(&Sha256::digest(archive)).leak(),
            files: &["one.js", "two.wasm"],
        }
    }

    #[test]
    fn the_files_of_an_archive_with_the_known_digest_are_installed() {
        let folder = tempfile::tempdir().unwrap();
        let long = vec![7; 1300];
        let files: [(&str, &[u8]); 4] = [
            ("package/package.json", b"{}"),
            ("package/one.js", &long),
            ("package/../../evil.js", b"evil"),
            ("package/two.wasm", b"wasm"),
        ];
        let archive = pack(&files);
        let file = folder.path().join("things.tgz");
        fs::write(&file, &archive).unwrap();
        let (extra, extras) = (extra(&archive), folder.path().join("extras"));
        assert!(!extra.is_installed(&extras));
        for _ in 0..2 {
            extra.install(&extras, &file).unwrap();
            assert!(extra.is_installed(&extras));
        }
        let one = extra.file(&extras, "one.js").unwrap();
        assert_eq!(fs::read(one).unwrap(), long);
        let names = fs::read_dir(extras.join("things")).unwrap();
        assert_eq!(names.count(), 2);
        assert_eq!(extra.file(&extras, "../things.tgz"), None);
    }

    #[test]
    fn another_archive_is_refused_and_what_is_installed_stays() {
        let folder = tempfile::tempdir().unwrap();
        let archive = pack(&[("package/one.js", b"1"), ("package/two.wasm", b"2")]);
        let file = folder.path().join("things.tgz");
        fs::write(&file, &archive).unwrap();
        let extra = extra(&archive);
        extra.install(folder.path(), &file).unwrap();
        fs::write(&file, pack(&[("package/one.js", b"other")])).unwrap();
        let refused = extra.install(folder.path(), &file).unwrap_err().to_string();
        assert!(refused.contains("that of things@1.0.0 is"), "{refused}");
        let one = extra.file(folder.path(), "one.js").unwrap();
        assert_eq!(fs::read(one).unwrap(), b"1");
    }
}
