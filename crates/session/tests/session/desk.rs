//! A session, and an arm that stays where it is put.

use std::time::Duration;

use dobot_arm::{Pose, Position, Tool, inverse};
use dobot_motion::ArmPlace;
use dobot_session::{CommandId, Event, Session};
use dobot_wire::{Dialect, MoveTo, MovingMode, Status, WriteVector};

pub(crate) const PERIOD: Duration = Dialect::SPECIFICATION.status_period();

/// A session, and an arm that stays where it is put.
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

pub(crate) fn status(x_mm: f64, y_mm: f64, z_mm: f64) -> Status {
    let pose = Pose {
        position: Position::new(x_mm, y_mm, z_mm),
        ..Pose::default()
    };
    let joints = inverse(&pose, Tool::SuctionCup).expect("within reach");
    ArmPlace::at_joints(joints, Tool::SuctionCup).status()
}

pub(crate) fn target(mode: MovingMode, x_mm: f32, y_mm: f32) -> MoveTo {
    MoveTo::to(x_mm, y_mm, 0.0).with_mode(mode)
}

pub(crate) fn vector(x_mm: f32, y_mm: f32) -> WriteVector {
    WriteVector::by(x_mm, y_mm, 0.0, 50.0)
}

pub(crate) fn completed(events: &[Event]) -> Vec<u64> {
    let id = |event: &Event| match event {
        Event::Completed(CommandId(id)) => Some(*id),
        _ => None,
    };
    events.iter().filter_map(id).collect()
}
