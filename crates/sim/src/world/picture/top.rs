//! The world from above.

use std::fmt::Write as _;

use dobot_arm::{FOREARM, REAR_ARM};
use dobot_geometry::{Point, Vec2, direction};
use dobot_lettering::{Anchor, Rectangle, ShapeStyle, Sheet, TextStyle};

use super::marks::marks;
use super::{INK, MUTED, PAPER, REACH_MM, ROD, STEEL, WARM, contrast, edge, fill};
use crate::world::footprint::Footprint;
use crate::world::{ArmState, Object, ToolAction, WorldState};

/// What is shown: the arm and what it reaches before it, and whatever else there is.
pub(super) fn bounds(state: &WorldState) -> Rectangle {
    let far = REACH_MM[1] + 14.0;
    let (mut min, mut max) = (Point::new(-95.0, -far), Point::new(far, far));
    let mut show = |x: [f64; 2], y: [f64; 2], around: f64| {
        min = Point::new(min.x.min(x[0] - around), min.y.min(y[0] - around));
        max = Point::new(max.x.max(x[1] + around), max.y.max(y[1] + around));
    };
    for object in &state.objects {
        let [x, y] = [0.0, 90.0].map(|it| object.footprint().extent(direction(it)));
        show(x, y, 10.0);
    }
    if let Some(paper) = state.paper {
        let (from, to) = (paper.from_mm, paper.to_mm);
        show([from.x, to.x], [from.y, to.y], 10.0);
    }
    if let Some(arm) = state.arm {
        show([arm.x_mm; 2], [arm.y_mm; 2], 30.0);
    }
    Rectangle {
        left: -max.y,
        top: -max.x,
        width: max.y - min.y,
        height: max.x - min.x,
    }
}

pub(super) fn view(sheet: &mut Sheet, state: &WorldState, frame: &Rectangle, unit: f64) {
    sheet.reach(REACH_MM, [2.6, -1.2], unit);
    base(sheet);
    grid(sheet, frame);
    paper(sheet, state);
    marks(sheet, state);
    let mut objects: Vec<&Object> = state.objects.iter().collect();
    objects.sort_by(|a, b| a.top_mm().total_cmp(&b.top_mm()));
    for object in &objects {
        solid(sheet, object, state.held.contains(&object.name));
    }
    if let Some(arm) = &state.arm {
        // Drawn straight ahead and turned: ahead is up, and left is counter-clockwise.
        let turned = format!("rotate({:.3})", -arm.base_deg);
        sheet.within(&turned, |sheet| links(sheet, state, arm));
        let (x, y, turn) = (-arm.y_mm, -arm.x_mm, -arm.rotation_deg);
        let turned = format!("translate({x:.2} {y:.2}) rotate({turn:.2})");
        sheet.within(&turned, |sheet| tool(sheet, state, arm));
    }
    for object in &objects {
        name(sheet, object, state, unit);
    }
    let low = frame.bottom() - 4.5 * unit;
    sheet.scale_bar([frame.right() - 5.0 * unit, low], 50.0, unit);
    axes(sheet, [frame.left + 15.0 * unit, low], unit);
}

fn base(sheet: &mut Sheet) {
    for (radius, color) in [(62.0, "#eef2f3"), (38.0, "#dfe6ea")] {
        let style = ShapeStyle::area(color).edged(STEEL, 0.5);
        sheet.circle([0.0, 0.0], radius, &style);
    }
}

/// A cross each 50 mm.
fn grid(sheet: &mut Sheet, frame: &Rectangle) {
    let steps = |from: f64, to: f64| {
        let first = (from / 50.0).ceil() * 50.0;
        std::iter::successors(Some(first), |it| Some(it + 50.0)).take_while(move |it| *it < to)
    };
    let places = steps(frame.top, frame.bottom())
        .flat_map(|y| steps(frame.left, frame.right()).map(move |x| [x, y]));
    let cross = |[x, y]: [f64; 2]| [[[x - 1.5, y], [x + 1.5, y]], [[x, y - 1.5], [x, y + 1.5]]];
    sheet.curves(places.flat_map(cross), &ShapeStyle::line("#b9c6cd", 0.3));
}

fn paper(sheet: &mut Sheet, state: &WorldState) {
    let Some(paper) = state.paper else {
        return;
    };
    let page = Rectangle::between(
        [-paper.to_mm.y, -paper.to_mm.x],
        [-paper.from_mm.y, -paper.from_mm.x],
    );
    let shadow = Rectangle {
        left: page.left + 1.5,
        top: page.top + 2.0,
        ..page
    };
    sheet.rect(&shadow, 0.6, &ShapeStyle::area(INK).faded(0.13));
    sheet.rect(
        &page,
        0.6,
        &ShapeStyle::area("#ffffff").edged("#d5d0c4", 0.3),
    );
}

/// An object with its shadow; the higher it is, the farther the shadow.
fn solid(sheet: &mut Sheet, object: &Object, held: bool) {
    let outline = outline(object);
    let away = 1.2 + object.bottom_mm.clamp(0.0, 200.0) * 0.06;
    let shadow = format!("translate({away:.2} {:.2})", away * 1.3);
    sheet.within(&shadow, |it| {
        it.path(&outline, &ShapeStyle::area(INK).faded(0.16));
    });
    let edge = edge(object);
    sheet.path(&outline, &ShapeStyle::area(fill(object)).edged(&edge, 0.7));
    if held {
        sheet.path(&outline, &ShapeStyle::line(PAPER, 2.4));
        sheet.path(&outline, &ShapeStyle::line(WARM, 1.2).dashed("3 2.2"));
    }
}

fn outline(object: &Object) -> String {
    match object.footprint() {
        Footprint::Disc {
            middle,
            radius_mm: r,
        } => {
            let (x, y) = (-middle.y, -middle.x);
            format!(
                "M{:.2} {y:.2}a{r} {r} 0 1 0 {:.2} 0a{r} {r} 0 1 0 {:.2} 0Z",
                x - r,
                2.0 * r,
                -2.0 * r
            )
        }
        Footprint::Rectangle {
            middle,
            half_mm: [along, across],
            turn_deg,
        } => rectangle(middle, [along, across], turn_deg),
    }
}

fn rectangle(middle: Point, [along, across]: [f64; 2], turn_deg: f64) -> String {
    let corners = [(1.0, 1.0), (1.0, -1.0), (-1.0, -1.0), (-1.0, 1.0)];
    let mut path = String::new();
    for (i, (x, y)) in corners.into_iter().enumerate() {
        let corner = middle + Vec2::new(x * along, y * across).rotate_scale(direction(turn_deg));
        let to = if i == 0 { 'M' } else { 'L' };
        let _ = write!(path, "{to}{:.2} {:.2}", -corner.y, -corner.x);
    }
    path + "Z"
}

/// The name: on the object where there is room and nothing stands there, otherwise below it.
fn name(sheet: &mut Sheet, object: &Object, state: &WorldState, unit: f64) {
    let high = 1.5 * unit;
    let held = state.held.contains(&object.name);
    let text = if held {
        format!("{} (held)", object.name)
    } else {
        object.name.clone()
    };
    let [right, left] = object.footprint().extent(Vec2::new(0.0, 1.0));
    let covered = state.objects.iter().any(|it| it.stands_on(object));
    let middle = Point::new(-object.at_mm.y, -object.at_mm.x);
    let kind = TextStyle::new(high, contrast(object));
    if !covered && !held && kind.width(&text) + 2.0 * unit < left - right {
        let at = [middle.x, middle.y + high / 2.0];
        return sheet.text(at, Anchor::Middle, &kind, &text);
    }
    let [back, _] = object.footprint().extent(Vec2::new(1.0, 0.0));
    let below = [middle.x, -back + high + 1.1 * unit];
    let kind = TextStyle::new(high, if held { WARM } else { INK });
    for kind in [kind.halo(PAPER), kind] {
        sheet.text(below, Anchor::Middle, &kind, &text);
    }
}

/// Rear arm, forearm and tool holder, so faint that what lies below shows.
fn links(sheet: &mut Sheet, state: &WorldState, arm: &ArmState) {
    let elbow = REAR_ARM.0 * arm.rear_deg.to_radians().sin();
    let wrist = elbow + FOREARM.0 * arm.fore_deg.to_radians().cos();
    let tool = wrist + state.tool.tool().reach().0;
    for (from, to, wide) in [
        (wrist, tool, 12.0),
        (elbow, wrist, 20.0),
        (0.0, elbow, 28.0),
    ] {
        let (steel, pale) = (
            ShapeStyle::line(STEEL, wide),
            ShapeStyle::line("#eef2f4", wide - 1.6),
        );
        sheet.line([0.0, -from], [0.0, -to], &steel.faded(0.55));
        sheet.line([0.0, -from], [0.0, -to], &pale.faded(0.62));
    }
    for (at, radius) in [(0.0, 9.0), (elbow, 6.5), (wrist, 5.0)] {
        sheet.circle([0.0, -at], radius, &ShapeStyle::area(PAPER).faded(0.8));
        sheet.circle([0.0, -at], radius, &ShapeStyle::line(STEEL, 0.8));
    }
}

/// The tool, as seen from above.
fn tool(sheet: &mut Sheet, state: &WorldState, arm: &ArmState) {
    let (middle, cross) = ([0.0, 0.0], "M-2.5 0H2.5M0 -2.5V2.5");
    match state.tool.action {
        ToolAction::Pen { .. } => {
            sheet.circle(middle, 5.0, &ShapeStyle::area(PAPER).faded(0.5));
            sheet.circle(middle, 5.0, &ShapeStyle::line(INK, 0.8));
            sheet.circle(middle, 0.9, &ShapeStyle::area(INK));
        }
        ToolAction::Laser { .. } => {
            laser(sheet, arm.laser);
        }
        ToolAction::SuctionCup { diameter_mm, .. } => {
            let edge = ShapeStyle::line(if arm.pump { WARM } else { INK }, 0.8);
            let radius = diameter_mm / 2.0;
            sheet.circle(middle, radius, &ShapeStyle::area(PAPER).faded(0.45));
            sheet.circle(middle, radius, &edge);
            sheet.path(cross, &edge);
        }
        ToolAction::Gripper { .. } => {
            fingers(sheet, arm.opening_mm / 2.0);
            sheet.path(cross, &ShapeStyle::line(INK, 0.8));
        }
    }
}

/// The fingers of the gripper, each at this distance from the middle.
fn fingers(sheet: &mut Sheet, half_mm: f64) {
    for left in [-half_mm - 4.0, half_mm] {
        let finger = Rectangle::between([left, -5.0], [left + 4.0, 5.0]);
        sheet.rect(&finger, 0.0, &ShapeStyle::area(ROD).edged(INK, 0.8));
    }
}

fn laser(sheet: &mut Sheet, is_on: bool) {
    let middle = [0.0, 0.0];
    let housing = Rectangle::between([-9.0, -9.0], [9.0, 9.0]);
    sheet.rect(&housing, 0.0, &ShapeStyle::area(PAPER).faded(0.3));
    sheet.rect(&housing, 0.0, &ShapeStyle::line(INK, 0.8));
    if is_on {
        sheet.circle(middle, 9.0, &ShapeStyle::area("#e0402e").faded(0.18));
        sheet.circle(middle, 1.6, &ShapeStyle::area("#e0402e"));
    }
}

/// Which way X and Y point.
fn axes(sheet: &mut Sheet, [x, y]: [f64; 2], unit: f64) {
    let (left, top) = (x - 9.0 * unit, y - 9.0 * unit);
    let (a, b) = (0.7 * unit, 1.4 * unit);
    let lines = [
        [[left, y], [x, y], [x, top]],
        [[x - a, top + b], [x, top], [x + a, top + b]],
        [[left + b, y - a], [left, y], [left + b, y + a]],
    ];
    sheet.curves(lines, &ShapeStyle::line(MUTED, 0.16 * unit));
    let kind = TextStyle::new(1.6 * unit, MUTED);
    sheet.text([x + 2.4 * unit, top + b], Anchor::Middle, &kind, "x");
    sheet.text([left, y - 1.6 * unit], Anchor::Middle, &kind, "y");
}
