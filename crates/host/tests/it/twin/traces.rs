//! Traces: the executed drawing in figures and over time.

use dobot_arm::{Position, Tool};
use dobot_controller::Personality;
use dobot_draw::{Estimate, Timeline, Trace, ink_seen};
use dobot_geometry::Stroke;
use dobot_plan::{Pass, Plan};

use super::bench::{Bench, PAPER, laser, line, pen, plan, square};

/// Executes a plan.
async fn drawn(plan: &Plan, personality: Personality) -> Bench {
    let mut bench = Bench::new(personality).await;
    bench.draw(plan).await;
    bench
}

fn two_passes() -> [Pass; 2] {
    [
        pen("frame", vec![square(200.0, 0.0, 20.0)]),
        pen("dots", vec![line(&[(205.0, 5.0)]), line(&[(215.0, 15.0)])]),
    ]
}

fn wanted(passes: &[Pass]) -> Vec<Stroke> {
    passes
        .iter()
        .flat_map(|pass| pass.strokes.clone())
        .collect()
}

#[tokio::test]
async fn the_figures_are_those_of_the_run() {
    for personality in Personality::ALL {
        let passes = two_passes();
        let plan = plan(&passes, personality);
        let mut bench = Bench::new(personality).await;
        bench.draw(&plan).await;
        let trace = Trace::new(&plan, &PAPER, &bench.samples(), &wanted(&passes)).unwrap();
        let Estimate {
            time_s,
            ink_mm,
            travel_mm,
            strokes,
            vectors,
            error_mm,
            passes,
        } = trace.estimate();
        assert_eq!((strokes, vectors), (3, plan.moves.len()));
        assert!((ink_mm - 80.0).abs() < 0.5, "{ink_mm}");
        // From the square's corner to the first dot and on to the second.
        let way = 50.0_f64.sqrt() + 200.0_f64.sqrt();
        assert!((travel_mm - way).abs() < 0.5, "{travel_mm}");
        assert!(error_mm < 0.1, "{personality:?}: {error_mm}");
        // The execution matches the plan, in whole ticks on a stock arm.
        let longer = time_s - plan.duration_s();
        assert!((-0.2..0.5).contains(&longer), "{personality:?}: {longer}");
        let counts: Vec<_> = passes
            .iter()
            .map(|pass| (pass.strokes, pass.tool))
            .collect();
        assert_eq!(counts, [(1, Tool::Pen), (2, Tool::Pen)]);
        let times: f64 = passes.iter().map(|pass| pass.time_s).sum();
        assert!((times - time_s).abs() < 1e-9);
    }
}

#[tokio::test]
async fn each_line_and_each_dot_is_found_in_its_pass() {
    for personality in Personality::ALL {
        let passes = two_passes();
        let plan = plan(&passes, personality);
        let bench = drawn(&plan, personality).await;
        let trace = Trace::new(&plan, &PAPER, &bench.samples(), &wanted(&passes)).unwrap();
        let ink = trace.ink();
        let of: Vec<u32> = ink.iter().map(|line| line.pass).collect();
        assert_eq!(of, [0, 1, 1]);
        assert!(ink[1].stroke.length_mm() < 0.01 && ink[2].stroke.length_mm() < 0.01);
        for line in &ink {
            assert_eq!(line.errors_mm.len(), line.stroke.points.len());
            assert!(line.errors_mm.iter().all(|&mm| mm < 0.1));
        }
    }
}

/// Returns the tool position at a time, as documented for pages.
fn seek(timeline: &Timeline, t: f64) -> [f64; 3] {
    let path = &timeline.path;
    let i = path
        .t_s
        .partition_point(|&time_s| time_s <= t)
        .saturating_sub(1);
    let next = (i + 1).min(path.t_s.len() - 1);
    let span = path.t_s[next] - path.t_s[i];
    let share = if span > 0.0 {
        (t - path.t_s[i]) / span
    } else {
        0.0
    };
    [&path.x_mm, &path.y_mm, &path.z_mm].map(|mm| mm[i] + (mm[next] - mm[i]) * share)
}

#[tokio::test]
async fn the_timeline_gives_the_place_of_the_tool_at_any_time() {
    for passes in [
        &two_passes()[..],
        &[laser(vec![square(200.0, 0.0, 20.0)], 1)],
    ] {
        for personality in Personality::ALL {
            let plan = plan(passes, personality);
            let bench = drawn(&plan, personality).await;
            let samples = bench.samples();
            let trace = Trace::new(&plan, &PAPER, &samples, &wanted(passes)).unwrap();
            let timeline = trace.timeline();
            // The end of the drawing is where the last vector led.
            let end = plan.positions().last().unwrap();
            let found = seek(&timeline, timeline.duration_s);
            for (found, wanted) in found.into_iter().zip(end) {
                assert!((found - wanted).abs() < 0.1, "{found} instead of {wanted}");
            }
            let after = samples.iter().filter(|sample| sample.at >= trace.began());
            for sample in after {
                let time = sample.at.saturating_sub(trace.began()).as_secs_f64();
                if time > timeline.duration_s {
                    break;
                }
                let [x, y, z] = seek(&timeline, time);
                let away = Position::new(x, y, z).distance(sample.position).0;
                assert!(away < 0.07, "{personality:?}: {away} mm at {time} s");
            }
        }
    }
}

#[tokio::test]
async fn the_moves_of_the_timeline_are_consecutive_stroke_by_stroke() {
    let personality = Personality::ALL[0];
    let plan = plan(&two_passes(), personality);
    let bench = drawn(&plan, personality).await;
    let trace = Trace::new(&plan, &PAPER, &bench.samples(), &[]).unwrap();
    let moves = trace.timeline().moves;
    let names: Vec<&str> = moves
        .kind
        .iter()
        .map(|&kind| moves.kinds[usize::from(kind)])
        .collect();
    let dot = ["travel", "lower", "lift"];
    assert_eq!(names[..3], ["lower", "draw", "lift"]);
    assert_eq!(names[3..], [dot, dot].concat());
    assert_eq!(moves.stroke, [0, 0, 0, 1, 1, 1, 2, 2, 2]);
    assert_eq!(moves.pass, [0, 0, 0, 1, 1, 1, 1, 1, 1]);
    assert!(moves.from_s.is_sorted() && moves.from_s[0] == 0.0);
}

#[tokio::test]
async fn ten_minutes_of_drawing_are_less_than_two_megabytes() {
    // A spiral of curves: hardly anything of it is straight.
    let wave = |i: i32| {
        let angle = f64::from(i) * 0.02;
        let radius = 5.0 + angle * 0.35;
        (210.0 + radius * angle.cos(), radius * angle.sin())
    };
    let spiral: Vec<(f64, f64)> = (0..9000).map(wave).collect();
    let passes = [pen("spiral", vec![line(&spiral)])];
    let personality = Personality::ALL[0];
    let plan = plan(&passes, personality);
    let bench = drawn(&plan, personality).await;
    let trace = Trace::new(&plan, &PAPER, &bench.samples(), &wanted(&passes)).unwrap();
    let timeline = trace.timeline();
    let bytes = serde_json::to_string(&timeline).unwrap().len();
    assert!(timeline.duration_s > 600.0, "{} s", timeline.duration_s);
    assert!(
        bytes < 2_000_000,
        "{bytes} bytes for {} s",
        timeline.duration_s
    );
}

#[tokio::test]
async fn an_arm_that_never_reached_the_start_has_drawn_nothing() {
    let plan = plan(&two_passes(), Personality::ALL[0]);
    let error = Trace::new(&plan, &PAPER, &[], &[]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the arm never reached the start of the plan at x 200.0, y 0.0, z -30.0 mm; \
         the closest sample is inf mm away"
    );
}

#[tokio::test]
async fn the_statuses_show_the_ink_and_not_the_place_of_the_arm_before() {
    for personality in Personality::ALL {
        let passes = two_passes();
        let plan = plan(&passes, personality);
        let mut bench = Bench::new(personality).await;
        bench.draw(&plan).await;
        let seen = bench.seen.iter().copied();
        let dots = ink_seen(seen, &plan, &PAPER);
        let worst = dobot_geometry::deviation(&wanted(&passes), &dots).astray;
        assert!(dots.len() > 10 && worst.distance_mm < 0.1, "{worst:?}");
    }
}
