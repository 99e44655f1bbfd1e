//! Starting a job, or going on with it: from wherever the arm is to where the job goes on.

use std::time::Duration;

use dobot_arm::Position;
use dobot_client::position;
use dobot_journal::prelude;
use dobot_wire::{Command, MoveTo, Status, WriteVector, single};

use super::watch::locate_at;
use super::{Begun, Effect, Left, Phase, Run};
use crate::keeper::Keeper;
use crate::words::{ClientId, JobPhase, News, Refusal, Reply};

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

    fn start(&mut self, client: ClientId, begun: Begun) -> Result<Reply, Refusal> {
        self.check_may_move(client)?;
        self.check_trust()?;
        self.check_saved()?;
        if self.session.under_way() > 0 || self.session.waiting() > 0 {
            return Err(Refusal::StillMoving {
                within_s: self.rests_within().as_secs_f64(),
            });
        }
        if begun.plan.burns() {
            self.check_laser_armed()?;
        }
        let kept = begun.doubt.map_or(begun.completed, |it| it.completed);
        let begun = self.located(begun)?;
        let Approach { first, lower } = self.approach(&begun);
        let mut run = Run::new(begun, Phase::Approaching { last: None }, self.last);
        (run.kept, run.asked_kept) = (kept, kept);
        let left = self.left_before(&run);
        if left.is_unknown {
            run.pace.rest_each(&run.begun.plan, run.begun.completed);
        }
        let ways = first.iter().chain(&lower);
        run.left = ways.fold(left, |left, it| run.after(left, it));
        for command in first.iter().chain(&lower) {
            self.session.check(command)?;
        }
        let mut last = None;
        for command in first {
            self.check_way(&command)?;
            last = Some(self.session.send(command)?);
        }
        self.halt = None;
        let (job, behind) = (run.job(), run.behind());
        let text = format!("job {job} ({}) is under way", run.begun.title);
        let phase = Phase::Approaching { last };
        self.run = Some(Run {
            phase,
            lower,
            ..run
        });
        let phase = JobPhase::Running;
        self.keep_phase(Effect::Phase {
            job,
            phase,
            reason: None,
            window: None,
            behind,
        });
        self.tell(News::Job { job, phase }, text);
        Ok(self.job_reply())
    }

    /// What the arm keeps for the next vector, before anything is sent for a job: what the pause has
    /// left, or else what the plan says.
    fn left_before(&self, run: &Run) -> Left {
        let paused = self.run.as_ref().filter(|it| it.job() == run.job());
        let left = paused.map(|it| it.left).filter(|it| !it.is_unknown);
        left.unwrap_or_else(|| run.planned_left())
    }

    /// A job of which nobody knows how far it got goes on only from where the arm rests.
    fn located(&self, mut begun: Begun) -> Result<Begun, Refusal> {
        let (Some(window), Some(status)) = (begun.doubt.take(), self.last) else {
            return Ok(begun);
        };
        let located = locate_at(&begun, &window, &status);
        begun.completed = located.map_err(|unclear| Refusal::CannotResume(unclear.to_string()))?;
        Ok(begun)
    }

    /// What brings the arm to where a job begins or goes on: settings that a reset may have lost,
    /// and the way there. A tool that is lifted in a pause comes down from above.
    fn approach(&self, begun: &Begun) -> Approach {
        let mut first = prelude(begun.plan.commands(), begun.completed);
        let start = begun.plan.start_position(begun.completed);
        let (Some(start), Some(status)) = (start, self.last) else {
            return Approach { first, lower: None };
        };
        let here = position(&status);
        if start.distance(here).0 <= THERE_MM {
            let higher_mm = start.z.0 - here.z.0;
            if higher_mm.abs() > LEVEL_MM {
                first.push(straight(higher_mm));
            } else if may_jump(begun) {
                first.extend(settle());
            }
            return Approach { first, lower: None };
        }
        let lift_mm = begun.plan.lift().map_or(0.0, f64::from);
        let above = start + Position::new(0.0, 0.0, lift_mm);
        let mut below_mm = lift_mm;
        if above.distance(here).0 <= THERE_MM {
            below_mm = here.z.0 - start.z.0;
        } else {
            let held = last_target(&begun.plan.commands()[..begun.completed]);
            first.push(hop(above, &status, held));
            if lift_mm == 0.0 && may_jump(begun) {
                first.extend(settle());
            }
        }
        let mut lower = (below_mm > 0.0).then(|| straight(-below_mm));
        if begun.completed == begun.plan.len() {
            // Nothing comes behind it.
            first.extend(lower.take());
        }
        Approach { first, lower }
    }

    /// Whether a job may be started as far as its own last motion goes: one that was paused a
    /// moment ago still does what the arm has got, and lifts the tool; one that a killed station left
    /// shows how far it got where the arm comes to rest.
    ///
    /// # Errors
    ///
    /// [`Refusal::StillMoving`]; [`Refusal::NoLink`] where nothing tells that the arm rests.
    pub fn check_rests(&self, job: u64) -> Result<(), Refusal> {
        let resting = |run: &Run| {
            run.job() == job
                && matches!(
                    run.phase,
                    Phase::Draining { .. } | Phase::Lifting { .. } | Phase::Locating { .. }
                )
        };
        if self.run.as_ref().is_some_and(resting) {
            self.check_link()?;
            return Err(Refusal::StillMoving {
                within_s: self.rests_within().as_secs_f64(),
            });
        }
        Ok(())
    }
}

/// The way to where a job begins or goes on.
struct Approach {
    /// What has to be over before the job.
    first: Vec<Command>,
    /// What lowers the tool, right before the job.
    lower: Option<Command>,
}

/// Straight up or down, slowly, with the laser off.
pub(in crate::keeper) fn straight(z_mm: f64) -> Command {
    WriteVector::by(0.0, 0.0, single(z_mm), 20.0).into()
}

/// Up and down a bit: behind that an arm has forgotten the speed that it had.
fn settle() -> [Command; 2] {
    [straight(SETTLE_MM), straight(-SETTLE_MM)]
}

/// Up, across and down, holding what is held.
fn hop(to: Position, status: &Status, (suction, gripper_deg): (bool, f32)) -> Command {
    let base_deg = to.y.0.atan2(to.x.0).to_degrees();
    MoveTo {
        rotation_deg: single(base_deg) + status.servo_deg,
        suction,
        gripper_deg,
        ..MoveTo::to(single(to.x.0), single(to.y.0), single(to.z.0))
    }
    .into()
}

/// Whether the arm would begin the rest of a stroke with the speed at which it was interrupted,
/// from a stand: one that does not use the start speed keeps the last end speed (note N48).
fn may_jump(begun: &Begun) -> bool {
    let before = begun.completed.checked_sub(1);
    let before = before.and_then(|it| begun.plan.commands().get(it));
    let moves = |it: &Command| matches!(it, Command::WriteVector(it) if it.end_speed_mm_s > 0.0);
    !begun.dialect.uses_start_speed && before.is_some_and(moves)
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

const SETTLE_MM: f64 = 1.0;
/// Another height than that by more is seen on the paper.
const LEVEL_MM: f64 = 0.05;
/// As near as this the arm is where it should be.
pub(super) const THERE_MM: f64 = 0.3;
