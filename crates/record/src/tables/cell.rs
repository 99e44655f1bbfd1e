//! The cells of a table.

/// A column: its name and its type.
#[derive(Clone, Debug)]
pub(crate) struct Column {
    pub(crate) name: String,
    pub(crate) kind: Kind,
}

/// The type of a column.
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
    /// An optional text.
    Text,
    Integers,
    Floats,
    Doubles,
    Texts,
}

/// A cell, of the type of its column. Lists are not empty.
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

/// Creates a column with this name.
pub(crate) fn column(name: impl Into<String>, kind: Kind) -> Column {
    let name = name.into();
    Column { name, kind }
}
