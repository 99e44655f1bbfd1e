//! The compiler from programs to commands.

mod decide;
mod emit;
mod resolve;
mod state;

use std::collections::BTreeMap;
use std::sync::Arc as Shared;

use dobot_api::{Answer, JobPause, JobRepeat};
use dobot_arm::{Calibration, Joints, Pose, Position, Tool, inverse};
use dobot_motion::to_raw;
use dobot_wire::{Command, MovingMode};
use toml::Spanned;

use self::decide::Decisions;
use self::resolve::Spot;
use self::state::State;
use crate::files::{Called, MAX_COMMANDS, beside, error};
use crate::program::{Arc, Drawing, Go};
use crate::{
    Action, Compiled, CompiledStep, Files, Here, Program, ProgramError, Steps, Times, Variables,
    barrier_reason,
};

impl Program {
    /// Compiles the program into commands. `files` provides the called programs and the drawings.
    ///
    /// Inner repeats and grids are expanded, up to 1,000,000 commands. A repeat that is the last
    /// step of the program is not: see [`Compiled::repeat`]. If its first cycle differs from the
    /// later ones, the first cycle is expanded before them.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] with the line of the step: an unreadable file, recursive calls, too many
    /// commands, a frame or an arc whose points lie on a line, or a step that needs the position of
    /// the arm before the first motion.
    pub fn compile(&self, files: &mut dyn Files) -> Result<Compiled, ProgramError> {
        self.compile_for(&Calibration::NONE, files)
    }

    /// Compiles the program for a calibrated arm: the program contains true places, the commands
    /// raw ones. The commands of drawings must already be raw.
    ///
    /// # Errors
    ///
    /// Those of [`compile`](Self::compile), and [`ProgramError`] if this arm cannot reach a place.
    pub fn compile_for(
        &self,
        arm: &Calibration,
        files: &mut dyn Files,
    ) -> Result<Compiled, ProgramError> {
        self.compile_answered(arm, files, &[])
    }

    /// Compiles the program up to the first question without an answer.
    ///
    /// # Errors
    ///
    /// Those of [`compile_for`](Self::compile_for), and [`ProgramError`] if an answer does not fit
    /// its question, the first question comes before the first motion, or a loop never ends.
    pub fn compile_answered(
        &self,
        arm: &Calibration,
        files: &mut dyn Files,
        answers: &[Answer],
    ) -> Result<Compiled, ProgramError> {
        let mut called = Called::default();
        called.load(self, files, &mut Vec::new())?;
        let mut compiler = Compiler {
            files,
            called: &called,
            arm: *arm,
            from: None,
            state: State::new(self.start_speed_percent),
            decisions: Decisions::new(answers, &self.variables),
            out: Compiled {
                title: self.title.clone(),
                start_speed_percent: self.start_speed_percent,
                ..Compiled::default()
            },
        };
        let scope = Scope {
            program: self,
            path: None,
            file: None,
            call_line: None,
            cells: BTreeMap::new(),
        };
        compiler.whole(&scope)?;
        compiler.finish(&scope)
    }
}

struct Compiler<'a> {
    files: &'a mut dyn Files,
    called: &'a Called,
    /// The calibration of the arm.
    arm: Calibration,
    /// The angles that the arm reports at the last target, if known.
    from: Option<Joints>,
    state: State,
    decisions: Decisions<'a>,
    out: Compiled,
}

/// A scope of names: a program, and the current cells of its grids.
#[derive(Clone)]
struct Scope<'a> {
    program: &'a Program,
    path: Option<&'a str>,
    file: Option<Shared<str>>,
    /// The line of the main program that calls it.
    call_line: Option<usize>,
    cells: BTreeMap<&'a str, Spot>,
}

impl Scope<'_> {
    fn error(&self, step: &Spanned<Action>, reason: String) -> ProgramError {
        error(
            self.program,
            step,
            self.path.map(str::to_owned).as_ref(),
            reason,
        )
    }
}

impl Compiler<'_> {
    /// Compiles the main program; a repeat at its end is not expanded.
    fn whole(&mut self, scope: &Scope<'_>) -> Result<(), ProgramError> {
        let steps = &scope.program.steps.0;
        let Some((last, before)) = steps.split_last() else {
            return Ok(());
        };
        self.steps(scope, before)?;
        match last.get_ref() {
            Action::Repeat(Times::Count(1), inner) => self.steps(scope, &inner.0),
            Action::Repeat(times, inner) if self.decides(scope) => {
                self.unroll(scope, last, *times, inner)
            }
            Action::Repeat(times, inner) => self.cycle(scope, *times, inner),
            _ => self.step(scope, last),
        }
    }

    /// Compiles a cycle twice: if the second pass differs from the first, the first is kept apart.
    fn cycle(
        &mut self,
        scope: &Scope<'_>,
        times: Times,
        inner: &Steps,
    ) -> Result<(), ProgramError> {
        let first = self.mark();
        self.steps(scope, &inner.0)?;
        let second = self.mark();
        self.steps(scope, &inner.0)?;
        let same = self.out.commands[first.commands..second.commands]
            == self.out.commands[second.commands..];
        if same {
            self.out.commands.truncate(second.commands);
            self.out.steps.truncate(second.steps);
            self.out.pauses.truncate(second.pauses);
        }
        let times = match times {
            Times::Forever => None,
            Times::Count(count) => Some(if same { count } else { count - 1 }),
        };
        self.out.first_apart = !same;
        let from = if same {
            first.commands
        } else {
            second.commands
        };
        // A cycle that runs once is not a repeat.
        self.out.repeat = Some(JobRepeat { from, times }).filter(|repeat| repeat.times != Some(1));
        Ok(())
    }

    fn mark(&self) -> Mark {
        Mark {
            commands: self.out.commands.len(),
            steps: self.out.steps.len(),
            pauses: self.out.pauses.len(),
        }
    }

    fn finish(self, scope: &Scope<'_>) -> Result<Compiled, ProgramError> {
        let commands = self.out.commands.len() as u64;
        let first = scope.program.steps.0.first();
        let line = first.map(|step| scope.program.line_of(step));
        let bad = |reason| ProgramError::at(line, reason);
        if commands > MAX_COMMANDS {
            return Err(bad(format!(
                "the program has {commands} commands; a job may have {MAX_COMMANDS}"
            )));
        }
        if self.out.pauses.len() > MAX_PAUSES {
            let found = self.out.pauses.len();
            return Err(bad(format!(
                "the program waits {found} times for a person; allowed are {MAX_PAUSES}"
            )));
        }
        if self.decisions.question.is_some() && self.has_laser_on() {
            return Err(bad(
                "the laser is on while the program asks; add a step with laser = false before it"
                    .into(),
            ));
        }
        if self.decisions.unused() > 0 {
            return Err(bad(
                "the program has fewer questions than answers were given".into(),
            ));
        }
        if !self.state.has_moved {
            return Err(bad(if self.decisions.question.is_some() {
                "the first question comes before the first motion; put a step with go before it"
            } else {
                "no step moves the arm; add a step with go"
            }
            .into()));
        }
        Ok(Compiled {
            asks: self.decisions.question.is_some() || !self.decisions.used().is_empty(),
            answers: self.decisions.used().to_vec(),
            question: self.decisions.question,
            ..self.out
        })
    }

    fn steps(&mut self, scope: &Scope<'_>, steps: &[Spanned<Action>]) -> Result<(), ProgramError> {
        steps.iter().try_for_each(|step| self.step(scope, step))
    }

    fn step(&mut self, scope: &Scope<'_>, step: &Spanned<Action>) -> Result<(), ProgramError> {
        let bad = |reason| scope.error(step, reason);
        if self.decisions.question.is_some() {
            return Ok(());
        }
        match step.get_ref() {
            Action::Choose(choose) => return self.choose(scope, step, choose),
            Action::While(condition, inner) => {
                return self.repeat_while(scope, step, condition, inner);
            }
            Action::Pick(transfer) => return self.pick(scope, step, transfer),
            Action::Set(variables) => {
                self.decisions.variables.extend(variables.clone());
                return Ok(());
            }
            Action::Add(variables) => return self.decisions.add(variables).map_err(bad),
            Action::Repeat(times, inner) => {
                let Times::Count(count) = times else {
                    return Err(bad(
                        "an endless repeat must be the last step of the program".into(),
                    ));
                };
                return (0..*count).try_for_each(|_| self.steps(scope, &inner.0));
            }
            Action::Each(grids, inner) => return self.each(scope, step, grids, inner),
            Action::Call(file) => return self.call(scope, step, file),
            _ => {}
        }
        let first = self.out.commands.len();
        self.simple(scope, step.get_ref()).map_err(bad)?;
        self.note_step(scope, step, first)
    }

    /// Adds a step with the commands from `first` on.
    fn note_step(
        &mut self,
        scope: &Scope<'_>,
        step: &Spanned<Action>,
        first: usize,
    ) -> Result<(), ProgramError> {
        self.limit().map_err(|reason| scope.error(step, reason))?;
        // A wait before the first motion belongs to the next step.
        if self.out.commands.len() > first {
            let line = scope.program.line_of(step);
            self.out.steps.push(CompiledStep {
                first,
                file: scope.file.clone(),
                line,
                main_line: scope.call_line.unwrap_or(line),
                label: label(step.get_ref()).into(),
                barrier: match step.get_ref() {
                    Action::Barrier(name) => Some(name.as_str().into()),
                    _ => None,
                },
            });
        }
        Ok(())
    }

    /// Limits the number of commands, with room for a separate first cycle.
    fn limit(&self) -> Result<(), String> {
        let found = self.out.commands.len() as u64;
        if found > 2 * MAX_COMMANDS {
            return Err(format!(
                "the program has {found} commands up to here; a job may have {MAX_COMMANDS}"
            ));
        }
        Ok(())
    }

    fn each(
        &mut self,
        scope: &Scope<'_>,
        step: &Spanned<Action>,
        grids: &[String],
        inner: &Steps,
    ) -> Result<(), ProgramError> {
        let bad = |reason| scope.error(step, reason);
        let names: Vec<_> = grids
            .iter()
            .filter_map(|grid| scope.program.grids.get_key_value(grid))
            .collect();
        let count = names.first().map_or(0, |name| name.1.cells());
        for cell in 0..count {
            let mut within = scope.clone();
            for (name, grid) in &names {
                let spot = scope.cell(grid, cell, &self.state).map_err(bad)?;
                within.cells.insert(name, spot);
            }
            self.steps(&within, &inner.0)?;
        }
        Ok(())
    }

    fn call(
        &mut self,
        scope: &Scope<'_>,
        step: &Spanned<Action>,
        file: &str,
    ) -> Result<(), ProgramError> {
        let path = beside(scope.path, file);
        let called = self.called;
        let Some(program) = called.get(&path) else {
            return Err(scope.error(step, format!("file {path} is not available any more")));
        };
        let within = Scope {
            program,
            file: Some(path.as_str().into()),
            path: Some(&path),
            call_line: scope.call_line.or(Some(scope.program.line_of(step))),
            cells: BTreeMap::new(),
        };
        self.steps(&within, &program.steps.0)
    }

    fn simple(&mut self, scope: &Scope<'_>, action: &Action) -> Result<(), String> {
        match action {
            Action::Go(go) => self.go(scope, go),
            Action::Here(then) => self.here(then),
            Action::Laser(on) => {
                self.push(emit::laser(*on));
                Ok(())
            }
            Action::Wait(message) => self.wait(message),
            Action::Barrier(name) => self.barrier(name),
            Action::Speed(speed) => {
                let commands = self.state.set_speed(speed);
                self.out.commands.extend(commands);
                self.from = None;
                Ok(())
            }
            Action::Tool(name) => {
                let Some(tool) = scope.program.tools.get(name) else {
                    return Err(format!("there is no tool {name:?}"));
                };
                self.state.mount(tool);
                self.push(emit::mounted(tool));
                Ok(())
            }
            Action::Arc(arc) => self.arc(scope, arc, false),
            Action::Circle(arc) => self.arc(scope, arc, true),
            Action::Drawing(drawing) => self.drawing(scope, drawing),
            Action::Place(transfer) => {
                let at = self.place(scope, &transfer.at)?;
                at.map_or(Ok(()), |at| self.transfer(at, transfer, false))
            }
            Action::Repeat(..)
            | Action::Each(..)
            | Action::Call(_)
            | Action::Choose(_)
            | Action::While(..)
            | Action::Set(_)
            | Action::Add(_)
            | Action::Pick(_) => Ok(()),
        }
    }

    fn push(&mut self, command: Command) {
        self.out.commands.push(command);
    }

    fn go(&mut self, scope: &Scope<'_>, go: &Go) -> Result<(), String> {
        let Some(spot) = self.place(scope, &go.to)? else {
            return Ok(());
        };
        let spot = spot.moved(go.offset, &self.state);
        self.state.grip(&go.then);
        self.target(emit::target(&spot, go.path, go.then.pause, &self.state))?;
        Ok(())
    }

    /// Adds a target; the first one is approached slowly.
    fn target(&mut self, target: Command) -> Result<(), String> {
        let (tool, from) = (self.state.tool, self.from.as_ref());
        let raw = to_raw(&target, &self.arm, tool, from).map_err(|error| error.to_string())?;
        self.from = joints_of(&raw, tool);
        let soft = self.state.soft_start();
        if let Some([slow, _]) = soft {
            self.push(slow);
        }
        self.push(raw);
        if let Some([_, normal]) = soft {
            self.push(normal);
        }
        self.state.arrived(target);
        Ok(())
    }

    /// Sends the arm to its current place by its joints, which moves nothing and is safe (note
    /// N34).
    fn here(&mut self, then: &Here) -> Result<(), String> {
        self.state.grip(then);
        let again = self.state.again(then.pause).ok_or(NOWHERE)?;
        self.target(again)?;
        Ok(())
    }

    /// Adds a wait. After the first motion a command follows it, so that a wait can be the last
    /// step of a program.
    fn wait(&mut self, message: &str) -> Result<(), String> {
        let before = self.out.commands.len();
        if self
            .out
            .pauses
            .last()
            .is_some_and(|pause| pause.before == before)
        {
            return Err("two waits follow each other before the first motion; merge them".into());
        }
        self.out.pauses.push(JobPause {
            before,
            message: message.to_owned(),
        });
        match self.state.again(None) {
            Some(again) => self.target(again)?,
            None if self.state.has_moved => return Err(NOWHERE.to_owned()),
            None => {}
        }
        Ok(())
    }

    /// Adds a barrier as a pause; the client that resumes the job determines when all arms have
    /// arrived.
    fn barrier(&mut self, name: &str) -> Result<(), String> {
        if !self.state.has_moved {
            return Err(format!(
                "the barrier {name:?} is before the first motion; all arms start together anyway: put a step with go before it"
            ));
        }
        self.wait(&barrier_reason(name))
    }

    fn arc(&mut self, scope: &Scope<'_>, arc: &Arc, is_circle: bool) -> Result<(), String> {
        let from = self.state.spot().ok_or(NOWHERE)?;
        let through = scope.spot(&arc.through, &self.state)?;
        let to = scope.spot(&arc.to, &self.state)?;
        let at = [from, through, to].map(|value| value.pose(&self.state).position);
        let places = crate::round::chords(at, is_circle, arc.tolerance)?;
        let turned = |spot: &Spot| spot.pose(&self.state).rotation.0;
        let (begin, end) = (
            turned(&from),
            if is_circle {
                turned(&from)
            } else {
                turned(&to)
            },
        );
        let count = places.len();
        for (index, place) in places.into_iter().enumerate() {
            #[expect(clippy::cast_precision_loss, reason = "some thousands at most")]
            let share = (index + 1) as f64 / count as f64;
            let spot = Spot::wrist(place, begin + (end - begin) * share);
            self.target(emit::target(&spot, MovingMode::MovL, None, &self.state))?;
        }
        Ok(())
    }

    fn drawing(&mut self, scope: &Scope<'_>, drawing: &Drawing) -> Result<(), String> {
        let path = beside(scope.path, &drawing.file);
        let commands = self.files.drawing(&path, drawing)?;
        let moves = |command: &&Command| {
            !matches!(
                command,
                Command::Configuration(_) | Command::PlaybackAdjustment(_) | Command::JointJog(_)
            )
        };
        let Some(Command::MoveTo(_) | Command::MoveJoints(_)) = commands.iter().find(moves) else {
            return Err(format!(
                "the drawing {path} does not start with a target (state 3 or 6), which gives its place"
            ));
        };
        self.out.commands.extend(commands);
        self.from = None;
        self.state.drawn();
        Ok(())
    }
}

/// The joint angles at the end of a target.
fn joints_of(target: &Command, tool: Tool) -> Option<Joints> {
    match target {
        Command::MoveTo(move_to) => {
            let [x, y, z] = [move_to.x_mm, move_to.y_mm, move_to.z_mm].map(f64::from);
            let pose = Pose {
                position: Position::new(x, y, z),
                ..Pose::default()
            };
            inverse(&pose, tool).ok()
        }
        Command::MoveJoints(move_joints) => {
            let [base, rear, fore] = [
                move_joints.base_deg,
                move_joints.rear_deg,
                move_joints.fore_deg,
            ]
            .map(f64::from);
            Some(Joints::new(base, rear, fore, 0.0))
        }
        _ => None,
    }
}

/// The size of the output at a moment.
struct Mark {
    commands: usize,
    steps: usize,
    pauses: usize,
}

/// A description of a step for people.
fn label(action: &Action) -> String {
    use crate::Place;
    let name = |place: &Place| match place {
        Place::Named(name) => name.clone(),
        Place::At(crate::Point::Cartesian {
            position: [x, y, z],
            ..
        }) => format!("x {x} y {y} z {z}"),
        Place::At(crate::Point::Joints([base, rear, fore, _])) => {
            format!("base {base} rear {rear} fore {fore}")
        }
        Place::External(place) => format!("{:?}", place.name()),
    };
    match action {
        Action::Go(go) => format!("go to {}", name(&go.to)),
        Action::Here(then) => here_label(then),
        Action::Laser(on) => format!("laser {}", on_off(*on)),
        Action::Wait(message) => format!("wait: {message}"),
        Action::Barrier(name) => format!("barrier {name}"),
        Action::Speed(_) => "speed".to_owned(),
        Action::Tool(tool) => format!("tool {tool}"),
        Action::Arc(arc) => format!("arc to {}", name(&arc.to)),
        Action::Circle(arc) => format!("circle through {}", name(&arc.through)),
        Action::Drawing(drawing) => format!("draw {}", drawing.file),
        Action::Repeat(..) => "repeat".to_owned(),
        Action::Each(grids, _) => format!("each of {}", grids.join(", ")),
        Action::Call(file) => format!("call {file}"),
        Action::Choose(choose) => format!("choose: {}", choose.question),
        Action::Set(variables) => format!("set {}", names(variables)),
        Action::Add(variables) => format!("add to {}", names(variables)),
        Action::While(condition, _) => format!("while {condition}"),
        Action::Pick(transfer) => format!("pick at {}", name(&transfer.at)),
        Action::Place(transfer) => format!("place at {}", name(&transfer.at)),
    }
}

fn names(variables: &Variables) -> String {
    let names: Vec<&str> = variables.keys().map(String::as_str).collect();
    names.join(", ")
}

fn here_label(then: &Here) -> String {
    let suction = then.suction.map(|on| format!("suction {}", on_off(on)));
    let gripper = then.gripper.map(|angle| format!("gripper {angle}°"));
    let pause = then.pause.map(|seconds| format!("pause {seconds} s"));
    let all: Vec<String> = [suction, gripper, pause].into_iter().flatten().collect();
    all.join(", ")
}

const fn on_off(on: bool) -> &'static str {
    if on { "on" } else { "off" }
}

/// The largest number of pauses of a job.
const MAX_PAUSES: usize = 1000;
const NOWHERE: &str =
    "the position of the arm is unknown here; put a step with go before it (also after a drawing)";
