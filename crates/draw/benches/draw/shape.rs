//! Benchmarks of merging, hatching and clipping: `cargo bench -p dobot-draw -- shape`.

use std::f64::consts::TAU;

use divan::Bencher;
use divan::counter::ItemsCount;
use dobot_draw::{Hatch, hatch, merge, simplify};
use dobot_geometry::{Area, FillRule, Point, Stroke, Vec2};

/// The target is below 300 ns per point for any stroke.
#[divan::bench(args = LONG, sample_count = 3, sample_size = 1)]
fn simplify_1_000_000_points(bencher: Bencher<'_, '_>, name: &str) {
    let stroke = Stroke::open((0..1_000_000).map(|i| long(name, i)).collect());
    bencher
        .counter(ItemsCount::new(stroke.points.len()))
        .bench_local(|| simplify(&stroke, 0.05));
}

/// Letters: short strokes, all of them curved.
#[divan::bench(sample_count = 10)]
fn simplify_10_000_strokes_of_60_points(bencher: Bencher<'_, '_>) {
    let letter = Stroke::open((0..60).map(|i| swirl(f64::from(i) / 12.0)).collect());
    bencher
        .counter(ItemsCount::new(600_000_usize))
        .bench_local(|| {
            for _ in 0..10_000 {
                divan::black_box(simplify(divan::black_box(&letter), 0.05));
            }
        });
}

/// The segments of a Hilbert curve in any order and direction, which become one stroke again.
#[divan::bench(sample_count = 10)]
fn merge_65_535_segments(bencher: Bencher<'_, '_>) {
    let count = 65_535_u32;
    let segment = |i: u32| {
        let ends = [hilbert(i), hilbert(i + 1)];
        let [a, b] = if i.is_multiple_of(3) {
            [ends[1], ends[0]]
        } else {
            ends
        };
        Stroke::open(vec![a, b])
    };
    // 7919 is coprime to their number, so each comes once.
    let shuffled = (0..count).map(|i| segment(i * 7919 % count));
    let segments: Vec<Stroke> = shuffled.collect();
    assert_eq!(merge(segments.clone(), 0.05).len(), 1);
    bencher
        .counter(ItemsCount::new(count))
        .with_inputs(|| segments.clone())
        .bench_local_values(|segments| merge(segments, 0.05));
}

/// A star of 20,000 corners with more than half a million crossings.
#[divan::bench(sample_count = 10)]
fn hatch_a_star_of_20_000_corners(bencher: Bencher<'_, '_>) {
    let corner = |i: u32| {
        let (sin, cos) = (TAU * f64::from(i) / 20_000.0).sin_cos();
        (Vec2::new(cos, sin) * if i.is_multiple_of(2) { 60.0 } else { 50.0 }).to_point()
    };
    let star = Area {
        rings: vec![(0..20_000).map(corner).collect()],
        rule: FillRule::NonZero,
    };
    let settings = Hatch {
        spacing_mm: 0.2,
        ..Hatch::default()
    };
    bencher.bench_local(|| hatch(&star, &settings));
}

const LONG: [&str; 6] = [
    "line",
    "spiral",
    "tight spiral",
    "coarse swirl",
    "noisy line",
    "wavering line",
];

/// Returns a point of a long stroke.
fn long(name: &str, i: u32) -> Point {
    let t = f64::from(i);
    match name {
        "spiral" => spiral(t / 1e6, 100.0),
        "tight spiral" => spiral(t / 1e6, 3000.0),
        "coarse swirl" => swirl(t / 8.0),
        "noisy line" => Point::new(t * 1e-4, noise(i) * 0.09),
        "wavering line" => Point::new(t * 1e-3 + noise(i) * 0.08, noise(i + 7) * 0.08),
        _ => Point::new(t * 1e-4, 0.0),
    }
}

fn spiral(share: f64, turns: f64) -> Point {
    let (sin, cos) = (TAU * turns * share).sin_cos();
    (Vec2::new(cos, sin) * (5.0 + 50.0 * share)).to_point()
}

fn swirl(t: f64) -> Point {
    Point::new(t + 3.0 * t.sin(), 4.0 * (t * 0.7).cos())
}

/// Returns a point of the curve through 65,536 places, half a millimetre apart.
fn hilbert(i: u32) -> Point {
    let (mut x, mut y) = (0, 0);
    for level in 0..8 {
        let side = 1 << level;
        let (right, up) = (
            (i >> (2 * level + 1)) & 1,
            ((i >> (2 * level)) ^ (i >> (2 * level + 1))) & 1,
        );
        if up == 0 {
            if right == 1 {
                (x, y) = (side - 1 - x, side - 1 - y);
            }
            (x, y) = (y, x);
        }
        (x, y) = (x + side * right, y + side * up);
    }
    Point::new(0.5 * f64::from(x), 0.5 * f64::from(y))
}

/// Returns a fixed pseudo-random number from 0 to 1.
fn noise(i: u32) -> f64 {
    let mixed = (u64::from(i) + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let mixed = (mixed ^ (mixed >> 29)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    f64::from((mixed >> 40) as u32) / f64::from(1 << 24)
}
