//! The program that is being taught.

mod blocks;
mod names;
mod run;

use dobot_teach::{
    Action, Go, Here, MountedTool, Program, ProgramDocument, ProgramError, RecordedPlace, Times,
    ToolState, path_steps,
};
use dobot_wire::MovingMode;

use super::outline::{Row, RowKind, outline};

pub(crate) use self::names::{GridUse, TouchedGrid};
pub(crate) use self::run::Part;

/// A program with a cursor and an undo history.
#[derive(Debug)]
pub(crate) struct Lesson {
    title: String,
    /// `None` before the first point: a program has at least one step.
    document: Option<ProgramDocument>,
    /// The selected row of the [`outline`].
    cursor: usize,
    /// A repeat that begins with the next step.
    begun: Option<Times>,
    /// The frame in which points are taught.
    frame: Option<String>,
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

impl Lesson {
    /// Creates a new program.
    pub(crate) const fn new(title: String) -> Self {
        Self {
            title,
            document: None,
            cursor: 0,
            begun: None,
            frame: None,
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
            cursor: outline(&document.program()?).len() - 1,
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

    /// The current program; without steps before the first point.
    pub(crate) fn program(&self) -> Program {
        let program = self.document.as_ref().map(ProgramDocument::program);
        program.and_then(Result::ok).unwrap_or_default()
    }

    /// Whether the program has unsaved changes.
    pub(crate) fn is_changed(&self) -> bool {
        self.text() != self.saved
    }

    /// Handles that a text was saved.
    pub(crate) fn handle_saved(&mut self, text: String) {
        self.saved = text;
    }

    /// The rows of the list, each with its number and its text.
    pub(crate) fn rows(&self) -> Vec<(String, String)> {
        let program = self.program();
        let rows = outline(&program);
        rows.iter().map(|row| (row.number(), row.text())).collect()
    }

    /// The selected row, after which new steps are added.
    pub(crate) const fn cursor(&self) -> usize {
        self.cursor
    }

    /// Selects the previous or next row.
    pub(crate) fn move_cursor(&mut self, down: bool) {
        let last = outline(&self.program()).len() - 1;
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
        let program = self.program();
        let tip = self.tip(place);
        let point = match self.frame() {
            Some(frame) => program.point_in(frame, &tip, self.mounted(&program))?,
            None => tip.point(),
        };
        let go = Go {
            path,
            then: self.changed_tool(place),
            ..Go::to(name.as_str())
        };
        self.add(vec![Action::Go(go)], |document| {
            document.set_point(&name, &point).map(|()| 1)
        })?;
        Ok(name)
    }

    /// Adds a jogged path as straight lines through its positions.
    pub(crate) fn add_path(&mut self, places: &[RecordedPlace]) -> Result<(), ProgramError> {
        let length_mm = self.length_mm();
        let tips: Vec<_> = places.iter().map(|place| place.tip(length_mm)).collect();
        self.add(path_steps(&tips, self.tool_before()), |_| Ok(0))
    }

    /// Adds a switch of the pump, unless there is no point yet or the program has already switched it.
    /// Returns whether it was added.
    pub(crate) fn switch_suction(&mut self, on: bool) -> Result<bool, ProgramError> {
        if self.document.is_none() || self.is_switched(on) {
            return Ok(false);
        }
        let here = Here {
            suction: Some(on),
            gripper: None,
            pause: Some(GRIP_S),
        };
        let added = self.add(vec![Action::Here(here)], |_| Ok(0));
        added.map(|()| true)
    }

    /// Adds a pause.
    pub(crate) fn pause(&mut self) -> Result<(), ProgramError> {
        if self.document.is_none() {
            return Err(nothing_yet());
        }
        self.add(vec![Action::Here(WAIT)], |_| Ok(0))
    }

    /// Undoes the change of the last key; returns `false` if there is none.
    pub(crate) fn undo(&mut self) -> bool {
        if self.begun.take().is_some() {
            return true;
        }
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

    /// The kind and the path of the selected row.
    fn selected(&self) -> (RowKind, Vec<usize>) {
        let program = self.program();
        let row = outline(&program).into_iter().nth(self.cursor);
        row.map_or((RowKind::Start, Vec::new()), |row| (row.kind, row.path))
    }

    /// The path at which the next step is inserted.
    fn next_path(&self) -> Vec<usize> {
        let program = self.program();
        let rows = outline(&program);
        rows.get(self.cursor).map_or_else(|| vec![0], Row::next)
    }

    /// Adds steps after the cursor and selects the last one; `names` first adds the names that they use, and returns
    /// the number of its edits. Puts them into the repeat that was begun.
    fn add(
        &mut self,
        actions: Vec<Action>,
        names: impl FnOnce(&mut ProgramDocument) -> Result<usize, ProgramError>,
    ) -> Result<(), ProgramError> {
        let at = self.next_path();
        if let Some(times) = self.begun {
            blocks::check_endless(times, &at)?;
        }
        let (mut document, is_new) = match &self.document {
            Some(document) => (document.clone(), false),
            None => (self.blank()?, true),
        };
        let mut changes = names(&mut document)?;
        let (mut path, mut last) = (at.clone(), at.clone());
        for action in actions {
            document.insert(&path, action)?;
            changes += 1;
            last.clone_from(&path);
            if let Some(index) = path.last_mut() {
                *index += 1;
            }
        }
        if is_new {
            document.remove(&path)?;
            changes = 0;
        }
        if let Some(times) = self.begun {
            document.repeat(&at, times)?;
            changes += usize::from(!is_new);
            last = inside(&at, &last);
        }
        self.begun = None;
        self.handle_changed(document, &Edited::at(changes, last));
        Ok(())
    }

    /// Edits the program, as one change to undo.
    fn change(
        &mut self,
        edit: impl FnOnce(&mut ProgramDocument) -> Result<Edited, ProgramError>,
    ) -> Result<(), ProgramError> {
        let Some(document) = &self.document else {
            return Err(nothing_yet());
        };
        let mut document = document.clone();
        let edited = edit(&mut document)?;
        self.handle_changed(document, &edited);
        Ok(())
    }

    fn handle_changed(&mut self, document: ProgramDocument, edited: &Edited) {
        self.document = Some(document);
        self.undone.clear();
        self.done.push(Done {
            changes: edited.changes,
            cursor: self.cursor,
        });
        let program = self.program();
        let mut rows = outline(&program).into_iter();
        let selected = rows.position(|row| {
            let is_end = row.kind == RowKind::End;
            row.path == edited.path && is_end == edited.is_end
        });
        self.cursor = selected.unwrap_or(self.cursor);
    }

    /// A program without points, whose only step is a placeholder: a text has at least one step.
    fn blank(&self) -> Result<ProgramDocument, ProgramError> {
        let mut program = Program::new(vec![Action::Here(WAIT)]);
        program.title.clone_from(&self.title);
        ProgramDocument::new(&program.to_toml())
    }

    /// An unused name for a point.
    fn free_name(&self) -> String {
        let Program { points, grids, .. } = self.program();
        let count = points.len() + grids.len();
        let names = (1..=count + 1).map(|number| format!("p{number}"));
        let mut free = names.filter(|name| !points.contains_key(name) && !grids.contains_key(name));
        free.next().unwrap_or_default()
    }

    fn changed_tool(&self, place: &RecordedPlace) -> Here {
        self.tool_before().changes_to(place)
    }

    /// Whether the pump is in this state after the selected row. In a repeat, only steps of the repeat count: its
    /// second cycle begins with the state of its end.
    fn is_switched(&self, on: bool) -> bool {
        let program = self.program();
        let at = self.next_path();
        let block = &at[..at.len() - 1];
        let rows = outline(&program).into_iter().take(self.cursor + 1);
        let inside = rows.filter(|row| row.kind == RowKind::Step && row.path.starts_with(block));
        let mut switched = inside.filter_map(|row| match row.step?.get_ref() {
            Action::Go(go) => go.then.suction,
            Action::Here(here) => here.suction,
            _ => None,
        });
        let is_new_block = self.begun.is_some();
        let at_start = (block.is_empty() && !is_new_block).then_some(false);
        let last = switched.next_back().filter(|_| !is_new_block);
        last.or(at_start) == Some(on)
    }

    /// The state of the tool after the selected row.
    fn tool_before(&self) -> ToolState {
        let program = self.program();
        let thens = self
            .actions_before(&program)
            .filter_map(|action| match action {
                Action::Go(go) => Some(go.then),
                Action::Here(here) => Some(*here),
                _ => None,
            });
        thens.fold(ToolState::default(), ToolState::after)
    }

    /// The place of the tip at a place of the wrist.
    fn tip(&self, place: &RecordedPlace) -> RecordedPlace {
        place.tip(self.length_mm())
    }

    /// The length of the tool that is mounted after the selected row.
    fn length_mm(&self) -> f64 {
        self.mounted(&self.program())
            .map_or(0.0, |tool| tool.length)
    }

    /// The tool that is mounted after the selected row.
    fn mounted<'a>(&self, program: &'a Program) -> Option<&'a MountedTool> {
        let tools = self
            .actions_before(program)
            .filter_map(|action| match action {
                Action::Tool(name) => program.tools.get(name),
                _ => None,
            });
        tools.last()
    }

    /// The steps up to the selected row, in the order of the text.
    fn actions_before<'a>(&self, program: &'a Program) -> impl Iterator<Item = &'a Action> {
        let rows = outline(program).into_iter().take(self.cursor + 1);
        let steps = rows.filter(|row| row.kind == RowKind::Step);
        steps.filter_map(|row| row.step.map(toml::Spanned::get_ref))
    }
}

/// The result of an edit.
struct Edited {
    /// The number of edits of the text.
    changes: usize,
    /// The path of the new cursor.
    path: Vec<usize>,
    /// Whether the cursor is at the end of the repeat at this path.
    is_end: bool,
}

impl Edited {
    /// Edits after which the cursor is on a step.
    const fn at(changes: usize, path: Vec<usize>) -> Self {
        Self {
            changes,
            path,
            is_end: false,
        }
    }

    /// One edit after which the cursor is where it was.
    fn on((kind, path): (RowKind, Vec<usize>)) -> Self {
        Self {
            changes: 1,
            path,
            is_end: kind == RowKind::End,
        }
    }
}

/// The path of a step after those from `at` on were put into a repeat.
fn inside(at: &[usize], path: &[usize]) -> Vec<usize> {
    let depth = at.len() - 1;
    let index = path[depth] - at[depth];
    [at, &[index], &path[depth + 1..]].concat()
}

fn nothing_yet() -> ProgramError {
    ProgramError::new("the program has no step yet; add a point first")
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
mod tests;
