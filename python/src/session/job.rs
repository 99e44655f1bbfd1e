//! Jobs: drawings and programs.

use dobot_api::{JobPhase, JobView, NewJob, PendingQuestion, Request, State, StationEvent};
use dobot_draw::{DrawingRequest, WITHOUT_ARM_Z_MM};
use dobot_host::{JobWatch, PlannedFor, drawing_job};
use dobot_motion::burns;

use super::{Session, publish};
use crate::failure::{Failure, failed};
use crate::follow::Follow;
use crate::mailbox::Sender;
use crate::program::Run;
use crate::worker::{Progress, Report};

/// A paused job that can be resumed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rests {
    job: u64,
    burns: bool,
}

impl Session {
    /// Plans a drawing for this arm, and draws it as a job.
    pub(super) async fn draw(
        &mut self,
        request: DrawingRequest,
        reports: &Sender<Report>,
    ) -> Result<(), Failure> {
        let title = request.title.clone();
        let (state, arm) = self.planned_for().await?;
        // A virtual arm in this process has its own paper.
        let z_mm = match (&state.arm, self.client.virtual_arm()) {
            (Some(arm), None) => arm.status.z_mm.into(),
            _ => WITHOUT_ARM_Z_MM,
        };
        // A stop is received meanwhile.
        let planning = tokio::task::spawn_blocking(move || {
            let request = request.calibrated(arm.calibration);
            request.prepare(arm.dialect, z_mm)
        });
        let (prepared, _) = planning
            .await
            .map_err(|error| failed(error.to_string()))?
            .map_err(|error| failed(error.to_string()))?;
        let job = drawing_job(&prepared.plan, &title);
        self.begin(job, &state, reports).await
    }

    /// Converts a program to a job for this arm, and runs it.
    pub(super) async fn run(&mut self, run: Run, reports: &Sender<Report>) -> Result<(), Failure> {
        let (state, arm) = self.planned_for().await?;
        self.asks = run.asks;
        let making = tokio::task::spawn_blocking(move || run.job(&arm));
        let job = making.await.map_err(|error| failed(error.to_string()))?;
        let job = job.map_err(|error| Failure::Refused(Box::new(error)))?;
        self.begin(job, &state, reports).await
    }

    /// Moves through points as a job.
    pub(super) async fn follow_path(
        &mut self,
        follow: Follow,
        reports: &Sender<Report>,
    ) -> Result<(), Failure> {
        let (state, arm) = self.planned_for().await?;
        let planning = tokio::task::spawn_blocking(move || follow.job(&arm));
        let job = planning.await.map_err(|error| failed(error.to_string()))?;
        let job = job.map_err(|problem| Failure::Refused(Box::new(problem)))?;
        self.begin(job, &state, reports).await
    }

    /// Returns the arm to plan for.
    pub(super) async fn planned_for(&mut self) -> Result<(State, PlannedFor), Failure> {
        let state = self.client.first_state().await?;
        let arm = self.client.planned_for(&state).await;
        Ok((state, arm.map_err(|error| failed(error.to_string()))?))
    }

    /// Queues and runs a job.
    async fn begin(
        &mut self,
        job: NewJob,
        state: &State,
        reports: &Sender<Report>,
    ) -> Result<(), Failure> {
        let burns = job.commands.iter().any(burns);
        let client = &mut self.client;
        if burns && client.virtual_arm().is_none() && state.laser.armed_for_s <= 0.0 {
            return Err(Failure::Failed {
                text: "the laser is disarmed".to_owned(),
                hint: Some(
                    "put on goggles, then arm the laser with `arm.arm_laser(60)` or on the station's page"
                        .to_owned(),
                ),
            });
        }
        client.request(Request::TakeLease).await?;
        let job = client.submit(job).await?;
        let begun = self.start(Rests { job, burns }, reports).await;
        if let Err(Failure::Refused(_)) = begun {
            self.client.remove_unstarted(job).await;
        }
        begun
    }

    /// Resumes the paused job; with `as_person`, a person has done what it waits for.
    pub(super) async fn resume(
        &mut self,
        as_person: bool,
        reports: &Sender<Report>,
    ) -> Result<(), Failure> {
        let rests = self.rests()?;
        self.client.request(Request::TakeLease).await?;
        if as_person {
            let job = rests.job;
            self.client.request(Request::ConfirmJob { job }).await?;
        }
        self.start(rests, reports).await
    }

    /// Cancels the paused job.
    pub(super) async fn cancel(&mut self) -> Result<(), Failure> {
        let Rests { job, .. } = self.rests()?;
        self.client.request(Request::TakeLease).await?;
        self.client.request(Request::CancelJob { job }).await?;
        self.rests = None;
        Ok(())
    }

    fn rests(&self) -> Result<Rests, Failure> {
        self.rests
            .ok_or_else(|| failed("there is no paused job of this connection".to_owned()))
    }

    /// Starts or resumes a job, and waits until it stops running.
    async fn start(&mut self, rests: Rests, reports: &Sender<Report>) -> Result<(), Failure> {
        let Rests { job, burns } = rests;
        self.client
            .request_at_rest(Request::StartJob { job })
            .await?;
        // Recorded now, so that the job can be resumed if waiting ends early.
        self.rests = Some(rests);
        if !burns {
            // A person at the arm may change its speed.
            self.client.request(Request::ReleaseLease).await?;
        }
        let (phase, text) = self.follow(job, reports).await?;
        if phase == JobPhase::Paused {
            // The in-flight commands finish, and the tool is lifted.
            self.client.idle().await?;
            return Err(Failure::Paused { job, text });
        }
        self.rests = None;
        match phase {
            JobPhase::Done => Ok(()),
            _ => Err(failed(text)),
        }
    }

    /// Asks the question of a program, and sends its answer. Time stands still meanwhile on a virtual
    /// arm of this process.
    async fn answer(
        &mut self,
        job: u64,
        question: Option<&PendingQuestion>,
        reports: &Sender<Report>,
    ) -> Result<(), Failure> {
        let Some(pending) = question else {
            return Ok(());
        };
        if !self.asks {
            return self.check_answered(pending);
        }
        let text =
            serde_json::to_string(&pending.question).map_err(|error| failed(error.to_string()))?;
        reports.send(Report::Question(text));
        let Some(answer) = self.answers.recv().await else {
            return Err(Failure::Closed);
        };
        let answer = Request::AnswerJob {
            job,
            question: Some(pending.number),
            answer,
        };
        self.client.request(answer).await?;
        Ok(())
    }

    /// Checks that somebody answers a question, though not this connection.
    fn check_answered(&self, pending: &PendingQuestion) -> Result<(), Failure> {
        if self.client.virtual_arm().is_none() || pending.otherwise.is_some() {
            return Ok(());
        }
        Err(failed(format!(
            "the program asks: {}; give `run` a function `ask` that answers",
            pending.question
        )))
    }

    /// Waits until the job stops running.
    async fn follow(
        &mut self,
        job: u64,
        reports: &Sender<Report>,
    ) -> Result<(JobPhase, String), Failure> {
        let mut watch = JobWatch::new(job);
        let mut asked = None;
        loop {
            match self.client.next().await? {
                StationEvent::State(state) => {
                    self.handle_state(job, &state, &mut asked, reports).await?;
                }
                StationEvent::Notice(notice) => {
                    if let Some(ended) = watch.handle_notice(&notice) {
                        return Ok(ended);
                    }
                }
            }
        }
    }

    /// Shows the progress of the job, and asks its question once.
    async fn handle_state(
        &mut self,
        job: u64,
        state: &State,
        asked: &mut Option<PendingQuestion>,
        reports: &Sender<Report>,
    ) -> Result<(), Failure> {
        publish(&self.statuses, state);
        let view = state.job.as_ref();
        let Some(view) = view.filter(|view| view.job == job) else {
            return Ok(());
        };
        reports.send(Report::Progress(progress(view)));
        if *asked != view.question {
            asked.clone_from(&view.question);
            self.answer(job, asked.as_ref(), reports).await?;
        }
        Ok(())
    }
}

/// Returns the commands of a drawing, or the steps and cycles of a program.
fn progress(job: &JobView) -> Progress {
    match &job.program {
        None => Progress::Commands {
            completed: job.completed,
            commands: job.commands,
        },
        Some(program) => Progress::Steps {
            step: (program.step + 1).min(program.steps),
            steps: program.steps,
            cycle: (program.cycles_done + 1).min(program.cycles.unwrap_or(u64::MAX)),
            cycles: program.cycles,
        },
    }
}
