//! The program of stock arms (firmware 1.1): its rounding, limits and traps (notes N37 to N51).
//!
//! It calculates in single precision, tick by tick, from its estimate of the arm. It does not validate
//! its input, so this module works on floats, not on commands: it divides by a speed of zero, and NaN
//! passes every limit.

mod ahead;
mod body;
mod fifo;
mod follow;
mod jog;
mod joint_motion;
mod line;
mod outcome;
mod printer;
mod receiver;
mod settings;
mod spoken;
mod target;
mod work;
mod write;

use core::time::Duration;

use dobot_arm::stock::{StockJoints, short};
use dobot_arm::{Joints, Pose};
use dobot_wire::{Frame, Status};

use self::body::Body;
use self::fifo::Fifo;
use self::follow::Follow;
use self::jog::Jog;
use self::line::StraightLine;
use self::outcome::{Progress, TickOutcome};
use self::printer::Printer;
use self::receiver::{Received, Receiver, VOICE_HEADER};
use self::settings::StockSettings;
use self::spoken::{InFlight, Spoken, SpokenWords};
use self::target::Travel;
use self::work::Work;
use self::write::Write;
use crate::log::Log;
use crate::outputs::Hands;
use crate::{Hang, Port, PowerUp, Refused};

/// The program of stock arms.
#[derive(Debug)]
pub(crate) struct Firmware {
    port: Port,
    receiver: Receiver,
    serial: SerialReceiver,
    printer: Printer,
    fifo: Fifo,
    body: Body,
    settings: StockSettings,
    in_force: InForce,
    travel: Travel,
    line: StraightLine,
    jog: Jog,
    write: Write,
    follow: Follow,
    spoken: Spoken,
    /// The data of the status: except for the pump, as before the last tick that could send one.
    snapshot: Status,
    /// The calculation time of the tick.
    computing: Duration,
    /// The motor positions at the start of a tick and after its pulses.
    sent: [StockJoints; 2],
    is_lost: bool,
}

/// The state of the receive routine, which it prints on the other port.
#[derive(Debug, Default)]
struct SerialReceiver {
    packets: u32,
    bad_tails: u32,
    too_long: u32,
    /// Whether every fetched command is treated as voice.
    is_voice: bool,
}

/// The current command. It is evaluated in every tick, even when it is finished.
#[derive(Debug)]
struct InForce {
    frame: Frame,
    state: i16,
    is_finished: bool,
    /// Its state in the previous tick.
    state_before: i16,
    /// Whether its first tick is still to come.
    is_new: bool,
    /// Whether a notice about it was logged.
    is_reported: bool,
}

impl InForce {
    const fn idle() -> Self {
        Self {
            frame: Frame::ZERO,
            state: IDLE,
            is_finished: true,
            state_before: IDLE,
            is_new: false,
            is_reported: false,
        }
    }
}

impl Firmware {
    pub(crate) fn power_up(power_up: &PowerUp) -> Self {
        let body = Body::power_up(power_up.rear_deg, power_up.fore_deg);
        Self {
            port: power_up.port,
            receiver: Receiver::new(power_up.port),
            serial: SerialReceiver::default(),
            printer: Printer::default(),
            fifo: Fifo::new(),
            settings: StockSettings::new(),
            in_force: InForce::idle(),
            travel: Travel::default(),
            line: StraightLine::default(),
            jog: Jog::default(),
            write: Write::default(),
            follow: Follow::default(),
            spoken: Spoken::default(),
            snapshot: status(&body),
            computing: Duration::ZERO,
            sent: [body.joints; 2],
            is_lost: false,
            body,
        }
    }

    /// Handles bytes that arrive now.
    pub(crate) fn handle_bytes(&mut self, now: Duration, bytes: &[u8], log: &mut Log) {
        self.receive(now, log);
        let mut rest = bytes;
        while !rest.is_empty() {
            rest = self.receiver.push(rest);
            if self.receiver.may_find() {
                self.receive(now, log);
            }
        }
        log.counters.skipped_bytes = self.receiver.skipped;
    }

    /// Runs a control tick. `may_send` is false if it certainly sends no status.
    pub(crate) fn tick(&mut self, at: Duration, may_send: bool, log: &mut Log) {
        self.receive(at, log);
        self.send();
        if may_send {
            self.snapshot = status(&self.body);
        }
        self.body.is_driven = false;
        if self.in_force.is_finished {
            self.fetch_next(log);
        }
        let outcome = self.dispatch();
        self.in_force.is_finished = outcome.is_over;
        self.body.is_planned &= !outcome.is_over;
        if let Some(notice) = outcome.notice
            && !self.in_force.is_reported
        {
            self.in_force.is_reported = true;
            log.refuse(notice);
        }
        self.body.settle();
        self.note_loss(log);
        self.compute(at);
    }

    fn fetch_next(&mut self, log: &mut Log) {
        if let Some(frame) = self.fifo.pop() {
            log.begun();
            self.fetch(frame);
        } else if self.fifo.len() > 0 {
            // An overfull queue returns nothing: the last command runs again.
            self.fetch(self.in_force.frame);
        }
    }

    pub(crate) const fn waiting(&self) -> usize {
        self.fifo.len()
    }

    /// Whether the current command is finished and none waits.
    pub(crate) fn is_at_rest(&self) -> bool {
        let InForce {
            state,
            is_finished,
            ref frame,
            ..
        } = self.in_force;
        // A release at a limit keeps decelerating.
        let is_jogging = matches!(state, JOINT_JOG | LINEAR_JOG)
            && (short(frame.float(2)) != 0 || !self.jog.is_released());
        is_finished && self.fifo.len() == 0 && !is_jogging
    }

    /// Runs a tick without effect.
    pub(crate) fn rest(&mut self, at: Duration) {
        self.receiver.set_busy_until(at + self.computing);
    }

    pub(crate) fn status(&self) -> Frame {
        Status {
            suction: self.body.hands.pump,
            ..self.snapshot
        }
        .emit()
    }

    /// The delay of a status after its tick.
    pub(crate) fn status_delay(&self) -> Duration {
        self.computing + SENDING
    }

    /// Takes the joint motion of the last tick, in degrees: base, rear, fore.
    pub(crate) const fn take_motion_deg(&mut self) -> [f32; 3] {
        core::mem::replace(&mut self.body.motion_deg, [0.0; 3])
    }

    /// Whether the motors repeat the previous tick although the pose is constant (note N50).
    pub(crate) const fn take_repeats(&mut self) -> bool {
        core::mem::replace(&mut self.body.repeats, false)
    }

    pub(crate) const fn hands(&self) -> Hands {
        self.body.hands
    }

    pub(crate) fn poll_other_port(&mut self) -> Option<u8> {
        self.printer.poll()
    }

    /// The joint angles at a fraction of the last tick, from 0 to 1.
    pub(crate) fn joints_at(&self, share: f64) -> Joints {
        let [from, to] = self.sent.map(|joints| {
            let angles = [
                joints.base_deg,
                joints.rear_deg,
                joints.fore_deg,
                joints.servo_deg,
            ];
            let [base, rear, fore, servo] = angles.map(f64::from);
            Joints::new(base, rear, fore, servo)
        });
        from.towards(&to, share)
    }

    pub(crate) fn pose_at(&self, share: f64) -> Pose {
        dobot_arm::forward(&self.joints_at(share), self.body.tool())
    }

    /// Searches the receive buffer, unless a tick is calculating.
    fn receive(&mut self, now: Duration, log: &mut Log) {
        if !self.receiver.is_empty() && !self.receiver.is_busy(now) {
            self.search(log);
        }
    }

    fn search(&mut self, log: &mut Log) {
        while let Some(found) = self.receiver.look() {
            self.take(&found, log);
        }
        if let Some(header) = self.receiver.begun() {
            self.interrupt(header);
        }
    }

    fn take(&mut self, found: &Received, log: &mut Log) {
        self.serial.packets += 1;
        match found {
            &Received::Frame(frame) => {
                log.counters.packets += 1;
                self.serial.is_voice = false;
                if !self.fifo.push(frame) {
                    log.refuse(Refused::QueueFull);
                }
            }
            Received::Voice(text) => {
                log.counters.packets += 1;
                self.receive_voice(&SpokenWords::find(text), log);
            }
            &Received::BadTail { header } => self.refuse_bad_tail(header, log),
            Received::TooLong => {
                self.serial.too_long += 1;
                log.refuse(Refused::TooLong);
            }
        }
        if self.port == Port::Usb {
            self.print_counters();
        }
    }

    fn refuse_bad_tail(&mut self, header: u8, log: &mut Log) {
        self.serial.bad_tails += 1;
        log.refuse(Refused::BadTail);
        self.interrupt(header);
        if self.port == Port::Bluetooth {
            self.printer.print(b"Invalid header!\r\n");
        }
    }

    fn print_counters(&mut self) {
        let serial = &self.serial;
        self.printer.print_number(serial.packets);
        self.printer.print(b",");
        self.printer.print_number(serial.bad_tails);
        self.printer.print(b",");
        self.printer.print_number(serial.too_long);
        self.printer.print(b"\r\n");
    }

    fn receive_voice(&mut self, words: &SpokenWords, log: &mut Log) {
        self.interrupt(VOICE_HEADER);
        if self.spoken.receive(words) {
            self.fifo.take_slot();
        } else {
            log.refuse(Refused::NotUnderstood);
        }
        words.echo(&mut self.printer);
    }

    /// Treats the current command as voice from the first byte of a text on.
    const fn interrupt(&mut self, header: u8) {
        self.serial.is_voice = header == VOICE_HEADER;
        if self.serial.is_voice {
            self.in_force.state = VOICE;
        }
    }

    /// Starts the motor pulses calculated in the previous tick.
    const fn send(&mut self) {
        self.sent[0] = self.sent[1];
        if !self.is_lost {
            self.sent[1] = self.body.joints;
        }
    }

    fn fetch(&mut self, frame: Frame) {
        self.in_force.frame = frame;
        self.in_force.state = if self.serial.is_voice {
            VOICE
        } else {
            short(frame.float(1))
        };
        self.in_force.is_finished = false;
        self.in_force.is_reported = false;
        self.in_force.is_new = true;
        self.jog.clear();
    }

    /// Runs a tick of the current command, finished or not.
    fn dispatch(&mut self) -> TickOutcome {
        let Self {
            in_force,
            settings,
            body,
            line,
            travel,
            ..
        } = self;
        let (frame, is_over) = (&in_force.frame, in_force.is_finished);
        let is_row = matches!(in_force.state, MOUSE | GESTURE);
        if is_row && in_force.state_before != in_force.state {
            self.follow.begin_sequence();
        }
        in_force.state_before = in_force.state;
        match in_force.state {
            MOUSE => self
                .follow
                .tick(follow::FollowKind::Mouse, frame, is_over, settings, body),
            JOINT_JOG => self
                .jog
                .tick(jog::JogKind::Joint, frame, self.port, settings, body),
            TARGET_POSE => travel.tick(
                target::TargetKind::Pose,
                frame,
                is_over,
                settings,
                line,
                body,
            ),
            WRITE => self.write.tick(frame, is_over, settings, body),
            VOICE => {
                let in_flight = InFlight {
                    text: self.receiver.begun() == Some(VOICE_HEADER),
                    fetched: in_force.is_new,
                };
                self.spoken.tick(is_over, in_flight, settings, line, body)
            }
            TARGET_JOINTS => travel.tick(
                target::TargetKind::Joints,
                frame,
                is_over,
                settings,
                line,
                body,
            ),
            LINEAR_JOG => self
                .jog
                .tick(jog::JogKind::Linear, frame, self.port, settings, body),
            GESTURE => {
                self.follow
                    .tick(follow::FollowKind::Gesture, frame, is_over, settings, body)
            }
            CONFIGURATION => {
                settings.configure(frame, body);
                in_force.state = IDLE;
                TickOutcome::OVER
            }
            ADJUSTMENT => {
                settings.adjust(frame);
                in_force.state = IDLE;
                TickOutcome::OVER
            }
            STATE_15 => {
                self.follow
                    .tick(follow::FollowKind::Joints, frame, is_over, settings, body)
            }
            _ if is_over => TickOutcome::OVER,
            state => TickOutcome::hangs(Hang::State(state)),
        }
    }

    /// Logs once that the pose is lost.
    fn note_loss(&mut self, log: &mut Log) {
        let was_lost = core::mem::replace(&mut self.is_lost, self.body.is_lost());
        if self.is_lost && !was_lost {
            log.refuse(Refused::PoseLost);
        }
    }

    /// Records the calculation time of this tick.
    fn compute(&mut self, at: Duration) {
        self.computing = self.work().time();
        self.receiver.set_busy_until(at + self.computing);
        self.in_force.is_new = false;
    }

    /// The calculation done in this tick.
    fn work(&self) -> Work {
        let InForce { state, is_new, .. } = self.in_force;
        let is_driven = self.body.is_driven;
        match state {
            TARGET_POSE | TARGET_JOINTS => self.work_for_target(),
            MOUSE if is_new => Work::PlanMouse,
            GESTURE | STATE_15 if is_new => Work::PlanGesture,
            _ if !is_driven => Work::Idle,
            JOINT_JOG => Work::JointJog,
            LINEAR_JOG => Work::LinearJog,
            WRITE if is_new => Work::PlanWrite,
            WRITE => Work::Write,
            VOICE => Work::Voice,
            _ => Work::Follow,
        }
    }

    fn work_for_target(&self) -> Work {
        let begins = self.in_force.is_new || self.travel.begins_phase();
        let is_driven = self.body.is_driven;
        match short(self.in_force.frame.float(8)) {
            target::JUMP if begins => Work::JumpPhase,
            target::MOVJ if begins => Work::PlanMovj,
            target::MOVL if is_driven => Work::Movl,
            _ if is_driven => Work::Movj,
            _ => Work::Idle,
        }
    }
}

const fn status(body: &Body) -> Status {
    Status {
        x_mm: body.pose.x_mm,
        y_mm: body.pose.y_mm,
        z_mm: body.pose.z_mm,
        rotation_deg: body.pose.rotation_deg,
        base_deg: body.joints.base_deg,
        rear_deg: body.joints.rear_deg,
        fore_deg: body.joints.fore_deg,
        servo_deg: body.joints.servo_deg,
        suction: body.hands.pump,
        gripper_deg: body.gripper_deg,
    }
}

const IDLE: i16 = 0;
const MOUSE: i16 = 1;
const JOINT_JOG: i16 = 2;
const TARGET_POSE: i16 = 3;
const WRITE: i16 = 4;
const VOICE: i16 = 5;
const TARGET_JOINTS: i16 = 6;
const LINEAR_JOG: i16 = 7;
const GESTURE: i16 = 8;
const CONFIGURATION: i16 = 9;
const ADJUSTMENT: i16 = 10;
const STATE_15: i16 = 15;
/// The time from the end of a tick's calculation to its status.
const SENDING: Duration = Duration::from_micros(600);
