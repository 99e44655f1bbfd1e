//! What merging, hatching and clipping cost: `cargo bench -p dobot-draw --bench shape`.

use std::f64::consts::TAU;

use divan::Bencher;
use divan::counter::ItemsCount;
use dobot_draw::{Point, Stroke, simplify};

fn main() {
    divan::main();
}

/// The aim is below 300 ns per point, whatever the stroke looks like.
#[divan::bench(args = LONG, sample_count = 3, sample_size = 1)]
fn simplify_1_000_000_points(bencher: Bencher<'_, '_>, name: &str) {
    let stroke = Stroke::open((0..1_000_000).map(|i| long(name, i)).collect());
    bencher
        .counter(ItemsCount::new(stroke.points.len()))
        .bench_local(|| simplify(&stroke, 0.05));
}

/// Letters: as short as strokes are, and all of them curved.
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

const LONG: [&str; 6] = [
    "line",
    "spiral",
    "tight spiral",
    "coarse swirl",
    "noisy line",
    "wavering line",
];

/// A point of a long stroke.
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
    Point::new(cos, sin) * (5.0 + 50.0 * share)
}

fn swirl(t: f64) -> Point {
    Point::new(t + 3.0 * t.sin(), 4.0 * (t * 0.7).cos())
}

/// From 0 to 1, the same every time.
fn noise(i: u32) -> f64 {
    let mixed = (u64::from(i) + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let mixed = (mixed ^ (mixed >> 29)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    f64::from((mixed >> 40) as u32) / f64::from(1 << 24)
}
