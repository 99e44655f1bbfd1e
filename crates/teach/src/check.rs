//! The check of a whole program with the motion model, before anything moves.

use std::fmt;

use dobot_api::JobRepeat;
use dobot_arm::{Joints, Limits, Tool};
use dobot_motion::{ArmPlace, Model};
use dobot_safety::{Policy, Violation};
use dobot_wire::Command;
use serde::Serialize;

use crate::Compiled;

/// The problems of a program, and the durations of its steps by the motion model.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Report {
    /// All problems, in the order of the commands.
    pub problems: Vec<Problem>,
    /// The duration of each step, in seconds, the first time, without the motion that the model
    /// cannot plan.
    pub steps_s: Vec<f64>,
}

/// A problem of a program.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Problem {
    /// The step, counted from 1 in order of execution.
    pub step: usize,
    /// The called program that contains the step; `None` for the program itself.
    pub file: Option<String>,
    /// The first line of the step, counted from 1.
    pub line: usize,
    /// A description of the step.
    pub label: String,
    /// The command, counted from 0.
    pub command: usize,
    /// The rule of the policy, or `arm` if the arm itself cannot execute the command.
    pub rule: String,
    /// What is wrong, and what is allowed.
    pub message: String,
    /// The remedy.
    pub remedy: String,
}

impl Problem {
    /// Creates the problem of a command, with its step and line; `None` if the program has no such
    /// command.
    #[must_use]
    pub fn of_command(
        program: &Compiled,
        command: usize,
        rule: &str,
        message: String,
        remedy: &str,
    ) -> Option<Self> {
        let step = program.step_of(command)?;
        let place = program.steps.get(step)?;
        Some(Self {
            step: step + 1,
            file: place.file.as_ref().map(ToString::to_string),
            line: place.line,
            label: place.label.to_string(),
            command,
            rule: rule.to_owned(),
            message,
            remedy: remedy.to_owned(),
        })
    }
}

/// Formats as `step 3 (line 12, go to tray): what is wrong; the remedy`.
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

/// Checks every command of a program under a policy, from an estimated state of the arm. The way to
/// the first target is not checked, because the arm may be anywhere by then; the station checks it
/// at the start of the program.
///
/// A cycle is checked twice, because its second pass starts where the first one ended. After a
/// command that is not allowed, the check continues from the end of that command, or else from the
/// next target.
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
    walk.check_end();
    if let Some(JobRepeat { from, .. }) = program.repeat {
        walk.is_again = true;
        for at in from..program.commands.len() {
            walk.command(at);
        }
    }
    walk.report
}

struct Walk<'a> {
    program: &'a Compiled,
    policy: &'a Policy,
    model: Model,
    /// Whether the model knows the position of the arm: not before the first target, nor after a
    /// command whose end is unknown.
    is_known: bool,
    /// Whether this is the second pass of the cycle.
    is_again: bool,
    report: Report,
}

impl Walk<'_> {
    /// The duration of the command, in seconds, as far as it is known.
    fn command(&mut self, at: usize) -> f64 {
        let command = &self.program.commands[at];
        let is_target = matches!(command, Command::MoveTo(_) | Command::MoveJoints(_));
        if !self.is_known && is_target {
            return self.check_from_unknown(at, command);
        }
        let judged = self.policy.check(&self.model, command);
        let planned = self.model.trajectory(command);
        if let Err(violation) = judged {
            self.report_violation(at, &violation);
        }
        let Ok(trajectory) = planned else {
            self.skip(command);
            return 0.0;
        };
        self.model = self.model.after(command, &trajectory);
        trajectory.duration_s().unwrap_or(0.0)
    }

    /// Checks a target from an unknown position: only its end and its settings.
    fn check_from_unknown(&mut self, at: usize, command: &Command) -> f64 {
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
                self.report_violation(at, &Violation::of_trajectory(&error));
                return 0.0;
            }
        }
        self.is_known = true;
        if let Err(violation) =
            self.policy
                .check_place(&self.model.place, self.model.tool, &self.model.calibration)
        {
            self.report_violation(at, &violation);
        }
        took
    }

    /// Continues from the place where a command would have ended.
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

    /// Reports a laser that is still on at the end: it burns a hole where the arm rests.
    fn check_end(&mut self) {
        if !self.model.laser {
            return;
        }
        let at = self.program.commands.len().saturating_sub(1);
        self.problem(
            at,
            "laser",
            "the laser is still on at the end of the program".to_owned(),
            "add a last step laser = false",
        );
    }

    fn report_violation(&mut self, at: usize, violation: &Violation) {
        self.problem(
            at,
            &violation.rule,
            violation.message.clone(),
            remedy(&violation.rule),
        );
    }

    fn problem(&mut self, command: usize, rule: &str, message: String, remedy: &str) {
        let mut known = self.report.problems.iter();
        if self.is_again && known.any(|problem| problem.command == command) {
            return;
        }
        let problem = Problem::of_command(self.program, command, rule, message, remedy);
        self.report.problems.extend(problem);
    }
}

/// The end of a target, if the arm can reach it.
fn end_of(command: &Command, tool: Tool) -> Option<ArmPlace> {
    // A pose from which every target can be reached.
    let anywhere = ArmPlace::at_joints(Joints::new(0.0, 45.0, 45.0, 0.0), tool);
    let mut model = Model::standing(dobot_wire::Dialect::SPECIFICATION, anywhere);
    model.tool = tool;
    let by_joints = match command {
        Command::MoveTo(target) => target.with_mode(dobot_wire::MovingMode::MovJ).into(),
        Command::MoveJoints(target) => target.with_mode(dobot_wire::MovingMode::MovJ).into(),
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
        .map(|step| step.first)
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
        "workspace" => "move the point into the range of the arm and the policy",
        "table" => "raise the point, or set the true length of the tool in the policy",
        "keep_out" => "go around it with a point in between, or with another path",
        "speed" | "acceleration" => {
            "add a step with a lower speed before it, for example speed = { percent = 30 }"
        }
        "jump" => "set a lower jump_height in a speed step, or use another path",
        "laser" => "burn with a drawing step, and allow the laser in the policy",
        _ => {
            "move the point into reach of the arm, or add a point in between if only the path is out of reach"
        }
    }
}
