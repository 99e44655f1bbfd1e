//! An observer of the traffic between other clients and an arm.

use std::time::Duration;

use dobot_motion::{Model, Trajectory};
use dobot_wire::{Command, Dialect, Status};

use crate::CommandId;
use crate::arm_estimate::ArmEstimate;
use crate::completion::{Completion, Verdict};
use crate::quality::UNSEEN;

/// Observes the traffic between other clients and an arm: an engine that tracks in-flight commands and detects their
/// ends by the same predictions and evidence as a [`Session`](crate::Session).
///
/// ```
/// use std::time::Duration;
///
/// use dobot_session::Observer;
/// use dobot_wire::{Dialect, MoveTo, Status};
///
/// let mut observer = Observer::new(Dialect::SPECIFICATION);
/// assert_eq!(observer.handle_status(Duration::ZERO, &Status::AT_ZERO), []);
/// observer.handle_sent(Duration::ZERO, &MoveTo::to(200.0, 0.0, 20.0).into());
/// let [path] = observer.in_flight().collect::<Vec<_>>()[..] else {
///     panic!("one command was sent");
/// };
/// assert!((path.end().unwrap().pose.position.x.0 - 200.0).abs() < 1e-9);
/// ```
#[derive(Debug)]
pub struct Observer {
    estimate: ArmEstimate,
    completion: Completion,
    sent: u64,
}

/// A command that has ended.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct SeenOver {
    /// The command.
    pub command: Command,
    /// Its trajectory; `None` if the arm ended elsewhere or the trajectory is unknown.
    pub way: Option<Trajectory>,
}

impl Observer {
    /// Creates an observer of an arm that speaks `dialect`.
    #[must_use]
    pub fn new(dialect: Dialect) -> Self {
        Self {
            estimate: ArmEstimate::new(Some(&dialect)),
            completion: Completion::default(),
            sent: 0,
        }
    }

    /// Handles a command that is sent to the arm. Before the first status its trajectory is unknown.
    pub fn handle_sent(&mut self, now: Duration, command: &Command) {
        let plan = self.estimate.plan(command);
        self.estimate.push(CommandId(self.sent), *command, plan);
        self.sent += 1;
        if let Some(given) = self.estimate.pop_next() {
            self.estimate.handle_sent(now, given);
        }
    }

    /// Handles a status and returns the commands that it shows to have ended, oldest first.
    pub fn handle_status(&mut self, now: Duration, status: &Status) -> Vec<SeenOver> {
        let mut seen = Vec::new();
        self.completion.handle_status(now, status);
        while let Some(verdict) = self.completion.poll(now, UNSEEN, self.estimate.in_flight()) {
            match verdict {
                Verdict::Over(count) => {
                    let over = (0..count).filter_map(|_| self.estimate.handle_over(now));
                    seen.extend(over.map(|sent| SeenOver {
                        command: sent.command,
                        way: sent.plan.trajectory.ok(),
                    }));
                }
                Verdict::Pauses => {}
                Verdict::Missed(..) => {
                    seen.extend(self.estimate.handle_missed(now).map(|sent| SeenOver {
                        command: sent.command,
                        way: None,
                    }));
                }
            }
        }
        self.estimate.handle_status(now, status);
        seen
    }

    /// The known trajectories of the in-flight commands, oldest first.
    pub fn in_flight(&self) -> impl Iterator<Item = &Trajectory> {
        let plans = self.estimate.in_flight().iter();
        plans.filter_map(|sent| sent.plan.trajectory.as_ref().ok())
    }

    /// Number of in-flight commands.
    #[must_use]
    pub fn waiting_for(&self) -> usize {
        self.estimate.in_flight().len()
    }

    /// The estimated model after all in-flight commands; `None` before the first status.
    #[must_use]
    pub fn model(&self) -> Option<&Model> {
        self.estimate.after_sent()
    }
}
