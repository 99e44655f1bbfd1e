//! Repeats in the program, and steps that move into and out of them.

use dobot_teach::{Action, Program, ProgramDocument, ProgramError, Times};
use toml::Spanned;

use super::{Edited, Lesson};
use crate::verbs::teach::outline::{RowKind, block_name, inner_steps, is_endless, outline};

impl Lesson {
    /// Begins a repeat after the cursor: around the steps that follow in the list, or if there are none, around the
    /// next step that is added. Returns whether there were some.
    pub(crate) fn begin_repeat(&mut self, times: Times) -> Result<bool, ProgramError> {
        let program = self.program();
        let at = self.next_path();
        check_endless(times, &at)?;
        if step_at(&program, &at).is_none() {
            self.begun = Some(times);
            return Ok(false);
        }
        self.change(|document| {
            document.repeat(&at, times)?;
            Ok(Edited::at(1, at))
        })?;
        Ok(true)
    }

    /// The repeat that begins with the next step.
    pub(crate) const fn begun(&self) -> Option<Times> {
        self.begun
    }

    /// Ends the repeat or the `each` around the selected step after this step; the steps that follow in it are moved
    /// after it. Returns its name.
    pub(crate) fn end_block(&mut self) -> Result<&'static str, ProgramError> {
        if self.begun.is_some() {
            return Err(ProgramError::new(
                "the repeat has no step yet; add its first one, or press z to drop it",
            ));
        }
        let program = self.program();
        let (kind, path) = self.selected();
        let block = enclosing_block(kind, &path)?;
        let action = step_at(&program, &block).ok_or_else(super::nothing_yet)?;
        if is_endless(action) {
            return Err(ProgramError::new(
                "an endless repeat is the last step of a program; nothing can follow it",
            ));
        }
        self.change(|document| {
            document.end_block(&path)?;
            Ok(Edited {
                changes: 1,
                path: block,
                is_end: true,
            })
        })?;
        Ok(block_name(action))
    }

    /// Removes the selected step, with the steps inside it.
    pub(crate) fn remove(&mut self) -> Result<(), ProgramError> {
        let (kind, path) = self.selected();
        check_removable(kind, self.document.is_some())?;
        let program = self.program();
        let outer = path.split_last().map(|(_, block)| block);
        if let Some(block) = outer.and_then(|block| step_at(&program, block))
            && inner_steps(block).is_some_and(|steps| steps.0.len() == 1)
        {
            let name = block_name(block);
            return Err(ProgramError::new(format!(
                "it is the only step of the {name}; remove the {name} itself"
            )));
        }
        let cursor = self.cursor;
        self.change(|document| {
            document.remove(&path)?;
            Ok(Edited::at(1, path))
        })?;
        self.cursor = cursor.min(outline(&self.program()).len() - 1);
        Ok(())
    }

    /// Moves the selected step up or down, also into and out of a repeat.
    pub(crate) fn shift(&mut self, down: bool) -> Result<(), ProgramError> {
        let (kind, path) = self.selected();
        if !matches!(kind, RowKind::Step | RowKind::Head) {
            return Ok(());
        }
        let Some(to) = shifted(&self.program(), &path, down) else {
            return Ok(());
        };
        self.change(|document: &mut ProgramDocument| {
            document.move_step(&path, &to)?;
            Ok(Edited::at(1, to))
        })
    }
}

/// Checks that an endless repeat is not inside another step.
pub(super) fn check_endless(times: Times, at: &[usize]) -> Result<(), ProgramError> {
    if times == Times::Forever && at.len() > 1 {
        return Err(ProgramError::new(
            "an endless repeat must be the last step of the program, not inside another one; enter a count, or press e first",
        ));
    }
    Ok(())
}

/// The step at a path.
pub(super) fn step_at<'a>(program: &'a Program, path: &[usize]) -> Option<&'a Action> {
    let (last, blocks) = path.split_last()?;
    let mut steps = &program.steps;
    for at in blocks {
        steps = inner_steps(steps.0.get(*at)?.get_ref())?;
    }
    steps.0.get(*last).map(Spanned::get_ref)
}

/// The path of a step one row further up or down, counted without the step; `None` at the end.
///
/// ```text
///   a                 a              a
///   repeat = 2        b              repeat = 2
///     b          up   repeat = 2       c         down
///     c               c              end
///   end               end            b
/// ```
fn shifted(program: &Program, path: &[usize], down: bool) -> Option<Vec<usize>> {
    let (at, block) = path.split_last()?;
    let beside = if down { at + 1 } else { at.wrapping_sub(1) };
    let sibling = [block, &[beside]].concat();
    match step_at(program, &sibling) {
        Some(action) => Some(match inner_steps(action) {
            // Its number without the moved step.
            Some(_) if down => [block, &[*at, 0]].concat(),
            Some(inner) => [block, &[beside, inner.0.len()]].concat(),
            None => sibling,
        }),
        None if block.is_empty() => None,
        None if down && is_endless(step_at(program, block)?) => None,
        None => {
            let (at, outer) = block.split_last()?;
            Some([outer, &[at + usize::from(down)]].concat())
        }
    }
}

/// Returns the path of the repeat or the `each` around a step.
fn enclosing_block(kind: RowKind, path: &[usize]) -> Result<Vec<usize>, ProgramError> {
    match (kind, path) {
        (RowKind::Head, _) => Err(ProgramError::new(
            "this is the beginning; select the last step of the repeat, and press e",
        )),
        (_, [block @ .., _]) if !block.is_empty() => Ok(block.to_vec()),
        _ => Err(ProgramError::new(
            "the selected step is not inside a repeat or an each; a begins one",
        )),
    }
}

fn check_removable(kind: RowKind, has_steps: bool) -> Result<(), ProgramError> {
    match kind {
        RowKind::Start if has_steps => {
            Err(ProgramError::new("no step is selected; , and . select one"))
        }
        RowKind::End => Err(ProgramError::new(
            "this is an end; to remove a repeat with its steps, select its beginning",
        )),
        _ => Ok(()),
    }
}
