//! The arm object for Python: requests go to the worker thread.

use std::sync::Arc;
use std::time::Duration;

use dobot_api::{Button, Request};
use dobot_arm::Tool;
use dobot_controller::PowerUp;
use dobot_host::{PathName, Target, TargetPlace, voice_command};
use dobot_sim::VirtualArm;
use dobot_teach::Times;
use dobot_wire::{
    Command, Configuration, Dialect, Gesture, JointJog, JointJogAxis, MouseMove, MovingMode,
    PlaybackAdjustment, Status, WriteVector,
};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::drawing::Drawing;
use crate::failure::value_error;
use crate::mailbox::Mailbox;
use crate::pending::{Pending, Statuses};
use crate::place::{ConnectOptions, place};
use crate::program::{Run, Taught};
use crate::virtual_arm::{read_faults, world_json};
use crate::worker::{Operation, Outcome, Report, Worker};

/// An arm with its safety rules. Any thread may use it; motions are carried out one after the
/// other.
///
/// A slow operation returns a [`Pending`], which a call or a coroutine waits for.
#[pyclass(frozen)]
pub(crate) struct Core {
    worker: Arc<Worker>,
}

#[pymethods]
impl Core {
    /// Starts to connect.
    #[new]
    fn new(at: &str, options: ConnectOptions) -> PyResult<Self> {
        let name = options.name.clone();
        let at = place(at, options)?;
        let worker = Worker::start(at, name);
        Ok(Self {
            worker: Arc::new(worker),
        })
    }

    /// Returns an operation that ends when the arm is connected.
    fn connected(&self) -> Pending {
        self.begin(Operation::Connected)
    }

    /// Returns the next status.
    fn status(&self) -> Pending {
        self.begin(Operation::Status)
    }

    fn move_to(
        &self,
        point_mm: [f32; 3],
        rotation_deg: Option<f32>,
        how: MoveOptions,
    ) -> PyResult<Pending> {
        let mm = point_mm;
        self.go(TargetPlace::Point { mm, rotation_deg }, None, &how)
    }

    fn move_joints(
        &self,
        joints_deg: [f32; 3],
        servo_deg: Option<f32>,
        how: MoveOptions,
    ) -> PyResult<Pending> {
        self.go(TargetPlace::Joints(joints_deg), servo_deg, &how)
    }

    /// Switches the pump at the current position.
    fn suction(&self, on: bool) -> Pending {
        self.switch(if on {
            JointJogAxis::SuctionOn
        } else {
            JointJogAxis::SuctionOff
        })
    }

    /// Switches the laser at the current position, if the rules allow it.
    fn laser(&self, on: bool) -> Pending {
        self.switch(if on {
            JointJogAxis::LaserOn
        } else {
            JointJogAxis::LaserOff
        })
    }

    /// Turns the gripper at the current position.
    fn gripper(&self, gripper_deg: f32) -> Pending {
        let command = move |from: &Status, _| {
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

    /// Sets the percentages of speed and acceleration of moves.
    fn speed(&self, speed_percent: f32, acceleration_percent: f32) -> Pending {
        self.carry_out(PlaybackAdjustment {
            speed_percent,
            acceleration_percent,
            teach_speed_percent: 100.0,
        })
    }

    /// Moves by a small distance, as with a mouse; omitted values do not change.
    fn mouse(&self, by: [f32; 3], rotation_deg: Option<f32>, suction: Option<bool>) -> Pending {
        let [x, y, z] = by;
        let command = move |from: &Status, dialect| {
            let kept_deg = MouseMove::kept_rotation_deg(from, dialect);
            MouseMove {
                y,
                x,
                z,
                rotation_deg: rotation_deg.unwrap_or(kept_deg),
                suction: suction.unwrap_or(from.suction),
            }
            .into()
        };
        self.begin(Operation::CarryOut(Box::new(command)))
    }

    /// Sends a voice command as text.
    fn say(&self, text: &str) -> PyResult<Pending> {
        let voice = voice_command(text).map_err(|error| value_error(&error))?;
        Ok(self.carry_out(voice))
    }

    /// Moves to the position of a hand; without `grab` the pump stays as it is.
    fn hand(&self, place: [f32; 3], grab: Option<bool>) -> Pending {
        let [x, y, z] = place;
        let command = move |from: &Status, _| {
            let grab = grab.unwrap_or(from.suction);
            Gesture { x, y, z, grab }.into()
        };
        self.begin(Operation::CarryOut(Box::new(command)))
    }

    /// Draws one straight line; `speeds_mm_s` are the maximum, at the start and at the end.
    fn vector(&self, by_mm: [f32; 3], speeds_mm_s: [f32; 3], burn: bool) -> Pending {
        let ([x_mm, y_mm, z_mm], [max_mm_s, start_mm_s, end_mm_s]) = (by_mm, speeds_mm_s);
        let line = WriteVector {
            start_speed_mm_s: start_mm_s,
            end_speed_mm_s: end_mm_s,
            ..WriteVector::by(x_mm, y_mm, z_mm, max_mm_s)
        };
        self.carry_out(if burn { line.burning() } else { line })
    }

    /// Sets the jog speeds: speed and acceleration of the joints, the servo and along a line.
    fn set_jog(&self, speeds: [f32; 6]) -> Pending {
        self.carry_out(Configuration::teach(speeds))
    }

    /// Sets the speeds of moves, in the same order, the default pause and the height of a JUMP.
    fn set_moves(&self, speeds: [f32; 6], pause_s: f32, jump_height_mm: f32) -> Pending {
        self.carry_out(Configuration::playback(speeds, pause_s, jump_height_mm))
    }

    fn set_writing(&self, acceleration_mm_s2: f32) -> Pending {
        self.carry_out(Configuration::Writing { acceleration_mm_s2 })
    }

    /// Sets the current angles of rear arm and forearm.
    fn set_angles(&self, rear_deg: f32, fore_deg: f32) -> Pending {
        self.carry_out(Configuration::InitialAngles { rear_deg, fore_deg })
    }

    /// Sets the end effector by the name of the tool.
    fn set_tool(&self, tool: &str) -> PyResult<Pending> {
        let named = Tool::named(tool).ok_or_else(|| {
            let names = Tool::ALL.map(Tool::option).join(", ");
            PyValueError::new_err(format!("tool is `{tool}`; allowed are {names}"))
        })?;
        let tool = named.into();
        Ok(self.carry_out(Configuration::EndEffector { tool }))
    }

    /// Holds a jog button until it is released, within a maximum time.
    fn press(&self, button: &str, speed_percent: f32, at_most_s: f64) -> PyResult<Pending> {
        let found = button
            .parse::<Button>()
            .ok()
            .filter(|button| button.moves());
        let found = found.ok_or_else(|| {
            PyValueError::new_err(format!(
                "the button is `{button}`; allowed are x y z base rear fore servo gripper, each followed by + or -"
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

    /// Runs a program; `times` is the number of repetitions, 0 for endless. With `asks`, the caller
    /// answers its questions.
    fn run(
        &self,
        program: &Bound<'_, Taught>,
        times: Option<u64>,
        from_step: usize,
        asks: bool,
    ) -> Pending {
        self.begin(Operation::Run(Box::new(Run {
            source: Arc::clone(&program.get().source),
            times: times.map(|time| match time {
                0 => Times::Forever,
                count => Times::Count(count),
            }),
            from_step,
            asks,
        })))
    }

    fn check(&self, program: &Bound<'_, Taught>) -> Pending {
        let source = Arc::clone(&program.get().source);
        self.begin(Operation::Check(source))
    }

    fn resume(&self, as_person: bool) -> Pending {
        self.begin(Operation::Resume { as_person })
    }

    fn cancel(&self) -> Pending {
        self.begin(Operation::Cancel)
    }

    fn wait(&self, seconds: f64) -> PyResult<Pending> {
        let time = Duration::try_from_secs_f64(seconds).map_err(|_| {
            PyValueError::new_err(format!("seconds is {seconds}; allowed are 0 or more"))
        })?;
        Ok(self.begin(Operation::Wait(time)))
    }

    /// Returns the world of a virtual arm of this process as a JSON object.
    fn world(&self) -> Pending {
        self.inspect(|arm, _| {
            let world = world_json(arm).ok_or("this virtual arm has no world")?;
            Ok(Outcome::Json(world))
        })
    }

    /// Replaces the faults of a virtual arm of this process.
    fn set_faults(&self, faults: Vec<String>, seed: u64) -> PyResult<Pending> {
        let faults = read_faults(&faults)?;
        Ok(self.inspect(move |arm, power_up| {
            let set = arm.set_faults(power_up, &faults, seed);
            set.map_err(|error| error.to_string())?;
            Ok(Outcome::Nothing)
        }))
    }

    fn confirm_pose(&self) -> Pending {
        self.begin(Operation::Plain(Request::ConfirmPose))
    }

    fn reset_stop(&self) -> Pending {
        self.begin(Operation::Plain(Request::ResetStop))
    }

    /// Stops the arm, whatever another thread is doing with it.
    fn stop(&self, reason: Option<String>) -> Pending {
        self.pending(self.worker.stop(reason))
    }

    /// Returns all statuses from now on.
    fn statuses(&self) -> Statuses {
        Statuses {
            statuses: self.worker.subscribe(),
            worker: Arc::clone(&self.worker),
        }
    }

    /// Disconnects and waits until that is done.
    fn close(&self, py: Python<'_>) {
        py.detach(|| self.worker.close());
    }
}

impl Core {
    fn go(
        &self,
        place: TargetPlace,
        servo_deg: Option<f32>,
        how: &MoveOptions,
    ) -> PyResult<Pending> {
        let target = Target {
            place,
            servo_deg,
            mode: mode(&how.path)?,
            suction: how.suction,
            gripper_deg: how.gripper_deg,
            pause_s: how.pause_s,
        };
        let command = move |from: &Status, _| target.command(from);
        Ok(self.begin(Operation::CarryOut(Box::new(command))))
    }

    fn inspect(
        &self,
        inspect: impl FnOnce(&mut VirtualArm, PowerUp) -> Result<Outcome, String> + Send + 'static,
    ) -> Pending {
        self.begin(Operation::Inspect(Box::new(inspect)))
    }

    fn switch(&self, axis: JointJogAxis) -> Pending {
        self.carry_out(JointJog::new(axis, 0.0))
    }

    /// Carries out a command that does not depend on the status.
    fn carry_out(&self, command: impl Into<Command>) -> Pending {
        let command = command.into();
        let command = move |_: &Status, _: Option<Dialect>| command;
        self.begin(Operation::CarryOut(Box::new(command)))
    }

    fn begin(&self, operation: Operation) -> Pending {
        self.pending(self.worker.ask(operation))
    }

    fn pending(&self, reports: Arc<Mailbox<Report>>) -> Pending {
        Pending {
            reports,
            worker: Arc::clone(&self.worker),
        }
    }
}

/// The path, and the tool state after the move: a Python tuple.
#[derive(FromPyObject)]
struct MoveOptions {
    #[pyo3(item(0))]
    path: String,
    #[pyo3(item(1))]
    suction: Option<bool>,
    #[pyo3(item(2))]
    gripper_deg: Option<f32>,
    #[pyo3(item(3))]
    pause_s: f32,
}

/// Returns the warning about a point that looks like metres.
#[pyfunction]
pub(crate) fn point_warning(mm: [f32; 3]) -> Option<String> {
    unit_warning(TargetPlace::Point {
        mm,
        rotation_deg: None,
    })
}

/// Returns the warning about joint angles that look like radians.
#[pyfunction]
pub(crate) fn joints_warning(joints_deg: [f32; 3]) -> Option<String> {
    unit_warning(TargetPlace::Joints(joints_deg))
}

fn unit_warning(place: TargetPlace) -> Option<String> {
    Some(place.unit_warning()?.to_string())
}

fn mode(path: &str) -> PyResult<MovingMode> {
    let named = path.parse::<PathName>();
    let named = named.map_err(|error| PyValueError::new_err(format!("path is `{path}`; {error}")));
    Ok(named?.0)
}
