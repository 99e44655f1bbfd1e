//! Jobs: queued, started, observed, changed.

use std::time::Duration;

use dobot_api::{Answer, JobPhase, JobView, News, Reply, Request, StationEvent, post};
use dobot_host::{JobWatch, StationClient, run_long};
use serde_json::{Value, json};
use tokio::time::timeout;

use crate::arguments::{
    AnswerJob, ChangeJob, JobAction, ProgramArguments, ProgramText, RunProgram, WhichJobs,
};
use crate::call::{Call, wait};
use crate::consent::short;
use crate::refused::Refused;

impl Call {
    /// Returns the station's report on a program.
    pub(crate) async fn check_program(&self, program: ProgramArguments) -> Result<Value, Refused> {
        let program = self.program(program).await?;
        Ok(post(&self.station().await?, "/api/v1/programs/check", &program).await?)
    }

    pub(crate) async fn run_program(&self, asked: RunProgram) -> Result<Value, Refused> {
        let time = wait(asked.wait_s)?;
        let program = self.program(asked.program).await?;
        let times = asked.times.map(|time| json!({ "count": time }));
        let mut station = self.connect().await?;
        let what = format!("run a program of {} lines", program.text.lines().count());
        let may_start = self.may_start(&station, &what).await?;
        if may_start {
            // Nothing is queued that cannot be started.
            station.request(Request::TakeLease).await?;
        }
        let new = json!({ "program": program, "times": times });
        let reply: Reply = post(&self.station().await?, "/api/v1/programs/jobs", &new).await?;
        let Reply::Job { job } = reply else {
            return Err(Refused::new(
                "no-station",
                "the station did not return the number of the queued job",
            ));
        };
        self.start_new(&mut station, job.job, time, may_start).await
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
                return Err(Refused::new("invalid", "give either `text` or `file`"));
            }
        };
        Ok(ProgramText {
            text,
            files: asked.files,
        })
    }

    /// Reads a file in the folder for agents; returns its name and bytes.
    pub(crate) async fn file(&self, name: String) -> Result<(String, Vec<u8>), Refused> {
        let Some(files) = self.shared.settings.files.clone() else {
            return Err(Refused::new("file", "there is no folder for agents")
                .hinted("set one with `dobot mcp --files FOLDER`"));
        };
        run_long(move || files.read(&name)).await?
    }

    /// Starts and observes a newly queued job, or leaves it to a person.
    pub(crate) async fn start_new(
        &self,
        station: &mut StationClient,
        job: u64,
        time: Duration,
        may_start: bool,
    ) -> Result<Value, Refused> {
        if !may_start {
            let text = format!(
                "job {job} is queued; a person has to start it, on the station's page or with `dobot jobs start {job}`"
            );
            return Ok(json!({ "message": text, "job": view(station, job).await? }));
        }
        self.shared.own_jobs.add(&self.name(), job);
        if let Err(refused) = start(station, job).await {
            station.remove_unstarted(job).await;
            return Err(refused);
        }
        self.follow(station, job, time).await
    }

    pub(crate) async fn jobs(&self, which: WhichJobs) -> Result<Value, Refused> {
        let time = wait(which.wait_s)?;
        let mut station = self.connect().await?;
        let Some(job) = which.job else {
            let mut jobs = station.jobs().await?;
            let over = jobs.iter().filter(|job| job.phase.is_over()).count();
            let mut left_out = over.saturating_sub(LATEST);
            let left_out_in_all = left_out;
            jobs.retain(|job| {
                let is_old = job.phase.is_over() && left_out > 0;
                left_out -= usize::from(is_old);
                !is_old
            });
            return Ok(json!({ "jobs": jobs, "left_out": left_out_in_all }));
        };
        if !time.is_zero() && view(&mut station, job).await?.phase == JobPhase::Running {
            let _ = timeout(time, rest(&mut station, job)).await;
        }
        Ok(json!({ "job": view(&mut station, job).await? }))
    }

    /// Pauses or cancels a job, which causes no new motion.
    pub(crate) async fn end_job(&self, asked: &ChangeJob) -> Result<Value, Refused> {
        let (mut station, job) = (self.connect().await?, asked.job);
        if asked.action == JobAction::Cancel {
            station.request(Request::CancelJob { job }).await?;
        } else {
            let found = view(&mut station, job).await?;
            if found.phase != JobPhase::Running {
                return Err(
                    Refused::new("no-job-runs", format!("job {job} is not running"))
                        .hinted("only a running job can be paused; `jobs` lists all jobs"),
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
        let found = view(&mut station, asked.job).await?;
        self.shared
            .own_jobs
            .check_may_resume(&self.name(), &found)?;
        let question = format!("resume job {}, \"{}\"", asked.job, short(&found.title));
        self.check_may_move(&station, &question).await?;
        station.request(Request::TakeLease).await?;
        start(&mut station, asked.job).await?;
        self.follow(&mut station, asked.job, time).await
    }
}

impl Call {
    /// Answers the question of a program that this agent has started, unless it is for a person.
    pub(crate) async fn answer_job(&self, asked: AnswerJob) -> Result<Value, Refused> {
        let time = wait(asked.wait_s)?;
        let mut station = self.connect().await?;
        let found = view(&mut station, asked.job).await?;
        self.shared
            .own_jobs
            .check_may_answer(&self.name(), &found)?;
        let question = format!("answer job {}, \"{}\"", asked.job, short(&found.title));
        self.check_may_move(&station, &question).await?;
        let answer = match (asked.answer, asked.place) {
            (Some(answer), None) => Answer::Choice(answer),
            (None, Some(place)) => Answer::Place(place),
            _ => return Err(Refused::new("arguments", "give either answer or place")),
        };
        let job = asked.job;
        let question = found.question.map(|pending| pending.number);
        let request = Request::AnswerJob {
            job,
            question,
            answer,
        };
        station.request(request).await?;
        self.follow(&mut station, job, time).await
    }
}

impl Call {
    /// Waits until a job stops running, within a timeout.
    async fn follow(
        &self,
        station: &mut StationClient,
        job: u64,
        time: Duration,
    ) -> Result<Value, Refused> {
        let over = self.until_over(station, job);
        let text = match timeout(time, over).await {
            Err(_) => "the job is still running; `jobs` shows its progress".to_owned(),
            Ok(Err(error)) => return Err(error),
            Ok(Ok((JobPhase::Stopped | JobPhase::Failed, text))) => {
                return Err(Refused::new("not-done", text));
            }
            Ok(Ok((_, text))) => text,
        };
        Ok(json!({ "message": text, "job": view(station, job).await? }))
    }

    /// Waits until a job stops running or asks; returns how it is, and the text about that.
    async fn until_over(
        &self,
        station: &mut StationClient,
        job: u64,
    ) -> Result<(JobPhase, String), Refused> {
        let mut watch = JobWatch::new(job);
        let mut progress = Progress::default();
        loop {
            let notice = match station.next().await? {
                StationEvent::Notice(notice) => notice,
                StationEvent::State(state) => {
                    if let Some(view) = state.job.as_ref().filter(|view| view.job == job) {
                        progress.report(self, state.at_s, view).await;
                    }
                    continue;
                }
            };
            if notice.news == (News::JobAsks { job }) {
                return Ok((JobPhase::Running, notice.text));
            }
            if let Some(over) = watch.handle_notice(&notice) {
                return Ok(over);
            }
        }
    }
}

/// The progress of a job, for an agent that asked for it.
#[derive(Default)]
struct Progress {
    reported: Option<usize>,
    /// The earliest time of the next report, in seconds since the station started.
    next_s: f64,
}

impl Progress {
    /// Reports the completed commands, at most once a second.
    async fn report(&mut self, call: &Call, at_s: f64, view: &JobView) {
        if at_s < self.next_s || self.reported == Some(view.completed) {
            return;
        }
        self.reported = Some(view.completed);
        self.next_s = at_s + 1.0;
        call.report_progress(view.completed, view.commands, &view.title)
            .await;
    }
}

/// Starts or resumes a job after control has been taken, then releases control, so that a person at
/// the arm may pause it.
async fn start(station: &mut StationClient, job: u64) -> Result<(), Refused> {
    station.request_at_rest(Request::StartJob { job }).await?;
    station.request(Request::ReleaseLease).await?;
    Ok(())
}

/// Waits until a job stops running.
async fn rest(station: &mut StationClient, job: u64) -> Result<(), Refused> {
    loop {
        let state = station.state().await?;
        let runs = |view: &JobView| view.job == job && view.phase == JobPhase::Running;
        if !state.job.as_ref().is_some_and(runs) {
            return Ok(());
        }
    }
}

async fn view(station: &mut StationClient, job: u64) -> Result<JobView, Refused> {
    let jobs = station.jobs().await?;
    let found = jobs.into_iter().find(|view| view.job == job);
    found.ok_or_else(|| {
        Refused::new("no-such-job", format!("there is no job {job}"))
            .hinted("`jobs` lists all jobs")
    })
}

/// The number of finished jobs that are listed.
const LATEST: usize = 20;
