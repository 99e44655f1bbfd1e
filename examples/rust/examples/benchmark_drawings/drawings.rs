//! The benchmark drawings, on a page of 200 x 120 mm.

use std::f64::consts::TAU;
use std::fmt::Write as _;

use dobot_geometry::{Point, Random};
use dobot_lettering::{Anchor, strokes, width};

/// All drawings.
pub(crate) const ALL: [Benchmark; 12] = [
    Benchmark::new("hilbert", hilbert),
    Benchmark::new("hilbert-shuffled", || shuffled(hilbert_segments())),
    Benchmark::new("spirograph", spirograph),
    Benchmark::new("spirograph-shuffled", || shuffled(spirograph_pieces())),
    Benchmark::new("text", text),
    Benchmark::new("text-shuffled", || shuffled(text())),
    Benchmark::new("stipple", stipple),
    Benchmark::new("stipple-shuffled", || shuffled(stipple())),
    Benchmark::new("hatch", hatch),
    Benchmark::new("hatch-shuffled", || shuffled(hatch())),
    Benchmark::new("engraving", engraving),
    Benchmark::new("circuit", circuit),
];

/// A benchmark drawing.
pub(crate) struct Benchmark {
    /// The name of its file.
    pub(crate) name: &'static str,
    /// Returns its `path` elements, one for each stroke.
    paths: fn() -> Vec<String>,
}

impl Benchmark {
    const fn new(name: &'static str, paths: fn() -> Vec<String>) -> Self {
        Self { name, paths }
    }

    /// Returns the drawing as the text of an SVG file.
    pub(crate) fn svg(&self) -> String {
        format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH_MM}mm" height="{HEIGHT_MM}mm" viewBox="0 0 {WIDTH_MM} {HEIGHT_MM}" fill="none" stroke="black" stroke-width="0.3" stroke-linecap="round">
{}
</svg>
"#,
            (self.paths)().join("\n")
        )
    }
}

/// A Hilbert curve of 65,535 segments as one stroke, in a square of 118 mm.
fn hilbert() -> Vec<String> {
    vec![path(&hilbert_points(), "")]
}

/// The same curve, with each segment as a stroke.
fn hilbert_segments() -> Vec<String> {
    let segments = hilbert_points();
    segments.windows(2).map(|pair| path(pair, "")).collect()
}

fn hilbert_points() -> Vec<[f64; 2]> {
    let cells = 1_u32 << HILBERT_ORDER;
    let step = 118.0 / f64::from(cells - 1);
    let at = |i| hilbert_cell(i).map(|cell| f64::from(cell) * step);
    let points = (0..cells * cells).map(at);
    points.map(|[x, y]| [41.0 + x, 1.0 + y]).collect()
}

/// Returns column and row of the i-th cell on the curve.
fn hilbert_cell(i: u32) -> [u32; 2] {
    let [mut x, mut y] = [0, 0];
    for level in 0..HILBERT_ORDER {
        let (side, quarter) = (1 << level, (i >> (2 * level)) & 3);
        [x, y] = match quarter {
            0 => [y, x],
            1 => [x, y + side],
            2 => [x + side, y + side],
            _ => [2 * side - 1 - y, side - 1 - x],
        };
    }
    [x, y]
}

/// One closed stroke of 20,000 segments: a spirograph.
fn spirograph() -> Vec<String> {
    let mut points = spirograph_points();
    points.pop();
    vec![path(&points, "Z")]
}

/// The same figure in 2,000 pieces of ten segments.
fn spirograph_pieces() -> Vec<String> {
    let points = spirograph_points();
    let pieces = (0..2000).map(|piece| &points[10 * piece..=10 * piece + 10]);
    pieces.map(|piece| path(piece, "")).collect()
}

fn spirograph_points() -> Vec<[f64; 2]> {
    // The wheel has 53 teeth, the ring 120: after 53 rounds the pen is back.
    let (ring, wheel, arm) = (120.0, 53.0, 44.0);
    let scale = 59.0 / (ring - wheel + arm);
    let at = |i: u32| {
        let angle = TAU * wheel * f64::from(i) / 20_000.0;
        let turned = angle * (ring - wheel) / wheel;
        let x = (ring - wheel) * angle.cos() + arm * turned.cos();
        let y = (ring - wheel) * angle.sin() - arm * turned.sin();
        [100.0 + scale * x, 60.0 + scale * y]
    };
    (0..=20_000).map(at).collect()
}

/// 2,000 strokes of lettering: words in lines, in reading order.
fn text() -> Vec<String> {
    let mut random = Random::new(7);
    let (mut strokes, mut line, mut y) = (Vec::new(), String::new(), 8.0);
    while strokes.len() < 2000 {
        let word = WORDS[below(&mut random, WORDS.len())];
        if width(&format!("{line} {word}"), LETTER_MM) > 190.0 {
            strokes.append(&mut letters(&line, y));
            line.clear();
            y += 5.3;
        }
        line += if line.is_empty() { "" } else { " " };
        line += word;
    }
    strokes.truncate(2000);
    strokes
}

/// Returns every stroke of a line of text as an element.
fn letters(line: &str, y: f64) -> Vec<String> {
    strokes(line, Anchor::Left, Point::new(5.0, y), LETTER_MM)
        .iter()
        .map(|line| path(&line.iter().map(|p| [p.x, p.y]).collect::<Vec<_>>(), ""))
        .collect()
}

/// 10,000 dots that shade two spheres, in scanning order from the top.
fn stipple() -> Vec<String> {
    let mut random = Random::new(11);
    let mut dots = Vec::new();
    while dots.len() < 10_000 {
        let dot = [
            2.0 + 196.0 * share(&mut random),
            2.0 + 116.0 * share(&mut random),
        ];
        if share(&mut random) < darkness(dot).powi(2) {
            dots.push(dot);
        }
    }
    let row = |dot: &[f64; 2]| (dot[1] / 1.5).floor();
    dots.sort_by(|a, b| row(a).total_cmp(&row(b)).then(a[0].total_cmp(&b[0])));
    let element = |[x, y]: [f64; 2]| format!(r#"<path d="M{x:.3} {y:.3}h0"/>"#);
    dots.into_iter().map(element).collect()
}

/// 5,000 hatch lines that shade the same spheres: the darker a spot, the more directions cross.
fn hatch() -> Vec<String> {
    let mut lines = Vec::new();
    for (family, least) in [0.15, 0.3, 0.45, 0.6, 0.75].into_iter().enumerate() {
        let angle = TAU * (0.08 + 0.1 * f64::from(u8::try_from(family).unwrap_or_default()));
        hatch_family(angle, least, &mut lines);
    }
    // The longest 5,000, in the order in which they were found.
    let mut lengths: Vec<f64> = lines.iter().map(length).collect();
    lengths.sort_by(|a, b| b.total_cmp(a));
    let least = lengths[4999];
    lines.retain(|line| length(line) >= least);
    lines.truncate(5000);
    lines.iter().map(|line| path(line, "")).collect()
}

/// 24,000 short curved strokes that follow the waves of a field, at random places.
fn engraving() -> Vec<String> {
    let mut random = Random::new(3);
    let stroke = |_| {
        let mut at = [
            3.0 + 194.0 * share(&mut random),
            3.0 + 114.0 * share(&mut random),
        ];
        let mut angle = (0.05 * at[0]).sin() + (0.07 * at[1]).cos();
        let points = (0..5).map(|_| {
            let here = at;
            angle += 0.15;
            at = [here[0] + 0.4 * angle.cos(), here[1] + 0.4 * angle.sin()];
            here
        });
        path(&points.collect::<Vec<_>>(), "")
    };
    (0..24_000).map(stroke).collect()
}

/// A circuit board: 300 round pads, and 1,100 tracks that turn by 45 degrees.
fn circuit() -> Vec<String> {
    let mut random = Random::new(5);
    let mut place = |width: usize, height: usize| {
        let [x, y] = [width, height].map(|most| below(&mut random, most) + 8);
        format!(r#"<path d="M{x} {y}"#)
    };
    let mut paths = Vec::new();
    for pad in 0..300 {
        let radius = [0.5, 0.8, 1.0][pad % 3];
        let half = |way: f64| format!("a{radius} {radius} 0 1 1 {way} 0");
        let (there, back) = (half(2.0 * radius), half(-2.0 * radius));
        paths.push(place(184, 104) + &there + &back + r#"z"/>"#);
    }
    for track in 0..1100_usize {
        let part = |i: usize| {
            let way = ["h6", "h-6", "h3", "h-3"][(track / 3 + i) % 4];
            let turn = ["l2 2", "l-2 2", "l2 -2", "l-2 -2"][(track + 3 * i) % 4];
            format!("{way}{turn}")
        };
        paths.push(place(184, 104) + &part(0) + &part(1) + &part(2) + r#""/>"#);
    }
    paths
}

/// Parallel lines, interrupted where the picture is too bright for them.
fn hatch_family(angle: f64, least: f64, lines: &mut Vec<[[f64; 2]; 2]>) {
    let (sin, cos) = angle.sin_cos();
    for row in -200..200 {
        let mut from = None;
        for step in -1200..=1200 {
            let (along, across) = (0.1 * f64::from(step), 0.6 * f64::from(row));
            let p = [
                100.0 + cos * along - sin * across,
                60.0 + sin * along + cos * across,
            ];
            // Noise in the tone interrupts the lines, like the grain of a photograph.
            let grain = 0.2 * ((1.7 * p[0]).sin() * (1.3 * p[1] + 0.4 * p[0]).cos());
            if on_page(p) && darkness(p) + grain > least {
                let start = from.map_or(p, |line: [[f64; 2]; 2]| line[0]);
                from = Some([start, p]);
            } else {
                lines.extend(from.take());
            }
        }
        lines.extend(from);
    }
}

/// The darkness of the picture at a point, from 0 to 1: two spheres lit from the upper left.
fn darkness(p: [f64; 2]) -> f64 {
    let ball = |x: f64, y: f64, radius: f64| {
        let [dx, dy] = [(p[0] - x) / radius, (p[1] - y) / radius];
        let height2 = 1.0 - dx * dx - dy * dy;
        let light = (0.64 * height2.max(0.0).sqrt() - 0.48 * dx - 0.6 * dy).max(0.0);
        (height2 > 0.0).then_some(1.0 - 0.9 * light)
    };
    ball(66.0, 62.0, 50.0)
        .or_else(|| ball(152.0, 78.0, 36.0))
        .unwrap_or(0.1 + 0.1 * p[1] / HEIGHT_MM)
}

fn on_page(p: [f64; 2]) -> bool {
    (2.0..=WIDTH_MM - 2.0).contains(&p[0]) && (2.0..=HEIGHT_MM - 2.0).contains(&p[1])
}

fn length([a, b]: &[[f64; 2]; 2]) -> f64 {
    (b[0] - a[0]).hypot(b[1] - a[1])
}

/// Returns a `path` element through these points.
fn path(points: &[[f64; 2]], end: &str) -> String {
    let mut element = r#"<path d="M"#.to_owned();
    for [x, y] in points {
        write!(element, "{x:.4} {y:.4} ").expect("a string takes all");
    }
    element + end + r#""/>"#
}

fn shuffled(mut paths: Vec<String>) -> Vec<String> {
    let mut random = Random::new(3);
    for i in (1..paths.len()).rev() {
        paths.swap(i, below(&mut random, i + 1));
    }
    paths
}

fn below(random: &mut Random, count: usize) -> usize {
    random.below(u32::try_from(count).expect("there are few")) as usize
}

/// Returns a random number from 0 to 1.
fn share(random: &mut Random) -> f64 {
    f64::from((random.number() >> 32) as u32) / f64::from(u32::MAX)
}

const WIDTH_MM: f64 = 200.0;
const HEIGHT_MM: f64 = 120.0;
const HILBERT_ORDER: u32 = 8;
const LETTER_MM: f64 = 3.0;
const WORDS: [&str; 32] = [
    "the", "arm", "draws", "a", "line", "and", "lifts", "its", "pen", "where", "one", "stroke",
    "ends", "before", "it", "goes", "on", "with", "next", "of", "paper", "ink", "far", "quick",
    "joint", "by", "elbow", "vector", "zigzag", "home", "to", "rests",
];
