//! The editor of program texts, which keeps comments.

mod blocks;
mod content;
mod layout;
mod names;

use toml_edit::{ArrayOfTables, DocumentMut, Item, Table};

use crate::plain::plain;
use crate::{Action, Program, ProgramError};

use self::layout::table_of;

pub use self::content::with_content;
pub(crate) use self::layout::on_lines;

/// A program text that is edited step by step; untouched parts keep their comments and their
/// formatting.
///
/// Each change can be undone; a change that would make the text invalid is refused.
///
/// A step is named by its path, counted from 0: `[2]` is the third step of the program, `[2, 0]` the
/// first one inside that step, which is a `repeat` or an `each`.
#[derive(Clone, Debug)]
pub struct ProgramDocument {
    document: DocumentMut,
    undone: Vec<DocumentMut>,
    before: Vec<DocumentMut>,
}

impl ProgramDocument {
    /// Starts to edit a text.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] if the text is not a program, or its steps are not written as `[[steps]]`.
    pub fn new(text: &str) -> Result<Self, ProgramError> {
        Program::from_toml(text)?;
        let document: DocumentMut = text
            .parse()
            .map_err(|error: toml_edit::TomlError| ProgramError::new(plain(error.message())))?;
        if document
            .get("steps")
            .and_then(Item::as_array_of_tables)
            .is_none()
        {
            return Err(ProgramError::new(
                "the steps are written as one array; to edit them, write each as [[steps]]",
            ));
        }
        Ok(Self {
            document,
            undone: Vec::new(),
            before: Vec::new(),
        })
    }

    /// Returns the current text.
    #[must_use]
    pub fn text(&self) -> String {
        self.document.to_string()
    }

    /// Returns the current program.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] never occurs for a text that only these operations have changed.
    pub fn program(&self) -> Result<Program, ProgramError> {
        Program::from_toml(&self.text())
    }

    /// The number of steps.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.document
            .get("steps")
            .and_then(Item::as_array_of_tables)
            .map_or(0, ArrayOfTables::len)
    }

    /// Inserts a step at a path, before the step that is there; the number of steps appends it.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] if the number is too large or the step uses an unknown name.
    pub fn insert(&mut self, at: &[usize], action: Action) -> Result<(), ProgramError> {
        let table = table_of(action)?;
        self.change(|steps| {
            let (steps, at) = list(steps, at)?;
            within(at, steps.len() + 1)?;
            steps.insert(at, table);
            Ok(())
        })
    }

    /// Replaces a step; the comment above it stays.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] if there is no such step or the new step uses an unknown name.
    pub fn replace(&mut self, at: &[usize], action: Action) -> Result<(), ProgramError> {
        let mut table = table_of(action)?;
        self.change(|steps| {
            let (steps, at) = list(steps, at)?;
            within(at, steps.len())?;
            if let Some(old) = steps.get(at) {
                *table.decor_mut() = old.decor().clone();
            }
            steps.replace(at, table);
            Ok(())
        })
    }

    /// Removes a step with the comment above it, and with the steps inside it.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] if there is no such step or it is the only one of its list.
    pub fn remove(&mut self, at: &[usize]) -> Result<(), ProgramError> {
        self.change(|steps| take_step(steps, at).map(drop))
    }

    /// Moves a step, with the comment above it, to another path, which is counted without the step.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] if one of the paths does not exist, or the step is the only one of its list.
    pub fn move_step(&mut self, from: &[usize], to: &[usize]) -> Result<(), ProgramError> {
        self.change(|steps| {
            let table = take_step(steps, from)?;
            let (steps, at) = list(steps, to)?;
            within(at, steps.len() + 1)?;
            steps.insert(at, table);
            Ok(())
        })
    }

    /// Undoes the last change; `false` if there is none.
    pub fn undo(&mut self) -> bool {
        let Some(before) = self.before.pop() else {
            return false;
        };
        self.undone
            .push(std::mem::replace(&mut self.document, before));
        true
    }

    /// Redoes the last undone change; `false` if there is none.
    pub fn redo(&mut self) -> bool {
        let Some(undone) = self.undone.pop() else {
            return false;
        };
        self.before
            .push(std::mem::replace(&mut self.document, undone));
        true
    }

    fn change(
        &mut self,
        edit: impl FnOnce(&mut ArrayOfTables) -> Result<(), ProgramError>,
    ) -> Result<(), ProgramError> {
        let mut new = self.document.clone();
        let steps = new.get_mut("steps").and_then(Item::as_array_of_tables_mut);
        let steps = steps.ok_or_else(|| ProgramError::new("the program has no [[steps]]"))?;
        edit(steps)?;
        // In the order of the list, whatever the order in the text was.
        steps.iter_mut().for_each(forget_position);
        self.take(new)
    }

    fn take(&mut self, new: DocumentMut) -> Result<(), ProgramError> {
        Program::from_toml(&new.to_string())?;
        self.before.push(std::mem::replace(&mut self.document, new));
        self.undone.clear();
        Ok(())
    }
}

fn forget_position(table: &mut Table) {
    table.set_position(None);
    for (_, item) in table.iter_mut() {
        match item {
            Item::Table(inner) => forget_position(inner),
            Item::ArrayOfTables(steps) => steps.iter_mut().for_each(forget_position),
            _ => {}
        }
    }
}

/// The list of steps that contains a path, and the number in it.
fn list<'a>(
    steps: &'a mut ArrayOfTables,
    path: &[usize],
) -> Result<(&'a mut ArrayOfTables, usize), ProgramError> {
    let Some((last, blocks)) = path.split_last() else {
        return Err(ProgramError::new("a path of a step has no number"));
    };
    let mut steps = steps;
    for at in blocks {
        within(*at, steps.len())?;
        let inner = steps.get_mut(*at).and_then(|step| step.get_mut("steps"));
        let inner = inner.and_then(Item::as_array_of_tables_mut);
        steps = inner.ok_or_else(|| {
            ProgramError::new(format!(
                "step {at} has no steps, or they are written as one array; to edit them, write each as [[steps.steps]]"
            ))
        })?;
    }
    Ok((steps, *last))
}

/// Takes a step out of its list.
fn take_step(steps: &mut ArrayOfTables, path: &[usize]) -> Result<Table, ProgramError> {
    let (steps, at) = list(steps, path)?;
    within(at, steps.len())?;
    Ok(steps.remove(at))
}

fn within(at: usize, count: usize) -> Result<(), ProgramError> {
    if at < count {
        return Ok(());
    }
    let most = count.saturating_sub(1);
    Err(ProgramError::new(format!(
        "step {at} does not exist; allowed are 0 to {most}"
    )))
}
