//! The world from the side, across the way the arm points.

use dobot_arm::{FOREARM, REAR_ARM};
use dobot_geometry::{Point, Vec2, direction};
use dobot_lettering::{Anchor, Rectangle, ShapeStyle, Sheet, TextStyle};

use super::{INK, MUTED, PAPER, REACH_MM, ROD, STEEL, WARM, edge, fill};
use crate::world::{ArmState, Object, ToolAction, WorldState};

/// Below the view from above, half as wide as that.
pub(super) fn bounds(state: &WorldState, top: &Rectangle, unit: f64) -> Rectangle {
    let width = (top.width - 4.0 * unit) * 0.54;
    let scale = width / SHOWN_MM;
    Rectangle {
        left: top.left,
        top: top.top + top.height + 4.0 * unit,
        width,
        height: (HIGHEST_MM - state.table_z_mm) * scale + 4.0 * unit,
    }
}

pub(super) fn view(sheet: &mut Sheet, state: &WorldState, frame: &Rectangle, unit: f64) {
    let scale = frame.width / SHOWN_MM;
    let words = "from the side, along the arm";
    let at = [frame.left + 3.0 * unit, frame.top + 4.4 * unit];
    sheet.text(at, Anchor::Left, &TextStyle::new(1.4 * unit, MUTED), words);
    let corner = [frame.right() - 4.0 * unit, frame.top + 6.5 * unit];
    sheet.scale_bar(corner, 50.0 * scale, unit);
    // From here on in mm of the base frame, with z up as seen by the reader.
    let (x, y) = (
        frame.left + BEHIND_MM * scale,
        frame.bottom() - 4.0 * unit + state.table_z_mm * scale,
    );
    let in_mm = format!("translate({x:.2} {y:.2}) scale({scale:.4})");
    sheet.within(&in_mm, |sheet| {
        table(sheet, -state.table_z_mm);
        objects(sheet, state, state.arm.map_or(0.0, |it| it.base_deg));
        base(sheet, -state.table_z_mm);
        if let Some(arm) = &state.arm {
            tool(sheet, state, arm);
            links(sheet, state, arm);
        }
    });
}

fn table(sheet: &mut Sheet, y: f64) {
    let board = Rectangle::between([-200.0, y], [600.0, y + 100.0]);
    sheet.rect(&board, 0.0, &ShapeStyle::area("#e9e4d6"));
    let [near, far] = REACH_MM;
    sheet.line([near, y], [far, y], &ShapeStyle::line("#b7cad4", 3.0));
    sheet.line([-200.0, y], [600.0, y], &ShapeStyle::line("#a79f8b", 0.8));
}

/// The farther an object is beside the plane of the arm, the fainter.
fn objects(sheet: &mut Sheet, state: &WorldState, base_deg: f64) {
    let across = direction(base_deg + 90.0);
    let beside = |it: &Object| it.at_mm.to_vec2().dot(across).abs();
    let mut objects: Vec<&Object> = state.objects.iter().collect();
    objects.sort_by(|a, b| beside(b).total_cmp(&beside(a)));
    for object in objects {
        let [from, to] = object.footprint().extent(direction(base_deg));
        let (opacity, edge) = if state.held.contains(&object.name) {
            (1.0, WARM.to_owned())
        } else {
            let opacity = (1.0 - beside(object) / 160.0).clamp(0.18, 1.0);
            (opacity, edge(object))
        };
        let top = -(state.table_z_mm + object.top_mm());
        let seen = Rectangle::between([from, top], [to, top + object.height_mm()]);
        let look = ShapeStyle::area(fill(object)).edged(&edge, 0.9);
        sheet.rect(&seen, 0.0, &look.faded(opacity));
    }
}

fn base(sheet: &mut Sheet, floor: f64) {
    let (deck, shoulder) = (floor - 30.0, (floor - 58.0).min(12.0));
    let foot = Rectangle::between([-62.0, deck], [62.0, floor]);
    sheet.rect(&foot, 0.0, &ShapeStyle::area("#dfe6ea").edged(STEEL, 0.9));
    let body =
        format!("M-38 {deck:.1}V{shoulder:.1}Q-38 -24 0 -24Q38 -24 38 {shoulder:.1}V{deck:.1}Z");
    sheet.path(&body, &ShapeStyle::area("#eef2f3").edged(STEEL, 0.9));
}

fn links(sheet: &mut Sheet, state: &WorldState, arm: &ArmState) {
    let (rear, fore) = (arm.rear_deg.to_radians(), arm.fore_deg.to_radians());
    let elbow = Point::new(REAR_ARM.0 * rear.sin(), -REAR_ARM.0 * rear.cos());
    let wrist = elbow + Vec2::new(FOREARM.0 * fore.cos(), FOREARM.0 * fore.sin());
    let tool = wrist + Vec2::new(state.tool.tool().reach().0, 0.0);
    let [shoulder, elbow, wrist, tool] =
        [Point::default(), elbow, wrist, tool].map(|it| [it.x, it.y]);
    for (from, to, wide) in [
        (wrist, tool, 9.0),
        (elbow, wrist, 14.0),
        (shoulder, elbow, 18.0),
    ] {
        sheet.line(from, to, &ShapeStyle::line(STEEL, wide));
        sheet.line(from, to, &ShapeStyle::line("#eef2f4", wide - 1.8));
    }
    for (at, radius) in [(shoulder, 7.0), (elbow, 5.5), (wrist, 4.0)] {
        sheet.circle(at, radius, &ShapeStyle::area(PAPER).edged(STEEL, 1.0));
    }
}

/// The tool hangs from the end of the arm down to its tip.
fn tool(sheet: &mut Sheet, state: &WorldState, arm: &ArmState) {
    let reach = arm.x_mm.hypot(arm.y_mm);
    let (top, tip) = (-arm.z_mm, -(state.table_z_mm + arm.tip_mm));
    let rod = |sheet: &mut Sheet, half: f64, to: f64| {
        let rod = Rectangle::between([reach - half, top], [reach + half, to]);
        sheet.rect(&rod, 0.0, &ShapeStyle::area(ROD));
    };
    match state.tool.action {
        ToolAction::Pen { .. } => {
            let (left, right, shoulder) = (reach - 3.0, reach + 3.0, tip - 8.0);
            rod(sheet, 3.0, shoulder);
            let nib = [[left, shoulder], [right, shoulder], [reach, tip]];
            sheet.area(&nib, &ShapeStyle::area(INK));
        }
        ToolAction::Laser { focus_mm, .. } => {
            rod(sheet, 8.0, tip);
            if arm.laser {
                let beam = ShapeStyle::line("#e0402e", 1.4);
                sheet.line([reach, tip], [reach, tip + focus_mm], &beam);
            }
        }
        ToolAction::SuctionCup { diameter_mm, .. } => {
            let (half, bell) = (diameter_mm / 2.0, tip - 6.0);
            rod(sheet, 2.5, bell);
            cup(sheet, [reach, tip], bell, half, arm.pump);
        }
        ToolAction::Gripper { .. } => {
            let turn = (arm.rotation_deg - arm.base_deg + 90.0).to_radians();
            let half = (arm.opening_mm / 2.0 * turn.cos()).abs();
            let palm = tip - 30.0;
            rod(sheet, 4.0, palm);
            fingers(sheet, [reach, tip], palm, half);
        }
    }
}

/// A suction cup from its bell down to its edge, which is `half` wide to each side.
fn cup(sheet: &mut Sheet, [reach, tip]: [f64; 2], bell: f64, half: f64, holds: bool) {
    let outline = [
        [reach - 2.5, bell],
        [reach + 2.5, bell],
        [reach + half, tip],
        [reach - half, tip],
    ];
    sheet.area(&outline, &ShapeStyle::area(if holds { WARM } else { INK }));
}

/// The fingers of a gripper from its palm down to their tips, `half` to each side.
fn fingers(sheet: &mut Sheet, [reach, tip]: [f64; 2], palm: f64, half: f64) {
    for x in [reach - half, reach + half] {
        sheet.line([x, palm], [x, tip], &ShapeStyle::line(ROD, 4.0));
    }
    let ends = [reach - half - 2.0, reach + half + 2.0].map(|x| [x, palm]);
    sheet.line(ends[0], ends[1], &ShapeStyle::line(ROD, 5.0));
}

/// What of the plane of the arm is shown, behind its axis and in all.
const BEHIND_MM: f64 = 95.0;
const SHOWN_MM: f64 = BEHIND_MM + 335.0;
/// Up to there.
const HIGHEST_MM: f64 = 165.0;
