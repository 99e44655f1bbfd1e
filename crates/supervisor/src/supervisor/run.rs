//! The current job: one vector after the other, none twice, none left out.

mod feed;
mod observe;
mod start;

use std::collections::VecDeque;
use std::time::Duration;

use dobot_api::{JobPhase, JobView, News};
use dobot_journal::{Window, model_at, window_end};
use dobot_motion::Model;
use dobot_plan::{ArmLimits, end_speed_mm_s};
use dobot_session::CommandId;
use dobot_wire::{Command, PlaybackAdjustment, Status};

pub(super) use self::feed::adjust::check_height;
use self::feed::cycles::CycleTimes;
use self::feed::permit::Permit;
use self::feed::speeds::Speeds;
pub(super) use self::observe::asking::DueAnswer;
use self::observe::grip_check::UnseenGrip;
use self::observe::resend::Retries;
use self::start::approach::straight;
pub use self::start::started_job::{Effect, StartedJob};

/// The running or paused job.
#[derive(Debug)]
pub(super) struct Run {
    started: StartedJob,
    phase: Phase,
    /// The arm when the job was started or resumed.
    from: Option<Status>,
    /// The next command to give to the session.
    next: usize,
    permit: Permit,
    /// The last result of [`Run::window_end`].
    reach: Option<WindowLimit>,
    speeds: Speeds,
    /// Given to the session and not over.
    given: VecDeque<SentCommand>,
    /// The carry-over of the last completed command.
    carry_over: CarryOver,
    tool: ToolHeight,
    /// A speed change by a person, sent before the next target.
    target_speed: Option<PlaybackAdjustment>,
    /// The time since the start or resume.
    ran: Option<RunTime>,
    /// Where it comes to rest when run step by step.
    step_end: Option<usize>,
    /// A completed grip that no status shows yet.
    unseen: Option<UnseenGrip>,
    retries: Retries,
    cycle_times: CycleTimes,
    /// When it asked the question after its last command.
    asked_at: Option<Duration>,
}

/// A job's output for the supervisor.
#[derive(Debug)]
pub(super) enum JobEffect {
    /// Request this from the journal.
    Write(Effect),
    /// Write the phase of the job, repeating until it succeeds.
    WritePhase(Effect),
    /// Publish a notice.
    Notify(News, String),
    /// Drop the job.
    Drop,
    /// Send lost commands again.
    Resend,
}

/// A command of the job that the session has.
#[derive(Clone, Copy, Debug)]
struct SentCommand {
    id: CommandId,
    index: usize,
    /// The carry-over after this command.
    carry_over: CarryOver,
}

/// What a command carries over to the next one.
#[derive(Clone, Copy, Debug, Default)]
struct CarryOver {
    /// The speed of the arm, or the speed kept for the next vector, in mm/s: on a stock arm
    /// slightly above 0 even at rest.
    speed_mm_s: f32,
    /// Whether the arm moves on.
    moves: bool,
    /// Whether the speed is unknown, because another station sent the previous commands.
    is_unknown: bool,
}

/// The tool height relative to the resume point.
#[derive(Clone, Copy, Debug)]
enum ToolHeight {
    /// This command lowers the tool, as soon as a command can follow directly.
    Above(Command),
    Lowering(CommandId, Command),
    Down,
}

/// The end of the journal window for a number of completed commands.
#[derive(Clone, Copy, Debug)]
struct WindowLimit {
    completed: usize,
    upto: usize,
}

/// When the job started to run and when its last command was over.
#[derive(Clone, Copy, Debug)]
struct RunTime {
    since: Duration,
    last_over: Duration,
}

#[derive(Debug)]
enum Phase {
    /// After a crash: finding out where the arm rests.
    Locating {
        window: Window,
    },
    /// On the way to the resume point.
    Approaching {
        last: Option<CommandId>,
    },
    /// Commands below `upto` may be given: there it pauses for a person, or ends.
    Running {
        upto: usize,
    },
    /// Finishing the in-flight commands, and possibly a few more to come to rest on the path.
    Draining {
        then: JobPhase,
        reason: String,
        upto: usize,
        rests: RestMode,
    },
    /// Lifting the tool for a pause.
    Lifting {
        then: JobPhase,
        reason: String,
    },
    Paused {
        reason: String,
    },
}

/// How a job comes to rest after its last command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum RestMode {
    AsItIs,
    /// With the tool lifted as soon as all is given.
    Lifted,
    /// To wait for a person.
    ForPerson,
    /// To send lost commands again from there.
    ToResend,
}

impl Run {
    pub(super) const RESTARTED: &str = "the station was restarted in the middle of the job";

    /// Restores a job that was running when the station ended unexpectedly.
    pub(super) fn recovered(mut started: StartedJob, window: Window) -> Self {
        // How long it ran is unknown.
        started.history.ran_s = None;
        let window = started.in_plan(window);
        let kept = started.completed;
        let mut run = Self::new(started, kept, Phase::Locating { window }, None);
        run.carry_over.is_unknown = true;
        run
    }

    /// Creates a run whose journal has this many completed commands.
    fn new(started: StartedJob, kept: usize, phase: Phase, from: Option<Status>) -> Self {
        let completed = started.completed;
        let arm_limits = ArmLimits::of(started.dialect);
        let speeds = Speeds::new(started.adjustment.speed_percent, arm_limits);
        Self {
            started,
            phase,
            from,
            next: completed,
            permit: Permit::new(completed, kept),
            reach: None,
            speeds,
            given: VecDeque::new(),
            carry_over: CarryOver::default(),
            tool: ToolHeight::Down,
            target_speed: None,
            ran: None,
            step_end: None,
            unseen: None,
            retries: Retries::default(),
            cycle_times: CycleTimes::default(),
            asked_at: None,
        }
    }

    pub(super) const fn job(&self) -> u64 {
        self.started.job
    }

    /// Returns the commands given to the session and not over.
    pub(super) fn in_flight(&self) -> impl Iterator<Item = CommandId> {
        self.given.iter().map(|sent| sent.id)
    }

    /// Returns the carry-over of the last command given.
    fn carry_over(&self) -> CarryOver {
        self.given
            .back()
            .map_or(self.carry_over, |sent| sent.carry_over)
    }

    fn speed_mm_s(&self) -> f32 {
        self.carry_over().speed_mm_s
    }

    /// Returns the carry-over of all completed commands, if they were done as planned.
    fn planned_carry_over(&self) -> CarryOver {
        let next = self.started.plan.chain(self.started.completed).next();
        CarryOver {
            speed_mm_s: next.map_or(0.0, |next| next.start_speed_mm_s),
            is_unknown: self.started.completed > 0,
            ..CarryOver::default()
        }
    }

    /// Returns the carry-over after the next command.
    fn after(&self, before: CarryOver, command: &Command) -> CarryOver {
        let arm_limits = self.speeds.arm_limits_at(&self.started.plan, self.next);
        match command {
            Command::WriteVector(vector) => CarryOver {
                speed_mm_s: end_speed_mm_s(vector, before.speed_mm_s, &arm_limits),
                moves: vector.end_speed_mm_s > 0.0 && !vector.stop,
                is_unknown: before.is_unknown && self.speeds.rests_each(self.next),
            },
            _ if arm_limits.has_ticks => CarryOver {
                moves: false,
                ..before
            },
            _ => CarryOver::default(),
        }
    }

    /// Returns whether no other client may move the arm.
    pub(super) const fn occupies_arm(&self) -> bool {
        !matches!(self.phase, Phase::Paused { .. })
    }

    /// Returns whether the job sends commands, or is about to.
    pub(super) const fn is_at_work(&self) -> bool {
        matches!(
            self.phase,
            Phase::Approaching { .. } | Phase::Running { .. }
        )
    }

    pub(super) const fn is_running(&self) -> bool {
        matches!(self.phase, Phase::Running { .. })
    }

    /// Returns whether the job sends no more commands but the arm may still move for it.
    pub(super) const fn is_coming_to_rest(&self) -> bool {
        matches!(
            self.phase,
            Phase::Draining { .. } | Phase::Lifting { .. } | Phase::Locating { .. }
        )
    }

    /// Returns the tool height below which its pen draws, in mm and raw coordinates.
    pub(super) fn draws_below_mm(&self) -> Option<f64> {
        self.started.plan.draws_below_mm(self.started.height_mm())
    }

    pub(super) const fn burns(&self) -> bool {
        self.started.plan.burns()
    }

    const fn lift_mm(&self) -> f32 {
        self.started.plan.lift_mm()
    }

    /// Handles a completed journal write, possibly of this job.
    pub(super) fn handle_written(&mut self, effect: &Effect) {
        match effect {
            Effect::ExtendWindow { job, upto, .. } if *job == self.job() => {
                self.permit
                    .handle_given(upto.saturating_sub(self.started.back));
            }
            Effect::Adjust { job, adjustment } if *job == self.job() => {
                self.permit.handle_adjusted(adjustment);
            }
            _ => {}
        }
    }

    /// Adds the time it ran.
    fn note_ran(&mut self) {
        if let (Some(ran), Some(before_s)) = (self.ran.take(), &mut self.started.history.ran_s) {
            *before_s += ran.last_over.saturating_sub(ran.since).as_secs_f64();
        }
    }

    /// Returns the longest time until everything sent by a previous station is over.
    pub(super) fn unseen_s(&self) -> f64 {
        let Phase::Locating { window } = &self.phase else {
            return 0.0;
        };
        let plan = &self.started.plan;
        let given_s = plan.takes_s(window.completed..window.upto);
        let commands = u32::try_from(window.upto - window.completed).unwrap_or(u32::MAX);
        given_s * ROUNDING + f64::from(commands) * COMMAND_S + APPROACH_S
    }

    const fn view_phase(&self) -> JobPhase {
        match &self.phase {
            Phase::Approaching { .. } | Phase::Running { .. } => JobPhase::Running,
            Phase::Draining { then, .. } | Phase::Lifting { then, .. } => *then,
            Phase::Locating { .. } | Phase::Paused { .. } => JobPhase::Paused,
        }
    }

    fn reason(&self) -> Option<String> {
        match &self.phase {
            Phase::Locating { .. } => Some(Self::RESTARTED.to_owned()),
            Phase::Draining { reason, .. }
            | Phase::Lifting { reason, .. }
            | Phase::Paused { reason } => Some(reason.clone()),
            Phase::Approaching { .. } | Phase::Running { .. } => None,
        }
    }

    /// Returns the window when nothing is in flight.
    fn certain(&self) -> Window {
        let completed = self.started.completed;
        Window {
            completed,
            upto: completed,
            start: self.start(),
        }
    }

    /// Returns the end of the window to request from the journal. It changes only with the
    /// completed commands and the plan.
    fn window_end(&mut self, status: &Status) -> usize {
        let completed = self.started.completed;
        if let Some(known) = self.reach.filter(|reach| reach.completed == completed) {
            return known.upto;
        }
        let (plan, dialect) = (&self.started.plan, self.started.dialect);
        let model = model_at(dialect, plan.settings_before(completed), &self.certain());
        let end = |model| window_end(plan.commands(), completed, model, plan.lift(), WINDOW);
        match &model {
            Some(model) => {
                let upto = end(model);
                self.reach = Some(WindowLimit { completed, upto });
                upto
            }
            None => end(&Model::new(dialect, status)),
        }
    }

    /// Returns the arm before the first command that is not over.
    fn start(&self) -> Option<Status> {
        self.started
            .plan
            .start(self.started.completed)
            .or(self.from)
    }

    pub(super) const fn progress(&self) -> (usize, JobPhase) {
        (
            self.started.completed + self.started.back,
            self.view_phase(),
        )
    }

    pub(super) fn view(&self) -> JobView {
        let started = &self.started;
        let counted = started.completed + started.back;
        // How long it takes depends on the answer.
        let asks = started.program.question().is_some();
        let is_paused = matches!(self.phase, Phase::Paused { .. });
        JobView {
            job: started.job,
            title: started.title.clone(),
            kind: started.kind,
            created_ms: started.created_ms,
            phase: self.view_phase(),
            reason: self.reason(),
            waits_for_person: is_paused && started.waits_for_person().is_some(),
            commands: started.commands,
            completed: started.program.at(counted, started.commands).1,
            planned_s: started.plan.planned_s().filter(|_| !asks),
            left_s: self.left_s().filter(|_| !asks),
            took_s: None,
            speed_percent: started.adjustment.speed_percent,
            height_mm: started.height_mm(),
            program: self.program_view(counted),
            question: self.question().cloned(),
        }
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

/// A stock arm moves in whole ticks, needs some time per command, and may have been on its way to
/// the resume point.
const ROUNDING: f64 = 1.02;
const COMMAND_S: f64 = 0.24;
const APPROACH_S: f64 = 10.0;
/// The maximum number of commands sent before the journal knows that earlier ones are over.
const WINDOW: usize = 32;
