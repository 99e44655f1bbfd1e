//! What is recorded of the way of the tool.

use std::time::Duration;

use crate::common::{
    button, completed, in_process, move_to, ms, refusals, run, vector, virtual_arm,
};
use dobot_arm::Position;
use dobot_session::Connection;
use dobot_sim::{InProcess, Sample};
use dobot_wire::{Command, Dialect, JointJogAxis, MovingMode, WriteMode, WriteVector};

async fn record(peer: &InProcess, program: &[Command]) -> Vec<Sample> {
    peer.arm().record(PERIOD);
    let mut connection = Connection::over_peer(peer.clone(), Some(Dialect::SPECIFICATION));
    let events = run(&mut connection, program).await;
    assert_eq!(completed(&events).len(), program.len(), "{events:?}");
    assert_eq!(refusals(peer), []);
    peer.arm().samples().to_vec()
}

/// A polyline whose vectors last anything but a number of ticks, and its corners.
fn polyline() -> (Vec<Command>, Vec<Position>) {
    let mut at = Position::new(220.0, 0.0, 0.0);
    let mut program: Vec<Command> = vec![move_to(MovingMode::MovL, 220.0, 0.0, 0.0).into()];
    let mut corners = vec![at];
    for n in 0..300_u16 {
        let angle = f32::from(n) * 2.4;
        let length_mm = 2.0 + f32::from(n % 7) * 0.731;
        let (y, x) = angle.sin_cos();
        let by = WriteVector {
            z_mm: 0.1 * y,
            start_speed_mm_s: 3.0,
            end_speed_mm_s: 3.0,
            ..vector(length_mm * x, length_mm * y, 17.3)
        };
        at = at + Position::new(by.x_mm.into(), by.y_mm.into(), by.z_mm.into());
        corners.push(at);
        program.push(by.into());
    }
    (program, corners)
}

#[tokio::test]
async fn every_corner_of_a_polyline_is_recorded_in_order() {
    let (program, corners) = polyline();
    let samples = record(&in_process(), &program).await;
    let mut rest = samples.iter();
    for (n, corner) in corners.iter().enumerate() {
        let near = |sample: &&Sample| sample.position.distance(*corner).0 <= 1e-6;
        assert!(
            rest.any(|it| near(&it)),
            "corner {n}, {corner:?}, is missing"
        );
    }
}

#[tokio::test]
async fn a_moving_arm_is_recorded_at_least_once_in_a_period() {
    let (program, _) = polyline();
    let samples = record(&in_process(), &program).await;
    let moved = |it: &[Sample]| it[0].position != it[1].position;
    for pair in samples.windows(2).filter(|it| moved(it)) {
        let gap = pair[1].at.saturating_sub(pair[0].at);
        assert!(gap <= PERIOD, "{gap:?} between {pair:?}");
    }
}

#[test]
fn what_is_recorded_does_not_depend_on_when_somebody_looks() {
    let by: Command = vector(10.0, 7.0, 20.0).into();
    let bytes = by.emit(&Dialect::SPECIFICATION).to_bytes();
    let recorded = |step: Duration| {
        let mut arm = virtual_arm();
        arm.record(PERIOD);
        arm.handle_bytes(Duration::ZERO, &bytes);
        while arm.now() < ms(2000) {
            let next = arm.now() + step;
            arm.handle_time(next.min(ms(2000)));
        }
        arm.samples().to_vec()
    };
    let expected = recorded(ms(2000));
    assert!(expected.len() > 100, "{} samples", expected.len());
    for step in [1, 3, 7, 33].map(ms) {
        assert_eq!(recorded(step), expected, "looked at every {step:?}");
    }
}

#[tokio::test]
async fn an_arm_that_stands_is_recorded_when_it_stops_and_when_it_goes_on() {
    let peer = in_process();
    let there = move_to(MovingMode::MovL, 230.0, 0.0, 0.0);
    record(&peer, &[there.into()]).await;
    let stopped = *peer.arm().samples().last().expect("it moved");
    let mut connection = Connection::over_peer(peer.clone(), Some(Dialect::SPECIFICATION));
    for _ in 0..25 {
        connection.next_status().await.expect("it is open");
    }
    assert_eq!(peer.arm().samples().last(), Some(&stopped));
    run(&mut connection, &[vector(0.0, 9.0, 20.0).into()]).await;
    let samples = peer.arm().samples().to_vec();
    let at = samples
        .iter()
        .position(|it| *it == stopped)
        .expect("it is kept");
    let (goes_on, first) = (samples[at + 1], samples[at + 2]);
    assert_eq!(goes_on.position, stopped.position);
    assert!(goes_on.at > stopped.at + Duration::from_secs(2));
    assert!(first.at <= goes_on.at + PERIOD);
    assert!(first.position != stopped.position);
}

#[tokio::test]
async fn each_sample_says_whether_the_laser_was_on_on_the_way_to_it() {
    let burn = |y_mm: f32, laser| WriteVector {
        mode: WriteMode::Laser,
        laser,
        ..vector(0.0, y_mm, 20.0)
    };
    let program: Vec<Command> = vec![
        button(JointJogAxis::LaserOff, 0.0).into(),
        move_to(MovingMode::MovL, 220.0, 0.0, 0.0).into(),
        burn(4.0, false).into(),
        burn(4.0, true).into(),
        burn(4.0, false).into(),
    ];
    let samples = record(&in_process(), &program).await;
    let drawn = samples
        .iter()
        .skip_while(|it| it.position != Position::new(220.0, 0.0, 0.0));
    for sample in drawn {
        let y_mm = sample.position.y.0;
        let inside = y_mm > 4.0 + 1e-6 && y_mm <= 8.0 + 1e-6;
        assert_eq!(sample.laser, inside, "{sample:?}");
    }
}

/// Shorter than a control tick.
const PERIOD: Duration = Duration::from_millis(5);
