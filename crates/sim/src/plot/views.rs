//! The way of the tool, from above and from the side.

use dobot_lettering::{Anchor, Rectangle, ShapeStyle, Sheet};

use super::axis::{Axis, range};
use super::{GRID, HEADING, INK, LASER, LEFT, PANEL, PAPER, PLAIN, PUMP, QUIET, RIGHT, Snapshot};

/// Draws both views, and what their colours mean.
pub(super) fn views(sheet: &mut Sheet, snapshots: &[Snapshot]) {
    let middle = f64::midpoint(LEFT, RIGHT);
    let top = View {
        title: "From above",
        axes: ["x (mm)", "y (mm)"],
        pixels: [LEFT, middle - 44.0],
        points: points(snapshots, |[x, y, _]| [x, y]),
    };
    let side = View {
        title: "From the side",
        axes: ["reach from the base axis (mm)", "z (mm)"],
        pixels: [middle + 44.0, RIGHT],
        points: points(snapshots, |[x, y, z]| [x.hypot(y), z]),
    };
    top.draw(sheet, snapshots);
    side.draw(sheet, snapshots);
    legend(sheet, snapshots);
}

struct View {
    title: &'static str,
    axes: [&'static str; 2],
    pixels: [f64; 2],
    points: Vec<[f64; 2]>,
}

impl View {
    fn draw(&self, sheet: &mut Sheet, snapshots: &[Snapshot]) {
        let axes = self.scales();
        self.frame(sheet, &axes);
        let kinds = snapshots.iter().map(ToolUse::of);
        let points = self
            .points
            .iter()
            .map(|&[u, v]| [axes[0].pixel(u), axes[1].pixel(v)]);
        let pixels: Vec<_> = points.zip(kinds).collect();
        for (stroke, kind) in strokes(&pixels) {
            sheet.curve(&stroke, &kind.look());
        }
        let known = || pixels.iter().map(|it| it.0).filter(|it| it[0].is_finite());
        if let (Some(first), Some(last)) = (known().next(), known().next_back()) {
            dot(sheet, first, PAPER);
            dot(sheet, last, INK);
        }
    }

    /// Millimetres are as long upwards as sideways.
    fn scales(&self) -> [Axis; 2] {
        let [left, right] = self.pixels;
        let spans = [0, 1].map(|n| range(self.points.iter().map(|it| it[n])));
        let sizes = [right - left, BOTTOM - TOP];
        let mm_per_pixel = (0..2)
            .map(|n| (1.12 * (spans[n][1] - spans[n][0])).max(20.0) / sizes[n])
            .fold(0.0, f64::max);
        let axis = |n: usize, pixels| {
            let center = f64::midpoint(spans[n][0], spans[n][1]);
            let half = sizes[n] * mm_per_pixel / 2.0;
            Axis::exact([center - half, center + half], pixels)
        };
        [axis(0, [left, right]), axis(1, [BOTTOM, TOP])]
    }

    fn frame(&self, sheet: &mut Sheet, axes: &[Axis; 2]) {
        let [left, right] = self.pixels;
        sheet.text([left, TOP - 10.0], Anchor::Left, &HEADING, self.title);
        sheet.rect(
            &Rectangle::between([left, TOP], [right, BOTTOM]),
            0.0,
            &PANEL,
        );
        for (value, text) in axes[0].ticks(60.0) {
            let x = axes[0].pixel(value);
            sheet.line([x, TOP], [x, BOTTOM], &GRID);
            sheet.text([x, BOTTOM + 18.0], Anchor::Middle, &QUIET, &text);
        }
        for (value, text) in axes[1].ticks(50.0) {
            let y = axes[1].pixel(value);
            sheet.line([left, y], [right, y], &GRID);
            sheet.text([left - 8.0, y + 4.5], Anchor::Right, &QUIET, &text);
        }
        self.label_axes(sheet);
    }

    fn label_axes(&self, sheet: &mut Sheet) {
        let [left, right] = self.pixels;
        let middle = f64::midpoint(left, right);
        sheet.text(
            [middle, BOTTOM + 38.0],
            Anchor::Middle,
            &PLAIN,
            self.axes[0],
        );
        sheet.text(
            [right, TOP - 10.0],
            Anchor::Right,
            &PLAIN,
            &format!("↑ {}", self.axes[1]),
        );
    }
}

/// What the tool does on its way.
#[derive(Clone, Copy, Debug, PartialEq)]
enum ToolUse {
    Free,
    Pump,
    Laser,
}

impl ToolUse {
    const fn of(snapshot: &Snapshot) -> Self {
        match snapshot {
            Snapshot { laser: true, .. } => Self::Laser,
            Snapshot { pump: true, .. } => Self::Pump,
            _ => Self::Free,
        }
    }

    const fn look(self) -> ShapeStyle<'static> {
        match self {
            Self::Free => ShapeStyle::line("#64748b", 1.6),
            Self::Pump => ShapeStyle::line(PUMP, 2.6),
            Self::Laser => ShapeStyle::line(LASER, 2.6),
        }
    }
}

fn dot(sheet: &mut Sheet, at: [f64; 2], fill: &str) {
    sheet.circle(at, 5.0, &ShapeStyle::area(fill).edged(INK, 2.0));
}

fn points(snapshots: &[Snapshot], seen: impl Fn([f64; 3]) -> [f64; 2]) -> Vec<[f64; 2]> {
    let place = |it: &Snapshot| {
        if it.is_known() {
            seen(it.tool_mm)
        } else {
            [f64::NAN; 2]
        }
    };
    snapshots.iter().map(place).collect()
}

/// The way in strokes of one kind, without points nearer to each other than a part of a pixel,
/// and without those that are none.
fn strokes(pixels: &[([f64; 2], ToolUse)]) -> Vec<(Vec<[f64; 2]>, ToolUse)> {
    let known = pixels.chunk_by(|a, b| a.0[0].is_finite() == b.0[0].is_finite());
    let mut strokes = Vec::new();
    for run in known.filter(|run| run[0].0[0].is_finite()) {
        let mut from = run[0].0;
        for run in run.chunk_by(|a, b| a.1 == b.1) {
            let points = run.iter().map(|it| it.0);
            strokes.push((thinned(from, points), run[0].1));
            from = run[run.len() - 1].0;
        }
    }
    strokes
}

fn thinned(from: [f64; 2], points: impl Iterator<Item = [f64; 2]>) -> Vec<[f64; 2]> {
    let mut kept = vec![from];
    let mut last = from;
    let mut skipped = None;
    for point in points {
        if (point[0] - last[0]).hypot(point[1] - last[1]) > 0.4 {
            kept.push(point);
            last = point;
            skipped = None;
        } else if point != last {
            skipped = Some(point);
        }
    }
    kept.extend(skipped);
    kept
}

fn legend(sheet: &mut Sheet, snapshots: &[Snapshot]) {
    let names = [
        (ToolUse::Free, "the tool's way"),
        (ToolUse::Pump, "with the pump on"),
        (ToolUse::Laser, "with the laser on"),
    ];
    let mut x = LEFT;
    for (kind, name) in names {
        if snapshots.iter().any(|it| ToolUse::of(it) == kind) {
            sheet.line([x, LEGEND], [x + 26.0, LEGEND], &kind.look());
            sheet.text([x + 34.0, LEGEND + 4.5], Anchor::Left, &PLAIN, name);
            x += 170.0;
        }
    }
    for (fill, name) in [(PAPER, "start"), (INK, "end")] {
        dot(sheet, [x + 6.0, LEGEND], fill);
        sheet.text([x + 18.0, LEGEND + 4.5], Anchor::Left, &PLAIN, name);
        x += 70.0;
    }
}

const TOP: f64 = 106.0;
const BOTTOM: f64 = 446.0;
const LEGEND: f64 = 508.0;
