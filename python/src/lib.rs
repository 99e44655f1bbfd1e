//! The arm for Python: a thread of its own owns the client of the rules, and Python talks to it by messages.

mod drawing;
mod mailbox;
mod worker;

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use dobot_api::{Button, Folders, Request, StationAddress, StationSearch};
use dobot_client::Address;
use dobot_controller::{Personality, PowerUp};
use dobot_rules::{LocalArm, PathName, Target, TargetPlace};
use dobot_safety::Policy;
use dobot_wire::{Dialect, JointJog, JointJogAxis, MovingMode, PlaybackAdjustment, Status};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::drawing::Drawing;
use crate::mailbox::{Mailbox, Taken};
use crate::worker::{Failure, Operation, Told, Where, Worker};

/// How often a waiting call looks whether Ctrl-C was pressed.
const SIGNALS: Duration = Duration::from_millis(20);
/// How long Ctrl-C waits until the arm is stopped.
const STOPPED: Duration = Duration::from_secs(5);

/// An arm under its rules. Any thread may use it; what moves it is done one after the other.
///
/// What takes its time is begun, and gives a [`Pending`]: a call waits for it, and so does a coroutine.
#[pyclass(frozen)]
struct Core {
    worker: Arc<Worker>,
}

#[pymethods]
impl Core {
    /// Begins to connect.
    #[new]
    fn new(
        at: &str,
        name: String,
        token: Option<&str>,
        dialect: Option<&str>,
        guardian: Option<PathBuf>,
    ) -> PyResult<Self> {
        let at = place(at, token, dialect, guardian)?;
        let worker = Worker::start(at, name);
        Ok(Self {
            worker: Arc::new(worker),
        })
    }

    /// Over when the arm is connected.
    fn connected(&self) -> Pending {
        self.begin(Operation::Connected)
    }

    /// What the arm tells next.
    fn status(&self) -> Pending {
        self.begin(Operation::Status)
    }

    #[allow(clippy::too_many_arguments)]
    fn move_to(
        &self,
        point_mm: [f32; 3],
        rotation_deg: Option<f32>,
        path: &str,
        suction: Option<bool>,
        gripper_deg: Option<f32>,
        pause_s: f32,
    ) -> PyResult<Pending> {
        Ok(self.go(Target {
            place: TargetPlace::Point {
                mm: point_mm,
                rotation_deg,
            },
            servo_deg: None,
            mode: mode(path)?,
            suction,
            gripper_deg,
            pause_s,
        }))
    }

    #[allow(clippy::too_many_arguments)]
    fn move_joints(
        &self,
        joints_deg: [f32; 3],
        servo_deg: Option<f32>,
        path: &str,
        suction: Option<bool>,
        gripper_deg: Option<f32>,
        pause_s: f32,
    ) -> PyResult<Pending> {
        Ok(self.go(Target {
            place: TargetPlace::Joints(joints_deg),
            servo_deg,
            mode: mode(path)?,
            suction,
            gripper_deg,
            pause_s,
        }))
    }

    /// Switches the pump where the arm is.
    fn suction(&self, on: bool) -> Pending {
        self.switch(if on {
            JointJogAxis::SuctionOn
        } else {
            JointJogAxis::SuctionOff
        })
    }

    /// Switches the laser where the arm is, as far as the rules allow it.
    fn laser(&self, on: bool) -> Pending {
        self.switch(if on {
            JointJogAxis::LaserOn
        } else {
            JointJogAxis::LaserOff
        })
    }

    /// Turns the gripper where the arm is.
    fn gripper(&self, gripper_deg: f32) -> Pending {
        let command = move |from: &Status| {
            let target = Target {
                place: TargetPlace::Joints([from.base_deg, from.rear_deg, from.fore_deg]),
                servo_deg: None,
                mode: MovingMode::MovJ,
                suction: None,
                gripper_deg: Some(gripper_deg),
                pause_s: 0.0,
            };
            target.command(from)
        };
        self.begin(Operation::CarryOut(Box::new(command)))
    }

    /// Shares of the speeds and accelerations of moves.
    fn speed(&self, speed_percent: f32, acceleration_percent: f32) -> Pending {
        let command = move |_: &Status| {
            PlaybackAdjustment {
                speed_percent,
                acceleration_percent,
                teach_speed_percent: 100.0,
            }
            .into()
        };
        self.begin(Operation::CarryOut(Box::new(command)))
    }

    /// Holds a jog button until it is released, and at most so long.
    fn press(&self, button: &str, speed_percent: f32, at_most_s: f64) -> PyResult<Pending> {
        let found = button.parse::<Button>().ok().filter(|it| it.moves());
        let found = found.ok_or_else(|| {
            PyValueError::new_err(format!(
                "the button is `{button}`; allowed are x y z base rear fore servo gripper, each with + or - behind it"
            ))
        })?;
        if !(0.02..=60.0).contains(&at_most_s) {
            return Err(PyValueError::new_err(format!(
                "at_most is {at_most_s}; allowed are 0.02 to 60 seconds"
            )));
        }
        let at_most = Duration::from_secs_f64(at_most_s);
        Ok(self.begin(Operation::Press(found.jog(speed_percent), at_most)))
    }

    fn release(&self) -> Pending {
        self.begin(Operation::Release)
    }

    fn arm_laser(&self, for_s: f64) -> Pending {
        self.begin(Operation::Controlled(Request::ArmLaser { for_s }))
    }

    fn disarm_laser(&self) -> Pending {
        self.begin(Operation::Plain(Request::DisarmLaser))
    }

    fn draw(&self, drawing: &Bound<'_, Drawing>) -> Pending {
        let request = drawing.get().request.clone();
        self.begin(Operation::Draw(Box::new(request)))
    }

    fn wait(&self, seconds: f64) -> PyResult<Pending> {
        let time = Duration::try_from_secs_f64(seconds).map_err(|_| {
            PyValueError::new_err(format!("seconds is {seconds}; allowed is 0 or more"))
        })?;
        Ok(self.begin(Operation::Wait(time)))
    }

    fn confirm_pose(&self) -> Pending {
        self.begin(Operation::Plain(Request::ConfirmPose))
    }

    fn reset_stop(&self) -> Pending {
        self.begin(Operation::Plain(Request::ResetStop))
    }

    /// Stops the arm, whatever another thread has it do.
    fn stop(&self, reason: Option<String>) -> Pending {
        self.pending(self.worker.stop(reason))
    }

    /// Every status from now on.
    fn statuses(&self) -> Statuses {
        Statuses {
            heard: self.worker.listen(),
            worker: Arc::clone(&self.worker),
        }
    }

    /// Lets go of the arm and waits until that is done.
    fn close(&self, py: Python<'_>) {
        py.detach(|| self.worker.close());
    }
}

impl Core {
    fn go(&self, target: Target) -> Pending {
        let command = move |from: &Status| target.command(from);
        self.begin(Operation::CarryOut(Box::new(command)))
    }

    fn switch(&self, axis: JointJogAxis) -> Pending {
        let command = move |_: &Status| JointJog::new(axis, 0.0).into();
        self.begin(Operation::CarryOut(Box::new(command)))
    }

    fn begin(&self, operation: Operation) -> Pending {
        self.pending(self.worker.ask(operation))
    }

    fn pending(&self, told: Arc<Mailbox<Told>>) -> Pending {
        Pending {
            told,
            worker: Arc::clone(&self.worker),
        }
    }
}

/// Something that goes on.
#[pyclass(frozen)]
struct Pending {
    told: Arc<Mailbox<Told>>,
    worker: Arc<Worker>,
}

#[pymethods]
impl Pending {
    /// Waits without the interpreter's lock. Ctrl-C stops the arm first, and so does what goes wrong in
    /// `progress`, which is called with how many commands of how many are over.
    fn wait<'py>(
        &self,
        py: Python<'py>,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyDict>> {
        loop {
            let called = match py.detach(|| self.told.take(SIGNALS)) {
                Taken::It(Told::Over(Ok(status))) => return dict(py, status),
                Taken::It(Told::Over(Err(failure))) => return Err(exception(py, &failure)),
                Taken::It(Told::Progress(completed, commands)) => match progress {
                    Some(it) => it.call1((completed, commands)).map(drop),
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

    /// What was told, without waiting: nothing, how many commands of how many are over, or the end.
    #[allow(clippy::type_complexity)]
    fn poll<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Option<(usize, usize)>, Option<Bound<'py, PyDict>>)> {
        match self.told.take(Duration::ZERO) {
            Taken::It(Told::Over(Ok(status))) => Ok((None, Some(dict(py, status)?))),
            Taken::It(Told::Over(Err(failure))) => Err(exception(py, &failure)),
            Taken::It(Told::Progress(completed, commands)) => {
                Ok((Some((completed, commands)), None))
            }
            Taken::Closed => Err(exception(py, &Failure::Closed)),
            Taken::Nothing => Ok((None, None)),
        }
    }

    /// Calls this once, in another thread, when there is something to poll.
    fn when_told(&self, wake: Py<PyAny>) {
        self.told.when_told(calling(wake));
    }
}

/// Every status from when it was asked for.
#[pyclass(frozen)]
struct Statuses {
    heard: Arc<Mailbox<Status>>,
    worker: Arc<Worker>,
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
                Taken::It(status) => return dict(py, Some(status)),
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
            Taken::It(status) => dict(py, Some(status)).map(Some),
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

fn dict(py: Python<'_>, status: Option<Status>) -> PyResult<Bound<'_, PyDict>> {
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

/// From what a user names to where the rules are kept.
fn place(
    at: &str,
    token: Option<&str>,
    dialect: Option<&str>,
    guardian: Option<PathBuf>,
) -> PyResult<Where> {
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
    let search = |address| StationSearch {
        address,
        token: token.map(str::to_owned),
        trust: None,
    };
    if at == "station" {
        return Ok(Where::Station(search(None)));
    }
    if at.starts_with("http://") || at.starts_with("https://") {
        StationAddress::new(at).map_err(|it| value_error(&it))?;
        return Ok(Where::Station(search(Some(at.to_owned()))));
    }
    if at.starts_with("serial:") || at.starts_with("tcp:") {
        let address = at.parse::<Address>().map_err(|it| value_error(&it))?;
        let dialect = dialect.map(str::parse::<Dialect>).transpose();
        let folders = Folders::of_environment();
        return Ok(Where::Local(Box::new(LocalArm {
            address,
            dialect: dialect.map_err(|it| value_error(&it))?,
            policy: Policy::default(),
            folders: folders
                .ok_or_else(|| value_error(&"this person has no home folder; set DOBOT_DATA"))?,
            guardian,
        })));
    }
    Err(PyValueError::new_err(format!(
        "the arm is at `{at}`; allowed are virtual:, virtual:firmware-1.1, station (the one that runs here; `dobot up` starts one), http://HOST:PORT, serial:PORT and tcp:HOST:PORT"
    )))
}

fn mode(path: &str) -> PyResult<MovingMode> {
    let named = path.parse::<PathName>();
    let named = named.map_err(|it| PyValueError::new_err(format!("path is `{path}`; {it}")));
    Ok(named?.0)
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
    module.add_class::<Pending>()?;
    module.add_class::<Statuses>()?;
    module.add_class::<Core>()
}
