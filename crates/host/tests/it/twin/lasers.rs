//! Burning.

use dobot_api::JobPhase;
use dobot_controller::Personality;
use dobot_draw::Trace;
use dobot_geometry::deviation;

use super::bench::{Bench, PAPER, laser, line, plan, square};

#[tokio::test]
async fn a_laser_burns_the_strokes_and_nothing_else() {
    let strokes = vec![
        line(&[(200.0, 0.0), (220.0, 0.0)]),
        square(200.0, 20.0, 10.0),
    ];
    let plan = plan(&[laser(strokes.clone(), 2)], Personality::Specification);
    let mut bench = Bench::new(Personality::Specification).await;
    bench.draw(&plan).await;
    let samples = bench.samples();
    let trace = Trace::new(&plan, &PAPER, &samples, &strokes).unwrap();
    let ink: Vec<_> = trace.ink().into_iter().map(|ink| ink.stroke).collect();
    // Each stroke twice.
    assert_eq!(ink.len(), 4);
    let worst = deviation(&strokes, &ink);
    assert!(worst.largest_mm() < 0.1, "{worst:?}");
    assert!(!samples.last().unwrap().laser);
}

#[tokio::test]
async fn a_laser_that_is_stopped_is_off() {
    for personality in Personality::ALL {
        let strokes = vec![square(200.0, 0.0, 20.0); 100];
        let plan = plan(&[laser(strokes, 1)], personality);
        let mut bench = Bench::new(personality).await;
        let job = bench.draw_until(&plan, plan.command_of(4)).await;
        assert_eq!(job.phase, JobPhase::Paused);
        let samples = bench.samples();
        assert!(samples.iter().any(|sample| sample.laser));
        assert!(!samples.last().unwrap().laser);
    }
}
