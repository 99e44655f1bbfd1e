//! Planned drawings.

use std::path::Path;

use dobot_draw::{
    Colors, DrawingRequest, FORMATS, InkLine, Materials, Options, OptionsError, Picture, Prepared,
    Settings, Subject, View, WITHOUT_ARM_Z_MM,
};
use dobot_geometry::Point;
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use serde_json::{Map, Value};

use crate::failure::{file_error, value_error};

/// Returns the supported file formats: the name and the extensions of each.
#[pyfunction]
pub(crate) fn drawing_formats() -> Vec<(&'static str, Vec<&'static str>)> {
    let row = |format: &'static dobot_draw::Format| (format.name, format.extensions.to_vec());
    FORMATS.iter().map(row).collect()
}

/// A drawing, planned for any arm; it is planned again for the arm that draws it.
#[pyclass(frozen)]
pub(crate) struct Drawing {
    pub(crate) request: DrawingRequest,
    prepared: Prepared,
    settings: Settings,
}

/// Lines computed in Python, passed in pieces to avoid a complete copy.
#[pyclass]
#[derive(Default)]
pub(crate) struct Lines(Vec<Vec<Point>>);

#[pymethods]
impl Lines {
    #[new]
    fn new() -> Self {
        Self::default()
    }

    /// Begins a line with this number of points; more may follow.
    fn begin(&mut self, points: usize) {
        self.0.push(Vec::with_capacity(points.min(MAX_FORESEEN)));
    }

    /// Appends points to the last line: the bytes of x and y as 64-bit floats.
    fn extend(&mut self, bytes: &[u8]) {
        let number = |bytes: &[u8]| bytes.try_into().map_or(f64::NAN, f64::from_le_bytes);
        let point = |bytes: &[u8]| {
            let (x, y) = bytes.split_at(bytes.len().min(8));
            Point::new(number(x), number(y))
        };
        if let Some(line) = self.0.last_mut() {
            line.extend(bytes.chunks(16).map(point));
        }
    }
}

impl Lines {
    fn take(&mut self) -> Subject {
        Subject::of_lines("lines", std::mem::take(&mut self.0))
    }
}

/// The maximum number of points for which memory is reserved in advance.
const MAX_FORESEEN: usize = 10_000_000;

#[pymethods]
impl Drawing {
    /// Plans a file (by name), lines, or the contents of the options, a JSON object. The lines are
    /// moved out of their argument.
    #[new]
    fn new(
        py: Python<'_>,
        file: Option<&str>,
        lines: Option<PyRefMut<'_, Lines>>,
        options: &str,
    ) -> PyResult<Self> {
        let options = grouped(options)?;
        let drawn = match (file, lines) {
            (Some(file), None) => Some(of_file(file)?),
            (None, Some(mut lines)) => Some(lines.take()),
            (None, None) => None,
            (Some(_), Some(_)) => {
                return Err(PyTypeError::new_err("give a file or lines=, not both"));
            }
        };
        let subject = match (drawn, Subject::of_text(&options.what)) {
            (None, Some(subject)) | (Some(subject), None) => subject,
            (None, None) => return Err(PyTypeError::new_err("give a file, lines= or text=")),
            (Some(subject), Some(text)) => subject.and(text),
        };
        py.detach(|| {
            let request = DrawingRequest::new(options, subject, &Materials::built_in());
            let request = request.map_err(|error| refused(&error))?;
            let (prepared, settings) = request
                .prepare(None, WITHOUT_ARM_Z_MM)
                .map_err(|error| refused(&error))?;
            Ok(Self {
                request,
                prepared,
                settings,
            })
        })
    }

    #[getter]
    fn title(&self) -> &str {
        &self.request.title
    }

    #[getter]
    fn duration_s(&self) -> f64 {
        self.prepared.plan.duration_s()
    }

    #[getter]
    fn vectors(&self) -> usize {
        self.prepared.plan.summary().vectors
    }

    #[getter]
    fn drawn_mm(&self) -> f64 {
        self.prepared.plan.summary().drawn_mm
    }

    #[getter]
    fn warnings(&self) -> Vec<String> {
        let warnings = self.prepared.warnings.iter().map(ToString::to_string);
        warnings
            .map(|warning| Options::rename_fields(&warning, str::to_owned))
            .collect()
    }

    /// Returns the ink, in the base frame, in mm.
    fn strokes(&self) -> Vec<Vec<(f64, f64)>> {
        let strokes = self.prepared.planned().into_iter();
        strokes
            .map(|stroke| stroke.points.into_iter().map(<(f64, f64)>::from).collect())
            .collect()
    }

    fn svg(&self, py: Python<'_>) -> String {
        py.detach(|| {
            let ink = InkLine::measured(self.prepared.planned(), &self.prepared.wanted());
            self.picture(&ink).to_svg()
        })
    }
}

impl Drawing {
    fn picture<'a>(&'a self, ink: &'a [InkLine]) -> Picture<'a> {
        Picture {
            title: &self.request.title,
            figures: &[],
            passes: &[],
            area: dobot_draw::AREA,
            sheet: self.settings.placement.sheet,
            plan: &self.prepared.plan,
            drawn: ink,
            colors: Colors::Passes,
            view: View::Paper,
        }
    }
}

/// Returns the error of invalid options, with their Python names.
fn refused(why: &OptionsError) -> PyErr {
    value_error(&Options::rename_fields(&why.to_string(), str::to_owned))
}

/// Parses the options with their Python names: those of `dobot draw`, without groups.
fn grouped(json: &str) -> PyResult<Options> {
    let flat: Map<String, Value> =
        serde_json::from_str(json).map_err(|error| value_error(&error))?;
    let known = Options::fields();
    let mut asked = Map::new();
    for (name, value) in flat {
        let group = known
            .iter()
            .find(|(_, options)| options.get(&name).is_some());
        let Some((group, _)) = group else {
            let names = known
                .values()
                .filter_map(Value::as_object)
                .flat_map(Map::keys);
            let names: Vec<&str> = names.map(String::as_str).collect();
            return Err(PyTypeError::new_err(format!(
                "unknown option `{name}`; allowed are {}",
                names.join(", ")
            )));
        };
        let group = asked.entry(group).or_insert_with(|| Map::new().into());
        group[&name] = value;
    }
    serde_path_to_error::deserialize(Value::Object(asked)).map_err(|error| {
        let path = error.path().to_string();
        let name = path.rsplit('.').next().unwrap_or_default();
        let problem = error.inner().to_string();
        let problem = problem.replace("expected f64", "allowed is a number");
        PyValueError::new_err(format!("{name}: {problem}"))
    })
}

fn of_file(file: &str) -> PyResult<Subject> {
    let bytes = std::fs::read(file).map_err(|error| file_error(&error, Path::new(file)))?;
    let name = Path::new(file)
        .file_name()
        .map(|file_name| file_name.to_string_lossy());
    let subject = Subject::of_file(&name.unwrap_or_default(), bytes);
    subject.map_err(|error| PyValueError::new_err(format!("{file}: {error}")))
}
