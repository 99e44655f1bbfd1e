//! The editor of program texts, which keeps comments.

use toml_edit::{ArrayOfTables, DocumentMut, Item, Table, value};

use crate::plain::plain;
use crate::{Action, Point, Program, ProgramError, Steps};

/// A program text that is edited step by step; untouched parts keep their comments and their
/// formatting.
///
/// Each change can be undone; a change that would make the text invalid is refused. Steps are those
/// of the program itself, counted from 0; steps inside `repeat` and `each` move with their outer
/// step.
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

    /// Inserts a step before the step with this number; the number of steps appends it.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] if the number is too large or the step uses an unknown name.
    pub fn insert(&mut self, at: usize, action: Action) -> Result<(), ProgramError> {
        let table = table_of(action)?;
        self.change(|steps| {
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
    pub fn replace(&mut self, at: usize, action: Action) -> Result<(), ProgramError> {
        let mut table = table_of(action)?;
        self.change(|steps| {
            within(at, steps.len())?;
            if let Some(old) = steps.get(at) {
                *table.decor_mut() = old.decor().clone();
            }
            steps.replace(at, table);
            Ok(())
        })
    }

    /// Removes a step with the comment above it.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] if there is no such step or it is the only one.
    pub fn remove(&mut self, at: usize) -> Result<(), ProgramError> {
        self.change(|steps| {
            within(at, steps.len())?;
            steps.remove(at);
            Ok(())
        })
    }

    /// Moves a step, with the comment above it, to another number.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] if one of the steps does not exist.
    pub fn move_step(&mut self, from: usize, to: usize) -> Result<(), ProgramError> {
        self.change(|steps| {
            within(from.max(to), steps.len())?;
            let table = steps.remove(from);
            steps.insert(to, table);
            Ok(())
        })
    }

    /// Sets a named point or adds it.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] if the frame of the point does not exist.
    pub fn set_point(&mut self, name: &str, point: &Point) -> Result<(), ProgramError> {
        let mut new = self.document.clone();
        let fields = toml_edit::ser::to_document(point)
            .map_err(|error| ProgramError::new(plain(&error.to_string())))?;
        let had_points = new.contains_key("points");
        let points = new.entry("points").or_insert_with(|| {
            let mut table = Table::new();
            table.set_implicit(true);
            // After the title, before the existing tables.
            table.set_position(Some(0));
            Item::Table(table)
        });
        let points = points
            .as_table_like_mut()
            .ok_or_else(|| ProgramError::new("points is not a table"))?;
        let mut inline = fields.as_table().clone().into_inline_table();
        inline.fmt();
        match points.get_mut(name).and_then(Item::as_table_like_mut) {
            Some(old) => {
                let keys: Vec<String> = old.iter().map(|(key, _)| key.to_owned()).collect();
                for key in keys.iter().filter(|key| !inline.contains_key(key)) {
                    old.remove(key);
                }
                for (key, field) in &inline {
                    old.insert(key, value(field.clone()));
                }
            }
            None => {
                points.insert(name, value(inline));
            }
        }
        if !had_points && let Some(table) = new["points"].as_table_mut() {
            table.set_implicit(false);
        }
        self.take(new)
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

/// Formats a program or steps for people: each step is a table with one key per line, `go` first; a
/// point, a tool, a frame or a grid is on one line.
pub(crate) fn on_lines(program: &impl serde::Serialize) -> Result<DocumentMut, String> {
    let text = toml::to_string(program).map_err(|error| plain(&error.to_string()))?;
    let document = text.parse();
    let mut document: DocumentMut =
        document.map_err(|error: toml_edit::TomlError| plain(error.message()))?;
    for (_, item) in document.iter_mut() {
        match item {
            Item::Table(names) => inline(names),
            Item::ArrayOfTables(steps) => steps.iter_mut().for_each(inline),
            _ => {}
        }
    }
    Ok(document)
}

/// A step as the table of a text.
fn table_of(action: Action) -> Result<Table, ProgramError> {
    #[derive(serde::Serialize)]
    struct One {
        steps: Steps,
    }
    let one = One {
        steps: Steps::new(vec![action]),
    };
    let document = on_lines(&one).map_err(ProgramError::new)?;
    let steps = document.get("steps").and_then(Item::as_array_of_tables);
    let mut table = steps
        .and_then(|steps| steps.get(0))
        .cloned()
        .ok_or_else(|| ProgramError::new("the step cannot be written as text"))?;
    table.decor_mut().set_prefix("\n");
    Ok(table)
}

/// Puts inner tables that are not steps on one line.
fn inline(table: &mut Table) {
    for (_, item) in table.iter_mut() {
        if let Item::Table(inner) = item {
            let mut line = std::mem::take(inner).into_inline_table();
            line.fmt();
            *item = value(line);
        } else if let Item::ArrayOfTables(steps) = item {
            steps.iter_mut().for_each(inline);
        }
    }
    table.sort_values_by(|a, _, b, _| (a != "go").cmp(&(b != "go")));
    table.set_implicit(false);
    table.fmt();
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

fn within(at: usize, count: usize) -> Result<(), ProgramError> {
    if at < count {
        return Ok(());
    }
    let most = count.saturating_sub(1);
    Err(ProgramError::new(format!(
        "step {at} does not exist; allowed are 0 to {most}"
    )))
}
