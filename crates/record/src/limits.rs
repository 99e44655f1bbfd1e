//! The size limits of recordings.

/// The size limits of recordings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// The longest file, in bytes, 1 MiB or more; a longer recording continues in another file.
    pub file_bytes: u64,
    /// The total length of all files, in bytes, at least twice that of one; beyond it the oldest
    /// file is deleted.
    pub total_bytes: u64,
}

impl Limits {
    /// The default: files of 64 MiB, 1 GiB in total.
    pub const DEFAULT: Self = Self {
        file_bytes: 64 << 20,
        total_bytes: 1 << 30,
    };

    /// Checks the limits.
    ///
    /// # Errors
    ///
    /// [`StartError`] if a limit is too low.
    pub(crate) const fn check(self) -> Result<(), StartError> {
        if self.file_bytes < MIN_FILE_BYTES {
            return Err(StartError::File(self.file_bytes));
        }
        if self.total_bytes / 2 < self.file_bytes {
            return Err(StartError::Total {
                found: self.total_bytes,
                file_bytes: self.file_bytes,
            });
        }
        Ok(())
    }
}

impl Default for Limits {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// The error returned when a recorder cannot start. A folder that cannot be written is not an
/// error, because that may change: see [`Recorder::health`](crate::Recorder::health).
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StartError {
    /// The limit of a file is too low.
    #[error("file_bytes is {0}; allowed are {MIN_FILE_BYTES} or more")]
    File(u64),
    /// The limit of all files is too low.
    #[error("total_bytes is {found}; allowed is twice file_bytes ({file_bytes}) or more")]
    Total {
        /// The limit.
        found: u64,
        /// The limit of a file.
        file_bytes: u64,
    },
    /// The system clock is out of range.
    #[error("system clock reads {0}; recordings support 1970 to 2490; set the clock")]
    Clock(jiff::Timestamp),
    /// The thread of the recorder cannot be started.
    #[error("cannot start the thread of the recorder")]
    Thread(#[source] std::io::Error),
}

const MIN_FILE_BYTES: u64 = 1 << 20;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_that_leave_no_room_report_the_needed_size() {
        let text = |file_bytes, total_bytes| {
            let limits = Limits {
                file_bytes,
                total_bytes,
            };
            limits.check().map_err(|error| error.to_string())
        };
        assert!(text(1000, 10_000).is_err_and(|text| text.contains("1048576")));
        assert!(text(2 << 20, 3 << 20).is_err_and(|text| text.contains("twice file_bytes")));
        assert_eq!(text(1 << 20, 2 << 20), Ok(()));
        assert!(Limits::DEFAULT.check().is_ok());
    }
}
