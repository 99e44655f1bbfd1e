//! Operations in progress, and incoming statuses: a call waits for them without the interpreter's
//! lock.

use std::sync::Arc;
use std::thread;
use std::time::Duration;

use dobot_api::{Answer, GivenPlace, Sense};
use dobot_geometry::CancelToken;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString, PyTuple};

use crate::failure::{Failure, exception};
use crate::mailbox::{Mailbox, Received};
use crate::worker::{Operation, Outcome, Progress, Report, Seen, Worker};

/// An operation in progress.
#[pyclass(frozen)]
pub(crate) struct Pending {
    pub(crate) reports: Arc<Mailbox<Report>>,
    pub(crate) worker: Arc<Worker>,
}

#[pymethods]
impl Pending {
    /// Waits without the interpreter's lock. Ctrl-C stops the arm first, and so does an exception
    /// in `progress`, which is called with the number of completed commands and the number of
    /// commands.
    fn wait<'py>(
        &self,
        py: Python<'py>,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        loop {
            let called = match py.detach(|| self.reports.receive(SIGNALS)) {
                Received::Message(Report::Over(Ok(outcome))) => return read(py, outcome),
                Received::Message(Report::Over(Err(failure))) => {
                    return Err(exception(py, &failure));
                }
                Received::Message(Report::Progress(part)) => match progress {
                    Some(callback) => counts(py, part)
                        .and_then(|part| callback.call1(part))
                        .map(drop),
                    None => Ok(()),
                },
                Received::Message(Report::Question(text)) => match progress {
                    Some(callback) => callback.call1((text,)).map(drop),
                    None => Ok(()),
                },
                Received::Closed => return Err(exception(py, &Failure::Closed)),
                Received::Nothing => Ok(()),
            };
            if let Err(interrupt) = called.and_then(|()| py.check_signals()) {
                let reason = format!("Python was interrupted: {interrupt}");
                let stopped = self.worker.stop(Some(reason));
                // Whatever the result, the interrupt is raised.
                py.detach(|| stopped.receive(STOPPED));
                return Err(interrupt);
            }
        }
    }

    /// Returns the latest message without waiting: nothing, the progress, or the result.
    fn poll<'py>(&self, py: Python<'py>) -> PyResult<Polled<'py>> {
        match self.reports.receive(Duration::ZERO) {
            Received::Message(Report::Over(Ok(outcome))) => Ok((None, Some(read(py, outcome)?))),
            Received::Message(Report::Over(Err(failure))) => Err(exception(py, &failure)),
            Received::Message(Report::Progress(part)) => Ok((Some(counts(py, part)?), None)),
            Received::Message(Report::Question(text)) => {
                Ok((Some((text,).into_pyobject(py)?), None))
            }
            Received::Closed => Err(exception(py, &Failure::Closed)),
            Received::Nothing => Ok((None, None)),
        }
    }

    /// Answers the question of a program: one of its answers, or a position in mm and degrees.
    /// With `seen` a camera has located it.
    fn answer(&self, choice: Option<String>, place: Option<[f64; 4]>, seen: bool) {
        let answer = match (choice, place) {
            (Some(choice), _) => Answer::Choice(choice),
            (None, Some([x_mm, y_mm, z_mm, rotation_deg])) => Answer::Place(GivenPlace {
                name: None,
                x_mm,
                y_mm,
                z_mm,
                rotation_deg,
                sense: seen.then_some(Sense::Camera),
            }),
            (None, None) => Answer::Skip,
        };
        self.worker.answer(answer);
    }

    /// Calls this once, in another thread, when there is something to poll.
    fn when_ready(&self, wake: Py<PyAny>) {
        self.reports.when_ready(calling(wake));
    }
}

/// The progress, and the result.
type Polled<'py> = (Option<Bound<'py, PyTuple>>, Option<Bound<'py, PyAny>>);

/// Converts a result: an empty dictionary, a status as one, or the text of a JSON value.
fn read(py: Python<'_>, outcome: Outcome) -> PyResult<Bound<'_, PyAny>> {
    Ok(match outcome {
        Outcome::Nothing => PyDict::new(py).into_any(),
        Outcome::Status(seen) => dict(py, seen)?.into_any(),
        Outcome::Json(text) => PyString::new(py, &text).into_any(),
    })
}

/// Returns the arguments of `progress`.
fn counts(py: Python<'_>, part: Progress) -> PyResult<Bound<'_, PyTuple>> {
    match part {
        Progress::Commands {
            completed,
            commands,
        } => (completed, commands).into_pyobject(py),
        Progress::Steps {
            step,
            steps,
            cycle,
            cycles,
        } => (step, steps, cycle, cycles).into_pyobject(py),
    }
}

/// All statuses from the time of the request.
#[pyclass(frozen)]
pub(crate) struct Statuses {
    pub(crate) statuses: Arc<Mailbox<Seen>>,
    pub(crate) worker: Arc<Worker>,
}

#[pymethods]
impl Statuses {
    /// Waits for the next status; virtual time passes meanwhile. Returns an empty dictionary to
    /// check for Ctrl-C.
    fn next<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let mut asked = None;
        loop {
            let time = if asked.is_none() {
                Duration::ZERO
            } else {
                SIGNALS
            };
            match py.detach(|| self.statuses.receive(time)) {
                Received::Message(status) => return dict(py, status),
                Received::Closed => return Err(exception(py, &Failure::NoMoreStatuses)),
                Received::Nothing => py.check_signals()?,
            }
            let asked: &Arc<Mailbox<Report>> = asked.get_or_insert_with(|| self.pass());
            if let Received::Message(Report::Over(Err(failure))) = asked.receive(Duration::ZERO) {
                return Err(exception(py, &failure));
            }
        }
    }

    /// Returns a received status, without waiting.
    fn poll<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        match self.statuses.receive(Duration::ZERO) {
            Received::Message(status) => dict(py, status).map(Some),
            Received::Closed => Err(exception(py, &Failure::NoMoreStatuses)),
            Received::Nothing => Ok(None),
        }
    }

    /// Calls this once, in another thread, when there is something to poll; virtual time passes
    /// meanwhile.
    fn when_ready(&self, wake: Py<PyAny>) {
        self.pass();
        self.statuses.when_ready(calling(wake));
    }
}

impl Statuses {
    fn pass(&self) -> Arc<Mailbox<Report>> {
        self.worker
            .ask(Operation::Subscribe(Arc::clone(&self.statuses)))
    }
}

/// Runs a calculation in another thread without the interpreter's lock, and cancels it on Ctrl-C.
pub(crate) fn interruptible<T: Send>(
    py: Python<'_>,
    cancel: &CancelToken,
    calculate: impl FnOnce() -> T + Send,
) -> PyResult<T> {
    thread::scope(|scope| {
        let (sender, results) = Mailbox::new();
        scope.spawn(move || sender.send(calculate()));
        loop {
            match py.detach(|| results.receive(SIGNALS)) {
                Received::Message(result) => return Ok(result),
                Received::Nothing => py.check_signals().inspect_err(|_| cancel.cancel())?,
                Received::Closed => {
                    return Err(PyRuntimeError::new_err("the calculation panicked"));
                }
            }
        }
    })
}

/// Calls a Python function from a worker thread, unless the interpreter is shutting down.
fn calling(wake: Py<PyAny>) -> Box<dyn FnOnce() + Send> {
    Box::new(move || {
        Python::try_attach(|py| {
            if let Err(error) = wake.call0(py) {
                error.write_unraisable(py, None);
            }
        });
    })
}

/// Returns the fields of a status for Python.
pub(crate) fn dict(py: Python<'_>, seen: Seen) -> PyResult<Bound<'_, PyDict>> {
    let Seen {
        status,
        at_s,
        moving,
    } = seen;
    let fields = PyDict::new(py);
    fields.set_item("x_mm", status.x_mm)?;
    fields.set_item("y_mm", status.y_mm)?;
    fields.set_item("z_mm", status.z_mm)?;
    fields.set_item("rotation_deg", status.rotation_deg)?;
    fields.set_item("base_deg", status.base_deg)?;
    fields.set_item("rear_deg", status.rear_deg)?;
    fields.set_item("fore_deg", status.fore_deg)?;
    fields.set_item("servo_deg", status.servo_deg)?;
    fields.set_item("suction", status.suction)?;
    fields.set_item("gripper_deg", status.gripper_deg)?;
    fields.set_item("at_s", at_s)?;
    fields.set_item("moving", moving)?;
    Ok(fields)
}

/// The interval at which a waiting call checks for Ctrl-C.
const SIGNALS: Duration = Duration::from_millis(20);
/// The time for which Ctrl-C waits until the arm is stopped.
const STOPPED: Duration = Duration::from_secs(5);
