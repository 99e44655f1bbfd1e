//! Dry runs: the problems and durations of a program, by running it on the twin.

use std::time::Duration;

use dobot_api::{ClientId, JobPhase, JobProgram, JobRepeat, JobState, NewJob, Request};
use dobot_controller::{Personality, PowerUp};
use dobot_supervisor::Refusal;
use dobot_teach::{Compiled, Files, Problem, Program, ProgramError, check};
use dobot_wire::{Command, Dialect, MoveJoints, MovingMode, Status};
use serde::Serialize;

use crate::jobs::journal_refusal;
use crate::{PlannedFor, VirtualStation};

/// The problems of a program, and its durations on the twin, without waits for a person.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DryRun {
    /// All problems, in the order of the steps.
    pub problems: Vec<Problem>,
    /// The duration of each step the first time, in seconds, by the motion model, without the motion
    /// that cannot be planned.
    pub steps_s: Vec<f64>,
    /// The duration of all steps once, in seconds, from the current position of the arm; `None` if
    /// there are problems.
    pub first_s: Option<f64>,
    /// The duration of each further cycle, in seconds; `None` if nothing repeats or there are
    /// problems.
    pub cycle_s: Option<f64>,
    /// The total duration, in seconds; `None` if the program repeats until a person ends it or
    /// there are problems.
    pub total_s: Option<f64>,
    /// Whether durations depend on answers: then they are those with the first answer of each
    /// question, without waiting for it.
    pub depends_on_answers: bool,
}

impl DryRun {
    const fn without_times(problems: Vec<Problem>, steps_s: Vec<f64>) -> Self {
        Self {
            problems,
            steps_s,
            first_s: None,
            cycle_s: None,
            total_s: None,
            depends_on_answers: false,
        }
    }
}

/// Runs each path through a program on the twin, see [`Program::paths`]. Returns the first one, and
/// the problems of all.
///
/// # Errors
///
/// [`ProgramError`] if the program cannot be compiled.
pub fn dry_run_program(
    program: &Program,
    arm: &PlannedFor,
    files: &mut dyn Files,
) -> Result<(Compiled, DryRun), ProgramError> {
    let mut paths = program.paths(&arm.arm(), files)?.into_iter();
    let first = paths.next();
    let first = first.ok_or_else(|| ProgramError::new("the program has no steps"))?;
    let mut found = dry_run(&first, arm);
    found.depends_on_answers = first.asks;
    for path in paths {
        for problem in dry_run(&path, arm).problems {
            let is_same = |known: &Problem| {
                (known.line, &known.file, &known.message)
                    == (problem.line, &problem.file, &problem.message)
            };
            if !found.problems.iter().any(is_same) {
                found.problems.push(problem);
            }
        }
    }
    if !found.problems.is_empty() {
        (found.first_s, found.cycle_s, found.total_s) = (None, None, None);
    }
    Ok((first, found))
}

/// Runs a program on the twin of an arm, in virtual time: from where the arm stands, with its
/// settings and calibration, under its policy. Pauses for a person are confirmed immediately.
#[must_use]
pub fn dry_run(program: &Compiled, arm: &PlannedFor) -> DryRun {
    let report = check(program, &arm.rules.policy, arm.model());
    if !report.problems.is_empty() {
        return DryRun::without_times(report.problems, report.steps_s);
    }
    let job = NewJob {
        title: "dry run".to_owned(),
        ..program.job()
    };
    match times(&job, arm) {
        Ok(times) => DryRun {
            first_s: Some(times.first),
            cycle_s: times.cycle,
            total_s: times.total,
            ..DryRun::without_times(Vec::new(), report.steps_s)
        },
        Err(failed) => {
            let problems = failed.problem(program).into_iter().collect();
            DryRun::without_times(problems, report.steps_s)
        }
    }
}

/// The durations of a job on the twin, in seconds.
struct Times {
    /// Of its first cycle.
    first: f64,
    /// Of each further cycle; `None` if nothing repeats.
    cycle: Option<f64>,
    /// Of all cycles; `None` if the job repeats until a person ends it.
    total: Option<f64>,
}

impl Times {
    const fn once(first: f64) -> Self {
        Self {
            first,
            cycle: None,
            total: Some(first),
        }
    }
}

/// Why the twin does not execute a job.
struct Failed {
    /// The first command that is not over, counted from 0.
    command: usize,
    refusal: Refusal,
}

impl Failed {
    fn problem(self, program: &Compiled) -> Option<Problem> {
        let command = self.command.min(program.commands.len().checked_sub(1)?);
        let remedy = self.refusal.hint().unwrap_or_default();
        let (rule, message) = match &self.refusal {
            Refusal::BadJob { why, rule, .. } => (rule.clone(), why.clone()),
            refusal => (None, refusal.to_string()),
        };
        let rule = rule.as_deref().unwrap_or("arm");
        Problem::of_command(program, command, rule, message, &remedy)
    }
}

/// The refusal of a job before its start.
impl From<Refusal> for Failed {
    fn from(refusal: Refusal) -> Self {
        let command = match refusal {
            Refusal::BadJob { index, .. } => index,
            _ => 0,
        };
        Self { command, refusal }
    }
}

/// Runs a job on the twin, with as many of its cycles as show how long a cycle takes.
fn times(job: &NewJob, arm: &PlannedFor) -> Result<Times, Failed> {
    let first_s = duration_s(job, arm, 1)?;
    let times = job.program.repeat.map_or(Some(1), |repeat| repeat.times);
    if times == Some(1) {
        return Ok(Times::once(first_s));
    }
    let cycles = executed_cycles(first_s);
    let some_s = duration_s(job, arm, cycles)?;
    let all_s = duration_s(job, arm, 2 * cycles)?;
    #[expect(clippy::cast_precision_loss, reason = "2^53 cycles never end")]
    let cycle_s = (all_s - some_s) / cycles as f64;
    let total_s = match times {
        None => None,
        Some(times) if times == cycles => Some(some_s),
        Some(times) if times < 2 * cycles => Some(duration_s(job, arm, times)?),
        #[expect(clippy::cast_precision_loss, reason = "2^53 cycles never end")]
        Some(times) => Some(all_s + cycle_s * (times - 2 * cycles) as f64),
    };
    Ok(Times {
        first: first_s,
        cycle: Some(cycle_s),
        total: total_s,
    })
}

/// Returns how many cycles to run on the twin to see how long one takes.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "it is small"
)]
fn executed_cycles(first_s: f64) -> u64 {
    ((EXECUTED_S / first_s) as u64).clamp(2, 5)
}

/// Returns the duration of a job with this number of cycles on the twin, in seconds, without waits
/// for a person.
fn duration_s(job: &NewJob, arm: &PlannedFor, cycles: u64) -> Result<f64, Failed> {
    let repeat = job.program.repeat.map(|repeat| JobRepeat {
        times: Some(cycles),
        ..repeat
    });
    let job = NewJob {
        program: JobProgram {
            repeat,
            ..job.program.clone()
        },
        ..job.clone()
    };
    let took = TwinRun::begin(&job, arm)?.finish(&job)?;
    Ok(took.as_secs_f64())
}

/// A program running on the twin.
struct TwinRun {
    station: VirtualStation,
    client: ClientId,
    job: u64,
    started: Duration,
    /// The time spent waiting for a person.
    waited: Duration,
}

impl TwinRun {
    fn begin(job: &NewJob, arm: &PlannedFor) -> Result<Self, Refusal> {
        let power_up = PowerUp::new(personality_of(arm.dialect()));
        let mut station = VirtualStation::new(power_up, arm.rules.policy.clone());
        station.free_laser();
        station.run_for(SETTLED);
        let client = station.client("dry run");
        station.ask(client, Request::TakeLease)?;
        prepare(&mut station, client, arm)?;
        let job = station.submit(job)?;
        station.start(client, job)?;
        Ok(Self {
            started: station.now(),
            station,
            client,
            job,
            waited: Duration::ZERO,
        })
    }

    /// Runs the job to its end, and returns its duration without waits for a person.
    fn finish(&mut self, job: &NewJob) -> Result<Duration, Failed> {
        let (mut last, mut last_over) = (0, Duration::ZERO);
        while let Some((completed, _)) = self.station.supervisor().job_progress() {
            if completed > last {
                (last, last_over) = (completed, self.elapsed());
            }
            if rests(&self.station, self.job) {
                let resumed = self.resume(job, last_over);
                resumed.map_err(|refusal| Failed {
                    command: completed,
                    refusal,
                })?;
            }
            self.run_on(completed)?;
        }
        self.outcome(last)
    }

    /// Runs until another command is executed or the arm rests. `completed` commands are over.
    fn run_on(&mut self, completed: usize) -> Result<(), Refusal> {
        let latest = self.station.now() + LONGEST;
        let is_elsewhere = |station: &VirtualStation| {
            let progress = station.supervisor().job_progress();
            progress.is_none_or(|progress| progress.0 != completed) || rests(station, self.job)
        };
        if self.station.run_until(latest, is_elsewhere) {
            return Ok(());
        }
        let why = "the twin does not finish it in two days";
        Err(Refusal::bad_job(completed, why))
    }

    /// Returns the duration of the completed job. `last` is the number of commands that were over.
    fn outcome(&mut self, last: usize) -> Result<Duration, Failed> {
        let took = self.elapsed();
        let latest = self.station.now() + SETTLED;
        let is_over =
            |station: &VirtualStation| station.job(self.job).is_ok_and(|job| job.state.is_over());
        self.station.run_until(latest, is_over);
        match self.state()? {
            JobState::Done => Ok(took),
            state => Err(Failed {
                command: last,
                refusal: Refusal::CannotResume(format!("on the twin, the program is {state}")),
            }),
        }
    }

    fn elapsed(&self) -> Duration {
        self.station
            .now()
            .saturating_sub(self.started + self.waited)
    }

    fn state(&self) -> Result<JobState, Refusal> {
        let job = self.station.job(self.job);
        job.map(|job| job.state)
            .map_err(|error| journal_refusal(&error))
    }

    /// Confirms a pause while the arm is at rest and resumes the job; the time at rest does not
    /// count.
    fn resume(&mut self, job: &NewJob, last_over: Duration) -> Result<(), Refusal> {
        let state = self.state()?;
        if !job
            .pauses
            .iter()
            .any(|pause| state.reason() == Some(&pause.message))
        {
            return Err(Refusal::CannotResume(format!(
                "on the twin, the program is {state}"
            )));
        }
        self.station.start(self.client, self.job)?;
        let latest = self.station.now() + LONGEST;
        self.station
            .run_until(latest, |station| station.supervisor().is_executing_job());
        self.waited = self.station.now().saturating_sub(self.started + last_over);
        Ok(())
    }
}

/// Brings the twin to where the arm stands, and sets its settings and calibration.
fn prepare(
    station: &mut VirtualStation,
    client: ClientId,
    arm: &PlannedFor,
) -> Result<(), Refusal> {
    if let Some(status) = &arm.status {
        let command = Command::from(move_to(status));
        // The policy may forbid the way to where the arm stands.
        if station.ask(client, Request::Command { command }).is_err() {
            station.guard(&[command.emit(&arm.dialect())]);
        }
        station.run_for(ARRIVED);
    }
    for command in arm.settings.iter().copied() {
        station.ask(client, Request::Command { command })?;
    }
    if let Some(calibration) = arm.calibration.clone().map(Box::new) {
        let calibration = Some(calibration);
        station.ask(client, Request::Calibrate { calibration })?;
    }
    if !arm.settings.is_empty() || arm.calibration.is_some() {
        station.run_for(SETTLED);
    }
    Ok(())
}

/// Returns the move to the joint angles, the pump and the gripper of a status.
fn move_to(status: &Status) -> MoveJoints {
    MoveJoints {
        base_deg: status.base_deg,
        rear_deg: status.rear_deg,
        fore_deg: status.fore_deg,
        servo_deg: status.servo_deg,
        suction: status.suction,
        gripper_deg: status.gripper_deg,
        mode: MovingMode::MovJ,
        pause_s: 0.0,
    }
}

/// Returns the personality of a virtual arm that speaks a dialect.
///
/// # Panics
///
/// Never: each dialect is that of a personality.
#[must_use]
pub fn personality_of(dialect: Dialect) -> Personality {
    Personality::ALL
        .into_iter()
        .find(|personality| personality.dialect() == dialect)
        .expect("each dialect has a personality")
}

/// Returns whether the job is paused and the journal has that: the arm is at rest.
fn rests(station: &VirtualStation, job: u64) -> bool {
    let progress = station.supervisor().job_progress();
    let is_paused = |job_phase: JobPhase| job_phase == JobPhase::Paused;
    progress.is_some_and(|progress| is_paused(progress.1))
        && station
            .job(job)
            .is_ok_and(|job| is_paused(job.state.phase()))
}

/// About so much of a repeated program is executed to measure a cycle, in seconds.
const EXECUTED_S: f64 = 300.0;
/// The time for the twin's first status and its journal.
const SETTLED: Duration = Duration::from_secs(1);
/// The arm has reached any position after this time at the speed of power-up.
const ARRIVED: Duration = Duration::from_secs(10);
/// No command takes longer, including its pause.
const LONGEST: Duration = Duration::from_secs(2 * 86_400);
