//! How long a program takes, by doing it on the twin.

use std::time::Duration;

use dobot_api::{
    CalibrationFile, ClientId, JobPhase, JobProgram, JobRepeat, JobState, NewJob, Request,
};
use dobot_controller::{Personality, PowerUp};
use dobot_safety::Policy;
use dobot_supervisor::Refusal;

use crate::VirtualStation;
use crate::jobs::journal_refusal;

/// How long a program takes on the twin, from when it was started.
#[derive(Clone, Debug, PartialEq)]
pub struct Prediction {
    /// When each command is seen to be over, in seconds, up to the end of the first cycle, waiting for people
    /// left out.
    pub until_s: Vec<f64>,
    /// How long a cycle takes that follows another one, in seconds; `None` where nothing is done again.
    pub cycle_s: Option<f64>,
}

/// Does a program on the twin in virtual time, under the rules that hold in a station, until it has done its cycle
/// twice. Persons who are waited for are there at once.
///
/// # Errors
///
/// [`Refusal`] with what is wrong with the job; and where the twin does not come to its end.
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
        .map_or(1, |it| it.times.unwrap_or(u64::MAX).min(CYCLES));
    let repeat = job.program.repeat.map(|it| JobRepeat {
        times: Some(cycles),
        ..it
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
    let cycle = repeat.map(|it| commands - it.from).filter(|_| cycles > 1);
    let cycle_s = cycle.map(|len| until[commands + len - 1].saturating_sub(until[commands - 1]));
    Ok(Prediction {
        until_s: until[..commands]
            .iter()
            .map(Duration::as_secs_f64)
            .collect(),
        cycle_s: cycle_s.map(|it| it.as_secs_f64()),
    })
}

/// A program that is done on the twin.
struct DryRun {
    station: VirtualStation,
    client: ClientId,
    job: u64,
    started: Duration,
    /// How long people were waited for.
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

    /// When each command was over, those of later cycles too.
    fn finish(&mut self, job: &NewJob) -> Result<Vec<Duration>, Refusal> {
        let mut until: Vec<Duration> = Vec::new();
        while let Some((completed, _)) = self.station.supervisor().job_progress() {
            until.resize(completed.max(until.len()), self.elapsed());
            if rests(&self.station, self.job) {
                self.go_on(job, until.last().copied().unwrap_or_default())?;
            }
            let latest = self.station.now() + LONGEST;
            let is_elsewhere = |it: &VirtualStation| {
                let progress = it.supervisor().job_progress();
                progress.is_none_or(|it| it.0 != completed) || rests(it, self.job)
            };
            if !self.station.run_until(latest, is_elsewhere) {
                return Err(Refusal::BadJob {
                    index: completed,
                    why: "the twin does not get beyond it in two days".to_owned(),
                    rule: None,
                });
            }
        }
        until.resize(
            job.program.total(job.commands.len()).unwrap_or(0),
            self.elapsed(),
        );
        let latest = self.station.now() + SETTLED;
        let is_over = |it: &VirtualStation| it.job(self.job).is_ok_and(|it| it.state.is_over());
        self.station.run_until(latest, is_over);
        match self.state()? {
            JobState::Done => Ok(until),
            state => Err(Refusal::CannotResume(format!(
                "on the twin the program is {state}"
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
        job.map(|it| it.state)
            .map_err(|error| journal_refusal(&error))
    }

    /// The arm rests, and a person says at once that it may go on; how long it rested does not count.
    fn go_on(&mut self, job: &NewJob, until: Duration) -> Result<(), Refusal> {
        let state = self.state()?;
        if !job
            .pauses
            .iter()
            .any(|it| state.reason() == Some(&it.message))
        {
            return Err(Refusal::CannotResume(format!(
                "on the twin the program is {state}"
            )));
        }
        self.station.start(self.client, self.job)?;
        let latest = self.station.now() + LONGEST;
        self.station
            .run_until(latest, |it| it.supervisor().has_active_job());
        self.waited = self.station.now().saturating_sub(self.started + until);
        Ok(())
    }
}

/// Whether the job is paused, and the journal knows it: the arm is at rest.
fn rests(station: &VirtualStation, job: u64) -> bool {
    let progress = station.supervisor().job_progress();
    let is_paused = |it: JobPhase| it == JobPhase::Paused;
    progress.is_some_and(|it| is_paused(it.1))
        && station.job(job).is_ok_and(|it| is_paused(it.state.phase()))
}

/// A cycle that follows another one takes as long as all later ones.
const CYCLES: u64 = 3;
/// Until the twin has told where it is, and its journal is written.
const SETTLED: Duration = Duration::from_secs(1);
/// No command takes longer, its pause included.
const LONGEST: Duration = Duration::from_secs(2 * 86_400);
