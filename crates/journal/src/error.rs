//! Why the journal could not do what it was asked.

use std::io;

use dobot_api::JobState;
use dobot_wire::ParseError;

use crate::JobId;

/// Why the journal could not do what it was asked. Jobs that it holds stay as they are.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum JournalError {
    /// There is no room left. What was there before is intact, and the journal works again as soon
    /// as there is room.
    #[error("no room is left for the journal {file} ({source}); free some and try again")]
    Full {
        /// The file.
        file: String,
        /// What the system says.
        source: io::Error,
    },

    /// The storage failed. Whether the change is there, [`Journal::jobs`](crate::Journal::jobs)
    /// tells once the storage works again; it is never half there.
    #[error("the storage of the journal {file} failed: {source}")]
    Io {
        /// The file.
        file: String,
        /// What the system says.
        source: io::Error,
    },

    /// Another program has it open.
    #[error("the journal {file} is open in another program; stop that one or use another file")]
    InUse {
        /// The file.
        file: String,
    },

    /// The file is something else. Nothing in it was changed.
    #[error("{file} is not a journal of jobs ({found}); move it away or use another file")]
    Foreign {
        /// The file.
        file: String,
        /// What it is instead.
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
        /// Its format.
        found: u64,
        /// The newest format that this version knows.
        known: u64,
    },

    /// What it holds makes no sense.
    #[error(
        "the journal {file} is damaged ({found}); restore a copy, or move it away to begin with \
         an empty one"
    )]
    Damaged {
        /// The file.
        file: String,
        /// What was found.
        found: String,
    },

    /// No job has this number.
    #[error("there is no job {0}; it may have been removed")]
    NoSuchJob(JobId),

    /// A command is none that an arm with the job's dialect understands.
    #[error("command {index} of the job cannot be sent: {source}")]
    NotSendable {
        /// Which one, counted from 0.
        index: usize,
        /// Why.
        source: ParseError,
    },

    /// A command would not come out of the journal as it was put in.
    #[error(
        "command {index} of the job reads differently once it is a packet; take numbers that a \
         packet holds exactly"
    )]
    NotExact {
        /// Which one, counted from 0.
        index: usize,
    },

    /// The lift of a job is not a length above 0.
    #[error("the lift of the job is {0} mm; a finite length above 0 is allowed")]
    Lift(f32),

    /// A pause does not stand before a command behind that of the pause before.
    #[error(
        "pause {index} of the job stands before command {before}; {least} to {most} are allowed",
        most = commands.saturating_sub(1)
    )]
    Pause {
        /// Which one, counted from 0.
        index: usize,
        /// Where it stands.
        before: usize,
        /// Where it may stand at the earliest.
        least: usize,
        /// How many commands the job has.
        commands: usize,
    },

    /// Its steps or its cycle do not fit its commands.
    #[error("the program of the job makes no sense: {0}")]
    Program(String),

    /// A number of the job is none that can be written.
    #[error("{name} of the job is {found}; a finite number is allowed")]
    Number {
        /// Which number.
        name: &'static str,
        /// What was found.
        found: f64,
    },

    /// A window leaves the job, or goes back behind what is done.
    #[error(
        "commands {completed}..{upto} cannot be given: job {job} has {commands} commands, of \
         which {done} are done"
    )]
    Window {
        /// The job.
        job: JobId,
        /// Where the window begins.
        completed: usize,
        /// Where it ends.
        upto: usize,
        /// How many commands are known to be done.
        done: usize,
        /// How many commands the job has.
        commands: usize,
    },

    /// The place at which a window begins holds what no status can hold.
    #[error("the place where the window of job {job} begins makes no sense: {source}")]
    Start {
        /// The job.
        job: JobId,
        /// Why.
        source: ParseError,
    },

    /// Commands of a job were to be given that does not run.
    #[error("job {job} is {state}; only a running one is given commands")]
    NotRunning {
        /// The job.
        job: JobId,
        /// Its state.
        state: JobState,
    },

    /// Another job was asked for with the same key.
    #[error("job {job}, another one, was asked for with the key {key:?}; each request has its own")]
    KeyReused {
        /// The key.
        key: String,
        /// The other job.
        job: JobId,
    },

    /// A job that has begun and is not over was to be removed.
    #[error("job {job} is {state}; stop it before it is removed")]
    Unfinished {
        /// The job.
        job: JobId,
        /// Its state.
        state: JobState,
    },
}
