//! The program of the published specification: every bad input is refused, no limit is passed.
//!
//! Its motions are functions of time: each starts exactly when the previous one ends, and the pose is
//! defined at any time between.

mod motion;

use core::time::Duration;

use dobot_arm::{Joints, Pose, TICK, Tool, Unreachable};
use dobot_motion::{ArmPlace, Button, JogAxis, JogTrajectory, Model, Trajectory};
use dobot_wire::{Command, Commands, Decoder, Dialect, Frame, Packet, VoiceOrder, single};
use heapless::Deque;

use self::motion::{Motion, Running};
use crate::log::Log;
use crate::outputs::{Hands, servo_value};
use crate::refused::QUEUE_LEN;
use crate::{PowerUp, Refused};

/// The program of the published specification.
#[derive(Debug)]
pub(crate) struct Specification {
    decoder: Decoder<Commands>,
    queue: Deque<Command, QUEUE_LEN>,
    /// The state of the arm as the controller has it.
    model: Model,
    running: Option<Running>,
    /// The joint angles sent to the motors in the previous tick.
    stepped_to: Joints,
}

impl Specification {
    pub(crate) fn power_up(power_up: &PowerUp) -> Self {
        let joints = Joints::new(0.0, power_up.rear_deg, power_up.fore_deg, 0.0);
        Self {
            decoder: Decoder::commands(),
            queue: Deque::new(),
            model: Model::standing(
                Dialect::SPECIFICATION,
                ArmPlace::at_joints(joints, Tool::SuctionCup),
            ),
            running: None,
            stepped_to: joints,
        }
    }

    pub(crate) fn handle_bytes(&mut self, bytes: &[u8], log: &mut Log) {
        // The iterator borrows the decoder, which is given back with its new lock.
        let mut decoder = core::mem::replace(&mut self.decoder, Decoder::commands());
        for packet in decoder.feed(bytes) {
            self.handle_packet(&packet, log);
        }
        log.counters.skipped_bytes = decoder.counts().skipped_bytes;
        self.decoder = decoder;
    }

    /// The end time of the current motion.
    pub(crate) fn wakeup(&self) -> Option<Duration> {
        self.running.as_ref().map(|running| running.ends)
    }

    /// Starts the next command when a motion has ended.
    pub(crate) fn handle_time(&mut self, at: Duration, log: &mut Log) {
        if self.wakeup().is_some_and(|wakeup| wakeup <= at) {
            self.finish(at);
            self.begin_next(at, log);
        }
    }

    pub(crate) fn tick(&mut self, at: Duration, log: &mut Log) {
        self.settle(at);
        self.obey_buttons(at, log);
        self.guard(at, log);
        if self.running.is_none() {
            self.begin_next(at, log);
        }
    }

    pub(crate) const fn waiting(&self) -> usize {
        self.queue.len()
    }

    /// Whether the program is idle until a byte arrives.
    pub(crate) fn is_at_rest(&self) -> bool {
        self.running.is_none() && self.queue.is_empty()
    }

    pub(crate) fn status(&self) -> Frame {
        self.model.status().emit()
    }

    /// Takes the joint motion since the last call, in degrees: base, rear, fore.
    pub(crate) fn take_motion_deg(&mut self) -> [f32; 3] {
        let to = self.model.place.joints;
        let from = core::mem::replace(&mut self.stepped_to, to);
        [
            to.base - from.base,
            to.rear - from.rear,
            to.fore - from.fore,
        ]
        .map(|angle| single(angle.0))
    }

    pub(crate) fn pose_at(&self, at: Duration) -> Pose {
        self.place_at(at).pose
    }

    pub(crate) fn joints_at(&self, at: Duration) -> Joints {
        self.place_at(at).joints
    }

    pub(crate) fn hands(&self) -> Hands {
        Hands {
            head_servo: servo_value(single(self.model.place.joints.servo.0)),
            gripper_servo: servo_value(single(self.model.gripper_deg)),
            pump: self.model.suction,
            valve: self.model.suction,
            laser: self.model.laser,
        }
    }

    fn place_at(&self, at: Duration) -> ArmPlace {
        self.running
            .as_ref()
            .and_then(|running| running.place_at(at))
            .and_then(Result::ok)
            .unwrap_or(self.model.place)
    }

    fn handle_packet(&mut self, packet: &Packet, log: &mut Log) {
        log.counters.packets += 1;
        match Command::parse(packet, &Dialect::SPECIFICATION) {
            Err(error) => log.refuse(Refused::Unreadable(error)),
            Ok(command) => {
                if self.queue.push_back(command).is_err() {
                    log.refuse(Refused::QueueFull);
                }
            }
        }
    }

    /// Adopts new angles without a motion of the motors.
    fn adopt_angles(&mut self, then: &Joints) {
        let now = &self.model.place.joints;
        self.stepped_to.base += then.base - now.base;
        self.stepped_to.rear += then.rear - now.rear;
        self.stepped_to.fore += then.fore - now.fore;
    }

    /// Updates the state to the current point of the motion.
    fn settle(&mut self, at: Duration) {
        self.model.place = self.place_at(at);
        if let Some(Running {
            motion: Motion::Jog(jog),
            began,
            ..
        }) = &self.running
        {
            self.model.gripper_deg = jog.gripper_deg_at(at.saturating_sub(*began).as_secs_f64());
        }
    }

    /// Ends the motion that is complete.
    fn finish(&mut self, at: Duration) {
        self.settle(at);
        let Some(running) = self.running.take() else {
            return;
        };
        if let Motion::Trajectory(command, trajectory) = running.motion {
            self.arrive(&command, &trajectory);
            let pause = Duration::try_from_secs_f64(trajectory.pause_s()).unwrap_or_default();
            if pause > Duration::ZERO {
                self.run(&Motion::Pause, at, pause);
            }
        }
    }

    /// Sets the tool and ends the stroke after the motion of a command (note N36).
    fn arrive(&mut self, command: &Command, trajectory: &Trajectory) {
        let laser = self.model.laser;
        self.model = self.model.after(command, trajectory);
        if matches!(command, Command::WriteVector(_))
            && matches!(self.queue.front(), Some(Command::WriteVector(_)))
        {
            self.model.laser = laser;
        }
    }

    /// Starts waiting commands: those without motion in turn, up to one that moves.
    fn begin_next(&mut self, at: Duration, log: &mut Log) {
        while self.running.is_none()
            && let Some(command) = self.queue.pop_front()
        {
            if let Err(refused) = self.begin(&command, at, log) {
                self.model.laser = false;
                log.refuse(refused);
            }
        }
    }

    fn begin(&mut self, command: &Command, at: Duration, log: &mut Log) -> Result<(), Refused> {
        let trajectory = self.model.trajectory(command)?;
        trajectory.check()?;
        if let Some(jog) = trajectory.jog() {
            self.run(&Motion::Jog(jog), at, Duration::MAX);
        } else if is_motion(command) {
            self.model = self.model.begun(command);
            let lasts = trajectory.motion_s().map(Duration::try_from_secs_f64);
            let lasts = lasts.and_then(Result::ok).unwrap_or(Duration::MAX);
            self.run(&Motion::Trajectory(*command, trajectory), at, lasts);
        } else {
            let after = self.model.after(command, &trajectory);
            self.adopt_angles(&after.place.joints);
            self.model = after;
        }
        log.begun();
        self.guard(at, log);
        Ok(())
    }

    fn run(&mut self, motion: &Motion, began: Duration, lasts: Duration) {
        self.running = Some(Running {
            motion: *motion,
            began,
            ends: began.saturating_add(lasts),
            ahead: None,
        });
    }

    /// Handles buttons immediately during a jog; other commands wait until the arm is at rest.
    fn obey_buttons(&mut self, at: Duration, log: &mut Log) {
        while let Some(Running {
            motion: Motion::Jog(jog),
            began,
            ends,
            ..
        }) = self.running
            && let Some(button) = self.queue.front().map(Button::of)
        {
            let t_s = at.saturating_sub(began).as_secs_f64();
            let Some(next) = self.press(button, &jog, t_s) else {
                // Other commands stay in the queue until the jog has decelerated.
                if ends == Duration::MAX
                    && let Next::Jog(jog, lasts) = self.released(&jog, t_s)
                {
                    self.run(&Motion::Jog(jog), at, lasts);
                }
                return;
            };
            self.queue.pop_front();
            log.begun();
            if let Next::Jog(jog, lasts) = next {
                self.run(&Motion::Jog(jog), at, lasts);
            }
        }
    }

    /// Handles a button during a jog; `None` if it has to wait.
    fn press(&mut self, button: Option<Button>, jog: &JogTrajectory, t_s: f64) -> Option<Next> {
        match button? {
            Button::Suction(on) => self.model.suction = on,
            Button::Laser(on) => self.model.laser = on,
            Button::Held { axis, share } if axis == jog.axis() => {
                let next = JogTrajectory::start(&self.model, axis, share, jog.speed_at(t_s));
                return Some(next.map_or(Next::Go, |jog| Next::Jog(jog, Duration::MAX)));
            }
            Button::Held { .. } => return None,
            Button::Released => return Some(self.released(jog, t_s)),
        }
        Some(Next::Go)
    }

    fn released(&self, jog: &JogTrajectory, t_s: f64) -> Next {
        jog.release(&self.model, t_s).map_or(Next::Go, |jog| {
            let lasts = Duration::try_from_secs_f64(jog.change_s());
            Next::Jog(jog, lasts.unwrap_or_default())
        })
    }

    /// Stops a jog that would pass a limit one tick later. An arm outside the limits can be jogged back
    /// in.
    fn guard(&mut self, at: Duration, log: &mut Log) {
        let Some(running) = &self.running else {
            return;
        };
        let Motion::Jog(jog) = running.motion else {
            return;
        };
        let next = running.ends.min(at + TICK);
        match self.look_ahead(&jog, next.saturating_sub(running.began)) {
            Err(refused) => {
                self.running = None;
                log.refuse(refused);
            }
            Ok(place) => {
                let running = self.running.as_mut();
                running.expect("checked above").ahead = place.map(|place| (next, place));
            }
        }
    }

    /// The pose that a jog leads to, if it moves the arm and the pose is allowed.
    fn look_ahead(&self, jog: &JogTrajectory, time: Duration) -> Result<Option<ArmPlace>, Refused> {
        let t_s = time.as_secs_f64();
        let gripper_deg = jog.gripper_deg_at(t_s);
        if gripper_deg.abs() > GRIPPER_DEG && gripper_deg.abs() > self.model.gripper_deg.abs() {
            return Err(Refused::GripperAtLimit { found: gripper_deg });
        }
        if jog.axis() == JogAxis::Gripper {
            return Ok(None);
        }
        let ahead = jog.place_at(t_s);
        let Err(error) = ahead.and_then(|place| place.check()) else {
            return Ok(ahead.ok());
        };
        let returning = |now: Unreachable| error.excess() < now.excess();
        if self.model.place.check().is_err_and(returning) {
            return Ok(ahead.ok());
        }
        Err(Refused::AtLimit(error))
    }
}

/// The effect of a button during a jog.
enum Next {
    /// The jog continues.
    Go,
    /// Another motion with its duration.
    Jog(JogTrajectory, Duration),
}

/// Whether a command takes time; all others act immediately.
fn is_motion(command: &Command) -> bool {
    match command {
        Command::MoveTo(_)
        | Command::MoveJoints(_)
        | Command::MouseMove(_)
        | Command::Gesture(_) => true,
        Command::WriteVector(vector) => !vector.stop,
        Command::Voice(voice) => matches!(VoiceOrder::parse(voice), Some(VoiceOrder::Move { .. })),
        _ => false,
    }
}

/// Table 3.7.
const GRIPPER_DEG: f64 = 90.0;
