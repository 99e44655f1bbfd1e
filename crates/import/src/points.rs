//! The readers of plain points: CSV, JSON and lists, in millimetres, x to the right and y down as
//! on a page.

mod csv;
mod json;
mod lines;

pub(crate) use self::csv::{is_likely as is_likely_csv, read as read_csv};
pub(crate) use self::json::read as read_json;
pub(crate) use self::lines::read as read_lines;

#[cfg(test)]
mod tests;
