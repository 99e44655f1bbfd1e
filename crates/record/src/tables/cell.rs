//! What stands in a table.

/// A column: what it is called, and what stands in it.
#[derive(Clone, Debug)]
pub(crate) struct Column {
    pub(crate) name: String,
    pub(crate) kind: Kind,
}

/// What stands in a column.
#[cfg_attr(
    not(feature = "parquet"),
    expect(dead_code, reason = "only datasets have these columns")
)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Nanoseconds since 1970.
    Time,
    Integer,
    Float,
    Double,
    Truth,
    /// A text, or nothing.
    Text,
    Integers,
    Floats,
    Doubles,
    Texts,
}

/// What stands in one row of a column, of the column's kind. Lists are not empty.
#[cfg_attr(
    not(feature = "parquet"),
    expect(dead_code, reason = "only datasets have these columns")
)]
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Cell {
    Time(i64),
    Integer(i64),
    Float(f32),
    Double(f64),
    Truth(bool),
    Text(Option<String>),
    Integers(Vec<i64>),
    Floats(Vec<f32>),
    Doubles(Vec<f64>),
    Texts(Vec<String>),
}

/// A column of that name.
pub(crate) fn column(name: impl Into<String>, kind: Kind) -> Column {
    let name = name.into();
    Column { name, kind }
}
