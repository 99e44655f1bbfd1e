//! Edits of keep-outs in the text of a policy.

use schemars::JsonSchema;
use serde::Deserialize;
use toml_edit::{DocumentMut, Item, Table, TableLike, Value};

use crate::{Bounds, KeepOut, PolicyError};

/// An edit of a keep-out in the text of a policy.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
pub enum KeepOutEdit {
    /// Adds a keep-out under the first free name: `zone_1`, `zone_2` and so on.
    Add {
        /// The new keep-out.
        keep_out: KeepOut,
    },
    /// Replaces a keep-out.
    Replace {
        /// The name, which stays.
        name: String,
        /// The new keep-out.
        keep_out: KeepOut,
    },
    /// Removes a keep-out.
    Remove {
        /// The name.
        name: String,
    },
}

impl KeepOutEdit {
    /// Returns the policy text with this edit. Everything else stays as written, including
    /// comments.
    ///
    /// Only the syntax must be valid, not the values: a person may type bounds one after the other.
    ///
    /// # Errors
    ///
    /// [`PolicyError`] if the text is not TOML, no keep-out has the name, or a number is not
    /// finite.
    pub fn apply(&self, text: &str) -> Result<String, PolicyError> {
        let parsed: Result<DocumentMut, _> = text.parse();
        let mut document =
            parsed.map_err(|error| PolicyError::reader(text, error.span(), error.message()))?;
        let keep_outs = document
            .entry("keep_out")
            .or_insert_with(|| Item::Table(Table::new()))
            .as_table_like_mut()
            .ok_or_else(|| refused("keep_out is a value; a policy has a table there"))?;
        match self {
            Self::Add { keep_out } => add(keep_outs, keep_out)?,
            Self::Replace { name, keep_out } => replace(keep_outs, name, keep_out)?,
            Self::Remove { name } => {
                named(keep_outs, name)?;
                keep_outs.remove(name);
            }
        }
        Ok(document.to_string())
    }
}

fn add(keep_outs: &mut dyn TableLike, keep_out: &KeepOut) -> Result<(), PolicyError> {
    let mut number = 1;
    while keep_outs.contains_key(&format!("zone_{number}")) {
        number += 1;
    }
    keep_outs.insert(&format!("zone_{number}"), Item::Value(inline(keep_out)?));
    Ok(())
}

fn replace(
    keep_outs: &mut dyn TableLike,
    name: &str,
    keep_out: &KeepOut,
) -> Result<(), PolicyError> {
    let mut new = inline(keep_out)?;
    match named(keep_outs, name)? {
        Item::Value(old) => {
            *new.decor_mut() = old.decor().clone();
            *old = new;
        }
        old => *old = Item::Value(new),
    }
    Ok(())
}

fn named<'a>(keep_outs: &'a mut dyn TableLike, name: &str) -> Result<&'a mut Item, PolicyError> {
    let names: Vec<String> = keep_outs.iter().map(|(name, _)| name.to_owned()).collect();
    keep_outs.get_mut(name).ok_or_else(|| {
        let there = if names.is_empty() {
            "there are none".to_owned()
        } else {
            format!("there are {}", names.join(", "))
        };
        refused(&format!("no keep-out is called {name:?}; {there}"))
    })
}

/// Formats a keep-out on one line of a file.
fn inline(keep_out: &KeepOut) -> Result<Value, PolicyError> {
    let range = |Bounds { min, max }: Bounds| format!("[{min}, {max}]");
    let text = match keep_out {
        KeepOut::Box(area) => {
            let [x, y, z] = area.axes().map(range);
            format!("{{ box = {{ x_mm = {x}, y_mm = {y}, z_mm = {z} }} }}")
        }
        KeepOut::Cylinder(cylinder) => format!(
            "{{ cylinder = {{ x_mm = {}, y_mm = {}, radius_mm = {}, z_mm = {} }} }}",
            cylinder.x_mm,
            cylinder.y_mm,
            cylinder.radius_mm,
            range(cylinder.z_mm)
        ),
    };
    text.parse()
        .map_err(|_| refused(&format!("{text} has a number that is not finite")))
}

fn refused(reason: &str) -> PolicyError {
    PolicyError {
        line: None,
        reason: reason.to_owned(),
    }
}
