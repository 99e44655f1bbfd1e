//! Curves and bands over time.

use dobot_lettering::{Anchor, Rectangle, ShapeStyle, Sheet, TextStyle};

use super::Snapshot;
use super::axis::{Axis, range};
use super::{GRID, HEADING, LASER, LETTERS, LOST, PANEL, PLAIN, PUMP, QUIET};

/// A chart of some curves over time.
pub(super) struct Chart {
    title: &'static str,
    unit: &'static str,
    top: f64,
    height: f64,
}

/// A curve: seconds and values.
pub(super) struct Curve {
    pub(super) name: &'static str,
    pub(super) color: &'static str,
    pub(super) points: Vec<[f64; 2]>,
}

impl Chart {
    pub(super) const fn new(
        title: &'static str,
        unit: &'static str,
        [top, height]: [f64; 2],
    ) -> Self {
        Self {
            title,
            unit,
            top,
            height,
        }
    }

    pub(super) fn draw(&self, sheet: &mut Sheet, time: &Axis, curves: &[Curve], lost: &[[f64; 2]]) {
        let values = curves.iter().flat_map(|it| &it.points).map(|it| it[1]);
        let axis = Axis::around(values.chain([0.0]), 1.0, [self.top + self.height, self.top]);
        let [left, right] = time.pixels();
        let bottom = self.top + self.height;
        sheet.rect(
            &Rectangle::between([left, self.top], [right, bottom]),
            0.0,
            &PANEL,
        );
        mark_lost(sheet, time, lost, [self.top, bottom]);
        time_grid(sheet, time, [self.top, bottom]);
        for (value, text) in axis.ticks(27.0) {
            let y = axis.pixel(value);
            let zero = ShapeStyle::line("#9ca3af", 1.0);
            let look = if value == 0.0 { zero } else { GRID };
            sheet.line([left, y], [right, y], &look);
            sheet.text([left - 8.0, y + 4.5], Anchor::Right, &QUIET, &text);
        }
        for curve in curves {
            for stroke in curve.strokes(time, &axis) {
                sheet.curve(&stroke, &ShapeStyle::line(curve.color, 1.6));
            }
        }
        self.words(sheet, [left, right], curves);
    }

    fn words(&self, sheet: &mut Sheet, [left, right]: [f64; 2], curves: &[Curve]) {
        let y = self.top - 10.0;
        sheet.text(
            [left, y],
            Anchor::Left,
            &HEADING,
            &format!("{} ({})", self.title, self.unit),
        );
        let named = curves.iter().filter(|it| !it.name.is_empty());
        for (n, curve) in named.rev().enumerate() {
            let x = right - 110.0 * f64::from(u8::try_from(n).unwrap_or_default()) - 92.0;
            let look = ShapeStyle::line(curve.color, 3.0);
            sheet.line([x, y - 4.5], [x + 22.0, y - 4.5], &look);
            sheet.text([x + 29.0, y], Anchor::Left, &PLAIN, curve.name);
        }
    }
}

impl Curve {
    /// The curve in pixels, in strokes where it is known.
    fn strokes(&self, time: &Axis, axis: &Axis) -> Vec<Vec<[f64; 2]>> {
        self.points
            .chunk_by(|a, b| a[1].is_finite() == b[1].is_finite())
            .filter(|run| run[0][1].is_finite())
            .map(|run| {
                let pixels = run.iter().map(|&[t, v]| [time.pixel(t), axis.pixel(v)]);
                thinned(&pixels.collect::<Vec<_>>())
            })
            .collect()
    }
}

/// Pump and laser as bands, and the time below all.
pub(super) fn bands(sheet: &mut Sheet, time: &Axis, snapshots: &[Snapshot], top: f64) {
    let [left, right] = time.pixels();
    let lanes = [
        ("pump", PUMP, spans(snapshots, |it| it.pump)),
        ("laser", LASER, spans(snapshots, |it| it.laser)),
    ];
    for ((name, color, spans), y) in lanes.into_iter().zip([top, top + 20.0]) {
        lane(sheet, time, y, (name, color, &spans));
    }
    let bottom = top + 40.0;
    for (value, text) in time.ticks(80.0) {
        sheet.text(
            [time.pixel(value), bottom + 13.0],
            Anchor::Middle,
            &QUIET,
            &text,
        );
    }
    let middle = f64::midpoint(left, right);
    sheet.text([middle, bottom + 34.0], Anchor::Middle, &PLAIN, "time (s)");
}

/// A band with its name; it is coloured in the spans.
fn lane(
    sheet: &mut Sheet,
    time: &Axis,
    y: f64,
    (name, color, spans): (&str, &'static str, &[[f64; 2]]),
) {
    let [left, right] = time.pixels();
    sheet.rect(
        &Rectangle::between([left, y], [right, y + 15.0]),
        0.0,
        &PANEL,
    );
    sheet.text([left - 8.0, y + 12.0], Anchor::Right, &PLAIN, name);
    for &[from, to] in spans {
        let (from, to) = (time.pixel(from), time.pixel(to));
        let band = Rectangle::between([from, y], [to.max(from + 1.0), y + 15.0]);
        sheet.rect(&band, 0.0, &ShapeStyle::area(color));
    }
}

fn time_grid(sheet: &mut Sheet, time: &Axis, [top, bottom]: [f64; 2]) {
    for (value, _) in time.ticks(80.0) {
        let x = time.pixel(value);
        sheet.line([x, top], [x, bottom], &GRID);
    }
}

/// Marks where the pose is no number.
fn mark_lost(sheet: &mut Sheet, time: &Axis, lost: &[[f64; 2]], [top, bottom]: [f64; 2]) {
    for &[from, to] in lost {
        let (from, to) = (time.pixel(from), time.pixel(to));
        let span = Rectangle::between([from, top], [to, bottom]);
        sheet.rect(&span, 0.0, &ShapeStyle::area(LOST));
        if to - from > 110.0 {
            // Where lines are rare: they stand still at the top, at zero or at the bottom.
            let middle = [f64::midpoint(from, to), top + 0.32 * (bottom - top)];
            let kind = TextStyle::new(LETTERS, LASER);
            sheet.text(middle, Anchor::Middle, &kind, "the pose is NaN");
        }
    }
}

/// From when to when something holds, in seconds.
fn spans(snapshots: &[Snapshot], holds: impl Fn(&Snapshot) -> bool) -> Vec<[f64; 2]> {
    let runs = snapshots.chunk_by(|a, b| holds(a) == holds(b));
    runs.filter(|run| holds(&run[0]))
        .map(|run| [&run[0], &run[run.len() - 1]].map(|it| it.at.as_secs_f64()))
        .collect()
}

/// Of the points in a column of pixels: the first, the lowest, the highest and the last.
fn thinned(pixels: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut kept = Vec::new();
    for column in pixels.chunk_by(|a, b| a[0].floor() == b[0].floor()) {
        if column.len() <= 4 {
            kept.extend_from_slice(column);
            continue;
        }
        let [low, high] = range(column.iter().map(|it| it[1]));
        let at = |y: f64| column.iter().position(|it| it[1] == y).unwrap_or_default();
        let mut places = [0, at(low), at(high), column.len() - 1];
        places.sort_unstable();
        kept.extend(places.map(|it| column[it]));
    }
    kept
}
