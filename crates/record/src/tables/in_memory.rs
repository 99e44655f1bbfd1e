//! Both tables of a recording in memory, by column.

use std::ops::RangeInclusive;
use std::time::Duration;

use crate::Recording;

use super::cell::{Cell, Column, Kind};
use super::columns::{of_commands, of_statuses};
use super::rows::{Row, each_row};

/// A column of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct TableColumn {
    /// The name, as in the files.
    pub name: String,
    /// The values.
    pub values: Values,
}

/// The values of a column.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// Nanoseconds since 1970.
    Times(Vec<i64>),
    /// Numbers as in a packet.
    Floats(Vec<f32>),
    /// Numbers.
    Doubles(Vec<f64>),
    /// Booleans.
    Truths(Vec<bool>),
    /// Optional texts.
    Texts(Vec<Option<String>>),
}

/// Both tables of a recording.
#[derive(Clone, Debug, PartialEq)]
pub struct Tables {
    /// The statuses of the arm.
    pub statuses: Vec<TableColumn>,
    /// The commands sent to it.
    pub commands: Vec<TableColumn>,
}

/// Reads the statuses and the commands of a period of a recording, with the columns of
/// [`export_tables`](super::export_tables). Everything is held in memory: 60 bytes per status.
#[must_use]
pub fn read_tables(recording: &mut Recording, stretch: &RangeInclusive<Duration>) -> Tables {
    let mut statuses: Vec<TableColumn> = of_statuses().into_iter().map(empty).collect();
    let mut commands: Vec<TableColumn> = of_commands().into_iter().map(empty).collect();
    let read = each_row(recording, stretch, |row| {
        match row {
            Row::Status(cells) => push(&mut statuses, cells),
            Row::Command(cells) => push(&mut commands, cells),
        }
        Ok(())
    });
    debug_assert!(read.is_ok(), "only writing can fail");
    Tables { statuses, commands }
}

fn empty(column: Column) -> TableColumn {
    let values = match column.kind {
        Kind::Time => Values::Times(Vec::new()),
        Kind::Float => Values::Floats(Vec::new()),
        Kind::Truth => Values::Truths(Vec::new()),
        Kind::Text => Values::Texts(Vec::new()),
        _ => Values::Doubles(Vec::new()),
    };
    TableColumn {
        name: column.name,
        values,
    }
}

fn push(columns: &mut [TableColumn], cells: Vec<Cell>) {
    for (column, cell) in columns.iter_mut().zip(cells) {
        match (&mut column.values, cell) {
            (Values::Times(all), Cell::Time(value)) => all.push(value),
            (Values::Floats(all), Cell::Float(value)) => all.push(value),
            (Values::Doubles(all), Cell::Double(value)) => all.push(value),
            (Values::Truths(all), Cell::Truth(value)) => all.push(value),
            (Values::Texts(all), Cell::Text(value)) => all.push(value),
            (_, cell) => unreachable!("{cell:?} is in the column {}", column.name),
        }
    }
}
