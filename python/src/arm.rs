//! The arm object for Python: requests go to the worker thread.

use std::sync::Arc;
use std::time::Duration;

use dobot_api::{Button, ClientId, EpisodeMark, Heard, Request, Sense, State};
use dobot_arm::Tool;
use dobot_controller::PowerUp;
use dobot_host::{PathName, Target, TargetPlace, voice_command};
use dobot_motion::{HandAxis, HandScale};
use dobot_sim::VirtualArm;
use dobot_teach::Times;
use dobot_wire::{
    Command, Configuration, Dialect, Gesture, JointJog, JointJogAxis, MouseMove, MovingMode,
    PlaybackAdjustment, Status, WriteVector,
};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::drawing::Drawing;
use crate::failure::{exception, value_error};
use crate::follow::Follow;
use crate::mailbox::Mailbox;
use crate::pending::{Pending, Statuses, dict};
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
    fn next_status(&self) -> Pending {
        self.begin(Operation::NextStatus)
    }

    /// Returns the last known status without waiting, if there is one.
    fn last_status<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let last = self
            .worker
            .last()
            .map_err(|failure| exception(py, &failure))?;
        last.map(|seen| dict(py, seen)).transpose()
    }

    /// Returns what the station knows, as a JSON object.
    fn state(&self) -> Pending {
        self.begin(Operation::State)
    }

    /// Moves to a point; `axes` are its three coordinates and the rotation. Omitted ones keep
    /// their values.
    fn move_to(&self, frame: &str, axes: [Option<f32>; 4], how: MoveOptions) -> PyResult<Pending> {
        let frame = match frame {
            "base" => Frame::Base,
            "current" => Frame::Current,
            _ => Frame::Polar,
        };
        self.go(move |from| (frame.place(axes, from), None), &how)
    }

    /// Moves to joint angles and the servo's angle, or by them.
    fn move_joints(&self, joints_deg: [Option<f32>; 4], how: MoveOptions) -> PyResult<Pending> {
        let place = move |from: &Status| {
            let [base, rear, fore, servo] = joints_deg;
            let joints = [
                base.unwrap_or(from.base_deg),
                rear.unwrap_or(from.rear_deg),
                fore.unwrap_or(from.fore_deg),
            ];
            (TargetPlace::Joints(joints), servo)
        };
        self.go(place, &how)
    }

    /// Moves through points in mm at a speed, without a stop in between.
    fn follow(&self, points_mm: Vec<[f64; 3]>, speed_mm_s: f64, title: String) -> Pending {
        self.begin(Operation::Follow(Box::new(Follow {
            points_mm,
            speed_mm_s,
            title,
        })))
    }

    /// Takes control, or asks its holder and waits for at most this long, in seconds.
    fn request_control(&self, patience_s: f64) -> PyResult<Pending> {
        Ok(self.begin(Operation::RequestControl(seconds("wait", patience_s)?)))
    }

    /// Marks an episode in the station's recording: `begin`, `end` or `discard`.
    fn mark_episode(&self, mark: &str, task: Option<String>) -> PyResult<Pending> {
        let mark = match mark {
            "begin" => EpisodeMark::Begin,
            "end" => EpisodeMark::End,
            "discard" => EpisodeMark::Discard,
            other => {
                return Err(PyValueError::new_err(format!(
                    "mark is {other:?}; allowed are begin, end and discard"
                )));
            }
        };
        Ok(self.begin(Operation::Plain(Request::MarkEpisode { mark, task })))
    }

    fn release_control(&self) -> Pending {
        self.begin(Operation::Plain(Request::ReleaseLease))
    }

    /// Gives control to a client that asked for it.
    fn grant_control(&self, client: u64) -> Pending {
        let to = ClientId(client);
        self.begin(Operation::Plain(Request::GrantLease { to }))
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
        let command = move |from: &Status, _: &State| {
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
        self.begin(Operation::CarryOut(Box::new(command), None))
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
        let command = move |from: &Status, state: &State| {
            let kept_deg = MouseMove::kept_rotation_deg(from, state.dialect);
            MouseMove {
                y,
                x,
                z,
                rotation_deg: rotation_deg.unwrap_or(kept_deg),
                suction: suction.unwrap_or(from.suction),
            }
            .into()
        };
        self.begin(Operation::CarryOut(Box::new(command), None))
    }

    /// Sends a voice command as text; with `spoken` a microphone has heard it.
    fn say(&self, text: &str, spoken: bool) -> PyResult<Pending> {
        let voice = voice_command(text).map_err(|error| value_error(&error))?;
        let sense = spoken.then_some(Sense::Microphone);
        let command = Box::new(move |_: &Status, _: &State| voice.into());
        Ok(self.begin(Operation::CarryOut(command, sense)))
    }

    /// Publishes what a microphone heard: a JSON object as in requests.
    fn report_heard(&self, heard: &str, client: Option<u64>) -> PyResult<Pending> {
        let heard: Heard = serde_json::from_str(heard).map_err(|error| value_error(&error))?;
        let client = client.map(ClientId);
        Ok(self.begin(Operation::Plain(Request::Heard { client, heard })))
    }

    /// Moves to the position of a hand; without `grab` the pump stays as it is. With `seen` a camera
    /// has seen the hand, and the position is in mm.
    fn hand(&self, place: [f32; 3], grab: Option<bool>, seen: bool) -> Pending {
        let command = move |from: &Status, state: &State| {
            let [x, y, z] = if seen {
                gesture_units(place, state)
            } else {
                place
            };
            let grab = grab.unwrap_or(from.suction);
            Gesture { x, y, z, grab }.into()
        };
        let sense = seen.then_some(Sense::Hand);
        self.begin(Operation::CarryOut(Box::new(command), sense))
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
        let time = self::seconds("seconds", seconds)?;
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
    /// Moves to a place that depends on the current status, with the angle of the servo.
    fn go(
        &self,
        place: impl FnOnce(&Status) -> (TargetPlace, Option<f32>) + Send + 'static,
        how: &MoveOptions,
    ) -> PyResult<Pending> {
        let mode = mode(&how.path)?;
        let MoveOptions {
            suction,
            gripper_deg,
            pause_s,
            ..
        } = *how;
        let command = move |from: &Status, _: &State| {
            let (place, servo_deg) = place(from);
            let mode = if mode == MovingMode::MovL && is_here(&place, from) {
                // A stock arm would lose its pose on a straight line of no length (note N34).
                MovingMode::MovJ
            } else {
                mode
            };
            let target = Target {
                place,
                servo_deg,
                mode,
                suction,
                gripper_deg,
                pause_s,
            };
            target.command(from)
        };
        Ok(self.begin(Operation::CarryOut(Box::new(command), None)))
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
        let command = move |_: &Status, _: &State| command;
        self.begin(Operation::CarryOut(Box::new(command), None))
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

/// The meaning of the coordinates of a target.
#[derive(Clone, Copy)]
enum Frame {
    /// x, y and z in the base frame, in mm.
    Base,
    /// Distances from the current position along x, y and z, in mm.
    Current,
    /// The distance from the base axis in mm, the angle about it in degrees, and the height in mm.
    Polar,
}

impl Frame {
    /// Returns the target for an arm with this status.
    fn place(self, axes: [Option<f32>; 4], from: &Status) -> TargetPlace {
        let [first, second, z, rotation] = axes;
        let (z_mm, mut rotation_deg) = (z.unwrap_or(from.z_mm), rotation);
        let mm = match self {
            Self::Base => [
                first.unwrap_or(from.x_mm),
                second.unwrap_or(from.y_mm),
                z_mm,
            ],
            Self::Current => {
                rotation_deg = rotation.map(|by_deg| from.rotation_deg + by_deg);
                let by = |distance: Option<f32>| distance.unwrap_or(0.0);
                [
                    from.x_mm + by(first),
                    from.y_mm + by(second),
                    from.z_mm + by(z),
                ]
            }
            Self::Polar => {
                let reach_mm = first.unwrap_or_else(|| from.x_mm.hypot(from.y_mm));
                let angle = second.map_or_else(|| from.y_mm.atan2(from.x_mm), f32::to_radians);
                [reach_mm * angle.cos(), reach_mm * angle.sin(), z_mm]
            }
        };
        TargetPlace::Point { mm, rotation_deg }
    }
}

/// Whether the arm is at a place already, with any rotation.
fn is_here(place: &TargetPlace, from: &Status) -> bool {
    let (there, here) = match *place {
        TargetPlace::Point { mm, .. } => (mm, [from.x_mm, from.y_mm, from.z_mm]),
        TargetPlace::Joints(deg) => (deg, [from.base_deg, from.rear_deg, from.fore_deg]),
    };
    there
        .iter()
        .zip(here)
        .all(|(there, here)| (there - here).abs() < HERE)
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

/// Converts a position in mm to the numbers of a gesture packet for the arm of a state.
fn gesture_units([x_mm, y_mm, z_mm]: [f32; 3], state: &State) -> [f32; 3] {
    let mounted = state.settings.iter().find_map(|command| match command {
        Command::Configuration(Configuration::EndEffector { tool }) => Some(Tool::from(*tool)),
        _ => None,
    });
    let dialect = state.dialect.unwrap_or(Dialect::SPECIFICATION);
    let HandScale { x, y, z } = HandScale::of(&dialect, mounted.unwrap_or(Tool::SuctionCup));
    #[expect(
        clippy::cast_possible_truncation,
        reason = "the wire has single precision"
    )]
    let units =
        |axis: HandAxis, mm: f32| ((f64::from(mm) - axis.zero_mm) * axis.units_per_mm) as f32;
    [units(x, x_mm), units(y, y_mm), units(z, z_mm)]
}

fn unit_warning(place: TargetPlace) -> Option<String> {
    Some(place.unit_warning()?.to_string())
}

/// Returns a duration from Python.
fn seconds(name: &str, value: f64) -> PyResult<Duration> {
    Duration::try_from_secs_f64(value)
        .map_err(|_| PyValueError::new_err(format!("{name} is {value}; allowed are 0 or more")))
}

/// The difference of coordinates that is no motion, in mm or degrees: that of rounded numbers.
const HERE: f32 = 0.01;

fn mode(path: &str) -> PyResult<MovingMode> {
    let named = path.parse::<PathName>();
    let named = named.map_err(|error| PyValueError::new_err(format!("path is `{path}`; {error}")));
    Ok(named?.0)
}
