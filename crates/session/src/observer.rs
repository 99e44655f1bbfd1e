//! One who looks on while others talk with an arm.

use std::time::Duration;

use dobot_motion::{Model, Trajectory};
use dobot_wire::{Command, Dialect, Status};

use crate::CommandId;
use crate::arm_estimate::ArmEstimate;
use crate::completion::{Completion, Verdict};
use crate::quality::UNSEEN;

/// One who looks on while others talk with an arm: an engine that knows what is under way and sees what is over, by the
/// same prediction and the same evidence as a [`Session`](crate::Session).
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
/// let [way] = observer.in_flight().collect::<Vec<_>>()[..] else {
///     panic!("one command was sent");
/// };
/// assert!((way.end().unwrap().pose.position.x.0 - 200.0).abs() < 1e-9);
/// ```
#[derive(Debug)]
pub struct Observer {
    estimate: ArmEstimate,
    completion: Completion,
    sent: u64,
}

/// A command that is over.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeenOver {
    /// The command.
    pub command: Command,
    /// The way that it went; `None` where the arm was seen to end elsewhere, or where nobody knows its way.
    pub way: Option<Trajectory>,
}

impl Observer {
    /// One who has seen nothing yet of an arm that speaks `dialect`.
    #[must_use]
    pub fn new(dialect: Dialect) -> Self {
        Self {
            estimate: ArmEstimate::new(Some(&dialect)),
            completion: Completion::default(),
            sent: 0,
        }
    }

    /// Takes a command that leaves for the arm. Before the first status nobody knows where it leads.
    pub fn handle_sent(&mut self, now: Duration, command: &Command) {
        let plan = self.estimate.plan(command);
        self.estimate.give(CommandId(self.sent), *command, plan);
        self.sent += 1;
        if let Some(given) = self.estimate.take_next() {
            self.estimate.handle_sent(now, given);
        }
    }

    /// Takes a status; gives the commands that it shows to be over, the oldest first.
    pub fn handle_status(&mut self, now: Duration, status: &Status) -> Vec<SeenOver> {
        let mut seen = Vec::new();
        self.completion.handle_status(now, status);
        while let Some(verdict) = self.completion.poll(now, UNSEEN, self.estimate.in_flight()) {
            match verdict {
                Verdict::Over(count) => {
                    let over = (0..count).filter_map(|_| self.estimate.handle_over(now));
                    seen.extend(over.map(|it| SeenOver {
                        command: it.command,
                        way: it.plan.trajectory.ok(),
                    }));
                }
                Verdict::Pauses => {}
                Verdict::Missed(..) => {
                    seen.extend(self.estimate.handle_missed(now).map(|it| SeenOver {
                        command: it.command,
                        way: None,
                    }));
                }
            }
        }
        self.estimate.handle_status(now, status);
        seen
    }

    /// The ways of the commands that were sent and are not over, the oldest first, as far as they are known.
    pub fn in_flight(&self) -> impl Iterator<Item = &Trajectory> {
        let plans = self.estimate.in_flight().iter();
        plans.filter_map(|it| it.plan.trajectory.as_ref().ok())
    }

    /// How many commands were sent and are not over.
    #[must_use]
    pub fn waiting_for(&self) -> usize {
        self.estimate.in_flight().len()
    }

    /// What is believed of the arm when all that was sent is over; `None` before the first status.
    #[must_use]
    pub fn model(&self) -> Option<&Model> {
        self.estimate.after_sent()
    }
}
