//! Table columns for Python: the bytes of a numpy array, or a list of texts.

use dobot_record::tables::{TableColumn, Values};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyList};

/// Columns of rows: the name of each, its numpy dtype, and its bytes.
pub(crate) struct Columns<'py> {
    py: Python<'py>,
    columns: Bound<'py, PyDict>,
}

impl<'py> Columns<'py> {
    pub(crate) fn new(py: Python<'py>) -> Self {
        let columns = PyDict::new(py);
        Self { py, columns }
    }

    /// Adds a column of 64-bit floats.
    pub(crate) fn doubles(self, name: &str, all: impl Iterator<Item = f64>) -> PyResult<Self> {
        self.bytes(name, "<f8", all.map(f64::to_le_bytes))
    }

    /// Adds a column of 32-bit floats, as in packets.
    pub(crate) fn floats(self, name: &str, all: impl Iterator<Item = f32>) -> PyResult<Self> {
        self.bytes(name, "<f4", all.map(f32::to_le_bytes))
    }

    /// Adds a column of integers.
    pub(crate) fn integers(self, name: &str, all: impl Iterator<Item = i64>) -> PyResult<Self> {
        self.bytes(name, "<i8", all.map(i64::to_le_bytes))
    }

    /// Adds a column of times in nanoseconds since 1970.
    fn times(self, name: &str, all: impl Iterator<Item = i64>) -> PyResult<Self> {
        self.bytes(name, "<M8[ns]", all.map(i64::to_le_bytes))
    }

    /// Adds a column of Booleans.
    pub(crate) fn truths(self, name: &str, all: impl Iterator<Item = bool>) -> PyResult<Self> {
        self.bytes(name, "?", all.map(|value| [u8::from(value)]))
    }

    fn texts(self, name: &str, all: Vec<Option<String>>) -> PyResult<Self> {
        self.columns
            .set_item(name, ("O", PyList::new(self.py, all)?))?;
        Ok(self)
    }

    /// Adds a column of a recording.
    pub(crate) fn column(self, column: TableColumn) -> PyResult<Self> {
        let name = column.name.as_str();
        match column.values {
            Values::Times(all) => self.times(name, all.into_iter()),
            Values::Floats(all) => self.floats(name, all.into_iter()),
            Values::Truths(all) => self.truths(name, all.into_iter()),
            Values::Texts(all) => self.texts(name, all),
            Values::Doubles(all) => self.doubles(name, all.into_iter()),
        }
    }

    pub(crate) fn finish(self) -> Bound<'py, PyDict> {
        self.columns
    }

    fn bytes<const N: usize>(
        self,
        name: &str,
        dtype: &str,
        all: impl Iterator<Item = [u8; N]>,
    ) -> PyResult<Self> {
        let bytes: Vec<u8> = all.flatten().collect();
        self.columns
            .set_item(name, (dtype, PyBytes::new(self.py, &bytes)))?;
        Ok(self)
    }
}
