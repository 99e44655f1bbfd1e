//! Programs that ask while they run: what a job keeps of them, how an answer continues them, and
//! the paths through them.

use std::collections::{BTreeMap, BTreeSet};

use dobot_api::{Answer, AskingProgram, GivenPlace, NewJob, Question};
use dobot_arm::Calibration;
use dobot_wire::Command;

use crate::files::{Called, beside, error};
use crate::program::Drawing;
use crate::{Action, Compiled, CompiledStep, Files, Program, ProgramError, Steps, Times};

impl Program {
    /// Compiles the program with another number of cycles, unless it is `None`. Returns the program
    /// with that number, too.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] as [`compile_for`](Self::compile_for) returns it.
    pub fn compile_times(
        &self,
        times: Option<Times>,
        arm: &Calibration,
        files: &mut dyn Files,
    ) -> Result<(Self, Compiled), ProgramError> {
        let mut compiled = self.compile_for(arm, files)?;
        match times {
            Some(times) if compiled.asks => {
                let program = self.clone().with_times(times);
                let compiled = program.compile_for(arm, files)?;
                Ok((program, compiled))
            }
            Some(times) => {
                compiled.repeat(times);
                Ok((self.clone(), compiled))
            }
            None => Ok((self.clone(), compiled)),
        }
    }

    /// Returns the program with another number of cycles: of its final repeat, or of all its steps.
    fn with_times(mut self, times: Times) -> Self {
        let steps = std::mem::take(&mut self.steps).0;
        let mut actions: Vec<Action> = steps.into_iter().map(toml::Spanned::into_inner).collect();
        match actions.last_mut() {
            Some(Action::Repeat(known, _)) => *known = times,
            _ => actions = vec![Action::Repeat(times, Steps::new(actions))],
        }
        self.steps = Steps::new(actions);
        self
    }

    /// Returns the job that starts at a step of a path through the program, counted from 0; `None`
    /// if the path has no such step. Questions before that step count as answered as in the path.
    /// If the program asks, the job has what is needed to continue it.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] if a file cannot be read, or the step goes to a position that is given
    /// while the program runs and that the program asks for before the job would start.
    pub fn job(
        &self,
        path: &Compiled,
        from_step: usize,
        arm: &Calibration,
        files: &mut dyn Files,
    ) -> Result<Option<NewJob>, ProgramError> {
        if !path.asks {
            return Ok(path.from_step(from_step).map(|rest| rest.job()));
        }
        if from_step >= path.steps.len() {
            return Ok(None);
        }
        let mut files = self.kept_files(files)?;
        let begun = self.begun(path, from_step, arm, &mut files)?;
        let Some(rest) = begun.from_step(from_step) else {
            return Ok(None);
        };
        let mut job = rest.job();
        job.program.asking = Some(Box::new(AskingProgram {
            text: self.to_toml(),
            files: files.texts,
            drawings: files.drawings,
            from_step,
            answers: begun.answers,
            question: begun.question,
        }));
        Ok(Some(job))
    }

    /// Compiles a path up to the question after a step, with as few of its answers as possible.
    fn begun(
        &self,
        path: &Compiled,
        from_step: usize,
        arm: &Calibration,
        files: &mut KeptFiles<'_>,
    ) -> Result<Compiled, ProgramError> {
        let mut external = BTreeSet::new();
        let mut begun = self.compile_answered(arm, files, &[])?;
        for count in 1..=path.answers.len() {
            let steps = begun.steps.len();
            if steps > from_step {
                break;
            }
            if let Some(Question::Place { name }) = begun.question.map(|pending| pending.question) {
                external.insert(steps);
                if steps == from_step {
                    let step = &path.steps[from_step];
                    return Err(ProgramError {
                        file: step.file.as_deref().map(str::to_owned),
                        ..ProgramError::at(step.line, no_place(from_step, &name, &external))
                    });
                }
            }
            begun = self.compile_answered(arm, files, &path.answers[..count])?;
        }
        Ok(begun)
    }

    /// Reads all files of the program.
    fn kept_files<'a>(&self, files: &'a mut dyn Files) -> Result<KeptFiles<'a>, ProgramError> {
        let mut kept = KeptFiles {
            source: Some(files),
            texts: BTreeMap::new(),
            drawings: BTreeMap::new(),
        };
        let mut called = Called::default();
        called.load(self, &mut kept, &mut Vec::new())?;
        called.drawings(self, &mut kept)?;
        Ok(kept)
    }

    /// Returns the paths through a program that asks: each answer of each question is in one of
    /// them, and positions that are given while it runs are [`EXAMPLE_PLACE`]. A program that does
    /// not ask has one path.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] as [`compile_answered`](Self::compile_answered) returns it.
    pub fn paths(
        &self,
        arm: &Calibration,
        files: &mut dyn Files,
    ) -> Result<Vec<Compiled>, ProgramError> {
        let mut tried = BTreeSet::new();
        let mut paths = Vec::new();
        loop {
            let known = tried.len();
            let path = self.path(arm, files, &mut tried)?;
            let asks = path.asks;
            if paths.is_empty() || tried.len() > known {
                paths.push(path);
            }
            if !asks || tried.len() == known || paths.len() == MAX_PATHS {
                return Ok(paths);
            }
        }
    }

    /// Returns a path with answers that no path had, as far as there are any.
    fn path(
        &self,
        arm: &Calibration,
        files: &mut dyn Files,
        tried: &mut BTreeSet<(String, String)>,
    ) -> Result<Compiled, ProgramError> {
        let mut answers = Vec::new();
        loop {
            let mut compiled = self.compile_answered(arm, files, &answers)?;
            let Some(pending) = compiled.question.take() else {
                return Ok(compiled);
            };
            let answer = match &pending.question {
                Question::NextCycle => None,
                Question::Place { .. } => Some(Answer::Place(EXAMPLE_PLACE)),
                Question::Choice { text, answers, .. } => untried(text, answers, tried),
            };
            match answer {
                Some(answer) if answers.len() < MAX_ANSWERS => answers.push(answer),
                _ => return Ok(compiled),
            }
        }
    }
}

/// Returns the path and its step, both counted from 0, that come first on a line of the program, or
/// after it: `None` if no path has a step there. A called program is on the line of its call.
#[must_use]
pub fn first_step_at(paths: &[Compiled], line: usize) -> Option<(usize, usize)> {
    let starts = paths.iter().enumerate().filter_map(|(path, compiled)| {
        let is_here = |step: &CompiledStep| step.main_line >= line;
        let step = compiled.steps.iter().position(is_here)?;
        Some((compiled.steps[step].main_line, path, step))
    });
    starts.min().map(|(_, path, step)| (path, step))
}

/// The first answer to a question that was not tried yet, or the first of all.
fn untried(
    question: &str,
    answers: &[String],
    tried: &mut BTreeSet<(String, String)>,
) -> Option<Answer> {
    let is_new = |answer: &&String| tried.insert((question.to_owned(), (*answer).clone()));
    let new = answers.iter().find(is_new);
    new.or(answers.first()).cloned().map(Answer::Choice)
}

/// Continues a program by an answer to its question; returns its whole job.
///
/// # Errors
///
/// [`ProgramError`] if the answer does not fit, or leads to a step that is not possible on this
/// arm.
pub fn continued(
    asking: &AskingProgram,
    answer: Answer,
    arm: &Calibration,
) -> Result<NewJob, ProgramError> {
    let pending = asking.question.as_ref();
    let pending = pending.ok_or_else(|| ProgramError::new("the program asks nothing"))?;
    pending.check(&answer).map_err(ProgramError::new)?;
    let program = Program::from_toml(&asking.text)?;
    let mut asking = asking.clone();
    asking.answers.push(answer);
    let mut files = KeptFiles {
        source: None,
        texts: std::mem::take(&mut asking.files),
        drawings: std::mem::take(&mut asking.drawings),
    };
    let compiled = program.compile_answered(arm, &mut files, &asking.answers)?;
    let rest = compiled.from_step(asking.from_step);
    let rest = rest.ok_or_else(|| ProgramError::new("the program is shorter than its job"))?;
    let mut job = rest.job();
    job.program.asking = Some(Box::new(AskingProgram {
        files: files.texts,
        drawings: files.drawings,
        question: compiled.question,
        ..asking
    }));
    Ok(job)
}

/// The reason why a job cannot start at a step, counted from 0, whose position is not known yet.
fn no_place(step: usize, name: &str, external: &BTreeSet<usize>) -> String {
    let known = (0..step).rev().find(|step| !external.contains(step));
    format!(
        "step {} goes to the position {name:?}, which is given while the program runs; start at step {}",
        step + 1,
        known.map_or(1, |known| known + 1),
    )
}

/// The files of a program, kept for its continuation.
struct KeptFiles<'a> {
    /// Where files are read the first time; later there are only those that were kept.
    source: Option<&'a mut dyn Files>,
    texts: BTreeMap<String, String>,
    drawings: BTreeMap<String, Vec<Command>>,
}

impl Files for KeptFiles<'_> {
    fn program(&mut self, path: &str) -> Result<String, String> {
        if let Some(text) = self.texts.get(path) {
            return Ok(text.clone());
        }
        let text = self
            .source
            .as_mut()
            .ok_or_else(|| missing(path))?
            .program(path)?;
        self.texts.insert(path.to_owned(), text.clone());
        Ok(text)
    }

    fn drawing(&mut self, path: &str, drawing: &Drawing) -> Result<Vec<Command>, String> {
        let key = drawing_key(path, drawing);
        if let Some(commands) = self.drawings.get(&key) {
            return Ok(commands.clone());
        }
        let source = self.source.as_mut().ok_or_else(|| missing(path))?;
        let commands = source.drawing(path, drawing)?;
        self.drawings.insert(key, commands.clone());
        Ok(commands)
    }
}

fn missing(path: &str) -> String {
    format!("file {path} was not kept with the job; submit the program again")
}

fn drawing_key(path: &str, drawing: &Drawing) -> String {
    format!("{path} {} {}", drawing.pen_down, drawing.options)
}

impl Called {
    /// Prepares all drawings of a program and of those that it calls.
    fn drawings(&self, program: &Program, files: &mut dyn Files) -> Result<(), ProgramError> {
        prepare(program, None, &program.steps, files)?;
        self.by_path()
            .try_for_each(|(path, called)| prepare(called, Some(path), &called.steps, files))
    }
}

/// Prepares the drawings of steps.
fn prepare(
    program: &Program,
    path: Option<&str>,
    steps: &Steps,
    files: &mut dyn Files,
) -> Result<(), ProgramError> {
    for step in &steps.0 {
        if let Action::Drawing(drawing) = step.get_ref() {
            let prepared = files.drawing(&beside(path, &drawing.file), drawing);
            prepared
                .map_err(|reason| error(program, step, path.map(str::to_owned).as_ref(), reason))?;
        }
        for inner in step.get_ref().inner() {
            prepare(program, path, inner, files)?;
        }
    }
    Ok(())
}

/// The position that stands for one that is given while the program runs, when it is checked.
pub const EXAMPLE_PLACE: GivenPlace = GivenPlace {
    name: None,
    x_mm: 200.0,
    y_mm: 0.0,
    z_mm: 0.0,
    rotation_deg: 0.0,
    sense: None,
};
/// The largest number of paths that are checked.
const MAX_PATHS: usize = 100;
/// The largest number of answers of a path.
const MAX_ANSWERS: usize = 50;
