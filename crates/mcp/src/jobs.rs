//! Jobs: queued, started, followed, changed.

use std::time::Duration;

use dobot_api::{JobPhase, JobView, Reply, Request, StationEvent, post};
use dobot_host::{JobWatch, StationClient, run_long};
use serde_json::{Value, json};
use tokio::time::timeout;

use crate::arguments::{
    ChangeJob, JobAction, ProgramArguments, ProgramText, RunProgram, WhichJobs,
};
use crate::call::{Call, wait};
use crate::refused::Refused;

impl Call {
    /// What the station says of a program.
    pub(crate) async fn check_program(&self, program: ProgramArguments) -> Result<Value, Refused> {
        let program = self.program(program).await?;
        Ok(post(&self.station().await?, "/api/v1/programs/check", &program).await?)
    }

    pub(crate) async fn run_program(&self, asked: RunProgram) -> Result<Value, Refused> {
        let time = wait(asked.wait_s)?;
        let program = self.program(asked.program).await?;
        let times = asked.times.map(|it| json!({ "count": it }));
        let mut station = self.connect().await?;
        if !self.asks(&station) {
            // Nothing is queued that cannot be started.
            station.request(Request::TakeLease).await?;
        }
        let new = json!({ "program": program, "times": times });
        let reply: Reply = post(&self.station().await?, "/api/v1/programs/jobs", &new).await?;
        let Reply::Job { job } = reply else {
            return Err(Refused::new(
                "no-station",
                "the station does not tell which job it queued",
            ));
        };
        self.start_new(&mut station, job.job, time).await
    }

    async fn program(&self, asked: ProgramArguments) -> Result<ProgramText, Refused> {
        let text = match (asked.text, asked.file) {
            (Some(text), None) => text,
            (None, Some(file)) => {
                let (name, bytes) = self.file(file).await?;
                let no_text = |_| Refused::new("file", format!("{name} is not text in UTF-8"));
                String::from_utf8(bytes).map_err(no_text)?
            }
            _ => {
                return Err(Refused::new(
                    "invalid",
                    "a program has either `text` or `file`",
                ));
            }
        };
        Ok(ProgramText {
            text,
            files: asked.files,
        })
    }

    /// The name and the bytes of a file of the folder for agents.
    pub(crate) async fn file(&self, name: String) -> Result<(String, Vec<u8>), Refused> {
        let Some(files) = self.shared.settings.files.clone() else {
            return Err(
                Refused::new("file", "no folder with files for agents was told")
                    .hinted("the person who starts it says which: `dobot mcp --files FOLDER`"),
            );
        };
        run_long(move || files.read(&name)).await?
    }

    /// Starts a job that was just queued and follows it, or leaves it to a person.
    pub(crate) async fn start_new(
        &self,
        station: &mut StationClient,
        job: u64,
        time: Duration,
    ) -> Result<Value, Refused> {
        if self.asks(station) {
            let told = format!(
                "job {job} is queued, and begins when a person starts it: on the station's page, or with `dobot jobs start {job}`"
            );
            return Ok(json!({ "told": told, "job": view(station, job).await? }));
        }
        self.shared.own_jobs.add(&self.name(), job);
        if let Err(refused) = start(station, job).await {
            station.remove_unstarted(job).await;
            return Err(refused);
        }
        follow(station, job, time).await
    }

    pub(crate) async fn jobs(&self, which: WhichJobs) -> Result<Value, Refused> {
        let time = wait(which.wait_s)?;
        let mut station = self.connect().await?;
        let Some(job) = which.job else {
            let mut jobs = station.jobs().await?;
            let over = jobs.iter().filter(|it| it.phase.is_over()).count();
            let mut left_out = over.saturating_sub(LATEST);
            let told = left_out;
            jobs.retain(|it| {
                let is_old = it.phase.is_over() && left_out > 0;
                left_out -= usize::from(is_old);
                !is_old
            });
            return Ok(json!({ "jobs": jobs, "left_out": told }));
        };
        if !time.is_zero() && view(&mut station, job).await?.phase == JobPhase::Running {
            let _ = timeout(time, rest(&mut station, job)).await;
        }
        Ok(json!({ "job": view(&mut station, job).await? }))
    }

    /// Pauses or ends a job: it moves nothing that would not move without it.
    pub(crate) async fn end_job(&self, asked: &ChangeJob) -> Result<Value, Refused> {
        let (mut station, job) = (self.connect().await?, asked.job);
        if asked.action == JobAction::Cancel {
            station.request(Request::CancelJob { job }).await?;
        } else {
            let found = view(&mut station, job).await?;
            if found.phase != JobPhase::Running {
                return Err(
                    Refused::new("no-job-runs", format!("job {job} does not run"))
                        .hinted("only a running job can be paused; `jobs` lists all of them"),
                );
            }
            station.request(Request::PauseJob).await?;
            let paused = view(&mut station, job).await?;
            self.shared.own_jobs.note_paused(&self.name(), &paused);
        }
        Ok(json!({ "job": view(&mut station, job).await? }))
    }

    pub(crate) async fn resume_job(&self, asked: &ChangeJob) -> Result<Value, Refused> {
        let time = wait(asked.wait_s)?;
        let mut station = self.connect().await?;
        self.check_may_move(&station)?;
        let found = view(&mut station, asked.job).await?;
        self.shared
            .own_jobs
            .check_may_resume(&self.name(), &found)?;
        station.request(Request::TakeLease).await?;
        start(&mut station, asked.job).await?;
        follow(&mut station, asked.job, time).await
    }
}

/// Starts a job, or goes on with it; control has been taken. It is given back: whoever is there may pause it.
async fn start(station: &mut StationClient, job: u64) -> Result<(), Refused> {
    station.request_at_rest(Request::StartJob { job }).await?;
    station.request(Request::ReleaseLease).await?;
    Ok(())
}

/// Waits until a job does not run any more, but no longer than this.
async fn follow(station: &mut StationClient, job: u64, time: Duration) -> Result<Value, Refused> {
    let mut watch = JobWatch::new(job);
    let over = async {
        loop {
            if let StationEvent::Notice(notice) = station.next().await?
                && let Some(over) = watch.handle_notice(&notice)
            {
                return Ok::<_, Refused>(over);
            }
        }
    };
    let told = match timeout(time, over).await {
        Err(_) => "it runs, and goes on; `jobs` tells how far it is".to_owned(),
        Ok(Err(error)) => return Err(error),
        Ok(Ok((JobPhase::Stopped | JobPhase::Failed, text))) => {
            return Err(Refused::new("not-done", text));
        }
        Ok(Ok((_, text))) => text,
    };
    Ok(json!({ "told": told, "job": view(station, job).await? }))
}

/// Until a job that runs does not any more.
async fn rest(station: &mut StationClient, job: u64) -> Result<(), Refused> {
    loop {
        let state = station.state().await?;
        let runs = |it: &JobView| it.job == job && it.phase == JobPhase::Running;
        if !state.job.as_ref().is_some_and(runs) {
            return Ok(());
        }
    }
}

async fn view(station: &mut StationClient, job: u64) -> Result<JobView, Refused> {
    let jobs = station.jobs().await?;
    let found = jobs.into_iter().find(|it| it.job == job);
    found.ok_or_else(|| {
        Refused::new("no-such-job", format!("there is no job {job}"))
            .hinted("`jobs` lists all of them")
    })
}

/// How many jobs that are over are listed.
const LATEST: usize = 20;
