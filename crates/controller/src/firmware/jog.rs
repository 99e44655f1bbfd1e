//! States 2 and 7 of the stock controller: jogging (note N44).

use dobot_arm::stock::short;
use dobot_wire::Frame;

use super::TickOutcome;
use super::body::{Body, PERIOD_S};
use super::settings::{RampSettings, StockSettings};
use crate::outputs::servo_value;
use crate::{Hang, Port};

/// The speed shared by all axes and both kinds of jog; it persists across other commands.
#[derive(Debug, Default)]
pub(crate) struct Jog {
    speed: f32,
    /// The last axis that was held.
    axis: i16,
    /// The acceleration of the last tick with a held button, which the deceleration keeps.
    acceleration: f32,
    /// Whether a limit has refused the deceleration, which is then finished although it runs on.
    is_refused: bool,
}

/// The kind of jog.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum JogKind {
    Joint,
    Linear,
}

impl Jog {
    /// Whether the speed is 0.
    pub(crate) fn is_released(&self) -> bool {
        self.speed == 0.0
    }

    pub(crate) const fn clear(&mut self) {
        self.is_refused = false;
    }

    /// Runs a tick of a jog. It is finished in every tick, so a waiting command replaces it.
    pub(crate) fn tick(
        &mut self,
        kind: JogKind,
        frame: &Frame,
        port: Port,
        settings: &StockSettings,
        body: &mut Body,
    ) -> TickOutcome {
        let outcome = match short(frame.float(2)) {
            0 => self.release(kind, body),
            9 => return press(body, |body| body.grab(true, body.gripper_deg)),
            10 => return press(body, |body| body.grab(false, body.gripper_deg)),
            13 => return press(body, |body| body.hands.laser = true),
            14 => return press(body, |body| body.hands.laser = false),
            axis @ (1..=8 | 11 | 12) => {
                let axis = received_axis(kind, axis, frame, port);
                self.hold(kind, axis, frame.float(8), settings, body)
            }
            axis => TickOutcome::hangs(Hang::JogAxis(axis)),
        };
        body.turn_head(body.joints.servo_deg);
        body.hands.gripper_servo = servo_value(body.gripper_deg);
        outcome
    }

    fn hold(
        &mut self,
        kind: JogKind,
        axis: i16,
        percent: f32,
        settings: &StockSettings,
        body: &mut Body,
    ) -> TickOutcome {
        self.axis = axis;
        let ramp = ramp(kind, axis, settings);
        let max = ramp.speed * (percent / 100.0);
        self.acceleration = ramp.acceleration;
        let change = self.acceleration * PERIOD_S;
        let sign = if axis % 2 == 1 { 1.0 } else { -1.0 };
        self.speed = if sign * self.speed < max {
            self.speed + sign * change
        } else {
            sign * max
        };
        TickOutcome::over(self.advance(kind, body))
    }

    /// Decelerates; the command ends when the speed is 0.
    fn release(&mut self, kind: JogKind, body: &mut Body) -> TickOutcome {
        if self.speed == 0.0 {
            return TickOutcome::OVER;
        }
        let change = self.acceleration * PERIOD_S;
        let is_plus = self.axis % 2 == 1;
        let runs = if is_plus {
            self.speed > 0.0
        } else {
            self.speed < 0.0
        };
        if !runs {
            self.speed = 0.0;
            return TickOutcome::over(self.advance(kind, body));
        }
        self.speed += if is_plus { -change } else { change };
        let advanced = self.advance(kind, body);
        self.is_refused |= !advanced;
        if self.is_refused {
            TickOutcome::over(advanced)
        } else {
            TickOutcome::GOES_ON
        }
    }

    fn advance(&self, kind: JogKind, body: &mut Body) -> bool {
        let speed = self.speed;
        let mut pose = body.pose;
        match (kind, self.axis) {
            (_, 11 | 12) => {
                body.gripper_deg += speed * PERIOD_S;
                return true;
            }
            (JogKind::Joint, 1 | 2) => return body.advance([speed, 0.0, 0.0, 0.0]),
            (JogKind::Joint, 3 | 4) => return body.advance([0.0, speed, 0.0, 0.0]),
            (JogKind::Joint, 5 | 6) => return body.advance([0.0, 0.0, speed, 0.0]),
            (JogKind::Joint, _) => return body.advance([0.0, 0.0, 0.0, speed]),
            (JogKind::Linear, 1 | 2) => pose.x_mm += speed * PERIOD_S,
            (JogKind::Linear, 3 | 4) => pose.y_mm += speed * PERIOD_S,
            (JogKind::Linear, 5 | 6) => pose.z_mm += speed * PERIOD_S,
            (JogKind::Linear, _) => pose.rotation_deg += speed * PERIOD_S,
        }
        body.advance_to(pose)
    }
}

fn press(body: &mut Body, button: impl Fn(&mut Body)) -> TickOutcome {
    button(body);
    TickOutcome::OVER
}

const fn ramp(kind: JogKind, axis: i16, settings: &StockSettings) -> RampSettings {
    match (axis, kind) {
        (7 | 8 | 11 | 12, _) => settings.jog_servo,
        (_, JogKind::Joint) => settings.jog_joint,
        (_, JogKind::Linear) => settings.jog_line,
    }
}

/// The axis that a button moves.
fn received_axis(kind: JogKind, axis: i16, frame: &Frame, port: Port) -> i16 {
    let is_exchanged = port == Port::Bluetooth && frame.float(1) == JOINT_JOG;
    if kind == JogKind::Joint && is_exchanged {
        exchanged(axis)
    } else {
        axis
    }
}

/// The state whose axes are exchanged over Bluetooth, compared exactly: 2.5 is also a joint jog.
const JOINT_JOG: f32 = 2.0;

/// Maps the axes of joint jogs over Bluetooth (note N38).
const fn exchanged(axis: i16) -> i16 {
    match axis {
        1 => 3,
        2 => 4,
        3 => 1,
        4 => 2,
        5 => 6,
        6 => 5,
        other => other,
    }
}
