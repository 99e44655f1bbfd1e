//! Plot of a run: the tool path, angles and speeds over time, pump and laser.

mod axis;
mod chart;
mod views;

use std::time::Duration;

use dobot_arm::TICK_S;
use dobot_controller::{Controller, Personality};
use dobot_lettering::{Anchor, Rectangle, ShapeStyle, Sheet, TextStyle};

use self::axis::Axis;
use self::chart::{Chart, Curve, bands};
use self::views::views;
use crate::TracedStatus;

/// The plot of a run.
#[derive(Clone, Copy, Debug)]
pub struct Plot<'a> {
    /// The title.
    pub title: &'a str,
    /// The personality of the controller.
    pub personality: Personality,
    /// The arm at every control tick.
    pub snapshots: &'a [Snapshot],
    /// The statuses, which show where the pose is lost.
    pub statuses: &'a [TracedStatus],
}

/// The arm at a control tick.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Snapshot {
    /// The time.
    pub at: Duration,
    /// The angles of base, rear arm, forearm and servo, in degrees.
    pub joints_deg: [f64; 4],
    /// The true tool position in the base frame: x, y and z in millimetres.
    pub tool_mm: [f64; 3],
    /// Whether the pump is on.
    pub pump: bool,
    /// Whether the laser is on.
    pub laser: bool,
}

impl Plot<'_> {
    /// Returns the plot as the text of an SVG file.
    #[must_use]
    pub fn to_svg(&self) -> String {
        let page = Rectangle::between([0.0, 0.0], [WIDTH, HEIGHT]);
        let mut sheet = Sheet::new(page, "px");
        sheet.rect(&page, 0.0, &ShapeStyle::area(PAPER));
        sheet.text([LEFT, 38.0], Anchor::Left, &TITLE, self.title);
        sheet.text([LEFT, 60.0], Anchor::Left, &QUIET, &self.subtitle());
        views(&mut sheet, self.snapshots);
        let time = self.time_axis();
        self.angles(&mut sheet, &time);
        self.speeds(&mut sheet, &time);
        self.tool_speed(&mut sheet, &time);
        bands(&mut sheet, &time, self.snapshots, BANDS_TOP);
        sheet.finish()
    }

    fn subtitle(&self) -> String {
        let time = self.end_s();
        let end = match self.snapshots.last().map(|it| it.tool_mm) {
            None => String::new(),
            Some([x, y, z]) => format!("  ·  ends at x {x:.2}, y {y:.2}, z {z:.2} mm"),
        };
        format!("{}  ·  {time} s{end}", self.personality)
    }

    fn end_s(&self) -> f64 {
        self.snapshots.last().map_or(0.0, |it| it.at.as_secs_f64())
    }

    fn time_axis(&self) -> Axis {
        Axis::exact([0.0, self.end_s() + TICK_S], [LEFT, RIGHT])
    }

    fn angles(&self, sheet: &mut Sheet, time: &Axis) {
        let chart = Chart::new("Joint angles", "°", [572.0, 190.0]);
        let curves = JOINTS.map(|(joint, name, color)| Curve {
            name,
            color,
            points: self.over_time(|it, _| it.joints_deg[joint]),
        });
        chart.draw(sheet, time, &curves, &self.lost());
    }

    fn speeds(&self, sheet: &mut Sheet, time: &Axis) {
        let chart = Chart::new("Joint speeds", "°/s", [812.0, 160.0]);
        let curves = JOINTS.map(|(joint, name, color)| Curve {
            name,
            color,
            points: self.over_time(|it, before| {
                let way = it.joints_deg[joint] - before.joints_deg[joint];
                if is_set_again(it, before) {
                    f64::NAN
                } else {
                    way / TICK_S
                }
            }),
        });
        chart.draw(sheet, time, &curves, &self.lost());
    }

    fn tool_speed(&self, sheet: &mut Sheet, time: &Axis) {
        let chart = Chart::new("Tool speed", "mm/s", [1022.0, 130.0]);
        let points = self.over_time(|it, before| {
            if is_set_again(it, before) {
                f64::NAN
            } else if it.joints_deg == before.joints_deg {
                0.0 // Another tool changes the tool's place, too.
            } else {
                distance(it.tool_mm, before.tool_mm) / TICK_S
            }
        });
        let curve = Curve {
            name: "",
            color: INK,
            points,
        };
        chart.draw(sheet, time, &[curve], &self.lost());
    }

    /// The time ranges, in seconds, in which the reported pose is NaN.
    fn lost(&self) -> Vec<[f64; 2]> {
        let is_lost = |it: &TracedStatus| it.floats.iter().any(|it| it.is_nan());
        let runs = self.statuses.chunk_by(|a, b| is_lost(a) == is_lost(b));
        let mut starts: Vec<_> = runs
            .map(|run| (status_s(&run[0]), is_lost(&run[0])))
            .collect();
        starts.push((self.end_s() + TICK_S, false));
        let spans = starts.windows(2).filter(|it| it[0].1);
        spans.map(|it| [it[0].0, it[1].0]).collect()
    }

    /// The reported values at each time and a tick earlier.
    fn over_time(&self, value: impl Fn(&Snapshot, &Snapshot) -> f64) -> Vec<[f64; 2]> {
        let before = self.snapshots.iter().take(1).chain(self.snapshots);
        self.snapshots
            .iter()
            .zip(before)
            .map(|(it, before)| [it.at.as_secs_f64(), value(it, before)])
            .collect()
    }
}

impl Snapshot {
    /// Takes a snapshot of a controller at the time of its last control tick.
    #[must_use]
    pub fn of(controller: &Controller, at: Duration) -> Self {
        let position = controller.pose_at(at).position;
        Self {
            at,
            joints_deg: controller.joints_at(at).angles_deg(),
            tool_mm: [position.x.0, position.y.0, position.z.0],
            pump: controller.suction(),
            laser: controller.laser(),
        }
    }

    /// Whether the pose is finite.
    fn is_known(&self) -> bool {
        self.joints_deg
            .iter()
            .chain(&self.tool_mm)
            .all(|it| it.is_finite())
    }
}

fn status_s(status: &TracedStatus) -> f64 {
    f64::from(status.tick) * TICK_S
}

/// Whether the angles changed more in a tick than a motor can turn, so that they were set.
fn is_set_again(it: &Snapshot, before: &Snapshot) -> bool {
    let ways = it.joints_deg.iter().zip(&before.joints_deg);
    ways.map(|(a, b)| (a - b).abs()).any(|way| way > 10.0)
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|n| (a[n] - b[n]).powi(2)).sum::<f64>().sqrt()
}

/// The joints: their indices in a snapshot, names and colour-blind safe colours.
const JOINTS: [(usize, &str, &str); 4] = [
    (0, "base", "#0072b2"),
    (1, "rear arm", "#d55e00"),
    (2, "forearm", "#009e73"),
    (3, "servo", "#aa4499"),
];
const WIDTH: f64 = 1200.0;
const HEIGHT: f64 = 1268.0;
const LEFT: f64 = 84.0;
const RIGHT: f64 = 1164.0;
const BANDS_TOP: f64 = 1176.0;

const PAPER: &str = "#ffffff";
const INK: &str = "#1f2937";
const SOFT: &str = "#6b7280";
const PANEL: ShapeStyle<'_> = ShapeStyle::area("#fafafa");
const GRID: ShapeStyle<'_> = ShapeStyle::line("#e5e7eb", 1.0);
const LASER: &str = "#dc2626";
const PUMP: &str = "#0284c7";
/// The colour of ranges with a NaN pose.
const LOST: &str = "#fde2e2";
const TITLE: TextStyle<'_> = TextStyle::new(14.0, INK).bold();
const HEADING: TextStyle<'_> = TextStyle::new(LETTERS, INK).bold();
const PLAIN: TextStyle<'_> = TextStyle::new(LETTERS, INK);
const QUIET: TextStyle<'_> = TextStyle::new(LETTERS, SOFT);
const LETTERS: f64 = 8.6;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test fails by it")]
mod tests;
