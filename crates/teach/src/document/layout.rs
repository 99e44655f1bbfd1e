//! The layout of program texts.

use toml_edit::{DocumentMut, Item, Table, value};

use crate::plain::plain;
use crate::{Action, ProgramError, Steps};

/// Formats a program or steps for people: each step is a table with one key per line, `go` first; a
/// point, a tool, a frame or a grid is on one line.
pub(crate) fn on_lines(program: &impl serde::Serialize) -> Result<DocumentMut, String> {
    let text = toml::to_string(program).map_err(|error| plain(&error.to_string()))?;
    let document = text.parse();
    let mut document: DocumentMut =
        document.map_err(|error: toml_edit::TomlError| plain(error.message()))?;
    lay_out(&mut document);
    Ok(document)
}

pub(super) fn lay_out(document: &mut DocumentMut) {
    for (_, item) in document.iter_mut() {
        match item {
            Item::Table(names) => inline(names),
            Item::ArrayOfTables(steps) => steps.iter_mut().for_each(inline),
            _ => {}
        }
    }
}

/// A step as the table of a text.
pub(super) fn table_of(action: Action) -> Result<Table, ProgramError> {
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
