//! The suite: all checks in order, over one link.

use dobot_session::{Link, LinkError};

use crate::check::{Begins, Check};
use crate::checks::flow;
use crate::checks::settings::show_tool;
use crate::outcome::Outcome;
use crate::packet::jog;
use crate::report::{Report, Row};
use crate::rig::{CheckError, Rig};

/// A run of all checks over one link.
#[derive(Debug)]
pub struct Suite {
    rig: Rig,
    rows: Vec<Row>,
    /// The reason why the run ended early.
    ended: Option<String>,
}

/// Optional checks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// Switch the laser on for a moment. Protect eyes and the surface below it.
    pub laser: bool,
    /// Finally try packets that make a stock arm lose its pose or hang until a reset, and the limit of
    /// the servo (note N34): for virtual arms.
    pub traps: bool,
    /// The arm was just switched on and has had no other client, like a new virtual arm.
    pub fresh: bool,
}

impl Suite {
    /// Creates a suite over a link; sends nothing.
    #[must_use]
    pub fn new(link: Link, options: Options) -> Self {
        Self {
            rig: Rig::new(link, options),
            rows: Vec::new(),
            ended: None,
        }
    }

    /// Runs all checks and calls `report` with each outcome. Every motion is small, at or above the
    /// start height, and ends at the start.
    ///
    /// Cancellation leaves the arm as it is: see [`Suite::stop`].
    pub async fn run(&mut self, mut report: impl FnMut(&Row)) -> Report {
        for check in Check::ALL {
            let began = self.rig.now();
            let outcome = match self.prevented(check) {
                Some(why) => Outcome::NotTried(why),
                None => self.judge(check).await,
            };
            self.count(&outcome);
            let row = Row {
                check: *check,
                outcome,
                took: self.rig.now().saturating_sub(began),
            };
            report(&row);
            self.rows.push(row);
        }
        let rig = &self.rig;
        Report::new(
            self.rows.clone(),
            rig.is_bluetooth(),
            rig.latency,
            rig.blocker.clone(),
        )
    }

    /// Counts an outcome that speaks for a dialect.
    fn count(&mut self, outcome: &Outcome) {
        match outcome {
            Outcome::Specification(_) => self.rig.votes[0] += 1,
            Outcome::Firmware11(_) => self.rig.votes[1] += 1,
            _ => {}
        }
    }

    /// Stops: releases the button, switches the laser off and moves back to the start.
    ///
    /// # Errors
    ///
    /// Returns a [`LinkError`] if the link fails.
    pub async fn stop(&mut self) -> Result<(), LinkError> {
        let stopped = async {
            self.rig.stop_jog().await?;
            self.rig.send(jog(2.0, LASER_OFF, 0.0)).await?;
            self.make_back().await
        };
        match stopped.await {
            Err(CheckError::Link(error)) => Err(error),
            _ => Ok(()),
        }
    }

    async fn make_back(&mut self) -> Result<(), CheckError> {
        if self.rig.moved {
            crate::checks::moves::back(&mut self.rig).await?;
        }
        Ok(())
    }

    /// Runs a check; repeats it if it differs or contradicts all earlier ones, because a command or a
    /// status may have been lost.
    async fn judge(&mut self, check: &Check) -> Outcome {
        let first = self.make(check).await;
        if !self.is_doubtful(check, &first) {
            return first;
        }
        for _ in 0..REPEATS {
            let again = match self.prepare_again(check).await {
                Ok(()) => self.make(check).await,
                Err(trouble) => {
                    self.end(&trouble);
                    return first;
                }
            };
            if again.passed() && again.word() != first.word() {
                let (first, again) = (first.found(), again.found());
                return Outcome::Unsteady(format!("first {first}; then {again}"));
            }
            if self.ended.is_some() {
                break;
            }
        }
        first
    }

    /// Whether an outcome may be due to a lost packet.
    fn is_doubtful(&self, check: &Check, outcome: &Outcome) -> bool {
        let contradicts = match outcome {
            Outcome::Specification(_) => self.rig.leaning() == Some(1),
            Outcome::Firmware11(_) => self.rig.leaning() == Some(0),
            other => other.differs(),
        };
        contradicts && self.ended.is_none() && check.begins != Begins::Once
    }

    /// Prepares a repetition: sends the settings again, which may be lost, and refills the queue.
    async fn prepare_again(&mut self, check: &Check) -> Result<(), CheckError> {
        self.rig.settings().await?;
        show_tool(&mut self.rig, true).await?;
        if matches!(check.id, "flow-again" | "flow-six" | "flow-order") {
            self.rig.go_home().await?;
            flow::silence(&mut self.rig).await?;
        }
        Ok(())
    }

    async fn make(&mut self, check: &Check) -> Outcome {
        if check.begins == Begins::AtHome
            && let Err(trouble) = self.rig.go_home().await
        {
            self.end(&trouble);
            return Outcome::NotTried(trouble.to_string());
        }
        match check.make(&mut self.rig).await {
            Ok(outcome) => outcome,
            Err(trouble) => {
                if !matches!(trouble, CheckError::Restless) {
                    self.end(&trouble);
                }
                Outcome::Differs(trouble.to_string())
            }
        }
    }

    fn end(&mut self, trouble: &CheckError) {
        // Where angles are not true no way back is safe.
        self.rig.moved &= !matches!(trouble, CheckError::Untrue);
        self.ended = Some(format!("before it, {trouble}"));
    }

    /// The reason why a check cannot or must not run.
    fn prevented(&self, check: &Check) -> Option<String> {
        if check.id == "return" && self.rig.moved {
            return None;
        }
        self.ended
            .clone()
            .or_else(|| self.forbidden(check))
            .or_else(|| self.lacks(check))
    }

    fn forbidden(&self, check: &Check) -> Option<String> {
        let options = self.rig.options;
        let why = match check.id {
            "laser" if !options.laser => "the laser burns; use `--with-laser` to try it",
            "limit-jog" if !options.traps => {
                "a stock arm ignores the first limit; use `--traps` to try it on a virtual arm"
            }
            "trap-no-length" | "trap-state" if !options.traps => {
                "a stock arm only recovers by a reset; use `--traps` to try it on a virtual arm"
            }
            _ => return None,
        };
        Some(why.into())
    }

    /// The failed prerequisite of a check.
    fn lacks(&self, check: &Check) -> Option<String> {
        let failed = |row: &&Row| check.needs.contains(&row.check.id) && !row.outcome.passed();
        let row = self.rows.iter().find(failed)?;
        Some(match &row.outcome {
            Outcome::NotTried(why) => why.clone(),
            _ => format!("it requires {}", row.check.id),
        })
    }
}

/// The maximum number of repetitions.
const REPEATS: u32 = 3;
const LASER_OFF: f32 = 14.0;
