//! The job that the arm is at: one vector after the other, none twice, none left out.

use std::collections::VecDeque;
use std::time::Duration;

use dobot_arm::Position;
use dobot_client::{CommandId, position};
use dobot_course::Model;
use dobot_journal::{Window, locate, model_at, prelude, window_end};
use dobot_wire::{Command, Dialect, MoveTo, MovingMode, Status, WriteMode, WriteVector};

use super::{JobPlan, Keeper};
use crate::words::{ClientId, JobKind, JobPhase, JobView, News, Refusal, Reply};

/// What the journal is to keep.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// Before any command below `upto` is sent, this has to be on the disk: [`Keeper::handle_given`]
    /// says that it is.
    Give {
        /// The job.
        job: u64,
        /// So many commands are over.
        completed: usize,
        /// Commands below this one may be sent.
        upto: usize,
        /// The arm as command `completed` finds it.
        start: Option<Status>,
    },
    /// The job is in another phase.
    Phase {
        /// The job.
        job: u64,
        /// The phase.
        phase: JobPhase,
        /// Why.
        reason: Option<String>,
        /// How far the job is for certain, where that is news.
        window: Option<Window>,
    },
}

/// A job that is to be begun, or gone on with.
#[derive(Clone, Debug)]
pub struct Begun {
    /// Its number.
    pub job: u64,
    /// What a person calls it.
    pub title: String,
    /// What kind of job.
    pub kind: JobKind,
    /// What the arm has to speak.
    pub dialect: Dialect,
    /// Its commands.
    pub plan: JobPlan,
    /// So many of them are over.
    pub completed: usize,
}

/// The job that the arm is at, or that is paused.
#[derive(Debug)]
pub(super) struct Run {
    begun: Begun,
    phase: Phase,
    /// The arm when the job was started or gone on with.
    from: Option<Status>,
    /// The next command to be given to the session.
    next: usize,
    /// Commands below this one may be sent: the journal has it.
    durable: usize,
    /// The journal has been asked for that.
    asked: usize,
    /// Given to the session and not over.
    given: VecDeque<(CommandId, usize)>,
}

#[derive(Debug)]
enum Phase {
    /// The station was started after a crash: where does the arm rest?
    Locating {
        window: Window,
    },
    /// On the way to where it goes on.
    Approaching {
        last: Option<CommandId>,
    },
    Running,
    /// The arm does what it has got already.
    Draining {
        then: JobPhase,
        reason: String,
        lift: bool,
    },
    /// The tool is lifted for a pause.
    Lifting {
        last: CommandId,
        then: JobPhase,
        reason: String,
    },
    Paused {
        reason: String,
    },
}

impl Run {
    pub(super) const fn job(&self) -> u64 {
        self.begun.job
    }

    /// So many statuses in a row that tell the same: nothing of a window is under way any more, not
    /// even a pause.
    fn rests_after(&self, window: &Window) -> u32 {
        let commands = self.begun.plan.commands();
        let upto = window.upto.min(commands.len());
        let possible = &commands[window.completed.min(upto)..upto];
        let longest_s = possible.iter().map(pause_s).fold(0.0, f32::max);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a pause is positive, and longer ones than a day are no pauses"
        )]
        let statuses = (longest_s.clamp(0.0, A_DAY_S) * STATUSES_PER_S).ceil() as u32;
        SURELY_AT_REST + statuses
    }

    /// What was given to the session and is not over.
    pub(super) fn under_way(&self) -> impl Iterator<Item = CommandId> {
        self.given.iter().map(|(id, _)| *id)
    }

    /// Whether nobody else may move the arm.
    pub(super) const fn has_the_arm(&self) -> bool {
        !matches!(self.phase, Phase::Paused { .. })
    }

    const fn view_phase(&self) -> JobPhase {
        match &self.phase {
            Phase::Approaching { .. } | Phase::Running => JobPhase::Running,
            Phase::Draining { then, .. } | Phase::Lifting { then, .. } => *then,
            Phase::Locating { .. } | Phase::Paused { .. } => JobPhase::Paused,
        }
    }

    fn reason(&self) -> Option<String> {
        match &self.phase {
            Phase::Locating { .. } => Some(RESTARTED.to_owned()),
            Phase::Draining { reason, .. }
            | Phase::Lifting { reason, .. }
            | Phase::Paused { reason } => Some(reason.clone()),
            Phase::Approaching { .. } | Phase::Running => None,
        }
    }

    /// How far it is when nothing is under way.
    fn certain(&self) -> Window {
        let completed = self.begun.completed;
        Window {
            completed,
            upto: completed,
            start: self.start(),
        }
    }

    /// How far the journal may be asked to let the job go on.
    fn window_end(&self, status: &Status) -> usize {
        let Begun {
            plan,
            dialect,
            completed,
            ..
        } = &self.begun;
        let model = model_at(*dialect, plan.commands(), &self.certain())
            .unwrap_or_else(|| Model::new(*dialect, status));
        window_end(plan.commands(), *completed, &model, plan.lift(), WINDOW)
    }

    /// The arm as the first command that is not over finds it.
    fn start(&self) -> Option<Status> {
        self.begun.plan.start(self.begun.completed).or(self.from)
    }

    pub(super) fn view(&self) -> JobView {
        let Begun {
            job,
            title,
            kind,
            plan,
            completed,
            ..
        } = &self.begun;
        JobView {
            job: *job,
            title: title.clone(),
            kind: *kind,
            phase: self.view_phase(),
            reason: self.reason(),
            commands: plan.len(),
            completed: *completed,
            planned_s: Some(plan.planned_s()),
            left_s: Some(plan.left_s(*completed)),
        }
    }
}

impl Keeper {
    /// Begins a job, or goes on with a paused one.
    ///
    /// # Errors
    ///
    /// [`Refusal`]; nothing has moved then.
    pub fn handle_start(
        &mut self,
        now: Duration,
        client: ClientId,
        begun: Begun,
    ) -> Result<Reply, Refusal> {
        self.handle_time(now);
        let started = self.start(client, begun);
        if let Err(refusal) = &started {
            self.tell_refused(client, refusal);
        }
        self.pump();
        started
    }

    /// Takes a job that was at work when the station ended without saying so: the laser goes off,
    /// and where the arm comes to rest tells how far the job got.
    pub fn handle_recovered(&mut self, now: Duration, begun: Begun, window: Window) {
        self.handle_time(now);
        self.session.distrust(RESTARTED);
        let completed = begun.completed;
        self.run = Some(Run {
            begun,
            phase: Phase::Locating { window },
            from: None,
            next: completed,
            durable: completed,
            asked: completed,
            given: VecDeque::new(),
        });
        self.changed = true;
    }

    /// The job that is at work or paused.
    #[must_use]
    pub fn job(&self) -> Option<JobView> {
        self.run.as_ref().map(Run::view)
    }

    /// Takes that the journal has what [`Effect::Give`] asked for.
    pub fn handle_given(&mut self, now: Duration, job: u64, upto: usize) {
        self.handle_time(now);
        if let Some(run) = self.run.as_mut().filter(|it| it.job() == job) {
            run.durable = run.durable.max(upto.min(run.asked));
        }
        self.pump();
    }

    /// Takes that the journal cannot be written: no more of the job is sent.
    pub fn handle_journal_failed(&mut self, now: Duration, why: &str) {
        self.handle_time(now);
        self.part_from_laser();
        let why = format!("the journal of jobs cannot be written: {why}");
        self.drop_run_waiting(&why);
        self.interrupt_run(&why);
        self.tell(News::Trouble, why);
    }

    fn start(&mut self, client: ClientId, begun: Begun) -> Result<Reply, Refusal> {
        self.check_may_move(client)?;
        self.check_trust()?;
        if self.session.under_way() > 0 || self.session.waiting() > 0 {
            return Err(Refusal::StillMoving {
                within_s: self.rests_within().as_secs_f64(),
            });
        }
        if begun.plan.burns() {
            self.check_laser_armed()?;
        }
        let approach = self.approach(&begun);
        for command in &approach {
            self.session.check(command)?;
        }
        let mut last = None;
        for command in approach {
            self.check_way(&command)?;
            last = Some(self.session.send(command)?);
        }
        self.halt = None;
        let (job, completed) = (begun.job, begun.completed);
        let text = format!("job {job} ({}) is under way", begun.title);
        self.run = Some(Run {
            begun,
            phase: Phase::Approaching { last },
            from: self.last,
            next: completed,
            durable: completed,
            asked: completed,
            given: VecDeque::new(),
        });
        let phase = JobPhase::Running;
        self.effects.push_back(Effect::Phase {
            job,
            phase,
            reason: None,
            window: None,
        });
        self.tell(News::Job { job, phase }, text);
        Ok(self.job_reply())
    }

    /// What brings the arm to where a job begins or goes on: settings that a reset may have lost,
    /// and the way there.
    fn approach(&self, begun: &Begun) -> Vec<Command> {
        let mut approach = prelude(begun.plan.commands(), begun.completed);
        let start = begun.plan.start_position(begun.completed);
        let (Some(start), Some(status)) = (start, self.last) else {
            return approach;
        };
        let here = position(&status);
        let aside_mm = Position { z: here.z, ..start }.distance(here).0;
        if start.distance(here).0 <= THERE_MM {
            return approach;
        }
        let held = last_target(&begun.plan.commands()[..begun.completed]);
        approach.push(if aside_mm <= THERE_MM {
            straight(start.z.0 - here.z.0)
        } else {
            hop(start, &status, held)
        });
        approach
    }

    /// Whether a job may be started as far as its own last motion goes: one that was paused a
    /// moment ago still does what the arm has got, and lifts the tool.
    ///
    /// # Errors
    ///
    /// [`Refusal::StillMoving`].
    pub fn check_rests(&self, job: u64) -> Result<(), Refusal> {
        let ending = |run: &Run| {
            run.job() == job && matches!(run.phase, Phase::Draining { .. } | Phase::Lifting { .. })
        };
        if self.run.as_ref().is_some_and(ending) {
            return Err(Refusal::StillMoving {
                within_s: self.rests_within().as_secs_f64(),
            });
        }
        Ok(())
    }

    pub(super) fn pause_job(&mut self, client: ClientId) -> Result<Reply, Refusal> {
        let why = format!("paused by {}", self.name(client));
        if self.run.as_ref().is_none_or(|it| !it.has_the_arm()) {
            return Err(Refusal::NoJobRuns);
        }
        self.part_from_laser();
        self.drop_run_waiting(&why);
        self.drain(JobPhase::Paused, &why, true);
        Ok(self.job_reply())
    }

    pub(super) fn cancel_job(&mut self, client: ClientId, job: u64) -> Result<Reply, Refusal> {
        if self.lease.is_some() {
            self.check_lease(client)?;
        }
        if self.run.as_ref().is_none_or(|it| it.job() != job) {
            return Err(Refusal::NoSuchJob(job));
        }
        let why = format!("ended by {}", self.name(client));
        self.part_from_laser();
        self.drop_run_waiting(&why);
        self.drain(JobPhase::Stopped, &why, true);
        let reply = self.job_reply();
        self.watch_run();
        Ok(reply)
    }

    /// The job goes no further: what is under way comes to its end, then it is paused.
    pub(super) fn interrupt_run(&mut self, why: &str) {
        let at_work = |it: &Run| matches!(it.view_phase(), JobPhase::Running);
        if self.run.as_ref().is_some_and(at_work) {
            self.drain(JobPhase::Paused, why, false);
        } else if let Some(run) = &mut self.run
            && let Phase::Draining { lift, .. } = &mut run.phase
        {
            *lift = false;
        }
    }

    /// A job that burns goes no further.
    pub(super) fn interrupt_burning(&mut self, why: &str) {
        let burns = |it: &Run| it.begun.plan.burns() && it.view_phase() == JobPhase::Running;
        if self.run.as_ref().is_some_and(burns) {
            self.drop_run_waiting(why);
            self.drain(JobPhase::Paused, why, true);
        }
    }

    fn drain(&mut self, then: JobPhase, reason: &str, lift: bool) {
        let Some(run) = &mut self.run else {
            return;
        };
        let job = run.job();
        run.phase = Phase::Draining {
            then,
            reason: reason.to_owned(),
            lift,
        };
        // The journal keeps it as running until nothing is under way: a crash until then has to find
        // out how far the job got.
        let text = format!("job {job} is {}: {reason}", word(then));
        self.tell(News::Job { job, phase: then }, text);
    }

    /// Forgets what the session has of the job and has not sent.
    fn drop_run_waiting(&mut self, why: &str) {
        self.drop_waiting(why);
    }

    pub(super) fn run_command_forgotten(&mut self, id: CommandId) {
        if let Some(run) = &mut self.run
            && let Some(at) = run.given.iter().position(|(it, _)| *it == id)
        {
            let (_, index) = run.given[at];
            run.given.truncate(at);
            run.next = run.next.min(index);
        }
    }

    /// Takes that a command is over: of the job, or on the way to it.
    pub(super) fn run_command_over(&mut self, id: CommandId, failed: Option<&str>) {
        let Some(run) = &mut self.run else {
            return;
        };
        let of_job = run.given.iter().position(|(it, _)| *it == id);
        let of_way = match &run.phase {
            Phase::Approaching { last } => *last == Some(id),
            Phase::Lifting { last, .. } => *last == id,
            _ => false,
        };
        if let Some(at) = of_job {
            let (_, index) = run.given.remove(at).expect("it was found there");
            if failed.is_none() && run.begun.completed == index {
                run.begun.completed = index + 1;
            }
        }
        match failed {
            Some(why) if of_job.is_some() || matches!(run.phase, Phase::Approaching { .. }) => {
                let why = why.to_owned();
                self.part_from_laser();
                self.drop_run_waiting(&why);
                self.interrupt_run(&why);
            }
            None if of_way && matches!(run.phase, Phase::Approaching { .. }) => {
                run.phase = Phase::Running;
            }
            _ => {}
        }
    }

    /// With each status: is the job located, drained, lifted, done?
    pub(super) fn watch_run(&mut self) {
        let Some(run) = &self.run else {
            return;
        };
        let idle = self.session.under_way() == 0 && self.session.waiting() == 0;
        match &run.phase {
            Phase::Locating { window } if self.still >= run.rests_after(window) => {
                let window = *window;
                self.locate_run(&window);
            }
            Phase::Draining { then, reason, lift } if idle && run.given.is_empty() => {
                let (then, reason, lift) = (*then, reason.clone(), *lift);
                self.drained(then, reason, lift);
            }
            Phase::Lifting { then, reason, .. } if idle => {
                let (then, reason) = (*then, reason.clone());
                self.rest_run(then, reason);
            }
            Phase::Running if run.begun.completed == run.begun.plan.len() => self.run_done(),
            _ => {}
        }
    }

    fn drained(&mut self, then: JobPhase, reason: String, lift: bool) {
        let up = self.run.as_ref().map_or(0.0, |it| it.begun.plan.lift_mm());
        if lift && up > 0.0 && self.stop.is_none() && self.is_linked() {
            let command = straight(up.into());
            if self.check_way(&command).is_ok()
                && let Ok(last) = self.session.send(command)
                && let Some(run) = &mut self.run
            {
                run.phase = Phase::Lifting { last, then, reason };
                return;
            }
        }
        self.rest_run(then, reason);
    }

    /// Nothing of the job is under way any more: how far it got is certain, and kept.
    fn rest_run(&mut self, then: JobPhase, reason: String) {
        let Some(run) = &mut self.run else {
            return;
        };
        run.next = run.begun.completed;
        run.phase = Phase::Paused {
            reason: reason.clone(),
        };
        let effect = Effect::Phase {
            job: run.job(),
            phase: then,
            reason: Some(reason),
            window: Some(run.certain()),
        };
        self.effects.push_back(effect);
        if then.is_over() {
            self.run = None;
        }
        self.changed = true;
    }

    fn run_done(&mut self) {
        let Some(run) = self.run.take() else {
            return;
        };
        self.part_from_laser();
        let job = run.job();
        self.effects.push_back(Effect::Phase {
            job,
            phase: JobPhase::Done,
            reason: None,
            window: Some(run.certain()),
        });
        let text = format!("job {job} ({}) is done", run.begun.title);
        let phase = JobPhase::Done;
        self.tell(News::Job { job, phase }, text);
    }

    /// The arm rests: which command was the last one that it did?
    fn locate_run(&mut self, window: &Window) {
        let (Some(run), Some(status)) = (&mut self.run, self.last) else {
            return;
        };
        let commands = run.begun.plan.commands();
        let dialect = run.begun.dialect;
        let model =
            model_at(dialect, commands, window).unwrap_or_else(|| Model::new(dialect, &status));
        let lift_mm = run.begun.plan.lift();
        let located = if window.completed == window.upto {
            Ok(window.completed)
        } else {
            locate(commands, window, &model, lift_mm, position(&status)).map(|it| it.next)
        };
        let reason = match located {
            Ok(next) => {
                run.begun.completed = next;
                format!("{RESTARTED}; the arm rests where command {next} begins")
            }
            Err(unclear) => format!("{RESTARTED}; {unclear}"),
        };
        self.rest_run(JobPhase::Paused, reason);
        self.tell_job_paused();
    }

    fn tell_job_paused(&mut self) {
        if let Some(JobView {
            job, phase, reason, ..
        }) = self.job()
        {
            let text = format!("job {job} is paused: {}", reason.unwrap_or_default());
            self.tell(News::Job { job, phase }, text);
        }
    }

    /// Keeps the session and the journal supplied.
    pub(super) fn pump(&mut self) {
        if !matches!(
            self.run,
            Some(Run {
                phase: Phase::Approaching { last: None } | Phase::Running,
                ..
            })
        ) {
            return;
        }
        if let Some(Run {
            phase: phase @ Phase::Approaching { .. },
            ..
        }) = &mut self.run
        {
            *phase = Phase::Running;
        }
        self.ask_journal();
        while self.session.waiting() < KEEP_WAITING
            && let Some(command) = self.next_of_run()
        {
            if let Err(refusal) = self.give(&command) {
                let why = refusal.to_string();
                self.part_from_laser();
                self.drain(JobPhase::Paused, &why, true);
                return;
            }
        }
    }

    fn next_of_run(&self) -> Option<Command> {
        let run = self.run.as_ref()?;
        let commands = &run.begun.plan.commands()[..run.durable];
        commands.get(run.next).copied()
    }

    fn give(&mut self, command: &Command) -> Result<(), Refusal> {
        self.check_laser(command)?;
        self.check_way(command)?;
        let id = self.session.send(*command)?;
        self.note_laser(command);
        let run = self.run.as_mut().expect("the command is of the run");
        run.given.push_back((id, run.next));
        run.next += 1;
        Ok(())
    }

    /// The journal is asked in time, so that the arm does not wait for the disk.
    fn ask_journal(&mut self) {
        let Some(run) = &mut self.run else {
            return;
        };
        if run.asked > run.durable || run.durable >= run.next + LOW_WATER {
            return;
        }
        let Some(upto) = self.last.map(|status| run.window_end(&status)) else {
            return;
        };
        if upto > run.asked {
            run.asked = upto;
            let effect = Effect::Give {
                job: run.job(),
                completed: run.begun.completed,
                upto,
                start: run.start(),
            };
            self.effects.push_back(effect);
        }
    }

    fn job_reply(&self) -> Reply {
        self.job().map_or(Reply::Done, |job| Reply::Job { job })
    }
}

/// Straight up or down, slowly, with the laser off.
fn straight(z_mm: f64) -> Command {
    WriteVector {
        mode: WriteMode::Writing,
        x_mm: 0.0,
        y_mm: 0.0,
        z_mm: single(z_mm),
        laser: false,
        start_speed_mm_s: 0.0,
        end_speed_mm_s: 0.0,
        max_speed_mm_s: 20.0,
        stop: false,
    }
    .into()
}

/// Up, across and down, holding what is held.
fn hop(to: Position, status: &Status, (suction, gripper_deg): (bool, f32)) -> Command {
    let base_deg = to.y.0.atan2(to.x.0).to_degrees();
    MoveTo {
        x_mm: single(to.x.0),
        y_mm: single(to.y.0),
        z_mm: single(to.z.0),
        rotation_deg: single(base_deg) + status.servo_deg,
        suction,
        mode: MovingMode::Jump,
        gripper_deg,
        pause_s: 0.0,
    }
    .into()
}

/// What the last target did with suction and gripper.
fn last_target(commands: &[Command]) -> (bool, f32) {
    let target = |it: &Command| match it {
        Command::MoveTo(it) => Some((it.suction, it.gripper_deg)),
        Command::MoveJoints(it) => Some((it.suction, it.gripper_deg)),
        _ => None,
    };
    commands.iter().rev().find_map(target).unwrap_or_default()
}

const fn pause_s(command: &Command) -> f32 {
    match command {
        Command::MoveTo(it) => it.pause_s,
        Command::MoveJoints(it) => it.pause_s,
        _ => 0.0,
    }
}

const fn word(phase: JobPhase) -> &'static str {
    match phase {
        JobPhase::Queued => "queued",
        JobPhase::Running => "running",
        JobPhase::Paused => "paused",
        JobPhase::Stopped => "stopped",
        JobPhase::Done => "done",
        JobPhase::Failed => "failed",
    }
}

#[expect(clippy::cast_possible_truncation, reason = "as the packet holds it")]
const fn single(value: f64) -> f32 {
    value as f32
}

const RESTARTED: &str = "the station was restarted in the middle of the job";
/// As near as this the arm is where it should be.
const THERE_MM: f64 = 0.3;
/// So many statuses in a row that tell the same: whatever was under way is over.
const SURELY_AT_REST: u32 = 20;
const STATUSES_PER_S: f32 = 12.5;
const A_DAY_S: f32 = 86_400.0;
/// So many commands wait in the session, so that a permit finds one.
const KEEP_WAITING: usize = 2;
/// The journal is asked for more when so few are left.
const LOW_WATER: usize = 12;
/// So many commands may be sent at the most before the journal knows that those before are over.
const WINDOW: usize = 32;
