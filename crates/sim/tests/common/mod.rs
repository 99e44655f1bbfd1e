//! What the tests have in common: commands in short, and a client that runs a program.

#![allow(dead_code, reason = "each test file uses its part")]

use std::time::Duration;

use dobot_controller::{Controller, PowerUp, Refused};
use dobot_session::{CommandId, Connection, Event};
use dobot_sim::{InProcess, SerialLine, VirtualArm};
use dobot_wire::{Command, Configuration, JointJog, JointJogAxis, MoveTo, MovingMode, WriteVector};

/// Where the arm is after power-up: rear arm and forearm at 45 degrees.
pub(crate) const POWER_UP_X_MM: f64 = 263.666_500_4;

pub(crate) fn virtual_arm() -> VirtualArm {
    VirtualArm::new(Controller::power_up(PowerUp::default()), SerialLine::STOCK)
}

pub(crate) fn in_process() -> InProcess {
    InProcess::new(virtual_arm())
}

pub(crate) fn move_to(mode: MovingMode, x_mm: f32, y_mm: f32, z_mm: f32) -> MoveTo {
    MoveTo::to(x_mm, y_mm, z_mm).with_mode(mode)
}

/// A vector at one speed from its start to its end.
pub(crate) fn vector(x_mm: f32, y_mm: f32, speed_mm_s: f32) -> WriteVector {
    WriteVector {
        start_speed_mm_s: speed_mm_s,
        end_speed_mm_s: speed_mm_s,
        ..WriteVector::by(x_mm, y_mm, 0.0, speed_mm_s)
    }
}

pub(crate) fn button(axis: JointJogAxis, speed_percent: f32) -> JointJog {
    JointJog::new(axis, speed_percent)
}

/// Speeds and accelerations of target moves, the same number for all.
pub(crate) fn playback(speed: f32) -> Configuration {
    Configuration::playback([speed, 200.0, speed, 200.0, speed, 200.0], 0.0, 20.0)
}

/// Three targets, a zigzag of vectors, and back.
pub(crate) fn program() -> Vec<Command> {
    let mut program: Vec<Command> = vec![
        move_to(MovingMode::MovL, 220.0, 0.0, 0.0).into(),
        move_to(MovingMode::MovJ, 240.0, 40.0, 20.0).into(),
        move_to(MovingMode::Jump, 210.0, -20.0, 0.0).into(),
    ];
    for n in 0..20_u8 {
        let sign = if n % 2 == 0 { 1.0 } else { -1.0 };
        program.push(vector(1.0, 10.0 * sign, 20.0).into());
    }
    program.push(move_to(MovingMode::MovJ, 200.0, 0.0, 0.0).into());
    program
}

/// Gives all commands at once and waits until the last one is over or something goes wrong;
/// returns what happened, statuses aside.
pub(crate) async fn run(connection: &mut Connection, program: &[Command]) -> Vec<Event> {
    run_with(connection, program, |_| {}).await
}

/// The same; `look` sees each event when it happens.
pub(crate) async fn run_with(
    connection: &mut Connection,
    program: &[Command],
    mut look: impl FnMut(&Event),
) -> Vec<Event> {
    let mut last = None;
    for command in program {
        // Who tells an arm its initial angles here knows where it stands.
        connection.session_mut().confirm_pose();
        last = Some(connection.send(*command).expect("it is allowed"));
    }
    let last = last.expect("a program has a command");
    let mut events = Vec::new();
    for _ in 0..MAX_EVENTS {
        let event = connection.next_event().await.expect("the link is open");
        if matches!(event, Event::Status(_)) {
            continue;
        }
        look(&event);
        let is_last = match &event {
            Event::Completed(id) => *id == last,
            event => matches!(event, Event::NotReached { .. } | Event::LinkLost { .. }),
        };
        events.push(event);
        if is_last {
            return events;
        }
    }
    panic!("no end in sight: {events:?}");
}

/// Hours of statuses.
const MAX_EVENTS: usize = 200_000;

pub(crate) fn completed(events: &[Event]) -> Vec<u64> {
    let id = |event: &Event| match event {
        Event::Completed(CommandId(id)) => Some(*id),
        _ => None,
    };
    events.iter().filter_map(id).collect()
}

pub(crate) fn refusals(peer: &InProcess) -> Vec<Refused> {
    std::iter::from_fn(|| peer.arm().poll_refused()).collect()
}

pub(crate) fn ms(ms: u64) -> Duration {
    Duration::from_millis(ms)
}
