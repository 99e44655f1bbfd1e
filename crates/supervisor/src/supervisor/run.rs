//! The job that the arm is at: one vector after the other, none twice, none left out.

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
use self::observe::grip_check::UnseenGrip;
use self::observe::resend::Retries;
use self::start::approach::straight;
pub use self::start::started_job::{Effect, StartedJob};

/// The job that the arm is at, or that is paused.
#[derive(Debug)]
pub(super) struct Run {
    started: StartedJob,
    phase: Phase,
    /// The arm when the job was started or gone on with.
    from: Option<Status>,
    /// The next command to be given to the session.
    next: usize,
    permit: Permit,
    /// As it was found last.
    reach: Option<Reach>,
    speeds: Speeds,
    /// Given to the session and not over.
    given: VecDeque<SentCommand>,
    /// What the last command has left that is over.
    left: CarriedOver,
    tool: ToolHeight,
    /// Sets the speed of targets before the next command, since a person has changed it.
    target_speed: Option<PlaybackAdjustment>,
    /// From where it goes on to where it rests.
    ran: Option<Ran>,
    /// Where it comes to rest because it is done step by step.
    step_end: Option<usize>,
    /// A grip that is done, and not seen yet.
    unseen: Option<UnseenGrip>,
    retries: Retries,
    cycle_times: CycleTimes,
}

/// What a job wants of the supervisor.
#[derive(Debug)]
pub(super) enum JobEffect {
    /// The journal is asked to keep this.
    Ask(Effect),
    /// The journal is to keep the job's phase, however long that takes.
    Keep(Effect),
    /// Those who watch are told.
    Notify(News, String),
    /// Nobody needs the job any more.
    Forget,
    /// What was lost on the way is sent again.
    TryAgain,
}

/// A command of the job that the session has.
#[derive(Clone, Copy, Debug)]
struct SentCommand {
    id: CommandId,
    index: usize,
    /// What the arm has behind it.
    left: CarriedOver,
}

/// What a command leaves to the next one.
#[derive(Clone, Copy, Debug, Default)]
struct CarriedOver {
    /// The speed that the arm has, or keeps for the next vector, in mm/s: in a stock arm that is a
    /// bit even where it rests.
    speed_mm_s: f32,
    /// It goes on.
    moves: bool,
    /// Nobody knows that speed: another station has sent what went before.
    is_unknown: bool,
}

/// Where the tool is, seen from where the job goes on.
#[derive(Clone, Copy, Debug)]
enum ToolHeight {
    /// This lowers it, as soon as something can be sent behind it.
    Above(Command),
    Lowering(CommandId, Command),
    Down,
}

/// How far the journal may be asked to let a job go on of which so many commands are done.
#[derive(Clone, Copy, Debug)]
struct Reach {
    completed: usize,
    upto: usize,
}

/// Since when a job runs, and when its last command was over.
#[derive(Clone, Copy, Debug)]
struct Ran {
    since: Duration,
    last_over: Duration,
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
    /// Commands below `upto` may be given: there it waits for a person, or ends.
    Running {
        upto: usize,
    },
    /// The arm does what it has got already, and perhaps a bit more, to come to rest on its way.
    Draining {
        then: JobPhase,
        reason: String,
        upto: usize,
        rests: Rests,
    },
    /// The tool is lifted for a pause.
    Lifting {
        then: JobPhase,
        reason: String,
    },
    Paused {
        reason: String,
    },
}

/// How a job comes to rest behind the last command that it gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Rests {
    AsItIs,
    /// The tool is lifted, as soon as all is given.
    Lifted,
    /// A person is waited for there.
    ForPerson,
    /// What was lost on the way is sent again from there.
    ToTryAgain,
}

impl Run {
    pub(super) const RESTARTED: &str = "the station was restarted in the middle of the job";

    /// A job that was at work when the station ended without saying so.
    pub(super) fn recovered(mut started: StartedJob, window: Window) -> Self {
        // How long it ran nobody knows any more.
        started.behind.ran_s = None;
        let window = started.in_plan(window);
        let kept = started.completed;
        let mut run = Self::new(started, kept, Phase::Locating { window }, None);
        run.left.is_unknown = true;
        run
    }

    /// A job of which so many commands are done as the journal has it.
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
            left: CarriedOver::default(),
            tool: ToolHeight::Down,
            target_speed: None,
            ran: None,
            step_end: None,
            unseen: None,
            retries: Retries::default(),
            cycle_times: CycleTimes::default(),
        }
    }

    pub(super) const fn job(&self) -> u64 {
        self.started.job
    }

    /// What was given to the session and is not over.
    pub(super) fn in_flight(&self) -> impl Iterator<Item = CommandId> {
        self.given.iter().map(|it| it.id)
    }

    /// What the last command leaves that was given.
    fn left(&self) -> CarriedOver {
        self.given.back().map_or(self.left, |it| it.left)
    }

    fn speed_mm_s(&self) -> f32 {
        self.left().speed_mm_s
    }

    /// What is left by all that is over, where that was done as planned.
    fn planned_left(&self) -> CarriedOver {
        let next = self.started.plan.chain(self.started.completed).next();
        CarriedOver {
            speed_mm_s: next.map_or(0.0, |it| it.start_speed_mm_s),
            is_unknown: self.started.completed > 0,
            ..CarriedOver::default()
        }
    }

    /// What a command leaves that comes next, on what the one before has left.
    fn after(&self, before: CarriedOver, command: &Command) -> CarriedOver {
        let arm_limits = self.speeds.arm_limits_at(&self.started.plan, self.next);
        match command {
            Command::WriteVector(it) => CarriedOver {
                speed_mm_s: end_speed_mm_s(it, before.speed_mm_s, &arm_limits),
                moves: it.end_speed_mm_s > 0.0 && !it.stop,
                is_unknown: before.is_unknown && self.speeds.rests_each(self.next),
            },
            _ if arm_limits.has_ticks => CarriedOver {
                moves: false,
                ..before
            },
            _ => CarriedOver::default(),
        }
    }

    /// Whether nobody else may move the arm.
    pub(super) const fn has_the_arm(&self) -> bool {
        !matches!(self.phase, Phase::Paused { .. })
    }

    /// Whether it gives the arm commands, or is about to.
    pub(super) const fn is_at_work(&self) -> bool {
        matches!(
            self.phase,
            Phase::Approaching { .. } | Phase::Running { .. }
        )
    }

    pub(super) const fn is_running(&self) -> bool {
        matches!(self.phase, Phase::Running { .. })
    }

    /// Whether it gives no more commands, and the arm may still move for its sake.
    pub(super) const fn is_coming_to_rest(&self) -> bool {
        matches!(
            self.phase,
            Phase::Draining { .. } | Phase::Lifting { .. } | Phase::Locating { .. }
        )
    }

    /// Below which height of the tool its pen draws, in mm and the arm's own words.
    pub(super) fn draws_below_mm(&self) -> Option<f64> {
        self.started.plan.draws_below_mm(self.started.height_mm())
    }

    pub(super) const fn burns(&self) -> bool {
        self.started.plan.burns()
    }

    const fn lift_mm(&self) -> f32 {
        self.started.plan.lift_mm()
    }

    /// Takes what the journal has, perhaps of this job.
    pub(super) fn handle_written(&mut self, effect: &Effect) {
        match effect {
            Effect::Give { job, upto, .. } if *job == self.job() => {
                self.permit
                    .handle_given(upto.saturating_sub(self.started.back));
            }
            Effect::Adjust { job, adjustment } if *job == self.job() => {
                self.permit.handle_adjusted(adjustment);
            }
            _ => {}
        }
    }

    /// Takes note of how long it ran.
    fn note_ran(&mut self) {
        if let (Some(ran), Some(before_s)) = (self.ran.take(), &mut self.started.behind.ran_s) {
            *before_s += ran.last_over.saturating_sub(ran.since).as_secs_f64();
        }
    }

    /// How long it may take until all that a station before this one has sent is over.
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

    /// How far it is when nothing is under way.
    fn certain(&self) -> Window {
        let completed = self.started.completed;
        Window {
            completed,
            upto: completed,
            start: self.start(),
        }
    }

    /// How far the journal may be asked to let the job go on. It changes only with what is done, and with the plan.
    fn window_end(&mut self, status: &Status) -> usize {
        let completed = self.started.completed;
        if let Some(known) = self.reach.filter(|it| it.completed == completed) {
            return known.upto;
        }
        let (plan, dialect) = (&self.started.plan, self.started.dialect);
        let model = model_at(dialect, plan.settings_before(completed), &self.certain());
        let end = |model| window_end(plan.commands(), completed, model, plan.lift(), WINDOW);
        match &model {
            Some(model) => {
                let upto = end(model);
                self.reach = Some(Reach { completed, upto });
                upto
            }
            None => end(&Model::new(dialect, status)),
        }
    }

    /// The arm as the first command that is not over finds it.
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
        let StartedJob {
            job,
            title,
            kind,
            created_ms,
            plan,
            adjustment,
            completed,
            back,
            ..
        } = &self.started;
        let counted = completed + back;
        JobView {
            job: *job,
            title: title.clone(),
            kind: *kind,
            created_ms: *created_ms,
            phase: self.view_phase(),
            reason: self.reason(),
            waits_for_person: matches!(self.phase, Phase::Paused { .. })
                && self.started.waits_for_person().is_some(),
            commands: self.started.commands,
            completed: self.started.program.at(counted, self.started.commands).1,
            planned_s: plan.planned_s(),
            left_s: self
                .left_s()
                .map(|it| it * 100.0 / adjustment.speed_percent),
            took_s: None,
            speed_percent: adjustment.speed_percent,
            height_mm: self.started.height_mm(),
            program: self.program_view(counted),
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

/// A stock arm goes in whole ticks, takes a bit for each command, and was perhaps on its way to
/// where the job goes on.
const ROUNDING: f64 = 1.02;
const COMMAND_S: f64 = 0.24;
const APPROACH_S: f64 = 10.0;
/// So many commands may be sent at the most before the journal knows that those before are over.
const WINDOW: usize = 32;
