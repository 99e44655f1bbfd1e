//! Jobs as table rows, and checks that they can be read back.

use std::iter::repeat;

use dobot_api::{AskingProgram, JobKind, JobPause, JobProgram, JobRepeat, JobState};
use dobot_arm::Calibration;
use dobot_wire::{Command, Dialect, Frame, PACKET_LEN, Packet, Status};
use serde::{Deserialize, Serialize};

use crate::{Adjustment, Job, JobExtension, JobHistory, JobId, JournalError, PlannedJob, Window};

/// A row of the table of jobs, as JSON.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct JobRow {
    title: String,
    kind: JobKind,
    dialect: String,
    lift_mm: Option<f32>,
    created_ms: i64,
    commands: usize,
    pub(crate) state: JobState,
    // Missing in format 1.
    #[serde(default)]
    planned_s: Option<f64>,
    #[serde(default)]
    pauses: Vec<JobPause>,
    #[serde(default)]
    pub(crate) adjustment: Adjustment,
    #[serde(default = "unknown", rename = "behind")]
    pub(crate) history: JobHistory,
    // Missing in format 2; the steps are in a table of their own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    repeat: Option<JobRepeat>,
    // Missing in format 3.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    calibration: Option<[f64; 10]>,
    // Missing in format 4.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) key: Option<String>,
    // Missing in format 5.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    asking: Option<Box<AskingProgram>>,
}

/// The history of a job that started before it was recorded.
const fn unknown() -> JobHistory {
    JobHistory {
        pauses: 0,
        ran_s: None,
    }
}

impl JobRow {
    /// Builds the row of a new queued job.
    pub(crate) fn new(job: &PlannedJob) -> Result<Self, JournalError> {
        job.lift_mm.map_or(Ok(()), check_lift)?;
        check_contents(&job.pauses, &job.program, job.commands.len())?;
        Ok(Self {
            title: job.title.clone(),
            kind: job.kind,
            dialect: job.dialect.name().to_owned(),
            lift_mm: job.lift_mm,
            created_ms: job.created_ms,
            commands: job.commands.len(),
            state: JobState::Queued,
            planned_s: job.planned_s,
            pauses: job.pauses.clone(),
            adjustment: Adjustment::default(),
            history: JobHistory::default(),
            repeat: job.program.repeat,
            calibration: Some(job.calibration)
                .filter(|calibration| !calibration.is_none())
                .map(|calibration| calibration.to_numbers()),
            key: job.key.clone(),
            asking: job.program.asking.clone(),
        })
    }

    pub(crate) fn to_bytes(&self) -> Vec<u8> {
        serde_json::to_vec(self).expect("strings and finite numbers are always JSON")
    }

    pub(crate) fn from_bytes(bytes: &[u8]) -> Result<Self, String> {
        serde_json::from_slice(bytes).map_err(|error| format!("a row of a job: {error}"))
    }

    /// Changes the state. A job that is over never runs again: its end may have been reported
    /// already.
    pub(crate) fn change_state(
        &mut self,
        job: JobId,
        state: &JobState,
    ) -> Result<(), JournalError> {
        if self.state.is_over() && *state == JobState::Running {
            let state = self.state.clone();
            return Err(JournalError::NotRunning { job, state });
        }
        self.state = state.clone();
        Ok(())
    }

    pub(crate) fn dialect(&self) -> Result<Dialect, String> {
        self.dialect
            .parse()
            .map_err(|error| format!("the dialect {:?}: {error}", self.dialect))
    }

    /// Returns the total number of commands over all cycles.
    pub(crate) fn total(&self) -> usize {
        let program = JobProgram {
            repeat: self.repeat,
            ..JobProgram::default()
        };
        program.total(self.commands).unwrap_or(usize::MAX)
    }

    fn program(&self, steps: JobProgram) -> JobProgram {
        JobProgram {
            repeat: self.repeat,
            asking: self.asking.clone(),
            ..steps
        }
    }

    /// Replaces commands, pauses and steps by those of a longer program with the same beginning.
    pub(crate) fn extend(&mut self, longer: &JobExtension) {
        self.commands = longer.commands.len();
        self.pauses.clone_from(&longer.pauses);
        self.asking.clone_from(&longer.program.asking);
    }

    pub(crate) fn job(self, id: JobId, steps: JobProgram, window: Window) -> Result<Job, String> {
        Ok(Job {
            id,
            dialect: self.dialect()?,
            calibration: self
                .calibration
                .map_or(Calibration::NONE, Calibration::from_numbers),
            program: self.program(steps),
            title: self.title,
            kind: self.kind,
            lift_mm: self.lift_mm,
            created_ms: self.created_ms,
            planned_s: self.planned_s,
            commands: self.commands,
            pauses: self.pauses,
            adjustment: self.adjustment,
            state: self.state,
            key: self.key,
            history: self.history,
            window,
        })
    }
}

fn check_lift(lift_mm: f32) -> Result<(), JournalError> {
    if lift_mm.is_finite() && lift_mm > 0.0 {
        Ok(())
    } else {
        Err(JournalError::Lift(lift_mm))
    }
}

/// Checks the pauses and the program of a job with this number of commands.
pub(crate) fn check_contents(
    pauses: &[JobPause],
    program: &JobProgram,
    commands: usize,
) -> Result<(), JournalError> {
    check_pauses(pauses, commands)?;
    program.check(commands).map_err(JournalError::Program)
}

/// Checks that pauses are in the order of their commands, each at a different command.
fn check_pauses(pauses: &[JobPause], commands: usize) -> Result<(), JournalError> {
    let mut least = 0;
    for (index, pause) in pauses.iter().enumerate() {
        if !(least..commands).contains(&pause.before) {
            return Err(JournalError::Pause {
                index,
                before: pause.before,
                least,
                commands,
            });
        }
        least = pause.before + 1;
    }
    Ok(())
}

/// Returns the packets of a job in sequence: what the arm will get, bit by bit.
pub(crate) fn packets(commands: &[Command], dialect: &Dialect) -> Result<Vec<u8>, JournalError> {
    let mut bytes = Vec::with_capacity(commands.len() * PACKET_LEN);
    for (index, command) in commands.iter().enumerate() {
        let packet = command.emit(dialect);
        let back = Command::parse(&packet, dialect)
            .map_err(|source| JournalError::NotSendable { index, source })?;
        if back != *command {
            return Err(JournalError::NotExact { index });
        }
        bytes.extend_from_slice(&packet.to_bytes());
    }
    Ok(bytes)
}

/// Reads the commands written by [`packets`].
pub(crate) fn commands(bytes: &[u8], row: &JobRow) -> Result<Vec<Command>, String> {
    let dialect = row.dialect()?;
    let (packets, rest) = bytes.as_chunks::<PACKET_LEN>();
    if !rest.is_empty() || packets.len() != row.commands {
        return Err(format!(
            "{} bytes of commands where {} commands belong",
            bytes.len(),
            row.commands
        ));
    }
    let command = |(index, bytes): (usize, &[u8; PACKET_LEN])| {
        let packet = Packet::from_bytes(bytes).ok_or(format!("command {index} is no packet"))?;
        Command::parse(&packet, &dialect).map_err(|error| format!("command {index}: {error}"))
    };
    packets.iter().enumerate().map(command).collect()
}

/// Encodes the first command of each step, and its line.
pub(crate) fn steps_bytes(program: &JobProgram) -> Vec<u8> {
    let lines = program.lines.iter().copied().chain(repeat(0));
    // A job has at most a million commands.
    let bytes =
        |(step, line): (&usize, u32)| ((u64::from(line) << 32) | *step as u64).to_le_bytes();
    program.steps.iter().zip(lines).flat_map(bytes).collect()
}

/// Decodes the steps and lines written by [`steps_bytes`].
pub(crate) fn steps(bytes: &[u8]) -> Result<JobProgram, String> {
    let (steps, rest) = bytes.as_chunks();
    if !rest.is_empty() {
        return Err(format!("{} bytes of steps", bytes.len()));
    }
    let words = steps.iter().map(|bytes| u64::from_le_bytes(*bytes));
    let steps = words.clone().map(|word| index(word & u64::from(u32::MAX)));
    let lines: Vec<u32> = words.map(|word| (word >> 32) as u32).collect();
    // Jobs of earlier versions have none.
    let has_lines = lines.iter().any(|line| *line > 0);
    Ok(JobProgram {
        steps: steps.collect::<Result<_, _>>()?,
        lines: if has_lines { lines } else { Vec::new() },
        ..JobProgram::default()
    })
}

/// Encodes the start position of a window; empty if there is none.
pub(crate) fn start_bytes(job: JobId, start: Option<&Status>) -> Result<Vec<u8>, JournalError> {
    let Some(status) = start else {
        return Ok(Vec::new());
    };
    let frame = status.emit();
    Status::parse(&frame).map_err(|source| JournalError::Start { job, source })?;
    Ok(frame.to_bytes().to_vec())
}

/// Decodes the window of a row: start, end, and the packet of a status.
pub(crate) fn window((completed, upto, start): (u64, u64, &[u8])) -> Result<Window, String> {
    Ok(Window {
        completed: index(completed)?,
        upto: index(upto)?,
        start: match start {
            [] => None,
            bytes => Some(status(bytes)?),
        },
    })
}

fn status(bytes: &[u8]) -> Result<Status, String> {
    let frame = <&[u8; PACKET_LEN]>::try_from(bytes)
        .ok()
        .and_then(Frame::from_bytes)
        .ok_or("the start of a window is no packet")?;
    Status::parse(&frame).map_err(|error| format!("the start of a window: {error}"))
}

fn index(number: u64) -> Result<usize, String> {
    usize::try_from(number).map_err(|_| format!("command {number} of a job"))
}
