//! The job that runs the program.

use dobot_api::{JobPhase, JobView, NewJob, Request, State};
use dobot_host::PlannedFor;
use dobot_motion::burns;

use super::Teacher;
use crate::program_file::files_beside;
use crate::verbs::teach::lesson::Part;

/// The job of a program, and the text that it was created from.
#[derive(Debug)]
pub(super) struct TaughtJob {
    job: u64,
    text: String,
}

/// The extent of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum JobStart {
    /// To the end.
    Run,
    /// One step.
    Step,
}

impl Teacher {
    /// The job of the program, as the station reports it.
    pub(in crate::verbs::teach) fn job(&self) -> Option<&JobView> {
        let own = self.job.as_ref()?.job;
        let job = self.pendant.state()?.job.as_ref();
        job.filter(|job| job.job == own)
    }

    pub(super) fn run(&mut self, part: Part, start: JobStart) {
        let phase = self.job().map(|job| job.phase);
        if phase == Some(JobPhase::Running) {
            let text = "running: p pauses, x ends, Space stops the arm";
            return self.pendant.show(text.into());
        }
        let text = self.lesson.text();
        if let Some(own) = &self.job
            && phase == Some(JobPhase::Paused)
        {
            // A changed program, or another start, needs a new job.
            if own.text == text && part == Part::All {
                return self.pendant.send(start.request(own.job));
            }
            self.pendant.send(Request::CancelJob { job: own.job });
        }
        self.submit(part, start);
    }

    fn submit(&mut self, part: Part, start: JobStart) {
        let rules = self.settings.rules.clone();
        let arm = match self.pendant.state() {
            Some(state) => PlannedFor::of(rules, state),
            None => PlannedFor::any(rules, None),
        };
        let mut files = files_beside(&self.file, &arm);
        match self.lesson.job(part, &mut files, &arm) {
            Ok(job) => {
                if !self.arm_laser(&job) {
                    return;
                }
                self.job = None;
                self.submitting = Some(start);
                self.pendant.send(Request::SubmitJob { job, key: None });
            }
            Err(why) => self.pendant.show(format!("not run: {why}")),
        }
    }

    /// Arms the laser for a program that burns; returns whether the program may run.
    fn arm_laser(&mut self, job: &NewJob) -> bool {
        if !job.commands.iter().any(burns) {
            return true;
        }
        let Some(for_s) = self.settings.arm_laser.map(|time| time.as_secs_f64()) else {
            self.pendant.show(
                "not run: it uses the laser; quit, put on goggles, and teach with --arm-laser SECONDS".into(),
            );
            return false;
        };
        self.pendant.send(Request::ArmLaser { for_s });
        true
    }

    pub(super) fn cancel(&mut self) {
        match self.job().map(|job| job.job) {
            Some(job) => self.pendant.send(Request::CancelJob { job }),
            None => self.pendant.show("no program is running".into()),
        }
    }

    /// Starts the submitted job once the arm is at rest; a stop cancels the start.
    pub(super) fn start_at_rest(&mut self, state: &State) {
        if state.stop.is_some() {
            self.starting = None;
        } else if is_at_rest(state)
            && let Some(request) = self.starting.take()
        {
            // The person who resumes the job has done what it waits for.
            if let Some(job) = state.job.as_ref().filter(|job| job.waits_for_person) {
                self.pendant.send(Request::ConfirmJob { job: job.job });
            }
            self.pendant.send(request);
        }
    }

    /// The station has the job.
    pub(super) fn handle_submitted(&mut self, job: u64) {
        if let Some(start) = self.submitting.take() {
            self.starting = Some(start.request(job));
            self.tries = 0;
            self.job = Some(TaughtJob {
                job,
                text: self.lesson.text(),
            });
        }
    }

    /// Whether a refused start is repeated, because the arm was still moving.
    pub(super) fn tries_again(&mut self, request: &Request, kind: Option<&str>) -> bool {
        let starts = matches!(request, Request::StartJob { .. } | Request::StepJob { .. });
        let again = starts && kind == Some("still-moving") && self.tries < MAX_TRIES;
        if again {
            self.tries += 1;
            self.starting = Some(request.clone());
        } else if matches!(request, Request::SubmitJob { .. }) {
            self.submitting = None;
        }
        again
    }
}

impl JobStart {
    const fn request(self, job: u64) -> Request {
        match self {
            Self::Run => Request::StartJob { job },
            Self::Step => Request::StepJob { job },
        }
    }
}

/// Whether no command is in flight, as far as the station has reported.
fn is_at_rest(state: &State) -> bool {
    let moving = state.arm.as_ref().is_some_and(|arm| arm.moving);
    !moving && state.queue.waiting + state.queue.under_way == 0
}

/// About two seconds of states.
const MAX_TRIES: u8 = 25;
