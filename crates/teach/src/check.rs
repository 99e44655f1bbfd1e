//! The whole program looked at by the motion model, before anything moves.

use std::fmt;

use dobot_api::JobRepeat;
use dobot_arm::{Joints, Limits, Tool};
use dobot_motion::{ArmPlace, Model};
use dobot_safety::{Policy, Violation};
use dobot_wire::Command;
use serde::Serialize;

use crate::Compiled;

/// What is wrong with a program, and how long it takes by the motion model.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Report {
    /// All that is wrong, in the order of the commands.
    pub problems: Vec<Problem>,
    /// How long each step takes, in seconds, the first time.
    pub steps_s: Vec<f64>,
    /// How long all commands take once, in seconds; the way to the first target counts from where the model is.
    pub once_s: f64,
    /// How long a cycle takes that follows another one, in seconds.
    pub cycle_s: Option<f64>,
    /// How long all of it takes, in seconds; none where it goes on until a person ends it.
    pub total_s: Option<f64>,
}

/// Something that is wrong with a program.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Problem {
    /// The step, counted from 1 in the order in which they are done.
    pub step: usize,
    /// The called program in which it stands; `None` in the program itself.
    pub file: Option<String>,
    /// The line on which it begins, counted from 1.
    pub line: usize,
    /// What the step does.
    pub label: String,
    /// The command, counted from 0.
    pub command: usize,
    /// The rule of the policy, or `arm` where the arm itself cannot do it.
    pub rule: String,
    /// What is wrong, and what is allowed.
    pub message: String,
    /// What helps.
    pub remedy: String,
}

/// `step 3 (line 12, go to tray): what is wrong; what helps`.
impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "step {} (", self.step)?;
        if let Some(file) = &self.file {
            write!(f, "{file}, ")?;
        }
        let (line, label) = (self.line, &self.label);
        write!(
            f,
            "line {line}, {label}): {}; {}",
            self.message, self.remedy
        )
    }
}

/// Looks at every command of a program under a policy, from what is believed of the arm. The way to the first target
/// is not judged: the arm may be anywhere by then; the station looks at it when the program is started.
///
/// A cycle is looked at twice, for its second time begins where its first one ended. Behind a command that is not
/// allowed it goes on from where that would have ended, or else from the next target.
#[must_use]
pub fn check(program: &Compiled, policy: &Policy, start: Model) -> Report {
    let mut walk = Walk {
        program,
        policy,
        model: start,
        is_known: false,
        report: Report::default(),
        is_again: false,
    };
    let took: Vec<f64> = (0..program.commands.len())
        .map(|at| walk.command(at))
        .collect();
    walk.report.steps_s = steps_s(program, &took);
    walk.report.once_s = took.iter().sum();
    walk.check_end();
    walk.report.total_s = Some(walk.report.once_s);
    if let Some(JobRepeat { from, times }) = program.repeat {
        walk.is_again = true;
        let cycle_s: f64 = (from..program.commands.len())
            .map(|at| walk.command(at))
            .sum();
        walk.report.cycle_s = Some(cycle_s);
        #[expect(clippy::cast_precision_loss, reason = "nobody waits for 2^53 cycles")]
        let more = times.map(|it| it.saturating_sub(1) as f64);
        walk.report.total_s = more.map(|it| walk.report.once_s + cycle_s * it);
    }
    walk.report
}

struct Walk<'a> {
    program: &'a Compiled,
    policy: &'a Policy,
    model: Model,
    /// Whether the model says where the arm is: not before the first target, nor behind a command that leads nowhere.
    is_known: bool,
    /// Whether it is at the second cycle.
    is_again: bool,
    report: Report,
}

impl Walk<'_> {
    /// How long the command takes, in seconds, as far as that is known.
    fn command(&mut self, at: usize) -> f64 {
        let command = &self.program.commands[at];
        let is_target = matches!(command, Command::MoveTo(_) | Command::MoveJoints(_));
        if !self.is_known && is_target {
            return self.unjudged(at, command);
        }
        let judged = self.policy.check(&self.model, command);
        let planned = self.model.trajectory(command);
        if let Err(violation) = judged {
            self.found(at, &violation);
        }
        let Ok(trajectory) = planned else {
            self.skip(command);
            return 0.0;
        };
        self.model = self.model.after(command, &trajectory);
        trajectory.duration_s().unwrap_or(0.0)
    }

    /// A target from somewhere: only its end and its settings are judged.
    fn unjudged(&mut self, at: usize, command: &Command) -> f64 {
        let mut took = 0.0;
        match (
            self.model.trajectory(command),
            end_of(command, self.model.tool),
        ) {
            (Ok(trajectory), _) => {
                self.model = self.model.after(command, &trajectory);
                took = trajectory.duration_s().unwrap_or(0.0);
            }
            (Err(_), Some(place)) => self.model.place = place,
            (Err(error), None) => {
                self.found(at, &Violation::of_trajectory(&error));
                return 0.0;
            }
        }
        self.is_known = true;
        if let Err(violation) =
            self.policy
                .check_place(&self.model.place, self.model.tool, &self.model.calibration)
        {
            self.found(at, &violation);
        }
        took
    }

    /// Goes on from where a command would have ended.
    fn skip(&mut self, command: &Command) {
        match command {
            Command::MoveTo(_) | Command::MoveJoints(_) => match end_of(command, self.model.tool) {
                Some(place) => self.model.place = place,
                None => self.is_known = false,
            },
            Command::WriteVector(_) => self.is_known = false,
            _ => {}
        }
    }

    /// A laser that is left on burns a hole, and so does one that is on when the arm rests.
    fn check_end(&mut self) {
        if !self.model.laser {
            return;
        }
        let at = self.program.commands.len().saturating_sub(1);
        self.problem(
            at,
            "laser",
            "the laser is still on when the program is over".to_owned(),
            "end with a step laser = false",
        );
    }

    fn found(&mut self, at: usize, violation: &Violation) {
        self.problem(
            at,
            &violation.rule,
            violation.message.clone(),
            remedy(&violation.rule),
        );
    }

    fn problem(&mut self, command: usize, rule: &str, message: String, remedy: &str) {
        if self.is_again && self.report.problems.iter().any(|it| it.command == command) {
            return;
        }
        let step = self.program.step_of(command).unwrap_or(0);
        let Some(place) = self.program.steps.get(step) else {
            return;
        };
        self.report.problems.push(Problem {
            step: step + 1,
            file: place.file.as_ref().map(ToString::to_string),
            line: place.line,
            label: place.label.to_string(),
            command,
            rule: rule.to_owned(),
            message,
            remedy: remedy.to_owned(),
        });
    }
}

/// Where a target leads, if the arm can be there.
fn end_of(command: &Command, tool: Tool) -> Option<ArmPlace> {
    // From a place from which every target can be come to.
    let anywhere = ArmPlace::at_joints(Joints::new(0.0, 45.0, 45.0, 0.0), tool);
    let mut model = Model::standing(dobot_wire::Dialect::SPECIFICATION, anywhere);
    model.tool = tool;
    let by_joints = match command {
        Command::MoveTo(it) => it.with_mode(dobot_wire::MovingMode::MovJ).into(),
        Command::MoveJoints(it) => it.with_mode(dobot_wire::MovingMode::MovJ).into(),
        _ => return None,
    };
    let trajectory = model.trajectory(&by_joints).ok()?;
    let place = model.after(&by_joints, &trajectory).place;
    Limits::STOCK
        .check_at(&place.joints, place.pose.position)
        .ok()
        .map(|()| place)
}

fn steps_s(program: &Compiled, took: &[f64]) -> Vec<f64> {
    let ends = program
        .steps
        .iter()
        .skip(1)
        .map(|it| it.first)
        .chain([took.len()]);
    program
        .steps
        .iter()
        .zip(ends)
        .map(|(step, end)| took[step.first..end].iter().sum())
        .collect()
}

fn remedy(rule: &str) -> &'static str {
    match rule.split('.').next().unwrap_or(rule) {
        "joints" => {
            "change the point, the angles or the rotation so that the joint turns less, or a straight line to path = \"movj\""
        }
        "workspace" => "move the point to where the policy and the arm allow it",
        "table" => "raise the point, or say the true length of the tool in the policy",
        "keep_out" => "go around it by a point between, or by another path",
        "speed" | "acceleration" => {
            "put a step with a lower speed before it, such as speed = { percent = 30 }"
        }
        "jump" => "set a lower jump_height in a speed step, or go by another path",
        "laser" => "burn with a drawing step, and let the policy allow it",
        _ => {
            "move the point to where the arm reaches it, or add a point between if only the way is out of reach"
        }
    }
}
