//! The world from above.

use std::fmt::Write as _;

use dobot_arm::{FOREARM, REAR_ARM};
use dobot_geometry::{Point, Vec2, direction};
use dobot_lettering::{Anchor, lettering, width};

use super::marks::marks;
use super::{
    Frame, INK, MUTED, REACH_MM, SHEET, STEEL, WARM, contrast, edge, fill, label, scale_bar,
};
use crate::world::footprint::Footprint;
use crate::world::{ArmState, Object, ToolKind, WorldState};

/// What is shown: the arm and what it reaches before it, and whatever else there is.
pub(super) fn bounds(state: &WorldState) -> Frame {
    let far = REACH_MM[1] + 14.0;
    let (mut min, mut max) = (Point::new(-95.0, -far), Point::new(far, far));
    let mut show = |x: [f64; 2], y: [f64; 2]| {
        min = Point::new(min.x.min(x[0]), min.y.min(y[0]));
        max = Point::new(max.x.max(x[1]), max.y.max(y[1]));
    };
    for object in &state.objects {
        let [x, y] = [0.0, 90.0].map(|it| object.footprint().extent(direction(it)));
        show([x[0] - 10.0, x[1] + 10.0], [y[0] - 10.0, y[1] + 10.0]);
    }
    if let Some(paper) = state.paper {
        show(
            [paper.from_mm.x - 10.0, paper.to_mm.x + 10.0],
            [paper.from_mm.y - 10.0, paper.to_mm.y + 10.0],
        );
    }
    if let Some(arm) = state.arm {
        show(
            [arm.x_mm - 30.0, arm.x_mm + 30.0],
            [arm.y_mm - 30.0, arm.y_mm + 30.0],
        );
    }
    Frame {
        left: -max.y,
        top: -max.x,
        width: max.y - min.y,
        height: max.x - min.x,
    }
}

pub(super) fn view(state: &WorldState, frame: &Frame, unit: f64) -> String {
    let mut svg = ring(unit);
    svg += &grid(frame);
    svg += &paper(state);
    svg += &marks(state);
    let mut objects: Vec<&Object> = state.objects.iter().collect();
    objects.sort_by(|a, b| a.top_mm().total_cmp(&b.top_mm()));
    for object in &objects {
        svg += &solid(object, state.held.contains(&object.name));
    }
    if let Some(arm) = &state.arm {
        svg += &links(state, arm);
        svg += &tool(state, arm);
    }
    for object in &objects {
        svg += &name(object, state, unit);
    }
    let corner = Point::new(
        frame.left + frame.width - 5.0 * unit,
        frame.top + frame.height - 4.5 * unit,
    );
    svg + &scale_bar(corner, 1.0, unit) + &axes(frame, unit)
}

/// What the arm reaches, and its base.
fn ring(unit: f64) -> String {
    let [near, far] = REACH_MM;
    let ring = format!(
        "M{far} 0A{far} {far} 0 1 0 -{far} 0A{far} {far} 0 1 0 {far} 0M{near} 0A{near} {near} 0 1 0 -{near} 0A{near} {near} 0 1 0 {near} 0"
    );
    let reach = |reach: f64, below: f64| {
        let text = format!("reach {reach:.0} mm");
        lettering(&text, Anchor::Middle, 0.0, below * unit - reach, 1.3 * unit)
    };
    let words = reach(near, 2.6) + &reach(far, -1.2);
    format!(
        r##"<path d="{ring}" fill="#e9f0f3" fill-rule="evenodd" stroke="#9fb3c2" stroke-width=".5"/>
<g stroke="{STEEL}" stroke-width=".7"><circle r="62" fill="#eef2f3" stroke-width=".4"/><circle r="38" fill="#dfe6ea"/></g><g stroke="{MUTED}" stroke-width=".75">{words}</g>
"##
    )
}

/// A cross each 50 mm.
fn grid(frame: &Frame) -> String {
    let mut path = String::new();
    let steps = |from: f64, long: f64| {
        let first = (from / 50.0).ceil() * 50.0;
        std::iter::successors(Some(first), |it| Some(it + 50.0))
            .take_while(move |it| *it < from + long)
    };
    for y in steps(frame.top, frame.height) {
        for x in steps(frame.left, frame.width) {
            let _ = write!(path, "M{} {y}h3M{x} {}v3", x - 1.5, y - 1.5);
        }
    }
    format!("<path d=\"{path}\" stroke=\"#b9c6cd\" stroke-width=\".3\"/>\n")
}

fn paper(state: &WorldState) -> String {
    let Some(paper) = state.paper else {
        return String::new();
    };
    let sheet = Frame {
        left: -paper.to_mm.y,
        top: -paper.to_mm.x,
        width: paper.to_mm.y - paper.from_mm.y,
        height: paper.to_mm.x - paper.from_mm.x,
    };
    let shadow = Frame {
        left: sheet.left + 1.5,
        top: sheet.top + 2.0,
        ..sheet
    };
    shadow.rect(0.6, r##"fill="#1b2a41" fill-opacity=".13""##)
        + &sheet.rect(
            0.6,
            r##"fill="#ffffff" stroke="#d5d0c4" stroke-width=".3""##,
        )
}

/// An object with its shadow; the higher it is, the farther the shadow.
fn solid(object: &Object, held: bool) -> String {
    let outline = outline(object);
    let away = 1.2 + object.bottom_mm.clamp(0.0, 200.0) * 0.06;
    let mut svg = format!(
        r##"<path d="{outline}" transform="translate({away:.2} {:.2})" fill="#1b2a41" fill-opacity=".16"/>
<path d="{outline}" fill="{}" stroke="{}" stroke-width=".7"/>
"##,
        away * 1.3,
        fill(object),
        edge(object),
    );
    if held {
        let _ = writeln!(
            svg,
            r#"<path d="{outline}" stroke="{SHEET}" stroke-width="2.4"/><path d="{outline}" stroke="{WARM}" stroke-width="1.2" stroke-dasharray="3 2.2"/>"#
        );
    }
    svg
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
        } => {
            let corners = [(1.0, 1.0), (1.0, -1.0), (-1.0, -1.0), (-1.0, 1.0)];
            let mut path = String::new();
            for (i, (x, y)) in corners.into_iter().enumerate() {
                let corner =
                    middle + Vec2::new(x * along, y * across).rotate_scale(direction(turn_deg));
                let to = if i == 0 { 'M' } else { 'L' };
                let _ = write!(path, "{to}{:.2} {:.2}", -corner.y, -corner.x);
            }
            path + "Z"
        }
    }
}

/// The name: on the object where there is room and nothing stands there, otherwise below it.
fn name(object: &Object, state: &WorldState, unit: f64) -> String {
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
    if !covered && !held && width(&text, high) + 2.0 * unit < left - right {
        let words = lettering(&text, Anchor::Middle, middle.x, middle.y + high / 2.0, high);
        let color = contrast(object);
        return format!("<g stroke=\"{color}\" stroke-width=\".9\">{words}</g>\n");
    }
    let [back, _] = object.footprint().extent(Vec2::new(1.0, 0.0));
    let below = Point::new(middle.x, -back + high + 1.1 * unit);
    let color = if held { WARM } else { INK };
    label(&text, Anchor::Middle, below, high, color)
}

/// Rear arm, forearm and tool holder, so faint that what lies below shows.
fn links(state: &WorldState, arm: &ArmState) -> String {
    let elbow = REAR_ARM.0 * arm.rear_deg.to_radians().sin();
    let wrist = elbow + FOREARM.0 * arm.fore_deg.to_radians().cos();
    let tool = wrist + state.tool.mounting().reach().0;
    // Drawn straight ahead and turned: on the picture ahead is up, and left is counter-clockwise.
    let turn = -arm.base_deg;
    let link = |from: f64, to: f64, wide: f64| {
        format!(
            r##"<path d="M0 {:.2}V{:.2}" stroke="{STEEL}" stroke-width="{wide}" stroke-opacity=".55"/><path d="M0 {:.2}V{:.2}" stroke="#eef2f4" stroke-width="{:.1}" stroke-opacity=".62"/>"##,
            -from,
            -to,
            -from,
            -to,
            wide - 1.6
        )
    };
    let joint = |at: f64, r: f64| {
        format!(
            r#"<circle cy="{:.2}" r="{r}" fill="{SHEET}" fill-opacity=".8" stroke="{STEEL}" stroke-width=".8"/>"#,
            -at
        )
    };
    format!(
        "<g transform=\"rotate({turn:.3})\">{}{}{}{}{}{}</g>\n",
        link(wrist, tool, 12.0),
        link(elbow, wrist, 20.0),
        link(0.0, elbow, 28.0),
        joint(0.0, 9.0),
        joint(elbow, 6.5),
        joint(wrist, 5.0)
    )
}

/// The tool, as seen from above.
fn tool(state: &WorldState, arm: &ArmState) -> String {
    let (x, y) = (-arm.y_mm, -arm.x_mm);
    let shape = match state.tool.kind {
        ToolKind::Pen { .. } => {
            format!(
                r#"<circle r="5" fill="{SHEET}" fill-opacity=".5"/><circle r=".9" fill="{INK}" stroke="none"/>"#
            )
        }
        ToolKind::Laser { .. } => {
            let beam = if arm.laser {
                r##"<circle r="9" fill="#e0402e" fill-opacity=".18" stroke="none"/><circle r="1.6" fill="#e0402e" stroke="none"/>"##
            } else {
                ""
            };
            format!(r#"<path d="M-9 -9H9V9H-9Z" fill="{SHEET}" fill-opacity=".3"/>{beam}"#)
        }
        ToolKind::SuctionCup { diameter_mm, .. } => {
            let color = if arm.pump { WARM } else { INK };
            format!(
                r#"<circle r="{:.2}" fill="{SHEET}" fill-opacity=".45" stroke="{color}"/><path d="M-2.5 0H2.5M0 -2.5V2.5" stroke="{color}"/>"#,
                diameter_mm / 2.0
            )
        }
        ToolKind::Gripper { .. } => {
            let half = arm.opening_mm / 2.0;
            format!(
                r##"<path d="M{:.2} -5h-4v10h4ZM{half:.2} -5h4v10h-4Z" fill="#4a5a68"/><path d="M-2.5 0H2.5M0 -2.5V2.5"/>"##,
                -half
            )
        }
    };
    format!(
        "<g transform=\"translate({x:.2} {y:.2}) rotate({:.2})\" stroke=\"{INK}\" stroke-width=\".8\">{shape}</g>\n",
        -arm.rotation_deg
    )
}

/// Which way X and Y point.
fn axes(frame: &Frame, unit: f64) -> String {
    let (x, y) = (
        frame.left + 15.0 * unit,
        frame.top + frame.height - 4.5 * unit,
    );
    let long = 9.0 * unit;
    let words = lettering(
        "x",
        Anchor::Middle,
        x + 2.4 * unit,
        y - long + 1.4 * unit,
        1.6 * unit,
    ) + &lettering("y", Anchor::Middle, x - long, y - 1.6 * unit, 1.6 * unit);
    format!(
        r#"<g stroke="{MUTED}" stroke-width="{:.2}"><path d="M{:.2} {y:.2}H{x:.2}V{:.2}m{a:.2} {b:.2}l-{a:.2} -{b:.2}l-{a:.2} {b:.2}M{:.2} {:.2}l-{b:.2} {a:.2}l{b:.2} {a:.2}"/><g stroke-width=".75">{words}</g></g>
"#,
        0.14 * unit,
        x - long,
        y - long,
        x - long + 1.4 * unit,
        y - 0.7 * unit,
        a = 0.7 * unit,
        b = 1.4 * unit,
    )
}
