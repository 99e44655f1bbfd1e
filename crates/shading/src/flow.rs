//! Lines along the edges of a picture, denser in darker areas.

use dobot_geometry::{CancelToken, CubicBez, ParamCurve, Point, Random, Stroke, Vec2};

use crate::shading::Shading;
use crate::tone::{Tone, as_ink, cell, count};

/// Draws a page with lines along its edges: across the gradient of the tone. In black areas they
/// are `spacing_mm` (on the page) apart, in lighter ones farther in proportion; white stays empty.
///
/// Each line starts at a free place, and continues in both directions until it comes too near to
/// another line or to itself (evenly spaced streamlines). One that returns to its start is closed.
pub(crate) fn flowing(
    tone: &Tone,
    shading: &Shading,
    spacing_mm: f64,
    cancel: &CancelToken,
) -> Vec<Stroke> {
    let mut flow = Flow {
        ways: Ways::new(tone, shading.angle_deg, spacing_mm, cancel),
        tone,
        spacing_mm,
        drawn: Drawn::new(tone.page(), spacing_mm),
        lines: 0,
    };
    let starts = starts(tone.page(), spacing_mm, shading.seed);
    let strokes = starts.into_iter().take_while(|_| !cancel.is_cancelled());
    let strokes = strokes.filter_map(|start| flow.stroke(start));
    strokes.collect()
}

struct Flow<'a> {
    ways: Ways,
    tone: &'a Tone,
    spacing_mm: f64,
    drawn: Drawn,
    /// The number of started lines.
    lines: usize,
}

impl Flow<'_> {
    /// The line through a place; none if there is no room, or it becomes too short.
    fn stroke(&mut self, start: Point) -> Option<Stroke> {
        let begin = Mark {
            at: start,
            line: self.lines,
            along_mm: 0.0,
        };
        if !self.has_room(&begin, 1.0) {
            return None;
        }
        self.lines += 1;
        self.drawn.put(begin);
        let way = self.ways.at(start);
        let (mut points, closed) = self.half(begin, way, 1.0);
        points.insert(0, start);
        if !closed {
            let (mut backward, _) = self.half(begin, -way, -1.0);
            backward.reverse();
            backward.append(&mut points);
            points = backward;
        }
        let stroke = Stroke { points, closed };
        if stroke.length_mm() >= SHORTEST * self.spacing_mm {
            return Some(stroke);
        }
        self.drawn.take_back(&stroke.points, begin.line);
        None
    }

    /// The corners of a line from its start, and whether it returns to the start. `side` is 1 for
    /// the line's direction and -1 against it.
    fn half(&mut self, begin: Mark, begin_way: Vec2, side: f64) -> (Vec<Point>, bool) {
        let step_mm = STEP * self.spacing_mm;
        let (mut here, mut way, mut line) = (begin, begin_way, Vec::new());
        for _ in 0..MAX_STEPS {
            if let Some(home) = self.home(here.at, way, begin.at, begin_way) {
                for &at in &home {
                    self.drawn.put(Mark { at, ..here });
                }
                line.extend(home);
                return (line, true);
            }
            // Half a step, to find the direction there.
            let middle = along(self.ways.at(here.at + way * (0.5 * step_mm)), way);
            here.at += middle * step_mm;
            here.along_mm += side * step_mm;
            if !self.has_room(&here, GO_ON) {
                break;
            }
            way = along(self.ways.at(here.at), middle);
            self.drawn.put(here);
            line.push(here.at);
        }
        (line, false)
    }

    /// The rest of a line that returns to its start: none if that is far, or not ahead, or an arc
    /// to it would not arrive along the line.
    fn home(&self, here: Point, way: Vec2, begin: Point, begin_way: Vec2) -> Option<Vec<Point>> {
        let step_mm = STEP * self.spacing_mm;
        let gap = begin - here;
        let length_mm = gap.length();
        if length_mm > GO_ON * self.apart_mm(here) + step_mm || length_mm < 1e-9 {
            return None;
        }
        let ahead = gap / length_mm;
        let arriving = ahead * (2.0 * way.dot(ahead)) - way;
        if way.dot(ahead) < AHEAD || arriving.dot(begin_way) < AHEAD {
            return None;
        }
        let third_mm = length_mm / 3.0;
        let curve = CubicBez::new(
            here,
            here + way * third_mm,
            begin - begin_way * third_mm,
            begin,
        );
        let pieces = cell((length_mm / step_mm).ceil(), MAX_STEPS).max(1);
        let corner = |i| curve.eval(count(i) / count(pieces));
        let mut line: Vec<Point> = (1..pieces).map(corner).collect();
        line.push(begin);
        line.iter().all(|&p| self.is_inked(p)).then_some(line)
    }

    /// Whether a line may pass there: it is not white, and neither another line nor a distant part
    /// of its own is nearer than a fraction of the spacing of its tone.
    fn has_room(&self, mark: &Mark, share: f64) -> bool {
        let within_mm = share * self.apart_mm(mark.at);
        self.is_inked(mark.at) && !self.drawn.is_near(mark, within_mm)
    }

    /// Whether it is on the page and not white.
    fn is_inked(&self, p: Point) -> bool {
        let page = self.tone.page();
        let is_on_page = p.x >= 0.0 && p.y >= 0.0 && p.x <= page.x && p.y <= page.y;
        is_on_page && self.tone.at(p) >= WHITE
    }

    /// The line spacing at the tone of a place.
    fn apart_mm(&self, p: Point) -> f64 {
        self.spacing_mm * (1.0 / self.tone.at(p).max(1e-9)).min(WIDEST)
    }
}

/// The direction or its opposite, whichever needs the smaller turn.
fn along(way: Vec2, before: Vec2) -> Vec2 {
    if way.dot(before) < 0.0 { -way } else { way }
}

/// The directions of lines, as cosine and sine of the doubled angle: a direction and its opposite
/// are equal.
struct Ways {
    cos: Tone,
    sin: Tone,
    /// The direction where the tone has no gradient.
    otherwise: Vec2,
}

impl Ways {
    fn new(tone: &Tone, angle_deg: f64, spacing_mm: f64, cancel: &CancelToken) -> Self {
        let soft = tone.blurred(spacing_mm, cancel);
        let (mut cos, mut sin) = (soft.clone(), soft.clone());
        for y in 0..tone.height {
            for x in 0..tone.width {
                let slope = slope(&soft, x, y);
                // Twice the angle of the gradient, plus a quarter turn.
                cos.ink[y * tone.width + x] = as_ink(slope.y * slope.y - slope.x * slope.x);
                sin.ink[y * tone.width + x] = as_ink(-2.0 * slope.x * slope.y);
            }
        }
        let (up, right) = angle_deg.to_radians().sin_cos();
        Self {
            cos: cos.blurred(REGION * spacing_mm, cancel),
            sin: sin.blurred(REGION * spacing_mm, cancel),
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

/// The gradient of the tone at a cell, per millimetre.
fn slope(tone: &Tone, x: usize, y: usize) -> Vec2 {
    let ink = |x: usize, y: usize| f64::from(tone.ink[y * tone.width + x]);
    let (right, below) = ((x + 1).min(tone.width - 1), (y + 1).min(tone.height - 1));
    let (left, above) = (x.saturating_sub(1), y.saturating_sub(1));
    Vec2::new(
        (ink(right, y) - ink(left, y)) / (count(right - left).max(1.0) * tone.cell.x),
        (ink(x, below) - ink(x, above)) / (count(below - above).max(1.0) * tone.cell.y),
    )
}

/// A place on a line.
#[derive(Clone, Copy)]
struct Mark {
    at: Point,
    /// The number of its line.
    line: usize,
    /// The distance from the line's start, below 0 against its direction.
    along_mm: f64,
}

impl Mark {
    /// Whether the other place is on the same line, so near along it that the two must be close.
    fn is_beside(&self, other: &Self, within_mm: f64) -> bool {
        let along_mm = (self.along_mm - other.along_mm).abs();
        self.line == other.line && along_mm <= BESIDE * within_mm
    }
}

/// The places of all lines, in squares.
struct Drawn {
    columns: usize,
    rows: usize,
    side_mm: f64,
    squares: Vec<Vec<Mark>>,
}

impl Drawn {
    fn new(page: Point, side_mm: f64) -> Self {
        let squares = |mm: f64| cell((mm / side_mm).ceil(), MAX_SQUARES) + 1;
        let (columns, rows) = (squares(page.x), squares(page.y));
        Self {
            columns,
            rows,
            side_mm,
            squares: vec![Vec::new(); columns * rows],
        }
    }

    fn put(&mut self, mark: Mark) {
        let [x, y] = self.square(mark.at);
        self.squares[y * self.columns + x].push(mark);
    }

    /// Removes a line with these points.
    fn take_back(&mut self, points: &[Point], line: usize) {
        for &p in points {
            let [x, y] = self.square(p);
            self.squares[y * self.columns + x].retain(|square| square.line != line);
        }
    }

    fn is_near(&self, mark: &Mark, within_mm: f64) -> bool {
        let off = Vec2::splat(within_mm);
        let ([x0, y0], [x1, y1]) = (self.square(mark.at - off), self.square(mark.at + off));
        (y0..=y1).any(|y| {
            let row = &self.squares[y * self.columns + x0..=y * self.columns + x1];
            row.iter()
                .flatten()
                .any(|row| row.at.distance(mark.at) < within_mm && !row.is_beside(mark, within_mm))
        })
    }

    fn square(&self, p: Point) -> [usize; 2] {
        [
            cell(p.x / self.side_mm, self.columns),
            cell(p.y / self.side_mm, self.rows),
        ]
    }
}

/// The start candidates: one place in each square of the page, in pseudorandom order.
fn starts(page: Point, spacing_mm: f64, seed: u64) -> Vec<Point> {
    let side_mm = START * spacing_mm;
    let squares = |mm: f64| cell((mm / side_mm).ceil(), MAX_SQUARES);
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
    starts.into_iter().map(|start| start.1).collect()
}

/// The distance between corners, in spacings.
const STEP: f64 = 0.5;
/// The minimum distance to others while a line continues, relative to that of a new one.
const GO_ON: f64 = 0.6;
/// The shortest line, in spacings.
const SHORTEST: f64 = 3.0;
/// The largest spacing, in spacings.
const WIDEST: f64 = 7.0;
/// Less ink counts as white.
const WHITE: f64 = 0.05;
/// Parts of a line may be close to each other within this distance along it, in minimum distances
/// to others.
const BESIDE: f64 = 2.0;
/// The cosine of the largest turn towards a line's start, and of the largest bend on arrival.
const AHEAD: f64 = 0.7;
const MAX_STEPS: usize = 2000;
/// The smoothing radius of directions, in spacings.
const REGION: f64 = 3.0;
/// A smaller squared gradient per millimetre gives no direction.
const FLAT: f64 = 1e-7;
/// The width of the squares of start candidates, in spacings.
const START: f64 = 0.7;
const MAX_SQUARES: usize = 4000;

#[cfg(test)]
mod tests;
