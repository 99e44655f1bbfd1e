//! The arm for Python: a thread of its own owns the client of the rules, and Python talks to it by messages.

mod drawing;
mod worker;

use std::process;
use std::sync::mpsc::{Receiver, RecvTimeoutError};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use dobot_api::StationAddress;
use dobot_controller::{Personality, PowerUp};
use dobot_wire::{JointJog, JointJogAxis, MoveJoints, MoveTo, MovingMode, Status};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::drawing::Drawing;
use crate::worker::{Answer, Failure, Operation, Told, Where, Worker};

/// How often a waiting call looks whether Ctrl-C was pressed.
const SIGNALS: Duration = Duration::from_millis(20);
/// How long Ctrl-C waits until the arm is stopped.
const STOPPED: Duration = Duration::from_secs(5);

/// An arm under its rules. Any thread may use it; what moves it is done one after the other.
#[pyclass(frozen)]
struct Core {
    worker: Worker,
    pid: u32,
}

#[pymethods]
impl Core {
    #[new]
    fn new(py: Python<'_>, at: &str, name: String, token: Option<String>) -> PyResult<Self> {
        let at = place(at, token)?;
        let (worker, connected) = Worker::start(at, name);
        let core = Self {
            worker,
            pid: process::id(),
        };
        core.wait_for(py, &connected, None)?;
        Ok(core)
    }

    /// What the arm tells next.
    fn status<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.tell(py, Operation::Status)
    }

    #[allow(clippy::too_many_arguments)]
    fn move_to<'py>(
        &self,
        py: Python<'py>,
        point_mm: [f32; 3],
        rotation_deg: Option<f32>,
        path: &str,
        suction: Option<bool>,
        gripper_deg: Option<f32>,
        pause_s: f32,
    ) -> PyResult<Bound<'py, PyDict>> {
        let mode = mode(path)?;
        let [x_mm, y_mm, z_mm] = point_mm;
        let command = move |from: &Status| {
            let base_deg = y_mm.atan2(x_mm).to_degrees();
            MoveTo {
                x_mm,
                y_mm,
                z_mm,
                rotation_deg: rotation_deg.unwrap_or(base_deg + from.servo_deg),
                suction: suction.unwrap_or(from.suction),
                mode,
                gripper_deg: gripper_deg.unwrap_or(from.gripper_deg),
                pause_s,
            }
            .into()
        };
        self.tell(py, Operation::CarryOut(Box::new(command)))
    }

    #[allow(clippy::too_many_arguments)]
    fn move_joints<'py>(
        &self,
        py: Python<'py>,
        joints_deg: [f32; 3],
        servo_deg: Option<f32>,
        path: &str,
        suction: Option<bool>,
        gripper_deg: Option<f32>,
        pause_s: f32,
    ) -> PyResult<Bound<'py, PyDict>> {
        let mode = mode(path)?;
        let [base_deg, rear_deg, fore_deg] = joints_deg;
        let command = move |from: &Status| {
            MoveJoints {
                base_deg,
                rear_deg,
                fore_deg,
                servo_deg: servo_deg.unwrap_or(from.servo_deg),
                suction: suction.unwrap_or(from.suction),
                mode,
                gripper_deg: gripper_deg.unwrap_or(from.gripper_deg),
                pause_s,
            }
            .into()
        };
        self.tell(py, Operation::CarryOut(Box::new(command)))
    }

    /// Switches the pump where the arm is.
    fn suction(&self, py: Python<'_>, on: bool) -> PyResult<()> {
        let axis = if on {
            JointJogAxis::SuctionOn
        } else {
            JointJogAxis::SuctionOff
        };
        let command = move |_: &Status| JointJog::new(axis, 0.0).into();
        self.tell(py, Operation::CarryOut(Box::new(command)))
            .map(drop)
    }

    /// Draws it; `progress` is called with how many commands of how many are over.
    fn draw(
        &self,
        py: Python<'_>,
        drawing: &Bound<'_, Drawing>,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<()> {
        self.check_process()?;
        let request = drawing.get().request.clone();
        let answer = self.worker.ask(Operation::Draw(Box::new(request)));
        self.wait_for(py, &answer, progress).map(drop)
    }

    fn wait(&self, py: Python<'_>, seconds: f64) -> PyResult<()> {
        let time = Duration::try_from_secs_f64(seconds).map_err(|_| {
            PyValueError::new_err(format!("seconds is {seconds}; allowed is 0 or more"))
        })?;
        self.ask(py, Operation::Wait(time)).map(drop)
    }

    fn confirm_pose(&self, py: Python<'_>) -> PyResult<()> {
        self.ask(py, Operation::ConfirmPose).map(drop)
    }

    fn reset_stop(&self, py: Python<'_>) -> PyResult<()> {
        self.ask(py, Operation::ResetStop).map(drop)
    }

    /// Stops the arm, whatever another thread has it do.
    fn stop(&self, py: Python<'_>, reason: Option<String>) -> PyResult<()> {
        self.check_process()?;
        let answer = self.worker.stop(reason);
        self.wait_for(py, &answer, None).map(drop)
    }

    /// Lets go of the arm and waits until that is done.
    fn close(&self, py: Python<'_>) -> PyResult<()> {
        self.check_process()?;
        py.detach(|| self.worker.close());
        Ok(())
    }
}

impl Core {
    fn tell<'py>(&self, py: Python<'py>, operation: Operation) -> PyResult<Bound<'py, PyDict>> {
        let status = self.ask(py, operation)?;
        let told = PyDict::new(py);
        if let Some(it) = status {
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
        }
        Ok(told)
    }

    fn ask(&self, py: Python<'_>, operation: Operation) -> PyResult<Option<Status>> {
        self.check_process()?;
        let answer = self.worker.ask(operation);
        self.wait_for(py, &answer, None)
    }

    /// Waits without the interpreter's lock. Ctrl-C stops the arm first, and so does what goes wrong in
    /// `progress`.
    fn wait_for(
        &self,
        py: Python<'_>,
        answer: &Mutex<Receiver<Told>>,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Option<Status>> {
        loop {
            let called = match hear(py, answer, SIGNALS) {
                Ok(Told::Over(answer)) => return over(py, answer),
                Ok(Told::Progress(completed, commands)) => match progress {
                    Some(it) => it.call1((completed, commands)).map(drop),
                    None => Ok(()),
                },
                Err(RecvTimeoutError::Disconnected) => return Err(exception(py, &Failure::Closed)),
                Err(RecvTimeoutError::Timeout) => Ok(()),
            };
            if let Err(interrupt) = called.and_then(|()| py.check_signals()) {
                let reason = format!("Python was interrupted: {interrupt}");
                let stopped = self.worker.stop(Some(reason));
                // Whatever comes of it, the interrupt is what is told.
                let _ = hear(py, &stopped, STOPPED);
                return Err(interrupt);
            }
        }
    }

    fn check_process(&self) -> PyResult<()> {
        if process::id() == self.pid {
            return Ok(());
        }
        Python::attach(|py| Err(exception(py, &Failure::Forked)))
    }
}

fn over(py: Python<'_>, answer: Answer) -> PyResult<Option<Status>> {
    answer.map_err(|it| exception(py, &it))
}

fn hear(
    py: Python<'_>,
    answer: &Mutex<Receiver<Told>>,
    time: Duration,
) -> Result<Told, RecvTimeoutError> {
    py.detach(|| {
        let answer = answer.lock().unwrap_or_else(PoisonError::into_inner);
        answer.recv_timeout(time)
    })
}

/// From what a user names to where the rules are kept.
fn place(at: &str, token: Option<String>) -> PyResult<Where> {
    let value_error = |it: &dyn std::fmt::Display| PyValueError::new_err(it.to_string());
    if let Some(personality) = at.strip_prefix("virtual:") {
        let personality = match personality {
            "" => Personality::default(),
            named => named
                .parse::<Personality>()
                .map_err(|it| value_error(&it))?,
        };
        return Ok(Where::Virtual(PowerUp::new(personality)));
    }
    if at.starts_with("http://") || at.starts_with("https://") {
        let mut address = StationAddress::new(at).map_err(|it| value_error(&it))?;
        address.token = token;
        return Ok(Where::Station(address));
    }
    Err(PyValueError::new_err(format!(
        "the arm is at `{at}`; allowed are virtual:, virtual:firmware-1.1 and a station as in http://127.0.0.1:8642 (`dobot up` starts one)"
    )))
}

fn mode(path: &str) -> PyResult<MovingMode> {
    match path {
        "jump" => Ok(MovingMode::Jump),
        "movl" => Ok(MovingMode::MovL),
        "movj" => Ok(MovingMode::MovJ),
        _ => Err(PyValueError::new_err(format!(
            "path is `{path}`; allowed are jump (lift, across, down), movl (straight) and movj (all joints at once)"
        ))),
    }
}

/// The exception of `dobot_arm.errors` for a failure.
fn exception(py: Python<'_>, failure: &Failure) -> PyErr {
    let made = || -> PyResult<PyErr> {
        let fields = PyDict::new(py);
        fields.set_item("hint", failure.hint())?;
        if let Failure::Refused(problem) = failure {
            fields.set_item("kind", &problem.kind)?;
            fields.set_item("rule", &problem.rule)?;
            fields.set_item("at_mm", problem.at_mm.map(<(f64, f64, f64)>::from))?;
            fields.set_item(
                "nearest_mm",
                problem.nearest_mm.map(<(f64, f64, f64)>::from),
            )?;
        }
        let class = py.import("dobot_arm.errors")?.getattr(failure.class())?;
        let error = class.call((failure.to_string(),), Some(&fields))?;
        Ok(PyErr::from_value(error))
    };
    made().unwrap_or_else(|error| error)
}

#[pymodule]
fn _core(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Drawing>()?;
    module.add_class::<Core>()
}
