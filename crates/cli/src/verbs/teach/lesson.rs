//! The program that is being taught.

use dobot_host::PlannedFor;
use std::collections::BTreeMap;

use dobot_api::NewJob;
use dobot_teach::{
    Action, Compiled, Files, Go, Here, Point, Problem, Program, ProgramDocument, ProgramError,
    RecordedPlace, Steps, Times, ToolState, check, path_steps,
};
use dobot_wire::MovingMode;

/// A program with a cursor and an undo history.
#[derive(Debug)]
pub(crate) struct Lesson {
    title: String,
    /// `None` before the first point: a program has at least one step.
    document: Option<ProgramDocument>,
    cursor: usize,
    done: Vec<Done>,
    undone: Vec<Undone>,
    saved: String,
}

/// The change of one key.
#[derive(Clone, Copy, Debug)]
struct Done {
    /// The number of edits of the text; 0 if it created the program.
    changes: usize,
    /// The cursor before.
    cursor: usize,
}

/// An undone change.
#[derive(Clone, Debug)]
struct Undone {
    /// The number of edits of the text.
    changes: usize,
    /// The program, if the change had created it.
    begun: Option<ProgramDocument>,
    /// The cursor before.
    cursor: usize,
}

/// The part of a program to run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Part {
    /// The whole program, with its own repetitions.
    All,
    /// The whole program, until a person ends it.
    Loop,
    /// From the selected step on.
    FromHere,
}

impl Lesson {
    /// Creates a new program.
    pub(crate) const fn new(title: String) -> Self {
        Self {
            title,
            document: None,
            cursor: 0,
            done: Vec::new(),
            undone: Vec::new(),
            saved: String::new(),
        }
    }

    /// Reads a program; new steps are added after its last one.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] if the text is not a program or cannot be edited.
    pub(crate) fn of_text(text: &str) -> Result<Self, ProgramError> {
        let document = ProgramDocument::new(text)?;
        Ok(Self {
            cursor: document.steps().saturating_sub(1),
            saved: document.text(),
            document: Some(document),
            ..Self::new(String::new())
        })
    }

    /// The current text; empty before the first point.
    pub(crate) fn text(&self) -> String {
        self.document
            .as_ref()
            .map_or_else(String::new, ProgramDocument::text)
    }

    /// Whether the program has unsaved changes.
    pub(crate) fn is_changed(&self) -> bool {
        self.text() != self.saved
    }

    /// Handles that a text was saved.
    pub(crate) fn handle_saved(&mut self, text: String) {
        self.saved = text;
    }

    /// The steps, one line each, as in the text.
    pub(crate) fn lines(&self) -> Vec<String> {
        let steps = self.steps();
        steps.0.iter().map(|step| line(step.get_ref())).collect()
    }

    /// The selected step, after which new ones are added.
    pub(crate) const fn cursor(&self) -> usize {
        self.cursor
    }

    /// Selects the previous or next step.
    pub(crate) fn move_cursor(&mut self, down: bool) {
        let last = self.count().saturating_sub(1);
        self.cursor = if down {
            (self.cursor + 1).min(last)
        } else {
            self.cursor.saturating_sub(1)
        };
    }

    /// Adds the current position as a point with a step that moves there. Returns the name of the point.
    pub(crate) fn capture(
        &mut self,
        place: &RecordedPlace,
        path: MovingMode,
    ) -> Result<String, ProgramError> {
        let name = self.free_name();
        let go = Go {
            path,
            then: self.changed_tool(place),
            ..Go::to(name.as_str())
        };
        if self.document.is_none() {
            let points = BTreeMap::from([(name.clone(), place.point())]);
            self.begin(points, vec![Action::Go(go)])?;
            return Ok(name);
        }
        self.change(|document, at| {
            document.set_point(&name, &place.point())?;
            document.insert(at, Action::Go(go))?;
            Ok(Edited {
                changes: 2,
                cursor: at,
            })
        })?;
        Ok(name)
    }

    /// Adds a jogged path as straight lines through its positions.
    pub(crate) fn add_path(&mut self, places: &[RecordedPlace]) -> Result<(), ProgramError> {
        let actions = path_steps(places, self.tool_before());
        if self.document.is_none() {
            return self.begin(BTreeMap::new(), actions);
        }
        self.change(|document, at| {
            let changes = actions.len();
            for (index, action) in actions.into_iter().enumerate() {
                document.insert(at + index, action)?;
            }
            Ok(Edited {
                changes,
                cursor: at + changes.saturating_sub(1),
            })
        })
    }

    /// Adds a switch of the pump, unless there is no point yet or the program has already switched it.
    /// Returns whether it was added.
    pub(crate) fn switch_suction(&mut self, on: bool) -> Result<bool, ProgramError> {
        if self.document.is_none() || self.tool_before().suction == on {
            return Ok(false);
        }
        let here = Here {
            suction: Some(on),
            gripper: None,
            pause: Some(GRIP_S),
        };
        self.insert(Action::Here(here)).map(|()| true)
    }

    /// Adds a pause.
    pub(crate) fn pause(&mut self) -> Result<(), ProgramError> {
        self.insert(Action::Here(WAIT))
    }

    /// Removes the selected step.
    pub(crate) fn remove(&mut self) -> Result<(), ProgramError> {
        let cursor = self.cursor;
        self.change(|document, _| {
            document.remove(cursor)?;
            Ok(Edited {
                changes: 1,
                cursor: cursor.min(document.steps().saturating_sub(1)),
            })
        })
    }

    /// Moves the selected step up or down.
    pub(crate) fn shift(&mut self, down: bool) -> Result<(), ProgramError> {
        let from = self.cursor;
        let to = if down {
            Some(from + 1)
        } else {
            from.checked_sub(1)
        };
        let Some(to) = to.filter(|index| *index < self.count()) else {
            return Ok(());
        };
        self.change(|document, _| {
            document.move_step(from, to)?;
            Ok(Edited {
                changes: 1,
                cursor: to,
            })
        })
    }

    /// Undoes the change of the last key; returns `false` if there is none.
    pub(crate) fn undo(&mut self) -> bool {
        let Some(done) = self.done.pop() else {
            return false;
        };
        let begun = self.document.take_if(|_| done.changes == 0);
        if let Some(document) = &mut self.document {
            for _ in 0..done.changes {
                document.undo();
            }
        }
        self.undone.push(Undone {
            changes: done.changes,
            begun,
            cursor: self.cursor,
        });
        self.cursor = done.cursor;
        true
    }

    /// Redoes the last undone change; returns `false` if there is none.
    pub(crate) fn redo(&mut self) -> bool {
        let Some(undone) = self.undone.pop() else {
            return false;
        };
        self.document = self.document.take().or(undone.begun);
        if let Some(document) = &mut self.document {
            for _ in 0..undone.changes {
                document.redo();
            }
        }
        self.done.push(Done {
            changes: undone.changes,
            cursor: self.cursor,
        });
        self.cursor = undone.cursor;
        true
    }

    /// Creates the job of a part of the program; `files` provides called programs and drawings. Selects a step that
    /// cannot be executed.
    ///
    /// # Errors
    ///
    /// The reason why it cannot be run, in one line.
    pub(crate) fn job(
        &mut self,
        part: Part,
        files: &mut dyn Files,
        arm: &PlannedFor,
    ) -> Result<NewJob, String> {
        let program = self.program().ok_or("the program has no step yet")?;
        let compiled = match part {
            Part::Loop => compile(&looped(program.clone()), arm, files)?,
            Part::All => compile(&program, arm, files)?,
            Part::FromHere => {
                let line = program
                    .steps
                    .0
                    .get(self.cursor)
                    .map(|step| program.line_of(step));
                let compiled = compile(&program, arm, files)?;
                let here = |step: &dobot_teach::CompiledStep| {
                    step.file.is_none() && Some(step.line) >= line
                };
                let step = compiled.steps.iter().position(here);
                let rest = step.and_then(|index| compiled.from_step(index));
                rest.ok_or("the program does nothing from this step on")?
            }
        };
        let report = check(&compiled, &arm.rules.policy, arm.model());
        if let Some(first) = report.problems.first() {
            let own = program.steps.0.iter();
            let mut lines = own.map(|step| program.line_of(step));
            if first.file.is_none()
                && let Some(at) = lines.rposition(|line| line <= first.line)
            {
                self.cursor = at;
            }
            return Err(problem_text(first, report.problems.len() - 1));
        }
        let mut job = compiled.job();
        if job.title.is_empty() {
            job.title.push_str("a taught program");
        }
        Ok(job)
    }

    fn program(&self) -> Option<Program> {
        self.document.as_ref()?.program().ok()
    }

    fn steps(&self) -> Steps {
        self.program()
            .map_or_else(Steps::default, |program| program.steps)
    }

    fn count(&self) -> usize {
        self.document.as_ref().map_or(0, ProgramDocument::steps)
    }

    fn begin(
        &mut self,
        points: BTreeMap<String, Point>,
        actions: Vec<Action>,
    ) -> Result<(), ProgramError> {
        let mut program = Program::new(actions.clone());
        program.title.clone_from(&self.title);
        if !points.is_empty() {
            // No step may name a point that does not exist yet.
            program.steps = Steps::new(vec![Action::Here(WAIT)]);
        }
        let mut document = ProgramDocument::new(&program.to_toml())?;
        for (name, point) in points {
            document.set_point(&name, &point)?;
        }
        let last = actions.len().saturating_sub(1);
        for (at, action) in actions.into_iter().enumerate() {
            if at < document.steps() {
                document.replace(at, action)?;
            } else {
                document.insert(at, action)?;
            }
        }
        self.document = Some(document);
        self.undone.clear();
        self.done.push(Done {
            changes: 0,
            cursor: 0,
        });
        self.cursor = last;
        Ok(())
    }

    fn insert(&mut self, action: Action) -> Result<(), ProgramError> {
        self.change(|document, at| {
            document.insert(at, action)?;
            Ok(Edited {
                changes: 1,
                cursor: at,
            })
        })
    }

    /// Edits the program after the cursor, as one change to undo.
    fn change(
        &mut self,
        edit: impl FnOnce(&mut ProgramDocument, usize) -> Result<Edited, ProgramError>,
    ) -> Result<(), ProgramError> {
        let next = (self.cursor + 1).min(self.count());
        let Some(document) = &mut self.document else {
            return Err(nothing_yet());
        };
        let mut edited = document.clone();
        let Edited { changes, cursor } = edit(&mut edited, next)?;
        *document = edited;
        self.undone.clear();
        self.done.push(Done {
            changes,
            cursor: self.cursor,
        });
        self.cursor = cursor;
        Ok(())
    }

    /// An unused name for a point.
    fn free_name(&self) -> String {
        let points = self
            .program()
            .map(|program| program.points)
            .unwrap_or_default();
        let names = (1..=points.len() + 1).map(|number| format!("p{number}"));
        let mut free = names.filter(|name| !points.contains_key(name));
        free.next().unwrap_or_default()
    }

    fn changed_tool(&self, place: &RecordedPlace) -> Here {
        self.tool_before().changes_to(place)
    }

    /// The state of the tool after the selected step.
    fn tool_before(&self) -> ToolState {
        let steps = self.steps();
        let until = (self.cursor + 1).min(steps.0.len());
        ToolState::behind(&steps.0[..until])
    }
}

/// The result of an edit: the number of edits of the text, and the new cursor.
struct Edited {
    changes: usize,
    cursor: usize,
}

/// Repeats a whole program forever.
fn looped(mut program: Program) -> Program {
    let repeats = |action: &Action| matches!(action, Action::Repeat(Times::Forever, _));
    if !program
        .steps
        .0
        .last()
        .is_some_and(|step| repeats(step.get_ref()))
    {
        let steps = std::mem::take(&mut program.steps);
        program.steps = Steps::new(vec![Action::Repeat(Times::Forever, steps)]);
    }
    program
}

/// Formats the first problem and the number of others.
fn problem_text(first: &Problem, more: usize) -> String {
    let Problem {
        step,
        message,
        remedy,
        ..
    } = first;
    let text = format!("step {step}: {message}; {remedy}");
    match more {
        0 => text,
        more => format!("{text} (and {more} more: `dobot check` lists them)"),
    }
}

fn compile(program: &Program, arm: &PlannedFor, files: &mut dyn Files) -> Result<Compiled, String> {
    let compiled = program.compile_for(&arm.arm(), files);
    compiled.map_err(|error| error.to_string())
}

fn nothing_yet() -> ProgramError {
    ProgramError::new("the program has no step yet; add a point first")
}

/// `go = "p1", path = "movl"`
fn line(action: &Action) -> String {
    let text = Program::new(vec![action.clone()]).to_toml();
    let lines = text.lines().map(str::trim);
    let lines: Vec<&str> = lines
        .filter(|line| !line.is_empty() && *line != "[[steps]]")
        .collect();
    lines.join(", ")
}

/// The pause after switching the pump, in seconds.
const GRIP_S: f64 = 0.5;
const WAIT: Here = Here {
    suction: None,
    gripper: None,
    pause: Some(GRIP_S),
};

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "tests")]
mod tests {
    use dobot_teach::NoFiles;
    use dobot_wire::Command;

    use dobot_host::Rules;
    use dobot_safety::Policy;

    use super::*;

    fn place(x: f64, suction: bool) -> RecordedPlace {
        RecordedPlace {
            point_mm: [x, 0.0, 10.0],
            rotation_deg: 0.0,
            suction,
            gripper_deg: 0.0,
        }
    }

    /// A pick at 200, a place at 250.
    fn pick_and_place() -> Lesson {
        let mut it = Lesson::new("cubes".into());
        it.capture(&place(200.0, false), MovingMode::Jump).unwrap();
        assert!(it.switch_suction(true).unwrap());
        it.capture(&place(250.0, true), MovingMode::Jump).unwrap();
        assert!(it.switch_suction(false).unwrap());
        it
    }

    fn any_arm() -> PlannedFor {
        PlannedFor::any(Rules::of(&Policy::default()).into(), None)
    }

    #[test]
    fn a_pick_and_place_is_taught_with_four_keys() {
        let it = pick_and_place();
        let program = Program::from_toml(&it.text()).unwrap();
        assert_eq!(program.title, "cubes");
        assert!(it.text().contains("p1 = { x = 200"), "{}", it.text());
        assert_eq!(program.points["p1"], Point::xyz(200.0, 0.0, 10.0));
        assert_eq!(program.points["p2"], Point::xyz(250.0, 0.0, 10.0));
        let lines = it.lines();
        assert_eq!(lines.len(), 4, "{lines:?}");
        assert!(lines[0].contains("go = \"p1\""), "{lines:?}");
        assert!(lines[1].contains("suction = true"), "{lines:?}");
        assert!(!lines[2].contains("suction"), "it is on already: {lines:?}");
        assert_eq!(it.cursor(), 3);
    }

    #[test]
    fn every_key_can_be_undone_down_to_the_empty_program() {
        let mut it = pick_and_place();
        it.shift(false).unwrap();
        it.remove().unwrap();
        it.add_path(&[place(260.0, true), place(270.0, true)])
            .unwrap();
        let mut texts = Vec::new();
        while it.undo() {
            texts.push((it.text(), it.cursor()));
        }
        assert_eq!(texts.len(), 7);
        assert_eq!(texts.last(), Some(&(String::new(), 0)));
        assert_eq!(texts[2].0, pick_and_place().text());
    }

    #[test]
    fn a_step_is_put_behind_the_cursor_and_moved_with_it() {
        let mut it = pick_and_place();
        it.move_cursor(false);
        it.move_cursor(false);
        it.capture(&place(220.0, true), MovingMode::MovL).unwrap();
        assert_eq!(it.cursor(), 2);
        assert!(it.lines()[2].contains("p3"), "{:?}", it.lines());
        it.shift(true).unwrap();
        assert_eq!(it.cursor(), 3);
        assert!(it.lines()[3].contains("p3"), "{:?}", it.lines());
    }

    #[test]
    fn the_pump_is_not_taught_twice_nor_before_the_first_point() {
        let mut it = Lesson::new(String::new());
        assert!(!it.switch_suction(true).unwrap());
        it.capture(&place(200.0, true), MovingMode::Jump).unwrap();
        assert!(it.lines()[0].contains("suction = true"), "{:?}", it.lines());
        assert!(!it.switch_suction(true).unwrap());
    }

    #[test]
    fn a_program_goes_on_where_it_was_and_keeps_its_comments() {
        let text = "# mine\n[points]\np1 = { x = 200, y = 0, z = 0 } # the pick\n\n[[steps]]\ngo = \"p1\"\n";
        let mut it = Lesson::of_text(text).unwrap();
        assert!(!it.is_changed());
        assert_eq!(
            it.capture(&place(230.0, false), MovingMode::MovJ).unwrap(),
            "p2"
        );
        assert!(it.is_changed());
        let now = it.text();
        assert!(
            now.contains("# mine") && now.contains("# the pick"),
            "{now}"
        );
        it.handle_saved(now);
        assert!(!it.is_changed());
    }

    fn targets(job: &NewJob) -> Vec<f32> {
        let x = |it: &Command| match it {
            Command::MoveTo(it) => Some(it.x_mm),
            _ => None,
        };
        job.commands.iter().filter_map(x).collect()
    }

    #[test]
    fn a_part_of_the_program_is_run_from_the_cursor_on() {
        let mut it = pick_and_place();
        it.move_cursor(false);
        let rest = it.job(Part::FromHere, &mut NoFiles, &any_arm()).unwrap();
        assert_eq!(targets(&rest).first(), Some(&250.0));
        let all = it.job(Part::All, &mut NoFiles, &any_arm()).unwrap();
        assert_eq!(targets(&all).first(), Some(&200.0));
        assert_eq!(all.program.repeat, None);
        let looped = it.job(Part::Loop, &mut NoFiles, &any_arm()).unwrap();
        assert_eq!(looped.program.repeat.map(|it| it.times), Some(None));
        assert!(
            Lesson::new(String::new())
                .job(Part::All, &mut NoFiles, &any_arm(),)
                .is_err()
        );
    }

    #[test]
    fn what_was_undone_is_made_again_until_something_else_is_taught() {
        let mut it = Lesson::new("t".into());
        assert!(!it.redo());
        it.capture(&place(200.0, false), MovingMode::Jump).unwrap();
        it.capture(&place(210.0, true), MovingMode::MovL).unwrap();
        let (text, cursor) = (it.text(), it.cursor());
        while it.undo() {}
        assert_eq!(it.text(), "");
        while it.redo() {}
        assert_eq!((it.text(), it.cursor()), (text.clone(), cursor));
        while it.undo() {}
        it.capture(&place(220.0, false), MovingMode::Jump).unwrap();
        assert!(!it.redo());
        assert_ne!(it.text(), text);
    }

    #[test]
    fn a_step_that_cannot_be_done_is_told_before_anything_runs_and_the_cursor_goes_there() {
        let mut it = Lesson::new("t".into());
        for x in [200.0, 900.0, 210.0] {
            it.capture(&place(x, false), MovingMode::MovL).unwrap();
        }
        let arm = any_arm();
        for part in [Part::All, Part::Loop] {
            it.move_cursor(true);
            let why = it.job(part, &mut NoFiles, &arm).unwrap_err();
            assert!(why.starts_with("step 2: "), "{why}");
            assert_eq!(it.cursor(), 1);
        }
    }
}
