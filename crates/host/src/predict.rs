//! Prediction of a program's duration by running it on the twin.

use std::time::Duration;

use dobot_api::{
    CalibrationFile, ClientId, JobPhase, JobProgram, JobRepeat, JobState, NewJob, Request,
};
use dobot_controller::{Personality, PowerUp};
use dobot_safety::Policy;
use dobot_supervisor::Refusal;

use crate::VirtualStation;
use crate::jobs::journal_refusal;

/// The duration of a program on the twin, from its start.
#[derive(Clone, Debug, PartialEq)]
pub struct Prediction {
    /// When each command is over, in seconds, up to the end of the first cycle, without waits for a
    /// person.
    pub until_s: Vec<f64>,
    /// The duration of a repeated cycle, in seconds; `None` if nothing repeats.
    pub cycle_s: Option<f64>,
}

/// Runs a program on the twin in virtual time, under the rules of a station, until it has done its
/// cycle twice. Pauses for a person are confirmed immediately.
///
/// # Errors
///
/// [`Refusal`] with what is wrong with the job, or if the twin does not finish it.
pub fn predict(
    job: &NewJob,
    policy: &Policy,
    personality: Personality,
    calibration: Option<&CalibrationFile>,
) -> Result<Prediction, Refusal> {
    let commands = job.commands.len();
    let cycles = job
        .program
        .repeat
        .map_or(1, |repeat| repeat.times.unwrap_or(u64::MAX).min(CYCLES));
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
    let mut dry_run = DryRun::begin(&job, policy, personality, calibration)?;
    let until = dry_run.finish(&job)?;
    let cycle = repeat
        .map(|repeat| commands - repeat.from)
        .filter(|_| cycles > 1);
    let cycle_s = cycle.map(|len| until[commands + len - 1].saturating_sub(until[commands - 1]));
    Ok(Prediction {
        until_s: until[..commands]
            .iter()
            .map(Duration::as_secs_f64)
            .collect(),
        cycle_s: cycle_s.map(|cycle_s| cycle_s.as_secs_f64()),
    })
}

/// A program running on the twin.
struct DryRun {
    station: VirtualStation,
    client: ClientId,
    job: u64,
    started: Duration,
    /// The time spent waiting for a person.
    waited: Duration,
}

impl DryRun {
    fn begin(
        job: &NewJob,
        policy: &Policy,
        personality: Personality,
        calibration: Option<&CalibrationFile>,
    ) -> Result<Self, Refusal> {
        let mut station = VirtualStation::new(PowerUp::new(personality), policy.clone());
        station.free_laser();
        station.run_for(SETTLED);
        let client = station.client("prediction");
        let calibration = calibration.cloned().map(Box::new);
        station.ask(client, Request::Calibrate { calibration })?;
        station.ask(client, Request::TakeLease)?;
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

    /// Returns when each command was over, including those of later cycles.
    fn finish(&mut self, job: &NewJob) -> Result<Vec<Duration>, Refusal> {
        let mut until: Vec<Duration> = Vec::new();
        while let Some((completed, _)) = self.station.supervisor().job_progress() {
            until.resize(completed.max(until.len()), self.elapsed());
            if rests(&self.station, self.job) {
                self.resume(job, until.last().copied().unwrap_or_default())?;
            }
            let latest = self.station.now() + LONGEST;
            let is_elsewhere = |station: &VirtualStation| {
                let progress = station.supervisor().job_progress();
                progress.is_none_or(|progress| progress.0 != completed) || rests(station, self.job)
            };
            if !self.station.run_until(latest, is_elsewhere) {
                return Err(Refusal::BadJob {
                    index: completed,
                    why: "the twin does not finish it in two days".to_owned(),
                    rule: None,
                });
            }
        }
        until.resize(
            job.program.total(job.commands.len()).unwrap_or(0),
            self.elapsed(),
        );
        let latest = self.station.now() + SETTLED;
        let is_over =
            |station: &VirtualStation| station.job(self.job).is_ok_and(|job| job.state.is_over());
        self.station.run_until(latest, is_over);
        match self.state()? {
            JobState::Done => Ok(until),
            state => Err(Refusal::CannotResume(format!(
                "on the twin, the program is {state}"
            ))),
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
    fn resume(&mut self, job: &NewJob, until: Duration) -> Result<(), Refusal> {
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
        self.waited = self.station.now().saturating_sub(self.started + until);
        Ok(())
    }
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

/// The second cycle takes as long as all later ones.
const CYCLES: u64 = 3;
/// The time for the twin's first status and its journal.
const SETTLED: Duration = Duration::from_secs(1);
/// No command takes longer, including its pause.
const LONGEST: Duration = Duration::from_secs(2 * 86_400);
