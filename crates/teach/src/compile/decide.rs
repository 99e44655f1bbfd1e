//! Steps that decide: the compiler follows the answers given, and stops at the first question
//! without one.

use std::collections::BTreeMap;

use dobot_api::{Answer, PendingQuestion, Question};
use dobot_arm::Tool;
use dobot_wire::{Command, JointJogAxis, MovingMode};
use toml::Spanned;

use super::resolve::Spot;
use super::{Compiler, Scope, emit};
use crate::decision::{AfterTimeout, ChosenBy, ExternalPlace};
use crate::program::Offset;
use crate::{
    Action, Choose, Condition, Here, Missed, Place, Point, ProgramError, Steps, Times, Transfer,
    Variables,
};

/// The answers given, and what follows from them.
pub(super) struct Decisions<'a> {
    answers: &'a [Answer],
    /// The number of answers used.
    used: usize,
    /// The first question without an answer.
    pub(super) question: Option<PendingQuestion>,
    pub(super) variables: Variables,
    /// How often each counted choice was made, by file and position.
    counters: BTreeMap<(Option<String>, usize), u64>,
}

impl<'a> Decisions<'a> {
    pub(super) fn new(answers: &'a [Answer], variables: &Variables) -> Self {
        Self {
            answers,
            used: 0,
            question: None,
            variables: variables.clone(),
            counters: BTreeMap::new(),
        }
    }

    /// Returns the number of answers that no question has asked for.
    pub(super) const fn unused(&self) -> usize {
        self.answers.len() - self.used
    }

    /// Returns the answers that were asked for.
    pub(super) fn used(&self) -> &[Answer] {
        &self.answers[..self.used]
    }

    /// Returns the answer to a question; `None` if there is none yet.
    fn ask(&mut self, question: PendingQuestion) -> Result<Option<Answer>, String> {
        let Some(answer) = self.answers.get(self.used) else {
            self.question = Some(PendingQuestion {
                number: self.used as u64 + 1,
                ..question
            });
            return Ok(None);
        };
        question.check(answer)?;
        self.used += 1;
        Ok(Some(answer.clone()))
    }

    /// Adds to variables.
    pub(super) fn add(&mut self, added: &Variables) -> Result<(), String> {
        for (name, by) in added {
            let value = self.variables.entry(name.clone()).or_default();
            *value = value.checked_add(*by).ok_or_else(|| {
                format!("{name} is {value}, and {by} more is too large for a whole number")
            })?;
        }
        Ok(())
    }

    /// Counts a choice; returns how often it was made.
    fn count(&mut self, scope: &Scope<'_>, step: &Spanned<Action>) -> u64 {
        let key = (scope.path.map(str::to_owned), step.span().start);
        let count = self.counters.entry(key).or_default();
        *count += 1;
        *count
    }
}

impl Compiler<'_> {
    /// Returns whether the commands of the program depend on answers, counters or variables.
    pub(super) fn decides(&self, scope: &Scope<'_>) -> bool {
        let called = self.called.by_path().map(|(_, program)| &program.steps);
        let mut all = called.chain([&scope.program.steps]);
        all.any(decides)
    }

    /// Returns whether the last command for the laser switches it on.
    pub(super) fn has_laser_on(&self) -> bool {
        let switch = |command: &Command| match command {
            Command::JointJog(jog) if jog.axis == JointJogAxis::LaserOn => Some(true),
            Command::JointJog(jog) if jog.axis == JointJogAxis::LaserOff => Some(false),
            _ => None,
        };
        let mut commands = self.out.commands.iter().rev();
        commands.find_map(switch).unwrap_or(false)
    }

    /// Repeats steps whose commands differ from cycle to cycle: an endless repeat without a
    /// question asks for its next cycle.
    pub(super) fn unroll(
        &mut self,
        scope: &Scope<'_>,
        step: &Spanned<Action>,
        times: Times,
        inner: &Steps,
    ) -> Result<(), ProgramError> {
        let mut left = match times {
            Times::Count(count) => Some(count),
            Times::Forever => None,
        };
        while left != Some(0) && self.decisions.question.is_none() {
            let (used, commands) = (self.decisions.used, self.out.commands.len());
            self.steps(scope, &inner.0)?;
            left = left.map(|left| left - 1);
            if left.is_none() && self.decisions.question.is_none() && self.decisions.used == used {
                let bad = |reason| scope.error(step, reason);
                if self.out.commands.len() == commands {
                    return Err(bad("the repeat never ends and sends nothing".into()));
                }
                self.decisions.ask(NEXT_CYCLE).map_err(bad)?;
            }
        }
        Ok(())
    }

    pub(super) fn choose(
        &mut self,
        scope: &Scope<'_>,
        step: &Spanned<Action>,
        choose: &Choose,
    ) -> Result<(), ProgramError> {
        let chosen = match choose.by {
            ChosenBy::Every(every) => {
                let is_due = self.decisions.count(scope, step).is_multiple_of(every);
                choose.when.get(usize::from(!is_due))
            }
            ChosenBy::Asked(by) => {
                let answers = choose.when.iter().map(|when| when.answer.clone());
                let question = PendingQuestion {
                    number: 0,
                    question: Question::Choice {
                        text: choose.question.clone(),
                        answers: answers.collect(),
                        by,
                    },
                    timeout_s: choose.wait.timeout_s,
                    otherwise: choose.wait.otherwise.clone().map(Answer::Choice),
                };
                let answer = self.decisions.ask(question);
                let answer = answer.map_err(|reason| scope.error(step, reason))?;
                choose
                    .when
                    .iter()
                    .find(|when| answer.as_ref() == Some(&Answer::Choice(when.answer.clone())))
            }
        };
        chosen.map_or(Ok(()), |when| self.steps(scope, &when.steps.0))
    }

    pub(super) fn repeat_while(
        &mut self,
        scope: &Scope<'_>,
        step: &Spanned<Action>,
        condition: &Condition,
        inner: &Steps,
    ) -> Result<(), ProgramError> {
        let bad = |reason| scope.error(step, reason);
        for _ in 0..MAX_PASSES {
            match condition.holds(&self.decisions.variables) {
                None => return Err(bad(format!("a variable of {condition} does not exist"))),
                Some(false) => return Ok(()),
                Some(true) => {}
            }
            let (used, variables) = (self.decisions.used, self.decisions.variables.clone());
            self.steps(scope, &inner.0)?;
            if self.decisions.question.is_some() {
                return Ok(());
            }
            if self.decisions.used == used && self.decisions.variables == variables {
                return Err(bad(format!(
                    "the loop never ends: none of its steps changes {}; add a step with set or add",
                    condition.names().collect::<Vec<_>>().join(" or ")
                )));
            }
        }
        Err(bad(format!(
            "the loop has not ended after {MAX_PASSES} passes; check how its steps change {}",
            condition.names().collect::<Vec<_>>().join(" and ")
        )))
    }

    /// Picks up an object, again if it was missed.
    pub(super) fn pick(
        &mut self,
        scope: &Scope<'_>,
        step: &Spanned<Action>,
        transfer: &Transfer,
    ) -> Result<(), ProgramError> {
        let bad = |reason| scope.error(step, reason);
        let tries = transfer.missed.as_ref().map_or(0, |missed| missed.retries);
        for _ in 0..=tries {
            let first = self.out.commands.len();
            let Some(at) = self.place(scope, &transfer.at).map_err(bad)? else {
                return Ok(());
            };
            self.transfer(at, transfer, true).map_err(bad)?;
            self.note_step(scope, step, first)?;
            let Some(missed) = &transfer.missed else {
                return Ok(());
            };
            match self.decisions.ask(gripped(missed)).map_err(bad)? {
                Some(Answer::Choice(answer)) if answer == NO => {}
                _ => return Ok(()),
            }
        }
        let missed = transfer.missed.as_ref();
        missed.map_or(Ok(()), |missed| self.steps(scope, &missed.steps.0))
    }

    /// Moves above a place, down, grips or releases, and up again.
    pub(super) fn transfer(
        &mut self,
        at: Spot,
        transfer: &Transfer,
        picks: bool,
    ) -> Result<(), String> {
        let then = match (self.state.tool, transfer.gripper) {
            (Tool::SuctionCup, None) => Here {
                suction: Some(picks),
                ..Here::default()
            },
            (Tool::Gripper, Some(_)) => Here {
                gripper: transfer.gripper,
                ..Here::default()
            },
            (Tool::SuctionCup, Some(_)) => {
                return Err("the mounted tool is a suction cup; remove gripper, or select a gripper by a step with tool".into());
            }
            (Tool::Gripper, None) => {
                return Err(
                    "the mounted tool is a gripper; add gripper with its angle, -90 to 90 degrees"
                        .into(),
                );
            }
            (tool, _) => {
                return Err(format!(
                    "the mounted tool is a {}; pick and place need a suction cup or a gripper: select it by a step with tool",
                    tool.name()
                ));
            }
        };
        let mut path = transfer.path;
        if transfer.approach_mm > 0.0 {
            let above = at.moved(up(transfer.approach_mm), &self.state);
            self.target(emit::target(&above, path, None, &self.state))?;
            path = MovingMode::MovL;
        }
        self.state.grip(&then);
        self.target(emit::target(
            &at,
            path,
            Some(transfer.settle_s),
            &self.state,
        ))?;
        if transfer.retreat_mm > 0.0 {
            let above = at.moved(up(transfer.retreat_mm), &self.state);
            self.target(emit::target(&above, MovingMode::MovL, None, &self.state))?;
        }
        Ok(())
    }

    /// Returns a place; `None` if it is not given yet, or its step is skipped.
    pub(super) fn place(
        &mut self,
        scope: &Scope<'_>,
        place: &Place,
    ) -> Result<Option<Spot>, String> {
        let Place::External(external) = place else {
            return scope.spot(place, &self.state).map(Some);
        };
        let Some(Answer::Place(given)) = self.decisions.ask(where_is(external))? else {
            return Ok(None);
        };
        let point = Point::Cartesian {
            position: [given.x_mm, given.y_mm, given.z_mm],
            rotation: Some(given.rotation_deg),
            frame: None,
        };
        scope.point(&point, &self.state).map(Some)
    }
}

fn decides(steps: &Steps) -> bool {
    let is_external = |place: &Place| matches!(place, Place::External(_));
    steps.0.iter().any(|step| match step.get_ref() {
        Action::Choose(_) | Action::While(..) | Action::Set(_) | Action::Add(_) => true,
        Action::Pick(transfer) => transfer.missed.is_some() || is_external(&transfer.at),
        Action::Place(transfer) => is_external(&transfer.at),
        Action::Go(go) => is_external(&go.to),
        action => action.inner().any(decides),
    })
}

fn where_is(place: &ExternalPlace) -> PendingQuestion {
    PendingQuestion {
        number: 0,
        question: Question::Place { name: place.name() },
        timeout_s: place.timeout,
        otherwise: (place.otherwise == AfterTimeout::Skip).then_some(Answer::Skip),
    }
}

fn gripped(missed: &Missed) -> PendingQuestion {
    PendingQuestion {
        number: 0,
        question: Question::Choice {
            text: "Was it picked up?".into(),
            answers: vec!["yes".into(), NO.into()],
            by: missed.by,
        },
        timeout_s: None,
        otherwise: None,
    }
}

const fn up(z: f64) -> Offset {
    Offset { x: 0.0, y: 0.0, z }
}

const NO: &str = "no";
const NEXT_CYCLE: PendingQuestion = PendingQuestion {
    number: 0,
    question: Question::NextCycle,
    timeout_s: None,
    otherwise: None,
};
/// The largest number of passes of a loop between two questions.
const MAX_PASSES: u32 = 100_000;
