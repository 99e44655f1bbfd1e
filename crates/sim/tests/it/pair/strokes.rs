//! What the pen draws, and how fast.

use super::*;

/// The speed in mm/s between each two samples, and when.
fn speeds(samples: &[Sample]) -> Vec<(Duration, f64)> {
    samples
        .windows(2)
        .map(|it| {
            let way_mm = it[0].position.distance(it[1].position).0;
            let time = it[1].at.saturating_sub(it[0].at);
            (it[1].at, way_mm / time.as_secs_f64())
        })
        .collect()
}

#[tokio::test]
async fn the_pen_never_stops_between_vectors_that_last_as_long_as_a_status_period() {
    let peer = in_process();
    peer.arm().record(ms(5));
    let mut arm = connect(&peer);
    let start = move_to(MovingMode::MovL, 220.0, -75.0, 0.0);
    run(&mut arm, &[start.into()]).await;
    let begun = peer.now();
    // 30 mm/s for 84 ms are 2.52 mm. The first and the last one speed up and slow down.
    let mut program: Vec<Command> = vec![
        WriteVector {
            start_speed_mm_s: 0.0,
            ..vector(0.0, 10.0, 30.0)
        }
        .into(),
    ];
    program.extend((0..50).map(|_| Command::from(vector(0.0, 2.52, 30.0))));
    program.push(
        WriteVector {
            end_speed_mm_s: 0.0,
            ..vector(0.0, 10.0, 30.0)
        }
        .into(),
    );
    let events = run(&mut arm, &program).await;
    assert_eq!(completed(&events).len(), 52);
    assert_eq!(refusals(&peer), []);
    let arm = peer.arm();
    let between = |sample: &&Sample| {
        sample.at > begun && (-65.0..=-65.0 + 126.0).contains(&sample.position.y.0)
    };
    let drawn: Vec<Sample> = arm.samples().iter().filter(between).copied().collect();
    assert!(drawn.len() > 800, "{} samples", drawn.len());
    for (at, speed_mm_s) in speeds(&drawn) {
        assert!((speed_mm_s - 30.0).abs() < 0.01, "{speed_mm_s} at {at:?}");
    }
}

async fn recorded(program: &[Command]) -> Vec<Sample> {
    let peer = in_process();
    peer.arm().record(ms(5));
    run(&mut connect(&peer), program).await;
    peer.arm().samples().to_vec()
}

#[tokio::test]
async fn the_same_program_twice_draws_the_same_samples_bit_by_bit() {
    let program: Vec<Command> = vec![
        move_to(MovingMode::MovJ, 230.0, 12.3, 4.5).into(),
        vector(1.1, 20.7, 33.3).into(),
        vector(-13.7, 2.9, 17.1).into(),
        move_to(MovingMode::Jump, 201.0, 30.0, 0.0).into(),
    ];
    let [first, second] = [recorded(&program).await, recorded(&program).await];
    assert!(first.len() > 100, "{} samples", first.len());
    let bits = |samples: &[Sample]| -> Vec<_> {
        let bits = |it: &Sample| {
            let Position { x, y, z } = it.position;
            (it.at, [x, y, z].map(|it| it.0.to_bits()), it.laser)
        };
        samples.iter().map(bits).collect()
    };
    assert_eq!(bits(&first), bits(&second));
}
