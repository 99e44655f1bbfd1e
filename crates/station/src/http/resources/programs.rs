//! Taught programs as texts: checked, edited step by step, and converted to jobs.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;

use dobot_api::problem_kinds::{BAD_PROGRAM, OUT_OF_RANGE};
use dobot_api::{NewJob, Problem};
use dobot_draw::ProgramFiles;
use dobot_host::{PlannedFor, ProgramJobError, ProgramStart, dry_run_program, program_job};
use dobot_teach::{
    Action, CompiledStep, Files, Frame, Go, GridSize, Point, Program, ProgramDocument,
    ProgramError, ProgramForm, RecordedPlace, Steps, TaughtGrid, Times, ToolState, path_steps,
    simplified, with_content,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A program, with the files that it uses.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ProgramText {
    /// Its TOML text.
    text: String,
    /// The texts of the programs that it calls and of its drawings, by the names used in it.
    #[serde(default)]
    files: BTreeMap<String, String>,
}

/// The steps and problems of a program.
#[derive(Clone, Debug, Default, Serialize, JsonSchema)]
pub(crate) struct ProgramReport {
    /// Its title.
    title: String,
    /// Its steps, in execution order; the steps of a final repeat are listed once.
    steps: Vec<StepReport>,
    /// All problems, in the order of the steps or, of a text that cannot be parsed, of its lines.
    problems: Vec<ProgramProblem>,
    /// The duration of the first pass through all steps, in seconds, from the current position of
    /// the arm; null if there are problems.
    once_s: Option<f64>,
    /// The duration of each further cycle, in seconds; null if nothing is repeated or there are
    /// problems.
    cycle_s: Option<f64>,
    /// The total duration, in seconds; null if it repeats until a person ends it or there are
    /// problems.
    total_s: Option<f64>,
    /// Whether the program asks while it runs: then steps and durations are those with the first
    /// answer to each question.
    depends_on_answers: bool,
}

/// A step of a program.
#[derive(Clone, Debug, Serialize, JsonSchema)]
struct StepReport {
    /// Its description.
    label: String,
    /// The called program that contains it; absent for the program itself.
    file: Option<String>,
    /// The line on which it begins, counted from 1.
    line: usize,
    /// Its first command in the job, counted from 0.
    first: usize,
    /// Its duration the first time, in seconds.
    takes_s: f64,
}

/// A problem of a program.
#[derive(Clone, Debug, Serialize, JsonSchema)]
struct ProgramProblem {
    /// The step, counted from 1 in execution order; absent if the text cannot be parsed.
    step: Option<usize>,
    /// The called program that contains it; absent for the program itself.
    file: Option<String>,
    /// The line, counted from 1, if it is known.
    line: Option<usize>,
    /// The problem, and what is allowed.
    message: String,
    /// The remedy.
    remedy: Option<String>,
}

/// A program to be queued as a job.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct NewProgram {
    /// The program.
    program: ProgramText,
    /// The first step to execute, counted from 1 in execution order; by default 1.
    #[serde(default)]
    #[schemars(range(min = 1))]
    from_step: Option<usize>,
    /// Instead of `from_step`, a line of the text, counted from 1: it starts at the first step on
    /// this line or after it, following the answers that lead there.
    #[serde(default)]
    #[schemars(range(min = 1))]
    from_line: Option<usize>,
    /// The number of repetitions; by default that of the program.
    #[serde(default)]
    times: Option<Repeat>,
    /// The number of the stored file that contains the program, for which the job is noted.
    #[serde(default)]
    pub(crate) stored: Option<u64>,
}

/// The number of repetitions of a program.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Repeat {
    /// This many passes in total, 1 or more.
    Count(#[schemars(range(min = 1))] u64),
    /// Until a person ends it.
    Forever,
}

/// Edits of a program's text.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct EditProgram {
    /// The text; an empty text starts a new program.
    #[serde(default)]
    text: String,
    /// The edits, in order; either all of them are made or none.
    #[schemars(length(max = 1000))]
    edits: Vec<Edit>,
}

/// An edit of a program's text; unchanged parts keep their comments and their format. Steps are
/// those of the program itself, counted from 0.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
enum Edit {
    /// Inserts a step before the one with this number, or after the last one.
    Insert {
        /// The number of the new step.
        at: usize,
        /// The step.
        step: Action,
    },
    /// Inserts a jogged path: straight lines through as few of its points as keep it within the
    /// tolerance.
    InsertPath {
        /// The number of the first new step.
        at: usize,
        /// Its points, in order.
        #[schemars(length(max = 100_000))]
        places: Vec<RecordedPlace>,
        /// The maximum distance of the lines from the points, in mm.
        #[schemars(range(min = 0.01, max = 50.0))]
        tolerance_mm: f64,
    },
    /// Replaces a step.
    Replace {
        /// The number of the step.
        at: usize,
        /// The new step.
        step: Action,
    },
    /// Removes a step.
    Remove {
        /// The number of the step.
        at: usize,
    },
    /// Moves a step to another number.
    Move {
        /// The number of the step.
        from: usize,
        /// Its new number.
        to: usize,
    },
    /// Sets a named point, which may be new.
    SetPoint {
        /// Its name.
        name: String,
        /// Its position.
        point: Point,
    },
    /// Renames a point, also where it is used.
    RenamePoint {
        /// Its name.
        name: String,
        /// Its new name.
        to: String,
    },
    /// Sets a grid from three touched corners, with a frame of its name; both may be new. A new
    /// program visits its cells.
    SetGrid {
        /// Its name.
        name: String,
        /// The first cell, the end of the first row and the end of the first column.
        corners: [RecordedPlace; 3],
        /// The number of its cells.
        size: GridSize,
    },
    /// Sets a frame from three touched places, which may be new.
    SetFrame {
        /// Its name.
        name: String,
        /// The origin, a place on the x axis and one on the side of the y axis.
        places: [RecordedPlace; 3],
    },
}

/// The text of a program.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub(crate) struct EditedProgram {
    /// The text.
    text: String,
    /// The number of steps.
    steps: usize,
}

/// The content of a program, to be put into a text.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct MergeProgram {
    /// The text, with its comments and its format.
    text: String,
    /// The new content, as TOML; it may have problems, and keys that no program has.
    content: String,
}

/// The text with the new content.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub(crate) struct MergedProgram {
    /// The text.
    text: String,
}

/// Puts the content of a program into a text.
pub(crate) fn merge(asked: &MergeProgram) -> Result<MergedProgram, Problem> {
    let text = with_content(&asked.text, &asked.content);
    let text = text.map_err(|error| BAD_PROGRAM.problem(error.to_string()))?;
    Ok(MergedProgram { text })
}

/// A program to be converted to another format.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ConvertProgram {
    /// Its text; a file of the vendor's software has bytes instead.
    #[serde(default)]
    text: Option<String>,
    /// The bytes of a file, in Base64.
    #[serde(default)]
    data: Option<String>,
    /// The format of the bytes; a text is a program.
    #[serde(default)]
    from: ProgramForm,
    /// The texts of the programs that it calls and of its drawings, by the names used in it.
    #[serde(default)]
    files: BTreeMap<String, String>,
    /// The target format.
    to: ProgramForm,
}

/// A converted program.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub(crate) struct ConvertedProgram {
    /// The text.
    text: String,
    /// Unexpected contents, and what the target format cannot represent.
    warnings: Vec<String>,
}

/// Converts a program to another format, for an arm with this dialect and calibration.
pub(crate) fn convert(
    asked: &ConvertProgram,
    arm: &PlannedFor,
) -> Result<ConvertedProgram, Problem> {
    let bad = |error: ProgramError| BAD_PROGRAM.problem(error.to_string());
    let bytes = match (&asked.text, &asked.data) {
        (Some(text), None) => text.clone().into_bytes(),
        (None, Some(data)) => data_encoding::BASE64
            .decode(data.as_bytes())
            .map_err(|error| BAD_PROGRAM.problem(format!("data is not base64: {error}")))?,
        _ => return Err(BAD_PROGRAM.problem("give either text or data")),
    };
    let program = asked.from.read(&bytes).map_err(bad)?;
    let written = asked
        .to
        .write(&program.content, &mut program_files(&asked.files, arm))
        .map_err(bad)?;
    let mut warnings = program.warnings;
    warnings.extend(written.warnings);
    Ok(ConvertedProgram {
        text: written.content,
        warnings,
    })
}

/// Checks a whole program.
pub(crate) fn report(program: &ProgramText, arm: &PlannedFor) -> ProgramReport {
    let mut files = program_files(&program.files, arm);
    let checked = Program::from_toml(&program.text)
        .and_then(|program| dry_run_program(&program, arm, &mut files));
    let (compiled, found) = match checked {
        Ok(checked) => checked,
        Err(error) => {
            return ProgramReport {
                problems: mistakes(error),
                ..ProgramReport::default()
            };
        }
    };
    let steps = compiled.steps.iter().zip(&found.steps_s);
    ProgramReport {
        steps: steps.map(step_report).collect(),
        problems: found.problems.into_iter().map(problem).collect(),
        once_s: found.first_s,
        cycle_s: found.cycle_s,
        total_s: found.total_s,
        depends_on_answers: found.depends_on_answers,
        title: compiled.title,
    }
}

fn step_report((step, &takes_s): (&CompiledStep, &f64)) -> StepReport {
    StepReport {
        label: step.label.to_string(),
        file: step.file.as_deref().map(str::to_owned),
        line: step.line,
        first: step.first,
        takes_s,
    }
}

/// The mistakes of a text that is not a program.
fn mistakes(mut error: ProgramError) -> Vec<ProgramProblem> {
    let others = std::mem::take(&mut error.others);
    let all = std::iter::once(error).chain(others);
    all.map(|error| ProgramProblem {
        step: None,
        file: error.file,
        line: error.line,
        message: error.reason,
        remedy: None,
    })
    .collect()
}

fn problem(found: dobot_teach::Problem) -> ProgramProblem {
    ProgramProblem {
        step: Some(found.step),
        file: found.file,
        line: Some(found.line),
        message: found.message,
        remedy: Some(found.remedy),
    }
}

/// Returns the job of a program.
pub(crate) fn job(new: &NewProgram, arm: &PlannedFor) -> Result<NewJob, Problem> {
    let bad = |error: ProgramError| BAD_PROGRAM.problem(error.to_string());
    let times = match new.times {
        Some(Repeat::Count(0)) => {
            return Err(OUT_OF_RANGE.problem("times is 0; allowed are 1 or more, or forever"));
        }
        Some(Repeat::Count(count)) => Some(Times::Count(count)),
        Some(Repeat::Forever) => Some(Times::Forever),
        None => None,
    };
    let start = match (new.from_step, new.from_line) {
        (Some(_), Some(_)) => {
            return Err(OUT_OF_RANGE.problem("both from_step and from_line are given; give one"));
        }
        (None, Some(line)) => ProgramStart::Line(line),
        (step, None) => ProgramStart::Step(step.unwrap_or(1)),
    };
    let program = Program::from_toml(&new.program.text).map_err(bad)?;
    let mut files = program_files(&new.program.files, arm);
    let job = program_job(&program, times, start, arm, &mut files);
    job.map_err(|error| match error {
        ProgramJobError::Problems(problems) => {
            let first = problems.into_iter().next().map(|first| {
                let (step, line, what) = (first.step, first.line, first.message);
                BAD_PROGRAM.hinted(format!("step {step} (line {line}): {what}"), first.remedy)
            });
            first.unwrap_or_else(|| BAD_PROGRAM.problem("the program has problems"))
        }
        error @ (ProgramJobError::NoStep { .. } | ProgramJobError::NoStepAtLine { .. }) => {
            OUT_OF_RANGE.problem(error.to_string())
        }
        error => BAD_PROGRAM.problem(error.to_string()),
    })
}

/// Edits the text of a program.
pub(crate) fn edit(asked: EditProgram) -> Result<EditedProgram, Problem> {
    asked.edits.iter().try_for_each(check_tolerance)?;
    let bad = |error: ProgramError| BAD_PROGRAM.problem(error.to_string());
    let mut edits = asked.edits.into_iter();
    let mut document = if asked.text.trim().is_empty() {
        begin(edits.next())?
    } else {
        ProgramDocument::new(&asked.text).map_err(bad)?
    };
    for (index, edit) in edits.enumerate() {
        let numbered = |error: ProgramError| BAD_PROGRAM.problem(format!("edit {index}: {error}"));
        apply(&mut document, edit).map_err(numbered)?;
    }
    Ok(EditedProgram {
        steps: document.steps(),
        text: document.text(),
    })
}

fn check_tolerance(edit: &Edit) -> Result<(), Problem> {
    if let Edit::InsertPath { tolerance_mm, .. } = edit
        && !TOLERANCE_MM.contains(tolerance_mm)
    {
        let (least, most) = (TOLERANCE_MM.start(), TOLERANCE_MM.end());
        return Err(OUT_OF_RANGE.problem(format!(
            "tolerance_mm is {tolerance_mm}; allowed are {least} to {most}"
        )));
    }
    Ok(())
}

/// Starts a new program with the first edit.
fn begin(first: Option<Edit>) -> Result<ProgramDocument, Problem> {
    let bad = |error: ProgramError| BAD_PROGRAM.problem(error.to_string());
    if let Some(Edit::SetGrid {
        name,
        corners,
        size,
    }) = &first
    {
        return begin_grid(name, corners, *size).map_err(bad);
    }
    let actions = match first {
        Some(Edit::Insert { at: 0, step }) => vec![step],
        Some(Edit::InsertPath {
            at: 0,
            places,
            tolerance_mm,
        }) => path_steps(&simplified(&places, tolerance_mm), ToolState::default()),
        _ => Vec::new(),
    };
    if actions.is_empty() {
        return Err(BAD_PROGRAM
            .problem("the text is empty; begin a new program with an edit that inserts at 0"));
    }
    let text = Program::new(actions).to_toml();
    ProgramDocument::new(&text).map_err(bad)
}

/// Starts a new program that visits all points of a grid.
fn begin_grid(
    name: &str,
    corners: &[RecordedPlace; 3],
    size: GridSize,
) -> Result<ProgramDocument, ProgramError> {
    let visit = Action::Each(vec![name.to_owned()], Steps::new(vec![visit(name)]));
    let taught = TaughtGrid::of(name, corners, size)?;
    let mut program = Program::new(vec![visit]);
    program.frames.insert(name.to_owned(), taught.frame);
    program.grids.insert(name.to_owned(), taught.grid);
    ProgramDocument::new(&program.to_toml())
}

fn visit(grid: &str) -> Action {
    Action::Go(Go::to(grid))
}

fn apply(document: &mut ProgramDocument, edit: Edit) -> Result<(), ProgramError> {
    match edit {
        Edit::Insert { at, step } => document.insert(&[at], step),
        Edit::InsertPath {
            at,
            places,
            tolerance_mm,
        } => insert_path(document, at, &simplified(&places, tolerance_mm)),
        Edit::Replace { at, step } => document.replace(&[at], step),
        Edit::Remove { at } => document.remove(&[at]),
        Edit::Move { from, to } => document.move_step(&[from], &[to]),
        Edit::SetPoint { name, point } => document.set_point(&name, &point),
        Edit::RenamePoint { name, to } => document.rename_point(&name, &to),
        Edit::SetGrid {
            name,
            corners,
            size,
        } => {
            let taught = TaughtGrid::of(&name, &corners, size)?;
            document.set_frame(&name, &taught.frame)?;
            document.set_grid(&name, &taught.grid)
        }
        Edit::SetFrame { name, places } => document.set_frame(&name, &Frame::touched(&places)),
    }
}

fn insert_path(
    document: &mut ProgramDocument,
    at: usize,
    places: &[RecordedPlace],
) -> Result<(), ProgramError> {
    let steps = document.program()?.steps.0;
    let before = ToolState::behind(&steps[..at.min(steps.len())]);
    let mut path = path_steps(places, before).into_iter().enumerate();
    path.try_for_each(|(index, step)| document.insert(&[at + index], step))
}

/// Returns the files that came with a program.
fn program_files(files: &BTreeMap<String, String>, arm: &PlannedFor) -> impl Files {
    let read = |path: &str| match files.get(path) {
        Some(text) => Ok(text.clone().into_bytes()),
        None => Err(format!("{path} is missing; add it to `files`")),
    };
    ProgramFiles::new(read, arm.dialect(), arm.calibration.clone())
}

/// The allowed distance of the lines of a path from its points.
const TOLERANCE_MM: RangeInclusive<f64> = 0.01..=50.0;
