//! A table as a Parquet file.

use std::io::Write;
use std::sync::Arc;

use parquet::basic::{Compression, LogicalType, Repetition, TimeUnit, Type as Physical, ZstdLevel};
use parquet::data_type::{
    BoolType, ByteArray, ByteArrayType, DataType, DoubleType, FloatType, Int64Type,
};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::{Type, TypePtr};

use super::cell::{Cell, Column, Kind};
use super::error::ExportError;

/// A table written as a Parquet file, some tens of thousands of rows at a time.
pub(crate) struct ParquetTable<W: Write + Send> {
    writer: SerializedFileWriter<W>,
    buffers: Vec<Buffer>,
    rows: usize,
}

/// The rows of a column that wait to be written.
struct Buffer {
    values: Values,
    /// For lists: 0 at the start of a row. For texts: 0 for none.
    levels: Vec<i16>,
    kind: Kind,
}

enum Values {
    Integer(Vec<i64>),
    Float(Vec<f32>),
    Double(Vec<f64>),
    Truth(Vec<bool>),
    Text(Vec<ByteArray>),
}

impl<W: Write + Send> ParquetTable<W> {
    /// Creates a file; `notes` are stored in its footer.
    pub(crate) fn new(
        file: W,
        columns: &[Column],
        notes: &[(&str, String)],
    ) -> Result<Self, ExportError> {
        let fields = columns.iter().map(field).collect::<Result<_, _>>()?;
        let schema = Type::group_type_builder("schema")
            .with_fields(fields)
            .build()?;
        let notes = notes
            .iter()
            .map(|(key, value)| KeyValue::new((*key).to_owned(), value.clone()));
        let properties = WriterProperties::builder()
            .set_compression(Compression::ZSTD(ZstdLevel::default()))
            .set_created_by(concat!("dobot ", env!("CARGO_PKG_VERSION")).to_owned())
            .set_key_value_metadata(Some(notes.collect()))
            .build();
        Ok(Self {
            writer: SerializedFileWriter::new(file, Arc::new(schema), Arc::new(properties))?,
            buffers: columns
                .iter()
                .map(|column| Buffer::new(column.kind))
                .collect(),
            rows: 0,
        })
    }

    /// Writes a row: one cell per column.
    pub(crate) fn push(&mut self, cells: Vec<Cell>) -> Result<(), ExportError> {
        for (buffer, cell) in self.buffers.iter_mut().zip(cells) {
            buffer.push(cell);
        }
        self.rows += 1;
        if self.rows >= MAX_ROWS {
            self.end_group()?;
        }
        Ok(())
    }

    /// Writes the waiting rows; later ones are in another row group.
    pub(crate) fn end_group(&mut self) -> Result<(), ExportError> {
        if self.rows == 0 {
            return Ok(());
        }
        let mut group = self.writer.next_row_group()?;
        for buffer in &mut self.buffers {
            buffer.write(&mut group)?;
        }
        group.close()?;
        self.rows = 0;
        Ok(())
    }

    /// Writes the remaining rows and finishes the file.
    pub(crate) fn finish(mut self) -> Result<(), ExportError> {
        self.end_group()?;
        self.writer.close()?;
        Ok(())
    }
}

impl Buffer {
    const fn new(kind: Kind) -> Self {
        let values = match kind {
            Kind::Time | Kind::Integer | Kind::Integers => Values::Integer(Vec::new()),
            Kind::Float | Kind::Floats => Values::Float(Vec::new()),
            Kind::Double | Kind::Doubles => Values::Double(Vec::new()),
            Kind::Truth => Values::Truth(Vec::new()),
            Kind::Text | Kind::Texts => Values::Text(Vec::new()),
        };
        Self {
            values,
            levels: Vec::new(),
            kind,
        }
    }

    fn push(&mut self, cell: Cell) {
        if let Cell::Text(text) = &cell {
            self.levels.push(text.is_some().into());
        }
        let list = (0..list_len(&cell)).map(|n| i16::from(n > 0));
        self.levels.extend(list);
        let bytes = |text: String| ByteArray::from(text.into_bytes());
        match (&mut self.values, cell) {
            (Values::Integer(all), Cell::Time(value) | Cell::Integer(value)) => all.push(value),
            (Values::Integer(all), Cell::Integers(values)) => all.extend(values),
            (Values::Float(all), Cell::Float(value)) => all.push(value),
            (Values::Float(all), Cell::Floats(values)) => all.extend(values),
            (Values::Double(all), Cell::Double(value)) => all.push(value),
            (Values::Double(all), Cell::Doubles(values)) => all.extend(values),
            (Values::Truth(all), Cell::Truth(value)) => all.push(value),
            (Values::Text(all), Cell::Text(text)) => all.extend(text.map(bytes)),
            (Values::Text(all), Cell::Texts(texts)) => all.extend(texts.into_iter().map(bytes)),
            (_, other) => unreachable!("{other:?} is in a column of {:?}", self.kind),
        }
    }

    fn write<W: Write + Send>(
        &mut self,
        group: &mut SerializedRowGroupWriter<'_, W>,
    ) -> Result<(), ExportError> {
        let levels = std::mem::take(&mut self.levels);
        match &mut self.values {
            Values::Integer(all) => write::<Int64Type, W>(group, self.kind, all, &levels)?,
            Values::Float(all) => write::<FloatType, W>(group, self.kind, all, &levels)?,
            Values::Double(all) => write::<DoubleType, W>(group, self.kind, all, &levels)?,
            Values::Truth(all) => write::<BoolType, W>(group, self.kind, all, &levels)?,
            Values::Text(all) => write::<ByteArrayType, W>(group, self.kind, all, &levels)?,
        }
        Ok(())
    }
}

/// Returns the number of values in a list; 0 for other cells.
const fn list_len(cell: &Cell) -> usize {
    match cell {
        Cell::Integers(values) => values.len(),
        Cell::Floats(values) => values.len(),
        Cell::Doubles(values) => values.len(),
        Cell::Texts(values) => values.len(),
        _ => 0,
    }
}

/// Writes a column and empties it.
fn write<T: DataType, W: Write + Send>(
    group: &mut SerializedRowGroupWriter<'_, W>,
    kind: Kind,
    values: &mut Vec<T::T>,
    levels: &[i16],
) -> Result<(), ExportError> {
    let mut column = group.next_column()?.expect("there is one for each buffer");
    // No list is empty, so each of its items exists.
    let ones = vec![1; levels.len()];
    let (definition, repetition) = match kind {
        Kind::Text => (Some(levels), None),
        Kind::Integers | Kind::Floats | Kind::Doubles | Kind::Texts => {
            (Some(ones.as_slice()), Some(levels))
        }
        _ => (None, None),
    };
    column
        .typed::<T>()
        .write_batch(values, definition, repetition)?;
    values.clear();
    Ok(column.close()?)
}

/// The type of a column. A list is a group of three levels, as the specification of the format
/// requires.
fn field(column: &Column) -> Result<TypePtr, ExportError> {
    let name = column.name.as_str();
    let utc_ns = LogicalType::timestamp(true, TimeUnit::NANOS);
    let (physical, logical, is_list) = match column.kind {
        Kind::Time => (Physical::INT64, Some(utc_ns), false),
        Kind::Integer => (Physical::INT64, None, false),
        Kind::Float => (Physical::FLOAT, None, false),
        Kind::Double => (Physical::DOUBLE, None, false),
        Kind::Truth => (Physical::BOOLEAN, None, false),
        Kind::Text => (Physical::BYTE_ARRAY, Some(LogicalType::String), false),
        Kind::Integers => (Physical::INT64, None, true),
        Kind::Floats => (Physical::FLOAT, None, true),
        Kind::Doubles => (Physical::DOUBLE, None, true),
        Kind::Texts => (Physical::BYTE_ARRAY, Some(LogicalType::String), true),
    };
    let is_optional = column.kind == Kind::Text;
    let repetition = if is_optional {
        Repetition::OPTIONAL
    } else {
        Repetition::REQUIRED
    };
    let value = Type::primitive_type_builder(if is_list { "element" } else { name }, physical)
        .with_logical_type(logical)
        .with_repetition(repetition)
        .build()?;
    if !is_list {
        return Ok(Arc::new(value));
    }
    let items = Type::group_type_builder("list")
        .with_repetition(Repetition::REPEATED)
        .with_fields(vec![Arc::new(value)])
        .build()?;
    let list = Type::group_type_builder(name)
        .with_repetition(Repetition::REQUIRED)
        .with_logical_type(Some(LogicalType::List))
        .with_fields(vec![Arc::new(items)])
        .build()?;
    Ok(Arc::new(list))
}

/// The largest number of waiting rows; a row of commands has about a hundred bytes.
const MAX_ROWS: usize = 32_768;
