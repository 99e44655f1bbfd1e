//! The configurable settings of the stock controller (Table 3.9, note N43).

use dobot_arm::stock::short;
use dobot_wire::Frame;

use super::body::{Body, LASER_MM, LONG_TOOL_MM};

/// Speeds and accelerations, in degrees, millimetres and seconds. Values are not checked: a
/// zero is accepted.
#[derive(Debug)]
pub(crate) struct StockSettings {
    /// Of the joints in moves: base, rear, fore, servo.
    pub(crate) joint_speeds: [f32; 4],
    pub(crate) joint_accelerations: [f32; 4],
    pub(crate) line: RampSettings,
    pub(crate) speed_ratio: f32,
    pub(crate) acceleration_ratio: f32,
    pub(crate) jog_joint: RampSettings,
    pub(crate) jog_servo: RampSettings,
    pub(crate) jog_line: RampSettings,
    pub(crate) write_acceleration: f32,
    pub(crate) jump_height_mm: f32,
    /// The lowest target of mouse and gesture, by tool.
    pub(crate) lowest_mm: f32,
}

/// A speed and its acceleration.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RampSettings {
    pub(crate) speed: f32,
    pub(crate) acceleration: f32,
}

impl StockSettings {
    pub(crate) fn new() -> Self {
        Self {
            joint_speeds: [200.0; 4],
            joint_accelerations: [200.0; 4],
            line: ramp(100.0, 200.0),
            speed_ratio: 0.5,
            acceleration_ratio: 0.5,
            jog_joint: ramp(15.0, 50.0),
            jog_servo: ramp(30.0, 50.0),
            jog_line: ramp(60.0, 60.0),
            write_acceleration: 100.0,
            jump_height_mm: dobot_wire::Dialect::FIRMWARE_1_1.default_jump_height_mm,
            lowest_mm: LOW_MM,
        }
    }

    /// Handles state 9.
    pub(crate) fn configure(&mut self, frame: &Frame, body: &mut Body) {
        let f = |n| frame.float(n);
        match short(f(2)) {
            0 => {
                self.jog_joint = ramp(f(3), f(4));
                self.jog_servo = ramp(f(5), f(6));
                self.jog_line = ramp(f(7), f(8));
            }
            1 => {
                self.joint_speeds = [f(3), f(3), f(3), f(5)];
                self.joint_accelerations = [f(4), f(4), f(4), f(6)];
                self.line = ramp(f(7), f(8));
                self.jump_height_mm = f(10);
            }
            2 => self.write_acceleration = f(3),
            3 => body.set_arms(0.0, 90.0 - f(3), f(4)),
            4 => self.mount(f(3), body),
            _ => {}
        }
    }

    /// Handles state 10. Float 5, the jog ratio, has no effect: each jog has its own.
    pub(crate) fn adjust(&mut self, frame: &Frame) {
        self.speed_ratio = frame.float(3) / 100.0;
        self.acceleration_ratio = frame.float(4) / 100.0;
    }

    /// The joints' speeds and accelerations in moves.
    pub(crate) fn joint_ramps(&self) -> [RampSettings; 4] {
        core::array::from_fn(|axis| RampSettings {
            speed: self.joint_speeds[axis] * self.speed_ratio,
            acceleration: self.joint_accelerations[axis] * self.acceleration_ratio,
        })
    }

    pub(crate) fn line_ramp(&self) -> RampSettings {
        RampSettings {
            speed: self.line.speed * self.speed_ratio,
            acceleration: self.line.acceleration * self.acceleration_ratio,
        }
    }

    fn mount(&mut self, tool: f32, body: &mut Body) {
        let (tool_mm, lowest_mm) = match tool {
            0.0 => (LONG_TOOL_MM, LOW_MM),
            1.0 => (LONG_TOOL_MM, GRIPPER_LOW_MM),
            2.0 => (LASER_MM, LOW_MM),
            _ => return,
        };
        self.lowest_mm = lowest_mm;
        body.set_tool(tool_mm);
    }
}

const fn ramp(speed: f32, acceleration: f32) -> RampSettings {
    RampSettings {
        speed,
        acceleration,
    }
}

const LOW_MM: f32 = -30.0;
const GRIPPER_LOW_MM: f32 = 20.0;
