//! Starting or resuming a job: from wherever the arm is to the resume point.

use dobot_api::{JobPhase, News};
use dobot_arm::Position;
use dobot_journal::prelude;
use dobot_motion::TrajectoryError;
use dobot_session::{CommandId, SendError, position};
use dobot_wire::{Command, MoveTo, MovingMode, Status, WriteVector, single};

use crate::refusal::Refusal;
use crate::supervisor::arm::Arm;
use crate::supervisor::run::observe::progress::{THERE_MM, locate_at};
use crate::supervisor::run::{CarryOver, Effect, JobEffect, Phase, Run, StartedJob, ToolHeight};

impl Run {
    /// Starts a job, or resumes the paused one if it is the same.
    pub(in crate::supervisor) fn begin(
        started: StartedJob,
        arm: &mut Arm,
        paused: Option<&Self>,
    ) -> Result<(Self, [JobEffect; 2]), Refusal> {
        let status = arm.last();
        let kept = started
            .doubt
            .map_or(started.completed, |doubt| doubt.completed);
        let started = located(started, status)?;
        check_holds(&started, status)?;
        let JobApproach { mut first, lower } = approach(&started, status);
        first.extend(reposition_after_cut_line(&started, status, arm));
        let step_end = started.single_step.then(|| started.step_end());
        let mut run = Self::new(started, kept, Phase::Approaching { last: None }, status);
        run.step_end = step_end;
        let is_planned = run.started.adjustment.speed_percent == 100.0;
        run.target_speed = run.started.target_speed(run.next).filter(|_| !is_planned);
        run.carry_over_approach(paused, first.iter().chain(&lower));
        let last = send_first(arm, &first, lower.as_ref())?;
        run.phase = Phase::Approaching { last };
        run.tool = lower.map_or(ToolHeight::Down, ToolHeight::Above);
        let wishes = run.begins();
        Ok((run, wishes))
    }

    /// Sets the carry-over for the next vector, which is sent after these commands.
    fn carry_over_approach<'a>(
        &mut self,
        paused: Option<&Self>,
        ways: impl Iterator<Item = &'a Command>,
    ) {
        let carry_over = self.carry_over_before(paused);
        if carry_over.is_unknown {
            self.speeds
                .stop_each(&self.started.plan, self.started.completed);
        }
        self.carry_over = ways.fold(carry_over, |carry_over, command| {
            self.after(carry_over, command)
        });
    }

    fn begins(&self) -> [JobEffect; 2] {
        let (job, phase) = (self.job(), JobPhase::Running);
        let text = format!("job {job} ({}) is running", self.started.title);
        let effect = Effect::Phase {
            job,
            phase,
            reason: None,
            window: None,
            history: self.started.history,
        };
        [
            JobEffect::WritePhase(effect),
            JobEffect::Notify(News::Job { job, phase }, text),
        ]
    }

    /// Returns the carry-over for the next vector before anything is sent for the job: what the
    /// pause has left, otherwise what the plan says.
    fn carry_over_before(&self, paused: Option<&Self>) -> CarryOver {
        let paused = paused.filter(|paused| paused.job() == self.job());
        let carry_over = paused
            .map(|paused| paused.carry_over)
            .filter(|carry_over| !carry_over.is_unknown);
        carry_over.unwrap_or_else(|| self.planned_carry_over())
    }
}

/// Locates a job of unknown progress by where the arm rests.
fn located(mut started: StartedJob, status: Option<Status>) -> Result<StartedJob, Refusal> {
    let (Some(window), Some(status)) = (started.doubt.take(), status) else {
        return Ok(started);
    };
    let located = locate_at(&started, &window, &status);
    started.completed = located.map_err(|unclear| Refusal::CannotResume(unclear.to_string()))?;
    Ok(started)
}

/// Checks all commands of an approach, then sends those before the job. Returns the last one.
fn send_first(
    arm: &mut Arm,
    first: &[Command],
    lower: Option<&Command>,
) -> Result<Option<CommandId>, Refusal> {
    for command in first.iter().chain(lower) {
        arm.session().check(command)?;
    }
    let mut last = None;
    for command in first {
        last = Some(arm.send(command)?);
    }
    Ok(last)
}

/// Returns the commands that bring the arm to the start or resume point: settings that a reset may
/// have lost, and the path. A tool that is lifted in pauses comes down from above.
fn approach(started: &StartedJob, status: Option<Status>) -> JobApproach {
    let mut first = prelude(started.plan.settings_before(started.completed));
    let (Some(planned), Some(status)) = (started.plan.start(started.completed), status) else {
        return JobApproach { first, lower: None };
    };
    let (start, here) = (position(&planned), position(&status));
    if start.distance(here).0 <= THERE_MM {
        first.extend(adjust_height(started, start.z.0 - here.z.0));
        return JobApproach { first, lower: None };
    }
    let lift_mm = started.plan.lift().map_or(0.0, f64::from);
    let above = start + Position::new(0.0, 0.0, lift_mm);
    let mut below_mm = lift_mm;
    if above.distance(here).0 <= THERE_MM {
        below_mm = here.z.0 - start.z.0;
    } else {
        first.push(hop(above, &planned));
        if lift_mm == 0.0 {
            first.extend(settle_before_jump(started));
        }
    }
    let mut lower = (below_mm > 0.0).then(|| straight(-below_mm));
    if started.completed == started.end() {
        // Nothing follows it.
        first.extend(lower.take());
    }
    JobApproach { first, lower }
}

/// The path to the start or resume point.
struct JobApproach {
    /// The commands before the job.
    first: Vec<Command>,
    /// The command that lowers the tool, right before the job.
    lower: Option<Command>,
}

/// Moves vertically, slowly, with the laser off.
pub(crate) fn straight(z_mm: f64) -> Command {
    WriteVector::by(0.0, 0.0, single(z_mm), 20.0).into()
}

/// A small move up and down, after which an arm has forgotten its speed.
fn settle() -> [Command; 2] {
    [straight(SETTLE_MM), straight(-SETTLE_MM)]
}

/// Returns the commands for an arm at the place where the job begins, but `higher_mm` below it.
fn adjust_height(started: &StartedJob, higher_mm: f64) -> Vec<Command> {
    if higher_mm.abs() > LEVEL_MM {
        vec![straight(higher_mm)]
    } else {
        settle_before_jump(started)
    }
}

/// Returns the small move before a stroke that would otherwise begin with a jump.
fn settle_before_jump(started: &StartedJob) -> Vec<Command> {
    let moves = may_jump(started).then(settle);
    moves.into_iter().flatten().collect()
}

/// Before a straight line whose predecessor may have been cut short: a MOVJ to where the arm is,
/// without which a stock arm would start with a jump (note N46).
fn reposition_after_cut_line(
    started: &StartedJob,
    status: Option<Status>,
    arm: &Arm,
) -> Option<Command> {
    let next = started.plan.commands().get(started.completed)?;
    let trap = Err(SendError::Trap(TrajectoryError::BehindCutLine));
    let here = started.plan.start(started.completed).or(status)?;
    (arm.session().check(next) == trap).then(|| go(position(&here), &here, MovingMode::MovJ))
}

/// Moves up, across and down, with tool rotation and grip as planned.
fn hop(to: Position, planned: &Status) -> Command {
    go(to, planned, MovingMode::Jump)
}

fn go(to: Position, planned: &Status, mode: MovingMode) -> Command {
    let base_deg = to.y.0.atan2(to.x.0).to_degrees();
    MoveTo {
        rotation_deg: single(base_deg) + planned.servo_deg,
        suction: planned.suction,
        gripper_deg: planned.gripper_deg,
        mode,
        ..MoveTo::to(single(to.x.0), single(to.y.0), single(to.z.0))
    }
    .into()
}

/// Returns whether the arm would start the rest of a stroke from rest with the speed at which it
/// was interrupted: an arm that does not use the start speed keeps the last end speed (note N48).
fn may_jump(started: &StartedJob) -> bool {
    let before = started.completed.checked_sub(1);
    let before = before.and_then(|before| started.plan.commands().get(before));
    let moves = |command: &Command| matches!(command, Command::WriteVector(vector) if vector.end_speed_mm_s > 0.0);
    !started.dialect.uses_start_speed && before.is_some_and(moves)
}

/// Checks that the pump is not off while the program expects a held object, which has then fallen.
fn check_holds(started: &StartedJob, status: Option<Status>) -> Result<(), Refusal> {
    let planned = started.plan.start(started.completed);
    if planned.is_some_and(|planned| planned.suction)
        && status.is_some_and(|status| !status.suction)
    {
        let (_, step) = started
            .program
            .at(started.completed + started.back, started.commands);
        return Err(Refusal::CannotResume(format!(
            "the pump is off, but the program had it on before command {step}: the held object has fallen; put it back, and run the program from the step that picks it up"
        )));
    }
    Ok(())
}

const SETTLE_MM: f64 = 1.0;
/// A larger height difference is visible on the paper.
const LEVEL_MM: f64 = 0.05;
