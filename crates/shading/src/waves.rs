//! Parallel waves, wider and faster in darker areas.

use dobot_geometry::{CancelToken, Point, Stroke};

use crate::rows::{Rows, strokes};
use crate::shading::Shading;
use crate::tone::Tone;

/// Draws a page with parallel lines, back and forth, each swinging from side to side.
///
/// Each swing is one vector, because the arm's link is slow: the wave is a zigzag. In light areas
/// the lines are straight, in lighter ones every other line is left out, in white ones all are.
/// `spacing_mm` is on the page.
pub(crate) fn waves(
    tone: &Tone,
    shading: &Shading,
    spacing_mm: f64,
    cancel: &CancelToken,
) -> Vec<Stroke> {
    let tone = tone.blurred(SOFTNESS * spacing_mm, cancel);
    let rows = Rows {
        page: tone.page(),
        margin_mm: WIDEST * spacing_mm,
        spacing_mm,
        angle_deg: shading.angle_deg,
    };
    let line = |(i, [a, b]): (usize, [Point; 2])| Wave::new(&tone, &rows, i, a).pieces(b);
    let lines = rows.lines().into_iter().enumerate();
    let lines = lines
        .take_while(|_| !cancel.is_cancelled())
        .map(line)
        .collect();
    strokes(lines, REACH * spacing_mm, shading.apart)
}

/// The wave along one line.
struct Wave<'a> {
    tone: &'a Tone,
    rows: &'a Rows,
    start: Point,
    /// The tone from which this line is drawn.
    from_ink: f64,
}

impl<'a> Wave<'a> {
    fn new(tone: &'a Tone, rows: &'a Rows, line: usize, start: Point) -> Self {
        Self {
            tone,
            rows,
            start,
            from_ink: if line.is_multiple_of(2) { FAINT } else { LIGHT },
        }
    }

    fn pieces(&self, end: Point) -> Vec<Vec<Point>> {
        let length_mm = self.start.distance(end);
        let mut pieces = Vec::new();
        let mut piece = Vec::new();
        let (mut at_mm, mut side) = (0.0, 1.0);
        while at_mm < length_mm {
            let ink = self.tone.at(self.place(at_mm, 0.0));
            // Hysteresis: a started line continues a little longer, which avoids dashes.
            let least = self.from_ink * if piece.is_empty() { 1.0 } else { GO_ON };
            if ink >= least {
                piece.push(self.place(at_mm, side * self.swing_mm(ink)));
            } else {
                self.finish(&mut pieces, &mut piece);
            }
            at_mm += self.step_mm(ink);
            side = -side;
        }
        if !piece.is_empty() {
            let ink = self.tone.at(end);
            piece.push(self.place(length_mm, side * self.swing_mm(ink)));
        }
        self.finish(&mut pieces, &mut piece);
        pieces
    }

    fn finish(&self, pieces: &mut Vec<Vec<Point>>, piece: &mut Vec<Point>) {
        let piece = std::mem::take(piece);
        if let [first, .., last] = piece[..]
            && first.distance(last) >= SHORTEST * self.rows.spacing_mm
        {
            pieces.push(piece);
        }
    }

    fn place(&self, along_mm: f64, across_mm: f64) -> Point {
        self.start + self.rows.along() * along_mm + self.rows.across() * across_mm
    }

    fn swing_mm(&self, ink: f64) -> f64 {
        self.rows.spacing_mm * WIDEST * strength(ink)
    }

    /// The distance between turns.
    fn step_mm(&self, ink: f64) -> f64 {
        let steps = SLOWEST + (FASTEST - SLOWEST) * strength(ink);
        self.rows.spacing_mm * steps
    }
}

/// The fraction of the full swing for a tone; the straight line alone is as dark as [`PLAIN`].
pub(crate) fn strength(ink: f64) -> f64 {
    ((ink - PLAIN) / (1.0 - PLAIN)).clamp(0.0, 1.0)
}

/// The smoothing radius of tones, in spacings.
pub(crate) const SOFTNESS: f64 = 0.25;
/// The widest swing to one side, in spacings: neighbours nearly touch.
pub(crate) const WIDEST: f64 = 0.48;
/// The distance between turns in light areas, in spacings.
pub(crate) const SLOWEST: f64 = 0.5;
/// The distance between turns in black areas, in spacings.
pub(crate) const FASTEST: f64 = 0.26;
/// The tone of straight lines.
const PLAIN: f64 = 0.25;
/// The tone from which every other line is drawn.
pub(crate) const FAINT: f64 = 0.06;
/// The tone from which every line is drawn.
const LIGHT: f64 = 0.18;
pub(crate) const GO_ON: f64 = 0.75;
/// The shortest piece, in spacings.
pub(crate) const SHORTEST: f64 = 1.0;
/// The largest gap between lines over which the pen stays down, in spacings.
const REACH: f64 = 1.7;
