//! Lines that run along the edges of what is seen, the denser the darker it is.

use dobot_geometry::{Point, Stroke, Vec2};
use dobot_random::Random;

use super::shading::Shading;
use super::tone::{Tone, as_ink, cell, count};

/// Draws a page with lines along its edges: across the way in which the tone changes most. Where it is
/// black they lie `spacing_mm` (on the page) apart, elsewhere farther in proportion; white stays empty.
///
/// Each line begins at a place that has room, and goes on to both sides until it comes too near to
/// another one (evenly spaced streamlines).
pub(super) fn flowing(tone: &Tone, shading: &Shading, spacing_mm: f64) -> Vec<Stroke> {
    let mut flow = Flow {
        ways: Ways::new(tone, shading.angle_deg, spacing_mm),
        tone,
        spacing_mm,
        drawn: Drawn::new(tone.page(), spacing_mm),
    };
    let mut strokes: Vec<Stroke> = Vec::new();
    for start in starts(tone.page(), spacing_mm, shading.seed) {
        let Some(line) = flow.line(start) else {
            continue;
        };
        for &p in &line {
            flow.drawn.put(p);
        }
        strokes.push(Stroke::open(line));
    }
    strokes
}

struct Flow<'a> {
    ways: Ways,
    tone: &'a Tone,
    spacing_mm: f64,
    drawn: Drawn,
}

impl Flow<'_> {
    /// The line through a place; none where it has no room, or becomes too short.
    fn line(&self, start: Point) -> Option<Vec<Point>> {
        if !self.has_room(start, 1.0) {
            return None;
        }
        let way = self.ways.at(start);
        let mut line = self.half(start, -way);
        line.reverse();
        line.push(start);
        line.append(&mut self.half(start, way));
        let length_mm: f64 = line.windows(2).map(|it| it[0].distance(it[1])).sum();
        (length_mm >= SHORTEST * self.spacing_mm).then_some(line)
    }

    fn half(&self, start: Point, mut way: Vec2) -> Vec<Point> {
        let step_mm = STEP * self.spacing_mm;
        let (mut here, mut line) = (start, Vec::new());
        for steps in 0..MOST_STEPS {
            // Half a step, to see which way it goes there.
            let middle = along(self.ways.at(here + way * (0.5 * step_mm)), way);
            let next = here + middle * step_mm;
            if !self.has_room(next, GO_ON) || (steps > HOME && next.distance(start) < step_mm) {
                break;
            }
            way = along(self.ways.at(next), middle);
            here = next;
            line.push(here);
        }
        line
    }

    /// Whether a line may lie there: it is not white, and no other is nearer than a share of what its
    /// tone asks for.
    fn has_room(&self, p: Point, share: f64) -> bool {
        let page = self.tone.page();
        if p.x < 0.0 || p.y < 0.0 || p.x > page.x || p.y > page.y {
            return false;
        }
        let ink = self.tone.at(p);
        let apart_mm = self.spacing_mm * (1.0 / ink.max(1e-9)).min(WIDEST);
        ink >= WHITE && !self.drawn.is_near(p, share * apart_mm)
    }
}

/// The way that is less of a turn.
fn along(way: Vec2, before: Vec2) -> Vec2 {
    if way.dot(before) < 0.0 { -way } else { way }
}

/// Which way lines run, as the doubled angle's cosine and sine: one way and its opposite are the same.
struct Ways {
    cos: Tone,
    sin: Tone,
    /// Where nothing tells a way.
    otherwise: Vec2,
}

impl Ways {
    fn new(tone: &Tone, angle_deg: f64, spacing_mm: f64) -> Self {
        let soft = tone.blurred(spacing_mm);
        let (mut cos, mut sin) = (soft.clone(), soft.clone());
        for y in 0..tone.height {
            for x in 0..tone.width {
                let slope = slope(&soft, x, y);
                // Twice the angle of the slope, and a quarter turn from there.
                cos.ink[y * tone.width + x] = as_ink(slope.y * slope.y - slope.x * slope.x);
                sin.ink[y * tone.width + x] = as_ink(-2.0 * slope.x * slope.y);
            }
        }
        let (up, right) = angle_deg.to_radians().sin_cos();
        Self {
            cos: cos.blurred(REGION * spacing_mm),
            sin: sin.blurred(REGION * spacing_mm),
            otherwise: Vec2::new(right, -up),
        }
    }

    fn at(&self, p: Point) -> Vec2 {
        let (cos, sin) = (self.cos.at(p), self.sin.at(p));
        if cos.hypot(sin) < FLAT {
            return self.otherwise;
        }
        Vec2::from_angle(sin.atan2(cos) / 2.0)
    }
}

/// How the tone changes at a cell, for each millimetre.
fn slope(tone: &Tone, x: usize, y: usize) -> Vec2 {
    let ink = |x: usize, y: usize| f64::from(tone.ink[y * tone.width + x]);
    let (right, below) = ((x + 1).min(tone.width - 1), (y + 1).min(tone.height - 1));
    let (left, above) = (x.saturating_sub(1), y.saturating_sub(1));
    Vec2::new(
        (ink(right, y) - ink(left, y)) / (count(right - left).max(1.0) * tone.cell.x),
        (ink(x, below) - ink(x, above)) / (count(below - above).max(1.0) * tone.cell.y),
    )
}

/// The points of all lines so far, in squares.
struct Drawn {
    columns: usize,
    rows: usize,
    side_mm: f64,
    squares: Vec<Vec<Point>>,
}

impl Drawn {
    fn new(page: Point, side_mm: f64) -> Self {
        let squares = |mm: f64| cell((mm / side_mm).ceil(), MOST_SQUARES) + 1;
        let (columns, rows) = (squares(page.x), squares(page.y));
        Self {
            columns,
            rows,
            side_mm,
            squares: vec![Vec::new(); columns * rows],
        }
    }

    fn put(&mut self, p: Point) {
        let [x, y] = self.square(p);
        self.squares[y * self.columns + x].push(p);
    }

    fn is_near(&self, p: Point, within_mm: f64) -> bool {
        let off = Vec2::splat(within_mm);
        let ([x0, y0], [x1, y1]) = (self.square(p - off), self.square(p + off));
        (y0..=y1).any(|y| {
            let row = &self.squares[y * self.columns + x0..=y * self.columns + x1];
            row.iter().flatten().any(|it| it.distance(p) < within_mm)
        })
    }

    fn square(&self, p: Point) -> [usize; 2] {
        [
            cell(p.x / self.side_mm, self.columns),
            cell(p.y / self.side_mm, self.rows),
        ]
    }
}

/// Where lines may begin: one place in each square of the page, in an order like chance.
fn starts(page: Point, spacing_mm: f64, seed: u64) -> Vec<Point> {
    let side_mm = START * spacing_mm;
    let squares = |mm: f64| cell((mm / side_mm).ceil(), MOST_SQUARES);
    let mut random = Random::new(seed);
    let mut starts: Vec<(f64, Point)> = Vec::new();
    for y in 0..squares(page.y) {
        for x in 0..squares(page.x) {
            let [right, down] = [random.share(), random.share()];
            let at = Point::new(count(x) + right, count(y) + down).to_vec2() * side_mm;
            starts.push((random.share(), at.to_point()));
        }
    }
    starts.sort_by(|a, b| a.0.total_cmp(&b.0));
    starts.into_iter().map(|it| it.1).collect()
}

/// From corner to corner, in spacings.
const STEP: f64 = 0.5;
/// A line that goes on may come so much nearer to others than one that begins.
const GO_ON: f64 = 0.6;
/// How long a line is at least, in spacings.
const SHORTEST: f64 = 3.0;
/// The farthest apart, in spacings.
const WIDEST: f64 = 7.0;
/// Less ink than that is white.
const WHITE: f64 = 0.05;
/// After so many steps a line may come home.
const HOME: usize = 8;
const MOST_STEPS: usize = 2000;
/// How far ways are mixed, in spacings.
const REGION: f64 = 3.0;
/// What changes less, squared and for each millimetre, tells no way.
const FLAT: f64 = 1e-7;
/// A line may begin in each square so wide, in spacings.
const START: f64 = 0.7;
const MOST_SQUARES: usize = 4000;
