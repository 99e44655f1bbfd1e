//! Errors of the journal.

use std::io;

use dobot_api::JobState;
use dobot_wire::ParseError;

use crate::JobId;

/// The error returned when the journal cannot do what was requested. Its jobs are unchanged.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum JournalError {
    /// The storage is full. Earlier content is intact, and the journal works again as soon as there
    /// is room.
    #[error("there is no room left for the journal {file} ({source}); free some and try again")]
    Full {
        /// The file.
        file: String,
        /// The operating system's error.
        source: io::Error,
    },

    /// The storage failed. Whether the change was made shows in
    /// [`Journal::jobs`](crate::Journal::jobs) once the storage works again; it is never made in
    /// part.
    #[error("the storage of the journal {file} failed: {source}")]
    Io {
        /// The file.
        file: String,
        /// The operating system's error.
        source: io::Error,
    },

    /// Another program has it open.
    #[error("the journal {file} is open in another program; stop that one or use another file")]
    InUse {
        /// The file.
        file: String,
    },

    /// The file is not a journal. Nothing in it was changed.
    #[error("{file} is not a journal of jobs ({found}); move it away or use another file")]
    Foreign {
        /// The file.
        file: String,
        /// The kind of content found.
        found: String,
    },

    /// A newer version of this program wrote it. Nothing in it was changed.
    #[error(
        "the journal {file} has format {found}; this version knows formats up to {known}: use a \
         newer version or move the file away"
    )]
    Newer {
        /// The file.
        file: String,
        /// The format.
        found: u64,
        /// The newest format that this version knows.
        known: u64,
    },

    /// The content is invalid.
    #[error(
        "the journal {file} is damaged ({found}); restore a copy, or move it away to begin with \
         an empty one"
    )]
    Damaged {
        /// The file.
        file: String,
        /// The problem found.
        found: String,
    },

    /// No job has this number.
    #[error("there is no job {0}; it may have been removed")]
    NoSuchJob(JobId),

    /// A longer program does not begin with the commands of its job.
    #[error("the longer program does not begin with the commands of job {0}; they may be done")]
    Shorter(JobId),

    /// A command is not valid for an arm with the job's dialect.
    #[error("command {index} of the job cannot be sent: {source}")]
    NotSendable {
        /// The index of the command, from 0.
        index: usize,
        /// The reason.
        source: ParseError,
    },

    /// A command would not be read back as it was written.
    #[error(
        "command {index} of the job reads differently once it is a packet; take numbers that a \
         packet holds exactly"
    )]
    NotExact {
        /// The index of the command, from 0.
        index: usize,
    },

    /// The lift of a job is not above 0.
    #[error("the lift of the job is {0} mm; a finite length above 0 is allowed")]
    Lift(f32),

    /// A pause is not before a command after that of the previous pause.
    #[error(
        "pause {index} of the job is before command {before}; allowed are {least} to {most}",
        most = commands.saturating_sub(1)
    )]
    Pause {
        /// The index of the pause, from 0.
        index: usize,
        /// The command it is placed before.
        before: usize,
        /// The earliest command allowed.
        least: usize,
        /// The number of commands of the job.
        commands: usize,
    },

    /// Its steps or its cycle do not fit its commands.
    #[error("the program of the job is invalid: {0}")]
    Program(String),

    /// A number of the job cannot be written.
    #[error("{name} of the job is {found}; a finite number is allowed")]
    Number {
        /// The name of the number.
        name: &'static str,
        /// The value found.
        found: f64,
    },

    /// A window is outside the job, or begins before what is done.
    #[error(
        "commands {completed}..{upto} cannot be given: job {job} has {commands} commands, of \
         which {done} are done"
    )]
    Window {
        /// The job.
        job: JobId,
        /// The start of the window.
        completed: usize,
        /// The end of the window.
        upto: usize,
        /// The number of commands known to be done.
        done: usize,
        /// The number of commands of the job.
        commands: usize,
    },

    /// The start position of a window contains values that no status can contain.
    #[error("the start position of the window of job {job} is invalid: {source}")]
    Start {
        /// The job.
        job: JobId,
        /// The reason.
        source: ParseError,
    },

    /// A window was extended for a job that is not running.
    #[error("job {job} is {state}; only a running job may get commands")]
    NotRunning {
        /// The job.
        job: JobId,
        /// Its state.
        state: JobState,
    },

    /// The idempotency key was already used for another job.
    #[error("key {key:?} was already used for a different request (job {job}); use a new key")]
    KeyReused {
        /// The key.
        key: String,
        /// The other job.
        job: JobId,
    },

    /// A started job that is not over cannot be removed.
    #[error("job {job} is {state}; stop it before it is removed")]
    Unfinished {
        /// The job.
        job: JobId,
        /// Its state.
        state: JobState,
    },
}
