//! A sample state, job and notice for tests.

use dobot_api::{ArmView, JobKind, JobPhase, JobView, LinkView, News, Notice, QueueView, State};
use dobot_wire::{Dialect, Status};

/// A running drawing.
pub(crate) fn job(number: u64) -> JobView {
    JobView {
        job: number,
        title: "a house".into(),
        kind: JobKind::Drawing,
        created_ms: 1_700_000_000_000,
        phase: JobPhase::Running,
        reason: None,
        waits_for_person: false,
        commands: 1200,
        completed: 480,
        planned_s: Some(300.0),
        left_s: Some(180.0),
        took_s: None,
        speed_percent: 100.0,
        height_mm: 0.0,
        program: None,
        question: None,
    }
}

/// An arm that draws it.
pub(crate) fn state(at_s: f64) -> State {
    let sample = State::sample();
    State {
        at_s,
        link: LinkView {
            address: Some("virtual:".into()),
            latency_ms: Some(84.0),
            ..sample.link
        },
        arm: sample.arm.map(|arm| ArmView {
            status: Status {
                x_mm: 200.0,
                y_mm: -31.5,
                z_mm: 52.0,
                rotation_deg: 0.0,
                base_deg: -9.0,
                rear_deg: 31.0,
                fore_deg: 42.5,
                servo_deg: 9.0,
                suction: false,
                gripper_deg: 12.0,
            },
            moving: true,
            ..arm
        }),
        dialect: Some(Dialect::FIRMWARE_1_1),
        queue: QueueView {
            waiting: 2,
            under_way: 1,
            ahead_s: 0.4,
        },
        job: Some(job(7)),
        ..sample
    }
}

/// A notice.
pub(crate) fn notice(number: u64, news: News, text: &str) -> Notice {
    Notice {
        number,
        at_s: 1.0,
        news,
        text: text.into(),
    }
}
