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
mod tests {
    use dobot_teach::NoFiles;
    use dobot_wire::Command;

    use dobot_api::NewJob;
    use dobot_arm::Tool;
    use dobot_host::{PlannedFor, Rules};
    use dobot_safety::Policy;
    use dobot_teach::{GridSize, Point};

    use super::*;

    fn place(x: f64, suction: bool) -> RecordedPlace {
        RecordedPlace {
            point_mm: [x, 0.0, 10.0],
            rotation_deg: 0.0,
            suction,
            gripper_deg: 0.0,
        }
    }

    /// The texts of the rows after the start.
    fn lines(it: &Lesson) -> Vec<String> {
        let rows = it.rows().into_iter().skip(1);
        rows.map(|(_, text)| text).collect()
    }

    /// The x of the targets of a run.
    fn run(it: &mut Lesson) -> Vec<f32> {
        let job = it.job(Part::All, &mut NoFiles, &any_arm()).unwrap();
        targets(&job)
    }

    fn capture(it: &mut Lesson, x: f64) {
        it.capture(&place(x, false), MovingMode::Jump).unwrap();
    }

    /// Selects a row by a part of its text.
    fn select(it: &mut Lesson, part: &str) {
        let at = it.rows().iter().position(|row| row.1.contains(part));
        let at = at.unwrap_or_else(|| panic!("{part} is missing: {:?}", it.rows()));
        while it.cursor() > at {
            it.move_cursor(false);
        }
        while it.cursor() < at {
            it.move_cursor(true);
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
        let lines = lines(&it);
        assert_eq!(lines.len(), 4, "{lines:?}");
        assert!(lines[0].contains("go = \"p1\""), "{lines:?}");
        assert!(lines[1].contains("suction = true"), "{lines:?}");
        assert!(!lines[2].contains("suction"), "it is on already: {lines:?}");
        assert_eq!(it.cursor(), 4);
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
        assert_eq!(it.cursor(), 3);
        assert!(lines(&it)[2].contains("p3"), "{:?}", lines(&it));
        it.shift(true).unwrap();
        assert_eq!(it.cursor(), 4);
        assert!(lines(&it)[3].contains("p3"), "{:?}", lines(&it));
    }

    #[test]
    fn the_pump_is_not_taught_twice_nor_before_the_first_point() {
        let mut it = Lesson::new(String::new());
        assert!(!it.switch_suction(true).unwrap());
        it.capture(&place(200.0, true), MovingMode::Jump).unwrap();
        assert!(lines(&it)[0].contains("suction = true"), "{:?}", lines(&it));
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
    fn an_impossible_step_is_reported_before_anything_runs_and_the_cursor_moves_to_it() {
        let mut it = Lesson::new("t".into());
        for x in [200.0, 900.0, 210.0] {
            it.capture(&place(x, false), MovingMode::MovL).unwrap();
        }
        let arm = any_arm();
        for part in [Part::All, Part::Loop] {
            it.move_cursor(true);
            let why = it.job(part, &mut NoFiles, &arm).unwrap_err();
            assert!(why.starts_with("step 2: "), "{why}");
            assert_eq!(it.cursor(), 2);
        }
    }

    #[test]
    fn a_step_is_added_before_the_first_one_from_the_start() {
        let mut it = pick_and_place();
        select(&mut it, "start");
        capture(&mut it, 180.0);
        assert_eq!(run(&mut it)[..2], [180.0, 200.0]);
        assert_eq!(it.cursor(), 1);
    }

    #[test]
    fn a_point_is_named_also_after_the_pump_was_switched() {
        let mut it = pick_and_place();
        let last = it.last_point().unwrap();
        it.rename_point(&last, "tray").unwrap();
        assert!(lines(&it)[2].contains("go = \"tray\""), "{:?}", lines(&it));
        assert_eq!(it.cursor(), 4, "the cursor stays");
        assert!(it.text().contains("tray = { x = 250"), "{}", it.text());
        let error = it.rename_point("tray", "p1").unwrap_err().to_string();
        assert!(error.contains("already a point"), "{error}");
        assert!(it.undo());
        assert_eq!(it.text(), pick_and_place().text());
    }

    #[test]
    fn a_repeat_begins_with_the_next_step_and_ends_after_the_selected_one() {
        let mut it = Lesson::new("t".into());
        capture(&mut it, 200.0);
        assert!(!it.begin_repeat(Times::Count(3)).unwrap());
        assert!(it.end_block().is_err(), "it has no step");
        capture(&mut it, 210.0);
        capture(&mut it, 220.0);
        assert_eq!(it.end_block().unwrap(), "repeat");
        capture(&mut it, 230.0);
        let expected = [
            "go = \"p1\"",
            "repeat = 3",
            "  go = \"p2\"",
            "  go = \"p3\"",
            "end of repeat",
            "go = \"p4\"",
        ];
        assert_eq!(lines(&it), expected);
        let cycle = [210.0, 220.0];
        let all = [&[200.0][..], &cycle, &cycle, &cycle, &[230.0]].concat();
        assert_eq!(run(&mut it), all);
    }

    #[test]
    fn a_repeat_is_put_around_steps_that_were_taught() {
        let mut it = Lesson::new("t".into());
        for x in [200.0, 210.0, 220.0, 230.0] {
            capture(&mut it, x);
        }
        select(&mut it, "p1");
        assert!(it.begin_repeat(Times::Count(2)).unwrap());
        select(&mut it, "p3");
        it.end_block().unwrap();
        assert_eq!(run(&mut it), [200.0, 210.0, 220.0, 210.0, 220.0, 230.0]);
        select(&mut it, "repeat = 2");
        it.shift(true).unwrap();
        // A repeat at the end is not expanded.
        assert_eq!(run(&mut it), [200.0, 230.0, 210.0, 220.0]);
        while it.undo() {}
        assert_eq!(it.text(), "");
    }

    #[test]
    fn the_first_step_of_a_program_may_be_in_a_repeat() {
        let mut it = Lesson::new("t".into());
        it.begin_repeat(Times::Count(2)).unwrap();
        capture(&mut it, 200.0);
        assert!(it.undo());
        assert_eq!(it.text(), "");
        assert!(it.redo());
        assert_eq!(lines(&it), ["repeat = 2", "  go = \"p1\"", "end of repeat"]);
        it.begin_repeat(Times::Count(5)).unwrap();
        assert!(it.undo(), "a repeat without a step is dropped");
        assert_eq!(it.begun(), None);
        assert_eq!(lines(&it).len(), 3);
    }

    #[test]
    fn steps_move_into_a_repeat_and_out_of_it() {
        let mut it = Lesson::new("t".into());
        for x in [200.0, 210.0, 220.0] {
            capture(&mut it, x);
        }
        select(&mut it, "p2");
        it.begin_repeat(Times::Count(2)).unwrap();
        select(&mut it, "p2");
        let mut seen = Vec::new();
        for down in [true, true, true, false, false, false] {
            it.shift(down).unwrap();
            let position = lines(&it).iter().position(|line| line.contains("p2"));
            assert_eq!(position.map(|row| row + 1), Some(it.cursor()));
            seen.push(position);
        }
        let expected = [2, 3, 4, 3, 2, 1].map(Some);
        assert_eq!(seen, expected);
        select(&mut it, "p3");
        let error = it.remove().unwrap_err().to_string();
        assert!(error.contains("only step of the repeat"), "{error}");
        select(&mut it, "repeat");
        it.remove().unwrap();
        assert_eq!(lines(&it).len(), 2);
    }

    #[test]
    fn an_endless_repeat_is_the_last_step_of_a_program() {
        let mut it = Lesson::new("t".into());
        it.begin_repeat(Times::Forever).unwrap();
        capture(&mut it, 200.0);
        let error = it.end_block().unwrap_err().to_string();
        assert!(error.contains("nothing can follow"), "{error}");
        let error = it.begin_repeat(Times::Forever).unwrap_err().to_string();
        assert!(error.contains("enter a count"), "{error}");
        assert_eq!(lines(&it), ["repeat = \"forever\"", "  go = \"p1\""]);
        let job = it.job(Part::All, &mut NoFiles, &any_arm()).unwrap();
        assert_eq!(job.program.repeat.map(|repeat| repeat.times), Some(None));
    }

    #[test]
    fn the_pump_is_switched_in_every_cycle_of_a_repeat() {
        let mut it = Lesson::new("t".into());
        capture(&mut it, 200.0);
        assert!(it.switch_suction(true).unwrap());
        it.begin_repeat(Times::Count(2)).unwrap();
        assert!(
            it.switch_suction(true).unwrap(),
            "it may be off in the second cycle"
        );
        assert!(!it.switch_suction(true).unwrap());
        assert!(it.switch_suction(false).unwrap());
    }

    #[test]
    fn points_after_a_tool_are_those_of_its_tip() {
        let mut it = Lesson::new("t".into());
        let tool = MountedTool {
            kind: Tool::Gripper,
            length: 40.0,
        };
        assert!(!it.add_tool(tool).unwrap());
        capture(&mut it, 200.0);
        it.add_path(&[place(210.0, false), place(220.0, false)])
            .unwrap();
        assert_eq!(it.program().points["p1"], Point::xyz(200.0, 0.0, -30.0));
        assert!(
            it.text()
                .contains("gripper = { kind = \"gripper\", length = 40.0 }"),
            "{}",
            it.text()
        );
        let job = it.job(Part::All, &mut NoFiles, &any_arm()).unwrap();
        let heights = job.commands.iter().filter_map(|command| match command {
            Command::MoveTo(target) => Some(target.z_mm),
            _ => None,
        });
        assert_eq!(
            heights.collect::<Vec<_>>(),
            [10.0; 3],
            "the wrist goes where it was"
        );
        // Another length for points that were taught already.
        select(&mut it, "start");
        let longer = MountedTool {
            length: 60.0,
            ..tool
        };
        assert!(it.add_tool(longer).unwrap());
        assert!(lines(&it)[0].contains("gripper2"), "{:?}", lines(&it));
    }

    fn corner(x: f64, y: f64) -> RecordedPlace {
        RecordedPlace {
            point_mm: [x, y, 10.0],
            ..place(0.0, false)
        }
    }

    fn tray(name: &str, columns: u32, y: f64) -> TouchedGrid {
        TouchedGrid {
            name: name.to_owned(),
            corners: [corner(200.0, y), corner(220.0, y), corner(200.0, y + 30.0)],
            size: GridSize {
                columns,
                rows: 2,
                layers: 1,
                layer_mm: 0.0,
            },
        }
    }

    #[test]
    fn a_grid_is_visited_cell_by_cell_and_what_is_taught_next_belongs_to_each_cell() {
        let mut it = Lesson::new("t".into());
        let (used, corner_deg) = it
            .add_grid(&tray("from", 2, 0.0), MovingMode::Jump)
            .unwrap();
        assert_eq!(used, GridUse::Visited);
        assert!((corner_deg - 90.0).abs() < 1e-9, "{corner_deg}");
        it.switch_suction(true).unwrap();
        let error = it
            .add_grid(&tray("to", 3, -60.0), MovingMode::Jump)
            .unwrap_err();
        assert!(error.to_string().contains("6 cells"), "{error}");
        let joined = it
            .add_grid(&tray("to", 2, -60.0), MovingMode::Jump)
            .unwrap();
        assert_eq!(joined.0, GridUse::Joined);
        let lines = lines(&it);
        assert_eq!(lines[0], "each = [\"from\", \"to\"]");
        assert_eq!(lines[3], "  go = \"to\"");
        assert_eq!(
            run(&mut it),
            [
                200.0, 200.0, 200.0, 220.0, 220.0, 220.0, 200.0, 200.0, 200.0, 220.0, 220.0, 220.0
            ]
        );
        while it.undo() {}
        assert_eq!(it.text(), "");
    }

    #[test]
    fn a_grid_that_is_taught_again_keeps_its_steps() {
        let mut it = Lesson::new("t".into());
        it.add_grid(&tray("tray", 2, 0.0), MovingMode::MovL)
            .unwrap();
        let before = (lines(&it), it.cursor());
        let mut moved = tray("tray", 2, 0.0);
        for corner in &mut moved.corners {
            corner.point_mm[0] += 50.0;
        }
        let (used, _) = it.add_grid(&moved, MovingMode::Jump).unwrap();
        assert_eq!(used, GridUse::TaughtAgain);
        assert_eq!((lines(&it), it.cursor()), before);
        assert_eq!(run(&mut it), [250.0, 270.0, 250.0, 270.0]);
    }

    #[test]
    fn points_are_taught_in_a_frame_until_another_one_is_chosen() {
        let mut it = Lesson::new("t".into());
        let points = [
            corner(200.0, 10.0),
            corner(200.0, 50.0),
            corner(150.0, 10.0),
        ];
        let error = it.set_frame("tray", &points).unwrap_err().to_string();
        assert!(error.contains("no step yet"), "{error}");
        capture(&mut it, 190.0);
        assert!(
            it.set_frame("tray", &points).unwrap(),
            "its z axis points up"
        );
        assert_eq!(it.frame(), Some("tray"));
        capture(&mut it, 210.0);
        it.use_frame(None);
        capture(&mut it, 220.0);
        assert!(
            it.text().contains(
                "p2 = { x = -10.0, y = -10.0, z = 0.0, rotation = -90.0, frame = \"tray\" }"
            ),
            "{}",
            it.text()
        );
        for (target, expected) in run(&mut it).into_iter().zip([190.0, 210.0, 220.0_f32]) {
            assert!(
                (target - expected).abs() < 0.01,
                "{target} instead of {expected}"
            );
        }
        let [origin, x, y] = points;
        assert!(
            !it.set_frame("down", &[origin, y, x]).unwrap(),
            "its z axis points down"
        );
        let error = it
            .set_frame("line", &[origin, x, x])
            .unwrap_err()
            .to_string();
        assert!(error.contains("on one line"), "{error}");
        assert_eq!(it.frame(), Some("down"));
        assert!(it.undo());
        assert_eq!(it.frame(), None, "the frame is gone");
    }
}
