//! Edits of the points, grids, frames and tools.

use serde::Serialize;
use toml_edit::{Item, Key, Table, TableLike, value};

use super::ProgramDocument;
use crate::plain::plain;
use crate::{Frame, Grid, MountedTool, Point, ProgramError};

impl ProgramDocument {
    /// Sets a named point or adds it.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] if the frame of the point does not exist.
    pub fn set_point(&mut self, name: &str, point: &Point) -> Result<(), ProgramError> {
        self.set("points", name, point)
    }

    /// Sets a named grid or adds it.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] if a number is out of range, the place of the first cell does not exist, or a point has the
    /// same name.
    pub fn set_grid(&mut self, name: &str, grid: &Grid) -> Result<(), ProgramError> {
        self.set("grids", name, grid)
    }

    /// Sets a named frame or adds it.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] if one of its places does not exist.
    pub fn set_frame(&mut self, name: &str, frame: &Frame) -> Result<(), ProgramError> {
        self.set("frames", name, frame)
    }

    /// Sets a named tool or adds it.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] if its length is out of range.
    pub fn set_tool(&mut self, name: &str, tool: &MountedTool) -> Result<(), ProgramError> {
        self.set("tools", name, tool)
    }

    /// Renames a point, also where steps, frames and grids use it.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] if there is no such point, or a point or a grid has the new name.
    pub fn rename_point(&mut self, from: &str, to: &str) -> Result<(), ProgramError> {
        let mut new = self.document.clone();
        let is_taken = |kind: &str| {
            let names = new.get(kind).and_then(Item::as_table_like);
            names.is_some_and(|names| names.contains_key(to))
        };
        if let Some(kind) = ["points", "grids"].into_iter().find(|kind| is_taken(kind)) {
            let kind = kind.trim_end_matches('s');
            return Err(ProgramError::new(format!(
                "there is already a {kind} {to:?}; names are unique: choose another one"
            )));
        }
        let points = new.get_mut("points").and_then(Item::as_table_like_mut);
        let points = points.filter(|points| points.contains_key(from));
        let points =
            points.ok_or_else(|| ProgramError::new(format!("there is no point {from:?}")))?;
        rename_key(points, from, to);
        for kind in ["steps", "frames", "grids"] {
            if let Some(item) = new.get_mut(kind) {
                rename_uses(item, from, to);
            }
        }
        self.take(new)
    }

    fn set(&mut self, kind: &str, name: &str, fields: &impl Serialize) -> Result<(), ProgramError> {
        let mut new = self.document.clone();
        let fields = toml_edit::ser::to_document(fields)
            .map_err(|error| ProgramError::new(plain(&error.to_string())))?;
        let mut fields = fields.as_table().clone().into_inline_table();
        for (_, field) in fields.iter_mut() {
            if let Some(inner) = field.as_inline_table_mut() {
                inner.fmt();
            }
        }
        fields.fmt();
        if !new.contains_key(kind) {
            // After the title, before the steps.
            let steps = new.remove("steps");
            let mut table = Table::new();
            table.set_position(Some(0));
            new.insert(kind, Item::Table(table));
            new.extend(steps.map(|steps| ("steps", steps)));
        }
        let names = new[kind].as_table_like_mut();
        let names = names.ok_or_else(|| ProgramError::new(format!("{kind} is not a table")))?;
        match names.get_mut(name).and_then(Item::as_table_like_mut) {
            Some(old) => {
                let keys: Vec<String> = old.iter().map(|(key, _)| key.to_owned()).collect();
                for key in keys.iter().filter(|key| !fields.contains_key(key)) {
                    old.remove(key);
                }
                for (key, field) in &fields {
                    old.insert(key, value(field.clone()));
                }
            }
            None => {
                names.insert(name, value(fields));
            }
        }
        self.take(new)
    }
}

/// Renames a key; the order and the comments stay.
fn rename_key(table: &mut dyn TableLike, from: &str, to: &str) {
    let keys: Vec<String> = table.iter().map(|(key, _)| key.to_owned()).collect();
    for key in keys {
        let decor = table.key(&key).map(|key| key.leaf_decor().clone());
        let Some(item) = table.remove(&key) else {
            continue;
        };
        let name = if key == from { to } else { &key };
        let key = Key::new(name).with_leaf_decor(decor.unwrap_or_default());
        table.entry_format(&key).or_insert(item);
    }
}

/// Renames a point where a step, a frame or a grid uses it.
fn rename_uses(item: &mut Item, from: &str, to: &str) {
    if let Some(tables) = item.as_array_of_tables_mut() {
        for table in tables.iter_mut() {
            rename_in(table, from, to);
        }
    } else if let Some(table) = item.as_table_like_mut() {
        rename_in(table, from, to);
    }
}

fn rename_in(table: &mut dyn TableLike, from: &str, to: &str) {
    for (key, item) in table.iter_mut() {
        if PLACES.contains(&key.get()) && item.as_str() == Some(from) {
            let decor = item.as_value().map(|value| value.decor().clone());
            *item = value(to);
            if let (Some(value), Some(decor)) = (item.as_value_mut(), decor) {
                *value.decor_mut() = decor;
            }
        } else if key != "drawing" {
            rename_uses(item, from, to);
        }
    }
}

/// The keys whose text is the name of a point.
const PLACES: [&str; 7] = ["go", "through", "to", "origin", "x", "y", "at"];
