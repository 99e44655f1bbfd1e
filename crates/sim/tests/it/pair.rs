//! Client and virtual arm in one process, in virtual time.

mod moves;
mod pauses;
mod programs;
mod strokes;
mod times;

use std::time::Duration;

use crate::common::{
    POWER_UP_X_MM, button, completed, in_process, move_to, ms, playback, refusals, run, run_with,
    vector, virtual_arm,
};
use dobot_arm::Position;
use dobot_controller::Refused;
use dobot_motion::TrajectoryError;
use dobot_session::{CommandId, Connection, Event, Peer};
use dobot_sim::{InProcess, Sample};
use dobot_wire::{
    Command, Configuration, Dialect, EndEffector, JointJogAxis, LinearJog, LinearJogAxis,
    MouseMove, MoveJoints, MoveTo, MovingMode, PlaybackAdjustment, Voice, WriteVector,
};

fn connect(peer: &InProcess) -> Connection {
    Connection::over_peer(peer.clone(), Some(Dialect::SPECIFICATION))
}

fn found(peer: &InProcess) -> Position {
    let arm = peer.arm();
    arm.controller().pose_at(arm.now()).position
}

#[track_caller]
fn assert_at(found: Position, x_mm: f64, y_mm: f64, z_mm: f64, tolerance_mm: f64) {
    let apart_mm = found.distance(Position::new(x_mm, y_mm, z_mm)).0;
    assert!(
        apart_mm <= tolerance_mm,
        "the arm is at {found:?}, {apart_mm} mm from {x_mm}, {y_mm}, {z_mm}; tolerance {tolerance_mm}"
    );
}
