//! The program of the published document: every bad input is refused, no limit is ever passed.
//!
//! Its motions are functions of time: the next one begins in the very instant in which the last one
//! ends, and where the arm is can be asked for any time between.

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

/// What the controller does by the document.
#[derive(Debug)]
pub(crate) struct Specification {
    decoder: Decoder<Commands>,
    queue: Deque<Command, QUEUE_LEN>,
    /// What the arm is; for a controller belief is truth.
    model: Model,
    running: Option<Running>,
    /// Where the motors were told to go by the tick before.
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

    /// When the motion ends that is going on.
    pub(crate) fn wakeup(&self) -> Option<Duration> {
        self.running.as_ref().map(|it| it.ends)
    }

    /// Goes on with what waits, if a motion is over.
    pub(crate) fn handle_time(&mut self, at: Duration, log: &mut Log) {
        if self.wakeup().is_some_and(|it| it <= at) {
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

    /// Whether nothing happens until something arrives.
    pub(crate) fn is_at_rest(&self) -> bool {
        self.running.is_none() && self.queue.is_empty()
    }

    pub(crate) fn status(&self) -> Frame {
        self.model.status().emit()
    }

    /// How far the joints went since this was asked last, in degrees: base, rear, fore.
    pub(crate) fn take_way_deg(&mut self) -> [f32; 3] {
        let to = self.model.place.joints;
        let from = core::mem::replace(&mut self.stepped_to, to);
        [
            to.base - from.base,
            to.rear - from.rear,
            to.fore - from.fore,
        ]
        .map(|it| single(it.0))
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
            .and_then(|it| it.place_at(at))
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

    /// New angles without a motion are nothing for the motors.
    fn forget_way(&mut self, then: &Joints) {
        let now = &self.model.place.joints;
        self.stepped_to.base += then.base - now.base;
        self.stepped_to.rear += then.rear - now.rear;
        self.stepped_to.fore += then.fore - now.fore;
    }

    /// Brings the state to where the motion has come.
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

    /// Ends the motion that is over now.
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

    /// The motion of a command is over: set the tool, and end the stroke (note N36).
    fn arrive(&mut self, command: &Command, trajectory: &Trajectory) {
        let laser = self.model.laser;
        self.model = self.model.after(command, trajectory);
        if matches!(command, Command::WriteVector(_))
            && matches!(self.queue.front(), Some(Command::WriteVector(_)))
        {
            self.model.laser = laser;
        }
    }

    /// Begins what waits: commands without motion one after the other, up to one that moves.
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
            self.forget_way(&after.place.joints);
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

    /// While the arm jogs, buttons act at once; any other command waits until it has come to rest.
    fn obey_buttons(&mut self, at: Duration, log: &mut Log) {
        while let Some(Running {
            motion: Motion::Jog(jog),
            began,
            ends,
            ..
        }) = self.running
            && let Some(command) = self.queue.front()
        {
            let t_s = at.saturating_sub(began).as_secs_f64();
            let next = match Button::of(command) {
                Some(Button::Suction(on)) => {
                    self.model.suction = on;
                    Next::Go
                }
                Some(Button::Laser(on)) => {
                    self.model.laser = on;
                    Next::Go
                }
                Some(Button::Held { axis, share }) if axis == jog.axis() => {
                    JogTrajectory::start(&self.model, axis, share, jog.speed_at(t_s))
                        .map_or(Next::Go, |jog| Next::Jog(jog, Duration::MAX))
                }
                Some(Button::Released) => self.released(&jog, t_s),
                // Anything else stays in the queue until the jog has run down.
                _ if ends == Duration::MAX => {
                    if let Next::Jog(jog, lasts) = self.released(&jog, t_s) {
                        self.run(&Motion::Jog(jog), at, lasts);
                    }
                    return;
                }
                _ => return,
            };
            self.queue.pop_front();
            log.begun();
            if let Next::Jog(jog, lasts) = next {
                self.run(&Motion::Jog(jog), at, lasts);
            }
        }
    }

    fn released(&self, jog: &JogTrajectory, t_s: f64) -> Next {
        jog.release(&self.model, t_s).map_or(Next::Go, |jog| {
            let lasts = Duration::try_from_secs_f64(jog.change_s());
            Next::Jog(jog, lasts.unwrap_or_default())
        })
    }

    /// Stops a jog that would be beyond a limit one tick later. An arm that stands outside of the
    /// limits may be jogged back in.
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
                running.expect("it was seen just above").ahead = place.map(|it| (next, it));
            }
        }
    }

    /// Where a jog leads, if it moves the arm, and the arm may go there.
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

/// What a button leads to while the arm jogs.
enum Next {
    /// The jog goes on.
    Go,
    /// Another one, for so long.
    Jog(JogTrajectory, Duration),
}

/// Whether a command takes its time; all others act at once.
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
