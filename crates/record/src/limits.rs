//! How much room recordings may take.

/// How much room recordings may take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// The longest file, in bytes, from 1 MiB; then another one is begun.
    pub file_bytes: u64,
    /// All files together, in bytes, at least twice as much as one; then the oldest is deleted.
    pub total_bytes: u64,
}

impl Limits {
    /// Files of 64 MiB, one gibibyte of them.
    pub const DEFAULT: Self = Self {
        file_bytes: 64 << 20,
        total_bytes: 1 << 30,
    };

    /// Whether there is room for anything.
    ///
    /// # Errors
    ///
    /// [`StartError`] where a limit is too low.
    pub(crate) const fn check(self) -> Result<(), StartError> {
        if self.file_bytes < LEAST_FILE_BYTES {
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

/// Why a recorder could not be started. A folder that cannot be written is not among the reasons: that
/// may change, and [`Recorder::health`](crate::Recorder::health) says so.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StartError {
    /// The limit of a file is too low.
    #[error("file_bytes is {0}; the least that is allowed is {LEAST_FILE_BYTES}")]
    File(u64),
    /// The limit of all files is too low.
    #[error(
        "total_bytes is {found}; the least that is allowed is twice file_bytes, which is {file_bytes}"
    )]
    Total {
        /// The limit.
        found: u64,
        /// The limit of a file.
        file_bytes: u64,
    },
    /// The clock is wrong.
    #[error("the clock says {0}; recordings have numbers for 1970 to 2490 only: set it right")]
    Clock(jiff::Timestamp),
    /// The thread of the recorder cannot be started.
    #[error("there is no thread for the recorder")]
    Thread(#[source] std::io::Error),
}

const LEAST_FILE_BYTES: u64 = 1 << 20;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_that_leave_no_room_say_how_much_is_needed() {
        let text = |file_bytes, total_bytes| {
            let limits = Limits {
                file_bytes,
                total_bytes,
            };
            limits.check().map_err(|error| error.to_string())
        };
        assert!(text(1000, 10_000).is_err_and(|it| it.contains("1048576")));
        assert!(text(2 << 20, 3 << 20).is_err_and(|it| it.contains("twice file_bytes")));
        assert_eq!(text(1 << 20, 2 << 20), Ok(()));
        assert!(Limits::DEFAULT.check().is_ok());
    }
}
