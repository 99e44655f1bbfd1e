//! Failures, and their exceptions.

use std::borrow::Cow;
use std::path::Path;
use std::{fmt, io};

use dobot_api::{ConnectError, Problem, RemoteError, problem_kinds};
use dobot_host::NoArm;
use pyo3::exceptions::{PyOSError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// The reason why an operation failed.
#[derive(Debug)]
pub(crate) enum Failure {
    Refused(Box<Problem>),
    Failed {
        text: String,
        hint: Option<String>,
    },
    /// A job is paused and can be resumed.
    Paused {
        job: u64,
        text: String,
    },
    LinkLost {
        text: String,
        hint: Option<String>,
    },
    Stopped,
    Closed,
    Forked,
    NoMoreStatuses,
}

impl Failure {
    /// Returns the name of its exception.
    pub(crate) const fn class(&self) -> &'static str {
        match self {
            Self::Refused(_) => "Refused",
            Self::Failed { .. } => "Failed",
            Self::Paused { .. } => "Paused",
            Self::LinkLost { .. } => "LinkLost",
            Self::Stopped => "Stopped",
            Self::Closed | Self::Forked | Self::NoMoreStatuses => "Closed",
        }
    }

    /// Returns the remedy.
    fn hint(&self) -> Option<Cow<'_, str>> {
        match self {
            Self::Refused(problem) => problem.hint.as_deref().map(in_python_calls),
            Self::Failed { hint, .. } | Self::LinkLost { hint, .. } => {
                hint.as_deref().map(in_python_calls)
            }
            Self::Paused { .. } => {
                Some("resume it with `arm.resume()`, or cancel it with `arm.cancel()`".into())
            }
            Self::Stopped => Some("when the arm may move again, call `arm.reset_stop()`".into()),
            Self::Closed | Self::Forked | Self::NoMoreStatuses => {
                Some("connect again with `dobot_arm.connect(...)`".into())
            }
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Refused(problem) => f.write_str(&in_python_terms(&problem.detail)),
            Self::Failed { text, .. } | Self::Paused { text, .. } | Self::LinkLost { text, .. } => {
                f.write_str(text)
            },
            Self::Stopped => f.write_str("the arm was stopped during the operation"),
            Self::Closed => f.write_str("the arm was disconnected"),
            Self::NoMoreStatuses => f.write_str(
                "there are no more statuses: the arm was disconnected, or more than an hour of statuses was not read",
            ),
            Self::Forked => f.write_str(
                "the arm belongs to the process that connected to it, and this is a fork of it",
            ),
        }
    }
}

impl From<RemoteError> for Failure {
    fn from(error: RemoteError) -> Self {
        let hint = error.hint();
        let text = error.to_string();
        match error {
            RemoteError::Refused(problem) => Self::Refused(problem),
            RemoteError::Failed(_) => Self::Failed { text, hint },
            _ => Self::LinkLost { text, hint },
        }
    }
}

impl From<ConnectError> for Failure {
    fn from(error: ConnectError) -> Self {
        let hint = error.hint();
        match error {
            ConnectError::Refused(problem) => Self::Refused(problem),
            other => lost(&other, hint),
        }
    }
}

impl From<NoArm> for Failure {
    fn from(error: NoArm) -> Self {
        match error {
            NoArm::Silent(error) => error.into(),
            other => Self::LinkLost {
                text: other.to_string(),
                hint: other.hint(),
            },
        }
    }
}

/// Returns all problem types: name, title, and explanation.
#[pyfunction]
#[pyo3(name = "problem_kinds")]
pub(crate) fn kinds() -> Vec<(&'static str, &'static str, &'static str)> {
    let kinds = problem_kinds::ALL.iter();
    kinds
        .map(|kind| (kind.name, kind.title, kind.explanation))
        .collect()
}

/// Returns the exception of `dobot_arm.errors` for a failure.
pub(crate) fn exception(py: Python<'_>, failure: &Failure) -> PyErr {
    let made = || -> PyResult<PyErr> {
        let fields = PyDict::new(py);
        fields.set_item("hint", failure.hint())?;
        if let Failure::Refused(problem) = failure {
            fields.set_item("kind", problem.name())?;
            fields.set_item("rule", &problem.rule)?;
            fields.set_item("at_mm", problem.at_mm.map(<(f64, f64, f64)>::from))?;
            fields.set_item(
                "nearest_mm",
                problem.nearest_mm.map(<(f64, f64, f64)>::from),
            )?;
        }
        if let Failure::Paused { job, .. } = failure {
            fields.set_item("job", job)?;
        }
        let class = py.import("dobot_arm.errors")?.getattr(failure.class())?;
        let error = class.call((failure.to_string(),), Some(&fields))?;
        Ok(PyErr::from_value(error))
    };
    made().unwrap_or_else(|error| error)
}

/// Replaces the number and the table of a float in a command by the name of the argument.
///
/// `float 9 (GripperValue) is 500; Table 3.7 allows -90 to 90 (degrees)` becomes
/// `gripper is 500; allowed are -90 to 90 (degrees)`.
fn in_python_terms(detail: &str) -> Cow<'_, str> {
    let parts = || {
        let (before, float) = detail.split_once("float ")?;
        let (_, named) = float.split_once(" (")?;
        let (name, found) = named.split_once(") is ")?;
        let (found, allowed) = found.split_once("; ")?;
        let (_, allowed) = allowed.split_once(" allows ")?;
        let (_, argument) = ARGUMENTS.iter().find(|(float, _)| *float == name)?;
        Some(format!(
            "{before}{argument} is {found}; allowed is {allowed}"
        ))
    };
    if let Some(rest) = detail.strip_prefix("for_s is ") {
        return Cow::Owned(format!("seconds is {rest}"));
    }
    parts().map_or(Cow::Borrowed(detail), Cow::Owned)
}

/// Replaces the commands of the program in a hint by calls, and removes the requests of the API.
///
/// ``confirm it: `dobot confirm` or `POST /api/v1/pose/confirm` `` becomes
/// ``confirm it: `arm.confirm_pose()` ``.
fn in_python_calls(hint: &str) -> Cow<'_, str> {
    let mut parts = hint.split(" or `");
    let mut text = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        match part.split_once('`') {
            Some((request, rest)) if request.contains(" /api/v1/") => text.push_str(rest),
            _ => {
                text.push_str(" or `");
                text.push_str(part);
            }
        }
    }
    for (command, call) in CALLS {
        text = text.replace(command, call);
    }
    text.into()
}

/// The commands of the program in hints, and the calls that do the same.
const CALLS: [(&str, &str); 11] = [
    ("`dobot confirm`", "`arm.confirm_pose()`"),
    ("`dobot stop --reset`", "`arm.reset_stop()`"),
    ("`dobot stop`", "`arm.stop()`"),
    ("`dobot policy`", "`arm.state().policy`"),
    ("`dobot lease ask`", "`arm.request_control()`"),
    ("`dobot lease`", "`arm.state().control`"),
    ("`dobot jobs`", "`arm.state().jobs`"),
    ("`dobot watch`", "`arm.state().link`"),
    ("`dobot set percent`", "`arm.speed(...)`"),
    (
        "`--dialect firmware-1.1`",
        "`connect(..., dialect=\"firmware-1.1\")`",
    ),
    (
        "arm the laser from the client that uses it: `--arm-laser 600` of `dobot jog` and `dobot jobs start`,",
        "arm the laser: `arm.arm_laser(60)`",
    ),
];

/// The floats of commands, and the arguments of the Python package.
const ARGUMENTS: [(&str, &str); 32] = [
    ("X", "x"),
    ("Y", "y"),
    ("Z", "z"),
    ("RHead", "the rotation"),
    ("GripperValue", "gripper"),
    ("PauseTime", "pause"),
    ("StartVel", "start_speed"),
    ("EndVel", "end_speed"),
    ("MaxVel", "speed"),
    ("StarVel", "speed"),
    ("Joint1 angle", "base"),
    ("Joint2 angle", "rear"),
    ("Joint3 angle", "fore"),
    ("joint2 angle", "rear"),
    ("joint3 angle", "fore"),
    ("playback speed", "velocity"),
    ("playback acceleration", "acceleration"),
    ("JUMP height", "jump_height"),
    ("default pause time", "pause"),
    ("joint jog speed", "joint_speed"),
    ("joint jog acceleration", "joint_acceleration"),
    ("joint 4 speed", "servo_speed"),
    ("joint 4 acceleration", "servo_acceleration"),
    ("linear jog speed", "linear_speed"),
    ("linear jog acceleration", "linear_acceleration"),
    ("max joint moving speed", "joint_speed"),
    ("max joint moving acceleration", "joint_acceleration"),
    ("max linear moving speed", "linear_speed"),
    ("max linear moving acceleration", "linear_acceleration"),
    ("max servo speed", "servo_speed"),
    ("max servo acceleration", "servo_acceleration"),
    ("writing acceleration", "acceleration"),
];

/// Returns the exception for a file, with its name.
pub(crate) fn file_error(error: &io::Error, file: &Path) -> PyErr {
    match error.raw_os_error() {
        // Python selects the class by the number.
        Some(number) => {
            PyOSError::new_err((number, plain_text(error), file.as_os_str().to_owned()))
        }
        None => PyOSError::new_err(format!("{}: {error}", file.display())),
    }
}

/// Returns the text of an error without its number.
fn plain_text(error: &io::Error) -> String {
    let text = error.to_string();
    let text = text
        .split_once(" (os error")
        .map_or(&*text, |(text, _)| text);
    text.to_owned()
}

pub(crate) fn lost(error: &dyn std::error::Error, hint: Option<String>) -> Failure {
    let text = error.to_string();
    Failure::LinkLost { text, hint }
}

pub(crate) const fn failed(text: String) -> Failure {
    Failure::Failed { text, hint: None }
}

/// Returns the exception for an invalid value.
pub(crate) fn value_error(why: &dyn fmt::Display) -> PyErr {
    PyValueError::new_err(why.to_string())
}
