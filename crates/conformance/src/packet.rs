//! Packets of the checks: floats by number, because the dialect is unknown.

use dobot_wire::{Dialect, Frame, JointJog, Status};

/// A button (states 2 and 7; Table 3.5).
pub(crate) fn jog(state: f32, axis: f32, percent: f32) -> Frame {
    Frame::ZERO.with(1, state).with(2, axis).with(8, percent)
}

/// The packet that does over Bluetooth what this one does over USB: joint jogs have other axes there
/// (note N38).
pub(crate) fn over_bluetooth(frame: Frame) -> Frame {
    // Joint jogs are the same in every dialect.
    let dialect = Dialect::FIRMWARE_1_1;
    let jog = JointJog::parse(&frame, &dialect);
    jog.map_or(frame, |jog| jog.over_bluetooth().emit(&dialect))
}

/// A target (states 3 and 6; Table 3.7) with pump and gripper of a status.
fn target(state: f32, [a, b, c]: [f32; 3], turn: f32, mode: f32, now: &Status) -> Frame {
    Frame::ZERO
        .with(1, state)
        .with(3, a)
        .with(4, b)
        .with(5, c)
        .with(6, turn)
        .with(7, f32::from(now.suction))
        .with(8, mode)
        .with(9, now.gripper_deg)
}

/// A point, with the rotation, the pump and the gripper of a status (state 3).
pub(crate) fn point(at: [f32; 3], mode: f32, now: &Status) -> Frame {
    target(3.0, at, now.rotation_deg, mode, now)
}

/// The joint angles of a status, with its pump and its gripper (state 6).
pub(crate) fn angles(of: &Status, mode: f32) -> Frame {
    let arms = [of.base_deg, of.rear_deg, of.fore_deg];
    target(6.0, arms, of.servo_deg, mode, of)
}

/// A write vector (state 4; Table 2.6).
pub(crate) fn vector([a, b, c]: [f32; 3], start: f32, max: f32) -> Frame {
    Frame::ZERO
        .with(1, 4.0)
        .with(3, a)
        .with(4, b)
        .with(5, c)
        .with(8, start)
        .with(10, max)
}

/// A configuration (state 9; Table 3.9).
pub(crate) fn configuration(mode: f32, values: &[f32]) -> Frame {
    let frame = Frame::ZERO.with(1, 9.0).with(2, mode);
    let numbered = values.iter().zip(3..);
    numbered.fold(frame, |frame, (&value, n)| frame.with(n, value))
}

/// Teach configuration (state 9, mode 0).
pub(crate) fn teach(joint_speed_deg_s: f32) -> Frame {
    configuration(0.0, &[joint_speed_deg_s, 50.0, 30.0, 50.0, 60.0, 60.0])
}

/// Playback configuration (state 9, mode 1): joints and servo alike.
pub(crate) fn playback(joints: [f32; 2], line: [f32; 2], pause_s: f32, height_mm: f32) -> Frame {
    let [speed, acceleration] = joints;
    configuration(
        1.0,
        &[
            speed,
            acceleration,
            speed,
            acceleration,
            line[0],
            line[1],
            pause_s,
            height_mm,
        ],
    )
}

/// The settings of the checks: slow moves and a low JUMP.
pub(crate) fn gentle(pause_s: f32) -> Frame {
    playback([30.0, 200.0], [80.0, 200.0], pause_s, JUMP_MM)
}

/// Acceleration of writing (state 9, mode 2).
pub(crate) fn writing(acceleration_mm_s2: f32) -> Frame {
    configuration(2.0, &[acceleration_mm_s2])
}

/// The end effector (state 9, mode 4).
pub(crate) fn tool(number: f32) -> Frame {
    configuration(4.0, &[number])
}

/// The percentages (state 10); the order of the first two depends on the dialect.
pub(crate) fn percent(float_3: f32, float_4: f32) -> Frame {
    Frame::ZERO
        .with(1, 10.0)
        .with(3, float_3)
        .with(4, float_4)
        .with(5, 100.0)
}

pub(crate) const SUCTION_CUP: f32 = 0.0;
pub(crate) const LASER: f32 = 2.0;
/// The height of a JUMP while the checks run.
pub(crate) const JUMP_MM: f32 = 5.0;
/// The power-up settings of a stock arm.
pub(crate) const STOCK_TEACH_DEG_S: f32 = 15.0;
pub(crate) const STOCK_WRITING_MM_S2: f32 = 100.0;
