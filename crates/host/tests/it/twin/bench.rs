//! A virtual arm on the bench, and something to draw.

use std::time::Duration;

use dobot_api::{JobKind, JobPause, JobPhase, JobView, NewJob, News, Reply, Request, StationEvent};
use dobot_arm::Position;
use dobot_controller::{Personality, PowerUp};
use dobot_draw::Sample;
use dobot_geometry::{Point, Stroke};
use dobot_host::StationClient;
use dobot_plan::{ArmLimits, DrawingTool, Laser, Paper, Pass, Pen, Plan};
use dobot_safety::Policy;
use dobot_session::position;
use dobot_sim::RECORDING_PERIOD;
use dobot_wire::Status;

pub(crate) struct Bench {
    station: StationClient,
    /// The questions to the person.
    pub(crate) asked: Vec<String>,
    /// The tool positions in the statuses.
    pub(crate) seen: Vec<Position>,
}

impl Bench {
    pub(crate) async fn new(personality: Personality) -> Self {
        let power_up = PowerUp::new(personality);
        let mut station = StationClient::with_virtual_arm(power_up, Policy::default(), "bench");
        station.state().await.unwrap();
        station.request(Request::TakeLease).await.unwrap();
        let arm = station.virtual_arm_mut().unwrap();
        arm.record(RECORDING_PERIOD);
        Self {
            station,
            asked: Vec::new(),
            seen: Vec::new(),
        }
    }

    /// Draws the plan, resuming after each pause; returns how long the arm took.
    pub(crate) async fn draw(&mut self, plan: &Plan) -> Duration {
        let job = self.submit(plan).await;
        loop {
            let (phase, text) = self.run(job, usize::MAX).await;
            match phase {
                JobPhase::Done => return self.took(job).await,
                JobPhase::Paused => {
                    self.asked.push(text);
                    self.rest().await;
                }
                _ => panic!("{text}"),
            }
        }
    }

    /// Pauses the drawing after this many commands; returns the job when the arm is at rest.
    pub(crate) async fn draw_until(&mut self, plan: &Plan, commands: usize) -> JobView {
        let job = self.submit(plan).await;
        let (phase, text) = self.run(job, commands).await;
        assert_eq!(phase, JobPhase::Paused, "{text}");
        self.rest().await.unwrap()
    }

    async fn submit(&mut self, plan: &Plan) -> u64 {
        let pause = |(before, message): (usize, &str)| JobPause {
            before,
            message: message.to_owned(),
        };
        #[expect(clippy::cast_possible_truncation, reason = "as a job holds it")]
        let job = NewJob {
            title: "bench".to_owned(),
            kind: JobKind::Drawing,
            commands: plan.commands().collect(),
            lift_mm: plan.lift_mm() as f32,
            pauses: plan.breaks_in_commands().map(pause).collect(),
            program: dobot_api::JobProgram::default(),
        };
        match self
            .station
            .request(Request::SubmitJob { job, key: None })
            .await
            .unwrap()
        {
            Reply::Job { job } => job.job,
            other => panic!("{other:?}"),
        }
    }

    /// Returns the status of the arm.
    pub(crate) async fn status(&mut self) -> Status {
        self.station.state().await.unwrap().arm.unwrap().status
    }

    /// Returns the planned duration of the last job, in s.
    pub(crate) async fn planned_s(&mut self) -> f64 {
        let jobs = self.station.jobs().await.unwrap();
        jobs.last().unwrap().planned_s.unwrap()
    }

    async fn took(&mut self, job: u64) -> Duration {
        let jobs = self.station.jobs().await.unwrap();
        let job = jobs.iter().find(|view| view.job == job).unwrap();
        Duration::from_secs_f64(job.took_s.unwrap())
    }

    /// Waits until it no longer runs; returns its end and its notices.
    async fn run(&mut self, job: u64, until: usize) -> (JobPhase, String) {
        for request in [Request::ConfirmJob { job }, Request::StartJob { job }] {
            self.station.request(request).await.unwrap();
        }
        let mut asked = false;
        loop {
            match self.station.next().await.unwrap() {
                StationEvent::State(state) => {
                    let status = state.arm.map(|arm| arm.status);
                    self.seen.extend(status.as_ref().map(position));
                    if !asked && state.job.is_some_and(|job| job.completed >= until) {
                        asked = true;
                        self.station.request(Request::PauseJob).await.unwrap();
                    }
                }
                StationEvent::Notice(notice) => {
                    let News::Job { phase, .. } = notice.news else {
                        continue;
                    };
                    if phase != JobPhase::Running {
                        return (phase, notice.text);
                    }
                }
            }
        }
    }

    /// Waits until the arm is at rest; returns the job.
    async fn rest(&mut self) -> Option<JobView> {
        let mut job = None;
        let rest = self.station.rest_with_events(|event| {
            if let StationEvent::State(state) = event {
                job.clone_from(&state.job);
            }
        });
        rest.await.unwrap();
        job
    }

    pub(crate) fn samples(&self) -> Vec<Sample> {
        let arm = self.station.virtual_arm().unwrap();
        let sample = |sample: &dobot_sim::Sample| Sample {
            at: sample.at,
            position: sample.position,
            laser: sample.laser,
        };
        arm.samples().iter().map(sample).collect()
    }
}

pub(crate) const PAPER: Paper = Paper::level(-40.0);

pub(crate) fn line(points: &[(f64, f64)]) -> Stroke {
    Stroke::open(points.iter().map(|&(x, y)| Point::new(x, y)).collect())
}

pub(crate) fn square(x: f64, y: f64, side: f64) -> Stroke {
    let corners = [
        (0.0, 0.0),
        (side, 0.0),
        (side, side),
        (0.0, side),
        (0.0, 0.0),
    ];
    line(&corners.map(|(dx, dy)| (x + dx, y + dy)))
}

pub(crate) fn pen(name: &str, strokes: Vec<Stroke>) -> Pass {
    Pass {
        name: name.to_owned(),
        ..Pass::new(DrawingTool::Pen(Pen::default()), strokes)
    }
}

pub(crate) fn laser(strokes: Vec<Stroke>, times: u32) -> Pass {
    let laser = Laser {
        times,
        ..Laser::default()
    };
    Pass::new(DrawingTool::Laser(laser), strokes)
}

pub(crate) fn plan(passes: &[Pass], personality: Personality) -> Plan {
    let arm_limits = ArmLimits::of(personality.dialect());
    Plan::new(passes, &PAPER, &arm_limits).unwrap()
}
