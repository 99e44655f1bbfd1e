//! Changing pens, and being stopped.

use dobot_api::JobPhase;
use dobot_controller::Personality;
use dobot_draw::Trace;
use dobot_plan::Pass;

use super::bench::{Bench, PAPER, line, pen, plan, square};

#[tokio::test]
async fn a_person_is_asked_for_each_pen_and_the_pen_is_up_meanwhile() {
    for personality in Personality::ALL {
        let blue = Pass {
            message: Some("put the blue pen in".to_owned()),
            ..pen("blue", vec![line(&[(200.0, 30.0), (210.0, 30.0)])])
        };
        let red = pen("red", vec![square(200.0, 0.0, 10.0)]);
        let plan = plan(&[red, blue], personality);
        let mut bench = Bench::new(personality).await;
        bench.draw(&plan).await;
        assert_eq!(bench.asked.len(), 1);
        assert!(
            bench.asked[0].ends_with("put the blue pen in"),
            "{:?}",
            bench.asked
        );
        let samples = bench.samples();
        let trace = Trace::new(&plan, &PAPER, &samples, &[]).unwrap();
        assert_eq!(
            (trace.vectors(), trace.estimate().strokes),
            (plan.moves.len(), 2)
        );
    }
}

#[tokio::test]
async fn a_slow_pen_change_does_not_make_the_drawing_longer() {
    let passes = |message: Option<&str>| {
        let second = Pass {
            message: message.map(str::to_owned),
            ..pen("b", vec![line(&[(200.0, 30.0), (210.0, 30.0)])])
        };
        [pen("a", vec![square(200.0, 0.0, 10.0)]), second]
    };
    let personality = Personality::ALL[0];
    let mut times = Vec::new();
    for message in [None, Some("wait")] {
        let mut bench = Bench::new(personality).await;
        let plan = plan(&passes(message), personality);
        times.push(bench.draw(&plan).await);
    }
    // The arm comes to rest at a break, which is reported after the third equal status.
    let longer = times[1].as_secs_f64() - times[0].as_secs_f64();
    assert!((-0.1..0.7).contains(&longer), "{times:?}");
}

#[tokio::test]
async fn a_drawing_of_ten_thousand_vectors_is_followed_to_its_end() {
    // A stock arm's rounding accumulates: adding up the vectors themselves gives another position.
    for personality in Personality::ALL {
        let dash = |i: i32| {
            let (x, y) = (180.0 + f64::from(i % 50), f64::from(i / 50 % 50));
            line(&[(x, y), (x + 0.5, y)])
        };
        let plan = plan(&[pen("dashes", (0..2500).map(dash).collect())], personality);
        assert!(plan.moves.len() >= 9_999, "{}", plan.moves.len());
        let mut bench = Bench::new(personality).await;
        bench.draw(&plan).await;
        let samples = bench.samples();
        let trace = Trace::new(&plan, &PAPER, &samples, &[]).unwrap();
        assert_eq!(trace.estimate().strokes, 2500);
    }
}

#[tokio::test]
async fn a_drawing_that_is_stopped_leaves_the_pen_up() {
    for personality in Personality::ALL {
        let plan = plan(
            &[pen("a", vec![square(200.0, 0.0, 10.0); 100])],
            personality,
        );
        let mut bench = Bench::new(personality).await;
        let job = bench.draw_until(&plan, plan.command_of(2)).await;
        assert_eq!(job.phase, JobPhase::Paused);
        let samples = bench.samples();
        let last = samples.last().unwrap().position.z.0;
        assert!((last + 30.0).abs() < 0.05, "{last}");
        let trace = Trace::new(&plan, &PAPER, &samples, &[]).unwrap();
        assert!((2..plan.moves.len()).contains(&trace.vectors()));
    }
}
