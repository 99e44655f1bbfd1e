//! Taught programs: read, created from steps, checked, and converted to jobs.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use dobot_api::problem_kinds::{BAD_PROGRAM, OUT_OF_RANGE};
use dobot_api::{NewJob, Problem};
use dobot_draw::ProgramFiles;
use dobot_host::{PlannedFor, ProgramJobError, ProgramStart, Rules, dry_run_program, program_job};
use dobot_safety::Policy;
use dobot_teach::{
    Action, Files, Program, ProgramError, ProgramForm, RecordedPlace, Steps, Times, ToolState,
    path_steps, simplified,
};
use dobot_wire::{Dialect, MovingMode};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use serde_json::{Value, json};
use toml::Spanned;

use crate::failure::{file_error, value_error};

/// A program, with the folder of the files that it uses.
#[pyclass(frozen)]
pub(crate) struct Taught {
    pub(crate) source: Arc<Source>,
    text: String,
    warnings: Vec<String>,
}

/// The source of jobs.
pub(crate) struct Source {
    program: Program,
    /// Its name if it has no title.
    name: String,
    folder: PathBuf,
}

#[pymethods]
impl Taught {
    /// Reads a file, whose format is determined by its extension.
    #[staticmethod]
    fn read(py: Python<'_>, file: PathBuf) -> PyResult<Self> {
        let form = form_of(&file)?;
        let bytes = fs::read(&file).map_err(|error| file_error(&error, &file))?;
        let in_file = |program_error: ProgramError| {
            PyValueError::new_err(format!("{}: {program_error}", file.display()))
        };
        py.detach(|| {
            let read = form.read(&bytes).map_err(in_file)?;
            let text = match form {
                ProgramForm::Toml => String::from_utf8_lossy(&bytes).into_owned(),
                _ => read.content.to_toml(),
            };
            let name = file.file_stem().unwrap_or_default().to_string_lossy();
            let folder = file.parent().unwrap_or(Path::new(""));
            Self::new(text, &name, folder, read.warnings).map_err(in_file)
        })
    }

    /// Parses the text of a program; the files that it uses are in a folder.
    #[staticmethod]
    fn of_text(text: String, folder: PathBuf) -> PyResult<Self> {
        Self::new(text, UNNAMED, &folder, Vec::new()).map_err(|error| value_error(&error))
    }

    /// Creates a program from a JSON object with the keys of a program's text.
    #[staticmethod]
    fn of_json(json: &str, folder: PathBuf) -> PyResult<Self> {
        let value: Value = serde_json::from_str(json).map_err(|error| value_error(&error))?;
        let text = toml::to_string(&value).map_err(|error| value_error(&error))?;
        let program = Program::from_toml(&text)
            .map_err(|error| PyValueError::new_err(numbered(&text, &error)))?;
        Self::new(program.to_toml(), UNNAMED, &folder, Vec::new())
            .map_err(|error| value_error(&error))
    }

    /// Creates a program of straight lines along a recorded path, with the fewest points within a
    /// tolerance in mm. A place is x, y and z (mm), the rotation (degrees), the pump and the
    /// gripper (degrees).
    #[staticmethod]
    fn of_path(
        py: Python<'_>,
        title: String,
        places: Vec<([f64; 3], f64, bool, f64)>,
        tolerance_mm: f64,
    ) -> PyResult<Self> {
        if !(0.0..=MAX_TOLERANCE_MM).contains(&tolerance_mm) {
            return Err(PyValueError::new_err(format!(
                "tolerance is {tolerance_mm}; allowed are 0 to {MAX_TOLERANCE_MM} mm"
            )));
        }
        py.detach(|| {
            let recorded = |(point_mm, rotation_deg, suction, gripper_deg)| RecordedPlace {
                point_mm,
                rotation_deg,
                suction,
                gripper_deg,
            };
            let places: Vec<RecordedPlace> = places.into_iter().map(recorded).collect();
            let mut steps = path_steps(&simplified(&places, tolerance_mm), ToolState::default());
            if let Some(Action::Go(first)) = steps.first_mut() {
                // From wherever the arm is, and allowed where it is already.
                first.path = MovingMode::Jump;
            }
            let steps = steps.into_iter().map(|step| Spanned::new(0..0, step));
            let mut program = Program::default();
            program.title = title;
            program.steps = Steps(steps.collect());
            Self::new(program.to_toml(), UNNAMED, Path::new(""), Vec::new())
                .map_err(|error| value_error(&error))
        })
    }

    /// Restores a program from its [`parts`](Self::parts).
    #[staticmethod]
    fn of_parts(
        text: String,
        name: &str,
        folder: PathBuf,
        warnings: Vec<String>,
    ) -> PyResult<Self> {
        Self::new(text, name, &folder, warnings).map_err(|error| value_error(&error))
    }

    /// Returns the text, the name, the folder of its files and the warnings, for pickling.
    fn parts(&self) -> (&str, &str, &Path, Vec<String>) {
        let Source { name, folder, .. } = &*self.source;
        (&self.text, name, folder, self.warnings.clone())
    }

    /// Returns the JSON Schema of a program.
    #[staticmethod]
    fn schema() -> String {
        Program::schema().to_string()
    }

    #[getter]
    fn title(&self) -> &str {
        self.source.title()
    }

    #[getter]
    fn steps(&self) -> usize {
        self.source.program.steps.0.len()
    }

    #[getter]
    fn text(&self) -> &str {
        &self.text
    }

    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.warnings.clone()
    }

    /// Writes a file, and returns what its format cannot represent.
    fn save(&self, py: Python<'_>, file: PathBuf) -> PyResult<Vec<String>> {
        let (text, lost) = match form_of(&file)? {
            ProgramForm::Toml => (self.text.clone(), Vec::new()),
            form => {
                let written = py.detach(|| {
                    let arm = PlannedFor::any(Rules::of(&Policy::default()).into(), None);
                    form.write(&self.source.program, &mut self.source.files(&arm))
                });
                let written = written.map_err(|error| value_error(&error))?;
                (written.content, written.warnings)
            }
        };
        fs::write(&file, text).map_err(|error| file_error(&error, &file))?;
        Ok(lost)
    }

    /// Returns the problems and durations for any arm of a dialect, as a JSON object.
    fn check(&self, py: Python<'_>, dialect: Option<&str>) -> PyResult<String> {
        let dialect = dialect.map(str::parse::<Dialect>).transpose();
        let dialect = dialect.map_err(|error| value_error(&error))?;
        py.detach(|| {
            let arm = PlannedFor::any(Rules::of(&Policy::default()).into(), dialect);
            self.source
                .report(&arm)
                .map_err(|error| value_error(&error))
        })
    }
}

impl Taught {
    fn new(
        text: String,
        name: &str,
        folder: &Path,
        warnings: Vec<String>,
    ) -> Result<Self, ProgramError> {
        let source = Source {
            program: Program::from_toml(&text)?,
            name: name.to_owned(),
            folder: folder.to_owned(),
        };
        Ok(Self {
            source: Arc::new(source),
            text,
            warnings,
        })
    }
}

impl Source {
    fn title(&self) -> &str {
        match self.program.title.as_str() {
            "" => &self.name,
            title => title,
        }
    }

    /// Returns the files that it uses, with drawings for an arm.
    fn files(&self, arm: &PlannedFor) -> impl Files {
        let read = |path: &str| {
            fs::read(self.folder.join(path)).map_err(|error| format!("cannot read {path}: {error}"))
        };
        ProgramFiles::new(read, arm.dialect(), arm.calibration.clone())
    }

    /// Returns the program with a title.
    fn titled(&self) -> Program {
        let mut program = self.program.clone();
        self.title().clone_into(&mut program.title);
        program
    }

    /// Returns the problems and durations for an arm, as a JSON object.
    pub(crate) fn report(&self, arm: &PlannedFor) -> Result<String, ProgramError> {
        let program = self.titled();
        let (compiled, report) = dry_run_program(&program, arm, &mut self.files(arm))?;
        let steps = compiled.steps.iter().zip(&report.steps_s);
        let steps: Vec<Value> = steps
            .map(|(step, takes_s)| json!({"label": *step.label, "file": step.file.as_deref(), "line": step.line, "takes_s": takes_s}))
            .collect();
        Ok(json!({
            "steps": steps,
            "problems": report.problems,
            "once_s": report.first_s,
            "cycle_s": report.cycle_s,
            "total_s": report.total_s,
            "depends_on_answers": report.depends_on_answers,
        })
        .to_string())
    }
}

/// A program to be run.
pub(crate) struct Run {
    pub(crate) source: Arc<Source>,
    /// The number of repetitions; by default that of the program.
    pub(crate) times: Option<Times>,
    /// The first step to execute, counted from 1.
    pub(crate) from_step: usize,
    /// Whether the caller answers its questions.
    pub(crate) asks: bool,
}

impl Run {
    /// Returns the job for an arm, if the program has no problems.
    pub(crate) fn job(&self, arm: &PlannedFor) -> Result<NewJob, Problem> {
        let (program, mut files) = (self.source.titled(), self.source.files(arm));
        let start = ProgramStart::Step(self.from_step);
        let job = program_job(&program, self.times, start, arm, &mut files);
        job.map_err(|error| match error {
            ProgramJobError::NoStep { .. } => OUT_OF_RANGE.problem(error.to_string()),
            error => BAD_PROGRAM.problem(error.to_string()),
        })
    }
}

fn form_of(file: &Path) -> PyResult<ProgramForm> {
    let name = file.to_string_lossy();
    ProgramForm::of_name(&name).ok_or_else(|| {
        PyValueError::new_err(format!(
            "{name} is not a program; program files end in .toml, .xml, .play or .playback"
        ))
    })
}

/// Returns the error with the number of the step, since the generated text has no visible lines.
fn numbered(text: &str, error: &ProgramError) -> String {
    let lines = text.lines().take(error.line.unwrap_or(0));
    match lines.filter(|line| *line == "[[steps]]").count() {
        0 => error.reason.clone(),
        step => format!("step {step}: {}", error.reason),
    }
}

/// A coarser path would have little to do with the recorded one.
const MAX_TOLERANCE_MM: f64 = 50.0;

/// The name of a program with neither a title nor a file.
const UNNAMED: &str = "program";
