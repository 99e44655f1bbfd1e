//! A session, and an arm that does nothing but stand where it is put.

use std::time::Duration;

use dobot_arm::{Joints, Pose, Position, Tool, forward, inverse};
use dobot_client::{CommandId, Event, Session};
use dobot_wire::{Dialect, MoveTo, MovingMode, Status, WriteMode, WriteVector};

pub(crate) const PERIOD: Duration = Dialect::SPECIFICATION.status_period;

/// A session, and an arm that does nothing but stand where it is put.
pub(crate) struct Desk {
    pub(crate) session: Session,
    pub(crate) now: Duration,
}

impl Desk {
    pub(crate) fn new(dialect: Option<Dialect>) -> Self {
        Self {
            session: Session::trusted(dialect),
            now: Duration::ZERO,
        }
    }

    /// One that fills the arm's queue.
    pub(crate) fn ahead(dialect: Option<Dialect>) -> Self {
        let desk = Self::new(dialect);
        Self {
            session: desk.session.with_ahead(Duration::MAX),
            ..desk
        }
    }

    /// The next status, 80 ms after the last one; returns what happened.
    pub(crate) fn status_at(&mut self, x_mm: f64, y_mm: f64, z_mm: f64) -> Vec<Event> {
        self.now += PERIOD;
        let bytes = status(x_mm, y_mm, z_mm).emit().to_bytes();
        self.session.handle_bytes(self.now, &bytes);
        self.events()
    }

    pub(crate) fn events(&mut self) -> Vec<Event> {
        std::iter::from_fn(|| self.session.poll_event())
            .filter(|event| !matches!(event, Event::Status(_)))
            .collect()
    }

    pub(crate) fn packets(&mut self) -> usize {
        std::iter::from_fn(|| self.session.poll_bytes()).count()
    }
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "the wire is single precision"
)]
pub(crate) fn status(x_mm: f64, y_mm: f64, z_mm: f64) -> Status {
    let pose = Pose {
        position: Position::new(x_mm, y_mm, z_mm),
        ..Pose::default()
    };
    let joints = inverse(&pose, Tool::SuctionCup).expect("within reach");
    let pose = forward(&joints, Tool::SuctionCup);
    let Joints {
        base,
        rear,
        fore,
        servo,
    } = joints;
    Status {
        x_mm: pose.position.x.0 as f32,
        y_mm: pose.position.y.0 as f32,
        z_mm: pose.position.z.0 as f32,
        rotation_deg: pose.rotation.0 as f32,
        base_deg: base.0 as f32,
        rear_deg: rear.0 as f32,
        fore_deg: fore.0 as f32,
        servo_deg: servo.0 as f32,
        suction: false,
        gripper_deg: 0.0,
    }
}

pub(crate) fn target(mode: MovingMode, x_mm: f32, y_mm: f32) -> MoveTo {
    MoveTo {
        x_mm,
        y_mm,
        z_mm: 0.0,
        rotation_deg: 0.0,
        suction: false,
        mode,
        gripper_deg: 0.0,
        pause_s: 0.0,
    }
}

pub(crate) fn vector(x_mm: f32, y_mm: f32) -> WriteVector {
    WriteVector {
        mode: WriteMode::Writing,
        x_mm,
        y_mm,
        z_mm: 0.0,
        laser: false,
        start_speed_mm_s: 0.0,
        end_speed_mm_s: 0.0,
        max_speed_mm_s: 50.0,
        stop: false,
    }
}

pub(crate) fn completed(events: &[Event]) -> Vec<u64> {
    let id = |event: &Event| match event {
        Event::Completed(CommandId(id)) => Some(*id),
        _ => None,
    };
    events.iter().filter_map(id).collect()
}
