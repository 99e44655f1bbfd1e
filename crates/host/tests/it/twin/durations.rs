//! Planned durations of drawings.

use dobot_controller::Personality;
use dobot_geometry::Stroke;
use dobot_motion::Model;
use dobot_plan::Pass;
use proptest::prelude::*;

use super::bench::{Bench, laser, line, pen, plan};

/// Draws passes on an arm of each kind; checks that the duration of the job and that of the plan,
/// with the way to its start, are what the arm took.
async fn check(passes: &[Pass]) {
    for personality in Personality::ALL {
        let plan = plan(passes, personality);
        let mut bench = Bench::new(personality).await;
        let model = Model::new(personality.dialect(), &bench.status().await);
        let took_s = bench.draw(&plan).await.as_secs_f64();
        let to_start = plan.commands().nth(plan.command_of(0) - 1).unwrap();
        let way_s = model.trajectory(&to_start).unwrap().duration_s().unwrap();
        let (job_s, plan_s) = (bench.planned_s().await, way_s + plan.duration_s());
        // The end is seen up to three statuses later; before the plan the arm got four commands.
        for (planned_s, fixed_s) in [(job_s, 0.24), (plan_s, 0.56)] {
            assert!(
                (took_s - planned_s).abs() < 0.01 * took_s + fixed_s,
                "{personality:?}: {took_s} s, planned {planned_s} s"
            );
        }
    }
}

#[tokio::test]
async fn a_sheet_of_dots_takes_as_long_as_planned() {
    let dot = |i: u32| line(&[(200.0 + 10.0 * f64::from(i % 7), 10.0 * f64::from(i / 7))]);
    let dots: Vec<Stroke> = (0..28).map(dot).collect();
    check(&[pen("dots", dots.clone())]).await;
    check(&[laser(dots, 1)]).await;
}

#[tokio::test]
async fn lines_drawn_there_and_back_take_as_long_as_planned() {
    let dash = |i: u32| {
        let (x, y) = (180.0 + 5.0 * f64::from(i % 8), 4.0 * f64::from(i / 8));
        line(&[(x, y), (x + 3.0, y), (x, y)])
    };
    check(&[pen("dashes", (0..40).map(dash).collect())]).await;
}

#[tokio::test]
async fn a_drawing_of_three_hours_takes_as_long_as_planned() {
    let dash = |i: u32| {
        let (x, y) = (170.0 + f64::from(i % 100), f64::from(i / 100) - 30.0);
        line(&[(x, y), (x + 0.3 + 0.005 * f64::from(i % 100), y)])
    };
    let dashes: Vec<Stroke> = (0..7500).map(dash).collect();
    let plan = plan(&[pen("dashes", dashes.clone())], Personality::Firmware11);
    assert!(plan.duration_s() > 3.0 * 3600.0, "{} s", plan.duration_s());
    check(&[pen("dashes", dashes)]).await;
}

/// Dots, dashes and long lines.
fn stroke() -> impl Strategy<Value = Stroke> {
    let place = || (170.0..270.0_f64, -60.0..60.0_f64);
    let dash = (place(), -4.0..4.0_f64, 0.1..4.0_f64);
    prop_oneof![
        place().prop_map(|place| line(&[place])),
        dash.prop_map(|((x, y), dx, dy)| line(&[(x, y), (x + dx, y + dy)])),
        proptest::collection::vec(place(), 2..5).prop_map(|points| line(&points)),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn a_drawing_of_dots_dashes_and_lines_takes_as_long_as_planned(
        strokes in proptest::collection::vec(stroke(), 1..60),
        burns: bool,
    ) {
        let pass = if burns { laser(strokes, 1) } else { pen("mixture", strokes) };
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build();
        runtime.unwrap().block_on(check(&[pass]));
    }
}
