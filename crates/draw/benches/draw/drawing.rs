//! Benchmarks of the steps from a drawing to vectors: `cargo bench -p dobot-draw`.

use std::f64::consts::TAU;
use std::fmt::Write as _;

use divan::Bencher;
use divan::counter::ItemsCount;
use dobot_draw::{Placement, Search, Settings, Size, Travel, order, prepare, simplify};
use dobot_geometry::{Point, Stroke, Vec2, deviation};
use dobot_import::{ReadOptions, Source, Text};
use dobot_plan::{ArmLimits, ChainVector, Cornering, DrawingTool, Paper, Pass, Plan};

/// Look-ahead alone; the target is below 60 ns per vector.
#[divan::bench]
fn look_ahead_50_000_vectors(bencher: Bencher<'_, '_>) {
    let chain: Vec<ChainVector> = (0..50_000)
        .map(|i| {
            let (sin, cos) = (f64::from(i) * 0.37).sin_cos();
            ChainVector {
                direction: [cos, sin, 0.0],
                length_mm: 0.5 + cos.abs(),
                limit_mm_s: 40.0,
                corner_mm_s: f64::INFINITY,
            }
        })
        .collect();
    let cornering = Cornering {
        acceleration_mm_s2: 100.0,
        deviation_mm: 0.05,
        window_s: 0.08,
    };
    let mut joints = Vec::new();
    bencher
        .counter(ItemsCount::new(chain.len()))
        .bench_local(|| cornering.speeds(0.0, divan::black_box(&chain), &mut joints));
}

/// Rounding, look-ahead and speeds of one stroke.
#[divan::bench]
fn plan_50_000_vectors(bencher: Bencher<'_, '_>) {
    let passes = [Pass::new(DrawingTool::default(), vec![spiral(50_000)])];
    bencher
        .counter(ItemsCount::new(50_000_usize))
        .bench_local(|| Plan::new(&passes, &Paper::default(), &ArmLimits::default()));
}

/// Reading and flattening; before merging there are four times as many vectors.
#[divan::bench]
fn read_a_drawing_of_50_000_vectors(bencher: Bencher<'_, '_>) {
    let source = Source::from(waves().as_str());
    let options = ReadOptions::default();
    let (drawing, _) = source.read(&options).expect("a drawing");
    let strokes = &drawing.layers[0].strokes;
    let vectors: usize = strokes.iter().map(|s| s.points.len() - 1).sum();
    bencher
        .counter(ItemsCount::new(vectors))
        .bench_local(|| source.read(&options));
}

/// The target is below a second, so that the plan is ready in two.
#[divan::bench(args = [1, 65_535], sample_count = 5)]
fn read_a_million_segments_in_paths(bencher: Bencher<'_, '_>, paths: u32) {
    let source = Source::from(short_lines(1_000_000, paths).as_str());
    bencher
        .counter(ItemsCount::new(1_000_000_usize))
        .bench_local(|| source.read(&ReadOptions::default()));
}

#[divan::bench]
fn read_10_000_dots(bencher: Bencher<'_, '_>) {
    let source = Source::from(short_lines(0, 10_000).as_str());
    bencher
        .counter(ItemsCount::new(10_000_usize))
        .bench_local(|| source.read(&ReadOptions::default()));
}

/// The longest allowed text, in single-stroke letters.
#[divan::bench]
fn write_20_000_letters(bencher: Bencher<'_, '_>) {
    let source = Source::Text(Text::new("Hamburgefonts, 0123!\n".repeat(950)));
    bencher
        .counter(ItemsCount::new(20_000_usize))
        .bench_local(|| source.read(&ReadOptions::default()));
}

/// All steps, from the text of the file to the plan.
#[divan::bench(sample_count = 20)]
fn prepare_a_drawing_of_50_000_vectors(bencher: Bencher<'_, '_>) {
    let source = Source::from(waves().as_str());
    let mut settings = Settings::default();
    settings.placement.size = Size::Fit;
    let reach = |_| Ok::<(), String>(());
    let plan = prepare(&source, &settings, reach).expect("a drawing").plan;
    bencher
        .counter(ItemsCount::new(plan.moves.len()))
        .bench_local(|| prepare(&source, &settings, reach));
}

#[divan::bench(sample_count = 10)]
fn order_100_000_strokes(bencher: Bencher<'_, '_>) {
    let strokes = scattered(100_000);
    bencher
        .counter(ItemsCount::new(strokes.len()))
        .with_inputs(|| strokes.clone())
        .bench_local_values(|strokes| {
            let search = Search {
                travel: Travel::Length,
                kicks: 20_000,
                seed: 1,
            };
            order(strokes, Point::default(), &search)
        });
}

#[divan::bench]
fn simplify_50_000_vectors(bencher: Bencher<'_, '_>) {
    let stroke = spiral(50_000);
    bencher
        .counter(ItemsCount::new(50_000_usize))
        .bench_local(|| simplify(&stroke, 0.05));
}

#[divan::bench(sample_count = 10)]
fn deviation_of_100_000_samples(bencher: Bencher<'_, '_>) {
    let (wanted, drawn) = ([spiral(50_000)], [spiral(100_000)]);
    bencher
        .counter(ItemsCount::new(100_000_usize))
        .bench_local(|| deviation(&wanted, &drawn));
}

fn spiral(points: u32) -> Stroke {
    let center = Placement::default().area.center();
    let at = |i: u32| {
        let share = f64::from(i) / f64::from(points);
        let (sin, cos) = (TAU * 100.0 * share).sin_cos();
        center + Vec2::new(cos, sin) * (5.0 + 50.0 * share)
    };
    Stroke::open((0..=points).map(at).collect())
}

/// Wavy lines that become some 50,000 vectors at the default tolerance.
fn waves() -> String {
    let mut svg =
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="120mm" viewBox="0 0 200 120" fill="none" stroke="black">"#
            .to_owned();
    for line in 0..124 {
        write!(svg, r#"<path d="M0 {:.1}"#, 0.96 * f64::from(line)).expect("a string takes all");
        svg += &"q.5 -.7 1 0t1 0".repeat(100);
        svg += r#""/>"#;
    }
    svg + "</svg>"
}

/// Distributes segments over paths; without segments, the paths are dots.
fn short_lines(segments: u32, paths: u32) -> String {
    let mut svg =
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="120mm" viewBox="0 0 200 120" fill="none" stroke="black" stroke-linecap="round">"#
            .to_owned();
    for path in 0..paths {
        let place = |i: u32| (f64::from(path) * 0.37 + f64::from(i) * 0.61).sin_cos();
        let (sin, cos) = place(0);
        write!(
            svg,
            r#"<path d="M{:.3} {:.3}h0"#,
            100.0 + 90.0 * cos,
            60.0 + 50.0 * sin
        )
        .expect("a string takes all");
        for i in 1..=segments / paths {
            let (sin, cos) = place(i);
            write!(svg, "L{:.3} {:.3}", 100.0 + 90.0 * cos, 60.0 + 50.0 * sin)
                .expect("a string takes all");
        }
        svg += r#""/>"#;
    }
    svg + "</svg>"
}

/// Short strokes at fixed pseudo-random places.
fn scattered(count: u32) -> Vec<Stroke> {
    let mut state = 1_u64;
    let mut random = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        f64::from((state >> 40) as u32) / f64::from(1 << 24)
    };
    let mut stroke = |_| {
        let start = Point::new(150.0 + 120.0 * random(), 200.0 * random() - 100.0);
        Stroke::open(vec![start, start + Vec2::new(random(), random())])
    };
    (0..count).map(&mut stroke).collect()
}
