//! A table being written.

use std::fmt;
use std::io::Write;

use jiff::Timestamp;

use super::cell::{Cell, Column};
use super::columns::{of_commands, of_statuses};
use super::error::ExportError;
#[cfg(feature = "parquet")]
use super::parquet_table::ParquetTable;

/// A table being written: CSV or Parquet.
pub struct Table<W: Write + Send>(Form<W>);

enum Form<W: Write + Send> {
    Csv(Box<csv::Writer<W>>),
    #[cfg(feature = "parquet")]
    Parquet(Box<ParquetTable<W>>),
}

impl<W: Write + Send> Table<W> {
    /// Creates a table of statuses as CSV.
    ///
    /// # Errors
    ///
    /// [`ExportError`] if the file cannot be written.
    pub fn statuses_csv(file: W) -> Result<Self, ExportError> {
        Self::csv(file, &of_statuses())
    }

    /// Creates a table of commands as CSV.
    ///
    /// # Errors
    ///
    /// [`ExportError`] if the file cannot be written.
    pub fn commands_csv(file: W) -> Result<Self, ExportError> {
        Self::csv(file, &of_commands())
    }

    #[cfg(feature = "parquet")]
    /// Creates a table of statuses as Parquet.
    ///
    /// # Errors
    ///
    /// [`ExportError`] if the file cannot be written.
    pub fn statuses_parquet(file: W) -> Result<Self, ExportError> {
        Self::parquet(file, &of_statuses())
    }

    #[cfg(feature = "parquet")]
    /// Creates a table of commands as Parquet.
    ///
    /// # Errors
    ///
    /// [`ExportError`] if the file cannot be written.
    pub fn commands_parquet(file: W) -> Result<Self, ExportError> {
        Self::parquet(file, &of_commands())
    }

    #[cfg_attr(
        not(feature = "parquet"),
        expect(clippy::needless_pass_by_value, reason = "Parquet keeps the cells")
    )]
    pub(crate) fn push(&mut self, cells: Vec<Cell>) -> Result<(), ExportError> {
        match &mut self.0 {
            Form::Csv(csv) => Ok(csv.write_record(cells.iter().map(text))?),
            #[cfg(feature = "parquet")]
            Form::Parquet(parquet) => parquet.push(cells),
        }
    }

    pub(crate) fn finish(self) -> Result<(), ExportError> {
        match self.0 {
            Form::Csv(mut csv) => Ok(csv.flush()?),
            #[cfg(feature = "parquet")]
            Form::Parquet(parquet) => parquet.finish(),
        }
    }

    fn csv(file: W, columns: &[Column]) -> Result<Self, ExportError> {
        let mut csv = csv::Writer::from_writer(file);
        csv.write_record(columns.iter().map(|column| &column.name))?;
        Ok(Self(Form::Csv(Box::new(csv))))
    }

    #[cfg(feature = "parquet")]
    fn parquet(file: W, columns: &[Column]) -> Result<Self, ExportError> {
        let parquet = ParquetTable::new(file, columns, &[])?;
        Ok(Self(Form::Parquet(Box::new(parquet))))
    }
}

impl<W: Write + Send> fmt::Debug for Table<W> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Table").finish_non_exhaustive()
    }
}

/// A cell of a CSV file, which has no lists. Readers guess the type of a column from its first cells, so that
/// each number of a column has a decimal point, or none, and each time as many digits.
fn text(cell: &Cell) -> String {
    match cell {
        Cell::Time(ns) => Timestamp::from_nanosecond(i128::from(*ns))
            .map_or_else(|_| ns.to_string(), |time| format!("{time:.9}")),
        Cell::Integer(value) => value.to_string(),
        Cell::Float(value) => format!("{value:?}"),
        Cell::Double(value) => format!("{value:?}"),
        Cell::Truth(value) => value.to_string(),
        Cell::Text(text) => text.clone().unwrap_or_default(),
        Cell::Integers(_) | Cell::Floats(_) | Cell::Doubles(_) | Cell::Texts(_) => String::new(),
    }
}
