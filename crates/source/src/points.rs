//! Reading plain points: CSV and JSON, in millimetres, x to the right and y down as on a page.

mod csv;
mod json;

pub(crate) use self::csv::read as read_csv;
pub(crate) use self::json::read as read_json;

#[cfg(test)]
mod tests;
