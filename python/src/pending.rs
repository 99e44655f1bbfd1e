//! What goes on, and the statuses that come: a call waits for them without the interpreter's lock.

use std::sync::Arc;
use std::time::Duration;

use dobot_wire::Status;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString, PyTuple};

use crate::failure::{Failure, exception};
use crate::mailbox::{Mailbox, Taken};
use crate::worker::{Operation, Outcome, Progress, Told, Worker};

/// Something that goes on.
#[pyclass(frozen)]
pub(crate) struct Pending {
    pub(crate) told: Arc<Mailbox<Told>>,
    pub(crate) worker: Arc<Worker>,
}

#[pymethods]
impl Pending {
    /// Waits without the interpreter's lock. Ctrl-C stops the arm first, and so does what goes wrong in
    /// `progress`, which is called with how many commands of how many are over.
    fn wait<'py>(
        &self,
        py: Python<'py>,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        loop {
            let called = match py.detach(|| self.told.take(SIGNALS)) {
                Taken::It(Told::Over(Ok(outcome))) => return read(py, outcome),
                Taken::It(Told::Over(Err(failure))) => return Err(exception(py, &failure)),
                Taken::It(Told::Progress(part)) => match progress {
                    Some(it) => counts(py, part).and_then(|part| it.call1(part)).map(drop),
                    None => Ok(()),
                },
                Taken::Closed => return Err(exception(py, &Failure::Closed)),
                Taken::Nothing => Ok(()),
            };
            if let Err(interrupt) = called.and_then(|()| py.check_signals()) {
                let reason = format!("Python was interrupted: {interrupt}");
                let stopped = self.worker.stop(Some(reason));
                // Whatever comes of it, the interrupt is what is told.
                py.detach(|| stopped.take(STOPPED));
                return Err(interrupt);
            }
        }
    }

    /// What was told, without waiting: nothing, how far it is, or the end.
    fn poll<'py>(&self, py: Python<'py>) -> PyResult<Polled<'py>> {
        match self.told.take(Duration::ZERO) {
            Taken::It(Told::Over(Ok(outcome))) => Ok((None, Some(read(py, outcome)?))),
            Taken::It(Told::Over(Err(failure))) => Err(exception(py, &failure)),
            Taken::It(Told::Progress(part)) => Ok((Some(counts(py, part)?), None)),
            Taken::Closed => Err(exception(py, &Failure::Closed)),
            Taken::Nothing => Ok((None, None)),
        }
    }

    /// Calls this once, in another thread, when there is something to poll.
    fn when_told(&self, wake: Py<PyAny>) {
        self.told.when_told(calling(wake));
    }
}

/// How far it is, and what came of it.
type Polled<'py> = (Option<Bound<'py, PyTuple>>, Option<Bound<'py, PyAny>>);

/// What came of it: an empty dictionary, a status as one, or the text of a JSON value.
fn read(py: Python<'_>, outcome: Outcome) -> PyResult<Bound<'_, PyAny>> {
    Ok(match outcome {
        Outcome::Nothing => PyDict::new(py).into_any(),
        Outcome::Status(status) => dict(py, status)?.into_any(),
        Outcome::Json(text) => PyString::new(py, &text).into_any(),
    })
}

/// What `progress` is called with.
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

/// Every status from when it was asked for.
#[pyclass(frozen)]
pub(crate) struct Statuses {
    pub(crate) heard: Arc<Mailbox<Status>>,
    pub(crate) worker: Arc<Worker>,
}

#[pymethods]
impl Statuses {
    /// Waits for the next one; virtual time passes meanwhile. Gives nothing where Ctrl-C may have been pressed.
    fn next<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let mut asked = None;
        loop {
            let time = if asked.is_none() {
                Duration::ZERO
            } else {
                SIGNALS
            };
            match py.detach(|| self.heard.take(time)) {
                Taken::It(status) => return dict(py, status),
                Taken::Closed => return Err(exception(py, &Failure::Unheard)),
                Taken::Nothing => py.check_signals()?,
            }
            let asked: &Arc<Mailbox<Told>> = asked.get_or_insert_with(|| self.pass());
            if let Taken::It(Told::Over(Err(failure))) = asked.take(Duration::ZERO) {
                return Err(exception(py, &failure));
            }
        }
    }

    /// A status that was told already, without waiting.
    fn poll<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        match self.heard.take(Duration::ZERO) {
            Taken::It(status) => dict(py, status).map(Some),
            Taken::Closed => Err(exception(py, &Failure::Unheard)),
            Taken::Nothing => Ok(None),
        }
    }

    /// Calls this once, in another thread, when there is something to poll; virtual time passes meanwhile.
    fn when_told(&self, wake: Py<PyAny>) {
        self.pass();
        self.heard.when_told(calling(wake));
    }
}

impl Statuses {
    fn pass(&self) -> Arc<Mailbox<Told>> {
        self.worker.ask(Operation::Hear(Arc::clone(&self.heard)))
    }
}

/// Calls it from a thread of ours; an interpreter that ends is left alone.
fn calling(wake: Py<PyAny>) -> Box<dyn FnOnce() + Send> {
    Box::new(move || {
        Python::try_attach(|py| {
            if let Err(error) = wake.call0(py) {
                error.write_unraisable(py, None);
            }
        });
    })
}

fn dict(py: Python<'_>, it: Status) -> PyResult<Bound<'_, PyDict>> {
    let told = PyDict::new(py);
    told.set_item("x_mm", it.x_mm)?;
    told.set_item("y_mm", it.y_mm)?;
    told.set_item("z_mm", it.z_mm)?;
    told.set_item("rotation_deg", it.rotation_deg)?;
    told.set_item("base_deg", it.base_deg)?;
    told.set_item("rear_deg", it.rear_deg)?;
    told.set_item("fore_deg", it.fore_deg)?;
    told.set_item("servo_deg", it.servo_deg)?;
    told.set_item("suction", it.suction)?;
    told.set_item("gripper_deg", it.gripper_deg)?;
    Ok(told)
}

/// How often a waiting call looks whether Ctrl-C was pressed.
const SIGNALS: Duration = Duration::from_millis(20);
/// How long Ctrl-C waits until the arm is stopped.
const STOPPED: Duration = Duration::from_secs(5);
