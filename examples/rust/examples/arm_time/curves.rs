//! Curves of many kinds, the same ones every time.

use std::f64::consts::TAU;

use dobot_draw::Placement;
use dobot_geometry::{Point, Random, Stroke, Vec2};
use dobot_lettering::{Anchor, strokes};

/// Strokes to draw, and the curves that they approximate.
pub(crate) struct Curves {
    /// Their name.
    pub(crate) name: &'static str,
    /// The strokes, in the base frame, in mm.
    pub(crate) given: Vec<Stroke>,
    /// The curves without noise.
    pub(crate) meant: Vec<Stroke>,
}

/// Returns all curves.
pub(crate) fn all() -> Vec<Curves> {
    let noiseless = |name, given: Vec<Stroke>| Curves {
        name,
        meant: given.clone(),
        given,
    };
    vec![
        noiseless("spirograph", vec![spirograph(101.0, 34.0, 49.3)]),
        noiseless("rosette", vec![spirograph(120.0, 53.0, 44.0)]),
        noiseless("circles", circles()),
        noiseless("waves", waves()),
        by_hand(),
        noiseless("text", text()),
    ]
}

/// A spirograph, 120 mm wide: 20,000 points.
fn spirograph(ring: f64, wheel: f64, arm: f64) -> Stroke {
    let scale = 60.0 / (ring - wheel + arm);
    let at = |i: u32| {
        let share = TAU * f64::from(i % 20_000) / 20_000.0;
        let rolled = Vec2::from_angle(wheel * share) * (ring - wheel);
        center() + (rolled + Vec2::from_angle(-(ring - wheel) * share) * arm) * scale
    };
    closed((0..=20_000).map(at))
}

/// Circles from 1 to 50 mm, with points at a distance of 0.01 mm from their chords.
fn circles() -> Vec<Stroke> {
    let radii_mm = [1.0, 2.0, 3.0, 5.0, 8.0, 12.0, 20.0, 30.0, 50.0];
    radii_mm.into_iter().map(circle).collect()
}

fn circle(radius_mm: f64) -> Stroke {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "some hundreds"
    )]
    let count = (TAU * (radius_mm / 0.08).sqrt()).ceil() as u32;
    let at = |i| TAU * f64::from(i % count) / f64::from(count);
    closed((0..=count).map(|i| center() + Vec2::from_angle(at(i)) * radius_mm))
}

/// Rows of waves of decreasing length: from almost straight to almost back and forth.
fn waves() -> Vec<Stroke> {
    let row = |row: u32| {
        let at = move |i: u32| {
            let share = f64::from(i) / 4000.0;
            let height_mm = 3.0 * (TAU * (5.0 * share + 25.0 * share * share)).sin();
            center() + Vec2::new(8.0 * f64::from(row) + height_mm, 160.0 * share - 80.0)
        };
        Stroke::open((0..=4000).map(at).collect())
    };
    (0..4).map(row).collect()
}

/// Smooth hand-drawn lines, as from a tablet: a point every 0.3 mm, with errors of up to 0.02 mm.
fn by_hand() -> Curves {
    let mut random = Random::new(5);
    let mut curves = Curves {
        name: "by hand",
        given: Vec::new(),
        meant: Vec::new(),
    };
    for _ in 0..10 {
        let line = wander(&mut random);
        let mut off = || 0.02 * (2.0 * random.share() - 1.0);
        let noisy = line.step_by(30).map(|p| p + Vec2::new(off(), off()));
        curves.given.push(Stroke::open(noisy.collect()));
    }
    let mut random = Random::new(5);
    for _ in 0..10 {
        let line: Vec<Point> = wander(&mut random).collect();
        (0..2 * line.len().div_ceil(30)).for_each(|_| _ = random.number());
        curves.meant.push(Stroke::open(line));
    }
    curves
}

/// A line of 200 mm with a random direction, in steps of 0.01 mm.
fn wander(random: &mut Random) -> impl Iterator<Item = Point> + use<> {
    let swings = [0.5, 1.3, 3.1, 7.0].map(|count| {
        let size = (0.5 + random.share()) * 2.0 / count;
        (
            TAU * count * (0.7 + 0.6 * random.share()),
            TAU * random.share(),
            size,
        )
    });
    let begin = center() + Vec2::new(60.0, 80.0) * (2.0 * random.share() - 1.0);
    let direction = move |i: u32| {
        let share = f64::from(i) / 20_000.0;
        let swing =
            |(often, begin, size): (f64, f64, f64)| size * (4.0 * often * share + begin).sin();
        Vec2::from_angle(swings.into_iter().map(swing).sum())
    };
    (0..20_000).scan(begin, move |here, i| {
        *here += direction(i) * 0.01;
        Some(*here)
    })
}

/// Single-line letters, 3 and 8 mm high.
fn text() -> Vec<Stroke> {
    let lines = [
        ("Where one stroke ends, quick joints lift its pen", 3.0),
        ("Sphinx, 1089 & Co", 8.0),
    ];
    let at = |p: Point| center() + Vec2::new(-p.y, -p.x);
    let placed = |points: Vec<Point>| Stroke::open(points.into_iter().map(at).collect());
    lines
        .into_iter()
        .flat_map(|(line, height_mm)| {
            let begin = Point::new(0.0, 10.0 * height_mm);
            strokes(line, Anchor::Middle, begin, height_mm)
        })
        .map(|line| placed(line.iter().map(|p| Point::new(p.x, p.y)).collect()))
        .collect()
}

fn center() -> Point {
    Placement::default().area.center()
}

fn closed(points: impl Iterator<Item = Point>) -> Stroke {
    Stroke {
        points: points.collect(),
        closed: true,
    }
}
