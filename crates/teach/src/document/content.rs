//! New content in an old text: what is unchanged keeps its comments and its format.

use std::collections::{BTreeMap, BTreeSet};

use toml_edit::{ArrayOfTables, DocumentMut, Item, Table, TableLike, Value};

use super::forget_position;
use super::layout::lay_out;
use crate::ProgramError;
use crate::plain::plain;

/// Returns a text with the content of another one. Unchanged keys and steps keep their comments and
/// their format, also steps that were moved; the comments of a removed step are removed with it.
/// Steps that were written as one array become `[[steps]]` if their number changes.
///
/// Both have to be TOML, but neither has to be a valid program: unknown keys are kept.
///
/// # Errors
///
/// [`ProgramError`] if one of them is not TOML.
///
/// ```
/// let text = "[[steps]]\npause = 1 # a moment\n";
/// let changed = dobot_teach::with_content(text, "[[steps]]\npause = 2")?;
/// assert_eq!(changed, "[[steps]]\npause = 2 # a moment\n");
/// # Ok::<(), dobot_teach::ProgramError>(())
/// ```
pub fn with_content(text: &str, content: &str) -> Result<String, ProgramError> {
    let mut document = parsed(text, "the text")?;
    let mut content = parsed(content, "the content")?;
    if canonical(document.as_item()) == canonical(content.as_item()) {
        return Ok(text.to_owned());
    }
    lay_out(&mut content);
    let mut steps = BTreeMap::new();
    collect_tables(document.as_item(), &mut steps);
    let known = document.iter().map(|(key, _)| key.to_owned()).collect();
    merge_tables(document.as_table_mut(), content.as_table(), &mut steps);
    names_before_steps(&mut document, &known);
    forget_position(document.as_table_mut());
    Ok(document.to_string())
}

fn parsed(text: &str, what: &str) -> Result<DocumentMut, ProgramError> {
    text.parse().map_err(|error: toml_edit::TomlError| {
        let start = error.span().map_or(0, |span| span.start);
        let line = text[..start.min(text.len())].matches('\n').count() + 1;
        ProgramError::at(
            line,
            format!("{what} is not TOML: {}", plain(error.message())),
        )
    })
}

/// New tables of names stand before the steps, as in a new program.
fn names_before_steps(document: &mut DocumentMut, known: &BTreeSet<String>) {
    let has_new = document.iter().any(|(key, _)| !known.contains(key));
    if has_new && let Some((key, steps)) = document.remove_entry("steps") {
        document.insert_formatted(&key, steps);
    }
}

/// The tables in lists, by their content: a step that was moved to another list is one of them.
type Tables = BTreeMap<String, Vec<Table>>;

fn collect_tables(item: &Item, tables: &mut Tables) {
    if let Some(list) = item.as_array_of_tables() {
        for table in list {
            let content = canonical_table(table);
            tables.entry(content).or_default().push(table.clone());
            table
                .iter()
                .for_each(|(_, item)| collect_tables(item, tables));
        }
    } else if let Some(table) = item.as_table_like() {
        table
            .iter()
            .for_each(|(_, item)| collect_tables(item, tables));
    }
}

fn merge_tables(old: &mut dyn TableLike, new: &dyn TableLike, moved: &mut Tables) {
    let gone = old.iter().map(|(key, _)| key.to_owned());
    let gone: Vec<String> = gone.filter(|key| !new.contains_key(key)).collect();
    for key in gone {
        old.remove(&key);
    }
    for (key, item) in new.iter() {
        match old.get_mut(key) {
            // The key of a table is written otherwise than that of a value.
            Some(there) if item.is_value() && there.is_array_of_tables() => {
                old.remove(key);
                old.insert(key, item.clone());
            }
            Some(there) => merge_items(there, item, moved),
            None => {
                old.insert(key, item.clone());
            }
        }
    }
}

fn merge_items(old: &mut Item, new: &Item, moved: &mut Tables) {
    if canonical(old) == canonical(new) {
        return;
    }
    if let (Some(old), Some(new)) = (old.as_table_like_mut(), new.as_table_like()) {
        return merge_tables(old, new, moved);
    }
    if let (Some(old), Some(new)) = (old.as_array_of_tables_mut(), new.as_array_of_tables()) {
        *old = merged_list(old, new, moved);
        return;
    }
    if let (Some(old), Some(new)) = (old.as_array_mut(), new.as_array_of_tables())
        && old.len() == new.len()
    {
        let tables = old.iter_mut().map(Value::as_inline_table_mut).zip(new);
        for (old, new) in tables.filter_map(|(old, new)| Some((old?, new))) {
            merge_tables(old, new, moved);
        }
        return;
    }
    let decor = old.as_value().map(|value| value.decor().clone());
    *old = new.clone();
    if let (Some(value), Some(decor)) = (old.as_value_mut(), decor) {
        *value.decor_mut() = decor;
    }
}

/// The new list, of old tables where they are equal or only changed.
fn merged_list(old: &ArrayOfTables, new: &ArrayOfTables, moved: &mut Tables) -> ArrayOfTables {
    let contents = |list: &ArrayOfTables| {
        list.iter()
            .map(|table| canonical_table(table))
            .collect::<Vec<_>>()
    };
    let (was, is) = (contents(old), contents(new));
    let mut from = unchanged(&was, &is);
    let mut left: Vec<usize> = (0..old.len())
        .filter(|n| !from.contains(&Some(*n)))
        .collect();
    // Moved within the list.
    for (content, from) in is.iter().zip(&mut from) {
        if from.is_none()
            && let Some(at) = left.iter().position(|n| was[*n] == *content)
        {
            *from = Some(left.remove(at));
        }
    }
    let stays = |content: &String| was.contains(content) || moved.contains_key(content);
    let is_moved: Vec<bool> = is.iter().map(stays).collect();
    // Changed in their place: between the same neighbours.
    for at in 0..is.len() {
        if from[at].is_some() || is_moved[at] {
            continue;
        }
        let low = from[..at].iter().flatten().max().map_or(0, |n| n + 1);
        let after = from[at + 1..].iter().flatten();
        let high = after.filter(|n| **n >= low).min().map_or(old.len(), |n| *n);
        let table = new.get(at);
        let shares = |n: usize| {
            let (old, new) = (old.get(n)?, table?);
            old.iter().find(|(key, _)| new.contains_key(key))
        };
        let is_here = |n: &usize| (low..high).contains(n) && shares(*n).is_some();
        if let Some(place) = left.iter().position(is_here) {
            from[at] = Some(left.remove(place));
        }
    }
    let mut list = ArrayOfTables::new();
    for (at, table) in new.iter().enumerate() {
        let there = from[at].and_then(|n| old.get(n)).cloned();
        let there = there.or_else(|| moved.get_mut(&is[at]).and_then(Vec::pop));
        list.push(if let Some(mut there) = there {
            merge_tables(&mut there, table, moved);
            there
        } else {
            let mut table = table.clone();
            table.decor_mut().set_prefix("\n");
            table
        });
    }
    list
}

/// For each new table the old one that is equal, in their common order.
fn unchanged(was: &[String], is: &[String]) -> Vec<Option<usize>> {
    let head = was.iter().zip(is).take_while(|(a, b)| a == b).count();
    let (was_rest, is_rest) = (&was[head..], &is[head..]);
    let same = was_rest.iter().rev().zip(is_rest.iter().rev());
    let tail = same.take_while(|(a, b)| a == b).count();
    let (rows, columns) = (was_rest.len() - tail, is_rest.len() - tail);
    let mut from: Vec<Option<usize>> = (0..head).map(Some).collect();
    if rows * columns <= MAX_COMPARED {
        from.extend(longest_common(&was_rest[..rows], &is_rest[..columns], head));
    } else {
        from.resize(head + columns, None);
    }
    from.extend((was.len() - tail..was.len()).map(Some));
    from
}

/// The longest common subsequence, as numbers in `was` after `offset`.
fn longest_common(was: &[String], is: &[String], offset: usize) -> Vec<Option<usize>> {
    let mut length = vec![vec![0_u32; is.len() + 1]; was.len() + 1];
    for (row, old) in was.iter().enumerate().rev() {
        for (column, new) in is.iter().enumerate().rev() {
            length[row][column] = if old == new {
                length[row + 1][column + 1] + 1
            } else {
                length[row + 1][column].max(length[row][column + 1])
            };
        }
    }
    let mut row = 0;
    let mut from = Vec::new();
    for (column, new) in is.iter().enumerate() {
        while row < was.len() && was[row] != *new && length[row + 1][column] == length[row][column]
        {
            row += 1;
        }
        let is_common = row < was.len() && was[row] == *new;
        from.push(is_common.then_some(offset + row));
        row += usize::from(is_common);
    }
    from
}

/// A content as a text that does not depend on order, layout or the kind of whole numbers.
fn canonical(item: &Item) -> String {
    match item {
        Item::Value(value) => canonical_value(value),
        Item::Table(table) => canonical_table(table),
        Item::ArrayOfTables(list) => {
            let tables: Vec<String> = list.iter().map(|table| canonical_table(table)).collect();
            format!("[{}]", tables.join(","))
        }
        Item::None => String::new(),
    }
}

fn canonical_table(table: &dyn TableLike) -> String {
    let mut rows: Vec<String> = table
        .iter()
        .map(|(key, item)| format!("{key:?}:{}", canonical(item)))
        .collect();
    rows.sort();
    format!("{{{}}}", rows.join(","))
}

fn canonical_value(value: &Value) -> String {
    match value {
        Value::String(text) => format!("{:?}", text.value()),
        Value::Integer(number) => number.value().to_string(),
        Value::Float(number) => number.value().to_string(),
        Value::Boolean(on) => on.value().to_string(),
        Value::Datetime(time) => time.value().to_string(),
        Value::InlineTable(table) => canonical_table(table),
        Value::Array(list) => {
            let values: Vec<String> = list.iter().map(canonical_value).collect();
            format!("[{}]", values.join(","))
        }
    }
}

/// Comparisons of two lists at most; in longer changes, equal steps are found wherever they are.
const MAX_COMPARED: usize = 4_000_000;
