//! The world from the side, across the way the arm points.

use std::fmt::Write as _;

use dobot_arm::{FOREARM, REAR_ARM};
use dobot_geometry::{Point, Vec2, direction};
use dobot_lettering::{Anchor, lettering};

use super::{Frame, INK, MUTED, REACH_MM, SHEET, STEEL, WARM, edge, fill, scale_bar};
use crate::world::{ArmState, Object, ToolKind, WorldState};

/// Below the view from above, half as wide as that.
pub(super) fn bounds(state: &WorldState, top: &Frame, unit: f64) -> Frame {
    let width = (top.width - 4.0 * unit) * 0.54;
    let scale = width / SHOWN_MM;
    Frame {
        left: top.left,
        top: top.top + top.height + 4.0 * unit,
        width,
        height: (HIGHEST_MM - state.table_z_mm) * scale + 4.0 * unit,
    }
}

pub(super) fn view(state: &WorldState, frame: &Frame, unit: f64) -> String {
    let scale = frame.width / SHOWN_MM;
    let words = lettering(
        "from the side, along the arm",
        Anchor::Left,
        frame.left + 3.0 * unit,
        frame.top + 4.4 * unit,
        1.4 * unit,
    );
    let corner = Point::new(
        frame.left + frame.width - 4.0 * unit,
        frame.top + 6.5 * unit,
    );
    // From here on in mm of the base frame, with z up as seen by the reader.
    let (x, y) = (
        frame.left + BEHIND_MM * scale,
        frame.top + frame.height - 4.0 * unit + state.table_z_mm * scale,
    );
    let mut svg = format!(
        "<g stroke=\"{MUTED}\" stroke-width=\".75\">{words}</g>\n{}<g transform=\"translate({x:.2} {y:.2}) scale({scale:.4})\">\n",
        scale_bar(corner, scale, unit)
    );
    let base_deg = state.arm.map_or(0.0, |it| it.base_deg);
    svg += &table(state.table_z_mm);
    svg += &objects(state, base_deg);
    svg += &base(state.table_z_mm);
    if let Some(arm) = &state.arm {
        svg += &tool(state, arm);
        svg += &links(state, arm);
    }
    svg + "</g>\n"
}

fn table(z_mm: f64) -> String {
    let [near, far] = REACH_MM;
    let y = -z_mm;
    format!(
        r##"<path d="M-200 {y}H600V{}H-200Z" fill="#e9e4d6"/><path d="M{near} {y}H{far}" stroke="#b7cad4" stroke-width="3"/><path d="M-200 {y}H600" stroke="#a79f8b" stroke-width=".8"/>
"##,
        y + 100.0
    )
}

/// The farther an object is beside the plane of the arm, the fainter.
fn objects(state: &WorldState, base_deg: f64) -> String {
    let across = direction(base_deg + 90.0);
    let beside = |it: &Object| it.at_mm.to_vec2().dot(across).abs();
    let mut objects: Vec<&Object> = state.objects.iter().collect();
    objects.sort_by(|a, b| beside(b).total_cmp(&beside(a)));
    let mut svg = String::new();
    for object in objects {
        let [from, to] = object.footprint().extent(direction(base_deg));
        let held = state.held.contains(&object.name);
        let opacity = if held {
            1.0
        } else {
            (1.0 - beside(object) / 160.0).clamp(0.18, 1.0)
        };
        let edge = if held { WARM.to_owned() } else { edge(object) };
        let _ = writeln!(
            svg,
            r#"<rect x="{from:.2}" y="{:.2}" width="{:.2}" height="{:.2}" fill="{}" stroke="{edge}" stroke-width=".9" opacity="{opacity:.2}"/>"#,
            -(state.table_z_mm + object.top_mm()),
            to - from,
            object.height_mm(),
            fill(object),
        );
    }
    svg
}

fn base(table_z_mm: f64) -> String {
    let floor = -table_z_mm;
    let shoulder = (floor - 58.0).min(12.0);
    format!(
        r##"<g stroke="{STEEL}" stroke-width=".9"><path d="M-62 {floor}V{:.1}H62V{floor}Z" fill="#dfe6ea"/><path d="M-38 {:.1}V{shoulder:.1}Q-38 -24 0 -24Q38 -24 38 {shoulder:.1}V{:.1}Z" fill="#eef2f3"/></g>
"##,
        floor - 30.0,
        floor - 30.0,
        floor - 30.0
    )
}

fn links(state: &WorldState, arm: &ArmState) -> String {
    let (rear, fore) = (arm.rear_deg.to_radians(), arm.fore_deg.to_radians());
    let elbow = Point::new(REAR_ARM.0 * rear.sin(), -REAR_ARM.0 * rear.cos());
    let wrist = elbow + Vec2::new(FOREARM.0 * fore.cos(), FOREARM.0 * fore.sin());
    let tool = wrist + Vec2::new(state.tool.mounting().reach().0, 0.0);
    let link = |from: Point, to: Point, wide: f64| {
        let path = format!("M{:.2} {:.2}L{:.2} {:.2}", from.x, from.y, to.x, to.y);
        format!(
            r##"<path d="{path}" stroke="{STEEL}" stroke-width="{wide}"/><path d="{path}" stroke="#eef2f4" stroke-width="{:.1}"/>"##,
            wide - 1.8
        )
    };
    let joint = |at: Point, r: f64| {
        format!(
            r#"<circle cx="{:.2}" cy="{:.2}" r="{r}" fill="{SHEET}" stroke="{STEEL}" stroke-width="1"/>"#,
            at.x, at.y
        )
    };
    [
        link(wrist, tool, 9.0),
        link(elbow, wrist, 14.0),
        link(Point::default(), elbow, 18.0),
        joint(Point::default(), 7.0),
        joint(elbow, 5.5),
        joint(wrist, 4.0),
    ]
    .concat()
        + "\n"
}

/// The tool hangs from the end of the arm down to its tip.
fn tool(state: &WorldState, arm: &ArmState) -> String {
    let reach = arm.x_mm.hypot(arm.y_mm);
    let (top, tip) = (-arm.z_mm, -(state.table_z_mm + arm.tip_mm));
    let rod = |wide: f64, to: f64| {
        format!(
            r##"<path d="M{reach:.2} {top:.2}V{to:.2}" stroke="#4a5a68" stroke-width="{wide}" stroke-linecap="butt"/>"##
        )
    };
    match state.tool.kind {
        ToolKind::Pen { .. } => {
            let shoulder = tip - 8.0;
            rod(6.0, shoulder)
                + &format!(
                    r#"<path d="M{:.2} {shoulder:.2}h6L{reach:.2} {tip:.2}Z" fill="{INK}"/>"#,
                    reach - 3.0
                )
        }
        ToolKind::Laser { focus_mm, .. } => {
            let beam = if arm.laser {
                format!(
                    r##"<path d="M{reach:.2} {tip:.2}v{focus_mm:.2}" stroke="#e0402e" stroke-width="1.4"/>"##
                )
            } else {
                String::new()
            };
            rod(16.0, tip) + &beam
        }
        ToolKind::SuctionCup { diameter_mm, .. } => {
            let bell = tip - 6.0;
            rod(5.0, bell)
                + &format!(
                    r#"<path d="M{:.2} {bell:.2}h5L{:.2} {tip:.2}H{:.2}Z" fill="{}"/>"#,
                    reach - 2.5,
                    reach + diameter_mm / 2.0,
                    reach - diameter_mm / 2.0,
                    if arm.pump { WARM } else { INK }
                )
        }
        ToolKind::Gripper { .. } => {
            let turn = (arm.rotation_deg - arm.base_deg + 90.0).to_radians();
            let half = arm.opening_mm / 2.0 * turn.cos();
            let palm = tip - 30.0;
            rod(8.0, palm)
                + &format!(
                    r##"<path d="M{:.2} {palm:.2}V{tip:.2}M{:.2} {palm:.2}V{tip:.2}" stroke="#4a5a68" stroke-width="4"/><path d="M{:.2} {palm:.2}H{:.2}" stroke="#4a5a68" stroke-width="5"/>"##,
                    reach - half,
                    reach + half,
                    reach - half.abs() - 2.0,
                    reach + half.abs() + 2.0
                )
        }
    }
}

/// What of the plane of the arm is shown, behind its axis and in all.
const BEHIND_MM: f64 = 95.0;
const SHOWN_MM: f64 = BEHIND_MM + 335.0;
/// Up to there.
const HIGHEST_MM: f64 = 165.0;
