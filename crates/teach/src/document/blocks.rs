//! Edits of `repeat` and `each`.

use toml_edit::{Array, ArrayOfTables, Item, value};

use super::layout::table_of;
use super::{ProgramDocument, list, within};
use crate::{Action, Here, ProgramError, Steps, Times};

impl ProgramDocument {
    /// Puts a step and all that follow it in its list into a new `repeat`.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] if there is no such step.
    pub fn repeat(&mut self, from: &[usize], times: Times) -> Result<(), ProgramError> {
        // The step is replaced below: a repeat cannot be empty.
        let placeholder = Action::Here(Here::default());
        let mut table = table_of(Action::Repeat(times, Steps::new(vec![placeholder])))?;
        self.change(|steps| {
            let (steps, from) = list(steps, from)?;
            within(from, steps.len())?;
            table.insert("steps", Item::ArrayOfTables(split_off(steps, from)));
            steps.push(table);
            Ok(())
        })
    }

    /// Ends a `repeat` or an `each` after one of its steps: the steps that follow in it are moved out, after it.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] if there is no such step, or it is not inside another one.
    pub fn end_block(&mut self, last: &[usize]) -> Result<(), ProgramError> {
        let Some((_, block @ [_, ..])) = last.split_last() else {
            let reason = "the step is not inside a repeat or an each";
            return Err(ProgramError::new(reason));
        };
        self.change(|steps| {
            let (inner, last) = list(steps, last)?;
            within(last, inner.len())?;
            let rest = split_off(inner, last + 1);
            let (outer, at) = list(steps, block)?;
            for (index, table) in rest.into_iter().enumerate() {
                outer.insert(at + 1 + index, table);
            }
            Ok(())
        })
    }

    /// Sets the grids of an `each`.
    ///
    /// # Errors
    ///
    /// [`ProgramError`] if there is no such step, or a grid does not exist or has another number of cells.
    pub fn set_each(&mut self, at: &[usize], grids: &[String]) -> Result<(), ProgramError> {
        self.change(|steps| {
            let (steps, at) = list(steps, at)?;
            within(at, steps.len())?;
            if let Some(step) = steps.get_mut(at) {
                step["each"] = match grids {
                    [grid] => value(grid),
                    grids => value(Array::from_iter(grids)),
                };
            }
            Ok(())
        })
    }
}

/// Takes the steps from a number on out of a list.
fn split_off(steps: &mut ArrayOfTables, from: usize) -> ArrayOfTables {
    let mut rest = ArrayOfTables::new();
    while from < steps.len() {
        rest.push(steps.remove(from));
    }
    rest
}
