//! Jobs: what is drawn, and programs.

use dobot_api::{JobPhase, JobView, NewJob, RemoteError, Request, State, StationEvent};
use dobot_draw::{DrawingRequest, WITHOUT_ARM_Z_MM};
use dobot_host::{JobWatch, PlannedFor, Rules, drawing_job};
use dobot_motion::burns;
use dobot_safety::Policy;

use super::{Session, tell};
use crate::failure::{Failure, failed};
use crate::mailbox::Teller;
use crate::program::Run;
use crate::worker::{Progress, Told};

/// A job that rests and can be gone on with.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rests {
    job: u64,
    burns: bool,
}

impl Session {
    /// Plans it for this arm, and draws it as a job.
    pub(super) async fn draw(
        &mut self,
        request: DrawingRequest,
        told: &Teller<Told>,
    ) -> Result<(), Failure> {
        let title = request.title.clone();
        let (state, arm) = self.planned_for().await?;
        // A virtual arm in this process has its own paper.
        let z_mm = match (&state.arm, self.client.virtual_arm()) {
            (Some(arm), None) => arm.status.z_mm.into(),
            _ => WITHOUT_ARM_Z_MM,
        };
        // A stop is heard meanwhile.
        let planning = tokio::task::spawn_blocking(move || {
            let request = request.calibrated(arm.calibration);
            request.prepare(arm.dialect, z_mm)
        });
        let (prepared, _) = planning
            .await
            .map_err(|it| failed(it.to_string()))?
            .map_err(|it| failed(it.to_string()))?;
        let job = drawing_job(&prepared.plan, &title);
        self.begin(job, &state, told).await
    }

    /// Makes a program into a job for this arm, and does it.
    pub(super) async fn run(&mut self, run: Run, told: &Teller<Told>) -> Result<(), Failure> {
        let (state, arm) = self.planned_for().await?;
        let making = tokio::task::spawn_blocking(move || run.job(&arm));
        let job = making.await.map_err(|it| failed(it.to_string()))?;
        let job = job.map_err(|it| Failure::Refused(Box::new(it)))?;
        self.begin(job, &state, told).await
    }

    /// What is known of this arm: for it is planned.
    pub(super) async fn planned_for(&mut self) -> Result<(State, PlannedFor), Failure> {
        let state = self.client.first_state().await?;
        let rules = Rules::of(&Policy::default());
        let arm = self.client.planned_for(rules, &state).await;
        Ok((state, arm.map_err(|it| failed(it.to_string()))?))
    }

    /// Queues a job and does it.
    async fn begin(
        &mut self,
        job: NewJob,
        state: &State,
        told: &Teller<Told>,
    ) -> Result<(), Failure> {
        let burns = job.commands.iter().any(burns);
        let client = &mut self.client;
        if burns && client.virtual_arm().is_none() && state.laser.armed_for_s <= 0.0 {
            return Err(Failure::Failed {
                text: "the laser is disarmed".to_owned(),
                hint: Some(
                    "put the goggles on, then arm it: `arm.arm_laser(60)`, or on the station's page"
                        .to_owned(),
                ),
            });
        }
        client.request(Request::TakeLease).await?;
        let job = client.submit(job).await?;
        let begun = self.start(Rests { job, burns }, told).await;
        if let Err(Failure::Refused(_)) = begun {
            self.client.remove_unstarted(job).await;
        }
        begun
    }

    /// Goes on with the job that rests; with `as_person`, a person has done what it waits for.
    pub(super) async fn resume(
        &mut self,
        as_person: bool,
        told: &Teller<Told>,
    ) -> Result<(), Failure> {
        let rests = self.rests()?;
        self.client.request(Request::TakeLease).await?;
        if as_person {
            let job = rests.job;
            self.client.request(Request::ConfirmJob { job }).await?;
        }
        self.start(rests, told).await
    }

    /// Gives up the job that rests.
    pub(super) async fn cancel(&mut self) -> Result<(), Failure> {
        let Rests { job, .. } = self.rests()?;
        self.client.request(Request::TakeLease).await?;
        self.client.request(Request::CancelJob { job }).await?;
        self.rests = None;
        Ok(())
    }

    fn rests(&self) -> Result<Rests, Failure> {
        self.rests.ok_or_else(|| {
            failed("no job of this connection rests that could be gone on with".to_owned())
        })
    }

    /// Starts a job or goes on with it, and follows it until it does not run any more.
    async fn start(&mut self, it: Rests, told: &Teller<Told>) -> Result<(), Failure> {
        let Rests { job, burns } = it;
        self.client
            .request_at_rest(Request::StartJob { job })
            .await?;
        // It is known from here on; where following it ends early, it can be gone on with.
        self.rests = Some(it);
        if !burns {
            // Whoever is there may change its speed.
            self.client.request(Request::ReleaseLease).await?;
        }
        let (phase, text) = self.follow(job, told).await?;
        match phase {
            JobPhase::Paused => {
                // What the arm has got already it does, and it lifts the tool.
                self.client.idle().await?;
                Err(Failure::Paused { job, text })
            }
            JobPhase::Done => {
                self.rests = None;
                Ok(())
            }
            _ => {
                self.rests = None;
                Err(failed(text))
            }
        }
    }

    /// Until the job does not run any more.
    async fn follow(
        &mut self,
        job: u64,
        told: &Teller<Told>,
    ) -> Result<(JobPhase, String), RemoteError> {
        let mut watch = JobWatch::new(job);
        loop {
            match self.client.next().await? {
                StationEvent::State(state) => {
                    tell(&self.ears, &state);
                    if let Some(it) = state.job.as_ref().filter(|it| it.job == job) {
                        told.tell(Told::Progress(progress(it)));
                    }
                }
                StationEvent::Notice(notice) => {
                    if let Some(ended) = watch.handle_notice(&notice) {
                        return Ok(ended);
                    }
                }
            }
        }
    }
}

/// Of a drawing the commands are told, of a program its steps and cycles.
fn progress(job: &JobView) -> Progress {
    match &job.program {
        None => Progress::Commands {
            completed: job.completed,
            commands: job.commands,
        },
        Some(it) => Progress::Steps {
            step: (it.step + 1).min(it.steps),
            steps: it.steps,
            cycle: (it.cycles_done + 1).min(it.cycles.unwrap_or(u64::MAX)),
            cycles: it.cycles,
        },
    }
}
